struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: vec4<u32>,
}

struct type_21 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_23 {
    member: array<type_21>,
}

struct type_25 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_26 {
    member: type_25,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_28 {
    member: array<type_26>,
}

struct type_33 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_35 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_38 {
    member: type_21,
    member_1: f32,
}

struct type_43 {
    member: array<vec4<u32>, 2>,
}

struct type_46 {
    member: array<i32>,
}

struct type_52 {
    member: array<array<u32, 7>>,
}

struct type_57 {
    member: type_33,
    member_1: u32,
}

struct type_58 {
    member: array<vec4<f32>, 3>,
    member_1: type_57,
    member_2: type_57,
}

struct type_63 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_43;
@group(0) @binding(2) 
var<uniform> global_3: type_43;
@group(0) @binding(5) 
var<storage> global_4: type_4;
@group(0) @binding(6) 
var<storage> global_5: type_46;
@group(0) @binding(7) 
var<storage> global_6: type_28;
@group(0) @binding(8) 
var<storage, read_write> global_7: type_23;
@group(0) @binding(9) 
var<storage, read_write> global_8: type_63;
@group(0) @binding(3) 
var<storage> global_9: type_52;
@group(0) @binding(4) 
var<storage> global_10: type_4;

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
    var phi_327_: u32;
    var phi_371_: i32;
    var phi_395_: type_35;
    var phi_501_: i32;
    var phi_502_: i32;
    var phi_512_: bool;
    var phi_522_: u32;
    var phi_523_: u32;
    var phi_525_: bool;
    var phi_530_: u32;
    var phi_562_: i32;
    var phi_580_: f32;
    var phi_586_: f32;
    var phi_597_: f32;
    var phi_603_: f32;
    var phi_626_: f32;
    var phi_637_: f32;
    var phi_646_: f32;
    var phi_652_: f32;
    var phi_663_: f32;
    var phi_669_: f32;
    var phi_692_: f32;
    var phi_703_: f32;
    var phi_712_: f32;
    var phi_718_: f32;
    var phi_729_: f32;
    var phi_735_: f32;
    var phi_758_: f32;
    var phi_769_: f32;
    var phi_869_: f32;
    var phi_870_: f32;
    var phi_4323_: bool;
    var phi_959_: type_38;
    var phi_962_: type_57;
    var phi_964_: u32;
    var phi_966_: bool;
    var phi_968_: u32;
    var phi_979_: bool;
    var phi_1065_: type_57;
    var phi_1066_: bool;
    var phi_1067_: u32;
    var phi_3235_: u32;
    var phi_3241_: u32;
    var phi_3495_: u32;
    var phi_3496_: u32;
    var phi_3506_: u32;
    var phi_3508_: u32;
    var phi_3509_: bool;
    var phi_3529_: u32;
    var phi_3530_: u32;
    var phi_3534_: type_58;
    var phi_3878_: type_57;
    var phi_3955_: type_57;
    var phi_3956_: type_57;
    var phi_3957_: u32;
    var phi_3959_: type_57;
    var phi_3960_: u32;
    var phi_3961_: bool;
    var phi_3970_: type_57;
    var phi_3975_: type_57;
    var phi_3976_: bool;
    var phi_1086_: type_38;
    var phi_1089_: type_8;
    var phi_1090_: type_8;
    var phi_1112_: type_8;
    var phi_1153_: u32;
    var phi_1159_: u32;
    var phi_1169_: u32;
    var phi_1185_: u32;
    var phi_1218_: u32;
    var phi_1224_: u32;
    var phi_1651_: u32;
    var phi_1669_: u32;
    var phi_1687_: u32;
    var phi_1707_: u32;
    var phi_1725_: u32;
    var phi_1743_: u32;
    var phi_1763_: u32;
    var phi_1781_: u32;
    var phi_1799_: u32;
    var phi_1377_: u32;
    var phi_1392_: u32;
    var phi_1402_: u32;
    var phi_1422_: u32;
    var phi_1442_: u32;
    var phi_1468_: u32;
    var phi_1483_: u32;
    var phi_1493_: u32;
    var phi_1513_: u32;
    var phi_1533_: u32;
    var phi_1559_: u32;
    var phi_1574_: u32;
    var phi_1584_: u32;
    var phi_1604_: u32;
    var phi_1624_: u32;
    var phi_1248_: u32;
    var phi_1291_: u32;
    var phi_1334_: u32;
    var phi_1805_: array<array<f32, 3>, 3>;
    var phi_2276_: vec3<f32>;
    var phi_2277_: vec3<f32>;
    var phi_2308_: bool;
    var phi_2317_: vec3<f32>;
    var phi_2357_: type_21;
    var phi_2359_: type_21;
    var phi_2360_: bool;
    var phi_2364_: type_21;
    var phi_2365_: type_21;
    var phi_2366_: type_21;
    var phi_2367_: bool;
    var phi_2371_: type_21;
    var phi_2372_: bool;
    var phi_2376_: type_21;
    var phi_2377_: bool;
    var phi_2381_: type_21;
    var phi_2404_: u32;
    var phi_2418_: i32;
    var phi_2438_: vec3<f32>;
    var phi_2439_: vec3<f32>;
    var phi_2455_: vec3<f32>;
    var phi_2456_: vec3<f32>;
    var phi_2472_: vec3<f32>;
    var phi_2473_: vec3<f32>;
    var phi_2509_: vec3<f32>;
    var phi_2691_: f32;
    var phi_2709_: bool;
    var phi_2710_: bool;
    var phi_2729_: bool;
    var phi_2730_: bool;
    var phi_2736_: type_38;
    var phi_2737_: type_38;
    var phi_2738_: type_38;
    var phi_1087_: type_38;
    var phi_4317_: bool;
    var phi_4506_: bool;
    var phi_3978_: type_38;
    var phi_3979_: type_57;
    var phi_3980_: bool;
    var phi_3981_: u32;
    var phi_4505_: bool;
    var phi_3982_: type_38;
    var phi_3983_: type_57;
    var phi_3984_: u32;
    var phi_3985_: bool;
    var phi_3986_: u32;
    var phi_4504_: bool;
    var phi_3987_: type_38;
    var phi_3988_: type_57;
    var phi_3989_: u32;
    var phi_3990_: bool;
    var phi_3991_: u32;
    var phi_4503_: bool;
    var phi_960_: type_38;
    var phi_963_: type_57;
    var phi_965_: u32;
    var phi_967_: bool;
    var phi_969_: u32;
    var phi_3992_: bool;
    var phi_4502_: bool;
    var local_10: type_38;
    var phi_4044_: type_21;
    var local_11: type_38;

