struct type_5 {
    member: array<u32>,
}

struct type_10 {
    member: u32,
    member_1: u32,
}

struct type_16 {
    member: array<array<u32, 3>>,
}

var<private> global: u32;
var<private> global_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_2: type_5;
@group(0) @binding(2) 
var<storage, read_write> global_3: type_5;
@group(0) @binding(3) 
var<storage, read_write> global_4: type_5;
var<workgroup> global_5: array<u32, 64>;
@group(0) @binding(0) 
var<storage> global_6: type_16;

fn function_() {
    var phi_94_: u32;
    var phi_101_: u32;
    var phi_129_: type_10;
    var phi_132_: u32;
    var phi_130_: type_10;
    var phi_155_: type_10;
    var phi_133_: u32;
    var phi_195_: bool;
    var local: u32;
    var local_1: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e24 = global_1;
            let _e25 = global;
            let _e37 = (_e24.x + (_e24.y * 2097152u));
            let _e38 = (_e37 < arrayLength((&global_6.member)));
            if _e38 {
                if _e38 {
                } else {
                    break;
                }
                let _e42 = global_6.member[_e37][2u];
                let _e44 = (_e42 >> bitcast<u32>(5i));
                let _e45 = (_e44 < arrayLength((&global_2.member)));
                if _e45 {
                    if _e45 {
                    } else {
                        break;
                    }
                    let _e48 = global_2.member[_e44];
                    phi_94_ = _e48;
                } else {
                    phi_94_ = 0u;
                }
                let _e50 = phi_94_;
                phi_101_ = select(0u, 1u, (((_e50 >> bitcast<u32>(((_e42 & 31u) & 31u))) & 1u) == 1u));
            } else {
                phi_101_ = 0u;
            }
            let _e59 = phi_101_;
            let _e60 = (_e25 % 64u);
            if (_e60 < 64u) {
            } else {
                break;
            }
            global_5[_e60] = _e59;
            workgroupBarrier();
            let _e63 = (_e37 / 32u);
            if ((_e25 & 31u) == 0u) {
                let _e66 = (_e63 < arrayLength((&global_3.member)));
                if _e66 {
                    let _e67 = (_e63 < arrayLength((&global_4.member)));
                    if _e67 {
                        phi_129_ = type_10(0u, 32u);
                        phi_132_ = 0u;
                        loop {
                            let _e69 = phi_129_;
                            let _e71 = phi_132_;
                            local = _e71;
                            local_1 = _e71;
                            if (_e69.member < _e69.member_1) {
                                phi_130_ = type_10((_e69.member + 1u), _e69.member_1);
                                phi_155_ = type_10(1u, _e69.member);
                            } else {
                                phi_130_ = _e69;
                                phi_155_ = type_10(0u, type_10().member_1);
                            }
                            let _e84 = phi_130_;
                            let _e86 = phi_155_;
                            let _e90 = (bitcast<i32>(_e86.member) != 0i);
                            if _e90 {
                                let _e92 = ((_e25 + _e86.member_1) % 64u);
                                if (_e92 < 64u) {
                                } else {
                                    phi_195_ = true;
                                    break;
                                }
                                let _e95 = global_5[_e92];
                                phi_133_ = (_e71 | (_e95 << bitcast<u32>((_e86.member_1 & 31u))));
                            } else {
                                phi_133_ = u32();
                            }
                            let _e101 = phi_133_;
                            continue;
                            continuing {
                                phi_129_ = _e84;
                                phi_132_ = _e101;
                                phi_195_ = false;
                                break if !(_e90);
                            }
                        }
                        let _e104 = phi_195_;
                        if _e104 {
                            break;
                        }
                        if _e66 {
                        } else {
                            break;
                        }
                        let _e108 = local;
                        global_3.member[_e63] = _e108;
                        let _e110 = local_1;
                        if _e67 {
                        } else {
                            break;
                        }
                        global_4.member[_e63] = countOneBits(_e110);
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn classify_order_63_(@builtin(global_invocation_id) param: vec3<u32>, @builtin(local_invocation_index) param_1: u32) {
    global_1 = param;
    global = param_1;
    function_();
}
