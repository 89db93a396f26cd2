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
    var phi_75_: type_10;
    var phi_78_: u32;
    var phi_76_: type_10;
    var phi_101_: type_10;
    var phi_120_: u32;
    var phi_79_: u32;
    var phi_288_: bool;
    var local: u32;
    var phi_131_: type_10;
    var phi_134_: u32;
    var phi_132_: type_10;
    var phi_157_: type_10;
    var phi_186_: u32;
    var phi_135_: u32;
    var phi_295_: bool;
    var local_1: u32;
    var phi_223_: type_10;
    var phi_226_: u32;
    var phi_224_: type_10;
    var phi_249_: type_10;
    var phi_275_: u32;
    var phi_227_: u32;
    var phi_277_: bool;
    var phi_300_: bool;

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
            phi_75_ = _e40;
            phi_78_ = 0u;
            loop {
                let _e42 = phi_75_;
                let _e44 = phi_78_;
                local = _e44;
                local_1 = _e44;
                if (_e42.member < _e42.member_1) {
                    phi_76_ = type_10((_e42.member + 1u), _e42.member_1);
                    phi_101_ = type_10(1u, _e42.member);
                } else {
                    phi_76_ = _e42;
                    phi_101_ = type_10(0u, type_10().member_1);
                }
                let _e57 = phi_76_;
                let _e59 = phi_101_;
                let _e63 = (bitcast<i32>(_e59.member) != 0i);
                if _e63 {
                    let _e64 = (_e59.member_1 < _e26);
                    if _e64 {
                        if _e64 {
                        } else {
                            phi_288_ = true;
                            break;
                        }
                        let _e67 = global_3.member[_e59.member_1];
                        phi_120_ = _e67;
                    } else {
                        phi_120_ = 0u;
                    }
                    let _e69 = phi_120_;
                    phi_79_ = (_e44 + _e69);
                } else {
                    phi_79_ = u32();
                }
                let _e72 = phi_79_;
                continue;
                continuing {
                    phi_75_ = _e57;
                    phi_78_ = _e72;
                    phi_288_ = false;
                    break if !(_e63);
                }
            }
            let _e75 = phi_288_;
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
            phi_131_ = type_10(0u, 6u);
            phi_134_ = 1u;
            loop {
                let _e82 = phi_131_;
                let _e84 = phi_134_;
                if (_e82.member < _e82.member_1) {
                    phi_132_ = type_10((_e82.member + 1u), _e82.member_1);
                    phi_157_ = type_10(1u, _e82.member);
                } else {
                    phi_132_ = _e82;
                    phi_157_ = type_10(0u, type_10().member_1);
                }
                let _e97 = phi_132_;
                let _e99 = phi_157_;
                let _e102 = (bitcast<i32>(_e99.member) != 0i);
                if _e102 {
                    if _e77 {
                    } else {
                        phi_295_ = true;
                        break;
                    }
                    let _e103 = global_4[_e76];
                    if (_e22 >= _e84) {
                        let _e106 = ((_e22 - _e84) % 64u);
                        if (_e106 < 64u) {
                        } else {
                            phi_295_ = true;
                            break;
                        }
                        let _e109 = global_4[_e106];
                        phi_186_ = (_e103 + _e109);
                    } else {
                        phi_186_ = _e103;
                    }
                    let _e112 = phi_186_;
                    workgroupBarrier();
                    if _e77 {
                    } else {
                        phi_295_ = true;
                        break;
                    }
                    global_4[_e76] = _e112;
                    workgroupBarrier();
                    phi_135_ = (_e84 * 2u);
                } else {
                    phi_135_ = u32();
                }
                let _e115 = phi_135_;
                continue;
                continuing {
                    phi_131_ = _e97;
                    phi_134_ = _e115;
                    phi_295_ = _e75;
                    break if !(_e102);
                }
            }
            let _e118 = phi_295_;
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
                phi_223_ = _e40;
                phi_226_ = ((_e119 - _e121) + _e126);
                loop {
                    let _e129 = phi_223_;
                    let _e131 = phi_226_;
                    if (_e129.member < _e129.member_1) {
                        phi_224_ = type_10((_e129.member + 1u), _e129.member_1);
                        phi_249_ = type_10(1u, _e129.member);
                    } else {
                        phi_224_ = _e129;
                        phi_249_ = type_10(0u, type_10().member_1);
                    }
                    let _e144 = phi_224_;
                    let _e146 = phi_249_;
                    if (bitcast<i32>(_e146.member) != 0i) {
                        let _e151 = (_e146.member_1 >= _e26);
                        if _e151 {
                            phi_275_ = u32();
                        } else {
                            let _e152 = (_e146.member_1 < _e26);
                            if _e152 {
                            } else {
                                phi_300_ = true;
                                break;
                            }
                            let _e155 = global_3.member[_e146.member_1];
                            if _e152 {
                            } else {
                                phi_300_ = true;
                                break;
                            }
                            global_3.member[_e146.member_1] = _e131;
                            phi_275_ = (_e131 + _e155);
                        }
                        let _e158 = phi_275_;
                        phi_227_ = _e158;
                        phi_277_ = select(true, false, _e151);
                    } else {
                        phi_227_ = u32();
                        phi_277_ = false;
                    }
                    let _e161 = phi_227_;
                    let _e163 = phi_277_;
                    continue;
                    continuing {
                        phi_223_ = _e144;
                        phi_226_ = _e161;
                        phi_300_ = _e118;
                        break if !(_e163);
                    }
                }
                let _e166 = phi_300_;
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
