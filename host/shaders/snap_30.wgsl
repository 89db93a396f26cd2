struct type_4 {
    member: array<u32>,
}

struct type_10 {
    member: vec4<u32>,
}

struct type_15 {
    member: array<array<f32, 3>>,
}

struct type_19 {
    member: array<array<u32, 3>>,
}

struct type_22 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_24 {
    member: array<type_22>,
}

struct type_34 {
    member: array<array<u32, 2>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_10;
@group(0) @binding(1) 
var<storage> global_2: type_15;
@group(0) @binding(2) 
var<storage> global_3: type_19;
@group(0) @binding(3) 
var<storage> global_4: type_34;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_24;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_4;

fn function_() {
    var phi_117_: i32;
    var phi_156_: array<u32, 3>;
    var phi_171_: array<f32, 3>;
    var phi_189_: array<f32, 3>;
    var phi_207_: array<f32, 3>;

    switch bitcast<i32>(0u) {
        default: {
            let _e20 = global;
            let _e23 = arrayLength((&global_2.member));
            let _e36 = (_e20.x + (_e20.y * 2097152u));
            let _e37 = (_e36 < arrayLength((&global_5.member)));
            if _e37 {
                let _e38 = (_e36 < arrayLength((&global_4.member)));
                if _e38 {
                    let _e39 = (_e36 < arrayLength((&global_6.member)));
                    if _e39 {
                        let _e42 = global_1.member[0u];
                        let _e43 = bitcast<i32>(_e42);
                        if (_e43 < -126i) {
                            phi_117_ = -126i;
                        } else {
                            phi_117_ = select(_e43, 127i, (_e43 > 127i));
                        }
                        let _e48 = phi_117_;
                        let _e53 = bitcast<f32>((bitcast<u32>((_e48 + 127i)) << bitcast<u32>(23i)));
                        let _e59 = bitcast<f32>((bitcast<u32>(((_e43 - _e48) + 127i)) << bitcast<u32>(23i)));
                        if _e38 {
                        } else {
                            break;
                        }
                        let _e63 = global_4.member[_e36][0u];
                        let _e67 = global_4.member[_e36][1u];
                        let _e68 = (_e67 < arrayLength((&global_3.member)));
                        if _e68 {
                            if _e68 {
                            } else {
                                break;
                            }
                            let _e70 = global_3.member[_e67];
                            phi_156_ = _e70;
                        } else {
                            phi_156_ = array<u32, 3>(0u, 0u, 0u);
                        }
                        let _e72 = phi_156_;
                        let _e74 = (_e72[0] < _e23);
                        if _e74 {
                            if _e74 {
                            } else {
                                break;
                            }
                            let _e76 = global_2.member[_e72[0]];
                            phi_171_ = _e76;
                        } else {
                            phi_171_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e78 = phi_171_;
                        let _e83 = (_e72[1] < _e23);
                        if _e83 {
                            if _e83 {
                            } else {
                                break;
                            }
                            let _e85 = global_2.member[_e72[1]];
                            phi_189_ = _e85;
                        } else {
                            phi_189_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e87 = phi_189_;
                        let _e92 = (_e72[2] < _e23);
                        if _e92 {
                            if _e92 {
                            } else {
                                break;
                            }
                            let _e94 = global_2.member[_e72[2]];
                            phi_207_ = _e94;
                        } else {
                            phi_207_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e96 = phi_207_;
                        let _e101 = ((_e78[0] * _e53) * _e59);
                        let _e105 = ((_e78[1] * _e53) * _e59);
                        let _e109 = ((_e78[2] * _e53) * _e59);
                        let _e113 = ((_e87[0] * _e53) * _e59);
                        let _e117 = ((_e87[1] * _e53) * _e59);
                        let _e121 = ((_e87[2] * _e53) * _e59);
                        let _e125 = ((_e96[0] * _e53) * _e59);
                        let _e129 = ((_e96[1] * _e53) * _e59);
                        let _e133 = ((_e96[2] * _e53) * _e59);
                        if _e37 {
                        } else {
                            break;
                        }
                        global_5.member[_e36] = type_22(array<f32, 9>(select(_e101, 0f, (_e101 == 0f)), select(_e105, 0f, (_e105 == 0f)), select(_e109, 0f, (_e109 == 0f)), select(_e113, 0f, (_e113 == 0f)), select(_e117, 0f, (_e117 == 0f)), select(_e121, 0f, (_e121 == 0f)), select(_e125, 0f, (_e125 == 0f)), select(_e129, 0f, (_e129 == 0f)), select(_e133, 0f, (_e133 == 0f))), _e67);
                        if _e39 {
                        } else {
                            break;
                        }
                        global_6.member[_e36] = _e63;
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn snap_30_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
