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
    var phi_393_: i32;
    var phi_394_: i32;
    var phi_404_: bool;
    var phi_414_: u32;
    var phi_415_: u32;
    var phi_417_: bool;
    var phi_422_: u32;
    var phi_435_: i32;
    var phi_455_: i32;
    var phi_473_: f32;
    var phi_479_: f32;
    var phi_519_: f32;
    var phi_525_: f32;
    var phi_598_: f32;
    var phi_604_: f32;
    var phi_644_: f32;
    var phi_650_: f32;
    var phi_723_: f32;
    var phi_729_: f32;
    var phi_769_: f32;
    var phi_775_: f32;
    var phi_894_: i32;
    var phi_916_: u32;
    var phi_917_: u32;
    var phi_954_: i32;
    var phi_976_: u32;
    var phi_977_: u32;
    var phi_985_: f32;
    var phi_986_: f32;
    var phi_3824_: bool;
    var phi_1082_: type_39;
    var phi_1085_: u32;
    var phi_1087_: bool;
    var phi_1089_: u32;
    var phi_1091_: type_50;
    var phi_1102_: bool;
    var phi_1188_: bool;
    var phi_1189_: u32;
    var phi_1190_: type_50;
    var phi_1208_: type_39;
    var phi_1211_: type_7;
    var phi_1212_: type_7;
    var phi_1234_: type_7;
    var phi_1255_: u32;
    var phi_1347_: array<array<f32, 3>, 3>;
    var phi_3459_: bool;
    var phi_3474_: bool;
    var phi_3489_: bool;
    var phi_3504_: bool;
    var phi_3519_: bool;
    var phi_3534_: bool;
    var phi_1889_: f32;
    var phi_1890_: f32;
    var phi_1891_: f32;
    var phi_1892_: f32;
    var phi_1893_: vec3<f32>;
    var phi_1894_: vec3<f32>;
    var phi_1895_: vec3<f32>;
    var phi_1896_: vec3<f32>;
    var phi_3549_: bool;
    var phi_3564_: bool;
    var phi_3579_: bool;
    var phi_3594_: bool;
    var phi_3609_: bool;
    var phi_3624_: bool;
    var phi_2104_: f32;
    var phi_2124_: type_35;
    var phi_2125_: type_35;
    var phi_2128_: type_35;
    var phi_2129_: type_35;
    var phi_2130_: bool;
    var phi_2134_: type_35;
    var phi_2143_: type_24;
    var phi_2154_: type_39;
    var phi_2155_: type_39;
    var phi_1209_: type_39;
    var phi_3818_: bool;
    var phi_4066_: bool;
    var phi_2156_: type_39;
    var phi_2883_: u32;
    var phi_2884_: u32;
    var phi_2894_: u32;
    var phi_2896_: u32;
    var phi_2897_: bool;
    var phi_2917_: u32;
    var phi_2918_: u32;
    var phi_2922_: type_51;
    var phi_3284_: type_50;
    var phi_3360_: type_50;
    var phi_3361_: u32;
    var phi_3362_: type_50;
    var phi_3364_: u32;
    var phi_3365_: type_50;
    var phi_3366_: bool;
    var phi_3375_: type_50;
    var phi_3380_: bool;
    var phi_3382_: type_50;
    var phi_3386_: bool;
    var phi_3387_: u32;
    var phi_3388_: type_50;
    var phi_3398_: u32;
    var phi_3399_: type_50;
    var phi_3983_: bool;
    var phi_3400_: type_39;
    var phi_3401_: u32;
    var phi_3402_: bool;
    var phi_3403_: u32;
    var phi_3404_: type_50;
    var phi_3982_: bool;
    var phi_3405_: type_39;
    var phi_3406_: u32;
    var phi_3407_: bool;
    var phi_3408_: u32;
    var phi_3409_: type_50;
    var phi_3981_: bool;
    var phi_1083_: type_39;
    var phi_1086_: u32;
    var phi_1088_: bool;
    var phi_1090_: u32;
    var phi_1092_: type_50;
    var phi_3410_: bool;
    var phi_3980_: bool;
    var local_10: type_39;
    var local_11: type_39;

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
                            phi_393_ = (bitcast<i32>((_e224 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_393_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e224)), 32u, (_e224 == 0u))));
                        }
                        let _e238 = phi_393_;
                        phi_394_ = _e238;
                    } else {
                        phi_394_ = 0i;
                    }
                    let _e240 = phi_394_;
                    let _e241 = (_e157 == _e196);
                    if _e241 {
                        phi_404_ = true;
                    } else {
                        phi_404_ = (_e164 == _e196);
                    }
                    let _e244 = phi_404_;
                    let _e245 = select(1u, 0u, _e241);
                    if _e244 {
                        let _e246 = (_e245 + 1u);
                        phi_414_ = _e246;
                        phi_415_ = _e246;
                        phi_417_ = select(true, false, (_e246 == 2u));
                    } else {
                        phi_414_ = u32();
                        phi_415_ = 0u;
                        phi_417_ = true;
                    }
                    let _e250 = phi_414_;
                    let _e252 = phi_415_;
                    let _e254 = phi_417_;
                    if _e254 {
                        phi_422_ = (_e252 + 1u);
                    } else {
                        phi_422_ = 0u;
                    }
                    let _e258 = phi_422_;
                    let _e259 = select(_e250, _e252, _e254);
                    let _e260 = select(_e245, select(2u, _e245, _e244), _e254);
                    if (_e127 < -126i) {
                        phi_435_ = -126i;
                    } else {
                        phi_435_ = select(_e127, 127i, (_e127 > 127i));
                    }
                    let _e265 = phi_435_;
                    let _e270 = bitcast<f32>((bitcast<u32>((_e265 + 127i)) << bitcast<u32>(23i)));
                    let _e276 = bitcast<f32>((bitcast<u32>(((_e127 - _e265) + 127i)) << bitcast<u32>(23i)));
                    let _e277 = -(_e240);
                    if (_e277 < -126i) {
                        phi_455_ = -126i;
                    } else {
                        phi_455_ = select(_e277, 127i, (_e277 > 127i));
                    }
                    let _e282 = phi_455_;
                    let _e287 = bitcast<f32>((bitcast<u32>((_e282 + 127i)) << bitcast<u32>(23i)));
                    let _e293 = bitcast<f32>((bitcast<u32>(((_e277 - _e282) + 127i)) << bitcast<u32>(23i)));
                    let _e297 = global_4.member[_e145].member;
                    let _e298 = (_e259 == 0u);
                    if _e298 {
                        phi_473_ = _e297[0];
                    } else {
                        phi_473_ = _e297[1];
                    }
                    let _e302 = phi_473_;
                    let _e303 = (_e259 == 2u);
                    if _e303 {
                        phi_479_ = _e297[2];
                    } else {
                        phi_479_ = _e302;
                    }
                    let _e306 = phi_479_;
                    let _e307 = bitcast<u32>(_e306);
                    let _e309 = ((_e307 & 2139095040u) != 0u);
                    let _e323 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e307 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e307 & 2147483648u))), _e306, _e309) * _e270) * select(0.00000011920929f, 1f, _e309)) * _e276);
                    let _e324 = global_4.member[_e145].member_2;
                    if _e298 {
                        phi_519_ = _e324[0];
                    } else {
                        phi_519_ = _e324[1];
                    }
                    let _e328 = phi_519_;
                    if _e303 {
                        phi_525_ = _e324[2];
                    } else {
                        phi_525_ = _e328;
                    }
                    let _e331 = phi_525_;
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
                        phi_598_ = _e297[0];
                    } else {
                        phi_598_ = _e297[1];
                    }
                    let _e369 = phi_598_;
                    let _e370 = (_e258 == 2u);
                    if _e370 {
                        phi_604_ = _e297[2];
                    } else {
                        phi_604_ = _e369;
                    }
                    let _e373 = phi_604_;
                    let _e374 = bitcast<u32>(_e373);
                    let _e376 = ((_e374 & 2139095040u) != 0u);
                    let _e390 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e374 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e374 & 2147483648u))), _e373, _e376) * _e270) * select(0.00000011920929f, 1f, _e376)) * _e276);
                    if _e365 {
                        phi_644_ = _e324[0];
                    } else {
                        phi_644_ = _e324[1];
                    }
                    let _e394 = phi_644_;
                    if _e370 {
                        phi_650_ = _e324[2];
                    } else {
                        phi_650_ = _e394;
                    }
                    let _e397 = phi_650_;
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
                        phi_723_ = _e297[0];
                    } else {
                        phi_723_ = _e297[1];
                    }
                    let _e435 = phi_723_;
                    let _e436 = (_e260 == 2u);
                    if _e436 {
                        phi_729_ = _e297[2];
                    } else {
                        phi_729_ = _e435;
                    }
                    let _e439 = phi_729_;
                    let _e440 = bitcast<u32>(_e439);
                    let _e442 = ((_e440 & 2139095040u) != 0u);
                    let _e456 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e440 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e440 & 2147483648u))), _e439, _e442) * _e270) * select(0.00000011920929f, 1f, _e442)) * _e276);
                    if _e431 {
                        phi_769_ = _e324[0];
                    } else {
                        phi_769_ = _e324[1];
                    }
                    let _e460 = phi_769_;
                    if _e436 {
                        phi_775_ = _e324[2];
                    } else {
                        phi_775_ = _e460;
                    }
                    let _e463 = phi_775_;
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
                            phi_894_ = 255i;
                        } else {
                            phi_894_ = (((_e514 + select(0i, 1i, (_e514 == 0i))) - _e521) + _e501);
                        }
                        let _e529 = phi_894_;
                        let _e539 = (_e529 <= 0i);
                        if _e539 {
                            phi_917_ = u32();
                        } else {
                            if _e518 {
                                phi_916_ = u32();
                            } else {
                                phi_916_ = select(((bitcast<u32>(_e529) << bitcast<u32>(23i)) | ((_e511 << bitcast<u32>(((_e521 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e529 >= 255i));
                            }
                            let _e543 = phi_916_;
                            phi_917_ = _e543;
                        }
                        let _e545 = phi_917_;
                        let _e557 = ((_e217 & 8388607u) | (select(0u, 1u, ((_e217 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e560 = bitcast<i32>((_e217 >> bitcast<u32>(23i)));
                        let _e564 = (_e557 == 0u);
                        let _e567 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e557)), 32u, _e564)) - 8i);
                        if (_e560 == 255i) {
                            phi_954_ = 255i;
                        } else {
                            phi_954_ = (((_e560 + select(0i, 1i, (_e560 == 0i))) - _e567) + _e501);
                        }
                        let _e575 = phi_954_;
                        let _e585 = (_e575 <= 0i);
                        if _e585 {
                            phi_977_ = u32();
                        } else {
                            if _e564 {
                                phi_976_ = u32();
                            } else {
                                phi_976_ = select(((bitcast<u32>(_e575) << bitcast<u32>(23i)) | ((_e557 << bitcast<u32>(((_e567 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e575 >= 255i));
                            }
                            let _e589 = phi_976_;
                            phi_977_ = _e589;
                        }
                        let _e591 = phi_977_;
                        phi_985_ = bitcast<f32>(((_e216 & 2147483648u) | select(_e591, 0u, select(_e564, true, _e585))));
                        phi_986_ = bitcast<f32>(((_e207 & 2147483648u) | select(_e545, 0u, select(_e518, true, _e539))));
                    } else {
                        phi_985_ = 0f;
                        phi_986_ = 1f;
                    }
                    let _e597 = phi_985_;
                    let _e599 = phi_986_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e603 = (_e259 % 3u);
                    let _e604 = (_e603 < 3u);
                    if _e604 {
                    } else {
                        break;
                    }
                    let _e606 = local_1[_e603];
                    let _e609 = (_e258 % 3u);
                    let _e610 = (_e609 < 3u);
                    if _e610 {
                    } else {
                        break;
                    }
                    let _e612 = local_1[_e609];
                    let _e615 = (_e260 % 3u);
                    let _e616 = (_e615 < 3u);
                    if _e616 {
                    } else {
                        break;
                    }
                    let _e618 = local_1[_e615];
                    if _e604 {
                    } else {
                        break;
                    }
                    let _e623 = local[_e603];
                    if _e610 {
                    } else {
                        break;
                    }
                    let _e627 = local[_e609];
                    if _e616 {
                    } else {
                        break;
                    }
                    let _e631 = local[_e615];
                    phi_3824_ = false;
                    phi_1082_ = type_39(_e597, false);
                    phi_1085_ = ((3u * _e89) + 1u);
                    phi_1087_ = (_e599 <= _e597);
                    phi_1089_ = 0u;
                    phi_1091_ = type_50(type_28(vec4<f32>((f32(_e606) * _e139), (f32(_e612) * _e139), (f32(_e618) * _e139), 0f), vec4<f32>((f32(_e623) * _e139), (f32(_e627) * _e139), (f32(_e631) * _e139), 0f)), select(0u, 2147483648u, (_e89 == 0u)));
                    loop {
                        let _e641 = phi_3824_;
                        let _e643 = phi_1082_;
                        let _e645 = phi_1085_;
                        let _e647 = phi_1087_;
                        let _e649 = phi_1089_;
                        let _e651 = phi_1091_;
                        local_10 = _e643;
                        if _e647 {
                            phi_1102_ = true;
                        } else {
                            phi_1102_ = (_e649 > 0u);
                        }
                        let _e654 = phi_1102_;
                        if _e654 {
                            let _e655 = (_e645 > 0u);
                            if _e655 {
                                if _e647 {
                                    phi_1188_ = _e647;
                                    phi_1189_ = _e649;
                                    phi_1190_ = _e651;
                                } else {
                                    let _e656 = (_e649 - 1u);
                                    let _e657 = (_e656 % 128u);
                                    let _e658 = (_e657 < 128u);
                                    if _e658 {
                                    } else {
                                        phi_3980_ = true;
                                        break;
                                    }
                                    let _e660 = local_7[_e657];
                                    if _e658 {
                                    } else {
                                        phi_3980_ = true;
                                        break;
                                    }
                                    let _e662 = local_6[_e657];
                                    if _e658 {
                                    } else {
                                        phi_3980_ = true;
                                        break;
                                    }
                                    let _e664 = local_5[_e657];
                                    if _e658 {
                                    } else {
                                        phi_3980_ = true;
                                        break;
                                    }
                                    let _e666 = local_4[_e657];
                                    if _e658 {
                                    } else {
                                        phi_3980_ = true;
                                        break;
                                    }
                                    let _e668 = local_3[_e657];
                                    if _e658 {
                                    } else {
                                        phi_3980_ = true;
                                        break;
                                    }
                                    let _e670 = local_2[_e657];
                                    if _e658 {
                                    } else {
                                        phi_3980_ = true;
                                        break;
                                    }
                                    let _e675 = local_8[_e657];
                                    if _e658 {
                                    } else {
                                        phi_3980_ = true;
                                        break;
                                    }
                                    let _e678 = local_9[_e657];
                                    phi_1188_ = (_e678 <= _e643.member);
                                    phi_1189_ = _e656;
                                    phi_1190_ = type_50(type_28(vec4<f32>(_e660, _e662, _e664, 0f), vec4<f32>(_e666, _e668, _e670, 0f)), _e675);
                                }
                                let _e682 = phi_1188_;
                                let _e684 = phi_1189_;
                                let _e686 = phi_1190_;
                                if _e682 {
                                    let _e690 = ((_e686.member_1 & 2147483648u) != 0u);
                                    if _e690 {
                                        phi_1208_ = _e643;
                                        phi_1211_ = type_7(0u, ((_e686.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e697 = phi_1208_;
                                            let _e699 = phi_1211_;
                                            local_11 = _e697;
                                            if (_e699.member < _e699.member_1) {
                                                phi_1212_ = type_7((_e699.member + 1u), _e699.member_1);
                                                phi_1234_ = type_7(1u, _e699.member);
                                            } else {
                                                phi_1212_ = _e699;
                                                phi_1234_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e712 = phi_1212_;
                                            let _e714 = phi_1234_;
                                            let _e718 = (bitcast<i32>(_e714.member) != 0i);
                                            if _e718 {
                                                let _e719 = ((_e686.member_1 & 268435455u) + _e714.member_1);
                                                let _e720 = (_e719 < _e91);
                                                if _e720 {
                                                    if _e720 {
                                                    } else {
                                                        phi_3818_ = true;
                                                        break;
                                                    }
                                                    let _e724 = global_2.member[_e719].member_1;
                                                    phi_1255_ = _e724;
                                                } else {
                                                    phi_1255_ = 4294967295u;
                                                }
                                                let _e726 = phi_1255_;
                                                if (_e719 >= _e91) {
                                                    phi_1347_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e720 {
                                                    } else {
                                                        phi_3818_ = true;
                                                        break;
                                                    }
                                                    if (_e603 < 9u) {
                                                    } else {
                                                        phi_3818_ = true;
                                                        break;
                                                    }
                                                    let _e733 = global_2.member[_e719].member[_e603];
                                                    if (_e609 < 9u) {
                                                    } else {
                                                        phi_3818_ = true;
                                                        break;
                                                    }
                                                    let _e739 = global_2.member[_e719].member[_e609];
                                                    if (_e615 < 9u) {
                                                    } else {
                                                        phi_3818_ = true;
                                                        break;
                                                    }
                                                    let _e745 = global_2.member[_e719].member[_e615];
                                                    let _e747 = (3u + _e603);
                                                    if (_e747 < 9u) {
                                                    } else {
                                                        phi_3818_ = true;
                                                        break;
                                                    }
                                                    let _e753 = global_2.member[_e719].member[_e747];
                                                    let _e754 = (3u + _e609);
                                                    if (_e754 < 9u) {
                                                    } else {
                                                        phi_3818_ = true;
                                                        break;
                                                    }
                                                    let _e760 = global_2.member[_e719].member[_e754];
                                                    let _e761 = (3u + _e615);
                                                    if (_e761 < 9u) {
                                                    } else {
                                                        phi_3818_ = true;
                                                        break;
                                                    }
                                                    let _e767 = global_2.member[_e719].member[_e761];
                                                    let _e769 = (6u + _e603);
                                                    if (_e769 < 9u) {
                                                    } else {
                                                        phi_3818_ = true;
                                                        break;
                                                    }
                                                    let _e775 = global_2.member[_e719].member[_e769];
                                                    let _e776 = (6u + _e609);
                                                    if (_e776 < 9u) {
                                                    } else {
                                                        phi_3818_ = true;
                                                        break;
                                                    }
                                                    let _e782 = global_2.member[_e719].member[_e776];
                                                    let _e783 = (6u + _e615);
                                                    if (_e783 < 9u) {
                                                    } else {
                                                        phi_3818_ = true;
                                                        break;
                                                    }
                                                    let _e789 = global_2.member[_e719].member[_e783];
                                                    phi_1347_ = array<array<f32, 3>, 3>(array<f32, 3>(_e733, _e739, _e745), array<f32, 3>(_e753, _e760, _e767), array<f32, 3>(_e775, _e782, _e789));
                                                }
                                                let _e793 = phi_1347_;
                                                let _e809 = (_e793[0][2] - _e456);
                                                let _e812 = (((_e793[0][0] - _e323) * _e492) - (_e809 * _e360));
                                                let _e815 = (((_e793[0][1] - _e390) * _e492) - (_e809 * _e426));
                                                let _e818 = (_e793[1][2] - _e456);
                                                let _e821 = (((_e793[1][0] - _e323) * _e492) - (_e818 * _e360));
                                                let _e824 = (((_e793[1][1] - _e390) * _e492) - (_e818 * _e426));
                                                let _e827 = (_e793[2][2] - _e456);
                                                let _e830 = (((_e793[2][0] - _e323) * _e492) - (_e827 * _e360));
                                                let _e833 = (((_e793[2][1] - _e390) * _e492) - (_e827 * _e426));
                                                let _e834 = (_e830 * _e824);
                                                let _e835 = (_e833 * _e821);
                                                let _e836 = (_e812 * _e833);
                                                let _e837 = (_e815 * _e830);
                                                let _e838 = (_e821 * _e815);
                                                let _e839 = (_e824 * _e812);
                                                let _e844 = (((_e834 >= _e835) && (_e836 >= _e837)) && (_e838 >= _e839));
                                                let _e850 = (_e844 || (((_e834 <= _e835) && (_e836 <= _e837)) && (_e838 <= _e839)));
                                                if _e850 {
                                                    let _e852 = select(-1f, 1f, _e844);
                                                    let _e854 = ((_e834 - _e835) * _e852);
                                                    let _e856 = select(0f, _e854, (_e854 > 0f));
                                                    let _e858 = ((_e836 - _e837) * _e852);
                                                    let _e860 = select(0f, _e858, (_e858 > 0f));
                                                    let _e862 = ((_e838 - _e839) * _e852);
                                                    let _e864 = select(0f, _e862, (_e862 > 0f));
                                                    let _e866 = ((_e856 + _e860) + _e864);
                                                    let _e868 = select(_e793[1][0], _e793[0][0], (_e793[0][0] < _e793[1][0]));
                                                    let _e872 = select(_e793[1][0], _e793[0][0], (_e793[0][0] > _e793[1][0]));
                                                    let _e876 = select(_e793[1][1], _e793[0][1], (_e793[0][1] < _e793[1][1]));
                                                    let _e880 = select(_e793[1][1], _e793[0][1], (_e793[0][1] > _e793[1][1]));
                                                    let _e884 = select(_e793[1][2], _e793[0][2], (_e793[0][2] < _e793[1][2]));
                                                    let _e888 = select(_e793[1][2], _e793[0][2], (_e793[0][2] > _e793[1][2]));
                                                    let _e893 = ((select(_e793[2][0], _e868, (_e868 < _e793[2][0])) - _e361) * _e364);
                                                    let _e894 = ((select(_e793[2][0], _e872, (_e872 > _e793[2][0])) - _e362) * _e364);
                                                    let _e897 = ((select(_e793[2][1], _e876, (_e876 < _e793[2][1])) - _e427) * _e430);
                                                    let _e898 = ((select(_e793[2][1], _e880, (_e880 > _e793[2][1])) - _e428) * _e430);
                                                    let _e901 = ((select(_e793[2][2], _e884, (_e884 < _e793[2][2])) - _e493) * _e496);
                                                    let _e902 = ((select(_e793[2][2], _e888, (_e888 > _e793[2][2])) - _e494) * _e496);
                                                    let _e904 = select(_e902, _e901, (_e901 < _e902));
                                                    let _e906 = select(_e902, _e901, (_e901 > _e902));
                                                    let _e908 = select(_e894, _e893, (_e893 < _e894));
                                                    let _e910 = select(_e898, _e897, (_e897 < _e898));
                                                    let _e912 = select(_e910, _e908, (_e908 > _e910));
                                                    let _e914 = select(_e904, _e912, (_e912 > _e904));
                                                    let _e916 = select(_e894, _e893, (_e893 > _e894));
                                                    let _e918 = select(_e898, _e897, (_e897 > _e898));
                                                    let _e920 = select(_e918, _e916, (_e916 < _e918));
                                                    let _e922 = select(_e906, _e920, (_e920 < _e906));
                                                    let _e923 = -(_e904);
                                                    let _e929 = select(_e599, _e914, (_e914 > _e599));
                                                    let _e933 = select(_e821, _e812, (_e812 < _e821));
                                                    let _e938 = select(_e821, _e812, (_e812 > _e821));
                                                    let _e945 = select(_e824, _e815, (_e815 < _e824));
                                                    let _e950 = select(_e824, _e815, (_e815 > _e824));
                                                    let _e959 = (((((_e850 && (_e866 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e830, _e933, (_e933 < _e830)) <= 0f) && (select(_e830, _e938, (_e938 > _e830)) >= 0f))) && ((select(_e833, _e945, (_e945 < _e833)) <= 0f) && (select(_e833, _e950, (_e950 > _e833)) >= 0f))) && (_e929 <= (_e922 + (select(_e923, _e906, (_e906 > _e923)) * 0.0000019073523f)))) && (_e929 <= _e697.member));
                                                    if _e959 {
                                                        let _e964 = (_e793[1][0] - _e793[0][0]);
                                                        let _e965 = (_e793[1][1] - _e793[0][1]);
                                                        let _e966 = (_e793[1][2] - _e793[0][2]);
                                                        let _e967 = vec3<f32>(_e964, _e965, _e966);
                                                        let _e968 = (_e793[2][0] - _e793[1][0]);
                                                        let _e969 = (_e793[2][1] - _e793[1][1]);
                                                        let _e970 = (_e793[2][2] - _e793[1][2]);
                                                        let _e971 = vec3<f32>(_e968, _e969, _e970);
                                                        let _e972 = (_e793[0][0] - _e793[2][0]);
                                                        let _e973 = (_e793[0][1] - _e793[2][1]);
                                                        let _e974 = (_e793[0][2] - _e793[2][2]);
                                                        let _e975 = vec3<f32>(_e972, _e973, _e974);
                                                        let _e976 = abs(_e964);
                                                        let _e977 = abs(_e965);
                                                        if (_e976 != _e976) {
                                                            phi_3459_ = true;
                                                        } else {
                                                            phi_3459_ = (_e977 >= _e976);
                                                        }
                                                        let _e981 = phi_3459_;
                                                        let _e982 = select(_e976, _e977, _e981);
                                                        let _e983 = abs(_e966);
                                                        if (_e982 != _e982) {
                                                            phi_3474_ = true;
                                                        } else {
                                                            phi_3474_ = (_e983 >= _e982);
                                                        }
                                                        let _e987 = phi_3474_;
                                                        let _e988 = select(_e982, _e983, _e987);
                                                        let _e989 = abs(_e968);
                                                        let _e990 = abs(_e969);
                                                        if (_e989 != _e989) {
                                                            phi_3489_ = true;
                                                        } else {
                                                            phi_3489_ = (_e990 >= _e989);
                                                        }
                                                        let _e994 = phi_3489_;
                                                        let _e995 = select(_e989, _e990, _e994);
                                                        let _e996 = abs(_e970);
                                                        if (_e995 != _e995) {
                                                            phi_3504_ = true;
                                                        } else {
                                                            phi_3504_ = (_e996 >= _e995);
                                                        }
                                                        let _e1000 = phi_3504_;
                                                        let _e1001 = select(_e995, _e996, _e1000);
                                                        let _e1002 = abs(_e972);
                                                        let _e1003 = abs(_e973);
                                                        if (_e1002 != _e1002) {
                                                            phi_3519_ = true;
                                                        } else {
                                                            phi_3519_ = (_e1003 >= _e1002);
                                                        }
                                                        let _e1007 = phi_3519_;
                                                        let _e1008 = select(_e1002, _e1003, _e1007);
                                                        let _e1009 = abs(_e974);
                                                        if (_e1008 != _e1008) {
                                                            phi_3534_ = true;
                                                        } else {
                                                            phi_3534_ = (_e1009 >= _e1008);
                                                        }
                                                        let _e1013 = phi_3534_;
                                                        let _e1014 = select(_e1008, _e1009, _e1013);
                                                        let _e1016 = select(_e1001, _e988, (_e988 > _e1001));
                                                        let _e1018 = select(_e1014, _e1016, (_e1016 > _e1014));
                                                        if (_e988 == _e1018) {
                                                            phi_1889_ = _e824;
                                                            phi_1890_ = _e821;
                                                            phi_1891_ = _e815;
                                                            phi_1892_ = _e812;
                                                            phi_1893_ = vec3<f32>(_e793[0][0], _e793[0][1], _e793[0][2]);
                                                            phi_1894_ = _e975;
                                                            phi_1895_ = _e971;
                                                            phi_1896_ = _e967;
                                                        } else {
                                                            let _e1020 = (_e1001 == _e1018);
                                                            let _e1025 = vec3(_e1020);
                                                            phi_1889_ = select(_e815, _e833, _e1020);
                                                            phi_1890_ = select(_e812, _e830, _e1020);
                                                            phi_1891_ = select(_e833, _e824, _e1020);
                                                            phi_1892_ = select(_e830, _e821, _e1020);
                                                            phi_1893_ = select(vec3<f32>(_e793[2][0], _e793[2][1], _e793[2][2]), vec3<f32>(_e793[1][0], _e793[1][1], _e793[1][2]), _e1025);
                                                            phi_1894_ = select(_e971, _e967, _e1025);
                                                            phi_1895_ = select(_e967, _e975, _e1025);
                                                            phi_1896_ = select(_e975, _e971, _e1025);
                                                        }
                                                        let _e1031 = phi_1889_;
                                                        let _e1033 = phi_1890_;
                                                        let _e1035 = phi_1891_;
                                                        let _e1037 = phi_1892_;
                                                        let _e1039 = phi_1893_;
                                                        let _e1041 = phi_1894_;
                                                        let _e1043 = phi_1895_;
                                                        let _e1045 = phi_1896_;
                                                        let _e1052 = ((_e1043.y * _e1041.z) - (_e1041.y * _e1043.z));
                                                        let _e1057 = ((_e1043.z * _e1041.x) - (_e1041.z * _e1043.x));
                                                        let _e1060 = ((_e1043.x * _e1041.y) - (_e1041.x * _e1043.y));
                                                        let _e1063 = ((_e856 >= _e860) && (_e856 >= _e864));
                                                        let _e1064 = (_e860 >= _e864);
                                                        let _e1078 = (((_e1052 * (select(select(_e793[2][0], _e793[1][0], _e1064), _e793[0][0], _e1063) - _e323)) + (_e1057 * (select(select(_e793[2][1], _e793[1][1], _e1064), _e793[0][1], _e1063) - _e390))) + (_e1060 * (select(select(_e793[2][2], _e793[1][2], _e1064), _e793[0][2], _e1063) - _e456)));
                                                        let _e1083 = (((_e1052 * _e360) + (_e1057 * _e426)) + (_e1060 * _e492));
                                                        let _e1084 = (_e1033 - _e1037);
                                                        let _e1085 = (_e1031 - _e1035);
                                                        let _e1088 = ((_e1084 * _e1084) + (_e1085 * _e1085));
                                                        let _e1095 = (-(((_e1037 * _e1084) + (_e1035 * _e1085))) / select(0.000000000000000000000000000000000000011754944f, _e1088, (_e1088 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1097 = select(1f, _e1095, (_e1095 < 1f));
                                                        let _e1099 = select(0f, _e1097, (_e1097 > 0f));
                                                        let _e1108 = ((_e1039.x + (_e1045.x * _e1099)) - _e323);
                                                        let _e1111 = ((_e1039.y + (_e1045.y * _e1099)) - _e390);
                                                        let _e1114 = ((_e1039.z + (_e1045.z * _e1099)) - _e456);
                                                        let _e1117 = bitcast<f32>((bitcast<u32>(_e1108) & 2147483647u));
                                                        let _e1120 = bitcast<f32>((bitcast<u32>(_e1111) & 2147483647u));
                                                        let _e1122 = select(_e1120, _e1117, (_e1117 > _e1120));
                                                        let _e1125 = bitcast<f32>((bitcast<u32>(_e1114) & 2147483647u));
                                                        let _e1127 = select(_e1125, _e1122, (_e1122 > _e1125));
                                                        let _e1131 = abs(_e1052);
                                                        let _e1132 = abs(_e1057);
                                                        if (_e1131 != _e1131) {
                                                            phi_3549_ = true;
                                                        } else {
                                                            phi_3549_ = (_e1132 >= _e1131);
                                                        }
                                                        let _e1136 = phi_3549_;
                                                        let _e1137 = select(_e1131, _e1132, _e1136);
                                                        let _e1138 = abs(_e1060);
                                                        if (_e1137 != _e1137) {
                                                            phi_3564_ = true;
                                                        } else {
                                                            phi_3564_ = (_e1138 >= _e1137);
                                                        }
                                                        let _e1142 = phi_3564_;
                                                        let _e1158 = abs(_e1043.x);
                                                        let _e1159 = abs(_e1043.y);
                                                        if (_e1158 != _e1158) {
                                                            phi_3579_ = true;
                                                        } else {
                                                            phi_3579_ = (_e1159 >= _e1158);
                                                        }
                                                        let _e1163 = phi_3579_;
                                                        let _e1164 = select(_e1158, _e1159, _e1163);
                                                        let _e1165 = abs(_e1043.z);
                                                        if (_e1164 != _e1164) {
                                                            phi_3594_ = true;
                                                        } else {
                                                            phi_3594_ = (_e1165 >= _e1164);
                                                        }
                                                        let _e1169 = phi_3594_;
                                                        let _e1172 = abs(_e1041.x);
                                                        let _e1173 = abs(_e1041.y);
                                                        if (_e1172 != _e1172) {
                                                            phi_3609_ = true;
                                                        } else {
                                                            phi_3609_ = (_e1173 >= _e1172);
                                                        }
                                                        let _e1177 = phi_3609_;
                                                        let _e1178 = select(_e1172, _e1173, _e1177);
                                                        let _e1179 = abs(_e1041.z);
                                                        if (_e1178 != _e1178) {
                                                            phi_3624_ = true;
                                                        } else {
                                                            phi_3624_ = (_e1179 >= _e1178);
                                                        }
                                                        let _e1183 = phi_3624_;
                                                        let _e1188 = ((bitcast<f32>((bitcast<u32>(((((_e1052 * _e1108) + (_e1057 * _e1111)) + (_e1060 * _e1114)) - _e1078)) & 2147483647u)) <= ((0.0000009536743f * select(_e1018, _e1127, (_e1127 > _e1018))) * select(_e1137, _e1138, _e1142))) && !((bitcast<f32>((bitcast<u32>(_e1083) & 2147483647u)) <= ((0.0000038146973f * select(_e1164, _e1165, _e1169)) * select(_e1178, _e1179, _e1183)))));
                                                        let _e1189 = (_e1078 / _e1083);
                                                        if (_e959 && !(_e1188)) {
                                                            let _e1192 = (_e1114 / _e492);
                                                            let _e1200 = (((_e1052 * (_e1108 - (_e360 * _e1192))) + (_e1057 * (_e1111 - (_e426 * _e1192)))) / _e1083);
                                                            phi_2104_ = select(select(_e1192, (_e1192 + _e1200), (bitcast<f32>((bitcast<u32>(_e1200) & 2147483647u)) <= _e1018)), _e1189, _e1188);
                                                        } else {
                                                            phi_2104_ = _e1189;
                                                        }
                                                        let _e1209 = phi_2104_;
                                                        let _e1211 = select(_e922, _e1209, (_e1209 < _e922));
                                                        let _e1213 = select(_e914, _e1211, (_e1211 > _e914));
                                                        let _e1214 = (1f / _e866);
                                                        phi_2124_ = type_35(_e1213, (_e860 * _e1214), (_e864 * _e1214), ((_e959 && (_e1213 >= _e599)) && (_e1213 <= _e697.member)));
                                                        phi_2125_ = type_35();
                                                    } else {
                                                        phi_2124_ = type_35();
                                                        phi_2125_ = type_35(0f, 0f, 0f, _e959);
                                                    }
                                                    let _e1223 = phi_2124_;
                                                    let _e1225 = phi_2125_;
                                                    phi_2128_ = _e1223;
                                                    phi_2129_ = _e1225;
                                                    phi_2130_ = select(true, false, _e959);
                                                } else {
                                                    phi_2128_ = type_35();
                                                    phi_2129_ = type_35(0f, 0f, 0f, _e850);
                                                    phi_2130_ = true;
                                                }
                                                let _e1228 = phi_2128_;
                                                let _e1230 = phi_2129_;
                                                let _e1232 = phi_2130_;
                                                if _e1232 {
                                                    phi_2134_ = _e1230;
                                                } else {
                                                    phi_2134_ = _e1228;
                                                }
                                                let _e1234 = phi_2134_;
                                                if _e1234.member_3 {
                                                    phi_2143_ = type_24(_e1234.member, _e1234.member_1, _e1234.member_2, _e726);
                                                } else {
                                                    phi_2143_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1241 = phi_2143_;
                                                if (_e1241.member_3 != 4294967295u) {
                                                    if (_e726 != 4294967295u) {
                                                        phi_2154_ = type_39(-340282350000000000000000000000000000000f, true);
                                                    } else {
                                                        phi_2154_ = _e697;
                                                    }
                                                    let _e1246 = phi_2154_;
                                                    phi_2155_ = _e1246;
                                                } else {
                                                    phi_2155_ = _e697;
                                                }
                                                let _e1248 = phi_2155_;
                                                phi_1209_ = _e1248;
                                            } else {
                                                phi_1209_ = type_39();
                                            }
                                            let _e1250 = phi_1209_;
                                            continue;
                                            continuing {
                                                phi_1208_ = _e1250;
                                                phi_1211_ = _e712;
                                                phi_3818_ = _e641;
                                                break if !(_e718);
                                            }
                                        }
                                        let _e1253 = phi_3818_;
                                        phi_3980_ = _e1253;
                                        if _e1253 {
                                            break;
                                        }
                                        phi_4066_ = _e1253;
                                        let _e1854 = local_11;
                                        phi_2156_ = _e1854;
                                    } else {
                                        phi_4066_ = _e641;
                                        phi_2156_ = _e643;
                                    }
                                    let _e1255 = phi_4066_;
                                    let _e1257 = phi_2156_;
                                    if _e690 {
                                        phi_3386_ = bool();
                                        phi_3387_ = u32();
                                        phi_3388_ = type_50();
                                    } else {
                                        if (_e686.member_1 >= _e89) {
                                            phi_2922_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_50(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_50(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e686.member_1 < _e89) {
                                            } else {
                                                phi_3980_ = true;
                                                break;
                                            }
                                            let _e1260 = (_e259 * 2u);
                                            let _e1262 = ((1u + _e1260) % 7u);
                                            if (_e1262 < 7u) {
                                            } else {
                                                phi_3980_ = true;
                                                break;
                                            }
                                            let _e1267 = global_6.member[_e686.member_1][_e1262];
                                            let _e1269 = ((_e1260 + 2u) % 7u);
                                            if (_e1269 < 7u) {
                                            } else {
                                                phi_3980_ = true;
                                                break;
                                            }
                                            let _e1274 = global_6.member[_e686.member_1][_e1269];
                                            let _e1275 = (_e258 * 2u);
                                            let _e1277 = ((1u + _e1275) % 7u);
                                            if (_e1277 < 7u) {
                                            } else {
                                                phi_3980_ = true;
                                                break;
                                            }
                                            let _e1282 = global_6.member[_e686.member_1][_e1277];
                                            let _e1284 = ((_e1275 + 2u) % 7u);
                                            if (_e1284 < 7u) {
                                            } else {
                                                phi_3980_ = true;
                                                break;
                                            }
                                            let _e1289 = global_6.member[_e686.member_1][_e1284];
                                            let _e1290 = (_e260 * 2u);
                                            let _e1292 = ((1u + _e1290) % 7u);
                                            if (_e1292 < 7u) {
                                            } else {
                                                phi_3980_ = true;
                                                break;
                                            }
                                            let _e1297 = global_6.member[_e686.member_1][_e1292];
                                            let _e1299 = ((_e1290 + 2u) % 7u);
                                            if (_e1299 < 7u) {
                                            } else {
                                                phi_3980_ = true;
                                                break;
                                            }
                                            let _e1304 = global_6.member[_e686.member_1][_e1299];
                                            let _e1327 = (bitcast<f32>((bitcast<u32>((_e686.member.member_1.x - _e686.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1328 = (bitcast<f32>((bitcast<u32>((_e686.member.member_1.y - _e686.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1329 = (bitcast<f32>((bitcast<u32>((_e686.member.member_1.z - _e686.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1331 = select(_e139, _e1327, (_e1327 > _e139));
                                            let _e1333 = select(_e139, _e1328, (_e1328 > _e139));
                                            let _e1335 = select(_e139, _e1329, (_e1329 > _e139));
                                            let _e1366 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1267 & 2097151u))) - 8388608f) * _e1331));
                                            let _e1371 = (bitcast<i32>((_e1267 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1374 = bitcast<f32>((_e1366 & bitcast<u32>(_e1371)));
                                            let _e1375 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1282 & 2097151u))) - 8388608f) * _e1333));
                                            let _e1380 = (bitcast<i32>((_e1282 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1383 = bitcast<f32>((_e1375 & bitcast<u32>(_e1380)));
                                            let _e1384 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1297 & 2097151u))) - 8388608f) * _e1335));
                                            let _e1389 = (bitcast<i32>((_e1297 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1392 = bitcast<f32>((_e1384 & bitcast<u32>(_e1389)));
                                            let _e1396 = bitcast<f32>((_e1366 & bitcast<u32>(~(_e1371))));
                                            let _e1400 = bitcast<f32>((_e1375 & bitcast<u32>(~(_e1380))));
                                            let _e1404 = bitcast<f32>((_e1384 & bitcast<u32>(~(_e1389))));
                                            let _e1405 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1274 & 2097151u))) - 8388608f) * _e1331));
                                            let _e1410 = (bitcast<i32>((_e1274 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1413 = bitcast<f32>((_e1405 & bitcast<u32>(_e1410)));
                                            let _e1414 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1289 & 2097151u))) - 8388608f) * _e1333));
                                            let _e1419 = (bitcast<i32>((_e1289 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1422 = bitcast<f32>((_e1414 & bitcast<u32>(_e1419)));
                                            let _e1423 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1304 & 2097151u))) - 8388608f) * _e1335));
                                            let _e1428 = (bitcast<i32>((_e1304 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1431 = bitcast<f32>((_e1423 & bitcast<u32>(_e1428)));
                                            let _e1435 = bitcast<f32>((_e1405 & bitcast<u32>(~(_e1410))));
                                            let _e1439 = bitcast<f32>((_e1414 & bitcast<u32>(~(_e1419))));
                                            let _e1443 = bitcast<f32>((_e1423 & bitcast<u32>(~(_e1428))));
                                            let _e1473 = global_6.member[_e686.member_1][0u];
                                            let _e1477 = global_6.member[_e686.member_1][2u];
                                            let _e1481 = global_6.member[_e686.member_1][4u];
                                            let _e1485 = global_6.member[_e686.member_1][6u];
                                            let _e1497 = (((_e1477 >> bitcast<u32>(22i)) | ((_e1481 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1485 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1498 = (_e1473 & 268435455u);
                                            let _e1499 = (_e1497 & 268435455u);
                                            let _e1502 = ((_e1473 >> bitcast<u32>(28u)) & 7u);
                                            let _e1510 = ((_e1473 >> bitcast<u32>(31i)) | (((_e1497 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1511 = (_e1502 != 0u);
                                            if (_e1502 == 0u) {
                                                phi_2884_ = _e1498;
                                            } else {
                                                if (_e1502 == 7u) {
                                                    phi_2883_ = 2147483648u;
                                                } else {
                                                    phi_2883_ = ((2147483648u | (_e1502 << bitcast<u32>(28u))) | (_e1499 & 268435455u));
                                                }
                                                let _e1520 = phi_2883_;
                                                phi_2884_ = _e1520;
                                            }
                                            let _e1522 = phi_2884_;
                                            if _e1511 {
                                                let _e1523 = (_e1502 != 7u);
                                                if _e1523 {
                                                    phi_2894_ = (_e1499 + _e1502);
                                                } else {
                                                    phi_2894_ = u32();
                                                }
                                                let _e1526 = phi_2894_;
                                                phi_2896_ = _e1526;
                                                phi_2897_ = select(true, false, _e1523);
                                            } else {
                                                phi_2896_ = u32();
                                                phi_2897_ = true;
                                            }
                                            let _e1529 = phi_2896_;
                                            let _e1531 = phi_2897_;
                                            if (_e1510 == 0u) {
                                                phi_2918_ = (_e1498 + select(0u, 1u, !(_e1511)));
                                            } else {
                                                if (_e1510 == 7u) {
                                                    phi_2917_ = 2147483648u;
                                                } else {
                                                    phi_2917_ = ((2147483648u | (_e1510 << bitcast<u32>(28u))) | (select(_e1529, _e1499, _e1531) & 268435455u));
                                                }
                                                let _e1544 = phi_2917_;
                                                phi_2918_ = _e1544;
                                            }
                                            let _e1546 = phi_2918_;
                                            phi_2922_ = type_51(array<vec4<f32>, 3>(vec4<f32>((_e686.member.member.x + _e1374), (_e686.member.member.x + _e1396), (_e686.member.member_1.x - _e1413), (_e686.member.member_1.x - _e1435)), vec4<f32>((_e686.member.member.y + _e1383), (_e686.member.member.y + _e1400), (_e686.member.member_1.y - _e1422), (_e686.member.member_1.y - _e1439)), vec4<f32>((_e686.member.member.z + _e1392), (_e686.member.member.z + _e1404), (_e686.member.member_1.z - _e1431), (_e686.member.member_1.z - _e1443))), type_50(type_28((_e686.member.member + vec4<f32>(_e1374, _e1383, _e1392, 0f)), (_e686.member.member_1 - vec4<f32>(_e1413, _e1422, _e1431, 0f))), _e1522), type_50(type_28((_e686.member.member + vec4<f32>(_e1396, _e1400, _e1404, 0f)), (_e686.member.member_1 - vec4<f32>(_e1435, _e1439, _e1443, 0f))), _e1546));
                                        }
                                        let _e1551 = phi_2922_;
                                        let _e1563 = ((_e1551.member[0].x - _e361) * _e364);
                                        let _e1564 = ((_e1551.member[0].y - _e361) * _e364);
                                        let _e1565 = ((_e1551.member[0].z - _e362) * _e364);
                                        let _e1566 = ((_e1551.member[0].w - _e362) * _e364);
                                        let _e1576 = ((_e1551.member[1].x - _e427) * _e430);
                                        let _e1577 = ((_e1551.member[1].y - _e427) * _e430);
                                        let _e1578 = ((_e1551.member[1].z - _e428) * _e430);
                                        let _e1579 = ((_e1551.member[1].w - _e428) * _e430);
                                        let _e1589 = ((_e1551.member[2].x - _e493) * _e496);
                                        let _e1590 = ((_e1551.member[2].y - _e493) * _e496);
                                        let _e1591 = ((_e1551.member[2].z - _e494) * _e496);
                                        let _e1592 = ((_e1551.member[2].w - _e494) * _e496);
                                        let _e1594 = select(_e1591, _e1589, (_e1589 < _e1591));
                                        let _e1596 = select(_e1592, _e1590, (_e1590 < _e1592));
                                        let _e1598 = select(_e1591, _e1589, (_e1589 > _e1591));
                                        let _e1600 = select(_e1592, _e1590, (_e1590 > _e1592));
                                        let _e1602 = select(_e1565, _e1563, (_e1563 < _e1565));
                                        let _e1604 = select(_e1566, _e1564, (_e1564 < _e1566));
                                        let _e1606 = select(_e1578, _e1576, (_e1576 < _e1578));
                                        let _e1608 = select(_e1579, _e1577, (_e1577 < _e1579));
                                        let _e1610 = select(_e1606, _e1602, (_e1602 > _e1606));
                                        let _e1612 = select(_e1608, _e1604, (_e1604 > _e1608));
                                        let _e1614 = select(_e1594, _e1610, (_e1610 > _e1594));
                                        let _e1616 = select(_e1596, _e1612, (_e1612 > _e1596));
                                        let _e1618 = select(_e1565, _e1563, (_e1563 > _e1565));
                                        let _e1620 = select(_e1566, _e1564, (_e1564 > _e1566));
                                        let _e1622 = select(_e1578, _e1576, (_e1576 > _e1578));
                                        let _e1624 = select(_e1579, _e1577, (_e1577 > _e1579));
                                        let _e1626 = select(_e1622, _e1618, (_e1618 < _e1622));
                                        let _e1628 = select(_e1624, _e1620, (_e1620 < _e1624));
                                        let _e1633 = -(_e1594);
                                        let _e1634 = -(_e1596);
                                        let _e1641 = (select(_e1598, _e1626, (_e1626 < _e1598)) + (select(_e1633, _e1598, (_e1598 > _e1633)) * 0.0000019073523f));
                                        let _e1642 = (select(_e1600, _e1628, (_e1628 < _e1600)) + (select(_e1634, _e1600, (_e1600 > _e1634)) * 0.0000019073523f));
                                        let _e1644 = select(_e599, _e1614, (_e1614 > _e599));
                                        let _e1646 = select(_e599, _e1616, (_e1616 > _e599));
                                        let _e1651 = (_e1644 <= select(_e1257.member, _e1641, (_e1641 < _e1257.member)));
                                        let _e1652 = (_e1646 <= select(_e1257.member, _e1642, (_e1642 < _e1257.member)));
                                        let _e1653 = (_e1644 <= _e1646);
                                        if _e1651 {
                                            if _e1652 {
                                                if _e1653 {
                                                    phi_3284_ = _e1551.member_2;
                                                } else {
                                                    phi_3284_ = _e1551.member_1;
                                                }
                                                let _e1657 = phi_3284_;
                                                let _e1678 = (_e684 % 128u);
                                                let _e1679 = (_e1678 < 128u);
                                                if _e1679 {
                                                } else {
                                                    phi_3980_ = true;
                                                    break;
                                                }
                                                local_8[_e1678] = _e1657.member_1;
                                                if _e1679 {
                                                } else {
                                                    phi_3980_ = true;
                                                    break;
                                                }
                                                local_7[_e1678] = _e1657.member.member.x;
                                                if _e1679 {
                                                } else {
                                                    phi_3980_ = true;
                                                    break;
                                                }
                                                local_6[_e1678] = _e1657.member.member.y;
                                                if _e1679 {
                                                } else {
                                                    phi_3980_ = true;
                                                    break;
                                                }
                                                local_5[_e1678] = _e1657.member.member.z;
                                                if _e1679 {
                                                } else {
                                                    phi_3980_ = true;
                                                    break;
                                                }
                                                local_4[_e1678] = _e1657.member.member_1.x;
                                                if _e1679 {
                                                } else {
                                                    phi_3980_ = true;
                                                    break;
                                                }
                                                local_3[_e1678] = _e1657.member.member_1.y;
                                                if _e1679 {
                                                } else {
                                                    phi_3980_ = true;
                                                    break;
                                                }
                                                local_2[_e1678] = _e1657.member.member_1.z;
                                                if _e1679 {
                                                } else {
                                                    phi_3980_ = true;
                                                    break;
                                                }
                                                local_9[_e1678] = select(_e1644, _e1646, _e1653);
                                                if _e1653 {
                                                    phi_3360_ = _e1551.member_1;
                                                } else {
                                                    phi_3360_ = _e1551.member_2;
                                                }
                                                let _e1692 = phi_3360_;
                                                phi_3361_ = (_e684 + 1u);
                                                phi_3362_ = _e1692;
                                            } else {
                                                phi_3361_ = u32();
                                                phi_3362_ = type_50();
                                            }
                                            let _e1694 = phi_3361_;
                                            let _e1696 = phi_3362_;
                                            phi_3364_ = _e1694;
                                            phi_3365_ = _e1696;
                                            phi_3366_ = select(true, false, _e1652);
                                        } else {
                                            phi_3364_ = u32();
                                            phi_3365_ = type_50();
                                            phi_3366_ = true;
                                        }
                                        let _e1699 = phi_3364_;
                                        let _e1701 = phi_3365_;
                                        let _e1703 = phi_3366_;
                                        if _e1703 {
                                            if _e1651 {
                                                phi_3375_ = _e1551.member_1;
                                            } else {
                                                phi_3375_ = _e1551.member_2;
                                            }
                                            let _e1707 = phi_3375_;
                                            phi_3380_ = select(_e1652, true, _e1651);
                                            phi_3382_ = _e1707;
                                        } else {
                                            phi_3380_ = _e682;
                                            phi_3382_ = _e1701;
                                        }
                                        let _e1710 = phi_3380_;
                                        let _e1712 = phi_3382_;
                                        phi_3386_ = _e1710;
                                        phi_3387_ = select(_e1699, _e684, _e1703);
                                        phi_3388_ = _e1712;
                                    }
                                    let _e1715 = phi_3386_;
                                    let _e1717 = phi_3387_;
                                    let _e1719 = phi_3388_;
                                    if _e690 {
                                        phi_3398_ = select(_e684, 0u, _e1257.member_1);
                                        phi_3399_ = _e686;
                                    } else {
                                        phi_3398_ = _e1717;
                                        phi_3399_ = _e1719;
                                    }
                                    let _e1723 = phi_3398_;
                                    let _e1725 = phi_3399_;
                                    phi_3983_ = _e1255;
                                    phi_3400_ = _e1257;
                                    phi_3401_ = (_e645 - 1u);
                                    phi_3402_ = select(_e1715, false, _e690);
                                    phi_3403_ = _e1723;
                                    phi_3404_ = _e1725;
                                } else {
                                    phi_3983_ = _e641;
                                    phi_3400_ = _e643;
                                    phi_3401_ = _e645;
                                    phi_3402_ = _e682;
                                    phi_3403_ = _e684;
                                    phi_3404_ = _e686;
                                }
                                let _e1728 = phi_3983_;
                                let _e1730 = phi_3400_;
                                let _e1732 = phi_3401_;
                                let _e1734 = phi_3402_;
                                let _e1736 = phi_3403_;
                                let _e1738 = phi_3404_;
                                phi_3982_ = _e1728;
                                phi_3405_ = _e1730;
                                phi_3406_ = _e1732;
                                phi_3407_ = _e1734;
                                phi_3408_ = _e1736;
                                phi_3409_ = _e1738;
                            } else {
                                phi_3982_ = _e641;
                                phi_3405_ = type_39();
                                phi_3406_ = u32();
                                phi_3407_ = bool();
                                phi_3408_ = u32();
                                phi_3409_ = type_50();
                            }
                            let _e1740 = phi_3982_;
                            let _e1742 = phi_3405_;
                            let _e1744 = phi_3406_;
                            let _e1746 = phi_3407_;
                            let _e1748 = phi_3408_;
                            let _e1750 = phi_3409_;
                            phi_3981_ = _e1740;
                            phi_1083_ = _e1742;
                            phi_1086_ = _e1744;
                            phi_1088_ = _e1746;
                            phi_1090_ = _e1748;
                            phi_1092_ = _e1750;
                            phi_3410_ = _e655;
                        } else {
                            phi_3981_ = _e641;
                            phi_1083_ = type_39();
                            phi_1086_ = u32();
                            phi_1088_ = bool();
                            phi_1090_ = u32();
                            phi_1092_ = type_50();
                            phi_3410_ = false;
                        }
                        let _e1752 = phi_3981_;
                        let _e1754 = phi_1083_;
                        let _e1756 = phi_1086_;
                        let _e1758 = phi_1088_;
                        let _e1760 = phi_1090_;
                        let _e1762 = phi_1092_;
                        let _e1764 = phi_3410_;
                        continue;
                        continuing {
                            phi_3824_ = _e1752;
                            phi_1082_ = _e1754;
                            phi_1085_ = _e1756;
                            phi_1087_ = _e1758;
                            phi_1089_ = _e1760;
                            phi_1091_ = _e1762;
                            phi_3980_ = _e1752;
                            break if !(_e1764);
                        }
                    }
                    let _e1767 = phi_3980_;
                    if _e1767 {
                        break;
                    }
                    let _e1769 = local_10;
                    if _e147 {
                    } else {
                        break;
                    }
                    global_5.member[_e145] = select(0u, 1u, _e1769.member_1);
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
