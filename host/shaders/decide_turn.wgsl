struct type_7 {
    member: array<i32>,
}

struct type_10 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_12 {
    member: array<type_10>,
}

struct type_14 {
    member: u32,
    member_1: u32,
    member_2: u32,
}

struct type_16 {
    member: array<type_14>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<storage> global_1: type_12;
@group(0) @binding(1) 
var<storage> global_2: type_16;
@group(0) @binding(2) 
var<storage, read_write> global_3: type_7;

fn function_() {
    switch bitcast<i32>(0u) {
        default: {
            let _e9 = global;
            let _e11 = arrayLength((&global_1.member));
            let _e19 = (_e9.x + (_e9.y * 2097152u));
            let _e20 = (_e19 < arrayLength((&global_2.member)));
            if _e20 {
                if (_e11 == 0u) {
                } else {
                    if (0u < _e11) {
                    } else {
                        break;
                    }
                    let _e26 = global_1.member[0u].member_3;
                    if (_e26 == 1u) {
                        if _e20 {
                        } else {
                            break;
                        }
                        let _e31 = global_2.member[_e19].member;
                        let _e32 = (_e31 < arrayLength((&global_3.member)));
                        if _e32 {
                            if _e32 {
                            } else {
                                break;
                            }
                            let _e35 = global_3.member[_e31];
                            if _e32 {
                            } else {
                                break;
                            }
                            global_3.member[_e31] = -(_e35);
                        }
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_turn(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
