struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: array<array<u32, 4>>,
}

struct type_18 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_20 {
    member: array<type_18>,
}

struct type_26 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_28 {
    member: array<type_26>,
}

struct type_30 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_31 {
    member: type_30,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_33 {
    member: array<type_31>,
}

struct type_38 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_42 {
    member: type_26,
    member_1: f32,
}

struct type_46 {
    member: type_42,
    member_1: u32,
    member_2: u32,
}

struct type_48 {
    member: array<vec4<u32>, 2>,
}

struct type_53 {
    member: type_38,
    member_1: u32,
}

struct type_54 {
    member: array<vec4<f32>, 3>,
    member_1: type_53,
    member_2: type_53,
}

struct type_59 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(2) 
var<storage> global_1: type_20;
@group(0) @binding(4) 
var<storage, read_write> global_2: type_28;
@group(0) @binding(0) 
var<uniform> global_3: type_48;
@group(0) @binding(1) 
var<storage> global_4: type_12;
@group(0) @binding(3) 
var<storage> global_5: type_33;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_7: type_59;

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
    var phi_478_: i32;
    var phi_479_: i32;
    var phi_489_: bool;
    var phi_499_: u32;
    var phi_500_: u32;
    var phi_502_: bool;
    var phi_507_: u32;
    var phi_539_: i32;
    var phi_557_: f32;
    var phi_563_: f32;
    var phi_603_: f32;
    var phi_609_: f32;
    var phi_661_: f32;
    var phi_672_: f32;
    var phi_681_: f32;
    var phi_687_: f32;
    var phi_727_: f32;
    var phi_733_: f32;
    var phi_785_: f32;
    var phi_796_: f32;
    var phi_805_: f32;
    var phi_811_: f32;
    var phi_851_: f32;
    var phi_857_: f32;
    var phi_909_: f32;
    var phi_920_: f32;
    var phi_975_: i32;
    var phi_997_: u32;
    var phi_998_: u32;
    var phi_1035_: i32;
    var phi_1057_: u32;
    var phi_1058_: u32;
    var phi_1066_: f32;
    var phi_1067_: f32;
    var phi_4002_: bool;
    var phi_1165_: type_46;
    var phi_1168_: type_53;
    var phi_1170_: u32;
    var phi_1172_: bool;
    var phi_1174_: u32;
    var phi_1185_: bool;
    var phi_1271_: type_53;
    var phi_1272_: bool;
    var phi_1273_: u32;
    var phi_3030_: u32;
    var phi_3031_: u32;
    var phi_3041_: u32;
    var phi_3043_: u32;
    var phi_3044_: bool;
    var phi_3064_: u32;
    var phi_3065_: u32;
    var phi_3069_: type_54;
    var phi_3413_: type_53;
    var phi_3490_: type_53;
    var phi_3491_: type_53;
    var phi_3492_: u32;
    var phi_3494_: type_53;
    var phi_3495_: u32;
    var phi_3496_: bool;
    var phi_3505_: type_53;
    var phi_3510_: type_53;
    var phi_3511_: bool;
    var phi_1291_: type_46;
    var phi_1294_: type_7;
    var phi_1295_: type_7;
    var phi_1317_: type_7;
    var phi_1341_: u32;
    var phi_1430_: array<array<f32, 3>, 3>;
    var phi_1547_: bool;
    var phi_1576_: bool;
    var phi_1977_: f32;
    var phi_1978_: f32;
    var phi_1979_: f32;
    var phi_1980_: f32;
    var phi_1981_: vec3<f32>;
    var phi_1982_: vec3<f32>;
    var phi_1983_: vec3<f32>;
    var phi_1984_: vec3<f32>;
    var phi_2015_: bool;
    var phi_2024_: vec3<f32>;
    var phi_2189_: f32;
    var phi_2191_: f32;
    var phi_2192_: bool;
    var phi_2212_: f32;
    var phi_2213_: f32;
    var phi_2236_: type_26;
    var phi_2238_: type_26;
    var phi_2239_: bool;
    var phi_2243_: type_26;
    var phi_2244_: type_26;
    var phi_2245_: type_26;
    var phi_2246_: bool;
    var phi_2250_: type_26;
    var phi_2251_: bool;
    var phi_2252_: type_26;
    var phi_2253_: bool;
    var phi_2254_: bool;
    var phi_2255_: type_26;
    var phi_2256_: bool;
    var phi_2257_: bool;
    var phi_2265_: type_26;
    var phi_2266_: bool;
    var phi_2270_: type_26;
    var phi_2295_: bool;
    var phi_2296_: bool;
    var phi_2303_: type_46;
    var phi_2304_: type_46;
    var phi_2305_: type_46;
    var phi_1292_: type_46;
    var phi_3996_: bool;
    var phi_4160_: bool;
    var phi_3513_: type_46;
    var phi_3514_: type_53;
    var phi_3515_: bool;
    var phi_3516_: u32;
    var phi_4159_: bool;
    var phi_3517_: type_46;
    var phi_3518_: type_53;
    var phi_3519_: u32;
    var phi_3520_: bool;
    var phi_3521_: u32;
    var phi_4158_: bool;
    var phi_3522_: type_46;
    var phi_3523_: type_53;
    var phi_3524_: u32;
    var phi_3525_: bool;
    var phi_3526_: u32;
    var phi_4157_: bool;
    var phi_1166_: type_46;
    var phi_1169_: type_53;
    var phi_1171_: u32;
    var phi_1173_: bool;
    var phi_1175_: u32;
    var phi_3527_: bool;
    var phi_4156_: bool;
    var local_10: type_46;
    var phi_3565_: f32;
    var phi_3567_: f32;
    var phi_3568_: bool;
    var phi_3569_: f32;
    var phi_3570_: bool;
    var phi_3904_: u32;
    var phi_3922_: bool;
    var phi_3925_: bool;
    var phi_3938_: f32;
    var phi_3939_: f32;
    var phi_3944_: f32;
    var phi_3945_: f32;
    var phi_3946_: bool;
    var phi_3954_: f32;
    var phi_3585_: f32;
    var phi_3586_: f32;
    var phi_3598_: f32;
    var phi_3603_: type_26;
    var local_11: type_46;
    var local_12: type_46;

