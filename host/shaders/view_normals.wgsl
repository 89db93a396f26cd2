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
    var phi_161_: i32;
    var phi_185_: array<u32, 3>;
    var phi_200_: array<f32, 3>;
    var phi_218_: array<f32, 3>;
    var phi_236_: array<f32, 3>;
    var phi_319_: array<u32, 3>;
    var phi_336_: vec3<f32>;
    var phi_353_: vec3<f32>;
    var phi_370_: vec3<f32>;
    var phi_447_: i32;
    var phi_478_: i32;
    var phi_497_: vec3<f32>;
    var phi_580_: i32;
    var phi_611_: i32;
    var phi_630_: vec3<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e30 = global;
            let _e33 = arrayLength((&global_2.member));
            let _e38 = arrayLength((&global_4.member));
            let _e46 = (_e30.x + (_e30.y * 2097152u));
            let _e47 = (_e46 < arrayLength((&global_6.member)));
            if _e47 {
                let _e48 = (_e46 < arrayLength((&global_5.member)));
                if _e48 {
                    if _e48 {
                    } else {
                        break;
                    }
                    let _e54 = global_5.member[_e46].member_3;
                    if (_e54 != 4294967295u) {
                        if _e47 {
                        } else {
                            break;
                        }
                        let _e58 = global_6.member[_e46];
                        if _e48 {
                        } else {
                            break;
                        }
                        let _e59 = global_5.member[_e46];
                        let _e62 = global_1.member[0u];
                        let _e63 = bitcast<i32>(_e62);
                        if (_e63 < -126i) {
                            phi_161_ = -126i;
                        } else {
                            phi_161_ = select(_e63, 127i, (_e63 > 127i));
                        }
                        let _e68 = phi_161_;
                        let _e73 = bitcast<f32>((bitcast<u32>((_e68 + 127i)) << bitcast<u32>(23i)));
                        let _e79 = bitcast<f32>((bitcast<u32>(((_e63 - _e68) + 127i)) << bitcast<u32>(23i)));
                        let _e81 = (_e59.member_3 < arrayLength((&global_3.member)));
                        if _e81 {
                            if _e81 {
                            } else {
                                break;
                            }
                            let _e83 = global_3.member[_e59.member_3];
                            phi_185_ = _e83;
                        } else {
                            phi_185_ = array<u32, 3>(0u, 0u, 0u);
                        }
                        let _e85 = phi_185_;
                        let _e87 = (_e85[0] < _e33);
                        if _e87 {
                            if _e87 {
                            } else {
                                break;
                            }
                            let _e89 = global_2.member[_e85[0]];
                            phi_200_ = _e89;
                        } else {
                            phi_200_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e91 = phi_200_;
                        let _e96 = (_e85[1] < _e33);
                        if _e96 {
                            if _e96 {
                            } else {
                                break;
                            }
                            let _e98 = global_2.member[_e85[1]];
                            phi_218_ = _e98;
                        } else {
                            phi_218_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e100 = phi_218_;
                        let _e105 = (_e85[2] < _e33);
                        if _e105 {
                            if _e105 {
                            } else {
                                break;
                            }
                            let _e107 = global_2.member[_e85[2]];
                            phi_236_ = _e107;
                        } else {
                            phi_236_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e109 = phi_236_;
                        let _e114 = ((_e91[0] * _e73) * _e79);
                        let _e116 = select(_e114, 0f, (_e114 == 0f));
                        let _e118 = ((_e91[1] * _e73) * _e79);
                        let _e120 = select(_e118, 0f, (_e118 == 0f));
                        let _e122 = ((_e91[2] * _e73) * _e79);
                        let _e124 = select(_e122, 0f, (_e122 == 0f));
                        let _e126 = ((_e100[0] * _e73) * _e79);
                        let _e130 = ((_e100[1] * _e73) * _e79);
                        let _e134 = ((_e100[2] * _e73) * _e79);
                        let _e138 = ((_e109[0] * _e73) * _e79);
                        let _e142 = ((_e109[1] * _e73) * _e79);
                        let _e146 = ((_e109[2] * _e73) * _e79);
                        if _e81 {
                            if _e81 {
                            } else {
                                break;
                            }
                            let _e150 = global_3.member[_e59.member_3];
                            phi_319_ = _e150;
                        } else {
                            phi_319_ = array<u32, 3>(0u, 0u, 0u);
                        }
                        let _e152 = phi_319_;
                        let _e154 = (_e152[0] < _e38);
                        if _e154 {
                            if _e154 {
                            } else {
                                break;
                            }
                            let _e157 = global_4.member[_e152[0]];
                            phi_336_ = vec3<f32>(_e157[0], _e157[1], _e157[2]);
                        } else {
                            phi_336_ = vec3<f32>(0f, 0f, 0f);
                        }
                        let _e163 = phi_336_;
                        let _e165 = (_e152[1] < _e38);
                        if _e165 {
                            if _e165 {
                            } else {
                                break;
                            }
                            let _e168 = global_4.member[_e152[1]];
                            phi_353_ = vec3<f32>(_e168[0], _e168[1], _e168[2]);
                        } else {
                            phi_353_ = vec3<f32>(0f, 0f, 0f);
                        }
                        let _e174 = phi_353_;
                        let _e176 = (_e152[2] < _e38);
                        if _e176 {
                            if _e176 {
                            } else {
                                break;
                            }
                            let _e179 = global_4.member[_e152[2]];
                            phi_370_ = vec3<f32>(_e179[0], _e179[1], _e179[2]);
                        } else {
                            phi_370_ = vec3<f32>(0f, 0f, 0f);
                        }
                        let _e185 = phi_370_;
                        let _e194 = ((1f - _e59.member_1) - _e59.member_2);
                        let _e196 = select(0f, _e194, (_e194 > 0f));
                        let _e198 = select(1f, _e59.member_1, (_e59.member_1 < 1f));
                        let _e200 = select(1f, _e59.member_2, (_e59.member_2 < 1f));
                        let _e201 = (select(_e126, 0f, (_e126 == 0f)) - _e116);
                        let _e202 = (select(_e130, 0f, (_e130 == 0f)) - _e120);
                        let _e203 = (select(_e134, 0f, (_e134 == 0f)) - _e124);
                        let _e204 = (select(_e138, 0f, (_e138 == 0f)) - _e116);
                        let _e205 = (select(_e142, 0f, (_e142 == 0f)) - _e120);
                        let _e206 = (select(_e146, 0f, (_e146 == 0f)) - _e124);
                        let _e209 = ((_e202 * _e206) - (_e205 * _e203));
                        let _e212 = ((_e203 * _e204) - (_e206 * _e201));
                        let _e215 = ((_e201 * _e205) - (_e204 * _e202));
                        let _e218 = bitcast<f32>((bitcast<u32>(_e209) & 2147483647u));
                        let _e221 = bitcast<f32>((bitcast<u32>(_e212) & 2147483647u));
                        let _e223 = select(_e221, _e218, (_e218 > _e221));
                        let _e226 = bitcast<f32>((bitcast<u32>(_e215) & 2147483647u));
                        let _e228 = select(_e226, _e223, (_e223 > _e226));
                        if (_e228 < 0.000000000000000000000000000000000000011754944f) {
                            phi_497_ = vec3<f32>(0f, 0f, 0f);
                        } else {
                            let _e231 = (bitcast<u32>(_e228) & 2147483647u);
                            let _e232 = (_e231 >= 8388608u);
                            if _e232 {
                                phi_447_ = (bitcast<i32>((_e231 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_447_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e231)), 32u, (_e231 == 0u))));
                            }
                            let _e245 = phi_447_;
                            let _e252 = bitcast<f32>((bitcast<u32>(((_e245 / -2i) + 127i)) << bitcast<u32>(23i)));
                            if _e232 {
                                phi_478_ = (bitcast<i32>((_e231 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_478_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e231)), 32u, (_e231 == 0u))));
                            }
                            let _e268 = phi_478_;
                            let _e274 = bitcast<f32>((bitcast<u32>((((_e245 / 2i) - _e268) + 127i)) << bitcast<u32>(23i)));
                            let _e275 = ((_e209 * _e252) * _e274);
                            let _e276 = ((_e212 * _e252) * _e274);
                            let _e277 = ((_e215 * _e252) * _e274);
                            let _e283 = sqrt((((_e275 * _e275) + (_e276 * _e276)) + (_e277 * _e277)));
                            phi_497_ = vec3<f32>((_e275 / _e283), (_e276 / _e283), (_e277 / _e283));
                        }
                        let _e289 = phi_497_;
                        let _e299 = select(1f, -1f, ((((_e289.x * _e58.member.member_2[0]) + (_e289.y * _e58.member.member_2[1])) + (_e289.z * _e58.member.member_2[2])) > 0f));
                        let _e325 = (((_e163.x * _e196) + (_e174.x * _e198)) + (_e185.x * _e200));
                        let _e326 = (((_e163.y * _e196) + (_e174.y * _e198)) + (_e185.y * _e200));
                        let _e327 = (((_e163.z * _e196) + (_e174.z * _e198)) + (_e185.z * _e200));
                        let _e330 = bitcast<f32>((bitcast<u32>(_e325) & 2147483647u));
                        let _e333 = bitcast<f32>((bitcast<u32>(_e326) & 2147483647u));
                        let _e335 = select(_e333, _e330, (_e330 > _e333));
                        let _e338 = bitcast<f32>((bitcast<u32>(_e327) & 2147483647u));
                        let _e340 = select(_e338, _e335, (_e335 > _e338));
                        if (_e340 < 0.000000000000000000000000000000000000011754944f) {
                            phi_630_ = vec3<f32>(0f, 0f, 0f);
                        } else {
                            let _e343 = (bitcast<u32>(_e340) & 2147483647u);
                            let _e344 = (_e343 >= 8388608u);
                            if _e344 {
                                phi_580_ = (bitcast<i32>((_e343 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_580_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e343)), 32u, (_e343 == 0u))));
                            }
                            let _e357 = phi_580_;
                            let _e364 = bitcast<f32>((bitcast<u32>(((_e357 / -2i) + 127i)) << bitcast<u32>(23i)));
                            if _e344 {
                                phi_611_ = (bitcast<i32>((_e343 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_611_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e343)), 32u, (_e343 == 0u))));
                            }
                            let _e380 = phi_611_;
                            let _e386 = bitcast<f32>((bitcast<u32>((((_e357 / 2i) - _e380) + 127i)) << bitcast<u32>(23i)));
                            let _e387 = ((_e325 * _e364) * _e386);
                            let _e388 = ((_e326 * _e364) * _e386);
                            let _e389 = ((_e327 * _e364) * _e386);
                            let _e395 = sqrt((((_e387 * _e387) + (_e388 * _e388)) + (_e389 * _e389)));
                            phi_630_ = vec3<f32>((_e387 / _e395), (_e388 / _e395), (_e389 / _e395));
                        }
                        let _e401 = phi_630_;
                        let _e416 = select((_e289 * _e299), (_e401 * _e299), vec3((((((_e401.x * _e299) * (_e289.x * _e299)) + ((_e401.y * _e299) * (_e289.y * _e299))) + ((_e401.z * _e299) * (_e289.z * _e299))) > 0f)));
                        if _e47 {
                        } else {
                            break;
                        }
                        global_6.member[_e46] = type_29(_e58.member, _e58.member_1, _e58.member_2, array<f32, 3>((_e58.member_3[0] + (((_e416.x * 0.5f) + 0.5f) * _e58.member_1[0])), (_e58.member_3[1] + (((_e416.y * 0.5f) + 0.5f) * _e58.member_1[1])), (_e58.member_3[2] + (((_e416.z * 0.5f) + 0.5f) * _e58.member_1[2]))), _e58.member_4);
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
