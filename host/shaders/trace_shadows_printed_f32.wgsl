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
    var phi_312_: u32;
    var phi_356_: i32;
    var phi_496_: type_41;
    var phi_646_: i32;
    var phi_647_: i32;
    var phi_657_: bool;
    var phi_667_: u32;
    var phi_668_: u32;
    var phi_670_: bool;
    var phi_675_: u32;
    var phi_708_: i32;
    var phi_726_: f32;
    var phi_732_: f32;
    var phi_772_: f32;
    var phi_778_: f32;
    var phi_851_: f32;
    var phi_857_: f32;
    var phi_897_: f32;
    var phi_903_: f32;
    var phi_976_: f32;
    var phi_982_: f32;
    var phi_1022_: f32;
    var phi_1028_: f32;
    var phi_1147_: i32;
    var phi_1169_: u32;
    var phi_1170_: u32;
    var phi_1207_: i32;
    var phi_1229_: u32;
    var phi_1230_: u32;
    var phi_1238_: f32;
    var phi_1239_: f32;
    var phi_3955_: bool;
    var phi_1322_: type_47;
    var phi_1325_: bool;
    var phi_1327_: type_63;
    var phi_1329_: u32;
    var phi_1331_: u32;
    var phi_1342_: bool;
    var phi_1428_: bool;
    var phi_1429_: type_63;
    var phi_1430_: u32;
    var phi_2716_: type_56;
    var phi_3602_: type_63;
    var phi_3678_: type_63;
    var phi_3679_: type_63;
    var phi_3680_: u32;
    var phi_3682_: type_63;
    var phi_3683_: u32;
    var phi_3684_: bool;
    var phi_3691_: type_63;
    var phi_3696_: bool;
    var phi_3697_: type_63;
    var phi_1448_: type_47;
    var phi_1451_: type_8;
    var phi_1452_: type_8;
    var phi_1474_: type_8;
    var phi_1495_: u32;
    var phi_1587_: array<array<f32, 3>, 3>;
    var phi_2117_: f32;
    var phi_2118_: f32;
    var phi_2119_: f32;
    var phi_2120_: f32;
    var phi_2121_: vec3<f32>;
    var phi_2122_: vec3<f32>;
    var phi_2123_: vec3<f32>;
    var phi_2124_: vec3<f32>;
    var phi_2315_: f32;
    var phi_2335_: type_46;
    var phi_2336_: type_46;
    var phi_2339_: type_46;
    var phi_2340_: type_46;
    var phi_2341_: bool;
    var phi_2345_: type_46;
    var phi_2354_: type_27;
    var phi_2377_: u32;
    var phi_2391_: i32;
    var phi_2413_: vec3<f32>;
    var phi_2414_: vec3<f32>;
    var phi_2432_: vec3<f32>;
    var phi_2433_: vec3<f32>;
    var phi_2451_: vec3<f32>;
    var phi_2452_: vec3<f32>;
    var phi_2488_: vec3<f32>;
    var phi_2670_: f32;
    var phi_2688_: bool;
    var phi_2689_: bool;
    var phi_2694_: type_47;
    var phi_2695_: type_47;
    var phi_1449_: type_47;
    var phi_3949_: bool;
    var local_10: type_47;
    var phi_4138_: bool;
    var phi_3699_: type_47;
    var phi_3700_: bool;
    var phi_3701_: type_63;
    var phi_3702_: u32;
    var phi_4137_: bool;
    var phi_3703_: type_47;
    var phi_3704_: bool;
    var phi_3705_: type_63;
    var phi_3706_: u32;
    var phi_3707_: u32;
    var phi_4136_: bool;
    var phi_3708_: type_47;
    var phi_3709_: bool;
    var phi_3710_: type_63;
    var phi_3711_: u32;
    var phi_3712_: u32;
    var phi_4135_: bool;
    var phi_1323_: type_47;
    var phi_1326_: bool;
    var phi_1328_: type_63;
    var phi_1330_: u32;
    var phi_1332_: u32;
    var phi_3713_: bool;
    var phi_4134_: bool;
    var local_11: type_47;
    var local_12: type_47;

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
                phi_312_ = _e153;
            } else {
                phi_312_ = 4294967295u;
            }
            let _e155 = phi_312_;
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
                phi_356_ = -126i;
            } else {
                phi_356_ = select(_e198, 127i, (_e198 > 127i));
            }
            let _e203 = phi_356_;
            let _e208 = bitcast<f32>((bitcast<u32>((_e203 + 127i)) << bitcast<u32>(23i)));
            let _e214 = bitcast<f32>((bitcast<u32>(((_e198 - _e203) + 127i)) << bitcast<u32>(23i)));
            if (_e174 == 0u) {
                phi_496_ = type_41(array<f32, 3>(_e191, _e192, _e193), _e174, _e195, _e196);
            } else {
                let _e216 = bitcast<u32>(_e191);
                let _e218 = ((_e216 & 2139095040u) != 0u);
                let _e233 = bitcast<u32>(_e192);
                let _e235 = ((_e233 & 2139095040u) != 0u);
                let _e250 = bitcast<u32>(_e193);
                let _e252 = ((_e250 & 2139095040u) != 0u);
                let _e268 = bitcast<u32>(_e195);
                let _e270 = ((_e268 & 2139095040u) != 0u);
                phi_496_ = type_41(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e216 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e216 & 2147483648u))), _e191, _e218) * _e208) * select(0.00000011920929f, 1f, _e218)) * _e214), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e233 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e233 & 2147483648u))), _e192, _e235) * _e208) * select(0.00000011920929f, 1f, _e235)) * _e214), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e250 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e250 & 2147483648u))), _e193, _e252) * _e208) * select(0.00000011920929f, 1f, _e252)) * _e214)), _e174, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e268 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e268 & 2147483648u))), _e195, _e270) * _e208) * select(0.00000011920929f, 1f, _e270)) * _e214), _e196);
            }
            let _e287 = phi_496_;
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
                                phi_646_ = (bitcast<i32>((_e385 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_646_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e385)), 32u, (_e385 == 0u))));
                            }
                            let _e399 = phi_646_;
                            phi_647_ = _e399;
                        } else {
                            phi_647_ = 0i;
                        }
                        let _e401 = phi_647_;
                        let _e402 = (_e321 == _e365);
                        if _e402 {
                            phi_657_ = true;
                        } else {
                            phi_657_ = (_e329 == _e365);
                        }
                        let _e405 = phi_657_;
                        let _e406 = select(1u, 0u, _e402);
                        if _e405 {
                            let _e407 = (_e406 + 1u);
                            phi_667_ = _e407;
                            phi_668_ = _e407;
                            phi_670_ = select(true, false, (_e407 == 2u));
                        } else {
                            phi_667_ = u32();
                            phi_668_ = 0u;
                            phi_670_ = true;
                        }
                        let _e411 = phi_667_;
                        let _e413 = phi_668_;
                        let _e415 = phi_670_;
                        if _e415 {
                            phi_675_ = (_e413 + 1u);
                        } else {
                            phi_675_ = 0u;
                        }
                        let _e419 = phi_675_;
                        let _e420 = select(_e411, _e413, _e415);
                        let _e421 = select(_e406, select(2u, _e406, _e405), _e415);
                        let _e422 = -(_e401);
                        if (_e422 < -126i) {
                            phi_708_ = -126i;
                        } else {
                            phi_708_ = select(_e422, 127i, (_e422 > 127i));
                        }
                        let _e427 = phi_708_;
                        let _e432 = bitcast<f32>((bitcast<u32>((_e427 + 127i)) << bitcast<u32>(23i)));
                        let _e438 = bitcast<f32>((bitcast<u32>(((_e422 - _e427) + 127i)) << bitcast<u32>(23i)));
                        let _e443 = global_9.member[_e142].member.member;
                        let _e444 = (_e420 == 0u);
                        if _e444 {
                            phi_726_ = _e443[0];
                        } else {
                            phi_726_ = _e443[1];
                        }
                        let _e448 = phi_726_;
                        let _e449 = (_e420 == 2u);
                        if _e449 {
                            phi_732_ = _e443[2];
                        } else {
                            phi_732_ = _e448;
                        }
                        let _e452 = phi_732_;
                        let _e453 = bitcast<u32>(_e452);
                        let _e455 = ((_e453 & 2139095040u) != 0u);
                        let _e467 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e453 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e453 & 2147483648u))), _e452, _e455) * select(0.00000011920929f, 1f, _e455));
                        let _e468 = global_9.member[_e142].member.member_2;
                        if _e444 {
                            phi_772_ = _e468[0];
                        } else {
                            phi_772_ = _e468[1];
                        }
                        let _e472 = phi_772_;
                        if _e449 {
                            phi_778_ = _e468[2];
                        } else {
                            phi_778_ = _e472;
                        }
                        let _e475 = phi_778_;
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
                            phi_851_ = _e443[0];
                        } else {
                            phi_851_ = _e443[1];
                        }
                        let _e513 = phi_851_;
                        let _e514 = (_e419 == 2u);
                        if _e514 {
                            phi_857_ = _e443[2];
                        } else {
                            phi_857_ = _e513;
                        }
                        let _e517 = phi_857_;
                        let _e518 = bitcast<u32>(_e517);
                        let _e520 = ((_e518 & 2139095040u) != 0u);
                        let _e532 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e518 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e518 & 2147483648u))), _e517, _e520) * select(0.00000011920929f, 1f, _e520));
                        if _e509 {
                            phi_897_ = _e468[0];
                        } else {
                            phi_897_ = _e468[1];
                        }
                        let _e536 = phi_897_;
                        if _e514 {
                            phi_903_ = _e468[2];
                        } else {
                            phi_903_ = _e536;
                        }
                        let _e539 = phi_903_;
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
                            phi_976_ = _e443[0];
                        } else {
                            phi_976_ = _e443[1];
                        }
                        let _e577 = phi_976_;
                        let _e578 = (_e421 == 2u);
                        if _e578 {
                            phi_982_ = _e443[2];
                        } else {
                            phi_982_ = _e577;
                        }
                        let _e581 = phi_982_;
                        let _e582 = bitcast<u32>(_e581);
                        let _e584 = ((_e582 & 2139095040u) != 0u);
                        let _e596 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e582 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e582 & 2147483648u))), _e581, _e584) * select(0.00000011920929f, 1f, _e584));
                        if _e573 {
                            phi_1022_ = _e468[0];
                        } else {
                            phi_1022_ = _e468[1];
                        }
                        let _e600 = phi_1022_;
                        if _e578 {
                            phi_1028_ = _e468[2];
                        } else {
                            phi_1028_ = _e600;
                        }
                        let _e603 = phi_1028_;
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
                                phi_1147_ = 255i;
                            } else {
                                phi_1147_ = (((_e653 + select(0i, 1i, (_e653 == 0i))) - _e660) + _e401);
                            }
                            let _e668 = phi_1147_;
                            let _e678 = (_e668 <= 0i);
                            if _e678 {
                                phi_1170_ = u32();
                            } else {
                                if _e657 {
                                    phi_1169_ = u32();
                                } else {
                                    phi_1169_ = select(((bitcast<u32>(_e668) << bitcast<u32>(23i)) | ((_e650 << bitcast<u32>(((_e660 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e668 >= 255i));
                                }
                                let _e682 = phi_1169_;
                                phi_1170_ = _e682;
                            }
                            let _e684 = phi_1170_;
                            let _e696 = ((_e378 & 8388607u) | (select(0u, 1u, ((_e378 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e699 = bitcast<i32>((_e378 >> bitcast<u32>(23i)));
                            let _e703 = (_e696 == 0u);
                            let _e706 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e696)), 32u, _e703)) - 8i);
                            if (_e699 == 255i) {
                                phi_1207_ = 255i;
                            } else {
                                phi_1207_ = (((_e699 + select(0i, 1i, (_e699 == 0i))) - _e706) + _e401);
                            }
                            let _e714 = phi_1207_;
                            let _e724 = (_e714 <= 0i);
                            if _e724 {
                                phi_1230_ = u32();
                            } else {
                                if _e703 {
                                    phi_1229_ = u32();
                                } else {
                                    phi_1229_ = select(((bitcast<u32>(_e714) << bitcast<u32>(23i)) | ((_e696 << bitcast<u32>(((_e706 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e714 >= 255i));
                                }
                                let _e728 = phi_1229_;
                                phi_1230_ = _e728;
                            }
                            let _e730 = phi_1230_;
                            phi_1238_ = bitcast<f32>(((_e377 & 2147483648u) | select(_e730, 0u, select(_e703, true, _e724))));
                            phi_1239_ = bitcast<f32>(((_e372 & 2147483648u) | select(_e684, 0u, select(_e657, true, _e678))));
                        } else {
                            phi_1238_ = 0f;
                            phi_1239_ = 1f;
                        }
                        let _e736 = phi_1238_;
                        let _e738 = phi_1239_;
                        local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 3>(bitcast<f32>(_e114), bitcast<f32>(_e118), bitcast<f32>(_e122));
                        let _e745 = (_e420 % 3u);
                        let _e746 = (_e745 < 3u);
                        if _e746 {
                        } else {
                            break;
                        }
                        let _e748 = local_9[_e745];
                        let _e749 = (_e419 % 3u);
                        let _e750 = (_e749 < 3u);
                        if _e750 {
                        } else {
                            break;
                        }
                        let _e752 = local_9[_e749];
                        let _e753 = (_e421 % 3u);
                        let _e754 = (_e753 < 3u);
                        if _e754 {
                        } else {
                            break;
                        }
                        let _e756 = local_9[_e753];
                        local_8 = array<f32, 3>(bitcast<f32>(_e126), bitcast<f32>(_e130), bitcast<f32>(_e134));
                        if _e746 {
                        } else {
                            break;
                        }
                        let _e760 = local_8[_e745];
                        if _e750 {
                        } else {
                            break;
                        }
                        let _e762 = local_8[_e749];
                        if _e754 {
                        } else {
                            break;
                        }
                        let _e764 = local_8[_e753];
                        phi_3955_ = false;
                        phi_1322_ = type_47(_e736, false);
                        phi_1325_ = (_e738 <= _e736);
                        phi_1327_ = type_63(type_61(array<f32, 3>(_e748, _e752, _e756), array<f32, 3>(_e760, _e762, _e764)), select(0u, 2147483648u, (_e96 == 0u)));
                        phi_1329_ = 0u;
                        phi_1331_ = ((3u * _e96) + 1u);
                        loop {
                            let _e770 = phi_3955_;
                            let _e772 = phi_1322_;
                            let _e774 = phi_1325_;
                            let _e776 = phi_1327_;
                            let _e778 = phi_1329_;
                            let _e780 = phi_1331_;
                            local_11 = _e772;
                            if _e774 {
                                phi_1342_ = true;
                            } else {
                                phi_1342_ = (_e778 > 0u);
                            }
                            let _e783 = phi_1342_;
                            if _e783 {
                                let _e784 = (_e780 > 0u);
                                if _e784 {
                                    if _e774 {
                                        phi_1428_ = _e774;
                                        phi_1429_ = _e776;
                                        phi_1430_ = _e778;
                                    } else {
                                        let _e785 = (_e778 - 1u);
                                        let _e786 = (_e785 % 128u);
                                        let _e787 = (_e786 < 128u);
                                        if _e787 {
                                        } else {
                                            phi_4134_ = true;
                                            break;
                                        }
                                        let _e789 = local_6[_e786];
                                        if _e787 {
                                        } else {
                                            phi_4134_ = true;
                                            break;
                                        }
                                        let _e791 = local_5[_e786];
                                        if _e787 {
                                        } else {
                                            phi_4134_ = true;
                                            break;
                                        }
                                        let _e793 = local_4[_e786];
                                        if _e787 {
                                        } else {
                                            phi_4134_ = true;
                                            break;
                                        }
                                        let _e795 = local_3[_e786];
                                        if _e787 {
                                        } else {
                                            phi_4134_ = true;
                                            break;
                                        }
                                        let _e798 = local_2[_e786];
                                        if _e787 {
                                        } else {
                                            phi_4134_ = true;
                                            break;
                                        }
                                        let _e800 = local_1[_e786];
                                        if _e787 {
                                        } else {
                                            phi_4134_ = true;
                                            break;
                                        }
                                        let _e802 = local[_e786];
                                        if _e787 {
                                        } else {
                                            phi_4134_ = true;
                                            break;
                                        }
                                        let _e807 = local_7[_e786];
                                        phi_1428_ = (_e807 <= _e772.member);
                                        phi_1429_ = type_63(type_61(array<f32, 3>(_e791, _e793, _e795), array<f32, 3>(_e798, _e800, _e802)), _e789);
                                        phi_1430_ = _e785;
                                    }
                                    let _e811 = phi_1428_;
                                    let _e813 = phi_1429_;
                                    let _e815 = phi_1430_;
                                    if _e811 {
                                        if ((_e813.member_1 & 2147483648u) != 0u) {
                                            phi_1448_ = _e772;
                                            phi_1451_ = type_8(0u, ((_e813.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1190 = phi_1448_;
                                                let _e1192 = phi_1451_;
                                                local_10 = _e1190;
                                                local_12 = _e1190;
                                                if (_e1192.member < _e1192.member_1) {
                                                    phi_1452_ = type_8((_e1192.member + 1u), _e1192.member_1);
                                                    phi_1474_ = type_8(1u, _e1192.member);
                                                } else {
                                                    phi_1452_ = _e1192;
                                                    phi_1474_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1205 = phi_1452_;
                                                let _e1207 = phi_1474_;
                                                let _e1211 = (bitcast<i32>(_e1207.member) != 0i);
                                                if _e1211 {
                                                    let _e1212 = ((_e813.member_1 & 268435455u) + _e1207.member_1);
                                                    let _e1213 = (_e1212 < _e98);
                                                    if _e1213 {
                                                        if _e1213 {
                                                        } else {
                                                            phi_3949_ = true;
                                                            break;
                                                        }
                                                        let _e1217 = global_5.member[_e1212].member_1;
                                                        phi_1495_ = _e1217;
                                                    } else {
                                                        phi_1495_ = 4294967295u;
                                                    }
                                                    let _e1219 = phi_1495_;
                                                    if (_e1212 >= _e98) {
                                                        phi_1587_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1213 {
                                                        } else {
                                                            phi_3949_ = true;
                                                            break;
                                                        }
                                                        if (_e745 < 9u) {
                                                        } else {
                                                            phi_3949_ = true;
                                                            break;
                                                        }
                                                        let _e1226 = global_5.member[_e1212].member[_e745];
                                                        if (_e749 < 9u) {
                                                        } else {
                                                            phi_3949_ = true;
                                                            break;
                                                        }
                                                        let _e1232 = global_5.member[_e1212].member[_e749];
                                                        if (_e753 < 9u) {
                                                        } else {
                                                            phi_3949_ = true;
                                                            break;
                                                        }
                                                        let _e1238 = global_5.member[_e1212].member[_e753];
                                                        let _e1240 = (3u + _e745);
                                                        if (_e1240 < 9u) {
                                                        } else {
                                                            phi_3949_ = true;
                                                            break;
                                                        }
                                                        let _e1246 = global_5.member[_e1212].member[_e1240];
                                                        let _e1247 = (3u + _e749);
                                                        if (_e1247 < 9u) {
                                                        } else {
                                                            phi_3949_ = true;
                                                            break;
                                                        }
                                                        let _e1253 = global_5.member[_e1212].member[_e1247];
                                                        let _e1254 = (3u + _e753);
                                                        if (_e1254 < 9u) {
                                                        } else {
                                                            phi_3949_ = true;
                                                            break;
                                                        }
                                                        let _e1260 = global_5.member[_e1212].member[_e1254];
                                                        let _e1262 = (6u + _e745);
                                                        if (_e1262 < 9u) {
                                                        } else {
                                                            phi_3949_ = true;
                                                            break;
                                                        }
                                                        let _e1268 = global_5.member[_e1212].member[_e1262];
                                                        let _e1269 = (6u + _e749);
                                                        if (_e1269 < 9u) {
                                                        } else {
                                                            phi_3949_ = true;
                                                            break;
                                                        }
                                                        let _e1275 = global_5.member[_e1212].member[_e1269];
                                                        let _e1276 = (6u + _e753);
                                                        if (_e1276 < 9u) {
                                                        } else {
                                                            phi_3949_ = true;
                                                            break;
                                                        }
                                                        let _e1282 = global_5.member[_e1212].member[_e1276];
                                                        phi_1587_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1226, _e1232, _e1238), array<f32, 3>(_e1246, _e1253, _e1260), array<f32, 3>(_e1268, _e1275, _e1282));
                                                    }
                                                    let _e1286 = phi_1587_;
                                                    let _e1302 = (_e1286[0][2] - _e596);
                                                    let _e1305 = (((_e1286[0][0] - _e467) * _e632) - (_e1302 * _e504));
                                                    let _e1308 = (((_e1286[0][1] - _e532) * _e632) - (_e1302 * _e568));
                                                    let _e1311 = (_e1286[1][2] - _e596);
                                                    let _e1314 = (((_e1286[1][0] - _e467) * _e632) - (_e1311 * _e504));
                                                    let _e1317 = (((_e1286[1][1] - _e532) * _e632) - (_e1311 * _e568));
                                                    let _e1320 = (_e1286[2][2] - _e596);
                                                    let _e1323 = (((_e1286[2][0] - _e467) * _e632) - (_e1320 * _e504));
                                                    let _e1326 = (((_e1286[2][1] - _e532) * _e632) - (_e1320 * _e568));
                                                    let _e1327 = (_e1323 * _e1317);
                                                    let _e1328 = (_e1326 * _e1314);
                                                    let _e1329 = (_e1305 * _e1326);
                                                    let _e1330 = (_e1308 * _e1323);
                                                    let _e1331 = (_e1314 * _e1308);
                                                    let _e1332 = (_e1317 * _e1305);
                                                    let _e1337 = (((_e1327 >= _e1328) && (_e1329 >= _e1330)) && (_e1331 >= _e1332));
                                                    let _e1343 = (_e1337 || (((_e1327 <= _e1328) && (_e1329 <= _e1330)) && (_e1331 <= _e1332)));
                                                    if _e1343 {
                                                        let _e1345 = select(-1f, 1f, _e1337);
                                                        let _e1347 = ((_e1327 - _e1328) * _e1345);
                                                        let _e1349 = select(0f, _e1347, (_e1347 > 0f));
                                                        let _e1351 = ((_e1329 - _e1330) * _e1345);
                                                        let _e1353 = select(0f, _e1351, (_e1351 > 0f));
                                                        let _e1355 = ((_e1331 - _e1332) * _e1345);
                                                        let _e1357 = select(0f, _e1355, (_e1355 > 0f));
                                                        let _e1359 = ((_e1349 + _e1353) + _e1357);
                                                        let _e1361 = select(_e1286[1][0], _e1286[0][0], (_e1286[0][0] < _e1286[1][0]));
                                                        let _e1365 = select(_e1286[1][0], _e1286[0][0], (_e1286[0][0] > _e1286[1][0]));
                                                        let _e1369 = select(_e1286[1][1], _e1286[0][1], (_e1286[0][1] < _e1286[1][1]));
                                                        let _e1373 = select(_e1286[1][1], _e1286[0][1], (_e1286[0][1] > _e1286[1][1]));
                                                        let _e1377 = select(_e1286[1][2], _e1286[0][2], (_e1286[0][2] < _e1286[1][2]));
                                                        let _e1381 = select(_e1286[1][2], _e1286[0][2], (_e1286[0][2] > _e1286[1][2]));
                                                        let _e1386 = ((select(_e1286[2][0], _e1361, (_e1361 < _e1286[2][0])) - _e505) * _e508);
                                                        let _e1387 = ((select(_e1286[2][0], _e1365, (_e1365 > _e1286[2][0])) - _e506) * _e508);
                                                        let _e1390 = ((select(_e1286[2][1], _e1369, (_e1369 < _e1286[2][1])) - _e569) * _e572);
                                                        let _e1391 = ((select(_e1286[2][1], _e1373, (_e1373 > _e1286[2][1])) - _e570) * _e572);
                                                        let _e1394 = ((select(_e1286[2][2], _e1377, (_e1377 < _e1286[2][2])) - _e633) * _e636);
                                                        let _e1395 = ((select(_e1286[2][2], _e1381, (_e1381 > _e1286[2][2])) - _e634) * _e636);
                                                        let _e1397 = select(_e1395, _e1394, (_e1394 < _e1395));
                                                        let _e1399 = select(_e1395, _e1394, (_e1394 > _e1395));
                                                        let _e1401 = select(_e1387, _e1386, (_e1386 < _e1387));
                                                        let _e1403 = select(_e1391, _e1390, (_e1390 < _e1391));
                                                        let _e1405 = select(_e1403, _e1401, (_e1401 > _e1403));
                                                        let _e1407 = select(_e1397, _e1405, (_e1405 > _e1397));
                                                        let _e1409 = select(_e1387, _e1386, (_e1386 > _e1387));
                                                        let _e1411 = select(_e1391, _e1390, (_e1390 > _e1391));
                                                        let _e1413 = select(_e1411, _e1409, (_e1409 < _e1411));
                                                        let _e1415 = select(_e1399, _e1413, (_e1413 < _e1399));
                                                        let _e1416 = -(_e1397);
                                                        let _e1422 = select(_e738, _e1407, (_e1407 > _e738));
                                                        let _e1426 = select(_e1314, _e1305, (_e1305 < _e1314));
                                                        let _e1431 = select(_e1314, _e1305, (_e1305 > _e1314));
                                                        let _e1438 = select(_e1317, _e1308, (_e1308 < _e1317));
                                                        let _e1443 = select(_e1317, _e1308, (_e1308 > _e1317));
                                                        let _e1452 = (((((_e1343 && (_e1359 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1323, _e1426, (_e1426 < _e1323)) <= 0f) && (select(_e1323, _e1431, (_e1431 > _e1323)) >= 0f))) && ((select(_e1326, _e1438, (_e1438 < _e1326)) <= 0f) && (select(_e1326, _e1443, (_e1443 > _e1326)) >= 0f))) && (_e1422 <= (_e1415 + (select(_e1416, _e1399, (_e1399 > _e1416)) * 0.0000019073523f)))) && (_e1422 <= _e1190.member));
                                                        if _e1452 {
                                                            let _e1457 = (_e1286[1][0] - _e1286[0][0]);
                                                            let _e1458 = (_e1286[1][1] - _e1286[0][1]);
                                                            let _e1459 = (_e1286[1][2] - _e1286[0][2]);
                                                            let _e1460 = vec3<f32>(_e1457, _e1458, _e1459);
                                                            let _e1461 = (_e1286[2][0] - _e1286[1][0]);
                                                            let _e1462 = (_e1286[2][1] - _e1286[1][1]);
                                                            let _e1463 = (_e1286[2][2] - _e1286[1][2]);
                                                            let _e1464 = vec3<f32>(_e1461, _e1462, _e1463);
                                                            let _e1465 = (_e1286[0][0] - _e1286[2][0]);
                                                            let _e1466 = (_e1286[0][1] - _e1286[2][1]);
                                                            let _e1467 = (_e1286[0][2] - _e1286[2][2]);
                                                            let _e1468 = vec3<f32>(_e1465, _e1466, _e1467);
                                                            let _e1471 = bitcast<f32>((bitcast<u32>(_e1457) & 2147483647u));
                                                            let _e1474 = bitcast<f32>((bitcast<u32>(_e1458) & 2147483647u));
                                                            let _e1476 = select(_e1474, _e1471, (_e1471 > _e1474));
                                                            let _e1479 = bitcast<f32>((bitcast<u32>(_e1459) & 2147483647u));
                                                            let _e1481 = select(_e1479, _e1476, (_e1476 > _e1479));
                                                            let _e1484 = bitcast<f32>((bitcast<u32>(_e1461) & 2147483647u));
                                                            let _e1487 = bitcast<f32>((bitcast<u32>(_e1462) & 2147483647u));
                                                            let _e1489 = select(_e1487, _e1484, (_e1484 > _e1487));
                                                            let _e1492 = bitcast<f32>((bitcast<u32>(_e1463) & 2147483647u));
                                                            let _e1494 = select(_e1492, _e1489, (_e1489 > _e1492));
                                                            let _e1497 = bitcast<f32>((bitcast<u32>(_e1465) & 2147483647u));
                                                            let _e1500 = bitcast<f32>((bitcast<u32>(_e1466) & 2147483647u));
                                                            let _e1502 = select(_e1500, _e1497, (_e1497 > _e1500));
                                                            let _e1505 = bitcast<f32>((bitcast<u32>(_e1467) & 2147483647u));
                                                            let _e1507 = select(_e1505, _e1502, (_e1502 > _e1505));
                                                            let _e1509 = select(_e1494, _e1481, (_e1481 > _e1494));
                                                            let _e1511 = select(_e1507, _e1509, (_e1509 > _e1507));
                                                            if (_e1481 == _e1511) {
                                                                phi_2117_ = _e1317;
                                                                phi_2118_ = _e1314;
                                                                phi_2119_ = _e1308;
                                                                phi_2120_ = _e1305;
                                                                phi_2121_ = vec3<f32>(_e1286[0][0], _e1286[0][1], _e1286[0][2]);
                                                                phi_2122_ = _e1468;
                                                                phi_2123_ = _e1464;
                                                                phi_2124_ = _e1460;
                                                            } else {
                                                                let _e1513 = (_e1494 == _e1511);
                                                                let _e1518 = vec3(_e1513);
                                                                phi_2117_ = select(_e1308, _e1326, _e1513);
                                                                phi_2118_ = select(_e1305, _e1323, _e1513);
                                                                phi_2119_ = select(_e1326, _e1317, _e1513);
                                                                phi_2120_ = select(_e1323, _e1314, _e1513);
                                                                phi_2121_ = select(vec3<f32>(_e1286[2][0], _e1286[2][1], _e1286[2][2]), vec3<f32>(_e1286[1][0], _e1286[1][1], _e1286[1][2]), _e1518);
                                                                phi_2122_ = select(_e1464, _e1460, _e1518);
                                                                phi_2123_ = select(_e1460, _e1468, _e1518);
                                                                phi_2124_ = select(_e1468, _e1464, _e1518);
                                                            }
                                                            let _e1524 = phi_2117_;
                                                            let _e1526 = phi_2118_;
                                                            let _e1528 = phi_2119_;
                                                            let _e1530 = phi_2120_;
                                                            let _e1532 = phi_2121_;
                                                            let _e1534 = phi_2122_;
                                                            let _e1536 = phi_2123_;
                                                            let _e1538 = phi_2124_;
                                                            let _e1545 = ((_e1536.y * _e1534.z) - (_e1534.y * _e1536.z));
                                                            let _e1550 = ((_e1536.z * _e1534.x) - (_e1534.z * _e1536.x));
                                                            let _e1553 = ((_e1536.x * _e1534.y) - (_e1534.x * _e1536.y));
                                                            let _e1556 = ((_e1349 >= _e1353) && (_e1349 >= _e1357));
                                                            let _e1557 = (_e1353 >= _e1357);
                                                            let _e1571 = (((_e1545 * (select(select(_e1286[2][0], _e1286[1][0], _e1557), _e1286[0][0], _e1556) - _e467)) + (_e1550 * (select(select(_e1286[2][1], _e1286[1][1], _e1557), _e1286[0][1], _e1556) - _e532))) + (_e1553 * (select(select(_e1286[2][2], _e1286[1][2], _e1557), _e1286[0][2], _e1556) - _e596)));
                                                            let _e1576 = (((_e1545 * _e504) + (_e1550 * _e568)) + (_e1553 * _e632));
                                                            let _e1577 = (_e1526 - _e1530);
                                                            let _e1578 = (_e1524 - _e1528);
                                                            let _e1581 = ((_e1577 * _e1577) + (_e1578 * _e1578));
                                                            let _e1588 = (-(((_e1530 * _e1577) + (_e1528 * _e1578))) / select(0.000000000000000000000000000000000000011754944f, _e1581, (_e1581 > 0.000000000000000000000000000000000000011754944f)));
                                                            let _e1590 = select(1f, _e1588, (_e1588 < 1f));
                                                            let _e1592 = select(0f, _e1590, (_e1590 > 0f));
                                                            let _e1601 = ((_e1532.x + (_e1538.x * _e1592)) - _e467);
                                                            let _e1604 = ((_e1532.y + (_e1538.y * _e1592)) - _e532);
                                                            let _e1607 = ((_e1532.z + (_e1538.z * _e1592)) - _e596);
                                                            let _e1610 = bitcast<f32>((bitcast<u32>(_e1601) & 2147483647u));
                                                            let _e1613 = bitcast<f32>((bitcast<u32>(_e1604) & 2147483647u));
                                                            let _e1615 = select(_e1613, _e1610, (_e1610 > _e1613));
                                                            let _e1618 = bitcast<f32>((bitcast<u32>(_e1607) & 2147483647u));
                                                            let _e1620 = select(_e1618, _e1615, (_e1615 > _e1618));
                                                            let _e1626 = bitcast<f32>((bitcast<u32>(_e1545) & 2147483647u));
                                                            let _e1629 = bitcast<f32>((bitcast<u32>(_e1550) & 2147483647u));
                                                            let _e1631 = select(_e1629, _e1626, (_e1626 > _e1629));
                                                            let _e1634 = bitcast<f32>((bitcast<u32>(_e1553) & 2147483647u));
                                                            let _e1653 = bitcast<f32>((bitcast<u32>(_e1536.x) & 2147483647u));
                                                            let _e1656 = bitcast<f32>((bitcast<u32>(_e1536.y) & 2147483647u));
                                                            let _e1658 = select(_e1656, _e1653, (_e1653 > _e1656));
                                                            let _e1661 = bitcast<f32>((bitcast<u32>(_e1536.z) & 2147483647u));
                                                            let _e1667 = bitcast<f32>((bitcast<u32>(_e1534.x) & 2147483647u));
                                                            let _e1670 = bitcast<f32>((bitcast<u32>(_e1534.y) & 2147483647u));
                                                            let _e1672 = select(_e1670, _e1667, (_e1667 > _e1670));
                                                            let _e1675 = bitcast<f32>((bitcast<u32>(_e1534.z) & 2147483647u));
                                                            let _e1681 = ((bitcast<f32>((bitcast<u32>(((((_e1545 * _e1601) + (_e1550 * _e1604)) + (_e1553 * _e1607)) - _e1571)) & 2147483647u)) <= ((0.0000009536743f * select(_e1511, _e1620, (_e1620 > _e1511))) * select(_e1634, _e1631, (_e1631 > _e1634)))) && !((bitcast<f32>((bitcast<u32>(_e1576) & 2147483647u)) <= ((0.0000038146973f * select(_e1661, _e1658, (_e1658 > _e1661))) * select(_e1675, _e1672, (_e1672 > _e1675))))));
                                                            let _e1682 = (_e1571 / _e1576);
                                                            if (_e1452 && !(_e1681)) {
                                                                let _e1685 = (_e1607 / _e632);
                                                                let _e1693 = (((_e1545 * (_e1601 - (_e504 * _e1685))) + (_e1550 * (_e1604 - (_e568 * _e1685)))) / _e1576);
                                                                phi_2315_ = select(select(_e1685, (_e1685 + _e1693), (bitcast<f32>((bitcast<u32>(_e1693) & 2147483647u)) <= _e1511)), _e1682, _e1681);
                                                            } else {
                                                                phi_2315_ = _e1682;
                                                            }
                                                            let _e1702 = phi_2315_;
                                                            let _e1704 = select(_e1415, _e1702, (_e1702 < _e1415));
                                                            let _e1706 = select(_e1407, _e1704, (_e1704 > _e1407));
                                                            let _e1707 = (1f / _e1359);
                                                            phi_2335_ = type_46(_e1706, (_e1353 * _e1707), (_e1357 * _e1707), ((_e1452 && (_e1706 >= _e738)) && (_e1706 <= _e1190.member)));
                                                            phi_2336_ = type_46();
                                                        } else {
                                                            phi_2335_ = type_46();
                                                            phi_2336_ = type_46(0f, 0f, 0f, _e1452);
                                                        }
                                                        let _e1716 = phi_2335_;
                                                        let _e1718 = phi_2336_;
                                                        phi_2339_ = _e1716;
                                                        phi_2340_ = _e1718;
                                                        phi_2341_ = select(true, false, _e1452);
                                                    } else {
                                                        phi_2339_ = type_46();
                                                        phi_2340_ = type_46(0f, 0f, 0f, _e1343);
                                                        phi_2341_ = true;
                                                    }
                                                    let _e1721 = phi_2339_;
                                                    let _e1723 = phi_2340_;
                                                    let _e1725 = phi_2341_;
                                                    if _e1725 {
                                                        phi_2345_ = _e1723;
                                                    } else {
                                                        phi_2345_ = _e1721;
                                                    }
                                                    let _e1727 = phi_2345_;
                                                    if _e1727.member_3 {
                                                        phi_2354_ = type_27(_e1727.member, _e1727.member_1, _e1727.member_2, _e1219);
                                                    } else {
                                                        phi_2354_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    }
                                                    let _e1734 = phi_2354_;
                                                    if (_e1734.member_3 != 4294967295u) {
                                                        if (_e1219 == _e155) {
                                                            phi_2689_ = false;
                                                        } else {
                                                            let _e1738 = (_e1219 < arrayLength((&global_6.member)));
                                                            if _e1738 {
                                                                if _e1738 {
                                                                } else {
                                                                    phi_3949_ = true;
                                                                    break;
                                                                }
                                                                let _e1740 = global_6.member[_e1219];
                                                                phi_2377_ = _e1740;
                                                            } else {
                                                                phi_2377_ = 4294967295u;
                                                            }
                                                            let _e1742 = phi_2377_;
                                                            let _e1743 = (_e1742 < arrayLength((&global_7.member)));
                                                            if _e1743 {
                                                                if _e1743 {
                                                                } else {
                                                                    phi_3949_ = true;
                                                                    break;
                                                                }
                                                                let _e1745 = global_7.member[_e1742];
                                                                phi_2391_ = _e1745;
                                                            } else {
                                                                phi_2391_ = 0i;
                                                            }
                                                            let _e1747 = phi_2391_;
                                                            let _e1748 = (_e1747 == 0i);
                                                            if _e1748 {
                                                                phi_2688_ = true;
                                                            } else {
                                                                if _e444 {
                                                                    phi_2414_ = vec3<f32>(_e1286[0][0], _e1286[0][1], _e1286[0][2]);
                                                                } else {
                                                                    if (_e420 == 1u) {
                                                                        phi_2413_ = vec3<f32>(_e1286[0][2], _e1286[0][0], _e1286[0][1]);
                                                                    } else {
                                                                        phi_2413_ = vec3<f32>(_e1286[0][1], _e1286[0][2], _e1286[0][0]);
                                                                    }
                                                                    let _e1753 = phi_2413_;
                                                                    phi_2414_ = _e1753;
                                                                }
                                                                let _e1756 = phi_2414_;
                                                                if _e444 {
                                                                    phi_2433_ = vec3<f32>(_e1286[1][0], _e1286[1][1], _e1286[1][2]);
                                                                } else {
                                                                    if (_e420 == 1u) {
                                                                        phi_2432_ = vec3<f32>(_e1286[1][2], _e1286[1][0], _e1286[1][1]);
                                                                    } else {
                                                                        phi_2432_ = vec3<f32>(_e1286[1][1], _e1286[1][2], _e1286[1][0]);
                                                                    }
                                                                    let _e1761 = phi_2432_;
                                                                    phi_2433_ = _e1761;
                                                                }
                                                                let _e1764 = phi_2433_;
                                                                if _e444 {
                                                                    phi_2452_ = vec3<f32>(_e1286[2][0], _e1286[2][1], _e1286[2][2]);
                                                                } else {
                                                                    if (_e420 == 1u) {
                                                                        phi_2451_ = vec3<f32>(_e1286[2][2], _e1286[2][0], _e1286[2][1]);
                                                                    } else {
                                                                        phi_2451_ = vec3<f32>(_e1286[2][1], _e1286[2][2], _e1286[2][0]);
                                                                    }
                                                                    let _e1769 = phi_2451_;
                                                                    phi_2452_ = _e1769;
                                                                }
                                                                let _e1772 = phi_2452_;
                                                                let _e1775 = (_e1764.x - _e1756.x);
                                                                let _e1778 = (_e1764.y - _e1756.y);
                                                                let _e1781 = (_e1764.z - _e1756.z);
                                                                let _e1783 = (_e1772.x - _e1756.x);
                                                                let _e1785 = (_e1772.y - _e1756.y);
                                                                let _e1787 = (_e1772.z - _e1756.z);
                                                                if (_e287.member_1 == 1u) {
                                                                    phi_2488_ = (vec3<f32>(_e287.member[0], _e287.member[1], _e287.member[2]) - _e1756);
                                                                } else {
                                                                    phi_2488_ = vec3<f32>(_e287.member[0], _e287.member[1], _e287.member[2]);
                                                                }
                                                                let _e1802 = phi_2488_;
                                                                let _e1808 = bitcast<f32>((bitcast<u32>((_e1775 * _e1785)) ^ _e287.member_3[0]));
                                                                let _e1812 = bitcast<f32>((bitcast<u32>((_e1778 * _e1783)) ^ _e287.member_3[0]));
                                                                let _e1816 = bitcast<f32>((bitcast<u32>((_e1778 * _e1787)) ^ _e287.member_3[0]));
                                                                let _e1820 = bitcast<f32>((bitcast<u32>((_e1781 * _e1785)) ^ _e287.member_3[0]));
                                                                let _e1824 = bitcast<f32>((bitcast<u32>((_e1781 * _e1783)) ^ _e287.member_3[0]));
                                                                let _e1828 = bitcast<f32>((bitcast<u32>((_e1775 * _e1787)) ^ _e287.member_3[0]));
                                                                let _e1829 = (_e1816 - _e1820);
                                                                let _e1830 = (_e1824 - _e1828);
                                                                let _e1831 = (_e1808 - _e1812);
                                                                let _e1855 = (bitcast<f32>((bitcast<u32>(_e1816) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1820) & 2147483647u)));
                                                                let _e1862 = (bitcast<f32>((bitcast<u32>(_e1824) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1828) & 2147483647u)));
                                                                let _e1869 = (bitcast<f32>((bitcast<u32>(_e1808) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1812) & 2147483647u)));
                                                                if (_e287.member_2 == 0f) {
                                                                    phi_2670_ = 0f;
                                                                } else {
                                                                    let _e1899 = bitcast<f32>((bitcast<u32>(_e1829) & 2147483647u));
                                                                    let _e1902 = bitcast<f32>((bitcast<u32>(_e1830) & 2147483647u));
                                                                    let _e1905 = bitcast<f32>((bitcast<u32>(_e1831) & 2147483647u));
                                                                    let _e1907 = select(_e1905, _e1902, (_e1902 > _e1905));
                                                                    let _e1911 = select(_e1905, _e1902, (_e1902 < _e1905));
                                                                    let _e1915 = select(_e1902, _e1899, (_e1899 < _e1902));
                                                                    let _e1917 = select(_e1902, _e1899, (_e1899 > _e1902));
                                                                    let _e1919 = select(_e1905, _e1917, (_e1917 < _e1905));
                                                                    phi_2670_ = bitcast<f32>((bitcast<u32>((_e287.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1907, _e1899, (_e1899 > _e1907)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1919, _e1915, (_e1915 > _e1919)))) ^ _e287.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1911, _e1899, (_e1899 < _e1911)))) ^ _e287.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1855 + _e1862) + _e1869))) ^ _e287.member_3[0]))) * 1.0000005f)) ^ _e287.member_3[0])))) ^ _e287.member_3[0]));
                                                                }
                                                                let _e1946 = phi_2670_;
                                                                phi_2688_ = (_e1748 || !(((((bitcast<f32>((bitcast<u32>((_e1802.x * _e1829)) ^ _e287.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1802.y * _e1830)) ^ _e287.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1802.z * _e1831)) ^ _e287.member_3[0]))) * f32(-(_e1747))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1802.x) & 2147483647u)) * _e1855)) ^ _e287.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1802.y) & 2147483647u)) * _e1862)) ^ _e287.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1802.z) & 2147483647u)) * _e1869)) ^ _e287.member_3[0]))))) ^ _e287.member_3[0])) + _e1946) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1960 = phi_2688_;
                                                            phi_2689_ = _e1960;
                                                        }
                                                        let _e1962 = phi_2689_;
                                                        if _e1962 {
                                                            phi_2694_ = type_47(-340282350000000000000000000000000000000f, true);
                                                        } else {
                                                            phi_2694_ = _e1190;
                                                        }
                                                        let _e1964 = phi_2694_;
                                                        phi_2695_ = _e1964;
                                                    } else {
                                                        phi_2695_ = _e1190;
                                                    }
                                                    let _e1966 = phi_2695_;
                                                    phi_1449_ = _e1966;
                                                } else {
                                                    phi_1449_ = type_47();
                                                }
                                                let _e1968 = phi_1449_;
                                                continue;
                                                continuing {
                                                    phi_1448_ = _e1968;
                                                    phi_1451_ = _e1205;
                                                    phi_3949_ = _e770;
                                                    break if !(_e1211);
                                                }
                                            }
                                            let _e1971 = phi_3949_;
                                            phi_4134_ = _e1971;
                                            if _e1971 {
                                                break;
                                            }
                                            let _e1973 = local_10;
                                            phi_4138_ = _e1971;
                                            let _e2154 = local_12;
                                            phi_3699_ = _e2154;
                                            phi_3700_ = false;
                                            phi_3701_ = _e813;
                                            phi_3702_ = select(_e815, 0u, (_e738 > _e1973.member));
                                        } else {
                                            let _e824 = (_e813.member_1 < _e96);
                                            if _e824 {
                                                if _e824 {
                                                } else {
                                                    phi_4134_ = true;
                                                    break;
                                                }
                                                let _e826 = global_10.member[_e813.member_1];
                                                phi_2716_ = _e826;
                                            } else {
                                                phi_2716_ = type_56(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e828 = phi_2716_;
                                            let _e843 = ((10u * _e420) & 31u);
                                            let _e846 = ((_e828.member[0] >> bitcast<u32>(_e843)) & 1023u);
                                            let _e854 = bitcast<f32>((bitcast<u32>(((_e813.member.member_1[0] - _e813.member.member[0]) * 0.0009775171f)) ^ _e138));
                                            let _e859 = (_e813.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e846)) - 8388608f) * _e854)) ^ _e138)));
                                            let _e863 = select(select(_e813.member.member_1[0], _e859, (_e859 < _e813.member.member_1[0])), _e813.member.member_1[0], (_e846 == 1023u));
                                            let _e865 = ((10u * _e419) & 31u);
                                            let _e868 = ((_e828.member[0] >> bitcast<u32>(_e865)) & 1023u);
                                            let _e876 = bitcast<f32>((bitcast<u32>(((_e813.member.member_1[1] - _e813.member.member[1]) * 0.0009775171f)) ^ _e138));
                                            let _e881 = (_e813.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e868)) - 8388608f) * _e876)) ^ _e138)));
                                            let _e885 = select(select(_e813.member.member_1[1], _e881, (_e881 < _e813.member.member_1[1])), _e813.member.member_1[1], (_e868 == 1023u));
                                            let _e887 = ((10u * _e421) & 31u);
                                            let _e890 = ((_e828.member[0] >> bitcast<u32>(_e887)) & 1023u);
                                            let _e898 = bitcast<f32>((bitcast<u32>(((_e813.member.member_1[2] - _e813.member.member[2]) * 0.0009775171f)) ^ _e138));
                                            let _e903 = (_e813.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e890)) - 8388608f) * _e898)) ^ _e138)));
                                            let _e907 = select(select(_e813.member.member_1[2], _e903, (_e903 < _e813.member.member_1[2])), _e813.member.member_1[2], (_e890 == 1023u));
                                            let _e910 = ((_e828.member[1] >> bitcast<u32>(_e843)) & 1023u);
                                            let _e918 = (_e813.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e910)) - 8388608f) * _e854)) ^ _e138)));
                                            let _e922 = select(select(_e813.member.member_1[0], _e918, (_e918 < _e813.member.member_1[0])), _e813.member.member_1[0], (_e910 == 1023u));
                                            let _e925 = ((_e828.member[1] >> bitcast<u32>(_e865)) & 1023u);
                                            let _e933 = (_e813.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e925)) - 8388608f) * _e876)) ^ _e138)));
                                            let _e937 = select(select(_e813.member.member_1[1], _e933, (_e933 < _e813.member.member_1[1])), _e813.member.member_1[1], (_e925 == 1023u));
                                            let _e940 = ((_e828.member[1] >> bitcast<u32>(_e887)) & 1023u);
                                            let _e948 = (_e813.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e940)) - 8388608f) * _e898)) ^ _e138)));
                                            let _e952 = select(select(_e813.member.member_1[2], _e948, (_e948 < _e813.member.member_1[2])), _e813.member.member_1[2], (_e940 == 1023u));
                                            let _e958 = ((_e828.member_1[0] >> bitcast<u32>(_e843)) & 1023u);
                                            let _e966 = (_e813.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e958)) - 8388608f) * _e854)) ^ _e138)));
                                            let _e970 = select(select(_e813.member.member_1[0], _e966, (_e966 < _e813.member.member_1[0])), _e813.member.member_1[0], (_e958 == 1023u));
                                            let _e973 = ((_e828.member_1[0] >> bitcast<u32>(_e865)) & 1023u);
                                            let _e981 = (_e813.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e973)) - 8388608f) * _e876)) ^ _e138)));
                                            let _e985 = select(select(_e813.member.member_1[1], _e981, (_e981 < _e813.member.member_1[1])), _e813.member.member_1[1], (_e973 == 1023u));
                                            let _e988 = ((_e828.member_1[0] >> bitcast<u32>(_e887)) & 1023u);
                                            let _e996 = (_e813.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e988)) - 8388608f) * _e898)) ^ _e138)));
                                            let _e1000 = select(select(_e813.member.member_1[2], _e996, (_e996 < _e813.member.member_1[2])), _e813.member.member_1[2], (_e988 == 1023u));
                                            let _e1003 = ((_e828.member_1[1] >> bitcast<u32>(_e843)) & 1023u);
                                            let _e1011 = (_e813.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1003)) - 8388608f) * _e854)) ^ _e138)));
                                            let _e1015 = select(select(_e813.member.member_1[0], _e1011, (_e1011 < _e813.member.member_1[0])), _e813.member.member_1[0], (_e1003 == 1023u));
                                            let _e1018 = ((_e828.member_1[1] >> bitcast<u32>(_e865)) & 1023u);
                                            let _e1026 = (_e813.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1018)) - 8388608f) * _e876)) ^ _e138)));
                                            let _e1030 = select(select(_e813.member.member_1[1], _e1026, (_e1026 < _e813.member.member_1[1])), _e813.member.member_1[1], (_e1018 == 1023u));
                                            let _e1033 = ((_e828.member_1[1] >> bitcast<u32>(_e887)) & 1023u);
                                            let _e1041 = (_e813.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1033)) - 8388608f) * _e898)) ^ _e138)));
                                            let _e1045 = select(select(_e813.member.member_1[2], _e1041, (_e1041 < _e813.member.member_1[2])), _e813.member.member_1[2], (_e1033 == 1023u));
                                            let _e1050 = type_63(type_61(array<f32, 3>(_e863, _e885, _e907), array<f32, 3>(_e922, _e937, _e952)), _e828.member_2);
                                            let _e1055 = type_63(type_61(array<f32, 3>(_e970, _e985, _e1000), array<f32, 3>(_e1015, _e1030, _e1045)), _e828.member_3);
                                            let _e1061 = ((_e863 - _e505) * _e508);
                                            let _e1062 = ((_e970 - _e505) * _e508);
                                            let _e1063 = ((_e922 - _e506) * _e508);
                                            let _e1064 = ((_e1015 - _e506) * _e508);
                                            let _e1069 = ((_e885 - _e569) * _e572);
                                            let _e1070 = ((_e985 - _e569) * _e572);
                                            let _e1071 = ((_e937 - _e570) * _e572);
                                            let _e1072 = ((_e1030 - _e570) * _e572);
                                            let _e1077 = ((_e907 - _e633) * _e636);
                                            let _e1078 = ((_e1000 - _e633) * _e636);
                                            let _e1079 = ((_e952 - _e634) * _e636);
                                            let _e1080 = ((_e1045 - _e634) * _e636);
                                            let _e1082 = select(_e1079, _e1077, (_e1077 < _e1079));
                                            let _e1084 = select(_e1080, _e1078, (_e1078 < _e1080));
                                            let _e1086 = select(_e1079, _e1077, (_e1077 > _e1079));
                                            let _e1088 = select(_e1080, _e1078, (_e1078 > _e1080));
                                            let _e1090 = select(_e1063, _e1061, (_e1061 < _e1063));
                                            let _e1092 = select(_e1064, _e1062, (_e1062 < _e1064));
                                            let _e1094 = select(_e1071, _e1069, (_e1069 < _e1071));
                                            let _e1096 = select(_e1072, _e1070, (_e1070 < _e1072));
                                            let _e1098 = select(_e1094, _e1090, (_e1090 > _e1094));
                                            let _e1100 = select(_e1096, _e1092, (_e1092 > _e1096));
                                            let _e1102 = select(_e1082, _e1098, (_e1098 > _e1082));
                                            let _e1104 = select(_e1084, _e1100, (_e1100 > _e1084));
                                            let _e1106 = select(_e1063, _e1061, (_e1061 > _e1063));
                                            let _e1108 = select(_e1064, _e1062, (_e1062 > _e1064));
                                            let _e1110 = select(_e1071, _e1069, (_e1069 > _e1071));
                                            let _e1112 = select(_e1072, _e1070, (_e1070 > _e1072));
                                            let _e1114 = select(_e1110, _e1106, (_e1106 < _e1110));
                                            let _e1116 = select(_e1112, _e1108, (_e1108 < _e1112));
                                            let _e1121 = -(_e1082);
                                            let _e1122 = -(_e1084);
                                            let _e1129 = (select(_e1086, _e1114, (_e1114 < _e1086)) + (select(_e1121, _e1086, (_e1086 > _e1121)) * 0.0000019073523f));
                                            let _e1130 = (select(_e1088, _e1116, (_e1116 < _e1088)) + (select(_e1122, _e1088, (_e1088 > _e1122)) * 0.0000019073523f));
                                            let _e1132 = select(_e738, _e1102, (_e1102 > _e738));
                                            let _e1134 = select(_e738, _e1104, (_e1104 > _e738));
                                            let _e1139 = (_e1132 <= select(_e772.member, _e1129, (_e1129 < _e772.member)));
                                            let _e1140 = (_e1134 <= select(_e772.member, _e1130, (_e1130 < _e772.member)));
                                            let _e1141 = (_e1132 <= _e1134);
                                            if _e1139 {
                                                if _e1140 {
                                                    if _e1141 {
                                                        phi_3602_ = _e1055;
                                                    } else {
                                                        phi_3602_ = _e1050;
                                                    }
                                                    let _e1143 = phi_3602_;
                                                    let _e1150 = (_e815 % 128u);
                                                    let _e1151 = (_e1150 < 128u);
                                                    if _e1151 {
                                                    } else {
                                                        phi_4134_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1150] = _e1143.member_1;
                                                    if _e1151 {
                                                    } else {
                                                        phi_4134_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1150] = _e1143.member.member[0];
                                                    if _e1151 {
                                                    } else {
                                                        phi_4134_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1150] = _e1143.member.member[1];
                                                    if _e1151 {
                                                    } else {
                                                        phi_4134_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1150] = _e1143.member.member[2];
                                                    if _e1151 {
                                                    } else {
                                                        phi_4134_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1150] = _e1143.member.member_1[0];
                                                    if _e1151 {
                                                    } else {
                                                        phi_4134_ = true;
                                                        break;
                                                    }
                                                    local_1[_e1150] = _e1143.member.member_1[1];
                                                    if _e1151 {
                                                    } else {
                                                        phi_4134_ = true;
                                                        break;
                                                    }
                                                    local[_e1150] = _e1143.member.member_1[2];
                                                    if _e1151 {
                                                    } else {
                                                        phi_4134_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1150] = select(_e1132, _e1134, _e1141);
                                                    if _e1141 {
                                                        phi_3678_ = _e1050;
                                                    } else {
                                                        phi_3678_ = _e1055;
                                                    }
                                                    let _e1168 = phi_3678_;
                                                    phi_3679_ = _e1168;
                                                    phi_3680_ = (_e815 + 1u);
                                                } else {
                                                    phi_3679_ = type_63();
                                                    phi_3680_ = u32();
                                                }
                                                let _e1170 = phi_3679_;
                                                let _e1172 = phi_3680_;
                                                phi_3682_ = _e1170;
                                                phi_3683_ = _e1172;
                                                phi_3684_ = select(true, false, _e1140);
                                            } else {
                                                phi_3682_ = type_63();
                                                phi_3683_ = u32();
                                                phi_3684_ = true;
                                            }
                                            let _e1175 = phi_3682_;
                                            let _e1177 = phi_3683_;
                                            let _e1179 = phi_3684_;
                                            if _e1179 {
                                                if _e1139 {
                                                    phi_3691_ = _e1050;
                                                } else {
                                                    phi_3691_ = _e1055;
                                                }
                                                let _e1181 = phi_3691_;
                                                phi_3696_ = select(_e1140, true, _e1139);
                                                phi_3697_ = _e1181;
                                            } else {
                                                phi_3696_ = _e811;
                                                phi_3697_ = _e1175;
                                            }
                                            let _e1184 = phi_3696_;
                                            let _e1186 = phi_3697_;
                                            phi_4138_ = _e770;
                                            phi_3699_ = _e772;
                                            phi_3700_ = _e1184;
                                            phi_3701_ = _e1186;
                                            phi_3702_ = select(_e1177, _e815, _e1179);
                                        }
                                        let _e1978 = phi_4138_;
                                        let _e1980 = phi_3699_;
                                        let _e1982 = phi_3700_;
                                        let _e1984 = phi_3701_;
                                        let _e1986 = phi_3702_;
                                        phi_4137_ = _e1978;
                                        phi_3703_ = _e1980;
                                        phi_3704_ = _e1982;
                                        phi_3705_ = _e1984;
                                        phi_3706_ = _e1986;
                                        phi_3707_ = (_e780 - 1u);
                                    } else {
                                        phi_4137_ = _e770;
                                        phi_3703_ = _e772;
                                        phi_3704_ = _e811;
                                        phi_3705_ = _e813;
                                        phi_3706_ = _e815;
                                        phi_3707_ = _e780;
                                    }
                                    let _e1988 = phi_4137_;
                                    let _e1990 = phi_3703_;
                                    let _e1992 = phi_3704_;
                                    let _e1994 = phi_3705_;
                                    let _e1996 = phi_3706_;
                                    let _e1998 = phi_3707_;
                                    phi_4136_ = _e1988;
                                    phi_3708_ = _e1990;
                                    phi_3709_ = _e1992;
                                    phi_3710_ = _e1994;
                                    phi_3711_ = _e1996;
                                    phi_3712_ = _e1998;
                                } else {
                                    phi_4136_ = _e770;
                                    phi_3708_ = type_47();
                                    phi_3709_ = bool();
                                    phi_3710_ = type_63();
                                    phi_3711_ = u32();
                                    phi_3712_ = u32();
                                }
                                let _e2000 = phi_4136_;
                                let _e2002 = phi_3708_;
                                let _e2004 = phi_3709_;
                                let _e2006 = phi_3710_;
                                let _e2008 = phi_3711_;
                                let _e2010 = phi_3712_;
                                phi_4135_ = _e2000;
                                phi_1323_ = _e2002;
                                phi_1326_ = _e2004;
                                phi_1328_ = _e2006;
                                phi_1330_ = _e2008;
                                phi_1332_ = _e2010;
                                phi_3713_ = _e784;
                            } else {
                                phi_4135_ = _e770;
                                phi_1323_ = type_47();
                                phi_1326_ = bool();
                                phi_1328_ = type_63();
                                phi_1330_ = u32();
                                phi_1332_ = u32();
                                phi_3713_ = false;
                            }
                            let _e2012 = phi_4135_;
                            let _e2014 = phi_1323_;
                            let _e2016 = phi_1326_;
                            let _e2018 = phi_1328_;
                            let _e2020 = phi_1330_;
                            let _e2022 = phi_1332_;
                            let _e2024 = phi_3713_;
                            continue;
                            continuing {
                                phi_3955_ = _e2012;
                                phi_1322_ = _e2014;
                                phi_1325_ = _e2016;
                                phi_1327_ = _e2018;
                                phi_1329_ = _e2020;
                                phi_1331_ = _e2022;
                                phi_4134_ = _e2012;
                                break if !(_e2024);
                            }
                        }
                        let _e2027 = phi_4134_;
                        if _e2027 {
                            break;
                        }
                        let _e2029 = local_11;
                        if _e2029.member_1 {
                        } else {
                            if _e288 {
                            } else {
                                break;
                            }
                            let _e2033 = global_2.member[_e142];
                            if _e149 {
                            } else {
                                break;
                            }
                            let _e2037 = global_9.member[_e142].member_1;
                            if _e288 {
                            } else {
                                break;
                            }
                            global_2.member[_e142] = type_29(_e2033.member, _e2033.member_1, _e2033.member_2, array<f32, 3>((_e2033.member_3[0] + (_e2037[0] * _e2033.member_1[0])), (_e2033.member_3[1] + (_e2037[1] * _e2033.member_1[1])), (_e2033.member_3[2] + (_e2037[2] * _e2033.member_1[2]))), _e2033.member_4);
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
