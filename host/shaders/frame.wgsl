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

struct type_19 {
    member: array<array<f32, 6>>,
}

struct type_21 {
    member: i32,
    member_1: i32,
    member_2: u32,
}

struct type_23 {
    member: array<type_21, 3>,
    member_1: u32,
}

struct type_25 {
    member: array<type_23>,
}

struct type_27 {
    member: vec3<f32>,
    member_1: vec3<f32>,
}

struct type_33 {
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
var<storage> global_2: type_19;
@group(0) @binding(2) 
var<storage, read_write> global_3: type_25;
@group(0) @binding(3) 
var<storage, read_write> global_4: type_3;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_19;
var<workgroup> global_6: array<type_27, 64>;

fn function_() {
    var local: type_27;
    var phi_138_: u32;
    var phi_141_: type_6;
    var phi_144_: type_15;
    var phi_142_: type_6;
    var phi_167_: type_6;
    var phi_209_: type_15;
    var phi_145_: type_15;
    var phi_1613_: bool;
    var local_1: type_15;
    var local_2: type_15;
    var phi_222_: type_6;
    var phi_225_: u32;
    var phi_223_: type_6;
    var phi_248_: type_6;
    var phi_226_: u32;
    var phi_1625_: bool;
    var phi_1176_: i32;
    var phi_1226_: u32;
    var phi_1301_: i32;
    var phi_1351_: u32;
    var phi_1426_: i32;
    var phi_1476_: u32;
    var phi_1508_: bool;
    var phi_1510_: bool;
    var phi_1513_: bool;
    var phi_1514_: bool;
    var phi_1515_: bool;
    var phi_1518_: bool;
    var phi_1519_: bool;
    var phi_1520_: bool;
    var phi_1521_: bool;
    var phi_1534_: bool;
    var phi_1535_: bool;
    var phi_1543_: type_33;
    var phi_1570_: bool;
    var phi_1572_: bool;
    var phi_1575_: bool;
    var phi_1576_: bool;
    var phi_1577_: bool;
    var phi_1580_: bool;
    var phi_1581_: bool;
    var phi_1582_: bool;
    var phi_1583_: bool;
    var phi_1596_: bool;
    var phi_1597_: bool;
    var phi_1605_: type_33;
    var phi_366_: u32;
    var phi_367_: u32;
    var phi_368_: bool;
    var phi_395_: u32;
    var phi_396_: u32;
    var phi_397_: bool;
    var phi_424_: u32;
    var phi_425_: u32;
    var phi_426_: bool;
    var phi_445_: type_6;
    var phi_448_: u32;
    var phi_450_: u32;
    var phi_446_: type_6;
    var phi_473_: type_6;
    var phi_492_: bool;
    var phi_498_: u32;
    var phi_499_: u32;
    var phi_449_: u32;
    var phi_451_: u32;
    var phi_500_: u32;
    var phi_502_: type_23;
    var phi_637_: i32;
    var phi_640_: i32;
    var phi_641_: i32;
    var local_3: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e51 = global;
            let _e53 = arrayLength((&global_2.member));
            let _e55 = arrayLength((&global_3.member));
            let _e57 = arrayLength((&global_4.member));
            let _e59 = arrayLength((&global_5.member));
            let _e60 = (_e53 / 64u);
            if ((_e53 % 64u) > 0u) {
                phi_138_ = (_e60 + 1u);
            } else {
                phi_138_ = _e60;
            }
            let _e65 = phi_138_;
            phi_141_ = type_6(0u, _e65);
            phi_144_ = type_15(vec3<f32>(340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f), vec3<f32>(-340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f));
            loop {
                let _e68 = phi_141_;
                let _e70 = phi_144_;
                local_1 = _e70;
                local_2 = _e70;
                if (_e68.member < _e68.member_1) {
                    phi_142_ = type_6((_e68.member + 1u), _e68.member_1);
                    phi_167_ = type_6(1u, _e68.member);
                } else {
                    phi_142_ = _e68;
                    phi_167_ = type_6(0u, type_6().member_1);
                }
                let _e83 = phi_142_;
                let _e85 = phi_167_;
                let _e89 = (bitcast<i32>(_e85.member) != 0i);
                if _e89 {
                    let _e91 = ((_e85.member_1 * 64u) + _e51);
                    let _e92 = (_e91 < _e53);
                    if _e92 {
                        if _e92 {
                        } else {
                            phi_1613_ = true;
                            break;
                        }
                        let _e95 = global_2.member[_e91];
                        let _e105 = bitcast<i32>(bitcast<u32>(_e70.member.x));
                        let _e111 = bitcast<i32>(bitcast<u32>(_e95[0]));
                        let _e121 = bitcast<i32>(bitcast<u32>(_e70.member.y));
                        let _e127 = bitcast<i32>(bitcast<u32>(_e95[1]));
                        let _e137 = bitcast<i32>(bitcast<u32>(_e70.member.z));
                        let _e143 = bitcast<i32>(bitcast<u32>(_e95[2]));
                        let _e154 = bitcast<i32>(bitcast<u32>(_e70.member_1.x));
                        let _e160 = bitcast<i32>(bitcast<u32>(_e95[3]));
                        let _e170 = bitcast<i32>(bitcast<u32>(_e70.member_1.y));
                        let _e176 = bitcast<i32>(bitcast<u32>(_e95[4]));
                        let _e186 = bitcast<i32>(bitcast<u32>(_e70.member_1.z));
                        let _e192 = bitcast<i32>(bitcast<u32>(_e95[5]));
                        phi_209_ = type_15(vec3<f32>(select(_e95[0], _e70.member.x, ((_e105 ^ ((_e105 >> bitcast<u32>(31i)) & 2147483647i)) < (_e111 ^ ((_e111 >> bitcast<u32>(31i)) & 2147483647i)))), select(_e95[1], _e70.member.y, ((_e121 ^ ((_e121 >> bitcast<u32>(31i)) & 2147483647i)) < (_e127 ^ ((_e127 >> bitcast<u32>(31i)) & 2147483647i)))), select(_e95[2], _e70.member.z, ((_e137 ^ ((_e137 >> bitcast<u32>(31i)) & 2147483647i)) < (_e143 ^ ((_e143 >> bitcast<u32>(31i)) & 2147483647i))))), vec3<f32>(select(_e95[3], _e70.member_1.x, ((_e154 ^ ((_e154 >> bitcast<u32>(31i)) & 2147483647i)) > (_e160 ^ ((_e160 >> bitcast<u32>(31i)) & 2147483647i)))), select(_e95[4], _e70.member_1.y, ((_e170 ^ ((_e170 >> bitcast<u32>(31i)) & 2147483647i)) > (_e176 ^ ((_e176 >> bitcast<u32>(31i)) & 2147483647i)))), select(_e95[5], _e70.member_1.z, ((_e186 ^ ((_e186 >> bitcast<u32>(31i)) & 2147483647i)) > (_e192 ^ ((_e192 >> bitcast<u32>(31i)) & 2147483647i))))));
                    } else {
                        phi_209_ = _e70;
                    }
                    let _e202 = phi_209_;
                    phi_145_ = _e202;
                } else {
                    phi_145_ = type_15();
                }
                let _e204 = phi_145_;
                continue;
                continuing {
                    phi_141_ = _e83;
                    phi_144_ = _e204;
                    phi_1613_ = false;
                    break if !(_e89);
                }
            }
            let _e207 = phi_1613_;
            if _e207 {
                break;
            }
            let _e208 = (_e51 % 64u);
            let _e209 = (_e208 < 64u);
            if _e209 {
            } else {
                break;
            }
            let _e212 = local_1;
            let _e215 = local_2;
            global_6[_e208] = type_27(_e212.member, _e215.member_1);
            workgroupBarrier();
            phi_222_ = type_6(0u, 6u);
            phi_225_ = 32u;
            loop {
                let _e219 = phi_222_;
                let _e221 = phi_225_;
                if (_e219.member < _e219.member_1) {
                    phi_223_ = type_6((_e219.member + 1u), _e219.member_1);
                    phi_248_ = type_6(1u, _e219.member);
                } else {
                    phi_223_ = _e219;
                    phi_248_ = type_6(0u, type_6().member_1);
                }
                let _e234 = phi_223_;
                let _e236 = phi_248_;
                let _e239 = (bitcast<i32>(_e236.member) != 0i);
                if _e239 {
                    if (_e51 < _e221) {
                        if _e209 {
                        } else {
                            phi_1625_ = true;
                            break;
                        }
                        let _e241 = global_6[_e208];
                        let _e245 = ((_e51 + _e221) % 64u);
                        if (_e245 < 64u) {
                        } else {
                            phi_1625_ = true;
                            break;
                        }
                        let _e248 = global_6[_e245];
                        let _e254 = bitcast<i32>(bitcast<u32>(_e241.member.x));
                        let _e260 = bitcast<i32>(bitcast<u32>(_e248.member.x));
                        let _e270 = bitcast<i32>(bitcast<u32>(_e241.member.y));
                        let _e276 = bitcast<i32>(bitcast<u32>(_e248.member.y));
                        let _e286 = bitcast<i32>(bitcast<u32>(_e241.member.z));
                        let _e292 = bitcast<i32>(bitcast<u32>(_e248.member.z));
                        let _e303 = bitcast<i32>(bitcast<u32>(_e241.member_1.x));
                        let _e309 = bitcast<i32>(bitcast<u32>(_e248.member_1.x));
                        let _e319 = bitcast<i32>(bitcast<u32>(_e241.member_1.y));
                        let _e325 = bitcast<i32>(bitcast<u32>(_e248.member_1.y));
                        let _e335 = bitcast<i32>(bitcast<u32>(_e241.member_1.z));
                        let _e341 = bitcast<i32>(bitcast<u32>(_e248.member_1.z));
                        if _e209 {
                        } else {
                            phi_1625_ = true;
                            break;
                        }
                        global_6[_e208] = type_27(vec3<f32>(select(_e248.member.x, _e241.member.x, ((_e254 ^ ((_e254 >> bitcast<u32>(31i)) & 2147483647i)) < (_e260 ^ ((_e260 >> bitcast<u32>(31i)) & 2147483647i)))), select(_e248.member.y, _e241.member.y, ((_e270 ^ ((_e270 >> bitcast<u32>(31i)) & 2147483647i)) < (_e276 ^ ((_e276 >> bitcast<u32>(31i)) & 2147483647i)))), select(_e248.member.z, _e241.member.z, ((_e286 ^ ((_e286 >> bitcast<u32>(31i)) & 2147483647i)) < (_e292 ^ ((_e292 >> bitcast<u32>(31i)) & 2147483647i))))), vec3<f32>(select(_e248.member_1.x, _e241.member_1.x, ((_e303 ^ ((_e303 >> bitcast<u32>(31i)) & 2147483647i)) > (_e309 ^ ((_e309 >> bitcast<u32>(31i)) & 2147483647i)))), select(_e248.member_1.y, _e241.member_1.y, ((_e319 ^ ((_e319 >> bitcast<u32>(31i)) & 2147483647i)) > (_e325 ^ ((_e325 >> bitcast<u32>(31i)) & 2147483647i)))), select(_e248.member_1.z, _e241.member_1.z, ((_e335 ^ ((_e335 >> bitcast<u32>(31i)) & 2147483647i)) > (_e341 ^ ((_e341 >> bitcast<u32>(31i)) & 2147483647i))))));
                    }
                    workgroupBarrier();
                    phi_226_ = (_e221 / 2u);
                } else {
                    phi_226_ = u32();
                }
                let _e352 = phi_226_;
                continue;
                continuing {
                    phi_222_ = _e234;
                    phi_225_ = _e352;
                    phi_1625_ = _e207;
                    break if !(_e239);
                }
            }
            let _e355 = phi_1625_;
            if _e355 {
                break;
            }
            if (_e51 == 0u) {
                if (_e55 == 0u) {
                } else {
                    if (_e57 == 0u) {
                    } else {
                        if (_e59 == 0u) {
                        } else {
                            let _e361 = global_6[0u];
                            local = _e361;
                            let _e364 = global_1.member[0u];
                            let _e367 = local.member[0u];
                            let _e370 = local.member_1[0u];
                            if (_e367 > _e370) {
                                phi_502_ = type_23(array<type_21, 3>(type_21(0i, 0i, 0u), type_21(0i, 0i, 0u), type_21(0i, 0i, 0u)), 0u);
                            } else {
                                let _e372 = local.member[0u];
                                let _e373 = local.member_1[0u];
                                let _e374 = local.member[0u];
                                let _e375 = local.member_1[0u];
                                let _e377 = (bitcast<u32>(_e374) & 2147483647u);
                                let _e379 = (bitcast<u32>(_e375) & 2147483647u);
                                let _e384 = (bitcast<u32>(bitcast<f32>(select(_e379, _e377, (_e379 < _e377)))) & 2147483647u);
                                if (_e384 >= 8388608u) {
                                    phi_1176_ = (bitcast<i32>((_e384 >> bitcast<u32>(23i))) - 127i);
                                } else {
                                    phi_1176_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e384)), 32u, (_e384 == 0u))));
                                }
                                let _e398 = phi_1176_;
                                let _e399 = (_e398 + -23i);
                                let _e401 = select(_e399, -126i, (_e399 < -126i));
                                let _e406 = bitcast<f32>((bitcast<u32>((127i - _e401)) << bitcast<u32>(23i)));
                                let _e407 = (_e372 * _e406);
                                let _e415 = (2i * select(0i, select(select(i32(_e407), i32(-2147483648), (_e407 < -2147483600f)), 2147483647i, (_e407 > 2147483500f)), (_e407 == _e407)));
                                let _e416 = (_e373 * _e406);
                                let _e426 = bitcast<u32>(((2i * select(0i, select(select(i32(_e416), i32(-2147483648), (_e416 < -2147483600f)), 2147483647i, (_e416 > 2147483500f)), (_e416 == _e416))) - _e415));
                                let _e427 = (_e426 == 0u);
                                if _e427 {
                                    phi_1226_ = 0u;
                                } else {
                                    phi_1226_ = select((bitcast<u32>(31i) - firstLeadingBit(_e426)), 32u, _e427);
                                }
                                let _e433 = phi_1226_;
                                let _e436 = (_e426 << bitcast<u32>((_e433 & 31u)));
                                let _e438 = (_e401 - bitcast<i32>(_e433));
                                let _e442 = local.member[1u];
                                let _e445 = local.member_1[1u];
                                let _e446 = local.member[1u];
                                let _e447 = local.member_1[1u];
                                let _e449 = (bitcast<u32>(_e446) & 2147483647u);
                                let _e451 = (bitcast<u32>(_e447) & 2147483647u);
                                let _e456 = (bitcast<u32>(bitcast<f32>(select(_e451, _e449, (_e451 < _e449)))) & 2147483647u);
                                if (_e456 >= 8388608u) {
                                    phi_1301_ = (bitcast<i32>((_e456 >> bitcast<u32>(23i))) - 127i);
                                } else {
                                    phi_1301_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e456)), 32u, (_e456 == 0u))));
                                }
                                let _e470 = phi_1301_;
                                let _e471 = (_e470 + -23i);
                                let _e473 = select(_e471, -126i, (_e471 < -126i));
                                let _e478 = bitcast<f32>((bitcast<u32>((127i - _e473)) << bitcast<u32>(23i)));
                                let _e479 = (_e442 * _e478);
                                let _e487 = (2i * select(0i, select(select(i32(_e479), i32(-2147483648), (_e479 < -2147483600f)), 2147483647i, (_e479 > 2147483500f)), (_e479 == _e479)));
                                let _e488 = (_e445 * _e478);
                                let _e498 = bitcast<u32>(((2i * select(0i, select(select(i32(_e488), i32(-2147483648), (_e488 < -2147483600f)), 2147483647i, (_e488 > 2147483500f)), (_e488 == _e488))) - _e487));
                                let _e499 = (_e498 == 0u);
                                if _e499 {
                                    phi_1351_ = 0u;
                                } else {
                                    phi_1351_ = select((bitcast<u32>(31i) - firstLeadingBit(_e498)), 32u, _e499);
                                }
                                let _e505 = phi_1351_;
                                let _e508 = (_e498 << bitcast<u32>((_e505 & 31u)));
                                let _e510 = (_e473 - bitcast<i32>(_e505));
                                let _e514 = local.member[2u];
                                let _e517 = local.member_1[2u];
                                let _e518 = local.member[2u];
                                let _e519 = local.member_1[2u];
                                let _e521 = (bitcast<u32>(_e518) & 2147483647u);
                                let _e523 = (bitcast<u32>(_e519) & 2147483647u);
                                let _e528 = (bitcast<u32>(bitcast<f32>(select(_e523, _e521, (_e523 < _e521)))) & 2147483647u);
                                if (_e528 >= 8388608u) {
                                    phi_1426_ = (bitcast<i32>((_e528 >> bitcast<u32>(23i))) - 127i);
                                } else {
                                    phi_1426_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e528)), 32u, (_e528 == 0u))));
                                }
                                let _e542 = phi_1426_;
                                let _e543 = (_e542 + -23i);
                                let _e545 = select(_e543, -126i, (_e543 < -126i));
                                let _e550 = bitcast<f32>((bitcast<u32>((127i - _e545)) << bitcast<u32>(23i)));
                                let _e551 = (_e514 * _e550);
                                let _e559 = (2i * select(0i, select(select(i32(_e551), i32(-2147483648), (_e551 < -2147483600f)), 2147483647i, (_e551 > 2147483500f)), (_e551 == _e551)));
                                let _e560 = (_e517 * _e550);
                                let _e570 = bitcast<u32>(((2i * select(0i, select(select(i32(_e560), i32(-2147483648), (_e560 < -2147483600f)), 2147483647i, (_e560 > 2147483500f)), (_e560 == _e560))) - _e559));
                                let _e571 = (_e570 == 0u);
                                if _e571 {
                                    phi_1476_ = 0u;
                                } else {
                                    phi_1476_ = select((bitcast<u32>(31i) - firstLeadingBit(_e570)), 32u, _e571);
                                }
                                let _e577 = phi_1476_;
                                let _e580 = (_e570 << bitcast<u32>((_e577 & 31u)));
                                let _e582 = (_e545 - bitcast<i32>(_e577));
                                if (_e508 > 0u) {
                                    if (_e436 == 0u) {
                                        phi_1518_ = true;
                                        phi_1519_ = false;
                                        phi_1520_ = false;
                                        phi_1521_ = false;
                                    } else {
                                        let _e586 = (_e510 > _e438);
                                        if _e586 {
                                            phi_1513_ = false;
                                            phi_1514_ = false;
                                            phi_1515_ = false;
                                        } else {
                                            let _e587 = (_e510 == _e438);
                                            if _e587 {
                                                let _e588 = (_e508 > _e436);
                                                phi_1508_ = _e588;
                                                phi_1510_ = select(true, false, _e588);
                                            } else {
                                                phi_1508_ = false;
                                                phi_1510_ = false;
                                            }
                                            let _e591 = phi_1508_;
                                            let _e593 = phi_1510_;
                                            phi_1513_ = _e591;
                                            phi_1514_ = select(true, false, _e587);
                                            phi_1515_ = _e593;
                                        }
                                        let _e596 = phi_1513_;
                                        let _e598 = phi_1514_;
                                        let _e600 = phi_1515_;
                                        phi_1518_ = _e586;
                                        phi_1519_ = _e596;
                                        phi_1520_ = _e598;
                                        phi_1521_ = _e600;
                                    }
                                    let _e602 = phi_1518_;
                                    let _e604 = phi_1519_;
                                    let _e606 = phi_1520_;
                                    let _e608 = phi_1521_;
                                    let _e609 = select(_e604, true, _e602);
                                    phi_1534_ = select(select(_e606, false, _e602), false, _e609);
                                    phi_1535_ = select(select(_e608, false, _e602), false, _e609);
                                } else {
                                    phi_1534_ = true;
                                    phi_1535_ = false;
                                }
                                let _e615 = phi_1534_;
                                let _e617 = phi_1535_;
                                if select(_e617, true, _e615) {
                                    phi_1543_ = type_33(_e401, _e415, _e436, _e433, _e438);
                                } else {
                                    phi_1543_ = type_33(_e473, _e487, _e508, _e505, _e510);
                                }
                                let _e620 = phi_1543_;
                                if (_e580 > 0u) {
                                    if (_e620.member_2 == 0u) {
                                        phi_1580_ = true;
                                        phi_1581_ = false;
                                        phi_1582_ = false;
                                        phi_1583_ = false;
                                    } else {
                                        let _e625 = (_e582 > _e620.member_4);
                                        if _e625 {
                                            phi_1575_ = false;
                                            phi_1576_ = false;
                                            phi_1577_ = false;
                                        } else {
                                            let _e626 = (_e582 == _e620.member_4);
                                            if _e626 {
                                                let _e627 = (_e580 > _e620.member_2);
                                                phi_1570_ = _e627;
                                                phi_1572_ = select(true, false, _e627);
                                            } else {
                                                phi_1570_ = false;
                                                phi_1572_ = false;
                                            }
                                            let _e630 = phi_1570_;
                                            let _e632 = phi_1572_;
                                            phi_1575_ = _e630;
                                            phi_1576_ = select(true, false, _e626);
                                            phi_1577_ = _e632;
                                        }
                                        let _e635 = phi_1575_;
                                        let _e637 = phi_1576_;
                                        let _e639 = phi_1577_;
                                        phi_1580_ = _e625;
                                        phi_1581_ = _e635;
                                        phi_1582_ = _e637;
                                        phi_1583_ = _e639;
                                    }
                                    let _e641 = phi_1580_;
                                    let _e643 = phi_1581_;
                                    let _e645 = phi_1582_;
                                    let _e647 = phi_1583_;
                                    let _e648 = select(_e643, true, _e641);
                                    phi_1596_ = select(select(_e645, false, _e641), false, _e648);
                                    phi_1597_ = select(select(_e647, false, _e641), false, _e648);
                                } else {
                                    phi_1596_ = true;
                                    phi_1597_ = false;
                                }
                                let _e654 = phi_1596_;
                                let _e656 = phi_1597_;
                                if select(_e656, true, _e654) {
                                    phi_1605_ = _e620;
                                } else {
                                    phi_1605_ = type_33(_e545, _e559, _e580, _e577, _e582);
                                }
                                let _e659 = phi_1605_;
                                let _e663 = bitcast<i32>(_e364);
                                let _e664 = (((_e659.member_4 - _e438) + 31i) - _e663);
                                if (_e436 == 0u) {
                                    phi_367_ = u32();
                                    phi_368_ = true;
                                } else {
                                    let _e666 = (_e664 > 31i);
                                    if _e666 {
                                        phi_366_ = u32();
                                    } else {
                                        phi_366_ = bitcast<u32>(_e664);
                                    }
                                    let _e669 = phi_366_;
                                    phi_367_ = _e669;
                                    phi_368_ = _e666;
                                }
                                let _e671 = phi_367_;
                                let _e673 = phi_368_;
                                let _e681 = (((_e659.member_4 - _e510) + 31i) - _e663);
                                if (_e508 == 0u) {
                                    phi_396_ = u32();
                                    phi_397_ = true;
                                } else {
                                    let _e683 = (_e681 > 31i);
                                    if _e683 {
                                        phi_395_ = u32();
                                    } else {
                                        phi_395_ = bitcast<u32>(_e681);
                                    }
                                    let _e686 = phi_395_;
                                    phi_396_ = _e686;
                                    phi_397_ = _e683;
                                }
                                let _e688 = phi_396_;
                                let _e690 = phi_397_;
                                let _e698 = (((_e659.member_4 - _e582) + 31i) - _e663);
                                if (_e580 == 0u) {
                                    phi_425_ = u32();
                                    phi_426_ = true;
                                } else {
                                    let _e700 = (_e698 > 31i);
                                    if _e700 {
                                        phi_424_ = u32();
                                    } else {
                                        phi_424_ = bitcast<u32>(_e698);
                                    }
                                    let _e703 = phi_424_;
                                    phi_425_ = _e703;
                                    phi_426_ = _e700;
                                }
                                let _e705 = phi_425_;
                                let _e707 = phi_426_;
                                if (_e659.member_2 == 0u) {
                                    phi_500_ = 0u;
                                } else {
                                    phi_445_ = type_6(0u, 63u);
                                    phi_448_ = 0u;
                                    phi_450_ = 0u;
                                    loop {
                                        let _e717 = phi_445_;
                                        let _e719 = phi_448_;
                                        let _e721 = phi_450_;
                                        local_3 = _e721;
                                        if (_e717.member < _e717.member_1) {
                                            phi_446_ = type_6((_e717.member + 1u), _e717.member_1);
                                            phi_473_ = type_6(1u, _e717.member);
                                        } else {
                                            phi_446_ = _e717;
                                            phi_473_ = type_6(0u, type_6().member_1);
                                        }
                                        let _e734 = phi_446_;
                                        let _e736 = phi_473_;
                                        let _e739 = (bitcast<i32>(_e736.member) != 0i);
                                        if _e739 {
                                            let _e744 = ((_e719 << bitcast<u32>(1i)) | 1u);
                                            let _e746 = (_e721 << bitcast<u32>(1i));
                                            if ((_e719 >> bitcast<u32>(31i)) == 1u) {
                                                phi_492_ = true;
                                            } else {
                                                phi_492_ = (_e744 >= _e659.member_2);
                                            }
                                            let _e750 = phi_492_;
                                            if _e750 {
                                                phi_498_ = (_e744 - _e659.member_2);
                                                phi_499_ = (_e746 | 1u);
                                            } else {
                                                phi_498_ = _e744;
                                                phi_499_ = _e746;
                                            }
                                            let _e754 = phi_498_;
                                            let _e756 = phi_499_;
                                            phi_449_ = _e754;
                                            phi_451_ = _e756;
                                        } else {
                                            phi_449_ = u32();
                                            phi_451_ = u32();
                                        }
                                        let _e758 = phi_449_;
                                        let _e760 = phi_451_;
                                        continue;
                                        continuing {
                                            phi_445_ = _e734;
                                            phi_448_ = _e758;
                                            phi_450_ = _e760;
                                            break if !(_e739);
                                        }
                                    }
                                    let _e916 = local_3;
                                    phi_500_ = _e916;
                                }
                                let _e763 = phi_500_;
                                phi_502_ = type_23(array<type_21, 3>(type_21(_e401, _e415, (_e433 | (select(_e671, 31u, _e673) << bitcast<u32>(16i)))), type_21(_e473, _e487, (_e505 | (select(_e688, 31u, _e690) << bitcast<u32>(16i)))), type_21(_e545, _e559, (_e577 | (select(_e705, 31u, _e707) << bitcast<u32>(16i))))), _e763);
                            }
                            let _e766 = phi_502_;
                            if (0u < _e55) {
                            } else {
                                break;
                            }
                            global_3.member[0u] = _e766;
                            let _e770 = local.member[0u];
                            let _e771 = local.member_1[0u];
                            if (_e770 > _e771) {
                                phi_641_ = 0i;
                            } else {
                                let _e773 = local.member[0u];
                                let _e774 = local.member_1[0u];
                                let _e776 = (bitcast<u32>(_e773) & 2147483647u);
                                let _e778 = (bitcast<u32>(_e774) & 2147483647u);
                                let _e780 = select(_e778, _e776, (_e778 < _e776));
                                let _e783 = local.member[1u];
                                let _e786 = local.member_1[1u];
                                let _e788 = (bitcast<u32>(_e783) & 2147483647u);
                                let _e790 = (bitcast<u32>(_e786) & 2147483647u);
                                let _e792 = select(_e790, _e788, (_e790 < _e788));
                                let _e794 = select(_e792, _e780, (_e792 < _e780));
                                let _e797 = local.member[2u];
                                let _e800 = local.member_1[2u];
                                let _e802 = (bitcast<u32>(_e797) & 2147483647u);
                                let _e804 = (bitcast<u32>(_e800) & 2147483647u);
                                let _e806 = select(_e804, _e802, (_e804 < _e802));
                                let _e808 = select(_e806, _e794, (_e806 < _e794));
                                if (_e808 > 0u) {
                                    let _e812 = (bitcast<u32>(bitcast<f32>(_e808)) & 2147483647u);
                                    if (_e812 >= 8388608u) {
                                        phi_637_ = (bitcast<i32>((_e812 >> bitcast<u32>(23i))) - 127i);
                                    } else {
                                        phi_637_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e812)), 32u, (_e812 == 0u))));
                                    }
                                    let _e826 = phi_637_;
                                    phi_640_ = (-1i - _e826);
                                } else {
                                    phi_640_ = 0i;
                                }
                                let _e829 = phi_640_;
                                phi_641_ = _e829;
                            }
                            let _e831 = phi_641_;
                            if (0u < _e57) {
                            } else {
                                break;
                            }
                            global_4.member[0u] = bitcast<u32>(_e831);
                            let _e836 = local;
                            if (0u < _e59) {
                            } else {
                                break;
                            }
                            global_5.member[0u] = array<f32, 6>(_e836.member.x, _e836.member.y, _e836.member.z, _e836.member_1.x, _e836.member_1.y, _e836.member_1.z);
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
