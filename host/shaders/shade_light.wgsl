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
    var phi_295_: i32;
    var phi_319_: array<u32, 3>;
    var phi_334_: array<f32, 3>;
    var phi_352_: array<f32, 3>;
    var phi_370_: array<f32, 3>;
    var phi_457_: array<u32, 3>;
    var phi_474_: vec3<f32>;
    var phi_491_: vec3<f32>;
    var phi_508_: vec3<f32>;
    var phi_642_: i32;
    var phi_673_: i32;
    var phi_692_: vec3<f32>;
    var phi_775_: i32;
    var phi_806_: i32;
    var phi_825_: vec3<f32>;
    var phi_867_: u32;
    var phi_1002_: i32;
    var phi_1083_: type_7;
    var phi_1084_: type_7;
    var phi_1107_: type_7;
    var phi_4318_: bool;
    var phi_1269_: type_7;
    var phi_1272_: u32;
    var phi_1274_: u32;
    var phi_1270_: type_7;
    var phi_1297_: type_7;
    var phi_1313_: u32;
    var phi_1273_: u32;
    var phi_1275_: u32;
    var local_2: u32;
    var phi_1348_: i32;
    var phi_1355_: i32;
    var phi_2651_: f32;
    var phi_2664_: f32;
    var phi_1590_: array<f32, 2>;
    var phi_1619_: type_53;
    var phi_2728_: vec3<f32>;
    var phi_2934_: bool;
    var phi_2937_: bool;
    var phi_2938_: bool;
    var phi_3023_: f32;
    var phi_3027_: f32;
    var phi_3030_: f32;
    var phi_3045_: f32;
    var phi_3049_: f32;
    var phi_3051_: f32;
    var phi_3072_: f32;
    var phi_3076_: f32;
    var phi_3079_: f32;
    var phi_3094_: f32;
    var phi_3098_: f32;
    var phi_3100_: f32;
    var phi_3121_: f32;
    var phi_3125_: f32;
    var phi_3128_: f32;
    var phi_3143_: f32;
    var phi_3147_: f32;
    var phi_3149_: f32;
    var phi_3170_: vec3<f32>;
    var phi_3204_: bool;
    var phi_3210_: f32;
    var phi_3246_: f32;
    var phi_3291_: type_49;
    var phi_3294_: type_49;
    var phi_3295_: bool;
    var phi_3297_: type_49;
    var phi_3298_: bool;
    var phi_3302_: type_49;
    var phi_3304_: type_49;
    var phi_3308_: type_49;
    var phi_3309_: bool;
    var phi_3313_: type_49;
    var phi_3615_: vec3<f32>;
    var phi_3821_: bool;
    var phi_3824_: bool;
    var phi_3825_: bool;
    var phi_3910_: f32;
    var phi_3914_: f32;
    var phi_3917_: f32;
    var phi_3932_: f32;
    var phi_3936_: f32;
    var phi_3938_: f32;
    var phi_3959_: f32;
    var phi_3963_: f32;
    var phi_3966_: f32;
    var phi_3981_: f32;
    var phi_3985_: f32;
    var phi_3987_: f32;
    var phi_4008_: f32;
    var phi_4012_: f32;
    var phi_4015_: f32;
    var phi_4030_: f32;
    var phi_4034_: f32;
    var phi_4036_: f32;
    var phi_4057_: vec3<f32>;
    var phi_4091_: bool;
    var phi_4097_: f32;
    var phi_4133_: f32;
    var phi_4178_: type_49;
    var phi_4181_: type_49;
    var phi_4182_: bool;
    var phi_4184_: type_49;
    var phi_4185_: bool;
    var phi_4189_: type_49;
    var phi_4191_: type_49;
    var phi_4195_: type_49;
    var phi_4196_: bool;
    var phi_4200_: type_49;
    var phi_3391_: f32;
    var phi_3395_: f32;
    var phi_3398_: f32;
    var phi_3413_: f32;
    var phi_3417_: f32;
    var phi_3419_: f32;
    var phi_3440_: f32;
    var phi_3444_: f32;
    var phi_3447_: f32;
    var phi_3462_: f32;
    var phi_3466_: f32;
    var phi_3468_: f32;
    var phi_3489_: f32;
    var phi_3493_: f32;
    var phi_3496_: f32;
    var phi_3511_: f32;
    var phi_3515_: f32;
    var phi_3517_: f32;
    var phi_3538_: vec3<f32>;
    var phi_3552_: type_49;
    var phi_1661_: type_49;
    var phi_1662_: type_49;
    var phi_1663_: type_49;
    var phi_1664_: type_49;

    switch bitcast<i32>(0u) {
        default: {
            let _e86 = global;
            let _e89 = arrayLength((&global_4.member));
            let _e94 = arrayLength((&global_6.member));
            let _e98 = arrayLength((&global_8.member));
            let _e108 = (_e86.x + (_e86.y * 2097152u));
            let _e109 = (_e108 < arrayLength((&global_10.member)));
            if _e109 {
                let _e110 = (_e108 < arrayLength((&global_9.member)));
                if _e110 {
                    let _e111 = (_e108 < arrayLength((&global_11.member)));
                    if _e111 {
                        if _e109 {
                        } else {
                            break;
                        }
                        let _e114 = global_10.member[_e108];
                        if _e110 {
                        } else {
                            break;
                        }
                        let _e117 = global_9.member[_e108];
                        if (_e114.member.member_1 <= _e114.member.member_3) {
                            if (_e117.member_3 != 4294967295u) {
                                if (_e98 == 0u) {
                                    phi_1662_ = type_49(type_35(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                                } else {
                                    let _e128 = global_1.member[0u];
                                    let _e129 = bitcast<i32>(_e128);
                                    let _e130 = (_e129 < -126i);
                                    if _e130 {
                                        phi_295_ = -126i;
                                    } else {
                                        phi_295_ = select(_e129, 127i, (_e129 > 127i));
                                    }
                                    let _e134 = phi_295_;
                                    let _e139 = bitcast<f32>((bitcast<u32>((_e134 + 127i)) << bitcast<u32>(23i)));
                                    let _e145 = bitcast<f32>((bitcast<u32>(((_e129 - _e134) + 127i)) << bitcast<u32>(23i)));
                                    let _e146 = (_e117.member_3 < arrayLength((&global_5.member)));
                                    if _e146 {
                                        if _e146 {
                                        } else {
                                            break;
                                        }
                                        let _e148 = global_5.member[_e117.member_3];
                                        phi_319_ = _e148;
                                    } else {
                                        phi_319_ = array<u32, 3>(0u, 0u, 0u);
                                    }
                                    let _e150 = phi_319_;
                                    let _e152 = (_e150[0] < _e89);
                                    if _e152 {
                                        if _e152 {
                                        } else {
                                            break;
                                        }
                                        let _e154 = global_4.member[_e150[0]];
                                        phi_334_ = _e154;
                                    } else {
                                        phi_334_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e156 = phi_334_;
                                    let _e161 = (_e150[1] < _e89);
                                    if _e161 {
                                        if _e161 {
                                        } else {
                                            break;
                                        }
                                        let _e163 = global_4.member[_e150[1]];
                                        phi_352_ = _e163;
                                    } else {
                                        phi_352_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e165 = phi_352_;
                                    let _e170 = (_e150[2] < _e89);
                                    if _e170 {
                                        if _e170 {
                                        } else {
                                            break;
                                        }
                                        let _e172 = global_4.member[_e150[2]];
                                        phi_370_ = _e172;
                                    } else {
                                        phi_370_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e174 = phi_370_;
                                    let _e179 = ((_e156[0] * _e139) * _e145);
                                    let _e181 = select(_e179, 0f, (_e179 == 0f));
                                    let _e183 = ((_e156[1] * _e139) * _e145);
                                    let _e185 = select(_e183, 0f, (_e183 == 0f));
                                    let _e187 = ((_e156[2] * _e139) * _e145);
                                    let _e189 = select(_e187, 0f, (_e187 == 0f));
                                    let _e191 = ((_e165[0] * _e139) * _e145);
                                    let _e193 = select(_e191, 0f, (_e191 == 0f));
                                    let _e195 = ((_e165[1] * _e139) * _e145);
                                    let _e197 = select(_e195, 0f, (_e195 == 0f));
                                    let _e199 = ((_e165[2] * _e139) * _e145);
                                    let _e201 = select(_e199, 0f, (_e199 == 0f));
                                    let _e203 = ((_e174[0] * _e139) * _e145);
                                    let _e205 = select(_e203, 0f, (_e203 == 0f));
                                    let _e207 = ((_e174[1] * _e139) * _e145);
                                    let _e209 = select(_e207, 0f, (_e207 == 0f));
                                    let _e211 = ((_e174[2] * _e139) * _e145);
                                    let _e213 = select(_e211, 0f, (_e211 == 0f));
                                    let _e214 = vec3<f32>(_e181, _e185, _e189);
                                    if _e146 {
                                        if _e146 {
                                        } else {
                                            break;
                                        }
                                        let _e216 = global_5.member[_e117.member_3];
                                        phi_457_ = _e216;
                                    } else {
                                        phi_457_ = array<u32, 3>(0u, 0u, 0u);
                                    }
                                    let _e218 = phi_457_;
                                    let _e220 = (_e218[0] < _e94);
                                    if _e220 {
                                        if _e220 {
                                        } else {
                                            break;
                                        }
                                        let _e223 = global_6.member[_e218[0]];
                                        phi_474_ = vec3<f32>(_e223[0], _e223[1], _e223[2]);
                                    } else {
                                        phi_474_ = vec3<f32>(0f, 0f, 0f);
                                    }
                                    let _e229 = phi_474_;
                                    let _e231 = (_e218[1] < _e94);
                                    if _e231 {
                                        if _e231 {
                                        } else {
                                            break;
                                        }
                                        let _e234 = global_6.member[_e218[1]];
                                        phi_491_ = vec3<f32>(_e234[0], _e234[1], _e234[2]);
                                    } else {
                                        phi_491_ = vec3<f32>(0f, 0f, 0f);
                                    }
                                    let _e240 = phi_491_;
                                    let _e242 = (_e218[2] < _e94);
                                    if _e242 {
                                        if _e242 {
                                        } else {
                                            break;
                                        }
                                        let _e245 = global_6.member[_e218[2]];
                                        phi_508_ = vec3<f32>(_e245[0], _e245[1], _e245[2]);
                                    } else {
                                        phi_508_ = vec3<f32>(0f, 0f, 0f);
                                    }
                                    let _e251 = phi_508_;
                                    let _e260 = ((1f - _e117.member_1) - _e117.member_2);
                                    let _e262 = select(0f, _e260, (_e260 > 0f));
                                    let _e264 = select(1f, _e117.member_1, (_e117.member_1 < 1f));
                                    let _e266 = select(1f, _e117.member_2, (_e117.member_2 < 1f));
                                    let _e267 = (_e181 * _e262);
                                    let _e268 = (_e185 * _e262);
                                    let _e269 = (_e189 * _e262);
                                    let _e270 = (_e193 * _e264);
                                    let _e271 = (_e197 * _e264);
                                    let _e272 = (_e201 * _e264);
                                    let _e273 = (_e205 * _e266);
                                    let _e274 = (_e209 * _e266);
                                    let _e275 = (_e213 * _e266);
                                    let _e279 = ((_e267 + _e270) + _e273);
                                    let _e280 = ((_e268 + _e271) + _e274);
                                    let _e281 = ((_e269 + _e272) + _e275);
                                    let _e315 = (((bitcast<f32>((bitcast<u32>(_e267) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e270) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e273) & 2147483647u))) * 0.00000071525625f);
                                    let _e316 = (((bitcast<f32>((bitcast<u32>(_e268) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e271) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e274) & 2147483647u))) * 0.00000071525625f);
                                    let _e317 = (((bitcast<f32>((bitcast<u32>(_e269) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e272) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e275) & 2147483647u))) * 0.00000071525625f);
                                    let _e318 = (_e193 - _e181);
                                    let _e319 = (_e197 - _e185);
                                    let _e320 = (_e201 - _e189);
                                    let _e321 = (_e205 - _e181);
                                    let _e322 = (_e209 - _e185);
                                    let _e323 = (_e213 - _e189);
                                    let _e324 = (_e319 * _e323);
                                    let _e326 = (_e324 - (_e322 * _e320));
                                    let _e327 = (_e320 * _e321);
                                    let _e329 = (_e327 - (_e323 * _e318));
                                    let _e330 = (_e318 * _e322);
                                    let _e332 = (_e330 - (_e321 * _e319));
                                    let _e335 = bitcast<f32>((bitcast<u32>(_e326) & 2147483647u));
                                    let _e338 = bitcast<f32>((bitcast<u32>(_e329) & 2147483647u));
                                    let _e340 = select(_e338, _e335, (_e335 > _e338));
                                    let _e343 = bitcast<f32>((bitcast<u32>(_e332) & 2147483647u));
                                    let _e345 = select(_e343, _e340, (_e340 > _e343));
                                    if (_e345 < 0.000000000000000000000000000000000000011754944f) {
                                        phi_692_ = vec3<f32>(0f, 0f, 0f);
                                    } else {
                                        let _e348 = (bitcast<u32>(_e345) & 2147483647u);
                                        let _e349 = (_e348 >= 8388608u);
                                        if _e349 {
                                            phi_642_ = (bitcast<i32>((_e348 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_642_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e348)), 32u, (_e348 == 0u))));
                                        }
                                        let _e362 = phi_642_;
                                        let _e369 = bitcast<f32>((bitcast<u32>(((_e362 / -2i) + 127i)) << bitcast<u32>(23i)));
                                        if _e349 {
                                            phi_673_ = (bitcast<i32>((_e348 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_673_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e348)), 32u, (_e348 == 0u))));
                                        }
                                        let _e385 = phi_673_;
                                        let _e391 = bitcast<f32>((bitcast<u32>((((_e362 / 2i) - _e385) + 127i)) << bitcast<u32>(23i)));
                                        let _e392 = ((_e326 * _e369) * _e391);
                                        let _e393 = ((_e329 * _e369) * _e391);
                                        let _e394 = ((_e332 * _e369) * _e391);
                                        let _e400 = sqrt((((_e392 * _e392) + (_e393 * _e393)) + (_e394 * _e394)));
                                        phi_692_ = vec3<f32>((_e392 / _e400), (_e393 / _e400), (_e394 / _e400));
                                    }
                                    let _e406 = phi_692_;
                                    let _e416 = select(1f, -1f, ((((_e406.x * _e114.member.member_2[0]) + (_e406.y * _e114.member.member_2[1])) + (_e406.z * _e114.member.member_2[2])) > 0f));
                                    let _e420 = (_e406 * _e416);
                                    let _e442 = (((_e229.x * _e262) + (_e240.x * _e264)) + (_e251.x * _e266));
                                    let _e443 = (((_e229.y * _e262) + (_e240.y * _e264)) + (_e251.y * _e266));
                                    let _e444 = (((_e229.z * _e262) + (_e240.z * _e264)) + (_e251.z * _e266));
                                    let _e447 = bitcast<f32>((bitcast<u32>(_e442) & 2147483647u));
                                    let _e450 = bitcast<f32>((bitcast<u32>(_e443) & 2147483647u));
                                    let _e452 = select(_e450, _e447, (_e447 > _e450));
                                    let _e455 = bitcast<f32>((bitcast<u32>(_e444) & 2147483647u));
                                    let _e457 = select(_e455, _e452, (_e452 > _e455));
                                    if (_e457 < 0.000000000000000000000000000000000000011754944f) {
                                        phi_825_ = vec3<f32>(0f, 0f, 0f);
                                    } else {
                                        let _e460 = (bitcast<u32>(_e457) & 2147483647u);
                                        let _e461 = (_e460 >= 8388608u);
                                        if _e461 {
                                            phi_775_ = (bitcast<i32>((_e460 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_775_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e460)), 32u, (_e460 == 0u))));
                                        }
                                        let _e474 = phi_775_;
                                        let _e481 = bitcast<f32>((bitcast<u32>(((_e474 / -2i) + 127i)) << bitcast<u32>(23i)));
                                        if _e461 {
                                            phi_806_ = (bitcast<i32>((_e460 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_806_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e460)), 32u, (_e460 == 0u))));
                                        }
                                        let _e497 = phi_806_;
                                        let _e503 = bitcast<f32>((bitcast<u32>((((_e474 / 2i) - _e497) + 127i)) << bitcast<u32>(23i)));
                                        let _e504 = ((_e442 * _e481) * _e503);
                                        let _e505 = ((_e443 * _e481) * _e503);
                                        let _e506 = ((_e444 * _e481) * _e503);
                                        let _e512 = sqrt((((_e504 * _e504) + (_e505 * _e505)) + (_e506 * _e506)));
                                        phi_825_ = vec3<f32>((_e504 / _e512), (_e505 / _e512), (_e506 / _e512));
                                    }
                                    let _e518 = phi_825_;
                                    let _e533 = select(_e420, (_e518 * _e416), vec3((((((_e518.x * _e416) * (_e406.x * _e416)) + ((_e518.y * _e416) * (_e406.y * _e416))) + ((_e518.z * _e416) * (_e406.z * _e416))) > 0f)));
                                    let _e534 = (_e117.member_3 < arrayLength((&global_7.member)));
                                    if _e534 {
                                        if _e534 {
                                        } else {
                                            break;
                                        }
                                        let _e537 = global_7.member[_e117.member_3];
                                        phi_867_ = _e537;
                                    } else {
                                        phi_867_ = 0u;
                                    }
                                    let _e539 = phi_867_;
                                    let _e541 = select(_e539, 0u, (_e539 >= _e98));
                                    if (_e541 < _e98) {
                                    } else {
                                        break;
                                    }
                                    let _e545 = global_8.member[_e541];
                                    let _e552 = global_3.member[0u];
                                    let _e555 = global_3.member[1u];
                                    let _e558 = global_2.member[0u];
                                    let _e568 = global_2.member[0u][3u];
                                    let _e571 = global_2.member[1u];
                                    let _e581 = global_2.member[1u][3u];
                                    let _e585 = global_2.member[2u];
                                    let _e595 = global_2.member[2u][3u];
                                    let _e598 = global_2.member[3u];
                                    let _e608 = global_2.member[3u][3u];
                                    let _e611 = global_2.member[4u];
                                    let _e621 = global_2.member[4u][3u];
                                    local_1 = type_53(array<f32, 3>(bitcast<f32>(_e558.x), bitcast<f32>(_e558.y), bitcast<f32>(_e558.z)), _e568, array<f32, 3>(bitcast<f32>(_e571.x), bitcast<f32>(_e571.y), bitcast<f32>(_e571.z)), bitcast<f32>(_e581), array<f32, 3>(bitcast<f32>(_e585.x), bitcast<f32>(_e585.y), bitcast<f32>(_e585.z)), _e595, array<f32, 3>(bitcast<f32>(_e598.x), bitcast<f32>(_e598.y), bitcast<f32>(_e598.z)), _e608, array<f32, 3>(bitcast<f32>(_e611.x), bitcast<f32>(_e611.y), bitcast<f32>(_e611.z)), _e621);
                                    if _e130 {
                                        phi_1002_ = -126i;
                                    } else {
                                        phi_1002_ = select(_e129, 127i, (_e129 > 127i));
                                    }
                                    let _e631 = phi_1002_;
                                    let _e636 = bitcast<f32>((bitcast<u32>((_e631 + 127i)) << bitcast<u32>(23i)));
                                    let _e642 = bitcast<f32>((bitcast<u32>(((_e129 - _e631) + 127i)) << bitcast<u32>(23i)));
                                    let _e643 = local_1;
                                    local = _e643;
                                    let _e645 = local_1.member_1;
                                    if (_e645 == 1u) {
                                        let _e648 = local_1.member;
                                        local.member = array<f32, 3>(((_e648[0] * _e636) * _e642), ((_e648[1] * _e636) * _e642), ((_e648[2] * _e636) * _e642));
                                        let _e661 = local_1.member_4;
                                        local.member_4 = array<f32, 3>(((_e661[0] * _e636) * _e642), ((_e661[1] * _e636) * _e642), ((_e661[2] * _e636) * _e642));
                                        let _e674 = local_1.member_6;
                                        local.member_6 = array<f32, 3>(((_e674[0] * _e636) * _e642), ((_e674[1] * _e636) * _e642), ((_e674[2] * _e636) * _e642));
                                        phi_1083_ = type_7(0u, 3u);
                                        loop {
                                            let _e687 = phi_1083_;
                                            if (_e687.member < _e687.member_1) {
                                                phi_1084_ = type_7((_e687.member + 1u), _e687.member_1);
                                                phi_1107_ = type_7(1u, _e687.member);
                                            } else {
                                                phi_1084_ = _e687;
                                                phi_1107_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e700 = phi_1084_;
                                            let _e702 = phi_1107_;
                                            let _e706 = (bitcast<i32>(_e702.member) != 0i);
                                            if _e706 {
                                                let _e707 = (_e702.member_1 < 3u);
                                                if _e707 {
                                                } else {
                                                    phi_4318_ = true;
                                                    break;
                                                }
                                                let _e710 = local_1.member_2[_e702.member_1];
                                                let _e714 = ((((_e710 * _e636) * _e642) * _e636) * _e642);
                                                if _e707 {
                                                } else {
                                                    phi_4318_ = true;
                                                    break;
                                                }
                                                local.member_2[_e702.member_1] = select(340282350000000000000000000000000000000f, _e714, (_e714 < 340282350000000000000000000000000000000f));
                                            }
                                            continue;
                                            continuing {
                                                phi_1083_ = _e700;
                                                phi_4318_ = false;
                                                break if !(_e706);
                                            }
                                        }
                                        let _e721 = phi_4318_;
                                        if _e721 {
                                            break;
                                        }
                                        let _e723 = local_1.member_3;
                                        if (_e723 < 340282350000000000000000000000000000000f) {
                                            let _e725 = local_1.member_3;
                                            let _e727 = ((_e725 * _e636) * _e642);
                                            local.member_3 = select(340282350000000000000000000000000000000f, _e727, (_e727 < 340282350000000000000000000000000000000f));
                                        }
                                    }
                                    let _e731 = local;
                                    let _e762 = type_53(array<f32, 3>(_e731.member[0], _e731.member[1], _e731.member[2]), _e731.member_1, array<f32, 3>(_e731.member_2[0], _e731.member_2[1], _e731.member_2[2]), _e731.member_3, array<f32, 3>(_e731.member_4[0], _e731.member_4[1], _e731.member_4[2]), _e731.member_5, array<f32, 3>(_e731.member_6[0], _e731.member_6[1], _e731.member_6[2]), _e731.member_7, array<f32, 3>(_e731.member_8[0], _e731.member_8[1], _e731.member_8[2]), _e731.member_9);
                                    if (_e731.member_5 != 0u) {
                                        let _e766 = select(1u, _e552, (1u < _e552));
                                        let _e767 = (_e766 == 0u);
                                        if _e767 {
                                            break;
                                        }
                                        let _e768 = (_e114.member_4 / _e766);
                                        if _e767 {
                                            break;
                                        }
                                        let _e773 = ((_e768 ^ (_e768 >> bitcast<u32>(16i))) * 569420461u);
                                        let _e777 = ((_e773 ^ (_e773 >> bitcast<u32>(15i))) * 3545902487u);
                                        let _e781 = ((_e777 ^ (_e777 >> bitcast<u32>(15i))) + _e555);
                                        let _e785 = ((_e781 ^ (_e781 >> bitcast<u32>(16i))) * 569420461u);
                                        let _e789 = ((_e785 ^ (_e785 >> bitcast<u32>(15i))) * 3545902487u);
                                        let _e793 = ((_e789 ^ (_e789 >> bitcast<u32>(15i))) + (_e731.member_7 + 1u));
                                        let _e797 = ((_e793 ^ (_e793 >> bitcast<u32>(16i))) * 569420461u);
                                        let _e801 = ((_e797 ^ (_e797 >> bitcast<u32>(15i))) * 3545902487u);
                                        let _e804 = (_e801 ^ (_e801 >> bitcast<u32>(15i)));
                                        let _e806 = (reverseBits((_e114.member_4 % _e766)) + _e804);
                                        let _e808 = (_e806 ^ (_e806 * 1817228412u));
                                        let _e810 = (_e808 ^ (_e808 * 3090095698u));
                                        let _e812 = (_e810 ^ (_e810 * 3350193720u));
                                        let _e815 = reverseBits((_e812 ^ (_e812 * 2367878886u)));
                                        let _e817 = (_e804 ^ 1u);
                                        let _e821 = ((_e817 ^ (_e817 >> bitcast<u32>(16i))) * 569420461u);
                                        let _e825 = ((_e821 ^ (_e821 >> bitcast<u32>(15i))) * 3545902487u);
                                        let _e830 = (reverseBits(reverseBits(_e815)) + (_e825 ^ (_e825 >> bitcast<u32>(15i))));
                                        let _e832 = (_e830 ^ (_e830 * 1817228412u));
                                        let _e834 = (_e832 ^ (_e832 * 3090095698u));
                                        let _e836 = (_e834 ^ (_e834 * 3350193720u));
                                        let _e839 = reverseBits((_e836 ^ (_e836 * 2367878886u)));
                                        phi_1269_ = type_7(0u, 32u);
                                        phi_1272_ = 2147483648u;
                                        phi_1274_ = 0u;
                                        loop {
                                            let _e841 = phi_1269_;
                                            let _e843 = phi_1272_;
                                            let _e845 = phi_1274_;
                                            local_2 = _e845;
                                            if (_e841.member < _e841.member_1) {
                                                phi_1270_ = type_7((_e841.member + 1u), _e841.member_1);
                                                phi_1297_ = type_7(1u, _e841.member);
                                            } else {
                                                phi_1270_ = _e841;
                                                phi_1297_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e858 = phi_1270_;
                                            let _e860 = phi_1297_;
                                            let _e864 = (bitcast<i32>(_e860.member) != 0i);
                                            if _e864 {
                                                if (((_e815 >> bitcast<u32>((_e860.member_1 & 31u))) & 1u) == 1u) {
                                                    phi_1313_ = (_e845 ^ _e843);
                                                } else {
                                                    phi_1313_ = _e845;
                                                }
                                                let _e872 = phi_1313_;
                                                phi_1273_ = (_e843 ^ (_e843 >> bitcast<u32>(1i)));
                                                phi_1275_ = _e872;
                                            } else {
                                                phi_1273_ = u32();
                                                phi_1275_ = u32();
                                            }
                                            let _e877 = phi_1273_;
                                            let _e879 = phi_1275_;
                                            continue;
                                            continuing {
                                                phi_1269_ = _e858;
                                                phi_1272_ = _e877;
                                                phi_1274_ = _e879;
                                                break if !(_e864);
                                            }
                                        }
                                        let _e881 = (_e804 ^ 2u);
                                        let _e885 = ((_e881 ^ (_e881 >> bitcast<u32>(16i))) * 569420461u);
                                        let _e889 = ((_e885 ^ (_e885 >> bitcast<u32>(15i))) * 3545902487u);
                                        let _e894 = local_2;
                                        let _e896 = (reverseBits(_e894) + (_e889 ^ (_e889 >> bitcast<u32>(15i))));
                                        let _e898 = (_e896 ^ (_e896 * 1817228412u));
                                        let _e900 = (_e898 ^ (_e898 * 3090095698u));
                                        let _e902 = (_e900 ^ (_e900 * 3350193720u));
                                        let _e905 = reverseBits((_e902 ^ (_e902 * 2367878886u)));
                                        if (_e731.member_5 == 1u) {
                                            let _e928 = bitcast<i32>(((2u * (_e839 >> bitcast<u32>(16i))) + 1u));
                                            let _e929 = (_e928 - 65536i);
                                            let _e934 = bitcast<i32>(((2u * (_e905 >> bitcast<u32>(16i))) + 1u));
                                            let _e935 = (_e934 - 65536i);
                                            let _e936 = (_e929 < 0i);
                                            if _e936 {
                                                phi_1348_ = (65536i - _e928);
                                            } else {
                                                phi_1348_ = _e929;
                                            }
                                            let _e939 = phi_1348_;
                                            let _e940 = bitcast<u32>(_e939);
                                            let _e941 = (_e935 < 0i);
                                            if _e941 {
                                                phi_1355_ = (65536i - _e934);
                                            } else {
                                                phi_1355_ = _e935;
                                            }
                                            let _e944 = phi_1355_;
                                            let _e945 = bitcast<u32>(_e944);
                                            let _e946 = (_e940 > _e945);
                                            let _e947 = select(_e945, _e940, _e946);
                                            let _e952 = select(1u, _e947, (1u < _e947));
                                            if (_e952 == 0u) {
                                                break;
                                            }
                                            let _e956 = (((select(_e940, _e945, _e946) << bitcast<u32>(16i)) / _e952) << bitcast<u32>(15i));
                                            let _e958 = (_e956 >> bitcast<u32>(16i));
                                            let _e959 = (_e956 & 65535u);
                                            let _e964 = ((_e958 * _e959) + ((_e959 * _e959) >> bitcast<u32>(16i)));
                                            let _e976 = ((((_e958 * _e958) + (_e964 >> bitcast<u32>(16i))) + (((_e959 * _e958) + (_e964 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i));
                                            let _e978 = (_e976 >> bitcast<u32>(16i));
                                            let _e979 = (_e976 & 65535u);
                                            let _e984 = ((_e978 * 7711u) + ((_e979 * 7711u) >> bitcast<u32>(16i)));
                                            let _e993 = (700062u - (((_e984 >> bitcast<u32>(16i)) + ((_e984 & 65535u) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                                            let _e995 = (_e993 >> bitcast<u32>(16i));
                                            let _e996 = (_e993 & 65535u);
                                            let _e1001 = ((_e978 * _e996) + ((_e979 * _e996) >> bitcast<u32>(16i)));
                                            let _e1014 = (34046945u - ((((_e978 * _e995) + (_e1001 >> bitcast<u32>(16i))) + (((_e979 * _e995) + (_e1001 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                                            let _e1016 = (_e1014 >> bitcast<u32>(16i));
                                            let _e1017 = (_e1014 & 65535u);
                                            let _e1022 = ((_e978 * _e1017) + ((_e979 * _e1017) >> bitcast<u32>(16i)));
                                            let _e1035 = (662337939u - ((((_e978 * _e1016) + (_e1022 >> bitcast<u32>(16i))) + (((_e979 * _e1016) + (_e1022 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                                            let _e1040 = ((_e978 * 13011u) + ((_e979 * 13011u) >> bitcast<u32>(16i)));
                                            let _e1051 = (5348082u - (((_e978 + (_e1040 >> bitcast<u32>(16i))) + ((_e979 + (_e1040 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                                            let _e1053 = (_e1051 >> bitcast<u32>(16i));
                                            let _e1054 = (_e1051 & 65535u);
                                            let _e1059 = ((_e978 * _e1054) + ((_e979 * _e1054) >> bitcast<u32>(16i)));
                                            let _e1072 = (173399667u - ((((_e978 * _e1053) + (_e1059 >> bitcast<u32>(16i))) + (((_e979 * _e1053) + (_e1059 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                                            let _e1074 = (_e1072 >> bitcast<u32>(16i));
                                            let _e1075 = (_e1072 & 65535u);
                                            let _e1080 = ((_e978 * _e1075) + ((_e979 * _e1075) >> bitcast<u32>(16i)));
                                            let _e1093 = (1686629713u - ((((_e978 * _e1074) + (_e1080 >> bitcast<u32>(16i))) + (((_e979 * _e1074) + (_e1080 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                                            let _e1095 = (_e1035 >> bitcast<u32>(16i));
                                            let _e1096 = (_e1035 & 65535u);
                                            let _e1101 = ((_e978 * _e1096) + ((_e979 * _e1096) >> bitcast<u32>(16i)));
                                            let _e1114 = (2147483648u - ((((_e978 * _e1095) + (_e1101 >> bitcast<u32>(16i))) + (((_e979 * _e1095) + (_e1101 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                                            let _e1116 = (_e1093 >> bitcast<u32>(16i));
                                            let _e1117 = (_e1093 & 65535u);
                                            let _e1122 = ((_e958 * _e1117) + ((_e959 * _e1117) >> bitcast<u32>(16i)));
                                            let _e1134 = ((((_e958 * _e1116) + (_e1122 >> bitcast<u32>(16i))) + (((_e959 * _e1116) + (_e1122 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i));
                                            let _e1136 = (_e947 << bitcast<u32>(15i));
                                            let _e1138 = (_e1136 >> bitcast<u32>(16i));
                                            let _e1139 = (_e1136 & 65535u);
                                            let _e1141 = (_e1114 >> bitcast<u32>(16i));
                                            let _e1142 = (_e1114 & 65535u);
                                            let _e1147 = ((_e1138 * _e1142) + ((_e1139 * _e1142) >> bitcast<u32>(16i)));
                                            let _e1159 = ((((_e1138 * _e1141) + (_e1147 >> bitcast<u32>(16i))) + (((_e1139 * _e1141) + (_e1147 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i));
                                            let _e1161 = (_e1134 >> bitcast<u32>(16i));
                                            let _e1162 = (_e1134 & 65535u);
                                            let _e1167 = ((_e1138 * _e1162) + ((_e1139 * _e1162) >> bitcast<u32>(16i)));
                                            let _e1179 = ((((_e1138 * _e1161) + (_e1167 >> bitcast<u32>(16i))) + (((_e1139 * _e1161) + (_e1167 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i));
                                            let _e1184 = f32((select(_e1179, _e1159, _e946) >> bitcast<u32>(7i)));
                                            if _e936 {
                                                phi_2651_ = (_e1184 * -0.000000059604645f);
                                            } else {
                                                phi_2651_ = (_e1184 * 0.000000059604645f);
                                            }
                                            let _e1188 = phi_2651_;
                                            let _e1191 = f32((select(_e1159, _e1179, _e946) >> bitcast<u32>(7i)));
                                            if _e941 {
                                                phi_2664_ = (_e1191 * -0.000000059604645f);
                                            } else {
                                                phi_2664_ = (_e1191 * 0.000000059604645f);
                                            }
                                            let _e1195 = phi_2664_;
                                            phi_1590_ = array<f32, 2>(_e1188, _e1195);
                                        } else {
                                            phi_1590_ = array<f32, 2>((f32((bitcast<i32>(((2u * (_e839 >> bitcast<u32>(9i))) + 1u)) - 8388608i)) * 0.00000011920929f), (f32((bitcast<i32>(((2u * (_e905 >> bitcast<u32>(9i))) + 1u)) - 8388608i)) * 0.00000011920929f));
                                        }
                                        let _e1198 = phi_1590_;
                                        phi_1619_ = type_53(array<f32, 3>((_e731.member[0] + ((_e731.member_4[0] * _e1198[0]) + (_e731.member_6[0] * _e1198[1]))), (_e731.member[1] + ((_e731.member_4[1] * _e1198[0]) + (_e731.member_6[1] * _e1198[1]))), (_e731.member[2] + ((_e731.member_4[2] * _e1198[0]) + (_e731.member_6[2] * _e1198[1])))), _e762.member_1, _e762.member_2, _e762.member_3, _e762.member_4, _e762.member_5, _e762.member_6, _e762.member_7, _e762.member_8, _e762.member_9);
                                    } else {
                                        phi_1619_ = _e762;
                                    }
                                    let _e1226 = phi_1619_;
                                    let _e1235 = global_3.member[2u];
                                    if (_e1235 == 1u) {
                                        let _e1590 = (_e1226.member_1 == 1u);
                                        if _e1590 {
                                            phi_3615_ = (vec3<f32>(_e1226.member[0], _e1226.member[1], _e1226.member[2]) - _e214);
                                        } else {
                                            phi_3615_ = vec3<f32>(_e1226.member[0], _e1226.member[1], _e1226.member[2]);
                                        }
                                        let _e1601 = phi_3615_;
                                        let _e1603 = bitcast<f32>(bitcast<u32>(_e330));
                                        let _e1606 = bitcast<f32>(bitcast<u32>((_e319 * _e321)));
                                        let _e1608 = bitcast<f32>(bitcast<u32>(_e324));
                                        let _e1611 = bitcast<f32>(bitcast<u32>((_e320 * _e322)));
                                        let _e1613 = bitcast<f32>(bitcast<u32>(_e327));
                                        let _e1616 = bitcast<f32>(bitcast<u32>((_e318 * _e323)));
                                        let _e1680 = global_12[0u];
                                        if (_e1226.member_2[0] == _e1680) {
                                            let _e1683 = global_12[1u];
                                            let _e1684 = (_e1226.member_2[1] == _e1683);
                                            if _e1684 {
                                                let _e1686 = global_12[2u];
                                                phi_3821_ = (_e1226.member_2[2] == _e1686);
                                            } else {
                                                phi_3821_ = bool();
                                            }
                                            let _e1689 = phi_3821_;
                                            phi_3824_ = _e1689;
                                            phi_3825_ = select(true, false, _e1684);
                                        } else {
                                            phi_3824_ = bool();
                                            phi_3825_ = true;
                                        }
                                        let _e1692 = phi_3824_;
                                        let _e1694 = phi_3825_;
                                        if select(_e1692, false, _e1694) {
                                            phi_4195_ = type_49();
                                            phi_4196_ = true;
                                        } else {
                                            let _e1697 = ((((bitcast<f32>(bitcast<u32>((_e1601.x * (_e1608 - _e1611)))) + bitcast<f32>(bitcast<u32>((_e1601.y * (_e1613 - _e1616))))) + bitcast<f32>(bitcast<u32>((_e1601.z * (_e1603 - _e1606))))) * _e416) > (bitcast<f32>(bitcast<u32>((0.0000009536752f * ((bitcast<f32>(bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1601.x) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e1608) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1611) & 2147483647u)))))) + bitcast<f32>(bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1601.y) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e1613) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1616) & 2147483647u))))))) + bitcast<f32>(bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1601.z) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e1603) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1606) & 2147483647u)))))))))) + 0.0000000000000000000000000000000000001880791f));
                                            if _e1697 {
                                                let _e1699 = select(_e316, _e315, (_e315 > _e316));
                                                let _e1716 = (select(_e317, _e1699, (_e1699 > _e317)) * ((bitcast<f32>((bitcast<u32>(_e420.x) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e420.y) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e420.z) & 2147483647u))));
                                                let _e1720 = (_e279 + (_e420.x * _e1716));
                                                let _e1721 = (_e280 + (_e420.y * _e1716));
                                                let _e1722 = (_e281 + (_e420.z * _e1716));
                                                if (_e420.x > 0f) {
                                                    let _e1743 = bitcast<u32>(_e1720);
                                                    if ((_e1743 & 2147483647u) == 0u) {
                                                        phi_3936_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1743 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_3932_ = bitcast<f32>((_e1743 + 1u));
                                                        } else {
                                                            phi_3932_ = bitcast<f32>((_e1743 - 1u));
                                                        }
                                                        let _e1754 = phi_3932_;
                                                        phi_3936_ = _e1754;
                                                    }
                                                    let _e1756 = phi_3936_;
                                                    phi_3938_ = _e1756;
                                                } else {
                                                    if (_e420.x < 0f) {
                                                        let _e1726 = bitcast<u32>(-(_e1720));
                                                        if ((_e1726 & 2147483647u) == 0u) {
                                                            phi_3914_ = 0.000000000000000000000000000000000000000000001f;
                                                        } else {
                                                            if ((_e1726 >> bitcast<u32>(31i)) == 0u) {
                                                                phi_3910_ = bitcast<f32>((_e1726 + 1u));
                                                            } else {
                                                                phi_3910_ = bitcast<f32>((_e1726 - 1u));
                                                            }
                                                            let _e1737 = phi_3910_;
                                                            phi_3914_ = _e1737;
                                                        }
                                                        let _e1739 = phi_3914_;
                                                        phi_3917_ = -(_e1739);
                                                    } else {
                                                        phi_3917_ = _e1720;
                                                    }
                                                    let _e1742 = phi_3917_;
                                                    phi_3938_ = _e1742;
                                                }
                                                let _e1758 = phi_3938_;
                                                if (_e420.y > 0f) {
                                                    let _e1779 = bitcast<u32>(_e1721);
                                                    if ((_e1779 & 2147483647u) == 0u) {
                                                        phi_3985_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1779 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_3981_ = bitcast<f32>((_e1779 + 1u));
                                                        } else {
                                                            phi_3981_ = bitcast<f32>((_e1779 - 1u));
                                                        }
                                                        let _e1790 = phi_3981_;
                                                        phi_3985_ = _e1790;
                                                    }
                                                    let _e1792 = phi_3985_;
                                                    phi_3987_ = _e1792;
                                                } else {
                                                    if (_e420.y < 0f) {
                                                        let _e1762 = bitcast<u32>(-(_e1721));
                                                        if ((_e1762 & 2147483647u) == 0u) {
                                                            phi_3963_ = 0.000000000000000000000000000000000000000000001f;
                                                        } else {
                                                            if ((_e1762 >> bitcast<u32>(31i)) == 0u) {
                                                                phi_3959_ = bitcast<f32>((_e1762 + 1u));
                                                            } else {
                                                                phi_3959_ = bitcast<f32>((_e1762 - 1u));
                                                            }
                                                            let _e1773 = phi_3959_;
                                                            phi_3963_ = _e1773;
                                                        }
                                                        let _e1775 = phi_3963_;
                                                        phi_3966_ = -(_e1775);
                                                    } else {
                                                        phi_3966_ = _e1721;
                                                    }
                                                    let _e1778 = phi_3966_;
                                                    phi_3987_ = _e1778;
                                                }
                                                let _e1794 = phi_3987_;
                                                if (_e420.z > 0f) {
                                                    let _e1815 = bitcast<u32>(_e1722);
                                                    if ((_e1815 & 2147483647u) == 0u) {
                                                        phi_4034_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1815 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_4030_ = bitcast<f32>((_e1815 + 1u));
                                                        } else {
                                                            phi_4030_ = bitcast<f32>((_e1815 - 1u));
                                                        }
                                                        let _e1826 = phi_4030_;
                                                        phi_4034_ = _e1826;
                                                    }
                                                    let _e1828 = phi_4034_;
                                                    phi_4036_ = _e1828;
                                                } else {
                                                    if (_e420.z < 0f) {
                                                        let _e1798 = bitcast<u32>(-(_e1722));
                                                        if ((_e1798 & 2147483647u) == 0u) {
                                                            phi_4012_ = 0.000000000000000000000000000000000000000000001f;
                                                        } else {
                                                            if ((_e1798 >> bitcast<u32>(31i)) == 0u) {
                                                                phi_4008_ = bitcast<f32>((_e1798 + 1u));
                                                            } else {
                                                                phi_4008_ = bitcast<f32>((_e1798 - 1u));
                                                            }
                                                            let _e1809 = phi_4008_;
                                                            phi_4012_ = _e1809;
                                                        }
                                                        let _e1811 = phi_4012_;
                                                        phi_4015_ = -(_e1811);
                                                    } else {
                                                        phi_4015_ = _e1722;
                                                    }
                                                    let _e1814 = phi_4015_;
                                                    phi_4036_ = _e1814;
                                                }
                                                let _e1830 = phi_4036_;
                                                if _e1590 {
                                                    phi_4057_ = vec3<f32>((_e1226.member[0] - _e1758), (_e1226.member[1] - _e1794), (_e1226.member[2] - _e1830));
                                                } else {
                                                    phi_4057_ = vec3<f32>(_e1226.member[0], _e1226.member[1], _e1226.member[2]);
                                                }
                                                let _e1840 = phi_4057_;
                                                let _e1853 = sqrt((((_e1840.x * _e1840.x) + (_e1840.y * _e1840.y)) + (_e1840.z * _e1840.z)));
                                                let _e1862 = ((((_e533.x * _e1840.x) + (_e533.y * _e1840.y)) + (_e533.z * _e1840.z)) / _e1853);
                                                if _e1590 {
                                                    phi_4091_ = (_e1853 <= _e1226.member_3);
                                                } else {
                                                    phi_4091_ = true;
                                                }
                                                let _e1865 = phi_4091_;
                                                if _e1590 {
                                                    phi_4097_ = (1f / (_e1853 * _e1853));
                                                } else {
                                                    phi_4097_ = 1f;
                                                }
                                                let _e1869 = phi_4097_;
                                                let _e1870 = -(_e1840.x);
                                                let _e1871 = -(_e1840.y);
                                                let _e1872 = -(_e1840.z);
                                                if (_e1226.member_5 == 0u) {
                                                    phi_4133_ = 1f;
                                                } else {
                                                    let _e1888 = ((((_e1226.member_8[0] * _e1870) + (_e1226.member_8[1] * _e1871)) + (_e1226.member_8[2] * _e1872)) / sqrt((((_e1870 * _e1870) + (_e1871 * _e1871)) + (_e1872 * _e1872))));
                                                    phi_4133_ = select(0f, _e1888, (_e1888 > 0f));
                                                }
                                                let _e1892 = phi_4133_;
                                                if (_e1862 > 0f) {
                                                    if _e1865 {
                                                        let _e1894 = (_e1892 > 0f);
                                                        if _e1894 {
                                                            let _e1901 = ((1f - select(_e545.member_1, _e545.member_2, (_e545.member_2 > 0f))) * 0.31830987f);
                                                            let _e1909 = ((_e1862 * _e1869) * _e1892);
                                                            phi_4178_ = type_49(type_35(array<f32, 3>(_e1758, _e1794, _e1830), 0f, array<f32, 3>(_e1840.x, _e1840.y, _e1840.z), select(340282350000000000000000000000000000000f, 1f, _e1590)), array<f32, 3>(((_e1226.member_2[0] * (_e545.member[0] * _e1901)) * _e1909), ((_e1226.member_2[1] * (_e545.member[1] * _e1901)) * _e1909), ((_e1226.member_2[2] * (_e545.member[2] * _e1901)) * _e1909)), _e117.member_3);
                                                        } else {
                                                            phi_4178_ = type_49();
                                                        }
                                                        let _e1916 = phi_4178_;
                                                        phi_4181_ = _e1916;
                                                        phi_4182_ = select(true, false, _e1894);
                                                    } else {
                                                        phi_4181_ = type_49();
                                                        phi_4182_ = true;
                                                    }
                                                    let _e1919 = phi_4181_;
                                                    let _e1921 = phi_4182_;
                                                    phi_4184_ = _e1919;
                                                    phi_4185_ = _e1921;
                                                } else {
                                                    phi_4184_ = type_49();
                                                    phi_4185_ = true;
                                                }
                                                let _e1923 = phi_4184_;
                                                let _e1925 = phi_4185_;
                                                if _e1925 {
                                                    phi_4189_ = type_49(type_35(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                                                } else {
                                                    phi_4189_ = _e1923;
                                                }
                                                let _e1927 = phi_4189_;
                                                phi_4191_ = _e1927;
                                            } else {
                                                phi_4191_ = type_49();
                                            }
                                            let _e1929 = phi_4191_;
                                            phi_4195_ = _e1929;
                                            phi_4196_ = select(true, false, _e1697);
                                        }
                                        let _e1932 = phi_4195_;
                                        let _e1934 = phi_4196_;
                                        if _e1934 {
                                            phi_4200_ = type_49(type_35(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                                        } else {
                                            phi_4200_ = _e1932;
                                        }
                                        let _e1936 = phi_4200_;
                                        if (_e1936.member.member_1 <= _e1936.member.member_3) {
                                            phi_3552_ = _e1936;
                                        } else {
                                            let _e1943 = select(_e316, _e315, (_e315 > _e316));
                                            let _e1960 = (select(_e317, _e1943, (_e1943 > _e317)) * ((bitcast<f32>((bitcast<u32>(_e420.x) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e420.y) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e420.z) & 2147483647u))));
                                            let _e1964 = (_e279 + (_e420.x * _e1960));
                                            let _e1965 = (_e280 + (_e420.y * _e1960));
                                            let _e1966 = (_e281 + (_e420.z * _e1960));
                                            if (_e420.x > 0f) {
                                                let _e1987 = bitcast<u32>(_e1964);
                                                if ((_e1987 & 2147483647u) == 0u) {
                                                    phi_3417_ = 0.000000000000000000000000000000000000000000001f;
                                                } else {
                                                    if ((_e1987 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_3413_ = bitcast<f32>((_e1987 + 1u));
                                                    } else {
                                                        phi_3413_ = bitcast<f32>((_e1987 - 1u));
                                                    }
                                                    let _e1998 = phi_3413_;
                                                    phi_3417_ = _e1998;
                                                }
                                                let _e2000 = phi_3417_;
                                                phi_3419_ = _e2000;
                                            } else {
                                                if (_e420.x < 0f) {
                                                    let _e1970 = bitcast<u32>(-(_e1964));
                                                    if ((_e1970 & 2147483647u) == 0u) {
                                                        phi_3395_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1970 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_3391_ = bitcast<f32>((_e1970 + 1u));
                                                        } else {
                                                            phi_3391_ = bitcast<f32>((_e1970 - 1u));
                                                        }
                                                        let _e1981 = phi_3391_;
                                                        phi_3395_ = _e1981;
                                                    }
                                                    let _e1983 = phi_3395_;
                                                    phi_3398_ = -(_e1983);
                                                } else {
                                                    phi_3398_ = _e1964;
                                                }
                                                let _e1986 = phi_3398_;
                                                phi_3419_ = _e1986;
                                            }
                                            let _e2002 = phi_3419_;
                                            if (_e420.y > 0f) {
                                                let _e2023 = bitcast<u32>(_e1965);
                                                if ((_e2023 & 2147483647u) == 0u) {
                                                    phi_3466_ = 0.000000000000000000000000000000000000000000001f;
                                                } else {
                                                    if ((_e2023 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_3462_ = bitcast<f32>((_e2023 + 1u));
                                                    } else {
                                                        phi_3462_ = bitcast<f32>((_e2023 - 1u));
                                                    }
                                                    let _e2034 = phi_3462_;
                                                    phi_3466_ = _e2034;
                                                }
                                                let _e2036 = phi_3466_;
                                                phi_3468_ = _e2036;
                                            } else {
                                                if (_e420.y < 0f) {
                                                    let _e2006 = bitcast<u32>(-(_e1965));
                                                    if ((_e2006 & 2147483647u) == 0u) {
                                                        phi_3444_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e2006 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_3440_ = bitcast<f32>((_e2006 + 1u));
                                                        } else {
                                                            phi_3440_ = bitcast<f32>((_e2006 - 1u));
                                                        }
                                                        let _e2017 = phi_3440_;
                                                        phi_3444_ = _e2017;
                                                    }
                                                    let _e2019 = phi_3444_;
                                                    phi_3447_ = -(_e2019);
                                                } else {
                                                    phi_3447_ = _e1965;
                                                }
                                                let _e2022 = phi_3447_;
                                                phi_3468_ = _e2022;
                                            }
                                            let _e2038 = phi_3468_;
                                            if (_e420.z > 0f) {
                                                let _e2059 = bitcast<u32>(_e1966);
                                                if ((_e2059 & 2147483647u) == 0u) {
                                                    phi_3515_ = 0.000000000000000000000000000000000000000000001f;
                                                } else {
                                                    if ((_e2059 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_3511_ = bitcast<f32>((_e2059 + 1u));
                                                    } else {
                                                        phi_3511_ = bitcast<f32>((_e2059 - 1u));
                                                    }
                                                    let _e2070 = phi_3511_;
                                                    phi_3515_ = _e2070;
                                                }
                                                let _e2072 = phi_3515_;
                                                phi_3517_ = _e2072;
                                            } else {
                                                if (_e420.z < 0f) {
                                                    let _e2042 = bitcast<u32>(-(_e1966));
                                                    if ((_e2042 & 2147483647u) == 0u) {
                                                        phi_3493_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e2042 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_3489_ = bitcast<f32>((_e2042 + 1u));
                                                        } else {
                                                            phi_3489_ = bitcast<f32>((_e2042 - 1u));
                                                        }
                                                        let _e2053 = phi_3489_;
                                                        phi_3493_ = _e2053;
                                                    }
                                                    let _e2055 = phi_3493_;
                                                    phi_3496_ = -(_e2055);
                                                } else {
                                                    phi_3496_ = _e1966;
                                                }
                                                let _e2058 = phi_3496_;
                                                phi_3517_ = _e2058;
                                            }
                                            let _e2074 = phi_3517_;
                                            if _e1590 {
                                                phi_3538_ = vec3<f32>((_e1226.member[0] - _e2002), (_e1226.member[1] - _e2038), (_e1226.member[2] - _e2074));
                                            } else {
                                                phi_3538_ = vec3<f32>(_e1226.member[0], _e1226.member[1], _e1226.member[2]);
                                            }
                                            let _e2084 = phi_3538_;
                                            phi_3552_ = type_49(type_35(array<f32, 3>(_e2002, _e2038, _e2074), 0f, array<f32, 3>(_e2084.x, _e2084.y, _e2084.z), select(340282350000000000000000000000000000000f, 1f, _e1590)), array<f32, 3>(0f, 0f, 0f), _e117.member_3);
                                        }
                                        let _e2094 = phi_3552_;
                                        phi_1661_ = _e2094;
                                    } else {
                                        let _e1240 = (_e1226.member_1 == 1u);
                                        if _e1240 {
                                            phi_2728_ = (vec3<f32>(_e1226.member[0], _e1226.member[1], _e1226.member[2]) - _e214);
                                        } else {
                                            phi_2728_ = vec3<f32>(_e1226.member[0], _e1226.member[1], _e1226.member[2]);
                                        }
                                        let _e1251 = phi_2728_;
                                        let _e1253 = bitcast<f32>(bitcast<u32>(_e330));
                                        let _e1256 = bitcast<f32>(bitcast<u32>((_e319 * _e321)));
                                        let _e1258 = bitcast<f32>(bitcast<u32>(_e324));
                                        let _e1261 = bitcast<f32>(bitcast<u32>((_e320 * _e322)));
                                        let _e1263 = bitcast<f32>(bitcast<u32>(_e327));
                                        let _e1266 = bitcast<f32>(bitcast<u32>((_e318 * _e323)));
                                        let _e1330 = global_12[0u];
                                        if (_e1226.member_2[0] == _e1330) {
                                            let _e1333 = global_12[1u];
                                            let _e1334 = (_e1226.member_2[1] == _e1333);
                                            if _e1334 {
                                                let _e1336 = global_12[2u];
                                                phi_2934_ = (_e1226.member_2[2] == _e1336);
                                            } else {
                                                phi_2934_ = bool();
                                            }
                                            let _e1339 = phi_2934_;
                                            phi_2937_ = _e1339;
                                            phi_2938_ = select(true, false, _e1334);
                                        } else {
                                            phi_2937_ = bool();
                                            phi_2938_ = true;
                                        }
                                        let _e1342 = phi_2937_;
                                        let _e1344 = phi_2938_;
                                        if select(_e1342, false, _e1344) {
                                            phi_3308_ = type_49();
                                            phi_3309_ = true;
                                        } else {
                                            let _e1347 = ((((bitcast<f32>(bitcast<u32>((_e1251.x * (_e1258 - _e1261)))) + bitcast<f32>(bitcast<u32>((_e1251.y * (_e1263 - _e1266))))) + bitcast<f32>(bitcast<u32>((_e1251.z * (_e1253 - _e1256))))) * _e416) > (bitcast<f32>(bitcast<u32>((0.0000009536752f * ((bitcast<f32>(bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1251.x) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e1258) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1261) & 2147483647u)))))) + bitcast<f32>(bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1251.y) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e1263) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1266) & 2147483647u))))))) + bitcast<f32>(bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1251.z) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e1253) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1256) & 2147483647u)))))))))) + 0.0000000000000000000000000000000000001880791f));
                                            if _e1347 {
                                                let _e1349 = select(_e316, _e315, (_e315 > _e316));
                                                let _e1366 = (select(_e317, _e1349, (_e1349 > _e317)) * ((bitcast<f32>((bitcast<u32>(_e420.x) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e420.y) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e420.z) & 2147483647u))));
                                                let _e1370 = (_e279 + (_e420.x * _e1366));
                                                let _e1371 = (_e280 + (_e420.y * _e1366));
                                                let _e1372 = (_e281 + (_e420.z * _e1366));
                                                if (_e420.x > 0f) {
                                                    let _e1393 = bitcast<u32>(_e1370);
                                                    if ((_e1393 & 2147483647u) == 0u) {
                                                        phi_3049_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1393 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_3045_ = bitcast<f32>((_e1393 + 1u));
                                                        } else {
                                                            phi_3045_ = bitcast<f32>((_e1393 - 1u));
                                                        }
                                                        let _e1404 = phi_3045_;
                                                        phi_3049_ = _e1404;
                                                    }
                                                    let _e1406 = phi_3049_;
                                                    phi_3051_ = _e1406;
                                                } else {
                                                    if (_e420.x < 0f) {
                                                        let _e1376 = bitcast<u32>(-(_e1370));
                                                        if ((_e1376 & 2147483647u) == 0u) {
                                                            phi_3027_ = 0.000000000000000000000000000000000000000000001f;
                                                        } else {
                                                            if ((_e1376 >> bitcast<u32>(31i)) == 0u) {
                                                                phi_3023_ = bitcast<f32>((_e1376 + 1u));
                                                            } else {
                                                                phi_3023_ = bitcast<f32>((_e1376 - 1u));
                                                            }
                                                            let _e1387 = phi_3023_;
                                                            phi_3027_ = _e1387;
                                                        }
                                                        let _e1389 = phi_3027_;
                                                        phi_3030_ = -(_e1389);
                                                    } else {
                                                        phi_3030_ = _e1370;
                                                    }
                                                    let _e1392 = phi_3030_;
                                                    phi_3051_ = _e1392;
                                                }
                                                let _e1408 = phi_3051_;
                                                if (_e420.y > 0f) {
                                                    let _e1429 = bitcast<u32>(_e1371);
                                                    if ((_e1429 & 2147483647u) == 0u) {
                                                        phi_3098_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1429 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_3094_ = bitcast<f32>((_e1429 + 1u));
                                                        } else {
                                                            phi_3094_ = bitcast<f32>((_e1429 - 1u));
                                                        }
                                                        let _e1440 = phi_3094_;
                                                        phi_3098_ = _e1440;
                                                    }
                                                    let _e1442 = phi_3098_;
                                                    phi_3100_ = _e1442;
                                                } else {
                                                    if (_e420.y < 0f) {
                                                        let _e1412 = bitcast<u32>(-(_e1371));
                                                        if ((_e1412 & 2147483647u) == 0u) {
                                                            phi_3076_ = 0.000000000000000000000000000000000000000000001f;
                                                        } else {
                                                            if ((_e1412 >> bitcast<u32>(31i)) == 0u) {
                                                                phi_3072_ = bitcast<f32>((_e1412 + 1u));
                                                            } else {
                                                                phi_3072_ = bitcast<f32>((_e1412 - 1u));
                                                            }
                                                            let _e1423 = phi_3072_;
                                                            phi_3076_ = _e1423;
                                                        }
                                                        let _e1425 = phi_3076_;
                                                        phi_3079_ = -(_e1425);
                                                    } else {
                                                        phi_3079_ = _e1371;
                                                    }
                                                    let _e1428 = phi_3079_;
                                                    phi_3100_ = _e1428;
                                                }
                                                let _e1444 = phi_3100_;
                                                if (_e420.z > 0f) {
                                                    let _e1465 = bitcast<u32>(_e1372);
                                                    if ((_e1465 & 2147483647u) == 0u) {
                                                        phi_3147_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1465 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_3143_ = bitcast<f32>((_e1465 + 1u));
                                                        } else {
                                                            phi_3143_ = bitcast<f32>((_e1465 - 1u));
                                                        }
                                                        let _e1476 = phi_3143_;
                                                        phi_3147_ = _e1476;
                                                    }
                                                    let _e1478 = phi_3147_;
                                                    phi_3149_ = _e1478;
                                                } else {
                                                    if (_e420.z < 0f) {
                                                        let _e1448 = bitcast<u32>(-(_e1372));
                                                        if ((_e1448 & 2147483647u) == 0u) {
                                                            phi_3125_ = 0.000000000000000000000000000000000000000000001f;
                                                        } else {
                                                            if ((_e1448 >> bitcast<u32>(31i)) == 0u) {
                                                                phi_3121_ = bitcast<f32>((_e1448 + 1u));
                                                            } else {
                                                                phi_3121_ = bitcast<f32>((_e1448 - 1u));
                                                            }
                                                            let _e1459 = phi_3121_;
                                                            phi_3125_ = _e1459;
                                                        }
                                                        let _e1461 = phi_3125_;
                                                        phi_3128_ = -(_e1461);
                                                    } else {
                                                        phi_3128_ = _e1372;
                                                    }
                                                    let _e1464 = phi_3128_;
                                                    phi_3149_ = _e1464;
                                                }
                                                let _e1480 = phi_3149_;
                                                if _e1240 {
                                                    phi_3170_ = vec3<f32>((_e1226.member[0] - _e1408), (_e1226.member[1] - _e1444), (_e1226.member[2] - _e1480));
                                                } else {
                                                    phi_3170_ = vec3<f32>(_e1226.member[0], _e1226.member[1], _e1226.member[2]);
                                                }
                                                let _e1490 = phi_3170_;
                                                let _e1503 = sqrt((((_e1490.x * _e1490.x) + (_e1490.y * _e1490.y)) + (_e1490.z * _e1490.z)));
                                                let _e1512 = ((((_e533.x * _e1490.x) + (_e533.y * _e1490.y)) + (_e533.z * _e1490.z)) / _e1503);
                                                if _e1240 {
                                                    phi_3204_ = (_e1503 <= _e1226.member_3);
                                                } else {
                                                    phi_3204_ = true;
                                                }
                                                let _e1515 = phi_3204_;
                                                if _e1240 {
                                                    phi_3210_ = (1f / (_e1503 * _e1503));
                                                } else {
                                                    phi_3210_ = 1f;
                                                }
                                                let _e1519 = phi_3210_;
                                                let _e1520 = -(_e1490.x);
                                                let _e1521 = -(_e1490.y);
                                                let _e1522 = -(_e1490.z);
                                                if (_e1226.member_5 == 0u) {
                                                    phi_3246_ = 1f;
                                                } else {
                                                    let _e1538 = ((((_e1226.member_8[0] * _e1520) + (_e1226.member_8[1] * _e1521)) + (_e1226.member_8[2] * _e1522)) / sqrt((((_e1520 * _e1520) + (_e1521 * _e1521)) + (_e1522 * _e1522))));
                                                    phi_3246_ = select(0f, _e1538, (_e1538 > 0f));
                                                }
                                                let _e1542 = phi_3246_;
                                                if (_e1512 > 0f) {
                                                    if _e1515 {
                                                        let _e1544 = (_e1542 > 0f);
                                                        if _e1544 {
                                                            let _e1551 = ((1f - select(_e545.member_1, _e545.member_2, (_e545.member_2 > 0f))) * 0.31830987f);
                                                            let _e1559 = ((_e1512 * _e1519) * _e1542);
                                                            phi_3291_ = type_49(type_35(array<f32, 3>(_e1408, _e1444, _e1480), 0f, array<f32, 3>(_e1490.x, _e1490.y, _e1490.z), select(340282350000000000000000000000000000000f, 1f, _e1240)), array<f32, 3>(((_e1226.member_2[0] * (_e545.member[0] * _e1551)) * _e1559), ((_e1226.member_2[1] * (_e545.member[1] * _e1551)) * _e1559), ((_e1226.member_2[2] * (_e545.member[2] * _e1551)) * _e1559)), _e117.member_3);
                                                        } else {
                                                            phi_3291_ = type_49();
                                                        }
                                                        let _e1566 = phi_3291_;
                                                        phi_3294_ = _e1566;
                                                        phi_3295_ = select(true, false, _e1544);
                                                    } else {
                                                        phi_3294_ = type_49();
                                                        phi_3295_ = true;
                                                    }
                                                    let _e1569 = phi_3294_;
                                                    let _e1571 = phi_3295_;
                                                    phi_3297_ = _e1569;
                                                    phi_3298_ = _e1571;
                                                } else {
                                                    phi_3297_ = type_49();
                                                    phi_3298_ = true;
                                                }
                                                let _e1573 = phi_3297_;
                                                let _e1575 = phi_3298_;
                                                if _e1575 {
                                                    phi_3302_ = type_49(type_35(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                                                } else {
                                                    phi_3302_ = _e1573;
                                                }
                                                let _e1577 = phi_3302_;
                                                phi_3304_ = _e1577;
                                            } else {
                                                phi_3304_ = type_49();
                                            }
                                            let _e1579 = phi_3304_;
                                            phi_3308_ = _e1579;
                                            phi_3309_ = select(true, false, _e1347);
                                        }
                                        let _e1582 = phi_3308_;
                                        let _e1584 = phi_3309_;
                                        if _e1584 {
                                            phi_3313_ = type_49(type_35(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                                        } else {
                                            phi_3313_ = _e1582;
                                        }
                                        let _e1586 = phi_3313_;
                                        phi_1661_ = _e1586;
                                    }
                                    let _e2096 = phi_1661_;
                                    phi_1662_ = _e2096;
                                }
                                let _e2098 = phi_1662_;
                                phi_1663_ = _e2098;
                            } else {
                                phi_1663_ = type_49(type_35(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                            }
                            let _e2100 = phi_1663_;
                            phi_1664_ = _e2100;
                        } else {
                            phi_1664_ = type_49(type_35(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                        }
                        let _e2102 = phi_1664_;
                        if _e111 {
                        } else {
                            break;
                        }
                        global_11.member[_e108] = _e2102;
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
