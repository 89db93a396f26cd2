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

struct type_32 {
    member: array<type_23>,
}

struct type_36 {
    member: array<array<type_22, 8>>,
}

struct type_42 {
    member: array<vec4<u32>, 2>,
}

struct type_44 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_46 {
    member: array<type_44>,
}

struct type_49 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_51 {
    member: type_49,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(3) 
var<storage> global_2: type_15;
@group(0) @binding(1) 
var<uniform> global_3: type_42;
@group(0) @binding(4) 
var<storage> global_4: type_32;
@group(0) @binding(2) 
var<storage> global_5: type_46;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_36;

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
    var phi_430_: i32;
    var phi_431_: i32;
    var phi_441_: bool;
    var phi_451_: u32;
    var phi_452_: u32;
    var phi_454_: bool;
    var phi_459_: u32;
    var phi_472_: i32;
    var phi_492_: i32;
    var phi_510_: f32;
    var phi_516_: f32;
    var phi_556_: f32;
    var phi_562_: f32;
    var phi_614_: f32;
    var phi_626_: f32;
    var phi_635_: f32;
    var phi_641_: f32;
    var phi_681_: f32;
    var phi_687_: f32;
    var phi_739_: f32;
    var phi_751_: f32;
    var phi_760_: f32;
    var phi_766_: f32;
    var phi_806_: f32;
    var phi_812_: f32;
    var phi_864_: f32;
    var phi_876_: f32;
    var phi_931_: i32;
    var phi_953_: u32;
    var phi_954_: u32;
    var phi_991_: i32;
    var phi_1013_: u32;
    var phi_1014_: u32;
    var phi_1022_: f32;
    var phi_1023_: f32;
    var phi_3790_: bool;
    var phi_3771_: f32;
    var phi_1159_: u32;
    var phi_1162_: bool;
    var phi_1164_: u32;
    var phi_1166_: type_51;
    var phi_1177_: bool;
    var phi_1264_: bool;
    var phi_1265_: u32;
    var phi_1266_: type_51;
    var phi_3787_: bool;
    var phi_3776_: f32;
    var phi_1284_: type_4;
    var phi_1285_: type_4;
    var phi_1308_: type_4;
    var phi_1329_: u32;
    var phi_1421_: array<array<f32, 3>, 3>;
    var phi_1574_: bool;
    var phi_1603_: bool;
    var phi_2022_: f32;
    var phi_2023_: f32;
    var phi_2024_: f32;
    var phi_2025_: f32;
    var phi_2026_: vec3<f32>;
    var phi_2027_: vec3<f32>;
    var phi_2028_: vec3<f32>;
    var phi_2029_: vec3<f32>;
    var phi_2066_: bool;
    var phi_2075_: vec3<f32>;
    var phi_2240_: f32;
    var phi_2242_: f32;
    var phi_2243_: bool;
    var phi_2263_: f32;
    var phi_2264_: f32;
    var phi_2287_: type_22;
    var phi_2289_: type_22;
    var phi_2290_: bool;
    var phi_2294_: type_22;
    var phi_2295_: type_22;
    var phi_2296_: type_22;
    var phi_2297_: bool;
    var phi_2301_: type_22;
    var phi_2302_: bool;
    var phi_2303_: type_22;
    var phi_2304_: bool;
    var phi_2305_: bool;
    var phi_2306_: type_22;
    var phi_2307_: bool;
    var phi_2308_: bool;
    var phi_2316_: type_22;
    var phi_2317_: bool;
    var phi_2321_: type_22;
    var phi_2333_: type_4;
    var phi_2336_: type_22;
    var phi_2334_: type_4;
    var phi_2359_: type_4;
    var phi_2391_: bool;
    var phi_2392_: bool;
    var phi_2413_: type_22;
    var phi_2337_: type_22;
    var phi_3778_: bool;
    var phi_4060_: f32;
    var phi_4059_: f32;
    var phi_3941_: bool;
    var phi_4058_: f32;
    var phi_3940_: bool;
    var phi_4057_: f32;
    var phi_3939_: bool;
    var phi_3969_: f32;
    var phi_3938_: bool;
    var phi_4120_: bool;
    var phi_3968_: f32;
    var phi_2445_: type_44;
    var phi_3332_: type_51;
    var phi_3408_: type_51;
    var phi_3409_: u32;
    var phi_3410_: type_51;
    var phi_3412_: u32;
    var phi_3413_: type_51;
    var phi_3414_: bool;
    var phi_3421_: type_51;
    var phi_3426_: bool;
    var phi_3428_: type_51;
    var phi_3432_: bool;
    var phi_3433_: u32;
    var phi_3434_: type_51;
    var phi_3444_: type_51;
    var phi_4147_: f32;
    var phi_4064_: bool;
    var phi_3445_: u32;
    var phi_3446_: bool;
    var phi_3447_: u32;
    var phi_3448_: type_51;
    var phi_4146_: f32;
    var phi_4063_: bool;
    var phi_3449_: u32;
    var phi_3450_: bool;
    var phi_3451_: u32;
    var phi_3452_: type_51;
    var phi_4145_: f32;
    var phi_4062_: bool;
    var phi_1160_: u32;
    var phi_1163_: bool;
    var phi_1165_: u32;
    var phi_1167_: type_51;
    var phi_3453_: bool;
    var phi_4061_: bool;
    var phi_3460_: type_4;
    var phi_3461_: type_4;
    var phi_3484_: type_4;
    var phi_3536_: f32;
    var phi_3538_: f32;
    var phi_3539_: bool;
    var phi_3540_: f32;
    var phi_3541_: bool;
    var phi_3680_: u32;
    var phi_3698_: bool;
    var phi_3701_: bool;
    var phi_3714_: f32;
    var phi_3715_: f32;
    var phi_3720_: f32;
    var phi_3721_: f32;
    var phi_3722_: bool;
    var phi_3730_: f32;
    var phi_3556_: f32;
    var phi_3557_: f32;
    var phi_3569_: f32;
    var phi_3574_: type_22;
    var phi_4127_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e87 = global;
            let _e90 = arrayLength((&global_5.member));
            let _e92 = arrayLength((&global_2.member));
            let _e100 = global_3.member[0u][0u];
            let _e104 = global_3.member[0u][1u];
            let _e108 = global_3.member[0u][2u];
            let _e112 = global_3.member[1u][0u];
            let _e116 = global_3.member[1u][1u];
            let _e120 = global_3.member[1u][2u];
            let _e124 = global_3.member[1u][3u];
            let _e127 = global_1.member[0u];
            let _e128 = bitcast<i32>(_e127);
            let _e138 = (_e87.x + (_e87.y * 2097152u));
            let _e139 = (_e138 < arrayLength((&global_4.member)));
            if _e139 {
                let _e140 = (_e138 < arrayLength((&global_6.member)));
                if _e140 {
                    if _e139 {
                    } else {
                        break;
                    }
                    let _e148 = global_4.member[_e138].member_2[0u];
                    let _e150 = (bitcast<u32>(_e148) & 2147483647u);
                    let _e155 = global_4.member[_e138].member_2[1u];
                    let _e157 = (bitcast<u32>(_e155) & 2147483647u);
                    let _e162 = global_4.member[_e138].member_2[2u];
                    let _e164 = (bitcast<u32>(_e162) & 2147483647u);
                    let _e169 = global_4.member[_e138].member[0u];
                    let _e171 = (bitcast<u32>(_e169) & 2147483647u);
                    let _e176 = global_4.member[_e138].member[1u];
                    let _e178 = (bitcast<u32>(_e176) & 2147483647u);
                    let _e183 = global_4.member[_e138].member[2u];
                    let _e185 = (bitcast<u32>(_e183) & 2147483647u);
                    let _e187 = select(_e157, _e150, (_e157 < _e150));
                    let _e189 = select(_e164, _e187, (_e164 < _e187));
                    let _e191 = select(_e171, _e189, (_e171 < _e189));
                    let _e193 = select(_e178, _e191, (_e178 < _e191));
                    let _e195 = select(_e185, _e193, (_e185 < _e193));
                    let _e199 = global_4.member[_e138].member_1;
                    let _e200 = bitcast<u32>(_e199);
                    let _e201 = (_e200 & 2147483647u);
                    let _e208 = global_4.member[_e138].member_3;
                    let _e209 = bitcast<u32>(_e208);
                    let _e210 = (_e209 & 2147483647u);
                    let _e214 = (((select(_e201, _e195, (_e201 < _e195)) < 2139095040u) && (_e210 <= 2139095040u)) && (_e189 > 0u));
                    if _e214 {
                        let _e217 = (bitcast<u32>(bitcast<f32>(_e189)) & 2147483647u);
                        if (_e217 >= 8388608u) {
                            phi_430_ = (bitcast<i32>((_e217 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_430_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e217)), 32u, (_e217 == 0u))));
                        }
                        let _e231 = phi_430_;
                        phi_431_ = _e231;
                    } else {
                        phi_431_ = 0i;
                    }
                    let _e233 = phi_431_;
                    let _e234 = (_e150 == _e189);
                    if _e234 {
                        phi_441_ = true;
                    } else {
                        phi_441_ = (_e157 == _e189);
                    }
                    let _e237 = phi_441_;
                    let _e238 = select(1u, 0u, _e234);
                    if _e237 {
                        let _e239 = (_e238 + 1u);
                        phi_451_ = _e239;
                        phi_452_ = _e239;
                        phi_454_ = select(true, false, (_e239 == 2u));
                    } else {
                        phi_451_ = u32();
                        phi_452_ = 0u;
                        phi_454_ = true;
                    }
                    let _e243 = phi_451_;
                    let _e245 = phi_452_;
                    let _e247 = phi_454_;
                    if _e247 {
                        phi_459_ = (_e245 + 1u);
                    } else {
                        phi_459_ = 0u;
                    }
                    let _e251 = phi_459_;
                    let _e252 = select(_e243, _e245, _e247);
                    let _e253 = select(_e238, select(2u, _e238, _e237), _e247);
                    if (_e128 < -126i) {
                        phi_472_ = -126i;
                    } else {
                        phi_472_ = select(_e128, 127i, (_e128 > 127i));
                    }
                    let _e258 = phi_472_;
                    let _e263 = bitcast<f32>((bitcast<u32>((_e258 + 127i)) << bitcast<u32>(23i)));
                    let _e269 = bitcast<f32>((bitcast<u32>(((_e128 - _e258) + 127i)) << bitcast<u32>(23i)));
                    let _e270 = -(_e233);
                    if (_e270 < -126i) {
                        phi_492_ = -126i;
                    } else {
                        phi_492_ = select(_e270, 127i, (_e270 > 127i));
                    }
                    let _e275 = phi_492_;
                    let _e280 = bitcast<f32>((bitcast<u32>((_e275 + 127i)) << bitcast<u32>(23i)));
                    let _e286 = bitcast<f32>((bitcast<u32>(((_e270 - _e275) + 127i)) << bitcast<u32>(23i)));
                    let _e290 = global_4.member[_e138].member;
                    let _e291 = (_e252 == 0u);
                    if _e291 {
                        phi_510_ = _e290[0];
                    } else {
                        phi_510_ = _e290[1];
                    }
                    let _e295 = phi_510_;
                    let _e296 = (_e252 == 2u);
                    if _e296 {
                        phi_516_ = _e290[2];
                    } else {
                        phi_516_ = _e295;
                    }
                    let _e299 = phi_516_;
                    let _e300 = bitcast<u32>(_e299);
                    let _e302 = ((_e300 & 2139095040u) != 0u);
                    let _e316 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e300 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e300 & 2147483648u))), _e299, _e302) * _e263) * select(0.00000011920929f, 1f, _e302)) * _e269);
                    let _e317 = global_4.member[_e138].member_2;
                    if _e291 {
                        phi_556_ = _e317[0];
                    } else {
                        phi_556_ = _e317[1];
                    }
                    let _e321 = phi_556_;
                    if _e296 {
                        phi_562_ = _e317[2];
                    } else {
                        phi_562_ = _e321;
                    }
                    let _e324 = phi_562_;
                    let _e325 = bitcast<u32>(_e324);
                    let _e327 = ((_e325 & 2139095040u) != 0u);
                    let _e341 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e325 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e325 & 2147483648u))), _e324, _e327) * _e280) * select(0.00000011920929f, 1f, _e327)) * _e286);
                    let _e345 = (bitcast<f32>((bitcast<u32>(_e341) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e345 {
                        let _e349 = (bitcast<f32>((bitcast<u32>(_e316) & 2147483647u)) * 0.00000011920929f);
                        phi_614_ = select(0.00000000000011368684f, _e349, (_e349 > 0.00000000000011368684f));
                    } else {
                        phi_614_ = 0f;
                    }
                    let _e353 = phi_614_;
                    let _e354 = (_e316 + _e353);
                    let _e355 = (_e316 - _e353);
                    let _e356 = select(_e341, 0f, _e345);
                    if _e345 {
                        phi_626_ = 38685626000000000000000000f;
                    } else {
                        phi_626_ = (1f / _e341);
                    }
                    let _e359 = phi_626_;
                    let _e360 = (_e251 == 0u);
                    if _e360 {
                        phi_635_ = _e290[0];
                    } else {
                        phi_635_ = _e290[1];
                    }
                    let _e364 = phi_635_;
                    let _e365 = (_e251 == 2u);
                    if _e365 {
                        phi_641_ = _e290[2];
                    } else {
                        phi_641_ = _e364;
                    }
                    let _e368 = phi_641_;
                    let _e369 = bitcast<u32>(_e368);
                    let _e371 = ((_e369 & 2139095040u) != 0u);
                    let _e385 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e369 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e369 & 2147483648u))), _e368, _e371) * _e263) * select(0.00000011920929f, 1f, _e371)) * _e269);
                    if _e360 {
                        phi_681_ = _e317[0];
                    } else {
                        phi_681_ = _e317[1];
                    }
                    let _e389 = phi_681_;
                    if _e365 {
                        phi_687_ = _e317[2];
                    } else {
                        phi_687_ = _e389;
                    }
                    let _e392 = phi_687_;
                    let _e393 = bitcast<u32>(_e392);
                    let _e395 = ((_e393 & 2139095040u) != 0u);
                    let _e409 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e393 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e393 & 2147483648u))), _e392, _e395) * _e280) * select(0.00000011920929f, 1f, _e395)) * _e286);
                    let _e413 = (bitcast<f32>((bitcast<u32>(_e409) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e413 {
                        let _e417 = (bitcast<f32>((bitcast<u32>(_e385) & 2147483647u)) * 0.00000011920929f);
                        phi_739_ = select(0.00000000000011368684f, _e417, (_e417 > 0.00000000000011368684f));
                    } else {
                        phi_739_ = 0f;
                    }
                    let _e421 = phi_739_;
                    let _e422 = (_e385 + _e421);
                    let _e423 = (_e385 - _e421);
                    let _e424 = select(_e409, 0f, _e413);
                    if _e413 {
                        phi_751_ = 38685626000000000000000000f;
                    } else {
                        phi_751_ = (1f / _e409);
                    }
                    let _e427 = phi_751_;
                    let _e428 = (_e253 == 0u);
                    if _e428 {
                        phi_760_ = _e290[0];
                    } else {
                        phi_760_ = _e290[1];
                    }
                    let _e432 = phi_760_;
                    let _e433 = (_e253 == 2u);
                    if _e433 {
                        phi_766_ = _e290[2];
                    } else {
                        phi_766_ = _e432;
                    }
                    let _e436 = phi_766_;
                    let _e437 = bitcast<u32>(_e436);
                    let _e439 = ((_e437 & 2139095040u) != 0u);
                    let _e453 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e437 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e437 & 2147483648u))), _e436, _e439) * _e263) * select(0.00000011920929f, 1f, _e439)) * _e269);
                    if _e428 {
                        phi_806_ = _e317[0];
                    } else {
                        phi_806_ = _e317[1];
                    }
                    let _e457 = phi_806_;
                    if _e433 {
                        phi_812_ = _e317[2];
                    } else {
                        phi_812_ = _e457;
                    }
                    let _e460 = phi_812_;
                    let _e461 = bitcast<u32>(_e460);
                    let _e463 = ((_e461 & 2139095040u) != 0u);
                    let _e477 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e461 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e461 & 2147483648u))), _e460, _e463) * _e280) * select(0.00000011920929f, 1f, _e463)) * _e286);
                    let _e481 = (bitcast<f32>((bitcast<u32>(_e477) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e481 {
                        let _e485 = (bitcast<f32>((bitcast<u32>(_e453) & 2147483647u)) * 0.00000011920929f);
                        phi_864_ = select(0.00000000000011368684f, _e485, (_e485 > 0.00000000000011368684f));
                    } else {
                        phi_864_ = 0f;
                    }
                    let _e489 = phi_864_;
                    let _e490 = (_e453 + _e489);
                    let _e491 = (_e453 - _e489);
                    let _e492 = select(_e477, 0f, _e481);
                    if _e481 {
                        phi_876_ = 38685626000000000000000000f;
                    } else {
                        phi_876_ = (1f / _e477);
                    }
                    let _e495 = phi_876_;
                    let _e498 = bitcast<f32>((bitcast<u32>(_e316) & 2147483647u));
                    let _e501 = bitcast<f32>((bitcast<u32>(_e385) & 2147483647u));
                    let _e503 = select(_e501, _e498, (_e498 > _e501));
                    let _e506 = bitcast<f32>((bitcast<u32>(_e453) & 2147483647u));
                    let _e509 = (_e128 + _e233);
                    if (_e214 && (select(_e506, _e503, (_e503 > _e506)) <= 1099511600000f)) {
                        let _e519 = ((_e201 & 8388607u) | (select(0u, 1u, ((_e201 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e522 = bitcast<i32>((_e201 >> bitcast<u32>(23i)));
                        let _e526 = (_e519 == 0u);
                        let _e529 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e519)), 32u, _e526)) - 8i);
                        if (_e522 == 255i) {
                            phi_931_ = 255i;
                        } else {
                            phi_931_ = (((_e522 + select(0i, 1i, (_e522 == 0i))) - _e529) + _e509);
                        }
                        let _e537 = phi_931_;
                        let _e547 = (_e537 <= 0i);
                        if _e547 {
                            phi_954_ = u32();
                        } else {
                            if _e526 {
                                phi_953_ = u32();
                            } else {
                                phi_953_ = select(((bitcast<u32>(_e537) << bitcast<u32>(23i)) | ((_e519 << bitcast<u32>(((_e529 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e537 >= 255i));
                            }
                            let _e551 = phi_953_;
                            phi_954_ = _e551;
                        }
                        let _e553 = phi_954_;
                        let _e565 = ((_e210 & 8388607u) | (select(0u, 1u, ((_e210 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e568 = bitcast<i32>((_e210 >> bitcast<u32>(23i)));
                        let _e572 = (_e565 == 0u);
                        let _e575 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e565)), 32u, _e572)) - 8i);
                        if (_e568 == 255i) {
                            phi_991_ = 255i;
                        } else {
                            phi_991_ = (((_e568 + select(0i, 1i, (_e568 == 0i))) - _e575) + _e509);
                        }
                        let _e583 = phi_991_;
                        let _e593 = (_e583 <= 0i);
                        if _e593 {
                            phi_1014_ = u32();
                        } else {
                            if _e572 {
                                phi_1013_ = u32();
                            } else {
                                phi_1013_ = select(((bitcast<u32>(_e583) << bitcast<u32>(23i)) | ((_e565 << bitcast<u32>(((_e575 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e583 >= 255i));
                            }
                            let _e597 = phi_1013_;
                            phi_1014_ = _e597;
                        }
                        let _e599 = phi_1014_;
                        phi_1022_ = bitcast<f32>(((_e209 & 2147483648u) | select(_e599, 0u, select(_e572, true, _e593))));
                        phi_1023_ = bitcast<f32>(((_e200 & 2147483648u) | select(_e553, 0u, select(_e526, true, _e547))));
                    } else {
                        phi_1022_ = 0f;
                        phi_1023_ = 1f;
                    }
                    let _e605 = phi_1022_;
                    let _e607 = phi_1023_;
                    local_7 = array<type_22, 8>(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_8 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_10 = array<f32, 3>(bitcast<f32>(_e100), bitcast<f32>(_e104), bitcast<f32>(_e108));
                    let _e611 = (_e252 % 3u);
                    let _e612 = (_e611 < 3u);
                    if _e612 {
                    } else {
                        break;
                    }
                    let _e614 = local_10[_e611];
                    let _e615 = (_e251 % 3u);
                    let _e616 = (_e615 < 3u);
                    if _e616 {
                    } else {
                        break;
                    }
                    let _e618 = local_10[_e615];
                    let _e619 = (_e253 % 3u);
                    let _e620 = (_e619 < 3u);
                    if _e620 {
                    } else {
                        break;
                    }
                    let _e622 = local_10[_e619];
                    local_9 = array<f32, 3>(bitcast<f32>(_e112), bitcast<f32>(_e116), bitcast<f32>(_e120));
                    if _e612 {
                    } else {
                        break;
                    }
                    let _e626 = local_9[_e611];
                    if _e616 {
                    } else {
                        break;
                    }
                    let _e628 = local_9[_e615];
                    if _e620 {
                    } else {
                        break;
                    }
                    let _e630 = local_9[_e619];
                    phi_3790_ = false;
                    phi_3771_ = _e605;
                    phi_1159_ = ((3u * _e90) + 1u);
                    phi_1162_ = (_e607 <= _e605);
                    phi_1164_ = 0u;
                    phi_1166_ = type_51(type_49(array<f32, 3>(_e614, _e618, _e622), array<f32, 3>(_e626, _e628, _e630)), select(0u, 2147483648u, (_e90 == 0u)));
                    loop {
                        let _e638 = phi_3790_;
                        let _e640 = phi_3771_;
                        let _e642 = phi_1159_;
                        let _e644 = phi_1162_;
                        let _e646 = phi_1164_;
                        let _e648 = phi_1166_;
                        if _e644 {
                            phi_1177_ = true;
                        } else {
                            phi_1177_ = (_e646 > 0u);
                        }
                        let _e651 = phi_1177_;
                        if _e651 {
                            let _e652 = (_e642 > 0u);
                            if _e652 {
                                if _e644 {
                                    phi_1264_ = _e644;
                                    phi_1265_ = _e646;
                                    phi_1266_ = _e648;
                                } else {
                                    let _e653 = (_e646 - 1u);
                                    let _e654 = (_e653 % 128u);
                                    let _e655 = (_e654 < 128u);
                                    if _e655 {
                                    } else {
                                        phi_4061_ = true;
                                        break;
                                    }
                                    let _e657 = local_6[_e654];
                                    if _e655 {
                                    } else {
                                        phi_4061_ = true;
                                        break;
                                    }
                                    let _e659 = local_5[_e654];
                                    if _e655 {
                                    } else {
                                        phi_4061_ = true;
                                        break;
                                    }
                                    let _e661 = local_4[_e654];
                                    if _e655 {
                                    } else {
                                        phi_4061_ = true;
                                        break;
                                    }
                                    let _e663 = local_3[_e654];
                                    if _e655 {
                                    } else {
                                        phi_4061_ = true;
                                        break;
                                    }
                                    let _e666 = local_2[_e654];
                                    if _e655 {
                                    } else {
                                        phi_4061_ = true;
                                        break;
                                    }
                                    let _e668 = local_1[_e654];
                                    if _e655 {
                                    } else {
                                        phi_4061_ = true;
                                        break;
                                    }
                                    let _e670 = local[_e654];
                                    if _e655 {
                                    } else {
                                        phi_4061_ = true;
                                        break;
                                    }
                                    let _e675 = local_8[_e654];
                                    phi_1264_ = (_e675 <= _e640);
                                    phi_1265_ = _e653;
                                    phi_1266_ = type_51(type_49(array<f32, 3>(_e659, _e661, _e663), array<f32, 3>(_e666, _e668, _e670)), _e657);
                                }
                                let _e678 = phi_1264_;
                                let _e680 = phi_1265_;
                                let _e682 = phi_1266_;
                                if _e678 {
                                    let _e686 = ((_e682.member_1 & 2147483648u) != 0u);
                                    if _e686 {
                                        phi_3787_ = _e638;
                                        phi_3776_ = _e640;
                                        phi_1284_ = type_4(0u, ((_e682.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e693 = phi_3787_;
                                            let _e695 = phi_3776_;
                                            let _e697 = phi_1284_;
                                            if (_e697.member < _e697.member_1) {
                                                phi_1285_ = type_4((_e697.member + 1u), _e697.member_1);
                                                phi_1308_ = type_4(1u, _e697.member);
                                            } else {
                                                phi_1285_ = _e697;
                                                phi_1308_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e710 = phi_1285_;
                                            let _e712 = phi_1308_;
                                            let _e716 = (bitcast<i32>(_e712.member) != 0i);
                                            if _e716 {
                                                let _e717 = ((_e682.member_1 & 268435455u) + _e712.member_1);
                                                let _e718 = (_e717 < _e92);
                                                if _e718 {
                                                    if _e718 {
                                                    } else {
                                                        phi_3969_ = _e695;
                                                        phi_3938_ = true;
                                                        break;
                                                    }
                                                    let _e722 = global_2.member[_e717].member_1;
                                                    phi_1329_ = _e722;
                                                } else {
                                                    phi_1329_ = 4294967295u;
                                                }
                                                let _e724 = phi_1329_;
                                                if (_e717 >= _e92) {
                                                    phi_1421_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e718 {
                                                    } else {
                                                        phi_3969_ = _e695;
                                                        phi_3938_ = true;
                                                        break;
                                                    }
                                                    if (_e611 < 9u) {
                                                    } else {
                                                        phi_3969_ = _e695;
                                                        phi_3938_ = true;
                                                        break;
                                                    }
                                                    let _e731 = global_2.member[_e717].member[_e611];
                                                    if (_e615 < 9u) {
                                                    } else {
                                                        phi_3969_ = _e695;
                                                        phi_3938_ = true;
                                                        break;
                                                    }
                                                    let _e737 = global_2.member[_e717].member[_e615];
                                                    if (_e619 < 9u) {
                                                    } else {
                                                        phi_3969_ = _e695;
                                                        phi_3938_ = true;
                                                        break;
                                                    }
                                                    let _e743 = global_2.member[_e717].member[_e619];
                                                    let _e745 = (3u + _e611);
                                                    if (_e745 < 9u) {
                                                    } else {
                                                        phi_3969_ = _e695;
                                                        phi_3938_ = true;
                                                        break;
                                                    }
                                                    let _e751 = global_2.member[_e717].member[_e745];
                                                    let _e752 = (3u + _e615);
                                                    if (_e752 < 9u) {
                                                    } else {
                                                        phi_3969_ = _e695;
                                                        phi_3938_ = true;
                                                        break;
                                                    }
                                                    let _e758 = global_2.member[_e717].member[_e752];
                                                    let _e759 = (3u + _e619);
                                                    if (_e759 < 9u) {
                                                    } else {
                                                        phi_3969_ = _e695;
                                                        phi_3938_ = true;
                                                        break;
                                                    }
                                                    let _e765 = global_2.member[_e717].member[_e759];
                                                    let _e767 = (6u + _e611);
                                                    if (_e767 < 9u) {
                                                    } else {
                                                        phi_3969_ = _e695;
                                                        phi_3938_ = true;
                                                        break;
                                                    }
                                                    let _e773 = global_2.member[_e717].member[_e767];
                                                    let _e774 = (6u + _e615);
                                                    if (_e774 < 9u) {
                                                    } else {
                                                        phi_3969_ = _e695;
                                                        phi_3938_ = true;
                                                        break;
                                                    }
                                                    let _e780 = global_2.member[_e717].member[_e774];
                                                    let _e781 = (6u + _e619);
                                                    if (_e781 < 9u) {
                                                    } else {
                                                        phi_3969_ = _e695;
                                                        phi_3938_ = true;
                                                        break;
                                                    }
                                                    let _e787 = global_2.member[_e717].member[_e781];
                                                    phi_1421_ = array<array<f32, 3>, 3>(array<f32, 3>(_e731, _e737, _e743), array<f32, 3>(_e751, _e758, _e765), array<f32, 3>(_e773, _e780, _e787));
                                                }
                                                let _e791 = phi_1421_;
                                                let _e798 = (_e791[0][2] - _e453);
                                                let _e801 = (((_e791[0][0] - _e316) * _e492) - (_e798 * _e356));
                                                let _e804 = (((_e791[0][1] - _e385) * _e492) - (_e798 * _e424));
                                                let _e811 = (_e791[1][2] - _e453);
                                                let _e814 = (((_e791[1][0] - _e316) * _e492) - (_e811 * _e356));
                                                let _e817 = (((_e791[1][1] - _e385) * _e492) - (_e811 * _e424));
                                                let _e824 = (_e791[2][2] - _e453);
                                                let _e827 = (((_e791[2][0] - _e316) * _e492) - (_e824 * _e356));
                                                let _e830 = (((_e791[2][1] - _e385) * _e492) - (_e824 * _e424));
                                                let _e831 = (_e827 * _e817);
                                                let _e832 = (_e830 * _e814);
                                                let _e833 = (_e801 * _e830);
                                                let _e834 = (_e804 * _e827);
                                                let _e835 = (_e814 * _e804);
                                                let _e836 = (_e817 * _e801);
                                                let _e841 = (((_e831 >= _e832) && (_e833 >= _e834)) && (_e835 >= _e836));
                                                if (_e841 || (((_e831 <= _e832) && (_e833 <= _e834)) && (_e835 <= _e836))) {
                                                    let _e848 = select(-1f, 1f, _e841);
                                                    let _e850 = ((_e831 - _e832) * _e848);
                                                    let _e852 = select(0f, _e850, (_e850 > 0f));
                                                    let _e854 = ((_e833 - _e834) * _e848);
                                                    let _e856 = select(0f, _e854, (_e854 > 0f));
                                                    let _e858 = ((_e835 - _e836) * _e848);
                                                    let _e860 = select(0f, _e858, (_e858 > 0f));
                                                    let _e862 = ((_e852 + _e856) + _e860);
                                                    if (_e862 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2306_ = type_22();
                                                        phi_2307_ = true;
                                                        phi_2308_ = false;
                                                    } else {
                                                        let _e865 = select(_e814, _e801, (_e801 < _e814));
                                                        if (select(_e827, _e865, (_e865 < _e827)) > 0f) {
                                                            phi_1574_ = true;
                                                        } else {
                                                            let _e870 = select(_e814, _e801, (_e801 > _e814));
                                                            phi_1574_ = (select(_e827, _e870, (_e870 > _e827)) < 0f);
                                                        }
                                                        let _e875 = phi_1574_;
                                                        if _e875 {
                                                            phi_2303_ = type_22();
                                                            phi_2304_ = true;
                                                            phi_2305_ = false;
                                                        } else {
                                                            let _e877 = select(_e817, _e804, (_e804 < _e817));
                                                            if (select(_e830, _e877, (_e877 < _e830)) > 0f) {
                                                                phi_1603_ = true;
                                                            } else {
                                                                let _e882 = select(_e817, _e804, (_e804 > _e817));
                                                                phi_1603_ = (select(_e830, _e882, (_e882 > _e830)) < 0f);
                                                            }
                                                            let _e887 = phi_1603_;
                                                            if _e887 {
                                                                phi_2301_ = type_22();
                                                                phi_2302_ = false;
                                                            } else {
                                                                let _e889 = select(_e791[1][0], _e791[0][0], (_e791[0][0] < _e791[1][0]));
                                                                let _e893 = select(_e791[1][0], _e791[0][0], (_e791[0][0] > _e791[1][0]));
                                                                let _e897 = select(_e791[1][1], _e791[0][1], (_e791[0][1] < _e791[1][1]));
                                                                let _e901 = select(_e791[1][1], _e791[0][1], (_e791[0][1] > _e791[1][1]));
                                                                let _e905 = select(_e791[1][2], _e791[0][2], (_e791[0][2] < _e791[1][2]));
                                                                let _e909 = select(_e791[1][2], _e791[0][2], (_e791[0][2] > _e791[1][2]));
                                                                let _e914 = ((select(_e791[2][0], _e889, (_e889 < _e791[2][0])) - _e354) * _e359);
                                                                let _e915 = ((select(_e791[2][0], _e893, (_e893 > _e791[2][0])) - _e355) * _e359);
                                                                let _e918 = ((select(_e791[2][1], _e897, (_e897 < _e791[2][1])) - _e422) * _e427);
                                                                let _e919 = ((select(_e791[2][1], _e901, (_e901 > _e791[2][1])) - _e423) * _e427);
                                                                let _e922 = ((select(_e791[2][2], _e905, (_e905 < _e791[2][2])) - _e490) * _e495);
                                                                let _e923 = ((select(_e791[2][2], _e909, (_e909 > _e791[2][2])) - _e491) * _e495);
                                                                let _e925 = select(_e923, _e922, (_e922 < _e923));
                                                                let _e927 = select(_e923, _e922, (_e922 > _e923));
                                                                let _e929 = select(_e915, _e914, (_e914 < _e915));
                                                                let _e931 = select(_e919, _e918, (_e918 < _e919));
                                                                let _e933 = select(_e931, _e929, (_e929 > _e931));
                                                                let _e935 = select(_e925, _e933, (_e933 > _e925));
                                                                let _e937 = select(_e915, _e914, (_e914 > _e915));
                                                                let _e939 = select(_e919, _e918, (_e918 > _e919));
                                                                let _e941 = select(_e939, _e937, (_e937 < _e939));
                                                                let _e943 = select(_e927, _e941, (_e941 < _e927));
                                                                let _e944 = -(_e925);
                                                                let _e950 = select(_e607, _e935, (_e935 > _e607));
                                                                if (_e950 > (_e943 + (select(_e944, _e927, (_e927 > _e944)) * 0.0000019073523f))) {
                                                                    phi_2296_ = type_22();
                                                                    phi_2297_ = true;
                                                                } else {
                                                                    let _e952 = (_e950 > _e695);
                                                                    if _e952 {
                                                                        phi_2295_ = type_22();
                                                                    } else {
                                                                        let _e953 = vec3<f32>(_e791[0][0], _e791[0][1], _e791[0][2]);
                                                                        let _e954 = vec3<f32>(_e791[1][0], _e791[1][1], _e791[1][2]);
                                                                        let _e955 = vec3<f32>(_e791[2][0], _e791[2][1], _e791[2][2]);
                                                                        let _e956 = (_e791[1][0] - _e791[0][0]);
                                                                        let _e957 = (_e791[1][1] - _e791[0][1]);
                                                                        let _e958 = (_e791[1][2] - _e791[0][2]);
                                                                        let _e959 = vec3<f32>(_e956, _e957, _e958);
                                                                        let _e960 = (_e791[2][0] - _e791[1][0]);
                                                                        let _e961 = (_e791[2][1] - _e791[1][1]);
                                                                        let _e962 = (_e791[2][2] - _e791[1][2]);
                                                                        let _e963 = vec3<f32>(_e960, _e961, _e962);
                                                                        let _e964 = (_e791[0][0] - _e791[2][0]);
                                                                        let _e965 = (_e791[0][1] - _e791[2][1]);
                                                                        let _e966 = (_e791[0][2] - _e791[2][2]);
                                                                        let _e967 = vec3<f32>(_e964, _e965, _e966);
                                                                        let _e970 = bitcast<f32>((bitcast<u32>(_e956) & 2147483647u));
                                                                        let _e973 = bitcast<f32>((bitcast<u32>(_e957) & 2147483647u));
                                                                        let _e975 = select(_e973, _e970, (_e970 > _e973));
                                                                        let _e978 = bitcast<f32>((bitcast<u32>(_e958) & 2147483647u));
                                                                        let _e980 = select(_e978, _e975, (_e975 > _e978));
                                                                        let _e983 = bitcast<f32>((bitcast<u32>(_e960) & 2147483647u));
                                                                        let _e986 = bitcast<f32>((bitcast<u32>(_e961) & 2147483647u));
                                                                        let _e988 = select(_e986, _e983, (_e983 > _e986));
                                                                        let _e991 = bitcast<f32>((bitcast<u32>(_e962) & 2147483647u));
                                                                        let _e993 = select(_e991, _e988, (_e988 > _e991));
                                                                        let _e996 = bitcast<f32>((bitcast<u32>(_e964) & 2147483647u));
                                                                        let _e999 = bitcast<f32>((bitcast<u32>(_e965) & 2147483647u));
                                                                        let _e1001 = select(_e999, _e996, (_e996 > _e999));
                                                                        let _e1004 = bitcast<f32>((bitcast<u32>(_e966) & 2147483647u));
                                                                        let _e1006 = select(_e1004, _e1001, (_e1001 > _e1004));
                                                                        let _e1008 = select(_e993, _e980, (_e980 > _e993));
                                                                        let _e1010 = select(_e1006, _e1008, (_e1008 > _e1006));
                                                                        if (_e980 == _e1010) {
                                                                            phi_2022_ = _e817;
                                                                            phi_2023_ = _e814;
                                                                            phi_2024_ = _e804;
                                                                            phi_2025_ = _e801;
                                                                            phi_2026_ = _e953;
                                                                            phi_2027_ = _e967;
                                                                            phi_2028_ = _e963;
                                                                            phi_2029_ = _e959;
                                                                        } else {
                                                                            let _e1012 = (_e993 == _e1010);
                                                                            let _e1017 = vec3(_e1012);
                                                                            phi_2022_ = select(_e804, _e830, _e1012);
                                                                            phi_2023_ = select(_e801, _e827, _e1012);
                                                                            phi_2024_ = select(_e830, _e817, _e1012);
                                                                            phi_2025_ = select(_e827, _e814, _e1012);
                                                                            phi_2026_ = select(_e955, _e954, _e1017);
                                                                            phi_2027_ = select(_e963, _e959, _e1017);
                                                                            phi_2028_ = select(_e959, _e967, _e1017);
                                                                            phi_2029_ = select(_e967, _e963, _e1017);
                                                                        }
                                                                        let _e1023 = phi_2022_;
                                                                        let _e1025 = phi_2023_;
                                                                        let _e1027 = phi_2024_;
                                                                        let _e1029 = phi_2025_;
                                                                        let _e1031 = phi_2026_;
                                                                        let _e1033 = phi_2027_;
                                                                        let _e1035 = phi_2028_;
                                                                        let _e1037 = phi_2029_;
                                                                        let _e1044 = ((_e1035.y * _e1033.z) - (_e1033.y * _e1035.z));
                                                                        let _e1049 = ((_e1035.z * _e1033.x) - (_e1033.z * _e1035.x));
                                                                        let _e1052 = ((_e1035.x * _e1033.y) - (_e1033.x * _e1035.y));
                                                                        if (_e852 >= _e856) {
                                                                            phi_2066_ = select(true, false, (_e852 >= _e860));
                                                                        } else {
                                                                            phi_2066_ = true;
                                                                        }
                                                                        let _e1057 = phi_2066_;
                                                                        if _e1057 {
                                                                            phi_2075_ = select(_e955, _e954, vec3((_e856 >= _e860)));
                                                                        } else {
                                                                            phi_2075_ = _e953;
                                                                        }
                                                                        let _e1062 = phi_2075_;
                                                                        let _e1073 = (((_e1044 * (_e1062.x - _e316)) + (_e1049 * (_e1062.y - _e385))) + (_e1052 * (_e1062.z - _e453)));
                                                                        let _e1078 = (((_e1044 * _e356) + (_e1049 * _e424)) + (_e1052 * _e492));
                                                                        let _e1079 = (_e1025 - _e1029);
                                                                        let _e1080 = (_e1023 - _e1027);
                                                                        let _e1088 = (-(((_e1029 * _e1079) + (_e1027 * _e1080))) / ((_e1079 * _e1079) + (_e1080 * _e1080)));
                                                                        let _e1090 = select(1f, _e1088, (_e1088 < 1f));
                                                                        let _e1092 = select(0f, _e1090, (_e1090 > 0f));
                                                                        let _e1105 = ((_e1031.x + (_e1037.x * _e1092)) - _e316);
                                                                        let _e1106 = ((_e1031.y + (_e1037.y * _e1092)) - _e385);
                                                                        let _e1107 = ((_e1031.z + (_e1037.z * _e1092)) - _e453);
                                                                        let _e1108 = (_e1107 / _e492);
                                                                        let _e1120 = bitcast<f32>((bitcast<u32>(_e1105) & 2147483647u));
                                                                        let _e1123 = bitcast<f32>((bitcast<u32>(_e1106) & 2147483647u));
                                                                        let _e1125 = select(_e1123, _e1120, (_e1120 > _e1123));
                                                                        let _e1128 = bitcast<f32>((bitcast<u32>(_e1107) & 2147483647u));
                                                                        let _e1130 = select(_e1128, _e1125, (_e1125 > _e1128));
                                                                        let _e1136 = bitcast<f32>((bitcast<u32>(_e1044) & 2147483647u));
                                                                        let _e1139 = bitcast<f32>((bitcast<u32>(_e1049) & 2147483647u));
                                                                        let _e1141 = select(_e1139, _e1136, (_e1136 > _e1139));
                                                                        let _e1144 = bitcast<f32>((bitcast<u32>(_e1052) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1044 * _e1105) + (_e1049 * _e1106)) + (_e1052 * _e1107)) - _e1073)) & 2147483647u)) <= ((0.0000009536743f * select(_e1010, _e1130, (_e1130 > _e1010))) * select(_e1144, _e1141, (_e1141 > _e1144)))) {
                                                                            let _e1154 = bitcast<f32>((bitcast<u32>(_e1035.x) & 2147483647u));
                                                                            let _e1157 = bitcast<f32>((bitcast<u32>(_e1035.y) & 2147483647u));
                                                                            let _e1159 = select(_e1157, _e1154, (_e1154 > _e1157));
                                                                            let _e1162 = bitcast<f32>((bitcast<u32>(_e1035.z) & 2147483647u));
                                                                            let _e1168 = bitcast<f32>((bitcast<u32>(_e1033.x) & 2147483647u));
                                                                            let _e1171 = bitcast<f32>((bitcast<u32>(_e1033.y) & 2147483647u));
                                                                            let _e1173 = select(_e1171, _e1168, (_e1168 > _e1171));
                                                                            let _e1176 = bitcast<f32>((bitcast<u32>(_e1033.z) & 2147483647u));
                                                                            let _e1180 = (bitcast<f32>((bitcast<u32>(_e1078) & 2147483647u)) > ((0.0000038146973f * select(_e1162, _e1159, (_e1159 > _e1162))) * select(_e1176, _e1173, (_e1173 > _e1176))));
                                                                            if _e1180 {
                                                                                phi_2240_ = (_e1073 / _e1078);
                                                                            } else {
                                                                                phi_2240_ = f32();
                                                                            }
                                                                            let _e1183 = phi_2240_;
                                                                            phi_2242_ = _e1183;
                                                                            phi_2243_ = select(true, false, _e1180);
                                                                        } else {
                                                                            phi_2242_ = f32();
                                                                            phi_2243_ = true;
                                                                        }
                                                                        let _e1186 = phi_2242_;
                                                                        let _e1188 = phi_2243_;
                                                                        if _e1188 {
                                                                            let _e1196 = (((_e1044 * (_e1105 - (_e356 * _e1108))) + (_e1049 * (_e1106 - (_e424 * _e1108)))) / _e1078);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1196) & 2147483647u)) <= _e1010) {
                                                                                phi_2263_ = (_e1108 + _e1196);
                                                                            } else {
                                                                                phi_2263_ = _e1108;
                                                                            }
                                                                            let _e1203 = phi_2263_;
                                                                            phi_2264_ = _e1203;
                                                                        } else {
                                                                            phi_2264_ = _e1186;
                                                                        }
                                                                        let _e1205 = phi_2264_;
                                                                        let _e1207 = select(_e943, _e1205, (_e1205 < _e943));
                                                                        let _e1209 = select(_e935, _e1207, (_e1207 > _e935));
                                                                        if (_e1209 >= _e607) {
                                                                            let _e1211 = (_e1209 <= _e695);
                                                                            if _e1211 {
                                                                                let _e1212 = (1f / _e862);
                                                                                phi_2287_ = type_22(_e1209, (_e856 * _e1212), (_e860 * _e1212), _e724);
                                                                            } else {
                                                                                phi_2287_ = type_22();
                                                                            }
                                                                            let _e1217 = phi_2287_;
                                                                            phi_2289_ = _e1217;
                                                                            phi_2290_ = select(true, false, _e1211);
                                                                        } else {
                                                                            phi_2289_ = type_22();
                                                                            phi_2290_ = true;
                                                                        }
                                                                        let _e1220 = phi_2289_;
                                                                        let _e1222 = phi_2290_;
                                                                        if _e1222 {
                                                                            phi_2294_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2294_ = _e1220;
                                                                        }
                                                                        let _e1224 = phi_2294_;
                                                                        phi_2295_ = _e1224;
                                                                    }
                                                                    let _e1226 = phi_2295_;
                                                                    phi_2296_ = _e1226;
                                                                    phi_2297_ = _e952;
                                                                }
                                                                let _e1228 = phi_2296_;
                                                                let _e1230 = phi_2297_;
                                                                phi_2301_ = _e1228;
                                                                phi_2302_ = _e1230;
                                                            }
                                                            let _e1232 = phi_2301_;
                                                            let _e1234 = phi_2302_;
                                                            phi_2303_ = _e1232;
                                                            phi_2304_ = _e887;
                                                            phi_2305_ = _e1234;
                                                        }
                                                        let _e1236 = phi_2303_;
                                                        let _e1238 = phi_2304_;
                                                        let _e1240 = phi_2305_;
                                                        phi_2306_ = _e1236;
                                                        phi_2307_ = _e1238;
                                                        phi_2308_ = _e1240;
                                                    }
                                                    let _e1242 = phi_2306_;
                                                    let _e1244 = phi_2307_;
                                                    let _e1246 = phi_2308_;
                                                    phi_2316_ = _e1242;
                                                    phi_2317_ = select(_e1246, true, _e1244);
                                                } else {
                                                    phi_2316_ = type_22();
                                                    phi_2317_ = true;
                                                }
                                                let _e1249 = phi_2316_;
                                                let _e1251 = phi_2317_;
                                                if _e1251 {
                                                    phi_2321_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2321_ = _e1249;
                                                }
                                                let _e1253 = phi_2321_;
                                                if (_e1253.member_3 != 4294967295u) {
                                                    if (_e724 != 4294967295u) {
                                                        phi_2333_ = type_4(0u, 8u);
                                                        phi_2336_ = _e1253;
                                                        loop {
                                                            let _e1258 = phi_2333_;
                                                            let _e1260 = phi_2336_;
                                                            if (_e1258.member < _e1258.member_1) {
                                                                phi_2334_ = type_4((_e1258.member + 1u), _e1258.member_1);
                                                                phi_2359_ = type_4(1u, _e1258.member);
                                                            } else {
                                                                phi_2334_ = _e1258;
                                                                phi_2359_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1273 = phi_2334_;
                                                            let _e1275 = phi_2359_;
                                                            let _e1279 = (bitcast<i32>(_e1275.member) != 0i);
                                                            if _e1279 {
                                                                let _e1280 = (_e1275.member_1 < 8u);
                                                                if _e1280 {
                                                                } else {
                                                                    phi_3778_ = true;
                                                                    break;
                                                                }
                                                                let _e1285 = local_7[_e1275.member_1].member;
                                                                if (_e1260.member < _e1285) {
                                                                    phi_2392_ = true;
                                                                } else {
                                                                    let _e1287 = local_7[_e1275.member_1].member;
                                                                    if (_e1260.member == _e1287) {
                                                                        let _e1292 = local_7[_e1275.member_1].member_3;
                                                                        phi_2391_ = (_e1260.member_3 < _e1292);
                                                                    } else {
                                                                        phi_2391_ = false;
                                                                    }
                                                                    let _e1295 = phi_2391_;
                                                                    phi_2392_ = _e1295;
                                                                }
                                                                let _e1297 = phi_2392_;
                                                                if _e1297 {
                                                                    if _e1280 {
                                                                    } else {
                                                                        phi_3778_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1298 = local_7[_e1275.member_1];
                                                                    local_7[_e1275.member_1] = type_22(_e1260.member, _e1260.member_1, _e1260.member_2, _e1260.member_3);
                                                                    phi_2413_ = type_22(_e1298.member, _e1298.member_1, _e1298.member_2, _e1298.member_3);
                                                                } else {
                                                                    phi_2413_ = _e1260;
                                                                }
                                                                let _e1309 = phi_2413_;
                                                                phi_2337_ = _e1309;
                                                            } else {
                                                                phi_2337_ = type_22();
                                                            }
                                                            let _e1311 = phi_2337_;
                                                            continue;
                                                            continuing {
                                                                phi_2333_ = _e1273;
                                                                phi_2336_ = _e1311;
                                                                phi_3778_ = _e693;
                                                                break if !(_e1279);
                                                            }
                                                        }
                                                        let _e1314 = phi_3778_;
                                                        phi_3969_ = _e695;
                                                        phi_3938_ = _e1314;
                                                        if _e1314 {
                                                            break;
                                                        }
                                                        let _e1317 = local_7[7u].member_3;
                                                        if (_e1317 != 4294967295u) {
                                                            let _e1321 = local_7[7u].member;
                                                            phi_4060_ = _e1321;
                                                        } else {
                                                            phi_4060_ = _e695;
                                                        }
                                                        let _e1323 = phi_4060_;
                                                        phi_4059_ = _e1323;
                                                        phi_3941_ = _e1314;
                                                    } else {
                                                        phi_4059_ = _e695;
                                                        phi_3941_ = _e693;
                                                    }
                                                    let _e1325 = phi_4059_;
                                                    let _e1327 = phi_3941_;
                                                    phi_4058_ = _e1325;
                                                    phi_3940_ = _e1327;
                                                } else {
                                                    phi_4058_ = _e695;
                                                    phi_3940_ = _e693;
                                                }
                                                let _e1329 = phi_4058_;
                                                let _e1331 = phi_3940_;
                                                phi_4057_ = _e1329;
                                                phi_3939_ = _e1331;
                                            } else {
                                                phi_4057_ = _e695;
                                                phi_3939_ = _e693;
                                            }
                                            let _e1333 = phi_4057_;
                                            let _e1335 = phi_3939_;
                                            continue;
                                            continuing {
                                                phi_3787_ = _e1335;
                                                phi_3776_ = _e1333;
                                                phi_1284_ = _e710;
                                                phi_3969_ = _e1333;
                                                phi_3938_ = _e1335;
                                                break if !(_e716);
                                            }
                                        }
                                        let _e1338 = phi_3969_;
                                        let _e1340 = phi_3938_;
                                        phi_4061_ = _e1340;
                                        if _e1340 {
                                            break;
                                        }
                                        phi_4120_ = _e1340;
                                        phi_3968_ = _e1338;
                                    } else {
                                        phi_4120_ = _e638;
                                        phi_3968_ = _e640;
                                    }
                                    let _e1342 = phi_4120_;
                                    let _e1344 = phi_3968_;
                                    if _e686 {
                                        phi_3432_ = bool();
                                        phi_3433_ = u32();
                                        phi_3434_ = type_51();
                                    } else {
                                        let _e1345 = (_e682.member_1 < _e90);
                                        if _e1345 {
                                            if _e1345 {
                                            } else {
                                                phi_4061_ = true;
                                                break;
                                            }
                                            let _e1347 = global_5.member[_e682.member_1];
                                            phi_2445_ = _e1347;
                                        } else {
                                            phi_2445_ = type_44(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e1349 = phi_2445_;
                                        let _e1364 = ((10u * _e252) & 31u);
                                        let _e1367 = ((_e1349.member[0] >> bitcast<u32>(_e1364)) & 1023u);
                                        let _e1375 = bitcast<f32>((bitcast<u32>(((_e682.member.member_1[0] - _e682.member.member[0]) * 0.0009775171f)) ^ _e124));
                                        let _e1380 = (_e682.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1367)) - 8388608f) * _e1375)) ^ _e124)));
                                        let _e1384 = select(select(_e682.member.member_1[0], _e1380, (_e1380 < _e682.member.member_1[0])), _e682.member.member_1[0], (_e1367 == 1023u));
                                        let _e1386 = ((10u * _e251) & 31u);
                                        let _e1389 = ((_e1349.member[0] >> bitcast<u32>(_e1386)) & 1023u);
                                        let _e1397 = bitcast<f32>((bitcast<u32>(((_e682.member.member_1[1] - _e682.member.member[1]) * 0.0009775171f)) ^ _e124));
                                        let _e1402 = (_e682.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1389)) - 8388608f) * _e1397)) ^ _e124)));
                                        let _e1406 = select(select(_e682.member.member_1[1], _e1402, (_e1402 < _e682.member.member_1[1])), _e682.member.member_1[1], (_e1389 == 1023u));
                                        let _e1408 = ((10u * _e253) & 31u);
                                        let _e1411 = ((_e1349.member[0] >> bitcast<u32>(_e1408)) & 1023u);
                                        let _e1419 = bitcast<f32>((bitcast<u32>(((_e682.member.member_1[2] - _e682.member.member[2]) * 0.0009775171f)) ^ _e124));
                                        let _e1424 = (_e682.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1411)) - 8388608f) * _e1419)) ^ _e124)));
                                        let _e1428 = select(select(_e682.member.member_1[2], _e1424, (_e1424 < _e682.member.member_1[2])), _e682.member.member_1[2], (_e1411 == 1023u));
                                        let _e1431 = ((_e1349.member[1] >> bitcast<u32>(_e1364)) & 1023u);
                                        let _e1439 = (_e682.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1431)) - 8388608f) * _e1375)) ^ _e124)));
                                        let _e1443 = select(select(_e682.member.member_1[0], _e1439, (_e1439 < _e682.member.member_1[0])), _e682.member.member_1[0], (_e1431 == 1023u));
                                        let _e1446 = ((_e1349.member[1] >> bitcast<u32>(_e1386)) & 1023u);
                                        let _e1454 = (_e682.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1446)) - 8388608f) * _e1397)) ^ _e124)));
                                        let _e1458 = select(select(_e682.member.member_1[1], _e1454, (_e1454 < _e682.member.member_1[1])), _e682.member.member_1[1], (_e1446 == 1023u));
                                        let _e1461 = ((_e1349.member[1] >> bitcast<u32>(_e1408)) & 1023u);
                                        let _e1469 = (_e682.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1461)) - 8388608f) * _e1419)) ^ _e124)));
                                        let _e1473 = select(select(_e682.member.member_1[2], _e1469, (_e1469 < _e682.member.member_1[2])), _e682.member.member_1[2], (_e1461 == 1023u));
                                        let _e1479 = ((_e1349.member_1[0] >> bitcast<u32>(_e1364)) & 1023u);
                                        let _e1487 = (_e682.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1479)) - 8388608f) * _e1375)) ^ _e124)));
                                        let _e1491 = select(select(_e682.member.member_1[0], _e1487, (_e1487 < _e682.member.member_1[0])), _e682.member.member_1[0], (_e1479 == 1023u));
                                        let _e1494 = ((_e1349.member_1[0] >> bitcast<u32>(_e1386)) & 1023u);
                                        let _e1502 = (_e682.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1494)) - 8388608f) * _e1397)) ^ _e124)));
                                        let _e1506 = select(select(_e682.member.member_1[1], _e1502, (_e1502 < _e682.member.member_1[1])), _e682.member.member_1[1], (_e1494 == 1023u));
                                        let _e1509 = ((_e1349.member_1[0] >> bitcast<u32>(_e1408)) & 1023u);
                                        let _e1517 = (_e682.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1509)) - 8388608f) * _e1419)) ^ _e124)));
                                        let _e1521 = select(select(_e682.member.member_1[2], _e1517, (_e1517 < _e682.member.member_1[2])), _e682.member.member_1[2], (_e1509 == 1023u));
                                        let _e1524 = ((_e1349.member_1[1] >> bitcast<u32>(_e1364)) & 1023u);
                                        let _e1532 = (_e682.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1524)) - 8388608f) * _e1375)) ^ _e124)));
                                        let _e1536 = select(select(_e682.member.member_1[0], _e1532, (_e1532 < _e682.member.member_1[0])), _e682.member.member_1[0], (_e1524 == 1023u));
                                        let _e1539 = ((_e1349.member_1[1] >> bitcast<u32>(_e1386)) & 1023u);
                                        let _e1547 = (_e682.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1539)) - 8388608f) * _e1397)) ^ _e124)));
                                        let _e1551 = select(select(_e682.member.member_1[1], _e1547, (_e1547 < _e682.member.member_1[1])), _e682.member.member_1[1], (_e1539 == 1023u));
                                        let _e1554 = ((_e1349.member_1[1] >> bitcast<u32>(_e1408)) & 1023u);
                                        let _e1562 = (_e682.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1554)) - 8388608f) * _e1419)) ^ _e124)));
                                        let _e1566 = select(select(_e682.member.member_1[2], _e1562, (_e1562 < _e682.member.member_1[2])), _e682.member.member_1[2], (_e1554 == 1023u));
                                        let _e1571 = type_51(type_49(array<f32, 3>(_e1384, _e1406, _e1428), array<f32, 3>(_e1443, _e1458, _e1473)), _e1349.member_2);
                                        let _e1576 = type_51(type_49(array<f32, 3>(_e1491, _e1506, _e1521), array<f32, 3>(_e1536, _e1551, _e1566)), _e1349.member_3);
                                        let _e1581 = ((_e1384 - _e354) * _e359);
                                        let _e1582 = ((_e1491 - _e354) * _e359);
                                        let _e1583 = ((_e1443 - _e355) * _e359);
                                        let _e1584 = ((_e1536 - _e355) * _e359);
                                        let _e1589 = ((_e1406 - _e422) * _e427);
                                        let _e1590 = ((_e1506 - _e422) * _e427);
                                        let _e1591 = ((_e1458 - _e423) * _e427);
                                        let _e1592 = ((_e1551 - _e423) * _e427);
                                        let _e1597 = ((_e1428 - _e490) * _e495);
                                        let _e1598 = ((_e1521 - _e490) * _e495);
                                        let _e1599 = ((_e1473 - _e491) * _e495);
                                        let _e1600 = ((_e1566 - _e491) * _e495);
                                        let _e1602 = select(_e1599, _e1597, (_e1597 < _e1599));
                                        let _e1604 = select(_e1600, _e1598, (_e1598 < _e1600));
                                        let _e1606 = select(_e1599, _e1597, (_e1597 > _e1599));
                                        let _e1608 = select(_e1600, _e1598, (_e1598 > _e1600));
                                        let _e1610 = select(_e1583, _e1581, (_e1581 < _e1583));
                                        let _e1612 = select(_e1584, _e1582, (_e1582 < _e1584));
                                        let _e1614 = select(_e1591, _e1589, (_e1589 < _e1591));
                                        let _e1616 = select(_e1592, _e1590, (_e1590 < _e1592));
                                        let _e1618 = select(_e1614, _e1610, (_e1610 > _e1614));
                                        let _e1620 = select(_e1616, _e1612, (_e1612 > _e1616));
                                        let _e1622 = select(_e1602, _e1618, (_e1618 > _e1602));
                                        let _e1624 = select(_e1604, _e1620, (_e1620 > _e1604));
                                        let _e1626 = select(_e1583, _e1581, (_e1581 > _e1583));
                                        let _e1628 = select(_e1584, _e1582, (_e1582 > _e1584));
                                        let _e1630 = select(_e1591, _e1589, (_e1589 > _e1591));
                                        let _e1632 = select(_e1592, _e1590, (_e1590 > _e1592));
                                        let _e1634 = select(_e1630, _e1626, (_e1626 < _e1630));
                                        let _e1636 = select(_e1632, _e1628, (_e1628 < _e1632));
                                        let _e1641 = -(_e1602);
                                        let _e1642 = -(_e1604);
                                        let _e1649 = (select(_e1606, _e1634, (_e1634 < _e1606)) + (select(_e1641, _e1606, (_e1606 > _e1641)) * 0.0000019073523f));
                                        let _e1650 = (select(_e1608, _e1636, (_e1636 < _e1608)) + (select(_e1642, _e1608, (_e1608 > _e1642)) * 0.0000019073523f));
                                        let _e1652 = select(_e607, _e1622, (_e1622 > _e607));
                                        let _e1654 = select(_e607, _e1624, (_e1624 > _e607));
                                        let _e1659 = (_e1652 <= select(_e1344, _e1649, (_e1649 < _e1344)));
                                        let _e1660 = (_e1654 <= select(_e1344, _e1650, (_e1650 < _e1344)));
                                        let _e1661 = (_e1652 <= _e1654);
                                        if _e1659 {
                                            if _e1660 {
                                                if _e1661 {
                                                    phi_3332_ = _e1576;
                                                } else {
                                                    phi_3332_ = _e1571;
                                                }
                                                let _e1663 = phi_3332_;
                                                let _e1670 = (_e680 % 128u);
                                                let _e1671 = (_e1670 < 128u);
                                                if _e1671 {
                                                } else {
                                                    phi_4061_ = true;
                                                    break;
                                                }
                                                local_6[_e1670] = _e1663.member_1;
                                                if _e1671 {
                                                } else {
                                                    phi_4061_ = true;
                                                    break;
                                                }
                                                local_5[_e1670] = _e1663.member.member[0];
                                                if _e1671 {
                                                } else {
                                                    phi_4061_ = true;
                                                    break;
                                                }
                                                local_4[_e1670] = _e1663.member.member[1];
                                                if _e1671 {
                                                } else {
                                                    phi_4061_ = true;
                                                    break;
                                                }
                                                local_3[_e1670] = _e1663.member.member[2];
                                                if _e1671 {
                                                } else {
                                                    phi_4061_ = true;
                                                    break;
                                                }
                                                local_2[_e1670] = _e1663.member.member_1[0];
                                                if _e1671 {
                                                } else {
                                                    phi_4061_ = true;
                                                    break;
                                                }
                                                local_1[_e1670] = _e1663.member.member_1[1];
                                                if _e1671 {
                                                } else {
                                                    phi_4061_ = true;
                                                    break;
                                                }
                                                local[_e1670] = _e1663.member.member_1[2];
                                                if _e1671 {
                                                } else {
                                                    phi_4061_ = true;
                                                    break;
                                                }
                                                local_8[_e1670] = select(_e1652, _e1654, _e1661);
                                                if _e1661 {
                                                    phi_3408_ = _e1571;
                                                } else {
                                                    phi_3408_ = _e1576;
                                                }
                                                let _e1688 = phi_3408_;
                                                phi_3409_ = (_e680 + 1u);
                                                phi_3410_ = _e1688;
                                            } else {
                                                phi_3409_ = u32();
                                                phi_3410_ = type_51();
                                            }
                                            let _e1690 = phi_3409_;
                                            let _e1692 = phi_3410_;
                                            phi_3412_ = _e1690;
                                            phi_3413_ = _e1692;
                                            phi_3414_ = select(true, false, _e1660);
                                        } else {
                                            phi_3412_ = u32();
                                            phi_3413_ = type_51();
                                            phi_3414_ = true;
                                        }
                                        let _e1695 = phi_3412_;
                                        let _e1697 = phi_3413_;
                                        let _e1699 = phi_3414_;
                                        if _e1699 {
                                            if _e1659 {
                                                phi_3421_ = _e1571;
                                            } else {
                                                phi_3421_ = _e1576;
                                            }
                                            let _e1701 = phi_3421_;
                                            phi_3426_ = select(_e1660, true, _e1659);
                                            phi_3428_ = _e1701;
                                        } else {
                                            phi_3426_ = _e678;
                                            phi_3428_ = _e1697;
                                        }
                                        let _e1704 = phi_3426_;
                                        let _e1706 = phi_3428_;
                                        phi_3432_ = _e1704;
                                        phi_3433_ = select(_e1695, _e680, _e1699);
                                        phi_3434_ = _e1706;
                                    }
                                    let _e1709 = phi_3432_;
                                    let _e1711 = phi_3433_;
                                    let _e1713 = phi_3434_;
                                    if _e686 {
                                        phi_3444_ = _e682;
                                    } else {
                                        phi_3444_ = _e1713;
                                    }
                                    let _e1715 = phi_3444_;
                                    phi_4147_ = _e1344;
                                    phi_4064_ = _e1342;
                                    phi_3445_ = (_e642 - 1u);
                                    phi_3446_ = select(_e1709, false, _e686);
                                    phi_3447_ = select(_e1711, _e680, _e686);
                                    phi_3448_ = _e1715;
                                } else {
                                    phi_4147_ = _e640;
                                    phi_4064_ = _e638;
                                    phi_3445_ = _e642;
                                    phi_3446_ = _e678;
                                    phi_3447_ = _e680;
                                    phi_3448_ = _e682;
                                }
                                let _e1719 = phi_4147_;
                                let _e1721 = phi_4064_;
                                let _e1723 = phi_3445_;
                                let _e1725 = phi_3446_;
                                let _e1727 = phi_3447_;
                                let _e1729 = phi_3448_;
                                phi_4146_ = _e1719;
                                phi_4063_ = _e1721;
                                phi_3449_ = _e1723;
                                phi_3450_ = _e1725;
                                phi_3451_ = _e1727;
                                phi_3452_ = _e1729;
                            } else {
                                phi_4146_ = _e640;
                                phi_4063_ = _e638;
                                phi_3449_ = u32();
                                phi_3450_ = bool();
                                phi_3451_ = u32();
                                phi_3452_ = type_51();
                            }
                            let _e1731 = phi_4146_;
                            let _e1733 = phi_4063_;
                            let _e1735 = phi_3449_;
                            let _e1737 = phi_3450_;
                            let _e1739 = phi_3451_;
                            let _e1741 = phi_3452_;
                            phi_4145_ = _e1731;
                            phi_4062_ = _e1733;
                            phi_1160_ = _e1735;
                            phi_1163_ = _e1737;
                            phi_1165_ = _e1739;
                            phi_1167_ = _e1741;
                            phi_3453_ = _e652;
                        } else {
                            phi_4145_ = _e640;
                            phi_4062_ = _e638;
                            phi_1160_ = u32();
                            phi_1163_ = bool();
                            phi_1165_ = u32();
                            phi_1167_ = type_51();
                            phi_3453_ = false;
                        }
                        let _e1743 = phi_4145_;
                        let _e1745 = phi_4062_;
                        let _e1747 = phi_1160_;
                        let _e1749 = phi_1163_;
                        let _e1751 = phi_1165_;
                        let _e1753 = phi_1167_;
                        let _e1755 = phi_3453_;
                        continue;
                        continuing {
                            phi_3790_ = _e1745;
                            phi_3771_ = _e1743;
                            phi_1159_ = _e1747;
                            phi_1162_ = _e1749;
                            phi_1164_ = _e1751;
                            phi_1166_ = _e1753;
                            phi_4061_ = _e1745;
                            break if !(_e1755);
                        }
                    }
                    let _e1758 = phi_4061_;
                    if _e1758 {
                        break;
                    }
                    phi_3460_ = type_4(0u, 8u);
                    loop {
                        let _e1760 = phi_3460_;
                        if (_e1760.member < _e1760.member_1) {
                            phi_3461_ = type_4((_e1760.member + 1u), _e1760.member_1);
                            phi_3484_ = type_4(1u, _e1760.member);
                        } else {
                            phi_3461_ = _e1760;
                            phi_3484_ = type_4(0u, type_4().member_1);
                        }
                        let _e1773 = phi_3461_;
                        let _e1775 = phi_3484_;
                        let _e1779 = (bitcast<i32>(_e1775.member) != 0i);
                        if _e1779 {
                            let _e1780 = (_e1775.member_1 < 8u);
                            if _e1780 {
                            } else {
                                phi_4127_ = true;
                                break;
                            }
                            let _e1782 = local_7[_e1775.member_1];
                            if (_e1782.member_3 != 4294967295u) {
                                let _e1788 = -(_e509);
                                let _e1789 = bitcast<u32>(_e1782.member);
                                let _e1793 = (bitcast<i32>((_e1789 >> bitcast<u32>(23i))) & 255i);
                                let _e1794 = (_e1793 + _e1788);
                                if (_e1793 == 255i) {
                                    phi_3557_ = _e1782.member;
                                } else {
                                    if (_e1793 > 0i) {
                                        if (_e1794 > 0i) {
                                            let _e1798 = (_e1794 < 255i);
                                            if _e1798 {
                                                phi_3536_ = bitcast<f32>((_e1789 + bitcast<u32>((_e1788 << bitcast<u32>(23i)))));
                                            } else {
                                                phi_3536_ = f32();
                                            }
                                            let _e1805 = phi_3536_;
                                            phi_3538_ = _e1805;
                                            phi_3539_ = select(true, false, _e1798);
                                        } else {
                                            phi_3538_ = f32();
                                            phi_3539_ = true;
                                        }
                                        let _e1808 = phi_3538_;
                                        let _e1810 = phi_3539_;
                                        phi_3540_ = _e1808;
                                        phi_3541_ = _e1810;
                                    } else {
                                        phi_3540_ = f32();
                                        phi_3541_ = true;
                                    }
                                    let _e1812 = phi_3540_;
                                    let _e1814 = phi_3541_;
                                    if _e1814 {
                                        let _e1815 = (_e1789 & 2147483648u);
                                        let _e1822 = ((_e1789 & 8388607u) | (select(0u, 1u, ((_e1789 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                        let _e1826 = (_e1822 == 0u);
                                        if _e1826 {
                                            phi_3730_ = bitcast<f32>(_e1815);
                                        } else {
                                            let _e1831 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1822)), 32u, _e1826) - 8u);
                                            let _e1834 = (_e1822 << bitcast<u32>((_e1831 & 31u)));
                                            let _e1836 = ((_e1794 + select(0i, 1i, (_e1793 == 0i))) - bitcast<i32>(_e1831));
                                            if (_e1836 >= 255i) {
                                                phi_3720_ = bitcast<f32>((_e1815 | 2139095040u));
                                                phi_3721_ = f32();
                                                phi_3722_ = true;
                                            } else {
                                                let _e1838 = (_e1836 > 0i);
                                                if _e1838 {
                                                    phi_3714_ = bitcast<f32>(((_e1815 | (bitcast<u32>(_e1836) << bitcast<u32>(23i))) | (_e1834 & 8388607u)));
                                                    phi_3715_ = f32();
                                                } else {
                                                    if (_e1836 < -24i) {
                                                        phi_3680_ = 26u;
                                                    } else {
                                                        phi_3680_ = bitcast<u32>((1i - _e1836));
                                                    }
                                                    let _e1843 = phi_3680_;
                                                    let _e1844 = (_e1843 & 31u);
                                                    let _e1846 = (_e1834 >> bitcast<u32>(_e1844));
                                                    let _e1850 = (_e1834 & ((1u << bitcast<u32>(_e1844)) - 1u));
                                                    let _e1854 = (1u << bitcast<u32>(((_e1843 - 1u) & 31u)));
                                                    if (_e1850 > _e1854) {
                                                        phi_3701_ = true;
                                                    } else {
                                                        if (_e1850 == _e1854) {
                                                            phi_3698_ = ((_e1846 & 1u) == 1u);
                                                        } else {
                                                            phi_3698_ = false;
                                                        }
                                                        let _e1860 = phi_3698_;
                                                        phi_3701_ = _e1860;
                                                    }
                                                    let _e1862 = phi_3701_;
                                                    phi_3714_ = f32();
                                                    phi_3715_ = bitcast<f32>((_e1815 | (_e1846 + select(0u, 1u, _e1862))));
                                                }
                                                let _e1875 = phi_3714_;
                                                let _e1877 = phi_3715_;
                                                phi_3720_ = _e1875;
                                                phi_3721_ = _e1877;
                                                phi_3722_ = _e1838;
                                            }
                                            let _e1881 = phi_3720_;
                                            let _e1883 = phi_3721_;
                                            let _e1885 = phi_3722_;
                                            phi_3730_ = select(_e1883, _e1881, _e1885);
                                        }
                                        let _e1889 = phi_3730_;
                                        phi_3556_ = _e1889;
                                    } else {
                                        phi_3556_ = _e1812;
                                    }
                                    let _e1891 = phi_3556_;
                                    phi_3557_ = _e1891;
                                }
                                let _e1893 = phi_3557_;
                                let _e1894 = bitcast<u32>(_e1893);
                                if ((_e1894 & 2147483647u) >= 2139095040u) {
                                    phi_3569_ = bitcast<f32>(((_e1894 & 2147483648u) | 2139095039u));
                                } else {
                                    phi_3569_ = _e1893;
                                }
                                let _e1901 = phi_3569_;
                                phi_3574_ = type_22(_e1901, _e1782.member_1, _e1782.member_2, _e1782.member_3);
                            } else {
                                phi_3574_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1904 = phi_3574_;
                            if _e1780 {
                            } else {
                                phi_4127_ = true;
                                break;
                            }
                            local_7[_e1775.member_1] = type_22(_e1904.member, _e1904.member_1, _e1904.member_2, _e1904.member_3);
                        }
                        continue;
                        continuing {
                            phi_3460_ = _e1773;
                            phi_4127_ = _e1758;
                            break if !(_e1779);
                        }
                    }
                    let _e1912 = phi_4127_;
                    if _e1912 {
                        break;
                    }
                    let _e1913 = local_7;
                    if _e140 {
                    } else {
                        break;
                    }
                    global_6.member[_e138] = array<type_22, 8>(type_22(_e1913[0].member, _e1913[0].member_1, _e1913[0].member_2, _e1913[0].member_3), type_22(_e1913[1].member, _e1913[1].member_1, _e1913[1].member_2, _e1913[1].member_3), type_22(_e1913[2].member, _e1913[2].member_1, _e1913[2].member_2, _e1913[2].member_3), type_22(_e1913[3].member, _e1913[3].member_1, _e1913[3].member_2, _e1913[3].member_3), type_22(_e1913[4].member, _e1913[4].member_1, _e1913[4].member_2, _e1913[4].member_3), type_22(_e1913[5].member, _e1913[5].member_1, _e1913[5].member_2, _e1913[5].member_3), type_22(_e1913[6].member, _e1913[6].member_1, _e1913[6].member_2, _e1913[6].member_3), type_22(_e1913[7].member, _e1913[7].member_1, _e1913[7].member_2, _e1913[7].member_3));
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
