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

struct type_31 {
    member: array<array<u32, 2>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_7;
@group(0) @binding(1) 
var<storage> global_2: type_12;
@group(0) @binding(2) 
var<storage> global_3: type_16;
@group(0) @binding(4) 
var<storage, read_write> global_4: type_21;
@group(0) @binding(3) 
var<storage> global_5: type_16;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_31;

fn function_() {
    var phi_113_: i32;
    var phi_156_: array<u32, 3>;
    var phi_171_: array<f32, 3>;
    var phi_189_: array<f32, 3>;
    var phi_207_: array<f32, 3>;

    switch bitcast<i32>(0u) {
        default: {
            let _e20 = global;
            let _e23 = arrayLength((&global_2.member));
            let _e36 = (_e20.x + (_e20.y * 2097152u));
            let _e37 = (_e36 < arrayLength((&global_4.member)));
            if _e37 {
                let _e38 = (_e36 < arrayLength((&global_5.member)));
                if _e38 {
                    let _e39 = (_e36 < arrayLength((&global_6.member)));
                    if _e39 {
                        let _e42 = global_1.member[0u];
                        let _e43 = bitcast<i32>(_e42);
                        if (_e43 < -126i) {
                            phi_113_ = -126i;
                        } else {
                            phi_113_ = select(_e43, 127i, (_e43 > 127i));
                        }
                        let _e48 = phi_113_;
                        let _e53 = bitcast<f32>((bitcast<u32>((_e48 + 127i)) << bitcast<u32>(23i)));
                        let _e59 = bitcast<f32>((bitcast<u32>(((_e43 - _e48) + 127i)) << bitcast<u32>(23i)));
                        if _e38 {
                        } else {
                            break;
                        }
                        let _e63 = global_5.member[_e36][0u];
                        let _e67 = global_5.member[_e36][1u];
                        let _e71 = global_5.member[_e36][2u];
                        let _e72 = (_e71 < arrayLength((&global_3.member)));
                        if _e72 {
                            if _e72 {
                            } else {
                                break;
                            }
                            let _e74 = global_3.member[_e71];
                            phi_156_ = _e74;
                        } else {
                            phi_156_ = array<u32, 3>(0u, 0u, 0u);
                        }
                        let _e76 = phi_156_;
                        let _e78 = (_e76[0] < _e23);
                        if _e78 {
                            if _e78 {
                            } else {
                                break;
                            }
                            let _e80 = global_2.member[_e76[0]];
                            phi_171_ = _e80;
                        } else {
                            phi_171_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e82 = phi_171_;
                        let _e87 = (_e76[1] < _e23);
                        if _e87 {
                            if _e87 {
                            } else {
                                break;
                            }
                            let _e89 = global_2.member[_e76[1]];
                            phi_189_ = _e89;
                        } else {
                            phi_189_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e91 = phi_189_;
                        let _e96 = (_e76[2] < _e23);
                        if _e96 {
                            if _e96 {
                            } else {
                                break;
                            }
                            let _e98 = global_2.member[_e76[2]];
                            phi_207_ = _e98;
                        } else {
                            phi_207_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e100 = phi_207_;
                        let _e105 = ((_e82[0] * _e53) * _e59);
                        let _e109 = ((_e82[1] * _e53) * _e59);
                        let _e113 = ((_e82[2] * _e53) * _e59);
                        let _e117 = ((_e91[0] * _e53) * _e59);
                        let _e121 = ((_e91[1] * _e53) * _e59);
                        let _e125 = ((_e91[2] * _e53) * _e59);
                        let _e129 = ((_e100[0] * _e53) * _e59);
                        let _e133 = ((_e100[1] * _e53) * _e59);
                        let _e137 = ((_e100[2] * _e53) * _e59);
                        if _e37 {
                        } else {
                            break;
                        }
                        global_4.member[_e36] = type_19(array<f32, 9>(select(_e105, 0f, (_e105 == 0f)), select(_e109, 0f, (_e109 == 0f)), select(_e113, 0f, (_e113 == 0f)), select(_e117, 0f, (_e117 == 0f)), select(_e121, 0f, (_e121 == 0f)), select(_e125, 0f, (_e125 == 0f)), select(_e129, 0f, (_e129 == 0f)), select(_e133, 0f, (_e133 == 0f)), select(_e137, 0f, (_e137 == 0f))), _e71);
                        if _e39 {
                        } else {
                            break;
                        }
                        global_6.member[_e36][0u] = _e63;
                        global_6.member[_e36][1u] = _e67;
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn snap_63_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
