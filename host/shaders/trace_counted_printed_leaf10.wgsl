struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_17 {
    member: array<array<u32, 2>>,
}

struct type_21 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_22 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_28 {
    member: type_21,
    member_1: f32,
}

struct type_30 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_32 {
    member: array<type_22>,
}

struct type_34 {
    member: type_28,
    member_1: u32,
    member_2: u32,
}

struct type_36 {
    member: array<vec4<u32>, 2>,
}

struct type_38 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_40 {
    member: array<type_38>,
}

struct type_43 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_45 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_47 {
    member: array<type_45>,
}

struct type_51 {
    member: type_43,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(1) 
var<uniform> global_2: type_36;
@group(0) @binding(4) 
var<storage> global_3: type_32;
@group(0) @binding(2) 
var<storage> global_4: type_40;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_17;
@group(0) @binding(3) 
var<storage> global_6: type_47;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<f32, 128>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<u32, 128>;
    var local_7: array<f32, 128>;
    var local_8: array<f32, 3>;
    var local_9: array<f32, 3>;
    var phi_371_: i32;
    var phi_372_: i32;
    var phi_382_: bool;
    var phi_392_: u32;
    var phi_393_: u32;
    var phi_395_: bool;
    var phi_400_: u32;
    var phi_413_: i32;
    var phi_433_: i32;
    var phi_451_: f32;
    var phi_457_: f32;
    var phi_497_: f32;
    var phi_503_: f32;
    var phi_576_: f32;
    var phi_582_: f32;
    var phi_622_: f32;
    var phi_628_: f32;
    var phi_701_: f32;
    var phi_707_: f32;
    var phi_747_: f32;
    var phi_753_: f32;
    var phi_872_: i32;
    var phi_894_: u32;
    var phi_895_: u32;
    var phi_932_: i32;
    var phi_954_: u32;
    var phi_955_: u32;
    var phi_963_: f32;
    var phi_964_: f32;
    var phi_3537_: bool;
    var phi_1048_: type_34;
    var phi_1051_: bool;
    var phi_1053_: type_51;
    var phi_1055_: u32;
    var phi_1057_: u32;
    var phi_1068_: bool;
    var phi_1154_: bool;
    var phi_1155_: type_51;
    var phi_1156_: u32;
    var phi_2333_: type_38;
    var phi_3222_: type_51;
    var phi_3298_: type_51;
    var phi_3299_: type_51;
    var phi_3300_: u32;
    var phi_3302_: type_51;
    var phi_3303_: u32;
    var phi_3304_: bool;
    var phi_3311_: type_51;
    var phi_3316_: bool;
    var phi_3317_: type_51;
    var phi_1175_: type_34;
    var phi_1178_: type_4;
    var phi_1179_: type_4;
    var phi_1201_: type_4;
    var phi_1229_: u32;
    var phi_1245_: type_45;
    var phi_2040_: f32;
    var phi_2041_: f32;
    var phi_2042_: f32;
    var phi_2043_: f32;
    var phi_2044_: vec3<f32>;
    var phi_2045_: vec3<f32>;
    var phi_2046_: vec3<f32>;
    var phi_2047_: vec3<f32>;
    var phi_2238_: f32;
    var phi_2258_: type_30;
    var phi_2259_: type_30;
    var phi_2262_: type_30;
    var phi_2263_: type_30;
    var phi_2264_: bool;
    var phi_2268_: type_30;
    var phi_2277_: type_21;
    var phi_2302_: bool;
    var phi_2303_: bool;
    var phi_2310_: type_34;
    var phi_2311_: type_34;
    var phi_2312_: type_34;
    var phi_1176_: type_34;
    var phi_3531_: bool;
    var local_10: type_34;
    var phi_3706_: bool;
    var phi_3319_: type_34;
    var phi_3320_: bool;
    var phi_3321_: type_51;
    var phi_3322_: u32;
    var phi_3705_: bool;
    var phi_3323_: type_34;
    var phi_3324_: bool;
    var phi_3325_: type_51;
    var phi_3326_: u32;
    var phi_3327_: u32;
    var phi_3704_: bool;
    var phi_3328_: type_34;
    var phi_3329_: bool;
    var phi_3330_: type_51;
    var phi_3331_: u32;
    var phi_3332_: u32;
    var phi_3703_: bool;
    var phi_1049_: type_34;
    var phi_1052_: bool;
    var phi_1054_: type_51;
    var phi_1056_: u32;
    var phi_1058_: u32;
    var phi_3333_: bool;
    var phi_3702_: bool;
    var local_11: type_34;
    var local_12: type_34;
    var local_13: type_34;

