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
    var phi_126_: array<u32, 3>;
    var phi_141_: array<f32, 3>;
    var phi_159_: array<f32, 3>;
    var phi_177_: array<f32, 3>;

    switch bitcast<i32>(0u) {
        default: {
            let _e17 = global;
            let _e20 = arrayLength((&global_2.member));
            let _e29 = (_e17.x + (_e17.y * 2097152u));
            let _e30 = (_e29 < arrayLength((&global_4.member)));
            if _e30 {
                let _e33 = global_1.member[0u];
                let _e34 = bitcast<i32>(_e33);
                let _e35 = (_e34 / 2i);
                let _e40 = bitcast<f32>((bitcast<u32>((_e35 + 127i)) << bitcast<u32>(23i)));
                let _e46 = bitcast<f32>((bitcast<u32>(((_e34 - _e35) + 127i)) << bitcast<u32>(23i)));
                if _e30 {
                } else {
                    break;
                }
                let _e52 = global_4.member[_e29].member_1;
                let _e53 = (_e52 < arrayLength((&global_3.member)));
                if _e53 {
                    if _e53 {
                    } else {
                        break;
                    }
                    let _e55 = global_3.member[_e52];
                    phi_126_ = _e55;
                } else {
                    phi_126_ = array<u32, 3>(0u, 0u, 0u);
                }
                let _e57 = phi_126_;
                let _e59 = (_e57[0] < _e20);
                if _e59 {
                    if _e59 {
                    } else {
                        break;
                    }
                    let _e61 = global_2.member[_e57[0]];
                    phi_141_ = _e61;
                } else {
                    phi_141_ = array<f32, 3>(0f, 0f, 0f);
                }
                let _e63 = phi_141_;
                let _e68 = (_e57[1] < _e20);
                if _e68 {
                    if _e68 {
                    } else {
                        break;
                    }
                    let _e70 = global_2.member[_e57[1]];
                    phi_159_ = _e70;
                } else {
                    phi_159_ = array<f32, 3>(0f, 0f, 0f);
                }
                let _e72 = phi_159_;
                let _e77 = (_e57[2] < _e20);
                if _e77 {
                    if _e77 {
                    } else {
                        break;
                    }
                    let _e79 = global_2.member[_e57[2]];
                    phi_177_ = _e79;
                } else {
                    phi_177_ = array<f32, 3>(0f, 0f, 0f);
                }
                let _e81 = phi_177_;
                let _e86 = ((_e63[0] * _e40) * _e46);
                let _e90 = ((_e63[1] * _e40) * _e46);
                let _e94 = ((_e63[2] * _e40) * _e46);
                let _e98 = ((_e72[0] * _e40) * _e46);
                let _e102 = ((_e72[1] * _e40) * _e46);
                let _e106 = ((_e72[2] * _e40) * _e46);
                let _e110 = ((_e81[0] * _e40) * _e46);
                let _e114 = ((_e81[1] * _e40) * _e46);
                let _e118 = ((_e81[2] * _e40) * _e46);
                if _e30 {
                } else {
                    break;
                }
                global_4.member[_e29] = type_19(array<f32, 9>(select(_e86, 0f, (_e86 == 0f)), select(_e90, 0f, (_e90 == 0f)), select(_e94, 0f, (_e94 == 0f)), select(_e98, 0f, (_e98 == 0f)), select(_e102, 0f, (_e102 == 0f)), select(_e106, 0f, (_e106 == 0f)), select(_e110, 0f, (_e110 == 0f)), select(_e114, 0f, (_e114 == 0f)), select(_e118, 0f, (_e118 == 0f))), _e52);
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
