struct type_5 {
    member: array<u32>,
}

struct type_9 {
    member: u32,
    member_1: u32,
}

struct type_13 {
    member: vec4<u32>,
}

struct type_18 {
    member: array<array<f32, 3>>,
}

struct type_22 {
    member: array<array<u32, 3>>,
}

struct type_30 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_31 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_33 {
    member: array<vec4<u32>, 2>,
}

struct type_36 {
    member: array<i32>,
}

struct type_41 {
    member: array<type_30>,
}

var<private> global: vec3<u32>;
var<private> global_1: u32;
@group(0) @binding(0) 
var<uniform> global_2: type_13;
@group(0) @binding(1) 
var<uniform> global_3: type_33;
@group(0) @binding(4) 
var<storage> global_4: type_5;
@group(0) @binding(5) 
var<storage> global_5: type_36;
@group(0) @binding(2) 
var<storage> global_6: type_18;
@group(0) @binding(3) 
var<storage> global_7: type_22;
@group(0) @binding(6) 
var<storage> global_8: type_36;
@group(0) @binding(7) 
var<storage, read_write> global_9: type_41;
var<workgroup> global_10: array<type_30, 64>;

fn function_() {
    var phi_162_: i32;
    var phi_215_: i32;
    var phi_239_: type_31;
    var phi_250_: type_9;
    var phi_253_: type_30;
    var phi_251_: type_9;
    var phi_276_: type_9;
    var phi_306_: u32;
    var phi_320_: i32;
    var phi_339_: array<u32, 3>;
    var phi_354_: array<f32, 3>;
    var phi_372_: array<f32, 3>;
    var phi_390_: array<f32, 3>;
    var phi_499_: vec3<f32>;
    var phi_681_: f32;
    var phi_717_: i32;
    var phi_721_: type_30;
    var phi_732_: type_30;
    var phi_254_: type_30;
    var phi_864_: bool;
    var local: type_30;
    var local_1: type_30;
    var local_2: type_30;
    var local_3: type_30;
    var phi_747_: type_9;
    var phi_750_: u32;
    var phi_748_: type_9;
    var phi_773_: type_9;
    var phi_751_: u32;
    var phi_901_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e47 = global;
            let _e48 = global_1;
            let _e51 = arrayLength((&global_6.member));
            let _e69 = (_e47.x + (_e47.y * 32768u));
            let _e72 = global_2.member[0u];
            let _e73 = bitcast<i32>(_e72);
            let _e74 = (_e73 < -126i);
            if _e74 {
                phi_162_ = -126i;
            } else {
                phi_162_ = select(_e73, 127i, (_e73 > 127i));
            }
            let _e78 = phi_162_;
            let _e83 = bitcast<f32>((bitcast<u32>((_e78 + 127i)) << bitcast<u32>(23i)));
            let _e89 = bitcast<f32>((bitcast<u32>(((_e73 - _e78) + 127i)) << bitcast<u32>(23i)));
            let _e93 = global_3.member[0u][0u];
            let _e97 = global_3.member[0u][1u];
            let _e101 = global_3.member[0u][2u];
            let _e105 = global_3.member[0u][3u];
            let _e109 = global_3.member[1u][0u];
            let _e113 = global_3.member[1u][1u];
            let _e117 = global_3.member[1u][2u];
            let _e121 = global_3.member[1u][3u];
            let _e122 = bitcast<f32>(_e93);
            let _e123 = bitcast<f32>(_e97);
            let _e124 = bitcast<f32>(_e101);
            let _e126 = bitcast<f32>(_e109);
            let _e127 = array<u32, 3>(_e113, _e117, _e121);
            if _e74 {
                phi_215_ = -126i;
            } else {
                phi_215_ = select(_e73, 127i, (_e73 > 127i));
            }
            let _e132 = phi_215_;
            let _e137 = bitcast<f32>((bitcast<u32>((_e132 + 127i)) << bitcast<u32>(23i)));
            let _e143 = bitcast<f32>((bitcast<u32>(((_e73 - _e132) + 127i)) << bitcast<u32>(23i)));
            if (_e105 == 0u) {
                phi_239_ = type_31(array<f32, 3>(_e122, _e123, _e124), _e105, _e126, _e127);
            } else {
                phi_239_ = type_31(array<f32, 3>(((_e122 * _e137) * _e143), ((_e123 * _e137) * _e143), ((_e124 * _e137) * _e143)), _e105, ((_e126 * _e137) * _e143), _e127);
            }
            let _e156 = phi_239_;
            phi_250_ = type_9(0u, 16u);
            phi_253_ = type_30(0u, 0u, 0u, 0u);
            loop {
                let _e158 = phi_250_;
                let _e160 = phi_253_;
                local = _e160;
                local_1 = _e160;
                local_2 = _e160;
                local_3 = _e160;
                if (_e158.member < _e158.member_1) {
                    phi_251_ = type_9((_e158.member + 1u), _e158.member_1);
                    phi_276_ = type_9(1u, _e158.member);
                } else {
                    phi_251_ = _e158;
                    phi_276_ = type_9(0u, type_9().member_1);
                }
                let _e173 = phi_251_;
                let _e175 = phi_276_;
                let _e179 = (bitcast<i32>(_e175.member) != 0i);
                if _e179 {
                    let _e183 = (((_e69 * 1024u) + (_e175.member_1 * 64u)) + _e48);
                    let _e184 = (_e183 < arrayLength((&global_7.member)));
                    if _e184 {
                        let _e185 = (_e183 < arrayLength((&global_4.member)));
                        if _e185 {
                            if _e185 {
                            } else {
                                phi_864_ = true;
                                break;
                            }
                            let _e187 = global_4.member[_e183];
                            phi_306_ = _e187;
                        } else {
                            phi_306_ = 4294967295u;
                        }
                        let _e189 = phi_306_;
                        let _e190 = (_e189 < arrayLength((&global_5.member)));
                        if _e190 {
                            if _e190 {
                            } else {
                                phi_864_ = true;
                                break;
                            }
                            let _e192 = global_5.member[_e189];
                            phi_320_ = _e192;
                        } else {
                            phi_320_ = 0i;
                        }
                        let _e194 = phi_320_;
                        if (_e194 == 0i) {
                            phi_721_ = type_30(1u, 1u, 0u, 0u);
                        } else {
                            if _e184 {
                                if _e184 {
                                } else {
                                    phi_864_ = true;
                                    break;
                                }
                                let _e197 = global_7.member[_e183];
                                phi_339_ = _e197;
                            } else {
                                phi_339_ = array<u32, 3>(0u, 0u, 0u);
                            }
                            let _e199 = phi_339_;
                            let _e201 = (_e199[0] < _e51);
                            if _e201 {
                                if _e201 {
                                } else {
                                    phi_864_ = true;
                                    break;
                                }
                                let _e203 = global_6.member[_e199[0]];
                                phi_354_ = _e203;
                            } else {
                                phi_354_ = array<f32, 3>(0f, 0f, 0f);
                            }
                            let _e205 = phi_354_;
                            let _e210 = (_e199[1] < _e51);
                            if _e210 {
                                if _e210 {
                                } else {
                                    phi_864_ = true;
                                    break;
                                }
                                let _e212 = global_6.member[_e199[1]];
                                phi_372_ = _e212;
                            } else {
                                phi_372_ = array<f32, 3>(0f, 0f, 0f);
                            }
                            let _e214 = phi_372_;
                            let _e219 = (_e199[2] < _e51);
                            if _e219 {
                                if _e219 {
                                } else {
                                    phi_864_ = true;
                                    break;
                                }
                                let _e221 = global_6.member[_e199[2]];
                                phi_390_ = _e221;
                            } else {
                                phi_390_ = array<f32, 3>(0f, 0f, 0f);
                            }
                            let _e223 = phi_390_;
                            let _e228 = ((_e205[0] * _e83) * _e89);
                            let _e230 = select(_e228, 0f, (_e228 == 0f));
                            let _e232 = ((_e205[1] * _e83) * _e89);
                            let _e234 = select(_e232, 0f, (_e232 == 0f));
                            let _e236 = ((_e205[2] * _e83) * _e89);
                            let _e238 = select(_e236, 0f, (_e236 == 0f));
                            let _e240 = ((_e214[0] * _e83) * _e89);
                            let _e244 = ((_e214[1] * _e83) * _e89);
                            let _e248 = ((_e214[2] * _e83) * _e89);
                            let _e252 = ((_e223[0] * _e83) * _e89);
                            let _e256 = ((_e223[1] * _e83) * _e89);
                            let _e260 = ((_e223[2] * _e83) * _e89);
                            let _e263 = (select(_e240, 0f, (_e240 == 0f)) - _e230);
                            let _e264 = (select(_e244, 0f, (_e244 == 0f)) - _e234);
                            let _e265 = (select(_e248, 0f, (_e248 == 0f)) - _e238);
                            let _e266 = (select(_e252, 0f, (_e252 == 0f)) - _e230);
                            let _e267 = (select(_e256, 0f, (_e256 == 0f)) - _e234);
                            let _e268 = (select(_e260, 0f, (_e260 == 0f)) - _e238);
                            if (_e156.member_1 == 1u) {
                                phi_499_ = vec3<f32>((_e156.member[0] - _e230), (_e156.member[1] - _e234), (_e156.member[2] - _e238));
                            } else {
                                phi_499_ = vec3<f32>(_e156.member[0], _e156.member[1], _e156.member[2]);
                            }
                            let _e285 = phi_499_;
                            let _e291 = bitcast<f32>((bitcast<u32>((_e263 * _e267)) ^ _e156.member_3[0]));
                            let _e295 = bitcast<f32>((bitcast<u32>((_e264 * _e266)) ^ _e156.member_3[0]));
                            let _e299 = bitcast<f32>((bitcast<u32>((_e264 * _e268)) ^ _e156.member_3[0]));
                            let _e303 = bitcast<f32>((bitcast<u32>((_e265 * _e267)) ^ _e156.member_3[0]));
                            let _e307 = bitcast<f32>((bitcast<u32>((_e265 * _e266)) ^ _e156.member_3[0]));
                            let _e311 = bitcast<f32>((bitcast<u32>((_e263 * _e268)) ^ _e156.member_3[0]));
                            let _e312 = (_e299 - _e303);
                            let _e313 = (_e307 - _e311);
                            let _e314 = (_e291 - _e295);
                            let _e331 = ((bitcast<f32>((bitcast<u32>((_e285.x * _e312)) ^ _e156.member_3[0])) + bitcast<f32>((bitcast<u32>((_e285.y * _e313)) ^ _e156.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e285.z * _e314)) ^ _e156.member_3[0])));
                            let _e338 = (bitcast<f32>((bitcast<u32>(_e299) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e303) & 2147483647u)));
                            let _e345 = (bitcast<f32>((bitcast<u32>(_e307) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e311) & 2147483647u)));
                            let _e352 = (bitcast<f32>((bitcast<u32>(_e291) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e295) & 2147483647u)));
                            if (_e156.member_2 == 0f) {
                                phi_681_ = 0f;
                            } else {
                                let _e382 = bitcast<f32>((bitcast<u32>(_e312) & 2147483647u));
                                let _e385 = bitcast<f32>((bitcast<u32>(_e313) & 2147483647u));
                                let _e388 = bitcast<f32>((bitcast<u32>(_e314) & 2147483647u));
                                let _e390 = select(_e388, _e385, (_e385 > _e388));
                                let _e394 = select(_e388, _e385, (_e385 < _e388));
                                let _e398 = select(_e385, _e382, (_e382 < _e385));
                                let _e400 = select(_e385, _e382, (_e382 > _e385));
                                let _e402 = select(_e388, _e400, (_e400 < _e388));
                                phi_681_ = bitcast<f32>((bitcast<u32>((_e156.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e390, _e382, (_e382 > _e390)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e402, _e398, (_e398 > _e402)))) ^ _e156.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e394, _e382, (_e382 < _e394)))) ^ _e156.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e338 + _e345) + _e352))) ^ _e156.member_3[0]))) * 1.0000005f)) ^ _e156.member_3[0])))) ^ _e156.member_3[0]));
                            }
                            let _e429 = phi_681_;
                            let _e435 = ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e285.x) & 2147483647u)) * _e338)) ^ _e156.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e285.y) & 2147483647u)) * _e345)) ^ _e156.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e285.z) & 2147483647u)) * _e352)) ^ _e156.member_3[0]))))) ^ _e156.member_3[0])) + _e429) + 0.0000000000000000000000000000000000001880791f);
                            let _e447 = (_e189 < arrayLength((&global_8.member)));
                            if _e447 {
                                if _e447 {
                                } else {
                                    phi_864_ = true;
                                    break;
                                }
                                let _e449 = global_8.member[_e189];
                                phi_717_ = _e449;
                            } else {
                                phi_717_ = 0i;
                            }
                            let _e451 = phi_717_;
                            phi_721_ = type_30(select(0u, 1u, !(((_e331 * f32(-(_e194))) > _e435))), select(0u, 1u, !(((_e331 * f32(_e194)) > _e435))), select(0u, 1u, (_e451 == 0i)), 0u);
                        }
                        let _e456 = phi_721_;
                        phi_732_ = type_30((_e160.member + _e456.member), (_e160.member_1 + _e456.member_1), (_e160.member_2 + _e456.member_2), 0u);
                    } else {
                        phi_732_ = _e160;
                    }
                    let _e468 = phi_732_;
                    phi_254_ = _e468;
                } else {
                    phi_254_ = type_30();
                }
                let _e470 = phi_254_;
                continue;
                continuing {
                    phi_250_ = _e173;
                    phi_253_ = _e470;
                    phi_864_ = false;
                    break if !(_e179);
                }
            }
            let _e473 = phi_864_;
            if _e473 {
                break;
            }
            let _e474 = (_e48 % 64u);
            let _e475 = (_e474 < 64u);
            if _e475 {
            } else {
                break;
            }
            let _e478 = local;
            let _e481 = local_1;
            let _e484 = local_2;
            let _e487 = local_3;
            global_10[_e474] = type_30(_e478.member, _e481.member_1, _e484.member_2, _e487.member_3);
            workgroupBarrier();
            phi_747_ = type_9(0u, 6u);
            phi_750_ = 32u;
            loop {
                let _e491 = phi_747_;
                let _e493 = phi_750_;
                if (_e491.member < _e491.member_1) {
                    phi_748_ = type_9((_e491.member + 1u), _e491.member_1);
                    phi_773_ = type_9(1u, _e491.member);
                } else {
                    phi_748_ = _e491;
                    phi_773_ = type_9(0u, type_9().member_1);
                }
                let _e506 = phi_748_;
                let _e508 = phi_773_;
                let _e511 = (bitcast<i32>(_e508.member) != 0i);
                if _e511 {
                    if (_e48 < _e493) {
                        if _e475 {
                        } else {
                            phi_901_ = true;
                            break;
                        }
                        let _e513 = global_10[_e474];
                        let _e518 = ((_e48 + _e493) % 64u);
                        if (_e518 < 64u) {
                        } else {
                            phi_901_ = true;
                            break;
                        }
                        let _e521 = global_10[_e518];
                        if _e475 {
                        } else {
                            phi_901_ = true;
                            break;
                        }
                        global_10[_e474] = type_30((_e513.member + _e521.member), (_e513.member_1 + _e521.member_1), (_e513.member_2 + _e521.member_2), 0u);
                    }
                    workgroupBarrier();
                    phi_751_ = (_e493 / 2u);
                } else {
                    phi_751_ = u32();
                }
                let _e531 = phi_751_;
                continue;
                continuing {
                    phi_747_ = _e506;
                    phi_750_ = _e531;
                    phi_901_ = _e473;
                    break if !(_e511);
                }
            }
            let _e534 = phi_901_;
            if _e534 {
                break;
            }
            if (_e48 == 0u) {
                let _e536 = (_e69 < arrayLength((&global_9.member)));
                if _e536 {
                    let _e538 = global_10[0u];
                    if _e536 {
                    } else {
                        break;
                    }
                    global_9.member[_e69] = type_30(_e538.member, _e538.member_1, _e538.member_2, _e538.member_3);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_counts(@builtin(workgroup_id) param: vec3<u32>, @builtin(local_invocation_index) param_1: u32) {
    global = param;
    global_1 = param_1;
    function_();
}
