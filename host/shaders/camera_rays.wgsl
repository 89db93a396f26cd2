struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_14 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_15 {
    member: type_14,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_17 {
    member: array<type_15>,
}

struct type_20 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 3>,
    member_5: u32,
    member_6: array<f32, 3>,
    member_7: u32,
}

struct type_22 {
    member: array<type_20>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(2) 
var<storage, read_write> global_2: type_17;
@group(0) @binding(1) 
var<storage> global_3: type_22;

fn function_() {
    var phi_136_: u32;
    var phi_139_: type_4;
    var phi_140_: type_4;
    var phi_162_: type_4;
    var phi_175_: u32;
    var phi_137_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_210_: array<f32, 2>;
    var phi_278_: type_14;

    switch bitcast<i32>(0u) {
        default: {
            let _e31 = global;
            let _e33 = arrayLength((&global_3.member));
            let _e39 = (_e31.x + (_e31.y * 2097152u));
            let _e40 = (_e39 < arrayLength((&global_2.member)));
            if _e40 {
                if (_e33 == 0u) {
                } else {
                    if (0u < _e33) {
                    } else {
                        break;
                    }
                    let _e45 = global_1.member[0u];
                    let _e46 = (_e45 + _e39);
                    let _e50 = global_3.member[0u].member_7;
                    let _e52 = select(1u, _e50, (1u < _e50));
                    let _e56 = global_3.member[0u].member_3;
                    let _e58 = select(1u, _e56, (1u < _e56));
                    let _e59 = (_e52 == 0u);
                    if _e59 {
                        break;
                    }
                    let _e60 = (_e46 / _e52);
                    let _e61 = (_e58 == 0u);
                    if _e61 {
                        break;
                    }
                    if _e61 {
                        break;
                    }
                    if _e59 {
                        break;
                    }
                    let _e64 = (_e46 % _e52);
                    phi_136_ = 1u;
                    phi_139_ = type_4(0u, 16u);
                    loop {
                        let _e66 = phi_136_;
                        let _e68 = phi_139_;
                        local = _e66;
                        local_1 = _e66;
                        local_2 = _e66;
                        local_3 = _e66;
                        local_4 = _e66;
                        local_5 = _e66;
                        if (_e68.member < _e68.member_1) {
                            phi_140_ = type_4((_e68.member + 1u), _e68.member_1);
                            phi_162_ = type_4(1u, _e68.member);
                        } else {
                            phi_140_ = _e68;
                            phi_162_ = type_4(0u, type_4().member_1);
                        }
                        let _e81 = phi_140_;
                        let _e83 = phi_162_;
                        let _e86 = (bitcast<i32>(_e83.member) != 0i);
                        if _e86 {
                            if ((_e66 * _e66) < _e52) {
                                phi_175_ = (_e66 + 1u);
                            } else {
                                phi_175_ = _e66;
                            }
                            let _e91 = phi_175_;
                            phi_137_ = _e91;
                        } else {
                            phi_137_ = u32();
                        }
                        let _e93 = phi_137_;
                        continue;
                        continuing {
                            phi_136_ = _e93;
                            phi_139_ = _e81;
                            break if !(_e86);
                        }
                    }
                    let _e96 = local;
                    let _e98 = local_1;
                    if ((_e96 * _e98) == _e52) {
                        let _e113 = local_2;
                        let _e114 = (_e113 == 0u);
                        if _e114 {
                            break;
                        }
                        let _e116 = local_3;
                        let _e121 = local_4;
                        let _e122 = f32(_e121);
                        if _e114 {
                            break;
                        }
                        let _e125 = local_5;
                        phi_210_ = array<f32, 2>(((f32((_e64 % _e116)) + 0.5f) / _e122), ((f32((_e64 / _e125)) + 0.5f) / _e122));
                    } else {
                        phi_210_ = array<f32, 2>(((f32(_e64) + 0.5f) / f32(_e52)), (f32((((_e64 * 2654435769u) + 1327217884u) >> bitcast<u32>(8i))) * 0.000000059604645f));
                    }
                    let _e132 = phi_210_;
                    let _e140 = ((((f32((_e60 % _e58)) + _e132[0]) / f32(_e56)) * 2f) - 1f);
                    let _e146 = global_3.member[0u].member_5;
                    let _e150 = (1f - (((f32((_e60 / _e58)) + _e132[1]) / f32(_e146)) * 2f));
                    let _e154 = global_3.member[0u].member_4;
                    let _e164 = global_3.member[0u].member_6;
                    let _e171 = ((_e154[0] * _e140) + (_e164[0] * _e150));
                    let _e172 = ((_e154[1] * _e140) + (_e164[1] * _e150));
                    let _e173 = ((_e154[2] * _e140) + (_e164[2] * _e150));
                    let _e177 = global_3.member[0u].member;
                    let _e184 = global_3.member[0u].member_2;
                    let _e191 = global_3.member[0u].member_1;
                    if (_e191 == 0u) {
                        phi_278_ = type_14(_e177, 0f, array<f32, 3>((_e184[0] + _e171), (_e184[1] + _e172), (_e184[2] + _e173)), 340282350000000000000000000000000000000f);
                    } else {
                        phi_278_ = type_14(array<f32, 3>((_e177[0] + _e171), (_e177[1] + _e172), (_e177[2] + _e173)), 0f, _e184, 340282350000000000000000000000000000000f);
                    }
                    let _e204 = phi_278_;
                    if _e40 {
                    } else {
                        break;
                    }
                    global_2.member[_e39] = type_15(_e204, array<f32, 3>(1f, 1f, 1f), 4294967295u, array<f32, 3>(0f, 0f, 0f), 0u);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn camera_rays(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
