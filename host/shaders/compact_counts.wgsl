struct type_4 {
    member: array<u32>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<storage> global_1: type_4;
@group(0) @binding(1) 
var<storage, read_write> global_2: type_4;

fn function_() {
    switch bitcast<i32>(0u) {
        default: {
            let _e6 = global;
            let _e14 = (_e6.x + (_e6.y * 2097152u));
            let _e15 = (_e14 < arrayLength((&global_1.member)));
            if _e15 {
                let _e16 = (_e14 < arrayLength((&global_2.member)));
                if _e16 {
                    if _e15 {
                    } else {
                        break;
                    }
                    let _e19 = global_1.member[_e14];
                    if _e16 {
                    } else {
                        break;
                    }
                    global_2.member[_e14] = countOneBits(_e19);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn compact_counts(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
