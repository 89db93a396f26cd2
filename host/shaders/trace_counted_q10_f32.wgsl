struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_9 {
    member: array<array<u32, 4>>,
}

struct type_12 {
    member: vec4<u32>,
}

struct type_17 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_19 {
    member: array<type_17>,
}

struct type_25 {
    member: array<array<u32, 2>>,
}

struct type_29 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_30 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_33 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_38 {
    member: type_29,
    member_1: f32,
}

struct type_41 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_43 {
    member: array<type_30>,
}

struct type_45 {
    member: type_38,
    member_1: u32,
    member_2: u32,
}

struct type_47 {
    member: array<vec4<u32>, 2>,
}

struct type_52 {
    member: type_33,
    member_1: u32,
}

struct type_53 {
    member: array<vec4<f32>, 3>,
    member_1: type_52,
    member_2: type_52,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(3) 
var<storage> global_2: type_19;
@group(0) @binding(1) 
var<uniform> global_3: type_47;
@group(0) @binding(2) 
var<storage> global_4: type_9;
@group(0) @binding(4) 
var<storage> global_5: type_43;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_25;

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
    var phi_410_: i32;
    var phi_411_: i32;
    var phi_421_: bool;
    var phi_431_: u32;
    var phi_432_: u32;
    var phi_434_: bool;
    var phi_439_: u32;
    var phi_452_: i32;
    var phi_472_: i32;
    var phi_490_: f32;
    var phi_496_: f32;
    var phi_536_: f32;
    var phi_542_: f32;
    var phi_615_: f32;
    var phi_621_: f32;
    var phi_661_: f32;
    var phi_667_: f32;
    var phi_740_: f32;
    var phi_746_: f32;
    var phi_786_: f32;
    var phi_792_: f32;
    var phi_911_: i32;
    var phi_933_: u32;
    var phi_934_: u32;
    var phi_971_: i32;
    var phi_993_: u32;
    var phi_994_: u32;
    var phi_1002_: f32;
    var phi_1003_: f32;
    var phi_3859_: bool;
    var phi_1100_: type_45;
    var phi_1103_: u32;
    var phi_1105_: bool;
    var phi_1107_: u32;
    var phi_1109_: type_52;
    var phi_1120_: bool;
    var phi_1206_: bool;
    var phi_1207_: u32;
    var phi_1208_: type_52;
    var phi_1226_: type_45;
    var phi_1229_: type_4;
    var phi_1230_: type_4;
    var phi_1252_: type_4;
    var phi_1276_: u32;
    var phi_1368_: array<array<f32, 3>, 3>;
    var phi_3494_: bool;
    var phi_3509_: bool;
    var phi_3524_: bool;
    var phi_3539_: bool;
    var phi_3554_: bool;
    var phi_3569_: bool;
    var phi_1910_: f32;
    var phi_1911_: f32;
    var phi_1912_: f32;
    var phi_1913_: f32;
    var phi_1914_: vec3<f32>;
    var phi_1915_: vec3<f32>;
    var phi_1916_: vec3<f32>;
    var phi_1917_: vec3<f32>;
    var phi_3584_: bool;
    var phi_3599_: bool;
    var phi_3614_: bool;
    var phi_3629_: bool;
    var phi_3644_: bool;
    var phi_3659_: bool;
    var phi_2125_: f32;
    var phi_2145_: type_41;
    var phi_2146_: type_41;
    var phi_2149_: type_41;
    var phi_2150_: type_41;
    var phi_2151_: bool;
    var phi_2155_: type_41;
    var phi_2164_: type_29;
    var phi_2189_: bool;
    var phi_2190_: bool;
    var phi_2197_: type_45;
    var phi_2198_: type_45;
    var phi_2199_: type_45;
    var phi_1227_: type_45;
    var phi_3853_: bool;
    var phi_4104_: bool;
    var phi_2200_: type_45;
    var phi_2927_: u32;
    var phi_2928_: u32;
    var phi_2938_: u32;
    var phi_2940_: u32;
    var phi_2941_: bool;
    var phi_2961_: u32;
    var phi_2962_: u32;
    var phi_2966_: type_53;
    var phi_3331_: type_52;
    var phi_3407_: type_52;
    var phi_3408_: u32;
    var phi_3409_: type_52;
    var phi_3411_: u32;
    var phi_3412_: type_52;
    var phi_3413_: bool;
    var phi_3422_: type_52;
    var phi_3427_: bool;
    var phi_3429_: type_52;
    var phi_3434_: type_45;
    var phi_3435_: bool;
    var phi_3436_: u32;
    var phi_3437_: type_52;
    var phi_3445_: type_45;
    var phi_3448_: type_52;
    var phi_4021_: bool;
    var phi_3449_: type_45;
    var phi_3450_: u32;
    var phi_3451_: bool;
    var phi_3452_: u32;
    var phi_3453_: type_52;
    var phi_4020_: bool;
    var phi_3454_: type_45;
    var phi_3455_: u32;
    var phi_3456_: bool;
    var phi_3457_: u32;
    var phi_3458_: type_52;
    var phi_4019_: bool;
    var phi_1101_: type_45;
    var phi_1104_: u32;
    var phi_1106_: bool;
    var phi_1108_: u32;
    var phi_1110_: type_52;
    var phi_3459_: bool;
    var phi_4018_: bool;
    var local_10: type_45;
    var local_11: type_45;
    var local_12: type_45;

