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

struct type_43 {
    member: array<vec4<u32>, 2>,
}

struct type_46 {
    member: array<i32>,
}

struct type_52 {
    member: array<array<u32, 7>>,
}

struct type_57 {
    member: type_33,
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
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_43;
@group(0) @binding(2) 
var<uniform> global_3: type_43;
@group(0) @binding(5) 
var<storage> global_4: type_4;
@group(0) @binding(6) 
var<storage> global_5: type_46;
@group(0) @binding(7) 
var<storage> global_6: type_28;
@group(0) @binding(8) 
var<storage, read_write> global_7: type_23;
@group(0) @binding(9) 
var<storage, read_write> global_8: type_63;
@group(0) @binding(3) 
var<storage> global_9: type_52;
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
    var phi_606_: type_35;
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
    var phi_1401_: type_39;
    var phi_1404_: u32;
    var phi_1406_: bool;
    var phi_1408_: u32;
    var phi_1410_: type_57;
    var phi_1421_: bool;
    var phi_1507_: bool;
    var phi_1508_: u32;
    var phi_1509_: type_57;
    var phi_1528_: type_39;
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
    var phi_3157_: type_21;
    var phi_3159_: type_21;
    var phi_3160_: bool;
    var phi_3164_: type_21;
    var phi_3165_: type_21;
    var phi_3166_: type_21;
    var phi_3167_: bool;
    var phi_3171_: type_21;
    var phi_3172_: bool;
    var phi_3173_: type_21;
    var phi_3174_: bool;
    var phi_3175_: bool;
    var phi_3176_: type_21;
    var phi_3177_: bool;
    var phi_3178_: bool;
    var phi_3186_: type_21;
    var phi_3187_: bool;
    var phi_3191_: type_21;
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
    var phi_3552_: type_39;
    var phi_3553_: type_39;
    var phi_3554_: type_39;
    var phi_1529_: type_39;
    var phi_5274_: bool;
    var phi_5604_: bool;
    var phi_3555_: type_39;
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
    var phi_4833_: type_39;
    var phi_4834_: u32;
    var phi_4835_: bool;
    var phi_4836_: u32;
    var phi_4837_: type_57;
    var phi_5515_: bool;
    var phi_4838_: type_39;
    var phi_4839_: u32;
    var phi_4840_: bool;
    var phi_4841_: u32;
    var phi_4842_: type_57;
    var phi_5514_: bool;
    var phi_1402_: type_39;
    var phi_1405_: u32;
    var phi_1407_: bool;
    var phi_1409_: u32;
    var phi_1411_: type_57;
    var phi_4843_: bool;
    var phi_5513_: bool;
    var local_10: type_39;
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
    var phi_4919_: type_21;
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
                phi_422_ = _e172;
            } else {
                phi_422_ = 4294967295u;
            }
            let _e174 = phi_422_;
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
                phi_466_ = -126i;
            } else {
                phi_466_ = select(_e217, 127i, (_e217 > 127i));
            }
            let _e222 = phi_466_;
            let _e227 = bitcast<f32>((bitcast<u32>((_e222 + 127i)) << bitcast<u32>(23i)));
            let _e233 = bitcast<f32>((bitcast<u32>(((_e217 - _e222) + 127i)) << bitcast<u32>(23i)));
            if (_e193 == 0u) {
                phi_606_ = type_35(array<f32, 3>(_e210, _e211, _e212), _e193, _e214, _e215);
            } else {
                let _e235 = bitcast<u32>(_e210);
                let _e237 = ((_e235 & 2139095040u) != 0u);
                let _e252 = bitcast<u32>(_e211);
                let _e254 = ((_e252 & 2139095040u) != 0u);
                let _e269 = bitcast<u32>(_e212);
                let _e271 = ((_e269 & 2139095040u) != 0u);
                let _e287 = bitcast<u32>(_e214);
                let _e289 = ((_e287 & 2139095040u) != 0u);
                phi_606_ = type_35(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e235 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e235 & 2147483648u))), _e210, _e237) * _e227) * select(0.00000011920929f, 1f, _e237)) * _e233), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e252 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e252 & 2147483648u))), _e211, _e254) * _e227) * select(0.00000011920929f, 1f, _e254)) * _e233), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e269 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e269 & 2147483648u))), _e212, _e271) * _e227) * select(0.00000011920929f, 1f, _e271)) * _e233)), _e193, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e287 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e287 & 2147483648u))), _e214, _e289) * _e227) * select(0.00000011920929f, 1f, _e289)) * _e233), _e215);
            }
            let _e306 = phi_606_;
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
                            phi_712_ = (bitcast<i32>((_e393 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_712_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e393)), 32u, (_e393 == 0u))));
                        }
                        let _e407 = phi_712_;
                        phi_713_ = _e407;
                    } else {
                        phi_713_ = 0i;
                    }
                    let _e409 = phi_713_;
                    let _e410 = (_e319 == _e363);
                    if _e410 {
                        phi_723_ = true;
                    } else {
                        phi_723_ = (_e327 == _e363);
                    }
                    let _e413 = phi_723_;
                    let _e414 = select(1u, 0u, _e410);
                    if _e413 {
                        let _e415 = (_e414 + 1u);
                        phi_733_ = _e415;
                        phi_734_ = _e415;
                        phi_736_ = select(true, false, (_e415 == 2u));
                    } else {
                        phi_733_ = u32();
                        phi_734_ = 0u;
                        phi_736_ = true;
                    }
                    let _e419 = phi_733_;
                    let _e421 = phi_734_;
                    let _e423 = phi_736_;
                    if _e423 {
                        phi_741_ = (_e421 + 1u);
                    } else {
                        phi_741_ = 0u;
                    }
                    let _e427 = phi_741_;
                    let _e428 = select(_e419, _e421, _e423);
                    let _e429 = select(_e414, select(2u, _e414, _e413), _e423);
                    let _e430 = -(_e409);
                    if (_e430 < -126i) {
                        phi_774_ = -126i;
                    } else {
                        phi_774_ = select(_e430, 127i, (_e430 > 127i));
                    }
                    let _e435 = phi_774_;
                    let _e440 = bitcast<f32>((bitcast<u32>((_e435 + 127i)) << bitcast<u32>(23i)));
                    let _e446 = bitcast<f32>((bitcast<u32>(((_e430 - _e435) + 127i)) << bitcast<u32>(23i)));
                    let _e451 = global_6.member[_e153].member.member;
                    let _e452 = (_e428 == 0u);
                    if _e452 {
                        phi_792_ = _e451[0];
                    } else {
                        phi_792_ = _e451[1];
                    }
                    let _e456 = phi_792_;
                    let _e457 = (_e428 == 2u);
                    if _e457 {
                        phi_798_ = _e451[2];
                    } else {
                        phi_798_ = _e456;
                    }
                    let _e460 = phi_798_;
                    let _e461 = bitcast<u32>(_e460);
                    let _e463 = ((_e461 & 2139095040u) != 0u);
                    let _e475 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e461 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e461 & 2147483648u))), _e460, _e463) * select(0.00000011920929f, 1f, _e463));
                    let _e476 = global_6.member[_e153].member.member_2;
                    if _e452 {
                        phi_838_ = _e476[0];
                    } else {
                        phi_838_ = _e476[1];
                    }
                    let _e480 = phi_838_;
                    if _e457 {
                        phi_844_ = _e476[2];
                    } else {
                        phi_844_ = _e480;
                    }
                    let _e483 = phi_844_;
                    let _e484 = bitcast<u32>(_e483);
                    let _e486 = ((_e484 & 2139095040u) != 0u);
                    let _e500 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e484 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e484 & 2147483648u))), _e483, _e486) * _e440) * select(0.00000011920929f, 1f, _e486)) * _e446);
                    let _e504 = (bitcast<f32>((bitcast<u32>(_e500) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e504 {
                        let _e508 = (bitcast<f32>((bitcast<u32>(_e475) & 2147483647u)) * 0.00000011920929f);
                        phi_896_ = select(0.00000000000011368684f, _e508, (_e508 > 0.00000000000011368684f));
                    } else {
                        phi_896_ = 0f;
                    }
                    let _e512 = phi_896_;
                    let _e513 = (_e475 + _e512);
                    let _e514 = (_e475 - _e512);
                    let _e515 = select(_e500, 0f, _e504);
                    if _e504 {
                        phi_908_ = 38685626000000000000000000f;
                    } else {
                        phi_908_ = (1f / _e500);
                    }
                    let _e518 = phi_908_;
                    let _e519 = (_e427 == 0u);
                    if _e519 {
                        phi_917_ = _e451[0];
                    } else {
                        phi_917_ = _e451[1];
                    }
                    let _e523 = phi_917_;
                    let _e524 = (_e427 == 2u);
                    if _e524 {
                        phi_923_ = _e451[2];
                    } else {
                        phi_923_ = _e523;
                    }
                    let _e527 = phi_923_;
                    let _e528 = bitcast<u32>(_e527);
                    let _e530 = ((_e528 & 2139095040u) != 0u);
                    let _e542 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e528 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e528 & 2147483648u))), _e527, _e530) * select(0.00000011920929f, 1f, _e530));
                    if _e519 {
                        phi_963_ = _e476[0];
                    } else {
                        phi_963_ = _e476[1];
                    }
                    let _e546 = phi_963_;
                    if _e524 {
                        phi_969_ = _e476[2];
                    } else {
                        phi_969_ = _e546;
                    }
                    let _e549 = phi_969_;
                    let _e550 = bitcast<u32>(_e549);
                    let _e552 = ((_e550 & 2139095040u) != 0u);
                    let _e566 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e550 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e550 & 2147483648u))), _e549, _e552) * _e440) * select(0.00000011920929f, 1f, _e552)) * _e446);
                    let _e570 = (bitcast<f32>((bitcast<u32>(_e566) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e570 {
                        let _e574 = (bitcast<f32>((bitcast<u32>(_e542) & 2147483647u)) * 0.00000011920929f);
                        phi_1021_ = select(0.00000000000011368684f, _e574, (_e574 > 0.00000000000011368684f));
                    } else {
                        phi_1021_ = 0f;
                    }
                    let _e578 = phi_1021_;
                    let _e579 = (_e542 + _e578);
                    let _e580 = (_e542 - _e578);
                    let _e581 = select(_e566, 0f, _e570);
                    if _e570 {
                        phi_1033_ = 38685626000000000000000000f;
                    } else {
                        phi_1033_ = (1f / _e566);
                    }
                    let _e584 = phi_1033_;
                    let _e585 = (_e429 == 0u);
                    if _e585 {
                        phi_1042_ = _e451[0];
                    } else {
                        phi_1042_ = _e451[1];
                    }
                    let _e589 = phi_1042_;
                    let _e590 = (_e429 == 2u);
                    if _e590 {
                        phi_1048_ = _e451[2];
                    } else {
                        phi_1048_ = _e589;
                    }
                    let _e593 = phi_1048_;
                    let _e594 = bitcast<u32>(_e593);
                    let _e596 = ((_e594 & 2139095040u) != 0u);
                    let _e608 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e594 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e594 & 2147483648u))), _e593, _e596) * select(0.00000011920929f, 1f, _e596));
                    if _e585 {
                        phi_1088_ = _e476[0];
                    } else {
                        phi_1088_ = _e476[1];
                    }
                    let _e612 = phi_1088_;
                    if _e590 {
                        phi_1094_ = _e476[2];
                    } else {
                        phi_1094_ = _e612;
                    }
                    let _e615 = phi_1094_;
                    let _e616 = bitcast<u32>(_e615);
                    let _e618 = ((_e616 & 2139095040u) != 0u);
                    let _e632 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e616 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e616 & 2147483648u))), _e615, _e618) * _e440) * select(0.00000011920929f, 1f, _e618)) * _e446);
                    let _e636 = (bitcast<f32>((bitcast<u32>(_e632) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e636 {
                        let _e640 = (bitcast<f32>((bitcast<u32>(_e608) & 2147483647u)) * 0.00000011920929f);
                        phi_1146_ = select(0.00000000000011368684f, _e640, (_e640 > 0.00000000000011368684f));
                    } else {
                        phi_1146_ = 0f;
                    }
                    let _e644 = phi_1146_;
                    let _e645 = (_e608 + _e644);
                    let _e646 = (_e608 - _e644);
                    let _e647 = select(_e632, 0f, _e636);
                    if _e636 {
                        phi_1158_ = 38685626000000000000000000f;
                    } else {
                        phi_1158_ = (1f / _e632);
                    }
                    let _e650 = phi_1158_;
                    let _e653 = bitcast<f32>((bitcast<u32>(_e475) & 2147483647u));
                    let _e656 = bitcast<f32>((bitcast<u32>(_e542) & 2147483647u));
                    let _e658 = select(_e656, _e653, (_e653 > _e656));
                    let _e661 = bitcast<f32>((bitcast<u32>(_e608) & 2147483647u));
                    if (_e390 && (select(_e661, _e658, (_e658 > _e661)) <= 1099511600000f)) {
                        let _e673 = ((_e376 & 8388607u) | (select(0u, 1u, ((_e376 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e676 = bitcast<i32>((_e376 >> bitcast<u32>(23i)));
                        let _e680 = (_e673 == 0u);
                        let _e683 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e673)), 32u, _e680)) - 8i);
                        if (_e676 == 255i) {
                            phi_1213_ = 255i;
                        } else {
                            phi_1213_ = (((_e676 + select(0i, 1i, (_e676 == 0i))) - _e683) + _e409);
                        }
                        let _e691 = phi_1213_;
                        let _e701 = (_e691 <= 0i);
                        if _e701 {
                            phi_1236_ = u32();
                        } else {
                            if _e680 {
                                phi_1235_ = u32();
                            } else {
                                phi_1235_ = select(((bitcast<u32>(_e691) << bitcast<u32>(23i)) | ((_e673 << bitcast<u32>(((_e683 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e691 >= 255i));
                            }
                            let _e705 = phi_1235_;
                            phi_1236_ = _e705;
                        }
                        let _e707 = phi_1236_;
                        let _e719 = ((_e386 & 8388607u) | (select(0u, 1u, ((_e386 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e722 = bitcast<i32>((_e386 >> bitcast<u32>(23i)));
                        let _e726 = (_e719 == 0u);
                        let _e729 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e719)), 32u, _e726)) - 8i);
                        if (_e722 == 255i) {
                            phi_1273_ = 255i;
                        } else {
                            phi_1273_ = (((_e722 + select(0i, 1i, (_e722 == 0i))) - _e729) + _e409);
                        }
                        let _e737 = phi_1273_;
                        let _e747 = (_e737 <= 0i);
                        if _e747 {
                            phi_1296_ = u32();
                        } else {
                            if _e726 {
                                phi_1295_ = u32();
                            } else {
                                phi_1295_ = select(((bitcast<u32>(_e737) << bitcast<u32>(23i)) | ((_e719 << bitcast<u32>(((_e729 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e737 >= 255i));
                            }
                            let _e751 = phi_1295_;
                            phi_1296_ = _e751;
                        }
                        let _e753 = phi_1296_;
                        phi_1304_ = bitcast<f32>(((_e385 & 2147483648u) | select(_e753, 0u, select(_e726, true, _e747))));
                        phi_1305_ = bitcast<f32>(((_e375 & 2147483648u) | select(_e707, 0u, select(_e680, true, _e701))));
                    } else {
                        phi_1304_ = 0f;
                        phi_1305_ = 1f;
                    }
                    let _e759 = phi_1304_;
                    let _e761 = phi_1305_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e765 = (_e428 % 3u);
                    let _e766 = (_e765 < 3u);
                    if _e766 {
                    } else {
                        break;
                    }
                    let _e768 = local_1[_e765];
                    let _e771 = (_e427 % 3u);
                    let _e772 = (_e771 < 3u);
                    if _e772 {
                    } else {
                        break;
                    }
                    let _e774 = local_1[_e771];
                    let _e777 = (_e429 % 3u);
                    let _e778 = (_e777 < 3u);
                    if _e778 {
                    } else {
                        break;
                    }
                    let _e780 = local_1[_e777];
                    if _e766 {
                    } else {
                        break;
                    }
                    let _e785 = local[_e765];
                    if _e772 {
                    } else {
                        break;
                    }
                    let _e789 = local[_e771];
                    if _e778 {
                    } else {
                        break;
                    }
                    let _e793 = local[_e777];
                    phi_5280_ = false;
                    phi_1401_ = type_39(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e759);
                    phi_1404_ = ((3u * _e106) + 1u);
                    phi_1406_ = (_e761 <= _e759);
                    phi_1408_ = 0u;
                    phi_1410_ = type_57(type_33(vec4<f32>((f32(_e768) * _e165), (f32(_e774) * _e165), (f32(_e780) * _e165), 0f), vec4<f32>((f32(_e785) * _e165), (f32(_e789) * _e165), (f32(_e793) * _e165), 0f)), select(0u, 2147483648u, (_e106 == 0u)));
                    loop {
                        let _e803 = phi_5280_;
                        let _e805 = phi_1401_;
                        let _e807 = phi_1404_;
                        let _e809 = phi_1406_;
                        let _e811 = phi_1408_;
                        let _e813 = phi_1410_;
                        local_10 = _e805;
                        if _e809 {
                            phi_1421_ = true;
                        } else {
                            phi_1421_ = (_e811 > 0u);
                        }
                        let _e816 = phi_1421_;
                        if _e816 {
                            let _e817 = (_e807 > 0u);
                            if _e817 {
                                if _e809 {
                                    phi_1507_ = _e809;
                                    phi_1508_ = _e811;
                                    phi_1509_ = _e813;
                                } else {
                                    let _e818 = (_e811 - 1u);
                                    let _e819 = (_e818 % 128u);
                                    let _e820 = (_e819 < 128u);
                                    if _e820 {
                                    } else {
                                        phi_5513_ = true;
                                        break;
                                    }
                                    let _e822 = local_7[_e819];
                                    if _e820 {
                                    } else {
                                        phi_5513_ = true;
                                        break;
                                    }
                                    let _e824 = local_6[_e819];
                                    if _e820 {
                                    } else {
                                        phi_5513_ = true;
                                        break;
                                    }
                                    let _e826 = local_5[_e819];
                                    if _e820 {
                                    } else {
                                        phi_5513_ = true;
                                        break;
                                    }
                                    let _e828 = local_4[_e819];
                                    if _e820 {
                                    } else {
                                        phi_5513_ = true;
                                        break;
                                    }
                                    let _e830 = local_3[_e819];
                                    if _e820 {
                                    } else {
                                        phi_5513_ = true;
                                        break;
                                    }
                                    let _e832 = local_2[_e819];
                                    if _e820 {
                                    } else {
                                        phi_5513_ = true;
                                        break;
                                    }
                                    let _e837 = local_8[_e819];
                                    if _e820 {
                                    } else {
                                        phi_5513_ = true;
                                        break;
                                    }
                                    let _e840 = local_9[_e819];
                                    phi_1507_ = (_e840 <= _e805.member_1);
                                    phi_1508_ = _e818;
                                    phi_1509_ = type_57(type_33(vec4<f32>(_e822, _e824, _e826, 0f), vec4<f32>(_e828, _e830, _e832, 0f)), _e837);
                                }
                                let _e844 = phi_1507_;
                                let _e846 = phi_1508_;
                                let _e848 = phi_1509_;
                                if _e844 {
                                    let _e852 = ((_e848.member_1 & 2147483648u) != 0u);
                                    let _e853 = (_e848.member_1 & 268435455u);
                                    if _e852 {
                                        phi_1528_ = _e805;
                                        phi_1531_ = type_8(0u, ((_e848.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e860 = phi_1528_;
                                            let _e862 = phi_1531_;
                                            local_11 = _e860;
                                            if (_e862.member < _e862.member_1) {
                                                phi_1532_ = type_8((_e862.member + 1u), _e862.member_1);
                                                phi_1554_ = type_8(1u, _e862.member);
                                            } else {
                                                phi_1532_ = _e862;
                                                phi_1554_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e875 = phi_1532_;
                                            let _e877 = phi_1554_;
                                            let _e881 = (bitcast<i32>(_e877.member) != 0i);
                                            if _e881 {
                                                let _e886 = (_e848.member.member_1.x - _e848.member.member.x);
                                                let _e889 = (_e848.member.member_1.y - _e848.member.member.y);
                                                let _e892 = (_e848.member.member_1.z - _e848.member.member.z);
                                                let _e894 = select(_e889, _e886, (_e886 > _e889));
                                                let _e896 = select(_e892, _e894, (_e894 > _e892));
                                                let _e898 = (_e896 < (1024f * _e165));
                                                if _e898 {
                                                    phi_1595_ = 0u;
                                                } else {
                                                    phi_1595_ = select(2u, 1u, (_e896 < (2097152f * _e165)));
                                                }
                                                let _e903 = phi_1595_;
                                                switch bitcast<i32>(_e903) {
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
                                                let _e906 = phi_1601_;
                                                switch bitcast<i32>(_e903) {
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
                                                let _e913 = phi_1611_;
                                                let _e915 = ((_e853 + (_e877.member_1 * ((3u * _e906) + 1u))) + (3u * _e913));
                                                let _e916 = (_e915 < _e109);
                                                if _e916 {
                                                    if _e916 {
                                                    } else {
                                                        phi_5274_ = true;
                                                        break;
                                                    }
                                                    let _e918 = global_10.member[_e915];
                                                    phi_1627_ = _e918;
                                                } else {
                                                    phi_1627_ = 4294967295u;
                                                }
                                                let _e920 = phi_1627_;
                                                if _e898 {
                                                    phi_1660_ = 0u;
                                                } else {
                                                    phi_1660_ = select(2u, 1u, (_e896 < (2097152f * _e165)));
                                                }
                                                let _e925 = phi_1660_;
                                                switch bitcast<i32>(_e925) {
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
                                                let _e928 = phi_1666_;
                                                let _e932 = (_e853 + (_e877.member_1 * ((3u * _e928) + 1u)));
                                                switch bitcast<i32>(_e925) {
                                                    case 0: {
                                                        let _e1207 = (_e932 < _e109);
                                                        if _e1207 {
                                                            if _e1207 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e1209 = global_10.member[_e932];
                                                            phi_1693_ = _e1209;
                                                        } else {
                                                            phi_1693_ = 0u;
                                                        }
                                                        let _e1211 = phi_1693_;
                                                        let _e1213 = ((10u * _e428) & 31u);
                                                        let _e1223 = ((10u * _e427) & 31u);
                                                        let _e1233 = ((10u * _e429) & 31u);
                                                        let _e1243 = (_e932 + 1u);
                                                        let _e1244 = (_e1243 < _e109);
                                                        if _e1244 {
                                                            if _e1244 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e1246 = global_10.member[_e1243];
                                                            phi_1742_ = _e1246;
                                                        } else {
                                                            phi_1742_ = 0u;
                                                        }
                                                        let _e1248 = phi_1742_;
                                                        let _e1274 = (_e932 + 2u);
                                                        let _e1275 = (_e1274 < _e109);
                                                        if _e1275 {
                                                            if _e1275 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e1277 = global_10.member[_e1274];
                                                            phi_1791_ = _e1277;
                                                        } else {
                                                            phi_1791_ = 0u;
                                                        }
                                                        let _e1279 = phi_1791_;
                                                        phi_2292_ = array<array<f32, 3>, 3>(array<f32, 3>((_e848.member.member.x + ((bitcast<f32>((1258291200u | ((_e1211 >> bitcast<u32>(_e1213)) & 1023u))) - 8388608f) * _e165)), (_e848.member.member.y + ((bitcast<f32>((1258291200u | ((_e1211 >> bitcast<u32>(_e1223)) & 1023u))) - 8388608f) * _e165)), (_e848.member.member.z + ((bitcast<f32>((1258291200u | ((_e1211 >> bitcast<u32>(_e1233)) & 1023u))) - 8388608f) * _e165))), array<f32, 3>((_e848.member.member.x + ((bitcast<f32>((1258291200u | ((_e1248 >> bitcast<u32>(_e1213)) & 1023u))) - 8388608f) * _e165)), (_e848.member.member.y + ((bitcast<f32>((1258291200u | ((_e1248 >> bitcast<u32>(_e1223)) & 1023u))) - 8388608f) * _e165)), (_e848.member.member.z + ((bitcast<f32>((1258291200u | ((_e1248 >> bitcast<u32>(_e1233)) & 1023u))) - 8388608f) * _e165))), array<f32, 3>((_e848.member.member.x + ((bitcast<f32>((1258291200u | ((_e1279 >> bitcast<u32>(_e1213)) & 1023u))) - 8388608f) * _e165)), (_e848.member.member.y + ((bitcast<f32>((1258291200u | ((_e1279 >> bitcast<u32>(_e1223)) & 1023u))) - 8388608f) * _e165)), (_e848.member.member.z + ((bitcast<f32>((1258291200u | ((_e1279 >> bitcast<u32>(_e1233)) & 1023u))) - 8388608f) * _e165))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1021 = (_e932 < _e109);
                                                        if _e1021 {
                                                            if _e1021 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e1023 = global_10.member[_e932];
                                                            phi_1840_ = _e1023;
                                                        } else {
                                                            phi_1840_ = 0u;
                                                        }
                                                        let _e1025 = phi_1840_;
                                                        let _e1026 = (_e932 + 1u);
                                                        let _e1027 = (_e1026 < _e109);
                                                        if _e1027 {
                                                            if _e1027 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e1029 = global_10.member[_e1026];
                                                            phi_1855_ = _e1029;
                                                        } else {
                                                            phi_1855_ = 0u;
                                                        }
                                                        let _e1031 = phi_1855_;
                                                        let _e1032 = (_e428 == 1u);
                                                        if _e1032 {
                                                            phi_1865_ = ((_e1025 >> bitcast<u32>(21i)) | (_e1031 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1865_ = (_e1031 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1041 = phi_1865_;
                                                        let _e1049 = (_e427 == 1u);
                                                        if _e1049 {
                                                            phi_1886_ = ((_e1025 >> bitcast<u32>(21i)) | (_e1031 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1886_ = (_e1031 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1058 = phi_1886_;
                                                        let _e1066 = (_e429 == 1u);
                                                        if _e1066 {
                                                            phi_1907_ = ((_e1025 >> bitcast<u32>(21i)) | (_e1031 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1907_ = (_e1031 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1075 = phi_1907_;
                                                        let _e1084 = (_e932 + 2u);
                                                        let _e1085 = (_e1084 < _e109);
                                                        if _e1085 {
                                                            if _e1085 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e1087 = global_10.member[_e1084];
                                                            phi_1937_ = _e1087;
                                                        } else {
                                                            phi_1937_ = 0u;
                                                        }
                                                        let _e1089 = phi_1937_;
                                                        let _e1090 = (_e932 + 3u);
                                                        let _e1091 = (_e1090 < _e109);
                                                        if _e1091 {
                                                            if _e1091 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e1093 = global_10.member[_e1090];
                                                            phi_1952_ = _e1093;
                                                        } else {
                                                            phi_1952_ = 0u;
                                                        }
                                                        let _e1095 = phi_1952_;
                                                        if _e1032 {
                                                            phi_1962_ = ((_e1089 >> bitcast<u32>(21i)) | (_e1095 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1962_ = (_e1095 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1104 = phi_1962_;
                                                        if _e1049 {
                                                            phi_1983_ = ((_e1089 >> bitcast<u32>(21i)) | (_e1095 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1983_ = (_e1095 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1120 = phi_1983_;
                                                        if _e1066 {
                                                            phi_2004_ = ((_e1089 >> bitcast<u32>(21i)) | (_e1095 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2004_ = (_e1095 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1136 = phi_2004_;
                                                        let _e1145 = (_e932 + 4u);
                                                        let _e1146 = (_e1145 < _e109);
                                                        if _e1146 {
                                                            if _e1146 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e1148 = global_10.member[_e1145];
                                                            phi_2034_ = _e1148;
                                                        } else {
                                                            phi_2034_ = 0u;
                                                        }
                                                        let _e1150 = phi_2034_;
                                                        let _e1151 = (_e932 + 5u);
                                                        let _e1152 = (_e1151 < _e109);
                                                        if _e1152 {
                                                            if _e1152 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e1154 = global_10.member[_e1151];
                                                            phi_2049_ = _e1154;
                                                        } else {
                                                            phi_2049_ = 0u;
                                                        }
                                                        let _e1156 = phi_2049_;
                                                        if _e1032 {
                                                            phi_2059_ = ((_e1150 >> bitcast<u32>(21i)) | (_e1156 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2059_ = (_e1156 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1165 = phi_2059_;
                                                        if _e1049 {
                                                            phi_2080_ = ((_e1150 >> bitcast<u32>(21i)) | (_e1156 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2080_ = (_e1156 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1181 = phi_2080_;
                                                        if _e1066 {
                                                            phi_2101_ = ((_e1150 >> bitcast<u32>(21i)) | (_e1156 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2101_ = (_e1156 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1197 = phi_2101_;
                                                        phi_2292_ = array<array<f32, 3>, 3>(array<f32, 3>((_e848.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1041, _e1025, _e452) & 2097151u))) - 8388608f) * _e165)), (_e848.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1058, _e1025, _e519) & 2097151u))) - 8388608f) * _e165)), (_e848.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1075, _e1025, _e585) & 2097151u))) - 8388608f) * _e165))), array<f32, 3>((_e848.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1104, _e1089, _e452) & 2097151u))) - 8388608f) * _e165)), (_e848.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1120, _e1089, _e519) & 2097151u))) - 8388608f) * _e165)), (_e848.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1136, _e1089, _e585) & 2097151u))) - 8388608f) * _e165))), array<f32, 3>((_e848.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1165, _e1150, _e452) & 2097151u))) - 8388608f) * _e165)), (_e848.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1181, _e1150, _e519) & 2097151u))) - 8388608f) * _e165)), (_e848.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1197, _e1150, _e585) & 2097151u))) - 8388608f) * _e165))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e934 = (_e932 + _e428);
                                                        let _e935 = (_e934 < _e109);
                                                        if _e935 {
                                                            if _e935 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e937 = global_10.member[_e934];
                                                            phi_2132_ = _e937;
                                                        } else {
                                                            phi_2132_ = 0u;
                                                        }
                                                        let _e939 = phi_2132_;
                                                        let _e943 = (_e932 + _e427);
                                                        let _e944 = (_e943 < _e109);
                                                        if _e944 {
                                                            if _e944 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e946 = global_10.member[_e943];
                                                            phi_2150_ = _e946;
                                                        } else {
                                                            phi_2150_ = 0u;
                                                        }
                                                        let _e948 = phi_2150_;
                                                        let _e952 = (_e932 + _e429);
                                                        let _e953 = (_e952 < _e109);
                                                        if _e953 {
                                                            if _e953 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e955 = global_10.member[_e952];
                                                            phi_2168_ = _e955;
                                                        } else {
                                                            phi_2168_ = 0u;
                                                        }
                                                        let _e957 = phi_2168_;
                                                        let _e962 = (_e932 + 3u);
                                                        let _e963 = (_e962 + _e428);
                                                        let _e964 = (_e963 < _e109);
                                                        if _e964 {
                                                            if _e964 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e966 = global_10.member[_e963];
                                                            phi_2191_ = _e966;
                                                        } else {
                                                            phi_2191_ = 0u;
                                                        }
                                                        let _e968 = phi_2191_;
                                                        let _e972 = (_e962 + _e427);
                                                        let _e973 = (_e972 < _e109);
                                                        if _e973 {
                                                            if _e973 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e975 = global_10.member[_e972];
                                                            phi_2209_ = _e975;
                                                        } else {
                                                            phi_2209_ = 0u;
                                                        }
                                                        let _e977 = phi_2209_;
                                                        let _e981 = (_e962 + _e429);
                                                        let _e982 = (_e981 < _e109);
                                                        if _e982 {
                                                            if _e982 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e984 = global_10.member[_e981];
                                                            phi_2227_ = _e984;
                                                        } else {
                                                            phi_2227_ = 0u;
                                                        }
                                                        let _e986 = phi_2227_;
                                                        let _e991 = (_e932 + 6u);
                                                        let _e992 = (_e991 + _e428);
                                                        let _e993 = (_e992 < _e109);
                                                        if _e993 {
                                                            if _e993 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e995 = global_10.member[_e992];
                                                            phi_2250_ = _e995;
                                                        } else {
                                                            phi_2250_ = 0u;
                                                        }
                                                        let _e997 = phi_2250_;
                                                        let _e1001 = (_e991 + _e427);
                                                        let _e1002 = (_e1001 < _e109);
                                                        if _e1002 {
                                                            if _e1002 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e1004 = global_10.member[_e1001];
                                                            phi_2268_ = _e1004;
                                                        } else {
                                                            phi_2268_ = 0u;
                                                        }
                                                        let _e1006 = phi_2268_;
                                                        let _e1010 = (_e991 + _e429);
                                                        let _e1011 = (_e1010 < _e109);
                                                        if _e1011 {
                                                            if _e1011 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e1013 = global_10.member[_e1010];
                                                            phi_2286_ = _e1013;
                                                        } else {
                                                            phi_2286_ = 0u;
                                                        }
                                                        let _e1015 = phi_2286_;
                                                        phi_2292_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e939)) * _e165), (f32(bitcast<i32>(_e948)) * _e165), (f32(bitcast<i32>(_e957)) * _e165)), array<f32, 3>((f32(bitcast<i32>(_e968)) * _e165), (f32(bitcast<i32>(_e977)) * _e165), (f32(bitcast<i32>(_e986)) * _e165)), array<f32, 3>((f32(bitcast<i32>(_e997)) * _e165), (f32(bitcast<i32>(_e1006)) * _e165), (f32(bitcast<i32>(_e1015)) * _e165)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2292_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1307 = phi_2292_;
                                                let _e1315 = (_e1307[0][2] - _e608);
                                                let _e1318 = (((_e1307[0][0] - _e475) * _e647) - (_e1315 * _e515));
                                                let _e1321 = (((_e1307[0][1] - _e542) * _e647) - (_e1315 * _e581));
                                                let _e1328 = (_e1307[1][2] - _e608);
                                                let _e1331 = (((_e1307[1][0] - _e475) * _e647) - (_e1328 * _e515));
                                                let _e1334 = (((_e1307[1][1] - _e542) * _e647) - (_e1328 * _e581));
                                                let _e1341 = (_e1307[2][2] - _e608);
                                                let _e1344 = (((_e1307[2][0] - _e475) * _e647) - (_e1341 * _e515));
                                                let _e1347 = (((_e1307[2][1] - _e542) * _e647) - (_e1341 * _e581));
                                                let _e1348 = (_e1344 * _e1334);
                                                let _e1349 = (_e1347 * _e1331);
                                                let _e1350 = (_e1318 * _e1347);
                                                let _e1351 = (_e1321 * _e1344);
                                                let _e1352 = (_e1331 * _e1321);
                                                let _e1353 = (_e1334 * _e1318);
                                                let _e1358 = (((_e1348 >= _e1349) && (_e1350 >= _e1351)) && (_e1352 >= _e1353));
                                                if (_e1358 || (((_e1348 <= _e1349) && (_e1350 <= _e1351)) && (_e1352 <= _e1353))) {
                                                    let _e1365 = select(-1f, 1f, _e1358);
                                                    let _e1367 = ((_e1348 - _e1349) * _e1365);
                                                    let _e1369 = select(0f, _e1367, (_e1367 > 0f));
                                                    let _e1371 = ((_e1350 - _e1351) * _e1365);
                                                    let _e1373 = select(0f, _e1371, (_e1371 > 0f));
                                                    let _e1375 = ((_e1352 - _e1353) * _e1365);
                                                    let _e1377 = select(0f, _e1375, (_e1375 > 0f));
                                                    let _e1379 = ((_e1369 + _e1373) + _e1377);
                                                    if (_e1379 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_3176_ = type_21();
                                                        phi_3177_ = true;
                                                        phi_3178_ = false;
                                                    } else {
                                                        let _e1382 = select(_e1331, _e1318, (_e1318 < _e1331));
                                                        if (select(_e1344, _e1382, (_e1382 < _e1344)) > 0f) {
                                                            phi_2444_ = true;
                                                        } else {
                                                            let _e1387 = select(_e1331, _e1318, (_e1318 > _e1331));
                                                            phi_2444_ = (select(_e1344, _e1387, (_e1387 > _e1344)) < 0f);
                                                        }
                                                        let _e1392 = phi_2444_;
                                                        if _e1392 {
                                                            phi_3173_ = type_21();
                                                            phi_3174_ = true;
                                                            phi_3175_ = false;
                                                        } else {
                                                            let _e1394 = select(_e1334, _e1321, (_e1321 < _e1334));
                                                            if (select(_e1347, _e1394, (_e1394 < _e1347)) > 0f) {
                                                                phi_2473_ = true;
                                                            } else {
                                                                let _e1399 = select(_e1334, _e1321, (_e1321 > _e1334));
                                                                phi_2473_ = (select(_e1347, _e1399, (_e1399 > _e1347)) < 0f);
                                                            }
                                                            let _e1404 = phi_2473_;
                                                            if _e1404 {
                                                                phi_3171_ = type_21();
                                                                phi_3172_ = false;
                                                            } else {
                                                                let _e1406 = select(_e1307[1][0], _e1307[0][0], (_e1307[0][0] < _e1307[1][0]));
                                                                let _e1410 = select(_e1307[1][0], _e1307[0][0], (_e1307[0][0] > _e1307[1][0]));
                                                                let _e1414 = select(_e1307[1][1], _e1307[0][1], (_e1307[0][1] < _e1307[1][1]));
                                                                let _e1418 = select(_e1307[1][1], _e1307[0][1], (_e1307[0][1] > _e1307[1][1]));
                                                                let _e1422 = select(_e1307[1][2], _e1307[0][2], (_e1307[0][2] < _e1307[1][2]));
                                                                let _e1426 = select(_e1307[1][2], _e1307[0][2], (_e1307[0][2] > _e1307[1][2]));
                                                                let _e1431 = ((select(_e1307[2][0], _e1406, (_e1406 < _e1307[2][0])) - _e513) * _e518);
                                                                let _e1432 = ((select(_e1307[2][0], _e1410, (_e1410 > _e1307[2][0])) - _e514) * _e518);
                                                                let _e1435 = ((select(_e1307[2][1], _e1414, (_e1414 < _e1307[2][1])) - _e579) * _e584);
                                                                let _e1436 = ((select(_e1307[2][1], _e1418, (_e1418 > _e1307[2][1])) - _e580) * _e584);
                                                                let _e1439 = ((select(_e1307[2][2], _e1422, (_e1422 < _e1307[2][2])) - _e645) * _e650);
                                                                let _e1440 = ((select(_e1307[2][2], _e1426, (_e1426 > _e1307[2][2])) - _e646) * _e650);
                                                                let _e1442 = select(_e1440, _e1439, (_e1439 < _e1440));
                                                                let _e1444 = select(_e1440, _e1439, (_e1439 > _e1440));
                                                                let _e1446 = select(_e1432, _e1431, (_e1431 < _e1432));
                                                                let _e1448 = select(_e1436, _e1435, (_e1435 < _e1436));
                                                                let _e1450 = select(_e1448, _e1446, (_e1446 > _e1448));
                                                                let _e1452 = select(_e1442, _e1450, (_e1450 > _e1442));
                                                                let _e1454 = select(_e1432, _e1431, (_e1431 > _e1432));
                                                                let _e1456 = select(_e1436, _e1435, (_e1435 > _e1436));
                                                                let _e1458 = select(_e1456, _e1454, (_e1454 < _e1456));
                                                                let _e1460 = select(_e1444, _e1458, (_e1458 < _e1444));
                                                                let _e1461 = -(_e1442);
                                                                let _e1467 = select(_e761, _e1452, (_e1452 > _e761));
                                                                if (_e1467 > (_e1460 + (select(_e1461, _e1444, (_e1444 > _e1461)) * 0.0000019073523f))) {
                                                                    phi_3166_ = type_21();
                                                                    phi_3167_ = true;
                                                                } else {
                                                                    let _e1469 = (_e1467 > _e860.member_1);
                                                                    if _e1469 {
                                                                        phi_3165_ = type_21();
                                                                    } else {
                                                                        let _e1470 = vec3<f32>(_e1307[0][0], _e1307[0][1], _e1307[0][2]);
                                                                        let _e1471 = vec3<f32>(_e1307[1][0], _e1307[1][1], _e1307[1][2]);
                                                                        let _e1472 = vec3<f32>(_e1307[2][0], _e1307[2][1], _e1307[2][2]);
                                                                        let _e1473 = (_e1307[1][0] - _e1307[0][0]);
                                                                        let _e1474 = (_e1307[1][1] - _e1307[0][1]);
                                                                        let _e1475 = (_e1307[1][2] - _e1307[0][2]);
                                                                        let _e1476 = vec3<f32>(_e1473, _e1474, _e1475);
                                                                        let _e1477 = (_e1307[2][0] - _e1307[1][0]);
                                                                        let _e1478 = (_e1307[2][1] - _e1307[1][1]);
                                                                        let _e1479 = (_e1307[2][2] - _e1307[1][2]);
                                                                        let _e1480 = vec3<f32>(_e1477, _e1478, _e1479);
                                                                        let _e1481 = (_e1307[0][0] - _e1307[2][0]);
                                                                        let _e1482 = (_e1307[0][1] - _e1307[2][1]);
                                                                        let _e1483 = (_e1307[0][2] - _e1307[2][2]);
                                                                        let _e1484 = vec3<f32>(_e1481, _e1482, _e1483);
                                                                        let _e1487 = bitcast<f32>((bitcast<u32>(_e1473) & 2147483647u));
                                                                        let _e1490 = bitcast<f32>((bitcast<u32>(_e1474) & 2147483647u));
                                                                        let _e1492 = select(_e1490, _e1487, (_e1487 > _e1490));
                                                                        let _e1495 = bitcast<f32>((bitcast<u32>(_e1475) & 2147483647u));
                                                                        let _e1497 = select(_e1495, _e1492, (_e1492 > _e1495));
                                                                        let _e1500 = bitcast<f32>((bitcast<u32>(_e1477) & 2147483647u));
                                                                        let _e1503 = bitcast<f32>((bitcast<u32>(_e1478) & 2147483647u));
                                                                        let _e1505 = select(_e1503, _e1500, (_e1500 > _e1503));
                                                                        let _e1508 = bitcast<f32>((bitcast<u32>(_e1479) & 2147483647u));
                                                                        let _e1510 = select(_e1508, _e1505, (_e1505 > _e1508));
                                                                        let _e1513 = bitcast<f32>((bitcast<u32>(_e1481) & 2147483647u));
                                                                        let _e1516 = bitcast<f32>((bitcast<u32>(_e1482) & 2147483647u));
                                                                        let _e1518 = select(_e1516, _e1513, (_e1513 > _e1516));
                                                                        let _e1521 = bitcast<f32>((bitcast<u32>(_e1483) & 2147483647u));
                                                                        let _e1523 = select(_e1521, _e1518, (_e1518 > _e1521));
                                                                        let _e1525 = select(_e1510, _e1497, (_e1497 > _e1510));
                                                                        let _e1527 = select(_e1523, _e1525, (_e1525 > _e1523));
                                                                        if (_e1497 == _e1527) {
                                                                            phi_2892_ = _e1334;
                                                                            phi_2893_ = _e1331;
                                                                            phi_2894_ = _e1321;
                                                                            phi_2895_ = _e1318;
                                                                            phi_2896_ = _e1470;
                                                                            phi_2897_ = _e1484;
                                                                            phi_2898_ = _e1480;
                                                                            phi_2899_ = _e1476;
                                                                        } else {
                                                                            let _e1529 = (_e1510 == _e1527);
                                                                            let _e1534 = vec3(_e1529);
                                                                            phi_2892_ = select(_e1321, _e1347, _e1529);
                                                                            phi_2893_ = select(_e1318, _e1344, _e1529);
                                                                            phi_2894_ = select(_e1347, _e1334, _e1529);
                                                                            phi_2895_ = select(_e1344, _e1331, _e1529);
                                                                            phi_2896_ = select(_e1472, _e1471, _e1534);
                                                                            phi_2897_ = select(_e1480, _e1476, _e1534);
                                                                            phi_2898_ = select(_e1476, _e1484, _e1534);
                                                                            phi_2899_ = select(_e1484, _e1480, _e1534);
                                                                        }
                                                                        let _e1540 = phi_2892_;
                                                                        let _e1542 = phi_2893_;
                                                                        let _e1544 = phi_2894_;
                                                                        let _e1546 = phi_2895_;
                                                                        let _e1548 = phi_2896_;
                                                                        let _e1550 = phi_2897_;
                                                                        let _e1552 = phi_2898_;
                                                                        let _e1554 = phi_2899_;
                                                                        let _e1561 = ((_e1552.y * _e1550.z) - (_e1550.y * _e1552.z));
                                                                        let _e1566 = ((_e1552.z * _e1550.x) - (_e1550.z * _e1552.x));
                                                                        let _e1569 = ((_e1552.x * _e1550.y) - (_e1550.x * _e1552.y));
                                                                        if (_e1369 >= _e1373) {
                                                                            phi_2936_ = select(true, false, (_e1369 >= _e1377));
                                                                        } else {
                                                                            phi_2936_ = true;
                                                                        }
                                                                        let _e1574 = phi_2936_;
                                                                        if _e1574 {
                                                                            phi_2945_ = select(_e1472, _e1471, vec3((_e1373 >= _e1377)));
                                                                        } else {
                                                                            phi_2945_ = _e1470;
                                                                        }
                                                                        let _e1579 = phi_2945_;
                                                                        let _e1590 = (((_e1561 * (_e1579.x - _e475)) + (_e1566 * (_e1579.y - _e542))) + (_e1569 * (_e1579.z - _e608)));
                                                                        let _e1595 = (((_e1561 * _e515) + (_e1566 * _e581)) + (_e1569 * _e647));
                                                                        let _e1596 = (_e1542 - _e1546);
                                                                        let _e1597 = (_e1540 - _e1544);
                                                                        let _e1605 = (-(((_e1546 * _e1596) + (_e1544 * _e1597))) / ((_e1596 * _e1596) + (_e1597 * _e1597)));
                                                                        let _e1607 = select(1f, _e1605, (_e1605 < 1f));
                                                                        let _e1609 = select(0f, _e1607, (_e1607 > 0f));
                                                                        let _e1622 = ((_e1548.x + (_e1554.x * _e1609)) - _e475);
                                                                        let _e1623 = ((_e1548.y + (_e1554.y * _e1609)) - _e542);
                                                                        let _e1624 = ((_e1548.z + (_e1554.z * _e1609)) - _e608);
                                                                        let _e1625 = (_e1624 / _e647);
                                                                        let _e1637 = bitcast<f32>((bitcast<u32>(_e1622) & 2147483647u));
                                                                        let _e1640 = bitcast<f32>((bitcast<u32>(_e1623) & 2147483647u));
                                                                        let _e1642 = select(_e1640, _e1637, (_e1637 > _e1640));
                                                                        let _e1645 = bitcast<f32>((bitcast<u32>(_e1624) & 2147483647u));
                                                                        let _e1647 = select(_e1645, _e1642, (_e1642 > _e1645));
                                                                        let _e1653 = bitcast<f32>((bitcast<u32>(_e1561) & 2147483647u));
                                                                        let _e1656 = bitcast<f32>((bitcast<u32>(_e1566) & 2147483647u));
                                                                        let _e1658 = select(_e1656, _e1653, (_e1653 > _e1656));
                                                                        let _e1661 = bitcast<f32>((bitcast<u32>(_e1569) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1561 * _e1622) + (_e1566 * _e1623)) + (_e1569 * _e1624)) - _e1590)) & 2147483647u)) <= ((0.0000009536743f * select(_e1527, _e1647, (_e1647 > _e1527))) * select(_e1661, _e1658, (_e1658 > _e1661)))) {
                                                                            let _e1671 = bitcast<f32>((bitcast<u32>(_e1552.x) & 2147483647u));
                                                                            let _e1674 = bitcast<f32>((bitcast<u32>(_e1552.y) & 2147483647u));
                                                                            let _e1676 = select(_e1674, _e1671, (_e1671 > _e1674));
                                                                            let _e1679 = bitcast<f32>((bitcast<u32>(_e1552.z) & 2147483647u));
                                                                            let _e1685 = bitcast<f32>((bitcast<u32>(_e1550.x) & 2147483647u));
                                                                            let _e1688 = bitcast<f32>((bitcast<u32>(_e1550.y) & 2147483647u));
                                                                            let _e1690 = select(_e1688, _e1685, (_e1685 > _e1688));
                                                                            let _e1693 = bitcast<f32>((bitcast<u32>(_e1550.z) & 2147483647u));
                                                                            let _e1697 = (bitcast<f32>((bitcast<u32>(_e1595) & 2147483647u)) > ((0.0000038146973f * select(_e1679, _e1676, (_e1676 > _e1679))) * select(_e1693, _e1690, (_e1690 > _e1693))));
                                                                            if _e1697 {
                                                                                phi_3110_ = (_e1590 / _e1595);
                                                                            } else {
                                                                                phi_3110_ = f32();
                                                                            }
                                                                            let _e1700 = phi_3110_;
                                                                            phi_3112_ = _e1700;
                                                                            phi_3113_ = select(true, false, _e1697);
                                                                        } else {
                                                                            phi_3112_ = f32();
                                                                            phi_3113_ = true;
                                                                        }
                                                                        let _e1703 = phi_3112_;
                                                                        let _e1705 = phi_3113_;
                                                                        if _e1705 {
                                                                            let _e1713 = (((_e1561 * (_e1622 - (_e515 * _e1625))) + (_e1566 * (_e1623 - (_e581 * _e1625)))) / _e1595);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1713) & 2147483647u)) <= _e1527) {
                                                                                phi_3133_ = (_e1625 + _e1713);
                                                                            } else {
                                                                                phi_3133_ = _e1625;
                                                                            }
                                                                            let _e1720 = phi_3133_;
                                                                            phi_3134_ = _e1720;
                                                                        } else {
                                                                            phi_3134_ = _e1703;
                                                                        }
                                                                        let _e1722 = phi_3134_;
                                                                        let _e1724 = select(_e1460, _e1722, (_e1722 < _e1460));
                                                                        let _e1726 = select(_e1452, _e1724, (_e1724 > _e1452));
                                                                        if (_e1726 >= _e761) {
                                                                            let _e1728 = (_e1726 <= _e860.member_1);
                                                                            if _e1728 {
                                                                                let _e1729 = (1f / _e1379);
                                                                                phi_3157_ = type_21(_e1726, (_e1373 * _e1729), (_e1377 * _e1729), _e920);
                                                                            } else {
                                                                                phi_3157_ = type_21();
                                                                            }
                                                                            let _e1734 = phi_3157_;
                                                                            phi_3159_ = _e1734;
                                                                            phi_3160_ = select(true, false, _e1728);
                                                                        } else {
                                                                            phi_3159_ = type_21();
                                                                            phi_3160_ = true;
                                                                        }
                                                                        let _e1737 = phi_3159_;
                                                                        let _e1739 = phi_3160_;
                                                                        if _e1739 {
                                                                            phi_3164_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_3164_ = _e1737;
                                                                        }
                                                                        let _e1741 = phi_3164_;
                                                                        phi_3165_ = _e1741;
                                                                    }
                                                                    let _e1743 = phi_3165_;
                                                                    phi_3166_ = _e1743;
                                                                    phi_3167_ = _e1469;
                                                                }
                                                                let _e1745 = phi_3166_;
                                                                let _e1747 = phi_3167_;
                                                                phi_3171_ = _e1745;
                                                                phi_3172_ = _e1747;
                                                            }
                                                            let _e1749 = phi_3171_;
                                                            let _e1751 = phi_3172_;
                                                            phi_3173_ = _e1749;
                                                            phi_3174_ = _e1404;
                                                            phi_3175_ = _e1751;
                                                        }
                                                        let _e1753 = phi_3173_;
                                                        let _e1755 = phi_3174_;
                                                        let _e1757 = phi_3175_;
                                                        phi_3176_ = _e1753;
                                                        phi_3177_ = _e1755;
                                                        phi_3178_ = _e1757;
                                                    }
                                                    let _e1759 = phi_3176_;
                                                    let _e1761 = phi_3177_;
                                                    let _e1763 = phi_3178_;
                                                    phi_3186_ = _e1759;
                                                    phi_3187_ = select(_e1763, true, _e1761);
                                                } else {
                                                    phi_3186_ = type_21();
                                                    phi_3187_ = true;
                                                }
                                                let _e1766 = phi_3186_;
                                                let _e1768 = phi_3187_;
                                                if _e1768 {
                                                    phi_3191_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_3191_ = _e1766;
                                                }
                                                let _e1770 = phi_3191_;
                                                if (_e1770.member_3 != 4294967295u) {
                                                    if (_e920 == _e174) {
                                                        phi_3526_ = false;
                                                    } else {
                                                        let _e1774 = (_e920 < arrayLength((&global_4.member)));
                                                        if _e1774 {
                                                            if _e1774 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e1776 = global_4.member[_e920];
                                                            phi_3214_ = _e1776;
                                                        } else {
                                                            phi_3214_ = 4294967295u;
                                                        }
                                                        let _e1778 = phi_3214_;
                                                        let _e1779 = (_e1778 < arrayLength((&global_5.member)));
                                                        if _e1779 {
                                                            if _e1779 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e1781 = global_5.member[_e1778];
                                                            phi_3228_ = _e1781;
                                                        } else {
                                                            phi_3228_ = 0i;
                                                        }
                                                        let _e1783 = phi_3228_;
                                                        let _e1784 = (_e1783 == 0i);
                                                        if _e1784 {
                                                            phi_3525_ = true;
                                                        } else {
                                                            if _e452 {
                                                                phi_3251_ = vec3<f32>(_e1307[0][0], _e1307[0][1], _e1307[0][2]);
                                                            } else {
                                                                if (_e428 == 1u) {
                                                                    phi_3250_ = vec3<f32>(_e1307[0][2], _e1307[0][0], _e1307[0][1]);
                                                                } else {
                                                                    phi_3250_ = vec3<f32>(_e1307[0][1], _e1307[0][2], _e1307[0][0]);
                                                                }
                                                                let _e1789 = phi_3250_;
                                                                phi_3251_ = _e1789;
                                                            }
                                                            let _e1792 = phi_3251_;
                                                            if _e452 {
                                                                phi_3270_ = vec3<f32>(_e1307[1][0], _e1307[1][1], _e1307[1][2]);
                                                            } else {
                                                                if (_e428 == 1u) {
                                                                    phi_3269_ = vec3<f32>(_e1307[1][2], _e1307[1][0], _e1307[1][1]);
                                                                } else {
                                                                    phi_3269_ = vec3<f32>(_e1307[1][1], _e1307[1][2], _e1307[1][0]);
                                                                }
                                                                let _e1797 = phi_3269_;
                                                                phi_3270_ = _e1797;
                                                            }
                                                            let _e1800 = phi_3270_;
                                                            if _e452 {
                                                                phi_3289_ = vec3<f32>(_e1307[2][0], _e1307[2][1], _e1307[2][2]);
                                                            } else {
                                                                if (_e428 == 1u) {
                                                                    phi_3288_ = vec3<f32>(_e1307[2][2], _e1307[2][0], _e1307[2][1]);
                                                                } else {
                                                                    phi_3288_ = vec3<f32>(_e1307[2][1], _e1307[2][2], _e1307[2][0]);
                                                                }
                                                                let _e1805 = phi_3288_;
                                                                phi_3289_ = _e1805;
                                                            }
                                                            let _e1808 = phi_3289_;
                                                            let _e1811 = (_e1800.x - _e1792.x);
                                                            let _e1814 = (_e1800.y - _e1792.y);
                                                            let _e1817 = (_e1800.z - _e1792.z);
                                                            let _e1819 = (_e1808.x - _e1792.x);
                                                            let _e1821 = (_e1808.y - _e1792.y);
                                                            let _e1823 = (_e1808.z - _e1792.z);
                                                            if (_e306.member_1 == 1u) {
                                                                phi_3325_ = (vec3<f32>(_e306.member[0], _e306.member[1], _e306.member[2]) - _e1792);
                                                            } else {
                                                                phi_3325_ = vec3<f32>(_e306.member[0], _e306.member[1], _e306.member[2]);
                                                            }
                                                            let _e1838 = phi_3325_;
                                                            let _e1844 = bitcast<f32>((bitcast<u32>((_e1811 * _e1821)) ^ _e306.member_3[0]));
                                                            let _e1848 = bitcast<f32>((bitcast<u32>((_e1814 * _e1819)) ^ _e306.member_3[0]));
                                                            let _e1852 = bitcast<f32>((bitcast<u32>((_e1814 * _e1823)) ^ _e306.member_3[0]));
                                                            let _e1856 = bitcast<f32>((bitcast<u32>((_e1817 * _e1821)) ^ _e306.member_3[0]));
                                                            let _e1860 = bitcast<f32>((bitcast<u32>((_e1817 * _e1819)) ^ _e306.member_3[0]));
                                                            let _e1864 = bitcast<f32>((bitcast<u32>((_e1811 * _e1823)) ^ _e306.member_3[0]));
                                                            let _e1865 = (_e1852 - _e1856);
                                                            let _e1866 = (_e1860 - _e1864);
                                                            let _e1867 = (_e1844 - _e1848);
                                                            let _e1891 = (bitcast<f32>((bitcast<u32>(_e1852) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1856) & 2147483647u)));
                                                            let _e1898 = (bitcast<f32>((bitcast<u32>(_e1860) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1864) & 2147483647u)));
                                                            let _e1905 = (bitcast<f32>((bitcast<u32>(_e1844) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1848) & 2147483647u)));
                                                            if (_e306.member_2 == 0f) {
                                                                phi_3507_ = 0f;
                                                            } else {
                                                                let _e1935 = bitcast<f32>((bitcast<u32>(_e1865) & 2147483647u));
                                                                let _e1938 = bitcast<f32>((bitcast<u32>(_e1866) & 2147483647u));
                                                                let _e1941 = bitcast<f32>((bitcast<u32>(_e1867) & 2147483647u));
                                                                let _e1943 = select(_e1941, _e1938, (_e1938 > _e1941));
                                                                let _e1947 = select(_e1941, _e1938, (_e1938 < _e1941));
                                                                let _e1951 = select(_e1938, _e1935, (_e1935 < _e1938));
                                                                let _e1953 = select(_e1938, _e1935, (_e1935 > _e1938));
                                                                let _e1955 = select(_e1941, _e1953, (_e1953 < _e1941));
                                                                phi_3507_ = bitcast<f32>((bitcast<u32>((_e306.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1943, _e1935, (_e1935 > _e1943)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1955, _e1951, (_e1951 > _e1955)))) ^ _e306.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1947, _e1935, (_e1935 < _e1947)))) ^ _e306.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1891 + _e1898) + _e1905))) ^ _e306.member_3[0]))) * 1.0000005f)) ^ _e306.member_3[0])))) ^ _e306.member_3[0]));
                                                            }
                                                            let _e1982 = phi_3507_;
                                                            phi_3525_ = (_e1784 || !(((((bitcast<f32>((bitcast<u32>((_e1838.x * _e1865)) ^ _e306.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1838.y * _e1866)) ^ _e306.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1838.z * _e1867)) ^ _e306.member_3[0]))) * f32(-(_e1783))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1838.x) & 2147483647u)) * _e1891)) ^ _e306.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1838.y) & 2147483647u)) * _e1898)) ^ _e306.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1838.z) & 2147483647u)) * _e1905)) ^ _e306.member_3[0]))))) ^ _e306.member_3[0])) + _e1982) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1996 = phi_3525_;
                                                        phi_3526_ = _e1996;
                                                    }
                                                    let _e1998 = phi_3526_;
                                                    if _e1998 {
                                                        if (_e1770.member < _e860.member.member) {
                                                            phi_3546_ = true;
                                                        } else {
                                                            if (_e1770.member == _e860.member.member) {
                                                                phi_3545_ = (_e1770.member_3 < _e860.member.member_3);
                                                            } else {
                                                                phi_3545_ = false;
                                                            }
                                                            let _e2008 = phi_3545_;
                                                            phi_3546_ = _e2008;
                                                        }
                                                        let _e2010 = phi_3546_;
                                                        if _e2010 {
                                                            phi_3552_ = type_39(_e1770, _e1770.member);
                                                        } else {
                                                            phi_3552_ = _e860;
                                                        }
                                                        let _e2013 = phi_3552_;
                                                        phi_3553_ = _e2013;
                                                    } else {
                                                        phi_3553_ = _e860;
                                                    }
                                                    let _e2015 = phi_3553_;
                                                    phi_3554_ = _e2015;
                                                } else {
                                                    phi_3554_ = _e860;
                                                }
                                                let _e2017 = phi_3554_;
                                                phi_1529_ = _e2017;
                                            } else {
                                                phi_1529_ = type_39();
                                            }
                                            let _e2019 = phi_1529_;
                                            continue;
                                            continuing {
                                                phi_1528_ = _e2019;
                                                phi_1531_ = _e875;
                                                phi_5274_ = _e803;
                                                break if !(_e881);
                                            }
                                        }
                                        let _e2022 = phi_5274_;
                                        phi_5513_ = _e2022;
                                        if _e2022 {
                                            break;
                                        }
                                        phi_5604_ = _e2022;
                                        let _e2849 = local_11;
                                        phi_3555_ = _e2849;
                                    } else {
                                        phi_5604_ = _e803;
                                        phi_3555_ = _e805;
                                    }
                                    let _e2024 = phi_5604_;
                                    let _e2026 = phi_3555_;
                                    if _e852 {
                                        phi_4820_ = bool();
                                        phi_4821_ = u32();
                                        phi_4822_ = type_57();
                                    } else {
                                        if (_e848.member_1 >= _e106) {
                                            phi_4356_ = type_58(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_57(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_57(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e848.member_1 < _e106) {
                                            } else {
                                                phi_5513_ = true;
                                                break;
                                            }
                                            let _e2029 = (_e428 * 2u);
                                            let _e2031 = ((1u + _e2029) % 7u);
                                            if (_e2031 < 7u) {
                                            } else {
                                                phi_5513_ = true;
                                                break;
                                            }
                                            let _e2036 = global_9.member[_e848.member_1][_e2031];
                                            let _e2038 = ((_e2029 + 2u) % 7u);
                                            if (_e2038 < 7u) {
                                            } else {
                                                phi_5513_ = true;
                                                break;
                                            }
                                            let _e2043 = global_9.member[_e848.member_1][_e2038];
                                            let _e2044 = (_e427 * 2u);
                                            let _e2046 = ((1u + _e2044) % 7u);
                                            if (_e2046 < 7u) {
                                            } else {
                                                phi_5513_ = true;
                                                break;
                                            }
                                            let _e2051 = global_9.member[_e848.member_1][_e2046];
                                            let _e2053 = ((_e2044 + 2u) % 7u);
                                            if (_e2053 < 7u) {
                                            } else {
                                                phi_5513_ = true;
                                                break;
                                            }
                                            let _e2058 = global_9.member[_e848.member_1][_e2053];
                                            let _e2059 = (_e429 * 2u);
                                            let _e2061 = ((1u + _e2059) % 7u);
                                            if (_e2061 < 7u) {
                                            } else {
                                                phi_5513_ = true;
                                                break;
                                            }
                                            let _e2066 = global_9.member[_e848.member_1][_e2061];
                                            let _e2068 = ((_e2059 + 2u) % 7u);
                                            if (_e2068 < 7u) {
                                            } else {
                                                phi_5513_ = true;
                                                break;
                                            }
                                            let _e2073 = global_9.member[_e848.member_1][_e2068];
                                            let _e2096 = (bitcast<f32>((bitcast<u32>((_e848.member.member_1.x - _e848.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e2097 = (bitcast<f32>((bitcast<u32>((_e848.member.member_1.y - _e848.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e2098 = (bitcast<f32>((bitcast<u32>((_e848.member.member_1.z - _e848.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e2100 = select(_e165, _e2096, (_e2096 > _e165));
                                            let _e2102 = select(_e165, _e2097, (_e2097 > _e165));
                                            let _e2104 = select(_e165, _e2098, (_e2098 > _e165));
                                            let _e2135 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2036 & 2097151u))) - 8388608f) * _e2100));
                                            let _e2140 = (bitcast<i32>((_e2036 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e2143 = bitcast<f32>((_e2135 & bitcast<u32>(_e2140)));
                                            let _e2144 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2051 & 2097151u))) - 8388608f) * _e2102));
                                            let _e2149 = (bitcast<i32>((_e2051 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e2152 = bitcast<f32>((_e2144 & bitcast<u32>(_e2149)));
                                            let _e2153 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2066 & 2097151u))) - 8388608f) * _e2104));
                                            let _e2158 = (bitcast<i32>((_e2066 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e2161 = bitcast<f32>((_e2153 & bitcast<u32>(_e2158)));
                                            let _e2165 = bitcast<f32>((_e2135 & bitcast<u32>(~(_e2140))));
                                            let _e2169 = bitcast<f32>((_e2144 & bitcast<u32>(~(_e2149))));
                                            let _e2173 = bitcast<f32>((_e2153 & bitcast<u32>(~(_e2158))));
                                            let _e2174 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2043 & 2097151u))) - 8388608f) * _e2100));
                                            let _e2179 = (bitcast<i32>((_e2043 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e2182 = bitcast<f32>((_e2174 & bitcast<u32>(_e2179)));
                                            let _e2183 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2058 & 2097151u))) - 8388608f) * _e2102));
                                            let _e2188 = (bitcast<i32>((_e2058 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e2191 = bitcast<f32>((_e2183 & bitcast<u32>(_e2188)));
                                            let _e2192 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2073 & 2097151u))) - 8388608f) * _e2104));
                                            let _e2197 = (bitcast<i32>((_e2073 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e2200 = bitcast<f32>((_e2192 & bitcast<u32>(_e2197)));
                                            let _e2204 = bitcast<f32>((_e2174 & bitcast<u32>(~(_e2179))));
                                            let _e2208 = bitcast<f32>((_e2183 & bitcast<u32>(~(_e2188))));
                                            let _e2212 = bitcast<f32>((_e2192 & bitcast<u32>(~(_e2197))));
                                            let _e2213 = (_e848.member.member.x + _e2143);
                                            let _e2214 = (_e848.member.member.y + _e2152);
                                            let _e2215 = (_e848.member.member.z + _e2161);
                                            let _e2218 = (_e848.member.member_1.x - _e2182);
                                            let _e2219 = (_e848.member.member_1.y - _e2191);
                                            let _e2220 = (_e848.member.member_1.z - _e2200);
                                            let _e2239 = (_e2218 - _e2213);
                                            let _e2240 = (_e2219 - _e2214);
                                            let _e2241 = (_e2220 - _e2215);
                                            let _e2243 = select(_e2240, _e2239, (_e2239 > _e2240));
                                            let _e2245 = select(_e2241, _e2243, (_e2243 > _e2241));
                                            if (_e2245 < (1024f * _e165)) {
                                                phi_4057_ = 0u;
                                            } else {
                                                phi_4057_ = select(2u, 1u, (_e2245 < (2097152f * _e165)));
                                            }
                                            let _e2252 = phi_4057_;
                                            switch bitcast<i32>(_e2252) {
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
                                            let _e2255 = phi_4063_;
                                            let _e2261 = global_9.member[_e848.member_1][0u];
                                            let _e2265 = global_9.member[_e848.member_1][2u];
                                            let _e2269 = global_9.member[_e848.member_1][4u];
                                            let _e2273 = global_9.member[_e848.member_1][6u];
                                            let _e2285 = (((_e2265 >> bitcast<u32>(22i)) | ((_e2269 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e2273 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e2286 = (_e2261 & 268435455u);
                                            let _e2287 = (_e2285 & 268435455u);
                                            let _e2290 = ((_e2261 >> bitcast<u32>(28u)) & 7u);
                                            let _e2298 = ((_e2261 >> bitcast<u32>(31i)) | (((_e2285 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e2299 = (_e2290 != 0u);
                                            if (_e2290 == 0u) {
                                                phi_4318_ = _e2286;
                                            } else {
                                                if (_e2290 == 7u) {
                                                    phi_4317_ = 2147483648u;
                                                } else {
                                                    phi_4317_ = ((2147483648u | (_e2290 << bitcast<u32>(28u))) | (_e2287 & 268435455u));
                                                }
                                                let _e2308 = phi_4317_;
                                                phi_4318_ = _e2308;
                                            }
                                            let _e2310 = phi_4318_;
                                            if _e2299 {
                                                let _e2311 = (_e2290 != 7u);
                                                if _e2311 {
                                                    phi_4328_ = (_e2287 + (_e2290 * ((3u * _e2255) + 1u)));
                                                } else {
                                                    phi_4328_ = u32();
                                                }
                                                let _e2315 = phi_4328_;
                                                phi_4330_ = _e2315;
                                                phi_4331_ = select(true, false, _e2311);
                                            } else {
                                                phi_4330_ = u32();
                                                phi_4331_ = true;
                                            }
                                            let _e2318 = phi_4330_;
                                            let _e2320 = phi_4331_;
                                            if (_e2298 == 0u) {
                                                phi_4352_ = (_e2286 + select(0u, 1u, !(_e2299)));
                                            } else {
                                                if (_e2298 == 7u) {
                                                    phi_4351_ = 2147483648u;
                                                } else {
                                                    phi_4351_ = ((2147483648u | (_e2298 << bitcast<u32>(28u))) | (select(_e2318, _e2287, _e2320) & 268435455u));
                                                }
                                                let _e2333 = phi_4351_;
                                                phi_4352_ = _e2333;
                                            }
                                            let _e2335 = phi_4352_;
                                            phi_4356_ = type_58(array<vec4<f32>, 3>(vec4<f32>(_e2213, (_e848.member.member.x + _e2165), _e2218, (_e848.member.member_1.x - _e2204)), vec4<f32>(_e2214, (_e848.member.member.y + _e2169), _e2219, (_e848.member.member_1.y - _e2208)), vec4<f32>(_e2215, (_e848.member.member.z + _e2173), _e2220, (_e848.member.member_1.z - _e2212))), type_57(type_33((_e848.member.member + vec4<f32>(_e2143, _e2152, _e2161, 0f)), (_e848.member.member_1 - vec4<f32>(_e2182, _e2191, _e2200, 0f))), _e2310), type_57(type_33((_e848.member.member + vec4<f32>(_e2165, _e2169, _e2173, 0f)), (_e848.member.member_1 - vec4<f32>(_e2204, _e2208, _e2212, 0f))), _e2335));
                                        }
                                        let _e2340 = phi_4356_;
                                        let _e2352 = ((_e2340.member[0].x - _e513) * _e518);
                                        let _e2353 = ((_e2340.member[0].y - _e513) * _e518);
                                        let _e2354 = ((_e2340.member[0].z - _e514) * _e518);
                                        let _e2355 = ((_e2340.member[0].w - _e514) * _e518);
                                        let _e2365 = ((_e2340.member[1].x - _e579) * _e584);
                                        let _e2366 = ((_e2340.member[1].y - _e579) * _e584);
                                        let _e2367 = ((_e2340.member[1].z - _e580) * _e584);
                                        let _e2368 = ((_e2340.member[1].w - _e580) * _e584);
                                        let _e2378 = ((_e2340.member[2].x - _e645) * _e650);
                                        let _e2379 = ((_e2340.member[2].y - _e645) * _e650);
                                        let _e2380 = ((_e2340.member[2].z - _e646) * _e650);
                                        let _e2381 = ((_e2340.member[2].w - _e646) * _e650);
                                        let _e2383 = select(_e2380, _e2378, (_e2378 < _e2380));
                                        let _e2385 = select(_e2381, _e2379, (_e2379 < _e2381));
                                        let _e2387 = select(_e2380, _e2378, (_e2378 > _e2380));
                                        let _e2389 = select(_e2381, _e2379, (_e2379 > _e2381));
                                        let _e2391 = select(_e2354, _e2352, (_e2352 < _e2354));
                                        let _e2393 = select(_e2355, _e2353, (_e2353 < _e2355));
                                        let _e2395 = select(_e2367, _e2365, (_e2365 < _e2367));
                                        let _e2397 = select(_e2368, _e2366, (_e2366 < _e2368));
                                        let _e2399 = select(_e2395, _e2391, (_e2391 > _e2395));
                                        let _e2401 = select(_e2397, _e2393, (_e2393 > _e2397));
                                        let _e2403 = select(_e2383, _e2399, (_e2399 > _e2383));
                                        let _e2405 = select(_e2385, _e2401, (_e2401 > _e2385));
                                        let _e2407 = select(_e2354, _e2352, (_e2352 > _e2354));
                                        let _e2409 = select(_e2355, _e2353, (_e2353 > _e2355));
                                        let _e2411 = select(_e2367, _e2365, (_e2365 > _e2367));
                                        let _e2413 = select(_e2368, _e2366, (_e2366 > _e2368));
                                        let _e2415 = select(_e2411, _e2407, (_e2407 < _e2411));
                                        let _e2417 = select(_e2413, _e2409, (_e2409 < _e2413));
                                        let _e2422 = -(_e2383);
                                        let _e2423 = -(_e2385);
                                        let _e2430 = (select(_e2387, _e2415, (_e2415 < _e2387)) + (select(_e2422, _e2387, (_e2387 > _e2422)) * 0.0000019073523f));
                                        let _e2431 = (select(_e2389, _e2417, (_e2417 < _e2389)) + (select(_e2423, _e2389, (_e2389 > _e2423)) * 0.0000019073523f));
                                        let _e2433 = select(_e761, _e2403, (_e2403 > _e761));
                                        let _e2435 = select(_e761, _e2405, (_e2405 > _e761));
                                        let _e2440 = (_e2433 <= select(_e2026.member_1, _e2430, (_e2430 < _e2026.member_1)));
                                        let _e2441 = (_e2435 <= select(_e2026.member_1, _e2431, (_e2431 < _e2026.member_1)));
                                        let _e2442 = (_e2433 <= _e2435);
                                        if _e2440 {
                                            if _e2441 {
                                                if _e2442 {
                                                    phi_4718_ = _e2340.member_2;
                                                } else {
                                                    phi_4718_ = _e2340.member_1;
                                                }
                                                let _e2446 = phi_4718_;
                                                let _e2467 = (_e846 % 128u);
                                                let _e2468 = (_e2467 < 128u);
                                                if _e2468 {
                                                } else {
                                                    phi_5513_ = true;
                                                    break;
                                                }
                                                local_8[_e2467] = _e2446.member_1;
                                                if _e2468 {
                                                } else {
                                                    phi_5513_ = true;
                                                    break;
                                                }
                                                local_7[_e2467] = _e2446.member.member.x;
                                                if _e2468 {
                                                } else {
                                                    phi_5513_ = true;
                                                    break;
                                                }
                                                local_6[_e2467] = _e2446.member.member.y;
                                                if _e2468 {
                                                } else {
                                                    phi_5513_ = true;
                                                    break;
                                                }
                                                local_5[_e2467] = _e2446.member.member.z;
                                                if _e2468 {
                                                } else {
                                                    phi_5513_ = true;
                                                    break;
                                                }
                                                local_4[_e2467] = _e2446.member.member_1.x;
                                                if _e2468 {
                                                } else {
                                                    phi_5513_ = true;
                                                    break;
                                                }
                                                local_3[_e2467] = _e2446.member.member_1.y;
                                                if _e2468 {
                                                } else {
                                                    phi_5513_ = true;
                                                    break;
                                                }
                                                local_2[_e2467] = _e2446.member.member_1.z;
                                                if _e2468 {
                                                } else {
                                                    phi_5513_ = true;
                                                    break;
                                                }
                                                local_9[_e2467] = select(_e2433, _e2435, _e2442);
                                                if _e2442 {
                                                    phi_4794_ = _e2340.member_1;
                                                } else {
                                                    phi_4794_ = _e2340.member_2;
                                                }
                                                let _e2481 = phi_4794_;
                                                phi_4795_ = (_e846 + 1u);
                                                phi_4796_ = _e2481;
                                            } else {
                                                phi_4795_ = u32();
                                                phi_4796_ = type_57();
                                            }
                                            let _e2483 = phi_4795_;
                                            let _e2485 = phi_4796_;
                                            phi_4798_ = _e2483;
                                            phi_4799_ = _e2485;
                                            phi_4800_ = select(true, false, _e2441);
                                        } else {
                                            phi_4798_ = u32();
                                            phi_4799_ = type_57();
                                            phi_4800_ = true;
                                        }
                                        let _e2488 = phi_4798_;
                                        let _e2490 = phi_4799_;
                                        let _e2492 = phi_4800_;
                                        if _e2492 {
                                            if _e2440 {
                                                phi_4809_ = _e2340.member_1;
                                            } else {
                                                phi_4809_ = _e2340.member_2;
                                            }
                                            let _e2496 = phi_4809_;
                                            phi_4814_ = select(_e2441, true, _e2440);
                                            phi_4816_ = _e2496;
                                        } else {
                                            phi_4814_ = _e844;
                                            phi_4816_ = _e2490;
                                        }
                                        let _e2499 = phi_4814_;
                                        let _e2501 = phi_4816_;
                                        phi_4820_ = _e2499;
                                        phi_4821_ = select(_e2488, _e846, _e2492);
                                        phi_4822_ = _e2501;
                                    }
                                    let _e2504 = phi_4820_;
                                    let _e2506 = phi_4821_;
                                    let _e2508 = phi_4822_;
                                    if _e852 {
                                        phi_4832_ = _e848;
                                    } else {
                                        phi_4832_ = _e2508;
                                    }
                                    let _e2510 = phi_4832_;
                                    phi_5516_ = _e2024;
                                    phi_4833_ = _e2026;
                                    phi_4834_ = (_e807 - 1u);
                                    phi_4835_ = select(_e2504, false, _e852);
                                    phi_4836_ = select(_e2506, _e846, _e852);
                                    phi_4837_ = _e2510;
                                } else {
                                    phi_5516_ = _e803;
                                    phi_4833_ = _e805;
                                    phi_4834_ = _e807;
                                    phi_4835_ = _e844;
                                    phi_4836_ = _e846;
                                    phi_4837_ = _e848;
                                }
                                let _e2514 = phi_5516_;
                                let _e2516 = phi_4833_;
                                let _e2518 = phi_4834_;
                                let _e2520 = phi_4835_;
                                let _e2522 = phi_4836_;
                                let _e2524 = phi_4837_;
                                phi_5515_ = _e2514;
                                phi_4838_ = _e2516;
                                phi_4839_ = _e2518;
                                phi_4840_ = _e2520;
                                phi_4841_ = _e2522;
                                phi_4842_ = _e2524;
                            } else {
                                phi_5515_ = _e803;
                                phi_4838_ = type_39();
                                phi_4839_ = u32();
                                phi_4840_ = bool();
                                phi_4841_ = u32();
                                phi_4842_ = type_57();
                            }
                            let _e2526 = phi_5515_;
                            let _e2528 = phi_4838_;
                            let _e2530 = phi_4839_;
                            let _e2532 = phi_4840_;
                            let _e2534 = phi_4841_;
                            let _e2536 = phi_4842_;
                            phi_5514_ = _e2526;
                            phi_1402_ = _e2528;
                            phi_1405_ = _e2530;
                            phi_1407_ = _e2532;
                            phi_1409_ = _e2534;
                            phi_1411_ = _e2536;
                            phi_4843_ = _e817;
                        } else {
                            phi_5514_ = _e803;
                            phi_1402_ = type_39();
                            phi_1405_ = u32();
                            phi_1407_ = bool();
                            phi_1409_ = u32();
                            phi_1411_ = type_57();
                            phi_4843_ = false;
                        }
                        let _e2538 = phi_5514_;
                        let _e2540 = phi_1402_;
                        let _e2542 = phi_1405_;
                        let _e2544 = phi_1407_;
                        let _e2546 = phi_1409_;
                        let _e2548 = phi_1411_;
                        let _e2550 = phi_4843_;
                        continue;
                        continuing {
                            phi_5280_ = _e2538;
                            phi_1401_ = _e2540;
                            phi_1404_ = _e2542;
                            phi_1406_ = _e2544;
                            phi_1408_ = _e2546;
                            phi_1410_ = _e2548;
                            phi_5513_ = _e2538;
                            break if !(_e2550);
                        }
                    }
                    let _e2553 = phi_5513_;
                    if _e2553 {
                        break;
                    }
                    let _e2555 = local_10;
                    if (_e2555.member.member_3 != 4294967295u) {
                        let _e2560 = bitcast<u32>(_e2555.member.member);
                        let _e2564 = (bitcast<i32>((_e2560 >> bitcast<u32>(23i))) & 255i);
                        let _e2565 = (_e2564 + _e430);
                        if (_e2564 == 255i) {
                            phi_4902_ = _e2555.member.member;
                        } else {
                            if (_e2564 > 0i) {
                                if (_e2565 > 0i) {
                                    let _e2569 = (_e2565 < 255i);
                                    if _e2569 {
                                        phi_4881_ = bitcast<f32>((_e2560 + bitcast<u32>((_e430 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_4881_ = f32();
                                    }
                                    let _e2576 = phi_4881_;
                                    phi_4883_ = _e2576;
                                    phi_4884_ = select(true, false, _e2569);
                                } else {
                                    phi_4883_ = f32();
                                    phi_4884_ = true;
                                }
                                let _e2579 = phi_4883_;
                                let _e2581 = phi_4884_;
                                phi_4885_ = _e2579;
                                phi_4886_ = _e2581;
                            } else {
                                phi_4885_ = f32();
                                phi_4886_ = true;
                            }
                            let _e2583 = phi_4885_;
                            let _e2585 = phi_4886_;
                            if _e2585 {
                                let _e2586 = (_e2560 & 2147483648u);
                                let _e2593 = ((_e2560 & 8388607u) | (select(0u, 1u, ((_e2560 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e2597 = (_e2593 == 0u);
                                if _e2597 {
                                    phi_5232_ = bitcast<f32>(_e2586);
                                } else {
                                    let _e2602 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2593)), 32u, _e2597) - 8u);
                                    let _e2605 = (_e2593 << bitcast<u32>((_e2602 & 31u)));
                                    let _e2607 = ((_e2565 + select(0i, 1i, (_e2564 == 0i))) - bitcast<i32>(_e2602));
                                    if (_e2607 >= 255i) {
                                        phi_5222_ = bitcast<f32>((_e2586 | 2139095040u));
                                        phi_5223_ = f32();
                                        phi_5224_ = true;
                                    } else {
                                        let _e2609 = (_e2607 > 0i);
                                        if _e2609 {
                                            phi_5216_ = bitcast<f32>(((_e2586 | (bitcast<u32>(_e2607) << bitcast<u32>(23i))) | (_e2605 & 8388607u)));
                                            phi_5217_ = f32();
                                        } else {
                                            if (_e2607 < -24i) {
                                                phi_5182_ = 26u;
                                            } else {
                                                phi_5182_ = bitcast<u32>((1i - _e2607));
                                            }
                                            let _e2614 = phi_5182_;
                                            let _e2615 = (_e2614 & 31u);
                                            let _e2617 = (_e2605 >> bitcast<u32>(_e2615));
                                            let _e2621 = (_e2605 & ((1u << bitcast<u32>(_e2615)) - 1u));
                                            let _e2625 = (1u << bitcast<u32>(((_e2614 - 1u) & 31u)));
                                            if (_e2621 > _e2625) {
                                                phi_5203_ = true;
                                            } else {
                                                if (_e2621 == _e2625) {
                                                    phi_5200_ = ((_e2617 & 1u) == 1u);
                                                } else {
                                                    phi_5200_ = false;
                                                }
                                                let _e2631 = phi_5200_;
                                                phi_5203_ = _e2631;
                                            }
                                            let _e2633 = phi_5203_;
                                            phi_5216_ = f32();
                                            phi_5217_ = bitcast<f32>((_e2586 | (_e2617 + select(0u, 1u, _e2633))));
                                        }
                                        let _e2646 = phi_5216_;
                                        let _e2648 = phi_5217_;
                                        phi_5222_ = _e2646;
                                        phi_5223_ = _e2648;
                                        phi_5224_ = _e2609;
                                    }
                                    let _e2652 = phi_5222_;
                                    let _e2654 = phi_5223_;
                                    let _e2656 = phi_5224_;
                                    phi_5232_ = select(_e2654, _e2652, _e2656);
                                }
                                let _e2660 = phi_5232_;
                                phi_4901_ = _e2660;
                            } else {
                                phi_4901_ = _e2583;
                            }
                            let _e2662 = phi_4901_;
                            phi_4902_ = _e2662;
                        }
                        let _e2664 = phi_4902_;
                        let _e2665 = bitcast<u32>(_e2664);
                        if ((_e2665 & 2147483647u) >= 2139095040u) {
                            phi_4914_ = bitcast<f32>(((_e2665 & 2147483648u) | 2139095039u));
                        } else {
                            phi_4914_ = _e2664;
                        }
                        let _e2672 = phi_4914_;
                        phi_4919_ = type_21(_e2672, _e2555.member.member_1, _e2555.member.member_2, _e2555.member.member_3);
                    } else {
                        phi_4919_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2677 = phi_4919_;
                    if _e307 {
                    } else {
                        break;
                    }
                    global_7.member[_e153] = _e2677;
                    if _e168 {
                    } else {
                        break;
                    }
                    let _e2681 = select(0u, 1u, (_e374 <= _e384));
                    if (_e2681 > 0u) {
                        let _e2683 = (1u < _e121);
                        if _e2683 {
                            if (0u < _e121) {
                            } else {
                                break;
                            }
                            let _e2687 = atomicAdd((&global_8.member[0u]), _e2681);
                            if ((_e2687 + _e2681) < _e2687) {
                                if _e2683 {
                                } else {
                                    break;
                                }
                                let _e2692 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                    }
                    let _e2695 = select(0u, 1u, (_e2677.member_3 != 4294967295u));
                    if (_e2695 > 0u) {
                        let _e2697 = (3u < _e121);
                        if _e2697 {
                            if (2u < _e121) {
                            } else {
                                break;
                            }
                            let _e2701 = atomicAdd((&global_8.member[2u]), _e2695);
                            if ((_e2701 + _e2695) < _e2701) {
                                if _e2697 {
                                } else {
                                    break;
                                }
                                let _e2706 = atomicAdd((&global_8.member[3u]), 1u);
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