    switch bitcast<i32>(0u) {
        default: {
            let _e96 = global;
            let _e98 = arrayLength((&global_9.member));
            let _e101 = arrayLength((&global_10.member));
            let _e113 = arrayLength((&global_8.member));
            let _e117 = global_3.member[0u][0u];
            let _e121 = global_3.member[0u][1u];
            let _e125 = global_3.member[0u][2u];
            let _e129 = global_3.member[0u][3u];
            let _e133 = global_3.member[1u][0u];
            let _e137 = global_3.member[1u][1u];
            let _e141 = global_3.member[1u][2u];
            let _e145 = (_e96.x + (_e96.y * 2097152u));
            let _e157 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e129) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e117), bitcast<i32>(_e121), bitcast<i32>(_e125));
            local = array<i32, 3>(bitcast<i32>(_e133), bitcast<i32>(_e137), bitcast<i32>(_e141));
            let _e160 = (_e145 < arrayLength((&global_6.member)));
            if _e160 {
                if _e160 {
                } else {
                    break;
                }
                let _e164 = global_6.member[_e145].member_2;
                phi_327_ = _e164;
            } else {
                phi_327_ = 4294967295u;
            }
            let _e166 = phi_327_;
            let _e169 = global_1.member[0u];
            let _e173 = global_2.member[0u][0u];
            let _e177 = global_2.member[0u][1u];
            let _e181 = global_2.member[0u][2u];
            let _e185 = global_2.member[0u][3u];
            let _e189 = global_2.member[1u][0u];
            let _e193 = global_2.member[1u][1u];
            let _e197 = global_2.member[1u][2u];
            let _e201 = global_2.member[1u][3u];
            let _e202 = bitcast<f32>(_e173);
            let _e203 = bitcast<f32>(_e177);
            let _e204 = bitcast<f32>(_e181);
            let _e206 = bitcast<f32>(_e189);
            let _e207 = array<u32, 3>(_e193, _e197, _e201);
            let _e209 = bitcast<i32>(_e169);
            if (_e209 < -126i) {
                phi_371_ = -126i;
            } else {
                phi_371_ = select(_e209, 127i, (_e209 > 127i));
            }
            let _e214 = phi_371_;
            let _e219 = bitcast<f32>((bitcast<u32>((_e214 + 127i)) << bitcast<u32>(23i)));
            let _e225 = bitcast<f32>((bitcast<u32>(((_e209 - _e214) + 127i)) << bitcast<u32>(23i)));
            if (_e185 == 0u) {
                phi_395_ = type_35(array<f32, 3>(_e202, _e203, _e204), _e185, _e206, _e207);
            } else {
                phi_395_ = type_35(array<f32, 3>(((_e202 * _e219) * _e225), ((_e203 * _e219) * _e225), ((_e204 * _e219) * _e225)), _e185, ((_e206 * _e219) * _e225), _e207);
            }
            let _e238 = phi_395_;
            if _e160 {
                let _e239 = (_e145 < arrayLength((&global_7.member)));
                if _e239 {
                    if _e160 {
                    } else {
                        break;
                    }
                    let _e249 = global_6.member[_e145].member.member_2[0u];
                    let _e251 = (bitcast<u32>(_e249) & 2147483647u);
                    let _e257 = global_6.member[_e145].member.member_2[1u];
                    let _e259 = (bitcast<u32>(_e257) & 2147483647u);
                    let _e265 = global_6.member[_e145].member.member_2[2u];
                    let _e267 = (bitcast<u32>(_e265) & 2147483647u);
                    let _e273 = global_6.member[_e145].member.member[0u];
                    let _e275 = (bitcast<u32>(_e273) & 2147483647u);
                    let _e281 = global_6.member[_e145].member.member[1u];
                    let _e283 = (bitcast<u32>(_e281) & 2147483647u);
                    let _e289 = global_6.member[_e145].member.member[2u];
                    let _e291 = (bitcast<u32>(_e289) & 2147483647u);
                    let _e293 = select(_e259, _e251, (_e259 < _e251));
                    let _e295 = select(_e267, _e293, (_e267 < _e293));
                    let _e297 = select(_e275, _e295, (_e275 < _e295));
                    let _e299 = select(_e283, _e297, (_e283 < _e297));
                    let _e301 = select(_e291, _e299, (_e291 < _e299));
                    let _e306 = global_6.member[_e145].member.member_1;
                    let _e308 = (bitcast<u32>(_e306) & 2147483647u);
                    let _e316 = global_6.member[_e145].member.member_3;
                    let _e322 = (((select(_e308, _e301, (_e308 < _e301)) < 2139095040u) && ((bitcast<u32>(_e316) & 2147483647u) <= 2139095040u)) && (_e295 > 0u));
                    if _e322 {
                        let _e325 = (bitcast<u32>(bitcast<f32>(_e295)) & 2147483647u);
                        if (_e325 >= 8388608u) {
                            phi_501_ = (bitcast<i32>((_e325 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_501_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e325)), 32u, (_e325 == 0u))));
                        }
                        let _e339 = phi_501_;
                        phi_502_ = _e339;
                    } else {
                        phi_502_ = 0i;
                    }
                    let _e341 = phi_502_;
                    let _e342 = (_e251 == _e295);
                    if _e342 {
                        phi_512_ = true;
                    } else {
                        phi_512_ = (_e259 == _e295);
                    }
                    let _e345 = phi_512_;
                    let _e346 = select(1u, 0u, _e342);
                    if _e345 {
                        let _e347 = (_e346 + 1u);
                        phi_522_ = _e347;
                        phi_523_ = _e347;
                        phi_525_ = select(true, false, (_e347 == 2u));
                    } else {
                        phi_522_ = u32();
                        phi_523_ = 0u;
                        phi_525_ = true;
                    }
                    let _e351 = phi_522_;
                    let _e353 = phi_523_;
                    let _e355 = phi_525_;
                    if _e355 {
                        phi_530_ = (_e353 + 1u);
                    } else {
                        phi_530_ = 0u;
                    }
                    let _e359 = phi_530_;
                    let _e360 = select(_e351, _e353, _e355);
                    let _e361 = select(_e346, select(2u, _e346, _e345), _e355);
                    let _e362 = -(_e341);
                    if (_e362 < -126i) {
                        phi_562_ = -126i;
                    } else {
                        phi_562_ = select(_e362, 127i, (_e362 > 127i));
                    }
                    let _e367 = phi_562_;
                    let _e372 = bitcast<f32>((bitcast<u32>((_e367 + 127i)) << bitcast<u32>(23i)));
                    let _e378 = bitcast<f32>((bitcast<u32>(((_e362 - _e367) + 127i)) << bitcast<u32>(23i)));
                    let _e383 = global_6.member[_e145].member.member;
                    let _e384 = (_e360 == 0u);
                    if _e384 {
                        phi_580_ = _e383[0];
                    } else {
                        phi_580_ = _e383[1];
                    }
                    let _e388 = phi_580_;
                    let _e389 = (_e360 == 2u);
                    if _e389 {
                        phi_586_ = _e383[2];
                    } else {
                        phi_586_ = _e388;
                    }
                    let _e392 = phi_586_;
                    let _e393 = global_6.member[_e145].member.member_2;
                    if _e384 {
                        phi_597_ = _e393[0];
                    } else {
                        phi_597_ = _e393[1];
                    }
                    let _e397 = phi_597_;
                    if _e389 {
                        phi_603_ = _e393[2];
                    } else {
                        phi_603_ = _e397;
                    }
                    let _e400 = phi_603_;
                    let _e402 = ((_e400 * _e372) * _e378);
                    let _e406 = (bitcast<f32>((bitcast<u32>(_e402) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e406 {
                        let _e410 = (bitcast<f32>((bitcast<u32>(_e392) & 2147483647u)) * 0.00000011920929f);
                        phi_626_ = select(0.00000000000011368684f, _e410, (_e410 > 0.00000000000011368684f));
                    } else {
                        phi_626_ = 0f;
                    }
                    let _e414 = phi_626_;
                    let _e415 = (_e392 + _e414);
                    let _e416 = (_e392 - _e414);
                    let _e417 = select(_e402, 0f, _e406);
                    if _e406 {
                        phi_637_ = 38685626000000000000000000f;
                    } else {
                        phi_637_ = (1f / _e402);
                    }
                    let _e420 = phi_637_;
                    let _e421 = (_e359 == 0u);
                    if _e421 {
                        phi_646_ = _e383[0];
                    } else {
                        phi_646_ = _e383[1];
                    }
                    let _e425 = phi_646_;
                    let _e426 = (_e359 == 2u);
                    if _e426 {
                        phi_652_ = _e383[2];
                    } else {
                        phi_652_ = _e425;
                    }
                    let _e429 = phi_652_;
                    if _e421 {
                        phi_663_ = _e393[0];
                    } else {
                        phi_663_ = _e393[1];
                    }
                    let _e433 = phi_663_;
                    if _e426 {
                        phi_669_ = _e393[2];
                    } else {
                        phi_669_ = _e433;
                    }
                    let _e436 = phi_669_;
                    let _e438 = ((_e436 * _e372) * _e378);
                    let _e442 = (bitcast<f32>((bitcast<u32>(_e438) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e442 {
                        let _e446 = (bitcast<f32>((bitcast<u32>(_e429) & 2147483647u)) * 0.00000011920929f);
                        phi_692_ = select(0.00000000000011368684f, _e446, (_e446 > 0.00000000000011368684f));
                    } else {
                        phi_692_ = 0f;
                    }
                    let _e450 = phi_692_;
                    let _e451 = (_e429 + _e450);
                    let _e452 = (_e429 - _e450);
                    let _e453 = select(_e438, 0f, _e442);
                    if _e442 {
                        phi_703_ = 38685626000000000000000000f;
                    } else {
                        phi_703_ = (1f / _e438);
                    }
                    let _e456 = phi_703_;
                    let _e457 = (_e361 == 0u);
                    if _e457 {
                        phi_712_ = _e383[0];
                    } else {
                        phi_712_ = _e383[1];
                    }
                    let _e461 = phi_712_;
                    let _e462 = (_e361 == 2u);
                    if _e462 {
                        phi_718_ = _e383[2];
                    } else {
                        phi_718_ = _e461;
                    }
                    let _e465 = phi_718_;
                    if _e457 {
                        phi_729_ = _e393[0];
                    } else {
                        phi_729_ = _e393[1];
                    }
                    let _e469 = phi_729_;
                    if _e462 {
                        phi_735_ = _e393[2];
                    } else {
                        phi_735_ = _e469;
                    }
                    let _e472 = phi_735_;
                    let _e474 = ((_e472 * _e372) * _e378);
                    let _e478 = (bitcast<f32>((bitcast<u32>(_e474) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e478 {
                        let _e482 = (bitcast<f32>((bitcast<u32>(_e465) & 2147483647u)) * 0.00000011920929f);
                        phi_758_ = select(0.00000000000011368684f, _e482, (_e482 > 0.00000000000011368684f));
                    } else {
                        phi_758_ = 0f;
                    }
                    let _e486 = phi_758_;
                    let _e487 = (_e465 + _e486);
                    let _e488 = (_e465 - _e486);
                    let _e489 = select(_e474, 0f, _e478);
                    if _e478 {
                        phi_769_ = 38685626000000000000000000f;
                    } else {
                        phi_769_ = (1f / _e474);
                    }
                    let _e492 = phi_769_;
                    let _e495 = bitcast<f32>((bitcast<u32>(_e392) & 2147483647u));
                    let _e498 = bitcast<f32>((bitcast<u32>(_e429) & 2147483647u));
                    let _e500 = select(_e498, _e495, (_e495 > _e498));
                    let _e503 = bitcast<f32>((bitcast<u32>(_e465) & 2147483647u));
                    if (_e322 && (select(_e503, _e500, (_e500 > _e503)) <= 1099511600000f)) {
                        let _e508 = (_e341 / 3i);
                        let _e515 = bitcast<f32>((bitcast<u32>((_e508 + 127i)) << bitcast<u32>(23i)));
                        let _e522 = bitcast<f32>((bitcast<u32>(((_e341 - (2i * _e508)) + 127i)) << bitcast<u32>(23i)));
                        let _e523 = (((_e306 * _e515) * _e515) * _e522);
                        let _e525 = select(340282350000000000000000000000000000000f, _e523, (_e523 < 340282350000000000000000000000000000000f));
                        let _e530 = (((_e316 * _e515) * _e515) * _e522);
                        let _e532 = select(340282350000000000000000000000000000000f, _e530, (_e530 < 340282350000000000000000000000000000000f));
                        phi_869_ = select(-340282350000000000000000000000000000000f, _e532, (_e532 > -340282350000000000000000000000000000000f));
                        phi_870_ = select(-340282350000000000000000000000000000000f, _e525, (_e525 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_869_ = 0f;
                        phi_870_ = 1f;
                    }
                    let _e536 = phi_869_;
                    let _e538 = phi_870_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e542 = (_e360 % 3u);
                    let _e543 = (_e542 < 3u);
                    if _e543 {
                    } else {
                        break;
                    }
                    let _e545 = local_1[_e542];
                    let _e548 = (_e359 % 3u);
                    let _e549 = (_e548 < 3u);
                    if _e549 {
                    } else {
                        break;
                    }
                    let _e551 = local_1[_e548];
                    let _e554 = (_e361 % 3u);
                    let _e555 = (_e554 < 3u);
                    if _e555 {
                    } else {
                        break;
                    }
                    let _e557 = local_1[_e554];
                    if _e543 {
                    } else {
                        break;
                    }
                    let _e562 = local[_e542];
                    if _e549 {
                    } else {
                        break;
                    }
                    let _e566 = local[_e548];
                    if _e555 {
                    } else {
                        break;
                    }
                    let _e570 = local[_e554];
                    phi_4323_ = false;
                    phi_959_ = type_38(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e536);
                    phi_962_ = type_57(type_33(vec4<f32>((f32(_e545) * _e157), (f32(_e551) * _e157), (f32(_e557) * _e157), 0f), vec4<f32>((f32(_e562) * _e157), (f32(_e566) * _e157), (f32(_e570) * _e157), 0f)), select(0u, 2147483648u, (_e98 == 0u)));
                    phi_964_ = ((3u * _e98) + 1u);
                    phi_966_ = (_e538 <= _e536);
                    phi_968_ = 0u;
                    loop {
                        let _e580 = phi_4323_;
                        let _e582 = phi_959_;
                        let _e584 = phi_962_;
                        let _e586 = phi_964_;
                        let _e588 = phi_966_;
                        let _e590 = phi_968_;
                        local_10 = _e582;
                        if _e588 {
                            phi_979_ = true;
                        } else {
                            phi_979_ = (_e590 > 0u);
                        }
                        let _e593 = phi_979_;
                        if _e593 {
                            let _e594 = (_e586 > 0u);
                            if _e594 {
                                if _e588 {
                                    phi_1065_ = _e584;
                                    phi_1066_ = _e588;
                                    phi_1067_ = _e590;
                                } else {
                                    let _e595 = (_e590 - 1u);
                                    let _e596 = (_e595 % 128u);
                                    let _e597 = (_e596 < 128u);
                                    if _e597 {
                                    } else {
                                        phi_4502_ = true;
                                        break;
                                    }
                                    let _e599 = local_7[_e596];
                                    if _e597 {
                                    } else {
                                        phi_4502_ = true;
                                        break;
                                    }
                                    let _e601 = local_6[_e596];
                                    if _e597 {
                                    } else {
                                        phi_4502_ = true;
                                        break;
                                    }
                                    let _e603 = local_5[_e596];
                                    if _e597 {
                                    } else {
                                        phi_4502_ = true;
                                        break;
                                    }
                                    let _e605 = local_4[_e596];
                                    if _e597 {
                                    } else {
                                        phi_4502_ = true;
                                        break;
                                    }
                                    let _e607 = local_3[_e596];
                                    if _e597 {
                                    } else {
                                        phi_4502_ = true;
                                        break;
                                    }
                                    let _e609 = local_2[_e596];
                                    if _e597 {
                                    } else {
                                        phi_4502_ = true;
                                        break;
                                    }
                                    let _e614 = local_8[_e596];
                                    if _e597 {
                                    } else {
                                        phi_4502_ = true;
                                        break;
                                    }
                                    let _e617 = local_9[_e596];
                                    phi_1065_ = type_57(type_33(vec4<f32>(_e599, _e601, _e603, 0f), vec4<f32>(_e605, _e607, _e609, 0f)), _e614);
                                    phi_1066_ = (_e617 <= _e582.member_1);
                                    phi_1067_ = _e595;
                                }
                                let _e621 = phi_1065_;
                                let _e623 = phi_1066_;
                                let _e625 = phi_1067_;
                                if _e623 {
                                    let _e630 = (_e621.member_1 & 268435455u);
                                    if ((_e621.member_1 & 2147483648u) != 0u) {
                                        phi_1086_ = _e582;
                                        phi_1089_ = type_8(0u, ((_e621.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1108 = phi_1086_;
                                            let _e1110 = phi_1089_;
                                            local_11 = _e1108;
                                            if (_e1110.member < _e1110.member_1) {
                                                phi_1090_ = type_8((_e1110.member + 1u), _e1110.member_1);
                                                phi_1112_ = type_8(1u, _e1110.member);
                                            } else {
                                                phi_1090_ = _e1110;
                                                phi_1112_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1123 = phi_1090_;
                                            let _e1125 = phi_1112_;
                                            let _e1129 = (bitcast<i32>(_e1125.member) != 0i);
                                            if _e1129 {
                                                let _e1134 = (_e621.member.member_1.x - _e621.member.member.x);
                                                let _e1137 = (_e621.member.member_1.y - _e621.member.member.y);
                                                let _e1140 = (_e621.member.member_1.z - _e621.member.member.z);
                                                let _e1142 = select(_e1137, _e1134, (_e1134 > _e1137));
                                                let _e1144 = select(_e1140, _e1142, (_e1142 > _e1140));
                                                let _e1146 = (_e1144 < (1024f * _e157));
                                                if _e1146 {
                                                    phi_1153_ = 0u;
                                                } else {
                                                    phi_1153_ = select(2u, 1u, (_e1144 < (2097152f * _e157)));
                                                }
                                                let _e1151 = phi_1153_;
                                                switch bitcast<i32>(_e1151) {
                                                    case 0: {
                                                        phi_1159_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1159_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1159_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1159_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1154 = phi_1159_;
                                                switch bitcast<i32>(_e1151) {
                                                    case 0: {
                                                        phi_1169_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1169_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1169_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1169_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1161 = phi_1169_;
                                                let _e1163 = ((_e630 + (_e1125.member_1 * ((3u * _e1154) + 1u))) + (3u * _e1161));
                                                let _e1164 = (_e1163 < _e101);
                                                if _e1164 {
                                                    if _e1164 {
                                                    } else {
                                                        phi_4317_ = true;
                                                        break;
                                                    }
                                                    let _e1166 = global_10.member[_e1163];
                                                    phi_1185_ = _e1166;
                                                } else {
                                                    phi_1185_ = 4294967295u;
                                                }
                                                let _e1168 = phi_1185_;
                                                if _e1146 {
                                                    phi_1218_ = 0u;
                                                } else {
                                                    phi_1218_ = select(2u, 1u, (_e1144 < (2097152f * _e157)));
                                                }
                                                let _e1173 = phi_1218_;
                                                switch bitcast<i32>(_e1173) {
                                                    case 0: {
                                                        phi_1224_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1224_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1224_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1224_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1176 = phi_1224_;
                                                let _e1180 = (_e630 + (_e1125.member_1 * ((3u * _e1176) + 1u)));
                                                switch bitcast<i32>(_e1173) {
                                                    case 0: {
                                                        let _e1446 = (_e1180 < _e101);
                                                        if _e1446 {
                                                            if _e1446 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1448 = global_10.member[_e1180];
                                                            phi_1248_ = _e1448;
                                                        } else {
                                                            phi_1248_ = 0u;
                                                        }
                                                        let _e1450 = phi_1248_;
                                                        let _e1452 = ((10u * _e360) & 31u);
                                                        let _e1461 = ((10u * _e359) & 31u);
                                                        let _e1470 = ((10u * _e361) & 31u);
                                                        let _e1479 = (_e1180 + 1u);
                                                        let _e1480 = (_e1479 < _e101);
                                                        if _e1480 {
                                                            if _e1480 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1482 = global_10.member[_e1479];
                                                            phi_1291_ = _e1482;
                                                        } else {
                                                            phi_1291_ = 0u;
                                                        }
                                                        let _e1484 = phi_1291_;
                                                        let _e1507 = (_e1180 + 2u);
                                                        let _e1508 = (_e1507 < _e101);
                                                        if _e1508 {
                                                            if _e1508 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1510 = global_10.member[_e1507];
                                                            phi_1334_ = _e1510;
                                                        } else {
                                                            phi_1334_ = 0u;
                                                        }
                                                        let _e1512 = phi_1334_;
                                                        phi_1805_ = array<array<f32, 3>, 3>(array<f32, 3>((_e621.member.member.x + (f32(bitcast<i32>(((_e1450 >> bitcast<u32>(_e1452)) & 1023u))) * _e157)), (_e621.member.member.y + (f32(bitcast<i32>(((_e1450 >> bitcast<u32>(_e1461)) & 1023u))) * _e157)), (_e621.member.member.z + (f32(bitcast<i32>(((_e1450 >> bitcast<u32>(_e1470)) & 1023u))) * _e157))), array<f32, 3>((_e621.member.member.x + (f32(bitcast<i32>(((_e1484 >> bitcast<u32>(_e1452)) & 1023u))) * _e157)), (_e621.member.member.y + (f32(bitcast<i32>(((_e1484 >> bitcast<u32>(_e1461)) & 1023u))) * _e157)), (_e621.member.member.z + (f32(bitcast<i32>(((_e1484 >> bitcast<u32>(_e1470)) & 1023u))) * _e157))), array<f32, 3>((_e621.member.member.x + (f32(bitcast<i32>(((_e1512 >> bitcast<u32>(_e1452)) & 1023u))) * _e157)), (_e621.member.member.y + (f32(bitcast<i32>(((_e1512 >> bitcast<u32>(_e1461)) & 1023u))) * _e157)), (_e621.member.member.z + (f32(bitcast<i32>(((_e1512 >> bitcast<u32>(_e1470)) & 1023u))) * _e157))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1269 = (_e1180 < _e101);
                                                        if _e1269 {
                                                            if _e1269 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1271 = global_10.member[_e1180];
                                                            phi_1377_ = _e1271;
                                                        } else {
                                                            phi_1377_ = 0u;
                                                        }
                                                        let _e1273 = phi_1377_;
                                                        let _e1274 = (_e1180 + 1u);
                                                        let _e1275 = (_e1274 < _e101);
                                                        if _e1275 {
                                                            if _e1275 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1277 = global_10.member[_e1274];
                                                            phi_1392_ = _e1277;
                                                        } else {
                                                            phi_1392_ = 0u;
                                                        }
                                                        let _e1279 = phi_1392_;
                                                        let _e1280 = (_e360 == 1u);
                                                        if _e1280 {
                                                            phi_1402_ = ((_e1273 >> bitcast<u32>(21i)) | (_e1279 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1402_ = (_e1279 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1289 = phi_1402_;
                                                        let _e1296 = (_e359 == 1u);
                                                        if _e1296 {
                                                            phi_1422_ = ((_e1273 >> bitcast<u32>(21i)) | (_e1279 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1422_ = (_e1279 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1305 = phi_1422_;
                                                        let _e1312 = (_e361 == 1u);
                                                        if _e1312 {
                                                            phi_1442_ = ((_e1273 >> bitcast<u32>(21i)) | (_e1279 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1442_ = (_e1279 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1321 = phi_1442_;
                                                        let _e1329 = (_e1180 + 2u);
                                                        let _e1330 = (_e1329 < _e101);
                                                        if _e1330 {
                                                            if _e1330 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1332 = global_10.member[_e1329];
                                                            phi_1468_ = _e1332;
                                                        } else {
                                                            phi_1468_ = 0u;
                                                        }
                                                        let _e1334 = phi_1468_;
                                                        let _e1335 = (_e1180 + 3u);
                                                        let _e1336 = (_e1335 < _e101);
                                                        if _e1336 {
                                                            if _e1336 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1338 = global_10.member[_e1335];
                                                            phi_1483_ = _e1338;
                                                        } else {
                                                            phi_1483_ = 0u;
                                                        }
                                                        let _e1340 = phi_1483_;
                                                        if _e1280 {
                                                            phi_1493_ = ((_e1334 >> bitcast<u32>(21i)) | (_e1340 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1493_ = (_e1340 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1349 = phi_1493_;
                                                        if _e1296 {
                                                            phi_1513_ = ((_e1334 >> bitcast<u32>(21i)) | (_e1340 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1513_ = (_e1340 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1364 = phi_1513_;
                                                        if _e1312 {
                                                            phi_1533_ = ((_e1334 >> bitcast<u32>(21i)) | (_e1340 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1533_ = (_e1340 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1379 = phi_1533_;
                                                        let _e1387 = (_e1180 + 4u);
                                                        let _e1388 = (_e1387 < _e101);
                                                        if _e1388 {
                                                            if _e1388 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1390 = global_10.member[_e1387];
                                                            phi_1559_ = _e1390;
                                                        } else {
                                                            phi_1559_ = 0u;
                                                        }
                                                        let _e1392 = phi_1559_;
                                                        let _e1393 = (_e1180 + 5u);
                                                        let _e1394 = (_e1393 < _e101);
                                                        if _e1394 {
                                                            if _e1394 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1396 = global_10.member[_e1393];
                                                            phi_1574_ = _e1396;
                                                        } else {
                                                            phi_1574_ = 0u;
                                                        }
                                                        let _e1398 = phi_1574_;
                                                        if _e1280 {
                                                            phi_1584_ = ((_e1392 >> bitcast<u32>(21i)) | (_e1398 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1584_ = (_e1398 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1407 = phi_1584_;
                                                        if _e1296 {
                                                            phi_1604_ = ((_e1392 >> bitcast<u32>(21i)) | (_e1398 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1604_ = (_e1398 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1422 = phi_1604_;
                                                        if _e1312 {
                                                            phi_1624_ = ((_e1392 >> bitcast<u32>(21i)) | (_e1398 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1624_ = (_e1398 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1437 = phi_1624_;
                                                        phi_1805_ = array<array<f32, 3>, 3>(array<f32, 3>((_e621.member.member.x + (f32(bitcast<i32>((select(_e1289, _e1273, _e384) & 2097151u))) * _e157)), (_e621.member.member.y + (f32(bitcast<i32>((select(_e1305, _e1273, _e421) & 2097151u))) * _e157)), (_e621.member.member.z + (f32(bitcast<i32>((select(_e1321, _e1273, _e457) & 2097151u))) * _e157))), array<f32, 3>((_e621.member.member.x + (f32(bitcast<i32>((select(_e1349, _e1334, _e384) & 2097151u))) * _e157)), (_e621.member.member.y + (f32(bitcast<i32>((select(_e1364, _e1334, _e421) & 2097151u))) * _e157)), (_e621.member.member.z + (f32(bitcast<i32>((select(_e1379, _e1334, _e457) & 2097151u))) * _e157))), array<f32, 3>((_e621.member.member.x + (f32(bitcast<i32>((select(_e1407, _e1392, _e384) & 2097151u))) * _e157)), (_e621.member.member.y + (f32(bitcast<i32>((select(_e1422, _e1392, _e421) & 2097151u))) * _e157)), (_e621.member.member.z + (f32(bitcast<i32>((select(_e1437, _e1392, _e457) & 2097151u))) * _e157))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1182 = (_e1180 + _e360);
                                                        let _e1183 = (_e1182 < _e101);
                                                        if _e1183 {
                                                            if _e1183 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1185 = global_10.member[_e1182];
                                                            phi_1651_ = _e1185;
                                                        } else {
                                                            phi_1651_ = 0u;
                                                        }
                                                        let _e1187 = phi_1651_;
                                                        let _e1191 = (_e1180 + _e359);
                                                        let _e1192 = (_e1191 < _e101);
                                                        if _e1192 {
                                                            if _e1192 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1194 = global_10.member[_e1191];
                                                            phi_1669_ = _e1194;
                                                        } else {
                                                            phi_1669_ = 0u;
                                                        }
                                                        let _e1196 = phi_1669_;
                                                        let _e1200 = (_e1180 + _e361);
                                                        let _e1201 = (_e1200 < _e101);
                                                        if _e1201 {
                                                            if _e1201 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1203 = global_10.member[_e1200];
                                                            phi_1687_ = _e1203;
                                                        } else {
                                                            phi_1687_ = 0u;
                                                        }
                                                        let _e1205 = phi_1687_;
                                                        let _e1210 = (_e1180 + 3u);
                                                        let _e1211 = (_e1210 + _e360);
                                                        let _e1212 = (_e1211 < _e101);
                                                        if _e1212 {
                                                            if _e1212 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1214 = global_10.member[_e1211];
                                                            phi_1707_ = _e1214;
                                                        } else {
                                                            phi_1707_ = 0u;
                                                        }
                                                        let _e1216 = phi_1707_;
                                                        let _e1220 = (_e1210 + _e359);
                                                        let _e1221 = (_e1220 < _e101);
                                                        if _e1221 {
                                                            if _e1221 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1223 = global_10.member[_e1220];
                                                            phi_1725_ = _e1223;
                                                        } else {
                                                            phi_1725_ = 0u;
                                                        }
                                                        let _e1225 = phi_1725_;
                                                        let _e1229 = (_e1210 + _e361);
                                                        let _e1230 = (_e1229 < _e101);
                                                        if _e1230 {
                                                            if _e1230 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1232 = global_10.member[_e1229];
                                                            phi_1743_ = _e1232;
                                                        } else {
                                                            phi_1743_ = 0u;
                                                        }
                                                        let _e1234 = phi_1743_;
                                                        let _e1239 = (_e1180 + 6u);
                                                        let _e1240 = (_e1239 + _e360);
                                                        let _e1241 = (_e1240 < _e101);
                                                        if _e1241 {
                                                            if _e1241 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1243 = global_10.member[_e1240];
                                                            phi_1763_ = _e1243;
                                                        } else {
                                                            phi_1763_ = 0u;
                                                        }
                                                        let _e1245 = phi_1763_;
                                                        let _e1249 = (_e1239 + _e359);
                                                        let _e1250 = (_e1249 < _e101);
                                                        if _e1250 {
                                                            if _e1250 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1252 = global_10.member[_e1249];
                                                            phi_1781_ = _e1252;
                                                        } else {
                                                            phi_1781_ = 0u;
                                                        }
                                                        let _e1254 = phi_1781_;
                                                        let _e1258 = (_e1239 + _e361);
                                                        let _e1259 = (_e1258 < _e101);
                                                        if _e1259 {
                                                            if _e1259 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1261 = global_10.member[_e1258];
                                                            phi_1799_ = _e1261;
                                                        } else {
                                                            phi_1799_ = 0u;
                                                        }
                                                        let _e1263 = phi_1799_;
                                                        phi_1805_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1187)) * _e157), (f32(bitcast<i32>(_e1196)) * _e157), (f32(bitcast<i32>(_e1205)) * _e157)), array<f32, 3>((f32(bitcast<i32>(_e1216)) * _e157), (f32(bitcast<i32>(_e1225)) * _e157), (f32(bitcast<i32>(_e1234)) * _e157)), array<f32, 3>((f32(bitcast<i32>(_e1245)) * _e157), (f32(bitcast<i32>(_e1254)) * _e157), (f32(bitcast<i32>(_e1263)) * _e157)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1805_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1537 = phi_1805_;
                                                let _e1545 = (_e1537[0][2] - _e465);
                                                let _e1548 = (((_e1537[0][0] - _e392) * _e489) - (_e1545 * _e417));
                                                let _e1551 = (((_e1537[0][1] - _e429) * _e489) - (_e1545 * _e453));
                                                let _e1558 = (_e1537[1][2] - _e465);
                                                let _e1561 = (((_e1537[1][0] - _e392) * _e489) - (_e1558 * _e417));
                                                let _e1564 = (((_e1537[1][1] - _e429) * _e489) - (_e1558 * _e453));
                                                let _e1571 = (_e1537[2][2] - _e465);
                                                let _e1574 = (((_e1537[2][0] - _e392) * _e489) - (_e1571 * _e417));
                                                let _e1577 = (((_e1537[2][1] - _e429) * _e489) - (_e1571 * _e453));
                                                let _e1578 = (_e1574 * _e1564);
                                                let _e1579 = (_e1577 * _e1561);
                                                let _e1580 = (_e1548 * _e1577);
                                                let _e1581 = (_e1551 * _e1574);
                                                let _e1582 = (_e1561 * _e1551);
                                                let _e1583 = (_e1564 * _e1548);
                                                let _e1588 = (((_e1578 >= _e1579) && (_e1580 >= _e1581)) && (_e1582 >= _e1583));
                                                if (_e1588 || (((_e1578 <= _e1579) && (_e1580 <= _e1581)) && (_e1582 <= _e1583))) {
                                                    let _e1595 = select(-1f, 1f, _e1588);
                                                    let _e1597 = ((_e1578 - _e1579) * _e1595);
                                                    let _e1599 = select(0f, _e1597, (_e1597 > 0f));
                                                    let _e1601 = ((_e1580 - _e1581) * _e1595);
                                                    let _e1603 = select(0f, _e1601, (_e1601 > 0f));
                                                    let _e1605 = ((_e1582 - _e1583) * _e1595);
                                                    let _e1607 = select(0f, _e1605, (_e1605 > 0f));
                                                    let _e1609 = ((_e1599 + _e1603) + _e1607);
                                                    if (_e1609 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2371_ = type_21();
                                                        phi_2372_ = true;
                                                    } else {
                                                        let _e1612 = select(_e1537[1][0], _e1537[0][0], (_e1537[0][0] < _e1537[1][0]));
                                                        let _e1616 = select(_e1537[1][0], _e1537[0][0], (_e1537[0][0] > _e1537[1][0]));
                                                        let _e1620 = select(_e1537[1][1], _e1537[0][1], (_e1537[0][1] < _e1537[1][1]));
                                                        let _e1624 = select(_e1537[1][1], _e1537[0][1], (_e1537[0][1] > _e1537[1][1]));
                                                        let _e1628 = select(_e1537[1][2], _e1537[0][2], (_e1537[0][2] < _e1537[1][2]));
                                                        let _e1632 = select(_e1537[1][2], _e1537[0][2], (_e1537[0][2] > _e1537[1][2]));
                                                        let _e1637 = ((select(_e1537[2][0], _e1612, (_e1612 < _e1537[2][0])) - _e415) * _e420);
                                                        let _e1638 = ((select(_e1537[2][0], _e1616, (_e1616 > _e1537[2][0])) - _e416) * _e420);
                                                        let _e1641 = ((select(_e1537[2][1], _e1620, (_e1620 < _e1537[2][1])) - _e451) * _e456);
                                                        let _e1642 = ((select(_e1537[2][1], _e1624, (_e1624 > _e1537[2][1])) - _e452) * _e456);
                                                        let _e1645 = ((select(_e1537[2][2], _e1628, (_e1628 < _e1537[2][2])) - _e487) * _e492);
                                                        let _e1646 = ((select(_e1537[2][2], _e1632, (_e1632 > _e1537[2][2])) - _e488) * _e492);
                                                        let _e1648 = select(_e1646, _e1645, (_e1645 < _e1646));
                                                        let _e1650 = select(_e1646, _e1645, (_e1645 > _e1646));
                                                        let _e1652 = select(_e1638, _e1637, (_e1637 < _e1638));
                                                        let _e1654 = select(_e1642, _e1641, (_e1641 < _e1642));
                                                        let _e1656 = select(_e1654, _e1652, (_e1652 > _e1654));
                                                        let _e1658 = select(_e1648, _e1656, (_e1656 > _e1648));
                                                        let _e1660 = select(_e1638, _e1637, (_e1637 > _e1638));
                                                        let _e1662 = select(_e1642, _e1641, (_e1641 > _e1642));
                                                        let _e1664 = select(_e1662, _e1660, (_e1660 < _e1662));
                                                        let _e1666 = select(_e1650, _e1664, (_e1664 < _e1650));
                                                        let _e1667 = -(_e1648);
                                                        let _e1673 = select(_e538, _e1658, (_e1658 > _e538));
                                                        if (_e1673 > (_e1666 + (select(_e1667, _e1650, (_e1650 > _e1667)) * 0.0000019073523f))) {
                                                            phi_2366_ = type_21();
                                                            phi_2367_ = true;
                                                        } else {
                                                            let _e1675 = (_e1673 > _e1108.member_1);
                                                            if _e1675 {
                                                                phi_2365_ = type_21();
                                                            } else {
                                                                let _e1679 = (_e1537[1][0] - _e1537[0][0]);
                                                                let _e1680 = (_e1537[1][1] - _e1537[0][1]);
                                                                let _e1681 = (_e1537[1][2] - _e1537[0][2]);
                                                                let _e1682 = vec3<f32>(_e1679, _e1680, _e1681);
                                                                let _e1683 = (_e1537[2][0] - _e1537[1][0]);
                                                                let _e1684 = (_e1537[2][1] - _e1537[1][1]);
                                                                let _e1685 = (_e1537[2][2] - _e1537[1][2]);
                                                                let _e1686 = vec3<f32>(_e1683, _e1684, _e1685);
                                                                let _e1687 = (_e1537[0][0] - _e1537[2][0]);
                                                                let _e1688 = (_e1537[0][1] - _e1537[2][1]);
                                                                let _e1689 = (_e1537[0][2] - _e1537[2][2]);
                                                                let _e1690 = vec3<f32>(_e1687, _e1688, _e1689);
                                                                let _e1693 = bitcast<f32>((bitcast<u32>(_e1679) & 2147483647u));
                                                                let _e1696 = bitcast<f32>((bitcast<u32>(_e1680) & 2147483647u));
                                                                let _e1698 = select(_e1696, _e1693, (_e1693 > _e1696));
                                                                let _e1701 = bitcast<f32>((bitcast<u32>(_e1681) & 2147483647u));
                                                                let _e1703 = select(_e1701, _e1698, (_e1698 > _e1701));
                                                                let _e1706 = bitcast<f32>((bitcast<u32>(_e1683) & 2147483647u));
                                                                let _e1709 = bitcast<f32>((bitcast<u32>(_e1684) & 2147483647u));
                                                                let _e1711 = select(_e1709, _e1706, (_e1706 > _e1709));
                                                                let _e1714 = bitcast<f32>((bitcast<u32>(_e1685) & 2147483647u));
                                                                let _e1716 = select(_e1714, _e1711, (_e1711 > _e1714));
                                                                let _e1719 = bitcast<f32>((bitcast<u32>(_e1687) & 2147483647u));
                                                                let _e1722 = bitcast<f32>((bitcast<u32>(_e1688) & 2147483647u));
                                                                let _e1724 = select(_e1722, _e1719, (_e1719 > _e1722));
                                                                let _e1727 = bitcast<f32>((bitcast<u32>(_e1689) & 2147483647u));
                                                                let _e1729 = select(_e1727, _e1724, (_e1724 > _e1727));
                                                                let _e1731 = select(_e1716, _e1703, (_e1703 > _e1716));
                                                                let _e1733 = select(_e1729, _e1731, (_e1731 > _e1729));
                                                                if (_e1703 == _e1733) {
                                                                    phi_2276_ = _e1686;
                                                                    phi_2277_ = _e1690;
                                                                } else {
                                                                    let _e1736 = vec3((_e1716 == _e1733));
                                                                    phi_2276_ = select(_e1682, _e1690, _e1736);
                                                                    phi_2277_ = select(_e1686, _e1682, _e1736);
                                                                }
                                                                let _e1740 = phi_2276_;
                                                                let _e1742 = phi_2277_;
                                                                let _e1749 = ((_e1740.y * _e1742.z) - (_e1742.y * _e1740.z));
                                                                let _e1754 = ((_e1740.z * _e1742.x) - (_e1742.z * _e1740.x));
                                                                let _e1757 = ((_e1740.x * _e1742.y) - (_e1742.x * _e1740.y));
                                                                if (_e1599 >= _e1603) {
                                                                    phi_2308_ = select(true, false, (_e1599 >= _e1607));
                                                                } else {
                                                                    phi_2308_ = true;
                                                                }
                                                                let _e1762 = phi_2308_;
                                                                if _e1762 {
                                                                    phi_2317_ = select(vec3<f32>(_e1537[2][0], _e1537[2][1], _e1537[2][2]), vec3<f32>(_e1537[1][0], _e1537[1][1], _e1537[1][2]), vec3((_e1603 >= _e1607)));
                                                                } else {
                                                                    phi_2317_ = vec3<f32>(_e1537[0][0], _e1537[0][1], _e1537[0][2]);
                                                                }
                                                                let _e1767 = phi_2317_;
                                                                let _e1784 = ((((_e1749 * (_e1767.x - _e392)) + (_e1754 * (_e1767.y - _e429))) + (_e1757 * (_e1767.z - _e465))) / (((_e1749 * _e417) + (_e1754 * _e453)) + (_e1757 * _e489)));
                                                                let _e1786 = select(_e1666, _e1784, (_e1784 < _e1666));
                                                                let _e1788 = select(_e1658, _e1786, (_e1786 > _e1658));
                                                                if (_e1788 >= _e538) {
                                                                    let _e1790 = (_e1788 <= _e1108.member_1);
                                                                    if _e1790 {
                                                                        let _e1791 = (1f / _e1609);
                                                                        phi_2357_ = type_21(_e1788, (_e1603 * _e1791), (_e1607 * _e1791), _e1168);
                                                                    } else {
                                                                        phi_2357_ = type_21();
                                                                    }
                                                                    let _e1796 = phi_2357_;
                                                                    phi_2359_ = _e1796;
                                                                    phi_2360_ = select(true, false, _e1790);
                                                                } else {
                                                                    phi_2359_ = type_21();
                                                                    phi_2360_ = true;
                                                                }
                                                                let _e1799 = phi_2359_;
                                                                let _e1801 = phi_2360_;
                                                                if _e1801 {
                                                                    phi_2364_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2364_ = _e1799;
                                                                }
                                                                let _e1803 = phi_2364_;
                                                                phi_2365_ = _e1803;
                                                            }
                                                            let _e1805 = phi_2365_;
                                                            phi_2366_ = _e1805;
                                                            phi_2367_ = _e1675;
                                                        }
                                                        let _e1807 = phi_2366_;
                                                        let _e1809 = phi_2367_;
                                                        phi_2371_ = _e1807;
                                                        phi_2372_ = _e1809;
                                                    }
                                                    let _e1811 = phi_2371_;
                                                    let _e1813 = phi_2372_;
                                                    phi_2376_ = _e1811;
                                                    phi_2377_ = _e1813;
                                                } else {
                                                    phi_2376_ = type_21();
                                                    phi_2377_ = true;
                                                }
                                                let _e1815 = phi_2376_;
                                                let _e1817 = phi_2377_;
                                                if _e1817 {
                                                    phi_2381_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2381_ = _e1815;
                                                }
                                                let _e1819 = phi_2381_;
                                                if (_e1819.member_3 != 4294967295u) {
                                                    if (_e1168 == _e166) {
                                                        phi_2710_ = false;
                                                    } else {
                                                        let _e1823 = (_e1168 < arrayLength((&global_4.member)));
                                                        if _e1823 {
                                                            if _e1823 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1825 = global_4.member[_e1168];
                                                            phi_2404_ = _e1825;
                                                        } else {
                                                            phi_2404_ = 4294967295u;
                                                        }
                                                        let _e1827 = phi_2404_;
                                                        let _e1828 = (_e1827 < arrayLength((&global_5.member)));
                                                        if _e1828 {
                                                            if _e1828 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1830 = global_5.member[_e1827];
                                                            phi_2418_ = _e1830;
                                                        } else {
                                                            phi_2418_ = 0i;
                                                        }
                                                        let _e1832 = phi_2418_;
                                                        let _e1833 = (_e1832 == 0i);
                                                        if _e1833 {
                                                            phi_2709_ = true;
                                                        } else {
                                                            if _e384 {
                                                                phi_2439_ = vec3<f32>(_e1537[0][0], _e1537[0][1], _e1537[0][2]);
                                                            } else {
                                                                if (_e360 == 1u) {
                                                                    phi_2438_ = vec3<f32>(_e1537[0][2], _e1537[0][0], _e1537[0][1]);
                                                                } else {
                                                                    phi_2438_ = vec3<f32>(_e1537[0][1], _e1537[0][2], _e1537[0][0]);
                                                                }
                                                                let _e1838 = phi_2438_;
                                                                phi_2439_ = _e1838;
                                                            }
                                                            let _e1841 = phi_2439_;
                                                            if _e384 {
                                                                phi_2456_ = vec3<f32>(_e1537[1][0], _e1537[1][1], _e1537[1][2]);
                                                            } else {
                                                                if (_e360 == 1u) {
                                                                    phi_2455_ = vec3<f32>(_e1537[1][2], _e1537[1][0], _e1537[1][1]);
                                                                } else {
                                                                    phi_2455_ = vec3<f32>(_e1537[1][1], _e1537[1][2], _e1537[1][0]);
                                                                }
                                                                let _e1846 = phi_2455_;
                                                                phi_2456_ = _e1846;
                                                            }
                                                            let _e1849 = phi_2456_;
                                                            if _e384 {
                                                                phi_2473_ = vec3<f32>(_e1537[2][0], _e1537[2][1], _e1537[2][2]);
                                                            } else {
                                                                if (_e360 == 1u) {
                                                                    phi_2472_ = vec3<f32>(_e1537[2][2], _e1537[2][0], _e1537[2][1]);
                                                                } else {
                                                                    phi_2472_ = vec3<f32>(_e1537[2][1], _e1537[2][2], _e1537[2][0]);
                                                                }
                                                                let _e1854 = phi_2472_;
                                                                phi_2473_ = _e1854;
                                                            }
                                                            let _e1857 = phi_2473_;
                                                            let _e1860 = (_e1849.x - _e1841.x);
                                                            let _e1863 = (_e1849.y - _e1841.y);
                                                            let _e1866 = (_e1849.z - _e1841.z);
                                                            let _e1868 = (_e1857.x - _e1841.x);
                                                            let _e1870 = (_e1857.y - _e1841.y);
                                                            let _e1872 = (_e1857.z - _e1841.z);
                                                            if (_e238.member_1 == 1u) {
                                                                phi_2509_ = (vec3<f32>(_e238.member[0], _e238.member[1], _e238.member[2]) - _e1841);
                                                            } else {
                                                                phi_2509_ = vec3<f32>(_e238.member[0], _e238.member[1], _e238.member[2]);
                                                            }
                                                            let _e1887 = phi_2509_;
                                                            let _e1893 = bitcast<f32>((bitcast<u32>((_e1860 * _e1870)) ^ _e238.member_3[0]));
                                                            let _e1897 = bitcast<f32>((bitcast<u32>((_e1863 * _e1868)) ^ _e238.member_3[0]));
                                                            let _e1901 = bitcast<f32>((bitcast<u32>((_e1863 * _e1872)) ^ _e238.member_3[0]));
                                                            let _e1905 = bitcast<f32>((bitcast<u32>((_e1866 * _e1870)) ^ _e238.member_3[0]));
                                                            let _e1909 = bitcast<f32>((bitcast<u32>((_e1866 * _e1868)) ^ _e238.member_3[0]));
                                                            let _e1913 = bitcast<f32>((bitcast<u32>((_e1860 * _e1872)) ^ _e238.member_3[0]));
                                                            let _e1914 = (_e1901 - _e1905);
                                                            let _e1915 = (_e1909 - _e1913);
                                                            let _e1916 = (_e1893 - _e1897);
                                                            let _e1940 = (bitcast<f32>((bitcast<u32>(_e1901) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1905) & 2147483647u)));
                                                            let _e1947 = (bitcast<f32>((bitcast<u32>(_e1909) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1913) & 2147483647u)));
                                                            let _e1954 = (bitcast<f32>((bitcast<u32>(_e1893) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1897) & 2147483647u)));
                                                            if (_e238.member_2 == 0f) {
                                                                phi_2691_ = 0f;
                                                            } else {
                                                                let _e1984 = bitcast<f32>((bitcast<u32>(_e1914) & 2147483647u));
                                                                let _e1987 = bitcast<f32>((bitcast<u32>(_e1915) & 2147483647u));
                                                                let _e1990 = bitcast<f32>((bitcast<u32>(_e1916) & 2147483647u));
                                                                let _e1992 = select(_e1990, _e1987, (_e1987 > _e1990));
                                                                let _e1996 = select(_e1990, _e1987, (_e1987 < _e1990));
                                                                let _e2000 = select(_e1987, _e1984, (_e1984 < _e1987));
                                                                let _e2002 = select(_e1987, _e1984, (_e1984 > _e1987));
                                                                let _e2004 = select(_e1990, _e2002, (_e2002 < _e1990));
                                                                phi_2691_ = bitcast<f32>((bitcast<u32>((_e238.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1992, _e1984, (_e1984 > _e1992)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2004, _e2000, (_e2000 > _e2004)))) ^ _e238.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1996, _e1984, (_e1984 < _e1996)))) ^ _e238.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1940 + _e1947) + _e1954))) ^ _e238.member_3[0]))) * 1.0000005f)) ^ _e238.member_3[0])))) ^ _e238.member_3[0]));
                                                            }
                                                            let _e2031 = phi_2691_;
                                                            phi_2709_ = (_e1833 || !(((((bitcast<f32>((bitcast<u32>((_e1887.x * _e1914)) ^ _e238.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1887.y * _e1915)) ^ _e238.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1887.z * _e1916)) ^ _e238.member_3[0]))) * f32(-(_e1832))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1887.x) & 2147483647u)) * _e1940)) ^ _e238.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1887.y) & 2147483647u)) * _e1947)) ^ _e238.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1887.z) & 2147483647u)) * _e1954)) ^ _e238.member_3[0]))))) ^ _e238.member_3[0])) + _e2031) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e2045 = phi_2709_;
                                                        phi_2710_ = _e2045;
                                                    }
                                                    let _e2047 = phi_2710_;
                                                    if _e2047 {
                                                        if (_e1819.member < _e1108.member.member) {
                                                            phi_2730_ = true;
                                                        } else {
                                                            if (_e1819.member == _e1108.member.member) {
                                                                phi_2729_ = (_e1819.member_3 < _e1108.member.member_3);
                                                            } else {
                                                                phi_2729_ = false;
                                                            }
                                                            let _e2057 = phi_2729_;
                                                            phi_2730_ = _e2057;
                                                        }
                                                        let _e2059 = phi_2730_;
                                                        if _e2059 {
                                                            phi_2736_ = type_38(_e1819, _e1819.member);
                                                        } else {
                                                            phi_2736_ = _e1108;
                                                        }
                                                        let _e2062 = phi_2736_;
                                                        phi_2737_ = _e2062;
                                                    } else {
                                                        phi_2737_ = _e1108;
                                                    }
                                                    let _e2064 = phi_2737_;
                                                    phi_2738_ = _e2064;
                                                } else {
                                                    phi_2738_ = _e1108;
                                                }
                                                let _e2066 = phi_2738_;
                                                phi_1087_ = _e2066;
                                            } else {
                                                phi_1087_ = type_38();
                                            }
                                            let _e2068 = phi_1087_;
                                            continue;
                                            continuing {
                                                phi_1086_ = _e2068;
                                                phi_1089_ = _e1123;
                                                phi_4317_ = _e580;
                                                break if !(_e1129);
                                            }
                                        }
                                        let _e2071 = phi_4317_;
                                        phi_4502_ = _e2071;
                                        if _e2071 {
                                            break;
                                        }
                                        phi_4506_ = _e2071;
                                        let _e2320 = local_11;
                                        phi_3978_ = _e2320;
                                        phi_3979_ = _e621;
                                        phi_3980_ = false;
                                        phi_3981_ = _e625;
                                    } else {
                                        if (_e621.member_1 >= _e98) {
                                            phi_3534_ = type_58(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_57(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_57(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e621.member_1 < _e98) {
                                            } else {
                                                phi_4502_ = true;
                                                break;
                                            }
                                            let _e637 = (_e360 * 2u);
                                            let _e639 = ((1u + _e637) % 7u);
                                            if (_e639 < 7u) {
                                            } else {
                                                phi_4502_ = true;
                                                break;
                                            }
                                            let _e644 = global_9.member[_e621.member_1][_e639];
                                            let _e646 = ((_e637 + 2u) % 7u);
                                            if (_e646 < 7u) {
                                            } else {
                                                phi_4502_ = true;
                                                break;
                                            }
                                            let _e651 = global_9.member[_e621.member_1][_e646];
                                            let _e652 = (_e359 * 2u);
                                            let _e654 = ((1u + _e652) % 7u);
                                            if (_e654 < 7u) {
                                            } else {
                                                phi_4502_ = true;
                                                break;
                                            }
                                            let _e659 = global_9.member[_e621.member_1][_e654];
                                            let _e661 = ((_e652 + 2u) % 7u);
                                            if (_e661 < 7u) {
                                            } else {
                                                phi_4502_ = true;
                                                break;
                                            }
                                            let _e666 = global_9.member[_e621.member_1][_e661];
                                            let _e667 = (_e361 * 2u);
                                            let _e669 = ((1u + _e667) % 7u);
                                            if (_e669 < 7u) {
                                            } else {
                                                phi_4502_ = true;
                                                break;
                                            }
                                            let _e674 = global_9.member[_e621.member_1][_e669];
                                            let _e676 = ((_e667 + 2u) % 7u);
                                            if (_e676 < 7u) {
                                            } else {
                                                phi_4502_ = true;
                                                break;
                                            }
                                            let _e681 = global_9.member[_e621.member_1][_e676];
                                            let _e704 = (bitcast<f32>((bitcast<u32>((_e621.member.member_1.x - _e621.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e705 = (bitcast<f32>((bitcast<u32>((_e621.member.member_1.y - _e621.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e706 = (bitcast<f32>((bitcast<u32>((_e621.member.member_1.z - _e621.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e708 = select(_e157, _e704, (_e704 > _e157));
                                            let _e710 = select(_e157, _e705, (_e705 > _e157));
                                            let _e712 = select(_e157, _e706, (_e706 > _e157));
                                            let _e737 = bitcast<u32>((f32(bitcast<i32>((_e644 & 2097151u))) * _e708));
                                            let _e742 = (bitcast<i32>((_e644 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e745 = bitcast<f32>((_e737 & bitcast<u32>(_e742)));
                                            let _e746 = bitcast<u32>((f32(bitcast<i32>((_e659 & 2097151u))) * _e710));
                                            let _e751 = (bitcast<i32>((_e659 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e754 = bitcast<f32>((_e746 & bitcast<u32>(_e751)));
                                            let _e755 = bitcast<u32>((f32(bitcast<i32>((_e674 & 2097151u))) * _e712));
                                            let _e760 = (bitcast<i32>((_e674 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e763 = bitcast<f32>((_e755 & bitcast<u32>(_e760)));
                                            let _e767 = bitcast<f32>((_e737 & bitcast<u32>(~(_e742))));
                                            let _e771 = bitcast<f32>((_e746 & bitcast<u32>(~(_e751))));
                                            let _e775 = bitcast<f32>((_e755 & bitcast<u32>(~(_e760))));
                                            let _e776 = bitcast<u32>((f32(bitcast<i32>((_e651 & 2097151u))) * _e708));
                                            let _e781 = (bitcast<i32>((_e651 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e784 = bitcast<f32>((_e776 & bitcast<u32>(_e781)));
                                            let _e785 = bitcast<u32>((f32(bitcast<i32>((_e666 & 2097151u))) * _e710));
                                            let _e790 = (bitcast<i32>((_e666 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e793 = bitcast<f32>((_e785 & bitcast<u32>(_e790)));
                                            let _e794 = bitcast<u32>((f32(bitcast<i32>((_e681 & 2097151u))) * _e712));
                                            let _e799 = (bitcast<i32>((_e681 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e802 = bitcast<f32>((_e794 & bitcast<u32>(_e799)));
                                            let _e806 = bitcast<f32>((_e776 & bitcast<u32>(~(_e781))));
                                            let _e810 = bitcast<f32>((_e785 & bitcast<u32>(~(_e790))));
                                            let _e814 = bitcast<f32>((_e794 & bitcast<u32>(~(_e799))));
                                            let _e815 = (_e621.member.member.x + _e745);
                                            let _e816 = (_e621.member.member.y + _e754);
                                            let _e817 = (_e621.member.member.z + _e763);
                                            let _e820 = (_e621.member.member_1.x - _e784);
                                            let _e821 = (_e621.member.member_1.y - _e793);
                                            let _e822 = (_e621.member.member_1.z - _e802);
                                            let _e841 = (_e820 - _e815);
                                            let _e842 = (_e821 - _e816);
                                            let _e843 = (_e822 - _e817);
                                            let _e845 = select(_e842, _e841, (_e841 > _e842));
                                            let _e847 = select(_e843, _e845, (_e845 > _e843));
                                            if (_e847 < (1024f * _e157)) {
                                                phi_3235_ = 0u;
                                            } else {
                                                phi_3235_ = select(2u, 1u, (_e847 < (2097152f * _e157)));
                                            }
                                            let _e854 = phi_3235_;
                                            switch bitcast<i32>(_e854) {
                                                case 0: {
                                                    phi_3241_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3241_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3241_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3241_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e857 = phi_3241_;
                                            let _e863 = global_9.member[_e621.member_1][0u];
                                            let _e867 = global_9.member[_e621.member_1][2u];
                                            let _e871 = global_9.member[_e621.member_1][4u];
                                            let _e875 = global_9.member[_e621.member_1][6u];
                                            let _e887 = (((_e867 >> bitcast<u32>(22i)) | ((_e871 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e875 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e888 = (_e863 & 268435455u);
                                            let _e889 = (_e887 & 268435455u);
                                            let _e892 = ((_e863 >> bitcast<u32>(28u)) & 7u);
                                            let _e900 = ((_e863 >> bitcast<u32>(31i)) | (((_e887 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e901 = (_e892 != 0u);
                                            if (_e892 == 0u) {
                                                phi_3496_ = _e888;
                                            } else {
                                                if (_e892 == 7u) {
                                                    phi_3495_ = 2147483648u;
                                                } else {
                                                    phi_3495_ = ((2147483648u | (_e892 << bitcast<u32>(28u))) | (_e889 & 268435455u));
                                                }
                                                let _e910 = phi_3495_;
                                                phi_3496_ = _e910;
                                            }
                                            let _e912 = phi_3496_;
                                            if _e901 {
                                                let _e913 = (_e892 != 7u);
                                                if _e913 {
                                                    phi_3506_ = (_e889 + (_e892 * ((3u * _e857) + 1u)));
                                                } else {
                                                    phi_3506_ = u32();
                                                }
                                                let _e917 = phi_3506_;
                                                phi_3508_ = _e917;
                                                phi_3509_ = select(true, false, _e913);
                                            } else {
                                                phi_3508_ = u32();
                                                phi_3509_ = true;
                                            }
                                            let _e920 = phi_3508_;
                                            let _e922 = phi_3509_;
                                            if (_e900 == 0u) {
                                                phi_3530_ = (_e888 + select(0u, 1u, !(_e901)));
                                            } else {
                                                if (_e900 == 7u) {
                                                    phi_3529_ = 2147483648u;
                                                } else {
                                                    phi_3529_ = ((2147483648u | (_e900 << bitcast<u32>(28u))) | (select(_e920, _e889, _e922) & 268435455u));
                                                }
                                                let _e935 = phi_3529_;
                                                phi_3530_ = _e935;
                                            }
                                            let _e937 = phi_3530_;
                                            phi_3534_ = type_58(array<vec4<f32>, 3>(vec4<f32>(_e815, (_e621.member.member.x + _e767), _e820, (_e621.member.member_1.x - _e806)), vec4<f32>(_e816, (_e621.member.member.y + _e771), _e821, (_e621.member.member_1.y - _e810)), vec4<f32>(_e817, (_e621.member.member.z + _e775), _e822, (_e621.member.member_1.z - _e814))), type_57(type_33((_e621.member.member + vec4<f32>(_e745, _e754, _e763, 0f)), (_e621.member.member_1 - vec4<f32>(_e784, _e793, _e802, 0f))), _e912), type_57(type_33((_e621.member.member + vec4<f32>(_e767, _e771, _e775, 0f)), (_e621.member.member_1 - vec4<f32>(_e806, _e810, _e814, 0f))), _e937));
                                        }
                                        let _e942 = phi_3534_;
                                        let _e954 = ((_e942.member[0].x - _e415) * _e420);
                                        let _e955 = ((_e942.member[0].y - _e415) * _e420);
                                        let _e956 = ((_e942.member[0].z - _e416) * _e420);
                                        let _e957 = ((_e942.member[0].w - _e416) * _e420);
                                        let _e967 = ((_e942.member[1].x - _e451) * _e456);
                                        let _e968 = ((_e942.member[1].y - _e451) * _e456);
                                        let _e969 = ((_e942.member[1].z - _e452) * _e456);
                                        let _e970 = ((_e942.member[1].w - _e452) * _e456);
                                        let _e980 = ((_e942.member[2].x - _e487) * _e492);
                                        let _e981 = ((_e942.member[2].y - _e487) * _e492);
                                        let _e982 = ((_e942.member[2].z - _e488) * _e492);
                                        let _e983 = ((_e942.member[2].w - _e488) * _e492);
                                        let _e985 = select(_e982, _e980, (_e980 < _e982));
                                        let _e987 = select(_e983, _e981, (_e981 < _e983));
                                        let _e989 = select(_e982, _e980, (_e980 > _e982));
                                        let _e991 = select(_e983, _e981, (_e981 > _e983));
                                        let _e993 = select(_e956, _e954, (_e954 < _e956));
                                        let _e995 = select(_e957, _e955, (_e955 < _e957));
                                        let _e997 = select(_e969, _e967, (_e967 < _e969));
                                        let _e999 = select(_e970, _e968, (_e968 < _e970));
                                        let _e1001 = select(_e997, _e993, (_e993 > _e997));
                                        let _e1003 = select(_e999, _e995, (_e995 > _e999));
                                        let _e1005 = select(_e985, _e1001, (_e1001 > _e985));
                                        let _e1007 = select(_e987, _e1003, (_e1003 > _e987));
                                        let _e1009 = select(_e956, _e954, (_e954 > _e956));
                                        let _e1011 = select(_e957, _e955, (_e955 > _e957));
                                        let _e1013 = select(_e969, _e967, (_e967 > _e969));
                                        let _e1015 = select(_e970, _e968, (_e968 > _e970));
                                        let _e1017 = select(_e1013, _e1009, (_e1009 < _e1013));
                                        let _e1019 = select(_e1015, _e1011, (_e1011 < _e1015));
                                        let _e1024 = -(_e985);
                                        let _e1025 = -(_e987);
                                        let _e1032 = (select(_e989, _e1017, (_e1017 < _e989)) + (select(_e1024, _e989, (_e989 > _e1024)) * 0.0000019073523f));
                                        let _e1033 = (select(_e991, _e1019, (_e1019 < _e991)) + (select(_e1025, _e991, (_e991 > _e1025)) * 0.0000019073523f));
                                        let _e1035 = select(_e538, _e1005, (_e1005 > _e538));
                                        let _e1037 = select(_e538, _e1007, (_e1007 > _e538));
                                        let _e1042 = (_e1035 <= select(_e582.member_1, _e1032, (_e1032 < _e582.member_1)));
                                        let _e1043 = (_e1037 <= select(_e582.member_1, _e1033, (_e1033 < _e582.member_1)));
                                        let _e1044 = (_e1035 <= _e1037);
                                        if _e1042 {
                                            if _e1043 {
                                                if _e1044 {
                                                    phi_3878_ = _e942.member_2;
                                                } else {
                                                    phi_3878_ = _e942.member_1;
                                                }
                                                let _e1048 = phi_3878_;
                                                let _e1070 = (_e625 % 128u);
                                                let _e1071 = (_e1070 < 128u);
                                                if _e1071 {
                                                } else {
                                                    phi_4502_ = true;
                                                    break;
                                                }
                                                local_8[_e1070] = _e1048.member_1;
                                                if _e1071 {
                                                } else {
                                                    phi_4502_ = true;
                                                    break;
                                                }
                                                local_7[_e1070] = _e1048.member.member.x;
                                                if _e1071 {
                                                } else {
                                                    phi_4502_ = true;
                                                    break;
                                                }
                                                local_6[_e1070] = _e1048.member.member.y;
                                                if _e1071 {
                                                } else {
                                                    phi_4502_ = true;
                                                    break;
                                                }
                                                local_5[_e1070] = _e1048.member.member.z;
                                                if _e1071 {
                                                } else {
                                                    phi_4502_ = true;
                                                    break;
                                                }
                                                local_4[_e1070] = _e1048.member.member_1.x;
                                                if _e1071 {
                                                } else {
                                                    phi_4502_ = true;
                                                    break;
                                                }
                                                local_3[_e1070] = _e1048.member.member_1.y;
                                                if _e1071 {
                                                } else {
                                                    phi_4502_ = true;
                                                    break;
                                                }
                                                local_2[_e1070] = _e1048.member.member_1.z;
                                                if _e1071 {
                                                } else {
                                                    phi_4502_ = true;
                                                    break;
                                                }
                                                local_9[_e1070] = select(_e1037, _e1035, (_e1035 > _e1037));
                                                if _e1044 {
                                                    phi_3955_ = _e942.member_1;
                                                } else {
                                                    phi_3955_ = _e942.member_2;
                                                }
                                                let _e1084 = phi_3955_;
                                                phi_3956_ = _e1084;
                                                phi_3957_ = (_e625 + 1u);
                                            } else {
                                                phi_3956_ = type_57();
                                                phi_3957_ = u32();
                                            }
                                            let _e1086 = phi_3956_;
                                            let _e1088 = phi_3957_;
                                            phi_3959_ = _e1086;
                                            phi_3960_ = _e1088;
                                            phi_3961_ = select(true, false, _e1043);
                                        } else {
                                            phi_3959_ = type_57();
                                            phi_3960_ = u32();
                                            phi_3961_ = true;
                                        }
                                        let _e1091 = phi_3959_;
                                        let _e1093 = phi_3960_;
                                        let _e1095 = phi_3961_;
                                        if _e1095 {
                                            if _e1042 {
                                                phi_3970_ = _e942.member_1;
                                            } else {
                                                phi_3970_ = _e942.member_2;
                                            }
                                            let _e1099 = phi_3970_;
                                            phi_3975_ = _e1099;
                                            phi_3976_ = select(_e1043, true, _e1042);
                                        } else {
                                            phi_3975_ = _e1091;
                                            phi_3976_ = _e623;
                                        }
                                        let _e1102 = phi_3975_;
                                        let _e1104 = phi_3976_;
                                        phi_4506_ = _e580;
                                        phi_3978_ = _e582;
                                        phi_3979_ = _e1102;
                                        phi_3980_ = _e1104;
                                        phi_3981_ = select(_e1093, _e625, _e1095);
                                    }
                                    let _e2073 = phi_4506_;
                                    let _e2075 = phi_3978_;
                                    let _e2077 = phi_3979_;
                                    let _e2079 = phi_3980_;
                                    let _e2081 = phi_3981_;
                                    phi_4505_ = _e2073;
                                    phi_3982_ = _e2075;
                                    phi_3983_ = _e2077;
                                    phi_3984_ = (_e586 - 1u);
                                    phi_3985_ = _e2079;
                                    phi_3986_ = _e2081;
                                } else {
                                    phi_4505_ = _e580;
                                    phi_3982_ = _e582;
                                    phi_3983_ = _e621;
                                    phi_3984_ = _e586;
                                    phi_3985_ = _e623;
                                    phi_3986_ = _e625;
                                }
                                let _e2083 = phi_4505_;
                                let _e2085 = phi_3982_;
                                let _e2087 = phi_3983_;
                                let _e2089 = phi_3984_;
                                let _e2091 = phi_3985_;
                                let _e2093 = phi_3986_;
                                phi_4504_ = _e2083;
                                phi_3987_ = _e2085;
                                phi_3988_ = _e2087;
                                phi_3989_ = _e2089;
                                phi_3990_ = _e2091;
                                phi_3991_ = _e2093;
                            } else {
                                phi_4504_ = _e580;
                                phi_3987_ = type_38();
                                phi_3988_ = type_57();
                                phi_3989_ = u32();
                                phi_3990_ = bool();
                                phi_3991_ = u32();
                            }
                            let _e2095 = phi_4504_;
                            let _e2097 = phi_3987_;
                            let _e2099 = phi_3988_;
                            let _e2101 = phi_3989_;
                            let _e2103 = phi_3990_;
                            let _e2105 = phi_3991_;
                            phi_4503_ = _e2095;
                            phi_960_ = _e2097;
                            phi_963_ = _e2099;
                            phi_965_ = _e2101;
                            phi_967_ = _e2103;
                            phi_969_ = _e2105;
                            phi_3992_ = _e594;
                        } else {
                            phi_4503_ = _e580;
                            phi_960_ = type_38();
                            phi_963_ = type_57();
                            phi_965_ = u32();
                            phi_967_ = bool();
                            phi_969_ = u32();
                            phi_3992_ = false;
                        }
                        let _e2107 = phi_4503_;
                        let _e2109 = phi_960_;
                        let _e2111 = phi_963_;
                        let _e2113 = phi_965_;
                        let _e2115 = phi_967_;
                        let _e2117 = phi_969_;
                        let _e2119 = phi_3992_;
                        continue;
                        continuing {
                            phi_4323_ = _e2107;
                            phi_959_ = _e2109;
                            phi_962_ = _e2111;
                            phi_964_ = _e2113;
                            phi_966_ = _e2115;
                            phi_968_ = _e2117;
                            phi_4502_ = _e2107;
                            break if !(_e2119);
                        }
                    }
                    let _e2122 = phi_4502_;
                    if _e2122 {
                        break;
                    }
                    let _e2124 = local_10;
                    if (_e2124.member.member_3 != 4294967295u) {
                        let _e2129 = (_e362 / 3i);
                        let _e2136 = bitcast<f32>((bitcast<u32>((_e2129 + 127i)) << bitcast<u32>(23i)));
                        let _e2144 = (((_e2124.member.member * _e2136) * _e2136) * bitcast<f32>((bitcast<u32>(((_e362 - (2i * _e2129)) + 127i)) << bitcast<u32>(23i))));
                        let _e2146 = select(340282350000000000000000000000000000000f, _e2144, (_e2144 < 340282350000000000000000000000000000000f));
                        phi_4044_ = type_21(select(-340282350000000000000000000000000000000f, _e2146, (_e2146 > -340282350000000000000000000000000000000f)), _e2124.member.member_1, _e2124.member.member_2, _e2124.member.member_3);
                    } else {
                        phi_4044_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2153 = phi_4044_;
                    if _e239 {
                    } else {
                        break;
                    }
                    global_7.member[_e145] = _e2153;
                    if _e160 {
                    } else {
                        break;
                    }
                    let _e2157 = select(0u, 1u, (_e306 <= _e316));
                    if (_e2157 > 0u) {
                        let _e2159 = (1u < _e113);
                        if _e2159 {
                            if (0u < _e113) {
                            } else {
                                break;
                            }
                            let _e2163 = atomicAdd((&global_8.member[0u]), _e2157);
                            if ((_e2163 + _e2157) < _e2163) {
                                if _e2159 {
                                } else {
                                    break;
                                }
                                let _e2168 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                    }
                    let _e2171 = select(0u, 1u, (_e2153.member_3 != 4294967295u));
                    if (_e2171 > 0u) {
                        let _e2173 = (3u < _e113);
                        if _e2173 {
                            if (2u < _e113) {
                            } else {
                                break;
                            }
                            let _e2177 = atomicAdd((&global_8.member[2u]), _e2171);
                            if ((_e2177 + _e2171) < _e2177) {
                                if _e2173 {
                                } else {
                                    break;
                                }
                                let _e2182 = atomicAdd((&global_8.member[3u]), 1u);
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
fn trace_paths_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
