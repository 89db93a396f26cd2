struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: vec4<u32>,
}

struct type_15 {
    member: i32,
    member_1: i32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(2) 
var<storage, read_write> global_2: type_4;
@group(0) @binding(3) 
var<storage, read_write> global_3: type_4;
@group(0) @binding(1) 
var<storage> global_4: type_4;

fn function_() {
    var phi_87_: type_8;
    var phi_90_: u32;
    var phi_88_: type_8;
    var phi_113_: type_8;
    var phi_146_: u32;
    var phi_160_: u32;
    var phi_168_: u32;
    var phi_175_: i32;
    var phi_195_: u32;
    var phi_209_: u32;
    var phi_217_: u32;
    var phi_224_: i32;
    var phi_231_: type_15;
    var phi_255_: u32;
    var phi_269_: u32;
    var phi_277_: u32;
    var phi_284_: i32;
    var phi_290_: u32;
    var phi_91_: u32;
    var phi_312_: bool;
    var phi_291_: u32;
    var local: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e24 = global;
            let _e27 = arrayLength((&global_4.member));
            let _e34 = global_1.member[0u];
            let _e38 = (_e24.x + (_e24.y * 2097152u));
            let _e39 = (_e38 < arrayLength((&global_2.member)));
            if _e39 {
                let _e40 = (_e38 < arrayLength((&global_3.member)));
                if _e40 {
                    if (_e34 <= 6u) {
                        phi_291_ = select(0u, 1u, (_e38 == 0u));
                    } else {
                        phi_87_ = type_8(0u, 32u);
                        phi_90_ = 0u;
                        loop {
                            let _e44 = phi_87_;
                            let _e46 = phi_90_;
                            local = _e46;
                            if (_e44.member < _e44.member_1) {
                                phi_88_ = type_8((_e44.member + 1u), _e44.member_1);
                                phi_113_ = type_8(1u, _e44.member);
                            } else {
                                phi_88_ = _e44;
                                phi_113_ = type_8(0u, type_8().member_1);
                            }
                            let _e59 = phi_88_;
                            let _e61 = phi_113_;
                            let _e65 = (bitcast<i32>(_e61.member) != 0i);
                            if _e65 {
                                let _e66 = ((_e38 * 32u) + _e61.member_1);
                                let _e67 = (_e66 + 1u);
                                let _e68 = (_e67 < _e34);
                                if _e68 {
                                    if _e68 {
                                        let _e69 = (_e66 < _e27);
                                        if _e69 {
                                            if _e69 {
                                            } else {
                                                phi_312_ = true;
                                                break;
                                            }
                                            let _e71 = global_4.member[_e66];
                                            phi_146_ = _e71;
                                        } else {
                                            phi_146_ = 0u;
                                        }
                                        let _e73 = phi_146_;
                                        let _e74 = (_e67 < _e27);
                                        if _e74 {
                                            if _e74 {
                                            } else {
                                                phi_312_ = true;
                                                break;
                                            }
                                            let _e76 = global_4.member[_e67];
                                            phi_160_ = _e76;
                                        } else {
                                            phi_160_ = 0u;
                                        }
                                        let _e78 = phi_160_;
                                        let _e79 = (_e73 ^ _e78);
                                        let _e80 = (_e79 == 0u);
                                        if _e80 {
                                            phi_168_ = (_e66 ^ _e67);
                                        } else {
                                            phi_168_ = _e79;
                                        }
                                        let _e83 = phi_168_;
                                        phi_175_ = (select(0i, 32i, _e80) + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e83)), 32u, (_e83 == 0u))));
                                    } else {
                                        phi_175_ = -1i;
                                    }
                                    let _e93 = phi_175_;
                                    let _e94 = (_e66 + 4294967295u);
                                    if (_e94 < _e34) {
                                        let _e96 = (_e66 < _e27);
                                        if _e96 {
                                            if _e96 {
                                            } else {
                                                phi_312_ = true;
                                                break;
                                            }
                                            let _e98 = global_4.member[_e66];
                                            phi_195_ = _e98;
                                        } else {
                                            phi_195_ = 0u;
                                        }
                                        let _e100 = phi_195_;
                                        let _e101 = (_e94 < _e27);
                                        if _e101 {
                                            if _e101 {
                                            } else {
                                                phi_312_ = true;
                                                break;
                                            }
                                            let _e103 = global_4.member[_e94];
                                            phi_209_ = _e103;
                                        } else {
                                            phi_209_ = 0u;
                                        }
                                        let _e105 = phi_209_;
                                        let _e106 = (_e100 ^ _e105);
                                        let _e107 = (_e106 == 0u);
                                        if _e107 {
                                            phi_217_ = (_e66 ^ _e94);
                                        } else {
                                            phi_217_ = _e106;
                                        }
                                        let _e110 = phi_217_;
                                        phi_224_ = (select(0i, 32i, _e107) + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e110)), 32u, (_e110 == 0u))));
                                    } else {
                                        phi_224_ = -1i;
                                    }
                                    let _e120 = phi_224_;
                                    if (_e93 > _e120) {
                                        phi_231_ = type_15(1i, _e120);
                                    } else {
                                        phi_231_ = type_15(-1i, _e93);
                                    }
                                    let _e125 = phi_231_;
                                    let _e130 = (_e66 + bitcast<u32>((_e125.member * 6i)));
                                    if (_e130 < _e34) {
                                        let _e132 = (_e66 < _e27);
                                        if _e132 {
                                            if _e132 {
                                            } else {
                                                phi_312_ = true;
                                                break;
                                            }
                                            let _e134 = global_4.member[_e66];
                                            phi_255_ = _e134;
                                        } else {
                                            phi_255_ = 0u;
                                        }
                                        let _e136 = phi_255_;
                                        let _e137 = (_e130 < _e27);
                                        if _e137 {
                                            if _e137 {
                                            } else {
                                                phi_312_ = true;
                                                break;
                                            }
                                            let _e139 = global_4.member[_e130];
                                            phi_269_ = _e139;
                                        } else {
                                            phi_269_ = 0u;
                                        }
                                        let _e141 = phi_269_;
                                        let _e142 = (_e136 ^ _e141);
                                        let _e143 = (_e142 == 0u);
                                        if _e143 {
                                            phi_277_ = (_e66 ^ _e130);
                                        } else {
                                            phi_277_ = _e142;
                                        }
                                        let _e146 = phi_277_;
                                        phi_284_ = (select(0i, 32i, _e143) + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e146)), 32u, (_e146 == 0u))));
                                    } else {
                                        phi_284_ = -1i;
                                    }
                                    let _e156 = phi_284_;
                                    phi_290_ = (_e46 | (select(0u, 1u, (_e156 > _e125.member_1)) << bitcast<u32>((_e61.member_1 & 31u))));
                                } else {
                                    phi_290_ = _e46;
                                }
                                let _e164 = phi_290_;
                                phi_91_ = _e164;
                            } else {
                                phi_91_ = u32();
                            }
                            let _e166 = phi_91_;
                            continue;
                            continuing {
                                phi_87_ = _e59;
                                phi_90_ = _e166;
                                phi_312_ = false;
                                break if !(_e65);
                            }
                        }
                        let _e169 = phi_312_;
                        if _e169 {
                            break;
                        }
                        let _e201 = local;
                        phi_291_ = _e201;
                    }
                    let _e173 = phi_291_;
                    if _e39 {
                    } else {
                        break;
                    }
                    global_2.member[_e38] = _e173;
                    if _e40 {
                    } else {
                        break;
                    }
                    global_3.member[_e38] = countOneBits(_e173);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn topology_kept_30_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
