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

struct type_30 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_32 {
    member: array<type_30>,
}

struct type_34 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_35 {
    member: type_34,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_37 {
    member: array<type_35>,
}

struct type_42 {
    member: array<vec4<u32>, 5>,
}

struct type_44 {
    member: array<f32, 3>,
    member_1: f32,
}

struct type_46 {
    member: array<type_44>,
}

struct type_48 {
    member: type_34,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_50 {
    member: array<type_48>,
}

struct type_52 {
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
var<uniform> global_2: type_42;
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
var<storage> global_8: type_46;
@group(0) @binding(8) 
var<storage> global_9: type_32;
@group(0) @binding(9) 
var<storage> global_10: type_37;
@group(0) @binding(10) 
var<storage, read_write> global_11: type_50;
var<private> global_12: vec3<f32> = vec3<f32>(0f, 0f, 0f);

fn function_() {
    var local: type_52;
    var local_1: type_52;
    var phi_313_: array<u32, 3>;
    var phi_328_: array<f32, 3>;
    var phi_346_: array<f32, 3>;
    var phi_364_: array<f32, 3>;
    var phi_451_: array<u32, 3>;
    var phi_468_: vec3<f32>;
    var phi_485_: vec3<f32>;
    var phi_502_: vec3<f32>;
    var phi_636_: i32;
    var phi_667_: i32;
    var phi_686_: vec3<f32>;
    var phi_769_: i32;
    var phi_800_: i32;
    var phi_819_: vec3<f32>;
    var phi_861_: u32;
    var phi_1068_: type_7;
    var phi_1069_: type_7;
    var phi_1092_: type_7;
    var phi_3150_: bool;
    var phi_1254_: type_7;
    var phi_1257_: u32;
    var phi_1259_: u32;
    var phi_1255_: type_7;
    var phi_1282_: type_7;
    var phi_1298_: u32;
    var phi_1258_: u32;
    var phi_1260_: u32;
    var local_2: u32;
    var phi_1333_: i32;
    var phi_1340_: i32;
    var phi_2393_: f32;
    var phi_2406_: f32;
    var phi_1575_: array<f32, 2>;
    var phi_1604_: type_52;
    var phi_2480_: vec3<f32>;
    var phi_2681_: bool;
    var phi_2684_: bool;
    var phi_2685_: bool;
    var phi_2932_: f32;
    var phi_2936_: f32;
    var phi_2939_: f32;
    var phi_2954_: f32;
    var phi_2958_: f32;
    var phi_2960_: f32;
    var phi_2983_: f32;
    var phi_2987_: f32;
    var phi_2990_: f32;
    var phi_3005_: f32;
    var phi_3009_: f32;
    var phi_3011_: f32;
    var phi_3034_: f32;
    var phi_3038_: f32;
    var phi_3041_: f32;
    var phi_3056_: f32;
    var phi_3060_: f32;
    var phi_3062_: f32;
    var phi_2706_: vec3<f32>;
    var phi_2739_: bool;
    var phi_2745_: f32;
    var phi_2784_: f32;
    var phi_2833_: type_48;
    var phi_2836_: type_48;
    var phi_2837_: bool;
    var phi_2839_: type_48;
    var phi_2840_: bool;
    var phi_2844_: type_48;
    var phi_2846_: type_48;
    var phi_2850_: type_48;
    var phi_2851_: bool;
    var phi_2855_: type_48;
    var phi_1638_: type_48;
    var phi_1639_: type_48;
    var phi_1640_: type_48;

    switch bitcast<i32>(0u) {
        default: {
            let _e85 = global;
            let _e88 = arrayLength((&global_4.member));
            let _e93 = arrayLength((&global_6.member));
            let _e97 = arrayLength((&global_8.member));
            let _e107 = (_e85.x + (_e85.y * 2097152u));
            let _e108 = (_e107 < arrayLength((&global_10.member)));
            if _e108 {
                let _e109 = (_e107 < arrayLength((&global_9.member)));
                if _e109 {
                    let _e110 = (_e107 < arrayLength((&global_11.member)));
                    if _e110 {
                        if _e108 {
                        } else {
                            break;
                        }
                        let _e113 = global_10.member[_e107];
                        if _e109 {
                        } else {
                            break;
                        }
                        let _e116 = global_9.member[_e107];
                        if (_e113.member.member_1 <= _e113.member.member_3) {
                            if (_e116.member_3 != 4294967295u) {
                                if (_e97 == 0u) {
                                    phi_1638_ = type_48(type_34(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                                } else {
                                    let _e127 = global_1.member[0u];
                                    let _e128 = bitcast<i32>(_e127);
                                    let _e129 = (_e128 / 2i);
                                    let _e134 = bitcast<f32>((bitcast<u32>((_e129 + 127i)) << bitcast<u32>(23i)));
                                    let _e140 = bitcast<f32>((bitcast<u32>(((_e128 - _e129) + 127i)) << bitcast<u32>(23i)));
                                    let _e141 = (_e116.member_3 < arrayLength((&global_5.member)));
                                    if _e141 {
                                        if _e141 {
                                        } else {
                                            break;
                                        }
                                        let _e143 = global_5.member[_e116.member_3];
                                        phi_313_ = _e143;
                                    } else {
                                        phi_313_ = array<u32, 3>(0u, 0u, 0u);
                                    }
                                    let _e145 = phi_313_;
                                    let _e147 = (_e145[0] < _e88);
                                    if _e147 {
                                        if _e147 {
                                        } else {
                                            break;
                                        }
                                        let _e149 = global_4.member[_e145[0]];
                                        phi_328_ = _e149;
                                    } else {
                                        phi_328_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e151 = phi_328_;
                                    let _e156 = (_e145[1] < _e88);
                                    if _e156 {
                                        if _e156 {
                                        } else {
                                            break;
                                        }
                                        let _e158 = global_4.member[_e145[1]];
                                        phi_346_ = _e158;
                                    } else {
                                        phi_346_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e160 = phi_346_;
                                    let _e165 = (_e145[2] < _e88);
                                    if _e165 {
                                        if _e165 {
                                        } else {
                                            break;
                                        }
                                        let _e167 = global_4.member[_e145[2]];
                                        phi_364_ = _e167;
                                    } else {
                                        phi_364_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e169 = phi_364_;
                                    let _e174 = ((_e151[0] * _e134) * _e140);
                                    let _e176 = select(_e174, 0f, (_e174 == 0f));
                                    let _e178 = ((_e151[1] * _e134) * _e140);
                                    let _e180 = select(_e178, 0f, (_e178 == 0f));
                                    let _e182 = ((_e151[2] * _e134) * _e140);
                                    let _e184 = select(_e182, 0f, (_e182 == 0f));
                                    let _e186 = ((_e160[0] * _e134) * _e140);
                                    let _e188 = select(_e186, 0f, (_e186 == 0f));
                                    let _e190 = ((_e160[1] * _e134) * _e140);
                                    let _e192 = select(_e190, 0f, (_e190 == 0f));
                                    let _e194 = ((_e160[2] * _e134) * _e140);
                                    let _e196 = select(_e194, 0f, (_e194 == 0f));
                                    let _e198 = ((_e169[0] * _e134) * _e140);
                                    let _e200 = select(_e198, 0f, (_e198 == 0f));
                                    let _e202 = ((_e169[1] * _e134) * _e140);
                                    let _e204 = select(_e202, 0f, (_e202 == 0f));
                                    let _e206 = ((_e169[2] * _e134) * _e140);
                                    let _e208 = select(_e206, 0f, (_e206 == 0f));
                                    if _e141 {
                                        if _e141 {
                                        } else {
                                            break;
                                        }
                                        let _e211 = global_5.member[_e116.member_3];
                                        phi_451_ = _e211;
                                    } else {
                                        phi_451_ = array<u32, 3>(0u, 0u, 0u);
                                    }
                                    let _e213 = phi_451_;
                                    let _e215 = (_e213[0] < _e93);
                                    if _e215 {
                                        if _e215 {
                                        } else {
                                            break;
                                        }
                                        let _e218 = global_6.member[_e213[0]];
                                        phi_468_ = vec3<f32>(_e218[0], _e218[1], _e218[2]);
                                    } else {
                                        phi_468_ = vec3<f32>(0f, 0f, 0f);
                                    }
                                    let _e224 = phi_468_;
                                    let _e226 = (_e213[1] < _e93);
                                    if _e226 {
                                        if _e226 {
                                        } else {
                                            break;
                                        }
                                        let _e229 = global_6.member[_e213[1]];
                                        phi_485_ = vec3<f32>(_e229[0], _e229[1], _e229[2]);
                                    } else {
                                        phi_485_ = vec3<f32>(0f, 0f, 0f);
                                    }
                                    let _e235 = phi_485_;
                                    let _e237 = (_e213[2] < _e93);
                                    if _e237 {
                                        if _e237 {
                                        } else {
                                            break;
                                        }
                                        let _e240 = global_6.member[_e213[2]];
                                        phi_502_ = vec3<f32>(_e240[0], _e240[1], _e240[2]);
                                    } else {
                                        phi_502_ = vec3<f32>(0f, 0f, 0f);
                                    }
                                    let _e246 = phi_502_;
                                    let _e255 = ((1f - _e116.member_1) - _e116.member_2);
                                    let _e257 = select(0f, _e255, (_e255 > 0f));
                                    let _e259 = select(1f, _e116.member_1, (_e116.member_1 < 1f));
                                    let _e261 = select(1f, _e116.member_2, (_e116.member_2 < 1f));
                                    let _e262 = (_e176 * _e257);
                                    let _e263 = (_e180 * _e257);
                                    let _e264 = (_e184 * _e257);
                                    let _e265 = (_e188 * _e259);
                                    let _e266 = (_e192 * _e259);
                                    let _e267 = (_e196 * _e259);
                                    let _e268 = (_e200 * _e261);
                                    let _e269 = (_e204 * _e261);
                                    let _e270 = (_e208 * _e261);
                                    let _e310 = (((bitcast<f32>((bitcast<u32>(_e262) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e265) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e268) & 2147483647u))) * 0.00000071525625f);
                                    let _e311 = (((bitcast<f32>((bitcast<u32>(_e263) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e266) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e269) & 2147483647u))) * 0.00000071525625f);
                                    let _e312 = (((bitcast<f32>((bitcast<u32>(_e264) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e267) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e270) & 2147483647u))) * 0.00000071525625f);
                                    let _e313 = (_e188 - _e176);
                                    let _e314 = (_e192 - _e180);
                                    let _e315 = (_e196 - _e184);
                                    let _e316 = (_e200 - _e176);
                                    let _e317 = (_e204 - _e180);
                                    let _e318 = (_e208 - _e184);
                                    let _e319 = (_e314 * _e318);
                                    let _e321 = (_e319 - (_e317 * _e315));
                                    let _e322 = (_e315 * _e316);
                                    let _e324 = (_e322 - (_e318 * _e313));
                                    let _e325 = (_e313 * _e317);
                                    let _e327 = (_e325 - (_e316 * _e314));
                                    let _e330 = bitcast<f32>((bitcast<u32>(_e321) & 2147483647u));
                                    let _e333 = bitcast<f32>((bitcast<u32>(_e324) & 2147483647u));
                                    let _e335 = select(_e333, _e330, (_e330 > _e333));
                                    let _e338 = bitcast<f32>((bitcast<u32>(_e327) & 2147483647u));
                                    let _e340 = select(_e338, _e335, (_e335 > _e338));
                                    if (_e340 < 0.000000000000000000000000000000000000011754944f) {
                                        phi_686_ = vec3<f32>(0f, 0f, 0f);
                                    } else {
                                        let _e343 = (bitcast<u32>(_e340) & 2147483647u);
                                        let _e344 = (_e343 >= 8388608u);
                                        if _e344 {
                                            phi_636_ = (bitcast<i32>((_e343 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_636_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e343)), 32u, (_e343 == 0u))));
                                        }
                                        let _e357 = phi_636_;
                                        let _e364 = bitcast<f32>((bitcast<u32>(((_e357 / -2i) + 127i)) << bitcast<u32>(23i)));
                                        if _e344 {
                                            phi_667_ = (bitcast<i32>((_e343 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_667_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e343)), 32u, (_e343 == 0u))));
                                        }
                                        let _e380 = phi_667_;
                                        let _e386 = bitcast<f32>((bitcast<u32>((((_e357 / 2i) - _e380) + 127i)) << bitcast<u32>(23i)));
                                        let _e387 = ((_e321 * _e364) * _e386);
                                        let _e388 = ((_e324 * _e364) * _e386);
                                        let _e389 = ((_e327 * _e364) * _e386);
                                        let _e395 = sqrt((((_e387 * _e387) + (_e388 * _e388)) + (_e389 * _e389)));
                                        phi_686_ = vec3<f32>((_e387 / _e395), (_e388 / _e395), (_e389 / _e395));
                                    }
                                    let _e401 = phi_686_;
                                    let _e411 = select(1f, -1f, ((((_e401.x * _e113.member.member_2[0]) + (_e401.y * _e113.member.member_2[1])) + (_e401.z * _e113.member.member_2[2])) > 0f));
                                    let _e415 = (_e401 * _e411);
                                    let _e437 = (((_e224.x * _e257) + (_e235.x * _e259)) + (_e246.x * _e261));
                                    let _e438 = (((_e224.y * _e257) + (_e235.y * _e259)) + (_e246.y * _e261));
                                    let _e439 = (((_e224.z * _e257) + (_e235.z * _e259)) + (_e246.z * _e261));
                                    let _e442 = bitcast<f32>((bitcast<u32>(_e437) & 2147483647u));
                                    let _e445 = bitcast<f32>((bitcast<u32>(_e438) & 2147483647u));
                                    let _e447 = select(_e445, _e442, (_e442 > _e445));
                                    let _e450 = bitcast<f32>((bitcast<u32>(_e439) & 2147483647u));
                                    let _e452 = select(_e450, _e447, (_e447 > _e450));
                                    if (_e452 < 0.000000000000000000000000000000000000011754944f) {
                                        phi_819_ = vec3<f32>(0f, 0f, 0f);
                                    } else {
                                        let _e455 = (bitcast<u32>(_e452) & 2147483647u);
                                        let _e456 = (_e455 >= 8388608u);
                                        if _e456 {
                                            phi_769_ = (bitcast<i32>((_e455 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_769_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e455)), 32u, (_e455 == 0u))));
                                        }
                                        let _e469 = phi_769_;
                                        let _e476 = bitcast<f32>((bitcast<u32>(((_e469 / -2i) + 127i)) << bitcast<u32>(23i)));
                                        if _e456 {
                                            phi_800_ = (bitcast<i32>((_e455 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_800_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e455)), 32u, (_e455 == 0u))));
                                        }
                                        let _e492 = phi_800_;
                                        let _e498 = bitcast<f32>((bitcast<u32>((((_e469 / 2i) - _e492) + 127i)) << bitcast<u32>(23i)));
                                        let _e499 = ((_e437 * _e476) * _e498);
                                        let _e500 = ((_e438 * _e476) * _e498);
                                        let _e501 = ((_e439 * _e476) * _e498);
                                        let _e507 = sqrt((((_e499 * _e499) + (_e500 * _e500)) + (_e501 * _e501)));
                                        phi_819_ = vec3<f32>((_e499 / _e507), (_e500 / _e507), (_e501 / _e507));
                                    }
                                    let _e513 = phi_819_;
                                    let _e528 = select(_e415, (_e513 * _e411), vec3((((((_e513.x * _e411) * (_e401.x * _e411)) + ((_e513.y * _e411) * (_e401.y * _e411))) + ((_e513.z * _e411) * (_e401.z * _e411))) > 0f)));
                                    let _e529 = (_e116.member_3 < arrayLength((&global_7.member)));
                                    if _e529 {
                                        if _e529 {
                                        } else {
                                            break;
                                        }
                                        let _e532 = global_7.member[_e116.member_3];
                                        phi_861_ = _e532;
                                    } else {
                                        phi_861_ = 0u;
                                    }
                                    let _e534 = phi_861_;
                                    let _e536 = select(_e534, 0u, (_e534 >= _e97));
                                    if (_e536 < _e97) {
                                    } else {
                                        break;
                                    }
                                    let _e540 = global_8.member[_e536];
                                    let _e546 = global_3.member[0u];
                                    let _e549 = global_3.member[1u];
                                    let _e552 = global_2.member[0u];
                                    let _e562 = global_2.member[0u][3u];
                                    let _e565 = global_2.member[1u];
                                    let _e575 = global_2.member[1u][3u];
                                    let _e579 = global_2.member[2u];
                                    let _e589 = global_2.member[2u][3u];
                                    let _e592 = global_2.member[3u];
                                    let _e602 = global_2.member[3u][3u];
                                    let _e605 = global_2.member[4u];
                                    let _e615 = global_2.member[4u][3u];
                                    local_1 = type_52(array<f32, 3>(bitcast<f32>(_e552.x), bitcast<f32>(_e552.y), bitcast<f32>(_e552.z)), _e562, array<f32, 3>(bitcast<f32>(_e565.x), bitcast<f32>(_e565.y), bitcast<f32>(_e565.z)), bitcast<f32>(_e575), array<f32, 3>(bitcast<f32>(_e579.x), bitcast<f32>(_e579.y), bitcast<f32>(_e579.z)), _e589, array<f32, 3>(bitcast<f32>(_e592.x), bitcast<f32>(_e592.y), bitcast<f32>(_e592.z)), _e602, array<f32, 3>(bitcast<f32>(_e605.x), bitcast<f32>(_e605.y), bitcast<f32>(_e605.z)), _e615);
                                    let _e622 = local_1;
                                    local = _e622;
                                    let _e624 = local_1.member_1;
                                    if (_e624 == 1u) {
                                        let _e627 = local_1.member;
                                        local.member = array<f32, 3>(((_e627[0] * _e134) * _e140), ((_e627[1] * _e134) * _e140), ((_e627[2] * _e134) * _e140));
                                        let _e640 = local_1.member_4;
                                        local.member_4 = array<f32, 3>(((_e640[0] * _e134) * _e140), ((_e640[1] * _e134) * _e140), ((_e640[2] * _e134) * _e140));
                                        let _e653 = local_1.member_6;
                                        local.member_6 = array<f32, 3>(((_e653[0] * _e134) * _e140), ((_e653[1] * _e134) * _e140), ((_e653[2] * _e134) * _e140));
                                        phi_1068_ = type_7(0u, 3u);
                                        loop {
                                            let _e666 = phi_1068_;
                                            if (_e666.member < _e666.member_1) {
                                                phi_1069_ = type_7((_e666.member + 1u), _e666.member_1);
                                                phi_1092_ = type_7(1u, _e666.member);
                                            } else {
                                                phi_1069_ = _e666;
                                                phi_1092_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e679 = phi_1069_;
                                            let _e681 = phi_1092_;
                                            let _e685 = (bitcast<i32>(_e681.member) != 0i);
                                            if _e685 {
                                                let _e686 = (_e681.member_1 < 3u);
                                                if _e686 {
                                                } else {
                                                    phi_3150_ = true;
                                                    break;
                                                }
                                                let _e689 = local_1.member_2[_e681.member_1];
                                                let _e693 = ((((_e689 * _e134) * _e140) * _e134) * _e140);
                                                if _e686 {
                                                } else {
                                                    phi_3150_ = true;
                                                    break;
                                                }
                                                local.member_2[_e681.member_1] = select(340282350000000000000000000000000000000f, _e693, (_e693 < 340282350000000000000000000000000000000f));
                                            }
                                            continue;
                                            continuing {
                                                phi_1068_ = _e679;
                                                phi_3150_ = false;
                                                break if !(_e685);
                                            }
                                        }
                                        let _e700 = phi_3150_;
                                        if _e700 {
                                            break;
                                        }
                                        let _e702 = local_1.member_3;
                                        if (_e702 < 340282350000000000000000000000000000000f) {
                                            let _e704 = local_1.member_3;
                                            let _e706 = ((_e704 * _e134) * _e140);
                                            local.member_3 = select(340282350000000000000000000000000000000f, _e706, (_e706 < 340282350000000000000000000000000000000f));
                                        }
                                    }
                                    let _e710 = local;
                                    let _e741 = type_52(array<f32, 3>(_e710.member[0], _e710.member[1], _e710.member[2]), _e710.member_1, array<f32, 3>(_e710.member_2[0], _e710.member_2[1], _e710.member_2[2]), _e710.member_3, array<f32, 3>(_e710.member_4[0], _e710.member_4[1], _e710.member_4[2]), _e710.member_5, array<f32, 3>(_e710.member_6[0], _e710.member_6[1], _e710.member_6[2]), _e710.member_7, array<f32, 3>(_e710.member_8[0], _e710.member_8[1], _e710.member_8[2]), _e710.member_9);
                                    if (_e710.member_5 != 0u) {
                                        let _e745 = select(1u, _e546, (1u < _e546));
                                        let _e746 = (_e745 == 0u);
                                        if _e746 {
                                            break;
                                        }
                                        let _e747 = (_e113.member_4 / _e745);
                                        if _e746 {
                                            break;
                                        }
                                        let _e752 = ((_e747 ^ (_e747 >> bitcast<u32>(16i))) * 569420461u);
                                        let _e756 = ((_e752 ^ (_e752 >> bitcast<u32>(15i))) * 3545902487u);
                                        let _e760 = ((_e756 ^ (_e756 >> bitcast<u32>(15i))) + _e549);
                                        let _e764 = ((_e760 ^ (_e760 >> bitcast<u32>(16i))) * 569420461u);
                                        let _e768 = ((_e764 ^ (_e764 >> bitcast<u32>(15i))) * 3545902487u);
                                        let _e772 = ((_e768 ^ (_e768 >> bitcast<u32>(15i))) + (_e710.member_7 + 1u));
                                        let _e776 = ((_e772 ^ (_e772 >> bitcast<u32>(16i))) * 569420461u);
                                        let _e780 = ((_e776 ^ (_e776 >> bitcast<u32>(15i))) * 3545902487u);
                                        let _e783 = (_e780 ^ (_e780 >> bitcast<u32>(15i)));
                                        let _e785 = (reverseBits((_e113.member_4 % _e745)) + _e783);
                                        let _e787 = (_e785 ^ (_e785 * 1817228412u));
                                        let _e789 = (_e787 ^ (_e787 * 3090095698u));
                                        let _e791 = (_e789 ^ (_e789 * 3350193720u));
                                        let _e794 = reverseBits((_e791 ^ (_e791 * 2367878886u)));
                                        let _e796 = (_e783 ^ 1u);
                                        let _e800 = ((_e796 ^ (_e796 >> bitcast<u32>(16i))) * 569420461u);
                                        let _e804 = ((_e800 ^ (_e800 >> bitcast<u32>(15i))) * 3545902487u);
                                        let _e809 = (reverseBits(reverseBits(_e794)) + (_e804 ^ (_e804 >> bitcast<u32>(15i))));
                                        let _e811 = (_e809 ^ (_e809 * 1817228412u));
                                        let _e813 = (_e811 ^ (_e811 * 3090095698u));
                                        let _e815 = (_e813 ^ (_e813 * 3350193720u));
                                        let _e818 = reverseBits((_e815 ^ (_e815 * 2367878886u)));
                                        phi_1254_ = type_7(0u, 32u);
                                        phi_1257_ = 2147483648u;
                                        phi_1259_ = 0u;
                                        loop {
                                            let _e820 = phi_1254_;
                                            let _e822 = phi_1257_;
                                            let _e824 = phi_1259_;
                                            local_2 = _e824;
                                            if (_e820.member < _e820.member_1) {
                                                phi_1255_ = type_7((_e820.member + 1u), _e820.member_1);
                                                phi_1282_ = type_7(1u, _e820.member);
                                            } else {
                                                phi_1255_ = _e820;
                                                phi_1282_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e837 = phi_1255_;
                                            let _e839 = phi_1282_;
                                            let _e843 = (bitcast<i32>(_e839.member) != 0i);
                                            if _e843 {
                                                if (((_e794 >> bitcast<u32>((_e839.member_1 & 31u))) & 1u) == 1u) {
                                                    phi_1298_ = (_e824 ^ _e822);
                                                } else {
                                                    phi_1298_ = _e824;
                                                }
                                                let _e851 = phi_1298_;
                                                phi_1258_ = (_e822 ^ (_e822 >> bitcast<u32>(1i)));
                                                phi_1260_ = _e851;
                                            } else {
                                                phi_1258_ = u32();
                                                phi_1260_ = u32();
                                            }
                                            let _e856 = phi_1258_;
                                            let _e858 = phi_1260_;
                                            continue;
                                            continuing {
                                                phi_1254_ = _e837;
                                                phi_1257_ = _e856;
                                                phi_1259_ = _e858;
                                                break if !(_e843);
                                            }
                                        }
                                        let _e860 = (_e783 ^ 2u);
                                        let _e864 = ((_e860 ^ (_e860 >> bitcast<u32>(16i))) * 569420461u);
                                        let _e868 = ((_e864 ^ (_e864 >> bitcast<u32>(15i))) * 3545902487u);
                                        let _e873 = local_2;
                                        let _e875 = (reverseBits(_e873) + (_e868 ^ (_e868 >> bitcast<u32>(15i))));
                                        let _e877 = (_e875 ^ (_e875 * 1817228412u));
                                        let _e879 = (_e877 ^ (_e877 * 3090095698u));
                                        let _e881 = (_e879 ^ (_e879 * 3350193720u));
                                        let _e884 = reverseBits((_e881 ^ (_e881 * 2367878886u)));
                                        if (_e710.member_5 == 1u) {
                                            let _e907 = bitcast<i32>(((2u * (_e818 >> bitcast<u32>(16i))) + 1u));
                                            let _e908 = (_e907 - 65536i);
                                            let _e913 = bitcast<i32>(((2u * (_e884 >> bitcast<u32>(16i))) + 1u));
                                            let _e914 = (_e913 - 65536i);
                                            let _e915 = (_e908 < 0i);
                                            if _e915 {
                                                phi_1333_ = (65536i - _e907);
                                            } else {
                                                phi_1333_ = _e908;
                                            }
                                            let _e918 = phi_1333_;
                                            let _e919 = bitcast<u32>(_e918);
                                            let _e920 = (_e914 < 0i);
                                            if _e920 {
                                                phi_1340_ = (65536i - _e913);
                                            } else {
                                                phi_1340_ = _e914;
                                            }
                                            let _e923 = phi_1340_;
                                            let _e924 = bitcast<u32>(_e923);
                                            let _e925 = (_e919 > _e924);
                                            let _e926 = select(_e924, _e919, _e925);
                                            let _e931 = select(1u, _e926, (1u < _e926));
                                            if (_e931 == 0u) {
                                                break;
                                            }
                                            let _e935 = (((select(_e919, _e924, _e925) << bitcast<u32>(16i)) / _e931) << bitcast<u32>(15i));
                                            let _e937 = (_e935 >> bitcast<u32>(16i));
                                            let _e938 = (_e935 & 65535u);
                                            let _e943 = ((_e937 * _e938) + ((_e938 * _e938) >> bitcast<u32>(16i)));
                                            let _e955 = ((((_e937 * _e937) + (_e943 >> bitcast<u32>(16i))) + (((_e938 * _e937) + (_e943 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i));
                                            let _e957 = (_e955 >> bitcast<u32>(16i));
                                            let _e958 = (_e955 & 65535u);
                                            let _e963 = ((_e957 * 7711u) + ((_e958 * 7711u) >> bitcast<u32>(16i)));
                                            let _e972 = (700062u - (((_e963 >> bitcast<u32>(16i)) + ((_e963 & 65535u) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                                            let _e974 = (_e972 >> bitcast<u32>(16i));
                                            let _e975 = (_e972 & 65535u);
                                            let _e980 = ((_e957 * _e975) + ((_e958 * _e975) >> bitcast<u32>(16i)));
                                            let _e993 = (34046945u - ((((_e957 * _e974) + (_e980 >> bitcast<u32>(16i))) + (((_e958 * _e974) + (_e980 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                                            let _e995 = (_e993 >> bitcast<u32>(16i));
                                            let _e996 = (_e993 & 65535u);
                                            let _e1001 = ((_e957 * _e996) + ((_e958 * _e996) >> bitcast<u32>(16i)));
                                            let _e1014 = (662337939u - ((((_e957 * _e995) + (_e1001 >> bitcast<u32>(16i))) + (((_e958 * _e995) + (_e1001 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                                            let _e1019 = ((_e957 * 13011u) + ((_e958 * 13011u) >> bitcast<u32>(16i)));
                                            let _e1030 = (5348082u - (((_e957 + (_e1019 >> bitcast<u32>(16i))) + ((_e958 + (_e1019 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                                            let _e1032 = (_e1030 >> bitcast<u32>(16i));
                                            let _e1033 = (_e1030 & 65535u);
                                            let _e1038 = ((_e957 * _e1033) + ((_e958 * _e1033) >> bitcast<u32>(16i)));
                                            let _e1051 = (173399667u - ((((_e957 * _e1032) + (_e1038 >> bitcast<u32>(16i))) + (((_e958 * _e1032) + (_e1038 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                                            let _e1053 = (_e1051 >> bitcast<u32>(16i));
                                            let _e1054 = (_e1051 & 65535u);
                                            let _e1059 = ((_e957 * _e1054) + ((_e958 * _e1054) >> bitcast<u32>(16i)));
                                            let _e1072 = (1686629713u - ((((_e957 * _e1053) + (_e1059 >> bitcast<u32>(16i))) + (((_e958 * _e1053) + (_e1059 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                                            let _e1074 = (_e1014 >> bitcast<u32>(16i));
                                            let _e1075 = (_e1014 & 65535u);
                                            let _e1080 = ((_e957 * _e1075) + ((_e958 * _e1075) >> bitcast<u32>(16i)));
                                            let _e1093 = (2147483648u - ((((_e957 * _e1074) + (_e1080 >> bitcast<u32>(16i))) + (((_e958 * _e1074) + (_e1080 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                                            let _e1095 = (_e1072 >> bitcast<u32>(16i));
                                            let _e1096 = (_e1072 & 65535u);
                                            let _e1101 = ((_e937 * _e1096) + ((_e938 * _e1096) >> bitcast<u32>(16i)));
                                            let _e1113 = ((((_e937 * _e1095) + (_e1101 >> bitcast<u32>(16i))) + (((_e938 * _e1095) + (_e1101 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i));
                                            let _e1115 = (_e926 << bitcast<u32>(15i));
                                            let _e1117 = (_e1115 >> bitcast<u32>(16i));
                                            let _e1118 = (_e1115 & 65535u);
                                            let _e1120 = (_e1093 >> bitcast<u32>(16i));
                                            let _e1121 = (_e1093 & 65535u);
                                            let _e1126 = ((_e1117 * _e1121) + ((_e1118 * _e1121) >> bitcast<u32>(16i)));
                                            let _e1138 = ((((_e1117 * _e1120) + (_e1126 >> bitcast<u32>(16i))) + (((_e1118 * _e1120) + (_e1126 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i));
                                            let _e1140 = (_e1113 >> bitcast<u32>(16i));
                                            let _e1141 = (_e1113 & 65535u);
                                            let _e1146 = ((_e1117 * _e1141) + ((_e1118 * _e1141) >> bitcast<u32>(16i)));
                                            let _e1158 = ((((_e1117 * _e1140) + (_e1146 >> bitcast<u32>(16i))) + (((_e1118 * _e1140) + (_e1146 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i));
                                            let _e1163 = f32((select(_e1158, _e1138, _e925) >> bitcast<u32>(7i)));
                                            if _e915 {
                                                phi_2393_ = (_e1163 * -0.000000059604645f);
                                            } else {
                                                phi_2393_ = (_e1163 * 0.000000059604645f);
                                            }
                                            let _e1167 = phi_2393_;
                                            let _e1170 = f32((select(_e1138, _e1158, _e925) >> bitcast<u32>(7i)));
                                            if _e920 {
                                                phi_2406_ = (_e1170 * -0.000000059604645f);
                                            } else {
                                                phi_2406_ = (_e1170 * 0.000000059604645f);
                                            }
                                            let _e1174 = phi_2406_;
                                            phi_1575_ = array<f32, 2>(_e1167, _e1174);
                                        } else {
                                            phi_1575_ = array<f32, 2>((f32((bitcast<i32>(((2u * (_e818 >> bitcast<u32>(9i))) + 1u)) - 8388608i)) * 0.00000011920929f), (f32((bitcast<i32>(((2u * (_e884 >> bitcast<u32>(9i))) + 1u)) - 8388608i)) * 0.00000011920929f));
                                        }
                                        let _e1177 = phi_1575_;
                                        phi_1604_ = type_52(array<f32, 3>((_e710.member[0] + ((_e710.member_4[0] * _e1177[0]) + (_e710.member_6[0] * _e1177[1]))), (_e710.member[1] + ((_e710.member_4[1] * _e1177[0]) + (_e710.member_6[1] * _e1177[1]))), (_e710.member[2] + ((_e710.member_4[2] * _e1177[0]) + (_e710.member_6[2] * _e1177[1])))), _e741.member_1, _e741.member_2, _e741.member_3, _e741.member_4, _e741.member_5, _e741.member_6, _e741.member_7, _e741.member_8, _e741.member_9);
                                    } else {
                                        phi_1604_ = _e741;
                                    }
                                    let _e1205 = phi_1604_;
                                    let _e1215 = vec3<f32>(_e1205.member[0], _e1205.member[1], _e1205.member[2]);
                                    let _e1219 = (_e1205.member_1 == 1u);
                                    if _e1219 {
                                        phi_2480_ = (_e1215 - vec3<f32>(_e176, _e180, _e184));
                                    } else {
                                        phi_2480_ = _e1215;
                                    }
                                    let _e1222 = phi_2480_;
                                    let _e1224 = bitcast<f32>(bitcast<u32>(_e325));
                                    let _e1227 = bitcast<f32>(bitcast<u32>((_e314 * _e316)));
                                    let _e1229 = bitcast<f32>(bitcast<u32>(_e319));
                                    let _e1232 = bitcast<f32>(bitcast<u32>((_e315 * _e317)));
                                    let _e1234 = bitcast<f32>(bitcast<u32>(_e322));
                                    let _e1237 = bitcast<f32>(bitcast<u32>((_e313 * _e318)));
                                    let _e1301 = global_12[0u];
                                    if (_e1205.member_2[0] == _e1301) {
                                        let _e1304 = global_12[1u];
                                        let _e1305 = (_e1205.member_2[1] == _e1304);
                                        if _e1305 {
                                            let _e1307 = global_12[2u];
                                            phi_2681_ = (_e1205.member_2[2] == _e1307);
                                        } else {
                                            phi_2681_ = bool();
                                        }
                                        let _e1310 = phi_2681_;
                                        phi_2684_ = _e1310;
                                        phi_2685_ = select(true, false, _e1305);
                                    } else {
                                        phi_2684_ = bool();
                                        phi_2685_ = true;
                                    }
                                    let _e1313 = phi_2684_;
                                    let _e1315 = phi_2685_;
                                    if select(_e1313, false, _e1315) {
                                        phi_2850_ = type_48();
                                        phi_2851_ = true;
                                    } else {
                                        let _e1318 = ((((bitcast<f32>(bitcast<u32>((_e1222.x * (_e1229 - _e1232)))) + bitcast<f32>(bitcast<u32>((_e1222.y * (_e1234 - _e1237))))) + bitcast<f32>(bitcast<u32>((_e1222.z * (_e1224 - _e1227))))) * _e411) > (bitcast<f32>(bitcast<u32>((0.0000009536752f * ((bitcast<f32>(bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1222.x) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e1229) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1232) & 2147483647u)))))) + bitcast<f32>(bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1222.y) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e1234) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1237) & 2147483647u))))))) + bitcast<f32>(bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1222.z) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e1224) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1227) & 2147483647u)))))))))) + 0.0000000000000000000000000000000000001880791f));
                                        if _e1318 {
                                            let _e1320 = select(_e311, _e310, (_e310 > _e311));
                                            let _e1337 = (select(_e312, _e1320, (_e1320 > _e312)) * ((bitcast<f32>((bitcast<u32>(_e415.x) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e415.y) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e415.z) & 2147483647u))));
                                            let _e1341 = (((_e262 + _e265) + _e268) + (_e415.x * _e1337));
                                            let _e1342 = (((_e263 + _e266) + _e269) + (_e415.y * _e1337));
                                            let _e1343 = (((_e264 + _e267) + _e270) + (_e415.z * _e1337));
                                            if (_e415.x > 0f) {
                                                let _e1364 = bitcast<u32>(_e1341);
                                                if ((_e1364 & 2147483647u) == 0u) {
                                                    phi_2958_ = 0.000000000000000000000000000000000000000000001f;
                                                } else {
                                                    if ((_e1364 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_2954_ = bitcast<f32>((_e1364 + 1u));
                                                    } else {
                                                        phi_2954_ = bitcast<f32>((_e1364 - 1u));
                                                    }
                                                    let _e1375 = phi_2954_;
                                                    phi_2958_ = _e1375;
                                                }
                                                let _e1377 = phi_2958_;
                                                phi_2960_ = _e1377;
                                            } else {
                                                if (_e415.x < 0f) {
                                                    let _e1347 = bitcast<u32>(-(_e1341));
                                                    if ((_e1347 & 2147483647u) == 0u) {
                                                        phi_2936_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1347 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_2932_ = bitcast<f32>((_e1347 + 1u));
                                                        } else {
                                                            phi_2932_ = bitcast<f32>((_e1347 - 1u));
                                                        }
                                                        let _e1358 = phi_2932_;
                                                        phi_2936_ = _e1358;
                                                    }
                                                    let _e1360 = phi_2936_;
                                                    phi_2939_ = -(_e1360);
                                                } else {
                                                    phi_2939_ = _e1341;
                                                }
                                                let _e1363 = phi_2939_;
                                                phi_2960_ = _e1363;
                                            }
                                            let _e1379 = phi_2960_;
                                            if (_e415.y > 0f) {
                                                let _e1400 = bitcast<u32>(_e1342);
                                                if ((_e1400 & 2147483647u) == 0u) {
                                                    phi_3009_ = 0.000000000000000000000000000000000000000000001f;
                                                } else {
                                                    if ((_e1400 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_3005_ = bitcast<f32>((_e1400 + 1u));
                                                    } else {
                                                        phi_3005_ = bitcast<f32>((_e1400 - 1u));
                                                    }
                                                    let _e1411 = phi_3005_;
                                                    phi_3009_ = _e1411;
                                                }
                                                let _e1413 = phi_3009_;
                                                phi_3011_ = _e1413;
                                            } else {
                                                if (_e415.y < 0f) {
                                                    let _e1383 = bitcast<u32>(-(_e1342));
                                                    if ((_e1383 & 2147483647u) == 0u) {
                                                        phi_2987_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1383 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_2983_ = bitcast<f32>((_e1383 + 1u));
                                                        } else {
                                                            phi_2983_ = bitcast<f32>((_e1383 - 1u));
                                                        }
                                                        let _e1394 = phi_2983_;
                                                        phi_2987_ = _e1394;
                                                    }
                                                    let _e1396 = phi_2987_;
                                                    phi_2990_ = -(_e1396);
                                                } else {
                                                    phi_2990_ = _e1342;
                                                }
                                                let _e1399 = phi_2990_;
                                                phi_3011_ = _e1399;
                                            }
                                            let _e1415 = phi_3011_;
                                            if (_e415.z > 0f) {
                                                let _e1436 = bitcast<u32>(_e1343);
                                                if ((_e1436 & 2147483647u) == 0u) {
                                                    phi_3060_ = 0.000000000000000000000000000000000000000000001f;
                                                } else {
                                                    if ((_e1436 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_3056_ = bitcast<f32>((_e1436 + 1u));
                                                    } else {
                                                        phi_3056_ = bitcast<f32>((_e1436 - 1u));
                                                    }
                                                    let _e1447 = phi_3056_;
                                                    phi_3060_ = _e1447;
                                                }
                                                let _e1449 = phi_3060_;
                                                phi_3062_ = _e1449;
                                            } else {
                                                if (_e415.z < 0f) {
                                                    let _e1419 = bitcast<u32>(-(_e1343));
                                                    if ((_e1419 & 2147483647u) == 0u) {
                                                        phi_3038_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1419 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_3034_ = bitcast<f32>((_e1419 + 1u));
                                                        } else {
                                                            phi_3034_ = bitcast<f32>((_e1419 - 1u));
                                                        }
                                                        let _e1430 = phi_3034_;
                                                        phi_3038_ = _e1430;
                                                    }
                                                    let _e1432 = phi_3038_;
                                                    phi_3041_ = -(_e1432);
                                                } else {
                                                    phi_3041_ = _e1343;
                                                }
                                                let _e1435 = phi_3041_;
                                                phi_3062_ = _e1435;
                                            }
                                            let _e1451 = phi_3062_;
                                            if _e1219 {
                                                phi_2706_ = (_e1215 - vec3<f32>(_e1379, _e1415, _e1451));
                                            } else {
                                                phi_2706_ = _e1215;
                                            }
                                            let _e1455 = phi_2706_;
                                            let _e1464 = sqrt((((_e1455.x * _e1455.x) + (_e1455.y * _e1455.y)) + (_e1455.z * _e1455.z)));
                                            let _e1473 = ((((_e528.x * _e1455.x) + (_e528.y * _e1455.y)) + (_e528.z * _e1455.z)) / _e1464);
                                            if _e1219 {
                                                phi_2739_ = (_e1464 <= _e1205.member_3);
                                            } else {
                                                phi_2739_ = true;
                                            }
                                            let _e1476 = phi_2739_;
                                            if _e1219 {
                                                phi_2745_ = (1f / (_e1464 * _e1464));
                                            } else {
                                                phi_2745_ = 1f;
                                            }
                                            let _e1480 = phi_2745_;
                                            let _e1481 = -(_e1455.x);
                                            let _e1482 = -(_e1455.y);
                                            let _e1483 = -(_e1455.z);
                                            if (_e1205.member_5 == 0u) {
                                                phi_2784_ = 1f;
                                            } else {
                                                let _e1499 = ((((_e1205.member_8[0] * _e1481) + (_e1205.member_8[1] * _e1482)) + (_e1205.member_8[2] * _e1483)) / sqrt((((_e1481 * _e1481) + (_e1482 * _e1482)) + (_e1483 * _e1483))));
                                                phi_2784_ = select(0f, _e1499, (_e1499 > 0f));
                                            }
                                            let _e1503 = phi_2784_;
                                            if (_e1473 > 0f) {
                                                if _e1476 {
                                                    let _e1505 = (_e1503 > 0f);
                                                    if _e1505 {
                                                        let _e1510 = ((1f - _e540.member_1) * 0.31830987f);
                                                        let _e1518 = ((_e1473 * _e1480) * _e1503);
                                                        phi_2833_ = type_48(type_34(array<f32, 3>(_e1379, _e1415, _e1451), 0f, array<f32, 3>(_e1455.x, _e1455.y, _e1455.z), select(340282350000000000000000000000000000000f, 1f, _e1219)), array<f32, 3>(((_e1205.member_2[0] * (_e540.member[0] * _e1510)) * _e1518), ((_e1205.member_2[1] * (_e540.member[1] * _e1510)) * _e1518), ((_e1205.member_2[2] * (_e540.member[2] * _e1510)) * _e1518)), _e116.member_3);
                                                    } else {
                                                        phi_2833_ = type_48();
                                                    }
                                                    let _e1529 = phi_2833_;
                                                    phi_2836_ = _e1529;
                                                    phi_2837_ = select(true, false, _e1505);
                                                } else {
                                                    phi_2836_ = type_48();
                                                    phi_2837_ = true;
                                                }
                                                let _e1532 = phi_2836_;
                                                let _e1534 = phi_2837_;
                                                phi_2839_ = _e1532;
                                                phi_2840_ = _e1534;
                                            } else {
                                                phi_2839_ = type_48();
                                                phi_2840_ = true;
                                            }
                                            let _e1536 = phi_2839_;
                                            let _e1538 = phi_2840_;
                                            if _e1538 {
                                                phi_2844_ = type_48(type_34(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                                            } else {
                                                phi_2844_ = _e1536;
                                            }
                                            let _e1540 = phi_2844_;
                                            phi_2846_ = _e1540;
                                        } else {
                                            phi_2846_ = type_48();
                                        }
                                        let _e1542 = phi_2846_;
                                        phi_2850_ = _e1542;
                                        phi_2851_ = select(true, false, _e1318);
                                    }
                                    let _e1545 = phi_2850_;
                                    let _e1547 = phi_2851_;
                                    if _e1547 {
                                        phi_2855_ = type_48(type_34(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                                    } else {
                                        phi_2855_ = _e1545;
                                    }
                                    let _e1549 = phi_2855_;
                                    phi_1638_ = _e1549;
                                }
                                let _e1551 = phi_1638_;
                                phi_1639_ = _e1551;
                            } else {
                                phi_1639_ = type_48(type_34(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                            }
                            let _e1553 = phi_1639_;
                            phi_1640_ = _e1553;
                        } else {
                            phi_1640_ = type_48(type_34(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                        }
                        let _e1555 = phi_1640_;
                        if _e110 {
                        } else {
                            break;
                        }
                        global_11.member[_e107] = _e1555;
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
