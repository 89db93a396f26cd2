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
    var phi_3868_: bool;
    var phi_1123_: type_36;
    var phi_1126_: u32;
    var phi_1128_: bool;
    var phi_1130_: u32;
    var phi_1132_: type_53;
    var phi_1143_: bool;
    var phi_1229_: bool;
    var phi_1230_: u32;
    var phi_1231_: type_53;
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
    var phi_3862_: bool;
    var phi_4099_: bool;
    var phi_2517_: type_36;
    var phi_2538_: type_40;
    var phi_3427_: type_53;
    var phi_3503_: type_53;
    var phi_3504_: u32;
    var phi_3505_: type_53;
    var phi_3507_: u32;
    var phi_3508_: type_53;
    var phi_3509_: bool;
    var phi_3516_: type_53;
    var phi_3521_: bool;
    var phi_3523_: type_53;
    var phi_3528_: type_36;
    var phi_3529_: bool;
    var phi_3530_: u32;
    var phi_3531_: type_53;
    var phi_3539_: type_36;
    var phi_3542_: type_53;
    var phi_4043_: bool;
    var phi_3543_: type_36;
    var phi_3544_: u32;
    var phi_3545_: bool;
    var phi_3546_: u32;
    var phi_3547_: type_53;
    var phi_4042_: bool;
    var phi_3548_: type_36;
    var phi_3549_: u32;
    var phi_3550_: bool;
    var phi_3551_: u32;
    var phi_3552_: type_53;
    var phi_4041_: bool;
    var phi_1124_: type_36;
    var phi_1127_: u32;
    var phi_1129_: bool;
    var phi_1131_: u32;
    var phi_1133_: type_53;
    var phi_3553_: bool;
    var phi_4040_: bool;
    var local_10: type_36;
    var phi_3591_: f32;
    var phi_3593_: f32;
    var phi_3594_: bool;
    var phi_3595_: f32;
    var phi_3596_: bool;
    var phi_3782_: u32;
    var phi_3800_: bool;
    var phi_3803_: bool;
    var phi_3816_: f32;
    var phi_3817_: f32;
    var phi_3822_: f32;
    var phi_3823_: f32;
    var phi_3824_: bool;
    var phi_3832_: f32;
    var phi_3611_: f32;
    var phi_3612_: f32;
    var phi_3624_: f32;
    var phi_3629_: type_19;
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
                        phi_3868_ = false;
                        phi_1123_ = type_36(type_34(type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e592), 0u, 0u);
                        phi_1126_ = ((3u * _e88) + 1u);
                        phi_1128_ = (_e594 <= _e592);
                        phi_1130_ = 0u;
                        phi_1132_ = type_53(type_45(array<f32, 3>(_e607, _e611, _e615), array<f32, 3>(_e619, _e621, _e623)), select(0u, 2147483648u, (_e88 == 0u)));
                        loop {
                            let _e631 = phi_3868_;
                            let _e633 = phi_1123_;
                            let _e635 = phi_1126_;
                            let _e637 = phi_1128_;
                            let _e639 = phi_1130_;
                            let _e641 = phi_1132_;
                            local_10 = _e633;
                            local_11 = _e633;
                            if _e637 {
                                phi_1143_ = true;
                            } else {
                                phi_1143_ = (_e639 > 0u);
                            }
                            let _e644 = phi_1143_;
                            if _e644 {
                                let _e645 = (_e635 > 0u);
                                if _e645 {
                                    if _e637 {
                                        phi_1229_ = _e637;
                                        phi_1230_ = _e639;
                                        phi_1231_ = _e641;
                                    } else {
                                        let _e646 = (_e639 - 1u);
                                        let _e647 = (_e646 % 128u);
                                        let _e648 = (_e647 < 128u);
                                        if _e648 {
                                        } else {
                                            phi_4040_ = true;
                                            break;
                                        }
                                        let _e650 = local_6[_e647];
                                        if _e648 {
                                        } else {
                                            phi_4040_ = true;
                                            break;
                                        }
                                        let _e652 = local_5[_e647];
                                        if _e648 {
                                        } else {
                                            phi_4040_ = true;
                                            break;
                                        }
                                        let _e654 = local_4[_e647];
                                        if _e648 {
                                        } else {
                                            phi_4040_ = true;
                                            break;
                                        }
                                        let _e656 = local_3[_e647];
                                        if _e648 {
                                        } else {
                                            phi_4040_ = true;
                                            break;
                                        }
                                        let _e659 = local_2[_e647];
                                        if _e648 {
                                        } else {
                                            phi_4040_ = true;
                                            break;
                                        }
                                        let _e661 = local_1[_e647];
                                        if _e648 {
                                        } else {
                                            phi_4040_ = true;
                                            break;
                                        }
                                        let _e663 = local[_e647];
                                        if _e648 {
                                        } else {
                                            phi_4040_ = true;
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
                                        let _e681 = ((_e677.member_1 & 2147483648u) != 0u);
                                        if _e681 {
                                            phi_1250_ = _e633;
                                            phi_1253_ = type_7(0u, ((_e677.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e689 = phi_1250_;
                                                let _e691 = phi_1253_;
                                                local_12 = _e689;
                                                if (_e691.member < _e691.member_1) {
                                                    phi_1254_ = type_7((_e691.member + 1u), _e691.member_1);
                                                    phi_1276_ = type_7(1u, _e691.member);
                                                } else {
                                                    phi_1254_ = _e691;
                                                    phi_1276_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e704 = phi_1254_;
                                                let _e706 = phi_1276_;
                                                let _e710 = (bitcast<i32>(_e706.member) != 0i);
                                                if _e710 {
                                                    let _e716 = type_36(_e689.member, _e689.member_1, (_e689.member_2 + 1u));
                                                    let _e717 = ((_e677.member_1 & 268435455u) + _e706.member_1);
                                                    let _e718 = (_e717 < arrayLength((&global_7.member)));
                                                    if _e718 {
                                                        if _e718 {
                                                        } else {
                                                            phi_3862_ = true;
                                                            break;
                                                        }
                                                        let _e721 = global_7.member[_e717].member_1;
                                                        phi_1304_ = _e721;
                                                    } else {
                                                        phi_1304_ = 4294967295u;
                                                    }
                                                    let _e723 = phi_1304_;
                                                    if _e718 {
                                                        if _e718 {
                                                        } else {
                                                            phi_3862_ = true;
                                                            break;
                                                        }
                                                        let _e725 = global_7.member[_e717];
                                                        phi_1320_ = _e725;
                                                    } else {
                                                        phi_1320_ = type_47(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                    }
                                                    let _e727 = phi_1320_;
                                                    let _e739 = ((10u * _e261) & 31u);
                                                    let _e742 = ((_e727.member[0] >> bitcast<u32>(_e739)) & 1023u);
                                                    let _e750 = bitcast<f32>((bitcast<u32>(((_e677.member.member_1[0] - _e677.member.member[0]) * 0.0009775171f)) ^ _e127));
                                                    let _e755 = (_e677.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e742)) - 8388608f) * _e750)) ^ _e127)));
                                                    let _e759 = select(select(_e677.member.member_1[0], _e755, (_e755 < _e677.member.member_1[0])), _e677.member.member_1[0], (_e742 == 1023u));
                                                    let _e761 = ((10u * _e260) & 31u);
                                                    let _e764 = ((_e727.member[0] >> bitcast<u32>(_e761)) & 1023u);
                                                    let _e772 = bitcast<f32>((bitcast<u32>(((_e677.member.member_1[1] - _e677.member.member[1]) * 0.0009775171f)) ^ _e127));
                                                    let _e777 = (_e677.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e764)) - 8388608f) * _e772)) ^ _e127)));
                                                    let _e781 = select(select(_e677.member.member_1[1], _e777, (_e777 < _e677.member.member_1[1])), _e677.member.member_1[1], (_e764 == 1023u));
                                                    let _e783 = ((10u * _e262) & 31u);
                                                    let _e786 = ((_e727.member[0] >> bitcast<u32>(_e783)) & 1023u);
                                                    let _e794 = bitcast<f32>((bitcast<u32>(((_e677.member.member_1[2] - _e677.member.member[2]) * 0.0009775171f)) ^ _e127));
                                                    let _e799 = (_e677.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e786)) - 8388608f) * _e794)) ^ _e127)));
                                                    let _e803 = select(select(_e677.member.member_1[2], _e799, (_e799 < _e677.member.member_1[2])), _e677.member.member_1[2], (_e786 == 1023u));
                                                    let _e807 = ((_e727.member[1] >> bitcast<u32>(_e739)) & 1023u);
                                                    let _e815 = (_e677.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e807)) - 8388608f) * _e750)) ^ _e127)));
                                                    let _e819 = select(select(_e677.member.member_1[0], _e815, (_e815 < _e677.member.member_1[0])), _e677.member.member_1[0], (_e807 == 1023u));
                                                    let _e822 = ((_e727.member[1] >> bitcast<u32>(_e761)) & 1023u);
                                                    let _e830 = (_e677.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e822)) - 8388608f) * _e772)) ^ _e127)));
                                                    let _e834 = select(select(_e677.member.member_1[1], _e830, (_e830 < _e677.member.member_1[1])), _e677.member.member_1[1], (_e822 == 1023u));
                                                    let _e837 = ((_e727.member[1] >> bitcast<u32>(_e783)) & 1023u);
                                                    let _e845 = (_e677.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e837)) - 8388608f) * _e794)) ^ _e127)));
                                                    let _e849 = select(select(_e677.member.member_1[2], _e845, (_e845 < _e677.member.member_1[2])), _e677.member.member_1[2], (_e837 == 1023u));
                                                    let _e853 = ((_e727.member[2] >> bitcast<u32>(_e739)) & 1023u);
                                                    let _e861 = (_e677.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e853)) - 8388608f) * _e750)) ^ _e127)));
                                                    let _e865 = select(select(_e677.member.member_1[0], _e861, (_e861 < _e677.member.member_1[0])), _e677.member.member_1[0], (_e853 == 1023u));
                                                    let _e868 = ((_e727.member[2] >> bitcast<u32>(_e761)) & 1023u);
                                                    let _e876 = (_e677.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e868)) - 8388608f) * _e772)) ^ _e127)));
                                                    let _e880 = select(select(_e677.member.member_1[1], _e876, (_e876 < _e677.member.member_1[1])), _e677.member.member_1[1], (_e868 == 1023u));
                                                    let _e883 = ((_e727.member[2] >> bitcast<u32>(_e783)) & 1023u);
                                                    let _e891 = (_e677.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e883)) - 8388608f) * _e794)) ^ _e127)));
                                                    let _e895 = select(select(_e677.member.member_1[2], _e891, (_e891 < _e677.member.member_1[2])), _e677.member.member_1[2], (_e883 == 1023u));
                                                    let _e900 = (_e803 - _e441);
                                                    let _e903 = (((_e759 - _e308) * _e480) - (_e900 * _e348));
                                                    let _e906 = (((_e781 - _e375) * _e480) - (_e900 * _e414));
                                                    let _e909 = (_e849 - _e441);
                                                    let _e912 = (((_e819 - _e308) * _e480) - (_e909 * _e348));
                                                    let _e915 = (((_e834 - _e375) * _e480) - (_e909 * _e414));
                                                    let _e918 = (_e895 - _e441);
                                                    let _e921 = (((_e865 - _e308) * _e480) - (_e918 * _e348));
                                                    let _e924 = (((_e880 - _e375) * _e480) - (_e918 * _e414));
                                                    let _e925 = (_e921 * _e915);
                                                    let _e926 = (_e924 * _e912);
                                                    let _e927 = (_e903 * _e924);
                                                    let _e928 = (_e906 * _e921);
                                                    let _e929 = (_e912 * _e906);
                                                    let _e930 = (_e915 * _e903);
                                                    let _e935 = (((_e925 >= _e926) && (_e927 >= _e928)) && (_e929 >= _e930));
                                                    if (_e935 || (((_e925 <= _e926) && (_e927 <= _e928)) && (_e929 <= _e930))) {
                                                        let _e942 = select(-1f, 1f, _e935);
                                                        let _e944 = ((_e925 - _e926) * _e942);
                                                        let _e946 = select(0f, _e944, (_e944 > 0f));
                                                        let _e948 = ((_e927 - _e928) * _e942);
                                                        let _e950 = select(0f, _e948, (_e948 > 0f));
                                                        let _e952 = ((_e929 - _e930) * _e942);
                                                        let _e954 = select(0f, _e952, (_e952 > 0f));
                                                        let _e956 = ((_e946 + _e950) + _e954);
                                                        if (_e956 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2466_ = type_19();
                                                            phi_2467_ = true;
                                                            phi_2468_ = false;
                                                        } else {
                                                            let _e959 = select(_e912, _e903, (_e903 < _e912));
                                                            if (select(_e921, _e959, (_e959 < _e921)) > 0f) {
                                                                phi_1758_ = true;
                                                            } else {
                                                                let _e964 = select(_e912, _e903, (_e903 > _e912));
                                                                phi_1758_ = (select(_e921, _e964, (_e964 > _e921)) < 0f);
                                                            }
                                                            let _e969 = phi_1758_;
                                                            if _e969 {
                                                                phi_2463_ = type_19();
                                                                phi_2464_ = true;
                                                                phi_2465_ = false;
                                                            } else {
                                                                let _e971 = select(_e915, _e906, (_e906 < _e915));
                                                                if (select(_e924, _e971, (_e971 < _e924)) > 0f) {
                                                                    phi_1787_ = true;
                                                                } else {
                                                                    let _e976 = select(_e915, _e906, (_e906 > _e915));
                                                                    phi_1787_ = (select(_e924, _e976, (_e976 > _e924)) < 0f);
                                                                }
                                                                let _e981 = phi_1787_;
                                                                if _e981 {
                                                                    phi_2461_ = type_19();
                                                                    phi_2462_ = false;
                                                                } else {
                                                                    let _e983 = select(_e819, _e759, (_e759 < _e819));
                                                                    let _e987 = select(_e819, _e759, (_e759 > _e819));
                                                                    let _e991 = select(_e834, _e781, (_e781 < _e834));
                                                                    let _e995 = select(_e834, _e781, (_e781 > _e834));
                                                                    let _e999 = select(_e849, _e803, (_e803 < _e849));
                                                                    let _e1003 = select(_e849, _e803, (_e803 > _e849));
                                                                    let _e1008 = ((select(_e865, _e983, (_e983 < _e865)) - _e346) * _e351);
                                                                    let _e1009 = ((select(_e865, _e987, (_e987 > _e865)) - _e347) * _e351);
                                                                    let _e1012 = ((select(_e880, _e991, (_e991 < _e880)) - _e412) * _e417);
                                                                    let _e1013 = ((select(_e880, _e995, (_e995 > _e880)) - _e413) * _e417);
                                                                    let _e1016 = ((select(_e895, _e999, (_e999 < _e895)) - _e478) * _e483);
                                                                    let _e1017 = ((select(_e895, _e1003, (_e1003 > _e895)) - _e479) * _e483);
                                                                    let _e1019 = select(_e1017, _e1016, (_e1016 < _e1017));
                                                                    let _e1021 = select(_e1017, _e1016, (_e1016 > _e1017));
                                                                    let _e1023 = select(_e1009, _e1008, (_e1008 < _e1009));
                                                                    let _e1025 = select(_e1013, _e1012, (_e1012 < _e1013));
                                                                    let _e1027 = select(_e1025, _e1023, (_e1023 > _e1025));
                                                                    let _e1029 = select(_e1019, _e1027, (_e1027 > _e1019));
                                                                    let _e1031 = select(_e1009, _e1008, (_e1008 > _e1009));
                                                                    let _e1033 = select(_e1013, _e1012, (_e1012 > _e1013));
                                                                    let _e1035 = select(_e1033, _e1031, (_e1031 < _e1033));
                                                                    let _e1037 = select(_e1021, _e1035, (_e1035 < _e1021));
                                                                    let _e1038 = -(_e1019);
                                                                    let _e1044 = select(_e594, _e1029, (_e1029 > _e594));
                                                                    if (_e1044 > (_e1037 + (select(_e1038, _e1021, (_e1021 > _e1038)) * 0.0000019073523f))) {
                                                                        phi_2456_ = type_19();
                                                                        phi_2457_ = true;
                                                                    } else {
                                                                        let _e1046 = (_e1044 > _e689.member.member_1);
                                                                        if _e1046 {
                                                                            phi_2455_ = type_19();
                                                                        } else {
                                                                            let _e1047 = vec3<f32>(_e759, _e781, _e803);
                                                                            let _e1048 = vec3<f32>(_e819, _e834, _e849);
                                                                            let _e1049 = vec3<f32>(_e865, _e880, _e895);
                                                                            let _e1050 = (_e819 - _e759);
                                                                            let _e1051 = (_e834 - _e781);
                                                                            let _e1052 = (_e849 - _e803);
                                                                            let _e1053 = vec3<f32>(_e1050, _e1051, _e1052);
                                                                            let _e1054 = (_e865 - _e819);
                                                                            let _e1055 = (_e880 - _e834);
                                                                            let _e1056 = (_e895 - _e849);
                                                                            let _e1057 = vec3<f32>(_e1054, _e1055, _e1056);
                                                                            let _e1058 = (_e759 - _e865);
                                                                            let _e1059 = (_e781 - _e880);
                                                                            let _e1060 = (_e803 - _e895);
                                                                            let _e1061 = vec3<f32>(_e1058, _e1059, _e1060);
                                                                            let _e1064 = bitcast<f32>((bitcast<u32>(_e1050) & 2147483647u));
                                                                            let _e1067 = bitcast<f32>((bitcast<u32>(_e1051) & 2147483647u));
                                                                            let _e1069 = select(_e1067, _e1064, (_e1064 > _e1067));
                                                                            let _e1072 = bitcast<f32>((bitcast<u32>(_e1052) & 2147483647u));
                                                                            let _e1074 = select(_e1072, _e1069, (_e1069 > _e1072));
                                                                            let _e1077 = bitcast<f32>((bitcast<u32>(_e1054) & 2147483647u));
                                                                            let _e1080 = bitcast<f32>((bitcast<u32>(_e1055) & 2147483647u));
                                                                            let _e1082 = select(_e1080, _e1077, (_e1077 > _e1080));
                                                                            let _e1085 = bitcast<f32>((bitcast<u32>(_e1056) & 2147483647u));
                                                                            let _e1087 = select(_e1085, _e1082, (_e1082 > _e1085));
                                                                            let _e1090 = bitcast<f32>((bitcast<u32>(_e1058) & 2147483647u));
                                                                            let _e1093 = bitcast<f32>((bitcast<u32>(_e1059) & 2147483647u));
                                                                            let _e1095 = select(_e1093, _e1090, (_e1090 > _e1093));
                                                                            let _e1098 = bitcast<f32>((bitcast<u32>(_e1060) & 2147483647u));
                                                                            let _e1100 = select(_e1098, _e1095, (_e1095 > _e1098));
                                                                            let _e1102 = select(_e1087, _e1074, (_e1074 > _e1087));
                                                                            let _e1104 = select(_e1100, _e1102, (_e1102 > _e1100));
                                                                            if (_e1074 == _e1104) {
                                                                                phi_2182_ = _e915;
                                                                                phi_2183_ = _e912;
                                                                                phi_2184_ = _e906;
                                                                                phi_2185_ = _e903;
                                                                                phi_2186_ = _e1047;
                                                                                phi_2187_ = _e1061;
                                                                                phi_2188_ = _e1057;
                                                                                phi_2189_ = _e1053;
                                                                            } else {
                                                                                let _e1106 = (_e1087 == _e1104);
                                                                                let _e1111 = vec3(_e1106);
                                                                                phi_2182_ = select(_e906, _e924, _e1106);
                                                                                phi_2183_ = select(_e903, _e921, _e1106);
                                                                                phi_2184_ = select(_e924, _e915, _e1106);
                                                                                phi_2185_ = select(_e921, _e912, _e1106);
                                                                                phi_2186_ = select(_e1049, _e1048, _e1111);
                                                                                phi_2187_ = select(_e1057, _e1053, _e1111);
                                                                                phi_2188_ = select(_e1053, _e1061, _e1111);
                                                                                phi_2189_ = select(_e1061, _e1057, _e1111);
                                                                            }
                                                                            let _e1117 = phi_2182_;
                                                                            let _e1119 = phi_2183_;
                                                                            let _e1121 = phi_2184_;
                                                                            let _e1123 = phi_2185_;
                                                                            let _e1125 = phi_2186_;
                                                                            let _e1127 = phi_2187_;
                                                                            let _e1129 = phi_2188_;
                                                                            let _e1131 = phi_2189_;
                                                                            let _e1138 = ((_e1129.y * _e1127.z) - (_e1127.y * _e1129.z));
                                                                            let _e1143 = ((_e1129.z * _e1127.x) - (_e1127.z * _e1129.x));
                                                                            let _e1146 = ((_e1129.x * _e1127.y) - (_e1127.x * _e1129.y));
                                                                            if (_e946 >= _e950) {
                                                                                phi_2226_ = select(true, false, (_e946 >= _e954));
                                                                            } else {
                                                                                phi_2226_ = true;
                                                                            }
                                                                            let _e1151 = phi_2226_;
                                                                            if _e1151 {
                                                                                phi_2235_ = select(_e1049, _e1048, vec3((_e950 >= _e954)));
                                                                            } else {
                                                                                phi_2235_ = _e1047;
                                                                            }
                                                                            let _e1156 = phi_2235_;
                                                                            let _e1167 = (((_e1138 * (_e1156.x - _e308)) + (_e1143 * (_e1156.y - _e375))) + (_e1146 * (_e1156.z - _e441)));
                                                                            let _e1172 = (((_e1138 * _e348) + (_e1143 * _e414)) + (_e1146 * _e480));
                                                                            let _e1173 = (_e1119 - _e1123);
                                                                            let _e1174 = (_e1117 - _e1121);
                                                                            let _e1182 = (-(((_e1123 * _e1173) + (_e1121 * _e1174))) / ((_e1173 * _e1173) + (_e1174 * _e1174)));
                                                                            let _e1184 = select(1f, _e1182, (_e1182 < 1f));
                                                                            let _e1186 = select(0f, _e1184, (_e1184 > 0f));
                                                                            let _e1199 = ((_e1125.x + (_e1131.x * _e1186)) - _e308);
                                                                            let _e1200 = ((_e1125.y + (_e1131.y * _e1186)) - _e375);
                                                                            let _e1201 = ((_e1125.z + (_e1131.z * _e1186)) - _e441);
                                                                            let _e1202 = (_e1201 / _e480);
                                                                            let _e1214 = bitcast<f32>((bitcast<u32>(_e1199) & 2147483647u));
                                                                            let _e1217 = bitcast<f32>((bitcast<u32>(_e1200) & 2147483647u));
                                                                            let _e1219 = select(_e1217, _e1214, (_e1214 > _e1217));
                                                                            let _e1222 = bitcast<f32>((bitcast<u32>(_e1201) & 2147483647u));
                                                                            let _e1224 = select(_e1222, _e1219, (_e1219 > _e1222));
                                                                            let _e1230 = bitcast<f32>((bitcast<u32>(_e1138) & 2147483647u));
                                                                            let _e1233 = bitcast<f32>((bitcast<u32>(_e1143) & 2147483647u));
                                                                            let _e1235 = select(_e1233, _e1230, (_e1230 > _e1233));
                                                                            let _e1238 = bitcast<f32>((bitcast<u32>(_e1146) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1138 * _e1199) + (_e1143 * _e1200)) + (_e1146 * _e1201)) - _e1167)) & 2147483647u)) <= ((0.0000009536743f * select(_e1104, _e1224, (_e1224 > _e1104))) * select(_e1238, _e1235, (_e1235 > _e1238)))) {
                                                                                let _e1248 = bitcast<f32>((bitcast<u32>(_e1129.x) & 2147483647u));
                                                                                let _e1251 = bitcast<f32>((bitcast<u32>(_e1129.y) & 2147483647u));
                                                                                let _e1253 = select(_e1251, _e1248, (_e1248 > _e1251));
                                                                                let _e1256 = bitcast<f32>((bitcast<u32>(_e1129.z) & 2147483647u));
                                                                                let _e1262 = bitcast<f32>((bitcast<u32>(_e1127.x) & 2147483647u));
                                                                                let _e1265 = bitcast<f32>((bitcast<u32>(_e1127.y) & 2147483647u));
                                                                                let _e1267 = select(_e1265, _e1262, (_e1262 > _e1265));
                                                                                let _e1270 = bitcast<f32>((bitcast<u32>(_e1127.z) & 2147483647u));
                                                                                let _e1274 = (bitcast<f32>((bitcast<u32>(_e1172) & 2147483647u)) > ((0.0000038146973f * select(_e1256, _e1253, (_e1253 > _e1256))) * select(_e1270, _e1267, (_e1267 > _e1270))));
                                                                                if _e1274 {
                                                                                    phi_2400_ = (_e1167 / _e1172);
                                                                                } else {
                                                                                    phi_2400_ = f32();
                                                                                }
                                                                                let _e1277 = phi_2400_;
                                                                                phi_2402_ = _e1277;
                                                                                phi_2403_ = select(true, false, _e1274);
                                                                            } else {
                                                                                phi_2402_ = f32();
                                                                                phi_2403_ = true;
                                                                            }
                                                                            let _e1280 = phi_2402_;
                                                                            let _e1282 = phi_2403_;
                                                                            if _e1282 {
                                                                                let _e1290 = (((_e1138 * (_e1199 - (_e348 * _e1202))) + (_e1143 * (_e1200 - (_e414 * _e1202)))) / _e1172);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1290) & 2147483647u)) <= _e1104) {
                                                                                    phi_2423_ = (_e1202 + _e1290);
                                                                                } else {
                                                                                    phi_2423_ = _e1202;
                                                                                }
                                                                                let _e1297 = phi_2423_;
                                                                                phi_2424_ = _e1297;
                                                                            } else {
                                                                                phi_2424_ = _e1280;
                                                                            }
                                                                            let _e1299 = phi_2424_;
                                                                            let _e1301 = select(_e1037, _e1299, (_e1299 < _e1037));
                                                                            let _e1303 = select(_e1029, _e1301, (_e1301 > _e1029));
                                                                            if (_e1303 >= _e594) {
                                                                                let _e1305 = (_e1303 <= _e689.member.member_1);
                                                                                if _e1305 {
                                                                                    let _e1306 = (1f / _e956);
                                                                                    phi_2447_ = type_19(_e1303, (_e950 * _e1306), (_e954 * _e1306), _e723);
                                                                                } else {
                                                                                    phi_2447_ = type_19();
                                                                                }
                                                                                let _e1311 = phi_2447_;
                                                                                phi_2449_ = _e1311;
                                                                                phi_2450_ = select(true, false, _e1305);
                                                                            } else {
                                                                                phi_2449_ = type_19();
                                                                                phi_2450_ = true;
                                                                            }
                                                                            let _e1314 = phi_2449_;
                                                                            let _e1316 = phi_2450_;
                                                                            if _e1316 {
                                                                                phi_2454_ = type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2454_ = _e1314;
                                                                            }
                                                                            let _e1318 = phi_2454_;
                                                                            phi_2455_ = _e1318;
                                                                        }
                                                                        let _e1320 = phi_2455_;
                                                                        phi_2456_ = _e1320;
                                                                        phi_2457_ = _e1046;
                                                                    }
                                                                    let _e1322 = phi_2456_;
                                                                    let _e1324 = phi_2457_;
                                                                    phi_2461_ = _e1322;
                                                                    phi_2462_ = _e1324;
                                                                }
                                                                let _e1326 = phi_2461_;
                                                                let _e1328 = phi_2462_;
                                                                phi_2463_ = _e1326;
                                                                phi_2464_ = _e981;
                                                                phi_2465_ = _e1328;
                                                            }
                                                            let _e1330 = phi_2463_;
                                                            let _e1332 = phi_2464_;
                                                            let _e1334 = phi_2465_;
                                                            phi_2466_ = _e1330;
                                                            phi_2467_ = _e1332;
                                                            phi_2468_ = _e1334;
                                                        }
                                                        let _e1336 = phi_2466_;
                                                        let _e1338 = phi_2467_;
                                                        let _e1340 = phi_2468_;
                                                        phi_2476_ = _e1336;
                                                        phi_2477_ = select(_e1340, true, _e1338);
                                                    } else {
                                                        phi_2476_ = type_19();
                                                        phi_2477_ = true;
                                                    }
                                                    let _e1343 = phi_2476_;
                                                    let _e1345 = phi_2477_;
                                                    if _e1345 {
                                                        phi_2481_ = type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2481_ = _e1343;
                                                    }
                                                    let _e1347 = phi_2481_;
                                                    if (_e1347.member_3 != 4294967295u) {
                                                        if (_e723 != _e600) {
                                                            if (_e1347.member < _e689.member.member.member) {
                                                                phi_2507_ = true;
                                                            } else {
                                                                if (_e1347.member == _e689.member.member.member) {
                                                                    phi_2506_ = (_e1347.member_3 < _e689.member.member.member_3);
                                                                } else {
                                                                    phi_2506_ = false;
                                                                }
                                                                let _e1362 = phi_2506_;
                                                                phi_2507_ = _e1362;
                                                            }
                                                            let _e1364 = phi_2507_;
                                                            if _e1364 {
                                                                phi_2514_ = type_36(type_34(_e1347, _e1347.member), _e716.member_1, _e716.member_2);
                                                            } else {
                                                                phi_2514_ = _e716;
                                                            }
                                                            let _e1371 = phi_2514_;
                                                            phi_2515_ = _e1371;
                                                        } else {
                                                            phi_2515_ = _e716;
                                                        }
                                                        let _e1373 = phi_2515_;
                                                        phi_2516_ = _e1373;
                                                    } else {
                                                        phi_2516_ = _e716;
                                                    }
                                                    let _e1375 = phi_2516_;
                                                    phi_1251_ = _e1375;
                                                } else {
                                                    phi_1251_ = type_36();
                                                }
                                                let _e1377 = phi_1251_;
                                                continue;
                                                continuing {
                                                    phi_1250_ = _e1377;
                                                    phi_1253_ = _e704;
                                                    phi_3862_ = _e631;
                                                    break if !(_e710);
                                                }
                                            }
                                            let _e1380 = phi_3862_;
                                            phi_4040_ = _e1380;
                                            if _e1380 {
                                                break;
                                            }
                                            phi_4099_ = _e1380;
                                            let _e2076 = local_12;
                                            phi_2517_ = _e2076;
                                        } else {
                                            phi_4099_ = _e631;
                                            phi_2517_ = _e633;
                                        }
                                        let _e1382 = phi_4099_;
                                        let _e1384 = phi_2517_;
                                        if _e681 {
                                            phi_3528_ = type_36();
                                            phi_3529_ = bool();
                                            phi_3530_ = u32();
                                            phi_3531_ = type_53();
                                        } else {
                                            let _e1385 = (_e677.member_1 < _e88);
                                            if _e1385 {
                                                if _e1385 {
                                                } else {
                                                    phi_4040_ = true;
                                                    break;
                                                }
                                                let _e1387 = global_6.member[_e677.member_1];
                                                phi_2538_ = _e1387;
                                            } else {
                                                phi_2538_ = type_40(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e1389 = phi_2538_;
                                            let _e1404 = ((10u * _e261) & 31u);
                                            let _e1407 = ((_e1389.member[0] >> bitcast<u32>(_e1404)) & 1023u);
                                            let _e1415 = bitcast<f32>((bitcast<u32>(((_e677.member.member_1[0] - _e677.member.member[0]) * 0.0009775171f)) ^ _e127));
                                            let _e1420 = (_e677.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1407)) - 8388608f) * _e1415)) ^ _e127)));
                                            let _e1424 = select(select(_e677.member.member_1[0], _e1420, (_e1420 < _e677.member.member_1[0])), _e677.member.member_1[0], (_e1407 == 1023u));
                                            let _e1426 = ((10u * _e260) & 31u);
                                            let _e1429 = ((_e1389.member[0] >> bitcast<u32>(_e1426)) & 1023u);
                                            let _e1437 = bitcast<f32>((bitcast<u32>(((_e677.member.member_1[1] - _e677.member.member[1]) * 0.0009775171f)) ^ _e127));
                                            let _e1442 = (_e677.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1429)) - 8388608f) * _e1437)) ^ _e127)));
                                            let _e1446 = select(select(_e677.member.member_1[1], _e1442, (_e1442 < _e677.member.member_1[1])), _e677.member.member_1[1], (_e1429 == 1023u));
                                            let _e1448 = ((10u * _e262) & 31u);
                                            let _e1451 = ((_e1389.member[0] >> bitcast<u32>(_e1448)) & 1023u);
                                            let _e1459 = bitcast<f32>((bitcast<u32>(((_e677.member.member_1[2] - _e677.member.member[2]) * 0.0009775171f)) ^ _e127));
                                            let _e1464 = (_e677.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1451)) - 8388608f) * _e1459)) ^ _e127)));
                                            let _e1468 = select(select(_e677.member.member_1[2], _e1464, (_e1464 < _e677.member.member_1[2])), _e677.member.member_1[2], (_e1451 == 1023u));
                                            let _e1471 = ((_e1389.member[1] >> bitcast<u32>(_e1404)) & 1023u);
                                            let _e1479 = (_e677.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1471)) - 8388608f) * _e1415)) ^ _e127)));
                                            let _e1483 = select(select(_e677.member.member_1[0], _e1479, (_e1479 < _e677.member.member_1[0])), _e677.member.member_1[0], (_e1471 == 1023u));
                                            let _e1486 = ((_e1389.member[1] >> bitcast<u32>(_e1426)) & 1023u);
                                            let _e1494 = (_e677.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1486)) - 8388608f) * _e1437)) ^ _e127)));
                                            let _e1498 = select(select(_e677.member.member_1[1], _e1494, (_e1494 < _e677.member.member_1[1])), _e677.member.member_1[1], (_e1486 == 1023u));
                                            let _e1501 = ((_e1389.member[1] >> bitcast<u32>(_e1448)) & 1023u);
                                            let _e1509 = (_e677.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1501)) - 8388608f) * _e1459)) ^ _e127)));
                                            let _e1513 = select(select(_e677.member.member_1[2], _e1509, (_e1509 < _e677.member.member_1[2])), _e677.member.member_1[2], (_e1501 == 1023u));
                                            let _e1519 = ((_e1389.member_1[0] >> bitcast<u32>(_e1404)) & 1023u);
                                            let _e1527 = (_e677.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1519)) - 8388608f) * _e1415)) ^ _e127)));
                                            let _e1531 = select(select(_e677.member.member_1[0], _e1527, (_e1527 < _e677.member.member_1[0])), _e677.member.member_1[0], (_e1519 == 1023u));
                                            let _e1534 = ((_e1389.member_1[0] >> bitcast<u32>(_e1426)) & 1023u);
                                            let _e1542 = (_e677.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1534)) - 8388608f) * _e1437)) ^ _e127)));
                                            let _e1546 = select(select(_e677.member.member_1[1], _e1542, (_e1542 < _e677.member.member_1[1])), _e677.member.member_1[1], (_e1534 == 1023u));
                                            let _e1549 = ((_e1389.member_1[0] >> bitcast<u32>(_e1448)) & 1023u);
                                            let _e1557 = (_e677.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1549)) - 8388608f) * _e1459)) ^ _e127)));
                                            let _e1561 = select(select(_e677.member.member_1[2], _e1557, (_e1557 < _e677.member.member_1[2])), _e677.member.member_1[2], (_e1549 == 1023u));
                                            let _e1564 = ((_e1389.member_1[1] >> bitcast<u32>(_e1404)) & 1023u);
                                            let _e1572 = (_e677.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1564)) - 8388608f) * _e1415)) ^ _e127)));
                                            let _e1576 = select(select(_e677.member.member_1[0], _e1572, (_e1572 < _e677.member.member_1[0])), _e677.member.member_1[0], (_e1564 == 1023u));
                                            let _e1579 = ((_e1389.member_1[1] >> bitcast<u32>(_e1426)) & 1023u);
                                            let _e1587 = (_e677.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1579)) - 8388608f) * _e1437)) ^ _e127)));
                                            let _e1591 = select(select(_e677.member.member_1[1], _e1587, (_e1587 < _e677.member.member_1[1])), _e677.member.member_1[1], (_e1579 == 1023u));
                                            let _e1594 = ((_e1389.member_1[1] >> bitcast<u32>(_e1448)) & 1023u);
                                            let _e1602 = (_e677.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1594)) - 8388608f) * _e1459)) ^ _e127)));
                                            let _e1606 = select(select(_e677.member.member_1[2], _e1602, (_e1602 < _e677.member.member_1[2])), _e677.member.member_1[2], (_e1594 == 1023u));
                                            let _e1611 = type_53(type_45(array<f32, 3>(_e1424, _e1446, _e1468), array<f32, 3>(_e1483, _e1498, _e1513)), _e1389.member_2);
                                            let _e1616 = type_53(type_45(array<f32, 3>(_e1531, _e1546, _e1561), array<f32, 3>(_e1576, _e1591, _e1606)), _e1389.member_3);
                                            let _e1629 = ((_e1424 - _e346) * _e351);
                                            let _e1630 = ((_e1531 - _e346) * _e351);
                                            let _e1631 = ((_e1483 - _e347) * _e351);
                                            let _e1632 = ((_e1576 - _e347) * _e351);
                                            let _e1637 = ((_e1446 - _e412) * _e417);
                                            let _e1638 = ((_e1546 - _e412) * _e417);
                                            let _e1639 = ((_e1498 - _e413) * _e417);
                                            let _e1640 = ((_e1591 - _e413) * _e417);
                                            let _e1645 = ((_e1468 - _e478) * _e483);
                                            let _e1646 = ((_e1561 - _e478) * _e483);
                                            let _e1647 = ((_e1513 - _e479) * _e483);
                                            let _e1648 = ((_e1606 - _e479) * _e483);
                                            let _e1650 = select(_e1647, _e1645, (_e1645 < _e1647));
                                            let _e1652 = select(_e1648, _e1646, (_e1646 < _e1648));
                                            let _e1654 = select(_e1647, _e1645, (_e1645 > _e1647));
                                            let _e1656 = select(_e1648, _e1646, (_e1646 > _e1648));
                                            let _e1658 = select(_e1631, _e1629, (_e1629 < _e1631));
                                            let _e1660 = select(_e1632, _e1630, (_e1630 < _e1632));
                                            let _e1662 = select(_e1639, _e1637, (_e1637 < _e1639));
                                            let _e1664 = select(_e1640, _e1638, (_e1638 < _e1640));
                                            let _e1666 = select(_e1662, _e1658, (_e1658 > _e1662));
                                            let _e1668 = select(_e1664, _e1660, (_e1660 > _e1664));
                                            let _e1670 = select(_e1650, _e1666, (_e1666 > _e1650));
                                            let _e1672 = select(_e1652, _e1668, (_e1668 > _e1652));
                                            let _e1674 = select(_e1631, _e1629, (_e1629 > _e1631));
                                            let _e1676 = select(_e1632, _e1630, (_e1630 > _e1632));
                                            let _e1678 = select(_e1639, _e1637, (_e1637 > _e1639));
                                            let _e1680 = select(_e1640, _e1638, (_e1638 > _e1640));
                                            let _e1682 = select(_e1678, _e1674, (_e1674 < _e1678));
                                            let _e1684 = select(_e1680, _e1676, (_e1676 < _e1680));
                                            let _e1689 = -(_e1650);
                                            let _e1690 = -(_e1652);
                                            let _e1697 = (select(_e1654, _e1682, (_e1682 < _e1654)) + (select(_e1689, _e1654, (_e1654 > _e1689)) * 0.0000019073523f));
                                            let _e1698 = (select(_e1656, _e1684, (_e1684 < _e1656)) + (select(_e1690, _e1656, (_e1656 > _e1690)) * 0.0000019073523f));
                                            let _e1700 = select(_e594, _e1670, (_e1670 > _e594));
                                            let _e1702 = select(_e594, _e1672, (_e1672 > _e594));
                                            let _e1707 = (_e1700 <= select(_e1384.member.member_1, _e1697, (_e1697 < _e1384.member.member_1)));
                                            let _e1708 = (_e1702 <= select(_e1384.member.member_1, _e1698, (_e1698 < _e1384.member.member_1)));
                                            let _e1709 = (_e1700 <= _e1702);
                                            if _e1707 {
                                                if _e1708 {
                                                    if _e1709 {
                                                        phi_3427_ = _e1616;
                                                    } else {
                                                        phi_3427_ = _e1611;
                                                    }
                                                    let _e1711 = phi_3427_;
                                                    let _e1718 = (_e675 % 128u);
                                                    let _e1719 = (_e1718 < 128u);
                                                    if _e1719 {
                                                    } else {
                                                        phi_4040_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1718] = _e1711.member_1;
                                                    if _e1719 {
                                                    } else {
                                                        phi_4040_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1718] = _e1711.member.member[0];
                                                    if _e1719 {
                                                    } else {
                                                        phi_4040_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1718] = _e1711.member.member[1];
                                                    if _e1719 {
                                                    } else {
                                                        phi_4040_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1718] = _e1711.member.member[2];
                                                    if _e1719 {
                                                    } else {
                                                        phi_4040_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1718] = _e1711.member.member_1[0];
                                                    if _e1719 {
                                                    } else {
                                                        phi_4040_ = true;
                                                        break;
                                                    }
                                                    local_1[_e1718] = _e1711.member.member_1[1];
                                                    if _e1719 {
                                                    } else {
                                                        phi_4040_ = true;
                                                        break;
                                                    }
                                                    local[_e1718] = _e1711.member.member_1[2];
                                                    if _e1719 {
                                                    } else {
                                                        phi_4040_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1718] = select(_e1700, _e1702, _e1709);
                                                    if _e1709 {
                                                        phi_3503_ = _e1611;
                                                    } else {
                                                        phi_3503_ = _e1616;
                                                    }
                                                    let _e1736 = phi_3503_;
                                                    phi_3504_ = (_e675 + 1u);
                                                    phi_3505_ = _e1736;
                                                } else {
                                                    phi_3504_ = u32();
                                                    phi_3505_ = type_53();
                                                }
                                                let _e1738 = phi_3504_;
                                                let _e1740 = phi_3505_;
                                                phi_3507_ = _e1738;
                                                phi_3508_ = _e1740;
                                                phi_3509_ = select(true, false, _e1708);
                                            } else {
                                                phi_3507_ = u32();
                                                phi_3508_ = type_53();
                                                phi_3509_ = true;
                                            }
                                            let _e1743 = phi_3507_;
                                            let _e1745 = phi_3508_;
                                            let _e1747 = phi_3509_;
                                            if _e1747 {
                                                if _e1707 {
                                                    phi_3516_ = _e1611;
                                                } else {
                                                    phi_3516_ = _e1616;
                                                }
                                                let _e1749 = phi_3516_;
                                                phi_3521_ = select(_e1708, true, _e1707);
                                                phi_3523_ = _e1749;
                                            } else {
                                                phi_3521_ = _e673;
                                                phi_3523_ = _e1745;
                                            }
                                            let _e1752 = phi_3521_;
                                            let _e1754 = phi_3523_;
                                            phi_3528_ = type_36(_e1384.member, (_e1384.member_1 + 1u), _e1384.member_2);
                                            phi_3529_ = _e1752;
                                            phi_3530_ = select(_e1743, _e675, _e1747);
                                            phi_3531_ = _e1754;
                                        }
                                        let _e1757 = phi_3528_;
                                        let _e1759 = phi_3529_;
                                        let _e1761 = phi_3530_;
                                        let _e1763 = phi_3531_;
                                        if _e681 {
                                            phi_3539_ = _e1384;
                                            phi_3542_ = _e677;
                                        } else {
                                            phi_3539_ = _e1757;
                                            phi_3542_ = _e1763;
                                        }
                                        let _e1765 = phi_3539_;
                                        let _e1767 = phi_3542_;
                                        phi_4043_ = _e1382;
                                        phi_3543_ = _e1765;
                                        phi_3544_ = (_e635 - 1u);
                                        phi_3545_ = select(_e1759, false, _e681);
                                        phi_3546_ = select(_e1761, _e675, _e681);
                                        phi_3547_ = _e1767;
                                    } else {
                                        phi_4043_ = _e631;
                                        phi_3543_ = _e633;
                                        phi_3544_ = _e635;
                                        phi_3545_ = _e673;
                                        phi_3546_ = _e675;
                                        phi_3547_ = _e677;
                                    }
                                    let _e1771 = phi_4043_;
                                    let _e1773 = phi_3543_;
                                    let _e1775 = phi_3544_;
                                    let _e1777 = phi_3545_;
                                    let _e1779 = phi_3546_;
                                    let _e1781 = phi_3547_;
                                    phi_4042_ = _e1771;
                                    phi_3548_ = _e1773;
                                    phi_3549_ = _e1775;
                                    phi_3550_ = _e1777;
                                    phi_3551_ = _e1779;
                                    phi_3552_ = _e1781;
                                } else {
                                    phi_4042_ = _e631;
                                    phi_3548_ = type_36();
                                    phi_3549_ = u32();
                                    phi_3550_ = bool();
                                    phi_3551_ = u32();
                                    phi_3552_ = type_53();
                                }
                                let _e1783 = phi_4042_;
                                let _e1785 = phi_3548_;
                                let _e1787 = phi_3549_;
                                let _e1789 = phi_3550_;
                                let _e1791 = phi_3551_;
                                let _e1793 = phi_3552_;
                                phi_4041_ = _e1783;
                                phi_1124_ = _e1785;
                                phi_1127_ = _e1787;
                                phi_1129_ = _e1789;
                                phi_1131_ = _e1791;
                                phi_1133_ = _e1793;
                                phi_3553_ = _e645;
                            } else {
                                phi_4041_ = _e631;
                                phi_1124_ = type_36();
                                phi_1127_ = u32();
                                phi_1129_ = bool();
                                phi_1131_ = u32();
                                phi_1133_ = type_53();
                                phi_3553_ = false;
                            }
                            let _e1795 = phi_4041_;
                            let _e1797 = phi_1124_;
                            let _e1799 = phi_1127_;
                            let _e1801 = phi_1129_;
                            let _e1803 = phi_1131_;
                            let _e1805 = phi_1133_;
                            let _e1807 = phi_3553_;
                            continue;
                            continuing {
                                phi_3868_ = _e1795;
                                phi_1123_ = _e1797;
                                phi_1126_ = _e1799;
                                phi_1128_ = _e1801;
                                phi_1130_ = _e1803;
                                phi_1132_ = _e1805;
                                phi_4040_ = _e1795;
                                break if !(_e1807);
                            }
                        }
                        let _e1810 = phi_4040_;
                        if _e1810 {
                            break;
                        }
                        let _e1812 = local_10;
                        if (_e1812.member.member.member_3 != 4294967295u) {
                            let _e1818 = bitcast<u32>(_e1812.member.member.member);
                            let _e1822 = (bitcast<i32>((_e1818 >> bitcast<u32>(23i))) & 255i);
                            let _e1823 = (_e1822 + _e263);
                            if (_e1822 == 255i) {
                                phi_3612_ = _e1812.member.member.member;
                            } else {
                                if (_e1822 > 0i) {
                                    if (_e1823 > 0i) {
                                        let _e1827 = (_e1823 < 255i);
                                        if _e1827 {
                                            phi_3591_ = bitcast<f32>((_e1818 + bitcast<u32>((_e263 << bitcast<u32>(23i)))));
                                        } else {
                                            phi_3591_ = f32();
                                        }
                                        let _e1834 = phi_3591_;
                                        phi_3593_ = _e1834;
                                        phi_3594_ = select(true, false, _e1827);
                                    } else {
                                        phi_3593_ = f32();
                                        phi_3594_ = true;
                                    }
                                    let _e1837 = phi_3593_;
                                    let _e1839 = phi_3594_;
                                    phi_3595_ = _e1837;
                                    phi_3596_ = _e1839;
                                } else {
                                    phi_3595_ = f32();
                                    phi_3596_ = true;
                                }
                                let _e1841 = phi_3595_;
                                let _e1843 = phi_3596_;
                                if _e1843 {
                                    let _e1844 = (_e1818 & 2147483648u);
                                    let _e1851 = ((_e1818 & 8388607u) | (select(0u, 1u, ((_e1818 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                    let _e1855 = (_e1851 == 0u);
                                    if _e1855 {
                                        phi_3832_ = bitcast<f32>(_e1844);
                                    } else {
                                        let _e1860 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1851)), 32u, _e1855) - 8u);
                                        let _e1863 = (_e1851 << bitcast<u32>((_e1860 & 31u)));
                                        let _e1865 = ((_e1823 + select(0i, 1i, (_e1822 == 0i))) - bitcast<i32>(_e1860));
                                        if (_e1865 >= 255i) {
                                            phi_3822_ = bitcast<f32>((_e1844 | 2139095040u));
                                            phi_3823_ = f32();
                                            phi_3824_ = true;
                                        } else {
                                            let _e1867 = (_e1865 > 0i);
                                            if _e1867 {
                                                phi_3816_ = bitcast<f32>(((_e1844 | (bitcast<u32>(_e1865) << bitcast<u32>(23i))) | (_e1863 & 8388607u)));
                                                phi_3817_ = f32();
                                            } else {
                                                if (_e1865 < -24i) {
                                                    phi_3782_ = 26u;
                                                } else {
                                                    phi_3782_ = bitcast<u32>((1i - _e1865));
                                                }
                                                let _e1872 = phi_3782_;
                                                let _e1873 = (_e1872 & 31u);
                                                let _e1875 = (_e1863 >> bitcast<u32>(_e1873));
                                                let _e1879 = (_e1863 & ((1u << bitcast<u32>(_e1873)) - 1u));
                                                let _e1883 = (1u << bitcast<u32>(((_e1872 - 1u) & 31u)));
                                                if (_e1879 > _e1883) {
                                                    phi_3803_ = true;
                                                } else {
                                                    if (_e1879 == _e1883) {
                                                        phi_3800_ = ((_e1875 & 1u) == 1u);
                                                    } else {
                                                        phi_3800_ = false;
                                                    }
                                                    let _e1889 = phi_3800_;
                                                    phi_3803_ = _e1889;
                                                }
                                                let _e1891 = phi_3803_;
                                                phi_3816_ = f32();
                                                phi_3817_ = bitcast<f32>((_e1844 | (_e1875 + select(0u, 1u, _e1891))));
                                            }
                                            let _e1904 = phi_3816_;
                                            let _e1906 = phi_3817_;
                                            phi_3822_ = _e1904;
                                            phi_3823_ = _e1906;
                                            phi_3824_ = _e1867;
                                        }
                                        let _e1910 = phi_3822_;
                                        let _e1912 = phi_3823_;
                                        let _e1914 = phi_3824_;
                                        phi_3832_ = select(_e1912, _e1910, _e1914);
                                    }
                                    let _e1918 = phi_3832_;
                                    phi_3611_ = _e1918;
                                } else {
                                    phi_3611_ = _e1841;
                                }
                                let _e1920 = phi_3611_;
                                phi_3612_ = _e1920;
                            }
                            let _e1922 = phi_3612_;
                            let _e1923 = bitcast<u32>(_e1922);
                            if ((_e1923 & 2147483647u) >= 2139095040u) {
                                phi_3624_ = bitcast<f32>(((_e1923 & 2147483648u) | 2139095039u));
                            } else {
                                phi_3624_ = _e1922;
                            }
                            let _e1930 = phi_3624_;
                            phi_3629_ = type_19(_e1930, _e1812.member.member.member_1, _e1812.member.member.member_2, _e1812.member.member.member_3);
                        } else {
                            phi_3629_ = type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1935 = phi_3629_;
                        if _e139 {
                        } else {
                            break;
                        }
                        global_1.member[_e131] = _e1935;
                        let _e1939 = local_11;
                        if _e140 {
                        } else {
                            break;
                        }
                        global_4.member[_e131] = _e1939.member_1;
                        if _e138 {
                        } else {
                            break;
                        }
                        let _e1944 = select(0u, 1u, (_e207 <= _e217));
                        if (_e1944 > 0u) {
                            let _e1946 = (1u < _e99);
                            if _e1946 {
                                if (0u < _e99) {
                                } else {
                                    break;
                                }
                                let _e1950 = atomicAdd((&global_5.member[0u]), _e1944);
                                if ((_e1950 + _e1944) < _e1950) {
                                    if _e1946 {
                                    } else {
                                        break;
                                    }
                                    let _e1955 = atomicAdd((&global_5.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1958 = select(0u, 1u, (_e1935.member_3 != 4294967295u));
                        if (_e1958 > 0u) {
                            let _e1960 = (3u < _e99);
                            if _e1960 {
                                if (2u < _e99) {
                                } else {
                                    break;
                                }
                                let _e1964 = atomicAdd((&global_5.member[2u]), _e1958);
                                if ((_e1964 + _e1958) < _e1964) {
                                    if _e1960 {
                                    } else {
                                        break;
                                    }
                                    let _e1969 = atomicAdd((&global_5.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1939.member_1 > 0u) {
                            let _e1971 = (5u < _e99);
                            if _e1971 {
                                if (4u < _e99) {
                                } else {
                                    break;
                                }
                                let _e1975 = atomicAdd((&global_5.member[4u]), _e1939.member_1);
                                if ((_e1975 + _e1939.member_1) < _e1975) {
                                    if _e1971 {
                                    } else {
                                        break;
                                    }
                                    let _e1980 = atomicAdd((&global_5.member[5u]), 1u);
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
