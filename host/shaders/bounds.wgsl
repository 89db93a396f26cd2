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
    var phi_161_: type_5;
    var phi_164_: type_21;
    var phi_162_: type_5;
    var phi_187_: type_5;
    var phi_208_: array<u32, 3>;
    var phi_223_: array<f32, 3>;
    var phi_241_: array<f32, 3>;
    var phi_259_: array<f32, 3>;
    var phi_165_: type_21;
    var phi_922_: bool;
    var local: type_21;
    var local_1: type_21;
    var phi_319_: type_5;
    var phi_322_: u32;
    var phi_320_: type_5;
    var phi_345_: type_5;
    var phi_323_: u32;
    var phi_950_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e36 = global;
            let _e37 = global_1;
            let _e40 = arrayLength((&global_3.member));
            let _e43 = arrayLength((&global_4.member));
            let _e49 = (_e36.x + (_e36.y * 32768u));
            let _e52 = ((_e49 * 1024u) + (_e37 * 16u));
            let _e54 = select(_e43, _e52, (_e52 < _e43));
            let _e55 = (_e43 - _e54);
            phi_161_ = type_5(_e54, (_e54 + select(16u, _e55, (_e55 < 16u))));
            phi_164_ = type_21(vec3<f32>(340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f), vec3<f32>(-340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f));
            loop {
                let _e61 = phi_161_;
                let _e63 = phi_164_;
                local = _e63;
                local_1 = _e63;
                if (_e61.member < _e61.member_1) {
                    phi_162_ = type_5((_e61.member + 1u), _e61.member_1);
                    phi_187_ = type_5(1u, _e61.member);
                } else {
                    phi_162_ = _e61;
                    phi_187_ = type_5(0u, type_5().member_1);
                }
                let _e76 = phi_162_;
                let _e78 = phi_187_;
                let _e82 = (bitcast<i32>(_e78.member) != 0i);
                if _e82 {
                    let _e83 = (_e78.member_1 < _e43);
                    if _e83 {
                        if _e83 {
                        } else {
                            phi_922_ = true;
                            break;
                        }
                        let _e85 = global_4.member[_e78.member_1];
                        phi_208_ = _e85;
                    } else {
                        phi_208_ = array<u32, 3>(0u, 0u, 0u);
                    }
                    let _e87 = phi_208_;
                    let _e89 = (_e87[0] < _e40);
                    if _e89 {
                        if _e89 {
                        } else {
                            phi_922_ = true;
                            break;
                        }
                        let _e91 = global_3.member[_e87[0]];
                        phi_223_ = _e91;
                    } else {
                        phi_223_ = array<f32, 3>(0f, 0f, 0f);
                    }
                    let _e93 = phi_223_;
                    let _e98 = (_e87[1] < _e40);
                    if _e98 {
                        if _e98 {
                        } else {
                            phi_922_ = true;
                            break;
                        }
                        let _e100 = global_3.member[_e87[1]];
                        phi_241_ = _e100;
                    } else {
                        phi_241_ = array<f32, 3>(0f, 0f, 0f);
                    }
                    let _e102 = phi_241_;
                    let _e107 = (_e87[2] < _e40);
                    if _e107 {
                        if _e107 {
                        } else {
                            phi_922_ = true;
                            break;
                        }
                        let _e109 = global_3.member[_e87[2]];
                        phi_259_ = _e109;
                    } else {
                        phi_259_ = array<f32, 3>(0f, 0f, 0f);
                    }
                    let _e111 = phi_259_;
                    let _e116 = bitcast<i32>(bitcast<u32>(_e93[0]));
                    let _e120 = (_e116 ^ ((_e116 >> bitcast<u32>(31i)) & 2147483647i));
                    let _e122 = bitcast<i32>(bitcast<u32>(_e102[0]));
                    let _e126 = (_e122 ^ ((_e122 >> bitcast<u32>(31i)) & 2147483647i));
                    let _e128 = select(_e102[0], _e93[0], (_e120 < _e126));
                    let _e130 = bitcast<i32>(bitcast<u32>(_e93[1]));
                    let _e134 = (_e130 ^ ((_e130 >> bitcast<u32>(31i)) & 2147483647i));
                    let _e136 = bitcast<i32>(bitcast<u32>(_e102[1]));
                    let _e140 = (_e136 ^ ((_e136 >> bitcast<u32>(31i)) & 2147483647i));
                    let _e142 = select(_e102[1], _e93[1], (_e134 < _e140));
                    let _e144 = bitcast<i32>(bitcast<u32>(_e93[2]));
                    let _e148 = (_e144 ^ ((_e144 >> bitcast<u32>(31i)) & 2147483647i));
                    let _e150 = bitcast<i32>(bitcast<u32>(_e102[2]));
                    let _e154 = (_e150 ^ ((_e150 >> bitcast<u32>(31i)) & 2147483647i));
                    let _e156 = select(_e102[2], _e93[2], (_e148 < _e154));
                    let _e158 = select(_e102[0], _e93[0], (_e120 > _e126));
                    let _e160 = select(_e102[1], _e93[1], (_e134 > _e140));
                    let _e162 = select(_e102[2], _e93[2], (_e148 > _e154));
                    let _e164 = bitcast<i32>(bitcast<u32>(_e128));
                    let _e170 = bitcast<i32>(bitcast<u32>(_e111[0]));
                    let _e174 = (_e170 ^ ((_e170 >> bitcast<u32>(31i)) & 2147483647i));
                    let _e176 = select(_e111[0], _e128, ((_e164 ^ ((_e164 >> bitcast<u32>(31i)) & 2147483647i)) < _e174));
                    let _e178 = bitcast<i32>(bitcast<u32>(_e142));
                    let _e184 = bitcast<i32>(bitcast<u32>(_e111[1]));
                    let _e188 = (_e184 ^ ((_e184 >> bitcast<u32>(31i)) & 2147483647i));
                    let _e190 = select(_e111[1], _e142, ((_e178 ^ ((_e178 >> bitcast<u32>(31i)) & 2147483647i)) < _e188));
                    let _e192 = bitcast<i32>(bitcast<u32>(_e156));
                    let _e198 = bitcast<i32>(bitcast<u32>(_e111[2]));
                    let _e202 = (_e198 ^ ((_e198 >> bitcast<u32>(31i)) & 2147483647i));
                    let _e204 = select(_e111[2], _e156, ((_e192 ^ ((_e192 >> bitcast<u32>(31i)) & 2147483647i)) < _e202));
                    let _e206 = bitcast<i32>(bitcast<u32>(_e158));
                    let _e212 = select(_e111[0], _e158, ((_e206 ^ ((_e206 >> bitcast<u32>(31i)) & 2147483647i)) > _e174));
                    let _e214 = bitcast<i32>(bitcast<u32>(_e160));
                    let _e220 = select(_e111[1], _e160, ((_e214 ^ ((_e214 >> bitcast<u32>(31i)) & 2147483647i)) > _e188));
                    let _e222 = bitcast<i32>(bitcast<u32>(_e162));
                    let _e228 = select(_e111[2], _e162, ((_e222 ^ ((_e222 >> bitcast<u32>(31i)) & 2147483647i)) > _e202));
                    let _e232 = bitcast<i32>(bitcast<u32>(_e63.member.x));
                    let _e238 = bitcast<i32>(bitcast<u32>(_e176));
                    let _e248 = bitcast<i32>(bitcast<u32>(_e63.member.y));
                    let _e254 = bitcast<i32>(bitcast<u32>(_e190));
                    let _e264 = bitcast<i32>(bitcast<u32>(_e63.member.z));
                    let _e270 = bitcast<i32>(bitcast<u32>(_e204));
                    let _e281 = bitcast<i32>(bitcast<u32>(_e63.member_1.x));
                    let _e287 = bitcast<i32>(bitcast<u32>(_e212));
                    let _e297 = bitcast<i32>(bitcast<u32>(_e63.member_1.y));
                    let _e303 = bitcast<i32>(bitcast<u32>(_e220));
                    let _e313 = bitcast<i32>(bitcast<u32>(_e63.member_1.z));
                    let _e319 = bitcast<i32>(bitcast<u32>(_e228));
                    phi_165_ = type_21(vec3<f32>(select(_e176, _e63.member.x, ((_e232 ^ ((_e232 >> bitcast<u32>(31i)) & 2147483647i)) < (_e238 ^ ((_e238 >> bitcast<u32>(31i)) & 2147483647i)))), select(_e190, _e63.member.y, ((_e248 ^ ((_e248 >> bitcast<u32>(31i)) & 2147483647i)) < (_e254 ^ ((_e254 >> bitcast<u32>(31i)) & 2147483647i)))), select(_e204, _e63.member.z, ((_e264 ^ ((_e264 >> bitcast<u32>(31i)) & 2147483647i)) < (_e270 ^ ((_e270 >> bitcast<u32>(31i)) & 2147483647i))))), vec3<f32>(select(_e212, _e63.member_1.x, ((_e281 ^ ((_e281 >> bitcast<u32>(31i)) & 2147483647i)) > (_e287 ^ ((_e287 >> bitcast<u32>(31i)) & 2147483647i)))), select(_e220, _e63.member_1.y, ((_e297 ^ ((_e297 >> bitcast<u32>(31i)) & 2147483647i)) > (_e303 ^ ((_e303 >> bitcast<u32>(31i)) & 2147483647i)))), select(_e228, _e63.member_1.z, ((_e313 ^ ((_e313 >> bitcast<u32>(31i)) & 2147483647i)) > (_e319 ^ ((_e319 >> bitcast<u32>(31i)) & 2147483647i))))));
                } else {
                    phi_165_ = type_21();
                }
                let _e329 = phi_165_;
                continue;
                continuing {
                    phi_161_ = _e76;
                    phi_164_ = _e329;
                    phi_922_ = false;
                    break if !(_e82);
                }
            }
            let _e332 = phi_922_;
            if _e332 {
                break;
            }
            let _e334 = local;
            let _e353 = local_1;
            let _e371 = (_e37 % 64u);
            let _e372 = (_e371 < 64u);
            if _e372 {
            } else {
                break;
            }
            global_2[_e371] = type_26(vec3<f32>(select(_e334.member.x, 0f, ((bitcast<u32>(_e334.member.x) & 2147483647u) == 0u)), select(_e334.member.y, 0f, ((bitcast<u32>(_e334.member.y) & 2147483647u) == 0u)), select(_e334.member.z, 0f, ((bitcast<u32>(_e334.member.z) & 2147483647u) == 0u))), vec3<f32>(select(_e353.member_1.x, 0f, ((bitcast<u32>(_e353.member_1.x) & 2147483647u) == 0u)), select(_e353.member_1.y, 0f, ((bitcast<u32>(_e353.member_1.y) & 2147483647u) == 0u)), select(_e353.member_1.z, 0f, ((bitcast<u32>(_e353.member_1.z) & 2147483647u) == 0u))));
            workgroupBarrier();
            phi_319_ = type_5(0u, 6u);
            phi_322_ = 32u;
            loop {
                let _e376 = phi_319_;
                let _e378 = phi_322_;
                if (_e376.member < _e376.member_1) {
                    phi_320_ = type_5((_e376.member + 1u), _e376.member_1);
                    phi_345_ = type_5(1u, _e376.member);
                } else {
                    phi_320_ = _e376;
                    phi_345_ = type_5(0u, type_5().member_1);
                }
                let _e391 = phi_320_;
                let _e393 = phi_345_;
                let _e396 = (bitcast<i32>(_e393.member) != 0i);
                if _e396 {
                    if (_e37 < _e378) {
                        if _e372 {
                        } else {
                            phi_950_ = true;
                            break;
                        }
                        let _e398 = global_2[_e371];
                        let _e402 = ((_e37 + _e378) % 64u);
                        if (_e402 < 64u) {
                        } else {
                            phi_950_ = true;
                            break;
                        }
                        let _e405 = global_2[_e402];
                        let _e411 = bitcast<i32>(bitcast<u32>(_e398.member.x));
                        let _e417 = bitcast<i32>(bitcast<u32>(_e405.member.x));
                        let _e427 = bitcast<i32>(bitcast<u32>(_e398.member.y));
                        let _e433 = bitcast<i32>(bitcast<u32>(_e405.member.y));
                        let _e443 = bitcast<i32>(bitcast<u32>(_e398.member.z));
                        let _e449 = bitcast<i32>(bitcast<u32>(_e405.member.z));
                        let _e460 = bitcast<i32>(bitcast<u32>(_e398.member_1.x));
                        let _e466 = bitcast<i32>(bitcast<u32>(_e405.member_1.x));
                        let _e476 = bitcast<i32>(bitcast<u32>(_e398.member_1.y));
                        let _e482 = bitcast<i32>(bitcast<u32>(_e405.member_1.y));
                        let _e492 = bitcast<i32>(bitcast<u32>(_e398.member_1.z));
                        let _e498 = bitcast<i32>(bitcast<u32>(_e405.member_1.z));
                        if _e372 {
                        } else {
                            phi_950_ = true;
                            break;
                        }
                        global_2[_e371] = type_26(vec3<f32>(select(_e405.member.x, _e398.member.x, ((_e411 ^ ((_e411 >> bitcast<u32>(31i)) & 2147483647i)) < (_e417 ^ ((_e417 >> bitcast<u32>(31i)) & 2147483647i)))), select(_e405.member.y, _e398.member.y, ((_e427 ^ ((_e427 >> bitcast<u32>(31i)) & 2147483647i)) < (_e433 ^ ((_e433 >> bitcast<u32>(31i)) & 2147483647i)))), select(_e405.member.z, _e398.member.z, ((_e443 ^ ((_e443 >> bitcast<u32>(31i)) & 2147483647i)) < (_e449 ^ ((_e449 >> bitcast<u32>(31i)) & 2147483647i))))), vec3<f32>(select(_e405.member_1.x, _e398.member_1.x, ((_e460 ^ ((_e460 >> bitcast<u32>(31i)) & 2147483647i)) > (_e466 ^ ((_e466 >> bitcast<u32>(31i)) & 2147483647i)))), select(_e405.member_1.y, _e398.member_1.y, ((_e476 ^ ((_e476 >> bitcast<u32>(31i)) & 2147483647i)) > (_e482 ^ ((_e482 >> bitcast<u32>(31i)) & 2147483647i)))), select(_e405.member_1.z, _e398.member_1.z, ((_e492 ^ ((_e492 >> bitcast<u32>(31i)) & 2147483647i)) > (_e498 ^ ((_e498 >> bitcast<u32>(31i)) & 2147483647i))))));
                    }
                    workgroupBarrier();
                    phi_323_ = (_e378 / 2u);
                } else {
                    phi_323_ = u32();
                }
                let _e509 = phi_323_;
                continue;
                continuing {
                    phi_319_ = _e391;
                    phi_322_ = _e509;
                    phi_950_ = _e332;
                    break if !(_e396);
                }
            }
            let _e512 = phi_950_;
            if _e512 {
                break;
            }
            if (_e37 == 0u) {
                let _e514 = (_e49 < arrayLength((&global_5.member)));
                if _e514 {
                    let _e516 = global_2[0u];
                    if _e514 {
                    } else {
                        break;
                    }
                    global_5.member[_e49] = array<f32, 6>(_e516.member.x, _e516.member.y, _e516.member.z, _e516.member_1.x, _e516.member_1.y, _e516.member_1.z);
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
