struct type_4 {
    member: array<u32>,
}

struct type_9 {
    member: vec4<u32>,
}

struct type_14 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_15 {
    member: type_14,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_17 {
    member: array<type_15>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_9;
@group(0) @binding(2) 
var<storage, read_write> global_2: type_17;
@group(0) @binding(1) 
var<storage> global_3: type_4;

fn function_() {
    switch bitcast<i32>(0u) {
        default: {
            let _e14 = global;
            let _e22 = (_e14.x + (_e14.y * 2097152u));
            let _e23 = (_e22 < arrayLength((&global_2.member)));
            if _e23 {
                let _e24 = (_e22 < arrayLength((&global_3.member)));
                if _e24 {
                    if _e23 {
                    } else {
                        break;
                    }
                    let _e27 = global_2.member[_e22];
                    if _e24 {
                    } else {
                        break;
                    }
                    let _e30 = global_3.member[_e22];
                    let _e33 = global_1.member[0u];
                    let _e35 = f32(_e33);
                    let _e38 = (f32(_e30) / select(1f, _e35, (_e35 > 1f)));
                    let _e41 = (select(1f, _e38, (_e38 < 1f)) * 4f);
                    let _e43 = select(1f, _e41, (_e41 < 1f));
                    let _e46 = (_e41 - 1f);
                    let _e48 = select(1f, _e46, (_e46 < 1f));
                    let _e50 = select(0f, _e48, (_e48 > 0f));
                    let _e51 = (_e41 - 2f);
                    let _e53 = select(1f, _e51, (_e51 < 1f));
                    let _e56 = (_e41 - 3f);
                    let _e58 = select(1f, _e56, (_e56 < 1f));
                    if _e23 {
                    } else {
                        break;
                    }
                    global_2.member[_e22] = type_15(_e27.member, _e27.member_1, _e27.member_2, array<f32, 3>((_e27.member_3[0] + (_e50 * _e27.member_1[0])), (_e27.member_3[1] + (select(0f, _e53, (_e53 > 0f)) * _e27.member_1[1])), (_e27.member_3[2] + ((((0.6f * select(0f, _e43, (_e43 > 0f))) * (1f - _e50)) + select(0f, _e58, (_e58 > 0f))) * _e27.member_1[2]))), _e27.member_4);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn view_heat(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
