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
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_37 {
    member: type_34,
    member_1: u32,
    member_2: u32,
}

struct type_39 {
    member: array<vec4<u32>, 2>,
}

struct type_41 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_43 {
    member: array<type_41>,
}

struct type_46 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_48 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_50 {
    member: array<type_48>,
}

struct type_54 {
    member: type_46,
    member_1: u32,
}

struct type_59 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(4) 
var<storage, read_write> global_1: type_21;
@group(0) @binding(0) 
var<uniform> global_2: type_39;
@group(0) @binding(3) 
var<storage> global_3: type_26;
@group(0) @binding(5) 
var<storage, read_write> global_4: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_5: type_59;
@group(0) @binding(1) 
var<storage> global_6: type_43;
@group(0) @binding(2) 
var<storage> global_7: type_50;

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
    var phi_458_: i32;
    var phi_459_: i32;
    var phi_469_: bool;
    var phi_479_: u32;
    var phi_480_: u32;
    var phi_482_: bool;
    var phi_487_: u32;
    var phi_520_: i32;
    var phi_538_: f32;
    var phi_544_: f32;
    var phi_584_: f32;
    var phi_590_: f32;
    var phi_663_: f32;
    var phi_669_: f32;
    var phi_709_: f32;
    var phi_715_: f32;
    var phi_788_: f32;
    var phi_794_: f32;
    var phi_834_: f32;
    var phi_840_: f32;
    var phi_959_: i32;
    var phi_981_: u32;
    var phi_982_: u32;
    var phi_1019_: i32;
    var phi_1041_: u32;
    var phi_1042_: u32;
    var phi_1050_: f32;
    var phi_1051_: f32;
    var phi_3968_: bool;
    var phi_1143_: type_37;
    var phi_1146_: u32;
    var phi_1148_: bool;
    var phi_1150_: u32;
    var phi_1152_: type_54;
    var phi_1163_: bool;
    var phi_1249_: bool;
    var phi_1250_: u32;
    var phi_1251_: type_54;
    var phi_1270_: type_37;
    var phi_1273_: type_7;
    var phi_1274_: type_7;
    var phi_1296_: type_7;
    var phi_1324_: u32;
    var phi_1340_: type_48;
    var phi_3689_: bool;
    var phi_3704_: bool;
    var phi_3719_: bool;
    var phi_3734_: bool;
    var phi_3749_: bool;
    var phi_3764_: bool;
    var phi_2147_: f32;
    var phi_2148_: f32;
    var phi_2149_: f32;
    var phi_2150_: f32;
    var phi_2151_: vec3<f32>;
    var phi_2152_: vec3<f32>;
    var phi_2153_: vec3<f32>;
    var phi_2154_: vec3<f32>;
    var phi_3779_: bool;
    var phi_3794_: bool;
    var phi_3809_: bool;
    var phi_3824_: bool;
    var phi_3839_: bool;
    var phi_3854_: bool;
    var phi_2362_: f32;
    var phi_2382_: type_36;
    var phi_2383_: type_36;
    var phi_2386_: type_36;
    var phi_2387_: type_36;
    var phi_2388_: bool;
    var phi_2392_: type_36;
    var phi_2401_: type_19;
    var phi_2426_: bool;
    var phi_2427_: bool;
    var phi_2434_: type_37;
    var phi_2435_: type_37;
    var phi_2436_: type_37;
    var phi_1271_: type_37;
    var phi_3962_: bool;
    var phi_4204_: bool;
    var phi_2437_: type_37;
    var phi_2458_: type_41;
    var phi_3347_: type_54;
    var phi_3423_: type_54;
    var phi_3424_: u32;
    var phi_3425_: type_54;
    var phi_3427_: u32;
    var phi_3428_: type_54;
    var phi_3429_: bool;
    var phi_3436_: type_54;
    var phi_3441_: bool;
    var phi_3443_: type_54;
    var phi_3448_: type_37;
    var phi_3449_: bool;
    var phi_3450_: u32;
    var phi_3451_: type_54;
    var phi_3459_: type_37;
    var phi_3462_: type_54;
    var phi_4148_: bool;
    var phi_3463_: type_37;
    var phi_3464_: u32;
    var phi_3465_: bool;
    var phi_3466_: u32;
    var phi_3467_: type_54;
    var phi_4147_: bool;
    var phi_3468_: type_37;
    var phi_3469_: u32;
    var phi_3470_: bool;
    var phi_3471_: u32;
    var phi_3472_: type_54;
    var phi_4146_: bool;
    var phi_1144_: type_37;
    var phi_1147_: u32;
    var phi_1149_: bool;
    var phi_1151_: u32;
    var phi_1153_: type_54;
    var phi_3473_: bool;
    var phi_4145_: bool;
    var local_10: type_37;
    var phi_3511_: f32;
    var phi_3513_: f32;
    var phi_3514_: bool;
    var phi_3515_: f32;
    var phi_3516_: bool;
    var phi_3882_: u32;
    var phi_3900_: bool;
    var phi_3903_: bool;
    var phi_3916_: f32;
    var phi_3917_: f32;
    var phi_3922_: f32;
    var phi_3923_: f32;
    var phi_3924_: bool;
    var phi_3932_: f32;
    var phi_3531_: f32;
    var phi_3532_: f32;
    var phi_3544_: f32;
    var phi_3549_: type_19;
    var local_11: type_37;
    var local_12: type_37;

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
                                phi_458_ = (bitcast<i32>((_e226 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_458_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e226)), 32u, (_e226 == 0u))));
                            }
                            let _e240 = phi_458_;
                            phi_459_ = _e240;
                        } else {
                            phi_459_ = 0i;
                        }
                        let _e242 = phi_459_;
                        let _e243 = (_e152 == _e196);
                        if _e243 {
                            phi_469_ = true;
                        } else {
                            phi_469_ = (_e160 == _e196);
                        }
                        let _e246 = phi_469_;
                        let _e247 = select(1u, 0u, _e243);
                        if _e246 {
                            let _e248 = (_e247 + 1u);
                            phi_479_ = _e248;
                            phi_480_ = _e248;
                            phi_482_ = select(true, false, (_e248 == 2u));
                        } else {
                            phi_479_ = u32();
                            phi_480_ = 0u;
                            phi_482_ = true;
                        }
                        let _e252 = phi_479_;
                        let _e254 = phi_480_;
                        let _e256 = phi_482_;
                        if _e256 {
                            phi_487_ = (_e254 + 1u);
                        } else {
                            phi_487_ = 0u;
                        }
                        let _e260 = phi_487_;
                        let _e261 = select(_e252, _e254, _e256);
                        let _e262 = select(_e247, select(2u, _e247, _e246), _e256);
                        let _e263 = -(_e242);
                        if (_e263 < -126i) {
                            phi_520_ = -126i;
                        } else {
                            phi_520_ = select(_e263, 127i, (_e263 > 127i));
                        }
                        let _e268 = phi_520_;
                        let _e273 = bitcast<f32>((bitcast<u32>((_e268 + 127i)) << bitcast<u32>(23i)));
                        let _e279 = bitcast<f32>((bitcast<u32>(((_e263 - _e268) + 127i)) << bitcast<u32>(23i)));
                        let _e284 = global_3.member[_e131].member.member;
                        let _e285 = (_e261 == 0u);
                        if _e285 {
                            phi_538_ = _e284[0];
                        } else {
                            phi_538_ = _e284[1];
                        }
                        let _e289 = phi_538_;
                        let _e290 = (_e261 == 2u);
                        if _e290 {
                            phi_544_ = _e284[2];
                        } else {
                            phi_544_ = _e289;
                        }
                        let _e293 = phi_544_;
                        let _e294 = bitcast<u32>(_e293);
                        let _e296 = ((_e294 & 2139095040u) != 0u);
                        let _e308 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e294 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e294 & 2147483648u))), _e293, _e296) * select(0.00000011920929f, 1f, _e296));
                        let _e309 = global_3.member[_e131].member.member_2;
                        if _e285 {
                            phi_584_ = _e309[0];
                        } else {
                            phi_584_ = _e309[1];
                        }
                        let _e313 = phi_584_;
                        if _e290 {
                            phi_590_ = _e309[2];
                        } else {
                            phi_590_ = _e313;
                        }
                        let _e316 = phi_590_;
                        let _e317 = bitcast<u32>(_e316);
                        let _e319 = ((_e317 & 2139095040u) != 0u);
                        let _e333 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e317 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e317 & 2147483648u))), _e316, _e319) * _e273) * select(0.00000011920929f, 1f, _e319)) * _e279);
                        let _e337 = (bitcast<f32>((bitcast<u32>(_e333) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e340 = bitcast<f32>((bitcast<u32>(_e308) & 2147483647u));
                        let _e341 = (_e340 * 0.00000011920929f);
                        let _e344 = select(select(0.00000000000011368684f, _e341, (_e341 > 0.00000000000011368684f)), 0f, _e337);
                        let _e345 = select(0f, _e333, _e337);
                        let _e346 = (_e308 + _e344);
                        let _e347 = (_e308 - _e344);
                        let _e349 = select(38685626000000000000000000f, (1f / _e333), _e337);
                        let _e350 = (_e260 == 0u);
                        if _e350 {
                            phi_663_ = _e284[0];
                        } else {
                            phi_663_ = _e284[1];
                        }
                        let _e354 = phi_663_;
                        let _e355 = (_e260 == 2u);
                        if _e355 {
                            phi_669_ = _e284[2];
                        } else {
                            phi_669_ = _e354;
                        }
                        let _e358 = phi_669_;
                        let _e359 = bitcast<u32>(_e358);
                        let _e361 = ((_e359 & 2139095040u) != 0u);
                        let _e373 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e359 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e359 & 2147483648u))), _e358, _e361) * select(0.00000011920929f, 1f, _e361));
                        if _e350 {
                            phi_709_ = _e309[0];
                        } else {
                            phi_709_ = _e309[1];
                        }
                        let _e377 = phi_709_;
                        if _e355 {
                            phi_715_ = _e309[2];
                        } else {
                            phi_715_ = _e377;
                        }
                        let _e380 = phi_715_;
                        let _e381 = bitcast<u32>(_e380);
                        let _e383 = ((_e381 & 2139095040u) != 0u);
                        let _e397 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e381 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e381 & 2147483648u))), _e380, _e383) * _e273) * select(0.00000011920929f, 1f, _e383)) * _e279);
                        let _e401 = (bitcast<f32>((bitcast<u32>(_e397) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e404 = bitcast<f32>((bitcast<u32>(_e373) & 2147483647u));
                        let _e405 = (_e404 * 0.00000011920929f);
                        let _e408 = select(select(0.00000000000011368684f, _e405, (_e405 > 0.00000000000011368684f)), 0f, _e401);
                        let _e409 = select(0f, _e397, _e401);
                        let _e410 = (_e373 + _e408);
                        let _e411 = (_e373 - _e408);
                        let _e413 = select(38685626000000000000000000f, (1f / _e397), _e401);
                        let _e414 = (_e262 == 0u);
                        if _e414 {
                            phi_788_ = _e284[0];
                        } else {
                            phi_788_ = _e284[1];
                        }
                        let _e418 = phi_788_;
                        let _e419 = (_e262 == 2u);
                        if _e419 {
                            phi_794_ = _e284[2];
                        } else {
                            phi_794_ = _e418;
                        }
                        let _e422 = phi_794_;
                        let _e423 = bitcast<u32>(_e422);
                        let _e425 = ((_e423 & 2139095040u) != 0u);
                        let _e437 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e423 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e423 & 2147483648u))), _e422, _e425) * select(0.00000011920929f, 1f, _e425));
                        if _e414 {
                            phi_834_ = _e309[0];
                        } else {
                            phi_834_ = _e309[1];
                        }
                        let _e441 = phi_834_;
                        if _e419 {
                            phi_840_ = _e309[2];
                        } else {
                            phi_840_ = _e441;
                        }
                        let _e444 = phi_840_;
                        let _e445 = bitcast<u32>(_e444);
                        let _e447 = ((_e445 & 2139095040u) != 0u);
                        let _e461 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e445 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e445 & 2147483648u))), _e444, _e447) * _e273) * select(0.00000011920929f, 1f, _e447)) * _e279);
                        let _e465 = (bitcast<f32>((bitcast<u32>(_e461) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e468 = bitcast<f32>((bitcast<u32>(_e437) & 2147483647u));
                        let _e469 = (_e468 * 0.00000011920929f);
                        let _e472 = select(select(0.00000000000011368684f, _e469, (_e469 > 0.00000000000011368684f)), 0f, _e465);
                        let _e473 = select(0f, _e461, _e465);
                        let _e474 = (_e437 + _e472);
                        let _e475 = (_e437 - _e472);
                        let _e477 = select(38685626000000000000000000f, (1f / _e461), _e465);
                        let _e479 = select(_e404, _e340, (_e340 > _e404));
                        if (_e223 && (select(_e468, _e479, (_e479 > _e468)) <= 1099511600000f)) {
                            let _e491 = ((_e209 & 8388607u) | (select(0u, 1u, ((_e209 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e494 = bitcast<i32>((_e209 >> bitcast<u32>(23i)));
                            let _e498 = (_e491 == 0u);
                            let _e501 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e491)), 32u, _e498)) - 8i);
                            if (_e494 == 255i) {
                                phi_959_ = 255i;
                            } else {
                                phi_959_ = (((_e494 + select(0i, 1i, (_e494 == 0i))) - _e501) + _e242);
                            }
                            let _e509 = phi_959_;
                            let _e519 = (_e509 <= 0i);
                            if _e519 {
                                phi_982_ = u32();
                            } else {
                                if _e498 {
                                    phi_981_ = u32();
                                } else {
                                    phi_981_ = select(((bitcast<u32>(_e509) << bitcast<u32>(23i)) | ((_e491 << bitcast<u32>(((_e501 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e509 >= 255i));
                                }
                                let _e523 = phi_981_;
                                phi_982_ = _e523;
                            }
                            let _e525 = phi_982_;
                            let _e537 = ((_e219 & 8388607u) | (select(0u, 1u, ((_e219 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e540 = bitcast<i32>((_e219 >> bitcast<u32>(23i)));
                            let _e544 = (_e537 == 0u);
                            let _e547 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e537)), 32u, _e544)) - 8i);
                            if (_e540 == 255i) {
                                phi_1019_ = 255i;
                            } else {
                                phi_1019_ = (((_e540 + select(0i, 1i, (_e540 == 0i))) - _e547) + _e242);
                            }
                            let _e555 = phi_1019_;
                            let _e565 = (_e555 <= 0i);
                            if _e565 {
                                phi_1042_ = u32();
                            } else {
                                if _e544 {
                                    phi_1041_ = u32();
                                } else {
                                    phi_1041_ = select(((bitcast<u32>(_e555) << bitcast<u32>(23i)) | ((_e537 << bitcast<u32>(((_e547 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e555 >= 255i));
                                }
                                let _e569 = phi_1041_;
                                phi_1042_ = _e569;
                            }
                            let _e571 = phi_1042_;
                            phi_1050_ = bitcast<f32>(((_e218 & 2147483648u) | select(_e571, 0u, select(_e544, true, _e565))));
                            phi_1051_ = bitcast<f32>(((_e208 & 2147483648u) | select(_e525, 0u, select(_e498, true, _e519))));
                        } else {
                            phi_1050_ = 0f;
                            phi_1051_ = 1f;
                        }
                        let _e577 = phi_1050_;
                        let _e579 = phi_1051_;
                        if _e138 {
                        } else {
                            break;
                        }
                        let _e585 = global_3.member[_e131].member_2;
                        local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 3>(bitcast<f32>(_e103), bitcast<f32>(_e107), bitcast<f32>(_e111));
                        let _e589 = (_e261 % 3u);
                        let _e590 = (_e589 < 3u);
                        if _e590 {
                        } else {
                            break;
                        }
                        let _e592 = local_9[_e589];
                        let _e593 = (_e260 % 3u);
                        let _e594 = (_e593 < 3u);
                        if _e594 {
                        } else {
                            break;
                        }
                        let _e596 = local_9[_e593];
                        let _e597 = (_e262 % 3u);
                        let _e598 = (_e597 < 3u);
                        if _e598 {
                        } else {
                            break;
                        }
                        let _e600 = local_9[_e597];
                        local_8 = array<f32, 3>(bitcast<f32>(_e115), bitcast<f32>(_e119), bitcast<f32>(_e123));
                        if _e590 {
                        } else {
                            break;
                        }
                        let _e604 = local_8[_e589];
                        if _e594 {
                        } else {
                            break;
                        }
                        let _e606 = local_8[_e593];
                        if _e598 {
                        } else {
                            break;
                        }
                        let _e608 = local_8[_e597];
                        phi_3968_ = false;
                        phi_1143_ = type_37(type_34(type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e577), 0u, 0u);
                        phi_1146_ = ((3u * _e88) + 1u);
                        phi_1148_ = (_e579 <= _e577);
                        phi_1150_ = 0u;
                        phi_1152_ = type_54(type_46(array<f32, 3>(_e592, _e596, _e600), array<f32, 3>(_e604, _e606, _e608)), select(0u, 2147483648u, (_e88 == 0u)));
                        loop {
                            let _e616 = phi_3968_;
                            let _e618 = phi_1143_;
                            let _e620 = phi_1146_;
                            let _e622 = phi_1148_;
                            let _e624 = phi_1150_;
                            let _e626 = phi_1152_;
                            local_10 = _e618;
                            local_11 = _e618;
                            if _e622 {
                                phi_1163_ = true;
                            } else {
                                phi_1163_ = (_e624 > 0u);
                            }
                            let _e629 = phi_1163_;
                            if _e629 {
                                let _e630 = (_e620 > 0u);
                                if _e630 {
                                    if _e622 {
                                        phi_1249_ = _e622;
                                        phi_1250_ = _e624;
                                        phi_1251_ = _e626;
                                    } else {
                                        let _e631 = (_e624 - 1u);
                                        let _e632 = (_e631 % 128u);
                                        let _e633 = (_e632 < 128u);
                                        if _e633 {
                                        } else {
                                            phi_4145_ = true;
                                            break;
                                        }
                                        let _e635 = local_6[_e632];
                                        if _e633 {
                                        } else {
                                            phi_4145_ = true;
                                            break;
                                        }
                                        let _e637 = local_5[_e632];
                                        if _e633 {
                                        } else {
                                            phi_4145_ = true;
                                            break;
                                        }
                                        let _e639 = local_4[_e632];
                                        if _e633 {
                                        } else {
                                            phi_4145_ = true;
                                            break;
                                        }
                                        let _e641 = local_3[_e632];
                                        if _e633 {
                                        } else {
                                            phi_4145_ = true;
                                            break;
                                        }
                                        let _e644 = local_2[_e632];
                                        if _e633 {
                                        } else {
                                            phi_4145_ = true;
                                            break;
                                        }
                                        let _e646 = local_1[_e632];
                                        if _e633 {
                                        } else {
                                            phi_4145_ = true;
                                            break;
                                        }
                                        let _e648 = local[_e632];
                                        if _e633 {
                                        } else {
                                            phi_4145_ = true;
                                            break;
                                        }
                                        let _e653 = local_7[_e632];
                                        phi_1249_ = (_e653 <= _e618.member.member_1);
                                        phi_1250_ = _e631;
                                        phi_1251_ = type_54(type_46(array<f32, 3>(_e637, _e639, _e641), array<f32, 3>(_e644, _e646, _e648)), _e635);
                                    }
                                    let _e658 = phi_1249_;
                                    let _e660 = phi_1250_;
                                    let _e662 = phi_1251_;
                                    if _e658 {
                                        let _e666 = ((_e662.member_1 & 2147483648u) != 0u);
                                        if _e666 {
                                            phi_1270_ = _e618;
                                            phi_1273_ = type_7(0u, ((_e662.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e674 = phi_1270_;
                                                let _e676 = phi_1273_;
                                                local_12 = _e674;
                                                if (_e676.member < _e676.member_1) {
                                                    phi_1274_ = type_7((_e676.member + 1u), _e676.member_1);
                                                    phi_1296_ = type_7(1u, _e676.member);
                                                } else {
                                                    phi_1274_ = _e676;
                                                    phi_1296_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e689 = phi_1274_;
                                                let _e691 = phi_1296_;
                                                let _e695 = (bitcast<i32>(_e691.member) != 0i);
                                                if _e695 {
                                                    let _e701 = type_37(_e674.member, _e674.member_1, (_e674.member_2 + 1u));
                                                    let _e702 = ((_e662.member_1 & 268435455u) + _e691.member_1);
                                                    let _e703 = (_e702 < arrayLength((&global_7.member)));
                                                    if _e703 {
                                                        if _e703 {
                                                        } else {
                                                            phi_3962_ = true;
                                                            break;
                                                        }
                                                        let _e706 = global_7.member[_e702].member_1;
                                                        phi_1324_ = _e706;
                                                    } else {
                                                        phi_1324_ = 4294967295u;
                                                    }
                                                    let _e708 = phi_1324_;
                                                    if _e703 {
                                                        if _e703 {
                                                        } else {
                                                            phi_3962_ = true;
                                                            break;
                                                        }
                                                        let _e710 = global_7.member[_e702];
                                                        phi_1340_ = _e710;
                                                    } else {
                                                        phi_1340_ = type_48(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                    }
                                                    let _e712 = phi_1340_;
                                                    let _e724 = ((10u * _e261) & 31u);
                                                    let _e727 = ((_e712.member[0] >> bitcast<u32>(_e724)) & 1023u);
                                                    let _e735 = bitcast<f32>((bitcast<u32>(((_e662.member.member_1[0] - _e662.member.member[0]) * 0.0009775171f)) ^ _e127));
                                                    let _e740 = (_e662.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e727)) - 8388608f) * _e735)) ^ _e127)));
                                                    let _e744 = select(select(_e662.member.member_1[0], _e740, (_e740 < _e662.member.member_1[0])), _e662.member.member_1[0], (_e727 == 1023u));
                                                    let _e746 = ((10u * _e260) & 31u);
                                                    let _e749 = ((_e712.member[0] >> bitcast<u32>(_e746)) & 1023u);
                                                    let _e757 = bitcast<f32>((bitcast<u32>(((_e662.member.member_1[1] - _e662.member.member[1]) * 0.0009775171f)) ^ _e127));
                                                    let _e762 = (_e662.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e749)) - 8388608f) * _e757)) ^ _e127)));
                                                    let _e766 = select(select(_e662.member.member_1[1], _e762, (_e762 < _e662.member.member_1[1])), _e662.member.member_1[1], (_e749 == 1023u));
                                                    let _e768 = ((10u * _e262) & 31u);
                                                    let _e771 = ((_e712.member[0] >> bitcast<u32>(_e768)) & 1023u);
                                                    let _e779 = bitcast<f32>((bitcast<u32>(((_e662.member.member_1[2] - _e662.member.member[2]) * 0.0009775171f)) ^ _e127));
                                                    let _e784 = (_e662.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e771)) - 8388608f) * _e779)) ^ _e127)));
                                                    let _e788 = select(select(_e662.member.member_1[2], _e784, (_e784 < _e662.member.member_1[2])), _e662.member.member_1[2], (_e771 == 1023u));
                                                    let _e792 = ((_e712.member[1] >> bitcast<u32>(_e724)) & 1023u);
                                                    let _e800 = (_e662.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e792)) - 8388608f) * _e735)) ^ _e127)));
                                                    let _e804 = select(select(_e662.member.member_1[0], _e800, (_e800 < _e662.member.member_1[0])), _e662.member.member_1[0], (_e792 == 1023u));
                                                    let _e807 = ((_e712.member[1] >> bitcast<u32>(_e746)) & 1023u);
                                                    let _e815 = (_e662.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e807)) - 8388608f) * _e757)) ^ _e127)));
                                                    let _e819 = select(select(_e662.member.member_1[1], _e815, (_e815 < _e662.member.member_1[1])), _e662.member.member_1[1], (_e807 == 1023u));
                                                    let _e822 = ((_e712.member[1] >> bitcast<u32>(_e768)) & 1023u);
                                                    let _e830 = (_e662.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e822)) - 8388608f) * _e779)) ^ _e127)));
                                                    let _e834 = select(select(_e662.member.member_1[2], _e830, (_e830 < _e662.member.member_1[2])), _e662.member.member_1[2], (_e822 == 1023u));
                                                    let _e838 = ((_e712.member[2] >> bitcast<u32>(_e724)) & 1023u);
                                                    let _e846 = (_e662.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e838)) - 8388608f) * _e735)) ^ _e127)));
                                                    let _e850 = select(select(_e662.member.member_1[0], _e846, (_e846 < _e662.member.member_1[0])), _e662.member.member_1[0], (_e838 == 1023u));
                                                    let _e853 = ((_e712.member[2] >> bitcast<u32>(_e746)) & 1023u);
                                                    let _e861 = (_e662.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e853)) - 8388608f) * _e757)) ^ _e127)));
                                                    let _e865 = select(select(_e662.member.member_1[1], _e861, (_e861 < _e662.member.member_1[1])), _e662.member.member_1[1], (_e853 == 1023u));
                                                    let _e868 = ((_e712.member[2] >> bitcast<u32>(_e768)) & 1023u);
                                                    let _e876 = (_e662.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e868)) - 8388608f) * _e779)) ^ _e127)));
                                                    let _e880 = select(select(_e662.member.member_1[2], _e876, (_e876 < _e662.member.member_1[2])), _e662.member.member_1[2], (_e868 == 1023u));
                                                    let _e885 = (_e788 - _e437);
                                                    let _e888 = (((_e744 - _e308) * _e473) - (_e885 * _e345));
                                                    let _e891 = (((_e766 - _e373) * _e473) - (_e885 * _e409));
                                                    let _e894 = (_e834 - _e437);
                                                    let _e897 = (((_e804 - _e308) * _e473) - (_e894 * _e345));
                                                    let _e900 = (((_e819 - _e373) * _e473) - (_e894 * _e409));
                                                    let _e903 = (_e880 - _e437);
                                                    let _e906 = (((_e850 - _e308) * _e473) - (_e903 * _e345));
                                                    let _e909 = (((_e865 - _e373) * _e473) - (_e903 * _e409));
                                                    let _e910 = (_e906 * _e900);
                                                    let _e911 = (_e909 * _e897);
                                                    let _e912 = (_e888 * _e909);
                                                    let _e913 = (_e891 * _e906);
                                                    let _e914 = (_e897 * _e891);
                                                    let _e915 = (_e900 * _e888);
                                                    let _e920 = (((_e910 >= _e911) && (_e912 >= _e913)) && (_e914 >= _e915));
                                                    let _e926 = (_e920 || (((_e910 <= _e911) && (_e912 <= _e913)) && (_e914 <= _e915)));
                                                    if _e926 {
                                                        let _e928 = select(-1f, 1f, _e920);
                                                        let _e930 = ((_e910 - _e911) * _e928);
                                                        let _e932 = select(0f, _e930, (_e930 > 0f));
                                                        let _e934 = ((_e912 - _e913) * _e928);
                                                        let _e936 = select(0f, _e934, (_e934 > 0f));
                                                        let _e938 = ((_e914 - _e915) * _e928);
                                                        let _e940 = select(0f, _e938, (_e938 > 0f));
                                                        let _e942 = ((_e932 + _e936) + _e940);
                                                        let _e944 = select(_e804, _e744, (_e744 < _e804));
                                                        let _e948 = select(_e804, _e744, (_e744 > _e804));
                                                        let _e952 = select(_e819, _e766, (_e766 < _e819));
                                                        let _e956 = select(_e819, _e766, (_e766 > _e819));
                                                        let _e960 = select(_e834, _e788, (_e788 < _e834));
                                                        let _e964 = select(_e834, _e788, (_e788 > _e834));
                                                        let _e969 = ((select(_e850, _e944, (_e944 < _e850)) - _e346) * _e349);
                                                        let _e970 = ((select(_e850, _e948, (_e948 > _e850)) - _e347) * _e349);
                                                        let _e973 = ((select(_e865, _e952, (_e952 < _e865)) - _e410) * _e413);
                                                        let _e974 = ((select(_e865, _e956, (_e956 > _e865)) - _e411) * _e413);
                                                        let _e977 = ((select(_e880, _e960, (_e960 < _e880)) - _e474) * _e477);
                                                        let _e978 = ((select(_e880, _e964, (_e964 > _e880)) - _e475) * _e477);
                                                        let _e980 = select(_e978, _e977, (_e977 < _e978));
                                                        let _e982 = select(_e978, _e977, (_e977 > _e978));
                                                        let _e984 = select(_e970, _e969, (_e969 < _e970));
                                                        let _e986 = select(_e974, _e973, (_e973 < _e974));
                                                        let _e988 = select(_e986, _e984, (_e984 > _e986));
                                                        let _e990 = select(_e980, _e988, (_e988 > _e980));
                                                        let _e992 = select(_e970, _e969, (_e969 > _e970));
                                                        let _e994 = select(_e974, _e973, (_e973 > _e974));
                                                        let _e996 = select(_e994, _e992, (_e992 < _e994));
                                                        let _e998 = select(_e982, _e996, (_e996 < _e982));
                                                        let _e999 = -(_e980);
                                                        let _e1005 = select(_e579, _e990, (_e990 > _e579));
                                                        let _e1009 = select(_e897, _e888, (_e888 < _e897));
                                                        let _e1014 = select(_e897, _e888, (_e888 > _e897));
                                                        let _e1021 = select(_e900, _e891, (_e891 < _e900));
                                                        let _e1026 = select(_e900, _e891, (_e891 > _e900));
                                                        let _e1035 = (((((_e926 && (_e942 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e906, _e1009, (_e1009 < _e906)) <= 0f) && (select(_e906, _e1014, (_e1014 > _e906)) >= 0f))) && ((select(_e909, _e1021, (_e1021 < _e909)) <= 0f) && (select(_e909, _e1026, (_e1026 > _e909)) >= 0f))) && (_e1005 <= (_e998 + (select(_e999, _e982, (_e982 > _e999)) * 0.0000019073523f)))) && (_e1005 <= _e674.member.member_1));
                                                        if _e1035 {
                                                            let _e1040 = (_e804 - _e744);
                                                            let _e1041 = (_e819 - _e766);
                                                            let _e1042 = (_e834 - _e788);
                                                            let _e1043 = vec3<f32>(_e1040, _e1041, _e1042);
                                                            let _e1044 = (_e850 - _e804);
                                                            let _e1045 = (_e865 - _e819);
                                                            let _e1046 = (_e880 - _e834);
                                                            let _e1047 = vec3<f32>(_e1044, _e1045, _e1046);
                                                            let _e1048 = (_e744 - _e850);
                                                            let _e1049 = (_e766 - _e865);
                                                            let _e1050 = (_e788 - _e880);
                                                            let _e1051 = vec3<f32>(_e1048, _e1049, _e1050);
                                                            let _e1052 = abs(_e1040);
                                                            let _e1053 = abs(_e1041);
                                                            if (_e1052 != _e1052) {
                                                                phi_3689_ = true;
                                                            } else {
                                                                phi_3689_ = (_e1053 >= _e1052);
                                                            }
                                                            let _e1057 = phi_3689_;
                                                            let _e1058 = select(_e1052, _e1053, _e1057);
                                                            let _e1059 = abs(_e1042);
                                                            if (_e1058 != _e1058) {
                                                                phi_3704_ = true;
                                                            } else {
                                                                phi_3704_ = (_e1059 >= _e1058);
                                                            }
                                                            let _e1063 = phi_3704_;
                                                            let _e1064 = select(_e1058, _e1059, _e1063);
                                                            let _e1065 = abs(_e1044);
                                                            let _e1066 = abs(_e1045);
                                                            if (_e1065 != _e1065) {
                                                                phi_3719_ = true;
                                                            } else {
                                                                phi_3719_ = (_e1066 >= _e1065);
                                                            }
                                                            let _e1070 = phi_3719_;
                                                            let _e1071 = select(_e1065, _e1066, _e1070);
                                                            let _e1072 = abs(_e1046);
                                                            if (_e1071 != _e1071) {
                                                                phi_3734_ = true;
                                                            } else {
                                                                phi_3734_ = (_e1072 >= _e1071);
                                                            }
                                                            let _e1076 = phi_3734_;
                                                            let _e1077 = select(_e1071, _e1072, _e1076);
                                                            let _e1078 = abs(_e1048);
                                                            let _e1079 = abs(_e1049);
                                                            if (_e1078 != _e1078) {
                                                                phi_3749_ = true;
                                                            } else {
                                                                phi_3749_ = (_e1079 >= _e1078);
                                                            }
                                                            let _e1083 = phi_3749_;
                                                            let _e1084 = select(_e1078, _e1079, _e1083);
                                                            let _e1085 = abs(_e1050);
                                                            if (_e1084 != _e1084) {
                                                                phi_3764_ = true;
                                                            } else {
                                                                phi_3764_ = (_e1085 >= _e1084);
                                                            }
                                                            let _e1089 = phi_3764_;
                                                            let _e1090 = select(_e1084, _e1085, _e1089);
                                                            let _e1092 = select(_e1077, _e1064, (_e1064 > _e1077));
                                                            let _e1094 = select(_e1090, _e1092, (_e1092 > _e1090));
                                                            if (_e1064 == _e1094) {
                                                                phi_2147_ = _e900;
                                                                phi_2148_ = _e897;
                                                                phi_2149_ = _e891;
                                                                phi_2150_ = _e888;
                                                                phi_2151_ = vec3<f32>(_e744, _e766, _e788);
                                                                phi_2152_ = _e1051;
                                                                phi_2153_ = _e1047;
                                                                phi_2154_ = _e1043;
                                                            } else {
                                                                let _e1096 = (_e1077 == _e1094);
                                                                let _e1101 = vec3(_e1096);
                                                                phi_2147_ = select(_e891, _e909, _e1096);
                                                                phi_2148_ = select(_e888, _e906, _e1096);
                                                                phi_2149_ = select(_e909, _e900, _e1096);
                                                                phi_2150_ = select(_e906, _e897, _e1096);
                                                                phi_2151_ = select(vec3<f32>(_e850, _e865, _e880), vec3<f32>(_e804, _e819, _e834), _e1101);
                                                                phi_2152_ = select(_e1047, _e1043, _e1101);
                                                                phi_2153_ = select(_e1043, _e1051, _e1101);
                                                                phi_2154_ = select(_e1051, _e1047, _e1101);
                                                            }
                                                            let _e1107 = phi_2147_;
                                                            let _e1109 = phi_2148_;
                                                            let _e1111 = phi_2149_;
                                                            let _e1113 = phi_2150_;
                                                            let _e1115 = phi_2151_;
                                                            let _e1117 = phi_2152_;
                                                            let _e1119 = phi_2153_;
                                                            let _e1121 = phi_2154_;
                                                            let _e1128 = ((_e1119.y * _e1117.z) - (_e1117.y * _e1119.z));
                                                            let _e1133 = ((_e1119.z * _e1117.x) - (_e1117.z * _e1119.x));
                                                            let _e1136 = ((_e1119.x * _e1117.y) - (_e1117.x * _e1119.y));
                                                            let _e1139 = ((_e932 >= _e936) && (_e932 >= _e940));
                                                            let _e1140 = (_e936 >= _e940);
                                                            let _e1154 = (((_e1128 * (select(select(_e850, _e804, _e1140), _e744, _e1139) - _e308)) + (_e1133 * (select(select(_e865, _e819, _e1140), _e766, _e1139) - _e373))) + (_e1136 * (select(select(_e880, _e834, _e1140), _e788, _e1139) - _e437)));
                                                            let _e1159 = (((_e1128 * _e345) + (_e1133 * _e409)) + (_e1136 * _e473));
                                                            let _e1160 = (_e1109 - _e1113);
                                                            let _e1161 = (_e1107 - _e1111);
                                                            let _e1164 = ((_e1160 * _e1160) + (_e1161 * _e1161));
                                                            let _e1171 = (-(((_e1113 * _e1160) + (_e1111 * _e1161))) / select(0.000000000000000000000000000000000000011754944f, _e1164, (_e1164 > 0.000000000000000000000000000000000000011754944f)));
                                                            let _e1173 = select(1f, _e1171, (_e1171 < 1f));
                                                            let _e1175 = select(0f, _e1173, (_e1173 > 0f));
                                                            let _e1184 = ((_e1115.x + (_e1121.x * _e1175)) - _e308);
                                                            let _e1187 = ((_e1115.y + (_e1121.y * _e1175)) - _e373);
                                                            let _e1190 = ((_e1115.z + (_e1121.z * _e1175)) - _e437);
                                                            let _e1193 = bitcast<f32>((bitcast<u32>(_e1184) & 2147483647u));
                                                            let _e1196 = bitcast<f32>((bitcast<u32>(_e1187) & 2147483647u));
                                                            let _e1198 = select(_e1196, _e1193, (_e1193 > _e1196));
                                                            let _e1201 = bitcast<f32>((bitcast<u32>(_e1190) & 2147483647u));
                                                            let _e1203 = select(_e1201, _e1198, (_e1198 > _e1201));
                                                            let _e1207 = abs(_e1128);
                                                            let _e1208 = abs(_e1133);
                                                            if (_e1207 != _e1207) {
                                                                phi_3779_ = true;
                                                            } else {
                                                                phi_3779_ = (_e1208 >= _e1207);
                                                            }
                                                            let _e1212 = phi_3779_;
                                                            let _e1213 = select(_e1207, _e1208, _e1212);
                                                            let _e1214 = abs(_e1136);
                                                            if (_e1213 != _e1213) {
                                                                phi_3794_ = true;
                                                            } else {
                                                                phi_3794_ = (_e1214 >= _e1213);
                                                            }
                                                            let _e1218 = phi_3794_;
                                                            let _e1234 = abs(_e1119.x);
                                                            let _e1235 = abs(_e1119.y);
                                                            if (_e1234 != _e1234) {
                                                                phi_3809_ = true;
                                                            } else {
                                                                phi_3809_ = (_e1235 >= _e1234);
                                                            }
                                                            let _e1239 = phi_3809_;
                                                            let _e1240 = select(_e1234, _e1235, _e1239);
                                                            let _e1241 = abs(_e1119.z);
                                                            if (_e1240 != _e1240) {
                                                                phi_3824_ = true;
                                                            } else {
                                                                phi_3824_ = (_e1241 >= _e1240);
                                                            }
                                                            let _e1245 = phi_3824_;
                                                            let _e1248 = abs(_e1117.x);
                                                            let _e1249 = abs(_e1117.y);
                                                            if (_e1248 != _e1248) {
                                                                phi_3839_ = true;
                                                            } else {
                                                                phi_3839_ = (_e1249 >= _e1248);
                                                            }
                                                            let _e1253 = phi_3839_;
                                                            let _e1254 = select(_e1248, _e1249, _e1253);
                                                            let _e1255 = abs(_e1117.z);
                                                            if (_e1254 != _e1254) {
                                                                phi_3854_ = true;
                                                            } else {
                                                                phi_3854_ = (_e1255 >= _e1254);
                                                            }
                                                            let _e1259 = phi_3854_;
                                                            let _e1264 = ((bitcast<f32>((bitcast<u32>(((((_e1128 * _e1184) + (_e1133 * _e1187)) + (_e1136 * _e1190)) - _e1154)) & 2147483647u)) <= ((0.0000009536743f * select(_e1094, _e1203, (_e1203 > _e1094))) * select(_e1213, _e1214, _e1218))) && !((bitcast<f32>((bitcast<u32>(_e1159) & 2147483647u)) <= ((0.0000038146973f * select(_e1240, _e1241, _e1245)) * select(_e1254, _e1255, _e1259)))));
                                                            let _e1265 = (_e1154 / _e1159);
                                                            if (_e1035 && !(_e1264)) {
                                                                let _e1268 = (_e1190 / _e473);
                                                                let _e1276 = (((_e1128 * (_e1184 - (_e345 * _e1268))) + (_e1133 * (_e1187 - (_e409 * _e1268)))) / _e1159);
                                                                phi_2362_ = select(select(_e1268, (_e1268 + _e1276), (bitcast<f32>((bitcast<u32>(_e1276) & 2147483647u)) <= _e1094)), _e1265, _e1264);
                                                            } else {
                                                                phi_2362_ = _e1265;
                                                            }
                                                            let _e1285 = phi_2362_;
                                                            let _e1287 = select(_e998, _e1285, (_e1285 < _e998));
                                                            let _e1289 = select(_e990, _e1287, (_e1287 > _e990));
                                                            let _e1290 = (1f / _e942);
                                                            phi_2382_ = type_36(_e1289, (_e936 * _e1290), (_e940 * _e1290), ((_e1035 && (_e1289 >= _e579)) && (_e1289 <= _e674.member.member_1)));
                                                            phi_2383_ = type_36();
                                                        } else {
                                                            phi_2382_ = type_36();
                                                            phi_2383_ = type_36(0f, 0f, 0f, _e1035);
                                                        }
                                                        let _e1299 = phi_2382_;
                                                        let _e1301 = phi_2383_;
                                                        phi_2386_ = _e1299;
                                                        phi_2387_ = _e1301;
                                                        phi_2388_ = select(true, false, _e1035);
                                                    } else {
                                                        phi_2386_ = type_36();
                                                        phi_2387_ = type_36(0f, 0f, 0f, _e926);
                                                        phi_2388_ = true;
                                                    }
                                                    let _e1304 = phi_2386_;
                                                    let _e1306 = phi_2387_;
                                                    let _e1308 = phi_2388_;
                                                    if _e1308 {
                                                        phi_2392_ = _e1306;
                                                    } else {
                                                        phi_2392_ = _e1304;
                                                    }
                                                    let _e1310 = phi_2392_;
                                                    if _e1310.member_3 {
                                                        phi_2401_ = type_19(_e1310.member, _e1310.member_1, _e1310.member_2, _e708);
                                                    } else {
                                                        phi_2401_ = type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    }
                                                    let _e1317 = phi_2401_;
                                                    if (_e1317.member_3 != 4294967295u) {
                                                        if (_e708 != _e585) {
                                                            if (_e1317.member < _e674.member.member.member) {
                                                                phi_2427_ = true;
                                                            } else {
                                                                if (_e1317.member == _e674.member.member.member) {
                                                                    phi_2426_ = (_e1317.member_3 < _e674.member.member.member_3);
                                                                } else {
                                                                    phi_2426_ = false;
                                                                }
                                                                let _e1332 = phi_2426_;
                                                                phi_2427_ = _e1332;
                                                            }
                                                            let _e1334 = phi_2427_;
                                                            if _e1334 {
                                                                phi_2434_ = type_37(type_34(_e1317, _e1317.member), _e701.member_1, _e701.member_2);
                                                            } else {
                                                                phi_2434_ = _e701;
                                                            }
                                                            let _e1341 = phi_2434_;
                                                            phi_2435_ = _e1341;
                                                        } else {
                                                            phi_2435_ = _e701;
                                                        }
                                                        let _e1343 = phi_2435_;
                                                        phi_2436_ = _e1343;
                                                    } else {
                                                        phi_2436_ = _e701;
                                                    }
                                                    let _e1345 = phi_2436_;
                                                    phi_1271_ = _e1345;
                                                } else {
                                                    phi_1271_ = type_37();
                                                }
                                                let _e1347 = phi_1271_;
                                                continue;
                                                continuing {
                                                    phi_1270_ = _e1347;
                                                    phi_1273_ = _e689;
                                                    phi_3962_ = _e616;
                                                    break if !(_e695);
                                                }
                                            }
                                            let _e1350 = phi_3962_;
                                            phi_4145_ = _e1350;
                                            if _e1350 {
                                                break;
                                            }
                                            phi_4204_ = _e1350;
                                            let _e2033 = local_12;
                                            phi_2437_ = _e2033;
                                        } else {
                                            phi_4204_ = _e616;
                                            phi_2437_ = _e618;
                                        }
                                        let _e1352 = phi_4204_;
                                        let _e1354 = phi_2437_;
                                        if _e666 {
                                            phi_3448_ = type_37();
                                            phi_3449_ = bool();
                                            phi_3450_ = u32();
                                            phi_3451_ = type_54();
                                        } else {
                                            let _e1355 = (_e662.member_1 < _e88);
                                            if _e1355 {
                                                if _e1355 {
                                                } else {
                                                    phi_4145_ = true;
                                                    break;
                                                }
                                                let _e1357 = global_6.member[_e662.member_1];
                                                phi_2458_ = _e1357;
                                            } else {
                                                phi_2458_ = type_41(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e1359 = phi_2458_;
                                            let _e1374 = ((10u * _e261) & 31u);
                                            let _e1377 = ((_e1359.member[0] >> bitcast<u32>(_e1374)) & 1023u);
                                            let _e1385 = bitcast<f32>((bitcast<u32>(((_e662.member.member_1[0] - _e662.member.member[0]) * 0.0009775171f)) ^ _e127));
                                            let _e1390 = (_e662.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1377)) - 8388608f) * _e1385)) ^ _e127)));
                                            let _e1394 = select(select(_e662.member.member_1[0], _e1390, (_e1390 < _e662.member.member_1[0])), _e662.member.member_1[0], (_e1377 == 1023u));
                                            let _e1396 = ((10u * _e260) & 31u);
                                            let _e1399 = ((_e1359.member[0] >> bitcast<u32>(_e1396)) & 1023u);
                                            let _e1407 = bitcast<f32>((bitcast<u32>(((_e662.member.member_1[1] - _e662.member.member[1]) * 0.0009775171f)) ^ _e127));
                                            let _e1412 = (_e662.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1399)) - 8388608f) * _e1407)) ^ _e127)));
                                            let _e1416 = select(select(_e662.member.member_1[1], _e1412, (_e1412 < _e662.member.member_1[1])), _e662.member.member_1[1], (_e1399 == 1023u));
                                            let _e1418 = ((10u * _e262) & 31u);
                                            let _e1421 = ((_e1359.member[0] >> bitcast<u32>(_e1418)) & 1023u);
                                            let _e1429 = bitcast<f32>((bitcast<u32>(((_e662.member.member_1[2] - _e662.member.member[2]) * 0.0009775171f)) ^ _e127));
                                            let _e1434 = (_e662.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1421)) - 8388608f) * _e1429)) ^ _e127)));
                                            let _e1438 = select(select(_e662.member.member_1[2], _e1434, (_e1434 < _e662.member.member_1[2])), _e662.member.member_1[2], (_e1421 == 1023u));
                                            let _e1441 = ((_e1359.member[1] >> bitcast<u32>(_e1374)) & 1023u);
                                            let _e1449 = (_e662.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1441)) - 8388608f) * _e1385)) ^ _e127)));
                                            let _e1453 = select(select(_e662.member.member_1[0], _e1449, (_e1449 < _e662.member.member_1[0])), _e662.member.member_1[0], (_e1441 == 1023u));
                                            let _e1456 = ((_e1359.member[1] >> bitcast<u32>(_e1396)) & 1023u);
                                            let _e1464 = (_e662.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1456)) - 8388608f) * _e1407)) ^ _e127)));
                                            let _e1468 = select(select(_e662.member.member_1[1], _e1464, (_e1464 < _e662.member.member_1[1])), _e662.member.member_1[1], (_e1456 == 1023u));
                                            let _e1471 = ((_e1359.member[1] >> bitcast<u32>(_e1418)) & 1023u);
                                            let _e1479 = (_e662.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1471)) - 8388608f) * _e1429)) ^ _e127)));
                                            let _e1483 = select(select(_e662.member.member_1[2], _e1479, (_e1479 < _e662.member.member_1[2])), _e662.member.member_1[2], (_e1471 == 1023u));
                                            let _e1489 = ((_e1359.member_1[0] >> bitcast<u32>(_e1374)) & 1023u);
                                            let _e1497 = (_e662.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1489)) - 8388608f) * _e1385)) ^ _e127)));
                                            let _e1501 = select(select(_e662.member.member_1[0], _e1497, (_e1497 < _e662.member.member_1[0])), _e662.member.member_1[0], (_e1489 == 1023u));
                                            let _e1504 = ((_e1359.member_1[0] >> bitcast<u32>(_e1396)) & 1023u);
                                            let _e1512 = (_e662.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1504)) - 8388608f) * _e1407)) ^ _e127)));
                                            let _e1516 = select(select(_e662.member.member_1[1], _e1512, (_e1512 < _e662.member.member_1[1])), _e662.member.member_1[1], (_e1504 == 1023u));
                                            let _e1519 = ((_e1359.member_1[0] >> bitcast<u32>(_e1418)) & 1023u);
                                            let _e1527 = (_e662.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1519)) - 8388608f) * _e1429)) ^ _e127)));
                                            let _e1531 = select(select(_e662.member.member_1[2], _e1527, (_e1527 < _e662.member.member_1[2])), _e662.member.member_1[2], (_e1519 == 1023u));
                                            let _e1534 = ((_e1359.member_1[1] >> bitcast<u32>(_e1374)) & 1023u);
                                            let _e1542 = (_e662.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1534)) - 8388608f) * _e1385)) ^ _e127)));
                                            let _e1546 = select(select(_e662.member.member_1[0], _e1542, (_e1542 < _e662.member.member_1[0])), _e662.member.member_1[0], (_e1534 == 1023u));
                                            let _e1549 = ((_e1359.member_1[1] >> bitcast<u32>(_e1396)) & 1023u);
                                            let _e1557 = (_e662.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1549)) - 8388608f) * _e1407)) ^ _e127)));
                                            let _e1561 = select(select(_e662.member.member_1[1], _e1557, (_e1557 < _e662.member.member_1[1])), _e662.member.member_1[1], (_e1549 == 1023u));
                                            let _e1564 = ((_e1359.member_1[1] >> bitcast<u32>(_e1418)) & 1023u);
                                            let _e1572 = (_e662.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1564)) - 8388608f) * _e1429)) ^ _e127)));
                                            let _e1576 = select(select(_e662.member.member_1[2], _e1572, (_e1572 < _e662.member.member_1[2])), _e662.member.member_1[2], (_e1564 == 1023u));
                                            let _e1581 = type_54(type_46(array<f32, 3>(_e1394, _e1416, _e1438), array<f32, 3>(_e1453, _e1468, _e1483)), _e1359.member_2);
                                            let _e1586 = type_54(type_46(array<f32, 3>(_e1501, _e1516, _e1531), array<f32, 3>(_e1546, _e1561, _e1576)), _e1359.member_3);
                                            let _e1599 = ((_e1394 - _e346) * _e349);
                                            let _e1600 = ((_e1501 - _e346) * _e349);
                                            let _e1601 = ((_e1453 - _e347) * _e349);
                                            let _e1602 = ((_e1546 - _e347) * _e349);
                                            let _e1607 = ((_e1416 - _e410) * _e413);
                                            let _e1608 = ((_e1516 - _e410) * _e413);
                                            let _e1609 = ((_e1468 - _e411) * _e413);
                                            let _e1610 = ((_e1561 - _e411) * _e413);
                                            let _e1615 = ((_e1438 - _e474) * _e477);
                                            let _e1616 = ((_e1531 - _e474) * _e477);
                                            let _e1617 = ((_e1483 - _e475) * _e477);
                                            let _e1618 = ((_e1576 - _e475) * _e477);
                                            let _e1620 = select(_e1617, _e1615, (_e1615 < _e1617));
                                            let _e1622 = select(_e1618, _e1616, (_e1616 < _e1618));
                                            let _e1624 = select(_e1617, _e1615, (_e1615 > _e1617));
                                            let _e1626 = select(_e1618, _e1616, (_e1616 > _e1618));
                                            let _e1628 = select(_e1601, _e1599, (_e1599 < _e1601));
                                            let _e1630 = select(_e1602, _e1600, (_e1600 < _e1602));
                                            let _e1632 = select(_e1609, _e1607, (_e1607 < _e1609));
                                            let _e1634 = select(_e1610, _e1608, (_e1608 < _e1610));
                                            let _e1636 = select(_e1632, _e1628, (_e1628 > _e1632));
                                            let _e1638 = select(_e1634, _e1630, (_e1630 > _e1634));
                                            let _e1640 = select(_e1620, _e1636, (_e1636 > _e1620));
                                            let _e1642 = select(_e1622, _e1638, (_e1638 > _e1622));
                                            let _e1644 = select(_e1601, _e1599, (_e1599 > _e1601));
                                            let _e1646 = select(_e1602, _e1600, (_e1600 > _e1602));
                                            let _e1648 = select(_e1609, _e1607, (_e1607 > _e1609));
                                            let _e1650 = select(_e1610, _e1608, (_e1608 > _e1610));
                                            let _e1652 = select(_e1648, _e1644, (_e1644 < _e1648));
                                            let _e1654 = select(_e1650, _e1646, (_e1646 < _e1650));
                                            let _e1659 = -(_e1620);
                                            let _e1660 = -(_e1622);
                                            let _e1667 = (select(_e1624, _e1652, (_e1652 < _e1624)) + (select(_e1659, _e1624, (_e1624 > _e1659)) * 0.0000019073523f));
                                            let _e1668 = (select(_e1626, _e1654, (_e1654 < _e1626)) + (select(_e1660, _e1626, (_e1626 > _e1660)) * 0.0000019073523f));
                                            let _e1670 = select(_e579, _e1640, (_e1640 > _e579));
                                            let _e1672 = select(_e579, _e1642, (_e1642 > _e579));
                                            let _e1677 = (_e1670 <= select(_e1354.member.member_1, _e1667, (_e1667 < _e1354.member.member_1)));
                                            let _e1678 = (_e1672 <= select(_e1354.member.member_1, _e1668, (_e1668 < _e1354.member.member_1)));
                                            let _e1679 = (_e1670 <= _e1672);
                                            if _e1677 {
                                                if _e1678 {
                                                    if _e1679 {
                                                        phi_3347_ = _e1586;
                                                    } else {
                                                        phi_3347_ = _e1581;
                                                    }
                                                    let _e1681 = phi_3347_;
                                                    let _e1688 = (_e660 % 128u);
                                                    let _e1689 = (_e1688 < 128u);
                                                    if _e1689 {
                                                    } else {
                                                        phi_4145_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1688] = _e1681.member_1;
                                                    if _e1689 {
                                                    } else {
                                                        phi_4145_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1688] = _e1681.member.member[0];
                                                    if _e1689 {
                                                    } else {
                                                        phi_4145_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1688] = _e1681.member.member[1];
                                                    if _e1689 {
                                                    } else {
                                                        phi_4145_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1688] = _e1681.member.member[2];
                                                    if _e1689 {
                                                    } else {
                                                        phi_4145_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1688] = _e1681.member.member_1[0];
                                                    if _e1689 {
                                                    } else {
                                                        phi_4145_ = true;
                                                        break;
                                                    }
                                                    local_1[_e1688] = _e1681.member.member_1[1];
                                                    if _e1689 {
                                                    } else {
                                                        phi_4145_ = true;
                                                        break;
                                                    }
                                                    local[_e1688] = _e1681.member.member_1[2];
                                                    if _e1689 {
                                                    } else {
                                                        phi_4145_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1688] = select(_e1670, _e1672, _e1679);
                                                    if _e1679 {
                                                        phi_3423_ = _e1581;
                                                    } else {
                                                        phi_3423_ = _e1586;
                                                    }
                                                    let _e1706 = phi_3423_;
                                                    phi_3424_ = (_e660 + 1u);
                                                    phi_3425_ = _e1706;
                                                } else {
                                                    phi_3424_ = u32();
                                                    phi_3425_ = type_54();
                                                }
                                                let _e1708 = phi_3424_;
                                                let _e1710 = phi_3425_;
                                                phi_3427_ = _e1708;
                                                phi_3428_ = _e1710;
                                                phi_3429_ = select(true, false, _e1678);
                                            } else {
                                                phi_3427_ = u32();
                                                phi_3428_ = type_54();
                                                phi_3429_ = true;
                                            }
                                            let _e1713 = phi_3427_;
                                            let _e1715 = phi_3428_;
                                            let _e1717 = phi_3429_;
                                            if _e1717 {
                                                if _e1677 {
                                                    phi_3436_ = _e1581;
                                                } else {
                                                    phi_3436_ = _e1586;
                                                }
                                                let _e1719 = phi_3436_;
                                                phi_3441_ = select(_e1678, true, _e1677);
                                                phi_3443_ = _e1719;
                                            } else {
                                                phi_3441_ = _e658;
                                                phi_3443_ = _e1715;
                                            }
                                            let _e1722 = phi_3441_;
                                            let _e1724 = phi_3443_;
                                            phi_3448_ = type_37(_e1354.member, (_e1354.member_1 + 1u), _e1354.member_2);
                                            phi_3449_ = _e1722;
                                            phi_3450_ = select(_e1713, _e660, _e1717);
                                            phi_3451_ = _e1724;
                                        }
                                        let _e1727 = phi_3448_;
                                        let _e1729 = phi_3449_;
                                        let _e1731 = phi_3450_;
                                        let _e1733 = phi_3451_;
                                        if _e666 {
                                            phi_3459_ = _e1354;
                                            phi_3462_ = _e662;
                                        } else {
                                            phi_3459_ = _e1727;
                                            phi_3462_ = _e1733;
                                        }
                                        let _e1735 = phi_3459_;
                                        let _e1737 = phi_3462_;
                                        phi_4148_ = _e1352;
                                        phi_3463_ = _e1735;
                                        phi_3464_ = (_e620 - 1u);
                                        phi_3465_ = select(_e1729, false, _e666);
                                        phi_3466_ = select(_e1731, _e660, _e666);
                                        phi_3467_ = _e1737;
                                    } else {
                                        phi_4148_ = _e616;
                                        phi_3463_ = _e618;
                                        phi_3464_ = _e620;
                                        phi_3465_ = _e658;
                                        phi_3466_ = _e660;
                                        phi_3467_ = _e662;
                                    }
                                    let _e1741 = phi_4148_;
                                    let _e1743 = phi_3463_;
                                    let _e1745 = phi_3464_;
                                    let _e1747 = phi_3465_;
                                    let _e1749 = phi_3466_;
                                    let _e1751 = phi_3467_;
                                    phi_4147_ = _e1741;
                                    phi_3468_ = _e1743;
                                    phi_3469_ = _e1745;
                                    phi_3470_ = _e1747;
                                    phi_3471_ = _e1749;
                                    phi_3472_ = _e1751;
                                } else {
                                    phi_4147_ = _e616;
                                    phi_3468_ = type_37();
                                    phi_3469_ = u32();
                                    phi_3470_ = bool();
                                    phi_3471_ = u32();
                                    phi_3472_ = type_54();
                                }
                                let _e1753 = phi_4147_;
                                let _e1755 = phi_3468_;
                                let _e1757 = phi_3469_;
                                let _e1759 = phi_3470_;
                                let _e1761 = phi_3471_;
                                let _e1763 = phi_3472_;
                                phi_4146_ = _e1753;
                                phi_1144_ = _e1755;
                                phi_1147_ = _e1757;
                                phi_1149_ = _e1759;
                                phi_1151_ = _e1761;
                                phi_1153_ = _e1763;
                                phi_3473_ = _e630;
                            } else {
                                phi_4146_ = _e616;
                                phi_1144_ = type_37();
                                phi_1147_ = u32();
                                phi_1149_ = bool();
                                phi_1151_ = u32();
                                phi_1153_ = type_54();
                                phi_3473_ = false;
                            }
                            let _e1765 = phi_4146_;
                            let _e1767 = phi_1144_;
                            let _e1769 = phi_1147_;
                            let _e1771 = phi_1149_;
                            let _e1773 = phi_1151_;
                            let _e1775 = phi_1153_;
                            let _e1777 = phi_3473_;
                            continue;
                            continuing {
                                phi_3968_ = _e1765;
                                phi_1143_ = _e1767;
                                phi_1146_ = _e1769;
                                phi_1148_ = _e1771;
                                phi_1150_ = _e1773;
                                phi_1152_ = _e1775;
                                phi_4145_ = _e1765;
                                break if !(_e1777);
                            }
                        }
                        let _e1780 = phi_4145_;
                        if _e1780 {
                            break;
                        }
                        let _e1782 = local_10;
                        if (_e1782.member.member.member_3 != 4294967295u) {
                            let _e1788 = bitcast<u32>(_e1782.member.member.member);
                            let _e1792 = (bitcast<i32>((_e1788 >> bitcast<u32>(23i))) & 255i);
                            let _e1793 = (_e1792 + _e263);
                            if (_e1792 == 255i) {
                                phi_3532_ = _e1782.member.member.member;
                            } else {
                                if (_e1792 > 0i) {
                                    if (_e1793 > 0i) {
                                        let _e1797 = (_e1793 < 255i);
                                        if _e1797 {
                                            phi_3511_ = bitcast<f32>((_e1788 + bitcast<u32>((_e263 << bitcast<u32>(23i)))));
                                        } else {
                                            phi_3511_ = f32();
                                        }
                                        let _e1804 = phi_3511_;
                                        phi_3513_ = _e1804;
                                        phi_3514_ = select(true, false, _e1797);
                                    } else {
                                        phi_3513_ = f32();
                                        phi_3514_ = true;
                                    }
                                    let _e1807 = phi_3513_;
                                    let _e1809 = phi_3514_;
                                    phi_3515_ = _e1807;
                                    phi_3516_ = _e1809;
                                } else {
                                    phi_3515_ = f32();
                                    phi_3516_ = true;
                                }
                                let _e1811 = phi_3515_;
                                let _e1813 = phi_3516_;
                                if _e1813 {
                                    let _e1814 = (_e1788 & 2147483648u);
                                    let _e1821 = ((_e1788 & 8388607u) | (select(0u, 1u, ((_e1788 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                    let _e1825 = (_e1821 == 0u);
                                    if _e1825 {
                                        phi_3932_ = bitcast<f32>(_e1814);
                                    } else {
                                        let _e1830 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1821)), 32u, _e1825) - 8u);
                                        let _e1833 = (_e1821 << bitcast<u32>((_e1830 & 31u)));
                                        let _e1835 = ((_e1793 + select(0i, 1i, (_e1792 == 0i))) - bitcast<i32>(_e1830));
                                        if (_e1835 >= 255i) {
                                            phi_3922_ = bitcast<f32>((_e1814 | 2139095040u));
                                            phi_3923_ = f32();
                                            phi_3924_ = true;
                                        } else {
                                            let _e1837 = (_e1835 > 0i);
                                            if _e1837 {
                                                phi_3916_ = bitcast<f32>(((_e1814 | (bitcast<u32>(_e1835) << bitcast<u32>(23i))) | (_e1833 & 8388607u)));
                                                phi_3917_ = f32();
                                            } else {
                                                if (_e1835 < -24i) {
                                                    phi_3882_ = 26u;
                                                } else {
                                                    phi_3882_ = bitcast<u32>((1i - _e1835));
                                                }
                                                let _e1842 = phi_3882_;
                                                let _e1843 = (_e1842 & 31u);
                                                let _e1845 = (_e1833 >> bitcast<u32>(_e1843));
                                                let _e1849 = (_e1833 & ((1u << bitcast<u32>(_e1843)) - 1u));
                                                let _e1853 = (1u << bitcast<u32>(((_e1842 - 1u) & 31u)));
                                                if (_e1849 > _e1853) {
                                                    phi_3903_ = true;
                                                } else {
                                                    if (_e1849 == _e1853) {
                                                        phi_3900_ = ((_e1845 & 1u) == 1u);
                                                    } else {
                                                        phi_3900_ = false;
                                                    }
                                                    let _e1859 = phi_3900_;
                                                    phi_3903_ = _e1859;
                                                }
                                                let _e1861 = phi_3903_;
                                                phi_3916_ = f32();
                                                phi_3917_ = bitcast<f32>((_e1814 | (_e1845 + select(0u, 1u, _e1861))));
                                            }
                                            let _e1874 = phi_3916_;
                                            let _e1876 = phi_3917_;
                                            phi_3922_ = _e1874;
                                            phi_3923_ = _e1876;
                                            phi_3924_ = _e1837;
                                        }
                                        let _e1880 = phi_3922_;
                                        let _e1882 = phi_3923_;
                                        let _e1884 = phi_3924_;
                                        phi_3932_ = select(_e1882, _e1880, _e1884);
                                    }
                                    let _e1888 = phi_3932_;
                                    phi_3531_ = _e1888;
                                } else {
                                    phi_3531_ = _e1811;
                                }
                                let _e1890 = phi_3531_;
                                phi_3532_ = _e1890;
                            }
                            let _e1892 = phi_3532_;
                            let _e1893 = bitcast<u32>(_e1892);
                            if ((_e1893 & 2147483647u) >= 2139095040u) {
                                phi_3544_ = bitcast<f32>(((_e1893 & 2147483648u) | 2139095039u));
                            } else {
                                phi_3544_ = _e1892;
                            }
                            let _e1900 = phi_3544_;
                            phi_3549_ = type_19(_e1900, _e1782.member.member.member_1, _e1782.member.member.member_2, _e1782.member.member.member_3);
                        } else {
                            phi_3549_ = type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1905 = phi_3549_;
                        if _e139 {
                        } else {
                            break;
                        }
                        global_1.member[_e131] = _e1905;
                        let _e1909 = local_11;
                        if _e140 {
                        } else {
                            break;
                        }
                        global_4.member[_e131] = _e1909.member_1;
                        if _e138 {
                        } else {
                            break;
                        }
                        let _e1914 = select(0u, 1u, (_e207 <= _e217));
                        if (_e1914 > 0u) {
                            let _e1916 = (1u < _e99);
                            if _e1916 {
                                if (0u < _e99) {
                                } else {
                                    break;
                                }
                                let _e1920 = atomicAdd((&global_5.member[0u]), _e1914);
                                if ((_e1920 + _e1914) < _e1920) {
                                    if _e1916 {
                                    } else {
                                        break;
                                    }
                                    let _e1925 = atomicAdd((&global_5.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1928 = select(0u, 1u, (_e1905.member_3 != 4294967295u));
                        if (_e1928 > 0u) {
                            let _e1930 = (3u < _e99);
                            if _e1930 {
                                if (2u < _e99) {
                                } else {
                                    break;
                                }
                                let _e1934 = atomicAdd((&global_5.member[2u]), _e1928);
                                if ((_e1934 + _e1928) < _e1934) {
                                    if _e1930 {
                                    } else {
                                        break;
                                    }
                                    let _e1939 = atomicAdd((&global_5.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1909.member_1 > 0u) {
                            let _e1941 = (5u < _e99);
                            if _e1941 {
                                if (4u < _e99) {
                                } else {
                                    break;
                                }
                                let _e1945 = atomicAdd((&global_5.member[4u]), _e1909.member_1);
                                if ((_e1945 + _e1909.member_1) < _e1945) {
                                    if _e1941 {
                                    } else {
                                        break;
                                    }
                                    let _e1950 = atomicAdd((&global_5.member[5u]), 1u);
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
