struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_13 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_15 {
    member: array<type_13>,
}

struct type_22 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_23 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_31 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_33 {
    member: array<type_23>,
}

struct type_37 {
    member: array<array<type_22, 8>>,
}

struct type_43 {
    member: array<vec4<u32>, 2>,
}

struct type_45 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_47 {
    member: array<type_45>,
}

struct type_50 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_52 {
    member: type_50,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(3) 
var<storage> global_2: type_15;
@group(0) @binding(1) 
var<uniform> global_3: type_43;
@group(0) @binding(4) 
var<storage> global_4: type_33;
@group(0) @binding(2) 
var<storage> global_5: type_47;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_37;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<f32, 128>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<u32, 128>;
    var local_7: array<type_22, 8>;
    var local_8: array<f32, 128>;
    var local_9: array<f32, 3>;
    var local_10: array<f32, 3>;
    var phi_451_: i32;
    var phi_452_: i32;
    var phi_462_: bool;
    var phi_472_: u32;
    var phi_473_: u32;
    var phi_475_: bool;
    var phi_480_: u32;
    var phi_493_: i32;
    var phi_513_: i32;
    var phi_531_: f32;
    var phi_537_: f32;
    var phi_577_: f32;
    var phi_583_: f32;
    var phi_656_: f32;
    var phi_662_: f32;
    var phi_702_: f32;
    var phi_708_: f32;
    var phi_781_: f32;
    var phi_787_: f32;
    var phi_827_: f32;
    var phi_833_: f32;
    var phi_952_: i32;
    var phi_974_: u32;
    var phi_975_: u32;
    var phi_1012_: i32;
    var phi_1034_: u32;
    var phi_1035_: u32;
    var phi_1043_: f32;
    var phi_1044_: f32;
    var phi_3889_: bool;
    var phi_3869_: f32;
    var phi_1180_: u32;
    var phi_1183_: bool;
    var phi_1185_: u32;
    var phi_1187_: type_52;
    var phi_1198_: bool;
    var phi_1285_: bool;
    var phi_1286_: u32;
    var phi_1287_: type_52;
    var phi_3886_: bool;
    var phi_3874_: f32;
    var phi_1305_: type_4;
    var phi_1306_: type_4;
    var phi_1329_: type_4;
    var phi_1350_: u32;
    var phi_1442_: array<array<f32, 3>, 3>;
    var phi_3585_: bool;
    var phi_3600_: bool;
    var phi_3615_: bool;
    var phi_3630_: bool;
    var phi_3645_: bool;
    var phi_3660_: bool;
    var phi_1985_: f32;
    var phi_1986_: f32;
    var phi_1987_: f32;
    var phi_1988_: f32;
    var phi_1989_: vec3<f32>;
    var phi_1990_: vec3<f32>;
    var phi_1991_: vec3<f32>;
    var phi_1992_: vec3<f32>;
    var phi_3675_: bool;
    var phi_3690_: bool;
    var phi_3705_: bool;
    var phi_3720_: bool;
    var phi_3735_: bool;
    var phi_3750_: bool;
    var phi_2200_: f32;
    var phi_2220_: type_31;
    var phi_2221_: type_31;
    var phi_2224_: type_31;
    var phi_2225_: type_31;
    var phi_2226_: bool;
    var phi_2230_: type_31;
    var phi_2239_: type_22;
    var phi_2251_: type_4;
    var phi_2254_: type_22;
    var phi_2252_: type_4;
    var phi_2277_: type_4;
    var phi_2309_: bool;
    var phi_2310_: bool;
    var phi_2331_: type_22;
    var phi_2255_: type_22;
    var phi_3876_: bool;
    var phi_4168_: f32;
    var phi_4167_: f32;
    var phi_4044_: bool;
    var phi_4166_: f32;
    var phi_4043_: bool;
    var phi_4165_: f32;
    var phi_4042_: bool;
    var phi_4072_: f32;
    var phi_4041_: bool;
    var phi_4228_: bool;
    var phi_4071_: f32;
    var phi_2363_: type_45;
    var phi_3250_: type_52;
    var phi_3326_: type_52;
    var phi_3327_: u32;
    var phi_3328_: type_52;
    var phi_3330_: u32;
    var phi_3331_: type_52;
    var phi_3332_: bool;
    var phi_3339_: type_52;
    var phi_3344_: bool;
    var phi_3346_: type_52;
    var phi_3350_: bool;
    var phi_3351_: u32;
    var phi_3352_: type_52;
    var phi_3362_: type_52;
    var phi_4255_: f32;
    var phi_4172_: bool;
    var phi_3363_: u32;
    var phi_3364_: bool;
    var phi_3365_: u32;
    var phi_3366_: type_52;
    var phi_4254_: f32;
    var phi_4171_: bool;
    var phi_3367_: u32;
    var phi_3368_: bool;
    var phi_3369_: u32;
    var phi_3370_: type_52;
    var phi_4253_: f32;
    var phi_4170_: bool;
    var phi_1181_: u32;
    var phi_1184_: bool;
    var phi_1186_: u32;
    var phi_1188_: type_52;
    var phi_3371_: bool;
    var phi_4169_: bool;
    var phi_3378_: type_4;
    var phi_3379_: type_4;
    var phi_3402_: type_4;
    var phi_3454_: f32;
    var phi_3456_: f32;
    var phi_3457_: bool;
    var phi_3458_: f32;
    var phi_3459_: bool;
    var phi_3778_: u32;
    var phi_3796_: bool;
    var phi_3799_: bool;
    var phi_3812_: f32;
    var phi_3813_: f32;
    var phi_3818_: f32;
    var phi_3819_: f32;
    var phi_3820_: bool;
    var phi_3828_: f32;
    var phi_3474_: f32;
    var phi_3475_: f32;
    var phi_3487_: f32;
    var phi_3492_: type_22;
    var phi_4235_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e88 = global;
            let _e91 = arrayLength((&global_5.member));
            let _e93 = arrayLength((&global_2.member));
            let _e101 = global_3.member[0u][0u];
            let _e105 = global_3.member[0u][1u];
            let _e109 = global_3.member[0u][2u];
            let _e113 = global_3.member[1u][0u];
            let _e117 = global_3.member[1u][1u];
            let _e121 = global_3.member[1u][2u];
            let _e125 = global_3.member[1u][3u];
            let _e128 = global_1.member[0u];
            let _e129 = bitcast<i32>(_e128);
            let _e139 = (_e88.x + (_e88.y * 2097152u));
            let _e140 = (_e139 < arrayLength((&global_4.member)));
            if _e140 {
                let _e141 = (_e139 < arrayLength((&global_6.member)));
                if _e141 {
                    if _e140 {
                    } else {
                        break;
                    }
                    let _e149 = global_4.member[_e139].member_2[0u];
                    let _e151 = (bitcast<u32>(_e149) & 2147483647u);
                    let _e156 = global_4.member[_e139].member_2[1u];
                    let _e158 = (bitcast<u32>(_e156) & 2147483647u);
                    let _e163 = global_4.member[_e139].member_2[2u];
                    let _e165 = (bitcast<u32>(_e163) & 2147483647u);
                    let _e170 = global_4.member[_e139].member[0u];
                    let _e172 = (bitcast<u32>(_e170) & 2147483647u);
                    let _e177 = global_4.member[_e139].member[1u];
                    let _e179 = (bitcast<u32>(_e177) & 2147483647u);
                    let _e184 = global_4.member[_e139].member[2u];
                    let _e186 = (bitcast<u32>(_e184) & 2147483647u);
                    let _e188 = select(_e158, _e151, (_e158 < _e151));
                    let _e190 = select(_e165, _e188, (_e165 < _e188));
                    let _e192 = select(_e172, _e190, (_e172 < _e190));
                    let _e194 = select(_e179, _e192, (_e179 < _e192));
                    let _e196 = select(_e186, _e194, (_e186 < _e194));
                    let _e200 = global_4.member[_e139].member_1;
                    let _e201 = bitcast<u32>(_e200);
                    let _e202 = (_e201 & 2147483647u);
                    let _e209 = global_4.member[_e139].member_3;
                    let _e210 = bitcast<u32>(_e209);
                    let _e211 = (_e210 & 2147483647u);
                    let _e215 = (((select(_e202, _e196, (_e202 < _e196)) < 2139095040u) && (_e211 <= 2139095040u)) && (_e190 > 0u));
                    if _e215 {
                        let _e218 = (bitcast<u32>(bitcast<f32>(_e190)) & 2147483647u);
                        if (_e218 >= 8388608u) {
                            phi_451_ = (bitcast<i32>((_e218 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_451_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e218)), 32u, (_e218 == 0u))));
                        }
                        let _e232 = phi_451_;
                        phi_452_ = _e232;
                    } else {
                        phi_452_ = 0i;
                    }
                    let _e234 = phi_452_;
                    let _e235 = (_e151 == _e190);
                    if _e235 {
                        phi_462_ = true;
                    } else {
                        phi_462_ = (_e158 == _e190);
                    }
                    let _e238 = phi_462_;
                    let _e239 = select(1u, 0u, _e235);
                    if _e238 {
                        let _e240 = (_e239 + 1u);
                        phi_472_ = _e240;
                        phi_473_ = _e240;
                        phi_475_ = select(true, false, (_e240 == 2u));
                    } else {
                        phi_472_ = u32();
                        phi_473_ = 0u;
                        phi_475_ = true;
                    }
                    let _e244 = phi_472_;
                    let _e246 = phi_473_;
                    let _e248 = phi_475_;
                    if _e248 {
                        phi_480_ = (_e246 + 1u);
                    } else {
                        phi_480_ = 0u;
                    }
                    let _e252 = phi_480_;
                    let _e253 = select(_e244, _e246, _e248);
                    let _e254 = select(_e239, select(2u, _e239, _e238), _e248);
                    if (_e129 < -126i) {
                        phi_493_ = -126i;
                    } else {
                        phi_493_ = select(_e129, 127i, (_e129 > 127i));
                    }
                    let _e259 = phi_493_;
                    let _e264 = bitcast<f32>((bitcast<u32>((_e259 + 127i)) << bitcast<u32>(23i)));
                    let _e270 = bitcast<f32>((bitcast<u32>(((_e129 - _e259) + 127i)) << bitcast<u32>(23i)));
                    let _e271 = -(_e234);
                    if (_e271 < -126i) {
                        phi_513_ = -126i;
                    } else {
                        phi_513_ = select(_e271, 127i, (_e271 > 127i));
                    }
                    let _e276 = phi_513_;
                    let _e281 = bitcast<f32>((bitcast<u32>((_e276 + 127i)) << bitcast<u32>(23i)));
                    let _e287 = bitcast<f32>((bitcast<u32>(((_e271 - _e276) + 127i)) << bitcast<u32>(23i)));
                    let _e291 = global_4.member[_e139].member;
                    let _e292 = (_e253 == 0u);
                    if _e292 {
                        phi_531_ = _e291[0];
                    } else {
                        phi_531_ = _e291[1];
                    }
                    let _e296 = phi_531_;
                    let _e297 = (_e253 == 2u);
                    if _e297 {
                        phi_537_ = _e291[2];
                    } else {
                        phi_537_ = _e296;
                    }
                    let _e300 = phi_537_;
                    let _e301 = bitcast<u32>(_e300);
                    let _e303 = ((_e301 & 2139095040u) != 0u);
                    let _e317 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e301 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e301 & 2147483648u))), _e300, _e303) * _e264) * select(0.00000011920929f, 1f, _e303)) * _e270);
                    let _e318 = global_4.member[_e139].member_2;
                    if _e292 {
                        phi_577_ = _e318[0];
                    } else {
                        phi_577_ = _e318[1];
                    }
                    let _e322 = phi_577_;
                    if _e297 {
                        phi_583_ = _e318[2];
                    } else {
                        phi_583_ = _e322;
                    }
                    let _e325 = phi_583_;
                    let _e326 = bitcast<u32>(_e325);
                    let _e328 = ((_e326 & 2139095040u) != 0u);
                    let _e342 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e326 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e326 & 2147483648u))), _e325, _e328) * _e281) * select(0.00000011920929f, 1f, _e328)) * _e287);
                    let _e346 = (bitcast<f32>((bitcast<u32>(_e342) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e349 = bitcast<f32>((bitcast<u32>(_e317) & 2147483647u));
                    let _e350 = (_e349 * 0.00000011920929f);
                    let _e353 = select(select(0.00000000000011368684f, _e350, (_e350 > 0.00000000000011368684f)), 0f, _e346);
                    let _e354 = select(0f, _e342, _e346);
                    let _e355 = (_e317 + _e353);
                    let _e356 = (_e317 - _e353);
                    let _e358 = select(38685626000000000000000000f, (1f / _e342), _e346);
                    let _e359 = (_e252 == 0u);
                    if _e359 {
                        phi_656_ = _e291[0];
                    } else {
                        phi_656_ = _e291[1];
                    }
                    let _e363 = phi_656_;
                    let _e364 = (_e252 == 2u);
                    if _e364 {
                        phi_662_ = _e291[2];
                    } else {
                        phi_662_ = _e363;
                    }
                    let _e367 = phi_662_;
                    let _e368 = bitcast<u32>(_e367);
                    let _e370 = ((_e368 & 2139095040u) != 0u);
                    let _e384 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e368 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e368 & 2147483648u))), _e367, _e370) * _e264) * select(0.00000011920929f, 1f, _e370)) * _e270);
                    if _e359 {
                        phi_702_ = _e318[0];
                    } else {
                        phi_702_ = _e318[1];
                    }
                    let _e388 = phi_702_;
                    if _e364 {
                        phi_708_ = _e318[2];
                    } else {
                        phi_708_ = _e388;
                    }
                    let _e391 = phi_708_;
                    let _e392 = bitcast<u32>(_e391);
                    let _e394 = ((_e392 & 2139095040u) != 0u);
                    let _e408 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e392 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e392 & 2147483648u))), _e391, _e394) * _e281) * select(0.00000011920929f, 1f, _e394)) * _e287);
                    let _e412 = (bitcast<f32>((bitcast<u32>(_e408) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e415 = bitcast<f32>((bitcast<u32>(_e384) & 2147483647u));
                    let _e416 = (_e415 * 0.00000011920929f);
                    let _e419 = select(select(0.00000000000011368684f, _e416, (_e416 > 0.00000000000011368684f)), 0f, _e412);
                    let _e420 = select(0f, _e408, _e412);
                    let _e421 = (_e384 + _e419);
                    let _e422 = (_e384 - _e419);
                    let _e424 = select(38685626000000000000000000f, (1f / _e408), _e412);
                    let _e425 = (_e254 == 0u);
                    if _e425 {
                        phi_781_ = _e291[0];
                    } else {
                        phi_781_ = _e291[1];
                    }
                    let _e429 = phi_781_;
                    let _e430 = (_e254 == 2u);
                    if _e430 {
                        phi_787_ = _e291[2];
                    } else {
                        phi_787_ = _e429;
                    }
                    let _e433 = phi_787_;
                    let _e434 = bitcast<u32>(_e433);
                    let _e436 = ((_e434 & 2139095040u) != 0u);
                    let _e450 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e434 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e434 & 2147483648u))), _e433, _e436) * _e264) * select(0.00000011920929f, 1f, _e436)) * _e270);
                    if _e425 {
                        phi_827_ = _e318[0];
                    } else {
                        phi_827_ = _e318[1];
                    }
                    let _e454 = phi_827_;
                    if _e430 {
                        phi_833_ = _e318[2];
                    } else {
                        phi_833_ = _e454;
                    }
                    let _e457 = phi_833_;
                    let _e458 = bitcast<u32>(_e457);
                    let _e460 = ((_e458 & 2139095040u) != 0u);
                    let _e474 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e458 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e458 & 2147483648u))), _e457, _e460) * _e281) * select(0.00000011920929f, 1f, _e460)) * _e287);
                    let _e478 = (bitcast<f32>((bitcast<u32>(_e474) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e481 = bitcast<f32>((bitcast<u32>(_e450) & 2147483647u));
                    let _e482 = (_e481 * 0.00000011920929f);
                    let _e485 = select(select(0.00000000000011368684f, _e482, (_e482 > 0.00000000000011368684f)), 0f, _e478);
                    let _e486 = select(0f, _e474, _e478);
                    let _e487 = (_e450 + _e485);
                    let _e488 = (_e450 - _e485);
                    let _e490 = select(38685626000000000000000000f, (1f / _e474), _e478);
                    let _e492 = select(_e415, _e349, (_e349 > _e415));
                    let _e495 = (_e129 + _e234);
                    if (_e215 && (select(_e481, _e492, (_e492 > _e481)) <= 1099511600000f)) {
                        let _e505 = ((_e202 & 8388607u) | (select(0u, 1u, ((_e202 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e508 = bitcast<i32>((_e202 >> bitcast<u32>(23i)));
                        let _e512 = (_e505 == 0u);
                        let _e515 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e505)), 32u, _e512)) - 8i);
                        if (_e508 == 255i) {
                            phi_952_ = 255i;
                        } else {
                            phi_952_ = (((_e508 + select(0i, 1i, (_e508 == 0i))) - _e515) + _e495);
                        }
                        let _e523 = phi_952_;
                        let _e533 = (_e523 <= 0i);
                        if _e533 {
                            phi_975_ = u32();
                        } else {
                            if _e512 {
                                phi_974_ = u32();
                            } else {
                                phi_974_ = select(((bitcast<u32>(_e523) << bitcast<u32>(23i)) | ((_e505 << bitcast<u32>(((_e515 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e523 >= 255i));
                            }
                            let _e537 = phi_974_;
                            phi_975_ = _e537;
                        }
                        let _e539 = phi_975_;
                        let _e551 = ((_e211 & 8388607u) | (select(0u, 1u, ((_e211 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e554 = bitcast<i32>((_e211 >> bitcast<u32>(23i)));
                        let _e558 = (_e551 == 0u);
                        let _e561 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e551)), 32u, _e558)) - 8i);
                        if (_e554 == 255i) {
                            phi_1012_ = 255i;
                        } else {
                            phi_1012_ = (((_e554 + select(0i, 1i, (_e554 == 0i))) - _e561) + _e495);
                        }
                        let _e569 = phi_1012_;
                        let _e579 = (_e569 <= 0i);
                        if _e579 {
                            phi_1035_ = u32();
                        } else {
                            if _e558 {
                                phi_1034_ = u32();
                            } else {
                                phi_1034_ = select(((bitcast<u32>(_e569) << bitcast<u32>(23i)) | ((_e551 << bitcast<u32>(((_e561 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e569 >= 255i));
                            }
                            let _e583 = phi_1034_;
                            phi_1035_ = _e583;
                        }
                        let _e585 = phi_1035_;
                        phi_1043_ = bitcast<f32>(((_e210 & 2147483648u) | select(_e585, 0u, select(_e558, true, _e579))));
                        phi_1044_ = bitcast<f32>(((_e201 & 2147483648u) | select(_e539, 0u, select(_e512, true, _e533))));
                    } else {
                        phi_1043_ = 0f;
                        phi_1044_ = 1f;
                    }
                    let _e591 = phi_1043_;
                    let _e593 = phi_1044_;
                    local_7 = array<type_22, 8>(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_8 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_10 = array<f32, 3>(bitcast<f32>(_e101), bitcast<f32>(_e105), bitcast<f32>(_e109));
                    let _e597 = (_e253 % 3u);
                    let _e598 = (_e597 < 3u);
                    if _e598 {
                    } else {
                        break;
                    }
                    let _e600 = local_10[_e597];
                    let _e601 = (_e252 % 3u);
                    let _e602 = (_e601 < 3u);
                    if _e602 {
                    } else {
                        break;
                    }
                    let _e604 = local_10[_e601];
                    let _e605 = (_e254 % 3u);
                    let _e606 = (_e605 < 3u);
                    if _e606 {
                    } else {
                        break;
                    }
                    let _e608 = local_10[_e605];
                    local_9 = array<f32, 3>(bitcast<f32>(_e113), bitcast<f32>(_e117), bitcast<f32>(_e121));
                    if _e598 {
                    } else {
                        break;
                    }
                    let _e612 = local_9[_e597];
                    if _e602 {
                    } else {
                        break;
                    }
                    let _e614 = local_9[_e601];
                    if _e606 {
                    } else {
                        break;
                    }
                    let _e616 = local_9[_e605];
                    phi_3889_ = false;
                    phi_3869_ = _e591;
                    phi_1180_ = ((3u * _e91) + 1u);
                    phi_1183_ = (_e593 <= _e591);
                    phi_1185_ = 0u;
                    phi_1187_ = type_52(type_50(array<f32, 3>(_e600, _e604, _e608), array<f32, 3>(_e612, _e614, _e616)), select(0u, 2147483648u, (_e91 == 0u)));
                    loop {
                        let _e624 = phi_3889_;
                        let _e626 = phi_3869_;
                        let _e628 = phi_1180_;
                        let _e630 = phi_1183_;
                        let _e632 = phi_1185_;
                        let _e634 = phi_1187_;
                        if _e630 {
                            phi_1198_ = true;
                        } else {
                            phi_1198_ = (_e632 > 0u);
                        }
                        let _e637 = phi_1198_;
                        if _e637 {
                            let _e638 = (_e628 > 0u);
                            if _e638 {
                                if _e630 {
                                    phi_1285_ = _e630;
                                    phi_1286_ = _e632;
                                    phi_1287_ = _e634;
                                } else {
                                    let _e639 = (_e632 - 1u);
                                    let _e640 = (_e639 % 128u);
                                    let _e641 = (_e640 < 128u);
                                    if _e641 {
                                    } else {
                                        phi_4169_ = true;
                                        break;
                                    }
                                    let _e643 = local_6[_e640];
                                    if _e641 {
                                    } else {
                                        phi_4169_ = true;
                                        break;
                                    }
                                    let _e645 = local_5[_e640];
                                    if _e641 {
                                    } else {
                                        phi_4169_ = true;
                                        break;
                                    }
                                    let _e647 = local_4[_e640];
                                    if _e641 {
                                    } else {
                                        phi_4169_ = true;
                                        break;
                                    }
                                    let _e649 = local_3[_e640];
                                    if _e641 {
                                    } else {
                                        phi_4169_ = true;
                                        break;
                                    }
                                    let _e652 = local_2[_e640];
                                    if _e641 {
                                    } else {
                                        phi_4169_ = true;
                                        break;
                                    }
                                    let _e654 = local_1[_e640];
                                    if _e641 {
                                    } else {
                                        phi_4169_ = true;
                                        break;
                                    }
                                    let _e656 = local[_e640];
                                    if _e641 {
                                    } else {
                                        phi_4169_ = true;
                                        break;
                                    }
                                    let _e661 = local_8[_e640];
                                    phi_1285_ = (_e661 <= _e626);
                                    phi_1286_ = _e639;
                                    phi_1287_ = type_52(type_50(array<f32, 3>(_e645, _e647, _e649), array<f32, 3>(_e652, _e654, _e656)), _e643);
                                }
                                let _e664 = phi_1285_;
                                let _e666 = phi_1286_;
                                let _e668 = phi_1287_;
                                if _e664 {
                                    let _e672 = ((_e668.member_1 & 2147483648u) != 0u);
                                    if _e672 {
                                        phi_3886_ = _e624;
                                        phi_3874_ = _e626;
                                        phi_1305_ = type_4(0u, ((_e668.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e679 = phi_3886_;
                                            let _e681 = phi_3874_;
                                            let _e683 = phi_1305_;
                                            if (_e683.member < _e683.member_1) {
                                                phi_1306_ = type_4((_e683.member + 1u), _e683.member_1);
                                                phi_1329_ = type_4(1u, _e683.member);
                                            } else {
                                                phi_1306_ = _e683;
                                                phi_1329_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e696 = phi_1306_;
                                            let _e698 = phi_1329_;
                                            let _e702 = (bitcast<i32>(_e698.member) != 0i);
                                            if _e702 {
                                                let _e703 = ((_e668.member_1 & 268435455u) + _e698.member_1);
                                                let _e704 = (_e703 < _e93);
                                                if _e704 {
                                                    if _e704 {
                                                    } else {
                                                        phi_4072_ = _e681;
                                                        phi_4041_ = true;
                                                        break;
                                                    }
                                                    let _e708 = global_2.member[_e703].member_1;
                                                    phi_1350_ = _e708;
                                                } else {
                                                    phi_1350_ = 4294967295u;
                                                }
                                                let _e710 = phi_1350_;
                                                if (_e703 >= _e93) {
                                                    phi_1442_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e704 {
                                                    } else {
                                                        phi_4072_ = _e681;
                                                        phi_4041_ = true;
                                                        break;
                                                    }
                                                    if (_e597 < 9u) {
                                                    } else {
                                                        phi_4072_ = _e681;
                                                        phi_4041_ = true;
                                                        break;
                                                    }
                                                    let _e717 = global_2.member[_e703].member[_e597];
                                                    if (_e601 < 9u) {
                                                    } else {
                                                        phi_4072_ = _e681;
                                                        phi_4041_ = true;
                                                        break;
                                                    }
                                                    let _e723 = global_2.member[_e703].member[_e601];
                                                    if (_e605 < 9u) {
                                                    } else {
                                                        phi_4072_ = _e681;
                                                        phi_4041_ = true;
                                                        break;
                                                    }
                                                    let _e729 = global_2.member[_e703].member[_e605];
                                                    let _e731 = (3u + _e597);
                                                    if (_e731 < 9u) {
                                                    } else {
                                                        phi_4072_ = _e681;
                                                        phi_4041_ = true;
                                                        break;
                                                    }
                                                    let _e737 = global_2.member[_e703].member[_e731];
                                                    let _e738 = (3u + _e601);
                                                    if (_e738 < 9u) {
                                                    } else {
                                                        phi_4072_ = _e681;
                                                        phi_4041_ = true;
                                                        break;
                                                    }
                                                    let _e744 = global_2.member[_e703].member[_e738];
                                                    let _e745 = (3u + _e605);
                                                    if (_e745 < 9u) {
                                                    } else {
                                                        phi_4072_ = _e681;
                                                        phi_4041_ = true;
                                                        break;
                                                    }
                                                    let _e751 = global_2.member[_e703].member[_e745];
                                                    let _e753 = (6u + _e597);
                                                    if (_e753 < 9u) {
                                                    } else {
                                                        phi_4072_ = _e681;
                                                        phi_4041_ = true;
                                                        break;
                                                    }
                                                    let _e759 = global_2.member[_e703].member[_e753];
                                                    let _e760 = (6u + _e601);
                                                    if (_e760 < 9u) {
                                                    } else {
                                                        phi_4072_ = _e681;
                                                        phi_4041_ = true;
                                                        break;
                                                    }
                                                    let _e766 = global_2.member[_e703].member[_e760];
                                                    let _e767 = (6u + _e605);
                                                    if (_e767 < 9u) {
                                                    } else {
                                                        phi_4072_ = _e681;
                                                        phi_4041_ = true;
                                                        break;
                                                    }
                                                    let _e773 = global_2.member[_e703].member[_e767];
                                                    phi_1442_ = array<array<f32, 3>, 3>(array<f32, 3>(_e717, _e723, _e729), array<f32, 3>(_e737, _e744, _e751), array<f32, 3>(_e759, _e766, _e773));
                                                }
                                                let _e777 = phi_1442_;
                                                let _e792 = (_e777[0][2] - _e450);
                                                let _e795 = (((_e777[0][0] - _e317) * _e486) - (_e792 * _e354));
                                                let _e798 = (((_e777[0][1] - _e384) * _e486) - (_e792 * _e420));
                                                let _e801 = (_e777[1][2] - _e450);
                                                let _e804 = (((_e777[1][0] - _e317) * _e486) - (_e801 * _e354));
                                                let _e807 = (((_e777[1][1] - _e384) * _e486) - (_e801 * _e420));
                                                let _e810 = (_e777[2][2] - _e450);
                                                let _e813 = (((_e777[2][0] - _e317) * _e486) - (_e810 * _e354));
                                                let _e816 = (((_e777[2][1] - _e384) * _e486) - (_e810 * _e420));
                                                let _e817 = (_e813 * _e807);
                                                let _e818 = (_e816 * _e804);
                                                let _e819 = (_e795 * _e816);
                                                let _e820 = (_e798 * _e813);
                                                let _e821 = (_e804 * _e798);
                                                let _e822 = (_e807 * _e795);
                                                let _e827 = (((_e817 >= _e818) && (_e819 >= _e820)) && (_e821 >= _e822));
                                                let _e833 = (_e827 || (((_e817 <= _e818) && (_e819 <= _e820)) && (_e821 <= _e822)));
                                                if _e833 {
                                                    let _e835 = select(-1f, 1f, _e827);
                                                    let _e837 = ((_e817 - _e818) * _e835);
                                                    let _e839 = select(0f, _e837, (_e837 > 0f));
                                                    let _e841 = ((_e819 - _e820) * _e835);
                                                    let _e843 = select(0f, _e841, (_e841 > 0f));
                                                    let _e845 = ((_e821 - _e822) * _e835);
                                                    let _e847 = select(0f, _e845, (_e845 > 0f));
                                                    let _e849 = ((_e839 + _e843) + _e847);
                                                    let _e851 = select(_e777[1][0], _e777[0][0], (_e777[0][0] < _e777[1][0]));
                                                    let _e855 = select(_e777[1][0], _e777[0][0], (_e777[0][0] > _e777[1][0]));
                                                    let _e859 = select(_e777[1][1], _e777[0][1], (_e777[0][1] < _e777[1][1]));
                                                    let _e863 = select(_e777[1][1], _e777[0][1], (_e777[0][1] > _e777[1][1]));
                                                    let _e867 = select(_e777[1][2], _e777[0][2], (_e777[0][2] < _e777[1][2]));
                                                    let _e871 = select(_e777[1][2], _e777[0][2], (_e777[0][2] > _e777[1][2]));
                                                    let _e876 = ((select(_e777[2][0], _e851, (_e851 < _e777[2][0])) - _e355) * _e358);
                                                    let _e877 = ((select(_e777[2][0], _e855, (_e855 > _e777[2][0])) - _e356) * _e358);
                                                    let _e880 = ((select(_e777[2][1], _e859, (_e859 < _e777[2][1])) - _e421) * _e424);
                                                    let _e881 = ((select(_e777[2][1], _e863, (_e863 > _e777[2][1])) - _e422) * _e424);
                                                    let _e884 = ((select(_e777[2][2], _e867, (_e867 < _e777[2][2])) - _e487) * _e490);
                                                    let _e885 = ((select(_e777[2][2], _e871, (_e871 > _e777[2][2])) - _e488) * _e490);
                                                    let _e887 = select(_e885, _e884, (_e884 < _e885));
                                                    let _e889 = select(_e885, _e884, (_e884 > _e885));
                                                    let _e891 = select(_e877, _e876, (_e876 < _e877));
                                                    let _e893 = select(_e881, _e880, (_e880 < _e881));
                                                    let _e895 = select(_e893, _e891, (_e891 > _e893));
                                                    let _e897 = select(_e887, _e895, (_e895 > _e887));
                                                    let _e899 = select(_e877, _e876, (_e876 > _e877));
                                                    let _e901 = select(_e881, _e880, (_e880 > _e881));
                                                    let _e903 = select(_e901, _e899, (_e899 < _e901));
                                                    let _e905 = select(_e889, _e903, (_e903 < _e889));
                                                    let _e906 = -(_e887);
                                                    let _e912 = select(_e593, _e897, (_e897 > _e593));
                                                    let _e916 = select(_e804, _e795, (_e795 < _e804));
                                                    let _e921 = select(_e804, _e795, (_e795 > _e804));
                                                    let _e928 = select(_e807, _e798, (_e798 < _e807));
                                                    let _e933 = select(_e807, _e798, (_e798 > _e807));
                                                    let _e942 = (((((_e833 && (_e849 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e813, _e916, (_e916 < _e813)) <= 0f) && (select(_e813, _e921, (_e921 > _e813)) >= 0f))) && ((select(_e816, _e928, (_e928 < _e816)) <= 0f) && (select(_e816, _e933, (_e933 > _e816)) >= 0f))) && (_e912 <= (_e905 + (select(_e906, _e889, (_e889 > _e906)) * 0.0000019073523f)))) && (_e912 <= _e681));
                                                    if _e942 {
                                                        let _e947 = (_e777[1][0] - _e777[0][0]);
                                                        let _e948 = (_e777[1][1] - _e777[0][1]);
                                                        let _e949 = (_e777[1][2] - _e777[0][2]);
                                                        let _e950 = vec3<f32>(_e947, _e948, _e949);
                                                        let _e951 = (_e777[2][0] - _e777[1][0]);
                                                        let _e952 = (_e777[2][1] - _e777[1][1]);
                                                        let _e953 = (_e777[2][2] - _e777[1][2]);
                                                        let _e954 = vec3<f32>(_e951, _e952, _e953);
                                                        let _e955 = (_e777[0][0] - _e777[2][0]);
                                                        let _e956 = (_e777[0][1] - _e777[2][1]);
                                                        let _e957 = (_e777[0][2] - _e777[2][2]);
                                                        let _e958 = vec3<f32>(_e955, _e956, _e957);
                                                        let _e959 = abs(_e947);
                                                        let _e960 = abs(_e948);
                                                        if (_e959 != _e959) {
                                                            phi_3585_ = true;
                                                        } else {
                                                            phi_3585_ = (_e960 >= _e959);
                                                        }
                                                        let _e964 = phi_3585_;
                                                        let _e965 = select(_e959, _e960, _e964);
                                                        let _e966 = abs(_e949);
                                                        if (_e965 != _e965) {
                                                            phi_3600_ = true;
                                                        } else {
                                                            phi_3600_ = (_e966 >= _e965);
                                                        }
                                                        let _e970 = phi_3600_;
                                                        let _e971 = select(_e965, _e966, _e970);
                                                        let _e972 = abs(_e951);
                                                        let _e973 = abs(_e952);
                                                        if (_e972 != _e972) {
                                                            phi_3615_ = true;
                                                        } else {
                                                            phi_3615_ = (_e973 >= _e972);
                                                        }
                                                        let _e977 = phi_3615_;
                                                        let _e978 = select(_e972, _e973, _e977);
                                                        let _e979 = abs(_e953);
                                                        if (_e978 != _e978) {
                                                            phi_3630_ = true;
                                                        } else {
                                                            phi_3630_ = (_e979 >= _e978);
                                                        }
                                                        let _e983 = phi_3630_;
                                                        let _e984 = select(_e978, _e979, _e983);
                                                        let _e985 = abs(_e955);
                                                        let _e986 = abs(_e956);
                                                        if (_e985 != _e985) {
                                                            phi_3645_ = true;
                                                        } else {
                                                            phi_3645_ = (_e986 >= _e985);
                                                        }
                                                        let _e990 = phi_3645_;
                                                        let _e991 = select(_e985, _e986, _e990);
                                                        let _e992 = abs(_e957);
                                                        if (_e991 != _e991) {
                                                            phi_3660_ = true;
                                                        } else {
                                                            phi_3660_ = (_e992 >= _e991);
                                                        }
                                                        let _e996 = phi_3660_;
                                                        let _e997 = select(_e991, _e992, _e996);
                                                        let _e999 = select(_e984, _e971, (_e971 > _e984));
                                                        let _e1001 = select(_e997, _e999, (_e999 > _e997));
                                                        if (_e971 == _e1001) {
                                                            phi_1985_ = _e807;
                                                            phi_1986_ = _e804;
                                                            phi_1987_ = _e798;
                                                            phi_1988_ = _e795;
                                                            phi_1989_ = vec3<f32>(_e777[0][0], _e777[0][1], _e777[0][2]);
                                                            phi_1990_ = _e958;
                                                            phi_1991_ = _e954;
                                                            phi_1992_ = _e950;
                                                        } else {
                                                            let _e1003 = (_e984 == _e1001);
                                                            let _e1008 = vec3(_e1003);
                                                            phi_1985_ = select(_e798, _e816, _e1003);
                                                            phi_1986_ = select(_e795, _e813, _e1003);
                                                            phi_1987_ = select(_e816, _e807, _e1003);
                                                            phi_1988_ = select(_e813, _e804, _e1003);
                                                            phi_1989_ = select(vec3<f32>(_e777[2][0], _e777[2][1], _e777[2][2]), vec3<f32>(_e777[1][0], _e777[1][1], _e777[1][2]), _e1008);
                                                            phi_1990_ = select(_e954, _e950, _e1008);
                                                            phi_1991_ = select(_e950, _e958, _e1008);
                                                            phi_1992_ = select(_e958, _e954, _e1008);
                                                        }
                                                        let _e1014 = phi_1985_;
                                                        let _e1016 = phi_1986_;
                                                        let _e1018 = phi_1987_;
                                                        let _e1020 = phi_1988_;
                                                        let _e1022 = phi_1989_;
                                                        let _e1024 = phi_1990_;
                                                        let _e1026 = phi_1991_;
                                                        let _e1028 = phi_1992_;
                                                        let _e1035 = ((_e1026.y * _e1024.z) - (_e1024.y * _e1026.z));
                                                        let _e1040 = ((_e1026.z * _e1024.x) - (_e1024.z * _e1026.x));
                                                        let _e1043 = ((_e1026.x * _e1024.y) - (_e1024.x * _e1026.y));
                                                        let _e1046 = ((_e839 >= _e843) && (_e839 >= _e847));
                                                        let _e1047 = (_e843 >= _e847);
                                                        let _e1061 = (((_e1035 * (select(select(_e777[2][0], _e777[1][0], _e1047), _e777[0][0], _e1046) - _e317)) + (_e1040 * (select(select(_e777[2][1], _e777[1][1], _e1047), _e777[0][1], _e1046) - _e384))) + (_e1043 * (select(select(_e777[2][2], _e777[1][2], _e1047), _e777[0][2], _e1046) - _e450)));
                                                        let _e1066 = (((_e1035 * _e354) + (_e1040 * _e420)) + (_e1043 * _e486));
                                                        let _e1067 = (_e1016 - _e1020);
                                                        let _e1068 = (_e1014 - _e1018);
                                                        let _e1071 = ((_e1067 * _e1067) + (_e1068 * _e1068));
                                                        let _e1078 = (-(((_e1020 * _e1067) + (_e1018 * _e1068))) / select(0.000000000000000000000000000000000000011754944f, _e1071, (_e1071 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1080 = select(1f, _e1078, (_e1078 < 1f));
                                                        let _e1082 = select(0f, _e1080, (_e1080 > 0f));
                                                        let _e1091 = ((_e1022.x + (_e1028.x * _e1082)) - _e317);
                                                        let _e1094 = ((_e1022.y + (_e1028.y * _e1082)) - _e384);
                                                        let _e1097 = ((_e1022.z + (_e1028.z * _e1082)) - _e450);
                                                        let _e1100 = bitcast<f32>((bitcast<u32>(_e1091) & 2147483647u));
                                                        let _e1103 = bitcast<f32>((bitcast<u32>(_e1094) & 2147483647u));
                                                        let _e1105 = select(_e1103, _e1100, (_e1100 > _e1103));
                                                        let _e1108 = bitcast<f32>((bitcast<u32>(_e1097) & 2147483647u));
                                                        let _e1110 = select(_e1108, _e1105, (_e1105 > _e1108));
                                                        let _e1114 = abs(_e1035);
                                                        let _e1115 = abs(_e1040);
                                                        if (_e1114 != _e1114) {
                                                            phi_3675_ = true;
                                                        } else {
                                                            phi_3675_ = (_e1115 >= _e1114);
                                                        }
                                                        let _e1119 = phi_3675_;
                                                        let _e1120 = select(_e1114, _e1115, _e1119);
                                                        let _e1121 = abs(_e1043);
                                                        if (_e1120 != _e1120) {
                                                            phi_3690_ = true;
                                                        } else {
                                                            phi_3690_ = (_e1121 >= _e1120);
                                                        }
                                                        let _e1125 = phi_3690_;
                                                        let _e1141 = abs(_e1026.x);
                                                        let _e1142 = abs(_e1026.y);
                                                        if (_e1141 != _e1141) {
                                                            phi_3705_ = true;
                                                        } else {
                                                            phi_3705_ = (_e1142 >= _e1141);
                                                        }
                                                        let _e1146 = phi_3705_;
                                                        let _e1147 = select(_e1141, _e1142, _e1146);
                                                        let _e1148 = abs(_e1026.z);
                                                        if (_e1147 != _e1147) {
                                                            phi_3720_ = true;
                                                        } else {
                                                            phi_3720_ = (_e1148 >= _e1147);
                                                        }
                                                        let _e1152 = phi_3720_;
                                                        let _e1155 = abs(_e1024.x);
                                                        let _e1156 = abs(_e1024.y);
                                                        if (_e1155 != _e1155) {
                                                            phi_3735_ = true;
                                                        } else {
                                                            phi_3735_ = (_e1156 >= _e1155);
                                                        }
                                                        let _e1160 = phi_3735_;
                                                        let _e1161 = select(_e1155, _e1156, _e1160);
                                                        let _e1162 = abs(_e1024.z);
                                                        if (_e1161 != _e1161) {
                                                            phi_3750_ = true;
                                                        } else {
                                                            phi_3750_ = (_e1162 >= _e1161);
                                                        }
                                                        let _e1166 = phi_3750_;
                                                        let _e1171 = ((bitcast<f32>((bitcast<u32>(((((_e1035 * _e1091) + (_e1040 * _e1094)) + (_e1043 * _e1097)) - _e1061)) & 2147483647u)) <= ((0.0000009536743f * select(_e1001, _e1110, (_e1110 > _e1001))) * select(_e1120, _e1121, _e1125))) && !((bitcast<f32>((bitcast<u32>(_e1066) & 2147483647u)) <= ((0.0000038146973f * select(_e1147, _e1148, _e1152)) * select(_e1161, _e1162, _e1166)))));
                                                        let _e1172 = (_e1061 / _e1066);
                                                        if (_e942 && !(_e1171)) {
                                                            let _e1175 = (_e1097 / _e486);
                                                            let _e1183 = (((_e1035 * (_e1091 - (_e354 * _e1175))) + (_e1040 * (_e1094 - (_e420 * _e1175)))) / _e1066);
                                                            phi_2200_ = select(select(_e1175, (_e1175 + _e1183), (bitcast<f32>((bitcast<u32>(_e1183) & 2147483647u)) <= _e1001)), _e1172, _e1171);
                                                        } else {
                                                            phi_2200_ = _e1172;
                                                        }
                                                        let _e1192 = phi_2200_;
                                                        let _e1194 = select(_e905, _e1192, (_e1192 < _e905));
                                                        let _e1196 = select(_e897, _e1194, (_e1194 > _e897));
                                                        let _e1197 = (1f / _e849);
                                                        phi_2220_ = type_31(_e1196, (_e843 * _e1197), (_e847 * _e1197), ((_e942 && (_e1196 >= _e593)) && (_e1196 <= _e681)));
                                                        phi_2221_ = type_31();
                                                    } else {
                                                        phi_2220_ = type_31();
                                                        phi_2221_ = type_31(0f, 0f, 0f, _e942);
                                                    }
                                                    let _e1206 = phi_2220_;
                                                    let _e1208 = phi_2221_;
                                                    phi_2224_ = _e1206;
                                                    phi_2225_ = _e1208;
                                                    phi_2226_ = select(true, false, _e942);
                                                } else {
                                                    phi_2224_ = type_31();
                                                    phi_2225_ = type_31(0f, 0f, 0f, _e833);
                                                    phi_2226_ = true;
                                                }
                                                let _e1211 = phi_2224_;
                                                let _e1213 = phi_2225_;
                                                let _e1215 = phi_2226_;
                                                if _e1215 {
                                                    phi_2230_ = _e1213;
                                                } else {
                                                    phi_2230_ = _e1211;
                                                }
                                                let _e1217 = phi_2230_;
                                                if _e1217.member_3 {
                                                    phi_2239_ = type_22(_e1217.member, _e1217.member_1, _e1217.member_2, _e710);
                                                } else {
                                                    phi_2239_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1224 = phi_2239_;
                                                if (_e1224.member_3 != 4294967295u) {
                                                    if (_e710 != 4294967295u) {
                                                        phi_2251_ = type_4(0u, 8u);
                                                        phi_2254_ = _e1224;
                                                        loop {
                                                            let _e1229 = phi_2251_;
                                                            let _e1231 = phi_2254_;
                                                            if (_e1229.member < _e1229.member_1) {
                                                                phi_2252_ = type_4((_e1229.member + 1u), _e1229.member_1);
                                                                phi_2277_ = type_4(1u, _e1229.member);
                                                            } else {
                                                                phi_2252_ = _e1229;
                                                                phi_2277_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1244 = phi_2252_;
                                                            let _e1246 = phi_2277_;
                                                            let _e1250 = (bitcast<i32>(_e1246.member) != 0i);
                                                            if _e1250 {
                                                                let _e1251 = (_e1246.member_1 < 8u);
                                                                if _e1251 {
                                                                } else {
                                                                    phi_3876_ = true;
                                                                    break;
                                                                }
                                                                let _e1256 = local_7[_e1246.member_1].member;
                                                                if (_e1231.member < _e1256) {
                                                                    phi_2310_ = true;
                                                                } else {
                                                                    let _e1258 = local_7[_e1246.member_1].member;
                                                                    if (_e1231.member == _e1258) {
                                                                        let _e1263 = local_7[_e1246.member_1].member_3;
                                                                        phi_2309_ = (_e1231.member_3 < _e1263);
                                                                    } else {
                                                                        phi_2309_ = false;
                                                                    }
                                                                    let _e1266 = phi_2309_;
                                                                    phi_2310_ = _e1266;
                                                                }
                                                                let _e1268 = phi_2310_;
                                                                if _e1268 {
                                                                    if _e1251 {
                                                                    } else {
                                                                        phi_3876_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1269 = local_7[_e1246.member_1];
                                                                    local_7[_e1246.member_1] = type_22(_e1231.member, _e1231.member_1, _e1231.member_2, _e1231.member_3);
                                                                    phi_2331_ = type_22(_e1269.member, _e1269.member_1, _e1269.member_2, _e1269.member_3);
                                                                } else {
                                                                    phi_2331_ = _e1231;
                                                                }
                                                                let _e1280 = phi_2331_;
                                                                phi_2255_ = _e1280;
                                                            } else {
                                                                phi_2255_ = type_22();
                                                            }
                                                            let _e1282 = phi_2255_;
                                                            continue;
                                                            continuing {
                                                                phi_2251_ = _e1244;
                                                                phi_2254_ = _e1282;
                                                                phi_3876_ = _e679;
                                                                break if !(_e1250);
                                                            }
                                                        }
                                                        let _e1285 = phi_3876_;
                                                        phi_4072_ = _e681;
                                                        phi_4041_ = _e1285;
                                                        if _e1285 {
                                                            break;
                                                        }
                                                        let _e1288 = local_7[7u].member_3;
                                                        if (_e1288 != 4294967295u) {
                                                            let _e1292 = local_7[7u].member;
                                                            phi_4168_ = _e1292;
                                                        } else {
                                                            phi_4168_ = _e681;
                                                        }
                                                        let _e1294 = phi_4168_;
                                                        phi_4167_ = _e1294;
                                                        phi_4044_ = _e1285;
                                                    } else {
                                                        phi_4167_ = _e681;
                                                        phi_4044_ = _e679;
                                                    }
                                                    let _e1296 = phi_4167_;
                                                    let _e1298 = phi_4044_;
                                                    phi_4166_ = _e1296;
                                                    phi_4043_ = _e1298;
                                                } else {
                                                    phi_4166_ = _e681;
                                                    phi_4043_ = _e679;
                                                }
                                                let _e1300 = phi_4166_;
                                                let _e1302 = phi_4043_;
                                                phi_4165_ = _e1300;
                                                phi_4042_ = _e1302;
                                            } else {
                                                phi_4165_ = _e681;
                                                phi_4042_ = _e679;
                                            }
                                            let _e1304 = phi_4165_;
                                            let _e1306 = phi_4042_;
                                            continue;
                                            continuing {
                                                phi_3886_ = _e1306;
                                                phi_3874_ = _e1304;
                                                phi_1305_ = _e696;
                                                phi_4072_ = _e1304;
                                                phi_4041_ = _e1306;
                                                break if !(_e702);
                                            }
                                        }
                                        let _e1309 = phi_4072_;
                                        let _e1311 = phi_4041_;
                                        phi_4169_ = _e1311;
                                        if _e1311 {
                                            break;
                                        }
                                        phi_4228_ = _e1311;
                                        phi_4071_ = _e1309;
                                    } else {
                                        phi_4228_ = _e624;
                                        phi_4071_ = _e626;
                                    }
                                    let _e1313 = phi_4228_;
                                    let _e1315 = phi_4071_;
                                    if _e672 {
                                        phi_3350_ = bool();
                                        phi_3351_ = u32();
                                        phi_3352_ = type_52();
                                    } else {
                                        let _e1316 = (_e668.member_1 < _e91);
                                        if _e1316 {
                                            if _e1316 {
                                            } else {
                                                phi_4169_ = true;
                                                break;
                                            }
                                            let _e1318 = global_5.member[_e668.member_1];
                                            phi_2363_ = _e1318;
                                        } else {
                                            phi_2363_ = type_45(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e1320 = phi_2363_;
                                        let _e1335 = ((10u * _e253) & 31u);
                                        let _e1338 = ((_e1320.member[0] >> bitcast<u32>(_e1335)) & 1023u);
                                        let _e1346 = bitcast<f32>((bitcast<u32>(((_e668.member.member_1[0] - _e668.member.member[0]) * 0.0009775171f)) ^ _e125));
                                        let _e1351 = (_e668.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1338)) - 8388608f) * _e1346)) ^ _e125)));
                                        let _e1355 = select(select(_e668.member.member_1[0], _e1351, (_e1351 < _e668.member.member_1[0])), _e668.member.member_1[0], (_e1338 == 1023u));
                                        let _e1357 = ((10u * _e252) & 31u);
                                        let _e1360 = ((_e1320.member[0] >> bitcast<u32>(_e1357)) & 1023u);
                                        let _e1368 = bitcast<f32>((bitcast<u32>(((_e668.member.member_1[1] - _e668.member.member[1]) * 0.0009775171f)) ^ _e125));
                                        let _e1373 = (_e668.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1360)) - 8388608f) * _e1368)) ^ _e125)));
                                        let _e1377 = select(select(_e668.member.member_1[1], _e1373, (_e1373 < _e668.member.member_1[1])), _e668.member.member_1[1], (_e1360 == 1023u));
                                        let _e1379 = ((10u * _e254) & 31u);
                                        let _e1382 = ((_e1320.member[0] >> bitcast<u32>(_e1379)) & 1023u);
                                        let _e1390 = bitcast<f32>((bitcast<u32>(((_e668.member.member_1[2] - _e668.member.member[2]) * 0.0009775171f)) ^ _e125));
                                        let _e1395 = (_e668.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1382)) - 8388608f) * _e1390)) ^ _e125)));
                                        let _e1399 = select(select(_e668.member.member_1[2], _e1395, (_e1395 < _e668.member.member_1[2])), _e668.member.member_1[2], (_e1382 == 1023u));
                                        let _e1402 = ((_e1320.member[1] >> bitcast<u32>(_e1335)) & 1023u);
                                        let _e1410 = (_e668.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1402)) - 8388608f) * _e1346)) ^ _e125)));
                                        let _e1414 = select(select(_e668.member.member_1[0], _e1410, (_e1410 < _e668.member.member_1[0])), _e668.member.member_1[0], (_e1402 == 1023u));
                                        let _e1417 = ((_e1320.member[1] >> bitcast<u32>(_e1357)) & 1023u);
                                        let _e1425 = (_e668.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1417)) - 8388608f) * _e1368)) ^ _e125)));
                                        let _e1429 = select(select(_e668.member.member_1[1], _e1425, (_e1425 < _e668.member.member_1[1])), _e668.member.member_1[1], (_e1417 == 1023u));
                                        let _e1432 = ((_e1320.member[1] >> bitcast<u32>(_e1379)) & 1023u);
                                        let _e1440 = (_e668.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1432)) - 8388608f) * _e1390)) ^ _e125)));
                                        let _e1444 = select(select(_e668.member.member_1[2], _e1440, (_e1440 < _e668.member.member_1[2])), _e668.member.member_1[2], (_e1432 == 1023u));
                                        let _e1450 = ((_e1320.member_1[0] >> bitcast<u32>(_e1335)) & 1023u);
                                        let _e1458 = (_e668.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1450)) - 8388608f) * _e1346)) ^ _e125)));
                                        let _e1462 = select(select(_e668.member.member_1[0], _e1458, (_e1458 < _e668.member.member_1[0])), _e668.member.member_1[0], (_e1450 == 1023u));
                                        let _e1465 = ((_e1320.member_1[0] >> bitcast<u32>(_e1357)) & 1023u);
                                        let _e1473 = (_e668.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1465)) - 8388608f) * _e1368)) ^ _e125)));
                                        let _e1477 = select(select(_e668.member.member_1[1], _e1473, (_e1473 < _e668.member.member_1[1])), _e668.member.member_1[1], (_e1465 == 1023u));
                                        let _e1480 = ((_e1320.member_1[0] >> bitcast<u32>(_e1379)) & 1023u);
                                        let _e1488 = (_e668.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1480)) - 8388608f) * _e1390)) ^ _e125)));
                                        let _e1492 = select(select(_e668.member.member_1[2], _e1488, (_e1488 < _e668.member.member_1[2])), _e668.member.member_1[2], (_e1480 == 1023u));
                                        let _e1495 = ((_e1320.member_1[1] >> bitcast<u32>(_e1335)) & 1023u);
                                        let _e1503 = (_e668.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1495)) - 8388608f) * _e1346)) ^ _e125)));
                                        let _e1507 = select(select(_e668.member.member_1[0], _e1503, (_e1503 < _e668.member.member_1[0])), _e668.member.member_1[0], (_e1495 == 1023u));
                                        let _e1510 = ((_e1320.member_1[1] >> bitcast<u32>(_e1357)) & 1023u);
                                        let _e1518 = (_e668.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1510)) - 8388608f) * _e1368)) ^ _e125)));
                                        let _e1522 = select(select(_e668.member.member_1[1], _e1518, (_e1518 < _e668.member.member_1[1])), _e668.member.member_1[1], (_e1510 == 1023u));
                                        let _e1525 = ((_e1320.member_1[1] >> bitcast<u32>(_e1379)) & 1023u);
                                        let _e1533 = (_e668.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1525)) - 8388608f) * _e1390)) ^ _e125)));
                                        let _e1537 = select(select(_e668.member.member_1[2], _e1533, (_e1533 < _e668.member.member_1[2])), _e668.member.member_1[2], (_e1525 == 1023u));
                                        let _e1542 = type_52(type_50(array<f32, 3>(_e1355, _e1377, _e1399), array<f32, 3>(_e1414, _e1429, _e1444)), _e1320.member_2);
                                        let _e1547 = type_52(type_50(array<f32, 3>(_e1462, _e1477, _e1492), array<f32, 3>(_e1507, _e1522, _e1537)), _e1320.member_3);
                                        let _e1552 = ((_e1355 - _e355) * _e358);
                                        let _e1553 = ((_e1462 - _e355) * _e358);
                                        let _e1554 = ((_e1414 - _e356) * _e358);
                                        let _e1555 = ((_e1507 - _e356) * _e358);
                                        let _e1560 = ((_e1377 - _e421) * _e424);
                                        let _e1561 = ((_e1477 - _e421) * _e424);
                                        let _e1562 = ((_e1429 - _e422) * _e424);
                                        let _e1563 = ((_e1522 - _e422) * _e424);
                                        let _e1568 = ((_e1399 - _e487) * _e490);
                                        let _e1569 = ((_e1492 - _e487) * _e490);
                                        let _e1570 = ((_e1444 - _e488) * _e490);
                                        let _e1571 = ((_e1537 - _e488) * _e490);
                                        let _e1573 = select(_e1570, _e1568, (_e1568 < _e1570));
                                        let _e1575 = select(_e1571, _e1569, (_e1569 < _e1571));
                                        let _e1577 = select(_e1570, _e1568, (_e1568 > _e1570));
                                        let _e1579 = select(_e1571, _e1569, (_e1569 > _e1571));
                                        let _e1581 = select(_e1554, _e1552, (_e1552 < _e1554));
                                        let _e1583 = select(_e1555, _e1553, (_e1553 < _e1555));
                                        let _e1585 = select(_e1562, _e1560, (_e1560 < _e1562));
                                        let _e1587 = select(_e1563, _e1561, (_e1561 < _e1563));
                                        let _e1589 = select(_e1585, _e1581, (_e1581 > _e1585));
                                        let _e1591 = select(_e1587, _e1583, (_e1583 > _e1587));
                                        let _e1593 = select(_e1573, _e1589, (_e1589 > _e1573));
                                        let _e1595 = select(_e1575, _e1591, (_e1591 > _e1575));
                                        let _e1597 = select(_e1554, _e1552, (_e1552 > _e1554));
                                        let _e1599 = select(_e1555, _e1553, (_e1553 > _e1555));
                                        let _e1601 = select(_e1562, _e1560, (_e1560 > _e1562));
                                        let _e1603 = select(_e1563, _e1561, (_e1561 > _e1563));
                                        let _e1605 = select(_e1601, _e1597, (_e1597 < _e1601));
                                        let _e1607 = select(_e1603, _e1599, (_e1599 < _e1603));
                                        let _e1612 = -(_e1573);
                                        let _e1613 = -(_e1575);
                                        let _e1620 = (select(_e1577, _e1605, (_e1605 < _e1577)) + (select(_e1612, _e1577, (_e1577 > _e1612)) * 0.0000019073523f));
                                        let _e1621 = (select(_e1579, _e1607, (_e1607 < _e1579)) + (select(_e1613, _e1579, (_e1579 > _e1613)) * 0.0000019073523f));
                                        let _e1623 = select(_e593, _e1593, (_e1593 > _e593));
                                        let _e1625 = select(_e593, _e1595, (_e1595 > _e593));
                                        let _e1630 = (_e1623 <= select(_e1315, _e1620, (_e1620 < _e1315)));
                                        let _e1631 = (_e1625 <= select(_e1315, _e1621, (_e1621 < _e1315)));
                                        let _e1632 = (_e1623 <= _e1625);
                                        if _e1630 {
                                            if _e1631 {
                                                if _e1632 {
                                                    phi_3250_ = _e1547;
                                                } else {
                                                    phi_3250_ = _e1542;
                                                }
                                                let _e1634 = phi_3250_;
                                                let _e1641 = (_e666 % 128u);
                                                let _e1642 = (_e1641 < 128u);
                                                if _e1642 {
                                                } else {
                                                    phi_4169_ = true;
                                                    break;
                                                }
                                                local_6[_e1641] = _e1634.member_1;
                                                if _e1642 {
                                                } else {
                                                    phi_4169_ = true;
                                                    break;
                                                }
                                                local_5[_e1641] = _e1634.member.member[0];
                                                if _e1642 {
                                                } else {
                                                    phi_4169_ = true;
                                                    break;
                                                }
                                                local_4[_e1641] = _e1634.member.member[1];
                                                if _e1642 {
                                                } else {
                                                    phi_4169_ = true;
                                                    break;
                                                }
                                                local_3[_e1641] = _e1634.member.member[2];
                                                if _e1642 {
                                                } else {
                                                    phi_4169_ = true;
                                                    break;
                                                }
                                                local_2[_e1641] = _e1634.member.member_1[0];
                                                if _e1642 {
                                                } else {
                                                    phi_4169_ = true;
                                                    break;
                                                }
                                                local_1[_e1641] = _e1634.member.member_1[1];
                                                if _e1642 {
                                                } else {
                                                    phi_4169_ = true;
                                                    break;
                                                }
                                                local[_e1641] = _e1634.member.member_1[2];
                                                if _e1642 {
                                                } else {
                                                    phi_4169_ = true;
                                                    break;
                                                }
                                                local_8[_e1641] = select(_e1623, _e1625, _e1632);
                                                if _e1632 {
                                                    phi_3326_ = _e1542;
                                                } else {
                                                    phi_3326_ = _e1547;
                                                }
                                                let _e1659 = phi_3326_;
                                                phi_3327_ = (_e666 + 1u);
                                                phi_3328_ = _e1659;
                                            } else {
                                                phi_3327_ = u32();
                                                phi_3328_ = type_52();
                                            }
                                            let _e1661 = phi_3327_;
                                            let _e1663 = phi_3328_;
                                            phi_3330_ = _e1661;
                                            phi_3331_ = _e1663;
                                            phi_3332_ = select(true, false, _e1631);
                                        } else {
                                            phi_3330_ = u32();
                                            phi_3331_ = type_52();
                                            phi_3332_ = true;
                                        }
                                        let _e1666 = phi_3330_;
                                        let _e1668 = phi_3331_;
                                        let _e1670 = phi_3332_;
                                        if _e1670 {
                                            if _e1630 {
                                                phi_3339_ = _e1542;
                                            } else {
                                                phi_3339_ = _e1547;
                                            }
                                            let _e1672 = phi_3339_;
                                            phi_3344_ = select(_e1631, true, _e1630);
                                            phi_3346_ = _e1672;
                                        } else {
                                            phi_3344_ = _e664;
                                            phi_3346_ = _e1668;
                                        }
                                        let _e1675 = phi_3344_;
                                        let _e1677 = phi_3346_;
                                        phi_3350_ = _e1675;
                                        phi_3351_ = select(_e1666, _e666, _e1670);
                                        phi_3352_ = _e1677;
                                    }
                                    let _e1680 = phi_3350_;
                                    let _e1682 = phi_3351_;
                                    let _e1684 = phi_3352_;
                                    if _e672 {
                                        phi_3362_ = _e668;
                                    } else {
                                        phi_3362_ = _e1684;
                                    }
                                    let _e1686 = phi_3362_;
                                    phi_4255_ = _e1315;
                                    phi_4172_ = _e1313;
                                    phi_3363_ = (_e628 - 1u);
                                    phi_3364_ = select(_e1680, false, _e672);
                                    phi_3365_ = select(_e1682, _e666, _e672);
                                    phi_3366_ = _e1686;
                                } else {
                                    phi_4255_ = _e626;
                                    phi_4172_ = _e624;
                                    phi_3363_ = _e628;
                                    phi_3364_ = _e664;
                                    phi_3365_ = _e666;
                                    phi_3366_ = _e668;
                                }
                                let _e1690 = phi_4255_;
                                let _e1692 = phi_4172_;
                                let _e1694 = phi_3363_;
                                let _e1696 = phi_3364_;
                                let _e1698 = phi_3365_;
                                let _e1700 = phi_3366_;
                                phi_4254_ = _e1690;
                                phi_4171_ = _e1692;
                                phi_3367_ = _e1694;
                                phi_3368_ = _e1696;
                                phi_3369_ = _e1698;
                                phi_3370_ = _e1700;
                            } else {
                                phi_4254_ = _e626;
                                phi_4171_ = _e624;
                                phi_3367_ = u32();
                                phi_3368_ = bool();
                                phi_3369_ = u32();
                                phi_3370_ = type_52();
                            }
                            let _e1702 = phi_4254_;
                            let _e1704 = phi_4171_;
                            let _e1706 = phi_3367_;
                            let _e1708 = phi_3368_;
                            let _e1710 = phi_3369_;
                            let _e1712 = phi_3370_;
                            phi_4253_ = _e1702;
                            phi_4170_ = _e1704;
                            phi_1181_ = _e1706;
                            phi_1184_ = _e1708;
                            phi_1186_ = _e1710;
                            phi_1188_ = _e1712;
                            phi_3371_ = _e638;
                        } else {
                            phi_4253_ = _e626;
                            phi_4170_ = _e624;
                            phi_1181_ = u32();
                            phi_1184_ = bool();
                            phi_1186_ = u32();
                            phi_1188_ = type_52();
                            phi_3371_ = false;
                        }
                        let _e1714 = phi_4253_;
                        let _e1716 = phi_4170_;
                        let _e1718 = phi_1181_;
                        let _e1720 = phi_1184_;
                        let _e1722 = phi_1186_;
                        let _e1724 = phi_1188_;
                        let _e1726 = phi_3371_;
                        continue;
                        continuing {
                            phi_3889_ = _e1716;
                            phi_3869_ = _e1714;
                            phi_1180_ = _e1718;
                            phi_1183_ = _e1720;
                            phi_1185_ = _e1722;
                            phi_1187_ = _e1724;
                            phi_4169_ = _e1716;
                            break if !(_e1726);
                        }
                    }
                    let _e1729 = phi_4169_;
                    if _e1729 {
                        break;
                    }
                    phi_3378_ = type_4(0u, 8u);
                    loop {
                        let _e1731 = phi_3378_;
                        if (_e1731.member < _e1731.member_1) {
                            phi_3379_ = type_4((_e1731.member + 1u), _e1731.member_1);
                            phi_3402_ = type_4(1u, _e1731.member);
                        } else {
                            phi_3379_ = _e1731;
                            phi_3402_ = type_4(0u, type_4().member_1);
                        }
                        let _e1744 = phi_3379_;
                        let _e1746 = phi_3402_;
                        let _e1750 = (bitcast<i32>(_e1746.member) != 0i);
                        if _e1750 {
                            let _e1751 = (_e1746.member_1 < 8u);
                            if _e1751 {
                            } else {
                                phi_4235_ = true;
                                break;
                            }
                            let _e1753 = local_7[_e1746.member_1];
                            if (_e1753.member_3 != 4294967295u) {
                                let _e1759 = -(_e495);
                                let _e1760 = bitcast<u32>(_e1753.member);
                                let _e1764 = (bitcast<i32>((_e1760 >> bitcast<u32>(23i))) & 255i);
                                let _e1765 = (_e1764 + _e1759);
                                if (_e1764 == 255i) {
                                    phi_3475_ = _e1753.member;
                                } else {
                                    if (_e1764 > 0i) {
                                        if (_e1765 > 0i) {
                                            let _e1769 = (_e1765 < 255i);
                                            if _e1769 {
                                                phi_3454_ = bitcast<f32>((_e1760 + bitcast<u32>((_e1759 << bitcast<u32>(23i)))));
                                            } else {
                                                phi_3454_ = f32();
                                            }
                                            let _e1776 = phi_3454_;
                                            phi_3456_ = _e1776;
                                            phi_3457_ = select(true, false, _e1769);
                                        } else {
                                            phi_3456_ = f32();
                                            phi_3457_ = true;
                                        }
                                        let _e1779 = phi_3456_;
                                        let _e1781 = phi_3457_;
                                        phi_3458_ = _e1779;
                                        phi_3459_ = _e1781;
                                    } else {
                                        phi_3458_ = f32();
                                        phi_3459_ = true;
                                    }
                                    let _e1783 = phi_3458_;
                                    let _e1785 = phi_3459_;
                                    if _e1785 {
                                        let _e1786 = (_e1760 & 2147483648u);
                                        let _e1793 = ((_e1760 & 8388607u) | (select(0u, 1u, ((_e1760 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                        let _e1797 = (_e1793 == 0u);
                                        if _e1797 {
                                            phi_3828_ = bitcast<f32>(_e1786);
                                        } else {
                                            let _e1802 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1793)), 32u, _e1797) - 8u);
                                            let _e1805 = (_e1793 << bitcast<u32>((_e1802 & 31u)));
                                            let _e1807 = ((_e1765 + select(0i, 1i, (_e1764 == 0i))) - bitcast<i32>(_e1802));
                                            if (_e1807 >= 255i) {
                                                phi_3818_ = bitcast<f32>((_e1786 | 2139095040u));
                                                phi_3819_ = f32();
                                                phi_3820_ = true;
                                            } else {
                                                let _e1809 = (_e1807 > 0i);
                                                if _e1809 {
                                                    phi_3812_ = bitcast<f32>(((_e1786 | (bitcast<u32>(_e1807) << bitcast<u32>(23i))) | (_e1805 & 8388607u)));
                                                    phi_3813_ = f32();
                                                } else {
                                                    if (_e1807 < -24i) {
                                                        phi_3778_ = 26u;
                                                    } else {
                                                        phi_3778_ = bitcast<u32>((1i - _e1807));
                                                    }
                                                    let _e1814 = phi_3778_;
                                                    let _e1815 = (_e1814 & 31u);
                                                    let _e1817 = (_e1805 >> bitcast<u32>(_e1815));
                                                    let _e1821 = (_e1805 & ((1u << bitcast<u32>(_e1815)) - 1u));
                                                    let _e1825 = (1u << bitcast<u32>(((_e1814 - 1u) & 31u)));
                                                    if (_e1821 > _e1825) {
                                                        phi_3799_ = true;
                                                    } else {
                                                        if (_e1821 == _e1825) {
                                                            phi_3796_ = ((_e1817 & 1u) == 1u);
                                                        } else {
                                                            phi_3796_ = false;
                                                        }
                                                        let _e1831 = phi_3796_;
                                                        phi_3799_ = _e1831;
                                                    }
                                                    let _e1833 = phi_3799_;
                                                    phi_3812_ = f32();
                                                    phi_3813_ = bitcast<f32>((_e1786 | (_e1817 + select(0u, 1u, _e1833))));
                                                }
                                                let _e1846 = phi_3812_;
                                                let _e1848 = phi_3813_;
                                                phi_3818_ = _e1846;
                                                phi_3819_ = _e1848;
                                                phi_3820_ = _e1809;
                                            }
                                            let _e1852 = phi_3818_;
                                            let _e1854 = phi_3819_;
                                            let _e1856 = phi_3820_;
                                            phi_3828_ = select(_e1854, _e1852, _e1856);
                                        }
                                        let _e1860 = phi_3828_;
                                        phi_3474_ = _e1860;
                                    } else {
                                        phi_3474_ = _e1783;
                                    }
                                    let _e1862 = phi_3474_;
                                    phi_3475_ = _e1862;
                                }
                                let _e1864 = phi_3475_;
                                let _e1865 = bitcast<u32>(_e1864);
                                if ((_e1865 & 2147483647u) >= 2139095040u) {
                                    phi_3487_ = bitcast<f32>(((_e1865 & 2147483648u) | 2139095039u));
                                } else {
                                    phi_3487_ = _e1864;
                                }
                                let _e1872 = phi_3487_;
                                phi_3492_ = type_22(_e1872, _e1753.member_1, _e1753.member_2, _e1753.member_3);
                            } else {
                                phi_3492_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1875 = phi_3492_;
                            if _e1751 {
                            } else {
                                phi_4235_ = true;
                                break;
                            }
                            local_7[_e1746.member_1] = type_22(_e1875.member, _e1875.member_1, _e1875.member_2, _e1875.member_3);
                        }
                        continue;
                        continuing {
                            phi_3378_ = _e1744;
                            phi_4235_ = _e1729;
                            break if !(_e1750);
                        }
                    }
                    let _e1883 = phi_4235_;
                    if _e1883 {
                        break;
                    }
                    let _e1884 = local_7;
                    if _e141 {
                    } else {
                        break;
                    }
                    global_6.member[_e139] = array<type_22, 8>(type_22(_e1884[0].member, _e1884[0].member_1, _e1884[0].member_2, _e1884[0].member_3), type_22(_e1884[1].member, _e1884[1].member_1, _e1884[1].member_2, _e1884[1].member_3), type_22(_e1884[2].member, _e1884[2].member_1, _e1884[2].member_2, _e1884[2].member_3), type_22(_e1884[3].member, _e1884[3].member_1, _e1884[3].member_2, _e1884[3].member_3), type_22(_e1884[4].member, _e1884[4].member_1, _e1884[4].member_2, _e1884[4].member_3), type_22(_e1884[5].member, _e1884[5].member_1, _e1884[5].member_2, _e1884[5].member_3), type_22(_e1884[6].member, _e1884[6].member_1, _e1884[6].member_2, _e1884[6].member_3), type_22(_e1884[7].member, _e1884[7].member_1, _e1884[7].member_2, _e1884[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
