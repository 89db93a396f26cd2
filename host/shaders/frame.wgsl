struct type_3 {
    member: array<u32>,
}

struct type_6 {
    member: u32,
    member_1: u32,
}

struct type_10 {
    member: vec4<u32>,
}

struct type_15 {
    member: vec3<f32>,
    member_1: vec3<f32>,
}

struct type_18 {
    member: array<array<f32, 6>>,
}

struct type_20 {
    member: i32,
    member_1: i32,
    member_2: u32,
}

struct type_22 {
    member: array<type_20, 3>,
    member_1: u32,
}

struct type_24 {
    member: array<type_22>,
}

struct type_26 {
    member: vec3<f32>,
    member_1: vec3<f32>,
}

struct type_31 {
    member: i32,
    member_1: i32,
    member_2: u32,
    member_3: u32,
    member_4: i32,
}

var<private> global: u32;
@group(0) @binding(0) 
var<uniform> global_1: type_10;
@group(0) @binding(1) 
var<storage> global_2: type_18;
@group(0) @binding(2) 
var<storage, read_write> global_3: type_24;
@group(0) @binding(3) 
var<storage, read_write> global_4: type_3;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_18;
var<workgroup> global_6: array<type_26, 64>;

fn function_() {
    var phi_127_: u32;
    var phi_130_: type_6;
    var phi_133_: type_15;
    var phi_131_: type_6;
    var phi_156_: type_6;
    var phi_224_: type_15;
    var phi_134_: type_15;
    var phi_1483_: bool;
    var local: type_15;
    var local_1: type_15;
    var phi_237_: type_6;
    var phi_240_: u32;
    var phi_238_: type_6;
    var phi_263_: type_6;
    var phi_241_: u32;
    var phi_1495_: bool;
    var phi_454_: i32;
    var phi_476_: i32;
    var phi_486_: i32;
    var phi_528_: i32;
    var phi_538_: i32;
    var phi_571_: u32;
    var phi_643_: i32;
    var phi_665_: i32;
    var phi_675_: i32;
    var phi_717_: i32;
    var phi_727_: i32;
    var phi_760_: u32;
    var phi_832_: i32;
    var phi_854_: i32;
    var phi_864_: i32;
    var phi_906_: i32;
    var phi_916_: i32;
    var phi_949_: u32;
    var phi_1378_: bool;
    var phi_1380_: bool;
    var phi_1383_: bool;
    var phi_1384_: bool;
    var phi_1385_: bool;
    var phi_1388_: bool;
    var phi_1389_: bool;
    var phi_1390_: bool;
    var phi_1391_: bool;
    var phi_1404_: bool;
    var phi_1405_: bool;
    var phi_1413_: type_31;
    var phi_1440_: bool;
    var phi_1442_: bool;
    var phi_1445_: bool;
    var phi_1446_: bool;
    var phi_1447_: bool;
    var phi_1450_: bool;
    var phi_1451_: bool;
    var phi_1452_: bool;
    var phi_1453_: bool;
    var phi_1466_: bool;
    var phi_1467_: bool;
    var phi_1475_: type_31;
    var phi_971_: u32;
    var phi_972_: u32;
    var phi_973_: bool;
    var phi_995_: u32;
    var phi_996_: u32;
    var phi_997_: bool;
    var phi_1019_: u32;
    var phi_1020_: u32;
    var phi_1021_: bool;
    var phi_1037_: type_6;
    var phi_1040_: u32;
    var phi_1042_: u32;
    var phi_1038_: type_6;
    var phi_1065_: type_6;
    var phi_1084_: bool;
    var phi_1090_: u32;
    var phi_1091_: u32;
    var phi_1041_: u32;
    var phi_1043_: u32;
    var phi_1092_: u32;
    var phi_1094_: type_22;
    var phi_1252_: i32;
    var phi_1255_: i32;
    var phi_1256_: i32;
    var local_2: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e49 = global;
            let _e51 = arrayLength((&global_2.member));
            let _e53 = arrayLength((&global_3.member));
            let _e55 = arrayLength((&global_4.member));
            let _e57 = arrayLength((&global_5.member));
            let _e58 = (_e51 / 64u);
            if ((_e51 % 64u) > 0u) {
                phi_127_ = (_e58 + 1u);
            } else {
                phi_127_ = _e58;
            }
            let _e63 = phi_127_;
            phi_130_ = type_6(0u, _e63);
            phi_133_ = type_15(vec3<f32>(340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f), vec3<f32>(-340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f));
            loop {
                let _e66 = phi_130_;
                let _e68 = phi_133_;
                local = _e68;
                local_1 = _e68;
                if (_e66.member < _e66.member_1) {
                    phi_131_ = type_6((_e66.member + 1u), _e66.member_1);
                    phi_156_ = type_6(1u, _e66.member);
                } else {
                    phi_131_ = _e66;
                    phi_156_ = type_6(0u, type_6().member_1);
                }
                let _e81 = phi_131_;
                let _e83 = phi_156_;
                let _e87 = (bitcast<i32>(_e83.member) != 0i);
                if _e87 {
                    let _e89 = ((_e83.member_1 * 64u) + _e49);
                    let _e90 = (_e89 < _e51);
                    if _e90 {
                        if _e90 {
                        } else {
                            phi_1483_ = true;
                            break;
                        }
                        let _e93 = global_2.member[_e89];
                        phi_224_ = type_15(vec3<f32>(select(_e93[0], _e68.member.x, (_e68.member.x < _e93[0])), select(_e93[1], _e68.member.y, (_e68.member.y < _e93[1])), select(_e93[2], _e68.member.z, (_e68.member.z < _e93[2]))), vec3<f32>(select(_e93[3], _e68.member_1.x, (_e68.member_1.x > _e93[3])), select(_e93[4], _e68.member_1.y, (_e68.member_1.y > _e93[4])), select(_e93[5], _e68.member_1.z, (_e68.member_1.z > _e93[5]))));
                    } else {
                        phi_224_ = _e68;
                    }
                    let _e124 = phi_224_;
                    phi_134_ = _e124;
                } else {
                    phi_134_ = type_15();
                }
                let _e126 = phi_134_;
                continue;
                continuing {
                    phi_130_ = _e81;
                    phi_133_ = _e126;
                    phi_1483_ = false;
                    break if !(_e87);
                }
            }
            let _e129 = phi_1483_;
            if _e129 {
                break;
            }
            let _e130 = (_e49 % 64u);
            let _e131 = (_e130 < 64u);
            if _e131 {
            } else {
                break;
            }
            let _e134 = local;
            let _e137 = local_1;
            global_6[_e130] = type_26(_e134.member, _e137.member_1);
            workgroupBarrier();
            phi_237_ = type_6(0u, 6u);
            phi_240_ = 32u;
            loop {
                let _e141 = phi_237_;
                let _e143 = phi_240_;
                if (_e141.member < _e141.member_1) {
                    phi_238_ = type_6((_e141.member + 1u), _e141.member_1);
                    phi_263_ = type_6(1u, _e141.member);
                } else {
                    phi_238_ = _e141;
                    phi_263_ = type_6(0u, type_6().member_1);
                }
                let _e156 = phi_238_;
                let _e158 = phi_263_;
                let _e161 = (bitcast<i32>(_e158.member) != 0i);
                if _e161 {
                    if (_e49 < _e143) {
                        if _e131 {
                        } else {
                            phi_1495_ = true;
                            break;
                        }
                        let _e163 = global_6[_e130];
                        let _e167 = ((_e49 + _e143) % 64u);
                        if (_e167 < 64u) {
                        } else {
                            phi_1495_ = true;
                            break;
                        }
                        let _e170 = global_6[_e167];
                        if _e131 {
                        } else {
                            phi_1495_ = true;
                            break;
                        }
                        global_6[_e130] = type_26(vec3<f32>(select(_e170.member.x, _e163.member.x, (_e163.member.x < _e170.member.x)), select(_e170.member.y, _e163.member.y, (_e163.member.y < _e170.member.y)), select(_e170.member.z, _e163.member.z, (_e163.member.z < _e170.member.z))), vec3<f32>(select(_e170.member_1.x, _e163.member_1.x, (_e163.member_1.x > _e170.member_1.x)), select(_e170.member_1.y, _e163.member_1.y, (_e163.member_1.y > _e170.member_1.y)), select(_e170.member_1.z, _e163.member_1.z, (_e163.member_1.z > _e170.member_1.z))));
                    }
                    workgroupBarrier();
                    phi_241_ = (_e143 / 2u);
                } else {
                    phi_241_ = u32();
                }
                let _e202 = phi_241_;
                continue;
                continuing {
                    phi_237_ = _e156;
                    phi_240_ = _e202;
                    phi_1495_ = _e129;
                    break if !(_e161);
                }
            }
            let _e205 = phi_1495_;
            if _e205 {
                break;
            }
            if (_e49 == 0u) {
                if (_e53 == 0u) {
                } else {
                    if (_e55 == 0u) {
                    } else {
                        if (_e57 == 0u) {
                        } else {
                            let _e211 = global_6[0u];
                            let _e216 = global_1.member[0u];
                            let _e219 = (_e211.member.x > _e211.member_1.x);
                            if _e219 {
                                phi_1094_ = type_22(array<type_20, 3>(type_20(0i, 0i, 0u), type_20(0i, 0i, 0u), type_20(0i, 0i, 0u)), 0u);
                            } else {
                                let _e220 = bitcast<u32>(_e211.member.x);
                                let _e222 = bitcast<f32>((_e220 & 2147483647u));
                                let _e223 = bitcast<u32>(_e211.member_1.x);
                                let _e225 = bitcast<f32>((_e223 & 2147483647u));
                                let _e227 = select(_e225, _e222, (_e222 > _e225));
                                let _e229 = select(_e225, _e222, (_e222 < _e225));
                                let _e233 = (bitcast<u32>(select(_e229, _e227, (_e227 > _e229))) & 2147483647u);
                                if (_e233 >= 8388608u) {
                                    phi_454_ = (bitcast<i32>((_e233 >> bitcast<u32>(23i))) - 127i);
                                } else {
                                    phi_454_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e233)), 32u, (_e233 == 0u))));
                                }
                                let _e247 = phi_454_;
                                let _e248 = (_e247 + -23i);
                                let _e251 = ((_e220 >> bitcast<u32>(23i)) & 255u);
                                let _e253 = select(0u, 1u, (_e251 != 0u));
                                let _e262 = (_e248 - ((bitcast<i32>(_e251) - bitcast<i32>(_e253)) + -149i));
                                let _e263 = (_e262 < 0i);
                                if _e263 {
                                    phi_476_ = -(_e262);
                                } else {
                                    phi_476_ = 0i;
                                }
                                let _e266 = phi_476_;
                                if _e263 {
                                    phi_486_ = 0i;
                                } else {
                                    phi_486_ = select(_e262, 31i, (_e262 > 31i));
                                }
                                let _e270 = phi_486_;
                                let _e271 = (_e270 & 31i);
                                let _e285 = (bitcast<i32>(_e220) >> bitcast<u32>(31i));
                                let _e289 = (2i * ((bitcast<i32>((((((_e220 & 8388607u) | (_e253 << bitcast<u32>(23i))) << bitcast<u32>((bitcast<u32>(_e266) & 31u))) + ((1u << bitcast<u32>(_e271)) >> bitcast<u32>(1i))) >> bitcast<u32>(_e271))) ^ _e285) - _e285));
                                let _e292 = ((_e223 >> bitcast<u32>(23i)) & 255u);
                                let _e294 = select(0u, 1u, (_e292 != 0u));
                                let _e303 = (_e248 - ((bitcast<i32>(_e292) - bitcast<i32>(_e294)) + -149i));
                                let _e304 = (_e303 < 0i);
                                if _e304 {
                                    phi_528_ = -(_e303);
                                } else {
                                    phi_528_ = 0i;
                                }
                                let _e307 = phi_528_;
                                if _e304 {
                                    phi_538_ = 0i;
                                } else {
                                    phi_538_ = select(_e303, 31i, (_e303 > 31i));
                                }
                                let _e311 = phi_538_;
                                let _e312 = (_e311 & 31i);
                                let _e326 = (bitcast<i32>(_e223) >> bitcast<u32>(31i));
                                let _e332 = bitcast<u32>(((2i * ((bitcast<i32>((((((_e223 & 8388607u) | (_e294 << bitcast<u32>(23i))) << bitcast<u32>((bitcast<u32>(_e307) & 31u))) + ((1u << bitcast<u32>(_e312)) >> bitcast<u32>(1i))) >> bitcast<u32>(_e312))) ^ _e326) - _e326)) - _e289));
                                let _e333 = (_e332 == 0u);
                                if _e333 {
                                    phi_571_ = 0u;
                                } else {
                                    phi_571_ = select((bitcast<u32>(31i) - firstLeadingBit(_e332)), 32u, _e333);
                                }
                                let _e339 = phi_571_;
                                let _e342 = (_e332 << bitcast<u32>((_e339 & 31u)));
                                let _e344 = (_e248 - bitcast<i32>(_e339));
                                let _e348 = bitcast<u32>(_e211.member.y);
                                let _e350 = bitcast<f32>((_e348 & 2147483647u));
                                let _e351 = bitcast<u32>(_e211.member_1.y);
                                let _e353 = bitcast<f32>((_e351 & 2147483647u));
                                let _e355 = select(_e353, _e350, (_e350 > _e353));
                                let _e357 = select(_e353, _e350, (_e350 < _e353));
                                let _e361 = (bitcast<u32>(select(_e357, _e355, (_e355 > _e357))) & 2147483647u);
                                if (_e361 >= 8388608u) {
                                    phi_643_ = (bitcast<i32>((_e361 >> bitcast<u32>(23i))) - 127i);
                                } else {
                                    phi_643_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e361)), 32u, (_e361 == 0u))));
                                }
                                let _e375 = phi_643_;
                                let _e376 = (_e375 + -23i);
                                let _e379 = ((_e348 >> bitcast<u32>(23i)) & 255u);
                                let _e381 = select(0u, 1u, (_e379 != 0u));
                                let _e390 = (_e376 - ((bitcast<i32>(_e379) - bitcast<i32>(_e381)) + -149i));
                                let _e391 = (_e390 < 0i);
                                if _e391 {
                                    phi_665_ = -(_e390);
                                } else {
                                    phi_665_ = 0i;
                                }
                                let _e394 = phi_665_;
                                if _e391 {
                                    phi_675_ = 0i;
                                } else {
                                    phi_675_ = select(_e390, 31i, (_e390 > 31i));
                                }
                                let _e398 = phi_675_;
                                let _e399 = (_e398 & 31i);
                                let _e413 = (bitcast<i32>(_e348) >> bitcast<u32>(31i));
                                let _e417 = (2i * ((bitcast<i32>((((((_e348 & 8388607u) | (_e381 << bitcast<u32>(23i))) << bitcast<u32>((bitcast<u32>(_e394) & 31u))) + ((1u << bitcast<u32>(_e399)) >> bitcast<u32>(1i))) >> bitcast<u32>(_e399))) ^ _e413) - _e413));
                                let _e420 = ((_e351 >> bitcast<u32>(23i)) & 255u);
                                let _e422 = select(0u, 1u, (_e420 != 0u));
                                let _e431 = (_e376 - ((bitcast<i32>(_e420) - bitcast<i32>(_e422)) + -149i));
                                let _e432 = (_e431 < 0i);
                                if _e432 {
                                    phi_717_ = -(_e431);
                                } else {
                                    phi_717_ = 0i;
                                }
                                let _e435 = phi_717_;
                                if _e432 {
                                    phi_727_ = 0i;
                                } else {
                                    phi_727_ = select(_e431, 31i, (_e431 > 31i));
                                }
                                let _e439 = phi_727_;
                                let _e440 = (_e439 & 31i);
                                let _e454 = (bitcast<i32>(_e351) >> bitcast<u32>(31i));
                                let _e460 = bitcast<u32>(((2i * ((bitcast<i32>((((((_e351 & 8388607u) | (_e422 << bitcast<u32>(23i))) << bitcast<u32>((bitcast<u32>(_e435) & 31u))) + ((1u << bitcast<u32>(_e440)) >> bitcast<u32>(1i))) >> bitcast<u32>(_e440))) ^ _e454) - _e454)) - _e417));
                                let _e461 = (_e460 == 0u);
                                if _e461 {
                                    phi_760_ = 0u;
                                } else {
                                    phi_760_ = select((bitcast<u32>(31i) - firstLeadingBit(_e460)), 32u, _e461);
                                }
                                let _e467 = phi_760_;
                                let _e470 = (_e460 << bitcast<u32>((_e467 & 31u)));
                                let _e472 = (_e376 - bitcast<i32>(_e467));
                                let _e476 = bitcast<u32>(_e211.member.z);
                                let _e478 = bitcast<f32>((_e476 & 2147483647u));
                                let _e479 = bitcast<u32>(_e211.member_1.z);
                                let _e481 = bitcast<f32>((_e479 & 2147483647u));
                                let _e483 = select(_e481, _e478, (_e478 > _e481));
                                let _e485 = select(_e481, _e478, (_e478 < _e481));
                                let _e489 = (bitcast<u32>(select(_e485, _e483, (_e483 > _e485))) & 2147483647u);
                                if (_e489 >= 8388608u) {
                                    phi_832_ = (bitcast<i32>((_e489 >> bitcast<u32>(23i))) - 127i);
                                } else {
                                    phi_832_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e489)), 32u, (_e489 == 0u))));
                                }
                                let _e503 = phi_832_;
                                let _e504 = (_e503 + -23i);
                                let _e507 = ((_e476 >> bitcast<u32>(23i)) & 255u);
                                let _e509 = select(0u, 1u, (_e507 != 0u));
                                let _e518 = (_e504 - ((bitcast<i32>(_e507) - bitcast<i32>(_e509)) + -149i));
                                let _e519 = (_e518 < 0i);
                                if _e519 {
                                    phi_854_ = -(_e518);
                                } else {
                                    phi_854_ = 0i;
                                }
                                let _e522 = phi_854_;
                                if _e519 {
                                    phi_864_ = 0i;
                                } else {
                                    phi_864_ = select(_e518, 31i, (_e518 > 31i));
                                }
                                let _e526 = phi_864_;
                                let _e527 = (_e526 & 31i);
                                let _e541 = (bitcast<i32>(_e476) >> bitcast<u32>(31i));
                                let _e545 = (2i * ((bitcast<i32>((((((_e476 & 8388607u) | (_e509 << bitcast<u32>(23i))) << bitcast<u32>((bitcast<u32>(_e522) & 31u))) + ((1u << bitcast<u32>(_e527)) >> bitcast<u32>(1i))) >> bitcast<u32>(_e527))) ^ _e541) - _e541));
                                let _e548 = ((_e479 >> bitcast<u32>(23i)) & 255u);
                                let _e550 = select(0u, 1u, (_e548 != 0u));
                                let _e559 = (_e504 - ((bitcast<i32>(_e548) - bitcast<i32>(_e550)) + -149i));
                                let _e560 = (_e559 < 0i);
                                if _e560 {
                                    phi_906_ = -(_e559);
                                } else {
                                    phi_906_ = 0i;
                                }
                                let _e563 = phi_906_;
                                if _e560 {
                                    phi_916_ = 0i;
                                } else {
                                    phi_916_ = select(_e559, 31i, (_e559 > 31i));
                                }
                                let _e567 = phi_916_;
                                let _e568 = (_e567 & 31i);
                                let _e582 = (bitcast<i32>(_e479) >> bitcast<u32>(31i));
                                let _e588 = bitcast<u32>(((2i * ((bitcast<i32>((((((_e479 & 8388607u) | (_e550 << bitcast<u32>(23i))) << bitcast<u32>((bitcast<u32>(_e563) & 31u))) + ((1u << bitcast<u32>(_e568)) >> bitcast<u32>(1i))) >> bitcast<u32>(_e568))) ^ _e582) - _e582)) - _e545));
                                let _e589 = (_e588 == 0u);
                                if _e589 {
                                    phi_949_ = 0u;
                                } else {
                                    phi_949_ = select((bitcast<u32>(31i) - firstLeadingBit(_e588)), 32u, _e589);
                                }
                                let _e595 = phi_949_;
                                let _e598 = (_e588 << bitcast<u32>((_e595 & 31u)));
                                let _e600 = (_e504 - bitcast<i32>(_e595));
                                if (_e470 > 0u) {
                                    if (_e342 == 0u) {
                                        phi_1388_ = true;
                                        phi_1389_ = false;
                                        phi_1390_ = false;
                                        phi_1391_ = false;
                                    } else {
                                        let _e604 = (_e472 > _e344);
                                        if _e604 {
                                            phi_1383_ = false;
                                            phi_1384_ = false;
                                            phi_1385_ = false;
                                        } else {
                                            let _e605 = (_e472 == _e344);
                                            if _e605 {
                                                let _e606 = (_e470 > _e342);
                                                phi_1378_ = _e606;
                                                phi_1380_ = select(true, false, _e606);
                                            } else {
                                                phi_1378_ = false;
                                                phi_1380_ = false;
                                            }
                                            let _e609 = phi_1378_;
                                            let _e611 = phi_1380_;
                                            phi_1383_ = _e609;
                                            phi_1384_ = select(true, false, _e605);
                                            phi_1385_ = _e611;
                                        }
                                        let _e614 = phi_1383_;
                                        let _e616 = phi_1384_;
                                        let _e618 = phi_1385_;
                                        phi_1388_ = _e604;
                                        phi_1389_ = _e614;
                                        phi_1390_ = _e616;
                                        phi_1391_ = _e618;
                                    }
                                    let _e620 = phi_1388_;
                                    let _e622 = phi_1389_;
                                    let _e624 = phi_1390_;
                                    let _e626 = phi_1391_;
                                    let _e627 = select(_e622, true, _e620);
                                    phi_1404_ = select(select(_e624, false, _e620), false, _e627);
                                    phi_1405_ = select(select(_e626, false, _e620), false, _e627);
                                } else {
                                    phi_1404_ = true;
                                    phi_1405_ = false;
                                }
                                let _e633 = phi_1404_;
                                let _e635 = phi_1405_;
                                if select(_e635, true, _e633) {
                                    phi_1413_ = type_31(_e248, _e289, _e342, _e339, _e344);
                                } else {
                                    phi_1413_ = type_31(_e376, _e417, _e470, _e467, _e472);
                                }
                                let _e638 = phi_1413_;
                                if (_e598 > 0u) {
                                    if (_e638.member_2 == 0u) {
                                        phi_1450_ = true;
                                        phi_1451_ = false;
                                        phi_1452_ = false;
                                        phi_1453_ = false;
                                    } else {
                                        let _e643 = (_e600 > _e638.member_4);
                                        if _e643 {
                                            phi_1445_ = false;
                                            phi_1446_ = false;
                                            phi_1447_ = false;
                                        } else {
                                            let _e644 = (_e600 == _e638.member_4);
                                            if _e644 {
                                                let _e645 = (_e598 > _e638.member_2);
                                                phi_1440_ = _e645;
                                                phi_1442_ = select(true, false, _e645);
                                            } else {
                                                phi_1440_ = false;
                                                phi_1442_ = false;
                                            }
                                            let _e648 = phi_1440_;
                                            let _e650 = phi_1442_;
                                            phi_1445_ = _e648;
                                            phi_1446_ = select(true, false, _e644);
                                            phi_1447_ = _e650;
                                        }
                                        let _e653 = phi_1445_;
                                        let _e655 = phi_1446_;
                                        let _e657 = phi_1447_;
                                        phi_1450_ = _e643;
                                        phi_1451_ = _e653;
                                        phi_1452_ = _e655;
                                        phi_1453_ = _e657;
                                    }
                                    let _e659 = phi_1450_;
                                    let _e661 = phi_1451_;
                                    let _e663 = phi_1452_;
                                    let _e665 = phi_1453_;
                                    let _e666 = select(_e661, true, _e659);
                                    phi_1466_ = select(select(_e663, false, _e659), false, _e666);
                                    phi_1467_ = select(select(_e665, false, _e659), false, _e666);
                                } else {
                                    phi_1466_ = true;
                                    phi_1467_ = false;
                                }
                                let _e672 = phi_1466_;
                                let _e674 = phi_1467_;
                                if select(_e674, true, _e672) {
                                    phi_1475_ = _e638;
                                } else {
                                    phi_1475_ = type_31(_e504, _e545, _e598, _e595, _e600);
                                }
                                let _e677 = phi_1475_;
                                let _e681 = bitcast<i32>(_e216);
                                let _e682 = (((_e677.member_4 - _e344) + 31i) - _e681);
                                if (_e342 == 0u) {
                                    phi_972_ = u32();
                                    phi_973_ = true;
                                } else {
                                    let _e684 = (_e682 > 31i);
                                    if _e684 {
                                        phi_971_ = u32();
                                    } else {
                                        phi_971_ = bitcast<u32>(_e682);
                                    }
                                    let _e687 = phi_971_;
                                    phi_972_ = _e687;
                                    phi_973_ = _e684;
                                }
                                let _e689 = phi_972_;
                                let _e691 = phi_973_;
                                let _e699 = (((_e677.member_4 - _e472) + 31i) - _e681);
                                if (_e470 == 0u) {
                                    phi_996_ = u32();
                                    phi_997_ = true;
                                } else {
                                    let _e701 = (_e699 > 31i);
                                    if _e701 {
                                        phi_995_ = u32();
                                    } else {
                                        phi_995_ = bitcast<u32>(_e699);
                                    }
                                    let _e704 = phi_995_;
                                    phi_996_ = _e704;
                                    phi_997_ = _e701;
                                }
                                let _e706 = phi_996_;
                                let _e708 = phi_997_;
                                let _e716 = (((_e677.member_4 - _e600) + 31i) - _e681);
                                if (_e598 == 0u) {
                                    phi_1020_ = u32();
                                    phi_1021_ = true;
                                } else {
                                    let _e718 = (_e716 > 31i);
                                    if _e718 {
                                        phi_1019_ = u32();
                                    } else {
                                        phi_1019_ = bitcast<u32>(_e716);
                                    }
                                    let _e721 = phi_1019_;
                                    phi_1020_ = _e721;
                                    phi_1021_ = _e718;
                                }
                                let _e723 = phi_1020_;
                                let _e725 = phi_1021_;
                                if (_e677.member_2 == 0u) {
                                    phi_1092_ = 0u;
                                } else {
                                    phi_1037_ = type_6(0u, 63u);
                                    phi_1040_ = 0u;
                                    phi_1042_ = 0u;
                                    loop {
                                        let _e735 = phi_1037_;
                                        let _e737 = phi_1040_;
                                        let _e739 = phi_1042_;
                                        local_2 = _e739;
                                        if (_e735.member < _e735.member_1) {
                                            phi_1038_ = type_6((_e735.member + 1u), _e735.member_1);
                                            phi_1065_ = type_6(1u, _e735.member);
                                        } else {
                                            phi_1038_ = _e735;
                                            phi_1065_ = type_6(0u, type_6().member_1);
                                        }
                                        let _e752 = phi_1038_;
                                        let _e754 = phi_1065_;
                                        let _e757 = (bitcast<i32>(_e754.member) != 0i);
                                        if _e757 {
                                            let _e762 = ((_e737 << bitcast<u32>(1i)) | 1u);
                                            let _e764 = (_e739 << bitcast<u32>(1i));
                                            if ((_e737 >> bitcast<u32>(31i)) == 1u) {
                                                phi_1084_ = true;
                                            } else {
                                                phi_1084_ = (_e762 >= _e677.member_2);
                                            }
                                            let _e768 = phi_1084_;
                                            if _e768 {
                                                phi_1090_ = (_e762 - _e677.member_2);
                                                phi_1091_ = (_e764 | 1u);
                                            } else {
                                                phi_1090_ = _e762;
                                                phi_1091_ = _e764;
                                            }
                                            let _e772 = phi_1090_;
                                            let _e774 = phi_1091_;
                                            phi_1041_ = _e772;
                                            phi_1043_ = _e774;
                                        } else {
                                            phi_1041_ = u32();
                                            phi_1043_ = u32();
                                        }
                                        let _e776 = phi_1041_;
                                        let _e778 = phi_1043_;
                                        continue;
                                        continuing {
                                            phi_1037_ = _e752;
                                            phi_1040_ = _e776;
                                            phi_1042_ = _e778;
                                            break if !(_e757);
                                        }
                                    }
                                    let _e945 = local_2;
                                    phi_1092_ = _e945;
                                }
                                let _e781 = phi_1092_;
                                phi_1094_ = type_22(array<type_20, 3>(type_20(_e248, _e289, (_e339 | (select(_e689, 31u, _e691) << bitcast<u32>(16i)))), type_20(_e376, _e417, (_e467 | (select(_e706, 31u, _e708) << bitcast<u32>(16i)))), type_20(_e504, _e545, (_e595 | (select(_e723, 31u, _e725) << bitcast<u32>(16i))))), _e781);
                            }
                            let _e784 = phi_1094_;
                            if (0u < _e53) {
                            } else {
                                break;
                            }
                            global_3.member[0u] = _e784;
                            if _e219 {
                                phi_1256_ = 0i;
                            } else {
                                let _e790 = bitcast<f32>((bitcast<u32>(_e211.member.x) & 2147483647u));
                                let _e793 = bitcast<f32>((bitcast<u32>(_e211.member_1.x) & 2147483647u));
                                let _e795 = select(_e793, _e790, (_e790 > _e793));
                                let _e797 = select(_e793, _e790, (_e790 < _e793));
                                let _e799 = select(_e797, _e795, (_e795 > _e797));
                                let _e804 = bitcast<f32>((bitcast<u32>(_e211.member.y) & 2147483647u));
                                let _e807 = bitcast<f32>((bitcast<u32>(_e211.member_1.y) & 2147483647u));
                                let _e809 = select(_e807, _e804, (_e804 > _e807));
                                let _e811 = select(_e807, _e804, (_e804 < _e807));
                                let _e813 = select(_e811, _e809, (_e809 > _e811));
                                let _e815 = select(_e813, _e799, (_e799 > _e813));
                                let _e820 = bitcast<f32>((bitcast<u32>(_e211.member.z) & 2147483647u));
                                let _e823 = bitcast<f32>((bitcast<u32>(_e211.member_1.z) & 2147483647u));
                                let _e825 = select(_e823, _e820, (_e820 > _e823));
                                let _e827 = select(_e823, _e820, (_e820 < _e823));
                                let _e829 = select(_e827, _e825, (_e825 > _e827));
                                let _e831 = select(_e829, _e815, (_e815 > _e829));
                                if (_e831 > 0f) {
                                    let _e834 = (bitcast<u32>(_e831) & 2147483647u);
                                    if (_e834 >= 8388608u) {
                                        phi_1252_ = (bitcast<i32>((_e834 >> bitcast<u32>(23i))) - 127i);
                                    } else {
                                        phi_1252_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e834)), 32u, (_e834 == 0u))));
                                    }
                                    let _e848 = phi_1252_;
                                    phi_1255_ = (-1i - _e848);
                                } else {
                                    phi_1255_ = 0i;
                                }
                                let _e851 = phi_1255_;
                                phi_1256_ = _e851;
                            }
                            let _e853 = phi_1256_;
                            if (0u < _e55) {
                            } else {
                                break;
                            }
                            global_4.member[0u] = bitcast<u32>(_e853);
                            if (0u < _e57) {
                            } else {
                                break;
                            }
                            global_5.member[0u] = array<f32, 6>(_e211.member.x, _e211.member.y, _e211.member.z, _e211.member_1.x, _e211.member_1.y, _e211.member_1.z);
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
fn frame(@builtin(local_invocation_index) param: u32) {
    global = param;
    function_();
}
