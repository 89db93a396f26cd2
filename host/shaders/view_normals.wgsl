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
    var phi_167_: i32;
    var phi_191_: array<u32, 3>;
    var phi_206_: array<f32, 3>;
    var phi_224_: array<f32, 3>;
    var phi_242_: array<f32, 3>;
    var phi_613_: array<u32, 3>;
    var phi_630_: vec3<f32>;
    var phi_647_: vec3<f32>;
    var phi_664_: vec3<f32>;
    var phi_741_: i32;
    var phi_772_: i32;
    var phi_791_: vec3<f32>;
    var phi_874_: i32;
    var phi_905_: i32;
    var phi_924_: vec3<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e36 = global;
            let _e39 = arrayLength((&global_2.member));
            let _e44 = arrayLength((&global_4.member));
            let _e52 = (_e36.x + (_e36.y * 2097152u));
            let _e53 = (_e52 < arrayLength((&global_6.member)));
            if _e53 {
                let _e54 = (_e52 < arrayLength((&global_5.member)));
                if _e54 {
                    if _e54 {
                    } else {
                        break;
                    }
                    let _e60 = global_5.member[_e52].member_3;
                    if (_e60 != 4294967295u) {
                        if _e53 {
                        } else {
                            break;
                        }
                        let _e64 = global_6.member[_e52];
                        if _e54 {
                        } else {
                            break;
                        }
                        let _e65 = global_5.member[_e52];
                        let _e68 = global_1.member[0u];
                        let _e69 = bitcast<i32>(_e68);
                        if (_e69 < -126i) {
                            phi_167_ = -126i;
                        } else {
                            phi_167_ = select(_e69, 127i, (_e69 > 127i));
                        }
                        let _e74 = phi_167_;
                        let _e79 = bitcast<f32>((bitcast<u32>((_e74 + 127i)) << bitcast<u32>(23i)));
                        let _e85 = bitcast<f32>((bitcast<u32>(((_e69 - _e74) + 127i)) << bitcast<u32>(23i)));
                        let _e87 = (_e65.member_3 < arrayLength((&global_3.member)));
                        if _e87 {
                            if _e87 {
                            } else {
                                break;
                            }
                            let _e89 = global_3.member[_e65.member_3];
                            phi_191_ = _e89;
                        } else {
                            phi_191_ = array<u32, 3>(0u, 0u, 0u);
                        }
                        let _e91 = phi_191_;
                        let _e93 = (_e91[0] < _e39);
                        if _e93 {
                            if _e93 {
                            } else {
                                break;
                            }
                            let _e95 = global_2.member[_e91[0]];
                            phi_206_ = _e95;
                        } else {
                            phi_206_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e97 = phi_206_;
                        let _e102 = (_e91[1] < _e39);
                        if _e102 {
                            if _e102 {
                            } else {
                                break;
                            }
                            let _e104 = global_2.member[_e91[1]];
                            phi_224_ = _e104;
                        } else {
                            phi_224_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e106 = phi_224_;
                        let _e111 = (_e91[2] < _e39);
                        if _e111 {
                            if _e111 {
                            } else {
                                break;
                            }
                            let _e113 = global_2.member[_e91[2]];
                            phi_242_ = _e113;
                        } else {
                            phi_242_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e115 = phi_242_;
                        let _e119 = bitcast<u32>(_e97[0]);
                        let _e121 = ((_e119 & 2139095040u) != 0u);
                        let _e135 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e119 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e119 & 2147483648u))), _e97[0], _e121) * _e79) * select(0.00000011920929f, 1f, _e121)) * _e85);
                        let _e140 = select(_e135, 0f, (bitcast<f32>((bitcast<u32>(_e135) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
                        let _e141 = bitcast<u32>(_e97[1]);
                        let _e143 = ((_e141 & 2139095040u) != 0u);
                        let _e157 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e141 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e141 & 2147483648u))), _e97[1], _e143) * _e79) * select(0.00000011920929f, 1f, _e143)) * _e85);
                        let _e162 = select(_e157, 0f, (bitcast<f32>((bitcast<u32>(_e157) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
                        let _e163 = bitcast<u32>(_e97[2]);
                        let _e165 = ((_e163 & 2139095040u) != 0u);
                        let _e179 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e163 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e163 & 2147483648u))), _e97[2], _e165) * _e79) * select(0.00000011920929f, 1f, _e165)) * _e85);
                        let _e184 = select(_e179, 0f, (bitcast<f32>((bitcast<u32>(_e179) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
                        let _e185 = bitcast<u32>(_e106[0]);
                        let _e187 = ((_e185 & 2139095040u) != 0u);
                        let _e201 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e185 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e185 & 2147483648u))), _e106[0], _e187) * _e79) * select(0.00000011920929f, 1f, _e187)) * _e85);
                        let _e207 = bitcast<u32>(_e106[1]);
                        let _e209 = ((_e207 & 2139095040u) != 0u);
                        let _e223 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e207 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e207 & 2147483648u))), _e106[1], _e209) * _e79) * select(0.00000011920929f, 1f, _e209)) * _e85);
                        let _e229 = bitcast<u32>(_e106[2]);
                        let _e231 = ((_e229 & 2139095040u) != 0u);
                        let _e245 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e229 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e229 & 2147483648u))), _e106[2], _e231) * _e79) * select(0.00000011920929f, 1f, _e231)) * _e85);
                        let _e251 = bitcast<u32>(_e115[0]);
                        let _e253 = ((_e251 & 2139095040u) != 0u);
                        let _e267 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e251 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e251 & 2147483648u))), _e115[0], _e253) * _e79) * select(0.00000011920929f, 1f, _e253)) * _e85);
                        let _e273 = bitcast<u32>(_e115[1]);
                        let _e275 = ((_e273 & 2139095040u) != 0u);
                        let _e289 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e273 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e273 & 2147483648u))), _e115[1], _e275) * _e79) * select(0.00000011920929f, 1f, _e275)) * _e85);
                        let _e295 = bitcast<u32>(_e115[2]);
                        let _e297 = ((_e295 & 2139095040u) != 0u);
                        let _e311 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e295 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e295 & 2147483648u))), _e115[2], _e297) * _e79) * select(0.00000011920929f, 1f, _e297)) * _e85);
                        if _e87 {
                            if _e87 {
                            } else {
                                break;
                            }
                            let _e318 = global_3.member[_e65.member_3];
                            phi_613_ = _e318;
                        } else {
                            phi_613_ = array<u32, 3>(0u, 0u, 0u);
                        }
                        let _e320 = phi_613_;
                        let _e322 = (_e320[0] < _e44);
                        if _e322 {
                            if _e322 {
                            } else {
                                break;
                            }
                            let _e325 = global_4.member[_e320[0]];
                            phi_630_ = vec3<f32>(_e325[0], _e325[1], _e325[2]);
                        } else {
                            phi_630_ = vec3<f32>(0f, 0f, 0f);
                        }
                        let _e331 = phi_630_;
                        let _e333 = (_e320[1] < _e44);
                        if _e333 {
                            if _e333 {
                            } else {
                                break;
                            }
                            let _e336 = global_4.member[_e320[1]];
                            phi_647_ = vec3<f32>(_e336[0], _e336[1], _e336[2]);
                        } else {
                            phi_647_ = vec3<f32>(0f, 0f, 0f);
                        }
                        let _e342 = phi_647_;
                        let _e344 = (_e320[2] < _e44);
                        if _e344 {
                            if _e344 {
                            } else {
                                break;
                            }
                            let _e347 = global_4.member[_e320[2]];
                            phi_664_ = vec3<f32>(_e347[0], _e347[1], _e347[2]);
                        } else {
                            phi_664_ = vec3<f32>(0f, 0f, 0f);
                        }
                        let _e353 = phi_664_;
                        let _e362 = ((1f - _e65.member_1) - _e65.member_2);
                        let _e364 = select(0f, _e362, (_e362 > 0f));
                        let _e366 = select(1f, _e65.member_1, (_e65.member_1 < 1f));
                        let _e368 = select(1f, _e65.member_2, (_e65.member_2 < 1f));
                        let _e369 = (select(_e201, 0f, (bitcast<f32>((bitcast<u32>(_e201) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f)) - _e140);
                        let _e370 = (select(_e223, 0f, (bitcast<f32>((bitcast<u32>(_e223) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f)) - _e162);
                        let _e371 = (select(_e245, 0f, (bitcast<f32>((bitcast<u32>(_e245) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f)) - _e184);
                        let _e372 = (select(_e267, 0f, (bitcast<f32>((bitcast<u32>(_e267) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f)) - _e140);
                        let _e373 = (select(_e289, 0f, (bitcast<f32>((bitcast<u32>(_e289) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f)) - _e162);
                        let _e374 = (select(_e311, 0f, (bitcast<f32>((bitcast<u32>(_e311) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f)) - _e184);
                        let _e377 = ((_e370 * _e374) - (_e373 * _e371));
                        let _e380 = ((_e371 * _e372) - (_e374 * _e369));
                        let _e383 = ((_e369 * _e373) - (_e372 * _e370));
                        let _e386 = bitcast<f32>((bitcast<u32>(_e377) & 2147483647u));
                        let _e389 = bitcast<f32>((bitcast<u32>(_e380) & 2147483647u));
                        let _e391 = select(_e389, _e386, (_e386 > _e389));
                        let _e394 = bitcast<f32>((bitcast<u32>(_e383) & 2147483647u));
                        let _e396 = select(_e394, _e391, (_e391 > _e394));
                        if (_e396 < 0.000000000000000000000000000000000000011754944f) {
                            phi_791_ = vec3<f32>(0f, 0f, 0f);
                        } else {
                            let _e399 = (bitcast<u32>(_e396) & 2147483647u);
                            let _e400 = (_e399 >= 8388608u);
                            if _e400 {
                                phi_741_ = (bitcast<i32>((_e399 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_741_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e399)), 32u, (_e399 == 0u))));
                            }
                            let _e413 = phi_741_;
                            let _e420 = bitcast<f32>((bitcast<u32>(((_e413 / -2i) + 127i)) << bitcast<u32>(23i)));
                            if _e400 {
                                phi_772_ = (bitcast<i32>((_e399 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_772_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e399)), 32u, (_e399 == 0u))));
                            }
                            let _e436 = phi_772_;
                            let _e442 = bitcast<f32>((bitcast<u32>((((_e413 / 2i) - _e436) + 127i)) << bitcast<u32>(23i)));
                            let _e443 = ((_e377 * _e420) * _e442);
                            let _e444 = ((_e380 * _e420) * _e442);
                            let _e445 = ((_e383 * _e420) * _e442);
                            let _e451 = sqrt((((_e443 * _e443) + (_e444 * _e444)) + (_e445 * _e445)));
                            phi_791_ = vec3<f32>((_e443 / _e451), (_e444 / _e451), (_e445 / _e451));
                        }
                        let _e457 = phi_791_;
                        let _e467 = select(1f, -1f, ((((_e457.x * _e64.member.member_2[0]) + (_e457.y * _e64.member.member_2[1])) + (_e457.z * _e64.member.member_2[2])) > 0f));
                        let _e493 = (((_e331.x * _e364) + (_e342.x * _e366)) + (_e353.x * _e368));
                        let _e494 = (((_e331.y * _e364) + (_e342.y * _e366)) + (_e353.y * _e368));
                        let _e495 = (((_e331.z * _e364) + (_e342.z * _e366)) + (_e353.z * _e368));
                        let _e498 = bitcast<f32>((bitcast<u32>(_e493) & 2147483647u));
                        let _e501 = bitcast<f32>((bitcast<u32>(_e494) & 2147483647u));
                        let _e503 = select(_e501, _e498, (_e498 > _e501));
                        let _e506 = bitcast<f32>((bitcast<u32>(_e495) & 2147483647u));
                        let _e508 = select(_e506, _e503, (_e503 > _e506));
                        if (_e508 < 0.000000000000000000000000000000000000011754944f) {
                            phi_924_ = vec3<f32>(0f, 0f, 0f);
                        } else {
                            let _e511 = (bitcast<u32>(_e508) & 2147483647u);
                            let _e512 = (_e511 >= 8388608u);
                            if _e512 {
                                phi_874_ = (bitcast<i32>((_e511 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_874_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e511)), 32u, (_e511 == 0u))));
                            }
                            let _e525 = phi_874_;
                            let _e532 = bitcast<f32>((bitcast<u32>(((_e525 / -2i) + 127i)) << bitcast<u32>(23i)));
                            if _e512 {
                                phi_905_ = (bitcast<i32>((_e511 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_905_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e511)), 32u, (_e511 == 0u))));
                            }
                            let _e548 = phi_905_;
                            let _e554 = bitcast<f32>((bitcast<u32>((((_e525 / 2i) - _e548) + 127i)) << bitcast<u32>(23i)));
                            let _e555 = ((_e493 * _e532) * _e554);
                            let _e556 = ((_e494 * _e532) * _e554);
                            let _e557 = ((_e495 * _e532) * _e554);
                            let _e563 = sqrt((((_e555 * _e555) + (_e556 * _e556)) + (_e557 * _e557)));
                            phi_924_ = vec3<f32>((_e555 / _e563), (_e556 / _e563), (_e557 / _e563));
                        }
                        let _e569 = phi_924_;
                        let _e584 = select((_e457 * _e467), (_e569 * _e467), vec3((((((_e569.x * _e467) * (_e457.x * _e467)) + ((_e569.y * _e467) * (_e457.y * _e467))) + ((_e569.z * _e467) * (_e457.z * _e467))) > 0f)));
                        if _e53 {
                        } else {
                            break;
                        }
                        global_6.member[_e52] = type_29(_e64.member, _e64.member_1, _e64.member_2, array<f32, 3>((_e64.member_3[0] + (((_e584.x * 0.5f) + 0.5f) * _e64.member_1[0])), (_e64.member_3[1] + (((_e584.y * 0.5f) + 0.5f) * _e64.member_1[1])), (_e64.member_3[2] + (((_e584.z * 0.5f) + 0.5f) * _e64.member_1[2]))), _e64.member_4);
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
