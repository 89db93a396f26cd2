struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: array<array<u32, 2>>,
}

struct type_15 {
    member: i32,
    member_1: i32,
}

var<private> global: vec3<u32>;
@group(0) @binding(1) 
var<storage, read_write> global_1: type_4;
@group(0) @binding(2) 
var<storage, read_write> global_2: type_4;
@group(0) @binding(0) 
var<storage> global_3: type_12;

fn function_() {
    var phi_74_: type_7;
    var phi_77_: u32;
    var phi_75_: type_7;
    var phi_100_: type_7;
    var phi_131_: array<u32, 2>;
    var phi_145_: array<u32, 2>;
    var phi_160_: u32;
    var phi_161_: i32;
    var phi_162_: u32;
    var phi_169_: i32;
    var phi_187_: array<u32, 2>;
    var phi_201_: array<u32, 2>;
    var phi_216_: u32;
    var phi_217_: i32;
    var phi_218_: u32;
    var phi_225_: i32;
    var phi_232_: type_15;
    var phi_254_: array<u32, 2>;
    var phi_268_: array<u32, 2>;
    var phi_283_: u32;
    var phi_284_: i32;
    var phi_285_: u32;
    var phi_292_: i32;
    var phi_298_: u32;
    var phi_78_: u32;
    var phi_319_: bool;
    var local: u32;
    var local_1: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e25 = global;
            let _e27 = arrayLength((&global_3.member));
            let _e35 = (_e25.x + (_e25.y * 2097152u));
            let _e36 = (_e35 < arrayLength((&global_1.member)));
            if _e36 {
                let _e37 = (_e35 < arrayLength((&global_2.member)));
                if _e37 {
                    phi_74_ = type_7(0u, 32u);
                    phi_77_ = 0u;
                    loop {
                        let _e40 = phi_74_;
                        let _e42 = phi_77_;
                        local = _e42;
                        local_1 = _e42;
                        if (_e40.member < _e40.member_1) {
                            phi_75_ = type_7((_e40.member + 1u), _e40.member_1);
                            phi_100_ = type_7(1u, _e40.member);
                        } else {
                            phi_75_ = _e40;
                            phi_100_ = type_7(0u, type_7().member_1);
                        }
                        let _e55 = phi_75_;
                        let _e57 = phi_100_;
                        let _e61 = (bitcast<i32>(_e57.member) != 0i);
                        if _e61 {
                            let _e62 = ((_e35 * 32u) + _e57.member_1);
                            let _e63 = (_e62 + 1u);
                            let _e64 = (_e63 < _e27);
                            if _e64 {
                                if _e64 {
                                    let _e65 = (_e62 < _e27);
                                    if _e65 {
                                        if _e65 {
                                        } else {
                                            phi_319_ = true;
                                            break;
                                        }
                                        let _e68 = global_3.member[_e62];
                                        phi_131_ = _e68;
                                    } else {
                                        phi_131_ = array<u32, 2>(0u, 0u);
                                    }
                                    let _e70 = phi_131_;
                                    if _e64 {
                                        if _e64 {
                                        } else {
                                            phi_319_ = true;
                                            break;
                                        }
                                        let _e75 = global_3.member[_e63];
                                        phi_145_ = _e75;
                                    } else {
                                        phi_145_ = array<u32, 2>(0u, 0u);
                                    }
                                    let _e77 = phi_145_;
                                    let _e80 = (_e70[0] ^ _e77[0]);
                                    let _e81 = (_e70[1] ^ _e77[1]);
                                    if (_e80 == 0u) {
                                        let _e83 = (_e81 == 0u);
                                        if _e83 {
                                            phi_160_ = (_e62 ^ _e63);
                                        } else {
                                            phi_160_ = _e81;
                                        }
                                        let _e86 = phi_160_;
                                        phi_161_ = select(32i, 64i, _e83);
                                        phi_162_ = _e86;
                                    } else {
                                        phi_161_ = 0i;
                                        phi_162_ = _e80;
                                    }
                                    let _e89 = phi_161_;
                                    let _e91 = phi_162_;
                                    phi_169_ = (_e89 + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e91)), 32u, (_e91 == 0u))));
                                } else {
                                    phi_169_ = -1i;
                                }
                                let _e100 = phi_169_;
                                let _e101 = (_e62 + 4294967295u);
                                let _e102 = (_e101 < _e27);
                                if _e102 {
                                    let _e103 = (_e62 < _e27);
                                    if _e103 {
                                        if _e103 {
                                        } else {
                                            phi_319_ = true;
                                            break;
                                        }
                                        let _e106 = global_3.member[_e62];
                                        phi_187_ = _e106;
                                    } else {
                                        phi_187_ = array<u32, 2>(0u, 0u);
                                    }
                                    let _e108 = phi_187_;
                                    if _e102 {
                                        if _e102 {
                                        } else {
                                            phi_319_ = true;
                                            break;
                                        }
                                        let _e113 = global_3.member[_e101];
                                        phi_201_ = _e113;
                                    } else {
                                        phi_201_ = array<u32, 2>(0u, 0u);
                                    }
                                    let _e115 = phi_201_;
                                    let _e118 = (_e108[0] ^ _e115[0]);
                                    let _e119 = (_e108[1] ^ _e115[1]);
                                    if (_e118 == 0u) {
                                        let _e121 = (_e119 == 0u);
                                        if _e121 {
                                            phi_216_ = (_e62 ^ _e101);
                                        } else {
                                            phi_216_ = _e119;
                                        }
                                        let _e124 = phi_216_;
                                        phi_217_ = select(32i, 64i, _e121);
                                        phi_218_ = _e124;
                                    } else {
                                        phi_217_ = 0i;
                                        phi_218_ = _e118;
                                    }
                                    let _e127 = phi_217_;
                                    let _e129 = phi_218_;
                                    phi_225_ = (_e127 + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e129)), 32u, (_e129 == 0u))));
                                } else {
                                    phi_225_ = -1i;
                                }
                                let _e138 = phi_225_;
                                if (_e100 > _e138) {
                                    phi_232_ = type_15(1i, _e138);
                                } else {
                                    phi_232_ = type_15(-1i, _e100);
                                }
                                let _e143 = phi_232_;
                                let _e148 = (_e62 + bitcast<u32>((_e143.member * 4i)));
                                let _e149 = (_e148 < _e27);
                                if _e149 {
                                    let _e150 = (_e62 < _e27);
                                    if _e150 {
                                        if _e150 {
                                        } else {
                                            phi_319_ = true;
                                            break;
                                        }
                                        let _e153 = global_3.member[_e62];
                                        phi_254_ = _e153;
                                    } else {
                                        phi_254_ = array<u32, 2>(0u, 0u);
                                    }
                                    let _e155 = phi_254_;
                                    if _e149 {
                                        if _e149 {
                                        } else {
                                            phi_319_ = true;
                                            break;
                                        }
                                        let _e160 = global_3.member[_e148];
                                        phi_268_ = _e160;
                                    } else {
                                        phi_268_ = array<u32, 2>(0u, 0u);
                                    }
                                    let _e162 = phi_268_;
                                    let _e165 = (_e155[0] ^ _e162[0]);
                                    let _e166 = (_e155[1] ^ _e162[1]);
                                    if (_e165 == 0u) {
                                        let _e168 = (_e166 == 0u);
                                        if _e168 {
                                            phi_283_ = (_e62 ^ _e148);
                                        } else {
                                            phi_283_ = _e166;
                                        }
                                        let _e171 = phi_283_;
                                        phi_284_ = select(32i, 64i, _e168);
                                        phi_285_ = _e171;
                                    } else {
                                        phi_284_ = 0i;
                                        phi_285_ = _e165;
                                    }
                                    let _e174 = phi_284_;
                                    let _e176 = phi_285_;
                                    phi_292_ = (_e174 + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e176)), 32u, (_e176 == 0u))));
                                } else {
                                    phi_292_ = -1i;
                                }
                                let _e185 = phi_292_;
                                phi_298_ = (_e42 | (select(0u, 1u, (_e185 > _e143.member_1)) << bitcast<u32>((_e57.member_1 & 31u))));
                            } else {
                                phi_298_ = _e42;
                            }
                            let _e193 = phi_298_;
                            phi_78_ = _e193;
                        } else {
                            phi_78_ = u32();
                        }
                        let _e195 = phi_78_;
                        continue;
                        continuing {
                            phi_74_ = _e55;
                            phi_77_ = _e195;
                            phi_319_ = false;
                            break if !(_e61);
                        }
                    }
                    let _e198 = phi_319_;
                    if _e198 {
                        break;
                    }
                    if _e36 {
                    } else {
                        break;
                    }
                    let _e202 = local;
                    global_1.member[_e35] = _e202;
                    let _e204 = local_1;
                    if _e37 {
                    } else {
                        break;
                    }
                    global_2.member[_e35] = countOneBits(_e204);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn topology_kept_63_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
