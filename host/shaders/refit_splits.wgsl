struct type_4 {
    member: array<u32>,
}

struct type_9 {
    member: vec4<u32>,
}

struct type_15 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_17 {
    member: array<type_15>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_9;
@group(0) @binding(1) 
var<storage> global_2: type_17;
@group(0) @binding(2) 
var<storage, read_write> global_3: type_4;

fn function_() {
    var phi_91_: u32;
    var phi_114_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e14 = global;
            let _e16 = arrayLength((&global_2.member));
            let _e22 = (_e14.x + (_e14.y * 2097152u));
            let _e25 = global_1.member[0u];
            if (_e22 < _e25) {
                let _e27 = (_e22 < _e16);
                if _e27 {
                    let _e28 = (_e22 < arrayLength((&global_3.member)));
                    if _e28 {
                        if _e27 {
                        } else {
                            break;
                        }
                        let _e32 = global_2.member[_e22].member_1;
                        let _e33 = (_e32 < _e16);
                        if _e33 {
                            if _e33 {
                            } else {
                                break;
                            }
                            let _e37 = global_2.member[_e32].member_4;
                            phi_91_ = _e37;
                        } else {
                            phi_91_ = 0u;
                        }
                        let _e39 = phi_91_;
                        if _e27 {
                        } else {
                            break;
                        }
                        if ((_e32 & 2147483648u) != 0u) {
                            phi_114_ = (((_e32 & 268435455u) + ((_e32 >> bitcast<u32>(28u)) & 7u)) - 1u);
                        } else {
                            phi_114_ = _e39;
                        }
                        let _e49 = phi_114_;
                        if _e28 {
                        } else {
                            break;
                        }
                        global_3.member[_e22] = _e49;
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn refit_splits(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
