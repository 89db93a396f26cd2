struct type_5 {
    member: vec4<u32>,
}

struct type_11 {
    member: array<array<f32, 8>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_5;
@group(0) @binding(1) 
var<storage> global_2: type_11;
@group(0) @binding(2) 
var<storage, read_write> global_3: type_11;
@group(0) @binding(3) 
var<storage, read_write> global_4: type_11;

fn function_() {
    var phi_81_: array<f32, 8>;
    var phi_101_: array<f32, 8>;

    switch bitcast<i32>(0u) {
        default: {
            let _e13 = global;
            let _e15 = arrayLength((&global_2.member));
            let _e23 = (_e13.x + (_e13.y * 2097152u));
            let _e26 = global_1.member[0u];
            let _e27 = (_e26 + _e23);
            let _e28 = (_e23 < arrayLength((&global_3.member)));
            if _e28 {
                let _e29 = (_e27 < arrayLength((&global_4.member)));
                if _e29 {
                    let _e30 = (2u * _e23);
                    let _e31 = (_e30 + 1u);
                    let _e33 = select(_e30, _e31, (_e31 < _e15));
                    let _e34 = (_e30 < _e15);
                    if _e34 {
                        if _e34 {
                        } else {
                            break;
                        }
                        let _e37 = global_2.member[_e30];
                        phi_81_ = _e37;
                    } else {
                        phi_81_ = array<f32, 8>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    }
                    let _e39 = phi_81_;
                    let _e46 = (_e33 < _e15);
                    if _e46 {
                        if _e46 {
                        } else {
                            break;
                        }
                        let _e49 = global_2.member[_e33];
                        phi_101_ = _e49;
                    } else {
                        phi_101_ = array<f32, 8>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    }
                    let _e51 = phi_101_;
                    let _e70 = array<f32, 8>(select(_e51[0], _e39[0], (_e39[0] < _e51[0])), select(_e51[1], _e39[1], (_e39[1] < _e51[1])), select(_e51[2], _e39[2], (_e39[2] < _e51[2])), 0f, select(_e51[4], _e39[4], (_e39[4] > _e51[4])), select(_e51[5], _e39[5], (_e39[5] > _e51[5])), select(_e51[6], _e39[6], (_e39[6] > _e51[6])), 0f);
                    if _e28 {
                    } else {
                        break;
                    }
                    global_3.member[_e23] = _e70;
                    if _e29 {
                    } else {
                        break;
                    }
                    global_4.member[_e27] = _e70;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn refit_parents(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
