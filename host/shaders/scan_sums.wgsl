struct type_5 {
    member: array<u32>,
}

struct type_10 {
    member: u32,
    member_1: u32,
}

var<private> global: vec3<u32>;
var<private> global_1: u32;
var<workgroup> global_2: array<u32, 64>;
@group(0) @binding(0) 
var<storage> global_3: type_5;
@group(0) @binding(1) 
var<storage, read_write> global_4: type_5;

fn function_() {
    var phi_75_: type_10;
    var phi_78_: u32;
    var phi_76_: type_10;
    var phi_101_: type_10;
    var phi_120_: u32;
    var phi_79_: u32;
    var phi_232_: bool;
    var local: u32;
    var phi_131_: type_10;
    var phi_134_: u32;
    var phi_132_: type_10;
    var phi_157_: type_10;
    var phi_186_: u32;
    var phi_135_: u32;
    var phi_239_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e22 = global;
            let _e23 = global_1;
            let _e25 = arrayLength((&global_3.member));
            let _e31 = (_e22.x + (_e22.y * 32768u));
            let _e34 = ((_e31 * 1024u) + (_e23 * 16u));
            let _e36 = select(_e25, _e34, (_e34 < _e25));
            let _e37 = (_e25 - _e36);
            phi_75_ = type_10(_e36, (_e36 + select(16u, _e37, (_e37 < 16u))));
            phi_78_ = 0u;
            loop {
                let _e43 = phi_75_;
                let _e45 = phi_78_;
                local = _e45;
                if (_e43.member < _e43.member_1) {
                    phi_76_ = type_10((_e43.member + 1u), _e43.member_1);
                    phi_101_ = type_10(1u, _e43.member);
                } else {
                    phi_76_ = _e43;
                    phi_101_ = type_10(0u, type_10().member_1);
                }
                let _e58 = phi_76_;
                let _e60 = phi_101_;
                let _e64 = (bitcast<i32>(_e60.member) != 0i);
                if _e64 {
                    let _e65 = (_e60.member_1 < _e25);
                    if _e65 {
                        if _e65 {
                        } else {
                            phi_232_ = true;
                            break;
                        }
                        let _e68 = global_3.member[_e60.member_1];
                        phi_120_ = _e68;
                    } else {
                        phi_120_ = 0u;
                    }
                    let _e70 = phi_120_;
                    phi_79_ = (_e45 + _e70);
                } else {
                    phi_79_ = u32();
                }
                let _e73 = phi_79_;
                continue;
                continuing {
                    phi_75_ = _e58;
                    phi_78_ = _e73;
                    phi_232_ = false;
                    break if !(_e64);
                }
            }
            let _e76 = phi_232_;
            if _e76 {
                break;
            }
            let _e77 = (_e23 % 64u);
            let _e78 = (_e77 < 64u);
            if _e78 {
            } else {
                break;
            }
            let _e81 = local;
            global_2[_e77] = _e81;
            workgroupBarrier();
            phi_131_ = type_10(0u, 6u);
            phi_134_ = 1u;
            loop {
                let _e83 = phi_131_;
                let _e85 = phi_134_;
                if (_e83.member < _e83.member_1) {
                    phi_132_ = type_10((_e83.member + 1u), _e83.member_1);
                    phi_157_ = type_10(1u, _e83.member);
                } else {
                    phi_132_ = _e83;
                    phi_157_ = type_10(0u, type_10().member_1);
                }
                let _e98 = phi_132_;
                let _e100 = phi_157_;
                let _e103 = (bitcast<i32>(_e100.member) != 0i);
                if _e103 {
                    if _e78 {
                    } else {
                        phi_239_ = true;
                        break;
                    }
                    let _e104 = global_2[_e77];
                    if (_e23 >= _e85) {
                        let _e107 = ((_e23 - _e85) % 64u);
                        if (_e107 < 64u) {
                        } else {
                            phi_239_ = true;
                            break;
                        }
                        let _e110 = global_2[_e107];
                        phi_186_ = (_e104 + _e110);
                    } else {
                        phi_186_ = _e104;
                    }
                    let _e113 = phi_186_;
                    workgroupBarrier();
                    if _e78 {
                    } else {
                        phi_239_ = true;
                        break;
                    }
                    global_2[_e77] = _e113;
                    workgroupBarrier();
                    phi_135_ = (_e85 * 2u);
                } else {
                    phi_135_ = u32();
                }
                let _e116 = phi_135_;
                continue;
                continuing {
                    phi_131_ = _e98;
                    phi_134_ = _e116;
                    phi_239_ = _e76;
                    break if !(_e103);
                }
            }
            let _e119 = phi_239_;
            if _e119 {
                break;
            }
            if _e78 {
            } else {
                break;
            }
            if (_e23 == 0u) {
                let _e121 = (_e31 < arrayLength((&global_4.member)));
                if _e121 {
                    let _e123 = global_2[63u];
                    if _e121 {
                    } else {
                        break;
                    }
                    global_4.member[_e31] = _e123;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn scan_sums(@builtin(workgroup_id) param: vec3<u32>, @builtin(local_invocation_index) param_1: u32) {
    global = param;
    global_1 = param_1;
    function_();
}
