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

struct type_23 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_25 {
    member: array<type_23>,
}

struct type_27 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_31 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_33 {
    member: array<type_31>,
}

struct type_40 {
    member: type_23,
    member_1: f32,
}

struct type_44 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_45 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_47 {
    member: array<type_27>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(1) 
var<storage> global_2: type_33;
@group(0) @binding(2) 
var<storage> global_3: type_15;
@group(0) @binding(3) 
var<storage> global_4: type_47;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_25;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_384_: i32;
    var phi_385_: i32;
    var phi_395_: bool;
    var phi_405_: u32;
    var phi_406_: u32;
    var phi_408_: bool;
    var phi_413_: u32;
    var phi_426_: i32;
    var phi_446_: i32;
    var phi_464_: f32;
    var phi_470_: f32;
    var phi_510_: f32;
    var phi_516_: f32;
    var phi_589_: f32;
    var phi_595_: f32;
    var phi_635_: f32;
    var phi_641_: f32;
    var phi_714_: f32;
    var phi_720_: f32;
    var phi_760_: f32;
    var phi_766_: f32;
    var phi_885_: i32;
    var phi_907_: u32;
    var phi_908_: u32;
    var phi_945_: i32;
    var phi_967_: u32;
    var phi_968_: u32;
    var phi_976_: f32;
    var phi_977_: f32;
    var phi_2891_: bool;
    var phi_992_: type_40;
    var phi_995_: u32;
    var phi_997_: bool;
    var phi_999_: u32;
    var phi_1001_: u32;
    var phi_1012_: bool;
    var phi_1044_: bool;
    var phi_1045_: u32;
    var phi_1046_: u32;
    var phi_1061_: type_40;
    var phi_1064_: type_4;
    var phi_1065_: type_4;
    var phi_1087_: type_4;
    var phi_1108_: u32;
    var phi_1200_: array<array<f32, 3>, 3>;
    var phi_2637_: bool;
    var phi_2652_: bool;
    var phi_2667_: bool;
    var phi_2682_: bool;
    var phi_2697_: bool;
    var phi_2712_: bool;
    var phi_1742_: f32;
    var phi_1743_: f32;
    var phi_1744_: f32;
    var phi_1745_: f32;
    var phi_1746_: vec3<f32>;
    var phi_1747_: vec3<f32>;
    var phi_1748_: vec3<f32>;
    var phi_1749_: vec3<f32>;
    var phi_2727_: bool;
    var phi_2742_: bool;
    var phi_2757_: bool;
    var phi_2772_: bool;
    var phi_2787_: bool;
    var phi_2802_: bool;
    var phi_1957_: f32;
    var phi_1977_: type_44;
    var phi_1978_: type_44;
    var phi_1981_: type_44;
    var phi_1982_: type_44;
    var phi_1983_: bool;
    var phi_1987_: type_44;
    var phi_1996_: type_23;
    var phi_2021_: bool;
    var phi_2022_: bool;
    var phi_2028_: type_40;
    var phi_2029_: type_40;
    var phi_2030_: type_40;
    var phi_1062_: type_40;
    var phi_2885_: bool;
    var phi_3085_: bool;
    var phi_2031_: type_40;
    var phi_2096_: type_45;
    var phi_2458_: u32;
    var phi_2485_: u32;
    var phi_2486_: u32;
    var phi_2487_: u32;
    var phi_2489_: u32;
    var phi_2490_: u32;
    var phi_2491_: bool;
    var phi_2500_: u32;
    var phi_2505_: bool;
    var phi_2507_: u32;
    var phi_2511_: bool;
    var phi_2512_: u32;
    var phi_2513_: u32;
    var phi_3053_: bool;
    var phi_2524_: type_40;
    var phi_2525_: u32;
    var phi_2526_: bool;
    var phi_2527_: u32;
    var phi_2528_: u32;
    var phi_3052_: bool;
    var phi_2529_: type_40;
    var phi_2530_: u32;
    var phi_2531_: bool;
    var phi_2532_: u32;
    var phi_2533_: u32;
    var phi_3051_: bool;
    var phi_993_: type_40;
    var phi_996_: u32;
    var phi_998_: bool;
    var phi_1000_: u32;
    var phi_1002_: u32;
    var phi_2534_: bool;
    var phi_3050_: bool;
    var local_2: type_40;
    var phi_2572_: f32;
    var phi_2574_: f32;
    var phi_2575_: bool;
    var phi_2576_: f32;
    var phi_2577_: bool;
    var phi_2830_: u32;
    var phi_2848_: bool;
    var phi_2851_: bool;
    var phi_2864_: f32;
    var phi_2865_: f32;
    var phi_2870_: f32;
    var phi_2871_: f32;
    var phi_2872_: bool;
    var phi_2880_: f32;
    var phi_2592_: f32;
    var phi_2593_: f32;
    var phi_2605_: f32;
    var phi_2610_: type_23;
    var local_3: type_40;

