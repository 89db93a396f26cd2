struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: vec4<u32>,
}

struct type_18 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_20 {
    member: array<type_18>,
}

struct type_26 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_27 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_28 {
    member: type_27,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_30 {
    member: array<type_28>,
}

struct type_35 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_36 {
    member: type_27,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_38 {
    member: array<type_36>,
}

struct type_41 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_47 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_48 {
    member: f32,
    member_1: bool,
}

struct type_50 {
    member: array<vec4<u32>, 2>,
}

struct type_53 {
    member: array<i32>,
}

struct type_59 {
    member: array<array<u32, 7>>,
}

struct type_64 {
    member: type_35,
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
var<uniform> global_1: type_12;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_30;
@group(0) @binding(1) 
var<uniform> global_3: type_50;
@group(0) @binding(2) 
var<uniform> global_4: type_50;
@group(0) @binding(4) 
var<storage> global_5: type_20;
@group(0) @binding(5) 
var<storage> global_6: type_4;
@group(0) @binding(6) 
var<storage> global_7: type_53;
@group(0) @binding(9) 
var<storage, read_write> global_8: type_70;
@group(0) @binding(3) 
var<storage> global_9: type_59;
@group(0) @binding(7) 
var<storage> global_10: type_38;

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
    var phi_547_: type_41;
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
    var phi_1386_: type_48;
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
    var phi_1512_: type_48;
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
    var phi_2399_: type_47;
    var phi_2400_: type_47;
    var phi_2403_: type_47;
    var phi_2404_: type_47;
    var phi_2405_: bool;
    var phi_2409_: type_47;
    var phi_2418_: type_26;
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
    var phi_2758_: type_48;
    var phi_2759_: type_48;
    var phi_1513_: type_48;
    var phi_4396_: bool;
    var local_10: type_48;
    var phi_4585_: bool;
    var phi_3986_: type_48;
    var phi_3987_: bool;
    var phi_3988_: type_64;
    var phi_3989_: u32;
    var phi_4584_: bool;
    var phi_3990_: type_48;
    var phi_3991_: bool;
    var phi_3992_: type_64;
    var phi_3993_: u32;
    var phi_3994_: u32;
    var phi_4583_: bool;
    var phi_3995_: type_48;
    var phi_3996_: bool;
    var phi_3997_: type_64;
    var phi_3998_: u32;
    var phi_3999_: u32;
    var phi_4582_: bool;
    var phi_1387_: type_48;
    var phi_1390_: bool;
    var phi_1392_: type_64;
    var phi_1394_: u32;
    var phi_1396_: u32;
    var phi_4000_: bool;
    var phi_4581_: bool;
    var local_11: type_48;
    var local_12: type_48;

