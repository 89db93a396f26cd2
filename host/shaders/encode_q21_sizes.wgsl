struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_13 {
    member: vec4<u32>,
}

struct type_18 {
    member: array<array<i32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_20 {
    member: array<type_18>,
}

struct type_23 {
    member: array<u32, 4>,
    member_1: array<u32, 4>,
}

struct type_25 {
    member: array<type_23>,
}

struct type_29 {
    member: array<i32, 3>,
    member_1: array<i32, 3>,
}

struct type_34 {
    member: array<array<u32, 7>>,
}

struct type_37 {
    member: array<i32, 3>,
    member_1: u32,
}

struct type_39 {
    member: array<type_37>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_13;
@group(0) @binding(1) 
var<uniform> global_2: type_13;
@group(0) @binding(2) 
var<uniform> global_3: type_13;
@group(0) @binding(3) 
var<storage> global_4: type_20;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_39;
@group(0) @binding(6) 
var<storage, read_write> global_6: type_4;
@group(0) @binding(7) 
var<storage, read_write> global_7: type_25;
@group(0) @binding(4) 
var<storage, read_write> global_8: type_34;

fn function_() {
    var phi_165_: i32;
    var phi_166_: i32;
    var phi_208_: type_18;
    var phi_259_: type_8;
    var phi_262_: type_29;
    var phi_264_: u32;
    var phi_260_: type_8;
    var phi_287_: type_8;
    var phi_309_: type_18;
    var phi_318_: bool;
    var phi_362_: i32;
    var phi_377_: i32;
    var phi_414_: i32;
    var phi_429_: i32;
    var phi_466_: i32;
    var phi_481_: i32;
    var phi_490_: type_29;
    var phi_491_: u32;
    var phi_263_: type_29;
    var phi_265_: u32;
    var phi_493_: bool;
    var phi_1463_: bool;
    var local: type_29;
    var local_1: type_29;
    var phi_1155_: u32;
    var phi_1161_: u32;
    var phi_1172_: u32;
    var phi_1175_: type_8;
    var phi_1176_: type_8;
    var phi_1199_: type_8;
    var phi_1496_: bool;
    var phi_1306_: u32;
    var phi_1312_: u32;
    var phi_1323_: u32;
    var phi_1326_: type_8;
    var phi_1327_: type_8;
    var phi_1350_: type_8;
    var phi_1551_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e39 = global;
            let _e41 = arrayLength((&global_4.member));
            let _e46 = arrayLength((&global_5.member));
            let _e49 = arrayLength((&global_6.member));
            let _e52 = arrayLength((&global_7.member));
            let _e55 = global_3.member[1u];
            if (_e55 == 0u) {
                let _e73 = global_3.member[0u];
                phi_166_ = bitcast<i32>(_e73);
            } else {
                let _e59 = global_3.member[0u];
                let _e63 = global_2.member[0u];
                let _e65 = (bitcast<i32>(_e59) + bitcast<i32>(_e63));
                if (_e65 < -126i) {
                    phi_165_ = -126i;
                } else {
                    phi_165_ = select(_e65, 127i, (_e65 > 127i));
                }
                let _e70 = phi_165_;
                phi_166_ = _e70;
            }
            let _e76 = phi_166_;
            let _e80 = (_e39.x + (_e39.y * 2097152u));
            let _e83 = global_1.member[0u];
            if (_e80 < _e83) {
                let _e85 = (_e80 < _e41);
                if _e85 {
                    let _e86 = (_e80 < arrayLength((&global_8.member)));
                    if _e86 {
                        let _e87 = (0u < _e41);
                        if _e87 {
                            if _e87 {
                            } else {
                                break;
                            }
                            let _e90 = global_4.member[0u];
                            phi_208_ = _e90;
                        } else {
                            phi_208_ = type_18(array<array<i32, 4>, 3>(array<i32, 4>(0i, 0i, 0i, 0i), array<i32, 4>(0i, 0i, 0i, 0i), array<i32, 4>(0i, 0i, 0i, 0i)), 2147483648u, 2147483648u, 0u, 0u);
                        }
                        let _e92 = phi_208_;
                        phi_259_ = type_8(0u, 128u);
                        phi_262_ = type_29(array<i32, 3>(select(_e92.member[0][0], _e92.member[0][1], (_e92.member[0][1] < _e92.member[0][0])), select(_e92.member[1][0], _e92.member[1][1], (_e92.member[1][1] < _e92.member[1][0])), select(_e92.member[2][0], _e92.member[2][1], (_e92.member[2][1] < _e92.member[2][0]))), array<i32, 3>(select(_e92.member[0][3], _e92.member[0][2], (_e92.member[0][3] < _e92.member[0][2])), select(_e92.member[1][3], _e92.member[1][2], (_e92.member[1][3] < _e92.member[1][2])), select(_e92.member[2][3], _e92.member[2][2], (_e92.member[2][3] < _e92.member[2][2]))));
                        phi_264_ = 0u;
                        loop {
                            let _e127 = phi_259_;
                            let _e129 = phi_262_;
                            let _e131 = phi_264_;
                            local = _e129;
                            local_1 = _e129;
                            if (_e127.member < _e127.member_1) {
                                phi_260_ = type_8((_e127.member + 1u), _e127.member_1);
                                phi_287_ = type_8(1u, _e127.member);
                            } else {
                                phi_260_ = _e127;
                                phi_287_ = type_8(0u, type_8().member_1);
                            }
                            let _e144 = phi_260_;
                            let _e146 = phi_287_;
                            if (bitcast<i32>(_e146.member) != 0i) {
                                let _e150 = (_e131 == _e80);
                                if _e150 {
                                    phi_490_ = type_29();
                                    phi_491_ = u32();
                                } else {
                                    let _e151 = (_e131 < _e41);
                                    if _e151 {
                                        if _e151 {
                                        } else {
                                            phi_1463_ = true;
                                            break;
                                        }
                                        let _e154 = global_4.member[_e131];
                                        phi_309_ = _e154;
                                    } else {
                                        phi_309_ = type_18(array<array<i32, 4>, 3>(array<i32, 4>(0i, 0i, 0i, 0i), array<i32, 4>(0i, 0i, 0i, 0i), array<i32, 4>(0i, 0i, 0i, 0i)), 2147483648u, 2147483648u, 0u, 0u);
                                    }
                                    let _e156 = phi_309_;
                                    if ((_e156.member_1 & 2147483648u) != 0u) {
                                        phi_318_ = false;
                                    } else {
                                        phi_318_ = (_e80 <= _e156.member_1);
                                    }
                                    let _e163 = phi_318_;
                                    let _e175 = bitcast<u32>((_e129.member_1[0] - _e129.member[0]));
                                    let _e181 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e175)), 32u, (_e175 == 0u)));
                                    let _e184 = (select(21u, _e181, (_e181 > 21u)) - 21u);
                                    let _e189 = (_e156.member[0][0] - _e129.member[0]);
                                    let _e190 = (_e156.member[0][1] - _e129.member[0]);
                                    let _e191 = (_e129.member_1[0] - _e156.member[0][2]);
                                    let _e192 = (_e129.member_1[0] - _e156.member[0][3]);
                                    let _e193 = (_e189 > _e190);
                                    if (_e193 == _e163) {
                                        let _e196 = (_e184 & 31u);
                                        phi_362_ = ((select(_e190, _e189, _e193) >> bitcast<u32>(_e196)) << bitcast<u32>(_e196));
                                    } else {
                                        phi_362_ = 0i;
                                    }
                                    let _e202 = phi_362_;
                                    let _e204 = (_e191 > _e192);
                                    if (_e204 == _e163) {
                                        let _e207 = (_e184 & 31u);
                                        phi_377_ = ((select(_e192, _e191, _e204) >> bitcast<u32>(_e207)) << bitcast<u32>(_e207));
                                    } else {
                                        phi_377_ = 0i;
                                    }
                                    let _e213 = phi_377_;
                                    let _e218 = bitcast<u32>((_e129.member_1[1] - _e129.member[1]));
                                    let _e224 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e218)), 32u, (_e218 == 0u)));
                                    let _e227 = (select(21u, _e224, (_e224 > 21u)) - 21u);
                                    let _e232 = (_e156.member[1][0] - _e129.member[1]);
                                    let _e233 = (_e156.member[1][1] - _e129.member[1]);
                                    let _e234 = (_e129.member_1[1] - _e156.member[1][2]);
                                    let _e235 = (_e129.member_1[1] - _e156.member[1][3]);
                                    let _e236 = (_e232 > _e233);
                                    if (_e236 == _e163) {
                                        let _e239 = (_e227 & 31u);
                                        phi_414_ = ((select(_e233, _e232, _e236) >> bitcast<u32>(_e239)) << bitcast<u32>(_e239));
                                    } else {
                                        phi_414_ = 0i;
                                    }
                                    let _e245 = phi_414_;
                                    let _e247 = (_e234 > _e235);
                                    if (_e247 == _e163) {
                                        let _e250 = (_e227 & 31u);
                                        phi_429_ = ((select(_e235, _e234, _e247) >> bitcast<u32>(_e250)) << bitcast<u32>(_e250));
                                    } else {
                                        phi_429_ = 0i;
                                    }
                                    let _e256 = phi_429_;
                                    let _e261 = bitcast<u32>((_e129.member_1[2] - _e129.member[2]));
                                    let _e267 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e261)), 32u, (_e261 == 0u)));
                                    let _e270 = (select(21u, _e267, (_e267 > 21u)) - 21u);
                                    let _e275 = (_e156.member[2][0] - _e129.member[2]);
                                    let _e276 = (_e156.member[2][1] - _e129.member[2]);
                                    let _e277 = (_e129.member_1[2] - _e156.member[2][2]);
                                    let _e278 = (_e129.member_1[2] - _e156.member[2][3]);
                                    let _e279 = (_e275 > _e276);
                                    if (_e279 == _e163) {
                                        let _e282 = (_e270 & 31u);
                                        phi_466_ = ((select(_e276, _e275, _e279) >> bitcast<u32>(_e282)) << bitcast<u32>(_e282));
                                    } else {
                                        phi_466_ = 0i;
                                    }
                                    let _e288 = phi_466_;
                                    let _e290 = (_e277 > _e278);
                                    if (_e290 == _e163) {
                                        let _e293 = (_e270 & 31u);
                                        phi_481_ = ((select(_e278, _e277, _e290) >> bitcast<u32>(_e293)) << bitcast<u32>(_e293));
                                    } else {
                                        phi_481_ = 0i;
                                    }
                                    let _e299 = phi_481_;
                                    phi_490_ = type_29(array<i32, 3>((_e129.member[0] + _e202), (_e129.member[1] + _e245), (_e129.member[2] + _e288)), array<i32, 3>((_e129.member_1[0] - _e213), (_e129.member_1[1] - _e256), (_e129.member_1[2] - _e299)));
                                    phi_491_ = select(_e156.member_2, _e156.member_1, _e163);
                                }
                                let _e306 = phi_490_;
                                let _e308 = phi_491_;
                                phi_263_ = _e306;
                                phi_265_ = _e308;
                                phi_493_ = select(true, false, _e150);
                            } else {
                                phi_263_ = type_29();
                                phi_265_ = u32();
                                phi_493_ = false;
                            }
                            let _e311 = phi_263_;
                            let _e313 = phi_265_;
                            let _e315 = phi_493_;
                            continue;
                            continuing {
                                phi_259_ = _e144;
                                phi_262_ = _e311;
                                phi_264_ = _e313;
                                phi_1463_ = false;
                                break if !(_e315);
                            }
                        }
                        let _e318 = phi_1463_;
                        if _e318 {
                            break;
                        }
                        if _e85 {
                        } else {
                            break;
                        }
                        let _e320 = local;
                        let _e323 = local_1;
                        let _e335 = global_4.member[_e80].member[0u];
                        let _e337 = bitcast<u32>((_e323.member_1[0] - _e320.member[0]));
                        let _e343 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e337)), 32u, (_e337 == 0u)));
                        let _e351 = (_e335[0] - _e320.member[0]);
                        let _e352 = (_e335[1] - _e320.member[0]);
                        let _e353 = (_e323.member_1[0] - _e335[2]);
                        let _e354 = (_e323.member_1[0] - _e335[3]);
                        let _e355 = (_e351 > _e352);
                        let _e358 = ((select(21u, _e343, (_e343 > 21u)) - 21u) & 31u);
                        let _e365 = (((bitcast<u32>(select(_e352, _e351, _e355)) >> bitcast<u32>(_e358)) & 2097151u) | (select(0u, 1u, _e355) << bitcast<u32>(21u)));
                        let _e366 = (_e353 > _e354);
                        let _e375 = (((bitcast<u32>(select(_e354, _e353, _e366)) >> bitcast<u32>(_e358)) & 2097151u) | (select(0u, 1u, _e366) << bitcast<u32>(21u)));
                        let _e380 = global_4.member[_e80].member[1u];
                        let _e382 = bitcast<u32>((_e323.member_1[1] - _e320.member[1]));
                        let _e388 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e382)), 32u, (_e382 == 0u)));
                        let _e396 = (_e380[0] - _e320.member[1]);
                        let _e397 = (_e380[1] - _e320.member[1]);
                        let _e398 = (_e323.member_1[1] - _e380[2]);
                        let _e399 = (_e323.member_1[1] - _e380[3]);
                        let _e400 = (_e396 > _e397);
                        let _e403 = ((select(21u, _e388, (_e388 > 21u)) - 21u) & 31u);
                        let _e410 = (((bitcast<u32>(select(_e397, _e396, _e400)) >> bitcast<u32>(_e403)) & 2097151u) | (select(0u, 1u, _e400) << bitcast<u32>(21u)));
                        let _e411 = (_e398 > _e399);
                        let _e420 = (((bitcast<u32>(select(_e399, _e398, _e411)) >> bitcast<u32>(_e403)) & 2097151u) | (select(0u, 1u, _e411) << bitcast<u32>(21u)));
                        let _e425 = global_4.member[_e80].member[2u];
                        let _e427 = bitcast<u32>((_e323.member_1[2] - _e320.member[2]));
                        let _e433 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e427)), 32u, (_e427 == 0u)));
                        let _e441 = (_e425[0] - _e320.member[2]);
                        let _e442 = (_e425[1] - _e320.member[2]);
                        let _e443 = (_e323.member_1[2] - _e425[2]);
                        let _e444 = (_e323.member_1[2] - _e425[3]);
                        let _e445 = (_e441 > _e442);
                        let _e448 = ((select(21u, _e433, (_e433 > 21u)) - 21u) & 31u);
                        let _e455 = (((bitcast<u32>(select(_e442, _e441, _e445)) >> bitcast<u32>(_e448)) & 2097151u) | (select(0u, 1u, _e445) << bitcast<u32>(21u)));
                        let _e456 = (_e443 > _e444);
                        let _e465 = (((bitcast<u32>(select(_e444, _e443, _e456)) >> bitcast<u32>(_e448)) & 2097151u) | (select(0u, 1u, _e456) << bitcast<u32>(21u)));
                        let _e470 = (_e320.member[0] + bitcast<i32>(((_e365 & 2097151u) << bitcast<u32>(_e358))));
                        let _e475 = (_e323.member_1[0] - bitcast<i32>(((_e375 & 2097151u) << bitcast<u32>(_e358))));
                        let _e479 = (((_e365 >> bitcast<u32>(21u)) & 1u) == 1u);
                        let _e483 = (((_e375 >> bitcast<u32>(21u)) & 1u) == 1u);
                        let _e484 = select(_e320.member[0], _e470, _e479);
                        let _e485 = select(_e470, _e320.member[0], _e479);
                        let _e492 = (_e320.member[1] + bitcast<i32>(((_e410 & 2097151u) << bitcast<u32>(_e403))));
                        let _e497 = (_e323.member_1[1] - bitcast<i32>(((_e420 & 2097151u) << bitcast<u32>(_e403))));
                        let _e501 = (((_e410 >> bitcast<u32>(21u)) & 1u) == 1u);
                        let _e505 = (((_e420 >> bitcast<u32>(21u)) & 1u) == 1u);
                        let _e506 = select(_e320.member[1], _e492, _e501);
                        let _e507 = select(_e492, _e320.member[1], _e501);
                        let _e514 = (_e320.member[2] + bitcast<i32>(((_e455 & 2097151u) << bitcast<u32>(_e448))));
                        let _e519 = (_e323.member_1[2] - bitcast<i32>(((_e465 & 2097151u) << bitcast<u32>(_e448))));
                        let _e523 = (((_e455 >> bitcast<u32>(21u)) & 1u) == 1u);
                        let _e527 = (((_e465 >> bitcast<u32>(21u)) & 1u) == 1u);
                        let _e528 = select(_e320.member[2], _e514, _e523);
                        let _e529 = select(_e514, _e320.member[2], _e523);
                        if _e86 {
                        } else {
                            break;
                        }
                        global_8.member[_e80] = array<u32, 7>(0u, _e365, _e375, _e410, _e420, _e455, _e465);
                        if _e85 {
                        } else {
                            break;
                        }
                        let _e538 = global_4.member[_e80].member_1;
                        let _e547 = ((bitcast<u32>((select(_e323.member_1[0], _e475, _e483) - _e484)) | bitcast<u32>((select(_e323.member_1[1], _e497, _e505) - _e506))) | bitcast<u32>((select(_e323.member_1[2], _e519, _e527) - _e528)));
                        if (_e547 < 1024u) {
                            phi_1155_ = 0u;
                        } else {
                            phi_1155_ = select(2u, 1u, (_e547 < 2097152u));
                        }
                        let _e552 = phi_1155_;
                        switch bitcast<i32>(_e552) {
                            case 0: {
                                phi_1161_ = 1u;
                                break;
                            }
                            case 1: {
                                phi_1161_ = 2u;
                                break;
                            }
                            case 2: {
                                phi_1161_ = 3u;
                                break;
                            }
                            default: {
                                phi_1161_ = u32();
                                break;
                            }
                        }
                        let _e555 = phi_1161_;
                        let _e557 = ((3u * _e555) + 1u);
                        if ((_e538 & 2147483648u) != 0u) {
                            phi_1172_ = ((_e538 >> bitcast<u32>(28u)) & 7u);
                        } else {
                            phi_1172_ = 0u;
                        }
                        let _e565 = phi_1172_;
                        phi_1175_ = type_8(0u, _e565);
                        loop {
                            let _e568 = phi_1175_;
                            if (_e568.member < _e568.member_1) {
                                phi_1176_ = type_8((_e568.member + 1u), _e568.member_1);
                                phi_1199_ = type_8(1u, _e568.member);
                            } else {
                                phi_1176_ = _e568;
                                phi_1199_ = type_8(0u, type_8().member_1);
                            }
                            let _e581 = phi_1176_;
                            let _e583 = phi_1199_;
                            let _e587 = (bitcast<i32>(_e583.member) != 0i);
                            if _e587 {
                                let _e589 = ((_e538 & 268435455u) + _e583.member_1);
                                let _e590 = (_e589 < _e46);
                                if _e590 {
                                    let _e591 = (_e589 < _e49);
                                    if _e591 {
                                        if _e590 {
                                        } else {
                                            phi_1496_ = true;
                                            break;
                                        }
                                        global_5.member[_e589] = type_37(array<i32, 3>(_e484, _e506, _e528), _e557);
                                        if _e591 {
                                        } else {
                                            phi_1496_ = true;
                                            break;
                                        }
                                        global_6.member[_e589] = _e557;
                                    }
                                }
                            }
                            continue;
                            continuing {
                                phi_1175_ = _e581;
                                phi_1496_ = _e318;
                                break if !(_e587);
                            }
                        }
                        let _e596 = phi_1496_;
                        if _e596 {
                            break;
                        }
                        if _e85 {
                        } else {
                            break;
                        }
                        let _e600 = global_4.member[_e80].member_2;
                        let _e609 = ((bitcast<u32>((select(_e475, _e323.member_1[0], _e483) - _e485)) | bitcast<u32>((select(_e497, _e323.member_1[1], _e505) - _e507))) | bitcast<u32>((select(_e519, _e323.member_1[2], _e527) - _e529)));
                        if (_e609 < 1024u) {
                            phi_1306_ = 0u;
                        } else {
                            phi_1306_ = select(2u, 1u, (_e609 < 2097152u));
                        }
                        let _e614 = phi_1306_;
                        switch bitcast<i32>(_e614) {
                            case 0: {
                                phi_1312_ = 1u;
                                break;
                            }
                            case 1: {
                                phi_1312_ = 2u;
                                break;
                            }
                            case 2: {
                                phi_1312_ = 3u;
                                break;
                            }
                            default: {
                                phi_1312_ = u32();
                                break;
                            }
                        }
                        let _e617 = phi_1312_;
                        let _e619 = ((3u * _e617) + 1u);
                        if ((_e600 & 2147483648u) != 0u) {
                            phi_1323_ = ((_e600 >> bitcast<u32>(28u)) & 7u);
                        } else {
                            phi_1323_ = 0u;
                        }
                        let _e627 = phi_1323_;
                        phi_1326_ = type_8(0u, _e627);
                        loop {
                            let _e630 = phi_1326_;
                            if (_e630.member < _e630.member_1) {
                                phi_1327_ = type_8((_e630.member + 1u), _e630.member_1);
                                phi_1350_ = type_8(1u, _e630.member);
                            } else {
                                phi_1327_ = _e630;
                                phi_1350_ = type_8(0u, type_8().member_1);
                            }
                            let _e643 = phi_1327_;
                            let _e645 = phi_1350_;
                            let _e649 = (bitcast<i32>(_e645.member) != 0i);
                            if _e649 {
                                let _e651 = ((_e600 & 268435455u) + _e645.member_1);
                                let _e652 = (_e651 < _e46);
                                if _e652 {
                                    let _e653 = (_e651 < _e49);
                                    if _e653 {
                                        if _e652 {
                                        } else {
                                            phi_1551_ = true;
                                            break;
                                        }
                                        global_5.member[_e651] = type_37(array<i32, 3>(_e485, _e507, _e529), _e619);
                                        if _e653 {
                                        } else {
                                            phi_1551_ = true;
                                            break;
                                        }
                                        global_6.member[_e651] = _e619;
                                    }
                                }
                            }
                            continue;
                            continuing {
                                phi_1326_ = _e643;
                                phi_1551_ = _e596;
                                break if !(_e649);
                            }
                        }
                        let _e658 = phi_1551_;
                        if _e658 {
                            break;
                        }
                        if (_e80 == 0u) {
                            if (_e52 == 0u) {
                            } else {
                                if (0u < _e52) {
                                } else {
                                    break;
                                }
                                global_7.member[0u] = type_23(array<u32, 4>(bitcast<u32>(_e320.member[0]), bitcast<u32>(_e320.member[1]), bitcast<u32>(_e320.member[2]), bitcast<u32>(_e76)), array<u32, 4>(bitcast<u32>(_e323.member_1[0]), bitcast<u32>(_e323.member_1[1]), bitcast<u32>(_e323.member_1[2]), 0u));
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
fn encode_q21_sizes(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
