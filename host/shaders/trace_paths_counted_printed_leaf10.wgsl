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
    var phi_465_: i32;
    var phi_466_: i32;
    var phi_476_: bool;
    var phi_486_: u32;
    var phi_487_: u32;
    var phi_489_: bool;
    var phi_494_: u32;
    var phi_527_: i32;
    var phi_545_: f32;
    var phi_551_: f32;
    var phi_591_: f32;
    var phi_597_: f32;
    var phi_670_: f32;
    var phi_676_: f32;
    var phi_716_: f32;
    var phi_722_: f32;
    var phi_795_: f32;
    var phi_801_: f32;
    var phi_841_: f32;
    var phi_847_: f32;
    var phi_966_: i32;
    var phi_988_: u32;
    var phi_989_: u32;
    var phi_1026_: i32;
    var phi_1048_: u32;
    var phi_1049_: u32;
    var phi_1057_: f32;
    var phi_1058_: f32;
    var phi_3894_: bool;
    var phi_1150_: type_37;
    var phi_1153_: bool;
    var phi_1155_: type_54;
    var phi_1157_: u32;
    var phi_1159_: u32;
    var phi_1170_: bool;
    var phi_1256_: bool;
    var phi_1257_: type_54;
    var phi_1258_: u32;
    var phi_2435_: type_41;
    var phi_3324_: type_54;
    var phi_3400_: type_54;
    var phi_3401_: type_54;
    var phi_3402_: u32;
    var phi_3404_: type_54;
    var phi_3405_: u32;
    var phi_3406_: bool;
    var phi_3413_: type_54;
    var phi_3418_: bool;
    var phi_3419_: type_54;
    var phi_1277_: type_37;
    var phi_1280_: type_7;
    var phi_1281_: type_7;
    var phi_1303_: type_7;
    var phi_1331_: u32;
    var phi_1347_: type_48;
    var phi_2142_: f32;
    var phi_2143_: f32;
    var phi_2144_: f32;
    var phi_2145_: f32;
    var phi_2146_: vec3<f32>;
    var phi_2147_: vec3<f32>;
    var phi_2148_: vec3<f32>;
    var phi_2149_: vec3<f32>;
    var phi_2340_: f32;
    var phi_2360_: type_36;
    var phi_2361_: type_36;
    var phi_2364_: type_36;
    var phi_2365_: type_36;
    var phi_2366_: bool;
    var phi_2370_: type_36;
    var phi_2379_: type_19;
    var phi_2404_: bool;
    var phi_2405_: bool;
    var phi_2412_: type_37;
    var phi_2413_: type_37;
    var phi_2414_: type_37;
    var phi_1278_: type_37;
    var phi_3888_: bool;
    var local_10: type_37;
    var phi_4063_: bool;
    var phi_3421_: type_37;
    var phi_3422_: bool;
    var phi_3423_: type_54;
    var phi_3424_: u32;
    var phi_4062_: bool;
    var phi_3425_: type_37;
    var phi_3426_: bool;
    var phi_3427_: type_54;
    var phi_3428_: u32;
    var phi_3429_: u32;
    var phi_4061_: bool;
    var phi_3430_: type_37;
    var phi_3431_: bool;
    var phi_3432_: type_54;
    var phi_3433_: u32;
    var phi_3434_: u32;
    var phi_4060_: bool;
    var phi_1151_: type_37;
    var phi_1154_: bool;
    var phi_1156_: type_54;
    var phi_1158_: u32;
    var phi_1160_: u32;
    var phi_3435_: bool;
    var phi_4059_: bool;
    var local_11: type_37;
    var phi_3473_: f32;
    var phi_3475_: f32;
    var phi_3476_: bool;
    var phi_3477_: f32;
    var phi_3478_: bool;
    var phi_3808_: u32;
    var phi_3826_: bool;
    var phi_3829_: bool;
    var phi_3842_: f32;
    var phi_3843_: f32;
    var phi_3848_: f32;
    var phi_3849_: f32;
    var phi_3850_: bool;
    var phi_3858_: f32;
    var phi_3493_: f32;
    var phi_3494_: f32;
    var phi_3506_: f32;
    var phi_3511_: type_19;
    var local_12: type_37;
    var local_13: type_37;

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
                                phi_465_ = (bitcast<i32>((_e226 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_465_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e226)), 32u, (_e226 == 0u))));
                            }
                            let _e240 = phi_465_;
                            phi_466_ = _e240;
                        } else {
                            phi_466_ = 0i;
                        }
                        let _e242 = phi_466_;
                        let _e243 = (_e152 == _e196);
                        if _e243 {
                            phi_476_ = true;
                        } else {
                            phi_476_ = (_e160 == _e196);
                        }
                        let _e246 = phi_476_;
                        let _e247 = select(1u, 0u, _e243);
                        if _e246 {
                            let _e248 = (_e247 + 1u);
                            phi_486_ = _e248;
                            phi_487_ = _e248;
                            phi_489_ = select(true, false, (_e248 == 2u));
                        } else {
                            phi_486_ = u32();
                            phi_487_ = 0u;
                            phi_489_ = true;
                        }
                        let _e252 = phi_486_;
                        let _e254 = phi_487_;
                        let _e256 = phi_489_;
                        if _e256 {
                            phi_494_ = (_e254 + 1u);
                        } else {
                            phi_494_ = 0u;
                        }
                        let _e260 = phi_494_;
                        let _e261 = select(_e252, _e254, _e256);
                        let _e262 = select(_e247, select(2u, _e247, _e246), _e256);
                        let _e263 = -(_e242);
                        if (_e263 < -126i) {
                            phi_527_ = -126i;
                        } else {
                            phi_527_ = select(_e263, 127i, (_e263 > 127i));
                        }
                        let _e268 = phi_527_;
                        let _e273 = bitcast<f32>((bitcast<u32>((_e268 + 127i)) << bitcast<u32>(23i)));
                        let _e279 = bitcast<f32>((bitcast<u32>(((_e263 - _e268) + 127i)) << bitcast<u32>(23i)));
                        let _e284 = global_3.member[_e131].member.member;
                        let _e285 = (_e261 == 0u);
                        if _e285 {
                            phi_545_ = _e284[0];
                        } else {
                            phi_545_ = _e284[1];
                        }
                        let _e289 = phi_545_;
                        let _e290 = (_e261 == 2u);
                        if _e290 {
                            phi_551_ = _e284[2];
                        } else {
                            phi_551_ = _e289;
                        }
                        let _e293 = phi_551_;
                        let _e294 = bitcast<u32>(_e293);
                        let _e296 = ((_e294 & 2139095040u) != 0u);
                        let _e308 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e294 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e294 & 2147483648u))), _e293, _e296) * select(0.00000011920929f, 1f, _e296));
                        let _e309 = global_3.member[_e131].member.member_2;
                        if _e285 {
                            phi_591_ = _e309[0];
                        } else {
                            phi_591_ = _e309[1];
                        }
                        let _e313 = phi_591_;
                        if _e290 {
                            phi_597_ = _e309[2];
                        } else {
                            phi_597_ = _e313;
                        }
                        let _e316 = phi_597_;
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
                            phi_670_ = _e284[0];
                        } else {
                            phi_670_ = _e284[1];
                        }
                        let _e354 = phi_670_;
                        let _e355 = (_e260 == 2u);
                        if _e355 {
                            phi_676_ = _e284[2];
                        } else {
                            phi_676_ = _e354;
                        }
                        let _e358 = phi_676_;
                        let _e359 = bitcast<u32>(_e358);
                        let _e361 = ((_e359 & 2139095040u) != 0u);
                        let _e373 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e359 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e359 & 2147483648u))), _e358, _e361) * select(0.00000011920929f, 1f, _e361));
                        if _e350 {
                            phi_716_ = _e309[0];
                        } else {
                            phi_716_ = _e309[1];
                        }
                        let _e377 = phi_716_;
                        if _e355 {
                            phi_722_ = _e309[2];
                        } else {
                            phi_722_ = _e377;
                        }
                        let _e380 = phi_722_;
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
                            phi_795_ = _e284[0];
                        } else {
                            phi_795_ = _e284[1];
                        }
                        let _e418 = phi_795_;
                        let _e419 = (_e262 == 2u);
                        if _e419 {
                            phi_801_ = _e284[2];
                        } else {
                            phi_801_ = _e418;
                        }
                        let _e422 = phi_801_;
                        let _e423 = bitcast<u32>(_e422);
                        let _e425 = ((_e423 & 2139095040u) != 0u);
                        let _e437 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e423 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e423 & 2147483648u))), _e422, _e425) * select(0.00000011920929f, 1f, _e425));
                        if _e414 {
                            phi_841_ = _e309[0];
                        } else {
                            phi_841_ = _e309[1];
                        }
                        let _e441 = phi_841_;
                        if _e419 {
                            phi_847_ = _e309[2];
                        } else {
                            phi_847_ = _e441;
                        }
                        let _e444 = phi_847_;
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
                                phi_966_ = 255i;
                            } else {
                                phi_966_ = (((_e494 + select(0i, 1i, (_e494 == 0i))) - _e501) + _e242);
                            }
                            let _e509 = phi_966_;
                            let _e519 = (_e509 <= 0i);
                            if _e519 {
                                phi_989_ = u32();
                            } else {
                                if _e498 {
                                    phi_988_ = u32();
                                } else {
                                    phi_988_ = select(((bitcast<u32>(_e509) << bitcast<u32>(23i)) | ((_e491 << bitcast<u32>(((_e501 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e509 >= 255i));
                                }
                                let _e523 = phi_988_;
                                phi_989_ = _e523;
                            }
                            let _e525 = phi_989_;
                            let _e537 = ((_e219 & 8388607u) | (select(0u, 1u, ((_e219 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e540 = bitcast<i32>((_e219 >> bitcast<u32>(23i)));
                            let _e544 = (_e537 == 0u);
                            let _e547 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e537)), 32u, _e544)) - 8i);
                            if (_e540 == 255i) {
                                phi_1026_ = 255i;
                            } else {
                                phi_1026_ = (((_e540 + select(0i, 1i, (_e540 == 0i))) - _e547) + _e242);
                            }
                            let _e555 = phi_1026_;
                            let _e565 = (_e555 <= 0i);
                            if _e565 {
                                phi_1049_ = u32();
                            } else {
                                if _e544 {
                                    phi_1048_ = u32();
                                } else {
                                    phi_1048_ = select(((bitcast<u32>(_e555) << bitcast<u32>(23i)) | ((_e537 << bitcast<u32>(((_e547 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e555 >= 255i));
                                }
                                let _e569 = phi_1048_;
                                phi_1049_ = _e569;
                            }
                            let _e571 = phi_1049_;
                            phi_1057_ = bitcast<f32>(((_e218 & 2147483648u) | select(_e571, 0u, select(_e544, true, _e565))));
                            phi_1058_ = bitcast<f32>(((_e208 & 2147483648u) | select(_e525, 0u, select(_e498, true, _e519))));
                        } else {
                            phi_1057_ = 0f;
                            phi_1058_ = 1f;
                        }
                        let _e577 = phi_1057_;
                        let _e579 = phi_1058_;
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
                        let _e591 = (_e261 % 3u);
                        let _e592 = (_e591 < 3u);
                        if _e592 {
                        } else {
                            break;
                        }
                        let _e594 = local_9[_e591];
                        let _e595 = (_e260 % 3u);
                        let _e596 = (_e595 < 3u);
                        if _e596 {
                        } else {
                            break;
                        }
                        let _e598 = local_9[_e595];
                        let _e599 = (_e262 % 3u);
                        let _e600 = (_e599 < 3u);
                        if _e600 {
                        } else {
                            break;
                        }
                        let _e602 = local_9[_e599];
                        local_8 = array<f32, 3>(bitcast<f32>(_e115), bitcast<f32>(_e119), bitcast<f32>(_e123));
                        if _e592 {
                        } else {
                            break;
                        }
                        let _e606 = local_8[_e591];
                        if _e596 {
                        } else {
                            break;
                        }
                        let _e608 = local_8[_e595];
                        if _e600 {
                        } else {
                            break;
                        }
                        let _e610 = local_8[_e599];
                        phi_3894_ = false;
                        phi_1150_ = type_37(type_34(type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e577), 0u, 0u);
                        phi_1153_ = (_e579 <= _e577);
                        phi_1155_ = type_54(type_46(array<f32, 3>(_e594, _e598, _e602), array<f32, 3>(_e606, _e608, _e610)), select(0u, 2147483648u, (_e88 == 0u)));
                        phi_1157_ = 0u;
                        phi_1159_ = ((3u * _e88) + 1u);
                        loop {
                            let _e616 = phi_3894_;
                            let _e618 = phi_1150_;
                            let _e620 = phi_1153_;
                            let _e622 = phi_1155_;
                            let _e624 = phi_1157_;
                            let _e626 = phi_1159_;
                            local_11 = _e618;
                            local_12 = _e618;
                            if _e620 {
                                phi_1170_ = true;
                            } else {
                                phi_1170_ = (_e624 > 0u);
                            }
                            let _e629 = phi_1170_;
                            if _e629 {
                                let _e630 = (_e626 > 0u);
                                if _e630 {
                                    if _e620 {
                                        phi_1256_ = _e620;
                                        phi_1257_ = _e622;
                                        phi_1258_ = _e624;
                                    } else {
                                        let _e631 = (_e624 - 1u);
                                        let _e632 = (_e631 % 128u);
                                        let _e633 = (_e632 < 128u);
                                        if _e633 {
                                        } else {
                                            phi_4059_ = true;
                                            break;
                                        }
                                        let _e635 = local_6[_e632];
                                        if _e633 {
                                        } else {
                                            phi_4059_ = true;
                                            break;
                                        }
                                        let _e637 = local_5[_e632];
                                        if _e633 {
                                        } else {
                                            phi_4059_ = true;
                                            break;
                                        }
                                        let _e639 = local_4[_e632];
                                        if _e633 {
                                        } else {
                                            phi_4059_ = true;
                                            break;
                                        }
                                        let _e641 = local_3[_e632];
                                        if _e633 {
                                        } else {
                                            phi_4059_ = true;
                                            break;
                                        }
                                        let _e644 = local_2[_e632];
                                        if _e633 {
                                        } else {
                                            phi_4059_ = true;
                                            break;
                                        }
                                        let _e646 = local_1[_e632];
                                        if _e633 {
                                        } else {
                                            phi_4059_ = true;
                                            break;
                                        }
                                        let _e648 = local[_e632];
                                        if _e633 {
                                        } else {
                                            phi_4059_ = true;
                                            break;
                                        }
                                        let _e653 = local_7[_e632];
                                        phi_1256_ = (_e653 <= _e618.member.member_1);
                                        phi_1257_ = type_54(type_46(array<f32, 3>(_e637, _e639, _e641), array<f32, 3>(_e644, _e646, _e648)), _e635);
                                        phi_1258_ = _e631;
                                    }
                                    let _e658 = phi_1256_;
                                    let _e660 = phi_1257_;
                                    let _e662 = phi_1258_;
                                    if _e658 {
                                        if ((_e660.member_1 & 2147483648u) != 0u) {
                                            phi_1277_ = _e618;
                                            phi_1280_ = type_7(0u, ((_e660.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1045 = phi_1277_;
                                                let _e1047 = phi_1280_;
                                                local_10 = _e1045;
                                                local_13 = _e1045;
                                                if (_e1047.member < _e1047.member_1) {
                                                    phi_1281_ = type_7((_e1047.member + 1u), _e1047.member_1);
                                                    phi_1303_ = type_7(1u, _e1047.member);
                                                } else {
                                                    phi_1281_ = _e1047;
                                                    phi_1303_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e1060 = phi_1281_;
                                                let _e1062 = phi_1303_;
                                                let _e1066 = (bitcast<i32>(_e1062.member) != 0i);
                                                if _e1066 {
                                                    let _e1072 = type_37(_e1045.member, _e1045.member_1, (_e1045.member_2 + 1u));
                                                    let _e1073 = ((_e660.member_1 & 268435455u) + _e1062.member_1);
                                                    let _e1074 = (_e1073 < arrayLength((&global_7.member)));
                                                    if _e1074 {
                                                        if _e1074 {
                                                        } else {
                                                            phi_3888_ = true;
                                                            break;
                                                        }
                                                        let _e1077 = global_7.member[_e1073].member_1;
                                                        phi_1331_ = _e1077;
                                                    } else {
                                                        phi_1331_ = 4294967295u;
                                                    }
                                                    let _e1079 = phi_1331_;
                                                    if _e1074 {
                                                        if _e1074 {
                                                        } else {
                                                            phi_3888_ = true;
                                                            break;
                                                        }
                                                        let _e1081 = global_7.member[_e1073];
                                                        phi_1347_ = _e1081;
                                                    } else {
                                                        phi_1347_ = type_48(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                    }
                                                    let _e1083 = phi_1347_;
                                                    let _e1095 = ((10u * _e261) & 31u);
                                                    let _e1098 = ((_e1083.member[0] >> bitcast<u32>(_e1095)) & 1023u);
                                                    let _e1106 = bitcast<f32>((bitcast<u32>(((_e660.member.member_1[0] - _e660.member.member[0]) * 0.0009775171f)) ^ _e127));
                                                    let _e1111 = (_e660.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1098)) - 8388608f) * _e1106)) ^ _e127)));
                                                    let _e1115 = select(select(_e660.member.member_1[0], _e1111, (_e1111 < _e660.member.member_1[0])), _e660.member.member_1[0], (_e1098 == 1023u));
                                                    let _e1117 = ((10u * _e260) & 31u);
                                                    let _e1120 = ((_e1083.member[0] >> bitcast<u32>(_e1117)) & 1023u);
                                                    let _e1128 = bitcast<f32>((bitcast<u32>(((_e660.member.member_1[1] - _e660.member.member[1]) * 0.0009775171f)) ^ _e127));
                                                    let _e1133 = (_e660.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1120)) - 8388608f) * _e1128)) ^ _e127)));
                                                    let _e1137 = select(select(_e660.member.member_1[1], _e1133, (_e1133 < _e660.member.member_1[1])), _e660.member.member_1[1], (_e1120 == 1023u));
                                                    let _e1139 = ((10u * _e262) & 31u);
                                                    let _e1142 = ((_e1083.member[0] >> bitcast<u32>(_e1139)) & 1023u);
                                                    let _e1150 = bitcast<f32>((bitcast<u32>(((_e660.member.member_1[2] - _e660.member.member[2]) * 0.0009775171f)) ^ _e127));
                                                    let _e1155 = (_e660.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1142)) - 8388608f) * _e1150)) ^ _e127)));
                                                    let _e1159 = select(select(_e660.member.member_1[2], _e1155, (_e1155 < _e660.member.member_1[2])), _e660.member.member_1[2], (_e1142 == 1023u));
                                                    let _e1163 = ((_e1083.member[1] >> bitcast<u32>(_e1095)) & 1023u);
                                                    let _e1171 = (_e660.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1163)) - 8388608f) * _e1106)) ^ _e127)));
                                                    let _e1175 = select(select(_e660.member.member_1[0], _e1171, (_e1171 < _e660.member.member_1[0])), _e660.member.member_1[0], (_e1163 == 1023u));
                                                    let _e1178 = ((_e1083.member[1] >> bitcast<u32>(_e1117)) & 1023u);
                                                    let _e1186 = (_e660.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1178)) - 8388608f) * _e1128)) ^ _e127)));
                                                    let _e1190 = select(select(_e660.member.member_1[1], _e1186, (_e1186 < _e660.member.member_1[1])), _e660.member.member_1[1], (_e1178 == 1023u));
                                                    let _e1193 = ((_e1083.member[1] >> bitcast<u32>(_e1139)) & 1023u);
                                                    let _e1201 = (_e660.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1193)) - 8388608f) * _e1150)) ^ _e127)));
                                                    let _e1205 = select(select(_e660.member.member_1[2], _e1201, (_e1201 < _e660.member.member_1[2])), _e660.member.member_1[2], (_e1193 == 1023u));
                                                    let _e1209 = ((_e1083.member[2] >> bitcast<u32>(_e1095)) & 1023u);
                                                    let _e1217 = (_e660.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1209)) - 8388608f) * _e1106)) ^ _e127)));
                                                    let _e1221 = select(select(_e660.member.member_1[0], _e1217, (_e1217 < _e660.member.member_1[0])), _e660.member.member_1[0], (_e1209 == 1023u));
                                                    let _e1224 = ((_e1083.member[2] >> bitcast<u32>(_e1117)) & 1023u);
                                                    let _e1232 = (_e660.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1224)) - 8388608f) * _e1128)) ^ _e127)));
                                                    let _e1236 = select(select(_e660.member.member_1[1], _e1232, (_e1232 < _e660.member.member_1[1])), _e660.member.member_1[1], (_e1224 == 1023u));
                                                    let _e1239 = ((_e1083.member[2] >> bitcast<u32>(_e1139)) & 1023u);
                                                    let _e1247 = (_e660.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1239)) - 8388608f) * _e1150)) ^ _e127)));
                                                    let _e1251 = select(select(_e660.member.member_1[2], _e1247, (_e1247 < _e660.member.member_1[2])), _e660.member.member_1[2], (_e1239 == 1023u));
                                                    let _e1256 = (_e1159 - _e437);
                                                    let _e1259 = (((_e1115 - _e308) * _e473) - (_e1256 * _e345));
                                                    let _e1262 = (((_e1137 - _e373) * _e473) - (_e1256 * _e409));
                                                    let _e1265 = (_e1205 - _e437);
                                                    let _e1268 = (((_e1175 - _e308) * _e473) - (_e1265 * _e345));
                                                    let _e1271 = (((_e1190 - _e373) * _e473) - (_e1265 * _e409));
                                                    let _e1274 = (_e1251 - _e437);
                                                    let _e1277 = (((_e1221 - _e308) * _e473) - (_e1274 * _e345));
                                                    let _e1280 = (((_e1236 - _e373) * _e473) - (_e1274 * _e409));
                                                    let _e1281 = (_e1277 * _e1271);
                                                    let _e1282 = (_e1280 * _e1268);
                                                    let _e1283 = (_e1259 * _e1280);
                                                    let _e1284 = (_e1262 * _e1277);
                                                    let _e1285 = (_e1268 * _e1262);
                                                    let _e1286 = (_e1271 * _e1259);
                                                    let _e1291 = (((_e1281 >= _e1282) && (_e1283 >= _e1284)) && (_e1285 >= _e1286));
                                                    let _e1297 = (_e1291 || (((_e1281 <= _e1282) && (_e1283 <= _e1284)) && (_e1285 <= _e1286)));
                                                    if _e1297 {
                                                        let _e1299 = select(-1f, 1f, _e1291);
                                                        let _e1301 = ((_e1281 - _e1282) * _e1299);
                                                        let _e1303 = select(0f, _e1301, (_e1301 > 0f));
                                                        let _e1305 = ((_e1283 - _e1284) * _e1299);
                                                        let _e1307 = select(0f, _e1305, (_e1305 > 0f));
                                                        let _e1309 = ((_e1285 - _e1286) * _e1299);
                                                        let _e1311 = select(0f, _e1309, (_e1309 > 0f));
                                                        let _e1313 = ((_e1303 + _e1307) + _e1311);
                                                        let _e1315 = select(_e1175, _e1115, (_e1115 < _e1175));
                                                        let _e1319 = select(_e1175, _e1115, (_e1115 > _e1175));
                                                        let _e1323 = select(_e1190, _e1137, (_e1137 < _e1190));
                                                        let _e1327 = select(_e1190, _e1137, (_e1137 > _e1190));
                                                        let _e1331 = select(_e1205, _e1159, (_e1159 < _e1205));
                                                        let _e1335 = select(_e1205, _e1159, (_e1159 > _e1205));
                                                        let _e1340 = ((select(_e1221, _e1315, (_e1315 < _e1221)) - _e346) * _e349);
                                                        let _e1341 = ((select(_e1221, _e1319, (_e1319 > _e1221)) - _e347) * _e349);
                                                        let _e1344 = ((select(_e1236, _e1323, (_e1323 < _e1236)) - _e410) * _e413);
                                                        let _e1345 = ((select(_e1236, _e1327, (_e1327 > _e1236)) - _e411) * _e413);
                                                        let _e1348 = ((select(_e1251, _e1331, (_e1331 < _e1251)) - _e474) * _e477);
                                                        let _e1349 = ((select(_e1251, _e1335, (_e1335 > _e1251)) - _e475) * _e477);
                                                        let _e1351 = select(_e1349, _e1348, (_e1348 < _e1349));
                                                        let _e1353 = select(_e1349, _e1348, (_e1348 > _e1349));
                                                        let _e1355 = select(_e1341, _e1340, (_e1340 < _e1341));
                                                        let _e1357 = select(_e1345, _e1344, (_e1344 < _e1345));
                                                        let _e1359 = select(_e1357, _e1355, (_e1355 > _e1357));
                                                        let _e1361 = select(_e1351, _e1359, (_e1359 > _e1351));
                                                        let _e1363 = select(_e1341, _e1340, (_e1340 > _e1341));
                                                        let _e1365 = select(_e1345, _e1344, (_e1344 > _e1345));
                                                        let _e1367 = select(_e1365, _e1363, (_e1363 < _e1365));
                                                        let _e1369 = select(_e1353, _e1367, (_e1367 < _e1353));
                                                        let _e1370 = -(_e1351);
                                                        let _e1376 = select(_e579, _e1361, (_e1361 > _e579));
                                                        let _e1380 = select(_e1268, _e1259, (_e1259 < _e1268));
                                                        let _e1385 = select(_e1268, _e1259, (_e1259 > _e1268));
                                                        let _e1392 = select(_e1271, _e1262, (_e1262 < _e1271));
                                                        let _e1397 = select(_e1271, _e1262, (_e1262 > _e1271));
                                                        let _e1406 = (((((_e1297 && (_e1313 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1277, _e1380, (_e1380 < _e1277)) <= 0f) && (select(_e1277, _e1385, (_e1385 > _e1277)) >= 0f))) && ((select(_e1280, _e1392, (_e1392 < _e1280)) <= 0f) && (select(_e1280, _e1397, (_e1397 > _e1280)) >= 0f))) && (_e1376 <= (_e1369 + (select(_e1370, _e1353, (_e1353 > _e1370)) * 0.0000019073523f)))) && (_e1376 <= _e1045.member.member_1));
                                                        if _e1406 {
                                                            let _e1411 = (_e1175 - _e1115);
                                                            let _e1412 = (_e1190 - _e1137);
                                                            let _e1413 = (_e1205 - _e1159);
                                                            let _e1414 = vec3<f32>(_e1411, _e1412, _e1413);
                                                            let _e1415 = (_e1221 - _e1175);
                                                            let _e1416 = (_e1236 - _e1190);
                                                            let _e1417 = (_e1251 - _e1205);
                                                            let _e1418 = vec3<f32>(_e1415, _e1416, _e1417);
                                                            let _e1419 = (_e1115 - _e1221);
                                                            let _e1420 = (_e1137 - _e1236);
                                                            let _e1421 = (_e1159 - _e1251);
                                                            let _e1422 = vec3<f32>(_e1419, _e1420, _e1421);
                                                            let _e1425 = bitcast<f32>((bitcast<u32>(_e1411) & 2147483647u));
                                                            let _e1428 = bitcast<f32>((bitcast<u32>(_e1412) & 2147483647u));
                                                            let _e1430 = select(_e1428, _e1425, (_e1425 > _e1428));
                                                            let _e1433 = bitcast<f32>((bitcast<u32>(_e1413) & 2147483647u));
                                                            let _e1435 = select(_e1433, _e1430, (_e1430 > _e1433));
                                                            let _e1438 = bitcast<f32>((bitcast<u32>(_e1415) & 2147483647u));
                                                            let _e1441 = bitcast<f32>((bitcast<u32>(_e1416) & 2147483647u));
                                                            let _e1443 = select(_e1441, _e1438, (_e1438 > _e1441));
                                                            let _e1446 = bitcast<f32>((bitcast<u32>(_e1417) & 2147483647u));
                                                            let _e1448 = select(_e1446, _e1443, (_e1443 > _e1446));
                                                            let _e1451 = bitcast<f32>((bitcast<u32>(_e1419) & 2147483647u));
                                                            let _e1454 = bitcast<f32>((bitcast<u32>(_e1420) & 2147483647u));
                                                            let _e1456 = select(_e1454, _e1451, (_e1451 > _e1454));
                                                            let _e1459 = bitcast<f32>((bitcast<u32>(_e1421) & 2147483647u));
                                                            let _e1461 = select(_e1459, _e1456, (_e1456 > _e1459));
                                                            let _e1463 = select(_e1448, _e1435, (_e1435 > _e1448));
                                                            let _e1465 = select(_e1461, _e1463, (_e1463 > _e1461));
                                                            if (_e1435 == _e1465) {
                                                                phi_2142_ = _e1271;
                                                                phi_2143_ = _e1268;
                                                                phi_2144_ = _e1262;
                                                                phi_2145_ = _e1259;
                                                                phi_2146_ = vec3<f32>(_e1115, _e1137, _e1159);
                                                                phi_2147_ = _e1422;
                                                                phi_2148_ = _e1418;
                                                                phi_2149_ = _e1414;
                                                            } else {
                                                                let _e1467 = (_e1448 == _e1465);
                                                                let _e1472 = vec3(_e1467);
                                                                phi_2142_ = select(_e1262, _e1280, _e1467);
                                                                phi_2143_ = select(_e1259, _e1277, _e1467);
                                                                phi_2144_ = select(_e1280, _e1271, _e1467);
                                                                phi_2145_ = select(_e1277, _e1268, _e1467);
                                                                phi_2146_ = select(vec3<f32>(_e1221, _e1236, _e1251), vec3<f32>(_e1175, _e1190, _e1205), _e1472);
                                                                phi_2147_ = select(_e1418, _e1414, _e1472);
                                                                phi_2148_ = select(_e1414, _e1422, _e1472);
                                                                phi_2149_ = select(_e1422, _e1418, _e1472);
                                                            }
                                                            let _e1478 = phi_2142_;
                                                            let _e1480 = phi_2143_;
                                                            let _e1482 = phi_2144_;
                                                            let _e1484 = phi_2145_;
                                                            let _e1486 = phi_2146_;
                                                            let _e1488 = phi_2147_;
                                                            let _e1490 = phi_2148_;
                                                            let _e1492 = phi_2149_;
                                                            let _e1499 = ((_e1490.y * _e1488.z) - (_e1488.y * _e1490.z));
                                                            let _e1504 = ((_e1490.z * _e1488.x) - (_e1488.z * _e1490.x));
                                                            let _e1507 = ((_e1490.x * _e1488.y) - (_e1488.x * _e1490.y));
                                                            let _e1510 = ((_e1303 >= _e1307) && (_e1303 >= _e1311));
                                                            let _e1511 = (_e1307 >= _e1311);
                                                            let _e1525 = (((_e1499 * (select(select(_e1221, _e1175, _e1511), _e1115, _e1510) - _e308)) + (_e1504 * (select(select(_e1236, _e1190, _e1511), _e1137, _e1510) - _e373))) + (_e1507 * (select(select(_e1251, _e1205, _e1511), _e1159, _e1510) - _e437)));
                                                            let _e1530 = (((_e1499 * _e345) + (_e1504 * _e409)) + (_e1507 * _e473));
                                                            let _e1531 = (_e1480 - _e1484);
                                                            let _e1532 = (_e1478 - _e1482);
                                                            let _e1535 = ((_e1531 * _e1531) + (_e1532 * _e1532));
                                                            let _e1542 = (-(((_e1484 * _e1531) + (_e1482 * _e1532))) / select(0.000000000000000000000000000000000000011754944f, _e1535, (_e1535 > 0.000000000000000000000000000000000000011754944f)));
                                                            let _e1544 = select(1f, _e1542, (_e1542 < 1f));
                                                            let _e1546 = select(0f, _e1544, (_e1544 > 0f));
                                                            let _e1555 = ((_e1486.x + (_e1492.x * _e1546)) - _e308);
                                                            let _e1558 = ((_e1486.y + (_e1492.y * _e1546)) - _e373);
                                                            let _e1561 = ((_e1486.z + (_e1492.z * _e1546)) - _e437);
                                                            let _e1564 = bitcast<f32>((bitcast<u32>(_e1555) & 2147483647u));
                                                            let _e1567 = bitcast<f32>((bitcast<u32>(_e1558) & 2147483647u));
                                                            let _e1569 = select(_e1567, _e1564, (_e1564 > _e1567));
                                                            let _e1572 = bitcast<f32>((bitcast<u32>(_e1561) & 2147483647u));
                                                            let _e1574 = select(_e1572, _e1569, (_e1569 > _e1572));
                                                            let _e1580 = bitcast<f32>((bitcast<u32>(_e1499) & 2147483647u));
                                                            let _e1583 = bitcast<f32>((bitcast<u32>(_e1504) & 2147483647u));
                                                            let _e1585 = select(_e1583, _e1580, (_e1580 > _e1583));
                                                            let _e1588 = bitcast<f32>((bitcast<u32>(_e1507) & 2147483647u));
                                                            let _e1607 = bitcast<f32>((bitcast<u32>(_e1490.x) & 2147483647u));
                                                            let _e1610 = bitcast<f32>((bitcast<u32>(_e1490.y) & 2147483647u));
                                                            let _e1612 = select(_e1610, _e1607, (_e1607 > _e1610));
                                                            let _e1615 = bitcast<f32>((bitcast<u32>(_e1490.z) & 2147483647u));
                                                            let _e1621 = bitcast<f32>((bitcast<u32>(_e1488.x) & 2147483647u));
                                                            let _e1624 = bitcast<f32>((bitcast<u32>(_e1488.y) & 2147483647u));
                                                            let _e1626 = select(_e1624, _e1621, (_e1621 > _e1624));
                                                            let _e1629 = bitcast<f32>((bitcast<u32>(_e1488.z) & 2147483647u));
                                                            let _e1635 = ((bitcast<f32>((bitcast<u32>(((((_e1499 * _e1555) + (_e1504 * _e1558)) + (_e1507 * _e1561)) - _e1525)) & 2147483647u)) <= ((0.0000009536743f * select(_e1465, _e1574, (_e1574 > _e1465))) * select(_e1588, _e1585, (_e1585 > _e1588)))) && !((bitcast<f32>((bitcast<u32>(_e1530) & 2147483647u)) <= ((0.0000038146973f * select(_e1615, _e1612, (_e1612 > _e1615))) * select(_e1629, _e1626, (_e1626 > _e1629))))));
                                                            let _e1636 = (_e1525 / _e1530);
                                                            if (_e1406 && !(_e1635)) {
                                                                let _e1639 = (_e1561 / _e473);
                                                                let _e1647 = (((_e1499 * (_e1555 - (_e345 * _e1639))) + (_e1504 * (_e1558 - (_e409 * _e1639)))) / _e1530);
                                                                phi_2340_ = select(select(_e1639, (_e1639 + _e1647), (bitcast<f32>((bitcast<u32>(_e1647) & 2147483647u)) <= _e1465)), _e1636, _e1635);
                                                            } else {
                                                                phi_2340_ = _e1636;
                                                            }
                                                            let _e1656 = phi_2340_;
                                                            let _e1658 = select(_e1369, _e1656, (_e1656 < _e1369));
                                                            let _e1660 = select(_e1361, _e1658, (_e1658 > _e1361));
                                                            let _e1661 = (1f / _e1313);
                                                            phi_2360_ = type_36(_e1660, (_e1307 * _e1661), (_e1311 * _e1661), ((_e1406 && (_e1660 >= _e579)) && (_e1660 <= _e1045.member.member_1)));
                                                            phi_2361_ = type_36();
                                                        } else {
                                                            phi_2360_ = type_36();
                                                            phi_2361_ = type_36(0f, 0f, 0f, _e1406);
                                                        }
                                                        let _e1670 = phi_2360_;
                                                        let _e1672 = phi_2361_;
                                                        phi_2364_ = _e1670;
                                                        phi_2365_ = _e1672;
                                                        phi_2366_ = select(true, false, _e1406);
                                                    } else {
                                                        phi_2364_ = type_36();
                                                        phi_2365_ = type_36(0f, 0f, 0f, _e1297);
                                                        phi_2366_ = true;
                                                    }
                                                    let _e1675 = phi_2364_;
                                                    let _e1677 = phi_2365_;
                                                    let _e1679 = phi_2366_;
                                                    if _e1679 {
                                                        phi_2370_ = _e1677;
                                                    } else {
                                                        phi_2370_ = _e1675;
                                                    }
                                                    let _e1681 = phi_2370_;
                                                    if _e1681.member_3 {
                                                        phi_2379_ = type_19(_e1681.member, _e1681.member_1, _e1681.member_2, _e1079);
                                                    } else {
                                                        phi_2379_ = type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    }
                                                    let _e1688 = phi_2379_;
                                                    if (_e1688.member_3 != 4294967295u) {
                                                        if (_e1079 != _e585) {
                                                            if (_e1688.member < _e1045.member.member.member) {
                                                                phi_2405_ = true;
                                                            } else {
                                                                if (_e1688.member == _e1045.member.member.member) {
                                                                    phi_2404_ = (_e1688.member_3 < _e1045.member.member.member_3);
                                                                } else {
                                                                    phi_2404_ = false;
                                                                }
                                                                let _e1703 = phi_2404_;
                                                                phi_2405_ = _e1703;
                                                            }
                                                            let _e1705 = phi_2405_;
                                                            if _e1705 {
                                                                phi_2412_ = type_37(type_34(_e1688, _e1688.member), _e1072.member_1, _e1072.member_2);
                                                            } else {
                                                                phi_2412_ = _e1072;
                                                            }
                                                            let _e1712 = phi_2412_;
                                                            phi_2413_ = _e1712;
                                                        } else {
                                                            phi_2413_ = _e1072;
                                                        }
                                                        let _e1714 = phi_2413_;
                                                        phi_2414_ = _e1714;
                                                    } else {
                                                        phi_2414_ = _e1072;
                                                    }
                                                    let _e1716 = phi_2414_;
                                                    phi_1278_ = _e1716;
                                                } else {
                                                    phi_1278_ = type_37();
                                                }
                                                let _e1718 = phi_1278_;
                                                continue;
                                                continuing {
                                                    phi_1277_ = _e1718;
                                                    phi_1280_ = _e1060;
                                                    phi_3888_ = _e616;
                                                    break if !(_e1066);
                                                }
                                            }
                                            let _e1721 = phi_3888_;
                                            phi_4059_ = _e1721;
                                            if _e1721 {
                                                break;
                                            }
                                            let _e1723 = local_10;
                                            phi_4063_ = _e1721;
                                            let _e2031 = local_13;
                                            phi_3421_ = _e2031;
                                            phi_3422_ = false;
                                            phi_3423_ = _e660;
                                            phi_3424_ = select(_e662, 0u, (_e579 > _e1723.member.member_1));
                                        } else {
                                            let _e672 = (_e660.member_1 < _e88);
                                            if _e672 {
                                                if _e672 {
                                                } else {
                                                    phi_4059_ = true;
                                                    break;
                                                }
                                                let _e674 = global_6.member[_e660.member_1];
                                                phi_2435_ = _e674;
                                            } else {
                                                phi_2435_ = type_41(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e676 = phi_2435_;
                                            let _e691 = ((10u * _e261) & 31u);
                                            let _e694 = ((_e676.member[0] >> bitcast<u32>(_e691)) & 1023u);
                                            let _e702 = bitcast<f32>((bitcast<u32>(((_e660.member.member_1[0] - _e660.member.member[0]) * 0.0009775171f)) ^ _e127));
                                            let _e707 = (_e660.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e694)) - 8388608f) * _e702)) ^ _e127)));
                                            let _e711 = select(select(_e660.member.member_1[0], _e707, (_e707 < _e660.member.member_1[0])), _e660.member.member_1[0], (_e694 == 1023u));
                                            let _e713 = ((10u * _e260) & 31u);
                                            let _e716 = ((_e676.member[0] >> bitcast<u32>(_e713)) & 1023u);
                                            let _e724 = bitcast<f32>((bitcast<u32>(((_e660.member.member_1[1] - _e660.member.member[1]) * 0.0009775171f)) ^ _e127));
                                            let _e729 = (_e660.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e716)) - 8388608f) * _e724)) ^ _e127)));
                                            let _e733 = select(select(_e660.member.member_1[1], _e729, (_e729 < _e660.member.member_1[1])), _e660.member.member_1[1], (_e716 == 1023u));
                                            let _e735 = ((10u * _e262) & 31u);
                                            let _e738 = ((_e676.member[0] >> bitcast<u32>(_e735)) & 1023u);
                                            let _e746 = bitcast<f32>((bitcast<u32>(((_e660.member.member_1[2] - _e660.member.member[2]) * 0.0009775171f)) ^ _e127));
                                            let _e751 = (_e660.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e738)) - 8388608f) * _e746)) ^ _e127)));
                                            let _e755 = select(select(_e660.member.member_1[2], _e751, (_e751 < _e660.member.member_1[2])), _e660.member.member_1[2], (_e738 == 1023u));
                                            let _e758 = ((_e676.member[1] >> bitcast<u32>(_e691)) & 1023u);
                                            let _e766 = (_e660.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e758)) - 8388608f) * _e702)) ^ _e127)));
                                            let _e770 = select(select(_e660.member.member_1[0], _e766, (_e766 < _e660.member.member_1[0])), _e660.member.member_1[0], (_e758 == 1023u));
                                            let _e773 = ((_e676.member[1] >> bitcast<u32>(_e713)) & 1023u);
                                            let _e781 = (_e660.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e773)) - 8388608f) * _e724)) ^ _e127)));
                                            let _e785 = select(select(_e660.member.member_1[1], _e781, (_e781 < _e660.member.member_1[1])), _e660.member.member_1[1], (_e773 == 1023u));
                                            let _e788 = ((_e676.member[1] >> bitcast<u32>(_e735)) & 1023u);
                                            let _e796 = (_e660.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e788)) - 8388608f) * _e746)) ^ _e127)));
                                            let _e800 = select(select(_e660.member.member_1[2], _e796, (_e796 < _e660.member.member_1[2])), _e660.member.member_1[2], (_e788 == 1023u));
                                            let _e806 = ((_e676.member_1[0] >> bitcast<u32>(_e691)) & 1023u);
                                            let _e814 = (_e660.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e806)) - 8388608f) * _e702)) ^ _e127)));
                                            let _e818 = select(select(_e660.member.member_1[0], _e814, (_e814 < _e660.member.member_1[0])), _e660.member.member_1[0], (_e806 == 1023u));
                                            let _e821 = ((_e676.member_1[0] >> bitcast<u32>(_e713)) & 1023u);
                                            let _e829 = (_e660.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e821)) - 8388608f) * _e724)) ^ _e127)));
                                            let _e833 = select(select(_e660.member.member_1[1], _e829, (_e829 < _e660.member.member_1[1])), _e660.member.member_1[1], (_e821 == 1023u));
                                            let _e836 = ((_e676.member_1[0] >> bitcast<u32>(_e735)) & 1023u);
                                            let _e844 = (_e660.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e836)) - 8388608f) * _e746)) ^ _e127)));
                                            let _e848 = select(select(_e660.member.member_1[2], _e844, (_e844 < _e660.member.member_1[2])), _e660.member.member_1[2], (_e836 == 1023u));
                                            let _e851 = ((_e676.member_1[1] >> bitcast<u32>(_e691)) & 1023u);
                                            let _e859 = (_e660.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e851)) - 8388608f) * _e702)) ^ _e127)));
                                            let _e863 = select(select(_e660.member.member_1[0], _e859, (_e859 < _e660.member.member_1[0])), _e660.member.member_1[0], (_e851 == 1023u));
                                            let _e866 = ((_e676.member_1[1] >> bitcast<u32>(_e713)) & 1023u);
                                            let _e874 = (_e660.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e866)) - 8388608f) * _e724)) ^ _e127)));
                                            let _e878 = select(select(_e660.member.member_1[1], _e874, (_e874 < _e660.member.member_1[1])), _e660.member.member_1[1], (_e866 == 1023u));
                                            let _e881 = ((_e676.member_1[1] >> bitcast<u32>(_e735)) & 1023u);
                                            let _e889 = (_e660.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e881)) - 8388608f) * _e746)) ^ _e127)));
                                            let _e893 = select(select(_e660.member.member_1[2], _e889, (_e889 < _e660.member.member_1[2])), _e660.member.member_1[2], (_e881 == 1023u));
                                            let _e898 = type_54(type_46(array<f32, 3>(_e711, _e733, _e755), array<f32, 3>(_e770, _e785, _e800)), _e676.member_2);
                                            let _e903 = type_54(type_46(array<f32, 3>(_e818, _e833, _e848), array<f32, 3>(_e863, _e878, _e893)), _e676.member_3);
                                            let _e916 = ((_e711 - _e346) * _e349);
                                            let _e917 = ((_e818 - _e346) * _e349);
                                            let _e918 = ((_e770 - _e347) * _e349);
                                            let _e919 = ((_e863 - _e347) * _e349);
                                            let _e924 = ((_e733 - _e410) * _e413);
                                            let _e925 = ((_e833 - _e410) * _e413);
                                            let _e926 = ((_e785 - _e411) * _e413);
                                            let _e927 = ((_e878 - _e411) * _e413);
                                            let _e932 = ((_e755 - _e474) * _e477);
                                            let _e933 = ((_e848 - _e474) * _e477);
                                            let _e934 = ((_e800 - _e475) * _e477);
                                            let _e935 = ((_e893 - _e475) * _e477);
                                            let _e937 = select(_e934, _e932, (_e932 < _e934));
                                            let _e939 = select(_e935, _e933, (_e933 < _e935));
                                            let _e941 = select(_e934, _e932, (_e932 > _e934));
                                            let _e943 = select(_e935, _e933, (_e933 > _e935));
                                            let _e945 = select(_e918, _e916, (_e916 < _e918));
                                            let _e947 = select(_e919, _e917, (_e917 < _e919));
                                            let _e949 = select(_e926, _e924, (_e924 < _e926));
                                            let _e951 = select(_e927, _e925, (_e925 < _e927));
                                            let _e953 = select(_e949, _e945, (_e945 > _e949));
                                            let _e955 = select(_e951, _e947, (_e947 > _e951));
                                            let _e957 = select(_e937, _e953, (_e953 > _e937));
                                            let _e959 = select(_e939, _e955, (_e955 > _e939));
                                            let _e961 = select(_e918, _e916, (_e916 > _e918));
                                            let _e963 = select(_e919, _e917, (_e917 > _e919));
                                            let _e965 = select(_e926, _e924, (_e924 > _e926));
                                            let _e967 = select(_e927, _e925, (_e925 > _e927));
                                            let _e969 = select(_e965, _e961, (_e961 < _e965));
                                            let _e971 = select(_e967, _e963, (_e963 < _e967));
                                            let _e976 = -(_e937);
                                            let _e977 = -(_e939);
                                            let _e984 = (select(_e941, _e969, (_e969 < _e941)) + (select(_e976, _e941, (_e941 > _e976)) * 0.0000019073523f));
                                            let _e985 = (select(_e943, _e971, (_e971 < _e943)) + (select(_e977, _e943, (_e943 > _e977)) * 0.0000019073523f));
                                            let _e987 = select(_e579, _e957, (_e957 > _e579));
                                            let _e989 = select(_e579, _e959, (_e959 > _e579));
                                            let _e994 = (_e987 <= select(_e618.member.member_1, _e984, (_e984 < _e618.member.member_1)));
                                            let _e995 = (_e989 <= select(_e618.member.member_1, _e985, (_e985 < _e618.member.member_1)));
                                            let _e996 = (_e987 <= _e989);
                                            if _e994 {
                                                if _e995 {
                                                    if _e996 {
                                                        phi_3324_ = _e903;
                                                    } else {
                                                        phi_3324_ = _e898;
                                                    }
                                                    let _e998 = phi_3324_;
                                                    let _e1005 = (_e662 % 128u);
                                                    let _e1006 = (_e1005 < 128u);
                                                    if _e1006 {
                                                    } else {
                                                        phi_4059_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1005] = _e998.member_1;
                                                    if _e1006 {
                                                    } else {
                                                        phi_4059_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1005] = _e998.member.member[0];
                                                    if _e1006 {
                                                    } else {
                                                        phi_4059_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1005] = _e998.member.member[1];
                                                    if _e1006 {
                                                    } else {
                                                        phi_4059_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1005] = _e998.member.member[2];
                                                    if _e1006 {
                                                    } else {
                                                        phi_4059_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1005] = _e998.member.member_1[0];
                                                    if _e1006 {
                                                    } else {
                                                        phi_4059_ = true;
                                                        break;
                                                    }
                                                    local_1[_e1005] = _e998.member.member_1[1];
                                                    if _e1006 {
                                                    } else {
                                                        phi_4059_ = true;
                                                        break;
                                                    }
                                                    local[_e1005] = _e998.member.member_1[2];
                                                    if _e1006 {
                                                    } else {
                                                        phi_4059_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1005] = select(_e987, _e989, _e996);
                                                    if _e996 {
                                                        phi_3400_ = _e898;
                                                    } else {
                                                        phi_3400_ = _e903;
                                                    }
                                                    let _e1023 = phi_3400_;
                                                    phi_3401_ = _e1023;
                                                    phi_3402_ = (_e662 + 1u);
                                                } else {
                                                    phi_3401_ = type_54();
                                                    phi_3402_ = u32();
                                                }
                                                let _e1025 = phi_3401_;
                                                let _e1027 = phi_3402_;
                                                phi_3404_ = _e1025;
                                                phi_3405_ = _e1027;
                                                phi_3406_ = select(true, false, _e995);
                                            } else {
                                                phi_3404_ = type_54();
                                                phi_3405_ = u32();
                                                phi_3406_ = true;
                                            }
                                            let _e1030 = phi_3404_;
                                            let _e1032 = phi_3405_;
                                            let _e1034 = phi_3406_;
                                            if _e1034 {
                                                if _e994 {
                                                    phi_3413_ = _e898;
                                                } else {
                                                    phi_3413_ = _e903;
                                                }
                                                let _e1036 = phi_3413_;
                                                phi_3418_ = select(_e995, true, _e994);
                                                phi_3419_ = _e1036;
                                            } else {
                                                phi_3418_ = _e658;
                                                phi_3419_ = _e1030;
                                            }
                                            let _e1039 = phi_3418_;
                                            let _e1041 = phi_3419_;
                                            phi_4063_ = _e616;
                                            phi_3421_ = type_37(_e618.member, (_e618.member_1 + 1u), _e618.member_2);
                                            phi_3422_ = _e1039;
                                            phi_3423_ = _e1041;
                                            phi_3424_ = select(_e1032, _e662, _e1034);
                                        }
                                        let _e1729 = phi_4063_;
                                        let _e1731 = phi_3421_;
                                        let _e1733 = phi_3422_;
                                        let _e1735 = phi_3423_;
                                        let _e1737 = phi_3424_;
                                        phi_4062_ = _e1729;
                                        phi_3425_ = _e1731;
                                        phi_3426_ = _e1733;
                                        phi_3427_ = _e1735;
                                        phi_3428_ = _e1737;
                                        phi_3429_ = (_e626 - 1u);
                                    } else {
                                        phi_4062_ = _e616;
                                        phi_3425_ = _e618;
                                        phi_3426_ = _e658;
                                        phi_3427_ = _e660;
                                        phi_3428_ = _e662;
                                        phi_3429_ = _e626;
                                    }
                                    let _e1739 = phi_4062_;
                                    let _e1741 = phi_3425_;
                                    let _e1743 = phi_3426_;
                                    let _e1745 = phi_3427_;
                                    let _e1747 = phi_3428_;
                                    let _e1749 = phi_3429_;
                                    phi_4061_ = _e1739;
                                    phi_3430_ = _e1741;
                                    phi_3431_ = _e1743;
                                    phi_3432_ = _e1745;
                                    phi_3433_ = _e1747;
                                    phi_3434_ = _e1749;
                                } else {
                                    phi_4061_ = _e616;
                                    phi_3430_ = type_37();
                                    phi_3431_ = bool();
                                    phi_3432_ = type_54();
                                    phi_3433_ = u32();
                                    phi_3434_ = u32();
                                }
                                let _e1751 = phi_4061_;
                                let _e1753 = phi_3430_;
                                let _e1755 = phi_3431_;
                                let _e1757 = phi_3432_;
                                let _e1759 = phi_3433_;
                                let _e1761 = phi_3434_;
                                phi_4060_ = _e1751;
                                phi_1151_ = _e1753;
                                phi_1154_ = _e1755;
                                phi_1156_ = _e1757;
                                phi_1158_ = _e1759;
                                phi_1160_ = _e1761;
                                phi_3435_ = _e630;
                            } else {
                                phi_4060_ = _e616;
                                phi_1151_ = type_37();
                                phi_1154_ = bool();
                                phi_1156_ = type_54();
                                phi_1158_ = u32();
                                phi_1160_ = u32();
                                phi_3435_ = false;
                            }
                            let _e1763 = phi_4060_;
                            let _e1765 = phi_1151_;
                            let _e1767 = phi_1154_;
                            let _e1769 = phi_1156_;
                            let _e1771 = phi_1158_;
                            let _e1773 = phi_1160_;
                            let _e1775 = phi_3435_;
                            continue;
                            continuing {
                                phi_3894_ = _e1763;
                                phi_1150_ = _e1765;
                                phi_1153_ = _e1767;
                                phi_1155_ = _e1769;
                                phi_1157_ = _e1771;
                                phi_1159_ = _e1773;
                                phi_4059_ = _e1763;
                                break if !(_e1775);
                            }
                        }
                        let _e1778 = phi_4059_;
                        if _e1778 {
                            break;
                        }
                        let _e1780 = local_11;
                        if (_e1780.member.member.member_3 != 4294967295u) {
                            let _e1786 = bitcast<u32>(_e1780.member.member.member);
                            let _e1790 = (bitcast<i32>((_e1786 >> bitcast<u32>(23i))) & 255i);
                            let _e1791 = (_e1790 + _e263);
                            if (_e1790 == 255i) {
                                phi_3494_ = _e1780.member.member.member;
                            } else {
                                if (_e1790 > 0i) {
                                    if (_e1791 > 0i) {
                                        let _e1795 = (_e1791 < 255i);
                                        if _e1795 {
                                            phi_3473_ = bitcast<f32>((_e1786 + bitcast<u32>((_e263 << bitcast<u32>(23i)))));
                                        } else {
                                            phi_3473_ = f32();
                                        }
                                        let _e1802 = phi_3473_;
                                        phi_3475_ = _e1802;
                                        phi_3476_ = select(true, false, _e1795);
                                    } else {
                                        phi_3475_ = f32();
                                        phi_3476_ = true;
                                    }
                                    let _e1805 = phi_3475_;
                                    let _e1807 = phi_3476_;
                                    phi_3477_ = _e1805;
                                    phi_3478_ = _e1807;
                                } else {
                                    phi_3477_ = f32();
                                    phi_3478_ = true;
                                }
                                let _e1809 = phi_3477_;
                                let _e1811 = phi_3478_;
                                if _e1811 {
                                    let _e1812 = (_e1786 & 2147483648u);
                                    let _e1819 = ((_e1786 & 8388607u) | (select(0u, 1u, ((_e1786 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                    let _e1823 = (_e1819 == 0u);
                                    if _e1823 {
                                        phi_3858_ = bitcast<f32>(_e1812);
                                    } else {
                                        let _e1828 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1819)), 32u, _e1823) - 8u);
                                        let _e1831 = (_e1819 << bitcast<u32>((_e1828 & 31u)));
                                        let _e1833 = ((_e1791 + select(0i, 1i, (_e1790 == 0i))) - bitcast<i32>(_e1828));
                                        if (_e1833 >= 255i) {
                                            phi_3848_ = bitcast<f32>((_e1812 | 2139095040u));
                                            phi_3849_ = f32();
                                            phi_3850_ = true;
                                        } else {
                                            let _e1835 = (_e1833 > 0i);
                                            if _e1835 {
                                                phi_3842_ = bitcast<f32>(((_e1812 | (bitcast<u32>(_e1833) << bitcast<u32>(23i))) | (_e1831 & 8388607u)));
                                                phi_3843_ = f32();
                                            } else {
                                                if (_e1833 < -24i) {
                                                    phi_3808_ = 26u;
                                                } else {
                                                    phi_3808_ = bitcast<u32>((1i - _e1833));
                                                }
                                                let _e1840 = phi_3808_;
                                                let _e1841 = (_e1840 & 31u);
                                                let _e1843 = (_e1831 >> bitcast<u32>(_e1841));
                                                let _e1847 = (_e1831 & ((1u << bitcast<u32>(_e1841)) - 1u));
                                                let _e1851 = (1u << bitcast<u32>(((_e1840 - 1u) & 31u)));
                                                if (_e1847 > _e1851) {
                                                    phi_3829_ = true;
                                                } else {
                                                    if (_e1847 == _e1851) {
                                                        phi_3826_ = ((_e1843 & 1u) == 1u);
                                                    } else {
                                                        phi_3826_ = false;
                                                    }
                                                    let _e1857 = phi_3826_;
                                                    phi_3829_ = _e1857;
                                                }
                                                let _e1859 = phi_3829_;
                                                phi_3842_ = f32();
                                                phi_3843_ = bitcast<f32>((_e1812 | (_e1843 + select(0u, 1u, _e1859))));
                                            }
                                            let _e1872 = phi_3842_;
                                            let _e1874 = phi_3843_;
                                            phi_3848_ = _e1872;
                                            phi_3849_ = _e1874;
                                            phi_3850_ = _e1835;
                                        }
                                        let _e1878 = phi_3848_;
                                        let _e1880 = phi_3849_;
                                        let _e1882 = phi_3850_;
                                        phi_3858_ = select(_e1880, _e1878, _e1882);
                                    }
                                    let _e1886 = phi_3858_;
                                    phi_3493_ = _e1886;
                                } else {
                                    phi_3493_ = _e1809;
                                }
                                let _e1888 = phi_3493_;
                                phi_3494_ = _e1888;
                            }
                            let _e1890 = phi_3494_;
                            let _e1891 = bitcast<u32>(_e1890);
                            if ((_e1891 & 2147483647u) >= 2139095040u) {
                                phi_3506_ = bitcast<f32>(((_e1891 & 2147483648u) | 2139095039u));
                            } else {
                                phi_3506_ = _e1890;
                            }
                            let _e1898 = phi_3506_;
                            phi_3511_ = type_19(_e1898, _e1780.member.member.member_1, _e1780.member.member.member_2, _e1780.member.member.member_3);
                        } else {
                            phi_3511_ = type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1903 = phi_3511_;
                        if _e139 {
                        } else {
                            break;
                        }
                        global_1.member[_e131] = _e1903;
                        let _e1907 = local_12;
                        if _e140 {
                        } else {
                            break;
                        }
                        global_4.member[_e131] = _e1907.member_1;
                        if _e138 {
                        } else {
                            break;
                        }
                        let _e1912 = select(0u, 1u, (_e207 <= _e217));
                        if (_e1912 > 0u) {
                            let _e1914 = (1u < _e99);
                            if _e1914 {
                                if (0u < _e99) {
                                } else {
                                    break;
                                }
                                let _e1918 = atomicAdd((&global_5.member[0u]), _e1912);
                                if ((_e1918 + _e1912) < _e1918) {
                                    if _e1914 {
                                    } else {
                                        break;
                                    }
                                    let _e1923 = atomicAdd((&global_5.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1926 = select(0u, 1u, (_e1903.member_3 != 4294967295u));
                        if (_e1926 > 0u) {
                            let _e1928 = (3u < _e99);
                            if _e1928 {
                                if (2u < _e99) {
                                } else {
                                    break;
                                }
                                let _e1932 = atomicAdd((&global_5.member[2u]), _e1926);
                                if ((_e1932 + _e1926) < _e1932) {
                                    if _e1928 {
                                    } else {
                                        break;
                                    }
                                    let _e1937 = atomicAdd((&global_5.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1907.member_1 > 0u) {
                            let _e1939 = (5u < _e99);
                            if _e1939 {
                                if (4u < _e99) {
                                } else {
                                    break;
                                }
                                let _e1943 = atomicAdd((&global_5.member[4u]), _e1907.member_1);
                                if ((_e1943 + _e1907.member_1) < _e1943) {
                                    if _e1939 {
                                    } else {
                                        break;
                                    }
                                    let _e1948 = atomicAdd((&global_5.member[5u]), 1u);
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
