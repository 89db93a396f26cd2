struct type_8 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_10 {
    member: array<type_8>,
}

struct type_12 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_13 {
    member: type_12,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_15 {
    member: array<type_13>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<storage> global_1: type_10;
@group(0) @binding(1) 
var<storage, read_write> global_2: type_15;

fn function_() {
    switch bitcast<i32>(0u) {
        default: {
            let _e17 = global;
            let _e25 = (_e17.x + (_e17.y * 2097152u));
            let _e26 = (_e25 < arrayLength((&global_2.member)));
            if _e26 {
                let _e27 = (_e25 < arrayLength((&global_1.member)));
                if _e27 {
                    if _e27 {
                    } else {
                        break;
                    }
                    let _e31 = global_1.member[_e25].member_3;
                    if (_e31 != 4294967295u) {
                        if _e26 {
                        } else {
                            break;
                        }
                        let _e35 = global_2.member[_e25];
                        if _e27 {
                        } else {
                            break;
                        }
                        let _e36 = (_e31 + 1u);
                        let _e40 = ((_e36 ^ (_e36 >> bitcast<u32>(16i))) * 2146121005u);
                        let _e44 = ((_e40 ^ (_e40 >> bitcast<u32>(15i))) * 2221713035u);
                        let _e47 = (_e44 ^ (_e44 >> bitcast<u32>(16i)));
                        if _e26 {
                        } else {
                            break;
                        }
                        global_2.member[_e25] = type_13(_e35.member, _e35.member_1, _e35.member_2, array<f32, 3>((_e35.member_3[0] + ((f32((_e47 & 255u)) * 0.003921569f) * _e35.member_1[0])), (_e35.member_3[1] + ((f32(((_e47 >> bitcast<u32>(8u)) & 255u)) * 0.003921569f) * _e35.member_1[1])), (_e35.member_3[2] + ((f32(((_e47 >> bitcast<u32>(16u)) & 255u)) * 0.003921569f) * _e35.member_1[2]))), _e35.member_4);
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn view_primitives(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
