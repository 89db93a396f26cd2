struct type_5 {
    member: array<u32>,
}

struct type_10 {
    member: u32,
    member_1: u32,
}

var<private> global: vec3<u32>;
var<private> global_1: u32;
@group(0) @binding(0) 
var<storage> global_2: type_5;
@group(0) @binding(1) 
var<storage, read_write> global_3: type_5;
var<workgroup> global_4: array<u32, 64>;

fn function_() {
    var phi_74_: type_10;
    var phi_77_: u32;
    var phi_75_: type_10;
    var phi_100_: type_10;
    var phi_119_: u32;
    var phi_78_: u32;
    var phi_287_: bool;
    var local: u32;
    var phi_130_: type_10;
    var phi_133_: u32;
    var phi_131_: type_10;
    var phi_156_: type_10;
    var phi_185_: u32;
    var phi_134_: u32;
    var phi_294_: bool;
    var local_1: u32;
    var phi_222_: type_10;
    var phi_225_: u32;
    var phi_223_: type_10;
    var phi_248_: type_10;
    var phi_274_: u32;
    var phi_226_: u32;
    var phi_276_: bool;
    var phi_299_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e21 = global;
            let _e22 = global_1;
            let _e26 = arrayLength((&global_3.member));
            let _e30 = (_e21.x + (_e21.y * 32768u));
            let _e33 = ((_e30 * 1024u) + (_e22 * 16u));
            let _e35 = select(_e26, _e33, (_e33 < _e26));
            let _e36 = (_e26 - _e35);
            let _e40 = type_10(_e35, (_e35 + select(16u, _e36, (_e36 < 16u))));
            phi_74_ = _e40;
            phi_77_ = 0u;
            loop {
                let _e42 = phi_74_;
                let _e44 = phi_77_;
                local = _e44;
                local_1 = _e44;
                if (_e42.member < _e42.member_1) {
                    phi_75_ = type_10((_e42.member + 1u), _e42.member_1);
                    phi_100_ = type_10(1u, _e42.member);
                } else {
                    phi_75_ = _e42;
                    phi_100_ = type_10(0u, type_10().member_1);
                }
                let _e57 = phi_75_;
                let _e59 = phi_100_;
                let _e63 = (bitcast<i32>(_e59.member) != 0i);
                if _e63 {
                    let _e64 = (_e59.member_1 < _e26);
                    if _e64 {
                        if _e64 {
                        } else {
                            phi_287_ = true;
                            break;
                        }
                        let _e67 = global_3.member[_e59.member_1];
                        phi_119_ = _e67;
                    } else {
                        phi_119_ = 0u;
                    }
                    let _e69 = phi_119_;
                    phi_78_ = (_e44 + _e69);
                } else {
                    phi_78_ = u32();
                }
                let _e72 = phi_78_;
                continue;
                continuing {
                    phi_74_ = _e57;
                    phi_77_ = _e72;
                    phi_287_ = false;
                    break if !(_e63);
                }
            }
            let _e75 = phi_287_;
            if _e75 {
                break;
            }
            let _e76 = (_e22 % 64u);
            let _e77 = (_e76 < 64u);
            if _e77 {
            } else {
                break;
            }
            let _e80 = local;
            global_4[_e76] = _e80;
            workgroupBarrier();
            phi_130_ = type_10(0u, 6u);
            phi_133_ = 1u;
            loop {
                let _e82 = phi_130_;
                let _e84 = phi_133_;
                if (_e82.member < _e82.member_1) {
                    phi_131_ = type_10((_e82.member + 1u), _e82.member_1);
                    phi_156_ = type_10(1u, _e82.member);
                } else {
                    phi_131_ = _e82;
                    phi_156_ = type_10(0u, type_10().member_1);
                }
                let _e97 = phi_131_;
                let _e99 = phi_156_;
                let _e102 = (bitcast<i32>(_e99.member) != 0i);
                if _e102 {
                    if _e77 {
                    } else {
                        phi_294_ = true;
                        break;
                    }
                    let _e103 = global_4[_e76];
                    if (_e22 >= _e84) {
                        let _e106 = ((_e22 - _e84) % 64u);
                        if (_e106 < 64u) {
                        } else {
                            phi_294_ = true;
                            break;
                        }
                        let _e109 = global_4[_e106];
                        phi_185_ = (_e103 + _e109);
                    } else {
                        phi_185_ = _e103;
                    }
                    let _e112 = phi_185_;
                    workgroupBarrier();
                    if _e77 {
                    } else {
                        phi_294_ = true;
                        break;
                    }
                    global_4[_e76] = _e112;
                    workgroupBarrier();
                    phi_134_ = (_e84 * 2u);
                } else {
                    phi_134_ = u32();
                }
                let _e115 = phi_134_;
                continue;
                continuing {
                    phi_130_ = _e97;
                    phi_133_ = _e115;
                    phi_294_ = _e75;
                    break if !(_e102);
                }
            }
            let _e118 = phi_294_;
            if _e118 {
                break;
            }
            if _e77 {
            } else {
                break;
            }
            let _e119 = global_4[_e76];
            let _e121 = local_1;
            let _e123 = (_e30 < arrayLength((&global_2.member)));
            if _e123 {
                if _e123 {
                } else {
                    break;
                }
                let _e126 = global_2.member[_e30];
                phi_222_ = _e40;
                phi_225_ = ((_e119 - _e121) + _e126);
                loop {
                    let _e129 = phi_222_;
                    let _e131 = phi_225_;
                    if (_e129.member < _e129.member_1) {
                        phi_223_ = type_10((_e129.member + 1u), _e129.member_1);
                        phi_248_ = type_10(1u, _e129.member);
                    } else {
                        phi_223_ = _e129;
                        phi_248_ = type_10(0u, type_10().member_1);
                    }
                    let _e144 = phi_223_;
                    let _e146 = phi_248_;
                    if (bitcast<i32>(_e146.member) != 0i) {
                        let _e151 = (_e146.member_1 >= _e26);
                        if _e151 {
                            phi_274_ = u32();
                        } else {
                            let _e152 = (_e146.member_1 < _e26);
                            if _e152 {
                            } else {
                                phi_299_ = true;
                                break;
                            }
                            let _e155 = global_3.member[_e146.member_1];
                            if _e152 {
                            } else {
                                phi_299_ = true;
                                break;
                            }
                            global_3.member[_e146.member_1] = _e131;
                            phi_274_ = (_e131 + _e155);
                        }
                        let _e158 = phi_274_;
                        phi_226_ = _e158;
                        phi_276_ = select(true, false, _e151);
                    } else {
                        phi_226_ = u32();
                        phi_276_ = false;
                    }
                    let _e161 = phi_226_;
                    let _e163 = phi_276_;
                    continue;
                    continuing {
                        phi_222_ = _e144;
                        phi_225_ = _e161;
                        phi_299_ = _e118;
                        break if !(_e163);
                    }
                }
                let _e166 = phi_299_;
                if _e166 {
                    break;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn scan_apply(@builtin(workgroup_id) param: vec3<u32>, @builtin(local_invocation_index) param_1: u32) {
    global = param;
    global_1 = param_1;
    function_();
}
