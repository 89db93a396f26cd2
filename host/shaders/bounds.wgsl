struct type_5 {
    member: u32,
    member_1: u32,
}

struct type_10 {
    member: array<array<f32, 3>>,
}

struct type_14 {
    member: array<array<u32, 3>>,
}

struct type_21 {
    member: vec3<f32>,
    member_1: vec3<f32>,
}

struct type_24 {
    member: array<array<f32, 6>>,
}

struct type_26 {
    member: vec3<f32>,
    member_1: vec3<f32>,
}

var<private> global: vec3<u32>;
var<private> global_1: u32;
var<workgroup> global_2: array<type_26, 64>;
@group(0) @binding(0) 
var<storage> global_3: type_10;
@group(0) @binding(1) 
var<storage> global_4: type_14;
@group(0) @binding(2) 
var<storage, read_write> global_5: type_24;

fn function_() {
    var phi_119_: type_5;
    var phi_122_: type_21;
    var phi_120_: type_5;
    var phi_145_: type_5;
    var phi_166_: array<u32, 3>;
    var phi_181_: array<f32, 3>;
    var phi_199_: array<f32, 3>;
    var phi_217_: array<f32, 3>;
    var phi_123_: type_21;
    var phi_560_: bool;
    var local: type_21;
    var local_1: type_21;
    var phi_351_: type_5;
    var phi_354_: u32;
    var phi_352_: type_5;
    var phi_377_: type_5;
    var phi_355_: u32;
    var phi_588_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e33 = global;
            let _e34 = global_1;
            let _e37 = arrayLength((&global_3.member));
            let _e40 = arrayLength((&global_4.member));
            let _e46 = (_e33.x + (_e33.y * 32768u));
            let _e49 = ((_e46 * 1024u) + (_e34 * 16u));
            let _e51 = select(_e40, _e49, (_e49 < _e40));
            let _e52 = (_e40 - _e51);
            phi_119_ = type_5(_e51, (_e51 + select(16u, _e52, (_e52 < 16u))));
            phi_122_ = type_21(vec3<f32>(340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f), vec3<f32>(-340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f));
            loop {
                let _e58 = phi_119_;
                let _e60 = phi_122_;
                local = _e60;
                local_1 = _e60;
                if (_e58.member < _e58.member_1) {
                    phi_120_ = type_5((_e58.member + 1u), _e58.member_1);
                    phi_145_ = type_5(1u, _e58.member);
                } else {
                    phi_120_ = _e58;
                    phi_145_ = type_5(0u, type_5().member_1);
                }
                let _e73 = phi_120_;
                let _e75 = phi_145_;
                let _e79 = (bitcast<i32>(_e75.member) != 0i);
                if _e79 {
                    let _e80 = (_e75.member_1 < _e40);
                    if _e80 {
                        if _e80 {
                        } else {
                            phi_560_ = true;
                            break;
                        }
                        let _e82 = global_4.member[_e75.member_1];
                        phi_166_ = _e82;
                    } else {
                        phi_166_ = array<u32, 3>(0u, 0u, 0u);
                    }
                    let _e84 = phi_166_;
                    let _e86 = (_e84[0] < _e37);
                    if _e86 {
                        if _e86 {
                        } else {
                            phi_560_ = true;
                            break;
                        }
                        let _e88 = global_3.member[_e84[0]];
                        phi_181_ = _e88;
                    } else {
                        phi_181_ = array<f32, 3>(0f, 0f, 0f);
                    }
                    let _e90 = phi_181_;
                    let _e95 = (_e84[1] < _e37);
                    if _e95 {
                        if _e95 {
                        } else {
                            phi_560_ = true;
                            break;
                        }
                        let _e97 = global_3.member[_e84[1]];
                        phi_199_ = _e97;
                    } else {
                        phi_199_ = array<f32, 3>(0f, 0f, 0f);
                    }
                    let _e99 = phi_199_;
                    let _e104 = (_e84[2] < _e37);
                    if _e104 {
                        if _e104 {
                        } else {
                            phi_560_ = true;
                            break;
                        }
                        let _e106 = global_3.member[_e84[2]];
                        phi_217_ = _e106;
                    } else {
                        phi_217_ = array<f32, 3>(0f, 0f, 0f);
                    }
                    let _e108 = phi_217_;
                    let _e113 = select(_e99[0], _e90[0], (_e90[0] < _e99[0]));
                    let _e115 = select(_e99[1], _e90[1], (_e90[1] < _e99[1]));
                    let _e117 = select(_e99[2], _e90[2], (_e90[2] < _e99[2]));
                    let _e119 = select(_e108[0], _e113, (_e113 < _e108[0]));
                    let _e121 = select(_e108[1], _e115, (_e115 < _e108[1]));
                    let _e123 = select(_e108[2], _e117, (_e117 < _e108[2]));
                    let _e125 = select(_e99[0], _e90[0], (_e90[0] > _e99[0]));
                    let _e127 = select(_e99[1], _e90[1], (_e90[1] > _e99[1]));
                    let _e129 = select(_e99[2], _e90[2], (_e90[2] > _e99[2]));
                    let _e131 = select(_e108[0], _e125, (_e125 > _e108[0]));
                    let _e133 = select(_e108[1], _e127, (_e127 > _e108[1]));
                    let _e135 = select(_e108[2], _e129, (_e129 > _e108[2]));
                    phi_123_ = type_21(vec3<f32>(select(_e119, _e60.member.x, (_e60.member.x < _e119)), select(_e121, _e60.member.y, (_e60.member.y < _e121)), select(_e123, _e60.member.z, (_e60.member.z < _e123))), vec3<f32>(select(_e131, _e60.member_1.x, (_e60.member_1.x > _e131)), select(_e133, _e60.member_1.y, (_e60.member_1.y > _e133)), select(_e135, _e60.member_1.z, (_e60.member_1.z > _e135))));
                } else {
                    phi_123_ = type_21();
                }
                let _e160 = phi_123_;
                continue;
                continuing {
                    phi_119_ = _e73;
                    phi_122_ = _e160;
                    phi_560_ = false;
                    break if !(_e79);
                }
            }
            let _e163 = phi_560_;
            if _e163 {
                break;
            }
            let _e165 = local;
            let _e178 = local_1;
            let _e190 = (_e34 % 64u);
            let _e191 = (_e190 < 64u);
            if _e191 {
            } else {
                break;
            }
            global_2[_e190] = type_26(vec3<f32>(select(_e165.member.x, 0f, (_e165.member.x == 0f)), select(_e165.member.y, 0f, (_e165.member.y == 0f)), select(_e165.member.z, 0f, (_e165.member.z == 0f))), vec3<f32>(select(_e178.member_1.x, 0f, (_e178.member_1.x == 0f)), select(_e178.member_1.y, 0f, (_e178.member_1.y == 0f)), select(_e178.member_1.z, 0f, (_e178.member_1.z == 0f))));
            workgroupBarrier();
            phi_351_ = type_5(0u, 6u);
            phi_354_ = 32u;
            loop {
                let _e195 = phi_351_;
                let _e197 = phi_354_;
                if (_e195.member < _e195.member_1) {
                    phi_352_ = type_5((_e195.member + 1u), _e195.member_1);
                    phi_377_ = type_5(1u, _e195.member);
                } else {
                    phi_352_ = _e195;
                    phi_377_ = type_5(0u, type_5().member_1);
                }
                let _e210 = phi_352_;
                let _e212 = phi_377_;
                let _e215 = (bitcast<i32>(_e212.member) != 0i);
                if _e215 {
                    if (_e34 < _e197) {
                        if _e191 {
                        } else {
                            phi_588_ = true;
                            break;
                        }
                        let _e217 = global_2[_e190];
                        let _e221 = ((_e34 + _e197) % 64u);
                        if (_e221 < 64u) {
                        } else {
                            phi_588_ = true;
                            break;
                        }
                        let _e224 = global_2[_e221];
                        if _e191 {
                        } else {
                            phi_588_ = true;
                            break;
                        }
                        global_2[_e190] = type_26(vec3<f32>(select(_e224.member.x, _e217.member.x, (_e217.member.x < _e224.member.x)), select(_e224.member.y, _e217.member.y, (_e217.member.y < _e224.member.y)), select(_e224.member.z, _e217.member.z, (_e217.member.z < _e224.member.z))), vec3<f32>(select(_e224.member_1.x, _e217.member_1.x, (_e217.member_1.x > _e224.member_1.x)), select(_e224.member_1.y, _e217.member_1.y, (_e217.member_1.y > _e224.member_1.y)), select(_e224.member_1.z, _e217.member_1.z, (_e217.member_1.z > _e224.member_1.z))));
                    }
                    workgroupBarrier();
                    phi_355_ = (_e197 / 2u);
                } else {
                    phi_355_ = u32();
                }
                let _e256 = phi_355_;
                continue;
                continuing {
                    phi_351_ = _e210;
                    phi_354_ = _e256;
                    phi_588_ = _e163;
                    break if !(_e215);
                }
            }
            let _e259 = phi_588_;
            if _e259 {
                break;
            }
            if (_e34 == 0u) {
                let _e261 = (_e46 < arrayLength((&global_5.member)));
                if _e261 {
                    let _e263 = global_2[0u];
                    if _e261 {
                    } else {
                        break;
                    }
                    global_5.member[_e46] = array<f32, 6>(_e263.member.x, _e263.member.y, _e263.member.z, _e263.member_1.x, _e263.member_1.y, _e263.member_1.z);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn bounds(@builtin(workgroup_id) param: vec3<u32>, @builtin(local_invocation_index) param_1: u32) {
    global = param;
    global_1 = param_1;
    function_();
}
