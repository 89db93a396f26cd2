struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_18 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_19 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_26 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_28 {
    member: array<type_19>,
}

struct type_32 {
    member: array<array<type_18, 8>>,
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

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(1) 
var<uniform> global_2: type_38;
@group(0) @binding(4) 
var<storage> global_3: type_28;
@group(0) @binding(2) 
var<storage> global_4: type_42;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_32;
@group(0) @binding(3) 
var<storage> global_6: type_49;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<f32, 128>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<u32, 128>;
    var local_7: array<type_18, 8>;
    var local_8: array<f32, 128>;
    var local_9: array<f32, 3>;
    var local_10: array<f32, 3>;
    var phi_461_: i32;
    var phi_462_: i32;
    var phi_472_: bool;
    var phi_482_: u32;
    var phi_483_: u32;
    var phi_485_: bool;
    var phi_490_: u32;
    var phi_503_: i32;
    var phi_523_: i32;
    var phi_541_: f32;
    var phi_547_: f32;
    var phi_587_: f32;
    var phi_593_: f32;
    var phi_666_: f32;
    var phi_672_: f32;
    var phi_712_: f32;
    var phi_718_: f32;
    var phi_791_: f32;
    var phi_797_: f32;
    var phi_837_: f32;
    var phi_843_: f32;
    var phi_962_: i32;
    var phi_984_: u32;
    var phi_985_: u32;
    var phi_1022_: i32;
    var phi_1044_: u32;
    var phi_1045_: u32;
    var phi_1053_: f32;
    var phi_1054_: f32;
    var phi_4077_: bool;
    var phi_3996_: f32;
    var phi_1190_: bool;
    var phi_1193_: type_53;
    var phi_1195_: u32;
    var phi_1197_: u32;
    var phi_1208_: bool;
    var phi_1295_: bool;
    var phi_1296_: type_53;
    var phi_1297_: u32;
    var phi_2539_: type_40;
    var phi_3426_: type_53;
    var phi_3502_: type_53;
    var phi_3503_: type_53;
    var phi_3504_: u32;
    var phi_3506_: type_53;
    var phi_3507_: u32;
    var phi_3508_: bool;
    var phi_3515_: type_53;
    var phi_3520_: bool;
    var phi_3521_: type_53;
    var phi_4074_: bool;
    var phi_4045_: f32;
    var phi_1316_: type_4;
    var phi_1317_: type_4;
    var phi_1340_: type_4;
    var phi_1365_: u32;
    var phi_1381_: type_47;
    var phi_2177_: f32;
    var phi_2178_: f32;
    var phi_2179_: f32;
    var phi_2180_: f32;
    var phi_2181_: vec3<f32>;
    var phi_2182_: vec3<f32>;
    var phi_2183_: vec3<f32>;
    var phi_2184_: vec3<f32>;
    var phi_2375_: f32;
    var phi_2395_: type_26;
    var phi_2396_: type_26;
    var phi_2399_: type_26;
    var phi_2400_: type_26;
    var phi_2401_: bool;
    var phi_2405_: type_26;
    var phi_2414_: type_18;
    var phi_2426_: type_4;
    var phi_2429_: type_18;
    var phi_2427_: type_4;
    var phi_2452_: type_4;
    var phi_2484_: bool;
    var phi_2485_: bool;
    var phi_2506_: type_18;
    var phi_2430_: type_18;
    var phi_4046_: bool;
    var phi_4306_: f32;
    var phi_4305_: f32;
    var phi_4220_: bool;
    var phi_4304_: f32;
    var phi_4219_: bool;
    var phi_4303_: f32;
    var phi_4218_: bool;
    var phi_4222_: f32;
    var phi_4217_: bool;
    var phi_4393_: f32;
    var phi_4311_: bool;
    var phi_3523_: bool;
    var phi_3524_: type_53;
    var phi_3525_: u32;
    var phi_4392_: f32;
    var phi_4310_: bool;
    var phi_3526_: bool;
    var phi_3527_: type_53;
    var phi_3528_: u32;
    var phi_3529_: u32;
    var phi_4391_: f32;
    var phi_4309_: bool;
    var phi_3530_: bool;
    var phi_3531_: type_53;
    var phi_3532_: u32;
    var phi_3533_: u32;
    var phi_4390_: f32;
    var phi_4308_: bool;
    var phi_1191_: bool;
    var phi_1194_: type_53;
    var phi_1196_: u32;
    var phi_1198_: u32;
    var phi_3534_: bool;
    var phi_4307_: bool;
    var phi_3541_: type_4;
    var phi_3542_: type_4;
    var phi_3565_: type_4;
    var phi_3617_: f32;
    var phi_3619_: f32;
    var phi_3620_: bool;
    var phi_3621_: f32;
    var phi_3622_: bool;
    var phi_3905_: u32;
    var phi_3923_: bool;
    var phi_3926_: bool;
    var phi_3939_: f32;
    var phi_3940_: f32;
    var phi_3945_: f32;
    var phi_3946_: f32;
    var phi_3947_: bool;
    var phi_3955_: f32;
    var phi_3637_: f32;
    var phi_3638_: f32;
    var phi_3650_: f32;
    var phi_3655_: type_18;
    var phi_4372_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e86 = global;
            let _e89 = arrayLength((&global_4.member));
            let _e100 = global_2.member[0u][0u];
            let _e104 = global_2.member[0u][1u];
            let _e108 = global_2.member[0u][2u];
            let _e112 = global_2.member[1u][0u];
            let _e116 = global_2.member[1u][1u];
            let _e120 = global_2.member[1u][2u];
            let _e124 = global_2.member[1u][3u];
            let _e127 = global_1.member[0u];
            let _e128 = bitcast<i32>(_e127);
            let _e138 = (_e86.x + (_e86.y * 2097152u));
            let _e139 = (_e138 < arrayLength((&global_3.member)));
            if _e139 {
                let _e140 = (_e138 < arrayLength((&global_5.member)));
                if _e140 {
                    if _e139 {
                    } else {
                        break;
                    }
                    let _e148 = global_3.member[_e138].member_2[0u];
                    let _e150 = (bitcast<u32>(_e148) & 2147483647u);
                    let _e155 = global_3.member[_e138].member_2[1u];
                    let _e157 = (bitcast<u32>(_e155) & 2147483647u);
                    let _e162 = global_3.member[_e138].member_2[2u];
                    let _e164 = (bitcast<u32>(_e162) & 2147483647u);
                    let _e169 = global_3.member[_e138].member[0u];
                    let _e171 = (bitcast<u32>(_e169) & 2147483647u);
                    let _e176 = global_3.member[_e138].member[1u];
                    let _e178 = (bitcast<u32>(_e176) & 2147483647u);
                    let _e183 = global_3.member[_e138].member[2u];
                    let _e185 = (bitcast<u32>(_e183) & 2147483647u);
                    let _e187 = select(_e157, _e150, (_e157 < _e150));
                    let _e189 = select(_e164, _e187, (_e164 < _e187));
                    let _e191 = select(_e171, _e189, (_e171 < _e189));
                    let _e193 = select(_e178, _e191, (_e178 < _e191));
                    let _e195 = select(_e185, _e193, (_e185 < _e193));
                    let _e199 = global_3.member[_e138].member_1;
                    let _e200 = bitcast<u32>(_e199);
                    let _e201 = (_e200 & 2147483647u);
                    let _e208 = global_3.member[_e138].member_3;
                    let _e209 = bitcast<u32>(_e208);
                    let _e210 = (_e209 & 2147483647u);
                    let _e214 = (((select(_e201, _e195, (_e201 < _e195)) < 2139095040u) && (_e210 <= 2139095040u)) && (_e189 > 0u));
                    if _e214 {
                        let _e217 = (bitcast<u32>(bitcast<f32>(_e189)) & 2147483647u);
                        if (_e217 >= 8388608u) {
                            phi_461_ = (bitcast<i32>((_e217 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_461_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e217)), 32u, (_e217 == 0u))));
                        }
                        let _e231 = phi_461_;
                        phi_462_ = _e231;
                    } else {
                        phi_462_ = 0i;
                    }
                    let _e233 = phi_462_;
                    let _e234 = (_e150 == _e189);
                    if _e234 {
                        phi_472_ = true;
                    } else {
                        phi_472_ = (_e157 == _e189);
                    }
                    let _e237 = phi_472_;
                    let _e238 = select(1u, 0u, _e234);
                    if _e237 {
                        let _e239 = (_e238 + 1u);
                        phi_482_ = _e239;
                        phi_483_ = _e239;
                        phi_485_ = select(true, false, (_e239 == 2u));
                    } else {
                        phi_482_ = u32();
                        phi_483_ = 0u;
                        phi_485_ = true;
                    }
                    let _e243 = phi_482_;
                    let _e245 = phi_483_;
                    let _e247 = phi_485_;
                    if _e247 {
                        phi_490_ = (_e245 + 1u);
                    } else {
                        phi_490_ = 0u;
                    }
                    let _e251 = phi_490_;
                    let _e252 = select(_e243, _e245, _e247);
                    let _e253 = select(_e238, select(2u, _e238, _e237), _e247);
                    if (_e128 < -126i) {
                        phi_503_ = -126i;
                    } else {
                        phi_503_ = select(_e128, 127i, (_e128 > 127i));
                    }
                    let _e258 = phi_503_;
                    let _e263 = bitcast<f32>((bitcast<u32>((_e258 + 127i)) << bitcast<u32>(23i)));
                    let _e269 = bitcast<f32>((bitcast<u32>(((_e128 - _e258) + 127i)) << bitcast<u32>(23i)));
                    let _e270 = -(_e233);
                    if (_e270 < -126i) {
                        phi_523_ = -126i;
                    } else {
                        phi_523_ = select(_e270, 127i, (_e270 > 127i));
                    }
                    let _e275 = phi_523_;
                    let _e280 = bitcast<f32>((bitcast<u32>((_e275 + 127i)) << bitcast<u32>(23i)));
                    let _e286 = bitcast<f32>((bitcast<u32>(((_e270 - _e275) + 127i)) << bitcast<u32>(23i)));
                    let _e290 = global_3.member[_e138].member;
                    let _e291 = (_e252 == 0u);
                    if _e291 {
                        phi_541_ = _e290[0];
                    } else {
                        phi_541_ = _e290[1];
                    }
                    let _e295 = phi_541_;
                    let _e296 = (_e252 == 2u);
                    if _e296 {
                        phi_547_ = _e290[2];
                    } else {
                        phi_547_ = _e295;
                    }
                    let _e299 = phi_547_;
                    let _e300 = bitcast<u32>(_e299);
                    let _e302 = ((_e300 & 2139095040u) != 0u);
                    let _e316 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e300 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e300 & 2147483648u))), _e299, _e302) * _e263) * select(0.00000011920929f, 1f, _e302)) * _e269);
                    let _e317 = global_3.member[_e138].member_2;
                    if _e291 {
                        phi_587_ = _e317[0];
                    } else {
                        phi_587_ = _e317[1];
                    }
                    let _e321 = phi_587_;
                    if _e296 {
                        phi_593_ = _e317[2];
                    } else {
                        phi_593_ = _e321;
                    }
                    let _e324 = phi_593_;
                    let _e325 = bitcast<u32>(_e324);
                    let _e327 = ((_e325 & 2139095040u) != 0u);
                    let _e341 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e325 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e325 & 2147483648u))), _e324, _e327) * _e280) * select(0.00000011920929f, 1f, _e327)) * _e286);
                    let _e345 = (bitcast<f32>((bitcast<u32>(_e341) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e348 = bitcast<f32>((bitcast<u32>(_e316) & 2147483647u));
                    let _e349 = (_e348 * 0.00000011920929f);
                    let _e352 = select(select(0.00000000000011368684f, _e349, (_e349 > 0.00000000000011368684f)), 0f, _e345);
                    let _e353 = select(0f, _e341, _e345);
                    let _e354 = (_e316 + _e352);
                    let _e355 = (_e316 - _e352);
                    let _e357 = select(38685626000000000000000000f, (1f / _e341), _e345);
                    let _e358 = (_e251 == 0u);
                    if _e358 {
                        phi_666_ = _e290[0];
                    } else {
                        phi_666_ = _e290[1];
                    }
                    let _e362 = phi_666_;
                    let _e363 = (_e251 == 2u);
                    if _e363 {
                        phi_672_ = _e290[2];
                    } else {
                        phi_672_ = _e362;
                    }
                    let _e366 = phi_672_;
                    let _e367 = bitcast<u32>(_e366);
                    let _e369 = ((_e367 & 2139095040u) != 0u);
                    let _e383 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e367 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e367 & 2147483648u))), _e366, _e369) * _e263) * select(0.00000011920929f, 1f, _e369)) * _e269);
                    if _e358 {
                        phi_712_ = _e317[0];
                    } else {
                        phi_712_ = _e317[1];
                    }
                    let _e387 = phi_712_;
                    if _e363 {
                        phi_718_ = _e317[2];
                    } else {
                        phi_718_ = _e387;
                    }
                    let _e390 = phi_718_;
                    let _e391 = bitcast<u32>(_e390);
                    let _e393 = ((_e391 & 2139095040u) != 0u);
                    let _e407 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e391 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e391 & 2147483648u))), _e390, _e393) * _e280) * select(0.00000011920929f, 1f, _e393)) * _e286);
                    let _e411 = (bitcast<f32>((bitcast<u32>(_e407) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e414 = bitcast<f32>((bitcast<u32>(_e383) & 2147483647u));
                    let _e415 = (_e414 * 0.00000011920929f);
                    let _e418 = select(select(0.00000000000011368684f, _e415, (_e415 > 0.00000000000011368684f)), 0f, _e411);
                    let _e419 = select(0f, _e407, _e411);
                    let _e420 = (_e383 + _e418);
                    let _e421 = (_e383 - _e418);
                    let _e423 = select(38685626000000000000000000f, (1f / _e407), _e411);
                    let _e424 = (_e253 == 0u);
                    if _e424 {
                        phi_791_ = _e290[0];
                    } else {
                        phi_791_ = _e290[1];
                    }
                    let _e428 = phi_791_;
                    let _e429 = (_e253 == 2u);
                    if _e429 {
                        phi_797_ = _e290[2];
                    } else {
                        phi_797_ = _e428;
                    }
                    let _e432 = phi_797_;
                    let _e433 = bitcast<u32>(_e432);
                    let _e435 = ((_e433 & 2139095040u) != 0u);
                    let _e449 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e433 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e433 & 2147483648u))), _e432, _e435) * _e263) * select(0.00000011920929f, 1f, _e435)) * _e269);
                    if _e424 {
                        phi_837_ = _e317[0];
                    } else {
                        phi_837_ = _e317[1];
                    }
                    let _e453 = phi_837_;
                    if _e429 {
                        phi_843_ = _e317[2];
                    } else {
                        phi_843_ = _e453;
                    }
                    let _e456 = phi_843_;
                    let _e457 = bitcast<u32>(_e456);
                    let _e459 = ((_e457 & 2139095040u) != 0u);
                    let _e473 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e457 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e457 & 2147483648u))), _e456, _e459) * _e280) * select(0.00000011920929f, 1f, _e459)) * _e286);
                    let _e477 = (bitcast<f32>((bitcast<u32>(_e473) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e480 = bitcast<f32>((bitcast<u32>(_e449) & 2147483647u));
                    let _e481 = (_e480 * 0.00000011920929f);
                    let _e484 = select(select(0.00000000000011368684f, _e481, (_e481 > 0.00000000000011368684f)), 0f, _e477);
                    let _e485 = select(0f, _e473, _e477);
                    let _e486 = (_e449 + _e484);
                    let _e487 = (_e449 - _e484);
                    let _e489 = select(38685626000000000000000000f, (1f / _e473), _e477);
                    let _e491 = select(_e414, _e348, (_e348 > _e414));
                    let _e494 = (_e128 + _e233);
                    if (_e214 && (select(_e480, _e491, (_e491 > _e480)) <= 1099511600000f)) {
                        let _e504 = ((_e201 & 8388607u) | (select(0u, 1u, ((_e201 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e507 = bitcast<i32>((_e201 >> bitcast<u32>(23i)));
                        let _e511 = (_e504 == 0u);
                        let _e514 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e504)), 32u, _e511)) - 8i);
                        if (_e507 == 255i) {
                            phi_962_ = 255i;
                        } else {
                            phi_962_ = (((_e507 + select(0i, 1i, (_e507 == 0i))) - _e514) + _e494);
                        }
                        let _e522 = phi_962_;
                        let _e532 = (_e522 <= 0i);
                        if _e532 {
                            phi_985_ = u32();
                        } else {
                            if _e511 {
                                phi_984_ = u32();
                            } else {
                                phi_984_ = select(((bitcast<u32>(_e522) << bitcast<u32>(23i)) | ((_e504 << bitcast<u32>(((_e514 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e522 >= 255i));
                            }
                            let _e536 = phi_984_;
                            phi_985_ = _e536;
                        }
                        let _e538 = phi_985_;
                        let _e550 = ((_e210 & 8388607u) | (select(0u, 1u, ((_e210 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e553 = bitcast<i32>((_e210 >> bitcast<u32>(23i)));
                        let _e557 = (_e550 == 0u);
                        let _e560 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e550)), 32u, _e557)) - 8i);
                        if (_e553 == 255i) {
                            phi_1022_ = 255i;
                        } else {
                            phi_1022_ = (((_e553 + select(0i, 1i, (_e553 == 0i))) - _e560) + _e494);
                        }
                        let _e568 = phi_1022_;
                        let _e578 = (_e568 <= 0i);
                        if _e578 {
                            phi_1045_ = u32();
                        } else {
                            if _e557 {
                                phi_1044_ = u32();
                            } else {
                                phi_1044_ = select(((bitcast<u32>(_e568) << bitcast<u32>(23i)) | ((_e550 << bitcast<u32>(((_e560 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e568 >= 255i));
                            }
                            let _e582 = phi_1044_;
                            phi_1045_ = _e582;
                        }
                        let _e584 = phi_1045_;
                        phi_1053_ = bitcast<f32>(((_e209 & 2147483648u) | select(_e584, 0u, select(_e557, true, _e578))));
                        phi_1054_ = bitcast<f32>(((_e200 & 2147483648u) | select(_e538, 0u, select(_e511, true, _e532))));
                    } else {
                        phi_1053_ = 0f;
                        phi_1054_ = 1f;
                    }
                    let _e590 = phi_1053_;
                    let _e592 = phi_1054_;
                    local_7 = array<type_18, 8>(type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_8 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_10 = array<f32, 3>(bitcast<f32>(_e100), bitcast<f32>(_e104), bitcast<f32>(_e108));
                    let _e598 = (_e252 % 3u);
                    let _e599 = (_e598 < 3u);
                    if _e599 {
                    } else {
                        break;
                    }
                    let _e601 = local_10[_e598];
                    let _e602 = (_e251 % 3u);
                    let _e603 = (_e602 < 3u);
                    if _e603 {
                    } else {
                        break;
                    }
                    let _e605 = local_10[_e602];
                    let _e606 = (_e253 % 3u);
                    let _e607 = (_e606 < 3u);
                    if _e607 {
                    } else {
                        break;
                    }
                    let _e609 = local_10[_e606];
                    local_9 = array<f32, 3>(bitcast<f32>(_e112), bitcast<f32>(_e116), bitcast<f32>(_e120));
                    if _e599 {
                    } else {
                        break;
                    }
                    let _e613 = local_9[_e598];
                    if _e603 {
                    } else {
                        break;
                    }
                    let _e615 = local_9[_e602];
                    if _e607 {
                    } else {
                        break;
                    }
                    let _e617 = local_9[_e606];
                    phi_4077_ = false;
                    phi_3996_ = _e590;
                    phi_1190_ = (_e592 <= _e590);
                    phi_1193_ = type_53(type_45(array<f32, 3>(_e601, _e605, _e609), array<f32, 3>(_e613, _e615, _e617)), select(0u, 2147483648u, (_e89 == 0u)));
                    phi_1195_ = 0u;
                    phi_1197_ = ((3u * _e89) + 1u);
                    loop {
                        let _e623 = phi_4077_;
                        let _e625 = phi_3996_;
                        let _e627 = phi_1190_;
                        let _e629 = phi_1193_;
                        let _e631 = phi_1195_;
                        let _e633 = phi_1197_;
                        if _e627 {
                            phi_1208_ = true;
                        } else {
                            phi_1208_ = (_e631 > 0u);
                        }
                        let _e636 = phi_1208_;
                        if _e636 {
                            let _e637 = (_e633 > 0u);
                            if _e637 {
                                if _e627 {
                                    phi_1295_ = _e627;
                                    phi_1296_ = _e629;
                                    phi_1297_ = _e631;
                                } else {
                                    let _e638 = (_e631 - 1u);
                                    let _e639 = (_e638 % 128u);
                                    let _e640 = (_e639 < 128u);
                                    if _e640 {
                                    } else {
                                        phi_4307_ = true;
                                        break;
                                    }
                                    let _e642 = local_6[_e639];
                                    if _e640 {
                                    } else {
                                        phi_4307_ = true;
                                        break;
                                    }
                                    let _e644 = local_5[_e639];
                                    if _e640 {
                                    } else {
                                        phi_4307_ = true;
                                        break;
                                    }
                                    let _e646 = local_4[_e639];
                                    if _e640 {
                                    } else {
                                        phi_4307_ = true;
                                        break;
                                    }
                                    let _e648 = local_3[_e639];
                                    if _e640 {
                                    } else {
                                        phi_4307_ = true;
                                        break;
                                    }
                                    let _e651 = local_2[_e639];
                                    if _e640 {
                                    } else {
                                        phi_4307_ = true;
                                        break;
                                    }
                                    let _e653 = local_1[_e639];
                                    if _e640 {
                                    } else {
                                        phi_4307_ = true;
                                        break;
                                    }
                                    let _e655 = local[_e639];
                                    if _e640 {
                                    } else {
                                        phi_4307_ = true;
                                        break;
                                    }
                                    let _e660 = local_8[_e639];
                                    phi_1295_ = (_e660 <= _e625);
                                    phi_1296_ = type_53(type_45(array<f32, 3>(_e644, _e646, _e648), array<f32, 3>(_e651, _e653, _e655)), _e642);
                                    phi_1297_ = _e638;
                                }
                                let _e663 = phi_1295_;
                                let _e665 = phi_1296_;
                                let _e667 = phi_1297_;
                                if _e663 {
                                    if ((_e665.member_1 & 2147483648u) != 0u) {
                                        phi_4074_ = _e623;
                                        phi_4045_ = _e625;
                                        phi_1316_ = type_4(0u, ((_e665.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1042 = phi_4074_;
                                            let _e1044 = phi_4045_;
                                            let _e1046 = phi_1316_;
                                            if (_e1046.member < _e1046.member_1) {
                                                phi_1317_ = type_4((_e1046.member + 1u), _e1046.member_1);
                                                phi_1340_ = type_4(1u, _e1046.member);
                                            } else {
                                                phi_1317_ = _e1046;
                                                phi_1340_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1059 = phi_1317_;
                                            let _e1061 = phi_1340_;
                                            let _e1065 = (bitcast<i32>(_e1061.member) != 0i);
                                            if _e1065 {
                                                let _e1066 = ((_e665.member_1 & 268435455u) + _e1061.member_1);
                                                let _e1067 = (_e1066 < arrayLength((&global_6.member)));
                                                if _e1067 {
                                                    if _e1067 {
                                                    } else {
                                                        phi_4222_ = _e1044;
                                                        phi_4217_ = true;
                                                        break;
                                                    }
                                                    let _e1070 = global_6.member[_e1066].member_1;
                                                    phi_1365_ = _e1070;
                                                } else {
                                                    phi_1365_ = 4294967295u;
                                                }
                                                let _e1072 = phi_1365_;
                                                if _e1067 {
                                                    if _e1067 {
                                                    } else {
                                                        phi_4222_ = _e1044;
                                                        phi_4217_ = true;
                                                        break;
                                                    }
                                                    let _e1074 = global_6.member[_e1066];
                                                    phi_1381_ = _e1074;
                                                } else {
                                                    phi_1381_ = type_47(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e1076 = phi_1381_;
                                                let _e1088 = ((10u * _e252) & 31u);
                                                let _e1091 = ((_e1076.member[0] >> bitcast<u32>(_e1088)) & 1023u);
                                                let _e1099 = bitcast<f32>((bitcast<u32>(((_e665.member.member_1[0] - _e665.member.member[0]) * 0.0009775171f)) ^ _e124));
                                                let _e1104 = (_e665.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1091)) - 8388608f) * _e1099)) ^ _e124)));
                                                let _e1108 = select(select(_e665.member.member_1[0], _e1104, (_e1104 < _e665.member.member_1[0])), _e665.member.member_1[0], (_e1091 == 1023u));
                                                let _e1110 = ((10u * _e251) & 31u);
                                                let _e1113 = ((_e1076.member[0] >> bitcast<u32>(_e1110)) & 1023u);
                                                let _e1121 = bitcast<f32>((bitcast<u32>(((_e665.member.member_1[1] - _e665.member.member[1]) * 0.0009775171f)) ^ _e124));
                                                let _e1126 = (_e665.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1113)) - 8388608f) * _e1121)) ^ _e124)));
                                                let _e1130 = select(select(_e665.member.member_1[1], _e1126, (_e1126 < _e665.member.member_1[1])), _e665.member.member_1[1], (_e1113 == 1023u));
                                                let _e1132 = ((10u * _e253) & 31u);
                                                let _e1135 = ((_e1076.member[0] >> bitcast<u32>(_e1132)) & 1023u);
                                                let _e1143 = bitcast<f32>((bitcast<u32>(((_e665.member.member_1[2] - _e665.member.member[2]) * 0.0009775171f)) ^ _e124));
                                                let _e1148 = (_e665.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1135)) - 8388608f) * _e1143)) ^ _e124)));
                                                let _e1152 = select(select(_e665.member.member_1[2], _e1148, (_e1148 < _e665.member.member_1[2])), _e665.member.member_1[2], (_e1135 == 1023u));
                                                let _e1156 = ((_e1076.member[1] >> bitcast<u32>(_e1088)) & 1023u);
                                                let _e1164 = (_e665.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1156)) - 8388608f) * _e1099)) ^ _e124)));
                                                let _e1168 = select(select(_e665.member.member_1[0], _e1164, (_e1164 < _e665.member.member_1[0])), _e665.member.member_1[0], (_e1156 == 1023u));
                                                let _e1171 = ((_e1076.member[1] >> bitcast<u32>(_e1110)) & 1023u);
                                                let _e1179 = (_e665.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1171)) - 8388608f) * _e1121)) ^ _e124)));
                                                let _e1183 = select(select(_e665.member.member_1[1], _e1179, (_e1179 < _e665.member.member_1[1])), _e665.member.member_1[1], (_e1171 == 1023u));
                                                let _e1186 = ((_e1076.member[1] >> bitcast<u32>(_e1132)) & 1023u);
                                                let _e1194 = (_e665.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1186)) - 8388608f) * _e1143)) ^ _e124)));
                                                let _e1198 = select(select(_e665.member.member_1[2], _e1194, (_e1194 < _e665.member.member_1[2])), _e665.member.member_1[2], (_e1186 == 1023u));
                                                let _e1202 = ((_e1076.member[2] >> bitcast<u32>(_e1088)) & 1023u);
                                                let _e1210 = (_e665.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1202)) - 8388608f) * _e1099)) ^ _e124)));
                                                let _e1214 = select(select(_e665.member.member_1[0], _e1210, (_e1210 < _e665.member.member_1[0])), _e665.member.member_1[0], (_e1202 == 1023u));
                                                let _e1217 = ((_e1076.member[2] >> bitcast<u32>(_e1110)) & 1023u);
                                                let _e1225 = (_e665.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1217)) - 8388608f) * _e1121)) ^ _e124)));
                                                let _e1229 = select(select(_e665.member.member_1[1], _e1225, (_e1225 < _e665.member.member_1[1])), _e665.member.member_1[1], (_e1217 == 1023u));
                                                let _e1232 = ((_e1076.member[2] >> bitcast<u32>(_e1132)) & 1023u);
                                                let _e1240 = (_e665.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1232)) - 8388608f) * _e1143)) ^ _e124)));
                                                let _e1244 = select(select(_e665.member.member_1[2], _e1240, (_e1240 < _e665.member.member_1[2])), _e665.member.member_1[2], (_e1232 == 1023u));
                                                let _e1247 = (_e1152 - _e449);
                                                let _e1250 = (((_e1108 - _e316) * _e485) - (_e1247 * _e353));
                                                let _e1253 = (((_e1130 - _e383) * _e485) - (_e1247 * _e419));
                                                let _e1256 = (_e1198 - _e449);
                                                let _e1259 = (((_e1168 - _e316) * _e485) - (_e1256 * _e353));
                                                let _e1262 = (((_e1183 - _e383) * _e485) - (_e1256 * _e419));
                                                let _e1265 = (_e1244 - _e449);
                                                let _e1268 = (((_e1214 - _e316) * _e485) - (_e1265 * _e353));
                                                let _e1271 = (((_e1229 - _e383) * _e485) - (_e1265 * _e419));
                                                let _e1272 = (_e1268 * _e1262);
                                                let _e1273 = (_e1271 * _e1259);
                                                let _e1274 = (_e1250 * _e1271);
                                                let _e1275 = (_e1253 * _e1268);
                                                let _e1276 = (_e1259 * _e1253);
                                                let _e1277 = (_e1262 * _e1250);
                                                let _e1282 = (((_e1272 >= _e1273) && (_e1274 >= _e1275)) && (_e1276 >= _e1277));
                                                let _e1288 = (_e1282 || (((_e1272 <= _e1273) && (_e1274 <= _e1275)) && (_e1276 <= _e1277)));
                                                if _e1288 {
                                                    let _e1290 = select(-1f, 1f, _e1282);
                                                    let _e1292 = ((_e1272 - _e1273) * _e1290);
                                                    let _e1294 = select(0f, _e1292, (_e1292 > 0f));
                                                    let _e1296 = ((_e1274 - _e1275) * _e1290);
                                                    let _e1298 = select(0f, _e1296, (_e1296 > 0f));
                                                    let _e1300 = ((_e1276 - _e1277) * _e1290);
                                                    let _e1302 = select(0f, _e1300, (_e1300 > 0f));
                                                    let _e1304 = ((_e1294 + _e1298) + _e1302);
                                                    let _e1306 = select(_e1168, _e1108, (_e1108 < _e1168));
                                                    let _e1310 = select(_e1168, _e1108, (_e1108 > _e1168));
                                                    let _e1314 = select(_e1183, _e1130, (_e1130 < _e1183));
                                                    let _e1318 = select(_e1183, _e1130, (_e1130 > _e1183));
                                                    let _e1322 = select(_e1198, _e1152, (_e1152 < _e1198));
                                                    let _e1326 = select(_e1198, _e1152, (_e1152 > _e1198));
                                                    let _e1331 = ((select(_e1214, _e1306, (_e1306 < _e1214)) - _e354) * _e357);
                                                    let _e1332 = ((select(_e1214, _e1310, (_e1310 > _e1214)) - _e355) * _e357);
                                                    let _e1335 = ((select(_e1229, _e1314, (_e1314 < _e1229)) - _e420) * _e423);
                                                    let _e1336 = ((select(_e1229, _e1318, (_e1318 > _e1229)) - _e421) * _e423);
                                                    let _e1339 = ((select(_e1244, _e1322, (_e1322 < _e1244)) - _e486) * _e489);
                                                    let _e1340 = ((select(_e1244, _e1326, (_e1326 > _e1244)) - _e487) * _e489);
                                                    let _e1342 = select(_e1340, _e1339, (_e1339 < _e1340));
                                                    let _e1344 = select(_e1340, _e1339, (_e1339 > _e1340));
                                                    let _e1346 = select(_e1332, _e1331, (_e1331 < _e1332));
                                                    let _e1348 = select(_e1336, _e1335, (_e1335 < _e1336));
                                                    let _e1350 = select(_e1348, _e1346, (_e1346 > _e1348));
                                                    let _e1352 = select(_e1342, _e1350, (_e1350 > _e1342));
                                                    let _e1354 = select(_e1332, _e1331, (_e1331 > _e1332));
                                                    let _e1356 = select(_e1336, _e1335, (_e1335 > _e1336));
                                                    let _e1358 = select(_e1356, _e1354, (_e1354 < _e1356));
                                                    let _e1360 = select(_e1344, _e1358, (_e1358 < _e1344));
                                                    let _e1361 = -(_e1342);
                                                    let _e1367 = select(_e592, _e1352, (_e1352 > _e592));
                                                    let _e1371 = select(_e1259, _e1250, (_e1250 < _e1259));
                                                    let _e1376 = select(_e1259, _e1250, (_e1250 > _e1259));
                                                    let _e1383 = select(_e1262, _e1253, (_e1253 < _e1262));
                                                    let _e1388 = select(_e1262, _e1253, (_e1253 > _e1262));
                                                    let _e1397 = (((((_e1288 && (_e1304 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1268, _e1371, (_e1371 < _e1268)) <= 0f) && (select(_e1268, _e1376, (_e1376 > _e1268)) >= 0f))) && ((select(_e1271, _e1383, (_e1383 < _e1271)) <= 0f) && (select(_e1271, _e1388, (_e1388 > _e1271)) >= 0f))) && (_e1367 <= (_e1360 + (select(_e1361, _e1344, (_e1344 > _e1361)) * 0.0000019073523f)))) && (_e1367 <= _e1044));
                                                    if _e1397 {
                                                        let _e1402 = (_e1168 - _e1108);
                                                        let _e1403 = (_e1183 - _e1130);
                                                        let _e1404 = (_e1198 - _e1152);
                                                        let _e1405 = vec3<f32>(_e1402, _e1403, _e1404);
                                                        let _e1406 = (_e1214 - _e1168);
                                                        let _e1407 = (_e1229 - _e1183);
                                                        let _e1408 = (_e1244 - _e1198);
                                                        let _e1409 = vec3<f32>(_e1406, _e1407, _e1408);
                                                        let _e1410 = (_e1108 - _e1214);
                                                        let _e1411 = (_e1130 - _e1229);
                                                        let _e1412 = (_e1152 - _e1244);
                                                        let _e1413 = vec3<f32>(_e1410, _e1411, _e1412);
                                                        let _e1416 = bitcast<f32>((bitcast<u32>(_e1402) & 2147483647u));
                                                        let _e1419 = bitcast<f32>((bitcast<u32>(_e1403) & 2147483647u));
                                                        let _e1421 = select(_e1419, _e1416, (_e1416 > _e1419));
                                                        let _e1424 = bitcast<f32>((bitcast<u32>(_e1404) & 2147483647u));
                                                        let _e1426 = select(_e1424, _e1421, (_e1421 > _e1424));
                                                        let _e1429 = bitcast<f32>((bitcast<u32>(_e1406) & 2147483647u));
                                                        let _e1432 = bitcast<f32>((bitcast<u32>(_e1407) & 2147483647u));
                                                        let _e1434 = select(_e1432, _e1429, (_e1429 > _e1432));
                                                        let _e1437 = bitcast<f32>((bitcast<u32>(_e1408) & 2147483647u));
                                                        let _e1439 = select(_e1437, _e1434, (_e1434 > _e1437));
                                                        let _e1442 = bitcast<f32>((bitcast<u32>(_e1410) & 2147483647u));
                                                        let _e1445 = bitcast<f32>((bitcast<u32>(_e1411) & 2147483647u));
                                                        let _e1447 = select(_e1445, _e1442, (_e1442 > _e1445));
                                                        let _e1450 = bitcast<f32>((bitcast<u32>(_e1412) & 2147483647u));
                                                        let _e1452 = select(_e1450, _e1447, (_e1447 > _e1450));
                                                        let _e1454 = select(_e1439, _e1426, (_e1426 > _e1439));
                                                        let _e1456 = select(_e1452, _e1454, (_e1454 > _e1452));
                                                        if (_e1426 == _e1456) {
                                                            phi_2177_ = _e1262;
                                                            phi_2178_ = _e1259;
                                                            phi_2179_ = _e1253;
                                                            phi_2180_ = _e1250;
                                                            phi_2181_ = vec3<f32>(_e1108, _e1130, _e1152);
                                                            phi_2182_ = _e1413;
                                                            phi_2183_ = _e1409;
                                                            phi_2184_ = _e1405;
                                                        } else {
                                                            let _e1458 = (_e1439 == _e1456);
                                                            let _e1463 = vec3(_e1458);
                                                            phi_2177_ = select(_e1253, _e1271, _e1458);
                                                            phi_2178_ = select(_e1250, _e1268, _e1458);
                                                            phi_2179_ = select(_e1271, _e1262, _e1458);
                                                            phi_2180_ = select(_e1268, _e1259, _e1458);
                                                            phi_2181_ = select(vec3<f32>(_e1214, _e1229, _e1244), vec3<f32>(_e1168, _e1183, _e1198), _e1463);
                                                            phi_2182_ = select(_e1409, _e1405, _e1463);
                                                            phi_2183_ = select(_e1405, _e1413, _e1463);
                                                            phi_2184_ = select(_e1413, _e1409, _e1463);
                                                        }
                                                        let _e1469 = phi_2177_;
                                                        let _e1471 = phi_2178_;
                                                        let _e1473 = phi_2179_;
                                                        let _e1475 = phi_2180_;
                                                        let _e1477 = phi_2181_;
                                                        let _e1479 = phi_2182_;
                                                        let _e1481 = phi_2183_;
                                                        let _e1483 = phi_2184_;
                                                        let _e1490 = ((_e1481.y * _e1479.z) - (_e1479.y * _e1481.z));
                                                        let _e1495 = ((_e1481.z * _e1479.x) - (_e1479.z * _e1481.x));
                                                        let _e1498 = ((_e1481.x * _e1479.y) - (_e1479.x * _e1481.y));
                                                        let _e1501 = ((_e1294 >= _e1298) && (_e1294 >= _e1302));
                                                        let _e1502 = (_e1298 >= _e1302);
                                                        let _e1516 = (((_e1490 * (select(select(_e1214, _e1168, _e1502), _e1108, _e1501) - _e316)) + (_e1495 * (select(select(_e1229, _e1183, _e1502), _e1130, _e1501) - _e383))) + (_e1498 * (select(select(_e1244, _e1198, _e1502), _e1152, _e1501) - _e449)));
                                                        let _e1521 = (((_e1490 * _e353) + (_e1495 * _e419)) + (_e1498 * _e485));
                                                        let _e1522 = (_e1471 - _e1475);
                                                        let _e1523 = (_e1469 - _e1473);
                                                        let _e1526 = ((_e1522 * _e1522) + (_e1523 * _e1523));
                                                        let _e1533 = (-(((_e1475 * _e1522) + (_e1473 * _e1523))) / select(0.000000000000000000000000000000000000011754944f, _e1526, (_e1526 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1535 = select(1f, _e1533, (_e1533 < 1f));
                                                        let _e1537 = select(0f, _e1535, (_e1535 > 0f));
                                                        let _e1546 = ((_e1477.x + (_e1483.x * _e1537)) - _e316);
                                                        let _e1549 = ((_e1477.y + (_e1483.y * _e1537)) - _e383);
                                                        let _e1552 = ((_e1477.z + (_e1483.z * _e1537)) - _e449);
                                                        let _e1555 = bitcast<f32>((bitcast<u32>(_e1546) & 2147483647u));
                                                        let _e1558 = bitcast<f32>((bitcast<u32>(_e1549) & 2147483647u));
                                                        let _e1560 = select(_e1558, _e1555, (_e1555 > _e1558));
                                                        let _e1563 = bitcast<f32>((bitcast<u32>(_e1552) & 2147483647u));
                                                        let _e1565 = select(_e1563, _e1560, (_e1560 > _e1563));
                                                        let _e1571 = bitcast<f32>((bitcast<u32>(_e1490) & 2147483647u));
                                                        let _e1574 = bitcast<f32>((bitcast<u32>(_e1495) & 2147483647u));
                                                        let _e1576 = select(_e1574, _e1571, (_e1571 > _e1574));
                                                        let _e1579 = bitcast<f32>((bitcast<u32>(_e1498) & 2147483647u));
                                                        let _e1598 = bitcast<f32>((bitcast<u32>(_e1481.x) & 2147483647u));
                                                        let _e1601 = bitcast<f32>((bitcast<u32>(_e1481.y) & 2147483647u));
                                                        let _e1603 = select(_e1601, _e1598, (_e1598 > _e1601));
                                                        let _e1606 = bitcast<f32>((bitcast<u32>(_e1481.z) & 2147483647u));
                                                        let _e1612 = bitcast<f32>((bitcast<u32>(_e1479.x) & 2147483647u));
                                                        let _e1615 = bitcast<f32>((bitcast<u32>(_e1479.y) & 2147483647u));
                                                        let _e1617 = select(_e1615, _e1612, (_e1612 > _e1615));
                                                        let _e1620 = bitcast<f32>((bitcast<u32>(_e1479.z) & 2147483647u));
                                                        let _e1626 = ((bitcast<f32>((bitcast<u32>(((((_e1490 * _e1546) + (_e1495 * _e1549)) + (_e1498 * _e1552)) - _e1516)) & 2147483647u)) <= ((0.0000009536743f * select(_e1456, _e1565, (_e1565 > _e1456))) * select(_e1579, _e1576, (_e1576 > _e1579)))) && !((bitcast<f32>((bitcast<u32>(_e1521) & 2147483647u)) <= ((0.0000038146973f * select(_e1606, _e1603, (_e1603 > _e1606))) * select(_e1620, _e1617, (_e1617 > _e1620))))));
                                                        let _e1627 = (_e1516 / _e1521);
                                                        if (_e1397 && !(_e1626)) {
                                                            let _e1630 = (_e1552 / _e485);
                                                            let _e1638 = (((_e1490 * (_e1546 - (_e353 * _e1630))) + (_e1495 * (_e1549 - (_e419 * _e1630)))) / _e1521);
                                                            phi_2375_ = select(select(_e1630, (_e1630 + _e1638), (bitcast<f32>((bitcast<u32>(_e1638) & 2147483647u)) <= _e1456)), _e1627, _e1626);
                                                        } else {
                                                            phi_2375_ = _e1627;
                                                        }
                                                        let _e1647 = phi_2375_;
                                                        let _e1649 = select(_e1360, _e1647, (_e1647 < _e1360));
                                                        let _e1651 = select(_e1352, _e1649, (_e1649 > _e1352));
                                                        let _e1652 = (1f / _e1304);
                                                        phi_2395_ = type_26(_e1651, (_e1298 * _e1652), (_e1302 * _e1652), ((_e1397 && (_e1651 >= _e592)) && (_e1651 <= _e1044)));
                                                        phi_2396_ = type_26();
                                                    } else {
                                                        phi_2395_ = type_26();
                                                        phi_2396_ = type_26(0f, 0f, 0f, _e1397);
                                                    }
                                                    let _e1661 = phi_2395_;
                                                    let _e1663 = phi_2396_;
                                                    phi_2399_ = _e1661;
                                                    phi_2400_ = _e1663;
                                                    phi_2401_ = select(true, false, _e1397);
                                                } else {
                                                    phi_2399_ = type_26();
                                                    phi_2400_ = type_26(0f, 0f, 0f, _e1288);
                                                    phi_2401_ = true;
                                                }
                                                let _e1666 = phi_2399_;
                                                let _e1668 = phi_2400_;
                                                let _e1670 = phi_2401_;
                                                if _e1670 {
                                                    phi_2405_ = _e1668;
                                                } else {
                                                    phi_2405_ = _e1666;
                                                }
                                                let _e1672 = phi_2405_;
                                                if _e1672.member_3 {
                                                    phi_2414_ = type_18(_e1672.member, _e1672.member_1, _e1672.member_2, _e1072);
                                                } else {
                                                    phi_2414_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1679 = phi_2414_;
                                                if (_e1679.member_3 != 4294967295u) {
                                                    if (_e1072 != 4294967295u) {
                                                        phi_2426_ = type_4(0u, 8u);
                                                        phi_2429_ = _e1679;
                                                        loop {
                                                            let _e1684 = phi_2426_;
                                                            let _e1686 = phi_2429_;
                                                            if (_e1684.member < _e1684.member_1) {
                                                                phi_2427_ = type_4((_e1684.member + 1u), _e1684.member_1);
                                                                phi_2452_ = type_4(1u, _e1684.member);
                                                            } else {
                                                                phi_2427_ = _e1684;
                                                                phi_2452_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1699 = phi_2427_;
                                                            let _e1701 = phi_2452_;
                                                            let _e1705 = (bitcast<i32>(_e1701.member) != 0i);
                                                            if _e1705 {
                                                                let _e1706 = (_e1701.member_1 < 8u);
                                                                if _e1706 {
                                                                } else {
                                                                    phi_4046_ = true;
                                                                    break;
                                                                }
                                                                let _e1711 = local_7[_e1701.member_1].member;
                                                                if (_e1686.member < _e1711) {
                                                                    phi_2485_ = true;
                                                                } else {
                                                                    let _e1713 = local_7[_e1701.member_1].member;
                                                                    if (_e1686.member == _e1713) {
                                                                        let _e1718 = local_7[_e1701.member_1].member_3;
                                                                        phi_2484_ = (_e1686.member_3 < _e1718);
                                                                    } else {
                                                                        phi_2484_ = false;
                                                                    }
                                                                    let _e1721 = phi_2484_;
                                                                    phi_2485_ = _e1721;
                                                                }
                                                                let _e1723 = phi_2485_;
                                                                if _e1723 {
                                                                    if _e1706 {
                                                                    } else {
                                                                        phi_4046_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1724 = local_7[_e1701.member_1];
                                                                    local_7[_e1701.member_1] = type_18(_e1686.member, _e1686.member_1, _e1686.member_2, _e1686.member_3);
                                                                    phi_2506_ = type_18(_e1724.member, _e1724.member_1, _e1724.member_2, _e1724.member_3);
                                                                } else {
                                                                    phi_2506_ = _e1686;
                                                                }
                                                                let _e1735 = phi_2506_;
                                                                phi_2430_ = _e1735;
                                                            } else {
                                                                phi_2430_ = type_18();
                                                            }
                                                            let _e1737 = phi_2430_;
                                                            continue;
                                                            continuing {
                                                                phi_2426_ = _e1699;
                                                                phi_2429_ = _e1737;
                                                                phi_4046_ = _e1042;
                                                                break if !(_e1705);
                                                            }
                                                        }
                                                        let _e1740 = phi_4046_;
                                                        phi_4222_ = _e1044;
                                                        phi_4217_ = _e1740;
                                                        if _e1740 {
                                                            break;
                                                        }
                                                        let _e1743 = local_7[7u].member_3;
                                                        if (_e1743 != 4294967295u) {
                                                            let _e1747 = local_7[7u].member;
                                                            phi_4306_ = _e1747;
                                                        } else {
                                                            phi_4306_ = _e1044;
                                                        }
                                                        let _e1749 = phi_4306_;
                                                        phi_4305_ = _e1749;
                                                        phi_4220_ = _e1740;
                                                    } else {
                                                        phi_4305_ = _e1044;
                                                        phi_4220_ = _e1042;
                                                    }
                                                    let _e1751 = phi_4305_;
                                                    let _e1753 = phi_4220_;
                                                    phi_4304_ = _e1751;
                                                    phi_4219_ = _e1753;
                                                } else {
                                                    phi_4304_ = _e1044;
                                                    phi_4219_ = _e1042;
                                                }
                                                let _e1755 = phi_4304_;
                                                let _e1757 = phi_4219_;
                                                phi_4303_ = _e1755;
                                                phi_4218_ = _e1757;
                                            } else {
                                                phi_4303_ = _e1044;
                                                phi_4218_ = _e1042;
                                            }
                                            let _e1759 = phi_4303_;
                                            let _e1761 = phi_4218_;
                                            continue;
                                            continuing {
                                                phi_4074_ = _e1761;
                                                phi_4045_ = _e1759;
                                                phi_1316_ = _e1059;
                                                phi_4222_ = _e1759;
                                                phi_4217_ = _e1761;
                                                break if !(_e1065);
                                            }
                                        }
                                        let _e1764 = phi_4222_;
                                        let _e1766 = phi_4217_;
                                        phi_4307_ = _e1766;
                                        if _e1766 {
                                            break;
                                        }
                                        phi_4393_ = _e1764;
                                        phi_4311_ = _e1766;
                                        phi_3523_ = false;
                                        phi_3524_ = _e665;
                                        phi_3525_ = select(_e667, 0u, (_e592 > _e1764));
                                    } else {
                                        let _e677 = (_e665.member_1 < _e89);
                                        if _e677 {
                                            if _e677 {
                                            } else {
                                                phi_4307_ = true;
                                                break;
                                            }
                                            let _e679 = global_4.member[_e665.member_1];
                                            phi_2539_ = _e679;
                                        } else {
                                            phi_2539_ = type_40(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e681 = phi_2539_;
                                        let _e696 = ((10u * _e252) & 31u);
                                        let _e699 = ((_e681.member[0] >> bitcast<u32>(_e696)) & 1023u);
                                        let _e707 = bitcast<f32>((bitcast<u32>(((_e665.member.member_1[0] - _e665.member.member[0]) * 0.0009775171f)) ^ _e124));
                                        let _e712 = (_e665.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e699)) - 8388608f) * _e707)) ^ _e124)));
                                        let _e716 = select(select(_e665.member.member_1[0], _e712, (_e712 < _e665.member.member_1[0])), _e665.member.member_1[0], (_e699 == 1023u));
                                        let _e718 = ((10u * _e251) & 31u);
                                        let _e721 = ((_e681.member[0] >> bitcast<u32>(_e718)) & 1023u);
                                        let _e729 = bitcast<f32>((bitcast<u32>(((_e665.member.member_1[1] - _e665.member.member[1]) * 0.0009775171f)) ^ _e124));
                                        let _e734 = (_e665.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e721)) - 8388608f) * _e729)) ^ _e124)));
                                        let _e738 = select(select(_e665.member.member_1[1], _e734, (_e734 < _e665.member.member_1[1])), _e665.member.member_1[1], (_e721 == 1023u));
                                        let _e740 = ((10u * _e253) & 31u);
                                        let _e743 = ((_e681.member[0] >> bitcast<u32>(_e740)) & 1023u);
                                        let _e751 = bitcast<f32>((bitcast<u32>(((_e665.member.member_1[2] - _e665.member.member[2]) * 0.0009775171f)) ^ _e124));
                                        let _e756 = (_e665.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e743)) - 8388608f) * _e751)) ^ _e124)));
                                        let _e760 = select(select(_e665.member.member_1[2], _e756, (_e756 < _e665.member.member_1[2])), _e665.member.member_1[2], (_e743 == 1023u));
                                        let _e763 = ((_e681.member[1] >> bitcast<u32>(_e696)) & 1023u);
                                        let _e771 = (_e665.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e763)) - 8388608f) * _e707)) ^ _e124)));
                                        let _e775 = select(select(_e665.member.member_1[0], _e771, (_e771 < _e665.member.member_1[0])), _e665.member.member_1[0], (_e763 == 1023u));
                                        let _e778 = ((_e681.member[1] >> bitcast<u32>(_e718)) & 1023u);
                                        let _e786 = (_e665.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e778)) - 8388608f) * _e729)) ^ _e124)));
                                        let _e790 = select(select(_e665.member.member_1[1], _e786, (_e786 < _e665.member.member_1[1])), _e665.member.member_1[1], (_e778 == 1023u));
                                        let _e793 = ((_e681.member[1] >> bitcast<u32>(_e740)) & 1023u);
                                        let _e801 = (_e665.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e793)) - 8388608f) * _e751)) ^ _e124)));
                                        let _e805 = select(select(_e665.member.member_1[2], _e801, (_e801 < _e665.member.member_1[2])), _e665.member.member_1[2], (_e793 == 1023u));
                                        let _e811 = ((_e681.member_1[0] >> bitcast<u32>(_e696)) & 1023u);
                                        let _e819 = (_e665.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e811)) - 8388608f) * _e707)) ^ _e124)));
                                        let _e823 = select(select(_e665.member.member_1[0], _e819, (_e819 < _e665.member.member_1[0])), _e665.member.member_1[0], (_e811 == 1023u));
                                        let _e826 = ((_e681.member_1[0] >> bitcast<u32>(_e718)) & 1023u);
                                        let _e834 = (_e665.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e826)) - 8388608f) * _e729)) ^ _e124)));
                                        let _e838 = select(select(_e665.member.member_1[1], _e834, (_e834 < _e665.member.member_1[1])), _e665.member.member_1[1], (_e826 == 1023u));
                                        let _e841 = ((_e681.member_1[0] >> bitcast<u32>(_e740)) & 1023u);
                                        let _e849 = (_e665.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e841)) - 8388608f) * _e751)) ^ _e124)));
                                        let _e853 = select(select(_e665.member.member_1[2], _e849, (_e849 < _e665.member.member_1[2])), _e665.member.member_1[2], (_e841 == 1023u));
                                        let _e856 = ((_e681.member_1[1] >> bitcast<u32>(_e696)) & 1023u);
                                        let _e864 = (_e665.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e856)) - 8388608f) * _e707)) ^ _e124)));
                                        let _e868 = select(select(_e665.member.member_1[0], _e864, (_e864 < _e665.member.member_1[0])), _e665.member.member_1[0], (_e856 == 1023u));
                                        let _e871 = ((_e681.member_1[1] >> bitcast<u32>(_e718)) & 1023u);
                                        let _e879 = (_e665.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e871)) - 8388608f) * _e729)) ^ _e124)));
                                        let _e883 = select(select(_e665.member.member_1[1], _e879, (_e879 < _e665.member.member_1[1])), _e665.member.member_1[1], (_e871 == 1023u));
                                        let _e886 = ((_e681.member_1[1] >> bitcast<u32>(_e740)) & 1023u);
                                        let _e894 = (_e665.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e886)) - 8388608f) * _e751)) ^ _e124)));
                                        let _e898 = select(select(_e665.member.member_1[2], _e894, (_e894 < _e665.member.member_1[2])), _e665.member.member_1[2], (_e886 == 1023u));
                                        let _e903 = type_53(type_45(array<f32, 3>(_e716, _e738, _e760), array<f32, 3>(_e775, _e790, _e805)), _e681.member_2);
                                        let _e908 = type_53(type_45(array<f32, 3>(_e823, _e838, _e853), array<f32, 3>(_e868, _e883, _e898)), _e681.member_3);
                                        let _e913 = ((_e716 - _e354) * _e357);
                                        let _e914 = ((_e823 - _e354) * _e357);
                                        let _e915 = ((_e775 - _e355) * _e357);
                                        let _e916 = ((_e868 - _e355) * _e357);
                                        let _e921 = ((_e738 - _e420) * _e423);
                                        let _e922 = ((_e838 - _e420) * _e423);
                                        let _e923 = ((_e790 - _e421) * _e423);
                                        let _e924 = ((_e883 - _e421) * _e423);
                                        let _e929 = ((_e760 - _e486) * _e489);
                                        let _e930 = ((_e853 - _e486) * _e489);
                                        let _e931 = ((_e805 - _e487) * _e489);
                                        let _e932 = ((_e898 - _e487) * _e489);
                                        let _e934 = select(_e931, _e929, (_e929 < _e931));
                                        let _e936 = select(_e932, _e930, (_e930 < _e932));
                                        let _e938 = select(_e931, _e929, (_e929 > _e931));
                                        let _e940 = select(_e932, _e930, (_e930 > _e932));
                                        let _e942 = select(_e915, _e913, (_e913 < _e915));
                                        let _e944 = select(_e916, _e914, (_e914 < _e916));
                                        let _e946 = select(_e923, _e921, (_e921 < _e923));
                                        let _e948 = select(_e924, _e922, (_e922 < _e924));
                                        let _e950 = select(_e946, _e942, (_e942 > _e946));
                                        let _e952 = select(_e948, _e944, (_e944 > _e948));
                                        let _e954 = select(_e934, _e950, (_e950 > _e934));
                                        let _e956 = select(_e936, _e952, (_e952 > _e936));
                                        let _e958 = select(_e915, _e913, (_e913 > _e915));
                                        let _e960 = select(_e916, _e914, (_e914 > _e916));
                                        let _e962 = select(_e923, _e921, (_e921 > _e923));
                                        let _e964 = select(_e924, _e922, (_e922 > _e924));
                                        let _e966 = select(_e962, _e958, (_e958 < _e962));
                                        let _e968 = select(_e964, _e960, (_e960 < _e964));
                                        let _e973 = -(_e934);
                                        let _e974 = -(_e936);
                                        let _e981 = (select(_e938, _e966, (_e966 < _e938)) + (select(_e973, _e938, (_e938 > _e973)) * 0.0000019073523f));
                                        let _e982 = (select(_e940, _e968, (_e968 < _e940)) + (select(_e974, _e940, (_e940 > _e974)) * 0.0000019073523f));
                                        let _e984 = select(_e592, _e954, (_e954 > _e592));
                                        let _e986 = select(_e592, _e956, (_e956 > _e592));
                                        let _e991 = (_e984 <= select(_e625, _e981, (_e981 < _e625)));
                                        let _e992 = (_e986 <= select(_e625, _e982, (_e982 < _e625)));
                                        let _e993 = (_e984 <= _e986);
                                        if _e991 {
                                            if _e992 {
                                                if _e993 {
                                                    phi_3426_ = _e908;
                                                } else {
                                                    phi_3426_ = _e903;
                                                }
                                                let _e995 = phi_3426_;
                                                let _e1002 = (_e667 % 128u);
                                                let _e1003 = (_e1002 < 128u);
                                                if _e1003 {
                                                } else {
                                                    phi_4307_ = true;
                                                    break;
                                                }
                                                local_6[_e1002] = _e995.member_1;
                                                if _e1003 {
                                                } else {
                                                    phi_4307_ = true;
                                                    break;
                                                }
                                                local_5[_e1002] = _e995.member.member[0];
                                                if _e1003 {
                                                } else {
                                                    phi_4307_ = true;
                                                    break;
                                                }
                                                local_4[_e1002] = _e995.member.member[1];
                                                if _e1003 {
                                                } else {
                                                    phi_4307_ = true;
                                                    break;
                                                }
                                                local_3[_e1002] = _e995.member.member[2];
                                                if _e1003 {
                                                } else {
                                                    phi_4307_ = true;
                                                    break;
                                                }
                                                local_2[_e1002] = _e995.member.member_1[0];
                                                if _e1003 {
                                                } else {
                                                    phi_4307_ = true;
                                                    break;
                                                }
                                                local_1[_e1002] = _e995.member.member_1[1];
                                                if _e1003 {
                                                } else {
                                                    phi_4307_ = true;
                                                    break;
                                                }
                                                local[_e1002] = _e995.member.member_1[2];
                                                if _e1003 {
                                                } else {
                                                    phi_4307_ = true;
                                                    break;
                                                }
                                                local_8[_e1002] = select(_e984, _e986, _e993);
                                                if _e993 {
                                                    phi_3502_ = _e903;
                                                } else {
                                                    phi_3502_ = _e908;
                                                }
                                                let _e1020 = phi_3502_;
                                                phi_3503_ = _e1020;
                                                phi_3504_ = (_e667 + 1u);
                                            } else {
                                                phi_3503_ = type_53();
                                                phi_3504_ = u32();
                                            }
                                            let _e1022 = phi_3503_;
                                            let _e1024 = phi_3504_;
                                            phi_3506_ = _e1022;
                                            phi_3507_ = _e1024;
                                            phi_3508_ = select(true, false, _e992);
                                        } else {
                                            phi_3506_ = type_53();
                                            phi_3507_ = u32();
                                            phi_3508_ = true;
                                        }
                                        let _e1027 = phi_3506_;
                                        let _e1029 = phi_3507_;
                                        let _e1031 = phi_3508_;
                                        if _e1031 {
                                            if _e991 {
                                                phi_3515_ = _e903;
                                            } else {
                                                phi_3515_ = _e908;
                                            }
                                            let _e1033 = phi_3515_;
                                            phi_3520_ = select(_e992, true, _e991);
                                            phi_3521_ = _e1033;
                                        } else {
                                            phi_3520_ = _e663;
                                            phi_3521_ = _e1027;
                                        }
                                        let _e1036 = phi_3520_;
                                        let _e1038 = phi_3521_;
                                        phi_4393_ = _e625;
                                        phi_4311_ = _e623;
                                        phi_3523_ = _e1036;
                                        phi_3524_ = _e1038;
                                        phi_3525_ = select(_e1029, _e667, _e1031);
                                    }
                                    let _e1770 = phi_4393_;
                                    let _e1772 = phi_4311_;
                                    let _e1774 = phi_3523_;
                                    let _e1776 = phi_3524_;
                                    let _e1778 = phi_3525_;
                                    phi_4392_ = _e1770;
                                    phi_4310_ = _e1772;
                                    phi_3526_ = _e1774;
                                    phi_3527_ = _e1776;
                                    phi_3528_ = _e1778;
                                    phi_3529_ = (_e633 - 1u);
                                } else {
                                    phi_4392_ = _e625;
                                    phi_4310_ = _e623;
                                    phi_3526_ = _e663;
                                    phi_3527_ = _e665;
                                    phi_3528_ = _e667;
                                    phi_3529_ = _e633;
                                }
                                let _e1780 = phi_4392_;
                                let _e1782 = phi_4310_;
                                let _e1784 = phi_3526_;
                                let _e1786 = phi_3527_;
                                let _e1788 = phi_3528_;
                                let _e1790 = phi_3529_;
                                phi_4391_ = _e1780;
                                phi_4309_ = _e1782;
                                phi_3530_ = _e1784;
                                phi_3531_ = _e1786;
                                phi_3532_ = _e1788;
                                phi_3533_ = _e1790;
                            } else {
                                phi_4391_ = _e625;
                                phi_4309_ = _e623;
                                phi_3530_ = bool();
                                phi_3531_ = type_53();
                                phi_3532_ = u32();
                                phi_3533_ = u32();
                            }
                            let _e1792 = phi_4391_;
                            let _e1794 = phi_4309_;
                            let _e1796 = phi_3530_;
                            let _e1798 = phi_3531_;
                            let _e1800 = phi_3532_;
                            let _e1802 = phi_3533_;
                            phi_4390_ = _e1792;
                            phi_4308_ = _e1794;
                            phi_1191_ = _e1796;
                            phi_1194_ = _e1798;
                            phi_1196_ = _e1800;
                            phi_1198_ = _e1802;
                            phi_3534_ = _e637;
                        } else {
                            phi_4390_ = _e625;
                            phi_4308_ = _e623;
                            phi_1191_ = bool();
                            phi_1194_ = type_53();
                            phi_1196_ = u32();
                            phi_1198_ = u32();
                            phi_3534_ = false;
                        }
                        let _e1804 = phi_4390_;
                        let _e1806 = phi_4308_;
                        let _e1808 = phi_1191_;
                        let _e1810 = phi_1194_;
                        let _e1812 = phi_1196_;
                        let _e1814 = phi_1198_;
                        let _e1816 = phi_3534_;
                        continue;
                        continuing {
                            phi_4077_ = _e1806;
                            phi_3996_ = _e1804;
                            phi_1190_ = _e1808;
                            phi_1193_ = _e1810;
                            phi_1195_ = _e1812;
                            phi_1197_ = _e1814;
                            phi_4307_ = _e1806;
                            break if !(_e1816);
                        }
                    }
                    let _e1819 = phi_4307_;
                    if _e1819 {
                        break;
                    }
                    phi_3541_ = type_4(0u, 8u);
                    loop {
                        let _e1821 = phi_3541_;
                        if (_e1821.member < _e1821.member_1) {
                            phi_3542_ = type_4((_e1821.member + 1u), _e1821.member_1);
                            phi_3565_ = type_4(1u, _e1821.member);
                        } else {
                            phi_3542_ = _e1821;
                            phi_3565_ = type_4(0u, type_4().member_1);
                        }
                        let _e1834 = phi_3542_;
                        let _e1836 = phi_3565_;
                        let _e1840 = (bitcast<i32>(_e1836.member) != 0i);
                        if _e1840 {
                            let _e1841 = (_e1836.member_1 < 8u);
                            if _e1841 {
                            } else {
                                phi_4372_ = true;
                                break;
                            }
                            let _e1843 = local_7[_e1836.member_1];
                            if (_e1843.member_3 != 4294967295u) {
                                let _e1849 = -(_e494);
                                let _e1850 = bitcast<u32>(_e1843.member);
                                let _e1854 = (bitcast<i32>((_e1850 >> bitcast<u32>(23i))) & 255i);
                                let _e1855 = (_e1854 + _e1849);
                                if (_e1854 == 255i) {
                                    phi_3638_ = _e1843.member;
                                } else {
                                    if (_e1854 > 0i) {
                                        if (_e1855 > 0i) {
                                            let _e1859 = (_e1855 < 255i);
                                            if _e1859 {
                                                phi_3617_ = bitcast<f32>((_e1850 + bitcast<u32>((_e1849 << bitcast<u32>(23i)))));
                                            } else {
                                                phi_3617_ = f32();
                                            }
                                            let _e1866 = phi_3617_;
                                            phi_3619_ = _e1866;
                                            phi_3620_ = select(true, false, _e1859);
                                        } else {
                                            phi_3619_ = f32();
                                            phi_3620_ = true;
                                        }
                                        let _e1869 = phi_3619_;
                                        let _e1871 = phi_3620_;
                                        phi_3621_ = _e1869;
                                        phi_3622_ = _e1871;
                                    } else {
                                        phi_3621_ = f32();
                                        phi_3622_ = true;
                                    }
                                    let _e1873 = phi_3621_;
                                    let _e1875 = phi_3622_;
                                    if _e1875 {
                                        let _e1876 = (_e1850 & 2147483648u);
                                        let _e1883 = ((_e1850 & 8388607u) | (select(0u, 1u, ((_e1850 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                        let _e1887 = (_e1883 == 0u);
                                        if _e1887 {
                                            phi_3955_ = bitcast<f32>(_e1876);
                                        } else {
                                            let _e1892 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1883)), 32u, _e1887) - 8u);
                                            let _e1895 = (_e1883 << bitcast<u32>((_e1892 & 31u)));
                                            let _e1897 = ((_e1855 + select(0i, 1i, (_e1854 == 0i))) - bitcast<i32>(_e1892));
                                            if (_e1897 >= 255i) {
                                                phi_3945_ = bitcast<f32>((_e1876 | 2139095040u));
                                                phi_3946_ = f32();
                                                phi_3947_ = true;
                                            } else {
                                                let _e1899 = (_e1897 > 0i);
                                                if _e1899 {
                                                    phi_3939_ = bitcast<f32>(((_e1876 | (bitcast<u32>(_e1897) << bitcast<u32>(23i))) | (_e1895 & 8388607u)));
                                                    phi_3940_ = f32();
                                                } else {
                                                    if (_e1897 < -24i) {
                                                        phi_3905_ = 26u;
                                                    } else {
                                                        phi_3905_ = bitcast<u32>((1i - _e1897));
                                                    }
                                                    let _e1904 = phi_3905_;
                                                    let _e1905 = (_e1904 & 31u);
                                                    let _e1907 = (_e1895 >> bitcast<u32>(_e1905));
                                                    let _e1911 = (_e1895 & ((1u << bitcast<u32>(_e1905)) - 1u));
                                                    let _e1915 = (1u << bitcast<u32>(((_e1904 - 1u) & 31u)));
                                                    if (_e1911 > _e1915) {
                                                        phi_3926_ = true;
                                                    } else {
                                                        if (_e1911 == _e1915) {
                                                            phi_3923_ = ((_e1907 & 1u) == 1u);
                                                        } else {
                                                            phi_3923_ = false;
                                                        }
                                                        let _e1921 = phi_3923_;
                                                        phi_3926_ = _e1921;
                                                    }
                                                    let _e1923 = phi_3926_;
                                                    phi_3939_ = f32();
                                                    phi_3940_ = bitcast<f32>((_e1876 | (_e1907 + select(0u, 1u, _e1923))));
                                                }
                                                let _e1936 = phi_3939_;
                                                let _e1938 = phi_3940_;
                                                phi_3945_ = _e1936;
                                                phi_3946_ = _e1938;
                                                phi_3947_ = _e1899;
                                            }
                                            let _e1942 = phi_3945_;
                                            let _e1944 = phi_3946_;
                                            let _e1946 = phi_3947_;
                                            phi_3955_ = select(_e1944, _e1942, _e1946);
                                        }
                                        let _e1950 = phi_3955_;
                                        phi_3637_ = _e1950;
                                    } else {
                                        phi_3637_ = _e1873;
                                    }
                                    let _e1952 = phi_3637_;
                                    phi_3638_ = _e1952;
                                }
                                let _e1954 = phi_3638_;
                                let _e1955 = bitcast<u32>(_e1954);
                                if ((_e1955 & 2147483647u) >= 2139095040u) {
                                    phi_3650_ = bitcast<f32>(((_e1955 & 2147483648u) | 2139095039u));
                                } else {
                                    phi_3650_ = _e1954;
                                }
                                let _e1962 = phi_3650_;
                                phi_3655_ = type_18(_e1962, _e1843.member_1, _e1843.member_2, _e1843.member_3);
                            } else {
                                phi_3655_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1965 = phi_3655_;
                            if _e1841 {
                            } else {
                                phi_4372_ = true;
                                break;
                            }
                            local_7[_e1836.member_1] = type_18(_e1965.member, _e1965.member_1, _e1965.member_2, _e1965.member_3);
                        }
                        continue;
                        continuing {
                            phi_3541_ = _e1834;
                            phi_4372_ = _e1819;
                            break if !(_e1840);
                        }
                    }
                    let _e1973 = phi_4372_;
                    if _e1973 {
                        break;
                    }
                    let _e1974 = local_7;
                    if _e140 {
                    } else {
                        break;
                    }
                    global_5.member[_e138] = array<type_18, 8>(type_18(_e1974[0].member, _e1974[0].member_1, _e1974[0].member_2, _e1974[0].member_3), type_18(_e1974[1].member, _e1974[1].member_1, _e1974[1].member_2, _e1974[1].member_3), type_18(_e1974[2].member, _e1974[2].member_1, _e1974[2].member_2, _e1974[2].member_3), type_18(_e1974[3].member, _e1974[3].member_1, _e1974[3].member_2, _e1974[3].member_3), type_18(_e1974[4].member, _e1974[4].member_1, _e1974[4].member_2, _e1974[4].member_3), type_18(_e1974[5].member, _e1974[5].member_1, _e1974[5].member_2, _e1974[5].member_3), type_18(_e1974[6].member, _e1974[6].member_1, _e1974[6].member_2, _e1974[6].member_3), type_18(_e1974[7].member, _e1974[7].member_1, _e1974[7].member_2, _e1974[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
