struct type_5 {
    member: u32,
    member_1: u32,
}

struct type_9 {
    member: u32,
    member_1: u32,
    member_2: u32,
}

struct type_11 {
    member: array<type_9>,
}

struct type_14 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
    member_2: f32,
    member_3: f32,
    member_4: u32,
}

struct type_16 {
    member: array<type_14>,
}

var<private> global: vec3<u32>;
var<private> global_1: u32;
var<workgroup> global_2: array<type_14, 64>;
@group(0) @binding(0) 
var<storage> global_3: type_11;
@group(0) @binding(1) 
var<storage> global_4: type_16;
@group(0) @binding(2) 
var<storage, read_write> global_5: type_16;

fn function_() {
    var phi_96_: type_9;
    var phi_113_: u32;
    var phi_116_: type_5;
    var phi_119_: type_14;
    var phi_117_: type_5;
    var phi_142_: type_5;
    var phi_170_: type_14;
    var phi_234_: type_14;
    var phi_120_: type_14;
    var phi_468_: bool;
    var local: type_14;
    var local_1: type_14;
    var local_2: type_14;
    var local_3: type_14;
    var local_4: type_14;
    var phi_258_: type_5;
    var phi_261_: u32;
    var phi_259_: type_5;
    var phi_284_: type_5;
    var phi_262_: u32;
    var phi_482_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e33 = global;
            let _e34 = global_1;
            let _e44 = (_e33.x + (_e33.y * 32768u));
            let _e45 = (_e44 < arrayLength((&global_3.member)));
            if _e45 {
                if _e45 {
                } else {
                    break;
                }
                let _e48 = global_3.member[_e44];
                phi_96_ = _e48;
            } else {
                phi_96_ = type_9(4294967295u, 0u, 0u);
            }
            let _e50 = phi_96_;
            let _e52 = (_e50.member_2 / 64u);
            if ((_e50.member_2 % 64u) > 0u) {
                phi_113_ = (_e52 + 1u);
            } else {
                phi_113_ = _e52;
            }
            let _e57 = phi_113_;
            phi_116_ = type_5(0u, _e57);
            phi_119_ = type_14(array<f32, 3>(340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f), array<f32, 3>(-340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f), 0f, 0f, 0u);
            loop {
                let _e60 = phi_116_;
                let _e62 = phi_119_;
                local = _e62;
                local_1 = _e62;
                local_2 = _e62;
                local_3 = _e62;
                local_4 = _e62;
                if (_e60.member < _e60.member_1) {
                    phi_117_ = type_5((_e60.member + 1u), _e60.member_1);
                    phi_142_ = type_5(1u, _e60.member);
                } else {
                    phi_117_ = _e60;
                    phi_142_ = type_5(0u, type_5().member_1);
                }
                let _e75 = phi_117_;
                let _e77 = phi_142_;
                let _e81 = (bitcast<i32>(_e77.member) != 0i);
                if _e81 {
                    let _e83 = ((_e77.member_1 * 64u) + _e34);
                    if (_e83 < _e50.member_2) {
                        let _e86 = (_e50.member_1 + _e83);
                        let _e87 = (_e86 < arrayLength((&global_4.member)));
                        if _e87 {
                            if _e87 {
                            } else {
                                phi_468_ = true;
                                break;
                            }
                            let _e90 = global_4.member[_e86];
                            phi_170_ = _e90;
                        } else {
                            phi_170_ = type_14(array<f32, 3>(340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f), array<f32, 3>(-340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f), 0f, 0f, 0u);
                        }
                        let _e92 = phi_170_;
                        let _e95 = (_e62.member_2 + _e92.member_2);
                        phi_234_ = type_14(array<f32, 3>(select(_e92.member[0], _e62.member[0], (_e62.member[0] < _e92.member[0])), select(_e92.member[1], _e62.member[1], (_e62.member[1] < _e92.member[1])), select(_e92.member[2], _e62.member[2], (_e62.member[2] < _e92.member[2]))), array<f32, 3>(select(_e92.member_1[0], _e62.member_1[0], (_e62.member_1[0] > _e92.member_1[0])), select(_e92.member_1[1], _e62.member_1[1], (_e62.member_1[1] > _e92.member_1[1])), select(_e92.member_1[2], _e62.member_1[2], (_e62.member_1[2] > _e92.member_1[2]))), _e95, ((_e62.member_3 + _e92.member_3) + (0.000000059604645f * bitcast<f32>((bitcast<u32>(_e95) & 2147483647u)))), (_e62.member_4 | _e92.member_4));
                    } else {
                        phi_234_ = _e62;
                    }
                    let _e139 = phi_234_;
                    phi_120_ = _e139;
                } else {
                    phi_120_ = type_14();
                }
                let _e141 = phi_120_;
                continue;
                continuing {
                    phi_116_ = _e75;
                    phi_119_ = _e141;
                    phi_468_ = false;
                    break if !(_e81);
                }
            }
            let _e144 = phi_468_;
            if _e144 {
                break;
            }
            let _e145 = (_e34 % 64u);
            let _e146 = (_e145 < 64u);
            if _e146 {
            } else {
                break;
            }
            let _e149 = local;
            let _e156 = local_1;
            let _e163 = local_2;
            let _e166 = local_3;
            let _e169 = local_4;
            global_2[_e145] = type_14(array<f32, 3>(_e149.member[0], _e149.member[1], _e149.member[2]), array<f32, 3>(_e156.member_1[0], _e156.member_1[1], _e156.member_1[2]), _e163.member_2, _e166.member_3, _e169.member_4);
            workgroupBarrier();
            phi_258_ = type_5(0u, 6u);
            phi_261_ = 32u;
            loop {
                let _e173 = phi_258_;
                let _e175 = phi_261_;
                if (_e173.member < _e173.member_1) {
                    phi_259_ = type_5((_e173.member + 1u), _e173.member_1);
                    phi_284_ = type_5(1u, _e173.member);
                } else {
                    phi_259_ = _e173;
                    phi_284_ = type_5(0u, type_5().member_1);
                }
                let _e188 = phi_259_;
                let _e190 = phi_284_;
                let _e193 = (bitcast<i32>(_e190.member) != 0i);
                if _e193 {
                    if (_e34 < _e175) {
                        if _e146 {
                        } else {
                            phi_482_ = true;
                            break;
                        }
                        let _e195 = global_2[_e145];
                        let _e208 = ((_e34 + _e175) % 64u);
                        if (_e208 < 64u) {
                        } else {
                            phi_482_ = true;
                            break;
                        }
                        let _e211 = global_2[_e208];
                        let _e223 = (_e195.member_2 + _e211.member_2);
                        if _e146 {
                        } else {
                            phi_482_ = true;
                            break;
                        }
                        global_2[_e145] = type_14(array<f32, 3>(select(_e211.member[0], _e195.member[0], (_e195.member[0] < _e211.member[0])), select(_e211.member[1], _e195.member[1], (_e195.member[1] < _e211.member[1])), select(_e211.member[2], _e195.member[2], (_e195.member[2] < _e211.member[2]))), array<f32, 3>(select(_e211.member_1[0], _e195.member_1[0], (_e195.member_1[0] > _e211.member_1[0])), select(_e211.member_1[1], _e195.member_1[1], (_e195.member_1[1] > _e211.member_1[1])), select(_e211.member_1[2], _e195.member_1[2], (_e195.member_1[2] > _e211.member_1[2]))), _e223, ((_e195.member_3 + _e211.member_3) + (0.000000059604645f * bitcast<f32>((bitcast<u32>(_e223) & 2147483647u)))), (_e195.member_4 | _e211.member_4));
                    }
                    workgroupBarrier();
                    phi_262_ = (_e175 / 2u);
                } else {
                    phi_262_ = u32();
                }
                let _e248 = phi_262_;
                continue;
                continuing {
                    phi_258_ = _e188;
                    phi_261_ = _e248;
                    phi_482_ = _e144;
                    break if !(_e193);
                }
            }
            let _e251 = phi_482_;
            if _e251 {
                break;
            }
            if (_e34 == 0u) {
                if _e45 {
                    let _e253 = (_e44 < arrayLength((&global_5.member)));
                    if _e253 {
                        let _e255 = global_2[0u];
                        if _e253 {
                        } else {
                            break;
                        }
                        global_5.member[_e44] = type_14(array<f32, 3>(_e255.member[0], _e255.member[1], _e255.member[2]), array<f32, 3>(_e255.member_1[0], _e255.member_1[1], _e255.member_1[2]), _e255.member_2, _e255.member_3, _e255.member_4);
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_components(@builtin(workgroup_id) param: vec3<u32>, @builtin(local_invocation_index) param_1: u32) {
    global = param;
    global_1 = param_1;
    function_();
}
