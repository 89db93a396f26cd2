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
    var phi_417_: i32;
    var phi_418_: i32;
    var phi_428_: bool;
    var phi_438_: u32;
    var phi_439_: u32;
    var phi_441_: bool;
    var phi_446_: u32;
    var phi_459_: i32;
    var phi_479_: i32;
    var phi_497_: f32;
    var phi_503_: f32;
    var phi_543_: f32;
    var phi_549_: f32;
    var phi_622_: f32;
    var phi_628_: f32;
    var phi_668_: f32;
    var phi_674_: f32;
    var phi_747_: f32;
    var phi_753_: f32;
    var phi_793_: f32;
    var phi_799_: f32;
    var phi_918_: i32;
    var phi_940_: u32;
    var phi_941_: u32;
    var phi_978_: i32;
    var phi_1000_: u32;
    var phi_1001_: u32;
    var phi_1009_: f32;
    var phi_1010_: f32;
    var phi_3785_: bool;
    var phi_1107_: type_45;
    var phi_1110_: bool;
    var phi_1112_: type_52;
    var phi_1114_: u32;
    var phi_1116_: u32;
    var phi_1127_: bool;
    var phi_1213_: bool;
    var phi_1214_: type_52;
    var phi_1215_: u32;
    var phi_2904_: u32;
    var phi_2905_: u32;
    var phi_2915_: u32;
    var phi_2917_: u32;
    var phi_2918_: bool;
    var phi_2938_: u32;
    var phi_2939_: u32;
    var phi_2943_: type_53;
    var phi_3308_: type_52;
    var phi_3384_: type_52;
    var phi_3385_: type_52;
    var phi_3386_: u32;
    var phi_3388_: type_52;
    var phi_3389_: u32;
    var phi_3390_: bool;
    var phi_3399_: type_52;
    var phi_3404_: bool;
    var phi_3405_: type_52;
    var phi_1233_: type_45;
    var phi_1236_: type_4;
    var phi_1237_: type_4;
    var phi_1259_: type_4;
    var phi_1283_: u32;
    var phi_1375_: array<array<f32, 3>, 3>;
    var phi_1905_: f32;
    var phi_1906_: f32;
    var phi_1907_: f32;
    var phi_1908_: f32;
    var phi_1909_: vec3<f32>;
    var phi_1910_: vec3<f32>;
    var phi_1911_: vec3<f32>;
    var phi_1912_: vec3<f32>;
    var phi_2103_: f32;
    var phi_2123_: type_41;
    var phi_2124_: type_41;
    var phi_2127_: type_41;
    var phi_2128_: type_41;
    var phi_2129_: bool;
    var phi_2133_: type_41;
    var phi_2142_: type_29;
    var phi_2167_: bool;
    var phi_2168_: bool;
    var phi_2175_: type_45;
    var phi_2176_: type_45;
    var phi_2177_: type_45;
    var phi_1234_: type_45;
    var phi_3779_: bool;
    var local_10: type_45;
    var phi_3936_: bool;
    var phi_3407_: type_45;
    var phi_3408_: bool;
    var phi_3409_: type_52;
    var phi_3410_: u32;
    var phi_3935_: bool;
    var phi_3411_: type_45;
    var phi_3412_: bool;
    var phi_3413_: type_52;
    var phi_3414_: u32;
    var phi_3415_: u32;
    var phi_3934_: bool;
    var phi_3416_: type_45;
    var phi_3417_: bool;
    var phi_3418_: type_52;
    var phi_3419_: u32;
    var phi_3420_: u32;
    var phi_3933_: bool;
    var phi_1108_: type_45;
    var phi_1111_: bool;
    var phi_1113_: type_52;
    var phi_1115_: u32;
    var phi_1117_: u32;
    var phi_3421_: bool;
    var phi_3932_: bool;
    var local_11: type_45;
    var local_12: type_45;
    var local_13: type_45;

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
                            phi_417_ = (bitcast<i32>((_e224 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_417_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e224)), 32u, (_e224 == 0u))));
                        }
                        let _e238 = phi_417_;
                        phi_418_ = _e238;
                    } else {
                        phi_418_ = 0i;
                    }
                    let _e240 = phi_418_;
                    let _e241 = (_e157 == _e196);
                    if _e241 {
                        phi_428_ = true;
                    } else {
                        phi_428_ = (_e164 == _e196);
                    }
                    let _e244 = phi_428_;
                    let _e245 = select(1u, 0u, _e241);
                    if _e244 {
                        let _e246 = (_e245 + 1u);
                        phi_438_ = _e246;
                        phi_439_ = _e246;
                        phi_441_ = select(true, false, (_e246 == 2u));
                    } else {
                        phi_438_ = u32();
                        phi_439_ = 0u;
                        phi_441_ = true;
                    }
                    let _e250 = phi_438_;
                    let _e252 = phi_439_;
                    let _e254 = phi_441_;
                    if _e254 {
                        phi_446_ = (_e252 + 1u);
                    } else {
                        phi_446_ = 0u;
                    }
                    let _e258 = phi_446_;
                    let _e259 = select(_e250, _e252, _e254);
                    let _e260 = select(_e245, select(2u, _e245, _e244), _e254);
                    if (_e127 < -126i) {
                        phi_459_ = -126i;
                    } else {
                        phi_459_ = select(_e127, 127i, (_e127 > 127i));
                    }
                    let _e265 = phi_459_;
                    let _e270 = bitcast<f32>((bitcast<u32>((_e265 + 127i)) << bitcast<u32>(23i)));
                    let _e276 = bitcast<f32>((bitcast<u32>(((_e127 - _e265) + 127i)) << bitcast<u32>(23i)));
                    let _e277 = -(_e240);
                    if (_e277 < -126i) {
                        phi_479_ = -126i;
                    } else {
                        phi_479_ = select(_e277, 127i, (_e277 > 127i));
                    }
                    let _e282 = phi_479_;
                    let _e287 = bitcast<f32>((bitcast<u32>((_e282 + 127i)) << bitcast<u32>(23i)));
                    let _e293 = bitcast<f32>((bitcast<u32>(((_e277 - _e282) + 127i)) << bitcast<u32>(23i)));
                    let _e297 = global_5.member[_e145].member;
                    let _e298 = (_e259 == 0u);
                    if _e298 {
                        phi_497_ = _e297[0];
                    } else {
                        phi_497_ = _e297[1];
                    }
                    let _e302 = phi_497_;
                    let _e303 = (_e259 == 2u);
                    if _e303 {
                        phi_503_ = _e297[2];
                    } else {
                        phi_503_ = _e302;
                    }
                    let _e306 = phi_503_;
                    let _e307 = bitcast<u32>(_e306);
                    let _e309 = ((_e307 & 2139095040u) != 0u);
                    let _e323 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e307 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e307 & 2147483648u))), _e306, _e309) * _e270) * select(0.00000011920929f, 1f, _e309)) * _e276);
                    let _e324 = global_5.member[_e145].member_2;
                    if _e298 {
                        phi_543_ = _e324[0];
                    } else {
                        phi_543_ = _e324[1];
                    }
                    let _e328 = phi_543_;
                    if _e303 {
                        phi_549_ = _e324[2];
                    } else {
                        phi_549_ = _e328;
                    }
                    let _e331 = phi_549_;
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
                        phi_622_ = _e297[0];
                    } else {
                        phi_622_ = _e297[1];
                    }
                    let _e369 = phi_622_;
                    let _e370 = (_e258 == 2u);
                    if _e370 {
                        phi_628_ = _e297[2];
                    } else {
                        phi_628_ = _e369;
                    }
                    let _e373 = phi_628_;
                    let _e374 = bitcast<u32>(_e373);
                    let _e376 = ((_e374 & 2139095040u) != 0u);
                    let _e390 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e374 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e374 & 2147483648u))), _e373, _e376) * _e270) * select(0.00000011920929f, 1f, _e376)) * _e276);
                    if _e365 {
                        phi_668_ = _e324[0];
                    } else {
                        phi_668_ = _e324[1];
                    }
                    let _e394 = phi_668_;
                    if _e370 {
                        phi_674_ = _e324[2];
                    } else {
                        phi_674_ = _e394;
                    }
                    let _e397 = phi_674_;
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
                        phi_747_ = _e297[0];
                    } else {
                        phi_747_ = _e297[1];
                    }
                    let _e435 = phi_747_;
                    let _e436 = (_e260 == 2u);
                    if _e436 {
                        phi_753_ = _e297[2];
                    } else {
                        phi_753_ = _e435;
                    }
                    let _e439 = phi_753_;
                    let _e440 = bitcast<u32>(_e439);
                    let _e442 = ((_e440 & 2139095040u) != 0u);
                    let _e456 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e440 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e440 & 2147483648u))), _e439, _e442) * _e270) * select(0.00000011920929f, 1f, _e442)) * _e276);
                    if _e431 {
                        phi_793_ = _e324[0];
                    } else {
                        phi_793_ = _e324[1];
                    }
                    let _e460 = phi_793_;
                    if _e436 {
                        phi_799_ = _e324[2];
                    } else {
                        phi_799_ = _e460;
                    }
                    let _e463 = phi_799_;
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
                            phi_918_ = 255i;
                        } else {
                            phi_918_ = (((_e514 + select(0i, 1i, (_e514 == 0i))) - _e521) + _e501);
                        }
                        let _e529 = phi_918_;
                        let _e539 = (_e529 <= 0i);
                        if _e539 {
                            phi_941_ = u32();
                        } else {
                            if _e518 {
                                phi_940_ = u32();
                            } else {
                                phi_940_ = select(((bitcast<u32>(_e529) << bitcast<u32>(23i)) | ((_e511 << bitcast<u32>(((_e521 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e529 >= 255i));
                            }
                            let _e543 = phi_940_;
                            phi_941_ = _e543;
                        }
                        let _e545 = phi_941_;
                        let _e557 = ((_e217 & 8388607u) | (select(0u, 1u, ((_e217 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e560 = bitcast<i32>((_e217 >> bitcast<u32>(23i)));
                        let _e564 = (_e557 == 0u);
                        let _e567 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e557)), 32u, _e564)) - 8i);
                        if (_e560 == 255i) {
                            phi_978_ = 255i;
                        } else {
                            phi_978_ = (((_e560 + select(0i, 1i, (_e560 == 0i))) - _e567) + _e501);
                        }
                        let _e575 = phi_978_;
                        let _e585 = (_e575 <= 0i);
                        if _e585 {
                            phi_1001_ = u32();
                        } else {
                            if _e564 {
                                phi_1000_ = u32();
                            } else {
                                phi_1000_ = select(((bitcast<u32>(_e575) << bitcast<u32>(23i)) | ((_e557 << bitcast<u32>(((_e567 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e575 >= 255i));
                            }
                            let _e589 = phi_1000_;
                            phi_1001_ = _e589;
                        }
                        let _e591 = phi_1001_;
                        phi_1009_ = bitcast<f32>(((_e216 & 2147483648u) | select(_e591, 0u, select(_e564, true, _e585))));
                        phi_1010_ = bitcast<f32>(((_e207 & 2147483648u) | select(_e545, 0u, select(_e518, true, _e539))));
                    } else {
                        phi_1009_ = 0f;
                        phi_1010_ = 1f;
                    }
                    let _e597 = phi_1009_;
                    let _e599 = phi_1010_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e606 = (_e259 % 3u);
                    let _e607 = (_e606 < 3u);
                    if _e607 {
                    } else {
                        break;
                    }
                    let _e609 = local_1[_e606];
                    let _e612 = (_e258 % 3u);
                    let _e613 = (_e612 < 3u);
                    if _e613 {
                    } else {
                        break;
                    }
                    let _e615 = local_1[_e612];
                    let _e618 = (_e260 % 3u);
                    let _e619 = (_e618 < 3u);
                    if _e619 {
                    } else {
                        break;
                    }
                    let _e621 = local_1[_e618];
                    if _e607 {
                    } else {
                        break;
                    }
                    let _e626 = local[_e606];
                    if _e613 {
                    } else {
                        break;
                    }
                    let _e630 = local[_e612];
                    if _e619 {
                    } else {
                        break;
                    }
                    let _e634 = local[_e618];
                    phi_3785_ = false;
                    phi_1107_ = type_45(type_38(type_29(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e597), 0u, 0u);
                    phi_1110_ = (_e599 <= _e597);
                    phi_1112_ = type_52(type_33(vec4<f32>((f32(_e609) * _e139), (f32(_e615) * _e139), (f32(_e621) * _e139), 0f), vec4<f32>((f32(_e626) * _e139), (f32(_e630) * _e139), (f32(_e634) * _e139), 0f)), select(0u, 2147483648u, (_e89 == 0u)));
                    phi_1114_ = 0u;
                    phi_1116_ = ((3u * _e89) + 1u);
                    loop {
                        let _e642 = phi_3785_;
                        let _e644 = phi_1107_;
                        let _e646 = phi_1110_;
                        let _e648 = phi_1112_;
                        let _e650 = phi_1114_;
                        let _e652 = phi_1116_;
                        local_11 = _e644;
                        local_12 = _e644;
                        if _e646 {
                            phi_1127_ = true;
                        } else {
                            phi_1127_ = (_e650 > 0u);
                        }
                        let _e655 = phi_1127_;
                        if _e655 {
                            let _e656 = (_e652 > 0u);
                            if _e656 {
                                if _e646 {
                                    phi_1213_ = _e646;
                                    phi_1214_ = _e648;
                                    phi_1215_ = _e650;
                                } else {
                                    let _e657 = (_e650 - 1u);
                                    let _e658 = (_e657 % 128u);
                                    let _e659 = (_e658 < 128u);
                                    if _e659 {
                                    } else {
                                        phi_3932_ = true;
                                        break;
                                    }
                                    let _e661 = local_7[_e658];
                                    if _e659 {
                                    } else {
                                        phi_3932_ = true;
                                        break;
                                    }
                                    let _e663 = local_6[_e658];
                                    if _e659 {
                                    } else {
                                        phi_3932_ = true;
                                        break;
                                    }
                                    let _e665 = local_5[_e658];
                                    if _e659 {
                                    } else {
                                        phi_3932_ = true;
                                        break;
                                    }
                                    let _e667 = local_4[_e658];
                                    if _e659 {
                                    } else {
                                        phi_3932_ = true;
                                        break;
                                    }
                                    let _e669 = local_3[_e658];
                                    if _e659 {
                                    } else {
                                        phi_3932_ = true;
                                        break;
                                    }
                                    let _e671 = local_2[_e658];
                                    if _e659 {
                                    } else {
                                        phi_3932_ = true;
                                        break;
                                    }
                                    let _e676 = local_8[_e658];
                                    if _e659 {
                                    } else {
                                        phi_3932_ = true;
                                        break;
                                    }
                                    let _e679 = local_9[_e658];
                                    phi_1213_ = (_e679 <= _e644.member.member_1);
                                    phi_1214_ = type_52(type_33(vec4<f32>(_e661, _e663, _e665, 0f), vec4<f32>(_e667, _e669, _e671, 0f)), _e676);
                                    phi_1215_ = _e657;
                                }
                                let _e684 = phi_1213_;
                                let _e686 = phi_1214_;
                                let _e688 = phi_1215_;
                                if _e684 {
                                    if ((_e686.member_1 & 2147483648u) != 0u) {
                                        phi_1233_ = _e644;
                                        phi_1236_ = type_4(0u, ((_e686.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1144 = phi_1233_;
                                            let _e1146 = phi_1236_;
                                            local_10 = _e1144;
                                            local_13 = _e1144;
                                            if (_e1146.member < _e1146.member_1) {
                                                phi_1237_ = type_4((_e1146.member + 1u), _e1146.member_1);
                                                phi_1259_ = type_4(1u, _e1146.member);
                                            } else {
                                                phi_1237_ = _e1146;
                                                phi_1259_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1159 = phi_1237_;
                                            let _e1161 = phi_1259_;
                                            let _e1165 = (bitcast<i32>(_e1161.member) != 0i);
                                            if _e1165 {
                                                let _e1171 = type_45(_e1144.member, _e1144.member_1, (_e1144.member_2 + 1u));
                                                let _e1172 = ((_e686.member_1 & 268435455u) + _e1161.member_1);
                                                let _e1173 = (_e1172 < _e91);
                                                if _e1173 {
                                                    if _e1173 {
                                                    } else {
                                                        phi_3779_ = true;
                                                        break;
                                                    }
                                                    let _e1177 = global_2.member[_e1172].member_1;
                                                    phi_1283_ = _e1177;
                                                } else {
                                                    phi_1283_ = 4294967295u;
                                                }
                                                let _e1179 = phi_1283_;
                                                if (_e1172 >= _e91) {
                                                    phi_1375_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1173 {
                                                    } else {
                                                        phi_3779_ = true;
                                                        break;
                                                    }
                                                    if (_e606 < 9u) {
                                                    } else {
                                                        phi_3779_ = true;
                                                        break;
                                                    }
                                                    let _e1186 = global_2.member[_e1172].member[_e606];
                                                    if (_e612 < 9u) {
                                                    } else {
                                                        phi_3779_ = true;
                                                        break;
                                                    }
                                                    let _e1192 = global_2.member[_e1172].member[_e612];
                                                    if (_e618 < 9u) {
                                                    } else {
                                                        phi_3779_ = true;
                                                        break;
                                                    }
                                                    let _e1198 = global_2.member[_e1172].member[_e618];
                                                    let _e1200 = (3u + _e606);
                                                    if (_e1200 < 9u) {
                                                    } else {
                                                        phi_3779_ = true;
                                                        break;
                                                    }
                                                    let _e1206 = global_2.member[_e1172].member[_e1200];
                                                    let _e1207 = (3u + _e612);
                                                    if (_e1207 < 9u) {
                                                    } else {
                                                        phi_3779_ = true;
                                                        break;
                                                    }
                                                    let _e1213 = global_2.member[_e1172].member[_e1207];
                                                    let _e1214 = (3u + _e618);
                                                    if (_e1214 < 9u) {
                                                    } else {
                                                        phi_3779_ = true;
                                                        break;
                                                    }
                                                    let _e1220 = global_2.member[_e1172].member[_e1214];
                                                    let _e1222 = (6u + _e606);
                                                    if (_e1222 < 9u) {
                                                    } else {
                                                        phi_3779_ = true;
                                                        break;
                                                    }
                                                    let _e1228 = global_2.member[_e1172].member[_e1222];
                                                    let _e1229 = (6u + _e612);
                                                    if (_e1229 < 9u) {
                                                    } else {
                                                        phi_3779_ = true;
                                                        break;
                                                    }
                                                    let _e1235 = global_2.member[_e1172].member[_e1229];
                                                    let _e1236 = (6u + _e618);
                                                    if (_e1236 < 9u) {
                                                    } else {
                                                        phi_3779_ = true;
                                                        break;
                                                    }
                                                    let _e1242 = global_2.member[_e1172].member[_e1236];
                                                    phi_1375_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1186, _e1192, _e1198), array<f32, 3>(_e1206, _e1213, _e1220), array<f32, 3>(_e1228, _e1235, _e1242));
                                                }
                                                let _e1246 = phi_1375_;
                                                let _e1263 = (_e1246[0][2] - _e456);
                                                let _e1266 = (((_e1246[0][0] - _e323) * _e492) - (_e1263 * _e360));
                                                let _e1269 = (((_e1246[0][1] - _e390) * _e492) - (_e1263 * _e426));
                                                let _e1272 = (_e1246[1][2] - _e456);
                                                let _e1275 = (((_e1246[1][0] - _e323) * _e492) - (_e1272 * _e360));
                                                let _e1278 = (((_e1246[1][1] - _e390) * _e492) - (_e1272 * _e426));
                                                let _e1281 = (_e1246[2][2] - _e456);
                                                let _e1284 = (((_e1246[2][0] - _e323) * _e492) - (_e1281 * _e360));
                                                let _e1287 = (((_e1246[2][1] - _e390) * _e492) - (_e1281 * _e426));
                                                let _e1288 = (_e1284 * _e1278);
                                                let _e1289 = (_e1287 * _e1275);
                                                let _e1290 = (_e1266 * _e1287);
                                                let _e1291 = (_e1269 * _e1284);
                                                let _e1292 = (_e1275 * _e1269);
                                                let _e1293 = (_e1278 * _e1266);
                                                let _e1298 = (((_e1288 >= _e1289) && (_e1290 >= _e1291)) && (_e1292 >= _e1293));
                                                let _e1304 = (_e1298 || (((_e1288 <= _e1289) && (_e1290 <= _e1291)) && (_e1292 <= _e1293)));
                                                if _e1304 {
                                                    let _e1306 = select(-1f, 1f, _e1298);
                                                    let _e1308 = ((_e1288 - _e1289) * _e1306);
                                                    let _e1310 = select(0f, _e1308, (_e1308 > 0f));
                                                    let _e1312 = ((_e1290 - _e1291) * _e1306);
                                                    let _e1314 = select(0f, _e1312, (_e1312 > 0f));
                                                    let _e1316 = ((_e1292 - _e1293) * _e1306);
                                                    let _e1318 = select(0f, _e1316, (_e1316 > 0f));
                                                    let _e1320 = ((_e1310 + _e1314) + _e1318);
                                                    let _e1322 = select(_e1246[1][0], _e1246[0][0], (_e1246[0][0] < _e1246[1][0]));
                                                    let _e1326 = select(_e1246[1][0], _e1246[0][0], (_e1246[0][0] > _e1246[1][0]));
                                                    let _e1330 = select(_e1246[1][1], _e1246[0][1], (_e1246[0][1] < _e1246[1][1]));
                                                    let _e1334 = select(_e1246[1][1], _e1246[0][1], (_e1246[0][1] > _e1246[1][1]));
                                                    let _e1338 = select(_e1246[1][2], _e1246[0][2], (_e1246[0][2] < _e1246[1][2]));
                                                    let _e1342 = select(_e1246[1][2], _e1246[0][2], (_e1246[0][2] > _e1246[1][2]));
                                                    let _e1347 = ((select(_e1246[2][0], _e1322, (_e1322 < _e1246[2][0])) - _e361) * _e364);
                                                    let _e1348 = ((select(_e1246[2][0], _e1326, (_e1326 > _e1246[2][0])) - _e362) * _e364);
                                                    let _e1351 = ((select(_e1246[2][1], _e1330, (_e1330 < _e1246[2][1])) - _e427) * _e430);
                                                    let _e1352 = ((select(_e1246[2][1], _e1334, (_e1334 > _e1246[2][1])) - _e428) * _e430);
                                                    let _e1355 = ((select(_e1246[2][2], _e1338, (_e1338 < _e1246[2][2])) - _e493) * _e496);
                                                    let _e1356 = ((select(_e1246[2][2], _e1342, (_e1342 > _e1246[2][2])) - _e494) * _e496);
                                                    let _e1358 = select(_e1356, _e1355, (_e1355 < _e1356));
                                                    let _e1360 = select(_e1356, _e1355, (_e1355 > _e1356));
                                                    let _e1362 = select(_e1348, _e1347, (_e1347 < _e1348));
                                                    let _e1364 = select(_e1352, _e1351, (_e1351 < _e1352));
                                                    let _e1366 = select(_e1364, _e1362, (_e1362 > _e1364));
                                                    let _e1368 = select(_e1358, _e1366, (_e1366 > _e1358));
                                                    let _e1370 = select(_e1348, _e1347, (_e1347 > _e1348));
                                                    let _e1372 = select(_e1352, _e1351, (_e1351 > _e1352));
                                                    let _e1374 = select(_e1372, _e1370, (_e1370 < _e1372));
                                                    let _e1376 = select(_e1360, _e1374, (_e1374 < _e1360));
                                                    let _e1377 = -(_e1358);
                                                    let _e1383 = select(_e599, _e1368, (_e1368 > _e599));
                                                    let _e1387 = select(_e1275, _e1266, (_e1266 < _e1275));
                                                    let _e1392 = select(_e1275, _e1266, (_e1266 > _e1275));
                                                    let _e1399 = select(_e1278, _e1269, (_e1269 < _e1278));
                                                    let _e1404 = select(_e1278, _e1269, (_e1269 > _e1278));
                                                    let _e1413 = (((((_e1304 && (_e1320 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1284, _e1387, (_e1387 < _e1284)) <= 0f) && (select(_e1284, _e1392, (_e1392 > _e1284)) >= 0f))) && ((select(_e1287, _e1399, (_e1399 < _e1287)) <= 0f) && (select(_e1287, _e1404, (_e1404 > _e1287)) >= 0f))) && (_e1383 <= (_e1376 + (select(_e1377, _e1360, (_e1360 > _e1377)) * 0.0000019073523f)))) && (_e1383 <= _e1144.member.member_1));
                                                    if _e1413 {
                                                        let _e1418 = (_e1246[1][0] - _e1246[0][0]);
                                                        let _e1419 = (_e1246[1][1] - _e1246[0][1]);
                                                        let _e1420 = (_e1246[1][2] - _e1246[0][2]);
                                                        let _e1421 = vec3<f32>(_e1418, _e1419, _e1420);
                                                        let _e1422 = (_e1246[2][0] - _e1246[1][0]);
                                                        let _e1423 = (_e1246[2][1] - _e1246[1][1]);
                                                        let _e1424 = (_e1246[2][2] - _e1246[1][2]);
                                                        let _e1425 = vec3<f32>(_e1422, _e1423, _e1424);
                                                        let _e1426 = (_e1246[0][0] - _e1246[2][0]);
                                                        let _e1427 = (_e1246[0][1] - _e1246[2][1]);
                                                        let _e1428 = (_e1246[0][2] - _e1246[2][2]);
                                                        let _e1429 = vec3<f32>(_e1426, _e1427, _e1428);
                                                        let _e1432 = bitcast<f32>((bitcast<u32>(_e1418) & 2147483647u));
                                                        let _e1435 = bitcast<f32>((bitcast<u32>(_e1419) & 2147483647u));
                                                        let _e1437 = select(_e1435, _e1432, (_e1432 > _e1435));
                                                        let _e1440 = bitcast<f32>((bitcast<u32>(_e1420) & 2147483647u));
                                                        let _e1442 = select(_e1440, _e1437, (_e1437 > _e1440));
                                                        let _e1445 = bitcast<f32>((bitcast<u32>(_e1422) & 2147483647u));
                                                        let _e1448 = bitcast<f32>((bitcast<u32>(_e1423) & 2147483647u));
                                                        let _e1450 = select(_e1448, _e1445, (_e1445 > _e1448));
                                                        let _e1453 = bitcast<f32>((bitcast<u32>(_e1424) & 2147483647u));
                                                        let _e1455 = select(_e1453, _e1450, (_e1450 > _e1453));
                                                        let _e1458 = bitcast<f32>((bitcast<u32>(_e1426) & 2147483647u));
                                                        let _e1461 = bitcast<f32>((bitcast<u32>(_e1427) & 2147483647u));
                                                        let _e1463 = select(_e1461, _e1458, (_e1458 > _e1461));
                                                        let _e1466 = bitcast<f32>((bitcast<u32>(_e1428) & 2147483647u));
                                                        let _e1468 = select(_e1466, _e1463, (_e1463 > _e1466));
                                                        let _e1470 = select(_e1455, _e1442, (_e1442 > _e1455));
                                                        let _e1472 = select(_e1468, _e1470, (_e1470 > _e1468));
                                                        if (_e1442 == _e1472) {
                                                            phi_1905_ = _e1278;
                                                            phi_1906_ = _e1275;
                                                            phi_1907_ = _e1269;
                                                            phi_1908_ = _e1266;
                                                            phi_1909_ = vec3<f32>(_e1246[0][0], _e1246[0][1], _e1246[0][2]);
                                                            phi_1910_ = _e1429;
                                                            phi_1911_ = _e1425;
                                                            phi_1912_ = _e1421;
                                                        } else {
                                                            let _e1474 = (_e1455 == _e1472);
                                                            let _e1479 = vec3(_e1474);
                                                            phi_1905_ = select(_e1269, _e1287, _e1474);
                                                            phi_1906_ = select(_e1266, _e1284, _e1474);
                                                            phi_1907_ = select(_e1287, _e1278, _e1474);
                                                            phi_1908_ = select(_e1284, _e1275, _e1474);
                                                            phi_1909_ = select(vec3<f32>(_e1246[2][0], _e1246[2][1], _e1246[2][2]), vec3<f32>(_e1246[1][0], _e1246[1][1], _e1246[1][2]), _e1479);
                                                            phi_1910_ = select(_e1425, _e1421, _e1479);
                                                            phi_1911_ = select(_e1421, _e1429, _e1479);
                                                            phi_1912_ = select(_e1429, _e1425, _e1479);
                                                        }
                                                        let _e1485 = phi_1905_;
                                                        let _e1487 = phi_1906_;
                                                        let _e1489 = phi_1907_;
                                                        let _e1491 = phi_1908_;
                                                        let _e1493 = phi_1909_;
                                                        let _e1495 = phi_1910_;
                                                        let _e1497 = phi_1911_;
                                                        let _e1499 = phi_1912_;
                                                        let _e1506 = ((_e1497.y * _e1495.z) - (_e1495.y * _e1497.z));
                                                        let _e1511 = ((_e1497.z * _e1495.x) - (_e1495.z * _e1497.x));
                                                        let _e1514 = ((_e1497.x * _e1495.y) - (_e1495.x * _e1497.y));
                                                        let _e1517 = ((_e1310 >= _e1314) && (_e1310 >= _e1318));
                                                        let _e1518 = (_e1314 >= _e1318);
                                                        let _e1532 = (((_e1506 * (select(select(_e1246[2][0], _e1246[1][0], _e1518), _e1246[0][0], _e1517) - _e323)) + (_e1511 * (select(select(_e1246[2][1], _e1246[1][1], _e1518), _e1246[0][1], _e1517) - _e390))) + (_e1514 * (select(select(_e1246[2][2], _e1246[1][2], _e1518), _e1246[0][2], _e1517) - _e456)));
                                                        let _e1537 = (((_e1506 * _e360) + (_e1511 * _e426)) + (_e1514 * _e492));
                                                        let _e1538 = (_e1487 - _e1491);
                                                        let _e1539 = (_e1485 - _e1489);
                                                        let _e1542 = ((_e1538 * _e1538) + (_e1539 * _e1539));
                                                        let _e1549 = (-(((_e1491 * _e1538) + (_e1489 * _e1539))) / select(0.000000000000000000000000000000000000011754944f, _e1542, (_e1542 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1551 = select(1f, _e1549, (_e1549 < 1f));
                                                        let _e1553 = select(0f, _e1551, (_e1551 > 0f));
                                                        let _e1562 = ((_e1493.x + (_e1499.x * _e1553)) - _e323);
                                                        let _e1565 = ((_e1493.y + (_e1499.y * _e1553)) - _e390);
                                                        let _e1568 = ((_e1493.z + (_e1499.z * _e1553)) - _e456);
                                                        let _e1571 = bitcast<f32>((bitcast<u32>(_e1562) & 2147483647u));
                                                        let _e1574 = bitcast<f32>((bitcast<u32>(_e1565) & 2147483647u));
                                                        let _e1576 = select(_e1574, _e1571, (_e1571 > _e1574));
                                                        let _e1579 = bitcast<f32>((bitcast<u32>(_e1568) & 2147483647u));
                                                        let _e1581 = select(_e1579, _e1576, (_e1576 > _e1579));
                                                        let _e1587 = bitcast<f32>((bitcast<u32>(_e1506) & 2147483647u));
                                                        let _e1590 = bitcast<f32>((bitcast<u32>(_e1511) & 2147483647u));
                                                        let _e1592 = select(_e1590, _e1587, (_e1587 > _e1590));
                                                        let _e1595 = bitcast<f32>((bitcast<u32>(_e1514) & 2147483647u));
                                                        let _e1614 = bitcast<f32>((bitcast<u32>(_e1497.x) & 2147483647u));
                                                        let _e1617 = bitcast<f32>((bitcast<u32>(_e1497.y) & 2147483647u));
                                                        let _e1619 = select(_e1617, _e1614, (_e1614 > _e1617));
                                                        let _e1622 = bitcast<f32>((bitcast<u32>(_e1497.z) & 2147483647u));
                                                        let _e1628 = bitcast<f32>((bitcast<u32>(_e1495.x) & 2147483647u));
                                                        let _e1631 = bitcast<f32>((bitcast<u32>(_e1495.y) & 2147483647u));
                                                        let _e1633 = select(_e1631, _e1628, (_e1628 > _e1631));
                                                        let _e1636 = bitcast<f32>((bitcast<u32>(_e1495.z) & 2147483647u));
                                                        let _e1642 = ((bitcast<f32>((bitcast<u32>(((((_e1506 * _e1562) + (_e1511 * _e1565)) + (_e1514 * _e1568)) - _e1532)) & 2147483647u)) <= ((0.0000009536743f * select(_e1472, _e1581, (_e1581 > _e1472))) * select(_e1595, _e1592, (_e1592 > _e1595)))) && !((bitcast<f32>((bitcast<u32>(_e1537) & 2147483647u)) <= ((0.0000038146973f * select(_e1622, _e1619, (_e1619 > _e1622))) * select(_e1636, _e1633, (_e1633 > _e1636))))));
                                                        let _e1643 = (_e1532 / _e1537);
                                                        if (_e1413 && !(_e1642)) {
                                                            let _e1646 = (_e1568 / _e492);
                                                            let _e1654 = (((_e1506 * (_e1562 - (_e360 * _e1646))) + (_e1511 * (_e1565 - (_e426 * _e1646)))) / _e1537);
                                                            phi_2103_ = select(select(_e1646, (_e1646 + _e1654), (bitcast<f32>((bitcast<u32>(_e1654) & 2147483647u)) <= _e1472)), _e1643, _e1642);
                                                        } else {
                                                            phi_2103_ = _e1643;
                                                        }
                                                        let _e1663 = phi_2103_;
                                                        let _e1665 = select(_e1376, _e1663, (_e1663 < _e1376));
                                                        let _e1667 = select(_e1368, _e1665, (_e1665 > _e1368));
                                                        let _e1668 = (1f / _e1320);
                                                        phi_2123_ = type_41(_e1667, (_e1314 * _e1668), (_e1318 * _e1668), ((_e1413 && (_e1667 >= _e599)) && (_e1667 <= _e1144.member.member_1)));
                                                        phi_2124_ = type_41();
                                                    } else {
                                                        phi_2123_ = type_41();
                                                        phi_2124_ = type_41(0f, 0f, 0f, _e1413);
                                                    }
                                                    let _e1677 = phi_2123_;
                                                    let _e1679 = phi_2124_;
                                                    phi_2127_ = _e1677;
                                                    phi_2128_ = _e1679;
                                                    phi_2129_ = select(true, false, _e1413);
                                                } else {
                                                    phi_2127_ = type_41();
                                                    phi_2128_ = type_41(0f, 0f, 0f, _e1304);
                                                    phi_2129_ = true;
                                                }
                                                let _e1682 = phi_2127_;
                                                let _e1684 = phi_2128_;
                                                let _e1686 = phi_2129_;
                                                if _e1686 {
                                                    phi_2133_ = _e1684;
                                                } else {
                                                    phi_2133_ = _e1682;
                                                }
                                                let _e1688 = phi_2133_;
                                                if _e1688.member_3 {
                                                    phi_2142_ = type_29(_e1688.member, _e1688.member_1, _e1688.member_2, _e1179);
                                                } else {
                                                    phi_2142_ = type_29(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1695 = phi_2142_;
                                                if (_e1695.member_3 != 4294967295u) {
                                                    if (_e1179 != 4294967295u) {
                                                        if (_e1695.member < _e1144.member.member.member) {
                                                            phi_2168_ = true;
                                                        } else {
                                                            if (_e1695.member == _e1144.member.member.member) {
                                                                phi_2167_ = (_e1695.member_3 < _e1144.member.member.member_3);
                                                            } else {
                                                                phi_2167_ = false;
                                                            }
                                                            let _e1710 = phi_2167_;
                                                            phi_2168_ = _e1710;
                                                        }
                                                        let _e1712 = phi_2168_;
                                                        if _e1712 {
                                                            phi_2175_ = type_45(type_38(_e1695, _e1695.member), _e1171.member_1, _e1171.member_2);
                                                        } else {
                                                            phi_2175_ = _e1171;
                                                        }
                                                        let _e1719 = phi_2175_;
                                                        phi_2176_ = _e1719;
                                                    } else {
                                                        phi_2176_ = _e1171;
                                                    }
                                                    let _e1721 = phi_2176_;
                                                    phi_2177_ = _e1721;
                                                } else {
                                                    phi_2177_ = _e1171;
                                                }
                                                let _e1723 = phi_2177_;
                                                phi_1234_ = _e1723;
                                            } else {
                                                phi_1234_ = type_45();
                                            }
                                            let _e1725 = phi_1234_;
                                            continue;
                                            continuing {
                                                phi_1233_ = _e1725;
                                                phi_1236_ = _e1159;
                                                phi_3779_ = _e642;
                                                break if !(_e1165);
                                            }
                                        }
                                        let _e1728 = phi_3779_;
                                        phi_3932_ = _e1728;
                                        if _e1728 {
                                            break;
                                        }
                                        let _e1730 = local_10;
                                        phi_3936_ = _e1728;
                                        let _e1888 = local_13;
                                        phi_3407_ = _e1888;
                                        phi_3408_ = false;
                                        phi_3409_ = _e686;
                                        phi_3410_ = select(_e688, 0u, (_e599 > _e1730.member.member_1));
                                    } else {
                                        if (_e686.member_1 >= _e89) {
                                            phi_2943_ = type_53(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_52(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_52(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e686.member_1 < _e89) {
                                            } else {
                                                phi_3932_ = true;
                                                break;
                                            }
                                            let _e700 = ((1u + _e259) % 4u);
                                            if (_e700 < 4u) {
                                            } else {
                                                phi_3932_ = true;
                                                break;
                                            }
                                            let _e705 = global_4.member[_e686.member_1][_e700];
                                            let _e707 = (_e705 >> bitcast<u32>(11u));
                                            let _e709 = ((1u + _e258) % 4u);
                                            if (_e709 < 4u) {
                                            } else {
                                                phi_3932_ = true;
                                                break;
                                            }
                                            let _e714 = global_4.member[_e686.member_1][_e709];
                                            let _e716 = (_e714 >> bitcast<u32>(11u));
                                            let _e718 = ((1u + _e260) % 4u);
                                            if (_e718 < 4u) {
                                            } else {
                                                phi_3932_ = true;
                                                break;
                                            }
                                            let _e723 = global_4.member[_e686.member_1][_e718];
                                            let _e725 = (_e723 >> bitcast<u32>(11u));
                                            let _e748 = (bitcast<f32>((bitcast<u32>((_e686.member.member_1.x - _e686.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e749 = (bitcast<f32>((bitcast<u32>((_e686.member.member_1.y - _e686.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e750 = (bitcast<f32>((bitcast<u32>((_e686.member.member_1.z - _e686.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e752 = select(_e139, _e748, (_e748 > _e139));
                                            let _e754 = select(_e139, _e749, (_e749 > _e139));
                                            let _e756 = select(_e139, _e750, (_e750 > _e139));
                                            let _e787 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e705 & 1023u))) - 8388608f) * _e752));
                                            let _e792 = (bitcast<i32>((_e705 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e795 = bitcast<f32>((_e787 & bitcast<u32>(_e792)));
                                            let _e796 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e714 & 1023u))) - 8388608f) * _e754));
                                            let _e801 = (bitcast<i32>((_e714 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e804 = bitcast<f32>((_e796 & bitcast<u32>(_e801)));
                                            let _e805 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e723 & 1023u))) - 8388608f) * _e756));
                                            let _e810 = (bitcast<i32>((_e723 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e813 = bitcast<f32>((_e805 & bitcast<u32>(_e810)));
                                            let _e817 = bitcast<f32>((_e787 & bitcast<u32>(~(_e792))));
                                            let _e821 = bitcast<f32>((_e796 & bitcast<u32>(~(_e801))));
                                            let _e825 = bitcast<f32>((_e805 & bitcast<u32>(~(_e810))));
                                            let _e826 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e707 & 1023u))) - 8388608f) * _e752));
                                            let _e831 = (bitcast<i32>((_e707 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e834 = bitcast<f32>((_e826 & bitcast<u32>(_e831)));
                                            let _e835 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e716 & 1023u))) - 8388608f) * _e754));
                                            let _e840 = (bitcast<i32>((_e716 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e843 = bitcast<f32>((_e835 & bitcast<u32>(_e840)));
                                            let _e844 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e725 & 1023u))) - 8388608f) * _e756));
                                            let _e849 = (bitcast<i32>((_e725 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e852 = bitcast<f32>((_e844 & bitcast<u32>(_e849)));
                                            let _e856 = bitcast<f32>((_e826 & bitcast<u32>(~(_e831))));
                                            let _e860 = bitcast<f32>((_e835 & bitcast<u32>(~(_e840))));
                                            let _e864 = bitcast<f32>((_e844 & bitcast<u32>(~(_e849))));
                                            let _e894 = global_4.member[_e686.member_1][0u];
                                            let _e898 = global_4.member[_e686.member_1][1u];
                                            let _e902 = global_4.member[_e686.member_1][2u];
                                            let _e906 = global_4.member[_e686.member_1][3u];
                                            let _e918 = (((_e898 >> bitcast<u32>(22i)) | ((_e902 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e906 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e919 = (_e894 & 268435455u);
                                            let _e920 = (_e918 & 268435455u);
                                            let _e923 = ((_e894 >> bitcast<u32>(28u)) & 7u);
                                            let _e931 = ((_e894 >> bitcast<u32>(31i)) | (((_e918 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e932 = (_e923 != 0u);
                                            if (_e923 == 0u) {
                                                phi_2905_ = _e919;
                                            } else {
                                                if (_e923 == 7u) {
                                                    phi_2904_ = 2147483648u;
                                                } else {
                                                    phi_2904_ = ((2147483648u | (_e923 << bitcast<u32>(28u))) | (_e920 & 268435455u));
                                                }
                                                let _e941 = phi_2904_;
                                                phi_2905_ = _e941;
                                            }
                                            let _e943 = phi_2905_;
                                            if _e932 {
                                                let _e944 = (_e923 != 7u);
                                                if _e944 {
                                                    phi_2915_ = (_e920 + _e923);
                                                } else {
                                                    phi_2915_ = u32();
                                                }
                                                let _e947 = phi_2915_;
                                                phi_2917_ = _e947;
                                                phi_2918_ = select(true, false, _e944);
                                            } else {
                                                phi_2917_ = u32();
                                                phi_2918_ = true;
                                            }
                                            let _e950 = phi_2917_;
                                            let _e952 = phi_2918_;
                                            if (_e931 == 0u) {
                                                phi_2939_ = (_e919 + select(0u, 1u, !(_e932)));
                                            } else {
                                                if (_e931 == 7u) {
                                                    phi_2938_ = 2147483648u;
                                                } else {
                                                    phi_2938_ = ((2147483648u | (_e931 << bitcast<u32>(28u))) | (select(_e950, _e920, _e952) & 268435455u));
                                                }
                                                let _e965 = phi_2938_;
                                                phi_2939_ = _e965;
                                            }
                                            let _e967 = phi_2939_;
                                            phi_2943_ = type_53(array<vec4<f32>, 3>(vec4<f32>((_e686.member.member.x + _e795), (_e686.member.member.x + _e817), (_e686.member.member_1.x - _e834), (_e686.member.member_1.x - _e856)), vec4<f32>((_e686.member.member.y + _e804), (_e686.member.member.y + _e821), (_e686.member.member_1.y - _e843), (_e686.member.member_1.y - _e860)), vec4<f32>((_e686.member.member.z + _e813), (_e686.member.member.z + _e825), (_e686.member.member_1.z - _e852), (_e686.member.member_1.z - _e864))), type_52(type_33((_e686.member.member + vec4<f32>(_e795, _e804, _e813, 0f)), (_e686.member.member_1 - vec4<f32>(_e834, _e843, _e852, 0f))), _e943), type_52(type_33((_e686.member.member + vec4<f32>(_e817, _e821, _e825, 0f)), (_e686.member.member_1 - vec4<f32>(_e856, _e860, _e864, 0f))), _e967));
                                        }
                                        let _e972 = phi_2943_;
                                        let _e991 = ((_e972.member[0].x - _e361) * _e364);
                                        let _e992 = ((_e972.member[0].y - _e361) * _e364);
                                        let _e993 = ((_e972.member[0].z - _e362) * _e364);
                                        let _e994 = ((_e972.member[0].w - _e362) * _e364);
                                        let _e1004 = ((_e972.member[1].x - _e427) * _e430);
                                        let _e1005 = ((_e972.member[1].y - _e427) * _e430);
                                        let _e1006 = ((_e972.member[1].z - _e428) * _e430);
                                        let _e1007 = ((_e972.member[1].w - _e428) * _e430);
                                        let _e1017 = ((_e972.member[2].x - _e493) * _e496);
                                        let _e1018 = ((_e972.member[2].y - _e493) * _e496);
                                        let _e1019 = ((_e972.member[2].z - _e494) * _e496);
                                        let _e1020 = ((_e972.member[2].w - _e494) * _e496);
                                        let _e1022 = select(_e1019, _e1017, (_e1017 < _e1019));
                                        let _e1024 = select(_e1020, _e1018, (_e1018 < _e1020));
                                        let _e1026 = select(_e1019, _e1017, (_e1017 > _e1019));
                                        let _e1028 = select(_e1020, _e1018, (_e1018 > _e1020));
                                        let _e1030 = select(_e993, _e991, (_e991 < _e993));
                                        let _e1032 = select(_e994, _e992, (_e992 < _e994));
                                        let _e1034 = select(_e1006, _e1004, (_e1004 < _e1006));
                                        let _e1036 = select(_e1007, _e1005, (_e1005 < _e1007));
                                        let _e1038 = select(_e1034, _e1030, (_e1030 > _e1034));
                                        let _e1040 = select(_e1036, _e1032, (_e1032 > _e1036));
                                        let _e1042 = select(_e1022, _e1038, (_e1038 > _e1022));
                                        let _e1044 = select(_e1024, _e1040, (_e1040 > _e1024));
                                        let _e1046 = select(_e993, _e991, (_e991 > _e993));
                                        let _e1048 = select(_e994, _e992, (_e992 > _e994));
                                        let _e1050 = select(_e1006, _e1004, (_e1004 > _e1006));
                                        let _e1052 = select(_e1007, _e1005, (_e1005 > _e1007));
                                        let _e1054 = select(_e1050, _e1046, (_e1046 < _e1050));
                                        let _e1056 = select(_e1052, _e1048, (_e1048 < _e1052));
                                        let _e1061 = -(_e1022);
                                        let _e1062 = -(_e1024);
                                        let _e1069 = (select(_e1026, _e1054, (_e1054 < _e1026)) + (select(_e1061, _e1026, (_e1026 > _e1061)) * 0.0000019073523f));
                                        let _e1070 = (select(_e1028, _e1056, (_e1056 < _e1028)) + (select(_e1062, _e1028, (_e1028 > _e1062)) * 0.0000019073523f));
                                        let _e1072 = select(_e599, _e1042, (_e1042 > _e599));
                                        let _e1074 = select(_e599, _e1044, (_e1044 > _e599));
                                        let _e1079 = (_e1072 <= select(_e644.member.member_1, _e1069, (_e1069 < _e644.member.member_1)));
                                        let _e1080 = (_e1074 <= select(_e644.member.member_1, _e1070, (_e1070 < _e644.member.member_1)));
                                        let _e1081 = (_e1072 <= _e1074);
                                        if _e1079 {
                                            if _e1080 {
                                                if _e1081 {
                                                    phi_3308_ = _e972.member_2;
                                                } else {
                                                    phi_3308_ = _e972.member_1;
                                                }
                                                let _e1085 = phi_3308_;
                                                let _e1106 = (_e688 % 128u);
                                                let _e1107 = (_e1106 < 128u);
                                                if _e1107 {
                                                } else {
                                                    phi_3932_ = true;
                                                    break;
                                                }
                                                local_8[_e1106] = _e1085.member_1;
                                                if _e1107 {
                                                } else {
                                                    phi_3932_ = true;
                                                    break;
                                                }
                                                local_7[_e1106] = _e1085.member.member.x;
                                                if _e1107 {
                                                } else {
                                                    phi_3932_ = true;
                                                    break;
                                                }
                                                local_6[_e1106] = _e1085.member.member.y;
                                                if _e1107 {
                                                } else {
                                                    phi_3932_ = true;
                                                    break;
                                                }
                                                local_5[_e1106] = _e1085.member.member.z;
                                                if _e1107 {
                                                } else {
                                                    phi_3932_ = true;
                                                    break;
                                                }
                                                local_4[_e1106] = _e1085.member.member_1.x;
                                                if _e1107 {
                                                } else {
                                                    phi_3932_ = true;
                                                    break;
                                                }
                                                local_3[_e1106] = _e1085.member.member_1.y;
                                                if _e1107 {
                                                } else {
                                                    phi_3932_ = true;
                                                    break;
                                                }
                                                local_2[_e1106] = _e1085.member.member_1.z;
                                                if _e1107 {
                                                } else {
                                                    phi_3932_ = true;
                                                    break;
                                                }
                                                local_9[_e1106] = select(_e1072, _e1074, _e1081);
                                                if _e1081 {
                                                    phi_3384_ = _e972.member_1;
                                                } else {
                                                    phi_3384_ = _e972.member_2;
                                                }
                                                let _e1120 = phi_3384_;
                                                phi_3385_ = _e1120;
                                                phi_3386_ = (_e688 + 1u);
                                            } else {
                                                phi_3385_ = type_52();
                                                phi_3386_ = u32();
                                            }
                                            let _e1122 = phi_3385_;
                                            let _e1124 = phi_3386_;
                                            phi_3388_ = _e1122;
                                            phi_3389_ = _e1124;
                                            phi_3390_ = select(true, false, _e1080);
                                        } else {
                                            phi_3388_ = type_52();
                                            phi_3389_ = u32();
                                            phi_3390_ = true;
                                        }
                                        let _e1127 = phi_3388_;
                                        let _e1129 = phi_3389_;
                                        let _e1131 = phi_3390_;
                                        if _e1131 {
                                            if _e1079 {
                                                phi_3399_ = _e972.member_1;
                                            } else {
                                                phi_3399_ = _e972.member_2;
                                            }
                                            let _e1135 = phi_3399_;
                                            phi_3404_ = select(_e1080, true, _e1079);
                                            phi_3405_ = _e1135;
                                        } else {
                                            phi_3404_ = _e684;
                                            phi_3405_ = _e1127;
                                        }
                                        let _e1138 = phi_3404_;
                                        let _e1140 = phi_3405_;
                                        phi_3936_ = _e642;
                                        phi_3407_ = type_45(_e644.member, (_e644.member_1 + 1u), _e644.member_2);
                                        phi_3408_ = _e1138;
                                        phi_3409_ = _e1140;
                                        phi_3410_ = select(_e1129, _e688, _e1131);
                                    }
                                    let _e1736 = phi_3936_;
                                    let _e1738 = phi_3407_;
                                    let _e1740 = phi_3408_;
                                    let _e1742 = phi_3409_;
                                    let _e1744 = phi_3410_;
                                    phi_3935_ = _e1736;
                                    phi_3411_ = _e1738;
                                    phi_3412_ = _e1740;
                                    phi_3413_ = _e1742;
                                    phi_3414_ = _e1744;
                                    phi_3415_ = (_e652 - 1u);
                                } else {
                                    phi_3935_ = _e642;
                                    phi_3411_ = _e644;
                                    phi_3412_ = _e684;
                                    phi_3413_ = _e686;
                                    phi_3414_ = _e688;
                                    phi_3415_ = _e652;
                                }
                                let _e1746 = phi_3935_;
                                let _e1748 = phi_3411_;
                                let _e1750 = phi_3412_;
                                let _e1752 = phi_3413_;
                                let _e1754 = phi_3414_;
                                let _e1756 = phi_3415_;
                                phi_3934_ = _e1746;
                                phi_3416_ = _e1748;
                                phi_3417_ = _e1750;
                                phi_3418_ = _e1752;
                                phi_3419_ = _e1754;
                                phi_3420_ = _e1756;
                            } else {
                                phi_3934_ = _e642;
                                phi_3416_ = type_45();
                                phi_3417_ = bool();
                                phi_3418_ = type_52();
                                phi_3419_ = u32();
                                phi_3420_ = u32();
                            }
                            let _e1758 = phi_3934_;
                            let _e1760 = phi_3416_;
                            let _e1762 = phi_3417_;
                            let _e1764 = phi_3418_;
                            let _e1766 = phi_3419_;
                            let _e1768 = phi_3420_;
                            phi_3933_ = _e1758;
                            phi_1108_ = _e1760;
                            phi_1111_ = _e1762;
                            phi_1113_ = _e1764;
                            phi_1115_ = _e1766;
                            phi_1117_ = _e1768;
                            phi_3421_ = _e656;
                        } else {
                            phi_3933_ = _e642;
                            phi_1108_ = type_45();
                            phi_1111_ = bool();
                            phi_1113_ = type_52();
                            phi_1115_ = u32();
                            phi_1117_ = u32();
                            phi_3421_ = false;
                        }
                        let _e1770 = phi_3933_;
                        let _e1772 = phi_1108_;
                        let _e1774 = phi_1111_;
                        let _e1776 = phi_1113_;
                        let _e1778 = phi_1115_;
                        let _e1780 = phi_1117_;
                        let _e1782 = phi_3421_;
                        continue;
                        continuing {
                            phi_3785_ = _e1770;
                            phi_1107_ = _e1772;
                            phi_1110_ = _e1774;
                            phi_1112_ = _e1776;
                            phi_1114_ = _e1778;
                            phi_1116_ = _e1780;
                            phi_3932_ = _e1770;
                            break if !(_e1782);
                        }
                    }
                    let _e1785 = phi_3932_;
                    if _e1785 {
                        break;
                    }
                    let _e1787 = local_11;
                    let _e1790 = local_12;
                    if _e147 {
                    } else {
                        break;
                    }
                    global_6.member[_e145][0u] = _e1787.member_1;
                    global_6.member[_e145][1u] = _e1790.member_2;
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
