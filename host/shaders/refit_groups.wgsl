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
    var phi_84_: u32;
    var phi_101_: type_4;
    var phi_104_: type_18;
    var phi_102_: type_4;
    var phi_127_: type_4;
    var phi_150_: type_8;
    var phi_306_: type_18;
    var phi_105_: type_18;
    var phi_333_: bool;
    var local: type_18;
    var local_1: type_18;
    var local_2: type_18;
    var local_3: type_18;
    var local_4: type_18;
    var local_5: type_18;

    switch bitcast<i32>(0u) {
        default: {
            let _e23 = global;
            let _e25 = arrayLength((&global_1.member));
            let _e33 = (_e23.x + (_e23.y * 2097152u));
            let _e34 = (_e25 / 8u);
            if ((_e25 % 8u) > 0u) {
                phi_84_ = (_e34 + 1u);
            } else {
                phi_84_ = _e34;
            }
            let _e39 = phi_84_;
            if (_e33 < _e39) {
                let _e41 = (_e33 < arrayLength((&global_2.member)));
                if _e41 {
                    let _e42 = (_e33 < arrayLength((&global_3.member)));
                    if _e42 {
                        let _e43 = (_e33 * 8u);
                        phi_101_ = type_4(_e43, (_e43 + 8u));
                        phi_104_ = type_18(vec4<f32>(340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f), vec4<f32>(-340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f));
                        loop {
                            let _e47 = phi_101_;
                            let _e49 = phi_104_;
                            local = _e49;
                            local_1 = _e49;
                            local_2 = _e49;
                            local_3 = _e49;
                            local_4 = _e49;
                            local_5 = _e49;
                            if (_e47.member < _e47.member_1) {
                                phi_102_ = type_4((_e47.member + 1u), _e47.member_1);
                                phi_127_ = type_4(1u, _e47.member);
                            } else {
                                phi_102_ = _e47;
                                phi_127_ = type_4(0u, type_4().member_1);
                            }
                            let _e62 = phi_102_;
                            let _e64 = phi_127_;
                            let _e68 = (bitcast<i32>(_e64.member) != 0i);
                            if _e68 {
                                let _e69 = (_e64.member_1 < _e25);
                                if _e69 {
                                    if _e69 {
                                        if _e69 {
                                        } else {
                                            phi_333_ = true;
                                            break;
                                        }
                                        let _e72 = global_1.member[_e64.member_1];
                                        phi_150_ = _e72;
                                    } else {
                                        phi_150_ = type_8(array<f32, 9>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f), 0u);
                                    }
                                    let _e74 = phi_150_;
                                    let _e86 = bitcast<f32>(_e74.member_1);
                                    let _e88 = select(_e74.member[3], _e74.member[0], (_e74.member[0] < _e74.member[3]));
                                    let _e90 = select(_e74.member[4], _e74.member[1], (_e74.member[1] < _e74.member[4]));
                                    let _e92 = select(_e74.member[5], _e74.member[2], (_e74.member[2] < _e74.member[5]));
                                    let _e94 = select(_e74.member[6], _e74.member[3], (_e74.member[3] < _e74.member[6]));
                                    let _e96 = select(_e74.member[6], _e88, (_e88 < _e74.member[6]));
                                    let _e98 = select(_e74.member[7], _e90, (_e90 < _e74.member[7]));
                                    let _e100 = select(_e74.member[8], _e92, (_e92 < _e74.member[8]));
                                    let _e102 = select(_e86, _e94, (_e94 < _e86));
                                    let _e104 = select(_e74.member[3], _e74.member[0], (_e74.member[0] > _e74.member[3]));
                                    let _e106 = select(_e74.member[4], _e74.member[1], (_e74.member[1] > _e74.member[4]));
                                    let _e108 = select(_e74.member[5], _e74.member[2], (_e74.member[2] > _e74.member[5]));
                                    let _e110 = select(_e74.member[6], _e74.member[3], (_e74.member[3] > _e74.member[6]));
                                    let _e112 = select(_e74.member[6], _e104, (_e104 > _e74.member[6]));
                                    let _e114 = select(_e74.member[7], _e106, (_e106 > _e74.member[7]));
                                    let _e116 = select(_e74.member[8], _e108, (_e108 > _e74.member[8]));
                                    let _e118 = select(_e86, _e110, (_e110 > _e86));
                                    phi_306_ = type_18(vec4<f32>(select(_e96, _e49.member.x, (_e49.member.x < _e96)), select(_e98, _e49.member.y, (_e49.member.y < _e98)), select(_e100, _e49.member.z, (_e49.member.z < _e100)), select(_e102, _e49.member.w, (_e49.member.w < _e102))), vec4<f32>(select(_e112, _e49.member_1.x, (_e49.member_1.x > _e112)), select(_e114, _e49.member_1.y, (_e49.member_1.y > _e114)), select(_e116, _e49.member_1.z, (_e49.member_1.z > _e116)), select(_e118, _e49.member_1.w, (_e49.member_1.w > _e118))));
                                } else {
                                    phi_306_ = _e49;
                                }
                                let _e149 = phi_306_;
                                phi_105_ = _e149;
                            } else {
                                phi_105_ = type_18();
                            }
                            let _e151 = phi_105_;
                            continue;
                            continuing {
                                phi_101_ = _e62;
                                phi_104_ = _e151;
                                phi_333_ = false;
                                break if !(_e68);
                            }
                        }
                        let _e154 = phi_333_;
                        if _e154 {
                            break;
                        }
                        let _e156 = local;
                        let _e160 = local_1;
                        let _e164 = local_2;
                        let _e168 = local_3;
                        let _e172 = local_4;
                        let _e176 = local_5;
                        let _e179 = array<f32, 8>(_e156.member.x, _e160.member.y, _e164.member.z, 0f, _e168.member_1.x, _e172.member_1.y, _e176.member_1.z, 0f);
                        if _e41 {
                        } else {
                            break;
                        }
                        global_2.member[_e33] = _e179;
                        if _e42 {
                        } else {
                            break;
                        }
                        global_3.member[_e33] = _e179;
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