    switch bitcast<i32>(0u) {
        default: {
            let _e87 = global;
            let _e89 = arrayLength((&global_4.member));
            let _e91 = arrayLength((&global_2.member));
            let _e99 = global_3.member[0u][0u];
            let _e103 = global_3.member[0u][1u];
            let _e107 = global_3.member[0u][2u];
            let _e111 = global_3.member[0u][3u];
            let _e115 = global_3.member[1u][0u];
            let _e119 = global_3.member[1u][1u];
            let _e123 = global_3.member[1u][2u];
            let _e126 = global_1.member[0u];
            let _e127 = bitcast<i32>(_e126);
            let _e139 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e111) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e99), bitcast<i32>(_e103), bitcast<i32>(_e107));
            local = array<i32, 3>(bitcast<i32>(_e115), bitcast<i32>(_e119), bitcast<i32>(_e123));
            let _e145 = (_e87.x + (_e87.y * 2097152u));
            let _e146 = (_e145 < arrayLength((&global_5.member)));
            if _e146 {
                let _e147 = (_e145 < arrayLength((&global_6.member)));
                if _e147 {
                    if _e146 {
                    } else {
                        break;
                    }
                    let _e155 = global_5.member[_e145].member_2[0u];
                    let _e157 = (bitcast<u32>(_e155) & 2147483647u);
                    let _e162 = global_5.member[_e145].member_2[1u];
                    let _e164 = (bitcast<u32>(_e162) & 2147483647u);
                    let _e169 = global_5.member[_e145].member_2[2u];
                    let _e171 = (bitcast<u32>(_e169) & 2147483647u);
                    let _e176 = global_5.member[_e145].member[0u];
                    let _e178 = (bitcast<u32>(_e176) & 2147483647u);
                    let _e183 = global_5.member[_e145].member[1u];
                    let _e185 = (bitcast<u32>(_e183) & 2147483647u);
                    let _e190 = global_5.member[_e145].member[2u];
                    let _e192 = (bitcast<u32>(_e190) & 2147483647u);
                    let _e194 = select(_e164, _e157, (_e164 < _e157));
                    let _e196 = select(_e171, _e194, (_e171 < _e194));
                    let _e198 = select(_e178, _e196, (_e178 < _e196));
                    let _e200 = select(_e185, _e198, (_e185 < _e198));
                    let _e202 = select(_e192, _e200, (_e192 < _e200));
                    let _e206 = global_5.member[_e145].member_1;
                    let _e207 = bitcast<u32>(_e206);
                    let _e208 = (_e207 & 2147483647u);
                    let _e215 = global_5.member[_e145].member_3;
                    let _e216 = bitcast<u32>(_e215);
                    let _e217 = (_e216 & 2147483647u);
                    let _e221 = (((select(_e208, _e202, (_e208 < _e202)) < 2139095040u) && (_e217 <= 2139095040u)) && (_e196 > 0u));
                    if _e221 {
                        let _e224 = (bitcast<u32>(bitcast<f32>(_e196)) & 2147483647u);
                        if (_e224 >= 8388608u) {
                            phi_410_ = (bitcast<i32>((_e224 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_410_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e224)), 32u, (_e224 == 0u))));
                        }
                        let _e238 = phi_410_;
                        phi_411_ = _e238;
                    } else {
                        phi_411_ = 0i;
                    }
                    let _e240 = phi_411_;
                    let _e241 = (_e157 == _e196);
                    if _e241 {
                        phi_421_ = true;
                    } else {
                        phi_421_ = (_e164 == _e196);
                    }
                    let _e244 = phi_421_;
                    let _e245 = select(1u, 0u, _e241);
                    if _e244 {
                        let _e246 = (_e245 + 1u);
                        phi_431_ = _e246;
                        phi_432_ = _e246;
                        phi_434_ = select(true, false, (_e246 == 2u));
                    } else {
                        phi_431_ = u32();
                        phi_432_ = 0u;
                        phi_434_ = true;
                    }
                    let _e250 = phi_431_;
                    let _e252 = phi_432_;
                    let _e254 = phi_434_;
                    if _e254 {
                        phi_439_ = (_e252 + 1u);
                    } else {
                        phi_439_ = 0u;
                    }
                    let _e258 = phi_439_;
                    let _e259 = select(_e250, _e252, _e254);
                    let _e260 = select(_e245, select(2u, _e245, _e244), _e254);
                    if (_e127 < -126i) {
                        phi_452_ = -126i;
                    } else {
                        phi_452_ = select(_e127, 127i, (_e127 > 127i));
                    }
                    let _e265 = phi_452_;
                    let _e270 = bitcast<f32>((bitcast<u32>((_e265 + 127i)) << bitcast<u32>(23i)));
                    let _e276 = bitcast<f32>((bitcast<u32>(((_e127 - _e265) + 127i)) << bitcast<u32>(23i)));
                    let _e277 = -(_e240);
                    if (_e277 < -126i) {
                        phi_472_ = -126i;
                    } else {
                        phi_472_ = select(_e277, 127i, (_e277 > 127i));
                    }
                    let _e282 = phi_472_;
                    let _e287 = bitcast<f32>((bitcast<u32>((_e282 + 127i)) << bitcast<u32>(23i)));
                    let _e293 = bitcast<f32>((bitcast<u32>(((_e277 - _e282) + 127i)) << bitcast<u32>(23i)));
                    let _e297 = global_5.member[_e145].member;
                    let _e298 = (_e259 == 0u);
                    if _e298 {
                        phi_490_ = _e297[0];
                    } else {
                        phi_490_ = _e297[1];
                    }
                    let _e302 = phi_490_;
                    let _e303 = (_e259 == 2u);
                    if _e303 {
                        phi_496_ = _e297[2];
                    } else {
                        phi_496_ = _e302;
                    }
                    let _e306 = phi_496_;
                    let _e307 = bitcast<u32>(_e306);
                    let _e309 = ((_e307 & 2139095040u) != 0u);
                    let _e323 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e307 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e307 & 2147483648u))), _e306, _e309) * _e270) * select(0.00000011920929f, 1f, _e309)) * _e276);
                    let _e324 = global_5.member[_e145].member_2;
                    if _e298 {
                        phi_536_ = _e324[0];
                    } else {
                        phi_536_ = _e324[1];
                    }
                    let _e328 = phi_536_;
                    if _e303 {
                        phi_542_ = _e324[2];
                    } else {
                        phi_542_ = _e328;
                    }
                    let _e331 = phi_542_;
                    let _e332 = bitcast<u32>(_e331);
                    let _e334 = ((_e332 & 2139095040u) != 0u);
                    let _e348 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e332 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e332 & 2147483648u))), _e331, _e334) * _e287) * select(0.00000011920929f, 1f, _e334)) * _e293);
                    let _e352 = (bitcast<f32>((bitcast<u32>(_e348) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e355 = bitcast<f32>((bitcast<u32>(_e323) & 2147483647u));
                    let _e356 = (_e355 * 0.00000011920929f);
                    let _e359 = select(select(0.00000000000011368684f, _e356, (_e356 > 0.00000000000011368684f)), 0f, _e352);
                    let _e360 = select(0f, _e348, _e352);
                    let _e361 = (_e323 + _e359);
                    let _e362 = (_e323 - _e359);
                    let _e364 = select(38685626000000000000000000f, (1f / _e348), _e352);
                    let _e365 = (_e258 == 0u);
                    if _e365 {
                        phi_615_ = _e297[0];
                    } else {
                        phi_615_ = _e297[1];
                    }
                    let _e369 = phi_615_;
                    let _e370 = (_e258 == 2u);
                    if _e370 {
                        phi_621_ = _e297[2];
                    } else {
                        phi_621_ = _e369;
                    }
                    let _e373 = phi_621_;
                    let _e374 = bitcast<u32>(_e373);
                    let _e376 = ((_e374 & 2139095040u) != 0u);
                    let _e390 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e374 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e374 & 2147483648u))), _e373, _e376) * _e270) * select(0.00000011920929f, 1f, _e376)) * _e276);
                    if _e365 {
                        phi_661_ = _e324[0];
                    } else {
                        phi_661_ = _e324[1];
                    }
                    let _e394 = phi_661_;
                    if _e370 {
                        phi_667_ = _e324[2];
                    } else {
                        phi_667_ = _e394;
                    }
                    let _e397 = phi_667_;
                    let _e398 = bitcast<u32>(_e397);
                    let _e400 = ((_e398 & 2139095040u) != 0u);
                    let _e414 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e398 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e398 & 2147483648u))), _e397, _e400) * _e287) * select(0.00000011920929f, 1f, _e400)) * _e293);
                    let _e418 = (bitcast<f32>((bitcast<u32>(_e414) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e421 = bitcast<f32>((bitcast<u32>(_e390) & 2147483647u));
                    let _e422 = (_e421 * 0.00000011920929f);
                    let _e425 = select(select(0.00000000000011368684f, _e422, (_e422 > 0.00000000000011368684f)), 0f, _e418);
                    let _e426 = select(0f, _e414, _e418);
                    let _e427 = (_e390 + _e425);
                    let _e428 = (_e390 - _e425);
                    let _e430 = select(38685626000000000000000000f, (1f / _e414), _e418);
                    let _e431 = (_e260 == 0u);
                    if _e431 {
                        phi_740_ = _e297[0];
                    } else {
                        phi_740_ = _e297[1];
                    }
                    let _e435 = phi_740_;
                    let _e436 = (_e260 == 2u);
                    if _e436 {
                        phi_746_ = _e297[2];
                    } else {
                        phi_746_ = _e435;
                    }
                    let _e439 = phi_746_;
                    let _e440 = bitcast<u32>(_e439);
                    let _e442 = ((_e440 & 2139095040u) != 0u);
                    let _e456 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e440 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e440 & 2147483648u))), _e439, _e442) * _e270) * select(0.00000011920929f, 1f, _e442)) * _e276);
                    if _e431 {
                        phi_786_ = _e324[0];
                    } else {
                        phi_786_ = _e324[1];
                    }
                    let _e460 = phi_786_;
                    if _e436 {
                        phi_792_ = _e324[2];
                    } else {
                        phi_792_ = _e460;
                    }
                    let _e463 = phi_792_;
                    let _e464 = bitcast<u32>(_e463);
                    let _e466 = ((_e464 & 2139095040u) != 0u);
                    let _e480 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e464 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e464 & 2147483648u))), _e463, _e466) * _e287) * select(0.00000011920929f, 1f, _e466)) * _e293);
                    let _e484 = (bitcast<f32>((bitcast<u32>(_e480) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e487 = bitcast<f32>((bitcast<u32>(_e456) & 2147483647u));
                    let _e488 = (_e487 * 0.00000011920929f);
                    let _e491 = select(select(0.00000000000011368684f, _e488, (_e488 > 0.00000000000011368684f)), 0f, _e484);
                    let _e492 = select(0f, _e480, _e484);
                    let _e493 = (_e456 + _e491);
                    let _e494 = (_e456 - _e491);
                    let _e496 = select(38685626000000000000000000f, (1f / _e480), _e484);
                    let _e498 = select(_e421, _e355, (_e355 > _e421));
                    let _e501 = (_e127 + _e240);
                    if (_e221 && (select(_e487, _e498, (_e498 > _e487)) <= 1099511600000f)) {
                        let _e511 = ((_e208 & 8388607u) | (select(0u, 1u, ((_e208 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e514 = bitcast<i32>((_e208 >> bitcast<u32>(23i)));
                        let _e518 = (_e511 == 0u);
                        let _e521 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e511)), 32u, _e518)) - 8i);
                        if (_e514 == 255i) {
                            phi_911_ = 255i;
                        } else {
                            phi_911_ = (((_e514 + select(0i, 1i, (_e514 == 0i))) - _e521) + _e501);
                        }
                        let _e529 = phi_911_;
                        let _e539 = (_e529 <= 0i);
                        if _e539 {
                            phi_934_ = u32();
                        } else {
                            if _e518 {
                                phi_933_ = u32();
                            } else {
                                phi_933_ = select(((bitcast<u32>(_e529) << bitcast<u32>(23i)) | ((_e511 << bitcast<u32>(((_e521 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e529 >= 255i));
                            }
                            let _e543 = phi_933_;
                            phi_934_ = _e543;
                        }
                        let _e545 = phi_934_;
                        let _e557 = ((_e217 & 8388607u) | (select(0u, 1u, ((_e217 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e560 = bitcast<i32>((_e217 >> bitcast<u32>(23i)));
                        let _e564 = (_e557 == 0u);
                        let _e567 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e557)), 32u, _e564)) - 8i);
                        if (_e560 == 255i) {
                            phi_971_ = 255i;
                        } else {
                            phi_971_ = (((_e560 + select(0i, 1i, (_e560 == 0i))) - _e567) + _e501);
                        }
                        let _e575 = phi_971_;
                        let _e585 = (_e575 <= 0i);
                        if _e585 {
                            phi_994_ = u32();
                        } else {
                            if _e564 {
                                phi_993_ = u32();
                            } else {
                                phi_993_ = select(((bitcast<u32>(_e575) << bitcast<u32>(23i)) | ((_e557 << bitcast<u32>(((_e567 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e575 >= 255i));
                            }
                            let _e589 = phi_993_;
                            phi_994_ = _e589;
                        }
                        let _e591 = phi_994_;
                        phi_1002_ = bitcast<f32>(((_e216 & 2147483648u) | select(_e591, 0u, select(_e564, true, _e585))));
                        phi_1003_ = bitcast<f32>(((_e207 & 2147483648u) | select(_e545, 0u, select(_e518, true, _e539))));
                    } else {
                        phi_1002_ = 0f;
                        phi_1003_ = 1f;
                    }
                    let _e597 = phi_1002_;
                    let _e599 = phi_1003_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e604 = (_e259 % 3u);
                    let _e605 = (_e604 < 3u);
                    if _e605 {
                    } else {
                        break;
                    }
                    let _e607 = local_1[_e604];
                    let _e610 = (_e258 % 3u);
                    let _e611 = (_e610 < 3u);
                    if _e611 {
                    } else {
                        break;
                    }
                    let _e613 = local_1[_e610];
                    let _e616 = (_e260 % 3u);
                    let _e617 = (_e616 < 3u);
                    if _e617 {
                    } else {
                        break;
                    }
                    let _e619 = local_1[_e616];
                    if _e605 {
                    } else {
                        break;
                    }
                    let _e624 = local[_e604];
                    if _e611 {
                    } else {
                        break;
                    }
                    let _e628 = local[_e610];
                    if _e617 {
                    } else {
                        break;
                    }
                    let _e632 = local[_e616];
                    phi_3859_ = false;
                    phi_1100_ = type_45(type_38(type_29(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e597), 0u, 0u);
                    phi_1103_ = ((3u * _e89) + 1u);
                    phi_1105_ = (_e599 <= _e597);
                    phi_1107_ = 0u;
                    phi_1109_ = type_52(type_33(vec4<f32>((f32(_e607) * _e139), (f32(_e613) * _e139), (f32(_e619) * _e139), 0f), vec4<f32>((f32(_e624) * _e139), (f32(_e628) * _e139), (f32(_e632) * _e139), 0f)), select(0u, 2147483648u, (_e89 == 0u)));
                    loop {
                        let _e642 = phi_3859_;
                        let _e644 = phi_1100_;
                        let _e646 = phi_1103_;
                        let _e648 = phi_1105_;
                        let _e650 = phi_1107_;
                        let _e652 = phi_1109_;
                        local_10 = _e644;
                        local_11 = _e644;
                        if _e648 {
                            phi_1120_ = true;
                        } else {
                            phi_1120_ = (_e650 > 0u);
                        }
                        let _e655 = phi_1120_;
                        if _e655 {
                            let _e656 = (_e646 > 0u);
                            if _e656 {
                                if _e648 {
                                    phi_1206_ = _e648;
                                    phi_1207_ = _e650;
                                    phi_1208_ = _e652;
                                } else {
                                    let _e657 = (_e650 - 1u);
                                    let _e658 = (_e657 % 128u);
                                    let _e659 = (_e658 < 128u);
                                    if _e659 {
                                    } else {
                                        phi_4018_ = true;
                                        break;
                                    }
                                    let _e661 = local_7[_e658];
                                    if _e659 {
                                    } else {
                                        phi_4018_ = true;
                                        break;
                                    }
                                    let _e663 = local_6[_e658];
                                    if _e659 {
                                    } else {
                                        phi_4018_ = true;
                                        break;
                                    }
                                    let _e665 = local_5[_e658];
                                    if _e659 {
                                    } else {
                                        phi_4018_ = true;
                                        break;
                                    }
                                    let _e667 = local_4[_e658];
                                    if _e659 {
                                    } else {
                                        phi_4018_ = true;
                                        break;
                                    }
                                    let _e669 = local_3[_e658];
                                    if _e659 {
                                    } else {
                                        phi_4018_ = true;
                                        break;
                                    }
                                    let _e671 = local_2[_e658];
                                    if _e659 {
                                    } else {
                                        phi_4018_ = true;
                                        break;
                                    }
                                    let _e676 = local_8[_e658];
                                    if _e659 {
                                    } else {
                                        phi_4018_ = true;
                                        break;
                                    }
                                    let _e679 = local_9[_e658];
                                    phi_1206_ = (_e679 <= _e644.member.member_1);
                                    phi_1207_ = _e657;
                                    phi_1208_ = type_52(type_33(vec4<f32>(_e661, _e663, _e665, 0f), vec4<f32>(_e667, _e669, _e671, 0f)), _e676);
                                }
                                let _e684 = phi_1206_;
                                let _e686 = phi_1207_;
                                let _e688 = phi_1208_;
                                if _e684 {
                                    let _e692 = ((_e688.member_1 & 2147483648u) != 0u);
                                    if _e692 {
                                        phi_1226_ = _e644;
                                        phi_1229_ = type_4(0u, ((_e688.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e699 = phi_1226_;
                                            let _e701 = phi_1229_;
                                            local_12 = _e699;
                                            if (_e701.member < _e701.member_1) {
                                                phi_1230_ = type_4((_e701.member + 1u), _e701.member_1);
                                                phi_1252_ = type_4(1u, _e701.member);
                                            } else {
                                                phi_1230_ = _e701;
                                                phi_1252_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e714 = phi_1230_;
                                            let _e716 = phi_1252_;
                                            let _e720 = (bitcast<i32>(_e716.member) != 0i);
                                            if _e720 {
                                                let _e726 = type_45(_e699.member, _e699.member_1, (_e699.member_2 + 1u));
                                                let _e727 = ((_e688.member_1 & 268435455u) + _e716.member_1);
                                                let _e728 = (_e727 < _e91);
                                                if _e728 {
                                                    if _e728 {
                                                    } else {
                                                        phi_3853_ = true;
                                                        break;
                                                    }
                                                    let _e732 = global_2.member[_e727].member_1;
                                                    phi_1276_ = _e732;
                                                } else {
                                                    phi_1276_ = 4294967295u;
                                                }
                                                let _e734 = phi_1276_;
                                                if (_e727 >= _e91) {
                                                    phi_1368_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e728 {
                                                    } else {
                                                        phi_3853_ = true;
                                                        break;
                                                    }
                                                    if (_e604 < 9u) {
                                                    } else {
                                                        phi_3853_ = true;
                                                        break;
                                                    }
                                                    let _e741 = global_2.member[_e727].member[_e604];
                                                    if (_e610 < 9u) {
                                                    } else {
                                                        phi_3853_ = true;
                                                        break;
                                                    }
                                                    let _e747 = global_2.member[_e727].member[_e610];
                                                    if (_e616 < 9u) {
                                                    } else {
                                                        phi_3853_ = true;
                                                        break;
                                                    }
                                                    let _e753 = global_2.member[_e727].member[_e616];
                                                    let _e755 = (3u + _e604);
                                                    if (_e755 < 9u) {
                                                    } else {
                                                        phi_3853_ = true;
                                                        break;
                                                    }
                                                    let _e761 = global_2.member[_e727].member[_e755];
                                                    let _e762 = (3u + _e610);
                                                    if (_e762 < 9u) {
                                                    } else {
                                                        phi_3853_ = true;
                                                        break;
                                                    }
                                                    let _e768 = global_2.member[_e727].member[_e762];
                                                    let _e769 = (3u + _e616);
                                                    if (_e769 < 9u) {
                                                    } else {
                                                        phi_3853_ = true;
                                                        break;
                                                    }
                                                    let _e775 = global_2.member[_e727].member[_e769];
                                                    let _e777 = (6u + _e604);
                                                    if (_e777 < 9u) {
                                                    } else {
                                                        phi_3853_ = true;
                                                        break;
                                                    }
                                                    let _e783 = global_2.member[_e727].member[_e777];
                                                    let _e784 = (6u + _e610);
                                                    if (_e784 < 9u) {
                                                    } else {
                                                        phi_3853_ = true;
                                                        break;
                                                    }
                                                    let _e790 = global_2.member[_e727].member[_e784];
                                                    let _e791 = (6u + _e616);
                                                    if (_e791 < 9u) {
                                                    } else {
                                                        phi_3853_ = true;
                                                        break;
                                                    }
                                                    let _e797 = global_2.member[_e727].member[_e791];
                                                    phi_1368_ = array<array<f32, 3>, 3>(array<f32, 3>(_e741, _e747, _e753), array<f32, 3>(_e761, _e768, _e775), array<f32, 3>(_e783, _e790, _e797));
                                                }
                                                let _e801 = phi_1368_;
                                                let _e818 = (_e801[0][2] - _e456);
                                                let _e821 = (((_e801[0][0] - _e323) * _e492) - (_e818 * _e360));
                                                let _e824 = (((_e801[0][1] - _e390) * _e492) - (_e818 * _e426));
                                                let _e827 = (_e801[1][2] - _e456);
                                                let _e830 = (((_e801[1][0] - _e323) * _e492) - (_e827 * _e360));
                                                let _e833 = (((_e801[1][1] - _e390) * _e492) - (_e827 * _e426));
                                                let _e836 = (_e801[2][2] - _e456);
                                                let _e839 = (((_e801[2][0] - _e323) * _e492) - (_e836 * _e360));
                                                let _e842 = (((_e801[2][1] - _e390) * _e492) - (_e836 * _e426));
                                                let _e843 = (_e839 * _e833);
                                                let _e844 = (_e842 * _e830);
                                                let _e845 = (_e821 * _e842);
                                                let _e846 = (_e824 * _e839);
                                                let _e847 = (_e830 * _e824);
                                                let _e848 = (_e833 * _e821);
                                                let _e853 = (((_e843 >= _e844) && (_e845 >= _e846)) && (_e847 >= _e848));
                                                let _e859 = (_e853 || (((_e843 <= _e844) && (_e845 <= _e846)) && (_e847 <= _e848)));
                                                if _e859 {
                                                    let _e861 = select(-1f, 1f, _e853);
                                                    let _e863 = ((_e843 - _e844) * _e861);
                                                    let _e865 = select(0f, _e863, (_e863 > 0f));
                                                    let _e867 = ((_e845 - _e846) * _e861);
                                                    let _e869 = select(0f, _e867, (_e867 > 0f));
                                                    let _e871 = ((_e847 - _e848) * _e861);
                                                    let _e873 = select(0f, _e871, (_e871 > 0f));
                                                    let _e875 = ((_e865 + _e869) + _e873);
                                                    let _e877 = select(_e801[1][0], _e801[0][0], (_e801[0][0] < _e801[1][0]));
                                                    let _e881 = select(_e801[1][0], _e801[0][0], (_e801[0][0] > _e801[1][0]));
                                                    let _e885 = select(_e801[1][1], _e801[0][1], (_e801[0][1] < _e801[1][1]));
                                                    let _e889 = select(_e801[1][1], _e801[0][1], (_e801[0][1] > _e801[1][1]));
                                                    let _e893 = select(_e801[1][2], _e801[0][2], (_e801[0][2] < _e801[1][2]));
                                                    let _e897 = select(_e801[1][2], _e801[0][2], (_e801[0][2] > _e801[1][2]));
                                                    let _e902 = ((select(_e801[2][0], _e877, (_e877 < _e801[2][0])) - _e361) * _e364);
                                                    let _e903 = ((select(_e801[2][0], _e881, (_e881 > _e801[2][0])) - _e362) * _e364);
                                                    let _e906 = ((select(_e801[2][1], _e885, (_e885 < _e801[2][1])) - _e427) * _e430);
                                                    let _e907 = ((select(_e801[2][1], _e889, (_e889 > _e801[2][1])) - _e428) * _e430);
                                                    let _e910 = ((select(_e801[2][2], _e893, (_e893 < _e801[2][2])) - _e493) * _e496);
                                                    let _e911 = ((select(_e801[2][2], _e897, (_e897 > _e801[2][2])) - _e494) * _e496);
                                                    let _e913 = select(_e911, _e910, (_e910 < _e911));
                                                    let _e915 = select(_e911, _e910, (_e910 > _e911));
                                                    let _e917 = select(_e903, _e902, (_e902 < _e903));
                                                    let _e919 = select(_e907, _e906, (_e906 < _e907));
                                                    let _e921 = select(_e919, _e917, (_e917 > _e919));
                                                    let _e923 = select(_e913, _e921, (_e921 > _e913));
                                                    let _e925 = select(_e903, _e902, (_e902 > _e903));
                                                    let _e927 = select(_e907, _e906, (_e906 > _e907));
                                                    let _e929 = select(_e927, _e925, (_e925 < _e927));
                                                    let _e931 = select(_e915, _e929, (_e929 < _e915));
                                                    let _e932 = -(_e913);
                                                    let _e938 = select(_e599, _e923, (_e923 > _e599));
                                                    let _e942 = select(_e830, _e821, (_e821 < _e830));
                                                    let _e947 = select(_e830, _e821, (_e821 > _e830));
                                                    let _e954 = select(_e833, _e824, (_e824 < _e833));
                                                    let _e959 = select(_e833, _e824, (_e824 > _e833));
                                                    let _e968 = (((((_e859 && (_e875 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e839, _e942, (_e942 < _e839)) <= 0f) && (select(_e839, _e947, (_e947 > _e839)) >= 0f))) && ((select(_e842, _e954, (_e954 < _e842)) <= 0f) && (select(_e842, _e959, (_e959 > _e842)) >= 0f))) && (_e938 <= (_e931 + (select(_e932, _e915, (_e915 > _e932)) * 0.0000019073523f)))) && (_e938 <= _e699.member.member_1));
                                                    if _e968 {
                                                        let _e973 = (_e801[1][0] - _e801[0][0]);
                                                        let _e974 = (_e801[1][1] - _e801[0][1]);
                                                        let _e975 = (_e801[1][2] - _e801[0][2]);
                                                        let _e976 = vec3<f32>(_e973, _e974, _e975);
                                                        let _e977 = (_e801[2][0] - _e801[1][0]);
                                                        let _e978 = (_e801[2][1] - _e801[1][1]);
                                                        let _e979 = (_e801[2][2] - _e801[1][2]);
                                                        let _e980 = vec3<f32>(_e977, _e978, _e979);
                                                        let _e981 = (_e801[0][0] - _e801[2][0]);
                                                        let _e982 = (_e801[0][1] - _e801[2][1]);
                                                        let _e983 = (_e801[0][2] - _e801[2][2]);
                                                        let _e984 = vec3<f32>(_e981, _e982, _e983);
                                                        let _e985 = abs(_e973);
                                                        let _e986 = abs(_e974);
                                                        if (_e985 != _e985) {
                                                            phi_3494_ = true;
                                                        } else {
                                                            phi_3494_ = (_e986 >= _e985);
                                                        }
                                                        let _e990 = phi_3494_;
                                                        let _e991 = select(_e985, _e986, _e990);
                                                        let _e992 = abs(_e975);
                                                        if (_e991 != _e991) {
                                                            phi_3509_ = true;
                                                        } else {
                                                            phi_3509_ = (_e992 >= _e991);
                                                        }
                                                        let _e996 = phi_3509_;
                                                        let _e997 = select(_e991, _e992, _e996);
                                                        let _e998 = abs(_e977);
                                                        let _e999 = abs(_e978);
                                                        if (_e998 != _e998) {
                                                            phi_3524_ = true;
                                                        } else {
                                                            phi_3524_ = (_e999 >= _e998);
                                                        }
                                                        let _e1003 = phi_3524_;
                                                        let _e1004 = select(_e998, _e999, _e1003);
                                                        let _e1005 = abs(_e979);
                                                        if (_e1004 != _e1004) {
                                                            phi_3539_ = true;
                                                        } else {
                                                            phi_3539_ = (_e1005 >= _e1004);
                                                        }
                                                        let _e1009 = phi_3539_;
                                                        let _e1010 = select(_e1004, _e1005, _e1009);
                                                        let _e1011 = abs(_e981);
                                                        let _e1012 = abs(_e982);
                                                        if (_e1011 != _e1011) {
                                                            phi_3554_ = true;
                                                        } else {
                                                            phi_3554_ = (_e1012 >= _e1011);
                                                        }
                                                        let _e1016 = phi_3554_;
                                                        let _e1017 = select(_e1011, _e1012, _e1016);
                                                        let _e1018 = abs(_e983);
                                                        if (_e1017 != _e1017) {
                                                            phi_3569_ = true;
                                                        } else {
                                                            phi_3569_ = (_e1018 >= _e1017);
                                                        }
                                                        let _e1022 = phi_3569_;
                                                        let _e1023 = select(_e1017, _e1018, _e1022);
                                                        let _e1025 = select(_e1010, _e997, (_e997 > _e1010));
                                                        let _e1027 = select(_e1023, _e1025, (_e1025 > _e1023));
                                                        if (_e997 == _e1027) {
                                                            phi_1910_ = _e833;
                                                            phi_1911_ = _e830;
                                                            phi_1912_ = _e824;
                                                            phi_1913_ = _e821;
                                                            phi_1914_ = vec3<f32>(_e801[0][0], _e801[0][1], _e801[0][2]);
                                                            phi_1915_ = _e984;
                                                            phi_1916_ = _e980;
                                                            phi_1917_ = _e976;
                                                        } else {
                                                            let _e1029 = (_e1010 == _e1027);
                                                            let _e1034 = vec3(_e1029);
                                                            phi_1910_ = select(_e824, _e842, _e1029);
                                                            phi_1911_ = select(_e821, _e839, _e1029);
                                                            phi_1912_ = select(_e842, _e833, _e1029);
                                                            phi_1913_ = select(_e839, _e830, _e1029);
                                                            phi_1914_ = select(vec3<f32>(_e801[2][0], _e801[2][1], _e801[2][2]), vec3<f32>(_e801[1][0], _e801[1][1], _e801[1][2]), _e1034);
                                                            phi_1915_ = select(_e980, _e976, _e1034);
                                                            phi_1916_ = select(_e976, _e984, _e1034);
                                                            phi_1917_ = select(_e984, _e980, _e1034);
                                                        }
                                                        let _e1040 = phi_1910_;
                                                        let _e1042 = phi_1911_;
                                                        let _e1044 = phi_1912_;
                                                        let _e1046 = phi_1913_;
                                                        let _e1048 = phi_1914_;
                                                        let _e1050 = phi_1915_;
                                                        let _e1052 = phi_1916_;
                                                        let _e1054 = phi_1917_;
                                                        let _e1061 = ((_e1052.y * _e1050.z) - (_e1050.y * _e1052.z));
                                                        let _e1066 = ((_e1052.z * _e1050.x) - (_e1050.z * _e1052.x));
                                                        let _e1069 = ((_e1052.x * _e1050.y) - (_e1050.x * _e1052.y));
                                                        let _e1072 = ((_e865 >= _e869) && (_e865 >= _e873));
                                                        let _e1073 = (_e869 >= _e873);
                                                        let _e1087 = (((_e1061 * (select(select(_e801[2][0], _e801[1][0], _e1073), _e801[0][0], _e1072) - _e323)) + (_e1066 * (select(select(_e801[2][1], _e801[1][1], _e1073), _e801[0][1], _e1072) - _e390))) + (_e1069 * (select(select(_e801[2][2], _e801[1][2], _e1073), _e801[0][2], _e1072) - _e456)));
                                                        let _e1092 = (((_e1061 * _e360) + (_e1066 * _e426)) + (_e1069 * _e492));
                                                        let _e1093 = (_e1042 - _e1046);
                                                        let _e1094 = (_e1040 - _e1044);
                                                        let _e1097 = ((_e1093 * _e1093) + (_e1094 * _e1094));
                                                        let _e1104 = (-(((_e1046 * _e1093) + (_e1044 * _e1094))) / select(0.000000000000000000000000000000000000011754944f, _e1097, (_e1097 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1106 = select(1f, _e1104, (_e1104 < 1f));
                                                        let _e1108 = select(0f, _e1106, (_e1106 > 0f));
                                                        let _e1117 = ((_e1048.x + (_e1054.x * _e1108)) - _e323);
                                                        let _e1120 = ((_e1048.y + (_e1054.y * _e1108)) - _e390);
                                                        let _e1123 = ((_e1048.z + (_e1054.z * _e1108)) - _e456);
                                                        let _e1126 = bitcast<f32>((bitcast<u32>(_e1117) & 2147483647u));
                                                        let _e1129 = bitcast<f32>((bitcast<u32>(_e1120) & 2147483647u));
                                                        let _e1131 = select(_e1129, _e1126, (_e1126 > _e1129));
                                                        let _e1134 = bitcast<f32>((bitcast<u32>(_e1123) & 2147483647u));
                                                        let _e1136 = select(_e1134, _e1131, (_e1131 > _e1134));
                                                        let _e1140 = abs(_e1061);
                                                        let _e1141 = abs(_e1066);
                                                        if (_e1140 != _e1140) {
                                                            phi_3584_ = true;
                                                        } else {
                                                            phi_3584_ = (_e1141 >= _e1140);
                                                        }
                                                        let _e1145 = phi_3584_;
                                                        let _e1146 = select(_e1140, _e1141, _e1145);
                                                        let _e1147 = abs(_e1069);
                                                        if (_e1146 != _e1146) {
                                                            phi_3599_ = true;
                                                        } else {
                                                            phi_3599_ = (_e1147 >= _e1146);
                                                        }
                                                        let _e1151 = phi_3599_;
                                                        let _e1167 = abs(_e1052.x);
                                                        let _e1168 = abs(_e1052.y);
                                                        if (_e1167 != _e1167) {
                                                            phi_3614_ = true;
                                                        } else {
                                                            phi_3614_ = (_e1168 >= _e1167);
                                                        }
                                                        let _e1172 = phi_3614_;
                                                        let _e1173 = select(_e1167, _e1168, _e1172);
                                                        let _e1174 = abs(_e1052.z);
                                                        if (_e1173 != _e1173) {
                                                            phi_3629_ = true;
                                                        } else {
                                                            phi_3629_ = (_e1174 >= _e1173);
                                                        }
                                                        let _e1178 = phi_3629_;
                                                        let _e1181 = abs(_e1050.x);
                                                        let _e1182 = abs(_e1050.y);
                                                        if (_e1181 != _e1181) {
                                                            phi_3644_ = true;
                                                        } else {
                                                            phi_3644_ = (_e1182 >= _e1181);
                                                        }
                                                        let _e1186 = phi_3644_;
                                                        let _e1187 = select(_e1181, _e1182, _e1186);
                                                        let _e1188 = abs(_e1050.z);
                                                        if (_e1187 != _e1187) {
                                                            phi_3659_ = true;
                                                        } else {
                                                            phi_3659_ = (_e1188 >= _e1187);
                                                        }
                                                        let _e1192 = phi_3659_;
                                                        let _e1197 = ((bitcast<f32>((bitcast<u32>(((((_e1061 * _e1117) + (_e1066 * _e1120)) + (_e1069 * _e1123)) - _e1087)) & 2147483647u)) <= ((0.0000009536743f * select(_e1027, _e1136, (_e1136 > _e1027))) * select(_e1146, _e1147, _e1151))) && !((bitcast<f32>((bitcast<u32>(_e1092) & 2147483647u)) <= ((0.0000038146973f * select(_e1173, _e1174, _e1178)) * select(_e1187, _e1188, _e1192)))));
                                                        let _e1198 = (_e1087 / _e1092);
                                                        if (_e968 && !(_e1197)) {
                                                            let _e1201 = (_e1123 / _e492);
                                                            let _e1209 = (((_e1061 * (_e1117 - (_e360 * _e1201))) + (_e1066 * (_e1120 - (_e426 * _e1201)))) / _e1092);
                                                            phi_2125_ = select(select(_e1201, (_e1201 + _e1209), (bitcast<f32>((bitcast<u32>(_e1209) & 2147483647u)) <= _e1027)), _e1198, _e1197);
                                                        } else {
                                                            phi_2125_ = _e1198;
                                                        }
                                                        let _e1218 = phi_2125_;
                                                        let _e1220 = select(_e931, _e1218, (_e1218 < _e931));
                                                        let _e1222 = select(_e923, _e1220, (_e1220 > _e923));
                                                        let _e1223 = (1f / _e875);
                                                        phi_2145_ = type_41(_e1222, (_e869 * _e1223), (_e873 * _e1223), ((_e968 && (_e1222 >= _e599)) && (_e1222 <= _e699.member.member_1)));
                                                        phi_2146_ = type_41();
                                                    } else {
                                                        phi_2145_ = type_41();
                                                        phi_2146_ = type_41(0f, 0f, 0f, _e968);
                                                    }
                                                    let _e1232 = phi_2145_;
                                                    let _e1234 = phi_2146_;
                                                    phi_2149_ = _e1232;
                                                    phi_2150_ = _e1234;
                                                    phi_2151_ = select(true, false, _e968);
                                                } else {
                                                    phi_2149_ = type_41();
                                                    phi_2150_ = type_41(0f, 0f, 0f, _e859);
                                                    phi_2151_ = true;
                                                }
                                                let _e1237 = phi_2149_;
                                                let _e1239 = phi_2150_;
                                                let _e1241 = phi_2151_;
                                                if _e1241 {
                                                    phi_2155_ = _e1239;
                                                } else {
                                                    phi_2155_ = _e1237;
                                                }
                                                let _e1243 = phi_2155_;
                                                if _e1243.member_3 {
                                                    phi_2164_ = type_29(_e1243.member, _e1243.member_1, _e1243.member_2, _e734);
                                                } else {
                                                    phi_2164_ = type_29(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1250 = phi_2164_;
                                                if (_e1250.member_3 != 4294967295u) {
                                                    if (_e734 != 4294967295u) {
                                                        if (_e1250.member < _e699.member.member.member) {
                                                            phi_2190_ = true;
                                                        } else {
                                                            if (_e1250.member == _e699.member.member.member) {
                                                                phi_2189_ = (_e1250.member_3 < _e699.member.member.member_3);
                                                            } else {
                                                                phi_2189_ = false;
                                                            }
                                                            let _e1265 = phi_2189_;
                                                            phi_2190_ = _e1265;
                                                        }
                                                        let _e1267 = phi_2190_;
                                                        if _e1267 {
                                                            phi_2197_ = type_45(type_38(_e1250, _e1250.member), _e726.member_1, _e726.member_2);
                                                        } else {
                                                            phi_2197_ = _e726;
                                                        }
                                                        let _e1274 = phi_2197_;
                                                        phi_2198_ = _e1274;
                                                    } else {
                                                        phi_2198_ = _e726;
                                                    }
                                                    let _e1276 = phi_2198_;
                                                    phi_2199_ = _e1276;
                                                } else {
                                                    phi_2199_ = _e726;
                                                }
                                                let _e1278 = phi_2199_;
                                                phi_1227_ = _e1278;
                                            } else {
                                                phi_1227_ = type_45();
                                            }
                                            let _e1280 = phi_1227_;
                                            continue;
                                            continuing {
                                                phi_1226_ = _e1280;
                                                phi_1229_ = _e714;
                                                phi_3853_ = _e642;
                                                break if !(_e720);
                                            }
                                        }
                                        let _e1283 = phi_3853_;
                                        phi_4018_ = _e1283;
                                        if _e1283 {
                                            break;
                                        }
                                        phi_4104_ = _e1283;
                                        let _e1883 = local_12;
                                        phi_2200_ = _e1883;
                                    } else {
                                        phi_4104_ = _e642;
                                        phi_2200_ = _e644;
                                    }
                                    let _e1285 = phi_4104_;
                                    let _e1287 = phi_2200_;
                                    if _e692 {
                                        phi_3434_ = type_45();
                                        phi_3435_ = bool();
                                        phi_3436_ = u32();
                                        phi_3437_ = type_52();
                                    } else {
                                        if (_e688.member_1 >= _e89) {
                                            phi_2966_ = type_53(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_52(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_52(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e688.member_1 < _e89) {
                                            } else {
                                                phi_4018_ = true;
                                                break;
                                            }
                                            let _e1291 = ((1u + _e259) % 4u);
                                            if (_e1291 < 4u) {
                                            } else {
                                                phi_4018_ = true;
                                                break;
                                            }
                                            let _e1296 = global_4.member[_e688.member_1][_e1291];
                                            let _e1298 = (_e1296 >> bitcast<u32>(11u));
                                            let _e1300 = ((1u + _e258) % 4u);
                                            if (_e1300 < 4u) {
                                            } else {
                                                phi_4018_ = true;
                                                break;
                                            }
                                            let _e1305 = global_4.member[_e688.member_1][_e1300];
                                            let _e1307 = (_e1305 >> bitcast<u32>(11u));
                                            let _e1309 = ((1u + _e260) % 4u);
                                            if (_e1309 < 4u) {
                                            } else {
                                                phi_4018_ = true;
                                                break;
                                            }
                                            let _e1314 = global_4.member[_e688.member_1][_e1309];
                                            let _e1316 = (_e1314 >> bitcast<u32>(11u));
                                            let _e1339 = (bitcast<f32>((bitcast<u32>((_e688.member.member_1.x - _e688.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e1340 = (bitcast<f32>((bitcast<u32>((_e688.member.member_1.y - _e688.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e1341 = (bitcast<f32>((bitcast<u32>((_e688.member.member_1.z - _e688.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e1343 = select(_e139, _e1339, (_e1339 > _e139));
                                            let _e1345 = select(_e139, _e1340, (_e1340 > _e139));
                                            let _e1347 = select(_e139, _e1341, (_e1341 > _e139));
                                            let _e1378 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1296 & 1023u))) - 8388608f) * _e1343));
                                            let _e1383 = (bitcast<i32>((_e1296 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1386 = bitcast<f32>((_e1378 & bitcast<u32>(_e1383)));
                                            let _e1387 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1305 & 1023u))) - 8388608f) * _e1345));
                                            let _e1392 = (bitcast<i32>((_e1305 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1395 = bitcast<f32>((_e1387 & bitcast<u32>(_e1392)));
                                            let _e1396 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1314 & 1023u))) - 8388608f) * _e1347));
                                            let _e1401 = (bitcast<i32>((_e1314 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1404 = bitcast<f32>((_e1396 & bitcast<u32>(_e1401)));
                                            let _e1408 = bitcast<f32>((_e1378 & bitcast<u32>(~(_e1383))));
                                            let _e1412 = bitcast<f32>((_e1387 & bitcast<u32>(~(_e1392))));
                                            let _e1416 = bitcast<f32>((_e1396 & bitcast<u32>(~(_e1401))));
                                            let _e1417 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1298 & 1023u))) - 8388608f) * _e1343));
                                            let _e1422 = (bitcast<i32>((_e1298 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1425 = bitcast<f32>((_e1417 & bitcast<u32>(_e1422)));
                                            let _e1426 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1307 & 1023u))) - 8388608f) * _e1345));
                                            let _e1431 = (bitcast<i32>((_e1307 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1434 = bitcast<f32>((_e1426 & bitcast<u32>(_e1431)));
                                            let _e1435 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1316 & 1023u))) - 8388608f) * _e1347));
                                            let _e1440 = (bitcast<i32>((_e1316 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1443 = bitcast<f32>((_e1435 & bitcast<u32>(_e1440)));
                                            let _e1447 = bitcast<f32>((_e1417 & bitcast<u32>(~(_e1422))));
                                            let _e1451 = bitcast<f32>((_e1426 & bitcast<u32>(~(_e1431))));
                                            let _e1455 = bitcast<f32>((_e1435 & bitcast<u32>(~(_e1440))));
                                            let _e1485 = global_4.member[_e688.member_1][0u];
                                            let _e1489 = global_4.member[_e688.member_1][1u];
                                            let _e1493 = global_4.member[_e688.member_1][2u];
                                            let _e1497 = global_4.member[_e688.member_1][3u];
                                            let _e1509 = (((_e1489 >> bitcast<u32>(22i)) | ((_e1493 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1497 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1510 = (_e1485 & 268435455u);
                                            let _e1511 = (_e1509 & 268435455u);
                                            let _e1514 = ((_e1485 >> bitcast<u32>(28u)) & 7u);
                                            let _e1522 = ((_e1485 >> bitcast<u32>(31i)) | (((_e1509 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1523 = (_e1514 != 0u);
                                            if (_e1514 == 0u) {
                                                phi_2928_ = _e1510;
                                            } else {
                                                if (_e1514 == 7u) {
                                                    phi_2927_ = 2147483648u;
                                                } else {
                                                    phi_2927_ = ((2147483648u | (_e1514 << bitcast<u32>(28u))) | (_e1511 & 268435455u));
                                                }
                                                let _e1532 = phi_2927_;
                                                phi_2928_ = _e1532;
                                            }
                                            let _e1534 = phi_2928_;
                                            if _e1523 {
                                                let _e1535 = (_e1514 != 7u);
                                                if _e1535 {
                                                    phi_2938_ = (_e1511 + _e1514);
                                                } else {
                                                    phi_2938_ = u32();
                                                }
                                                let _e1538 = phi_2938_;
                                                phi_2940_ = _e1538;
                                                phi_2941_ = select(true, false, _e1535);
                                            } else {
                                                phi_2940_ = u32();
                                                phi_2941_ = true;
                                            }
                                            let _e1541 = phi_2940_;
                                            let _e1543 = phi_2941_;
                                            if (_e1522 == 0u) {
                                                phi_2962_ = (_e1510 + select(0u, 1u, !(_e1523)));
                                            } else {
                                                if (_e1522 == 7u) {
                                                    phi_2961_ = 2147483648u;
                                                } else {
                                                    phi_2961_ = ((2147483648u | (_e1522 << bitcast<u32>(28u))) | (select(_e1541, _e1511, _e1543) & 268435455u));
                                                }
                                                let _e1556 = phi_2961_;
                                                phi_2962_ = _e1556;
                                            }
                                            let _e1558 = phi_2962_;
                                            phi_2966_ = type_53(array<vec4<f32>, 3>(vec4<f32>((_e688.member.member.x + _e1386), (_e688.member.member.x + _e1408), (_e688.member.member_1.x - _e1425), (_e688.member.member_1.x - _e1447)), vec4<f32>((_e688.member.member.y + _e1395), (_e688.member.member.y + _e1412), (_e688.member.member_1.y - _e1434), (_e688.member.member_1.y - _e1451)), vec4<f32>((_e688.member.member.z + _e1404), (_e688.member.member.z + _e1416), (_e688.member.member_1.z - _e1443), (_e688.member.member_1.z - _e1455))), type_52(type_33((_e688.member.member + vec4<f32>(_e1386, _e1395, _e1404, 0f)), (_e688.member.member_1 - vec4<f32>(_e1425, _e1434, _e1443, 0f))), _e1534), type_52(type_33((_e688.member.member + vec4<f32>(_e1408, _e1412, _e1416, 0f)), (_e688.member.member_1 - vec4<f32>(_e1447, _e1451, _e1455, 0f))), _e1558));
                                        }
                                        let _e1563 = phi_2966_;
                                        let _e1582 = ((_e1563.member[0].x - _e361) * _e364);
                                        let _e1583 = ((_e1563.member[0].y - _e361) * _e364);
                                        let _e1584 = ((_e1563.member[0].z - _e362) * _e364);
                                        let _e1585 = ((_e1563.member[0].w - _e362) * _e364);
                                        let _e1595 = ((_e1563.member[1].x - _e427) * _e430);
                                        let _e1596 = ((_e1563.member[1].y - _e427) * _e430);
                                        let _e1597 = ((_e1563.member[1].z - _e428) * _e430);
                                        let _e1598 = ((_e1563.member[1].w - _e428) * _e430);
                                        let _e1608 = ((_e1563.member[2].x - _e493) * _e496);
                                        let _e1609 = ((_e1563.member[2].y - _e493) * _e496);
                                        let _e1610 = ((_e1563.member[2].z - _e494) * _e496);
                                        let _e1611 = ((_e1563.member[2].w - _e494) * _e496);
                                        let _e1613 = select(_e1610, _e1608, (_e1608 < _e1610));
                                        let _e1615 = select(_e1611, _e1609, (_e1609 < _e1611));
                                        let _e1617 = select(_e1610, _e1608, (_e1608 > _e1610));
                                        let _e1619 = select(_e1611, _e1609, (_e1609 > _e1611));
                                        let _e1621 = select(_e1584, _e1582, (_e1582 < _e1584));
                                        let _e1623 = select(_e1585, _e1583, (_e1583 < _e1585));
                                        let _e1625 = select(_e1597, _e1595, (_e1595 < _e1597));
                                        let _e1627 = select(_e1598, _e1596, (_e1596 < _e1598));
                                        let _e1629 = select(_e1625, _e1621, (_e1621 > _e1625));
                                        let _e1631 = select(_e1627, _e1623, (_e1623 > _e1627));
                                        let _e1633 = select(_e1613, _e1629, (_e1629 > _e1613));
                                        let _e1635 = select(_e1615, _e1631, (_e1631 > _e1615));
                                        let _e1637 = select(_e1584, _e1582, (_e1582 > _e1584));
                                        let _e1639 = select(_e1585, _e1583, (_e1583 > _e1585));
                                        let _e1641 = select(_e1597, _e1595, (_e1595 > _e1597));
                                        let _e1643 = select(_e1598, _e1596, (_e1596 > _e1598));
                                        let _e1645 = select(_e1641, _e1637, (_e1637 < _e1641));
                                        let _e1647 = select(_e1643, _e1639, (_e1639 < _e1643));
                                        let _e1652 = -(_e1613);
                                        let _e1653 = -(_e1615);
                                        let _e1660 = (select(_e1617, _e1645, (_e1645 < _e1617)) + (select(_e1652, _e1617, (_e1617 > _e1652)) * 0.0000019073523f));
                                        let _e1661 = (select(_e1619, _e1647, (_e1647 < _e1619)) + (select(_e1653, _e1619, (_e1619 > _e1653)) * 0.0000019073523f));
                                        let _e1663 = select(_e599, _e1633, (_e1633 > _e599));
                                        let _e1665 = select(_e599, _e1635, (_e1635 > _e599));
                                        let _e1670 = (_e1663 <= select(_e1287.member.member_1, _e1660, (_e1660 < _e1287.member.member_1)));
                                        let _e1671 = (_e1665 <= select(_e1287.member.member_1, _e1661, (_e1661 < _e1287.member.member_1)));
                                        let _e1672 = (_e1663 <= _e1665);
                                        if _e1670 {
                                            if _e1671 {
                                                if _e1672 {
                                                    phi_3331_ = _e1563.member_2;
                                                } else {
                                                    phi_3331_ = _e1563.member_1;
                                                }
                                                let _e1676 = phi_3331_;
                                                let _e1697 = (_e686 % 128u);
                                                let _e1698 = (_e1697 < 128u);
                                                if _e1698 {
                                                } else {
                                                    phi_4018_ = true;
                                                    break;
                                                }
                                                local_8[_e1697] = _e1676.member_1;
                                                if _e1698 {
                                                } else {
                                                    phi_4018_ = true;
                                                    break;
                                                }
                                                local_7[_e1697] = _e1676.member.member.x;
                                                if _e1698 {
                                                } else {
                                                    phi_4018_ = true;
                                                    break;
                                                }
                                                local_6[_e1697] = _e1676.member.member.y;
                                                if _e1698 {
                                                } else {
                                                    phi_4018_ = true;
                                                    break;
                                                }
                                                local_5[_e1697] = _e1676.member.member.z;
                                                if _e1698 {
                                                } else {
                                                    phi_4018_ = true;
                                                    break;
                                                }
                                                local_4[_e1697] = _e1676.member.member_1.x;
                                                if _e1698 {
                                                } else {
                                                    phi_4018_ = true;
                                                    break;
                                                }
                                                local_3[_e1697] = _e1676.member.member_1.y;
                                                if _e1698 {
                                                } else {
                                                    phi_4018_ = true;
                                                    break;
                                                }
                                                local_2[_e1697] = _e1676.member.member_1.z;
                                                if _e1698 {
                                                } else {
                                                    phi_4018_ = true;
                                                    break;
                                                }
                                                local_9[_e1697] = select(_e1663, _e1665, _e1672);
                                                if _e1672 {
                                                    phi_3407_ = _e1563.member_1;
                                                } else {
                                                    phi_3407_ = _e1563.member_2;
                                                }
                                                let _e1711 = phi_3407_;
                                                phi_3408_ = (_e686 + 1u);
                                                phi_3409_ = _e1711;
                                            } else {
                                                phi_3408_ = u32();
                                                phi_3409_ = type_52();
                                            }
                                            let _e1713 = phi_3408_;
                                            let _e1715 = phi_3409_;
                                            phi_3411_ = _e1713;
                                            phi_3412_ = _e1715;
                                            phi_3413_ = select(true, false, _e1671);
                                        } else {
                                            phi_3411_ = u32();
                                            phi_3412_ = type_52();
                                            phi_3413_ = true;
                                        }
                                        let _e1718 = phi_3411_;
                                        let _e1720 = phi_3412_;
                                        let _e1722 = phi_3413_;
                                        if _e1722 {
                                            if _e1670 {
                                                phi_3422_ = _e1563.member_1;
                                            } else {
                                                phi_3422_ = _e1563.member_2;
                                            }
                                            let _e1726 = phi_3422_;
                                            phi_3427_ = select(_e1671, true, _e1670);
                                            phi_3429_ = _e1726;
                                        } else {
                                            phi_3427_ = _e684;
                                            phi_3429_ = _e1720;
                                        }
                                        let _e1729 = phi_3427_;
                                        let _e1731 = phi_3429_;
                                        phi_3434_ = type_45(_e1287.member, (_e1287.member_1 + 1u), _e1287.member_2);
                                        phi_3435_ = _e1729;
                                        phi_3436_ = select(_e1718, _e686, _e1722);
                                        phi_3437_ = _e1731;
                                    }
                                    let _e1734 = phi_3434_;
                                    let _e1736 = phi_3435_;
                                    let _e1738 = phi_3436_;
                                    let _e1740 = phi_3437_;
                                    if _e692 {
                                        phi_3445_ = _e1287;
                                        phi_3448_ = _e688;
                                    } else {
                                        phi_3445_ = _e1734;
                                        phi_3448_ = _e1740;
                                    }
                                    let _e1742 = phi_3445_;
                                    let _e1744 = phi_3448_;
                                    phi_4021_ = _e1285;
                                    phi_3449_ = _e1742;
                                    phi_3450_ = (_e646 - 1u);
                                    phi_3451_ = select(_e1736, false, _e692);
                                    phi_3452_ = select(_e1738, _e686, _e692);
                                    phi_3453_ = _e1744;
                                } else {
                                    phi_4021_ = _e642;
                                    phi_3449_ = _e644;
                                    phi_3450_ = _e646;
                                    phi_3451_ = _e684;
                                    phi_3452_ = _e686;
                                    phi_3453_ = _e688;
                                }
                                let _e1748 = phi_4021_;
                                let _e1750 = phi_3449_;
                                let _e1752 = phi_3450_;
                                let _e1754 = phi_3451_;
                                let _e1756 = phi_3452_;
                                let _e1758 = phi_3453_;
                                phi_4020_ = _e1748;
                                phi_3454_ = _e1750;
                                phi_3455_ = _e1752;
                                phi_3456_ = _e1754;
                                phi_3457_ = _e1756;
                                phi_3458_ = _e1758;
                            } else {
                                phi_4020_ = _e642;
                                phi_3454_ = type_45();
                                phi_3455_ = u32();
                                phi_3456_ = bool();
                                phi_3457_ = u32();
                                phi_3458_ = type_52();
                            }
                            let _e1760 = phi_4020_;
                            let _e1762 = phi_3454_;
                            let _e1764 = phi_3455_;
                            let _e1766 = phi_3456_;
                            let _e1768 = phi_3457_;
                            let _e1770 = phi_3458_;
                            phi_4019_ = _e1760;
                            phi_1101_ = _e1762;
                            phi_1104_ = _e1764;
                            phi_1106_ = _e1766;
                            phi_1108_ = _e1768;
                            phi_1110_ = _e1770;
                            phi_3459_ = _e656;
                        } else {
                            phi_4019_ = _e642;
                            phi_1101_ = type_45();
                            phi_1104_ = u32();
                            phi_1106_ = bool();
                            phi_1108_ = u32();
                            phi_1110_ = type_52();
                            phi_3459_ = false;
                        }
                        let _e1772 = phi_4019_;
                        let _e1774 = phi_1101_;
                        let _e1776 = phi_1104_;
                        let _e1778 = phi_1106_;
                        let _e1780 = phi_1108_;
                        let _e1782 = phi_1110_;
                        let _e1784 = phi_3459_;
                        continue;
                        continuing {
                            phi_3859_ = _e1772;
                            phi_1100_ = _e1774;
                            phi_1103_ = _e1776;
                            phi_1105_ = _e1778;
                            phi_1107_ = _e1780;
                            phi_1109_ = _e1782;
                            phi_4018_ = _e1772;
                            break if !(_e1784);
                        }
                    }
                    let _e1787 = phi_4018_;
                    if _e1787 {
                        break;
                    }
                    let _e1789 = local_10;
                    let _e1792 = local_11;
                    if _e147 {
                    } else {
                        break;
                    }
                    global_6.member[_e145][0u] = _e1789.member_1;
                    global_6.member[_e145][1u] = _e1792.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
