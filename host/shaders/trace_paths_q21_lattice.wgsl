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

struct type_38 {
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
    var phi_416_: u32;
    var phi_460_: i32;
    var phi_600_: type_35;
    var phi_706_: i32;
    var phi_707_: i32;
    var phi_717_: bool;
    var phi_727_: u32;
    var phi_728_: u32;
    var phi_730_: bool;
    var phi_735_: u32;
    var phi_767_: i32;
    var phi_785_: f32;
    var phi_791_: f32;
    var phi_831_: f32;
    var phi_837_: f32;
    var phi_889_: f32;
    var phi_900_: f32;
    var phi_909_: f32;
    var phi_915_: f32;
    var phi_955_: f32;
    var phi_961_: f32;
    var phi_1013_: f32;
    var phi_1024_: f32;
    var phi_1033_: f32;
    var phi_1039_: f32;
    var phi_1079_: f32;
    var phi_1085_: f32;
    var phi_1137_: f32;
    var phi_1148_: f32;
    var phi_1203_: i32;
    var phi_1225_: u32;
    var phi_1226_: u32;
    var phi_1263_: i32;
    var phi_1285_: u32;
    var phi_1286_: u32;
    var phi_1294_: f32;
    var phi_1295_: f32;
    var phi_5136_: bool;
    var phi_1384_: type_38;
    var phi_1387_: type_57;
    var phi_1389_: u32;
    var phi_1391_: bool;
    var phi_1393_: u32;
    var phi_1404_: bool;
    var phi_1490_: type_57;
    var phi_1491_: bool;
    var phi_1492_: u32;
    var phi_3942_: u32;
    var phi_3948_: u32;
    var phi_4202_: u32;
    var phi_4203_: u32;
    var phi_4213_: u32;
    var phi_4215_: u32;
    var phi_4216_: bool;
    var phi_4236_: u32;
    var phi_4237_: u32;
    var phi_4241_: type_58;
    var phi_4585_: type_57;
    var phi_4662_: type_57;
    var phi_4663_: type_57;
    var phi_4664_: u32;
    var phi_4666_: type_57;
    var phi_4667_: u32;
    var phi_4668_: bool;
    var phi_4677_: type_57;
    var phi_4682_: type_57;
    var phi_4683_: bool;
    var phi_1511_: type_38;
    var phi_1514_: type_8;
    var phi_1515_: type_8;
    var phi_1537_: type_8;
    var phi_1578_: u32;
    var phi_1584_: u32;
    var phi_1594_: u32;
    var phi_1610_: u32;
    var phi_1643_: u32;
    var phi_1649_: u32;
    var phi_2094_: u32;
    var phi_2112_: u32;
    var phi_2130_: u32;
    var phi_2150_: u32;
    var phi_2168_: u32;
    var phi_2186_: u32;
    var phi_2206_: u32;
    var phi_2224_: u32;
    var phi_2242_: u32;
    var phi_1811_: u32;
    var phi_1826_: u32;
    var phi_1836_: u32;
    var phi_1857_: u32;
    var phi_1878_: u32;
    var phi_1905_: u32;
    var phi_1920_: u32;
    var phi_1930_: u32;
    var phi_1951_: u32;
    var phi_1972_: u32;
    var phi_1999_: u32;
    var phi_2014_: u32;
    var phi_2024_: u32;
    var phi_2045_: u32;
    var phi_2066_: u32;
    var phi_1673_: u32;
    var phi_1719_: u32;
    var phi_1765_: u32;
    var phi_2248_: array<array<f32, 3>, 3>;
    var phi_2365_: bool;
    var phi_2394_: bool;
    var phi_2795_: f32;
    var phi_2796_: f32;
    var phi_2797_: f32;
    var phi_2798_: f32;
    var phi_2799_: vec3<f32>;
    var phi_2800_: vec3<f32>;
    var phi_2801_: vec3<f32>;
    var phi_2802_: vec3<f32>;
    var phi_2833_: bool;
    var phi_2842_: vec3<f32>;
    var phi_3007_: f32;
    var phi_3009_: f32;
    var phi_3010_: bool;
    var phi_3030_: f32;
    var phi_3031_: f32;
    var phi_3054_: type_21;
    var phi_3056_: type_21;
    var phi_3057_: bool;
    var phi_3061_: type_21;
    var phi_3062_: type_21;
    var phi_3063_: type_21;
    var phi_3064_: bool;
    var phi_3068_: type_21;
    var phi_3069_: bool;
    var phi_3070_: type_21;
    var phi_3071_: bool;
    var phi_3072_: bool;
    var phi_3073_: type_21;
    var phi_3074_: bool;
    var phi_3075_: bool;
    var phi_3083_: type_21;
    var phi_3084_: bool;
    var phi_3088_: type_21;
    var phi_3111_: u32;
    var phi_3125_: i32;
    var phi_3145_: vec3<f32>;
    var phi_3146_: vec3<f32>;
    var phi_3162_: vec3<f32>;
    var phi_3163_: vec3<f32>;
    var phi_3179_: vec3<f32>;
    var phi_3180_: vec3<f32>;
    var phi_3216_: vec3<f32>;
    var phi_3398_: f32;
    var phi_3416_: bool;
    var phi_3417_: bool;
    var phi_3436_: bool;
    var phi_3437_: bool;
    var phi_3443_: type_38;
    var phi_3444_: type_38;
    var phi_3445_: type_38;
    var phi_1512_: type_38;
    var phi_5130_: bool;
    var phi_5373_: bool;
    var phi_4685_: type_38;
    var phi_4686_: type_57;
    var phi_4687_: bool;
    var phi_4688_: u32;
    var phi_5372_: bool;
    var phi_4689_: type_38;
    var phi_4690_: type_57;
    var phi_4691_: u32;
    var phi_4692_: bool;
    var phi_4693_: u32;
    var phi_5371_: bool;
    var phi_4694_: type_38;
    var phi_4695_: type_57;
    var phi_4696_: u32;
    var phi_4697_: bool;
    var phi_4698_: u32;
    var phi_5370_: bool;
    var phi_1385_: type_38;
    var phi_1388_: type_57;
    var phi_1390_: u32;
    var phi_1392_: bool;
    var phi_1394_: u32;
    var phi_4699_: bool;
    var phi_5369_: bool;
    var local_10: type_38;
    var phi_4737_: f32;
    var phi_4739_: f32;
    var phi_4740_: bool;
    var phi_4741_: f32;
    var phi_4742_: bool;
    var phi_5038_: u32;
    var phi_5056_: bool;
    var phi_5059_: bool;
    var phi_5072_: f32;
    var phi_5073_: f32;
    var phi_5078_: f32;
    var phi_5079_: f32;
    var phi_5080_: bool;
    var phi_5088_: f32;
    var phi_4757_: f32;
    var phi_4758_: f32;
    var phi_4770_: f32;
    var phi_4775_: type_21;
    var local_11: type_38;

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
                phi_416_ = _e172;
            } else {
                phi_416_ = 4294967295u;
            }
            let _e174 = phi_416_;
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
                phi_460_ = -126i;
            } else {
                phi_460_ = select(_e217, 127i, (_e217 > 127i));
            }
            let _e222 = phi_460_;
            let _e227 = bitcast<f32>((bitcast<u32>((_e222 + 127i)) << bitcast<u32>(23i)));
            let _e233 = bitcast<f32>((bitcast<u32>(((_e217 - _e222) + 127i)) << bitcast<u32>(23i)));
            if (_e193 == 0u) {
                phi_600_ = type_35(array<f32, 3>(_e210, _e211, _e212), _e193, _e214, _e215);
            } else {
                let _e235 = bitcast<u32>(_e210);
                let _e237 = ((_e235 & 2139095040u) != 0u);
                let _e252 = bitcast<u32>(_e211);
                let _e254 = ((_e252 & 2139095040u) != 0u);
                let _e269 = bitcast<u32>(_e212);
                let _e271 = ((_e269 & 2139095040u) != 0u);
                let _e287 = bitcast<u32>(_e214);
                let _e289 = ((_e287 & 2139095040u) != 0u);
                phi_600_ = type_35(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e235 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e235 & 2147483648u))), _e210, _e237) * _e227) * select(0.00000011920929f, 1f, _e237)) * _e233), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e252 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e252 & 2147483648u))), _e211, _e254) * _e227) * select(0.00000011920929f, 1f, _e254)) * _e233), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e269 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e269 & 2147483648u))), _e212, _e271) * _e227) * select(0.00000011920929f, 1f, _e271)) * _e233)), _e193, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e287 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e287 & 2147483648u))), _e214, _e289) * _e227) * select(0.00000011920929f, 1f, _e289)) * _e233), _e215);
            }
            let _e306 = phi_600_;
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
                            phi_706_ = (bitcast<i32>((_e393 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_706_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e393)), 32u, (_e393 == 0u))));
                        }
                        let _e407 = phi_706_;
                        phi_707_ = _e407;
                    } else {
                        phi_707_ = 0i;
                    }
                    let _e409 = phi_707_;
                    let _e410 = (_e319 == _e363);
                    if _e410 {
                        phi_717_ = true;
                    } else {
                        phi_717_ = (_e327 == _e363);
                    }
                    let _e413 = phi_717_;
                    let _e414 = select(1u, 0u, _e410);
                    if _e413 {
                        let _e415 = (_e414 + 1u);
                        phi_727_ = _e415;
                        phi_728_ = _e415;
                        phi_730_ = select(true, false, (_e415 == 2u));
                    } else {
                        phi_727_ = u32();
                        phi_728_ = 0u;
                        phi_730_ = true;
                    }
                    let _e419 = phi_727_;
                    let _e421 = phi_728_;
                    let _e423 = phi_730_;
                    if _e423 {
                        phi_735_ = (_e421 + 1u);
                    } else {
                        phi_735_ = 0u;
                    }
                    let _e427 = phi_735_;
                    let _e428 = select(_e419, _e421, _e423);
                    let _e429 = select(_e414, select(2u, _e414, _e413), _e423);
                    let _e430 = -(_e409);
                    if (_e430 < -126i) {
                        phi_767_ = -126i;
                    } else {
                        phi_767_ = select(_e430, 127i, (_e430 > 127i));
                    }
                    let _e435 = phi_767_;
                    let _e440 = bitcast<f32>((bitcast<u32>((_e435 + 127i)) << bitcast<u32>(23i)));
                    let _e446 = bitcast<f32>((bitcast<u32>(((_e430 - _e435) + 127i)) << bitcast<u32>(23i)));
                    let _e451 = global_6.member[_e153].member.member;
                    let _e452 = (_e428 == 0u);
                    if _e452 {
                        phi_785_ = _e451[0];
                    } else {
                        phi_785_ = _e451[1];
                    }
                    let _e456 = phi_785_;
                    let _e457 = (_e428 == 2u);
                    if _e457 {
                        phi_791_ = _e451[2];
                    } else {
                        phi_791_ = _e456;
                    }
                    let _e460 = phi_791_;
                    let _e461 = bitcast<u32>(_e460);
                    let _e463 = ((_e461 & 2139095040u) != 0u);
                    let _e475 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e461 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e461 & 2147483648u))), _e460, _e463) * select(0.00000011920929f, 1f, _e463));
                    let _e476 = global_6.member[_e153].member.member_2;
                    if _e452 {
                        phi_831_ = _e476[0];
                    } else {
                        phi_831_ = _e476[1];
                    }
                    let _e480 = phi_831_;
                    if _e457 {
                        phi_837_ = _e476[2];
                    } else {
                        phi_837_ = _e480;
                    }
                    let _e483 = phi_837_;
                    let _e484 = bitcast<u32>(_e483);
                    let _e486 = ((_e484 & 2139095040u) != 0u);
                    let _e500 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e484 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e484 & 2147483648u))), _e483, _e486) * _e440) * select(0.00000011920929f, 1f, _e486)) * _e446);
                    let _e504 = (bitcast<f32>((bitcast<u32>(_e500) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e504 {
                        let _e508 = (bitcast<f32>((bitcast<u32>(_e475) & 2147483647u)) * 0.00000011920929f);
                        phi_889_ = select(0.00000000000011368684f, _e508, (_e508 > 0.00000000000011368684f));
                    } else {
                        phi_889_ = 0f;
                    }
                    let _e512 = phi_889_;
                    let _e513 = (_e475 + _e512);
                    let _e514 = (_e475 - _e512);
                    let _e515 = select(_e500, 0f, _e504);
                    if _e504 {
                        phi_900_ = 38685626000000000000000000f;
                    } else {
                        phi_900_ = (1f / _e500);
                    }
                    let _e518 = phi_900_;
                    let _e519 = (_e427 == 0u);
                    if _e519 {
                        phi_909_ = _e451[0];
                    } else {
                        phi_909_ = _e451[1];
                    }
                    let _e523 = phi_909_;
                    let _e524 = (_e427 == 2u);
                    if _e524 {
                        phi_915_ = _e451[2];
                    } else {
                        phi_915_ = _e523;
                    }
                    let _e527 = phi_915_;
                    let _e528 = bitcast<u32>(_e527);
                    let _e530 = ((_e528 & 2139095040u) != 0u);
                    let _e542 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e528 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e528 & 2147483648u))), _e527, _e530) * select(0.00000011920929f, 1f, _e530));
                    if _e519 {
                        phi_955_ = _e476[0];
                    } else {
                        phi_955_ = _e476[1];
                    }
                    let _e546 = phi_955_;
                    if _e524 {
                        phi_961_ = _e476[2];
                    } else {
                        phi_961_ = _e546;
                    }
                    let _e549 = phi_961_;
                    let _e550 = bitcast<u32>(_e549);
                    let _e552 = ((_e550 & 2139095040u) != 0u);
                    let _e566 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e550 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e550 & 2147483648u))), _e549, _e552) * _e440) * select(0.00000011920929f, 1f, _e552)) * _e446);
                    let _e570 = (bitcast<f32>((bitcast<u32>(_e566) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e570 {
                        let _e574 = (bitcast<f32>((bitcast<u32>(_e542) & 2147483647u)) * 0.00000011920929f);
                        phi_1013_ = select(0.00000000000011368684f, _e574, (_e574 > 0.00000000000011368684f));
                    } else {
                        phi_1013_ = 0f;
                    }
                    let _e578 = phi_1013_;
                    let _e579 = (_e542 + _e578);
                    let _e580 = (_e542 - _e578);
                    let _e581 = select(_e566, 0f, _e570);
                    if _e570 {
                        phi_1024_ = 38685626000000000000000000f;
                    } else {
                        phi_1024_ = (1f / _e566);
                    }
                    let _e584 = phi_1024_;
                    let _e585 = (_e429 == 0u);
                    if _e585 {
                        phi_1033_ = _e451[0];
                    } else {
                        phi_1033_ = _e451[1];
                    }
                    let _e589 = phi_1033_;
                    let _e590 = (_e429 == 2u);
                    if _e590 {
                        phi_1039_ = _e451[2];
                    } else {
                        phi_1039_ = _e589;
                    }
                    let _e593 = phi_1039_;
                    let _e594 = bitcast<u32>(_e593);
                    let _e596 = ((_e594 & 2139095040u) != 0u);
                    let _e608 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e594 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e594 & 2147483648u))), _e593, _e596) * select(0.00000011920929f, 1f, _e596));
                    if _e585 {
                        phi_1079_ = _e476[0];
                    } else {
                        phi_1079_ = _e476[1];
                    }
                    let _e612 = phi_1079_;
                    if _e590 {
                        phi_1085_ = _e476[2];
                    } else {
                        phi_1085_ = _e612;
                    }
                    let _e615 = phi_1085_;
                    let _e616 = bitcast<u32>(_e615);
                    let _e618 = ((_e616 & 2139095040u) != 0u);
                    let _e632 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e616 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e616 & 2147483648u))), _e615, _e618) * _e440) * select(0.00000011920929f, 1f, _e618)) * _e446);
                    let _e636 = (bitcast<f32>((bitcast<u32>(_e632) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e636 {
                        let _e640 = (bitcast<f32>((bitcast<u32>(_e608) & 2147483647u)) * 0.00000011920929f);
                        phi_1137_ = select(0.00000000000011368684f, _e640, (_e640 > 0.00000000000011368684f));
                    } else {
                        phi_1137_ = 0f;
                    }
                    let _e644 = phi_1137_;
                    let _e645 = (_e608 + _e644);
                    let _e646 = (_e608 - _e644);
                    let _e647 = select(_e632, 0f, _e636);
                    if _e636 {
                        phi_1148_ = 38685626000000000000000000f;
                    } else {
                        phi_1148_ = (1f / _e632);
                    }
                    let _e650 = phi_1148_;
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
                            phi_1203_ = 255i;
                        } else {
                            phi_1203_ = (((_e676 + select(0i, 1i, (_e676 == 0i))) - _e683) + _e409);
                        }
                        let _e691 = phi_1203_;
                        let _e701 = (_e691 <= 0i);
                        if _e701 {
                            phi_1226_ = u32();
                        } else {
                            if _e680 {
                                phi_1225_ = u32();
                            } else {
                                phi_1225_ = select(((bitcast<u32>(_e691) << bitcast<u32>(23i)) | ((_e673 << bitcast<u32>(((_e683 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e691 >= 255i));
                            }
                            let _e705 = phi_1225_;
                            phi_1226_ = _e705;
                        }
                        let _e707 = phi_1226_;
                        let _e719 = ((_e386 & 8388607u) | (select(0u, 1u, ((_e386 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e722 = bitcast<i32>((_e386 >> bitcast<u32>(23i)));
                        let _e726 = (_e719 == 0u);
                        let _e729 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e719)), 32u, _e726)) - 8i);
                        if (_e722 == 255i) {
                            phi_1263_ = 255i;
                        } else {
                            phi_1263_ = (((_e722 + select(0i, 1i, (_e722 == 0i))) - _e729) + _e409);
                        }
                        let _e737 = phi_1263_;
                        let _e747 = (_e737 <= 0i);
                        if _e747 {
                            phi_1286_ = u32();
                        } else {
                            if _e726 {
                                phi_1285_ = u32();
                            } else {
                                phi_1285_ = select(((bitcast<u32>(_e737) << bitcast<u32>(23i)) | ((_e719 << bitcast<u32>(((_e729 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e737 >= 255i));
                            }
                            let _e751 = phi_1285_;
                            phi_1286_ = _e751;
                        }
                        let _e753 = phi_1286_;
                        phi_1294_ = bitcast<f32>(((_e385 & 2147483648u) | select(_e753, 0u, select(_e726, true, _e747))));
                        phi_1295_ = bitcast<f32>(((_e375 & 2147483648u) | select(_e707, 0u, select(_e680, true, _e701))));
                    } else {
                        phi_1294_ = 0f;
                        phi_1295_ = 1f;
                    }
                    let _e759 = phi_1294_;
                    let _e761 = phi_1295_;
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
                    phi_5136_ = false;
                    phi_1384_ = type_38(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e759);
                    phi_1387_ = type_57(type_33(vec4<f32>((f32(_e768) * _e165), (f32(_e774) * _e165), (f32(_e780) * _e165), 0f), vec4<f32>((f32(_e785) * _e165), (f32(_e789) * _e165), (f32(_e793) * _e165), 0f)), select(0u, 2147483648u, (_e106 == 0u)));
                    phi_1389_ = ((3u * _e106) + 1u);
                    phi_1391_ = (_e761 <= _e759);
                    phi_1393_ = 0u;
                    loop {
                        let _e803 = phi_5136_;
                        let _e805 = phi_1384_;
                        let _e807 = phi_1387_;
                        let _e809 = phi_1389_;
                        let _e811 = phi_1391_;
                        let _e813 = phi_1393_;
                        local_10 = _e805;
                        if _e811 {
                            phi_1404_ = true;
                        } else {
                            phi_1404_ = (_e813 > 0u);
                        }
                        let _e816 = phi_1404_;
                        if _e816 {
                            let _e817 = (_e809 > 0u);
                            if _e817 {
                                if _e811 {
                                    phi_1490_ = _e807;
                                    phi_1491_ = _e811;
                                    phi_1492_ = _e813;
                                } else {
                                    let _e818 = (_e813 - 1u);
                                    let _e819 = (_e818 % 128u);
                                    let _e820 = (_e819 < 128u);
                                    if _e820 {
                                    } else {
                                        phi_5369_ = true;
                                        break;
                                    }
                                    let _e822 = local_7[_e819];
                                    if _e820 {
                                    } else {
                                        phi_5369_ = true;
                                        break;
                                    }
                                    let _e824 = local_6[_e819];
                                    if _e820 {
                                    } else {
                                        phi_5369_ = true;
                                        break;
                                    }
                                    let _e826 = local_5[_e819];
                                    if _e820 {
                                    } else {
                                        phi_5369_ = true;
                                        break;
                                    }
                                    let _e828 = local_4[_e819];
                                    if _e820 {
                                    } else {
                                        phi_5369_ = true;
                                        break;
                                    }
                                    let _e830 = local_3[_e819];
                                    if _e820 {
                                    } else {
                                        phi_5369_ = true;
                                        break;
                                    }
                                    let _e832 = local_2[_e819];
                                    if _e820 {
                                    } else {
                                        phi_5369_ = true;
                                        break;
                                    }
                                    let _e837 = local_8[_e819];
                                    if _e820 {
                                    } else {
                                        phi_5369_ = true;
                                        break;
                                    }
                                    let _e840 = local_9[_e819];
                                    phi_1490_ = type_57(type_33(vec4<f32>(_e822, _e824, _e826, 0f), vec4<f32>(_e828, _e830, _e832, 0f)), _e837);
                                    phi_1491_ = (_e840 <= _e805.member_1);
                                    phi_1492_ = _e818;
                                }
                                let _e844 = phi_1490_;
                                let _e846 = phi_1491_;
                                let _e848 = phi_1492_;
                                if _e846 {
                                    let _e853 = (_e844.member_1 & 268435455u);
                                    if ((_e844.member_1 & 2147483648u) != 0u) {
                                        phi_1511_ = _e805;
                                        phi_1514_ = type_8(0u, ((_e844.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1337 = phi_1511_;
                                            let _e1339 = phi_1514_;
                                            local_11 = _e1337;
                                            if (_e1339.member < _e1339.member_1) {
                                                phi_1515_ = type_8((_e1339.member + 1u), _e1339.member_1);
                                                phi_1537_ = type_8(1u, _e1339.member);
                                            } else {
                                                phi_1515_ = _e1339;
                                                phi_1537_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1352 = phi_1515_;
                                            let _e1354 = phi_1537_;
                                            let _e1358 = (bitcast<i32>(_e1354.member) != 0i);
                                            if _e1358 {
                                                let _e1363 = (_e844.member.member_1.x - _e844.member.member.x);
                                                let _e1366 = (_e844.member.member_1.y - _e844.member.member.y);
                                                let _e1369 = (_e844.member.member_1.z - _e844.member.member.z);
                                                let _e1371 = select(_e1366, _e1363, (_e1363 > _e1366));
                                                let _e1373 = select(_e1369, _e1371, (_e1371 > _e1369));
                                                let _e1375 = (_e1373 < (1024f * _e165));
                                                if _e1375 {
                                                    phi_1578_ = 0u;
                                                } else {
                                                    phi_1578_ = select(2u, 1u, (_e1373 < (2097152f * _e165)));
                                                }
                                                let _e1380 = phi_1578_;
                                                switch bitcast<i32>(_e1380) {
                                                    case 0: {
                                                        phi_1584_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1584_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1584_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1584_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1383 = phi_1584_;
                                                switch bitcast<i32>(_e1380) {
                                                    case 0: {
                                                        phi_1594_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1594_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1594_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1594_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1390 = phi_1594_;
                                                let _e1392 = ((_e853 + (_e1354.member_1 * ((3u * _e1383) + 1u))) + (3u * _e1390));
                                                let _e1393 = (_e1392 < _e109);
                                                if _e1393 {
                                                    if _e1393 {
                                                    } else {
                                                        phi_5130_ = true;
                                                        break;
                                                    }
                                                    let _e1395 = global_10.member[_e1392];
                                                    phi_1610_ = _e1395;
                                                } else {
                                                    phi_1610_ = 4294967295u;
                                                }
                                                let _e1397 = phi_1610_;
                                                if _e1375 {
                                                    phi_1643_ = 0u;
                                                } else {
                                                    phi_1643_ = select(2u, 1u, (_e1373 < (2097152f * _e165)));
                                                }
                                                let _e1402 = phi_1643_;
                                                switch bitcast<i32>(_e1402) {
                                                    case 0: {
                                                        phi_1649_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1649_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1649_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1649_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1405 = phi_1649_;
                                                let _e1409 = (_e853 + (_e1354.member_1 * ((3u * _e1405) + 1u)));
                                                switch bitcast<i32>(_e1402) {
                                                    case 0: {
                                                        let _e1684 = (_e1409 < _e109);
                                                        if _e1684 {
                                                            if _e1684 {
                                                            } else {
                                                                phi_5130_ = true;
                                                                break;
                                                            }
                                                            let _e1686 = global_10.member[_e1409];
                                                            phi_1673_ = _e1686;
                                                        } else {
                                                            phi_1673_ = 0u;
                                                        }
                                                        let _e1688 = phi_1673_;
                                                        let _e1690 = ((10u * _e428) & 31u);
                                                        let _e1700 = ((10u * _e427) & 31u);
                                                        let _e1710 = ((10u * _e429) & 31u);
                                                        let _e1720 = (_e1409 + 1u);
                                                        let _e1721 = (_e1720 < _e109);
                                                        if _e1721 {
                                                            if _e1721 {
                                                            } else {
                                                                phi_5130_ = true;
                                                                break;
                                                            }
                                                            let _e1723 = global_10.member[_e1720];
                                                            phi_1719_ = _e1723;
                                                        } else {
                                                            phi_1719_ = 0u;
                                                        }
                                                        let _e1725 = phi_1719_;
                                                        let _e1751 = (_e1409 + 2u);
                                                        let _e1752 = (_e1751 < _e109);
                                                        if _e1752 {
                                                            if _e1752 {
                                                            } else {
                                                                phi_5130_ = true;
                                                                break;
                                                            }
                                                            let _e1754 = global_10.member[_e1751];
                                                            phi_1765_ = _e1754;
                                                        } else {
                                                            phi_1765_ = 0u;
                                                        }
                                                        let _e1756 = phi_1765_;
                                                        phi_2248_ = array<array<f32, 3>, 3>(array<f32, 3>((_e844.member.member.x + ((bitcast<f32>((1258291200u | ((_e1688 >> bitcast<u32>(_e1690)) & 1023u))) - 8388608f) * _e165)), (_e844.member.member.y + ((bitcast<f32>((1258291200u | ((_e1688 >> bitcast<u32>(_e1700)) & 1023u))) - 8388608f) * _e165)), (_e844.member.member.z + ((bitcast<f32>((1258291200u | ((_e1688 >> bitcast<u32>(_e1710)) & 1023u))) - 8388608f) * _e165))), array<f32, 3>((_e844.member.member.x + ((bitcast<f32>((1258291200u | ((_e1725 >> bitcast<u32>(_e1690)) & 1023u))) - 8388608f) * _e165)), (_e844.member.member.y + ((bitcast<f32>((1258291200u | ((_e1725 >> bitcast<u32>(_e1700)) & 1023u))) - 8388608f) * _e165)), (_e844.member.member.z + ((bitcast<f32>((1258291200u | ((_e1725 >> bitcast<u32>(_e1710)) & 1023u))) - 8388608f) * _e165))), array<f32, 3>((_e844.member.member.x + ((bitcast<f32>((1258291200u | ((_e1756 >> bitcast<u32>(_e1690)) & 1023u))) - 8388608f) * _e165)), (_e844.member.member.y + ((bitcast<f32>((1258291200u | ((_e1756 >> bitcast<u32>(_e1700)) & 1023u))) - 8388608f) * _e165)), (_e844.member.member.z + ((bitcast<f32>((1258291200u | ((_e1756 >> bitcast<u32>(_e1710)) & 1023u))) - 8388608f) * _e165))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1498 = (_e1409 < _e109);
                                                        if _e1498 {
                                                            if _e1498 {
                                                            } else {
                                                                phi_5130_ = true;
                                                                break;
                                                            }
                                                            let _e1500 = global_10.member[_e1409];
                                                            phi_1811_ = _e1500;
                                                        } else {
                                                            phi_1811_ = 0u;
                                                        }
                                                        let _e1502 = phi_1811_;
                                                        let _e1503 = (_e1409 + 1u);
                                                        let _e1504 = (_e1503 < _e109);
                                                        if _e1504 {
                                                            if _e1504 {
                                                            } else {
                                                                phi_5130_ = true;
                                                                break;
                                                            }
                                                            let _e1506 = global_10.member[_e1503];
                                                            phi_1826_ = _e1506;
                                                        } else {
                                                            phi_1826_ = 0u;
                                                        }
                                                        let _e1508 = phi_1826_;
                                                        let _e1509 = (_e428 == 1u);
                                                        if _e1509 {
                                                            phi_1836_ = ((_e1502 >> bitcast<u32>(21i)) | (_e1508 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1836_ = (_e1508 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1518 = phi_1836_;
                                                        let _e1526 = (_e427 == 1u);
                                                        if _e1526 {
                                                            phi_1857_ = ((_e1502 >> bitcast<u32>(21i)) | (_e1508 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1857_ = (_e1508 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1535 = phi_1857_;
                                                        let _e1543 = (_e429 == 1u);
                                                        if _e1543 {
                                                            phi_1878_ = ((_e1502 >> bitcast<u32>(21i)) | (_e1508 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1878_ = (_e1508 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1552 = phi_1878_;
                                                        let _e1561 = (_e1409 + 2u);
                                                        let _e1562 = (_e1561 < _e109);
                                                        if _e1562 {
                                                            if _e1562 {
                                                            } else {
                                                                phi_5130_ = true;
                                                                break;
                                                            }
                                                            let _e1564 = global_10.member[_e1561];
                                                            phi_1905_ = _e1564;
                                                        } else {
                                                            phi_1905_ = 0u;
                                                        }
                                                        let _e1566 = phi_1905_;
                                                        let _e1567 = (_e1409 + 3u);
                                                        let _e1568 = (_e1567 < _e109);
                                                        if _e1568 {
                                                            if _e1568 {
                                                            } else {
                                                                phi_5130_ = true;
                                                                break;
                                                            }
                                                            let _e1570 = global_10.member[_e1567];
                                                            phi_1920_ = _e1570;
                                                        } else {
                                                            phi_1920_ = 0u;
                                                        }
                                                        let _e1572 = phi_1920_;
                                                        if _e1509 {
                                                            phi_1930_ = ((_e1566 >> bitcast<u32>(21i)) | (_e1572 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1930_ = (_e1572 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1581 = phi_1930_;
                                                        if _e1526 {
                                                            phi_1951_ = ((_e1566 >> bitcast<u32>(21i)) | (_e1572 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1951_ = (_e1572 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1597 = phi_1951_;
                                                        if _e1543 {
                                                            phi_1972_ = ((_e1566 >> bitcast<u32>(21i)) | (_e1572 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1972_ = (_e1572 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1613 = phi_1972_;
                                                        let _e1622 = (_e1409 + 4u);
                                                        let _e1623 = (_e1622 < _e109);
                                                        if _e1623 {
                                                            if _e1623 {
                                                            } else {
                                                                phi_5130_ = true;
                                                                break;
                                                            }
                                                            let _e1625 = global_10.member[_e1622];
                                                            phi_1999_ = _e1625;
                                                        } else {
                                                            phi_1999_ = 0u;
                                                        }
                                                        let _e1627 = phi_1999_;
                                                        let _e1628 = (_e1409 + 5u);
                                                        let _e1629 = (_e1628 < _e109);
                                                        if _e1629 {
                                                            if _e1629 {
                                                            } else {
                                                                phi_5130_ = true;
                                                                break;
                                                            }
                                                            let _e1631 = global_10.member[_e1628];
                                                            phi_2014_ = _e1631;
                                                        } else {
                                                            phi_2014_ = 0u;
                                                        }
                                                        let _e1633 = phi_2014_;
                                                        if _e1509 {
                                                            phi_2024_ = ((_e1627 >> bitcast<u32>(21i)) | (_e1633 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2024_ = (_e1633 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1642 = phi_2024_;
                                                        if _e1526 {
                                                            phi_2045_ = ((_e1627 >> bitcast<u32>(21i)) | (_e1633 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2045_ = (_e1633 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1658 = phi_2045_;
                                                        if _e1543 {
                                                            phi_2066_ = ((_e1627 >> bitcast<u32>(21i)) | (_e1633 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2066_ = (_e1633 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1674 = phi_2066_;
                                                        phi_2248_ = array<array<f32, 3>, 3>(array<f32, 3>((_e844.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1518, _e1502, _e452) & 2097151u))) - 8388608f) * _e165)), (_e844.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1535, _e1502, _e519) & 2097151u))) - 8388608f) * _e165)), (_e844.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1552, _e1502, _e585) & 2097151u))) - 8388608f) * _e165))), array<f32, 3>((_e844.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1581, _e1566, _e452) & 2097151u))) - 8388608f) * _e165)), (_e844.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1597, _e1566, _e519) & 2097151u))) - 8388608f) * _e165)), (_e844.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1613, _e1566, _e585) & 2097151u))) - 8388608f) * _e165))), array<f32, 3>((_e844.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1642, _e1627, _e452) & 2097151u))) - 8388608f) * _e165)), (_e844.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1658, _e1627, _e519) & 2097151u))) - 8388608f) * _e165)), (_e844.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1674, _e1627, _e585) & 2097151u))) - 8388608f) * _e165))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1411 = (_e1409 + _e428);
                                                        let _e1412 = (_e1411 < _e109);
                                                        if _e1412 {
                                                            if _e1412 {
                                                            } else {
                                                                phi_5130_ = true;
                                                                break;
                                                            }
                                                            let _e1414 = global_10.member[_e1411];
                                                            phi_2094_ = _e1414;
                                                        } else {
                                                            phi_2094_ = 0u;
                                                        }
                                                        let _e1416 = phi_2094_;
                                                        let _e1420 = (_e1409 + _e427);
                                                        let _e1421 = (_e1420 < _e109);
                                                        if _e1421 {
                                                            if _e1421 {
                                                            } else {
                                                                phi_5130_ = true;
                                                                break;
                                                            }
                                                            let _e1423 = global_10.member[_e1420];
                                                            phi_2112_ = _e1423;
                                                        } else {
                                                            phi_2112_ = 0u;
                                                        }
                                                        let _e1425 = phi_2112_;
                                                        let _e1429 = (_e1409 + _e429);
                                                        let _e1430 = (_e1429 < _e109);
                                                        if _e1430 {
                                                            if _e1430 {
                                                            } else {
                                                                phi_5130_ = true;
                                                                break;
                                                            }
                                                            let _e1432 = global_10.member[_e1429];
                                                            phi_2130_ = _e1432;
                                                        } else {
                                                            phi_2130_ = 0u;
                                                        }
                                                        let _e1434 = phi_2130_;
                                                        let _e1439 = (_e1409 + 3u);
                                                        let _e1440 = (_e1439 + _e428);
                                                        let _e1441 = (_e1440 < _e109);
                                                        if _e1441 {
                                                            if _e1441 {
                                                            } else {
                                                                phi_5130_ = true;
                                                                break;
                                                            }
                                                            let _e1443 = global_10.member[_e1440];
                                                            phi_2150_ = _e1443;
                                                        } else {
                                                            phi_2150_ = 0u;
                                                        }
                                                        let _e1445 = phi_2150_;
                                                        let _e1449 = (_e1439 + _e427);
                                                        let _e1450 = (_e1449 < _e109);
                                                        if _e1450 {
                                                            if _e1450 {
                                                            } else {
                                                                phi_5130_ = true;
                                                                break;
                                                            }
                                                            let _e1452 = global_10.member[_e1449];
                                                            phi_2168_ = _e1452;
                                                        } else {
                                                            phi_2168_ = 0u;
                                                        }
                                                        let _e1454 = phi_2168_;
                                                        let _e1458 = (_e1439 + _e429);
                                                        let _e1459 = (_e1458 < _e109);
                                                        if _e1459 {
                                                            if _e1459 {
                                                            } else {
                                                                phi_5130_ = true;
                                                                break;
                                                            }
                                                            let _e1461 = global_10.member[_e1458];
                                                            phi_2186_ = _e1461;
                                                        } else {
                                                            phi_2186_ = 0u;
                                                        }
                                                        let _e1463 = phi_2186_;
                                                        let _e1468 = (_e1409 + 6u);
                                                        let _e1469 = (_e1468 + _e428);
                                                        let _e1470 = (_e1469 < _e109);
                                                        if _e1470 {
                                                            if _e1470 {
                                                            } else {
                                                                phi_5130_ = true;
                                                                break;
                                                            }
                                                            let _e1472 = global_10.member[_e1469];
                                                            phi_2206_ = _e1472;
                                                        } else {
                                                            phi_2206_ = 0u;
                                                        }
                                                        let _e1474 = phi_2206_;
                                                        let _e1478 = (_e1468 + _e427);
                                                        let _e1479 = (_e1478 < _e109);
                                                        if _e1479 {
                                                            if _e1479 {
                                                            } else {
                                                                phi_5130_ = true;
                                                                break;
                                                            }
                                                            let _e1481 = global_10.member[_e1478];
                                                            phi_2224_ = _e1481;
                                                        } else {
                                                            phi_2224_ = 0u;
                                                        }
                                                        let _e1483 = phi_2224_;
                                                        let _e1487 = (_e1468 + _e429);
                                                        let _e1488 = (_e1487 < _e109);
                                                        if _e1488 {
                                                            if _e1488 {
                                                            } else {
                                                                phi_5130_ = true;
                                                                break;
                                                            }
                                                            let _e1490 = global_10.member[_e1487];
                                                            phi_2242_ = _e1490;
                                                        } else {
                                                            phi_2242_ = 0u;
                                                        }
                                                        let _e1492 = phi_2242_;
                                                        phi_2248_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1416)) * _e165), (f32(bitcast<i32>(_e1425)) * _e165), (f32(bitcast<i32>(_e1434)) * _e165)), array<f32, 3>((f32(bitcast<i32>(_e1445)) * _e165), (f32(bitcast<i32>(_e1454)) * _e165), (f32(bitcast<i32>(_e1463)) * _e165)), array<f32, 3>((f32(bitcast<i32>(_e1474)) * _e165), (f32(bitcast<i32>(_e1483)) * _e165), (f32(bitcast<i32>(_e1492)) * _e165)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2248_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1784 = phi_2248_;
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
                                                        phi_3073_ = type_21();
                                                        phi_3074_ = true;
                                                        phi_3075_ = false;
                                                    } else {
                                                        let _e1859 = select(_e1808, _e1795, (_e1795 < _e1808));
                                                        if (select(_e1821, _e1859, (_e1859 < _e1821)) > 0f) {
                                                            phi_2365_ = true;
                                                        } else {
                                                            let _e1864 = select(_e1808, _e1795, (_e1795 > _e1808));
                                                            phi_2365_ = (select(_e1821, _e1864, (_e1864 > _e1821)) < 0f);
                                                        }
                                                        let _e1869 = phi_2365_;
                                                        if _e1869 {
                                                            phi_3070_ = type_21();
                                                            phi_3071_ = true;
                                                            phi_3072_ = false;
                                                        } else {
                                                            let _e1871 = select(_e1811, _e1798, (_e1798 < _e1811));
                                                            if (select(_e1824, _e1871, (_e1871 < _e1824)) > 0f) {
                                                                phi_2394_ = true;
                                                            } else {
                                                                let _e1876 = select(_e1811, _e1798, (_e1798 > _e1811));
                                                                phi_2394_ = (select(_e1824, _e1876, (_e1876 > _e1824)) < 0f);
                                                            }
                                                            let _e1881 = phi_2394_;
                                                            if _e1881 {
                                                                phi_3068_ = type_21();
                                                                phi_3069_ = false;
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
                                                                    phi_3063_ = type_21();
                                                                    phi_3064_ = true;
                                                                } else {
                                                                    let _e1946 = (_e1944 > _e1337.member_1);
                                                                    if _e1946 {
                                                                        phi_3062_ = type_21();
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
                                                                            phi_2795_ = _e1811;
                                                                            phi_2796_ = _e1808;
                                                                            phi_2797_ = _e1798;
                                                                            phi_2798_ = _e1795;
                                                                            phi_2799_ = _e1947;
                                                                            phi_2800_ = _e1961;
                                                                            phi_2801_ = _e1957;
                                                                            phi_2802_ = _e1953;
                                                                        } else {
                                                                            let _e2006 = (_e1987 == _e2004);
                                                                            let _e2011 = vec3(_e2006);
                                                                            phi_2795_ = select(_e1798, _e1824, _e2006);
                                                                            phi_2796_ = select(_e1795, _e1821, _e2006);
                                                                            phi_2797_ = select(_e1824, _e1811, _e2006);
                                                                            phi_2798_ = select(_e1821, _e1808, _e2006);
                                                                            phi_2799_ = select(_e1949, _e1948, _e2011);
                                                                            phi_2800_ = select(_e1957, _e1953, _e2011);
                                                                            phi_2801_ = select(_e1953, _e1961, _e2011);
                                                                            phi_2802_ = select(_e1961, _e1957, _e2011);
                                                                        }
                                                                        let _e2017 = phi_2795_;
                                                                        let _e2019 = phi_2796_;
                                                                        let _e2021 = phi_2797_;
                                                                        let _e2023 = phi_2798_;
                                                                        let _e2025 = phi_2799_;
                                                                        let _e2027 = phi_2800_;
                                                                        let _e2029 = phi_2801_;
                                                                        let _e2031 = phi_2802_;
                                                                        let _e2038 = ((_e2029.y * _e2027.z) - (_e2027.y * _e2029.z));
                                                                        let _e2043 = ((_e2029.z * _e2027.x) - (_e2027.z * _e2029.x));
                                                                        let _e2046 = ((_e2029.x * _e2027.y) - (_e2027.x * _e2029.y));
                                                                        if (_e1846 >= _e1850) {
                                                                            phi_2833_ = select(true, false, (_e1846 >= _e1854));
                                                                        } else {
                                                                            phi_2833_ = true;
                                                                        }
                                                                        let _e2051 = phi_2833_;
                                                                        if _e2051 {
                                                                            phi_2842_ = select(_e1949, _e1948, vec3((_e1850 >= _e1854)));
                                                                        } else {
                                                                            phi_2842_ = _e1947;
                                                                        }
                                                                        let _e2056 = phi_2842_;
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
                                                                                phi_3007_ = (_e2067 / _e2072);
                                                                            } else {
                                                                                phi_3007_ = f32();
                                                                            }
                                                                            let _e2177 = phi_3007_;
                                                                            phi_3009_ = _e2177;
                                                                            phi_3010_ = select(true, false, _e2174);
                                                                        } else {
                                                                            phi_3009_ = f32();
                                                                            phi_3010_ = true;
                                                                        }
                                                                        let _e2180 = phi_3009_;
                                                                        let _e2182 = phi_3010_;
                                                                        if _e2182 {
                                                                            let _e2190 = (((_e2038 * (_e2099 - (_e515 * _e2102))) + (_e2043 * (_e2100 - (_e581 * _e2102)))) / _e2072);
                                                                            if (bitcast<f32>((bitcast<u32>(_e2190) & 2147483647u)) <= _e2004) {
                                                                                phi_3030_ = (_e2102 + _e2190);
                                                                            } else {
                                                                                phi_3030_ = _e2102;
                                                                            }
                                                                            let _e2197 = phi_3030_;
                                                                            phi_3031_ = _e2197;
                                                                        } else {
                                                                            phi_3031_ = _e2180;
                                                                        }
                                                                        let _e2199 = phi_3031_;
                                                                        let _e2201 = select(_e1937, _e2199, (_e2199 < _e1937));
                                                                        let _e2203 = select(_e1929, _e2201, (_e2201 > _e1929));
                                                                        if (_e2203 >= _e761) {
                                                                            let _e2205 = (_e2203 <= _e1337.member_1);
                                                                            if _e2205 {
                                                                                let _e2206 = (1f / _e1856);
                                                                                phi_3054_ = type_21(_e2203, (_e1850 * _e2206), (_e1854 * _e2206), _e1397);
                                                                            } else {
                                                                                phi_3054_ = type_21();
                                                                            }
                                                                            let _e2211 = phi_3054_;
                                                                            phi_3056_ = _e2211;
                                                                            phi_3057_ = select(true, false, _e2205);
                                                                        } else {
                                                                            phi_3056_ = type_21();
                                                                            phi_3057_ = true;
                                                                        }
                                                                        let _e2214 = phi_3056_;
                                                                        let _e2216 = phi_3057_;
                                                                        if _e2216 {
                                                                            phi_3061_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_3061_ = _e2214;
                                                                        }
                                                                        let _e2218 = phi_3061_;
                                                                        phi_3062_ = _e2218;
                                                                    }
                                                                    let _e2220 = phi_3062_;
                                                                    phi_3063_ = _e2220;
                                                                    phi_3064_ = _e1946;
                                                                }
                                                                let _e2222 = phi_3063_;
                                                                let _e2224 = phi_3064_;
                                                                phi_3068_ = _e2222;
                                                                phi_3069_ = _e2224;
                                                            }
                                                            let _e2226 = phi_3068_;
                                                            let _e2228 = phi_3069_;
                                                            phi_3070_ = _e2226;
                                                            phi_3071_ = _e1881;
                                                            phi_3072_ = _e2228;
                                                        }
                                                        let _e2230 = phi_3070_;
                                                        let _e2232 = phi_3071_;
                                                        let _e2234 = phi_3072_;
                                                        phi_3073_ = _e2230;
                                                        phi_3074_ = _e2232;
                                                        phi_3075_ = _e2234;
                                                    }
                                                    let _e2236 = phi_3073_;
                                                    let _e2238 = phi_3074_;
                                                    let _e2240 = phi_3075_;
                                                    phi_3083_ = _e2236;
                                                    phi_3084_ = select(_e2240, true, _e2238);
                                                } else {
                                                    phi_3083_ = type_21();
                                                    phi_3084_ = true;
                                                }
                                                let _e2243 = phi_3083_;
                                                let _e2245 = phi_3084_;
                                                if _e2245 {
                                                    phi_3088_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_3088_ = _e2243;
                                                }
                                                let _e2247 = phi_3088_;
                                                if (_e2247.member_3 != 4294967295u) {
                                                    if (_e1397 == _e174) {
                                                        phi_3417_ = false;
                                                    } else {
                                                        let _e2251 = (_e1397 < arrayLength((&global_4.member)));
                                                        if _e2251 {
                                                            if _e2251 {
                                                            } else {
                                                                phi_5130_ = true;
                                                                break;
                                                            }
                                                            let _e2253 = global_4.member[_e1397];
                                                            phi_3111_ = _e2253;
                                                        } else {
                                                            phi_3111_ = 4294967295u;
                                                        }
                                                        let _e2255 = phi_3111_;
                                                        let _e2256 = (_e2255 < arrayLength((&global_5.member)));
                                                        if _e2256 {
                                                            if _e2256 {
                                                            } else {
                                                                phi_5130_ = true;
                                                                break;
                                                            }
                                                            let _e2258 = global_5.member[_e2255];
                                                            phi_3125_ = _e2258;
                                                        } else {
                                                            phi_3125_ = 0i;
                                                        }
                                                        let _e2260 = phi_3125_;
                                                        let _e2261 = (_e2260 == 0i);
                                                        if _e2261 {
                                                            phi_3416_ = true;
                                                        } else {
                                                            if _e452 {
                                                                phi_3146_ = vec3<f32>(_e1784[0][0], _e1784[0][1], _e1784[0][2]);
                                                            } else {
                                                                if (_e428 == 1u) {
                                                                    phi_3145_ = vec3<f32>(_e1784[0][2], _e1784[0][0], _e1784[0][1]);
                                                                } else {
                                                                    phi_3145_ = vec3<f32>(_e1784[0][1], _e1784[0][2], _e1784[0][0]);
                                                                }
                                                                let _e2266 = phi_3145_;
                                                                phi_3146_ = _e2266;
                                                            }
                                                            let _e2269 = phi_3146_;
                                                            if _e452 {
                                                                phi_3163_ = vec3<f32>(_e1784[1][0], _e1784[1][1], _e1784[1][2]);
                                                            } else {
                                                                if (_e428 == 1u) {
                                                                    phi_3162_ = vec3<f32>(_e1784[1][2], _e1784[1][0], _e1784[1][1]);
                                                                } else {
                                                                    phi_3162_ = vec3<f32>(_e1784[1][1], _e1784[1][2], _e1784[1][0]);
                                                                }
                                                                let _e2274 = phi_3162_;
                                                                phi_3163_ = _e2274;
                                                            }
                                                            let _e2277 = phi_3163_;
                                                            if _e452 {
                                                                phi_3180_ = vec3<f32>(_e1784[2][0], _e1784[2][1], _e1784[2][2]);
                                                            } else {
                                                                if (_e428 == 1u) {
                                                                    phi_3179_ = vec3<f32>(_e1784[2][2], _e1784[2][0], _e1784[2][1]);
                                                                } else {
                                                                    phi_3179_ = vec3<f32>(_e1784[2][1], _e1784[2][2], _e1784[2][0]);
                                                                }
                                                                let _e2282 = phi_3179_;
                                                                phi_3180_ = _e2282;
                                                            }
                                                            let _e2285 = phi_3180_;
                                                            let _e2288 = (_e2277.x - _e2269.x);
                                                            let _e2291 = (_e2277.y - _e2269.y);
                                                            let _e2294 = (_e2277.z - _e2269.z);
                                                            let _e2296 = (_e2285.x - _e2269.x);
                                                            let _e2298 = (_e2285.y - _e2269.y);
                                                            let _e2300 = (_e2285.z - _e2269.z);
                                                            if (_e306.member_1 == 1u) {
                                                                phi_3216_ = (vec3<f32>(_e306.member[0], _e306.member[1], _e306.member[2]) - _e2269);
                                                            } else {
                                                                phi_3216_ = vec3<f32>(_e306.member[0], _e306.member[1], _e306.member[2]);
                                                            }
                                                            let _e2315 = phi_3216_;
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
                                                                phi_3398_ = 0f;
                                                            } else {
                                                                let _e2412 = bitcast<f32>((bitcast<u32>(_e2342) & 2147483647u));
                                                                let _e2415 = bitcast<f32>((bitcast<u32>(_e2343) & 2147483647u));
                                                                let _e2418 = bitcast<f32>((bitcast<u32>(_e2344) & 2147483647u));
                                                                let _e2420 = select(_e2418, _e2415, (_e2415 > _e2418));
                                                                let _e2424 = select(_e2418, _e2415, (_e2415 < _e2418));
                                                                let _e2428 = select(_e2415, _e2412, (_e2412 < _e2415));
                                                                let _e2430 = select(_e2415, _e2412, (_e2412 > _e2415));
                                                                let _e2432 = select(_e2418, _e2430, (_e2430 < _e2418));
                                                                phi_3398_ = bitcast<f32>((bitcast<u32>((_e306.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2420, _e2412, (_e2412 > _e2420)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2432, _e2428, (_e2428 > _e2432)))) ^ _e306.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2424, _e2412, (_e2412 < _e2424)))) ^ _e306.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e2368 + _e2375) + _e2382))) ^ _e306.member_3[0]))) * 1.0000005f)) ^ _e306.member_3[0])))) ^ _e306.member_3[0]));
                                                            }
                                                            let _e2459 = phi_3398_;
                                                            phi_3416_ = (_e2261 || !(((((bitcast<f32>((bitcast<u32>((_e2315.x * _e2342)) ^ _e306.member_3[0])) + bitcast<f32>((bitcast<u32>((_e2315.y * _e2343)) ^ _e306.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e2315.z * _e2344)) ^ _e306.member_3[0]))) * f32(-(_e2260))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2315.x) & 2147483647u)) * _e2368)) ^ _e306.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2315.y) & 2147483647u)) * _e2375)) ^ _e306.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2315.z) & 2147483647u)) * _e2382)) ^ _e306.member_3[0]))))) ^ _e306.member_3[0])) + _e2459) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e2473 = phi_3416_;
                                                        phi_3417_ = _e2473;
                                                    }
                                                    let _e2475 = phi_3417_;
                                                    if _e2475 {
                                                        if (_e2247.member < _e1337.member.member) {
                                                            phi_3437_ = true;
                                                        } else {
                                                            if (_e2247.member == _e1337.member.member) {
                                                                phi_3436_ = (_e2247.member_3 < _e1337.member.member_3);
                                                            } else {
                                                                phi_3436_ = false;
                                                            }
                                                            let _e2485 = phi_3436_;
                                                            phi_3437_ = _e2485;
                                                        }
                                                        let _e2487 = phi_3437_;
                                                        if _e2487 {
                                                            phi_3443_ = type_38(_e2247, _e2247.member);
                                                        } else {
                                                            phi_3443_ = _e1337;
                                                        }
                                                        let _e2490 = phi_3443_;
                                                        phi_3444_ = _e2490;
                                                    } else {
                                                        phi_3444_ = _e1337;
                                                    }
                                                    let _e2492 = phi_3444_;
                                                    phi_3445_ = _e2492;
                                                } else {
                                                    phi_3445_ = _e1337;
                                                }
                                                let _e2494 = phi_3445_;
                                                phi_1512_ = _e2494;
                                            } else {
                                                phi_1512_ = type_38();
                                            }
                                            let _e2496 = phi_1512_;
                                            continue;
                                            continuing {
                                                phi_1511_ = _e2496;
                                                phi_1514_ = _e1352;
                                                phi_5130_ = _e803;
                                                break if !(_e1358);
                                            }
                                        }
                                        let _e2499 = phi_5130_;
                                        phi_5369_ = _e2499;
                                        if _e2499 {
                                            break;
                                        }
                                        phi_5373_ = _e2499;
                                        let _e2866 = local_11;
                                        phi_4685_ = _e2866;
                                        phi_4686_ = _e844;
                                        phi_4687_ = false;
                                        phi_4688_ = _e848;
                                    } else {
                                        if (_e844.member_1 >= _e106) {
                                            phi_4241_ = type_58(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_57(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_57(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e844.member_1 < _e106) {
                                            } else {
                                                phi_5369_ = true;
                                                break;
                                            }
                                            let _e860 = (_e428 * 2u);
                                            let _e862 = ((1u + _e860) % 7u);
                                            if (_e862 < 7u) {
                                            } else {
                                                phi_5369_ = true;
                                                break;
                                            }
                                            let _e867 = global_9.member[_e844.member_1][_e862];
                                            let _e869 = ((_e860 + 2u) % 7u);
                                            if (_e869 < 7u) {
                                            } else {
                                                phi_5369_ = true;
                                                break;
                                            }
                                            let _e874 = global_9.member[_e844.member_1][_e869];
                                            let _e875 = (_e427 * 2u);
                                            let _e877 = ((1u + _e875) % 7u);
                                            if (_e877 < 7u) {
                                            } else {
                                                phi_5369_ = true;
                                                break;
                                            }
                                            let _e882 = global_9.member[_e844.member_1][_e877];
                                            let _e884 = ((_e875 + 2u) % 7u);
                                            if (_e884 < 7u) {
                                            } else {
                                                phi_5369_ = true;
                                                break;
                                            }
                                            let _e889 = global_9.member[_e844.member_1][_e884];
                                            let _e890 = (_e429 * 2u);
                                            let _e892 = ((1u + _e890) % 7u);
                                            if (_e892 < 7u) {
                                            } else {
                                                phi_5369_ = true;
                                                break;
                                            }
                                            let _e897 = global_9.member[_e844.member_1][_e892];
                                            let _e899 = ((_e890 + 2u) % 7u);
                                            if (_e899 < 7u) {
                                            } else {
                                                phi_5369_ = true;
                                                break;
                                            }
                                            let _e904 = global_9.member[_e844.member_1][_e899];
                                            let _e927 = (bitcast<f32>((bitcast<u32>((_e844.member.member_1.x - _e844.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e928 = (bitcast<f32>((bitcast<u32>((_e844.member.member_1.y - _e844.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e929 = (bitcast<f32>((bitcast<u32>((_e844.member.member_1.z - _e844.member.member.z)) & 2139095040u)) * 0.0000009536743f);
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
                                            let _e1044 = (_e844.member.member.x + _e974);
                                            let _e1045 = (_e844.member.member.y + _e983);
                                            let _e1046 = (_e844.member.member.z + _e992);
                                            let _e1049 = (_e844.member.member_1.x - _e1013);
                                            let _e1050 = (_e844.member.member_1.y - _e1022);
                                            let _e1051 = (_e844.member.member_1.z - _e1031);
                                            let _e1070 = (_e1049 - _e1044);
                                            let _e1071 = (_e1050 - _e1045);
                                            let _e1072 = (_e1051 - _e1046);
                                            let _e1074 = select(_e1071, _e1070, (_e1070 > _e1071));
                                            let _e1076 = select(_e1072, _e1074, (_e1074 > _e1072));
                                            if (_e1076 < (1024f * _e165)) {
                                                phi_3942_ = 0u;
                                            } else {
                                                phi_3942_ = select(2u, 1u, (_e1076 < (2097152f * _e165)));
                                            }
                                            let _e1083 = phi_3942_;
                                            switch bitcast<i32>(_e1083) {
                                                case 0: {
                                                    phi_3948_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3948_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3948_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3948_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e1086 = phi_3948_;
                                            let _e1092 = global_9.member[_e844.member_1][0u];
                                            let _e1096 = global_9.member[_e844.member_1][2u];
                                            let _e1100 = global_9.member[_e844.member_1][4u];
                                            let _e1104 = global_9.member[_e844.member_1][6u];
                                            let _e1116 = (((_e1096 >> bitcast<u32>(22i)) | ((_e1100 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1104 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1117 = (_e1092 & 268435455u);
                                            let _e1118 = (_e1116 & 268435455u);
                                            let _e1121 = ((_e1092 >> bitcast<u32>(28u)) & 7u);
                                            let _e1129 = ((_e1092 >> bitcast<u32>(31i)) | (((_e1116 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1130 = (_e1121 != 0u);
                                            if (_e1121 == 0u) {
                                                phi_4203_ = _e1117;
                                            } else {
                                                if (_e1121 == 7u) {
                                                    phi_4202_ = 2147483648u;
                                                } else {
                                                    phi_4202_ = ((2147483648u | (_e1121 << bitcast<u32>(28u))) | (_e1118 & 268435455u));
                                                }
                                                let _e1139 = phi_4202_;
                                                phi_4203_ = _e1139;
                                            }
                                            let _e1141 = phi_4203_;
                                            if _e1130 {
                                                let _e1142 = (_e1121 != 7u);
                                                if _e1142 {
                                                    phi_4213_ = (_e1118 + (_e1121 * ((3u * _e1086) + 1u)));
                                                } else {
                                                    phi_4213_ = u32();
                                                }
                                                let _e1146 = phi_4213_;
                                                phi_4215_ = _e1146;
                                                phi_4216_ = select(true, false, _e1142);
                                            } else {
                                                phi_4215_ = u32();
                                                phi_4216_ = true;
                                            }
                                            let _e1149 = phi_4215_;
                                            let _e1151 = phi_4216_;
                                            if (_e1129 == 0u) {
                                                phi_4237_ = (_e1117 + select(0u, 1u, !(_e1130)));
                                            } else {
                                                if (_e1129 == 7u) {
                                                    phi_4236_ = 2147483648u;
                                                } else {
                                                    phi_4236_ = ((2147483648u | (_e1129 << bitcast<u32>(28u))) | (select(_e1149, _e1118, _e1151) & 268435455u));
                                                }
                                                let _e1164 = phi_4236_;
                                                phi_4237_ = _e1164;
                                            }
                                            let _e1166 = phi_4237_;
                                            phi_4241_ = type_58(array<vec4<f32>, 3>(vec4<f32>(_e1044, (_e844.member.member.x + _e996), _e1049, (_e844.member.member_1.x - _e1035)), vec4<f32>(_e1045, (_e844.member.member.y + _e1000), _e1050, (_e844.member.member_1.y - _e1039)), vec4<f32>(_e1046, (_e844.member.member.z + _e1004), _e1051, (_e844.member.member_1.z - _e1043))), type_57(type_33((_e844.member.member + vec4<f32>(_e974, _e983, _e992, 0f)), (_e844.member.member_1 - vec4<f32>(_e1013, _e1022, _e1031, 0f))), _e1141), type_57(type_33((_e844.member.member + vec4<f32>(_e996, _e1000, _e1004, 0f)), (_e844.member.member_1 - vec4<f32>(_e1035, _e1039, _e1043, 0f))), _e1166));
                                        }
                                        let _e1171 = phi_4241_;
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
                                                    phi_4585_ = _e1171.member_2;
                                                } else {
                                                    phi_4585_ = _e1171.member_1;
                                                }
                                                let _e1277 = phi_4585_;
                                                let _e1299 = (_e848 % 128u);
                                                let _e1300 = (_e1299 < 128u);
                                                if _e1300 {
                                                } else {
                                                    phi_5369_ = true;
                                                    break;
                                                }
                                                local_8[_e1299] = _e1277.member_1;
                                                if _e1300 {
                                                } else {
                                                    phi_5369_ = true;
                                                    break;
                                                }
                                                local_7[_e1299] = _e1277.member.member.x;
                                                if _e1300 {
                                                } else {
                                                    phi_5369_ = true;
                                                    break;
                                                }
                                                local_6[_e1299] = _e1277.member.member.y;
                                                if _e1300 {
                                                } else {
                                                    phi_5369_ = true;
                                                    break;
                                                }
                                                local_5[_e1299] = _e1277.member.member.z;
                                                if _e1300 {
                                                } else {
                                                    phi_5369_ = true;
                                                    break;
                                                }
                                                local_4[_e1299] = _e1277.member.member_1.x;
                                                if _e1300 {
                                                } else {
                                                    phi_5369_ = true;
                                                    break;
                                                }
                                                local_3[_e1299] = _e1277.member.member_1.y;
                                                if _e1300 {
                                                } else {
                                                    phi_5369_ = true;
                                                    break;
                                                }
                                                local_2[_e1299] = _e1277.member.member_1.z;
                                                if _e1300 {
                                                } else {
                                                    phi_5369_ = true;
                                                    break;
                                                }
                                                local_9[_e1299] = select(_e1266, _e1264, (_e1264 > _e1266));
                                                if _e1273 {
                                                    phi_4662_ = _e1171.member_1;
                                                } else {
                                                    phi_4662_ = _e1171.member_2;
                                                }
                                                let _e1313 = phi_4662_;
                                                phi_4663_ = _e1313;
                                                phi_4664_ = (_e848 + 1u);
                                            } else {
                                                phi_4663_ = type_57();
                                                phi_4664_ = u32();
                                            }
                                            let _e1315 = phi_4663_;
                                            let _e1317 = phi_4664_;
                                            phi_4666_ = _e1315;
                                            phi_4667_ = _e1317;
                                            phi_4668_ = select(true, false, _e1272);
                                        } else {
                                            phi_4666_ = type_57();
                                            phi_4667_ = u32();
                                            phi_4668_ = true;
                                        }
                                        let _e1320 = phi_4666_;
                                        let _e1322 = phi_4667_;
                                        let _e1324 = phi_4668_;
                                        if _e1324 {
                                            if _e1271 {
                                                phi_4677_ = _e1171.member_1;
                                            } else {
                                                phi_4677_ = _e1171.member_2;
                                            }
                                            let _e1328 = phi_4677_;
                                            phi_4682_ = _e1328;
                                            phi_4683_ = select(_e1272, true, _e1271);
                                        } else {
                                            phi_4682_ = _e1320;
                                            phi_4683_ = _e846;
                                        }
                                        let _e1331 = phi_4682_;
                                        let _e1333 = phi_4683_;
                                        phi_5373_ = _e803;
                                        phi_4685_ = _e805;
                                        phi_4686_ = _e1331;
                                        phi_4687_ = _e1333;
                                        phi_4688_ = select(_e1322, _e848, _e1324);
                                    }
                                    let _e2501 = phi_5373_;
                                    let _e2503 = phi_4685_;
                                    let _e2505 = phi_4686_;
                                    let _e2507 = phi_4687_;
                                    let _e2509 = phi_4688_;
                                    phi_5372_ = _e2501;
                                    phi_4689_ = _e2503;
                                    phi_4690_ = _e2505;
                                    phi_4691_ = (_e809 - 1u);
                                    phi_4692_ = _e2507;
                                    phi_4693_ = _e2509;
                                } else {
                                    phi_5372_ = _e803;
                                    phi_4689_ = _e805;
                                    phi_4690_ = _e844;
                                    phi_4691_ = _e809;
                                    phi_4692_ = _e846;
                                    phi_4693_ = _e848;
                                }
                                let _e2511 = phi_5372_;
                                let _e2513 = phi_4689_;
                                let _e2515 = phi_4690_;
                                let _e2517 = phi_4691_;
                                let _e2519 = phi_4692_;
                                let _e2521 = phi_4693_;
                                phi_5371_ = _e2511;
                                phi_4694_ = _e2513;
                                phi_4695_ = _e2515;
                                phi_4696_ = _e2517;
                                phi_4697_ = _e2519;
                                phi_4698_ = _e2521;
                            } else {
                                phi_5371_ = _e803;
                                phi_4694_ = type_38();
                                phi_4695_ = type_57();
                                phi_4696_ = u32();
                                phi_4697_ = bool();
                                phi_4698_ = u32();
                            }
                            let _e2523 = phi_5371_;
                            let _e2525 = phi_4694_;
                            let _e2527 = phi_4695_;
                            let _e2529 = phi_4696_;
                            let _e2531 = phi_4697_;
                            let _e2533 = phi_4698_;
                            phi_5370_ = _e2523;
                            phi_1385_ = _e2525;
                            phi_1388_ = _e2527;
                            phi_1390_ = _e2529;
                            phi_1392_ = _e2531;
                            phi_1394_ = _e2533;
                            phi_4699_ = _e817;
                        } else {
                            phi_5370_ = _e803;
                            phi_1385_ = type_38();
                            phi_1388_ = type_57();
                            phi_1390_ = u32();
                            phi_1392_ = bool();
                            phi_1394_ = u32();
                            phi_4699_ = false;
                        }
                        let _e2535 = phi_5370_;
                        let _e2537 = phi_1385_;
                        let _e2539 = phi_1388_;
                        let _e2541 = phi_1390_;
                        let _e2543 = phi_1392_;
                        let _e2545 = phi_1394_;
                        let _e2547 = phi_4699_;
                        continue;
                        continuing {
                            phi_5136_ = _e2535;
                            phi_1384_ = _e2537;
                            phi_1387_ = _e2539;
                            phi_1389_ = _e2541;
                            phi_1391_ = _e2543;
                            phi_1393_ = _e2545;
                            phi_5369_ = _e2535;
                            break if !(_e2547);
                        }
                    }
                    let _e2550 = phi_5369_;
                    if _e2550 {
                        break;
                    }
                    let _e2552 = local_10;
                    if (_e2552.member.member_3 != 4294967295u) {
                        let _e2557 = bitcast<u32>(_e2552.member.member);
                        let _e2561 = (bitcast<i32>((_e2557 >> bitcast<u32>(23i))) & 255i);
                        let _e2562 = (_e2561 + _e430);
                        if (_e2561 == 255i) {
                            phi_4758_ = _e2552.member.member;
                        } else {
                            if (_e2561 > 0i) {
                                if (_e2562 > 0i) {
                                    let _e2566 = (_e2562 < 255i);
                                    if _e2566 {
                                        phi_4737_ = bitcast<f32>((_e2557 + bitcast<u32>((_e430 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_4737_ = f32();
                                    }
                                    let _e2573 = phi_4737_;
                                    phi_4739_ = _e2573;
                                    phi_4740_ = select(true, false, _e2566);
                                } else {
                                    phi_4739_ = f32();
                                    phi_4740_ = true;
                                }
                                let _e2576 = phi_4739_;
                                let _e2578 = phi_4740_;
                                phi_4741_ = _e2576;
                                phi_4742_ = _e2578;
                            } else {
                                phi_4741_ = f32();
                                phi_4742_ = true;
                            }
                            let _e2580 = phi_4741_;
                            let _e2582 = phi_4742_;
                            if _e2582 {
                                let _e2583 = (_e2557 & 2147483648u);
                                let _e2590 = ((_e2557 & 8388607u) | (select(0u, 1u, ((_e2557 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e2594 = (_e2590 == 0u);
                                if _e2594 {
                                    phi_5088_ = bitcast<f32>(_e2583);
                                } else {
                                    let _e2599 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2590)), 32u, _e2594) - 8u);
                                    let _e2602 = (_e2590 << bitcast<u32>((_e2599 & 31u)));
                                    let _e2604 = ((_e2562 + select(0i, 1i, (_e2561 == 0i))) - bitcast<i32>(_e2599));
                                    if (_e2604 >= 255i) {
                                        phi_5078_ = bitcast<f32>((_e2583 | 2139095040u));
                                        phi_5079_ = f32();
                                        phi_5080_ = true;
                                    } else {
                                        let _e2606 = (_e2604 > 0i);
                                        if _e2606 {
                                            phi_5072_ = bitcast<f32>(((_e2583 | (bitcast<u32>(_e2604) << bitcast<u32>(23i))) | (_e2602 & 8388607u)));
                                            phi_5073_ = f32();
                                        } else {
                                            if (_e2604 < -24i) {
                                                phi_5038_ = 26u;
                                            } else {
                                                phi_5038_ = bitcast<u32>((1i - _e2604));
                                            }
                                            let _e2611 = phi_5038_;
                                            let _e2612 = (_e2611 & 31u);
                                            let _e2614 = (_e2602 >> bitcast<u32>(_e2612));
                                            let _e2618 = (_e2602 & ((1u << bitcast<u32>(_e2612)) - 1u));
                                            let _e2622 = (1u << bitcast<u32>(((_e2611 - 1u) & 31u)));
                                            if (_e2618 > _e2622) {
                                                phi_5059_ = true;
                                            } else {
                                                if (_e2618 == _e2622) {
                                                    phi_5056_ = ((_e2614 & 1u) == 1u);
                                                } else {
                                                    phi_5056_ = false;
                                                }
                                                let _e2628 = phi_5056_;
                                                phi_5059_ = _e2628;
                                            }
                                            let _e2630 = phi_5059_;
                                            phi_5072_ = f32();
                                            phi_5073_ = bitcast<f32>((_e2583 | (_e2614 + select(0u, 1u, _e2630))));
                                        }
                                        let _e2643 = phi_5072_;
                                        let _e2645 = phi_5073_;
                                        phi_5078_ = _e2643;
                                        phi_5079_ = _e2645;
                                        phi_5080_ = _e2606;
                                    }
                                    let _e2649 = phi_5078_;
                                    let _e2651 = phi_5079_;
                                    let _e2653 = phi_5080_;
                                    phi_5088_ = select(_e2651, _e2649, _e2653);
                                }
                                let _e2657 = phi_5088_;
                                phi_4757_ = _e2657;
                            } else {
                                phi_4757_ = _e2580;
                            }
                            let _e2659 = phi_4757_;
                            phi_4758_ = _e2659;
                        }
                        let _e2661 = phi_4758_;
                        let _e2662 = bitcast<u32>(_e2661);
                        if ((_e2662 & 2147483647u) >= 2139095040u) {
                            phi_4770_ = bitcast<f32>(((_e2662 & 2147483648u) | 2139095039u));
                        } else {
                            phi_4770_ = _e2661;
                        }
                        let _e2669 = phi_4770_;
                        phi_4775_ = type_21(_e2669, _e2552.member.member_1, _e2552.member.member_2, _e2552.member.member_3);
                    } else {
                        phi_4775_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2674 = phi_4775_;
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
