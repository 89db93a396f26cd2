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
    var phi_315_: array<u32, 3>;
    var phi_330_: array<f32, 3>;
    var phi_348_: array<f32, 3>;
    var phi_366_: array<f32, 3>;
    var phi_453_: array<u32, 3>;
    var phi_470_: vec3<f32>;
    var phi_487_: vec3<f32>;
    var phi_504_: vec3<f32>;
    var phi_638_: i32;
    var phi_669_: i32;
    var phi_688_: vec3<f32>;
    var phi_771_: i32;
    var phi_802_: i32;
    var phi_821_: vec3<f32>;
    var phi_863_: u32;
    var phi_1076_: type_7;
    var phi_1077_: type_7;
    var phi_1100_: type_7;
    var phi_4311_: bool;
    var phi_1262_: type_7;
    var phi_1265_: u32;
    var phi_1267_: u32;
    var phi_1263_: type_7;
    var phi_1290_: type_7;
    var phi_1306_: u32;
    var phi_1266_: u32;
    var phi_1268_: u32;
    var local_2: u32;
    var phi_1341_: i32;
    var phi_1348_: i32;
    var phi_2644_: f32;
    var phi_2657_: f32;
    var phi_1583_: array<f32, 2>;
    var phi_1612_: type_53;
    var phi_2721_: vec3<f32>;
    var phi_2927_: bool;
    var phi_2930_: bool;
    var phi_2931_: bool;
    var phi_3016_: f32;
    var phi_3020_: f32;
    var phi_3023_: f32;
    var phi_3038_: f32;
    var phi_3042_: f32;
    var phi_3044_: f32;
    var phi_3065_: f32;
    var phi_3069_: f32;
    var phi_3072_: f32;
    var phi_3087_: f32;
    var phi_3091_: f32;
    var phi_3093_: f32;
    var phi_3114_: f32;
    var phi_3118_: f32;
    var phi_3121_: f32;
    var phi_3136_: f32;
    var phi_3140_: f32;
    var phi_3142_: f32;
    var phi_3163_: vec3<f32>;
    var phi_3197_: bool;
    var phi_3203_: f32;
    var phi_3239_: f32;
    var phi_3284_: type_49;
    var phi_3287_: type_49;
    var phi_3288_: bool;
    var phi_3290_: type_49;
    var phi_3291_: bool;
    var phi_3295_: type_49;
    var phi_3297_: type_49;
    var phi_3301_: type_49;
    var phi_3302_: bool;
    var phi_3306_: type_49;
    var phi_3608_: vec3<f32>;
    var phi_3814_: bool;
    var phi_3817_: bool;
    var phi_3818_: bool;
    var phi_3903_: f32;
    var phi_3907_: f32;
    var phi_3910_: f32;
    var phi_3925_: f32;
    var phi_3929_: f32;
    var phi_3931_: f32;
    var phi_3952_: f32;
    var phi_3956_: f32;
    var phi_3959_: f32;
    var phi_3974_: f32;
    var phi_3978_: f32;
    var phi_3980_: f32;
    var phi_4001_: f32;
    var phi_4005_: f32;
    var phi_4008_: f32;
    var phi_4023_: f32;
    var phi_4027_: f32;
    var phi_4029_: f32;
    var phi_4050_: vec3<f32>;
    var phi_4084_: bool;
    var phi_4090_: f32;
    var phi_4126_: f32;
    var phi_4171_: type_49;
    var phi_4174_: type_49;
    var phi_4175_: bool;
    var phi_4177_: type_49;
    var phi_4178_: bool;
    var phi_4182_: type_49;
    var phi_4184_: type_49;
    var phi_4188_: type_49;
    var phi_4189_: bool;
    var phi_4193_: type_49;
    var phi_3384_: f32;
    var phi_3388_: f32;
    var phi_3391_: f32;
    var phi_3406_: f32;
    var phi_3410_: f32;
    var phi_3412_: f32;
    var phi_3433_: f32;
    var phi_3437_: f32;
    var phi_3440_: f32;
    var phi_3455_: f32;
    var phi_3459_: f32;
    var phi_3461_: f32;
    var phi_3482_: f32;
    var phi_3486_: f32;
    var phi_3489_: f32;
    var phi_3504_: f32;
    var phi_3508_: f32;
    var phi_3510_: f32;
    var phi_3531_: vec3<f32>;
    var phi_3545_: type_49;
    var phi_1654_: type_49;
    var phi_1655_: type_49;
    var phi_1656_: type_49;
    var phi_1657_: type_49;

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
                                    phi_1655_ = type_49(type_35(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
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
                                        phi_315_ = _e143;
                                    } else {
                                        phi_315_ = array<u32, 3>(0u, 0u, 0u);
                                    }
                                    let _e145 = phi_315_;
                                    let _e147 = (_e145[0] < _e88);
                                    if _e147 {
                                        if _e147 {
                                        } else {
                                            break;
                                        }
                                        let _e149 = global_4.member[_e145[0]];
                                        phi_330_ = _e149;
                                    } else {
                                        phi_330_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e151 = phi_330_;
                                    let _e156 = (_e145[1] < _e88);
                                    if _e156 {
                                        if _e156 {
                                        } else {
                                            break;
                                        }
                                        let _e158 = global_4.member[_e145[1]];
                                        phi_348_ = _e158;
                                    } else {
                                        phi_348_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e160 = phi_348_;
                                    let _e165 = (_e145[2] < _e88);
                                    if _e165 {
                                        if _e165 {
                                        } else {
                                            break;
                                        }
                                        let _e167 = global_4.member[_e145[2]];
                                        phi_366_ = _e167;
                                    } else {
                                        phi_366_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e169 = phi_366_;
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
                                        phi_453_ = _e211;
                                    } else {
                                        phi_453_ = array<u32, 3>(0u, 0u, 0u);
                                    }
                                    let _e213 = phi_453_;
                                    let _e215 = (_e213[0] < _e93);
                                    if _e215 {
                                        if _e215 {
                                        } else {
                                            break;
                                        }
                                        let _e218 = global_6.member[_e213[0]];
                                        phi_470_ = vec3<f32>(_e218[0], _e218[1], _e218[2]);
                                    } else {
                                        phi_470_ = vec3<f32>(0f, 0f, 0f);
                                    }
                                    let _e224 = phi_470_;
                                    let _e226 = (_e213[1] < _e93);
                                    if _e226 {
                                        if _e226 {
                                        } else {
                                            break;
                                        }
                                        let _e229 = global_6.member[_e213[1]];
                                        phi_487_ = vec3<f32>(_e229[0], _e229[1], _e229[2]);
                                    } else {
                                        phi_487_ = vec3<f32>(0f, 0f, 0f);
                                    }
                                    let _e235 = phi_487_;
                                    let _e237 = (_e213[2] < _e93);
                                    if _e237 {
                                        if _e237 {
                                        } else {
                                            break;
                                        }
                                        let _e240 = global_6.member[_e213[2]];
                                        phi_504_ = vec3<f32>(_e240[0], _e240[1], _e240[2]);
                                    } else {
                                        phi_504_ = vec3<f32>(0f, 0f, 0f);
                                    }
                                    let _e246 = phi_504_;
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
                                        phi_688_ = vec3<f32>(0f, 0f, 0f);
                                    } else {
                                        let _e343 = (bitcast<u32>(_e340) & 2147483647u);
                                        let _e344 = (_e343 >= 8388608u);
                                        if _e344 {
                                            phi_638_ = (bitcast<i32>((_e343 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_638_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e343)), 32u, (_e343 == 0u))));
                                        }
                                        let _e357 = phi_638_;
                                        let _e364 = bitcast<f32>((bitcast<u32>(((_e357 / -2i) + 127i)) << bitcast<u32>(23i)));
                                        if _e344 {
                                            phi_669_ = (bitcast<i32>((_e343 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_669_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e343)), 32u, (_e343 == 0u))));
                                        }
                                        let _e380 = phi_669_;
                                        let _e386 = bitcast<f32>((bitcast<u32>((((_e357 / 2i) - _e380) + 127i)) << bitcast<u32>(23i)));
                                        let _e387 = ((_e321 * _e364) * _e386);
                                        let _e388 = ((_e324 * _e364) * _e386);
                                        let _e389 = ((_e327 * _e364) * _e386);
                                        let _e395 = sqrt((((_e387 * _e387) + (_e388 * _e388)) + (_e389 * _e389)));
                                        phi_688_ = vec3<f32>((_e387 / _e395), (_e388 / _e395), (_e389 / _e395));
                                    }
                                    let _e401 = phi_688_;
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
                                        phi_821_ = vec3<f32>(0f, 0f, 0f);
                                    } else {
                                        let _e455 = (bitcast<u32>(_e452) & 2147483647u);
                                        let _e456 = (_e455 >= 8388608u);
                                        if _e456 {
                                            phi_771_ = (bitcast<i32>((_e455 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_771_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e455)), 32u, (_e455 == 0u))));
                                        }
                                        let _e469 = phi_771_;
                                        let _e476 = bitcast<f32>((bitcast<u32>(((_e469 / -2i) + 127i)) << bitcast<u32>(23i)));
                                        if _e456 {
                                            phi_802_ = (bitcast<i32>((_e455 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_802_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e455)), 32u, (_e455 == 0u))));
                                        }
                                        let _e492 = phi_802_;
                                        let _e498 = bitcast<f32>((bitcast<u32>((((_e469 / 2i) - _e492) + 127i)) << bitcast<u32>(23i)));
                                        let _e499 = ((_e437 * _e476) * _e498);
                                        let _e500 = ((_e438 * _e476) * _e498);
                                        let _e501 = ((_e439 * _e476) * _e498);
                                        let _e507 = sqrt((((_e499 * _e499) + (_e500 * _e500)) + (_e501 * _e501)));
                                        phi_821_ = vec3<f32>((_e499 / _e507), (_e500 / _e507), (_e501 / _e507));
                                    }
                                    let _e513 = phi_821_;
                                    let _e528 = select(_e415, (_e513 * _e411), vec3((((((_e513.x * _e411) * (_e401.x * _e411)) + ((_e513.y * _e411) * (_e401.y * _e411))) + ((_e513.z * _e411) * (_e401.z * _e411))) > 0f)));
                                    let _e529 = (_e116.member_3 < arrayLength((&global_7.member)));
                                    if _e529 {
                                        if _e529 {
                                        } else {
                                            break;
                                        }
                                        let _e532 = global_7.member[_e116.member_3];
                                        phi_863_ = _e532;
                                    } else {
                                        phi_863_ = 0u;
                                    }
                                    let _e534 = phi_863_;
                                    let _e536 = select(_e534, 0u, (_e534 >= _e97));
                                    if (_e536 < _e97) {
                                    } else {
                                        break;
                                    }
                                    let _e540 = global_8.member[_e536];
                                    let _e547 = global_3.member[0u];
                                    let _e550 = global_3.member[1u];
                                    let _e553 = global_2.member[0u];
                                    let _e563 = global_2.member[0u][3u];
                                    let _e566 = global_2.member[1u];
                                    let _e576 = global_2.member[1u][3u];
                                    let _e580 = global_2.member[2u];
                                    let _e590 = global_2.member[2u][3u];
                                    let _e593 = global_2.member[3u];
                                    let _e603 = global_2.member[3u][3u];
                                    let _e606 = global_2.member[4u];
                                    let _e616 = global_2.member[4u][3u];
                                    local_1 = type_53(array<f32, 3>(bitcast<f32>(_e553.x), bitcast<f32>(_e553.y), bitcast<f32>(_e553.z)), _e563, array<f32, 3>(bitcast<f32>(_e566.x), bitcast<f32>(_e566.y), bitcast<f32>(_e566.z)), bitcast<f32>(_e576), array<f32, 3>(bitcast<f32>(_e580.x), bitcast<f32>(_e580.y), bitcast<f32>(_e580.z)), _e590, array<f32, 3>(bitcast<f32>(_e593.x), bitcast<f32>(_e593.y), bitcast<f32>(_e593.z)), _e603, array<f32, 3>(bitcast<f32>(_e606.x), bitcast<f32>(_e606.y), bitcast<f32>(_e606.z)), _e616);
                                    let _e623 = local_1;
                                    local = _e623;
                                    let _e625 = local_1.member_1;
                                    if (_e625 == 1u) {
                                        let _e628 = local_1.member;
                                        local.member = array<f32, 3>(((_e628[0] * _e134) * _e140), ((_e628[1] * _e134) * _e140), ((_e628[2] * _e134) * _e140));
                                        let _e641 = local_1.member_4;
                                        local.member_4 = array<f32, 3>(((_e641[0] * _e134) * _e140), ((_e641[1] * _e134) * _e140), ((_e641[2] * _e134) * _e140));
                                        let _e654 = local_1.member_6;
                                        local.member_6 = array<f32, 3>(((_e654[0] * _e134) * _e140), ((_e654[1] * _e134) * _e140), ((_e654[2] * _e134) * _e140));
                                        phi_1076_ = type_7(0u, 3u);
                                        loop {
                                            let _e667 = phi_1076_;
                                            if (_e667.member < _e667.member_1) {
                                                phi_1077_ = type_7((_e667.member + 1u), _e667.member_1);
                                                phi_1100_ = type_7(1u, _e667.member);
                                            } else {
                                                phi_1077_ = _e667;
                                                phi_1100_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e680 = phi_1077_;
                                            let _e682 = phi_1100_;
                                            let _e686 = (bitcast<i32>(_e682.member) != 0i);
                                            if _e686 {
                                                let _e687 = (_e682.member_1 < 3u);
                                                if _e687 {
                                                } else {
                                                    phi_4311_ = true;
                                                    break;
                                                }
                                                let _e690 = local_1.member_2[_e682.member_1];
                                                let _e694 = ((((_e690 * _e134) * _e140) * _e134) * _e140);
                                                if _e687 {
                                                } else {
                                                    phi_4311_ = true;
                                                    break;
                                                }
                                                local.member_2[_e682.member_1] = select(340282350000000000000000000000000000000f, _e694, (_e694 < 340282350000000000000000000000000000000f));
                                            }
                                            continue;
                                            continuing {
                                                phi_1076_ = _e680;
                                                phi_4311_ = false;
                                                break if !(_e686);
                                            }
                                        }
                                        let _e701 = phi_4311_;
                                        if _e701 {
                                            break;
                                        }
                                        let _e703 = local_1.member_3;
                                        if (_e703 < 340282350000000000000000000000000000000f) {
                                            let _e705 = local_1.member_3;
                                            let _e707 = ((_e705 * _e134) * _e140);
                                            local.member_3 = select(340282350000000000000000000000000000000f, _e707, (_e707 < 340282350000000000000000000000000000000f));
                                        }
                                    }
                                    let _e711 = local;
                                    let _e742 = type_53(array<f32, 3>(_e711.member[0], _e711.member[1], _e711.member[2]), _e711.member_1, array<f32, 3>(_e711.member_2[0], _e711.member_2[1], _e711.member_2[2]), _e711.member_3, array<f32, 3>(_e711.member_4[0], _e711.member_4[1], _e711.member_4[2]), _e711.member_5, array<f32, 3>(_e711.member_6[0], _e711.member_6[1], _e711.member_6[2]), _e711.member_7, array<f32, 3>(_e711.member_8[0], _e711.member_8[1], _e711.member_8[2]), _e711.member_9);
                                    if (_e711.member_5 != 0u) {
                                        let _e746 = select(1u, _e547, (1u < _e547));
                                        let _e747 = (_e746 == 0u);
                                        if _e747 {
                                            break;
                                        }
                                        let _e748 = (_e113.member_4 / _e746);
                                        if _e747 {
                                            break;
                                        }
                                        let _e753 = ((_e748 ^ (_e748 >> bitcast<u32>(16i))) * 569420461u);
                                        let _e757 = ((_e753 ^ (_e753 >> bitcast<u32>(15i))) * 3545902487u);
                                        let _e761 = ((_e757 ^ (_e757 >> bitcast<u32>(15i))) + _e550);
                                        let _e765 = ((_e761 ^ (_e761 >> bitcast<u32>(16i))) * 569420461u);
                                        let _e769 = ((_e765 ^ (_e765 >> bitcast<u32>(15i))) * 3545902487u);
                                        let _e773 = ((_e769 ^ (_e769 >> bitcast<u32>(15i))) + (_e711.member_7 + 1u));
                                        let _e777 = ((_e773 ^ (_e773 >> bitcast<u32>(16i))) * 569420461u);
                                        let _e781 = ((_e777 ^ (_e777 >> bitcast<u32>(15i))) * 3545902487u);
                                        let _e784 = (_e781 ^ (_e781 >> bitcast<u32>(15i)));
                                        let _e786 = (reverseBits((_e113.member_4 % _e746)) + _e784);
                                        let _e788 = (_e786 ^ (_e786 * 1817228412u));
                                        let _e790 = (_e788 ^ (_e788 * 3090095698u));
                                        let _e792 = (_e790 ^ (_e790 * 3350193720u));
                                        let _e795 = reverseBits((_e792 ^ (_e792 * 2367878886u)));
                                        let _e797 = (_e784 ^ 1u);
                                        let _e801 = ((_e797 ^ (_e797 >> bitcast<u32>(16i))) * 569420461u);
                                        let _e805 = ((_e801 ^ (_e801 >> bitcast<u32>(15i))) * 3545902487u);
                                        let _e810 = (reverseBits(reverseBits(_e795)) + (_e805 ^ (_e805 >> bitcast<u32>(15i))));
                                        let _e812 = (_e810 ^ (_e810 * 1817228412u));
                                        let _e814 = (_e812 ^ (_e812 * 3090095698u));
                                        let _e816 = (_e814 ^ (_e814 * 3350193720u));
                                        let _e819 = reverseBits((_e816 ^ (_e816 * 2367878886u)));
                                        phi_1262_ = type_7(0u, 32u);
                                        phi_1265_ = 2147483648u;
                                        phi_1267_ = 0u;
                                        loop {
                                            let _e821 = phi_1262_;
                                            let _e823 = phi_1265_;
                                            let _e825 = phi_1267_;
                                            local_2 = _e825;
                                            if (_e821.member < _e821.member_1) {
                                                phi_1263_ = type_7((_e821.member + 1u), _e821.member_1);
                                                phi_1290_ = type_7(1u, _e821.member);
                                            } else {
                                                phi_1263_ = _e821;
                                                phi_1290_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e838 = phi_1263_;
                                            let _e840 = phi_1290_;
                                            let _e844 = (bitcast<i32>(_e840.member) != 0i);
                                            if _e844 {
                                                if (((_e795 >> bitcast<u32>((_e840.member_1 & 31u))) & 1u) == 1u) {
                                                    phi_1306_ = (_e825 ^ _e823);
                                                } else {
                                                    phi_1306_ = _e825;
                                                }
                                                let _e852 = phi_1306_;
                                                phi_1266_ = (_e823 ^ (_e823 >> bitcast<u32>(1i)));
                                                phi_1268_ = _e852;
                                            } else {
                                                phi_1266_ = u32();
                                                phi_1268_ = u32();
                                            }
                                            let _e857 = phi_1266_;
                                            let _e859 = phi_1268_;
                                            continue;
                                            continuing {
                                                phi_1262_ = _e838;
                                                phi_1265_ = _e857;
                                                phi_1267_ = _e859;
                                                break if !(_e844);
                                            }
                                        }
                                        let _e861 = (_e784 ^ 2u);
                                        let _e865 = ((_e861 ^ (_e861 >> bitcast<u32>(16i))) * 569420461u);
                                        let _e869 = ((_e865 ^ (_e865 >> bitcast<u32>(15i))) * 3545902487u);
                                        let _e874 = local_2;
                                        let _e876 = (reverseBits(_e874) + (_e869 ^ (_e869 >> bitcast<u32>(15i))));
                                        let _e878 = (_e876 ^ (_e876 * 1817228412u));
                                        let _e880 = (_e878 ^ (_e878 * 3090095698u));
                                        let _e882 = (_e880 ^ (_e880 * 3350193720u));
                                        let _e885 = reverseBits((_e882 ^ (_e882 * 2367878886u)));
                                        if (_e711.member_5 == 1u) {
                                            let _e908 = bitcast<i32>(((2u * (_e819 >> bitcast<u32>(16i))) + 1u));
                                            let _e909 = (_e908 - 65536i);
                                            let _e914 = bitcast<i32>(((2u * (_e885 >> bitcast<u32>(16i))) + 1u));
                                            let _e915 = (_e914 - 65536i);
                                            let _e916 = (_e909 < 0i);
                                            if _e916 {
                                                phi_1341_ = (65536i - _e908);
                                            } else {
                                                phi_1341_ = _e909;
                                            }
                                            let _e919 = phi_1341_;
                                            let _e920 = bitcast<u32>(_e919);
                                            let _e921 = (_e915 < 0i);
                                            if _e921 {
                                                phi_1348_ = (65536i - _e914);
                                            } else {
                                                phi_1348_ = _e915;
                                            }
                                            let _e924 = phi_1348_;
                                            let _e925 = bitcast<u32>(_e924);
                                            let _e926 = (_e920 > _e925);
                                            let _e927 = select(_e925, _e920, _e926);
                                            let _e932 = select(1u, _e927, (1u < _e927));
                                            if (_e932 == 0u) {
                                                break;
                                            }
                                            let _e936 = (((select(_e920, _e925, _e926) << bitcast<u32>(16i)) / _e932) << bitcast<u32>(15i));
                                            let _e938 = (_e936 >> bitcast<u32>(16i));
                                            let _e939 = (_e936 & 65535u);
                                            let _e944 = ((_e938 * _e939) + ((_e939 * _e939) >> bitcast<u32>(16i)));
                                            let _e956 = ((((_e938 * _e938) + (_e944 >> bitcast<u32>(16i))) + (((_e939 * _e938) + (_e944 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i));
                                            let _e958 = (_e956 >> bitcast<u32>(16i));
                                            let _e959 = (_e956 & 65535u);
                                            let _e964 = ((_e958 * 7711u) + ((_e959 * 7711u) >> bitcast<u32>(16i)));
                                            let _e973 = (700062u - (((_e964 >> bitcast<u32>(16i)) + ((_e964 & 65535u) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                                            let _e975 = (_e973 >> bitcast<u32>(16i));
                                            let _e976 = (_e973 & 65535u);
                                            let _e981 = ((_e958 * _e976) + ((_e959 * _e976) >> bitcast<u32>(16i)));
                                            let _e994 = (34046945u - ((((_e958 * _e975) + (_e981 >> bitcast<u32>(16i))) + (((_e959 * _e975) + (_e981 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                                            let _e996 = (_e994 >> bitcast<u32>(16i));
                                            let _e997 = (_e994 & 65535u);
                                            let _e1002 = ((_e958 * _e997) + ((_e959 * _e997) >> bitcast<u32>(16i)));
                                            let _e1015 = (662337939u - ((((_e958 * _e996) + (_e1002 >> bitcast<u32>(16i))) + (((_e959 * _e996) + (_e1002 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                                            let _e1020 = ((_e958 * 13011u) + ((_e959 * 13011u) >> bitcast<u32>(16i)));
                                            let _e1031 = (5348082u - (((_e958 + (_e1020 >> bitcast<u32>(16i))) + ((_e959 + (_e1020 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                                            let _e1033 = (_e1031 >> bitcast<u32>(16i));
                                            let _e1034 = (_e1031 & 65535u);
                                            let _e1039 = ((_e958 * _e1034) + ((_e959 * _e1034) >> bitcast<u32>(16i)));
                                            let _e1052 = (173399667u - ((((_e958 * _e1033) + (_e1039 >> bitcast<u32>(16i))) + (((_e959 * _e1033) + (_e1039 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                                            let _e1054 = (_e1052 >> bitcast<u32>(16i));
                                            let _e1055 = (_e1052 & 65535u);
                                            let _e1060 = ((_e958 * _e1055) + ((_e959 * _e1055) >> bitcast<u32>(16i)));
                                            let _e1073 = (1686629713u - ((((_e958 * _e1054) + (_e1060 >> bitcast<u32>(16i))) + (((_e959 * _e1054) + (_e1060 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                                            let _e1075 = (_e1015 >> bitcast<u32>(16i));
                                            let _e1076 = (_e1015 & 65535u);
                                            let _e1081 = ((_e958 * _e1076) + ((_e959 * _e1076) >> bitcast<u32>(16i)));
                                            let _e1094 = (2147483648u - ((((_e958 * _e1075) + (_e1081 >> bitcast<u32>(16i))) + (((_e959 * _e1075) + (_e1081 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                                            let _e1096 = (_e1073 >> bitcast<u32>(16i));
                                            let _e1097 = (_e1073 & 65535u);
                                            let _e1102 = ((_e938 * _e1097) + ((_e939 * _e1097) >> bitcast<u32>(16i)));
                                            let _e1114 = ((((_e938 * _e1096) + (_e1102 >> bitcast<u32>(16i))) + (((_e939 * _e1096) + (_e1102 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i));
                                            let _e1116 = (_e927 << bitcast<u32>(15i));
                                            let _e1118 = (_e1116 >> bitcast<u32>(16i));
                                            let _e1119 = (_e1116 & 65535u);
                                            let _e1121 = (_e1094 >> bitcast<u32>(16i));
                                            let _e1122 = (_e1094 & 65535u);
                                            let _e1127 = ((_e1118 * _e1122) + ((_e1119 * _e1122) >> bitcast<u32>(16i)));
                                            let _e1139 = ((((_e1118 * _e1121) + (_e1127 >> bitcast<u32>(16i))) + (((_e1119 * _e1121) + (_e1127 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i));
                                            let _e1141 = (_e1114 >> bitcast<u32>(16i));
                                            let _e1142 = (_e1114 & 65535u);
                                            let _e1147 = ((_e1118 * _e1142) + ((_e1119 * _e1142) >> bitcast<u32>(16i)));
                                            let _e1159 = ((((_e1118 * _e1141) + (_e1147 >> bitcast<u32>(16i))) + (((_e1119 * _e1141) + (_e1147 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i));
                                            let _e1164 = f32((select(_e1159, _e1139, _e926) >> bitcast<u32>(7i)));
                                            if _e916 {
                                                phi_2644_ = (_e1164 * -0.000000059604645f);
                                            } else {
                                                phi_2644_ = (_e1164 * 0.000000059604645f);
                                            }
                                            let _e1168 = phi_2644_;
                                            let _e1171 = f32((select(_e1139, _e1159, _e926) >> bitcast<u32>(7i)));
                                            if _e921 {
                                                phi_2657_ = (_e1171 * -0.000000059604645f);
                                            } else {
                                                phi_2657_ = (_e1171 * 0.000000059604645f);
                                            }
                                            let _e1175 = phi_2657_;
                                            phi_1583_ = array<f32, 2>(_e1168, _e1175);
                                        } else {
                                            phi_1583_ = array<f32, 2>((f32((bitcast<i32>(((2u * (_e819 >> bitcast<u32>(9i))) + 1u)) - 8388608i)) * 0.00000011920929f), (f32((bitcast<i32>(((2u * (_e885 >> bitcast<u32>(9i))) + 1u)) - 8388608i)) * 0.00000011920929f));
                                        }
                                        let _e1178 = phi_1583_;
                                        phi_1612_ = type_53(array<f32, 3>((_e711.member[0] + ((_e711.member_4[0] * _e1178[0]) + (_e711.member_6[0] * _e1178[1]))), (_e711.member[1] + ((_e711.member_4[1] * _e1178[0]) + (_e711.member_6[1] * _e1178[1]))), (_e711.member[2] + ((_e711.member_4[2] * _e1178[0]) + (_e711.member_6[2] * _e1178[1])))), _e742.member_1, _e742.member_2, _e742.member_3, _e742.member_4, _e742.member_5, _e742.member_6, _e742.member_7, _e742.member_8, _e742.member_9);
                                    } else {
                                        phi_1612_ = _e742;
                                    }
                                    let _e1206 = phi_1612_;
                                    let _e1215 = global_3.member[2u];
                                    if (_e1215 == 1u) {
                                        let _e1570 = (_e1206.member_1 == 1u);
                                        if _e1570 {
                                            phi_3608_ = (vec3<f32>(_e1206.member[0], _e1206.member[1], _e1206.member[2]) - _e209);
                                        } else {
                                            phi_3608_ = vec3<f32>(_e1206.member[0], _e1206.member[1], _e1206.member[2]);
                                        }
                                        let _e1581 = phi_3608_;
                                        let _e1583 = bitcast<f32>(bitcast<u32>(_e325));
                                        let _e1586 = bitcast<f32>(bitcast<u32>((_e314 * _e316)));
                                        let _e1588 = bitcast<f32>(bitcast<u32>(_e319));
                                        let _e1591 = bitcast<f32>(bitcast<u32>((_e315 * _e317)));
                                        let _e1593 = bitcast<f32>(bitcast<u32>(_e322));
                                        let _e1596 = bitcast<f32>(bitcast<u32>((_e313 * _e318)));
                                        let _e1660 = global_12[0u];
                                        if (_e1206.member_2[0] == _e1660) {
                                            let _e1663 = global_12[1u];
                                            let _e1664 = (_e1206.member_2[1] == _e1663);
                                            if _e1664 {
                                                let _e1666 = global_12[2u];
                                                phi_3814_ = (_e1206.member_2[2] == _e1666);
                                            } else {
                                                phi_3814_ = bool();
                                            }
                                            let _e1669 = phi_3814_;
                                            phi_3817_ = _e1669;
                                            phi_3818_ = select(true, false, _e1664);
                                        } else {
                                            phi_3817_ = bool();
                                            phi_3818_ = true;
                                        }
                                        let _e1672 = phi_3817_;
                                        let _e1674 = phi_3818_;
                                        if select(_e1672, false, _e1674) {
                                            phi_4188_ = type_49();
                                            phi_4189_ = true;
                                        } else {
                                            let _e1677 = ((((bitcast<f32>(bitcast<u32>((_e1581.x * (_e1588 - _e1591)))) + bitcast<f32>(bitcast<u32>((_e1581.y * (_e1593 - _e1596))))) + bitcast<f32>(bitcast<u32>((_e1581.z * (_e1583 - _e1586))))) * _e411) > (bitcast<f32>(bitcast<u32>((0.0000009536752f * ((bitcast<f32>(bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1581.x) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e1588) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1591) & 2147483647u)))))) + bitcast<f32>(bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1581.y) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e1593) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1596) & 2147483647u))))))) + bitcast<f32>(bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1581.z) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e1583) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1586) & 2147483647u)))))))))) + 0.0000000000000000000000000000000000001880791f));
                                            if _e1677 {
                                                let _e1679 = select(_e311, _e310, (_e310 > _e311));
                                                let _e1696 = (select(_e312, _e1679, (_e1679 > _e312)) * ((bitcast<f32>((bitcast<u32>(_e415.x) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e415.y) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e415.z) & 2147483647u))));
                                                let _e1700 = (_e274 + (_e415.x * _e1696));
                                                let _e1701 = (_e275 + (_e415.y * _e1696));
                                                let _e1702 = (_e276 + (_e415.z * _e1696));
                                                if (_e415.x > 0f) {
                                                    let _e1723 = bitcast<u32>(_e1700);
                                                    if ((_e1723 & 2147483647u) == 0u) {
                                                        phi_3929_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1723 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_3925_ = bitcast<f32>((_e1723 + 1u));
                                                        } else {
                                                            phi_3925_ = bitcast<f32>((_e1723 - 1u));
                                                        }
                                                        let _e1734 = phi_3925_;
                                                        phi_3929_ = _e1734;
                                                    }
                                                    let _e1736 = phi_3929_;
                                                    phi_3931_ = _e1736;
                                                } else {
                                                    if (_e415.x < 0f) {
                                                        let _e1706 = bitcast<u32>(-(_e1700));
                                                        if ((_e1706 & 2147483647u) == 0u) {
                                                            phi_3907_ = 0.000000000000000000000000000000000000000000001f;
                                                        } else {
                                                            if ((_e1706 >> bitcast<u32>(31i)) == 0u) {
                                                                phi_3903_ = bitcast<f32>((_e1706 + 1u));
                                                            } else {
                                                                phi_3903_ = bitcast<f32>((_e1706 - 1u));
                                                            }
                                                            let _e1717 = phi_3903_;
                                                            phi_3907_ = _e1717;
                                                        }
                                                        let _e1719 = phi_3907_;
                                                        phi_3910_ = -(_e1719);
                                                    } else {
                                                        phi_3910_ = _e1700;
                                                    }
                                                    let _e1722 = phi_3910_;
                                                    phi_3931_ = _e1722;
                                                }
                                                let _e1738 = phi_3931_;
                                                if (_e415.y > 0f) {
                                                    let _e1759 = bitcast<u32>(_e1701);
                                                    if ((_e1759 & 2147483647u) == 0u) {
                                                        phi_3978_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1759 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_3974_ = bitcast<f32>((_e1759 + 1u));
                                                        } else {
                                                            phi_3974_ = bitcast<f32>((_e1759 - 1u));
                                                        }
                                                        let _e1770 = phi_3974_;
                                                        phi_3978_ = _e1770;
                                                    }
                                                    let _e1772 = phi_3978_;
                                                    phi_3980_ = _e1772;
                                                } else {
                                                    if (_e415.y < 0f) {
                                                        let _e1742 = bitcast<u32>(-(_e1701));
                                                        if ((_e1742 & 2147483647u) == 0u) {
                                                            phi_3956_ = 0.000000000000000000000000000000000000000000001f;
                                                        } else {
                                                            if ((_e1742 >> bitcast<u32>(31i)) == 0u) {
                                                                phi_3952_ = bitcast<f32>((_e1742 + 1u));
                                                            } else {
                                                                phi_3952_ = bitcast<f32>((_e1742 - 1u));
                                                            }
                                                            let _e1753 = phi_3952_;
                                                            phi_3956_ = _e1753;
                                                        }
                                                        let _e1755 = phi_3956_;
                                                        phi_3959_ = -(_e1755);
                                                    } else {
                                                        phi_3959_ = _e1701;
                                                    }
                                                    let _e1758 = phi_3959_;
                                                    phi_3980_ = _e1758;
                                                }
                                                let _e1774 = phi_3980_;
                                                if (_e415.z > 0f) {
                                                    let _e1795 = bitcast<u32>(_e1702);
                                                    if ((_e1795 & 2147483647u) == 0u) {
                                                        phi_4027_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1795 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_4023_ = bitcast<f32>((_e1795 + 1u));
                                                        } else {
                                                            phi_4023_ = bitcast<f32>((_e1795 - 1u));
                                                        }
                                                        let _e1806 = phi_4023_;
                                                        phi_4027_ = _e1806;
                                                    }
                                                    let _e1808 = phi_4027_;
                                                    phi_4029_ = _e1808;
                                                } else {
                                                    if (_e415.z < 0f) {
                                                        let _e1778 = bitcast<u32>(-(_e1702));
                                                        if ((_e1778 & 2147483647u) == 0u) {
                                                            phi_4005_ = 0.000000000000000000000000000000000000000000001f;
                                                        } else {
                                                            if ((_e1778 >> bitcast<u32>(31i)) == 0u) {
                                                                phi_4001_ = bitcast<f32>((_e1778 + 1u));
                                                            } else {
                                                                phi_4001_ = bitcast<f32>((_e1778 - 1u));
                                                            }
                                                            let _e1789 = phi_4001_;
                                                            phi_4005_ = _e1789;
                                                        }
                                                        let _e1791 = phi_4005_;
                                                        phi_4008_ = -(_e1791);
                                                    } else {
                                                        phi_4008_ = _e1702;
                                                    }
                                                    let _e1794 = phi_4008_;
                                                    phi_4029_ = _e1794;
                                                }
                                                let _e1810 = phi_4029_;
                                                if _e1570 {
                                                    phi_4050_ = vec3<f32>((_e1206.member[0] - _e1738), (_e1206.member[1] - _e1774), (_e1206.member[2] - _e1810));
                                                } else {
                                                    phi_4050_ = vec3<f32>(_e1206.member[0], _e1206.member[1], _e1206.member[2]);
                                                }
                                                let _e1820 = phi_4050_;
                                                let _e1833 = sqrt((((_e1820.x * _e1820.x) + (_e1820.y * _e1820.y)) + (_e1820.z * _e1820.z)));
                                                let _e1842 = ((((_e528.x * _e1820.x) + (_e528.y * _e1820.y)) + (_e528.z * _e1820.z)) / _e1833);
                                                if _e1570 {
                                                    phi_4084_ = (_e1833 <= _e1206.member_3);
                                                } else {
                                                    phi_4084_ = true;
                                                }
                                                let _e1845 = phi_4084_;
                                                if _e1570 {
                                                    phi_4090_ = (1f / (_e1833 * _e1833));
                                                } else {
                                                    phi_4090_ = 1f;
                                                }
                                                let _e1849 = phi_4090_;
                                                let _e1850 = -(_e1820.x);
                                                let _e1851 = -(_e1820.y);
                                                let _e1852 = -(_e1820.z);
                                                if (_e1206.member_5 == 0u) {
                                                    phi_4126_ = 1f;
                                                } else {
                                                    let _e1868 = ((((_e1206.member_8[0] * _e1850) + (_e1206.member_8[1] * _e1851)) + (_e1206.member_8[2] * _e1852)) / sqrt((((_e1850 * _e1850) + (_e1851 * _e1851)) + (_e1852 * _e1852))));
                                                    phi_4126_ = select(0f, _e1868, (_e1868 > 0f));
                                                }
                                                let _e1872 = phi_4126_;
                                                if (_e1842 > 0f) {
                                                    if _e1845 {
                                                        let _e1874 = (_e1872 > 0f);
                                                        if _e1874 {
                                                            let _e1881 = ((1f - select(_e540.member_1, _e540.member_2, (_e540.member_2 > 0f))) * 0.31830987f);
                                                            let _e1889 = ((_e1842 * _e1849) * _e1872);
                                                            phi_4171_ = type_49(type_35(array<f32, 3>(_e1738, _e1774, _e1810), 0f, array<f32, 3>(_e1820.x, _e1820.y, _e1820.z), select(340282350000000000000000000000000000000f, 1f, _e1570)), array<f32, 3>(((_e1206.member_2[0] * (_e540.member[0] * _e1881)) * _e1889), ((_e1206.member_2[1] * (_e540.member[1] * _e1881)) * _e1889), ((_e1206.member_2[2] * (_e540.member[2] * _e1881)) * _e1889)), _e116.member_3);
                                                        } else {
                                                            phi_4171_ = type_49();
                                                        }
                                                        let _e1896 = phi_4171_;
                                                        phi_4174_ = _e1896;
                                                        phi_4175_ = select(true, false, _e1874);
                                                    } else {
                                                        phi_4174_ = type_49();
                                                        phi_4175_ = true;
                                                    }
                                                    let _e1899 = phi_4174_;
                                                    let _e1901 = phi_4175_;
                                                    phi_4177_ = _e1899;
                                                    phi_4178_ = _e1901;
                                                } else {
                                                    phi_4177_ = type_49();
                                                    phi_4178_ = true;
                                                }
                                                let _e1903 = phi_4177_;
                                                let _e1905 = phi_4178_;
                                                if _e1905 {
                                                    phi_4182_ = type_49(type_35(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                                                } else {
                                                    phi_4182_ = _e1903;
                                                }
                                                let _e1907 = phi_4182_;
                                                phi_4184_ = _e1907;
                                            } else {
                                                phi_4184_ = type_49();
                                            }
                                            let _e1909 = phi_4184_;
                                            phi_4188_ = _e1909;
                                            phi_4189_ = select(true, false, _e1677);
                                        }
                                        let _e1912 = phi_4188_;
                                        let _e1914 = phi_4189_;
                                        if _e1914 {
                                            phi_4193_ = type_49(type_35(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                                        } else {
                                            phi_4193_ = _e1912;
                                        }
                                        let _e1916 = phi_4193_;
                                        if (_e1916.member.member_1 <= _e1916.member.member_3) {
                                            phi_3545_ = _e1916;
                                        } else {
                                            let _e1923 = select(_e311, _e310, (_e310 > _e311));
                                            let _e1940 = (select(_e312, _e1923, (_e1923 > _e312)) * ((bitcast<f32>((bitcast<u32>(_e415.x) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e415.y) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e415.z) & 2147483647u))));
                                            let _e1944 = (_e274 + (_e415.x * _e1940));
                                            let _e1945 = (_e275 + (_e415.y * _e1940));
                                            let _e1946 = (_e276 + (_e415.z * _e1940));
                                            if (_e415.x > 0f) {
                                                let _e1967 = bitcast<u32>(_e1944);
                                                if ((_e1967 & 2147483647u) == 0u) {
                                                    phi_3410_ = 0.000000000000000000000000000000000000000000001f;
                                                } else {
                                                    if ((_e1967 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_3406_ = bitcast<f32>((_e1967 + 1u));
                                                    } else {
                                                        phi_3406_ = bitcast<f32>((_e1967 - 1u));
                                                    }
                                                    let _e1978 = phi_3406_;
                                                    phi_3410_ = _e1978;
                                                }
                                                let _e1980 = phi_3410_;
                                                phi_3412_ = _e1980;
                                            } else {
                                                if (_e415.x < 0f) {
                                                    let _e1950 = bitcast<u32>(-(_e1944));
                                                    if ((_e1950 & 2147483647u) == 0u) {
                                                        phi_3388_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1950 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_3384_ = bitcast<f32>((_e1950 + 1u));
                                                        } else {
                                                            phi_3384_ = bitcast<f32>((_e1950 - 1u));
                                                        }
                                                        let _e1961 = phi_3384_;
                                                        phi_3388_ = _e1961;
                                                    }
                                                    let _e1963 = phi_3388_;
                                                    phi_3391_ = -(_e1963);
                                                } else {
                                                    phi_3391_ = _e1944;
                                                }
                                                let _e1966 = phi_3391_;
                                                phi_3412_ = _e1966;
                                            }
                                            let _e1982 = phi_3412_;
                                            if (_e415.y > 0f) {
                                                let _e2003 = bitcast<u32>(_e1945);
                                                if ((_e2003 & 2147483647u) == 0u) {
                                                    phi_3459_ = 0.000000000000000000000000000000000000000000001f;
                                                } else {
                                                    if ((_e2003 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_3455_ = bitcast<f32>((_e2003 + 1u));
                                                    } else {
                                                        phi_3455_ = bitcast<f32>((_e2003 - 1u));
                                                    }
                                                    let _e2014 = phi_3455_;
                                                    phi_3459_ = _e2014;
                                                }
                                                let _e2016 = phi_3459_;
                                                phi_3461_ = _e2016;
                                            } else {
                                                if (_e415.y < 0f) {
                                                    let _e1986 = bitcast<u32>(-(_e1945));
                                                    if ((_e1986 & 2147483647u) == 0u) {
                                                        phi_3437_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1986 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_3433_ = bitcast<f32>((_e1986 + 1u));
                                                        } else {
                                                            phi_3433_ = bitcast<f32>((_e1986 - 1u));
                                                        }
                                                        let _e1997 = phi_3433_;
                                                        phi_3437_ = _e1997;
                                                    }
                                                    let _e1999 = phi_3437_;
                                                    phi_3440_ = -(_e1999);
                                                } else {
                                                    phi_3440_ = _e1945;
                                                }
                                                let _e2002 = phi_3440_;
                                                phi_3461_ = _e2002;
                                            }
                                            let _e2018 = phi_3461_;
                                            if (_e415.z > 0f) {
                                                let _e2039 = bitcast<u32>(_e1946);
                                                if ((_e2039 & 2147483647u) == 0u) {
                                                    phi_3508_ = 0.000000000000000000000000000000000000000000001f;
                                                } else {
                                                    if ((_e2039 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_3504_ = bitcast<f32>((_e2039 + 1u));
                                                    } else {
                                                        phi_3504_ = bitcast<f32>((_e2039 - 1u));
                                                    }
                                                    let _e2050 = phi_3504_;
                                                    phi_3508_ = _e2050;
                                                }
                                                let _e2052 = phi_3508_;
                                                phi_3510_ = _e2052;
                                            } else {
                                                if (_e415.z < 0f) {
                                                    let _e2022 = bitcast<u32>(-(_e1946));
                                                    if ((_e2022 & 2147483647u) == 0u) {
                                                        phi_3486_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e2022 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_3482_ = bitcast<f32>((_e2022 + 1u));
                                                        } else {
                                                            phi_3482_ = bitcast<f32>((_e2022 - 1u));
                                                        }
                                                        let _e2033 = phi_3482_;
                                                        phi_3486_ = _e2033;
                                                    }
                                                    let _e2035 = phi_3486_;
                                                    phi_3489_ = -(_e2035);
                                                } else {
                                                    phi_3489_ = _e1946;
                                                }
                                                let _e2038 = phi_3489_;
                                                phi_3510_ = _e2038;
                                            }
                                            let _e2054 = phi_3510_;
                                            if _e1570 {
                                                phi_3531_ = vec3<f32>((_e1206.member[0] - _e1982), (_e1206.member[1] - _e2018), (_e1206.member[2] - _e2054));
                                            } else {
                                                phi_3531_ = vec3<f32>(_e1206.member[0], _e1206.member[1], _e1206.member[2]);
                                            }
                                            let _e2064 = phi_3531_;
                                            phi_3545_ = type_49(type_35(array<f32, 3>(_e1982, _e2018, _e2054), 0f, array<f32, 3>(_e2064.x, _e2064.y, _e2064.z), select(340282350000000000000000000000000000000f, 1f, _e1570)), array<f32, 3>(0f, 0f, 0f), _e116.member_3);
                                        }
                                        let _e2074 = phi_3545_;
                                        phi_1654_ = _e2074;
                                    } else {
                                        let _e1220 = (_e1206.member_1 == 1u);
                                        if _e1220 {
                                            phi_2721_ = (vec3<f32>(_e1206.member[0], _e1206.member[1], _e1206.member[2]) - _e209);
                                        } else {
                                            phi_2721_ = vec3<f32>(_e1206.member[0], _e1206.member[1], _e1206.member[2]);
                                        }
                                        let _e1231 = phi_2721_;
                                        let _e1233 = bitcast<f32>(bitcast<u32>(_e325));
                                        let _e1236 = bitcast<f32>(bitcast<u32>((_e314 * _e316)));
                                        let _e1238 = bitcast<f32>(bitcast<u32>(_e319));
                                        let _e1241 = bitcast<f32>(bitcast<u32>((_e315 * _e317)));
                                        let _e1243 = bitcast<f32>(bitcast<u32>(_e322));
                                        let _e1246 = bitcast<f32>(bitcast<u32>((_e313 * _e318)));
                                        let _e1310 = global_12[0u];
                                        if (_e1206.member_2[0] == _e1310) {
                                            let _e1313 = global_12[1u];
                                            let _e1314 = (_e1206.member_2[1] == _e1313);
                                            if _e1314 {
                                                let _e1316 = global_12[2u];
                                                phi_2927_ = (_e1206.member_2[2] == _e1316);
                                            } else {
                                                phi_2927_ = bool();
                                            }
                                            let _e1319 = phi_2927_;
                                            phi_2930_ = _e1319;
                                            phi_2931_ = select(true, false, _e1314);
                                        } else {
                                            phi_2930_ = bool();
                                            phi_2931_ = true;
                                        }
                                        let _e1322 = phi_2930_;
                                        let _e1324 = phi_2931_;
                                        if select(_e1322, false, _e1324) {
                                            phi_3301_ = type_49();
                                            phi_3302_ = true;
                                        } else {
                                            let _e1327 = ((((bitcast<f32>(bitcast<u32>((_e1231.x * (_e1238 - _e1241)))) + bitcast<f32>(bitcast<u32>((_e1231.y * (_e1243 - _e1246))))) + bitcast<f32>(bitcast<u32>((_e1231.z * (_e1233 - _e1236))))) * _e411) > (bitcast<f32>(bitcast<u32>((0.0000009536752f * ((bitcast<f32>(bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1231.x) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e1238) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1241) & 2147483647u)))))) + bitcast<f32>(bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1231.y) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e1243) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1246) & 2147483647u))))))) + bitcast<f32>(bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1231.z) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e1233) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1236) & 2147483647u)))))))))) + 0.0000000000000000000000000000000000001880791f));
                                            if _e1327 {
                                                let _e1329 = select(_e311, _e310, (_e310 > _e311));
                                                let _e1346 = (select(_e312, _e1329, (_e1329 > _e312)) * ((bitcast<f32>((bitcast<u32>(_e415.x) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e415.y) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e415.z) & 2147483647u))));
                                                let _e1350 = (_e274 + (_e415.x * _e1346));
                                                let _e1351 = (_e275 + (_e415.y * _e1346));
                                                let _e1352 = (_e276 + (_e415.z * _e1346));
                                                if (_e415.x > 0f) {
                                                    let _e1373 = bitcast<u32>(_e1350);
                                                    if ((_e1373 & 2147483647u) == 0u) {
                                                        phi_3042_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1373 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_3038_ = bitcast<f32>((_e1373 + 1u));
                                                        } else {
                                                            phi_3038_ = bitcast<f32>((_e1373 - 1u));
                                                        }
                                                        let _e1384 = phi_3038_;
                                                        phi_3042_ = _e1384;
                                                    }
                                                    let _e1386 = phi_3042_;
                                                    phi_3044_ = _e1386;
                                                } else {
                                                    if (_e415.x < 0f) {
                                                        let _e1356 = bitcast<u32>(-(_e1350));
                                                        if ((_e1356 & 2147483647u) == 0u) {
                                                            phi_3020_ = 0.000000000000000000000000000000000000000000001f;
                                                        } else {
                                                            if ((_e1356 >> bitcast<u32>(31i)) == 0u) {
                                                                phi_3016_ = bitcast<f32>((_e1356 + 1u));
                                                            } else {
                                                                phi_3016_ = bitcast<f32>((_e1356 - 1u));
                                                            }
                                                            let _e1367 = phi_3016_;
                                                            phi_3020_ = _e1367;
                                                        }
                                                        let _e1369 = phi_3020_;
                                                        phi_3023_ = -(_e1369);
                                                    } else {
                                                        phi_3023_ = _e1350;
                                                    }
                                                    let _e1372 = phi_3023_;
                                                    phi_3044_ = _e1372;
                                                }
                                                let _e1388 = phi_3044_;
                                                if (_e415.y > 0f) {
                                                    let _e1409 = bitcast<u32>(_e1351);
                                                    if ((_e1409 & 2147483647u) == 0u) {
                                                        phi_3091_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1409 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_3087_ = bitcast<f32>((_e1409 + 1u));
                                                        } else {
                                                            phi_3087_ = bitcast<f32>((_e1409 - 1u));
                                                        }
                                                        let _e1420 = phi_3087_;
                                                        phi_3091_ = _e1420;
                                                    }
                                                    let _e1422 = phi_3091_;
                                                    phi_3093_ = _e1422;
                                                } else {
                                                    if (_e415.y < 0f) {
                                                        let _e1392 = bitcast<u32>(-(_e1351));
                                                        if ((_e1392 & 2147483647u) == 0u) {
                                                            phi_3069_ = 0.000000000000000000000000000000000000000000001f;
                                                        } else {
                                                            if ((_e1392 >> bitcast<u32>(31i)) == 0u) {
                                                                phi_3065_ = bitcast<f32>((_e1392 + 1u));
                                                            } else {
                                                                phi_3065_ = bitcast<f32>((_e1392 - 1u));
                                                            }
                                                            let _e1403 = phi_3065_;
                                                            phi_3069_ = _e1403;
                                                        }
                                                        let _e1405 = phi_3069_;
                                                        phi_3072_ = -(_e1405);
                                                    } else {
                                                        phi_3072_ = _e1351;
                                                    }
                                                    let _e1408 = phi_3072_;
                                                    phi_3093_ = _e1408;
                                                }
                                                let _e1424 = phi_3093_;
                                                if (_e415.z > 0f) {
                                                    let _e1445 = bitcast<u32>(_e1352);
                                                    if ((_e1445 & 2147483647u) == 0u) {
                                                        phi_3140_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1445 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_3136_ = bitcast<f32>((_e1445 + 1u));
                                                        } else {
                                                            phi_3136_ = bitcast<f32>((_e1445 - 1u));
                                                        }
                                                        let _e1456 = phi_3136_;
                                                        phi_3140_ = _e1456;
                                                    }
                                                    let _e1458 = phi_3140_;
                                                    phi_3142_ = _e1458;
                                                } else {
                                                    if (_e415.z < 0f) {
                                                        let _e1428 = bitcast<u32>(-(_e1352));
                                                        if ((_e1428 & 2147483647u) == 0u) {
                                                            phi_3118_ = 0.000000000000000000000000000000000000000000001f;
                                                        } else {
                                                            if ((_e1428 >> bitcast<u32>(31i)) == 0u) {
                                                                phi_3114_ = bitcast<f32>((_e1428 + 1u));
                                                            } else {
                                                                phi_3114_ = bitcast<f32>((_e1428 - 1u));
                                                            }
                                                            let _e1439 = phi_3114_;
                                                            phi_3118_ = _e1439;
                                                        }
                                                        let _e1441 = phi_3118_;
                                                        phi_3121_ = -(_e1441);
                                                    } else {
                                                        phi_3121_ = _e1352;
                                                    }
                                                    let _e1444 = phi_3121_;
                                                    phi_3142_ = _e1444;
                                                }
                                                let _e1460 = phi_3142_;
                                                if _e1220 {
                                                    phi_3163_ = vec3<f32>((_e1206.member[0] - _e1388), (_e1206.member[1] - _e1424), (_e1206.member[2] - _e1460));
                                                } else {
                                                    phi_3163_ = vec3<f32>(_e1206.member[0], _e1206.member[1], _e1206.member[2]);
                                                }
                                                let _e1470 = phi_3163_;
                                                let _e1483 = sqrt((((_e1470.x * _e1470.x) + (_e1470.y * _e1470.y)) + (_e1470.z * _e1470.z)));
                                                let _e1492 = ((((_e528.x * _e1470.x) + (_e528.y * _e1470.y)) + (_e528.z * _e1470.z)) / _e1483);
                                                if _e1220 {
                                                    phi_3197_ = (_e1483 <= _e1206.member_3);
                                                } else {
                                                    phi_3197_ = true;
                                                }
                                                let _e1495 = phi_3197_;
                                                if _e1220 {
                                                    phi_3203_ = (1f / (_e1483 * _e1483));
                                                } else {
                                                    phi_3203_ = 1f;
                                                }
                                                let _e1499 = phi_3203_;
                                                let _e1500 = -(_e1470.x);
                                                let _e1501 = -(_e1470.y);
                                                let _e1502 = -(_e1470.z);
                                                if (_e1206.member_5 == 0u) {
                                                    phi_3239_ = 1f;
                                                } else {
                                                    let _e1518 = ((((_e1206.member_8[0] * _e1500) + (_e1206.member_8[1] * _e1501)) + (_e1206.member_8[2] * _e1502)) / sqrt((((_e1500 * _e1500) + (_e1501 * _e1501)) + (_e1502 * _e1502))));
                                                    phi_3239_ = select(0f, _e1518, (_e1518 > 0f));
                                                }
                                                let _e1522 = phi_3239_;
                                                if (_e1492 > 0f) {
                                                    if _e1495 {
                                                        let _e1524 = (_e1522 > 0f);
                                                        if _e1524 {
                                                            let _e1531 = ((1f - select(_e540.member_1, _e540.member_2, (_e540.member_2 > 0f))) * 0.31830987f);
                                                            let _e1539 = ((_e1492 * _e1499) * _e1522);
                                                            phi_3284_ = type_49(type_35(array<f32, 3>(_e1388, _e1424, _e1460), 0f, array<f32, 3>(_e1470.x, _e1470.y, _e1470.z), select(340282350000000000000000000000000000000f, 1f, _e1220)), array<f32, 3>(((_e1206.member_2[0] * (_e540.member[0] * _e1531)) * _e1539), ((_e1206.member_2[1] * (_e540.member[1] * _e1531)) * _e1539), ((_e1206.member_2[2] * (_e540.member[2] * _e1531)) * _e1539)), _e116.member_3);
                                                        } else {
                                                            phi_3284_ = type_49();
                                                        }
                                                        let _e1546 = phi_3284_;
                                                        phi_3287_ = _e1546;
                                                        phi_3288_ = select(true, false, _e1524);
                                                    } else {
                                                        phi_3287_ = type_49();
                                                        phi_3288_ = true;
                                                    }
                                                    let _e1549 = phi_3287_;
                                                    let _e1551 = phi_3288_;
                                                    phi_3290_ = _e1549;
                                                    phi_3291_ = _e1551;
                                                } else {
                                                    phi_3290_ = type_49();
                                                    phi_3291_ = true;
                                                }
                                                let _e1553 = phi_3290_;
                                                let _e1555 = phi_3291_;
                                                if _e1555 {
                                                    phi_3295_ = type_49(type_35(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                                                } else {
                                                    phi_3295_ = _e1553;
                                                }
                                                let _e1557 = phi_3295_;
                                                phi_3297_ = _e1557;
                                            } else {
                                                phi_3297_ = type_49();
                                            }
                                            let _e1559 = phi_3297_;
                                            phi_3301_ = _e1559;
                                            phi_3302_ = select(true, false, _e1327);
                                        }
                                        let _e1562 = phi_3301_;
                                        let _e1564 = phi_3302_;
                                        if _e1564 {
                                            phi_3306_ = type_49(type_35(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                                        } else {
                                            phi_3306_ = _e1562;
                                        }
                                        let _e1566 = phi_3306_;
                                        phi_1654_ = _e1566;
                                    }
                                    let _e2076 = phi_1654_;
                                    phi_1655_ = _e2076;
                                }
                                let _e2078 = phi_1655_;
                                phi_1656_ = _e2078;
                            } else {
                                phi_1656_ = type_49(type_35(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                            }
                            let _e2080 = phi_1656_;
                            phi_1657_ = _e2080;
                        } else {
                            phi_1657_ = type_49(type_35(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                        }
                        let _e2082 = phi_1657_;
                        if _e110 {
                        } else {
                            break;
                        }
                        global_11.member[_e107] = _e2082;
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
