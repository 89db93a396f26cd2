struct type_4 {
    member: array<u32>,
}

struct type_11 {
    member: array<array<u32, 3>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(2) 
var<storage> global_1: type_4;
@group(0) @binding(0) 
var<storage> global_2: type_11;
@group(0) @binding(1) 
var<storage> global_3: type_4;
@group(0) @binding(3) 
var<storage, read_write> global_4: type_11;

fn function_() {
    var phi_68_: u32;
    var phi_89_: u32;
    var phi_106_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e13 = global;
            let _e25 = (_e13.x + (_e13.y * 2097152u));
            let _e26 = (_e25 < arrayLength((&global_2.member)));
            if _e26 {
                let _e28 = (_e25 >> bitcast<u32>(5i));
                let _e29 = (_e28 < arrayLength((&global_3.member)));
                if _e29 {
                    if _e29 {
                    } else {
                        break;
                    }
                    let _e32 = global_3.member[_e28];
                    phi_68_ = _e32;
                } else {
                    phi_68_ = 0u;
                }
                let _e34 = phi_68_;
                let _e36 = ((_e25 & 31u) & 31u);
                if (((_e34 >> bitcast<u32>(_e36)) & 1u) == 1u) {
                    if _e29 {
                        if _e29 {
                        } else {
                            break;
                        }
                        let _e43 = global_3.member[_e28];
                        phi_89_ = _e43;
                    } else {
                        phi_89_ = 0u;
                    }
                    let _e45 = phi_89_;
                    let _e50 = (_e28 < arrayLength((&global_1.member)));
                    if _e50 {
                        if _e50 {
                        } else {
                            break;
                        }
                        let _e53 = global_1.member[_e28];
                        phi_106_ = _e53;
                    } else {
                        phi_106_ = 0u;
                    }
                    let _e55 = phi_106_;
                    let _e57 = (_e55 + countOneBits((_e45 & ~((4294967295u << bitcast<u32>(_e36))))));
                    let _e58 = (_e57 < arrayLength((&global_4.member)));
                    if _e58 {
                        if _e26 {
                        } else {
                            break;
                        }
                        let _e61 = global_2.member[_e25];
                        if _e58 {
                        } else {
                            break;
                        }
                        global_4.member[_e57] = _e61;
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn classify_compact_63_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
