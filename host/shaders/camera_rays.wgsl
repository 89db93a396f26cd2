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
@group(0) @binding(1) 
var<uniform> global_2: type_8;
@group(0) @binding(3) 
var<storage, read_write> global_3: type_17;
@group(0) @binding(2) 
var<storage> global_4: type_22;

fn function_() {
    var phi_170_: type_20;
    var phi_208_: u32;
    var phi_211_: type_4;
    var phi_212_: type_4;
    var phi_234_: type_4;
    var phi_247_: u32;
    var phi_209_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_282_: array<f32, 2>;
    var phi_341_: type_14;

    switch bitcast<i32>(0u) {
        default: {
            let _e33 = global;
            let _e35 = arrayLength((&global_4.member));
            let _e41 = (_e33.x + (_e33.y * 2097152u));
            let _e42 = (_e41 < arrayLength((&global_3.member)));
            if _e42 {
                if (_e35 == 0u) {
                } else {
                    if (0u < _e35) {
                    } else {
                        break;
                    }
                    let _e47 = global_1.member[0u];
                    let _e48 = bitcast<i32>(_e47);
                    let _e49 = (_e48 / 2i);
                    let _e54 = bitcast<f32>((bitcast<u32>((_e49 + 127i)) << bitcast<u32>(23i)));
                    let _e60 = bitcast<f32>((bitcast<u32>(((_e48 - _e49) + 127i)) << bitcast<u32>(23i)));
                    let _e63 = global_4.member[0u];
                    let _e67 = global_4.member[0u].member;
                    let _e86 = type_20(array<f32, 3>(((_e67[0] * _e54) * _e60), ((_e67[1] * _e54) * _e60), ((_e67[2] * _e54) * _e60)), _e63.member_1, _e63.member_2, _e63.member_3, _e63.member_4, _e63.member_5, _e63.member_6, _e63.member_7);
                    let _e90 = global_4.member[0u].member_1;
                    if (_e90 == 1u) {
                        let _e95 = global_4.member[0u].member_4;
                        let _e114 = type_20(_e86.member, _e86.member_1, _e86.member_2, _e86.member_3, array<f32, 3>(((_e95[0] * _e54) * _e60), ((_e95[1] * _e54) * _e60), ((_e95[2] * _e54) * _e60)), _e86.member_5, _e86.member_6, _e86.member_7);
                        let _e118 = global_4.member[0u].member_6;
                        phi_170_ = type_20(_e114.member, _e114.member_1, _e114.member_2, _e114.member_3, _e114.member_4, _e114.member_5, array<f32, 3>(((_e118[0] * _e54) * _e60), ((_e118[1] * _e54) * _e60), ((_e118[2] * _e54) * _e60)), _e114.member_7);
                    } else {
                        phi_170_ = _e86;
                    }
                    let _e139 = phi_170_;
                    let _e142 = global_2.member[0u];
                    let _e143 = (_e142 + _e41);
                    let _e146 = select(1u, _e139.member_7, (1u < _e139.member_7));
                    let _e149 = select(1u, _e139.member_3, (1u < _e139.member_3));
                    let _e150 = (_e146 == 0u);
                    if _e150 {
                        break;
                    }
                    let _e151 = (_e143 / _e146);
                    let _e152 = (_e149 == 0u);
                    if _e152 {
                        break;
                    }
                    if _e152 {
                        break;
                    }
                    if _e150 {
                        break;
                    }
                    let _e155 = (_e143 % _e146);
                    phi_208_ = 1u;
                    phi_211_ = type_4(0u, 16u);
                    loop {
                        let _e157 = phi_208_;
                        let _e159 = phi_211_;
                        local = _e157;
                        local_1 = _e157;
                        local_2 = _e157;
                        local_3 = _e157;
                        local_4 = _e157;
                        local_5 = _e157;
                        if (_e159.member < _e159.member_1) {
                            phi_212_ = type_4((_e159.member + 1u), _e159.member_1);
                            phi_234_ = type_4(1u, _e159.member);
                        } else {
                            phi_212_ = _e159;
                            phi_234_ = type_4(0u, type_4().member_1);
                        }
                        let _e172 = phi_212_;
                        let _e174 = phi_234_;
                        let _e177 = (bitcast<i32>(_e174.member) != 0i);
                        if _e177 {
                            if ((_e157 * _e157) < _e146) {
                                phi_247_ = (_e157 + 1u);
                            } else {
                                phi_247_ = _e157;
                            }
                            let _e182 = phi_247_;
                            phi_209_ = _e182;
                        } else {
                            phi_209_ = u32();
                        }
                        let _e184 = phi_209_;
                        continue;
                        continuing {
                            phi_208_ = _e184;
                            phi_211_ = _e172;
                            break if !(_e177);
                        }
                    }
                    let _e187 = local;
                    let _e189 = local_1;
                    if ((_e187 * _e189) == _e146) {
                        let _e204 = local_2;
                        let _e205 = (_e204 == 0u);
                        if _e205 {
                            break;
                        }
                        let _e207 = local_3;
                        let _e212 = local_4;
                        let _e213 = f32(_e212);
                        if _e205 {
                            break;
                        }
                        let _e216 = local_5;
                        phi_282_ = array<f32, 2>(((f32((_e155 % _e207)) + 0.5f) / _e213), ((f32((_e155 / _e216)) + 0.5f) / _e213));
                    } else {
                        phi_282_ = array<f32, 2>(((f32(_e155) + 0.5f) / f32(_e146)), (f32((((_e155 * 2654435769u) + 1327217884u) >> bitcast<u32>(8i))) * 0.000000059604645f));
                    }
                    let _e223 = phi_282_;
                    let _e231 = ((((f32((_e151 % _e149)) + _e223[0]) / f32(_e139.member_3)) * 2f) - 1f);
                    let _e238 = (1f - (((f32((_e151 / _e149)) + _e223[1]) / f32(_e139.member_5)) * 2f));
                    let _e253 = ((_e139.member_4[0] * _e231) + (_e139.member_6[0] * _e238));
                    let _e254 = ((_e139.member_4[1] * _e231) + (_e139.member_6[1] * _e238));
                    let _e255 = ((_e139.member_4[2] * _e231) + (_e139.member_6[2] * _e238));
                    if (_e139.member_1 == 0u) {
                        phi_341_ = type_14(_e139.member, 0f, array<f32, 3>((_e139.member_2[0] + _e253), (_e139.member_2[1] + _e254), (_e139.member_2[2] + _e255)), 340282350000000000000000000000000000000f);
                    } else {
                        phi_341_ = type_14(array<f32, 3>((_e139.member[0] + _e253), (_e139.member[1] + _e254), (_e139.member[2] + _e255)), 0f, _e139.member_2, 340282350000000000000000000000000000000f);
                    }
                    let _e277 = phi_341_;
                    if _e42 {
                    } else {
                        break;
                    }
                    global_3.member[_e41] = type_15(_e277, array<f32, 3>(1f, 1f, 1f), 4294967295u, array<f32, 3>(0f, 0f, 0f), 0u);
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
