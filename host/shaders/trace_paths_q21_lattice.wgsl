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
    var phi_5276_: bool;
    var phi_1401_: type_39;
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
    var phi_5270_: bool;
    var phi_5513_: bool;
    var phi_4825_: type_39;
    var phi_4826_: bool;
    var phi_4827_: u32;
    var phi_4828_: type_57;
    var phi_5512_: bool;
    var phi_4829_: type_39;
    var phi_4830_: bool;
    var phi_4831_: u32;
    var phi_4832_: u32;
    var phi_4833_: type_57;
    var phi_5511_: bool;
    var phi_4834_: type_39;
    var phi_4835_: bool;
    var phi_4836_: u32;
    var phi_4837_: u32;
    var phi_4838_: type_57;
    var phi_5510_: bool;
    var phi_1402_: type_39;
    var phi_1405_: bool;
    var phi_1407_: u32;
    var phi_1409_: u32;
    var phi_1411_: type_57;
    var phi_4839_: bool;
    var phi_5509_: bool;
    var local_10: type_39;
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
    var phi_4915_: type_21;
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
                    phi_5276_ = false;
                    phi_1401_ = type_39(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e759);
                    phi_1404_ = (_e761 <= _e759);
                    phi_1406_ = ((3u * _e106) + 1u);
                    phi_1408_ = 0u;
                    phi_1410_ = type_57(type_33(vec4<f32>((f32(_e768) * _e165), (f32(_e774) * _e165), (f32(_e780) * _e165), 0f), vec4<f32>((f32(_e785) * _e165), (f32(_e789) * _e165), (f32(_e793) * _e165), 0f)), select(0u, 2147483648u, (_e106 == 0u)));
                    loop {
                        let _e803 = phi_5276_;
                        let _e805 = phi_1401_;
                        let _e807 = phi_1404_;
                        let _e809 = phi_1406_;
                        let _e811 = phi_1408_;
                        let _e813 = phi_1410_;
                        local_10 = _e805;
                        if _e807 {
                            phi_1421_ = true;
                        } else {
                            phi_1421_ = (_e811 > 0u);
                        }
                        let _e816 = phi_1421_;
                        if _e816 {
                            let _e817 = (_e809 > 0u);
                            if _e817 {
                                if _e807 {
                                    phi_1507_ = _e807;
                                    phi_1508_ = _e811;
                                    phi_1509_ = _e813;
                                } else {
                                    let _e818 = (_e811 - 1u);
                                    let _e819 = (_e818 % 128u);
                                    let _e820 = (_e819 < 128u);
                                    if _e820 {
                                    } else {
                                        phi_5509_ = true;
                                        break;
                                    }
                                    let _e822 = local_7[_e819];
                                    if _e820 {
                                    } else {
                                        phi_5509_ = true;
                                        break;
                                    }
                                    let _e824 = local_6[_e819];
                                    if _e820 {
                                    } else {
                                        phi_5509_ = true;
                                        break;
                                    }
                                    let _e826 = local_5[_e819];
                                    if _e820 {
                                    } else {
                                        phi_5509_ = true;
                                        break;
                                    }
                                    let _e828 = local_4[_e819];
                                    if _e820 {
                                    } else {
                                        phi_5509_ = true;
                                        break;
                                    }
                                    let _e830 = local_3[_e819];
                                    if _e820 {
                                    } else {
                                        phi_5509_ = true;
                                        break;
                                    }
                                    let _e832 = local_2[_e819];
                                    if _e820 {
                                    } else {
                                        phi_5509_ = true;
                                        break;
                                    }
                                    let _e837 = local_8[_e819];
                                    if _e820 {
                                    } else {
                                        phi_5509_ = true;
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
                                    let _e853 = (_e848.member_1 & 268435455u);
                                    if ((_e848.member_1 & 2147483648u) != 0u) {
                                        phi_1528_ = _e805;
                                        phi_1531_ = type_8(0u, ((_e848.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1337 = phi_1528_;
                                            let _e1339 = phi_1531_;
                                            local_11 = _e1337;
                                            if (_e1339.member < _e1339.member_1) {
                                                phi_1532_ = type_8((_e1339.member + 1u), _e1339.member_1);
                                                phi_1554_ = type_8(1u, _e1339.member);
                                            } else {
                                                phi_1532_ = _e1339;
                                                phi_1554_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1352 = phi_1532_;
                                            let _e1354 = phi_1554_;
                                            let _e1358 = (bitcast<i32>(_e1354.member) != 0i);
                                            if _e1358 {
                                                let _e1363 = (_e848.member.member_1.x - _e848.member.member.x);
                                                let _e1366 = (_e848.member.member_1.y - _e848.member.member.y);
                                                let _e1369 = (_e848.member.member_1.z - _e848.member.member.z);
                                                let _e1371 = select(_e1366, _e1363, (_e1363 > _e1366));
                                                let _e1373 = select(_e1369, _e1371, (_e1371 > _e1369));
                                                let _e1375 = (_e1373 < (1024f * _e165));
                                                if _e1375 {
                                                    phi_1595_ = 0u;
                                                } else {
                                                    phi_1595_ = select(2u, 1u, (_e1373 < (2097152f * _e165)));
                                                }
                                                let _e1380 = phi_1595_;
                                                switch bitcast<i32>(_e1380) {
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
                                                let _e1383 = phi_1601_;
                                                switch bitcast<i32>(_e1380) {
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
                                                let _e1390 = phi_1611_;
                                                let _e1392 = ((_e853 + (_e1354.member_1 * ((3u * _e1383) + 1u))) + (3u * _e1390));
                                                let _e1393 = (_e1392 < _e109);
                                                if _e1393 {
                                                    if _e1393 {
                                                    } else {
                                                        phi_5270_ = true;
                                                        break;
                                                    }
                                                    let _e1395 = global_10.member[_e1392];
                                                    phi_1627_ = _e1395;
                                                } else {
                                                    phi_1627_ = 4294967295u;
                                                }
                                                let _e1397 = phi_1627_;
                                                if _e1375 {
                                                    phi_1660_ = 0u;
                                                } else {
                                                    phi_1660_ = select(2u, 1u, (_e1373 < (2097152f * _e165)));
                                                }
                                                let _e1402 = phi_1660_;
                                                switch bitcast<i32>(_e1402) {
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
                                                let _e1405 = phi_1666_;
                                                let _e1409 = (_e853 + (_e1354.member_1 * ((3u * _e1405) + 1u)));
                                                switch bitcast<i32>(_e1402) {
                                                    case 0: {
                                                        let _e1684 = (_e1409 < _e109);
                                                        if _e1684 {
                                                            if _e1684 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e1686 = global_10.member[_e1409];
                                                            phi_1693_ = _e1686;
                                                        } else {
                                                            phi_1693_ = 0u;
                                                        }
                                                        let _e1688 = phi_1693_;
                                                        let _e1690 = ((10u * _e428) & 31u);
                                                        let _e1700 = ((10u * _e427) & 31u);
                                                        let _e1710 = ((10u * _e429) & 31u);
                                                        let _e1720 = (_e1409 + 1u);
                                                        let _e1721 = (_e1720 < _e109);
                                                        if _e1721 {
                                                            if _e1721 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e1723 = global_10.member[_e1720];
                                                            phi_1742_ = _e1723;
                                                        } else {
                                                            phi_1742_ = 0u;
                                                        }
                                                        let _e1725 = phi_1742_;
                                                        let _e1751 = (_e1409 + 2u);
                                                        let _e1752 = (_e1751 < _e109);
                                                        if _e1752 {
                                                            if _e1752 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e1754 = global_10.member[_e1751];
                                                            phi_1791_ = _e1754;
                                                        } else {
                                                            phi_1791_ = 0u;
                                                        }
                                                        let _e1756 = phi_1791_;
                                                        phi_2292_ = array<array<f32, 3>, 3>(array<f32, 3>((_e848.member.member.x + ((bitcast<f32>((1258291200u | ((_e1688 >> bitcast<u32>(_e1690)) & 1023u))) - 8388608f) * _e165)), (_e848.member.member.y + ((bitcast<f32>((1258291200u | ((_e1688 >> bitcast<u32>(_e1700)) & 1023u))) - 8388608f) * _e165)), (_e848.member.member.z + ((bitcast<f32>((1258291200u | ((_e1688 >> bitcast<u32>(_e1710)) & 1023u))) - 8388608f) * _e165))), array<f32, 3>((_e848.member.member.x + ((bitcast<f32>((1258291200u | ((_e1725 >> bitcast<u32>(_e1690)) & 1023u))) - 8388608f) * _e165)), (_e848.member.member.y + ((bitcast<f32>((1258291200u | ((_e1725 >> bitcast<u32>(_e1700)) & 1023u))) - 8388608f) * _e165)), (_e848.member.member.z + ((bitcast<f32>((1258291200u | ((_e1725 >> bitcast<u32>(_e1710)) & 1023u))) - 8388608f) * _e165))), array<f32, 3>((_e848.member.member.x + ((bitcast<f32>((1258291200u | ((_e1756 >> bitcast<u32>(_e1690)) & 1023u))) - 8388608f) * _e165)), (_e848.member.member.y + ((bitcast<f32>((1258291200u | ((_e1756 >> bitcast<u32>(_e1700)) & 1023u))) - 8388608f) * _e165)), (_e848.member.member.z + ((bitcast<f32>((1258291200u | ((_e1756 >> bitcast<u32>(_e1710)) & 1023u))) - 8388608f) * _e165))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1498 = (_e1409 < _e109);
                                                        if _e1498 {
                                                            if _e1498 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e1500 = global_10.member[_e1409];
                                                            phi_1840_ = _e1500;
                                                        } else {
                                                            phi_1840_ = 0u;
                                                        }
                                                        let _e1502 = phi_1840_;
                                                        let _e1503 = (_e1409 + 1u);
                                                        let _e1504 = (_e1503 < _e109);
                                                        if _e1504 {
                                                            if _e1504 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e1506 = global_10.member[_e1503];
                                                            phi_1855_ = _e1506;
                                                        } else {
                                                            phi_1855_ = 0u;
                                                        }
                                                        let _e1508 = phi_1855_;
                                                        let _e1509 = (_e428 == 1u);
                                                        if _e1509 {
                                                            phi_1865_ = ((_e1502 >> bitcast<u32>(21i)) | (_e1508 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1865_ = (_e1508 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1518 = phi_1865_;
                                                        let _e1526 = (_e427 == 1u);
                                                        if _e1526 {
                                                            phi_1886_ = ((_e1502 >> bitcast<u32>(21i)) | (_e1508 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1886_ = (_e1508 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1535 = phi_1886_;
                                                        let _e1543 = (_e429 == 1u);
                                                        if _e1543 {
                                                            phi_1907_ = ((_e1502 >> bitcast<u32>(21i)) | (_e1508 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1907_ = (_e1508 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1552 = phi_1907_;
                                                        let _e1561 = (_e1409 + 2u);
                                                        let _e1562 = (_e1561 < _e109);
                                                        if _e1562 {
                                                            if _e1562 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e1564 = global_10.member[_e1561];
                                                            phi_1937_ = _e1564;
                                                        } else {
                                                            phi_1937_ = 0u;
                                                        }
                                                        let _e1566 = phi_1937_;
                                                        let _e1567 = (_e1409 + 3u);
                                                        let _e1568 = (_e1567 < _e109);
                                                        if _e1568 {
                                                            if _e1568 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e1570 = global_10.member[_e1567];
                                                            phi_1952_ = _e1570;
                                                        } else {
                                                            phi_1952_ = 0u;
                                                        }
                                                        let _e1572 = phi_1952_;
                                                        if _e1509 {
                                                            phi_1962_ = ((_e1566 >> bitcast<u32>(21i)) | (_e1572 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1962_ = (_e1572 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1581 = phi_1962_;
                                                        if _e1526 {
                                                            phi_1983_ = ((_e1566 >> bitcast<u32>(21i)) | (_e1572 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1983_ = (_e1572 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1597 = phi_1983_;
                                                        if _e1543 {
                                                            phi_2004_ = ((_e1566 >> bitcast<u32>(21i)) | (_e1572 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2004_ = (_e1572 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1613 = phi_2004_;
                                                        let _e1622 = (_e1409 + 4u);
                                                        let _e1623 = (_e1622 < _e109);
                                                        if _e1623 {
                                                            if _e1623 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e1625 = global_10.member[_e1622];
                                                            phi_2034_ = _e1625;
                                                        } else {
                                                            phi_2034_ = 0u;
                                                        }
                                                        let _e1627 = phi_2034_;
                                                        let _e1628 = (_e1409 + 5u);
                                                        let _e1629 = (_e1628 < _e109);
                                                        if _e1629 {
                                                            if _e1629 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e1631 = global_10.member[_e1628];
                                                            phi_2049_ = _e1631;
                                                        } else {
                                                            phi_2049_ = 0u;
                                                        }
                                                        let _e1633 = phi_2049_;
                                                        if _e1509 {
                                                            phi_2059_ = ((_e1627 >> bitcast<u32>(21i)) | (_e1633 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2059_ = (_e1633 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1642 = phi_2059_;
                                                        if _e1526 {
                                                            phi_2080_ = ((_e1627 >> bitcast<u32>(21i)) | (_e1633 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2080_ = (_e1633 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1658 = phi_2080_;
                                                        if _e1543 {
                                                            phi_2101_ = ((_e1627 >> bitcast<u32>(21i)) | (_e1633 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2101_ = (_e1633 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1674 = phi_2101_;
                                                        phi_2292_ = array<array<f32, 3>, 3>(array<f32, 3>((_e848.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1518, _e1502, _e452) & 2097151u))) - 8388608f) * _e165)), (_e848.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1535, _e1502, _e519) & 2097151u))) - 8388608f) * _e165)), (_e848.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1552, _e1502, _e585) & 2097151u))) - 8388608f) * _e165))), array<f32, 3>((_e848.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1581, _e1566, _e452) & 2097151u))) - 8388608f) * _e165)), (_e848.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1597, _e1566, _e519) & 2097151u))) - 8388608f) * _e165)), (_e848.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1613, _e1566, _e585) & 2097151u))) - 8388608f) * _e165))), array<f32, 3>((_e848.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1642, _e1627, _e452) & 2097151u))) - 8388608f) * _e165)), (_e848.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1658, _e1627, _e519) & 2097151u))) - 8388608f) * _e165)), (_e848.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1674, _e1627, _e585) & 2097151u))) - 8388608f) * _e165))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1411 = (_e1409 + _e428);
                                                        let _e1412 = (_e1411 < _e109);
                                                        if _e1412 {
                                                            if _e1412 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e1414 = global_10.member[_e1411];
                                                            phi_2132_ = _e1414;
                                                        } else {
                                                            phi_2132_ = 0u;
                                                        }
                                                        let _e1416 = phi_2132_;
                                                        let _e1420 = (_e1409 + _e427);
                                                        let _e1421 = (_e1420 < _e109);
                                                        if _e1421 {
                                                            if _e1421 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e1423 = global_10.member[_e1420];
                                                            phi_2150_ = _e1423;
                                                        } else {
                                                            phi_2150_ = 0u;
                                                        }
                                                        let _e1425 = phi_2150_;
                                                        let _e1429 = (_e1409 + _e429);
                                                        let _e1430 = (_e1429 < _e109);
                                                        if _e1430 {
                                                            if _e1430 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e1432 = global_10.member[_e1429];
                                                            phi_2168_ = _e1432;
                                                        } else {
                                                            phi_2168_ = 0u;
                                                        }
                                                        let _e1434 = phi_2168_;
                                                        let _e1439 = (_e1409 + 3u);
                                                        let _e1440 = (_e1439 + _e428);
                                                        let _e1441 = (_e1440 < _e109);
                                                        if _e1441 {
                                                            if _e1441 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e1443 = global_10.member[_e1440];
                                                            phi_2191_ = _e1443;
                                                        } else {
                                                            phi_2191_ = 0u;
                                                        }
                                                        let _e1445 = phi_2191_;
                                                        let _e1449 = (_e1439 + _e427);
                                                        let _e1450 = (_e1449 < _e109);
                                                        if _e1450 {
                                                            if _e1450 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e1452 = global_10.member[_e1449];
                                                            phi_2209_ = _e1452;
                                                        } else {
                                                            phi_2209_ = 0u;
                                                        }
                                                        let _e1454 = phi_2209_;
                                                        let _e1458 = (_e1439 + _e429);
                                                        let _e1459 = (_e1458 < _e109);
                                                        if _e1459 {
                                                            if _e1459 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e1461 = global_10.member[_e1458];
                                                            phi_2227_ = _e1461;
                                                        } else {
                                                            phi_2227_ = 0u;
                                                        }
                                                        let _e1463 = phi_2227_;
                                                        let _e1468 = (_e1409 + 6u);
                                                        let _e1469 = (_e1468 + _e428);
                                                        let _e1470 = (_e1469 < _e109);
                                                        if _e1470 {
                                                            if _e1470 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e1472 = global_10.member[_e1469];
                                                            phi_2250_ = _e1472;
                                                        } else {
                                                            phi_2250_ = 0u;
                                                        }
                                                        let _e1474 = phi_2250_;
                                                        let _e1478 = (_e1468 + _e427);
                                                        let _e1479 = (_e1478 < _e109);
                                                        if _e1479 {
                                                            if _e1479 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e1481 = global_10.member[_e1478];
                                                            phi_2268_ = _e1481;
                                                        } else {
                                                            phi_2268_ = 0u;
                                                        }
                                                        let _e1483 = phi_2268_;
                                                        let _e1487 = (_e1468 + _e429);
                                                        let _e1488 = (_e1487 < _e109);
                                                        if _e1488 {
                                                            if _e1488 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e1490 = global_10.member[_e1487];
                                                            phi_2286_ = _e1490;
                                                        } else {
                                                            phi_2286_ = 0u;
                                                        }
                                                        let _e1492 = phi_2286_;
                                                        phi_2292_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1416)) * _e165), (f32(bitcast<i32>(_e1425)) * _e165), (f32(bitcast<i32>(_e1434)) * _e165)), array<f32, 3>((f32(bitcast<i32>(_e1445)) * _e165), (f32(bitcast<i32>(_e1454)) * _e165), (f32(bitcast<i32>(_e1463)) * _e165)), array<f32, 3>((f32(bitcast<i32>(_e1474)) * _e165), (f32(bitcast<i32>(_e1483)) * _e165), (f32(bitcast<i32>(_e1492)) * _e165)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2292_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1784 = phi_2292_;
                                                let _e1792 = (_e1784[0][2] - _e608);
                                                let _e1795 = (((_e1784[0][0] - _e475) * _e647) - (_e1792 * _e515));
                                                let _e1798 = (((_e1784[0][1] - _e542) * _e647) - (_e1792 * _e581));
                                                let _e1805 = (_e1784[1][2] - _e608);
                                                let _e1808 = (((_e1784[1][0] - _e475) * _e647) - (_e1805 * _e515));
                                                let _e1811 = (((_e1784[1][1] - _e542) * _e647) - (_e1805 * _e581));
                                                let _e1818 = (_e1784[2][2] - _e608);
                                                let _e1821 = (((_e1784[2][0] - _e475) * _e647) - (_e1818 * _e515));
                                                let _e1824 = (((_e1784[2][1] - _e542) * _e647) - (_e1818 * _e581));
                                                let _e1825 = (_e1821 * _e1811);
                                                let _e1826 = (_e1824 * _e1808);
                                                let _e1827 = (_e1795 * _e1824);
                                                let _e1828 = (_e1798 * _e1821);
                                                let _e1829 = (_e1808 * _e1798);
                                                let _e1830 = (_e1811 * _e1795);
                                                let _e1835 = (((_e1825 >= _e1826) && (_e1827 >= _e1828)) && (_e1829 >= _e1830));
                                                if (_e1835 || (((_e1825 <= _e1826) && (_e1827 <= _e1828)) && (_e1829 <= _e1830))) {
                                                    let _e1842 = select(-1f, 1f, _e1835);
                                                    let _e1844 = ((_e1825 - _e1826) * _e1842);
                                                    let _e1846 = select(0f, _e1844, (_e1844 > 0f));
                                                    let _e1848 = ((_e1827 - _e1828) * _e1842);
                                                    let _e1850 = select(0f, _e1848, (_e1848 > 0f));
                                                    let _e1852 = ((_e1829 - _e1830) * _e1842);
                                                    let _e1854 = select(0f, _e1852, (_e1852 > 0f));
                                                    let _e1856 = ((_e1846 + _e1850) + _e1854);
                                                    if (_e1856 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_3176_ = type_21();
                                                        phi_3177_ = true;
                                                        phi_3178_ = false;
                                                    } else {
                                                        let _e1859 = select(_e1808, _e1795, (_e1795 < _e1808));
                                                        if (select(_e1821, _e1859, (_e1859 < _e1821)) > 0f) {
                                                            phi_2444_ = true;
                                                        } else {
                                                            let _e1864 = select(_e1808, _e1795, (_e1795 > _e1808));
                                                            phi_2444_ = (select(_e1821, _e1864, (_e1864 > _e1821)) < 0f);
                                                        }
                                                        let _e1869 = phi_2444_;
                                                        if _e1869 {
                                                            phi_3173_ = type_21();
                                                            phi_3174_ = true;
                                                            phi_3175_ = false;
                                                        } else {
                                                            let _e1871 = select(_e1811, _e1798, (_e1798 < _e1811));
                                                            if (select(_e1824, _e1871, (_e1871 < _e1824)) > 0f) {
                                                                phi_2473_ = true;
                                                            } else {
                                                                let _e1876 = select(_e1811, _e1798, (_e1798 > _e1811));
                                                                phi_2473_ = (select(_e1824, _e1876, (_e1876 > _e1824)) < 0f);
                                                            }
                                                            let _e1881 = phi_2473_;
                                                            if _e1881 {
                                                                phi_3171_ = type_21();
                                                                phi_3172_ = false;
                                                            } else {
                                                                let _e1883 = select(_e1784[1][0], _e1784[0][0], (_e1784[0][0] < _e1784[1][0]));
                                                                let _e1887 = select(_e1784[1][0], _e1784[0][0], (_e1784[0][0] > _e1784[1][0]));
                                                                let _e1891 = select(_e1784[1][1], _e1784[0][1], (_e1784[0][1] < _e1784[1][1]));
                                                                let _e1895 = select(_e1784[1][1], _e1784[0][1], (_e1784[0][1] > _e1784[1][1]));
                                                                let _e1899 = select(_e1784[1][2], _e1784[0][2], (_e1784[0][2] < _e1784[1][2]));
                                                                let _e1903 = select(_e1784[1][2], _e1784[0][2], (_e1784[0][2] > _e1784[1][2]));
                                                                let _e1908 = ((select(_e1784[2][0], _e1883, (_e1883 < _e1784[2][0])) - _e513) * _e518);
                                                                let _e1909 = ((select(_e1784[2][0], _e1887, (_e1887 > _e1784[2][0])) - _e514) * _e518);
                                                                let _e1912 = ((select(_e1784[2][1], _e1891, (_e1891 < _e1784[2][1])) - _e579) * _e584);
                                                                let _e1913 = ((select(_e1784[2][1], _e1895, (_e1895 > _e1784[2][1])) - _e580) * _e584);
                                                                let _e1916 = ((select(_e1784[2][2], _e1899, (_e1899 < _e1784[2][2])) - _e645) * _e650);
                                                                let _e1917 = ((select(_e1784[2][2], _e1903, (_e1903 > _e1784[2][2])) - _e646) * _e650);
                                                                let _e1919 = select(_e1917, _e1916, (_e1916 < _e1917));
                                                                let _e1921 = select(_e1917, _e1916, (_e1916 > _e1917));
                                                                let _e1923 = select(_e1909, _e1908, (_e1908 < _e1909));
                                                                let _e1925 = select(_e1913, _e1912, (_e1912 < _e1913));
                                                                let _e1927 = select(_e1925, _e1923, (_e1923 > _e1925));
                                                                let _e1929 = select(_e1919, _e1927, (_e1927 > _e1919));
                                                                let _e1931 = select(_e1909, _e1908, (_e1908 > _e1909));
                                                                let _e1933 = select(_e1913, _e1912, (_e1912 > _e1913));
                                                                let _e1935 = select(_e1933, _e1931, (_e1931 < _e1933));
                                                                let _e1937 = select(_e1921, _e1935, (_e1935 < _e1921));
                                                                let _e1938 = -(_e1919);
                                                                let _e1944 = select(_e761, _e1929, (_e1929 > _e761));
                                                                if (_e1944 > (_e1937 + (select(_e1938, _e1921, (_e1921 > _e1938)) * 0.0000019073523f))) {
                                                                    phi_3166_ = type_21();
                                                                    phi_3167_ = true;
                                                                } else {
                                                                    let _e1946 = (_e1944 > _e1337.member_1);
                                                                    if _e1946 {
                                                                        phi_3165_ = type_21();
                                                                    } else {
                                                                        let _e1947 = vec3<f32>(_e1784[0][0], _e1784[0][1], _e1784[0][2]);
                                                                        let _e1948 = vec3<f32>(_e1784[1][0], _e1784[1][1], _e1784[1][2]);
                                                                        let _e1949 = vec3<f32>(_e1784[2][0], _e1784[2][1], _e1784[2][2]);
                                                                        let _e1950 = (_e1784[1][0] - _e1784[0][0]);
                                                                        let _e1951 = (_e1784[1][1] - _e1784[0][1]);
                                                                        let _e1952 = (_e1784[1][2] - _e1784[0][2]);
                                                                        let _e1953 = vec3<f32>(_e1950, _e1951, _e1952);
                                                                        let _e1954 = (_e1784[2][0] - _e1784[1][0]);
                                                                        let _e1955 = (_e1784[2][1] - _e1784[1][1]);
                                                                        let _e1956 = (_e1784[2][2] - _e1784[1][2]);
                                                                        let _e1957 = vec3<f32>(_e1954, _e1955, _e1956);
                                                                        let _e1958 = (_e1784[0][0] - _e1784[2][0]);
                                                                        let _e1959 = (_e1784[0][1] - _e1784[2][1]);
                                                                        let _e1960 = (_e1784[0][2] - _e1784[2][2]);
                                                                        let _e1961 = vec3<f32>(_e1958, _e1959, _e1960);
                                                                        let _e1964 = bitcast<f32>((bitcast<u32>(_e1950) & 2147483647u));
                                                                        let _e1967 = bitcast<f32>((bitcast<u32>(_e1951) & 2147483647u));
                                                                        let _e1969 = select(_e1967, _e1964, (_e1964 > _e1967));
                                                                        let _e1972 = bitcast<f32>((bitcast<u32>(_e1952) & 2147483647u));
                                                                        let _e1974 = select(_e1972, _e1969, (_e1969 > _e1972));
                                                                        let _e1977 = bitcast<f32>((bitcast<u32>(_e1954) & 2147483647u));
                                                                        let _e1980 = bitcast<f32>((bitcast<u32>(_e1955) & 2147483647u));
                                                                        let _e1982 = select(_e1980, _e1977, (_e1977 > _e1980));
                                                                        let _e1985 = bitcast<f32>((bitcast<u32>(_e1956) & 2147483647u));
                                                                        let _e1987 = select(_e1985, _e1982, (_e1982 > _e1985));
                                                                        let _e1990 = bitcast<f32>((bitcast<u32>(_e1958) & 2147483647u));
                                                                        let _e1993 = bitcast<f32>((bitcast<u32>(_e1959) & 2147483647u));
                                                                        let _e1995 = select(_e1993, _e1990, (_e1990 > _e1993));
                                                                        let _e1998 = bitcast<f32>((bitcast<u32>(_e1960) & 2147483647u));
                                                                        let _e2000 = select(_e1998, _e1995, (_e1995 > _e1998));
                                                                        let _e2002 = select(_e1987, _e1974, (_e1974 > _e1987));
                                                                        let _e2004 = select(_e2000, _e2002, (_e2002 > _e2000));
                                                                        if (_e1974 == _e2004) {
                                                                            phi_2892_ = _e1811;
                                                                            phi_2893_ = _e1808;
                                                                            phi_2894_ = _e1798;
                                                                            phi_2895_ = _e1795;
                                                                            phi_2896_ = _e1947;
                                                                            phi_2897_ = _e1961;
                                                                            phi_2898_ = _e1957;
                                                                            phi_2899_ = _e1953;
                                                                        } else {
                                                                            let _e2006 = (_e1987 == _e2004);
                                                                            let _e2011 = vec3(_e2006);
                                                                            phi_2892_ = select(_e1798, _e1824, _e2006);
                                                                            phi_2893_ = select(_e1795, _e1821, _e2006);
                                                                            phi_2894_ = select(_e1824, _e1811, _e2006);
                                                                            phi_2895_ = select(_e1821, _e1808, _e2006);
                                                                            phi_2896_ = select(_e1949, _e1948, _e2011);
                                                                            phi_2897_ = select(_e1957, _e1953, _e2011);
                                                                            phi_2898_ = select(_e1953, _e1961, _e2011);
                                                                            phi_2899_ = select(_e1961, _e1957, _e2011);
                                                                        }
                                                                        let _e2017 = phi_2892_;
                                                                        let _e2019 = phi_2893_;
                                                                        let _e2021 = phi_2894_;
                                                                        let _e2023 = phi_2895_;
                                                                        let _e2025 = phi_2896_;
                                                                        let _e2027 = phi_2897_;
                                                                        let _e2029 = phi_2898_;
                                                                        let _e2031 = phi_2899_;
                                                                        let _e2038 = ((_e2029.y * _e2027.z) - (_e2027.y * _e2029.z));
                                                                        let _e2043 = ((_e2029.z * _e2027.x) - (_e2027.z * _e2029.x));
                                                                        let _e2046 = ((_e2029.x * _e2027.y) - (_e2027.x * _e2029.y));
                                                                        if (_e1846 >= _e1850) {
                                                                            phi_2936_ = select(true, false, (_e1846 >= _e1854));
                                                                        } else {
                                                                            phi_2936_ = true;
                                                                        }
                                                                        let _e2051 = phi_2936_;
                                                                        if _e2051 {
                                                                            phi_2945_ = select(_e1949, _e1948, vec3((_e1850 >= _e1854)));
                                                                        } else {
                                                                            phi_2945_ = _e1947;
                                                                        }
                                                                        let _e2056 = phi_2945_;
                                                                        let _e2067 = (((_e2038 * (_e2056.x - _e475)) + (_e2043 * (_e2056.y - _e542))) + (_e2046 * (_e2056.z - _e608)));
                                                                        let _e2072 = (((_e2038 * _e515) + (_e2043 * _e581)) + (_e2046 * _e647));
                                                                        let _e2073 = (_e2019 - _e2023);
                                                                        let _e2074 = (_e2017 - _e2021);
                                                                        let _e2082 = (-(((_e2023 * _e2073) + (_e2021 * _e2074))) / ((_e2073 * _e2073) + (_e2074 * _e2074)));
                                                                        let _e2084 = select(1f, _e2082, (_e2082 < 1f));
                                                                        let _e2086 = select(0f, _e2084, (_e2084 > 0f));
                                                                        let _e2099 = ((_e2025.x + (_e2031.x * _e2086)) - _e475);
                                                                        let _e2100 = ((_e2025.y + (_e2031.y * _e2086)) - _e542);
                                                                        let _e2101 = ((_e2025.z + (_e2031.z * _e2086)) - _e608);
                                                                        let _e2102 = (_e2101 / _e647);
                                                                        let _e2114 = bitcast<f32>((bitcast<u32>(_e2099) & 2147483647u));
                                                                        let _e2117 = bitcast<f32>((bitcast<u32>(_e2100) & 2147483647u));
                                                                        let _e2119 = select(_e2117, _e2114, (_e2114 > _e2117));
                                                                        let _e2122 = bitcast<f32>((bitcast<u32>(_e2101) & 2147483647u));
                                                                        let _e2124 = select(_e2122, _e2119, (_e2119 > _e2122));
                                                                        let _e2130 = bitcast<f32>((bitcast<u32>(_e2038) & 2147483647u));
                                                                        let _e2133 = bitcast<f32>((bitcast<u32>(_e2043) & 2147483647u));
                                                                        let _e2135 = select(_e2133, _e2130, (_e2130 > _e2133));
                                                                        let _e2138 = bitcast<f32>((bitcast<u32>(_e2046) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e2038 * _e2099) + (_e2043 * _e2100)) + (_e2046 * _e2101)) - _e2067)) & 2147483647u)) <= ((0.0000009536743f * select(_e2004, _e2124, (_e2124 > _e2004))) * select(_e2138, _e2135, (_e2135 > _e2138)))) {
                                                                            let _e2148 = bitcast<f32>((bitcast<u32>(_e2029.x) & 2147483647u));
                                                                            let _e2151 = bitcast<f32>((bitcast<u32>(_e2029.y) & 2147483647u));
                                                                            let _e2153 = select(_e2151, _e2148, (_e2148 > _e2151));
                                                                            let _e2156 = bitcast<f32>((bitcast<u32>(_e2029.z) & 2147483647u));
                                                                            let _e2162 = bitcast<f32>((bitcast<u32>(_e2027.x) & 2147483647u));
                                                                            let _e2165 = bitcast<f32>((bitcast<u32>(_e2027.y) & 2147483647u));
                                                                            let _e2167 = select(_e2165, _e2162, (_e2162 > _e2165));
                                                                            let _e2170 = bitcast<f32>((bitcast<u32>(_e2027.z) & 2147483647u));
                                                                            let _e2174 = (bitcast<f32>((bitcast<u32>(_e2072) & 2147483647u)) > ((0.0000038146973f * select(_e2156, _e2153, (_e2153 > _e2156))) * select(_e2170, _e2167, (_e2167 > _e2170))));
                                                                            if _e2174 {
                                                                                phi_3110_ = (_e2067 / _e2072);
                                                                            } else {
                                                                                phi_3110_ = f32();
                                                                            }
                                                                            let _e2177 = phi_3110_;
                                                                            phi_3112_ = _e2177;
                                                                            phi_3113_ = select(true, false, _e2174);
                                                                        } else {
                                                                            phi_3112_ = f32();
                                                                            phi_3113_ = true;
                                                                        }
                                                                        let _e2180 = phi_3112_;
                                                                        let _e2182 = phi_3113_;
                                                                        if _e2182 {
                                                                            let _e2190 = (((_e2038 * (_e2099 - (_e515 * _e2102))) + (_e2043 * (_e2100 - (_e581 * _e2102)))) / _e2072);
                                                                            if (bitcast<f32>((bitcast<u32>(_e2190) & 2147483647u)) <= _e2004) {
                                                                                phi_3133_ = (_e2102 + _e2190);
                                                                            } else {
                                                                                phi_3133_ = _e2102;
                                                                            }
                                                                            let _e2197 = phi_3133_;
                                                                            phi_3134_ = _e2197;
                                                                        } else {
                                                                            phi_3134_ = _e2180;
                                                                        }
                                                                        let _e2199 = phi_3134_;
                                                                        let _e2201 = select(_e1937, _e2199, (_e2199 < _e1937));
                                                                        let _e2203 = select(_e1929, _e2201, (_e2201 > _e1929));
                                                                        if (_e2203 >= _e761) {
                                                                            let _e2205 = (_e2203 <= _e1337.member_1);
                                                                            if _e2205 {
                                                                                let _e2206 = (1f / _e1856);
                                                                                phi_3157_ = type_21(_e2203, (_e1850 * _e2206), (_e1854 * _e2206), _e1397);
                                                                            } else {
                                                                                phi_3157_ = type_21();
                                                                            }
                                                                            let _e2211 = phi_3157_;
                                                                            phi_3159_ = _e2211;
                                                                            phi_3160_ = select(true, false, _e2205);
                                                                        } else {
                                                                            phi_3159_ = type_21();
                                                                            phi_3160_ = true;
                                                                        }
                                                                        let _e2214 = phi_3159_;
                                                                        let _e2216 = phi_3160_;
                                                                        if _e2216 {
                                                                            phi_3164_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_3164_ = _e2214;
                                                                        }
                                                                        let _e2218 = phi_3164_;
                                                                        phi_3165_ = _e2218;
                                                                    }
                                                                    let _e2220 = phi_3165_;
                                                                    phi_3166_ = _e2220;
                                                                    phi_3167_ = _e1946;
                                                                }
                                                                let _e2222 = phi_3166_;
                                                                let _e2224 = phi_3167_;
                                                                phi_3171_ = _e2222;
                                                                phi_3172_ = _e2224;
                                                            }
                                                            let _e2226 = phi_3171_;
                                                            let _e2228 = phi_3172_;
                                                            phi_3173_ = _e2226;
                                                            phi_3174_ = _e1881;
                                                            phi_3175_ = _e2228;
                                                        }
                                                        let _e2230 = phi_3173_;
                                                        let _e2232 = phi_3174_;
                                                        let _e2234 = phi_3175_;
                                                        phi_3176_ = _e2230;
                                                        phi_3177_ = _e2232;
                                                        phi_3178_ = _e2234;
                                                    }
                                                    let _e2236 = phi_3176_;
                                                    let _e2238 = phi_3177_;
                                                    let _e2240 = phi_3178_;
                                                    phi_3186_ = _e2236;
                                                    phi_3187_ = select(_e2240, true, _e2238);
                                                } else {
                                                    phi_3186_ = type_21();
                                                    phi_3187_ = true;
                                                }
                                                let _e2243 = phi_3186_;
                                                let _e2245 = phi_3187_;
                                                if _e2245 {
                                                    phi_3191_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_3191_ = _e2243;
                                                }
                                                let _e2247 = phi_3191_;
                                                if (_e2247.member_3 != 4294967295u) {
                                                    if (_e1397 == _e174) {
                                                        phi_3526_ = false;
                                                    } else {
                                                        let _e2251 = (_e1397 < arrayLength((&global_4.member)));
                                                        if _e2251 {
                                                            if _e2251 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e2253 = global_4.member[_e1397];
                                                            phi_3214_ = _e2253;
                                                        } else {
                                                            phi_3214_ = 4294967295u;
                                                        }
                                                        let _e2255 = phi_3214_;
                                                        let _e2256 = (_e2255 < arrayLength((&global_5.member)));
                                                        if _e2256 {
                                                            if _e2256 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e2258 = global_5.member[_e2255];
                                                            phi_3228_ = _e2258;
                                                        } else {
                                                            phi_3228_ = 0i;
                                                        }
                                                        let _e2260 = phi_3228_;
                                                        let _e2261 = (_e2260 == 0i);
                                                        if _e2261 {
                                                            phi_3525_ = true;
                                                        } else {
                                                            if _e452 {
                                                                phi_3251_ = vec3<f32>(_e1784[0][0], _e1784[0][1], _e1784[0][2]);
                                                            } else {
                                                                if (_e428 == 1u) {
                                                                    phi_3250_ = vec3<f32>(_e1784[0][2], _e1784[0][0], _e1784[0][1]);
                                                                } else {
                                                                    phi_3250_ = vec3<f32>(_e1784[0][1], _e1784[0][2], _e1784[0][0]);
                                                                }
                                                                let _e2266 = phi_3250_;
                                                                phi_3251_ = _e2266;
                                                            }
                                                            let _e2269 = phi_3251_;
                                                            if _e452 {
                                                                phi_3270_ = vec3<f32>(_e1784[1][0], _e1784[1][1], _e1784[1][2]);
                                                            } else {
                                                                if (_e428 == 1u) {
                                                                    phi_3269_ = vec3<f32>(_e1784[1][2], _e1784[1][0], _e1784[1][1]);
                                                                } else {
                                                                    phi_3269_ = vec3<f32>(_e1784[1][1], _e1784[1][2], _e1784[1][0]);
                                                                }
                                                                let _e2274 = phi_3269_;
                                                                phi_3270_ = _e2274;
                                                            }
                                                            let _e2277 = phi_3270_;
                                                            if _e452 {
                                                                phi_3289_ = vec3<f32>(_e1784[2][0], _e1784[2][1], _e1784[2][2]);
                                                            } else {
                                                                if (_e428 == 1u) {
                                                                    phi_3288_ = vec3<f32>(_e1784[2][2], _e1784[2][0], _e1784[2][1]);
                                                                } else {
                                                                    phi_3288_ = vec3<f32>(_e1784[2][1], _e1784[2][2], _e1784[2][0]);
                                                                }
                                                                let _e2282 = phi_3288_;
                                                                phi_3289_ = _e2282;
                                                            }
                                                            let _e2285 = phi_3289_;
                                                            let _e2288 = (_e2277.x - _e2269.x);
                                                            let _e2291 = (_e2277.y - _e2269.y);
                                                            let _e2294 = (_e2277.z - _e2269.z);
                                                            let _e2296 = (_e2285.x - _e2269.x);
                                                            let _e2298 = (_e2285.y - _e2269.y);
                                                            let _e2300 = (_e2285.z - _e2269.z);
                                                            if (_e306.member_1 == 1u) {
                                                                phi_3325_ = (vec3<f32>(_e306.member[0], _e306.member[1], _e306.member[2]) - _e2269);
                                                            } else {
                                                                phi_3325_ = vec3<f32>(_e306.member[0], _e306.member[1], _e306.member[2]);
                                                            }
                                                            let _e2315 = phi_3325_;
                                                            let _e2321 = bitcast<f32>((bitcast<u32>((_e2288 * _e2298)) ^ _e306.member_3[0]));
                                                            let _e2325 = bitcast<f32>((bitcast<u32>((_e2291 * _e2296)) ^ _e306.member_3[0]));
                                                            let _e2329 = bitcast<f32>((bitcast<u32>((_e2291 * _e2300)) ^ _e306.member_3[0]));
                                                            let _e2333 = bitcast<f32>((bitcast<u32>((_e2294 * _e2298)) ^ _e306.member_3[0]));
                                                            let _e2337 = bitcast<f32>((bitcast<u32>((_e2294 * _e2296)) ^ _e306.member_3[0]));
                                                            let _e2341 = bitcast<f32>((bitcast<u32>((_e2288 * _e2300)) ^ _e306.member_3[0]));
                                                            let _e2342 = (_e2329 - _e2333);
                                                            let _e2343 = (_e2337 - _e2341);
                                                            let _e2344 = (_e2321 - _e2325);
                                                            let _e2368 = (bitcast<f32>((bitcast<u32>(_e2329) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2333) & 2147483647u)));
                                                            let _e2375 = (bitcast<f32>((bitcast<u32>(_e2337) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2341) & 2147483647u)));
                                                            let _e2382 = (bitcast<f32>((bitcast<u32>(_e2321) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2325) & 2147483647u)));
                                                            if (_e306.member_2 == 0f) {
                                                                phi_3507_ = 0f;
                                                            } else {
                                                                let _e2412 = bitcast<f32>((bitcast<u32>(_e2342) & 2147483647u));
                                                                let _e2415 = bitcast<f32>((bitcast<u32>(_e2343) & 2147483647u));
                                                                let _e2418 = bitcast<f32>((bitcast<u32>(_e2344) & 2147483647u));
                                                                let _e2420 = select(_e2418, _e2415, (_e2415 > _e2418));
                                                                let _e2424 = select(_e2418, _e2415, (_e2415 < _e2418));
                                                                let _e2428 = select(_e2415, _e2412, (_e2412 < _e2415));
                                                                let _e2430 = select(_e2415, _e2412, (_e2412 > _e2415));
                                                                let _e2432 = select(_e2418, _e2430, (_e2430 < _e2418));
                                                                phi_3507_ = bitcast<f32>((bitcast<u32>((_e306.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2420, _e2412, (_e2412 > _e2420)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2432, _e2428, (_e2428 > _e2432)))) ^ _e306.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2424, _e2412, (_e2412 < _e2424)))) ^ _e306.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e2368 + _e2375) + _e2382))) ^ _e306.member_3[0]))) * 1.0000005f)) ^ _e306.member_3[0])))) ^ _e306.member_3[0]));
                                                            }
                                                            let _e2459 = phi_3507_;
                                                            phi_3525_ = (_e2261 || !(((((bitcast<f32>((bitcast<u32>((_e2315.x * _e2342)) ^ _e306.member_3[0])) + bitcast<f32>((bitcast<u32>((_e2315.y * _e2343)) ^ _e306.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e2315.z * _e2344)) ^ _e306.member_3[0]))) * f32(-(_e2260))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2315.x) & 2147483647u)) * _e2368)) ^ _e306.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2315.y) & 2147483647u)) * _e2375)) ^ _e306.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2315.z) & 2147483647u)) * _e2382)) ^ _e306.member_3[0]))))) ^ _e306.member_3[0])) + _e2459) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e2473 = phi_3525_;
                                                        phi_3526_ = _e2473;
                                                    }
                                                    let _e2475 = phi_3526_;
                                                    if _e2475 {
                                                        if (_e2247.member < _e1337.member.member) {
                                                            phi_3546_ = true;
                                                        } else {
                                                            if (_e2247.member == _e1337.member.member) {
                                                                phi_3545_ = (_e2247.member_3 < _e1337.member.member_3);
                                                            } else {
                                                                phi_3545_ = false;
                                                            }
                                                            let _e2485 = phi_3545_;
                                                            phi_3546_ = _e2485;
                                                        }
                                                        let _e2487 = phi_3546_;
                                                        if _e2487 {
                                                            phi_3552_ = type_39(_e2247, _e2247.member);
                                                        } else {
                                                            phi_3552_ = _e1337;
                                                        }
                                                        let _e2490 = phi_3552_;
                                                        phi_3553_ = _e2490;
                                                    } else {
                                                        phi_3553_ = _e1337;
                                                    }
                                                    let _e2492 = phi_3553_;
                                                    phi_3554_ = _e2492;
                                                } else {
                                                    phi_3554_ = _e1337;
                                                }
                                                let _e2494 = phi_3554_;
                                                phi_1529_ = _e2494;
                                            } else {
                                                phi_1529_ = type_39();
                                            }
                                            let _e2496 = phi_1529_;
                                            continue;
                                            continuing {
                                                phi_1528_ = _e2496;
                                                phi_1531_ = _e1352;
                                                phi_5270_ = _e803;
                                                break if !(_e1358);
                                            }
                                        }
                                        let _e2499 = phi_5270_;
                                        phi_5509_ = _e2499;
                                        if _e2499 {
                                            break;
                                        }
                                        phi_5513_ = _e2499;
                                        let _e2866 = local_11;
                                        phi_4825_ = _e2866;
                                        phi_4826_ = false;
                                        phi_4827_ = _e846;
                                        phi_4828_ = _e848;
                                    } else {
                                        if (_e848.member_1 >= _e106) {
                                            phi_4360_ = type_58(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_57(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_57(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e848.member_1 < _e106) {
                                            } else {
                                                phi_5509_ = true;
                                                break;
                                            }
                                            let _e860 = (_e428 * 2u);
                                            let _e862 = ((1u + _e860) % 7u);
                                            if (_e862 < 7u) {
                                            } else {
                                                phi_5509_ = true;
                                                break;
                                            }
                                            let _e867 = global_9.member[_e848.member_1][_e862];
                                            let _e869 = ((_e860 + 2u) % 7u);
                                            if (_e869 < 7u) {
                                            } else {
                                                phi_5509_ = true;
                                                break;
                                            }
                                            let _e874 = global_9.member[_e848.member_1][_e869];
                                            let _e875 = (_e427 * 2u);
                                            let _e877 = ((1u + _e875) % 7u);
                                            if (_e877 < 7u) {
                                            } else {
                                                phi_5509_ = true;
                                                break;
                                            }
                                            let _e882 = global_9.member[_e848.member_1][_e877];
                                            let _e884 = ((_e875 + 2u) % 7u);
                                            if (_e884 < 7u) {
                                            } else {
                                                phi_5509_ = true;
                                                break;
                                            }
                                            let _e889 = global_9.member[_e848.member_1][_e884];
                                            let _e890 = (_e429 * 2u);
                                            let _e892 = ((1u + _e890) % 7u);
                                            if (_e892 < 7u) {
                                            } else {
                                                phi_5509_ = true;
                                                break;
                                            }
                                            let _e897 = global_9.member[_e848.member_1][_e892];
                                            let _e899 = ((_e890 + 2u) % 7u);
                                            if (_e899 < 7u) {
                                            } else {
                                                phi_5509_ = true;
                                                break;
                                            }
                                            let _e904 = global_9.member[_e848.member_1][_e899];
                                            let _e927 = (bitcast<f32>((bitcast<u32>((_e848.member.member_1.x - _e848.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e928 = (bitcast<f32>((bitcast<u32>((_e848.member.member_1.y - _e848.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e929 = (bitcast<f32>((bitcast<u32>((_e848.member.member_1.z - _e848.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e931 = select(_e165, _e927, (_e927 > _e165));
                                            let _e933 = select(_e165, _e928, (_e928 > _e165));
                                            let _e935 = select(_e165, _e929, (_e929 > _e165));
                                            let _e966 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e867 & 2097151u))) - 8388608f) * _e931));
                                            let _e971 = (bitcast<i32>((_e867 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e974 = bitcast<f32>((_e966 & bitcast<u32>(_e971)));
                                            let _e975 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e882 & 2097151u))) - 8388608f) * _e933));
                                            let _e980 = (bitcast<i32>((_e882 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e983 = bitcast<f32>((_e975 & bitcast<u32>(_e980)));
                                            let _e984 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e897 & 2097151u))) - 8388608f) * _e935));
                                            let _e989 = (bitcast<i32>((_e897 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e992 = bitcast<f32>((_e984 & bitcast<u32>(_e989)));
                                            let _e996 = bitcast<f32>((_e966 & bitcast<u32>(~(_e971))));
                                            let _e1000 = bitcast<f32>((_e975 & bitcast<u32>(~(_e980))));
                                            let _e1004 = bitcast<f32>((_e984 & bitcast<u32>(~(_e989))));
                                            let _e1005 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e874 & 2097151u))) - 8388608f) * _e931));
                                            let _e1010 = (bitcast<i32>((_e874 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1013 = bitcast<f32>((_e1005 & bitcast<u32>(_e1010)));
                                            let _e1014 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e889 & 2097151u))) - 8388608f) * _e933));
                                            let _e1019 = (bitcast<i32>((_e889 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1022 = bitcast<f32>((_e1014 & bitcast<u32>(_e1019)));
                                            let _e1023 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e904 & 2097151u))) - 8388608f) * _e935));
                                            let _e1028 = (bitcast<i32>((_e904 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1031 = bitcast<f32>((_e1023 & bitcast<u32>(_e1028)));
                                            let _e1035 = bitcast<f32>((_e1005 & bitcast<u32>(~(_e1010))));
                                            let _e1039 = bitcast<f32>((_e1014 & bitcast<u32>(~(_e1019))));
                                            let _e1043 = bitcast<f32>((_e1023 & bitcast<u32>(~(_e1028))));
                                            let _e1044 = (_e848.member.member.x + _e974);
                                            let _e1045 = (_e848.member.member.y + _e983);
                                            let _e1046 = (_e848.member.member.z + _e992);
                                            let _e1049 = (_e848.member.member_1.x - _e1013);
                                            let _e1050 = (_e848.member.member_1.y - _e1022);
                                            let _e1051 = (_e848.member.member_1.z - _e1031);
                                            let _e1070 = (_e1049 - _e1044);
                                            let _e1071 = (_e1050 - _e1045);
                                            let _e1072 = (_e1051 - _e1046);
                                            let _e1074 = select(_e1071, _e1070, (_e1070 > _e1071));
                                            let _e1076 = select(_e1072, _e1074, (_e1074 > _e1072));
                                            if (_e1076 < (1024f * _e165)) {
                                                phi_4061_ = 0u;
                                            } else {
                                                phi_4061_ = select(2u, 1u, (_e1076 < (2097152f * _e165)));
                                            }
                                            let _e1083 = phi_4061_;
                                            switch bitcast<i32>(_e1083) {
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
                                            let _e1086 = phi_4067_;
                                            let _e1092 = global_9.member[_e848.member_1][0u];
                                            let _e1096 = global_9.member[_e848.member_1][2u];
                                            let _e1100 = global_9.member[_e848.member_1][4u];
                                            let _e1104 = global_9.member[_e848.member_1][6u];
                                            let _e1116 = (((_e1096 >> bitcast<u32>(22i)) | ((_e1100 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1104 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1117 = (_e1092 & 268435455u);
                                            let _e1118 = (_e1116 & 268435455u);
                                            let _e1121 = ((_e1092 >> bitcast<u32>(28u)) & 7u);
                                            let _e1129 = ((_e1092 >> bitcast<u32>(31i)) | (((_e1116 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1130 = (_e1121 != 0u);
                                            if (_e1121 == 0u) {
                                                phi_4322_ = _e1117;
                                            } else {
                                                if (_e1121 == 7u) {
                                                    phi_4321_ = 2147483648u;
                                                } else {
                                                    phi_4321_ = ((2147483648u | (_e1121 << bitcast<u32>(28u))) | (_e1118 & 268435455u));
                                                }
                                                let _e1139 = phi_4321_;
                                                phi_4322_ = _e1139;
                                            }
                                            let _e1141 = phi_4322_;
                                            if _e1130 {
                                                let _e1142 = (_e1121 != 7u);
                                                if _e1142 {
                                                    phi_4332_ = (_e1118 + (_e1121 * ((3u * _e1086) + 1u)));
                                                } else {
                                                    phi_4332_ = u32();
                                                }
                                                let _e1146 = phi_4332_;
                                                phi_4334_ = _e1146;
                                                phi_4335_ = select(true, false, _e1142);
                                            } else {
                                                phi_4334_ = u32();
                                                phi_4335_ = true;
                                            }
                                            let _e1149 = phi_4334_;
                                            let _e1151 = phi_4335_;
                                            if (_e1129 == 0u) {
                                                phi_4356_ = (_e1117 + select(0u, 1u, !(_e1130)));
                                            } else {
                                                if (_e1129 == 7u) {
                                                    phi_4355_ = 2147483648u;
                                                } else {
                                                    phi_4355_ = ((2147483648u | (_e1129 << bitcast<u32>(28u))) | (select(_e1149, _e1118, _e1151) & 268435455u));
                                                }
                                                let _e1164 = phi_4355_;
                                                phi_4356_ = _e1164;
                                            }
                                            let _e1166 = phi_4356_;
                                            phi_4360_ = type_58(array<vec4<f32>, 3>(vec4<f32>(_e1044, (_e848.member.member.x + _e996), _e1049, (_e848.member.member_1.x - _e1035)), vec4<f32>(_e1045, (_e848.member.member.y + _e1000), _e1050, (_e848.member.member_1.y - _e1039)), vec4<f32>(_e1046, (_e848.member.member.z + _e1004), _e1051, (_e848.member.member_1.z - _e1043))), type_57(type_33((_e848.member.member + vec4<f32>(_e974, _e983, _e992, 0f)), (_e848.member.member_1 - vec4<f32>(_e1013, _e1022, _e1031, 0f))), _e1141), type_57(type_33((_e848.member.member + vec4<f32>(_e996, _e1000, _e1004, 0f)), (_e848.member.member_1 - vec4<f32>(_e1035, _e1039, _e1043, 0f))), _e1166));
                                        }
                                        let _e1171 = phi_4360_;
                                        let _e1183 = ((_e1171.member[0].x - _e513) * _e518);
                                        let _e1184 = ((_e1171.member[0].y - _e513) * _e518);
                                        let _e1185 = ((_e1171.member[0].z - _e514) * _e518);
                                        let _e1186 = ((_e1171.member[0].w - _e514) * _e518);
                                        let _e1196 = ((_e1171.member[1].x - _e579) * _e584);
                                        let _e1197 = ((_e1171.member[1].y - _e579) * _e584);
                                        let _e1198 = ((_e1171.member[1].z - _e580) * _e584);
                                        let _e1199 = ((_e1171.member[1].w - _e580) * _e584);
                                        let _e1209 = ((_e1171.member[2].x - _e645) * _e650);
                                        let _e1210 = ((_e1171.member[2].y - _e645) * _e650);
                                        let _e1211 = ((_e1171.member[2].z - _e646) * _e650);
                                        let _e1212 = ((_e1171.member[2].w - _e646) * _e650);
                                        let _e1214 = select(_e1211, _e1209, (_e1209 < _e1211));
                                        let _e1216 = select(_e1212, _e1210, (_e1210 < _e1212));
                                        let _e1218 = select(_e1211, _e1209, (_e1209 > _e1211));
                                        let _e1220 = select(_e1212, _e1210, (_e1210 > _e1212));
                                        let _e1222 = select(_e1185, _e1183, (_e1183 < _e1185));
                                        let _e1224 = select(_e1186, _e1184, (_e1184 < _e1186));
                                        let _e1226 = select(_e1198, _e1196, (_e1196 < _e1198));
                                        let _e1228 = select(_e1199, _e1197, (_e1197 < _e1199));
                                        let _e1230 = select(_e1226, _e1222, (_e1222 > _e1226));
                                        let _e1232 = select(_e1228, _e1224, (_e1224 > _e1228));
                                        let _e1234 = select(_e1214, _e1230, (_e1230 > _e1214));
                                        let _e1236 = select(_e1216, _e1232, (_e1232 > _e1216));
                                        let _e1238 = select(_e1185, _e1183, (_e1183 > _e1185));
                                        let _e1240 = select(_e1186, _e1184, (_e1184 > _e1186));
                                        let _e1242 = select(_e1198, _e1196, (_e1196 > _e1198));
                                        let _e1244 = select(_e1199, _e1197, (_e1197 > _e1199));
                                        let _e1246 = select(_e1242, _e1238, (_e1238 < _e1242));
                                        let _e1248 = select(_e1244, _e1240, (_e1240 < _e1244));
                                        let _e1253 = -(_e1214);
                                        let _e1254 = -(_e1216);
                                        let _e1261 = (select(_e1218, _e1246, (_e1246 < _e1218)) + (select(_e1253, _e1218, (_e1218 > _e1253)) * 0.0000019073523f));
                                        let _e1262 = (select(_e1220, _e1248, (_e1248 < _e1220)) + (select(_e1254, _e1220, (_e1220 > _e1254)) * 0.0000019073523f));
                                        let _e1264 = select(_e761, _e1234, (_e1234 > _e761));
                                        let _e1266 = select(_e761, _e1236, (_e1236 > _e761));
                                        let _e1271 = (_e1264 <= select(_e805.member_1, _e1261, (_e1261 < _e805.member_1)));
                                        let _e1272 = (_e1266 <= select(_e805.member_1, _e1262, (_e1262 < _e805.member_1)));
                                        let _e1273 = (_e1264 <= _e1266);
                                        if _e1271 {
                                            if _e1272 {
                                                if _e1273 {
                                                    phi_4722_ = _e1171.member_2;
                                                } else {
                                                    phi_4722_ = _e1171.member_1;
                                                }
                                                let _e1277 = phi_4722_;
                                                let _e1299 = (_e846 % 128u);
                                                let _e1300 = (_e1299 < 128u);
                                                if _e1300 {
                                                } else {
                                                    phi_5509_ = true;
                                                    break;
                                                }
                                                local_8[_e1299] = _e1277.member_1;
                                                if _e1300 {
                                                } else {
                                                    phi_5509_ = true;
                                                    break;
                                                }
                                                local_7[_e1299] = _e1277.member.member.x;
                                                if _e1300 {
                                                } else {
                                                    phi_5509_ = true;
                                                    break;
                                                }
                                                local_6[_e1299] = _e1277.member.member.y;
                                                if _e1300 {
                                                } else {
                                                    phi_5509_ = true;
                                                    break;
                                                }
                                                local_5[_e1299] = _e1277.member.member.z;
                                                if _e1300 {
                                                } else {
                                                    phi_5509_ = true;
                                                    break;
                                                }
                                                local_4[_e1299] = _e1277.member.member_1.x;
                                                if _e1300 {
                                                } else {
                                                    phi_5509_ = true;
                                                    break;
                                                }
                                                local_3[_e1299] = _e1277.member.member_1.y;
                                                if _e1300 {
                                                } else {
                                                    phi_5509_ = true;
                                                    break;
                                                }
                                                local_2[_e1299] = _e1277.member.member_1.z;
                                                if _e1300 {
                                                } else {
                                                    phi_5509_ = true;
                                                    break;
                                                }
                                                local_9[_e1299] = select(_e1266, _e1264, !(_e1273));
                                                if _e1273 {
                                                    phi_4799_ = _e1171.member_1;
                                                } else {
                                                    phi_4799_ = _e1171.member_2;
                                                }
                                                let _e1313 = phi_4799_;
                                                phi_4800_ = (_e846 + 1u);
                                                phi_4801_ = _e1313;
                                            } else {
                                                phi_4800_ = u32();
                                                phi_4801_ = type_57();
                                            }
                                            let _e1315 = phi_4800_;
                                            let _e1317 = phi_4801_;
                                            phi_4803_ = _e1315;
                                            phi_4804_ = _e1317;
                                            phi_4805_ = select(true, false, _e1272);
                                        } else {
                                            phi_4803_ = u32();
                                            phi_4804_ = type_57();
                                            phi_4805_ = true;
                                        }
                                        let _e1320 = phi_4803_;
                                        let _e1322 = phi_4804_;
                                        let _e1324 = phi_4805_;
                                        if _e1324 {
                                            if _e1271 {
                                                phi_4814_ = _e1171.member_1;
                                            } else {
                                                phi_4814_ = _e1171.member_2;
                                            }
                                            let _e1328 = phi_4814_;
                                            phi_4819_ = select(_e1272, true, _e1271);
                                            phi_4821_ = _e1328;
                                        } else {
                                            phi_4819_ = _e844;
                                            phi_4821_ = _e1322;
                                        }
                                        let _e1331 = phi_4819_;
                                        let _e1333 = phi_4821_;
                                        phi_5513_ = _e803;
                                        phi_4825_ = _e805;
                                        phi_4826_ = _e1331;
                                        phi_4827_ = select(_e1320, _e846, _e1324);
                                        phi_4828_ = _e1333;
                                    }
                                    let _e2501 = phi_5513_;
                                    let _e2503 = phi_4825_;
                                    let _e2505 = phi_4826_;
                                    let _e2507 = phi_4827_;
                                    let _e2509 = phi_4828_;
                                    phi_5512_ = _e2501;
                                    phi_4829_ = _e2503;
                                    phi_4830_ = _e2505;
                                    phi_4831_ = (_e809 - 1u);
                                    phi_4832_ = _e2507;
                                    phi_4833_ = _e2509;
                                } else {
                                    phi_5512_ = _e803;
                                    phi_4829_ = _e805;
                                    phi_4830_ = _e844;
                                    phi_4831_ = _e809;
                                    phi_4832_ = _e846;
                                    phi_4833_ = _e848;
                                }
                                let _e2511 = phi_5512_;
                                let _e2513 = phi_4829_;
                                let _e2515 = phi_4830_;
                                let _e2517 = phi_4831_;
                                let _e2519 = phi_4832_;
                                let _e2521 = phi_4833_;
                                phi_5511_ = _e2511;
                                phi_4834_ = _e2513;
                                phi_4835_ = _e2515;
                                phi_4836_ = _e2517;
                                phi_4837_ = _e2519;
                                phi_4838_ = _e2521;
                            } else {
                                phi_5511_ = _e803;
                                phi_4834_ = type_39();
                                phi_4835_ = bool();
                                phi_4836_ = u32();
                                phi_4837_ = u32();
                                phi_4838_ = type_57();
                            }
                            let _e2523 = phi_5511_;
                            let _e2525 = phi_4834_;
                            let _e2527 = phi_4835_;
                            let _e2529 = phi_4836_;
                            let _e2531 = phi_4837_;
                            let _e2533 = phi_4838_;
                            phi_5510_ = _e2523;
                            phi_1402_ = _e2525;
                            phi_1405_ = _e2527;
                            phi_1407_ = _e2529;
                            phi_1409_ = _e2531;
                            phi_1411_ = _e2533;
                            phi_4839_ = _e817;
                        } else {
                            phi_5510_ = _e803;
                            phi_1402_ = type_39();
                            phi_1405_ = bool();
                            phi_1407_ = u32();
                            phi_1409_ = u32();
                            phi_1411_ = type_57();
                            phi_4839_ = false;
                        }
                        let _e2535 = phi_5510_;
                        let _e2537 = phi_1402_;
                        let _e2539 = phi_1405_;
                        let _e2541 = phi_1407_;
                        let _e2543 = phi_1409_;
                        let _e2545 = phi_1411_;
                        let _e2547 = phi_4839_;
                        continue;
                        continuing {
                            phi_5276_ = _e2535;
                            phi_1401_ = _e2537;
                            phi_1404_ = _e2539;
                            phi_1406_ = _e2541;
                            phi_1408_ = _e2543;
                            phi_1410_ = _e2545;
                            phi_5509_ = _e2535;
                            break if !(_e2547);
                        }
                    }
                    let _e2550 = phi_5509_;
                    if _e2550 {
                        break;
                    }
                    let _e2552 = local_10;
                    if (_e2552.member.member_3 != 4294967295u) {
                        let _e2557 = bitcast<u32>(_e2552.member.member);
                        let _e2561 = (bitcast<i32>((_e2557 >> bitcast<u32>(23i))) & 255i);
                        let _e2562 = (_e2561 + _e430);
                        if (_e2561 == 255i) {
                            phi_4898_ = _e2552.member.member;
                        } else {
                            if (_e2561 > 0i) {
                                if (_e2562 > 0i) {
                                    let _e2566 = (_e2562 < 255i);
                                    if _e2566 {
                                        phi_4877_ = bitcast<f32>((_e2557 + bitcast<u32>((_e430 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_4877_ = f32();
                                    }
                                    let _e2573 = phi_4877_;
                                    phi_4879_ = _e2573;
                                    phi_4880_ = select(true, false, _e2566);
                                } else {
                                    phi_4879_ = f32();
                                    phi_4880_ = true;
                                }
                                let _e2576 = phi_4879_;
                                let _e2578 = phi_4880_;
                                phi_4881_ = _e2576;
                                phi_4882_ = _e2578;
                            } else {
                                phi_4881_ = f32();
                                phi_4882_ = true;
                            }
                            let _e2580 = phi_4881_;
                            let _e2582 = phi_4882_;
                            if _e2582 {
                                let _e2583 = (_e2557 & 2147483648u);
                                let _e2590 = ((_e2557 & 8388607u) | (select(0u, 1u, ((_e2557 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e2594 = (_e2590 == 0u);
                                if _e2594 {
                                    phi_5228_ = bitcast<f32>(_e2583);
                                } else {
                                    let _e2599 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2590)), 32u, _e2594) - 8u);
                                    let _e2602 = (_e2590 << bitcast<u32>((_e2599 & 31u)));
                                    let _e2604 = ((_e2562 + select(0i, 1i, (_e2561 == 0i))) - bitcast<i32>(_e2599));
                                    if (_e2604 >= 255i) {
                                        phi_5218_ = bitcast<f32>((_e2583 | 2139095040u));
                                        phi_5219_ = f32();
                                        phi_5220_ = true;
                                    } else {
                                        let _e2606 = (_e2604 > 0i);
                                        if _e2606 {
                                            phi_5212_ = bitcast<f32>(((_e2583 | (bitcast<u32>(_e2604) << bitcast<u32>(23i))) | (_e2602 & 8388607u)));
                                            phi_5213_ = f32();
                                        } else {
                                            if (_e2604 < -24i) {
                                                phi_5178_ = 26u;
                                            } else {
                                                phi_5178_ = bitcast<u32>((1i - _e2604));
                                            }
                                            let _e2611 = phi_5178_;
                                            let _e2612 = (_e2611 & 31u);
                                            let _e2614 = (_e2602 >> bitcast<u32>(_e2612));
                                            let _e2618 = (_e2602 & ((1u << bitcast<u32>(_e2612)) - 1u));
                                            let _e2622 = (1u << bitcast<u32>(((_e2611 - 1u) & 31u)));
                                            if (_e2618 > _e2622) {
                                                phi_5199_ = true;
                                            } else {
                                                if (_e2618 == _e2622) {
                                                    phi_5196_ = ((_e2614 & 1u) == 1u);
                                                } else {
                                                    phi_5196_ = false;
                                                }
                                                let _e2628 = phi_5196_;
                                                phi_5199_ = _e2628;
                                            }
                                            let _e2630 = phi_5199_;
                                            phi_5212_ = f32();
                                            phi_5213_ = bitcast<f32>((_e2583 | (_e2614 + select(0u, 1u, _e2630))));
                                        }
                                        let _e2643 = phi_5212_;
                                        let _e2645 = phi_5213_;
                                        phi_5218_ = _e2643;
                                        phi_5219_ = _e2645;
                                        phi_5220_ = _e2606;
                                    }
                                    let _e2649 = phi_5218_;
                                    let _e2651 = phi_5219_;
                                    let _e2653 = phi_5220_;
                                    phi_5228_ = select(_e2651, _e2649, _e2653);
                                }
                                let _e2657 = phi_5228_;
                                phi_4897_ = _e2657;
                            } else {
                                phi_4897_ = _e2580;
                            }
                            let _e2659 = phi_4897_;
                            phi_4898_ = _e2659;
                        }
                        let _e2661 = phi_4898_;
                        let _e2662 = bitcast<u32>(_e2661);
                        if ((_e2662 & 2147483647u) >= 2139095040u) {
                            phi_4910_ = bitcast<f32>(((_e2662 & 2147483648u) | 2139095039u));
                        } else {
                            phi_4910_ = _e2661;
                        }
                        let _e2669 = phi_4910_;
                        phi_4915_ = type_21(_e2669, _e2552.member.member_1, _e2552.member.member_2, _e2552.member.member_3);
                    } else {
                        phi_4915_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2674 = phi_4915_;
                    if _e307 {
                    } else {
                        break;
                    }
                    global_7.member[_e153] = _e2674;
                    if _e168 {
                    } else {
                        break;
                    }
                    let _e2678 = select(0u, 1u, (_e374 <= _e384));
                    if (_e2678 > 0u) {
                        let _e2680 = (1u < _e121);
                        if _e2680 {
                            if (0u < _e121) {
                            } else {
                                break;
                            }
                            let _e2684 = atomicAdd((&global_8.member[0u]), _e2678);
                            if ((_e2684 + _e2678) < _e2684) {
                                if _e2680 {
                                } else {
                                    break;
                                }
                                let _e2689 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                    }
                    let _e2692 = select(0u, 1u, (_e2674.member_3 != 4294967295u));
                    if (_e2692 > 0u) {
                        let _e2694 = (3u < _e121);
                        if _e2694 {
                            if (2u < _e121) {
                            } else {
                                break;
                            }
                            let _e2698 = atomicAdd((&global_8.member[2u]), _e2692);
                            if ((_e2698 + _e2692) < _e2698) {
                                if _e2694 {
                                } else {
                                    break;
                                }
                                let _e2703 = atomicAdd((&global_8.member[3u]), 1u);
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
