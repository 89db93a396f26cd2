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

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_7;
@group(0) @binding(1) 
var<storage> global_2: type_12;
@group(0) @binding(2) 
var<storage> global_3: type_16;
@group(0) @binding(3) 
var<storage, read_write> global_4: type_21;

fn function_() {
    var phi_101_: i32;
    var phi_136_: array<u32, 3>;
    var phi_151_: array<f32, 3>;
    var phi_169_: array<f32, 3>;
    var phi_187_: array<f32, 3>;

    switch bitcast<i32>(0u) {
        default: {
            let _e26 = global;
            let _e29 = arrayLength((&global_2.member));
            let _e38 = (_e26.x + (_e26.y * 2097152u));
            let _e39 = (_e38 < arrayLength((&global_4.member)));
            if _e39 {
                let _e42 = global_1.member[0u];
                let _e43 = bitcast<i32>(_e42);
                if (_e43 < -126i) {
                    phi_101_ = -126i;
                } else {
                    phi_101_ = select(_e43, 127i, (_e43 > 127i));
                }
                let _e48 = phi_101_;
                let _e53 = bitcast<f32>((bitcast<u32>((_e48 + 127i)) << bitcast<u32>(23i)));
                let _e59 = bitcast<f32>((bitcast<u32>(((_e43 - _e48) + 127i)) << bitcast<u32>(23i)));
                if _e39 {
                } else {
                    break;
                }
                let _e65 = global_4.member[_e38].member_1;
                let _e66 = (_e65 < arrayLength((&global_3.member)));
                if _e66 {
                    if _e66 {
                    } else {
                        break;
                    }
                    let _e68 = global_3.member[_e65];
                    phi_136_ = _e68;
                } else {
                    phi_136_ = array<u32, 3>(0u, 0u, 0u);
                }
                let _e70 = phi_136_;
                let _e72 = (_e70[0] < _e29);
                if _e72 {
                    if _e72 {
                    } else {
                        break;
                    }
                    let _e74 = global_2.member[_e70[0]];
                    phi_151_ = _e74;
                } else {
                    phi_151_ = array<f32, 3>(0f, 0f, 0f);
                }
                let _e76 = phi_151_;
                let _e81 = (_e70[1] < _e29);
                if _e81 {
                    if _e81 {
                    } else {
                        break;
                    }
                    let _e83 = global_2.member[_e70[1]];
                    phi_169_ = _e83;
                } else {
                    phi_169_ = array<f32, 3>(0f, 0f, 0f);
                }
                let _e85 = phi_169_;
                let _e90 = (_e70[2] < _e29);
                if _e90 {
                    if _e90 {
                    } else {
                        break;
                    }
                    let _e92 = global_2.member[_e70[2]];
                    phi_187_ = _e92;
                } else {
                    phi_187_ = array<f32, 3>(0f, 0f, 0f);
                }
                let _e94 = phi_187_;
                let _e98 = bitcast<u32>(_e76[0]);
                let _e100 = ((_e98 & 2139095040u) != 0u);
                let _e114 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e98 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e98 & 2147483648u))), _e76[0], _e100) * _e53) * select(0.00000011920929f, 1f, _e100)) * _e59);
                let _e120 = bitcast<u32>(_e76[1]);
                let _e122 = ((_e120 & 2139095040u) != 0u);
                let _e136 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e120 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e120 & 2147483648u))), _e76[1], _e122) * _e53) * select(0.00000011920929f, 1f, _e122)) * _e59);
                let _e142 = bitcast<u32>(_e76[2]);
                let _e144 = ((_e142 & 2139095040u) != 0u);
                let _e158 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e142 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e142 & 2147483648u))), _e76[2], _e144) * _e53) * select(0.00000011920929f, 1f, _e144)) * _e59);
                let _e164 = bitcast<u32>(_e85[0]);
                let _e166 = ((_e164 & 2139095040u) != 0u);
                let _e180 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e164 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e164 & 2147483648u))), _e85[0], _e166) * _e53) * select(0.00000011920929f, 1f, _e166)) * _e59);
                let _e186 = bitcast<u32>(_e85[1]);
                let _e188 = ((_e186 & 2139095040u) != 0u);
                let _e202 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e186 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e186 & 2147483648u))), _e85[1], _e188) * _e53) * select(0.00000011920929f, 1f, _e188)) * _e59);
                let _e208 = bitcast<u32>(_e85[2]);
                let _e210 = ((_e208 & 2139095040u) != 0u);
                let _e224 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e208 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e208 & 2147483648u))), _e85[2], _e210) * _e53) * select(0.00000011920929f, 1f, _e210)) * _e59);
                let _e230 = bitcast<u32>(_e94[0]);
                let _e232 = ((_e230 & 2139095040u) != 0u);
                let _e246 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e230 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e230 & 2147483648u))), _e94[0], _e232) * _e53) * select(0.00000011920929f, 1f, _e232)) * _e59);
                let _e252 = bitcast<u32>(_e94[1]);
                let _e254 = ((_e252 & 2139095040u) != 0u);
                let _e268 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e252 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e252 & 2147483648u))), _e94[1], _e254) * _e53) * select(0.00000011920929f, 1f, _e254)) * _e59);
                let _e274 = bitcast<u32>(_e94[2]);
                let _e276 = ((_e274 & 2139095040u) != 0u);
                let _e290 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e274 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e274 & 2147483648u))), _e94[2], _e276) * _e53) * select(0.00000011920929f, 1f, _e276)) * _e59);
                if _e39 {
                } else {
                    break;
                }
                global_4.member[_e38] = type_19(array<f32, 9>(select(_e114, 0f, (bitcast<f32>((bitcast<u32>(_e114) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f)), select(_e136, 0f, (bitcast<f32>((bitcast<u32>(_e136) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f)), select(_e158, 0f, (bitcast<f32>((bitcast<u32>(_e158) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f)), select(_e180, 0f, (bitcast<f32>((bitcast<u32>(_e180) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f)), select(_e202, 0f, (bitcast<f32>((bitcast<u32>(_e202) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f)), select(_e224, 0f, (bitcast<f32>((bitcast<u32>(_e224) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f)), select(_e246, 0f, (bitcast<f32>((bitcast<u32>(_e246) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f)), select(_e268, 0f, (bitcast<f32>((bitcast<u32>(_e268) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f)), select(_e290, 0f, (bitcast<f32>((bitcast<u32>(_e290) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f))), _e65);
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn snap_again(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
