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

struct type_21 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_23 {
    member: array<type_21>,
}

struct type_25 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_26 {
    member: type_25,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_28 {
    member: array<type_26>,
}

struct type_33 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_35 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_39 {
    member: type_21,
    member_1: f32,
}

struct type_42 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_44 {
    member: array<vec4<u32>, 2>,
}

struct type_47 {
    member: array<i32>,
}

struct type_53 {
    member: array<array<u32, 7>>,
}

struct type_58 {
    member: type_33,
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
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_44;
@group(0) @binding(2) 
var<uniform> global_3: type_44;
@group(0) @binding(5) 
var<storage> global_4: type_4;
@group(0) @binding(6) 
var<storage> global_5: type_47;
@group(0) @binding(7) 
var<storage> global_6: type_28;
@group(0) @binding(8) 
var<storage, read_write> global_7: type_23;
@group(0) @binding(9) 
var<storage, read_write> global_8: type_64;
@group(0) @binding(3) 
var<storage> global_9: type_53;
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
    var phi_626_: type_35;
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
    var phi_1421_: type_39;
    var phi_1424_: u32;
    var phi_1426_: bool;
    var phi_1428_: u32;
    var phi_1430_: type_58;
    var phi_1441_: bool;
    var phi_1527_: bool;
    var phi_1528_: u32;
    var phi_1529_: type_58;
    var phi_1548_: type_39;
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
    var phi_3089_: type_42;
    var phi_3090_: type_42;
    var phi_3093_: type_42;
    var phi_3094_: type_42;
    var phi_3095_: bool;
    var phi_3099_: type_42;
    var phi_3108_: type_21;
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
    var phi_3469_: type_39;
    var phi_3470_: type_39;
    var phi_3471_: type_39;
    var phi_1549_: type_39;
    var phi_5371_: bool;
    var phi_5706_: bool;
    var phi_3472_: type_39;
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
    var phi_4750_: type_39;
    var phi_4751_: u32;
    var phi_4752_: bool;
    var phi_4753_: u32;
    var phi_4754_: type_58;
    var phi_5617_: bool;
    var phi_4755_: type_39;
    var phi_4756_: u32;
    var phi_4757_: bool;
    var phi_4758_: u32;
    var phi_4759_: type_58;
    var phi_5616_: bool;
    var phi_1422_: type_39;
    var phi_1425_: u32;
    var phi_1427_: bool;
    var phi_1429_: u32;
    var phi_1431_: type_58;
    var phi_4760_: bool;
    var phi_5615_: bool;
    var local_10: type_39;
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
    var phi_4836_: type_21;
    var local_11: type_39;

