struct type_5 {
    member: array<u32>,
}

struct type_11 {
    member: u32,
    member_1: u32,
}

struct type_16 {
    member: vec4<u32>,
}

struct type_21 {
    member: array<array<f32, 3>>,
}

struct type_25 {
    member: array<array<u32, 3>>,
}

struct type_34 {
    member: array<array<u32, 2>>,
}

struct type_37 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_39 {
    member: array<vec4<u32>, 2>,
}

struct type_42 {
    member: array<i32>,
}

var<private> global: u32;
var<private> global_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_2: type_16;
@group(0) @binding(3) 
var<storage> global_3: type_21;
@group(0) @binding(4) 
var<storage> global_4: type_25;
@group(0) @binding(1) 
var<uniform> global_5: type_39;
@group(0) @binding(2) 
var<storage> global_6: type_34;
@group(0) @binding(5) 
var<storage> global_7: type_5;
@group(0) @binding(6) 
var<storage> global_8: type_42;
@group(0) @binding(7) 
var<storage, read_write> global_9: type_5;
@group(0) @binding(8) 
var<storage, read_write> global_10: type_5;
var<workgroup> global_11: array<u32, 64>;

fn function_() {
    var phi_211_: type_37;
    var phi_260_: u32;
    var phi_274_: i32;
    var phi_292_: array<u32, 3>;
    var phi_307_: array<f32, 3>;
    var phi_325_: array<f32, 3>;
    var phi_343_: array<f32, 3>;
    var phi_438_: vec3<f32>;
    var phi_631_: bool;
    var phi_632_: bool;
    var phi_634_: u32;
    var phi_662_: type_11;
    var phi_665_: u32;
    var phi_663_: type_11;
    var phi_688_: type_11;
    var phi_666_: u32;
    var phi_727_: bool;
    var local: u32;
    var local_1: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e42 = global_1;
            let _e43 = global;
            let _e48 = arrayLength((&global_3.member));
            let _e65 = (_e42.x + (_e42.y * 2097152u));
            let _e66 = (_e65 < arrayLength((&global_6.member)));
            if _e66 {
                let _e69 = global_2.member[0u];
                let _e73 = global_5.member[0u][0u];
                let _e77 = global_5.member[0u][1u];
                let _e81 = global_5.member[0u][2u];
                let _e85 = global_5.member[0u][3u];
                let _e89 = global_5.member[1u][0u];
                let _e93 = global_5.member[1u][1u];
                let _e97 = global_5.member[1u][2u];
                let _e101 = global_5.member[1u][3u];
                let _e102 = bitcast<f32>(_e73);
                let _e103 = bitcast<f32>(_e77);
                let _e104 = bitcast<f32>(_e81);
                let _e106 = bitcast<f32>(_e89);
                let _e107 = array<u32, 3>(_e93, _e97, _e101);
                let _e109 = bitcast<i32>(_e69);
                let _e110 = (_e109 / 2i);
                let _e115 = bitcast<f32>((bitcast<u32>((_e110 + 127i)) << bitcast<u32>(23i)));
                let _e121 = bitcast<f32>((bitcast<u32>(((_e109 - _e110) + 127i)) << bitcast<u32>(23i)));
                if (_e85 == 0u) {
                    phi_211_ = type_37(array<f32, 3>(_e102, _e103, _e104), _e85, _e106, _e107);
                } else {
                    phi_211_ = type_37(array<f32, 3>(((_e102 * _e115) * _e121), ((_e103 * _e115) * _e121), ((_e104 * _e115) * _e121)), _e85, ((_e106 * _e115) * _e121), _e107);
                }
                let _e134 = phi_211_;
                if _e66 {
                } else {
                    break;
                }
                let _e138 = global_6.member[_e65][1u];
                let _e139 = (_e138 < arrayLength((&global_7.member)));
                if _e139 {
                    if _e139 {
                    } else {
                        break;
                    }
                    let _e141 = global_7.member[_e138];
                    phi_260_ = _e141;
                } else {
                    phi_260_ = 4294967295u;
                }
                let _e143 = phi_260_;
                let _e144 = (_e143 < arrayLength((&global_8.member)));
                if _e144 {
                    if _e144 {
                    } else {
                        break;
                    }
                    let _e146 = global_8.member[_e143];
                    phi_274_ = _e146;
                } else {
                    phi_274_ = 0i;
                }
                let _e148 = phi_274_;
                let _e149 = (_e148 == 0i);
                if _e149 {
                    phi_632_ = true;
                } else {
                    let _e150 = (_e138 < arrayLength((&global_4.member)));
                    if _e150 {
                        if _e150 {
                        } else {
                            break;
                        }
                        let _e152 = global_4.member[_e138];
                        phi_292_ = _e152;
                    } else {
                        phi_292_ = array<u32, 3>(0u, 0u, 0u);
                    }
                    let _e154 = phi_292_;
                    let _e156 = (_e154[0] < _e48);
                    if _e156 {
                        if _e156 {
                        } else {
                            break;
                        }
                        let _e158 = global_3.member[_e154[0]];
                        phi_307_ = _e158;
                    } else {
                        phi_307_ = array<f32, 3>(0f, 0f, 0f);
                    }
                    let _e160 = phi_307_;
                    let _e165 = (_e154[1] < _e48);
                    if _e165 {
                        if _e165 {
                        } else {
                            break;
                        }
                        let _e167 = global_3.member[_e154[1]];
                        phi_325_ = _e167;
                    } else {
                        phi_325_ = array<f32, 3>(0f, 0f, 0f);
                    }
                    let _e169 = phi_325_;
                    let _e174 = (_e154[2] < _e48);
                    if _e174 {
                        if _e174 {
                        } else {
                            break;
                        }
                        let _e176 = global_3.member[_e154[2]];
                        phi_343_ = _e176;
                    } else {
                        phi_343_ = array<f32, 3>(0f, 0f, 0f);
                    }
                    let _e178 = phi_343_;
                    let _e183 = ((_e160[0] * _e115) * _e121);
                    let _e185 = select(_e183, 0f, (_e183 == 0f));
                    let _e187 = ((_e160[1] * _e115) * _e121);
                    let _e189 = select(_e187, 0f, (_e187 == 0f));
                    let _e191 = ((_e160[2] * _e115) * _e121);
                    let _e193 = select(_e191, 0f, (_e191 == 0f));
                    let _e195 = ((_e169[0] * _e115) * _e121);
                    let _e199 = ((_e169[1] * _e115) * _e121);
                    let _e203 = ((_e169[2] * _e115) * _e121);
                    let _e207 = ((_e178[0] * _e115) * _e121);
                    let _e211 = ((_e178[1] * _e115) * _e121);
                    let _e215 = ((_e178[2] * _e115) * _e121);
                    if _e149 {
                        phi_631_ = true;
                    } else {
                        let _e218 = (select(_e195, 0f, (_e195 == 0f)) - _e185);
                        let _e219 = (select(_e199, 0f, (_e199 == 0f)) - _e189);
                        let _e220 = (select(_e203, 0f, (_e203 == 0f)) - _e193);
                        let _e221 = (select(_e207, 0f, (_e207 == 0f)) - _e185);
                        let _e222 = (select(_e211, 0f, (_e211 == 0f)) - _e189);
                        let _e223 = (select(_e215, 0f, (_e215 == 0f)) - _e193);
                        if (_e134.member_1 == 1u) {
                            phi_438_ = vec3<f32>((_e134.member[0] - _e185), (_e134.member[1] - _e189), (_e134.member[2] - _e193));
                        } else {
                            phi_438_ = vec3<f32>(_e134.member[0], _e134.member[1], _e134.member[2]);
                        }
                        let _e240 = phi_438_;
                        let _e246 = bitcast<f32>((bitcast<u32>((_e218 * _e222)) ^ _e134.member_3[0]));
                        let _e250 = bitcast<f32>((bitcast<u32>((_e219 * _e221)) ^ _e134.member_3[0]));
                        let _e254 = bitcast<f32>((bitcast<u32>((_e219 * _e223)) ^ _e134.member_3[0]));
                        let _e258 = bitcast<f32>((bitcast<u32>((_e220 * _e222)) ^ _e134.member_3[0]));
                        let _e262 = bitcast<f32>((bitcast<u32>((_e220 * _e221)) ^ _e134.member_3[0]));
                        let _e266 = bitcast<f32>((bitcast<u32>((_e218 * _e223)) ^ _e134.member_3[0]));
                        let _e267 = (_e254 - _e258);
                        let _e268 = (_e262 - _e266);
                        let _e269 = (_e246 - _e250);
                        let _e293 = (bitcast<f32>((bitcast<u32>(_e254) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e258) & 2147483647u)));
                        let _e300 = (bitcast<f32>((bitcast<u32>(_e262) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e266) & 2147483647u)));
                        let _e307 = (bitcast<f32>((bitcast<u32>(_e246) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e250) & 2147483647u)));
                        let _e333 = bitcast<f32>((bitcast<u32>(_e267) & 2147483647u));
                        let _e336 = bitcast<f32>((bitcast<u32>(_e268) & 2147483647u));
                        let _e339 = bitcast<f32>((bitcast<u32>(_e269) & 2147483647u));
                        let _e341 = select(_e339, _e336, (_e336 > _e339));
                        let _e345 = select(_e339, _e336, (_e336 < _e339));
                        let _e349 = select(_e336, _e333, (_e333 < _e336));
                        let _e351 = select(_e336, _e333, (_e333 > _e336));
                        let _e353 = select(_e339, _e351, (_e351 < _e339));
                        phi_631_ = !(((((bitcast<f32>((bitcast<u32>((_e240.x * _e267)) ^ _e134.member_3[0])) + bitcast<f32>((bitcast<u32>((_e240.y * _e268)) ^ _e134.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e240.z * _e269)) ^ _e134.member_3[0]))) * f32(-(_e148))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e240.x) & 2147483647u)) * _e293)) ^ _e134.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e240.y) & 2147483647u)) * _e300)) ^ _e134.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e240.z) & 2147483647u)) * _e307)) ^ _e134.member_3[0]))))) ^ _e134.member_3[0])) + bitcast<f32>((bitcast<u32>((_e134.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e341, _e333, (_e333 > _e341)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e353, _e349, (_e349 > _e353)))) ^ _e134.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e345, _e333, (_e333 < _e345)))) ^ _e134.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e293 + _e300) + _e307))) ^ _e134.member_3[0]))) * 1.0000005f)) ^ _e134.member_3[0])))) ^ _e134.member_3[0]))) + 0.0000000000000000000000000000000000001880791f)));
                    }
                    let _e394 = phi_631_;
                    phi_632_ = _e394;
                }
                let _e396 = phi_632_;
                phi_634_ = select(0u, 1u, _e396);
            } else {
                phi_634_ = 0u;
            }
            let _e399 = phi_634_;
            let _e400 = (_e43 % 64u);
            if (_e400 < 64u) {
            } else {
                break;
            }
            global_11[_e400] = _e399;
            workgroupBarrier();
            let _e403 = (_e65 / 32u);
            if ((_e43 & 31u) == 0u) {
                let _e406 = (_e403 < arrayLength((&global_9.member)));
                if _e406 {
                    let _e407 = (_e403 < arrayLength((&global_10.member)));
                    if _e407 {
                        phi_662_ = type_11(0u, 32u);
                        phi_665_ = 0u;
                        loop {
                            let _e409 = phi_662_;
                            let _e411 = phi_665_;
                            local = _e411;
                            local_1 = _e411;
                            if (_e409.member < _e409.member_1) {
                                phi_663_ = type_11((_e409.member + 1u), _e409.member_1);
                                phi_688_ = type_11(1u, _e409.member);
                            } else {
                                phi_663_ = _e409;
                                phi_688_ = type_11(0u, type_11().member_1);
                            }
                            let _e424 = phi_663_;
                            let _e426 = phi_688_;
                            let _e430 = (bitcast<i32>(_e426.member) != 0i);
                            if _e430 {
                                let _e432 = ((_e43 + _e426.member_1) % 64u);
                                if (_e432 < 64u) {
                                } else {
                                    phi_727_ = true;
                                    break;
                                }
                                let _e435 = global_11[_e432];
                                phi_666_ = (_e411 | (_e435 << bitcast<u32>((_e426.member_1 & 31u))));
                            } else {
                                phi_666_ = u32();
                            }
                            let _e441 = phi_666_;
                            continue;
                            continuing {
                                phi_662_ = _e424;
                                phi_665_ = _e441;
                                phi_727_ = false;
                                break if !(_e430);
                            }
                        }
                        let _e444 = phi_727_;
                        if _e444 {
                            break;
                        }
                        if _e406 {
                        } else {
                            break;
                        }
                        let _e448 = local;
                        global_9.member[_e403] = _e448;
                        let _e450 = local_1;
                        if _e407 {
                        } else {
                            break;
                        }
                        global_10.member[_e403] = countOneBits(_e450);
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn classify_30_(@builtin(global_invocation_id) param: vec3<u32>, @builtin(local_invocation_index) param_1: u32) {
    global_1 = param;
    global = param_1;
    function_();
}
