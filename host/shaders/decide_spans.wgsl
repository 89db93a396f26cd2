struct type_5 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_13 {
    member: array<array<f32, 3>>,
}

struct type_17 {
    member: array<array<u32, 3>>,
}

struct type_26 {
    member: array<array<u32, 2>>,
}

struct type_30 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
    member_2: f32,
    member_3: f32,
    member_4: u32,
}

struct type_32 {
    member: array<type_30>,
}

struct type_35 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_37 {
    member: array<type_35>,
}

var<private> global: vec3<u32>;
var<private> global_1: u32;
@group(0) @binding(0) 
var<uniform> global_2: type_8;
@group(0) @binding(1) 
var<uniform> global_3: type_8;
@group(0) @binding(2) 
var<storage> global_4: type_13;
@group(0) @binding(3) 
var<storage> global_5: type_17;
@group(0) @binding(4) 
var<storage> global_6: type_26;
@group(0) @binding(5) 
var<storage> global_7: type_37;
@group(0) @binding(6) 
var<storage, read_write> global_8: type_32;
var<workgroup> global_9: array<type_30, 64>;

fn function_() {
    var phi_165_: type_35;
    var phi_218_: array<f32, 3>;
    var phi_250_: u32;
    var phi_253_: type_5;
    var phi_256_: type_30;
    var phi_254_: type_5;
    var phi_279_: type_5;
    var phi_309_: array<u32, 3>;
    var phi_324_: array<f32, 3>;
    var phi_342_: array<f32, 3>;
    var phi_360_: array<f32, 3>;
    var phi_622_: type_30;
    var phi_257_: type_30;
    var phi_1068_: bool;
    var phi_639_: u32;
    var phi_642_: type_5;
    var phi_645_: type_30;
    var phi_643_: type_5;
    var phi_668_: type_5;
    var phi_698_: array<u32, 2>;
    var phi_714_: array<f32, 3>;
    var phi_728_: array<f32, 3>;
    var phi_742_: bool;
    var phi_759_: bool;
    var phi_776_: bool;
    var phi_777_: bool;
    var phi_779_: bool;
    var phi_780_: bool;
    var phi_790_: type_30;
    var phi_646_: type_30;
    var phi_1104_: bool;
    var local: type_30;
    var local_1: type_30;
    var local_2: type_30;
    var local_3: type_30;
    var local_4: type_30;
    var phi_814_: type_5;
    var phi_817_: u32;
    var phi_815_: type_5;
    var phi_840_: type_5;
    var phi_818_: u32;
    var phi_1119_: bool;
    var local_5: type_30;

    switch bitcast<i32>(0u) {
        default: {
            let _e46 = global;
            let _e47 = global_1;
            let _e50 = arrayLength((&global_4.member));
            let _e64 = (_e46.x + (_e46.y * 32768u));
            let _e65 = (_e64 < arrayLength((&global_7.member)));
            if _e65 {
                if _e65 {
                } else {
                    break;
                }
                let _e68 = global_7.member[_e64];
                phi_165_ = _e68;
            } else {
                phi_165_ = type_35(0u, 0u, 0u, 0u, 0u);
            }
            let _e70 = phi_165_;
            let _e73 = global_2.member[0u];
            let _e74 = bitcast<i32>(_e73);
            let _e75 = (_e74 / 2i);
            let _e80 = bitcast<f32>((bitcast<u32>((_e75 + 127i)) << bitcast<u32>(23i)));
            let _e86 = bitcast<f32>((bitcast<u32>(((_e74 - _e75) + 127i)) << bitcast<u32>(23i)));
            let _e89 = global_3.member[0u];
            let _e91 = (_e70.member < _e50);
            if _e91 {
                if _e91 {
                } else {
                    break;
                }
                let _e93 = global_4.member[_e70.member];
                phi_218_ = _e93;
            } else {
                phi_218_ = array<f32, 3>(0f, 0f, 0f);
            }
            let _e95 = phi_218_;
            let _e106 = (_e70.member_2 / 64u);
            if ((_e70.member_2 % 64u) > 0u) {
                phi_250_ = (_e106 + 1u);
            } else {
                phi_250_ = _e106;
            }
            let _e111 = phi_250_;
            phi_253_ = type_5(0u, _e111);
            phi_256_ = type_30(array<f32, 3>(340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f), array<f32, 3>(-340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f), 0f, 0f, 0u);
            loop {
                let _e114 = phi_253_;
                let _e116 = phi_256_;
                local_5 = _e116;
                if (_e114.member < _e114.member_1) {
                    phi_254_ = type_5((_e114.member + 1u), _e114.member_1);
                    phi_279_ = type_5(1u, _e114.member);
                } else {
                    phi_254_ = _e114;
                    phi_279_ = type_5(0u, type_5().member_1);
                }
                let _e129 = phi_254_;
                let _e131 = phi_279_;
                let _e135 = (bitcast<i32>(_e131.member) != 0i);
                if _e135 {
                    let _e137 = ((_e131.member_1 * 64u) + _e47);
                    if (_e137 < _e70.member_2) {
                        let _e140 = (_e70.member_1 + _e137);
                        let _e141 = (_e140 < arrayLength((&global_5.member)));
                        if _e141 {
                            if _e141 {
                            } else {
                                phi_1068_ = true;
                                break;
                            }
                            let _e143 = global_5.member[_e140];
                            phi_309_ = _e143;
                        } else {
                            phi_309_ = array<u32, 3>(0u, 0u, 0u);
                        }
                        let _e145 = phi_309_;
                        let _e147 = (_e145[0] < _e50);
                        if _e147 {
                            if _e147 {
                            } else {
                                phi_1068_ = true;
                                break;
                            }
                            let _e149 = global_4.member[_e145[0]];
                            phi_324_ = _e149;
                        } else {
                            phi_324_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e151 = phi_324_;
                        let _e156 = (_e145[1] < _e50);
                        if _e156 {
                            if _e156 {
                            } else {
                                phi_1068_ = true;
                                break;
                            }
                            let _e158 = global_4.member[_e145[1]];
                            phi_342_ = _e158;
                        } else {
                            phi_342_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e160 = phi_342_;
                        let _e165 = (_e145[2] < _e50);
                        if _e165 {
                            if _e165 {
                            } else {
                                phi_1068_ = true;
                                break;
                            }
                            let _e167 = global_4.member[_e145[2]];
                            phi_360_ = _e167;
                        } else {
                            phi_360_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e169 = phi_360_;
                        let _e174 = ((_e151[0] * _e80) * _e86);
                        let _e176 = ((_e151[1] * _e80) * _e86);
                        let _e178 = ((_e151[2] * _e80) * _e86);
                        let _e179 = (_e174 - ((_e95[0] * _e80) * _e86));
                        let _e180 = (_e176 - ((_e95[1] * _e80) * _e86));
                        let _e181 = (_e178 - ((_e95[2] * _e80) * _e86));
                        let _e188 = (((_e160[0] * _e80) * _e86) - _e174);
                        let _e189 = (((_e160[1] * _e80) * _e86) - _e176);
                        let _e190 = (((_e160[2] * _e80) * _e86) - _e178);
                        let _e197 = (((_e169[0] * _e80) * _e86) - _e174);
                        let _e198 = (((_e169[1] * _e80) * _e86) - _e176);
                        let _e199 = (((_e169[2] * _e80) * _e86) - _e178);
                        let _e203 = bitcast<f32>((bitcast<u32>((_e188 * _e198)) ^ _e89));
                        let _e207 = bitcast<f32>((bitcast<u32>((_e189 * _e197)) ^ _e89));
                        let _e211 = bitcast<f32>((bitcast<u32>((_e189 * _e199)) ^ _e89));
                        let _e215 = bitcast<f32>((bitcast<u32>((_e190 * _e198)) ^ _e89));
                        let _e219 = bitcast<f32>((bitcast<u32>((_e190 * _e197)) ^ _e89));
                        let _e223 = bitcast<f32>((bitcast<u32>((_e188 * _e199)) ^ _e89));
                        let _e286 = select(_e160[0], _e151[0], (_e151[0] < _e160[0]));
                        let _e288 = select(_e160[1], _e151[1], (_e151[1] < _e160[1]));
                        let _e290 = select(_e160[2], _e151[2], (_e151[2] < _e160[2]));
                        let _e292 = select(_e169[0], _e286, (_e286 < _e169[0]));
                        let _e294 = select(_e169[1], _e288, (_e288 < _e169[1]));
                        let _e296 = select(_e169[2], _e290, (_e290 < _e169[2]));
                        let _e298 = select(_e160[0], _e151[0], (_e151[0] > _e160[0]));
                        let _e300 = select(_e160[1], _e151[1], (_e151[1] > _e160[1]));
                        let _e302 = select(_e160[2], _e151[2], (_e151[2] > _e160[2]));
                        let _e304 = select(_e169[0], _e298, (_e298 > _e169[0]));
                        let _e306 = select(_e169[1], _e300, (_e300 > _e169[1]));
                        let _e308 = select(_e169[2], _e302, (_e302 > _e169[2]));
                        let _e310 = select(_e292, 0f, (_e292 == 0f));
                        let _e312 = select(_e294, 0f, (_e294 == 0f));
                        let _e314 = select(_e296, 0f, (_e296 == 0f));
                        let _e316 = select(_e304, 0f, (_e304 == 0f));
                        let _e318 = select(_e306, 0f, (_e306 == 0f));
                        let _e320 = select(_e308, 0f, (_e308 == 0f));
                        let _e327 = (_e116.member_2 + ((bitcast<f32>((bitcast<u32>((_e179 * (_e211 - _e215))) ^ _e89)) + bitcast<f32>((bitcast<u32>((_e180 * (_e219 - _e223))) ^ _e89))) + bitcast<f32>((bitcast<u32>((_e181 * (_e203 - _e207))) ^ _e89))));
                        phi_622_ = type_30(array<f32, 3>(select(_e310, _e116.member[0], (_e116.member[0] < _e310)), select(_e312, _e116.member[1], (_e116.member[1] < _e312)), select(_e314, _e116.member[2], (_e116.member[2] < _e314))), array<f32, 3>(select(_e316, _e116.member_1[0], (_e116.member_1[0] > _e316)), select(_e318, _e116.member_1[1], (_e116.member_1[1] > _e318)), select(_e320, _e116.member_1[2], (_e116.member_1[2] > _e320))), _e327, ((_e116.member_3 + (bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e179) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e211) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e215) & 2147483647u))))) ^ _e89)) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e180) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e219) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e223) & 2147483647u))))) ^ _e89))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e181) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e203) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e207) & 2147483647u))))) ^ _e89))))) ^ _e89)) + 0.0000000000000000000000000000000000030092655f)) + (0.000000059604645f * bitcast<f32>((bitcast<u32>(_e327) & 2147483647u)))), _e116.member_4);
                    } else {
                        phi_622_ = _e116;
                    }
                    let _e360 = phi_622_;
                    phi_257_ = _e360;
                } else {
                    phi_257_ = type_30();
                }
                let _e362 = phi_257_;
                continue;
                continuing {
                    phi_253_ = _e129;
                    phi_256_ = _e362;
                    phi_1068_ = false;
                    break if !(_e135);
                }
            }
            let _e365 = phi_1068_;
            if _e365 {
                break;
            }
            let _e367 = (_e70.member_4 / 64u);
            if ((_e70.member_4 % 64u) > 0u) {
                phi_639_ = (_e367 + 1u);
            } else {
                phi_639_ = _e367;
            }
            let _e372 = phi_639_;
            phi_642_ = type_5(0u, _e372);
            let _e622 = local_5;
            phi_645_ = _e622;
            loop {
                let _e375 = phi_642_;
                let _e377 = phi_645_;
                local = _e377;
                local_1 = _e377;
                local_2 = _e377;
                local_3 = _e377;
                local_4 = _e377;
                if (_e375.member < _e375.member_1) {
                    phi_643_ = type_5((_e375.member + 1u), _e375.member_1);
                    phi_668_ = type_5(1u, _e375.member);
                } else {
                    phi_643_ = _e375;
                    phi_668_ = type_5(0u, type_5().member_1);
                }
                let _e390 = phi_643_;
                let _e392 = phi_668_;
                let _e396 = (bitcast<i32>(_e392.member) != 0i);
                if _e396 {
                    let _e398 = ((_e392.member_1 * 64u) + _e47);
                    if (_e398 < _e70.member_4) {
                        let _e401 = (_e70.member_3 + _e398);
                        let _e402 = (_e401 < arrayLength((&global_6.member)));
                        if _e402 {
                            if _e402 {
                            } else {
                                phi_1104_ = true;
                                break;
                            }
                            let _e404 = global_6.member[_e401];
                            phi_698_ = _e404;
                        } else {
                            phi_698_ = array<u32, 2>(0u, 0u);
                        }
                        let _e406 = phi_698_;
                        let _e409 = (_e406[0] < _e50);
                        if _e409 {
                            if _e409 {
                            } else {
                                phi_1104_ = true;
                                break;
                            }
                            let _e411 = global_4.member[_e406[0]];
                            phi_714_ = _e411;
                        } else {
                            phi_714_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e413 = phi_714_;
                        let _e414 = (_e406[1] < _e50);
                        if _e414 {
                            if _e414 {
                            } else {
                                phi_1104_ = true;
                                break;
                            }
                            let _e416 = global_4.member[_e406[1]];
                            phi_728_ = _e416;
                        } else {
                            phi_728_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e418 = phi_728_;
                        let _e421 = bitcast<u32>(_e413[0]);
                        let _e422 = bitcast<u32>(_e418[0]);
                        if (_e421 == _e422) {
                            phi_742_ = true;
                        } else {
                            phi_742_ = (((_e421 | _e422) << bitcast<u32>(1i)) == 0u);
                        }
                        let _e429 = phi_742_;
                        if _e429 {
                            let _e432 = bitcast<u32>(_e413[1]);
                            let _e433 = bitcast<u32>(_e418[1]);
                            if (_e432 == _e433) {
                                phi_759_ = true;
                            } else {
                                phi_759_ = (((_e432 | _e433) << bitcast<u32>(1i)) == 0u);
                            }
                            let _e440 = phi_759_;
                            if _e440 {
                                let _e443 = bitcast<u32>(_e413[2]);
                                let _e444 = bitcast<u32>(_e418[2]);
                                if (_e443 == _e444) {
                                    phi_776_ = true;
                                } else {
                                    phi_776_ = (((_e443 | _e444) << bitcast<u32>(1i)) == 0u);
                                }
                                let _e451 = phi_776_;
                                phi_777_ = _e451;
                            } else {
                                phi_777_ = bool();
                            }
                            let _e453 = phi_777_;
                            phi_779_ = _e453;
                            phi_780_ = select(true, false, _e440);
                        } else {
                            phi_779_ = bool();
                            phi_780_ = true;
                        }
                        let _e456 = phi_779_;
                        let _e458 = phi_780_;
                        phi_790_ = type_30(_e377.member, _e377.member_1, _e377.member_2, _e377.member_3, (_e377.member_4 | select(0u, 1u, !(select(_e456, false, _e458)))));
                    } else {
                        phi_790_ = _e377;
                    }
                    let _e471 = phi_790_;
                    phi_646_ = _e471;
                } else {
                    phi_646_ = type_30();
                }
                let _e473 = phi_646_;
                continue;
                continuing {
                    phi_642_ = _e390;
                    phi_645_ = _e473;
                    phi_1104_ = _e365;
                    break if !(_e396);
                }
            }
            let _e476 = phi_1104_;
            if _e476 {
                break;
            }
            let _e477 = (_e47 % 64u);
            let _e478 = (_e477 < 64u);
            if _e478 {
            } else {
                break;
            }
            let _e481 = local;
            let _e488 = local_1;
            let _e495 = local_2;
            let _e498 = local_3;
            let _e501 = local_4;
            global_9[_e477] = type_30(array<f32, 3>(_e481.member[0], _e481.member[1], _e481.member[2]), array<f32, 3>(_e488.member_1[0], _e488.member_1[1], _e488.member_1[2]), _e495.member_2, _e498.member_3, _e501.member_4);
            workgroupBarrier();
            phi_814_ = type_5(0u, 6u);
            phi_817_ = 32u;
            loop {
                let _e505 = phi_814_;
                let _e507 = phi_817_;
                if (_e505.member < _e505.member_1) {
                    phi_815_ = type_5((_e505.member + 1u), _e505.member_1);
                    phi_840_ = type_5(1u, _e505.member);
                } else {
                    phi_815_ = _e505;
                    phi_840_ = type_5(0u, type_5().member_1);
                }
                let _e520 = phi_815_;
                let _e522 = phi_840_;
                let _e525 = (bitcast<i32>(_e522.member) != 0i);
                if _e525 {
                    if (_e47 < _e507) {
                        if _e478 {
                        } else {
                            phi_1119_ = true;
                            break;
                        }
                        let _e527 = global_9[_e477];
                        let _e540 = ((_e47 + _e507) % 64u);
                        if (_e540 < 64u) {
                        } else {
                            phi_1119_ = true;
                            break;
                        }
                        let _e543 = global_9[_e540];
                        let _e555 = (_e527.member_2 + _e543.member_2);
                        if _e478 {
                        } else {
                            phi_1119_ = true;
                            break;
                        }
                        global_9[_e477] = type_30(array<f32, 3>(select(_e543.member[0], _e527.member[0], (_e527.member[0] < _e543.member[0])), select(_e543.member[1], _e527.member[1], (_e527.member[1] < _e543.member[1])), select(_e543.member[2], _e527.member[2], (_e527.member[2] < _e543.member[2]))), array<f32, 3>(select(_e543.member_1[0], _e527.member_1[0], (_e527.member_1[0] > _e543.member_1[0])), select(_e543.member_1[1], _e527.member_1[1], (_e527.member_1[1] > _e543.member_1[1])), select(_e543.member_1[2], _e527.member_1[2], (_e527.member_1[2] > _e543.member_1[2]))), _e555, ((_e527.member_3 + _e543.member_3) + (0.000000059604645f * bitcast<f32>((bitcast<u32>(_e555) & 2147483647u)))), (_e527.member_4 | _e543.member_4));
                    }
                    workgroupBarrier();
                    phi_818_ = (_e507 / 2u);
                } else {
                    phi_818_ = u32();
                }
                let _e580 = phi_818_;
                continue;
                continuing {
                    phi_814_ = _e520;
                    phi_817_ = _e580;
                    phi_1119_ = _e476;
                    break if !(_e525);
                }
            }
            let _e583 = phi_1119_;
            if _e583 {
                break;
            }
            if (_e47 == 0u) {
                if _e65 {
                    let _e585 = (_e64 < arrayLength((&global_8.member)));
                    if _e585 {
                        let _e587 = global_9[0u];
                        if _e585 {
                        } else {
                            break;
                        }
                        global_8.member[_e64] = type_30(array<f32, 3>(_e587.member[0], _e587.member[1], _e587.member[2]), array<f32, 3>(_e587.member_1[0], _e587.member_1[1], _e587.member_1[2]), _e587.member_2, _e587.member_3, _e587.member_4);
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_spans(@builtin(workgroup_id) param: vec3<u32>, @builtin(local_invocation_index) param_1: u32) {
    global = param;
    global_1 = param_1;
    function_();
}
