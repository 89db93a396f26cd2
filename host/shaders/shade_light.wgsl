struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_11 {
    member: vec4<u32>,
}

struct type_16 {
    member: array<array<f32, 3>>,
}

struct type_20 {
    member: array<array<u32, 3>>,
}

struct type_31 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_33 {
    member: array<type_31>,
}

struct type_35 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_36 {
    member: type_35,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_38 {
    member: array<type_36>,
}

struct type_43 {
    member: array<vec4<u32>, 5>,
}

struct type_45 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: f32,
    member_3: f32,
    member_4: array<u32, 2>,
}

struct type_47 {
    member: array<type_45>,
}

struct type_49 {
    member: type_35,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_51 {
    member: array<type_49>,
}

struct type_53 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: f32,
    member_4: array<f32, 3>,
    member_5: u32,
    member_6: array<f32, 3>,
    member_7: u32,
    member_8: array<f32, 3>,
    member_9: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_11;
@group(0) @binding(1) 
var<uniform> global_2: type_43;
@group(0) @binding(2) 
var<uniform> global_3: type_11;
@group(0) @binding(3) 
var<storage> global_4: type_16;
@group(0) @binding(4) 
var<storage> global_5: type_20;
@group(0) @binding(5) 
var<storage> global_6: type_16;
@group(0) @binding(6) 
var<storage> global_7: type_4;
@group(0) @binding(7) 
var<storage> global_8: type_47;
@group(0) @binding(8) 
var<storage> global_9: type_33;
@group(0) @binding(9) 
var<storage> global_10: type_38;
@group(0) @binding(10) 
var<storage, read_write> global_11: type_51;
var<private> global_12: vec3<f32> = vec3<f32>(0f, 0f, 0f);

fn function_() {
    var local: type_53;
    var local_1: type_53;
    var phi_300_: i32;
    var phi_324_: array<u32, 3>;
    var phi_339_: array<f32, 3>;
    var phi_357_: array<f32, 3>;
    var phi_375_: array<f32, 3>;
    var phi_750_: array<u32, 3>;
    var phi_767_: vec3<f32>;
    var phi_784_: vec3<f32>;
    var phi_801_: vec3<f32>;
    var phi_935_: i32;
    var phi_966_: i32;
    var phi_985_: vec3<f32>;
    var phi_1068_: i32;
    var phi_1099_: i32;
    var phi_1118_: vec3<f32>;
    var phi_1160_: u32;
    var phi_1295_: i32;
    var phi_1637_: type_7;
    var phi_1638_: type_7;
    var phi_1661_: type_7;
    var phi_4959_: bool;
    var phi_1910_: type_7;
    var phi_1913_: u32;
    var phi_1915_: u32;
    var phi_1911_: type_7;
    var phi_1938_: type_7;
    var phi_1954_: u32;
    var phi_1914_: u32;
    var phi_1916_: u32;
    var local_2: u32;
    var phi_1989_: i32;
    var phi_1996_: i32;
    var phi_3292_: f32;
    var phi_3305_: f32;
    var phi_2231_: array<f32, 2>;
    var phi_2260_: type_53;
    var phi_3369_: vec3<f32>;
    var phi_3575_: bool;
    var phi_3578_: bool;
    var phi_3579_: bool;
    var phi_3664_: f32;
    var phi_3668_: f32;
    var phi_3671_: f32;
    var phi_3686_: f32;
    var phi_3690_: f32;
    var phi_3692_: f32;
    var phi_3713_: f32;
    var phi_3717_: f32;
    var phi_3720_: f32;
    var phi_3735_: f32;
    var phi_3739_: f32;
    var phi_3741_: f32;
    var phi_3762_: f32;
    var phi_3766_: f32;
    var phi_3769_: f32;
    var phi_3784_: f32;
    var phi_3788_: f32;
    var phi_3790_: f32;
    var phi_3811_: vec3<f32>;
    var phi_3845_: bool;
    var phi_3851_: f32;
    var phi_3887_: f32;
    var phi_3932_: type_49;
    var phi_3935_: type_49;
    var phi_3936_: bool;
    var phi_3938_: type_49;
    var phi_3939_: bool;
    var phi_3943_: type_49;
    var phi_3945_: type_49;
    var phi_3949_: type_49;
    var phi_3950_: bool;
    var phi_3954_: type_49;
    var phi_4256_: vec3<f32>;
    var phi_4462_: bool;
    var phi_4465_: bool;
    var phi_4466_: bool;
    var phi_4551_: f32;
    var phi_4555_: f32;
    var phi_4558_: f32;
    var phi_4573_: f32;
    var phi_4577_: f32;
    var phi_4579_: f32;
    var phi_4600_: f32;
    var phi_4604_: f32;
    var phi_4607_: f32;
    var phi_4622_: f32;
    var phi_4626_: f32;
    var phi_4628_: f32;
    var phi_4649_: f32;
    var phi_4653_: f32;
    var phi_4656_: f32;
    var phi_4671_: f32;
    var phi_4675_: f32;
    var phi_4677_: f32;
    var phi_4698_: vec3<f32>;
    var phi_4732_: bool;
    var phi_4738_: f32;
    var phi_4774_: f32;
    var phi_4819_: type_49;
    var phi_4822_: type_49;
    var phi_4823_: bool;
    var phi_4825_: type_49;
    var phi_4826_: bool;
    var phi_4830_: type_49;
    var phi_4832_: type_49;
    var phi_4836_: type_49;
    var phi_4837_: bool;
    var phi_4841_: type_49;
    var phi_4032_: f32;
    var phi_4036_: f32;
    var phi_4039_: f32;
    var phi_4054_: f32;
    var phi_4058_: f32;
    var phi_4060_: f32;
    var phi_4081_: f32;
    var phi_4085_: f32;
    var phi_4088_: f32;
    var phi_4103_: f32;
    var phi_4107_: f32;
    var phi_4109_: f32;
    var phi_4130_: f32;
    var phi_4134_: f32;
    var phi_4137_: f32;
    var phi_4152_: f32;
    var phi_4156_: f32;
    var phi_4158_: f32;
    var phi_4179_: vec3<f32>;
    var phi_4193_: type_49;
    var phi_2302_: type_49;
    var phi_2303_: type_49;
    var phi_2304_: type_49;
    var phi_2305_: type_49;

    switch bitcast<i32>(0u) {
        default: {
            let _e90 = global;
            let _e93 = arrayLength((&global_4.member));
            let _e98 = arrayLength((&global_6.member));
            let _e102 = arrayLength((&global_8.member));
            let _e112 = (_e90.x + (_e90.y * 2097152u));
            let _e113 = (_e112 < arrayLength((&global_10.member)));
            if _e113 {
                let _e114 = (_e112 < arrayLength((&global_9.member)));
                if _e114 {
                    let _e115 = (_e112 < arrayLength((&global_11.member)));
                    if _e115 {
                        if _e113 {
                        } else {
                            break;
                        }
                        let _e118 = global_10.member[_e112];
                        if _e114 {
                        } else {
                            break;
                        }
                        let _e121 = global_9.member[_e112];
                        if (_e118.member.member_1 <= _e118.member.member_3) {
                            if (_e121.member_3 != 4294967295u) {
                                if (_e102 == 0u) {
                                    phi_2303_ = type_49(type_35(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                                } else {
                                    let _e132 = global_1.member[0u];
                                    let _e133 = bitcast<i32>(_e132);
                                    let _e134 = (_e133 < -126i);
                                    if _e134 {
                                        phi_300_ = -126i;
                                    } else {
                                        phi_300_ = select(_e133, 127i, (_e133 > 127i));
                                    }
                                    let _e138 = phi_300_;
                                    let _e143 = bitcast<f32>((bitcast<u32>((_e138 + 127i)) << bitcast<u32>(23i)));
                                    let _e149 = bitcast<f32>((bitcast<u32>(((_e133 - _e138) + 127i)) << bitcast<u32>(23i)));
                                    let _e150 = (_e121.member_3 < arrayLength((&global_5.member)));
                                    if _e150 {
                                        if _e150 {
                                        } else {
                                            break;
                                        }
                                        let _e152 = global_5.member[_e121.member_3];
                                        phi_324_ = _e152;
                                    } else {
                                        phi_324_ = array<u32, 3>(0u, 0u, 0u);
                                    }
                                    let _e154 = phi_324_;
                                    let _e156 = (_e154[0] < _e93);
                                    if _e156 {
                                        if _e156 {
                                        } else {
                                            break;
                                        }
                                        let _e158 = global_4.member[_e154[0]];
                                        phi_339_ = _e158;
                                    } else {
                                        phi_339_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e160 = phi_339_;
                                    let _e165 = (_e154[1] < _e93);
                                    if _e165 {
                                        if _e165 {
                                        } else {
                                            break;
                                        }
                                        let _e167 = global_4.member[_e154[1]];
                                        phi_357_ = _e167;
                                    } else {
                                        phi_357_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e169 = phi_357_;
                                    let _e174 = (_e154[2] < _e93);
                                    if _e174 {
                                        if _e174 {
                                        } else {
                                            break;
                                        }
                                        let _e176 = global_4.member[_e154[2]];
                                        phi_375_ = _e176;
                                    } else {
                                        phi_375_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e178 = phi_375_;
                                    let _e182 = bitcast<u32>(_e160[0]);
                                    let _e184 = ((_e182 & 2139095040u) != 0u);
                                    let _e198 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e182 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e182 & 2147483648u))), _e160[0], _e184) * _e143) * select(0.00000011920929f, 1f, _e184)) * _e149);
                                    let _e203 = select(_e198, 0f, (bitcast<f32>((bitcast<u32>(_e198) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
                                    let _e204 = bitcast<u32>(_e160[1]);
                                    let _e206 = ((_e204 & 2139095040u) != 0u);
                                    let _e220 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e204 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e204 & 2147483648u))), _e160[1], _e206) * _e143) * select(0.00000011920929f, 1f, _e206)) * _e149);
                                    let _e225 = select(_e220, 0f, (bitcast<f32>((bitcast<u32>(_e220) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
                                    let _e226 = bitcast<u32>(_e160[2]);
                                    let _e228 = ((_e226 & 2139095040u) != 0u);
                                    let _e242 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e226 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e226 & 2147483648u))), _e160[2], _e228) * _e143) * select(0.00000011920929f, 1f, _e228)) * _e149);
                                    let _e247 = select(_e242, 0f, (bitcast<f32>((bitcast<u32>(_e242) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
                                    let _e248 = bitcast<u32>(_e169[0]);
                                    let _e250 = ((_e248 & 2139095040u) != 0u);
                                    let _e264 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e248 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e248 & 2147483648u))), _e169[0], _e250) * _e143) * select(0.00000011920929f, 1f, _e250)) * _e149);
                                    let _e269 = select(_e264, 0f, (bitcast<f32>((bitcast<u32>(_e264) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
                                    let _e270 = bitcast<u32>(_e169[1]);
                                    let _e272 = ((_e270 & 2139095040u) != 0u);
                                    let _e286 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e270 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e270 & 2147483648u))), _e169[1], _e272) * _e143) * select(0.00000011920929f, 1f, _e272)) * _e149);
                                    let _e291 = select(_e286, 0f, (bitcast<f32>((bitcast<u32>(_e286) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
                                    let _e292 = bitcast<u32>(_e169[2]);
                                    let _e294 = ((_e292 & 2139095040u) != 0u);
                                    let _e308 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e292 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e292 & 2147483648u))), _e169[2], _e294) * _e143) * select(0.00000011920929f, 1f, _e294)) * _e149);
                                    let _e313 = select(_e308, 0f, (bitcast<f32>((bitcast<u32>(_e308) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
                                    let _e314 = bitcast<u32>(_e178[0]);
                                    let _e316 = ((_e314 & 2139095040u) != 0u);
                                    let _e330 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e314 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e314 & 2147483648u))), _e178[0], _e316) * _e143) * select(0.00000011920929f, 1f, _e316)) * _e149);
                                    let _e335 = select(_e330, 0f, (bitcast<f32>((bitcast<u32>(_e330) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
                                    let _e336 = bitcast<u32>(_e178[1]);
                                    let _e338 = ((_e336 & 2139095040u) != 0u);
                                    let _e352 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e336 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e336 & 2147483648u))), _e178[1], _e338) * _e143) * select(0.00000011920929f, 1f, _e338)) * _e149);
                                    let _e357 = select(_e352, 0f, (bitcast<f32>((bitcast<u32>(_e352) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
                                    let _e358 = bitcast<u32>(_e178[2]);
                                    let _e360 = ((_e358 & 2139095040u) != 0u);
                                    let _e374 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e358 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e358 & 2147483648u))), _e178[2], _e360) * _e143) * select(0.00000011920929f, 1f, _e360)) * _e149);
                                    let _e379 = select(_e374, 0f, (bitcast<f32>((bitcast<u32>(_e374) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
                                    let _e380 = vec3<f32>(_e203, _e225, _e247);
                                    if _e150 {
                                        if _e150 {
                                        } else {
                                            break;
                                        }
                                        let _e382 = global_5.member[_e121.member_3];
                                        phi_750_ = _e382;
                                    } else {
                                        phi_750_ = array<u32, 3>(0u, 0u, 0u);
                                    }
                                    let _e384 = phi_750_;
                                    let _e386 = (_e384[0] < _e98);
                                    if _e386 {
                                        if _e386 {
                                        } else {
                                            break;
                                        }
                                        let _e389 = global_6.member[_e384[0]];
                                        phi_767_ = vec3<f32>(_e389[0], _e389[1], _e389[2]);
                                    } else {
                                        phi_767_ = vec3<f32>(0f, 0f, 0f);
                                    }
                                    let _e395 = phi_767_;
                                    let _e397 = (_e384[1] < _e98);
                                    if _e397 {
                                        if _e397 {
                                        } else {
                                            break;
                                        }
                                        let _e400 = global_6.member[_e384[1]];
                                        phi_784_ = vec3<f32>(_e400[0], _e400[1], _e400[2]);
                                    } else {
                                        phi_784_ = vec3<f32>(0f, 0f, 0f);
                                    }
                                    let _e406 = phi_784_;
                                    let _e408 = (_e384[2] < _e98);
                                    if _e408 {
                                        if _e408 {
                                        } else {
                                            break;
                                        }
                                        let _e411 = global_6.member[_e384[2]];
                                        phi_801_ = vec3<f32>(_e411[0], _e411[1], _e411[2]);
                                    } else {
                                        phi_801_ = vec3<f32>(0f, 0f, 0f);
                                    }
                                    let _e417 = phi_801_;
                                    let _e426 = ((1f - _e121.member_1) - _e121.member_2);
                                    let _e428 = select(0f, _e426, (_e426 > 0f));
                                    let _e430 = select(1f, _e121.member_1, (_e121.member_1 < 1f));
                                    let _e432 = select(1f, _e121.member_2, (_e121.member_2 < 1f));
                                    let _e433 = (_e203 * _e428);
                                    let _e434 = (_e225 * _e428);
                                    let _e435 = (_e247 * _e428);
                                    let _e436 = (_e269 * _e430);
                                    let _e437 = (_e291 * _e430);
                                    let _e438 = (_e313 * _e430);
                                    let _e439 = (_e335 * _e432);
                                    let _e440 = (_e357 * _e432);
                                    let _e441 = (_e379 * _e432);
                                    let _e445 = ((_e433 + _e436) + _e439);
                                    let _e446 = ((_e434 + _e437) + _e440);
                                    let _e447 = ((_e435 + _e438) + _e441);
                                    let _e481 = (((bitcast<f32>((bitcast<u32>(_e433) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e436) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e439) & 2147483647u))) * 0.00000071525625f);
                                    let _e482 = (((bitcast<f32>((bitcast<u32>(_e434) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e437) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e440) & 2147483647u))) * 0.00000071525625f);
                                    let _e483 = (((bitcast<f32>((bitcast<u32>(_e435) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e438) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e441) & 2147483647u))) * 0.00000071525625f);
                                    let _e484 = (_e269 - _e203);
                                    let _e485 = (_e291 - _e225);
                                    let _e486 = (_e313 - _e247);
                                    let _e487 = (_e335 - _e203);
                                    let _e488 = (_e357 - _e225);
                                    let _e489 = (_e379 - _e247);
                                    let _e490 = (_e485 * _e489);
                                    let _e492 = (_e490 - (_e488 * _e486));
                                    let _e493 = (_e486 * _e487);
                                    let _e495 = (_e493 - (_e489 * _e484));
                                    let _e496 = (_e484 * _e488);
                                    let _e498 = (_e496 - (_e487 * _e485));
                                    let _e501 = bitcast<f32>((bitcast<u32>(_e492) & 2147483647u));
                                    let _e504 = bitcast<f32>((bitcast<u32>(_e495) & 2147483647u));
                                    let _e506 = select(_e504, _e501, (_e501 > _e504));
                                    let _e509 = bitcast<f32>((bitcast<u32>(_e498) & 2147483647u));
                                    let _e511 = select(_e509, _e506, (_e506 > _e509));
                                    if (_e511 < 0.000000000000000000000000000000000000011754944f) {
                                        phi_985_ = vec3<f32>(0f, 0f, 0f);
                                    } else {
                                        let _e514 = (bitcast<u32>(_e511) & 2147483647u);
                                        let _e515 = (_e514 >= 8388608u);
                                        if _e515 {
                                            phi_935_ = (bitcast<i32>((_e514 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_935_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e514)), 32u, (_e514 == 0u))));
                                        }
                                        let _e528 = phi_935_;
                                        let _e535 = bitcast<f32>((bitcast<u32>(((_e528 / -2i) + 127i)) << bitcast<u32>(23i)));
                                        if _e515 {
                                            phi_966_ = (bitcast<i32>((_e514 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_966_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e514)), 32u, (_e514 == 0u))));
                                        }
                                        let _e551 = phi_966_;
                                        let _e557 = bitcast<f32>((bitcast<u32>((((_e528 / 2i) - _e551) + 127i)) << bitcast<u32>(23i)));
                                        let _e558 = ((_e492 * _e535) * _e557);
                                        let _e559 = ((_e495 * _e535) * _e557);
                                        let _e560 = ((_e498 * _e535) * _e557);
                                        let _e566 = sqrt((((_e558 * _e558) + (_e559 * _e559)) + (_e560 * _e560)));
                                        phi_985_ = vec3<f32>((_e558 / _e566), (_e559 / _e566), (_e560 / _e566));
                                    }
                                    let _e572 = phi_985_;
                                    let _e582 = select(1f, -1f, ((((_e572.x * _e118.member.member_2[0]) + (_e572.y * _e118.member.member_2[1])) + (_e572.z * _e118.member.member_2[2])) > 0f));
                                    let _e586 = (_e572 * _e582);
                                    let _e608 = (((_e395.x * _e428) + (_e406.x * _e430)) + (_e417.x * _e432));
                                    let _e609 = (((_e395.y * _e428) + (_e406.y * _e430)) + (_e417.y * _e432));
                                    let _e610 = (((_e395.z * _e428) + (_e406.z * _e430)) + (_e417.z * _e432));
                                    let _e613 = bitcast<f32>((bitcast<u32>(_e608) & 2147483647u));
                                    let _e616 = bitcast<f32>((bitcast<u32>(_e609) & 2147483647u));
                                    let _e618 = select(_e616, _e613, (_e613 > _e616));
                                    let _e621 = bitcast<f32>((bitcast<u32>(_e610) & 2147483647u));
                                    let _e623 = select(_e621, _e618, (_e618 > _e621));
                                    if (_e623 < 0.000000000000000000000000000000000000011754944f) {
                                        phi_1118_ = vec3<f32>(0f, 0f, 0f);
                                    } else {
                                        let _e626 = (bitcast<u32>(_e623) & 2147483647u);
                                        let _e627 = (_e626 >= 8388608u);
                                        if _e627 {
                                            phi_1068_ = (bitcast<i32>((_e626 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_1068_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e626)), 32u, (_e626 == 0u))));
                                        }
                                        let _e640 = phi_1068_;
                                        let _e647 = bitcast<f32>((bitcast<u32>(((_e640 / -2i) + 127i)) << bitcast<u32>(23i)));
                                        if _e627 {
                                            phi_1099_ = (bitcast<i32>((_e626 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_1099_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e626)), 32u, (_e626 == 0u))));
                                        }
                                        let _e663 = phi_1099_;
                                        let _e669 = bitcast<f32>((bitcast<u32>((((_e640 / 2i) - _e663) + 127i)) << bitcast<u32>(23i)));
                                        let _e670 = ((_e608 * _e647) * _e669);
                                        let _e671 = ((_e609 * _e647) * _e669);
                                        let _e672 = ((_e610 * _e647) * _e669);
                                        let _e678 = sqrt((((_e670 * _e670) + (_e671 * _e671)) + (_e672 * _e672)));
                                        phi_1118_ = vec3<f32>((_e670 / _e678), (_e671 / _e678), (_e672 / _e678));
                                    }
                                    let _e684 = phi_1118_;
                                    let _e699 = select(_e586, (_e684 * _e582), vec3((((((_e684.x * _e582) * (_e572.x * _e582)) + ((_e684.y * _e582) * (_e572.y * _e582))) + ((_e684.z * _e582) * (_e572.z * _e582))) > 0f)));
                                    let _e700 = (_e121.member_3 < arrayLength((&global_7.member)));
                                    if _e700 {
                                        if _e700 {
                                        } else {
                                            break;
                                        }
                                        let _e703 = global_7.member[_e121.member_3];
                                        phi_1160_ = _e703;
                                    } else {
                                        phi_1160_ = 0u;
                                    }
                                    let _e705 = phi_1160_;
                                    let _e707 = select(_e705, 0u, (_e705 >= _e102));
                                    if (_e707 < _e102) {
                                    } else {
                                        break;
                                    }
                                    let _e711 = global_8.member[_e707];
                                    let _e718 = global_3.member[0u];
                                    let _e721 = global_3.member[1u];
                                    let _e724 = global_2.member[0u];
                                    let _e734 = global_2.member[0u][3u];
                                    let _e737 = global_2.member[1u];
                                    let _e747 = global_2.member[1u][3u];
                                    let _e751 = global_2.member[2u];
                                    let _e761 = global_2.member[2u][3u];
                                    let _e764 = global_2.member[3u];
                                    let _e774 = global_2.member[3u][3u];
                                    let _e777 = global_2.member[4u];
                                    let _e787 = global_2.member[4u][3u];
                                    local_1 = type_53(array<f32, 3>(bitcast<f32>(_e724.x), bitcast<f32>(_e724.y), bitcast<f32>(_e724.z)), _e734, array<f32, 3>(bitcast<f32>(_e737.x), bitcast<f32>(_e737.y), bitcast<f32>(_e737.z)), bitcast<f32>(_e747), array<f32, 3>(bitcast<f32>(_e751.x), bitcast<f32>(_e751.y), bitcast<f32>(_e751.z)), _e761, array<f32, 3>(bitcast<f32>(_e764.x), bitcast<f32>(_e764.y), bitcast<f32>(_e764.z)), _e774, array<f32, 3>(bitcast<f32>(_e777.x), bitcast<f32>(_e777.y), bitcast<f32>(_e777.z)), _e787);
                                    if _e134 {
                                        phi_1295_ = -126i;
                                    } else {
                                        phi_1295_ = select(_e133, 127i, (_e133 > 127i));
                                    }
                                    let _e797 = phi_1295_;
                                    let _e802 = bitcast<f32>((bitcast<u32>((_e797 + 127i)) << bitcast<u32>(23i)));
                                    let _e808 = bitcast<f32>((bitcast<u32>(((_e133 - _e797) + 127i)) << bitcast<u32>(23i)));
                                    let _e809 = local_1;
                                    local = _e809;
                                    let _e811 = local_1.member_1;
                                    if (_e811 == 1u) {
                                        let _e814 = local_1.member;
                                        let _e818 = bitcast<u32>(_e814[0]);
                                        let _e820 = ((_e818 & 2139095040u) != 0u);
                                        let _e835 = bitcast<u32>(_e814[1]);
                                        let _e837 = ((_e835 & 2139095040u) != 0u);
                                        let _e852 = bitcast<u32>(_e814[2]);
                                        let _e854 = ((_e852 & 2139095040u) != 0u);
                                        local.member = array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e818 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e818 & 2147483648u))), _e814[0], _e820) * _e802) * select(0.00000011920929f, 1f, _e820)) * _e808), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e835 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e835 & 2147483648u))), _e814[1], _e837) * _e802) * select(0.00000011920929f, 1f, _e837)) * _e808), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e852 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e852 & 2147483648u))), _e814[2], _e854) * _e802) * select(0.00000011920929f, 1f, _e854)) * _e808));
                                        let _e872 = local_1.member_4;
                                        let _e876 = bitcast<u32>(_e872[0]);
                                        let _e878 = ((_e876 & 2139095040u) != 0u);
                                        let _e893 = bitcast<u32>(_e872[1]);
                                        let _e895 = ((_e893 & 2139095040u) != 0u);
                                        let _e910 = bitcast<u32>(_e872[2]);
                                        let _e912 = ((_e910 & 2139095040u) != 0u);
                                        local.member_4 = array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e876 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e876 & 2147483648u))), _e872[0], _e878) * _e802) * select(0.00000011920929f, 1f, _e878)) * _e808), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e893 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e893 & 2147483648u))), _e872[1], _e895) * _e802) * select(0.00000011920929f, 1f, _e895)) * _e808), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e910 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e910 & 2147483648u))), _e872[2], _e912) * _e802) * select(0.00000011920929f, 1f, _e912)) * _e808));
                                        let _e930 = local_1.member_6;
                                        let _e934 = bitcast<u32>(_e930[0]);
                                        let _e936 = ((_e934 & 2139095040u) != 0u);
                                        let _e951 = bitcast<u32>(_e930[1]);
                                        let _e953 = ((_e951 & 2139095040u) != 0u);
                                        let _e968 = bitcast<u32>(_e930[2]);
                                        let _e970 = ((_e968 & 2139095040u) != 0u);
                                        local.member_6 = array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e934 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e934 & 2147483648u))), _e930[0], _e936) * _e802) * select(0.00000011920929f, 1f, _e936)) * _e808), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e951 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e951 & 2147483648u))), _e930[1], _e953) * _e802) * select(0.00000011920929f, 1f, _e953)) * _e808), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e968 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e968 & 2147483648u))), _e930[2], _e970) * _e802) * select(0.00000011920929f, 1f, _e970)) * _e808));
                                        phi_1637_ = type_7(0u, 3u);
                                        loop {
                                            let _e988 = phi_1637_;
                                            if (_e988.member < _e988.member_1) {
                                                phi_1638_ = type_7((_e988.member + 1u), _e988.member_1);
                                                phi_1661_ = type_7(1u, _e988.member);
                                            } else {
                                                phi_1638_ = _e988;
                                                phi_1661_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e1001 = phi_1638_;
                                            let _e1003 = phi_1661_;
                                            let _e1007 = (bitcast<i32>(_e1003.member) != 0i);
                                            if _e1007 {
                                                let _e1008 = (_e1003.member_1 < 3u);
                                                if _e1008 {
                                                } else {
                                                    phi_4959_ = true;
                                                    break;
                                                }
                                                let _e1011 = local_1.member_2[_e1003.member_1];
                                                let _e1012 = bitcast<u32>(_e1011);
                                                let _e1014 = ((_e1012 & 2139095040u) != 0u);
                                                let _e1028 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1012 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1012 & 2147483648u))), _e1011, _e1014) * _e802) * select(0.00000011920929f, 1f, _e1014)) * _e808);
                                                let _e1029 = bitcast<u32>(_e1028);
                                                let _e1031 = ((_e1029 & 2139095040u) != 0u);
                                                let _e1045 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1029 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1029 & 2147483648u))), _e1028, _e1031) * _e802) * select(0.00000011920929f, 1f, _e1031)) * _e808);
                                                if _e1008 {
                                                } else {
                                                    phi_4959_ = true;
                                                    break;
                                                }
                                                local.member_2[_e1003.member_1] = select(340282350000000000000000000000000000000f, _e1045, (_e1045 < 340282350000000000000000000000000000000f));
                                            }
                                            continue;
                                            continuing {
                                                phi_1637_ = _e1001;
                                                phi_4959_ = false;
                                                break if !(_e1007);
                                            }
                                        }
                                        let _e1052 = phi_4959_;
                                        if _e1052 {
                                            break;
                                        }
                                        let _e1054 = local_1.member_3;
                                        if (_e1054 < 340282350000000000000000000000000000000f) {
                                            let _e1056 = local_1.member_3;
                                            let _e1057 = bitcast<u32>(_e1056);
                                            let _e1059 = ((_e1057 & 2139095040u) != 0u);
                                            let _e1073 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1057 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1057 & 2147483648u))), _e1056, _e1059) * _e802) * select(0.00000011920929f, 1f, _e1059)) * _e808);
                                            local.member_3 = select(340282350000000000000000000000000000000f, _e1073, (_e1073 < 340282350000000000000000000000000000000f));
                                        }
                                    }
                                    let _e1077 = local;
                                    let _e1108 = type_53(array<f32, 3>(_e1077.member[0], _e1077.member[1], _e1077.member[2]), _e1077.member_1, array<f32, 3>(_e1077.member_2[0], _e1077.member_2[1], _e1077.member_2[2]), _e1077.member_3, array<f32, 3>(_e1077.member_4[0], _e1077.member_4[1], _e1077.member_4[2]), _e1077.member_5, array<f32, 3>(_e1077.member_6[0], _e1077.member_6[1], _e1077.member_6[2]), _e1077.member_7, array<f32, 3>(_e1077.member_8[0], _e1077.member_8[1], _e1077.member_8[2]), _e1077.member_9);
                                    if (_e1077.member_5 != 0u) {
                                        let _e1112 = select(1u, _e718, (1u < _e718));
                                        let _e1113 = (_e1112 == 0u);
                                        if _e1113 {
                                            break;
                                        }
                                        let _e1114 = (_e118.member_4 / _e1112);
                                        if _e1113 {
                                            break;
                                        }
                                        let _e1119 = ((_e1114 ^ (_e1114 >> bitcast<u32>(16i))) * 569420461u);
                                        let _e1123 = ((_e1119 ^ (_e1119 >> bitcast<u32>(15i))) * 3545902487u);
                                        let _e1127 = ((_e1123 ^ (_e1123 >> bitcast<u32>(15i))) + _e721);
                                        let _e1131 = ((_e1127 ^ (_e1127 >> bitcast<u32>(16i))) * 569420461u);
                                        let _e1135 = ((_e1131 ^ (_e1131 >> bitcast<u32>(15i))) * 3545902487u);
                                        let _e1139 = ((_e1135 ^ (_e1135 >> bitcast<u32>(15i))) + (_e1077.member_7 + 1u));
                                        let _e1143 = ((_e1139 ^ (_e1139 >> bitcast<u32>(16i))) * 569420461u);
                                        let _e1147 = ((_e1143 ^ (_e1143 >> bitcast<u32>(15i))) * 3545902487u);
                                        let _e1150 = (_e1147 ^ (_e1147 >> bitcast<u32>(15i)));
                                        let _e1152 = (reverseBits((_e118.member_4 % _e1112)) + _e1150);
                                        let _e1154 = (_e1152 ^ (_e1152 * 1817228412u));
                                        let _e1156 = (_e1154 ^ (_e1154 * 3090095698u));
                                        let _e1158 = (_e1156 ^ (_e1156 * 3350193720u));
                                        let _e1161 = reverseBits((_e1158 ^ (_e1158 * 2367878886u)));
                                        let _e1163 = (_e1150 ^ 1u);
                                        let _e1167 = ((_e1163 ^ (_e1163 >> bitcast<u32>(16i))) * 569420461u);
                                        let _e1171 = ((_e1167 ^ (_e1167 >> bitcast<u32>(15i))) * 3545902487u);
                                        let _e1176 = (reverseBits(reverseBits(_e1161)) + (_e1171 ^ (_e1171 >> bitcast<u32>(15i))));
                                        let _e1178 = (_e1176 ^ (_e1176 * 1817228412u));
                                        let _e1180 = (_e1178 ^ (_e1178 * 3090095698u));
                                        let _e1182 = (_e1180 ^ (_e1180 * 3350193720u));
                                        let _e1185 = reverseBits((_e1182 ^ (_e1182 * 2367878886u)));
                                        phi_1910_ = type_7(0u, 32u);
                                        phi_1913_ = 2147483648u;
                                        phi_1915_ = 0u;
                                        loop {
                                            let _e1187 = phi_1910_;
                                            let _e1189 = phi_1913_;
                                            let _e1191 = phi_1915_;
                                            local_2 = _e1191;
                                            if (_e1187.member < _e1187.member_1) {
                                                phi_1911_ = type_7((_e1187.member + 1u), _e1187.member_1);
                                                phi_1938_ = type_7(1u, _e1187.member);
                                            } else {
                                                phi_1911_ = _e1187;
                                                phi_1938_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e1204 = phi_1911_;
                                            let _e1206 = phi_1938_;
                                            let _e1210 = (bitcast<i32>(_e1206.member) != 0i);
                                            if _e1210 {
                                                if (((_e1161 >> bitcast<u32>((_e1206.member_1 & 31u))) & 1u) == 1u) {
                                                    phi_1954_ = (_e1191 ^ _e1189);
                                                } else {
                                                    phi_1954_ = _e1191;
                                                }
                                                let _e1218 = phi_1954_;
                                                phi_1914_ = (_e1189 ^ (_e1189 >> bitcast<u32>(1i)));
                                                phi_1916_ = _e1218;
                                            } else {
                                                phi_1914_ = u32();
                                                phi_1916_ = u32();
                                            }
                                            let _e1223 = phi_1914_;
                                            let _e1225 = phi_1916_;
                                            continue;
                                            continuing {
                                                phi_1910_ = _e1204;
                                                phi_1913_ = _e1223;
                                                phi_1915_ = _e1225;
                                                break if !(_e1210);
                                            }
                                        }
                                        let _e1227 = (_e1150 ^ 2u);
                                        let _e1231 = ((_e1227 ^ (_e1227 >> bitcast<u32>(16i))) * 569420461u);
                                        let _e1235 = ((_e1231 ^ (_e1231 >> bitcast<u32>(15i))) * 3545902487u);
                                        let _e1240 = local_2;
                                        let _e1242 = (reverseBits(_e1240) + (_e1235 ^ (_e1235 >> bitcast<u32>(15i))));
                                        let _e1244 = (_e1242 ^ (_e1242 * 1817228412u));
                                        let _e1246 = (_e1244 ^ (_e1244 * 3090095698u));
                                        let _e1248 = (_e1246 ^ (_e1246 * 3350193720u));
                                        let _e1251 = reverseBits((_e1248 ^ (_e1248 * 2367878886u)));
                                        if (_e1077.member_5 == 1u) {
                                            let _e1274 = bitcast<i32>(((2u * (_e1185 >> bitcast<u32>(16i))) + 1u));
                                            let _e1275 = (_e1274 - 65536i);
                                            let _e1280 = bitcast<i32>(((2u * (_e1251 >> bitcast<u32>(16i))) + 1u));
                                            let _e1281 = (_e1280 - 65536i);
                                            let _e1282 = (_e1275 < 0i);
                                            if _e1282 {
                                                phi_1989_ = (65536i - _e1274);
                                            } else {
                                                phi_1989_ = _e1275;
                                            }
                                            let _e1285 = phi_1989_;
                                            let _e1286 = bitcast<u32>(_e1285);
                                            let _e1287 = (_e1281 < 0i);
                                            if _e1287 {
                                                phi_1996_ = (65536i - _e1280);
                                            } else {
                                                phi_1996_ = _e1281;
                                            }
                                            let _e1290 = phi_1996_;
                                            let _e1291 = bitcast<u32>(_e1290);
                                            let _e1292 = (_e1286 > _e1291);
                                            let _e1293 = select(_e1291, _e1286, _e1292);
                                            let _e1298 = select(1u, _e1293, (1u < _e1293));
                                            if (_e1298 == 0u) {
                                                break;
                                            }
                                            let _e1302 = (((select(_e1286, _e1291, _e1292) << bitcast<u32>(16i)) / _e1298) << bitcast<u32>(15i));
                                            let _e1304 = (_e1302 >> bitcast<u32>(16i));
                                            let _e1305 = (_e1302 & 65535u);
                                            let _e1310 = ((_e1304 * _e1305) + ((_e1305 * _e1305) >> bitcast<u32>(16i)));
                                            let _e1322 = ((((_e1304 * _e1304) + (_e1310 >> bitcast<u32>(16i))) + (((_e1305 * _e1304) + (_e1310 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i));
                                            let _e1324 = (_e1322 >> bitcast<u32>(16i));
                                            let _e1325 = (_e1322 & 65535u);
                                            let _e1330 = ((_e1324 * 7711u) + ((_e1325 * 7711u) >> bitcast<u32>(16i)));
                                            let _e1339 = (700062u - (((_e1330 >> bitcast<u32>(16i)) + ((_e1330 & 65535u) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                                            let _e1341 = (_e1339 >> bitcast<u32>(16i));
                                            let _e1342 = (_e1339 & 65535u);
                                            let _e1347 = ((_e1324 * _e1342) + ((_e1325 * _e1342) >> bitcast<u32>(16i)));
                                            let _e1360 = (34046945u - ((((_e1324 * _e1341) + (_e1347 >> bitcast<u32>(16i))) + (((_e1325 * _e1341) + (_e1347 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                                            let _e1362 = (_e1360 >> bitcast<u32>(16i));
                                            let _e1363 = (_e1360 & 65535u);
                                            let _e1368 = ((_e1324 * _e1363) + ((_e1325 * _e1363) >> bitcast<u32>(16i)));
                                            let _e1381 = (662337939u - ((((_e1324 * _e1362) + (_e1368 >> bitcast<u32>(16i))) + (((_e1325 * _e1362) + (_e1368 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                                            let _e1386 = ((_e1324 * 13011u) + ((_e1325 * 13011u) >> bitcast<u32>(16i)));
                                            let _e1397 = (5348082u - (((_e1324 + (_e1386 >> bitcast<u32>(16i))) + ((_e1325 + (_e1386 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                                            let _e1399 = (_e1397 >> bitcast<u32>(16i));
                                            let _e1400 = (_e1397 & 65535u);
                                            let _e1405 = ((_e1324 * _e1400) + ((_e1325 * _e1400) >> bitcast<u32>(16i)));
                                            let _e1418 = (173399667u - ((((_e1324 * _e1399) + (_e1405 >> bitcast<u32>(16i))) + (((_e1325 * _e1399) + (_e1405 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                                            let _e1420 = (_e1418 >> bitcast<u32>(16i));
                                            let _e1421 = (_e1418 & 65535u);
                                            let _e1426 = ((_e1324 * _e1421) + ((_e1325 * _e1421) >> bitcast<u32>(16i)));
                                            let _e1439 = (1686629713u - ((((_e1324 * _e1420) + (_e1426 >> bitcast<u32>(16i))) + (((_e1325 * _e1420) + (_e1426 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                                            let _e1441 = (_e1381 >> bitcast<u32>(16i));
                                            let _e1442 = (_e1381 & 65535u);
                                            let _e1447 = ((_e1324 * _e1442) + ((_e1325 * _e1442) >> bitcast<u32>(16i)));
                                            let _e1460 = (2147483648u - ((((_e1324 * _e1441) + (_e1447 >> bitcast<u32>(16i))) + (((_e1325 * _e1441) + (_e1447 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                                            let _e1462 = (_e1439 >> bitcast<u32>(16i));
                                            let _e1463 = (_e1439 & 65535u);
                                            let _e1468 = ((_e1304 * _e1463) + ((_e1305 * _e1463) >> bitcast<u32>(16i)));
                                            let _e1480 = ((((_e1304 * _e1462) + (_e1468 >> bitcast<u32>(16i))) + (((_e1305 * _e1462) + (_e1468 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i));
                                            let _e1482 = (_e1293 << bitcast<u32>(15i));
                                            let _e1484 = (_e1482 >> bitcast<u32>(16i));
                                            let _e1485 = (_e1482 & 65535u);
                                            let _e1487 = (_e1460 >> bitcast<u32>(16i));
                                            let _e1488 = (_e1460 & 65535u);
                                            let _e1493 = ((_e1484 * _e1488) + ((_e1485 * _e1488) >> bitcast<u32>(16i)));
                                            let _e1505 = ((((_e1484 * _e1487) + (_e1493 >> bitcast<u32>(16i))) + (((_e1485 * _e1487) + (_e1493 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i));
                                            let _e1507 = (_e1480 >> bitcast<u32>(16i));
                                            let _e1508 = (_e1480 & 65535u);
                                            let _e1513 = ((_e1484 * _e1508) + ((_e1485 * _e1508) >> bitcast<u32>(16i)));
                                            let _e1525 = ((((_e1484 * _e1507) + (_e1513 >> bitcast<u32>(16i))) + (((_e1485 * _e1507) + (_e1513 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i));
                                            let _e1530 = f32((select(_e1525, _e1505, _e1292) >> bitcast<u32>(7i)));
                                            if _e1282 {
                                                phi_3292_ = (_e1530 * -0.000000059604645f);
                                            } else {
                                                phi_3292_ = (_e1530 * 0.000000059604645f);
                                            }
                                            let _e1534 = phi_3292_;
                                            let _e1537 = f32((select(_e1505, _e1525, _e1292) >> bitcast<u32>(7i)));
                                            if _e1287 {
                                                phi_3305_ = (_e1537 * -0.000000059604645f);
                                            } else {
                                                phi_3305_ = (_e1537 * 0.000000059604645f);
                                            }
                                            let _e1541 = phi_3305_;
                                            phi_2231_ = array<f32, 2>(_e1534, _e1541);
                                        } else {
                                            phi_2231_ = array<f32, 2>((f32((bitcast<i32>(((2u * (_e1185 >> bitcast<u32>(9i))) + 1u)) - 8388608i)) * 0.00000011920929f), (f32((bitcast<i32>(((2u * (_e1251 >> bitcast<u32>(9i))) + 1u)) - 8388608i)) * 0.00000011920929f));
                                        }
                                        let _e1544 = phi_2231_;
                                        phi_2260_ = type_53(array<f32, 3>((_e1077.member[0] + ((_e1077.member_4[0] * _e1544[0]) + (_e1077.member_6[0] * _e1544[1]))), (_e1077.member[1] + ((_e1077.member_4[1] * _e1544[0]) + (_e1077.member_6[1] * _e1544[1]))), (_e1077.member[2] + ((_e1077.member_4[2] * _e1544[0]) + (_e1077.member_6[2] * _e1544[1])))), _e1108.member_1, _e1108.member_2, _e1108.member_3, _e1108.member_4, _e1108.member_5, _e1108.member_6, _e1108.member_7, _e1108.member_8, _e1108.member_9);
                                    } else {
                                        phi_2260_ = _e1108;
                                    }
                                    let _e1572 = phi_2260_;
                                    let _e1581 = global_3.member[2u];
                                    if (_e1581 == 1u) {
                                        let _e1936 = (_e1572.member_1 == 1u);
                                        if _e1936 {
                                            phi_4256_ = (vec3<f32>(_e1572.member[0], _e1572.member[1], _e1572.member[2]) - _e380);
                                        } else {
                                            phi_4256_ = vec3<f32>(_e1572.member[0], _e1572.member[1], _e1572.member[2]);
                                        }
                                        let _e1947 = phi_4256_;
                                        let _e1949 = bitcast<f32>(bitcast<u32>(_e496));
                                        let _e1952 = bitcast<f32>(bitcast<u32>((_e485 * _e487)));
                                        let _e1954 = bitcast<f32>(bitcast<u32>(_e490));
                                        let _e1957 = bitcast<f32>(bitcast<u32>((_e486 * _e488)));
                                        let _e1959 = bitcast<f32>(bitcast<u32>(_e493));
                                        let _e1962 = bitcast<f32>(bitcast<u32>((_e484 * _e489)));
                                        let _e2026 = global_12[0u];
                                        if (_e1572.member_2[0] == _e2026) {
                                            let _e2029 = global_12[1u];
                                            let _e2030 = (_e1572.member_2[1] == _e2029);
                                            if _e2030 {
                                                let _e2032 = global_12[2u];
                                                phi_4462_ = (_e1572.member_2[2] == _e2032);
                                            } else {
                                                phi_4462_ = bool();
                                            }
                                            let _e2035 = phi_4462_;
                                            phi_4465_ = _e2035;
                                            phi_4466_ = select(true, false, _e2030);
                                        } else {
                                            phi_4465_ = bool();
                                            phi_4466_ = true;
                                        }
                                        let _e2038 = phi_4465_;
                                        let _e2040 = phi_4466_;
                                        if select(_e2038, false, _e2040) {
                                            phi_4836_ = type_49();
                                            phi_4837_ = true;
                                        } else {
                                            let _e2043 = ((((bitcast<f32>(bitcast<u32>((_e1947.x * (_e1954 - _e1957)))) + bitcast<f32>(bitcast<u32>((_e1947.y * (_e1959 - _e1962))))) + bitcast<f32>(bitcast<u32>((_e1947.z * (_e1949 - _e1952))))) * _e582) > (bitcast<f32>(bitcast<u32>((0.0000009536752f * ((bitcast<f32>(bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1947.x) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e1954) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1957) & 2147483647u)))))) + bitcast<f32>(bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1947.y) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e1959) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1962) & 2147483647u))))))) + bitcast<f32>(bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1947.z) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e1949) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1952) & 2147483647u)))))))))) + 0.0000000000000000000000000000000000001880791f));
                                            if _e2043 {
                                                let _e2045 = select(_e482, _e481, (_e481 > _e482));
                                                let _e2062 = (select(_e483, _e2045, (_e2045 > _e483)) * ((bitcast<f32>((bitcast<u32>(_e586.x) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e586.y) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e586.z) & 2147483647u))));
                                                let _e2066 = (_e445 + (_e586.x * _e2062));
                                                let _e2067 = (_e446 + (_e586.y * _e2062));
                                                let _e2068 = (_e447 + (_e586.z * _e2062));
                                                if (_e586.x > 0f) {
                                                    let _e2089 = bitcast<u32>(_e2066);
                                                    if ((_e2089 & 2147483647u) == 0u) {
                                                        phi_4577_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e2089 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_4573_ = bitcast<f32>((_e2089 + 1u));
                                                        } else {
                                                            phi_4573_ = bitcast<f32>((_e2089 - 1u));
                                                        }
                                                        let _e2100 = phi_4573_;
                                                        phi_4577_ = _e2100;
                                                    }
                                                    let _e2102 = phi_4577_;
                                                    phi_4579_ = _e2102;
                                                } else {
                                                    if (_e586.x < 0f) {
                                                        let _e2072 = bitcast<u32>(-(_e2066));
                                                        if ((_e2072 & 2147483647u) == 0u) {
                                                            phi_4555_ = 0.000000000000000000000000000000000000000000001f;
                                                        } else {
                                                            if ((_e2072 >> bitcast<u32>(31i)) == 0u) {
                                                                phi_4551_ = bitcast<f32>((_e2072 + 1u));
                                                            } else {
                                                                phi_4551_ = bitcast<f32>((_e2072 - 1u));
                                                            }
                                                            let _e2083 = phi_4551_;
                                                            phi_4555_ = _e2083;
                                                        }
                                                        let _e2085 = phi_4555_;
                                                        phi_4558_ = -(_e2085);
                                                    } else {
                                                        phi_4558_ = _e2066;
                                                    }
                                                    let _e2088 = phi_4558_;
                                                    phi_4579_ = _e2088;
                                                }
                                                let _e2104 = phi_4579_;
                                                if (_e586.y > 0f) {
                                                    let _e2125 = bitcast<u32>(_e2067);
                                                    if ((_e2125 & 2147483647u) == 0u) {
                                                        phi_4626_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e2125 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_4622_ = bitcast<f32>((_e2125 + 1u));
                                                        } else {
                                                            phi_4622_ = bitcast<f32>((_e2125 - 1u));
                                                        }
                                                        let _e2136 = phi_4622_;
                                                        phi_4626_ = _e2136;
                                                    }
                                                    let _e2138 = phi_4626_;
                                                    phi_4628_ = _e2138;
                                                } else {
                                                    if (_e586.y < 0f) {
                                                        let _e2108 = bitcast<u32>(-(_e2067));
                                                        if ((_e2108 & 2147483647u) == 0u) {
                                                            phi_4604_ = 0.000000000000000000000000000000000000000000001f;
                                                        } else {
                                                            if ((_e2108 >> bitcast<u32>(31i)) == 0u) {
                                                                phi_4600_ = bitcast<f32>((_e2108 + 1u));
                                                            } else {
                                                                phi_4600_ = bitcast<f32>((_e2108 - 1u));
                                                            }
                                                            let _e2119 = phi_4600_;
                                                            phi_4604_ = _e2119;
                                                        }
                                                        let _e2121 = phi_4604_;
                                                        phi_4607_ = -(_e2121);
                                                    } else {
                                                        phi_4607_ = _e2067;
                                                    }
                                                    let _e2124 = phi_4607_;
                                                    phi_4628_ = _e2124;
                                                }
                                                let _e2140 = phi_4628_;
                                                if (_e586.z > 0f) {
                                                    let _e2161 = bitcast<u32>(_e2068);
                                                    if ((_e2161 & 2147483647u) == 0u) {
                                                        phi_4675_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e2161 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_4671_ = bitcast<f32>((_e2161 + 1u));
                                                        } else {
                                                            phi_4671_ = bitcast<f32>((_e2161 - 1u));
                                                        }
                                                        let _e2172 = phi_4671_;
                                                        phi_4675_ = _e2172;
                                                    }
                                                    let _e2174 = phi_4675_;
                                                    phi_4677_ = _e2174;
                                                } else {
                                                    if (_e586.z < 0f) {
                                                        let _e2144 = bitcast<u32>(-(_e2068));
                                                        if ((_e2144 & 2147483647u) == 0u) {
                                                            phi_4653_ = 0.000000000000000000000000000000000000000000001f;
                                                        } else {
                                                            if ((_e2144 >> bitcast<u32>(31i)) == 0u) {
                                                                phi_4649_ = bitcast<f32>((_e2144 + 1u));
                                                            } else {
                                                                phi_4649_ = bitcast<f32>((_e2144 - 1u));
                                                            }
                                                            let _e2155 = phi_4649_;
                                                            phi_4653_ = _e2155;
                                                        }
                                                        let _e2157 = phi_4653_;
                                                        phi_4656_ = -(_e2157);
                                                    } else {
                                                        phi_4656_ = _e2068;
                                                    }
                                                    let _e2160 = phi_4656_;
                                                    phi_4677_ = _e2160;
                                                }
                                                let _e2176 = phi_4677_;
                                                if _e1936 {
                                                    phi_4698_ = vec3<f32>((_e1572.member[0] - _e2104), (_e1572.member[1] - _e2140), (_e1572.member[2] - _e2176));
                                                } else {
                                                    phi_4698_ = vec3<f32>(_e1572.member[0], _e1572.member[1], _e1572.member[2]);
                                                }
                                                let _e2186 = phi_4698_;
                                                let _e2199 = sqrt((((_e2186.x * _e2186.x) + (_e2186.y * _e2186.y)) + (_e2186.z * _e2186.z)));
                                                let _e2208 = ((((_e699.x * _e2186.x) + (_e699.y * _e2186.y)) + (_e699.z * _e2186.z)) / _e2199);
                                                if _e1936 {
                                                    phi_4732_ = (_e2199 <= _e1572.member_3);
                                                } else {
                                                    phi_4732_ = true;
                                                }
                                                let _e2211 = phi_4732_;
                                                if _e1936 {
                                                    phi_4738_ = (1f / (_e2199 * _e2199));
                                                } else {
                                                    phi_4738_ = 1f;
                                                }
                                                let _e2215 = phi_4738_;
                                                let _e2216 = -(_e2186.x);
                                                let _e2217 = -(_e2186.y);
                                                let _e2218 = -(_e2186.z);
                                                if (_e1572.member_5 == 0u) {
                                                    phi_4774_ = 1f;
                                                } else {
                                                    let _e2234 = ((((_e1572.member_8[0] * _e2216) + (_e1572.member_8[1] * _e2217)) + (_e1572.member_8[2] * _e2218)) / sqrt((((_e2216 * _e2216) + (_e2217 * _e2217)) + (_e2218 * _e2218))));
                                                    phi_4774_ = select(0f, _e2234, (_e2234 > 0f));
                                                }
                                                let _e2238 = phi_4774_;
                                                if (_e2208 > 0f) {
                                                    if _e2211 {
                                                        let _e2240 = (_e2238 > 0f);
                                                        if _e2240 {
                                                            let _e2247 = ((1f - select(_e711.member_1, _e711.member_2, (_e711.member_2 > 0f))) * 0.31830987f);
                                                            let _e2255 = ((_e2208 * _e2215) * _e2238);
                                                            phi_4819_ = type_49(type_35(array<f32, 3>(_e2104, _e2140, _e2176), 0f, array<f32, 3>(_e2186.x, _e2186.y, _e2186.z), select(340282350000000000000000000000000000000f, 1f, _e1936)), array<f32, 3>(((_e1572.member_2[0] * (_e711.member[0] * _e2247)) * _e2255), ((_e1572.member_2[1] * (_e711.member[1] * _e2247)) * _e2255), ((_e1572.member_2[2] * (_e711.member[2] * _e2247)) * _e2255)), _e121.member_3);
                                                        } else {
                                                            phi_4819_ = type_49();
                                                        }
                                                        let _e2262 = phi_4819_;
                                                        phi_4822_ = _e2262;
                                                        phi_4823_ = select(true, false, _e2240);
                                                    } else {
                                                        phi_4822_ = type_49();
                                                        phi_4823_ = true;
                                                    }
                                                    let _e2265 = phi_4822_;
                                                    let _e2267 = phi_4823_;
                                                    phi_4825_ = _e2265;
                                                    phi_4826_ = _e2267;
                                                } else {
                                                    phi_4825_ = type_49();
                                                    phi_4826_ = true;
                                                }
                                                let _e2269 = phi_4825_;
                                                let _e2271 = phi_4826_;
                                                if _e2271 {
                                                    phi_4830_ = type_49(type_35(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                                                } else {
                                                    phi_4830_ = _e2269;
                                                }
                                                let _e2273 = phi_4830_;
                                                phi_4832_ = _e2273;
                                            } else {
                                                phi_4832_ = type_49();
                                            }
                                            let _e2275 = phi_4832_;
                                            phi_4836_ = _e2275;
                                            phi_4837_ = select(true, false, _e2043);
                                        }
                                        let _e2278 = phi_4836_;
                                        let _e2280 = phi_4837_;
                                        if _e2280 {
                                            phi_4841_ = type_49(type_35(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                                        } else {
                                            phi_4841_ = _e2278;
                                        }
                                        let _e2282 = phi_4841_;
                                        if (_e2282.member.member_1 <= _e2282.member.member_3) {
                                            phi_4193_ = _e2282;
                                        } else {
                                            let _e2289 = select(_e482, _e481, (_e481 > _e482));
                                            let _e2306 = (select(_e483, _e2289, (_e2289 > _e483)) * ((bitcast<f32>((bitcast<u32>(_e586.x) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e586.y) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e586.z) & 2147483647u))));
                                            let _e2310 = (_e445 + (_e586.x * _e2306));
                                            let _e2311 = (_e446 + (_e586.y * _e2306));
                                            let _e2312 = (_e447 + (_e586.z * _e2306));
                                            if (_e586.x > 0f) {
                                                let _e2333 = bitcast<u32>(_e2310);
                                                if ((_e2333 & 2147483647u) == 0u) {
                                                    phi_4058_ = 0.000000000000000000000000000000000000000000001f;
                                                } else {
                                                    if ((_e2333 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_4054_ = bitcast<f32>((_e2333 + 1u));
                                                    } else {
                                                        phi_4054_ = bitcast<f32>((_e2333 - 1u));
                                                    }
                                                    let _e2344 = phi_4054_;
                                                    phi_4058_ = _e2344;
                                                }
                                                let _e2346 = phi_4058_;
                                                phi_4060_ = _e2346;
                                            } else {
                                                if (_e586.x < 0f) {
                                                    let _e2316 = bitcast<u32>(-(_e2310));
                                                    if ((_e2316 & 2147483647u) == 0u) {
                                                        phi_4036_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e2316 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_4032_ = bitcast<f32>((_e2316 + 1u));
                                                        } else {
                                                            phi_4032_ = bitcast<f32>((_e2316 - 1u));
                                                        }
                                                        let _e2327 = phi_4032_;
                                                        phi_4036_ = _e2327;
                                                    }
                                                    let _e2329 = phi_4036_;
                                                    phi_4039_ = -(_e2329);
                                                } else {
                                                    phi_4039_ = _e2310;
                                                }
                                                let _e2332 = phi_4039_;
                                                phi_4060_ = _e2332;
                                            }
                                            let _e2348 = phi_4060_;
                                            if (_e586.y > 0f) {
                                                let _e2369 = bitcast<u32>(_e2311);
                                                if ((_e2369 & 2147483647u) == 0u) {
                                                    phi_4107_ = 0.000000000000000000000000000000000000000000001f;
                                                } else {
                                                    if ((_e2369 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_4103_ = bitcast<f32>((_e2369 + 1u));
                                                    } else {
                                                        phi_4103_ = bitcast<f32>((_e2369 - 1u));
                                                    }
                                                    let _e2380 = phi_4103_;
                                                    phi_4107_ = _e2380;
                                                }
                                                let _e2382 = phi_4107_;
                                                phi_4109_ = _e2382;
                                            } else {
                                                if (_e586.y < 0f) {
                                                    let _e2352 = bitcast<u32>(-(_e2311));
                                                    if ((_e2352 & 2147483647u) == 0u) {
                                                        phi_4085_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e2352 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_4081_ = bitcast<f32>((_e2352 + 1u));
                                                        } else {
                                                            phi_4081_ = bitcast<f32>((_e2352 - 1u));
                                                        }
                                                        let _e2363 = phi_4081_;
                                                        phi_4085_ = _e2363;
                                                    }
                                                    let _e2365 = phi_4085_;
                                                    phi_4088_ = -(_e2365);
                                                } else {
                                                    phi_4088_ = _e2311;
                                                }
                                                let _e2368 = phi_4088_;
                                                phi_4109_ = _e2368;
                                            }
                                            let _e2384 = phi_4109_;
                                            if (_e586.z > 0f) {
                                                let _e2405 = bitcast<u32>(_e2312);
                                                if ((_e2405 & 2147483647u) == 0u) {
                                                    phi_4156_ = 0.000000000000000000000000000000000000000000001f;
                                                } else {
                                                    if ((_e2405 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_4152_ = bitcast<f32>((_e2405 + 1u));
                                                    } else {
                                                        phi_4152_ = bitcast<f32>((_e2405 - 1u));
                                                    }
                                                    let _e2416 = phi_4152_;
                                                    phi_4156_ = _e2416;
                                                }
                                                let _e2418 = phi_4156_;
                                                phi_4158_ = _e2418;
                                            } else {
                                                if (_e586.z < 0f) {
                                                    let _e2388 = bitcast<u32>(-(_e2312));
                                                    if ((_e2388 & 2147483647u) == 0u) {
                                                        phi_4134_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e2388 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_4130_ = bitcast<f32>((_e2388 + 1u));
                                                        } else {
                                                            phi_4130_ = bitcast<f32>((_e2388 - 1u));
                                                        }
                                                        let _e2399 = phi_4130_;
                                                        phi_4134_ = _e2399;
                                                    }
                                                    let _e2401 = phi_4134_;
                                                    phi_4137_ = -(_e2401);
                                                } else {
                                                    phi_4137_ = _e2312;
                                                }
                                                let _e2404 = phi_4137_;
                                                phi_4158_ = _e2404;
                                            }
                                            let _e2420 = phi_4158_;
                                            if _e1936 {
                                                phi_4179_ = vec3<f32>((_e1572.member[0] - _e2348), (_e1572.member[1] - _e2384), (_e1572.member[2] - _e2420));
                                            } else {
                                                phi_4179_ = vec3<f32>(_e1572.member[0], _e1572.member[1], _e1572.member[2]);
                                            }
                                            let _e2430 = phi_4179_;
                                            phi_4193_ = type_49(type_35(array<f32, 3>(_e2348, _e2384, _e2420), 0f, array<f32, 3>(_e2430.x, _e2430.y, _e2430.z), select(340282350000000000000000000000000000000f, 1f, _e1936)), array<f32, 3>(0f, 0f, 0f), _e121.member_3);
                                        }
                                        let _e2440 = phi_4193_;
                                        phi_2302_ = _e2440;
                                    } else {
                                        let _e1586 = (_e1572.member_1 == 1u);
                                        if _e1586 {
                                            phi_3369_ = (vec3<f32>(_e1572.member[0], _e1572.member[1], _e1572.member[2]) - _e380);
                                        } else {
                                            phi_3369_ = vec3<f32>(_e1572.member[0], _e1572.member[1], _e1572.member[2]);
                                        }
                                        let _e1597 = phi_3369_;
                                        let _e1599 = bitcast<f32>(bitcast<u32>(_e496));
                                        let _e1602 = bitcast<f32>(bitcast<u32>((_e485 * _e487)));
                                        let _e1604 = bitcast<f32>(bitcast<u32>(_e490));
                                        let _e1607 = bitcast<f32>(bitcast<u32>((_e486 * _e488)));
                                        let _e1609 = bitcast<f32>(bitcast<u32>(_e493));
                                        let _e1612 = bitcast<f32>(bitcast<u32>((_e484 * _e489)));
                                        let _e1676 = global_12[0u];
                                        if (_e1572.member_2[0] == _e1676) {
                                            let _e1679 = global_12[1u];
                                            let _e1680 = (_e1572.member_2[1] == _e1679);
                                            if _e1680 {
                                                let _e1682 = global_12[2u];
                                                phi_3575_ = (_e1572.member_2[2] == _e1682);
                                            } else {
                                                phi_3575_ = bool();
                                            }
                                            let _e1685 = phi_3575_;
                                            phi_3578_ = _e1685;
                                            phi_3579_ = select(true, false, _e1680);
                                        } else {
                                            phi_3578_ = bool();
                                            phi_3579_ = true;
                                        }
                                        let _e1688 = phi_3578_;
                                        let _e1690 = phi_3579_;
                                        if select(_e1688, false, _e1690) {
                                            phi_3949_ = type_49();
                                            phi_3950_ = true;
                                        } else {
                                            let _e1693 = ((((bitcast<f32>(bitcast<u32>((_e1597.x * (_e1604 - _e1607)))) + bitcast<f32>(bitcast<u32>((_e1597.y * (_e1609 - _e1612))))) + bitcast<f32>(bitcast<u32>((_e1597.z * (_e1599 - _e1602))))) * _e582) > (bitcast<f32>(bitcast<u32>((0.0000009536752f * ((bitcast<f32>(bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1597.x) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e1604) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1607) & 2147483647u)))))) + bitcast<f32>(bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1597.y) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e1609) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1612) & 2147483647u))))))) + bitcast<f32>(bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1597.z) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e1599) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1602) & 2147483647u)))))))))) + 0.0000000000000000000000000000000000001880791f));
                                            if _e1693 {
                                                let _e1695 = select(_e482, _e481, (_e481 > _e482));
                                                let _e1712 = (select(_e483, _e1695, (_e1695 > _e483)) * ((bitcast<f32>((bitcast<u32>(_e586.x) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e586.y) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e586.z) & 2147483647u))));
                                                let _e1716 = (_e445 + (_e586.x * _e1712));
                                                let _e1717 = (_e446 + (_e586.y * _e1712));
                                                let _e1718 = (_e447 + (_e586.z * _e1712));
                                                if (_e586.x > 0f) {
                                                    let _e1739 = bitcast<u32>(_e1716);
                                                    if ((_e1739 & 2147483647u) == 0u) {
                                                        phi_3690_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1739 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_3686_ = bitcast<f32>((_e1739 + 1u));
                                                        } else {
                                                            phi_3686_ = bitcast<f32>((_e1739 - 1u));
                                                        }
                                                        let _e1750 = phi_3686_;
                                                        phi_3690_ = _e1750;
                                                    }
                                                    let _e1752 = phi_3690_;
                                                    phi_3692_ = _e1752;
                                                } else {
                                                    if (_e586.x < 0f) {
                                                        let _e1722 = bitcast<u32>(-(_e1716));
                                                        if ((_e1722 & 2147483647u) == 0u) {
                                                            phi_3668_ = 0.000000000000000000000000000000000000000000001f;
                                                        } else {
                                                            if ((_e1722 >> bitcast<u32>(31i)) == 0u) {
                                                                phi_3664_ = bitcast<f32>((_e1722 + 1u));
                                                            } else {
                                                                phi_3664_ = bitcast<f32>((_e1722 - 1u));
                                                            }
                                                            let _e1733 = phi_3664_;
                                                            phi_3668_ = _e1733;
                                                        }
                                                        let _e1735 = phi_3668_;
                                                        phi_3671_ = -(_e1735);
                                                    } else {
                                                        phi_3671_ = _e1716;
                                                    }
                                                    let _e1738 = phi_3671_;
                                                    phi_3692_ = _e1738;
                                                }
                                                let _e1754 = phi_3692_;
                                                if (_e586.y > 0f) {
                                                    let _e1775 = bitcast<u32>(_e1717);
                                                    if ((_e1775 & 2147483647u) == 0u) {
                                                        phi_3739_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1775 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_3735_ = bitcast<f32>((_e1775 + 1u));
                                                        } else {
                                                            phi_3735_ = bitcast<f32>((_e1775 - 1u));
                                                        }
                                                        let _e1786 = phi_3735_;
                                                        phi_3739_ = _e1786;
                                                    }
                                                    let _e1788 = phi_3739_;
                                                    phi_3741_ = _e1788;
                                                } else {
                                                    if (_e586.y < 0f) {
                                                        let _e1758 = bitcast<u32>(-(_e1717));
                                                        if ((_e1758 & 2147483647u) == 0u) {
                                                            phi_3717_ = 0.000000000000000000000000000000000000000000001f;
                                                        } else {
                                                            if ((_e1758 >> bitcast<u32>(31i)) == 0u) {
                                                                phi_3713_ = bitcast<f32>((_e1758 + 1u));
                                                            } else {
                                                                phi_3713_ = bitcast<f32>((_e1758 - 1u));
                                                            }
                                                            let _e1769 = phi_3713_;
                                                            phi_3717_ = _e1769;
                                                        }
                                                        let _e1771 = phi_3717_;
                                                        phi_3720_ = -(_e1771);
                                                    } else {
                                                        phi_3720_ = _e1717;
                                                    }
                                                    let _e1774 = phi_3720_;
                                                    phi_3741_ = _e1774;
                                                }
                                                let _e1790 = phi_3741_;
                                                if (_e586.z > 0f) {
                                                    let _e1811 = bitcast<u32>(_e1718);
                                                    if ((_e1811 & 2147483647u) == 0u) {
                                                        phi_3788_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1811 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_3784_ = bitcast<f32>((_e1811 + 1u));
                                                        } else {
                                                            phi_3784_ = bitcast<f32>((_e1811 - 1u));
                                                        }
                                                        let _e1822 = phi_3784_;
                                                        phi_3788_ = _e1822;
                                                    }
                                                    let _e1824 = phi_3788_;
                                                    phi_3790_ = _e1824;
                                                } else {
                                                    if (_e586.z < 0f) {
                                                        let _e1794 = bitcast<u32>(-(_e1718));
                                                        if ((_e1794 & 2147483647u) == 0u) {
                                                            phi_3766_ = 0.000000000000000000000000000000000000000000001f;
                                                        } else {
                                                            if ((_e1794 >> bitcast<u32>(31i)) == 0u) {
                                                                phi_3762_ = bitcast<f32>((_e1794 + 1u));
                                                            } else {
                                                                phi_3762_ = bitcast<f32>((_e1794 - 1u));
                                                            }
                                                            let _e1805 = phi_3762_;
                                                            phi_3766_ = _e1805;
                                                        }
                                                        let _e1807 = phi_3766_;
                                                        phi_3769_ = -(_e1807);
                                                    } else {
                                                        phi_3769_ = _e1718;
                                                    }
                                                    let _e1810 = phi_3769_;
                                                    phi_3790_ = _e1810;
                                                }
                                                let _e1826 = phi_3790_;
                                                if _e1586 {
                                                    phi_3811_ = vec3<f32>((_e1572.member[0] - _e1754), (_e1572.member[1] - _e1790), (_e1572.member[2] - _e1826));
                                                } else {
                                                    phi_3811_ = vec3<f32>(_e1572.member[0], _e1572.member[1], _e1572.member[2]);
                                                }
                                                let _e1836 = phi_3811_;
                                                let _e1849 = sqrt((((_e1836.x * _e1836.x) + (_e1836.y * _e1836.y)) + (_e1836.z * _e1836.z)));
                                                let _e1858 = ((((_e699.x * _e1836.x) + (_e699.y * _e1836.y)) + (_e699.z * _e1836.z)) / _e1849);
                                                if _e1586 {
                                                    phi_3845_ = (_e1849 <= _e1572.member_3);
                                                } else {
                                                    phi_3845_ = true;
                                                }
                                                let _e1861 = phi_3845_;
                                                if _e1586 {
                                                    phi_3851_ = (1f / (_e1849 * _e1849));
                                                } else {
                                                    phi_3851_ = 1f;
                                                }
                                                let _e1865 = phi_3851_;
                                                let _e1866 = -(_e1836.x);
                                                let _e1867 = -(_e1836.y);
                                                let _e1868 = -(_e1836.z);
                                                if (_e1572.member_5 == 0u) {
                                                    phi_3887_ = 1f;
                                                } else {
                                                    let _e1884 = ((((_e1572.member_8[0] * _e1866) + (_e1572.member_8[1] * _e1867)) + (_e1572.member_8[2] * _e1868)) / sqrt((((_e1866 * _e1866) + (_e1867 * _e1867)) + (_e1868 * _e1868))));
                                                    phi_3887_ = select(0f, _e1884, (_e1884 > 0f));
                                                }
                                                let _e1888 = phi_3887_;
                                                if (_e1858 > 0f) {
                                                    if _e1861 {
                                                        let _e1890 = (_e1888 > 0f);
                                                        if _e1890 {
                                                            let _e1897 = ((1f - select(_e711.member_1, _e711.member_2, (_e711.member_2 > 0f))) * 0.31830987f);
                                                            let _e1905 = ((_e1858 * _e1865) * _e1888);
                                                            phi_3932_ = type_49(type_35(array<f32, 3>(_e1754, _e1790, _e1826), 0f, array<f32, 3>(_e1836.x, _e1836.y, _e1836.z), select(340282350000000000000000000000000000000f, 1f, _e1586)), array<f32, 3>(((_e1572.member_2[0] * (_e711.member[0] * _e1897)) * _e1905), ((_e1572.member_2[1] * (_e711.member[1] * _e1897)) * _e1905), ((_e1572.member_2[2] * (_e711.member[2] * _e1897)) * _e1905)), _e121.member_3);
                                                        } else {
                                                            phi_3932_ = type_49();
                                                        }
                                                        let _e1912 = phi_3932_;
                                                        phi_3935_ = _e1912;
                                                        phi_3936_ = select(true, false, _e1890);
                                                    } else {
                                                        phi_3935_ = type_49();
                                                        phi_3936_ = true;
                                                    }
                                                    let _e1915 = phi_3935_;
                                                    let _e1917 = phi_3936_;
                                                    phi_3938_ = _e1915;
                                                    phi_3939_ = _e1917;
                                                } else {
                                                    phi_3938_ = type_49();
                                                    phi_3939_ = true;
                                                }
                                                let _e1919 = phi_3938_;
                                                let _e1921 = phi_3939_;
                                                if _e1921 {
                                                    phi_3943_ = type_49(type_35(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                                                } else {
                                                    phi_3943_ = _e1919;
                                                }
                                                let _e1923 = phi_3943_;
                                                phi_3945_ = _e1923;
                                            } else {
                                                phi_3945_ = type_49();
                                            }
                                            let _e1925 = phi_3945_;
                                            phi_3949_ = _e1925;
                                            phi_3950_ = select(true, false, _e1693);
                                        }
                                        let _e1928 = phi_3949_;
                                        let _e1930 = phi_3950_;
                                        if _e1930 {
                                            phi_3954_ = type_49(type_35(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                                        } else {
                                            phi_3954_ = _e1928;
                                        }
                                        let _e1932 = phi_3954_;
                                        phi_2302_ = _e1932;
                                    }
                                    let _e2442 = phi_2302_;
                                    phi_2303_ = _e2442;
                                }
                                let _e2444 = phi_2303_;
                                phi_2304_ = _e2444;
                            } else {
                                phi_2304_ = type_49(type_35(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                            }
                            let _e2446 = phi_2304_;
                            phi_2305_ = _e2446;
                        } else {
                            phi_2305_ = type_49(type_35(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                        }
                        let _e2448 = phi_2305_;
                        if _e115 {
                        } else {
                            break;
                        }
                        global_11.member[_e112] = _e2448;
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn shade_light(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
