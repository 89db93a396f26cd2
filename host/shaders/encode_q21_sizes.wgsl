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

struct type_38 {
    member: array<type_29>,
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
var<storage, read_write> global_5: type_38;
@group(0) @binding(6) 
var<storage, read_write> global_6: type_4;
@group(0) @binding(7) 
var<storage, read_write> global_7: type_25;
@group(0) @binding(4) 
var<storage, read_write> global_8: type_34;

fn function_() {
    var phi_164_: i32;
    var phi_165_: i32;
    var phi_211_: type_18;
    var phi_262_: type_8;
    var phi_265_: type_29;
    var phi_267_: u32;
    var phi_263_: type_8;
    var phi_290_: type_8;
    var phi_312_: type_18;
    var phi_321_: bool;
    var phi_365_: i32;
    var phi_380_: i32;
    var phi_417_: i32;
    var phi_432_: i32;
    var phi_469_: i32;
    var phi_484_: i32;
    var phi_493_: type_29;
    var phi_494_: u32;
    var phi_266_: type_29;
    var phi_268_: u32;
    var phi_496_: bool;
    var phi_1436_: bool;
    var local: type_29;
    var local_1: type_29;
    var local_2: type_29;
    var phi_1163_: u32;
    var phi_1169_: u32;
    var phi_1176_: type_8;
    var phi_1177_: type_8;
    var phi_1200_: type_8;
    var phi_1469_: bool;
    var phi_1529_: bool;
    var phi_1296_: u32;
    var phi_1302_: u32;
    var phi_1309_: type_8;
    var phi_1310_: type_8;
    var phi_1333_: type_8;
    var phi_1522_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e39 = global;
            let _e41 = arrayLength((&global_4.member));
            let _e49 = arrayLength((&global_6.member));
            let _e52 = arrayLength((&global_7.member));
            let _e55 = global_3.member[1u];
            if (_e55 == 0u) {
                let _e73 = global_3.member[0u];
                phi_165_ = bitcast<i32>(_e73);
            } else {
                let _e59 = global_3.member[0u];
                let _e63 = global_2.member[0u];
                let _e65 = (bitcast<i32>(_e59) + bitcast<i32>(_e63));
                if (_e65 < -126i) {
                    phi_164_ = -126i;
                } else {
                    phi_164_ = select(_e65, 127i, (_e65 > 127i));
                }
                let _e70 = phi_164_;
                phi_165_ = _e70;
            }
            let _e76 = phi_165_;
            let _e80 = (_e39.x + (_e39.y * 2097152u));
            let _e83 = global_1.member[0u];
            if (_e80 < _e83) {
                let _e85 = (_e80 < _e41);
                if _e85 {
                    let _e86 = (_e80 < arrayLength((&global_8.member)));
                    if _e86 {
                        let _e87 = (_e80 < arrayLength((&global_5.member)));
                        if _e87 {
                            let _e88 = (0u < _e41);
                            if _e88 {
                                if _e88 {
                                } else {
                                    break;
                                }
                                let _e91 = global_4.member[0u];
                                phi_211_ = _e91;
                            } else {
                                phi_211_ = type_18(array<array<i32, 4>, 3>(array<i32, 4>(0i, 0i, 0i, 0i), array<i32, 4>(0i, 0i, 0i, 0i), array<i32, 4>(0i, 0i, 0i, 0i)), 2147483648u, 2147483648u, 0u, 0u);
                            }
                            let _e93 = phi_211_;
                            phi_262_ = type_8(0u, 128u);
                            phi_265_ = type_29(array<i32, 3>(select(_e93.member[0][0], _e93.member[0][1], (_e93.member[0][1] < _e93.member[0][0])), select(_e93.member[1][0], _e93.member[1][1], (_e93.member[1][1] < _e93.member[1][0])), select(_e93.member[2][0], _e93.member[2][1], (_e93.member[2][1] < _e93.member[2][0]))), array<i32, 3>(select(_e93.member[0][3], _e93.member[0][2], (_e93.member[0][3] < _e93.member[0][2])), select(_e93.member[1][3], _e93.member[1][2], (_e93.member[1][3] < _e93.member[1][2])), select(_e93.member[2][3], _e93.member[2][2], (_e93.member[2][3] < _e93.member[2][2]))));
                            phi_267_ = 0u;
                            loop {
                                let _e128 = phi_262_;
                                let _e130 = phi_265_;
                                let _e132 = phi_267_;
                                local = _e130;
                                local_1 = _e130;
                                local_2 = _e130;
                                if (_e128.member < _e128.member_1) {
                                    phi_263_ = type_8((_e128.member + 1u), _e128.member_1);
                                    phi_290_ = type_8(1u, _e128.member);
                                } else {
                                    phi_263_ = _e128;
                                    phi_290_ = type_8(0u, type_8().member_1);
                                }
                                let _e145 = phi_263_;
                                let _e147 = phi_290_;
                                if (bitcast<i32>(_e147.member) != 0i) {
                                    let _e151 = (_e132 == _e80);
                                    if _e151 {
                                        phi_493_ = type_29();
                                        phi_494_ = u32();
                                    } else {
                                        let _e152 = (_e132 < _e41);
                                        if _e152 {
                                            if _e152 {
                                            } else {
                                                phi_1436_ = true;
                                                break;
                                            }
                                            let _e155 = global_4.member[_e132];
                                            phi_312_ = _e155;
                                        } else {
                                            phi_312_ = type_18(array<array<i32, 4>, 3>(array<i32, 4>(0i, 0i, 0i, 0i), array<i32, 4>(0i, 0i, 0i, 0i), array<i32, 4>(0i, 0i, 0i, 0i)), 2147483648u, 2147483648u, 0u, 0u);
                                        }
                                        let _e157 = phi_312_;
                                        if ((_e157.member_1 & 2147483648u) != 0u) {
                                            phi_321_ = false;
                                        } else {
                                            phi_321_ = (_e80 <= _e157.member_1);
                                        }
                                        let _e164 = phi_321_;
                                        let _e176 = bitcast<u32>((_e130.member_1[0] - _e130.member[0]));
                                        let _e182 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e176)), 32u, (_e176 == 0u)));
                                        let _e185 = (select(21u, _e182, (_e182 > 21u)) - 21u);
                                        let _e190 = (_e157.member[0][0] - _e130.member[0]);
                                        let _e191 = (_e157.member[0][1] - _e130.member[0]);
                                        let _e192 = (_e130.member_1[0] - _e157.member[0][2]);
                                        let _e193 = (_e130.member_1[0] - _e157.member[0][3]);
                                        let _e194 = (_e190 > _e191);
                                        if (_e194 == _e164) {
                                            let _e197 = (_e185 & 31u);
                                            phi_365_ = ((select(_e191, _e190, _e194) >> bitcast<u32>(_e197)) << bitcast<u32>(_e197));
                                        } else {
                                            phi_365_ = 0i;
                                        }
                                        let _e203 = phi_365_;
                                        let _e205 = (_e192 > _e193);
                                        if (_e205 == _e164) {
                                            let _e208 = (_e185 & 31u);
                                            phi_380_ = ((select(_e193, _e192, _e205) >> bitcast<u32>(_e208)) << bitcast<u32>(_e208));
                                        } else {
                                            phi_380_ = 0i;
                                        }
                                        let _e214 = phi_380_;
                                        let _e219 = bitcast<u32>((_e130.member_1[1] - _e130.member[1]));
                                        let _e225 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e219)), 32u, (_e219 == 0u)));
                                        let _e228 = (select(21u, _e225, (_e225 > 21u)) - 21u);
                                        let _e233 = (_e157.member[1][0] - _e130.member[1]);
                                        let _e234 = (_e157.member[1][1] - _e130.member[1]);
                                        let _e235 = (_e130.member_1[1] - _e157.member[1][2]);
                                        let _e236 = (_e130.member_1[1] - _e157.member[1][3]);
                                        let _e237 = (_e233 > _e234);
                                        if (_e237 == _e164) {
                                            let _e240 = (_e228 & 31u);
                                            phi_417_ = ((select(_e234, _e233, _e237) >> bitcast<u32>(_e240)) << bitcast<u32>(_e240));
                                        } else {
                                            phi_417_ = 0i;
                                        }
                                        let _e246 = phi_417_;
                                        let _e248 = (_e235 > _e236);
                                        if (_e248 == _e164) {
                                            let _e251 = (_e228 & 31u);
                                            phi_432_ = ((select(_e236, _e235, _e248) >> bitcast<u32>(_e251)) << bitcast<u32>(_e251));
                                        } else {
                                            phi_432_ = 0i;
                                        }
                                        let _e257 = phi_432_;
                                        let _e262 = bitcast<u32>((_e130.member_1[2] - _e130.member[2]));
                                        let _e268 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e262)), 32u, (_e262 == 0u)));
                                        let _e271 = (select(21u, _e268, (_e268 > 21u)) - 21u);
                                        let _e276 = (_e157.member[2][0] - _e130.member[2]);
                                        let _e277 = (_e157.member[2][1] - _e130.member[2]);
                                        let _e278 = (_e130.member_1[2] - _e157.member[2][2]);
                                        let _e279 = (_e130.member_1[2] - _e157.member[2][3]);
                                        let _e280 = (_e276 > _e277);
                                        if (_e280 == _e164) {
                                            let _e283 = (_e271 & 31u);
                                            phi_469_ = ((select(_e277, _e276, _e280) >> bitcast<u32>(_e283)) << bitcast<u32>(_e283));
                                        } else {
                                            phi_469_ = 0i;
                                        }
                                        let _e289 = phi_469_;
                                        let _e291 = (_e278 > _e279);
                                        if (_e291 == _e164) {
                                            let _e294 = (_e271 & 31u);
                                            phi_484_ = ((select(_e279, _e278, _e291) >> bitcast<u32>(_e294)) << bitcast<u32>(_e294));
                                        } else {
                                            phi_484_ = 0i;
                                        }
                                        let _e300 = phi_484_;
                                        phi_493_ = type_29(array<i32, 3>((_e130.member[0] + _e203), (_e130.member[1] + _e246), (_e130.member[2] + _e289)), array<i32, 3>((_e130.member_1[0] - _e214), (_e130.member_1[1] - _e257), (_e130.member_1[2] - _e300)));
                                        phi_494_ = select(_e157.member_2, _e157.member_1, _e164);
                                    }
                                    let _e307 = phi_493_;
                                    let _e309 = phi_494_;
                                    phi_266_ = _e307;
                                    phi_268_ = _e309;
                                    phi_496_ = select(true, false, _e151);
                                } else {
                                    phi_266_ = type_29();
                                    phi_268_ = u32();
                                    phi_496_ = false;
                                }
                                let _e312 = phi_266_;
                                let _e314 = phi_268_;
                                let _e316 = phi_496_;
                                continue;
                                continuing {
                                    phi_262_ = _e145;
                                    phi_265_ = _e312;
                                    phi_267_ = _e314;
                                    phi_1436_ = false;
                                    break if !(_e316);
                                }
                            }
                            let _e319 = phi_1436_;
                            if _e319 {
                                break;
                            }
                            if _e85 {
                            } else {
                                break;
                            }
                            let _e321 = local;
                            let _e324 = local_1;
                            let _e336 = global_4.member[_e80].member[0u];
                            let _e338 = bitcast<u32>((_e324.member_1[0] - _e321.member[0]));
                            let _e344 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e338)), 32u, (_e338 == 0u)));
                            let _e352 = (_e336[0] - _e321.member[0]);
                            let _e353 = (_e336[1] - _e321.member[0]);
                            let _e354 = (_e324.member_1[0] - _e336[2]);
                            let _e355 = (_e324.member_1[0] - _e336[3]);
                            let _e356 = (_e352 > _e353);
                            let _e359 = ((select(21u, _e344, (_e344 > 21u)) - 21u) & 31u);
                            let _e366 = (((bitcast<u32>(select(_e353, _e352, _e356)) >> bitcast<u32>(_e359)) & 2097151u) | (select(0u, 1u, _e356) << bitcast<u32>(21u)));
                            let _e367 = (_e354 > _e355);
                            let _e376 = (((bitcast<u32>(select(_e355, _e354, _e367)) >> bitcast<u32>(_e359)) & 2097151u) | (select(0u, 1u, _e367) << bitcast<u32>(21u)));
                            let _e381 = global_4.member[_e80].member[1u];
                            let _e383 = bitcast<u32>((_e324.member_1[1] - _e321.member[1]));
                            let _e389 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e383)), 32u, (_e383 == 0u)));
                            let _e397 = (_e381[0] - _e321.member[1]);
                            let _e398 = (_e381[1] - _e321.member[1]);
                            let _e399 = (_e324.member_1[1] - _e381[2]);
                            let _e400 = (_e324.member_1[1] - _e381[3]);
                            let _e401 = (_e397 > _e398);
                            let _e404 = ((select(21u, _e389, (_e389 > 21u)) - 21u) & 31u);
                            let _e411 = (((bitcast<u32>(select(_e398, _e397, _e401)) >> bitcast<u32>(_e404)) & 2097151u) | (select(0u, 1u, _e401) << bitcast<u32>(21u)));
                            let _e412 = (_e399 > _e400);
                            let _e421 = (((bitcast<u32>(select(_e400, _e399, _e412)) >> bitcast<u32>(_e404)) & 2097151u) | (select(0u, 1u, _e412) << bitcast<u32>(21u)));
                            let _e426 = global_4.member[_e80].member[2u];
                            let _e428 = bitcast<u32>((_e324.member_1[2] - _e321.member[2]));
                            let _e434 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e428)), 32u, (_e428 == 0u)));
                            let _e442 = (_e426[0] - _e321.member[2]);
                            let _e443 = (_e426[1] - _e321.member[2]);
                            let _e444 = (_e324.member_1[2] - _e426[2]);
                            let _e445 = (_e324.member_1[2] - _e426[3]);
                            let _e446 = (_e442 > _e443);
                            let _e449 = ((select(21u, _e434, (_e434 > 21u)) - 21u) & 31u);
                            let _e456 = (((bitcast<u32>(select(_e443, _e442, _e446)) >> bitcast<u32>(_e449)) & 2097151u) | (select(0u, 1u, _e446) << bitcast<u32>(21u)));
                            let _e457 = (_e444 > _e445);
                            let _e466 = (((bitcast<u32>(select(_e445, _e444, _e457)) >> bitcast<u32>(_e449)) & 2097151u) | (select(0u, 1u, _e457) << bitcast<u32>(21u)));
                            let _e471 = (_e321.member[0] + bitcast<i32>(((_e366 & 2097151u) << bitcast<u32>(_e359))));
                            let _e476 = (_e324.member_1[0] - bitcast<i32>(((_e376 & 2097151u) << bitcast<u32>(_e359))));
                            let _e480 = (((_e366 >> bitcast<u32>(21u)) & 1u) == 1u);
                            let _e484 = (((_e376 >> bitcast<u32>(21u)) & 1u) == 1u);
                            let _e493 = (_e321.member[1] + bitcast<i32>(((_e411 & 2097151u) << bitcast<u32>(_e404))));
                            let _e498 = (_e324.member_1[1] - bitcast<i32>(((_e421 & 2097151u) << bitcast<u32>(_e404))));
                            let _e502 = (((_e411 >> bitcast<u32>(21u)) & 1u) == 1u);
                            let _e506 = (((_e421 >> bitcast<u32>(21u)) & 1u) == 1u);
                            let _e515 = (_e321.member[2] + bitcast<i32>(((_e456 & 2097151u) << bitcast<u32>(_e449))));
                            let _e520 = (_e324.member_1[2] - bitcast<i32>(((_e466 & 2097151u) << bitcast<u32>(_e449))));
                            let _e524 = (((_e456 >> bitcast<u32>(21u)) & 1u) == 1u);
                            let _e528 = (((_e466 >> bitcast<u32>(21u)) & 1u) == 1u);
                            if _e86 {
                            } else {
                                break;
                            }
                            global_8.member[_e80] = array<u32, 7>(0u, _e366, _e376, _e411, _e421, _e456, _e466);
                            if _e87 {
                            } else {
                                break;
                            }
                            let _e538 = local_2;
                            global_5.member[_e80] = _e538;
                            if _e85 {
                            } else {
                                break;
                            }
                            let _e542 = global_4.member[_e80].member_1;
                            if ((_e542 & 2147483648u) != 0u) {
                                let _e552 = ((bitcast<u32>((select(_e324.member_1[0], _e476, _e484) - select(_e321.member[0], _e471, _e480))) | bitcast<u32>((select(_e324.member_1[1], _e498, _e506) - select(_e321.member[1], _e493, _e502)))) | bitcast<u32>((select(_e324.member_1[2], _e520, _e528) - select(_e321.member[2], _e515, _e524))));
                                if (_e552 < 1024u) {
                                    phi_1163_ = 0u;
                                } else {
                                    phi_1163_ = select(2u, 1u, (_e552 < 2097152u));
                                }
                                let _e557 = phi_1163_;
                                switch bitcast<i32>(_e557) {
                                    case 0: {
                                        phi_1169_ = 1u;
                                        break;
                                    }
                                    case 1: {
                                        phi_1169_ = 2u;
                                        break;
                                    }
                                    case 2: {
                                        phi_1169_ = 3u;
                                        break;
                                    }
                                    default: {
                                        phi_1169_ = u32();
                                        break;
                                    }
                                }
                                let _e560 = phi_1169_;
                                phi_1176_ = type_8(0u, ((_e542 >> bitcast<u32>(28u)) & 7u));
                                loop {
                                    let _e568 = phi_1176_;
                                    if (_e568.member < _e568.member_1) {
                                        phi_1177_ = type_8((_e568.member + 1u), _e568.member_1);
                                        phi_1200_ = type_8(1u, _e568.member);
                                    } else {
                                        phi_1177_ = _e568;
                                        phi_1200_ = type_8(0u, type_8().member_1);
                                    }
                                    let _e581 = phi_1177_;
                                    let _e583 = phi_1200_;
                                    let _e587 = (bitcast<i32>(_e583.member) != 0i);
                                    if _e587 {
                                        let _e589 = ((_e542 & 268435455u) + _e583.member_1);
                                        let _e590 = (_e589 < _e49);
                                        if _e590 {
                                            if _e590 {
                                            } else {
                                                phi_1469_ = true;
                                                break;
                                            }
                                            global_6.member[_e589] = ((3u * _e560) + 1u);
                                        }
                                    }
                                    continue;
                                    continuing {
                                        phi_1176_ = _e581;
                                        phi_1469_ = _e319;
                                        break if !(_e587);
                                    }
                                }
                                let _e594 = phi_1469_;
                                if _e594 {
                                    break;
                                }
                                phi_1529_ = _e594;
                            } else {
                                phi_1529_ = _e319;
                            }
                            let _e596 = phi_1529_;
                            if _e85 {
                            } else {
                                break;
                            }
                            let _e600 = global_4.member[_e80].member_2;
                            if ((_e600 & 2147483648u) != 0u) {
                                let _e610 = ((bitcast<u32>((select(_e476, _e324.member_1[0], _e484) - select(_e471, _e321.member[0], _e480))) | bitcast<u32>((select(_e498, _e324.member_1[1], _e506) - select(_e493, _e321.member[1], _e502)))) | bitcast<u32>((select(_e520, _e324.member_1[2], _e528) - select(_e515, _e321.member[2], _e524))));
                                if (_e610 < 1024u) {
                                    phi_1296_ = 0u;
                                } else {
                                    phi_1296_ = select(2u, 1u, (_e610 < 2097152u));
                                }
                                let _e615 = phi_1296_;
                                switch bitcast<i32>(_e615) {
                                    case 0: {
                                        phi_1302_ = 1u;
                                        break;
                                    }
                                    case 1: {
                                        phi_1302_ = 2u;
                                        break;
                                    }
                                    case 2: {
                                        phi_1302_ = 3u;
                                        break;
                                    }
                                    default: {
                                        phi_1302_ = u32();
                                        break;
                                    }
                                }
                                let _e618 = phi_1302_;
                                phi_1309_ = type_8(0u, ((_e600 >> bitcast<u32>(28u)) & 7u));
                                loop {
                                    let _e626 = phi_1309_;
                                    if (_e626.member < _e626.member_1) {
                                        phi_1310_ = type_8((_e626.member + 1u), _e626.member_1);
                                        phi_1333_ = type_8(1u, _e626.member);
                                    } else {
                                        phi_1310_ = _e626;
                                        phi_1333_ = type_8(0u, type_8().member_1);
                                    }
                                    let _e639 = phi_1310_;
                                    let _e641 = phi_1333_;
                                    let _e645 = (bitcast<i32>(_e641.member) != 0i);
                                    if _e645 {
                                        let _e647 = ((_e600 & 268435455u) + _e641.member_1);
                                        let _e648 = (_e647 < _e49);
                                        if _e648 {
                                            if _e648 {
                                            } else {
                                                phi_1522_ = true;
                                                break;
                                            }
                                            global_6.member[_e647] = ((3u * _e618) + 1u);
                                        }
                                    }
                                    continue;
                                    continuing {
                                        phi_1309_ = _e639;
                                        phi_1522_ = _e596;
                                        break if !(_e645);
                                    }
                                }
                                let _e652 = phi_1522_;
                                if _e652 {
                                    break;
                                }
                            }
                            if (_e80 == 0u) {
                                if (_e52 == 0u) {
                                } else {
                                    if (0u < _e52) {
                                    } else {
                                        break;
                                    }
                                    global_7.member[0u] = type_23(array<u32, 4>(bitcast<u32>(_e321.member[0]), bitcast<u32>(_e321.member[1]), bitcast<u32>(_e321.member[2]), bitcast<u32>(_e76)), array<u32, 4>(bitcast<u32>(_e324.member_1[0]), bitcast<u32>(_e324.member_1[1]), bitcast<u32>(_e324.member_1[2]), 0u));
                                }
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
