struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_13 {
    member: array<array<u32, 4>>,
}

struct type_16 {
    member: vec4<u32>,
}

struct type_22 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_24 {
    member: array<type_22>,
}

struct type_30 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_31 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_32 {
    member: type_31,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_34 {
    member: array<type_32>,
}

struct type_39 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_40 {
    member: type_31,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_42 {
    member: array<type_40>,
}

struct type_45 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_51 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_52 {
    member: f32,
    member_1: bool,
}

struct type_54 {
    member: array<vec4<u32>, 2>,
}

struct type_57 {
    member: array<i32>,
}

struct type_64 {
    member: type_39,
    member_1: u32,
}

struct type_65 {
    member: array<vec4<f32>, 3>,
    member_1: type_64,
    member_2: type_64,
}

struct type_70 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_34;
@group(0) @binding(1) 
var<uniform> global_3: type_54;
@group(0) @binding(2) 
var<uniform> global_4: type_54;
@group(0) @binding(3) 
var<storage> global_5: type_13;
@group(0) @binding(4) 
var<storage> global_6: type_24;
@group(0) @binding(5) 
var<storage> global_7: type_4;
@group(0) @binding(6) 
var<storage> global_8: type_57;
@group(0) @binding(9) 
var<storage, read_write> global_9: type_70;
@group(0) @binding(7) 
var<storage> global_10: type_42;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<f32, 128>;
    var local_7: array<f32, 128>;
    var local_8: array<u32, 128>;
    var local_9: array<f32, 128>;
    var phi_363_: u32;
    var phi_407_: i32;
    var phi_547_: type_45;
    var phi_697_: i32;
    var phi_698_: i32;
    var phi_708_: bool;
    var phi_718_: u32;
    var phi_719_: u32;
    var phi_721_: bool;
    var phi_726_: u32;
    var phi_759_: i32;
    var phi_777_: f32;
    var phi_783_: f32;
    var phi_823_: f32;
    var phi_829_: f32;
    var phi_902_: f32;
    var phi_908_: f32;
    var phi_948_: f32;
    var phi_954_: f32;
    var phi_1027_: f32;
    var phi_1033_: f32;
    var phi_1073_: f32;
    var phi_1079_: f32;
    var phi_1198_: i32;
    var phi_1220_: u32;
    var phi_1221_: u32;
    var phi_1258_: i32;
    var phi_1280_: u32;
    var phi_1281_: u32;
    var phi_1289_: f32;
    var phi_1290_: f32;
    var phi_4402_: bool;
    var phi_1386_: type_52;
    var phi_1389_: bool;
    var phi_1391_: type_64;
    var phi_1393_: u32;
    var phi_1395_: u32;
    var phi_1406_: bool;
    var phi_1492_: bool;
    var phi_1493_: type_64;
    var phi_1494_: u32;
    var phi_3486_: u32;
    var phi_3487_: u32;
    var phi_3497_: u32;
    var phi_3499_: u32;
    var phi_3500_: bool;
    var phi_3520_: u32;
    var phi_3521_: u32;
    var phi_3525_: type_65;
    var phi_3887_: type_64;
    var phi_3963_: type_64;
    var phi_3964_: type_64;
    var phi_3965_: u32;
    var phi_3967_: type_64;
    var phi_3968_: u32;
    var phi_3969_: bool;
    var phi_3978_: type_64;
    var phi_3983_: bool;
    var phi_3984_: type_64;
    var phi_1512_: type_52;
    var phi_1515_: type_8;
    var phi_1516_: type_8;
    var phi_1538_: type_8;
    var phi_1559_: u32;
    var phi_1651_: array<array<f32, 3>, 3>;
    var phi_2181_: f32;
    var phi_2182_: f32;
    var phi_2183_: f32;
    var phi_2184_: f32;
    var phi_2185_: vec3<f32>;
    var phi_2186_: vec3<f32>;
    var phi_2187_: vec3<f32>;
    var phi_2188_: vec3<f32>;
    var phi_2379_: f32;
    var phi_2399_: type_51;
    var phi_2400_: type_51;
    var phi_2403_: type_51;
    var phi_2404_: type_51;
    var phi_2405_: bool;
    var phi_2409_: type_51;
    var phi_2418_: type_30;
    var phi_2441_: u32;
    var phi_2455_: i32;
    var phi_2477_: vec3<f32>;
    var phi_2478_: vec3<f32>;
    var phi_2496_: vec3<f32>;
    var phi_2497_: vec3<f32>;
    var phi_2515_: vec3<f32>;
    var phi_2516_: vec3<f32>;
    var phi_2552_: vec3<f32>;
    var phi_2734_: f32;
    var phi_2752_: bool;
    var phi_2753_: bool;
    var phi_2758_: type_52;
    var phi_2759_: type_52;
    var phi_1513_: type_52;
    var phi_4396_: bool;
    var local_10: type_52;
    var phi_4585_: bool;
    var phi_3986_: type_52;
    var phi_3987_: bool;
    var phi_3988_: type_64;
    var phi_3989_: u32;
    var phi_4584_: bool;
    var phi_3990_: type_52;
    var phi_3991_: bool;
    var phi_3992_: type_64;
    var phi_3993_: u32;
    var phi_3994_: u32;
    var phi_4583_: bool;
    var phi_3995_: type_52;
    var phi_3996_: bool;
    var phi_3997_: type_64;
    var phi_3998_: u32;
    var phi_3999_: u32;
    var phi_4582_: bool;
    var phi_1387_: type_52;
    var phi_1390_: bool;
    var phi_1392_: type_64;
    var phi_1394_: u32;
    var phi_1396_: u32;
    var phi_4000_: bool;
    var phi_4581_: bool;
    var local_11: type_52;
    var local_12: type_52;

