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

struct type_27 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_28 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_29 {
    member: type_28,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_31 {
    member: array<type_29>,
}

struct type_35 {
    member: type_28,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_37 {
    member: array<type_35>,
}

struct type_41 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_46 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_47 {
    member: f32,
    member_1: bool,
}

struct type_49 {
    member: array<vec4<u32>, 2>,
}

struct type_52 {
    member: array<i32>,
}

struct type_56 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_58 {
    member: array<type_56>,
}

struct type_61 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_63 {
    member: type_61,
    member_1: u32,
}

struct type_68 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_31;
@group(0) @binding(1) 
var<uniform> global_3: type_49;
@group(0) @binding(2) 
var<uniform> global_4: type_49;
@group(0) @binding(4) 
var<storage> global_5: type_20;
@group(0) @binding(5) 
var<storage> global_6: type_4;
@group(0) @binding(6) 
var<storage> global_7: type_52;
@group(0) @binding(9) 
var<storage, read_write> global_8: type_68;
@group(0) @binding(7) 
var<storage> global_9: type_37;
@group(0) @binding(3) 
var<storage> global_10: type_58;

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
    var phi_305_: u32;
    var phi_349_: i32;
    var phi_489_: type_41;
    var phi_639_: i32;
    var phi_640_: i32;
    var phi_650_: bool;
    var phi_660_: u32;
    var phi_661_: u32;
    var phi_663_: bool;
    var phi_668_: u32;
    var phi_701_: i32;
    var phi_719_: f32;
    var phi_725_: f32;
    var phi_765_: f32;
    var phi_771_: f32;
    var phi_844_: f32;
    var phi_850_: f32;
    var phi_890_: f32;
    var phi_896_: f32;
    var phi_969_: f32;
    var phi_975_: f32;
    var phi_1015_: f32;
    var phi_1021_: f32;
    var phi_1140_: i32;
    var phi_1162_: u32;
    var phi_1163_: u32;
    var phi_1200_: i32;
    var phi_1222_: u32;
    var phi_1223_: u32;
    var phi_1231_: f32;
    var phi_1232_: f32;
    var phi_4027_: bool;
    var phi_1315_: type_47;
    var phi_1318_: u32;
    var phi_1320_: bool;
    var phi_1322_: u32;
    var phi_1324_: type_63;
    var phi_1335_: bool;
    var phi_1421_: bool;
    var phi_1422_: u32;
    var phi_1423_: type_63;
    var phi_1441_: type_47;
    var phi_1444_: type_8;
    var phi_1445_: type_8;
    var phi_1467_: type_8;
    var phi_1488_: u32;
    var phi_1580_: array<array<f32, 3>, 3>;
    var phi_3822_: bool;
    var phi_3837_: bool;
    var phi_3852_: bool;
    var phi_3867_: bool;
    var phi_3882_: bool;
    var phi_3897_: bool;
    var phi_2122_: f32;
    var phi_2123_: f32;
    var phi_2124_: f32;
    var phi_2125_: f32;
    var phi_2126_: vec3<f32>;
    var phi_2127_: vec3<f32>;
    var phi_2128_: vec3<f32>;
    var phi_2129_: vec3<f32>;
    var phi_3912_: bool;
    var phi_3927_: bool;
    var phi_3942_: bool;
    var phi_3957_: bool;
    var phi_3972_: bool;
    var phi_3987_: bool;
    var phi_2337_: f32;
    var phi_2357_: type_46;
    var phi_2358_: type_46;
    var phi_2361_: type_46;
    var phi_2362_: type_46;
    var phi_2363_: bool;
    var phi_2367_: type_46;
    var phi_2376_: type_27;
    var phi_2399_: u32;
    var phi_2413_: i32;
    var phi_2435_: vec3<f32>;
    var phi_2436_: vec3<f32>;
    var phi_2454_: vec3<f32>;
    var phi_2455_: vec3<f32>;
    var phi_2473_: vec3<f32>;
    var phi_2474_: vec3<f32>;
    var phi_2510_: vec3<f32>;
    var phi_2692_: f32;
    var phi_2710_: bool;
    var phi_2711_: bool;
    var phi_2716_: type_47;
    var phi_2717_: type_47;
    var phi_1442_: type_47;
    var phi_4021_: bool;
    var phi_4277_: bool;
    var phi_2718_: type_47;
    var phi_2739_: type_56;
    var phi_3625_: type_63;
    var phi_3701_: type_63;
    var phi_3702_: u32;
    var phi_3703_: type_63;
    var phi_3705_: u32;
    var phi_3706_: type_63;
    var phi_3707_: bool;
    var phi_3714_: type_63;
    var phi_3719_: bool;
    var phi_3721_: type_63;
    var phi_3725_: bool;
    var phi_3726_: u32;
    var phi_3727_: type_63;
    var phi_3737_: u32;
    var phi_3738_: type_63;
    var phi_4221_: bool;
    var phi_3739_: type_47;
    var phi_3740_: u32;
    var phi_3741_: bool;
    var phi_3742_: u32;
    var phi_3743_: type_63;
    var phi_4220_: bool;
    var phi_3744_: type_47;
    var phi_3745_: u32;
    var phi_3746_: bool;
    var phi_3747_: u32;
    var phi_3748_: type_63;
    var phi_4219_: bool;
    var phi_1316_: type_47;
    var phi_1319_: u32;
    var phi_1321_: bool;
    var phi_1323_: u32;
    var phi_1325_: type_63;
    var phi_3749_: bool;
    var phi_4218_: bool;
    var local_10: type_47;
    var local_11: type_47;

