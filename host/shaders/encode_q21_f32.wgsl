struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_9 {
    member: vec4<u32>,
}

struct type_14 {
    member: array<array<i32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_16 {
    member: array<type_14>,
}

struct type_19 {
    member: array<u32, 4>,
    member_1: array<u32, 4>,
}

struct type_21 {
    member: array<type_19>,
}

struct type_24 {
    member: array<i32, 3>,
    member_1: array<i32, 3>,
}

struct type_29 {
    member: array<array<u32, 7>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_9;
@group(0) @binding(1) 
var<storage> global_2: type_16;
@group(0) @binding(3) 
var<storage, read_write> global_3: type_21;
@group(0) @binding(2) 
var<storage, read_write> global_4: type_29;

fn function_() {
    var phi_139_: type_14;
    var phi_191_: type_4;
    var phi_194_: type_24;
    var phi_196_: u32;
    var phi_192_: type_4;
    var phi_219_: type_4;
    var phi_241_: type_14;
    var phi_250_: bool;
    var phi_294_: i32;
    var phi_309_: i32;
    var phi_346_: i32;
    var phi_361_: i32;
    var phi_398_: i32;
    var phi_413_: i32;
    var phi_422_: type_24;
    var phi_423_: u32;
    var phi_195_: type_24;
    var phi_197_: u32;
    var phi_425_: bool;
    var phi_1425_: bool;
    var local: type_24;
    var local_1: type_24;
    var phi_855_: u32;
    var phi_857_: u32;
    var phi_858_: bool;
    var phi_874_: u32;
    var phi_876_: u32;
    var phi_877_: bool;
    var phi_882_: u32;
    var phi_910_: u32;
    var phi_925_: u32;
    var phi_940_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e37 = global;
            let _e39 = arrayLength((&global_2.member));
            let _e43 = arrayLength((&global_3.member));
            let _e47 = (_e37.x + (_e37.y * 2097152u));
            let _e50 = global_1.member[0u];
            if (_e47 < _e50) {
                let _e52 = (_e47 < _e39);
                if _e52 {
                    let _e53 = (_e47 < arrayLength((&global_4.member)));
                    if _e53 {
                        let _e54 = (0u < _e39);
                        if _e54 {
                            if _e54 {
                            } else {
                                break;
                            }
                            let _e57 = global_2.member[0u];
                            phi_139_ = _e57;
                        } else {
                            phi_139_ = type_14(array<array<i32, 4>, 3>(array<i32, 4>(0i, 0i, 0i, 0i), array<i32, 4>(0i, 0i, 0i, 0i), array<i32, 4>(0i, 0i, 0i, 0i)), 2147483648u, 2147483648u, 0u, 0u);
                        }
                        let _e59 = phi_139_;
                        phi_191_ = type_4(0u, 128u);
                        phi_194_ = type_24(array<i32, 3>(select(_e59.member[0][0], _e59.member[0][1], (_e59.member[0][1] < _e59.member[0][0])), select(_e59.member[1][0], _e59.member[1][1], (_e59.member[1][1] < _e59.member[1][0])), select(_e59.member[2][0], _e59.member[2][1], (_e59.member[2][1] < _e59.member[2][0]))), array<i32, 3>(select(_e59.member[0][3], _e59.member[0][2], (_e59.member[0][3] < _e59.member[0][2])), select(_e59.member[1][3], _e59.member[1][2], (_e59.member[1][3] < _e59.member[1][2])), select(_e59.member[2][3], _e59.member[2][2], (_e59.member[2][3] < _e59.member[2][2]))));
                        phi_196_ = 0u;
                        loop {
                            let _e92 = phi_191_;
                            let _e94 = phi_194_;
                            let _e96 = phi_196_;
                            local = _e94;
                            local_1 = _e94;
                            if (_e92.member < _e92.member_1) {
                                phi_192_ = type_4((_e92.member + 1u), _e92.member_1);
                                phi_219_ = type_4(1u, _e92.member);
                            } else {
                                phi_192_ = _e92;
                                phi_219_ = type_4(0u, type_4().member_1);
                            }
                            let _e109 = phi_192_;
                            let _e111 = phi_219_;
                            if (bitcast<i32>(_e111.member) != 0i) {
                                let _e115 = (_e96 == _e47);
                                if _e115 {
                                    phi_422_ = type_24();
                                    phi_423_ = u32();
                                } else {
                                    let _e116 = (_e96 < _e39);
                                    if _e116 {
                                        if _e116 {
                                        } else {
                                            phi_1425_ = true;
                                            break;
                                        }
                                        let _e119 = global_2.member[_e96];
                                        phi_241_ = _e119;
                                    } else {
                                        phi_241_ = type_14(array<array<i32, 4>, 3>(array<i32, 4>(0i, 0i, 0i, 0i), array<i32, 4>(0i, 0i, 0i, 0i), array<i32, 4>(0i, 0i, 0i, 0i)), 2147483648u, 2147483648u, 0u, 0u);
                                    }
                                    let _e121 = phi_241_;
                                    if ((_e121.member_1 & 2147483648u) != 0u) {
                                        phi_250_ = false;
                                    } else {
                                        phi_250_ = (_e47 <= _e121.member_1);
                                    }
                                    let _e128 = phi_250_;
                                    let _e140 = bitcast<u32>((_e94.member_1[0] - _e94.member[0]));
                                    let _e146 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e140)), 32u, (_e140 == 0u)));
                                    let _e149 = (select(21u, _e146, (_e146 > 21u)) - 21u);
                                    let _e154 = (_e121.member[0][0] - _e94.member[0]);
                                    let _e155 = (_e121.member[0][1] - _e94.member[0]);
                                    let _e156 = (_e94.member_1[0] - _e121.member[0][2]);
                                    let _e157 = (_e94.member_1[0] - _e121.member[0][3]);
                                    let _e158 = (_e154 > _e155);
                                    if (_e158 == _e128) {
                                        let _e161 = (_e149 & 31u);
                                        phi_294_ = ((select(_e155, _e154, _e158) >> bitcast<u32>(_e161)) << bitcast<u32>(_e161));
                                    } else {
                                        phi_294_ = 0i;
                                    }
                                    let _e167 = phi_294_;
                                    let _e169 = (_e156 > _e157);
                                    if (_e169 == _e128) {
                                        let _e172 = (_e149 & 31u);
                                        phi_309_ = ((select(_e157, _e156, _e169) >> bitcast<u32>(_e172)) << bitcast<u32>(_e172));
                                    } else {
                                        phi_309_ = 0i;
                                    }
                                    let _e178 = phi_309_;
                                    let _e183 = bitcast<u32>((_e94.member_1[1] - _e94.member[1]));
                                    let _e189 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e183)), 32u, (_e183 == 0u)));
                                    let _e192 = (select(21u, _e189, (_e189 > 21u)) - 21u);
                                    let _e197 = (_e121.member[1][0] - _e94.member[1]);
                                    let _e198 = (_e121.member[1][1] - _e94.member[1]);
                                    let _e199 = (_e94.member_1[1] - _e121.member[1][2]);
                                    let _e200 = (_e94.member_1[1] - _e121.member[1][3]);
                                    let _e201 = (_e197 > _e198);
                                    if (_e201 == _e128) {
                                        let _e204 = (_e192 & 31u);
                                        phi_346_ = ((select(_e198, _e197, _e201) >> bitcast<u32>(_e204)) << bitcast<u32>(_e204));
                                    } else {
                                        phi_346_ = 0i;
                                    }
                                    let _e210 = phi_346_;
                                    let _e212 = (_e199 > _e200);
                                    if (_e212 == _e128) {
                                        let _e215 = (_e192 & 31u);
                                        phi_361_ = ((select(_e200, _e199, _e212) >> bitcast<u32>(_e215)) << bitcast<u32>(_e215));
                                    } else {
                                        phi_361_ = 0i;
                                    }
                                    let _e221 = phi_361_;
                                    let _e226 = bitcast<u32>((_e94.member_1[2] - _e94.member[2]));
                                    let _e232 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e226)), 32u, (_e226 == 0u)));
                                    let _e235 = (select(21u, _e232, (_e232 > 21u)) - 21u);
                                    let _e240 = (_e121.member[2][0] - _e94.member[2]);
                                    let _e241 = (_e121.member[2][1] - _e94.member[2]);
                                    let _e242 = (_e94.member_1[2] - _e121.member[2][2]);
                                    let _e243 = (_e94.member_1[2] - _e121.member[2][3]);
                                    let _e244 = (_e240 > _e241);
                                    if (_e244 == _e128) {
                                        let _e247 = (_e235 & 31u);
                                        phi_398_ = ((select(_e241, _e240, _e244) >> bitcast<u32>(_e247)) << bitcast<u32>(_e247));
                                    } else {
                                        phi_398_ = 0i;
                                    }
                                    let _e253 = phi_398_;
                                    let _e255 = (_e242 > _e243);
                                    if (_e255 == _e128) {
                                        let _e258 = (_e235 & 31u);
                                        phi_413_ = ((select(_e243, _e242, _e255) >> bitcast<u32>(_e258)) << bitcast<u32>(_e258));
                                    } else {
                                        phi_413_ = 0i;
                                    }
                                    let _e264 = phi_413_;
                                    phi_422_ = type_24(array<i32, 3>((_e94.member[0] + _e167), (_e94.member[1] + _e210), (_e94.member[2] + _e253)), array<i32, 3>((_e94.member_1[0] - _e178), (_e94.member_1[1] - _e221), (_e94.member_1[2] - _e264)));
                                    phi_423_ = select(_e121.member_2, _e121.member_1, _e128);
                                }
                                let _e271 = phi_422_;
                                let _e273 = phi_423_;
                                phi_195_ = _e271;
                                phi_197_ = _e273;
                                phi_425_ = select(true, false, _e115);
                            } else {
                                phi_195_ = type_24();
                                phi_197_ = u32();
                                phi_425_ = false;
                            }
                            let _e276 = phi_195_;
                            let _e278 = phi_197_;
                            let _e280 = phi_425_;
                            continue;
                            continuing {
                                phi_191_ = _e109;
                                phi_194_ = _e276;
                                phi_196_ = _e278;
                                phi_1425_ = false;
                                break if !(_e280);
                            }
                        }
                        let _e283 = phi_1425_;
                        if _e283 {
                            break;
                        }
                        if _e52 {
                        } else {
                            break;
                        }
                        let _e285 = local;
                        let _e288 = local_1;
                        let _e300 = global_2.member[_e47].member[0u];
                        let _e302 = bitcast<u32>((_e288.member_1[0] - _e285.member[0]));
                        let _e308 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e302)), 32u, (_e302 == 0u)));
                        let _e316 = (_e300[0] - _e285.member[0]);
                        let _e317 = (_e300[1] - _e285.member[0]);
                        let _e318 = (_e288.member_1[0] - _e300[2]);
                        let _e319 = (_e288.member_1[0] - _e300[3]);
                        let _e320 = (_e316 > _e317);
                        let _e323 = ((select(21u, _e308, (_e308 > 21u)) - 21u) & 31u);
                        let _e331 = (_e318 > _e319);
                        let _e345 = global_2.member[_e47].member[1u];
                        let _e347 = bitcast<u32>((_e288.member_1[1] - _e285.member[1]));
                        let _e353 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e347)), 32u, (_e347 == 0u)));
                        let _e361 = (_e345[0] - _e285.member[1]);
                        let _e362 = (_e345[1] - _e285.member[1]);
                        let _e363 = (_e288.member_1[1] - _e345[2]);
                        let _e364 = (_e288.member_1[1] - _e345[3]);
                        let _e365 = (_e361 > _e362);
                        let _e368 = ((select(21u, _e353, (_e353 > 21u)) - 21u) & 31u);
                        let _e376 = (_e363 > _e364);
                        let _e390 = global_2.member[_e47].member[2u];
                        let _e392 = bitcast<u32>((_e288.member_1[2] - _e285.member[2]));
                        let _e398 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e392)), 32u, (_e392 == 0u)));
                        let _e406 = (_e390[0] - _e285.member[2]);
                        let _e407 = (_e390[1] - _e285.member[2]);
                        let _e408 = (_e288.member_1[2] - _e390[2]);
                        let _e409 = (_e288.member_1[2] - _e390[3]);
                        let _e410 = (_e406 > _e407);
                        let _e413 = ((select(21u, _e398, (_e398 > 21u)) - 21u) & 31u);
                        let _e421 = (_e408 > _e409);
                        if _e52 {
                        } else {
                            break;
                        }
                        let _e434 = global_2.member[_e47].member_1;
                        if _e52 {
                        } else {
                            break;
                        }
                        let _e438 = global_2.member[_e47].member_2;
                        let _e440 = ((_e434 & 2147483648u) != 0u);
                        if _e440 {
                            let _e444 = (((_e434 >> bitcast<u32>(28u)) & 7u) > 0u);
                            if _e444 {
                                phi_855_ = (_e434 & 268435455u);
                            } else {
                                phi_855_ = u32();
                            }
                            let _e447 = phi_855_;
                            phi_857_ = _e447;
                            phi_858_ = select(true, false, _e444);
                        } else {
                            phi_857_ = u32();
                            phi_858_ = true;
                        }
                        let _e450 = phi_857_;
                        let _e452 = phi_858_;
                        if _e452 {
                            if ((_e438 & 2147483648u) != 0u) {
                                let _e458 = (((_e438 >> bitcast<u32>(28u)) & 7u) > 0u);
                                if _e458 {
                                    phi_874_ = (_e438 & 268435455u);
                                } else {
                                    phi_874_ = u32();
                                }
                                let _e461 = phi_874_;
                                phi_876_ = _e461;
                                phi_877_ = select(true, false, _e458);
                            } else {
                                phi_876_ = u32();
                                phi_877_ = true;
                            }
                            let _e464 = phi_876_;
                            let _e466 = phi_877_;
                            phi_882_ = select(_e464, 0u, _e466);
                        } else {
                            phi_882_ = _e450;
                        }
                        let _e469 = phi_882_;
                        if _e52 {
                        } else {
                            break;
                        }
                        if _e52 {
                        } else {
                            break;
                        }
                        if _e440 {
                            phi_910_ = select(_e438, 0u, ((_e438 & 2147483648u) != 0u));
                        } else {
                            phi_910_ = _e434;
                        }
                        let _e474 = phi_910_;
                        if _e440 {
                            let _e477 = ((_e434 >> bitcast<u32>(28u)) & 7u);
                            phi_925_ = select(_e477, 7u, (_e477 == 0u));
                        } else {
                            phi_925_ = 0u;
                        }
                        let _e481 = phi_925_;
                        if ((_e438 & 2147483648u) != 0u) {
                            let _e486 = ((_e438 >> bitcast<u32>(28u)) & 7u);
                            phi_940_ = select(_e486, 7u, (_e486 == 0u));
                        } else {
                            phi_940_ = 0u;
                        }
                        let _e490 = phi_940_;
                        let _e503 = ((_e469 & 268435455u) | ((_e490 >> bitcast<u32>(1i)) << bitcast<u32>(28u)));
                        if _e53 {
                        } else {
                            break;
                        }
                        global_4.member[_e47] = array<u32, 7>((((_e474 & 268435455u) | (_e481 << bitcast<u32>(28u))) | (_e490 << bitcast<u32>(31i))), (((bitcast<u32>(select(_e317, _e316, _e320)) >> bitcast<u32>(_e323)) & 2097151u) | (select(0u, 1u, _e320) << bitcast<u32>(21u))), ((((bitcast<u32>(select(_e319, _e318, _e331)) >> bitcast<u32>(_e323)) & 2097151u) | (select(0u, 1u, _e331) << bitcast<u32>(21u))) | (_e503 << bitcast<u32>(22i))), (((bitcast<u32>(select(_e362, _e361, _e365)) >> bitcast<u32>(_e368)) & 2097151u) | (select(0u, 1u, _e365) << bitcast<u32>(21u))), ((((bitcast<u32>(select(_e364, _e363, _e376)) >> bitcast<u32>(_e368)) & 2097151u) | (select(0u, 1u, _e376) << bitcast<u32>(21u))) | ((_e503 >> bitcast<u32>(10u)) << bitcast<u32>(22i))), (((bitcast<u32>(select(_e407, _e406, _e410)) >> bitcast<u32>(_e413)) & 2097151u) | (select(0u, 1u, _e410) << bitcast<u32>(21u))), ((((bitcast<u32>(select(_e409, _e408, _e421)) >> bitcast<u32>(_e413)) & 2097151u) | (select(0u, 1u, _e421) << bitcast<u32>(21u))) | ((_e503 >> bitcast<u32>(20u)) << bitcast<u32>(22i))));
                        if (_e47 == 0u) {
                            if (_e43 == 0u) {
                            } else {
                                if (0u < _e43) {
                                } else {
                                    break;
                                }
                                global_3.member[0u] = type_19(array<u32, 4>(bitcast<u32>(_e285.member[0]), bitcast<u32>(_e285.member[1]), bitcast<u32>(_e285.member[2]), 4294967272u), array<u32, 4>(bitcast<u32>(_e288.member_1[0]), bitcast<u32>(_e288.member_1[1]), bitcast<u32>(_e288.member_1[2]), 0u));
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
fn encode_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
