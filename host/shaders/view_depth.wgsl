struct type_6 {
    member: vec4<u32>,
}

struct type_11 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_13 {
    member: array<type_11>,
}

struct type_15 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_16 {
    member: type_15,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_18 {
    member: array<type_16>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_6;
@group(0) @binding(1) 
var<storage> global_2: type_13;
@group(0) @binding(2) 
var<storage, read_write> global_3: type_18;

fn function_() {
    switch bitcast<i32>(0u) {
        default: {
            let _e15 = global;
            let _e23 = (_e15.x + (_e15.y * 2097152u));
            let _e24 = (_e23 < arrayLength((&global_3.member)));
            if _e24 {
                let _e25 = (_e23 < arrayLength((&global_2.member)));
                if _e25 {
                    if _e25 {
                    } else {
                        break;
                    }
                    let _e29 = global_2.member[_e23].member_3;
                    if (_e29 != 4294967295u) {
                        let _e33 = global_1.member[0u];
                        let _e34 = bitcast<f32>(_e33);
                        let _e37 = global_1.member[1u];
                        let _e38 = bitcast<f32>(_e37);
                        if _e24 {
                        } else {
                            break;
                        }
                        let _e41 = global_3.member[_e23];
                        if _e25 {
                        } else {
                            break;
                        }
                        let _e45 = global_2.member[_e23].member;
                        let _e47 = (_e38 - _e34);
                        let _e52 = (((_e45 - _e34) / select(0.000000000000000000000000000000000000011754944f, _e47, (_e47 > 0.000000000000000000000000000000000000011754944f))) * (_e38 / _e45));
                        let _e54 = select(1f, _e52, (_e52 < 1f));
                        let _e58 = (0.9f - (0.85f * select(0f, _e54, (_e54 > 0f))));
                        if _e24 {
                        } else {
                            break;
                        }
                        global_3.member[_e23] = type_16(_e41.member, _e41.member_1, _e41.member_2, array<f32, 3>((_e41.member_3[0] + (_e58 * _e41.member_1[0])), (_e41.member_3[1] + (_e58 * _e41.member_1[1])), (_e41.member_3[2] + (_e58 * _e41.member_1[2]))), _e41.member_4);
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn view_depth(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
