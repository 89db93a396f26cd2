struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_19 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_21 {
    member: array<type_19>,
}

struct type_23 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_24 {
    member: type_23,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_26 {
    member: array<type_24>,
}

struct type_34 {
    member: type_19,
    member_1: f32,
}

struct type_36 {
    member: type_34,
    member_1: u32,
    member_2: u32,
}

struct type_38 {
    member: array<vec4<u32>, 2>,
}

struct type_40 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_42 {
    member: array<type_40>,
}

struct type_45 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_47 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_49 {
    member: array<type_47>,
}

struct type_53 {
    member: type_45,
    member_1: u32,
}

struct type_58 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(4) 
var<storage, read_write> global_1: type_21;
@group(0) @binding(0) 
var<uniform> global_2: type_38;
@group(0) @binding(3) 
var<storage> global_3: type_26;
@group(0) @binding(5) 
var<storage, read_write> global_4: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_5: type_58;
@group(0) @binding(1) 
var<storage> global_6: type_42;
@group(0) @binding(2) 
var<storage> global_7: type_49;

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
    var phi_438_: i32;
    var phi_439_: i32;
    var phi_449_: bool;
    var phi_459_: u32;
    var phi_460_: u32;
    var phi_462_: bool;
    var phi_467_: u32;
    var phi_500_: i32;
    var phi_518_: f32;
    var phi_524_: f32;
    var phi_564_: f32;
    var phi_570_: f32;
    var phi_622_: f32;
    var phi_634_: f32;
    var phi_643_: f32;
    var phi_649_: f32;
    var phi_689_: f32;
    var phi_695_: f32;
    var phi_747_: f32;
    var phi_759_: f32;
    var phi_768_: f32;
    var phi_774_: f32;
    var phi_814_: f32;
    var phi_820_: f32;
    var phi_872_: f32;
    var phi_884_: f32;
    var phi_939_: i32;
    var phi_961_: u32;
    var phi_962_: u32;
    var phi_999_: i32;
    var phi_1021_: u32;
    var phi_1022_: u32;
    var phi_1030_: f32;
    var phi_1031_: f32;
    var phi_3862_: bool;
    var phi_1123_: type_36;
    var phi_1126_: bool;
    var phi_1128_: u32;
    var phi_1130_: u32;
    var phi_1132_: type_53;
    var phi_1143_: bool;
    var phi_1229_: bool;
    var phi_1230_: u32;
    var phi_1231_: type_53;
    var phi_2542_: type_40;
    var phi_3431_: type_53;
    var phi_3508_: type_53;
    var phi_3509_: u32;
    var phi_3510_: type_53;
    var phi_3512_: u32;
    var phi_3513_: type_53;
    var phi_3514_: bool;
    var phi_3521_: type_53;
    var phi_3526_: bool;
    var phi_3528_: type_53;
    var phi_1250_: type_36;
    var phi_1253_: type_7;
    var phi_1254_: type_7;
    var phi_1276_: type_7;
    var phi_1304_: u32;
    var phi_1320_: type_47;
    var phi_1758_: bool;
    var phi_1787_: bool;
    var phi_2182_: f32;
    var phi_2183_: f32;
    var phi_2184_: f32;
    var phi_2185_: f32;
    var phi_2186_: vec3<f32>;
    var phi_2187_: vec3<f32>;
    var phi_2188_: vec3<f32>;
    var phi_2189_: vec3<f32>;
    var phi_2226_: bool;
    var phi_2235_: vec3<f32>;
    var phi_2400_: f32;
    var phi_2402_: f32;
    var phi_2403_: bool;
    var phi_2423_: f32;
    var phi_2424_: f32;
    var phi_2447_: type_19;
    var phi_2449_: type_19;
    var phi_2450_: bool;
    var phi_2454_: type_19;
    var phi_2455_: type_19;
    var phi_2456_: type_19;
    var phi_2457_: bool;
    var phi_2461_: type_19;
    var phi_2462_: bool;
    var phi_2463_: type_19;
    var phi_2464_: bool;
    var phi_2465_: bool;
    var phi_2466_: type_19;
    var phi_2467_: bool;
    var phi_2468_: bool;
    var phi_2476_: type_19;
    var phi_2477_: bool;
    var phi_2481_: type_19;
    var phi_2506_: bool;
    var phi_2507_: bool;
    var phi_2514_: type_36;
    var phi_2515_: type_36;
    var phi_2516_: type_36;
    var phi_1251_: type_36;
    var phi_3856_: bool;
    var phi_4038_: bool;
    var phi_3533_: type_36;
    var phi_3534_: bool;
    var phi_3535_: u32;
    var phi_3536_: type_53;
    var phi_4037_: bool;
    var phi_3537_: type_36;
    var phi_3538_: bool;
    var phi_3539_: u32;
    var phi_3540_: u32;
    var phi_3541_: type_53;
    var phi_4036_: bool;
    var phi_3542_: type_36;
    var phi_3543_: bool;
    var phi_3544_: u32;
    var phi_3545_: u32;
    var phi_3546_: type_53;
    var phi_4035_: bool;
    var phi_1124_: type_36;
    var phi_1127_: bool;
    var phi_1129_: u32;
    var phi_1131_: u32;
    var phi_1133_: type_53;
    var phi_3547_: bool;
    var phi_4034_: bool;
    var local_10: type_36;
    var phi_3585_: f32;
    var phi_3587_: f32;
    var phi_3588_: bool;
    var phi_3589_: f32;
    var phi_3590_: bool;
    var phi_3776_: u32;
    var phi_3794_: bool;
    var phi_3797_: bool;
    var phi_3810_: f32;
    var phi_3811_: f32;
    var phi_3816_: f32;
    var phi_3817_: f32;
    var phi_3818_: bool;
    var phi_3826_: f32;
    var phi_3605_: f32;
    var phi_3606_: f32;
    var phi_3618_: f32;
    var phi_3623_: type_19;
    var local_11: type_36;
    var local_12: type_36;