    switch bitcast<i32>(0u) {
        default: {
            let _e94 = global;
            let _e96 = arrayLength((&global_4.member));
            let _e98 = arrayLength((&global_1.member));
            let _e106 = arrayLength((&global_7.member));
            let _e110 = global_3.member[0u][0u];
            let _e114 = global_3.member[0u][1u];
            let _e118 = global_3.member[0u][2u];
            let _e122 = global_3.member[0u][3u];
            let _e126 = global_3.member[1u][0u];
            let _e130 = global_3.member[1u][1u];
            let _e134 = global_3.member[1u][2u];
            let _e138 = (_e94.x + (_e94.y * 2097152u));
            let _e150 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e122) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e110), bitcast<i32>(_e114), bitcast<i32>(_e118));
            local = array<i32, 3>(bitcast<i32>(_e126), bitcast<i32>(_e130), bitcast<i32>(_e134));
            let _e153 = (_e138 < arrayLength((&global_5.member)));
            if _e153 {
                let _e154 = (_e138 < arrayLength((&global_2.member)));
                if _e154 {
                    let _e155 = (_e138 < arrayLength((&global_6.member)));
                    if _e155 {
                        if _e153 {
                        } else {
                            break;
                        }
                        let _e165 = global_5.member[_e138].member.member_2[0u];
                        let _e167 = (bitcast<u32>(_e165) & 2147483647u);
                        let _e173 = global_5.member[_e138].member.member_2[1u];
                        let _e175 = (bitcast<u32>(_e173) & 2147483647u);
                        let _e181 = global_5.member[_e138].member.member_2[2u];
                        let _e183 = (bitcast<u32>(_e181) & 2147483647u);
                        let _e189 = global_5.member[_e138].member.member[0u];
                        let _e191 = (bitcast<u32>(_e189) & 2147483647u);
                        let _e197 = global_5.member[_e138].member.member[1u];
                        let _e199 = (bitcast<u32>(_e197) & 2147483647u);
                        let _e205 = global_5.member[_e138].member.member[2u];
                        let _e207 = (bitcast<u32>(_e205) & 2147483647u);
                        let _e209 = select(_e175, _e167, (_e175 < _e167));
                        let _e211 = select(_e183, _e209, (_e183 < _e209));
                        let _e213 = select(_e191, _e211, (_e191 < _e211));
                        let _e215 = select(_e199, _e213, (_e199 < _e213));
                        let _e217 = select(_e207, _e215, (_e207 < _e215));
                        let _e222 = global_5.member[_e138].member.member_1;
                        let _e223 = bitcast<u32>(_e222);
                        let _e224 = (_e223 & 2147483647u);
                        let _e232 = global_5.member[_e138].member.member_3;
                        let _e233 = bitcast<u32>(_e232);
                        let _e234 = (_e233 & 2147483647u);
                        let _e238 = (((select(_e224, _e217, (_e224 < _e217)) < 2139095040u) && (_e234 <= 2139095040u)) && (_e211 > 0u));
                        if _e238 {
                            let _e241 = (bitcast<u32>(bitcast<f32>(_e211)) & 2147483647u);
                            if (_e241 >= 8388608u) {
                                phi_478_ = (bitcast<i32>((_e241 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_478_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e241)), 32u, (_e241 == 0u))));
                            }
                            let _e255 = phi_478_;
                            phi_479_ = _e255;
                        } else {
                            phi_479_ = 0i;
                        }
                        let _e257 = phi_479_;
                        let _e258 = (_e167 == _e211);
                        if _e258 {
                            phi_489_ = true;
                        } else {
                            phi_489_ = (_e175 == _e211);
                        }
                        let _e261 = phi_489_;
                        let _e262 = select(1u, 0u, _e258);
                        if _e261 {
                            let _e263 = (_e262 + 1u);
                            phi_499_ = _e263;
                            phi_500_ = _e263;
                            phi_502_ = select(true, false, (_e263 == 2u));
                        } else {
                            phi_499_ = u32();
                            phi_500_ = 0u;
                            phi_502_ = true;
                        }
                        let _e267 = phi_499_;
                        let _e269 = phi_500_;
                        let _e271 = phi_502_;
                        if _e271 {
                            phi_507_ = (_e269 + 1u);
                        } else {
                            phi_507_ = 0u;
                        }
                        let _e275 = phi_507_;
                        let _e276 = select(_e267, _e269, _e271);
                        let _e277 = select(_e262, select(2u, _e262, _e261), _e271);
                        let _e278 = -(_e257);
                        if (_e278 < -126i) {
                            phi_539_ = -126i;
                        } else {
                            phi_539_ = select(_e278, 127i, (_e278 > 127i));
                        }
                        let _e283 = phi_539_;
                        let _e288 = bitcast<f32>((bitcast<u32>((_e283 + 127i)) << bitcast<u32>(23i)));
                        let _e294 = bitcast<f32>((bitcast<u32>(((_e278 - _e283) + 127i)) << bitcast<u32>(23i)));
                        let _e299 = global_5.member[_e138].member.member;
                        let _e300 = (_e276 == 0u);
                        if _e300 {
                            phi_557_ = _e299[0];
                        } else {
                            phi_557_ = _e299[1];
                        }
                        let _e304 = phi_557_;
                        let _e305 = (_e276 == 2u);
                        if _e305 {
                            phi_563_ = _e299[2];
                        } else {
                            phi_563_ = _e304;
                        }
                        let _e308 = phi_563_;
                        let _e309 = bitcast<u32>(_e308);
                        let _e311 = ((_e309 & 2139095040u) != 0u);
                        let _e323 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e309 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e309 & 2147483648u))), _e308, _e311) * select(0.00000011920929f, 1f, _e311));
                        let _e324 = global_5.member[_e138].member.member_2;
                        if _e300 {
                            phi_603_ = _e324[0];
                        } else {
                            phi_603_ = _e324[1];
                        }
                        let _e328 = phi_603_;
                        if _e305 {
                            phi_609_ = _e324[2];
                        } else {
                            phi_609_ = _e328;
                        }
                        let _e331 = phi_609_;
                        let _e332 = bitcast<u32>(_e331);
                        let _e334 = ((_e332 & 2139095040u) != 0u);
                        let _e348 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e332 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e332 & 2147483648u))), _e331, _e334) * _e288) * select(0.00000011920929f, 1f, _e334)) * _e294);
                        let _e352 = (bitcast<f32>((bitcast<u32>(_e348) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e352 {
                            let _e356 = (bitcast<f32>((bitcast<u32>(_e323) & 2147483647u)) * 0.00000011920929f);
                            phi_661_ = select(0.00000000000011368684f, _e356, (_e356 > 0.00000000000011368684f));
                        } else {
                            phi_661_ = 0f;
                        }
                        let _e360 = phi_661_;
                        let _e361 = (_e323 + _e360);
                        let _e362 = (_e323 - _e360);
                        let _e363 = select(_e348, 0f, _e352);
                        if _e352 {
                            phi_672_ = 38685626000000000000000000f;
                        } else {
                            phi_672_ = (1f / _e348);
                        }
                        let _e366 = phi_672_;
                        let _e367 = (_e275 == 0u);
                        if _e367 {
                            phi_681_ = _e299[0];
                        } else {
                            phi_681_ = _e299[1];
                        }
                        let _e371 = phi_681_;
                        let _e372 = (_e275 == 2u);
                        if _e372 {
                            phi_687_ = _e299[2];
                        } else {
                            phi_687_ = _e371;
                        }
                        let _e375 = phi_687_;
                        let _e376 = bitcast<u32>(_e375);
                        let _e378 = ((_e376 & 2139095040u) != 0u);
                        let _e390 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e376 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e376 & 2147483648u))), _e375, _e378) * select(0.00000011920929f, 1f, _e378));
                        if _e367 {
                            phi_727_ = _e324[0];
                        } else {
                            phi_727_ = _e324[1];
                        }
                        let _e394 = phi_727_;
                        if _e372 {
                            phi_733_ = _e324[2];
                        } else {
                            phi_733_ = _e394;
                        }
                        let _e397 = phi_733_;
                        let _e398 = bitcast<u32>(_e397);
                        let _e400 = ((_e398 & 2139095040u) != 0u);
                        let _e414 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e398 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e398 & 2147483648u))), _e397, _e400) * _e288) * select(0.00000011920929f, 1f, _e400)) * _e294);
                        let _e418 = (bitcast<f32>((bitcast<u32>(_e414) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e418 {
                            let _e422 = (bitcast<f32>((bitcast<u32>(_e390) & 2147483647u)) * 0.00000011920929f);
                            phi_785_ = select(0.00000000000011368684f, _e422, (_e422 > 0.00000000000011368684f));
                        } else {
                            phi_785_ = 0f;
                        }
                        let _e426 = phi_785_;
                        let _e427 = (_e390 + _e426);
                        let _e428 = (_e390 - _e426);
                        let _e429 = select(_e414, 0f, _e418);
                        if _e418 {
                            phi_796_ = 38685626000000000000000000f;
                        } else {
                            phi_796_ = (1f / _e414);
                        }
                        let _e432 = phi_796_;
                        let _e433 = (_e277 == 0u);
                        if _e433 {
                            phi_805_ = _e299[0];
                        } else {
                            phi_805_ = _e299[1];
                        }
                        let _e437 = phi_805_;
                        let _e438 = (_e277 == 2u);
                        if _e438 {
                            phi_811_ = _e299[2];
                        } else {
                            phi_811_ = _e437;
                        }
                        let _e441 = phi_811_;
                        let _e442 = bitcast<u32>(_e441);
                        let _e444 = ((_e442 & 2139095040u) != 0u);
                        let _e456 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e442 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e442 & 2147483648u))), _e441, _e444) * select(0.00000011920929f, 1f, _e444));
                        if _e433 {
                            phi_851_ = _e324[0];
                        } else {
                            phi_851_ = _e324[1];
                        }
                        let _e460 = phi_851_;
                        if _e438 {
                            phi_857_ = _e324[2];
                        } else {
                            phi_857_ = _e460;
                        }
                        let _e463 = phi_857_;
                        let _e464 = bitcast<u32>(_e463);
                        let _e466 = ((_e464 & 2139095040u) != 0u);
                        let _e480 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e464 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e464 & 2147483648u))), _e463, _e466) * _e288) * select(0.00000011920929f, 1f, _e466)) * _e294);
                        let _e484 = (bitcast<f32>((bitcast<u32>(_e480) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e484 {
                            let _e488 = (bitcast<f32>((bitcast<u32>(_e456) & 2147483647u)) * 0.00000011920929f);
                            phi_909_ = select(0.00000000000011368684f, _e488, (_e488 > 0.00000000000011368684f));
                        } else {
                            phi_909_ = 0f;
                        }
                        let _e492 = phi_909_;
                        let _e493 = (_e456 + _e492);
                        let _e494 = (_e456 - _e492);
                        let _e495 = select(_e480, 0f, _e484);
                        if _e484 {
                            phi_920_ = 38685626000000000000000000f;
                        } else {
                            phi_920_ = (1f / _e480);
                        }
                        let _e498 = phi_920_;
                        let _e501 = bitcast<f32>((bitcast<u32>(_e323) & 2147483647u));
                        let _e504 = bitcast<f32>((bitcast<u32>(_e390) & 2147483647u));
                        let _e506 = select(_e504, _e501, (_e501 > _e504));
                        let _e509 = bitcast<f32>((bitcast<u32>(_e456) & 2147483647u));
                        if (_e238 && (select(_e509, _e506, (_e506 > _e509)) <= 1099511600000f)) {
                            let _e521 = ((_e224 & 8388607u) | (select(0u, 1u, ((_e224 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e524 = bitcast<i32>((_e224 >> bitcast<u32>(23i)));
                            let _e528 = (_e521 == 0u);
                            let _e531 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e521)), 32u, _e528)) - 8i);
                            if (_e524 == 255i) {
                                phi_975_ = 255i;
                            } else {
                                phi_975_ = (((_e524 + select(0i, 1i, (_e524 == 0i))) - _e531) + _e257);
                            }
                            let _e539 = phi_975_;
                            let _e549 = (_e539 <= 0i);
                            if _e549 {
                                phi_998_ = u32();
                            } else {
                                if _e528 {
                                    phi_997_ = u32();
                                } else {
                                    phi_997_ = select(((bitcast<u32>(_e539) << bitcast<u32>(23i)) | ((_e521 << bitcast<u32>(((_e531 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e539 >= 255i));
                                }
                                let _e553 = phi_997_;
                                phi_998_ = _e553;
                            }
                            let _e555 = phi_998_;
                            let _e567 = ((_e234 & 8388607u) | (select(0u, 1u, ((_e234 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e570 = bitcast<i32>((_e234 >> bitcast<u32>(23i)));
                            let _e574 = (_e567 == 0u);
                            let _e577 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e567)), 32u, _e574)) - 8i);
                            if (_e570 == 255i) {
                                phi_1035_ = 255i;
                            } else {
                                phi_1035_ = (((_e570 + select(0i, 1i, (_e570 == 0i))) - _e577) + _e257);
                            }
                            let _e585 = phi_1035_;
                            let _e595 = (_e585 <= 0i);
                            if _e595 {
                                phi_1058_ = u32();
                            } else {
                                if _e574 {
                                    phi_1057_ = u32();
                                } else {
                                    phi_1057_ = select(((bitcast<u32>(_e585) << bitcast<u32>(23i)) | ((_e567 << bitcast<u32>(((_e577 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e585 >= 255i));
                                }
                                let _e599 = phi_1057_;
                                phi_1058_ = _e599;
                            }
                            let _e601 = phi_1058_;
                            phi_1066_ = bitcast<f32>(((_e233 & 2147483648u) | select(_e601, 0u, select(_e574, true, _e595))));
                            phi_1067_ = bitcast<f32>(((_e223 & 2147483648u) | select(_e555, 0u, select(_e528, true, _e549))));
                        } else {
                            phi_1066_ = 0f;
                            phi_1067_ = 1f;
                        }
                        let _e607 = phi_1066_;
                        let _e609 = phi_1067_;
                        if _e153 {
                        } else {
                            break;
                        }
                        let _e615 = global_5.member[_e138].member_2;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e618 = (_e276 % 3u);
                        let _e619 = (_e618 < 3u);
                        if _e619 {
                        } else {
                            break;
                        }
                        let _e621 = local_1[_e618];
                        let _e624 = (_e275 % 3u);
                        let _e625 = (_e624 < 3u);
                        if _e625 {
                        } else {
                            break;
                        }
                        let _e627 = local_1[_e624];
                        let _e630 = (_e277 % 3u);
                        let _e631 = (_e630 < 3u);
                        if _e631 {
                        } else {
                            break;
                        }
                        let _e633 = local_1[_e630];
                        if _e619 {
                        } else {
                            break;
                        }
                        let _e638 = local[_e618];
                        if _e625 {
                        } else {
                            break;
                        }
                        let _e642 = local[_e624];
                        if _e631 {
                        } else {
                            break;
                        }
                        let _e646 = local[_e630];
                        phi_4002_ = false;
                        phi_1165_ = type_46(type_42(type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e607), 0u, 0u);
                        phi_1168_ = type_53(type_38(vec4<f32>((f32(_e621) * _e150), (f32(_e627) * _e150), (f32(_e633) * _e150), 0f), vec4<f32>((f32(_e638) * _e150), (f32(_e642) * _e150), (f32(_e646) * _e150), 0f)), select(0u, 2147483648u, (_e96 == 0u)));
                        phi_1170_ = ((3u * _e96) + 1u);
                        phi_1172_ = (_e609 <= _e607);
                        phi_1174_ = 0u;
                        loop {
                            let _e656 = phi_4002_;
                            let _e658 = phi_1165_;
                            let _e660 = phi_1168_;
                            let _e662 = phi_1170_;
                            let _e664 = phi_1172_;
                            let _e666 = phi_1174_;
                            local_10 = _e658;
                            local_11 = _e658;
                            if _e664 {
                                phi_1185_ = true;
                            } else {
                                phi_1185_ = (_e666 > 0u);
                            }
                            let _e669 = phi_1185_;
                            if _e669 {
                                let _e670 = (_e662 > 0u);
                                if _e670 {
                                    if _e664 {
                                        phi_1271_ = _e660;
                                        phi_1272_ = _e664;
                                        phi_1273_ = _e666;
                                    } else {
                                        let _e671 = (_e666 - 1u);
                                        let _e672 = (_e671 % 128u);
                                        let _e673 = (_e672 < 128u);
                                        if _e673 {
                                        } else {
                                            phi_4156_ = true;
                                            break;
                                        }
                                        let _e675 = local_7[_e672];
                                        if _e673 {
                                        } else {
                                            phi_4156_ = true;
                                            break;
                                        }
                                        let _e677 = local_6[_e672];
                                        if _e673 {
                                        } else {
                                            phi_4156_ = true;
                                            break;
                                        }
                                        let _e679 = local_5[_e672];
                                        if _e673 {
                                        } else {
                                            phi_4156_ = true;
                                            break;
                                        }
                                        let _e681 = local_4[_e672];
                                        if _e673 {
                                        } else {
                                            phi_4156_ = true;
                                            break;
                                        }
                                        let _e683 = local_3[_e672];
                                        if _e673 {
                                        } else {
                                            phi_4156_ = true;
                                            break;
                                        }
                                        let _e685 = local_2[_e672];
                                        if _e673 {
                                        } else {
                                            phi_4156_ = true;
                                            break;
                                        }
                                        let _e690 = local_8[_e672];
                                        if _e673 {
                                        } else {
                                            phi_4156_ = true;
                                            break;
                                        }
                                        let _e693 = local_9[_e672];
                                        phi_1271_ = type_53(type_38(vec4<f32>(_e675, _e677, _e679, 0f), vec4<f32>(_e681, _e683, _e685, 0f)), _e690);
                                        phi_1272_ = (_e693 <= _e658.member.member_1);
                                        phi_1273_ = _e671;
                                    }
                                    let _e698 = phi_1271_;
                                    let _e700 = phi_1272_;
                                    let _e702 = phi_1273_;
                                    if _e700 {
                                        if ((_e698.member_1 & 2147483648u) != 0u) {
                                            phi_1291_ = _e658;
                                            phi_1294_ = type_7(0u, ((_e698.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1159 = phi_1291_;
                                                let _e1161 = phi_1294_;
                                                local_12 = _e1159;
                                                if (_e1161.member < _e1161.member_1) {
                                                    phi_1295_ = type_7((_e1161.member + 1u), _e1161.member_1);
                                                    phi_1317_ = type_7(1u, _e1161.member);
                                                } else {
                                                    phi_1295_ = _e1161;
                                                    phi_1317_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e1174 = phi_1295_;
                                                let _e1176 = phi_1317_;
                                                let _e1180 = (bitcast<i32>(_e1176.member) != 0i);
                                                if _e1180 {
                                                    let _e1186 = type_46(_e1159.member, _e1159.member_1, (_e1159.member_2 + 1u));
                                                    let _e1187 = ((_e698.member_1 & 268435455u) + _e1176.member_1);
                                                    let _e1188 = (_e1187 < _e98);
                                                    if _e1188 {
                                                        if _e1188 {
                                                        } else {
                                                            phi_3996_ = true;
                                                            break;
                                                        }
                                                        let _e1192 = global_1.member[_e1187].member_1;
                                                        phi_1341_ = _e1192;
                                                    } else {
                                                        phi_1341_ = 4294967295u;
                                                    }
                                                    let _e1194 = phi_1341_;
                                                    if (_e1187 >= _e98) {
                                                        phi_1430_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1188 {
                                                        } else {
                                                            phi_3996_ = true;
                                                            break;
                                                        }
                                                        if (_e618 < 9u) {
                                                        } else {
                                                            phi_3996_ = true;
                                                            break;
                                                        }
                                                        let _e1201 = global_1.member[_e1187].member[_e618];
                                                        if (_e624 < 9u) {
                                                        } else {
                                                            phi_3996_ = true;
                                                            break;
                                                        }
                                                        let _e1207 = global_1.member[_e1187].member[_e624];
                                                        if (_e630 < 9u) {
                                                        } else {
                                                            phi_3996_ = true;
                                                            break;
                                                        }
                                                        let _e1213 = global_1.member[_e1187].member[_e630];
                                                        let _e1215 = (3u + _e618);
                                                        if (_e1215 < 9u) {
                                                        } else {
                                                            phi_3996_ = true;
                                                            break;
                                                        }
                                                        let _e1221 = global_1.member[_e1187].member[_e1215];
                                                        let _e1222 = (3u + _e624);
                                                        if (_e1222 < 9u) {
                                                        } else {
                                                            phi_3996_ = true;
                                                            break;
                                                        }
                                                        let _e1228 = global_1.member[_e1187].member[_e1222];
                                                        let _e1229 = (3u + _e630);
                                                        if (_e1229 < 9u) {
                                                        } else {
                                                            phi_3996_ = true;
                                                            break;
                                                        }
                                                        let _e1235 = global_1.member[_e1187].member[_e1229];
                                                        let _e1237 = (6u + _e618);
                                                        if (_e1237 < 9u) {
                                                        } else {
                                                            phi_3996_ = true;
                                                            break;
                                                        }
                                                        let _e1243 = global_1.member[_e1187].member[_e1237];
                                                        let _e1244 = (6u + _e624);
                                                        if (_e1244 < 9u) {
                                                        } else {
                                                            phi_3996_ = true;
                                                            break;
                                                        }
                                                        let _e1250 = global_1.member[_e1187].member[_e1244];
                                                        let _e1251 = (6u + _e630);
                                                        if (_e1251 < 9u) {
                                                        } else {
                                                            phi_3996_ = true;
                                                            break;
                                                        }
                                                        let _e1257 = global_1.member[_e1187].member[_e1251];
                                                        phi_1430_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1201, _e1207, _e1213), array<f32, 3>(_e1221, _e1228, _e1235), array<f32, 3>(_e1243, _e1250, _e1257));
                                                    }
                                                    let _e1261 = phi_1430_;
                                                    let _e1270 = (_e1261[0][2] - _e456);
                                                    let _e1273 = (((_e1261[0][0] - _e323) * _e495) - (_e1270 * _e363));
                                                    let _e1276 = (((_e1261[0][1] - _e390) * _e495) - (_e1270 * _e429));
                                                    let _e1283 = (_e1261[1][2] - _e456);
                                                    let _e1286 = (((_e1261[1][0] - _e323) * _e495) - (_e1283 * _e363));
                                                    let _e1289 = (((_e1261[1][1] - _e390) * _e495) - (_e1283 * _e429));
                                                    let _e1296 = (_e1261[2][2] - _e456);
                                                    let _e1299 = (((_e1261[2][0] - _e323) * _e495) - (_e1296 * _e363));
                                                    let _e1302 = (((_e1261[2][1] - _e390) * _e495) - (_e1296 * _e429));
                                                    let _e1303 = (_e1299 * _e1289);
                                                    let _e1304 = (_e1302 * _e1286);
                                                    let _e1305 = (_e1273 * _e1302);
                                                    let _e1306 = (_e1276 * _e1299);
                                                    let _e1307 = (_e1286 * _e1276);
                                                    let _e1308 = (_e1289 * _e1273);
                                                    let _e1313 = (((_e1303 >= _e1304) && (_e1305 >= _e1306)) && (_e1307 >= _e1308));
                                                    if (_e1313 || (((_e1303 <= _e1304) && (_e1305 <= _e1306)) && (_e1307 <= _e1308))) {
                                                        let _e1320 = select(-1f, 1f, _e1313);
                                                        let _e1322 = ((_e1303 - _e1304) * _e1320);
                                                        let _e1324 = select(0f, _e1322, (_e1322 > 0f));
                                                        let _e1326 = ((_e1305 - _e1306) * _e1320);
                                                        let _e1328 = select(0f, _e1326, (_e1326 > 0f));
                                                        let _e1330 = ((_e1307 - _e1308) * _e1320);
                                                        let _e1332 = select(0f, _e1330, (_e1330 > 0f));
                                                        let _e1334 = ((_e1324 + _e1328) + _e1332);
                                                        if (_e1334 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2255_ = type_26();
                                                            phi_2256_ = true;
                                                            phi_2257_ = false;
                                                        } else {
                                                            let _e1337 = select(_e1286, _e1273, (_e1273 < _e1286));
                                                            if (select(_e1299, _e1337, (_e1337 < _e1299)) > 0f) {
                                                                phi_1547_ = true;
                                                            } else {
                                                                let _e1342 = select(_e1286, _e1273, (_e1273 > _e1286));
                                                                phi_1547_ = (select(_e1299, _e1342, (_e1342 > _e1299)) < 0f);
                                                            }
                                                            let _e1347 = phi_1547_;
                                                            if _e1347 {
                                                                phi_2252_ = type_26();
                                                                phi_2253_ = true;
                                                                phi_2254_ = false;
                                                            } else {
                                                                let _e1349 = select(_e1289, _e1276, (_e1276 < _e1289));
                                                                if (select(_e1302, _e1349, (_e1349 < _e1302)) > 0f) {
                                                                    phi_1576_ = true;
                                                                } else {
                                                                    let _e1354 = select(_e1289, _e1276, (_e1276 > _e1289));
                                                                    phi_1576_ = (select(_e1302, _e1354, (_e1354 > _e1302)) < 0f);
                                                                }
                                                                let _e1359 = phi_1576_;
                                                                if _e1359 {
                                                                    phi_2250_ = type_26();
                                                                    phi_2251_ = false;
                                                                } else {
                                                                    let _e1361 = select(_e1261[1][0], _e1261[0][0], (_e1261[0][0] < _e1261[1][0]));
                                                                    let _e1365 = select(_e1261[1][0], _e1261[0][0], (_e1261[0][0] > _e1261[1][0]));
                                                                    let _e1369 = select(_e1261[1][1], _e1261[0][1], (_e1261[0][1] < _e1261[1][1]));
                                                                    let _e1373 = select(_e1261[1][1], _e1261[0][1], (_e1261[0][1] > _e1261[1][1]));
                                                                    let _e1377 = select(_e1261[1][2], _e1261[0][2], (_e1261[0][2] < _e1261[1][2]));
                                                                    let _e1381 = select(_e1261[1][2], _e1261[0][2], (_e1261[0][2] > _e1261[1][2]));
                                                                    let _e1386 = ((select(_e1261[2][0], _e1361, (_e1361 < _e1261[2][0])) - _e361) * _e366);
                                                                    let _e1387 = ((select(_e1261[2][0], _e1365, (_e1365 > _e1261[2][0])) - _e362) * _e366);
                                                                    let _e1390 = ((select(_e1261[2][1], _e1369, (_e1369 < _e1261[2][1])) - _e427) * _e432);
                                                                    let _e1391 = ((select(_e1261[2][1], _e1373, (_e1373 > _e1261[2][1])) - _e428) * _e432);
                                                                    let _e1394 = ((select(_e1261[2][2], _e1377, (_e1377 < _e1261[2][2])) - _e493) * _e498);
                                                                    let _e1395 = ((select(_e1261[2][2], _e1381, (_e1381 > _e1261[2][2])) - _e494) * _e498);
                                                                    let _e1397 = select(_e1395, _e1394, (_e1394 < _e1395));
                                                                    let _e1399 = select(_e1395, _e1394, (_e1394 > _e1395));
                                                                    let _e1401 = select(_e1387, _e1386, (_e1386 < _e1387));
                                                                    let _e1403 = select(_e1391, _e1390, (_e1390 < _e1391));
                                                                    let _e1405 = select(_e1403, _e1401, (_e1401 > _e1403));
                                                                    let _e1407 = select(_e1397, _e1405, (_e1405 > _e1397));
                                                                    let _e1409 = select(_e1387, _e1386, (_e1386 > _e1387));
                                                                    let _e1411 = select(_e1391, _e1390, (_e1390 > _e1391));
                                                                    let _e1413 = select(_e1411, _e1409, (_e1409 < _e1411));
                                                                    let _e1415 = select(_e1399, _e1413, (_e1413 < _e1399));
                                                                    let _e1416 = -(_e1397);
                                                                    let _e1422 = select(_e609, _e1407, (_e1407 > _e609));
                                                                    if (_e1422 > (_e1415 + (select(_e1416, _e1399, (_e1399 > _e1416)) * 0.0000019073523f))) {
                                                                        phi_2245_ = type_26();
                                                                        phi_2246_ = true;
                                                                    } else {
                                                                        let _e1424 = (_e1422 > _e1159.member.member_1);
                                                                        if _e1424 {
                                                                            phi_2244_ = type_26();
                                                                        } else {
                                                                            let _e1425 = vec3<f32>(_e1261[0][0], _e1261[0][1], _e1261[0][2]);
                                                                            let _e1426 = vec3<f32>(_e1261[1][0], _e1261[1][1], _e1261[1][2]);
                                                                            let _e1427 = vec3<f32>(_e1261[2][0], _e1261[2][1], _e1261[2][2]);
                                                                            let _e1428 = (_e1261[1][0] - _e1261[0][0]);
                                                                            let _e1429 = (_e1261[1][1] - _e1261[0][1]);
                                                                            let _e1430 = (_e1261[1][2] - _e1261[0][2]);
                                                                            let _e1431 = vec3<f32>(_e1428, _e1429, _e1430);
                                                                            let _e1432 = (_e1261[2][0] - _e1261[1][0]);
                                                                            let _e1433 = (_e1261[2][1] - _e1261[1][1]);
                                                                            let _e1434 = (_e1261[2][2] - _e1261[1][2]);
                                                                            let _e1435 = vec3<f32>(_e1432, _e1433, _e1434);
                                                                            let _e1436 = (_e1261[0][0] - _e1261[2][0]);
                                                                            let _e1437 = (_e1261[0][1] - _e1261[2][1]);
                                                                            let _e1438 = (_e1261[0][2] - _e1261[2][2]);
                                                                            let _e1439 = vec3<f32>(_e1436, _e1437, _e1438);
                                                                            let _e1442 = bitcast<f32>((bitcast<u32>(_e1428) & 2147483647u));
                                                                            let _e1445 = bitcast<f32>((bitcast<u32>(_e1429) & 2147483647u));
                                                                            let _e1447 = select(_e1445, _e1442, (_e1442 > _e1445));
                                                                            let _e1450 = bitcast<f32>((bitcast<u32>(_e1430) & 2147483647u));
                                                                            let _e1452 = select(_e1450, _e1447, (_e1447 > _e1450));
                                                                            let _e1455 = bitcast<f32>((bitcast<u32>(_e1432) & 2147483647u));
                                                                            let _e1458 = bitcast<f32>((bitcast<u32>(_e1433) & 2147483647u));
                                                                            let _e1460 = select(_e1458, _e1455, (_e1455 > _e1458));
                                                                            let _e1463 = bitcast<f32>((bitcast<u32>(_e1434) & 2147483647u));
                                                                            let _e1465 = select(_e1463, _e1460, (_e1460 > _e1463));
                                                                            let _e1468 = bitcast<f32>((bitcast<u32>(_e1436) & 2147483647u));
                                                                            let _e1471 = bitcast<f32>((bitcast<u32>(_e1437) & 2147483647u));
                                                                            let _e1473 = select(_e1471, _e1468, (_e1468 > _e1471));
                                                                            let _e1476 = bitcast<f32>((bitcast<u32>(_e1438) & 2147483647u));
                                                                            let _e1478 = select(_e1476, _e1473, (_e1473 > _e1476));
                                                                            let _e1480 = select(_e1465, _e1452, (_e1452 > _e1465));
                                                                            let _e1482 = select(_e1478, _e1480, (_e1480 > _e1478));
                                                                            if (_e1452 == _e1482) {
                                                                                phi_1977_ = _e1289;
                                                                                phi_1978_ = _e1286;
                                                                                phi_1979_ = _e1276;
                                                                                phi_1980_ = _e1273;
                                                                                phi_1981_ = _e1425;
                                                                                phi_1982_ = _e1439;
                                                                                phi_1983_ = _e1435;
                                                                                phi_1984_ = _e1431;
                                                                            } else {
                                                                                let _e1484 = (_e1465 == _e1482);
                                                                                let _e1489 = vec3(_e1484);
                                                                                phi_1977_ = select(_e1276, _e1302, _e1484);
                                                                                phi_1978_ = select(_e1273, _e1299, _e1484);
                                                                                phi_1979_ = select(_e1302, _e1289, _e1484);
                                                                                phi_1980_ = select(_e1299, _e1286, _e1484);
                                                                                phi_1981_ = select(_e1427, _e1426, _e1489);
                                                                                phi_1982_ = select(_e1435, _e1431, _e1489);
                                                                                phi_1983_ = select(_e1431, _e1439, _e1489);
                                                                                phi_1984_ = select(_e1439, _e1435, _e1489);
                                                                            }
                                                                            let _e1495 = phi_1977_;
                                                                            let _e1497 = phi_1978_;
                                                                            let _e1499 = phi_1979_;
                                                                            let _e1501 = phi_1980_;
                                                                            let _e1503 = phi_1981_;
                                                                            let _e1505 = phi_1982_;
                                                                            let _e1507 = phi_1983_;
                                                                            let _e1509 = phi_1984_;
                                                                            let _e1516 = ((_e1507.y * _e1505.z) - (_e1505.y * _e1507.z));
                                                                            let _e1521 = ((_e1507.z * _e1505.x) - (_e1505.z * _e1507.x));
                                                                            let _e1524 = ((_e1507.x * _e1505.y) - (_e1505.x * _e1507.y));
                                                                            if (_e1324 >= _e1328) {
                                                                                phi_2015_ = select(true, false, (_e1324 >= _e1332));
                                                                            } else {
                                                                                phi_2015_ = true;
                                                                            }
                                                                            let _e1529 = phi_2015_;
                                                                            if _e1529 {
                                                                                phi_2024_ = select(_e1427, _e1426, vec3((_e1328 >= _e1332)));
                                                                            } else {
                                                                                phi_2024_ = _e1425;
                                                                            }
                                                                            let _e1534 = phi_2024_;
                                                                            let _e1545 = (((_e1516 * (_e1534.x - _e323)) + (_e1521 * (_e1534.y - _e390))) + (_e1524 * (_e1534.z - _e456)));
                                                                            let _e1550 = (((_e1516 * _e363) + (_e1521 * _e429)) + (_e1524 * _e495));
                                                                            let _e1551 = (_e1497 - _e1501);
                                                                            let _e1552 = (_e1495 - _e1499);
                                                                            let _e1560 = (-(((_e1501 * _e1551) + (_e1499 * _e1552))) / ((_e1551 * _e1551) + (_e1552 * _e1552)));
                                                                            let _e1562 = select(1f, _e1560, (_e1560 < 1f));
                                                                            let _e1564 = select(0f, _e1562, (_e1562 > 0f));
                                                                            let _e1577 = ((_e1503.x + (_e1509.x * _e1564)) - _e323);
                                                                            let _e1578 = ((_e1503.y + (_e1509.y * _e1564)) - _e390);
                                                                            let _e1579 = ((_e1503.z + (_e1509.z * _e1564)) - _e456);
                                                                            let _e1580 = (_e1579 / _e495);
                                                                            let _e1592 = bitcast<f32>((bitcast<u32>(_e1577) & 2147483647u));
                                                                            let _e1595 = bitcast<f32>((bitcast<u32>(_e1578) & 2147483647u));
                                                                            let _e1597 = select(_e1595, _e1592, (_e1592 > _e1595));
                                                                            let _e1600 = bitcast<f32>((bitcast<u32>(_e1579) & 2147483647u));
                                                                            let _e1602 = select(_e1600, _e1597, (_e1597 > _e1600));
                                                                            let _e1608 = bitcast<f32>((bitcast<u32>(_e1516) & 2147483647u));
                                                                            let _e1611 = bitcast<f32>((bitcast<u32>(_e1521) & 2147483647u));
                                                                            let _e1613 = select(_e1611, _e1608, (_e1608 > _e1611));
                                                                            let _e1616 = bitcast<f32>((bitcast<u32>(_e1524) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1516 * _e1577) + (_e1521 * _e1578)) + (_e1524 * _e1579)) - _e1545)) & 2147483647u)) <= ((0.0000009536743f * select(_e1482, _e1602, (_e1602 > _e1482))) * select(_e1616, _e1613, (_e1613 > _e1616)))) {
                                                                                let _e1626 = bitcast<f32>((bitcast<u32>(_e1507.x) & 2147483647u));
                                                                                let _e1629 = bitcast<f32>((bitcast<u32>(_e1507.y) & 2147483647u));
                                                                                let _e1631 = select(_e1629, _e1626, (_e1626 > _e1629));
                                                                                let _e1634 = bitcast<f32>((bitcast<u32>(_e1507.z) & 2147483647u));
                                                                                let _e1640 = bitcast<f32>((bitcast<u32>(_e1505.x) & 2147483647u));
                                                                                let _e1643 = bitcast<f32>((bitcast<u32>(_e1505.y) & 2147483647u));
                                                                                let _e1645 = select(_e1643, _e1640, (_e1640 > _e1643));
                                                                                let _e1648 = bitcast<f32>((bitcast<u32>(_e1505.z) & 2147483647u));
                                                                                let _e1652 = (bitcast<f32>((bitcast<u32>(_e1550) & 2147483647u)) > ((0.0000038146973f * select(_e1634, _e1631, (_e1631 > _e1634))) * select(_e1648, _e1645, (_e1645 > _e1648))));
                                                                                if _e1652 {
                                                                                    phi_2189_ = (_e1545 / _e1550);
                                                                                } else {
                                                                                    phi_2189_ = f32();
                                                                                }
                                                                                let _e1655 = phi_2189_;
                                                                                phi_2191_ = _e1655;
                                                                                phi_2192_ = select(true, false, _e1652);
                                                                            } else {
                                                                                phi_2191_ = f32();
                                                                                phi_2192_ = true;
                                                                            }
                                                                            let _e1658 = phi_2191_;
                                                                            let _e1660 = phi_2192_;
                                                                            if _e1660 {
                                                                                let _e1668 = (((_e1516 * (_e1577 - (_e363 * _e1580))) + (_e1521 * (_e1578 - (_e429 * _e1580)))) / _e1550);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1668) & 2147483647u)) <= _e1482) {
                                                                                    phi_2212_ = (_e1580 + _e1668);
                                                                                } else {
                                                                                    phi_2212_ = _e1580;
                                                                                }
                                                                                let _e1675 = phi_2212_;
                                                                                phi_2213_ = _e1675;
                                                                            } else {
                                                                                phi_2213_ = _e1658;
                                                                            }
                                                                            let _e1677 = phi_2213_;
                                                                            let _e1679 = select(_e1415, _e1677, (_e1677 < _e1415));
                                                                            let _e1681 = select(_e1407, _e1679, (_e1679 > _e1407));
                                                                            if (_e1681 >= _e609) {
                                                                                let _e1683 = (_e1681 <= _e1159.member.member_1);
                                                                                if _e1683 {
                                                                                    let _e1684 = (1f / _e1334);
                                                                                    phi_2236_ = type_26(_e1681, (_e1328 * _e1684), (_e1332 * _e1684), _e1194);
                                                                                } else {
                                                                                    phi_2236_ = type_26();
                                                                                }
                                                                                let _e1689 = phi_2236_;
                                                                                phi_2238_ = _e1689;
                                                                                phi_2239_ = select(true, false, _e1683);
                                                                            } else {
                                                                                phi_2238_ = type_26();
                                                                                phi_2239_ = true;
                                                                            }
                                                                            let _e1692 = phi_2238_;
                                                                            let _e1694 = phi_2239_;
                                                                            if _e1694 {
                                                                                phi_2243_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2243_ = _e1692;
                                                                            }
                                                                            let _e1696 = phi_2243_;
                                                                            phi_2244_ = _e1696;
                                                                        }
                                                                        let _e1698 = phi_2244_;
                                                                        phi_2245_ = _e1698;
                                                                        phi_2246_ = _e1424;
                                                                    }
                                                                    let _e1700 = phi_2245_;
                                                                    let _e1702 = phi_2246_;
                                                                    phi_2250_ = _e1700;
                                                                    phi_2251_ = _e1702;
                                                                }
                                                                let _e1704 = phi_2250_;
                                                                let _e1706 = phi_2251_;
                                                                phi_2252_ = _e1704;
                                                                phi_2253_ = _e1359;
                                                                phi_2254_ = _e1706;
                                                            }
                                                            let _e1708 = phi_2252_;
                                                            let _e1710 = phi_2253_;
                                                            let _e1712 = phi_2254_;
                                                            phi_2255_ = _e1708;
                                                            phi_2256_ = _e1710;
                                                            phi_2257_ = _e1712;
                                                        }
                                                        let _e1714 = phi_2255_;
                                                        let _e1716 = phi_2256_;
                                                        let _e1718 = phi_2257_;
                                                        phi_2265_ = _e1714;
                                                        phi_2266_ = select(_e1718, true, _e1716);
                                                    } else {
                                                        phi_2265_ = type_26();
                                                        phi_2266_ = true;
                                                    }
                                                    let _e1721 = phi_2265_;
                                                    let _e1723 = phi_2266_;
                                                    if _e1723 {
                                                        phi_2270_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2270_ = _e1721;
                                                    }
                                                    let _e1725 = phi_2270_;
                                                    if (_e1725.member_3 != 4294967295u) {
                                                        if (_e1194 != _e615) {
                                                            if (_e1725.member < _e1159.member.member.member) {
                                                                phi_2296_ = true;
                                                            } else {
                                                                if (_e1725.member == _e1159.member.member.member) {
                                                                    phi_2295_ = (_e1725.member_3 < _e1159.member.member.member_3);
                                                                } else {
                                                                    phi_2295_ = false;
                                                                }
                                                                let _e1740 = phi_2295_;
                                                                phi_2296_ = _e1740;
                                                            }
                                                            let _e1742 = phi_2296_;
                                                            if _e1742 {
                                                                phi_2303_ = type_46(type_42(_e1725, _e1725.member), _e1186.member_1, _e1186.member_2);
                                                            } else {
                                                                phi_2303_ = _e1186;
                                                            }
                                                            let _e1749 = phi_2303_;
                                                            phi_2304_ = _e1749;
                                                        } else {
                                                            phi_2304_ = _e1186;
                                                        }
                                                        let _e1751 = phi_2304_;
                                                        phi_2305_ = _e1751;
                                                    } else {
                                                        phi_2305_ = _e1186;
                                                    }
                                                    let _e1753 = phi_2305_;
                                                    phi_1292_ = _e1753;
                                                } else {
                                                    phi_1292_ = type_46();
                                                }
                                                let _e1755 = phi_1292_;
                                                continue;
                                                continuing {
                                                    phi_1291_ = _e1755;
                                                    phi_1294_ = _e1174;
                                                    phi_3996_ = _e656;
                                                    break if !(_e1180);
                                                }
                                            }
                                            let _e1758 = phi_3996_;
                                            phi_4156_ = _e1758;
                                            if _e1758 {
                                                break;
                                            }
                                            phi_4160_ = _e1758;
                                            let _e2093 = local_12;
                                            phi_3513_ = _e2093;
                                            phi_3514_ = _e698;
                                            phi_3515_ = false;
                                            phi_3516_ = _e702;
                                        } else {
                                            if (_e698.member_1 >= _e96) {
                                                phi_3069_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_53(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_53(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e698.member_1 < _e96) {
                                                } else {
                                                    phi_4156_ = true;
                                                    break;
                                                }
                                                let _e720 = ((1u + _e276) % 4u);
                                                if (_e720 < 4u) {
                                                } else {
                                                    phi_4156_ = true;
                                                    break;
                                                }
                                                let _e725 = global_4.member[_e698.member_1][_e720];
                                                let _e727 = (_e725 >> bitcast<u32>(11u));
                                                let _e729 = ((1u + _e275) % 4u);
                                                if (_e729 < 4u) {
                                                } else {
                                                    phi_4156_ = true;
                                                    break;
                                                }
                                                let _e734 = global_4.member[_e698.member_1][_e729];
                                                let _e736 = (_e734 >> bitcast<u32>(11u));
                                                let _e738 = ((1u + _e277) % 4u);
                                                if (_e738 < 4u) {
                                                } else {
                                                    phi_4156_ = true;
                                                    break;
                                                }
                                                let _e743 = global_4.member[_e698.member_1][_e738];
                                                let _e745 = (_e743 >> bitcast<u32>(11u));
                                                let _e768 = (bitcast<f32>((bitcast<u32>((_e698.member.member_1.x - _e698.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e769 = (bitcast<f32>((bitcast<u32>((_e698.member.member_1.y - _e698.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e770 = (bitcast<f32>((bitcast<u32>((_e698.member.member_1.z - _e698.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e772 = select(_e150, _e768, (_e768 > _e150));
                                                let _e774 = select(_e150, _e769, (_e769 > _e150));
                                                let _e776 = select(_e150, _e770, (_e770 > _e150));
                                                let _e807 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e725 & 1023u))) - 8388608f) * _e772));
                                                let _e812 = (bitcast<i32>((_e725 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e815 = bitcast<f32>((_e807 & bitcast<u32>(_e812)));
                                                let _e816 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e734 & 1023u))) - 8388608f) * _e774));
                                                let _e821 = (bitcast<i32>((_e734 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e824 = bitcast<f32>((_e816 & bitcast<u32>(_e821)));
                                                let _e825 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e743 & 1023u))) - 8388608f) * _e776));
                                                let _e830 = (bitcast<i32>((_e743 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e833 = bitcast<f32>((_e825 & bitcast<u32>(_e830)));
                                                let _e837 = bitcast<f32>((_e807 & bitcast<u32>(~(_e812))));
                                                let _e841 = bitcast<f32>((_e816 & bitcast<u32>(~(_e821))));
                                                let _e845 = bitcast<f32>((_e825 & bitcast<u32>(~(_e830))));
                                                let _e846 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e727 & 1023u))) - 8388608f) * _e772));
                                                let _e851 = (bitcast<i32>((_e727 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e854 = bitcast<f32>((_e846 & bitcast<u32>(_e851)));
                                                let _e855 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e736 & 1023u))) - 8388608f) * _e774));
                                                let _e860 = (bitcast<i32>((_e736 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e863 = bitcast<f32>((_e855 & bitcast<u32>(_e860)));
                                                let _e864 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e745 & 1023u))) - 8388608f) * _e776));
                                                let _e869 = (bitcast<i32>((_e745 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e872 = bitcast<f32>((_e864 & bitcast<u32>(_e869)));
                                                let _e876 = bitcast<f32>((_e846 & bitcast<u32>(~(_e851))));
                                                let _e880 = bitcast<f32>((_e855 & bitcast<u32>(~(_e860))));
                                                let _e884 = bitcast<f32>((_e864 & bitcast<u32>(~(_e869))));
                                                let _e914 = global_4.member[_e698.member_1][0u];
                                                let _e918 = global_4.member[_e698.member_1][1u];
                                                let _e922 = global_4.member[_e698.member_1][2u];
                                                let _e926 = global_4.member[_e698.member_1][3u];
                                                let _e938 = (((_e918 >> bitcast<u32>(22i)) | ((_e922 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e926 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e939 = (_e914 & 268435455u);
                                                let _e940 = (_e938 & 268435455u);
                                                let _e943 = ((_e914 >> bitcast<u32>(28u)) & 7u);
                                                let _e951 = ((_e914 >> bitcast<u32>(31i)) | (((_e938 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e952 = (_e943 != 0u);
                                                if (_e943 == 0u) {
                                                    phi_3031_ = _e939;
                                                } else {
                                                    if (_e943 == 7u) {
                                                        phi_3030_ = 2147483648u;
                                                    } else {
                                                        phi_3030_ = ((2147483648u | (_e943 << bitcast<u32>(28u))) | (_e940 & 268435455u));
                                                    }
                                                    let _e961 = phi_3030_;
                                                    phi_3031_ = _e961;
                                                }
                                                let _e963 = phi_3031_;
                                                if _e952 {
                                                    let _e964 = (_e943 != 7u);
                                                    if _e964 {
                                                        phi_3041_ = (_e940 + _e943);
                                                    } else {
                                                        phi_3041_ = u32();
                                                    }
                                                    let _e967 = phi_3041_;
                                                    phi_3043_ = _e967;
                                                    phi_3044_ = select(true, false, _e964);
                                                } else {
                                                    phi_3043_ = u32();
                                                    phi_3044_ = true;
                                                }
                                                let _e970 = phi_3043_;
                                                let _e972 = phi_3044_;
                                                if (_e951 == 0u) {
                                                    phi_3065_ = (_e939 + select(0u, 1u, !(_e952)));
                                                } else {
                                                    if (_e951 == 7u) {
                                                        phi_3064_ = 2147483648u;
                                                    } else {
                                                        phi_3064_ = ((2147483648u | (_e951 << bitcast<u32>(28u))) | (select(_e970, _e940, _e972) & 268435455u));
                                                    }
                                                    let _e985 = phi_3064_;
                                                    phi_3065_ = _e985;
                                                }
                                                let _e987 = phi_3065_;
                                                phi_3069_ = type_54(array<vec4<f32>, 3>(vec4<f32>((_e698.member.member.x + _e815), (_e698.member.member.x + _e837), (_e698.member.member_1.x - _e854), (_e698.member.member_1.x - _e876)), vec4<f32>((_e698.member.member.y + _e824), (_e698.member.member.y + _e841), (_e698.member.member_1.y - _e863), (_e698.member.member_1.y - _e880)), vec4<f32>((_e698.member.member.z + _e833), (_e698.member.member.z + _e845), (_e698.member.member_1.z - _e872), (_e698.member.member_1.z - _e884))), type_53(type_38((_e698.member.member + vec4<f32>(_e815, _e824, _e833, 0f)), (_e698.member.member_1 - vec4<f32>(_e854, _e863, _e872, 0f))), _e963), type_53(type_38((_e698.member.member + vec4<f32>(_e837, _e841, _e845, 0f)), (_e698.member.member_1 - vec4<f32>(_e876, _e880, _e884, 0f))), _e987));
                                            }
                                            let _e992 = phi_3069_;
                                            let _e1005 = ((_e992.member[0].x - _e361) * _e366);
                                            let _e1006 = ((_e992.member[0].y - _e361) * _e366);
                                            let _e1007 = ((_e992.member[0].z - _e362) * _e366);
                                            let _e1008 = ((_e992.member[0].w - _e362) * _e366);
                                            let _e1018 = ((_e992.member[1].x - _e427) * _e432);
                                            let _e1019 = ((_e992.member[1].y - _e427) * _e432);
                                            let _e1020 = ((_e992.member[1].z - _e428) * _e432);
                                            let _e1021 = ((_e992.member[1].w - _e428) * _e432);
                                            let _e1031 = ((_e992.member[2].x - _e493) * _e498);
                                            let _e1032 = ((_e992.member[2].y - _e493) * _e498);
                                            let _e1033 = ((_e992.member[2].z - _e494) * _e498);
                                            let _e1034 = ((_e992.member[2].w - _e494) * _e498);
                                            let _e1036 = select(_e1033, _e1031, (_e1031 < _e1033));
                                            let _e1038 = select(_e1034, _e1032, (_e1032 < _e1034));
                                            let _e1040 = select(_e1033, _e1031, (_e1031 > _e1033));
                                            let _e1042 = select(_e1034, _e1032, (_e1032 > _e1034));
                                            let _e1044 = select(_e1007, _e1005, (_e1005 < _e1007));
                                            let _e1046 = select(_e1008, _e1006, (_e1006 < _e1008));
                                            let _e1048 = select(_e1020, _e1018, (_e1018 < _e1020));
                                            let _e1050 = select(_e1021, _e1019, (_e1019 < _e1021));
                                            let _e1052 = select(_e1048, _e1044, (_e1044 > _e1048));
                                            let _e1054 = select(_e1050, _e1046, (_e1046 > _e1050));
                                            let _e1056 = select(_e1036, _e1052, (_e1052 > _e1036));
                                            let _e1058 = select(_e1038, _e1054, (_e1054 > _e1038));
                                            let _e1060 = select(_e1007, _e1005, (_e1005 > _e1007));
                                            let _e1062 = select(_e1008, _e1006, (_e1006 > _e1008));
                                            let _e1064 = select(_e1020, _e1018, (_e1018 > _e1020));
                                            let _e1066 = select(_e1021, _e1019, (_e1019 > _e1021));
                                            let _e1068 = select(_e1064, _e1060, (_e1060 < _e1064));
                                            let _e1070 = select(_e1066, _e1062, (_e1062 < _e1066));
                                            let _e1075 = -(_e1036);
                                            let _e1076 = -(_e1038);
                                            let _e1083 = (select(_e1040, _e1068, (_e1068 < _e1040)) + (select(_e1075, _e1040, (_e1040 > _e1075)) * 0.0000019073523f));
                                            let _e1084 = (select(_e1042, _e1070, (_e1070 < _e1042)) + (select(_e1076, _e1042, (_e1042 > _e1076)) * 0.0000019073523f));
                                            let _e1086 = select(_e609, _e1056, (_e1056 > _e609));
                                            let _e1088 = select(_e609, _e1058, (_e1058 > _e609));
                                            let _e1093 = (_e1086 <= select(_e658.member.member_1, _e1083, (_e1083 < _e658.member.member_1)));
                                            let _e1094 = (_e1088 <= select(_e658.member.member_1, _e1084, (_e1084 < _e658.member.member_1)));
                                            let _e1095 = (_e1086 <= _e1088);
                                            if _e1093 {
                                                if _e1094 {
                                                    if _e1095 {
                                                        phi_3413_ = _e992.member_2;
                                                    } else {
                                                        phi_3413_ = _e992.member_1;
                                                    }
                                                    let _e1099 = phi_3413_;
                                                    let _e1121 = (_e702 % 128u);
                                                    let _e1122 = (_e1121 < 128u);
                                                    if _e1122 {
                                                    } else {
                                                        phi_4156_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1121] = _e1099.member_1;
                                                    if _e1122 {
                                                    } else {
                                                        phi_4156_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1121] = _e1099.member.member.x;
                                                    if _e1122 {
                                                    } else {
                                                        phi_4156_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1121] = _e1099.member.member.y;
                                                    if _e1122 {
                                                    } else {
                                                        phi_4156_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1121] = _e1099.member.member.z;
                                                    if _e1122 {
                                                    } else {
                                                        phi_4156_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1121] = _e1099.member.member_1.x;
                                                    if _e1122 {
                                                    } else {
                                                        phi_4156_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1121] = _e1099.member.member_1.y;
                                                    if _e1122 {
                                                    } else {
                                                        phi_4156_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1121] = _e1099.member.member_1.z;
                                                    if _e1122 {
                                                    } else {
                                                        phi_4156_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1121] = select(_e1088, _e1086, (_e1086 > _e1088));
                                                    if _e1095 {
                                                        phi_3490_ = _e992.member_1;
                                                    } else {
                                                        phi_3490_ = _e992.member_2;
                                                    }
                                                    let _e1135 = phi_3490_;
                                                    phi_3491_ = _e1135;
                                                    phi_3492_ = (_e702 + 1u);
                                                } else {
                                                    phi_3491_ = type_53();
                                                    phi_3492_ = u32();
                                                }
                                                let _e1137 = phi_3491_;
                                                let _e1139 = phi_3492_;
                                                phi_3494_ = _e1137;
                                                phi_3495_ = _e1139;
                                                phi_3496_ = select(true, false, _e1094);
                                            } else {
                                                phi_3494_ = type_53();
                                                phi_3495_ = u32();
                                                phi_3496_ = true;
                                            }
                                            let _e1142 = phi_3494_;
                                            let _e1144 = phi_3495_;
                                            let _e1146 = phi_3496_;
                                            if _e1146 {
                                                if _e1093 {
                                                    phi_3505_ = _e992.member_1;
                                                } else {
                                                    phi_3505_ = _e992.member_2;
                                                }
                                                let _e1150 = phi_3505_;
                                                phi_3510_ = _e1150;
                                                phi_3511_ = select(_e1094, true, _e1093);
                                            } else {
                                                phi_3510_ = _e1142;
                                                phi_3511_ = _e700;
                                            }
                                            let _e1153 = phi_3510_;
                                            let _e1155 = phi_3511_;
                                            phi_4160_ = _e656;
                                            phi_3513_ = type_46(_e658.member, (_e658.member_1 + 1u), _e658.member_2);
                                            phi_3514_ = _e1153;
                                            phi_3515_ = _e1155;
                                            phi_3516_ = select(_e1144, _e702, _e1146);
                                        }
                                        let _e1760 = phi_4160_;
                                        let _e1762 = phi_3513_;
                                        let _e1764 = phi_3514_;
                                        let _e1766 = phi_3515_;
                                        let _e1768 = phi_3516_;
                                        phi_4159_ = _e1760;
                                        phi_3517_ = _e1762;
                                        phi_3518_ = _e1764;
                                        phi_3519_ = (_e662 - 1u);
                                        phi_3520_ = _e1766;
                                        phi_3521_ = _e1768;
                                    } else {
                                        phi_4159_ = _e656;
                                        phi_3517_ = _e658;
                                        phi_3518_ = _e698;
                                        phi_3519_ = _e662;
                                        phi_3520_ = _e700;
                                        phi_3521_ = _e702;
                                    }
                                    let _e1770 = phi_4159_;
                                    let _e1772 = phi_3517_;
                                    let _e1774 = phi_3518_;
                                    let _e1776 = phi_3519_;
                                    let _e1778 = phi_3520_;
                                    let _e1780 = phi_3521_;
                                    phi_4158_ = _e1770;
                                    phi_3522_ = _e1772;
                                    phi_3523_ = _e1774;
                                    phi_3524_ = _e1776;
                                    phi_3525_ = _e1778;
                                    phi_3526_ = _e1780;
                                } else {
                                    phi_4158_ = _e656;
                                    phi_3522_ = type_46();
                                    phi_3523_ = type_53();
                                    phi_3524_ = u32();
                                    phi_3525_ = bool();
                                    phi_3526_ = u32();
                                }
                                let _e1782 = phi_4158_;
                                let _e1784 = phi_3522_;
                                let _e1786 = phi_3523_;
                                let _e1788 = phi_3524_;
                                let _e1790 = phi_3525_;
                                let _e1792 = phi_3526_;
                                phi_4157_ = _e1782;
                                phi_1166_ = _e1784;
                                phi_1169_ = _e1786;
                                phi_1171_ = _e1788;
                                phi_1173_ = _e1790;
                                phi_1175_ = _e1792;
                                phi_3527_ = _e670;
                            } else {
                                phi_4157_ = _e656;
                                phi_1166_ = type_46();
                                phi_1169_ = type_53();
                                phi_1171_ = u32();
                                phi_1173_ = bool();
                                phi_1175_ = u32();
                                phi_3527_ = false;
                            }
                            let _e1794 = phi_4157_;
                            let _e1796 = phi_1166_;
                            let _e1798 = phi_1169_;
                            let _e1800 = phi_1171_;
                            let _e1802 = phi_1173_;
                            let _e1804 = phi_1175_;
                            let _e1806 = phi_3527_;
                            continue;
                            continuing {
                                phi_4002_ = _e1794;
                                phi_1165_ = _e1796;
                                phi_1168_ = _e1798;
                                phi_1170_ = _e1800;
                                phi_1172_ = _e1802;
                                phi_1174_ = _e1804;
                                phi_4156_ = _e1794;
                                break if !(_e1806);
                            }
                        }
                        let _e1809 = phi_4156_;
                        if _e1809 {
                            break;
                        }
                        let _e1811 = local_10;
                        if (_e1811.member.member.member_3 != 4294967295u) {
                            let _e1817 = bitcast<u32>(_e1811.member.member.member);
                            let _e1821 = (bitcast<i32>((_e1817 >> bitcast<u32>(23i))) & 255i);
                            let _e1822 = (_e1821 + _e278);
                            if (_e1821 == 255i) {
                                phi_3586_ = _e1811.member.member.member;
                            } else {
                                if (_e1821 > 0i) {
                                    if (_e1822 > 0i) {
                                        let _e1826 = (_e1822 < 255i);
                                        if _e1826 {
                                            phi_3565_ = bitcast<f32>((_e1817 + bitcast<u32>((_e278 << bitcast<u32>(23i)))));
                                        } else {
                                            phi_3565_ = f32();
                                        }
                                        let _e1833 = phi_3565_;
                                        phi_3567_ = _e1833;
                                        phi_3568_ = select(true, false, _e1826);
                                    } else {
                                        phi_3567_ = f32();
                                        phi_3568_ = true;
                                    }
                                    let _e1836 = phi_3567_;
                                    let _e1838 = phi_3568_;
                                    phi_3569_ = _e1836;
                                    phi_3570_ = _e1838;
                                } else {
                                    phi_3569_ = f32();
                                    phi_3570_ = true;
                                }
                                let _e1840 = phi_3569_;
                                let _e1842 = phi_3570_;
                                if _e1842 {
                                    let _e1843 = (_e1817 & 2147483648u);
                                    let _e1850 = ((_e1817 & 8388607u) | (select(0u, 1u, ((_e1817 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                    let _e1854 = (_e1850 == 0u);
                                    if _e1854 {
                                        phi_3954_ = bitcast<f32>(_e1843);
                                    } else {
                                        let _e1859 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1850)), 32u, _e1854) - 8u);
                                        let _e1862 = (_e1850 << bitcast<u32>((_e1859 & 31u)));
                                        let _e1864 = ((_e1822 + select(0i, 1i, (_e1821 == 0i))) - bitcast<i32>(_e1859));
                                        if (_e1864 >= 255i) {
                                            phi_3944_ = bitcast<f32>((_e1843 | 2139095040u));
                                            phi_3945_ = f32();
                                            phi_3946_ = true;
                                        } else {
                                            let _e1866 = (_e1864 > 0i);
                                            if _e1866 {
                                                phi_3938_ = bitcast<f32>(((_e1843 | (bitcast<u32>(_e1864) << bitcast<u32>(23i))) | (_e1862 & 8388607u)));
                                                phi_3939_ = f32();
                                            } else {
                                                if (_e1864 < -24i) {
                                                    phi_3904_ = 26u;
                                                } else {
                                                    phi_3904_ = bitcast<u32>((1i - _e1864));
                                                }
                                                let _e1871 = phi_3904_;
                                                let _e1872 = (_e1871 & 31u);
                                                let _e1874 = (_e1862 >> bitcast<u32>(_e1872));
                                                let _e1878 = (_e1862 & ((1u << bitcast<u32>(_e1872)) - 1u));
                                                let _e1882 = (1u << bitcast<u32>(((_e1871 - 1u) & 31u)));
                                                if (_e1878 > _e1882) {
                                                    phi_3925_ = true;
                                                } else {
                                                    if (_e1878 == _e1882) {
                                                        phi_3922_ = ((_e1874 & 1u) == 1u);
                                                    } else {
                                                        phi_3922_ = false;
                                                    }
                                                    let _e1888 = phi_3922_;
                                                    phi_3925_ = _e1888;
                                                }
                                                let _e1890 = phi_3925_;
                                                phi_3938_ = f32();
                                                phi_3939_ = bitcast<f32>((_e1843 | (_e1874 + select(0u, 1u, _e1890))));
                                            }
                                            let _e1903 = phi_3938_;
                                            let _e1905 = phi_3939_;
                                            phi_3944_ = _e1903;
                                            phi_3945_ = _e1905;
                                            phi_3946_ = _e1866;
                                        }
                                        let _e1909 = phi_3944_;
                                        let _e1911 = phi_3945_;
                                        let _e1913 = phi_3946_;
                                        phi_3954_ = select(_e1911, _e1909, _e1913);
                                    }
                                    let _e1917 = phi_3954_;
                                    phi_3585_ = _e1917;
                                } else {
                                    phi_3585_ = _e1840;
                                }
                                let _e1919 = phi_3585_;
                                phi_3586_ = _e1919;
                            }
                            let _e1921 = phi_3586_;
                            let _e1922 = bitcast<u32>(_e1921);
                            if ((_e1922 & 2147483647u) >= 2139095040u) {
                                phi_3598_ = bitcast<f32>(((_e1922 & 2147483648u) | 2139095039u));
                            } else {
                                phi_3598_ = _e1921;
                            }
                            let _e1929 = phi_3598_;
                            phi_3603_ = type_26(_e1929, _e1811.member.member.member_1, _e1811.member.member.member_2, _e1811.member.member.member_3);
                        } else {
                            phi_3603_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1934 = phi_3603_;
                        if _e154 {
                        } else {
                            break;
                        }
                        global_2.member[_e138] = _e1934;
                        let _e1938 = local_11;
                        if _e155 {
                        } else {
                            break;
                        }
                        global_6.member[_e138] = _e1938.member_1;
                        if _e153 {
                        } else {
                            break;
                        }
                        let _e1943 = select(0u, 1u, (_e222 <= _e232));
                        if (_e1943 > 0u) {
                            let _e1945 = (1u < _e106);
                            if _e1945 {
                                if (0u < _e106) {
                                } else {
                                    break;
                                }
                                let _e1949 = atomicAdd((&global_7.member[0u]), _e1943);
                                if ((_e1949 + _e1943) < _e1949) {
                                    if _e1945 {
                                    } else {
                                        break;
                                    }
                                    let _e1954 = atomicAdd((&global_7.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1957 = select(0u, 1u, (_e1934.member_3 != 4294967295u));
                        if (_e1957 > 0u) {
                            let _e1959 = (3u < _e106);
                            if _e1959 {
                                if (2u < _e106) {
                                } else {
                                    break;
                                }
                                let _e1963 = atomicAdd((&global_7.member[2u]), _e1957);
                                if ((_e1963 + _e1957) < _e1963) {
                                    if _e1959 {
                                    } else {
                                        break;
                                    }
                                    let _e1968 = atomicAdd((&global_7.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1938.member_1 > 0u) {
                            let _e1970 = (5u < _e106);
                            if _e1970 {
                                if (4u < _e106) {
                                } else {
                                    break;
                                }
                                let _e1974 = atomicAdd((&global_7.member[4u]), _e1938.member_1);
                                if ((_e1974 + _e1938.member_1) < _e1974) {
                                    if _e1970 {
                                    } else {
                                        break;
                                    }
                                    let _e1979 = atomicAdd((&global_7.member[5u]), 1u);
                                }
                            }
                        }
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_paths_counted_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
