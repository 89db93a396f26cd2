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
    var phi_458_: i32;
    var phi_459_: i32;
    var phi_469_: bool;
    var phi_479_: u32;
    var phi_480_: u32;
    var phi_482_: bool;
    var phi_487_: u32;
    var phi_500_: i32;
    var phi_520_: i32;
    var phi_538_: f32;
    var phi_544_: f32;
    var phi_584_: f32;
    var phi_590_: f32;
    var phi_663_: f32;
    var phi_669_: f32;
    var phi_709_: f32;
    var phi_715_: f32;
    var phi_788_: f32;
    var phi_794_: f32;
    var phi_834_: f32;
    var phi_840_: f32;
    var phi_959_: i32;
    var phi_981_: u32;
    var phi_982_: u32;
    var phi_1019_: i32;
    var phi_1041_: u32;
    var phi_1042_: u32;
    var phi_1050_: f32;
    var phi_1051_: f32;
    var phi_3844_: bool;
    var phi_3799_: f32;
    var phi_1187_: bool;
    var phi_1190_: type_52;
    var phi_1192_: u32;
    var phi_1194_: u32;
    var phi_1205_: bool;
    var phi_1292_: bool;
    var phi_1293_: type_52;
    var phi_1294_: u32;
    var phi_2342_: type_45;
    var phi_3229_: type_52;
    var phi_3305_: type_52;
    var phi_3306_: type_52;
    var phi_3307_: u32;
    var phi_3309_: type_52;
    var phi_3310_: u32;
    var phi_3311_: bool;
    var phi_3318_: type_52;
    var phi_3323_: bool;
    var phi_3324_: type_52;
    var phi_3841_: bool;
    var phi_3830_: f32;
    var phi_1312_: type_4;
    var phi_1313_: type_4;
    var phi_1336_: type_4;
    var phi_1357_: u32;
    var phi_1449_: array<array<f32, 3>, 3>;
    var phi_1980_: f32;
    var phi_1981_: f32;
    var phi_1982_: f32;
    var phi_1983_: f32;
    var phi_1984_: vec3<f32>;
    var phi_1985_: vec3<f32>;
    var phi_1986_: vec3<f32>;
    var phi_1987_: vec3<f32>;
    var phi_2178_: f32;
    var phi_2198_: type_31;
    var phi_2199_: type_31;
    var phi_2202_: type_31;
    var phi_2203_: type_31;
    var phi_2204_: bool;
    var phi_2208_: type_31;
    var phi_2217_: type_22;
    var phi_2229_: type_4;
    var phi_2232_: type_22;
    var phi_2230_: type_4;
    var phi_2255_: type_4;
    var phi_2287_: bool;
    var phi_2288_: bool;
    var phi_2309_: type_22;
    var phi_2233_: type_22;
    var phi_3831_: bool;
    var phi_4073_: f32;
    var phi_4072_: f32;
    var phi_3987_: bool;
    var phi_4071_: f32;
    var phi_3986_: bool;
    var phi_4070_: f32;
    var phi_3985_: bool;
    var phi_3989_: f32;
    var phi_3984_: bool;
    var phi_4160_: f32;
    var phi_4078_: bool;
    var phi_3326_: bool;
    var phi_3327_: type_52;
    var phi_3328_: u32;
    var phi_4159_: f32;
    var phi_4077_: bool;
    var phi_3329_: bool;
    var phi_3330_: type_52;
    var phi_3331_: u32;
    var phi_3332_: u32;
    var phi_4158_: f32;
    var phi_4076_: bool;
    var phi_3333_: bool;
    var phi_3334_: type_52;
    var phi_3335_: u32;
    var phi_3336_: u32;
    var phi_4157_: f32;
    var phi_4075_: bool;
    var phi_1188_: bool;
    var phi_1191_: type_52;
    var phi_1193_: u32;
    var phi_1195_: u32;
    var phi_3337_: bool;
    var phi_4074_: bool;
    var phi_3344_: type_4;
    var phi_3345_: type_4;
    var phi_3368_: type_4;
    var phi_3420_: f32;
    var phi_3422_: f32;
    var phi_3423_: bool;
    var phi_3424_: f32;
    var phi_3425_: bool;
    var phi_3708_: u32;
    var phi_3726_: bool;
    var phi_3729_: bool;
    var phi_3742_: f32;
    var phi_3743_: f32;
    var phi_3748_: f32;
    var phi_3749_: f32;
    var phi_3750_: bool;
    var phi_3758_: f32;
    var phi_3440_: f32;
    var phi_3441_: f32;
    var phi_3453_: f32;
    var phi_3458_: type_22;
    var phi_4139_: bool;

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
                            phi_458_ = (bitcast<i32>((_e218 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_458_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e218)), 32u, (_e218 == 0u))));
                        }
                        let _e232 = phi_458_;
                        phi_459_ = _e232;
                    } else {
                        phi_459_ = 0i;
                    }
                    let _e234 = phi_459_;
                    let _e235 = (_e151 == _e190);
                    if _e235 {
                        phi_469_ = true;
                    } else {
                        phi_469_ = (_e158 == _e190);
                    }
                    let _e238 = phi_469_;
                    let _e239 = select(1u, 0u, _e235);
                    if _e238 {
                        let _e240 = (_e239 + 1u);
                        phi_479_ = _e240;
                        phi_480_ = _e240;
                        phi_482_ = select(true, false, (_e240 == 2u));
                    } else {
                        phi_479_ = u32();
                        phi_480_ = 0u;
                        phi_482_ = true;
                    }
                    let _e244 = phi_479_;
                    let _e246 = phi_480_;
                    let _e248 = phi_482_;
                    if _e248 {
                        phi_487_ = (_e246 + 1u);
                    } else {
                        phi_487_ = 0u;
                    }
                    let _e252 = phi_487_;
                    let _e253 = select(_e244, _e246, _e248);
                    let _e254 = select(_e239, select(2u, _e239, _e238), _e248);
                    if (_e129 < -126i) {
                        phi_500_ = -126i;
                    } else {
                        phi_500_ = select(_e129, 127i, (_e129 > 127i));
                    }
                    let _e259 = phi_500_;
                    let _e264 = bitcast<f32>((bitcast<u32>((_e259 + 127i)) << bitcast<u32>(23i)));
                    let _e270 = bitcast<f32>((bitcast<u32>(((_e129 - _e259) + 127i)) << bitcast<u32>(23i)));
                    let _e271 = -(_e234);
                    if (_e271 < -126i) {
                        phi_520_ = -126i;
                    } else {
                        phi_520_ = select(_e271, 127i, (_e271 > 127i));
                    }
                    let _e276 = phi_520_;
                    let _e281 = bitcast<f32>((bitcast<u32>((_e276 + 127i)) << bitcast<u32>(23i)));
                    let _e287 = bitcast<f32>((bitcast<u32>(((_e271 - _e276) + 127i)) << bitcast<u32>(23i)));
                    let _e291 = global_4.member[_e139].member;
                    let _e292 = (_e253 == 0u);
                    if _e292 {
                        phi_538_ = _e291[0];
                    } else {
                        phi_538_ = _e291[1];
                    }
                    let _e296 = phi_538_;
                    let _e297 = (_e253 == 2u);
                    if _e297 {
                        phi_544_ = _e291[2];
                    } else {
                        phi_544_ = _e296;
                    }
                    let _e300 = phi_544_;
                    let _e301 = bitcast<u32>(_e300);
                    let _e303 = ((_e301 & 2139095040u) != 0u);
                    let _e317 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e301 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e301 & 2147483648u))), _e300, _e303) * _e264) * select(0.00000011920929f, 1f, _e303)) * _e270);
                    let _e318 = global_4.member[_e139].member_2;
                    if _e292 {
                        phi_584_ = _e318[0];
                    } else {
                        phi_584_ = _e318[1];
                    }
                    let _e322 = phi_584_;
                    if _e297 {
                        phi_590_ = _e318[2];
                    } else {
                        phi_590_ = _e322;
                    }
                    let _e325 = phi_590_;
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
                        phi_663_ = _e291[0];
                    } else {
                        phi_663_ = _e291[1];
                    }
                    let _e363 = phi_663_;
                    let _e364 = (_e252 == 2u);
                    if _e364 {
                        phi_669_ = _e291[2];
                    } else {
                        phi_669_ = _e363;
                    }
                    let _e367 = phi_669_;
                    let _e368 = bitcast<u32>(_e367);
                    let _e370 = ((_e368 & 2139095040u) != 0u);
                    let _e384 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e368 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e368 & 2147483648u))), _e367, _e370) * _e264) * select(0.00000011920929f, 1f, _e370)) * _e270);
                    if _e359 {
                        phi_709_ = _e318[0];
                    } else {
                        phi_709_ = _e318[1];
                    }
                    let _e388 = phi_709_;
                    if _e364 {
                        phi_715_ = _e318[2];
                    } else {
                        phi_715_ = _e388;
                    }
                    let _e391 = phi_715_;
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
                        phi_788_ = _e291[0];
                    } else {
                        phi_788_ = _e291[1];
                    }
                    let _e429 = phi_788_;
                    let _e430 = (_e254 == 2u);
                    if _e430 {
                        phi_794_ = _e291[2];
                    } else {
                        phi_794_ = _e429;
                    }
                    let _e433 = phi_794_;
                    let _e434 = bitcast<u32>(_e433);
                    let _e436 = ((_e434 & 2139095040u) != 0u);
                    let _e450 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e434 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e434 & 2147483648u))), _e433, _e436) * _e264) * select(0.00000011920929f, 1f, _e436)) * _e270);
                    if _e425 {
                        phi_834_ = _e318[0];
                    } else {
                        phi_834_ = _e318[1];
                    }
                    let _e454 = phi_834_;
                    if _e430 {
                        phi_840_ = _e318[2];
                    } else {
                        phi_840_ = _e454;
                    }
                    let _e457 = phi_840_;
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
                            phi_959_ = 255i;
                        } else {
                            phi_959_ = (((_e508 + select(0i, 1i, (_e508 == 0i))) - _e515) + _e495);
                        }
                        let _e523 = phi_959_;
                        let _e533 = (_e523 <= 0i);
                        if _e533 {
                            phi_982_ = u32();
                        } else {
                            if _e512 {
                                phi_981_ = u32();
                            } else {
                                phi_981_ = select(((bitcast<u32>(_e523) << bitcast<u32>(23i)) | ((_e505 << bitcast<u32>(((_e515 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e523 >= 255i));
                            }
                            let _e537 = phi_981_;
                            phi_982_ = _e537;
                        }
                        let _e539 = phi_982_;
                        let _e551 = ((_e211 & 8388607u) | (select(0u, 1u, ((_e211 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e554 = bitcast<i32>((_e211 >> bitcast<u32>(23i)));
                        let _e558 = (_e551 == 0u);
                        let _e561 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e551)), 32u, _e558)) - 8i);
                        if (_e554 == 255i) {
                            phi_1019_ = 255i;
                        } else {
                            phi_1019_ = (((_e554 + select(0i, 1i, (_e554 == 0i))) - _e561) + _e495);
                        }
                        let _e569 = phi_1019_;
                        let _e579 = (_e569 <= 0i);
                        if _e579 {
                            phi_1042_ = u32();
                        } else {
                            if _e558 {
                                phi_1041_ = u32();
                            } else {
                                phi_1041_ = select(((bitcast<u32>(_e569) << bitcast<u32>(23i)) | ((_e551 << bitcast<u32>(((_e561 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e569 >= 255i));
                            }
                            let _e583 = phi_1041_;
                            phi_1042_ = _e583;
                        }
                        let _e585 = phi_1042_;
                        phi_1050_ = bitcast<f32>(((_e210 & 2147483648u) | select(_e585, 0u, select(_e558, true, _e579))));
                        phi_1051_ = bitcast<f32>(((_e201 & 2147483648u) | select(_e539, 0u, select(_e512, true, _e533))));
                    } else {
                        phi_1050_ = 0f;
                        phi_1051_ = 1f;
                    }
                    let _e591 = phi_1050_;
                    let _e593 = phi_1051_;
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
                    let _e599 = (_e253 % 3u);
                    let _e600 = (_e599 < 3u);
                    if _e600 {
                    } else {
                        break;
                    }
                    let _e602 = local_10[_e599];
                    let _e603 = (_e252 % 3u);
                    let _e604 = (_e603 < 3u);
                    if _e604 {
                    } else {
                        break;
                    }
                    let _e606 = local_10[_e603];
                    let _e607 = (_e254 % 3u);
                    let _e608 = (_e607 < 3u);
                    if _e608 {
                    } else {
                        break;
                    }
                    let _e610 = local_10[_e607];
                    local_9 = array<f32, 3>(bitcast<f32>(_e113), bitcast<f32>(_e117), bitcast<f32>(_e121));
                    if _e600 {
                    } else {
                        break;
                    }
                    let _e614 = local_9[_e599];
                    if _e604 {
                    } else {
                        break;
                    }
                    let _e616 = local_9[_e603];
                    if _e608 {
                    } else {
                        break;
                    }
                    let _e618 = local_9[_e607];
                    phi_3844_ = false;
                    phi_3799_ = _e591;
                    phi_1187_ = (_e593 <= _e591);
                    phi_1190_ = type_52(type_50(array<f32, 3>(_e602, _e606, _e610), array<f32, 3>(_e614, _e616, _e618)), select(0u, 2147483648u, (_e91 == 0u)));
                    phi_1192_ = 0u;
                    phi_1194_ = ((3u * _e91) + 1u);
                    loop {
                        let _e624 = phi_3844_;
                        let _e626 = phi_3799_;
                        let _e628 = phi_1187_;
                        let _e630 = phi_1190_;
                        let _e632 = phi_1192_;
                        let _e634 = phi_1194_;
                        if _e628 {
                            phi_1205_ = true;
                        } else {
                            phi_1205_ = (_e632 > 0u);
                        }
                        let _e637 = phi_1205_;
                        if _e637 {
                            let _e638 = (_e634 > 0u);
                            if _e638 {
                                if _e628 {
                                    phi_1292_ = _e628;
                                    phi_1293_ = _e630;
                                    phi_1294_ = _e632;
                                } else {
                                    let _e639 = (_e632 - 1u);
                                    let _e640 = (_e639 % 128u);
                                    let _e641 = (_e640 < 128u);
                                    if _e641 {
                                    } else {
                                        phi_4074_ = true;
                                        break;
                                    }
                                    let _e643 = local_6[_e640];
                                    if _e641 {
                                    } else {
                                        phi_4074_ = true;
                                        break;
                                    }
                                    let _e645 = local_5[_e640];
                                    if _e641 {
                                    } else {
                                        phi_4074_ = true;
                                        break;
                                    }
                                    let _e647 = local_4[_e640];
                                    if _e641 {
                                    } else {
                                        phi_4074_ = true;
                                        break;
                                    }
                                    let _e649 = local_3[_e640];
                                    if _e641 {
                                    } else {
                                        phi_4074_ = true;
                                        break;
                                    }
                                    let _e652 = local_2[_e640];
                                    if _e641 {
                                    } else {
                                        phi_4074_ = true;
                                        break;
                                    }
                                    let _e654 = local_1[_e640];
                                    if _e641 {
                                    } else {
                                        phi_4074_ = true;
                                        break;
                                    }
                                    let _e656 = local[_e640];
                                    if _e641 {
                                    } else {
                                        phi_4074_ = true;
                                        break;
                                    }
                                    let _e661 = local_8[_e640];
                                    phi_1292_ = (_e661 <= _e626);
                                    phi_1293_ = type_52(type_50(array<f32, 3>(_e645, _e647, _e649), array<f32, 3>(_e652, _e654, _e656)), _e643);
                                    phi_1294_ = _e639;
                                }
                                let _e664 = phi_1292_;
                                let _e666 = phi_1293_;
                                let _e668 = phi_1294_;
                                if _e664 {
                                    if ((_e666.member_1 & 2147483648u) != 0u) {
                                        phi_3841_ = _e624;
                                        phi_3830_ = _e626;
                                        phi_1312_ = type_4(0u, ((_e666.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1042 = phi_3841_;
                                            let _e1044 = phi_3830_;
                                            let _e1046 = phi_1312_;
                                            if (_e1046.member < _e1046.member_1) {
                                                phi_1313_ = type_4((_e1046.member + 1u), _e1046.member_1);
                                                phi_1336_ = type_4(1u, _e1046.member);
                                            } else {
                                                phi_1313_ = _e1046;
                                                phi_1336_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1059 = phi_1313_;
                                            let _e1061 = phi_1336_;
                                            let _e1065 = (bitcast<i32>(_e1061.member) != 0i);
                                            if _e1065 {
                                                let _e1066 = ((_e666.member_1 & 268435455u) + _e1061.member_1);
                                                let _e1067 = (_e1066 < _e93);
                                                if _e1067 {
                                                    if _e1067 {
                                                    } else {
                                                        phi_3989_ = _e1044;
                                                        phi_3984_ = true;
                                                        break;
                                                    }
                                                    let _e1071 = global_2.member[_e1066].member_1;
                                                    phi_1357_ = _e1071;
                                                } else {
                                                    phi_1357_ = 4294967295u;
                                                }
                                                let _e1073 = phi_1357_;
                                                if (_e1066 >= _e93) {
                                                    phi_1449_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1067 {
                                                    } else {
                                                        phi_3989_ = _e1044;
                                                        phi_3984_ = true;
                                                        break;
                                                    }
                                                    if (_e599 < 9u) {
                                                    } else {
                                                        phi_3989_ = _e1044;
                                                        phi_3984_ = true;
                                                        break;
                                                    }
                                                    let _e1080 = global_2.member[_e1066].member[_e599];
                                                    if (_e603 < 9u) {
                                                    } else {
                                                        phi_3989_ = _e1044;
                                                        phi_3984_ = true;
                                                        break;
                                                    }
                                                    let _e1086 = global_2.member[_e1066].member[_e603];
                                                    if (_e607 < 9u) {
                                                    } else {
                                                        phi_3989_ = _e1044;
                                                        phi_3984_ = true;
                                                        break;
                                                    }
                                                    let _e1092 = global_2.member[_e1066].member[_e607];
                                                    let _e1094 = (3u + _e599);
                                                    if (_e1094 < 9u) {
                                                    } else {
                                                        phi_3989_ = _e1044;
                                                        phi_3984_ = true;
                                                        break;
                                                    }
                                                    let _e1100 = global_2.member[_e1066].member[_e1094];
                                                    let _e1101 = (3u + _e603);
                                                    if (_e1101 < 9u) {
                                                    } else {
                                                        phi_3989_ = _e1044;
                                                        phi_3984_ = true;
                                                        break;
                                                    }
                                                    let _e1107 = global_2.member[_e1066].member[_e1101];
                                                    let _e1108 = (3u + _e607);
                                                    if (_e1108 < 9u) {
                                                    } else {
                                                        phi_3989_ = _e1044;
                                                        phi_3984_ = true;
                                                        break;
                                                    }
                                                    let _e1114 = global_2.member[_e1066].member[_e1108];
                                                    let _e1116 = (6u + _e599);
                                                    if (_e1116 < 9u) {
                                                    } else {
                                                        phi_3989_ = _e1044;
                                                        phi_3984_ = true;
                                                        break;
                                                    }
                                                    let _e1122 = global_2.member[_e1066].member[_e1116];
                                                    let _e1123 = (6u + _e603);
                                                    if (_e1123 < 9u) {
                                                    } else {
                                                        phi_3989_ = _e1044;
                                                        phi_3984_ = true;
                                                        break;
                                                    }
                                                    let _e1129 = global_2.member[_e1066].member[_e1123];
                                                    let _e1130 = (6u + _e607);
                                                    if (_e1130 < 9u) {
                                                    } else {
                                                        phi_3989_ = _e1044;
                                                        phi_3984_ = true;
                                                        break;
                                                    }
                                                    let _e1136 = global_2.member[_e1066].member[_e1130];
                                                    phi_1449_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1080, _e1086, _e1092), array<f32, 3>(_e1100, _e1107, _e1114), array<f32, 3>(_e1122, _e1129, _e1136));
                                                }
                                                let _e1140 = phi_1449_;
                                                let _e1155 = (_e1140[0][2] - _e450);
                                                let _e1158 = (((_e1140[0][0] - _e317) * _e486) - (_e1155 * _e354));
                                                let _e1161 = (((_e1140[0][1] - _e384) * _e486) - (_e1155 * _e420));
                                                let _e1164 = (_e1140[1][2] - _e450);
                                                let _e1167 = (((_e1140[1][0] - _e317) * _e486) - (_e1164 * _e354));
                                                let _e1170 = (((_e1140[1][1] - _e384) * _e486) - (_e1164 * _e420));
                                                let _e1173 = (_e1140[2][2] - _e450);
                                                let _e1176 = (((_e1140[2][0] - _e317) * _e486) - (_e1173 * _e354));
                                                let _e1179 = (((_e1140[2][1] - _e384) * _e486) - (_e1173 * _e420));
                                                let _e1180 = (_e1176 * _e1170);
                                                let _e1181 = (_e1179 * _e1167);
                                                let _e1182 = (_e1158 * _e1179);
                                                let _e1183 = (_e1161 * _e1176);
                                                let _e1184 = (_e1167 * _e1161);
                                                let _e1185 = (_e1170 * _e1158);
                                                let _e1190 = (((_e1180 >= _e1181) && (_e1182 >= _e1183)) && (_e1184 >= _e1185));
                                                let _e1196 = (_e1190 || (((_e1180 <= _e1181) && (_e1182 <= _e1183)) && (_e1184 <= _e1185)));
                                                if _e1196 {
                                                    let _e1198 = select(-1f, 1f, _e1190);
                                                    let _e1200 = ((_e1180 - _e1181) * _e1198);
                                                    let _e1202 = select(0f, _e1200, (_e1200 > 0f));
                                                    let _e1204 = ((_e1182 - _e1183) * _e1198);
                                                    let _e1206 = select(0f, _e1204, (_e1204 > 0f));
                                                    let _e1208 = ((_e1184 - _e1185) * _e1198);
                                                    let _e1210 = select(0f, _e1208, (_e1208 > 0f));
                                                    let _e1212 = ((_e1202 + _e1206) + _e1210);
                                                    let _e1214 = select(_e1140[1][0], _e1140[0][0], (_e1140[0][0] < _e1140[1][0]));
                                                    let _e1218 = select(_e1140[1][0], _e1140[0][0], (_e1140[0][0] > _e1140[1][0]));
                                                    let _e1222 = select(_e1140[1][1], _e1140[0][1], (_e1140[0][1] < _e1140[1][1]));
                                                    let _e1226 = select(_e1140[1][1], _e1140[0][1], (_e1140[0][1] > _e1140[1][1]));
                                                    let _e1230 = select(_e1140[1][2], _e1140[0][2], (_e1140[0][2] < _e1140[1][2]));
                                                    let _e1234 = select(_e1140[1][2], _e1140[0][2], (_e1140[0][2] > _e1140[1][2]));
                                                    let _e1239 = ((select(_e1140[2][0], _e1214, (_e1214 < _e1140[2][0])) - _e355) * _e358);
                                                    let _e1240 = ((select(_e1140[2][0], _e1218, (_e1218 > _e1140[2][0])) - _e356) * _e358);
                                                    let _e1243 = ((select(_e1140[2][1], _e1222, (_e1222 < _e1140[2][1])) - _e421) * _e424);
                                                    let _e1244 = ((select(_e1140[2][1], _e1226, (_e1226 > _e1140[2][1])) - _e422) * _e424);
                                                    let _e1247 = ((select(_e1140[2][2], _e1230, (_e1230 < _e1140[2][2])) - _e487) * _e490);
                                                    let _e1248 = ((select(_e1140[2][2], _e1234, (_e1234 > _e1140[2][2])) - _e488) * _e490);
                                                    let _e1250 = select(_e1248, _e1247, (_e1247 < _e1248));
                                                    let _e1252 = select(_e1248, _e1247, (_e1247 > _e1248));
                                                    let _e1254 = select(_e1240, _e1239, (_e1239 < _e1240));
                                                    let _e1256 = select(_e1244, _e1243, (_e1243 < _e1244));
                                                    let _e1258 = select(_e1256, _e1254, (_e1254 > _e1256));
                                                    let _e1260 = select(_e1250, _e1258, (_e1258 > _e1250));
                                                    let _e1262 = select(_e1240, _e1239, (_e1239 > _e1240));
                                                    let _e1264 = select(_e1244, _e1243, (_e1243 > _e1244));
                                                    let _e1266 = select(_e1264, _e1262, (_e1262 < _e1264));
                                                    let _e1268 = select(_e1252, _e1266, (_e1266 < _e1252));
                                                    let _e1269 = -(_e1250);
                                                    let _e1275 = select(_e593, _e1260, (_e1260 > _e593));
                                                    let _e1279 = select(_e1167, _e1158, (_e1158 < _e1167));
                                                    let _e1284 = select(_e1167, _e1158, (_e1158 > _e1167));
                                                    let _e1291 = select(_e1170, _e1161, (_e1161 < _e1170));
                                                    let _e1296 = select(_e1170, _e1161, (_e1161 > _e1170));
                                                    let _e1305 = (((((_e1196 && (_e1212 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1176, _e1279, (_e1279 < _e1176)) <= 0f) && (select(_e1176, _e1284, (_e1284 > _e1176)) >= 0f))) && ((select(_e1179, _e1291, (_e1291 < _e1179)) <= 0f) && (select(_e1179, _e1296, (_e1296 > _e1179)) >= 0f))) && (_e1275 <= (_e1268 + (select(_e1269, _e1252, (_e1252 > _e1269)) * 0.0000019073523f)))) && (_e1275 <= _e1044));
                                                    if _e1305 {
                                                        let _e1310 = (_e1140[1][0] - _e1140[0][0]);
                                                        let _e1311 = (_e1140[1][1] - _e1140[0][1]);
                                                        let _e1312 = (_e1140[1][2] - _e1140[0][2]);
                                                        let _e1313 = vec3<f32>(_e1310, _e1311, _e1312);
                                                        let _e1314 = (_e1140[2][0] - _e1140[1][0]);
                                                        let _e1315 = (_e1140[2][1] - _e1140[1][1]);
                                                        let _e1316 = (_e1140[2][2] - _e1140[1][2]);
                                                        let _e1317 = vec3<f32>(_e1314, _e1315, _e1316);
                                                        let _e1318 = (_e1140[0][0] - _e1140[2][0]);
                                                        let _e1319 = (_e1140[0][1] - _e1140[2][1]);
                                                        let _e1320 = (_e1140[0][2] - _e1140[2][2]);
                                                        let _e1321 = vec3<f32>(_e1318, _e1319, _e1320);
                                                        let _e1324 = bitcast<f32>((bitcast<u32>(_e1310) & 2147483647u));
                                                        let _e1327 = bitcast<f32>((bitcast<u32>(_e1311) & 2147483647u));
                                                        let _e1329 = select(_e1327, _e1324, (_e1324 > _e1327));
                                                        let _e1332 = bitcast<f32>((bitcast<u32>(_e1312) & 2147483647u));
                                                        let _e1334 = select(_e1332, _e1329, (_e1329 > _e1332));
                                                        let _e1337 = bitcast<f32>((bitcast<u32>(_e1314) & 2147483647u));
                                                        let _e1340 = bitcast<f32>((bitcast<u32>(_e1315) & 2147483647u));
                                                        let _e1342 = select(_e1340, _e1337, (_e1337 > _e1340));
                                                        let _e1345 = bitcast<f32>((bitcast<u32>(_e1316) & 2147483647u));
                                                        let _e1347 = select(_e1345, _e1342, (_e1342 > _e1345));
                                                        let _e1350 = bitcast<f32>((bitcast<u32>(_e1318) & 2147483647u));
                                                        let _e1353 = bitcast<f32>((bitcast<u32>(_e1319) & 2147483647u));
                                                        let _e1355 = select(_e1353, _e1350, (_e1350 > _e1353));
                                                        let _e1358 = bitcast<f32>((bitcast<u32>(_e1320) & 2147483647u));
                                                        let _e1360 = select(_e1358, _e1355, (_e1355 > _e1358));
                                                        let _e1362 = select(_e1347, _e1334, (_e1334 > _e1347));
                                                        let _e1364 = select(_e1360, _e1362, (_e1362 > _e1360));
                                                        if (_e1334 == _e1364) {
                                                            phi_1980_ = _e1170;
                                                            phi_1981_ = _e1167;
                                                            phi_1982_ = _e1161;
                                                            phi_1983_ = _e1158;
                                                            phi_1984_ = vec3<f32>(_e1140[0][0], _e1140[0][1], _e1140[0][2]);
                                                            phi_1985_ = _e1321;
                                                            phi_1986_ = _e1317;
                                                            phi_1987_ = _e1313;
                                                        } else {
                                                            let _e1366 = (_e1347 == _e1364);
                                                            let _e1371 = vec3(_e1366);
                                                            phi_1980_ = select(_e1161, _e1179, _e1366);
                                                            phi_1981_ = select(_e1158, _e1176, _e1366);
                                                            phi_1982_ = select(_e1179, _e1170, _e1366);
                                                            phi_1983_ = select(_e1176, _e1167, _e1366);
                                                            phi_1984_ = select(vec3<f32>(_e1140[2][0], _e1140[2][1], _e1140[2][2]), vec3<f32>(_e1140[1][0], _e1140[1][1], _e1140[1][2]), _e1371);
                                                            phi_1985_ = select(_e1317, _e1313, _e1371);
                                                            phi_1986_ = select(_e1313, _e1321, _e1371);
                                                            phi_1987_ = select(_e1321, _e1317, _e1371);
                                                        }
                                                        let _e1377 = phi_1980_;
                                                        let _e1379 = phi_1981_;
                                                        let _e1381 = phi_1982_;
                                                        let _e1383 = phi_1983_;
                                                        let _e1385 = phi_1984_;
                                                        let _e1387 = phi_1985_;
                                                        let _e1389 = phi_1986_;
                                                        let _e1391 = phi_1987_;
                                                        let _e1398 = ((_e1389.y * _e1387.z) - (_e1387.y * _e1389.z));
                                                        let _e1403 = ((_e1389.z * _e1387.x) - (_e1387.z * _e1389.x));
                                                        let _e1406 = ((_e1389.x * _e1387.y) - (_e1387.x * _e1389.y));
                                                        let _e1409 = ((_e1202 >= _e1206) && (_e1202 >= _e1210));
                                                        let _e1410 = (_e1206 >= _e1210);
                                                        let _e1424 = (((_e1398 * (select(select(_e1140[2][0], _e1140[1][0], _e1410), _e1140[0][0], _e1409) - _e317)) + (_e1403 * (select(select(_e1140[2][1], _e1140[1][1], _e1410), _e1140[0][1], _e1409) - _e384))) + (_e1406 * (select(select(_e1140[2][2], _e1140[1][2], _e1410), _e1140[0][2], _e1409) - _e450)));
                                                        let _e1429 = (((_e1398 * _e354) + (_e1403 * _e420)) + (_e1406 * _e486));
                                                        let _e1430 = (_e1379 - _e1383);
                                                        let _e1431 = (_e1377 - _e1381);
                                                        let _e1434 = ((_e1430 * _e1430) + (_e1431 * _e1431));
                                                        let _e1441 = (-(((_e1383 * _e1430) + (_e1381 * _e1431))) / select(0.000000000000000000000000000000000000011754944f, _e1434, (_e1434 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1443 = select(1f, _e1441, (_e1441 < 1f));
                                                        let _e1445 = select(0f, _e1443, (_e1443 > 0f));
                                                        let _e1454 = ((_e1385.x + (_e1391.x * _e1445)) - _e317);
                                                        let _e1457 = ((_e1385.y + (_e1391.y * _e1445)) - _e384);
                                                        let _e1460 = ((_e1385.z + (_e1391.z * _e1445)) - _e450);
                                                        let _e1463 = bitcast<f32>((bitcast<u32>(_e1454) & 2147483647u));
                                                        let _e1466 = bitcast<f32>((bitcast<u32>(_e1457) & 2147483647u));
                                                        let _e1468 = select(_e1466, _e1463, (_e1463 > _e1466));
                                                        let _e1471 = bitcast<f32>((bitcast<u32>(_e1460) & 2147483647u));
                                                        let _e1473 = select(_e1471, _e1468, (_e1468 > _e1471));
                                                        let _e1479 = bitcast<f32>((bitcast<u32>(_e1398) & 2147483647u));
                                                        let _e1482 = bitcast<f32>((bitcast<u32>(_e1403) & 2147483647u));
                                                        let _e1484 = select(_e1482, _e1479, (_e1479 > _e1482));
                                                        let _e1487 = bitcast<f32>((bitcast<u32>(_e1406) & 2147483647u));
                                                        let _e1506 = bitcast<f32>((bitcast<u32>(_e1389.x) & 2147483647u));
                                                        let _e1509 = bitcast<f32>((bitcast<u32>(_e1389.y) & 2147483647u));
                                                        let _e1511 = select(_e1509, _e1506, (_e1506 > _e1509));
                                                        let _e1514 = bitcast<f32>((bitcast<u32>(_e1389.z) & 2147483647u));
                                                        let _e1520 = bitcast<f32>((bitcast<u32>(_e1387.x) & 2147483647u));
                                                        let _e1523 = bitcast<f32>((bitcast<u32>(_e1387.y) & 2147483647u));
                                                        let _e1525 = select(_e1523, _e1520, (_e1520 > _e1523));
                                                        let _e1528 = bitcast<f32>((bitcast<u32>(_e1387.z) & 2147483647u));
                                                        let _e1534 = ((bitcast<f32>((bitcast<u32>(((((_e1398 * _e1454) + (_e1403 * _e1457)) + (_e1406 * _e1460)) - _e1424)) & 2147483647u)) <= ((0.0000009536743f * select(_e1364, _e1473, (_e1473 > _e1364))) * select(_e1487, _e1484, (_e1484 > _e1487)))) && !((bitcast<f32>((bitcast<u32>(_e1429) & 2147483647u)) <= ((0.0000038146973f * select(_e1514, _e1511, (_e1511 > _e1514))) * select(_e1528, _e1525, (_e1525 > _e1528))))));
                                                        let _e1535 = (_e1424 / _e1429);
                                                        if (_e1305 && !(_e1534)) {
                                                            let _e1538 = (_e1460 / _e486);
                                                            let _e1546 = (((_e1398 * (_e1454 - (_e354 * _e1538))) + (_e1403 * (_e1457 - (_e420 * _e1538)))) / _e1429);
                                                            phi_2178_ = select(select(_e1538, (_e1538 + _e1546), (bitcast<f32>((bitcast<u32>(_e1546) & 2147483647u)) <= _e1364)), _e1535, _e1534);
                                                        } else {
                                                            phi_2178_ = _e1535;
                                                        }
                                                        let _e1555 = phi_2178_;
                                                        let _e1557 = select(_e1268, _e1555, (_e1555 < _e1268));
                                                        let _e1559 = select(_e1260, _e1557, (_e1557 > _e1260));
                                                        let _e1560 = (1f / _e1212);
                                                        phi_2198_ = type_31(_e1559, (_e1206 * _e1560), (_e1210 * _e1560), ((_e1305 && (_e1559 >= _e593)) && (_e1559 <= _e1044)));
                                                        phi_2199_ = type_31();
                                                    } else {
                                                        phi_2198_ = type_31();
                                                        phi_2199_ = type_31(0f, 0f, 0f, _e1305);
                                                    }
                                                    let _e1569 = phi_2198_;
                                                    let _e1571 = phi_2199_;
                                                    phi_2202_ = _e1569;
                                                    phi_2203_ = _e1571;
                                                    phi_2204_ = select(true, false, _e1305);
                                                } else {
                                                    phi_2202_ = type_31();
                                                    phi_2203_ = type_31(0f, 0f, 0f, _e1196);
                                                    phi_2204_ = true;
                                                }
                                                let _e1574 = phi_2202_;
                                                let _e1576 = phi_2203_;
                                                let _e1578 = phi_2204_;
                                                if _e1578 {
                                                    phi_2208_ = _e1576;
                                                } else {
                                                    phi_2208_ = _e1574;
                                                }
                                                let _e1580 = phi_2208_;
                                                if _e1580.member_3 {
                                                    phi_2217_ = type_22(_e1580.member, _e1580.member_1, _e1580.member_2, _e1073);
                                                } else {
                                                    phi_2217_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1587 = phi_2217_;
                                                if (_e1587.member_3 != 4294967295u) {
                                                    if (_e1073 != 4294967295u) {
                                                        phi_2229_ = type_4(0u, 8u);
                                                        phi_2232_ = _e1587;
                                                        loop {
                                                            let _e1592 = phi_2229_;
                                                            let _e1594 = phi_2232_;
                                                            if (_e1592.member < _e1592.member_1) {
                                                                phi_2230_ = type_4((_e1592.member + 1u), _e1592.member_1);
                                                                phi_2255_ = type_4(1u, _e1592.member);
                                                            } else {
                                                                phi_2230_ = _e1592;
                                                                phi_2255_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1607 = phi_2230_;
                                                            let _e1609 = phi_2255_;
                                                            let _e1613 = (bitcast<i32>(_e1609.member) != 0i);
                                                            if _e1613 {
                                                                let _e1614 = (_e1609.member_1 < 8u);
                                                                if _e1614 {
                                                                } else {
                                                                    phi_3831_ = true;
                                                                    break;
                                                                }
                                                                let _e1619 = local_7[_e1609.member_1].member;
                                                                if (_e1594.member < _e1619) {
                                                                    phi_2288_ = true;
                                                                } else {
                                                                    let _e1621 = local_7[_e1609.member_1].member;
                                                                    if (_e1594.member == _e1621) {
                                                                        let _e1626 = local_7[_e1609.member_1].member_3;
                                                                        phi_2287_ = (_e1594.member_3 < _e1626);
                                                                    } else {
                                                                        phi_2287_ = false;
                                                                    }
                                                                    let _e1629 = phi_2287_;
                                                                    phi_2288_ = _e1629;
                                                                }
                                                                let _e1631 = phi_2288_;
                                                                if _e1631 {
                                                                    if _e1614 {
                                                                    } else {
                                                                        phi_3831_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1632 = local_7[_e1609.member_1];
                                                                    local_7[_e1609.member_1] = type_22(_e1594.member, _e1594.member_1, _e1594.member_2, _e1594.member_3);
                                                                    phi_2309_ = type_22(_e1632.member, _e1632.member_1, _e1632.member_2, _e1632.member_3);
                                                                } else {
                                                                    phi_2309_ = _e1594;
                                                                }
                                                                let _e1643 = phi_2309_;
                                                                phi_2233_ = _e1643;
                                                            } else {
                                                                phi_2233_ = type_22();
                                                            }
                                                            let _e1645 = phi_2233_;
                                                            continue;
                                                            continuing {
                                                                phi_2229_ = _e1607;
                                                                phi_2232_ = _e1645;
                                                                phi_3831_ = _e1042;
                                                                break if !(_e1613);
                                                            }
                                                        }
                                                        let _e1648 = phi_3831_;
                                                        phi_3989_ = _e1044;
                                                        phi_3984_ = _e1648;
                                                        if _e1648 {
                                                            break;
                                                        }
                                                        let _e1651 = local_7[7u].member_3;
                                                        if (_e1651 != 4294967295u) {
                                                            let _e1655 = local_7[7u].member;
                                                            phi_4073_ = _e1655;
                                                        } else {
                                                            phi_4073_ = _e1044;
                                                        }
                                                        let _e1657 = phi_4073_;
                                                        phi_4072_ = _e1657;
                                                        phi_3987_ = _e1648;
                                                    } else {
                                                        phi_4072_ = _e1044;
                                                        phi_3987_ = _e1042;
                                                    }
                                                    let _e1659 = phi_4072_;
                                                    let _e1661 = phi_3987_;
                                                    phi_4071_ = _e1659;
                                                    phi_3986_ = _e1661;
                                                } else {
                                                    phi_4071_ = _e1044;
                                                    phi_3986_ = _e1042;
                                                }
                                                let _e1663 = phi_4071_;
                                                let _e1665 = phi_3986_;
                                                phi_4070_ = _e1663;
                                                phi_3985_ = _e1665;
                                            } else {
                                                phi_4070_ = _e1044;
                                                phi_3985_ = _e1042;
                                            }
                                            let _e1667 = phi_4070_;
                                            let _e1669 = phi_3985_;
                                            continue;
                                            continuing {
                                                phi_3841_ = _e1669;
                                                phi_3830_ = _e1667;
                                                phi_1312_ = _e1059;
                                                phi_3989_ = _e1667;
                                                phi_3984_ = _e1669;
                                                break if !(_e1065);
                                            }
                                        }
                                        let _e1672 = phi_3989_;
                                        let _e1674 = phi_3984_;
                                        phi_4074_ = _e1674;
                                        if _e1674 {
                                            break;
                                        }
                                        phi_4160_ = _e1672;
                                        phi_4078_ = _e1674;
                                        phi_3326_ = false;
                                        phi_3327_ = _e666;
                                        phi_3328_ = select(_e668, 0u, (_e593 > _e1672));
                                    } else {
                                        let _e677 = (_e666.member_1 < _e91);
                                        if _e677 {
                                            if _e677 {
                                            } else {
                                                phi_4074_ = true;
                                                break;
                                            }
                                            let _e679 = global_5.member[_e666.member_1];
                                            phi_2342_ = _e679;
                                        } else {
                                            phi_2342_ = type_45(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e681 = phi_2342_;
                                        let _e696 = ((10u * _e253) & 31u);
                                        let _e699 = ((_e681.member[0] >> bitcast<u32>(_e696)) & 1023u);
                                        let _e707 = bitcast<f32>((bitcast<u32>(((_e666.member.member_1[0] - _e666.member.member[0]) * 0.0009775171f)) ^ _e125));
                                        let _e712 = (_e666.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e699)) - 8388608f) * _e707)) ^ _e125)));
                                        let _e716 = select(select(_e666.member.member_1[0], _e712, (_e712 < _e666.member.member_1[0])), _e666.member.member_1[0], (_e699 == 1023u));
                                        let _e718 = ((10u * _e252) & 31u);
                                        let _e721 = ((_e681.member[0] >> bitcast<u32>(_e718)) & 1023u);
                                        let _e729 = bitcast<f32>((bitcast<u32>(((_e666.member.member_1[1] - _e666.member.member[1]) * 0.0009775171f)) ^ _e125));
                                        let _e734 = (_e666.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e721)) - 8388608f) * _e729)) ^ _e125)));
                                        let _e738 = select(select(_e666.member.member_1[1], _e734, (_e734 < _e666.member.member_1[1])), _e666.member.member_1[1], (_e721 == 1023u));
                                        let _e740 = ((10u * _e254) & 31u);
                                        let _e743 = ((_e681.member[0] >> bitcast<u32>(_e740)) & 1023u);
                                        let _e751 = bitcast<f32>((bitcast<u32>(((_e666.member.member_1[2] - _e666.member.member[2]) * 0.0009775171f)) ^ _e125));
                                        let _e756 = (_e666.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e743)) - 8388608f) * _e751)) ^ _e125)));
                                        let _e760 = select(select(_e666.member.member_1[2], _e756, (_e756 < _e666.member.member_1[2])), _e666.member.member_1[2], (_e743 == 1023u));
                                        let _e763 = ((_e681.member[1] >> bitcast<u32>(_e696)) & 1023u);
                                        let _e771 = (_e666.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e763)) - 8388608f) * _e707)) ^ _e125)));
                                        let _e775 = select(select(_e666.member.member_1[0], _e771, (_e771 < _e666.member.member_1[0])), _e666.member.member_1[0], (_e763 == 1023u));
                                        let _e778 = ((_e681.member[1] >> bitcast<u32>(_e718)) & 1023u);
                                        let _e786 = (_e666.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e778)) - 8388608f) * _e729)) ^ _e125)));
                                        let _e790 = select(select(_e666.member.member_1[1], _e786, (_e786 < _e666.member.member_1[1])), _e666.member.member_1[1], (_e778 == 1023u));
                                        let _e793 = ((_e681.member[1] >> bitcast<u32>(_e740)) & 1023u);
                                        let _e801 = (_e666.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e793)) - 8388608f) * _e751)) ^ _e125)));
                                        let _e805 = select(select(_e666.member.member_1[2], _e801, (_e801 < _e666.member.member_1[2])), _e666.member.member_1[2], (_e793 == 1023u));
                                        let _e811 = ((_e681.member_1[0] >> bitcast<u32>(_e696)) & 1023u);
                                        let _e819 = (_e666.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e811)) - 8388608f) * _e707)) ^ _e125)));
                                        let _e823 = select(select(_e666.member.member_1[0], _e819, (_e819 < _e666.member.member_1[0])), _e666.member.member_1[0], (_e811 == 1023u));
                                        let _e826 = ((_e681.member_1[0] >> bitcast<u32>(_e718)) & 1023u);
                                        let _e834 = (_e666.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e826)) - 8388608f) * _e729)) ^ _e125)));
                                        let _e838 = select(select(_e666.member.member_1[1], _e834, (_e834 < _e666.member.member_1[1])), _e666.member.member_1[1], (_e826 == 1023u));
                                        let _e841 = ((_e681.member_1[0] >> bitcast<u32>(_e740)) & 1023u);
                                        let _e849 = (_e666.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e841)) - 8388608f) * _e751)) ^ _e125)));
                                        let _e853 = select(select(_e666.member.member_1[2], _e849, (_e849 < _e666.member.member_1[2])), _e666.member.member_1[2], (_e841 == 1023u));
                                        let _e856 = ((_e681.member_1[1] >> bitcast<u32>(_e696)) & 1023u);
                                        let _e864 = (_e666.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e856)) - 8388608f) * _e707)) ^ _e125)));
                                        let _e868 = select(select(_e666.member.member_1[0], _e864, (_e864 < _e666.member.member_1[0])), _e666.member.member_1[0], (_e856 == 1023u));
                                        let _e871 = ((_e681.member_1[1] >> bitcast<u32>(_e718)) & 1023u);
                                        let _e879 = (_e666.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e871)) - 8388608f) * _e729)) ^ _e125)));
                                        let _e883 = select(select(_e666.member.member_1[1], _e879, (_e879 < _e666.member.member_1[1])), _e666.member.member_1[1], (_e871 == 1023u));
                                        let _e886 = ((_e681.member_1[1] >> bitcast<u32>(_e740)) & 1023u);
                                        let _e894 = (_e666.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e886)) - 8388608f) * _e751)) ^ _e125)));
                                        let _e898 = select(select(_e666.member.member_1[2], _e894, (_e894 < _e666.member.member_1[2])), _e666.member.member_1[2], (_e886 == 1023u));
                                        let _e903 = type_52(type_50(array<f32, 3>(_e716, _e738, _e760), array<f32, 3>(_e775, _e790, _e805)), _e681.member_2);
                                        let _e908 = type_52(type_50(array<f32, 3>(_e823, _e838, _e853), array<f32, 3>(_e868, _e883, _e898)), _e681.member_3);
                                        let _e913 = ((_e716 - _e355) * _e358);
                                        let _e914 = ((_e823 - _e355) * _e358);
                                        let _e915 = ((_e775 - _e356) * _e358);
                                        let _e916 = ((_e868 - _e356) * _e358);
                                        let _e921 = ((_e738 - _e421) * _e424);
                                        let _e922 = ((_e838 - _e421) * _e424);
                                        let _e923 = ((_e790 - _e422) * _e424);
                                        let _e924 = ((_e883 - _e422) * _e424);
                                        let _e929 = ((_e760 - _e487) * _e490);
                                        let _e930 = ((_e853 - _e487) * _e490);
                                        let _e931 = ((_e805 - _e488) * _e490);
                                        let _e932 = ((_e898 - _e488) * _e490);
                                        let _e934 = select(_e931, _e929, (_e929 < _e931));
                                        let _e936 = select(_e932, _e930, (_e930 < _e932));
                                        let _e938 = select(_e931, _e929, (_e929 > _e931));
                                        let _e940 = select(_e932, _e930, (_e930 > _e932));
                                        let _e942 = select(_e915, _e913, (_e913 < _e915));
                                        let _e944 = select(_e916, _e914, (_e914 < _e916));
                                        let _e946 = select(_e923, _e921, (_e921 < _e923));
                                        let _e948 = select(_e924, _e922, (_e922 < _e924));
                                        let _e950 = select(_e946, _e942, (_e942 > _e946));
                                        let _e952 = select(_e948, _e944, (_e944 > _e948));
                                        let _e954 = select(_e934, _e950, (_e950 > _e934));
                                        let _e956 = select(_e936, _e952, (_e952 > _e936));
                                        let _e958 = select(_e915, _e913, (_e913 > _e915));
                                        let _e960 = select(_e916, _e914, (_e914 > _e916));
                                        let _e962 = select(_e923, _e921, (_e921 > _e923));
                                        let _e964 = select(_e924, _e922, (_e922 > _e924));
                                        let _e966 = select(_e962, _e958, (_e958 < _e962));
                                        let _e968 = select(_e964, _e960, (_e960 < _e964));
                                        let _e973 = -(_e934);
                                        let _e974 = -(_e936);
                                        let _e981 = (select(_e938, _e966, (_e966 < _e938)) + (select(_e973, _e938, (_e938 > _e973)) * 0.0000019073523f));
                                        let _e982 = (select(_e940, _e968, (_e968 < _e940)) + (select(_e974, _e940, (_e940 > _e974)) * 0.0000019073523f));
                                        let _e984 = select(_e593, _e954, (_e954 > _e593));
                                        let _e986 = select(_e593, _e956, (_e956 > _e593));
                                        let _e991 = (_e984 <= select(_e626, _e981, (_e981 < _e626)));
                                        let _e992 = (_e986 <= select(_e626, _e982, (_e982 < _e626)));
                                        let _e993 = (_e984 <= _e986);
                                        if _e991 {
                                            if _e992 {
                                                if _e993 {
                                                    phi_3229_ = _e908;
                                                } else {
                                                    phi_3229_ = _e903;
                                                }
                                                let _e995 = phi_3229_;
                                                let _e1002 = (_e668 % 128u);
                                                let _e1003 = (_e1002 < 128u);
                                                if _e1003 {
                                                } else {
                                                    phi_4074_ = true;
                                                    break;
                                                }
                                                local_6[_e1002] = _e995.member_1;
                                                if _e1003 {
                                                } else {
                                                    phi_4074_ = true;
                                                    break;
                                                }
                                                local_5[_e1002] = _e995.member.member[0];
                                                if _e1003 {
                                                } else {
                                                    phi_4074_ = true;
                                                    break;
                                                }
                                                local_4[_e1002] = _e995.member.member[1];
                                                if _e1003 {
                                                } else {
                                                    phi_4074_ = true;
                                                    break;
                                                }
                                                local_3[_e1002] = _e995.member.member[2];
                                                if _e1003 {
                                                } else {
                                                    phi_4074_ = true;
                                                    break;
                                                }
                                                local_2[_e1002] = _e995.member.member_1[0];
                                                if _e1003 {
                                                } else {
                                                    phi_4074_ = true;
                                                    break;
                                                }
                                                local_1[_e1002] = _e995.member.member_1[1];
                                                if _e1003 {
                                                } else {
                                                    phi_4074_ = true;
                                                    break;
                                                }
                                                local[_e1002] = _e995.member.member_1[2];
                                                if _e1003 {
                                                } else {
                                                    phi_4074_ = true;
                                                    break;
                                                }
                                                local_8[_e1002] = select(_e984, _e986, _e993);
                                                if _e993 {
                                                    phi_3305_ = _e903;
                                                } else {
                                                    phi_3305_ = _e908;
                                                }
                                                let _e1020 = phi_3305_;
                                                phi_3306_ = _e1020;
                                                phi_3307_ = (_e668 + 1u);
                                            } else {
                                                phi_3306_ = type_52();
                                                phi_3307_ = u32();
                                            }
                                            let _e1022 = phi_3306_;
                                            let _e1024 = phi_3307_;
                                            phi_3309_ = _e1022;
                                            phi_3310_ = _e1024;
                                            phi_3311_ = select(true, false, _e992);
                                        } else {
                                            phi_3309_ = type_52();
                                            phi_3310_ = u32();
                                            phi_3311_ = true;
                                        }
                                        let _e1027 = phi_3309_;
                                        let _e1029 = phi_3310_;
                                        let _e1031 = phi_3311_;
                                        if _e1031 {
                                            if _e991 {
                                                phi_3318_ = _e903;
                                            } else {
                                                phi_3318_ = _e908;
                                            }
                                            let _e1033 = phi_3318_;
                                            phi_3323_ = select(_e992, true, _e991);
                                            phi_3324_ = _e1033;
                                        } else {
                                            phi_3323_ = _e664;
                                            phi_3324_ = _e1027;
                                        }
                                        let _e1036 = phi_3323_;
                                        let _e1038 = phi_3324_;
                                        phi_4160_ = _e626;
                                        phi_4078_ = _e624;
                                        phi_3326_ = _e1036;
                                        phi_3327_ = _e1038;
                                        phi_3328_ = select(_e1029, _e668, _e1031);
                                    }
                                    let _e1678 = phi_4160_;
                                    let _e1680 = phi_4078_;
                                    let _e1682 = phi_3326_;
                                    let _e1684 = phi_3327_;
                                    let _e1686 = phi_3328_;
                                    phi_4159_ = _e1678;
                                    phi_4077_ = _e1680;
                                    phi_3329_ = _e1682;
                                    phi_3330_ = _e1684;
                                    phi_3331_ = _e1686;
                                    phi_3332_ = (_e634 - 1u);
                                } else {
                                    phi_4159_ = _e626;
                                    phi_4077_ = _e624;
                                    phi_3329_ = _e664;
                                    phi_3330_ = _e666;
                                    phi_3331_ = _e668;
                                    phi_3332_ = _e634;
                                }
                                let _e1688 = phi_4159_;
                                let _e1690 = phi_4077_;
                                let _e1692 = phi_3329_;
                                let _e1694 = phi_3330_;
                                let _e1696 = phi_3331_;
                                let _e1698 = phi_3332_;
                                phi_4158_ = _e1688;
                                phi_4076_ = _e1690;
                                phi_3333_ = _e1692;
                                phi_3334_ = _e1694;
                                phi_3335_ = _e1696;
                                phi_3336_ = _e1698;
                            } else {
                                phi_4158_ = _e626;
                                phi_4076_ = _e624;
                                phi_3333_ = bool();
                                phi_3334_ = type_52();
                                phi_3335_ = u32();
                                phi_3336_ = u32();
                            }
                            let _e1700 = phi_4158_;
                            let _e1702 = phi_4076_;
                            let _e1704 = phi_3333_;
                            let _e1706 = phi_3334_;
                            let _e1708 = phi_3335_;
                            let _e1710 = phi_3336_;
                            phi_4157_ = _e1700;
                            phi_4075_ = _e1702;
                            phi_1188_ = _e1704;
                            phi_1191_ = _e1706;
                            phi_1193_ = _e1708;
                            phi_1195_ = _e1710;
                            phi_3337_ = _e638;
                        } else {
                            phi_4157_ = _e626;
                            phi_4075_ = _e624;
                            phi_1188_ = bool();
                            phi_1191_ = type_52();
                            phi_1193_ = u32();
                            phi_1195_ = u32();
                            phi_3337_ = false;
                        }
                        let _e1712 = phi_4157_;
                        let _e1714 = phi_4075_;
                        let _e1716 = phi_1188_;
                        let _e1718 = phi_1191_;
                        let _e1720 = phi_1193_;
                        let _e1722 = phi_1195_;
                        let _e1724 = phi_3337_;
                        continue;
                        continuing {
                            phi_3844_ = _e1714;
                            phi_3799_ = _e1712;
                            phi_1187_ = _e1716;
                            phi_1190_ = _e1718;
                            phi_1192_ = _e1720;
                            phi_1194_ = _e1722;
                            phi_4074_ = _e1714;
                            break if !(_e1724);
                        }
                    }
                    let _e1727 = phi_4074_;
                    if _e1727 {
                        break;
                    }
                    phi_3344_ = type_4(0u, 8u);
                    loop {
                        let _e1729 = phi_3344_;
                        if (_e1729.member < _e1729.member_1) {
                            phi_3345_ = type_4((_e1729.member + 1u), _e1729.member_1);
                            phi_3368_ = type_4(1u, _e1729.member);
                        } else {
                            phi_3345_ = _e1729;
                            phi_3368_ = type_4(0u, type_4().member_1);
                        }
                        let _e1742 = phi_3345_;
                        let _e1744 = phi_3368_;
                        let _e1748 = (bitcast<i32>(_e1744.member) != 0i);
                        if _e1748 {
                            let _e1749 = (_e1744.member_1 < 8u);
                            if _e1749 {
                            } else {
                                phi_4139_ = true;
                                break;
                            }
                            let _e1751 = local_7[_e1744.member_1];
                            if (_e1751.member_3 != 4294967295u) {
                                let _e1757 = -(_e495);
                                let _e1758 = bitcast<u32>(_e1751.member);
                                let _e1762 = (bitcast<i32>((_e1758 >> bitcast<u32>(23i))) & 255i);
                                let _e1763 = (_e1762 + _e1757);
                                if (_e1762 == 255i) {
                                    phi_3441_ = _e1751.member;
                                } else {
                                    if (_e1762 > 0i) {
                                        if (_e1763 > 0i) {
                                            let _e1767 = (_e1763 < 255i);
                                            if _e1767 {
                                                phi_3420_ = bitcast<f32>((_e1758 + bitcast<u32>((_e1757 << bitcast<u32>(23i)))));
                                            } else {
                                                phi_3420_ = f32();
                                            }
                                            let _e1774 = phi_3420_;
                                            phi_3422_ = _e1774;
                                            phi_3423_ = select(true, false, _e1767);
                                        } else {
                                            phi_3422_ = f32();
                                            phi_3423_ = true;
                                        }
                                        let _e1777 = phi_3422_;
                                        let _e1779 = phi_3423_;
                                        phi_3424_ = _e1777;
                                        phi_3425_ = _e1779;
                                    } else {
                                        phi_3424_ = f32();
                                        phi_3425_ = true;
                                    }
                                    let _e1781 = phi_3424_;
                                    let _e1783 = phi_3425_;
                                    if _e1783 {
                                        let _e1784 = (_e1758 & 2147483648u);
                                        let _e1791 = ((_e1758 & 8388607u) | (select(0u, 1u, ((_e1758 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                        let _e1795 = (_e1791 == 0u);
                                        if _e1795 {
                                            phi_3758_ = bitcast<f32>(_e1784);
                                        } else {
                                            let _e1800 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1791)), 32u, _e1795) - 8u);
                                            let _e1803 = (_e1791 << bitcast<u32>((_e1800 & 31u)));
                                            let _e1805 = ((_e1763 + select(0i, 1i, (_e1762 == 0i))) - bitcast<i32>(_e1800));
                                            if (_e1805 >= 255i) {
                                                phi_3748_ = bitcast<f32>((_e1784 | 2139095040u));
                                                phi_3749_ = f32();
                                                phi_3750_ = true;
                                            } else {
                                                let _e1807 = (_e1805 > 0i);
                                                if _e1807 {
                                                    phi_3742_ = bitcast<f32>(((_e1784 | (bitcast<u32>(_e1805) << bitcast<u32>(23i))) | (_e1803 & 8388607u)));
                                                    phi_3743_ = f32();
                                                } else {
                                                    if (_e1805 < -24i) {
                                                        phi_3708_ = 26u;
                                                    } else {
                                                        phi_3708_ = bitcast<u32>((1i - _e1805));
                                                    }
                                                    let _e1812 = phi_3708_;
                                                    let _e1813 = (_e1812 & 31u);
                                                    let _e1815 = (_e1803 >> bitcast<u32>(_e1813));
                                                    let _e1819 = (_e1803 & ((1u << bitcast<u32>(_e1813)) - 1u));
                                                    let _e1823 = (1u << bitcast<u32>(((_e1812 - 1u) & 31u)));
                                                    if (_e1819 > _e1823) {
                                                        phi_3729_ = true;
                                                    } else {
                                                        if (_e1819 == _e1823) {
                                                            phi_3726_ = ((_e1815 & 1u) == 1u);
                                                        } else {
                                                            phi_3726_ = false;
                                                        }
                                                        let _e1829 = phi_3726_;
                                                        phi_3729_ = _e1829;
                                                    }
                                                    let _e1831 = phi_3729_;
                                                    phi_3742_ = f32();
                                                    phi_3743_ = bitcast<f32>((_e1784 | (_e1815 + select(0u, 1u, _e1831))));
                                                }
                                                let _e1844 = phi_3742_;
                                                let _e1846 = phi_3743_;
                                                phi_3748_ = _e1844;
                                                phi_3749_ = _e1846;
                                                phi_3750_ = _e1807;
                                            }
                                            let _e1850 = phi_3748_;
                                            let _e1852 = phi_3749_;
                                            let _e1854 = phi_3750_;
                                            phi_3758_ = select(_e1852, _e1850, _e1854);
                                        }
                                        let _e1858 = phi_3758_;
                                        phi_3440_ = _e1858;
                                    } else {
                                        phi_3440_ = _e1781;
                                    }
                                    let _e1860 = phi_3440_;
                                    phi_3441_ = _e1860;
                                }
                                let _e1862 = phi_3441_;
                                let _e1863 = bitcast<u32>(_e1862);
                                if ((_e1863 & 2147483647u) >= 2139095040u) {
                                    phi_3453_ = bitcast<f32>(((_e1863 & 2147483648u) | 2139095039u));
                                } else {
                                    phi_3453_ = _e1862;
                                }
                                let _e1870 = phi_3453_;
                                phi_3458_ = type_22(_e1870, _e1751.member_1, _e1751.member_2, _e1751.member_3);
                            } else {
                                phi_3458_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1873 = phi_3458_;
                            if _e1749 {
                            } else {
                                phi_4139_ = true;
                                break;
                            }
                            local_7[_e1744.member_1] = type_22(_e1873.member, _e1873.member_1, _e1873.member_2, _e1873.member_3);
                        }
                        continue;
                        continuing {
                            phi_3344_ = _e1742;
                            phi_4139_ = _e1727;
                            break if !(_e1748);
                        }
                    }
                    let _e1881 = phi_4139_;
                    if _e1881 {
                        break;
                    }
                    let _e1882 = local_7;
                    if _e141 {
                    } else {
                        break;
                    }
                    global_6.member[_e139] = array<type_22, 8>(type_22(_e1882[0].member, _e1882[0].member_1, _e1882[0].member_2, _e1882[0].member_3), type_22(_e1882[1].member, _e1882[1].member_1, _e1882[1].member_2, _e1882[1].member_3), type_22(_e1882[2].member, _e1882[2].member_1, _e1882[2].member_2, _e1882[2].member_3), type_22(_e1882[3].member, _e1882[3].member_1, _e1882[3].member_2, _e1882[3].member_3), type_22(_e1882[4].member, _e1882[4].member_1, _e1882[4].member_2, _e1882[4].member_3), type_22(_e1882[5].member, _e1882[5].member_1, _e1882[5].member_2, _e1882[5].member_3), type_22(_e1882[6].member, _e1882[6].member_1, _e1882[6].member_2, _e1882[6].member_3), type_22(_e1882[7].member, _e1882[7].member_1, _e1882[7].member_2, _e1882[7].member_3));
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
