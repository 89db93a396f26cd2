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
    member: array<f32, 9>,
    member_1: u32,
}

struct type_18 {
    member: array<type_16>,
}

struct type_24 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_25 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_28 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_35 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_37 {
    member: array<type_25>,
}

struct type_39 {
    member: f32,
    member_1: bool,
}

struct type_41 {
    member: array<vec4<u32>, 2>,
}

struct type_45 {
    member: array<array<u32, 7>>,
}

struct type_50 {
    member: type_28,
    member_1: u32,
}

struct type_51 {
    member: array<vec4<f32>, 3>,
    member_1: type_50,
    member_2: type_50,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_11;
@group(0) @binding(3) 
var<storage> global_2: type_18;
@group(0) @binding(1) 
var<uniform> global_3: type_41;
@group(0) @binding(4) 
var<storage> global_4: type_37;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(2) 
var<storage> global_6: type_45;

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
    var phi_400_: i32;
    var phi_401_: i32;
    var phi_411_: bool;
    var phi_421_: u32;
    var phi_422_: u32;
    var phi_424_: bool;
    var phi_429_: u32;
    var phi_442_: i32;
    var phi_462_: i32;
    var phi_480_: f32;
    var phi_486_: f32;
    var phi_526_: f32;
    var phi_532_: f32;
    var phi_605_: f32;
    var phi_611_: f32;
    var phi_651_: f32;
    var phi_657_: f32;
    var phi_730_: f32;
    var phi_736_: f32;
    var phi_776_: f32;
    var phi_782_: f32;
    var phi_901_: i32;
    var phi_923_: u32;
    var phi_924_: u32;
    var phi_961_: i32;
    var phi_983_: u32;
    var phi_984_: u32;
    var phi_992_: f32;
    var phi_993_: f32;
    var phi_3752_: bool;
    var phi_1089_: type_39;
    var phi_1092_: bool;
    var phi_1094_: type_50;
    var phi_1096_: u32;
    var phi_1098_: u32;
    var phi_1109_: bool;
    var phi_1195_: bool;
    var phi_1196_: type_50;
    var phi_1197_: u32;
    var phi_2860_: u32;
    var phi_2861_: u32;
    var phi_2871_: u32;
    var phi_2873_: u32;
    var phi_2874_: bool;
    var phi_2894_: u32;
    var phi_2895_: u32;
    var phi_2899_: type_51;
    var phi_3261_: type_50;
    var phi_3337_: type_50;
    var phi_3338_: type_50;
    var phi_3339_: u32;
    var phi_3341_: type_50;
    var phi_3342_: u32;
    var phi_3343_: bool;
    var phi_3352_: type_50;
    var phi_3357_: bool;
    var phi_3358_: type_50;
    var phi_1215_: type_39;
    var phi_1218_: type_7;
    var phi_1219_: type_7;
    var phi_1241_: type_7;
    var phi_1262_: u32;
    var phi_1354_: array<array<f32, 3>, 3>;
    var phi_1884_: f32;
    var phi_1885_: f32;
    var phi_1886_: f32;
    var phi_1887_: f32;
    var phi_1888_: vec3<f32>;
    var phi_1889_: vec3<f32>;
    var phi_1890_: vec3<f32>;
    var phi_1891_: vec3<f32>;
    var phi_2082_: f32;
    var phi_2102_: type_35;
    var phi_2103_: type_35;
    var phi_2106_: type_35;
    var phi_2107_: type_35;
    var phi_2108_: bool;
    var phi_2112_: type_35;
    var phi_2121_: type_24;
    var phi_2132_: type_39;
    var phi_2133_: type_39;
    var phi_1216_: type_39;
    var phi_3746_: bool;
    var local_10: type_39;
    var phi_3900_: bool;
    var phi_3360_: type_39;
    var phi_3361_: bool;
    var phi_3362_: type_50;
    var phi_3363_: u32;
    var phi_3899_: bool;
    var phi_3364_: type_39;
    var phi_3365_: bool;
    var phi_3366_: type_50;
    var phi_3367_: u32;
    var phi_3368_: u32;
    var phi_3898_: bool;
    var phi_3369_: type_39;
    var phi_3370_: bool;
    var phi_3371_: type_50;
    var phi_3372_: u32;
    var phi_3373_: u32;
    var phi_3897_: bool;
    var phi_1090_: type_39;
    var phi_1093_: bool;
    var phi_1095_: type_50;
    var phi_1097_: u32;
    var phi_1099_: u32;
    var phi_3374_: bool;
    var phi_3896_: bool;
    var local_11: type_39;
    var local_12: type_39;