    switch bitcast<i32>(0u) {
        default: {
            let _e93 = global;
            let _e96 = arrayLength((&global_10.member));
            let _e98 = arrayLength((&global_5.member));
            let _e110 = arrayLength((&global_8.member));
            let _e114 = global_4.member[0u][0u];
            let _e118 = global_4.member[0u][1u];
            let _e122 = global_4.member[0u][2u];
            let _e126 = global_4.member[1u][0u];
            let _e130 = global_4.member[1u][1u];
            let _e134 = global_4.member[1u][2u];
            let _e138 = global_4.member[1u][3u];
            let _e142 = (_e93.x + (_e93.y * 2097152u));
            let _e149 = (_e142 < arrayLength((&global_9.member)));
            if _e149 {
                if _e149 {
                } else {
                    break;
                }
                let _e153 = global_9.member[_e142].member_2;
                phi_305_ = _e153;
            } else {
                phi_305_ = 4294967295u;
            }
            let _e155 = phi_305_;
            let _e158 = global_1.member[0u];
            let _e162 = global_3.member[0u][0u];
            let _e166 = global_3.member[0u][1u];
            let _e170 = global_3.member[0u][2u];
            let _e174 = global_3.member[0u][3u];
            let _e178 = global_3.member[1u][0u];
            let _e182 = global_3.member[1u][1u];
            let _e186 = global_3.member[1u][2u];
            let _e190 = global_3.member[1u][3u];
            let _e191 = bitcast<f32>(_e162);
            let _e192 = bitcast<f32>(_e166);
            let _e193 = bitcast<f32>(_e170);
            let _e195 = bitcast<f32>(_e178);
            let _e196 = array<u32, 3>(_e182, _e186, _e190);
            let _e198 = bitcast<i32>(_e158);
            if (_e198 < -126i) {
                phi_349_ = -126i;
            } else {
                phi_349_ = select(_e198, 127i, (_e198 > 127i));
            }
            let _e203 = phi_349_;
            let _e208 = bitcast<f32>((bitcast<u32>((_e203 + 127i)) << bitcast<u32>(23i)));
            let _e214 = bitcast<f32>((bitcast<u32>(((_e198 - _e203) + 127i)) << bitcast<u32>(23i)));
            if (_e174 == 0u) {
                phi_489_ = type_41(array<f32, 3>(_e191, _e192, _e193), _e174, _e195, _e196);
            } else {
                let _e216 = bitcast<u32>(_e191);
                let _e218 = ((_e216 & 2139095040u) != 0u);
                let _e233 = bitcast<u32>(_e192);
                let _e235 = ((_e233 & 2139095040u) != 0u);
                let _e250 = bitcast<u32>(_e193);
                let _e252 = ((_e250 & 2139095040u) != 0u);
                let _e268 = bitcast<u32>(_e195);
                let _e270 = ((_e268 & 2139095040u) != 0u);
                phi_489_ = type_41(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e216 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e216 & 2147483648u))), _e191, _e218) * _e208) * select(0.00000011920929f, 1f, _e218)) * _e214), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e233 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e233 & 2147483648u))), _e192, _e235) * _e208) * select(0.00000011920929f, 1f, _e235)) * _e214), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e250 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e250 & 2147483648u))), _e193, _e252) * _e208) * select(0.00000011920929f, 1f, _e252)) * _e214)), _e174, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e268 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e268 & 2147483648u))), _e195, _e270) * _e208) * select(0.00000011920929f, 1f, _e270)) * _e214), _e196);
            }
            let _e287 = phi_489_;
            if _e149 {
                let _e288 = (_e142 < arrayLength((&global_2.member)));
                if _e288 {
                    if _e149 {
                    } else {
                        break;
                    }
                    let _e293 = global_9.member[_e142].member.member_1;
                    let _e298 = global_9.member[_e142].member.member_3;
                    if (_e293 <= _e298) {
                        let _e300 = (1u < _e110);
                        if _e300 {
                            if (0u < _e110) {
                            } else {
                                break;
                            }
                            let _e304 = atomicAdd((&global_8.member[0u]), 1u);
                            if ((_e304 + 1u) < _e304) {
                                if _e300 {
                                } else {
                                    break;
                                }
                                let _e309 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                        if _e149 {
                        } else {
                            break;
                        }
                        let _e319 = global_9.member[_e142].member.member_2[0u];
                        let _e321 = (bitcast<u32>(_e319) & 2147483647u);
                        let _e327 = global_9.member[_e142].member.member_2[1u];
                        let _e329 = (bitcast<u32>(_e327) & 2147483647u);
                        let _e335 = global_9.member[_e142].member.member_2[2u];
                        let _e337 = (bitcast<u32>(_e335) & 2147483647u);
                        let _e343 = global_9.member[_e142].member.member[0u];
                        let _e345 = (bitcast<u32>(_e343) & 2147483647u);
                        let _e351 = global_9.member[_e142].member.member[1u];
                        let _e353 = (bitcast<u32>(_e351) & 2147483647u);
                        let _e359 = global_9.member[_e142].member.member[2u];
                        let _e361 = (bitcast<u32>(_e359) & 2147483647u);
                        let _e363 = select(_e329, _e321, (_e329 < _e321));
                        let _e365 = select(_e337, _e363, (_e337 < _e363));
                        let _e367 = select(_e345, _e365, (_e345 < _e365));
                        let _e369 = select(_e353, _e367, (_e353 < _e367));
                        let _e371 = select(_e361, _e369, (_e361 < _e369));
                        let _e372 = bitcast<u32>(_e293);
                        let _e373 = (_e372 & 2147483647u);
                        let _e377 = bitcast<u32>(_e298);
                        let _e378 = (_e377 & 2147483647u);
                        let _e382 = (((select(_e373, _e371, (_e373 < _e371)) < 2139095040u) && (_e378 <= 2139095040u)) && (_e365 > 0u));
                        if _e382 {
                            let _e385 = (bitcast<u32>(bitcast<f32>(_e365)) & 2147483647u);
                            if (_e385 >= 8388608u) {
                                phi_639_ = (bitcast<i32>((_e385 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_639_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e385)), 32u, (_e385 == 0u))));
                            }
                            let _e399 = phi_639_;
                            phi_640_ = _e399;
                        } else {
                            phi_640_ = 0i;
                        }
                        let _e401 = phi_640_;
                        let _e402 = (_e321 == _e365);
                        if _e402 {
                            phi_650_ = true;
                        } else {
                            phi_650_ = (_e329 == _e365);
                        }
                        let _e405 = phi_650_;
                        let _e406 = select(1u, 0u, _e402);
                        if _e405 {
                            let _e407 = (_e406 + 1u);
                            phi_660_ = _e407;
                            phi_661_ = _e407;
                            phi_663_ = select(true, false, (_e407 == 2u));
                        } else {
                            phi_660_ = u32();
                            phi_661_ = 0u;
                            phi_663_ = true;
                        }
                        let _e411 = phi_660_;
                        let _e413 = phi_661_;
                        let _e415 = phi_663_;
                        if _e415 {
                            phi_668_ = (_e413 + 1u);
                        } else {
                            phi_668_ = 0u;
                        }
                        let _e419 = phi_668_;
                        let _e420 = select(_e411, _e413, _e415);
                        let _e421 = select(_e406, select(2u, _e406, _e405), _e415);
                        let _e422 = -(_e401);
                        if (_e422 < -126i) {
                            phi_701_ = -126i;
                        } else {
                            phi_701_ = select(_e422, 127i, (_e422 > 127i));
                        }
                        let _e427 = phi_701_;
                        let _e432 = bitcast<f32>((bitcast<u32>((_e427 + 127i)) << bitcast<u32>(23i)));
                        let _e438 = bitcast<f32>((bitcast<u32>(((_e422 - _e427) + 127i)) << bitcast<u32>(23i)));
                        let _e443 = global_9.member[_e142].member.member;
                        let _e444 = (_e420 == 0u);
                        if _e444 {
                            phi_719_ = _e443[0];
                        } else {
                            phi_719_ = _e443[1];
                        }
                        let _e448 = phi_719_;
                        let _e449 = (_e420 == 2u);
                        if _e449 {
                            phi_725_ = _e443[2];
                        } else {
                            phi_725_ = _e448;
                        }
                        let _e452 = phi_725_;
                        let _e453 = bitcast<u32>(_e452);
                        let _e455 = ((_e453 & 2139095040u) != 0u);
                        let _e467 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e453 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e453 & 2147483648u))), _e452, _e455) * select(0.00000011920929f, 1f, _e455));
                        let _e468 = global_9.member[_e142].member.member_2;
                        if _e444 {
                            phi_765_ = _e468[0];
                        } else {
                            phi_765_ = _e468[1];
                        }
                        let _e472 = phi_765_;
                        if _e449 {
                            phi_771_ = _e468[2];
                        } else {
                            phi_771_ = _e472;
                        }
                        let _e475 = phi_771_;
                        let _e476 = bitcast<u32>(_e475);
                        let _e478 = ((_e476 & 2139095040u) != 0u);
                        let _e492 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e476 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e476 & 2147483648u))), _e475, _e478) * _e432) * select(0.00000011920929f, 1f, _e478)) * _e438);
                        let _e496 = (bitcast<f32>((bitcast<u32>(_e492) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e499 = bitcast<f32>((bitcast<u32>(_e467) & 2147483647u));
                        let _e500 = (_e499 * 0.00000011920929f);
                        let _e503 = select(select(0.00000000000011368684f, _e500, (_e500 > 0.00000000000011368684f)), 0f, _e496);
                        let _e504 = select(0f, _e492, _e496);
                        let _e505 = (_e467 + _e503);
                        let _e506 = (_e467 - _e503);
                        let _e508 = select(38685626000000000000000000f, (1f / _e492), _e496);
                        let _e509 = (_e419 == 0u);
                        if _e509 {
                            phi_844_ = _e443[0];
                        } else {
                            phi_844_ = _e443[1];
                        }
                        let _e513 = phi_844_;
                        let _e514 = (_e419 == 2u);
                        if _e514 {
                            phi_850_ = _e443[2];
                        } else {
                            phi_850_ = _e513;
                        }
                        let _e517 = phi_850_;
                        let _e518 = bitcast<u32>(_e517);
                        let _e520 = ((_e518 & 2139095040u) != 0u);
                        let _e532 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e518 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e518 & 2147483648u))), _e517, _e520) * select(0.00000011920929f, 1f, _e520));
                        if _e509 {
                            phi_890_ = _e468[0];
                        } else {
                            phi_890_ = _e468[1];
                        }
                        let _e536 = phi_890_;
                        if _e514 {
                            phi_896_ = _e468[2];
                        } else {
                            phi_896_ = _e536;
                        }
                        let _e539 = phi_896_;
                        let _e540 = bitcast<u32>(_e539);
                        let _e542 = ((_e540 & 2139095040u) != 0u);
                        let _e556 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e540 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e540 & 2147483648u))), _e539, _e542) * _e432) * select(0.00000011920929f, 1f, _e542)) * _e438);
                        let _e560 = (bitcast<f32>((bitcast<u32>(_e556) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e563 = bitcast<f32>((bitcast<u32>(_e532) & 2147483647u));
                        let _e564 = (_e563 * 0.00000011920929f);
                        let _e567 = select(select(0.00000000000011368684f, _e564, (_e564 > 0.00000000000011368684f)), 0f, _e560);
                        let _e568 = select(0f, _e556, _e560);
                        let _e569 = (_e532 + _e567);
                        let _e570 = (_e532 - _e567);
                        let _e572 = select(38685626000000000000000000f, (1f / _e556), _e560);
                        let _e573 = (_e421 == 0u);
                        if _e573 {
                            phi_969_ = _e443[0];
                        } else {
                            phi_969_ = _e443[1];
                        }
                        let _e577 = phi_969_;
                        let _e578 = (_e421 == 2u);
                        if _e578 {
                            phi_975_ = _e443[2];
                        } else {
                            phi_975_ = _e577;
                        }
                        let _e581 = phi_975_;
                        let _e582 = bitcast<u32>(_e581);
                        let _e584 = ((_e582 & 2139095040u) != 0u);
                        let _e596 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e582 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e582 & 2147483648u))), _e581, _e584) * select(0.00000011920929f, 1f, _e584));
                        if _e573 {
                            phi_1015_ = _e468[0];
                        } else {
                            phi_1015_ = _e468[1];
                        }
                        let _e600 = phi_1015_;
                        if _e578 {
                            phi_1021_ = _e468[2];
                        } else {
                            phi_1021_ = _e600;
                        }
                        let _e603 = phi_1021_;
                        let _e604 = bitcast<u32>(_e603);
                        let _e606 = ((_e604 & 2139095040u) != 0u);
                        let _e620 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e604 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e604 & 2147483648u))), _e603, _e606) * _e432) * select(0.00000011920929f, 1f, _e606)) * _e438);
                        let _e624 = (bitcast<f32>((bitcast<u32>(_e620) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e627 = bitcast<f32>((bitcast<u32>(_e596) & 2147483647u));
                        let _e628 = (_e627 * 0.00000011920929f);
                        let _e631 = select(select(0.00000000000011368684f, _e628, (_e628 > 0.00000000000011368684f)), 0f, _e624);
                        let _e632 = select(0f, _e620, _e624);
                        let _e633 = (_e596 + _e631);
                        let _e634 = (_e596 - _e631);
                        let _e636 = select(38685626000000000000000000f, (1f / _e620), _e624);
                        let _e638 = select(_e563, _e499, (_e499 > _e563));
                        if (_e382 && (select(_e627, _e638, (_e638 > _e627)) <= 1099511600000f)) {
                            let _e650 = ((_e373 & 8388607u) | (select(0u, 1u, ((_e373 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e653 = bitcast<i32>((_e373 >> bitcast<u32>(23i)));
                            let _e657 = (_e650 == 0u);
                            let _e660 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e650)), 32u, _e657)) - 8i);
                            if (_e653 == 255i) {
                                phi_1140_ = 255i;
                            } else {
                                phi_1140_ = (((_e653 + select(0i, 1i, (_e653 == 0i))) - _e660) + _e401);
                            }
                            let _e668 = phi_1140_;
                            let _e678 = (_e668 <= 0i);
                            if _e678 {
                                phi_1163_ = u32();
                            } else {
                                if _e657 {
                                    phi_1162_ = u32();
                                } else {
                                    phi_1162_ = select(((bitcast<u32>(_e668) << bitcast<u32>(23i)) | ((_e650 << bitcast<u32>(((_e660 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e668 >= 255i));
                                }
                                let _e682 = phi_1162_;
                                phi_1163_ = _e682;
                            }
                            let _e684 = phi_1163_;
                            let _e696 = ((_e378 & 8388607u) | (select(0u, 1u, ((_e378 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e699 = bitcast<i32>((_e378 >> bitcast<u32>(23i)));
                            let _e703 = (_e696 == 0u);
                            let _e706 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e696)), 32u, _e703)) - 8i);
                            if (_e699 == 255i) {
                                phi_1200_ = 255i;
                            } else {
                                phi_1200_ = (((_e699 + select(0i, 1i, (_e699 == 0i))) - _e706) + _e401);
                            }
                            let _e714 = phi_1200_;
                            let _e724 = (_e714 <= 0i);
                            if _e724 {
                                phi_1223_ = u32();
                            } else {
                                if _e703 {
                                    phi_1222_ = u32();
                                } else {
                                    phi_1222_ = select(((bitcast<u32>(_e714) << bitcast<u32>(23i)) | ((_e696 << bitcast<u32>(((_e706 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e714 >= 255i));
                                }
                                let _e728 = phi_1222_;
                                phi_1223_ = _e728;
                            }
                            let _e730 = phi_1223_;
                            phi_1231_ = bitcast<f32>(((_e377 & 2147483648u) | select(_e730, 0u, select(_e703, true, _e724))));
                            phi_1232_ = bitcast<f32>(((_e372 & 2147483648u) | select(_e684, 0u, select(_e657, true, _e678))));
                        } else {
                            phi_1231_ = 0f;
                            phi_1232_ = 1f;
                        }
                        let _e736 = phi_1231_;
                        let _e738 = phi_1232_;
                        local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 3>(bitcast<f32>(_e114), bitcast<f32>(_e118), bitcast<f32>(_e122));
                        let _e743 = (_e420 % 3u);
                        let _e744 = (_e743 < 3u);
                        if _e744 {
                        } else {
                            break;
                        }
                        let _e746 = local_9[_e743];
                        let _e747 = (_e419 % 3u);
                        let _e748 = (_e747 < 3u);
                        if _e748 {
                        } else {
                            break;
                        }
                        let _e750 = local_9[_e747];
                        let _e751 = (_e421 % 3u);
                        let _e752 = (_e751 < 3u);
                        if _e752 {
                        } else {
                            break;
                        }
                        let _e754 = local_9[_e751];
                        local_8 = array<f32, 3>(bitcast<f32>(_e126), bitcast<f32>(_e130), bitcast<f32>(_e134));
                        if _e744 {
                        } else {
                            break;
                        }
                        let _e758 = local_8[_e743];
                        if _e748 {
                        } else {
                            break;
                        }
                        let _e760 = local_8[_e747];
                        if _e752 {
                        } else {
                            break;
                        }
                        let _e762 = local_8[_e751];
                        phi_4027_ = false;
                        phi_1315_ = type_47(_e736, false);
                        phi_1318_ = ((3u * _e96) + 1u);
                        phi_1320_ = (_e738 <= _e736);
                        phi_1322_ = 0u;
                        phi_1324_ = type_63(type_61(array<f32, 3>(_e746, _e750, _e754), array<f32, 3>(_e758, _e760, _e762)), select(0u, 2147483648u, (_e96 == 0u)));
                        loop {
                            let _e770 = phi_4027_;
                            let _e772 = phi_1315_;
                            let _e774 = phi_1318_;
                            let _e776 = phi_1320_;
                            let _e778 = phi_1322_;
                            let _e780 = phi_1324_;
                            local_10 = _e772;
                            if _e776 {
                                phi_1335_ = true;
                            } else {
                                phi_1335_ = (_e778 > 0u);
                            }
                            let _e783 = phi_1335_;
                            if _e783 {
                                let _e784 = (_e774 > 0u);
                                if _e784 {
                                    if _e776 {
                                        phi_1421_ = _e776;
                                        phi_1422_ = _e778;
                                        phi_1423_ = _e780;
                                    } else {
                                        let _e785 = (_e778 - 1u);
                                        let _e786 = (_e785 % 128u);
                                        let _e787 = (_e786 < 128u);
                                        if _e787 {
                                        } else {
                                            phi_4218_ = true;
                                            break;
                                        }
                                        let _e789 = local_6[_e786];
                                        if _e787 {
                                        } else {
                                            phi_4218_ = true;
                                            break;
                                        }
                                        let _e791 = local_5[_e786];
                                        if _e787 {
                                        } else {
                                            phi_4218_ = true;
                                            break;
                                        }
                                        let _e793 = local_4[_e786];
                                        if _e787 {
                                        } else {
                                            phi_4218_ = true;
                                            break;
                                        }
                                        let _e795 = local_3[_e786];
                                        if _e787 {
                                        } else {
                                            phi_4218_ = true;
                                            break;
                                        }
                                        let _e798 = local_2[_e786];
                                        if _e787 {
                                        } else {
                                            phi_4218_ = true;
                                            break;
                                        }
                                        let _e800 = local_1[_e786];
                                        if _e787 {
                                        } else {
                                            phi_4218_ = true;
                                            break;
                                        }
                                        let _e802 = local[_e786];
                                        if _e787 {
                                        } else {
                                            phi_4218_ = true;
                                            break;
                                        }
                                        let _e807 = local_7[_e786];
                                        phi_1421_ = (_e807 <= _e772.member);
                                        phi_1422_ = _e785;
                                        phi_1423_ = type_63(type_61(array<f32, 3>(_e791, _e793, _e795), array<f32, 3>(_e798, _e800, _e802)), _e789);
                                    }
                                    let _e811 = phi_1421_;
                                    let _e813 = phi_1422_;
                                    let _e815 = phi_1423_;
                                    if _e811 {
                                        let _e819 = ((_e815.member_1 & 2147483648u) != 0u);
                                        if _e819 {
                                            phi_1441_ = _e772;
                                            phi_1444_ = type_8(0u, ((_e815.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e826 = phi_1441_;
                                                let _e828 = phi_1444_;
                                                local_11 = _e826;
                                                if (_e828.member < _e828.member_1) {
                                                    phi_1445_ = type_8((_e828.member + 1u), _e828.member_1);
                                                    phi_1467_ = type_8(1u, _e828.member);
                                                } else {
                                                    phi_1445_ = _e828;
                                                    phi_1467_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e841 = phi_1445_;
                                                let _e843 = phi_1467_;
                                                let _e847 = (bitcast<i32>(_e843.member) != 0i);
                                                if _e847 {
                                                    let _e848 = ((_e815.member_1 & 268435455u) + _e843.member_1);
                                                    let _e849 = (_e848 < _e98);
                                                    if _e849 {
                                                        if _e849 {
                                                        } else {
                                                            phi_4021_ = true;
                                                            break;
                                                        }
                                                        let _e853 = global_5.member[_e848].member_1;
                                                        phi_1488_ = _e853;
                                                    } else {
                                                        phi_1488_ = 4294967295u;
                                                    }
                                                    let _e855 = phi_1488_;
                                                    if (_e848 >= _e98) {
                                                        phi_1580_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e849 {
                                                        } else {
                                                            phi_4021_ = true;
                                                            break;
                                                        }
                                                        if (_e743 < 9u) {
                                                        } else {
                                                            phi_4021_ = true;
                                                            break;
                                                        }
                                                        let _e862 = global_5.member[_e848].member[_e743];
                                                        if (_e747 < 9u) {
                                                        } else {
                                                            phi_4021_ = true;
                                                            break;
                                                        }
                                                        let _e868 = global_5.member[_e848].member[_e747];
                                                        if (_e751 < 9u) {
                                                        } else {
                                                            phi_4021_ = true;
                                                            break;
                                                        }
                                                        let _e874 = global_5.member[_e848].member[_e751];
                                                        let _e876 = (3u + _e743);
                                                        if (_e876 < 9u) {
                                                        } else {
                                                            phi_4021_ = true;
                                                            break;
                                                        }
                                                        let _e882 = global_5.member[_e848].member[_e876];
                                                        let _e883 = (3u + _e747);
                                                        if (_e883 < 9u) {
                                                        } else {
                                                            phi_4021_ = true;
                                                            break;
                                                        }
                                                        let _e889 = global_5.member[_e848].member[_e883];
                                                        let _e890 = (3u + _e751);
                                                        if (_e890 < 9u) {
                                                        } else {
                                                            phi_4021_ = true;
                                                            break;
                                                        }
                                                        let _e896 = global_5.member[_e848].member[_e890];
                                                        let _e898 = (6u + _e743);
                                                        if (_e898 < 9u) {
                                                        } else {
                                                            phi_4021_ = true;
                                                            break;
                                                        }
                                                        let _e904 = global_5.member[_e848].member[_e898];
                                                        let _e905 = (6u + _e747);
                                                        if (_e905 < 9u) {
                                                        } else {
                                                            phi_4021_ = true;
                                                            break;
                                                        }
                                                        let _e911 = global_5.member[_e848].member[_e905];
                                                        let _e912 = (6u + _e751);
                                                        if (_e912 < 9u) {
                                                        } else {
                                                            phi_4021_ = true;
                                                            break;
                                                        }
                                                        let _e918 = global_5.member[_e848].member[_e912];
                                                        phi_1580_ = array<array<f32, 3>, 3>(array<f32, 3>(_e862, _e868, _e874), array<f32, 3>(_e882, _e889, _e896), array<f32, 3>(_e904, _e911, _e918));
                                                    }
                                                    let _e922 = phi_1580_;
                                                    let _e938 = (_e922[0][2] - _e596);
                                                    let _e941 = (((_e922[0][0] - _e467) * _e632) - (_e938 * _e504));
                                                    let _e944 = (((_e922[0][1] - _e532) * _e632) - (_e938 * _e568));
                                                    let _e947 = (_e922[1][2] - _e596);
                                                    let _e950 = (((_e922[1][0] - _e467) * _e632) - (_e947 * _e504));
                                                    let _e953 = (((_e922[1][1] - _e532) * _e632) - (_e947 * _e568));
                                                    let _e956 = (_e922[2][2] - _e596);
                                                    let _e959 = (((_e922[2][0] - _e467) * _e632) - (_e956 * _e504));
                                                    let _e962 = (((_e922[2][1] - _e532) * _e632) - (_e956 * _e568));
                                                    let _e963 = (_e959 * _e953);
                                                    let _e964 = (_e962 * _e950);
                                                    let _e965 = (_e941 * _e962);
                                                    let _e966 = (_e944 * _e959);
                                                    let _e967 = (_e950 * _e944);
                                                    let _e968 = (_e953 * _e941);
                                                    let _e973 = (((_e963 >= _e964) && (_e965 >= _e966)) && (_e967 >= _e968));
                                                    let _e979 = (_e973 || (((_e963 <= _e964) && (_e965 <= _e966)) && (_e967 <= _e968)));
                                                    if _e979 {
                                                        let _e981 = select(-1f, 1f, _e973);
                                                        let _e983 = ((_e963 - _e964) * _e981);
                                                        let _e985 = select(0f, _e983, (_e983 > 0f));
                                                        let _e987 = ((_e965 - _e966) * _e981);
                                                        let _e989 = select(0f, _e987, (_e987 > 0f));
                                                        let _e991 = ((_e967 - _e968) * _e981);
                                                        let _e993 = select(0f, _e991, (_e991 > 0f));
                                                        let _e995 = ((_e985 + _e989) + _e993);
                                                        let _e997 = select(_e922[1][0], _e922[0][0], (_e922[0][0] < _e922[1][0]));
                                                        let _e1001 = select(_e922[1][0], _e922[0][0], (_e922[0][0] > _e922[1][0]));
                                                        let _e1005 = select(_e922[1][1], _e922[0][1], (_e922[0][1] < _e922[1][1]));
                                                        let _e1009 = select(_e922[1][1], _e922[0][1], (_e922[0][1] > _e922[1][1]));
                                                        let _e1013 = select(_e922[1][2], _e922[0][2], (_e922[0][2] < _e922[1][2]));
                                                        let _e1017 = select(_e922[1][2], _e922[0][2], (_e922[0][2] > _e922[1][2]));
                                                        let _e1022 = ((select(_e922[2][0], _e997, (_e997 < _e922[2][0])) - _e505) * _e508);
                                                        let _e1023 = ((select(_e922[2][0], _e1001, (_e1001 > _e922[2][0])) - _e506) * _e508);
                                                        let _e1026 = ((select(_e922[2][1], _e1005, (_e1005 < _e922[2][1])) - _e569) * _e572);
                                                        let _e1027 = ((select(_e922[2][1], _e1009, (_e1009 > _e922[2][1])) - _e570) * _e572);
                                                        let _e1030 = ((select(_e922[2][2], _e1013, (_e1013 < _e922[2][2])) - _e633) * _e636);
                                                        let _e1031 = ((select(_e922[2][2], _e1017, (_e1017 > _e922[2][2])) - _e634) * _e636);
                                                        let _e1033 = select(_e1031, _e1030, (_e1030 < _e1031));
                                                        let _e1035 = select(_e1031, _e1030, (_e1030 > _e1031));
                                                        let _e1037 = select(_e1023, _e1022, (_e1022 < _e1023));
                                                        let _e1039 = select(_e1027, _e1026, (_e1026 < _e1027));
                                                        let _e1041 = select(_e1039, _e1037, (_e1037 > _e1039));
                                                        let _e1043 = select(_e1033, _e1041, (_e1041 > _e1033));
                                                        let _e1045 = select(_e1023, _e1022, (_e1022 > _e1023));
                                                        let _e1047 = select(_e1027, _e1026, (_e1026 > _e1027));
                                                        let _e1049 = select(_e1047, _e1045, (_e1045 < _e1047));
                                                        let _e1051 = select(_e1035, _e1049, (_e1049 < _e1035));
                                                        let _e1052 = -(_e1033);
                                                        let _e1058 = select(_e738, _e1043, (_e1043 > _e738));
                                                        let _e1062 = select(_e950, _e941, (_e941 < _e950));
                                                        let _e1067 = select(_e950, _e941, (_e941 > _e950));
                                                        let _e1074 = select(_e953, _e944, (_e944 < _e953));
                                                        let _e1079 = select(_e953, _e944, (_e944 > _e953));
                                                        let _e1088 = (((((_e979 && (_e995 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e959, _e1062, (_e1062 < _e959)) <= 0f) && (select(_e959, _e1067, (_e1067 > _e959)) >= 0f))) && ((select(_e962, _e1074, (_e1074 < _e962)) <= 0f) && (select(_e962, _e1079, (_e1079 > _e962)) >= 0f))) && (_e1058 <= (_e1051 + (select(_e1052, _e1035, (_e1035 > _e1052)) * 0.0000019073523f)))) && (_e1058 <= _e826.member));
                                                        if _e1088 {
                                                            let _e1093 = (_e922[1][0] - _e922[0][0]);
                                                            let _e1094 = (_e922[1][1] - _e922[0][1]);
                                                            let _e1095 = (_e922[1][2] - _e922[0][2]);
                                                            let _e1096 = vec3<f32>(_e1093, _e1094, _e1095);
                                                            let _e1097 = (_e922[2][0] - _e922[1][0]);
                                                            let _e1098 = (_e922[2][1] - _e922[1][1]);
                                                            let _e1099 = (_e922[2][2] - _e922[1][2]);
                                                            let _e1100 = vec3<f32>(_e1097, _e1098, _e1099);
                                                            let _e1101 = (_e922[0][0] - _e922[2][0]);
                                                            let _e1102 = (_e922[0][1] - _e922[2][1]);
                                                            let _e1103 = (_e922[0][2] - _e922[2][2]);
                                                            let _e1104 = vec3<f32>(_e1101, _e1102, _e1103);
                                                            let _e1105 = abs(_e1093);
                                                            let _e1106 = abs(_e1094);
                                                            if (_e1105 != _e1105) {
                                                                phi_3822_ = true;
                                                            } else {
                                                                phi_3822_ = (_e1106 >= _e1105);
                                                            }
                                                            let _e1110 = phi_3822_;
                                                            let _e1111 = select(_e1105, _e1106, _e1110);
                                                            let _e1112 = abs(_e1095);
                                                            if (_e1111 != _e1111) {
                                                                phi_3837_ = true;
                                                            } else {
                                                                phi_3837_ = (_e1112 >= _e1111);
                                                            }
                                                            let _e1116 = phi_3837_;
                                                            let _e1117 = select(_e1111, _e1112, _e1116);
                                                            let _e1118 = abs(_e1097);
                                                            let _e1119 = abs(_e1098);
                                                            if (_e1118 != _e1118) {
                                                                phi_3852_ = true;
                                                            } else {
                                                                phi_3852_ = (_e1119 >= _e1118);
                                                            }
                                                            let _e1123 = phi_3852_;
                                                            let _e1124 = select(_e1118, _e1119, _e1123);
                                                            let _e1125 = abs(_e1099);
                                                            if (_e1124 != _e1124) {
                                                                phi_3867_ = true;
                                                            } else {
                                                                phi_3867_ = (_e1125 >= _e1124);
                                                            }
                                                            let _e1129 = phi_3867_;
                                                            let _e1130 = select(_e1124, _e1125, _e1129);
                                                            let _e1131 = abs(_e1101);
                                                            let _e1132 = abs(_e1102);
                                                            if (_e1131 != _e1131) {
                                                                phi_3882_ = true;
                                                            } else {
                                                                phi_3882_ = (_e1132 >= _e1131);
                                                            }
                                                            let _e1136 = phi_3882_;
                                                            let _e1137 = select(_e1131, _e1132, _e1136);
                                                            let _e1138 = abs(_e1103);
                                                            if (_e1137 != _e1137) {
                                                                phi_3897_ = true;
                                                            } else {
                                                                phi_3897_ = (_e1138 >= _e1137);
                                                            }
                                                            let _e1142 = phi_3897_;
                                                            let _e1143 = select(_e1137, _e1138, _e1142);
                                                            let _e1145 = select(_e1130, _e1117, (_e1117 > _e1130));
                                                            let _e1147 = select(_e1143, _e1145, (_e1145 > _e1143));
                                                            if (_e1117 == _e1147) {
                                                                phi_2122_ = _e953;
                                                                phi_2123_ = _e950;
                                                                phi_2124_ = _e944;
                                                                phi_2125_ = _e941;
                                                                phi_2126_ = vec3<f32>(_e922[0][0], _e922[0][1], _e922[0][2]);
                                                                phi_2127_ = _e1104;
                                                                phi_2128_ = _e1100;
                                                                phi_2129_ = _e1096;
                                                            } else {
                                                                let _e1149 = (_e1130 == _e1147);
                                                                let _e1154 = vec3(_e1149);
                                                                phi_2122_ = select(_e944, _e962, _e1149);
                                                                phi_2123_ = select(_e941, _e959, _e1149);
                                                                phi_2124_ = select(_e962, _e953, _e1149);
                                                                phi_2125_ = select(_e959, _e950, _e1149);
                                                                phi_2126_ = select(vec3<f32>(_e922[2][0], _e922[2][1], _e922[2][2]), vec3<f32>(_e922[1][0], _e922[1][1], _e922[1][2]), _e1154);
                                                                phi_2127_ = select(_e1100, _e1096, _e1154);
                                                                phi_2128_ = select(_e1096, _e1104, _e1154);
                                                                phi_2129_ = select(_e1104, _e1100, _e1154);
                                                            }
                                                            let _e1160 = phi_2122_;
                                                            let _e1162 = phi_2123_;
                                                            let _e1164 = phi_2124_;
                                                            let _e1166 = phi_2125_;
                                                            let _e1168 = phi_2126_;
                                                            let _e1170 = phi_2127_;
                                                            let _e1172 = phi_2128_;
                                                            let _e1174 = phi_2129_;
                                                            let _e1181 = ((_e1172.y * _e1170.z) - (_e1170.y * _e1172.z));
                                                            let _e1186 = ((_e1172.z * _e1170.x) - (_e1170.z * _e1172.x));
                                                            let _e1189 = ((_e1172.x * _e1170.y) - (_e1170.x * _e1172.y));
                                                            let _e1192 = ((_e985 >= _e989) && (_e985 >= _e993));
                                                            let _e1193 = (_e989 >= _e993);
                                                            let _e1207 = (((_e1181 * (select(select(_e922[2][0], _e922[1][0], _e1193), _e922[0][0], _e1192) - _e467)) + (_e1186 * (select(select(_e922[2][1], _e922[1][1], _e1193), _e922[0][1], _e1192) - _e532))) + (_e1189 * (select(select(_e922[2][2], _e922[1][2], _e1193), _e922[0][2], _e1192) - _e596)));
                                                            let _e1212 = (((_e1181 * _e504) + (_e1186 * _e568)) + (_e1189 * _e632));
                                                            let _e1213 = (_e1162 - _e1166);
                                                            let _e1214 = (_e1160 - _e1164);
                                                            let _e1217 = ((_e1213 * _e1213) + (_e1214 * _e1214));
                                                            let _e1224 = (-(((_e1166 * _e1213) + (_e1164 * _e1214))) / select(0.000000000000000000000000000000000000011754944f, _e1217, (_e1217 > 0.000000000000000000000000000000000000011754944f)));
                                                            let _e1226 = select(1f, _e1224, (_e1224 < 1f));
                                                            let _e1228 = select(0f, _e1226, (_e1226 > 0f));
                                                            let _e1237 = ((_e1168.x + (_e1174.x * _e1228)) - _e467);
                                                            let _e1240 = ((_e1168.y + (_e1174.y * _e1228)) - _e532);
                                                            let _e1243 = ((_e1168.z + (_e1174.z * _e1228)) - _e596);
                                                            let _e1246 = bitcast<f32>((bitcast<u32>(_e1237) & 2147483647u));
                                                            let _e1249 = bitcast<f32>((bitcast<u32>(_e1240) & 2147483647u));
                                                            let _e1251 = select(_e1249, _e1246, (_e1246 > _e1249));
                                                            let _e1254 = bitcast<f32>((bitcast<u32>(_e1243) & 2147483647u));
                                                            let _e1256 = select(_e1254, _e1251, (_e1251 > _e1254));
                                                            let _e1260 = abs(_e1181);
                                                            let _e1261 = abs(_e1186);
                                                            if (_e1260 != _e1260) {
                                                                phi_3912_ = true;
                                                            } else {
                                                                phi_3912_ = (_e1261 >= _e1260);
                                                            }
                                                            let _e1265 = phi_3912_;
                                                            let _e1266 = select(_e1260, _e1261, _e1265);
                                                            let _e1267 = abs(_e1189);
                                                            if (_e1266 != _e1266) {
                                                                phi_3927_ = true;
                                                            } else {
                                                                phi_3927_ = (_e1267 >= _e1266);
                                                            }
                                                            let _e1271 = phi_3927_;
                                                            let _e1287 = abs(_e1172.x);
                                                            let _e1288 = abs(_e1172.y);
                                                            if (_e1287 != _e1287) {
                                                                phi_3942_ = true;
                                                            } else {
                                                                phi_3942_ = (_e1288 >= _e1287);
                                                            }
                                                            let _e1292 = phi_3942_;
                                                            let _e1293 = select(_e1287, _e1288, _e1292);
                                                            let _e1294 = abs(_e1172.z);
                                                            if (_e1293 != _e1293) {
                                                                phi_3957_ = true;
                                                            } else {
                                                                phi_3957_ = (_e1294 >= _e1293);
                                                            }
                                                            let _e1298 = phi_3957_;
                                                            let _e1301 = abs(_e1170.x);
                                                            let _e1302 = abs(_e1170.y);
                                                            if (_e1301 != _e1301) {
                                                                phi_3972_ = true;
                                                            } else {
                                                                phi_3972_ = (_e1302 >= _e1301);
                                                            }
                                                            let _e1306 = phi_3972_;
                                                            let _e1307 = select(_e1301, _e1302, _e1306);
                                                            let _e1308 = abs(_e1170.z);
                                                            if (_e1307 != _e1307) {
                                                                phi_3987_ = true;
                                                            } else {
                                                                phi_3987_ = (_e1308 >= _e1307);
                                                            }
                                                            let _e1312 = phi_3987_;
                                                            let _e1317 = ((bitcast<f32>((bitcast<u32>(((((_e1181 * _e1237) + (_e1186 * _e1240)) + (_e1189 * _e1243)) - _e1207)) & 2147483647u)) <= ((0.0000009536743f * select(_e1147, _e1256, (_e1256 > _e1147))) * select(_e1266, _e1267, _e1271))) && !((bitcast<f32>((bitcast<u32>(_e1212) & 2147483647u)) <= ((0.0000038146973f * select(_e1293, _e1294, _e1298)) * select(_e1307, _e1308, _e1312)))));
                                                            let _e1318 = (_e1207 / _e1212);
                                                            if (_e1088 && !(_e1317)) {
                                                                let _e1321 = (_e1243 / _e632);
                                                                let _e1329 = (((_e1181 * (_e1237 - (_e504 * _e1321))) + (_e1186 * (_e1240 - (_e568 * _e1321)))) / _e1212);
                                                                phi_2337_ = select(select(_e1321, (_e1321 + _e1329), (bitcast<f32>((bitcast<u32>(_e1329) & 2147483647u)) <= _e1147)), _e1318, _e1317);
                                                            } else {
                                                                phi_2337_ = _e1318;
                                                            }
                                                            let _e1338 = phi_2337_;
                                                            let _e1340 = select(_e1051, _e1338, (_e1338 < _e1051));
                                                            let _e1342 = select(_e1043, _e1340, (_e1340 > _e1043));
                                                            let _e1343 = (1f / _e995);
                                                            phi_2357_ = type_46(_e1342, (_e989 * _e1343), (_e993 * _e1343), ((_e1088 && (_e1342 >= _e738)) && (_e1342 <= _e826.member)));
                                                            phi_2358_ = type_46();
                                                        } else {
                                                            phi_2357_ = type_46();
                                                            phi_2358_ = type_46(0f, 0f, 0f, _e1088);
                                                        }
                                                        let _e1352 = phi_2357_;
                                                        let _e1354 = phi_2358_;
                                                        phi_2361_ = _e1352;
                                                        phi_2362_ = _e1354;
                                                        phi_2363_ = select(true, false, _e1088);
                                                    } else {
                                                        phi_2361_ = type_46();
                                                        phi_2362_ = type_46(0f, 0f, 0f, _e979);
                                                        phi_2363_ = true;
                                                    }
                                                    let _e1357 = phi_2361_;
                                                    let _e1359 = phi_2362_;
                                                    let _e1361 = phi_2363_;
                                                    if _e1361 {
                                                        phi_2367_ = _e1359;
                                                    } else {
                                                        phi_2367_ = _e1357;
                                                    }
                                                    let _e1363 = phi_2367_;
                                                    if _e1363.member_3 {
                                                        phi_2376_ = type_27(_e1363.member, _e1363.member_1, _e1363.member_2, _e855);
                                                    } else {
                                                        phi_2376_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    }
                                                    let _e1370 = phi_2376_;
                                                    if (_e1370.member_3 != 4294967295u) {
                                                        if (_e855 == _e155) {
                                                            phi_2711_ = false;
                                                        } else {
                                                            let _e1374 = (_e855 < arrayLength((&global_6.member)));
                                                            if _e1374 {
                                                                if _e1374 {
                                                                } else {
                                                                    phi_4021_ = true;
                                                                    break;
                                                                }
                                                                let _e1376 = global_6.member[_e855];
                                                                phi_2399_ = _e1376;
                                                            } else {
                                                                phi_2399_ = 4294967295u;
                                                            }
                                                            let _e1378 = phi_2399_;
                                                            let _e1379 = (_e1378 < arrayLength((&global_7.member)));
                                                            if _e1379 {
                                                                if _e1379 {
                                                                } else {
                                                                    phi_4021_ = true;
                                                                    break;
                                                                }
                                                                let _e1381 = global_7.member[_e1378];
                                                                phi_2413_ = _e1381;
                                                            } else {
                                                                phi_2413_ = 0i;
                                                            }
                                                            let _e1383 = phi_2413_;
                                                            let _e1384 = (_e1383 == 0i);
                                                            if _e1384 {
                                                                phi_2710_ = true;
                                                            } else {
                                                                if _e444 {
                                                                    phi_2436_ = vec3<f32>(_e922[0][0], _e922[0][1], _e922[0][2]);
                                                                } else {
                                                                    if (_e420 == 1u) {
                                                                        phi_2435_ = vec3<f32>(_e922[0][2], _e922[0][0], _e922[0][1]);
                                                                    } else {
                                                                        phi_2435_ = vec3<f32>(_e922[0][1], _e922[0][2], _e922[0][0]);
                                                                    }
                                                                    let _e1389 = phi_2435_;
                                                                    phi_2436_ = _e1389;
                                                                }
                                                                let _e1392 = phi_2436_;
                                                                if _e444 {
                                                                    phi_2455_ = vec3<f32>(_e922[1][0], _e922[1][1], _e922[1][2]);
                                                                } else {
                                                                    if (_e420 == 1u) {
                                                                        phi_2454_ = vec3<f32>(_e922[1][2], _e922[1][0], _e922[1][1]);
                                                                    } else {
                                                                        phi_2454_ = vec3<f32>(_e922[1][1], _e922[1][2], _e922[1][0]);
                                                                    }
                                                                    let _e1397 = phi_2454_;
                                                                    phi_2455_ = _e1397;
                                                                }
                                                                let _e1400 = phi_2455_;
                                                                if _e444 {
                                                                    phi_2474_ = vec3<f32>(_e922[2][0], _e922[2][1], _e922[2][2]);
                                                                } else {
                                                                    if (_e420 == 1u) {
                                                                        phi_2473_ = vec3<f32>(_e922[2][2], _e922[2][0], _e922[2][1]);
                                                                    } else {
                                                                        phi_2473_ = vec3<f32>(_e922[2][1], _e922[2][2], _e922[2][0]);
                                                                    }
                                                                    let _e1405 = phi_2473_;
                                                                    phi_2474_ = _e1405;
                                                                }
                                                                let _e1408 = phi_2474_;
                                                                let _e1411 = (_e1400.x - _e1392.x);
                                                                let _e1414 = (_e1400.y - _e1392.y);
                                                                let _e1417 = (_e1400.z - _e1392.z);
                                                                let _e1419 = (_e1408.x - _e1392.x);
                                                                let _e1421 = (_e1408.y - _e1392.y);
                                                                let _e1423 = (_e1408.z - _e1392.z);
                                                                if (_e287.member_1 == 1u) {
                                                                    phi_2510_ = (vec3<f32>(_e287.member[0], _e287.member[1], _e287.member[2]) - _e1392);
                                                                } else {
                                                                    phi_2510_ = vec3<f32>(_e287.member[0], _e287.member[1], _e287.member[2]);
                                                                }
                                                                let _e1438 = phi_2510_;
                                                                let _e1444 = bitcast<f32>((bitcast<u32>((_e1411 * _e1421)) ^ _e287.member_3[0]));
                                                                let _e1448 = bitcast<f32>((bitcast<u32>((_e1414 * _e1419)) ^ _e287.member_3[0]));
                                                                let _e1452 = bitcast<f32>((bitcast<u32>((_e1414 * _e1423)) ^ _e287.member_3[0]));
                                                                let _e1456 = bitcast<f32>((bitcast<u32>((_e1417 * _e1421)) ^ _e287.member_3[0]));
                                                                let _e1460 = bitcast<f32>((bitcast<u32>((_e1417 * _e1419)) ^ _e287.member_3[0]));
                                                                let _e1464 = bitcast<f32>((bitcast<u32>((_e1411 * _e1423)) ^ _e287.member_3[0]));
                                                                let _e1465 = (_e1452 - _e1456);
                                                                let _e1466 = (_e1460 - _e1464);
                                                                let _e1467 = (_e1444 - _e1448);
                                                                let _e1491 = (bitcast<f32>((bitcast<u32>(_e1452) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1456) & 2147483647u)));
                                                                let _e1498 = (bitcast<f32>((bitcast<u32>(_e1460) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1464) & 2147483647u)));
                                                                let _e1505 = (bitcast<f32>((bitcast<u32>(_e1444) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1448) & 2147483647u)));
                                                                if (_e287.member_2 == 0f) {
                                                                    phi_2692_ = 0f;
                                                                } else {
                                                                    let _e1535 = bitcast<f32>((bitcast<u32>(_e1465) & 2147483647u));
                                                                    let _e1538 = bitcast<f32>((bitcast<u32>(_e1466) & 2147483647u));
                                                                    let _e1541 = bitcast<f32>((bitcast<u32>(_e1467) & 2147483647u));
                                                                    let _e1543 = select(_e1541, _e1538, (_e1538 > _e1541));
                                                                    let _e1547 = select(_e1541, _e1538, (_e1538 < _e1541));
                                                                    let _e1551 = select(_e1538, _e1535, (_e1535 < _e1538));
                                                                    let _e1553 = select(_e1538, _e1535, (_e1535 > _e1538));
                                                                    let _e1555 = select(_e1541, _e1553, (_e1553 < _e1541));
                                                                    phi_2692_ = bitcast<f32>((bitcast<u32>((_e287.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1543, _e1535, (_e1535 > _e1543)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1555, _e1551, (_e1551 > _e1555)))) ^ _e287.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1547, _e1535, (_e1535 < _e1547)))) ^ _e287.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1491 + _e1498) + _e1505))) ^ _e287.member_3[0]))) * 1.0000005f)) ^ _e287.member_3[0])))) ^ _e287.member_3[0]));
                                                                }
                                                                let _e1582 = phi_2692_;
                                                                phi_2710_ = (_e1384 || !(((((bitcast<f32>((bitcast<u32>((_e1438.x * _e1465)) ^ _e287.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1438.y * _e1466)) ^ _e287.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1438.z * _e1467)) ^ _e287.member_3[0]))) * f32(-(_e1383))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1438.x) & 2147483647u)) * _e1491)) ^ _e287.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1438.y) & 2147483647u)) * _e1498)) ^ _e287.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1438.z) & 2147483647u)) * _e1505)) ^ _e287.member_3[0]))))) ^ _e287.member_3[0])) + _e1582) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1596 = phi_2710_;
                                                            phi_2711_ = _e1596;
                                                        }
                                                        let _e1598 = phi_2711_;
                                                        if _e1598 {
                                                            phi_2716_ = type_47(-340282350000000000000000000000000000000f, true);
                                                        } else {
                                                            phi_2716_ = _e826;
                                                        }
                                                        let _e1600 = phi_2716_;
                                                        phi_2717_ = _e1600;
                                                    } else {
                                                        phi_2717_ = _e826;
                                                    }
                                                    let _e1602 = phi_2717_;
                                                    phi_1442_ = _e1602;
                                                } else {
                                                    phi_1442_ = type_47();
                                                }
                                                let _e1604 = phi_1442_;
                                                continue;
                                                continuing {
                                                    phi_1441_ = _e1604;
                                                    phi_1444_ = _e841;
                                                    phi_4021_ = _e770;
                                                    break if !(_e847);
                                                }
                                            }
                                            let _e1607 = phi_4021_;
                                            phi_4218_ = _e1607;
                                            if _e1607 {
                                                break;
                                            }
                                            phi_4277_ = _e1607;
                                            let _e2156 = local_11;
                                            phi_2718_ = _e2156;
                                        } else {
                                            phi_4277_ = _e770;
                                            phi_2718_ = _e772;
                                        }
                                        let _e1609 = phi_4277_;
                                        let _e1611 = phi_2718_;
                                        if _e819 {
                                            phi_3725_ = bool();
                                            phi_3726_ = u32();
                                            phi_3727_ = type_63();
                                        } else {
                                            let _e1612 = (_e815.member_1 < _e96);
                                            if _e1612 {
                                                if _e1612 {
                                                } else {
                                                    phi_4218_ = true;
                                                    break;
                                                }
                                                let _e1614 = global_10.member[_e815.member_1];
                                                phi_2739_ = _e1614;
                                            } else {
                                                phi_2739_ = type_56(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e1616 = phi_2739_;
                                            let _e1631 = ((10u * _e420) & 31u);
                                            let _e1634 = ((_e1616.member[0] >> bitcast<u32>(_e1631)) & 1023u);
                                            let _e1642 = bitcast<f32>((bitcast<u32>(((_e815.member.member_1[0] - _e815.member.member[0]) * 0.0009775171f)) ^ _e138));
                                            let _e1647 = (_e815.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1634)) - 8388608f) * _e1642)) ^ _e138)));
                                            let _e1651 = select(select(_e815.member.member_1[0], _e1647, (_e1647 < _e815.member.member_1[0])), _e815.member.member_1[0], (_e1634 == 1023u));
                                            let _e1653 = ((10u * _e419) & 31u);
                                            let _e1656 = ((_e1616.member[0] >> bitcast<u32>(_e1653)) & 1023u);
                                            let _e1664 = bitcast<f32>((bitcast<u32>(((_e815.member.member_1[1] - _e815.member.member[1]) * 0.0009775171f)) ^ _e138));
                                            let _e1669 = (_e815.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1656)) - 8388608f) * _e1664)) ^ _e138)));
                                            let _e1673 = select(select(_e815.member.member_1[1], _e1669, (_e1669 < _e815.member.member_1[1])), _e815.member.member_1[1], (_e1656 == 1023u));
                                            let _e1675 = ((10u * _e421) & 31u);
                                            let _e1678 = ((_e1616.member[0] >> bitcast<u32>(_e1675)) & 1023u);
                                            let _e1686 = bitcast<f32>((bitcast<u32>(((_e815.member.member_1[2] - _e815.member.member[2]) * 0.0009775171f)) ^ _e138));
                                            let _e1691 = (_e815.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1678)) - 8388608f) * _e1686)) ^ _e138)));
                                            let _e1695 = select(select(_e815.member.member_1[2], _e1691, (_e1691 < _e815.member.member_1[2])), _e815.member.member_1[2], (_e1678 == 1023u));
                                            let _e1698 = ((_e1616.member[1] >> bitcast<u32>(_e1631)) & 1023u);
                                            let _e1706 = (_e815.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1698)) - 8388608f) * _e1642)) ^ _e138)));
                                            let _e1710 = select(select(_e815.member.member_1[0], _e1706, (_e1706 < _e815.member.member_1[0])), _e815.member.member_1[0], (_e1698 == 1023u));
                                            let _e1713 = ((_e1616.member[1] >> bitcast<u32>(_e1653)) & 1023u);
                                            let _e1721 = (_e815.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1713)) - 8388608f) * _e1664)) ^ _e138)));
                                            let _e1725 = select(select(_e815.member.member_1[1], _e1721, (_e1721 < _e815.member.member_1[1])), _e815.member.member_1[1], (_e1713 == 1023u));
                                            let _e1728 = ((_e1616.member[1] >> bitcast<u32>(_e1675)) & 1023u);
                                            let _e1736 = (_e815.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1728)) - 8388608f) * _e1686)) ^ _e138)));
                                            let _e1740 = select(select(_e815.member.member_1[2], _e1736, (_e1736 < _e815.member.member_1[2])), _e815.member.member_1[2], (_e1728 == 1023u));
                                            let _e1746 = ((_e1616.member_1[0] >> bitcast<u32>(_e1631)) & 1023u);
                                            let _e1754 = (_e815.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1746)) - 8388608f) * _e1642)) ^ _e138)));
                                            let _e1758 = select(select(_e815.member.member_1[0], _e1754, (_e1754 < _e815.member.member_1[0])), _e815.member.member_1[0], (_e1746 == 1023u));
                                            let _e1761 = ((_e1616.member_1[0] >> bitcast<u32>(_e1653)) & 1023u);
                                            let _e1769 = (_e815.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1761)) - 8388608f) * _e1664)) ^ _e138)));
                                            let _e1773 = select(select(_e815.member.member_1[1], _e1769, (_e1769 < _e815.member.member_1[1])), _e815.member.member_1[1], (_e1761 == 1023u));
                                            let _e1776 = ((_e1616.member_1[0] >> bitcast<u32>(_e1675)) & 1023u);
                                            let _e1784 = (_e815.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1776)) - 8388608f) * _e1686)) ^ _e138)));
                                            let _e1788 = select(select(_e815.member.member_1[2], _e1784, (_e1784 < _e815.member.member_1[2])), _e815.member.member_1[2], (_e1776 == 1023u));
                                            let _e1791 = ((_e1616.member_1[1] >> bitcast<u32>(_e1631)) & 1023u);
                                            let _e1799 = (_e815.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1791)) - 8388608f) * _e1642)) ^ _e138)));
                                            let _e1803 = select(select(_e815.member.member_1[0], _e1799, (_e1799 < _e815.member.member_1[0])), _e815.member.member_1[0], (_e1791 == 1023u));
                                            let _e1806 = ((_e1616.member_1[1] >> bitcast<u32>(_e1653)) & 1023u);
                                            let _e1814 = (_e815.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1806)) - 8388608f) * _e1664)) ^ _e138)));
                                            let _e1818 = select(select(_e815.member.member_1[1], _e1814, (_e1814 < _e815.member.member_1[1])), _e815.member.member_1[1], (_e1806 == 1023u));
                                            let _e1821 = ((_e1616.member_1[1] >> bitcast<u32>(_e1675)) & 1023u);
                                            let _e1829 = (_e815.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1821)) - 8388608f) * _e1686)) ^ _e138)));
                                            let _e1833 = select(select(_e815.member.member_1[2], _e1829, (_e1829 < _e815.member.member_1[2])), _e815.member.member_1[2], (_e1821 == 1023u));
                                            let _e1838 = type_63(type_61(array<f32, 3>(_e1651, _e1673, _e1695), array<f32, 3>(_e1710, _e1725, _e1740)), _e1616.member_2);
                                            let _e1843 = type_63(type_61(array<f32, 3>(_e1758, _e1773, _e1788), array<f32, 3>(_e1803, _e1818, _e1833)), _e1616.member_3);
                                            let _e1849 = ((_e1651 - _e505) * _e508);
                                            let _e1850 = ((_e1758 - _e505) * _e508);
                                            let _e1851 = ((_e1710 - _e506) * _e508);
                                            let _e1852 = ((_e1803 - _e506) * _e508);
                                            let _e1857 = ((_e1673 - _e569) * _e572);
                                            let _e1858 = ((_e1773 - _e569) * _e572);
                                            let _e1859 = ((_e1725 - _e570) * _e572);
                                            let _e1860 = ((_e1818 - _e570) * _e572);
                                            let _e1865 = ((_e1695 - _e633) * _e636);
                                            let _e1866 = ((_e1788 - _e633) * _e636);
                                            let _e1867 = ((_e1740 - _e634) * _e636);
                                            let _e1868 = ((_e1833 - _e634) * _e636);
                                            let _e1870 = select(_e1867, _e1865, (_e1865 < _e1867));
                                            let _e1872 = select(_e1868, _e1866, (_e1866 < _e1868));
                                            let _e1874 = select(_e1867, _e1865, (_e1865 > _e1867));
                                            let _e1876 = select(_e1868, _e1866, (_e1866 > _e1868));
                                            let _e1878 = select(_e1851, _e1849, (_e1849 < _e1851));
                                            let _e1880 = select(_e1852, _e1850, (_e1850 < _e1852));
                                            let _e1882 = select(_e1859, _e1857, (_e1857 < _e1859));
                                            let _e1884 = select(_e1860, _e1858, (_e1858 < _e1860));
                                            let _e1886 = select(_e1882, _e1878, (_e1878 > _e1882));
                                            let _e1888 = select(_e1884, _e1880, (_e1880 > _e1884));
                                            let _e1890 = select(_e1870, _e1886, (_e1886 > _e1870));
                                            let _e1892 = select(_e1872, _e1888, (_e1888 > _e1872));
                                            let _e1894 = select(_e1851, _e1849, (_e1849 > _e1851));
                                            let _e1896 = select(_e1852, _e1850, (_e1850 > _e1852));
                                            let _e1898 = select(_e1859, _e1857, (_e1857 > _e1859));
                                            let _e1900 = select(_e1860, _e1858, (_e1858 > _e1860));
                                            let _e1902 = select(_e1898, _e1894, (_e1894 < _e1898));
                                            let _e1904 = select(_e1900, _e1896, (_e1896 < _e1900));
                                            let _e1909 = -(_e1870);
                                            let _e1910 = -(_e1872);
                                            let _e1917 = (select(_e1874, _e1902, (_e1902 < _e1874)) + (select(_e1909, _e1874, (_e1874 > _e1909)) * 0.0000019073523f));
                                            let _e1918 = (select(_e1876, _e1904, (_e1904 < _e1876)) + (select(_e1910, _e1876, (_e1876 > _e1910)) * 0.0000019073523f));
                                            let _e1920 = select(_e738, _e1890, (_e1890 > _e738));
                                            let _e1922 = select(_e738, _e1892, (_e1892 > _e738));
                                            let _e1927 = (_e1920 <= select(_e1611.member, _e1917, (_e1917 < _e1611.member)));
                                            let _e1928 = (_e1922 <= select(_e1611.member, _e1918, (_e1918 < _e1611.member)));
                                            let _e1929 = (_e1920 <= _e1922);
                                            if _e1927 {
                                                if _e1928 {
                                                    if _e1929 {
                                                        phi_3625_ = _e1843;
                                                    } else {
                                                        phi_3625_ = _e1838;
                                                    }
                                                    let _e1931 = phi_3625_;
                                                    let _e1938 = (_e813 % 128u);
                                                    let _e1939 = (_e1938 < 128u);
                                                    if _e1939 {
                                                    } else {
                                                        phi_4218_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1938] = _e1931.member_1;
                                                    if _e1939 {
                                                    } else {
                                                        phi_4218_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1938] = _e1931.member.member[0];
                                                    if _e1939 {
                                                    } else {
                                                        phi_4218_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1938] = _e1931.member.member[1];
                                                    if _e1939 {
                                                    } else {
                                                        phi_4218_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1938] = _e1931.member.member[2];
                                                    if _e1939 {
                                                    } else {
                                                        phi_4218_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1938] = _e1931.member.member_1[0];
                                                    if _e1939 {
                                                    } else {
                                                        phi_4218_ = true;
                                                        break;
                                                    }
                                                    local_1[_e1938] = _e1931.member.member_1[1];
                                                    if _e1939 {
                                                    } else {
                                                        phi_4218_ = true;
                                                        break;
                                                    }
                                                    local[_e1938] = _e1931.member.member_1[2];
                                                    if _e1939 {
                                                    } else {
                                                        phi_4218_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1938] = select(_e1920, _e1922, _e1929);
                                                    if _e1929 {
                                                        phi_3701_ = _e1838;
                                                    } else {
                                                        phi_3701_ = _e1843;
                                                    }
                                                    let _e1956 = phi_3701_;
                                                    phi_3702_ = (_e813 + 1u);
                                                    phi_3703_ = _e1956;
                                                } else {
                                                    phi_3702_ = u32();
                                                    phi_3703_ = type_63();
                                                }
                                                let _e1958 = phi_3702_;
                                                let _e1960 = phi_3703_;
                                                phi_3705_ = _e1958;
                                                phi_3706_ = _e1960;
                                                phi_3707_ = select(true, false, _e1928);
                                            } else {
                                                phi_3705_ = u32();
                                                phi_3706_ = type_63();
                                                phi_3707_ = true;
                                            }
                                            let _e1963 = phi_3705_;
                                            let _e1965 = phi_3706_;
                                            let _e1967 = phi_3707_;
                                            if _e1967 {
                                                if _e1927 {
                                                    phi_3714_ = _e1838;
                                                } else {
                                                    phi_3714_ = _e1843;
                                                }
                                                let _e1969 = phi_3714_;
                                                phi_3719_ = select(_e1928, true, _e1927);
                                                phi_3721_ = _e1969;
                                            } else {
                                                phi_3719_ = _e811;
                                                phi_3721_ = _e1965;
                                            }
                                            let _e1972 = phi_3719_;
                                            let _e1974 = phi_3721_;
                                            phi_3725_ = _e1972;
                                            phi_3726_ = select(_e1963, _e813, _e1967);
                                            phi_3727_ = _e1974;
                                        }
                                        let _e1977 = phi_3725_;
                                        let _e1979 = phi_3726_;
                                        let _e1981 = phi_3727_;
                                        if _e819 {
                                            phi_3737_ = select(_e813, 0u, _e1611.member_1);
                                            phi_3738_ = _e815;
                                        } else {
                                            phi_3737_ = _e1979;
                                            phi_3738_ = _e1981;
                                        }
                                        let _e1985 = phi_3737_;
                                        let _e1987 = phi_3738_;
                                        phi_4221_ = _e1609;
                                        phi_3739_ = _e1611;
                                        phi_3740_ = (_e774 - 1u);
                                        phi_3741_ = select(_e1977, false, _e819);
                                        phi_3742_ = _e1985;
                                        phi_3743_ = _e1987;
                                    } else {
                                        phi_4221_ = _e770;
                                        phi_3739_ = _e772;
                                        phi_3740_ = _e774;
                                        phi_3741_ = _e811;
                                        phi_3742_ = _e813;
                                        phi_3743_ = _e815;
                                    }
                                    let _e1990 = phi_4221_;
                                    let _e1992 = phi_3739_;
                                    let _e1994 = phi_3740_;
                                    let _e1996 = phi_3741_;
                                    let _e1998 = phi_3742_;
                                    let _e2000 = phi_3743_;
                                    phi_4220_ = _e1990;
                                    phi_3744_ = _e1992;
                                    phi_3745_ = _e1994;
                                    phi_3746_ = _e1996;
                                    phi_3747_ = _e1998;
                                    phi_3748_ = _e2000;
                                } else {
                                    phi_4220_ = _e770;
                                    phi_3744_ = type_47();
                                    phi_3745_ = u32();
                                    phi_3746_ = bool();
                                    phi_3747_ = u32();
                                    phi_3748_ = type_63();
                                }
                                let _e2002 = phi_4220_;
                                let _e2004 = phi_3744_;
                                let _e2006 = phi_3745_;
                                let _e2008 = phi_3746_;
                                let _e2010 = phi_3747_;
                                let _e2012 = phi_3748_;
                                phi_4219_ = _e2002;
                                phi_1316_ = _e2004;
                                phi_1319_ = _e2006;
                                phi_1321_ = _e2008;
                                phi_1323_ = _e2010;
                                phi_1325_ = _e2012;
                                phi_3749_ = _e784;
                            } else {
                                phi_4219_ = _e770;
                                phi_1316_ = type_47();
                                phi_1319_ = u32();
                                phi_1321_ = bool();
                                phi_1323_ = u32();
                                phi_1325_ = type_63();
                                phi_3749_ = false;
                            }
                            let _e2014 = phi_4219_;
                            let _e2016 = phi_1316_;
                            let _e2018 = phi_1319_;
                            let _e2020 = phi_1321_;
                            let _e2022 = phi_1323_;
                            let _e2024 = phi_1325_;
                            let _e2026 = phi_3749_;
                            continue;
                            continuing {
                                phi_4027_ = _e2014;
                                phi_1315_ = _e2016;
                                phi_1318_ = _e2018;
                                phi_1320_ = _e2020;
                                phi_1322_ = _e2022;
                                phi_1324_ = _e2024;
                                phi_4218_ = _e2014;
                                break if !(_e2026);
                            }
                        }
                        let _e2029 = phi_4218_;
                        if _e2029 {
                            break;
                        }
                        let _e2031 = local_10;
                        if _e2031.member_1 {
                        } else {
                            if _e288 {
                            } else {
                                break;
                            }
                            let _e2035 = global_2.member[_e142];
                            if _e149 {
                            } else {
                                break;
                            }
                            let _e2039 = global_9.member[_e142].member_1;
                            if _e288 {
                            } else {
                                break;
                            }
                            global_2.member[_e142] = type_29(_e2035.member, _e2035.member_1, _e2035.member_2, array<f32, 3>((_e2035.member_3[0] + (_e2039[0] * _e2035.member_1[0])), (_e2035.member_3[1] + (_e2039[1] * _e2035.member_1[1])), (_e2035.member_3[2] + (_e2039[2] * _e2035.member_1[2]))), _e2035.member_4);
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
fn trace_shadows_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
