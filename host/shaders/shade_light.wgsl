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
    var phi_314_: array<u32, 3>;
    var phi_329_: array<f32, 3>;
    var phi_347_: array<f32, 3>;
    var phi_365_: array<f32, 3>;
    var phi_452_: array<u32, 3>;
    var phi_469_: vec3<f32>;
    var phi_486_: vec3<f32>;
    var phi_503_: vec3<f32>;
    var phi_637_: i32;
    var phi_668_: i32;
    var phi_687_: vec3<f32>;
    var phi_770_: i32;
    var phi_801_: i32;
    var phi_820_: vec3<f32>;
    var phi_862_: u32;
    var phi_1069_: type_7;
    var phi_1070_: type_7;
    var phi_1093_: type_7;
    var phi_4139_: bool;
    var phi_1255_: type_7;
    var phi_1258_: u32;
    var phi_1260_: u32;
    var phi_1256_: type_7;
    var phi_1283_: type_7;
    var phi_1299_: u32;
    var phi_1259_: u32;
    var phi_1261_: u32;
    var local_2: u32;
    var phi_1334_: i32;
    var phi_1341_: i32;
    var phi_2446_: f32;
    var phi_2459_: f32;
    var phi_1576_: array<f32, 2>;
    var phi_1605_: type_52;
    var phi_2523_: vec3<f32>;
    var phi_2729_: bool;
    var phi_2732_: bool;
    var phi_2733_: bool;
    var phi_2981_: f32;
    var phi_2985_: f32;
    var phi_2988_: f32;
    var phi_3003_: f32;
    var phi_3007_: f32;
    var phi_3009_: f32;
    var phi_3032_: f32;
    var phi_3036_: f32;
    var phi_3039_: f32;
    var phi_3054_: f32;
    var phi_3058_: f32;
    var phi_3060_: f32;
    var phi_3083_: f32;
    var phi_3087_: f32;
    var phi_3090_: f32;
    var phi_3105_: f32;
    var phi_3109_: f32;
    var phi_3111_: f32;
    var phi_2767_: vec3<f32>;
    var phi_2804_: bool;
    var phi_2810_: f32;
    var phi_2846_: f32;
    var phi_2882_: type_48;
    var phi_2885_: type_48;
    var phi_2886_: bool;
    var phi_2888_: type_48;
    var phi_2889_: bool;
    var phi_2893_: type_48;
    var phi_2895_: type_48;
    var phi_2899_: type_48;
    var phi_2900_: bool;
    var phi_2904_: type_48;
    var phi_3219_: vec3<f32>;
    var phi_3425_: bool;
    var phi_3428_: bool;
    var phi_3429_: bool;
    var phi_3677_: f32;
    var phi_3681_: f32;
    var phi_3684_: f32;
    var phi_3699_: f32;
    var phi_3703_: f32;
    var phi_3705_: f32;
    var phi_3728_: f32;
    var phi_3732_: f32;
    var phi_3735_: f32;
    var phi_3750_: f32;
    var phi_3754_: f32;
    var phi_3756_: f32;
    var phi_3779_: f32;
    var phi_3783_: f32;
    var phi_3786_: f32;
    var phi_3801_: f32;
    var phi_3805_: f32;
    var phi_3807_: f32;
    var phi_3463_: vec3<f32>;
    var phi_3500_: bool;
    var phi_3506_: f32;
    var phi_3542_: f32;
    var phi_3578_: type_48;
    var phi_3581_: type_48;
    var phi_3582_: bool;
    var phi_3584_: type_48;
    var phi_3585_: bool;
    var phi_3589_: type_48;
    var phi_3591_: type_48;
    var phi_3595_: type_48;
    var phi_3596_: bool;
    var phi_3600_: type_48;
    var phi_3885_: f32;
    var phi_3889_: f32;
    var phi_3892_: f32;
    var phi_3907_: f32;
    var phi_3911_: f32;
    var phi_3913_: f32;
    var phi_3936_: f32;
    var phi_3940_: f32;
    var phi_3943_: f32;
    var phi_3958_: f32;
    var phi_3962_: f32;
    var phi_3964_: f32;
    var phi_3987_: f32;
    var phi_3991_: f32;
    var phi_3994_: f32;
    var phi_4009_: f32;
    var phi_4013_: f32;
    var phi_4015_: f32;
    var phi_3139_: vec3<f32>;
    var phi_3156_: type_48;
    var phi_1647_: type_48;
    var phi_1648_: type_48;
    var phi_1649_: type_48;
    var phi_1650_: type_48;

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
                                    phi_1648_ = type_48(type_34(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
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
                                        phi_314_ = _e143;
                                    } else {
                                        phi_314_ = array<u32, 3>(0u, 0u, 0u);
                                    }
                                    let _e145 = phi_314_;
                                    let _e147 = (_e145[0] < _e88);
                                    if _e147 {
                                        if _e147 {
                                        } else {
                                            break;
                                        }
                                        let _e149 = global_4.member[_e145[0]];
                                        phi_329_ = _e149;
                                    } else {
                                        phi_329_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e151 = phi_329_;
                                    let _e156 = (_e145[1] < _e88);
                                    if _e156 {
                                        if _e156 {
                                        } else {
                                            break;
                                        }
                                        let _e158 = global_4.member[_e145[1]];
                                        phi_347_ = _e158;
                                    } else {
                                        phi_347_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e160 = phi_347_;
                                    let _e165 = (_e145[2] < _e88);
                                    if _e165 {
                                        if _e165 {
                                        } else {
                                            break;
                                        }
                                        let _e167 = global_4.member[_e145[2]];
                                        phi_365_ = _e167;
                                    } else {
                                        phi_365_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e169 = phi_365_;
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
                                    let _e209 = vec3<f32>(_e176, _e180, _e184);
                                    if _e141 {
                                        if _e141 {
                                        } else {
                                            break;
                                        }
                                        let _e211 = global_5.member[_e116.member_3];
                                        phi_452_ = _e211;
                                    } else {
                                        phi_452_ = array<u32, 3>(0u, 0u, 0u);
                                    }
                                    let _e213 = phi_452_;
                                    let _e215 = (_e213[0] < _e93);
                                    if _e215 {
                                        if _e215 {
                                        } else {
                                            break;
                                        }
                                        let _e218 = global_6.member[_e213[0]];
                                        phi_469_ = vec3<f32>(_e218[0], _e218[1], _e218[2]);
                                    } else {
                                        phi_469_ = vec3<f32>(0f, 0f, 0f);
                                    }
                                    let _e224 = phi_469_;
                                    let _e226 = (_e213[1] < _e93);
                                    if _e226 {
                                        if _e226 {
                                        } else {
                                            break;
                                        }
                                        let _e229 = global_6.member[_e213[1]];
                                        phi_486_ = vec3<f32>(_e229[0], _e229[1], _e229[2]);
                                    } else {
                                        phi_486_ = vec3<f32>(0f, 0f, 0f);
                                    }
                                    let _e235 = phi_486_;
                                    let _e237 = (_e213[2] < _e93);
                                    if _e237 {
                                        if _e237 {
                                        } else {
                                            break;
                                        }
                                        let _e240 = global_6.member[_e213[2]];
                                        phi_503_ = vec3<f32>(_e240[0], _e240[1], _e240[2]);
                                    } else {
                                        phi_503_ = vec3<f32>(0f, 0f, 0f);
                                    }
                                    let _e246 = phi_503_;
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
                                    let _e274 = ((_e262 + _e265) + _e268);
                                    let _e275 = ((_e263 + _e266) + _e269);
                                    let _e276 = ((_e264 + _e267) + _e270);
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
                                        phi_687_ = vec3<f32>(0f, 0f, 0f);
                                    } else {
                                        let _e343 = (bitcast<u32>(_e340) & 2147483647u);
                                        let _e344 = (_e343 >= 8388608u);
                                        if _e344 {
                                            phi_637_ = (bitcast<i32>((_e343 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_637_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e343)), 32u, (_e343 == 0u))));
                                        }
                                        let _e357 = phi_637_;
                                        let _e364 = bitcast<f32>((bitcast<u32>(((_e357 / -2i) + 127i)) << bitcast<u32>(23i)));
                                        if _e344 {
                                            phi_668_ = (bitcast<i32>((_e343 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_668_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e343)), 32u, (_e343 == 0u))));
                                        }
                                        let _e380 = phi_668_;
                                        let _e386 = bitcast<f32>((bitcast<u32>((((_e357 / 2i) - _e380) + 127i)) << bitcast<u32>(23i)));
                                        let _e387 = ((_e321 * _e364) * _e386);
                                        let _e388 = ((_e324 * _e364) * _e386);
                                        let _e389 = ((_e327 * _e364) * _e386);
                                        let _e395 = sqrt((((_e387 * _e387) + (_e388 * _e388)) + (_e389 * _e389)));
                                        phi_687_ = vec3<f32>((_e387 / _e395), (_e388 / _e395), (_e389 / _e395));
                                    }
                                    let _e401 = phi_687_;
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
                                        phi_820_ = vec3<f32>(0f, 0f, 0f);
                                    } else {
                                        let _e455 = (bitcast<u32>(_e452) & 2147483647u);
                                        let _e456 = (_e455 >= 8388608u);
                                        if _e456 {
                                            phi_770_ = (bitcast<i32>((_e455 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_770_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e455)), 32u, (_e455 == 0u))));
                                        }
                                        let _e469 = phi_770_;
                                        let _e476 = bitcast<f32>((bitcast<u32>(((_e469 / -2i) + 127i)) << bitcast<u32>(23i)));
                                        if _e456 {
                                            phi_801_ = (bitcast<i32>((_e455 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_801_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e455)), 32u, (_e455 == 0u))));
                                        }
                                        let _e492 = phi_801_;
                                        let _e498 = bitcast<f32>((bitcast<u32>((((_e469 / 2i) - _e492) + 127i)) << bitcast<u32>(23i)));
                                        let _e499 = ((_e437 * _e476) * _e498);
                                        let _e500 = ((_e438 * _e476) * _e498);
                                        let _e501 = ((_e439 * _e476) * _e498);
                                        let _e507 = sqrt((((_e499 * _e499) + (_e500 * _e500)) + (_e501 * _e501)));
                                        phi_820_ = vec3<f32>((_e499 / _e507), (_e500 / _e507), (_e501 / _e507));
                                    }
                                    let _e513 = phi_820_;
                                    let _e528 = select(_e415, (_e513 * _e411), vec3((((((_e513.x * _e411) * (_e401.x * _e411)) + ((_e513.y * _e411) * (_e401.y * _e411))) + ((_e513.z * _e411) * (_e401.z * _e411))) > 0f)));
                                    let _e529 = (_e116.member_3 < arrayLength((&global_7.member)));
                                    if _e529 {
                                        if _e529 {
                                        } else {
                                            break;
                                        }
                                        let _e532 = global_7.member[_e116.member_3];
                                        phi_862_ = _e532;
                                    } else {
                                        phi_862_ = 0u;
                                    }
                                    let _e534 = phi_862_;
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
                                        phi_1069_ = type_7(0u, 3u);
                                        loop {
                                            let _e666 = phi_1069_;
                                            if (_e666.member < _e666.member_1) {
                                                phi_1070_ = type_7((_e666.member + 1u), _e666.member_1);
                                                phi_1093_ = type_7(1u, _e666.member);
                                            } else {
                                                phi_1070_ = _e666;
                                                phi_1093_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e679 = phi_1070_;
                                            let _e681 = phi_1093_;
                                            let _e685 = (bitcast<i32>(_e681.member) != 0i);
                                            if _e685 {
                                                let _e686 = (_e681.member_1 < 3u);
                                                if _e686 {
                                                } else {
                                                    phi_4139_ = true;
                                                    break;
                                                }
                                                let _e689 = local_1.member_2[_e681.member_1];
                                                let _e693 = ((((_e689 * _e134) * _e140) * _e134) * _e140);
                                                if _e686 {
                                                } else {
                                                    phi_4139_ = true;
                                                    break;
                                                }
                                                local.member_2[_e681.member_1] = select(340282350000000000000000000000000000000f, _e693, (_e693 < 340282350000000000000000000000000000000f));
                                            }
                                            continue;
                                            continuing {
                                                phi_1069_ = _e679;
                                                phi_4139_ = false;
                                                break if !(_e685);
                                            }
                                        }
                                        let _e700 = phi_4139_;
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
                                        phi_1255_ = type_7(0u, 32u);
                                        phi_1258_ = 2147483648u;
                                        phi_1260_ = 0u;
                                        loop {
                                            let _e820 = phi_1255_;
                                            let _e822 = phi_1258_;
                                            let _e824 = phi_1260_;
                                            local_2 = _e824;
                                            if (_e820.member < _e820.member_1) {
                                                phi_1256_ = type_7((_e820.member + 1u), _e820.member_1);
                                                phi_1283_ = type_7(1u, _e820.member);
                                            } else {
                                                phi_1256_ = _e820;
                                                phi_1283_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e837 = phi_1256_;
                                            let _e839 = phi_1283_;
                                            let _e843 = (bitcast<i32>(_e839.member) != 0i);
                                            if _e843 {
                                                if (((_e794 >> bitcast<u32>((_e839.member_1 & 31u))) & 1u) == 1u) {
                                                    phi_1299_ = (_e824 ^ _e822);
                                                } else {
                                                    phi_1299_ = _e824;
                                                }
                                                let _e851 = phi_1299_;
                                                phi_1259_ = (_e822 ^ (_e822 >> bitcast<u32>(1i)));
                                                phi_1261_ = _e851;
                                            } else {
                                                phi_1259_ = u32();
                                                phi_1261_ = u32();
                                            }
                                            let _e856 = phi_1259_;
                                            let _e858 = phi_1261_;
                                            continue;
                                            continuing {
                                                phi_1255_ = _e837;
                                                phi_1258_ = _e856;
                                                phi_1260_ = _e858;
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
                                                phi_1334_ = (65536i - _e907);
                                            } else {
                                                phi_1334_ = _e908;
                                            }
                                            let _e918 = phi_1334_;
                                            let _e919 = bitcast<u32>(_e918);
                                            let _e920 = (_e914 < 0i);
                                            if _e920 {
                                                phi_1341_ = (65536i - _e913);
                                            } else {
                                                phi_1341_ = _e914;
                                            }
                                            let _e923 = phi_1341_;
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
                                                phi_2446_ = (_e1163 * -0.000000059604645f);
                                            } else {
                                                phi_2446_ = (_e1163 * 0.000000059604645f);
                                            }
                                            let _e1167 = phi_2446_;
                                            let _e1170 = f32((select(_e1138, _e1158, _e925) >> bitcast<u32>(7i)));
                                            if _e920 {
                                                phi_2459_ = (_e1170 * -0.000000059604645f);
                                            } else {
                                                phi_2459_ = (_e1170 * 0.000000059604645f);
                                            }
                                            let _e1174 = phi_2459_;
                                            phi_1576_ = array<f32, 2>(_e1167, _e1174);
                                        } else {
                                            phi_1576_ = array<f32, 2>((f32((bitcast<i32>(((2u * (_e818 >> bitcast<u32>(9i))) + 1u)) - 8388608i)) * 0.00000011920929f), (f32((bitcast<i32>(((2u * (_e884 >> bitcast<u32>(9i))) + 1u)) - 8388608i)) * 0.00000011920929f));
                                        }
                                        let _e1177 = phi_1576_;
                                        phi_1605_ = type_52(array<f32, 3>((_e710.member[0] + ((_e710.member_4[0] * _e1177[0]) + (_e710.member_6[0] * _e1177[1]))), (_e710.member[1] + ((_e710.member_4[1] * _e1177[0]) + (_e710.member_6[1] * _e1177[1]))), (_e710.member[2] + ((_e710.member_4[2] * _e1177[0]) + (_e710.member_6[2] * _e1177[1])))), _e741.member_1, _e741.member_2, _e741.member_3, _e741.member_4, _e741.member_5, _e741.member_6, _e741.member_7, _e741.member_8, _e741.member_9);
                                    } else {
                                        phi_1605_ = _e741;
                                    }
                                    let _e1205 = phi_1605_;
                                    let _e1214 = global_3.member[2u];
                                    if (_e1214 == 1u) {
                                        let _e1565 = (_e1205.member_1 == 1u);
                                        if _e1565 {
                                            phi_3219_ = (vec3<f32>(_e1205.member[0], _e1205.member[1], _e1205.member[2]) - _e209);
                                        } else {
                                            phi_3219_ = vec3<f32>(_e1205.member[0], _e1205.member[1], _e1205.member[2]);
                                        }
                                        let _e1576 = phi_3219_;
                                        let _e1578 = bitcast<f32>(bitcast<u32>(_e325));
                                        let _e1581 = bitcast<f32>(bitcast<u32>((_e314 * _e316)));
                                        let _e1583 = bitcast<f32>(bitcast<u32>(_e319));
                                        let _e1586 = bitcast<f32>(bitcast<u32>((_e315 * _e317)));
                                        let _e1588 = bitcast<f32>(bitcast<u32>(_e322));
                                        let _e1591 = bitcast<f32>(bitcast<u32>((_e313 * _e318)));
                                        let _e1655 = global_12[0u];
                                        if (_e1205.member_2[0] == _e1655) {
                                            let _e1658 = global_12[1u];
                                            let _e1659 = (_e1205.member_2[1] == _e1658);
                                            if _e1659 {
                                                let _e1661 = global_12[2u];
                                                phi_3425_ = (_e1205.member_2[2] == _e1661);
                                            } else {
                                                phi_3425_ = bool();
                                            }
                                            let _e1664 = phi_3425_;
                                            phi_3428_ = _e1664;
                                            phi_3429_ = select(true, false, _e1659);
                                        } else {
                                            phi_3428_ = bool();
                                            phi_3429_ = true;
                                        }
                                        let _e1667 = phi_3428_;
                                        let _e1669 = phi_3429_;
                                        if select(_e1667, false, _e1669) {
                                            phi_3595_ = type_48();
                                            phi_3596_ = true;
                                        } else {
                                            let _e1672 = ((((bitcast<f32>(bitcast<u32>((_e1576.x * (_e1583 - _e1586)))) + bitcast<f32>(bitcast<u32>((_e1576.y * (_e1588 - _e1591))))) + bitcast<f32>(bitcast<u32>((_e1576.z * (_e1578 - _e1581))))) * _e411) > (bitcast<f32>(bitcast<u32>((0.0000009536752f * ((bitcast<f32>(bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1576.x) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e1583) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1586) & 2147483647u)))))) + bitcast<f32>(bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1576.y) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e1588) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1591) & 2147483647u))))))) + bitcast<f32>(bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1576.z) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e1578) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1581) & 2147483647u)))))))))) + 0.0000000000000000000000000000000000001880791f));
                                            if _e1672 {
                                                let _e1674 = select(_e311, _e310, (_e310 > _e311));
                                                let _e1691 = (select(_e312, _e1674, (_e1674 > _e312)) * ((bitcast<f32>((bitcast<u32>(_e415.x) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e415.y) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e415.z) & 2147483647u))));
                                                let _e1695 = (_e274 + (_e415.x * _e1691));
                                                let _e1696 = (_e275 + (_e415.y * _e1691));
                                                let _e1697 = (_e276 + (_e415.z * _e1691));
                                                if (_e415.x > 0f) {
                                                    let _e1718 = bitcast<u32>(_e1695);
                                                    if ((_e1718 & 2147483647u) == 0u) {
                                                        phi_3703_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1718 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_3699_ = bitcast<f32>((_e1718 + 1u));
                                                        } else {
                                                            phi_3699_ = bitcast<f32>((_e1718 - 1u));
                                                        }
                                                        let _e1729 = phi_3699_;
                                                        phi_3703_ = _e1729;
                                                    }
                                                    let _e1731 = phi_3703_;
                                                    phi_3705_ = _e1731;
                                                } else {
                                                    if (_e415.x < 0f) {
                                                        let _e1701 = bitcast<u32>(-(_e1695));
                                                        if ((_e1701 & 2147483647u) == 0u) {
                                                            phi_3681_ = 0.000000000000000000000000000000000000000000001f;
                                                        } else {
                                                            if ((_e1701 >> bitcast<u32>(31i)) == 0u) {
                                                                phi_3677_ = bitcast<f32>((_e1701 + 1u));
                                                            } else {
                                                                phi_3677_ = bitcast<f32>((_e1701 - 1u));
                                                            }
                                                            let _e1712 = phi_3677_;
                                                            phi_3681_ = _e1712;
                                                        }
                                                        let _e1714 = phi_3681_;
                                                        phi_3684_ = -(_e1714);
                                                    } else {
                                                        phi_3684_ = _e1695;
                                                    }
                                                    let _e1717 = phi_3684_;
                                                    phi_3705_ = _e1717;
                                                }
                                                let _e1733 = phi_3705_;
                                                if (_e415.y > 0f) {
                                                    let _e1754 = bitcast<u32>(_e1696);
                                                    if ((_e1754 & 2147483647u) == 0u) {
                                                        phi_3754_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1754 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_3750_ = bitcast<f32>((_e1754 + 1u));
                                                        } else {
                                                            phi_3750_ = bitcast<f32>((_e1754 - 1u));
                                                        }
                                                        let _e1765 = phi_3750_;
                                                        phi_3754_ = _e1765;
                                                    }
                                                    let _e1767 = phi_3754_;
                                                    phi_3756_ = _e1767;
                                                } else {
                                                    if (_e415.y < 0f) {
                                                        let _e1737 = bitcast<u32>(-(_e1696));
                                                        if ((_e1737 & 2147483647u) == 0u) {
                                                            phi_3732_ = 0.000000000000000000000000000000000000000000001f;
                                                        } else {
                                                            if ((_e1737 >> bitcast<u32>(31i)) == 0u) {
                                                                phi_3728_ = bitcast<f32>((_e1737 + 1u));
                                                            } else {
                                                                phi_3728_ = bitcast<f32>((_e1737 - 1u));
                                                            }
                                                            let _e1748 = phi_3728_;
                                                            phi_3732_ = _e1748;
                                                        }
                                                        let _e1750 = phi_3732_;
                                                        phi_3735_ = -(_e1750);
                                                    } else {
                                                        phi_3735_ = _e1696;
                                                    }
                                                    let _e1753 = phi_3735_;
                                                    phi_3756_ = _e1753;
                                                }
                                                let _e1769 = phi_3756_;
                                                if (_e415.z > 0f) {
                                                    let _e1790 = bitcast<u32>(_e1697);
                                                    if ((_e1790 & 2147483647u) == 0u) {
                                                        phi_3805_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1790 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_3801_ = bitcast<f32>((_e1790 + 1u));
                                                        } else {
                                                            phi_3801_ = bitcast<f32>((_e1790 - 1u));
                                                        }
                                                        let _e1801 = phi_3801_;
                                                        phi_3805_ = _e1801;
                                                    }
                                                    let _e1803 = phi_3805_;
                                                    phi_3807_ = _e1803;
                                                } else {
                                                    if (_e415.z < 0f) {
                                                        let _e1773 = bitcast<u32>(-(_e1697));
                                                        if ((_e1773 & 2147483647u) == 0u) {
                                                            phi_3783_ = 0.000000000000000000000000000000000000000000001f;
                                                        } else {
                                                            if ((_e1773 >> bitcast<u32>(31i)) == 0u) {
                                                                phi_3779_ = bitcast<f32>((_e1773 + 1u));
                                                            } else {
                                                                phi_3779_ = bitcast<f32>((_e1773 - 1u));
                                                            }
                                                            let _e1784 = phi_3779_;
                                                            phi_3783_ = _e1784;
                                                        }
                                                        let _e1786 = phi_3783_;
                                                        phi_3786_ = -(_e1786);
                                                    } else {
                                                        phi_3786_ = _e1697;
                                                    }
                                                    let _e1789 = phi_3786_;
                                                    phi_3807_ = _e1789;
                                                }
                                                let _e1805 = phi_3807_;
                                                let _e1810 = vec3<f32>(_e1205.member[0], _e1205.member[1], _e1205.member[2]);
                                                if _e1565 {
                                                    phi_3463_ = (_e1810 - vec3<f32>(_e1733, _e1769, _e1805));
                                                } else {
                                                    phi_3463_ = _e1810;
                                                }
                                                let _e1813 = phi_3463_;
                                                let _e1826 = sqrt((((_e1813.x * _e1813.x) + (_e1813.y * _e1813.y)) + (_e1813.z * _e1813.z)));
                                                let _e1835 = ((((_e528.x * _e1813.x) + (_e528.y * _e1813.y)) + (_e528.z * _e1813.z)) / _e1826);
                                                if _e1565 {
                                                    phi_3500_ = (_e1826 <= _e1205.member_3);
                                                } else {
                                                    phi_3500_ = true;
                                                }
                                                let _e1838 = phi_3500_;
                                                if _e1565 {
                                                    phi_3506_ = (1f / (_e1826 * _e1826));
                                                } else {
                                                    phi_3506_ = 1f;
                                                }
                                                let _e1842 = phi_3506_;
                                                let _e1843 = -(_e1813.x);
                                                let _e1844 = -(_e1813.y);
                                                let _e1845 = -(_e1813.z);
                                                if (_e1205.member_5 == 0u) {
                                                    phi_3542_ = 1f;
                                                } else {
                                                    let _e1861 = ((((_e1205.member_8[0] * _e1843) + (_e1205.member_8[1] * _e1844)) + (_e1205.member_8[2] * _e1845)) / sqrt((((_e1843 * _e1843) + (_e1844 * _e1844)) + (_e1845 * _e1845))));
                                                    phi_3542_ = select(0f, _e1861, (_e1861 > 0f));
                                                }
                                                let _e1865 = phi_3542_;
                                                if (_e1835 > 0f) {
                                                    if _e1838 {
                                                        let _e1867 = (_e1865 > 0f);
                                                        if _e1867 {
                                                            let _e1872 = ((1f - _e540.member_1) * 0.31830987f);
                                                            let _e1880 = ((_e1835 * _e1842) * _e1865);
                                                            phi_3578_ = type_48(type_34(array<f32, 3>(_e1733, _e1769, _e1805), 0f, array<f32, 3>(_e1813.x, _e1813.y, _e1813.z), select(340282350000000000000000000000000000000f, 1f, _e1565)), array<f32, 3>(((_e1205.member_2[0] * (_e540.member[0] * _e1872)) * _e1880), ((_e1205.member_2[1] * (_e540.member[1] * _e1872)) * _e1880), ((_e1205.member_2[2] * (_e540.member[2] * _e1872)) * _e1880)), _e116.member_3);
                                                        } else {
                                                            phi_3578_ = type_48();
                                                        }
                                                        let _e1887 = phi_3578_;
                                                        phi_3581_ = _e1887;
                                                        phi_3582_ = select(true, false, _e1867);
                                                    } else {
                                                        phi_3581_ = type_48();
                                                        phi_3582_ = true;
                                                    }
                                                    let _e1890 = phi_3581_;
                                                    let _e1892 = phi_3582_;
                                                    phi_3584_ = _e1890;
                                                    phi_3585_ = _e1892;
                                                } else {
                                                    phi_3584_ = type_48();
                                                    phi_3585_ = true;
                                                }
                                                let _e1894 = phi_3584_;
                                                let _e1896 = phi_3585_;
                                                if _e1896 {
                                                    phi_3589_ = type_48(type_34(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                                                } else {
                                                    phi_3589_ = _e1894;
                                                }
                                                let _e1898 = phi_3589_;
                                                phi_3591_ = _e1898;
                                            } else {
                                                phi_3591_ = type_48();
                                            }
                                            let _e1900 = phi_3591_;
                                            phi_3595_ = _e1900;
                                            phi_3596_ = select(true, false, _e1672);
                                        }
                                        let _e1903 = phi_3595_;
                                        let _e1905 = phi_3596_;
                                        if _e1905 {
                                            phi_3600_ = type_48(type_34(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                                        } else {
                                            phi_3600_ = _e1903;
                                        }
                                        let _e1907 = phi_3600_;
                                        if (_e1907.member.member_1 <= _e1907.member.member_3) {
                                            phi_3156_ = _e1907;
                                        } else {
                                            let _e1914 = select(_e311, _e310, (_e310 > _e311));
                                            let _e1931 = (select(_e312, _e1914, (_e1914 > _e312)) * ((bitcast<f32>((bitcast<u32>(_e415.x) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e415.y) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e415.z) & 2147483647u))));
                                            let _e1935 = (_e274 + (_e415.x * _e1931));
                                            let _e1936 = (_e275 + (_e415.y * _e1931));
                                            let _e1937 = (_e276 + (_e415.z * _e1931));
                                            if (_e415.x > 0f) {
                                                let _e1958 = bitcast<u32>(_e1935);
                                                if ((_e1958 & 2147483647u) == 0u) {
                                                    phi_3911_ = 0.000000000000000000000000000000000000000000001f;
                                                } else {
                                                    if ((_e1958 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_3907_ = bitcast<f32>((_e1958 + 1u));
                                                    } else {
                                                        phi_3907_ = bitcast<f32>((_e1958 - 1u));
                                                    }
                                                    let _e1969 = phi_3907_;
                                                    phi_3911_ = _e1969;
                                                }
                                                let _e1971 = phi_3911_;
                                                phi_3913_ = _e1971;
                                            } else {
                                                if (_e415.x < 0f) {
                                                    let _e1941 = bitcast<u32>(-(_e1935));
                                                    if ((_e1941 & 2147483647u) == 0u) {
                                                        phi_3889_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1941 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_3885_ = bitcast<f32>((_e1941 + 1u));
                                                        } else {
                                                            phi_3885_ = bitcast<f32>((_e1941 - 1u));
                                                        }
                                                        let _e1952 = phi_3885_;
                                                        phi_3889_ = _e1952;
                                                    }
                                                    let _e1954 = phi_3889_;
                                                    phi_3892_ = -(_e1954);
                                                } else {
                                                    phi_3892_ = _e1935;
                                                }
                                                let _e1957 = phi_3892_;
                                                phi_3913_ = _e1957;
                                            }
                                            let _e1973 = phi_3913_;
                                            if (_e415.y > 0f) {
                                                let _e1994 = bitcast<u32>(_e1936);
                                                if ((_e1994 & 2147483647u) == 0u) {
                                                    phi_3962_ = 0.000000000000000000000000000000000000000000001f;
                                                } else {
                                                    if ((_e1994 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_3958_ = bitcast<f32>((_e1994 + 1u));
                                                    } else {
                                                        phi_3958_ = bitcast<f32>((_e1994 - 1u));
                                                    }
                                                    let _e2005 = phi_3958_;
                                                    phi_3962_ = _e2005;
                                                }
                                                let _e2007 = phi_3962_;
                                                phi_3964_ = _e2007;
                                            } else {
                                                if (_e415.y < 0f) {
                                                    let _e1977 = bitcast<u32>(-(_e1936));
                                                    if ((_e1977 & 2147483647u) == 0u) {
                                                        phi_3940_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1977 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_3936_ = bitcast<f32>((_e1977 + 1u));
                                                        } else {
                                                            phi_3936_ = bitcast<f32>((_e1977 - 1u));
                                                        }
                                                        let _e1988 = phi_3936_;
                                                        phi_3940_ = _e1988;
                                                    }
                                                    let _e1990 = phi_3940_;
                                                    phi_3943_ = -(_e1990);
                                                } else {
                                                    phi_3943_ = _e1936;
                                                }
                                                let _e1993 = phi_3943_;
                                                phi_3964_ = _e1993;
                                            }
                                            let _e2009 = phi_3964_;
                                            if (_e415.z > 0f) {
                                                let _e2030 = bitcast<u32>(_e1937);
                                                if ((_e2030 & 2147483647u) == 0u) {
                                                    phi_4013_ = 0.000000000000000000000000000000000000000000001f;
                                                } else {
                                                    if ((_e2030 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_4009_ = bitcast<f32>((_e2030 + 1u));
                                                    } else {
                                                        phi_4009_ = bitcast<f32>((_e2030 - 1u));
                                                    }
                                                    let _e2041 = phi_4009_;
                                                    phi_4013_ = _e2041;
                                                }
                                                let _e2043 = phi_4013_;
                                                phi_4015_ = _e2043;
                                            } else {
                                                if (_e415.z < 0f) {
                                                    let _e2013 = bitcast<u32>(-(_e1937));
                                                    if ((_e2013 & 2147483647u) == 0u) {
                                                        phi_3991_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e2013 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_3987_ = bitcast<f32>((_e2013 + 1u));
                                                        } else {
                                                            phi_3987_ = bitcast<f32>((_e2013 - 1u));
                                                        }
                                                        let _e2024 = phi_3987_;
                                                        phi_3991_ = _e2024;
                                                    }
                                                    let _e2026 = phi_3991_;
                                                    phi_3994_ = -(_e2026);
                                                } else {
                                                    phi_3994_ = _e1937;
                                                }
                                                let _e2029 = phi_3994_;
                                                phi_4015_ = _e2029;
                                            }
                                            let _e2045 = phi_4015_;
                                            let _e2050 = vec3<f32>(_e1205.member[0], _e1205.member[1], _e1205.member[2]);
                                            if _e1565 {
                                                phi_3139_ = (_e2050 - vec3<f32>(_e1973, _e2009, _e2045));
                                            } else {
                                                phi_3139_ = _e2050;
                                            }
                                            let _e2053 = phi_3139_;
                                            phi_3156_ = type_48(type_34(array<f32, 3>(_e1973, _e2009, _e2045), 0f, array<f32, 3>(_e2053.x, _e2053.y, _e2053.z), select(340282350000000000000000000000000000000f, 1f, _e1565)), array<f32, 3>(0f, 0f, 0f), _e116.member_3);
                                        }
                                        let _e2063 = phi_3156_;
                                        phi_1647_ = _e2063;
                                    } else {
                                        let _e1219 = (_e1205.member_1 == 1u);
                                        if _e1219 {
                                            phi_2523_ = (vec3<f32>(_e1205.member[0], _e1205.member[1], _e1205.member[2]) - _e209);
                                        } else {
                                            phi_2523_ = vec3<f32>(_e1205.member[0], _e1205.member[1], _e1205.member[2]);
                                        }
                                        let _e1230 = phi_2523_;
                                        let _e1232 = bitcast<f32>(bitcast<u32>(_e325));
                                        let _e1235 = bitcast<f32>(bitcast<u32>((_e314 * _e316)));
                                        let _e1237 = bitcast<f32>(bitcast<u32>(_e319));
                                        let _e1240 = bitcast<f32>(bitcast<u32>((_e315 * _e317)));
                                        let _e1242 = bitcast<f32>(bitcast<u32>(_e322));
                                        let _e1245 = bitcast<f32>(bitcast<u32>((_e313 * _e318)));
                                        let _e1309 = global_12[0u];
                                        if (_e1205.member_2[0] == _e1309) {
                                            let _e1312 = global_12[1u];
                                            let _e1313 = (_e1205.member_2[1] == _e1312);
                                            if _e1313 {
                                                let _e1315 = global_12[2u];
                                                phi_2729_ = (_e1205.member_2[2] == _e1315);
                                            } else {
                                                phi_2729_ = bool();
                                            }
                                            let _e1318 = phi_2729_;
                                            phi_2732_ = _e1318;
                                            phi_2733_ = select(true, false, _e1313);
                                        } else {
                                            phi_2732_ = bool();
                                            phi_2733_ = true;
                                        }
                                        let _e1321 = phi_2732_;
                                        let _e1323 = phi_2733_;
                                        if select(_e1321, false, _e1323) {
                                            phi_2899_ = type_48();
                                            phi_2900_ = true;
                                        } else {
                                            let _e1326 = ((((bitcast<f32>(bitcast<u32>((_e1230.x * (_e1237 - _e1240)))) + bitcast<f32>(bitcast<u32>((_e1230.y * (_e1242 - _e1245))))) + bitcast<f32>(bitcast<u32>((_e1230.z * (_e1232 - _e1235))))) * _e411) > (bitcast<f32>(bitcast<u32>((0.0000009536752f * ((bitcast<f32>(bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1230.x) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e1237) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1240) & 2147483647u)))))) + bitcast<f32>(bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1230.y) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e1242) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1245) & 2147483647u))))))) + bitcast<f32>(bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1230.z) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e1232) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1235) & 2147483647u)))))))))) + 0.0000000000000000000000000000000000001880791f));
                                            if _e1326 {
                                                let _e1328 = select(_e311, _e310, (_e310 > _e311));
                                                let _e1345 = (select(_e312, _e1328, (_e1328 > _e312)) * ((bitcast<f32>((bitcast<u32>(_e415.x) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e415.y) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e415.z) & 2147483647u))));
                                                let _e1349 = (_e274 + (_e415.x * _e1345));
                                                let _e1350 = (_e275 + (_e415.y * _e1345));
                                                let _e1351 = (_e276 + (_e415.z * _e1345));
                                                if (_e415.x > 0f) {
                                                    let _e1372 = bitcast<u32>(_e1349);
                                                    if ((_e1372 & 2147483647u) == 0u) {
                                                        phi_3007_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1372 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_3003_ = bitcast<f32>((_e1372 + 1u));
                                                        } else {
                                                            phi_3003_ = bitcast<f32>((_e1372 - 1u));
                                                        }
                                                        let _e1383 = phi_3003_;
                                                        phi_3007_ = _e1383;
                                                    }
                                                    let _e1385 = phi_3007_;
                                                    phi_3009_ = _e1385;
                                                } else {
                                                    if (_e415.x < 0f) {
                                                        let _e1355 = bitcast<u32>(-(_e1349));
                                                        if ((_e1355 & 2147483647u) == 0u) {
                                                            phi_2985_ = 0.000000000000000000000000000000000000000000001f;
                                                        } else {
                                                            if ((_e1355 >> bitcast<u32>(31i)) == 0u) {
                                                                phi_2981_ = bitcast<f32>((_e1355 + 1u));
                                                            } else {
                                                                phi_2981_ = bitcast<f32>((_e1355 - 1u));
                                                            }
                                                            let _e1366 = phi_2981_;
                                                            phi_2985_ = _e1366;
                                                        }
                                                        let _e1368 = phi_2985_;
                                                        phi_2988_ = -(_e1368);
                                                    } else {
                                                        phi_2988_ = _e1349;
                                                    }
                                                    let _e1371 = phi_2988_;
                                                    phi_3009_ = _e1371;
                                                }
                                                let _e1387 = phi_3009_;
                                                if (_e415.y > 0f) {
                                                    let _e1408 = bitcast<u32>(_e1350);
                                                    if ((_e1408 & 2147483647u) == 0u) {
                                                        phi_3058_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1408 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_3054_ = bitcast<f32>((_e1408 + 1u));
                                                        } else {
                                                            phi_3054_ = bitcast<f32>((_e1408 - 1u));
                                                        }
                                                        let _e1419 = phi_3054_;
                                                        phi_3058_ = _e1419;
                                                    }
                                                    let _e1421 = phi_3058_;
                                                    phi_3060_ = _e1421;
                                                } else {
                                                    if (_e415.y < 0f) {
                                                        let _e1391 = bitcast<u32>(-(_e1350));
                                                        if ((_e1391 & 2147483647u) == 0u) {
                                                            phi_3036_ = 0.000000000000000000000000000000000000000000001f;
                                                        } else {
                                                            if ((_e1391 >> bitcast<u32>(31i)) == 0u) {
                                                                phi_3032_ = bitcast<f32>((_e1391 + 1u));
                                                            } else {
                                                                phi_3032_ = bitcast<f32>((_e1391 - 1u));
                                                            }
                                                            let _e1402 = phi_3032_;
                                                            phi_3036_ = _e1402;
                                                        }
                                                        let _e1404 = phi_3036_;
                                                        phi_3039_ = -(_e1404);
                                                    } else {
                                                        phi_3039_ = _e1350;
                                                    }
                                                    let _e1407 = phi_3039_;
                                                    phi_3060_ = _e1407;
                                                }
                                                let _e1423 = phi_3060_;
                                                if (_e415.z > 0f) {
                                                    let _e1444 = bitcast<u32>(_e1351);
                                                    if ((_e1444 & 2147483647u) == 0u) {
                                                        phi_3109_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1444 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_3105_ = bitcast<f32>((_e1444 + 1u));
                                                        } else {
                                                            phi_3105_ = bitcast<f32>((_e1444 - 1u));
                                                        }
                                                        let _e1455 = phi_3105_;
                                                        phi_3109_ = _e1455;
                                                    }
                                                    let _e1457 = phi_3109_;
                                                    phi_3111_ = _e1457;
                                                } else {
                                                    if (_e415.z < 0f) {
                                                        let _e1427 = bitcast<u32>(-(_e1351));
                                                        if ((_e1427 & 2147483647u) == 0u) {
                                                            phi_3087_ = 0.000000000000000000000000000000000000000000001f;
                                                        } else {
                                                            if ((_e1427 >> bitcast<u32>(31i)) == 0u) {
                                                                phi_3083_ = bitcast<f32>((_e1427 + 1u));
                                                            } else {
                                                                phi_3083_ = bitcast<f32>((_e1427 - 1u));
                                                            }
                                                            let _e1438 = phi_3083_;
                                                            phi_3087_ = _e1438;
                                                        }
                                                        let _e1440 = phi_3087_;
                                                        phi_3090_ = -(_e1440);
                                                    } else {
                                                        phi_3090_ = _e1351;
                                                    }
                                                    let _e1443 = phi_3090_;
                                                    phi_3111_ = _e1443;
                                                }
                                                let _e1459 = phi_3111_;
                                                let _e1464 = vec3<f32>(_e1205.member[0], _e1205.member[1], _e1205.member[2]);
                                                if _e1219 {
                                                    phi_2767_ = (_e1464 - vec3<f32>(_e1387, _e1423, _e1459));
                                                } else {
                                                    phi_2767_ = _e1464;
                                                }
                                                let _e1467 = phi_2767_;
                                                let _e1480 = sqrt((((_e1467.x * _e1467.x) + (_e1467.y * _e1467.y)) + (_e1467.z * _e1467.z)));
                                                let _e1489 = ((((_e528.x * _e1467.x) + (_e528.y * _e1467.y)) + (_e528.z * _e1467.z)) / _e1480);
                                                if _e1219 {
                                                    phi_2804_ = (_e1480 <= _e1205.member_3);
                                                } else {
                                                    phi_2804_ = true;
                                                }
                                                let _e1492 = phi_2804_;
                                                if _e1219 {
                                                    phi_2810_ = (1f / (_e1480 * _e1480));
                                                } else {
                                                    phi_2810_ = 1f;
                                                }
                                                let _e1496 = phi_2810_;
                                                let _e1497 = -(_e1467.x);
                                                let _e1498 = -(_e1467.y);
                                                let _e1499 = -(_e1467.z);
                                                if (_e1205.member_5 == 0u) {
                                                    phi_2846_ = 1f;
                                                } else {
                                                    let _e1515 = ((((_e1205.member_8[0] * _e1497) + (_e1205.member_8[1] * _e1498)) + (_e1205.member_8[2] * _e1499)) / sqrt((((_e1497 * _e1497) + (_e1498 * _e1498)) + (_e1499 * _e1499))));
                                                    phi_2846_ = select(0f, _e1515, (_e1515 > 0f));
                                                }
                                                let _e1519 = phi_2846_;
                                                if (_e1489 > 0f) {
                                                    if _e1492 {
                                                        let _e1521 = (_e1519 > 0f);
                                                        if _e1521 {
                                                            let _e1526 = ((1f - _e540.member_1) * 0.31830987f);
                                                            let _e1534 = ((_e1489 * _e1496) * _e1519);
                                                            phi_2882_ = type_48(type_34(array<f32, 3>(_e1387, _e1423, _e1459), 0f, array<f32, 3>(_e1467.x, _e1467.y, _e1467.z), select(340282350000000000000000000000000000000f, 1f, _e1219)), array<f32, 3>(((_e1205.member_2[0] * (_e540.member[0] * _e1526)) * _e1534), ((_e1205.member_2[1] * (_e540.member[1] * _e1526)) * _e1534), ((_e1205.member_2[2] * (_e540.member[2] * _e1526)) * _e1534)), _e116.member_3);
                                                        } else {
                                                            phi_2882_ = type_48();
                                                        }
                                                        let _e1541 = phi_2882_;
                                                        phi_2885_ = _e1541;
                                                        phi_2886_ = select(true, false, _e1521);
                                                    } else {
                                                        phi_2885_ = type_48();
                                                        phi_2886_ = true;
                                                    }
                                                    let _e1544 = phi_2885_;
                                                    let _e1546 = phi_2886_;
                                                    phi_2888_ = _e1544;
                                                    phi_2889_ = _e1546;
                                                } else {
                                                    phi_2888_ = type_48();
                                                    phi_2889_ = true;
                                                }
                                                let _e1548 = phi_2888_;
                                                let _e1550 = phi_2889_;
                                                if _e1550 {
                                                    phi_2893_ = type_48(type_34(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                                                } else {
                                                    phi_2893_ = _e1548;
                                                }
                                                let _e1552 = phi_2893_;
                                                phi_2895_ = _e1552;
                                            } else {
                                                phi_2895_ = type_48();
                                            }
                                            let _e1554 = phi_2895_;
                                            phi_2899_ = _e1554;
                                            phi_2900_ = select(true, false, _e1326);
                                        }
                                        let _e1557 = phi_2899_;
                                        let _e1559 = phi_2900_;
                                        if _e1559 {
                                            phi_2904_ = type_48(type_34(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                                        } else {
                                            phi_2904_ = _e1557;
                                        }
                                        let _e1561 = phi_2904_;
                                        phi_1647_ = _e1561;
                                    }
                                    let _e2065 = phi_1647_;
                                    phi_1648_ = _e2065;
                                }
                                let _e2067 = phi_1648_;
                                phi_1649_ = _e2067;
                            } else {
                                phi_1649_ = type_48(type_34(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                            }
                            let _e2069 = phi_1649_;
                            phi_1650_ = _e2069;
                        } else {
                            phi_1650_ = type_48(type_34(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                        }
                        let _e2071 = phi_1650_;
                        if _e110 {
                        } else {
                            break;
                        }
                        global_11.member[_e107] = _e2071;
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
