struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_10 {
    member: i32,
    member_1: i32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<storage> global_1: type_4;
@group(0) @binding(1) 
var<storage, read_write> global_2: type_4;
@group(0) @binding(2) 
var<storage, read_write> global_3: type_4;

fn function_() {
    var phi_66_: type_7;
    var phi_69_: u32;
    var phi_67_: type_7;
    var phi_92_: type_7;
    var phi_123_: u32;
    var phi_135_: u32;
    var phi_143_: u32;
    var phi_150_: i32;
    var phi_168_: u32;
    var phi_180_: u32;
    var phi_188_: u32;
    var phi_195_: i32;
    var phi_202_: type_10;
    var phi_224_: u32;
    var phi_236_: u32;
    var phi_244_: u32;
    var phi_251_: i32;
    var phi_257_: u32;
    var phi_70_: u32;
    var phi_278_: bool;
    var local: u32;
    var local_1: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e22 = global;
            let _e24 = arrayLength((&global_1.member));
            let _e32 = (_e22.x + (_e22.y * 2097152u));
            let _e33 = (_e32 < arrayLength((&global_2.member)));
            if _e33 {
                let _e34 = (_e32 < arrayLength((&global_3.member)));
                if _e34 {
                    phi_66_ = type_7(0u, 32u);
                    phi_69_ = 0u;
                    loop {
                        let _e37 = phi_66_;
                        let _e39 = phi_69_;
                        local = _e39;
                        local_1 = _e39;
                        if (_e37.member < _e37.member_1) {
                            phi_67_ = type_7((_e37.member + 1u), _e37.member_1);
                            phi_92_ = type_7(1u, _e37.member);
                        } else {
                            phi_67_ = _e37;
                            phi_92_ = type_7(0u, type_7().member_1);
                        }
                        let _e52 = phi_67_;
                        let _e54 = phi_92_;
                        let _e58 = (bitcast<i32>(_e54.member) != 0i);
                        if _e58 {
                            let _e59 = ((_e32 * 32u) + _e54.member_1);
                            let _e60 = (_e59 + 1u);
                            let _e61 = (_e60 < _e24);
                            if _e61 {
                                if _e61 {
                                    let _e62 = (_e59 < _e24);
                                    if _e62 {
                                        if _e62 {
                                        } else {
                                            phi_278_ = true;
                                            break;
                                        }
                                        let _e65 = global_1.member[_e59];
                                        phi_123_ = _e65;
                                    } else {
                                        phi_123_ = 0u;
                                    }
                                    let _e67 = phi_123_;
                                    if _e61 {
                                        if _e61 {
                                        } else {
                                            phi_278_ = true;
                                            break;
                                        }
                                        let _e70 = global_1.member[_e60];
                                        phi_135_ = _e70;
                                    } else {
                                        phi_135_ = 0u;
                                    }
                                    let _e72 = phi_135_;
                                    let _e73 = (_e67 ^ _e72);
                                    let _e74 = (_e73 == 0u);
                                    if _e74 {
                                        phi_143_ = (_e59 ^ _e60);
                                    } else {
                                        phi_143_ = _e73;
                                    }
                                    let _e77 = phi_143_;
                                    phi_150_ = (select(0i, 32i, _e74) + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e77)), 32u, (_e77 == 0u))));
                                } else {
                                    phi_150_ = -1i;
                                }
                                let _e87 = phi_150_;
                                let _e88 = (_e59 + 4294967295u);
                                let _e89 = (_e88 < _e24);
                                if _e89 {
                                    let _e90 = (_e59 < _e24);
                                    if _e90 {
                                        if _e90 {
                                        } else {
                                            phi_278_ = true;
                                            break;
                                        }
                                        let _e93 = global_1.member[_e59];
                                        phi_168_ = _e93;
                                    } else {
                                        phi_168_ = 0u;
                                    }
                                    let _e95 = phi_168_;
                                    if _e89 {
                                        if _e89 {
                                        } else {
                                            phi_278_ = true;
                                            break;
                                        }
                                        let _e98 = global_1.member[_e88];
                                        phi_180_ = _e98;
                                    } else {
                                        phi_180_ = 0u;
                                    }
                                    let _e100 = phi_180_;
                                    let _e101 = (_e95 ^ _e100);
                                    let _e102 = (_e101 == 0u);
                                    if _e102 {
                                        phi_188_ = (_e59 ^ _e88);
                                    } else {
                                        phi_188_ = _e101;
                                    }
                                    let _e105 = phi_188_;
                                    phi_195_ = (select(0i, 32i, _e102) + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e105)), 32u, (_e105 == 0u))));
                                } else {
                                    phi_195_ = -1i;
                                }
                                let _e115 = phi_195_;
                                if (_e87 > _e115) {
                                    phi_202_ = type_10(1i, _e115);
                                } else {
                                    phi_202_ = type_10(-1i, _e87);
                                }
                                let _e120 = phi_202_;
                                let _e125 = (_e59 + bitcast<u32>((_e120.member * 4i)));
                                let _e126 = (_e125 < _e24);
                                if _e126 {
                                    let _e127 = (_e59 < _e24);
                                    if _e127 {
                                        if _e127 {
                                        } else {
                                            phi_278_ = true;
                                            break;
                                        }
                                        let _e130 = global_1.member[_e59];
                                        phi_224_ = _e130;
                                    } else {
                                        phi_224_ = 0u;
                                    }
                                    let _e132 = phi_224_;
                                    if _e126 {
                                        if _e126 {
                                        } else {
                                            phi_278_ = true;
                                            break;
                                        }
                                        let _e135 = global_1.member[_e125];
                                        phi_236_ = _e135;
                                    } else {
                                        phi_236_ = 0u;
                                    }
                                    let _e137 = phi_236_;
                                    let _e138 = (_e132 ^ _e137);
                                    let _e139 = (_e138 == 0u);
                                    if _e139 {
                                        phi_244_ = (_e59 ^ _e125);
                                    } else {
                                        phi_244_ = _e138;
                                    }
                                    let _e142 = phi_244_;
                                    phi_251_ = (select(0i, 32i, _e139) + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e142)), 32u, (_e142 == 0u))));
                                } else {
                                    phi_251_ = -1i;
                                }
                                let _e152 = phi_251_;
                                phi_257_ = (_e39 | (select(0u, 1u, (_e152 > _e120.member_1)) << bitcast<u32>((_e54.member_1 & 31u))));
                            } else {
                                phi_257_ = _e39;
                            }
                            let _e160 = phi_257_;
                            phi_70_ = _e160;
                        } else {
                            phi_70_ = u32();
                        }
                        let _e162 = phi_70_;
                        continue;
                        continuing {
                            phi_66_ = _e52;
                            phi_69_ = _e162;
                            phi_278_ = false;
                            break if !(_e58);
                        }
                    }
                    let _e165 = phi_278_;
                    if _e165 {
                        break;
                    }
                    if _e33 {
                    } else {
                        break;
                    }
                    let _e169 = local;
                    global_2.member[_e32] = _e169;
                    let _e171 = local_1;
                    if _e34 {
                    } else {
                        break;
                    }
                    global_3.member[_e32] = countOneBits(_e171);
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
