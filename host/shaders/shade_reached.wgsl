struct type_4 {
    member: array<u32>,
}

struct type_10 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_12 {
    member: type_10,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_14 {
    member: array<type_12>,
}

struct type_18 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<storage> global_1: type_14;
@group(0) @binding(1) 
var<storage, read_write> global_2: type_18;

fn function_() {
    switch bitcast<i32>(0u) {
        default: {
            let _e9 = global;
            let _e13 = arrayLength((&global_2.member));
            let _e17 = (_e9.x + (_e9.y * 2097152u));
            let _e18 = (_e17 < arrayLength((&global_1.member)));
            if _e18 {
                if _e18 {
                } else {
                    break;
                }
                let _e23 = global_1.member[_e17].member.member_1;
                let _e28 = global_1.member[_e17].member.member_3;
                let _e30 = select(0u, 1u, (_e23 <= _e28));
                if (_e30 > 0u) {
                    let _e32 = (1u < _e13);
                    if _e32 {
                        if (0u < _e13) {
                        } else {
                            break;
                        }
                        let _e36 = atomicAdd((&global_2.member[0u]), _e30);
                        if ((_e36 + _e30) < _e36) {
                            if _e32 {
                            } else {
                                break;
                            }
                            let _e41 = atomicAdd((&global_2.member[1u]), 1u);
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
fn shade_reached(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
