struct type_4 {
    member: array<u32>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<storage> global_1: type_4;
@group(0) @binding(1) 
var<storage> global_2: type_4;
@group(0) @binding(2) 
var<storage, read_write> global_3: type_4;

fn function_() {
    var phi_54_: u32;
    var phi_75_: u32;
    var phi_92_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e11 = global;
            let _e21 = (_e11.x + (_e11.y * 2097152u));
            let _e23 = (_e21 >> bitcast<u32>(5i));
            let _e24 = (_e23 < arrayLength((&global_1.member)));
            if _e24 {
                if _e24 {
                } else {
                    break;
                }
                let _e27 = global_1.member[_e23];
                phi_54_ = _e27;
            } else {
                phi_54_ = 0u;
            }
            let _e29 = phi_54_;
            let _e31 = ((_e21 & 31u) & 31u);
            if (((_e29 >> bitcast<u32>(_e31)) & 1u) == 1u) {
                if _e24 {
                    if _e24 {
                    } else {
                        break;
                    }
                    let _e38 = global_1.member[_e23];
                    phi_75_ = _e38;
                } else {
                    phi_75_ = 0u;
                }
                let _e40 = phi_75_;
                let _e45 = (_e23 < arrayLength((&global_2.member)));
                if _e45 {
                    if _e45 {
                    } else {
                        break;
                    }
                    let _e48 = global_2.member[_e23];
                    phi_92_ = _e48;
                } else {
                    phi_92_ = 0u;
                }
                let _e50 = phi_92_;
                let _e52 = (_e50 + countOneBits((_e40 & ~((4294967295u << bitcast<u32>(_e31))))));
                let _e53 = (_e52 < arrayLength((&global_3.member)));
                if _e53 {
                    if _e53 {
                    } else {
                        break;
                    }
                    global_3.member[_e52] = _e21;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn compact(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
