struct type_7 {
    member: vec4<u32>,
}

struct type_12 {
    member: array<array<f32, 3>>,
}

struct type_16 {
    member: array<array<u32, 3>>,
}

struct type_19 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_21 {
    member: array<type_19>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_7;
@group(0) @binding(1) 
var<storage> global_2: type_12;
@group(0) @binding(2) 
var<storage> global_3: type_16;
@group(0) @binding(3) 
var<storage, read_write> global_4: type_21;

fn function_() {
    var phi_92_: i32;
    var phi_127_: array<u32, 3>;
    var phi_142_: array<f32, 3>;
    var phi_160_: array<f32, 3>;
    var phi_178_: array<f32, 3>;

    switch bitcast<i32>(0u) {
        default: {
            let _e17 = global;
            let _e20 = arrayLength((&global_2.member));
            let _e29 = (_e17.x + (_e17.y * 2097152u));
            let _e30 = (_e29 < arrayLength((&global_4.member)));
            if _e30 {
                let _e33 = global_1.member[0u];
                let _e34 = bitcast<i32>(_e33);
                if (_e34 < -126i) {
                    phi_92_ = -126i;
                } else {
                    phi_92_ = select(_e34, 127i, (_e34 > 127i));
                }
                let _e39 = phi_92_;
                let _e44 = bitcast<f32>((bitcast<u32>((_e39 + 127i)) << bitcast<u32>(23i)));
                let _e50 = bitcast<f32>((bitcast<u32>(((_e34 - _e39) + 127i)) << bitcast<u32>(23i)));
                if _e30 {
                } else {
                    break;
                }
                let _e56 = global_4.member[_e29].member_1;
                let _e57 = (_e56 < arrayLength((&global_3.member)));
                if _e57 {
                    if _e57 {
                    } else {
                        break;
                    }
                    let _e59 = global_3.member[_e56];
                    phi_127_ = _e59;
                } else {
                    phi_127_ = array<u32, 3>(0u, 0u, 0u);
                }
                let _e61 = phi_127_;
                let _e63 = (_e61[0] < _e20);
                if _e63 {
                    if _e63 {
                    } else {
                        break;
                    }
                    let _e65 = global_2.member[_e61[0]];
                    phi_142_ = _e65;
                } else {
                    phi_142_ = array<f32, 3>(0f, 0f, 0f);
                }
                let _e67 = phi_142_;
                let _e72 = (_e61[1] < _e20);
                if _e72 {
                    if _e72 {
                    } else {
                        break;
                    }
                    let _e74 = global_2.member[_e61[1]];
                    phi_160_ = _e74;
                } else {
                    phi_160_ = array<f32, 3>(0f, 0f, 0f);
                }
                let _e76 = phi_160_;
                let _e81 = (_e61[2] < _e20);
                if _e81 {
                    if _e81 {
                    } else {
                        break;
                    }
                    let _e83 = global_2.member[_e61[2]];
                    phi_178_ = _e83;
                } else {
                    phi_178_ = array<f32, 3>(0f, 0f, 0f);
                }
                let _e85 = phi_178_;
                let _e90 = ((_e67[0] * _e44) * _e50);
                let _e94 = ((_e67[1] * _e44) * _e50);
                let _e98 = ((_e67[2] * _e44) * _e50);
                let _e102 = ((_e76[0] * _e44) * _e50);
                let _e106 = ((_e76[1] * _e44) * _e50);
                let _e110 = ((_e76[2] * _e44) * _e50);
                let _e114 = ((_e85[0] * _e44) * _e50);
                let _e118 = ((_e85[1] * _e44) * _e50);
                let _e122 = ((_e85[2] * _e44) * _e50);
                if _e30 {
                } else {
                    break;
                }
                global_4.member[_e29] = type_19(array<f32, 9>(select(_e90, 0f, (_e90 == 0f)), select(_e94, 0f, (_e94 == 0f)), select(_e98, 0f, (_e98 == 0f)), select(_e102, 0f, (_e102 == 0f)), select(_e106, 0f, (_e106 == 0f)), select(_e110, 0f, (_e110 == 0f)), select(_e114, 0f, (_e114 == 0f)), select(_e118, 0f, (_e118 == 0f)), select(_e122, 0f, (_e122 == 0f))), _e56);
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn snap_again(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
