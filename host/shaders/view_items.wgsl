struct type_4 {
    member: array<u32>,
}

struct type_10 {
    member: array<array<u32, 2>>,
}

@group(0) @binding(0) 
var<storage> global: type_4;
var<private> global_1: vec3<u32>;
@group(0) @binding(1) 
var<storage, read_write> global_2: type_10;

fn function_() {
    switch bitcast<i32>(0u) {
        default: {
            let _e8 = global_1;
            let _e16 = (_e8.x + (_e8.y * 2097152u));
            let _e17 = (_e16 < arrayLength((&global.member)));
            if _e17 {
                let _e18 = (_e16 < arrayLength((&global_2.member)));
                if _e18 {
                    if _e17 {
                    } else {
                        break;
                    }
                    let _e21 = global.member[_e16];
                    if _e18 {
                    } else {
                        break;
                    }
                    global_2.member[_e16][0u] = _e21;
                    global_2.member[_e16][1u] = _e16;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn view_items(@builtin(global_invocation_id) param: vec3<u32>) {
    global_1 = param;
    function_();
}
