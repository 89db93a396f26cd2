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

struct type_23 {
    member: array<array<f32, 6>>,
}

struct type_25 {
    member: vec3<f32>,
    member_1: vec3<f32>,
}

struct type_28 {
    member: vec3<f32>,
    member_1: vec3<f32>,
}

var<private> global: vec3<u32>;
var<private> global_1: u32;
var<workgroup> global_2: array<type_25, 64>;
@group(0) @binding(0) 
var<storage> global_3: type_10;
@group(0) @binding(1) 
var<storage> global_4: type_14;
@group(0) @binding(2) 
var<storage, read_write> global_5: type_23;

fn function_() {
    var phi_116_: type_5;
    var phi_119_: type_28;
    var phi_117_: type_5;
    var phi_142_: type_5;
    var phi_163_: array<u32, 3>;
    var phi_178_: array<f32, 3>;
    var phi_196_: array<f32, 3>;
    var phi_214_: array<f32, 3>;
    var phi_120_: type_28;
    var phi_490_: bool;
    var local: type_28;
    var local_1: type_28;
    var phi_331_: type_5;
    var phi_334_: u32;
    var phi_332_: type_5;
    var phi_357_: type_5;
    var phi_335_: u32;
    var phi_518_: bool;

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
            phi_116_ = type_5(_e51, (_e51 + select(16u, _e52, (_e52 < 16u))));
            phi_119_ = type_28(vec3<f32>(340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f), vec3<f32>(-340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f));
            loop {
                let _e58 = phi_116_;
                let _e60 = phi_119_;
                local = _e60;
                local_1 = _e60;
                if (_e58.member < _e58.member_1) {
                    phi_117_ = type_5((_e58.member + 1u), _e58.member_1);
                    phi_142_ = type_5(1u, _e58.member);
                } else {
                    phi_117_ = _e58;
                    phi_142_ = type_5(0u, type_5().member_1);
                }
                let _e73 = phi_117_;
                let _e75 = phi_142_;
                let _e79 = (bitcast<i32>(_e75.member) != 0i);
                if _e79 {
                    let _e80 = (_e75.member_1 < _e40);
                    if _e80 {
                        if _e80 {
                        } else {
                            phi_490_ = true;
                            break;
                        }
                        let _e82 = global_4.member[_e75.member_1];
                        phi_163_ = _e82;
                    } else {
                        phi_163_ = array<u32, 3>(0u, 0u, 0u);
                    }
                    let _e84 = phi_163_;
                    let _e86 = (_e84[0] < _e37);
                    if _e86 {
                        if _e86 {
                        } else {
                            phi_490_ = true;
                            break;
                        }
                        let _e88 = global_3.member[_e84[0]];
                        phi_178_ = _e88;
                    } else {
                        phi_178_ = array<f32, 3>(0f, 0f, 0f);
                    }
                    let _e90 = phi_178_;
                    let _e95 = (_e84[1] < _e37);
                    if _e95 {
                        if _e95 {
                        } else {
                            phi_490_ = true;
                            break;
                        }
                        let _e97 = global_3.member[_e84[1]];
                        phi_196_ = _e97;
                    } else {
                        phi_196_ = array<f32, 3>(0f, 0f, 0f);
                    }
                    let _e99 = phi_196_;
                    let _e104 = (_e84[2] < _e37);
                    if _e104 {
                        if _e104 {
                        } else {
                            phi_490_ = true;
                            break;
                        }
                        let _e106 = global_3.member[_e84[2]];
                        phi_214_ = _e106;
                    } else {
                        phi_214_ = array<f32, 3>(0f, 0f, 0f);
                    }
                    let _e108 = phi_214_;
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
                    phi_120_ = type_28(vec3<f32>(select(_e119, _e60.member.x, (_e60.member.x < _e119)), select(_e121, _e60.member.y, (_e60.member.y < _e121)), select(_e123, _e60.member.z, (_e60.member.z < _e123))), vec3<f32>(select(_e131, _e60.member_1.x, (_e60.member_1.x > _e131)), select(_e133, _e60.member_1.y, (_e60.member_1.y > _e133)), select(_e135, _e60.member_1.z, (_e60.member_1.z > _e135))));
                } else {
                    phi_120_ = type_28();
                }
                let _e160 = phi_120_;
                continue;
                continuing {
                    phi_116_ = _e73;
                    phi_119_ = _e160;
                    phi_490_ = false;
                    break if !(_e79);
                }
            }
            let _e163 = phi_490_;
            if _e163 {
                break;
            }
            let _e164 = (_e34 % 64u);
            let _e165 = (_e164 < 64u);
            if _e165 {
            } else {
                break;
            }
            let _e168 = local;
            let _e171 = local_1;
            global_2[_e164] = type_25(_e168.member, _e171.member_1);
            workgroupBarrier();
            phi_331_ = type_5(0u, 6u);
            phi_334_ = 32u;
            loop {
                let _e175 = phi_331_;
                let _e177 = phi_334_;
                if (_e175.member < _e175.member_1) {
                    phi_332_ = type_5((_e175.member + 1u), _e175.member_1);
                    phi_357_ = type_5(1u, _e175.member);
                } else {
                    phi_332_ = _e175;
                    phi_357_ = type_5(0u, type_5().member_1);
                }
                let _e190 = phi_332_;
                let _e192 = phi_357_;
                let _e195 = (bitcast<i32>(_e192.member) != 0i);
                if _e195 {
                    if (_e34 < _e177) {
                        if _e165 {
                        } else {
                            phi_518_ = true;
                            break;
                        }
                        let _e197 = global_2[_e164];
                        let _e201 = ((_e34 + _e177) % 64u);
                        if (_e201 < 64u) {
                        } else {
                            phi_518_ = true;
                            break;
                        }
                        let _e204 = global_2[_e201];
                        if _e165 {
                        } else {
                            phi_518_ = true;
                            break;
                        }
                        global_2[_e164] = type_25(vec3<f32>(select(_e204.member.x, _e197.member.x, (_e197.member.x < _e204.member.x)), select(_e204.member.y, _e197.member.y, (_e197.member.y < _e204.member.y)), select(_e204.member.z, _e197.member.z, (_e197.member.z < _e204.member.z))), vec3<f32>(select(_e204.member_1.x, _e197.member_1.x, (_e197.member_1.x > _e204.member_1.x)), select(_e204.member_1.y, _e197.member_1.y, (_e197.member_1.y > _e204.member_1.y)), select(_e204.member_1.z, _e197.member_1.z, (_e197.member_1.z > _e204.member_1.z))));
                    }
                    workgroupBarrier();
                    phi_335_ = (_e177 / 2u);
                } else {
                    phi_335_ = u32();
                }
                let _e236 = phi_335_;
                continue;
                continuing {
                    phi_331_ = _e190;
                    phi_334_ = _e236;
                    phi_518_ = _e163;
                    break if !(_e195);
                }
            }
            let _e239 = phi_518_;
            if _e239 {
                break;
            }
            if (_e34 == 0u) {
                let _e241 = (_e46 < arrayLength((&global_5.member)));
                if _e241 {
                    let _e243 = global_2[0u];
                    if _e241 {
                    } else {
                        break;
                    }
                    global_5.member[_e46] = array<f32, 6>(_e243.member.x, _e243.member.y, _e243.member.z, _e243.member_1.x, _e243.member_1.y, _e243.member_1.z);
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
