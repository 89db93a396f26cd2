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
    var phi_1824_: i32;
    var phi_1855_: i32;
    var phi_1874_: vec3<f32>;
    var phi_214_: i32;
    var phi_238_: array<u32, 3>;
    var phi_253_: array<f32, 3>;
    var phi_271_: array<f32, 3>;
    var phi_289_: array<f32, 3>;
    var phi_660_: array<u32, 3>;
    var phi_677_: vec3<f32>;
    var phi_694_: vec3<f32>;
    var phi_711_: vec3<f32>;
    var phi_843_: i32;
    var phi_874_: i32;
    var phi_893_: vec3<f32>;
    var phi_976_: i32;
    var phi_1007_: i32;
    var phi_1026_: vec3<f32>;
    var phi_1056_: u32;
    var phi_1090_: f32;
    var phi_1127_: f32;
    var phi_1149_: f32;
    var phi_1188_: i32;
    var phi_1219_: i32;
    var phi_1238_: vec3<f32>;
    var phi_1278_: vec3<f32>;
    var phi_1324_: vec3<f32>;
    var phi_1325_: vec3<f32>;
    var phi_1412_: f32;
    var phi_1413_: f32;
    var phi_1415_: f32;
    var phi_1389_: f32;
    var phi_1390_: f32;
    var phi_1416_: f32;
    var phi_1460_: f32;
    var phi_1461_: f32;
    var phi_1463_: f32;
    var phi_1437_: f32;
    var phi_1438_: f32;
    var phi_1464_: f32;
    var phi_1508_: f32;
    var phi_1509_: f32;
    var phi_1511_: f32;
    var phi_1485_: f32;
    var phi_1486_: f32;
    var phi_1512_: f32;
    var phi_1515_: type_39;
    var phi_1517_: type_39;
    var phi_1518_: bool;
    var phi_1593_: f32;
    var phi_1594_: f32;
    var phi_1596_: f32;
    var phi_1570_: f32;
    var phi_1571_: f32;
    var phi_1597_: f32;
    var phi_1641_: f32;
    var phi_1642_: f32;
    var phi_1644_: f32;
    var phi_1618_: f32;
    var phi_1619_: f32;
    var phi_1645_: f32;
    var phi_1689_: f32;
    var phi_1690_: f32;
    var phi_1692_: f32;
    var phi_1666_: f32;
    var phi_1667_: f32;
    var phi_1693_: f32;
    var phi_1736_: vec3<f32>;
    var phi_1738_: type_39;
    var phi_1758_: vec3<f32>;
    var phi_1776_: type_33;
    var phi_1931_: type_33;

    switch bitcast<i32>(0u) {
        default: {
            let _e51 = global;
            let _e54 = arrayLength((&global_2.member));
            let _e59 = arrayLength((&global_4.member));
            let _e63 = arrayLength((&global_6.member));
            let _e65 = arrayLength((&global_7.member));
            let _e73 = (_e51.x + (_e51.y * 2097152u));
            let _e74 = (_e73 < arrayLength((&global_9.member)));
            if _e74 {
                let _e75 = (_e73 < arrayLength((&global_8.member)));
                if _e75 {
                    if (_e63 == 0u) {
                    } else {
                        if (_e65 == 0u) {
                        } else {
                            if _e74 {
                            } else {
                                break;
                            }
                            let _e80 = global_9.member[_e73];
                            if _e75 {
                            } else {
                                break;
                            }
                            let _e83 = global_8.member[_e73];
                            if (_e80.member.member_1 <= _e80.member.member_3) {
                                if (_e83.member_3 != 4294967295u) {
                                    let _e231 = global_1.member[0u];
                                    let _e232 = bitcast<i32>(_e231);
                                    if (_e232 < -126i) {
                                        phi_214_ = -126i;
                                    } else {
                                        phi_214_ = select(_e232, 127i, (_e232 > 127i));
                                    }
                                    let _e237 = phi_214_;
                                    let _e242 = bitcast<f32>((bitcast<u32>((_e237 + 127i)) << bitcast<u32>(23i)));
                                    let _e248 = bitcast<f32>((bitcast<u32>(((_e232 - _e237) + 127i)) << bitcast<u32>(23i)));
                                    let _e249 = (_e83.member_3 < arrayLength((&global_3.member)));
                                    if _e249 {
                                        if _e249 {
                                        } else {
                                            break;
                                        }
                                        let _e251 = global_3.member[_e83.member_3];
                                        phi_238_ = _e251;
                                    } else {
                                        phi_238_ = array<u32, 3>(0u, 0u, 0u);
                                    }
                                    let _e253 = phi_238_;
                                    let _e255 = (_e253[0] < _e54);
                                    if _e255 {
                                        if _e255 {
                                        } else {
                                            break;
                                        }
                                        let _e257 = global_2.member[_e253[0]];
                                        phi_253_ = _e257;
                                    } else {
                                        phi_253_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e259 = phi_253_;
                                    let _e264 = (_e253[1] < _e54);
                                    if _e264 {
                                        if _e264 {
                                        } else {
                                            break;
                                        }
                                        let _e266 = global_2.member[_e253[1]];
                                        phi_271_ = _e266;
                                    } else {
                                        phi_271_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e268 = phi_271_;
                                    let _e273 = (_e253[2] < _e54);
                                    if _e273 {
                                        if _e273 {
                                        } else {
                                            break;
                                        }
                                        let _e275 = global_2.member[_e253[2]];
                                        phi_289_ = _e275;
                                    } else {
                                        phi_289_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e277 = phi_289_;
                                    let _e281 = bitcast<u32>(_e259[0]);
                                    let _e283 = ((_e281 & 2139095040u) != 0u);
                                    let _e297 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e281 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e281 & 2147483648u))), _e259[0], _e283) * _e242) * select(0.00000011920929f, 1f, _e283)) * _e248);
                                    let _e302 = select(_e297, 0f, (bitcast<f32>((bitcast<u32>(_e297) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
                                    let _e303 = bitcast<u32>(_e259[1]);
                                    let _e305 = ((_e303 & 2139095040u) != 0u);
                                    let _e319 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e303 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e303 & 2147483648u))), _e259[1], _e305) * _e242) * select(0.00000011920929f, 1f, _e305)) * _e248);
                                    let _e324 = select(_e319, 0f, (bitcast<f32>((bitcast<u32>(_e319) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
                                    let _e325 = bitcast<u32>(_e259[2]);
                                    let _e327 = ((_e325 & 2139095040u) != 0u);
                                    let _e341 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e325 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e325 & 2147483648u))), _e259[2], _e327) * _e242) * select(0.00000011920929f, 1f, _e327)) * _e248);
                                    let _e346 = select(_e341, 0f, (bitcast<f32>((bitcast<u32>(_e341) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
                                    let _e347 = bitcast<u32>(_e268[0]);
                                    let _e349 = ((_e347 & 2139095040u) != 0u);
                                    let _e363 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e347 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e347 & 2147483648u))), _e268[0], _e349) * _e242) * select(0.00000011920929f, 1f, _e349)) * _e248);
                                    let _e368 = select(_e363, 0f, (bitcast<f32>((bitcast<u32>(_e363) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
                                    let _e369 = bitcast<u32>(_e268[1]);
                                    let _e371 = ((_e369 & 2139095040u) != 0u);
                                    let _e385 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e369 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e369 & 2147483648u))), _e268[1], _e371) * _e242) * select(0.00000011920929f, 1f, _e371)) * _e248);
                                    let _e390 = select(_e385, 0f, (bitcast<f32>((bitcast<u32>(_e385) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
                                    let _e391 = bitcast<u32>(_e268[2]);
                                    let _e393 = ((_e391 & 2139095040u) != 0u);
                                    let _e407 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e391 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e391 & 2147483648u))), _e268[2], _e393) * _e242) * select(0.00000011920929f, 1f, _e393)) * _e248);
                                    let _e412 = select(_e407, 0f, (bitcast<f32>((bitcast<u32>(_e407) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
                                    let _e413 = bitcast<u32>(_e277[0]);
                                    let _e415 = ((_e413 & 2139095040u) != 0u);
                                    let _e429 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e413 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e413 & 2147483648u))), _e277[0], _e415) * _e242) * select(0.00000011920929f, 1f, _e415)) * _e248);
                                    let _e434 = select(_e429, 0f, (bitcast<f32>((bitcast<u32>(_e429) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
                                    let _e435 = bitcast<u32>(_e277[1]);
                                    let _e437 = ((_e435 & 2139095040u) != 0u);
                                    let _e451 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e435 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e435 & 2147483648u))), _e277[1], _e437) * _e242) * select(0.00000011920929f, 1f, _e437)) * _e248);
                                    let _e456 = select(_e451, 0f, (bitcast<f32>((bitcast<u32>(_e451) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
                                    let _e457 = bitcast<u32>(_e277[2]);
                                    let _e459 = ((_e457 & 2139095040u) != 0u);
                                    let _e473 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e457 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e457 & 2147483648u))), _e277[2], _e459) * _e242) * select(0.00000011920929f, 1f, _e459)) * _e248);
                                    let _e478 = select(_e473, 0f, (bitcast<f32>((bitcast<u32>(_e473) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
                                    if _e249 {
                                        if _e249 {
                                        } else {
                                            break;
                                        }
                                        let _e480 = global_3.member[_e83.member_3];
                                        phi_660_ = _e480;
                                    } else {
                                        phi_660_ = array<u32, 3>(0u, 0u, 0u);
                                    }
                                    let _e482 = phi_660_;
                                    let _e484 = (_e482[0] < _e59);
                                    if _e484 {
                                        if _e484 {
                                        } else {
                                            break;
                                        }
                                        let _e487 = global_4.member[_e482[0]];
                                        phi_677_ = vec3<f32>(_e487[0], _e487[1], _e487[2]);
                                    } else {
                                        phi_677_ = vec3<f32>(0f, 0f, 0f);
                                    }
                                    let _e493 = phi_677_;
                                    let _e495 = (_e482[1] < _e59);
                                    if _e495 {
                                        if _e495 {
                                        } else {
                                            break;
                                        }
                                        let _e498 = global_4.member[_e482[1]];
                                        phi_694_ = vec3<f32>(_e498[0], _e498[1], _e498[2]);
                                    } else {
                                        phi_694_ = vec3<f32>(0f, 0f, 0f);
                                    }
                                    let _e504 = phi_694_;
                                    let _e506 = (_e482[2] < _e59);
                                    if _e506 {
                                        if _e506 {
                                        } else {
                                            break;
                                        }
                                        let _e509 = global_4.member[_e482[2]];
                                        phi_711_ = vec3<f32>(_e509[0], _e509[1], _e509[2]);
                                    } else {
                                        phi_711_ = vec3<f32>(0f, 0f, 0f);
                                    }
                                    let _e515 = phi_711_;
                                    let _e524 = ((1f - _e83.member_1) - _e83.member_2);
                                    let _e526 = select(0f, _e524, (_e524 > 0f));
                                    let _e528 = select(1f, _e83.member_1, (_e83.member_1 < 1f));
                                    let _e530 = select(1f, _e83.member_2, (_e83.member_2 < 1f));
                                    let _e531 = (_e302 * _e526);
                                    let _e532 = (_e324 * _e526);
                                    let _e533 = (_e346 * _e526);
                                    let _e534 = (_e368 * _e528);
                                    let _e535 = (_e390 * _e528);
                                    let _e536 = (_e412 * _e528);
                                    let _e537 = (_e434 * _e530);
                                    let _e538 = (_e456 * _e530);
                                    let _e539 = (_e478 * _e530);
                                    let _e543 = ((_e531 + _e534) + _e537);
                                    let _e544 = ((_e532 + _e535) + _e538);
                                    let _e545 = ((_e533 + _e536) + _e539);
                                    let _e579 = (((bitcast<f32>((bitcast<u32>(_e531) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e534) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e537) & 2147483647u))) * 0.00000071525625f);
                                    let _e580 = (((bitcast<f32>((bitcast<u32>(_e532) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e535) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e538) & 2147483647u))) * 0.00000071525625f);
                                    let _e581 = (((bitcast<f32>((bitcast<u32>(_e533) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e536) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e539) & 2147483647u))) * 0.00000071525625f);
                                    let _e582 = (_e368 - _e302);
                                    let _e583 = (_e390 - _e324);
                                    let _e584 = (_e412 - _e346);
                                    let _e585 = (_e434 - _e302);
                                    let _e586 = (_e456 - _e324);
                                    let _e587 = (_e478 - _e346);
                                    let _e590 = ((_e583 * _e587) - (_e586 * _e584));
                                    let _e593 = ((_e584 * _e585) - (_e587 * _e582));
                                    let _e596 = ((_e582 * _e586) - (_e585 * _e583));
                                    let _e599 = bitcast<f32>((bitcast<u32>(_e590) & 2147483647u));
                                    let _e602 = bitcast<f32>((bitcast<u32>(_e593) & 2147483647u));
                                    let _e604 = select(_e602, _e599, (_e599 > _e602));
                                    let _e607 = bitcast<f32>((bitcast<u32>(_e596) & 2147483647u));
                                    let _e609 = select(_e607, _e604, (_e604 > _e607));
                                    if (_e609 < 0.000000000000000000000000000000000000011754944f) {
                                        phi_893_ = vec3<f32>(0f, 0f, 0f);
                                    } else {
                                        let _e612 = (bitcast<u32>(_e609) & 2147483647u);
                                        let _e613 = (_e612 >= 8388608u);
                                        if _e613 {
                                            phi_843_ = (bitcast<i32>((_e612 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_843_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e612)), 32u, (_e612 == 0u))));
                                        }
                                        let _e626 = phi_843_;
                                        let _e633 = bitcast<f32>((bitcast<u32>(((_e626 / -2i) + 127i)) << bitcast<u32>(23i)));
                                        if _e613 {
                                            phi_874_ = (bitcast<i32>((_e612 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_874_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e612)), 32u, (_e612 == 0u))));
                                        }
                                        let _e649 = phi_874_;
                                        let _e655 = bitcast<f32>((bitcast<u32>((((_e626 / 2i) - _e649) + 127i)) << bitcast<u32>(23i)));
                                        let _e656 = ((_e590 * _e633) * _e655);
                                        let _e657 = ((_e593 * _e633) * _e655);
                                        let _e658 = ((_e596 * _e633) * _e655);
                                        let _e664 = sqrt((((_e656 * _e656) + (_e657 * _e657)) + (_e658 * _e658)));
                                        phi_893_ = vec3<f32>((_e656 / _e664), (_e657 / _e664), (_e658 / _e664));
                                    }
                                    let _e670 = phi_893_;
                                    let _e680 = select(1f, -1f, ((((_e670.x * _e80.member.member_2[0]) + (_e670.y * _e80.member.member_2[1])) + (_e670.z * _e80.member.member_2[2])) > 0f));
                                    let _e681 = (_e670.x * _e680);
                                    let _e682 = (_e670.y * _e680);
                                    let _e683 = (_e670.z * _e680);
                                    let _e706 = (((_e493.x * _e526) + (_e504.x * _e528)) + (_e515.x * _e530));
                                    let _e707 = (((_e493.y * _e526) + (_e504.y * _e528)) + (_e515.y * _e530));
                                    let _e708 = (((_e493.z * _e526) + (_e504.z * _e528)) + (_e515.z * _e530));
                                    let _e711 = bitcast<f32>((bitcast<u32>(_e706) & 2147483647u));
                                    let _e714 = bitcast<f32>((bitcast<u32>(_e707) & 2147483647u));
                                    let _e716 = select(_e714, _e711, (_e711 > _e714));
                                    let _e719 = bitcast<f32>((bitcast<u32>(_e708) & 2147483647u));
                                    let _e721 = select(_e719, _e716, (_e716 > _e719));
                                    if (_e721 < 0.000000000000000000000000000000000000011754944f) {
                                        phi_1026_ = vec3<f32>(0f, 0f, 0f);
                                    } else {
                                        let _e724 = (bitcast<u32>(_e721) & 2147483647u);
                                        let _e725 = (_e724 >= 8388608u);
                                        if _e725 {
                                            phi_976_ = (bitcast<i32>((_e724 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_976_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e724)), 32u, (_e724 == 0u))));
                                        }
                                        let _e738 = phi_976_;
                                        let _e745 = bitcast<f32>((bitcast<u32>(((_e738 / -2i) + 127i)) << bitcast<u32>(23i)));
                                        if _e725 {
                                            phi_1007_ = (bitcast<i32>((_e724 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_1007_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e724)), 32u, (_e724 == 0u))));
                                        }
                                        let _e761 = phi_1007_;
                                        let _e767 = bitcast<f32>((bitcast<u32>((((_e738 / 2i) - _e761) + 127i)) << bitcast<u32>(23i)));
                                        let _e768 = ((_e706 * _e745) * _e767);
                                        let _e769 = ((_e707 * _e745) * _e767);
                                        let _e770 = ((_e708 * _e745) * _e767);
                                        let _e776 = sqrt((((_e768 * _e768) + (_e769 * _e769)) + (_e770 * _e770)));
                                        phi_1026_ = vec3<f32>((_e768 / _e776), (_e769 / _e776), (_e770 / _e776));
                                    }
                                    let _e782 = phi_1026_;
                                    let _e797 = select((_e670 * _e680), (_e782 * _e680), vec3((((((_e782.x * _e680) * _e681) + ((_e782.y * _e680) * _e682)) + ((_e782.z * _e680) * _e683)) > 0f)));
                                    let _e798 = (_e83.member_3 < arrayLength((&global_5.member)));
                                    if _e798 {
                                        if _e798 {
                                        } else {
                                            break;
                                        }
                                        let _e801 = global_5.member[_e83.member_3];
                                        phi_1056_ = _e801;
                                    } else {
                                        phi_1056_ = 0u;
                                    }
                                    let _e803 = phi_1056_;
                                    let _e805 = select(_e803, 0u, (_e803 >= _e63));
                                    if (_e805 < _e63) {
                                    } else {
                                        break;
                                    }
                                    let _e809 = global_6.member[_e805];
                                    if (0u < _e65) {
                                    } else {
                                        break;
                                    }
                                    let _e814 = global_7.member[0u].member;
                                    let _e823 = (_e809.member_2 > 0f);
                                    if _e823 {
                                        phi_1090_ = _e809.member_2;
                                    } else {
                                        phi_1090_ = _e809.member_1;
                                    }
                                    let _e826 = phi_1090_;
                                    let _e828 = ((1f - _e826) * 0.31830987f);
                                    let _e849 = array<f32, 3>((_e80.member_3[0] + ((_e814[0] * (_e809.member[0] * _e828)) * _e80.member_1[0])), (_e80.member_3[1] + ((_e814[1] * (_e809.member[1] * _e828)) * _e80.member_1[1])), (_e80.member_3[2] + ((_e814[2] * (_e809.member[2] * _e828)) * _e80.member_1[2])));
                                    if _e823 {
                                        phi_1127_ = _e809.member_2;
                                    } else {
                                        phi_1127_ = _e809.member_1;
                                    }
                                    let _e855 = phi_1127_;
                                    if (_e855 <= 0f) {
                                        phi_1776_ = type_33(type_32(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), _e80.member_1, _e80.member_2, _e849, _e80.member_4);
                                    } else {
                                        if _e823 {
                                            if (_e680 > 0f) {
                                                phi_1149_ = (1f / _e809.member_3);
                                            } else {
                                                phi_1149_ = _e809.member_3;
                                            }
                                            let _e866 = phi_1149_;
                                            let _e869 = bitcast<f32>((bitcast<u32>(_e80.member.member_2[0]) & 2147483647u));
                                            let _e872 = bitcast<f32>((bitcast<u32>(_e80.member.member_2[1]) & 2147483647u));
                                            let _e874 = select(_e872, _e869, (_e869 > _e872));
                                            let _e877 = bitcast<f32>((bitcast<u32>(_e80.member.member_2[2]) & 2147483647u));
                                            let _e879 = select(_e877, _e874, (_e874 > _e877));
                                            if (_e879 < 0.000000000000000000000000000000000000011754944f) {
                                                phi_1238_ = vec3<f32>(0f, 0f, 0f);
                                            } else {
                                                let _e882 = (bitcast<u32>(_e879) & 2147483647u);
                                                let _e883 = (_e882 >= 8388608u);
                                                if _e883 {
                                                    phi_1188_ = (bitcast<i32>((_e882 >> bitcast<u32>(23i))) - 127i);
                                                } else {
                                                    phi_1188_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e882)), 32u, (_e882 == 0u))));
                                                }
                                                let _e896 = phi_1188_;
                                                let _e903 = bitcast<f32>((bitcast<u32>(((_e896 / -2i) + 127i)) << bitcast<u32>(23i)));
                                                if _e883 {
                                                    phi_1219_ = (bitcast<i32>((_e882 >> bitcast<u32>(23i))) - 127i);
                                                } else {
                                                    phi_1219_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e882)), 32u, (_e882 == 0u))));
                                                }
                                                let _e919 = phi_1219_;
                                                let _e925 = bitcast<f32>((bitcast<u32>((((_e896 / 2i) - _e919) + 127i)) << bitcast<u32>(23i)));
                                                let _e926 = ((_e80.member.member_2[0] * _e903) * _e925);
                                                let _e927 = ((_e80.member.member_2[1] * _e903) * _e925);
                                                let _e928 = ((_e80.member.member_2[2] * _e903) * _e925);
                                                let _e934 = sqrt((((_e926 * _e926) + (_e927 * _e927)) + (_e928 * _e928)));
                                                phi_1238_ = vec3<f32>((_e926 / _e934), (_e927 / _e934), (_e928 / _e934));
                                            }
                                            let _e940 = phi_1238_;
                                            let _e951 = (((_e797.x * _e940.x) + (_e797.y * _e940.y)) + (_e797.z * _e940.z));
                                            let _e952 = (_e866 * _e866);
                                            let _e956 = (1f - (_e952 * (1f - (_e951 * _e951))));
                                            if (_e956 >= 0f) {
                                                let _e963 = ((_e866 * _e951) + sqrt(_e956));
                                                phi_1278_ = vec3<f32>(((_e866 * _e940.x) - (_e963 * _e797.x)), ((_e866 * _e940.y) - (_e963 * _e797.y)), ((_e866 * _e940.z) - (_e963 * _e797.z)));
                                            } else {
                                                phi_1278_ = vec3<f32>(0f, 0f, 0f);
                                            }
                                            let _e972 = phi_1278_;
                                            if ((((_e972.x * _e681) + (_e972.y * _e682)) + (_e972.z * _e683)) > 0f) {
                                                let _e986 = (((_e681 * _e940.x) + (_e682 * _e940.y)) + (_e683 * _e940.z));
                                                let _e990 = (1f - (_e952 * (1f - (_e986 * _e986))));
                                                if (_e990 >= 0f) {
                                                    let _e997 = ((_e866 * _e986) + sqrt(_e990));
                                                    phi_1324_ = vec3<f32>(((_e866 * _e940.x) - (_e997 * _e681)), ((_e866 * _e940.y) - (_e997 * _e682)), ((_e866 * _e940.z) - (_e997 * _e683)));
                                                } else {
                                                    phi_1324_ = vec3<f32>(0f, 0f, 0f);
                                                }
                                                let _e1006 = phi_1324_;
                                                phi_1325_ = _e1006;
                                            } else {
                                                phi_1325_ = _e972;
                                            }
                                            let _e1008 = phi_1325_;
                                            let _e1017 = ((((_e1008.x * _e681) + (_e1008.y * _e682)) + (_e1008.z * _e683)) < 0f);
                                            if _e1017 {
                                                let _e1018 = -(_e681);
                                                let _e1019 = -(_e682);
                                                let _e1020 = -(_e683);
                                                let _e1022 = select(_e580, _e579, (_e579 > _e580));
                                                let _e1036 = (select(_e581, _e1022, (_e1022 > _e581)) * ((bitcast<f32>((bitcast<u32>(_e1018) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1019) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e1020) & 2147483647u))));
                                                let _e1040 = (_e543 + (_e1018 * _e1036));
                                                let _e1041 = (_e544 + (_e1019 * _e1036));
                                                let _e1042 = (_e545 + (_e1020 * _e1036));
                                                if (_e1018 > 0f) {
                                                    let _e1063 = bitcast<u32>(_e1040);
                                                    if ((_e1063 & 2147483647u) == 0u) {
                                                        phi_1390_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1063 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_1389_ = bitcast<f32>((_e1063 + 1u));
                                                        } else {
                                                            phi_1389_ = bitcast<f32>((_e1063 - 1u));
                                                        }
                                                        let _e1074 = phi_1389_;
                                                        phi_1390_ = _e1074;
                                                    }
                                                    let _e1076 = phi_1390_;
                                                    phi_1416_ = _e1076;
                                                } else {
                                                    if (_e1018 < 0f) {
                                                        let _e1046 = bitcast<u32>(-(_e1040));
                                                        if ((_e1046 & 2147483647u) == 0u) {
                                                            phi_1413_ = 0.000000000000000000000000000000000000000000001f;
                                                        } else {
                                                            if ((_e1046 >> bitcast<u32>(31i)) == 0u) {
                                                                phi_1412_ = bitcast<f32>((_e1046 + 1u));
                                                            } else {
                                                                phi_1412_ = bitcast<f32>((_e1046 - 1u));
                                                            }
                                                            let _e1057 = phi_1412_;
                                                            phi_1413_ = _e1057;
                                                        }
                                                        let _e1059 = phi_1413_;
                                                        phi_1415_ = -(_e1059);
                                                    } else {
                                                        phi_1415_ = _e1040;
                                                    }
                                                    let _e1062 = phi_1415_;
                                                    phi_1416_ = _e1062;
                                                }
                                                let _e1078 = phi_1416_;
                                                if (_e1019 > 0f) {
                                                    let _e1099 = bitcast<u32>(_e1041);
                                                    if ((_e1099 & 2147483647u) == 0u) {
                                                        phi_1438_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1099 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_1437_ = bitcast<f32>((_e1099 + 1u));
                                                        } else {
                                                            phi_1437_ = bitcast<f32>((_e1099 - 1u));
                                                        }
                                                        let _e1110 = phi_1437_;
                                                        phi_1438_ = _e1110;
                                                    }
                                                    let _e1112 = phi_1438_;
                                                    phi_1464_ = _e1112;
                                                } else {
                                                    if (_e1019 < 0f) {
                                                        let _e1082 = bitcast<u32>(-(_e1041));
                                                        if ((_e1082 & 2147483647u) == 0u) {
                                                            phi_1461_ = 0.000000000000000000000000000000000000000000001f;
                                                        } else {
                                                            if ((_e1082 >> bitcast<u32>(31i)) == 0u) {
                                                                phi_1460_ = bitcast<f32>((_e1082 + 1u));
                                                            } else {
                                                                phi_1460_ = bitcast<f32>((_e1082 - 1u));
                                                            }
                                                            let _e1093 = phi_1460_;
                                                            phi_1461_ = _e1093;
                                                        }
                                                        let _e1095 = phi_1461_;
                                                        phi_1463_ = -(_e1095);
                                                    } else {
                                                        phi_1463_ = _e1041;
                                                    }
                                                    let _e1098 = phi_1463_;
                                                    phi_1464_ = _e1098;
                                                }
                                                let _e1114 = phi_1464_;
                                                if (_e1020 > 0f) {
                                                    let _e1135 = bitcast<u32>(_e1042);
                                                    if ((_e1135 & 2147483647u) == 0u) {
                                                        phi_1486_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1135 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_1485_ = bitcast<f32>((_e1135 + 1u));
                                                        } else {
                                                            phi_1485_ = bitcast<f32>((_e1135 - 1u));
                                                        }
                                                        let _e1146 = phi_1485_;
                                                        phi_1486_ = _e1146;
                                                    }
                                                    let _e1148 = phi_1486_;
                                                    phi_1512_ = _e1148;
                                                } else {
                                                    if (_e1020 < 0f) {
                                                        let _e1118 = bitcast<u32>(-(_e1042));
                                                        if ((_e1118 & 2147483647u) == 0u) {
                                                            phi_1509_ = 0.000000000000000000000000000000000000000000001f;
                                                        } else {
                                                            if ((_e1118 >> bitcast<u32>(31i)) == 0u) {
                                                                phi_1508_ = bitcast<f32>((_e1118 + 1u));
                                                            } else {
                                                                phi_1508_ = bitcast<f32>((_e1118 - 1u));
                                                            }
                                                            let _e1129 = phi_1508_;
                                                            phi_1509_ = _e1129;
                                                        }
                                                        let _e1131 = phi_1509_;
                                                        phi_1511_ = -(_e1131);
                                                    } else {
                                                        phi_1511_ = _e1042;
                                                    }
                                                    let _e1134 = phi_1511_;
                                                    phi_1512_ = _e1134;
                                                }
                                                let _e1150 = phi_1512_;
                                                phi_1515_ = type_39(vec3<f32>(_e1078, _e1114, _e1150), _e1008);
                                            } else {
                                                phi_1515_ = type_39();
                                            }
                                            let _e1154 = phi_1515_;
                                            phi_1517_ = _e1154;
                                            phi_1518_ = select(true, false, _e1017);
                                        } else {
                                            phi_1517_ = type_39();
                                            phi_1518_ = true;
                                        }
                                        let _e1157 = phi_1517_;
                                        let _e1159 = phi_1518_;
                                        if _e1159 {
                                            let _e1161 = select(_e580, _e579, (_e579 > _e580));
                                            let _e1175 = (select(_e581, _e1161, (_e1161 > _e581)) * ((bitcast<f32>((bitcast<u32>(_e681) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e682) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e683) & 2147483647u))));
                                            let _e1179 = (_e543 + (_e681 * _e1175));
                                            let _e1180 = (_e544 + (_e682 * _e1175));
                                            let _e1181 = (_e545 + (_e683 * _e1175));
                                            if (_e681 > 0f) {
                                                let _e1202 = bitcast<u32>(_e1179);
                                                if ((_e1202 & 2147483647u) == 0u) {
                                                    phi_1571_ = 0.000000000000000000000000000000000000000000001f;
                                                } else {
                                                    if ((_e1202 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_1570_ = bitcast<f32>((_e1202 + 1u));
                                                    } else {
                                                        phi_1570_ = bitcast<f32>((_e1202 - 1u));
                                                    }
                                                    let _e1213 = phi_1570_;
                                                    phi_1571_ = _e1213;
                                                }
                                                let _e1215 = phi_1571_;
                                                phi_1597_ = _e1215;
                                            } else {
                                                if (_e681 < 0f) {
                                                    let _e1185 = bitcast<u32>(-(_e1179));
                                                    if ((_e1185 & 2147483647u) == 0u) {
                                                        phi_1594_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1185 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_1593_ = bitcast<f32>((_e1185 + 1u));
                                                        } else {
                                                            phi_1593_ = bitcast<f32>((_e1185 - 1u));
                                                        }
                                                        let _e1196 = phi_1593_;
                                                        phi_1594_ = _e1196;
                                                    }
                                                    let _e1198 = phi_1594_;
                                                    phi_1596_ = -(_e1198);
                                                } else {
                                                    phi_1596_ = _e1179;
                                                }
                                                let _e1201 = phi_1596_;
                                                phi_1597_ = _e1201;
                                            }
                                            let _e1217 = phi_1597_;
                                            if (_e682 > 0f) {
                                                let _e1238 = bitcast<u32>(_e1180);
                                                if ((_e1238 & 2147483647u) == 0u) {
                                                    phi_1619_ = 0.000000000000000000000000000000000000000000001f;
                                                } else {
                                                    if ((_e1238 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_1618_ = bitcast<f32>((_e1238 + 1u));
                                                    } else {
                                                        phi_1618_ = bitcast<f32>((_e1238 - 1u));
                                                    }
                                                    let _e1249 = phi_1618_;
                                                    phi_1619_ = _e1249;
                                                }
                                                let _e1251 = phi_1619_;
                                                phi_1645_ = _e1251;
                                            } else {
                                                if (_e682 < 0f) {
                                                    let _e1221 = bitcast<u32>(-(_e1180));
                                                    if ((_e1221 & 2147483647u) == 0u) {
                                                        phi_1642_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1221 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_1641_ = bitcast<f32>((_e1221 + 1u));
                                                        } else {
                                                            phi_1641_ = bitcast<f32>((_e1221 - 1u));
                                                        }
                                                        let _e1232 = phi_1641_;
                                                        phi_1642_ = _e1232;
                                                    }
                                                    let _e1234 = phi_1642_;
                                                    phi_1644_ = -(_e1234);
                                                } else {
                                                    phi_1644_ = _e1180;
                                                }
                                                let _e1237 = phi_1644_;
                                                phi_1645_ = _e1237;
                                            }
                                            let _e1253 = phi_1645_;
                                            if (_e683 > 0f) {
                                                let _e1274 = bitcast<u32>(_e1181);
                                                if ((_e1274 & 2147483647u) == 0u) {
                                                    phi_1667_ = 0.000000000000000000000000000000000000000000001f;
                                                } else {
                                                    if ((_e1274 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_1666_ = bitcast<f32>((_e1274 + 1u));
                                                    } else {
                                                        phi_1666_ = bitcast<f32>((_e1274 - 1u));
                                                    }
                                                    let _e1285 = phi_1666_;
                                                    phi_1667_ = _e1285;
                                                }
                                                let _e1287 = phi_1667_;
                                                phi_1693_ = _e1287;
                                            } else {
                                                if (_e683 < 0f) {
                                                    let _e1257 = bitcast<u32>(-(_e1181));
                                                    if ((_e1257 & 2147483647u) == 0u) {
                                                        phi_1690_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1257 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_1689_ = bitcast<f32>((_e1257 + 1u));
                                                        } else {
                                                            phi_1689_ = bitcast<f32>((_e1257 - 1u));
                                                        }
                                                        let _e1268 = phi_1689_;
                                                        phi_1690_ = _e1268;
                                                    }
                                                    let _e1270 = phi_1690_;
                                                    phi_1692_ = -(_e1270);
                                                } else {
                                                    phi_1692_ = _e1181;
                                                }
                                                let _e1273 = phi_1692_;
                                                phi_1693_ = _e1273;
                                            }
                                            let _e1289 = phi_1693_;
                                            let _e1299 = (2f * (((_e80.member.member_2[0] * _e797.x) + (_e80.member.member_2[1] * _e797.y)) + (_e80.member.member_2[2] * _e797.z)));
                                            let _e1303 = (_e80.member.member_2[0] - (_e797.x * _e1299));
                                            let _e1304 = (_e80.member.member_2[1] - (_e797.y * _e1299));
                                            let _e1305 = (_e80.member.member_2[2] - (_e797.z * _e1299));
                                            if ((((_e1303 * _e681) + (_e1304 * _e682)) + (_e1305 * _e683)) > 0f) {
                                                phi_1736_ = vec3<f32>(_e1303, _e1304, _e1305);
                                            } else {
                                                let _e1318 = (2f * (((_e80.member.member_2[0] * _e681) + (_e80.member.member_2[1] * _e682)) + (_e80.member.member_2[2] * _e683)));
                                                phi_1736_ = vec3<f32>((_e80.member.member_2[0] - (_e681 * _e1318)), (_e80.member.member_2[1] - (_e682 * _e1318)), (_e80.member.member_2[2] - (_e683 * _e1318)));
                                            }
                                            let _e1327 = phi_1736_;
                                            phi_1738_ = type_39(vec3<f32>(_e1217, _e1253, _e1289), _e1327);
                                        } else {
                                            phi_1738_ = _e1157;
                                        }
                                        let _e1330 = phi_1738_;
                                        if _e823 {
                                            phi_1758_ = vec3<f32>((_e809.member[0] * _e809.member_2), (_e809.member[1] * _e809.member_2), (_e809.member[2] * _e809.member_2));
                                        } else {
                                            phi_1758_ = vec3(_e809.member_1);
                                        }
                                        let _e1338 = phi_1758_;
                                        phi_1776_ = type_33(type_32(array<f32, 3>(_e1330.member.x, _e1330.member.y, _e1330.member.z), 0f, array<f32, 3>(_e1330.member_1.x, _e1330.member_1.y, _e1330.member_1.z), 340282350000000000000000000000000000000f), array<f32, 3>((_e80.member_1[0] * _e1338.x), (_e80.member_1[1] * _e1338.y), (_e80.member_1[2] * _e1338.z)), _e83.member_3, _e849, _e80.member_4);
                                    }
                                    let _e1364 = phi_1776_;
                                    phi_1931_ = _e1364;
                                } else {
                                    if (0u < _e65) {
                                    } else {
                                        break;
                                    }
                                    let _e99 = bitcast<f32>((bitcast<u32>(_e80.member.member_2[0]) & 2147483647u));
                                    let _e102 = bitcast<f32>((bitcast<u32>(_e80.member.member_2[1]) & 2147483647u));
                                    let _e104 = select(_e102, _e99, (_e99 > _e102));
                                    let _e107 = bitcast<f32>((bitcast<u32>(_e80.member.member_2[2]) & 2147483647u));
                                    let _e109 = select(_e107, _e104, (_e104 > _e107));
                                    if (_e109 < 0.000000000000000000000000000000000000011754944f) {
                                        phi_1874_ = vec3<f32>(0f, 0f, 0f);
                                    } else {
                                        let _e112 = (bitcast<u32>(_e109) & 2147483647u);
                                        let _e113 = (_e112 >= 8388608u);
                                        if _e113 {
                                            phi_1824_ = (bitcast<i32>((_e112 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_1824_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e112)), 32u, (_e112 == 0u))));
                                        }
                                        let _e126 = phi_1824_;
                                        let _e133 = bitcast<f32>((bitcast<u32>(((_e126 / -2i) + 127i)) << bitcast<u32>(23i)));
                                        if _e113 {
                                            phi_1855_ = (bitcast<i32>((_e112 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_1855_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e112)), 32u, (_e112 == 0u))));
                                        }
                                        let _e149 = phi_1855_;
                                        let _e155 = bitcast<f32>((bitcast<u32>((((_e126 / 2i) - _e149) + 127i)) << bitcast<u32>(23i)));
                                        let _e156 = ((_e80.member.member_2[0] * _e133) * _e155);
                                        let _e157 = ((_e80.member.member_2[1] * _e133) * _e155);
                                        let _e158 = ((_e80.member.member_2[2] * _e133) * _e155);
                                        let _e164 = sqrt((((_e156 * _e156) + (_e157 * _e157)) + (_e158 * _e158)));
                                        phi_1874_ = vec3<f32>((_e156 / _e164), (_e157 / _e164), (_e158 / _e164));
                                    }
                                    let _e170 = phi_1874_;
                                    let _e174 = global_7.member[0u].member_6;
                                    let _e185 = (((_e170.x * _e174[0]) + (_e170.y * _e174[1])) + (_e170.z * _e174[2]));
                                    let _e187 = select(0f, _e185, (_e185 > 0f));
                                    let _e191 = global_7.member[0u].member_4;
                                    let _e198 = global_7.member[0u].member_2;
                                    phi_1931_ = type_33(type_32(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), _e80.member_1, _e80.member_2, array<f32, 3>((_e80.member_3[0] + ((_e191[0] + ((_e198[0] - _e191[0]) * _e187)) * _e80.member_1[0])), (_e80.member_3[1] + ((_e191[1] + ((_e198[1] - _e191[1]) * _e187)) * _e80.member_1[1])), (_e80.member_3[2] + ((_e191[2] + ((_e198[2] - _e191[2]) * _e187)) * _e80.member_1[2]))), _e80.member_4);
                                }
                                let _e1366 = phi_1931_;
                                if _e74 {
                                } else {
                                    break;
                                }
                                global_9.member[_e73] = _e1366;
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