    switch bitcast<i32>(0u) {
        default: {
            let _e85 = global;
            let _e88 = arrayLength((&global_6.member));
            let _e99 = arrayLength((&global_5.member));
            let _e103 = global_2.member[0u][0u];
            let _e107 = global_2.member[0u][1u];
            let _e111 = global_2.member[0u][2u];
            let _e115 = global_2.member[1u][0u];
            let _e119 = global_2.member[1u][1u];
            let _e123 = global_2.member[1u][2u];
            let _e127 = global_2.member[1u][3u];
            let _e131 = (_e85.x + (_e85.y * 2097152u));
            let _e138 = (_e131 < arrayLength((&global_3.member)));
            if _e138 {
                let _e139 = (_e131 < arrayLength((&global_1.member)));
                if _e139 {
                    let _e140 = (_e131 < arrayLength((&global_4.member)));
                    if _e140 {
                        if _e138 {
                        } else {
                            break;
                        }
                        let _e150 = global_3.member[_e131].member.member_2[0u];
                        let _e152 = (bitcast<u32>(_e150) & 2147483647u);
                        let _e158 = global_3.member[_e131].member.member_2[1u];
                        let _e160 = (bitcast<u32>(_e158) & 2147483647u);
                        let _e166 = global_3.member[_e131].member.member_2[2u];
                        let _e168 = (bitcast<u32>(_e166) & 2147483647u);
                        let _e174 = global_3.member[_e131].member.member[0u];
                        let _e176 = (bitcast<u32>(_e174) & 2147483647u);
                        let _e182 = global_3.member[_e131].member.member[1u];
                        let _e184 = (bitcast<u32>(_e182) & 2147483647u);
                        let _e190 = global_3.member[_e131].member.member[2u];
                        let _e192 = (bitcast<u32>(_e190) & 2147483647u);
                        let _e194 = select(_e160, _e152, (_e160 < _e152));
                        let _e196 = select(_e168, _e194, (_e168 < _e194));
                        let _e198 = select(_e176, _e196, (_e176 < _e196));
                        let _e200 = select(_e184, _e198, (_e184 < _e198));
                        let _e202 = select(_e192, _e200, (_e192 < _e200));
                        let _e207 = global_3.member[_e131].member.member_1;
                        let _e208 = bitcast<u32>(_e207);
                        let _e209 = (_e208 & 2147483647u);
                        let _e217 = global_3.member[_e131].member.member_3;
                        let _e218 = bitcast<u32>(_e217);
                        let _e219 = (_e218 & 2147483647u);
                        let _e223 = (((select(_e209, _e202, (_e209 < _e202)) < 2139095040u) && (_e219 <= 2139095040u)) && (_e196 > 0u));
                        if _e223 {
                            let _e226 = (bitcast<u32>(bitcast<f32>(_e196)) & 2147483647u);
                            if (_e226 >= 8388608u) {
                                phi_438_ = (bitcast<i32>((_e226 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_438_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e226)), 32u, (_e226 == 0u))));
                            }
                            let _e240 = phi_438_;
                            phi_439_ = _e240;
                        } else {
                            phi_439_ = 0i;
                        }
                        let _e242 = phi_439_;
                        let _e243 = (_e152 == _e196);
                        if _e243 {
                            phi_449_ = true;
                        } else {
                            phi_449_ = (_e160 == _e196);
                        }
                        let _e246 = phi_449_;
                        let _e247 = select(1u, 0u, _e243);
                        if _e246 {
                            let _e248 = (_e247 + 1u);
                            phi_459_ = _e248;
                            phi_460_ = _e248;
                            phi_462_ = select(true, false, (_e248 == 2u));
                        } else {
                            phi_459_ = u32();
                            phi_460_ = 0u;
                            phi_462_ = true;
                        }
                        let _e252 = phi_459_;
                        let _e254 = phi_460_;
                        let _e256 = phi_462_;
                        if _e256 {
                            phi_467_ = (_e254 + 1u);
                        } else {
                            phi_467_ = 0u;
                        }
                        let _e260 = phi_467_;
                        let _e261 = select(_e252, _e254, _e256);
                        let _e262 = select(_e247, select(2u, _e247, _e246), _e256);
                        let _e263 = -(_e242);
                        if (_e263 < -126i) {
                            phi_500_ = -126i;
                        } else {
                            phi_500_ = select(_e263, 127i, (_e263 > 127i));
                        }
                        let _e268 = phi_500_;
                        let _e273 = bitcast<f32>((bitcast<u32>((_e268 + 127i)) << bitcast<u32>(23i)));
                        let _e279 = bitcast<f32>((bitcast<u32>(((_e263 - _e268) + 127i)) << bitcast<u32>(23i)));
                        let _e284 = global_3.member[_e131].member.member;
                        let _e285 = (_e261 == 0u);
                        if _e285 {
                            phi_518_ = _e284[0];
                        } else {
                            phi_518_ = _e284[1];
                        }
                        let _e289 = phi_518_;
                        let _e290 = (_e261 == 2u);
                        if _e290 {
                            phi_524_ = _e284[2];
                        } else {
                            phi_524_ = _e289;
                        }
                        let _e293 = phi_524_;
                        let _e294 = bitcast<u32>(_e293);
                        let _e296 = ((_e294 & 2139095040u) != 0u);
                        let _e308 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e294 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e294 & 2147483648u))), _e293, _e296) * select(0.00000011920929f, 1f, _e296));
                        let _e309 = global_3.member[_e131].member.member_2;
                        if _e285 {
                            phi_564_ = _e309[0];
                        } else {
                            phi_564_ = _e309[1];
                        }
                        let _e313 = phi_564_;
                        if _e290 {
                            phi_570_ = _e309[2];
                        } else {
                            phi_570_ = _e313;
                        }
                        let _e316 = phi_570_;
                        let _e317 = bitcast<u32>(_e316);
                        let _e319 = ((_e317 & 2139095040u) != 0u);
                        let _e333 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e317 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e317 & 2147483648u))), _e316, _e319) * _e273) * select(0.00000011920929f, 1f, _e319)) * _e279);
                        let _e337 = (bitcast<f32>((bitcast<u32>(_e333) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e337 {
                            let _e341 = (bitcast<f32>((bitcast<u32>(_e308) & 2147483647u)) * 0.00000011920929f);
                            phi_622_ = select(0.00000000000011368684f, _e341, (_e341 > 0.00000000000011368684f));
                        } else {
                            phi_622_ = 0f;
                        }
                        let _e345 = phi_622_;
                        let _e346 = (_e308 + _e345);
                        let _e347 = (_e308 - _e345);
                        let _e348 = select(_e333, 0f, _e337);
                        if _e337 {
                            phi_634_ = 38685626000000000000000000f;
                        } else {
                            phi_634_ = (1f / _e333);
                        }
                        let _e351 = phi_634_;
                        let _e352 = (_e260 == 0u);
                        if _e352 {
                            phi_643_ = _e284[0];
                        } else {
                            phi_643_ = _e284[1];
                        }
                        let _e356 = phi_643_;
                        let _e357 = (_e260 == 2u);
                        if _e357 {
                            phi_649_ = _e284[2];
                        } else {
                            phi_649_ = _e356;
                        }
                        let _e360 = phi_649_;
                        let _e361 = bitcast<u32>(_e360);
                        let _e363 = ((_e361 & 2139095040u) != 0u);
                        let _e375 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e361 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e361 & 2147483648u))), _e360, _e363) * select(0.00000011920929f, 1f, _e363));
                        if _e352 {
                            phi_689_ = _e309[0];
                        } else {
                            phi_689_ = _e309[1];
                        }
                        let _e379 = phi_689_;
                        if _e357 {
                            phi_695_ = _e309[2];
                        } else {
                            phi_695_ = _e379;
                        }
                        let _e382 = phi_695_;
                        let _e383 = bitcast<u32>(_e382);
                        let _e385 = ((_e383 & 2139095040u) != 0u);
                        let _e399 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e383 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e383 & 2147483648u))), _e382, _e385) * _e273) * select(0.00000011920929f, 1f, _e385)) * _e279);
                        let _e403 = (bitcast<f32>((bitcast<u32>(_e399) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e403 {
                            let _e407 = (bitcast<f32>((bitcast<u32>(_e375) & 2147483647u)) * 0.00000011920929f);
                            phi_747_ = select(0.00000000000011368684f, _e407, (_e407 > 0.00000000000011368684f));
                        } else {
                            phi_747_ = 0f;
                        }
                        let _e411 = phi_747_;
                        let _e412 = (_e375 + _e411);
                        let _e413 = (_e375 - _e411);
                        let _e414 = select(_e399, 0f, _e403);
                        if _e403 {
                            phi_759_ = 38685626000000000000000000f;
                        } else {
                            phi_759_ = (1f / _e399);
                        }
                        let _e417 = phi_759_;
                        let _e418 = (_e262 == 0u);
                        if _e418 {
                            phi_768_ = _e284[0];
                        } else {
                            phi_768_ = _e284[1];
                        }
                        let _e422 = phi_768_;
                        let _e423 = (_e262 == 2u);
                        if _e423 {
                            phi_774_ = _e284[2];
                        } else {
                            phi_774_ = _e422;
                        }
                        let _e426 = phi_774_;
                        let _e427 = bitcast<u32>(_e426);
                        let _e429 = ((_e427 & 2139095040u) != 0u);
                        let _e441 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e427 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e427 & 2147483648u))), _e426, _e429) * select(0.00000011920929f, 1f, _e429));
                        if _e418 {
                            phi_814_ = _e309[0];
                        } else {
                            phi_814_ = _e309[1];
                        }
                        let _e445 = phi_814_;
                        if _e423 {
                            phi_820_ = _e309[2];
                        } else {
                            phi_820_ = _e445;
                        }
                        let _e448 = phi_820_;
                        let _e449 = bitcast<u32>(_e448);
                        let _e451 = ((_e449 & 2139095040u) != 0u);
                        let _e465 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e449 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e449 & 2147483648u))), _e448, _e451) * _e273) * select(0.00000011920929f, 1f, _e451)) * _e279);
                        let _e469 = (bitcast<f32>((bitcast<u32>(_e465) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e469 {
                            let _e473 = (bitcast<f32>((bitcast<u32>(_e441) & 2147483647u)) * 0.00000011920929f);
                            phi_872_ = select(0.00000000000011368684f, _e473, (_e473 > 0.00000000000011368684f));
                        } else {
                            phi_872_ = 0f;
                        }
                        let _e477 = phi_872_;
                        let _e478 = (_e441 + _e477);
                        let _e479 = (_e441 - _e477);
                        let _e480 = select(_e465, 0f, _e469);
                        if _e469 {
                            phi_884_ = 38685626000000000000000000f;
                        } else {
                            phi_884_ = (1f / _e465);
                        }
                        let _e483 = phi_884_;
                        let _e486 = bitcast<f32>((bitcast<u32>(_e308) & 2147483647u));
                        let _e489 = bitcast<f32>((bitcast<u32>(_e375) & 2147483647u));
                        let _e491 = select(_e489, _e486, (_e486 > _e489));
                        let _e494 = bitcast<f32>((bitcast<u32>(_e441) & 2147483647u));
                        if (_e223 && (select(_e494, _e491, (_e491 > _e494)) <= 1099511600000f)) {
                            let _e506 = ((_e209 & 8388607u) | (select(0u, 1u, ((_e209 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e509 = bitcast<i32>((_e209 >> bitcast<u32>(23i)));
                            let _e513 = (_e506 == 0u);
                            let _e516 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e506)), 32u, _e513)) - 8i);
                            if (_e509 == 255i) {
                                phi_939_ = 255i;
                            } else {
                                phi_939_ = (((_e509 + select(0i, 1i, (_e509 == 0i))) - _e516) + _e242);
                            }
                            let _e524 = phi_939_;
                            let _e534 = (_e524 <= 0i);
                            if _e534 {
                                phi_962_ = u32();
                            } else {
                                if _e513 {
                                    phi_961_ = u32();
                                } else {
                                    phi_961_ = select(((bitcast<u32>(_e524) << bitcast<u32>(23i)) | ((_e506 << bitcast<u32>(((_e516 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e524 >= 255i));
                                }
                                let _e538 = phi_961_;
                                phi_962_ = _e538;
                            }
                            let _e540 = phi_962_;
                            let _e552 = ((_e219 & 8388607u) | (select(0u, 1u, ((_e219 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e555 = bitcast<i32>((_e219 >> bitcast<u32>(23i)));
                            let _e559 = (_e552 == 0u);
                            let _e562 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e552)), 32u, _e559)) - 8i);
                            if (_e555 == 255i) {
                                phi_999_ = 255i;
                            } else {
                                phi_999_ = (((_e555 + select(0i, 1i, (_e555 == 0i))) - _e562) + _e242);
                            }
                            let _e570 = phi_999_;
                            let _e580 = (_e570 <= 0i);
                            if _e580 {
                                phi_1022_ = u32();
                            } else {
                                if _e559 {
                                    phi_1021_ = u32();
                                } else {
                                    phi_1021_ = select(((bitcast<u32>(_e570) << bitcast<u32>(23i)) | ((_e552 << bitcast<u32>(((_e562 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e570 >= 255i));
                                }
                                let _e584 = phi_1021_;
                                phi_1022_ = _e584;
                            }
                            let _e586 = phi_1022_;
                            phi_1030_ = bitcast<f32>(((_e218 & 2147483648u) | select(_e586, 0u, select(_e559, true, _e580))));
                            phi_1031_ = bitcast<f32>(((_e208 & 2147483648u) | select(_e540, 0u, select(_e513, true, _e534))));
                        } else {
                            phi_1030_ = 0f;
                            phi_1031_ = 1f;
                        }
                        let _e592 = phi_1030_;
                        let _e594 = phi_1031_;
                        if _e138 {
                        } else {
                            break;
                        }
                        let _e600 = global_3.member[_e131].member_2;
                        local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 3>(bitcast<f32>(_e103), bitcast<f32>(_e107), bitcast<f32>(_e111));
                        let _e604 = (_e261 % 3u);
                        let _e605 = (_e604 < 3u);
                        if _e605 {
                        } else {
                            break;
                        }
                        let _e607 = local_9[_e604];
                        let _e608 = (_e260 % 3u);
                        let _e609 = (_e608 < 3u);
                        if _e609 {
                        } else {
                            break;
                        }
                        let _e611 = local_9[_e608];
                        let _e612 = (_e262 % 3u);
                        let _e613 = (_e612 < 3u);
                        if _e613 {
                        } else {
                            break;
                        }
                        let _e615 = local_9[_e612];
                        local_8 = array<f32, 3>(bitcast<f32>(_e115), bitcast<f32>(_e119), bitcast<f32>(_e123));
                        if _e605 {
                        } else {
                            break;
                        }
                        let _e619 = local_8[_e604];
                        if _e609 {
                        } else {
                            break;
                        }
                        let _e621 = local_8[_e608];
                        if _e613 {
                        } else {
                            break;
                        }
                        let _e623 = local_8[_e612];
                        phi_3862_ = false;
                        phi_1123_ = type_36(type_34(type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e592), 0u, 0u);
                        phi_1126_ = (_e594 <= _e592);
                        phi_1128_ = ((3u * _e88) + 1u);
                        phi_1130_ = 0u;
                        phi_1132_ = type_53(type_45(array<f32, 3>(_e607, _e611, _e615), array<f32, 3>(_e619, _e621, _e623)), select(0u, 2147483648u, (_e88 == 0u)));
                        loop {
                            let _e631 = phi_3862_;
                            let _e633 = phi_1123_;
                            let _e635 = phi_1126_;
                            let _e637 = phi_1128_;
                            let _e639 = phi_1130_;
                            let _e641 = phi_1132_;
                            local_10 = _e633;
                            local_11 = _e633;
                            if _e635 {
                                phi_1143_ = true;
                            } else {
                                phi_1143_ = (_e639 > 0u);
                            }
                            let _e644 = phi_1143_;
                            if _e644 {
                                let _e645 = (_e637 > 0u);
                                if _e645 {
                                    if _e635 {
                                        phi_1229_ = _e635;
                                        phi_1230_ = _e639;
                                        phi_1231_ = _e641;
                                    } else {
                                        let _e646 = (_e639 - 1u);
                                        let _e647 = (_e646 % 128u);
                                        let _e648 = (_e647 < 128u);
                                        if _e648 {
                                        } else {
                                            phi_4034_ = true;
                                            break;
                                        }
                                        let _e650 = local_6[_e647];
                                        if _e648 {
                                        } else {
                                            phi_4034_ = true;
                                            break;
                                        }
                                        let _e652 = local_5[_e647];
                                        if _e648 {
                                        } else {
                                            phi_4034_ = true;
                                            break;
                                        }
                                        let _e654 = local_4[_e647];
                                        if _e648 {
                                        } else {
                                            phi_4034_ = true;
                                            break;
                                        }
                                        let _e656 = local_3[_e647];
                                        if _e648 {
                                        } else {
                                            phi_4034_ = true;
                                            break;
                                        }
                                        let _e659 = local_2[_e647];
                                        if _e648 {
                                        } else {
                                            phi_4034_ = true;
                                            break;
                                        }
                                        let _e661 = local_1[_e647];
                                        if _e648 {
                                        } else {
                                            phi_4034_ = true;
                                            break;
                                        }
                                        let _e663 = local[_e647];
                                        if _e648 {
                                        } else {
                                            phi_4034_ = true;
                                            break;
                                        }
                                        let _e668 = local_7[_e647];
                                        phi_1229_ = (_e668 <= _e633.member.member_1);
                                        phi_1230_ = _e646;
                                        phi_1231_ = type_53(type_45(array<f32, 3>(_e652, _e654, _e656), array<f32, 3>(_e659, _e661, _e663)), _e650);
                                    }
                                    let _e673 = phi_1229_;
                                    let _e675 = phi_1230_;
                                    let _e677 = phi_1231_;
                                    if _e673 {
                                        if ((_e677.member_1 & 2147483648u) != 0u) {
                                            phi_1250_ = _e633;
                                            phi_1253_ = type_7(0u, ((_e677.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1061 = phi_1250_;
                                                let _e1063 = phi_1253_;
                                                local_12 = _e1061;
                                                if (_e1063.member < _e1063.member_1) {
                                                    phi_1254_ = type_7((_e1063.member + 1u), _e1063.member_1);
                                                    phi_1276_ = type_7(1u, _e1063.member);
                                                } else {
                                                    phi_1254_ = _e1063;
                                                    phi_1276_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e1076 = phi_1254_;
                                                let _e1078 = phi_1276_;
                                                let _e1082 = (bitcast<i32>(_e1078.member) != 0i);
                                                if _e1082 {
                                                    let _e1088 = type_36(_e1061.member, _e1061.member_1, (_e1061.member_2 + 1u));
                                                    let _e1089 = ((_e677.member_1 & 268435455u) + _e1078.member_1);
                                                    let _e1090 = (_e1089 < arrayLength((&global_7.member)));
                                                    if _e1090 {
                                                        if _e1090 {
                                                        } else {
                                                            phi_3856_ = true;
                                                            break;
                                                        }
                                                        let _e1093 = global_7.member[_e1089].member_1;
                                                        phi_1304_ = _e1093;
                                                    } else {
                                                        phi_1304_ = 4294967295u;
                                                    }
                                                    let _e1095 = phi_1304_;
                                                    if _e1090 {
                                                        if _e1090 {
                                                        } else {
                                                            phi_3856_ = true;
                                                            break;
                                                        }
                                                        let _e1097 = global_7.member[_e1089];
                                                        phi_1320_ = _e1097;
                                                    } else {
                                                        phi_1320_ = type_47(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                    }
                                                    let _e1099 = phi_1320_;
                                                    let _e1111 = ((10u * _e261) & 31u);
                                                    let _e1114 = ((_e1099.member[0] >> bitcast<u32>(_e1111)) & 1023u);
                                                    let _e1122 = bitcast<f32>((bitcast<u32>(((_e677.member.member_1[0] - _e677.member.member[0]) * 0.0009775171f)) ^ _e127));
                                                    let _e1127 = (_e677.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1114)) - 8388608f) * _e1122)) ^ _e127)));
                                                    let _e1131 = select(select(_e677.member.member_1[0], _e1127, (_e1127 < _e677.member.member_1[0])), _e677.member.member_1[0], (_e1114 == 1023u));
                                                    let _e1133 = ((10u * _e260) & 31u);
                                                    let _e1136 = ((_e1099.member[0] >> bitcast<u32>(_e1133)) & 1023u);
                                                    let _e1144 = bitcast<f32>((bitcast<u32>(((_e677.member.member_1[1] - _e677.member.member[1]) * 0.0009775171f)) ^ _e127));
                                                    let _e1149 = (_e677.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1136)) - 8388608f) * _e1144)) ^ _e127)));
                                                    let _e1153 = select(select(_e677.member.member_1[1], _e1149, (_e1149 < _e677.member.member_1[1])), _e677.member.member_1[1], (_e1136 == 1023u));
                                                    let _e1155 = ((10u * _e262) & 31u);
                                                    let _e1158 = ((_e1099.member[0] >> bitcast<u32>(_e1155)) & 1023u);
                                                    let _e1166 = bitcast<f32>((bitcast<u32>(((_e677.member.member_1[2] - _e677.member.member[2]) * 0.0009775171f)) ^ _e127));
                                                    let _e1171 = (_e677.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1158)) - 8388608f) * _e1166)) ^ _e127)));
                                                    let _e1175 = select(select(_e677.member.member_1[2], _e1171, (_e1171 < _e677.member.member_1[2])), _e677.member.member_1[2], (_e1158 == 1023u));
                                                    let _e1179 = ((_e1099.member[1] >> bitcast<u32>(_e1111)) & 1023u);
                                                    let _e1187 = (_e677.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1179)) - 8388608f) * _e1122)) ^ _e127)));
                                                    let _e1191 = select(select(_e677.member.member_1[0], _e1187, (_e1187 < _e677.member.member_1[0])), _e677.member.member_1[0], (_e1179 == 1023u));
                                                    let _e1194 = ((_e1099.member[1] >> bitcast<u32>(_e1133)) & 1023u);
                                                    let _e1202 = (_e677.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1194)) - 8388608f) * _e1144)) ^ _e127)));
                                                    let _e1206 = select(select(_e677.member.member_1[1], _e1202, (_e1202 < _e677.member.member_1[1])), _e677.member.member_1[1], (_e1194 == 1023u));
                                                    let _e1209 = ((_e1099.member[1] >> bitcast<u32>(_e1155)) & 1023u);
                                                    let _e1217 = (_e677.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1209)) - 8388608f) * _e1166)) ^ _e127)));
                                                    let _e1221 = select(select(_e677.member.member_1[2], _e1217, (_e1217 < _e677.member.member_1[2])), _e677.member.member_1[2], (_e1209 == 1023u));
                                                    let _e1225 = ((_e1099.member[2] >> bitcast<u32>(_e1111)) & 1023u);
                                                    let _e1233 = (_e677.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1225)) - 8388608f) * _e1122)) ^ _e127)));
                                                    let _e1237 = select(select(_e677.member.member_1[0], _e1233, (_e1233 < _e677.member.member_1[0])), _e677.member.member_1[0], (_e1225 == 1023u));
                                                    let _e1240 = ((_e1099.member[2] >> bitcast<u32>(_e1133)) & 1023u);
                                                    let _e1248 = (_e677.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1240)) - 8388608f) * _e1144)) ^ _e127)));
                                                    let _e1252 = select(select(_e677.member.member_1[1], _e1248, (_e1248 < _e677.member.member_1[1])), _e677.member.member_1[1], (_e1240 == 1023u));
                                                    let _e1255 = ((_e1099.member[2] >> bitcast<u32>(_e1155)) & 1023u);
                                                    let _e1263 = (_e677.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1255)) - 8388608f) * _e1166)) ^ _e127)));
                                                    let _e1267 = select(select(_e677.member.member_1[2], _e1263, (_e1263 < _e677.member.member_1[2])), _e677.member.member_1[2], (_e1255 == 1023u));
                                                    let _e1272 = (_e1175 - _e441);
                                                    let _e1275 = (((_e1131 - _e308) * _e480) - (_e1272 * _e348));
                                                    let _e1278 = (((_e1153 - _e375) * _e480) - (_e1272 * _e414));
                                                    let _e1281 = (_e1221 - _e441);
                                                    let _e1284 = (((_e1191 - _e308) * _e480) - (_e1281 * _e348));
                                                    let _e1287 = (((_e1206 - _e375) * _e480) - (_e1281 * _e414));
                                                    let _e1290 = (_e1267 - _e441);
                                                    let _e1293 = (((_e1237 - _e308) * _e480) - (_e1290 * _e348));
                                                    let _e1296 = (((_e1252 - _e375) * _e480) - (_e1290 * _e414));
                                                    let _e1297 = (_e1293 * _e1287);
                                                    let _e1298 = (_e1296 * _e1284);
                                                    let _e1299 = (_e1275 * _e1296);
                                                    let _e1300 = (_e1278 * _e1293);
                                                    let _e1301 = (_e1284 * _e1278);
                                                    let _e1302 = (_e1287 * _e1275);
                                                    let _e1307 = (((_e1297 >= _e1298) && (_e1299 >= _e1300)) && (_e1301 >= _e1302));
                                                    if (_e1307 || (((_e1297 <= _e1298) && (_e1299 <= _e1300)) && (_e1301 <= _e1302))) {
                                                        let _e1314 = select(-1f, 1f, _e1307);
                                                        let _e1316 = ((_e1297 - _e1298) * _e1314);
                                                        let _e1318 = select(0f, _e1316, (_e1316 > 0f));
                                                        let _e1320 = ((_e1299 - _e1300) * _e1314);
                                                        let _e1322 = select(0f, _e1320, (_e1320 > 0f));
                                                        let _e1324 = ((_e1301 - _e1302) * _e1314);
                                                        let _e1326 = select(0f, _e1324, (_e1324 > 0f));
                                                        let _e1328 = ((_e1318 + _e1322) + _e1326);
                                                        if (_e1328 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2466_ = type_19();
                                                            phi_2467_ = true;
                                                            phi_2468_ = false;
                                                        } else {
                                                            let _e1331 = select(_e1284, _e1275, (_e1275 < _e1284));
                                                            if (select(_e1293, _e1331, (_e1331 < _e1293)) > 0f) {
                                                                phi_1758_ = true;
                                                            } else {
                                                                let _e1336 = select(_e1284, _e1275, (_e1275 > _e1284));
                                                                phi_1758_ = (select(_e1293, _e1336, (_e1336 > _e1293)) < 0f);
                                                            }
                                                            let _e1341 = phi_1758_;
                                                            if _e1341 {
                                                                phi_2463_ = type_19();
                                                                phi_2464_ = true;
                                                                phi_2465_ = false;
                                                            } else {
                                                                let _e1343 = select(_e1287, _e1278, (_e1278 < _e1287));
                                                                if (select(_e1296, _e1343, (_e1343 < _e1296)) > 0f) {
                                                                    phi_1787_ = true;
                                                                } else {
                                                                    let _e1348 = select(_e1287, _e1278, (_e1278 > _e1287));
                                                                    phi_1787_ = (select(_e1296, _e1348, (_e1348 > _e1296)) < 0f);
                                                                }
                                                                let _e1353 = phi_1787_;
                                                                if _e1353 {
                                                                    phi_2461_ = type_19();
                                                                    phi_2462_ = false;
                                                                } else {
                                                                    let _e1355 = select(_e1191, _e1131, (_e1131 < _e1191));
                                                                    let _e1359 = select(_e1191, _e1131, (_e1131 > _e1191));
                                                                    let _e1363 = select(_e1206, _e1153, (_e1153 < _e1206));
                                                                    let _e1367 = select(_e1206, _e1153, (_e1153 > _e1206));
                                                                    let _e1371 = select(_e1221, _e1175, (_e1175 < _e1221));
                                                                    let _e1375 = select(_e1221, _e1175, (_e1175 > _e1221));
                                                                    let _e1380 = ((select(_e1237, _e1355, (_e1355 < _e1237)) - _e346) * _e351);
                                                                    let _e1381 = ((select(_e1237, _e1359, (_e1359 > _e1237)) - _e347) * _e351);
                                                                    let _e1384 = ((select(_e1252, _e1363, (_e1363 < _e1252)) - _e412) * _e417);
                                                                    let _e1385 = ((select(_e1252, _e1367, (_e1367 > _e1252)) - _e413) * _e417);
                                                                    let _e1388 = ((select(_e1267, _e1371, (_e1371 < _e1267)) - _e478) * _e483);
                                                                    let _e1389 = ((select(_e1267, _e1375, (_e1375 > _e1267)) - _e479) * _e483);
                                                                    let _e1391 = select(_e1389, _e1388, (_e1388 < _e1389));
                                                                    let _e1393 = select(_e1389, _e1388, (_e1388 > _e1389));
                                                                    let _e1395 = select(_e1381, _e1380, (_e1380 < _e1381));
                                                                    let _e1397 = select(_e1385, _e1384, (_e1384 < _e1385));
                                                                    let _e1399 = select(_e1397, _e1395, (_e1395 > _e1397));
                                                                    let _e1401 = select(_e1391, _e1399, (_e1399 > _e1391));
                                                                    let _e1403 = select(_e1381, _e1380, (_e1380 > _e1381));
                                                                    let _e1405 = select(_e1385, _e1384, (_e1384 > _e1385));
                                                                    let _e1407 = select(_e1405, _e1403, (_e1403 < _e1405));
                                                                    let _e1409 = select(_e1393, _e1407, (_e1407 < _e1393));
                                                                    let _e1410 = -(_e1391);
                                                                    let _e1416 = select(_e594, _e1401, (_e1401 > _e594));
                                                                    if (_e1416 > (_e1409 + (select(_e1410, _e1393, (_e1393 > _e1410)) * 0.0000019073523f))) {
                                                                        phi_2456_ = type_19();
                                                                        phi_2457_ = true;
                                                                    } else {
                                                                        let _e1418 = (_e1416 > _e1061.member.member_1);
                                                                        if _e1418 {
                                                                            phi_2455_ = type_19();
                                                                        } else {
                                                                            let _e1419 = vec3<f32>(_e1131, _e1153, _e1175);
                                                                            let _e1420 = vec3<f32>(_e1191, _e1206, _e1221);
                                                                            let _e1421 = vec3<f32>(_e1237, _e1252, _e1267);
                                                                            let _e1422 = (_e1191 - _e1131);
                                                                            let _e1423 = (_e1206 - _e1153);
                                                                            let _e1424 = (_e1221 - _e1175);
                                                                            let _e1425 = vec3<f32>(_e1422, _e1423, _e1424);
                                                                            let _e1426 = (_e1237 - _e1191);
                                                                            let _e1427 = (_e1252 - _e1206);
                                                                            let _e1428 = (_e1267 - _e1221);
                                                                            let _e1429 = vec3<f32>(_e1426, _e1427, _e1428);
                                                                            let _e1430 = (_e1131 - _e1237);
                                                                            let _e1431 = (_e1153 - _e1252);
                                                                            let _e1432 = (_e1175 - _e1267);
                                                                            let _e1433 = vec3<f32>(_e1430, _e1431, _e1432);
                                                                            let _e1436 = bitcast<f32>((bitcast<u32>(_e1422) & 2147483647u));
                                                                            let _e1439 = bitcast<f32>((bitcast<u32>(_e1423) & 2147483647u));
                                                                            let _e1441 = select(_e1439, _e1436, (_e1436 > _e1439));
                                                                            let _e1444 = bitcast<f32>((bitcast<u32>(_e1424) & 2147483647u));
                                                                            let _e1446 = select(_e1444, _e1441, (_e1441 > _e1444));
                                                                            let _e1449 = bitcast<f32>((bitcast<u32>(_e1426) & 2147483647u));
                                                                            let _e1452 = bitcast<f32>((bitcast<u32>(_e1427) & 2147483647u));
                                                                            let _e1454 = select(_e1452, _e1449, (_e1449 > _e1452));
                                                                            let _e1457 = bitcast<f32>((bitcast<u32>(_e1428) & 2147483647u));
                                                                            let _e1459 = select(_e1457, _e1454, (_e1454 > _e1457));
                                                                            let _e1462 = bitcast<f32>((bitcast<u32>(_e1430) & 2147483647u));
                                                                            let _e1465 = bitcast<f32>((bitcast<u32>(_e1431) & 2147483647u));
                                                                            let _e1467 = select(_e1465, _e1462, (_e1462 > _e1465));
                                                                            let _e1470 = bitcast<f32>((bitcast<u32>(_e1432) & 2147483647u));
                                                                            let _e1472 = select(_e1470, _e1467, (_e1467 > _e1470));
                                                                            let _e1474 = select(_e1459, _e1446, (_e1446 > _e1459));
                                                                            let _e1476 = select(_e1472, _e1474, (_e1474 > _e1472));
                                                                            if (_e1446 == _e1476) {
                                                                                phi_2182_ = _e1287;
                                                                                phi_2183_ = _e1284;
                                                                                phi_2184_ = _e1278;
                                                                                phi_2185_ = _e1275;
                                                                                phi_2186_ = _e1419;
                                                                                phi_2187_ = _e1433;
                                                                                phi_2188_ = _e1429;
                                                                                phi_2189_ = _e1425;
                                                                            } else {
                                                                                let _e1478 = (_e1459 == _e1476);
                                                                                let _e1483 = vec3(_e1478);
                                                                                phi_2182_ = select(_e1278, _e1296, _e1478);
                                                                                phi_2183_ = select(_e1275, _e1293, _e1478);
                                                                                phi_2184_ = select(_e1296, _e1287, _e1478);
                                                                                phi_2185_ = select(_e1293, _e1284, _e1478);
                                                                                phi_2186_ = select(_e1421, _e1420, _e1483);
                                                                                phi_2187_ = select(_e1429, _e1425, _e1483);
                                                                                phi_2188_ = select(_e1425, _e1433, _e1483);
                                                                                phi_2189_ = select(_e1433, _e1429, _e1483);
                                                                            }
                                                                            let _e1489 = phi_2182_;
                                                                            let _e1491 = phi_2183_;
                                                                            let _e1493 = phi_2184_;
                                                                            let _e1495 = phi_2185_;
                                                                            let _e1497 = phi_2186_;
                                                                            let _e1499 = phi_2187_;
                                                                            let _e1501 = phi_2188_;
                                                                            let _e1503 = phi_2189_;
                                                                            let _e1510 = ((_e1501.y * _e1499.z) - (_e1499.y * _e1501.z));
                                                                            let _e1515 = ((_e1501.z * _e1499.x) - (_e1499.z * _e1501.x));
                                                                            let _e1518 = ((_e1501.x * _e1499.y) - (_e1499.x * _e1501.y));
                                                                            if (_e1318 >= _e1322) {
                                                                                phi_2226_ = select(true, false, (_e1318 >= _e1326));
                                                                            } else {
                                                                                phi_2226_ = true;
                                                                            }
                                                                            let _e1523 = phi_2226_;
                                                                            if _e1523 {
                                                                                phi_2235_ = select(_e1421, _e1420, vec3((_e1322 >= _e1326)));
                                                                            } else {
                                                                                phi_2235_ = _e1419;
                                                                            }
                                                                            let _e1528 = phi_2235_;
                                                                            let _e1539 = (((_e1510 * (_e1528.x - _e308)) + (_e1515 * (_e1528.y - _e375))) + (_e1518 * (_e1528.z - _e441)));
                                                                            let _e1544 = (((_e1510 * _e348) + (_e1515 * _e414)) + (_e1518 * _e480));
                                                                            let _e1545 = (_e1491 - _e1495);
                                                                            let _e1546 = (_e1489 - _e1493);
                                                                            let _e1554 = (-(((_e1495 * _e1545) + (_e1493 * _e1546))) / ((_e1545 * _e1545) + (_e1546 * _e1546)));
                                                                            let _e1556 = select(1f, _e1554, (_e1554 < 1f));
                                                                            let _e1558 = select(0f, _e1556, (_e1556 > 0f));
                                                                            let _e1571 = ((_e1497.x + (_e1503.x * _e1558)) - _e308);
                                                                            let _e1572 = ((_e1497.y + (_e1503.y * _e1558)) - _e375);
                                                                            let _e1573 = ((_e1497.z + (_e1503.z * _e1558)) - _e441);
                                                                            let _e1574 = (_e1573 / _e480);
                                                                            let _e1586 = bitcast<f32>((bitcast<u32>(_e1571) & 2147483647u));
                                                                            let _e1589 = bitcast<f32>((bitcast<u32>(_e1572) & 2147483647u));
                                                                            let _e1591 = select(_e1589, _e1586, (_e1586 > _e1589));
                                                                            let _e1594 = bitcast<f32>((bitcast<u32>(_e1573) & 2147483647u));
                                                                            let _e1596 = select(_e1594, _e1591, (_e1591 > _e1594));
                                                                            let _e1602 = bitcast<f32>((bitcast<u32>(_e1510) & 2147483647u));
                                                                            let _e1605 = bitcast<f32>((bitcast<u32>(_e1515) & 2147483647u));
                                                                            let _e1607 = select(_e1605, _e1602, (_e1602 > _e1605));
                                                                            let _e1610 = bitcast<f32>((bitcast<u32>(_e1518) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1510 * _e1571) + (_e1515 * _e1572)) + (_e1518 * _e1573)) - _e1539)) & 2147483647u)) <= ((0.0000009536743f * select(_e1476, _e1596, (_e1596 > _e1476))) * select(_e1610, _e1607, (_e1607 > _e1610)))) {
                                                                                let _e1620 = bitcast<f32>((bitcast<u32>(_e1501.x) & 2147483647u));
                                                                                let _e1623 = bitcast<f32>((bitcast<u32>(_e1501.y) & 2147483647u));
                                                                                let _e1625 = select(_e1623, _e1620, (_e1620 > _e1623));
                                                                                let _e1628 = bitcast<f32>((bitcast<u32>(_e1501.z) & 2147483647u));
                                                                                let _e1634 = bitcast<f32>((bitcast<u32>(_e1499.x) & 2147483647u));
                                                                                let _e1637 = bitcast<f32>((bitcast<u32>(_e1499.y) & 2147483647u));
                                                                                let _e1639 = select(_e1637, _e1634, (_e1634 > _e1637));
                                                                                let _e1642 = bitcast<f32>((bitcast<u32>(_e1499.z) & 2147483647u));
                                                                                let _e1646 = (bitcast<f32>((bitcast<u32>(_e1544) & 2147483647u)) > ((0.0000038146973f * select(_e1628, _e1625, (_e1625 > _e1628))) * select(_e1642, _e1639, (_e1639 > _e1642))));
                                                                                if _e1646 {
                                                                                    phi_2400_ = (_e1539 / _e1544);
                                                                                } else {
                                                                                    phi_2400_ = f32();
                                                                                }
                                                                                let _e1649 = phi_2400_;
                                                                                phi_2402_ = _e1649;
                                                                                phi_2403_ = select(true, false, _e1646);
                                                                            } else {
                                                                                phi_2402_ = f32();
                                                                                phi_2403_ = true;
                                                                            }
                                                                            let _e1652 = phi_2402_;
                                                                            let _e1654 = phi_2403_;
                                                                            if _e1654 {
                                                                                let _e1662 = (((_e1510 * (_e1571 - (_e348 * _e1574))) + (_e1515 * (_e1572 - (_e414 * _e1574)))) / _e1544);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1662) & 2147483647u)) <= _e1476) {
                                                                                    phi_2423_ = (_e1574 + _e1662);
                                                                                } else {
                                                                                    phi_2423_ = _e1574;
                                                                                }
                                                                                let _e1669 = phi_2423_;
                                                                                phi_2424_ = _e1669;
                                                                            } else {
                                                                                phi_2424_ = _e1652;
                                                                            }
                                                                            let _e1671 = phi_2424_;
                                                                            let _e1673 = select(_e1409, _e1671, (_e1671 < _e1409));
                                                                            let _e1675 = select(_e1401, _e1673, (_e1673 > _e1401));
                                                                            if (_e1675 >= _e594) {
                                                                                let _e1677 = (_e1675 <= _e1061.member.member_1);
                                                                                if _e1677 {
                                                                                    let _e1678 = (1f / _e1328);
                                                                                    phi_2447_ = type_19(_e1675, (_e1322 * _e1678), (_e1326 * _e1678), _e1095);
                                                                                } else {
                                                                                    phi_2447_ = type_19();
                                                                                }
                                                                                let _e1683 = phi_2447_;
                                                                                phi_2449_ = _e1683;
                                                                                phi_2450_ = select(true, false, _e1677);
                                                                            } else {
                                                                                phi_2449_ = type_19();
                                                                                phi_2450_ = true;
                                                                            }
                                                                            let _e1686 = phi_2449_;
                                                                            let _e1688 = phi_2450_;
                                                                            if _e1688 {
                                                                                phi_2454_ = type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2454_ = _e1686;
                                                                            }
                                                                            let _e1690 = phi_2454_;
                                                                            phi_2455_ = _e1690;
                                                                        }
                                                                        let _e1692 = phi_2455_;
                                                                        phi_2456_ = _e1692;
                                                                        phi_2457_ = _e1418;
                                                                    }
                                                                    let _e1694 = phi_2456_;
                                                                    let _e1696 = phi_2457_;
                                                                    phi_2461_ = _e1694;
                                                                    phi_2462_ = _e1696;
                                                                }
                                                                let _e1698 = phi_2461_;
                                                                let _e1700 = phi_2462_;
                                                                phi_2463_ = _e1698;
                                                                phi_2464_ = _e1353;
                                                                phi_2465_ = _e1700;
                                                            }
                                                            let _e1702 = phi_2463_;
                                                            let _e1704 = phi_2464_;
                                                            let _e1706 = phi_2465_;
                                                            phi_2466_ = _e1702;
                                                            phi_2467_ = _e1704;
                                                            phi_2468_ = _e1706;
                                                        }
                                                        let _e1708 = phi_2466_;
                                                        let _e1710 = phi_2467_;
                                                        let _e1712 = phi_2468_;
                                                        phi_2476_ = _e1708;
                                                        phi_2477_ = select(_e1712, true, _e1710);
                                                    } else {
                                                        phi_2476_ = type_19();
                                                        phi_2477_ = true;
                                                    }
                                                    let _e1715 = phi_2476_;
                                                    let _e1717 = phi_2477_;
                                                    if _e1717 {
                                                        phi_2481_ = type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2481_ = _e1715;
                                                    }
                                                    let _e1719 = phi_2481_;
                                                    if (_e1719.member_3 != 4294967295u) {
                                                        if (_e1095 != _e600) {
                                                            if (_e1719.member < _e1061.member.member.member) {
                                                                phi_2507_ = true;
                                                            } else {
                                                                if (_e1719.member == _e1061.member.member.member) {
                                                                    phi_2506_ = (_e1719.member_3 < _e1061.member.member.member_3);
                                                                } else {
                                                                    phi_2506_ = false;
                                                                }
                                                                let _e1734 = phi_2506_;
                                                                phi_2507_ = _e1734;
                                                            }
                                                            let _e1736 = phi_2507_;
                                                            if _e1736 {
                                                                phi_2514_ = type_36(type_34(_e1719, _e1719.member), _e1088.member_1, _e1088.member_2);
                                                            } else {
                                                                phi_2514_ = _e1088;
                                                            }
                                                            let _e1743 = phi_2514_;
                                                            phi_2515_ = _e1743;
                                                        } else {
                                                            phi_2515_ = _e1088;
                                                        }
                                                        let _e1745 = phi_2515_;
                                                        phi_2516_ = _e1745;
                                                    } else {
                                                        phi_2516_ = _e1088;
                                                    }
                                                    let _e1747 = phi_2516_;
                                                    phi_1251_ = _e1747;
                                                } else {
                                                    phi_1251_ = type_36();
                                                }
                                                let _e1749 = phi_1251_;
                                                continue;
                                                continuing {
                                                    phi_1250_ = _e1749;
                                                    phi_1253_ = _e1076;
                                                    phi_3856_ = _e631;
                                                    break if !(_e1082);
                                                }
                                            }
                                            let _e1752 = phi_3856_;
                                            phi_4034_ = _e1752;
                                            if _e1752 {
                                                break;
                                            }
                                            phi_4038_ = _e1752;
                                            let _e2080 = local_12;
                                            phi_3533_ = _e2080;
                                            phi_3534_ = false;
                                            phi_3535_ = _e675;
                                            phi_3536_ = _e677;
                                        } else {
                                            let _e687 = (_e677.member_1 < _e88);
                                            if _e687 {
                                                if _e687 {
                                                } else {
                                                    phi_4034_ = true;
                                                    break;
                                                }
                                                let _e689 = global_6.member[_e677.member_1];
                                                phi_2542_ = _e689;
                                            } else {
                                                phi_2542_ = type_40(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e691 = phi_2542_;
                                            let _e706 = ((10u * _e261) & 31u);
                                            let _e709 = ((_e691.member[0] >> bitcast<u32>(_e706)) & 1023u);
                                            let _e717 = bitcast<f32>((bitcast<u32>(((_e677.member.member_1[0] - _e677.member.member[0]) * 0.0009775171f)) ^ _e127));
                                            let _e722 = (_e677.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e709)) - 8388608f) * _e717)) ^ _e127)));
                                            let _e726 = select(select(_e677.member.member_1[0], _e722, (_e722 < _e677.member.member_1[0])), _e677.member.member_1[0], (_e709 == 1023u));
                                            let _e728 = ((10u * _e260) & 31u);
                                            let _e731 = ((_e691.member[0] >> bitcast<u32>(_e728)) & 1023u);
                                            let _e739 = bitcast<f32>((bitcast<u32>(((_e677.member.member_1[1] - _e677.member.member[1]) * 0.0009775171f)) ^ _e127));
                                            let _e744 = (_e677.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e731)) - 8388608f) * _e739)) ^ _e127)));
                                            let _e748 = select(select(_e677.member.member_1[1], _e744, (_e744 < _e677.member.member_1[1])), _e677.member.member_1[1], (_e731 == 1023u));
                                            let _e750 = ((10u * _e262) & 31u);
                                            let _e753 = ((_e691.member[0] >> bitcast<u32>(_e750)) & 1023u);
                                            let _e761 = bitcast<f32>((bitcast<u32>(((_e677.member.member_1[2] - _e677.member.member[2]) * 0.0009775171f)) ^ _e127));
                                            let _e766 = (_e677.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e753)) - 8388608f) * _e761)) ^ _e127)));
                                            let _e770 = select(select(_e677.member.member_1[2], _e766, (_e766 < _e677.member.member_1[2])), _e677.member.member_1[2], (_e753 == 1023u));
                                            let _e773 = ((_e691.member[1] >> bitcast<u32>(_e706)) & 1023u);
                                            let _e781 = (_e677.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e773)) - 8388608f) * _e717)) ^ _e127)));
                                            let _e785 = select(select(_e677.member.member_1[0], _e781, (_e781 < _e677.member.member_1[0])), _e677.member.member_1[0], (_e773 == 1023u));
                                            let _e788 = ((_e691.member[1] >> bitcast<u32>(_e728)) & 1023u);
                                            let _e796 = (_e677.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e788)) - 8388608f) * _e739)) ^ _e127)));
                                            let _e800 = select(select(_e677.member.member_1[1], _e796, (_e796 < _e677.member.member_1[1])), _e677.member.member_1[1], (_e788 == 1023u));
                                            let _e803 = ((_e691.member[1] >> bitcast<u32>(_e750)) & 1023u);
                                            let _e811 = (_e677.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e803)) - 8388608f) * _e761)) ^ _e127)));
                                            let _e815 = select(select(_e677.member.member_1[2], _e811, (_e811 < _e677.member.member_1[2])), _e677.member.member_1[2], (_e803 == 1023u));
                                            let _e821 = ((_e691.member_1[0] >> bitcast<u32>(_e706)) & 1023u);
                                            let _e829 = (_e677.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e821)) - 8388608f) * _e717)) ^ _e127)));
                                            let _e833 = select(select(_e677.member.member_1[0], _e829, (_e829 < _e677.member.member_1[0])), _e677.member.member_1[0], (_e821 == 1023u));
                                            let _e836 = ((_e691.member_1[0] >> bitcast<u32>(_e728)) & 1023u);
                                            let _e844 = (_e677.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e836)) - 8388608f) * _e739)) ^ _e127)));
                                            let _e848 = select(select(_e677.member.member_1[1], _e844, (_e844 < _e677.member.member_1[1])), _e677.member.member_1[1], (_e836 == 1023u));
                                            let _e851 = ((_e691.member_1[0] >> bitcast<u32>(_e750)) & 1023u);
                                            let _e859 = (_e677.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e851)) - 8388608f) * _e761)) ^ _e127)));
                                            let _e863 = select(select(_e677.member.member_1[2], _e859, (_e859 < _e677.member.member_1[2])), _e677.member.member_1[2], (_e851 == 1023u));
                                            let _e866 = ((_e691.member_1[1] >> bitcast<u32>(_e706)) & 1023u);
                                            let _e874 = (_e677.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e866)) - 8388608f) * _e717)) ^ _e127)));
                                            let _e878 = select(select(_e677.member.member_1[0], _e874, (_e874 < _e677.member.member_1[0])), _e677.member.member_1[0], (_e866 == 1023u));
                                            let _e881 = ((_e691.member_1[1] >> bitcast<u32>(_e728)) & 1023u);
                                            let _e889 = (_e677.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e881)) - 8388608f) * _e739)) ^ _e127)));
                                            let _e893 = select(select(_e677.member.member_1[1], _e889, (_e889 < _e677.member.member_1[1])), _e677.member.member_1[1], (_e881 == 1023u));
                                            let _e896 = ((_e691.member_1[1] >> bitcast<u32>(_e750)) & 1023u);
                                            let _e904 = (_e677.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e896)) - 8388608f) * _e761)) ^ _e127)));
                                            let _e908 = select(select(_e677.member.member_1[2], _e904, (_e904 < _e677.member.member_1[2])), _e677.member.member_1[2], (_e896 == 1023u));
                                            let _e913 = type_53(type_45(array<f32, 3>(_e726, _e748, _e770), array<f32, 3>(_e785, _e800, _e815)), _e691.member_2);
                                            let _e918 = type_53(type_45(array<f32, 3>(_e833, _e848, _e863), array<f32, 3>(_e878, _e893, _e908)), _e691.member_3);
                                            let _e931 = ((_e726 - _e346) * _e351);
                                            let _e932 = ((_e833 - _e346) * _e351);
                                            let _e933 = ((_e785 - _e347) * _e351);
                                            let _e934 = ((_e878 - _e347) * _e351);
                                            let _e939 = ((_e748 - _e412) * _e417);
                                            let _e940 = ((_e848 - _e412) * _e417);
                                            let _e941 = ((_e800 - _e413) * _e417);
                                            let _e942 = ((_e893 - _e413) * _e417);
                                            let _e947 = ((_e770 - _e478) * _e483);
                                            let _e948 = ((_e863 - _e478) * _e483);
                                            let _e949 = ((_e815 - _e479) * _e483);
                                            let _e950 = ((_e908 - _e479) * _e483);
                                            let _e952 = select(_e949, _e947, (_e947 < _e949));
                                            let _e954 = select(_e950, _e948, (_e948 < _e950));
                                            let _e956 = select(_e949, _e947, (_e947 > _e949));
                                            let _e958 = select(_e950, _e948, (_e948 > _e950));
                                            let _e960 = select(_e933, _e931, (_e931 < _e933));
                                            let _e962 = select(_e934, _e932, (_e932 < _e934));
                                            let _e964 = select(_e941, _e939, (_e939 < _e941));
                                            let _e966 = select(_e942, _e940, (_e940 < _e942));
                                            let _e968 = select(_e964, _e960, (_e960 > _e964));
                                            let _e970 = select(_e966, _e962, (_e962 > _e966));
                                            let _e972 = select(_e952, _e968, (_e968 > _e952));
                                            let _e974 = select(_e954, _e970, (_e970 > _e954));
                                            let _e976 = select(_e933, _e931, (_e931 > _e933));
                                            let _e978 = select(_e934, _e932, (_e932 > _e934));
                                            let _e980 = select(_e941, _e939, (_e939 > _e941));
                                            let _e982 = select(_e942, _e940, (_e940 > _e942));
                                            let _e984 = select(_e980, _e976, (_e976 < _e980));
                                            let _e986 = select(_e982, _e978, (_e978 < _e982));
                                            let _e991 = -(_e952);
                                            let _e992 = -(_e954);
                                            let _e999 = (select(_e956, _e984, (_e984 < _e956)) + (select(_e991, _e956, (_e956 > _e991)) * 0.0000019073523f));
                                            let _e1000 = (select(_e958, _e986, (_e986 < _e958)) + (select(_e992, _e958, (_e958 > _e992)) * 0.0000019073523f));
                                            let _e1002 = select(_e594, _e972, (_e972 > _e594));
                                            let _e1004 = select(_e594, _e974, (_e974 > _e594));
                                            let _e1009 = (_e1002 <= select(_e633.member.member_1, _e999, (_e999 < _e633.member.member_1)));
                                            let _e1010 = (_e1004 <= select(_e633.member.member_1, _e1000, (_e1000 < _e633.member.member_1)));
                                            let _e1011 = (_e1002 <= _e1004);
                                            if _e1009 {
                                                if _e1010 {
                                                    if _e1011 {
                                                        phi_3431_ = _e918;
                                                    } else {
                                                        phi_3431_ = _e913;
                                                    }
                                                    let _e1013 = phi_3431_;
                                                    let _e1021 = (_e675 % 128u);
                                                    let _e1022 = (_e1021 < 128u);
                                                    if _e1022 {
                                                    } else {
                                                        phi_4034_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1021] = _e1013.member_1;
                                                    if _e1022 {
                                                    } else {
                                                        phi_4034_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1021] = _e1013.member.member[0];
                                                    if _e1022 {
                                                    } else {
                                                        phi_4034_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1021] = _e1013.member.member[1];
                                                    if _e1022 {
                                                    } else {
                                                        phi_4034_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1021] = _e1013.member.member[2];
                                                    if _e1022 {
                                                    } else {
                                                        phi_4034_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1021] = _e1013.member.member_1[0];
                                                    if _e1022 {
                                                    } else {
                                                        phi_4034_ = true;
                                                        break;
                                                    }
                                                    local_1[_e1021] = _e1013.member.member_1[1];
                                                    if _e1022 {
                                                    } else {
                                                        phi_4034_ = true;
                                                        break;
                                                    }
                                                    local[_e1021] = _e1013.member.member_1[2];
                                                    if _e1022 {
                                                    } else {
                                                        phi_4034_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1021] = select(_e1004, _e1002, !(_e1011));
                                                    if _e1011 {
                                                        phi_3508_ = _e913;
                                                    } else {
                                                        phi_3508_ = _e918;
                                                    }
                                                    let _e1039 = phi_3508_;
                                                    phi_3509_ = (_e675 + 1u);
                                                    phi_3510_ = _e1039;
                                                } else {
                                                    phi_3509_ = u32();
                                                    phi_3510_ = type_53();
                                                }
                                                let _e1041 = phi_3509_;
                                                let _e1043 = phi_3510_;
                                                phi_3512_ = _e1041;
                                                phi_3513_ = _e1043;
                                                phi_3514_ = select(true, false, _e1010);
                                            } else {
                                                phi_3512_ = u32();
                                                phi_3513_ = type_53();
                                                phi_3514_ = true;
                                            }
                                            let _e1046 = phi_3512_;
                                            let _e1048 = phi_3513_;
                                            let _e1050 = phi_3514_;
                                            if _e1050 {
                                                if _e1009 {
                                                    phi_3521_ = _e913;
                                                } else {
                                                    phi_3521_ = _e918;
                                                }
                                                let _e1052 = phi_3521_;
                                                phi_3526_ = select(_e1010, true, _e1009);
                                                phi_3528_ = _e1052;
                                            } else {
                                                phi_3526_ = _e673;
                                                phi_3528_ = _e1048;
                                            }
                                            let _e1055 = phi_3526_;
                                            let _e1057 = phi_3528_;
                                            phi_4038_ = _e631;
                                            phi_3533_ = type_36(_e633.member, (_e633.member_1 + 1u), _e633.member_2);
                                            phi_3534_ = _e1055;
                                            phi_3535_ = select(_e1046, _e675, _e1050);
                                            phi_3536_ = _e1057;
                                        }
                                        let _e1754 = phi_4038_;
                                        let _e1756 = phi_3533_;
                                        let _e1758 = phi_3534_;
                                        let _e1760 = phi_3535_;
                                        let _e1762 = phi_3536_;
                                        phi_4037_ = _e1754;
                                        phi_3537_ = _e1756;
                                        phi_3538_ = _e1758;
                                        phi_3539_ = (_e637 - 1u);
                                        phi_3540_ = _e1760;
                                        phi_3541_ = _e1762;
                                    } else {
                                        phi_4037_ = _e631;
                                        phi_3537_ = _e633;
                                        phi_3538_ = _e673;
                                        phi_3539_ = _e637;
                                        phi_3540_ = _e675;
                                        phi_3541_ = _e677;
                                    }
                                    let _e1764 = phi_4037_;
                                    let _e1766 = phi_3537_;
                                    let _e1768 = phi_3538_;
                                    let _e1770 = phi_3539_;
                                    let _e1772 = phi_3540_;
                                    let _e1774 = phi_3541_;
                                    phi_4036_ = _e1764;
                                    phi_3542_ = _e1766;
                                    phi_3543_ = _e1768;
                                    phi_3544_ = _e1770;
                                    phi_3545_ = _e1772;
                                    phi_3546_ = _e1774;
                                } else {
                                    phi_4036_ = _e631;
                                    phi_3542_ = type_36();
                                    phi_3543_ = bool();
                                    phi_3544_ = u32();
                                    phi_3545_ = u32();
                                    phi_3546_ = type_53();
                                }
                                let _e1776 = phi_4036_;
                                let _e1778 = phi_3542_;
                                let _e1780 = phi_3543_;
                                let _e1782 = phi_3544_;
                                let _e1784 = phi_3545_;
                                let _e1786 = phi_3546_;
                                phi_4035_ = _e1776;
                                phi_1124_ = _e1778;
                                phi_1127_ = _e1780;
                                phi_1129_ = _e1782;
                                phi_1131_ = _e1784;
                                phi_1133_ = _e1786;
                                phi_3547_ = _e645;
                            } else {
                                phi_4035_ = _e631;
                                phi_1124_ = type_36();
                                phi_1127_ = bool();
                                phi_1129_ = u32();
                                phi_1131_ = u32();
                                phi_1133_ = type_53();
                                phi_3547_ = false;
                            }
                            let _e1788 = phi_4035_;
                            let _e1790 = phi_1124_;
                            let _e1792 = phi_1127_;
                            let _e1794 = phi_1129_;
                            let _e1796 = phi_1131_;
                            let _e1798 = phi_1133_;
                            let _e1800 = phi_3547_;
                            continue;
                            continuing {
                                phi_3862_ = _e1788;
                                phi_1123_ = _e1790;
                                phi_1126_ = _e1792;
                                phi_1128_ = _e1794;
                                phi_1130_ = _e1796;
                                phi_1132_ = _e1798;
                                phi_4034_ = _e1788;
                                break if !(_e1800);
                            }
                        }
                        let _e1803 = phi_4034_;
                        if _e1803 {
                            break;
                        }
                        let _e1805 = local_10;
                        if (_e1805.member.member.member_3 != 4294967295u) {
                            let _e1811 = bitcast<u32>(_e1805.member.member.member);
                            let _e1815 = (bitcast<i32>((_e1811 >> bitcast<u32>(23i))) & 255i);
                            let _e1816 = (_e1815 + _e263);
                            if (_e1815 == 255i) {
                                phi_3606_ = _e1805.member.member.member;
                            } else {
                                if (_e1815 > 0i) {
                                    if (_e1816 > 0i) {
                                        let _e1820 = (_e1816 < 255i);
                                        if _e1820 {
                                            phi_3585_ = bitcast<f32>((_e1811 + bitcast<u32>((_e263 << bitcast<u32>(23i)))));
                                        } else {
                                            phi_3585_ = f32();
                                        }
                                        let _e1827 = phi_3585_;
                                        phi_3587_ = _e1827;
                                        phi_3588_ = select(true, false, _e1820);
                                    } else {
                                        phi_3587_ = f32();
                                        phi_3588_ = true;
                                    }
                                    let _e1830 = phi_3587_;
                                    let _e1832 = phi_3588_;
                                    phi_3589_ = _e1830;
                                    phi_3590_ = _e1832;
                                } else {
                                    phi_3589_ = f32();
                                    phi_3590_ = true;
                                }
                                let _e1834 = phi_3589_;
                                let _e1836 = phi_3590_;
                                if _e1836 {
                                    let _e1837 = (_e1811 & 2147483648u);
                                    let _e1844 = ((_e1811 & 8388607u) | (select(0u, 1u, ((_e1811 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                    let _e1848 = (_e1844 == 0u);
                                    if _e1848 {
                                        phi_3826_ = bitcast<f32>(_e1837);
                                    } else {
                                        let _e1853 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1844)), 32u, _e1848) - 8u);
                                        let _e1856 = (_e1844 << bitcast<u32>((_e1853 & 31u)));
                                        let _e1858 = ((_e1816 + select(0i, 1i, (_e1815 == 0i))) - bitcast<i32>(_e1853));
                                        if (_e1858 >= 255i) {
                                            phi_3816_ = bitcast<f32>((_e1837 | 2139095040u));
                                            phi_3817_ = f32();
                                            phi_3818_ = true;
                                        } else {
                                            let _e1860 = (_e1858 > 0i);
                                            if _e1860 {
                                                phi_3810_ = bitcast<f32>(((_e1837 | (bitcast<u32>(_e1858) << bitcast<u32>(23i))) | (_e1856 & 8388607u)));
                                                phi_3811_ = f32();
                                            } else {
                                                if (_e1858 < -24i) {
                                                    phi_3776_ = 26u;
                                                } else {
                                                    phi_3776_ = bitcast<u32>((1i - _e1858));
                                                }
                                                let _e1865 = phi_3776_;
                                                let _e1866 = (_e1865 & 31u);
                                                let _e1868 = (_e1856 >> bitcast<u32>(_e1866));
                                                let _e1872 = (_e1856 & ((1u << bitcast<u32>(_e1866)) - 1u));
                                                let _e1876 = (1u << bitcast<u32>(((_e1865 - 1u) & 31u)));
                                                if (_e1872 > _e1876) {
                                                    phi_3797_ = true;
                                                } else {
                                                    if (_e1872 == _e1876) {
                                                        phi_3794_ = ((_e1868 & 1u) == 1u);
                                                    } else {
                                                        phi_3794_ = false;
                                                    }
                                                    let _e1882 = phi_3794_;
                                                    phi_3797_ = _e1882;
                                                }
                                                let _e1884 = phi_3797_;
                                                phi_3810_ = f32();
                                                phi_3811_ = bitcast<f32>((_e1837 | (_e1868 + select(0u, 1u, _e1884))));
                                            }
                                            let _e1897 = phi_3810_;
                                            let _e1899 = phi_3811_;
                                            phi_3816_ = _e1897;
                                            phi_3817_ = _e1899;
                                            phi_3818_ = _e1860;
                                        }
                                        let _e1903 = phi_3816_;
                                        let _e1905 = phi_3817_;
                                        let _e1907 = phi_3818_;
                                        phi_3826_ = select(_e1905, _e1903, _e1907);
                                    }
                                    let _e1911 = phi_3826_;
                                    phi_3605_ = _e1911;
                                } else {
                                    phi_3605_ = _e1834;
                                }
                                let _e1913 = phi_3605_;
                                phi_3606_ = _e1913;
                            }
                            let _e1915 = phi_3606_;
                            let _e1916 = bitcast<u32>(_e1915);
                            if ((_e1916 & 2147483647u) >= 2139095040u) {
                                phi_3618_ = bitcast<f32>(((_e1916 & 2147483648u) | 2139095039u));
                            } else {
                                phi_3618_ = _e1915;
                            }
                            let _e1923 = phi_3618_;
                            phi_3623_ = type_19(_e1923, _e1805.member.member.member_1, _e1805.member.member.member_2, _e1805.member.member.member_3);
                        } else {
                            phi_3623_ = type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1928 = phi_3623_;
                        if _e139 {
                        } else {
                            break;
                        }
                        global_1.member[_e131] = _e1928;
                        let _e1932 = local_11;
                        if _e140 {
                        } else {
                            break;
                        }
                        global_4.member[_e131] = _e1932.member_1;
                        if _e138 {
                        } else {
                            break;
                        }
                        let _e1937 = select(0u, 1u, (_e207 <= _e217));
                        if (_e1937 > 0u) {
                            let _e1939 = (1u < _e99);
                            if _e1939 {
                                if (0u < _e99) {
                                } else {
                                    break;
                                }
                                let _e1943 = atomicAdd((&global_5.member[0u]), _e1937);
                                if ((_e1943 + _e1937) < _e1943) {
                                    if _e1939 {
                                    } else {
                                        break;
                                    }
                                    let _e1948 = atomicAdd((&global_5.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1951 = select(0u, 1u, (_e1928.member_3 != 4294967295u));
                        if (_e1951 > 0u) {
                            let _e1953 = (3u < _e99);
                            if _e1953 {
                                if (2u < _e99) {
                                } else {
                                    break;
                                }
                                let _e1957 = atomicAdd((&global_5.member[2u]), _e1951);
                                if ((_e1957 + _e1951) < _e1957) {
                                    if _e1953 {
                                    } else {
                                        break;
                                    }
                                    let _e1962 = atomicAdd((&global_5.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1932.member_1 > 0u) {
                            let _e1964 = (5u < _e99);
                            if _e1964 {
                                if (4u < _e99) {
                                } else {
                                    break;
                                }
                                let _e1968 = atomicAdd((&global_5.member[4u]), _e1932.member_1);
                                if ((_e1968 + _e1932.member_1) < _e1968) {
                                    if _e1964 {
                                    } else {
                                        break;
                                    }
                                    let _e1973 = atomicAdd((&global_5.member[5u]), 1u);
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
fn trace_paths_counted_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
