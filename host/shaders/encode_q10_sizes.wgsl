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

struct type_37 {
    member: array<type_32>,
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
var<storage, read_write> global_6: type_37;
@group(0) @binding(6) 
var<storage, read_write> global_7: type_4;
@group(0) @binding(7) 
var<storage, read_write> global_8: type_28;

fn function_() {
    var phi_163_: i32;
    var phi_164_: i32;
    var phi_210_: type_21;
    var phi_261_: type_8;
    var phi_264_: type_32;
    var phi_266_: u32;
    var phi_262_: type_8;
    var phi_289_: type_8;
    var phi_311_: type_21;
    var phi_320_: bool;
    var phi_364_: i32;
    var phi_379_: i32;
    var phi_416_: i32;
    var phi_431_: i32;
    var phi_468_: i32;
    var phi_483_: i32;
    var phi_492_: type_32;
    var phi_493_: u32;
    var phi_265_: type_32;
    var phi_267_: u32;
    var phi_495_: bool;
    var phi_1417_: bool;
    var local: type_32;
    var local_1: type_32;
    var local_2: type_32;
    var phi_1153_: u32;
    var phi_1159_: u32;
    var phi_1166_: type_8;
    var phi_1167_: type_8;
    var phi_1190_: type_8;
    var phi_1450_: bool;
    var phi_1510_: bool;
    var phi_1286_: u32;
    var phi_1292_: u32;
    var phi_1299_: type_8;
    var phi_1300_: type_8;
    var phi_1323_: type_8;
    var phi_1503_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e40 = global;
            let _e42 = arrayLength((&global_4.member));
            let _e50 = arrayLength((&global_7.member));
            let _e53 = arrayLength((&global_8.member));
            let _e56 = global_3.member[1u];
            if (_e56 == 0u) {
                let _e74 = global_3.member[0u];
                phi_164_ = bitcast<i32>(_e74);
            } else {
                let _e60 = global_3.member[0u];
                let _e64 = global_2.member[0u];
                let _e66 = (bitcast<i32>(_e60) + bitcast<i32>(_e64));
                if (_e66 < -126i) {
                    phi_163_ = -126i;
                } else {
                    phi_163_ = select(_e66, 127i, (_e66 > 127i));
                }
                let _e71 = phi_163_;
                phi_164_ = _e71;
            }
            let _e77 = phi_164_;
            let _e81 = (_e40.x + (_e40.y * 2097152u));
            let _e84 = global_1.member[0u];
            if (_e81 < _e84) {
                let _e86 = (_e81 < _e42);
                if _e86 {
                    let _e87 = (_e81 < arrayLength((&global_5.member)));
                    if _e87 {
                        let _e88 = (_e81 < arrayLength((&global_6.member)));
                        if _e88 {
                            let _e89 = (0u < _e42);
                            if _e89 {
                                if _e89 {
                                } else {
                                    break;
                                }
                                let _e92 = global_4.member[0u];
                                phi_210_ = _e92;
                            } else {
                                phi_210_ = type_21(array<array<i32, 4>, 3>(array<i32, 4>(0i, 0i, 0i, 0i), array<i32, 4>(0i, 0i, 0i, 0i), array<i32, 4>(0i, 0i, 0i, 0i)), 2147483648u, 2147483648u, 0u, 0u);
                            }
                            let _e94 = phi_210_;
                            phi_261_ = type_8(0u, 128u);
                            phi_264_ = type_32(array<i32, 3>(select(_e94.member[0][0], _e94.member[0][1], (_e94.member[0][1] < _e94.member[0][0])), select(_e94.member[1][0], _e94.member[1][1], (_e94.member[1][1] < _e94.member[1][0])), select(_e94.member[2][0], _e94.member[2][1], (_e94.member[2][1] < _e94.member[2][0]))), array<i32, 3>(select(_e94.member[0][3], _e94.member[0][2], (_e94.member[0][3] < _e94.member[0][2])), select(_e94.member[1][3], _e94.member[1][2], (_e94.member[1][3] < _e94.member[1][2])), select(_e94.member[2][3], _e94.member[2][2], (_e94.member[2][3] < _e94.member[2][2]))));
                            phi_266_ = 0u;
                            loop {
                                let _e129 = phi_261_;
                                let _e131 = phi_264_;
                                let _e133 = phi_266_;
                                local = _e131;
                                local_1 = _e131;
                                local_2 = _e131;
                                if (_e129.member < _e129.member_1) {
                                    phi_262_ = type_8((_e129.member + 1u), _e129.member_1);
                                    phi_289_ = type_8(1u, _e129.member);
                                } else {
                                    phi_262_ = _e129;
                                    phi_289_ = type_8(0u, type_8().member_1);
                                }
                                let _e146 = phi_262_;
                                let _e148 = phi_289_;
                                if (bitcast<i32>(_e148.member) != 0i) {
                                    let _e152 = (_e133 == _e81);
                                    if _e152 {
                                        phi_492_ = type_32();
                                        phi_493_ = u32();
                                    } else {
                                        let _e153 = (_e133 < _e42);
                                        if _e153 {
                                            if _e153 {
                                            } else {
                                                phi_1417_ = true;
                                                break;
                                            }
                                            let _e156 = global_4.member[_e133];
                                            phi_311_ = _e156;
                                        } else {
                                            phi_311_ = type_21(array<array<i32, 4>, 3>(array<i32, 4>(0i, 0i, 0i, 0i), array<i32, 4>(0i, 0i, 0i, 0i), array<i32, 4>(0i, 0i, 0i, 0i)), 2147483648u, 2147483648u, 0u, 0u);
                                        }
                                        let _e158 = phi_311_;
                                        if ((_e158.member_1 & 2147483648u) != 0u) {
                                            phi_320_ = false;
                                        } else {
                                            phi_320_ = (_e81 <= _e158.member_1);
                                        }
                                        let _e165 = phi_320_;
                                        let _e177 = bitcast<u32>((_e131.member_1[0] - _e131.member[0]));
                                        let _e183 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e177)), 32u, (_e177 == 0u)));
                                        let _e186 = (select(10u, _e183, (_e183 > 10u)) - 10u);
                                        let _e191 = (_e158.member[0][0] - _e131.member[0]);
                                        let _e192 = (_e158.member[0][1] - _e131.member[0]);
                                        let _e193 = (_e131.member_1[0] - _e158.member[0][2]);
                                        let _e194 = (_e131.member_1[0] - _e158.member[0][3]);
                                        let _e195 = (_e191 > _e192);
                                        if (_e195 == _e165) {
                                            let _e198 = (_e186 & 31u);
                                            phi_364_ = ((select(_e192, _e191, _e195) >> bitcast<u32>(_e198)) << bitcast<u32>(_e198));
                                        } else {
                                            phi_364_ = 0i;
                                        }
                                        let _e204 = phi_364_;
                                        let _e206 = (_e193 > _e194);
                                        if (_e206 == _e165) {
                                            let _e209 = (_e186 & 31u);
                                            phi_379_ = ((select(_e194, _e193, _e206) >> bitcast<u32>(_e209)) << bitcast<u32>(_e209));
                                        } else {
                                            phi_379_ = 0i;
                                        }
                                        let _e215 = phi_379_;
                                        let _e220 = bitcast<u32>((_e131.member_1[1] - _e131.member[1]));
                                        let _e226 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e220)), 32u, (_e220 == 0u)));
                                        let _e229 = (select(10u, _e226, (_e226 > 10u)) - 10u);
                                        let _e234 = (_e158.member[1][0] - _e131.member[1]);
                                        let _e235 = (_e158.member[1][1] - _e131.member[1]);
                                        let _e236 = (_e131.member_1[1] - _e158.member[1][2]);
                                        let _e237 = (_e131.member_1[1] - _e158.member[1][3]);
                                        let _e238 = (_e234 > _e235);
                                        if (_e238 == _e165) {
                                            let _e241 = (_e229 & 31u);
                                            phi_416_ = ((select(_e235, _e234, _e238) >> bitcast<u32>(_e241)) << bitcast<u32>(_e241));
                                        } else {
                                            phi_416_ = 0i;
                                        }
                                        let _e247 = phi_416_;
                                        let _e249 = (_e236 > _e237);
                                        if (_e249 == _e165) {
                                            let _e252 = (_e229 & 31u);
                                            phi_431_ = ((select(_e237, _e236, _e249) >> bitcast<u32>(_e252)) << bitcast<u32>(_e252));
                                        } else {
                                            phi_431_ = 0i;
                                        }
                                        let _e258 = phi_431_;
                                        let _e263 = bitcast<u32>((_e131.member_1[2] - _e131.member[2]));
                                        let _e269 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e263)), 32u, (_e263 == 0u)));
                                        let _e272 = (select(10u, _e269, (_e269 > 10u)) - 10u);
                                        let _e277 = (_e158.member[2][0] - _e131.member[2]);
                                        let _e278 = (_e158.member[2][1] - _e131.member[2]);
                                        let _e279 = (_e131.member_1[2] - _e158.member[2][2]);
                                        let _e280 = (_e131.member_1[2] - _e158.member[2][3]);
                                        let _e281 = (_e277 > _e278);
                                        if (_e281 == _e165) {
                                            let _e284 = (_e272 & 31u);
                                            phi_468_ = ((select(_e278, _e277, _e281) >> bitcast<u32>(_e284)) << bitcast<u32>(_e284));
                                        } else {
                                            phi_468_ = 0i;
                                        }
                                        let _e290 = phi_468_;
                                        let _e292 = (_e279 > _e280);
                                        if (_e292 == _e165) {
                                            let _e295 = (_e272 & 31u);
                                            phi_483_ = ((select(_e280, _e279, _e292) >> bitcast<u32>(_e295)) << bitcast<u32>(_e295));
                                        } else {
                                            phi_483_ = 0i;
                                        }
                                        let _e301 = phi_483_;
                                        phi_492_ = type_32(array<i32, 3>((_e131.member[0] + _e204), (_e131.member[1] + _e247), (_e131.member[2] + _e290)), array<i32, 3>((_e131.member_1[0] - _e215), (_e131.member_1[1] - _e258), (_e131.member_1[2] - _e301)));
                                        phi_493_ = select(_e158.member_2, _e158.member_1, _e165);
                                    }
                                    let _e308 = phi_492_;
                                    let _e310 = phi_493_;
                                    phi_265_ = _e308;
                                    phi_267_ = _e310;
                                    phi_495_ = select(true, false, _e152);
                                } else {
                                    phi_265_ = type_32();
                                    phi_267_ = u32();
                                    phi_495_ = false;
                                }
                                let _e313 = phi_265_;
                                let _e315 = phi_267_;
                                let _e317 = phi_495_;
                                continue;
                                continuing {
                                    phi_261_ = _e146;
                                    phi_264_ = _e313;
                                    phi_266_ = _e315;
                                    phi_1417_ = false;
                                    break if !(_e317);
                                }
                            }
                            let _e320 = phi_1417_;
                            if _e320 {
                                break;
                            }
                            if _e86 {
                            } else {
                                break;
                            }
                            let _e322 = local;
                            let _e325 = local_1;
                            let _e337 = global_4.member[_e81].member[0u];
                            let _e339 = bitcast<u32>((_e325.member_1[0] - _e322.member[0]));
                            let _e345 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e339)), 32u, (_e339 == 0u)));
                            let _e353 = (_e337[0] - _e322.member[0]);
                            let _e354 = (_e337[1] - _e322.member[0]);
                            let _e355 = (_e325.member_1[0] - _e337[2]);
                            let _e356 = (_e325.member_1[0] - _e337[3]);
                            let _e357 = (_e353 > _e354);
                            let _e360 = ((select(10u, _e345, (_e345 > 10u)) - 10u) & 31u);
                            let _e367 = (((bitcast<u32>(select(_e354, _e353, _e357)) >> bitcast<u32>(_e360)) & 1023u) | (select(0u, 1u, _e357) << bitcast<u32>(10u)));
                            let _e368 = (_e355 > _e356);
                            let _e377 = (((bitcast<u32>(select(_e356, _e355, _e368)) >> bitcast<u32>(_e360)) & 1023u) | (select(0u, 1u, _e368) << bitcast<u32>(10u)));
                            let _e382 = global_4.member[_e81].member[1u];
                            let _e384 = bitcast<u32>((_e325.member_1[1] - _e322.member[1]));
                            let _e390 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e384)), 32u, (_e384 == 0u)));
                            let _e398 = (_e382[0] - _e322.member[1]);
                            let _e399 = (_e382[1] - _e322.member[1]);
                            let _e400 = (_e325.member_1[1] - _e382[2]);
                            let _e401 = (_e325.member_1[1] - _e382[3]);
                            let _e402 = (_e398 > _e399);
                            let _e405 = ((select(10u, _e390, (_e390 > 10u)) - 10u) & 31u);
                            let _e412 = (((bitcast<u32>(select(_e399, _e398, _e402)) >> bitcast<u32>(_e405)) & 1023u) | (select(0u, 1u, _e402) << bitcast<u32>(10u)));
                            let _e413 = (_e400 > _e401);
                            let _e422 = (((bitcast<u32>(select(_e401, _e400, _e413)) >> bitcast<u32>(_e405)) & 1023u) | (select(0u, 1u, _e413) << bitcast<u32>(10u)));
                            let _e427 = global_4.member[_e81].member[2u];
                            let _e429 = bitcast<u32>((_e325.member_1[2] - _e322.member[2]));
                            let _e435 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e429)), 32u, (_e429 == 0u)));
                            let _e443 = (_e427[0] - _e322.member[2]);
                            let _e444 = (_e427[1] - _e322.member[2]);
                            let _e445 = (_e325.member_1[2] - _e427[2]);
                            let _e446 = (_e325.member_1[2] - _e427[3]);
                            let _e447 = (_e443 > _e444);
                            let _e450 = ((select(10u, _e435, (_e435 > 10u)) - 10u) & 31u);
                            let _e457 = (((bitcast<u32>(select(_e444, _e443, _e447)) >> bitcast<u32>(_e450)) & 1023u) | (select(0u, 1u, _e447) << bitcast<u32>(10u)));
                            let _e458 = (_e445 > _e446);
                            let _e467 = (((bitcast<u32>(select(_e446, _e445, _e458)) >> bitcast<u32>(_e450)) & 1023u) | (select(0u, 1u, _e458) << bitcast<u32>(10u)));
                            let _e481 = (_e322.member[0] + bitcast<i32>(((_e367 & 1023u) << bitcast<u32>(_e360))));
                            let _e486 = (_e325.member_1[0] - bitcast<i32>(((_e377 & 1023u) << bitcast<u32>(_e360))));
                            let _e490 = (((_e367 >> bitcast<u32>(10u)) & 1u) == 1u);
                            let _e494 = (((_e377 >> bitcast<u32>(10u)) & 1u) == 1u);
                            let _e503 = (_e322.member[1] + bitcast<i32>(((_e412 & 1023u) << bitcast<u32>(_e405))));
                            let _e508 = (_e325.member_1[1] - bitcast<i32>(((_e422 & 1023u) << bitcast<u32>(_e405))));
                            let _e512 = (((_e412 >> bitcast<u32>(10u)) & 1u) == 1u);
                            let _e516 = (((_e422 >> bitcast<u32>(10u)) & 1u) == 1u);
                            let _e525 = (_e322.member[2] + bitcast<i32>(((_e457 & 1023u) << bitcast<u32>(_e450))));
                            let _e530 = (_e325.member_1[2] - bitcast<i32>(((_e467 & 1023u) << bitcast<u32>(_e450))));
                            let _e534 = (((_e457 >> bitcast<u32>(10u)) & 1u) == 1u);
                            let _e538 = (((_e467 >> bitcast<u32>(10u)) & 1u) == 1u);
                            if _e87 {
                            } else {
                                break;
                            }
                            global_5.member[_e81] = array<u32, 4>(0u, (_e367 | (_e377 << bitcast<u32>(11u))), (_e412 | (_e422 << bitcast<u32>(11u))), (_e457 | (_e467 << bitcast<u32>(11u))));
                            if _e88 {
                            } else {
                                break;
                            }
                            let _e548 = local_2;
                            global_6.member[_e81] = _e548;
                            if _e86 {
                            } else {
                                break;
                            }
                            let _e552 = global_4.member[_e81].member_1;
                            if ((_e552 & 2147483648u) != 0u) {
                                let _e562 = ((bitcast<u32>((select(_e325.member_1[0], _e486, _e494) - select(_e322.member[0], _e481, _e490))) | bitcast<u32>((select(_e325.member_1[1], _e508, _e516) - select(_e322.member[1], _e503, _e512)))) | bitcast<u32>((select(_e325.member_1[2], _e530, _e538) - select(_e322.member[2], _e525, _e534))));
                                if (_e562 < 1024u) {
                                    phi_1153_ = 0u;
                                } else {
                                    phi_1153_ = select(2u, 1u, (_e562 < 2097152u));
                                }
                                let _e567 = phi_1153_;
                                switch bitcast<i32>(_e567) {
                                    case 0: {
                                        phi_1159_ = 1u;
                                        break;
                                    }
                                    case 1: {
                                        phi_1159_ = 2u;
                                        break;
                                    }
                                    case 2: {
                                        phi_1159_ = 3u;
                                        break;
                                    }
                                    default: {
                                        phi_1159_ = u32();
                                        break;
                                    }
                                }
                                let _e570 = phi_1159_;
                                phi_1166_ = type_8(0u, ((_e552 >> bitcast<u32>(28u)) & 7u));
                                loop {
                                    let _e578 = phi_1166_;
                                    if (_e578.member < _e578.member_1) {
                                        phi_1167_ = type_8((_e578.member + 1u), _e578.member_1);
                                        phi_1190_ = type_8(1u, _e578.member);
                                    } else {
                                        phi_1167_ = _e578;
                                        phi_1190_ = type_8(0u, type_8().member_1);
                                    }
                                    let _e591 = phi_1167_;
                                    let _e593 = phi_1190_;
                                    let _e597 = (bitcast<i32>(_e593.member) != 0i);
                                    if _e597 {
                                        let _e599 = ((_e552 & 268435455u) + _e593.member_1);
                                        let _e600 = (_e599 < _e50);
                                        if _e600 {
                                            if _e600 {
                                            } else {
                                                phi_1450_ = true;
                                                break;
                                            }
                                            global_7.member[_e599] = ((3u * _e570) + 1u);
                                        }
                                    }
                                    continue;
                                    continuing {
                                        phi_1166_ = _e591;
                                        phi_1450_ = _e320;
                                        break if !(_e597);
                                    }
                                }
                                let _e604 = phi_1450_;
                                if _e604 {
                                    break;
                                }
                                phi_1510_ = _e604;
                            } else {
                                phi_1510_ = _e320;
                            }
                            let _e606 = phi_1510_;
                            if _e86 {
                            } else {
                                break;
                            }
                            let _e610 = global_4.member[_e81].member_2;
                            if ((_e610 & 2147483648u) != 0u) {
                                let _e620 = ((bitcast<u32>((select(_e486, _e325.member_1[0], _e494) - select(_e481, _e322.member[0], _e490))) | bitcast<u32>((select(_e508, _e325.member_1[1], _e516) - select(_e503, _e322.member[1], _e512)))) | bitcast<u32>((select(_e530, _e325.member_1[2], _e538) - select(_e525, _e322.member[2], _e534))));
                                if (_e620 < 1024u) {
                                    phi_1286_ = 0u;
                                } else {
                                    phi_1286_ = select(2u, 1u, (_e620 < 2097152u));
                                }
                                let _e625 = phi_1286_;
                                switch bitcast<i32>(_e625) {
                                    case 0: {
                                        phi_1292_ = 1u;
                                        break;
                                    }
                                    case 1: {
                                        phi_1292_ = 2u;
                                        break;
                                    }
                                    case 2: {
                                        phi_1292_ = 3u;
                                        break;
                                    }
                                    default: {
                                        phi_1292_ = u32();
                                        break;
                                    }
                                }
                                let _e628 = phi_1292_;
                                phi_1299_ = type_8(0u, ((_e610 >> bitcast<u32>(28u)) & 7u));
                                loop {
                                    let _e636 = phi_1299_;
                                    if (_e636.member < _e636.member_1) {
                                        phi_1300_ = type_8((_e636.member + 1u), _e636.member_1);
                                        phi_1323_ = type_8(1u, _e636.member);
                                    } else {
                                        phi_1300_ = _e636;
                                        phi_1323_ = type_8(0u, type_8().member_1);
                                    }
                                    let _e649 = phi_1300_;
                                    let _e651 = phi_1323_;
                                    let _e655 = (bitcast<i32>(_e651.member) != 0i);
                                    if _e655 {
                                        let _e657 = ((_e610 & 268435455u) + _e651.member_1);
                                        let _e658 = (_e657 < _e50);
                                        if _e658 {
                                            if _e658 {
                                            } else {
                                                phi_1503_ = true;
                                                break;
                                            }
                                            global_7.member[_e657] = ((3u * _e628) + 1u);
                                        }
                                    }
                                    continue;
                                    continuing {
                                        phi_1299_ = _e649;
                                        phi_1503_ = _e606;
                                        break if !(_e655);
                                    }
                                }
                                let _e662 = phi_1503_;
                                if _e662 {
                                    break;
                                }
                            }
                            if (_e81 == 0u) {
                                if (_e53 == 0u) {
                                } else {
                                    if (0u < _e53) {
                                    } else {
                                        break;
                                    }
                                    global_8.member[0u] = type_26(array<u32, 4>(bitcast<u32>(_e322.member[0]), bitcast<u32>(_e322.member[1]), bitcast<u32>(_e322.member[2]), bitcast<u32>(_e77)), array<u32, 4>(bitcast<u32>(_e325.member_1[0]), bitcast<u32>(_e325.member_1[1]), bitcast<u32>(_e325.member_1[2]), 0u));
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
fn encode_q10_sizes(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