    switch bitcast<i32>(0u) {
        default: {
            let _e100 = global;
            let _e102 = arrayLength((&global_5.member));
            let _e104 = arrayLength((&global_6.member));
            let _e116 = arrayLength((&global_9.member));
            let _e120 = global_4.member[0u][0u];
            let _e124 = global_4.member[0u][1u];
            let _e128 = global_4.member[0u][2u];
            let _e132 = global_4.member[0u][3u];
            let _e136 = global_4.member[1u][0u];
            let _e140 = global_4.member[1u][1u];
            let _e144 = global_4.member[1u][2u];
            let _e148 = (_e100.x + (_e100.y * 2097152u));
            let _e160 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e132) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e120), bitcast<i32>(_e124), bitcast<i32>(_e128));
            local = array<i32, 3>(bitcast<i32>(_e136), bitcast<i32>(_e140), bitcast<i32>(_e144));
            let _e163 = (_e148 < arrayLength((&global_10.member)));
            if _e163 {
                if _e163 {
                } else {
                    break;
                }
                let _e167 = global_10.member[_e148].member_2;
                phi_363_ = _e167;
            } else {
                phi_363_ = 4294967295u;
            }
            let _e169 = phi_363_;
            let _e172 = global_1.member[0u];
            let _e176 = global_3.member[0u][0u];
            let _e180 = global_3.member[0u][1u];
            let _e184 = global_3.member[0u][2u];
            let _e188 = global_3.member[0u][3u];
            let _e192 = global_3.member[1u][0u];
            let _e196 = global_3.member[1u][1u];
            let _e200 = global_3.member[1u][2u];
            let _e204 = global_3.member[1u][3u];
            let _e205 = bitcast<f32>(_e176);
            let _e206 = bitcast<f32>(_e180);
            let _e207 = bitcast<f32>(_e184);
            let _e209 = bitcast<f32>(_e192);
            let _e210 = array<u32, 3>(_e196, _e200, _e204);
            let _e212 = bitcast<i32>(_e172);
            if (_e212 < -126i) {
                phi_407_ = -126i;
            } else {
                phi_407_ = select(_e212, 127i, (_e212 > 127i));
            }
            let _e217 = phi_407_;
            let _e222 = bitcast<f32>((bitcast<u32>((_e217 + 127i)) << bitcast<u32>(23i)));
            let _e228 = bitcast<f32>((bitcast<u32>(((_e212 - _e217) + 127i)) << bitcast<u32>(23i)));
            if (_e188 == 0u) {
                phi_547_ = type_45(array<f32, 3>(_e205, _e206, _e207), _e188, _e209, _e210);
            } else {
                let _e230 = bitcast<u32>(_e205);
                let _e232 = ((_e230 & 2139095040u) != 0u);
                let _e247 = bitcast<u32>(_e206);
                let _e249 = ((_e247 & 2139095040u) != 0u);
                let _e264 = bitcast<u32>(_e207);
                let _e266 = ((_e264 & 2139095040u) != 0u);
                let _e282 = bitcast<u32>(_e209);
                let _e284 = ((_e282 & 2139095040u) != 0u);
                phi_547_ = type_45(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e230 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e230 & 2147483648u))), _e205, _e232) * _e222) * select(0.00000011920929f, 1f, _e232)) * _e228), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e247 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e247 & 2147483648u))), _e206, _e249) * _e222) * select(0.00000011920929f, 1f, _e249)) * _e228), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e264 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e264 & 2147483648u))), _e207, _e266) * _e222) * select(0.00000011920929f, 1f, _e266)) * _e228)), _e188, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e282 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e282 & 2147483648u))), _e209, _e284) * _e222) * select(0.00000011920929f, 1f, _e284)) * _e228), _e210);
            }
            let _e301 = phi_547_;
            if _e163 {
                let _e302 = (_e148 < arrayLength((&global_2.member)));
                if _e302 {
                    if _e163 {
                    } else {
                        break;
                    }
                    let _e307 = global_10.member[_e148].member.member_1;
                    let _e312 = global_10.member[_e148].member.member_3;
                    if (_e307 <= _e312) {
                        let _e314 = (1u < _e116);
                        if _e314 {
                            if (0u < _e116) {
                            } else {
                                break;
                            }
                            let _e318 = atomicAdd((&global_9.member[0u]), 1u);
                            if ((_e318 + 1u) < _e318) {
                                if _e314 {
                                } else {
                                    break;
                                }
                                let _e323 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                        if _e163 {
                        } else {
                            break;
                        }
                        let _e333 = global_10.member[_e148].member.member_2[0u];
                        let _e335 = (bitcast<u32>(_e333) & 2147483647u);
                        let _e341 = global_10.member[_e148].member.member_2[1u];
                        let _e343 = (bitcast<u32>(_e341) & 2147483647u);
                        let _e349 = global_10.member[_e148].member.member_2[2u];
                        let _e351 = (bitcast<u32>(_e349) & 2147483647u);
                        let _e357 = global_10.member[_e148].member.member[0u];
                        let _e359 = (bitcast<u32>(_e357) & 2147483647u);
                        let _e365 = global_10.member[_e148].member.member[1u];
                        let _e367 = (bitcast<u32>(_e365) & 2147483647u);
                        let _e373 = global_10.member[_e148].member.member[2u];
                        let _e375 = (bitcast<u32>(_e373) & 2147483647u);
                        let _e377 = select(_e343, _e335, (_e343 < _e335));
                        let _e379 = select(_e351, _e377, (_e351 < _e377));
                        let _e381 = select(_e359, _e379, (_e359 < _e379));
                        let _e383 = select(_e367, _e381, (_e367 < _e381));
                        let _e385 = select(_e375, _e383, (_e375 < _e383));
                        let _e386 = bitcast<u32>(_e307);
                        let _e387 = (_e386 & 2147483647u);
                        let _e391 = bitcast<u32>(_e312);
                        let _e392 = (_e391 & 2147483647u);
                        let _e396 = (((select(_e387, _e385, (_e387 < _e385)) < 2139095040u) && (_e392 <= 2139095040u)) && (_e379 > 0u));
                        if _e396 {
                            let _e399 = (bitcast<u32>(bitcast<f32>(_e379)) & 2147483647u);
                            if (_e399 >= 8388608u) {
                                phi_697_ = (bitcast<i32>((_e399 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_697_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e399)), 32u, (_e399 == 0u))));
                            }
                            let _e413 = phi_697_;
                            phi_698_ = _e413;
                        } else {
                            phi_698_ = 0i;
                        }
                        let _e415 = phi_698_;
                        let _e416 = (_e335 == _e379);
                        if _e416 {
                            phi_708_ = true;
                        } else {
                            phi_708_ = (_e343 == _e379);
                        }
                        let _e419 = phi_708_;
                        let _e420 = select(1u, 0u, _e416);
                        if _e419 {
                            let _e421 = (_e420 + 1u);
                            phi_718_ = _e421;
                            phi_719_ = _e421;
                            phi_721_ = select(true, false, (_e421 == 2u));
                        } else {
                            phi_718_ = u32();
                            phi_719_ = 0u;
                            phi_721_ = true;
                        }
                        let _e425 = phi_718_;
                        let _e427 = phi_719_;
                        let _e429 = phi_721_;
                        if _e429 {
                            phi_726_ = (_e427 + 1u);
                        } else {
                            phi_726_ = 0u;
                        }
                        let _e433 = phi_726_;
                        let _e434 = select(_e425, _e427, _e429);
                        let _e435 = select(_e420, select(2u, _e420, _e419), _e429);
                        let _e436 = -(_e415);
                        if (_e436 < -126i) {
                            phi_759_ = -126i;
                        } else {
                            phi_759_ = select(_e436, 127i, (_e436 > 127i));
                        }
                        let _e441 = phi_759_;
                        let _e446 = bitcast<f32>((bitcast<u32>((_e441 + 127i)) << bitcast<u32>(23i)));
                        let _e452 = bitcast<f32>((bitcast<u32>(((_e436 - _e441) + 127i)) << bitcast<u32>(23i)));
                        let _e457 = global_10.member[_e148].member.member;
                        let _e458 = (_e434 == 0u);
                        if _e458 {
                            phi_777_ = _e457[0];
                        } else {
                            phi_777_ = _e457[1];
                        }
                        let _e462 = phi_777_;
                        let _e463 = (_e434 == 2u);
                        if _e463 {
                            phi_783_ = _e457[2];
                        } else {
                            phi_783_ = _e462;
                        }
                        let _e466 = phi_783_;
                        let _e467 = bitcast<u32>(_e466);
                        let _e469 = ((_e467 & 2139095040u) != 0u);
                        let _e481 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e467 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e467 & 2147483648u))), _e466, _e469) * select(0.00000011920929f, 1f, _e469));
                        let _e482 = global_10.member[_e148].member.member_2;
                        if _e458 {
                            phi_823_ = _e482[0];
                        } else {
                            phi_823_ = _e482[1];
                        }
                        let _e486 = phi_823_;
                        if _e463 {
                            phi_829_ = _e482[2];
                        } else {
                            phi_829_ = _e486;
                        }
                        let _e489 = phi_829_;
                        let _e490 = bitcast<u32>(_e489);
                        let _e492 = ((_e490 & 2139095040u) != 0u);
                        let _e506 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e490 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e490 & 2147483648u))), _e489, _e492) * _e446) * select(0.00000011920929f, 1f, _e492)) * _e452);
                        let _e510 = (bitcast<f32>((bitcast<u32>(_e506) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e513 = bitcast<f32>((bitcast<u32>(_e481) & 2147483647u));
                        let _e514 = (_e513 * 0.00000011920929f);
                        let _e517 = select(select(0.00000000000011368684f, _e514, (_e514 > 0.00000000000011368684f)), 0f, _e510);
                        let _e518 = select(0f, _e506, _e510);
                        let _e519 = (_e481 + _e517);
                        let _e520 = (_e481 - _e517);
                        let _e522 = select(38685626000000000000000000f, (1f / _e506), _e510);
                        let _e523 = (_e433 == 0u);
                        if _e523 {
                            phi_902_ = _e457[0];
                        } else {
                            phi_902_ = _e457[1];
                        }
                        let _e527 = phi_902_;
                        let _e528 = (_e433 == 2u);
                        if _e528 {
                            phi_908_ = _e457[2];
                        } else {
                            phi_908_ = _e527;
                        }
                        let _e531 = phi_908_;
                        let _e532 = bitcast<u32>(_e531);
                        let _e534 = ((_e532 & 2139095040u) != 0u);
                        let _e546 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e532 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e532 & 2147483648u))), _e531, _e534) * select(0.00000011920929f, 1f, _e534));
                        if _e523 {
                            phi_948_ = _e482[0];
                        } else {
                            phi_948_ = _e482[1];
                        }
                        let _e550 = phi_948_;
                        if _e528 {
                            phi_954_ = _e482[2];
                        } else {
                            phi_954_ = _e550;
                        }
                        let _e553 = phi_954_;
                        let _e554 = bitcast<u32>(_e553);
                        let _e556 = ((_e554 & 2139095040u) != 0u);
                        let _e570 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e554 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e554 & 2147483648u))), _e553, _e556) * _e446) * select(0.00000011920929f, 1f, _e556)) * _e452);
                        let _e574 = (bitcast<f32>((bitcast<u32>(_e570) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e577 = bitcast<f32>((bitcast<u32>(_e546) & 2147483647u));
                        let _e578 = (_e577 * 0.00000011920929f);
                        let _e581 = select(select(0.00000000000011368684f, _e578, (_e578 > 0.00000000000011368684f)), 0f, _e574);
                        let _e582 = select(0f, _e570, _e574);
                        let _e583 = (_e546 + _e581);
                        let _e584 = (_e546 - _e581);
                        let _e586 = select(38685626000000000000000000f, (1f / _e570), _e574);
                        let _e587 = (_e435 == 0u);
                        if _e587 {
                            phi_1027_ = _e457[0];
                        } else {
                            phi_1027_ = _e457[1];
                        }
                        let _e591 = phi_1027_;
                        let _e592 = (_e435 == 2u);
                        if _e592 {
                            phi_1033_ = _e457[2];
                        } else {
                            phi_1033_ = _e591;
                        }
                        let _e595 = phi_1033_;
                        let _e596 = bitcast<u32>(_e595);
                        let _e598 = ((_e596 & 2139095040u) != 0u);
                        let _e610 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e596 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e596 & 2147483648u))), _e595, _e598) * select(0.00000011920929f, 1f, _e598));
                        if _e587 {
                            phi_1073_ = _e482[0];
                        } else {
                            phi_1073_ = _e482[1];
                        }
                        let _e614 = phi_1073_;
                        if _e592 {
                            phi_1079_ = _e482[2];
                        } else {
                            phi_1079_ = _e614;
                        }
                        let _e617 = phi_1079_;
                        let _e618 = bitcast<u32>(_e617);
                        let _e620 = ((_e618 & 2139095040u) != 0u);
                        let _e634 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e618 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e618 & 2147483648u))), _e617, _e620) * _e446) * select(0.00000011920929f, 1f, _e620)) * _e452);
                        let _e638 = (bitcast<f32>((bitcast<u32>(_e634) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e641 = bitcast<f32>((bitcast<u32>(_e610) & 2147483647u));
                        let _e642 = (_e641 * 0.00000011920929f);
                        let _e645 = select(select(0.00000000000011368684f, _e642, (_e642 > 0.00000000000011368684f)), 0f, _e638);
                        let _e646 = select(0f, _e634, _e638);
                        let _e647 = (_e610 + _e645);
                        let _e648 = (_e610 - _e645);
                        let _e650 = select(38685626000000000000000000f, (1f / _e634), _e638);
                        let _e652 = select(_e577, _e513, (_e513 > _e577));
                        if (_e396 && (select(_e641, _e652, (_e652 > _e641)) <= 1099511600000f)) {
                            let _e664 = ((_e387 & 8388607u) | (select(0u, 1u, ((_e387 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e667 = bitcast<i32>((_e387 >> bitcast<u32>(23i)));
                            let _e671 = (_e664 == 0u);
                            let _e674 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e664)), 32u, _e671)) - 8i);
                            if (_e667 == 255i) {
                                phi_1198_ = 255i;
                            } else {
                                phi_1198_ = (((_e667 + select(0i, 1i, (_e667 == 0i))) - _e674) + _e415);
                            }
                            let _e682 = phi_1198_;
                            let _e692 = (_e682 <= 0i);
                            if _e692 {
                                phi_1221_ = u32();
                            } else {
                                if _e671 {
                                    phi_1220_ = u32();
                                } else {
                                    phi_1220_ = select(((bitcast<u32>(_e682) << bitcast<u32>(23i)) | ((_e664 << bitcast<u32>(((_e674 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e682 >= 255i));
                                }
                                let _e696 = phi_1220_;
                                phi_1221_ = _e696;
                            }
                            let _e698 = phi_1221_;
                            let _e710 = ((_e392 & 8388607u) | (select(0u, 1u, ((_e392 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e713 = bitcast<i32>((_e392 >> bitcast<u32>(23i)));
                            let _e717 = (_e710 == 0u);
                            let _e720 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e710)), 32u, _e717)) - 8i);
                            if (_e713 == 255i) {
                                phi_1258_ = 255i;
                            } else {
                                phi_1258_ = (((_e713 + select(0i, 1i, (_e713 == 0i))) - _e720) + _e415);
                            }
                            let _e728 = phi_1258_;
                            let _e738 = (_e728 <= 0i);
                            if _e738 {
                                phi_1281_ = u32();
                            } else {
                                if _e717 {
                                    phi_1280_ = u32();
                                } else {
                                    phi_1280_ = select(((bitcast<u32>(_e728) << bitcast<u32>(23i)) | ((_e710 << bitcast<u32>(((_e720 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e728 >= 255i));
                                }
                                let _e742 = phi_1280_;
                                phi_1281_ = _e742;
                            }
                            let _e744 = phi_1281_;
                            phi_1289_ = bitcast<f32>(((_e391 & 2147483648u) | select(_e744, 0u, select(_e717, true, _e738))));
                            phi_1290_ = bitcast<f32>(((_e386 & 2147483648u) | select(_e698, 0u, select(_e671, true, _e692))));
                        } else {
                            phi_1289_ = 0f;
                            phi_1290_ = 1f;
                        }
                        let _e750 = phi_1289_;
                        let _e752 = phi_1290_;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e758 = (_e434 % 3u);
                        let _e759 = (_e758 < 3u);
                        if _e759 {
                        } else {
                            break;
                        }
                        let _e761 = local_1[_e758];
                        let _e764 = (_e433 % 3u);
                        let _e765 = (_e764 < 3u);
                        if _e765 {
                        } else {
                            break;
                        }
                        let _e767 = local_1[_e764];
                        let _e770 = (_e435 % 3u);
                        let _e771 = (_e770 < 3u);
                        if _e771 {
                        } else {
                            break;
                        }
                        let _e773 = local_1[_e770];
                        if _e759 {
                        } else {
                            break;
                        }
                        let _e778 = local[_e758];
                        if _e765 {
                        } else {
                            break;
                        }
                        let _e782 = local[_e764];
                        if _e771 {
                        } else {
                            break;
                        }
                        let _e786 = local[_e770];
                        phi_4402_ = false;
                        phi_1386_ = type_52(_e750, false);
                        phi_1389_ = (_e752 <= _e750);
                        phi_1391_ = type_64(type_39(vec4<f32>((f32(_e761) * _e160), (f32(_e767) * _e160), (f32(_e773) * _e160), 0f), vec4<f32>((f32(_e778) * _e160), (f32(_e782) * _e160), (f32(_e786) * _e160), 0f)), select(0u, 2147483648u, (_e102 == 0u)));
                        phi_1393_ = 0u;
                        phi_1395_ = ((3u * _e102) + 1u);
                        loop {
                            let _e794 = phi_4402_;
                            let _e796 = phi_1386_;
                            let _e798 = phi_1389_;
                            let _e800 = phi_1391_;
                            let _e802 = phi_1393_;
                            let _e804 = phi_1395_;
                            local_11 = _e796;
                            if _e798 {
                                phi_1406_ = true;
                            } else {
                                phi_1406_ = (_e802 > 0u);
                            }
                            let _e807 = phi_1406_;
                            if _e807 {
                                let _e808 = (_e804 > 0u);
                                if _e808 {
                                    if _e798 {
                                        phi_1492_ = _e798;
                                        phi_1493_ = _e800;
                                        phi_1494_ = _e802;
                                    } else {
                                        let _e809 = (_e802 - 1u);
                                        let _e810 = (_e809 % 128u);
                                        let _e811 = (_e810 < 128u);
                                        if _e811 {
                                        } else {
                                            phi_4581_ = true;
                                            break;
                                        }
                                        let _e813 = local_7[_e810];
                                        if _e811 {
                                        } else {
                                            phi_4581_ = true;
                                            break;
                                        }
                                        let _e815 = local_6[_e810];
                                        if _e811 {
                                        } else {
                                            phi_4581_ = true;
                                            break;
                                        }
                                        let _e817 = local_5[_e810];
                                        if _e811 {
                                        } else {
                                            phi_4581_ = true;
                                            break;
                                        }
                                        let _e819 = local_4[_e810];
                                        if _e811 {
                                        } else {
                                            phi_4581_ = true;
                                            break;
                                        }
                                        let _e821 = local_3[_e810];
                                        if _e811 {
                                        } else {
                                            phi_4581_ = true;
                                            break;
                                        }
                                        let _e823 = local_2[_e810];
                                        if _e811 {
                                        } else {
                                            phi_4581_ = true;
                                            break;
                                        }
                                        let _e828 = local_8[_e810];
                                        if _e811 {
                                        } else {
                                            phi_4581_ = true;
                                            break;
                                        }
                                        let _e831 = local_9[_e810];
                                        phi_1492_ = (_e831 <= _e796.member);
                                        phi_1493_ = type_64(type_39(vec4<f32>(_e813, _e815, _e817, 0f), vec4<f32>(_e819, _e821, _e823, 0f)), _e828);
                                        phi_1494_ = _e809;
                                    }
                                    let _e835 = phi_1492_;
                                    let _e837 = phi_1493_;
                                    let _e839 = phi_1494_;
                                    if _e835 {
                                        if ((_e837.member_1 & 2147483648u) != 0u) {
                                            phi_1512_ = _e796;
                                            phi_1515_ = type_8(0u, ((_e837.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1288 = phi_1512_;
                                                let _e1290 = phi_1515_;
                                                local_10 = _e1288;
                                                local_12 = _e1288;
                                                if (_e1290.member < _e1290.member_1) {
                                                    phi_1516_ = type_8((_e1290.member + 1u), _e1290.member_1);
                                                    phi_1538_ = type_8(1u, _e1290.member);
                                                } else {
                                                    phi_1516_ = _e1290;
                                                    phi_1538_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1303 = phi_1516_;
                                                let _e1305 = phi_1538_;
                                                let _e1309 = (bitcast<i32>(_e1305.member) != 0i);
                                                if _e1309 {
                                                    let _e1310 = ((_e837.member_1 & 268435455u) + _e1305.member_1);
                                                    let _e1311 = (_e1310 < _e104);
                                                    if _e1311 {
                                                        if _e1311 {
                                                        } else {
                                                            phi_4396_ = true;
                                                            break;
                                                        }
                                                        let _e1315 = global_6.member[_e1310].member_1;
                                                        phi_1559_ = _e1315;
                                                    } else {
                                                        phi_1559_ = 4294967295u;
                                                    }
                                                    let _e1317 = phi_1559_;
                                                    if (_e1310 >= _e104) {
                                                        phi_1651_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1311 {
                                                        } else {
                                                            phi_4396_ = true;
                                                            break;
                                                        }
                                                        if (_e758 < 9u) {
                                                        } else {
                                                            phi_4396_ = true;
                                                            break;
                                                        }
                                                        let _e1324 = global_6.member[_e1310].member[_e758];
                                                        if (_e764 < 9u) {
                                                        } else {
                                                            phi_4396_ = true;
                                                            break;
                                                        }
                                                        let _e1330 = global_6.member[_e1310].member[_e764];
                                                        if (_e770 < 9u) {
                                                        } else {
                                                            phi_4396_ = true;
                                                            break;
                                                        }
                                                        let _e1336 = global_6.member[_e1310].member[_e770];
                                                        let _e1338 = (3u + _e758);
                                                        if (_e1338 < 9u) {
                                                        } else {
                                                            phi_4396_ = true;
                                                            break;
                                                        }
                                                        let _e1344 = global_6.member[_e1310].member[_e1338];
                                                        let _e1345 = (3u + _e764);
                                                        if (_e1345 < 9u) {
                                                        } else {
                                                            phi_4396_ = true;
                                                            break;
                                                        }
                                                        let _e1351 = global_6.member[_e1310].member[_e1345];
                                                        let _e1352 = (3u + _e770);
                                                        if (_e1352 < 9u) {
                                                        } else {
                                                            phi_4396_ = true;
                                                            break;
                                                        }
                                                        let _e1358 = global_6.member[_e1310].member[_e1352];
                                                        let _e1360 = (6u + _e758);
                                                        if (_e1360 < 9u) {
                                                        } else {
                                                            phi_4396_ = true;
                                                            break;
                                                        }
                                                        let _e1366 = global_6.member[_e1310].member[_e1360];
                                                        let _e1367 = (6u + _e764);
                                                        if (_e1367 < 9u) {
                                                        } else {
                                                            phi_4396_ = true;
                                                            break;
                                                        }
                                                        let _e1373 = global_6.member[_e1310].member[_e1367];
                                                        let _e1374 = (6u + _e770);
                                                        if (_e1374 < 9u) {
                                                        } else {
                                                            phi_4396_ = true;
                                                            break;
                                                        }
                                                        let _e1380 = global_6.member[_e1310].member[_e1374];
                                                        phi_1651_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1324, _e1330, _e1336), array<f32, 3>(_e1344, _e1351, _e1358), array<f32, 3>(_e1366, _e1373, _e1380));
                                                    }
                                                    let _e1384 = phi_1651_;
                                                    let _e1400 = (_e1384[0][2] - _e610);
                                                    let _e1403 = (((_e1384[0][0] - _e481) * _e646) - (_e1400 * _e518));
                                                    let _e1406 = (((_e1384[0][1] - _e546) * _e646) - (_e1400 * _e582));
                                                    let _e1409 = (_e1384[1][2] - _e610);
                                                    let _e1412 = (((_e1384[1][0] - _e481) * _e646) - (_e1409 * _e518));
                                                    let _e1415 = (((_e1384[1][1] - _e546) * _e646) - (_e1409 * _e582));
                                                    let _e1418 = (_e1384[2][2] - _e610);
                                                    let _e1421 = (((_e1384[2][0] - _e481) * _e646) - (_e1418 * _e518));
                                                    let _e1424 = (((_e1384[2][1] - _e546) * _e646) - (_e1418 * _e582));
                                                    let _e1425 = (_e1421 * _e1415);
                                                    let _e1426 = (_e1424 * _e1412);
                                                    let _e1427 = (_e1403 * _e1424);
                                                    let _e1428 = (_e1406 * _e1421);
                                                    let _e1429 = (_e1412 * _e1406);
                                                    let _e1430 = (_e1415 * _e1403);
                                                    let _e1435 = (((_e1425 >= _e1426) && (_e1427 >= _e1428)) && (_e1429 >= _e1430));
                                                    let _e1441 = (_e1435 || (((_e1425 <= _e1426) && (_e1427 <= _e1428)) && (_e1429 <= _e1430)));
                                                    if _e1441 {
                                                        let _e1443 = select(-1f, 1f, _e1435);
                                                        let _e1445 = ((_e1425 - _e1426) * _e1443);
                                                        let _e1447 = select(0f, _e1445, (_e1445 > 0f));
                                                        let _e1449 = ((_e1427 - _e1428) * _e1443);
                                                        let _e1451 = select(0f, _e1449, (_e1449 > 0f));
                                                        let _e1453 = ((_e1429 - _e1430) * _e1443);
                                                        let _e1455 = select(0f, _e1453, (_e1453 > 0f));
                                                        let _e1457 = ((_e1447 + _e1451) + _e1455);
                                                        let _e1459 = select(_e1384[1][0], _e1384[0][0], (_e1384[0][0] < _e1384[1][0]));
                                                        let _e1463 = select(_e1384[1][0], _e1384[0][0], (_e1384[0][0] > _e1384[1][0]));
                                                        let _e1467 = select(_e1384[1][1], _e1384[0][1], (_e1384[0][1] < _e1384[1][1]));
                                                        let _e1471 = select(_e1384[1][1], _e1384[0][1], (_e1384[0][1] > _e1384[1][1]));
                                                        let _e1475 = select(_e1384[1][2], _e1384[0][2], (_e1384[0][2] < _e1384[1][2]));
                                                        let _e1479 = select(_e1384[1][2], _e1384[0][2], (_e1384[0][2] > _e1384[1][2]));
                                                        let _e1484 = ((select(_e1384[2][0], _e1459, (_e1459 < _e1384[2][0])) - _e519) * _e522);
                                                        let _e1485 = ((select(_e1384[2][0], _e1463, (_e1463 > _e1384[2][0])) - _e520) * _e522);
                                                        let _e1488 = ((select(_e1384[2][1], _e1467, (_e1467 < _e1384[2][1])) - _e583) * _e586);
                                                        let _e1489 = ((select(_e1384[2][1], _e1471, (_e1471 > _e1384[2][1])) - _e584) * _e586);
                                                        let _e1492 = ((select(_e1384[2][2], _e1475, (_e1475 < _e1384[2][2])) - _e647) * _e650);
                                                        let _e1493 = ((select(_e1384[2][2], _e1479, (_e1479 > _e1384[2][2])) - _e648) * _e650);
                                                        let _e1495 = select(_e1493, _e1492, (_e1492 < _e1493));
                                                        let _e1497 = select(_e1493, _e1492, (_e1492 > _e1493));
                                                        let _e1499 = select(_e1485, _e1484, (_e1484 < _e1485));
                                                        let _e1501 = select(_e1489, _e1488, (_e1488 < _e1489));
                                                        let _e1503 = select(_e1501, _e1499, (_e1499 > _e1501));
                                                        let _e1505 = select(_e1495, _e1503, (_e1503 > _e1495));
                                                        let _e1507 = select(_e1485, _e1484, (_e1484 > _e1485));
                                                        let _e1509 = select(_e1489, _e1488, (_e1488 > _e1489));
                                                        let _e1511 = select(_e1509, _e1507, (_e1507 < _e1509));
                                                        let _e1513 = select(_e1497, _e1511, (_e1511 < _e1497));
                                                        let _e1514 = -(_e1495);
                                                        let _e1520 = select(_e752, _e1505, (_e1505 > _e752));
                                                        let _e1524 = select(_e1412, _e1403, (_e1403 < _e1412));
                                                        let _e1529 = select(_e1412, _e1403, (_e1403 > _e1412));
                                                        let _e1536 = select(_e1415, _e1406, (_e1406 < _e1415));
                                                        let _e1541 = select(_e1415, _e1406, (_e1406 > _e1415));
                                                        let _e1550 = (((((_e1441 && (_e1457 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1421, _e1524, (_e1524 < _e1421)) <= 0f) && (select(_e1421, _e1529, (_e1529 > _e1421)) >= 0f))) && ((select(_e1424, _e1536, (_e1536 < _e1424)) <= 0f) && (select(_e1424, _e1541, (_e1541 > _e1424)) >= 0f))) && (_e1520 <= (_e1513 + (select(_e1514, _e1497, (_e1497 > _e1514)) * 0.0000019073523f)))) && (_e1520 <= _e1288.member));
                                                        if _e1550 {
                                                            let _e1555 = (_e1384[1][0] - _e1384[0][0]);
                                                            let _e1556 = (_e1384[1][1] - _e1384[0][1]);
                                                            let _e1557 = (_e1384[1][2] - _e1384[0][2]);
                                                            let _e1558 = vec3<f32>(_e1555, _e1556, _e1557);
                                                            let _e1559 = (_e1384[2][0] - _e1384[1][0]);
                                                            let _e1560 = (_e1384[2][1] - _e1384[1][1]);
                                                            let _e1561 = (_e1384[2][2] - _e1384[1][2]);
                                                            let _e1562 = vec3<f32>(_e1559, _e1560, _e1561);
                                                            let _e1563 = (_e1384[0][0] - _e1384[2][0]);
                                                            let _e1564 = (_e1384[0][1] - _e1384[2][1]);
                                                            let _e1565 = (_e1384[0][2] - _e1384[2][2]);
                                                            let _e1566 = vec3<f32>(_e1563, _e1564, _e1565);
                                                            let _e1569 = bitcast<f32>((bitcast<u32>(_e1555) & 2147483647u));
                                                            let _e1572 = bitcast<f32>((bitcast<u32>(_e1556) & 2147483647u));
                                                            let _e1574 = select(_e1572, _e1569, (_e1569 > _e1572));
                                                            let _e1577 = bitcast<f32>((bitcast<u32>(_e1557) & 2147483647u));
                                                            let _e1579 = select(_e1577, _e1574, (_e1574 > _e1577));
                                                            let _e1582 = bitcast<f32>((bitcast<u32>(_e1559) & 2147483647u));
                                                            let _e1585 = bitcast<f32>((bitcast<u32>(_e1560) & 2147483647u));
                                                            let _e1587 = select(_e1585, _e1582, (_e1582 > _e1585));
                                                            let _e1590 = bitcast<f32>((bitcast<u32>(_e1561) & 2147483647u));
                                                            let _e1592 = select(_e1590, _e1587, (_e1587 > _e1590));
                                                            let _e1595 = bitcast<f32>((bitcast<u32>(_e1563) & 2147483647u));
                                                            let _e1598 = bitcast<f32>((bitcast<u32>(_e1564) & 2147483647u));
                                                            let _e1600 = select(_e1598, _e1595, (_e1595 > _e1598));
                                                            let _e1603 = bitcast<f32>((bitcast<u32>(_e1565) & 2147483647u));
                                                            let _e1605 = select(_e1603, _e1600, (_e1600 > _e1603));
                                                            let _e1607 = select(_e1592, _e1579, (_e1579 > _e1592));
                                                            let _e1609 = select(_e1605, _e1607, (_e1607 > _e1605));
                                                            if (_e1579 == _e1609) {
                                                                phi_2181_ = _e1415;
                                                                phi_2182_ = _e1412;
                                                                phi_2183_ = _e1406;
                                                                phi_2184_ = _e1403;
                                                                phi_2185_ = vec3<f32>(_e1384[0][0], _e1384[0][1], _e1384[0][2]);
                                                                phi_2186_ = _e1566;
                                                                phi_2187_ = _e1562;
                                                                phi_2188_ = _e1558;
                                                            } else {
                                                                let _e1611 = (_e1592 == _e1609);
                                                                let _e1616 = vec3(_e1611);
                                                                phi_2181_ = select(_e1406, _e1424, _e1611);
                                                                phi_2182_ = select(_e1403, _e1421, _e1611);
                                                                phi_2183_ = select(_e1424, _e1415, _e1611);
                                                                phi_2184_ = select(_e1421, _e1412, _e1611);
                                                                phi_2185_ = select(vec3<f32>(_e1384[2][0], _e1384[2][1], _e1384[2][2]), vec3<f32>(_e1384[1][0], _e1384[1][1], _e1384[1][2]), _e1616);
                                                                phi_2186_ = select(_e1562, _e1558, _e1616);
                                                                phi_2187_ = select(_e1558, _e1566, _e1616);
                                                                phi_2188_ = select(_e1566, _e1562, _e1616);
                                                            }
                                                            let _e1622 = phi_2181_;
                                                            let _e1624 = phi_2182_;
                                                            let _e1626 = phi_2183_;
                                                            let _e1628 = phi_2184_;
                                                            let _e1630 = phi_2185_;
                                                            let _e1632 = phi_2186_;
                                                            let _e1634 = phi_2187_;
                                                            let _e1636 = phi_2188_;
                                                            let _e1643 = ((_e1634.y * _e1632.z) - (_e1632.y * _e1634.z));
                                                            let _e1648 = ((_e1634.z * _e1632.x) - (_e1632.z * _e1634.x));
                                                            let _e1651 = ((_e1634.x * _e1632.y) - (_e1632.x * _e1634.y));
                                                            let _e1654 = ((_e1447 >= _e1451) && (_e1447 >= _e1455));
                                                            let _e1655 = (_e1451 >= _e1455);
                                                            let _e1669 = (((_e1643 * (select(select(_e1384[2][0], _e1384[1][0], _e1655), _e1384[0][0], _e1654) - _e481)) + (_e1648 * (select(select(_e1384[2][1], _e1384[1][1], _e1655), _e1384[0][1], _e1654) - _e546))) + (_e1651 * (select(select(_e1384[2][2], _e1384[1][2], _e1655), _e1384[0][2], _e1654) - _e610)));
                                                            let _e1674 = (((_e1643 * _e518) + (_e1648 * _e582)) + (_e1651 * _e646));
                                                            let _e1675 = (_e1624 - _e1628);
                                                            let _e1676 = (_e1622 - _e1626);
                                                            let _e1679 = ((_e1675 * _e1675) + (_e1676 * _e1676));
                                                            let _e1686 = (-(((_e1628 * _e1675) + (_e1626 * _e1676))) / select(0.000000000000000000000000000000000000011754944f, _e1679, (_e1679 > 0.000000000000000000000000000000000000011754944f)));
                                                            let _e1688 = select(1f, _e1686, (_e1686 < 1f));
                                                            let _e1690 = select(0f, _e1688, (_e1688 > 0f));
                                                            let _e1699 = ((_e1630.x + (_e1636.x * _e1690)) - _e481);
                                                            let _e1702 = ((_e1630.y + (_e1636.y * _e1690)) - _e546);
                                                            let _e1705 = ((_e1630.z + (_e1636.z * _e1690)) - _e610);
                                                            let _e1708 = bitcast<f32>((bitcast<u32>(_e1699) & 2147483647u));
                                                            let _e1711 = bitcast<f32>((bitcast<u32>(_e1702) & 2147483647u));
                                                            let _e1713 = select(_e1711, _e1708, (_e1708 > _e1711));
                                                            let _e1716 = bitcast<f32>((bitcast<u32>(_e1705) & 2147483647u));
                                                            let _e1718 = select(_e1716, _e1713, (_e1713 > _e1716));
                                                            let _e1724 = bitcast<f32>((bitcast<u32>(_e1643) & 2147483647u));
                                                            let _e1727 = bitcast<f32>((bitcast<u32>(_e1648) & 2147483647u));
                                                            let _e1729 = select(_e1727, _e1724, (_e1724 > _e1727));
                                                            let _e1732 = bitcast<f32>((bitcast<u32>(_e1651) & 2147483647u));
                                                            let _e1751 = bitcast<f32>((bitcast<u32>(_e1634.x) & 2147483647u));
                                                            let _e1754 = bitcast<f32>((bitcast<u32>(_e1634.y) & 2147483647u));
                                                            let _e1756 = select(_e1754, _e1751, (_e1751 > _e1754));
                                                            let _e1759 = bitcast<f32>((bitcast<u32>(_e1634.z) & 2147483647u));
                                                            let _e1765 = bitcast<f32>((bitcast<u32>(_e1632.x) & 2147483647u));
                                                            let _e1768 = bitcast<f32>((bitcast<u32>(_e1632.y) & 2147483647u));
                                                            let _e1770 = select(_e1768, _e1765, (_e1765 > _e1768));
                                                            let _e1773 = bitcast<f32>((bitcast<u32>(_e1632.z) & 2147483647u));
                                                            let _e1779 = ((bitcast<f32>((bitcast<u32>(((((_e1643 * _e1699) + (_e1648 * _e1702)) + (_e1651 * _e1705)) - _e1669)) & 2147483647u)) <= ((0.0000009536743f * select(_e1609, _e1718, (_e1718 > _e1609))) * select(_e1732, _e1729, (_e1729 > _e1732)))) && !((bitcast<f32>((bitcast<u32>(_e1674) & 2147483647u)) <= ((0.0000038146973f * select(_e1759, _e1756, (_e1756 > _e1759))) * select(_e1773, _e1770, (_e1770 > _e1773))))));
                                                            let _e1780 = (_e1669 / _e1674);
                                                            if (_e1550 && !(_e1779)) {
                                                                let _e1783 = (_e1705 / _e646);
                                                                let _e1791 = (((_e1643 * (_e1699 - (_e518 * _e1783))) + (_e1648 * (_e1702 - (_e582 * _e1783)))) / _e1674);
                                                                phi_2379_ = select(select(_e1783, (_e1783 + _e1791), (bitcast<f32>((bitcast<u32>(_e1791) & 2147483647u)) <= _e1609)), _e1780, _e1779);
                                                            } else {
                                                                phi_2379_ = _e1780;
                                                            }
                                                            let _e1800 = phi_2379_;
                                                            let _e1802 = select(_e1513, _e1800, (_e1800 < _e1513));
                                                            let _e1804 = select(_e1505, _e1802, (_e1802 > _e1505));
                                                            let _e1805 = (1f / _e1457);
                                                            phi_2399_ = type_51(_e1804, (_e1451 * _e1805), (_e1455 * _e1805), ((_e1550 && (_e1804 >= _e752)) && (_e1804 <= _e1288.member)));
                                                            phi_2400_ = type_51();
                                                        } else {
                                                            phi_2399_ = type_51();
                                                            phi_2400_ = type_51(0f, 0f, 0f, _e1550);
                                                        }
                                                        let _e1814 = phi_2399_;
                                                        let _e1816 = phi_2400_;
                                                        phi_2403_ = _e1814;
                                                        phi_2404_ = _e1816;
                                                        phi_2405_ = select(true, false, _e1550);
                                                    } else {
                                                        phi_2403_ = type_51();
                                                        phi_2404_ = type_51(0f, 0f, 0f, _e1441);
                                                        phi_2405_ = true;
                                                    }
                                                    let _e1819 = phi_2403_;
                                                    let _e1821 = phi_2404_;
                                                    let _e1823 = phi_2405_;
                                                    if _e1823 {
                                                        phi_2409_ = _e1821;
                                                    } else {
                                                        phi_2409_ = _e1819;
                                                    }
                                                    let _e1825 = phi_2409_;
                                                    if _e1825.member_3 {
                                                        phi_2418_ = type_30(_e1825.member, _e1825.member_1, _e1825.member_2, _e1317);
                                                    } else {
                                                        phi_2418_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    }
                                                    let _e1832 = phi_2418_;
                                                    if (_e1832.member_3 != 4294967295u) {
                                                        if (_e1317 == _e169) {
                                                            phi_2753_ = false;
                                                        } else {
                                                            let _e1836 = (_e1317 < arrayLength((&global_7.member)));
                                                            if _e1836 {
                                                                if _e1836 {
                                                                } else {
                                                                    phi_4396_ = true;
                                                                    break;
                                                                }
                                                                let _e1838 = global_7.member[_e1317];
                                                                phi_2441_ = _e1838;
                                                            } else {
                                                                phi_2441_ = 4294967295u;
                                                            }
                                                            let _e1840 = phi_2441_;
                                                            let _e1841 = (_e1840 < arrayLength((&global_8.member)));
                                                            if _e1841 {
                                                                if _e1841 {
                                                                } else {
                                                                    phi_4396_ = true;
                                                                    break;
                                                                }
                                                                let _e1843 = global_8.member[_e1840];
                                                                phi_2455_ = _e1843;
                                                            } else {
                                                                phi_2455_ = 0i;
                                                            }
                                                            let _e1845 = phi_2455_;
                                                            let _e1846 = (_e1845 == 0i);
                                                            if _e1846 {
                                                                phi_2752_ = true;
                                                            } else {
                                                                if _e458 {
                                                                    phi_2478_ = vec3<f32>(_e1384[0][0], _e1384[0][1], _e1384[0][2]);
                                                                } else {
                                                                    if (_e434 == 1u) {
                                                                        phi_2477_ = vec3<f32>(_e1384[0][2], _e1384[0][0], _e1384[0][1]);
                                                                    } else {
                                                                        phi_2477_ = vec3<f32>(_e1384[0][1], _e1384[0][2], _e1384[0][0]);
                                                                    }
                                                                    let _e1851 = phi_2477_;
                                                                    phi_2478_ = _e1851;
                                                                }
                                                                let _e1854 = phi_2478_;
                                                                if _e458 {
                                                                    phi_2497_ = vec3<f32>(_e1384[1][0], _e1384[1][1], _e1384[1][2]);
                                                                } else {
                                                                    if (_e434 == 1u) {
                                                                        phi_2496_ = vec3<f32>(_e1384[1][2], _e1384[1][0], _e1384[1][1]);
                                                                    } else {
                                                                        phi_2496_ = vec3<f32>(_e1384[1][1], _e1384[1][2], _e1384[1][0]);
                                                                    }
                                                                    let _e1859 = phi_2496_;
                                                                    phi_2497_ = _e1859;
                                                                }
                                                                let _e1862 = phi_2497_;
                                                                if _e458 {
                                                                    phi_2516_ = vec3<f32>(_e1384[2][0], _e1384[2][1], _e1384[2][2]);
                                                                } else {
                                                                    if (_e434 == 1u) {
                                                                        phi_2515_ = vec3<f32>(_e1384[2][2], _e1384[2][0], _e1384[2][1]);
                                                                    } else {
                                                                        phi_2515_ = vec3<f32>(_e1384[2][1], _e1384[2][2], _e1384[2][0]);
                                                                    }
                                                                    let _e1867 = phi_2515_;
                                                                    phi_2516_ = _e1867;
                                                                }
                                                                let _e1870 = phi_2516_;
                                                                let _e1873 = (_e1862.x - _e1854.x);
                                                                let _e1876 = (_e1862.y - _e1854.y);
                                                                let _e1879 = (_e1862.z - _e1854.z);
                                                                let _e1881 = (_e1870.x - _e1854.x);
                                                                let _e1883 = (_e1870.y - _e1854.y);
                                                                let _e1885 = (_e1870.z - _e1854.z);
                                                                if (_e301.member_1 == 1u) {
                                                                    phi_2552_ = (vec3<f32>(_e301.member[0], _e301.member[1], _e301.member[2]) - _e1854);
                                                                } else {
                                                                    phi_2552_ = vec3<f32>(_e301.member[0], _e301.member[1], _e301.member[2]);
                                                                }
                                                                let _e1900 = phi_2552_;
                                                                let _e1906 = bitcast<f32>((bitcast<u32>((_e1873 * _e1883)) ^ _e301.member_3[0]));
                                                                let _e1910 = bitcast<f32>((bitcast<u32>((_e1876 * _e1881)) ^ _e301.member_3[0]));
                                                                let _e1914 = bitcast<f32>((bitcast<u32>((_e1876 * _e1885)) ^ _e301.member_3[0]));
                                                                let _e1918 = bitcast<f32>((bitcast<u32>((_e1879 * _e1883)) ^ _e301.member_3[0]));
                                                                let _e1922 = bitcast<f32>((bitcast<u32>((_e1879 * _e1881)) ^ _e301.member_3[0]));
                                                                let _e1926 = bitcast<f32>((bitcast<u32>((_e1873 * _e1885)) ^ _e301.member_3[0]));
                                                                let _e1927 = (_e1914 - _e1918);
                                                                let _e1928 = (_e1922 - _e1926);
                                                                let _e1929 = (_e1906 - _e1910);
                                                                let _e1953 = (bitcast<f32>((bitcast<u32>(_e1914) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1918) & 2147483647u)));
                                                                let _e1960 = (bitcast<f32>((bitcast<u32>(_e1922) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1926) & 2147483647u)));
                                                                let _e1967 = (bitcast<f32>((bitcast<u32>(_e1906) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1910) & 2147483647u)));
                                                                if (_e301.member_2 == 0f) {
                                                                    phi_2734_ = 0f;
                                                                } else {
                                                                    let _e1997 = bitcast<f32>((bitcast<u32>(_e1927) & 2147483647u));
                                                                    let _e2000 = bitcast<f32>((bitcast<u32>(_e1928) & 2147483647u));
                                                                    let _e2003 = bitcast<f32>((bitcast<u32>(_e1929) & 2147483647u));
                                                                    let _e2005 = select(_e2003, _e2000, (_e2000 > _e2003));
                                                                    let _e2009 = select(_e2003, _e2000, (_e2000 < _e2003));
                                                                    let _e2013 = select(_e2000, _e1997, (_e1997 < _e2000));
                                                                    let _e2015 = select(_e2000, _e1997, (_e1997 > _e2000));
                                                                    let _e2017 = select(_e2003, _e2015, (_e2015 < _e2003));
                                                                    phi_2734_ = bitcast<f32>((bitcast<u32>((_e301.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2005, _e1997, (_e1997 > _e2005)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2017, _e2013, (_e2013 > _e2017)))) ^ _e301.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2009, _e1997, (_e1997 < _e2009)))) ^ _e301.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1953 + _e1960) + _e1967))) ^ _e301.member_3[0]))) * 1.0000005f)) ^ _e301.member_3[0])))) ^ _e301.member_3[0]));
                                                                }
                                                                let _e2044 = phi_2734_;
                                                                phi_2752_ = (_e1846 || !(((((bitcast<f32>((bitcast<u32>((_e1900.x * _e1927)) ^ _e301.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1900.y * _e1928)) ^ _e301.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1900.z * _e1929)) ^ _e301.member_3[0]))) * f32(-(_e1845))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1900.x) & 2147483647u)) * _e1953)) ^ _e301.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1900.y) & 2147483647u)) * _e1960)) ^ _e301.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1900.z) & 2147483647u)) * _e1967)) ^ _e301.member_3[0]))))) ^ _e301.member_3[0])) + _e2044) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e2058 = phi_2752_;
                                                            phi_2753_ = _e2058;
                                                        }
                                                        let _e2060 = phi_2753_;
                                                        if _e2060 {
                                                            phi_2758_ = type_52(-340282350000000000000000000000000000000f, true);
                                                        } else {
                                                            phi_2758_ = _e1288;
                                                        }
                                                        let _e2062 = phi_2758_;
                                                        phi_2759_ = _e2062;
                                                    } else {
                                                        phi_2759_ = _e1288;
                                                    }
                                                    let _e2064 = phi_2759_;
                                                    phi_1513_ = _e2064;
                                                } else {
                                                    phi_1513_ = type_52();
                                                }
                                                let _e2066 = phi_1513_;
                                                continue;
                                                continuing {
                                                    phi_1512_ = _e2066;
                                                    phi_1515_ = _e1303;
                                                    phi_4396_ = _e794;
                                                    break if !(_e1309);
                                                }
                                            }
                                            let _e2069 = phi_4396_;
                                            phi_4581_ = _e2069;
                                            if _e2069 {
                                                break;
                                            }
                                            let _e2071 = local_10;
                                            phi_4585_ = _e2069;
                                            let _e2259 = local_12;
                                            phi_3986_ = _e2259;
                                            phi_3987_ = false;
                                            phi_3988_ = _e837;
                                            phi_3989_ = select(_e839, 0u, (_e752 > _e2071.member));
                                        } else {
                                            if (_e837.member_1 >= _e102) {
                                                phi_3525_ = type_65(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_64(type_39(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_64(type_39(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e837.member_1 < _e102) {
                                                } else {
                                                    phi_4581_ = true;
                                                    break;
                                                }
                                                let _e851 = ((1u + _e434) % 4u);
                                                if (_e851 < 4u) {
                                                } else {
                                                    phi_4581_ = true;
                                                    break;
                                                }
                                                let _e856 = global_5.member[_e837.member_1][_e851];
                                                let _e858 = (_e856 >> bitcast<u32>(11u));
                                                let _e860 = ((1u + _e433) % 4u);
                                                if (_e860 < 4u) {
                                                } else {
                                                    phi_4581_ = true;
                                                    break;
                                                }
                                                let _e865 = global_5.member[_e837.member_1][_e860];
                                                let _e867 = (_e865 >> bitcast<u32>(11u));
                                                let _e869 = ((1u + _e435) % 4u);
                                                if (_e869 < 4u) {
                                                } else {
                                                    phi_4581_ = true;
                                                    break;
                                                }
                                                let _e874 = global_5.member[_e837.member_1][_e869];
                                                let _e876 = (_e874 >> bitcast<u32>(11u));
                                                let _e899 = (bitcast<f32>((bitcast<u32>((_e837.member.member_1.x - _e837.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e900 = (bitcast<f32>((bitcast<u32>((_e837.member.member_1.y - _e837.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e901 = (bitcast<f32>((bitcast<u32>((_e837.member.member_1.z - _e837.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e903 = select(_e160, _e899, (_e899 > _e160));
                                                let _e905 = select(_e160, _e900, (_e900 > _e160));
                                                let _e907 = select(_e160, _e901, (_e901 > _e160));
                                                let _e938 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e856 & 1023u))) - 8388608f) * _e903));
                                                let _e943 = (bitcast<i32>((_e856 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e946 = bitcast<f32>((_e938 & bitcast<u32>(_e943)));
                                                let _e947 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e865 & 1023u))) - 8388608f) * _e905));
                                                let _e952 = (bitcast<i32>((_e865 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e955 = bitcast<f32>((_e947 & bitcast<u32>(_e952)));
                                                let _e956 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e874 & 1023u))) - 8388608f) * _e907));
                                                let _e961 = (bitcast<i32>((_e874 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e964 = bitcast<f32>((_e956 & bitcast<u32>(_e961)));
                                                let _e968 = bitcast<f32>((_e938 & bitcast<u32>(~(_e943))));
                                                let _e972 = bitcast<f32>((_e947 & bitcast<u32>(~(_e952))));
                                                let _e976 = bitcast<f32>((_e956 & bitcast<u32>(~(_e961))));
                                                let _e977 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e858 & 1023u))) - 8388608f) * _e903));
                                                let _e982 = (bitcast<i32>((_e858 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e985 = bitcast<f32>((_e977 & bitcast<u32>(_e982)));
                                                let _e986 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e867 & 1023u))) - 8388608f) * _e905));
                                                let _e991 = (bitcast<i32>((_e867 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e994 = bitcast<f32>((_e986 & bitcast<u32>(_e991)));
                                                let _e995 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e876 & 1023u))) - 8388608f) * _e907));
                                                let _e1000 = (bitcast<i32>((_e876 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1003 = bitcast<f32>((_e995 & bitcast<u32>(_e1000)));
                                                let _e1007 = bitcast<f32>((_e977 & bitcast<u32>(~(_e982))));
                                                let _e1011 = bitcast<f32>((_e986 & bitcast<u32>(~(_e991))));
                                                let _e1015 = bitcast<f32>((_e995 & bitcast<u32>(~(_e1000))));
                                                let _e1045 = global_5.member[_e837.member_1][0u];
                                                let _e1049 = global_5.member[_e837.member_1][1u];
                                                let _e1053 = global_5.member[_e837.member_1][2u];
                                                let _e1057 = global_5.member[_e837.member_1][3u];
                                                let _e1069 = (((_e1049 >> bitcast<u32>(22i)) | ((_e1053 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1057 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e1070 = (_e1045 & 268435455u);
                                                let _e1071 = (_e1069 & 268435455u);
                                                let _e1074 = ((_e1045 >> bitcast<u32>(28u)) & 7u);
                                                let _e1082 = ((_e1045 >> bitcast<u32>(31i)) | (((_e1069 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e1083 = (_e1074 != 0u);
                                                if (_e1074 == 0u) {
                                                    phi_3487_ = _e1070;
                                                } else {
                                                    if (_e1074 == 7u) {
                                                        phi_3486_ = 2147483648u;
                                                    } else {
                                                        phi_3486_ = ((2147483648u | (_e1074 << bitcast<u32>(28u))) | (_e1071 & 268435455u));
                                                    }
                                                    let _e1092 = phi_3486_;
                                                    phi_3487_ = _e1092;
                                                }
                                                let _e1094 = phi_3487_;
                                                if _e1083 {
                                                    let _e1095 = (_e1074 != 7u);
                                                    if _e1095 {
                                                        phi_3497_ = (_e1071 + _e1074);
                                                    } else {
                                                        phi_3497_ = u32();
                                                    }
                                                    let _e1098 = phi_3497_;
                                                    phi_3499_ = _e1098;
                                                    phi_3500_ = select(true, false, _e1095);
                                                } else {
                                                    phi_3499_ = u32();
                                                    phi_3500_ = true;
                                                }
                                                let _e1101 = phi_3499_;
                                                let _e1103 = phi_3500_;
                                                if (_e1082 == 0u) {
                                                    phi_3521_ = (_e1070 + select(0u, 1u, !(_e1083)));
                                                } else {
                                                    if (_e1082 == 7u) {
                                                        phi_3520_ = 2147483648u;
                                                    } else {
                                                        phi_3520_ = ((2147483648u | (_e1082 << bitcast<u32>(28u))) | (select(_e1101, _e1071, _e1103) & 268435455u));
                                                    }
                                                    let _e1116 = phi_3520_;
                                                    phi_3521_ = _e1116;
                                                }
                                                let _e1118 = phi_3521_;
                                                phi_3525_ = type_65(array<vec4<f32>, 3>(vec4<f32>((_e837.member.member.x + _e946), (_e837.member.member.x + _e968), (_e837.member.member_1.x - _e985), (_e837.member.member_1.x - _e1007)), vec4<f32>((_e837.member.member.y + _e955), (_e837.member.member.y + _e972), (_e837.member.member_1.y - _e994), (_e837.member.member_1.y - _e1011)), vec4<f32>((_e837.member.member.z + _e964), (_e837.member.member.z + _e976), (_e837.member.member_1.z - _e1003), (_e837.member.member_1.z - _e1015))), type_64(type_39((_e837.member.member + vec4<f32>(_e946, _e955, _e964, 0f)), (_e837.member.member_1 - vec4<f32>(_e985, _e994, _e1003, 0f))), _e1094), type_64(type_39((_e837.member.member + vec4<f32>(_e968, _e972, _e976, 0f)), (_e837.member.member_1 - vec4<f32>(_e1007, _e1011, _e1015, 0f))), _e1118));
                                            }
                                            let _e1123 = phi_3525_;
                                            let _e1135 = ((_e1123.member[0].x - _e519) * _e522);
                                            let _e1136 = ((_e1123.member[0].y - _e519) * _e522);
                                            let _e1137 = ((_e1123.member[0].z - _e520) * _e522);
                                            let _e1138 = ((_e1123.member[0].w - _e520) * _e522);
                                            let _e1148 = ((_e1123.member[1].x - _e583) * _e586);
                                            let _e1149 = ((_e1123.member[1].y - _e583) * _e586);
                                            let _e1150 = ((_e1123.member[1].z - _e584) * _e586);
                                            let _e1151 = ((_e1123.member[1].w - _e584) * _e586);
                                            let _e1161 = ((_e1123.member[2].x - _e647) * _e650);
                                            let _e1162 = ((_e1123.member[2].y - _e647) * _e650);
                                            let _e1163 = ((_e1123.member[2].z - _e648) * _e650);
                                            let _e1164 = ((_e1123.member[2].w - _e648) * _e650);
                                            let _e1166 = select(_e1163, _e1161, (_e1161 < _e1163));
                                            let _e1168 = select(_e1164, _e1162, (_e1162 < _e1164));
                                            let _e1170 = select(_e1163, _e1161, (_e1161 > _e1163));
                                            let _e1172 = select(_e1164, _e1162, (_e1162 > _e1164));
                                            let _e1174 = select(_e1137, _e1135, (_e1135 < _e1137));
                                            let _e1176 = select(_e1138, _e1136, (_e1136 < _e1138));
                                            let _e1178 = select(_e1150, _e1148, (_e1148 < _e1150));
                                            let _e1180 = select(_e1151, _e1149, (_e1149 < _e1151));
                                            let _e1182 = select(_e1178, _e1174, (_e1174 > _e1178));
                                            let _e1184 = select(_e1180, _e1176, (_e1176 > _e1180));
                                            let _e1186 = select(_e1166, _e1182, (_e1182 > _e1166));
                                            let _e1188 = select(_e1168, _e1184, (_e1184 > _e1168));
                                            let _e1190 = select(_e1137, _e1135, (_e1135 > _e1137));
                                            let _e1192 = select(_e1138, _e1136, (_e1136 > _e1138));
                                            let _e1194 = select(_e1150, _e1148, (_e1148 > _e1150));
                                            let _e1196 = select(_e1151, _e1149, (_e1149 > _e1151));
                                            let _e1198 = select(_e1194, _e1190, (_e1190 < _e1194));
                                            let _e1200 = select(_e1196, _e1192, (_e1192 < _e1196));
                                            let _e1205 = -(_e1166);
                                            let _e1206 = -(_e1168);
                                            let _e1213 = (select(_e1170, _e1198, (_e1198 < _e1170)) + (select(_e1205, _e1170, (_e1170 > _e1205)) * 0.0000019073523f));
                                            let _e1214 = (select(_e1172, _e1200, (_e1200 < _e1172)) + (select(_e1206, _e1172, (_e1172 > _e1206)) * 0.0000019073523f));
                                            let _e1216 = select(_e752, _e1186, (_e1186 > _e752));
                                            let _e1218 = select(_e752, _e1188, (_e1188 > _e752));
                                            let _e1223 = (_e1216 <= select(_e796.member, _e1213, (_e1213 < _e796.member)));
                                            let _e1224 = (_e1218 <= select(_e796.member, _e1214, (_e1214 < _e796.member)));
                                            let _e1225 = (_e1216 <= _e1218);
                                            if _e1223 {
                                                if _e1224 {
                                                    if _e1225 {
                                                        phi_3887_ = _e1123.member_2;
                                                    } else {
                                                        phi_3887_ = _e1123.member_1;
                                                    }
                                                    let _e1229 = phi_3887_;
                                                    let _e1250 = (_e839 % 128u);
                                                    let _e1251 = (_e1250 < 128u);
                                                    if _e1251 {
                                                    } else {
                                                        phi_4581_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1250] = _e1229.member_1;
                                                    if _e1251 {
                                                    } else {
                                                        phi_4581_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1250] = _e1229.member.member.x;
                                                    if _e1251 {
                                                    } else {
                                                        phi_4581_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1250] = _e1229.member.member.y;
                                                    if _e1251 {
                                                    } else {
                                                        phi_4581_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1250] = _e1229.member.member.z;
                                                    if _e1251 {
                                                    } else {
                                                        phi_4581_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1250] = _e1229.member.member_1.x;
                                                    if _e1251 {
                                                    } else {
                                                        phi_4581_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1250] = _e1229.member.member_1.y;
                                                    if _e1251 {
                                                    } else {
                                                        phi_4581_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1250] = _e1229.member.member_1.z;
                                                    if _e1251 {
                                                    } else {
                                                        phi_4581_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1250] = select(_e1216, _e1218, _e1225);
                                                    if _e1225 {
                                                        phi_3963_ = _e1123.member_1;
                                                    } else {
                                                        phi_3963_ = _e1123.member_2;
                                                    }
                                                    let _e1264 = phi_3963_;
                                                    phi_3964_ = _e1264;
                                                    phi_3965_ = (_e839 + 1u);
                                                } else {
                                                    phi_3964_ = type_64();
                                                    phi_3965_ = u32();
                                                }
                                                let _e1266 = phi_3964_;
                                                let _e1268 = phi_3965_;
                                                phi_3967_ = _e1266;
                                                phi_3968_ = _e1268;
                                                phi_3969_ = select(true, false, _e1224);
                                            } else {
                                                phi_3967_ = type_64();
                                                phi_3968_ = u32();
                                                phi_3969_ = true;
                                            }
                                            let _e1271 = phi_3967_;
                                            let _e1273 = phi_3968_;
                                            let _e1275 = phi_3969_;
                                            if _e1275 {
                                                if _e1223 {
                                                    phi_3978_ = _e1123.member_1;
                                                } else {
                                                    phi_3978_ = _e1123.member_2;
                                                }
                                                let _e1279 = phi_3978_;
                                                phi_3983_ = select(_e1224, true, _e1223);
                                                phi_3984_ = _e1279;
                                            } else {
                                                phi_3983_ = _e835;
                                                phi_3984_ = _e1271;
                                            }
                                            let _e1282 = phi_3983_;
                                            let _e1284 = phi_3984_;
                                            phi_4585_ = _e794;
                                            phi_3986_ = _e796;
                                            phi_3987_ = _e1282;
                                            phi_3988_ = _e1284;
                                            phi_3989_ = select(_e1273, _e839, _e1275);
                                        }
                                        let _e2076 = phi_4585_;
                                        let _e2078 = phi_3986_;
                                        let _e2080 = phi_3987_;
                                        let _e2082 = phi_3988_;
                                        let _e2084 = phi_3989_;
                                        phi_4584_ = _e2076;
                                        phi_3990_ = _e2078;
                                        phi_3991_ = _e2080;
                                        phi_3992_ = _e2082;
                                        phi_3993_ = _e2084;
                                        phi_3994_ = (_e804 - 1u);
                                    } else {
                                        phi_4584_ = _e794;
                                        phi_3990_ = _e796;
                                        phi_3991_ = _e835;
                                        phi_3992_ = _e837;
                                        phi_3993_ = _e839;
                                        phi_3994_ = _e804;
                                    }
                                    let _e2086 = phi_4584_;
                                    let _e2088 = phi_3990_;
                                    let _e2090 = phi_3991_;
                                    let _e2092 = phi_3992_;
                                    let _e2094 = phi_3993_;
                                    let _e2096 = phi_3994_;
                                    phi_4583_ = _e2086;
                                    phi_3995_ = _e2088;
                                    phi_3996_ = _e2090;
                                    phi_3997_ = _e2092;
                                    phi_3998_ = _e2094;
                                    phi_3999_ = _e2096;
                                } else {
                                    phi_4583_ = _e794;
                                    phi_3995_ = type_52();
                                    phi_3996_ = bool();
                                    phi_3997_ = type_64();
                                    phi_3998_ = u32();
                                    phi_3999_ = u32();
                                }
                                let _e2098 = phi_4583_;
                                let _e2100 = phi_3995_;
                                let _e2102 = phi_3996_;
                                let _e2104 = phi_3997_;
                                let _e2106 = phi_3998_;
                                let _e2108 = phi_3999_;
                                phi_4582_ = _e2098;
                                phi_1387_ = _e2100;
                                phi_1390_ = _e2102;
                                phi_1392_ = _e2104;
                                phi_1394_ = _e2106;
                                phi_1396_ = _e2108;
                                phi_4000_ = _e808;
                            } else {
                                phi_4582_ = _e794;
                                phi_1387_ = type_52();
                                phi_1390_ = bool();
                                phi_1392_ = type_64();
                                phi_1394_ = u32();
                                phi_1396_ = u32();
                                phi_4000_ = false;
                            }
                            let _e2110 = phi_4582_;
                            let _e2112 = phi_1387_;
                            let _e2114 = phi_1390_;
                            let _e2116 = phi_1392_;
                            let _e2118 = phi_1394_;
                            let _e2120 = phi_1396_;
                            let _e2122 = phi_4000_;
                            continue;
                            continuing {
                                phi_4402_ = _e2110;
                                phi_1386_ = _e2112;
                                phi_1389_ = _e2114;
                                phi_1391_ = _e2116;
                                phi_1393_ = _e2118;
                                phi_1395_ = _e2120;
                                phi_4581_ = _e2110;
                                break if !(_e2122);
                            }
                        }
                        let _e2125 = phi_4581_;
                        if _e2125 {
                            break;
                        }
                        let _e2127 = local_11;
                        if _e2127.member_1 {
                        } else {
                            if _e302 {
                            } else {
                                break;
                            }
                            let _e2131 = global_2.member[_e148];
                            if _e163 {
                            } else {
                                break;
                            }
                            let _e2135 = global_10.member[_e148].member_1;
                            if _e302 {
                            } else {
                                break;
                            }
                            global_2.member[_e148] = type_32(_e2131.member, _e2131.member_1, _e2131.member_2, array<f32, 3>((_e2131.member_3[0] + (_e2135[0] * _e2131.member_1[0])), (_e2131.member_3[1] + (_e2135[1] * _e2131.member_1[1])), (_e2131.member_3[2] + (_e2135[2] * _e2131.member_1[2]))), _e2131.member_4);
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
fn trace_shadows_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
