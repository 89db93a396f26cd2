struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_14 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_16 {
    member: array<type_14>,
}

struct type_22 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_24 {
    member: array<type_22>,
}

struct type_26 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_27 {
    member: type_26,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_29 {
    member: array<type_27>,
}

struct type_34 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_38 {
    member: type_22,
    member_1: f32,
}

struct type_42 {
    member: type_38,
    member_1: u32,
    member_2: u32,
}

struct type_44 {
    member: array<vec4<u32>, 2>,
}

struct type_48 {
    member: array<array<u32, 7>>,
}

struct type_53 {
    member: type_34,
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
var<storage> global_1: type_16;
@group(0) @binding(4) 
var<storage, read_write> global_2: type_24;
@group(0) @binding(0) 
var<uniform> global_3: type_44;
@group(0) @binding(3) 
var<storage> global_4: type_29;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_6: type_59;
@group(0) @binding(1) 
var<storage> global_7: type_48;

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
    var phi_1165_: type_42;
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
    var phi_1291_: type_42;
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
    var phi_2236_: type_22;
    var phi_2238_: type_22;
    var phi_2239_: bool;
    var phi_2243_: type_22;
    var phi_2244_: type_22;
    var phi_2245_: type_22;
    var phi_2246_: bool;
    var phi_2250_: type_22;
    var phi_2251_: bool;
    var phi_2252_: type_22;
    var phi_2253_: bool;
    var phi_2254_: bool;
    var phi_2255_: type_22;
    var phi_2256_: bool;
    var phi_2257_: bool;
    var phi_2265_: type_22;
    var phi_2266_: bool;
    var phi_2270_: type_22;
    var phi_2295_: bool;
    var phi_2296_: bool;
    var phi_2303_: type_42;
    var phi_2304_: type_42;
    var phi_2305_: type_42;
    var phi_1292_: type_42;
    var phi_3996_: bool;
    var phi_4160_: bool;
    var phi_3513_: type_42;
    var phi_3514_: type_53;
    var phi_3515_: bool;
    var phi_3516_: u32;
    var phi_4159_: bool;
    var phi_3517_: type_42;
    var phi_3518_: type_53;
    var phi_3519_: u32;
    var phi_3520_: bool;
    var phi_3521_: u32;
    var phi_4158_: bool;
    var phi_3522_: type_42;
    var phi_3523_: type_53;
    var phi_3524_: u32;
    var phi_3525_: bool;
    var phi_3526_: u32;
    var phi_4157_: bool;
    var phi_1166_: type_42;
    var phi_1169_: type_53;
    var phi_1171_: u32;
    var phi_1173_: bool;
    var phi_1175_: u32;
    var phi_3527_: bool;
    var phi_4156_: bool;
    var local_10: type_42;
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
    var phi_3603_: type_22;
    var local_11: type_42;
    var local_12: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e92 = global;
            let _e94 = arrayLength((&global_7.member));
            let _e96 = arrayLength((&global_1.member));
            let _e104 = arrayLength((&global_6.member));
            let _e108 = global_3.member[0u][0u];
            let _e112 = global_3.member[0u][1u];
            let _e116 = global_3.member[0u][2u];
            let _e120 = global_3.member[0u][3u];
            let _e124 = global_3.member[1u][0u];
            let _e128 = global_3.member[1u][1u];
            let _e132 = global_3.member[1u][2u];
            let _e136 = (_e92.x + (_e92.y * 2097152u));
            let _e148 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e120) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e108), bitcast<i32>(_e112), bitcast<i32>(_e116));
            local = array<i32, 3>(bitcast<i32>(_e124), bitcast<i32>(_e128), bitcast<i32>(_e132));
            let _e151 = (_e136 < arrayLength((&global_4.member)));
            if _e151 {
                let _e152 = (_e136 < arrayLength((&global_2.member)));
                if _e152 {
                    let _e153 = (_e136 < arrayLength((&global_5.member)));
                    if _e153 {
                        if _e151 {
                        } else {
                            break;
                        }
                        let _e163 = global_4.member[_e136].member.member_2[0u];
                        let _e165 = (bitcast<u32>(_e163) & 2147483647u);
                        let _e171 = global_4.member[_e136].member.member_2[1u];
                        let _e173 = (bitcast<u32>(_e171) & 2147483647u);
                        let _e179 = global_4.member[_e136].member.member_2[2u];
                        let _e181 = (bitcast<u32>(_e179) & 2147483647u);
                        let _e187 = global_4.member[_e136].member.member[0u];
                        let _e189 = (bitcast<u32>(_e187) & 2147483647u);
                        let _e195 = global_4.member[_e136].member.member[1u];
                        let _e197 = (bitcast<u32>(_e195) & 2147483647u);
                        let _e203 = global_4.member[_e136].member.member[2u];
                        let _e205 = (bitcast<u32>(_e203) & 2147483647u);
                        let _e207 = select(_e173, _e165, (_e173 < _e165));
                        let _e209 = select(_e181, _e207, (_e181 < _e207));
                        let _e211 = select(_e189, _e209, (_e189 < _e209));
                        let _e213 = select(_e197, _e211, (_e197 < _e211));
                        let _e215 = select(_e205, _e213, (_e205 < _e213));
                        let _e220 = global_4.member[_e136].member.member_1;
                        let _e221 = bitcast<u32>(_e220);
                        let _e222 = (_e221 & 2147483647u);
                        let _e230 = global_4.member[_e136].member.member_3;
                        let _e231 = bitcast<u32>(_e230);
                        let _e232 = (_e231 & 2147483647u);
                        let _e236 = (((select(_e222, _e215, (_e222 < _e215)) < 2139095040u) && (_e232 <= 2139095040u)) && (_e209 > 0u));
                        if _e236 {
                            let _e239 = (bitcast<u32>(bitcast<f32>(_e209)) & 2147483647u);
                            if (_e239 >= 8388608u) {
                                phi_478_ = (bitcast<i32>((_e239 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_478_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e239)), 32u, (_e239 == 0u))));
                            }
                            let _e253 = phi_478_;
                            phi_479_ = _e253;
                        } else {
                            phi_479_ = 0i;
                        }
                        let _e255 = phi_479_;
                        let _e256 = (_e165 == _e209);
                        if _e256 {
                            phi_489_ = true;
                        } else {
                            phi_489_ = (_e173 == _e209);
                        }
                        let _e259 = phi_489_;
                        let _e260 = select(1u, 0u, _e256);
                        if _e259 {
                            let _e261 = (_e260 + 1u);
                            phi_499_ = _e261;
                            phi_500_ = _e261;
                            phi_502_ = select(true, false, (_e261 == 2u));
                        } else {
                            phi_499_ = u32();
                            phi_500_ = 0u;
                            phi_502_ = true;
                        }
                        let _e265 = phi_499_;
                        let _e267 = phi_500_;
                        let _e269 = phi_502_;
                        if _e269 {
                            phi_507_ = (_e267 + 1u);
                        } else {
                            phi_507_ = 0u;
                        }
                        let _e273 = phi_507_;
                        let _e274 = select(_e265, _e267, _e269);
                        let _e275 = select(_e260, select(2u, _e260, _e259), _e269);
                        let _e276 = -(_e255);
                        if (_e276 < -126i) {
                            phi_539_ = -126i;
                        } else {
                            phi_539_ = select(_e276, 127i, (_e276 > 127i));
                        }
                        let _e281 = phi_539_;
                        let _e286 = bitcast<f32>((bitcast<u32>((_e281 + 127i)) << bitcast<u32>(23i)));
                        let _e292 = bitcast<f32>((bitcast<u32>(((_e276 - _e281) + 127i)) << bitcast<u32>(23i)));
                        let _e297 = global_4.member[_e136].member.member;
                        let _e298 = (_e274 == 0u);
                        if _e298 {
                            phi_557_ = _e297[0];
                        } else {
                            phi_557_ = _e297[1];
                        }
                        let _e302 = phi_557_;
                        let _e303 = (_e274 == 2u);
                        if _e303 {
                            phi_563_ = _e297[2];
                        } else {
                            phi_563_ = _e302;
                        }
                        let _e306 = phi_563_;
                        let _e307 = bitcast<u32>(_e306);
                        let _e309 = ((_e307 & 2139095040u) != 0u);
                        let _e321 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e307 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e307 & 2147483648u))), _e306, _e309) * select(0.00000011920929f, 1f, _e309));
                        let _e322 = global_4.member[_e136].member.member_2;
                        if _e298 {
                            phi_603_ = _e322[0];
                        } else {
                            phi_603_ = _e322[1];
                        }
                        let _e326 = phi_603_;
                        if _e303 {
                            phi_609_ = _e322[2];
                        } else {
                            phi_609_ = _e326;
                        }
                        let _e329 = phi_609_;
                        let _e330 = bitcast<u32>(_e329);
                        let _e332 = ((_e330 & 2139095040u) != 0u);
                        let _e346 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e330 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e330 & 2147483648u))), _e329, _e332) * _e286) * select(0.00000011920929f, 1f, _e332)) * _e292);
                        let _e350 = (bitcast<f32>((bitcast<u32>(_e346) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e350 {
                            let _e354 = (bitcast<f32>((bitcast<u32>(_e321) & 2147483647u)) * 0.00000011920929f);
                            phi_661_ = select(0.00000000000011368684f, _e354, (_e354 > 0.00000000000011368684f));
                        } else {
                            phi_661_ = 0f;
                        }
                        let _e358 = phi_661_;
                        let _e359 = (_e321 + _e358);
                        let _e360 = (_e321 - _e358);
                        let _e361 = select(_e346, 0f, _e350);
                        if _e350 {
                            phi_672_ = 38685626000000000000000000f;
                        } else {
                            phi_672_ = (1f / _e346);
                        }
                        let _e364 = phi_672_;
                        let _e365 = (_e273 == 0u);
                        if _e365 {
                            phi_681_ = _e297[0];
                        } else {
                            phi_681_ = _e297[1];
                        }
                        let _e369 = phi_681_;
                        let _e370 = (_e273 == 2u);
                        if _e370 {
                            phi_687_ = _e297[2];
                        } else {
                            phi_687_ = _e369;
                        }
                        let _e373 = phi_687_;
                        let _e374 = bitcast<u32>(_e373);
                        let _e376 = ((_e374 & 2139095040u) != 0u);
                        let _e388 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e374 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e374 & 2147483648u))), _e373, _e376) * select(0.00000011920929f, 1f, _e376));
                        if _e365 {
                            phi_727_ = _e322[0];
                        } else {
                            phi_727_ = _e322[1];
                        }
                        let _e392 = phi_727_;
                        if _e370 {
                            phi_733_ = _e322[2];
                        } else {
                            phi_733_ = _e392;
                        }
                        let _e395 = phi_733_;
                        let _e396 = bitcast<u32>(_e395);
                        let _e398 = ((_e396 & 2139095040u) != 0u);
                        let _e412 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e396 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e396 & 2147483648u))), _e395, _e398) * _e286) * select(0.00000011920929f, 1f, _e398)) * _e292);
                        let _e416 = (bitcast<f32>((bitcast<u32>(_e412) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e416 {
                            let _e420 = (bitcast<f32>((bitcast<u32>(_e388) & 2147483647u)) * 0.00000011920929f);
                            phi_785_ = select(0.00000000000011368684f, _e420, (_e420 > 0.00000000000011368684f));
                        } else {
                            phi_785_ = 0f;
                        }
                        let _e424 = phi_785_;
                        let _e425 = (_e388 + _e424);
                        let _e426 = (_e388 - _e424);
                        let _e427 = select(_e412, 0f, _e416);
                        if _e416 {
                            phi_796_ = 38685626000000000000000000f;
                        } else {
                            phi_796_ = (1f / _e412);
                        }
                        let _e430 = phi_796_;
                        let _e431 = (_e275 == 0u);
                        if _e431 {
                            phi_805_ = _e297[0];
                        } else {
                            phi_805_ = _e297[1];
                        }
                        let _e435 = phi_805_;
                        let _e436 = (_e275 == 2u);
                        if _e436 {
                            phi_811_ = _e297[2];
                        } else {
                            phi_811_ = _e435;
                        }
                        let _e439 = phi_811_;
                        let _e440 = bitcast<u32>(_e439);
                        let _e442 = ((_e440 & 2139095040u) != 0u);
                        let _e454 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e440 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e440 & 2147483648u))), _e439, _e442) * select(0.00000011920929f, 1f, _e442));
                        if _e431 {
                            phi_851_ = _e322[0];
                        } else {
                            phi_851_ = _e322[1];
                        }
                        let _e458 = phi_851_;
                        if _e436 {
                            phi_857_ = _e322[2];
                        } else {
                            phi_857_ = _e458;
                        }
                        let _e461 = phi_857_;
                        let _e462 = bitcast<u32>(_e461);
                        let _e464 = ((_e462 & 2139095040u) != 0u);
                        let _e478 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e462 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e462 & 2147483648u))), _e461, _e464) * _e286) * select(0.00000011920929f, 1f, _e464)) * _e292);
                        let _e482 = (bitcast<f32>((bitcast<u32>(_e478) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e482 {
                            let _e486 = (bitcast<f32>((bitcast<u32>(_e454) & 2147483647u)) * 0.00000011920929f);
                            phi_909_ = select(0.00000000000011368684f, _e486, (_e486 > 0.00000000000011368684f));
                        } else {
                            phi_909_ = 0f;
                        }
                        let _e490 = phi_909_;
                        let _e491 = (_e454 + _e490);
                        let _e492 = (_e454 - _e490);
                        let _e493 = select(_e478, 0f, _e482);
                        if _e482 {
                            phi_920_ = 38685626000000000000000000f;
                        } else {
                            phi_920_ = (1f / _e478);
                        }
                        let _e496 = phi_920_;
                        let _e499 = bitcast<f32>((bitcast<u32>(_e321) & 2147483647u));
                        let _e502 = bitcast<f32>((bitcast<u32>(_e388) & 2147483647u));
                        let _e504 = select(_e502, _e499, (_e499 > _e502));
                        let _e507 = bitcast<f32>((bitcast<u32>(_e454) & 2147483647u));
                        if (_e236 && (select(_e507, _e504, (_e504 > _e507)) <= 1099511600000f)) {
                            let _e519 = ((_e222 & 8388607u) | (select(0u, 1u, ((_e222 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e522 = bitcast<i32>((_e222 >> bitcast<u32>(23i)));
                            let _e526 = (_e519 == 0u);
                            let _e529 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e519)), 32u, _e526)) - 8i);
                            if (_e522 == 255i) {
                                phi_975_ = 255i;
                            } else {
                                phi_975_ = (((_e522 + select(0i, 1i, (_e522 == 0i))) - _e529) + _e255);
                            }
                            let _e537 = phi_975_;
                            let _e547 = (_e537 <= 0i);
                            if _e547 {
                                phi_998_ = u32();
                            } else {
                                if _e526 {
                                    phi_997_ = u32();
                                } else {
                                    phi_997_ = select(((bitcast<u32>(_e537) << bitcast<u32>(23i)) | ((_e519 << bitcast<u32>(((_e529 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e537 >= 255i));
                                }
                                let _e551 = phi_997_;
                                phi_998_ = _e551;
                            }
                            let _e553 = phi_998_;
                            let _e565 = ((_e232 & 8388607u) | (select(0u, 1u, ((_e232 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e568 = bitcast<i32>((_e232 >> bitcast<u32>(23i)));
                            let _e572 = (_e565 == 0u);
                            let _e575 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e565)), 32u, _e572)) - 8i);
                            if (_e568 == 255i) {
                                phi_1035_ = 255i;
                            } else {
                                phi_1035_ = (((_e568 + select(0i, 1i, (_e568 == 0i))) - _e575) + _e255);
                            }
                            let _e583 = phi_1035_;
                            let _e593 = (_e583 <= 0i);
                            if _e593 {
                                phi_1058_ = u32();
                            } else {
                                if _e572 {
                                    phi_1057_ = u32();
                                } else {
                                    phi_1057_ = select(((bitcast<u32>(_e583) << bitcast<u32>(23i)) | ((_e565 << bitcast<u32>(((_e575 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e583 >= 255i));
                                }
                                let _e597 = phi_1057_;
                                phi_1058_ = _e597;
                            }
                            let _e599 = phi_1058_;
                            phi_1066_ = bitcast<f32>(((_e231 & 2147483648u) | select(_e599, 0u, select(_e572, true, _e593))));
                            phi_1067_ = bitcast<f32>(((_e221 & 2147483648u) | select(_e553, 0u, select(_e526, true, _e547))));
                        } else {
                            phi_1066_ = 0f;
                            phi_1067_ = 1f;
                        }
                        let _e605 = phi_1066_;
                        let _e607 = phi_1067_;
                        if _e151 {
                        } else {
                            break;
                        }
                        let _e613 = global_4.member[_e136].member_2;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e616 = (_e274 % 3u);
                        let _e617 = (_e616 < 3u);
                        if _e617 {
                        } else {
                            break;
                        }
                        let _e619 = local_1[_e616];
                        let _e622 = (_e273 % 3u);
                        let _e623 = (_e622 < 3u);
                        if _e623 {
                        } else {
                            break;
                        }
                        let _e625 = local_1[_e622];
                        let _e628 = (_e275 % 3u);
                        let _e629 = (_e628 < 3u);
                        if _e629 {
                        } else {
                            break;
                        }
                        let _e631 = local_1[_e628];
                        if _e617 {
                        } else {
                            break;
                        }
                        let _e636 = local[_e616];
                        if _e623 {
                        } else {
                            break;
                        }
                        let _e640 = local[_e622];
                        if _e629 {
                        } else {
                            break;
                        }
                        let _e644 = local[_e628];
                        phi_4002_ = false;
                        phi_1165_ = type_42(type_38(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e605), 0u, 0u);
                        phi_1168_ = type_53(type_34(vec4<f32>((f32(_e619) * _e148), (f32(_e625) * _e148), (f32(_e631) * _e148), 0f), vec4<f32>((f32(_e636) * _e148), (f32(_e640) * _e148), (f32(_e644) * _e148), 0f)), select(0u, 2147483648u, (_e94 == 0u)));
                        phi_1170_ = ((3u * _e94) + 1u);
                        phi_1172_ = (_e607 <= _e605);
                        phi_1174_ = 0u;
                        loop {
                            let _e654 = phi_4002_;
                            let _e656 = phi_1165_;
                            let _e658 = phi_1168_;
                            let _e660 = phi_1170_;
                            let _e662 = phi_1172_;
                            let _e664 = phi_1174_;
                            local_10 = _e656;
                            local_11 = _e656;
                            if _e662 {
                                phi_1185_ = true;
                            } else {
                                phi_1185_ = (_e664 > 0u);
                            }
                            let _e667 = phi_1185_;
                            if _e667 {
                                let _e668 = (_e660 > 0u);
                                if _e668 {
                                    if _e662 {
                                        phi_1271_ = _e658;
                                        phi_1272_ = _e662;
                                        phi_1273_ = _e664;
                                    } else {
                                        let _e669 = (_e664 - 1u);
                                        let _e670 = (_e669 % 128u);
                                        let _e671 = (_e670 < 128u);
                                        if _e671 {
                                        } else {
                                            phi_4156_ = true;
                                            break;
                                        }
                                        let _e673 = local_7[_e670];
                                        if _e671 {
                                        } else {
                                            phi_4156_ = true;
                                            break;
                                        }
                                        let _e675 = local_6[_e670];
                                        if _e671 {
                                        } else {
                                            phi_4156_ = true;
                                            break;
                                        }
                                        let _e677 = local_5[_e670];
                                        if _e671 {
                                        } else {
                                            phi_4156_ = true;
                                            break;
                                        }
                                        let _e679 = local_4[_e670];
                                        if _e671 {
                                        } else {
                                            phi_4156_ = true;
                                            break;
                                        }
                                        let _e681 = local_3[_e670];
                                        if _e671 {
                                        } else {
                                            phi_4156_ = true;
                                            break;
                                        }
                                        let _e683 = local_2[_e670];
                                        if _e671 {
                                        } else {
                                            phi_4156_ = true;
                                            break;
                                        }
                                        let _e688 = local_8[_e670];
                                        if _e671 {
                                        } else {
                                            phi_4156_ = true;
                                            break;
                                        }
                                        let _e691 = local_9[_e670];
                                        phi_1271_ = type_53(type_34(vec4<f32>(_e673, _e675, _e677, 0f), vec4<f32>(_e679, _e681, _e683, 0f)), _e688);
                                        phi_1272_ = (_e691 <= _e656.member.member_1);
                                        phi_1273_ = _e669;
                                    }
                                    let _e696 = phi_1271_;
                                    let _e698 = phi_1272_;
                                    let _e700 = phi_1273_;
                                    if _e698 {
                                        if ((_e696.member_1 & 2147483648u) != 0u) {
                                            phi_1291_ = _e656;
                                            phi_1294_ = type_7(0u, ((_e696.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1175 = phi_1291_;
                                                let _e1177 = phi_1294_;
                                                local_12 = _e1175;
                                                if (_e1177.member < _e1177.member_1) {
                                                    phi_1295_ = type_7((_e1177.member + 1u), _e1177.member_1);
                                                    phi_1317_ = type_7(1u, _e1177.member);
                                                } else {
                                                    phi_1295_ = _e1177;
                                                    phi_1317_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e1190 = phi_1295_;
                                                let _e1192 = phi_1317_;
                                                let _e1196 = (bitcast<i32>(_e1192.member) != 0i);
                                                if _e1196 {
                                                    let _e1202 = type_42(_e1175.member, _e1175.member_1, (_e1175.member_2 + 1u));
                                                    let _e1203 = ((_e696.member_1 & 268435455u) + _e1192.member_1);
                                                    let _e1204 = (_e1203 < _e96);
                                                    if _e1204 {
                                                        if _e1204 {
                                                        } else {
                                                            phi_3996_ = true;
                                                            break;
                                                        }
                                                        let _e1208 = global_1.member[_e1203].member_1;
                                                        phi_1341_ = _e1208;
                                                    } else {
                                                        phi_1341_ = 4294967295u;
                                                    }
                                                    let _e1210 = phi_1341_;
                                                    if (_e1203 >= _e96) {
                                                        phi_1430_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1204 {
                                                        } else {
                                                            phi_3996_ = true;
                                                            break;
                                                        }
                                                        if (_e616 < 9u) {
                                                        } else {
                                                            phi_3996_ = true;
                                                            break;
                                                        }
                                                        let _e1217 = global_1.member[_e1203].member[_e616];
                                                        if (_e622 < 9u) {
                                                        } else {
                                                            phi_3996_ = true;
                                                            break;
                                                        }
                                                        let _e1223 = global_1.member[_e1203].member[_e622];
                                                        if (_e628 < 9u) {
                                                        } else {
                                                            phi_3996_ = true;
                                                            break;
                                                        }
                                                        let _e1229 = global_1.member[_e1203].member[_e628];
                                                        let _e1231 = (3u + _e616);
                                                        if (_e1231 < 9u) {
                                                        } else {
                                                            phi_3996_ = true;
                                                            break;
                                                        }
                                                        let _e1237 = global_1.member[_e1203].member[_e1231];
                                                        let _e1238 = (3u + _e622);
                                                        if (_e1238 < 9u) {
                                                        } else {
                                                            phi_3996_ = true;
                                                            break;
                                                        }
                                                        let _e1244 = global_1.member[_e1203].member[_e1238];
                                                        let _e1245 = (3u + _e628);
                                                        if (_e1245 < 9u) {
                                                        } else {
                                                            phi_3996_ = true;
                                                            break;
                                                        }
                                                        let _e1251 = global_1.member[_e1203].member[_e1245];
                                                        let _e1253 = (6u + _e616);
                                                        if (_e1253 < 9u) {
                                                        } else {
                                                            phi_3996_ = true;
                                                            break;
                                                        }
                                                        let _e1259 = global_1.member[_e1203].member[_e1253];
                                                        let _e1260 = (6u + _e622);
                                                        if (_e1260 < 9u) {
                                                        } else {
                                                            phi_3996_ = true;
                                                            break;
                                                        }
                                                        let _e1266 = global_1.member[_e1203].member[_e1260];
                                                        let _e1267 = (6u + _e628);
                                                        if (_e1267 < 9u) {
                                                        } else {
                                                            phi_3996_ = true;
                                                            break;
                                                        }
                                                        let _e1273 = global_1.member[_e1203].member[_e1267];
                                                        phi_1430_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1217, _e1223, _e1229), array<f32, 3>(_e1237, _e1244, _e1251), array<f32, 3>(_e1259, _e1266, _e1273));
                                                    }
                                                    let _e1277 = phi_1430_;
                                                    let _e1286 = (_e1277[0][2] - _e454);
                                                    let _e1289 = (((_e1277[0][0] - _e321) * _e493) - (_e1286 * _e361));
                                                    let _e1292 = (((_e1277[0][1] - _e388) * _e493) - (_e1286 * _e427));
                                                    let _e1299 = (_e1277[1][2] - _e454);
                                                    let _e1302 = (((_e1277[1][0] - _e321) * _e493) - (_e1299 * _e361));
                                                    let _e1305 = (((_e1277[1][1] - _e388) * _e493) - (_e1299 * _e427));
                                                    let _e1312 = (_e1277[2][2] - _e454);
                                                    let _e1315 = (((_e1277[2][0] - _e321) * _e493) - (_e1312 * _e361));
                                                    let _e1318 = (((_e1277[2][1] - _e388) * _e493) - (_e1312 * _e427));
                                                    let _e1319 = (_e1315 * _e1305);
                                                    let _e1320 = (_e1318 * _e1302);
                                                    let _e1321 = (_e1289 * _e1318);
                                                    let _e1322 = (_e1292 * _e1315);
                                                    let _e1323 = (_e1302 * _e1292);
                                                    let _e1324 = (_e1305 * _e1289);
                                                    let _e1329 = (((_e1319 >= _e1320) && (_e1321 >= _e1322)) && (_e1323 >= _e1324));
                                                    if (_e1329 || (((_e1319 <= _e1320) && (_e1321 <= _e1322)) && (_e1323 <= _e1324))) {
                                                        let _e1336 = select(-1f, 1f, _e1329);
                                                        let _e1338 = ((_e1319 - _e1320) * _e1336);
                                                        let _e1340 = select(0f, _e1338, (_e1338 > 0f));
                                                        let _e1342 = ((_e1321 - _e1322) * _e1336);
                                                        let _e1344 = select(0f, _e1342, (_e1342 > 0f));
                                                        let _e1346 = ((_e1323 - _e1324) * _e1336);
                                                        let _e1348 = select(0f, _e1346, (_e1346 > 0f));
                                                        let _e1350 = ((_e1340 + _e1344) + _e1348);
                                                        if (_e1350 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2255_ = type_22();
                                                            phi_2256_ = true;
                                                            phi_2257_ = false;
                                                        } else {
                                                            let _e1353 = select(_e1302, _e1289, (_e1289 < _e1302));
                                                            if (select(_e1315, _e1353, (_e1353 < _e1315)) > 0f) {
                                                                phi_1547_ = true;
                                                            } else {
                                                                let _e1358 = select(_e1302, _e1289, (_e1289 > _e1302));
                                                                phi_1547_ = (select(_e1315, _e1358, (_e1358 > _e1315)) < 0f);
                                                            }
                                                            let _e1363 = phi_1547_;
                                                            if _e1363 {
                                                                phi_2252_ = type_22();
                                                                phi_2253_ = true;
                                                                phi_2254_ = false;
                                                            } else {
                                                                let _e1365 = select(_e1305, _e1292, (_e1292 < _e1305));
                                                                if (select(_e1318, _e1365, (_e1365 < _e1318)) > 0f) {
                                                                    phi_1576_ = true;
                                                                } else {
                                                                    let _e1370 = select(_e1305, _e1292, (_e1292 > _e1305));
                                                                    phi_1576_ = (select(_e1318, _e1370, (_e1370 > _e1318)) < 0f);
                                                                }
                                                                let _e1375 = phi_1576_;
                                                                if _e1375 {
                                                                    phi_2250_ = type_22();
                                                                    phi_2251_ = false;
                                                                } else {
                                                                    let _e1377 = select(_e1277[1][0], _e1277[0][0], (_e1277[0][0] < _e1277[1][0]));
                                                                    let _e1381 = select(_e1277[1][0], _e1277[0][0], (_e1277[0][0] > _e1277[1][0]));
                                                                    let _e1385 = select(_e1277[1][1], _e1277[0][1], (_e1277[0][1] < _e1277[1][1]));
                                                                    let _e1389 = select(_e1277[1][1], _e1277[0][1], (_e1277[0][1] > _e1277[1][1]));
                                                                    let _e1393 = select(_e1277[1][2], _e1277[0][2], (_e1277[0][2] < _e1277[1][2]));
                                                                    let _e1397 = select(_e1277[1][2], _e1277[0][2], (_e1277[0][2] > _e1277[1][2]));
                                                                    let _e1402 = ((select(_e1277[2][0], _e1377, (_e1377 < _e1277[2][0])) - _e359) * _e364);
                                                                    let _e1403 = ((select(_e1277[2][0], _e1381, (_e1381 > _e1277[2][0])) - _e360) * _e364);
                                                                    let _e1406 = ((select(_e1277[2][1], _e1385, (_e1385 < _e1277[2][1])) - _e425) * _e430);
                                                                    let _e1407 = ((select(_e1277[2][1], _e1389, (_e1389 > _e1277[2][1])) - _e426) * _e430);
                                                                    let _e1410 = ((select(_e1277[2][2], _e1393, (_e1393 < _e1277[2][2])) - _e491) * _e496);
                                                                    let _e1411 = ((select(_e1277[2][2], _e1397, (_e1397 > _e1277[2][2])) - _e492) * _e496);
                                                                    let _e1413 = select(_e1411, _e1410, (_e1410 < _e1411));
                                                                    let _e1415 = select(_e1411, _e1410, (_e1410 > _e1411));
                                                                    let _e1417 = select(_e1403, _e1402, (_e1402 < _e1403));
                                                                    let _e1419 = select(_e1407, _e1406, (_e1406 < _e1407));
                                                                    let _e1421 = select(_e1419, _e1417, (_e1417 > _e1419));
                                                                    let _e1423 = select(_e1413, _e1421, (_e1421 > _e1413));
                                                                    let _e1425 = select(_e1403, _e1402, (_e1402 > _e1403));
                                                                    let _e1427 = select(_e1407, _e1406, (_e1406 > _e1407));
                                                                    let _e1429 = select(_e1427, _e1425, (_e1425 < _e1427));
                                                                    let _e1431 = select(_e1415, _e1429, (_e1429 < _e1415));
                                                                    let _e1432 = -(_e1413);
                                                                    let _e1438 = select(_e607, _e1423, (_e1423 > _e607));
                                                                    if (_e1438 > (_e1431 + (select(_e1432, _e1415, (_e1415 > _e1432)) * 0.0000019073523f))) {
                                                                        phi_2245_ = type_22();
                                                                        phi_2246_ = true;
                                                                    } else {
                                                                        let _e1440 = (_e1438 > _e1175.member.member_1);
                                                                        if _e1440 {
                                                                            phi_2244_ = type_22();
                                                                        } else {
                                                                            let _e1441 = vec3<f32>(_e1277[0][0], _e1277[0][1], _e1277[0][2]);
                                                                            let _e1442 = vec3<f32>(_e1277[1][0], _e1277[1][1], _e1277[1][2]);
                                                                            let _e1443 = vec3<f32>(_e1277[2][0], _e1277[2][1], _e1277[2][2]);
                                                                            let _e1444 = (_e1277[1][0] - _e1277[0][0]);
                                                                            let _e1445 = (_e1277[1][1] - _e1277[0][1]);
                                                                            let _e1446 = (_e1277[1][2] - _e1277[0][2]);
                                                                            let _e1447 = vec3<f32>(_e1444, _e1445, _e1446);
                                                                            let _e1448 = (_e1277[2][0] - _e1277[1][0]);
                                                                            let _e1449 = (_e1277[2][1] - _e1277[1][1]);
                                                                            let _e1450 = (_e1277[2][2] - _e1277[1][2]);
                                                                            let _e1451 = vec3<f32>(_e1448, _e1449, _e1450);
                                                                            let _e1452 = (_e1277[0][0] - _e1277[2][0]);
                                                                            let _e1453 = (_e1277[0][1] - _e1277[2][1]);
                                                                            let _e1454 = (_e1277[0][2] - _e1277[2][2]);
                                                                            let _e1455 = vec3<f32>(_e1452, _e1453, _e1454);
                                                                            let _e1458 = bitcast<f32>((bitcast<u32>(_e1444) & 2147483647u));
                                                                            let _e1461 = bitcast<f32>((bitcast<u32>(_e1445) & 2147483647u));
                                                                            let _e1463 = select(_e1461, _e1458, (_e1458 > _e1461));
                                                                            let _e1466 = bitcast<f32>((bitcast<u32>(_e1446) & 2147483647u));
                                                                            let _e1468 = select(_e1466, _e1463, (_e1463 > _e1466));
                                                                            let _e1471 = bitcast<f32>((bitcast<u32>(_e1448) & 2147483647u));
                                                                            let _e1474 = bitcast<f32>((bitcast<u32>(_e1449) & 2147483647u));
                                                                            let _e1476 = select(_e1474, _e1471, (_e1471 > _e1474));
                                                                            let _e1479 = bitcast<f32>((bitcast<u32>(_e1450) & 2147483647u));
                                                                            let _e1481 = select(_e1479, _e1476, (_e1476 > _e1479));
                                                                            let _e1484 = bitcast<f32>((bitcast<u32>(_e1452) & 2147483647u));
                                                                            let _e1487 = bitcast<f32>((bitcast<u32>(_e1453) & 2147483647u));
                                                                            let _e1489 = select(_e1487, _e1484, (_e1484 > _e1487));
                                                                            let _e1492 = bitcast<f32>((bitcast<u32>(_e1454) & 2147483647u));
                                                                            let _e1494 = select(_e1492, _e1489, (_e1489 > _e1492));
                                                                            let _e1496 = select(_e1481, _e1468, (_e1468 > _e1481));
                                                                            let _e1498 = select(_e1494, _e1496, (_e1496 > _e1494));
                                                                            if (_e1468 == _e1498) {
                                                                                phi_1977_ = _e1305;
                                                                                phi_1978_ = _e1302;
                                                                                phi_1979_ = _e1292;
                                                                                phi_1980_ = _e1289;
                                                                                phi_1981_ = _e1441;
                                                                                phi_1982_ = _e1455;
                                                                                phi_1983_ = _e1451;
                                                                                phi_1984_ = _e1447;
                                                                            } else {
                                                                                let _e1500 = (_e1481 == _e1498);
                                                                                let _e1505 = vec3(_e1500);
                                                                                phi_1977_ = select(_e1292, _e1318, _e1500);
                                                                                phi_1978_ = select(_e1289, _e1315, _e1500);
                                                                                phi_1979_ = select(_e1318, _e1305, _e1500);
                                                                                phi_1980_ = select(_e1315, _e1302, _e1500);
                                                                                phi_1981_ = select(_e1443, _e1442, _e1505);
                                                                                phi_1982_ = select(_e1451, _e1447, _e1505);
                                                                                phi_1983_ = select(_e1447, _e1455, _e1505);
                                                                                phi_1984_ = select(_e1455, _e1451, _e1505);
                                                                            }
                                                                            let _e1511 = phi_1977_;
                                                                            let _e1513 = phi_1978_;
                                                                            let _e1515 = phi_1979_;
                                                                            let _e1517 = phi_1980_;
                                                                            let _e1519 = phi_1981_;
                                                                            let _e1521 = phi_1982_;
                                                                            let _e1523 = phi_1983_;
                                                                            let _e1525 = phi_1984_;
                                                                            let _e1532 = ((_e1523.y * _e1521.z) - (_e1521.y * _e1523.z));
                                                                            let _e1537 = ((_e1523.z * _e1521.x) - (_e1521.z * _e1523.x));
                                                                            let _e1540 = ((_e1523.x * _e1521.y) - (_e1521.x * _e1523.y));
                                                                            if (_e1340 >= _e1344) {
                                                                                phi_2015_ = select(true, false, (_e1340 >= _e1348));
                                                                            } else {
                                                                                phi_2015_ = true;
                                                                            }
                                                                            let _e1545 = phi_2015_;
                                                                            if _e1545 {
                                                                                phi_2024_ = select(_e1443, _e1442, vec3((_e1344 >= _e1348)));
                                                                            } else {
                                                                                phi_2024_ = _e1441;
                                                                            }
                                                                            let _e1550 = phi_2024_;
                                                                            let _e1561 = (((_e1532 * (_e1550.x - _e321)) + (_e1537 * (_e1550.y - _e388))) + (_e1540 * (_e1550.z - _e454)));
                                                                            let _e1566 = (((_e1532 * _e361) + (_e1537 * _e427)) + (_e1540 * _e493));
                                                                            let _e1567 = (_e1513 - _e1517);
                                                                            let _e1568 = (_e1511 - _e1515);
                                                                            let _e1576 = (-(((_e1517 * _e1567) + (_e1515 * _e1568))) / ((_e1567 * _e1567) + (_e1568 * _e1568)));
                                                                            let _e1578 = select(1f, _e1576, (_e1576 < 1f));
                                                                            let _e1580 = select(0f, _e1578, (_e1578 > 0f));
                                                                            let _e1593 = ((_e1519.x + (_e1525.x * _e1580)) - _e321);
                                                                            let _e1594 = ((_e1519.y + (_e1525.y * _e1580)) - _e388);
                                                                            let _e1595 = ((_e1519.z + (_e1525.z * _e1580)) - _e454);
                                                                            let _e1596 = (_e1595 / _e493);
                                                                            let _e1608 = bitcast<f32>((bitcast<u32>(_e1593) & 2147483647u));
                                                                            let _e1611 = bitcast<f32>((bitcast<u32>(_e1594) & 2147483647u));
                                                                            let _e1613 = select(_e1611, _e1608, (_e1608 > _e1611));
                                                                            let _e1616 = bitcast<f32>((bitcast<u32>(_e1595) & 2147483647u));
                                                                            let _e1618 = select(_e1616, _e1613, (_e1613 > _e1616));
                                                                            let _e1624 = bitcast<f32>((bitcast<u32>(_e1532) & 2147483647u));
                                                                            let _e1627 = bitcast<f32>((bitcast<u32>(_e1537) & 2147483647u));
                                                                            let _e1629 = select(_e1627, _e1624, (_e1624 > _e1627));
                                                                            let _e1632 = bitcast<f32>((bitcast<u32>(_e1540) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1532 * _e1593) + (_e1537 * _e1594)) + (_e1540 * _e1595)) - _e1561)) & 2147483647u)) <= ((0.0000009536743f * select(_e1498, _e1618, (_e1618 > _e1498))) * select(_e1632, _e1629, (_e1629 > _e1632)))) {
                                                                                let _e1642 = bitcast<f32>((bitcast<u32>(_e1523.x) & 2147483647u));
                                                                                let _e1645 = bitcast<f32>((bitcast<u32>(_e1523.y) & 2147483647u));
                                                                                let _e1647 = select(_e1645, _e1642, (_e1642 > _e1645));
                                                                                let _e1650 = bitcast<f32>((bitcast<u32>(_e1523.z) & 2147483647u));
                                                                                let _e1656 = bitcast<f32>((bitcast<u32>(_e1521.x) & 2147483647u));
                                                                                let _e1659 = bitcast<f32>((bitcast<u32>(_e1521.y) & 2147483647u));
                                                                                let _e1661 = select(_e1659, _e1656, (_e1656 > _e1659));
                                                                                let _e1664 = bitcast<f32>((bitcast<u32>(_e1521.z) & 2147483647u));
                                                                                let _e1668 = (bitcast<f32>((bitcast<u32>(_e1566) & 2147483647u)) > ((0.0000038146973f * select(_e1650, _e1647, (_e1647 > _e1650))) * select(_e1664, _e1661, (_e1661 > _e1664))));
                                                                                if _e1668 {
                                                                                    phi_2189_ = (_e1561 / _e1566);
                                                                                } else {
                                                                                    phi_2189_ = f32();
                                                                                }
                                                                                let _e1671 = phi_2189_;
                                                                                phi_2191_ = _e1671;
                                                                                phi_2192_ = select(true, false, _e1668);
                                                                            } else {
                                                                                phi_2191_ = f32();
                                                                                phi_2192_ = true;
                                                                            }
                                                                            let _e1674 = phi_2191_;
                                                                            let _e1676 = phi_2192_;
                                                                            if _e1676 {
                                                                                let _e1684 = (((_e1532 * (_e1593 - (_e361 * _e1596))) + (_e1537 * (_e1594 - (_e427 * _e1596)))) / _e1566);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1684) & 2147483647u)) <= _e1498) {
                                                                                    phi_2212_ = (_e1596 + _e1684);
                                                                                } else {
                                                                                    phi_2212_ = _e1596;
                                                                                }
                                                                                let _e1691 = phi_2212_;
                                                                                phi_2213_ = _e1691;
                                                                            } else {
                                                                                phi_2213_ = _e1674;
                                                                            }
                                                                            let _e1693 = phi_2213_;
                                                                            let _e1695 = select(_e1431, _e1693, (_e1693 < _e1431));
                                                                            let _e1697 = select(_e1423, _e1695, (_e1695 > _e1423));
                                                                            if (_e1697 >= _e607) {
                                                                                let _e1699 = (_e1697 <= _e1175.member.member_1);
                                                                                if _e1699 {
                                                                                    let _e1700 = (1f / _e1350);
                                                                                    phi_2236_ = type_22(_e1697, (_e1344 * _e1700), (_e1348 * _e1700), _e1210);
                                                                                } else {
                                                                                    phi_2236_ = type_22();
                                                                                }
                                                                                let _e1705 = phi_2236_;
                                                                                phi_2238_ = _e1705;
                                                                                phi_2239_ = select(true, false, _e1699);
                                                                            } else {
                                                                                phi_2238_ = type_22();
                                                                                phi_2239_ = true;
                                                                            }
                                                                            let _e1708 = phi_2238_;
                                                                            let _e1710 = phi_2239_;
                                                                            if _e1710 {
                                                                                phi_2243_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2243_ = _e1708;
                                                                            }
                                                                            let _e1712 = phi_2243_;
                                                                            phi_2244_ = _e1712;
                                                                        }
                                                                        let _e1714 = phi_2244_;
                                                                        phi_2245_ = _e1714;
                                                                        phi_2246_ = _e1440;
                                                                    }
                                                                    let _e1716 = phi_2245_;
                                                                    let _e1718 = phi_2246_;
                                                                    phi_2250_ = _e1716;
                                                                    phi_2251_ = _e1718;
                                                                }
                                                                let _e1720 = phi_2250_;
                                                                let _e1722 = phi_2251_;
                                                                phi_2252_ = _e1720;
                                                                phi_2253_ = _e1375;
                                                                phi_2254_ = _e1722;
                                                            }
                                                            let _e1724 = phi_2252_;
                                                            let _e1726 = phi_2253_;
                                                            let _e1728 = phi_2254_;
                                                            phi_2255_ = _e1724;
                                                            phi_2256_ = _e1726;
                                                            phi_2257_ = _e1728;
                                                        }
                                                        let _e1730 = phi_2255_;
                                                        let _e1732 = phi_2256_;
                                                        let _e1734 = phi_2257_;
                                                        phi_2265_ = _e1730;
                                                        phi_2266_ = select(_e1734, true, _e1732);
                                                    } else {
                                                        phi_2265_ = type_22();
                                                        phi_2266_ = true;
                                                    }
                                                    let _e1737 = phi_2265_;
                                                    let _e1739 = phi_2266_;
                                                    if _e1739 {
                                                        phi_2270_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2270_ = _e1737;
                                                    }
                                                    let _e1741 = phi_2270_;
                                                    if (_e1741.member_3 != 4294967295u) {
                                                        if (_e1210 != _e613) {
                                                            if (_e1741.member < _e1175.member.member.member) {
                                                                phi_2296_ = true;
                                                            } else {
                                                                if (_e1741.member == _e1175.member.member.member) {
                                                                    phi_2295_ = (_e1741.member_3 < _e1175.member.member.member_3);
                                                                } else {
                                                                    phi_2295_ = false;
                                                                }
                                                                let _e1756 = phi_2295_;
                                                                phi_2296_ = _e1756;
                                                            }
                                                            let _e1758 = phi_2296_;
                                                            if _e1758 {
                                                                phi_2303_ = type_42(type_38(_e1741, _e1741.member), _e1202.member_1, _e1202.member_2);
                                                            } else {
                                                                phi_2303_ = _e1202;
                                                            }
                                                            let _e1765 = phi_2303_;
                                                            phi_2304_ = _e1765;
                                                        } else {
                                                            phi_2304_ = _e1202;
                                                        }
                                                        let _e1767 = phi_2304_;
                                                        phi_2305_ = _e1767;
                                                    } else {
                                                        phi_2305_ = _e1202;
                                                    }
                                                    let _e1769 = phi_2305_;
                                                    phi_1292_ = _e1769;
                                                } else {
                                                    phi_1292_ = type_42();
                                                }
                                                let _e1771 = phi_1292_;
                                                continue;
                                                continuing {
                                                    phi_1291_ = _e1771;
                                                    phi_1294_ = _e1190;
                                                    phi_3996_ = _e654;
                                                    break if !(_e1196);
                                                }
                                            }
                                            let _e1774 = phi_3996_;
                                            phi_4156_ = _e1774;
                                            if _e1774 {
                                                break;
                                            }
                                            phi_4160_ = _e1774;
                                            let _e2109 = local_12;
                                            phi_3513_ = _e2109;
                                            phi_3514_ = _e696;
                                            phi_3515_ = false;
                                            phi_3516_ = _e700;
                                        } else {
                                            if (_e696.member_1 >= _e94) {
                                                phi_3069_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_53(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_53(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e696.member_1 < _e94) {
                                                } else {
                                                    phi_4156_ = true;
                                                    break;
                                                }
                                                let _e717 = (_e274 * 2u);
                                                let _e719 = ((1u + _e717) % 7u);
                                                if (_e719 < 7u) {
                                                } else {
                                                    phi_4156_ = true;
                                                    break;
                                                }
                                                let _e724 = global_7.member[_e696.member_1][_e719];
                                                let _e726 = ((_e717 + 2u) % 7u);
                                                if (_e726 < 7u) {
                                                } else {
                                                    phi_4156_ = true;
                                                    break;
                                                }
                                                let _e731 = global_7.member[_e696.member_1][_e726];
                                                let _e732 = (_e273 * 2u);
                                                let _e734 = ((1u + _e732) % 7u);
                                                if (_e734 < 7u) {
                                                } else {
                                                    phi_4156_ = true;
                                                    break;
                                                }
                                                let _e739 = global_7.member[_e696.member_1][_e734];
                                                let _e741 = ((_e732 + 2u) % 7u);
                                                if (_e741 < 7u) {
                                                } else {
                                                    phi_4156_ = true;
                                                    break;
                                                }
                                                let _e746 = global_7.member[_e696.member_1][_e741];
                                                let _e747 = (_e275 * 2u);
                                                let _e749 = ((1u + _e747) % 7u);
                                                if (_e749 < 7u) {
                                                } else {
                                                    phi_4156_ = true;
                                                    break;
                                                }
                                                let _e754 = global_7.member[_e696.member_1][_e749];
                                                let _e756 = ((_e747 + 2u) % 7u);
                                                if (_e756 < 7u) {
                                                } else {
                                                    phi_4156_ = true;
                                                    break;
                                                }
                                                let _e761 = global_7.member[_e696.member_1][_e756];
                                                let _e784 = (bitcast<f32>((bitcast<u32>((_e696.member.member_1.x - _e696.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e785 = (bitcast<f32>((bitcast<u32>((_e696.member.member_1.y - _e696.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e786 = (bitcast<f32>((bitcast<u32>((_e696.member.member_1.z - _e696.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e788 = select(_e148, _e784, (_e784 > _e148));
                                                let _e790 = select(_e148, _e785, (_e785 > _e148));
                                                let _e792 = select(_e148, _e786, (_e786 > _e148));
                                                let _e823 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e724 & 2097151u))) - 8388608f) * _e788));
                                                let _e828 = (bitcast<i32>((_e724 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e831 = bitcast<f32>((_e823 & bitcast<u32>(_e828)));
                                                let _e832 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e739 & 2097151u))) - 8388608f) * _e790));
                                                let _e837 = (bitcast<i32>((_e739 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e840 = bitcast<f32>((_e832 & bitcast<u32>(_e837)));
                                                let _e841 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e754 & 2097151u))) - 8388608f) * _e792));
                                                let _e846 = (bitcast<i32>((_e754 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e849 = bitcast<f32>((_e841 & bitcast<u32>(_e846)));
                                                let _e853 = bitcast<f32>((_e823 & bitcast<u32>(~(_e828))));
                                                let _e857 = bitcast<f32>((_e832 & bitcast<u32>(~(_e837))));
                                                let _e861 = bitcast<f32>((_e841 & bitcast<u32>(~(_e846))));
                                                let _e862 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e731 & 2097151u))) - 8388608f) * _e788));
                                                let _e867 = (bitcast<i32>((_e731 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e870 = bitcast<f32>((_e862 & bitcast<u32>(_e867)));
                                                let _e871 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e746 & 2097151u))) - 8388608f) * _e790));
                                                let _e876 = (bitcast<i32>((_e746 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e879 = bitcast<f32>((_e871 & bitcast<u32>(_e876)));
                                                let _e880 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e761 & 2097151u))) - 8388608f) * _e792));
                                                let _e885 = (bitcast<i32>((_e761 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e888 = bitcast<f32>((_e880 & bitcast<u32>(_e885)));
                                                let _e892 = bitcast<f32>((_e862 & bitcast<u32>(~(_e867))));
                                                let _e896 = bitcast<f32>((_e871 & bitcast<u32>(~(_e876))));
                                                let _e900 = bitcast<f32>((_e880 & bitcast<u32>(~(_e885))));
                                                let _e930 = global_7.member[_e696.member_1][0u];
                                                let _e934 = global_7.member[_e696.member_1][2u];
                                                let _e938 = global_7.member[_e696.member_1][4u];
                                                let _e942 = global_7.member[_e696.member_1][6u];
                                                let _e954 = (((_e934 >> bitcast<u32>(22i)) | ((_e938 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e942 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e955 = (_e930 & 268435455u);
                                                let _e956 = (_e954 & 268435455u);
                                                let _e959 = ((_e930 >> bitcast<u32>(28u)) & 7u);
                                                let _e967 = ((_e930 >> bitcast<u32>(31i)) | (((_e954 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e968 = (_e959 != 0u);
                                                if (_e959 == 0u) {
                                                    phi_3031_ = _e955;
                                                } else {
                                                    if (_e959 == 7u) {
                                                        phi_3030_ = 2147483648u;
                                                    } else {
                                                        phi_3030_ = ((2147483648u | (_e959 << bitcast<u32>(28u))) | (_e956 & 268435455u));
                                                    }
                                                    let _e977 = phi_3030_;
                                                    phi_3031_ = _e977;
                                                }
                                                let _e979 = phi_3031_;
                                                if _e968 {
                                                    let _e980 = (_e959 != 7u);
                                                    if _e980 {
                                                        phi_3041_ = (_e956 + _e959);
                                                    } else {
                                                        phi_3041_ = u32();
                                                    }
                                                    let _e983 = phi_3041_;
                                                    phi_3043_ = _e983;
                                                    phi_3044_ = select(true, false, _e980);
                                                } else {
                                                    phi_3043_ = u32();
                                                    phi_3044_ = true;
                                                }
                                                let _e986 = phi_3043_;
                                                let _e988 = phi_3044_;
                                                if (_e967 == 0u) {
                                                    phi_3065_ = (_e955 + select(0u, 1u, !(_e968)));
                                                } else {
                                                    if (_e967 == 7u) {
                                                        phi_3064_ = 2147483648u;
                                                    } else {
                                                        phi_3064_ = ((2147483648u | (_e967 << bitcast<u32>(28u))) | (select(_e986, _e956, _e988) & 268435455u));
                                                    }
                                                    let _e1001 = phi_3064_;
                                                    phi_3065_ = _e1001;
                                                }
                                                let _e1003 = phi_3065_;
                                                phi_3069_ = type_54(array<vec4<f32>, 3>(vec4<f32>((_e696.member.member.x + _e831), (_e696.member.member.x + _e853), (_e696.member.member_1.x - _e870), (_e696.member.member_1.x - _e892)), vec4<f32>((_e696.member.member.y + _e840), (_e696.member.member.y + _e857), (_e696.member.member_1.y - _e879), (_e696.member.member_1.y - _e896)), vec4<f32>((_e696.member.member.z + _e849), (_e696.member.member.z + _e861), (_e696.member.member_1.z - _e888), (_e696.member.member_1.z - _e900))), type_53(type_34((_e696.member.member + vec4<f32>(_e831, _e840, _e849, 0f)), (_e696.member.member_1 - vec4<f32>(_e870, _e879, _e888, 0f))), _e979), type_53(type_34((_e696.member.member + vec4<f32>(_e853, _e857, _e861, 0f)), (_e696.member.member_1 - vec4<f32>(_e892, _e896, _e900, 0f))), _e1003));
                                            }
                                            let _e1008 = phi_3069_;
                                            let _e1021 = ((_e1008.member[0].x - _e359) * _e364);
                                            let _e1022 = ((_e1008.member[0].y - _e359) * _e364);
                                            let _e1023 = ((_e1008.member[0].z - _e360) * _e364);
                                            let _e1024 = ((_e1008.member[0].w - _e360) * _e364);
                                            let _e1034 = ((_e1008.member[1].x - _e425) * _e430);
                                            let _e1035 = ((_e1008.member[1].y - _e425) * _e430);
                                            let _e1036 = ((_e1008.member[1].z - _e426) * _e430);
                                            let _e1037 = ((_e1008.member[1].w - _e426) * _e430);
                                            let _e1047 = ((_e1008.member[2].x - _e491) * _e496);
                                            let _e1048 = ((_e1008.member[2].y - _e491) * _e496);
                                            let _e1049 = ((_e1008.member[2].z - _e492) * _e496);
                                            let _e1050 = ((_e1008.member[2].w - _e492) * _e496);
                                            let _e1052 = select(_e1049, _e1047, (_e1047 < _e1049));
                                            let _e1054 = select(_e1050, _e1048, (_e1048 < _e1050));
                                            let _e1056 = select(_e1049, _e1047, (_e1047 > _e1049));
                                            let _e1058 = select(_e1050, _e1048, (_e1048 > _e1050));
                                            let _e1060 = select(_e1023, _e1021, (_e1021 < _e1023));
                                            let _e1062 = select(_e1024, _e1022, (_e1022 < _e1024));
                                            let _e1064 = select(_e1036, _e1034, (_e1034 < _e1036));
                                            let _e1066 = select(_e1037, _e1035, (_e1035 < _e1037));
                                            let _e1068 = select(_e1064, _e1060, (_e1060 > _e1064));
                                            let _e1070 = select(_e1066, _e1062, (_e1062 > _e1066));
                                            let _e1072 = select(_e1052, _e1068, (_e1068 > _e1052));
                                            let _e1074 = select(_e1054, _e1070, (_e1070 > _e1054));
                                            let _e1076 = select(_e1023, _e1021, (_e1021 > _e1023));
                                            let _e1078 = select(_e1024, _e1022, (_e1022 > _e1024));
                                            let _e1080 = select(_e1036, _e1034, (_e1034 > _e1036));
                                            let _e1082 = select(_e1037, _e1035, (_e1035 > _e1037));
                                            let _e1084 = select(_e1080, _e1076, (_e1076 < _e1080));
                                            let _e1086 = select(_e1082, _e1078, (_e1078 < _e1082));
                                            let _e1091 = -(_e1052);
                                            let _e1092 = -(_e1054);
                                            let _e1099 = (select(_e1056, _e1084, (_e1084 < _e1056)) + (select(_e1091, _e1056, (_e1056 > _e1091)) * 0.0000019073523f));
                                            let _e1100 = (select(_e1058, _e1086, (_e1086 < _e1058)) + (select(_e1092, _e1058, (_e1058 > _e1092)) * 0.0000019073523f));
                                            let _e1102 = select(_e607, _e1072, (_e1072 > _e607));
                                            let _e1104 = select(_e607, _e1074, (_e1074 > _e607));
                                            let _e1109 = (_e1102 <= select(_e656.member.member_1, _e1099, (_e1099 < _e656.member.member_1)));
                                            let _e1110 = (_e1104 <= select(_e656.member.member_1, _e1100, (_e1100 < _e656.member.member_1)));
                                            let _e1111 = (_e1102 <= _e1104);
                                            if _e1109 {
                                                if _e1110 {
                                                    if _e1111 {
                                                        phi_3413_ = _e1008.member_2;
                                                    } else {
                                                        phi_3413_ = _e1008.member_1;
                                                    }
                                                    let _e1115 = phi_3413_;
                                                    let _e1137 = (_e700 % 128u);
                                                    let _e1138 = (_e1137 < 128u);
                                                    if _e1138 {
                                                    } else {
                                                        phi_4156_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1137] = _e1115.member_1;
                                                    if _e1138 {
                                                    } else {
                                                        phi_4156_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1137] = _e1115.member.member.x;
                                                    if _e1138 {
                                                    } else {
                                                        phi_4156_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1137] = _e1115.member.member.y;
                                                    if _e1138 {
                                                    } else {
                                                        phi_4156_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1137] = _e1115.member.member.z;
                                                    if _e1138 {
                                                    } else {
                                                        phi_4156_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1137] = _e1115.member.member_1.x;
                                                    if _e1138 {
                                                    } else {
                                                        phi_4156_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1137] = _e1115.member.member_1.y;
                                                    if _e1138 {
                                                    } else {
                                                        phi_4156_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1137] = _e1115.member.member_1.z;
                                                    if _e1138 {
                                                    } else {
                                                        phi_4156_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1137] = select(_e1104, _e1102, (_e1102 > _e1104));
                                                    if _e1111 {
                                                        phi_3490_ = _e1008.member_1;
                                                    } else {
                                                        phi_3490_ = _e1008.member_2;
                                                    }
                                                    let _e1151 = phi_3490_;
                                                    phi_3491_ = _e1151;
                                                    phi_3492_ = (_e700 + 1u);
                                                } else {
                                                    phi_3491_ = type_53();
                                                    phi_3492_ = u32();
                                                }
                                                let _e1153 = phi_3491_;
                                                let _e1155 = phi_3492_;
                                                phi_3494_ = _e1153;
                                                phi_3495_ = _e1155;
                                                phi_3496_ = select(true, false, _e1110);
                                            } else {
                                                phi_3494_ = type_53();
                                                phi_3495_ = u32();
                                                phi_3496_ = true;
                                            }
                                            let _e1158 = phi_3494_;
                                            let _e1160 = phi_3495_;
                                            let _e1162 = phi_3496_;
                                            if _e1162 {
                                                if _e1109 {
                                                    phi_3505_ = _e1008.member_1;
                                                } else {
                                                    phi_3505_ = _e1008.member_2;
                                                }
                                                let _e1166 = phi_3505_;
                                                phi_3510_ = _e1166;
                                                phi_3511_ = select(_e1110, true, _e1109);
                                            } else {
                                                phi_3510_ = _e1158;
                                                phi_3511_ = _e698;
                                            }
                                            let _e1169 = phi_3510_;
                                            let _e1171 = phi_3511_;
                                            phi_4160_ = _e654;
                                            phi_3513_ = type_42(_e656.member, (_e656.member_1 + 1u), _e656.member_2);
                                            phi_3514_ = _e1169;
                                            phi_3515_ = _e1171;
                                            phi_3516_ = select(_e1160, _e700, _e1162);
                                        }
                                        let _e1776 = phi_4160_;
                                        let _e1778 = phi_3513_;
                                        let _e1780 = phi_3514_;
                                        let _e1782 = phi_3515_;
                                        let _e1784 = phi_3516_;
                                        phi_4159_ = _e1776;
                                        phi_3517_ = _e1778;
                                        phi_3518_ = _e1780;
                                        phi_3519_ = (_e660 - 1u);
                                        phi_3520_ = _e1782;
                                        phi_3521_ = _e1784;
                                    } else {
                                        phi_4159_ = _e654;
                                        phi_3517_ = _e656;
                                        phi_3518_ = _e696;
                                        phi_3519_ = _e660;
                                        phi_3520_ = _e698;
                                        phi_3521_ = _e700;
                                    }
                                    let _e1786 = phi_4159_;
                                    let _e1788 = phi_3517_;
                                    let _e1790 = phi_3518_;
                                    let _e1792 = phi_3519_;
                                    let _e1794 = phi_3520_;
                                    let _e1796 = phi_3521_;
                                    phi_4158_ = _e1786;
                                    phi_3522_ = _e1788;
                                    phi_3523_ = _e1790;
                                    phi_3524_ = _e1792;
                                    phi_3525_ = _e1794;
                                    phi_3526_ = _e1796;
                                } else {
                                    phi_4158_ = _e654;
                                    phi_3522_ = type_42();
                                    phi_3523_ = type_53();
                                    phi_3524_ = u32();
                                    phi_3525_ = bool();
                                    phi_3526_ = u32();
                                }
                                let _e1798 = phi_4158_;
                                let _e1800 = phi_3522_;
                                let _e1802 = phi_3523_;
                                let _e1804 = phi_3524_;
                                let _e1806 = phi_3525_;
                                let _e1808 = phi_3526_;
                                phi_4157_ = _e1798;
                                phi_1166_ = _e1800;
                                phi_1169_ = _e1802;
                                phi_1171_ = _e1804;
                                phi_1173_ = _e1806;
                                phi_1175_ = _e1808;
                                phi_3527_ = _e668;
                            } else {
                                phi_4157_ = _e654;
                                phi_1166_ = type_42();
                                phi_1169_ = type_53();
                                phi_1171_ = u32();
                                phi_1173_ = bool();
                                phi_1175_ = u32();
                                phi_3527_ = false;
                            }
                            let _e1810 = phi_4157_;
                            let _e1812 = phi_1166_;
                            let _e1814 = phi_1169_;
                            let _e1816 = phi_1171_;
                            let _e1818 = phi_1173_;
                            let _e1820 = phi_1175_;
                            let _e1822 = phi_3527_;
                            continue;
                            continuing {
                                phi_4002_ = _e1810;
                                phi_1165_ = _e1812;
                                phi_1168_ = _e1814;
                                phi_1170_ = _e1816;
                                phi_1172_ = _e1818;
                                phi_1174_ = _e1820;
                                phi_4156_ = _e1810;
                                break if !(_e1822);
                            }
                        }
                        let _e1825 = phi_4156_;
                        if _e1825 {
                            break;
                        }
                        let _e1827 = local_10;
                        if (_e1827.member.member.member_3 != 4294967295u) {
                            let _e1833 = bitcast<u32>(_e1827.member.member.member);
                            let _e1837 = (bitcast<i32>((_e1833 >> bitcast<u32>(23i))) & 255i);
                            let _e1838 = (_e1837 + _e276);
                            if (_e1837 == 255i) {
                                phi_3586_ = _e1827.member.member.member;
                            } else {
                                if (_e1837 > 0i) {
                                    if (_e1838 > 0i) {
                                        let _e1842 = (_e1838 < 255i);
                                        if _e1842 {
                                            phi_3565_ = bitcast<f32>((_e1833 + bitcast<u32>((_e276 << bitcast<u32>(23i)))));
                                        } else {
                                            phi_3565_ = f32();
                                        }
                                        let _e1849 = phi_3565_;
                                        phi_3567_ = _e1849;
                                        phi_3568_ = select(true, false, _e1842);
                                    } else {
                                        phi_3567_ = f32();
                                        phi_3568_ = true;
                                    }
                                    let _e1852 = phi_3567_;
                                    let _e1854 = phi_3568_;
                                    phi_3569_ = _e1852;
                                    phi_3570_ = _e1854;
                                } else {
                                    phi_3569_ = f32();
                                    phi_3570_ = true;
                                }
                                let _e1856 = phi_3569_;
                                let _e1858 = phi_3570_;
                                if _e1858 {
                                    let _e1859 = (_e1833 & 2147483648u);
                                    let _e1866 = ((_e1833 & 8388607u) | (select(0u, 1u, ((_e1833 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                    let _e1870 = (_e1866 == 0u);
                                    if _e1870 {
                                        phi_3954_ = bitcast<f32>(_e1859);
                                    } else {
                                        let _e1875 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1866)), 32u, _e1870) - 8u);
                                        let _e1878 = (_e1866 << bitcast<u32>((_e1875 & 31u)));
                                        let _e1880 = ((_e1838 + select(0i, 1i, (_e1837 == 0i))) - bitcast<i32>(_e1875));
                                        if (_e1880 >= 255i) {
                                            phi_3944_ = bitcast<f32>((_e1859 | 2139095040u));
                                            phi_3945_ = f32();
                                            phi_3946_ = true;
                                        } else {
                                            let _e1882 = (_e1880 > 0i);
                                            if _e1882 {
                                                phi_3938_ = bitcast<f32>(((_e1859 | (bitcast<u32>(_e1880) << bitcast<u32>(23i))) | (_e1878 & 8388607u)));
                                                phi_3939_ = f32();
                                            } else {
                                                if (_e1880 < -24i) {
                                                    phi_3904_ = 26u;
                                                } else {
                                                    phi_3904_ = bitcast<u32>((1i - _e1880));
                                                }
                                                let _e1887 = phi_3904_;
                                                let _e1888 = (_e1887 & 31u);
                                                let _e1890 = (_e1878 >> bitcast<u32>(_e1888));
                                                let _e1894 = (_e1878 & ((1u << bitcast<u32>(_e1888)) - 1u));
                                                let _e1898 = (1u << bitcast<u32>(((_e1887 - 1u) & 31u)));
                                                if (_e1894 > _e1898) {
                                                    phi_3925_ = true;
                                                } else {
                                                    if (_e1894 == _e1898) {
                                                        phi_3922_ = ((_e1890 & 1u) == 1u);
                                                    } else {
                                                        phi_3922_ = false;
                                                    }
                                                    let _e1904 = phi_3922_;
                                                    phi_3925_ = _e1904;
                                                }
                                                let _e1906 = phi_3925_;
                                                phi_3938_ = f32();
                                                phi_3939_ = bitcast<f32>((_e1859 | (_e1890 + select(0u, 1u, _e1906))));
                                            }
                                            let _e1919 = phi_3938_;
                                            let _e1921 = phi_3939_;
                                            phi_3944_ = _e1919;
                                            phi_3945_ = _e1921;
                                            phi_3946_ = _e1882;
                                        }
                                        let _e1925 = phi_3944_;
                                        let _e1927 = phi_3945_;
                                        let _e1929 = phi_3946_;
                                        phi_3954_ = select(_e1927, _e1925, _e1929);
                                    }
                                    let _e1933 = phi_3954_;
                                    phi_3585_ = _e1933;
                                } else {
                                    phi_3585_ = _e1856;
                                }
                                let _e1935 = phi_3585_;
                                phi_3586_ = _e1935;
                            }
                            let _e1937 = phi_3586_;
                            let _e1938 = bitcast<u32>(_e1937);
                            if ((_e1938 & 2147483647u) >= 2139095040u) {
                                phi_3598_ = bitcast<f32>(((_e1938 & 2147483648u) | 2139095039u));
                            } else {
                                phi_3598_ = _e1937;
                            }
                            let _e1945 = phi_3598_;
                            phi_3603_ = type_22(_e1945, _e1827.member.member.member_1, _e1827.member.member.member_2, _e1827.member.member.member_3);
                        } else {
                            phi_3603_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1950 = phi_3603_;
                        if _e152 {
                        } else {
                            break;
                        }
                        global_2.member[_e136] = _e1950;
                        let _e1954 = local_11;
                        if _e153 {
                        } else {
                            break;
                        }
                        global_5.member[_e136] = _e1954.member_1;
                        if _e151 {
                        } else {
                            break;
                        }
                        let _e1959 = select(0u, 1u, (_e220 <= _e230));
                        if (_e1959 > 0u) {
                            let _e1961 = (1u < _e104);
                            if _e1961 {
                                if (0u < _e104) {
                                } else {
                                    break;
                                }
                                let _e1965 = atomicAdd((&global_6.member[0u]), _e1959);
                                if ((_e1965 + _e1959) < _e1965) {
                                    if _e1961 {
                                    } else {
                                        break;
                                    }
                                    let _e1970 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1973 = select(0u, 1u, (_e1950.member_3 != 4294967295u));
                        if (_e1973 > 0u) {
                            let _e1975 = (3u < _e104);
                            if _e1975 {
                                if (2u < _e104) {
                                } else {
                                    break;
                                }
                                let _e1979 = atomicAdd((&global_6.member[2u]), _e1973);
                                if ((_e1979 + _e1973) < _e1979) {
                                    if _e1975 {
                                    } else {
                                        break;
                                    }
                                    let _e1984 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1954.member_1 > 0u) {
                            let _e1986 = (5u < _e104);
                            if _e1986 {
                                if (4u < _e104) {
                                } else {
                                    break;
                                }
                                let _e1990 = atomicAdd((&global_6.member[4u]), _e1954.member_1);
                                if ((_e1990 + _e1954.member_1) < _e1990) {
                                    if _e1986 {
                                    } else {
                                        break;
                                    }
                                    let _e1995 = atomicAdd((&global_6.member[5u]), 1u);
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
fn trace_paths_counted_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
