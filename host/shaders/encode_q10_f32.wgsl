struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_9 {
    member: array<array<u32, 4>>,
}

struct type_12 {
    member: vec4<u32>,
}

struct type_17 {
    member: array<array<i32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_19 {
    member: array<type_17>,
}

struct type_22 {
    member: array<u32, 4>,
    member_1: array<u32, 4>,
}

struct type_24 {
    member: array<type_22>,
}

struct type_27 {
    member: array<i32, 3>,
    member_1: array<i32, 3>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<storage> global_2: type_19;
@group(0) @binding(2) 
var<storage, read_write> global_3: type_9;
@group(0) @binding(3) 
var<storage, read_write> global_4: type_24;

fn function_() {
    var phi_138_: type_17;
    var phi_189_: type_4;
    var phi_192_: type_27;
    var phi_194_: u32;
    var phi_190_: type_4;
    var phi_217_: type_4;
    var phi_239_: type_17;
    var phi_248_: bool;
    var phi_292_: i32;
    var phi_307_: i32;
    var phi_344_: i32;
    var phi_359_: i32;
    var phi_396_: i32;
    var phi_411_: i32;
    var phi_420_: type_27;
    var phi_421_: u32;
    var phi_193_: type_27;
    var phi_195_: u32;
    var phi_423_: bool;
    var phi_1414_: bool;
    var local: type_27;
    var local_1: type_27;
    var phi_850_: u32;
    var phi_852_: u32;
    var phi_853_: bool;
    var phi_869_: u32;
    var phi_871_: u32;
    var phi_872_: bool;
    var phi_877_: u32;
    var phi_905_: u32;
    var phi_920_: u32;
    var phi_935_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e37 = global;
            let _e39 = arrayLength((&global_2.member));
            let _e43 = arrayLength((&global_4.member));
            let _e47 = (_e37.x + (_e37.y * 2097152u));
            let _e50 = global_1.member[0u];
            if (_e47 < _e50) {
                let _e52 = (_e47 < _e39);
                if _e52 {
                    let _e53 = (_e47 < arrayLength((&global_3.member)));
                    if _e53 {
                        let _e54 = (0u < _e39);
                        if _e54 {
                            if _e54 {
                            } else {
                                break;
                            }
                            let _e57 = global_2.member[0u];
                            phi_138_ = _e57;
                        } else {
                            phi_138_ = type_17(array<array<i32, 4>, 3>(array<i32, 4>(0i, 0i, 0i, 0i), array<i32, 4>(0i, 0i, 0i, 0i), array<i32, 4>(0i, 0i, 0i, 0i)), 2147483648u, 2147483648u, 0u, 0u);
                        }
                        let _e59 = phi_138_;
                        phi_189_ = type_4(0u, 128u);
                        phi_192_ = type_27(array<i32, 3>(select(_e59.member[0][0], _e59.member[0][1], (_e59.member[0][1] < _e59.member[0][0])), select(_e59.member[1][0], _e59.member[1][1], (_e59.member[1][1] < _e59.member[1][0])), select(_e59.member[2][0], _e59.member[2][1], (_e59.member[2][1] < _e59.member[2][0]))), array<i32, 3>(select(_e59.member[0][3], _e59.member[0][2], (_e59.member[0][3] < _e59.member[0][2])), select(_e59.member[1][3], _e59.member[1][2], (_e59.member[1][3] < _e59.member[1][2])), select(_e59.member[2][3], _e59.member[2][2], (_e59.member[2][3] < _e59.member[2][2]))));
                        phi_194_ = 0u;
                        loop {
                            let _e94 = phi_189_;
                            let _e96 = phi_192_;
                            let _e98 = phi_194_;
                            local = _e96;
                            local_1 = _e96;
                            if (_e94.member < _e94.member_1) {
                                phi_190_ = type_4((_e94.member + 1u), _e94.member_1);
                                phi_217_ = type_4(1u, _e94.member);
                            } else {
                                phi_190_ = _e94;
                                phi_217_ = type_4(0u, type_4().member_1);
                            }
                            let _e111 = phi_190_;
                            let _e113 = phi_217_;
                            if (bitcast<i32>(_e113.member) != 0i) {
                                let _e117 = (_e98 == _e47);
                                if _e117 {
                                    phi_420_ = type_27();
                                    phi_421_ = u32();
                                } else {
                                    let _e118 = (_e98 < _e39);
                                    if _e118 {
                                        if _e118 {
                                        } else {
                                            phi_1414_ = true;
                                            break;
                                        }
                                        let _e121 = global_2.member[_e98];
                                        phi_239_ = _e121;
                                    } else {
                                        phi_239_ = type_17(array<array<i32, 4>, 3>(array<i32, 4>(0i, 0i, 0i, 0i), array<i32, 4>(0i, 0i, 0i, 0i), array<i32, 4>(0i, 0i, 0i, 0i)), 2147483648u, 2147483648u, 0u, 0u);
                                    }
                                    let _e123 = phi_239_;
                                    if ((_e123.member_1 & 2147483648u) != 0u) {
                                        phi_248_ = false;
                                    } else {
                                        phi_248_ = (_e47 <= _e123.member_1);
                                    }
                                    let _e130 = phi_248_;
                                    let _e142 = bitcast<u32>((_e96.member_1[0] - _e96.member[0]));
                                    let _e148 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e142)), 32u, (_e142 == 0u)));
                                    let _e151 = (select(10u, _e148, (_e148 > 10u)) - 10u);
                                    let _e156 = (_e123.member[0][0] - _e96.member[0]);
                                    let _e157 = (_e123.member[0][1] - _e96.member[0]);
                                    let _e158 = (_e96.member_1[0] - _e123.member[0][2]);
                                    let _e159 = (_e96.member_1[0] - _e123.member[0][3]);
                                    let _e160 = (_e156 > _e157);
                                    if (_e160 == _e130) {
                                        let _e163 = (_e151 & 31u);
                                        phi_292_ = ((select(_e157, _e156, _e160) >> bitcast<u32>(_e163)) << bitcast<u32>(_e163));
                                    } else {
                                        phi_292_ = 0i;
                                    }
                                    let _e169 = phi_292_;
                                    let _e171 = (_e158 > _e159);
                                    if (_e171 == _e130) {
                                        let _e174 = (_e151 & 31u);
                                        phi_307_ = ((select(_e159, _e158, _e171) >> bitcast<u32>(_e174)) << bitcast<u32>(_e174));
                                    } else {
                                        phi_307_ = 0i;
                                    }
                                    let _e180 = phi_307_;
                                    let _e185 = bitcast<u32>((_e96.member_1[1] - _e96.member[1]));
                                    let _e191 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e185)), 32u, (_e185 == 0u)));
                                    let _e194 = (select(10u, _e191, (_e191 > 10u)) - 10u);
                                    let _e199 = (_e123.member[1][0] - _e96.member[1]);
                                    let _e200 = (_e123.member[1][1] - _e96.member[1]);
                                    let _e201 = (_e96.member_1[1] - _e123.member[1][2]);
                                    let _e202 = (_e96.member_1[1] - _e123.member[1][3]);
                                    let _e203 = (_e199 > _e200);
                                    if (_e203 == _e130) {
                                        let _e206 = (_e194 & 31u);
                                        phi_344_ = ((select(_e200, _e199, _e203) >> bitcast<u32>(_e206)) << bitcast<u32>(_e206));
                                    } else {
                                        phi_344_ = 0i;
                                    }
                                    let _e212 = phi_344_;
                                    let _e214 = (_e201 > _e202);
                                    if (_e214 == _e130) {
                                        let _e217 = (_e194 & 31u);
                                        phi_359_ = ((select(_e202, _e201, _e214) >> bitcast<u32>(_e217)) << bitcast<u32>(_e217));
                                    } else {
                                        phi_359_ = 0i;
                                    }
                                    let _e223 = phi_359_;
                                    let _e228 = bitcast<u32>((_e96.member_1[2] - _e96.member[2]));
                                    let _e234 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e228)), 32u, (_e228 == 0u)));
                                    let _e237 = (select(10u, _e234, (_e234 > 10u)) - 10u);
                                    let _e242 = (_e123.member[2][0] - _e96.member[2]);
                                    let _e243 = (_e123.member[2][1] - _e96.member[2]);
                                    let _e244 = (_e96.member_1[2] - _e123.member[2][2]);
                                    let _e245 = (_e96.member_1[2] - _e123.member[2][3]);
                                    let _e246 = (_e242 > _e243);
                                    if (_e246 == _e130) {
                                        let _e249 = (_e237 & 31u);
                                        phi_396_ = ((select(_e243, _e242, _e246) >> bitcast<u32>(_e249)) << bitcast<u32>(_e249));
                                    } else {
                                        phi_396_ = 0i;
                                    }
                                    let _e255 = phi_396_;
                                    let _e257 = (_e244 > _e245);
                                    if (_e257 == _e130) {
                                        let _e260 = (_e237 & 31u);
                                        phi_411_ = ((select(_e245, _e244, _e257) >> bitcast<u32>(_e260)) << bitcast<u32>(_e260));
                                    } else {
                                        phi_411_ = 0i;
                                    }
                                    let _e266 = phi_411_;
                                    phi_420_ = type_27(array<i32, 3>((_e96.member[0] + _e169), (_e96.member[1] + _e212), (_e96.member[2] + _e255)), array<i32, 3>((_e96.member_1[0] - _e180), (_e96.member_1[1] - _e223), (_e96.member_1[2] - _e266)));
                                    phi_421_ = select(_e123.member_2, _e123.member_1, _e130);
                                }
                                let _e273 = phi_420_;
                                let _e275 = phi_421_;
                                phi_193_ = _e273;
                                phi_195_ = _e275;
                                phi_423_ = select(true, false, _e117);
                            } else {
                                phi_193_ = type_27();
                                phi_195_ = u32();
                                phi_423_ = false;
                            }
                            let _e278 = phi_193_;
                            let _e280 = phi_195_;
                            let _e282 = phi_423_;
                            continue;
                            continuing {
                                phi_189_ = _e111;
                                phi_192_ = _e278;
                                phi_194_ = _e280;
                                phi_1414_ = false;
                                break if !(_e282);
                            }
                        }
                        let _e285 = phi_1414_;
                        if _e285 {
                            break;
                        }
                        if _e52 {
                        } else {
                            break;
                        }
                        let _e287 = local;
                        let _e290 = local_1;
                        let _e302 = global_2.member[_e47].member[0u];
                        let _e304 = bitcast<u32>((_e290.member_1[0] - _e287.member[0]));
                        let _e310 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e304)), 32u, (_e304 == 0u)));
                        let _e318 = (_e302[0] - _e287.member[0]);
                        let _e319 = (_e302[1] - _e287.member[0]);
                        let _e320 = (_e290.member_1[0] - _e302[2]);
                        let _e321 = (_e290.member_1[0] - _e302[3]);
                        let _e322 = (_e318 > _e319);
                        let _e325 = ((select(10u, _e310, (_e310 > 10u)) - 10u) & 31u);
                        let _e333 = (_e320 > _e321);
                        let _e347 = global_2.member[_e47].member[1u];
                        let _e349 = bitcast<u32>((_e290.member_1[1] - _e287.member[1]));
                        let _e355 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e349)), 32u, (_e349 == 0u)));
                        let _e363 = (_e347[0] - _e287.member[1]);
                        let _e364 = (_e347[1] - _e287.member[1]);
                        let _e365 = (_e290.member_1[1] - _e347[2]);
                        let _e366 = (_e290.member_1[1] - _e347[3]);
                        let _e367 = (_e363 > _e364);
                        let _e370 = ((select(10u, _e355, (_e355 > 10u)) - 10u) & 31u);
                        let _e378 = (_e365 > _e366);
                        let _e392 = global_2.member[_e47].member[2u];
                        let _e394 = bitcast<u32>((_e290.member_1[2] - _e287.member[2]));
                        let _e400 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e394)), 32u, (_e394 == 0u)));
                        let _e408 = (_e392[0] - _e287.member[2]);
                        let _e409 = (_e392[1] - _e287.member[2]);
                        let _e410 = (_e290.member_1[2] - _e392[2]);
                        let _e411 = (_e290.member_1[2] - _e392[3]);
                        let _e412 = (_e408 > _e409);
                        let _e415 = ((select(10u, _e400, (_e400 > 10u)) - 10u) & 31u);
                        let _e423 = (_e410 > _e411);
                        if _e52 {
                        } else {
                            break;
                        }
                        let _e445 = global_2.member[_e47].member_1;
                        if _e52 {
                        } else {
                            break;
                        }
                        let _e449 = global_2.member[_e47].member_2;
                        let _e451 = ((_e445 & 2147483648u) != 0u);
                        if _e451 {
                            let _e455 = (((_e445 >> bitcast<u32>(28u)) & 7u) > 0u);
                            if _e455 {
                                phi_850_ = (_e445 & 268435455u);
                            } else {
                                phi_850_ = u32();
                            }
                            let _e458 = phi_850_;
                            phi_852_ = _e458;
                            phi_853_ = select(true, false, _e455);
                        } else {
                            phi_852_ = u32();
                            phi_853_ = true;
                        }
                        let _e461 = phi_852_;
                        let _e463 = phi_853_;
                        if _e463 {
                            if ((_e449 & 2147483648u) != 0u) {
                                let _e469 = (((_e449 >> bitcast<u32>(28u)) & 7u) > 0u);
                                if _e469 {
                                    phi_869_ = (_e449 & 268435455u);
                                } else {
                                    phi_869_ = u32();
                                }
                                let _e472 = phi_869_;
                                phi_871_ = _e472;
                                phi_872_ = select(true, false, _e469);
                            } else {
                                phi_871_ = u32();
                                phi_872_ = true;
                            }
                            let _e475 = phi_871_;
                            let _e477 = phi_872_;
                            phi_877_ = select(_e475, 0u, _e477);
                        } else {
                            phi_877_ = _e461;
                        }
                        let _e480 = phi_877_;
                        if _e52 {
                        } else {
                            break;
                        }
                        if _e52 {
                        } else {
                            break;
                        }
                        if _e451 {
                            phi_905_ = select(_e449, 0u, ((_e449 & 2147483648u) != 0u));
                        } else {
                            phi_905_ = _e445;
                        }
                        let _e485 = phi_905_;
                        if _e451 {
                            let _e488 = ((_e445 >> bitcast<u32>(28u)) & 7u);
                            phi_920_ = select(_e488, 7u, (_e488 == 0u));
                        } else {
                            phi_920_ = 0u;
                        }
                        let _e492 = phi_920_;
                        if ((_e449 & 2147483648u) != 0u) {
                            let _e497 = ((_e449 >> bitcast<u32>(28u)) & 7u);
                            phi_935_ = select(_e497, 7u, (_e497 == 0u));
                        } else {
                            phi_935_ = 0u;
                        }
                        let _e501 = phi_935_;
                        let _e514 = ((_e480 & 268435455u) | ((_e501 >> bitcast<u32>(1i)) << bitcast<u32>(28u)));
                        if _e53 {
                        } else {
                            break;
                        }
                        global_3.member[_e47] = array<u32, 4>((((_e485 & 268435455u) | (_e492 << bitcast<u32>(28u))) | (_e501 << bitcast<u32>(31i))), (((((bitcast<u32>(select(_e319, _e318, _e322)) >> bitcast<u32>(_e325)) & 1023u) | (select(0u, 1u, _e322) << bitcast<u32>(10u))) | ((((bitcast<u32>(select(_e321, _e320, _e333)) >> bitcast<u32>(_e325)) & 1023u) | (select(0u, 1u, _e333) << bitcast<u32>(10u))) << bitcast<u32>(11u))) | (_e514 << bitcast<u32>(22i))), (((((bitcast<u32>(select(_e364, _e363, _e367)) >> bitcast<u32>(_e370)) & 1023u) | (select(0u, 1u, _e367) << bitcast<u32>(10u))) | ((((bitcast<u32>(select(_e366, _e365, _e378)) >> bitcast<u32>(_e370)) & 1023u) | (select(0u, 1u, _e378) << bitcast<u32>(10u))) << bitcast<u32>(11u))) | ((_e514 >> bitcast<u32>(10u)) << bitcast<u32>(22i))), (((((bitcast<u32>(select(_e409, _e408, _e412)) >> bitcast<u32>(_e415)) & 1023u) | (select(0u, 1u, _e412) << bitcast<u32>(10u))) | ((((bitcast<u32>(select(_e411, _e410, _e423)) >> bitcast<u32>(_e415)) & 1023u) | (select(0u, 1u, _e423) << bitcast<u32>(10u))) << bitcast<u32>(11u))) | ((_e514 >> bitcast<u32>(20u)) << bitcast<u32>(22i))));
                        if (_e47 == 0u) {
                            if (_e43 == 0u) {
                            } else {
                                if (0u < _e43) {
                                } else {
                                    break;
                                }
                                global_4.member[0u] = type_22(array<u32, 4>(bitcast<u32>(_e287.member[0]), bitcast<u32>(_e287.member[1]), bitcast<u32>(_e287.member[2]), 4294967272u), array<u32, 4>(bitcast<u32>(_e290.member_1[0]), bitcast<u32>(_e290.member_1[1]), bitcast<u32>(_e290.member_1[2]), 0u));
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
fn encode_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
