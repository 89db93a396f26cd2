struct type_3 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_14 {
    member: array<array<u32, 4>>,
}

var<private> global: u32;
var<workgroup> global_1: array<u32, 64>;
@group(0) @binding(0) 
var<storage, read_write> global_2: type_3;
@group(0) @binding(1) 
var<storage, read_write> global_3: type_14;

fn function_() {
    var phi_71_: u32;
    var phi_89_: type_8;
    var phi_92_: u32;
    var phi_90_: type_8;
    var phi_115_: type_8;
    var phi_134_: u32;
    var phi_93_: u32;
    var phi_341_: bool;
    var local: u32;
    var phi_145_: type_8;
    var phi_148_: u32;
    var phi_146_: type_8;
    var phi_171_: type_8;
    var phi_200_: u32;
    var phi_149_: u32;
    var phi_349_: bool;
    var local_1: u32;
    var phi_221_: type_8;
    var phi_224_: u32;
    var phi_222_: type_8;
    var phi_247_: type_8;
    var phi_273_: u32;
    var phi_225_: u32;
    var phi_275_: bool;
    var phi_354_: bool;
    var phi_301_: u32;
    var phi_322_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e21 = global;
            let _e23 = arrayLength((&global_2.member));
            let _e25 = arrayLength((&global_3.member));
            let _e26 = (_e23 / 64u);
            if ((_e23 % 64u) > 0u) {
                phi_71_ = (_e26 + 1u);
            } else {
                phi_71_ = _e26;
            }
            let _e31 = phi_71_;
            let _e32 = (_e21 * _e31);
            let _e34 = select(_e23, _e32, (_e32 < _e23));
            let _e35 = (_e23 - _e34);
            let _e39 = type_8(_e34, (_e34 + select(_e31, _e35, (_e35 < _e31))));
            phi_89_ = _e39;
            phi_92_ = 0u;
            loop {
                let _e41 = phi_89_;
                let _e43 = phi_92_;
                local = _e43;
                local_1 = _e43;
                if (_e41.member < _e41.member_1) {
                    phi_90_ = type_8((_e41.member + 1u), _e41.member_1);
                    phi_115_ = type_8(1u, _e41.member);
                } else {
                    phi_90_ = _e41;
                    phi_115_ = type_8(0u, type_8().member_1);
                }
                let _e56 = phi_90_;
                let _e58 = phi_115_;
                let _e62 = (bitcast<i32>(_e58.member) != 0i);
                if _e62 {
                    let _e63 = (_e58.member_1 < _e23);
                    if _e63 {
                        if _e63 {
                        } else {
                            phi_341_ = true;
                            break;
                        }
                        let _e66 = global_2.member[_e58.member_1];
                        phi_134_ = _e66;
                    } else {
                        phi_134_ = 0u;
                    }
                    let _e68 = phi_134_;
                    phi_93_ = (_e43 + _e68);
                } else {
                    phi_93_ = u32();
                }
                let _e71 = phi_93_;
                continue;
                continuing {
                    phi_89_ = _e56;
                    phi_92_ = _e71;
                    phi_341_ = false;
                    break if !(_e62);
                }
            }
            let _e74 = phi_341_;
            if _e74 {
                break;
            }
            let _e75 = (_e21 % 64u);
            let _e76 = (_e75 < 64u);
            if _e76 {
            } else {
                break;
            }
            let _e79 = local;
            global_1[_e75] = _e79;
            workgroupBarrier();
            phi_145_ = type_8(0u, 6u);
            phi_148_ = 1u;
            loop {
                let _e81 = phi_145_;
                let _e83 = phi_148_;
                if (_e81.member < _e81.member_1) {
                    phi_146_ = type_8((_e81.member + 1u), _e81.member_1);
                    phi_171_ = type_8(1u, _e81.member);
                } else {
                    phi_146_ = _e81;
                    phi_171_ = type_8(0u, type_8().member_1);
                }
                let _e96 = phi_146_;
                let _e98 = phi_171_;
                let _e101 = (bitcast<i32>(_e98.member) != 0i);
                if _e101 {
                    if _e76 {
                    } else {
                        phi_349_ = true;
                        break;
                    }
                    let _e102 = global_1[_e75];
                    if (_e21 >= _e83) {
                        let _e105 = ((_e21 - _e83) % 64u);
                        if (_e105 < 64u) {
                        } else {
                            phi_349_ = true;
                            break;
                        }
                        let _e108 = global_1[_e105];
                        phi_200_ = (_e102 + _e108);
                    } else {
                        phi_200_ = _e102;
                    }
                    let _e111 = phi_200_;
                    workgroupBarrier();
                    if _e76 {
                    } else {
                        phi_349_ = true;
                        break;
                    }
                    global_1[_e75] = _e111;
                    workgroupBarrier();
                    phi_149_ = (_e83 * 2u);
                } else {
                    phi_149_ = u32();
                }
                let _e114 = phi_149_;
                continue;
                continuing {
                    phi_145_ = _e96;
                    phi_148_ = _e114;
                    phi_349_ = _e74;
                    break if !(_e101);
                }
            }
            let _e117 = phi_349_;
            if _e117 {
                break;
            }
            if _e76 {
            } else {
                break;
            }
            let _e118 = global_1[_e75];
            let _e120 = local_1;
            phi_221_ = _e39;
            phi_224_ = (_e118 - _e120);
            loop {
                let _e123 = phi_221_;
                let _e125 = phi_224_;
                if (_e123.member < _e123.member_1) {
                    phi_222_ = type_8((_e123.member + 1u), _e123.member_1);
                    phi_247_ = type_8(1u, _e123.member);
                } else {
                    phi_222_ = _e123;
                    phi_247_ = type_8(0u, type_8().member_1);
                }
                let _e138 = phi_222_;
                let _e140 = phi_247_;
                if (bitcast<i32>(_e140.member) != 0i) {
                    let _e145 = (_e140.member_1 >= _e23);
                    if _e145 {
                        phi_273_ = u32();
                    } else {
                        let _e146 = (_e140.member_1 < _e23);
                        if _e146 {
                        } else {
                            phi_354_ = true;
                            break;
                        }
                        let _e149 = global_2.member[_e140.member_1];
                        if _e146 {
                        } else {
                            phi_354_ = true;
                            break;
                        }
                        global_2.member[_e140.member_1] = _e125;
                        phi_273_ = (_e125 + _e149);
                    }
                    let _e152 = phi_273_;
                    phi_225_ = _e152;
                    phi_275_ = select(true, false, _e145);
                } else {
                    phi_225_ = u32();
                    phi_275_ = false;
                }
                let _e155 = phi_225_;
                let _e157 = phi_275_;
                continue;
                continuing {
                    phi_221_ = _e138;
                    phi_224_ = _e155;
                    phi_354_ = _e117;
                    break if !(_e157);
                }
            }
            let _e160 = phi_354_;
            if _e160 {
                break;
            }
            if (_e21 == 0u) {
                if (_e25 == 0u) {
                } else {
                    let _e164 = global_1[63u];
                    let _e165 = (_e164 / 64u);
                    if ((_e164 % 64u) > 0u) {
                        phi_301_ = (_e165 + 1u);
                    } else {
                        phi_301_ = _e165;
                    }
                    let _e170 = phi_301_;
                    let _e173 = (_e170 / 32768u);
                    if ((_e170 % 32768u) > 0u) {
                        phi_322_ = (_e173 + 1u);
                    } else {
                        phi_322_ = _e173;
                    }
                    let _e178 = phi_322_;
                    if (0u < _e25) {
                    } else {
                        break;
                    }
                    global_3.member[0u][0u] = _e164;
                    global_3.member[0u][1u] = select(32768u, _e170, (_e170 < 32768u));
                    global_3.member[0u][2u] = _e178;
                    global_3.member[0u][3u] = 1u;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn scan_blocks(@builtin(local_invocation_index) param: u32) {
    global = param;
    function_();
}
