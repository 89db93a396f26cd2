struct type_7 {
    member: vec4<u32>,
}

struct type_12 {
    member: array<array<f32, 3>>,
}

struct type_16 {
    member: array<array<u32, 3>>,
}

struct type_24 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_26 {
    member: array<type_24>,
}

struct type_28 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_29 {
    member: type_28,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_31 {
    member: array<type_29>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_7;
@group(0) @binding(1) 
var<storage> global_2: type_12;
@group(0) @binding(2) 
var<storage> global_3: type_16;
@group(0) @binding(3) 
var<storage> global_4: type_12;
@group(0) @binding(4) 
var<storage> global_5: type_26;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_31;

fn function_() {
    var phi_181_: array<u32, 3>;
    var phi_196_: array<f32, 3>;
    var phi_214_: array<f32, 3>;
    var phi_232_: array<f32, 3>;
    var phi_315_: array<u32, 3>;
    var phi_332_: vec3<f32>;
    var phi_349_: vec3<f32>;
    var phi_366_: vec3<f32>;
    var phi_443_: i32;
    var phi_474_: i32;
    var phi_493_: vec3<f32>;
    var phi_576_: i32;
    var phi_607_: i32;
    var phi_626_: vec3<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e29 = global;
            let _e32 = arrayLength((&global_2.member));
            let _e37 = arrayLength((&global_4.member));
            let _e45 = (_e29.x + (_e29.y * 2097152u));
            let _e46 = (_e45 < arrayLength((&global_6.member)));
            if _e46 {
                let _e47 = (_e45 < arrayLength((&global_5.member)));
                if _e47 {
                    if _e47 {
                    } else {
                        break;
                    }
                    let _e53 = global_5.member[_e45].member_3;
                    if (_e53 != 4294967295u) {
                        if _e46 {
                        } else {
                            break;
                        }
                        let _e57 = global_6.member[_e45];
                        if _e47 {
                        } else {
                            break;
                        }
                        let _e58 = global_5.member[_e45];
                        let _e61 = global_1.member[0u];
                        let _e62 = bitcast<i32>(_e61);
                        let _e63 = (_e62 / 2i);
                        let _e68 = bitcast<f32>((bitcast<u32>((_e63 + 127i)) << bitcast<u32>(23i)));
                        let _e74 = bitcast<f32>((bitcast<u32>(((_e62 - _e63) + 127i)) << bitcast<u32>(23i)));
                        let _e76 = (_e58.member_3 < arrayLength((&global_3.member)));
                        if _e76 {
                            if _e76 {
                            } else {
                                break;
                            }
                            let _e78 = global_3.member[_e58.member_3];
                            phi_181_ = _e78;
                        } else {
                            phi_181_ = array<u32, 3>(0u, 0u, 0u);
                        }
                        let _e80 = phi_181_;
                        let _e82 = (_e80[0] < _e32);
                        if _e82 {
                            if _e82 {
                            } else {
                                break;
                            }
                            let _e84 = global_2.member[_e80[0]];
                            phi_196_ = _e84;
                        } else {
                            phi_196_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e86 = phi_196_;
                        let _e91 = (_e80[1] < _e32);
                        if _e91 {
                            if _e91 {
                            } else {
                                break;
                            }
                            let _e93 = global_2.member[_e80[1]];
                            phi_214_ = _e93;
                        } else {
                            phi_214_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e95 = phi_214_;
                        let _e100 = (_e80[2] < _e32);
                        if _e100 {
                            if _e100 {
                            } else {
                                break;
                            }
                            let _e102 = global_2.member[_e80[2]];
                            phi_232_ = _e102;
                        } else {
                            phi_232_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e104 = phi_232_;
                        let _e109 = ((_e86[0] * _e68) * _e74);
                        let _e111 = select(_e109, 0f, (_e109 == 0f));
                        let _e113 = ((_e86[1] * _e68) * _e74);
                        let _e115 = select(_e113, 0f, (_e113 == 0f));
                        let _e117 = ((_e86[2] * _e68) * _e74);
                        let _e119 = select(_e117, 0f, (_e117 == 0f));
                        let _e121 = ((_e95[0] * _e68) * _e74);
                        let _e125 = ((_e95[1] * _e68) * _e74);
                        let _e129 = ((_e95[2] * _e68) * _e74);
                        let _e133 = ((_e104[0] * _e68) * _e74);
                        let _e137 = ((_e104[1] * _e68) * _e74);
                        let _e141 = ((_e104[2] * _e68) * _e74);
                        if _e76 {
                            if _e76 {
                            } else {
                                break;
                            }
                            let _e145 = global_3.member[_e58.member_3];
                            phi_315_ = _e145;
                        } else {
                            phi_315_ = array<u32, 3>(0u, 0u, 0u);
                        }
                        let _e147 = phi_315_;
                        let _e149 = (_e147[0] < _e37);
                        if _e149 {
                            if _e149 {
                            } else {
                                break;
                            }
                            let _e152 = global_4.member[_e147[0]];
                            phi_332_ = vec3<f32>(_e152[0], _e152[1], _e152[2]);
                        } else {
                            phi_332_ = vec3<f32>(0f, 0f, 0f);
                        }
                        let _e158 = phi_332_;
                        let _e160 = (_e147[1] < _e37);
                        if _e160 {
                            if _e160 {
                            } else {
                                break;
                            }
                            let _e163 = global_4.member[_e147[1]];
                            phi_349_ = vec3<f32>(_e163[0], _e163[1], _e163[2]);
                        } else {
                            phi_349_ = vec3<f32>(0f, 0f, 0f);
                        }
                        let _e169 = phi_349_;
                        let _e171 = (_e147[2] < _e37);
                        if _e171 {
                            if _e171 {
                            } else {
                                break;
                            }
                            let _e174 = global_4.member[_e147[2]];
                            phi_366_ = vec3<f32>(_e174[0], _e174[1], _e174[2]);
                        } else {
                            phi_366_ = vec3<f32>(0f, 0f, 0f);
                        }
                        let _e180 = phi_366_;
                        let _e189 = ((1f - _e58.member_1) - _e58.member_2);
                        let _e191 = select(0f, _e189, (_e189 > 0f));
                        let _e193 = select(1f, _e58.member_1, (_e58.member_1 < 1f));
                        let _e195 = select(1f, _e58.member_2, (_e58.member_2 < 1f));
                        let _e196 = (select(_e121, 0f, (_e121 == 0f)) - _e111);
                        let _e197 = (select(_e125, 0f, (_e125 == 0f)) - _e115);
                        let _e198 = (select(_e129, 0f, (_e129 == 0f)) - _e119);
                        let _e199 = (select(_e133, 0f, (_e133 == 0f)) - _e111);
                        let _e200 = (select(_e137, 0f, (_e137 == 0f)) - _e115);
                        let _e201 = (select(_e141, 0f, (_e141 == 0f)) - _e119);
                        let _e204 = ((_e197 * _e201) - (_e200 * _e198));
                        let _e207 = ((_e198 * _e199) - (_e201 * _e196));
                        let _e210 = ((_e196 * _e200) - (_e199 * _e197));
                        let _e213 = bitcast<f32>((bitcast<u32>(_e204) & 2147483647u));
                        let _e216 = bitcast<f32>((bitcast<u32>(_e207) & 2147483647u));
                        let _e218 = select(_e216, _e213, (_e213 > _e216));
                        let _e221 = bitcast<f32>((bitcast<u32>(_e210) & 2147483647u));
                        let _e223 = select(_e221, _e218, (_e218 > _e221));
                        if (_e223 < 0.000000000000000000000000000000000000011754944f) {
                            phi_493_ = vec3<f32>(0f, 0f, 0f);
                        } else {
                            let _e226 = (bitcast<u32>(_e223) & 2147483647u);
                            let _e227 = (_e226 >= 8388608u);
                            if _e227 {
                                phi_443_ = (bitcast<i32>((_e226 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_443_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e226)), 32u, (_e226 == 0u))));
                            }
                            let _e240 = phi_443_;
                            let _e247 = bitcast<f32>((bitcast<u32>(((_e240 / -2i) + 127i)) << bitcast<u32>(23i)));
                            if _e227 {
                                phi_474_ = (bitcast<i32>((_e226 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_474_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e226)), 32u, (_e226 == 0u))));
                            }
                            let _e263 = phi_474_;
                            let _e269 = bitcast<f32>((bitcast<u32>((((_e240 / 2i) - _e263) + 127i)) << bitcast<u32>(23i)));
                            let _e270 = ((_e204 * _e247) * _e269);
                            let _e271 = ((_e207 * _e247) * _e269);
                            let _e272 = ((_e210 * _e247) * _e269);
                            let _e278 = sqrt((((_e270 * _e270) + (_e271 * _e271)) + (_e272 * _e272)));
                            phi_493_ = vec3<f32>((_e270 / _e278), (_e271 / _e278), (_e272 / _e278));
                        }
                        let _e284 = phi_493_;
                        let _e294 = select(1f, -1f, ((((_e284.x * _e57.member.member_2[0]) + (_e284.y * _e57.member.member_2[1])) + (_e284.z * _e57.member.member_2[2])) > 0f));
                        let _e320 = (((_e158.x * _e191) + (_e169.x * _e193)) + (_e180.x * _e195));
                        let _e321 = (((_e158.y * _e191) + (_e169.y * _e193)) + (_e180.y * _e195));
                        let _e322 = (((_e158.z * _e191) + (_e169.z * _e193)) + (_e180.z * _e195));
                        let _e325 = bitcast<f32>((bitcast<u32>(_e320) & 2147483647u));
                        let _e328 = bitcast<f32>((bitcast<u32>(_e321) & 2147483647u));
                        let _e330 = select(_e328, _e325, (_e325 > _e328));
                        let _e333 = bitcast<f32>((bitcast<u32>(_e322) & 2147483647u));
                        let _e335 = select(_e333, _e330, (_e330 > _e333));
                        if (_e335 < 0.000000000000000000000000000000000000011754944f) {
                            phi_626_ = vec3<f32>(0f, 0f, 0f);
                        } else {
                            let _e338 = (bitcast<u32>(_e335) & 2147483647u);
                            let _e339 = (_e338 >= 8388608u);
                            if _e339 {
                                phi_576_ = (bitcast<i32>((_e338 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_576_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e338)), 32u, (_e338 == 0u))));
                            }
                            let _e352 = phi_576_;
                            let _e359 = bitcast<f32>((bitcast<u32>(((_e352 / -2i) + 127i)) << bitcast<u32>(23i)));
                            if _e339 {
                                phi_607_ = (bitcast<i32>((_e338 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_607_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e338)), 32u, (_e338 == 0u))));
                            }
                            let _e375 = phi_607_;
                            let _e381 = bitcast<f32>((bitcast<u32>((((_e352 / 2i) - _e375) + 127i)) << bitcast<u32>(23i)));
                            let _e382 = ((_e320 * _e359) * _e381);
                            let _e383 = ((_e321 * _e359) * _e381);
                            let _e384 = ((_e322 * _e359) * _e381);
                            let _e390 = sqrt((((_e382 * _e382) + (_e383 * _e383)) + (_e384 * _e384)));
                            phi_626_ = vec3<f32>((_e382 / _e390), (_e383 / _e390), (_e384 / _e390));
                        }
                        let _e396 = phi_626_;
                        let _e411 = select((_e284 * _e294), (_e396 * _e294), vec3((((((_e396.x * _e294) * (_e284.x * _e294)) + ((_e396.y * _e294) * (_e284.y * _e294))) + ((_e396.z * _e294) * (_e284.z * _e294))) > 0f)));
                        if _e46 {
                        } else {
                            break;
                        }
                        global_6.member[_e45] = type_29(_e57.member, _e57.member_1, _e57.member_2, array<f32, 3>((_e57.member_3[0] + (((_e411.x * 0.5f) + 0.5f) * _e57.member_1[0])), (_e57.member_3[1] + (((_e411.y * 0.5f) + 0.5f) * _e57.member_1[1])), (_e57.member_3[2] + (((_e411.z * 0.5f) + 0.5f) * _e57.member_1[2]))), _e57.member_4);
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn view_normals(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
