struct type_4 {
    member: array<u32>,
}

struct type_10 {
    member: vec4<u32>,
}

struct type_15 {
    member: array<array<f32, 3>>,
}

struct type_19 {
    member: array<array<u32, 3>>,
}

struct type_28 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_30 {
    member: array<type_28>,
}

struct type_32 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_33 {
    member: type_32,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_35 {
    member: array<type_33>,
}

struct type_39 {
    member: vec3<f32>,
    member_1: vec3<f32>,
}

struct type_40 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: f32,
    member_3: f32,
    member_4: array<u32, 2>,
}

struct type_42 {
    member: array<type_40>,
}

struct type_45 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 3>,
    member_5: u32,
    member_6: array<f32, 3>,
    member_7: u32,
}

struct type_47 {
    member: array<type_45>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_10;
@group(0) @binding(1) 
var<storage> global_2: type_15;
@group(0) @binding(2) 
var<storage> global_3: type_19;
@group(0) @binding(3) 
var<storage> global_4: type_15;
@group(0) @binding(4) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage> global_6: type_42;
@group(0) @binding(6) 
var<storage> global_7: type_47;
@group(0) @binding(7) 
var<storage> global_8: type_30;
@group(0) @binding(8) 
var<storage, read_write> global_9: type_35;

fn function_() {
    var phi_1530_: i32;
    var phi_1561_: i32;
    var phi_1580_: vec3<f32>;
    var phi_208_: i32;
    var phi_232_: array<u32, 3>;
    var phi_247_: array<f32, 3>;
    var phi_265_: array<f32, 3>;
    var phi_283_: array<f32, 3>;
    var phi_366_: array<u32, 3>;
    var phi_383_: vec3<f32>;
    var phi_400_: vec3<f32>;
    var phi_417_: vec3<f32>;
    var phi_549_: i32;
    var phi_580_: i32;
    var phi_599_: vec3<f32>;
    var phi_682_: i32;
    var phi_713_: i32;
    var phi_732_: vec3<f32>;
    var phi_762_: u32;
    var phi_796_: f32;
    var phi_833_: f32;
    var phi_855_: f32;
    var phi_894_: i32;
    var phi_925_: i32;
    var phi_944_: vec3<f32>;
    var phi_984_: vec3<f32>;
    var phi_1030_: vec3<f32>;
    var phi_1031_: vec3<f32>;
    var phi_1118_: f32;
    var phi_1119_: f32;
    var phi_1121_: f32;
    var phi_1095_: f32;
    var phi_1096_: f32;
    var phi_1122_: f32;
    var phi_1166_: f32;
    var phi_1167_: f32;
    var phi_1169_: f32;
    var phi_1143_: f32;
    var phi_1144_: f32;
    var phi_1170_: f32;
    var phi_1214_: f32;
    var phi_1215_: f32;
    var phi_1217_: f32;
    var phi_1191_: f32;
    var phi_1192_: f32;
    var phi_1218_: f32;
    var phi_1221_: type_39;
    var phi_1223_: type_39;
    var phi_1224_: bool;
    var phi_1299_: f32;
    var phi_1300_: f32;
    var phi_1302_: f32;
    var phi_1276_: f32;
    var phi_1277_: f32;
    var phi_1303_: f32;
    var phi_1347_: f32;
    var phi_1348_: f32;
    var phi_1350_: f32;
    var phi_1324_: f32;
    var phi_1325_: f32;
    var phi_1351_: f32;
    var phi_1395_: f32;
    var phi_1396_: f32;
    var phi_1398_: f32;
    var phi_1372_: f32;
    var phi_1373_: f32;
    var phi_1399_: f32;
    var phi_1442_: vec3<f32>;
    var phi_1444_: type_39;
    var phi_1464_: vec3<f32>;
    var phi_1482_: type_33;
    var phi_1637_: type_33;

    switch bitcast<i32>(0u) {
        default: {
            let _e45 = global;
            let _e48 = arrayLength((&global_2.member));
            let _e53 = arrayLength((&global_4.member));
            let _e57 = arrayLength((&global_6.member));
            let _e59 = arrayLength((&global_7.member));
            let _e67 = (_e45.x + (_e45.y * 2097152u));
            let _e68 = (_e67 < arrayLength((&global_9.member)));
            if _e68 {
                let _e69 = (_e67 < arrayLength((&global_8.member)));
                if _e69 {
                    if (_e57 == 0u) {
                    } else {
                        if (_e59 == 0u) {
                        } else {
                            if _e68 {
                            } else {
                                break;
                            }
                            let _e74 = global_9.member[_e67];
                            if _e69 {
                            } else {
                                break;
                            }
                            let _e77 = global_8.member[_e67];
                            if (_e74.member.member_1 <= _e74.member.member_3) {
                                if (_e77.member_3 != 4294967295u) {
                                    let _e225 = global_1.member[0u];
                                    let _e226 = bitcast<i32>(_e225);
                                    if (_e226 < -126i) {
                                        phi_208_ = -126i;
                                    } else {
                                        phi_208_ = select(_e226, 127i, (_e226 > 127i));
                                    }
                                    let _e231 = phi_208_;
                                    let _e236 = bitcast<f32>((bitcast<u32>((_e231 + 127i)) << bitcast<u32>(23i)));
                                    let _e242 = bitcast<f32>((bitcast<u32>(((_e226 - _e231) + 127i)) << bitcast<u32>(23i)));
                                    let _e243 = (_e77.member_3 < arrayLength((&global_3.member)));
                                    if _e243 {
                                        if _e243 {
                                        } else {
                                            break;
                                        }
                                        let _e245 = global_3.member[_e77.member_3];
                                        phi_232_ = _e245;
                                    } else {
                                        phi_232_ = array<u32, 3>(0u, 0u, 0u);
                                    }
                                    let _e247 = phi_232_;
                                    let _e249 = (_e247[0] < _e48);
                                    if _e249 {
                                        if _e249 {
                                        } else {
                                            break;
                                        }
                                        let _e251 = global_2.member[_e247[0]];
                                        phi_247_ = _e251;
                                    } else {
                                        phi_247_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e253 = phi_247_;
                                    let _e258 = (_e247[1] < _e48);
                                    if _e258 {
                                        if _e258 {
                                        } else {
                                            break;
                                        }
                                        let _e260 = global_2.member[_e247[1]];
                                        phi_265_ = _e260;
                                    } else {
                                        phi_265_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e262 = phi_265_;
                                    let _e267 = (_e247[2] < _e48);
                                    if _e267 {
                                        if _e267 {
                                        } else {
                                            break;
                                        }
                                        let _e269 = global_2.member[_e247[2]];
                                        phi_283_ = _e269;
                                    } else {
                                        phi_283_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e271 = phi_283_;
                                    let _e276 = ((_e253[0] * _e236) * _e242);
                                    let _e278 = select(_e276, 0f, (_e276 == 0f));
                                    let _e280 = ((_e253[1] * _e236) * _e242);
                                    let _e282 = select(_e280, 0f, (_e280 == 0f));
                                    let _e284 = ((_e253[2] * _e236) * _e242);
                                    let _e286 = select(_e284, 0f, (_e284 == 0f));
                                    let _e288 = ((_e262[0] * _e236) * _e242);
                                    let _e290 = select(_e288, 0f, (_e288 == 0f));
                                    let _e292 = ((_e262[1] * _e236) * _e242);
                                    let _e294 = select(_e292, 0f, (_e292 == 0f));
                                    let _e296 = ((_e262[2] * _e236) * _e242);
                                    let _e298 = select(_e296, 0f, (_e296 == 0f));
                                    let _e300 = ((_e271[0] * _e236) * _e242);
                                    let _e302 = select(_e300, 0f, (_e300 == 0f));
                                    let _e304 = ((_e271[1] * _e236) * _e242);
                                    let _e306 = select(_e304, 0f, (_e304 == 0f));
                                    let _e308 = ((_e271[2] * _e236) * _e242);
                                    let _e310 = select(_e308, 0f, (_e308 == 0f));
                                    if _e243 {
                                        if _e243 {
                                        } else {
                                            break;
                                        }
                                        let _e312 = global_3.member[_e77.member_3];
                                        phi_366_ = _e312;
                                    } else {
                                        phi_366_ = array<u32, 3>(0u, 0u, 0u);
                                    }
                                    let _e314 = phi_366_;
                                    let _e316 = (_e314[0] < _e53);
                                    if _e316 {
                                        if _e316 {
                                        } else {
                                            break;
                                        }
                                        let _e319 = global_4.member[_e314[0]];
                                        phi_383_ = vec3<f32>(_e319[0], _e319[1], _e319[2]);
                                    } else {
                                        phi_383_ = vec3<f32>(0f, 0f, 0f);
                                    }
                                    let _e325 = phi_383_;
                                    let _e327 = (_e314[1] < _e53);
                                    if _e327 {
                                        if _e327 {
                                        } else {
                                            break;
                                        }
                                        let _e330 = global_4.member[_e314[1]];
                                        phi_400_ = vec3<f32>(_e330[0], _e330[1], _e330[2]);
                                    } else {
                                        phi_400_ = vec3<f32>(0f, 0f, 0f);
                                    }
                                    let _e336 = phi_400_;
                                    let _e338 = (_e314[2] < _e53);
                                    if _e338 {
                                        if _e338 {
                                        } else {
                                            break;
                                        }
                                        let _e341 = global_4.member[_e314[2]];
                                        phi_417_ = vec3<f32>(_e341[0], _e341[1], _e341[2]);
                                    } else {
                                        phi_417_ = vec3<f32>(0f, 0f, 0f);
                                    }
                                    let _e347 = phi_417_;
                                    let _e356 = ((1f - _e77.member_1) - _e77.member_2);
                                    let _e358 = select(0f, _e356, (_e356 > 0f));
                                    let _e360 = select(1f, _e77.member_1, (_e77.member_1 < 1f));
                                    let _e362 = select(1f, _e77.member_2, (_e77.member_2 < 1f));
                                    let _e363 = (_e278 * _e358);
                                    let _e364 = (_e282 * _e358);
                                    let _e365 = (_e286 * _e358);
                                    let _e366 = (_e290 * _e360);
                                    let _e367 = (_e294 * _e360);
                                    let _e368 = (_e298 * _e360);
                                    let _e369 = (_e302 * _e362);
                                    let _e370 = (_e306 * _e362);
                                    let _e371 = (_e310 * _e362);
                                    let _e375 = ((_e363 + _e366) + _e369);
                                    let _e376 = ((_e364 + _e367) + _e370);
                                    let _e377 = ((_e365 + _e368) + _e371);
                                    let _e411 = (((bitcast<f32>((bitcast<u32>(_e363) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e366) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e369) & 2147483647u))) * 0.00000071525625f);
                                    let _e412 = (((bitcast<f32>((bitcast<u32>(_e364) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e367) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e370) & 2147483647u))) * 0.00000071525625f);
                                    let _e413 = (((bitcast<f32>((bitcast<u32>(_e365) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e368) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e371) & 2147483647u))) * 0.00000071525625f);
                                    let _e414 = (_e290 - _e278);
                                    let _e415 = (_e294 - _e282);
                                    let _e416 = (_e298 - _e286);
                                    let _e417 = (_e302 - _e278);
                                    let _e418 = (_e306 - _e282);
                                    let _e419 = (_e310 - _e286);
                                    let _e422 = ((_e415 * _e419) - (_e418 * _e416));
                                    let _e425 = ((_e416 * _e417) - (_e419 * _e414));
                                    let _e428 = ((_e414 * _e418) - (_e417 * _e415));
                                    let _e431 = bitcast<f32>((bitcast<u32>(_e422) & 2147483647u));
                                    let _e434 = bitcast<f32>((bitcast<u32>(_e425) & 2147483647u));
                                    let _e436 = select(_e434, _e431, (_e431 > _e434));
                                    let _e439 = bitcast<f32>((bitcast<u32>(_e428) & 2147483647u));
                                    let _e441 = select(_e439, _e436, (_e436 > _e439));
                                    if (_e441 < 0.000000000000000000000000000000000000011754944f) {
                                        phi_599_ = vec3<f32>(0f, 0f, 0f);
                                    } else {
                                        let _e444 = (bitcast<u32>(_e441) & 2147483647u);
                                        let _e445 = (_e444 >= 8388608u);
                                        if _e445 {
                                            phi_549_ = (bitcast<i32>((_e444 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_549_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e444)), 32u, (_e444 == 0u))));
                                        }
                                        let _e458 = phi_549_;
                                        let _e465 = bitcast<f32>((bitcast<u32>(((_e458 / -2i) + 127i)) << bitcast<u32>(23i)));
                                        if _e445 {
                                            phi_580_ = (bitcast<i32>((_e444 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_580_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e444)), 32u, (_e444 == 0u))));
                                        }
                                        let _e481 = phi_580_;
                                        let _e487 = bitcast<f32>((bitcast<u32>((((_e458 / 2i) - _e481) + 127i)) << bitcast<u32>(23i)));
                                        let _e488 = ((_e422 * _e465) * _e487);
                                        let _e489 = ((_e425 * _e465) * _e487);
                                        let _e490 = ((_e428 * _e465) * _e487);
                                        let _e496 = sqrt((((_e488 * _e488) + (_e489 * _e489)) + (_e490 * _e490)));
                                        phi_599_ = vec3<f32>((_e488 / _e496), (_e489 / _e496), (_e490 / _e496));
                                    }
                                    let _e502 = phi_599_;
                                    let _e512 = select(1f, -1f, ((((_e502.x * _e74.member.member_2[0]) + (_e502.y * _e74.member.member_2[1])) + (_e502.z * _e74.member.member_2[2])) > 0f));
                                    let _e513 = (_e502.x * _e512);
                                    let _e514 = (_e502.y * _e512);
                                    let _e515 = (_e502.z * _e512);
                                    let _e538 = (((_e325.x * _e358) + (_e336.x * _e360)) + (_e347.x * _e362));
                                    let _e539 = (((_e325.y * _e358) + (_e336.y * _e360)) + (_e347.y * _e362));
                                    let _e540 = (((_e325.z * _e358) + (_e336.z * _e360)) + (_e347.z * _e362));
                                    let _e543 = bitcast<f32>((bitcast<u32>(_e538) & 2147483647u));
                                    let _e546 = bitcast<f32>((bitcast<u32>(_e539) & 2147483647u));
                                    let _e548 = select(_e546, _e543, (_e543 > _e546));
                                    let _e551 = bitcast<f32>((bitcast<u32>(_e540) & 2147483647u));
                                    let _e553 = select(_e551, _e548, (_e548 > _e551));
                                    if (_e553 < 0.000000000000000000000000000000000000011754944f) {
                                        phi_732_ = vec3<f32>(0f, 0f, 0f);
                                    } else {
                                        let _e556 = (bitcast<u32>(_e553) & 2147483647u);
                                        let _e557 = (_e556 >= 8388608u);
                                        if _e557 {
                                            phi_682_ = (bitcast<i32>((_e556 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_682_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e556)), 32u, (_e556 == 0u))));
                                        }
                                        let _e570 = phi_682_;
                                        let _e577 = bitcast<f32>((bitcast<u32>(((_e570 / -2i) + 127i)) << bitcast<u32>(23i)));
                                        if _e557 {
                                            phi_713_ = (bitcast<i32>((_e556 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_713_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e556)), 32u, (_e556 == 0u))));
                                        }
                                        let _e593 = phi_713_;
                                        let _e599 = bitcast<f32>((bitcast<u32>((((_e570 / 2i) - _e593) + 127i)) << bitcast<u32>(23i)));
                                        let _e600 = ((_e538 * _e577) * _e599);
                                        let _e601 = ((_e539 * _e577) * _e599);
                                        let _e602 = ((_e540 * _e577) * _e599);
                                        let _e608 = sqrt((((_e600 * _e600) + (_e601 * _e601)) + (_e602 * _e602)));
                                        phi_732_ = vec3<f32>((_e600 / _e608), (_e601 / _e608), (_e602 / _e608));
                                    }
                                    let _e614 = phi_732_;
                                    let _e629 = select((_e502 * _e512), (_e614 * _e512), vec3((((((_e614.x * _e512) * _e513) + ((_e614.y * _e512) * _e514)) + ((_e614.z * _e512) * _e515)) > 0f)));
                                    let _e630 = (_e77.member_3 < arrayLength((&global_5.member)));
                                    if _e630 {
                                        if _e630 {
                                        } else {
                                            break;
                                        }
                                        let _e633 = global_5.member[_e77.member_3];
                                        phi_762_ = _e633;
                                    } else {
                                        phi_762_ = 0u;
                                    }
                                    let _e635 = phi_762_;
                                    let _e637 = select(_e635, 0u, (_e635 >= _e57));
                                    if (_e637 < _e57) {
                                    } else {
                                        break;
                                    }
                                    let _e641 = global_6.member[_e637];
                                    if (0u < _e59) {
                                    } else {
                                        break;
                                    }
                                    let _e646 = global_7.member[0u].member;
                                    let _e655 = (_e641.member_2 > 0f);
                                    if _e655 {
                                        phi_796_ = _e641.member_2;
                                    } else {
                                        phi_796_ = _e641.member_1;
                                    }
                                    let _e658 = phi_796_;
                                    let _e660 = ((1f - _e658) * 0.31830987f);
                                    let _e681 = array<f32, 3>((_e74.member_3[0] + ((_e646[0] * (_e641.member[0] * _e660)) * _e74.member_1[0])), (_e74.member_3[1] + ((_e646[1] * (_e641.member[1] * _e660)) * _e74.member_1[1])), (_e74.member_3[2] + ((_e646[2] * (_e641.member[2] * _e660)) * _e74.member_1[2])));
                                    if _e655 {
                                        phi_833_ = _e641.member_2;
                                    } else {
                                        phi_833_ = _e641.member_1;
                                    }
                                    let _e687 = phi_833_;
                                    if (_e687 <= 0f) {
                                        phi_1482_ = type_33(type_32(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), _e74.member_1, _e74.member_2, _e681, _e74.member_4);
                                    } else {
                                        if _e655 {
                                            if (_e512 > 0f) {
                                                phi_855_ = (1f / _e641.member_3);
                                            } else {
                                                phi_855_ = _e641.member_3;
                                            }
                                            let _e698 = phi_855_;
                                            let _e701 = bitcast<f32>((bitcast<u32>(_e74.member.member_2[0]) & 2147483647u));
                                            let _e704 = bitcast<f32>((bitcast<u32>(_e74.member.member_2[1]) & 2147483647u));
                                            let _e706 = select(_e704, _e701, (_e701 > _e704));
                                            let _e709 = bitcast<f32>((bitcast<u32>(_e74.member.member_2[2]) & 2147483647u));
                                            let _e711 = select(_e709, _e706, (_e706 > _e709));
                                            if (_e711 < 0.000000000000000000000000000000000000011754944f) {
                                                phi_944_ = vec3<f32>(0f, 0f, 0f);
                                            } else {
                                                let _e714 = (bitcast<u32>(_e711) & 2147483647u);
                                                let _e715 = (_e714 >= 8388608u);
                                                if _e715 {
                                                    phi_894_ = (bitcast<i32>((_e714 >> bitcast<u32>(23i))) - 127i);
                                                } else {
                                                    phi_894_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e714)), 32u, (_e714 == 0u))));
                                                }
                                                let _e728 = phi_894_;
                                                let _e735 = bitcast<f32>((bitcast<u32>(((_e728 / -2i) + 127i)) << bitcast<u32>(23i)));
                                                if _e715 {
                                                    phi_925_ = (bitcast<i32>((_e714 >> bitcast<u32>(23i))) - 127i);
                                                } else {
                                                    phi_925_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e714)), 32u, (_e714 == 0u))));
                                                }
                                                let _e751 = phi_925_;
                                                let _e757 = bitcast<f32>((bitcast<u32>((((_e728 / 2i) - _e751) + 127i)) << bitcast<u32>(23i)));
                                                let _e758 = ((_e74.member.member_2[0] * _e735) * _e757);
                                                let _e759 = ((_e74.member.member_2[1] * _e735) * _e757);
                                                let _e760 = ((_e74.member.member_2[2] * _e735) * _e757);
                                                let _e766 = sqrt((((_e758 * _e758) + (_e759 * _e759)) + (_e760 * _e760)));
                                                phi_944_ = vec3<f32>((_e758 / _e766), (_e759 / _e766), (_e760 / _e766));
                                            }
                                            let _e772 = phi_944_;
                                            let _e783 = (((_e629.x * _e772.x) + (_e629.y * _e772.y)) + (_e629.z * _e772.z));
                                            let _e784 = (_e698 * _e698);
                                            let _e788 = (1f - (_e784 * (1f - (_e783 * _e783))));
                                            if (_e788 >= 0f) {
                                                let _e795 = ((_e698 * _e783) + sqrt(_e788));
                                                phi_984_ = vec3<f32>(((_e698 * _e772.x) - (_e795 * _e629.x)), ((_e698 * _e772.y) - (_e795 * _e629.y)), ((_e698 * _e772.z) - (_e795 * _e629.z)));
                                            } else {
                                                phi_984_ = vec3<f32>(0f, 0f, 0f);
                                            }
                                            let _e804 = phi_984_;
                                            if ((((_e804.x * _e513) + (_e804.y * _e514)) + (_e804.z * _e515)) > 0f) {
                                                let _e818 = (((_e513 * _e772.x) + (_e514 * _e772.y)) + (_e515 * _e772.z));
                                                let _e822 = (1f - (_e784 * (1f - (_e818 * _e818))));
                                                if (_e822 >= 0f) {
                                                    let _e829 = ((_e698 * _e818) + sqrt(_e822));
                                                    phi_1030_ = vec3<f32>(((_e698 * _e772.x) - (_e829 * _e513)), ((_e698 * _e772.y) - (_e829 * _e514)), ((_e698 * _e772.z) - (_e829 * _e515)));
                                                } else {
                                                    phi_1030_ = vec3<f32>(0f, 0f, 0f);
                                                }
                                                let _e838 = phi_1030_;
                                                phi_1031_ = _e838;
                                            } else {
                                                phi_1031_ = _e804;
                                            }
                                            let _e840 = phi_1031_;
                                            let _e849 = ((((_e840.x * _e513) + (_e840.y * _e514)) + (_e840.z * _e515)) < 0f);
                                            if _e849 {
                                                let _e850 = -(_e513);
                                                let _e851 = -(_e514);
                                                let _e852 = -(_e515);
                                                let _e854 = select(_e412, _e411, (_e411 > _e412));
                                                let _e868 = (select(_e413, _e854, (_e854 > _e413)) * ((bitcast<f32>((bitcast<u32>(_e850) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e851) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e852) & 2147483647u))));
                                                let _e872 = (_e375 + (_e850 * _e868));
                                                let _e873 = (_e376 + (_e851 * _e868));
                                                let _e874 = (_e377 + (_e852 * _e868));
                                                if (_e850 > 0f) {
                                                    let _e895 = bitcast<u32>(_e872);
                                                    if ((_e895 & 2147483647u) == 0u) {
                                                        phi_1096_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e895 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_1095_ = bitcast<f32>((_e895 + 1u));
                                                        } else {
                                                            phi_1095_ = bitcast<f32>((_e895 - 1u));
                                                        }
                                                        let _e906 = phi_1095_;
                                                        phi_1096_ = _e906;
                                                    }
                                                    let _e908 = phi_1096_;
                                                    phi_1122_ = _e908;
                                                } else {
                                                    if (_e850 < 0f) {
                                                        let _e878 = bitcast<u32>(-(_e872));
                                                        if ((_e878 & 2147483647u) == 0u) {
                                                            phi_1119_ = 0.000000000000000000000000000000000000000000001f;
                                                        } else {
                                                            if ((_e878 >> bitcast<u32>(31i)) == 0u) {
                                                                phi_1118_ = bitcast<f32>((_e878 + 1u));
                                                            } else {
                                                                phi_1118_ = bitcast<f32>((_e878 - 1u));
                                                            }
                                                            let _e889 = phi_1118_;
                                                            phi_1119_ = _e889;
                                                        }
                                                        let _e891 = phi_1119_;
                                                        phi_1121_ = -(_e891);
                                                    } else {
                                                        phi_1121_ = _e872;
                                                    }
                                                    let _e894 = phi_1121_;
                                                    phi_1122_ = _e894;
                                                }
                                                let _e910 = phi_1122_;
                                                if (_e851 > 0f) {
                                                    let _e931 = bitcast<u32>(_e873);
                                                    if ((_e931 & 2147483647u) == 0u) {
                                                        phi_1144_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e931 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_1143_ = bitcast<f32>((_e931 + 1u));
                                                        } else {
                                                            phi_1143_ = bitcast<f32>((_e931 - 1u));
                                                        }
                                                        let _e942 = phi_1143_;
                                                        phi_1144_ = _e942;
                                                    }
                                                    let _e944 = phi_1144_;
                                                    phi_1170_ = _e944;
                                                } else {
                                                    if (_e851 < 0f) {
                                                        let _e914 = bitcast<u32>(-(_e873));
                                                        if ((_e914 & 2147483647u) == 0u) {
                                                            phi_1167_ = 0.000000000000000000000000000000000000000000001f;
                                                        } else {
                                                            if ((_e914 >> bitcast<u32>(31i)) == 0u) {
                                                                phi_1166_ = bitcast<f32>((_e914 + 1u));
                                                            } else {
                                                                phi_1166_ = bitcast<f32>((_e914 - 1u));
                                                            }
                                                            let _e925 = phi_1166_;
                                                            phi_1167_ = _e925;
                                                        }
                                                        let _e927 = phi_1167_;
                                                        phi_1169_ = -(_e927);
                                                    } else {
                                                        phi_1169_ = _e873;
                                                    }
                                                    let _e930 = phi_1169_;
                                                    phi_1170_ = _e930;
                                                }
                                                let _e946 = phi_1170_;
                                                if (_e852 > 0f) {
                                                    let _e967 = bitcast<u32>(_e874);
                                                    if ((_e967 & 2147483647u) == 0u) {
                                                        phi_1192_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e967 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_1191_ = bitcast<f32>((_e967 + 1u));
                                                        } else {
                                                            phi_1191_ = bitcast<f32>((_e967 - 1u));
                                                        }
                                                        let _e978 = phi_1191_;
                                                        phi_1192_ = _e978;
                                                    }
                                                    let _e980 = phi_1192_;
                                                    phi_1218_ = _e980;
                                                } else {
                                                    if (_e852 < 0f) {
                                                        let _e950 = bitcast<u32>(-(_e874));
                                                        if ((_e950 & 2147483647u) == 0u) {
                                                            phi_1215_ = 0.000000000000000000000000000000000000000000001f;
                                                        } else {
                                                            if ((_e950 >> bitcast<u32>(31i)) == 0u) {
                                                                phi_1214_ = bitcast<f32>((_e950 + 1u));
                                                            } else {
                                                                phi_1214_ = bitcast<f32>((_e950 - 1u));
                                                            }
                                                            let _e961 = phi_1214_;
                                                            phi_1215_ = _e961;
                                                        }
                                                        let _e963 = phi_1215_;
                                                        phi_1217_ = -(_e963);
                                                    } else {
                                                        phi_1217_ = _e874;
                                                    }
                                                    let _e966 = phi_1217_;
                                                    phi_1218_ = _e966;
                                                }
                                                let _e982 = phi_1218_;
                                                phi_1221_ = type_39(vec3<f32>(_e910, _e946, _e982), _e840);
                                            } else {
                                                phi_1221_ = type_39();
                                            }
                                            let _e986 = phi_1221_;
                                            phi_1223_ = _e986;
                                            phi_1224_ = select(true, false, _e849);
                                        } else {
                                            phi_1223_ = type_39();
                                            phi_1224_ = true;
                                        }
                                        let _e989 = phi_1223_;
                                        let _e991 = phi_1224_;
                                        if _e991 {
                                            let _e993 = select(_e412, _e411, (_e411 > _e412));
                                            let _e1007 = (select(_e413, _e993, (_e993 > _e413)) * ((bitcast<f32>((bitcast<u32>(_e513) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e514) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e515) & 2147483647u))));
                                            let _e1011 = (_e375 + (_e513 * _e1007));
                                            let _e1012 = (_e376 + (_e514 * _e1007));
                                            let _e1013 = (_e377 + (_e515 * _e1007));
                                            if (_e513 > 0f) {
                                                let _e1034 = bitcast<u32>(_e1011);
                                                if ((_e1034 & 2147483647u) == 0u) {
                                                    phi_1277_ = 0.000000000000000000000000000000000000000000001f;
                                                } else {
                                                    if ((_e1034 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_1276_ = bitcast<f32>((_e1034 + 1u));
                                                    } else {
                                                        phi_1276_ = bitcast<f32>((_e1034 - 1u));
                                                    }
                                                    let _e1045 = phi_1276_;
                                                    phi_1277_ = _e1045;
                                                }
                                                let _e1047 = phi_1277_;
                                                phi_1303_ = _e1047;
                                            } else {
                                                if (_e513 < 0f) {
                                                    let _e1017 = bitcast<u32>(-(_e1011));
                                                    if ((_e1017 & 2147483647u) == 0u) {
                                                        phi_1300_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1017 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_1299_ = bitcast<f32>((_e1017 + 1u));
                                                        } else {
                                                            phi_1299_ = bitcast<f32>((_e1017 - 1u));
                                                        }
                                                        let _e1028 = phi_1299_;
                                                        phi_1300_ = _e1028;
                                                    }
                                                    let _e1030 = phi_1300_;
                                                    phi_1302_ = -(_e1030);
                                                } else {
                                                    phi_1302_ = _e1011;
                                                }
                                                let _e1033 = phi_1302_;
                                                phi_1303_ = _e1033;
                                            }
                                            let _e1049 = phi_1303_;
                                            if (_e514 > 0f) {
                                                let _e1070 = bitcast<u32>(_e1012);
                                                if ((_e1070 & 2147483647u) == 0u) {
                                                    phi_1325_ = 0.000000000000000000000000000000000000000000001f;
                                                } else {
                                                    if ((_e1070 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_1324_ = bitcast<f32>((_e1070 + 1u));
                                                    } else {
                                                        phi_1324_ = bitcast<f32>((_e1070 - 1u));
                                                    }
                                                    let _e1081 = phi_1324_;
                                                    phi_1325_ = _e1081;
                                                }
                                                let _e1083 = phi_1325_;
                                                phi_1351_ = _e1083;
                                            } else {
                                                if (_e514 < 0f) {
                                                    let _e1053 = bitcast<u32>(-(_e1012));
                                                    if ((_e1053 & 2147483647u) == 0u) {
                                                        phi_1348_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1053 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_1347_ = bitcast<f32>((_e1053 + 1u));
                                                        } else {
                                                            phi_1347_ = bitcast<f32>((_e1053 - 1u));
                                                        }
                                                        let _e1064 = phi_1347_;
                                                        phi_1348_ = _e1064;
                                                    }
                                                    let _e1066 = phi_1348_;
                                                    phi_1350_ = -(_e1066);
                                                } else {
                                                    phi_1350_ = _e1012;
                                                }
                                                let _e1069 = phi_1350_;
                                                phi_1351_ = _e1069;
                                            }
                                            let _e1085 = phi_1351_;
                                            if (_e515 > 0f) {
                                                let _e1106 = bitcast<u32>(_e1013);
                                                if ((_e1106 & 2147483647u) == 0u) {
                                                    phi_1373_ = 0.000000000000000000000000000000000000000000001f;
                                                } else {
                                                    if ((_e1106 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_1372_ = bitcast<f32>((_e1106 + 1u));
                                                    } else {
                                                        phi_1372_ = bitcast<f32>((_e1106 - 1u));
                                                    }
                                                    let _e1117 = phi_1372_;
                                                    phi_1373_ = _e1117;
                                                }
                                                let _e1119 = phi_1373_;
                                                phi_1399_ = _e1119;
                                            } else {
                                                if (_e515 < 0f) {
                                                    let _e1089 = bitcast<u32>(-(_e1013));
                                                    if ((_e1089 & 2147483647u) == 0u) {
                                                        phi_1396_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1089 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_1395_ = bitcast<f32>((_e1089 + 1u));
                                                        } else {
                                                            phi_1395_ = bitcast<f32>((_e1089 - 1u));
                                                        }
                                                        let _e1100 = phi_1395_;
                                                        phi_1396_ = _e1100;
                                                    }
                                                    let _e1102 = phi_1396_;
                                                    phi_1398_ = -(_e1102);
                                                } else {
                                                    phi_1398_ = _e1013;
                                                }
                                                let _e1105 = phi_1398_;
                                                phi_1399_ = _e1105;
                                            }
                                            let _e1121 = phi_1399_;
                                            let _e1131 = (2f * (((_e74.member.member_2[0] * _e629.x) + (_e74.member.member_2[1] * _e629.y)) + (_e74.member.member_2[2] * _e629.z)));
                                            let _e1135 = (_e74.member.member_2[0] - (_e629.x * _e1131));
                                            let _e1136 = (_e74.member.member_2[1] - (_e629.y * _e1131));
                                            let _e1137 = (_e74.member.member_2[2] - (_e629.z * _e1131));
                                            if ((((_e1135 * _e513) + (_e1136 * _e514)) + (_e1137 * _e515)) > 0f) {
                                                phi_1442_ = vec3<f32>(_e1135, _e1136, _e1137);
                                            } else {
                                                let _e1150 = (2f * (((_e74.member.member_2[0] * _e513) + (_e74.member.member_2[1] * _e514)) + (_e74.member.member_2[2] * _e515)));
                                                phi_1442_ = vec3<f32>((_e74.member.member_2[0] - (_e513 * _e1150)), (_e74.member.member_2[1] - (_e514 * _e1150)), (_e74.member.member_2[2] - (_e515 * _e1150)));
                                            }
                                            let _e1159 = phi_1442_;
                                            phi_1444_ = type_39(vec3<f32>(_e1049, _e1085, _e1121), _e1159);
                                        } else {
                                            phi_1444_ = _e989;
                                        }
                                        let _e1162 = phi_1444_;
                                        if _e655 {
                                            phi_1464_ = vec3<f32>((_e641.member[0] * _e641.member_2), (_e641.member[1] * _e641.member_2), (_e641.member[2] * _e641.member_2));
                                        } else {
                                            phi_1464_ = vec3(_e641.member_1);
                                        }
                                        let _e1170 = phi_1464_;
                                        phi_1482_ = type_33(type_32(array<f32, 3>(_e1162.member.x, _e1162.member.y, _e1162.member.z), 0f, array<f32, 3>(_e1162.member_1.x, _e1162.member_1.y, _e1162.member_1.z), 340282350000000000000000000000000000000f), array<f32, 3>((_e74.member_1[0] * _e1170.x), (_e74.member_1[1] * _e1170.y), (_e74.member_1[2] * _e1170.z)), _e77.member_3, _e681, _e74.member_4);
                                    }
                                    let _e1196 = phi_1482_;
                                    phi_1637_ = _e1196;
                                } else {
                                    if (0u < _e59) {
                                    } else {
                                        break;
                                    }
                                    let _e93 = bitcast<f32>((bitcast<u32>(_e74.member.member_2[0]) & 2147483647u));
                                    let _e96 = bitcast<f32>((bitcast<u32>(_e74.member.member_2[1]) & 2147483647u));
                                    let _e98 = select(_e96, _e93, (_e93 > _e96));
                                    let _e101 = bitcast<f32>((bitcast<u32>(_e74.member.member_2[2]) & 2147483647u));
                                    let _e103 = select(_e101, _e98, (_e98 > _e101));
                                    if (_e103 < 0.000000000000000000000000000000000000011754944f) {
                                        phi_1580_ = vec3<f32>(0f, 0f, 0f);
                                    } else {
                                        let _e106 = (bitcast<u32>(_e103) & 2147483647u);
                                        let _e107 = (_e106 >= 8388608u);
                                        if _e107 {
                                            phi_1530_ = (bitcast<i32>((_e106 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_1530_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e106)), 32u, (_e106 == 0u))));
                                        }
                                        let _e120 = phi_1530_;
                                        let _e127 = bitcast<f32>((bitcast<u32>(((_e120 / -2i) + 127i)) << bitcast<u32>(23i)));
                                        if _e107 {
                                            phi_1561_ = (bitcast<i32>((_e106 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_1561_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e106)), 32u, (_e106 == 0u))));
                                        }
                                        let _e143 = phi_1561_;
                                        let _e149 = bitcast<f32>((bitcast<u32>((((_e120 / 2i) - _e143) + 127i)) << bitcast<u32>(23i)));
                                        let _e150 = ((_e74.member.member_2[0] * _e127) * _e149);
                                        let _e151 = ((_e74.member.member_2[1] * _e127) * _e149);
                                        let _e152 = ((_e74.member.member_2[2] * _e127) * _e149);
                                        let _e158 = sqrt((((_e150 * _e150) + (_e151 * _e151)) + (_e152 * _e152)));
                                        phi_1580_ = vec3<f32>((_e150 / _e158), (_e151 / _e158), (_e152 / _e158));
                                    }
                                    let _e164 = phi_1580_;
                                    let _e168 = global_7.member[0u].member_6;
                                    let _e179 = (((_e164.x * _e168[0]) + (_e164.y * _e168[1])) + (_e164.z * _e168[2]));
                                    let _e181 = select(0f, _e179, (_e179 > 0f));
                                    let _e185 = global_7.member[0u].member_4;
                                    let _e192 = global_7.member[0u].member_2;
                                    phi_1637_ = type_33(type_32(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), _e74.member_1, _e74.member_2, array<f32, 3>((_e74.member_3[0] + ((_e185[0] + ((_e192[0] - _e185[0]) * _e181)) * _e74.member_1[0])), (_e74.member_3[1] + ((_e185[1] + ((_e192[1] - _e185[1]) * _e181)) * _e74.member_1[1])), (_e74.member_3[2] + ((_e185[2] + ((_e192[2] - _e185[2]) * _e181)) * _e74.member_1[2]))), _e74.member_4);
                                }
                                let _e1198 = phi_1637_;
                                if _e68 {
                                } else {
                                    break;
                                }
                                global_9.member[_e67] = _e1198;
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
fn shade_scatter(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
