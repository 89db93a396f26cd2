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

struct type_31 {
    member: array<array<u32, 2>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_7;
@group(0) @binding(1) 
var<storage> global_2: type_12;
@group(0) @binding(2) 
var<storage> global_3: type_16;
@group(0) @binding(4) 
var<storage, read_write> global_4: type_21;
@group(0) @binding(3) 
var<storage> global_5: type_16;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_31;

fn function_() {
    var phi_122_: i32;
    var phi_165_: array<u32, 3>;
    var phi_180_: array<f32, 3>;
    var phi_198_: array<f32, 3>;
    var phi_216_: array<f32, 3>;

    switch bitcast<i32>(0u) {
        default: {
            let _e29 = global;
            let _e32 = arrayLength((&global_2.member));
            let _e45 = (_e29.x + (_e29.y * 2097152u));
            let _e46 = (_e45 < arrayLength((&global_4.member)));
            if _e46 {
                let _e47 = (_e45 < arrayLength((&global_5.member)));
                if _e47 {
                    let _e48 = (_e45 < arrayLength((&global_6.member)));
                    if _e48 {
                        let _e51 = global_1.member[0u];
                        let _e52 = bitcast<i32>(_e51);
                        if (_e52 < -126i) {
                            phi_122_ = -126i;
                        } else {
                            phi_122_ = select(_e52, 127i, (_e52 > 127i));
                        }
                        let _e57 = phi_122_;
                        let _e62 = bitcast<f32>((bitcast<u32>((_e57 + 127i)) << bitcast<u32>(23i)));
                        let _e68 = bitcast<f32>((bitcast<u32>(((_e52 - _e57) + 127i)) << bitcast<u32>(23i)));
                        if _e47 {
                        } else {
                            break;
                        }
                        let _e72 = global_5.member[_e45][0u];
                        let _e76 = global_5.member[_e45][1u];
                        let _e80 = global_5.member[_e45][2u];
                        let _e81 = (_e80 < arrayLength((&global_3.member)));
                        if _e81 {
                            if _e81 {
                            } else {
                                break;
                            }
                            let _e83 = global_3.member[_e80];
                            phi_165_ = _e83;
                        } else {
                            phi_165_ = array<u32, 3>(0u, 0u, 0u);
                        }
                        let _e85 = phi_165_;
                        let _e87 = (_e85[0] < _e32);
                        if _e87 {
                            if _e87 {
                            } else {
                                break;
                            }
                            let _e89 = global_2.member[_e85[0]];
                            phi_180_ = _e89;
                        } else {
                            phi_180_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e91 = phi_180_;
                        let _e96 = (_e85[1] < _e32);
                        if _e96 {
                            if _e96 {
                            } else {
                                break;
                            }
                            let _e98 = global_2.member[_e85[1]];
                            phi_198_ = _e98;
                        } else {
                            phi_198_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e100 = phi_198_;
                        let _e105 = (_e85[2] < _e32);
                        if _e105 {
                            if _e105 {
                            } else {
                                break;
                            }
                            let _e107 = global_2.member[_e85[2]];
                            phi_216_ = _e107;
                        } else {
                            phi_216_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e109 = phi_216_;
                        let _e113 = bitcast<u32>(_e91[0]);
                        let _e115 = ((_e113 & 2139095040u) != 0u);
                        let _e129 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e113 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e113 & 2147483648u))), _e91[0], _e115) * _e62) * select(0.00000011920929f, 1f, _e115)) * _e68);
                        let _e135 = bitcast<u32>(_e91[1]);
                        let _e137 = ((_e135 & 2139095040u) != 0u);
                        let _e151 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e135 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e135 & 2147483648u))), _e91[1], _e137) * _e62) * select(0.00000011920929f, 1f, _e137)) * _e68);
                        let _e157 = bitcast<u32>(_e91[2]);
                        let _e159 = ((_e157 & 2139095040u) != 0u);
                        let _e173 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e157 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e157 & 2147483648u))), _e91[2], _e159) * _e62) * select(0.00000011920929f, 1f, _e159)) * _e68);
                        let _e179 = bitcast<u32>(_e100[0]);
                        let _e181 = ((_e179 & 2139095040u) != 0u);
                        let _e195 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e179 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e179 & 2147483648u))), _e100[0], _e181) * _e62) * select(0.00000011920929f, 1f, _e181)) * _e68);
                        let _e201 = bitcast<u32>(_e100[1]);
                        let _e203 = ((_e201 & 2139095040u) != 0u);
                        let _e217 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e201 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e201 & 2147483648u))), _e100[1], _e203) * _e62) * select(0.00000011920929f, 1f, _e203)) * _e68);
                        let _e223 = bitcast<u32>(_e100[2]);
                        let _e225 = ((_e223 & 2139095040u) != 0u);
                        let _e239 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e223 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e223 & 2147483648u))), _e100[2], _e225) * _e62) * select(0.00000011920929f, 1f, _e225)) * _e68);
                        let _e245 = bitcast<u32>(_e109[0]);
                        let _e247 = ((_e245 & 2139095040u) != 0u);
                        let _e261 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e245 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e245 & 2147483648u))), _e109[0], _e247) * _e62) * select(0.00000011920929f, 1f, _e247)) * _e68);
                        let _e267 = bitcast<u32>(_e109[1]);
                        let _e269 = ((_e267 & 2139095040u) != 0u);
                        let _e283 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e267 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e267 & 2147483648u))), _e109[1], _e269) * _e62) * select(0.00000011920929f, 1f, _e269)) * _e68);
                        let _e289 = bitcast<u32>(_e109[2]);
                        let _e291 = ((_e289 & 2139095040u) != 0u);
                        let _e305 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e289 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e289 & 2147483648u))), _e109[2], _e291) * _e62) * select(0.00000011920929f, 1f, _e291)) * _e68);
                        if _e46 {
                        } else {
                            break;
                        }
                        global_4.member[_e45] = type_19(array<f32, 9>(select(_e129, 0f, (bitcast<f32>((bitcast<u32>(_e129) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f)), select(_e151, 0f, (bitcast<f32>((bitcast<u32>(_e151) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f)), select(_e173, 0f, (bitcast<f32>((bitcast<u32>(_e173) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f)), select(_e195, 0f, (bitcast<f32>((bitcast<u32>(_e195) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f)), select(_e217, 0f, (bitcast<f32>((bitcast<u32>(_e217) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f)), select(_e239, 0f, (bitcast<f32>((bitcast<u32>(_e239) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f)), select(_e261, 0f, (bitcast<f32>((bitcast<u32>(_e261) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f)), select(_e283, 0f, (bitcast<f32>((bitcast<u32>(_e283) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f)), select(_e305, 0f, (bitcast<f32>((bitcast<u32>(_e305) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f))), _e80);
                        if _e48 {
                        } else {
                            break;
                        }
                        global_6.member[_e45][0u] = _e72;
                        global_6.member[_e45][1u] = _e76;
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn snap_63_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
