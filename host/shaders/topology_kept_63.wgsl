struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_11 {
    member: vec4<u32>,
}

struct type_16 {
    member: array<array<u32, 2>>,
}

struct type_20 {
    member: i32,
    member_1: i32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_11;
@group(0) @binding(2) 
var<storage, read_write> global_2: type_4;
@group(0) @binding(3) 
var<storage, read_write> global_3: type_4;
@group(0) @binding(1) 
var<storage> global_4: type_16;

fn function_() {
    var phi_96_: type_7;
    var phi_99_: u32;
    var phi_97_: type_7;
    var phi_122_: type_7;
    var phi_155_: array<u32, 2>;
    var phi_171_: array<u32, 2>;
    var phi_186_: u32;
    var phi_187_: i32;
    var phi_188_: u32;
    var phi_195_: i32;
    var phi_215_: array<u32, 2>;
    var phi_231_: array<u32, 2>;
    var phi_246_: u32;
    var phi_247_: i32;
    var phi_248_: u32;
    var phi_255_: i32;
    var phi_262_: type_20;
    var phi_286_: array<u32, 2>;
    var phi_302_: array<u32, 2>;
    var phi_317_: u32;
    var phi_318_: i32;
    var phi_319_: u32;
    var phi_326_: i32;
    var phi_332_: u32;
    var phi_100_: u32;
    var phi_354_: bool;
    var phi_333_: u32;
    var local: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e27 = global;
            let _e30 = arrayLength((&global_4.member));
            let _e37 = global_1.member[0u];
            let _e41 = (_e27.x + (_e27.y * 2097152u));
            let _e42 = (_e41 < arrayLength((&global_2.member)));
            if _e42 {
                let _e43 = (_e41 < arrayLength((&global_3.member)));
                if _e43 {
                    if (_e37 <= 6u) {
                        phi_333_ = select(0u, 1u, (_e41 == 0u));
                    } else {
                        phi_96_ = type_7(0u, 32u);
                        phi_99_ = 0u;
                        loop {
                            let _e47 = phi_96_;
                            let _e49 = phi_99_;
                            local = _e49;
                            if (_e47.member < _e47.member_1) {
                                phi_97_ = type_7((_e47.member + 1u), _e47.member_1);
                                phi_122_ = type_7(1u, _e47.member);
                            } else {
                                phi_97_ = _e47;
                                phi_122_ = type_7(0u, type_7().member_1);
                            }
                            let _e62 = phi_97_;
                            let _e64 = phi_122_;
                            let _e68 = (bitcast<i32>(_e64.member) != 0i);
                            if _e68 {
                                let _e69 = ((_e41 * 32u) + _e64.member_1);
                                let _e70 = (_e69 + 1u);
                                let _e71 = (_e70 < _e37);
                                if _e71 {
                                    if _e71 {
                                        let _e72 = (_e69 < _e30);
                                        if _e72 {
                                            if _e72 {
                                            } else {
                                                phi_354_ = true;
                                                break;
                                            }
                                            let _e74 = global_4.member[_e69];
                                            phi_155_ = _e74;
                                        } else {
                                            phi_155_ = array<u32, 2>(0u, 0u);
                                        }
                                        let _e76 = phi_155_;
                                        let _e79 = (_e70 < _e30);
                                        if _e79 {
                                            if _e79 {
                                            } else {
                                                phi_354_ = true;
                                                break;
                                            }
                                            let _e81 = global_4.member[_e70];
                                            phi_171_ = _e81;
                                        } else {
                                            phi_171_ = array<u32, 2>(0u, 0u);
                                        }
                                        let _e83 = phi_171_;
                                        let _e86 = (_e76[0] ^ _e83[0]);
                                        let _e87 = (_e76[1] ^ _e83[1]);
                                        if (_e86 == 0u) {
                                            let _e89 = (_e87 == 0u);
                                            if _e89 {
                                                phi_186_ = (_e69 ^ _e70);
                                            } else {
                                                phi_186_ = _e87;
                                            }
                                            let _e92 = phi_186_;
                                            phi_187_ = select(32i, 64i, _e89);
                                            phi_188_ = _e92;
                                        } else {
                                            phi_187_ = 0i;
                                            phi_188_ = _e86;
                                        }
                                        let _e95 = phi_187_;
                                        let _e97 = phi_188_;
                                        phi_195_ = (_e95 + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e97)), 32u, (_e97 == 0u))));
                                    } else {
                                        phi_195_ = -1i;
                                    }
                                    let _e106 = phi_195_;
                                    let _e107 = (_e69 + 4294967295u);
                                    if (_e107 < _e37) {
                                        let _e109 = (_e69 < _e30);
                                        if _e109 {
                                            if _e109 {
                                            } else {
                                                phi_354_ = true;
                                                break;
                                            }
                                            let _e111 = global_4.member[_e69];
                                            phi_215_ = _e111;
                                        } else {
                                            phi_215_ = array<u32, 2>(0u, 0u);
                                        }
                                        let _e113 = phi_215_;
                                        let _e116 = (_e107 < _e30);
                                        if _e116 {
                                            if _e116 {
                                            } else {
                                                phi_354_ = true;
                                                break;
                                            }
                                            let _e118 = global_4.member[_e107];
                                            phi_231_ = _e118;
                                        } else {
                                            phi_231_ = array<u32, 2>(0u, 0u);
                                        }
                                        let _e120 = phi_231_;
                                        let _e123 = (_e113[0] ^ _e120[0]);
                                        let _e124 = (_e113[1] ^ _e120[1]);
                                        if (_e123 == 0u) {
                                            let _e126 = (_e124 == 0u);
                                            if _e126 {
                                                phi_246_ = (_e69 ^ _e107);
                                            } else {
                                                phi_246_ = _e124;
                                            }
                                            let _e129 = phi_246_;
                                            phi_247_ = select(32i, 64i, _e126);
                                            phi_248_ = _e129;
                                        } else {
                                            phi_247_ = 0i;
                                            phi_248_ = _e123;
                                        }
                                        let _e132 = phi_247_;
                                        let _e134 = phi_248_;
                                        phi_255_ = (_e132 + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e134)), 32u, (_e134 == 0u))));
                                    } else {
                                        phi_255_ = -1i;
                                    }
                                    let _e143 = phi_255_;
                                    if (_e106 > _e143) {
                                        phi_262_ = type_20(1i, _e143);
                                    } else {
                                        phi_262_ = type_20(-1i, _e106);
                                    }
                                    let _e148 = phi_262_;
                                    let _e153 = (_e69 + bitcast<u32>((_e148.member * 6i)));
                                    if (_e153 < _e37) {
                                        let _e155 = (_e69 < _e30);
                                        if _e155 {
                                            if _e155 {
                                            } else {
                                                phi_354_ = true;
                                                break;
                                            }
                                            let _e157 = global_4.member[_e69];
                                            phi_286_ = _e157;
                                        } else {
                                            phi_286_ = array<u32, 2>(0u, 0u);
                                        }
                                        let _e159 = phi_286_;
                                        let _e162 = (_e153 < _e30);
                                        if _e162 {
                                            if _e162 {
                                            } else {
                                                phi_354_ = true;
                                                break;
                                            }
                                            let _e164 = global_4.member[_e153];
                                            phi_302_ = _e164;
                                        } else {
                                            phi_302_ = array<u32, 2>(0u, 0u);
                                        }
                                        let _e166 = phi_302_;
                                        let _e169 = (_e159[0] ^ _e166[0]);
                                        let _e170 = (_e159[1] ^ _e166[1]);
                                        if (_e169 == 0u) {
                                            let _e172 = (_e170 == 0u);
                                            if _e172 {
                                                phi_317_ = (_e69 ^ _e153);
                                            } else {
                                                phi_317_ = _e170;
                                            }
                                            let _e175 = phi_317_;
                                            phi_318_ = select(32i, 64i, _e172);
                                            phi_319_ = _e175;
                                        } else {
                                            phi_318_ = 0i;
                                            phi_319_ = _e169;
                                        }
                                        let _e178 = phi_318_;
                                        let _e180 = phi_319_;
                                        phi_326_ = (_e178 + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e180)), 32u, (_e180 == 0u))));
                                    } else {
                                        phi_326_ = -1i;
                                    }
                                    let _e189 = phi_326_;
                                    phi_332_ = (_e49 | (select(0u, 1u, (_e189 > _e148.member_1)) << bitcast<u32>((_e64.member_1 & 31u))));
                                } else {
                                    phi_332_ = _e49;
                                }
                                let _e197 = phi_332_;
                                phi_100_ = _e197;
                            } else {
                                phi_100_ = u32();
                            }
                            let _e199 = phi_100_;
                            continue;
                            continuing {
                                phi_96_ = _e62;
                                phi_99_ = _e199;
                                phi_354_ = false;
                                break if !(_e68);
                            }
                        }
                        let _e202 = phi_354_;
                        if _e202 {
                            break;
                        }
                        let _e240 = local;
                        phi_333_ = _e240;
                    }
                    let _e206 = phi_333_;
                    if _e42 {
                    } else {
                        break;
                    }
                    global_2.member[_e41] = _e206;
                    if _e43 {
                    } else {
                        break;
                    }
                    global_3.member[_e41] = countOneBits(_e206);
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