    switch bitcast<i32>(0u) {
        default: {
            let _e78 = global;
            let _e81 = arrayLength((&global_4.member));
            let _e92 = global_2.member[0u][0u];
            let _e96 = global_2.member[0u][1u];
            let _e100 = global_2.member[0u][2u];
            let _e104 = global_2.member[1u][0u];
            let _e108 = global_2.member[1u][1u];
            let _e112 = global_2.member[1u][2u];
            let _e116 = global_2.member[1u][3u];
            let _e119 = global_1.member[0u];
            let _e120 = bitcast<i32>(_e119);
            let _e130 = (_e78.x + (_e78.y * 2097152u));
            let _e131 = (_e130 < arrayLength((&global_3.member)));
            if _e131 {
                let _e132 = (_e130 < arrayLength((&global_5.member)));
                if _e132 {
                    if _e131 {
                    } else {
                        break;
                    }
                    let _e140 = global_3.member[_e130].member_2[0u];
                    let _e142 = (bitcast<u32>(_e140) & 2147483647u);
                    let _e147 = global_3.member[_e130].member_2[1u];
                    let _e149 = (bitcast<u32>(_e147) & 2147483647u);
                    let _e154 = global_3.member[_e130].member_2[2u];
                    let _e156 = (bitcast<u32>(_e154) & 2147483647u);
                    let _e161 = global_3.member[_e130].member[0u];
                    let _e163 = (bitcast<u32>(_e161) & 2147483647u);
                    let _e168 = global_3.member[_e130].member[1u];
                    let _e170 = (bitcast<u32>(_e168) & 2147483647u);
                    let _e175 = global_3.member[_e130].member[2u];
                    let _e177 = (bitcast<u32>(_e175) & 2147483647u);
                    let _e179 = select(_e149, _e142, (_e149 < _e142));
                    let _e181 = select(_e156, _e179, (_e156 < _e179));
                    let _e183 = select(_e163, _e181, (_e163 < _e181));
                    let _e185 = select(_e170, _e183, (_e170 < _e183));
                    let _e187 = select(_e177, _e185, (_e177 < _e185));
                    let _e191 = global_3.member[_e130].member_1;
                    let _e192 = bitcast<u32>(_e191);
                    let _e193 = (_e192 & 2147483647u);
                    let _e200 = global_3.member[_e130].member_3;
                    let _e201 = bitcast<u32>(_e200);
                    let _e202 = (_e201 & 2147483647u);
                    let _e206 = (((select(_e193, _e187, (_e193 < _e187)) < 2139095040u) && (_e202 <= 2139095040u)) && (_e181 > 0u));
                    if _e206 {
                        let _e209 = (bitcast<u32>(bitcast<f32>(_e181)) & 2147483647u);
                        if (_e209 >= 8388608u) {
                            phi_371_ = (bitcast<i32>((_e209 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_371_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e209)), 32u, (_e209 == 0u))));
                        }
                        let _e223 = phi_371_;
                        phi_372_ = _e223;
                    } else {
                        phi_372_ = 0i;
                    }
                    let _e225 = phi_372_;
                    let _e226 = (_e142 == _e181);
                    if _e226 {
                        phi_382_ = true;
                    } else {
                        phi_382_ = (_e149 == _e181);
                    }
                    let _e229 = phi_382_;
                    let _e230 = select(1u, 0u, _e226);
                    if _e229 {
                        let _e231 = (_e230 + 1u);
                        phi_392_ = _e231;
                        phi_393_ = _e231;
                        phi_395_ = select(true, false, (_e231 == 2u));
                    } else {
                        phi_392_ = u32();
                        phi_393_ = 0u;
                        phi_395_ = true;
                    }
                    let _e235 = phi_392_;
                    let _e237 = phi_393_;
                    let _e239 = phi_395_;
                    if _e239 {
                        phi_400_ = (_e237 + 1u);
                    } else {
                        phi_400_ = 0u;
                    }
                    let _e243 = phi_400_;
                    let _e244 = select(_e235, _e237, _e239);
                    let _e245 = select(_e230, select(2u, _e230, _e229), _e239);
                    if (_e120 < -126i) {
                        phi_413_ = -126i;
                    } else {
                        phi_413_ = select(_e120, 127i, (_e120 > 127i));
                    }
                    let _e250 = phi_413_;
                    let _e255 = bitcast<f32>((bitcast<u32>((_e250 + 127i)) << bitcast<u32>(23i)));
                    let _e261 = bitcast<f32>((bitcast<u32>(((_e120 - _e250) + 127i)) << bitcast<u32>(23i)));
                    let _e262 = -(_e225);
                    if (_e262 < -126i) {
                        phi_433_ = -126i;
                    } else {
                        phi_433_ = select(_e262, 127i, (_e262 > 127i));
                    }
                    let _e267 = phi_433_;
                    let _e272 = bitcast<f32>((bitcast<u32>((_e267 + 127i)) << bitcast<u32>(23i)));
                    let _e278 = bitcast<f32>((bitcast<u32>(((_e262 - _e267) + 127i)) << bitcast<u32>(23i)));
                    let _e282 = global_3.member[_e130].member;
                    let _e283 = (_e244 == 0u);
                    if _e283 {
                        phi_451_ = _e282[0];
                    } else {
                        phi_451_ = _e282[1];
                    }
                    let _e287 = phi_451_;
                    let _e288 = (_e244 == 2u);
                    if _e288 {
                        phi_457_ = _e282[2];
                    } else {
                        phi_457_ = _e287;
                    }
                    let _e291 = phi_457_;
                    let _e292 = bitcast<u32>(_e291);
                    let _e294 = ((_e292 & 2139095040u) != 0u);
                    let _e308 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e292 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e292 & 2147483648u))), _e291, _e294) * _e255) * select(0.00000011920929f, 1f, _e294)) * _e261);
                    let _e309 = global_3.member[_e130].member_2;
                    if _e283 {
                        phi_497_ = _e309[0];
                    } else {
                        phi_497_ = _e309[1];
                    }
                    let _e313 = phi_497_;
                    if _e288 {
                        phi_503_ = _e309[2];
                    } else {
                        phi_503_ = _e313;
                    }
                    let _e316 = phi_503_;
                    let _e317 = bitcast<u32>(_e316);
                    let _e319 = ((_e317 & 2139095040u) != 0u);
                    let _e333 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e317 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e317 & 2147483648u))), _e316, _e319) * _e272) * select(0.00000011920929f, 1f, _e319)) * _e278);
                    let _e337 = (bitcast<f32>((bitcast<u32>(_e333) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e340 = bitcast<f32>((bitcast<u32>(_e308) & 2147483647u));
                    let _e341 = (_e340 * 0.00000011920929f);
                    let _e344 = select(select(0.00000000000011368684f, _e341, (_e341 > 0.00000000000011368684f)), 0f, _e337);
                    let _e345 = select(0f, _e333, _e337);
                    let _e346 = (_e308 + _e344);
                    let _e347 = (_e308 - _e344);
                    let _e349 = select(38685626000000000000000000f, (1f / _e333), _e337);
                    let _e350 = (_e243 == 0u);
                    if _e350 {
                        phi_576_ = _e282[0];
                    } else {
                        phi_576_ = _e282[1];
                    }
                    let _e354 = phi_576_;
                    let _e355 = (_e243 == 2u);
                    if _e355 {
                        phi_582_ = _e282[2];
                    } else {
                        phi_582_ = _e354;
                    }
                    let _e358 = phi_582_;
                    let _e359 = bitcast<u32>(_e358);
                    let _e361 = ((_e359 & 2139095040u) != 0u);
                    let _e375 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e359 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e359 & 2147483648u))), _e358, _e361) * _e255) * select(0.00000011920929f, 1f, _e361)) * _e261);
                    if _e350 {
                        phi_622_ = _e309[0];
                    } else {
                        phi_622_ = _e309[1];
                    }
                    let _e379 = phi_622_;
                    if _e355 {
                        phi_628_ = _e309[2];
                    } else {
                        phi_628_ = _e379;
                    }
                    let _e382 = phi_628_;
                    let _e383 = bitcast<u32>(_e382);
                    let _e385 = ((_e383 & 2139095040u) != 0u);
                    let _e399 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e383 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e383 & 2147483648u))), _e382, _e385) * _e272) * select(0.00000011920929f, 1f, _e385)) * _e278);
                    let _e403 = (bitcast<f32>((bitcast<u32>(_e399) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e406 = bitcast<f32>((bitcast<u32>(_e375) & 2147483647u));
                    let _e407 = (_e406 * 0.00000011920929f);
                    let _e410 = select(select(0.00000000000011368684f, _e407, (_e407 > 0.00000000000011368684f)), 0f, _e403);
                    let _e411 = select(0f, _e399, _e403);
                    let _e412 = (_e375 + _e410);
                    let _e413 = (_e375 - _e410);
                    let _e415 = select(38685626000000000000000000f, (1f / _e399), _e403);
                    let _e416 = (_e245 == 0u);
                    if _e416 {
                        phi_701_ = _e282[0];
                    } else {
                        phi_701_ = _e282[1];
                    }
                    let _e420 = phi_701_;
                    let _e421 = (_e245 == 2u);
                    if _e421 {
                        phi_707_ = _e282[2];
                    } else {
                        phi_707_ = _e420;
                    }
                    let _e424 = phi_707_;
                    let _e425 = bitcast<u32>(_e424);
                    let _e427 = ((_e425 & 2139095040u) != 0u);
                    let _e441 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e425 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e425 & 2147483648u))), _e424, _e427) * _e255) * select(0.00000011920929f, 1f, _e427)) * _e261);
                    if _e416 {
                        phi_747_ = _e309[0];
                    } else {
                        phi_747_ = _e309[1];
                    }
                    let _e445 = phi_747_;
                    if _e421 {
                        phi_753_ = _e309[2];
                    } else {
                        phi_753_ = _e445;
                    }
                    let _e448 = phi_753_;
                    let _e449 = bitcast<u32>(_e448);
                    let _e451 = ((_e449 & 2139095040u) != 0u);
                    let _e465 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e449 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e449 & 2147483648u))), _e448, _e451) * _e272) * select(0.00000011920929f, 1f, _e451)) * _e278);
                    let _e469 = (bitcast<f32>((bitcast<u32>(_e465) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e472 = bitcast<f32>((bitcast<u32>(_e441) & 2147483647u));
                    let _e473 = (_e472 * 0.00000011920929f);
                    let _e476 = select(select(0.00000000000011368684f, _e473, (_e473 > 0.00000000000011368684f)), 0f, _e469);
                    let _e477 = select(0f, _e465, _e469);
                    let _e478 = (_e441 + _e476);
                    let _e479 = (_e441 - _e476);
                    let _e481 = select(38685626000000000000000000f, (1f / _e465), _e469);
                    let _e483 = select(_e406, _e340, (_e340 > _e406));
                    let _e486 = (_e120 + _e225);
                    if (_e206 && (select(_e472, _e483, (_e483 > _e472)) <= 1099511600000f)) {
                        let _e496 = ((_e193 & 8388607u) | (select(0u, 1u, ((_e193 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e499 = bitcast<i32>((_e193 >> bitcast<u32>(23i)));
                        let _e503 = (_e496 == 0u);
                        let _e506 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e496)), 32u, _e503)) - 8i);
                        if (_e499 == 255i) {
                            phi_872_ = 255i;
                        } else {
                            phi_872_ = (((_e499 + select(0i, 1i, (_e499 == 0i))) - _e506) + _e486);
                        }
                        let _e514 = phi_872_;
                        let _e524 = (_e514 <= 0i);
                        if _e524 {
                            phi_895_ = u32();
                        } else {
                            if _e503 {
                                phi_894_ = u32();
                            } else {
                                phi_894_ = select(((bitcast<u32>(_e514) << bitcast<u32>(23i)) | ((_e496 << bitcast<u32>(((_e506 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e514 >= 255i));
                            }
                            let _e528 = phi_894_;
                            phi_895_ = _e528;
                        }
                        let _e530 = phi_895_;
                        let _e542 = ((_e202 & 8388607u) | (select(0u, 1u, ((_e202 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e545 = bitcast<i32>((_e202 >> bitcast<u32>(23i)));
                        let _e549 = (_e542 == 0u);
                        let _e552 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e542)), 32u, _e549)) - 8i);
                        if (_e545 == 255i) {
                            phi_932_ = 255i;
                        } else {
                            phi_932_ = (((_e545 + select(0i, 1i, (_e545 == 0i))) - _e552) + _e486);
                        }
                        let _e560 = phi_932_;
                        let _e570 = (_e560 <= 0i);
                        if _e570 {
                            phi_955_ = u32();
                        } else {
                            if _e549 {
                                phi_954_ = u32();
                            } else {
                                phi_954_ = select(((bitcast<u32>(_e560) << bitcast<u32>(23i)) | ((_e542 << bitcast<u32>(((_e552 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e560 >= 255i));
                            }
                            let _e574 = phi_954_;
                            phi_955_ = _e574;
                        }
                        let _e576 = phi_955_;
                        phi_963_ = bitcast<f32>(((_e201 & 2147483648u) | select(_e576, 0u, select(_e549, true, _e570))));
                        phi_964_ = bitcast<f32>(((_e192 & 2147483648u) | select(_e530, 0u, select(_e503, true, _e524))));
                    } else {
                        phi_963_ = 0f;
                        phi_964_ = 1f;
                    }
                    let _e582 = phi_963_;
                    let _e584 = phi_964_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e92), bitcast<f32>(_e96), bitcast<f32>(_e100));
                    let _e592 = (_e244 % 3u);
                    let _e593 = (_e592 < 3u);
                    if _e593 {
                    } else {
                        break;
                    }
                    let _e595 = local_9[_e592];
                    let _e596 = (_e243 % 3u);
                    let _e597 = (_e596 < 3u);
                    if _e597 {
                    } else {
                        break;
                    }
                    let _e599 = local_9[_e596];
                    let _e600 = (_e245 % 3u);
                    let _e601 = (_e600 < 3u);
                    if _e601 {
                    } else {
                        break;
                    }
                    let _e603 = local_9[_e600];
                    local_8 = array<f32, 3>(bitcast<f32>(_e104), bitcast<f32>(_e108), bitcast<f32>(_e112));
                    if _e593 {
                    } else {
                        break;
                    }
                    let _e607 = local_8[_e592];
                    if _e597 {
                    } else {
                        break;
                    }
                    let _e609 = local_8[_e596];
                    if _e601 {
                    } else {
                        break;
                    }
                    let _e611 = local_8[_e600];
                    phi_3537_ = false;
                    phi_1048_ = type_34(type_28(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e582), 0u, 0u);
                    phi_1051_ = (_e584 <= _e582);
                    phi_1053_ = type_51(type_43(array<f32, 3>(_e595, _e599, _e603), array<f32, 3>(_e607, _e609, _e611)), select(0u, 2147483648u, (_e81 == 0u)));
                    phi_1055_ = 0u;
                    phi_1057_ = ((3u * _e81) + 1u);
                    loop {
                        let _e617 = phi_3537_;
                        let _e619 = phi_1048_;
                        let _e621 = phi_1051_;
                        let _e623 = phi_1053_;
                        let _e625 = phi_1055_;
                        let _e627 = phi_1057_;
                        local_11 = _e619;
                        local_12 = _e619;
                        if _e621 {
                            phi_1068_ = true;
                        } else {
                            phi_1068_ = (_e625 > 0u);
                        }
                        let _e630 = phi_1068_;
                        if _e630 {
                            let _e631 = (_e627 > 0u);
                            if _e631 {
                                if _e621 {
                                    phi_1154_ = _e621;
                                    phi_1155_ = _e623;
                                    phi_1156_ = _e625;
                                } else {
                                    let _e632 = (_e625 - 1u);
                                    let _e633 = (_e632 % 128u);
                                    let _e634 = (_e633 < 128u);
                                    if _e634 {
                                    } else {
                                        phi_3702_ = true;
                                        break;
                                    }
                                    let _e636 = local_6[_e633];
                                    if _e634 {
                                    } else {
                                        phi_3702_ = true;
                                        break;
                                    }
                                    let _e638 = local_5[_e633];
                                    if _e634 {
                                    } else {
                                        phi_3702_ = true;
                                        break;
                                    }
                                    let _e640 = local_4[_e633];
                                    if _e634 {
                                    } else {
                                        phi_3702_ = true;
                                        break;
                                    }
                                    let _e642 = local_3[_e633];
                                    if _e634 {
                                    } else {
                                        phi_3702_ = true;
                                        break;
                                    }
                                    let _e645 = local_2[_e633];
                                    if _e634 {
                                    } else {
                                        phi_3702_ = true;
                                        break;
                                    }
                                    let _e647 = local_1[_e633];
                                    if _e634 {
                                    } else {
                                        phi_3702_ = true;
                                        break;
                                    }
                                    let _e649 = local[_e633];
                                    if _e634 {
                                    } else {
                                        phi_3702_ = true;
                                        break;
                                    }
                                    let _e654 = local_7[_e633];
                                    phi_1154_ = (_e654 <= _e619.member.member_1);
                                    phi_1155_ = type_51(type_43(array<f32, 3>(_e638, _e640, _e642), array<f32, 3>(_e645, _e647, _e649)), _e636);
                                    phi_1156_ = _e632;
                                }
                                let _e659 = phi_1154_;
                                let _e661 = phi_1155_;
                                let _e663 = phi_1156_;
                                if _e659 {
                                    if ((_e661.member_1 & 2147483648u) != 0u) {
                                        phi_1175_ = _e619;
                                        phi_1178_ = type_4(0u, ((_e661.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1046 = phi_1175_;
                                            let _e1048 = phi_1178_;
                                            local_10 = _e1046;
                                            local_13 = _e1046;
                                            if (_e1048.member < _e1048.member_1) {
                                                phi_1179_ = type_4((_e1048.member + 1u), _e1048.member_1);
                                                phi_1201_ = type_4(1u, _e1048.member);
                                            } else {
                                                phi_1179_ = _e1048;
                                                phi_1201_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1061 = phi_1179_;
                                            let _e1063 = phi_1201_;
                                            let _e1067 = (bitcast<i32>(_e1063.member) != 0i);
                                            if _e1067 {
                                                let _e1073 = type_34(_e1046.member, _e1046.member_1, (_e1046.member_2 + 1u));
                                                let _e1074 = ((_e661.member_1 & 268435455u) + _e1063.member_1);
                                                let _e1075 = (_e1074 < arrayLength((&global_6.member)));
                                                if _e1075 {
                                                    if _e1075 {
                                                    } else {
                                                        phi_3531_ = true;
                                                        break;
                                                    }
                                                    let _e1078 = global_6.member[_e1074].member_1;
                                                    phi_1229_ = _e1078;
                                                } else {
                                                    phi_1229_ = 4294967295u;
                                                }
                                                let _e1080 = phi_1229_;
                                                if _e1075 {
                                                    if _e1075 {
                                                    } else {
                                                        phi_3531_ = true;
                                                        break;
                                                    }
                                                    let _e1082 = global_6.member[_e1074];
                                                    phi_1245_ = _e1082;
                                                } else {
                                                    phi_1245_ = type_45(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e1084 = phi_1245_;
                                                let _e1096 = ((10u * _e244) & 31u);
                                                let _e1099 = ((_e1084.member[0] >> bitcast<u32>(_e1096)) & 1023u);
                                                let _e1107 = bitcast<f32>((bitcast<u32>(((_e661.member.member_1[0] - _e661.member.member[0]) * 0.0009775171f)) ^ _e116));
                                                let _e1112 = (_e661.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1099)) - 8388608f) * _e1107)) ^ _e116)));
                                                let _e1116 = select(select(_e661.member.member_1[0], _e1112, (_e1112 < _e661.member.member_1[0])), _e661.member.member_1[0], (_e1099 == 1023u));
                                                let _e1118 = ((10u * _e243) & 31u);
                                                let _e1121 = ((_e1084.member[0] >> bitcast<u32>(_e1118)) & 1023u);
                                                let _e1129 = bitcast<f32>((bitcast<u32>(((_e661.member.member_1[1] - _e661.member.member[1]) * 0.0009775171f)) ^ _e116));
                                                let _e1134 = (_e661.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1121)) - 8388608f) * _e1129)) ^ _e116)));
                                                let _e1138 = select(select(_e661.member.member_1[1], _e1134, (_e1134 < _e661.member.member_1[1])), _e661.member.member_1[1], (_e1121 == 1023u));
                                                let _e1140 = ((10u * _e245) & 31u);
                                                let _e1143 = ((_e1084.member[0] >> bitcast<u32>(_e1140)) & 1023u);
                                                let _e1151 = bitcast<f32>((bitcast<u32>(((_e661.member.member_1[2] - _e661.member.member[2]) * 0.0009775171f)) ^ _e116));
                                                let _e1156 = (_e661.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1143)) - 8388608f) * _e1151)) ^ _e116)));
                                                let _e1160 = select(select(_e661.member.member_1[2], _e1156, (_e1156 < _e661.member.member_1[2])), _e661.member.member_1[2], (_e1143 == 1023u));
                                                let _e1164 = ((_e1084.member[1] >> bitcast<u32>(_e1096)) & 1023u);
                                                let _e1172 = (_e661.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1164)) - 8388608f) * _e1107)) ^ _e116)));
                                                let _e1176 = select(select(_e661.member.member_1[0], _e1172, (_e1172 < _e661.member.member_1[0])), _e661.member.member_1[0], (_e1164 == 1023u));
                                                let _e1179 = ((_e1084.member[1] >> bitcast<u32>(_e1118)) & 1023u);
                                                let _e1187 = (_e661.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1179)) - 8388608f) * _e1129)) ^ _e116)));
                                                let _e1191 = select(select(_e661.member.member_1[1], _e1187, (_e1187 < _e661.member.member_1[1])), _e661.member.member_1[1], (_e1179 == 1023u));
                                                let _e1194 = ((_e1084.member[1] >> bitcast<u32>(_e1140)) & 1023u);
                                                let _e1202 = (_e661.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1194)) - 8388608f) * _e1151)) ^ _e116)));
                                                let _e1206 = select(select(_e661.member.member_1[2], _e1202, (_e1202 < _e661.member.member_1[2])), _e661.member.member_1[2], (_e1194 == 1023u));
                                                let _e1210 = ((_e1084.member[2] >> bitcast<u32>(_e1096)) & 1023u);
                                                let _e1218 = (_e661.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1210)) - 8388608f) * _e1107)) ^ _e116)));
                                                let _e1222 = select(select(_e661.member.member_1[0], _e1218, (_e1218 < _e661.member.member_1[0])), _e661.member.member_1[0], (_e1210 == 1023u));
                                                let _e1225 = ((_e1084.member[2] >> bitcast<u32>(_e1118)) & 1023u);
                                                let _e1233 = (_e661.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1225)) - 8388608f) * _e1129)) ^ _e116)));
                                                let _e1237 = select(select(_e661.member.member_1[1], _e1233, (_e1233 < _e661.member.member_1[1])), _e661.member.member_1[1], (_e1225 == 1023u));
                                                let _e1240 = ((_e1084.member[2] >> bitcast<u32>(_e1140)) & 1023u);
                                                let _e1248 = (_e661.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1240)) - 8388608f) * _e1151)) ^ _e116)));
                                                let _e1252 = select(select(_e661.member.member_1[2], _e1248, (_e1248 < _e661.member.member_1[2])), _e661.member.member_1[2], (_e1240 == 1023u));
                                                let _e1257 = (_e1160 - _e441);
                                                let _e1260 = (((_e1116 - _e308) * _e477) - (_e1257 * _e345));
                                                let _e1263 = (((_e1138 - _e375) * _e477) - (_e1257 * _e411));
                                                let _e1266 = (_e1206 - _e441);
                                                let _e1269 = (((_e1176 - _e308) * _e477) - (_e1266 * _e345));
                                                let _e1272 = (((_e1191 - _e375) * _e477) - (_e1266 * _e411));
                                                let _e1275 = (_e1252 - _e441);
                                                let _e1278 = (((_e1222 - _e308) * _e477) - (_e1275 * _e345));
                                                let _e1281 = (((_e1237 - _e375) * _e477) - (_e1275 * _e411));
                                                let _e1282 = (_e1278 * _e1272);
                                                let _e1283 = (_e1281 * _e1269);
                                                let _e1284 = (_e1260 * _e1281);
                                                let _e1285 = (_e1263 * _e1278);
                                                let _e1286 = (_e1269 * _e1263);
                                                let _e1287 = (_e1272 * _e1260);
                                                let _e1292 = (((_e1282 >= _e1283) && (_e1284 >= _e1285)) && (_e1286 >= _e1287));
                                                let _e1298 = (_e1292 || (((_e1282 <= _e1283) && (_e1284 <= _e1285)) && (_e1286 <= _e1287)));
                                                if _e1298 {
                                                    let _e1300 = select(-1f, 1f, _e1292);
                                                    let _e1302 = ((_e1282 - _e1283) * _e1300);
                                                    let _e1304 = select(0f, _e1302, (_e1302 > 0f));
                                                    let _e1306 = ((_e1284 - _e1285) * _e1300);
                                                    let _e1308 = select(0f, _e1306, (_e1306 > 0f));
                                                    let _e1310 = ((_e1286 - _e1287) * _e1300);
                                                    let _e1312 = select(0f, _e1310, (_e1310 > 0f));
                                                    let _e1314 = ((_e1304 + _e1308) + _e1312);
                                                    let _e1316 = select(_e1176, _e1116, (_e1116 < _e1176));
                                                    let _e1320 = select(_e1176, _e1116, (_e1116 > _e1176));
                                                    let _e1324 = select(_e1191, _e1138, (_e1138 < _e1191));
                                                    let _e1328 = select(_e1191, _e1138, (_e1138 > _e1191));
                                                    let _e1332 = select(_e1206, _e1160, (_e1160 < _e1206));
                                                    let _e1336 = select(_e1206, _e1160, (_e1160 > _e1206));
                                                    let _e1341 = ((select(_e1222, _e1316, (_e1316 < _e1222)) - _e346) * _e349);
                                                    let _e1342 = ((select(_e1222, _e1320, (_e1320 > _e1222)) - _e347) * _e349);
                                                    let _e1345 = ((select(_e1237, _e1324, (_e1324 < _e1237)) - _e412) * _e415);
                                                    let _e1346 = ((select(_e1237, _e1328, (_e1328 > _e1237)) - _e413) * _e415);
                                                    let _e1349 = ((select(_e1252, _e1332, (_e1332 < _e1252)) - _e478) * _e481);
                                                    let _e1350 = ((select(_e1252, _e1336, (_e1336 > _e1252)) - _e479) * _e481);
                                                    let _e1352 = select(_e1350, _e1349, (_e1349 < _e1350));
                                                    let _e1354 = select(_e1350, _e1349, (_e1349 > _e1350));
                                                    let _e1356 = select(_e1342, _e1341, (_e1341 < _e1342));
                                                    let _e1358 = select(_e1346, _e1345, (_e1345 < _e1346));
                                                    let _e1360 = select(_e1358, _e1356, (_e1356 > _e1358));
                                                    let _e1362 = select(_e1352, _e1360, (_e1360 > _e1352));
                                                    let _e1364 = select(_e1342, _e1341, (_e1341 > _e1342));
                                                    let _e1366 = select(_e1346, _e1345, (_e1345 > _e1346));
                                                    let _e1368 = select(_e1366, _e1364, (_e1364 < _e1366));
                                                    let _e1370 = select(_e1354, _e1368, (_e1368 < _e1354));
                                                    let _e1371 = -(_e1352);
                                                    let _e1377 = select(_e584, _e1362, (_e1362 > _e584));
                                                    let _e1381 = select(_e1269, _e1260, (_e1260 < _e1269));
                                                    let _e1386 = select(_e1269, _e1260, (_e1260 > _e1269));
                                                    let _e1393 = select(_e1272, _e1263, (_e1263 < _e1272));
                                                    let _e1398 = select(_e1272, _e1263, (_e1263 > _e1272));
                                                    let _e1407 = (((((_e1298 && (_e1314 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1278, _e1381, (_e1381 < _e1278)) <= 0f) && (select(_e1278, _e1386, (_e1386 > _e1278)) >= 0f))) && ((select(_e1281, _e1393, (_e1393 < _e1281)) <= 0f) && (select(_e1281, _e1398, (_e1398 > _e1281)) >= 0f))) && (_e1377 <= (_e1370 + (select(_e1371, _e1354, (_e1354 > _e1371)) * 0.0000019073523f)))) && (_e1377 <= _e1046.member.member_1));
                                                    if _e1407 {
                                                        let _e1412 = (_e1176 - _e1116);
                                                        let _e1413 = (_e1191 - _e1138);
                                                        let _e1414 = (_e1206 - _e1160);
                                                        let _e1415 = vec3<f32>(_e1412, _e1413, _e1414);
                                                        let _e1416 = (_e1222 - _e1176);
                                                        let _e1417 = (_e1237 - _e1191);
                                                        let _e1418 = (_e1252 - _e1206);
                                                        let _e1419 = vec3<f32>(_e1416, _e1417, _e1418);
                                                        let _e1420 = (_e1116 - _e1222);
                                                        let _e1421 = (_e1138 - _e1237);
                                                        let _e1422 = (_e1160 - _e1252);
                                                        let _e1423 = vec3<f32>(_e1420, _e1421, _e1422);
                                                        let _e1426 = bitcast<f32>((bitcast<u32>(_e1412) & 2147483647u));
                                                        let _e1429 = bitcast<f32>((bitcast<u32>(_e1413) & 2147483647u));
                                                        let _e1431 = select(_e1429, _e1426, (_e1426 > _e1429));
                                                        let _e1434 = bitcast<f32>((bitcast<u32>(_e1414) & 2147483647u));
                                                        let _e1436 = select(_e1434, _e1431, (_e1431 > _e1434));
                                                        let _e1439 = bitcast<f32>((bitcast<u32>(_e1416) & 2147483647u));
                                                        let _e1442 = bitcast<f32>((bitcast<u32>(_e1417) & 2147483647u));
                                                        let _e1444 = select(_e1442, _e1439, (_e1439 > _e1442));
                                                        let _e1447 = bitcast<f32>((bitcast<u32>(_e1418) & 2147483647u));
                                                        let _e1449 = select(_e1447, _e1444, (_e1444 > _e1447));
                                                        let _e1452 = bitcast<f32>((bitcast<u32>(_e1420) & 2147483647u));
                                                        let _e1455 = bitcast<f32>((bitcast<u32>(_e1421) & 2147483647u));
                                                        let _e1457 = select(_e1455, _e1452, (_e1452 > _e1455));
                                                        let _e1460 = bitcast<f32>((bitcast<u32>(_e1422) & 2147483647u));
                                                        let _e1462 = select(_e1460, _e1457, (_e1457 > _e1460));
                                                        let _e1464 = select(_e1449, _e1436, (_e1436 > _e1449));
                                                        let _e1466 = select(_e1462, _e1464, (_e1464 > _e1462));
                                                        if (_e1436 == _e1466) {
                                                            phi_2040_ = _e1272;
                                                            phi_2041_ = _e1269;
                                                            phi_2042_ = _e1263;
                                                            phi_2043_ = _e1260;
                                                            phi_2044_ = vec3<f32>(_e1116, _e1138, _e1160);
                                                            phi_2045_ = _e1423;
                                                            phi_2046_ = _e1419;
                                                            phi_2047_ = _e1415;
                                                        } else {
                                                            let _e1468 = (_e1449 == _e1466);
                                                            let _e1473 = vec3(_e1468);
                                                            phi_2040_ = select(_e1263, _e1281, _e1468);
                                                            phi_2041_ = select(_e1260, _e1278, _e1468);
                                                            phi_2042_ = select(_e1281, _e1272, _e1468);
                                                            phi_2043_ = select(_e1278, _e1269, _e1468);
                                                            phi_2044_ = select(vec3<f32>(_e1222, _e1237, _e1252), vec3<f32>(_e1176, _e1191, _e1206), _e1473);
                                                            phi_2045_ = select(_e1419, _e1415, _e1473);
                                                            phi_2046_ = select(_e1415, _e1423, _e1473);
                                                            phi_2047_ = select(_e1423, _e1419, _e1473);
                                                        }
                                                        let _e1479 = phi_2040_;
                                                        let _e1481 = phi_2041_;
                                                        let _e1483 = phi_2042_;
                                                        let _e1485 = phi_2043_;
                                                        let _e1487 = phi_2044_;
                                                        let _e1489 = phi_2045_;
                                                        let _e1491 = phi_2046_;
                                                        let _e1493 = phi_2047_;
                                                        let _e1500 = ((_e1491.y * _e1489.z) - (_e1489.y * _e1491.z));
                                                        let _e1505 = ((_e1491.z * _e1489.x) - (_e1489.z * _e1491.x));
                                                        let _e1508 = ((_e1491.x * _e1489.y) - (_e1489.x * _e1491.y));
                                                        let _e1511 = ((_e1304 >= _e1308) && (_e1304 >= _e1312));
                                                        let _e1512 = (_e1308 >= _e1312);
                                                        let _e1526 = (((_e1500 * (select(select(_e1222, _e1176, _e1512), _e1116, _e1511) - _e308)) + (_e1505 * (select(select(_e1237, _e1191, _e1512), _e1138, _e1511) - _e375))) + (_e1508 * (select(select(_e1252, _e1206, _e1512), _e1160, _e1511) - _e441)));
                                                        let _e1531 = (((_e1500 * _e345) + (_e1505 * _e411)) + (_e1508 * _e477));
                                                        let _e1532 = (_e1481 - _e1485);
                                                        let _e1533 = (_e1479 - _e1483);
                                                        let _e1536 = ((_e1532 * _e1532) + (_e1533 * _e1533));
                                                        let _e1543 = (-(((_e1485 * _e1532) + (_e1483 * _e1533))) / select(0.000000000000000000000000000000000000011754944f, _e1536, (_e1536 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1545 = select(1f, _e1543, (_e1543 < 1f));
                                                        let _e1547 = select(0f, _e1545, (_e1545 > 0f));
                                                        let _e1556 = ((_e1487.x + (_e1493.x * _e1547)) - _e308);
                                                        let _e1559 = ((_e1487.y + (_e1493.y * _e1547)) - _e375);
                                                        let _e1562 = ((_e1487.z + (_e1493.z * _e1547)) - _e441);
                                                        let _e1565 = bitcast<f32>((bitcast<u32>(_e1556) & 2147483647u));
                                                        let _e1568 = bitcast<f32>((bitcast<u32>(_e1559) & 2147483647u));
                                                        let _e1570 = select(_e1568, _e1565, (_e1565 > _e1568));
                                                        let _e1573 = bitcast<f32>((bitcast<u32>(_e1562) & 2147483647u));
                                                        let _e1575 = select(_e1573, _e1570, (_e1570 > _e1573));
                                                        let _e1581 = bitcast<f32>((bitcast<u32>(_e1500) & 2147483647u));
                                                        let _e1584 = bitcast<f32>((bitcast<u32>(_e1505) & 2147483647u));
                                                        let _e1586 = select(_e1584, _e1581, (_e1581 > _e1584));
                                                        let _e1589 = bitcast<f32>((bitcast<u32>(_e1508) & 2147483647u));
                                                        let _e1608 = bitcast<f32>((bitcast<u32>(_e1491.x) & 2147483647u));
                                                        let _e1611 = bitcast<f32>((bitcast<u32>(_e1491.y) & 2147483647u));
                                                        let _e1613 = select(_e1611, _e1608, (_e1608 > _e1611));
                                                        let _e1616 = bitcast<f32>((bitcast<u32>(_e1491.z) & 2147483647u));
                                                        let _e1622 = bitcast<f32>((bitcast<u32>(_e1489.x) & 2147483647u));
                                                        let _e1625 = bitcast<f32>((bitcast<u32>(_e1489.y) & 2147483647u));
                                                        let _e1627 = select(_e1625, _e1622, (_e1622 > _e1625));
                                                        let _e1630 = bitcast<f32>((bitcast<u32>(_e1489.z) & 2147483647u));
                                                        let _e1636 = ((bitcast<f32>((bitcast<u32>(((((_e1500 * _e1556) + (_e1505 * _e1559)) + (_e1508 * _e1562)) - _e1526)) & 2147483647u)) <= ((0.0000009536743f * select(_e1466, _e1575, (_e1575 > _e1466))) * select(_e1589, _e1586, (_e1586 > _e1589)))) && !((bitcast<f32>((bitcast<u32>(_e1531) & 2147483647u)) <= ((0.0000038146973f * select(_e1616, _e1613, (_e1613 > _e1616))) * select(_e1630, _e1627, (_e1627 > _e1630))))));
                                                        let _e1637 = (_e1526 / _e1531);
                                                        if (_e1407 && !(_e1636)) {
                                                            let _e1640 = (_e1562 / _e477);
                                                            let _e1648 = (((_e1500 * (_e1556 - (_e345 * _e1640))) + (_e1505 * (_e1559 - (_e411 * _e1640)))) / _e1531);
                                                            phi_2238_ = select(select(_e1640, (_e1640 + _e1648), (bitcast<f32>((bitcast<u32>(_e1648) & 2147483647u)) <= _e1466)), _e1637, _e1636);
                                                        } else {
                                                            phi_2238_ = _e1637;
                                                        }
                                                        let _e1657 = phi_2238_;
                                                        let _e1659 = select(_e1370, _e1657, (_e1657 < _e1370));
                                                        let _e1661 = select(_e1362, _e1659, (_e1659 > _e1362));
                                                        let _e1662 = (1f / _e1314);
                                                        phi_2258_ = type_30(_e1661, (_e1308 * _e1662), (_e1312 * _e1662), ((_e1407 && (_e1661 >= _e584)) && (_e1661 <= _e1046.member.member_1)));
                                                        phi_2259_ = type_30();
                                                    } else {
                                                        phi_2258_ = type_30();
                                                        phi_2259_ = type_30(0f, 0f, 0f, _e1407);
                                                    }
                                                    let _e1671 = phi_2258_;
                                                    let _e1673 = phi_2259_;
                                                    phi_2262_ = _e1671;
                                                    phi_2263_ = _e1673;
                                                    phi_2264_ = select(true, false, _e1407);
                                                } else {
                                                    phi_2262_ = type_30();
                                                    phi_2263_ = type_30(0f, 0f, 0f, _e1298);
                                                    phi_2264_ = true;
                                                }
                                                let _e1676 = phi_2262_;
                                                let _e1678 = phi_2263_;
                                                let _e1680 = phi_2264_;
                                                if _e1680 {
                                                    phi_2268_ = _e1678;
                                                } else {
                                                    phi_2268_ = _e1676;
                                                }
                                                let _e1682 = phi_2268_;
                                                if _e1682.member_3 {
                                                    phi_2277_ = type_21(_e1682.member, _e1682.member_1, _e1682.member_2, _e1080);
                                                } else {
                                                    phi_2277_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1689 = phi_2277_;
                                                if (_e1689.member_3 != 4294967295u) {
                                                    if (_e1080 != 4294967295u) {
                                                        if (_e1689.member < _e1046.member.member.member) {
                                                            phi_2303_ = true;
                                                        } else {
                                                            if (_e1689.member == _e1046.member.member.member) {
                                                                phi_2302_ = (_e1689.member_3 < _e1046.member.member.member_3);
                                                            } else {
                                                                phi_2302_ = false;
                                                            }
                                                            let _e1704 = phi_2302_;
                                                            phi_2303_ = _e1704;
                                                        }
                                                        let _e1706 = phi_2303_;
                                                        if _e1706 {
                                                            phi_2310_ = type_34(type_28(_e1689, _e1689.member), _e1073.member_1, _e1073.member_2);
                                                        } else {
                                                            phi_2310_ = _e1073;
                                                        }
                                                        let _e1713 = phi_2310_;
                                                        phi_2311_ = _e1713;
                                                    } else {
                                                        phi_2311_ = _e1073;
                                                    }
                                                    let _e1715 = phi_2311_;
                                                    phi_2312_ = _e1715;
                                                } else {
                                                    phi_2312_ = _e1073;
                                                }
                                                let _e1717 = phi_2312_;
                                                phi_1176_ = _e1717;
                                            } else {
                                                phi_1176_ = type_34();
                                            }
                                            let _e1719 = phi_1176_;
                                            continue;
                                            continuing {
                                                phi_1175_ = _e1719;
                                                phi_1178_ = _e1061;
                                                phi_3531_ = _e617;
                                                break if !(_e1067);
                                            }
                                        }
                                        let _e1722 = phi_3531_;
                                        phi_3702_ = _e1722;
                                        if _e1722 {
                                            break;
                                        }
                                        let _e1724 = local_10;
                                        phi_3706_ = _e1722;
                                        let _e1875 = local_13;
                                        phi_3319_ = _e1875;
                                        phi_3320_ = false;
                                        phi_3321_ = _e661;
                                        phi_3322_ = select(_e663, 0u, (_e584 > _e1724.member.member_1));
                                    } else {
                                        let _e673 = (_e661.member_1 < _e81);
                                        if _e673 {
                                            if _e673 {
                                            } else {
                                                phi_3702_ = true;
                                                break;
                                            }
                                            let _e675 = global_4.member[_e661.member_1];
                                            phi_2333_ = _e675;
                                        } else {
                                            phi_2333_ = type_38(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e677 = phi_2333_;
                                        let _e692 = ((10u * _e244) & 31u);
                                        let _e695 = ((_e677.member[0] >> bitcast<u32>(_e692)) & 1023u);
                                        let _e703 = bitcast<f32>((bitcast<u32>(((_e661.member.member_1[0] - _e661.member.member[0]) * 0.0009775171f)) ^ _e116));
                                        let _e708 = (_e661.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e695)) - 8388608f) * _e703)) ^ _e116)));
                                        let _e712 = select(select(_e661.member.member_1[0], _e708, (_e708 < _e661.member.member_1[0])), _e661.member.member_1[0], (_e695 == 1023u));
                                        let _e714 = ((10u * _e243) & 31u);
                                        let _e717 = ((_e677.member[0] >> bitcast<u32>(_e714)) & 1023u);
                                        let _e725 = bitcast<f32>((bitcast<u32>(((_e661.member.member_1[1] - _e661.member.member[1]) * 0.0009775171f)) ^ _e116));
                                        let _e730 = (_e661.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e717)) - 8388608f) * _e725)) ^ _e116)));
                                        let _e734 = select(select(_e661.member.member_1[1], _e730, (_e730 < _e661.member.member_1[1])), _e661.member.member_1[1], (_e717 == 1023u));
                                        let _e736 = ((10u * _e245) & 31u);
                                        let _e739 = ((_e677.member[0] >> bitcast<u32>(_e736)) & 1023u);
                                        let _e747 = bitcast<f32>((bitcast<u32>(((_e661.member.member_1[2] - _e661.member.member[2]) * 0.0009775171f)) ^ _e116));
                                        let _e752 = (_e661.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e739)) - 8388608f) * _e747)) ^ _e116)));
                                        let _e756 = select(select(_e661.member.member_1[2], _e752, (_e752 < _e661.member.member_1[2])), _e661.member.member_1[2], (_e739 == 1023u));
                                        let _e759 = ((_e677.member[1] >> bitcast<u32>(_e692)) & 1023u);
                                        let _e767 = (_e661.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e759)) - 8388608f) * _e703)) ^ _e116)));
                                        let _e771 = select(select(_e661.member.member_1[0], _e767, (_e767 < _e661.member.member_1[0])), _e661.member.member_1[0], (_e759 == 1023u));
                                        let _e774 = ((_e677.member[1] >> bitcast<u32>(_e714)) & 1023u);
                                        let _e782 = (_e661.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e774)) - 8388608f) * _e725)) ^ _e116)));
                                        let _e786 = select(select(_e661.member.member_1[1], _e782, (_e782 < _e661.member.member_1[1])), _e661.member.member_1[1], (_e774 == 1023u));
                                        let _e789 = ((_e677.member[1] >> bitcast<u32>(_e736)) & 1023u);
                                        let _e797 = (_e661.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e789)) - 8388608f) * _e747)) ^ _e116)));
                                        let _e801 = select(select(_e661.member.member_1[2], _e797, (_e797 < _e661.member.member_1[2])), _e661.member.member_1[2], (_e789 == 1023u));
                                        let _e807 = ((_e677.member_1[0] >> bitcast<u32>(_e692)) & 1023u);
                                        let _e815 = (_e661.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e807)) - 8388608f) * _e703)) ^ _e116)));
                                        let _e819 = select(select(_e661.member.member_1[0], _e815, (_e815 < _e661.member.member_1[0])), _e661.member.member_1[0], (_e807 == 1023u));
                                        let _e822 = ((_e677.member_1[0] >> bitcast<u32>(_e714)) & 1023u);
                                        let _e830 = (_e661.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e822)) - 8388608f) * _e725)) ^ _e116)));
                                        let _e834 = select(select(_e661.member.member_1[1], _e830, (_e830 < _e661.member.member_1[1])), _e661.member.member_1[1], (_e822 == 1023u));
                                        let _e837 = ((_e677.member_1[0] >> bitcast<u32>(_e736)) & 1023u);
                                        let _e845 = (_e661.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e837)) - 8388608f) * _e747)) ^ _e116)));
                                        let _e849 = select(select(_e661.member.member_1[2], _e845, (_e845 < _e661.member.member_1[2])), _e661.member.member_1[2], (_e837 == 1023u));
                                        let _e852 = ((_e677.member_1[1] >> bitcast<u32>(_e692)) & 1023u);
                                        let _e860 = (_e661.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e852)) - 8388608f) * _e703)) ^ _e116)));
                                        let _e864 = select(select(_e661.member.member_1[0], _e860, (_e860 < _e661.member.member_1[0])), _e661.member.member_1[0], (_e852 == 1023u));
                                        let _e867 = ((_e677.member_1[1] >> bitcast<u32>(_e714)) & 1023u);
                                        let _e875 = (_e661.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e867)) - 8388608f) * _e725)) ^ _e116)));
                                        let _e879 = select(select(_e661.member.member_1[1], _e875, (_e875 < _e661.member.member_1[1])), _e661.member.member_1[1], (_e867 == 1023u));
                                        let _e882 = ((_e677.member_1[1] >> bitcast<u32>(_e736)) & 1023u);
                                        let _e890 = (_e661.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e882)) - 8388608f) * _e747)) ^ _e116)));
                                        let _e894 = select(select(_e661.member.member_1[2], _e890, (_e890 < _e661.member.member_1[2])), _e661.member.member_1[2], (_e882 == 1023u));
                                        let _e899 = type_51(type_43(array<f32, 3>(_e712, _e734, _e756), array<f32, 3>(_e771, _e786, _e801)), _e677.member_2);
                                        let _e904 = type_51(type_43(array<f32, 3>(_e819, _e834, _e849), array<f32, 3>(_e864, _e879, _e894)), _e677.member_3);
                                        let _e917 = ((_e712 - _e346) * _e349);
                                        let _e918 = ((_e819 - _e346) * _e349);
                                        let _e919 = ((_e771 - _e347) * _e349);
                                        let _e920 = ((_e864 - _e347) * _e349);
                                        let _e925 = ((_e734 - _e412) * _e415);
                                        let _e926 = ((_e834 - _e412) * _e415);
                                        let _e927 = ((_e786 - _e413) * _e415);
                                        let _e928 = ((_e879 - _e413) * _e415);
                                        let _e933 = ((_e756 - _e478) * _e481);
                                        let _e934 = ((_e849 - _e478) * _e481);
                                        let _e935 = ((_e801 - _e479) * _e481);
                                        let _e936 = ((_e894 - _e479) * _e481);
                                        let _e938 = select(_e935, _e933, (_e933 < _e935));
                                        let _e940 = select(_e936, _e934, (_e934 < _e936));
                                        let _e942 = select(_e935, _e933, (_e933 > _e935));
                                        let _e944 = select(_e936, _e934, (_e934 > _e936));
                                        let _e946 = select(_e919, _e917, (_e917 < _e919));
                                        let _e948 = select(_e920, _e918, (_e918 < _e920));
                                        let _e950 = select(_e927, _e925, (_e925 < _e927));
                                        let _e952 = select(_e928, _e926, (_e926 < _e928));
                                        let _e954 = select(_e950, _e946, (_e946 > _e950));
                                        let _e956 = select(_e952, _e948, (_e948 > _e952));
                                        let _e958 = select(_e938, _e954, (_e954 > _e938));
                                        let _e960 = select(_e940, _e956, (_e956 > _e940));
                                        let _e962 = select(_e919, _e917, (_e917 > _e919));
                                        let _e964 = select(_e920, _e918, (_e918 > _e920));
                                        let _e966 = select(_e927, _e925, (_e925 > _e927));
                                        let _e968 = select(_e928, _e926, (_e926 > _e928));
                                        let _e970 = select(_e966, _e962, (_e962 < _e966));
                                        let _e972 = select(_e968, _e964, (_e964 < _e968));
                                        let _e977 = -(_e938);
                                        let _e978 = -(_e940);
                                        let _e985 = (select(_e942, _e970, (_e970 < _e942)) + (select(_e977, _e942, (_e942 > _e977)) * 0.0000019073523f));
                                        let _e986 = (select(_e944, _e972, (_e972 < _e944)) + (select(_e978, _e944, (_e944 > _e978)) * 0.0000019073523f));
                                        let _e988 = select(_e584, _e958, (_e958 > _e584));
                                        let _e990 = select(_e584, _e960, (_e960 > _e584));
                                        let _e995 = (_e988 <= select(_e619.member.member_1, _e985, (_e985 < _e619.member.member_1)));
                                        let _e996 = (_e990 <= select(_e619.member.member_1, _e986, (_e986 < _e619.member.member_1)));
                                        let _e997 = (_e988 <= _e990);
                                        if _e995 {
                                            if _e996 {
                                                if _e997 {
                                                    phi_3222_ = _e904;
                                                } else {
                                                    phi_3222_ = _e899;
                                                }
                                                let _e999 = phi_3222_;
                                                let _e1006 = (_e663 % 128u);
                                                let _e1007 = (_e1006 < 128u);
                                                if _e1007 {
                                                } else {
                                                    phi_3702_ = true;
                                                    break;
                                                }
                                                local_6[_e1006] = _e999.member_1;
                                                if _e1007 {
                                                } else {
                                                    phi_3702_ = true;
                                                    break;
                                                }
                                                local_5[_e1006] = _e999.member.member[0];
                                                if _e1007 {
                                                } else {
                                                    phi_3702_ = true;
                                                    break;
                                                }
                                                local_4[_e1006] = _e999.member.member[1];
                                                if _e1007 {
                                                } else {
                                                    phi_3702_ = true;
                                                    break;
                                                }
                                                local_3[_e1006] = _e999.member.member[2];
                                                if _e1007 {
                                                } else {
                                                    phi_3702_ = true;
                                                    break;
                                                }
                                                local_2[_e1006] = _e999.member.member_1[0];
                                                if _e1007 {
                                                } else {
                                                    phi_3702_ = true;
                                                    break;
                                                }
                                                local_1[_e1006] = _e999.member.member_1[1];
                                                if _e1007 {
                                                } else {
                                                    phi_3702_ = true;
                                                    break;
                                                }
                                                local[_e1006] = _e999.member.member_1[2];
                                                if _e1007 {
                                                } else {
                                                    phi_3702_ = true;
                                                    break;
                                                }
                                                local_7[_e1006] = select(_e988, _e990, _e997);
                                                if _e997 {
                                                    phi_3298_ = _e899;
                                                } else {
                                                    phi_3298_ = _e904;
                                                }
                                                let _e1024 = phi_3298_;
                                                phi_3299_ = _e1024;
                                                phi_3300_ = (_e663 + 1u);
                                            } else {
                                                phi_3299_ = type_51();
                                                phi_3300_ = u32();
                                            }
                                            let _e1026 = phi_3299_;
                                            let _e1028 = phi_3300_;
                                            phi_3302_ = _e1026;
                                            phi_3303_ = _e1028;
                                            phi_3304_ = select(true, false, _e996);
                                        } else {
                                            phi_3302_ = type_51();
                                            phi_3303_ = u32();
                                            phi_3304_ = true;
                                        }
                                        let _e1031 = phi_3302_;
                                        let _e1033 = phi_3303_;
                                        let _e1035 = phi_3304_;
                                        if _e1035 {
                                            if _e995 {
                                                phi_3311_ = _e899;
                                            } else {
                                                phi_3311_ = _e904;
                                            }
                                            let _e1037 = phi_3311_;
                                            phi_3316_ = select(_e996, true, _e995);
                                            phi_3317_ = _e1037;
                                        } else {
                                            phi_3316_ = _e659;
                                            phi_3317_ = _e1031;
                                        }
                                        let _e1040 = phi_3316_;
                                        let _e1042 = phi_3317_;
                                        phi_3706_ = _e617;
                                        phi_3319_ = type_34(_e619.member, (_e619.member_1 + 1u), _e619.member_2);
                                        phi_3320_ = _e1040;
                                        phi_3321_ = _e1042;
                                        phi_3322_ = select(_e1033, _e663, _e1035);
                                    }
                                    let _e1730 = phi_3706_;
                                    let _e1732 = phi_3319_;
                                    let _e1734 = phi_3320_;
                                    let _e1736 = phi_3321_;
                                    let _e1738 = phi_3322_;
                                    phi_3705_ = _e1730;
                                    phi_3323_ = _e1732;
                                    phi_3324_ = _e1734;
                                    phi_3325_ = _e1736;
                                    phi_3326_ = _e1738;
                                    phi_3327_ = (_e627 - 1u);
                                } else {
                                    phi_3705_ = _e617;
                                    phi_3323_ = _e619;
                                    phi_3324_ = _e659;
                                    phi_3325_ = _e661;
                                    phi_3326_ = _e663;
                                    phi_3327_ = _e627;
                                }
                                let _e1740 = phi_3705_;
                                let _e1742 = phi_3323_;
                                let _e1744 = phi_3324_;
                                let _e1746 = phi_3325_;
                                let _e1748 = phi_3326_;
                                let _e1750 = phi_3327_;
                                phi_3704_ = _e1740;
                                phi_3328_ = _e1742;
                                phi_3329_ = _e1744;
                                phi_3330_ = _e1746;
                                phi_3331_ = _e1748;
                                phi_3332_ = _e1750;
                            } else {
                                phi_3704_ = _e617;
                                phi_3328_ = type_34();
                                phi_3329_ = bool();
                                phi_3330_ = type_51();
                                phi_3331_ = u32();
                                phi_3332_ = u32();
                            }
                            let _e1752 = phi_3704_;
                            let _e1754 = phi_3328_;
                            let _e1756 = phi_3329_;
                            let _e1758 = phi_3330_;
                            let _e1760 = phi_3331_;
                            let _e1762 = phi_3332_;
                            phi_3703_ = _e1752;
                            phi_1049_ = _e1754;
                            phi_1052_ = _e1756;
                            phi_1054_ = _e1758;
                            phi_1056_ = _e1760;
                            phi_1058_ = _e1762;
                            phi_3333_ = _e631;
                        } else {
                            phi_3703_ = _e617;
                            phi_1049_ = type_34();
                            phi_1052_ = bool();
                            phi_1054_ = type_51();
                            phi_1056_ = u32();
                            phi_1058_ = u32();
                            phi_3333_ = false;
                        }
                        let _e1764 = phi_3703_;
                        let _e1766 = phi_1049_;
                        let _e1768 = phi_1052_;
                        let _e1770 = phi_1054_;
                        let _e1772 = phi_1056_;
                        let _e1774 = phi_1058_;
                        let _e1776 = phi_3333_;
                        continue;
                        continuing {
                            phi_3537_ = _e1764;
                            phi_1048_ = _e1766;
                            phi_1051_ = _e1768;
                            phi_1053_ = _e1770;
                            phi_1055_ = _e1772;
                            phi_1057_ = _e1774;
                            phi_3702_ = _e1764;
                            break if !(_e1776);
                        }
                    }
                    let _e1779 = phi_3702_;
                    if _e1779 {
                        break;
                    }
                    let _e1781 = local_11;
                    let _e1784 = local_12;
                    if _e132 {
                    } else {
                        break;
                    }
                    global_5.member[_e130][0u] = _e1781.member_1;
                    global_5.member[_e130][1u] = _e1784.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
