struct type_4 {
    member: array<u32>,
}

struct type_9 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_11 {
    member: array<type_9>,
}

@group(0) @binding(1) 
var<storage, read_write> global: type_4;
var<private> global_1: vec3<u32>;
@group(0) @binding(0) 
var<storage> global_2: type_11;

fn function_() {
    switch bitcast<i32>(0u) {
        default: {
            let _e7 = global_1;
            let _e15 = (_e7.x + (_e7.y * 2097152u));
            let _e16 = (_e15 < arrayLength((&global_2.member)));
            if _e16 {
                let _e17 = (_e15 < arrayLength((&global.member)));
                if _e17 {
                    if _e16 {
                    } else {
                        break;
                    }
                    let _e21 = global_2.member[_e15].member;
                    if _e17 {
                    } else {
                        break;
                    }
                    global.member[_e15] = bitcast<u32>(bitcast<f32>((bitcast<u32>(_e21) & 2147483647u)));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn view_depth_values(@builtin(global_invocation_id) param: vec3<u32>) {
    global_1 = param;
    function_();
}