    switch bitcast<i32>(0u) {
        default: {
            let _e98 = global;
            let _e100 = arrayLength((&global_9.member));
            let _e102 = arrayLength((&global_5.member));
            let _e114 = arrayLength((&global_8.member));
            let _e118 = global_4.member[0u][0u];
            let _e122 = global_4.member[0u][1u];
            let _e126 = global_4.member[0u][2u];
            let _e130 = global_4.member[0u][3u];
            let _e134 = global_4.member[1u][0u];
            let _e138 = global_4.member[1u][1u];
            let _e142 = global_4.member[1u][2u];
            let _e146 = (_e98.x + (_e98.y * 2097152u));
            let _e158 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e130) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e118), bitcast<i32>(_e122), bitcast<i32>(_e126));
            local = array<i32, 3>(bitcast<i32>(_e134), bitcast<i32>(_e138), bitcast<i32>(_e142));
            let _e161 = (_e146 < arrayLength((&global_10.member)));
            if _e161 {
                if _e161 {
                } else {
                    break;
                }
                let _e165 = global_10.member[_e146].member_2;
                phi_363_ = _e165;
            } else {
                phi_363_ = 4294967295u;
            }
            let _e167 = phi_363_;
            let _e170 = global_1.member[0u];
            let _e174 = global_3.member[0u][0u];
            let _e178 = global_3.member[0u][1u];
            let _e182 = global_3.member[0u][2u];
            let _e186 = global_3.member[0u][3u];
            let _e190 = global_3.member[1u][0u];
            let _e194 = global_3.member[1u][1u];
            let _e198 = global_3.member[1u][2u];
            let _e202 = global_3.member[1u][3u];
            let _e203 = bitcast<f32>(_e174);
            let _e204 = bitcast<f32>(_e178);
            let _e205 = bitcast<f32>(_e182);
            let _e207 = bitcast<f32>(_e190);
            let _e208 = array<u32, 3>(_e194, _e198, _e202);
            let _e210 = bitcast<i32>(_e170);
            if (_e210 < -126i) {
                phi_407_ = -126i;
            } else {
                phi_407_ = select(_e210, 127i, (_e210 > 127i));
            }
            let _e215 = phi_407_;
            let _e220 = bitcast<f32>((bitcast<u32>((_e215 + 127i)) << bitcast<u32>(23i)));
            let _e226 = bitcast<f32>((bitcast<u32>(((_e210 - _e215) + 127i)) << bitcast<u32>(23i)));
            if (_e186 == 0u) {
                phi_547_ = type_41(array<f32, 3>(_e203, _e204, _e205), _e186, _e207, _e208);
            } else {
                let _e228 = bitcast<u32>(_e203);
                let _e230 = ((_e228 & 2139095040u) != 0u);
                let _e245 = bitcast<u32>(_e204);
                let _e247 = ((_e245 & 2139095040u) != 0u);
                let _e262 = bitcast<u32>(_e205);
                let _e264 = ((_e262 & 2139095040u) != 0u);
                let _e280 = bitcast<u32>(_e207);
                let _e282 = ((_e280 & 2139095040u) != 0u);
                phi_547_ = type_41(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e228 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e228 & 2147483648u))), _e203, _e230) * _e220) * select(0.00000011920929f, 1f, _e230)) * _e226), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e245 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e245 & 2147483648u))), _e204, _e247) * _e220) * select(0.00000011920929f, 1f, _e247)) * _e226), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e262 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e262 & 2147483648u))), _e205, _e264) * _e220) * select(0.00000011920929f, 1f, _e264)) * _e226)), _e186, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e280 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e280 & 2147483648u))), _e207, _e282) * _e220) * select(0.00000011920929f, 1f, _e282)) * _e226), _e208);
            }
            let _e299 = phi_547_;
            if _e161 {
                let _e300 = (_e146 < arrayLength((&global_2.member)));
                if _e300 {
                    if _e161 {
                    } else {
                        break;
                    }
                    let _e305 = global_10.member[_e146].member.member_1;
                    let _e310 = global_10.member[_e146].member.member_3;
                    if (_e305 <= _e310) {
                        let _e312 = (1u < _e114);
                        if _e312 {
                            if (0u < _e114) {
                            } else {
                                break;
                            }
                            let _e316 = atomicAdd((&global_8.member[0u]), 1u);
                            if ((_e316 + 1u) < _e316) {
                                if _e312 {
                                } else {
                                    break;
                                }
                                let _e321 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                        if _e161 {
                        } else {
                            break;
                        }
                        let _e331 = global_10.member[_e146].member.member_2[0u];
                        let _e333 = (bitcast<u32>(_e331) & 2147483647u);
                        let _e339 = global_10.member[_e146].member.member_2[1u];
                        let _e341 = (bitcast<u32>(_e339) & 2147483647u);
                        let _e347 = global_10.member[_e146].member.member_2[2u];
                        let _e349 = (bitcast<u32>(_e347) & 2147483647u);
                        let _e355 = global_10.member[_e146].member.member[0u];
                        let _e357 = (bitcast<u32>(_e355) & 2147483647u);
                        let _e363 = global_10.member[_e146].member.member[1u];
                        let _e365 = (bitcast<u32>(_e363) & 2147483647u);
                        let _e371 = global_10.member[_e146].member.member[2u];
                        let _e373 = (bitcast<u32>(_e371) & 2147483647u);
                        let _e375 = select(_e341, _e333, (_e341 < _e333));
                        let _e377 = select(_e349, _e375, (_e349 < _e375));
                        let _e379 = select(_e357, _e377, (_e357 < _e377));
                        let _e381 = select(_e365, _e379, (_e365 < _e379));
                        let _e383 = select(_e373, _e381, (_e373 < _e381));
                        let _e384 = bitcast<u32>(_e305);
                        let _e385 = (_e384 & 2147483647u);
                        let _e389 = bitcast<u32>(_e310);
                        let _e390 = (_e389 & 2147483647u);
                        let _e394 = (((select(_e385, _e383, (_e385 < _e383)) < 2139095040u) && (_e390 <= 2139095040u)) && (_e377 > 0u));
                        if _e394 {
                            let _e397 = (bitcast<u32>(bitcast<f32>(_e377)) & 2147483647u);
                            if (_e397 >= 8388608u) {
                                phi_697_ = (bitcast<i32>((_e397 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_697_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e397)), 32u, (_e397 == 0u))));
                            }
                            let _e411 = phi_697_;
                            phi_698_ = _e411;
                        } else {
                            phi_698_ = 0i;
                        }
                        let _e413 = phi_698_;
                        let _e414 = (_e333 == _e377);
                        if _e414 {
                            phi_708_ = true;
                        } else {
                            phi_708_ = (_e341 == _e377);
                        }
                        let _e417 = phi_708_;
                        let _e418 = select(1u, 0u, _e414);
                        if _e417 {
                            let _e419 = (_e418 + 1u);
                            phi_718_ = _e419;
                            phi_719_ = _e419;
                            phi_721_ = select(true, false, (_e419 == 2u));
                        } else {
                            phi_718_ = u32();
                            phi_719_ = 0u;
                            phi_721_ = true;
                        }
                        let _e423 = phi_718_;
                        let _e425 = phi_719_;
                        let _e427 = phi_721_;
                        if _e427 {
                            phi_726_ = (_e425 + 1u);
                        } else {
                            phi_726_ = 0u;
                        }
                        let _e431 = phi_726_;
                        let _e432 = select(_e423, _e425, _e427);
                        let _e433 = select(_e418, select(2u, _e418, _e417), _e427);
                        let _e434 = -(_e413);
                        if (_e434 < -126i) {
                            phi_759_ = -126i;
                        } else {
                            phi_759_ = select(_e434, 127i, (_e434 > 127i));
                        }
                        let _e439 = phi_759_;
                        let _e444 = bitcast<f32>((bitcast<u32>((_e439 + 127i)) << bitcast<u32>(23i)));
                        let _e450 = bitcast<f32>((bitcast<u32>(((_e434 - _e439) + 127i)) << bitcast<u32>(23i)));
                        let _e455 = global_10.member[_e146].member.member;
                        let _e456 = (_e432 == 0u);
                        if _e456 {
                            phi_777_ = _e455[0];
                        } else {
                            phi_777_ = _e455[1];
                        }
                        let _e460 = phi_777_;
                        let _e461 = (_e432 == 2u);
                        if _e461 {
                            phi_783_ = _e455[2];
                        } else {
                            phi_783_ = _e460;
                        }
                        let _e464 = phi_783_;
                        let _e465 = bitcast<u32>(_e464);
                        let _e467 = ((_e465 & 2139095040u) != 0u);
                        let _e479 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e465 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e465 & 2147483648u))), _e464, _e467) * select(0.00000011920929f, 1f, _e467));
                        let _e480 = global_10.member[_e146].member.member_2;
                        if _e456 {
                            phi_823_ = _e480[0];
                        } else {
                            phi_823_ = _e480[1];
                        }
                        let _e484 = phi_823_;
                        if _e461 {
                            phi_829_ = _e480[2];
                        } else {
                            phi_829_ = _e484;
                        }
                        let _e487 = phi_829_;
                        let _e488 = bitcast<u32>(_e487);
                        let _e490 = ((_e488 & 2139095040u) != 0u);
                        let _e504 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e488 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e488 & 2147483648u))), _e487, _e490) * _e444) * select(0.00000011920929f, 1f, _e490)) * _e450);
                        let _e508 = (bitcast<f32>((bitcast<u32>(_e504) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e511 = bitcast<f32>((bitcast<u32>(_e479) & 2147483647u));
                        let _e512 = (_e511 * 0.00000011920929f);
                        let _e515 = select(select(0.00000000000011368684f, _e512, (_e512 > 0.00000000000011368684f)), 0f, _e508);
                        let _e516 = select(0f, _e504, _e508);
                        let _e517 = (_e479 + _e515);
                        let _e518 = (_e479 - _e515);
                        let _e520 = select(38685626000000000000000000f, (1f / _e504), _e508);
                        let _e521 = (_e431 == 0u);
                        if _e521 {
                            phi_902_ = _e455[0];
                        } else {
                            phi_902_ = _e455[1];
                        }
                        let _e525 = phi_902_;
                        let _e526 = (_e431 == 2u);
                        if _e526 {
                            phi_908_ = _e455[2];
                        } else {
                            phi_908_ = _e525;
                        }
                        let _e529 = phi_908_;
                        let _e530 = bitcast<u32>(_e529);
                        let _e532 = ((_e530 & 2139095040u) != 0u);
                        let _e544 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e530 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e530 & 2147483648u))), _e529, _e532) * select(0.00000011920929f, 1f, _e532));
                        if _e521 {
                            phi_948_ = _e480[0];
                        } else {
                            phi_948_ = _e480[1];
                        }
                        let _e548 = phi_948_;
                        if _e526 {
                            phi_954_ = _e480[2];
                        } else {
                            phi_954_ = _e548;
                        }
                        let _e551 = phi_954_;
                        let _e552 = bitcast<u32>(_e551);
                        let _e554 = ((_e552 & 2139095040u) != 0u);
                        let _e568 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e552 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e552 & 2147483648u))), _e551, _e554) * _e444) * select(0.00000011920929f, 1f, _e554)) * _e450);
                        let _e572 = (bitcast<f32>((bitcast<u32>(_e568) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e575 = bitcast<f32>((bitcast<u32>(_e544) & 2147483647u));
                        let _e576 = (_e575 * 0.00000011920929f);
                        let _e579 = select(select(0.00000000000011368684f, _e576, (_e576 > 0.00000000000011368684f)), 0f, _e572);
                        let _e580 = select(0f, _e568, _e572);
                        let _e581 = (_e544 + _e579);
                        let _e582 = (_e544 - _e579);
                        let _e584 = select(38685626000000000000000000f, (1f / _e568), _e572);
                        let _e585 = (_e433 == 0u);
                        if _e585 {
                            phi_1027_ = _e455[0];
                        } else {
                            phi_1027_ = _e455[1];
                        }
                        let _e589 = phi_1027_;
                        let _e590 = (_e433 == 2u);
                        if _e590 {
                            phi_1033_ = _e455[2];
                        } else {
                            phi_1033_ = _e589;
                        }
                        let _e593 = phi_1033_;
                        let _e594 = bitcast<u32>(_e593);
                        let _e596 = ((_e594 & 2139095040u) != 0u);
                        let _e608 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e594 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e594 & 2147483648u))), _e593, _e596) * select(0.00000011920929f, 1f, _e596));
                        if _e585 {
                            phi_1073_ = _e480[0];
                        } else {
                            phi_1073_ = _e480[1];
                        }
                        let _e612 = phi_1073_;
                        if _e590 {
                            phi_1079_ = _e480[2];
                        } else {
                            phi_1079_ = _e612;
                        }
                        let _e615 = phi_1079_;
                        let _e616 = bitcast<u32>(_e615);
                        let _e618 = ((_e616 & 2139095040u) != 0u);
                        let _e632 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e616 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e616 & 2147483648u))), _e615, _e618) * _e444) * select(0.00000011920929f, 1f, _e618)) * _e450);
                        let _e636 = (bitcast<f32>((bitcast<u32>(_e632) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e639 = bitcast<f32>((bitcast<u32>(_e608) & 2147483647u));
                        let _e640 = (_e639 * 0.00000011920929f);
                        let _e643 = select(select(0.00000000000011368684f, _e640, (_e640 > 0.00000000000011368684f)), 0f, _e636);
                        let _e644 = select(0f, _e632, _e636);
                        let _e645 = (_e608 + _e643);
                        let _e646 = (_e608 - _e643);
                        let _e648 = select(38685626000000000000000000f, (1f / _e632), _e636);
                        let _e650 = select(_e575, _e511, (_e511 > _e575));
                        if (_e394 && (select(_e639, _e650, (_e650 > _e639)) <= 1099511600000f)) {
                            let _e662 = ((_e385 & 8388607u) | (select(0u, 1u, ((_e385 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e665 = bitcast<i32>((_e385 >> bitcast<u32>(23i)));
                            let _e669 = (_e662 == 0u);
                            let _e672 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e662)), 32u, _e669)) - 8i);
                            if (_e665 == 255i) {
                                phi_1198_ = 255i;
                            } else {
                                phi_1198_ = (((_e665 + select(0i, 1i, (_e665 == 0i))) - _e672) + _e413);
                            }
                            let _e680 = phi_1198_;
                            let _e690 = (_e680 <= 0i);
                            if _e690 {
                                phi_1221_ = u32();
                            } else {
                                if _e669 {
                                    phi_1220_ = u32();
                                } else {
                                    phi_1220_ = select(((bitcast<u32>(_e680) << bitcast<u32>(23i)) | ((_e662 << bitcast<u32>(((_e672 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e680 >= 255i));
                                }
                                let _e694 = phi_1220_;
                                phi_1221_ = _e694;
                            }
                            let _e696 = phi_1221_;
                            let _e708 = ((_e390 & 8388607u) | (select(0u, 1u, ((_e390 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e711 = bitcast<i32>((_e390 >> bitcast<u32>(23i)));
                            let _e715 = (_e708 == 0u);
                            let _e718 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e708)), 32u, _e715)) - 8i);
                            if (_e711 == 255i) {
                                phi_1258_ = 255i;
                            } else {
                                phi_1258_ = (((_e711 + select(0i, 1i, (_e711 == 0i))) - _e718) + _e413);
                            }
                            let _e726 = phi_1258_;
                            let _e736 = (_e726 <= 0i);
                            if _e736 {
                                phi_1281_ = u32();
                            } else {
                                if _e715 {
                                    phi_1280_ = u32();
                                } else {
                                    phi_1280_ = select(((bitcast<u32>(_e726) << bitcast<u32>(23i)) | ((_e708 << bitcast<u32>(((_e718 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e726 >= 255i));
                                }
                                let _e740 = phi_1280_;
                                phi_1281_ = _e740;
                            }
                            let _e742 = phi_1281_;
                            phi_1289_ = bitcast<f32>(((_e389 & 2147483648u) | select(_e742, 0u, select(_e715, true, _e736))));
                            phi_1290_ = bitcast<f32>(((_e384 & 2147483648u) | select(_e696, 0u, select(_e669, true, _e690))));
                        } else {
                            phi_1289_ = 0f;
                            phi_1290_ = 1f;
                        }
                        let _e748 = phi_1289_;
                        let _e750 = phi_1290_;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e756 = (_e432 % 3u);
                        let _e757 = (_e756 < 3u);
                        if _e757 {
                        } else {
                            break;
                        }
                        let _e759 = local_1[_e756];
                        let _e762 = (_e431 % 3u);
                        let _e763 = (_e762 < 3u);
                        if _e763 {
                        } else {
                            break;
                        }
                        let _e765 = local_1[_e762];
                        let _e768 = (_e433 % 3u);
                        let _e769 = (_e768 < 3u);
                        if _e769 {
                        } else {
                            break;
                        }
                        let _e771 = local_1[_e768];
                        if _e757 {
                        } else {
                            break;
                        }
                        let _e776 = local[_e756];
                        if _e763 {
                        } else {
                            break;
                        }
                        let _e780 = local[_e762];
                        if _e769 {
                        } else {
                            break;
                        }
                        let _e784 = local[_e768];
                        phi_4402_ = false;
                        phi_1386_ = type_48(_e748, false);
                        phi_1389_ = (_e750 <= _e748);
                        phi_1391_ = type_64(type_35(vec4<f32>((f32(_e759) * _e158), (f32(_e765) * _e158), (f32(_e771) * _e158), 0f), vec4<f32>((f32(_e776) * _e158), (f32(_e780) * _e158), (f32(_e784) * _e158), 0f)), select(0u, 2147483648u, (_e100 == 0u)));
                        phi_1393_ = 0u;
                        phi_1395_ = ((3u * _e100) + 1u);
                        loop {
                            let _e792 = phi_4402_;
                            let _e794 = phi_1386_;
                            let _e796 = phi_1389_;
                            let _e798 = phi_1391_;
                            let _e800 = phi_1393_;
                            let _e802 = phi_1395_;
                            local_11 = _e794;
                            if _e796 {
                                phi_1406_ = true;
                            } else {
                                phi_1406_ = (_e800 > 0u);
                            }
                            let _e805 = phi_1406_;
                            if _e805 {
                                let _e806 = (_e802 > 0u);
                                if _e806 {
                                    if _e796 {
                                        phi_1492_ = _e796;
                                        phi_1493_ = _e798;
                                        phi_1494_ = _e800;
                                    } else {
                                        let _e807 = (_e800 - 1u);
                                        let _e808 = (_e807 % 128u);
                                        let _e809 = (_e808 < 128u);
                                        if _e809 {
                                        } else {
                                            phi_4581_ = true;
                                            break;
                                        }
                                        let _e811 = local_7[_e808];
                                        if _e809 {
                                        } else {
                                            phi_4581_ = true;
                                            break;
                                        }
                                        let _e813 = local_6[_e808];
                                        if _e809 {
                                        } else {
                                            phi_4581_ = true;
                                            break;
                                        }
                                        let _e815 = local_5[_e808];
                                        if _e809 {
                                        } else {
                                            phi_4581_ = true;
                                            break;
                                        }
                                        let _e817 = local_4[_e808];
                                        if _e809 {
                                        } else {
                                            phi_4581_ = true;
                                            break;
                                        }
                                        let _e819 = local_3[_e808];
                                        if _e809 {
                                        } else {
                                            phi_4581_ = true;
                                            break;
                                        }
                                        let _e821 = local_2[_e808];
                                        if _e809 {
                                        } else {
                                            phi_4581_ = true;
                                            break;
                                        }
                                        let _e826 = local_8[_e808];
                                        if _e809 {
                                        } else {
                                            phi_4581_ = true;
                                            break;
                                        }
                                        let _e829 = local_9[_e808];
                                        phi_1492_ = (_e829 <= _e794.member);
                                        phi_1493_ = type_64(type_35(vec4<f32>(_e811, _e813, _e815, 0f), vec4<f32>(_e817, _e819, _e821, 0f)), _e826);
                                        phi_1494_ = _e807;
                                    }
                                    let _e833 = phi_1492_;
                                    let _e835 = phi_1493_;
                                    let _e837 = phi_1494_;
                                    if _e833 {
                                        if ((_e835.member_1 & 2147483648u) != 0u) {
                                            phi_1512_ = _e794;
                                            phi_1515_ = type_8(0u, ((_e835.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1304 = phi_1512_;
                                                let _e1306 = phi_1515_;
                                                local_10 = _e1304;
                                                local_12 = _e1304;
                                                if (_e1306.member < _e1306.member_1) {
                                                    phi_1516_ = type_8((_e1306.member + 1u), _e1306.member_1);
                                                    phi_1538_ = type_8(1u, _e1306.member);
                                                } else {
                                                    phi_1516_ = _e1306;
                                                    phi_1538_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1319 = phi_1516_;
                                                let _e1321 = phi_1538_;
                                                let _e1325 = (bitcast<i32>(_e1321.member) != 0i);
                                                if _e1325 {
                                                    let _e1326 = ((_e835.member_1 & 268435455u) + _e1321.member_1);
                                                    let _e1327 = (_e1326 < _e102);
                                                    if _e1327 {
                                                        if _e1327 {
                                                        } else {
                                                            phi_4396_ = true;
                                                            break;
                                                        }
                                                        let _e1331 = global_5.member[_e1326].member_1;
                                                        phi_1559_ = _e1331;
                                                    } else {
                                                        phi_1559_ = 4294967295u;
                                                    }
                                                    let _e1333 = phi_1559_;
                                                    if (_e1326 >= _e102) {
                                                        phi_1651_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1327 {
                                                        } else {
                                                            phi_4396_ = true;
                                                            break;
                                                        }
                                                        if (_e756 < 9u) {
                                                        } else {
                                                            phi_4396_ = true;
                                                            break;
                                                        }
                                                        let _e1340 = global_5.member[_e1326].member[_e756];
                                                        if (_e762 < 9u) {
                                                        } else {
                                                            phi_4396_ = true;
                                                            break;
                                                        }
                                                        let _e1346 = global_5.member[_e1326].member[_e762];
                                                        if (_e768 < 9u) {
                                                        } else {
                                                            phi_4396_ = true;
                                                            break;
                                                        }
                                                        let _e1352 = global_5.member[_e1326].member[_e768];
                                                        let _e1354 = (3u + _e756);
                                                        if (_e1354 < 9u) {
                                                        } else {
                                                            phi_4396_ = true;
                                                            break;
                                                        }
                                                        let _e1360 = global_5.member[_e1326].member[_e1354];
                                                        let _e1361 = (3u + _e762);
                                                        if (_e1361 < 9u) {
                                                        } else {
                                                            phi_4396_ = true;
                                                            break;
                                                        }
                                                        let _e1367 = global_5.member[_e1326].member[_e1361];
                                                        let _e1368 = (3u + _e768);
                                                        if (_e1368 < 9u) {
                                                        } else {
                                                            phi_4396_ = true;
                                                            break;
                                                        }
                                                        let _e1374 = global_5.member[_e1326].member[_e1368];
                                                        let _e1376 = (6u + _e756);
                                                        if (_e1376 < 9u) {
                                                        } else {
                                                            phi_4396_ = true;
                                                            break;
                                                        }
                                                        let _e1382 = global_5.member[_e1326].member[_e1376];
                                                        let _e1383 = (6u + _e762);
                                                        if (_e1383 < 9u) {
                                                        } else {
                                                            phi_4396_ = true;
                                                            break;
                                                        }
                                                        let _e1389 = global_5.member[_e1326].member[_e1383];
                                                        let _e1390 = (6u + _e768);
                                                        if (_e1390 < 9u) {
                                                        } else {
                                                            phi_4396_ = true;
                                                            break;
                                                        }
                                                        let _e1396 = global_5.member[_e1326].member[_e1390];
                                                        phi_1651_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1340, _e1346, _e1352), array<f32, 3>(_e1360, _e1367, _e1374), array<f32, 3>(_e1382, _e1389, _e1396));
                                                    }
                                                    let _e1400 = phi_1651_;
                                                    let _e1416 = (_e1400[0][2] - _e608);
                                                    let _e1419 = (((_e1400[0][0] - _e479) * _e644) - (_e1416 * _e516));
                                                    let _e1422 = (((_e1400[0][1] - _e544) * _e644) - (_e1416 * _e580));
                                                    let _e1425 = (_e1400[1][2] - _e608);
                                                    let _e1428 = (((_e1400[1][0] - _e479) * _e644) - (_e1425 * _e516));
                                                    let _e1431 = (((_e1400[1][1] - _e544) * _e644) - (_e1425 * _e580));
                                                    let _e1434 = (_e1400[2][2] - _e608);
                                                    let _e1437 = (((_e1400[2][0] - _e479) * _e644) - (_e1434 * _e516));
                                                    let _e1440 = (((_e1400[2][1] - _e544) * _e644) - (_e1434 * _e580));
                                                    let _e1441 = (_e1437 * _e1431);
                                                    let _e1442 = (_e1440 * _e1428);
                                                    let _e1443 = (_e1419 * _e1440);
                                                    let _e1444 = (_e1422 * _e1437);
                                                    let _e1445 = (_e1428 * _e1422);
                                                    let _e1446 = (_e1431 * _e1419);
                                                    let _e1451 = (((_e1441 >= _e1442) && (_e1443 >= _e1444)) && (_e1445 >= _e1446));
                                                    let _e1457 = (_e1451 || (((_e1441 <= _e1442) && (_e1443 <= _e1444)) && (_e1445 <= _e1446)));
                                                    if _e1457 {
                                                        let _e1459 = select(-1f, 1f, _e1451);
                                                        let _e1461 = ((_e1441 - _e1442) * _e1459);
                                                        let _e1463 = select(0f, _e1461, (_e1461 > 0f));
                                                        let _e1465 = ((_e1443 - _e1444) * _e1459);
                                                        let _e1467 = select(0f, _e1465, (_e1465 > 0f));
                                                        let _e1469 = ((_e1445 - _e1446) * _e1459);
                                                        let _e1471 = select(0f, _e1469, (_e1469 > 0f));
                                                        let _e1473 = ((_e1463 + _e1467) + _e1471);
                                                        let _e1475 = select(_e1400[1][0], _e1400[0][0], (_e1400[0][0] < _e1400[1][0]));
                                                        let _e1479 = select(_e1400[1][0], _e1400[0][0], (_e1400[0][0] > _e1400[1][0]));
                                                        let _e1483 = select(_e1400[1][1], _e1400[0][1], (_e1400[0][1] < _e1400[1][1]));
                                                        let _e1487 = select(_e1400[1][1], _e1400[0][1], (_e1400[0][1] > _e1400[1][1]));
                                                        let _e1491 = select(_e1400[1][2], _e1400[0][2], (_e1400[0][2] < _e1400[1][2]));
                                                        let _e1495 = select(_e1400[1][2], _e1400[0][2], (_e1400[0][2] > _e1400[1][2]));
                                                        let _e1500 = ((select(_e1400[2][0], _e1475, (_e1475 < _e1400[2][0])) - _e517) * _e520);
                                                        let _e1501 = ((select(_e1400[2][0], _e1479, (_e1479 > _e1400[2][0])) - _e518) * _e520);
                                                        let _e1504 = ((select(_e1400[2][1], _e1483, (_e1483 < _e1400[2][1])) - _e581) * _e584);
                                                        let _e1505 = ((select(_e1400[2][1], _e1487, (_e1487 > _e1400[2][1])) - _e582) * _e584);
                                                        let _e1508 = ((select(_e1400[2][2], _e1491, (_e1491 < _e1400[2][2])) - _e645) * _e648);
                                                        let _e1509 = ((select(_e1400[2][2], _e1495, (_e1495 > _e1400[2][2])) - _e646) * _e648);
                                                        let _e1511 = select(_e1509, _e1508, (_e1508 < _e1509));
                                                        let _e1513 = select(_e1509, _e1508, (_e1508 > _e1509));
                                                        let _e1515 = select(_e1501, _e1500, (_e1500 < _e1501));
                                                        let _e1517 = select(_e1505, _e1504, (_e1504 < _e1505));
                                                        let _e1519 = select(_e1517, _e1515, (_e1515 > _e1517));
                                                        let _e1521 = select(_e1511, _e1519, (_e1519 > _e1511));
                                                        let _e1523 = select(_e1501, _e1500, (_e1500 > _e1501));
                                                        let _e1525 = select(_e1505, _e1504, (_e1504 > _e1505));
                                                        let _e1527 = select(_e1525, _e1523, (_e1523 < _e1525));
                                                        let _e1529 = select(_e1513, _e1527, (_e1527 < _e1513));
                                                        let _e1530 = -(_e1511);
                                                        let _e1536 = select(_e750, _e1521, (_e1521 > _e750));
                                                        let _e1540 = select(_e1428, _e1419, (_e1419 < _e1428));
                                                        let _e1545 = select(_e1428, _e1419, (_e1419 > _e1428));
                                                        let _e1552 = select(_e1431, _e1422, (_e1422 < _e1431));
                                                        let _e1557 = select(_e1431, _e1422, (_e1422 > _e1431));
                                                        let _e1566 = (((((_e1457 && (_e1473 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1437, _e1540, (_e1540 < _e1437)) <= 0f) && (select(_e1437, _e1545, (_e1545 > _e1437)) >= 0f))) && ((select(_e1440, _e1552, (_e1552 < _e1440)) <= 0f) && (select(_e1440, _e1557, (_e1557 > _e1440)) >= 0f))) && (_e1536 <= (_e1529 + (select(_e1530, _e1513, (_e1513 > _e1530)) * 0.0000019073523f)))) && (_e1536 <= _e1304.member));
                                                        if _e1566 {
                                                            let _e1571 = (_e1400[1][0] - _e1400[0][0]);
                                                            let _e1572 = (_e1400[1][1] - _e1400[0][1]);
                                                            let _e1573 = (_e1400[1][2] - _e1400[0][2]);
                                                            let _e1574 = vec3<f32>(_e1571, _e1572, _e1573);
                                                            let _e1575 = (_e1400[2][0] - _e1400[1][0]);
                                                            let _e1576 = (_e1400[2][1] - _e1400[1][1]);
                                                            let _e1577 = (_e1400[2][2] - _e1400[1][2]);
                                                            let _e1578 = vec3<f32>(_e1575, _e1576, _e1577);
                                                            let _e1579 = (_e1400[0][0] - _e1400[2][0]);
                                                            let _e1580 = (_e1400[0][1] - _e1400[2][1]);
                                                            let _e1581 = (_e1400[0][2] - _e1400[2][2]);
                                                            let _e1582 = vec3<f32>(_e1579, _e1580, _e1581);
                                                            let _e1585 = bitcast<f32>((bitcast<u32>(_e1571) & 2147483647u));
                                                            let _e1588 = bitcast<f32>((bitcast<u32>(_e1572) & 2147483647u));
                                                            let _e1590 = select(_e1588, _e1585, (_e1585 > _e1588));
                                                            let _e1593 = bitcast<f32>((bitcast<u32>(_e1573) & 2147483647u));
                                                            let _e1595 = select(_e1593, _e1590, (_e1590 > _e1593));
                                                            let _e1598 = bitcast<f32>((bitcast<u32>(_e1575) & 2147483647u));
                                                            let _e1601 = bitcast<f32>((bitcast<u32>(_e1576) & 2147483647u));
                                                            let _e1603 = select(_e1601, _e1598, (_e1598 > _e1601));
                                                            let _e1606 = bitcast<f32>((bitcast<u32>(_e1577) & 2147483647u));
                                                            let _e1608 = select(_e1606, _e1603, (_e1603 > _e1606));
                                                            let _e1611 = bitcast<f32>((bitcast<u32>(_e1579) & 2147483647u));
                                                            let _e1614 = bitcast<f32>((bitcast<u32>(_e1580) & 2147483647u));
                                                            let _e1616 = select(_e1614, _e1611, (_e1611 > _e1614));
                                                            let _e1619 = bitcast<f32>((bitcast<u32>(_e1581) & 2147483647u));
                                                            let _e1621 = select(_e1619, _e1616, (_e1616 > _e1619));
                                                            let _e1623 = select(_e1608, _e1595, (_e1595 > _e1608));
                                                            let _e1625 = select(_e1621, _e1623, (_e1623 > _e1621));
                                                            if (_e1595 == _e1625) {
                                                                phi_2181_ = _e1431;
                                                                phi_2182_ = _e1428;
                                                                phi_2183_ = _e1422;
                                                                phi_2184_ = _e1419;
                                                                phi_2185_ = vec3<f32>(_e1400[0][0], _e1400[0][1], _e1400[0][2]);
                                                                phi_2186_ = _e1582;
                                                                phi_2187_ = _e1578;
                                                                phi_2188_ = _e1574;
                                                            } else {
                                                                let _e1627 = (_e1608 == _e1625);
                                                                let _e1632 = vec3(_e1627);
                                                                phi_2181_ = select(_e1422, _e1440, _e1627);
                                                                phi_2182_ = select(_e1419, _e1437, _e1627);
                                                                phi_2183_ = select(_e1440, _e1431, _e1627);
                                                                phi_2184_ = select(_e1437, _e1428, _e1627);
                                                                phi_2185_ = select(vec3<f32>(_e1400[2][0], _e1400[2][1], _e1400[2][2]), vec3<f32>(_e1400[1][0], _e1400[1][1], _e1400[1][2]), _e1632);
                                                                phi_2186_ = select(_e1578, _e1574, _e1632);
                                                                phi_2187_ = select(_e1574, _e1582, _e1632);
                                                                phi_2188_ = select(_e1582, _e1578, _e1632);
                                                            }
                                                            let _e1638 = phi_2181_;
                                                            let _e1640 = phi_2182_;
                                                            let _e1642 = phi_2183_;
                                                            let _e1644 = phi_2184_;
                                                            let _e1646 = phi_2185_;
                                                            let _e1648 = phi_2186_;
                                                            let _e1650 = phi_2187_;
                                                            let _e1652 = phi_2188_;
                                                            let _e1659 = ((_e1650.y * _e1648.z) - (_e1648.y * _e1650.z));
                                                            let _e1664 = ((_e1650.z * _e1648.x) - (_e1648.z * _e1650.x));
                                                            let _e1667 = ((_e1650.x * _e1648.y) - (_e1648.x * _e1650.y));
                                                            let _e1670 = ((_e1463 >= _e1467) && (_e1463 >= _e1471));
                                                            let _e1671 = (_e1467 >= _e1471);
                                                            let _e1685 = (((_e1659 * (select(select(_e1400[2][0], _e1400[1][0], _e1671), _e1400[0][0], _e1670) - _e479)) + (_e1664 * (select(select(_e1400[2][1], _e1400[1][1], _e1671), _e1400[0][1], _e1670) - _e544))) + (_e1667 * (select(select(_e1400[2][2], _e1400[1][2], _e1671), _e1400[0][2], _e1670) - _e608)));
                                                            let _e1690 = (((_e1659 * _e516) + (_e1664 * _e580)) + (_e1667 * _e644));
                                                            let _e1691 = (_e1640 - _e1644);
                                                            let _e1692 = (_e1638 - _e1642);
                                                            let _e1695 = ((_e1691 * _e1691) + (_e1692 * _e1692));
                                                            let _e1702 = (-(((_e1644 * _e1691) + (_e1642 * _e1692))) / select(0.000000000000000000000000000000000000011754944f, _e1695, (_e1695 > 0.000000000000000000000000000000000000011754944f)));
                                                            let _e1704 = select(1f, _e1702, (_e1702 < 1f));
                                                            let _e1706 = select(0f, _e1704, (_e1704 > 0f));
                                                            let _e1715 = ((_e1646.x + (_e1652.x * _e1706)) - _e479);
                                                            let _e1718 = ((_e1646.y + (_e1652.y * _e1706)) - _e544);
                                                            let _e1721 = ((_e1646.z + (_e1652.z * _e1706)) - _e608);
                                                            let _e1724 = bitcast<f32>((bitcast<u32>(_e1715) & 2147483647u));
                                                            let _e1727 = bitcast<f32>((bitcast<u32>(_e1718) & 2147483647u));
                                                            let _e1729 = select(_e1727, _e1724, (_e1724 > _e1727));
                                                            let _e1732 = bitcast<f32>((bitcast<u32>(_e1721) & 2147483647u));
                                                            let _e1734 = select(_e1732, _e1729, (_e1729 > _e1732));
                                                            let _e1740 = bitcast<f32>((bitcast<u32>(_e1659) & 2147483647u));
                                                            let _e1743 = bitcast<f32>((bitcast<u32>(_e1664) & 2147483647u));
                                                            let _e1745 = select(_e1743, _e1740, (_e1740 > _e1743));
                                                            let _e1748 = bitcast<f32>((bitcast<u32>(_e1667) & 2147483647u));
                                                            let _e1767 = bitcast<f32>((bitcast<u32>(_e1650.x) & 2147483647u));
                                                            let _e1770 = bitcast<f32>((bitcast<u32>(_e1650.y) & 2147483647u));
                                                            let _e1772 = select(_e1770, _e1767, (_e1767 > _e1770));
                                                            let _e1775 = bitcast<f32>((bitcast<u32>(_e1650.z) & 2147483647u));
                                                            let _e1781 = bitcast<f32>((bitcast<u32>(_e1648.x) & 2147483647u));
                                                            let _e1784 = bitcast<f32>((bitcast<u32>(_e1648.y) & 2147483647u));
                                                            let _e1786 = select(_e1784, _e1781, (_e1781 > _e1784));
                                                            let _e1789 = bitcast<f32>((bitcast<u32>(_e1648.z) & 2147483647u));
                                                            let _e1795 = ((bitcast<f32>((bitcast<u32>(((((_e1659 * _e1715) + (_e1664 * _e1718)) + (_e1667 * _e1721)) - _e1685)) & 2147483647u)) <= ((0.0000009536743f * select(_e1625, _e1734, (_e1734 > _e1625))) * select(_e1748, _e1745, (_e1745 > _e1748)))) && !((bitcast<f32>((bitcast<u32>(_e1690) & 2147483647u)) <= ((0.0000038146973f * select(_e1775, _e1772, (_e1772 > _e1775))) * select(_e1789, _e1786, (_e1786 > _e1789))))));
                                                            let _e1796 = (_e1685 / _e1690);
                                                            if (_e1566 && !(_e1795)) {
                                                                let _e1799 = (_e1721 / _e644);
                                                                let _e1807 = (((_e1659 * (_e1715 - (_e516 * _e1799))) + (_e1664 * (_e1718 - (_e580 * _e1799)))) / _e1690);
                                                                phi_2379_ = select(select(_e1799, (_e1799 + _e1807), (bitcast<f32>((bitcast<u32>(_e1807) & 2147483647u)) <= _e1625)), _e1796, _e1795);
                                                            } else {
                                                                phi_2379_ = _e1796;
                                                            }
                                                            let _e1816 = phi_2379_;
                                                            let _e1818 = select(_e1529, _e1816, (_e1816 < _e1529));
                                                            let _e1820 = select(_e1521, _e1818, (_e1818 > _e1521));
                                                            let _e1821 = (1f / _e1473);
                                                            phi_2399_ = type_47(_e1820, (_e1467 * _e1821), (_e1471 * _e1821), ((_e1566 && (_e1820 >= _e750)) && (_e1820 <= _e1304.member)));
                                                            phi_2400_ = type_47();
                                                        } else {
                                                            phi_2399_ = type_47();
                                                            phi_2400_ = type_47(0f, 0f, 0f, _e1566);
                                                        }
                                                        let _e1830 = phi_2399_;
                                                        let _e1832 = phi_2400_;
                                                        phi_2403_ = _e1830;
                                                        phi_2404_ = _e1832;
                                                        phi_2405_ = select(true, false, _e1566);
                                                    } else {
                                                        phi_2403_ = type_47();
                                                        phi_2404_ = type_47(0f, 0f, 0f, _e1457);
                                                        phi_2405_ = true;
                                                    }
                                                    let _e1835 = phi_2403_;
                                                    let _e1837 = phi_2404_;
                                                    let _e1839 = phi_2405_;
                                                    if _e1839 {
                                                        phi_2409_ = _e1837;
                                                    } else {
                                                        phi_2409_ = _e1835;
                                                    }
                                                    let _e1841 = phi_2409_;
                                                    if _e1841.member_3 {
                                                        phi_2418_ = type_26(_e1841.member, _e1841.member_1, _e1841.member_2, _e1333);
                                                    } else {
                                                        phi_2418_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    }
                                                    let _e1848 = phi_2418_;
                                                    if (_e1848.member_3 != 4294967295u) {
                                                        if (_e1333 == _e167) {
                                                            phi_2753_ = false;
                                                        } else {
                                                            let _e1852 = (_e1333 < arrayLength((&global_6.member)));
                                                            if _e1852 {
                                                                if _e1852 {
                                                                } else {
                                                                    phi_4396_ = true;
                                                                    break;
                                                                }
                                                                let _e1854 = global_6.member[_e1333];
                                                                phi_2441_ = _e1854;
                                                            } else {
                                                                phi_2441_ = 4294967295u;
                                                            }
                                                            let _e1856 = phi_2441_;
                                                            let _e1857 = (_e1856 < arrayLength((&global_7.member)));
                                                            if _e1857 {
                                                                if _e1857 {
                                                                } else {
                                                                    phi_4396_ = true;
                                                                    break;
                                                                }
                                                                let _e1859 = global_7.member[_e1856];
                                                                phi_2455_ = _e1859;
                                                            } else {
                                                                phi_2455_ = 0i;
                                                            }
                                                            let _e1861 = phi_2455_;
                                                            let _e1862 = (_e1861 == 0i);
                                                            if _e1862 {
                                                                phi_2752_ = true;
                                                            } else {
                                                                if _e456 {
                                                                    phi_2478_ = vec3<f32>(_e1400[0][0], _e1400[0][1], _e1400[0][2]);
                                                                } else {
                                                                    if (_e432 == 1u) {
                                                                        phi_2477_ = vec3<f32>(_e1400[0][2], _e1400[0][0], _e1400[0][1]);
                                                                    } else {
                                                                        phi_2477_ = vec3<f32>(_e1400[0][1], _e1400[0][2], _e1400[0][0]);
                                                                    }
                                                                    let _e1867 = phi_2477_;
                                                                    phi_2478_ = _e1867;
                                                                }
                                                                let _e1870 = phi_2478_;
                                                                if _e456 {
                                                                    phi_2497_ = vec3<f32>(_e1400[1][0], _e1400[1][1], _e1400[1][2]);
                                                                } else {
                                                                    if (_e432 == 1u) {
                                                                        phi_2496_ = vec3<f32>(_e1400[1][2], _e1400[1][0], _e1400[1][1]);
                                                                    } else {
                                                                        phi_2496_ = vec3<f32>(_e1400[1][1], _e1400[1][2], _e1400[1][0]);
                                                                    }
                                                                    let _e1875 = phi_2496_;
                                                                    phi_2497_ = _e1875;
                                                                }
                                                                let _e1878 = phi_2497_;
                                                                if _e456 {
                                                                    phi_2516_ = vec3<f32>(_e1400[2][0], _e1400[2][1], _e1400[2][2]);
                                                                } else {
                                                                    if (_e432 == 1u) {
                                                                        phi_2515_ = vec3<f32>(_e1400[2][2], _e1400[2][0], _e1400[2][1]);
                                                                    } else {
                                                                        phi_2515_ = vec3<f32>(_e1400[2][1], _e1400[2][2], _e1400[2][0]);
                                                                    }
                                                                    let _e1883 = phi_2515_;
                                                                    phi_2516_ = _e1883;
                                                                }
                                                                let _e1886 = phi_2516_;
                                                                let _e1889 = (_e1878.x - _e1870.x);
                                                                let _e1892 = (_e1878.y - _e1870.y);
                                                                let _e1895 = (_e1878.z - _e1870.z);
                                                                let _e1897 = (_e1886.x - _e1870.x);
                                                                let _e1899 = (_e1886.y - _e1870.y);
                                                                let _e1901 = (_e1886.z - _e1870.z);
                                                                if (_e299.member_1 == 1u) {
                                                                    phi_2552_ = (vec3<f32>(_e299.member[0], _e299.member[1], _e299.member[2]) - _e1870);
                                                                } else {
                                                                    phi_2552_ = vec3<f32>(_e299.member[0], _e299.member[1], _e299.member[2]);
                                                                }
                                                                let _e1916 = phi_2552_;
                                                                let _e1922 = bitcast<f32>((bitcast<u32>((_e1889 * _e1899)) ^ _e299.member_3[0]));
                                                                let _e1926 = bitcast<f32>((bitcast<u32>((_e1892 * _e1897)) ^ _e299.member_3[0]));
                                                                let _e1930 = bitcast<f32>((bitcast<u32>((_e1892 * _e1901)) ^ _e299.member_3[0]));
                                                                let _e1934 = bitcast<f32>((bitcast<u32>((_e1895 * _e1899)) ^ _e299.member_3[0]));
                                                                let _e1938 = bitcast<f32>((bitcast<u32>((_e1895 * _e1897)) ^ _e299.member_3[0]));
                                                                let _e1942 = bitcast<f32>((bitcast<u32>((_e1889 * _e1901)) ^ _e299.member_3[0]));
                                                                let _e1943 = (_e1930 - _e1934);
                                                                let _e1944 = (_e1938 - _e1942);
                                                                let _e1945 = (_e1922 - _e1926);
                                                                let _e1969 = (bitcast<f32>((bitcast<u32>(_e1930) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1934) & 2147483647u)));
                                                                let _e1976 = (bitcast<f32>((bitcast<u32>(_e1938) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1942) & 2147483647u)));
                                                                let _e1983 = (bitcast<f32>((bitcast<u32>(_e1922) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1926) & 2147483647u)));
                                                                if (_e299.member_2 == 0f) {
                                                                    phi_2734_ = 0f;
                                                                } else {
                                                                    let _e2013 = bitcast<f32>((bitcast<u32>(_e1943) & 2147483647u));
                                                                    let _e2016 = bitcast<f32>((bitcast<u32>(_e1944) & 2147483647u));
                                                                    let _e2019 = bitcast<f32>((bitcast<u32>(_e1945) & 2147483647u));
                                                                    let _e2021 = select(_e2019, _e2016, (_e2016 > _e2019));
                                                                    let _e2025 = select(_e2019, _e2016, (_e2016 < _e2019));
                                                                    let _e2029 = select(_e2016, _e2013, (_e2013 < _e2016));
                                                                    let _e2031 = select(_e2016, _e2013, (_e2013 > _e2016));
                                                                    let _e2033 = select(_e2019, _e2031, (_e2031 < _e2019));
                                                                    phi_2734_ = bitcast<f32>((bitcast<u32>((_e299.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2021, _e2013, (_e2013 > _e2021)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2033, _e2029, (_e2029 > _e2033)))) ^ _e299.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2025, _e2013, (_e2013 < _e2025)))) ^ _e299.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1969 + _e1976) + _e1983))) ^ _e299.member_3[0]))) * 1.0000005f)) ^ _e299.member_3[0])))) ^ _e299.member_3[0]));
                                                                }
                                                                let _e2060 = phi_2734_;
                                                                phi_2752_ = (_e1862 || !(((((bitcast<f32>((bitcast<u32>((_e1916.x * _e1943)) ^ _e299.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1916.y * _e1944)) ^ _e299.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1916.z * _e1945)) ^ _e299.member_3[0]))) * f32(-(_e1861))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1916.x) & 2147483647u)) * _e1969)) ^ _e299.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1916.y) & 2147483647u)) * _e1976)) ^ _e299.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1916.z) & 2147483647u)) * _e1983)) ^ _e299.member_3[0]))))) ^ _e299.member_3[0])) + _e2060) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e2074 = phi_2752_;
                                                            phi_2753_ = _e2074;
                                                        }
                                                        let _e2076 = phi_2753_;
                                                        if _e2076 {
                                                            phi_2758_ = type_48(-340282350000000000000000000000000000000f, true);
                                                        } else {
                                                            phi_2758_ = _e1304;
                                                        }
                                                        let _e2078 = phi_2758_;
                                                        phi_2759_ = _e2078;
                                                    } else {
                                                        phi_2759_ = _e1304;
                                                    }
                                                    let _e2080 = phi_2759_;
                                                    phi_1513_ = _e2080;
                                                } else {
                                                    phi_1513_ = type_48();
                                                }
                                                let _e2082 = phi_1513_;
                                                continue;
                                                continuing {
                                                    phi_1512_ = _e2082;
                                                    phi_1515_ = _e1319;
                                                    phi_4396_ = _e792;
                                                    break if !(_e1325);
                                                }
                                            }
                                            let _e2085 = phi_4396_;
                                            phi_4581_ = _e2085;
                                            if _e2085 {
                                                break;
                                            }
                                            let _e2087 = local_10;
                                            phi_4585_ = _e2085;
                                            let _e2275 = local_12;
                                            phi_3986_ = _e2275;
                                            phi_3987_ = false;
                                            phi_3988_ = _e835;
                                            phi_3989_ = select(_e837, 0u, (_e750 > _e2087.member));
                                        } else {
                                            if (_e835.member_1 >= _e100) {
                                                phi_3525_ = type_65(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_64(type_35(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_64(type_35(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e835.member_1 < _e100) {
                                                } else {
                                                    phi_4581_ = true;
                                                    break;
                                                }
                                                let _e848 = (_e432 * 2u);
                                                let _e850 = ((1u + _e848) % 7u);
                                                if (_e850 < 7u) {
                                                } else {
                                                    phi_4581_ = true;
                                                    break;
                                                }
                                                let _e855 = global_9.member[_e835.member_1][_e850];
                                                let _e857 = ((_e848 + 2u) % 7u);
                                                if (_e857 < 7u) {
                                                } else {
                                                    phi_4581_ = true;
                                                    break;
                                                }
                                                let _e862 = global_9.member[_e835.member_1][_e857];
                                                let _e863 = (_e431 * 2u);
                                                let _e865 = ((1u + _e863) % 7u);
                                                if (_e865 < 7u) {
                                                } else {
                                                    phi_4581_ = true;
                                                    break;
                                                }
                                                let _e870 = global_9.member[_e835.member_1][_e865];
                                                let _e872 = ((_e863 + 2u) % 7u);
                                                if (_e872 < 7u) {
                                                } else {
                                                    phi_4581_ = true;
                                                    break;
                                                }
                                                let _e877 = global_9.member[_e835.member_1][_e872];
                                                let _e878 = (_e433 * 2u);
                                                let _e880 = ((1u + _e878) % 7u);
                                                if (_e880 < 7u) {
                                                } else {
                                                    phi_4581_ = true;
                                                    break;
                                                }
                                                let _e885 = global_9.member[_e835.member_1][_e880];
                                                let _e887 = ((_e878 + 2u) % 7u);
                                                if (_e887 < 7u) {
                                                } else {
                                                    phi_4581_ = true;
                                                    break;
                                                }
                                                let _e892 = global_9.member[_e835.member_1][_e887];
                                                let _e915 = (bitcast<f32>((bitcast<u32>((_e835.member.member_1.x - _e835.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e916 = (bitcast<f32>((bitcast<u32>((_e835.member.member_1.y - _e835.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e917 = (bitcast<f32>((bitcast<u32>((_e835.member.member_1.z - _e835.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e919 = select(_e158, _e915, (_e915 > _e158));
                                                let _e921 = select(_e158, _e916, (_e916 > _e158));
                                                let _e923 = select(_e158, _e917, (_e917 > _e158));
                                                let _e954 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e855 & 2097151u))) - 8388608f) * _e919));
                                                let _e959 = (bitcast<i32>((_e855 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e962 = bitcast<f32>((_e954 & bitcast<u32>(_e959)));
                                                let _e963 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e870 & 2097151u))) - 8388608f) * _e921));
                                                let _e968 = (bitcast<i32>((_e870 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e971 = bitcast<f32>((_e963 & bitcast<u32>(_e968)));
                                                let _e972 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e885 & 2097151u))) - 8388608f) * _e923));
                                                let _e977 = (bitcast<i32>((_e885 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e980 = bitcast<f32>((_e972 & bitcast<u32>(_e977)));
                                                let _e984 = bitcast<f32>((_e954 & bitcast<u32>(~(_e959))));
                                                let _e988 = bitcast<f32>((_e963 & bitcast<u32>(~(_e968))));
                                                let _e992 = bitcast<f32>((_e972 & bitcast<u32>(~(_e977))));
                                                let _e993 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e862 & 2097151u))) - 8388608f) * _e919));
                                                let _e998 = (bitcast<i32>((_e862 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1001 = bitcast<f32>((_e993 & bitcast<u32>(_e998)));
                                                let _e1002 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e877 & 2097151u))) - 8388608f) * _e921));
                                                let _e1007 = (bitcast<i32>((_e877 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1010 = bitcast<f32>((_e1002 & bitcast<u32>(_e1007)));
                                                let _e1011 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e892 & 2097151u))) - 8388608f) * _e923));
                                                let _e1016 = (bitcast<i32>((_e892 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1019 = bitcast<f32>((_e1011 & bitcast<u32>(_e1016)));
                                                let _e1023 = bitcast<f32>((_e993 & bitcast<u32>(~(_e998))));
                                                let _e1027 = bitcast<f32>((_e1002 & bitcast<u32>(~(_e1007))));
                                                let _e1031 = bitcast<f32>((_e1011 & bitcast<u32>(~(_e1016))));
                                                let _e1061 = global_9.member[_e835.member_1][0u];
                                                let _e1065 = global_9.member[_e835.member_1][2u];
                                                let _e1069 = global_9.member[_e835.member_1][4u];
                                                let _e1073 = global_9.member[_e835.member_1][6u];
                                                let _e1085 = (((_e1065 >> bitcast<u32>(22i)) | ((_e1069 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1073 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e1086 = (_e1061 & 268435455u);
                                                let _e1087 = (_e1085 & 268435455u);
                                                let _e1090 = ((_e1061 >> bitcast<u32>(28u)) & 7u);
                                                let _e1098 = ((_e1061 >> bitcast<u32>(31i)) | (((_e1085 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e1099 = (_e1090 != 0u);
                                                if (_e1090 == 0u) {
                                                    phi_3487_ = _e1086;
                                                } else {
                                                    if (_e1090 == 7u) {
                                                        phi_3486_ = 2147483648u;
                                                    } else {
                                                        phi_3486_ = ((2147483648u | (_e1090 << bitcast<u32>(28u))) | (_e1087 & 268435455u));
                                                    }
                                                    let _e1108 = phi_3486_;
                                                    phi_3487_ = _e1108;
                                                }
                                                let _e1110 = phi_3487_;
                                                if _e1099 {
                                                    let _e1111 = (_e1090 != 7u);
                                                    if _e1111 {
                                                        phi_3497_ = (_e1087 + _e1090);
                                                    } else {
                                                        phi_3497_ = u32();
                                                    }
                                                    let _e1114 = phi_3497_;
                                                    phi_3499_ = _e1114;
                                                    phi_3500_ = select(true, false, _e1111);
                                                } else {
                                                    phi_3499_ = u32();
                                                    phi_3500_ = true;
                                                }
                                                let _e1117 = phi_3499_;
                                                let _e1119 = phi_3500_;
                                                if (_e1098 == 0u) {
                                                    phi_3521_ = (_e1086 + select(0u, 1u, !(_e1099)));
                                                } else {
                                                    if (_e1098 == 7u) {
                                                        phi_3520_ = 2147483648u;
                                                    } else {
                                                        phi_3520_ = ((2147483648u | (_e1098 << bitcast<u32>(28u))) | (select(_e1117, _e1087, _e1119) & 268435455u));
                                                    }
                                                    let _e1132 = phi_3520_;
                                                    phi_3521_ = _e1132;
                                                }
                                                let _e1134 = phi_3521_;
                                                phi_3525_ = type_65(array<vec4<f32>, 3>(vec4<f32>((_e835.member.member.x + _e962), (_e835.member.member.x + _e984), (_e835.member.member_1.x - _e1001), (_e835.member.member_1.x - _e1023)), vec4<f32>((_e835.member.member.y + _e971), (_e835.member.member.y + _e988), (_e835.member.member_1.y - _e1010), (_e835.member.member_1.y - _e1027)), vec4<f32>((_e835.member.member.z + _e980), (_e835.member.member.z + _e992), (_e835.member.member_1.z - _e1019), (_e835.member.member_1.z - _e1031))), type_64(type_35((_e835.member.member + vec4<f32>(_e962, _e971, _e980, 0f)), (_e835.member.member_1 - vec4<f32>(_e1001, _e1010, _e1019, 0f))), _e1110), type_64(type_35((_e835.member.member + vec4<f32>(_e984, _e988, _e992, 0f)), (_e835.member.member_1 - vec4<f32>(_e1023, _e1027, _e1031, 0f))), _e1134));
                                            }
                                            let _e1139 = phi_3525_;
                                            let _e1151 = ((_e1139.member[0].x - _e517) * _e520);
                                            let _e1152 = ((_e1139.member[0].y - _e517) * _e520);
                                            let _e1153 = ((_e1139.member[0].z - _e518) * _e520);
                                            let _e1154 = ((_e1139.member[0].w - _e518) * _e520);
                                            let _e1164 = ((_e1139.member[1].x - _e581) * _e584);
                                            let _e1165 = ((_e1139.member[1].y - _e581) * _e584);
                                            let _e1166 = ((_e1139.member[1].z - _e582) * _e584);
                                            let _e1167 = ((_e1139.member[1].w - _e582) * _e584);
                                            let _e1177 = ((_e1139.member[2].x - _e645) * _e648);
                                            let _e1178 = ((_e1139.member[2].y - _e645) * _e648);
                                            let _e1179 = ((_e1139.member[2].z - _e646) * _e648);
                                            let _e1180 = ((_e1139.member[2].w - _e646) * _e648);
                                            let _e1182 = select(_e1179, _e1177, (_e1177 < _e1179));
                                            let _e1184 = select(_e1180, _e1178, (_e1178 < _e1180));
                                            let _e1186 = select(_e1179, _e1177, (_e1177 > _e1179));
                                            let _e1188 = select(_e1180, _e1178, (_e1178 > _e1180));
                                            let _e1190 = select(_e1153, _e1151, (_e1151 < _e1153));
                                            let _e1192 = select(_e1154, _e1152, (_e1152 < _e1154));
                                            let _e1194 = select(_e1166, _e1164, (_e1164 < _e1166));
                                            let _e1196 = select(_e1167, _e1165, (_e1165 < _e1167));
                                            let _e1198 = select(_e1194, _e1190, (_e1190 > _e1194));
                                            let _e1200 = select(_e1196, _e1192, (_e1192 > _e1196));
                                            let _e1202 = select(_e1182, _e1198, (_e1198 > _e1182));
                                            let _e1204 = select(_e1184, _e1200, (_e1200 > _e1184));
                                            let _e1206 = select(_e1153, _e1151, (_e1151 > _e1153));
                                            let _e1208 = select(_e1154, _e1152, (_e1152 > _e1154));
                                            let _e1210 = select(_e1166, _e1164, (_e1164 > _e1166));
                                            let _e1212 = select(_e1167, _e1165, (_e1165 > _e1167));
                                            let _e1214 = select(_e1210, _e1206, (_e1206 < _e1210));
                                            let _e1216 = select(_e1212, _e1208, (_e1208 < _e1212));
                                            let _e1221 = -(_e1182);
                                            let _e1222 = -(_e1184);
                                            let _e1229 = (select(_e1186, _e1214, (_e1214 < _e1186)) + (select(_e1221, _e1186, (_e1186 > _e1221)) * 0.0000019073523f));
                                            let _e1230 = (select(_e1188, _e1216, (_e1216 < _e1188)) + (select(_e1222, _e1188, (_e1188 > _e1222)) * 0.0000019073523f));
                                            let _e1232 = select(_e750, _e1202, (_e1202 > _e750));
                                            let _e1234 = select(_e750, _e1204, (_e1204 > _e750));
                                            let _e1239 = (_e1232 <= select(_e794.member, _e1229, (_e1229 < _e794.member)));
                                            let _e1240 = (_e1234 <= select(_e794.member, _e1230, (_e1230 < _e794.member)));
                                            let _e1241 = (_e1232 <= _e1234);
                                            if _e1239 {
                                                if _e1240 {
                                                    if _e1241 {
                                                        phi_3887_ = _e1139.member_2;
                                                    } else {
                                                        phi_3887_ = _e1139.member_1;
                                                    }
                                                    let _e1245 = phi_3887_;
                                                    let _e1266 = (_e837 % 128u);
                                                    let _e1267 = (_e1266 < 128u);
                                                    if _e1267 {
                                                    } else {
                                                        phi_4581_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1266] = _e1245.member_1;
                                                    if _e1267 {
                                                    } else {
                                                        phi_4581_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1266] = _e1245.member.member.x;
                                                    if _e1267 {
                                                    } else {
                                                        phi_4581_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1266] = _e1245.member.member.y;
                                                    if _e1267 {
                                                    } else {
                                                        phi_4581_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1266] = _e1245.member.member.z;
                                                    if _e1267 {
                                                    } else {
                                                        phi_4581_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1266] = _e1245.member.member_1.x;
                                                    if _e1267 {
                                                    } else {
                                                        phi_4581_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1266] = _e1245.member.member_1.y;
                                                    if _e1267 {
                                                    } else {
                                                        phi_4581_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1266] = _e1245.member.member_1.z;
                                                    if _e1267 {
                                                    } else {
                                                        phi_4581_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1266] = select(_e1232, _e1234, _e1241);
                                                    if _e1241 {
                                                        phi_3963_ = _e1139.member_1;
                                                    } else {
                                                        phi_3963_ = _e1139.member_2;
                                                    }
                                                    let _e1280 = phi_3963_;
                                                    phi_3964_ = _e1280;
                                                    phi_3965_ = (_e837 + 1u);
                                                } else {
                                                    phi_3964_ = type_64();
                                                    phi_3965_ = u32();
                                                }
                                                let _e1282 = phi_3964_;
                                                let _e1284 = phi_3965_;
                                                phi_3967_ = _e1282;
                                                phi_3968_ = _e1284;
                                                phi_3969_ = select(true, false, _e1240);
                                            } else {
                                                phi_3967_ = type_64();
                                                phi_3968_ = u32();
                                                phi_3969_ = true;
                                            }
                                            let _e1287 = phi_3967_;
                                            let _e1289 = phi_3968_;
                                            let _e1291 = phi_3969_;
                                            if _e1291 {
                                                if _e1239 {
                                                    phi_3978_ = _e1139.member_1;
                                                } else {
                                                    phi_3978_ = _e1139.member_2;
                                                }
                                                let _e1295 = phi_3978_;
                                                phi_3983_ = select(_e1240, true, _e1239);
                                                phi_3984_ = _e1295;
                                            } else {
                                                phi_3983_ = _e833;
                                                phi_3984_ = _e1287;
                                            }
                                            let _e1298 = phi_3983_;
                                            let _e1300 = phi_3984_;
                                            phi_4585_ = _e792;
                                            phi_3986_ = _e794;
                                            phi_3987_ = _e1298;
                                            phi_3988_ = _e1300;
                                            phi_3989_ = select(_e1289, _e837, _e1291);
                                        }
                                        let _e2092 = phi_4585_;
                                        let _e2094 = phi_3986_;
                                        let _e2096 = phi_3987_;
                                        let _e2098 = phi_3988_;
                                        let _e2100 = phi_3989_;
                                        phi_4584_ = _e2092;
                                        phi_3990_ = _e2094;
                                        phi_3991_ = _e2096;
                                        phi_3992_ = _e2098;
                                        phi_3993_ = _e2100;
                                        phi_3994_ = (_e802 - 1u);
                                    } else {
                                        phi_4584_ = _e792;
                                        phi_3990_ = _e794;
                                        phi_3991_ = _e833;
                                        phi_3992_ = _e835;
                                        phi_3993_ = _e837;
                                        phi_3994_ = _e802;
                                    }
                                    let _e2102 = phi_4584_;
                                    let _e2104 = phi_3990_;
                                    let _e2106 = phi_3991_;
                                    let _e2108 = phi_3992_;
                                    let _e2110 = phi_3993_;
                                    let _e2112 = phi_3994_;
                                    phi_4583_ = _e2102;
                                    phi_3995_ = _e2104;
                                    phi_3996_ = _e2106;
                                    phi_3997_ = _e2108;
                                    phi_3998_ = _e2110;
                                    phi_3999_ = _e2112;
                                } else {
                                    phi_4583_ = _e792;
                                    phi_3995_ = type_48();
                                    phi_3996_ = bool();
                                    phi_3997_ = type_64();
                                    phi_3998_ = u32();
                                    phi_3999_ = u32();
                                }
                                let _e2114 = phi_4583_;
                                let _e2116 = phi_3995_;
                                let _e2118 = phi_3996_;
                                let _e2120 = phi_3997_;
                                let _e2122 = phi_3998_;
                                let _e2124 = phi_3999_;
                                phi_4582_ = _e2114;
                                phi_1387_ = _e2116;
                                phi_1390_ = _e2118;
                                phi_1392_ = _e2120;
                                phi_1394_ = _e2122;
                                phi_1396_ = _e2124;
                                phi_4000_ = _e806;
                            } else {
                                phi_4582_ = _e792;
                                phi_1387_ = type_48();
                                phi_1390_ = bool();
                                phi_1392_ = type_64();
                                phi_1394_ = u32();
                                phi_1396_ = u32();
                                phi_4000_ = false;
                            }
                            let _e2126 = phi_4582_;
                            let _e2128 = phi_1387_;
                            let _e2130 = phi_1390_;
                            let _e2132 = phi_1392_;
                            let _e2134 = phi_1394_;
                            let _e2136 = phi_1396_;
                            let _e2138 = phi_4000_;
                            continue;
                            continuing {
                                phi_4402_ = _e2126;
                                phi_1386_ = _e2128;
                                phi_1389_ = _e2130;
                                phi_1391_ = _e2132;
                                phi_1393_ = _e2134;
                                phi_1395_ = _e2136;
                                phi_4581_ = _e2126;
                                break if !(_e2138);
                            }
                        }
                        let _e2141 = phi_4581_;
                        if _e2141 {
                            break;
                        }
                        let _e2143 = local_11;
                        if _e2143.member_1 {
                        } else {
                            if _e300 {
                            } else {
                                break;
                            }
                            let _e2147 = global_2.member[_e146];
                            if _e161 {
                            } else {
                                break;
                            }
                            let _e2151 = global_10.member[_e146].member_1;
                            if _e300 {
                            } else {
                                break;
                            }
                            global_2.member[_e146] = type_28(_e2147.member, _e2147.member_1, _e2147.member_2, array<f32, 3>((_e2147.member_3[0] + (_e2151[0] * _e2147.member_1[0])), (_e2147.member_3[1] + (_e2151[1] * _e2147.member_1[1])), (_e2147.member_3[2] + (_e2151[2] * _e2147.member_1[2]))), _e2147.member_4);
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
fn trace_shadows_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