    switch bitcast<i32>(0u) {
        default: {
            let _e73 = global;
            let _e75 = arrayLength((&global_2.member));
            let _e77 = arrayLength((&global_3.member));
            let _e85 = (_e73.x + (_e73.y * 2097152u));
            let _e88 = global_1.member[0u];
            let _e89 = bitcast<i32>(_e88);
            let _e90 = (_e85 < arrayLength((&global_4.member)));
            if _e90 {
                let _e91 = (_e85 < arrayLength((&global_5.member)));
                if _e91 {
                    if _e90 {
                    } else {
                        break;
                    }
                    let _e99 = global_4.member[_e85].member_2[0u];
                    let _e101 = (bitcast<u32>(_e99) & 2147483647u);
                    let _e106 = global_4.member[_e85].member_2[1u];
                    let _e108 = (bitcast<u32>(_e106) & 2147483647u);
                    let _e113 = global_4.member[_e85].member_2[2u];
                    let _e115 = (bitcast<u32>(_e113) & 2147483647u);
                    let _e120 = global_4.member[_e85].member[0u];
                    let _e122 = (bitcast<u32>(_e120) & 2147483647u);
                    let _e127 = global_4.member[_e85].member[1u];
                    let _e129 = (bitcast<u32>(_e127) & 2147483647u);
                    let _e134 = global_4.member[_e85].member[2u];
                    let _e136 = (bitcast<u32>(_e134) & 2147483647u);
                    let _e138 = select(_e108, _e101, (_e108 < _e101));
                    let _e140 = select(_e115, _e138, (_e115 < _e138));
                    let _e142 = select(_e122, _e140, (_e122 < _e140));
                    let _e144 = select(_e129, _e142, (_e129 < _e142));
                    let _e146 = select(_e136, _e144, (_e136 < _e144));
                    let _e150 = global_4.member[_e85].member_1;
                    let _e151 = bitcast<u32>(_e150);
                    let _e152 = (_e151 & 2147483647u);
                    let _e159 = global_4.member[_e85].member_3;
                    let _e160 = bitcast<u32>(_e159);
                    let _e161 = (_e160 & 2147483647u);
                    let _e165 = (((select(_e152, _e146, (_e152 < _e146)) < 2139095040u) && (_e161 <= 2139095040u)) && (_e140 > 0u));
                    if _e165 {
                        let _e168 = (bitcast<u32>(bitcast<f32>(_e140)) & 2147483647u);
                        if (_e168 >= 8388608u) {
                            phi_384_ = (bitcast<i32>((_e168 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_384_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e168)), 32u, (_e168 == 0u))));
                        }
                        let _e182 = phi_384_;
                        phi_385_ = _e182;
                    } else {
                        phi_385_ = 0i;
                    }
                    let _e184 = phi_385_;
                    let _e185 = (_e101 == _e140);
                    if _e185 {
                        phi_395_ = true;
                    } else {
                        phi_395_ = (_e108 == _e140);
                    }
                    let _e188 = phi_395_;
                    let _e189 = select(1u, 0u, _e185);
                    if _e188 {
                        let _e190 = (_e189 + 1u);
                        phi_405_ = _e190;
                        phi_406_ = _e190;
                        phi_408_ = select(true, false, (_e190 == 2u));
                    } else {
                        phi_405_ = u32();
                        phi_406_ = 0u;
                        phi_408_ = true;
                    }
                    let _e194 = phi_405_;
                    let _e196 = phi_406_;
                    let _e198 = phi_408_;
                    if _e198 {
                        phi_413_ = (_e196 + 1u);
                    } else {
                        phi_413_ = 0u;
                    }
                    let _e202 = phi_413_;
                    let _e203 = select(_e194, _e196, _e198);
                    let _e204 = select(_e189, select(2u, _e189, _e188), _e198);
                    if (_e89 < -126i) {
                        phi_426_ = -126i;
                    } else {
                        phi_426_ = select(_e89, 127i, (_e89 > 127i));
                    }
                    let _e209 = phi_426_;
                    let _e214 = bitcast<f32>((bitcast<u32>((_e209 + 127i)) << bitcast<u32>(23i)));
                    let _e220 = bitcast<f32>((bitcast<u32>(((_e89 - _e209) + 127i)) << bitcast<u32>(23i)));
                    let _e221 = -(_e184);
                    if (_e221 < -126i) {
                        phi_446_ = -126i;
                    } else {
                        phi_446_ = select(_e221, 127i, (_e221 > 127i));
                    }
                    let _e226 = phi_446_;
                    let _e231 = bitcast<f32>((bitcast<u32>((_e226 + 127i)) << bitcast<u32>(23i)));
                    let _e237 = bitcast<f32>((bitcast<u32>(((_e221 - _e226) + 127i)) << bitcast<u32>(23i)));
                    let _e241 = global_4.member[_e85].member;
                    let _e242 = (_e203 == 0u);
                    if _e242 {
                        phi_464_ = _e241[0];
                    } else {
                        phi_464_ = _e241[1];
                    }
                    let _e246 = phi_464_;
                    let _e247 = (_e203 == 2u);
                    if _e247 {
                        phi_470_ = _e241[2];
                    } else {
                        phi_470_ = _e246;
                    }
                    let _e250 = phi_470_;
                    let _e251 = bitcast<u32>(_e250);
                    let _e253 = ((_e251 & 2139095040u) != 0u);
                    let _e267 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e251 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e251 & 2147483648u))), _e250, _e253) * _e214) * select(0.00000011920929f, 1f, _e253)) * _e220);
                    let _e268 = global_4.member[_e85].member_2;
                    if _e242 {
                        phi_510_ = _e268[0];
                    } else {
                        phi_510_ = _e268[1];
                    }
                    let _e272 = phi_510_;
                    if _e247 {
                        phi_516_ = _e268[2];
                    } else {
                        phi_516_ = _e272;
                    }
                    let _e275 = phi_516_;
                    let _e276 = bitcast<u32>(_e275);
                    let _e278 = ((_e276 & 2139095040u) != 0u);
                    let _e292 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e276 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e276 & 2147483648u))), _e275, _e278) * _e231) * select(0.00000011920929f, 1f, _e278)) * _e237);
                    let _e296 = (bitcast<f32>((bitcast<u32>(_e292) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e299 = bitcast<f32>((bitcast<u32>(_e267) & 2147483647u));
                    let _e300 = (_e299 * 0.00000011920929f);
                    let _e303 = select(select(0.00000000000011368684f, _e300, (_e300 > 0.00000000000011368684f)), 0f, _e296);
                    let _e304 = select(0f, _e292, _e296);
                    let _e305 = (_e267 + _e303);
                    let _e306 = (_e267 - _e303);
                    let _e308 = select(38685626000000000000000000f, (1f / _e292), _e296);
                    let _e309 = (_e202 == 0u);
                    if _e309 {
                        phi_589_ = _e241[0];
                    } else {
                        phi_589_ = _e241[1];
                    }
                    let _e313 = phi_589_;
                    let _e314 = (_e202 == 2u);
                    if _e314 {
                        phi_595_ = _e241[2];
                    } else {
                        phi_595_ = _e313;
                    }
                    let _e317 = phi_595_;
                    let _e318 = bitcast<u32>(_e317);
                    let _e320 = ((_e318 & 2139095040u) != 0u);
                    let _e334 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e318 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e318 & 2147483648u))), _e317, _e320) * _e214) * select(0.00000011920929f, 1f, _e320)) * _e220);
                    if _e309 {
                        phi_635_ = _e268[0];
                    } else {
                        phi_635_ = _e268[1];
                    }
                    let _e338 = phi_635_;
                    if _e314 {
                        phi_641_ = _e268[2];
                    } else {
                        phi_641_ = _e338;
                    }
                    let _e341 = phi_641_;
                    let _e342 = bitcast<u32>(_e341);
                    let _e344 = ((_e342 & 2139095040u) != 0u);
                    let _e358 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e342 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e342 & 2147483648u))), _e341, _e344) * _e231) * select(0.00000011920929f, 1f, _e344)) * _e237);
                    let _e362 = (bitcast<f32>((bitcast<u32>(_e358) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e365 = bitcast<f32>((bitcast<u32>(_e334) & 2147483647u));
                    let _e366 = (_e365 * 0.00000011920929f);
                    let _e369 = select(select(0.00000000000011368684f, _e366, (_e366 > 0.00000000000011368684f)), 0f, _e362);
                    let _e370 = select(0f, _e358, _e362);
                    let _e371 = (_e334 + _e369);
                    let _e372 = (_e334 - _e369);
                    let _e374 = select(38685626000000000000000000f, (1f / _e358), _e362);
                    let _e375 = (_e204 == 0u);
                    if _e375 {
                        phi_714_ = _e241[0];
                    } else {
                        phi_714_ = _e241[1];
                    }
                    let _e379 = phi_714_;
                    let _e380 = (_e204 == 2u);
                    if _e380 {
                        phi_720_ = _e241[2];
                    } else {
                        phi_720_ = _e379;
                    }
                    let _e383 = phi_720_;
                    let _e384 = bitcast<u32>(_e383);
                    let _e386 = ((_e384 & 2139095040u) != 0u);
                    let _e400 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e384 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e384 & 2147483648u))), _e383, _e386) * _e214) * select(0.00000011920929f, 1f, _e386)) * _e220);
                    if _e375 {
                        phi_760_ = _e268[0];
                    } else {
                        phi_760_ = _e268[1];
                    }
                    let _e404 = phi_760_;
                    if _e380 {
                        phi_766_ = _e268[2];
                    } else {
                        phi_766_ = _e404;
                    }
                    let _e407 = phi_766_;
                    let _e408 = bitcast<u32>(_e407);
                    let _e410 = ((_e408 & 2139095040u) != 0u);
                    let _e424 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e408 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e408 & 2147483648u))), _e407, _e410) * _e231) * select(0.00000011920929f, 1f, _e410)) * _e237);
                    let _e428 = (bitcast<f32>((bitcast<u32>(_e424) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e431 = bitcast<f32>((bitcast<u32>(_e400) & 2147483647u));
                    let _e432 = (_e431 * 0.00000011920929f);
                    let _e435 = select(select(0.00000000000011368684f, _e432, (_e432 > 0.00000000000011368684f)), 0f, _e428);
                    let _e436 = select(0f, _e424, _e428);
                    let _e437 = (_e400 + _e435);
                    let _e438 = (_e400 - _e435);
                    let _e440 = select(38685626000000000000000000f, (1f / _e424), _e428);
                    let _e442 = select(_e365, _e299, (_e299 > _e365));
                    let _e445 = (_e89 + _e184);
                    if (_e165 && (select(_e431, _e442, (_e442 > _e431)) <= 1099511600000f)) {
                        let _e455 = ((_e152 & 8388607u) | (select(0u, 1u, ((_e152 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e458 = bitcast<i32>((_e152 >> bitcast<u32>(23i)));
                        let _e462 = (_e455 == 0u);
                        let _e465 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e455)), 32u, _e462)) - 8i);
                        if (_e458 == 255i) {
                            phi_885_ = 255i;
                        } else {
                            phi_885_ = (((_e458 + select(0i, 1i, (_e458 == 0i))) - _e465) + _e445);
                        }
                        let _e473 = phi_885_;
                        let _e483 = (_e473 <= 0i);
                        if _e483 {
                            phi_908_ = u32();
                        } else {
                            if _e462 {
                                phi_907_ = u32();
                            } else {
                                phi_907_ = select(((bitcast<u32>(_e473) << bitcast<u32>(23i)) | ((_e455 << bitcast<u32>(((_e465 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e473 >= 255i));
                            }
                            let _e487 = phi_907_;
                            phi_908_ = _e487;
                        }
                        let _e489 = phi_908_;
                        let _e501 = ((_e161 & 8388607u) | (select(0u, 1u, ((_e161 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e504 = bitcast<i32>((_e161 >> bitcast<u32>(23i)));
                        let _e508 = (_e501 == 0u);
                        let _e511 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e501)), 32u, _e508)) - 8i);
                        if (_e504 == 255i) {
                            phi_945_ = 255i;
                        } else {
                            phi_945_ = (((_e504 + select(0i, 1i, (_e504 == 0i))) - _e511) + _e445);
                        }
                        let _e519 = phi_945_;
                        let _e529 = (_e519 <= 0i);
                        if _e529 {
                            phi_968_ = u32();
                        } else {
                            if _e508 {
                                phi_967_ = u32();
                            } else {
                                phi_967_ = select(((bitcast<u32>(_e519) << bitcast<u32>(23i)) | ((_e501 << bitcast<u32>(((_e511 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e519 >= 255i));
                            }
                            let _e533 = phi_967_;
                            phi_968_ = _e533;
                        }
                        let _e535 = phi_968_;
                        phi_976_ = bitcast<f32>(((_e160 & 2147483648u) | select(_e535, 0u, select(_e508, true, _e529))));
                        phi_977_ = bitcast<f32>(((_e151 & 2147483648u) | select(_e489, 0u, select(_e462, true, _e483))));
                    } else {
                        phi_976_ = 0f;
                        phi_977_ = 1f;
                    }
                    let _e541 = phi_976_;
                    let _e543 = phi_977_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2891_ = false;
                    phi_992_ = type_40(type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e541);
                    phi_995_ = ((3u * _e75) + 1u);
                    phi_997_ = (_e543 <= _e541);
                    phi_999_ = 0u;
                    phi_1001_ = select(0u, 2147483648u, (_e75 == 0u));
                    loop {
                        let _e551 = phi_2891_;
                        let _e553 = phi_992_;
                        let _e555 = phi_995_;
                        let _e557 = phi_997_;
                        let _e559 = phi_999_;
                        let _e561 = phi_1001_;
                        local_2 = _e553;
                        if _e557 {
                            phi_1012_ = true;
                        } else {
                            phi_1012_ = (_e559 > 0u);
                        }
                        let _e564 = phi_1012_;
                        if _e564 {
                            let _e565 = (_e555 > 0u);
                            if _e565 {
                                if _e557 {
                                    phi_1044_ = _e557;
                                    phi_1045_ = _e559;
                                    phi_1046_ = _e561;
                                } else {
                                    let _e566 = (_e559 - 1u);
                                    let _e567 = (_e566 % 128u);
                                    let _e568 = (_e567 < 128u);
                                    if _e568 {
                                    } else {
                                        phi_3050_ = true;
                                        break;
                                    }
                                    let _e570 = local_1[_e567];
                                    if _e568 {
                                    } else {
                                        phi_3050_ = true;
                                        break;
                                    }
                                    let _e572 = local[_e567];
                                    phi_1044_ = (_e572 <= _e553.member_1);
                                    phi_1045_ = _e566;
                                    phi_1046_ = _e570;
                                }
                                let _e576 = phi_1044_;
                                let _e578 = phi_1045_;
                                let _e580 = phi_1046_;
                                if _e576 {
                                    let _e583 = ((_e580 & 2147483648u) != 0u);
                                    if _e583 {
                                        phi_1061_ = _e553;
                                        phi_1064_ = type_4(0u, ((_e580 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e590 = phi_1061_;
                                            let _e592 = phi_1064_;
                                            local_3 = _e590;
                                            if (_e592.member < _e592.member_1) {
                                                phi_1065_ = type_4((_e592.member + 1u), _e592.member_1);
                                                phi_1087_ = type_4(1u, _e592.member);
                                            } else {
                                                phi_1065_ = _e592;
                                                phi_1087_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e605 = phi_1065_;
                                            let _e607 = phi_1087_;
                                            let _e611 = (bitcast<i32>(_e607.member) != 0i);
                                            if _e611 {
                                                let _e612 = ((_e580 & 268435455u) + _e607.member_1);
                                                let _e613 = (_e612 < _e77);
                                                if _e613 {
                                                    if _e613 {
                                                    } else {
                                                        phi_2885_ = true;
                                                        break;
                                                    }
                                                    let _e617 = global_3.member[_e612].member_1;
                                                    phi_1108_ = _e617;
                                                } else {
                                                    phi_1108_ = 4294967295u;
                                                }
                                                let _e619 = phi_1108_;
                                                if (_e612 >= _e77) {
                                                    phi_1200_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e613 {
                                                    } else {
                                                        phi_2885_ = true;
                                                        break;
                                                    }
                                                    let _e621 = (_e203 % 3u);
                                                    let _e622 = (_e202 % 3u);
                                                    let _e623 = (_e204 % 3u);
                                                    if (_e621 < 9u) {
                                                    } else {
                                                        phi_2885_ = true;
                                                        break;
                                                    }
                                                    let _e629 = global_3.member[_e612].member[_e621];
                                                    if (_e622 < 9u) {
                                                    } else {
                                                        phi_2885_ = true;
                                                        break;
                                                    }
                                                    let _e635 = global_3.member[_e612].member[_e622];
                                                    if (_e623 < 9u) {
                                                    } else {
                                                        phi_2885_ = true;
                                                        break;
                                                    }
                                                    let _e641 = global_3.member[_e612].member[_e623];
                                                    let _e643 = (3u + _e621);
                                                    if (_e643 < 9u) {
                                                    } else {
                                                        phi_2885_ = true;
                                                        break;
                                                    }
                                                    let _e649 = global_3.member[_e612].member[_e643];
                                                    let _e650 = (3u + _e622);
                                                    if (_e650 < 9u) {
                                                    } else {
                                                        phi_2885_ = true;
                                                        break;
                                                    }
                                                    let _e656 = global_3.member[_e612].member[_e650];
                                                    let _e657 = (3u + _e623);
                                                    if (_e657 < 9u) {
                                                    } else {
                                                        phi_2885_ = true;
                                                        break;
                                                    }
                                                    let _e663 = global_3.member[_e612].member[_e657];
                                                    let _e665 = (6u + _e621);
                                                    if (_e665 < 9u) {
                                                    } else {
                                                        phi_2885_ = true;
                                                        break;
                                                    }
                                                    let _e671 = global_3.member[_e612].member[_e665];
                                                    let _e672 = (6u + _e622);
                                                    if (_e672 < 9u) {
                                                    } else {
                                                        phi_2885_ = true;
                                                        break;
                                                    }
                                                    let _e678 = global_3.member[_e612].member[_e672];
                                                    let _e679 = (6u + _e623);
                                                    if (_e679 < 9u) {
                                                    } else {
                                                        phi_2885_ = true;
                                                        break;
                                                    }
                                                    let _e685 = global_3.member[_e612].member[_e679];
                                                    phi_1200_ = array<array<f32, 3>, 3>(array<f32, 3>(_e629, _e635, _e641), array<f32, 3>(_e649, _e656, _e663), array<f32, 3>(_e671, _e678, _e685));
                                                }
                                                let _e689 = phi_1200_;
                                                let _e705 = (_e689[0][2] - _e400);
                                                let _e708 = (((_e689[0][0] - _e267) * _e436) - (_e705 * _e304));
                                                let _e711 = (((_e689[0][1] - _e334) * _e436) - (_e705 * _e370));
                                                let _e714 = (_e689[1][2] - _e400);
                                                let _e717 = (((_e689[1][0] - _e267) * _e436) - (_e714 * _e304));
                                                let _e720 = (((_e689[1][1] - _e334) * _e436) - (_e714 * _e370));
                                                let _e723 = (_e689[2][2] - _e400);
                                                let _e726 = (((_e689[2][0] - _e267) * _e436) - (_e723 * _e304));
                                                let _e729 = (((_e689[2][1] - _e334) * _e436) - (_e723 * _e370));
                                                let _e730 = (_e726 * _e720);
                                                let _e731 = (_e729 * _e717);
                                                let _e732 = (_e708 * _e729);
                                                let _e733 = (_e711 * _e726);
                                                let _e734 = (_e717 * _e711);
                                                let _e735 = (_e720 * _e708);
                                                let _e740 = (((_e730 >= _e731) && (_e732 >= _e733)) && (_e734 >= _e735));
                                                let _e746 = (_e740 || (((_e730 <= _e731) && (_e732 <= _e733)) && (_e734 <= _e735)));
                                                if _e746 {
                                                    let _e748 = select(-1f, 1f, _e740);
                                                    let _e750 = ((_e730 - _e731) * _e748);
                                                    let _e752 = select(0f, _e750, (_e750 > 0f));
                                                    let _e754 = ((_e732 - _e733) * _e748);
                                                    let _e756 = select(0f, _e754, (_e754 > 0f));
                                                    let _e758 = ((_e734 - _e735) * _e748);
                                                    let _e760 = select(0f, _e758, (_e758 > 0f));
                                                    let _e762 = ((_e752 + _e756) + _e760);
                                                    let _e764 = select(_e689[1][0], _e689[0][0], (_e689[0][0] < _e689[1][0]));
                                                    let _e768 = select(_e689[1][0], _e689[0][0], (_e689[0][0] > _e689[1][0]));
                                                    let _e772 = select(_e689[1][1], _e689[0][1], (_e689[0][1] < _e689[1][1]));
                                                    let _e776 = select(_e689[1][1], _e689[0][1], (_e689[0][1] > _e689[1][1]));
                                                    let _e780 = select(_e689[1][2], _e689[0][2], (_e689[0][2] < _e689[1][2]));
                                                    let _e784 = select(_e689[1][2], _e689[0][2], (_e689[0][2] > _e689[1][2]));
                                                    let _e789 = ((select(_e689[2][0], _e764, (_e764 < _e689[2][0])) - _e305) * _e308);
                                                    let _e790 = ((select(_e689[2][0], _e768, (_e768 > _e689[2][0])) - _e306) * _e308);
                                                    let _e793 = ((select(_e689[2][1], _e772, (_e772 < _e689[2][1])) - _e371) * _e374);
                                                    let _e794 = ((select(_e689[2][1], _e776, (_e776 > _e689[2][1])) - _e372) * _e374);
                                                    let _e797 = ((select(_e689[2][2], _e780, (_e780 < _e689[2][2])) - _e437) * _e440);
                                                    let _e798 = ((select(_e689[2][2], _e784, (_e784 > _e689[2][2])) - _e438) * _e440);
                                                    let _e800 = select(_e798, _e797, (_e797 < _e798));
                                                    let _e802 = select(_e798, _e797, (_e797 > _e798));
                                                    let _e804 = select(_e790, _e789, (_e789 < _e790));
                                                    let _e806 = select(_e794, _e793, (_e793 < _e794));
                                                    let _e808 = select(_e806, _e804, (_e804 > _e806));
                                                    let _e810 = select(_e800, _e808, (_e808 > _e800));
                                                    let _e812 = select(_e790, _e789, (_e789 > _e790));
                                                    let _e814 = select(_e794, _e793, (_e793 > _e794));
                                                    let _e816 = select(_e814, _e812, (_e812 < _e814));
                                                    let _e818 = select(_e802, _e816, (_e816 < _e802));
                                                    let _e819 = -(_e800);
                                                    let _e825 = select(_e543, _e810, (_e810 > _e543));
                                                    let _e829 = select(_e717, _e708, (_e708 < _e717));
                                                    let _e834 = select(_e717, _e708, (_e708 > _e717));
                                                    let _e841 = select(_e720, _e711, (_e711 < _e720));
                                                    let _e846 = select(_e720, _e711, (_e711 > _e720));
                                                    let _e855 = (((((_e746 && (_e762 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e726, _e829, (_e829 < _e726)) <= 0f) && (select(_e726, _e834, (_e834 > _e726)) >= 0f))) && ((select(_e729, _e841, (_e841 < _e729)) <= 0f) && (select(_e729, _e846, (_e846 > _e729)) >= 0f))) && (_e825 <= (_e818 + (select(_e819, _e802, (_e802 > _e819)) * 0.0000019073523f)))) && (_e825 <= _e590.member_1));
                                                    if _e855 {
                                                        let _e860 = (_e689[1][0] - _e689[0][0]);
                                                        let _e861 = (_e689[1][1] - _e689[0][1]);
                                                        let _e862 = (_e689[1][2] - _e689[0][2]);
                                                        let _e863 = vec3<f32>(_e860, _e861, _e862);
                                                        let _e864 = (_e689[2][0] - _e689[1][0]);
                                                        let _e865 = (_e689[2][1] - _e689[1][1]);
                                                        let _e866 = (_e689[2][2] - _e689[1][2]);
                                                        let _e867 = vec3<f32>(_e864, _e865, _e866);
                                                        let _e868 = (_e689[0][0] - _e689[2][0]);
                                                        let _e869 = (_e689[0][1] - _e689[2][1]);
                                                        let _e870 = (_e689[0][2] - _e689[2][2]);
                                                        let _e871 = vec3<f32>(_e868, _e869, _e870);
                                                        let _e872 = abs(_e860);
                                                        let _e873 = abs(_e861);
                                                        if (_e872 != _e872) {
                                                            phi_2637_ = true;
                                                        } else {
                                                            phi_2637_ = (_e873 >= _e872);
                                                        }
                                                        let _e877 = phi_2637_;
                                                        let _e878 = select(_e872, _e873, _e877);
                                                        let _e879 = abs(_e862);
                                                        if (_e878 != _e878) {
                                                            phi_2652_ = true;
                                                        } else {
                                                            phi_2652_ = (_e879 >= _e878);
                                                        }
                                                        let _e883 = phi_2652_;
                                                        let _e884 = select(_e878, _e879, _e883);
                                                        let _e885 = abs(_e864);
                                                        let _e886 = abs(_e865);
                                                        if (_e885 != _e885) {
                                                            phi_2667_ = true;
                                                        } else {
                                                            phi_2667_ = (_e886 >= _e885);
                                                        }
                                                        let _e890 = phi_2667_;
                                                        let _e891 = select(_e885, _e886, _e890);
                                                        let _e892 = abs(_e866);
                                                        if (_e891 != _e891) {
                                                            phi_2682_ = true;
                                                        } else {
                                                            phi_2682_ = (_e892 >= _e891);
                                                        }
                                                        let _e896 = phi_2682_;
                                                        let _e897 = select(_e891, _e892, _e896);
                                                        let _e898 = abs(_e868);
                                                        let _e899 = abs(_e869);
                                                        if (_e898 != _e898) {
                                                            phi_2697_ = true;
                                                        } else {
                                                            phi_2697_ = (_e899 >= _e898);
                                                        }
                                                        let _e903 = phi_2697_;
                                                        let _e904 = select(_e898, _e899, _e903);
                                                        let _e905 = abs(_e870);
                                                        if (_e904 != _e904) {
                                                            phi_2712_ = true;
                                                        } else {
                                                            phi_2712_ = (_e905 >= _e904);
                                                        }
                                                        let _e909 = phi_2712_;
                                                        let _e910 = select(_e904, _e905, _e909);
                                                        let _e912 = select(_e897, _e884, (_e884 > _e897));
                                                        let _e914 = select(_e910, _e912, (_e912 > _e910));
                                                        if (_e884 == _e914) {
                                                            phi_1742_ = _e720;
                                                            phi_1743_ = _e717;
                                                            phi_1744_ = _e711;
                                                            phi_1745_ = _e708;
                                                            phi_1746_ = vec3<f32>(_e689[0][0], _e689[0][1], _e689[0][2]);
                                                            phi_1747_ = _e871;
                                                            phi_1748_ = _e867;
                                                            phi_1749_ = _e863;
                                                        } else {
                                                            let _e916 = (_e897 == _e914);
                                                            let _e921 = vec3(_e916);
                                                            phi_1742_ = select(_e711, _e729, _e916);
                                                            phi_1743_ = select(_e708, _e726, _e916);
                                                            phi_1744_ = select(_e729, _e720, _e916);
                                                            phi_1745_ = select(_e726, _e717, _e916);
                                                            phi_1746_ = select(vec3<f32>(_e689[2][0], _e689[2][1], _e689[2][2]), vec3<f32>(_e689[1][0], _e689[1][1], _e689[1][2]), _e921);
                                                            phi_1747_ = select(_e867, _e863, _e921);
                                                            phi_1748_ = select(_e863, _e871, _e921);
                                                            phi_1749_ = select(_e871, _e867, _e921);
                                                        }
                                                        let _e927 = phi_1742_;
                                                        let _e929 = phi_1743_;
                                                        let _e931 = phi_1744_;
                                                        let _e933 = phi_1745_;
                                                        let _e935 = phi_1746_;
                                                        let _e937 = phi_1747_;
                                                        let _e939 = phi_1748_;
                                                        let _e941 = phi_1749_;
                                                        let _e948 = ((_e939.y * _e937.z) - (_e937.y * _e939.z));
                                                        let _e953 = ((_e939.z * _e937.x) - (_e937.z * _e939.x));
                                                        let _e956 = ((_e939.x * _e937.y) - (_e937.x * _e939.y));
                                                        let _e959 = ((_e752 >= _e756) && (_e752 >= _e760));
                                                        let _e960 = (_e756 >= _e760);
                                                        let _e974 = (((_e948 * (select(select(_e689[2][0], _e689[1][0], _e960), _e689[0][0], _e959) - _e267)) + (_e953 * (select(select(_e689[2][1], _e689[1][1], _e960), _e689[0][1], _e959) - _e334))) + (_e956 * (select(select(_e689[2][2], _e689[1][2], _e960), _e689[0][2], _e959) - _e400)));
                                                        let _e979 = (((_e948 * _e304) + (_e953 * _e370)) + (_e956 * _e436));
                                                        let _e980 = (_e929 - _e933);
                                                        let _e981 = (_e927 - _e931);
                                                        let _e984 = ((_e980 * _e980) + (_e981 * _e981));
                                                        let _e991 = (-(((_e933 * _e980) + (_e931 * _e981))) / select(0.000000000000000000000000000000000000011754944f, _e984, (_e984 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e993 = select(1f, _e991, (_e991 < 1f));
                                                        let _e995 = select(0f, _e993, (_e993 > 0f));
                                                        let _e1004 = ((_e935.x + (_e941.x * _e995)) - _e267);
                                                        let _e1007 = ((_e935.y + (_e941.y * _e995)) - _e334);
                                                        let _e1010 = ((_e935.z + (_e941.z * _e995)) - _e400);
                                                        let _e1013 = bitcast<f32>((bitcast<u32>(_e1004) & 2147483647u));
                                                        let _e1016 = bitcast<f32>((bitcast<u32>(_e1007) & 2147483647u));
                                                        let _e1018 = select(_e1016, _e1013, (_e1013 > _e1016));
                                                        let _e1021 = bitcast<f32>((bitcast<u32>(_e1010) & 2147483647u));
                                                        let _e1023 = select(_e1021, _e1018, (_e1018 > _e1021));
                                                        let _e1027 = abs(_e948);
                                                        let _e1028 = abs(_e953);
                                                        if (_e1027 != _e1027) {
                                                            phi_2727_ = true;
                                                        } else {
                                                            phi_2727_ = (_e1028 >= _e1027);
                                                        }
                                                        let _e1032 = phi_2727_;
                                                        let _e1033 = select(_e1027, _e1028, _e1032);
                                                        let _e1034 = abs(_e956);
                                                        if (_e1033 != _e1033) {
                                                            phi_2742_ = true;
                                                        } else {
                                                            phi_2742_ = (_e1034 >= _e1033);
                                                        }
                                                        let _e1038 = phi_2742_;
                                                        let _e1054 = abs(_e939.x);
                                                        let _e1055 = abs(_e939.y);
                                                        if (_e1054 != _e1054) {
                                                            phi_2757_ = true;
                                                        } else {
                                                            phi_2757_ = (_e1055 >= _e1054);
                                                        }
                                                        let _e1059 = phi_2757_;
                                                        let _e1060 = select(_e1054, _e1055, _e1059);
                                                        let _e1061 = abs(_e939.z);
                                                        if (_e1060 != _e1060) {
                                                            phi_2772_ = true;
                                                        } else {
                                                            phi_2772_ = (_e1061 >= _e1060);
                                                        }
                                                        let _e1065 = phi_2772_;
                                                        let _e1068 = abs(_e937.x);
                                                        let _e1069 = abs(_e937.y);
                                                        if (_e1068 != _e1068) {
                                                            phi_2787_ = true;
                                                        } else {
                                                            phi_2787_ = (_e1069 >= _e1068);
                                                        }
                                                        let _e1073 = phi_2787_;
                                                        let _e1074 = select(_e1068, _e1069, _e1073);
                                                        let _e1075 = abs(_e937.z);
                                                        if (_e1074 != _e1074) {
                                                            phi_2802_ = true;
                                                        } else {
                                                            phi_2802_ = (_e1075 >= _e1074);
                                                        }
                                                        let _e1079 = phi_2802_;
                                                        let _e1084 = ((bitcast<f32>((bitcast<u32>(((((_e948 * _e1004) + (_e953 * _e1007)) + (_e956 * _e1010)) - _e974)) & 2147483647u)) <= ((0.0000009536743f * select(_e914, _e1023, (_e1023 > _e914))) * select(_e1033, _e1034, _e1038))) && !((bitcast<f32>((bitcast<u32>(_e979) & 2147483647u)) <= ((0.0000038146973f * select(_e1060, _e1061, _e1065)) * select(_e1074, _e1075, _e1079)))));
                                                        let _e1085 = (_e974 / _e979);
                                                        if (_e855 && !(_e1084)) {
                                                            let _e1088 = (_e1010 / _e436);
                                                            let _e1096 = (((_e948 * (_e1004 - (_e304 * _e1088))) + (_e953 * (_e1007 - (_e370 * _e1088)))) / _e979);
                                                            phi_1957_ = select(select(_e1088, (_e1088 + _e1096), (bitcast<f32>((bitcast<u32>(_e1096) & 2147483647u)) <= _e914)), _e1085, _e1084);
                                                        } else {
                                                            phi_1957_ = _e1085;
                                                        }
                                                        let _e1105 = phi_1957_;
                                                        let _e1107 = select(_e818, _e1105, (_e1105 < _e818));
                                                        let _e1109 = select(_e810, _e1107, (_e1107 > _e810));
                                                        let _e1110 = (1f / _e762);
                                                        phi_1977_ = type_44(_e1109, (_e756 * _e1110), (_e760 * _e1110), ((_e855 && (_e1109 >= _e543)) && (_e1109 <= _e590.member_1)));
                                                        phi_1978_ = type_44();
                                                    } else {
                                                        phi_1977_ = type_44();
                                                        phi_1978_ = type_44(0f, 0f, 0f, _e855);
                                                    }
                                                    let _e1119 = phi_1977_;
                                                    let _e1121 = phi_1978_;
                                                    phi_1981_ = _e1119;
                                                    phi_1982_ = _e1121;
                                                    phi_1983_ = select(true, false, _e855);
                                                } else {
                                                    phi_1981_ = type_44();
                                                    phi_1982_ = type_44(0f, 0f, 0f, _e746);
                                                    phi_1983_ = true;
                                                }
                                                let _e1124 = phi_1981_;
                                                let _e1126 = phi_1982_;
                                                let _e1128 = phi_1983_;
                                                if _e1128 {
                                                    phi_1987_ = _e1126;
                                                } else {
                                                    phi_1987_ = _e1124;
                                                }
                                                let _e1130 = phi_1987_;
                                                if _e1130.member_3 {
                                                    phi_1996_ = type_23(_e1130.member, _e1130.member_1, _e1130.member_2, _e619);
                                                } else {
                                                    phi_1996_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1137 = phi_1996_;
                                                if (_e1137.member_3 != 4294967295u) {
                                                    if (_e619 != 4294967295u) {
                                                        if (_e1137.member < _e590.member.member) {
                                                            phi_2022_ = true;
                                                        } else {
                                                            if (_e1137.member == _e590.member.member) {
                                                                phi_2021_ = (_e1137.member_3 < _e590.member.member_3);
                                                            } else {
                                                                phi_2021_ = false;
                                                            }
                                                            let _e1150 = phi_2021_;
                                                            phi_2022_ = _e1150;
                                                        }
                                                        let _e1152 = phi_2022_;
                                                        if _e1152 {
                                                            phi_2028_ = type_40(_e1137, _e1137.member);
                                                        } else {
                                                            phi_2028_ = _e590;
                                                        }
                                                        let _e1155 = phi_2028_;
                                                        phi_2029_ = _e1155;
                                                    } else {
                                                        phi_2029_ = _e590;
                                                    }
                                                    let _e1157 = phi_2029_;
                                                    phi_2030_ = _e1157;
                                                } else {
                                                    phi_2030_ = _e590;
                                                }
                                                let _e1159 = phi_2030_;
                                                phi_1062_ = _e1159;
                                            } else {
                                                phi_1062_ = type_40();
                                            }
                                            let _e1161 = phi_1062_;
                                            continue;
                                            continuing {
                                                phi_1061_ = _e1161;
                                                phi_1064_ = _e605;
                                                phi_2885_ = _e551;
                                                break if !(_e611);
                                            }
                                        }
                                        let _e1164 = phi_2885_;
                                        phi_3050_ = _e1164;
                                        if _e1164 {
                                            break;
                                        }
                                        phi_3085_ = _e1164;
                                        let _e1616 = local_3;
                                        phi_2031_ = _e1616;
                                    } else {
                                        phi_3085_ = _e551;
                                        phi_2031_ = _e553;
                                    }
                                    let _e1166 = phi_3085_;
                                    let _e1168 = phi_2031_;
                                    if _e583 {
                                        phi_2511_ = bool();
                                        phi_2512_ = u32();
                                        phi_2513_ = u32();
                                    } else {
                                        if (_e580 >= _e75) {
                                            phi_2096_ = type_45(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e580 < _e75) {
                                            } else {
                                                phi_3050_ = true;
                                                break;
                                            }
                                            let _e1171 = (_e203 % 3u);
                                            if (_e1171 < 3u) {
                                            } else {
                                                phi_3050_ = true;
                                                break;
                                            }
                                            let _e1177 = global_2.member[_e580].member[_e1171];
                                            let _e1183 = (_e202 % 3u);
                                            if (_e1183 < 3u) {
                                            } else {
                                                phi_3050_ = true;
                                                break;
                                            }
                                            let _e1189 = global_2.member[_e580].member[_e1183];
                                            let _e1195 = (_e204 % 3u);
                                            if (_e1195 < 3u) {
                                            } else {
                                                phi_3050_ = true;
                                                break;
                                            }
                                            let _e1201 = global_2.member[_e580].member[_e1195];
                                            let _e1211 = global_2.member[_e580].member_1;
                                            let _e1215 = global_2.member[_e580].member_2;
                                            phi_2096_ = type_45(array<vec4<f32>, 3>(vec4<f32>(_e1177[0], _e1177[1], _e1177[2], _e1177[3]), vec4<f32>(_e1189[0], _e1189[1], _e1189[2], _e1189[3]), vec4<f32>(_e1201[0], _e1201[1], _e1201[2], _e1201[3])), _e1211, _e1215);
                                        }
                                        let _e1218 = phi_2096_;
                                        let _e1230 = ((_e1218.member[0].x - _e305) * _e308);
                                        let _e1231 = ((_e1218.member[0].y - _e305) * _e308);
                                        let _e1232 = ((_e1218.member[0].z - _e306) * _e308);
                                        let _e1233 = ((_e1218.member[0].w - _e306) * _e308);
                                        let _e1243 = ((_e1218.member[1].x - _e371) * _e374);
                                        let _e1244 = ((_e1218.member[1].y - _e371) * _e374);
                                        let _e1245 = ((_e1218.member[1].z - _e372) * _e374);
                                        let _e1246 = ((_e1218.member[1].w - _e372) * _e374);
                                        let _e1256 = ((_e1218.member[2].x - _e437) * _e440);
                                        let _e1257 = ((_e1218.member[2].y - _e437) * _e440);
                                        let _e1258 = ((_e1218.member[2].z - _e438) * _e440);
                                        let _e1259 = ((_e1218.member[2].w - _e438) * _e440);
                                        let _e1261 = select(_e1258, _e1256, (_e1256 < _e1258));
                                        let _e1263 = select(_e1259, _e1257, (_e1257 < _e1259));
                                        let _e1265 = select(_e1258, _e1256, (_e1256 > _e1258));
                                        let _e1267 = select(_e1259, _e1257, (_e1257 > _e1259));
                                        let _e1269 = select(_e1232, _e1230, (_e1230 < _e1232));
                                        let _e1271 = select(_e1233, _e1231, (_e1231 < _e1233));
                                        let _e1273 = select(_e1245, _e1243, (_e1243 < _e1245));
                                        let _e1275 = select(_e1246, _e1244, (_e1244 < _e1246));
                                        let _e1277 = select(_e1273, _e1269, (_e1269 > _e1273));
                                        let _e1279 = select(_e1275, _e1271, (_e1271 > _e1275));
                                        let _e1281 = select(_e1261, _e1277, (_e1277 > _e1261));
                                        let _e1283 = select(_e1263, _e1279, (_e1279 > _e1263));
                                        let _e1285 = select(_e1232, _e1230, (_e1230 > _e1232));
                                        let _e1287 = select(_e1233, _e1231, (_e1231 > _e1233));
                                        let _e1289 = select(_e1245, _e1243, (_e1243 > _e1245));
                                        let _e1291 = select(_e1246, _e1244, (_e1244 > _e1246));
                                        let _e1293 = select(_e1289, _e1285, (_e1285 < _e1289));
                                        let _e1295 = select(_e1291, _e1287, (_e1287 < _e1291));
                                        let _e1300 = -(_e1261);
                                        let _e1301 = -(_e1263);
                                        let _e1308 = (select(_e1265, _e1293, (_e1293 < _e1265)) + (select(_e1300, _e1265, (_e1265 > _e1300)) * 0.0000019073523f));
                                        let _e1309 = (select(_e1267, _e1295, (_e1295 < _e1267)) + (select(_e1301, _e1267, (_e1267 > _e1301)) * 0.0000019073523f));
                                        let _e1311 = select(_e543, _e1281, (_e1281 > _e543));
                                        let _e1313 = select(_e543, _e1283, (_e1283 > _e543));
                                        let _e1318 = (_e1311 <= select(_e1168.member_1, _e1308, (_e1308 < _e1168.member_1)));
                                        let _e1319 = (_e1313 <= select(_e1168.member_1, _e1309, (_e1309 < _e1168.member_1)));
                                        let _e1320 = (_e1311 <= _e1313);
                                        if _e1318 {
                                            if _e1319 {
                                                if _e1320 {
                                                    phi_2458_ = _e1218.member_2;
                                                } else {
                                                    phi_2458_ = _e1218.member_1;
                                                }
                                                let _e1324 = phi_2458_;
                                                let _e1326 = (_e578 % 128u);
                                                let _e1327 = (_e1326 < 128u);
                                                if _e1327 {
                                                } else {
                                                    phi_3050_ = true;
                                                    break;
                                                }
                                                local_1[_e1326] = _e1324;
                                                if _e1327 {
                                                } else {
                                                    phi_3050_ = true;
                                                    break;
                                                }
                                                local[_e1326] = select(_e1311, _e1313, _e1320);
                                                if _e1320 {
                                                    phi_2485_ = _e1218.member_1;
                                                } else {
                                                    phi_2485_ = _e1218.member_2;
                                                }
                                                let _e1334 = phi_2485_;
                                                phi_2486_ = (_e578 + 1u);
                                                phi_2487_ = _e1334;
                                            } else {
                                                phi_2486_ = u32();
                                                phi_2487_ = u32();
                                            }
                                            let _e1336 = phi_2486_;
                                            let _e1338 = phi_2487_;
                                            phi_2489_ = _e1336;
                                            phi_2490_ = _e1338;
                                            phi_2491_ = select(true, false, _e1319);
                                        } else {
                                            phi_2489_ = u32();
                                            phi_2490_ = u32();
                                            phi_2491_ = true;
                                        }
                                        let _e1341 = phi_2489_;
                                        let _e1343 = phi_2490_;
                                        let _e1345 = phi_2491_;
                                        if _e1345 {
                                            if _e1318 {
                                                phi_2500_ = _e1218.member_1;
                                            } else {
                                                phi_2500_ = _e1218.member_2;
                                            }
                                            let _e1349 = phi_2500_;
                                            phi_2505_ = select(_e1319, true, _e1318);
                                            phi_2507_ = _e1349;
                                        } else {
                                            phi_2505_ = _e576;
                                            phi_2507_ = _e1343;
                                        }
                                        let _e1352 = phi_2505_;
                                        let _e1354 = phi_2507_;
                                        phi_2511_ = _e1352;
                                        phi_2512_ = select(_e1341, _e578, _e1345);
                                        phi_2513_ = _e1354;
                                    }
                                    let _e1357 = phi_2511_;
                                    let _e1359 = phi_2512_;
                                    let _e1361 = phi_2513_;
                                    phi_3053_ = _e1166;
                                    phi_2524_ = _e1168;
                                    phi_2525_ = (_e555 - 1u);
                                    phi_2526_ = select(_e1357, false, _e583);
                                    phi_2527_ = select(_e1359, _e578, _e583);
                                    phi_2528_ = select(_e1361, _e580, _e583);
                                } else {
                                    phi_3053_ = _e551;
                                    phi_2524_ = _e553;
                                    phi_2525_ = _e555;
                                    phi_2526_ = _e576;
                                    phi_2527_ = _e578;
                                    phi_2528_ = _e580;
                                }
                                let _e1366 = phi_3053_;
                                let _e1368 = phi_2524_;
                                let _e1370 = phi_2525_;
                                let _e1372 = phi_2526_;
                                let _e1374 = phi_2527_;
                                let _e1376 = phi_2528_;
                                phi_3052_ = _e1366;
                                phi_2529_ = _e1368;
                                phi_2530_ = _e1370;
                                phi_2531_ = _e1372;
                                phi_2532_ = _e1374;
                                phi_2533_ = _e1376;
                            } else {
                                phi_3052_ = _e551;
                                phi_2529_ = type_40();
                                phi_2530_ = u32();
                                phi_2531_ = bool();
                                phi_2532_ = u32();
                                phi_2533_ = u32();
                            }
                            let _e1378 = phi_3052_;
                            let _e1380 = phi_2529_;
                            let _e1382 = phi_2530_;
                            let _e1384 = phi_2531_;
                            let _e1386 = phi_2532_;
                            let _e1388 = phi_2533_;
                            phi_3051_ = _e1378;
                            phi_993_ = _e1380;
                            phi_996_ = _e1382;
                            phi_998_ = _e1384;
                            phi_1000_ = _e1386;
                            phi_1002_ = _e1388;
                            phi_2534_ = _e565;
                        } else {
                            phi_3051_ = _e551;
                            phi_993_ = type_40();
                            phi_996_ = u32();
                            phi_998_ = bool();
                            phi_1000_ = u32();
                            phi_1002_ = u32();
                            phi_2534_ = false;
                        }
                        let _e1390 = phi_3051_;
                        let _e1392 = phi_993_;
                        let _e1394 = phi_996_;
                        let _e1396 = phi_998_;
                        let _e1398 = phi_1000_;
                        let _e1400 = phi_1002_;
                        let _e1402 = phi_2534_;
                        continue;
                        continuing {
                            phi_2891_ = _e1390;
                            phi_992_ = _e1392;
                            phi_995_ = _e1394;
                            phi_997_ = _e1396;
                            phi_999_ = _e1398;
                            phi_1001_ = _e1400;
                            phi_3050_ = _e1390;
                            break if !(_e1402);
                        }
                    }
                    let _e1405 = phi_3050_;
                    if _e1405 {
                        break;
                    }
                    let _e1407 = local_2;
                    if (_e1407.member.member_3 != 4294967295u) {
                        let _e1412 = -(_e445);
                        let _e1413 = bitcast<u32>(_e1407.member.member);
                        let _e1417 = (bitcast<i32>((_e1413 >> bitcast<u32>(23i))) & 255i);
                        let _e1418 = (_e1417 + _e1412);
                        if (_e1417 == 255i) {
                            phi_2593_ = _e1407.member.member;
                        } else {
                            if (_e1417 > 0i) {
                                if (_e1418 > 0i) {
                                    let _e1422 = (_e1418 < 255i);
                                    if _e1422 {
                                        phi_2572_ = bitcast<f32>((_e1413 + bitcast<u32>((_e1412 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_2572_ = f32();
                                    }
                                    let _e1429 = phi_2572_;
                                    phi_2574_ = _e1429;
                                    phi_2575_ = select(true, false, _e1422);
                                } else {
                                    phi_2574_ = f32();
                                    phi_2575_ = true;
                                }
                                let _e1432 = phi_2574_;
                                let _e1434 = phi_2575_;
                                phi_2576_ = _e1432;
                                phi_2577_ = _e1434;
                            } else {
                                phi_2576_ = f32();
                                phi_2577_ = true;
                            }
                            let _e1436 = phi_2576_;
                            let _e1438 = phi_2577_;
                            if _e1438 {
                                let _e1439 = (_e1413 & 2147483648u);
                                let _e1446 = ((_e1413 & 8388607u) | (select(0u, 1u, ((_e1413 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e1450 = (_e1446 == 0u);
                                if _e1450 {
                                    phi_2880_ = bitcast<f32>(_e1439);
                                } else {
                                    let _e1455 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1446)), 32u, _e1450) - 8u);
                                    let _e1458 = (_e1446 << bitcast<u32>((_e1455 & 31u)));
                                    let _e1460 = ((_e1418 + select(0i, 1i, (_e1417 == 0i))) - bitcast<i32>(_e1455));
                                    if (_e1460 >= 255i) {
                                        phi_2870_ = bitcast<f32>((_e1439 | 2139095040u));
                                        phi_2871_ = f32();
                                        phi_2872_ = true;
                                    } else {
                                        let _e1462 = (_e1460 > 0i);
                                        if _e1462 {
                                            phi_2864_ = bitcast<f32>(((_e1439 | (bitcast<u32>(_e1460) << bitcast<u32>(23i))) | (_e1458 & 8388607u)));
                                            phi_2865_ = f32();
                                        } else {
                                            if (_e1460 < -24i) {
                                                phi_2830_ = 26u;
                                            } else {
                                                phi_2830_ = bitcast<u32>((1i - _e1460));
                                            }
                                            let _e1467 = phi_2830_;
                                            let _e1468 = (_e1467 & 31u);
                                            let _e1470 = (_e1458 >> bitcast<u32>(_e1468));
                                            let _e1474 = (_e1458 & ((1u << bitcast<u32>(_e1468)) - 1u));
                                            let _e1478 = (1u << bitcast<u32>(((_e1467 - 1u) & 31u)));
                                            if (_e1474 > _e1478) {
                                                phi_2851_ = true;
                                            } else {
                                                if (_e1474 == _e1478) {
                                                    phi_2848_ = ((_e1470 & 1u) == 1u);
                                                } else {
                                                    phi_2848_ = false;
                                                }
                                                let _e1484 = phi_2848_;
                                                phi_2851_ = _e1484;
                                            }
                                            let _e1486 = phi_2851_;
                                            phi_2864_ = f32();
                                            phi_2865_ = bitcast<f32>((_e1439 | (_e1470 + select(0u, 1u, _e1486))));
                                        }
                                        let _e1499 = phi_2864_;
                                        let _e1501 = phi_2865_;
                                        phi_2870_ = _e1499;
                                        phi_2871_ = _e1501;
                                        phi_2872_ = _e1462;
                                    }
                                    let _e1505 = phi_2870_;
                                    let _e1507 = phi_2871_;
                                    let _e1509 = phi_2872_;
                                    phi_2880_ = select(_e1507, _e1505, _e1509);
                                }
                                let _e1513 = phi_2880_;
                                phi_2592_ = _e1513;
                            } else {
                                phi_2592_ = _e1436;
                            }
                            let _e1515 = phi_2592_;
                            phi_2593_ = _e1515;
                        }
                        let _e1517 = phi_2593_;
                        let _e1518 = bitcast<u32>(_e1517);
                        if ((_e1518 & 2147483647u) >= 2139095040u) {
                            phi_2605_ = bitcast<f32>(((_e1518 & 2147483648u) | 2139095039u));
                        } else {
                            phi_2605_ = _e1517;
                        }
                        let _e1525 = phi_2605_;
                        phi_2610_ = type_23(_e1525, _e1407.member.member_1, _e1407.member.member_2, _e1407.member.member_3);
                    } else {
                        phi_2610_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1530 = phi_2610_;
                    if _e91 {
                    } else {
                        break;
                    }
                    global_5.member[_e85] = _e1530;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_closest(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
