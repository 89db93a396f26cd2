struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_13 {
    member: array<array<u32, 4>>,
}

struct type_16 {
    member: vec4<u32>,
}

struct type_25 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_27 {
    member: array<type_25>,
}

struct type_29 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_30 {
    member: type_29,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_32 {
    member: array<type_30>,
}

struct type_37 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_39 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_42 {
    member: type_25,
    member_1: f32,
}

struct type_47 {
    member: array<vec4<u32>, 2>,
}

struct type_50 {
    member: array<i32>,
}

struct type_57 {
    member: type_37,
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
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_47;
@group(0) @binding(2) 
var<uniform> global_3: type_47;
@group(0) @binding(3) 
var<storage> global_4: type_13;
@group(0) @binding(5) 
var<storage> global_5: type_4;
@group(0) @binding(6) 
var<storage> global_6: type_50;
@group(0) @binding(7) 
var<storage> global_7: type_32;
@group(0) @binding(8) 
var<storage, read_write> global_8: type_27;
@group(0) @binding(9) 
var<storage, read_write> global_9: type_63;
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
    var phi_395_: type_39;
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
    var phi_959_: type_42;
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
    var phi_1086_: type_42;
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
    var phi_2357_: type_25;
    var phi_2359_: type_25;
    var phi_2360_: bool;
    var phi_2364_: type_25;
    var phi_2365_: type_25;
    var phi_2366_: type_25;
    var phi_2367_: bool;
    var phi_2371_: type_25;
    var phi_2372_: bool;
    var phi_2376_: type_25;
    var phi_2377_: bool;
    var phi_2381_: type_25;
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
    var phi_2736_: type_42;
    var phi_2737_: type_42;
    var phi_2738_: type_42;
    var phi_1087_: type_42;
    var phi_4317_: bool;
    var phi_4506_: bool;
    var phi_3978_: type_42;
    var phi_3979_: type_57;
    var phi_3980_: bool;
    var phi_3981_: u32;
    var phi_4505_: bool;
    var phi_3982_: type_42;
    var phi_3983_: type_57;
    var phi_3984_: u32;
    var phi_3985_: bool;
    var phi_3986_: u32;
    var phi_4504_: bool;
    var phi_3987_: type_42;
    var phi_3988_: type_57;
    var phi_3989_: u32;
    var phi_3990_: bool;
    var phi_3991_: u32;
    var phi_4503_: bool;
    var phi_960_: type_42;
    var phi_963_: type_57;
    var phi_965_: u32;
    var phi_967_: bool;
    var phi_969_: u32;
    var phi_3992_: bool;
    var phi_4502_: bool;
    var local_10: type_42;
    var phi_4044_: type_25;
    var local_11: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e98 = global;
            let _e100 = arrayLength((&global_4.member));
            let _e103 = arrayLength((&global_10.member));
            let _e115 = arrayLength((&global_9.member));
            let _e119 = global_3.member[0u][0u];
            let _e123 = global_3.member[0u][1u];
            let _e127 = global_3.member[0u][2u];
            let _e131 = global_3.member[0u][3u];
            let _e135 = global_3.member[1u][0u];
            let _e139 = global_3.member[1u][1u];
            let _e143 = global_3.member[1u][2u];
            let _e147 = (_e98.x + (_e98.y * 2097152u));
            let _e159 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e131) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e119), bitcast<i32>(_e123), bitcast<i32>(_e127));
            local = array<i32, 3>(bitcast<i32>(_e135), bitcast<i32>(_e139), bitcast<i32>(_e143));
            let _e162 = (_e147 < arrayLength((&global_7.member)));
            if _e162 {
                if _e162 {
                } else {
                    break;
                }
                let _e166 = global_7.member[_e147].member_2;
                phi_327_ = _e166;
            } else {
                phi_327_ = 4294967295u;
            }
            let _e168 = phi_327_;
            let _e171 = global_1.member[0u];
            let _e175 = global_2.member[0u][0u];
            let _e179 = global_2.member[0u][1u];
            let _e183 = global_2.member[0u][2u];
            let _e187 = global_2.member[0u][3u];
            let _e191 = global_2.member[1u][0u];
            let _e195 = global_2.member[1u][1u];
            let _e199 = global_2.member[1u][2u];
            let _e203 = global_2.member[1u][3u];
            let _e204 = bitcast<f32>(_e175);
            let _e205 = bitcast<f32>(_e179);
            let _e206 = bitcast<f32>(_e183);
            let _e208 = bitcast<f32>(_e191);
            let _e209 = array<u32, 3>(_e195, _e199, _e203);
            let _e211 = bitcast<i32>(_e171);
            if (_e211 < -126i) {
                phi_371_ = -126i;
            } else {
                phi_371_ = select(_e211, 127i, (_e211 > 127i));
            }
            let _e216 = phi_371_;
            let _e221 = bitcast<f32>((bitcast<u32>((_e216 + 127i)) << bitcast<u32>(23i)));
            let _e227 = bitcast<f32>((bitcast<u32>(((_e211 - _e216) + 127i)) << bitcast<u32>(23i)));
            if (_e187 == 0u) {
                phi_395_ = type_39(array<f32, 3>(_e204, _e205, _e206), _e187, _e208, _e209);
            } else {
                phi_395_ = type_39(array<f32, 3>(((_e204 * _e221) * _e227), ((_e205 * _e221) * _e227), ((_e206 * _e221) * _e227)), _e187, ((_e208 * _e221) * _e227), _e209);
            }
            let _e240 = phi_395_;
            if _e162 {
                let _e241 = (_e147 < arrayLength((&global_8.member)));
                if _e241 {
                    if _e162 {
                    } else {
                        break;
                    }
                    let _e251 = global_7.member[_e147].member.member_2[0u];
                    let _e253 = (bitcast<u32>(_e251) & 2147483647u);
                    let _e259 = global_7.member[_e147].member.member_2[1u];
                    let _e261 = (bitcast<u32>(_e259) & 2147483647u);
                    let _e267 = global_7.member[_e147].member.member_2[2u];
                    let _e269 = (bitcast<u32>(_e267) & 2147483647u);
                    let _e275 = global_7.member[_e147].member.member[0u];
                    let _e277 = (bitcast<u32>(_e275) & 2147483647u);
                    let _e283 = global_7.member[_e147].member.member[1u];
                    let _e285 = (bitcast<u32>(_e283) & 2147483647u);
                    let _e291 = global_7.member[_e147].member.member[2u];
                    let _e293 = (bitcast<u32>(_e291) & 2147483647u);
                    let _e295 = select(_e261, _e253, (_e261 < _e253));
                    let _e297 = select(_e269, _e295, (_e269 < _e295));
                    let _e299 = select(_e277, _e297, (_e277 < _e297));
                    let _e301 = select(_e285, _e299, (_e285 < _e299));
                    let _e303 = select(_e293, _e301, (_e293 < _e301));
                    let _e308 = global_7.member[_e147].member.member_1;
                    let _e310 = (bitcast<u32>(_e308) & 2147483647u);
                    let _e318 = global_7.member[_e147].member.member_3;
                    let _e324 = (((select(_e310, _e303, (_e310 < _e303)) < 2139095040u) && ((bitcast<u32>(_e318) & 2147483647u) <= 2139095040u)) && (_e297 > 0u));
                    if _e324 {
                        let _e327 = (bitcast<u32>(bitcast<f32>(_e297)) & 2147483647u);
                        if (_e327 >= 8388608u) {
                            phi_501_ = (bitcast<i32>((_e327 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_501_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e327)), 32u, (_e327 == 0u))));
                        }
                        let _e341 = phi_501_;
                        phi_502_ = _e341;
                    } else {
                        phi_502_ = 0i;
                    }
                    let _e343 = phi_502_;
                    let _e344 = (_e253 == _e297);
                    if _e344 {
                        phi_512_ = true;
                    } else {
                        phi_512_ = (_e261 == _e297);
                    }
                    let _e347 = phi_512_;
                    let _e348 = select(1u, 0u, _e344);
                    if _e347 {
                        let _e349 = (_e348 + 1u);
                        phi_522_ = _e349;
                        phi_523_ = _e349;
                        phi_525_ = select(true, false, (_e349 == 2u));
                    } else {
                        phi_522_ = u32();
                        phi_523_ = 0u;
                        phi_525_ = true;
                    }
                    let _e353 = phi_522_;
                    let _e355 = phi_523_;
                    let _e357 = phi_525_;
                    if _e357 {
                        phi_530_ = (_e355 + 1u);
                    } else {
                        phi_530_ = 0u;
                    }
                    let _e361 = phi_530_;
                    let _e362 = select(_e353, _e355, _e357);
                    let _e363 = select(_e348, select(2u, _e348, _e347), _e357);
                    let _e364 = -(_e343);
                    if (_e364 < -126i) {
                        phi_562_ = -126i;
                    } else {
                        phi_562_ = select(_e364, 127i, (_e364 > 127i));
                    }
                    let _e369 = phi_562_;
                    let _e374 = bitcast<f32>((bitcast<u32>((_e369 + 127i)) << bitcast<u32>(23i)));
                    let _e380 = bitcast<f32>((bitcast<u32>(((_e364 - _e369) + 127i)) << bitcast<u32>(23i)));
                    let _e385 = global_7.member[_e147].member.member;
                    let _e386 = (_e362 == 0u);
                    if _e386 {
                        phi_580_ = _e385[0];
                    } else {
                        phi_580_ = _e385[1];
                    }
                    let _e390 = phi_580_;
                    let _e391 = (_e362 == 2u);
                    if _e391 {
                        phi_586_ = _e385[2];
                    } else {
                        phi_586_ = _e390;
                    }
                    let _e394 = phi_586_;
                    let _e395 = global_7.member[_e147].member.member_2;
                    if _e386 {
                        phi_597_ = _e395[0];
                    } else {
                        phi_597_ = _e395[1];
                    }
                    let _e399 = phi_597_;
                    if _e391 {
                        phi_603_ = _e395[2];
                    } else {
                        phi_603_ = _e399;
                    }
                    let _e402 = phi_603_;
                    let _e404 = ((_e402 * _e374) * _e380);
                    let _e408 = (bitcast<f32>((bitcast<u32>(_e404) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e408 {
                        let _e412 = (bitcast<f32>((bitcast<u32>(_e394) & 2147483647u)) * 0.00000011920929f);
                        phi_626_ = select(0.00000000000011368684f, _e412, (_e412 > 0.00000000000011368684f));
                    } else {
                        phi_626_ = 0f;
                    }
                    let _e416 = phi_626_;
                    let _e417 = (_e394 + _e416);
                    let _e418 = (_e394 - _e416);
                    let _e419 = select(_e404, 0f, _e408);
                    if _e408 {
                        phi_637_ = 38685626000000000000000000f;
                    } else {
                        phi_637_ = (1f / _e404);
                    }
                    let _e422 = phi_637_;
                    let _e423 = (_e361 == 0u);
                    if _e423 {
                        phi_646_ = _e385[0];
                    } else {
                        phi_646_ = _e385[1];
                    }
                    let _e427 = phi_646_;
                    let _e428 = (_e361 == 2u);
                    if _e428 {
                        phi_652_ = _e385[2];
                    } else {
                        phi_652_ = _e427;
                    }
                    let _e431 = phi_652_;
                    if _e423 {
                        phi_663_ = _e395[0];
                    } else {
                        phi_663_ = _e395[1];
                    }
                    let _e435 = phi_663_;
                    if _e428 {
                        phi_669_ = _e395[2];
                    } else {
                        phi_669_ = _e435;
                    }
                    let _e438 = phi_669_;
                    let _e440 = ((_e438 * _e374) * _e380);
                    let _e444 = (bitcast<f32>((bitcast<u32>(_e440) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e444 {
                        let _e448 = (bitcast<f32>((bitcast<u32>(_e431) & 2147483647u)) * 0.00000011920929f);
                        phi_692_ = select(0.00000000000011368684f, _e448, (_e448 > 0.00000000000011368684f));
                    } else {
                        phi_692_ = 0f;
                    }
                    let _e452 = phi_692_;
                    let _e453 = (_e431 + _e452);
                    let _e454 = (_e431 - _e452);
                    let _e455 = select(_e440, 0f, _e444);
                    if _e444 {
                        phi_703_ = 38685626000000000000000000f;
                    } else {
                        phi_703_ = (1f / _e440);
                    }
                    let _e458 = phi_703_;
                    let _e459 = (_e363 == 0u);
                    if _e459 {
                        phi_712_ = _e385[0];
                    } else {
                        phi_712_ = _e385[1];
                    }
                    let _e463 = phi_712_;
                    let _e464 = (_e363 == 2u);
                    if _e464 {
                        phi_718_ = _e385[2];
                    } else {
                        phi_718_ = _e463;
                    }
                    let _e467 = phi_718_;
                    if _e459 {
                        phi_729_ = _e395[0];
                    } else {
                        phi_729_ = _e395[1];
                    }
                    let _e471 = phi_729_;
                    if _e464 {
                        phi_735_ = _e395[2];
                    } else {
                        phi_735_ = _e471;
                    }
                    let _e474 = phi_735_;
                    let _e476 = ((_e474 * _e374) * _e380);
                    let _e480 = (bitcast<f32>((bitcast<u32>(_e476) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e480 {
                        let _e484 = (bitcast<f32>((bitcast<u32>(_e467) & 2147483647u)) * 0.00000011920929f);
                        phi_758_ = select(0.00000000000011368684f, _e484, (_e484 > 0.00000000000011368684f));
                    } else {
                        phi_758_ = 0f;
                    }
                    let _e488 = phi_758_;
                    let _e489 = (_e467 + _e488);
                    let _e490 = (_e467 - _e488);
                    let _e491 = select(_e476, 0f, _e480);
                    if _e480 {
                        phi_769_ = 38685626000000000000000000f;
                    } else {
                        phi_769_ = (1f / _e476);
                    }
                    let _e494 = phi_769_;
                    let _e497 = bitcast<f32>((bitcast<u32>(_e394) & 2147483647u));
                    let _e500 = bitcast<f32>((bitcast<u32>(_e431) & 2147483647u));
                    let _e502 = select(_e500, _e497, (_e497 > _e500));
                    let _e505 = bitcast<f32>((bitcast<u32>(_e467) & 2147483647u));
                    if (_e324 && (select(_e505, _e502, (_e502 > _e505)) <= 1099511600000f)) {
                        let _e510 = (_e343 / 3i);
                        let _e517 = bitcast<f32>((bitcast<u32>((_e510 + 127i)) << bitcast<u32>(23i)));
                        let _e524 = bitcast<f32>((bitcast<u32>(((_e343 - (2i * _e510)) + 127i)) << bitcast<u32>(23i)));
                        let _e525 = (((_e308 * _e517) * _e517) * _e524);
                        let _e527 = select(340282350000000000000000000000000000000f, _e525, (_e525 < 340282350000000000000000000000000000000f));
                        let _e532 = (((_e318 * _e517) * _e517) * _e524);
                        let _e534 = select(340282350000000000000000000000000000000f, _e532, (_e532 < 340282350000000000000000000000000000000f));
                        phi_869_ = select(-340282350000000000000000000000000000000f, _e534, (_e534 > -340282350000000000000000000000000000000f));
                        phi_870_ = select(-340282350000000000000000000000000000000f, _e527, (_e527 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_869_ = 0f;
                        phi_870_ = 1f;
                    }
                    let _e538 = phi_869_;
                    let _e540 = phi_870_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e544 = (_e362 % 3u);
                    let _e545 = (_e544 < 3u);
                    if _e545 {
                    } else {
                        break;
                    }
                    let _e547 = local_1[_e544];
                    let _e550 = (_e361 % 3u);
                    let _e551 = (_e550 < 3u);
                    if _e551 {
                    } else {
                        break;
                    }
                    let _e553 = local_1[_e550];
                    let _e556 = (_e363 % 3u);
                    let _e557 = (_e556 < 3u);
                    if _e557 {
                    } else {
                        break;
                    }
                    let _e559 = local_1[_e556];
                    if _e545 {
                    } else {
                        break;
                    }
                    let _e564 = local[_e544];
                    if _e551 {
                    } else {
                        break;
                    }
                    let _e568 = local[_e550];
                    if _e557 {
                    } else {
                        break;
                    }
                    let _e572 = local[_e556];
                    phi_4323_ = false;
                    phi_959_ = type_42(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e538);
                    phi_962_ = type_57(type_37(vec4<f32>((f32(_e547) * _e159), (f32(_e553) * _e159), (f32(_e559) * _e159), 0f), vec4<f32>((f32(_e564) * _e159), (f32(_e568) * _e159), (f32(_e572) * _e159), 0f)), select(0u, 2147483648u, (_e100 == 0u)));
                    phi_964_ = ((3u * _e100) + 1u);
                    phi_966_ = (_e540 <= _e538);
                    phi_968_ = 0u;
                    loop {
                        let _e582 = phi_4323_;
                        let _e584 = phi_959_;
                        let _e586 = phi_962_;
                        let _e588 = phi_964_;
                        let _e590 = phi_966_;
                        let _e592 = phi_968_;
                        local_10 = _e584;
                        if _e590 {
                            phi_979_ = true;
                        } else {
                            phi_979_ = (_e592 > 0u);
                        }
                        let _e595 = phi_979_;
                        if _e595 {
                            let _e596 = (_e588 > 0u);
                            if _e596 {
                                if _e590 {
                                    phi_1065_ = _e586;
                                    phi_1066_ = _e590;
                                    phi_1067_ = _e592;
                                } else {
                                    let _e597 = (_e592 - 1u);
                                    let _e598 = (_e597 % 128u);
                                    let _e599 = (_e598 < 128u);
                                    if _e599 {
                                    } else {
                                        phi_4502_ = true;
                                        break;
                                    }
                                    let _e601 = local_7[_e598];
                                    if _e599 {
                                    } else {
                                        phi_4502_ = true;
                                        break;
                                    }
                                    let _e603 = local_6[_e598];
                                    if _e599 {
                                    } else {
                                        phi_4502_ = true;
                                        break;
                                    }
                                    let _e605 = local_5[_e598];
                                    if _e599 {
                                    } else {
                                        phi_4502_ = true;
                                        break;
                                    }
                                    let _e607 = local_4[_e598];
                                    if _e599 {
                                    } else {
                                        phi_4502_ = true;
                                        break;
                                    }
                                    let _e609 = local_3[_e598];
                                    if _e599 {
                                    } else {
                                        phi_4502_ = true;
                                        break;
                                    }
                                    let _e611 = local_2[_e598];
                                    if _e599 {
                                    } else {
                                        phi_4502_ = true;
                                        break;
                                    }
                                    let _e616 = local_8[_e598];
                                    if _e599 {
                                    } else {
                                        phi_4502_ = true;
                                        break;
                                    }
                                    let _e619 = local_9[_e598];
                                    phi_1065_ = type_57(type_37(vec4<f32>(_e601, _e603, _e605, 0f), vec4<f32>(_e607, _e609, _e611, 0f)), _e616);
                                    phi_1066_ = (_e619 <= _e584.member_1);
                                    phi_1067_ = _e597;
                                }
                                let _e623 = phi_1065_;
                                let _e625 = phi_1066_;
                                let _e627 = phi_1067_;
                                if _e625 {
                                    let _e632 = (_e623.member_1 & 268435455u);
                                    if ((_e623.member_1 & 2147483648u) != 0u) {
                                        phi_1086_ = _e584;
                                        phi_1089_ = type_8(0u, ((_e623.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1092 = phi_1086_;
                                            let _e1094 = phi_1089_;
                                            local_11 = _e1092;
                                            if (_e1094.member < _e1094.member_1) {
                                                phi_1090_ = type_8((_e1094.member + 1u), _e1094.member_1);
                                                phi_1112_ = type_8(1u, _e1094.member);
                                            } else {
                                                phi_1090_ = _e1094;
                                                phi_1112_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1107 = phi_1090_;
                                            let _e1109 = phi_1112_;
                                            let _e1113 = (bitcast<i32>(_e1109.member) != 0i);
                                            if _e1113 {
                                                let _e1118 = (_e623.member.member_1.x - _e623.member.member.x);
                                                let _e1121 = (_e623.member.member_1.y - _e623.member.member.y);
                                                let _e1124 = (_e623.member.member_1.z - _e623.member.member.z);
                                                let _e1126 = select(_e1121, _e1118, (_e1118 > _e1121));
                                                let _e1128 = select(_e1124, _e1126, (_e1126 > _e1124));
                                                let _e1130 = (_e1128 < (1024f * _e159));
                                                if _e1130 {
                                                    phi_1153_ = 0u;
                                                } else {
                                                    phi_1153_ = select(2u, 1u, (_e1128 < (2097152f * _e159)));
                                                }
                                                let _e1135 = phi_1153_;
                                                switch bitcast<i32>(_e1135) {
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
                                                let _e1138 = phi_1159_;
                                                switch bitcast<i32>(_e1135) {
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
                                                let _e1145 = phi_1169_;
                                                let _e1147 = ((_e632 + (_e1109.member_1 * ((3u * _e1138) + 1u))) + (3u * _e1145));
                                                let _e1148 = (_e1147 < _e103);
                                                if _e1148 {
                                                    if _e1148 {
                                                    } else {
                                                        phi_4317_ = true;
                                                        break;
                                                    }
                                                    let _e1150 = global_10.member[_e1147];
                                                    phi_1185_ = _e1150;
                                                } else {
                                                    phi_1185_ = 4294967295u;
                                                }
                                                let _e1152 = phi_1185_;
                                                if _e1130 {
                                                    phi_1218_ = 0u;
                                                } else {
                                                    phi_1218_ = select(2u, 1u, (_e1128 < (2097152f * _e159)));
                                                }
                                                let _e1157 = phi_1218_;
                                                switch bitcast<i32>(_e1157) {
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
                                                let _e1160 = phi_1224_;
                                                let _e1164 = (_e632 + (_e1109.member_1 * ((3u * _e1160) + 1u)));
                                                switch bitcast<i32>(_e1157) {
                                                    case 0: {
                                                        let _e1430 = (_e1164 < _e103);
                                                        if _e1430 {
                                                            if _e1430 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1432 = global_10.member[_e1164];
                                                            phi_1248_ = _e1432;
                                                        } else {
                                                            phi_1248_ = 0u;
                                                        }
                                                        let _e1434 = phi_1248_;
                                                        let _e1436 = ((10u * _e362) & 31u);
                                                        let _e1445 = ((10u * _e361) & 31u);
                                                        let _e1454 = ((10u * _e363) & 31u);
                                                        let _e1463 = (_e1164 + 1u);
                                                        let _e1464 = (_e1463 < _e103);
                                                        if _e1464 {
                                                            if _e1464 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1466 = global_10.member[_e1463];
                                                            phi_1291_ = _e1466;
                                                        } else {
                                                            phi_1291_ = 0u;
                                                        }
                                                        let _e1468 = phi_1291_;
                                                        let _e1491 = (_e1164 + 2u);
                                                        let _e1492 = (_e1491 < _e103);
                                                        if _e1492 {
                                                            if _e1492 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1494 = global_10.member[_e1491];
                                                            phi_1334_ = _e1494;
                                                        } else {
                                                            phi_1334_ = 0u;
                                                        }
                                                        let _e1496 = phi_1334_;
                                                        phi_1805_ = array<array<f32, 3>, 3>(array<f32, 3>((_e623.member.member.x + (f32(bitcast<i32>(((_e1434 >> bitcast<u32>(_e1436)) & 1023u))) * _e159)), (_e623.member.member.y + (f32(bitcast<i32>(((_e1434 >> bitcast<u32>(_e1445)) & 1023u))) * _e159)), (_e623.member.member.z + (f32(bitcast<i32>(((_e1434 >> bitcast<u32>(_e1454)) & 1023u))) * _e159))), array<f32, 3>((_e623.member.member.x + (f32(bitcast<i32>(((_e1468 >> bitcast<u32>(_e1436)) & 1023u))) * _e159)), (_e623.member.member.y + (f32(bitcast<i32>(((_e1468 >> bitcast<u32>(_e1445)) & 1023u))) * _e159)), (_e623.member.member.z + (f32(bitcast<i32>(((_e1468 >> bitcast<u32>(_e1454)) & 1023u))) * _e159))), array<f32, 3>((_e623.member.member.x + (f32(bitcast<i32>(((_e1496 >> bitcast<u32>(_e1436)) & 1023u))) * _e159)), (_e623.member.member.y + (f32(bitcast<i32>(((_e1496 >> bitcast<u32>(_e1445)) & 1023u))) * _e159)), (_e623.member.member.z + (f32(bitcast<i32>(((_e1496 >> bitcast<u32>(_e1454)) & 1023u))) * _e159))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1253 = (_e1164 < _e103);
                                                        if _e1253 {
                                                            if _e1253 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1255 = global_10.member[_e1164];
                                                            phi_1377_ = _e1255;
                                                        } else {
                                                            phi_1377_ = 0u;
                                                        }
                                                        let _e1257 = phi_1377_;
                                                        let _e1258 = (_e1164 + 1u);
                                                        let _e1259 = (_e1258 < _e103);
                                                        if _e1259 {
                                                            if _e1259 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1261 = global_10.member[_e1258];
                                                            phi_1392_ = _e1261;
                                                        } else {
                                                            phi_1392_ = 0u;
                                                        }
                                                        let _e1263 = phi_1392_;
                                                        let _e1264 = (_e362 == 1u);
                                                        if _e1264 {
                                                            phi_1402_ = ((_e1257 >> bitcast<u32>(21i)) | (_e1263 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1402_ = (_e1263 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1273 = phi_1402_;
                                                        let _e1280 = (_e361 == 1u);
                                                        if _e1280 {
                                                            phi_1422_ = ((_e1257 >> bitcast<u32>(21i)) | (_e1263 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1422_ = (_e1263 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1289 = phi_1422_;
                                                        let _e1296 = (_e363 == 1u);
                                                        if _e1296 {
                                                            phi_1442_ = ((_e1257 >> bitcast<u32>(21i)) | (_e1263 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1442_ = (_e1263 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1305 = phi_1442_;
                                                        let _e1313 = (_e1164 + 2u);
                                                        let _e1314 = (_e1313 < _e103);
                                                        if _e1314 {
                                                            if _e1314 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1316 = global_10.member[_e1313];
                                                            phi_1468_ = _e1316;
                                                        } else {
                                                            phi_1468_ = 0u;
                                                        }
                                                        let _e1318 = phi_1468_;
                                                        let _e1319 = (_e1164 + 3u);
                                                        let _e1320 = (_e1319 < _e103);
                                                        if _e1320 {
                                                            if _e1320 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1322 = global_10.member[_e1319];
                                                            phi_1483_ = _e1322;
                                                        } else {
                                                            phi_1483_ = 0u;
                                                        }
                                                        let _e1324 = phi_1483_;
                                                        if _e1264 {
                                                            phi_1493_ = ((_e1318 >> bitcast<u32>(21i)) | (_e1324 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1493_ = (_e1324 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1333 = phi_1493_;
                                                        if _e1280 {
                                                            phi_1513_ = ((_e1318 >> bitcast<u32>(21i)) | (_e1324 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1513_ = (_e1324 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1348 = phi_1513_;
                                                        if _e1296 {
                                                            phi_1533_ = ((_e1318 >> bitcast<u32>(21i)) | (_e1324 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1533_ = (_e1324 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1363 = phi_1533_;
                                                        let _e1371 = (_e1164 + 4u);
                                                        let _e1372 = (_e1371 < _e103);
                                                        if _e1372 {
                                                            if _e1372 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1374 = global_10.member[_e1371];
                                                            phi_1559_ = _e1374;
                                                        } else {
                                                            phi_1559_ = 0u;
                                                        }
                                                        let _e1376 = phi_1559_;
                                                        let _e1377 = (_e1164 + 5u);
                                                        let _e1378 = (_e1377 < _e103);
                                                        if _e1378 {
                                                            if _e1378 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1380 = global_10.member[_e1377];
                                                            phi_1574_ = _e1380;
                                                        } else {
                                                            phi_1574_ = 0u;
                                                        }
                                                        let _e1382 = phi_1574_;
                                                        if _e1264 {
                                                            phi_1584_ = ((_e1376 >> bitcast<u32>(21i)) | (_e1382 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1584_ = (_e1382 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1391 = phi_1584_;
                                                        if _e1280 {
                                                            phi_1604_ = ((_e1376 >> bitcast<u32>(21i)) | (_e1382 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1604_ = (_e1382 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1406 = phi_1604_;
                                                        if _e1296 {
                                                            phi_1624_ = ((_e1376 >> bitcast<u32>(21i)) | (_e1382 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1624_ = (_e1382 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1421 = phi_1624_;
                                                        phi_1805_ = array<array<f32, 3>, 3>(array<f32, 3>((_e623.member.member.x + (f32(bitcast<i32>((select(_e1273, _e1257, _e386) & 2097151u))) * _e159)), (_e623.member.member.y + (f32(bitcast<i32>((select(_e1289, _e1257, _e423) & 2097151u))) * _e159)), (_e623.member.member.z + (f32(bitcast<i32>((select(_e1305, _e1257, _e459) & 2097151u))) * _e159))), array<f32, 3>((_e623.member.member.x + (f32(bitcast<i32>((select(_e1333, _e1318, _e386) & 2097151u))) * _e159)), (_e623.member.member.y + (f32(bitcast<i32>((select(_e1348, _e1318, _e423) & 2097151u))) * _e159)), (_e623.member.member.z + (f32(bitcast<i32>((select(_e1363, _e1318, _e459) & 2097151u))) * _e159))), array<f32, 3>((_e623.member.member.x + (f32(bitcast<i32>((select(_e1391, _e1376, _e386) & 2097151u))) * _e159)), (_e623.member.member.y + (f32(bitcast<i32>((select(_e1406, _e1376, _e423) & 2097151u))) * _e159)), (_e623.member.member.z + (f32(bitcast<i32>((select(_e1421, _e1376, _e459) & 2097151u))) * _e159))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1166 = (_e1164 + _e362);
                                                        let _e1167 = (_e1166 < _e103);
                                                        if _e1167 {
                                                            if _e1167 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1169 = global_10.member[_e1166];
                                                            phi_1651_ = _e1169;
                                                        } else {
                                                            phi_1651_ = 0u;
                                                        }
                                                        let _e1171 = phi_1651_;
                                                        let _e1175 = (_e1164 + _e361);
                                                        let _e1176 = (_e1175 < _e103);
                                                        if _e1176 {
                                                            if _e1176 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1178 = global_10.member[_e1175];
                                                            phi_1669_ = _e1178;
                                                        } else {
                                                            phi_1669_ = 0u;
                                                        }
                                                        let _e1180 = phi_1669_;
                                                        let _e1184 = (_e1164 + _e363);
                                                        let _e1185 = (_e1184 < _e103);
                                                        if _e1185 {
                                                            if _e1185 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1187 = global_10.member[_e1184];
                                                            phi_1687_ = _e1187;
                                                        } else {
                                                            phi_1687_ = 0u;
                                                        }
                                                        let _e1189 = phi_1687_;
                                                        let _e1194 = (_e1164 + 3u);
                                                        let _e1195 = (_e1194 + _e362);
                                                        let _e1196 = (_e1195 < _e103);
                                                        if _e1196 {
                                                            if _e1196 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1198 = global_10.member[_e1195];
                                                            phi_1707_ = _e1198;
                                                        } else {
                                                            phi_1707_ = 0u;
                                                        }
                                                        let _e1200 = phi_1707_;
                                                        let _e1204 = (_e1194 + _e361);
                                                        let _e1205 = (_e1204 < _e103);
                                                        if _e1205 {
                                                            if _e1205 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1207 = global_10.member[_e1204];
                                                            phi_1725_ = _e1207;
                                                        } else {
                                                            phi_1725_ = 0u;
                                                        }
                                                        let _e1209 = phi_1725_;
                                                        let _e1213 = (_e1194 + _e363);
                                                        let _e1214 = (_e1213 < _e103);
                                                        if _e1214 {
                                                            if _e1214 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1216 = global_10.member[_e1213];
                                                            phi_1743_ = _e1216;
                                                        } else {
                                                            phi_1743_ = 0u;
                                                        }
                                                        let _e1218 = phi_1743_;
                                                        let _e1223 = (_e1164 + 6u);
                                                        let _e1224 = (_e1223 + _e362);
                                                        let _e1225 = (_e1224 < _e103);
                                                        if _e1225 {
                                                            if _e1225 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1227 = global_10.member[_e1224];
                                                            phi_1763_ = _e1227;
                                                        } else {
                                                            phi_1763_ = 0u;
                                                        }
                                                        let _e1229 = phi_1763_;
                                                        let _e1233 = (_e1223 + _e361);
                                                        let _e1234 = (_e1233 < _e103);
                                                        if _e1234 {
                                                            if _e1234 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1236 = global_10.member[_e1233];
                                                            phi_1781_ = _e1236;
                                                        } else {
                                                            phi_1781_ = 0u;
                                                        }
                                                        let _e1238 = phi_1781_;
                                                        let _e1242 = (_e1223 + _e363);
                                                        let _e1243 = (_e1242 < _e103);
                                                        if _e1243 {
                                                            if _e1243 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1245 = global_10.member[_e1242];
                                                            phi_1799_ = _e1245;
                                                        } else {
                                                            phi_1799_ = 0u;
                                                        }
                                                        let _e1247 = phi_1799_;
                                                        phi_1805_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1171)) * _e159), (f32(bitcast<i32>(_e1180)) * _e159), (f32(bitcast<i32>(_e1189)) * _e159)), array<f32, 3>((f32(bitcast<i32>(_e1200)) * _e159), (f32(bitcast<i32>(_e1209)) * _e159), (f32(bitcast<i32>(_e1218)) * _e159)), array<f32, 3>((f32(bitcast<i32>(_e1229)) * _e159), (f32(bitcast<i32>(_e1238)) * _e159), (f32(bitcast<i32>(_e1247)) * _e159)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1805_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1521 = phi_1805_;
                                                let _e1529 = (_e1521[0][2] - _e467);
                                                let _e1532 = (((_e1521[0][0] - _e394) * _e491) - (_e1529 * _e419));
                                                let _e1535 = (((_e1521[0][1] - _e431) * _e491) - (_e1529 * _e455));
                                                let _e1542 = (_e1521[1][2] - _e467);
                                                let _e1545 = (((_e1521[1][0] - _e394) * _e491) - (_e1542 * _e419));
                                                let _e1548 = (((_e1521[1][1] - _e431) * _e491) - (_e1542 * _e455));
                                                let _e1555 = (_e1521[2][2] - _e467);
                                                let _e1558 = (((_e1521[2][0] - _e394) * _e491) - (_e1555 * _e419));
                                                let _e1561 = (((_e1521[2][1] - _e431) * _e491) - (_e1555 * _e455));
                                                let _e1562 = (_e1558 * _e1548);
                                                let _e1563 = (_e1561 * _e1545);
                                                let _e1564 = (_e1532 * _e1561);
                                                let _e1565 = (_e1535 * _e1558);
                                                let _e1566 = (_e1545 * _e1535);
                                                let _e1567 = (_e1548 * _e1532);
                                                let _e1572 = (((_e1562 >= _e1563) && (_e1564 >= _e1565)) && (_e1566 >= _e1567));
                                                if (_e1572 || (((_e1562 <= _e1563) && (_e1564 <= _e1565)) && (_e1566 <= _e1567))) {
                                                    let _e1579 = select(-1f, 1f, _e1572);
                                                    let _e1581 = ((_e1562 - _e1563) * _e1579);
                                                    let _e1583 = select(0f, _e1581, (_e1581 > 0f));
                                                    let _e1585 = ((_e1564 - _e1565) * _e1579);
                                                    let _e1587 = select(0f, _e1585, (_e1585 > 0f));
                                                    let _e1589 = ((_e1566 - _e1567) * _e1579);
                                                    let _e1591 = select(0f, _e1589, (_e1589 > 0f));
                                                    let _e1593 = ((_e1583 + _e1587) + _e1591);
                                                    if (_e1593 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2371_ = type_25();
                                                        phi_2372_ = true;
                                                    } else {
                                                        let _e1596 = select(_e1521[1][0], _e1521[0][0], (_e1521[0][0] < _e1521[1][0]));
                                                        let _e1600 = select(_e1521[1][0], _e1521[0][0], (_e1521[0][0] > _e1521[1][0]));
                                                        let _e1604 = select(_e1521[1][1], _e1521[0][1], (_e1521[0][1] < _e1521[1][1]));
                                                        let _e1608 = select(_e1521[1][1], _e1521[0][1], (_e1521[0][1] > _e1521[1][1]));
                                                        let _e1612 = select(_e1521[1][2], _e1521[0][2], (_e1521[0][2] < _e1521[1][2]));
                                                        let _e1616 = select(_e1521[1][2], _e1521[0][2], (_e1521[0][2] > _e1521[1][2]));
                                                        let _e1621 = ((select(_e1521[2][0], _e1596, (_e1596 < _e1521[2][0])) - _e417) * _e422);
                                                        let _e1622 = ((select(_e1521[2][0], _e1600, (_e1600 > _e1521[2][0])) - _e418) * _e422);
                                                        let _e1625 = ((select(_e1521[2][1], _e1604, (_e1604 < _e1521[2][1])) - _e453) * _e458);
                                                        let _e1626 = ((select(_e1521[2][1], _e1608, (_e1608 > _e1521[2][1])) - _e454) * _e458);
                                                        let _e1629 = ((select(_e1521[2][2], _e1612, (_e1612 < _e1521[2][2])) - _e489) * _e494);
                                                        let _e1630 = ((select(_e1521[2][2], _e1616, (_e1616 > _e1521[2][2])) - _e490) * _e494);
                                                        let _e1632 = select(_e1630, _e1629, (_e1629 < _e1630));
                                                        let _e1634 = select(_e1630, _e1629, (_e1629 > _e1630));
                                                        let _e1636 = select(_e1622, _e1621, (_e1621 < _e1622));
                                                        let _e1638 = select(_e1626, _e1625, (_e1625 < _e1626));
                                                        let _e1640 = select(_e1638, _e1636, (_e1636 > _e1638));
                                                        let _e1642 = select(_e1632, _e1640, (_e1640 > _e1632));
                                                        let _e1644 = select(_e1622, _e1621, (_e1621 > _e1622));
                                                        let _e1646 = select(_e1626, _e1625, (_e1625 > _e1626));
                                                        let _e1648 = select(_e1646, _e1644, (_e1644 < _e1646));
                                                        let _e1650 = select(_e1634, _e1648, (_e1648 < _e1634));
                                                        let _e1651 = -(_e1632);
                                                        let _e1657 = select(_e540, _e1642, (_e1642 > _e540));
                                                        if (_e1657 > (_e1650 + (select(_e1651, _e1634, (_e1634 > _e1651)) * 0.0000019073523f))) {
                                                            phi_2366_ = type_25();
                                                            phi_2367_ = true;
                                                        } else {
                                                            let _e1659 = (_e1657 > _e1092.member_1);
                                                            if _e1659 {
                                                                phi_2365_ = type_25();
                                                            } else {
                                                                let _e1663 = (_e1521[1][0] - _e1521[0][0]);
                                                                let _e1664 = (_e1521[1][1] - _e1521[0][1]);
                                                                let _e1665 = (_e1521[1][2] - _e1521[0][2]);
                                                                let _e1666 = vec3<f32>(_e1663, _e1664, _e1665);
                                                                let _e1667 = (_e1521[2][0] - _e1521[1][0]);
                                                                let _e1668 = (_e1521[2][1] - _e1521[1][1]);
                                                                let _e1669 = (_e1521[2][2] - _e1521[1][2]);
                                                                let _e1670 = vec3<f32>(_e1667, _e1668, _e1669);
                                                                let _e1671 = (_e1521[0][0] - _e1521[2][0]);
                                                                let _e1672 = (_e1521[0][1] - _e1521[2][1]);
                                                                let _e1673 = (_e1521[0][2] - _e1521[2][2]);
                                                                let _e1674 = vec3<f32>(_e1671, _e1672, _e1673);
                                                                let _e1677 = bitcast<f32>((bitcast<u32>(_e1663) & 2147483647u));
                                                                let _e1680 = bitcast<f32>((bitcast<u32>(_e1664) & 2147483647u));
                                                                let _e1682 = select(_e1680, _e1677, (_e1677 > _e1680));
                                                                let _e1685 = bitcast<f32>((bitcast<u32>(_e1665) & 2147483647u));
                                                                let _e1687 = select(_e1685, _e1682, (_e1682 > _e1685));
                                                                let _e1690 = bitcast<f32>((bitcast<u32>(_e1667) & 2147483647u));
                                                                let _e1693 = bitcast<f32>((bitcast<u32>(_e1668) & 2147483647u));
                                                                let _e1695 = select(_e1693, _e1690, (_e1690 > _e1693));
                                                                let _e1698 = bitcast<f32>((bitcast<u32>(_e1669) & 2147483647u));
                                                                let _e1700 = select(_e1698, _e1695, (_e1695 > _e1698));
                                                                let _e1703 = bitcast<f32>((bitcast<u32>(_e1671) & 2147483647u));
                                                                let _e1706 = bitcast<f32>((bitcast<u32>(_e1672) & 2147483647u));
                                                                let _e1708 = select(_e1706, _e1703, (_e1703 > _e1706));
                                                                let _e1711 = bitcast<f32>((bitcast<u32>(_e1673) & 2147483647u));
                                                                let _e1713 = select(_e1711, _e1708, (_e1708 > _e1711));
                                                                let _e1715 = select(_e1700, _e1687, (_e1687 > _e1700));
                                                                let _e1717 = select(_e1713, _e1715, (_e1715 > _e1713));
                                                                if (_e1687 == _e1717) {
                                                                    phi_2276_ = _e1670;
                                                                    phi_2277_ = _e1674;
                                                                } else {
                                                                    let _e1720 = vec3((_e1700 == _e1717));
                                                                    phi_2276_ = select(_e1666, _e1674, _e1720);
                                                                    phi_2277_ = select(_e1670, _e1666, _e1720);
                                                                }
                                                                let _e1724 = phi_2276_;
                                                                let _e1726 = phi_2277_;
                                                                let _e1733 = ((_e1724.y * _e1726.z) - (_e1726.y * _e1724.z));
                                                                let _e1738 = ((_e1724.z * _e1726.x) - (_e1726.z * _e1724.x));
                                                                let _e1741 = ((_e1724.x * _e1726.y) - (_e1726.x * _e1724.y));
                                                                if (_e1583 >= _e1587) {
                                                                    phi_2308_ = select(true, false, (_e1583 >= _e1591));
                                                                } else {
                                                                    phi_2308_ = true;
                                                                }
                                                                let _e1746 = phi_2308_;
                                                                if _e1746 {
                                                                    phi_2317_ = select(vec3<f32>(_e1521[2][0], _e1521[2][1], _e1521[2][2]), vec3<f32>(_e1521[1][0], _e1521[1][1], _e1521[1][2]), vec3((_e1587 >= _e1591)));
                                                                } else {
                                                                    phi_2317_ = vec3<f32>(_e1521[0][0], _e1521[0][1], _e1521[0][2]);
                                                                }
                                                                let _e1751 = phi_2317_;
                                                                let _e1768 = ((((_e1733 * (_e1751.x - _e394)) + (_e1738 * (_e1751.y - _e431))) + (_e1741 * (_e1751.z - _e467))) / (((_e1733 * _e419) + (_e1738 * _e455)) + (_e1741 * _e491)));
                                                                let _e1770 = select(_e1650, _e1768, (_e1768 < _e1650));
                                                                let _e1772 = select(_e1642, _e1770, (_e1770 > _e1642));
                                                                if (_e1772 >= _e540) {
                                                                    let _e1774 = (_e1772 <= _e1092.member_1);
                                                                    if _e1774 {
                                                                        let _e1775 = (1f / _e1593);
                                                                        phi_2357_ = type_25(_e1772, (_e1587 * _e1775), (_e1591 * _e1775), _e1152);
                                                                    } else {
                                                                        phi_2357_ = type_25();
                                                                    }
                                                                    let _e1780 = phi_2357_;
                                                                    phi_2359_ = _e1780;
                                                                    phi_2360_ = select(true, false, _e1774);
                                                                } else {
                                                                    phi_2359_ = type_25();
                                                                    phi_2360_ = true;
                                                                }
                                                                let _e1783 = phi_2359_;
                                                                let _e1785 = phi_2360_;
                                                                if _e1785 {
                                                                    phi_2364_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2364_ = _e1783;
                                                                }
                                                                let _e1787 = phi_2364_;
                                                                phi_2365_ = _e1787;
                                                            }
                                                            let _e1789 = phi_2365_;
                                                            phi_2366_ = _e1789;
                                                            phi_2367_ = _e1659;
                                                        }
                                                        let _e1791 = phi_2366_;
                                                        let _e1793 = phi_2367_;
                                                        phi_2371_ = _e1791;
                                                        phi_2372_ = _e1793;
                                                    }
                                                    let _e1795 = phi_2371_;
                                                    let _e1797 = phi_2372_;
                                                    phi_2376_ = _e1795;
                                                    phi_2377_ = _e1797;
                                                } else {
                                                    phi_2376_ = type_25();
                                                    phi_2377_ = true;
                                                }
                                                let _e1799 = phi_2376_;
                                                let _e1801 = phi_2377_;
                                                if _e1801 {
                                                    phi_2381_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2381_ = _e1799;
                                                }
                                                let _e1803 = phi_2381_;
                                                if (_e1803.member_3 != 4294967295u) {
                                                    if (_e1152 == _e168) {
                                                        phi_2710_ = false;
                                                    } else {
                                                        let _e1807 = (_e1152 < arrayLength((&global_5.member)));
                                                        if _e1807 {
                                                            if _e1807 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1809 = global_5.member[_e1152];
                                                            phi_2404_ = _e1809;
                                                        } else {
                                                            phi_2404_ = 4294967295u;
                                                        }
                                                        let _e1811 = phi_2404_;
                                                        let _e1812 = (_e1811 < arrayLength((&global_6.member)));
                                                        if _e1812 {
                                                            if _e1812 {
                                                            } else {
                                                                phi_4317_ = true;
                                                                break;
                                                            }
                                                            let _e1814 = global_6.member[_e1811];
                                                            phi_2418_ = _e1814;
                                                        } else {
                                                            phi_2418_ = 0i;
                                                        }
                                                        let _e1816 = phi_2418_;
                                                        let _e1817 = (_e1816 == 0i);
                                                        if _e1817 {
                                                            phi_2709_ = true;
                                                        } else {
                                                            if _e386 {
                                                                phi_2439_ = vec3<f32>(_e1521[0][0], _e1521[0][1], _e1521[0][2]);
                                                            } else {
                                                                if (_e362 == 1u) {
                                                                    phi_2438_ = vec3<f32>(_e1521[0][2], _e1521[0][0], _e1521[0][1]);
                                                                } else {
                                                                    phi_2438_ = vec3<f32>(_e1521[0][1], _e1521[0][2], _e1521[0][0]);
                                                                }
                                                                let _e1822 = phi_2438_;
                                                                phi_2439_ = _e1822;
                                                            }
                                                            let _e1825 = phi_2439_;
                                                            if _e386 {
                                                                phi_2456_ = vec3<f32>(_e1521[1][0], _e1521[1][1], _e1521[1][2]);
                                                            } else {
                                                                if (_e362 == 1u) {
                                                                    phi_2455_ = vec3<f32>(_e1521[1][2], _e1521[1][0], _e1521[1][1]);
                                                                } else {
                                                                    phi_2455_ = vec3<f32>(_e1521[1][1], _e1521[1][2], _e1521[1][0]);
                                                                }
                                                                let _e1830 = phi_2455_;
                                                                phi_2456_ = _e1830;
                                                            }
                                                            let _e1833 = phi_2456_;
                                                            if _e386 {
                                                                phi_2473_ = vec3<f32>(_e1521[2][0], _e1521[2][1], _e1521[2][2]);
                                                            } else {
                                                                if (_e362 == 1u) {
                                                                    phi_2472_ = vec3<f32>(_e1521[2][2], _e1521[2][0], _e1521[2][1]);
                                                                } else {
                                                                    phi_2472_ = vec3<f32>(_e1521[2][1], _e1521[2][2], _e1521[2][0]);
                                                                }
                                                                let _e1838 = phi_2472_;
                                                                phi_2473_ = _e1838;
                                                            }
                                                            let _e1841 = phi_2473_;
                                                            let _e1844 = (_e1833.x - _e1825.x);
                                                            let _e1847 = (_e1833.y - _e1825.y);
                                                            let _e1850 = (_e1833.z - _e1825.z);
                                                            let _e1852 = (_e1841.x - _e1825.x);
                                                            let _e1854 = (_e1841.y - _e1825.y);
                                                            let _e1856 = (_e1841.z - _e1825.z);
                                                            if (_e240.member_1 == 1u) {
                                                                phi_2509_ = (vec3<f32>(_e240.member[0], _e240.member[1], _e240.member[2]) - _e1825);
                                                            } else {
                                                                phi_2509_ = vec3<f32>(_e240.member[0], _e240.member[1], _e240.member[2]);
                                                            }
                                                            let _e1871 = phi_2509_;
                                                            let _e1877 = bitcast<f32>((bitcast<u32>((_e1844 * _e1854)) ^ _e240.member_3[0]));
                                                            let _e1881 = bitcast<f32>((bitcast<u32>((_e1847 * _e1852)) ^ _e240.member_3[0]));
                                                            let _e1885 = bitcast<f32>((bitcast<u32>((_e1847 * _e1856)) ^ _e240.member_3[0]));
                                                            let _e1889 = bitcast<f32>((bitcast<u32>((_e1850 * _e1854)) ^ _e240.member_3[0]));
                                                            let _e1893 = bitcast<f32>((bitcast<u32>((_e1850 * _e1852)) ^ _e240.member_3[0]));
                                                            let _e1897 = bitcast<f32>((bitcast<u32>((_e1844 * _e1856)) ^ _e240.member_3[0]));
                                                            let _e1898 = (_e1885 - _e1889);
                                                            let _e1899 = (_e1893 - _e1897);
                                                            let _e1900 = (_e1877 - _e1881);
                                                            let _e1924 = (bitcast<f32>((bitcast<u32>(_e1885) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1889) & 2147483647u)));
                                                            let _e1931 = (bitcast<f32>((bitcast<u32>(_e1893) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1897) & 2147483647u)));
                                                            let _e1938 = (bitcast<f32>((bitcast<u32>(_e1877) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1881) & 2147483647u)));
                                                            if (_e240.member_2 == 0f) {
                                                                phi_2691_ = 0f;
                                                            } else {
                                                                let _e1968 = bitcast<f32>((bitcast<u32>(_e1898) & 2147483647u));
                                                                let _e1971 = bitcast<f32>((bitcast<u32>(_e1899) & 2147483647u));
                                                                let _e1974 = bitcast<f32>((bitcast<u32>(_e1900) & 2147483647u));
                                                                let _e1976 = select(_e1974, _e1971, (_e1971 > _e1974));
                                                                let _e1980 = select(_e1974, _e1971, (_e1971 < _e1974));
                                                                let _e1984 = select(_e1971, _e1968, (_e1968 < _e1971));
                                                                let _e1986 = select(_e1971, _e1968, (_e1968 > _e1971));
                                                                let _e1988 = select(_e1974, _e1986, (_e1986 < _e1974));
                                                                phi_2691_ = bitcast<f32>((bitcast<u32>((_e240.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1976, _e1968, (_e1968 > _e1976)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1988, _e1984, (_e1984 > _e1988)))) ^ _e240.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1980, _e1968, (_e1968 < _e1980)))) ^ _e240.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1924 + _e1931) + _e1938))) ^ _e240.member_3[0]))) * 1.0000005f)) ^ _e240.member_3[0])))) ^ _e240.member_3[0]));
                                                            }
                                                            let _e2015 = phi_2691_;
                                                            phi_2709_ = (_e1817 || !(((((bitcast<f32>((bitcast<u32>((_e1871.x * _e1898)) ^ _e240.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1871.y * _e1899)) ^ _e240.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1871.z * _e1900)) ^ _e240.member_3[0]))) * f32(-(_e1816))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1871.x) & 2147483647u)) * _e1924)) ^ _e240.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1871.y) & 2147483647u)) * _e1931)) ^ _e240.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1871.z) & 2147483647u)) * _e1938)) ^ _e240.member_3[0]))))) ^ _e240.member_3[0])) + _e2015) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e2029 = phi_2709_;
                                                        phi_2710_ = _e2029;
                                                    }
                                                    let _e2031 = phi_2710_;
                                                    if _e2031 {
                                                        if (_e1803.member < _e1092.member.member) {
                                                            phi_2730_ = true;
                                                        } else {
                                                            if (_e1803.member == _e1092.member.member) {
                                                                phi_2729_ = (_e1803.member_3 < _e1092.member.member_3);
                                                            } else {
                                                                phi_2729_ = false;
                                                            }
                                                            let _e2041 = phi_2729_;
                                                            phi_2730_ = _e2041;
                                                        }
                                                        let _e2043 = phi_2730_;
                                                        if _e2043 {
                                                            phi_2736_ = type_42(_e1803, _e1803.member);
                                                        } else {
                                                            phi_2736_ = _e1092;
                                                        }
                                                        let _e2046 = phi_2736_;
                                                        phi_2737_ = _e2046;
                                                    } else {
                                                        phi_2737_ = _e1092;
                                                    }
                                                    let _e2048 = phi_2737_;
                                                    phi_2738_ = _e2048;
                                                } else {
                                                    phi_2738_ = _e1092;
                                                }
                                                let _e2050 = phi_2738_;
                                                phi_1087_ = _e2050;
                                            } else {
                                                phi_1087_ = type_42();
                                            }
                                            let _e2052 = phi_1087_;
                                            continue;
                                            continuing {
                                                phi_1086_ = _e2052;
                                                phi_1089_ = _e1107;
                                                phi_4317_ = _e582;
                                                break if !(_e1113);
                                            }
                                        }
                                        let _e2055 = phi_4317_;
                                        phi_4502_ = _e2055;
                                        if _e2055 {
                                            break;
                                        }
                                        phi_4506_ = _e2055;
                                        let _e2304 = local_11;
                                        phi_3978_ = _e2304;
                                        phi_3979_ = _e623;
                                        phi_3980_ = false;
                                        phi_3981_ = _e627;
                                    } else {
                                        if (_e623.member_1 >= _e100) {
                                            phi_3534_ = type_58(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_57(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_57(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e623.member_1 < _e100) {
                                            } else {
                                                phi_4502_ = true;
                                                break;
                                            }
                                            let _e640 = ((1u + _e362) % 4u);
                                            if (_e640 < 4u) {
                                            } else {
                                                phi_4502_ = true;
                                                break;
                                            }
                                            let _e645 = global_4.member[_e623.member_1][_e640];
                                            let _e647 = (_e645 >> bitcast<u32>(11u));
                                            let _e649 = ((1u + _e361) % 4u);
                                            if (_e649 < 4u) {
                                            } else {
                                                phi_4502_ = true;
                                                break;
                                            }
                                            let _e654 = global_4.member[_e623.member_1][_e649];
                                            let _e656 = (_e654 >> bitcast<u32>(11u));
                                            let _e658 = ((1u + _e363) % 4u);
                                            if (_e658 < 4u) {
                                            } else {
                                                phi_4502_ = true;
                                                break;
                                            }
                                            let _e663 = global_4.member[_e623.member_1][_e658];
                                            let _e665 = (_e663 >> bitcast<u32>(11u));
                                            let _e688 = (bitcast<f32>((bitcast<u32>((_e623.member.member_1.x - _e623.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e689 = (bitcast<f32>((bitcast<u32>((_e623.member.member_1.y - _e623.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e690 = (bitcast<f32>((bitcast<u32>((_e623.member.member_1.z - _e623.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e692 = select(_e159, _e688, (_e688 > _e159));
                                            let _e694 = select(_e159, _e689, (_e689 > _e159));
                                            let _e696 = select(_e159, _e690, (_e690 > _e159));
                                            let _e721 = bitcast<u32>((f32(bitcast<i32>((_e645 & 1023u))) * _e692));
                                            let _e726 = (bitcast<i32>((_e645 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e729 = bitcast<f32>((_e721 & bitcast<u32>(_e726)));
                                            let _e730 = bitcast<u32>((f32(bitcast<i32>((_e654 & 1023u))) * _e694));
                                            let _e735 = (bitcast<i32>((_e654 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e738 = bitcast<f32>((_e730 & bitcast<u32>(_e735)));
                                            let _e739 = bitcast<u32>((f32(bitcast<i32>((_e663 & 1023u))) * _e696));
                                            let _e744 = (bitcast<i32>((_e663 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e747 = bitcast<f32>((_e739 & bitcast<u32>(_e744)));
                                            let _e751 = bitcast<f32>((_e721 & bitcast<u32>(~(_e726))));
                                            let _e755 = bitcast<f32>((_e730 & bitcast<u32>(~(_e735))));
                                            let _e759 = bitcast<f32>((_e739 & bitcast<u32>(~(_e744))));
                                            let _e760 = bitcast<u32>((f32(bitcast<i32>((_e647 & 1023u))) * _e692));
                                            let _e765 = (bitcast<i32>((_e647 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e768 = bitcast<f32>((_e760 & bitcast<u32>(_e765)));
                                            let _e769 = bitcast<u32>((f32(bitcast<i32>((_e656 & 1023u))) * _e694));
                                            let _e774 = (bitcast<i32>((_e656 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e777 = bitcast<f32>((_e769 & bitcast<u32>(_e774)));
                                            let _e778 = bitcast<u32>((f32(bitcast<i32>((_e665 & 1023u))) * _e696));
                                            let _e783 = (bitcast<i32>((_e665 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e786 = bitcast<f32>((_e778 & bitcast<u32>(_e783)));
                                            let _e790 = bitcast<f32>((_e760 & bitcast<u32>(~(_e765))));
                                            let _e794 = bitcast<f32>((_e769 & bitcast<u32>(~(_e774))));
                                            let _e798 = bitcast<f32>((_e778 & bitcast<u32>(~(_e783))));
                                            let _e799 = (_e623.member.member.x + _e729);
                                            let _e800 = (_e623.member.member.y + _e738);
                                            let _e801 = (_e623.member.member.z + _e747);
                                            let _e804 = (_e623.member.member_1.x - _e768);
                                            let _e805 = (_e623.member.member_1.y - _e777);
                                            let _e806 = (_e623.member.member_1.z - _e786);
                                            let _e825 = (_e804 - _e799);
                                            let _e826 = (_e805 - _e800);
                                            let _e827 = (_e806 - _e801);
                                            let _e829 = select(_e826, _e825, (_e825 > _e826));
                                            let _e831 = select(_e827, _e829, (_e829 > _e827));
                                            if (_e831 < (1024f * _e159)) {
                                                phi_3235_ = 0u;
                                            } else {
                                                phi_3235_ = select(2u, 1u, (_e831 < (2097152f * _e159)));
                                            }
                                            let _e838 = phi_3235_;
                                            switch bitcast<i32>(_e838) {
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
                                            let _e841 = phi_3241_;
                                            let _e847 = global_4.member[_e623.member_1][0u];
                                            let _e851 = global_4.member[_e623.member_1][1u];
                                            let _e855 = global_4.member[_e623.member_1][2u];
                                            let _e859 = global_4.member[_e623.member_1][3u];
                                            let _e871 = (((_e851 >> bitcast<u32>(22i)) | ((_e855 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e859 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e872 = (_e847 & 268435455u);
                                            let _e873 = (_e871 & 268435455u);
                                            let _e876 = ((_e847 >> bitcast<u32>(28u)) & 7u);
                                            let _e884 = ((_e847 >> bitcast<u32>(31i)) | (((_e871 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e885 = (_e876 != 0u);
                                            if (_e876 == 0u) {
                                                phi_3496_ = _e872;
                                            } else {
                                                if (_e876 == 7u) {
                                                    phi_3495_ = 2147483648u;
                                                } else {
                                                    phi_3495_ = ((2147483648u | (_e876 << bitcast<u32>(28u))) | (_e873 & 268435455u));
                                                }
                                                let _e894 = phi_3495_;
                                                phi_3496_ = _e894;
                                            }
                                            let _e896 = phi_3496_;
                                            if _e885 {
                                                let _e897 = (_e876 != 7u);
                                                if _e897 {
                                                    phi_3506_ = (_e873 + (_e876 * ((3u * _e841) + 1u)));
                                                } else {
                                                    phi_3506_ = u32();
                                                }
                                                let _e901 = phi_3506_;
                                                phi_3508_ = _e901;
                                                phi_3509_ = select(true, false, _e897);
                                            } else {
                                                phi_3508_ = u32();
                                                phi_3509_ = true;
                                            }
                                            let _e904 = phi_3508_;
                                            let _e906 = phi_3509_;
                                            if (_e884 == 0u) {
                                                phi_3530_ = (_e872 + select(0u, 1u, !(_e885)));
                                            } else {
                                                if (_e884 == 7u) {
                                                    phi_3529_ = 2147483648u;
                                                } else {
                                                    phi_3529_ = ((2147483648u | (_e884 << bitcast<u32>(28u))) | (select(_e904, _e873, _e906) & 268435455u));
                                                }
                                                let _e919 = phi_3529_;
                                                phi_3530_ = _e919;
                                            }
                                            let _e921 = phi_3530_;
                                            phi_3534_ = type_58(array<vec4<f32>, 3>(vec4<f32>(_e799, (_e623.member.member.x + _e751), _e804, (_e623.member.member_1.x - _e790)), vec4<f32>(_e800, (_e623.member.member.y + _e755), _e805, (_e623.member.member_1.y - _e794)), vec4<f32>(_e801, (_e623.member.member.z + _e759), _e806, (_e623.member.member_1.z - _e798))), type_57(type_37((_e623.member.member + vec4<f32>(_e729, _e738, _e747, 0f)), (_e623.member.member_1 - vec4<f32>(_e768, _e777, _e786, 0f))), _e896), type_57(type_37((_e623.member.member + vec4<f32>(_e751, _e755, _e759, 0f)), (_e623.member.member_1 - vec4<f32>(_e790, _e794, _e798, 0f))), _e921));
                                        }
                                        let _e926 = phi_3534_;
                                        let _e938 = ((_e926.member[0].x - _e417) * _e422);
                                        let _e939 = ((_e926.member[0].y - _e417) * _e422);
                                        let _e940 = ((_e926.member[0].z - _e418) * _e422);
                                        let _e941 = ((_e926.member[0].w - _e418) * _e422);
                                        let _e951 = ((_e926.member[1].x - _e453) * _e458);
                                        let _e952 = ((_e926.member[1].y - _e453) * _e458);
                                        let _e953 = ((_e926.member[1].z - _e454) * _e458);
                                        let _e954 = ((_e926.member[1].w - _e454) * _e458);
                                        let _e964 = ((_e926.member[2].x - _e489) * _e494);
                                        let _e965 = ((_e926.member[2].y - _e489) * _e494);
                                        let _e966 = ((_e926.member[2].z - _e490) * _e494);
                                        let _e967 = ((_e926.member[2].w - _e490) * _e494);
                                        let _e969 = select(_e966, _e964, (_e964 < _e966));
                                        let _e971 = select(_e967, _e965, (_e965 < _e967));
                                        let _e973 = select(_e966, _e964, (_e964 > _e966));
                                        let _e975 = select(_e967, _e965, (_e965 > _e967));
                                        let _e977 = select(_e940, _e938, (_e938 < _e940));
                                        let _e979 = select(_e941, _e939, (_e939 < _e941));
                                        let _e981 = select(_e953, _e951, (_e951 < _e953));
                                        let _e983 = select(_e954, _e952, (_e952 < _e954));
                                        let _e985 = select(_e981, _e977, (_e977 > _e981));
                                        let _e987 = select(_e983, _e979, (_e979 > _e983));
                                        let _e989 = select(_e969, _e985, (_e985 > _e969));
                                        let _e991 = select(_e971, _e987, (_e987 > _e971));
                                        let _e993 = select(_e940, _e938, (_e938 > _e940));
                                        let _e995 = select(_e941, _e939, (_e939 > _e941));
                                        let _e997 = select(_e953, _e951, (_e951 > _e953));
                                        let _e999 = select(_e954, _e952, (_e952 > _e954));
                                        let _e1001 = select(_e997, _e993, (_e993 < _e997));
                                        let _e1003 = select(_e999, _e995, (_e995 < _e999));
                                        let _e1008 = -(_e969);
                                        let _e1009 = -(_e971);
                                        let _e1016 = (select(_e973, _e1001, (_e1001 < _e973)) + (select(_e1008, _e973, (_e973 > _e1008)) * 0.0000019073523f));
                                        let _e1017 = (select(_e975, _e1003, (_e1003 < _e975)) + (select(_e1009, _e975, (_e975 > _e1009)) * 0.0000019073523f));
                                        let _e1019 = select(_e540, _e989, (_e989 > _e540));
                                        let _e1021 = select(_e540, _e991, (_e991 > _e540));
                                        let _e1026 = (_e1019 <= select(_e584.member_1, _e1016, (_e1016 < _e584.member_1)));
                                        let _e1027 = (_e1021 <= select(_e584.member_1, _e1017, (_e1017 < _e584.member_1)));
                                        let _e1028 = (_e1019 <= _e1021);
                                        if _e1026 {
                                            if _e1027 {
                                                if _e1028 {
                                                    phi_3878_ = _e926.member_2;
                                                } else {
                                                    phi_3878_ = _e926.member_1;
                                                }
                                                let _e1032 = phi_3878_;
                                                let _e1054 = (_e627 % 128u);
                                                let _e1055 = (_e1054 < 128u);
                                                if _e1055 {
                                                } else {
                                                    phi_4502_ = true;
                                                    break;
                                                }
                                                local_8[_e1054] = _e1032.member_1;
                                                if _e1055 {
                                                } else {
                                                    phi_4502_ = true;
                                                    break;
                                                }
                                                local_7[_e1054] = _e1032.member.member.x;
                                                if _e1055 {
                                                } else {
                                                    phi_4502_ = true;
                                                    break;
                                                }
                                                local_6[_e1054] = _e1032.member.member.y;
                                                if _e1055 {
                                                } else {
                                                    phi_4502_ = true;
                                                    break;
                                                }
                                                local_5[_e1054] = _e1032.member.member.z;
                                                if _e1055 {
                                                } else {
                                                    phi_4502_ = true;
                                                    break;
                                                }
                                                local_4[_e1054] = _e1032.member.member_1.x;
                                                if _e1055 {
                                                } else {
                                                    phi_4502_ = true;
                                                    break;
                                                }
                                                local_3[_e1054] = _e1032.member.member_1.y;
                                                if _e1055 {
                                                } else {
                                                    phi_4502_ = true;
                                                    break;
                                                }
                                                local_2[_e1054] = _e1032.member.member_1.z;
                                                if _e1055 {
                                                } else {
                                                    phi_4502_ = true;
                                                    break;
                                                }
                                                local_9[_e1054] = select(_e1021, _e1019, (_e1019 > _e1021));
                                                if _e1028 {
                                                    phi_3955_ = _e926.member_1;
                                                } else {
                                                    phi_3955_ = _e926.member_2;
                                                }
                                                let _e1068 = phi_3955_;
                                                phi_3956_ = _e1068;
                                                phi_3957_ = (_e627 + 1u);
                                            } else {
                                                phi_3956_ = type_57();
                                                phi_3957_ = u32();
                                            }
                                            let _e1070 = phi_3956_;
                                            let _e1072 = phi_3957_;
                                            phi_3959_ = _e1070;
                                            phi_3960_ = _e1072;
                                            phi_3961_ = select(true, false, _e1027);
                                        } else {
                                            phi_3959_ = type_57();
                                            phi_3960_ = u32();
                                            phi_3961_ = true;
                                        }
                                        let _e1075 = phi_3959_;
                                        let _e1077 = phi_3960_;
                                        let _e1079 = phi_3961_;
                                        if _e1079 {
                                            if _e1026 {
                                                phi_3970_ = _e926.member_1;
                                            } else {
                                                phi_3970_ = _e926.member_2;
                                            }
                                            let _e1083 = phi_3970_;
                                            phi_3975_ = _e1083;
                                            phi_3976_ = select(_e1027, true, _e1026);
                                        } else {
                                            phi_3975_ = _e1075;
                                            phi_3976_ = _e625;
                                        }
                                        let _e1086 = phi_3975_;
                                        let _e1088 = phi_3976_;
                                        phi_4506_ = _e582;
                                        phi_3978_ = _e584;
                                        phi_3979_ = _e1086;
                                        phi_3980_ = _e1088;
                                        phi_3981_ = select(_e1077, _e627, _e1079);
                                    }
                                    let _e2057 = phi_4506_;
                                    let _e2059 = phi_3978_;
                                    let _e2061 = phi_3979_;
                                    let _e2063 = phi_3980_;
                                    let _e2065 = phi_3981_;
                                    phi_4505_ = _e2057;
                                    phi_3982_ = _e2059;
                                    phi_3983_ = _e2061;
                                    phi_3984_ = (_e588 - 1u);
                                    phi_3985_ = _e2063;
                                    phi_3986_ = _e2065;
                                } else {
                                    phi_4505_ = _e582;
                                    phi_3982_ = _e584;
                                    phi_3983_ = _e623;
                                    phi_3984_ = _e588;
                                    phi_3985_ = _e625;
                                    phi_3986_ = _e627;
                                }
                                let _e2067 = phi_4505_;
                                let _e2069 = phi_3982_;
                                let _e2071 = phi_3983_;
                                let _e2073 = phi_3984_;
                                let _e2075 = phi_3985_;
                                let _e2077 = phi_3986_;
                                phi_4504_ = _e2067;
                                phi_3987_ = _e2069;
                                phi_3988_ = _e2071;
                                phi_3989_ = _e2073;
                                phi_3990_ = _e2075;
                                phi_3991_ = _e2077;
                            } else {
                                phi_4504_ = _e582;
                                phi_3987_ = type_42();
                                phi_3988_ = type_57();
                                phi_3989_ = u32();
                                phi_3990_ = bool();
                                phi_3991_ = u32();
                            }
                            let _e2079 = phi_4504_;
                            let _e2081 = phi_3987_;
                            let _e2083 = phi_3988_;
                            let _e2085 = phi_3989_;
                            let _e2087 = phi_3990_;
                            let _e2089 = phi_3991_;
                            phi_4503_ = _e2079;
                            phi_960_ = _e2081;
                            phi_963_ = _e2083;
                            phi_965_ = _e2085;
                            phi_967_ = _e2087;
                            phi_969_ = _e2089;
                            phi_3992_ = _e596;
                        } else {
                            phi_4503_ = _e582;
                            phi_960_ = type_42();
                            phi_963_ = type_57();
                            phi_965_ = u32();
                            phi_967_ = bool();
                            phi_969_ = u32();
                            phi_3992_ = false;
                        }
                        let _e2091 = phi_4503_;
                        let _e2093 = phi_960_;
                        let _e2095 = phi_963_;
                        let _e2097 = phi_965_;
                        let _e2099 = phi_967_;
                        let _e2101 = phi_969_;
                        let _e2103 = phi_3992_;
                        continue;
                        continuing {
                            phi_4323_ = _e2091;
                            phi_959_ = _e2093;
                            phi_962_ = _e2095;
                            phi_964_ = _e2097;
                            phi_966_ = _e2099;
                            phi_968_ = _e2101;
                            phi_4502_ = _e2091;
                            break if !(_e2103);
                        }
                    }
                    let _e2106 = phi_4502_;
                    if _e2106 {
                        break;
                    }
                    let _e2108 = local_10;
                    if (_e2108.member.member_3 != 4294967295u) {
                        let _e2113 = (_e364 / 3i);
                        let _e2120 = bitcast<f32>((bitcast<u32>((_e2113 + 127i)) << bitcast<u32>(23i)));
                        let _e2128 = (((_e2108.member.member * _e2120) * _e2120) * bitcast<f32>((bitcast<u32>(((_e364 - (2i * _e2113)) + 127i)) << bitcast<u32>(23i))));
                        let _e2130 = select(340282350000000000000000000000000000000f, _e2128, (_e2128 < 340282350000000000000000000000000000000f));
                        phi_4044_ = type_25(select(-340282350000000000000000000000000000000f, _e2130, (_e2130 > -340282350000000000000000000000000000000f)), _e2108.member.member_1, _e2108.member.member_2, _e2108.member.member_3);
                    } else {
                        phi_4044_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2137 = phi_4044_;
                    if _e241 {
                    } else {
                        break;
                    }
                    global_8.member[_e147] = _e2137;
                    if _e162 {
                    } else {
                        break;
                    }
                    let _e2141 = select(0u, 1u, (_e308 <= _e318));
                    if (_e2141 > 0u) {
                        let _e2143 = (1u < _e115);
                        if _e2143 {
                            if (0u < _e115) {
                            } else {
                                break;
                            }
                            let _e2147 = atomicAdd((&global_9.member[0u]), _e2141);
                            if ((_e2147 + _e2141) < _e2147) {
                                if _e2143 {
                                } else {
                                    break;
                                }
                                let _e2152 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e2155 = select(0u, 1u, (_e2137.member_3 != 4294967295u));
                    if (_e2155 > 0u) {
                        let _e2157 = (3u < _e115);
                        if _e2157 {
                            if (2u < _e115) {
                            } else {
                                break;
                            }
                            let _e2161 = atomicAdd((&global_9.member[2u]), _e2155);
                            if ((_e2161 + _e2155) < _e2161) {
                                if _e2157 {
                                } else {
                                    break;
                                }
                                let _e2166 = atomicAdd((&global_9.member[3u]), 1u);
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
fn trace_paths_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
