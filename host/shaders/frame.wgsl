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
    var phi_136_: u32;
    var phi_139_: type_6;
    var phi_142_: type_15;
    var phi_140_: type_6;
    var phi_165_: type_6;
    var phi_233_: type_15;
    var phi_143_: type_15;
    var phi_1546_: bool;
    var local_1: type_15;
    var local_2: type_15;
    var phi_246_: type_6;
    var phi_249_: u32;
    var phi_247_: type_6;
    var phi_272_: type_6;
    var phi_250_: u32;
    var phi_1558_: bool;
    var phi_1075_: i32;
    var phi_1125_: u32;
    var phi_1217_: i32;
    var phi_1267_: u32;
    var phi_1359_: i32;
    var phi_1409_: u32;
    var phi_1441_: bool;
    var phi_1443_: bool;
    var phi_1446_: bool;
    var phi_1447_: bool;
    var phi_1448_: bool;
    var phi_1451_: bool;
    var phi_1452_: bool;
    var phi_1453_: bool;
    var phi_1454_: bool;
    var phi_1467_: bool;
    var phi_1468_: bool;
    var phi_1476_: type_33;
    var phi_1503_: bool;
    var phi_1505_: bool;
    var phi_1508_: bool;
    var phi_1509_: bool;
    var phi_1510_: bool;
    var phi_1513_: bool;
    var phi_1514_: bool;
    var phi_1515_: bool;
    var phi_1516_: bool;
    var phi_1529_: bool;
    var phi_1530_: bool;
    var phi_1538_: type_33;
    var phi_418_: u32;
    var phi_419_: u32;
    var phi_420_: bool;
    var phi_447_: u32;
    var phi_448_: u32;
    var phi_449_: bool;
    var phi_476_: u32;
    var phi_477_: u32;
    var phi_478_: bool;
    var phi_497_: type_6;
    var phi_500_: u32;
    var phi_502_: u32;
    var phi_498_: type_6;
    var phi_525_: type_6;
    var phi_544_: bool;
    var phi_550_: u32;
    var phi_551_: u32;
    var phi_501_: u32;
    var phi_503_: u32;
    var phi_552_: u32;
    var phi_554_: type_23;
    var phi_742_: i32;
    var phi_745_: i32;
    var phi_746_: i32;
    var local_3: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e52 = global;
            let _e54 = arrayLength((&global_2.member));
            let _e56 = arrayLength((&global_3.member));
            let _e58 = arrayLength((&global_4.member));
            let _e60 = arrayLength((&global_5.member));
            let _e61 = (_e54 / 64u);
            if ((_e54 % 64u) > 0u) {
                phi_136_ = (_e61 + 1u);
            } else {
                phi_136_ = _e61;
            }
            let _e66 = phi_136_;
            phi_139_ = type_6(0u, _e66);
            phi_142_ = type_15(vec3<f32>(340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f), vec3<f32>(-340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f));
            loop {
                let _e69 = phi_139_;
                let _e71 = phi_142_;
                local_1 = _e71;
                local_2 = _e71;
                if (_e69.member < _e69.member_1) {
                    phi_140_ = type_6((_e69.member + 1u), _e69.member_1);
                    phi_165_ = type_6(1u, _e69.member);
                } else {
                    phi_140_ = _e69;
                    phi_165_ = type_6(0u, type_6().member_1);
                }
                let _e84 = phi_140_;
                let _e86 = phi_165_;
                let _e90 = (bitcast<i32>(_e86.member) != 0i);
                if _e90 {
                    let _e92 = ((_e86.member_1 * 64u) + _e52);
                    let _e93 = (_e92 < _e54);
                    if _e93 {
                        if _e93 {
                        } else {
                            phi_1546_ = true;
                            break;
                        }
                        let _e96 = global_2.member[_e92];
                        phi_233_ = type_15(vec3<f32>(select(_e96[0], _e71.member.x, (_e71.member.x < _e96[0])), select(_e96[1], _e71.member.y, (_e71.member.y < _e96[1])), select(_e96[2], _e71.member.z, (_e71.member.z < _e96[2]))), vec3<f32>(select(_e96[3], _e71.member_1.x, (_e71.member_1.x > _e96[3])), select(_e96[4], _e71.member_1.y, (_e71.member_1.y > _e96[4])), select(_e96[5], _e71.member_1.z, (_e71.member_1.z > _e96[5]))));
                    } else {
                        phi_233_ = _e71;
                    }
                    let _e127 = phi_233_;
                    phi_143_ = _e127;
                } else {
                    phi_143_ = type_15();
                }
                let _e129 = phi_143_;
                continue;
                continuing {
                    phi_139_ = _e84;
                    phi_142_ = _e129;
                    phi_1546_ = false;
                    break if !(_e90);
                }
            }
            let _e132 = phi_1546_;
            if _e132 {
                break;
            }
            let _e133 = (_e52 % 64u);
            let _e134 = (_e133 < 64u);
            if _e134 {
            } else {
                break;
            }
            let _e137 = local_1;
            let _e140 = local_2;
            global_6[_e133] = type_27(_e137.member, _e140.member_1);
            workgroupBarrier();
            phi_246_ = type_6(0u, 6u);
            phi_249_ = 32u;
            loop {
                let _e144 = phi_246_;
                let _e146 = phi_249_;
                if (_e144.member < _e144.member_1) {
                    phi_247_ = type_6((_e144.member + 1u), _e144.member_1);
                    phi_272_ = type_6(1u, _e144.member);
                } else {
                    phi_247_ = _e144;
                    phi_272_ = type_6(0u, type_6().member_1);
                }
                let _e159 = phi_247_;
                let _e161 = phi_272_;
                let _e164 = (bitcast<i32>(_e161.member) != 0i);
                if _e164 {
                    if (_e52 < _e146) {
                        if _e134 {
                        } else {
                            phi_1558_ = true;
                            break;
                        }
                        let _e166 = global_6[_e133];
                        let _e170 = ((_e52 + _e146) % 64u);
                        if (_e170 < 64u) {
                        } else {
                            phi_1558_ = true;
                            break;
                        }
                        let _e173 = global_6[_e170];
                        if _e134 {
                        } else {
                            phi_1558_ = true;
                            break;
                        }
                        global_6[_e133] = type_27(vec3<f32>(select(_e173.member.x, _e166.member.x, (_e166.member.x < _e173.member.x)), select(_e173.member.y, _e166.member.y, (_e166.member.y < _e173.member.y)), select(_e173.member.z, _e166.member.z, (_e166.member.z < _e173.member.z))), vec3<f32>(select(_e173.member_1.x, _e166.member_1.x, (_e166.member_1.x > _e173.member_1.x)), select(_e173.member_1.y, _e166.member_1.y, (_e166.member_1.y > _e173.member_1.y)), select(_e173.member_1.z, _e166.member_1.z, (_e166.member_1.z > _e173.member_1.z))));
                    }
                    workgroupBarrier();
                    phi_250_ = (_e146 / 2u);
                } else {
                    phi_250_ = u32();
                }
                let _e205 = phi_250_;
                continue;
                continuing {
                    phi_246_ = _e159;
                    phi_249_ = _e205;
                    phi_1558_ = _e132;
                    break if !(_e164);
                }
            }
            let _e208 = phi_1558_;
            if _e208 {
                break;
            }
            if (_e52 == 0u) {
                if (_e56 == 0u) {
                } else {
                    if (_e58 == 0u) {
                    } else {
                        if (_e60 == 0u) {
                        } else {
                            let _e214 = global_6[0u];
                            local = _e214;
                            let _e217 = global_1.member[0u];
                            let _e220 = local.member[0u];
                            let _e223 = local.member_1[0u];
                            if (_e220 > _e223) {
                                phi_554_ = type_23(array<type_21, 3>(type_21(0i, 0i, 0u), type_21(0i, 0i, 0u), type_21(0i, 0i, 0u)), 0u);
                            } else {
                                let _e225 = local.member[0u];
                                let _e226 = local.member_1[0u];
                                let _e227 = local.member[0u];
                                let _e228 = local.member_1[0u];
                                let _e231 = bitcast<f32>((bitcast<u32>(_e227) & 2147483647u));
                                let _e234 = bitcast<f32>((bitcast<u32>(_e228) & 2147483647u));
                                let _e236 = select(_e234, _e231, (_e231 > _e234));
                                let _e238 = select(_e234, _e231, (_e231 < _e234));
                                let _e242 = (bitcast<u32>(select(_e238, _e236, (_e236 > _e238))) & 2147483647u);
                                if (_e242 >= 8388608u) {
                                    phi_1075_ = (bitcast<i32>((_e242 >> bitcast<u32>(23i))) - 127i);
                                } else {
                                    phi_1075_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e242)), 32u, (_e242 == 0u))));
                                }
                                let _e256 = phi_1075_;
                                let _e257 = (_e256 + -23i);
                                let _e259 = select(_e257, -126i, (_e257 < -126i));
                                let _e264 = bitcast<f32>((bitcast<u32>((127i - _e259)) << bitcast<u32>(23i)));
                                let _e265 = (_e225 * _e264);
                                let _e273 = (2i * select(0i, select(select(i32(_e265), i32(-2147483648), (_e265 < -2147483600f)), 2147483647i, (_e265 > 2147483500f)), (_e265 == _e265)));
                                let _e274 = (_e226 * _e264);
                                let _e284 = bitcast<u32>(((2i * select(0i, select(select(i32(_e274), i32(-2147483648), (_e274 < -2147483600f)), 2147483647i, (_e274 > 2147483500f)), (_e274 == _e274))) - _e273));
                                let _e285 = (_e284 == 0u);
                                if _e285 {
                                    phi_1125_ = 0u;
                                } else {
                                    phi_1125_ = select((bitcast<u32>(31i) - firstLeadingBit(_e284)), 32u, _e285);
                                }
                                let _e291 = phi_1125_;
                                let _e294 = (_e284 << bitcast<u32>((_e291 & 31u)));
                                let _e296 = (_e259 - bitcast<i32>(_e291));
                                let _e300 = local.member[1u];
                                let _e303 = local.member_1[1u];
                                let _e304 = local.member[1u];
                                let _e305 = local.member_1[1u];
                                let _e308 = bitcast<f32>((bitcast<u32>(_e304) & 2147483647u));
                                let _e311 = bitcast<f32>((bitcast<u32>(_e305) & 2147483647u));
                                let _e313 = select(_e311, _e308, (_e308 > _e311));
                                let _e315 = select(_e311, _e308, (_e308 < _e311));
                                let _e319 = (bitcast<u32>(select(_e315, _e313, (_e313 > _e315))) & 2147483647u);
                                if (_e319 >= 8388608u) {
                                    phi_1217_ = (bitcast<i32>((_e319 >> bitcast<u32>(23i))) - 127i);
                                } else {
                                    phi_1217_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e319)), 32u, (_e319 == 0u))));
                                }
                                let _e333 = phi_1217_;
                                let _e334 = (_e333 + -23i);
                                let _e336 = select(_e334, -126i, (_e334 < -126i));
                                let _e341 = bitcast<f32>((bitcast<u32>((127i - _e336)) << bitcast<u32>(23i)));
                                let _e342 = (_e300 * _e341);
                                let _e350 = (2i * select(0i, select(select(i32(_e342), i32(-2147483648), (_e342 < -2147483600f)), 2147483647i, (_e342 > 2147483500f)), (_e342 == _e342)));
                                let _e351 = (_e303 * _e341);
                                let _e361 = bitcast<u32>(((2i * select(0i, select(select(i32(_e351), i32(-2147483648), (_e351 < -2147483600f)), 2147483647i, (_e351 > 2147483500f)), (_e351 == _e351))) - _e350));
                                let _e362 = (_e361 == 0u);
                                if _e362 {
                                    phi_1267_ = 0u;
                                } else {
                                    phi_1267_ = select((bitcast<u32>(31i) - firstLeadingBit(_e361)), 32u, _e362);
                                }
                                let _e368 = phi_1267_;
                                let _e371 = (_e361 << bitcast<u32>((_e368 & 31u)));
                                let _e373 = (_e336 - bitcast<i32>(_e368));
                                let _e377 = local.member[2u];
                                let _e380 = local.member_1[2u];
                                let _e381 = local.member[2u];
                                let _e382 = local.member_1[2u];
                                let _e385 = bitcast<f32>((bitcast<u32>(_e381) & 2147483647u));
                                let _e388 = bitcast<f32>((bitcast<u32>(_e382) & 2147483647u));
                                let _e390 = select(_e388, _e385, (_e385 > _e388));
                                let _e392 = select(_e388, _e385, (_e385 < _e388));
                                let _e396 = (bitcast<u32>(select(_e392, _e390, (_e390 > _e392))) & 2147483647u);
                                if (_e396 >= 8388608u) {
                                    phi_1359_ = (bitcast<i32>((_e396 >> bitcast<u32>(23i))) - 127i);
                                } else {
                                    phi_1359_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e396)), 32u, (_e396 == 0u))));
                                }
                                let _e410 = phi_1359_;
                                let _e411 = (_e410 + -23i);
                                let _e413 = select(_e411, -126i, (_e411 < -126i));
                                let _e418 = bitcast<f32>((bitcast<u32>((127i - _e413)) << bitcast<u32>(23i)));
                                let _e419 = (_e377 * _e418);
                                let _e427 = (2i * select(0i, select(select(i32(_e419), i32(-2147483648), (_e419 < -2147483600f)), 2147483647i, (_e419 > 2147483500f)), (_e419 == _e419)));
                                let _e428 = (_e380 * _e418);
                                let _e438 = bitcast<u32>(((2i * select(0i, select(select(i32(_e428), i32(-2147483648), (_e428 < -2147483600f)), 2147483647i, (_e428 > 2147483500f)), (_e428 == _e428))) - _e427));
                                let _e439 = (_e438 == 0u);
                                if _e439 {
                                    phi_1409_ = 0u;
                                } else {
                                    phi_1409_ = select((bitcast<u32>(31i) - firstLeadingBit(_e438)), 32u, _e439);
                                }
                                let _e445 = phi_1409_;
                                let _e448 = (_e438 << bitcast<u32>((_e445 & 31u)));
                                let _e450 = (_e413 - bitcast<i32>(_e445));
                                if (_e371 > 0u) {
                                    if (_e294 == 0u) {
                                        phi_1451_ = true;
                                        phi_1452_ = false;
                                        phi_1453_ = false;
                                        phi_1454_ = false;
                                    } else {
                                        let _e454 = (_e373 > _e296);
                                        if _e454 {
                                            phi_1446_ = false;
                                            phi_1447_ = false;
                                            phi_1448_ = false;
                                        } else {
                                            let _e455 = (_e373 == _e296);
                                            if _e455 {
                                                let _e456 = (_e371 > _e294);
                                                phi_1441_ = _e456;
                                                phi_1443_ = select(true, false, _e456);
                                            } else {
                                                phi_1441_ = false;
                                                phi_1443_ = false;
                                            }
                                            let _e459 = phi_1441_;
                                            let _e461 = phi_1443_;
                                            phi_1446_ = _e459;
                                            phi_1447_ = select(true, false, _e455);
                                            phi_1448_ = _e461;
                                        }
                                        let _e464 = phi_1446_;
                                        let _e466 = phi_1447_;
                                        let _e468 = phi_1448_;
                                        phi_1451_ = _e454;
                                        phi_1452_ = _e464;
                                        phi_1453_ = _e466;
                                        phi_1454_ = _e468;
                                    }
                                    let _e470 = phi_1451_;
                                    let _e472 = phi_1452_;
                                    let _e474 = phi_1453_;
                                    let _e476 = phi_1454_;
                                    let _e477 = select(_e472, true, _e470);
                                    phi_1467_ = select(select(_e474, false, _e470), false, _e477);
                                    phi_1468_ = select(select(_e476, false, _e470), false, _e477);
                                } else {
                                    phi_1467_ = true;
                                    phi_1468_ = false;
                                }
                                let _e483 = phi_1467_;
                                let _e485 = phi_1468_;
                                if select(_e485, true, _e483) {
                                    phi_1476_ = type_33(_e259, _e273, _e294, _e291, _e296);
                                } else {
                                    phi_1476_ = type_33(_e336, _e350, _e371, _e368, _e373);
                                }
                                let _e488 = phi_1476_;
                                if (_e448 > 0u) {
                                    if (_e488.member_2 == 0u) {
                                        phi_1513_ = true;
                                        phi_1514_ = false;
                                        phi_1515_ = false;
                                        phi_1516_ = false;
                                    } else {
                                        let _e493 = (_e450 > _e488.member_4);
                                        if _e493 {
                                            phi_1508_ = false;
                                            phi_1509_ = false;
                                            phi_1510_ = false;
                                        } else {
                                            let _e494 = (_e450 == _e488.member_4);
                                            if _e494 {
                                                let _e495 = (_e448 > _e488.member_2);
                                                phi_1503_ = _e495;
                                                phi_1505_ = select(true, false, _e495);
                                            } else {
                                                phi_1503_ = false;
                                                phi_1505_ = false;
                                            }
                                            let _e498 = phi_1503_;
                                            let _e500 = phi_1505_;
                                            phi_1508_ = _e498;
                                            phi_1509_ = select(true, false, _e494);
                                            phi_1510_ = _e500;
                                        }
                                        let _e503 = phi_1508_;
                                        let _e505 = phi_1509_;
                                        let _e507 = phi_1510_;
                                        phi_1513_ = _e493;
                                        phi_1514_ = _e503;
                                        phi_1515_ = _e505;
                                        phi_1516_ = _e507;
                                    }
                                    let _e509 = phi_1513_;
                                    let _e511 = phi_1514_;
                                    let _e513 = phi_1515_;
                                    let _e515 = phi_1516_;
                                    let _e516 = select(_e511, true, _e509);
                                    phi_1529_ = select(select(_e513, false, _e509), false, _e516);
                                    phi_1530_ = select(select(_e515, false, _e509), false, _e516);
                                } else {
                                    phi_1529_ = true;
                                    phi_1530_ = false;
                                }
                                let _e522 = phi_1529_;
                                let _e524 = phi_1530_;
                                if select(_e524, true, _e522) {
                                    phi_1538_ = _e488;
                                } else {
                                    phi_1538_ = type_33(_e413, _e427, _e448, _e445, _e450);
                                }
                                let _e527 = phi_1538_;
                                let _e531 = bitcast<i32>(_e217);
                                let _e532 = (((_e527.member_4 - _e296) + 31i) - _e531);
                                if (_e294 == 0u) {
                                    phi_419_ = u32();
                                    phi_420_ = true;
                                } else {
                                    let _e534 = (_e532 > 31i);
                                    if _e534 {
                                        phi_418_ = u32();
                                    } else {
                                        phi_418_ = bitcast<u32>(_e532);
                                    }
                                    let _e537 = phi_418_;
                                    phi_419_ = _e537;
                                    phi_420_ = _e534;
                                }
                                let _e539 = phi_419_;
                                let _e541 = phi_420_;
                                let _e549 = (((_e527.member_4 - _e373) + 31i) - _e531);
                                if (_e371 == 0u) {
                                    phi_448_ = u32();
                                    phi_449_ = true;
                                } else {
                                    let _e551 = (_e549 > 31i);
                                    if _e551 {
                                        phi_447_ = u32();
                                    } else {
                                        phi_447_ = bitcast<u32>(_e549);
                                    }
                                    let _e554 = phi_447_;
                                    phi_448_ = _e554;
                                    phi_449_ = _e551;
                                }
                                let _e556 = phi_448_;
                                let _e558 = phi_449_;
                                let _e566 = (((_e527.member_4 - _e450) + 31i) - _e531);
                                if (_e448 == 0u) {
                                    phi_477_ = u32();
                                    phi_478_ = true;
                                } else {
                                    let _e568 = (_e566 > 31i);
                                    if _e568 {
                                        phi_476_ = u32();
                                    } else {
                                        phi_476_ = bitcast<u32>(_e566);
                                    }
                                    let _e571 = phi_476_;
                                    phi_477_ = _e571;
                                    phi_478_ = _e568;
                                }
                                let _e573 = phi_477_;
                                let _e575 = phi_478_;
                                if (_e527.member_2 == 0u) {
                                    phi_552_ = 0u;
                                } else {
                                    phi_497_ = type_6(0u, 63u);
                                    phi_500_ = 0u;
                                    phi_502_ = 0u;
                                    loop {
                                        let _e585 = phi_497_;
                                        let _e587 = phi_500_;
                                        let _e589 = phi_502_;
                                        local_3 = _e589;
                                        if (_e585.member < _e585.member_1) {
                                            phi_498_ = type_6((_e585.member + 1u), _e585.member_1);
                                            phi_525_ = type_6(1u, _e585.member);
                                        } else {
                                            phi_498_ = _e585;
                                            phi_525_ = type_6(0u, type_6().member_1);
                                        }
                                        let _e602 = phi_498_;
                                        let _e604 = phi_525_;
                                        let _e607 = (bitcast<i32>(_e604.member) != 0i);
                                        if _e607 {
                                            let _e612 = ((_e587 << bitcast<u32>(1i)) | 1u);
                                            let _e614 = (_e589 << bitcast<u32>(1i));
                                            if ((_e587 >> bitcast<u32>(31i)) == 1u) {
                                                phi_544_ = true;
                                            } else {
                                                phi_544_ = (_e612 >= _e527.member_2);
                                            }
                                            let _e618 = phi_544_;
                                            if _e618 {
                                                phi_550_ = (_e612 - _e527.member_2);
                                                phi_551_ = (_e614 | 1u);
                                            } else {
                                                phi_550_ = _e612;
                                                phi_551_ = _e614;
                                            }
                                            let _e622 = phi_550_;
                                            let _e624 = phi_551_;
                                            phi_501_ = _e622;
                                            phi_503_ = _e624;
                                        } else {
                                            phi_501_ = u32();
                                            phi_503_ = u32();
                                        }
                                        let _e626 = phi_501_;
                                        let _e628 = phi_503_;
                                        continue;
                                        continuing {
                                            phi_497_ = _e602;
                                            phi_500_ = _e626;
                                            phi_502_ = _e628;
                                            break if !(_e607);
                                        }
                                    }
                                    let _e801 = local_3;
                                    phi_552_ = _e801;
                                }
                                let _e631 = phi_552_;
                                phi_554_ = type_23(array<type_21, 3>(type_21(_e259, _e273, (_e291 | (select(_e539, 31u, _e541) << bitcast<u32>(16i)))), type_21(_e336, _e350, (_e368 | (select(_e556, 31u, _e558) << bitcast<u32>(16i)))), type_21(_e413, _e427, (_e445 | (select(_e573, 31u, _e575) << bitcast<u32>(16i))))), _e631);
                            }
                            let _e634 = phi_554_;
                            if (0u < _e56) {
                            } else {
                                break;
                            }
                            global_3.member[0u] = _e634;
                            let _e638 = local.member[0u];
                            let _e639 = local.member_1[0u];
                            if (_e638 > _e639) {
                                phi_746_ = 0i;
                            } else {
                                let _e641 = local.member[0u];
                                let _e642 = local.member_1[0u];
                                let _e645 = bitcast<f32>((bitcast<u32>(_e641) & 2147483647u));
                                let _e648 = bitcast<f32>((bitcast<u32>(_e642) & 2147483647u));
                                let _e650 = select(_e648, _e645, (_e645 > _e648));
                                let _e652 = select(_e648, _e645, (_e645 < _e648));
                                let _e654 = select(_e652, _e650, (_e650 > _e652));
                                let _e657 = local.member[1u];
                                let _e660 = local.member_1[1u];
                                let _e663 = bitcast<f32>((bitcast<u32>(_e657) & 2147483647u));
                                let _e666 = bitcast<f32>((bitcast<u32>(_e660) & 2147483647u));
                                let _e668 = select(_e666, _e663, (_e663 > _e666));
                                let _e670 = select(_e666, _e663, (_e663 < _e666));
                                let _e672 = select(_e670, _e668, (_e668 > _e670));
                                let _e674 = select(_e672, _e654, (_e654 > _e672));
                                let _e677 = local.member[2u];
                                let _e680 = local.member_1[2u];
                                let _e683 = bitcast<f32>((bitcast<u32>(_e677) & 2147483647u));
                                let _e686 = bitcast<f32>((bitcast<u32>(_e680) & 2147483647u));
                                let _e688 = select(_e686, _e683, (_e683 > _e686));
                                let _e690 = select(_e686, _e683, (_e683 < _e686));
                                let _e692 = select(_e690, _e688, (_e688 > _e690));
                                let _e694 = select(_e692, _e674, (_e674 > _e692));
                                if (_e694 > 0f) {
                                    let _e697 = (bitcast<u32>(_e694) & 2147483647u);
                                    if (_e697 >= 8388608u) {
                                        phi_742_ = (bitcast<i32>((_e697 >> bitcast<u32>(23i))) - 127i);
                                    } else {
                                        phi_742_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e697)), 32u, (_e697 == 0u))));
                                    }
                                    let _e711 = phi_742_;
                                    phi_745_ = (-1i - _e711);
                                } else {
                                    phi_745_ = 0i;
                                }
                                let _e714 = phi_745_;
                                phi_746_ = _e714;
                            }
                            let _e716 = phi_746_;
                            if (0u < _e58) {
                            } else {
                                break;
                            }
                            global_4.member[0u] = bitcast<u32>(_e716);
                            let _e721 = local;
                            if (0u < _e60) {
                            } else {
                                break;
                            }
                            global_5.member[0u] = array<f32, 6>(_e721.member.x, _e721.member.y, _e721.member.z, _e721.member_1.x, _e721.member_1.y, _e721.member_1.z);
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
