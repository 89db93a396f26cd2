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
    var phi_126_: i32;
    var phi_165_: array<u32, 3>;
    var phi_180_: array<f32, 3>;
    var phi_198_: array<f32, 3>;
    var phi_216_: array<f32, 3>;

    switch bitcast<i32>(0u) {
        default: {
            let _e29 = global;
            let _e32 = arrayLength((&global_2.member));
            let _e45 = (_e29.x + (_e29.y * 2097152u));
            let _e46 = (_e45 < arrayLength((&global_5.member)));
            if _e46 {
                let _e47 = (_e45 < arrayLength((&global_4.member)));
                if _e47 {
                    let _e48 = (_e45 < arrayLength((&global_6.member)));
                    if _e48 {
                        let _e51 = global_1.member[0u];
                        let _e52 = bitcast<i32>(_e51);
                        if (_e52 < -126i) {
                            phi_126_ = -126i;
                        } else {
                            phi_126_ = select(_e52, 127i, (_e52 > 127i));
                        }
                        let _e57 = phi_126_;
                        let _e62 = bitcast<f32>((bitcast<u32>((_e57 + 127i)) << bitcast<u32>(23i)));
                        let _e68 = bitcast<f32>((bitcast<u32>(((_e52 - _e57) + 127i)) << bitcast<u32>(23i)));
                        if _e47 {
                        } else {
                            break;
                        }
                        let _e72 = global_4.member[_e45][0u];
                        let _e76 = global_4.member[_e45][1u];
                        let _e77 = (_e76 < arrayLength((&global_3.member)));
                        if _e77 {
                            if _e77 {
                            } else {
                                break;
                            }
                            let _e79 = global_3.member[_e76];
                            phi_165_ = _e79;
                        } else {
                            phi_165_ = array<u32, 3>(0u, 0u, 0u);
                        }
                        let _e81 = phi_165_;
                        let _e83 = (_e81[0] < _e32);
                        if _e83 {
                            if _e83 {
                            } else {
                                break;
                            }
                            let _e85 = global_2.member[_e81[0]];
                            phi_180_ = _e85;
                        } else {
                            phi_180_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e87 = phi_180_;
                        let _e92 = (_e81[1] < _e32);
                        if _e92 {
                            if _e92 {
                            } else {
                                break;
                            }
                            let _e94 = global_2.member[_e81[1]];
                            phi_198_ = _e94;
                        } else {
                            phi_198_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e96 = phi_198_;
                        let _e101 = (_e81[2] < _e32);
                        if _e101 {
                            if _e101 {
                            } else {
                                break;
                            }
                            let _e103 = global_2.member[_e81[2]];
                            phi_216_ = _e103;
                        } else {
                            phi_216_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e105 = phi_216_;
                        let _e109 = bitcast<u32>(_e87[0]);
                        let _e111 = ((_e109 & 2139095040u) != 0u);
                        let _e125 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e109 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e109 & 2147483648u))), _e87[0], _e111) * _e62) * select(0.00000011920929f, 1f, _e111)) * _e68);
                        let _e131 = bitcast<u32>(_e87[1]);
                        let _e133 = ((_e131 & 2139095040u) != 0u);
                        let _e147 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e131 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e131 & 2147483648u))), _e87[1], _e133) * _e62) * select(0.00000011920929f, 1f, _e133)) * _e68);
                        let _e153 = bitcast<u32>(_e87[2]);
                        let _e155 = ((_e153 & 2139095040u) != 0u);
                        let _e169 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e153 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e153 & 2147483648u))), _e87[2], _e155) * _e62) * select(0.00000011920929f, 1f, _e155)) * _e68);
                        let _e175 = bitcast<u32>(_e96[0]);
                        let _e177 = ((_e175 & 2139095040u) != 0u);
                        let _e191 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e175 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e175 & 2147483648u))), _e96[0], _e177) * _e62) * select(0.00000011920929f, 1f, _e177)) * _e68);
                        let _e197 = bitcast<u32>(_e96[1]);
                        let _e199 = ((_e197 & 2139095040u) != 0u);
                        let _e213 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e197 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e197 & 2147483648u))), _e96[1], _e199) * _e62) * select(0.00000011920929f, 1f, _e199)) * _e68);
                        let _e219 = bitcast<u32>(_e96[2]);
                        let _e221 = ((_e219 & 2139095040u) != 0u);
                        let _e235 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e219 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e219 & 2147483648u))), _e96[2], _e221) * _e62) * select(0.00000011920929f, 1f, _e221)) * _e68);
                        let _e241 = bitcast<u32>(_e105[0]);
                        let _e243 = ((_e241 & 2139095040u) != 0u);
                        let _e257 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e241 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e241 & 2147483648u))), _e105[0], _e243) * _e62) * select(0.00000011920929f, 1f, _e243)) * _e68);
                        let _e263 = bitcast<u32>(_e105[1]);
                        let _e265 = ((_e263 & 2139095040u) != 0u);
                        let _e279 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e263 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e263 & 2147483648u))), _e105[1], _e265) * _e62) * select(0.00000011920929f, 1f, _e265)) * _e68);
                        let _e285 = bitcast<u32>(_e105[2]);
                        let _e287 = ((_e285 & 2139095040u) != 0u);
                        let _e301 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e285 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e285 & 2147483648u))), _e105[2], _e287) * _e62) * select(0.00000011920929f, 1f, _e287)) * _e68);
                        if _e46 {
                        } else {
                            break;
                        }
                        global_5.member[_e45] = type_22(array<f32, 9>(select(_e125, 0f, (bitcast<f32>((bitcast<u32>(_e125) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f)), select(_e147, 0f, (bitcast<f32>((bitcast<u32>(_e147) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f)), select(_e169, 0f, (bitcast<f32>((bitcast<u32>(_e169) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f)), select(_e191, 0f, (bitcast<f32>((bitcast<u32>(_e191) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f)), select(_e213, 0f, (bitcast<f32>((bitcast<u32>(_e213) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f)), select(_e235, 0f, (bitcast<f32>((bitcast<u32>(_e235) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f)), select(_e257, 0f, (bitcast<f32>((bitcast<u32>(_e257) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f)), select(_e279, 0f, (bitcast<f32>((bitcast<u32>(_e279) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f)), select(_e301, 0f, (bitcast<f32>((bitcast<u32>(_e301) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f))), _e76);
                        if _e48 {
                        } else {
                            break;
                        }
                        global_6.member[_e45] = _e72;
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
