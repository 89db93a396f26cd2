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
    var phi_454_: i32;
    var phi_455_: i32;
    var phi_465_: bool;
    var phi_475_: u32;
    var phi_476_: u32;
    var phi_478_: bool;
    var phi_483_: u32;
    var phi_496_: i32;
    var phi_516_: i32;
    var phi_534_: f32;
    var phi_540_: f32;
    var phi_580_: f32;
    var phi_586_: f32;
    var phi_659_: f32;
    var phi_665_: f32;
    var phi_705_: f32;
    var phi_711_: f32;
    var phi_784_: f32;
    var phi_790_: f32;
    var phi_830_: f32;
    var phi_836_: f32;
    var phi_955_: i32;
    var phi_977_: u32;
    var phi_978_: u32;
    var phi_1015_: i32;
    var phi_1037_: u32;
    var phi_1038_: u32;
    var phi_1046_: f32;
    var phi_1047_: f32;
    var phi_4122_: bool;
    var phi_4066_: f32;
    var phi_1183_: u32;
    var phi_1186_: bool;
    var phi_1188_: u32;
    var phi_1190_: type_53;
    var phi_1201_: bool;
    var phi_1288_: bool;
    var phi_1289_: u32;
    var phi_1290_: type_53;
    var phi_4119_: bool;
    var phi_4089_: f32;
    var phi_1309_: type_4;
    var phi_1310_: type_4;
    var phi_1333_: type_4;
    var phi_1358_: u32;
    var phi_1374_: type_47;
    var phi_3782_: bool;
    var phi_3797_: bool;
    var phi_3812_: bool;
    var phi_3827_: bool;
    var phi_3842_: bool;
    var phi_3857_: bool;
    var phi_2182_: f32;
    var phi_2183_: f32;
    var phi_2184_: f32;
    var phi_2185_: f32;
    var phi_2186_: vec3<f32>;
    var phi_2187_: vec3<f32>;
    var phi_2188_: vec3<f32>;
    var phi_2189_: vec3<f32>;
    var phi_3872_: bool;
    var phi_3887_: bool;
    var phi_3902_: bool;
    var phi_3917_: bool;
    var phi_3932_: bool;
    var phi_3947_: bool;
    var phi_2397_: f32;
    var phi_2417_: type_26;
    var phi_2418_: type_26;
    var phi_2421_: type_26;
    var phi_2422_: type_26;
    var phi_2423_: bool;
    var phi_2427_: type_26;
    var phi_2436_: type_18;
    var phi_2448_: type_4;
    var phi_2451_: type_18;
    var phi_2449_: type_4;
    var phi_2474_: type_4;
    var phi_2506_: bool;
    var phi_2507_: bool;
    var phi_2528_: type_18;
    var phi_2452_: type_18;
    var phi_4091_: bool;
    var phi_4401_: f32;
    var phi_4400_: f32;
    var phi_4277_: bool;
    var phi_4399_: f32;
    var phi_4276_: bool;
    var phi_4398_: f32;
    var phi_4275_: bool;
    var phi_4305_: f32;
    var phi_4274_: bool;
    var phi_4461_: bool;
    var phi_4304_: f32;
    var phi_2560_: type_40;
    var phi_3447_: type_53;
    var phi_3523_: type_53;
    var phi_3524_: u32;
    var phi_3525_: type_53;
    var phi_3527_: u32;
    var phi_3528_: type_53;
    var phi_3529_: bool;
    var phi_3536_: type_53;
    var phi_3541_: bool;
    var phi_3543_: type_53;
    var phi_3547_: bool;
    var phi_3548_: u32;
    var phi_3549_: type_53;
    var phi_3559_: type_53;
    var phi_4488_: f32;
    var phi_4405_: bool;
    var phi_3560_: u32;
    var phi_3561_: bool;
    var phi_3562_: u32;
    var phi_3563_: type_53;
    var phi_4487_: f32;
    var phi_4404_: bool;
    var phi_3564_: u32;
    var phi_3565_: bool;
    var phi_3566_: u32;
    var phi_3567_: type_53;
    var phi_4486_: f32;
    var phi_4403_: bool;
    var phi_1184_: u32;
    var phi_1187_: bool;
    var phi_1189_: u32;
    var phi_1191_: type_53;
    var phi_3568_: bool;
    var phi_4402_: bool;
    var phi_3575_: type_4;
    var phi_3576_: type_4;
    var phi_3599_: type_4;
    var phi_3651_: f32;
    var phi_3653_: f32;
    var phi_3654_: bool;
    var phi_3655_: f32;
    var phi_3656_: bool;
    var phi_3975_: u32;
    var phi_3993_: bool;
    var phi_3996_: bool;
    var phi_4009_: f32;
    var phi_4010_: f32;
    var phi_4015_: f32;
    var phi_4016_: f32;
    var phi_4017_: bool;
    var phi_4025_: f32;
    var phi_3671_: f32;
    var phi_3672_: f32;
    var phi_3684_: f32;
    var phi_3689_: type_18;
    var phi_4468_: bool;

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
                            phi_454_ = (bitcast<i32>((_e217 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_454_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e217)), 32u, (_e217 == 0u))));
                        }
                        let _e231 = phi_454_;
                        phi_455_ = _e231;
                    } else {
                        phi_455_ = 0i;
                    }
                    let _e233 = phi_455_;
                    let _e234 = (_e150 == _e189);
                    if _e234 {
                        phi_465_ = true;
                    } else {
                        phi_465_ = (_e157 == _e189);
                    }
                    let _e237 = phi_465_;
                    let _e238 = select(1u, 0u, _e234);
                    if _e237 {
                        let _e239 = (_e238 + 1u);
                        phi_475_ = _e239;
                        phi_476_ = _e239;
                        phi_478_ = select(true, false, (_e239 == 2u));
                    } else {
                        phi_475_ = u32();
                        phi_476_ = 0u;
                        phi_478_ = true;
                    }
                    let _e243 = phi_475_;
                    let _e245 = phi_476_;
                    let _e247 = phi_478_;
                    if _e247 {
                        phi_483_ = (_e245 + 1u);
                    } else {
                        phi_483_ = 0u;
                    }
                    let _e251 = phi_483_;
                    let _e252 = select(_e243, _e245, _e247);
                    let _e253 = select(_e238, select(2u, _e238, _e237), _e247);
                    if (_e128 < -126i) {
                        phi_496_ = -126i;
                    } else {
                        phi_496_ = select(_e128, 127i, (_e128 > 127i));
                    }
                    let _e258 = phi_496_;
                    let _e263 = bitcast<f32>((bitcast<u32>((_e258 + 127i)) << bitcast<u32>(23i)));
                    let _e269 = bitcast<f32>((bitcast<u32>(((_e128 - _e258) + 127i)) << bitcast<u32>(23i)));
                    let _e270 = -(_e233);
                    if (_e270 < -126i) {
                        phi_516_ = -126i;
                    } else {
                        phi_516_ = select(_e270, 127i, (_e270 > 127i));
                    }
                    let _e275 = phi_516_;
                    let _e280 = bitcast<f32>((bitcast<u32>((_e275 + 127i)) << bitcast<u32>(23i)));
                    let _e286 = bitcast<f32>((bitcast<u32>(((_e270 - _e275) + 127i)) << bitcast<u32>(23i)));
                    let _e290 = global_3.member[_e138].member;
                    let _e291 = (_e252 == 0u);
                    if _e291 {
                        phi_534_ = _e290[0];
                    } else {
                        phi_534_ = _e290[1];
                    }
                    let _e295 = phi_534_;
                    let _e296 = (_e252 == 2u);
                    if _e296 {
                        phi_540_ = _e290[2];
                    } else {
                        phi_540_ = _e295;
                    }
                    let _e299 = phi_540_;
                    let _e300 = bitcast<u32>(_e299);
                    let _e302 = ((_e300 & 2139095040u) != 0u);
                    let _e316 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e300 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e300 & 2147483648u))), _e299, _e302) * _e263) * select(0.00000011920929f, 1f, _e302)) * _e269);
                    let _e317 = global_3.member[_e138].member_2;
                    if _e291 {
                        phi_580_ = _e317[0];
                    } else {
                        phi_580_ = _e317[1];
                    }
                    let _e321 = phi_580_;
                    if _e296 {
                        phi_586_ = _e317[2];
                    } else {
                        phi_586_ = _e321;
                    }
                    let _e324 = phi_586_;
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
                        phi_659_ = _e290[0];
                    } else {
                        phi_659_ = _e290[1];
                    }
                    let _e362 = phi_659_;
                    let _e363 = (_e251 == 2u);
                    if _e363 {
                        phi_665_ = _e290[2];
                    } else {
                        phi_665_ = _e362;
                    }
                    let _e366 = phi_665_;
                    let _e367 = bitcast<u32>(_e366);
                    let _e369 = ((_e367 & 2139095040u) != 0u);
                    let _e383 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e367 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e367 & 2147483648u))), _e366, _e369) * _e263) * select(0.00000011920929f, 1f, _e369)) * _e269);
                    if _e358 {
                        phi_705_ = _e317[0];
                    } else {
                        phi_705_ = _e317[1];
                    }
                    let _e387 = phi_705_;
                    if _e363 {
                        phi_711_ = _e317[2];
                    } else {
                        phi_711_ = _e387;
                    }
                    let _e390 = phi_711_;
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
                        phi_784_ = _e290[0];
                    } else {
                        phi_784_ = _e290[1];
                    }
                    let _e428 = phi_784_;
                    let _e429 = (_e253 == 2u);
                    if _e429 {
                        phi_790_ = _e290[2];
                    } else {
                        phi_790_ = _e428;
                    }
                    let _e432 = phi_790_;
                    let _e433 = bitcast<u32>(_e432);
                    let _e435 = ((_e433 & 2139095040u) != 0u);
                    let _e449 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e433 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e433 & 2147483648u))), _e432, _e435) * _e263) * select(0.00000011920929f, 1f, _e435)) * _e269);
                    if _e424 {
                        phi_830_ = _e317[0];
                    } else {
                        phi_830_ = _e317[1];
                    }
                    let _e453 = phi_830_;
                    if _e429 {
                        phi_836_ = _e317[2];
                    } else {
                        phi_836_ = _e453;
                    }
                    let _e456 = phi_836_;
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
                            phi_955_ = 255i;
                        } else {
                            phi_955_ = (((_e507 + select(0i, 1i, (_e507 == 0i))) - _e514) + _e494);
                        }
                        let _e522 = phi_955_;
                        let _e532 = (_e522 <= 0i);
                        if _e532 {
                            phi_978_ = u32();
                        } else {
                            if _e511 {
                                phi_977_ = u32();
                            } else {
                                phi_977_ = select(((bitcast<u32>(_e522) << bitcast<u32>(23i)) | ((_e504 << bitcast<u32>(((_e514 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e522 >= 255i));
                            }
                            let _e536 = phi_977_;
                            phi_978_ = _e536;
                        }
                        let _e538 = phi_978_;
                        let _e550 = ((_e210 & 8388607u) | (select(0u, 1u, ((_e210 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e553 = bitcast<i32>((_e210 >> bitcast<u32>(23i)));
                        let _e557 = (_e550 == 0u);
                        let _e560 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e550)), 32u, _e557)) - 8i);
                        if (_e553 == 255i) {
                            phi_1015_ = 255i;
                        } else {
                            phi_1015_ = (((_e553 + select(0i, 1i, (_e553 == 0i))) - _e560) + _e494);
                        }
                        let _e568 = phi_1015_;
                        let _e578 = (_e568 <= 0i);
                        if _e578 {
                            phi_1038_ = u32();
                        } else {
                            if _e557 {
                                phi_1037_ = u32();
                            } else {
                                phi_1037_ = select(((bitcast<u32>(_e568) << bitcast<u32>(23i)) | ((_e550 << bitcast<u32>(((_e560 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e568 >= 255i));
                            }
                            let _e582 = phi_1037_;
                            phi_1038_ = _e582;
                        }
                        let _e584 = phi_1038_;
                        phi_1046_ = bitcast<f32>(((_e209 & 2147483648u) | select(_e584, 0u, select(_e557, true, _e578))));
                        phi_1047_ = bitcast<f32>(((_e200 & 2147483648u) | select(_e538, 0u, select(_e511, true, _e532))));
                    } else {
                        phi_1046_ = 0f;
                        phi_1047_ = 1f;
                    }
                    let _e590 = phi_1046_;
                    let _e592 = phi_1047_;
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
                    let _e596 = (_e252 % 3u);
                    let _e597 = (_e596 < 3u);
                    if _e597 {
                    } else {
                        break;
                    }
                    let _e599 = local_10[_e596];
                    let _e600 = (_e251 % 3u);
                    let _e601 = (_e600 < 3u);
                    if _e601 {
                    } else {
                        break;
                    }
                    let _e603 = local_10[_e600];
                    let _e604 = (_e253 % 3u);
                    let _e605 = (_e604 < 3u);
                    if _e605 {
                    } else {
                        break;
                    }
                    let _e607 = local_10[_e604];
                    local_9 = array<f32, 3>(bitcast<f32>(_e112), bitcast<f32>(_e116), bitcast<f32>(_e120));
                    if _e597 {
                    } else {
                        break;
                    }
                    let _e611 = local_9[_e596];
                    if _e601 {
                    } else {
                        break;
                    }
                    let _e613 = local_9[_e600];
                    if _e605 {
                    } else {
                        break;
                    }
                    let _e615 = local_9[_e604];
                    phi_4122_ = false;
                    phi_4066_ = _e590;
                    phi_1183_ = ((3u * _e89) + 1u);
                    phi_1186_ = (_e592 <= _e590);
                    phi_1188_ = 0u;
                    phi_1190_ = type_53(type_45(array<f32, 3>(_e599, _e603, _e607), array<f32, 3>(_e611, _e613, _e615)), select(0u, 2147483648u, (_e89 == 0u)));
                    loop {
                        let _e623 = phi_4122_;
                        let _e625 = phi_4066_;
                        let _e627 = phi_1183_;
                        let _e629 = phi_1186_;
                        let _e631 = phi_1188_;
                        let _e633 = phi_1190_;
                        if _e629 {
                            phi_1201_ = true;
                        } else {
                            phi_1201_ = (_e631 > 0u);
                        }
                        let _e636 = phi_1201_;
                        if _e636 {
                            let _e637 = (_e627 > 0u);
                            if _e637 {
                                if _e629 {
                                    phi_1288_ = _e629;
                                    phi_1289_ = _e631;
                                    phi_1290_ = _e633;
                                } else {
                                    let _e638 = (_e631 - 1u);
                                    let _e639 = (_e638 % 128u);
                                    let _e640 = (_e639 < 128u);
                                    if _e640 {
                                    } else {
                                        phi_4402_ = true;
                                        break;
                                    }
                                    let _e642 = local_6[_e639];
                                    if _e640 {
                                    } else {
                                        phi_4402_ = true;
                                        break;
                                    }
                                    let _e644 = local_5[_e639];
                                    if _e640 {
                                    } else {
                                        phi_4402_ = true;
                                        break;
                                    }
                                    let _e646 = local_4[_e639];
                                    if _e640 {
                                    } else {
                                        phi_4402_ = true;
                                        break;
                                    }
                                    let _e648 = local_3[_e639];
                                    if _e640 {
                                    } else {
                                        phi_4402_ = true;
                                        break;
                                    }
                                    let _e651 = local_2[_e639];
                                    if _e640 {
                                    } else {
                                        phi_4402_ = true;
                                        break;
                                    }
                                    let _e653 = local_1[_e639];
                                    if _e640 {
                                    } else {
                                        phi_4402_ = true;
                                        break;
                                    }
                                    let _e655 = local[_e639];
                                    if _e640 {
                                    } else {
                                        phi_4402_ = true;
                                        break;
                                    }
                                    let _e660 = local_8[_e639];
                                    phi_1288_ = (_e660 <= _e625);
                                    phi_1289_ = _e638;
                                    phi_1290_ = type_53(type_45(array<f32, 3>(_e644, _e646, _e648), array<f32, 3>(_e651, _e653, _e655)), _e642);
                                }
                                let _e663 = phi_1288_;
                                let _e665 = phi_1289_;
                                let _e667 = phi_1290_;
                                if _e663 {
                                    let _e671 = ((_e667.member_1 & 2147483648u) != 0u);
                                    if _e671 {
                                        phi_4119_ = _e623;
                                        phi_4089_ = _e625;
                                        phi_1309_ = type_4(0u, ((_e667.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e679 = phi_4119_;
                                            let _e681 = phi_4089_;
                                            let _e683 = phi_1309_;
                                            if (_e683.member < _e683.member_1) {
                                                phi_1310_ = type_4((_e683.member + 1u), _e683.member_1);
                                                phi_1333_ = type_4(1u, _e683.member);
                                            } else {
                                                phi_1310_ = _e683;
                                                phi_1333_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e696 = phi_1310_;
                                            let _e698 = phi_1333_;
                                            let _e702 = (bitcast<i32>(_e698.member) != 0i);
                                            if _e702 {
                                                let _e703 = ((_e667.member_1 & 268435455u) + _e698.member_1);
                                                let _e704 = (_e703 < arrayLength((&global_6.member)));
                                                if _e704 {
                                                    if _e704 {
                                                    } else {
                                                        phi_4305_ = _e681;
                                                        phi_4274_ = true;
                                                        break;
                                                    }
                                                    let _e707 = global_6.member[_e703].member_1;
                                                    phi_1358_ = _e707;
                                                } else {
                                                    phi_1358_ = 4294967295u;
                                                }
                                                let _e709 = phi_1358_;
                                                if _e704 {
                                                    if _e704 {
                                                    } else {
                                                        phi_4305_ = _e681;
                                                        phi_4274_ = true;
                                                        break;
                                                    }
                                                    let _e711 = global_6.member[_e703];
                                                    phi_1374_ = _e711;
                                                } else {
                                                    phi_1374_ = type_47(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e713 = phi_1374_;
                                                let _e725 = ((10u * _e252) & 31u);
                                                let _e728 = ((_e713.member[0] >> bitcast<u32>(_e725)) & 1023u);
                                                let _e736 = bitcast<f32>((bitcast<u32>(((_e667.member.member_1[0] - _e667.member.member[0]) * 0.0009775171f)) ^ _e124));
                                                let _e741 = (_e667.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e728)) - 8388608f) * _e736)) ^ _e124)));
                                                let _e745 = select(select(_e667.member.member_1[0], _e741, (_e741 < _e667.member.member_1[0])), _e667.member.member_1[0], (_e728 == 1023u));
                                                let _e747 = ((10u * _e251) & 31u);
                                                let _e750 = ((_e713.member[0] >> bitcast<u32>(_e747)) & 1023u);
                                                let _e758 = bitcast<f32>((bitcast<u32>(((_e667.member.member_1[1] - _e667.member.member[1]) * 0.0009775171f)) ^ _e124));
                                                let _e763 = (_e667.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e750)) - 8388608f) * _e758)) ^ _e124)));
                                                let _e767 = select(select(_e667.member.member_1[1], _e763, (_e763 < _e667.member.member_1[1])), _e667.member.member_1[1], (_e750 == 1023u));
                                                let _e769 = ((10u * _e253) & 31u);
                                                let _e772 = ((_e713.member[0] >> bitcast<u32>(_e769)) & 1023u);
                                                let _e780 = bitcast<f32>((bitcast<u32>(((_e667.member.member_1[2] - _e667.member.member[2]) * 0.0009775171f)) ^ _e124));
                                                let _e785 = (_e667.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e772)) - 8388608f) * _e780)) ^ _e124)));
                                                let _e789 = select(select(_e667.member.member_1[2], _e785, (_e785 < _e667.member.member_1[2])), _e667.member.member_1[2], (_e772 == 1023u));
                                                let _e793 = ((_e713.member[1] >> bitcast<u32>(_e725)) & 1023u);
                                                let _e801 = (_e667.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e793)) - 8388608f) * _e736)) ^ _e124)));
                                                let _e805 = select(select(_e667.member.member_1[0], _e801, (_e801 < _e667.member.member_1[0])), _e667.member.member_1[0], (_e793 == 1023u));
                                                let _e808 = ((_e713.member[1] >> bitcast<u32>(_e747)) & 1023u);
                                                let _e816 = (_e667.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e808)) - 8388608f) * _e758)) ^ _e124)));
                                                let _e820 = select(select(_e667.member.member_1[1], _e816, (_e816 < _e667.member.member_1[1])), _e667.member.member_1[1], (_e808 == 1023u));
                                                let _e823 = ((_e713.member[1] >> bitcast<u32>(_e769)) & 1023u);
                                                let _e831 = (_e667.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e823)) - 8388608f) * _e780)) ^ _e124)));
                                                let _e835 = select(select(_e667.member.member_1[2], _e831, (_e831 < _e667.member.member_1[2])), _e667.member.member_1[2], (_e823 == 1023u));
                                                let _e839 = ((_e713.member[2] >> bitcast<u32>(_e725)) & 1023u);
                                                let _e847 = (_e667.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e839)) - 8388608f) * _e736)) ^ _e124)));
                                                let _e851 = select(select(_e667.member.member_1[0], _e847, (_e847 < _e667.member.member_1[0])), _e667.member.member_1[0], (_e839 == 1023u));
                                                let _e854 = ((_e713.member[2] >> bitcast<u32>(_e747)) & 1023u);
                                                let _e862 = (_e667.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e854)) - 8388608f) * _e758)) ^ _e124)));
                                                let _e866 = select(select(_e667.member.member_1[1], _e862, (_e862 < _e667.member.member_1[1])), _e667.member.member_1[1], (_e854 == 1023u));
                                                let _e869 = ((_e713.member[2] >> bitcast<u32>(_e769)) & 1023u);
                                                let _e877 = (_e667.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e869)) - 8388608f) * _e780)) ^ _e124)));
                                                let _e881 = select(select(_e667.member.member_1[2], _e877, (_e877 < _e667.member.member_1[2])), _e667.member.member_1[2], (_e869 == 1023u));
                                                let _e884 = (_e789 - _e449);
                                                let _e887 = (((_e745 - _e316) * _e485) - (_e884 * _e353));
                                                let _e890 = (((_e767 - _e383) * _e485) - (_e884 * _e419));
                                                let _e893 = (_e835 - _e449);
                                                let _e896 = (((_e805 - _e316) * _e485) - (_e893 * _e353));
                                                let _e899 = (((_e820 - _e383) * _e485) - (_e893 * _e419));
                                                let _e902 = (_e881 - _e449);
                                                let _e905 = (((_e851 - _e316) * _e485) - (_e902 * _e353));
                                                let _e908 = (((_e866 - _e383) * _e485) - (_e902 * _e419));
                                                let _e909 = (_e905 * _e899);
                                                let _e910 = (_e908 * _e896);
                                                let _e911 = (_e887 * _e908);
                                                let _e912 = (_e890 * _e905);
                                                let _e913 = (_e896 * _e890);
                                                let _e914 = (_e899 * _e887);
                                                let _e919 = (((_e909 >= _e910) && (_e911 >= _e912)) && (_e913 >= _e914));
                                                let _e925 = (_e919 || (((_e909 <= _e910) && (_e911 <= _e912)) && (_e913 <= _e914)));
                                                if _e925 {
                                                    let _e927 = select(-1f, 1f, _e919);
                                                    let _e929 = ((_e909 - _e910) * _e927);
                                                    let _e931 = select(0f, _e929, (_e929 > 0f));
                                                    let _e933 = ((_e911 - _e912) * _e927);
                                                    let _e935 = select(0f, _e933, (_e933 > 0f));
                                                    let _e937 = ((_e913 - _e914) * _e927);
                                                    let _e939 = select(0f, _e937, (_e937 > 0f));
                                                    let _e941 = ((_e931 + _e935) + _e939);
                                                    let _e943 = select(_e805, _e745, (_e745 < _e805));
                                                    let _e947 = select(_e805, _e745, (_e745 > _e805));
                                                    let _e951 = select(_e820, _e767, (_e767 < _e820));
                                                    let _e955 = select(_e820, _e767, (_e767 > _e820));
                                                    let _e959 = select(_e835, _e789, (_e789 < _e835));
                                                    let _e963 = select(_e835, _e789, (_e789 > _e835));
                                                    let _e968 = ((select(_e851, _e943, (_e943 < _e851)) - _e354) * _e357);
                                                    let _e969 = ((select(_e851, _e947, (_e947 > _e851)) - _e355) * _e357);
                                                    let _e972 = ((select(_e866, _e951, (_e951 < _e866)) - _e420) * _e423);
                                                    let _e973 = ((select(_e866, _e955, (_e955 > _e866)) - _e421) * _e423);
                                                    let _e976 = ((select(_e881, _e959, (_e959 < _e881)) - _e486) * _e489);
                                                    let _e977 = ((select(_e881, _e963, (_e963 > _e881)) - _e487) * _e489);
                                                    let _e979 = select(_e977, _e976, (_e976 < _e977));
                                                    let _e981 = select(_e977, _e976, (_e976 > _e977));
                                                    let _e983 = select(_e969, _e968, (_e968 < _e969));
                                                    let _e985 = select(_e973, _e972, (_e972 < _e973));
                                                    let _e987 = select(_e985, _e983, (_e983 > _e985));
                                                    let _e989 = select(_e979, _e987, (_e987 > _e979));
                                                    let _e991 = select(_e969, _e968, (_e968 > _e969));
                                                    let _e993 = select(_e973, _e972, (_e972 > _e973));
                                                    let _e995 = select(_e993, _e991, (_e991 < _e993));
                                                    let _e997 = select(_e981, _e995, (_e995 < _e981));
                                                    let _e998 = -(_e979);
                                                    let _e1004 = select(_e592, _e989, (_e989 > _e592));
                                                    let _e1008 = select(_e896, _e887, (_e887 < _e896));
                                                    let _e1013 = select(_e896, _e887, (_e887 > _e896));
                                                    let _e1020 = select(_e899, _e890, (_e890 < _e899));
                                                    let _e1025 = select(_e899, _e890, (_e890 > _e899));
                                                    let _e1034 = (((((_e925 && (_e941 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e905, _e1008, (_e1008 < _e905)) <= 0f) && (select(_e905, _e1013, (_e1013 > _e905)) >= 0f))) && ((select(_e908, _e1020, (_e1020 < _e908)) <= 0f) && (select(_e908, _e1025, (_e1025 > _e908)) >= 0f))) && (_e1004 <= (_e997 + (select(_e998, _e981, (_e981 > _e998)) * 0.0000019073523f)))) && (_e1004 <= _e681));
                                                    if _e1034 {
                                                        let _e1039 = (_e805 - _e745);
                                                        let _e1040 = (_e820 - _e767);
                                                        let _e1041 = (_e835 - _e789);
                                                        let _e1042 = vec3<f32>(_e1039, _e1040, _e1041);
                                                        let _e1043 = (_e851 - _e805);
                                                        let _e1044 = (_e866 - _e820);
                                                        let _e1045 = (_e881 - _e835);
                                                        let _e1046 = vec3<f32>(_e1043, _e1044, _e1045);
                                                        let _e1047 = (_e745 - _e851);
                                                        let _e1048 = (_e767 - _e866);
                                                        let _e1049 = (_e789 - _e881);
                                                        let _e1050 = vec3<f32>(_e1047, _e1048, _e1049);
                                                        let _e1051 = abs(_e1039);
                                                        let _e1052 = abs(_e1040);
                                                        if (_e1051 != _e1051) {
                                                            phi_3782_ = true;
                                                        } else {
                                                            phi_3782_ = (_e1052 >= _e1051);
                                                        }
                                                        let _e1056 = phi_3782_;
                                                        let _e1057 = select(_e1051, _e1052, _e1056);
                                                        let _e1058 = abs(_e1041);
                                                        if (_e1057 != _e1057) {
                                                            phi_3797_ = true;
                                                        } else {
                                                            phi_3797_ = (_e1058 >= _e1057);
                                                        }
                                                        let _e1062 = phi_3797_;
                                                        let _e1063 = select(_e1057, _e1058, _e1062);
                                                        let _e1064 = abs(_e1043);
                                                        let _e1065 = abs(_e1044);
                                                        if (_e1064 != _e1064) {
                                                            phi_3812_ = true;
                                                        } else {
                                                            phi_3812_ = (_e1065 >= _e1064);
                                                        }
                                                        let _e1069 = phi_3812_;
                                                        let _e1070 = select(_e1064, _e1065, _e1069);
                                                        let _e1071 = abs(_e1045);
                                                        if (_e1070 != _e1070) {
                                                            phi_3827_ = true;
                                                        } else {
                                                            phi_3827_ = (_e1071 >= _e1070);
                                                        }
                                                        let _e1075 = phi_3827_;
                                                        let _e1076 = select(_e1070, _e1071, _e1075);
                                                        let _e1077 = abs(_e1047);
                                                        let _e1078 = abs(_e1048);
                                                        if (_e1077 != _e1077) {
                                                            phi_3842_ = true;
                                                        } else {
                                                            phi_3842_ = (_e1078 >= _e1077);
                                                        }
                                                        let _e1082 = phi_3842_;
                                                        let _e1083 = select(_e1077, _e1078, _e1082);
                                                        let _e1084 = abs(_e1049);
                                                        if (_e1083 != _e1083) {
                                                            phi_3857_ = true;
                                                        } else {
                                                            phi_3857_ = (_e1084 >= _e1083);
                                                        }
                                                        let _e1088 = phi_3857_;
                                                        let _e1089 = select(_e1083, _e1084, _e1088);
                                                        let _e1091 = select(_e1076, _e1063, (_e1063 > _e1076));
                                                        let _e1093 = select(_e1089, _e1091, (_e1091 > _e1089));
                                                        if (_e1063 == _e1093) {
                                                            phi_2182_ = _e899;
                                                            phi_2183_ = _e896;
                                                            phi_2184_ = _e890;
                                                            phi_2185_ = _e887;
                                                            phi_2186_ = vec3<f32>(_e745, _e767, _e789);
                                                            phi_2187_ = _e1050;
                                                            phi_2188_ = _e1046;
                                                            phi_2189_ = _e1042;
                                                        } else {
                                                            let _e1095 = (_e1076 == _e1093);
                                                            let _e1100 = vec3(_e1095);
                                                            phi_2182_ = select(_e890, _e908, _e1095);
                                                            phi_2183_ = select(_e887, _e905, _e1095);
                                                            phi_2184_ = select(_e908, _e899, _e1095);
                                                            phi_2185_ = select(_e905, _e896, _e1095);
                                                            phi_2186_ = select(vec3<f32>(_e851, _e866, _e881), vec3<f32>(_e805, _e820, _e835), _e1100);
                                                            phi_2187_ = select(_e1046, _e1042, _e1100);
                                                            phi_2188_ = select(_e1042, _e1050, _e1100);
                                                            phi_2189_ = select(_e1050, _e1046, _e1100);
                                                        }
                                                        let _e1106 = phi_2182_;
                                                        let _e1108 = phi_2183_;
                                                        let _e1110 = phi_2184_;
                                                        let _e1112 = phi_2185_;
                                                        let _e1114 = phi_2186_;
                                                        let _e1116 = phi_2187_;
                                                        let _e1118 = phi_2188_;
                                                        let _e1120 = phi_2189_;
                                                        let _e1127 = ((_e1118.y * _e1116.z) - (_e1116.y * _e1118.z));
                                                        let _e1132 = ((_e1118.z * _e1116.x) - (_e1116.z * _e1118.x));
                                                        let _e1135 = ((_e1118.x * _e1116.y) - (_e1116.x * _e1118.y));
                                                        let _e1138 = ((_e931 >= _e935) && (_e931 >= _e939));
                                                        let _e1139 = (_e935 >= _e939);
                                                        let _e1153 = (((_e1127 * (select(select(_e851, _e805, _e1139), _e745, _e1138) - _e316)) + (_e1132 * (select(select(_e866, _e820, _e1139), _e767, _e1138) - _e383))) + (_e1135 * (select(select(_e881, _e835, _e1139), _e789, _e1138) - _e449)));
                                                        let _e1158 = (((_e1127 * _e353) + (_e1132 * _e419)) + (_e1135 * _e485));
                                                        let _e1159 = (_e1108 - _e1112);
                                                        let _e1160 = (_e1106 - _e1110);
                                                        let _e1163 = ((_e1159 * _e1159) + (_e1160 * _e1160));
                                                        let _e1170 = (-(((_e1112 * _e1159) + (_e1110 * _e1160))) / select(0.000000000000000000000000000000000000011754944f, _e1163, (_e1163 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1172 = select(1f, _e1170, (_e1170 < 1f));
                                                        let _e1174 = select(0f, _e1172, (_e1172 > 0f));
                                                        let _e1183 = ((_e1114.x + (_e1120.x * _e1174)) - _e316);
                                                        let _e1186 = ((_e1114.y + (_e1120.y * _e1174)) - _e383);
                                                        let _e1189 = ((_e1114.z + (_e1120.z * _e1174)) - _e449);
                                                        let _e1192 = bitcast<f32>((bitcast<u32>(_e1183) & 2147483647u));
                                                        let _e1195 = bitcast<f32>((bitcast<u32>(_e1186) & 2147483647u));
                                                        let _e1197 = select(_e1195, _e1192, (_e1192 > _e1195));
                                                        let _e1200 = bitcast<f32>((bitcast<u32>(_e1189) & 2147483647u));
                                                        let _e1202 = select(_e1200, _e1197, (_e1197 > _e1200));
                                                        let _e1206 = abs(_e1127);
                                                        let _e1207 = abs(_e1132);
                                                        if (_e1206 != _e1206) {
                                                            phi_3872_ = true;
                                                        } else {
                                                            phi_3872_ = (_e1207 >= _e1206);
                                                        }
                                                        let _e1211 = phi_3872_;
                                                        let _e1212 = select(_e1206, _e1207, _e1211);
                                                        let _e1213 = abs(_e1135);
                                                        if (_e1212 != _e1212) {
                                                            phi_3887_ = true;
                                                        } else {
                                                            phi_3887_ = (_e1213 >= _e1212);
                                                        }
                                                        let _e1217 = phi_3887_;
                                                        let _e1233 = abs(_e1118.x);
                                                        let _e1234 = abs(_e1118.y);
                                                        if (_e1233 != _e1233) {
                                                            phi_3902_ = true;
                                                        } else {
                                                            phi_3902_ = (_e1234 >= _e1233);
                                                        }
                                                        let _e1238 = phi_3902_;
                                                        let _e1239 = select(_e1233, _e1234, _e1238);
                                                        let _e1240 = abs(_e1118.z);
                                                        if (_e1239 != _e1239) {
                                                            phi_3917_ = true;
                                                        } else {
                                                            phi_3917_ = (_e1240 >= _e1239);
                                                        }
                                                        let _e1244 = phi_3917_;
                                                        let _e1247 = abs(_e1116.x);
                                                        let _e1248 = abs(_e1116.y);
                                                        if (_e1247 != _e1247) {
                                                            phi_3932_ = true;
                                                        } else {
                                                            phi_3932_ = (_e1248 >= _e1247);
                                                        }
                                                        let _e1252 = phi_3932_;
                                                        let _e1253 = select(_e1247, _e1248, _e1252);
                                                        let _e1254 = abs(_e1116.z);
                                                        if (_e1253 != _e1253) {
                                                            phi_3947_ = true;
                                                        } else {
                                                            phi_3947_ = (_e1254 >= _e1253);
                                                        }
                                                        let _e1258 = phi_3947_;
                                                        let _e1263 = ((bitcast<f32>((bitcast<u32>(((((_e1127 * _e1183) + (_e1132 * _e1186)) + (_e1135 * _e1189)) - _e1153)) & 2147483647u)) <= ((0.0000009536743f * select(_e1093, _e1202, (_e1202 > _e1093))) * select(_e1212, _e1213, _e1217))) && !((bitcast<f32>((bitcast<u32>(_e1158) & 2147483647u)) <= ((0.0000038146973f * select(_e1239, _e1240, _e1244)) * select(_e1253, _e1254, _e1258)))));
                                                        let _e1264 = (_e1153 / _e1158);
                                                        if (_e1034 && !(_e1263)) {
                                                            let _e1267 = (_e1189 / _e485);
                                                            let _e1275 = (((_e1127 * (_e1183 - (_e353 * _e1267))) + (_e1132 * (_e1186 - (_e419 * _e1267)))) / _e1158);
                                                            phi_2397_ = select(select(_e1267, (_e1267 + _e1275), (bitcast<f32>((bitcast<u32>(_e1275) & 2147483647u)) <= _e1093)), _e1264, _e1263);
                                                        } else {
                                                            phi_2397_ = _e1264;
                                                        }
                                                        let _e1284 = phi_2397_;
                                                        let _e1286 = select(_e997, _e1284, (_e1284 < _e997));
                                                        let _e1288 = select(_e989, _e1286, (_e1286 > _e989));
                                                        let _e1289 = (1f / _e941);
                                                        phi_2417_ = type_26(_e1288, (_e935 * _e1289), (_e939 * _e1289), ((_e1034 && (_e1288 >= _e592)) && (_e1288 <= _e681)));
                                                        phi_2418_ = type_26();
                                                    } else {
                                                        phi_2417_ = type_26();
                                                        phi_2418_ = type_26(0f, 0f, 0f, _e1034);
                                                    }
                                                    let _e1298 = phi_2417_;
                                                    let _e1300 = phi_2418_;
                                                    phi_2421_ = _e1298;
                                                    phi_2422_ = _e1300;
                                                    phi_2423_ = select(true, false, _e1034);
                                                } else {
                                                    phi_2421_ = type_26();
                                                    phi_2422_ = type_26(0f, 0f, 0f, _e925);
                                                    phi_2423_ = true;
                                                }
                                                let _e1303 = phi_2421_;
                                                let _e1305 = phi_2422_;
                                                let _e1307 = phi_2423_;
                                                if _e1307 {
                                                    phi_2427_ = _e1305;
                                                } else {
                                                    phi_2427_ = _e1303;
                                                }
                                                let _e1309 = phi_2427_;
                                                if _e1309.member_3 {
                                                    phi_2436_ = type_18(_e1309.member, _e1309.member_1, _e1309.member_2, _e709);
                                                } else {
                                                    phi_2436_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1316 = phi_2436_;
                                                if (_e1316.member_3 != 4294967295u) {
                                                    if (_e709 != 4294967295u) {
                                                        phi_2448_ = type_4(0u, 8u);
                                                        phi_2451_ = _e1316;
                                                        loop {
                                                            let _e1321 = phi_2448_;
                                                            let _e1323 = phi_2451_;
                                                            if (_e1321.member < _e1321.member_1) {
                                                                phi_2449_ = type_4((_e1321.member + 1u), _e1321.member_1);
                                                                phi_2474_ = type_4(1u, _e1321.member);
                                                            } else {
                                                                phi_2449_ = _e1321;
                                                                phi_2474_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1336 = phi_2449_;
                                                            let _e1338 = phi_2474_;
                                                            let _e1342 = (bitcast<i32>(_e1338.member) != 0i);
                                                            if _e1342 {
                                                                let _e1343 = (_e1338.member_1 < 8u);
                                                                if _e1343 {
                                                                } else {
                                                                    phi_4091_ = true;
                                                                    break;
                                                                }
                                                                let _e1348 = local_7[_e1338.member_1].member;
                                                                if (_e1323.member < _e1348) {
                                                                    phi_2507_ = true;
                                                                } else {
                                                                    let _e1350 = local_7[_e1338.member_1].member;
                                                                    if (_e1323.member == _e1350) {
                                                                        let _e1355 = local_7[_e1338.member_1].member_3;
                                                                        phi_2506_ = (_e1323.member_3 < _e1355);
                                                                    } else {
                                                                        phi_2506_ = false;
                                                                    }
                                                                    let _e1358 = phi_2506_;
                                                                    phi_2507_ = _e1358;
                                                                }
                                                                let _e1360 = phi_2507_;
                                                                if _e1360 {
                                                                    if _e1343 {
                                                                    } else {
                                                                        phi_4091_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1361 = local_7[_e1338.member_1];
                                                                    local_7[_e1338.member_1] = type_18(_e1323.member, _e1323.member_1, _e1323.member_2, _e1323.member_3);
                                                                    phi_2528_ = type_18(_e1361.member, _e1361.member_1, _e1361.member_2, _e1361.member_3);
                                                                } else {
                                                                    phi_2528_ = _e1323;
                                                                }
                                                                let _e1372 = phi_2528_;
                                                                phi_2452_ = _e1372;
                                                            } else {
                                                                phi_2452_ = type_18();
                                                            }
                                                            let _e1374 = phi_2452_;
                                                            continue;
                                                            continuing {
                                                                phi_2448_ = _e1336;
                                                                phi_2451_ = _e1374;
                                                                phi_4091_ = _e679;
                                                                break if !(_e1342);
                                                            }
                                                        }
                                                        let _e1377 = phi_4091_;
                                                        phi_4305_ = _e681;
                                                        phi_4274_ = _e1377;
                                                        if _e1377 {
                                                            break;
                                                        }
                                                        let _e1380 = local_7[7u].member_3;
                                                        if (_e1380 != 4294967295u) {
                                                            let _e1384 = local_7[7u].member;
                                                            phi_4401_ = _e1384;
                                                        } else {
                                                            phi_4401_ = _e681;
                                                        }
                                                        let _e1386 = phi_4401_;
                                                        phi_4400_ = _e1386;
                                                        phi_4277_ = _e1377;
                                                    } else {
                                                        phi_4400_ = _e681;
                                                        phi_4277_ = _e679;
                                                    }
                                                    let _e1388 = phi_4400_;
                                                    let _e1390 = phi_4277_;
                                                    phi_4399_ = _e1388;
                                                    phi_4276_ = _e1390;
                                                } else {
                                                    phi_4399_ = _e681;
                                                    phi_4276_ = _e679;
                                                }
                                                let _e1392 = phi_4399_;
                                                let _e1394 = phi_4276_;
                                                phi_4398_ = _e1392;
                                                phi_4275_ = _e1394;
                                            } else {
                                                phi_4398_ = _e681;
                                                phi_4275_ = _e679;
                                            }
                                            let _e1396 = phi_4398_;
                                            let _e1398 = phi_4275_;
                                            continue;
                                            continuing {
                                                phi_4119_ = _e1398;
                                                phi_4089_ = _e1396;
                                                phi_1309_ = _e696;
                                                phi_4305_ = _e1396;
                                                phi_4274_ = _e1398;
                                                break if !(_e702);
                                            }
                                        }
                                        let _e1401 = phi_4305_;
                                        let _e1403 = phi_4274_;
                                        phi_4402_ = _e1403;
                                        if _e1403 {
                                            break;
                                        }
                                        phi_4461_ = _e1403;
                                        phi_4304_ = _e1401;
                                    } else {
                                        phi_4461_ = _e623;
                                        phi_4304_ = _e625;
                                    }
                                    let _e1405 = phi_4461_;
                                    let _e1407 = phi_4304_;
                                    if _e671 {
                                        phi_3547_ = bool();
                                        phi_3548_ = u32();
                                        phi_3549_ = type_53();
                                    } else {
                                        let _e1408 = (_e667.member_1 < _e89);
                                        if _e1408 {
                                            if _e1408 {
                                            } else {
                                                phi_4402_ = true;
                                                break;
                                            }
                                            let _e1410 = global_4.member[_e667.member_1];
                                            phi_2560_ = _e1410;
                                        } else {
                                            phi_2560_ = type_40(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e1412 = phi_2560_;
                                        let _e1427 = ((10u * _e252) & 31u);
                                        let _e1430 = ((_e1412.member[0] >> bitcast<u32>(_e1427)) & 1023u);
                                        let _e1438 = bitcast<f32>((bitcast<u32>(((_e667.member.member_1[0] - _e667.member.member[0]) * 0.0009775171f)) ^ _e124));
                                        let _e1443 = (_e667.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1430)) - 8388608f) * _e1438)) ^ _e124)));
                                        let _e1447 = select(select(_e667.member.member_1[0], _e1443, (_e1443 < _e667.member.member_1[0])), _e667.member.member_1[0], (_e1430 == 1023u));
                                        let _e1449 = ((10u * _e251) & 31u);
                                        let _e1452 = ((_e1412.member[0] >> bitcast<u32>(_e1449)) & 1023u);
                                        let _e1460 = bitcast<f32>((bitcast<u32>(((_e667.member.member_1[1] - _e667.member.member[1]) * 0.0009775171f)) ^ _e124));
                                        let _e1465 = (_e667.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1452)) - 8388608f) * _e1460)) ^ _e124)));
                                        let _e1469 = select(select(_e667.member.member_1[1], _e1465, (_e1465 < _e667.member.member_1[1])), _e667.member.member_1[1], (_e1452 == 1023u));
                                        let _e1471 = ((10u * _e253) & 31u);
                                        let _e1474 = ((_e1412.member[0] >> bitcast<u32>(_e1471)) & 1023u);
                                        let _e1482 = bitcast<f32>((bitcast<u32>(((_e667.member.member_1[2] - _e667.member.member[2]) * 0.0009775171f)) ^ _e124));
                                        let _e1487 = (_e667.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1474)) - 8388608f) * _e1482)) ^ _e124)));
                                        let _e1491 = select(select(_e667.member.member_1[2], _e1487, (_e1487 < _e667.member.member_1[2])), _e667.member.member_1[2], (_e1474 == 1023u));
                                        let _e1494 = ((_e1412.member[1] >> bitcast<u32>(_e1427)) & 1023u);
                                        let _e1502 = (_e667.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1494)) - 8388608f) * _e1438)) ^ _e124)));
                                        let _e1506 = select(select(_e667.member.member_1[0], _e1502, (_e1502 < _e667.member.member_1[0])), _e667.member.member_1[0], (_e1494 == 1023u));
                                        let _e1509 = ((_e1412.member[1] >> bitcast<u32>(_e1449)) & 1023u);
                                        let _e1517 = (_e667.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1509)) - 8388608f) * _e1460)) ^ _e124)));
                                        let _e1521 = select(select(_e667.member.member_1[1], _e1517, (_e1517 < _e667.member.member_1[1])), _e667.member.member_1[1], (_e1509 == 1023u));
                                        let _e1524 = ((_e1412.member[1] >> bitcast<u32>(_e1471)) & 1023u);
                                        let _e1532 = (_e667.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1524)) - 8388608f) * _e1482)) ^ _e124)));
                                        let _e1536 = select(select(_e667.member.member_1[2], _e1532, (_e1532 < _e667.member.member_1[2])), _e667.member.member_1[2], (_e1524 == 1023u));
                                        let _e1542 = ((_e1412.member_1[0] >> bitcast<u32>(_e1427)) & 1023u);
                                        let _e1550 = (_e667.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1542)) - 8388608f) * _e1438)) ^ _e124)));
                                        let _e1554 = select(select(_e667.member.member_1[0], _e1550, (_e1550 < _e667.member.member_1[0])), _e667.member.member_1[0], (_e1542 == 1023u));
                                        let _e1557 = ((_e1412.member_1[0] >> bitcast<u32>(_e1449)) & 1023u);
                                        let _e1565 = (_e667.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1557)) - 8388608f) * _e1460)) ^ _e124)));
                                        let _e1569 = select(select(_e667.member.member_1[1], _e1565, (_e1565 < _e667.member.member_1[1])), _e667.member.member_1[1], (_e1557 == 1023u));
                                        let _e1572 = ((_e1412.member_1[0] >> bitcast<u32>(_e1471)) & 1023u);
                                        let _e1580 = (_e667.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1572)) - 8388608f) * _e1482)) ^ _e124)));
                                        let _e1584 = select(select(_e667.member.member_1[2], _e1580, (_e1580 < _e667.member.member_1[2])), _e667.member.member_1[2], (_e1572 == 1023u));
                                        let _e1587 = ((_e1412.member_1[1] >> bitcast<u32>(_e1427)) & 1023u);
                                        let _e1595 = (_e667.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1587)) - 8388608f) * _e1438)) ^ _e124)));
                                        let _e1599 = select(select(_e667.member.member_1[0], _e1595, (_e1595 < _e667.member.member_1[0])), _e667.member.member_1[0], (_e1587 == 1023u));
                                        let _e1602 = ((_e1412.member_1[1] >> bitcast<u32>(_e1449)) & 1023u);
                                        let _e1610 = (_e667.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1602)) - 8388608f) * _e1460)) ^ _e124)));
                                        let _e1614 = select(select(_e667.member.member_1[1], _e1610, (_e1610 < _e667.member.member_1[1])), _e667.member.member_1[1], (_e1602 == 1023u));
                                        let _e1617 = ((_e1412.member_1[1] >> bitcast<u32>(_e1471)) & 1023u);
                                        let _e1625 = (_e667.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1617)) - 8388608f) * _e1482)) ^ _e124)));
                                        let _e1629 = select(select(_e667.member.member_1[2], _e1625, (_e1625 < _e667.member.member_1[2])), _e667.member.member_1[2], (_e1617 == 1023u));
                                        let _e1634 = type_53(type_45(array<f32, 3>(_e1447, _e1469, _e1491), array<f32, 3>(_e1506, _e1521, _e1536)), _e1412.member_2);
                                        let _e1639 = type_53(type_45(array<f32, 3>(_e1554, _e1569, _e1584), array<f32, 3>(_e1599, _e1614, _e1629)), _e1412.member_3);
                                        let _e1644 = ((_e1447 - _e354) * _e357);
                                        let _e1645 = ((_e1554 - _e354) * _e357);
                                        let _e1646 = ((_e1506 - _e355) * _e357);
                                        let _e1647 = ((_e1599 - _e355) * _e357);
                                        let _e1652 = ((_e1469 - _e420) * _e423);
                                        let _e1653 = ((_e1569 - _e420) * _e423);
                                        let _e1654 = ((_e1521 - _e421) * _e423);
                                        let _e1655 = ((_e1614 - _e421) * _e423);
                                        let _e1660 = ((_e1491 - _e486) * _e489);
                                        let _e1661 = ((_e1584 - _e486) * _e489);
                                        let _e1662 = ((_e1536 - _e487) * _e489);
                                        let _e1663 = ((_e1629 - _e487) * _e489);
                                        let _e1665 = select(_e1662, _e1660, (_e1660 < _e1662));
                                        let _e1667 = select(_e1663, _e1661, (_e1661 < _e1663));
                                        let _e1669 = select(_e1662, _e1660, (_e1660 > _e1662));
                                        let _e1671 = select(_e1663, _e1661, (_e1661 > _e1663));
                                        let _e1673 = select(_e1646, _e1644, (_e1644 < _e1646));
                                        let _e1675 = select(_e1647, _e1645, (_e1645 < _e1647));
                                        let _e1677 = select(_e1654, _e1652, (_e1652 < _e1654));
                                        let _e1679 = select(_e1655, _e1653, (_e1653 < _e1655));
                                        let _e1681 = select(_e1677, _e1673, (_e1673 > _e1677));
                                        let _e1683 = select(_e1679, _e1675, (_e1675 > _e1679));
                                        let _e1685 = select(_e1665, _e1681, (_e1681 > _e1665));
                                        let _e1687 = select(_e1667, _e1683, (_e1683 > _e1667));
                                        let _e1689 = select(_e1646, _e1644, (_e1644 > _e1646));
                                        let _e1691 = select(_e1647, _e1645, (_e1645 > _e1647));
                                        let _e1693 = select(_e1654, _e1652, (_e1652 > _e1654));
                                        let _e1695 = select(_e1655, _e1653, (_e1653 > _e1655));
                                        let _e1697 = select(_e1693, _e1689, (_e1689 < _e1693));
                                        let _e1699 = select(_e1695, _e1691, (_e1691 < _e1695));
                                        let _e1704 = -(_e1665);
                                        let _e1705 = -(_e1667);
                                        let _e1712 = (select(_e1669, _e1697, (_e1697 < _e1669)) + (select(_e1704, _e1669, (_e1669 > _e1704)) * 0.0000019073523f));
                                        let _e1713 = (select(_e1671, _e1699, (_e1699 < _e1671)) + (select(_e1705, _e1671, (_e1671 > _e1705)) * 0.0000019073523f));
                                        let _e1715 = select(_e592, _e1685, (_e1685 > _e592));
                                        let _e1717 = select(_e592, _e1687, (_e1687 > _e592));
                                        let _e1722 = (_e1715 <= select(_e1407, _e1712, (_e1712 < _e1407)));
                                        let _e1723 = (_e1717 <= select(_e1407, _e1713, (_e1713 < _e1407)));
                                        let _e1724 = (_e1715 <= _e1717);
                                        if _e1722 {
                                            if _e1723 {
                                                if _e1724 {
                                                    phi_3447_ = _e1639;
                                                } else {
                                                    phi_3447_ = _e1634;
                                                }
                                                let _e1726 = phi_3447_;
                                                let _e1733 = (_e665 % 128u);
                                                let _e1734 = (_e1733 < 128u);
                                                if _e1734 {
                                                } else {
                                                    phi_4402_ = true;
                                                    break;
                                                }
                                                local_6[_e1733] = _e1726.member_1;
                                                if _e1734 {
                                                } else {
                                                    phi_4402_ = true;
                                                    break;
                                                }
                                                local_5[_e1733] = _e1726.member.member[0];
                                                if _e1734 {
                                                } else {
                                                    phi_4402_ = true;
                                                    break;
                                                }
                                                local_4[_e1733] = _e1726.member.member[1];
                                                if _e1734 {
                                                } else {
                                                    phi_4402_ = true;
                                                    break;
                                                }
                                                local_3[_e1733] = _e1726.member.member[2];
                                                if _e1734 {
                                                } else {
                                                    phi_4402_ = true;
                                                    break;
                                                }
                                                local_2[_e1733] = _e1726.member.member_1[0];
                                                if _e1734 {
                                                } else {
                                                    phi_4402_ = true;
                                                    break;
                                                }
                                                local_1[_e1733] = _e1726.member.member_1[1];
                                                if _e1734 {
                                                } else {
                                                    phi_4402_ = true;
                                                    break;
                                                }
                                                local[_e1733] = _e1726.member.member_1[2];
                                                if _e1734 {
                                                } else {
                                                    phi_4402_ = true;
                                                    break;
                                                }
                                                local_8[_e1733] = select(_e1715, _e1717, _e1724);
                                                if _e1724 {
                                                    phi_3523_ = _e1634;
                                                } else {
                                                    phi_3523_ = _e1639;
                                                }
                                                let _e1751 = phi_3523_;
                                                phi_3524_ = (_e665 + 1u);
                                                phi_3525_ = _e1751;
                                            } else {
                                                phi_3524_ = u32();
                                                phi_3525_ = type_53();
                                            }
                                            let _e1753 = phi_3524_;
                                            let _e1755 = phi_3525_;
                                            phi_3527_ = _e1753;
                                            phi_3528_ = _e1755;
                                            phi_3529_ = select(true, false, _e1723);
                                        } else {
                                            phi_3527_ = u32();
                                            phi_3528_ = type_53();
                                            phi_3529_ = true;
                                        }
                                        let _e1758 = phi_3527_;
                                        let _e1760 = phi_3528_;
                                        let _e1762 = phi_3529_;
                                        if _e1762 {
                                            if _e1722 {
                                                phi_3536_ = _e1634;
                                            } else {
                                                phi_3536_ = _e1639;
                                            }
                                            let _e1764 = phi_3536_;
                                            phi_3541_ = select(_e1723, true, _e1722);
                                            phi_3543_ = _e1764;
                                        } else {
                                            phi_3541_ = _e663;
                                            phi_3543_ = _e1760;
                                        }
                                        let _e1767 = phi_3541_;
                                        let _e1769 = phi_3543_;
                                        phi_3547_ = _e1767;
                                        phi_3548_ = select(_e1758, _e665, _e1762);
                                        phi_3549_ = _e1769;
                                    }
                                    let _e1772 = phi_3547_;
                                    let _e1774 = phi_3548_;
                                    let _e1776 = phi_3549_;
                                    if _e671 {
                                        phi_3559_ = _e667;
                                    } else {
                                        phi_3559_ = _e1776;
                                    }
                                    let _e1778 = phi_3559_;
                                    phi_4488_ = _e1407;
                                    phi_4405_ = _e1405;
                                    phi_3560_ = (_e627 - 1u);
                                    phi_3561_ = select(_e1772, false, _e671);
                                    phi_3562_ = select(_e1774, _e665, _e671);
                                    phi_3563_ = _e1778;
                                } else {
                                    phi_4488_ = _e625;
                                    phi_4405_ = _e623;
                                    phi_3560_ = _e627;
                                    phi_3561_ = _e663;
                                    phi_3562_ = _e665;
                                    phi_3563_ = _e667;
                                }
                                let _e1782 = phi_4488_;
                                let _e1784 = phi_4405_;
                                let _e1786 = phi_3560_;
                                let _e1788 = phi_3561_;
                                let _e1790 = phi_3562_;
                                let _e1792 = phi_3563_;
                                phi_4487_ = _e1782;
                                phi_4404_ = _e1784;
                                phi_3564_ = _e1786;
                                phi_3565_ = _e1788;
                                phi_3566_ = _e1790;
                                phi_3567_ = _e1792;
                            } else {
                                phi_4487_ = _e625;
                                phi_4404_ = _e623;
                                phi_3564_ = u32();
                                phi_3565_ = bool();
                                phi_3566_ = u32();
                                phi_3567_ = type_53();
                            }
                            let _e1794 = phi_4487_;
                            let _e1796 = phi_4404_;
                            let _e1798 = phi_3564_;
                            let _e1800 = phi_3565_;
                            let _e1802 = phi_3566_;
                            let _e1804 = phi_3567_;
                            phi_4486_ = _e1794;
                            phi_4403_ = _e1796;
                            phi_1184_ = _e1798;
                            phi_1187_ = _e1800;
                            phi_1189_ = _e1802;
                            phi_1191_ = _e1804;
                            phi_3568_ = _e637;
                        } else {
                            phi_4486_ = _e625;
                            phi_4403_ = _e623;
                            phi_1184_ = u32();
                            phi_1187_ = bool();
                            phi_1189_ = u32();
                            phi_1191_ = type_53();
                            phi_3568_ = false;
                        }
                        let _e1806 = phi_4486_;
                        let _e1808 = phi_4403_;
                        let _e1810 = phi_1184_;
                        let _e1812 = phi_1187_;
                        let _e1814 = phi_1189_;
                        let _e1816 = phi_1191_;
                        let _e1818 = phi_3568_;
                        continue;
                        continuing {
                            phi_4122_ = _e1808;
                            phi_4066_ = _e1806;
                            phi_1183_ = _e1810;
                            phi_1186_ = _e1812;
                            phi_1188_ = _e1814;
                            phi_1190_ = _e1816;
                            phi_4402_ = _e1808;
                            break if !(_e1818);
                        }
                    }
                    let _e1821 = phi_4402_;
                    if _e1821 {
                        break;
                    }
                    phi_3575_ = type_4(0u, 8u);
                    loop {
                        let _e1823 = phi_3575_;
                        if (_e1823.member < _e1823.member_1) {
                            phi_3576_ = type_4((_e1823.member + 1u), _e1823.member_1);
                            phi_3599_ = type_4(1u, _e1823.member);
                        } else {
                            phi_3576_ = _e1823;
                            phi_3599_ = type_4(0u, type_4().member_1);
                        }
                        let _e1836 = phi_3576_;
                        let _e1838 = phi_3599_;
                        let _e1842 = (bitcast<i32>(_e1838.member) != 0i);
                        if _e1842 {
                            let _e1843 = (_e1838.member_1 < 8u);
                            if _e1843 {
                            } else {
                                phi_4468_ = true;
                                break;
                            }
                            let _e1845 = local_7[_e1838.member_1];
                            if (_e1845.member_3 != 4294967295u) {
                                let _e1851 = -(_e494);
                                let _e1852 = bitcast<u32>(_e1845.member);
                                let _e1856 = (bitcast<i32>((_e1852 >> bitcast<u32>(23i))) & 255i);
                                let _e1857 = (_e1856 + _e1851);
                                if (_e1856 == 255i) {
                                    phi_3672_ = _e1845.member;
                                } else {
                                    if (_e1856 > 0i) {
                                        if (_e1857 > 0i) {
                                            let _e1861 = (_e1857 < 255i);
                                            if _e1861 {
                                                phi_3651_ = bitcast<f32>((_e1852 + bitcast<u32>((_e1851 << bitcast<u32>(23i)))));
                                            } else {
                                                phi_3651_ = f32();
                                            }
                                            let _e1868 = phi_3651_;
                                            phi_3653_ = _e1868;
                                            phi_3654_ = select(true, false, _e1861);
                                        } else {
                                            phi_3653_ = f32();
                                            phi_3654_ = true;
                                        }
                                        let _e1871 = phi_3653_;
                                        let _e1873 = phi_3654_;
                                        phi_3655_ = _e1871;
                                        phi_3656_ = _e1873;
                                    } else {
                                        phi_3655_ = f32();
                                        phi_3656_ = true;
                                    }
                                    let _e1875 = phi_3655_;
                                    let _e1877 = phi_3656_;
                                    if _e1877 {
                                        let _e1878 = (_e1852 & 2147483648u);
                                        let _e1885 = ((_e1852 & 8388607u) | (select(0u, 1u, ((_e1852 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                        let _e1889 = (_e1885 == 0u);
                                        if _e1889 {
                                            phi_4025_ = bitcast<f32>(_e1878);
                                        } else {
                                            let _e1894 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1885)), 32u, _e1889) - 8u);
                                            let _e1897 = (_e1885 << bitcast<u32>((_e1894 & 31u)));
                                            let _e1899 = ((_e1857 + select(0i, 1i, (_e1856 == 0i))) - bitcast<i32>(_e1894));
                                            if (_e1899 >= 255i) {
                                                phi_4015_ = bitcast<f32>((_e1878 | 2139095040u));
                                                phi_4016_ = f32();
                                                phi_4017_ = true;
                                            } else {
                                                let _e1901 = (_e1899 > 0i);
                                                if _e1901 {
                                                    phi_4009_ = bitcast<f32>(((_e1878 | (bitcast<u32>(_e1899) << bitcast<u32>(23i))) | (_e1897 & 8388607u)));
                                                    phi_4010_ = f32();
                                                } else {
                                                    if (_e1899 < -24i) {
                                                        phi_3975_ = 26u;
                                                    } else {
                                                        phi_3975_ = bitcast<u32>((1i - _e1899));
                                                    }
                                                    let _e1906 = phi_3975_;
                                                    let _e1907 = (_e1906 & 31u);
                                                    let _e1909 = (_e1897 >> bitcast<u32>(_e1907));
                                                    let _e1913 = (_e1897 & ((1u << bitcast<u32>(_e1907)) - 1u));
                                                    let _e1917 = (1u << bitcast<u32>(((_e1906 - 1u) & 31u)));
                                                    if (_e1913 > _e1917) {
                                                        phi_3996_ = true;
                                                    } else {
                                                        if (_e1913 == _e1917) {
                                                            phi_3993_ = ((_e1909 & 1u) == 1u);
                                                        } else {
                                                            phi_3993_ = false;
                                                        }
                                                        let _e1923 = phi_3993_;
                                                        phi_3996_ = _e1923;
                                                    }
                                                    let _e1925 = phi_3996_;
                                                    phi_4009_ = f32();
                                                    phi_4010_ = bitcast<f32>((_e1878 | (_e1909 + select(0u, 1u, _e1925))));
                                                }
                                                let _e1938 = phi_4009_;
                                                let _e1940 = phi_4010_;
                                                phi_4015_ = _e1938;
                                                phi_4016_ = _e1940;
                                                phi_4017_ = _e1901;
                                            }
                                            let _e1944 = phi_4015_;
                                            let _e1946 = phi_4016_;
                                            let _e1948 = phi_4017_;
                                            phi_4025_ = select(_e1946, _e1944, _e1948);
                                        }
                                        let _e1952 = phi_4025_;
                                        phi_3671_ = _e1952;
                                    } else {
                                        phi_3671_ = _e1875;
                                    }
                                    let _e1954 = phi_3671_;
                                    phi_3672_ = _e1954;
                                }
                                let _e1956 = phi_3672_;
                                let _e1957 = bitcast<u32>(_e1956);
                                if ((_e1957 & 2147483647u) >= 2139095040u) {
                                    phi_3684_ = bitcast<f32>(((_e1957 & 2147483648u) | 2139095039u));
                                } else {
                                    phi_3684_ = _e1956;
                                }
                                let _e1964 = phi_3684_;
                                phi_3689_ = type_18(_e1964, _e1845.member_1, _e1845.member_2, _e1845.member_3);
                            } else {
                                phi_3689_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1967 = phi_3689_;
                            if _e1843 {
                            } else {
                                phi_4468_ = true;
                                break;
                            }
                            local_7[_e1838.member_1] = type_18(_e1967.member, _e1967.member_1, _e1967.member_2, _e1967.member_3);
                        }
                        continue;
                        continuing {
                            phi_3575_ = _e1836;
                            phi_4468_ = _e1821;
                            break if !(_e1842);
                        }
                    }
                    let _e1975 = phi_4468_;
                    if _e1975 {
                        break;
                    }
                    let _e1976 = local_7;
                    if _e140 {
                    } else {
                        break;
                    }
                    global_5.member[_e138] = array<type_18, 8>(type_18(_e1976[0].member, _e1976[0].member_1, _e1976[0].member_2, _e1976[0].member_3), type_18(_e1976[1].member, _e1976[1].member_1, _e1976[1].member_2, _e1976[1].member_3), type_18(_e1976[2].member, _e1976[2].member_1, _e1976[2].member_2, _e1976[2].member_3), type_18(_e1976[3].member, _e1976[3].member_1, _e1976[3].member_2, _e1976[3].member_3), type_18(_e1976[4].member, _e1976[4].member_1, _e1976[4].member_2, _e1976[4].member_3), type_18(_e1976[5].member, _e1976[5].member_1, _e1976[5].member_2, _e1976[5].member_3), type_18(_e1976[6].member, _e1976[6].member_1, _e1976[6].member_2, _e1976[6].member_3), type_18(_e1976[7].member, _e1976[7].member_1, _e1976[7].member_2, _e1976[7].member_3));
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
