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
    var phi_75_: type_7;
    var phi_78_: u32;
    var phi_76_: type_7;
    var phi_101_: type_7;
    var phi_132_: array<u32, 2>;
    var phi_146_: array<u32, 2>;
    var phi_161_: u32;
    var phi_162_: i32;
    var phi_163_: u32;
    var phi_170_: i32;
    var phi_188_: array<u32, 2>;
    var phi_202_: array<u32, 2>;
    var phi_217_: u32;
    var phi_218_: i32;
    var phi_219_: u32;
    var phi_226_: i32;
    var phi_233_: type_15;
    var phi_255_: array<u32, 2>;
    var phi_269_: array<u32, 2>;
    var phi_284_: u32;
    var phi_285_: i32;
    var phi_286_: u32;
    var phi_293_: i32;
    var phi_299_: u32;
    var phi_79_: u32;
    var phi_320_: bool;
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
                    phi_75_ = type_7(0u, 32u);
                    phi_78_ = 0u;
                    loop {
                        let _e40 = phi_75_;
                        let _e42 = phi_78_;
                        local = _e42;
                        local_1 = _e42;
                        if (_e40.member < _e40.member_1) {
                            phi_76_ = type_7((_e40.member + 1u), _e40.member_1);
                            phi_101_ = type_7(1u, _e40.member);
                        } else {
                            phi_76_ = _e40;
                            phi_101_ = type_7(0u, type_7().member_1);
                        }
                        let _e55 = phi_76_;
                        let _e57 = phi_101_;
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
                                            phi_320_ = true;
                                            break;
                                        }
                                        let _e68 = global_3.member[_e62];
                                        phi_132_ = _e68;
                                    } else {
                                        phi_132_ = array<u32, 2>(0u, 0u);
                                    }
                                    let _e70 = phi_132_;
                                    if _e64 {
                                        if _e64 {
                                        } else {
                                            phi_320_ = true;
                                            break;
                                        }
                                        let _e75 = global_3.member[_e63];
                                        phi_146_ = _e75;
                                    } else {
                                        phi_146_ = array<u32, 2>(0u, 0u);
                                    }
                                    let _e77 = phi_146_;
                                    let _e80 = (_e70[0] ^ _e77[0]);
                                    let _e81 = (_e70[1] ^ _e77[1]);
                                    if (_e80 == 0u) {
                                        let _e83 = (_e81 == 0u);
                                        if _e83 {
                                            phi_161_ = (_e62 ^ _e63);
                                        } else {
                                            phi_161_ = _e81;
                                        }
                                        let _e86 = phi_161_;
                                        phi_162_ = select(32i, 64i, _e83);
                                        phi_163_ = _e86;
                                    } else {
                                        phi_162_ = 0i;
                                        phi_163_ = _e80;
                                    }
                                    let _e89 = phi_162_;
                                    let _e91 = phi_163_;
                                    phi_170_ = (_e89 + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e91)), 32u, (_e91 == 0u))));
                                } else {
                                    phi_170_ = -1i;
                                }
                                let _e100 = phi_170_;
                                let _e101 = (_e62 + 4294967295u);
                                let _e102 = (_e101 < _e27);
                                if _e102 {
                                    let _e103 = (_e62 < _e27);
                                    if _e103 {
                                        if _e103 {
                                        } else {
                                            phi_320_ = true;
                                            break;
                                        }
                                        let _e106 = global_3.member[_e62];
                                        phi_188_ = _e106;
                                    } else {
                                        phi_188_ = array<u32, 2>(0u, 0u);
                                    }
                                    let _e108 = phi_188_;
                                    if _e102 {
                                        if _e102 {
                                        } else {
                                            phi_320_ = true;
                                            break;
                                        }
                                        let _e113 = global_3.member[_e101];
                                        phi_202_ = _e113;
                                    } else {
                                        phi_202_ = array<u32, 2>(0u, 0u);
                                    }
                                    let _e115 = phi_202_;
                                    let _e118 = (_e108[0] ^ _e115[0]);
                                    let _e119 = (_e108[1] ^ _e115[1]);
                                    if (_e118 == 0u) {
                                        let _e121 = (_e119 == 0u);
                                        if _e121 {
                                            phi_217_ = (_e62 ^ _e101);
                                        } else {
                                            phi_217_ = _e119;
                                        }
                                        let _e124 = phi_217_;
                                        phi_218_ = select(32i, 64i, _e121);
                                        phi_219_ = _e124;
                                    } else {
                                        phi_218_ = 0i;
                                        phi_219_ = _e118;
                                    }
                                    let _e127 = phi_218_;
                                    let _e129 = phi_219_;
                                    phi_226_ = (_e127 + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e129)), 32u, (_e129 == 0u))));
                                } else {
                                    phi_226_ = -1i;
                                }
                                let _e138 = phi_226_;
                                if (_e100 > _e138) {
                                    phi_233_ = type_15(1i, _e138);
                                } else {
                                    phi_233_ = type_15(-1i, _e100);
                                }
                                let _e143 = phi_233_;
                                let _e148 = (_e62 + bitcast<u32>((_e143.member * 4i)));
                                let _e149 = (_e148 < _e27);
                                if _e149 {
                                    let _e150 = (_e62 < _e27);
                                    if _e150 {
                                        if _e150 {
                                        } else {
                                            phi_320_ = true;
                                            break;
                                        }
                                        let _e153 = global_3.member[_e62];
                                        phi_255_ = _e153;
                                    } else {
                                        phi_255_ = array<u32, 2>(0u, 0u);
                                    }
                                    let _e155 = phi_255_;
                                    if _e149 {
                                        if _e149 {
                                        } else {
                                            phi_320_ = true;
                                            break;
                                        }
                                        let _e160 = global_3.member[_e148];
                                        phi_269_ = _e160;
                                    } else {
                                        phi_269_ = array<u32, 2>(0u, 0u);
                                    }
                                    let _e162 = phi_269_;
                                    let _e165 = (_e155[0] ^ _e162[0]);
                                    let _e166 = (_e155[1] ^ _e162[1]);
                                    if (_e165 == 0u) {
                                        let _e168 = (_e166 == 0u);
                                        if _e168 {
                                            phi_284_ = (_e62 ^ _e148);
                                        } else {
                                            phi_284_ = _e166;
                                        }
                                        let _e171 = phi_284_;
                                        phi_285_ = select(32i, 64i, _e168);
                                        phi_286_ = _e171;
                                    } else {
                                        phi_285_ = 0i;
                                        phi_286_ = _e165;
                                    }
                                    let _e174 = phi_285_;
                                    let _e176 = phi_286_;
                                    phi_293_ = (_e174 + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e176)), 32u, (_e176 == 0u))));
                                } else {
                                    phi_293_ = -1i;
                                }
                                let _e185 = phi_293_;
                                phi_299_ = (_e42 | (select(0u, 1u, (_e185 > _e143.member_1)) << bitcast<u32>((_e57.member_1 & 31u))));
                            } else {
                                phi_299_ = _e42;
                            }
                            let _e193 = phi_299_;
                            phi_79_ = _e193;
                        } else {
                            phi_79_ = u32();
                        }
                        let _e195 = phi_79_;
                        continue;
                        continuing {
                            phi_75_ = _e55;
                            phi_78_ = _e195;
                            phi_320_ = false;
                            break if !(_e61);
                        }
                    }
                    let _e198 = phi_320_;
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
