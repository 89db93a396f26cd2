struct type_3 {
    member: u32,
    member_1: u32,
}

struct type_5 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_7 {
    member: array<type_5>,
}

var<private> global: u32;
var<workgroup> global_1: array<type_5, 64>;
@group(0) @binding(0) 
var<storage> global_2: type_7;
@group(0) @binding(1) 
var<storage, read_write> global_3: type_7;

fn function_() {
    var phi_65_: u32;
    var phi_68_: type_3;
    var phi_71_: type_5;
    var phi_69_: type_3;
    var phi_94_: type_3;
    var phi_116_: type_5;
    var phi_72_: type_5;
    var phi_271_: bool;
    var local: type_5;
    var local_1: type_5;
    var local_2: type_5;
    var local_3: type_5;
    var phi_141_: type_3;
    var phi_144_: u32;
    var phi_142_: type_3;
    var phi_167_: type_3;
    var phi_145_: u32;
    var phi_277_: bool;
    var phi_251_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e20 = global;
            let _e22 = arrayLength((&global_2.member));
            let _e24 = arrayLength((&global_3.member));
            let _e25 = (_e22 / 64u);
            if ((_e22 % 64u) > 0u) {
                phi_65_ = (_e25 + 1u);
            } else {
                phi_65_ = _e25;
            }
            let _e30 = phi_65_;
            phi_68_ = type_3(0u, _e30);
            phi_71_ = type_5(0u, 0u, 0u, 0u);
            loop {
                let _e33 = phi_68_;
                let _e35 = phi_71_;
                local = _e35;
                local_1 = _e35;
                local_2 = _e35;
                local_3 = _e35;
                if (_e33.member < _e33.member_1) {
                    phi_69_ = type_3((_e33.member + 1u), _e33.member_1);
                    phi_94_ = type_3(1u, _e33.member);
                } else {
                    phi_69_ = _e33;
                    phi_94_ = type_3(0u, type_3().member_1);
                }
                let _e48 = phi_69_;
                let _e50 = phi_94_;
                let _e54 = (bitcast<i32>(_e50.member) != 0i);
                if _e54 {
                    let _e56 = ((_e50.member_1 * 64u) + _e20);
                    let _e57 = (_e56 < _e22);
                    if _e57 {
                        if _e57 {
                        } else {
                            phi_271_ = true;
                            break;
                        }
                        let _e60 = global_2.member[_e56];
                        phi_116_ = _e60;
                    } else {
                        phi_116_ = type_5(0u, 0u, 0u, 0u);
                    }
                    let _e62 = phi_116_;
                    phi_72_ = type_5((_e35.member + _e62.member), (_e35.member_1 + _e62.member_1), (_e35.member_2 + _e62.member_2), 0u);
                } else {
                    phi_72_ = type_5();
                }
                let _e74 = phi_72_;
                continue;
                continuing {
                    phi_68_ = _e48;
                    phi_71_ = _e74;
                    phi_271_ = false;
                    break if !(_e54);
                }
            }
            let _e77 = phi_271_;
            if _e77 {
                break;
            }
            let _e78 = (_e20 % 64u);
            let _e79 = (_e78 < 64u);
            if _e79 {
            } else {
                break;
            }
            let _e82 = local;
            let _e85 = local_1;
            let _e88 = local_2;
            let _e91 = local_3;
            global_1[_e78] = type_5(_e82.member, _e85.member_1, _e88.member_2, _e91.member_3);
            workgroupBarrier();
            phi_141_ = type_3(0u, 6u);
            phi_144_ = 32u;
            loop {
                let _e95 = phi_141_;
                let _e97 = phi_144_;
                if (_e95.member < _e95.member_1) {
                    phi_142_ = type_3((_e95.member + 1u), _e95.member_1);
                    phi_167_ = type_3(1u, _e95.member);
                } else {
                    phi_142_ = _e95;
                    phi_167_ = type_3(0u, type_3().member_1);
                }
                let _e110 = phi_142_;
                let _e112 = phi_167_;
                let _e115 = (bitcast<i32>(_e112.member) != 0i);
                if _e115 {
                    if (_e20 < _e97) {
                        if _e79 {
                        } else {
                            phi_277_ = true;
                            break;
                        }
                        let _e117 = global_1[_e78];
                        let _e122 = ((_e20 + _e97) % 64u);
                        if (_e122 < 64u) {
                        } else {
                            phi_277_ = true;
                            break;
                        }
                        let _e125 = global_1[_e122];
                        if _e79 {
                        } else {
                            phi_277_ = true;
                            break;
                        }
                        global_1[_e78] = type_5((_e117.member + _e125.member), (_e117.member_1 + _e125.member_1), (_e117.member_2 + _e125.member_2), 0u);
                    }
                    workgroupBarrier();
                    phi_145_ = (_e97 / 2u);
                } else {
                    phi_145_ = u32();
                }
                let _e135 = phi_145_;
                continue;
                continuing {
                    phi_141_ = _e110;
                    phi_144_ = _e135;
                    phi_277_ = _e77;
                    break if !(_e115);
                }
            }
            let _e138 = phi_277_;
            if _e138 {
                break;
            }
            if (_e20 == 0u) {
                if (_e24 == 0u) {
                } else {
                    let _e142 = global_1[0u];
                    if (_e142.member_2 == 0u) {
                        phi_251_ = (_e142.member_1 < _e142.member);
                    } else {
                        phi_251_ = false;
                    }
                    let _e149 = phi_251_;
                    if (0u < _e24) {
                    } else {
                        break;
                    }
                    global_3.member[0u] = type_5(_e142.member, _e142.member_1, _e142.member_2, select(0u, 1u, _e149));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_smaller(@builtin(local_invocation_index) param: u32) {
    global = param;
    function_();
}