    switch bitcast<i32>(0u) {
        default: {
            let _e104 = global;
            let _e106 = arrayLength((&global_9.member));
            let _e109 = arrayLength((&global_10.member));
            let _e121 = arrayLength((&global_8.member));
            let _e125 = global_3.member[0u][0u];
            let _e129 = global_3.member[0u][1u];
            let _e133 = global_3.member[0u][2u];
            let _e137 = global_3.member[0u][3u];
            let _e141 = global_3.member[1u][0u];
            let _e145 = global_3.member[1u][1u];
            let _e149 = global_3.member[1u][2u];
            let _e153 = (_e104.x + (_e104.y * 2097152u));
            let _e165 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e137) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e125), bitcast<i32>(_e129), bitcast<i32>(_e133));
            local = array<i32, 3>(bitcast<i32>(_e141), bitcast<i32>(_e145), bitcast<i32>(_e149));
            let _e168 = (_e153 < arrayLength((&global_6.member)));
            if _e168 {
                if _e168 {
                } else {
                    break;
                }
                let _e172 = global_6.member[_e153].member_2;
                phi_442_ = _e172;
            } else {
                phi_442_ = 4294967295u;
            }
            let _e174 = phi_442_;
            let _e177 = global_1.member[0u];
            let _e181 = global_2.member[0u][0u];
            let _e185 = global_2.member[0u][1u];
            let _e189 = global_2.member[0u][2u];
            let _e193 = global_2.member[0u][3u];
            let _e197 = global_2.member[1u][0u];
            let _e201 = global_2.member[1u][1u];
            let _e205 = global_2.member[1u][2u];
            let _e209 = global_2.member[1u][3u];
            let _e210 = bitcast<f32>(_e181);
            let _e211 = bitcast<f32>(_e185);
            let _e212 = bitcast<f32>(_e189);
            let _e214 = bitcast<f32>(_e197);
            let _e215 = array<u32, 3>(_e201, _e205, _e209);
            let _e217 = bitcast<i32>(_e177);
            if (_e217 < -126i) {
                phi_486_ = -126i;
            } else {
                phi_486_ = select(_e217, 127i, (_e217 > 127i));
            }
            let _e222 = phi_486_;
            let _e227 = bitcast<f32>((bitcast<u32>((_e222 + 127i)) << bitcast<u32>(23i)));
            let _e233 = bitcast<f32>((bitcast<u32>(((_e217 - _e222) + 127i)) << bitcast<u32>(23i)));
            if (_e193 == 0u) {
                phi_626_ = type_35(array<f32, 3>(_e210, _e211, _e212), _e193, _e214, _e215);
            } else {
                let _e235 = bitcast<u32>(_e210);
                let _e237 = ((_e235 & 2139095040u) != 0u);
                let _e252 = bitcast<u32>(_e211);
                let _e254 = ((_e252 & 2139095040u) != 0u);
                let _e269 = bitcast<u32>(_e212);
                let _e271 = ((_e269 & 2139095040u) != 0u);
                let _e287 = bitcast<u32>(_e214);
                let _e289 = ((_e287 & 2139095040u) != 0u);
                phi_626_ = type_35(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e235 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e235 & 2147483648u))), _e210, _e237) * _e227) * select(0.00000011920929f, 1f, _e237)) * _e233), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e252 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e252 & 2147483648u))), _e211, _e254) * _e227) * select(0.00000011920929f, 1f, _e254)) * _e233), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e269 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e269 & 2147483648u))), _e212, _e271) * _e227) * select(0.00000011920929f, 1f, _e271)) * _e233)), _e193, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e287 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e287 & 2147483648u))), _e214, _e289) * _e227) * select(0.00000011920929f, 1f, _e289)) * _e233), _e215);
            }
            let _e306 = phi_626_;
            if _e168 {
                let _e307 = (_e153 < arrayLength((&global_7.member)));
                if _e307 {
                    if _e168 {
                    } else {
                        break;
                    }
                    let _e317 = global_6.member[_e153].member.member_2[0u];
                    let _e319 = (bitcast<u32>(_e317) & 2147483647u);
                    let _e325 = global_6.member[_e153].member.member_2[1u];
                    let _e327 = (bitcast<u32>(_e325) & 2147483647u);
                    let _e333 = global_6.member[_e153].member.member_2[2u];
                    let _e335 = (bitcast<u32>(_e333) & 2147483647u);
                    let _e341 = global_6.member[_e153].member.member[0u];
                    let _e343 = (bitcast<u32>(_e341) & 2147483647u);
                    let _e349 = global_6.member[_e153].member.member[1u];
                    let _e351 = (bitcast<u32>(_e349) & 2147483647u);
                    let _e357 = global_6.member[_e153].member.member[2u];
                    let _e359 = (bitcast<u32>(_e357) & 2147483647u);
                    let _e361 = select(_e327, _e319, (_e327 < _e319));
                    let _e363 = select(_e335, _e361, (_e335 < _e361));
                    let _e365 = select(_e343, _e363, (_e343 < _e363));
                    let _e367 = select(_e351, _e365, (_e351 < _e365));
                    let _e369 = select(_e359, _e367, (_e359 < _e367));
                    let _e374 = global_6.member[_e153].member.member_1;
                    let _e375 = bitcast<u32>(_e374);
                    let _e376 = (_e375 & 2147483647u);
                    let _e384 = global_6.member[_e153].member.member_3;
                    let _e385 = bitcast<u32>(_e384);
                    let _e386 = (_e385 & 2147483647u);
                    let _e390 = (((select(_e376, _e369, (_e376 < _e369)) < 2139095040u) && (_e386 <= 2139095040u)) && (_e363 > 0u));
                    if _e390 {
                        let _e393 = (bitcast<u32>(bitcast<f32>(_e363)) & 2147483647u);
                        if (_e393 >= 8388608u) {
                            phi_732_ = (bitcast<i32>((_e393 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_732_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e393)), 32u, (_e393 == 0u))));
                        }
                        let _e407 = phi_732_;
                        phi_733_ = _e407;
                    } else {
                        phi_733_ = 0i;
                    }
                    let _e409 = phi_733_;
                    let _e410 = (_e319 == _e363);
                    if _e410 {
                        phi_743_ = true;
                    } else {
                        phi_743_ = (_e327 == _e363);
                    }
                    let _e413 = phi_743_;
                    let _e414 = select(1u, 0u, _e410);
                    if _e413 {
                        let _e415 = (_e414 + 1u);
                        phi_753_ = _e415;
                        phi_754_ = _e415;
                        phi_756_ = select(true, false, (_e415 == 2u));
                    } else {
                        phi_753_ = u32();
                        phi_754_ = 0u;
                        phi_756_ = true;
                    }
                    let _e419 = phi_753_;
                    let _e421 = phi_754_;
                    let _e423 = phi_756_;
                    if _e423 {
                        phi_761_ = (_e421 + 1u);
                    } else {
                        phi_761_ = 0u;
                    }
                    let _e427 = phi_761_;
                    let _e428 = select(_e419, _e421, _e423);
                    let _e429 = select(_e414, select(2u, _e414, _e413), _e423);
                    let _e430 = -(_e409);
                    if (_e430 < -126i) {
                        phi_794_ = -126i;
                    } else {
                        phi_794_ = select(_e430, 127i, (_e430 > 127i));
                    }
                    let _e435 = phi_794_;
                    let _e440 = bitcast<f32>((bitcast<u32>((_e435 + 127i)) << bitcast<u32>(23i)));
                    let _e446 = bitcast<f32>((bitcast<u32>(((_e430 - _e435) + 127i)) << bitcast<u32>(23i)));
                    let _e451 = global_6.member[_e153].member.member;
                    let _e452 = (_e428 == 0u);
                    if _e452 {
                        phi_812_ = _e451[0];
                    } else {
                        phi_812_ = _e451[1];
                    }
                    let _e456 = phi_812_;
                    let _e457 = (_e428 == 2u);
                    if _e457 {
                        phi_818_ = _e451[2];
                    } else {
                        phi_818_ = _e456;
                    }
                    let _e460 = phi_818_;
                    let _e461 = bitcast<u32>(_e460);
                    let _e463 = ((_e461 & 2139095040u) != 0u);
                    let _e475 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e461 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e461 & 2147483648u))), _e460, _e463) * select(0.00000011920929f, 1f, _e463));
                    let _e476 = global_6.member[_e153].member.member_2;
                    if _e452 {
                        phi_858_ = _e476[0];
                    } else {
                        phi_858_ = _e476[1];
                    }
                    let _e480 = phi_858_;
                    if _e457 {
                        phi_864_ = _e476[2];
                    } else {
                        phi_864_ = _e480;
                    }
                    let _e483 = phi_864_;
                    let _e484 = bitcast<u32>(_e483);
                    let _e486 = ((_e484 & 2139095040u) != 0u);
                    let _e500 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e484 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e484 & 2147483648u))), _e483, _e486) * _e440) * select(0.00000011920929f, 1f, _e486)) * _e446);
                    let _e504 = (bitcast<f32>((bitcast<u32>(_e500) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e507 = bitcast<f32>((bitcast<u32>(_e475) & 2147483647u));
                    let _e508 = (_e507 * 0.00000011920929f);
                    let _e511 = select(select(0.00000000000011368684f, _e508, (_e508 > 0.00000000000011368684f)), 0f, _e504);
                    let _e512 = select(0f, _e500, _e504);
                    let _e513 = (_e475 + _e511);
                    let _e514 = (_e475 - _e511);
                    let _e516 = select(38685626000000000000000000f, (1f / _e500), _e504);
                    let _e517 = (_e427 == 0u);
                    if _e517 {
                        phi_937_ = _e451[0];
                    } else {
                        phi_937_ = _e451[1];
                    }
                    let _e521 = phi_937_;
                    let _e522 = (_e427 == 2u);
                    if _e522 {
                        phi_943_ = _e451[2];
                    } else {
                        phi_943_ = _e521;
                    }
                    let _e525 = phi_943_;
                    let _e526 = bitcast<u32>(_e525);
                    let _e528 = ((_e526 & 2139095040u) != 0u);
                    let _e540 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e526 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e526 & 2147483648u))), _e525, _e528) * select(0.00000011920929f, 1f, _e528));
                    if _e517 {
                        phi_983_ = _e476[0];
                    } else {
                        phi_983_ = _e476[1];
                    }
                    let _e544 = phi_983_;
                    if _e522 {
                        phi_989_ = _e476[2];
                    } else {
                        phi_989_ = _e544;
                    }
                    let _e547 = phi_989_;
                    let _e548 = bitcast<u32>(_e547);
                    let _e550 = ((_e548 & 2139095040u) != 0u);
                    let _e564 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e548 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e548 & 2147483648u))), _e547, _e550) * _e440) * select(0.00000011920929f, 1f, _e550)) * _e446);
                    let _e568 = (bitcast<f32>((bitcast<u32>(_e564) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e571 = bitcast<f32>((bitcast<u32>(_e540) & 2147483647u));
                    let _e572 = (_e571 * 0.00000011920929f);
                    let _e575 = select(select(0.00000000000011368684f, _e572, (_e572 > 0.00000000000011368684f)), 0f, _e568);
                    let _e576 = select(0f, _e564, _e568);
                    let _e577 = (_e540 + _e575);
                    let _e578 = (_e540 - _e575);
                    let _e580 = select(38685626000000000000000000f, (1f / _e564), _e568);
                    let _e581 = (_e429 == 0u);
                    if _e581 {
                        phi_1062_ = _e451[0];
                    } else {
                        phi_1062_ = _e451[1];
                    }
                    let _e585 = phi_1062_;
                    let _e586 = (_e429 == 2u);
                    if _e586 {
                        phi_1068_ = _e451[2];
                    } else {
                        phi_1068_ = _e585;
                    }
                    let _e589 = phi_1068_;
                    let _e590 = bitcast<u32>(_e589);
                    let _e592 = ((_e590 & 2139095040u) != 0u);
                    let _e604 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e590 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e590 & 2147483648u))), _e589, _e592) * select(0.00000011920929f, 1f, _e592));
                    if _e581 {
                        phi_1108_ = _e476[0];
                    } else {
                        phi_1108_ = _e476[1];
                    }
                    let _e608 = phi_1108_;
                    if _e586 {
                        phi_1114_ = _e476[2];
                    } else {
                        phi_1114_ = _e608;
                    }
                    let _e611 = phi_1114_;
                    let _e612 = bitcast<u32>(_e611);
                    let _e614 = ((_e612 & 2139095040u) != 0u);
                    let _e628 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e612 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e612 & 2147483648u))), _e611, _e614) * _e440) * select(0.00000011920929f, 1f, _e614)) * _e446);
                    let _e632 = (bitcast<f32>((bitcast<u32>(_e628) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e635 = bitcast<f32>((bitcast<u32>(_e604) & 2147483647u));
                    let _e636 = (_e635 * 0.00000011920929f);
                    let _e639 = select(select(0.00000000000011368684f, _e636, (_e636 > 0.00000000000011368684f)), 0f, _e632);
                    let _e640 = select(0f, _e628, _e632);
                    let _e641 = (_e604 + _e639);
                    let _e642 = (_e604 - _e639);
                    let _e644 = select(38685626000000000000000000f, (1f / _e628), _e632);
                    let _e646 = select(_e571, _e507, (_e507 > _e571));
                    if (_e390 && (select(_e635, _e646, (_e646 > _e635)) <= 1099511600000f)) {
                        let _e658 = ((_e376 & 8388607u) | (select(0u, 1u, ((_e376 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e661 = bitcast<i32>((_e376 >> bitcast<u32>(23i)));
                        let _e665 = (_e658 == 0u);
                        let _e668 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e658)), 32u, _e665)) - 8i);
                        if (_e661 == 255i) {
                            phi_1233_ = 255i;
                        } else {
                            phi_1233_ = (((_e661 + select(0i, 1i, (_e661 == 0i))) - _e668) + _e409);
                        }
                        let _e676 = phi_1233_;
                        let _e686 = (_e676 <= 0i);
                        if _e686 {
                            phi_1256_ = u32();
                        } else {
                            if _e665 {
                                phi_1255_ = u32();
                            } else {
                                phi_1255_ = select(((bitcast<u32>(_e676) << bitcast<u32>(23i)) | ((_e658 << bitcast<u32>(((_e668 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e676 >= 255i));
                            }
                            let _e690 = phi_1255_;
                            phi_1256_ = _e690;
                        }
                        let _e692 = phi_1256_;
                        let _e704 = ((_e386 & 8388607u) | (select(0u, 1u, ((_e386 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e707 = bitcast<i32>((_e386 >> bitcast<u32>(23i)));
                        let _e711 = (_e704 == 0u);
                        let _e714 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e704)), 32u, _e711)) - 8i);
                        if (_e707 == 255i) {
                            phi_1293_ = 255i;
                        } else {
                            phi_1293_ = (((_e707 + select(0i, 1i, (_e707 == 0i))) - _e714) + _e409);
                        }
                        let _e722 = phi_1293_;
                        let _e732 = (_e722 <= 0i);
                        if _e732 {
                            phi_1316_ = u32();
                        } else {
                            if _e711 {
                                phi_1315_ = u32();
                            } else {
                                phi_1315_ = select(((bitcast<u32>(_e722) << bitcast<u32>(23i)) | ((_e704 << bitcast<u32>(((_e714 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e722 >= 255i));
                            }
                            let _e736 = phi_1315_;
                            phi_1316_ = _e736;
                        }
                        let _e738 = phi_1316_;
                        phi_1324_ = bitcast<f32>(((_e385 & 2147483648u) | select(_e738, 0u, select(_e711, true, _e732))));
                        phi_1325_ = bitcast<f32>(((_e375 & 2147483648u) | select(_e692, 0u, select(_e665, true, _e686))));
                    } else {
                        phi_1324_ = 0f;
                        phi_1325_ = 1f;
                    }
                    let _e744 = phi_1324_;
                    let _e746 = phi_1325_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e750 = (_e428 % 3u);
                    let _e751 = (_e750 < 3u);
                    if _e751 {
                    } else {
                        break;
                    }
                    let _e753 = local_1[_e750];
                    let _e756 = (_e427 % 3u);
                    let _e757 = (_e756 < 3u);
                    if _e757 {
                    } else {
                        break;
                    }
                    let _e759 = local_1[_e756];
                    let _e762 = (_e429 % 3u);
                    let _e763 = (_e762 < 3u);
                    if _e763 {
                    } else {
                        break;
                    }
                    let _e765 = local_1[_e762];
                    if _e751 {
                    } else {
                        break;
                    }
                    let _e770 = local[_e750];
                    if _e757 {
                    } else {
                        break;
                    }
                    let _e774 = local[_e756];
                    if _e763 {
                    } else {
                        break;
                    }
                    let _e778 = local[_e762];
                    phi_5377_ = false;
                    phi_1421_ = type_39(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e744);
                    phi_1424_ = ((3u * _e106) + 1u);
                    phi_1426_ = (_e746 <= _e744);
                    phi_1428_ = 0u;
                    phi_1430_ = type_58(type_33(vec4<f32>((f32(_e753) * _e165), (f32(_e759) * _e165), (f32(_e765) * _e165), 0f), vec4<f32>((f32(_e770) * _e165), (f32(_e774) * _e165), (f32(_e778) * _e165), 0f)), select(0u, 2147483648u, (_e106 == 0u)));
                    loop {
                        let _e788 = phi_5377_;
                        let _e790 = phi_1421_;
                        let _e792 = phi_1424_;
                        let _e794 = phi_1426_;
                        let _e796 = phi_1428_;
                        let _e798 = phi_1430_;
                        local_10 = _e790;
                        if _e794 {
                            phi_1441_ = true;
                        } else {
                            phi_1441_ = (_e796 > 0u);
                        }
                        let _e801 = phi_1441_;
                        if _e801 {
                            let _e802 = (_e792 > 0u);
                            if _e802 {
                                if _e794 {
                                    phi_1527_ = _e794;
                                    phi_1528_ = _e796;
                                    phi_1529_ = _e798;
                                } else {
                                    let _e803 = (_e796 - 1u);
                                    let _e804 = (_e803 % 128u);
                                    let _e805 = (_e804 < 128u);
                                    if _e805 {
                                    } else {
                                        phi_5615_ = true;
                                        break;
                                    }
                                    let _e807 = local_7[_e804];
                                    if _e805 {
                                    } else {
                                        phi_5615_ = true;
                                        break;
                                    }
                                    let _e809 = local_6[_e804];
                                    if _e805 {
                                    } else {
                                        phi_5615_ = true;
                                        break;
                                    }
                                    let _e811 = local_5[_e804];
                                    if _e805 {
                                    } else {
                                        phi_5615_ = true;
                                        break;
                                    }
                                    let _e813 = local_4[_e804];
                                    if _e805 {
                                    } else {
                                        phi_5615_ = true;
                                        break;
                                    }
                                    let _e815 = local_3[_e804];
                                    if _e805 {
                                    } else {
                                        phi_5615_ = true;
                                        break;
                                    }
                                    let _e817 = local_2[_e804];
                                    if _e805 {
                                    } else {
                                        phi_5615_ = true;
                                        break;
                                    }
                                    let _e822 = local_8[_e804];
                                    if _e805 {
                                    } else {
                                        phi_5615_ = true;
                                        break;
                                    }
                                    let _e825 = local_9[_e804];
                                    phi_1527_ = (_e825 <= _e790.member_1);
                                    phi_1528_ = _e803;
                                    phi_1529_ = type_58(type_33(vec4<f32>(_e807, _e809, _e811, 0f), vec4<f32>(_e813, _e815, _e817, 0f)), _e822);
                                }
                                let _e829 = phi_1527_;
                                let _e831 = phi_1528_;
                                let _e833 = phi_1529_;
                                if _e829 {
                                    let _e837 = ((_e833.member_1 & 2147483648u) != 0u);
                                    let _e838 = (_e833.member_1 & 268435455u);
                                    if _e837 {
                                        phi_1548_ = _e790;
                                        phi_1551_ = type_8(0u, ((_e833.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e845 = phi_1548_;
                                            let _e847 = phi_1551_;
                                            local_11 = _e845;
                                            if (_e847.member < _e847.member_1) {
                                                phi_1552_ = type_8((_e847.member + 1u), _e847.member_1);
                                                phi_1574_ = type_8(1u, _e847.member);
                                            } else {
                                                phi_1552_ = _e847;
                                                phi_1574_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e860 = phi_1552_;
                                            let _e862 = phi_1574_;
                                            let _e866 = (bitcast<i32>(_e862.member) != 0i);
                                            if _e866 {
                                                let _e871 = (_e833.member.member_1.x - _e833.member.member.x);
                                                let _e874 = (_e833.member.member_1.y - _e833.member.member.y);
                                                let _e877 = (_e833.member.member_1.z - _e833.member.member.z);
                                                let _e879 = select(_e874, _e871, (_e871 > _e874));
                                                let _e881 = select(_e877, _e879, (_e879 > _e877));
                                                let _e883 = (_e881 < (1024f * _e165));
                                                if _e883 {
                                                    phi_1615_ = 0u;
                                                } else {
                                                    phi_1615_ = select(2u, 1u, (_e881 < (2097152f * _e165)));
                                                }
                                                let _e888 = phi_1615_;
                                                switch bitcast<i32>(_e888) {
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
                                                let _e891 = phi_1621_;
                                                switch bitcast<i32>(_e888) {
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
                                                let _e898 = phi_1631_;
                                                let _e900 = ((_e838 + (_e862.member_1 * ((3u * _e891) + 1u))) + (3u * _e898));
                                                let _e901 = (_e900 < _e109);
                                                if _e901 {
                                                    if _e901 {
                                                    } else {
                                                        phi_5371_ = true;
                                                        break;
                                                    }
                                                    let _e903 = global_10.member[_e900];
                                                    phi_1647_ = _e903;
                                                } else {
                                                    phi_1647_ = 4294967295u;
                                                }
                                                let _e905 = phi_1647_;
                                                if _e883 {
                                                    phi_1680_ = 0u;
                                                } else {
                                                    phi_1680_ = select(2u, 1u, (_e881 < (2097152f * _e165)));
                                                }
                                                let _e910 = phi_1680_;
                                                switch bitcast<i32>(_e910) {
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
                                                let _e913 = phi_1686_;
                                                let _e917 = (_e838 + (_e862.member_1 * ((3u * _e913) + 1u)));
                                                switch bitcast<i32>(_e910) {
                                                    case 0: {
                                                        let _e1192 = (_e917 < _e109);
                                                        if _e1192 {
                                                            if _e1192 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e1194 = global_10.member[_e917];
                                                            phi_1713_ = _e1194;
                                                        } else {
                                                            phi_1713_ = 0u;
                                                        }
                                                        let _e1196 = phi_1713_;
                                                        let _e1198 = ((10u * _e428) & 31u);
                                                        let _e1208 = ((10u * _e427) & 31u);
                                                        let _e1218 = ((10u * _e429) & 31u);
                                                        let _e1228 = (_e917 + 1u);
                                                        let _e1229 = (_e1228 < _e109);
                                                        if _e1229 {
                                                            if _e1229 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e1231 = global_10.member[_e1228];
                                                            phi_1762_ = _e1231;
                                                        } else {
                                                            phi_1762_ = 0u;
                                                        }
                                                        let _e1233 = phi_1762_;
                                                        let _e1259 = (_e917 + 2u);
                                                        let _e1260 = (_e1259 < _e109);
                                                        if _e1260 {
                                                            if _e1260 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e1262 = global_10.member[_e1259];
                                                            phi_1811_ = _e1262;
                                                        } else {
                                                            phi_1811_ = 0u;
                                                        }
                                                        let _e1264 = phi_1811_;
                                                        phi_2312_ = array<array<f32, 3>, 3>(array<f32, 3>((_e833.member.member.x + ((bitcast<f32>((1258291200u | ((_e1196 >> bitcast<u32>(_e1198)) & 1023u))) - 8388608f) * _e165)), (_e833.member.member.y + ((bitcast<f32>((1258291200u | ((_e1196 >> bitcast<u32>(_e1208)) & 1023u))) - 8388608f) * _e165)), (_e833.member.member.z + ((bitcast<f32>((1258291200u | ((_e1196 >> bitcast<u32>(_e1218)) & 1023u))) - 8388608f) * _e165))), array<f32, 3>((_e833.member.member.x + ((bitcast<f32>((1258291200u | ((_e1233 >> bitcast<u32>(_e1198)) & 1023u))) - 8388608f) * _e165)), (_e833.member.member.y + ((bitcast<f32>((1258291200u | ((_e1233 >> bitcast<u32>(_e1208)) & 1023u))) - 8388608f) * _e165)), (_e833.member.member.z + ((bitcast<f32>((1258291200u | ((_e1233 >> bitcast<u32>(_e1218)) & 1023u))) - 8388608f) * _e165))), array<f32, 3>((_e833.member.member.x + ((bitcast<f32>((1258291200u | ((_e1264 >> bitcast<u32>(_e1198)) & 1023u))) - 8388608f) * _e165)), (_e833.member.member.y + ((bitcast<f32>((1258291200u | ((_e1264 >> bitcast<u32>(_e1208)) & 1023u))) - 8388608f) * _e165)), (_e833.member.member.z + ((bitcast<f32>((1258291200u | ((_e1264 >> bitcast<u32>(_e1218)) & 1023u))) - 8388608f) * _e165))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1006 = (_e917 < _e109);
                                                        if _e1006 {
                                                            if _e1006 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e1008 = global_10.member[_e917];
                                                            phi_1860_ = _e1008;
                                                        } else {
                                                            phi_1860_ = 0u;
                                                        }
                                                        let _e1010 = phi_1860_;
                                                        let _e1011 = (_e917 + 1u);
                                                        let _e1012 = (_e1011 < _e109);
                                                        if _e1012 {
                                                            if _e1012 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e1014 = global_10.member[_e1011];
                                                            phi_1875_ = _e1014;
                                                        } else {
                                                            phi_1875_ = 0u;
                                                        }
                                                        let _e1016 = phi_1875_;
                                                        let _e1017 = (_e428 == 1u);
                                                        if _e1017 {
                                                            phi_1885_ = ((_e1010 >> bitcast<u32>(21i)) | (_e1016 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1885_ = (_e1016 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1026 = phi_1885_;
                                                        let _e1034 = (_e427 == 1u);
                                                        if _e1034 {
                                                            phi_1906_ = ((_e1010 >> bitcast<u32>(21i)) | (_e1016 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1906_ = (_e1016 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1043 = phi_1906_;
                                                        let _e1051 = (_e429 == 1u);
                                                        if _e1051 {
                                                            phi_1927_ = ((_e1010 >> bitcast<u32>(21i)) | (_e1016 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1927_ = (_e1016 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1060 = phi_1927_;
                                                        let _e1069 = (_e917 + 2u);
                                                        let _e1070 = (_e1069 < _e109);
                                                        if _e1070 {
                                                            if _e1070 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e1072 = global_10.member[_e1069];
                                                            phi_1957_ = _e1072;
                                                        } else {
                                                            phi_1957_ = 0u;
                                                        }
                                                        let _e1074 = phi_1957_;
                                                        let _e1075 = (_e917 + 3u);
                                                        let _e1076 = (_e1075 < _e109);
                                                        if _e1076 {
                                                            if _e1076 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e1078 = global_10.member[_e1075];
                                                            phi_1972_ = _e1078;
                                                        } else {
                                                            phi_1972_ = 0u;
                                                        }
                                                        let _e1080 = phi_1972_;
                                                        if _e1017 {
                                                            phi_1982_ = ((_e1074 >> bitcast<u32>(21i)) | (_e1080 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1982_ = (_e1080 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1089 = phi_1982_;
                                                        if _e1034 {
                                                            phi_2003_ = ((_e1074 >> bitcast<u32>(21i)) | (_e1080 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2003_ = (_e1080 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1105 = phi_2003_;
                                                        if _e1051 {
                                                            phi_2024_ = ((_e1074 >> bitcast<u32>(21i)) | (_e1080 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2024_ = (_e1080 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1121 = phi_2024_;
                                                        let _e1130 = (_e917 + 4u);
                                                        let _e1131 = (_e1130 < _e109);
                                                        if _e1131 {
                                                            if _e1131 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e1133 = global_10.member[_e1130];
                                                            phi_2054_ = _e1133;
                                                        } else {
                                                            phi_2054_ = 0u;
                                                        }
                                                        let _e1135 = phi_2054_;
                                                        let _e1136 = (_e917 + 5u);
                                                        let _e1137 = (_e1136 < _e109);
                                                        if _e1137 {
                                                            if _e1137 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e1139 = global_10.member[_e1136];
                                                            phi_2069_ = _e1139;
                                                        } else {
                                                            phi_2069_ = 0u;
                                                        }
                                                        let _e1141 = phi_2069_;
                                                        if _e1017 {
                                                            phi_2079_ = ((_e1135 >> bitcast<u32>(21i)) | (_e1141 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2079_ = (_e1141 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1150 = phi_2079_;
                                                        if _e1034 {
                                                            phi_2100_ = ((_e1135 >> bitcast<u32>(21i)) | (_e1141 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2100_ = (_e1141 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1166 = phi_2100_;
                                                        if _e1051 {
                                                            phi_2121_ = ((_e1135 >> bitcast<u32>(21i)) | (_e1141 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2121_ = (_e1141 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1182 = phi_2121_;
                                                        phi_2312_ = array<array<f32, 3>, 3>(array<f32, 3>((_e833.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1026, _e1010, _e452) & 2097151u))) - 8388608f) * _e165)), (_e833.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1043, _e1010, _e517) & 2097151u))) - 8388608f) * _e165)), (_e833.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1060, _e1010, _e581) & 2097151u))) - 8388608f) * _e165))), array<f32, 3>((_e833.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1089, _e1074, _e452) & 2097151u))) - 8388608f) * _e165)), (_e833.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1105, _e1074, _e517) & 2097151u))) - 8388608f) * _e165)), (_e833.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1121, _e1074, _e581) & 2097151u))) - 8388608f) * _e165))), array<f32, 3>((_e833.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1150, _e1135, _e452) & 2097151u))) - 8388608f) * _e165)), (_e833.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1166, _e1135, _e517) & 2097151u))) - 8388608f) * _e165)), (_e833.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1182, _e1135, _e581) & 2097151u))) - 8388608f) * _e165))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e919 = (_e917 + _e428);
                                                        let _e920 = (_e919 < _e109);
                                                        if _e920 {
                                                            if _e920 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e922 = global_10.member[_e919];
                                                            phi_2152_ = _e922;
                                                        } else {
                                                            phi_2152_ = 0u;
                                                        }
                                                        let _e924 = phi_2152_;
                                                        let _e928 = (_e917 + _e427);
                                                        let _e929 = (_e928 < _e109);
                                                        if _e929 {
                                                            if _e929 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e931 = global_10.member[_e928];
                                                            phi_2170_ = _e931;
                                                        } else {
                                                            phi_2170_ = 0u;
                                                        }
                                                        let _e933 = phi_2170_;
                                                        let _e937 = (_e917 + _e429);
                                                        let _e938 = (_e937 < _e109);
                                                        if _e938 {
                                                            if _e938 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e940 = global_10.member[_e937];
                                                            phi_2188_ = _e940;
                                                        } else {
                                                            phi_2188_ = 0u;
                                                        }
                                                        let _e942 = phi_2188_;
                                                        let _e947 = (_e917 + 3u);
                                                        let _e948 = (_e947 + _e428);
                                                        let _e949 = (_e948 < _e109);
                                                        if _e949 {
                                                            if _e949 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e951 = global_10.member[_e948];
                                                            phi_2211_ = _e951;
                                                        } else {
                                                            phi_2211_ = 0u;
                                                        }
                                                        let _e953 = phi_2211_;
                                                        let _e957 = (_e947 + _e427);
                                                        let _e958 = (_e957 < _e109);
                                                        if _e958 {
                                                            if _e958 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e960 = global_10.member[_e957];
                                                            phi_2229_ = _e960;
                                                        } else {
                                                            phi_2229_ = 0u;
                                                        }
                                                        let _e962 = phi_2229_;
                                                        let _e966 = (_e947 + _e429);
                                                        let _e967 = (_e966 < _e109);
                                                        if _e967 {
                                                            if _e967 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e969 = global_10.member[_e966];
                                                            phi_2247_ = _e969;
                                                        } else {
                                                            phi_2247_ = 0u;
                                                        }
                                                        let _e971 = phi_2247_;
                                                        let _e976 = (_e917 + 6u);
                                                        let _e977 = (_e976 + _e428);
                                                        let _e978 = (_e977 < _e109);
                                                        if _e978 {
                                                            if _e978 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e980 = global_10.member[_e977];
                                                            phi_2270_ = _e980;
                                                        } else {
                                                            phi_2270_ = 0u;
                                                        }
                                                        let _e982 = phi_2270_;
                                                        let _e986 = (_e976 + _e427);
                                                        let _e987 = (_e986 < _e109);
                                                        if _e987 {
                                                            if _e987 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e989 = global_10.member[_e986];
                                                            phi_2288_ = _e989;
                                                        } else {
                                                            phi_2288_ = 0u;
                                                        }
                                                        let _e991 = phi_2288_;
                                                        let _e995 = (_e976 + _e429);
                                                        let _e996 = (_e995 < _e109);
                                                        if _e996 {
                                                            if _e996 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e998 = global_10.member[_e995];
                                                            phi_2306_ = _e998;
                                                        } else {
                                                            phi_2306_ = 0u;
                                                        }
                                                        let _e1000 = phi_2306_;
                                                        phi_2312_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e924)) * _e165), (f32(bitcast<i32>(_e933)) * _e165), (f32(bitcast<i32>(_e942)) * _e165)), array<f32, 3>((f32(bitcast<i32>(_e953)) * _e165), (f32(bitcast<i32>(_e962)) * _e165), (f32(bitcast<i32>(_e971)) * _e165)), array<f32, 3>((f32(bitcast<i32>(_e982)) * _e165), (f32(bitcast<i32>(_e991)) * _e165), (f32(bitcast<i32>(_e1000)) * _e165)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2312_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1292 = phi_2312_;
                                                let _e1308 = (_e1292[0][2] - _e604);
                                                let _e1311 = (((_e1292[0][0] - _e475) * _e640) - (_e1308 * _e512));
                                                let _e1314 = (((_e1292[0][1] - _e540) * _e640) - (_e1308 * _e576));
                                                let _e1317 = (_e1292[1][2] - _e604);
                                                let _e1320 = (((_e1292[1][0] - _e475) * _e640) - (_e1317 * _e512));
                                                let _e1323 = (((_e1292[1][1] - _e540) * _e640) - (_e1317 * _e576));
                                                let _e1326 = (_e1292[2][2] - _e604);
                                                let _e1329 = (((_e1292[2][0] - _e475) * _e640) - (_e1326 * _e512));
                                                let _e1332 = (((_e1292[2][1] - _e540) * _e640) - (_e1326 * _e576));
                                                let _e1333 = (_e1329 * _e1323);
                                                let _e1334 = (_e1332 * _e1320);
                                                let _e1335 = (_e1311 * _e1332);
                                                let _e1336 = (_e1314 * _e1329);
                                                let _e1337 = (_e1320 * _e1314);
                                                let _e1338 = (_e1323 * _e1311);
                                                let _e1343 = (((_e1333 >= _e1334) && (_e1335 >= _e1336)) && (_e1337 >= _e1338));
                                                let _e1349 = (_e1343 || (((_e1333 <= _e1334) && (_e1335 <= _e1336)) && (_e1337 <= _e1338)));
                                                if _e1349 {
                                                    let _e1351 = select(-1f, 1f, _e1343);
                                                    let _e1353 = ((_e1333 - _e1334) * _e1351);
                                                    let _e1355 = select(0f, _e1353, (_e1353 > 0f));
                                                    let _e1357 = ((_e1335 - _e1336) * _e1351);
                                                    let _e1359 = select(0f, _e1357, (_e1357 > 0f));
                                                    let _e1361 = ((_e1337 - _e1338) * _e1351);
                                                    let _e1363 = select(0f, _e1361, (_e1361 > 0f));
                                                    let _e1365 = ((_e1355 + _e1359) + _e1363);
                                                    let _e1367 = select(_e1292[1][0], _e1292[0][0], (_e1292[0][0] < _e1292[1][0]));
                                                    let _e1371 = select(_e1292[1][0], _e1292[0][0], (_e1292[0][0] > _e1292[1][0]));
                                                    let _e1375 = select(_e1292[1][1], _e1292[0][1], (_e1292[0][1] < _e1292[1][1]));
                                                    let _e1379 = select(_e1292[1][1], _e1292[0][1], (_e1292[0][1] > _e1292[1][1]));
                                                    let _e1383 = select(_e1292[1][2], _e1292[0][2], (_e1292[0][2] < _e1292[1][2]));
                                                    let _e1387 = select(_e1292[1][2], _e1292[0][2], (_e1292[0][2] > _e1292[1][2]));
                                                    let _e1392 = ((select(_e1292[2][0], _e1367, (_e1367 < _e1292[2][0])) - _e513) * _e516);
                                                    let _e1393 = ((select(_e1292[2][0], _e1371, (_e1371 > _e1292[2][0])) - _e514) * _e516);
                                                    let _e1396 = ((select(_e1292[2][1], _e1375, (_e1375 < _e1292[2][1])) - _e577) * _e580);
                                                    let _e1397 = ((select(_e1292[2][1], _e1379, (_e1379 > _e1292[2][1])) - _e578) * _e580);
                                                    let _e1400 = ((select(_e1292[2][2], _e1383, (_e1383 < _e1292[2][2])) - _e641) * _e644);
                                                    let _e1401 = ((select(_e1292[2][2], _e1387, (_e1387 > _e1292[2][2])) - _e642) * _e644);
                                                    let _e1403 = select(_e1401, _e1400, (_e1400 < _e1401));
                                                    let _e1405 = select(_e1401, _e1400, (_e1400 > _e1401));
                                                    let _e1407 = select(_e1393, _e1392, (_e1392 < _e1393));
                                                    let _e1409 = select(_e1397, _e1396, (_e1396 < _e1397));
                                                    let _e1411 = select(_e1409, _e1407, (_e1407 > _e1409));
                                                    let _e1413 = select(_e1403, _e1411, (_e1411 > _e1403));
                                                    let _e1415 = select(_e1393, _e1392, (_e1392 > _e1393));
                                                    let _e1417 = select(_e1397, _e1396, (_e1396 > _e1397));
                                                    let _e1419 = select(_e1417, _e1415, (_e1415 < _e1417));
                                                    let _e1421 = select(_e1405, _e1419, (_e1419 < _e1405));
                                                    let _e1422 = -(_e1403);
                                                    let _e1428 = select(_e746, _e1413, (_e1413 > _e746));
                                                    let _e1432 = select(_e1320, _e1311, (_e1311 < _e1320));
                                                    let _e1437 = select(_e1320, _e1311, (_e1311 > _e1320));
                                                    let _e1444 = select(_e1323, _e1314, (_e1314 < _e1323));
                                                    let _e1449 = select(_e1323, _e1314, (_e1314 > _e1323));
                                                    let _e1458 = (((((_e1349 && (_e1365 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1329, _e1432, (_e1432 < _e1329)) <= 0f) && (select(_e1329, _e1437, (_e1437 > _e1329)) >= 0f))) && ((select(_e1332, _e1444, (_e1444 < _e1332)) <= 0f) && (select(_e1332, _e1449, (_e1449 > _e1332)) >= 0f))) && (_e1428 <= (_e1421 + (select(_e1422, _e1405, (_e1405 > _e1422)) * 0.0000019073523f)))) && (_e1428 <= _e845.member_1));
                                                    if _e1458 {
                                                        let _e1463 = (_e1292[1][0] - _e1292[0][0]);
                                                        let _e1464 = (_e1292[1][1] - _e1292[0][1]);
                                                        let _e1465 = (_e1292[1][2] - _e1292[0][2]);
                                                        let _e1466 = vec3<f32>(_e1463, _e1464, _e1465);
                                                        let _e1467 = (_e1292[2][0] - _e1292[1][0]);
                                                        let _e1468 = (_e1292[2][1] - _e1292[1][1]);
                                                        let _e1469 = (_e1292[2][2] - _e1292[1][2]);
                                                        let _e1470 = vec3<f32>(_e1467, _e1468, _e1469);
                                                        let _e1471 = (_e1292[0][0] - _e1292[2][0]);
                                                        let _e1472 = (_e1292[0][1] - _e1292[2][1]);
                                                        let _e1473 = (_e1292[0][2] - _e1292[2][2]);
                                                        let _e1474 = vec3<f32>(_e1471, _e1472, _e1473);
                                                        let _e1475 = abs(_e1463);
                                                        let _e1476 = abs(_e1464);
                                                        if (_e1475 != _e1475) {
                                                            phi_4938_ = true;
                                                        } else {
                                                            phi_4938_ = (_e1476 >= _e1475);
                                                        }
                                                        let _e1480 = phi_4938_;
                                                        let _e1481 = select(_e1475, _e1476, _e1480);
                                                        let _e1482 = abs(_e1465);
                                                        if (_e1481 != _e1481) {
                                                            phi_4953_ = true;
                                                        } else {
                                                            phi_4953_ = (_e1482 >= _e1481);
                                                        }
                                                        let _e1486 = phi_4953_;
                                                        let _e1487 = select(_e1481, _e1482, _e1486);
                                                        let _e1488 = abs(_e1467);
                                                        let _e1489 = abs(_e1468);
                                                        if (_e1488 != _e1488) {
                                                            phi_4968_ = true;
                                                        } else {
                                                            phi_4968_ = (_e1489 >= _e1488);
                                                        }
                                                        let _e1493 = phi_4968_;
                                                        let _e1494 = select(_e1488, _e1489, _e1493);
                                                        let _e1495 = abs(_e1469);
                                                        if (_e1494 != _e1494) {
                                                            phi_4983_ = true;
                                                        } else {
                                                            phi_4983_ = (_e1495 >= _e1494);
                                                        }
                                                        let _e1499 = phi_4983_;
                                                        let _e1500 = select(_e1494, _e1495, _e1499);
                                                        let _e1501 = abs(_e1471);
                                                        let _e1502 = abs(_e1472);
                                                        if (_e1501 != _e1501) {
                                                            phi_4998_ = true;
                                                        } else {
                                                            phi_4998_ = (_e1502 >= _e1501);
                                                        }
                                                        let _e1506 = phi_4998_;
                                                        let _e1507 = select(_e1501, _e1502, _e1506);
                                                        let _e1508 = abs(_e1473);
                                                        if (_e1507 != _e1507) {
                                                            phi_5013_ = true;
                                                        } else {
                                                            phi_5013_ = (_e1508 >= _e1507);
                                                        }
                                                        let _e1512 = phi_5013_;
                                                        let _e1513 = select(_e1507, _e1508, _e1512);
                                                        let _e1515 = select(_e1500, _e1487, (_e1487 > _e1500));
                                                        let _e1517 = select(_e1513, _e1515, (_e1515 > _e1513));
                                                        if (_e1487 == _e1517) {
                                                            phi_2854_ = _e1323;
                                                            phi_2855_ = _e1320;
                                                            phi_2856_ = _e1314;
                                                            phi_2857_ = _e1311;
                                                            phi_2858_ = vec3<f32>(_e1292[0][0], _e1292[0][1], _e1292[0][2]);
                                                            phi_2859_ = _e1474;
                                                            phi_2860_ = _e1470;
                                                            phi_2861_ = _e1466;
                                                        } else {
                                                            let _e1519 = (_e1500 == _e1517);
                                                            let _e1524 = vec3(_e1519);
                                                            phi_2854_ = select(_e1314, _e1332, _e1519);
                                                            phi_2855_ = select(_e1311, _e1329, _e1519);
                                                            phi_2856_ = select(_e1332, _e1323, _e1519);
                                                            phi_2857_ = select(_e1329, _e1320, _e1519);
                                                            phi_2858_ = select(vec3<f32>(_e1292[2][0], _e1292[2][1], _e1292[2][2]), vec3<f32>(_e1292[1][0], _e1292[1][1], _e1292[1][2]), _e1524);
                                                            phi_2859_ = select(_e1470, _e1466, _e1524);
                                                            phi_2860_ = select(_e1466, _e1474, _e1524);
                                                            phi_2861_ = select(_e1474, _e1470, _e1524);
                                                        }
                                                        let _e1530 = phi_2854_;
                                                        let _e1532 = phi_2855_;
                                                        let _e1534 = phi_2856_;
                                                        let _e1536 = phi_2857_;
                                                        let _e1538 = phi_2858_;
                                                        let _e1540 = phi_2859_;
                                                        let _e1542 = phi_2860_;
                                                        let _e1544 = phi_2861_;
                                                        let _e1551 = ((_e1542.y * _e1540.z) - (_e1540.y * _e1542.z));
                                                        let _e1556 = ((_e1542.z * _e1540.x) - (_e1540.z * _e1542.x));
                                                        let _e1559 = ((_e1542.x * _e1540.y) - (_e1540.x * _e1542.y));
                                                        let _e1562 = ((_e1355 >= _e1359) && (_e1355 >= _e1363));
                                                        let _e1563 = (_e1359 >= _e1363);
                                                        let _e1577 = (((_e1551 * (select(select(_e1292[2][0], _e1292[1][0], _e1563), _e1292[0][0], _e1562) - _e475)) + (_e1556 * (select(select(_e1292[2][1], _e1292[1][1], _e1563), _e1292[0][1], _e1562) - _e540))) + (_e1559 * (select(select(_e1292[2][2], _e1292[1][2], _e1563), _e1292[0][2], _e1562) - _e604)));
                                                        let _e1582 = (((_e1551 * _e512) + (_e1556 * _e576)) + (_e1559 * _e640));
                                                        let _e1583 = (_e1532 - _e1536);
                                                        let _e1584 = (_e1530 - _e1534);
                                                        let _e1587 = ((_e1583 * _e1583) + (_e1584 * _e1584));
                                                        let _e1594 = (-(((_e1536 * _e1583) + (_e1534 * _e1584))) / select(0.000000000000000000000000000000000000011754944f, _e1587, (_e1587 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1596 = select(1f, _e1594, (_e1594 < 1f));
                                                        let _e1598 = select(0f, _e1596, (_e1596 > 0f));
                                                        let _e1607 = ((_e1538.x + (_e1544.x * _e1598)) - _e475);
                                                        let _e1610 = ((_e1538.y + (_e1544.y * _e1598)) - _e540);
                                                        let _e1613 = ((_e1538.z + (_e1544.z * _e1598)) - _e604);
                                                        let _e1616 = bitcast<f32>((bitcast<u32>(_e1607) & 2147483647u));
                                                        let _e1619 = bitcast<f32>((bitcast<u32>(_e1610) & 2147483647u));
                                                        let _e1621 = select(_e1619, _e1616, (_e1616 > _e1619));
                                                        let _e1624 = bitcast<f32>((bitcast<u32>(_e1613) & 2147483647u));
                                                        let _e1626 = select(_e1624, _e1621, (_e1621 > _e1624));
                                                        let _e1630 = abs(_e1551);
                                                        let _e1631 = abs(_e1556);
                                                        if (_e1630 != _e1630) {
                                                            phi_5028_ = true;
                                                        } else {
                                                            phi_5028_ = (_e1631 >= _e1630);
                                                        }
                                                        let _e1635 = phi_5028_;
                                                        let _e1636 = select(_e1630, _e1631, _e1635);
                                                        let _e1637 = abs(_e1559);
                                                        if (_e1636 != _e1636) {
                                                            phi_5043_ = true;
                                                        } else {
                                                            phi_5043_ = (_e1637 >= _e1636);
                                                        }
                                                        let _e1641 = phi_5043_;
                                                        let _e1657 = abs(_e1542.x);
                                                        let _e1658 = abs(_e1542.y);
                                                        if (_e1657 != _e1657) {
                                                            phi_5058_ = true;
                                                        } else {
                                                            phi_5058_ = (_e1658 >= _e1657);
                                                        }
                                                        let _e1662 = phi_5058_;
                                                        let _e1663 = select(_e1657, _e1658, _e1662);
                                                        let _e1664 = abs(_e1542.z);
                                                        if (_e1663 != _e1663) {
                                                            phi_5073_ = true;
                                                        } else {
                                                            phi_5073_ = (_e1664 >= _e1663);
                                                        }
                                                        let _e1668 = phi_5073_;
                                                        let _e1671 = abs(_e1540.x);
                                                        let _e1672 = abs(_e1540.y);
                                                        if (_e1671 != _e1671) {
                                                            phi_5088_ = true;
                                                        } else {
                                                            phi_5088_ = (_e1672 >= _e1671);
                                                        }
                                                        let _e1676 = phi_5088_;
                                                        let _e1677 = select(_e1671, _e1672, _e1676);
                                                        let _e1678 = abs(_e1540.z);
                                                        if (_e1677 != _e1677) {
                                                            phi_5103_ = true;
                                                        } else {
                                                            phi_5103_ = (_e1678 >= _e1677);
                                                        }
                                                        let _e1682 = phi_5103_;
                                                        let _e1687 = ((bitcast<f32>((bitcast<u32>(((((_e1551 * _e1607) + (_e1556 * _e1610)) + (_e1559 * _e1613)) - _e1577)) & 2147483647u)) <= ((0.0000009536743f * select(_e1517, _e1626, (_e1626 > _e1517))) * select(_e1636, _e1637, _e1641))) && !((bitcast<f32>((bitcast<u32>(_e1582) & 2147483647u)) <= ((0.0000038146973f * select(_e1663, _e1664, _e1668)) * select(_e1677, _e1678, _e1682)))));
                                                        let _e1688 = (_e1577 / _e1582);
                                                        if (_e1458 && !(_e1687)) {
                                                            let _e1691 = (_e1613 / _e640);
                                                            let _e1699 = (((_e1551 * (_e1607 - (_e512 * _e1691))) + (_e1556 * (_e1610 - (_e576 * _e1691)))) / _e1582);
                                                            phi_3069_ = select(select(_e1691, (_e1691 + _e1699), (bitcast<f32>((bitcast<u32>(_e1699) & 2147483647u)) <= _e1517)), _e1688, _e1687);
                                                        } else {
                                                            phi_3069_ = _e1688;
                                                        }
                                                        let _e1708 = phi_3069_;
                                                        let _e1710 = select(_e1421, _e1708, (_e1708 < _e1421));
                                                        let _e1712 = select(_e1413, _e1710, (_e1710 > _e1413));
                                                        let _e1713 = (1f / _e1365);
                                                        phi_3089_ = type_42(_e1712, (_e1359 * _e1713), (_e1363 * _e1713), ((_e1458 && (_e1712 >= _e746)) && (_e1712 <= _e845.member_1)));
                                                        phi_3090_ = type_42();
                                                    } else {
                                                        phi_3089_ = type_42();
                                                        phi_3090_ = type_42(0f, 0f, 0f, _e1458);
                                                    }
                                                    let _e1722 = phi_3089_;
                                                    let _e1724 = phi_3090_;
                                                    phi_3093_ = _e1722;
                                                    phi_3094_ = _e1724;
                                                    phi_3095_ = select(true, false, _e1458);
                                                } else {
                                                    phi_3093_ = type_42();
                                                    phi_3094_ = type_42(0f, 0f, 0f, _e1349);
                                                    phi_3095_ = true;
                                                }
                                                let _e1727 = phi_3093_;
                                                let _e1729 = phi_3094_;
                                                let _e1731 = phi_3095_;
                                                if _e1731 {
                                                    phi_3099_ = _e1729;
                                                } else {
                                                    phi_3099_ = _e1727;
                                                }
                                                let _e1733 = phi_3099_;
                                                if _e1733.member_3 {
                                                    phi_3108_ = type_21(_e1733.member, _e1733.member_1, _e1733.member_2, _e905);
                                                } else {
                                                    phi_3108_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1740 = phi_3108_;
                                                if (_e1740.member_3 != 4294967295u) {
                                                    if (_e905 == _e174) {
                                                        phi_3443_ = false;
                                                    } else {
                                                        let _e1744 = (_e905 < arrayLength((&global_4.member)));
                                                        if _e1744 {
                                                            if _e1744 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e1746 = global_4.member[_e905];
                                                            phi_3131_ = _e1746;
                                                        } else {
                                                            phi_3131_ = 4294967295u;
                                                        }
                                                        let _e1748 = phi_3131_;
                                                        let _e1749 = (_e1748 < arrayLength((&global_5.member)));
                                                        if _e1749 {
                                                            if _e1749 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e1751 = global_5.member[_e1748];
                                                            phi_3145_ = _e1751;
                                                        } else {
                                                            phi_3145_ = 0i;
                                                        }
                                                        let _e1753 = phi_3145_;
                                                        let _e1754 = (_e1753 == 0i);
                                                        if _e1754 {
                                                            phi_3442_ = true;
                                                        } else {
                                                            if _e452 {
                                                                phi_3168_ = vec3<f32>(_e1292[0][0], _e1292[0][1], _e1292[0][2]);
                                                            } else {
                                                                if (_e428 == 1u) {
                                                                    phi_3167_ = vec3<f32>(_e1292[0][2], _e1292[0][0], _e1292[0][1]);
                                                                } else {
                                                                    phi_3167_ = vec3<f32>(_e1292[0][1], _e1292[0][2], _e1292[0][0]);
                                                                }
                                                                let _e1759 = phi_3167_;
                                                                phi_3168_ = _e1759;
                                                            }
                                                            let _e1762 = phi_3168_;
                                                            if _e452 {
                                                                phi_3187_ = vec3<f32>(_e1292[1][0], _e1292[1][1], _e1292[1][2]);
                                                            } else {
                                                                if (_e428 == 1u) {
                                                                    phi_3186_ = vec3<f32>(_e1292[1][2], _e1292[1][0], _e1292[1][1]);
                                                                } else {
                                                                    phi_3186_ = vec3<f32>(_e1292[1][1], _e1292[1][2], _e1292[1][0]);
                                                                }
                                                                let _e1767 = phi_3186_;
                                                                phi_3187_ = _e1767;
                                                            }
                                                            let _e1770 = phi_3187_;
                                                            if _e452 {
                                                                phi_3206_ = vec3<f32>(_e1292[2][0], _e1292[2][1], _e1292[2][2]);
                                                            } else {
                                                                if (_e428 == 1u) {
                                                                    phi_3205_ = vec3<f32>(_e1292[2][2], _e1292[2][0], _e1292[2][1]);
                                                                } else {
                                                                    phi_3205_ = vec3<f32>(_e1292[2][1], _e1292[2][2], _e1292[2][0]);
                                                                }
                                                                let _e1775 = phi_3205_;
                                                                phi_3206_ = _e1775;
                                                            }
                                                            let _e1778 = phi_3206_;
                                                            let _e1781 = (_e1770.x - _e1762.x);
                                                            let _e1784 = (_e1770.y - _e1762.y);
                                                            let _e1787 = (_e1770.z - _e1762.z);
                                                            let _e1789 = (_e1778.x - _e1762.x);
                                                            let _e1791 = (_e1778.y - _e1762.y);
                                                            let _e1793 = (_e1778.z - _e1762.z);
                                                            if (_e306.member_1 == 1u) {
                                                                phi_3242_ = (vec3<f32>(_e306.member[0], _e306.member[1], _e306.member[2]) - _e1762);
                                                            } else {
                                                                phi_3242_ = vec3<f32>(_e306.member[0], _e306.member[1], _e306.member[2]);
                                                            }
                                                            let _e1808 = phi_3242_;
                                                            let _e1814 = bitcast<f32>((bitcast<u32>((_e1781 * _e1791)) ^ _e306.member_3[0]));
                                                            let _e1818 = bitcast<f32>((bitcast<u32>((_e1784 * _e1789)) ^ _e306.member_3[0]));
                                                            let _e1822 = bitcast<f32>((bitcast<u32>((_e1784 * _e1793)) ^ _e306.member_3[0]));
                                                            let _e1826 = bitcast<f32>((bitcast<u32>((_e1787 * _e1791)) ^ _e306.member_3[0]));
                                                            let _e1830 = bitcast<f32>((bitcast<u32>((_e1787 * _e1789)) ^ _e306.member_3[0]));
                                                            let _e1834 = bitcast<f32>((bitcast<u32>((_e1781 * _e1793)) ^ _e306.member_3[0]));
                                                            let _e1835 = (_e1822 - _e1826);
                                                            let _e1836 = (_e1830 - _e1834);
                                                            let _e1837 = (_e1814 - _e1818);
                                                            let _e1861 = (bitcast<f32>((bitcast<u32>(_e1822) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1826) & 2147483647u)));
                                                            let _e1868 = (bitcast<f32>((bitcast<u32>(_e1830) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1834) & 2147483647u)));
                                                            let _e1875 = (bitcast<f32>((bitcast<u32>(_e1814) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1818) & 2147483647u)));
                                                            if (_e306.member_2 == 0f) {
                                                                phi_3424_ = 0f;
                                                            } else {
                                                                let _e1905 = bitcast<f32>((bitcast<u32>(_e1835) & 2147483647u));
                                                                let _e1908 = bitcast<f32>((bitcast<u32>(_e1836) & 2147483647u));
                                                                let _e1911 = bitcast<f32>((bitcast<u32>(_e1837) & 2147483647u));
                                                                let _e1913 = select(_e1911, _e1908, (_e1908 > _e1911));
                                                                let _e1917 = select(_e1911, _e1908, (_e1908 < _e1911));
                                                                let _e1921 = select(_e1908, _e1905, (_e1905 < _e1908));
                                                                let _e1923 = select(_e1908, _e1905, (_e1905 > _e1908));
                                                                let _e1925 = select(_e1911, _e1923, (_e1923 < _e1911));
                                                                phi_3424_ = bitcast<f32>((bitcast<u32>((_e306.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1913, _e1905, (_e1905 > _e1913)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1925, _e1921, (_e1921 > _e1925)))) ^ _e306.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1917, _e1905, (_e1905 < _e1917)))) ^ _e306.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1861 + _e1868) + _e1875))) ^ _e306.member_3[0]))) * 1.0000005f)) ^ _e306.member_3[0])))) ^ _e306.member_3[0]));
                                                            }
                                                            let _e1952 = phi_3424_;
                                                            phi_3442_ = (_e1754 || !(((((bitcast<f32>((bitcast<u32>((_e1808.x * _e1835)) ^ _e306.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1808.y * _e1836)) ^ _e306.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1808.z * _e1837)) ^ _e306.member_3[0]))) * f32(-(_e1753))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1808.x) & 2147483647u)) * _e1861)) ^ _e306.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1808.y) & 2147483647u)) * _e1868)) ^ _e306.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1808.z) & 2147483647u)) * _e1875)) ^ _e306.member_3[0]))))) ^ _e306.member_3[0])) + _e1952) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1966 = phi_3442_;
                                                        phi_3443_ = _e1966;
                                                    }
                                                    let _e1968 = phi_3443_;
                                                    if _e1968 {
                                                        if (_e1740.member < _e845.member.member) {
                                                            phi_3463_ = true;
                                                        } else {
                                                            if (_e1740.member == _e845.member.member) {
                                                                phi_3462_ = (_e1740.member_3 < _e845.member.member_3);
                                                            } else {
                                                                phi_3462_ = false;
                                                            }
                                                            let _e1978 = phi_3462_;
                                                            phi_3463_ = _e1978;
                                                        }
                                                        let _e1980 = phi_3463_;
                                                        if _e1980 {
                                                            phi_3469_ = type_39(_e1740, _e1740.member);
                                                        } else {
                                                            phi_3469_ = _e845;
                                                        }
                                                        let _e1983 = phi_3469_;
                                                        phi_3470_ = _e1983;
                                                    } else {
                                                        phi_3470_ = _e845;
                                                    }
                                                    let _e1985 = phi_3470_;
                                                    phi_3471_ = _e1985;
                                                } else {
                                                    phi_3471_ = _e845;
                                                }
                                                let _e1987 = phi_3471_;
                                                phi_1549_ = _e1987;
                                            } else {
                                                phi_1549_ = type_39();
                                            }
                                            let _e1989 = phi_1549_;
                                            continue;
                                            continuing {
                                                phi_1548_ = _e1989;
                                                phi_1551_ = _e860;
                                                phi_5371_ = _e788;
                                                break if !(_e866);
                                            }
                                        }
                                        let _e1992 = phi_5371_;
                                        phi_5615_ = _e1992;
                                        if _e1992 {
                                            break;
                                        }
                                        phi_5706_ = _e1992;
                                        let _e2806 = local_11;
                                        phi_3472_ = _e2806;
                                    } else {
                                        phi_5706_ = _e788;
                                        phi_3472_ = _e790;
                                    }
                                    let _e1994 = phi_5706_;
                                    let _e1996 = phi_3472_;
                                    if _e837 {
                                        phi_4737_ = bool();
                                        phi_4738_ = u32();
                                        phi_4739_ = type_58();
                                    } else {
                                        if (_e833.member_1 >= _e106) {
                                            phi_4273_ = type_59(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_58(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_58(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e833.member_1 < _e106) {
                                            } else {
                                                phi_5615_ = true;
                                                break;
                                            }
                                            let _e1999 = (_e428 * 2u);
                                            let _e2001 = ((1u + _e1999) % 7u);
                                            if (_e2001 < 7u) {
                                            } else {
                                                phi_5615_ = true;
                                                break;
                                            }
                                            let _e2006 = global_9.member[_e833.member_1][_e2001];
                                            let _e2008 = ((_e1999 + 2u) % 7u);
                                            if (_e2008 < 7u) {
                                            } else {
                                                phi_5615_ = true;
                                                break;
                                            }
                                            let _e2013 = global_9.member[_e833.member_1][_e2008];
                                            let _e2014 = (_e427 * 2u);
                                            let _e2016 = ((1u + _e2014) % 7u);
                                            if (_e2016 < 7u) {
                                            } else {
                                                phi_5615_ = true;
                                                break;
                                            }
                                            let _e2021 = global_9.member[_e833.member_1][_e2016];
                                            let _e2023 = ((_e2014 + 2u) % 7u);
                                            if (_e2023 < 7u) {
                                            } else {
                                                phi_5615_ = true;
                                                break;
                                            }
                                            let _e2028 = global_9.member[_e833.member_1][_e2023];
                                            let _e2029 = (_e429 * 2u);
                                            let _e2031 = ((1u + _e2029) % 7u);
                                            if (_e2031 < 7u) {
                                            } else {
                                                phi_5615_ = true;
                                                break;
                                            }
                                            let _e2036 = global_9.member[_e833.member_1][_e2031];
                                            let _e2038 = ((_e2029 + 2u) % 7u);
                                            if (_e2038 < 7u) {
                                            } else {
                                                phi_5615_ = true;
                                                break;
                                            }
                                            let _e2043 = global_9.member[_e833.member_1][_e2038];
                                            let _e2066 = (bitcast<f32>((bitcast<u32>((_e833.member.member_1.x - _e833.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e2067 = (bitcast<f32>((bitcast<u32>((_e833.member.member_1.y - _e833.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e2068 = (bitcast<f32>((bitcast<u32>((_e833.member.member_1.z - _e833.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e2070 = select(_e165, _e2066, (_e2066 > _e165));
                                            let _e2072 = select(_e165, _e2067, (_e2067 > _e165));
                                            let _e2074 = select(_e165, _e2068, (_e2068 > _e165));
                                            let _e2105 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2006 & 2097151u))) - 8388608f) * _e2070));
                                            let _e2110 = (bitcast<i32>((_e2006 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e2113 = bitcast<f32>((_e2105 & bitcast<u32>(_e2110)));
                                            let _e2114 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2021 & 2097151u))) - 8388608f) * _e2072));
                                            let _e2119 = (bitcast<i32>((_e2021 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e2122 = bitcast<f32>((_e2114 & bitcast<u32>(_e2119)));
                                            let _e2123 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2036 & 2097151u))) - 8388608f) * _e2074));
                                            let _e2128 = (bitcast<i32>((_e2036 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e2131 = bitcast<f32>((_e2123 & bitcast<u32>(_e2128)));
                                            let _e2135 = bitcast<f32>((_e2105 & bitcast<u32>(~(_e2110))));
                                            let _e2139 = bitcast<f32>((_e2114 & bitcast<u32>(~(_e2119))));
                                            let _e2143 = bitcast<f32>((_e2123 & bitcast<u32>(~(_e2128))));
                                            let _e2144 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2013 & 2097151u))) - 8388608f) * _e2070));
                                            let _e2149 = (bitcast<i32>((_e2013 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e2152 = bitcast<f32>((_e2144 & bitcast<u32>(_e2149)));
                                            let _e2153 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2028 & 2097151u))) - 8388608f) * _e2072));
                                            let _e2158 = (bitcast<i32>((_e2028 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e2161 = bitcast<f32>((_e2153 & bitcast<u32>(_e2158)));
                                            let _e2162 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2043 & 2097151u))) - 8388608f) * _e2074));
                                            let _e2167 = (bitcast<i32>((_e2043 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e2170 = bitcast<f32>((_e2162 & bitcast<u32>(_e2167)));
                                            let _e2174 = bitcast<f32>((_e2144 & bitcast<u32>(~(_e2149))));
                                            let _e2178 = bitcast<f32>((_e2153 & bitcast<u32>(~(_e2158))));
                                            let _e2182 = bitcast<f32>((_e2162 & bitcast<u32>(~(_e2167))));
                                            let _e2183 = (_e833.member.member.x + _e2113);
                                            let _e2184 = (_e833.member.member.y + _e2122);
                                            let _e2185 = (_e833.member.member.z + _e2131);
                                            let _e2188 = (_e833.member.member_1.x - _e2152);
                                            let _e2189 = (_e833.member.member_1.y - _e2161);
                                            let _e2190 = (_e833.member.member_1.z - _e2170);
                                            let _e2209 = (_e2188 - _e2183);
                                            let _e2210 = (_e2189 - _e2184);
                                            let _e2211 = (_e2190 - _e2185);
                                            let _e2213 = select(_e2210, _e2209, (_e2209 > _e2210));
                                            let _e2215 = select(_e2211, _e2213, (_e2213 > _e2211));
                                            if (_e2215 < (1024f * _e165)) {
                                                phi_3974_ = 0u;
                                            } else {
                                                phi_3974_ = select(2u, 1u, (_e2215 < (2097152f * _e165)));
                                            }
                                            let _e2222 = phi_3974_;
                                            switch bitcast<i32>(_e2222) {
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
                                            let _e2225 = phi_3980_;
                                            let _e2231 = global_9.member[_e833.member_1][0u];
                                            let _e2235 = global_9.member[_e833.member_1][2u];
                                            let _e2239 = global_9.member[_e833.member_1][4u];
                                            let _e2243 = global_9.member[_e833.member_1][6u];
                                            let _e2255 = (((_e2235 >> bitcast<u32>(22i)) | ((_e2239 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e2243 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e2256 = (_e2231 & 268435455u);
                                            let _e2257 = (_e2255 & 268435455u);
                                            let _e2260 = ((_e2231 >> bitcast<u32>(28u)) & 7u);
                                            let _e2268 = ((_e2231 >> bitcast<u32>(31i)) | (((_e2255 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e2269 = (_e2260 != 0u);
                                            if (_e2260 == 0u) {
                                                phi_4235_ = _e2256;
                                            } else {
                                                if (_e2260 == 7u) {
                                                    phi_4234_ = 2147483648u;
                                                } else {
                                                    phi_4234_ = ((2147483648u | (_e2260 << bitcast<u32>(28u))) | (_e2257 & 268435455u));
                                                }
                                                let _e2278 = phi_4234_;
                                                phi_4235_ = _e2278;
                                            }
                                            let _e2280 = phi_4235_;
                                            if _e2269 {
                                                let _e2281 = (_e2260 != 7u);
                                                if _e2281 {
                                                    phi_4245_ = (_e2257 + (_e2260 * ((3u * _e2225) + 1u)));
                                                } else {
                                                    phi_4245_ = u32();
                                                }
                                                let _e2285 = phi_4245_;
                                                phi_4247_ = _e2285;
                                                phi_4248_ = select(true, false, _e2281);
                                            } else {
                                                phi_4247_ = u32();
                                                phi_4248_ = true;
                                            }
                                            let _e2288 = phi_4247_;
                                            let _e2290 = phi_4248_;
                                            if (_e2268 == 0u) {
                                                phi_4269_ = (_e2256 + select(0u, 1u, !(_e2269)));
                                            } else {
                                                if (_e2268 == 7u) {
                                                    phi_4268_ = 2147483648u;
                                                } else {
                                                    phi_4268_ = ((2147483648u | (_e2268 << bitcast<u32>(28u))) | (select(_e2288, _e2257, _e2290) & 268435455u));
                                                }
                                                let _e2303 = phi_4268_;
                                                phi_4269_ = _e2303;
                                            }
                                            let _e2305 = phi_4269_;
                                            phi_4273_ = type_59(array<vec4<f32>, 3>(vec4<f32>(_e2183, (_e833.member.member.x + _e2135), _e2188, (_e833.member.member_1.x - _e2174)), vec4<f32>(_e2184, (_e833.member.member.y + _e2139), _e2189, (_e833.member.member_1.y - _e2178)), vec4<f32>(_e2185, (_e833.member.member.z + _e2143), _e2190, (_e833.member.member_1.z - _e2182))), type_58(type_33((_e833.member.member + vec4<f32>(_e2113, _e2122, _e2131, 0f)), (_e833.member.member_1 - vec4<f32>(_e2152, _e2161, _e2170, 0f))), _e2280), type_58(type_33((_e833.member.member + vec4<f32>(_e2135, _e2139, _e2143, 0f)), (_e833.member.member_1 - vec4<f32>(_e2174, _e2178, _e2182, 0f))), _e2305));
                                        }
                                        let _e2310 = phi_4273_;
                                        let _e2322 = ((_e2310.member[0].x - _e513) * _e516);
                                        let _e2323 = ((_e2310.member[0].y - _e513) * _e516);
                                        let _e2324 = ((_e2310.member[0].z - _e514) * _e516);
                                        let _e2325 = ((_e2310.member[0].w - _e514) * _e516);
                                        let _e2335 = ((_e2310.member[1].x - _e577) * _e580);
                                        let _e2336 = ((_e2310.member[1].y - _e577) * _e580);
                                        let _e2337 = ((_e2310.member[1].z - _e578) * _e580);
                                        let _e2338 = ((_e2310.member[1].w - _e578) * _e580);
                                        let _e2348 = ((_e2310.member[2].x - _e641) * _e644);
                                        let _e2349 = ((_e2310.member[2].y - _e641) * _e644);
                                        let _e2350 = ((_e2310.member[2].z - _e642) * _e644);
                                        let _e2351 = ((_e2310.member[2].w - _e642) * _e644);
                                        let _e2353 = select(_e2350, _e2348, (_e2348 < _e2350));
                                        let _e2355 = select(_e2351, _e2349, (_e2349 < _e2351));
                                        let _e2357 = select(_e2350, _e2348, (_e2348 > _e2350));
                                        let _e2359 = select(_e2351, _e2349, (_e2349 > _e2351));
                                        let _e2361 = select(_e2324, _e2322, (_e2322 < _e2324));
                                        let _e2363 = select(_e2325, _e2323, (_e2323 < _e2325));
                                        let _e2365 = select(_e2337, _e2335, (_e2335 < _e2337));
                                        let _e2367 = select(_e2338, _e2336, (_e2336 < _e2338));
                                        let _e2369 = select(_e2365, _e2361, (_e2361 > _e2365));
                                        let _e2371 = select(_e2367, _e2363, (_e2363 > _e2367));
                                        let _e2373 = select(_e2353, _e2369, (_e2369 > _e2353));
                                        let _e2375 = select(_e2355, _e2371, (_e2371 > _e2355));
                                        let _e2377 = select(_e2324, _e2322, (_e2322 > _e2324));
                                        let _e2379 = select(_e2325, _e2323, (_e2323 > _e2325));
                                        let _e2381 = select(_e2337, _e2335, (_e2335 > _e2337));
                                        let _e2383 = select(_e2338, _e2336, (_e2336 > _e2338));
                                        let _e2385 = select(_e2381, _e2377, (_e2377 < _e2381));
                                        let _e2387 = select(_e2383, _e2379, (_e2379 < _e2383));
                                        let _e2392 = -(_e2353);
                                        let _e2393 = -(_e2355);
                                        let _e2400 = (select(_e2357, _e2385, (_e2385 < _e2357)) + (select(_e2392, _e2357, (_e2357 > _e2392)) * 0.0000019073523f));
                                        let _e2401 = (select(_e2359, _e2387, (_e2387 < _e2359)) + (select(_e2393, _e2359, (_e2359 > _e2393)) * 0.0000019073523f));
                                        let _e2403 = select(_e746, _e2373, (_e2373 > _e746));
                                        let _e2405 = select(_e746, _e2375, (_e2375 > _e746));
                                        let _e2410 = (_e2403 <= select(_e1996.member_1, _e2400, (_e2400 < _e1996.member_1)));
                                        let _e2411 = (_e2405 <= select(_e1996.member_1, _e2401, (_e2401 < _e1996.member_1)));
                                        let _e2412 = (_e2403 <= _e2405);
                                        if _e2410 {
                                            if _e2411 {
                                                if _e2412 {
                                                    phi_4635_ = _e2310.member_2;
                                                } else {
                                                    phi_4635_ = _e2310.member_1;
                                                }
                                                let _e2416 = phi_4635_;
                                                let _e2437 = (_e831 % 128u);
                                                let _e2438 = (_e2437 < 128u);
                                                if _e2438 {
                                                } else {
                                                    phi_5615_ = true;
                                                    break;
                                                }
                                                local_8[_e2437] = _e2416.member_1;
                                                if _e2438 {
                                                } else {
                                                    phi_5615_ = true;
                                                    break;
                                                }
                                                local_7[_e2437] = _e2416.member.member.x;
                                                if _e2438 {
                                                } else {
                                                    phi_5615_ = true;
                                                    break;
                                                }
                                                local_6[_e2437] = _e2416.member.member.y;
                                                if _e2438 {
                                                } else {
                                                    phi_5615_ = true;
                                                    break;
                                                }
                                                local_5[_e2437] = _e2416.member.member.z;
                                                if _e2438 {
                                                } else {
                                                    phi_5615_ = true;
                                                    break;
                                                }
                                                local_4[_e2437] = _e2416.member.member_1.x;
                                                if _e2438 {
                                                } else {
                                                    phi_5615_ = true;
                                                    break;
                                                }
                                                local_3[_e2437] = _e2416.member.member_1.y;
                                                if _e2438 {
                                                } else {
                                                    phi_5615_ = true;
                                                    break;
                                                }
                                                local_2[_e2437] = _e2416.member.member_1.z;
                                                if _e2438 {
                                                } else {
                                                    phi_5615_ = true;
                                                    break;
                                                }
                                                local_9[_e2437] = select(_e2403, _e2405, _e2412);
                                                if _e2412 {
                                                    phi_4711_ = _e2310.member_1;
                                                } else {
                                                    phi_4711_ = _e2310.member_2;
                                                }
                                                let _e2451 = phi_4711_;
                                                phi_4712_ = (_e831 + 1u);
                                                phi_4713_ = _e2451;
                                            } else {
                                                phi_4712_ = u32();
                                                phi_4713_ = type_58();
                                            }
                                            let _e2453 = phi_4712_;
                                            let _e2455 = phi_4713_;
                                            phi_4715_ = _e2453;
                                            phi_4716_ = _e2455;
                                            phi_4717_ = select(true, false, _e2411);
                                        } else {
                                            phi_4715_ = u32();
                                            phi_4716_ = type_58();
                                            phi_4717_ = true;
                                        }
                                        let _e2458 = phi_4715_;
                                        let _e2460 = phi_4716_;
                                        let _e2462 = phi_4717_;
                                        if _e2462 {
                                            if _e2410 {
                                                phi_4726_ = _e2310.member_1;
                                            } else {
                                                phi_4726_ = _e2310.member_2;
                                            }
                                            let _e2466 = phi_4726_;
                                            phi_4731_ = select(_e2411, true, _e2410);
                                            phi_4733_ = _e2466;
                                        } else {
                                            phi_4731_ = _e829;
                                            phi_4733_ = _e2460;
                                        }
                                        let _e2469 = phi_4731_;
                                        let _e2471 = phi_4733_;
                                        phi_4737_ = _e2469;
                                        phi_4738_ = select(_e2458, _e831, _e2462);
                                        phi_4739_ = _e2471;
                                    }
                                    let _e2474 = phi_4737_;
                                    let _e2476 = phi_4738_;
                                    let _e2478 = phi_4739_;
                                    if _e837 {
                                        phi_4749_ = _e833;
                                    } else {
                                        phi_4749_ = _e2478;
                                    }
                                    let _e2480 = phi_4749_;
                                    phi_5618_ = _e1994;
                                    phi_4750_ = _e1996;
                                    phi_4751_ = (_e792 - 1u);
                                    phi_4752_ = select(_e2474, false, _e837);
                                    phi_4753_ = select(_e2476, _e831, _e837);
                                    phi_4754_ = _e2480;
                                } else {
                                    phi_5618_ = _e788;
                                    phi_4750_ = _e790;
                                    phi_4751_ = _e792;
                                    phi_4752_ = _e829;
                                    phi_4753_ = _e831;
                                    phi_4754_ = _e833;
                                }
                                let _e2484 = phi_5618_;
                                let _e2486 = phi_4750_;
                                let _e2488 = phi_4751_;
                                let _e2490 = phi_4752_;
                                let _e2492 = phi_4753_;
                                let _e2494 = phi_4754_;
                                phi_5617_ = _e2484;
                                phi_4755_ = _e2486;
                                phi_4756_ = _e2488;
                                phi_4757_ = _e2490;
                                phi_4758_ = _e2492;
                                phi_4759_ = _e2494;
                            } else {
                                phi_5617_ = _e788;
                                phi_4755_ = type_39();
                                phi_4756_ = u32();
                                phi_4757_ = bool();
                                phi_4758_ = u32();
                                phi_4759_ = type_58();
                            }
                            let _e2496 = phi_5617_;
                            let _e2498 = phi_4755_;
                            let _e2500 = phi_4756_;
                            let _e2502 = phi_4757_;
                            let _e2504 = phi_4758_;
                            let _e2506 = phi_4759_;
                            phi_5616_ = _e2496;
                            phi_1422_ = _e2498;
                            phi_1425_ = _e2500;
                            phi_1427_ = _e2502;
                            phi_1429_ = _e2504;
                            phi_1431_ = _e2506;
                            phi_4760_ = _e802;
                        } else {
                            phi_5616_ = _e788;
                            phi_1422_ = type_39();
                            phi_1425_ = u32();
                            phi_1427_ = bool();
                            phi_1429_ = u32();
                            phi_1431_ = type_58();
                            phi_4760_ = false;
                        }
                        let _e2508 = phi_5616_;
                        let _e2510 = phi_1422_;
                        let _e2512 = phi_1425_;
                        let _e2514 = phi_1427_;
                        let _e2516 = phi_1429_;
                        let _e2518 = phi_1431_;
                        let _e2520 = phi_4760_;
                        continue;
                        continuing {
                            phi_5377_ = _e2508;
                            phi_1421_ = _e2510;
                            phi_1424_ = _e2512;
                            phi_1426_ = _e2514;
                            phi_1428_ = _e2516;
                            phi_1430_ = _e2518;
                            phi_5615_ = _e2508;
                            break if !(_e2520);
                        }
                    }
                    let _e2523 = phi_5615_;
                    if _e2523 {
                        break;
                    }
                    let _e2525 = local_10;
                    if (_e2525.member.member_3 != 4294967295u) {
                        let _e2530 = bitcast<u32>(_e2525.member.member);
                        let _e2534 = (bitcast<i32>((_e2530 >> bitcast<u32>(23i))) & 255i);
                        let _e2535 = (_e2534 + _e430);
                        if (_e2534 == 255i) {
                            phi_4819_ = _e2525.member.member;
                        } else {
                            if (_e2534 > 0i) {
                                if (_e2535 > 0i) {
                                    let _e2539 = (_e2535 < 255i);
                                    if _e2539 {
                                        phi_4798_ = bitcast<f32>((_e2530 + bitcast<u32>((_e430 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_4798_ = f32();
                                    }
                                    let _e2546 = phi_4798_;
                                    phi_4800_ = _e2546;
                                    phi_4801_ = select(true, false, _e2539);
                                } else {
                                    phi_4800_ = f32();
                                    phi_4801_ = true;
                                }
                                let _e2549 = phi_4800_;
                                let _e2551 = phi_4801_;
                                phi_4802_ = _e2549;
                                phi_4803_ = _e2551;
                            } else {
                                phi_4802_ = f32();
                                phi_4803_ = true;
                            }
                            let _e2553 = phi_4802_;
                            let _e2555 = phi_4803_;
                            if _e2555 {
                                let _e2556 = (_e2530 & 2147483648u);
                                let _e2563 = ((_e2530 & 8388607u) | (select(0u, 1u, ((_e2530 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e2567 = (_e2563 == 0u);
                                if _e2567 {
                                    phi_5329_ = bitcast<f32>(_e2556);
                                } else {
                                    let _e2572 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2563)), 32u, _e2567) - 8u);
                                    let _e2575 = (_e2563 << bitcast<u32>((_e2572 & 31u)));
                                    let _e2577 = ((_e2535 + select(0i, 1i, (_e2534 == 0i))) - bitcast<i32>(_e2572));
                                    if (_e2577 >= 255i) {
                                        phi_5319_ = bitcast<f32>((_e2556 | 2139095040u));
                                        phi_5320_ = f32();
                                        phi_5321_ = true;
                                    } else {
                                        let _e2579 = (_e2577 > 0i);
                                        if _e2579 {
                                            phi_5313_ = bitcast<f32>(((_e2556 | (bitcast<u32>(_e2577) << bitcast<u32>(23i))) | (_e2575 & 8388607u)));
                                            phi_5314_ = f32();
                                        } else {
                                            if (_e2577 < -24i) {
                                                phi_5279_ = 26u;
                                            } else {
                                                phi_5279_ = bitcast<u32>((1i - _e2577));
                                            }
                                            let _e2584 = phi_5279_;
                                            let _e2585 = (_e2584 & 31u);
                                            let _e2587 = (_e2575 >> bitcast<u32>(_e2585));
                                            let _e2591 = (_e2575 & ((1u << bitcast<u32>(_e2585)) - 1u));
                                            let _e2595 = (1u << bitcast<u32>(((_e2584 - 1u) & 31u)));
                                            if (_e2591 > _e2595) {
                                                phi_5300_ = true;
                                            } else {
                                                if (_e2591 == _e2595) {
                                                    phi_5297_ = ((_e2587 & 1u) == 1u);
                                                } else {
                                                    phi_5297_ = false;
                                                }
                                                let _e2601 = phi_5297_;
                                                phi_5300_ = _e2601;
                                            }
                                            let _e2603 = phi_5300_;
                                            phi_5313_ = f32();
                                            phi_5314_ = bitcast<f32>((_e2556 | (_e2587 + select(0u, 1u, _e2603))));
                                        }
                                        let _e2616 = phi_5313_;
                                        let _e2618 = phi_5314_;
                                        phi_5319_ = _e2616;
                                        phi_5320_ = _e2618;
                                        phi_5321_ = _e2579;
                                    }
                                    let _e2622 = phi_5319_;
                                    let _e2624 = phi_5320_;
                                    let _e2626 = phi_5321_;
                                    phi_5329_ = select(_e2624, _e2622, _e2626);
                                }
                                let _e2630 = phi_5329_;
                                phi_4818_ = _e2630;
                            } else {
                                phi_4818_ = _e2553;
                            }
                            let _e2632 = phi_4818_;
                            phi_4819_ = _e2632;
                        }
                        let _e2634 = phi_4819_;
                        let _e2635 = bitcast<u32>(_e2634);
                        if ((_e2635 & 2147483647u) >= 2139095040u) {
                            phi_4831_ = bitcast<f32>(((_e2635 & 2147483648u) | 2139095039u));
                        } else {
                            phi_4831_ = _e2634;
                        }
                        let _e2642 = phi_4831_;
                        phi_4836_ = type_21(_e2642, _e2525.member.member_1, _e2525.member.member_2, _e2525.member.member_3);
                    } else {
                        phi_4836_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2647 = phi_4836_;
                    if _e307 {
                    } else {
                        break;
                    }
                    global_7.member[_e153] = _e2647;
                    if _e168 {
                    } else {
                        break;
                    }
                    let _e2651 = select(0u, 1u, (_e374 <= _e384));
                    if (_e2651 > 0u) {
                        let _e2653 = (1u < _e121);
                        if _e2653 {
                            if (0u < _e121) {
                            } else {
                                break;
                            }
                            let _e2657 = atomicAdd((&global_8.member[0u]), _e2651);
                            if ((_e2657 + _e2651) < _e2657) {
                                if _e2653 {
                                } else {
                                    break;
                                }
                                let _e2662 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                    }
                    let _e2665 = select(0u, 1u, (_e2647.member_3 != 4294967295u));
                    if (_e2665 > 0u) {
                        let _e2667 = (3u < _e121);
                        if _e2667 {
                            if (2u < _e121) {
                            } else {
                                break;
                            }
                            let _e2671 = atomicAdd((&global_8.member[2u]), _e2665);
                            if ((_e2671 + _e2665) < _e2671) {
                                if _e2667 {
                                } else {
                                    break;
                                }
                                let _e2676 = atomicAdd((&global_8.member[3u]), 1u);
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
fn trace_paths_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
