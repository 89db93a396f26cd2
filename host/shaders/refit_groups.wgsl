struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_10 {
    member: array<type_8>,
}

struct type_15 {
    member: array<array<f32, 8>>,
}

struct type_18 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<storage> global_1: type_10;
@group(0) @binding(1) 
var<storage, read_write> global_2: type_15;
@group(0) @binding(2) 
var<storage, read_write> global_3: type_15;

fn function_() {
    var phi_85_: u32;
    var phi_102_: type_4;
    var phi_105_: type_18;
    var phi_103_: type_4;
    var phi_128_: type_4;
    var phi_151_: type_8;
    var phi_307_: type_18;
    var phi_106_: type_18;
    var phi_334_: bool;
    var local: type_18;
    var local_1: type_18;
    var local_2: type_18;
    var local_3: type_18;
    var local_4: type_18;
    var local_5: type_18;

    switch bitcast<i32>(0u) {
        default: {
            let _e24 = global;
            let _e26 = arrayLength((&global_1.member));
            let _e34 = (_e24.x + (_e24.y * 2097152u));
            let _e35 = (_e26 / 4u);
            if ((_e26 % 4u) > 0u) {
                phi_85_ = (_e35 + 1u);
            } else {
                phi_85_ = _e35;
            }
            let _e40 = phi_85_;
            if (_e34 < _e40) {
                let _e42 = (_e34 < arrayLength((&global_2.member)));
                if _e42 {
                    let _e43 = (_e34 < arrayLength((&global_3.member)));
                    if _e43 {
                        let _e44 = (_e34 * 4u);
                        phi_102_ = type_4(_e44, (_e44 + 4u));
                        phi_105_ = type_18(vec4<f32>(340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f), vec4<f32>(-340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f));
                        loop {
                            let _e48 = phi_102_;
                            let _e50 = phi_105_;
                            local = _e50;
                            local_1 = _e50;
                            local_2 = _e50;
                            local_3 = _e50;
                            local_4 = _e50;
                            local_5 = _e50;
                            if (_e48.member < _e48.member_1) {
                                phi_103_ = type_4((_e48.member + 1u), _e48.member_1);
                                phi_128_ = type_4(1u, _e48.member);
                            } else {
                                phi_103_ = _e48;
                                phi_128_ = type_4(0u, type_4().member_1);
                            }
                            let _e63 = phi_103_;
                            let _e65 = phi_128_;
                            let _e69 = (bitcast<i32>(_e65.member) != 0i);
                            if _e69 {
                                let _e70 = (_e65.member_1 < _e26);
                                if _e70 {
                                    if _e70 {
                                        if _e70 {
                                        } else {
                                            phi_334_ = true;
                                            break;
                                        }
                                        let _e73 = global_1.member[_e65.member_1];
                                        phi_151_ = _e73;
                                    } else {
                                        phi_151_ = type_8(array<f32, 9>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f), 0u);
                                    }
                                    let _e75 = phi_151_;
                                    let _e87 = bitcast<f32>(_e75.member_1);
                                    let _e89 = select(_e75.member[3], _e75.member[0], (_e75.member[0] < _e75.member[3]));
                                    let _e91 = select(_e75.member[4], _e75.member[1], (_e75.member[1] < _e75.member[4]));
                                    let _e93 = select(_e75.member[5], _e75.member[2], (_e75.member[2] < _e75.member[5]));
                                    let _e95 = select(_e75.member[6], _e75.member[3], (_e75.member[3] < _e75.member[6]));
                                    let _e97 = select(_e75.member[6], _e89, (_e89 < _e75.member[6]));
                                    let _e99 = select(_e75.member[7], _e91, (_e91 < _e75.member[7]));
                                    let _e101 = select(_e75.member[8], _e93, (_e93 < _e75.member[8]));
                                    let _e103 = select(_e87, _e95, (_e95 < _e87));
                                    let _e105 = select(_e75.member[3], _e75.member[0], (_e75.member[0] > _e75.member[3]));
                                    let _e107 = select(_e75.member[4], _e75.member[1], (_e75.member[1] > _e75.member[4]));
                                    let _e109 = select(_e75.member[5], _e75.member[2], (_e75.member[2] > _e75.member[5]));
                                    let _e111 = select(_e75.member[6], _e75.member[3], (_e75.member[3] > _e75.member[6]));
                                    let _e113 = select(_e75.member[6], _e105, (_e105 > _e75.member[6]));
                                    let _e115 = select(_e75.member[7], _e107, (_e107 > _e75.member[7]));
                                    let _e117 = select(_e75.member[8], _e109, (_e109 > _e75.member[8]));
                                    let _e119 = select(_e87, _e111, (_e111 > _e87));
                                    phi_307_ = type_18(vec4<f32>(select(_e97, _e50.member.x, (_e50.member.x < _e97)), select(_e99, _e50.member.y, (_e50.member.y < _e99)), select(_e101, _e50.member.z, (_e50.member.z < _e101)), select(_e103, _e50.member.w, (_e50.member.w < _e103))), vec4<f32>(select(_e113, _e50.member_1.x, (_e50.member_1.x > _e113)), select(_e115, _e50.member_1.y, (_e50.member_1.y > _e115)), select(_e117, _e50.member_1.z, (_e50.member_1.z > _e117)), select(_e119, _e50.member_1.w, (_e50.member_1.w > _e119))));
                                } else {
                                    phi_307_ = _e50;
                                }
                                let _e150 = phi_307_;
                                phi_106_ = _e150;
                            } else {
                                phi_106_ = type_18();
                            }
                            let _e152 = phi_106_;
                            continue;
                            continuing {
                                phi_102_ = _e63;
                                phi_105_ = _e152;
                                phi_334_ = false;
                                break if !(_e69);
                            }
                        }
                        let _e155 = phi_334_;
                        if _e155 {
                            break;
                        }
                        let _e157 = local;
                        let _e161 = local_1;
                        let _e165 = local_2;
                        let _e169 = local_3;
                        let _e173 = local_4;
                        let _e177 = local_5;
                        let _e180 = array<f32, 8>(_e157.member.x, _e161.member.y, _e165.member.z, 0f, _e169.member_1.x, _e173.member_1.y, _e177.member_1.z, 0f);
                        if _e42 {
                        } else {
                            break;
                        }
                        global_2.member[_e34] = _e180;
                        if _e43 {
                        } else {
                            break;
                        }
                        global_3.member[_e34] = _e180;
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn refit_groups(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
