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

struct type_21 {
    member: array<array<i32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_23 {
    member: array<type_21>,
}

struct type_26 {
    member: array<u32, 4>,
    member_1: array<u32, 4>,
}

struct type_28 {
    member: array<type_26>,
}

struct type_32 {
    member: array<i32, 3>,
    member_1: array<i32, 3>,
}

struct type_36 {
    member: array<i32, 3>,
    member_1: u32,
}

struct type_38 {
    member: array<type_36>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_16;
@group(0) @binding(2) 
var<uniform> global_3: type_16;
@group(0) @binding(3) 
var<storage> global_4: type_23;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_13;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_38;
@group(0) @binding(6) 
var<storage, read_write> global_7: type_4;
@group(0) @binding(7) 
var<storage, read_write> global_8: type_28;

fn function_() {
    var phi_164_: i32;
    var phi_165_: i32;
    var phi_207_: type_21;
    var phi_259_: type_8;
    var phi_262_: type_32;
    var phi_264_: u32;
    var phi_260_: type_8;
    var phi_287_: type_8;
    var phi_309_: type_21;
    var phi_318_: bool;
    var phi_362_: i32;
    var phi_377_: i32;
    var phi_414_: i32;
    var phi_429_: i32;
    var phi_466_: i32;
    var phi_481_: i32;
    var phi_490_: type_32;
    var phi_491_: u32;
    var phi_263_: type_32;
    var phi_265_: u32;
    var phi_493_: bool;
    var phi_1445_: bool;
    var local: type_32;
    var local_1: type_32;
    var phi_1146_: u32;
    var phi_1152_: u32;
    var phi_1163_: u32;
    var phi_1166_: type_8;
    var phi_1167_: type_8;
    var phi_1190_: type_8;
    var phi_1478_: bool;
    var phi_1297_: u32;
    var phi_1303_: u32;
    var phi_1314_: u32;
    var phi_1317_: type_8;
    var phi_1318_: type_8;
    var phi_1341_: type_8;
    var phi_1533_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e40 = global;
            let _e42 = arrayLength((&global_4.member));
            let _e47 = arrayLength((&global_6.member));
            let _e50 = arrayLength((&global_7.member));
            let _e53 = arrayLength((&global_8.member));
            let _e56 = global_3.member[1u];
            if (_e56 == 0u) {
                let _e74 = global_3.member[0u];
                phi_165_ = bitcast<i32>(_e74);
            } else {
                let _e60 = global_3.member[0u];
                let _e64 = global_2.member[0u];
                let _e66 = (bitcast<i32>(_e60) + bitcast<i32>(_e64));
                if (_e66 < -126i) {
                    phi_164_ = -126i;
                } else {
                    phi_164_ = select(_e66, 127i, (_e66 > 127i));
                }
                let _e71 = phi_164_;
                phi_165_ = _e71;
            }
            let _e77 = phi_165_;
            let _e81 = (_e40.x + (_e40.y * 2097152u));
            let _e84 = global_1.member[0u];
            if (_e81 < _e84) {
                let _e86 = (_e81 < _e42);
                if _e86 {
                    let _e87 = (_e81 < arrayLength((&global_5.member)));
                    if _e87 {
                        let _e88 = (0u < _e42);
                        if _e88 {
                            if _e88 {
                            } else {
                                break;
                            }
                            let _e91 = global_4.member[0u];
                            phi_207_ = _e91;
                        } else {
                            phi_207_ = type_21(array<array<i32, 4>, 3>(array<i32, 4>(0i, 0i, 0i, 0i), array<i32, 4>(0i, 0i, 0i, 0i), array<i32, 4>(0i, 0i, 0i, 0i)), 2147483648u, 2147483648u, 0u, 0u);
                        }
                        let _e93 = phi_207_;
                        phi_259_ = type_8(0u, 128u);
                        phi_262_ = type_32(array<i32, 3>(select(_e93.member[0][0], _e93.member[0][1], (_e93.member[0][1] < _e93.member[0][0])), select(_e93.member[1][0], _e93.member[1][1], (_e93.member[1][1] < _e93.member[1][0])), select(_e93.member[2][0], _e93.member[2][1], (_e93.member[2][1] < _e93.member[2][0]))), array<i32, 3>(select(_e93.member[0][3], _e93.member[0][2], (_e93.member[0][3] < _e93.member[0][2])), select(_e93.member[1][3], _e93.member[1][2], (_e93.member[1][3] < _e93.member[1][2])), select(_e93.member[2][3], _e93.member[2][2], (_e93.member[2][3] < _e93.member[2][2]))));
                        phi_264_ = 0u;
                        loop {
                            let _e126 = phi_259_;
                            let _e128 = phi_262_;
                            let _e130 = phi_264_;
                            local = _e128;
                            local_1 = _e128;
                            if (_e126.member < _e126.member_1) {
                                phi_260_ = type_8((_e126.member + 1u), _e126.member_1);
                                phi_287_ = type_8(1u, _e126.member);
                            } else {
                                phi_260_ = _e126;
                                phi_287_ = type_8(0u, type_8().member_1);
                            }
                            let _e143 = phi_260_;
                            let _e145 = phi_287_;
                            if (bitcast<i32>(_e145.member) != 0i) {
                                let _e149 = (_e130 == _e81);
                                if _e149 {
                                    phi_490_ = type_32();
                                    phi_491_ = u32();
                                } else {
                                    let _e150 = (_e130 < _e42);
                                    if _e150 {
                                        if _e150 {
                                        } else {
                                            phi_1445_ = true;
                                            break;
                                        }
                                        let _e153 = global_4.member[_e130];
                                        phi_309_ = _e153;
                                    } else {
                                        phi_309_ = type_21(array<array<i32, 4>, 3>(array<i32, 4>(0i, 0i, 0i, 0i), array<i32, 4>(0i, 0i, 0i, 0i), array<i32, 4>(0i, 0i, 0i, 0i)), 2147483648u, 2147483648u, 0u, 0u);
                                    }
                                    let _e155 = phi_309_;
                                    if ((_e155.member_1 & 2147483648u) != 0u) {
                                        phi_318_ = false;
                                    } else {
                                        phi_318_ = (_e81 <= _e155.member_1);
                                    }
                                    let _e162 = phi_318_;
                                    let _e174 = bitcast<u32>((_e128.member_1[0] - _e128.member[0]));
                                    let _e180 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e174)), 32u, (_e174 == 0u)));
                                    let _e183 = (select(10u, _e180, (_e180 > 10u)) - 10u);
                                    let _e188 = (_e155.member[0][0] - _e128.member[0]);
                                    let _e189 = (_e155.member[0][1] - _e128.member[0]);
                                    let _e190 = (_e128.member_1[0] - _e155.member[0][2]);
                                    let _e191 = (_e128.member_1[0] - _e155.member[0][3]);
                                    let _e192 = (_e188 > _e189);
                                    if (_e192 == _e162) {
                                        let _e195 = (_e183 & 31u);
                                        phi_362_ = ((select(_e189, _e188, _e192) >> bitcast<u32>(_e195)) << bitcast<u32>(_e195));
                                    } else {
                                        phi_362_ = 0i;
                                    }
                                    let _e201 = phi_362_;
                                    let _e203 = (_e190 > _e191);
                                    if (_e203 == _e162) {
                                        let _e206 = (_e183 & 31u);
                                        phi_377_ = ((select(_e191, _e190, _e203) >> bitcast<u32>(_e206)) << bitcast<u32>(_e206));
                                    } else {
                                        phi_377_ = 0i;
                                    }
                                    let _e212 = phi_377_;
                                    let _e217 = bitcast<u32>((_e128.member_1[1] - _e128.member[1]));
                                    let _e223 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e217)), 32u, (_e217 == 0u)));
                                    let _e226 = (select(10u, _e223, (_e223 > 10u)) - 10u);
                                    let _e231 = (_e155.member[1][0] - _e128.member[1]);
                                    let _e232 = (_e155.member[1][1] - _e128.member[1]);
                                    let _e233 = (_e128.member_1[1] - _e155.member[1][2]);
                                    let _e234 = (_e128.member_1[1] - _e155.member[1][3]);
                                    let _e235 = (_e231 > _e232);
                                    if (_e235 == _e162) {
                                        let _e238 = (_e226 & 31u);
                                        phi_414_ = ((select(_e232, _e231, _e235) >> bitcast<u32>(_e238)) << bitcast<u32>(_e238));
                                    } else {
                                        phi_414_ = 0i;
                                    }
                                    let _e244 = phi_414_;
                                    let _e246 = (_e233 > _e234);
                                    if (_e246 == _e162) {
                                        let _e249 = (_e226 & 31u);
                                        phi_429_ = ((select(_e234, _e233, _e246) >> bitcast<u32>(_e249)) << bitcast<u32>(_e249));
                                    } else {
                                        phi_429_ = 0i;
                                    }
                                    let _e255 = phi_429_;
                                    let _e260 = bitcast<u32>((_e128.member_1[2] - _e128.member[2]));
                                    let _e266 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e260)), 32u, (_e260 == 0u)));
                                    let _e269 = (select(10u, _e266, (_e266 > 10u)) - 10u);
                                    let _e274 = (_e155.member[2][0] - _e128.member[2]);
                                    let _e275 = (_e155.member[2][1] - _e128.member[2]);
                                    let _e276 = (_e128.member_1[2] - _e155.member[2][2]);
                                    let _e277 = (_e128.member_1[2] - _e155.member[2][3]);
                                    let _e278 = (_e274 > _e275);
                                    if (_e278 == _e162) {
                                        let _e281 = (_e269 & 31u);
                                        phi_466_ = ((select(_e275, _e274, _e278) >> bitcast<u32>(_e281)) << bitcast<u32>(_e281));
                                    } else {
                                        phi_466_ = 0i;
                                    }
                                    let _e287 = phi_466_;
                                    let _e289 = (_e276 > _e277);
                                    if (_e289 == _e162) {
                                        let _e292 = (_e269 & 31u);
                                        phi_481_ = ((select(_e277, _e276, _e289) >> bitcast<u32>(_e292)) << bitcast<u32>(_e292));
                                    } else {
                                        phi_481_ = 0i;
                                    }
                                    let _e298 = phi_481_;
                                    phi_490_ = type_32(array<i32, 3>((_e128.member[0] + _e201), (_e128.member[1] + _e244), (_e128.member[2] + _e287)), array<i32, 3>((_e128.member_1[0] - _e212), (_e128.member_1[1] - _e255), (_e128.member_1[2] - _e298)));
                                    phi_491_ = select(_e155.member_2, _e155.member_1, _e162);
                                }
                                let _e305 = phi_490_;
                                let _e307 = phi_491_;
                                phi_263_ = _e305;
                                phi_265_ = _e307;
                                phi_493_ = select(true, false, _e149);
                            } else {
                                phi_263_ = type_32();
                                phi_265_ = u32();
                                phi_493_ = false;
                            }
                            let _e310 = phi_263_;
                            let _e312 = phi_265_;
                            let _e314 = phi_493_;
                            continue;
                            continuing {
                                phi_259_ = _e143;
                                phi_262_ = _e310;
                                phi_264_ = _e312;
                                phi_1445_ = false;
                                break if !(_e314);
                            }
                        }
                        let _e317 = phi_1445_;
                        if _e317 {
                            break;
                        }
                        if _e86 {
                        } else {
                            break;
                        }
                        let _e319 = local;
                        let _e322 = local_1;
                        let _e334 = global_4.member[_e81].member[0u];
                        let _e336 = bitcast<u32>((_e322.member_1[0] - _e319.member[0]));
                        let _e342 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e336)), 32u, (_e336 == 0u)));
                        let _e350 = (_e334[0] - _e319.member[0]);
                        let _e351 = (_e334[1] - _e319.member[0]);
                        let _e352 = (_e322.member_1[0] - _e334[2]);
                        let _e353 = (_e322.member_1[0] - _e334[3]);
                        let _e354 = (_e350 > _e351);
                        let _e357 = ((select(10u, _e342, (_e342 > 10u)) - 10u) & 31u);
                        let _e364 = (((bitcast<u32>(select(_e351, _e350, _e354)) >> bitcast<u32>(_e357)) & 1023u) | (select(0u, 1u, _e354) << bitcast<u32>(10u)));
                        let _e365 = (_e352 > _e353);
                        let _e374 = (((bitcast<u32>(select(_e353, _e352, _e365)) >> bitcast<u32>(_e357)) & 1023u) | (select(0u, 1u, _e365) << bitcast<u32>(10u)));
                        let _e379 = global_4.member[_e81].member[1u];
                        let _e381 = bitcast<u32>((_e322.member_1[1] - _e319.member[1]));
                        let _e387 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e381)), 32u, (_e381 == 0u)));
                        let _e395 = (_e379[0] - _e319.member[1]);
                        let _e396 = (_e379[1] - _e319.member[1]);
                        let _e397 = (_e322.member_1[1] - _e379[2]);
                        let _e398 = (_e322.member_1[1] - _e379[3]);
                        let _e399 = (_e395 > _e396);
                        let _e402 = ((select(10u, _e387, (_e387 > 10u)) - 10u) & 31u);
                        let _e409 = (((bitcast<u32>(select(_e396, _e395, _e399)) >> bitcast<u32>(_e402)) & 1023u) | (select(0u, 1u, _e399) << bitcast<u32>(10u)));
                        let _e410 = (_e397 > _e398);
                        let _e419 = (((bitcast<u32>(select(_e398, _e397, _e410)) >> bitcast<u32>(_e402)) & 1023u) | (select(0u, 1u, _e410) << bitcast<u32>(10u)));
                        let _e424 = global_4.member[_e81].member[2u];
                        let _e426 = bitcast<u32>((_e322.member_1[2] - _e319.member[2]));
                        let _e432 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e426)), 32u, (_e426 == 0u)));
                        let _e440 = (_e424[0] - _e319.member[2]);
                        let _e441 = (_e424[1] - _e319.member[2]);
                        let _e442 = (_e322.member_1[2] - _e424[2]);
                        let _e443 = (_e322.member_1[2] - _e424[3]);
                        let _e444 = (_e440 > _e441);
                        let _e447 = ((select(10u, _e432, (_e432 > 10u)) - 10u) & 31u);
                        let _e454 = (((bitcast<u32>(select(_e441, _e440, _e444)) >> bitcast<u32>(_e447)) & 1023u) | (select(0u, 1u, _e444) << bitcast<u32>(10u)));
                        let _e455 = (_e442 > _e443);
                        let _e464 = (((bitcast<u32>(select(_e443, _e442, _e455)) >> bitcast<u32>(_e447)) & 1023u) | (select(0u, 1u, _e455) << bitcast<u32>(10u)));
                        let _e478 = (_e319.member[0] + bitcast<i32>(((_e364 & 1023u) << bitcast<u32>(_e357))));
                        let _e483 = (_e322.member_1[0] - bitcast<i32>(((_e374 & 1023u) << bitcast<u32>(_e357))));
                        let _e487 = (((_e364 >> bitcast<u32>(10u)) & 1u) == 1u);
                        let _e491 = (((_e374 >> bitcast<u32>(10u)) & 1u) == 1u);
                        let _e492 = select(_e319.member[0], _e478, _e487);
                        let _e493 = select(_e478, _e319.member[0], _e487);
                        let _e500 = (_e319.member[1] + bitcast<i32>(((_e409 & 1023u) << bitcast<u32>(_e402))));
                        let _e505 = (_e322.member_1[1] - bitcast<i32>(((_e419 & 1023u) << bitcast<u32>(_e402))));
                        let _e509 = (((_e409 >> bitcast<u32>(10u)) & 1u) == 1u);
                        let _e513 = (((_e419 >> bitcast<u32>(10u)) & 1u) == 1u);
                        let _e514 = select(_e319.member[1], _e500, _e509);
                        let _e515 = select(_e500, _e319.member[1], _e509);
                        let _e522 = (_e319.member[2] + bitcast<i32>(((_e454 & 1023u) << bitcast<u32>(_e447))));
                        let _e527 = (_e322.member_1[2] - bitcast<i32>(((_e464 & 1023u) << bitcast<u32>(_e447))));
                        let _e531 = (((_e454 >> bitcast<u32>(10u)) & 1u) == 1u);
                        let _e535 = (((_e464 >> bitcast<u32>(10u)) & 1u) == 1u);
                        let _e536 = select(_e319.member[2], _e522, _e531);
                        let _e537 = select(_e522, _e319.member[2], _e531);
                        if _e87 {
                        } else {
                            break;
                        }
                        global_5.member[_e81] = array<u32, 4>(0u, (_e364 | (_e374 << bitcast<u32>(11u))), (_e409 | (_e419 << bitcast<u32>(11u))), (_e454 | (_e464 << bitcast<u32>(11u))));
                        if _e86 {
                        } else {
                            break;
                        }
                        let _e546 = global_4.member[_e81].member_1;
                        let _e555 = ((bitcast<u32>((select(_e322.member_1[0], _e483, _e491) - _e492)) | bitcast<u32>((select(_e322.member_1[1], _e505, _e513) - _e514))) | bitcast<u32>((select(_e322.member_1[2], _e527, _e535) - _e536)));
                        if (_e555 < 1024u) {
                            phi_1146_ = 0u;
                        } else {
                            phi_1146_ = select(2u, 1u, (_e555 < 2097152u));
                        }
                        let _e560 = phi_1146_;
                        switch bitcast<i32>(_e560) {
                            case 0: {
                                phi_1152_ = 1u;
                                break;
                            }
                            case 1: {
                                phi_1152_ = 2u;
                                break;
                            }
                            case 2: {
                                phi_1152_ = 3u;
                                break;
                            }
                            default: {
                                phi_1152_ = u32();
                                break;
                            }
                        }
                        let _e563 = phi_1152_;
                        let _e565 = ((3u * _e563) + 1u);
                        if ((_e546 & 2147483648u) != 0u) {
                            phi_1163_ = ((_e546 >> bitcast<u32>(28u)) & 7u);
                        } else {
                            phi_1163_ = 0u;
                        }
                        let _e573 = phi_1163_;
                        phi_1166_ = type_8(0u, _e573);
                        loop {
                            let _e576 = phi_1166_;
                            if (_e576.member < _e576.member_1) {
                                phi_1167_ = type_8((_e576.member + 1u), _e576.member_1);
                                phi_1190_ = type_8(1u, _e576.member);
                            } else {
                                phi_1167_ = _e576;
                                phi_1190_ = type_8(0u, type_8().member_1);
                            }
                            let _e589 = phi_1167_;
                            let _e591 = phi_1190_;
                            let _e595 = (bitcast<i32>(_e591.member) != 0i);
                            if _e595 {
                                let _e597 = ((_e546 & 268435455u) + _e591.member_1);
                                let _e598 = (_e597 < _e47);
                                if _e598 {
                                    let _e599 = (_e597 < _e50);
                                    if _e599 {
                                        if _e598 {
                                        } else {
                                            phi_1478_ = true;
                                            break;
                                        }
                                        global_6.member[_e597] = type_36(array<i32, 3>(_e492, _e514, _e536), _e565);
                                        if _e599 {
                                        } else {
                                            phi_1478_ = true;
                                            break;
                                        }
                                        global_7.member[_e597] = _e565;
                                    }
                                }
                            }
                            continue;
                            continuing {
                                phi_1166_ = _e589;
                                phi_1478_ = _e317;
                                break if !(_e595);
                            }
                        }
                        let _e604 = phi_1478_;
                        if _e604 {
                            break;
                        }
                        if _e86 {
                        } else {
                            break;
                        }
                        let _e608 = global_4.member[_e81].member_2;
                        let _e617 = ((bitcast<u32>((select(_e483, _e322.member_1[0], _e491) - _e493)) | bitcast<u32>((select(_e505, _e322.member_1[1], _e513) - _e515))) | bitcast<u32>((select(_e527, _e322.member_1[2], _e535) - _e537)));
                        if (_e617 < 1024u) {
                            phi_1297_ = 0u;
                        } else {
                            phi_1297_ = select(2u, 1u, (_e617 < 2097152u));
                        }
                        let _e622 = phi_1297_;
                        switch bitcast<i32>(_e622) {
                            case 0: {
                                phi_1303_ = 1u;
                                break;
                            }
                            case 1: {
                                phi_1303_ = 2u;
                                break;
                            }
                            case 2: {
                                phi_1303_ = 3u;
                                break;
                            }
                            default: {
                                phi_1303_ = u32();
                                break;
                            }
                        }
                        let _e625 = phi_1303_;
                        let _e627 = ((3u * _e625) + 1u);
                        if ((_e608 & 2147483648u) != 0u) {
                            phi_1314_ = ((_e608 >> bitcast<u32>(28u)) & 7u);
                        } else {
                            phi_1314_ = 0u;
                        }
                        let _e635 = phi_1314_;
                        phi_1317_ = type_8(0u, _e635);
                        loop {
                            let _e638 = phi_1317_;
                            if (_e638.member < _e638.member_1) {
                                phi_1318_ = type_8((_e638.member + 1u), _e638.member_1);
                                phi_1341_ = type_8(1u, _e638.member);
                            } else {
                                phi_1318_ = _e638;
                                phi_1341_ = type_8(0u, type_8().member_1);
                            }
                            let _e651 = phi_1318_;
                            let _e653 = phi_1341_;
                            let _e657 = (bitcast<i32>(_e653.member) != 0i);
                            if _e657 {
                                let _e659 = ((_e608 & 268435455u) + _e653.member_1);
                                let _e660 = (_e659 < _e47);
                                if _e660 {
                                    let _e661 = (_e659 < _e50);
                                    if _e661 {
                                        if _e660 {
                                        } else {
                                            phi_1533_ = true;
                                            break;
                                        }
                                        global_6.member[_e659] = type_36(array<i32, 3>(_e493, _e515, _e537), _e627);
                                        if _e661 {
                                        } else {
                                            phi_1533_ = true;
                                            break;
                                        }
                                        global_7.member[_e659] = _e627;
                                    }
                                }
                            }
                            continue;
                            continuing {
                                phi_1317_ = _e651;
                                phi_1533_ = _e604;
                                break if !(_e657);
                            }
                        }
                        let _e666 = phi_1533_;
                        if _e666 {
                            break;
                        }
                        if (_e81 == 0u) {
                            if (_e53 == 0u) {
                            } else {
                                if (0u < _e53) {
                                } else {
                                    break;
                                }
                                global_8.member[0u] = type_26(array<u32, 4>(bitcast<u32>(_e319.member[0]), bitcast<u32>(_e319.member[1]), bitcast<u32>(_e319.member[2]), bitcast<u32>(_e77)), array<u32, 4>(bitcast<u32>(_e322.member_1[0]), bitcast<u32>(_e322.member_1[1]), bitcast<u32>(_e322.member_1[2]), 0u));
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
fn encode_q10_sizes(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
