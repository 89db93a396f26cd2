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
    var phi_163_: type_35;
    var phi_182_: i32;
    var phi_219_: array<f32, 3>;
    var phi_251_: u32;
    var phi_254_: type_5;
    var phi_257_: type_30;
    var phi_255_: type_5;
    var phi_280_: type_5;
    var phi_310_: array<u32, 3>;
    var phi_325_: array<f32, 3>;
    var phi_343_: array<f32, 3>;
    var phi_361_: array<f32, 3>;
    var phi_623_: type_30;
    var phi_258_: type_30;
    var phi_1069_: bool;
    var phi_640_: u32;
    var phi_643_: type_5;
    var phi_646_: type_30;
    var phi_644_: type_5;
    var phi_669_: type_5;
    var phi_699_: array<u32, 2>;
    var phi_715_: array<f32, 3>;
    var phi_729_: array<f32, 3>;
    var phi_743_: bool;
    var phi_760_: bool;
    var phi_777_: bool;
    var phi_778_: bool;
    var phi_780_: bool;
    var phi_781_: bool;
    var phi_791_: type_30;
    var phi_647_: type_30;
    var phi_1107_: bool;
    var local: type_30;
    var local_1: type_30;
    var local_2: type_30;
    var local_3: type_30;
    var local_4: type_30;
    var phi_815_: type_5;
    var phi_818_: u32;
    var phi_816_: type_5;
    var phi_841_: type_5;
    var phi_819_: u32;
    var phi_1122_: bool;
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
                phi_163_ = _e68;
            } else {
                phi_163_ = type_35(0u, 0u, 0u, 0u, 0u);
            }
            let _e70 = phi_163_;
            let _e73 = global_2.member[0u];
            let _e74 = bitcast<i32>(_e73);
            if (_e74 < -126i) {
                phi_182_ = -126i;
            } else {
                phi_182_ = select(_e74, 127i, (_e74 > 127i));
            }
            let _e79 = phi_182_;
            let _e84 = bitcast<f32>((bitcast<u32>((_e79 + 127i)) << bitcast<u32>(23i)));
            let _e90 = bitcast<f32>((bitcast<u32>(((_e74 - _e79) + 127i)) << bitcast<u32>(23i)));
            let _e93 = global_3.member[0u];
            let _e95 = (_e70.member < _e50);
            if _e95 {
                if _e95 {
                } else {
                    break;
                }
                let _e97 = global_4.member[_e70.member];
                phi_219_ = _e97;
            } else {
                phi_219_ = array<f32, 3>(0f, 0f, 0f);
            }
            let _e99 = phi_219_;
            let _e110 = (_e70.member_2 / 64u);
            if ((_e70.member_2 % 64u) > 0u) {
                phi_251_ = (_e110 + 1u);
            } else {
                phi_251_ = _e110;
            }
            let _e115 = phi_251_;
            phi_254_ = type_5(0u, _e115);
            phi_257_ = type_30(array<f32, 3>(340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f), array<f32, 3>(-340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f), 0f, 0f, 0u);
            loop {
                let _e118 = phi_254_;
                let _e120 = phi_257_;
                local_5 = _e120;
                if (_e118.member < _e118.member_1) {
                    phi_255_ = type_5((_e118.member + 1u), _e118.member_1);
                    phi_280_ = type_5(1u, _e118.member);
                } else {
                    phi_255_ = _e118;
                    phi_280_ = type_5(0u, type_5().member_1);
                }
                let _e133 = phi_255_;
                let _e135 = phi_280_;
                let _e139 = (bitcast<i32>(_e135.member) != 0i);
                if _e139 {
                    let _e141 = ((_e135.member_1 * 64u) + _e47);
                    if (_e141 < _e70.member_2) {
                        let _e144 = (_e70.member_1 + _e141);
                        let _e145 = (_e144 < arrayLength((&global_5.member)));
                        if _e145 {
                            if _e145 {
                            } else {
                                phi_1069_ = true;
                                break;
                            }
                            let _e147 = global_5.member[_e144];
                            phi_310_ = _e147;
                        } else {
                            phi_310_ = array<u32, 3>(0u, 0u, 0u);
                        }
                        let _e149 = phi_310_;
                        let _e151 = (_e149[0] < _e50);
                        if _e151 {
                            if _e151 {
                            } else {
                                phi_1069_ = true;
                                break;
                            }
                            let _e153 = global_4.member[_e149[0]];
                            phi_325_ = _e153;
                        } else {
                            phi_325_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e155 = phi_325_;
                        let _e160 = (_e149[1] < _e50);
                        if _e160 {
                            if _e160 {
                            } else {
                                phi_1069_ = true;
                                break;
                            }
                            let _e162 = global_4.member[_e149[1]];
                            phi_343_ = _e162;
                        } else {
                            phi_343_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e164 = phi_343_;
                        let _e169 = (_e149[2] < _e50);
                        if _e169 {
                            if _e169 {
                            } else {
                                phi_1069_ = true;
                                break;
                            }
                            let _e171 = global_4.member[_e149[2]];
                            phi_361_ = _e171;
                        } else {
                            phi_361_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e173 = phi_361_;
                        let _e178 = ((_e155[0] * _e84) * _e90);
                        let _e180 = ((_e155[1] * _e84) * _e90);
                        let _e182 = ((_e155[2] * _e84) * _e90);
                        let _e183 = (_e178 - ((_e99[0] * _e84) * _e90));
                        let _e184 = (_e180 - ((_e99[1] * _e84) * _e90));
                        let _e185 = (_e182 - ((_e99[2] * _e84) * _e90));
                        let _e192 = (((_e164[0] * _e84) * _e90) - _e178);
                        let _e193 = (((_e164[1] * _e84) * _e90) - _e180);
                        let _e194 = (((_e164[2] * _e84) * _e90) - _e182);
                        let _e201 = (((_e173[0] * _e84) * _e90) - _e178);
                        let _e202 = (((_e173[1] * _e84) * _e90) - _e180);
                        let _e203 = (((_e173[2] * _e84) * _e90) - _e182);
                        let _e207 = bitcast<f32>((bitcast<u32>((_e192 * _e202)) ^ _e93));
                        let _e211 = bitcast<f32>((bitcast<u32>((_e193 * _e201)) ^ _e93));
                        let _e215 = bitcast<f32>((bitcast<u32>((_e193 * _e203)) ^ _e93));
                        let _e219 = bitcast<f32>((bitcast<u32>((_e194 * _e202)) ^ _e93));
                        let _e223 = bitcast<f32>((bitcast<u32>((_e194 * _e201)) ^ _e93));
                        let _e227 = bitcast<f32>((bitcast<u32>((_e192 * _e203)) ^ _e93));
                        let _e290 = select(_e164[0], _e155[0], (_e155[0] < _e164[0]));
                        let _e292 = select(_e164[1], _e155[1], (_e155[1] < _e164[1]));
                        let _e294 = select(_e164[2], _e155[2], (_e155[2] < _e164[2]));
                        let _e296 = select(_e173[0], _e290, (_e290 < _e173[0]));
                        let _e298 = select(_e173[1], _e292, (_e292 < _e173[1]));
                        let _e300 = select(_e173[2], _e294, (_e294 < _e173[2]));
                        let _e302 = select(_e164[0], _e155[0], (_e155[0] > _e164[0]));
                        let _e304 = select(_e164[1], _e155[1], (_e155[1] > _e164[1]));
                        let _e306 = select(_e164[2], _e155[2], (_e155[2] > _e164[2]));
                        let _e308 = select(_e173[0], _e302, (_e302 > _e173[0]));
                        let _e310 = select(_e173[1], _e304, (_e304 > _e173[1]));
                        let _e312 = select(_e173[2], _e306, (_e306 > _e173[2]));
                        let _e314 = select(_e296, 0f, (_e296 == 0f));
                        let _e316 = select(_e298, 0f, (_e298 == 0f));
                        let _e318 = select(_e300, 0f, (_e300 == 0f));
                        let _e320 = select(_e308, 0f, (_e308 == 0f));
                        let _e322 = select(_e310, 0f, (_e310 == 0f));
                        let _e324 = select(_e312, 0f, (_e312 == 0f));
                        let _e331 = (_e120.member_2 + ((bitcast<f32>((bitcast<u32>((_e183 * (_e215 - _e219))) ^ _e93)) + bitcast<f32>((bitcast<u32>((_e184 * (_e223 - _e227))) ^ _e93))) + bitcast<f32>((bitcast<u32>((_e185 * (_e207 - _e211))) ^ _e93))));
                        phi_623_ = type_30(array<f32, 3>(select(_e314, _e120.member[0], (_e120.member[0] < _e314)), select(_e316, _e120.member[1], (_e120.member[1] < _e316)), select(_e318, _e120.member[2], (_e120.member[2] < _e318))), array<f32, 3>(select(_e320, _e120.member_1[0], (_e120.member_1[0] > _e320)), select(_e322, _e120.member_1[1], (_e120.member_1[1] > _e322)), select(_e324, _e120.member_1[2], (_e120.member_1[2] > _e324))), _e331, ((_e120.member_3 + (bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e183) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e215) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e219) & 2147483647u))))) ^ _e93)) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e184) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e223) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e227) & 2147483647u))))) ^ _e93))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e185) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e207) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e211) & 2147483647u))))) ^ _e93))))) ^ _e93)) + 0.0000000000000000000000000000000000030092655f)) + (0.000000059604645f * bitcast<f32>((bitcast<u32>(_e331) & 2147483647u)))), _e120.member_4);
                    } else {
                        phi_623_ = _e120;
                    }
                    let _e364 = phi_623_;
                    phi_258_ = _e364;
                } else {
                    phi_258_ = type_30();
                }
                let _e366 = phi_258_;
                continue;
                continuing {
                    phi_254_ = _e133;
                    phi_257_ = _e366;
                    phi_1069_ = false;
                    break if !(_e139);
                }
            }
            let _e369 = phi_1069_;
            if _e369 {
                break;
            }
            let _e371 = (_e70.member_4 / 64u);
            if ((_e70.member_4 % 64u) > 0u) {
                phi_640_ = (_e371 + 1u);
            } else {
                phi_640_ = _e371;
            }
            let _e376 = phi_640_;
            phi_643_ = type_5(0u, _e376);
            let _e627 = local_5;
            phi_646_ = _e627;
            loop {
                let _e379 = phi_643_;
                let _e381 = phi_646_;
                local = _e381;
                local_1 = _e381;
                local_2 = _e381;
                local_3 = _e381;
                local_4 = _e381;
                if (_e379.member < _e379.member_1) {
                    phi_644_ = type_5((_e379.member + 1u), _e379.member_1);
                    phi_669_ = type_5(1u, _e379.member);
                } else {
                    phi_644_ = _e379;
                    phi_669_ = type_5(0u, type_5().member_1);
                }
                let _e394 = phi_644_;
                let _e396 = phi_669_;
                let _e400 = (bitcast<i32>(_e396.member) != 0i);
                if _e400 {
                    let _e402 = ((_e396.member_1 * 64u) + _e47);
                    if (_e402 < _e70.member_4) {
                        let _e405 = (_e70.member_3 + _e402);
                        let _e406 = (_e405 < arrayLength((&global_6.member)));
                        if _e406 {
                            if _e406 {
                            } else {
                                phi_1107_ = true;
                                break;
                            }
                            let _e408 = global_6.member[_e405];
                            phi_699_ = _e408;
                        } else {
                            phi_699_ = array<u32, 2>(0u, 0u);
                        }
                        let _e410 = phi_699_;
                        let _e413 = (_e410[0] < _e50);
                        if _e413 {
                            if _e413 {
                            } else {
                                phi_1107_ = true;
                                break;
                            }
                            let _e415 = global_4.member[_e410[0]];
                            phi_715_ = _e415;
                        } else {
                            phi_715_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e417 = phi_715_;
                        let _e418 = (_e410[1] < _e50);
                        if _e418 {
                            if _e418 {
                            } else {
                                phi_1107_ = true;
                                break;
                            }
                            let _e420 = global_4.member[_e410[1]];
                            phi_729_ = _e420;
                        } else {
                            phi_729_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e422 = phi_729_;
                        let _e425 = bitcast<u32>(_e417[0]);
                        let _e426 = bitcast<u32>(_e422[0]);
                        if (_e425 == _e426) {
                            phi_743_ = true;
                        } else {
                            phi_743_ = (((_e425 | _e426) << bitcast<u32>(1i)) == 0u);
                        }
                        let _e433 = phi_743_;
                        if _e433 {
                            let _e436 = bitcast<u32>(_e417[1]);
                            let _e437 = bitcast<u32>(_e422[1]);
                            if (_e436 == _e437) {
                                phi_760_ = true;
                            } else {
                                phi_760_ = (((_e436 | _e437) << bitcast<u32>(1i)) == 0u);
                            }
                            let _e444 = phi_760_;
                            if _e444 {
                                let _e447 = bitcast<u32>(_e417[2]);
                                let _e448 = bitcast<u32>(_e422[2]);
                                if (_e447 == _e448) {
                                    phi_777_ = true;
                                } else {
                                    phi_777_ = (((_e447 | _e448) << bitcast<u32>(1i)) == 0u);
                                }
                                let _e455 = phi_777_;
                                phi_778_ = _e455;
                            } else {
                                phi_778_ = bool();
                            }
                            let _e457 = phi_778_;
                            phi_780_ = _e457;
                            phi_781_ = select(true, false, _e444);
                        } else {
                            phi_780_ = bool();
                            phi_781_ = true;
                        }
                        let _e460 = phi_780_;
                        let _e462 = phi_781_;
                        phi_791_ = type_30(_e381.member, _e381.member_1, _e381.member_2, _e381.member_3, (_e381.member_4 | select(0u, 1u, !(select(_e460, false, _e462)))));
                    } else {
                        phi_791_ = _e381;
                    }
                    let _e475 = phi_791_;
                    phi_647_ = _e475;
                } else {
                    phi_647_ = type_30();
                }
                let _e477 = phi_647_;
                continue;
                continuing {
                    phi_643_ = _e394;
                    phi_646_ = _e477;
                    phi_1107_ = _e369;
                    break if !(_e400);
                }
            }
            let _e480 = phi_1107_;
            if _e480 {
                break;
            }
            let _e481 = (_e47 % 64u);
            let _e482 = (_e481 < 64u);
            if _e482 {
            } else {
                break;
            }
            let _e485 = local;
            let _e492 = local_1;
            let _e499 = local_2;
            let _e502 = local_3;
            let _e505 = local_4;
            global_9[_e481] = type_30(array<f32, 3>(_e485.member[0], _e485.member[1], _e485.member[2]), array<f32, 3>(_e492.member_1[0], _e492.member_1[1], _e492.member_1[2]), _e499.member_2, _e502.member_3, _e505.member_4);
            workgroupBarrier();
            phi_815_ = type_5(0u, 6u);
            phi_818_ = 32u;
            loop {
                let _e509 = phi_815_;
                let _e511 = phi_818_;
                if (_e509.member < _e509.member_1) {
                    phi_816_ = type_5((_e509.member + 1u), _e509.member_1);
                    phi_841_ = type_5(1u, _e509.member);
                } else {
                    phi_816_ = _e509;
                    phi_841_ = type_5(0u, type_5().member_1);
                }
                let _e524 = phi_816_;
                let _e526 = phi_841_;
                let _e529 = (bitcast<i32>(_e526.member) != 0i);
                if _e529 {
                    if (_e47 < _e511) {
                        if _e482 {
                        } else {
                            phi_1122_ = true;
                            break;
                        }
                        let _e531 = global_9[_e481];
                        let _e544 = ((_e47 + _e511) % 64u);
                        if (_e544 < 64u) {
                        } else {
                            phi_1122_ = true;
                            break;
                        }
                        let _e547 = global_9[_e544];
                        let _e559 = (_e531.member_2 + _e547.member_2);
                        if _e482 {
                        } else {
                            phi_1122_ = true;
                            break;
                        }
                        global_9[_e481] = type_30(array<f32, 3>(select(_e547.member[0], _e531.member[0], (_e531.member[0] < _e547.member[0])), select(_e547.member[1], _e531.member[1], (_e531.member[1] < _e547.member[1])), select(_e547.member[2], _e531.member[2], (_e531.member[2] < _e547.member[2]))), array<f32, 3>(select(_e547.member_1[0], _e531.member_1[0], (_e531.member_1[0] > _e547.member_1[0])), select(_e547.member_1[1], _e531.member_1[1], (_e531.member_1[1] > _e547.member_1[1])), select(_e547.member_1[2], _e531.member_1[2], (_e531.member_1[2] > _e547.member_1[2]))), _e559, ((_e531.member_3 + _e547.member_3) + (0.000000059604645f * bitcast<f32>((bitcast<u32>(_e559) & 2147483647u)))), (_e531.member_4 | _e547.member_4));
                    }
                    workgroupBarrier();
                    phi_819_ = (_e511 / 2u);
                } else {
                    phi_819_ = u32();
                }
                let _e584 = phi_819_;
                continue;
                continuing {
                    phi_815_ = _e524;
                    phi_818_ = _e584;
                    phi_1122_ = _e480;
                    break if !(_e529);
                }
            }
            let _e587 = phi_1122_;
            if _e587 {
                break;
            }
            if (_e47 == 0u) {
                if _e65 {
                    let _e589 = (_e64 < arrayLength((&global_8.member)));
                    if _e589 {
                        let _e591 = global_9[0u];
                        if _e589 {
                        } else {
                            break;
                        }
                        global_8.member[_e64] = type_30(array<f32, 3>(_e591.member[0], _e591.member[1], _e591.member[2]), array<f32, 3>(_e591.member_1[0], _e591.member_1[1], _e591.member_1[2]), _e591.member_2, _e591.member_3, _e591.member_4);
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
