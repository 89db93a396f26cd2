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
    var phi_260_: type_8;
    var phi_263_: type_29;
    var phi_265_: u32;
    var phi_261_: type_8;
    var phi_288_: type_8;
    var phi_310_: type_18;
    var phi_319_: bool;
    var phi_363_: i32;
    var phi_378_: i32;
    var phi_415_: i32;
    var phi_430_: i32;
    var phi_467_: i32;
    var phi_482_: i32;
    var phi_491_: type_29;
    var phi_492_: u32;
    var phi_264_: type_29;
    var phi_266_: u32;
    var phi_494_: bool;
    var phi_1464_: bool;
    var local: type_29;
    var local_1: type_29;
    var phi_1156_: u32;
    var phi_1162_: u32;
    var phi_1173_: u32;
    var phi_1176_: type_8;
    var phi_1177_: type_8;
    var phi_1200_: type_8;
    var phi_1497_: bool;
    var phi_1307_: u32;
    var phi_1313_: u32;
    var phi_1324_: u32;
    var phi_1327_: type_8;
    var phi_1328_: type_8;
    var phi_1351_: type_8;
    var phi_1552_: bool;

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
                        phi_260_ = type_8(0u, 128u);
                        phi_263_ = type_29(array<i32, 3>(select(_e92.member[0][0], _e92.member[0][1], (_e92.member[0][1] < _e92.member[0][0])), select(_e92.member[1][0], _e92.member[1][1], (_e92.member[1][1] < _e92.member[1][0])), select(_e92.member[2][0], _e92.member[2][1], (_e92.member[2][1] < _e92.member[2][0]))), array<i32, 3>(select(_e92.member[0][3], _e92.member[0][2], (_e92.member[0][3] < _e92.member[0][2])), select(_e92.member[1][3], _e92.member[1][2], (_e92.member[1][3] < _e92.member[1][2])), select(_e92.member[2][3], _e92.member[2][2], (_e92.member[2][3] < _e92.member[2][2]))));
                        phi_265_ = 0u;
                        loop {
                            let _e125 = phi_260_;
                            let _e127 = phi_263_;
                            let _e129 = phi_265_;
                            local = _e127;
                            local_1 = _e127;
                            if (_e125.member < _e125.member_1) {
                                phi_261_ = type_8((_e125.member + 1u), _e125.member_1);
                                phi_288_ = type_8(1u, _e125.member);
                            } else {
                                phi_261_ = _e125;
                                phi_288_ = type_8(0u, type_8().member_1);
                            }
                            let _e142 = phi_261_;
                            let _e144 = phi_288_;
                            if (bitcast<i32>(_e144.member) != 0i) {
                                let _e148 = (_e129 == _e80);
                                if _e148 {
                                    phi_491_ = type_29();
                                    phi_492_ = u32();
                                } else {
                                    let _e149 = (_e129 < _e41);
                                    if _e149 {
                                        if _e149 {
                                        } else {
                                            phi_1464_ = true;
                                            break;
                                        }
                                        let _e152 = global_4.member[_e129];
                                        phi_310_ = _e152;
                                    } else {
                                        phi_310_ = type_18(array<array<i32, 4>, 3>(array<i32, 4>(0i, 0i, 0i, 0i), array<i32, 4>(0i, 0i, 0i, 0i), array<i32, 4>(0i, 0i, 0i, 0i)), 2147483648u, 2147483648u, 0u, 0u);
                                    }
                                    let _e154 = phi_310_;
                                    if ((_e154.member_1 & 2147483648u) != 0u) {
                                        phi_319_ = false;
                                    } else {
                                        phi_319_ = (_e80 <= _e154.member_1);
                                    }
                                    let _e161 = phi_319_;
                                    let _e173 = bitcast<u32>((_e127.member_1[0] - _e127.member[0]));
                                    let _e179 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e173)), 32u, (_e173 == 0u)));
                                    let _e182 = (select(21u, _e179, (_e179 > 21u)) - 21u);
                                    let _e187 = (_e154.member[0][0] - _e127.member[0]);
                                    let _e188 = (_e154.member[0][1] - _e127.member[0]);
                                    let _e189 = (_e127.member_1[0] - _e154.member[0][2]);
                                    let _e190 = (_e127.member_1[0] - _e154.member[0][3]);
                                    let _e191 = (_e187 > _e188);
                                    if (_e191 == _e161) {
                                        let _e194 = (_e182 & 31u);
                                        phi_363_ = ((select(_e188, _e187, _e191) >> bitcast<u32>(_e194)) << bitcast<u32>(_e194));
                                    } else {
                                        phi_363_ = 0i;
                                    }
                                    let _e200 = phi_363_;
                                    let _e202 = (_e189 > _e190);
                                    if (_e202 == _e161) {
                                        let _e205 = (_e182 & 31u);
                                        phi_378_ = ((select(_e190, _e189, _e202) >> bitcast<u32>(_e205)) << bitcast<u32>(_e205));
                                    } else {
                                        phi_378_ = 0i;
                                    }
                                    let _e211 = phi_378_;
                                    let _e216 = bitcast<u32>((_e127.member_1[1] - _e127.member[1]));
                                    let _e222 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e216)), 32u, (_e216 == 0u)));
                                    let _e225 = (select(21u, _e222, (_e222 > 21u)) - 21u);
                                    let _e230 = (_e154.member[1][0] - _e127.member[1]);
                                    let _e231 = (_e154.member[1][1] - _e127.member[1]);
                                    let _e232 = (_e127.member_1[1] - _e154.member[1][2]);
                                    let _e233 = (_e127.member_1[1] - _e154.member[1][3]);
                                    let _e234 = (_e230 > _e231);
                                    if (_e234 == _e161) {
                                        let _e237 = (_e225 & 31u);
                                        phi_415_ = ((select(_e231, _e230, _e234) >> bitcast<u32>(_e237)) << bitcast<u32>(_e237));
                                    } else {
                                        phi_415_ = 0i;
                                    }
                                    let _e243 = phi_415_;
                                    let _e245 = (_e232 > _e233);
                                    if (_e245 == _e161) {
                                        let _e248 = (_e225 & 31u);
                                        phi_430_ = ((select(_e233, _e232, _e245) >> bitcast<u32>(_e248)) << bitcast<u32>(_e248));
                                    } else {
                                        phi_430_ = 0i;
                                    }
                                    let _e254 = phi_430_;
                                    let _e259 = bitcast<u32>((_e127.member_1[2] - _e127.member[2]));
                                    let _e265 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e259)), 32u, (_e259 == 0u)));
                                    let _e268 = (select(21u, _e265, (_e265 > 21u)) - 21u);
                                    let _e273 = (_e154.member[2][0] - _e127.member[2]);
                                    let _e274 = (_e154.member[2][1] - _e127.member[2]);
                                    let _e275 = (_e127.member_1[2] - _e154.member[2][2]);
                                    let _e276 = (_e127.member_1[2] - _e154.member[2][3]);
                                    let _e277 = (_e273 > _e274);
                                    if (_e277 == _e161) {
                                        let _e280 = (_e268 & 31u);
                                        phi_467_ = ((select(_e274, _e273, _e277) >> bitcast<u32>(_e280)) << bitcast<u32>(_e280));
                                    } else {
                                        phi_467_ = 0i;
                                    }
                                    let _e286 = phi_467_;
                                    let _e288 = (_e275 > _e276);
                                    if (_e288 == _e161) {
                                        let _e291 = (_e268 & 31u);
                                        phi_482_ = ((select(_e276, _e275, _e288) >> bitcast<u32>(_e291)) << bitcast<u32>(_e291));
                                    } else {
                                        phi_482_ = 0i;
                                    }
                                    let _e297 = phi_482_;
                                    phi_491_ = type_29(array<i32, 3>((_e127.member[0] + _e200), (_e127.member[1] + _e243), (_e127.member[2] + _e286)), array<i32, 3>((_e127.member_1[0] - _e211), (_e127.member_1[1] - _e254), (_e127.member_1[2] - _e297)));
                                    phi_492_ = select(_e154.member_2, _e154.member_1, _e161);
                                }
                                let _e304 = phi_491_;
                                let _e306 = phi_492_;
                                phi_264_ = _e304;
                                phi_266_ = _e306;
                                phi_494_ = select(true, false, _e148);
                            } else {
                                phi_264_ = type_29();
                                phi_266_ = u32();
                                phi_494_ = false;
                            }
                            let _e309 = phi_264_;
                            let _e311 = phi_266_;
                            let _e313 = phi_494_;
                            continue;
                            continuing {
                                phi_260_ = _e142;
                                phi_263_ = _e309;
                                phi_265_ = _e311;
                                phi_1464_ = false;
                                break if !(_e313);
                            }
                        }
                        let _e316 = phi_1464_;
                        if _e316 {
                            break;
                        }
                        if _e85 {
                        } else {
                            break;
                        }
                        let _e318 = local;
                        let _e321 = local_1;
                        let _e333 = global_4.member[_e80].member[0u];
                        let _e335 = bitcast<u32>((_e321.member_1[0] - _e318.member[0]));
                        let _e341 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e335)), 32u, (_e335 == 0u)));
                        let _e349 = (_e333[0] - _e318.member[0]);
                        let _e350 = (_e333[1] - _e318.member[0]);
                        let _e351 = (_e321.member_1[0] - _e333[2]);
                        let _e352 = (_e321.member_1[0] - _e333[3]);
                        let _e353 = (_e349 > _e350);
                        let _e356 = ((select(21u, _e341, (_e341 > 21u)) - 21u) & 31u);
                        let _e363 = (((bitcast<u32>(select(_e350, _e349, _e353)) >> bitcast<u32>(_e356)) & 2097151u) | (select(0u, 1u, _e353) << bitcast<u32>(21u)));
                        let _e364 = (_e351 > _e352);
                        let _e373 = (((bitcast<u32>(select(_e352, _e351, _e364)) >> bitcast<u32>(_e356)) & 2097151u) | (select(0u, 1u, _e364) << bitcast<u32>(21u)));
                        let _e378 = global_4.member[_e80].member[1u];
                        let _e380 = bitcast<u32>((_e321.member_1[1] - _e318.member[1]));
                        let _e386 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e380)), 32u, (_e380 == 0u)));
                        let _e394 = (_e378[0] - _e318.member[1]);
                        let _e395 = (_e378[1] - _e318.member[1]);
                        let _e396 = (_e321.member_1[1] - _e378[2]);
                        let _e397 = (_e321.member_1[1] - _e378[3]);
                        let _e398 = (_e394 > _e395);
                        let _e401 = ((select(21u, _e386, (_e386 > 21u)) - 21u) & 31u);
                        let _e408 = (((bitcast<u32>(select(_e395, _e394, _e398)) >> bitcast<u32>(_e401)) & 2097151u) | (select(0u, 1u, _e398) << bitcast<u32>(21u)));
                        let _e409 = (_e396 > _e397);
                        let _e418 = (((bitcast<u32>(select(_e397, _e396, _e409)) >> bitcast<u32>(_e401)) & 2097151u) | (select(0u, 1u, _e409) << bitcast<u32>(21u)));
                        let _e423 = global_4.member[_e80].member[2u];
                        let _e425 = bitcast<u32>((_e321.member_1[2] - _e318.member[2]));
                        let _e431 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e425)), 32u, (_e425 == 0u)));
                        let _e439 = (_e423[0] - _e318.member[2]);
                        let _e440 = (_e423[1] - _e318.member[2]);
                        let _e441 = (_e321.member_1[2] - _e423[2]);
                        let _e442 = (_e321.member_1[2] - _e423[3]);
                        let _e443 = (_e439 > _e440);
                        let _e446 = ((select(21u, _e431, (_e431 > 21u)) - 21u) & 31u);
                        let _e453 = (((bitcast<u32>(select(_e440, _e439, _e443)) >> bitcast<u32>(_e446)) & 2097151u) | (select(0u, 1u, _e443) << bitcast<u32>(21u)));
                        let _e454 = (_e441 > _e442);
                        let _e463 = (((bitcast<u32>(select(_e442, _e441, _e454)) >> bitcast<u32>(_e446)) & 2097151u) | (select(0u, 1u, _e454) << bitcast<u32>(21u)));
                        let _e468 = (_e318.member[0] + bitcast<i32>(((_e363 & 2097151u) << bitcast<u32>(_e356))));
                        let _e473 = (_e321.member_1[0] - bitcast<i32>(((_e373 & 2097151u) << bitcast<u32>(_e356))));
                        let _e477 = (((_e363 >> bitcast<u32>(21u)) & 1u) == 1u);
                        let _e481 = (((_e373 >> bitcast<u32>(21u)) & 1u) == 1u);
                        let _e482 = select(_e318.member[0], _e468, _e477);
                        let _e483 = select(_e468, _e318.member[0], _e477);
                        let _e490 = (_e318.member[1] + bitcast<i32>(((_e408 & 2097151u) << bitcast<u32>(_e401))));
                        let _e495 = (_e321.member_1[1] - bitcast<i32>(((_e418 & 2097151u) << bitcast<u32>(_e401))));
                        let _e499 = (((_e408 >> bitcast<u32>(21u)) & 1u) == 1u);
                        let _e503 = (((_e418 >> bitcast<u32>(21u)) & 1u) == 1u);
                        let _e504 = select(_e318.member[1], _e490, _e499);
                        let _e505 = select(_e490, _e318.member[1], _e499);
                        let _e512 = (_e318.member[2] + bitcast<i32>(((_e453 & 2097151u) << bitcast<u32>(_e446))));
                        let _e517 = (_e321.member_1[2] - bitcast<i32>(((_e463 & 2097151u) << bitcast<u32>(_e446))));
                        let _e521 = (((_e453 >> bitcast<u32>(21u)) & 1u) == 1u);
                        let _e525 = (((_e463 >> bitcast<u32>(21u)) & 1u) == 1u);
                        let _e526 = select(_e318.member[2], _e512, _e521);
                        let _e527 = select(_e512, _e318.member[2], _e521);
                        if _e86 {
                        } else {
                            break;
                        }
                        global_8.member[_e80] = array<u32, 7>(0u, _e363, _e373, _e408, _e418, _e453, _e463);
                        if _e85 {
                        } else {
                            break;
                        }
                        let _e536 = global_4.member[_e80].member_1;
                        let _e545 = ((bitcast<u32>((select(_e321.member_1[0], _e473, _e481) - _e482)) | bitcast<u32>((select(_e321.member_1[1], _e495, _e503) - _e504))) | bitcast<u32>((select(_e321.member_1[2], _e517, _e525) - _e526)));
                        if (_e545 < 1024u) {
                            phi_1156_ = 0u;
                        } else {
                            phi_1156_ = select(2u, 1u, (_e545 < 2097152u));
                        }
                        let _e550 = phi_1156_;
                        switch bitcast<i32>(_e550) {
                            case 0: {
                                phi_1162_ = 1u;
                                break;
                            }
                            case 1: {
                                phi_1162_ = 2u;
                                break;
                            }
                            case 2: {
                                phi_1162_ = 3u;
                                break;
                            }
                            default: {
                                phi_1162_ = u32();
                                break;
                            }
                        }
                        let _e553 = phi_1162_;
                        let _e555 = ((3u * _e553) + 1u);
                        if ((_e536 & 2147483648u) != 0u) {
                            phi_1173_ = ((_e536 >> bitcast<u32>(28u)) & 7u);
                        } else {
                            phi_1173_ = 0u;
                        }
                        let _e563 = phi_1173_;
                        phi_1176_ = type_8(0u, _e563);
                        loop {
                            let _e566 = phi_1176_;
                            if (_e566.member < _e566.member_1) {
                                phi_1177_ = type_8((_e566.member + 1u), _e566.member_1);
                                phi_1200_ = type_8(1u, _e566.member);
                            } else {
                                phi_1177_ = _e566;
                                phi_1200_ = type_8(0u, type_8().member_1);
                            }
                            let _e579 = phi_1177_;
                            let _e581 = phi_1200_;
                            let _e585 = (bitcast<i32>(_e581.member) != 0i);
                            if _e585 {
                                let _e587 = ((_e536 & 268435455u) + _e581.member_1);
                                let _e588 = (_e587 < _e46);
                                if _e588 {
                                    let _e589 = (_e587 < _e49);
                                    if _e589 {
                                        if _e588 {
                                        } else {
                                            phi_1497_ = true;
                                            break;
                                        }
                                        global_5.member[_e587] = type_37(array<i32, 3>(_e482, _e504, _e526), _e555);
                                        if _e589 {
                                        } else {
                                            phi_1497_ = true;
                                            break;
                                        }
                                        global_6.member[_e587] = _e555;
                                    }
                                }
                            }
                            continue;
                            continuing {
                                phi_1176_ = _e579;
                                phi_1497_ = _e316;
                                break if !(_e585);
                            }
                        }
                        let _e594 = phi_1497_;
                        if _e594 {
                            break;
                        }
                        if _e85 {
                        } else {
                            break;
                        }
                        let _e598 = global_4.member[_e80].member_2;
                        let _e607 = ((bitcast<u32>((select(_e473, _e321.member_1[0], _e481) - _e483)) | bitcast<u32>((select(_e495, _e321.member_1[1], _e503) - _e505))) | bitcast<u32>((select(_e517, _e321.member_1[2], _e525) - _e527)));
                        if (_e607 < 1024u) {
                            phi_1307_ = 0u;
                        } else {
                            phi_1307_ = select(2u, 1u, (_e607 < 2097152u));
                        }
                        let _e612 = phi_1307_;
                        switch bitcast<i32>(_e612) {
                            case 0: {
                                phi_1313_ = 1u;
                                break;
                            }
                            case 1: {
                                phi_1313_ = 2u;
                                break;
                            }
                            case 2: {
                                phi_1313_ = 3u;
                                break;
                            }
                            default: {
                                phi_1313_ = u32();
                                break;
                            }
                        }
                        let _e615 = phi_1313_;
                        let _e617 = ((3u * _e615) + 1u);
                        if ((_e598 & 2147483648u) != 0u) {
                            phi_1324_ = ((_e598 >> bitcast<u32>(28u)) & 7u);
                        } else {
                            phi_1324_ = 0u;
                        }
                        let _e625 = phi_1324_;
                        phi_1327_ = type_8(0u, _e625);
                        loop {
                            let _e628 = phi_1327_;
                            if (_e628.member < _e628.member_1) {
                                phi_1328_ = type_8((_e628.member + 1u), _e628.member_1);
                                phi_1351_ = type_8(1u, _e628.member);
                            } else {
                                phi_1328_ = _e628;
                                phi_1351_ = type_8(0u, type_8().member_1);
                            }
                            let _e641 = phi_1328_;
                            let _e643 = phi_1351_;
                            let _e647 = (bitcast<i32>(_e643.member) != 0i);
                            if _e647 {
                                let _e649 = ((_e598 & 268435455u) + _e643.member_1);
                                let _e650 = (_e649 < _e46);
                                if _e650 {
                                    let _e651 = (_e649 < _e49);
                                    if _e651 {
                                        if _e650 {
                                        } else {
                                            phi_1552_ = true;
                                            break;
                                        }
                                        global_5.member[_e649] = type_37(array<i32, 3>(_e483, _e505, _e527), _e617);
                                        if _e651 {
                                        } else {
                                            phi_1552_ = true;
                                            break;
                                        }
                                        global_6.member[_e649] = _e617;
                                    }
                                }
                            }
                            continue;
                            continuing {
                                phi_1327_ = _e641;
                                phi_1552_ = _e594;
                                break if !(_e647);
                            }
                        }
                        let _e656 = phi_1552_;
                        if _e656 {
                            break;
                        }
                        if (_e80 == 0u) {
                            if (_e52 == 0u) {
                            } else {
                                if (0u < _e52) {
                                } else {
                                    break;
                                }
                                global_7.member[0u] = type_23(array<u32, 4>(bitcast<u32>(_e318.member[0]), bitcast<u32>(_e318.member[1]), bitcast<u32>(_e318.member[2]), bitcast<u32>(_e76)), array<u32, 4>(bitcast<u32>(_e321.member_1[0]), bitcast<u32>(_e321.member_1[1]), bitcast<u32>(_e321.member_1[2]), 0u));
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