    switch bitcast<i32>(0u) {
        default: {
            let _e87 = global;
            let _e89 = arrayLength((&global_6.member));
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
            let _e146 = (_e145 < arrayLength((&global_4.member)));
            if _e146 {
                let _e147 = (_e145 < arrayLength((&global_5.member)));
                if _e147 {
                    if _e146 {
                    } else {
                        break;
                    }
                    let _e155 = global_4.member[_e145].member_2[0u];
                    let _e157 = (bitcast<u32>(_e155) & 2147483647u);
                    let _e162 = global_4.member[_e145].member_2[1u];
                    let _e164 = (bitcast<u32>(_e162) & 2147483647u);
                    let _e169 = global_4.member[_e145].member_2[2u];
                    let _e171 = (bitcast<u32>(_e169) & 2147483647u);
                    let _e176 = global_4.member[_e145].member[0u];
                    let _e178 = (bitcast<u32>(_e176) & 2147483647u);
                    let _e183 = global_4.member[_e145].member[1u];
                    let _e185 = (bitcast<u32>(_e183) & 2147483647u);
                    let _e190 = global_4.member[_e145].member[2u];
                    let _e192 = (bitcast<u32>(_e190) & 2147483647u);
                    let _e194 = select(_e164, _e157, (_e164 < _e157));
                    let _e196 = select(_e171, _e194, (_e171 < _e194));
                    let _e198 = select(_e178, _e196, (_e178 < _e196));
                    let _e200 = select(_e185, _e198, (_e185 < _e198));
                    let _e202 = select(_e192, _e200, (_e192 < _e200));
                    let _e206 = global_4.member[_e145].member_1;
                    let _e207 = bitcast<u32>(_e206);
                    let _e208 = (_e207 & 2147483647u);
                    let _e215 = global_4.member[_e145].member_3;
                    let _e216 = bitcast<u32>(_e215);
                    let _e217 = (_e216 & 2147483647u);
                    let _e221 = (((select(_e208, _e202, (_e208 < _e202)) < 2139095040u) && (_e217 <= 2139095040u)) && (_e196 > 0u));
                    if _e221 {
                        let _e224 = (bitcast<u32>(bitcast<f32>(_e196)) & 2147483647u);
                        if (_e224 >= 8388608u) {
                            phi_400_ = (bitcast<i32>((_e224 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_400_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e224)), 32u, (_e224 == 0u))));
                        }
                        let _e238 = phi_400_;
                        phi_401_ = _e238;
                    } else {
                        phi_401_ = 0i;
                    }
                    let _e240 = phi_401_;
                    let _e241 = (_e157 == _e196);
                    if _e241 {
                        phi_411_ = true;
                    } else {
                        phi_411_ = (_e164 == _e196);
                    }
                    let _e244 = phi_411_;
                    let _e245 = select(1u, 0u, _e241);
                    if _e244 {
                        let _e246 = (_e245 + 1u);
                        phi_421_ = _e246;
                        phi_422_ = _e246;
                        phi_424_ = select(true, false, (_e246 == 2u));
                    } else {
                        phi_421_ = u32();
                        phi_422_ = 0u;
                        phi_424_ = true;
                    }
                    let _e250 = phi_421_;
                    let _e252 = phi_422_;
                    let _e254 = phi_424_;
                    if _e254 {
                        phi_429_ = (_e252 + 1u);
                    } else {
                        phi_429_ = 0u;
                    }
                    let _e258 = phi_429_;
                    let _e259 = select(_e250, _e252, _e254);
                    let _e260 = select(_e245, select(2u, _e245, _e244), _e254);
                    if (_e127 < -126i) {
                        phi_442_ = -126i;
                    } else {
                        phi_442_ = select(_e127, 127i, (_e127 > 127i));
                    }
                    let _e265 = phi_442_;
                    let _e270 = bitcast<f32>((bitcast<u32>((_e265 + 127i)) << bitcast<u32>(23i)));
                    let _e276 = bitcast<f32>((bitcast<u32>(((_e127 - _e265) + 127i)) << bitcast<u32>(23i)));
                    let _e277 = -(_e240);
                    if (_e277 < -126i) {
                        phi_462_ = -126i;
                    } else {
                        phi_462_ = select(_e277, 127i, (_e277 > 127i));
                    }
                    let _e282 = phi_462_;
                    let _e287 = bitcast<f32>((bitcast<u32>((_e282 + 127i)) << bitcast<u32>(23i)));
                    let _e293 = bitcast<f32>((bitcast<u32>(((_e277 - _e282) + 127i)) << bitcast<u32>(23i)));
                    let _e297 = global_4.member[_e145].member;
                    let _e298 = (_e259 == 0u);
                    if _e298 {
                        phi_480_ = _e297[0];
                    } else {
                        phi_480_ = _e297[1];
                    }
                    let _e302 = phi_480_;
                    let _e303 = (_e259 == 2u);
                    if _e303 {
                        phi_486_ = _e297[2];
                    } else {
                        phi_486_ = _e302;
                    }
                    let _e306 = phi_486_;
                    let _e307 = bitcast<u32>(_e306);
                    let _e309 = ((_e307 & 2139095040u) != 0u);
                    let _e323 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e307 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e307 & 2147483648u))), _e306, _e309) * _e270) * select(0.00000011920929f, 1f, _e309)) * _e276);
                    let _e324 = global_4.member[_e145].member_2;
                    if _e298 {
                        phi_526_ = _e324[0];
                    } else {
                        phi_526_ = _e324[1];
                    }
                    let _e328 = phi_526_;
                    if _e303 {
                        phi_532_ = _e324[2];
                    } else {
                        phi_532_ = _e328;
                    }
                    let _e331 = phi_532_;
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
                        phi_605_ = _e297[0];
                    } else {
                        phi_605_ = _e297[1];
                    }
                    let _e369 = phi_605_;
                    let _e370 = (_e258 == 2u);
                    if _e370 {
                        phi_611_ = _e297[2];
                    } else {
                        phi_611_ = _e369;
                    }
                    let _e373 = phi_611_;
                    let _e374 = bitcast<u32>(_e373);
                    let _e376 = ((_e374 & 2139095040u) != 0u);
                    let _e390 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e374 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e374 & 2147483648u))), _e373, _e376) * _e270) * select(0.00000011920929f, 1f, _e376)) * _e276);
                    if _e365 {
                        phi_651_ = _e324[0];
                    } else {
                        phi_651_ = _e324[1];
                    }
                    let _e394 = phi_651_;
                    if _e370 {
                        phi_657_ = _e324[2];
                    } else {
                        phi_657_ = _e394;
                    }
                    let _e397 = phi_657_;
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
                        phi_730_ = _e297[0];
                    } else {
                        phi_730_ = _e297[1];
                    }
                    let _e435 = phi_730_;
                    let _e436 = (_e260 == 2u);
                    if _e436 {
                        phi_736_ = _e297[2];
                    } else {
                        phi_736_ = _e435;
                    }
                    let _e439 = phi_736_;
                    let _e440 = bitcast<u32>(_e439);
                    let _e442 = ((_e440 & 2139095040u) != 0u);
                    let _e456 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e440 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e440 & 2147483648u))), _e439, _e442) * _e270) * select(0.00000011920929f, 1f, _e442)) * _e276);
                    if _e431 {
                        phi_776_ = _e324[0];
                    } else {
                        phi_776_ = _e324[1];
                    }
                    let _e460 = phi_776_;
                    if _e436 {
                        phi_782_ = _e324[2];
                    } else {
                        phi_782_ = _e460;
                    }
                    let _e463 = phi_782_;
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
                            phi_901_ = 255i;
                        } else {
                            phi_901_ = (((_e514 + select(0i, 1i, (_e514 == 0i))) - _e521) + _e501);
                        }
                        let _e529 = phi_901_;
                        let _e539 = (_e529 <= 0i);
                        if _e539 {
                            phi_924_ = u32();
                        } else {
                            if _e518 {
                                phi_923_ = u32();
                            } else {
                                phi_923_ = select(((bitcast<u32>(_e529) << bitcast<u32>(23i)) | ((_e511 << bitcast<u32>(((_e521 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e529 >= 255i));
                            }
                            let _e543 = phi_923_;
                            phi_924_ = _e543;
                        }
                        let _e545 = phi_924_;
                        let _e557 = ((_e217 & 8388607u) | (select(0u, 1u, ((_e217 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e560 = bitcast<i32>((_e217 >> bitcast<u32>(23i)));
                        let _e564 = (_e557 == 0u);
                        let _e567 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e557)), 32u, _e564)) - 8i);
                        if (_e560 == 255i) {
                            phi_961_ = 255i;
                        } else {
                            phi_961_ = (((_e560 + select(0i, 1i, (_e560 == 0i))) - _e567) + _e501);
                        }
                        let _e575 = phi_961_;
                        let _e585 = (_e575 <= 0i);
                        if _e585 {
                            phi_984_ = u32();
                        } else {
                            if _e564 {
                                phi_983_ = u32();
                            } else {
                                phi_983_ = select(((bitcast<u32>(_e575) << bitcast<u32>(23i)) | ((_e557 << bitcast<u32>(((_e567 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e575 >= 255i));
                            }
                            let _e589 = phi_983_;
                            phi_984_ = _e589;
                        }
                        let _e591 = phi_984_;
                        phi_992_ = bitcast<f32>(((_e216 & 2147483648u) | select(_e591, 0u, select(_e564, true, _e585))));
                        phi_993_ = bitcast<f32>(((_e207 & 2147483648u) | select(_e545, 0u, select(_e518, true, _e539))));
                    } else {
                        phi_992_ = 0f;
                        phi_993_ = 1f;
                    }
                    let _e597 = phi_992_;
                    let _e599 = phi_993_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e605 = (_e259 % 3u);
                    let _e606 = (_e605 < 3u);
                    if _e606 {
                    } else {
                        break;
                    }
                    let _e608 = local_1[_e605];
                    let _e611 = (_e258 % 3u);
                    let _e612 = (_e611 < 3u);
                    if _e612 {
                    } else {
                        break;
                    }
                    let _e614 = local_1[_e611];
                    let _e617 = (_e260 % 3u);
                    let _e618 = (_e617 < 3u);
                    if _e618 {
                    } else {
                        break;
                    }
                    let _e620 = local_1[_e617];
                    if _e606 {
                    } else {
                        break;
                    }
                    let _e625 = local[_e605];
                    if _e612 {
                    } else {
                        break;
                    }
                    let _e629 = local[_e611];
                    if _e618 {
                    } else {
                        break;
                    }
                    let _e633 = local[_e617];
                    phi_3752_ = false;
                    phi_1089_ = type_39(_e597, false);
                    phi_1092_ = (_e599 <= _e597);
                    phi_1094_ = type_50(type_28(vec4<f32>((f32(_e608) * _e139), (f32(_e614) * _e139), (f32(_e620) * _e139), 0f), vec4<f32>((f32(_e625) * _e139), (f32(_e629) * _e139), (f32(_e633) * _e139), 0f)), select(0u, 2147483648u, (_e89 == 0u)));
                    phi_1096_ = 0u;
                    phi_1098_ = ((3u * _e89) + 1u);
                    loop {
                        let _e641 = phi_3752_;
                        let _e643 = phi_1089_;
                        let _e645 = phi_1092_;
                        let _e647 = phi_1094_;
                        let _e649 = phi_1096_;
                        let _e651 = phi_1098_;
                        local_11 = _e643;
                        if _e645 {
                            phi_1109_ = true;
                        } else {
                            phi_1109_ = (_e649 > 0u);
                        }
                        let _e654 = phi_1109_;
                        if _e654 {
                            let _e655 = (_e651 > 0u);
                            if _e655 {
                                if _e645 {
                                    phi_1195_ = _e645;
                                    phi_1196_ = _e647;
                                    phi_1197_ = _e649;
                                } else {
                                    let _e656 = (_e649 - 1u);
                                    let _e657 = (_e656 % 128u);
                                    let _e658 = (_e657 < 128u);
                                    if _e658 {
                                    } else {
                                        phi_3896_ = true;
                                        break;
                                    }
                                    let _e660 = local_7[_e657];
                                    if _e658 {
                                    } else {
                                        phi_3896_ = true;
                                        break;
                                    }
                                    let _e662 = local_6[_e657];
                                    if _e658 {
                                    } else {
                                        phi_3896_ = true;
                                        break;
                                    }
                                    let _e664 = local_5[_e657];
                                    if _e658 {
                                    } else {
                                        phi_3896_ = true;
                                        break;
                                    }
                                    let _e666 = local_4[_e657];
                                    if _e658 {
                                    } else {
                                        phi_3896_ = true;
                                        break;
                                    }
                                    let _e668 = local_3[_e657];
                                    if _e658 {
                                    } else {
                                        phi_3896_ = true;
                                        break;
                                    }
                                    let _e670 = local_2[_e657];
                                    if _e658 {
                                    } else {
                                        phi_3896_ = true;
                                        break;
                                    }
                                    let _e675 = local_8[_e657];
                                    if _e658 {
                                    } else {
                                        phi_3896_ = true;
                                        break;
                                    }
                                    let _e678 = local_9[_e657];
                                    phi_1195_ = (_e678 <= _e643.member);
                                    phi_1196_ = type_50(type_28(vec4<f32>(_e660, _e662, _e664, 0f), vec4<f32>(_e666, _e668, _e670, 0f)), _e675);
                                    phi_1197_ = _e656;
                                }
                                let _e682 = phi_1195_;
                                let _e684 = phi_1196_;
                                let _e686 = phi_1197_;
                                if _e682 {
                                    if ((_e684.member_1 & 2147483648u) != 0u) {
                                        phi_1215_ = _e643;
                                        phi_1218_ = type_7(0u, ((_e684.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1153 = phi_1215_;
                                            let _e1155 = phi_1218_;
                                            local_10 = _e1153;
                                            local_12 = _e1153;
                                            if (_e1155.member < _e1155.member_1) {
                                                phi_1219_ = type_7((_e1155.member + 1u), _e1155.member_1);
                                                phi_1241_ = type_7(1u, _e1155.member);
                                            } else {
                                                phi_1219_ = _e1155;
                                                phi_1241_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e1168 = phi_1219_;
                                            let _e1170 = phi_1241_;
                                            let _e1174 = (bitcast<i32>(_e1170.member) != 0i);
                                            if _e1174 {
                                                let _e1175 = ((_e684.member_1 & 268435455u) + _e1170.member_1);
                                                let _e1176 = (_e1175 < _e91);
                                                if _e1176 {
                                                    if _e1176 {
                                                    } else {
                                                        phi_3746_ = true;
                                                        break;
                                                    }
                                                    let _e1180 = global_2.member[_e1175].member_1;
                                                    phi_1262_ = _e1180;
                                                } else {
                                                    phi_1262_ = 4294967295u;
                                                }
                                                let _e1182 = phi_1262_;
                                                if (_e1175 >= _e91) {
                                                    phi_1354_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1176 {
                                                    } else {
                                                        phi_3746_ = true;
                                                        break;
                                                    }
                                                    if (_e605 < 9u) {
                                                    } else {
                                                        phi_3746_ = true;
                                                        break;
                                                    }
                                                    let _e1189 = global_2.member[_e1175].member[_e605];
                                                    if (_e611 < 9u) {
                                                    } else {
                                                        phi_3746_ = true;
                                                        break;
                                                    }
                                                    let _e1195 = global_2.member[_e1175].member[_e611];
                                                    if (_e617 < 9u) {
                                                    } else {
                                                        phi_3746_ = true;
                                                        break;
                                                    }
                                                    let _e1201 = global_2.member[_e1175].member[_e617];
                                                    let _e1203 = (3u + _e605);
                                                    if (_e1203 < 9u) {
                                                    } else {
                                                        phi_3746_ = true;
                                                        break;
                                                    }
                                                    let _e1209 = global_2.member[_e1175].member[_e1203];
                                                    let _e1210 = (3u + _e611);
                                                    if (_e1210 < 9u) {
                                                    } else {
                                                        phi_3746_ = true;
                                                        break;
                                                    }
                                                    let _e1216 = global_2.member[_e1175].member[_e1210];
                                                    let _e1217 = (3u + _e617);
                                                    if (_e1217 < 9u) {
                                                    } else {
                                                        phi_3746_ = true;
                                                        break;
                                                    }
                                                    let _e1223 = global_2.member[_e1175].member[_e1217];
                                                    let _e1225 = (6u + _e605);
                                                    if (_e1225 < 9u) {
                                                    } else {
                                                        phi_3746_ = true;
                                                        break;
                                                    }
                                                    let _e1231 = global_2.member[_e1175].member[_e1225];
                                                    let _e1232 = (6u + _e611);
                                                    if (_e1232 < 9u) {
                                                    } else {
                                                        phi_3746_ = true;
                                                        break;
                                                    }
                                                    let _e1238 = global_2.member[_e1175].member[_e1232];
                                                    let _e1239 = (6u + _e617);
                                                    if (_e1239 < 9u) {
                                                    } else {
                                                        phi_3746_ = true;
                                                        break;
                                                    }
                                                    let _e1245 = global_2.member[_e1175].member[_e1239];
                                                    phi_1354_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1189, _e1195, _e1201), array<f32, 3>(_e1209, _e1216, _e1223), array<f32, 3>(_e1231, _e1238, _e1245));
                                                }
                                                let _e1249 = phi_1354_;
                                                let _e1265 = (_e1249[0][2] - _e456);
                                                let _e1268 = (((_e1249[0][0] - _e323) * _e492) - (_e1265 * _e360));
                                                let _e1271 = (((_e1249[0][1] - _e390) * _e492) - (_e1265 * _e426));
                                                let _e1274 = (_e1249[1][2] - _e456);
                                                let _e1277 = (((_e1249[1][0] - _e323) * _e492) - (_e1274 * _e360));
                                                let _e1280 = (((_e1249[1][1] - _e390) * _e492) - (_e1274 * _e426));
                                                let _e1283 = (_e1249[2][2] - _e456);
                                                let _e1286 = (((_e1249[2][0] - _e323) * _e492) - (_e1283 * _e360));
                                                let _e1289 = (((_e1249[2][1] - _e390) * _e492) - (_e1283 * _e426));
                                                let _e1290 = (_e1286 * _e1280);
                                                let _e1291 = (_e1289 * _e1277);
                                                let _e1292 = (_e1268 * _e1289);
                                                let _e1293 = (_e1271 * _e1286);
                                                let _e1294 = (_e1277 * _e1271);
                                                let _e1295 = (_e1280 * _e1268);
                                                let _e1300 = (((_e1290 >= _e1291) && (_e1292 >= _e1293)) && (_e1294 >= _e1295));
                                                let _e1306 = (_e1300 || (((_e1290 <= _e1291) && (_e1292 <= _e1293)) && (_e1294 <= _e1295)));
                                                if _e1306 {
                                                    let _e1308 = select(-1f, 1f, _e1300);
                                                    let _e1310 = ((_e1290 - _e1291) * _e1308);
                                                    let _e1312 = select(0f, _e1310, (_e1310 > 0f));
                                                    let _e1314 = ((_e1292 - _e1293) * _e1308);
                                                    let _e1316 = select(0f, _e1314, (_e1314 > 0f));
                                                    let _e1318 = ((_e1294 - _e1295) * _e1308);
                                                    let _e1320 = select(0f, _e1318, (_e1318 > 0f));
                                                    let _e1322 = ((_e1312 + _e1316) + _e1320);
                                                    let _e1324 = select(_e1249[1][0], _e1249[0][0], (_e1249[0][0] < _e1249[1][0]));
                                                    let _e1328 = select(_e1249[1][0], _e1249[0][0], (_e1249[0][0] > _e1249[1][0]));
                                                    let _e1332 = select(_e1249[1][1], _e1249[0][1], (_e1249[0][1] < _e1249[1][1]));
                                                    let _e1336 = select(_e1249[1][1], _e1249[0][1], (_e1249[0][1] > _e1249[1][1]));
                                                    let _e1340 = select(_e1249[1][2], _e1249[0][2], (_e1249[0][2] < _e1249[1][2]));
                                                    let _e1344 = select(_e1249[1][2], _e1249[0][2], (_e1249[0][2] > _e1249[1][2]));
                                                    let _e1349 = ((select(_e1249[2][0], _e1324, (_e1324 < _e1249[2][0])) - _e361) * _e364);
                                                    let _e1350 = ((select(_e1249[2][0], _e1328, (_e1328 > _e1249[2][0])) - _e362) * _e364);
                                                    let _e1353 = ((select(_e1249[2][1], _e1332, (_e1332 < _e1249[2][1])) - _e427) * _e430);
                                                    let _e1354 = ((select(_e1249[2][1], _e1336, (_e1336 > _e1249[2][1])) - _e428) * _e430);
                                                    let _e1357 = ((select(_e1249[2][2], _e1340, (_e1340 < _e1249[2][2])) - _e493) * _e496);
                                                    let _e1358 = ((select(_e1249[2][2], _e1344, (_e1344 > _e1249[2][2])) - _e494) * _e496);
                                                    let _e1360 = select(_e1358, _e1357, (_e1357 < _e1358));
                                                    let _e1362 = select(_e1358, _e1357, (_e1357 > _e1358));
                                                    let _e1364 = select(_e1350, _e1349, (_e1349 < _e1350));
                                                    let _e1366 = select(_e1354, _e1353, (_e1353 < _e1354));
                                                    let _e1368 = select(_e1366, _e1364, (_e1364 > _e1366));
                                                    let _e1370 = select(_e1360, _e1368, (_e1368 > _e1360));
                                                    let _e1372 = select(_e1350, _e1349, (_e1349 > _e1350));
                                                    let _e1374 = select(_e1354, _e1353, (_e1353 > _e1354));
                                                    let _e1376 = select(_e1374, _e1372, (_e1372 < _e1374));
                                                    let _e1378 = select(_e1362, _e1376, (_e1376 < _e1362));
                                                    let _e1379 = -(_e1360);
                                                    let _e1385 = select(_e599, _e1370, (_e1370 > _e599));
                                                    let _e1389 = select(_e1277, _e1268, (_e1268 < _e1277));
                                                    let _e1394 = select(_e1277, _e1268, (_e1268 > _e1277));
                                                    let _e1401 = select(_e1280, _e1271, (_e1271 < _e1280));
                                                    let _e1406 = select(_e1280, _e1271, (_e1271 > _e1280));
                                                    let _e1415 = (((((_e1306 && (_e1322 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1286, _e1389, (_e1389 < _e1286)) <= 0f) && (select(_e1286, _e1394, (_e1394 > _e1286)) >= 0f))) && ((select(_e1289, _e1401, (_e1401 < _e1289)) <= 0f) && (select(_e1289, _e1406, (_e1406 > _e1289)) >= 0f))) && (_e1385 <= (_e1378 + (select(_e1379, _e1362, (_e1362 > _e1379)) * 0.0000019073523f)))) && (_e1385 <= _e1153.member));
                                                    if _e1415 {
                                                        let _e1420 = (_e1249[1][0] - _e1249[0][0]);
                                                        let _e1421 = (_e1249[1][1] - _e1249[0][1]);
                                                        let _e1422 = (_e1249[1][2] - _e1249[0][2]);
                                                        let _e1423 = vec3<f32>(_e1420, _e1421, _e1422);
                                                        let _e1424 = (_e1249[2][0] - _e1249[1][0]);
                                                        let _e1425 = (_e1249[2][1] - _e1249[1][1]);
                                                        let _e1426 = (_e1249[2][2] - _e1249[1][2]);
                                                        let _e1427 = vec3<f32>(_e1424, _e1425, _e1426);
                                                        let _e1428 = (_e1249[0][0] - _e1249[2][0]);
                                                        let _e1429 = (_e1249[0][1] - _e1249[2][1]);
                                                        let _e1430 = (_e1249[0][2] - _e1249[2][2]);
                                                        let _e1431 = vec3<f32>(_e1428, _e1429, _e1430);
                                                        let _e1434 = bitcast<f32>((bitcast<u32>(_e1420) & 2147483647u));
                                                        let _e1437 = bitcast<f32>((bitcast<u32>(_e1421) & 2147483647u));
                                                        let _e1439 = select(_e1437, _e1434, (_e1434 > _e1437));
                                                        let _e1442 = bitcast<f32>((bitcast<u32>(_e1422) & 2147483647u));
                                                        let _e1444 = select(_e1442, _e1439, (_e1439 > _e1442));
                                                        let _e1447 = bitcast<f32>((bitcast<u32>(_e1424) & 2147483647u));
                                                        let _e1450 = bitcast<f32>((bitcast<u32>(_e1425) & 2147483647u));
                                                        let _e1452 = select(_e1450, _e1447, (_e1447 > _e1450));
                                                        let _e1455 = bitcast<f32>((bitcast<u32>(_e1426) & 2147483647u));
                                                        let _e1457 = select(_e1455, _e1452, (_e1452 > _e1455));
                                                        let _e1460 = bitcast<f32>((bitcast<u32>(_e1428) & 2147483647u));
                                                        let _e1463 = bitcast<f32>((bitcast<u32>(_e1429) & 2147483647u));
                                                        let _e1465 = select(_e1463, _e1460, (_e1460 > _e1463));
                                                        let _e1468 = bitcast<f32>((bitcast<u32>(_e1430) & 2147483647u));
                                                        let _e1470 = select(_e1468, _e1465, (_e1465 > _e1468));
                                                        let _e1472 = select(_e1457, _e1444, (_e1444 > _e1457));
                                                        let _e1474 = select(_e1470, _e1472, (_e1472 > _e1470));
                                                        if (_e1444 == _e1474) {
                                                            phi_1884_ = _e1280;
                                                            phi_1885_ = _e1277;
                                                            phi_1886_ = _e1271;
                                                            phi_1887_ = _e1268;
                                                            phi_1888_ = vec3<f32>(_e1249[0][0], _e1249[0][1], _e1249[0][2]);
                                                            phi_1889_ = _e1431;
                                                            phi_1890_ = _e1427;
                                                            phi_1891_ = _e1423;
                                                        } else {
                                                            let _e1476 = (_e1457 == _e1474);
                                                            let _e1481 = vec3(_e1476);
                                                            phi_1884_ = select(_e1271, _e1289, _e1476);
                                                            phi_1885_ = select(_e1268, _e1286, _e1476);
                                                            phi_1886_ = select(_e1289, _e1280, _e1476);
                                                            phi_1887_ = select(_e1286, _e1277, _e1476);
                                                            phi_1888_ = select(vec3<f32>(_e1249[2][0], _e1249[2][1], _e1249[2][2]), vec3<f32>(_e1249[1][0], _e1249[1][1], _e1249[1][2]), _e1481);
                                                            phi_1889_ = select(_e1427, _e1423, _e1481);
                                                            phi_1890_ = select(_e1423, _e1431, _e1481);
                                                            phi_1891_ = select(_e1431, _e1427, _e1481);
                                                        }
                                                        let _e1487 = phi_1884_;
                                                        let _e1489 = phi_1885_;
                                                        let _e1491 = phi_1886_;
                                                        let _e1493 = phi_1887_;
                                                        let _e1495 = phi_1888_;
                                                        let _e1497 = phi_1889_;
                                                        let _e1499 = phi_1890_;
                                                        let _e1501 = phi_1891_;
                                                        let _e1508 = ((_e1499.y * _e1497.z) - (_e1497.y * _e1499.z));
                                                        let _e1513 = ((_e1499.z * _e1497.x) - (_e1497.z * _e1499.x));
                                                        let _e1516 = ((_e1499.x * _e1497.y) - (_e1497.x * _e1499.y));
                                                        let _e1519 = ((_e1312 >= _e1316) && (_e1312 >= _e1320));
                                                        let _e1520 = (_e1316 >= _e1320);
                                                        let _e1534 = (((_e1508 * (select(select(_e1249[2][0], _e1249[1][0], _e1520), _e1249[0][0], _e1519) - _e323)) + (_e1513 * (select(select(_e1249[2][1], _e1249[1][1], _e1520), _e1249[0][1], _e1519) - _e390))) + (_e1516 * (select(select(_e1249[2][2], _e1249[1][2], _e1520), _e1249[0][2], _e1519) - _e456)));
                                                        let _e1539 = (((_e1508 * _e360) + (_e1513 * _e426)) + (_e1516 * _e492));
                                                        let _e1540 = (_e1489 - _e1493);
                                                        let _e1541 = (_e1487 - _e1491);
                                                        let _e1544 = ((_e1540 * _e1540) + (_e1541 * _e1541));
                                                        let _e1551 = (-(((_e1493 * _e1540) + (_e1491 * _e1541))) / select(0.000000000000000000000000000000000000011754944f, _e1544, (_e1544 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1553 = select(1f, _e1551, (_e1551 < 1f));
                                                        let _e1555 = select(0f, _e1553, (_e1553 > 0f));
                                                        let _e1564 = ((_e1495.x + (_e1501.x * _e1555)) - _e323);
                                                        let _e1567 = ((_e1495.y + (_e1501.y * _e1555)) - _e390);
                                                        let _e1570 = ((_e1495.z + (_e1501.z * _e1555)) - _e456);
                                                        let _e1573 = bitcast<f32>((bitcast<u32>(_e1564) & 2147483647u));
                                                        let _e1576 = bitcast<f32>((bitcast<u32>(_e1567) & 2147483647u));
                                                        let _e1578 = select(_e1576, _e1573, (_e1573 > _e1576));
                                                        let _e1581 = bitcast<f32>((bitcast<u32>(_e1570) & 2147483647u));
                                                        let _e1583 = select(_e1581, _e1578, (_e1578 > _e1581));
                                                        let _e1589 = bitcast<f32>((bitcast<u32>(_e1508) & 2147483647u));
                                                        let _e1592 = bitcast<f32>((bitcast<u32>(_e1513) & 2147483647u));
                                                        let _e1594 = select(_e1592, _e1589, (_e1589 > _e1592));
                                                        let _e1597 = bitcast<f32>((bitcast<u32>(_e1516) & 2147483647u));
                                                        let _e1616 = bitcast<f32>((bitcast<u32>(_e1499.x) & 2147483647u));
                                                        let _e1619 = bitcast<f32>((bitcast<u32>(_e1499.y) & 2147483647u));
                                                        let _e1621 = select(_e1619, _e1616, (_e1616 > _e1619));
                                                        let _e1624 = bitcast<f32>((bitcast<u32>(_e1499.z) & 2147483647u));
                                                        let _e1630 = bitcast<f32>((bitcast<u32>(_e1497.x) & 2147483647u));
                                                        let _e1633 = bitcast<f32>((bitcast<u32>(_e1497.y) & 2147483647u));
                                                        let _e1635 = select(_e1633, _e1630, (_e1630 > _e1633));
                                                        let _e1638 = bitcast<f32>((bitcast<u32>(_e1497.z) & 2147483647u));
                                                        let _e1644 = ((bitcast<f32>((bitcast<u32>(((((_e1508 * _e1564) + (_e1513 * _e1567)) + (_e1516 * _e1570)) - _e1534)) & 2147483647u)) <= ((0.0000009536743f * select(_e1474, _e1583, (_e1583 > _e1474))) * select(_e1597, _e1594, (_e1594 > _e1597)))) && !((bitcast<f32>((bitcast<u32>(_e1539) & 2147483647u)) <= ((0.0000038146973f * select(_e1624, _e1621, (_e1621 > _e1624))) * select(_e1638, _e1635, (_e1635 > _e1638))))));
                                                        let _e1645 = (_e1534 / _e1539);
                                                        if (_e1415 && !(_e1644)) {
                                                            let _e1648 = (_e1570 / _e492);
                                                            let _e1656 = (((_e1508 * (_e1564 - (_e360 * _e1648))) + (_e1513 * (_e1567 - (_e426 * _e1648)))) / _e1539);
                                                            phi_2082_ = select(select(_e1648, (_e1648 + _e1656), (bitcast<f32>((bitcast<u32>(_e1656) & 2147483647u)) <= _e1474)), _e1645, _e1644);
                                                        } else {
                                                            phi_2082_ = _e1645;
                                                        }
                                                        let _e1665 = phi_2082_;
                                                        let _e1667 = select(_e1378, _e1665, (_e1665 < _e1378));
                                                        let _e1669 = select(_e1370, _e1667, (_e1667 > _e1370));
                                                        let _e1670 = (1f / _e1322);
                                                        phi_2102_ = type_35(_e1669, (_e1316 * _e1670), (_e1320 * _e1670), ((_e1415 && (_e1669 >= _e599)) && (_e1669 <= _e1153.member)));
                                                        phi_2103_ = type_35();
                                                    } else {
                                                        phi_2102_ = type_35();
                                                        phi_2103_ = type_35(0f, 0f, 0f, _e1415);
                                                    }
                                                    let _e1679 = phi_2102_;
                                                    let _e1681 = phi_2103_;
                                                    phi_2106_ = _e1679;
                                                    phi_2107_ = _e1681;
                                                    phi_2108_ = select(true, false, _e1415);
                                                } else {
                                                    phi_2106_ = type_35();
                                                    phi_2107_ = type_35(0f, 0f, 0f, _e1306);
                                                    phi_2108_ = true;
                                                }
                                                let _e1684 = phi_2106_;
                                                let _e1686 = phi_2107_;
                                                let _e1688 = phi_2108_;
                                                if _e1688 {
                                                    phi_2112_ = _e1686;
                                                } else {
                                                    phi_2112_ = _e1684;
                                                }
                                                let _e1690 = phi_2112_;
                                                if _e1690.member_3 {
                                                    phi_2121_ = type_24(_e1690.member, _e1690.member_1, _e1690.member_2, _e1182);
                                                } else {
                                                    phi_2121_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1697 = phi_2121_;
                                                if (_e1697.member_3 != 4294967295u) {
                                                    if (_e1182 != 4294967295u) {
                                                        phi_2132_ = type_39(-340282350000000000000000000000000000000f, true);
                                                    } else {
                                                        phi_2132_ = _e1153;
                                                    }
                                                    let _e1702 = phi_2132_;
                                                    phi_2133_ = _e1702;
                                                } else {
                                                    phi_2133_ = _e1153;
                                                }
                                                let _e1704 = phi_2133_;
                                                phi_1216_ = _e1704;
                                            } else {
                                                phi_1216_ = type_39();
                                            }
                                            let _e1706 = phi_1216_;
                                            continue;
                                            continuing {
                                                phi_1215_ = _e1706;
                                                phi_1218_ = _e1168;
                                                phi_3746_ = _e641;
                                                break if !(_e1174);
                                            }
                                        }
                                        let _e1709 = phi_3746_;
                                        phi_3896_ = _e1709;
                                        if _e1709 {
                                            break;
                                        }
                                        let _e1711 = local_10;
                                        phi_3900_ = _e1709;
                                        let _e1859 = local_12;
                                        phi_3360_ = _e1859;
                                        phi_3361_ = false;
                                        phi_3362_ = _e684;
                                        phi_3363_ = select(_e686, 0u, (_e599 > _e1711.member));
                                    } else {
                                        if (_e684.member_1 >= _e89) {
                                            phi_2899_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_50(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_50(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e684.member_1 < _e89) {
                                            } else {
                                                phi_3896_ = true;
                                                break;
                                            }
                                            let _e697 = (_e259 * 2u);
                                            let _e699 = ((1u + _e697) % 7u);
                                            if (_e699 < 7u) {
                                            } else {
                                                phi_3896_ = true;
                                                break;
                                            }
                                            let _e704 = global_6.member[_e684.member_1][_e699];
                                            let _e706 = ((_e697 + 2u) % 7u);
                                            if (_e706 < 7u) {
                                            } else {
                                                phi_3896_ = true;
                                                break;
                                            }
                                            let _e711 = global_6.member[_e684.member_1][_e706];
                                            let _e712 = (_e258 * 2u);
                                            let _e714 = ((1u + _e712) % 7u);
                                            if (_e714 < 7u) {
                                            } else {
                                                phi_3896_ = true;
                                                break;
                                            }
                                            let _e719 = global_6.member[_e684.member_1][_e714];
                                            let _e721 = ((_e712 + 2u) % 7u);
                                            if (_e721 < 7u) {
                                            } else {
                                                phi_3896_ = true;
                                                break;
                                            }
                                            let _e726 = global_6.member[_e684.member_1][_e721];
                                            let _e727 = (_e260 * 2u);
                                            let _e729 = ((1u + _e727) % 7u);
                                            if (_e729 < 7u) {
                                            } else {
                                                phi_3896_ = true;
                                                break;
                                            }
                                            let _e734 = global_6.member[_e684.member_1][_e729];
                                            let _e736 = ((_e727 + 2u) % 7u);
                                            if (_e736 < 7u) {
                                            } else {
                                                phi_3896_ = true;
                                                break;
                                            }
                                            let _e741 = global_6.member[_e684.member_1][_e736];
                                            let _e764 = (bitcast<f32>((bitcast<u32>((_e684.member.member_1.x - _e684.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e765 = (bitcast<f32>((bitcast<u32>((_e684.member.member_1.y - _e684.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e766 = (bitcast<f32>((bitcast<u32>((_e684.member.member_1.z - _e684.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e768 = select(_e139, _e764, (_e764 > _e139));
                                            let _e770 = select(_e139, _e765, (_e765 > _e139));
                                            let _e772 = select(_e139, _e766, (_e766 > _e139));
                                            let _e803 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e704 & 2097151u))) - 8388608f) * _e768));
                                            let _e808 = (bitcast<i32>((_e704 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e811 = bitcast<f32>((_e803 & bitcast<u32>(_e808)));
                                            let _e812 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e719 & 2097151u))) - 8388608f) * _e770));
                                            let _e817 = (bitcast<i32>((_e719 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e820 = bitcast<f32>((_e812 & bitcast<u32>(_e817)));
                                            let _e821 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e734 & 2097151u))) - 8388608f) * _e772));
                                            let _e826 = (bitcast<i32>((_e734 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e829 = bitcast<f32>((_e821 & bitcast<u32>(_e826)));
                                            let _e833 = bitcast<f32>((_e803 & bitcast<u32>(~(_e808))));
                                            let _e837 = bitcast<f32>((_e812 & bitcast<u32>(~(_e817))));
                                            let _e841 = bitcast<f32>((_e821 & bitcast<u32>(~(_e826))));
                                            let _e842 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e711 & 2097151u))) - 8388608f) * _e768));
                                            let _e847 = (bitcast<i32>((_e711 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e850 = bitcast<f32>((_e842 & bitcast<u32>(_e847)));
                                            let _e851 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e726 & 2097151u))) - 8388608f) * _e770));
                                            let _e856 = (bitcast<i32>((_e726 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e859 = bitcast<f32>((_e851 & bitcast<u32>(_e856)));
                                            let _e860 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e741 & 2097151u))) - 8388608f) * _e772));
                                            let _e865 = (bitcast<i32>((_e741 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e868 = bitcast<f32>((_e860 & bitcast<u32>(_e865)));
                                            let _e872 = bitcast<f32>((_e842 & bitcast<u32>(~(_e847))));
                                            let _e876 = bitcast<f32>((_e851 & bitcast<u32>(~(_e856))));
                                            let _e880 = bitcast<f32>((_e860 & bitcast<u32>(~(_e865))));
                                            let _e910 = global_6.member[_e684.member_1][0u];
                                            let _e914 = global_6.member[_e684.member_1][2u];
                                            let _e918 = global_6.member[_e684.member_1][4u];
                                            let _e922 = global_6.member[_e684.member_1][6u];
                                            let _e934 = (((_e914 >> bitcast<u32>(22i)) | ((_e918 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e922 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e935 = (_e910 & 268435455u);
                                            let _e936 = (_e934 & 268435455u);
                                            let _e939 = ((_e910 >> bitcast<u32>(28u)) & 7u);
                                            let _e947 = ((_e910 >> bitcast<u32>(31i)) | (((_e934 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e948 = (_e939 != 0u);
                                            if (_e939 == 0u) {
                                                phi_2861_ = _e935;
                                            } else {
                                                if (_e939 == 7u) {
                                                    phi_2860_ = 2147483648u;
                                                } else {
                                                    phi_2860_ = ((2147483648u | (_e939 << bitcast<u32>(28u))) | (_e936 & 268435455u));
                                                }
                                                let _e957 = phi_2860_;
                                                phi_2861_ = _e957;
                                            }
                                            let _e959 = phi_2861_;
                                            if _e948 {
                                                let _e960 = (_e939 != 7u);
                                                if _e960 {
                                                    phi_2871_ = (_e936 + _e939);
                                                } else {
                                                    phi_2871_ = u32();
                                                }
                                                let _e963 = phi_2871_;
                                                phi_2873_ = _e963;
                                                phi_2874_ = select(true, false, _e960);
                                            } else {
                                                phi_2873_ = u32();
                                                phi_2874_ = true;
                                            }
                                            let _e966 = phi_2873_;
                                            let _e968 = phi_2874_;
                                            if (_e947 == 0u) {
                                                phi_2895_ = (_e935 + select(0u, 1u, !(_e948)));
                                            } else {
                                                if (_e947 == 7u) {
                                                    phi_2894_ = 2147483648u;
                                                } else {
                                                    phi_2894_ = ((2147483648u | (_e947 << bitcast<u32>(28u))) | (select(_e966, _e936, _e968) & 268435455u));
                                                }
                                                let _e981 = phi_2894_;
                                                phi_2895_ = _e981;
                                            }
                                            let _e983 = phi_2895_;
                                            phi_2899_ = type_51(array<vec4<f32>, 3>(vec4<f32>((_e684.member.member.x + _e811), (_e684.member.member.x + _e833), (_e684.member.member_1.x - _e850), (_e684.member.member_1.x - _e872)), vec4<f32>((_e684.member.member.y + _e820), (_e684.member.member.y + _e837), (_e684.member.member_1.y - _e859), (_e684.member.member_1.y - _e876)), vec4<f32>((_e684.member.member.z + _e829), (_e684.member.member.z + _e841), (_e684.member.member_1.z - _e868), (_e684.member.member_1.z - _e880))), type_50(type_28((_e684.member.member + vec4<f32>(_e811, _e820, _e829, 0f)), (_e684.member.member_1 - vec4<f32>(_e850, _e859, _e868, 0f))), _e959), type_50(type_28((_e684.member.member + vec4<f32>(_e833, _e837, _e841, 0f)), (_e684.member.member_1 - vec4<f32>(_e872, _e876, _e880, 0f))), _e983));
                                        }
                                        let _e988 = phi_2899_;
                                        let _e1000 = ((_e988.member[0].x - _e361) * _e364);
                                        let _e1001 = ((_e988.member[0].y - _e361) * _e364);
                                        let _e1002 = ((_e988.member[0].z - _e362) * _e364);
                                        let _e1003 = ((_e988.member[0].w - _e362) * _e364);
                                        let _e1013 = ((_e988.member[1].x - _e427) * _e430);
                                        let _e1014 = ((_e988.member[1].y - _e427) * _e430);
                                        let _e1015 = ((_e988.member[1].z - _e428) * _e430);
                                        let _e1016 = ((_e988.member[1].w - _e428) * _e430);
                                        let _e1026 = ((_e988.member[2].x - _e493) * _e496);
                                        let _e1027 = ((_e988.member[2].y - _e493) * _e496);
                                        let _e1028 = ((_e988.member[2].z - _e494) * _e496);
                                        let _e1029 = ((_e988.member[2].w - _e494) * _e496);
                                        let _e1031 = select(_e1028, _e1026, (_e1026 < _e1028));
                                        let _e1033 = select(_e1029, _e1027, (_e1027 < _e1029));
                                        let _e1035 = select(_e1028, _e1026, (_e1026 > _e1028));
                                        let _e1037 = select(_e1029, _e1027, (_e1027 > _e1029));
                                        let _e1039 = select(_e1002, _e1000, (_e1000 < _e1002));
                                        let _e1041 = select(_e1003, _e1001, (_e1001 < _e1003));
                                        let _e1043 = select(_e1015, _e1013, (_e1013 < _e1015));
                                        let _e1045 = select(_e1016, _e1014, (_e1014 < _e1016));
                                        let _e1047 = select(_e1043, _e1039, (_e1039 > _e1043));
                                        let _e1049 = select(_e1045, _e1041, (_e1041 > _e1045));
                                        let _e1051 = select(_e1031, _e1047, (_e1047 > _e1031));
                                        let _e1053 = select(_e1033, _e1049, (_e1049 > _e1033));
                                        let _e1055 = select(_e1002, _e1000, (_e1000 > _e1002));
                                        let _e1057 = select(_e1003, _e1001, (_e1001 > _e1003));
                                        let _e1059 = select(_e1015, _e1013, (_e1013 > _e1015));
                                        let _e1061 = select(_e1016, _e1014, (_e1014 > _e1016));
                                        let _e1063 = select(_e1059, _e1055, (_e1055 < _e1059));
                                        let _e1065 = select(_e1061, _e1057, (_e1057 < _e1061));
                                        let _e1070 = -(_e1031);
                                        let _e1071 = -(_e1033);
                                        let _e1078 = (select(_e1035, _e1063, (_e1063 < _e1035)) + (select(_e1070, _e1035, (_e1035 > _e1070)) * 0.0000019073523f));
                                        let _e1079 = (select(_e1037, _e1065, (_e1065 < _e1037)) + (select(_e1071, _e1037, (_e1037 > _e1071)) * 0.0000019073523f));
                                        let _e1081 = select(_e599, _e1051, (_e1051 > _e599));
                                        let _e1083 = select(_e599, _e1053, (_e1053 > _e599));
                                        let _e1088 = (_e1081 <= select(_e643.member, _e1078, (_e1078 < _e643.member)));
                                        let _e1089 = (_e1083 <= select(_e643.member, _e1079, (_e1079 < _e643.member)));
                                        let _e1090 = (_e1081 <= _e1083);
                                        if _e1088 {
                                            if _e1089 {
                                                if _e1090 {
                                                    phi_3261_ = _e988.member_2;
                                                } else {
                                                    phi_3261_ = _e988.member_1;
                                                }
                                                let _e1094 = phi_3261_;
                                                let _e1115 = (_e686 % 128u);
                                                let _e1116 = (_e1115 < 128u);
                                                if _e1116 {
                                                } else {
                                                    phi_3896_ = true;
                                                    break;
                                                }
                                                local_8[_e1115] = _e1094.member_1;
                                                if _e1116 {
                                                } else {
                                                    phi_3896_ = true;
                                                    break;
                                                }
                                                local_7[_e1115] = _e1094.member.member.x;
                                                if _e1116 {
                                                } else {
                                                    phi_3896_ = true;
                                                    break;
                                                }
                                                local_6[_e1115] = _e1094.member.member.y;
                                                if _e1116 {
                                                } else {
                                                    phi_3896_ = true;
                                                    break;
                                                }
                                                local_5[_e1115] = _e1094.member.member.z;
                                                if _e1116 {
                                                } else {
                                                    phi_3896_ = true;
                                                    break;
                                                }
                                                local_4[_e1115] = _e1094.member.member_1.x;
                                                if _e1116 {
                                                } else {
                                                    phi_3896_ = true;
                                                    break;
                                                }
                                                local_3[_e1115] = _e1094.member.member_1.y;
                                                if _e1116 {
                                                } else {
                                                    phi_3896_ = true;
                                                    break;
                                                }
                                                local_2[_e1115] = _e1094.member.member_1.z;
                                                if _e1116 {
                                                } else {
                                                    phi_3896_ = true;
                                                    break;
                                                }
                                                local_9[_e1115] = select(_e1081, _e1083, _e1090);
                                                if _e1090 {
                                                    phi_3337_ = _e988.member_1;
                                                } else {
                                                    phi_3337_ = _e988.member_2;
                                                }
                                                let _e1129 = phi_3337_;
                                                phi_3338_ = _e1129;
                                                phi_3339_ = (_e686 + 1u);
                                            } else {
                                                phi_3338_ = type_50();
                                                phi_3339_ = u32();
                                            }
                                            let _e1131 = phi_3338_;
                                            let _e1133 = phi_3339_;
                                            phi_3341_ = _e1131;
                                            phi_3342_ = _e1133;
                                            phi_3343_ = select(true, false, _e1089);
                                        } else {
                                            phi_3341_ = type_50();
                                            phi_3342_ = u32();
                                            phi_3343_ = true;
                                        }
                                        let _e1136 = phi_3341_;
                                        let _e1138 = phi_3342_;
                                        let _e1140 = phi_3343_;
                                        if _e1140 {
                                            if _e1088 {
                                                phi_3352_ = _e988.member_1;
                                            } else {
                                                phi_3352_ = _e988.member_2;
                                            }
                                            let _e1144 = phi_3352_;
                                            phi_3357_ = select(_e1089, true, _e1088);
                                            phi_3358_ = _e1144;
                                        } else {
                                            phi_3357_ = _e682;
                                            phi_3358_ = _e1136;
                                        }
                                        let _e1147 = phi_3357_;
                                        let _e1149 = phi_3358_;
                                        phi_3900_ = _e641;
                                        phi_3360_ = _e643;
                                        phi_3361_ = _e1147;
                                        phi_3362_ = _e1149;
                                        phi_3363_ = select(_e1138, _e686, _e1140);
                                    }
                                    let _e1716 = phi_3900_;
                                    let _e1718 = phi_3360_;
                                    let _e1720 = phi_3361_;
                                    let _e1722 = phi_3362_;
                                    let _e1724 = phi_3363_;
                                    phi_3899_ = _e1716;
                                    phi_3364_ = _e1718;
                                    phi_3365_ = _e1720;
                                    phi_3366_ = _e1722;
                                    phi_3367_ = _e1724;
                                    phi_3368_ = (_e651 - 1u);
                                } else {
                                    phi_3899_ = _e641;
                                    phi_3364_ = _e643;
                                    phi_3365_ = _e682;
                                    phi_3366_ = _e684;
                                    phi_3367_ = _e686;
                                    phi_3368_ = _e651;
                                }
                                let _e1726 = phi_3899_;
                                let _e1728 = phi_3364_;
                                let _e1730 = phi_3365_;
                                let _e1732 = phi_3366_;
                                let _e1734 = phi_3367_;
                                let _e1736 = phi_3368_;
                                phi_3898_ = _e1726;
                                phi_3369_ = _e1728;
                                phi_3370_ = _e1730;
                                phi_3371_ = _e1732;
                                phi_3372_ = _e1734;
                                phi_3373_ = _e1736;
                            } else {
                                phi_3898_ = _e641;
                                phi_3369_ = type_39();
                                phi_3370_ = bool();
                                phi_3371_ = type_50();
                                phi_3372_ = u32();
                                phi_3373_ = u32();
                            }
                            let _e1738 = phi_3898_;
                            let _e1740 = phi_3369_;
                            let _e1742 = phi_3370_;
                            let _e1744 = phi_3371_;
                            let _e1746 = phi_3372_;
                            let _e1748 = phi_3373_;
                            phi_3897_ = _e1738;
                            phi_1090_ = _e1740;
                            phi_1093_ = _e1742;
                            phi_1095_ = _e1744;
                            phi_1097_ = _e1746;
                            phi_1099_ = _e1748;
                            phi_3374_ = _e655;
                        } else {
                            phi_3897_ = _e641;
                            phi_1090_ = type_39();
                            phi_1093_ = bool();
                            phi_1095_ = type_50();
                            phi_1097_ = u32();
                            phi_1099_ = u32();
                            phi_3374_ = false;
                        }
                        let _e1750 = phi_3897_;
                        let _e1752 = phi_1090_;
                        let _e1754 = phi_1093_;
                        let _e1756 = phi_1095_;
                        let _e1758 = phi_1097_;
                        let _e1760 = phi_1099_;
                        let _e1762 = phi_3374_;
                        continue;
                        continuing {
                            phi_3752_ = _e1750;
                            phi_1089_ = _e1752;
                            phi_1092_ = _e1754;
                            phi_1094_ = _e1756;
                            phi_1096_ = _e1758;
                            phi_1098_ = _e1760;
                            phi_3896_ = _e1750;
                            break if !(_e1762);
                        }
                    }
                    let _e1765 = phi_3896_;
                    if _e1765 {
                        break;
                    }
                    let _e1767 = local_11;
                    if _e147 {
                    } else {
                        break;
                    }
                    global_5.member[_e145] = select(0u, 1u, _e1767.member_1);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_any_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
