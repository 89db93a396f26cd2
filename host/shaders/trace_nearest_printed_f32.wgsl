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
    var phi_3813_: bool;
    var phi_3770_: f32;
    var phi_1161_: bool;
    var phi_1164_: u32;
    var phi_1166_: u32;
    var phi_1168_: type_51;
    var phi_1179_: bool;
    var phi_1266_: bool;
    var phi_1267_: u32;
    var phi_1268_: type_51;
    var phi_2452_: type_44;
    var phi_3339_: type_51;
    var phi_3416_: type_51;
    var phi_3417_: u32;
    var phi_3418_: type_51;
    var phi_3420_: u32;
    var phi_3421_: type_51;
    var phi_3422_: bool;
    var phi_3429_: type_51;
    var phi_3434_: bool;
    var phi_3436_: type_51;
    var phi_3810_: bool;
    var phi_3800_: f32;
    var phi_1286_: type_4;
    var phi_1287_: type_4;
    var phi_1310_: type_4;
    var phi_1331_: u32;
    var phi_1423_: array<array<f32, 3>, 3>;
    var phi_1576_: bool;
    var phi_1605_: bool;
    var phi_2024_: f32;
    var phi_2025_: f32;
    var phi_2026_: f32;
    var phi_2027_: f32;
    var phi_2028_: vec3<f32>;
    var phi_2029_: vec3<f32>;
    var phi_2030_: vec3<f32>;
    var phi_2031_: vec3<f32>;
    var phi_2068_: bool;
    var phi_2077_: vec3<f32>;
    var phi_2242_: f32;
    var phi_2244_: f32;
    var phi_2245_: bool;
    var phi_2265_: f32;
    var phi_2266_: f32;
    var phi_2289_: type_22;
    var phi_2291_: type_22;
    var phi_2292_: bool;
    var phi_2296_: type_22;
    var phi_2297_: type_22;
    var phi_2298_: type_22;
    var phi_2299_: bool;
    var phi_2303_: type_22;
    var phi_2304_: bool;
    var phi_2305_: type_22;
    var phi_2306_: bool;
    var phi_2307_: bool;
    var phi_2308_: type_22;
    var phi_2309_: bool;
    var phi_2310_: bool;
    var phi_2318_: type_22;
    var phi_2319_: bool;
    var phi_2323_: type_22;
    var phi_2335_: type_4;
    var phi_2338_: type_22;
    var phi_2336_: type_4;
    var phi_2361_: type_4;
    var phi_2393_: bool;
    var phi_2394_: bool;
    var phi_2415_: type_22;
    var phi_2339_: type_22;
    var phi_3801_: bool;
    var phi_4177_: f32;
    var phi_4176_: f32;
    var phi_3964_: bool;
    var phi_4175_: f32;
    var phi_3963_: bool;
    var phi_4174_: f32;
    var phi_3962_: bool;
    var phi_4086_: f32;
    var phi_3961_: bool;
    var phi_4051_: f32;
    var phi_3970_: bool;
    var phi_3440_: bool;
    var phi_3441_: u32;
    var phi_3442_: type_51;
    var phi_4050_: f32;
    var phi_3969_: bool;
    var phi_3443_: bool;
    var phi_3444_: u32;
    var phi_3445_: u32;
    var phi_3446_: type_51;
    var phi_4049_: f32;
    var phi_3968_: bool;
    var phi_3447_: bool;
    var phi_3448_: u32;
    var phi_3449_: u32;
    var phi_3450_: type_51;
    var phi_4048_: f32;
    var phi_3967_: bool;
    var phi_1162_: bool;
    var phi_1165_: u32;
    var phi_1167_: u32;
    var phi_1169_: type_51;
    var phi_3451_: bool;
    var phi_3966_: bool;
    var phi_3458_: type_4;
    var phi_3459_: type_4;
    var phi_3482_: type_4;
    var phi_3534_: f32;
    var phi_3536_: f32;
    var phi_3537_: bool;
    var phi_3538_: f32;
    var phi_3539_: bool;
    var phi_3678_: u32;
    var phi_3696_: bool;
    var phi_3699_: bool;
    var phi_3712_: f32;
    var phi_3713_: f32;
    var phi_3718_: f32;
    var phi_3719_: f32;
    var phi_3720_: bool;
    var phi_3728_: f32;
    var phi_3554_: f32;
    var phi_3555_: f32;
    var phi_3567_: f32;
    var phi_3572_: type_22;
    var phi_4030_: bool;

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
                    phi_3813_ = false;
                    phi_3770_ = _e605;
                    phi_1161_ = (_e607 <= _e605);
                    phi_1164_ = ((3u * _e90) + 1u);
                    phi_1166_ = 0u;
                    phi_1168_ = type_51(type_49(array<f32, 3>(_e614, _e618, _e622), array<f32, 3>(_e626, _e628, _e630)), select(0u, 2147483648u, (_e90 == 0u)));
                    loop {
                        let _e638 = phi_3813_;
                        let _e640 = phi_3770_;
                        let _e642 = phi_1161_;
                        let _e644 = phi_1164_;
                        let _e646 = phi_1166_;
                        let _e648 = phi_1168_;
                        if _e642 {
                            phi_1179_ = true;
                        } else {
                            phi_1179_ = (_e646 > 0u);
                        }
                        let _e651 = phi_1179_;
                        if _e651 {
                            let _e652 = (_e644 > 0u);
                            if _e652 {
                                if _e642 {
                                    phi_1266_ = _e642;
                                    phi_1267_ = _e646;
                                    phi_1268_ = _e648;
                                } else {
                                    let _e653 = (_e646 - 1u);
                                    let _e654 = (_e653 % 128u);
                                    let _e655 = (_e654 < 128u);
                                    if _e655 {
                                    } else {
                                        phi_3966_ = true;
                                        break;
                                    }
                                    let _e657 = local_6[_e654];
                                    if _e655 {
                                    } else {
                                        phi_3966_ = true;
                                        break;
                                    }
                                    let _e659 = local_5[_e654];
                                    if _e655 {
                                    } else {
                                        phi_3966_ = true;
                                        break;
                                    }
                                    let _e661 = local_4[_e654];
                                    if _e655 {
                                    } else {
                                        phi_3966_ = true;
                                        break;
                                    }
                                    let _e663 = local_3[_e654];
                                    if _e655 {
                                    } else {
                                        phi_3966_ = true;
                                        break;
                                    }
                                    let _e666 = local_2[_e654];
                                    if _e655 {
                                    } else {
                                        phi_3966_ = true;
                                        break;
                                    }
                                    let _e668 = local_1[_e654];
                                    if _e655 {
                                    } else {
                                        phi_3966_ = true;
                                        break;
                                    }
                                    let _e670 = local[_e654];
                                    if _e655 {
                                    } else {
                                        phi_3966_ = true;
                                        break;
                                    }
                                    let _e675 = local_8[_e654];
                                    phi_1266_ = (_e675 <= _e640);
                                    phi_1267_ = _e653;
                                    phi_1268_ = type_51(type_49(array<f32, 3>(_e659, _e661, _e663), array<f32, 3>(_e666, _e668, _e670)), _e657);
                                }
                                let _e678 = phi_1266_;
                                let _e680 = phi_1267_;
                                let _e682 = phi_1268_;
                                if _e678 {
                                    if ((_e682.member_1 & 2147483648u) != 0u) {
                                        phi_3810_ = _e638;
                                        phi_3800_ = _e640;
                                        phi_1286_ = type_4(0u, ((_e682.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1057 = phi_3810_;
                                            let _e1059 = phi_3800_;
                                            let _e1061 = phi_1286_;
                                            if (_e1061.member < _e1061.member_1) {
                                                phi_1287_ = type_4((_e1061.member + 1u), _e1061.member_1);
                                                phi_1310_ = type_4(1u, _e1061.member);
                                            } else {
                                                phi_1287_ = _e1061;
                                                phi_1310_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1074 = phi_1287_;
                                            let _e1076 = phi_1310_;
                                            let _e1080 = (bitcast<i32>(_e1076.member) != 0i);
                                            if _e1080 {
                                                let _e1081 = ((_e682.member_1 & 268435455u) + _e1076.member_1);
                                                let _e1082 = (_e1081 < _e92);
                                                if _e1082 {
                                                    if _e1082 {
                                                    } else {
                                                        phi_4086_ = _e1059;
                                                        phi_3961_ = true;
                                                        break;
                                                    }
                                                    let _e1086 = global_2.member[_e1081].member_1;
                                                    phi_1331_ = _e1086;
                                                } else {
                                                    phi_1331_ = 4294967295u;
                                                }
                                                let _e1088 = phi_1331_;
                                                if (_e1081 >= _e92) {
                                                    phi_1423_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1082 {
                                                    } else {
                                                        phi_4086_ = _e1059;
                                                        phi_3961_ = true;
                                                        break;
                                                    }
                                                    if (_e611 < 9u) {
                                                    } else {
                                                        phi_4086_ = _e1059;
                                                        phi_3961_ = true;
                                                        break;
                                                    }
                                                    let _e1095 = global_2.member[_e1081].member[_e611];
                                                    if (_e615 < 9u) {
                                                    } else {
                                                        phi_4086_ = _e1059;
                                                        phi_3961_ = true;
                                                        break;
                                                    }
                                                    let _e1101 = global_2.member[_e1081].member[_e615];
                                                    if (_e619 < 9u) {
                                                    } else {
                                                        phi_4086_ = _e1059;
                                                        phi_3961_ = true;
                                                        break;
                                                    }
                                                    let _e1107 = global_2.member[_e1081].member[_e619];
                                                    let _e1109 = (3u + _e611);
                                                    if (_e1109 < 9u) {
                                                    } else {
                                                        phi_4086_ = _e1059;
                                                        phi_3961_ = true;
                                                        break;
                                                    }
                                                    let _e1115 = global_2.member[_e1081].member[_e1109];
                                                    let _e1116 = (3u + _e615);
                                                    if (_e1116 < 9u) {
                                                    } else {
                                                        phi_4086_ = _e1059;
                                                        phi_3961_ = true;
                                                        break;
                                                    }
                                                    let _e1122 = global_2.member[_e1081].member[_e1116];
                                                    let _e1123 = (3u + _e619);
                                                    if (_e1123 < 9u) {
                                                    } else {
                                                        phi_4086_ = _e1059;
                                                        phi_3961_ = true;
                                                        break;
                                                    }
                                                    let _e1129 = global_2.member[_e1081].member[_e1123];
                                                    let _e1131 = (6u + _e611);
                                                    if (_e1131 < 9u) {
                                                    } else {
                                                        phi_4086_ = _e1059;
                                                        phi_3961_ = true;
                                                        break;
                                                    }
                                                    let _e1137 = global_2.member[_e1081].member[_e1131];
                                                    let _e1138 = (6u + _e615);
                                                    if (_e1138 < 9u) {
                                                    } else {
                                                        phi_4086_ = _e1059;
                                                        phi_3961_ = true;
                                                        break;
                                                    }
                                                    let _e1144 = global_2.member[_e1081].member[_e1138];
                                                    let _e1145 = (6u + _e619);
                                                    if (_e1145 < 9u) {
                                                    } else {
                                                        phi_4086_ = _e1059;
                                                        phi_3961_ = true;
                                                        break;
                                                    }
                                                    let _e1151 = global_2.member[_e1081].member[_e1145];
                                                    phi_1423_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1095, _e1101, _e1107), array<f32, 3>(_e1115, _e1122, _e1129), array<f32, 3>(_e1137, _e1144, _e1151));
                                                }
                                                let _e1155 = phi_1423_;
                                                let _e1162 = (_e1155[0][2] - _e453);
                                                let _e1165 = (((_e1155[0][0] - _e316) * _e492) - (_e1162 * _e356));
                                                let _e1168 = (((_e1155[0][1] - _e385) * _e492) - (_e1162 * _e424));
                                                let _e1175 = (_e1155[1][2] - _e453);
                                                let _e1178 = (((_e1155[1][0] - _e316) * _e492) - (_e1175 * _e356));
                                                let _e1181 = (((_e1155[1][1] - _e385) * _e492) - (_e1175 * _e424));
                                                let _e1188 = (_e1155[2][2] - _e453);
                                                let _e1191 = (((_e1155[2][0] - _e316) * _e492) - (_e1188 * _e356));
                                                let _e1194 = (((_e1155[2][1] - _e385) * _e492) - (_e1188 * _e424));
                                                let _e1195 = (_e1191 * _e1181);
                                                let _e1196 = (_e1194 * _e1178);
                                                let _e1197 = (_e1165 * _e1194);
                                                let _e1198 = (_e1168 * _e1191);
                                                let _e1199 = (_e1178 * _e1168);
                                                let _e1200 = (_e1181 * _e1165);
                                                let _e1205 = (((_e1195 >= _e1196) && (_e1197 >= _e1198)) && (_e1199 >= _e1200));
                                                if (_e1205 || (((_e1195 <= _e1196) && (_e1197 <= _e1198)) && (_e1199 <= _e1200))) {
                                                    let _e1212 = select(-1f, 1f, _e1205);
                                                    let _e1214 = ((_e1195 - _e1196) * _e1212);
                                                    let _e1216 = select(0f, _e1214, (_e1214 > 0f));
                                                    let _e1218 = ((_e1197 - _e1198) * _e1212);
                                                    let _e1220 = select(0f, _e1218, (_e1218 > 0f));
                                                    let _e1222 = ((_e1199 - _e1200) * _e1212);
                                                    let _e1224 = select(0f, _e1222, (_e1222 > 0f));
                                                    let _e1226 = ((_e1216 + _e1220) + _e1224);
                                                    if (_e1226 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2308_ = type_22();
                                                        phi_2309_ = true;
                                                        phi_2310_ = false;
                                                    } else {
                                                        let _e1229 = select(_e1178, _e1165, (_e1165 < _e1178));
                                                        if (select(_e1191, _e1229, (_e1229 < _e1191)) > 0f) {
                                                            phi_1576_ = true;
                                                        } else {
                                                            let _e1234 = select(_e1178, _e1165, (_e1165 > _e1178));
                                                            phi_1576_ = (select(_e1191, _e1234, (_e1234 > _e1191)) < 0f);
                                                        }
                                                        let _e1239 = phi_1576_;
                                                        if _e1239 {
                                                            phi_2305_ = type_22();
                                                            phi_2306_ = true;
                                                            phi_2307_ = false;
                                                        } else {
                                                            let _e1241 = select(_e1181, _e1168, (_e1168 < _e1181));
                                                            if (select(_e1194, _e1241, (_e1241 < _e1194)) > 0f) {
                                                                phi_1605_ = true;
                                                            } else {
                                                                let _e1246 = select(_e1181, _e1168, (_e1168 > _e1181));
                                                                phi_1605_ = (select(_e1194, _e1246, (_e1246 > _e1194)) < 0f);
                                                            }
                                                            let _e1251 = phi_1605_;
                                                            if _e1251 {
                                                                phi_2303_ = type_22();
                                                                phi_2304_ = false;
                                                            } else {
                                                                let _e1253 = select(_e1155[1][0], _e1155[0][0], (_e1155[0][0] < _e1155[1][0]));
                                                                let _e1257 = select(_e1155[1][0], _e1155[0][0], (_e1155[0][0] > _e1155[1][0]));
                                                                let _e1261 = select(_e1155[1][1], _e1155[0][1], (_e1155[0][1] < _e1155[1][1]));
                                                                let _e1265 = select(_e1155[1][1], _e1155[0][1], (_e1155[0][1] > _e1155[1][1]));
                                                                let _e1269 = select(_e1155[1][2], _e1155[0][2], (_e1155[0][2] < _e1155[1][2]));
                                                                let _e1273 = select(_e1155[1][2], _e1155[0][2], (_e1155[0][2] > _e1155[1][2]));
                                                                let _e1278 = ((select(_e1155[2][0], _e1253, (_e1253 < _e1155[2][0])) - _e354) * _e359);
                                                                let _e1279 = ((select(_e1155[2][0], _e1257, (_e1257 > _e1155[2][0])) - _e355) * _e359);
                                                                let _e1282 = ((select(_e1155[2][1], _e1261, (_e1261 < _e1155[2][1])) - _e422) * _e427);
                                                                let _e1283 = ((select(_e1155[2][1], _e1265, (_e1265 > _e1155[2][1])) - _e423) * _e427);
                                                                let _e1286 = ((select(_e1155[2][2], _e1269, (_e1269 < _e1155[2][2])) - _e490) * _e495);
                                                                let _e1287 = ((select(_e1155[2][2], _e1273, (_e1273 > _e1155[2][2])) - _e491) * _e495);
                                                                let _e1289 = select(_e1287, _e1286, (_e1286 < _e1287));
                                                                let _e1291 = select(_e1287, _e1286, (_e1286 > _e1287));
                                                                let _e1293 = select(_e1279, _e1278, (_e1278 < _e1279));
                                                                let _e1295 = select(_e1283, _e1282, (_e1282 < _e1283));
                                                                let _e1297 = select(_e1295, _e1293, (_e1293 > _e1295));
                                                                let _e1299 = select(_e1289, _e1297, (_e1297 > _e1289));
                                                                let _e1301 = select(_e1279, _e1278, (_e1278 > _e1279));
                                                                let _e1303 = select(_e1283, _e1282, (_e1282 > _e1283));
                                                                let _e1305 = select(_e1303, _e1301, (_e1301 < _e1303));
                                                                let _e1307 = select(_e1291, _e1305, (_e1305 < _e1291));
                                                                let _e1308 = -(_e1289);
                                                                let _e1314 = select(_e607, _e1299, (_e1299 > _e607));
                                                                if (_e1314 > (_e1307 + (select(_e1308, _e1291, (_e1291 > _e1308)) * 0.0000019073523f))) {
                                                                    phi_2298_ = type_22();
                                                                    phi_2299_ = true;
                                                                } else {
                                                                    let _e1316 = (_e1314 > _e1059);
                                                                    if _e1316 {
                                                                        phi_2297_ = type_22();
                                                                    } else {
                                                                        let _e1317 = vec3<f32>(_e1155[0][0], _e1155[0][1], _e1155[0][2]);
                                                                        let _e1318 = vec3<f32>(_e1155[1][0], _e1155[1][1], _e1155[1][2]);
                                                                        let _e1319 = vec3<f32>(_e1155[2][0], _e1155[2][1], _e1155[2][2]);
                                                                        let _e1320 = (_e1155[1][0] - _e1155[0][0]);
                                                                        let _e1321 = (_e1155[1][1] - _e1155[0][1]);
                                                                        let _e1322 = (_e1155[1][2] - _e1155[0][2]);
                                                                        let _e1323 = vec3<f32>(_e1320, _e1321, _e1322);
                                                                        let _e1324 = (_e1155[2][0] - _e1155[1][0]);
                                                                        let _e1325 = (_e1155[2][1] - _e1155[1][1]);
                                                                        let _e1326 = (_e1155[2][2] - _e1155[1][2]);
                                                                        let _e1327 = vec3<f32>(_e1324, _e1325, _e1326);
                                                                        let _e1328 = (_e1155[0][0] - _e1155[2][0]);
                                                                        let _e1329 = (_e1155[0][1] - _e1155[2][1]);
                                                                        let _e1330 = (_e1155[0][2] - _e1155[2][2]);
                                                                        let _e1331 = vec3<f32>(_e1328, _e1329, _e1330);
                                                                        let _e1334 = bitcast<f32>((bitcast<u32>(_e1320) & 2147483647u));
                                                                        let _e1337 = bitcast<f32>((bitcast<u32>(_e1321) & 2147483647u));
                                                                        let _e1339 = select(_e1337, _e1334, (_e1334 > _e1337));
                                                                        let _e1342 = bitcast<f32>((bitcast<u32>(_e1322) & 2147483647u));
                                                                        let _e1344 = select(_e1342, _e1339, (_e1339 > _e1342));
                                                                        let _e1347 = bitcast<f32>((bitcast<u32>(_e1324) & 2147483647u));
                                                                        let _e1350 = bitcast<f32>((bitcast<u32>(_e1325) & 2147483647u));
                                                                        let _e1352 = select(_e1350, _e1347, (_e1347 > _e1350));
                                                                        let _e1355 = bitcast<f32>((bitcast<u32>(_e1326) & 2147483647u));
                                                                        let _e1357 = select(_e1355, _e1352, (_e1352 > _e1355));
                                                                        let _e1360 = bitcast<f32>((bitcast<u32>(_e1328) & 2147483647u));
                                                                        let _e1363 = bitcast<f32>((bitcast<u32>(_e1329) & 2147483647u));
                                                                        let _e1365 = select(_e1363, _e1360, (_e1360 > _e1363));
                                                                        let _e1368 = bitcast<f32>((bitcast<u32>(_e1330) & 2147483647u));
                                                                        let _e1370 = select(_e1368, _e1365, (_e1365 > _e1368));
                                                                        let _e1372 = select(_e1357, _e1344, (_e1344 > _e1357));
                                                                        let _e1374 = select(_e1370, _e1372, (_e1372 > _e1370));
                                                                        if (_e1344 == _e1374) {
                                                                            phi_2024_ = _e1181;
                                                                            phi_2025_ = _e1178;
                                                                            phi_2026_ = _e1168;
                                                                            phi_2027_ = _e1165;
                                                                            phi_2028_ = _e1317;
                                                                            phi_2029_ = _e1331;
                                                                            phi_2030_ = _e1327;
                                                                            phi_2031_ = _e1323;
                                                                        } else {
                                                                            let _e1376 = (_e1357 == _e1374);
                                                                            let _e1381 = vec3(_e1376);
                                                                            phi_2024_ = select(_e1168, _e1194, _e1376);
                                                                            phi_2025_ = select(_e1165, _e1191, _e1376);
                                                                            phi_2026_ = select(_e1194, _e1181, _e1376);
                                                                            phi_2027_ = select(_e1191, _e1178, _e1376);
                                                                            phi_2028_ = select(_e1319, _e1318, _e1381);
                                                                            phi_2029_ = select(_e1327, _e1323, _e1381);
                                                                            phi_2030_ = select(_e1323, _e1331, _e1381);
                                                                            phi_2031_ = select(_e1331, _e1327, _e1381);
                                                                        }
                                                                        let _e1387 = phi_2024_;
                                                                        let _e1389 = phi_2025_;
                                                                        let _e1391 = phi_2026_;
                                                                        let _e1393 = phi_2027_;
                                                                        let _e1395 = phi_2028_;
                                                                        let _e1397 = phi_2029_;
                                                                        let _e1399 = phi_2030_;
                                                                        let _e1401 = phi_2031_;
                                                                        let _e1408 = ((_e1399.y * _e1397.z) - (_e1397.y * _e1399.z));
                                                                        let _e1413 = ((_e1399.z * _e1397.x) - (_e1397.z * _e1399.x));
                                                                        let _e1416 = ((_e1399.x * _e1397.y) - (_e1397.x * _e1399.y));
                                                                        if (_e1216 >= _e1220) {
                                                                            phi_2068_ = select(true, false, (_e1216 >= _e1224));
                                                                        } else {
                                                                            phi_2068_ = true;
                                                                        }
                                                                        let _e1421 = phi_2068_;
                                                                        if _e1421 {
                                                                            phi_2077_ = select(_e1319, _e1318, vec3((_e1220 >= _e1224)));
                                                                        } else {
                                                                            phi_2077_ = _e1317;
                                                                        }
                                                                        let _e1426 = phi_2077_;
                                                                        let _e1437 = (((_e1408 * (_e1426.x - _e316)) + (_e1413 * (_e1426.y - _e385))) + (_e1416 * (_e1426.z - _e453)));
                                                                        let _e1442 = (((_e1408 * _e356) + (_e1413 * _e424)) + (_e1416 * _e492));
                                                                        let _e1443 = (_e1389 - _e1393);
                                                                        let _e1444 = (_e1387 - _e1391);
                                                                        let _e1452 = (-(((_e1393 * _e1443) + (_e1391 * _e1444))) / ((_e1443 * _e1443) + (_e1444 * _e1444)));
                                                                        let _e1454 = select(1f, _e1452, (_e1452 < 1f));
                                                                        let _e1456 = select(0f, _e1454, (_e1454 > 0f));
                                                                        let _e1469 = ((_e1395.x + (_e1401.x * _e1456)) - _e316);
                                                                        let _e1470 = ((_e1395.y + (_e1401.y * _e1456)) - _e385);
                                                                        let _e1471 = ((_e1395.z + (_e1401.z * _e1456)) - _e453);
                                                                        let _e1472 = (_e1471 / _e492);
                                                                        let _e1484 = bitcast<f32>((bitcast<u32>(_e1469) & 2147483647u));
                                                                        let _e1487 = bitcast<f32>((bitcast<u32>(_e1470) & 2147483647u));
                                                                        let _e1489 = select(_e1487, _e1484, (_e1484 > _e1487));
                                                                        let _e1492 = bitcast<f32>((bitcast<u32>(_e1471) & 2147483647u));
                                                                        let _e1494 = select(_e1492, _e1489, (_e1489 > _e1492));
                                                                        let _e1500 = bitcast<f32>((bitcast<u32>(_e1408) & 2147483647u));
                                                                        let _e1503 = bitcast<f32>((bitcast<u32>(_e1413) & 2147483647u));
                                                                        let _e1505 = select(_e1503, _e1500, (_e1500 > _e1503));
                                                                        let _e1508 = bitcast<f32>((bitcast<u32>(_e1416) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1408 * _e1469) + (_e1413 * _e1470)) + (_e1416 * _e1471)) - _e1437)) & 2147483647u)) <= ((0.0000009536743f * select(_e1374, _e1494, (_e1494 > _e1374))) * select(_e1508, _e1505, (_e1505 > _e1508)))) {
                                                                            let _e1518 = bitcast<f32>((bitcast<u32>(_e1399.x) & 2147483647u));
                                                                            let _e1521 = bitcast<f32>((bitcast<u32>(_e1399.y) & 2147483647u));
                                                                            let _e1523 = select(_e1521, _e1518, (_e1518 > _e1521));
                                                                            let _e1526 = bitcast<f32>((bitcast<u32>(_e1399.z) & 2147483647u));
                                                                            let _e1532 = bitcast<f32>((bitcast<u32>(_e1397.x) & 2147483647u));
                                                                            let _e1535 = bitcast<f32>((bitcast<u32>(_e1397.y) & 2147483647u));
                                                                            let _e1537 = select(_e1535, _e1532, (_e1532 > _e1535));
                                                                            let _e1540 = bitcast<f32>((bitcast<u32>(_e1397.z) & 2147483647u));
                                                                            let _e1544 = (bitcast<f32>((bitcast<u32>(_e1442) & 2147483647u)) > ((0.0000038146973f * select(_e1526, _e1523, (_e1523 > _e1526))) * select(_e1540, _e1537, (_e1537 > _e1540))));
                                                                            if _e1544 {
                                                                                phi_2242_ = (_e1437 / _e1442);
                                                                            } else {
                                                                                phi_2242_ = f32();
                                                                            }
                                                                            let _e1547 = phi_2242_;
                                                                            phi_2244_ = _e1547;
                                                                            phi_2245_ = select(true, false, _e1544);
                                                                        } else {
                                                                            phi_2244_ = f32();
                                                                            phi_2245_ = true;
                                                                        }
                                                                        let _e1550 = phi_2244_;
                                                                        let _e1552 = phi_2245_;
                                                                        if _e1552 {
                                                                            let _e1560 = (((_e1408 * (_e1469 - (_e356 * _e1472))) + (_e1413 * (_e1470 - (_e424 * _e1472)))) / _e1442);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1560) & 2147483647u)) <= _e1374) {
                                                                                phi_2265_ = (_e1472 + _e1560);
                                                                            } else {
                                                                                phi_2265_ = _e1472;
                                                                            }
                                                                            let _e1567 = phi_2265_;
                                                                            phi_2266_ = _e1567;
                                                                        } else {
                                                                            phi_2266_ = _e1550;
                                                                        }
                                                                        let _e1569 = phi_2266_;
                                                                        let _e1571 = select(_e1307, _e1569, (_e1569 < _e1307));
                                                                        let _e1573 = select(_e1299, _e1571, (_e1571 > _e1299));
                                                                        if (_e1573 >= _e607) {
                                                                            let _e1575 = (_e1573 <= _e1059);
                                                                            if _e1575 {
                                                                                let _e1576 = (1f / _e1226);
                                                                                phi_2289_ = type_22(_e1573, (_e1220 * _e1576), (_e1224 * _e1576), _e1088);
                                                                            } else {
                                                                                phi_2289_ = type_22();
                                                                            }
                                                                            let _e1581 = phi_2289_;
                                                                            phi_2291_ = _e1581;
                                                                            phi_2292_ = select(true, false, _e1575);
                                                                        } else {
                                                                            phi_2291_ = type_22();
                                                                            phi_2292_ = true;
                                                                        }
                                                                        let _e1584 = phi_2291_;
                                                                        let _e1586 = phi_2292_;
                                                                        if _e1586 {
                                                                            phi_2296_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2296_ = _e1584;
                                                                        }
                                                                        let _e1588 = phi_2296_;
                                                                        phi_2297_ = _e1588;
                                                                    }
                                                                    let _e1590 = phi_2297_;
                                                                    phi_2298_ = _e1590;
                                                                    phi_2299_ = _e1316;
                                                                }
                                                                let _e1592 = phi_2298_;
                                                                let _e1594 = phi_2299_;
                                                                phi_2303_ = _e1592;
                                                                phi_2304_ = _e1594;
                                                            }
                                                            let _e1596 = phi_2303_;
                                                            let _e1598 = phi_2304_;
                                                            phi_2305_ = _e1596;
                                                            phi_2306_ = _e1251;
                                                            phi_2307_ = _e1598;
                                                        }
                                                        let _e1600 = phi_2305_;
                                                        let _e1602 = phi_2306_;
                                                        let _e1604 = phi_2307_;
                                                        phi_2308_ = _e1600;
                                                        phi_2309_ = _e1602;
                                                        phi_2310_ = _e1604;
                                                    }
                                                    let _e1606 = phi_2308_;
                                                    let _e1608 = phi_2309_;
                                                    let _e1610 = phi_2310_;
                                                    phi_2318_ = _e1606;
                                                    phi_2319_ = select(_e1610, true, _e1608);
                                                } else {
                                                    phi_2318_ = type_22();
                                                    phi_2319_ = true;
                                                }
                                                let _e1613 = phi_2318_;
                                                let _e1615 = phi_2319_;
                                                if _e1615 {
                                                    phi_2323_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2323_ = _e1613;
                                                }
                                                let _e1617 = phi_2323_;
                                                if (_e1617.member_3 != 4294967295u) {
                                                    if (_e1088 != 4294967295u) {
                                                        phi_2335_ = type_4(0u, 8u);
                                                        phi_2338_ = _e1617;
                                                        loop {
                                                            let _e1622 = phi_2335_;
                                                            let _e1624 = phi_2338_;
                                                            if (_e1622.member < _e1622.member_1) {
                                                                phi_2336_ = type_4((_e1622.member + 1u), _e1622.member_1);
                                                                phi_2361_ = type_4(1u, _e1622.member);
                                                            } else {
                                                                phi_2336_ = _e1622;
                                                                phi_2361_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1637 = phi_2336_;
                                                            let _e1639 = phi_2361_;
                                                            let _e1643 = (bitcast<i32>(_e1639.member) != 0i);
                                                            if _e1643 {
                                                                let _e1644 = (_e1639.member_1 < 8u);
                                                                if _e1644 {
                                                                } else {
                                                                    phi_3801_ = true;
                                                                    break;
                                                                }
                                                                let _e1649 = local_7[_e1639.member_1].member;
                                                                if (_e1624.member < _e1649) {
                                                                    phi_2394_ = true;
                                                                } else {
                                                                    let _e1651 = local_7[_e1639.member_1].member;
                                                                    if (_e1624.member == _e1651) {
                                                                        let _e1656 = local_7[_e1639.member_1].member_3;
                                                                        phi_2393_ = (_e1624.member_3 < _e1656);
                                                                    } else {
                                                                        phi_2393_ = false;
                                                                    }
                                                                    let _e1659 = phi_2393_;
                                                                    phi_2394_ = _e1659;
                                                                }
                                                                let _e1661 = phi_2394_;
                                                                if _e1661 {
                                                                    if _e1644 {
                                                                    } else {
                                                                        phi_3801_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1662 = local_7[_e1639.member_1];
                                                                    local_7[_e1639.member_1] = type_22(_e1624.member, _e1624.member_1, _e1624.member_2, _e1624.member_3);
                                                                    phi_2415_ = type_22(_e1662.member, _e1662.member_1, _e1662.member_2, _e1662.member_3);
                                                                } else {
                                                                    phi_2415_ = _e1624;
                                                                }
                                                                let _e1673 = phi_2415_;
                                                                phi_2339_ = _e1673;
                                                            } else {
                                                                phi_2339_ = type_22();
                                                            }
                                                            let _e1675 = phi_2339_;
                                                            continue;
                                                            continuing {
                                                                phi_2335_ = _e1637;
                                                                phi_2338_ = _e1675;
                                                                phi_3801_ = _e1057;
                                                                break if !(_e1643);
                                                            }
                                                        }
                                                        let _e1678 = phi_3801_;
                                                        phi_4086_ = _e1059;
                                                        phi_3961_ = _e1678;
                                                        if _e1678 {
                                                            break;
                                                        }
                                                        let _e1681 = local_7[7u].member_3;
                                                        if (_e1681 != 4294967295u) {
                                                            let _e1685 = local_7[7u].member;
                                                            phi_4177_ = _e1685;
                                                        } else {
                                                            phi_4177_ = _e1059;
                                                        }
                                                        let _e1687 = phi_4177_;
                                                        phi_4176_ = _e1687;
                                                        phi_3964_ = _e1678;
                                                    } else {
                                                        phi_4176_ = _e1059;
                                                        phi_3964_ = _e1057;
                                                    }
                                                    let _e1689 = phi_4176_;
                                                    let _e1691 = phi_3964_;
                                                    phi_4175_ = _e1689;
                                                    phi_3963_ = _e1691;
                                                } else {
                                                    phi_4175_ = _e1059;
                                                    phi_3963_ = _e1057;
                                                }
                                                let _e1693 = phi_4175_;
                                                let _e1695 = phi_3963_;
                                                phi_4174_ = _e1693;
                                                phi_3962_ = _e1695;
                                            } else {
                                                phi_4174_ = _e1059;
                                                phi_3962_ = _e1057;
                                            }
                                            let _e1697 = phi_4174_;
                                            let _e1699 = phi_3962_;
                                            continue;
                                            continuing {
                                                phi_3810_ = _e1699;
                                                phi_3800_ = _e1697;
                                                phi_1286_ = _e1074;
                                                phi_4086_ = _e1697;
                                                phi_3961_ = _e1699;
                                                break if !(_e1080);
                                            }
                                        }
                                        let _e1702 = phi_4086_;
                                        let _e1704 = phi_3961_;
                                        phi_3966_ = _e1704;
                                        if _e1704 {
                                            break;
                                        }
                                        phi_4051_ = _e1702;
                                        phi_3970_ = _e1704;
                                        phi_3440_ = false;
                                        phi_3441_ = _e680;
                                        phi_3442_ = _e682;
                                    } else {
                                        let _e691 = (_e682.member_1 < _e90);
                                        if _e691 {
                                            if _e691 {
                                            } else {
                                                phi_3966_ = true;
                                                break;
                                            }
                                            let _e693 = global_5.member[_e682.member_1];
                                            phi_2452_ = _e693;
                                        } else {
                                            phi_2452_ = type_44(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e695 = phi_2452_;
                                        let _e710 = ((10u * _e252) & 31u);
                                        let _e713 = ((_e695.member[0] >> bitcast<u32>(_e710)) & 1023u);
                                        let _e721 = bitcast<f32>((bitcast<u32>(((_e682.member.member_1[0] - _e682.member.member[0]) * 0.0009775171f)) ^ _e124));
                                        let _e726 = (_e682.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e713)) - 8388608f) * _e721)) ^ _e124)));
                                        let _e730 = select(select(_e682.member.member_1[0], _e726, (_e726 < _e682.member.member_1[0])), _e682.member.member_1[0], (_e713 == 1023u));
                                        let _e732 = ((10u * _e251) & 31u);
                                        let _e735 = ((_e695.member[0] >> bitcast<u32>(_e732)) & 1023u);
                                        let _e743 = bitcast<f32>((bitcast<u32>(((_e682.member.member_1[1] - _e682.member.member[1]) * 0.0009775171f)) ^ _e124));
                                        let _e748 = (_e682.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e735)) - 8388608f) * _e743)) ^ _e124)));
                                        let _e752 = select(select(_e682.member.member_1[1], _e748, (_e748 < _e682.member.member_1[1])), _e682.member.member_1[1], (_e735 == 1023u));
                                        let _e754 = ((10u * _e253) & 31u);
                                        let _e757 = ((_e695.member[0] >> bitcast<u32>(_e754)) & 1023u);
                                        let _e765 = bitcast<f32>((bitcast<u32>(((_e682.member.member_1[2] - _e682.member.member[2]) * 0.0009775171f)) ^ _e124));
                                        let _e770 = (_e682.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e757)) - 8388608f) * _e765)) ^ _e124)));
                                        let _e774 = select(select(_e682.member.member_1[2], _e770, (_e770 < _e682.member.member_1[2])), _e682.member.member_1[2], (_e757 == 1023u));
                                        let _e777 = ((_e695.member[1] >> bitcast<u32>(_e710)) & 1023u);
                                        let _e785 = (_e682.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e777)) - 8388608f) * _e721)) ^ _e124)));
                                        let _e789 = select(select(_e682.member.member_1[0], _e785, (_e785 < _e682.member.member_1[0])), _e682.member.member_1[0], (_e777 == 1023u));
                                        let _e792 = ((_e695.member[1] >> bitcast<u32>(_e732)) & 1023u);
                                        let _e800 = (_e682.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e792)) - 8388608f) * _e743)) ^ _e124)));
                                        let _e804 = select(select(_e682.member.member_1[1], _e800, (_e800 < _e682.member.member_1[1])), _e682.member.member_1[1], (_e792 == 1023u));
                                        let _e807 = ((_e695.member[1] >> bitcast<u32>(_e754)) & 1023u);
                                        let _e815 = (_e682.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e807)) - 8388608f) * _e765)) ^ _e124)));
                                        let _e819 = select(select(_e682.member.member_1[2], _e815, (_e815 < _e682.member.member_1[2])), _e682.member.member_1[2], (_e807 == 1023u));
                                        let _e825 = ((_e695.member_1[0] >> bitcast<u32>(_e710)) & 1023u);
                                        let _e833 = (_e682.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e825)) - 8388608f) * _e721)) ^ _e124)));
                                        let _e837 = select(select(_e682.member.member_1[0], _e833, (_e833 < _e682.member.member_1[0])), _e682.member.member_1[0], (_e825 == 1023u));
                                        let _e840 = ((_e695.member_1[0] >> bitcast<u32>(_e732)) & 1023u);
                                        let _e848 = (_e682.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e840)) - 8388608f) * _e743)) ^ _e124)));
                                        let _e852 = select(select(_e682.member.member_1[1], _e848, (_e848 < _e682.member.member_1[1])), _e682.member.member_1[1], (_e840 == 1023u));
                                        let _e855 = ((_e695.member_1[0] >> bitcast<u32>(_e754)) & 1023u);
                                        let _e863 = (_e682.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e855)) - 8388608f) * _e765)) ^ _e124)));
                                        let _e867 = select(select(_e682.member.member_1[2], _e863, (_e863 < _e682.member.member_1[2])), _e682.member.member_1[2], (_e855 == 1023u));
                                        let _e870 = ((_e695.member_1[1] >> bitcast<u32>(_e710)) & 1023u);
                                        let _e878 = (_e682.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e870)) - 8388608f) * _e721)) ^ _e124)));
                                        let _e882 = select(select(_e682.member.member_1[0], _e878, (_e878 < _e682.member.member_1[0])), _e682.member.member_1[0], (_e870 == 1023u));
                                        let _e885 = ((_e695.member_1[1] >> bitcast<u32>(_e732)) & 1023u);
                                        let _e893 = (_e682.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e885)) - 8388608f) * _e743)) ^ _e124)));
                                        let _e897 = select(select(_e682.member.member_1[1], _e893, (_e893 < _e682.member.member_1[1])), _e682.member.member_1[1], (_e885 == 1023u));
                                        let _e900 = ((_e695.member_1[1] >> bitcast<u32>(_e754)) & 1023u);
                                        let _e908 = (_e682.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e900)) - 8388608f) * _e765)) ^ _e124)));
                                        let _e912 = select(select(_e682.member.member_1[2], _e908, (_e908 < _e682.member.member_1[2])), _e682.member.member_1[2], (_e900 == 1023u));
                                        let _e917 = type_51(type_49(array<f32, 3>(_e730, _e752, _e774), array<f32, 3>(_e789, _e804, _e819)), _e695.member_2);
                                        let _e922 = type_51(type_49(array<f32, 3>(_e837, _e852, _e867), array<f32, 3>(_e882, _e897, _e912)), _e695.member_3);
                                        let _e927 = ((_e730 - _e354) * _e359);
                                        let _e928 = ((_e837 - _e354) * _e359);
                                        let _e929 = ((_e789 - _e355) * _e359);
                                        let _e930 = ((_e882 - _e355) * _e359);
                                        let _e935 = ((_e752 - _e422) * _e427);
                                        let _e936 = ((_e852 - _e422) * _e427);
                                        let _e937 = ((_e804 - _e423) * _e427);
                                        let _e938 = ((_e897 - _e423) * _e427);
                                        let _e943 = ((_e774 - _e490) * _e495);
                                        let _e944 = ((_e867 - _e490) * _e495);
                                        let _e945 = ((_e819 - _e491) * _e495);
                                        let _e946 = ((_e912 - _e491) * _e495);
                                        let _e948 = select(_e945, _e943, (_e943 < _e945));
                                        let _e950 = select(_e946, _e944, (_e944 < _e946));
                                        let _e952 = select(_e945, _e943, (_e943 > _e945));
                                        let _e954 = select(_e946, _e944, (_e944 > _e946));
                                        let _e956 = select(_e929, _e927, (_e927 < _e929));
                                        let _e958 = select(_e930, _e928, (_e928 < _e930));
                                        let _e960 = select(_e937, _e935, (_e935 < _e937));
                                        let _e962 = select(_e938, _e936, (_e936 < _e938));
                                        let _e964 = select(_e960, _e956, (_e956 > _e960));
                                        let _e966 = select(_e962, _e958, (_e958 > _e962));
                                        let _e968 = select(_e948, _e964, (_e964 > _e948));
                                        let _e970 = select(_e950, _e966, (_e966 > _e950));
                                        let _e972 = select(_e929, _e927, (_e927 > _e929));
                                        let _e974 = select(_e930, _e928, (_e928 > _e930));
                                        let _e976 = select(_e937, _e935, (_e935 > _e937));
                                        let _e978 = select(_e938, _e936, (_e936 > _e938));
                                        let _e980 = select(_e976, _e972, (_e972 < _e976));
                                        let _e982 = select(_e978, _e974, (_e974 < _e978));
                                        let _e987 = -(_e948);
                                        let _e988 = -(_e950);
                                        let _e995 = (select(_e952, _e980, (_e980 < _e952)) + (select(_e987, _e952, (_e952 > _e987)) * 0.0000019073523f));
                                        let _e996 = (select(_e954, _e982, (_e982 < _e954)) + (select(_e988, _e954, (_e954 > _e988)) * 0.0000019073523f));
                                        let _e998 = select(_e607, _e968, (_e968 > _e607));
                                        let _e1000 = select(_e607, _e970, (_e970 > _e607));
                                        let _e1005 = (_e998 <= select(_e640, _e995, (_e995 < _e640)));
                                        let _e1006 = (_e1000 <= select(_e640, _e996, (_e996 < _e640)));
                                        let _e1007 = (_e998 <= _e1000);
                                        if _e1005 {
                                            if _e1006 {
                                                if _e1007 {
                                                    phi_3339_ = _e922;
                                                } else {
                                                    phi_3339_ = _e917;
                                                }
                                                let _e1009 = phi_3339_;
                                                let _e1017 = (_e680 % 128u);
                                                let _e1018 = (_e1017 < 128u);
                                                if _e1018 {
                                                } else {
                                                    phi_3966_ = true;
                                                    break;
                                                }
                                                local_6[_e1017] = _e1009.member_1;
                                                if _e1018 {
                                                } else {
                                                    phi_3966_ = true;
                                                    break;
                                                }
                                                local_5[_e1017] = _e1009.member.member[0];
                                                if _e1018 {
                                                } else {
                                                    phi_3966_ = true;
                                                    break;
                                                }
                                                local_4[_e1017] = _e1009.member.member[1];
                                                if _e1018 {
                                                } else {
                                                    phi_3966_ = true;
                                                    break;
                                                }
                                                local_3[_e1017] = _e1009.member.member[2];
                                                if _e1018 {
                                                } else {
                                                    phi_3966_ = true;
                                                    break;
                                                }
                                                local_2[_e1017] = _e1009.member.member_1[0];
                                                if _e1018 {
                                                } else {
                                                    phi_3966_ = true;
                                                    break;
                                                }
                                                local_1[_e1017] = _e1009.member.member_1[1];
                                                if _e1018 {
                                                } else {
                                                    phi_3966_ = true;
                                                    break;
                                                }
                                                local[_e1017] = _e1009.member.member_1[2];
                                                if _e1018 {
                                                } else {
                                                    phi_3966_ = true;
                                                    break;
                                                }
                                                local_8[_e1017] = select(_e1000, _e998, !(_e1007));
                                                if _e1007 {
                                                    phi_3416_ = _e917;
                                                } else {
                                                    phi_3416_ = _e922;
                                                }
                                                let _e1035 = phi_3416_;
                                                phi_3417_ = (_e680 + 1u);
                                                phi_3418_ = _e1035;
                                            } else {
                                                phi_3417_ = u32();
                                                phi_3418_ = type_51();
                                            }
                                            let _e1037 = phi_3417_;
                                            let _e1039 = phi_3418_;
                                            phi_3420_ = _e1037;
                                            phi_3421_ = _e1039;
                                            phi_3422_ = select(true, false, _e1006);
                                        } else {
                                            phi_3420_ = u32();
                                            phi_3421_ = type_51();
                                            phi_3422_ = true;
                                        }
                                        let _e1042 = phi_3420_;
                                        let _e1044 = phi_3421_;
                                        let _e1046 = phi_3422_;
                                        if _e1046 {
                                            if _e1005 {
                                                phi_3429_ = _e917;
                                            } else {
                                                phi_3429_ = _e922;
                                            }
                                            let _e1048 = phi_3429_;
                                            phi_3434_ = select(_e1006, true, _e1005);
                                            phi_3436_ = _e1048;
                                        } else {
                                            phi_3434_ = _e678;
                                            phi_3436_ = _e1044;
                                        }
                                        let _e1051 = phi_3434_;
                                        let _e1053 = phi_3436_;
                                        phi_4051_ = _e640;
                                        phi_3970_ = _e638;
                                        phi_3440_ = _e1051;
                                        phi_3441_ = select(_e1042, _e680, _e1046);
                                        phi_3442_ = _e1053;
                                    }
                                    let _e1706 = phi_4051_;
                                    let _e1708 = phi_3970_;
                                    let _e1710 = phi_3440_;
                                    let _e1712 = phi_3441_;
                                    let _e1714 = phi_3442_;
                                    phi_4050_ = _e1706;
                                    phi_3969_ = _e1708;
                                    phi_3443_ = _e1710;
                                    phi_3444_ = (_e644 - 1u);
                                    phi_3445_ = _e1712;
                                    phi_3446_ = _e1714;
                                } else {
                                    phi_4050_ = _e640;
                                    phi_3969_ = _e638;
                                    phi_3443_ = _e678;
                                    phi_3444_ = _e644;
                                    phi_3445_ = _e680;
                                    phi_3446_ = _e682;
                                }
                                let _e1716 = phi_4050_;
                                let _e1718 = phi_3969_;
                                let _e1720 = phi_3443_;
                                let _e1722 = phi_3444_;
                                let _e1724 = phi_3445_;
                                let _e1726 = phi_3446_;
                                phi_4049_ = _e1716;
                                phi_3968_ = _e1718;
                                phi_3447_ = _e1720;
                                phi_3448_ = _e1722;
                                phi_3449_ = _e1724;
                                phi_3450_ = _e1726;
                            } else {
                                phi_4049_ = _e640;
                                phi_3968_ = _e638;
                                phi_3447_ = bool();
                                phi_3448_ = u32();
                                phi_3449_ = u32();
                                phi_3450_ = type_51();
                            }
                            let _e1728 = phi_4049_;
                            let _e1730 = phi_3968_;
                            let _e1732 = phi_3447_;
                            let _e1734 = phi_3448_;
                            let _e1736 = phi_3449_;
                            let _e1738 = phi_3450_;
                            phi_4048_ = _e1728;
                            phi_3967_ = _e1730;
                            phi_1162_ = _e1732;
                            phi_1165_ = _e1734;
                            phi_1167_ = _e1736;
                            phi_1169_ = _e1738;
                            phi_3451_ = _e652;
                        } else {
                            phi_4048_ = _e640;
                            phi_3967_ = _e638;
                            phi_1162_ = bool();
                            phi_1165_ = u32();
                            phi_1167_ = u32();
                            phi_1169_ = type_51();
                            phi_3451_ = false;
                        }
                        let _e1740 = phi_4048_;
                        let _e1742 = phi_3967_;
                        let _e1744 = phi_1162_;
                        let _e1746 = phi_1165_;
                        let _e1748 = phi_1167_;
                        let _e1750 = phi_1169_;
                        let _e1752 = phi_3451_;
                        continue;
                        continuing {
                            phi_3813_ = _e1742;
                            phi_3770_ = _e1740;
                            phi_1161_ = _e1744;
                            phi_1164_ = _e1746;
                            phi_1166_ = _e1748;
                            phi_1168_ = _e1750;
                            phi_3966_ = _e1742;
                            break if !(_e1752);
                        }
                    }
                    let _e1755 = phi_3966_;
                    if _e1755 {
                        break;
                    }
                    phi_3458_ = type_4(0u, 8u);
                    loop {
                        let _e1757 = phi_3458_;
                        if (_e1757.member < _e1757.member_1) {
                            phi_3459_ = type_4((_e1757.member + 1u), _e1757.member_1);
                            phi_3482_ = type_4(1u, _e1757.member);
                        } else {
                            phi_3459_ = _e1757;
                            phi_3482_ = type_4(0u, type_4().member_1);
                        }
                        let _e1770 = phi_3459_;
                        let _e1772 = phi_3482_;
                        let _e1776 = (bitcast<i32>(_e1772.member) != 0i);
                        if _e1776 {
                            let _e1777 = (_e1772.member_1 < 8u);
                            if _e1777 {
                            } else {
                                phi_4030_ = true;
                                break;
                            }
                            let _e1779 = local_7[_e1772.member_1];
                            if (_e1779.member_3 != 4294967295u) {
                                let _e1785 = -(_e509);
                                let _e1786 = bitcast<u32>(_e1779.member);
                                let _e1790 = (bitcast<i32>((_e1786 >> bitcast<u32>(23i))) & 255i);
                                let _e1791 = (_e1790 + _e1785);
                                if (_e1790 == 255i) {
                                    phi_3555_ = _e1779.member;
                                } else {
                                    if (_e1790 > 0i) {
                                        if (_e1791 > 0i) {
                                            let _e1795 = (_e1791 < 255i);
                                            if _e1795 {
                                                phi_3534_ = bitcast<f32>((_e1786 + bitcast<u32>((_e1785 << bitcast<u32>(23i)))));
                                            } else {
                                                phi_3534_ = f32();
                                            }
                                            let _e1802 = phi_3534_;
                                            phi_3536_ = _e1802;
                                            phi_3537_ = select(true, false, _e1795);
                                        } else {
                                            phi_3536_ = f32();
                                            phi_3537_ = true;
                                        }
                                        let _e1805 = phi_3536_;
                                        let _e1807 = phi_3537_;
                                        phi_3538_ = _e1805;
                                        phi_3539_ = _e1807;
                                    } else {
                                        phi_3538_ = f32();
                                        phi_3539_ = true;
                                    }
                                    let _e1809 = phi_3538_;
                                    let _e1811 = phi_3539_;
                                    if _e1811 {
                                        let _e1812 = (_e1786 & 2147483648u);
                                        let _e1819 = ((_e1786 & 8388607u) | (select(0u, 1u, ((_e1786 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                        let _e1823 = (_e1819 == 0u);
                                        if _e1823 {
                                            phi_3728_ = bitcast<f32>(_e1812);
                                        } else {
                                            let _e1828 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1819)), 32u, _e1823) - 8u);
                                            let _e1831 = (_e1819 << bitcast<u32>((_e1828 & 31u)));
                                            let _e1833 = ((_e1791 + select(0i, 1i, (_e1790 == 0i))) - bitcast<i32>(_e1828));
                                            if (_e1833 >= 255i) {
                                                phi_3718_ = bitcast<f32>((_e1812 | 2139095040u));
                                                phi_3719_ = f32();
                                                phi_3720_ = true;
                                            } else {
                                                let _e1835 = (_e1833 > 0i);
                                                if _e1835 {
                                                    phi_3712_ = bitcast<f32>(((_e1812 | (bitcast<u32>(_e1833) << bitcast<u32>(23i))) | (_e1831 & 8388607u)));
                                                    phi_3713_ = f32();
                                                } else {
                                                    if (_e1833 < -24i) {
                                                        phi_3678_ = 26u;
                                                    } else {
                                                        phi_3678_ = bitcast<u32>((1i - _e1833));
                                                    }
                                                    let _e1840 = phi_3678_;
                                                    let _e1841 = (_e1840 & 31u);
                                                    let _e1843 = (_e1831 >> bitcast<u32>(_e1841));
                                                    let _e1847 = (_e1831 & ((1u << bitcast<u32>(_e1841)) - 1u));
                                                    let _e1851 = (1u << bitcast<u32>(((_e1840 - 1u) & 31u)));
                                                    if (_e1847 > _e1851) {
                                                        phi_3699_ = true;
                                                    } else {
                                                        if (_e1847 == _e1851) {
                                                            phi_3696_ = ((_e1843 & 1u) == 1u);
                                                        } else {
                                                            phi_3696_ = false;
                                                        }
                                                        let _e1857 = phi_3696_;
                                                        phi_3699_ = _e1857;
                                                    }
                                                    let _e1859 = phi_3699_;
                                                    phi_3712_ = f32();
                                                    phi_3713_ = bitcast<f32>((_e1812 | (_e1843 + select(0u, 1u, _e1859))));
                                                }
                                                let _e1872 = phi_3712_;
                                                let _e1874 = phi_3713_;
                                                phi_3718_ = _e1872;
                                                phi_3719_ = _e1874;
                                                phi_3720_ = _e1835;
                                            }
                                            let _e1878 = phi_3718_;
                                            let _e1880 = phi_3719_;
                                            let _e1882 = phi_3720_;
                                            phi_3728_ = select(_e1880, _e1878, _e1882);
                                        }
                                        let _e1886 = phi_3728_;
                                        phi_3554_ = _e1886;
                                    } else {
                                        phi_3554_ = _e1809;
                                    }
                                    let _e1888 = phi_3554_;
                                    phi_3555_ = _e1888;
                                }
                                let _e1890 = phi_3555_;
                                let _e1891 = bitcast<u32>(_e1890);
                                if ((_e1891 & 2147483647u) >= 2139095040u) {
                                    phi_3567_ = bitcast<f32>(((_e1891 & 2147483648u) | 2139095039u));
                                } else {
                                    phi_3567_ = _e1890;
                                }
                                let _e1898 = phi_3567_;
                                phi_3572_ = type_22(_e1898, _e1779.member_1, _e1779.member_2, _e1779.member_3);
                            } else {
                                phi_3572_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1901 = phi_3572_;
                            if _e1777 {
                            } else {
                                phi_4030_ = true;
                                break;
                            }
                            local_7[_e1772.member_1] = type_22(_e1901.member, _e1901.member_1, _e1901.member_2, _e1901.member_3);
                        }
                        continue;
                        continuing {
                            phi_3458_ = _e1770;
                            phi_4030_ = _e1755;
                            break if !(_e1776);
                        }
                    }
                    let _e1909 = phi_4030_;
                    if _e1909 {
                        break;
                    }
                    let _e1910 = local_7;
                    if _e140 {
                    } else {
                        break;
                    }
                    global_6.member[_e138] = array<type_22, 8>(type_22(_e1910[0].member, _e1910[0].member_1, _e1910[0].member_2, _e1910[0].member_3), type_22(_e1910[1].member, _e1910[1].member_1, _e1910[1].member_2, _e1910[1].member_3), type_22(_e1910[2].member, _e1910[2].member_1, _e1910[2].member_2, _e1910[2].member_3), type_22(_e1910[3].member, _e1910[3].member_1, _e1910[3].member_2, _e1910[3].member_3), type_22(_e1910[4].member, _e1910[4].member_1, _e1910[4].member_2, _e1910[4].member_3), type_22(_e1910[5].member, _e1910[5].member_1, _e1910[5].member_2, _e1910[5].member_3), type_22(_e1910[6].member, _e1910[6].member_1, _e1910[6].member_2, _e1910[6].member_3), type_22(_e1910[7].member, _e1910[7].member_1, _e1910[7].member_2, _e1910[7].member_3));
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
