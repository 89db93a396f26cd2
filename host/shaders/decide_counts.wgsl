struct type_5 {
    member: array<u32>,
}

struct type_9 {
    member: u32,
    member_1: u32,
}

struct type_13 {
    member: vec4<u32>,
}

struct type_18 {
    member: array<array<f32, 3>>,
}

struct type_22 {
    member: array<array<u32, 3>>,
}

struct type_30 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_32 {
    member: array<vec4<u32>, 2>,
}

struct type_35 {
    member: array<i32>,
}

struct type_39 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_41 {
    member: array<type_39>,
}

var<private> global: vec3<u32>;
var<private> global_1: u32;
@group(0) @binding(0) 
var<uniform> global_2: type_13;
@group(0) @binding(1) 
var<uniform> global_3: type_32;
@group(0) @binding(4) 
var<storage> global_4: type_5;
@group(0) @binding(5) 
var<storage> global_5: type_35;
@group(0) @binding(2) 
var<storage> global_6: type_18;
@group(0) @binding(3) 
var<storage> global_7: type_22;
@group(0) @binding(6) 
var<storage> global_8: type_35;
@group(0) @binding(7) 
var<storage, read_write> global_9: type_41;
var<workgroup> global_10: array<type_39, 64>;

fn function_() {
    var phi_235_: type_30;
    var phi_246_: type_9;
    var phi_249_: type_39;
    var phi_247_: type_9;
    var phi_272_: type_9;
    var phi_302_: u32;
    var phi_316_: i32;
    var phi_335_: array<u32, 3>;
    var phi_350_: array<f32, 3>;
    var phi_368_: array<f32, 3>;
    var phi_386_: array<f32, 3>;
    var phi_495_: vec3<f32>;
    var phi_677_: f32;
    var phi_713_: i32;
    var phi_717_: type_39;
    var phi_728_: type_39;
    var phi_250_: type_39;
    var phi_860_: bool;
    var local: type_39;
    var local_1: type_39;
    var local_2: type_39;
    var local_3: type_39;
    var phi_743_: type_9;
    var phi_746_: u32;
    var phi_744_: type_9;
    var phi_769_: type_9;
    var phi_747_: u32;
    var phi_893_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e47 = global;
            let _e48 = global_1;
            let _e51 = arrayLength((&global_6.member));
            let _e69 = (_e47.x + (_e47.y * 32768u));
            let _e72 = global_2.member[0u];
            let _e73 = bitcast<i32>(_e72);
            let _e74 = (_e73 / 2i);
            let _e79 = bitcast<f32>((bitcast<u32>((_e74 + 127i)) << bitcast<u32>(23i)));
            let _e85 = bitcast<f32>((bitcast<u32>(((_e73 - _e74) + 127i)) << bitcast<u32>(23i)));
            let _e89 = global_3.member[0u][0u];
            let _e93 = global_3.member[0u][1u];
            let _e97 = global_3.member[0u][2u];
            let _e101 = global_3.member[0u][3u];
            let _e105 = global_3.member[1u][0u];
            let _e109 = global_3.member[1u][1u];
            let _e113 = global_3.member[1u][2u];
            let _e117 = global_3.member[1u][3u];
            let _e118 = bitcast<f32>(_e89);
            let _e119 = bitcast<f32>(_e93);
            let _e120 = bitcast<f32>(_e97);
            let _e122 = bitcast<f32>(_e105);
            let _e123 = array<u32, 3>(_e109, _e113, _e117);
            if (_e101 == 0u) {
                phi_235_ = type_30(array<f32, 3>(_e118, _e119, _e120), _e101, _e122, _e123);
            } else {
                phi_235_ = type_30(array<f32, 3>(((_e118 * _e79) * _e85), ((_e119 * _e79) * _e85), ((_e120 * _e79) * _e85)), _e101, ((_e122 * _e79) * _e85), _e123);
            }
            let _e137 = phi_235_;
            phi_246_ = type_9(0u, 16u);
            phi_249_ = type_39(0u, 0u, 0u, 0u);
            loop {
                let _e139 = phi_246_;
                let _e141 = phi_249_;
                local = _e141;
                local_1 = _e141;
                local_2 = _e141;
                local_3 = _e141;
                if (_e139.member < _e139.member_1) {
                    phi_247_ = type_9((_e139.member + 1u), _e139.member_1);
                    phi_272_ = type_9(1u, _e139.member);
                } else {
                    phi_247_ = _e139;
                    phi_272_ = type_9(0u, type_9().member_1);
                }
                let _e154 = phi_247_;
                let _e156 = phi_272_;
                let _e160 = (bitcast<i32>(_e156.member) != 0i);
                if _e160 {
                    let _e164 = (((_e69 * 1024u) + (_e156.member_1 * 64u)) + _e48);
                    let _e165 = (_e164 < arrayLength((&global_7.member)));
                    if _e165 {
                        let _e166 = (_e164 < arrayLength((&global_4.member)));
                        if _e166 {
                            if _e166 {
                            } else {
                                phi_860_ = true;
                                break;
                            }
                            let _e168 = global_4.member[_e164];
                            phi_302_ = _e168;
                        } else {
                            phi_302_ = 4294967295u;
                        }
                        let _e170 = phi_302_;
                        let _e171 = (_e170 < arrayLength((&global_5.member)));
                        if _e171 {
                            if _e171 {
                            } else {
                                phi_860_ = true;
                                break;
                            }
                            let _e173 = global_5.member[_e170];
                            phi_316_ = _e173;
                        } else {
                            phi_316_ = 0i;
                        }
                        let _e175 = phi_316_;
                        if (_e175 == 0i) {
                            phi_717_ = type_39(1u, 1u, 0u, 0u);
                        } else {
                            if _e165 {
                                if _e165 {
                                } else {
                                    phi_860_ = true;
                                    break;
                                }
                                let _e178 = global_7.member[_e164];
                                phi_335_ = _e178;
                            } else {
                                phi_335_ = array<u32, 3>(0u, 0u, 0u);
                            }
                            let _e180 = phi_335_;
                            let _e182 = (_e180[0] < _e51);
                            if _e182 {
                                if _e182 {
                                } else {
                                    phi_860_ = true;
                                    break;
                                }
                                let _e184 = global_6.member[_e180[0]];
                                phi_350_ = _e184;
                            } else {
                                phi_350_ = array<f32, 3>(0f, 0f, 0f);
                            }
                            let _e186 = phi_350_;
                            let _e191 = (_e180[1] < _e51);
                            if _e191 {
                                if _e191 {
                                } else {
                                    phi_860_ = true;
                                    break;
                                }
                                let _e193 = global_6.member[_e180[1]];
                                phi_368_ = _e193;
                            } else {
                                phi_368_ = array<f32, 3>(0f, 0f, 0f);
                            }
                            let _e195 = phi_368_;
                            let _e200 = (_e180[2] < _e51);
                            if _e200 {
                                if _e200 {
                                } else {
                                    phi_860_ = true;
                                    break;
                                }
                                let _e202 = global_6.member[_e180[2]];
                                phi_386_ = _e202;
                            } else {
                                phi_386_ = array<f32, 3>(0f, 0f, 0f);
                            }
                            let _e204 = phi_386_;
                            let _e209 = ((_e186[0] * _e79) * _e85);
                            let _e211 = select(_e209, 0f, (_e209 == 0f));
                            let _e213 = ((_e186[1] * _e79) * _e85);
                            let _e215 = select(_e213, 0f, (_e213 == 0f));
                            let _e217 = ((_e186[2] * _e79) * _e85);
                            let _e219 = select(_e217, 0f, (_e217 == 0f));
                            let _e221 = ((_e195[0] * _e79) * _e85);
                            let _e225 = ((_e195[1] * _e79) * _e85);
                            let _e229 = ((_e195[2] * _e79) * _e85);
                            let _e233 = ((_e204[0] * _e79) * _e85);
                            let _e237 = ((_e204[1] * _e79) * _e85);
                            let _e241 = ((_e204[2] * _e79) * _e85);
                            let _e244 = (select(_e221, 0f, (_e221 == 0f)) - _e211);
                            let _e245 = (select(_e225, 0f, (_e225 == 0f)) - _e215);
                            let _e246 = (select(_e229, 0f, (_e229 == 0f)) - _e219);
                            let _e247 = (select(_e233, 0f, (_e233 == 0f)) - _e211);
                            let _e248 = (select(_e237, 0f, (_e237 == 0f)) - _e215);
                            let _e249 = (select(_e241, 0f, (_e241 == 0f)) - _e219);
                            if (_e137.member_1 == 1u) {
                                phi_495_ = vec3<f32>((_e137.member[0] - _e211), (_e137.member[1] - _e215), (_e137.member[2] - _e219));
                            } else {
                                phi_495_ = vec3<f32>(_e137.member[0], _e137.member[1], _e137.member[2]);
                            }
                            let _e266 = phi_495_;
                            let _e272 = bitcast<f32>((bitcast<u32>((_e244 * _e248)) ^ _e137.member_3[0]));
                            let _e276 = bitcast<f32>((bitcast<u32>((_e245 * _e247)) ^ _e137.member_3[0]));
                            let _e280 = bitcast<f32>((bitcast<u32>((_e245 * _e249)) ^ _e137.member_3[0]));
                            let _e284 = bitcast<f32>((bitcast<u32>((_e246 * _e248)) ^ _e137.member_3[0]));
                            let _e288 = bitcast<f32>((bitcast<u32>((_e246 * _e247)) ^ _e137.member_3[0]));
                            let _e292 = bitcast<f32>((bitcast<u32>((_e244 * _e249)) ^ _e137.member_3[0]));
                            let _e293 = (_e280 - _e284);
                            let _e294 = (_e288 - _e292);
                            let _e295 = (_e272 - _e276);
                            let _e312 = ((bitcast<f32>((bitcast<u32>((_e266.x * _e293)) ^ _e137.member_3[0])) + bitcast<f32>((bitcast<u32>((_e266.y * _e294)) ^ _e137.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e266.z * _e295)) ^ _e137.member_3[0])));
                            let _e319 = (bitcast<f32>((bitcast<u32>(_e280) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e284) & 2147483647u)));
                            let _e326 = (bitcast<f32>((bitcast<u32>(_e288) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e292) & 2147483647u)));
                            let _e333 = (bitcast<f32>((bitcast<u32>(_e272) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e276) & 2147483647u)));
                            if (_e137.member_2 == 0f) {
                                phi_677_ = 0f;
                            } else {
                                let _e363 = bitcast<f32>((bitcast<u32>(_e293) & 2147483647u));
                                let _e366 = bitcast<f32>((bitcast<u32>(_e294) & 2147483647u));
                                let _e369 = bitcast<f32>((bitcast<u32>(_e295) & 2147483647u));
                                let _e371 = select(_e369, _e366, (_e366 > _e369));
                                let _e375 = select(_e369, _e366, (_e366 < _e369));
                                let _e379 = select(_e366, _e363, (_e363 < _e366));
                                let _e381 = select(_e366, _e363, (_e363 > _e366));
                                let _e383 = select(_e369, _e381, (_e381 < _e369));
                                phi_677_ = bitcast<f32>((bitcast<u32>((_e137.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e371, _e363, (_e363 > _e371)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e383, _e379, (_e379 > _e383)))) ^ _e137.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e375, _e363, (_e363 < _e375)))) ^ _e137.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e319 + _e326) + _e333))) ^ _e137.member_3[0]))) * 1.0000005f)) ^ _e137.member_3[0])))) ^ _e137.member_3[0]));
                            }
                            let _e410 = phi_677_;
                            let _e416 = ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e266.x) & 2147483647u)) * _e319)) ^ _e137.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e266.y) & 2147483647u)) * _e326)) ^ _e137.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e266.z) & 2147483647u)) * _e333)) ^ _e137.member_3[0]))))) ^ _e137.member_3[0])) + _e410) + 0.0000000000000000000000000000000000001880791f);
                            let _e428 = (_e170 < arrayLength((&global_8.member)));
                            if _e428 {
                                if _e428 {
                                } else {
                                    phi_860_ = true;
                                    break;
                                }
                                let _e430 = global_8.member[_e170];
                                phi_713_ = _e430;
                            } else {
                                phi_713_ = 0i;
                            }
                            let _e432 = phi_713_;
                            phi_717_ = type_39(select(0u, 1u, !(((_e312 * f32(-(_e175))) > _e416))), select(0u, 1u, !(((_e312 * f32(_e175)) > _e416))), select(0u, 1u, (_e432 == 0i)), 0u);
                        }
                        let _e437 = phi_717_;
                        phi_728_ = type_39((_e141.member + _e437.member), (_e141.member_1 + _e437.member_1), (_e141.member_2 + _e437.member_2), 0u);
                    } else {
                        phi_728_ = _e141;
                    }
                    let _e449 = phi_728_;
                    phi_250_ = _e449;
                } else {
                    phi_250_ = type_39();
                }
                let _e451 = phi_250_;
                continue;
                continuing {
                    phi_246_ = _e154;
                    phi_249_ = _e451;
                    phi_860_ = false;
                    break if !(_e160);
                }
            }
            let _e454 = phi_860_;
            if _e454 {
                break;
            }
            let _e455 = (_e48 % 64u);
            let _e456 = (_e455 < 64u);
            if _e456 {
            } else {
                break;
            }
            let _e459 = local;
            let _e462 = local_1;
            let _e465 = local_2;
            let _e468 = local_3;
            global_10[_e455] = type_39(_e459.member, _e462.member_1, _e465.member_2, _e468.member_3);
            workgroupBarrier();
            phi_743_ = type_9(0u, 6u);
            phi_746_ = 32u;
            loop {
                let _e472 = phi_743_;
                let _e474 = phi_746_;
                if (_e472.member < _e472.member_1) {
                    phi_744_ = type_9((_e472.member + 1u), _e472.member_1);
                    phi_769_ = type_9(1u, _e472.member);
                } else {
                    phi_744_ = _e472;
                    phi_769_ = type_9(0u, type_9().member_1);
                }
                let _e487 = phi_744_;
                let _e489 = phi_769_;
                let _e492 = (bitcast<i32>(_e489.member) != 0i);
                if _e492 {
                    if (_e48 < _e474) {
                        if _e456 {
                        } else {
                            phi_893_ = true;
                            break;
                        }
                        let _e494 = global_10[_e455];
                        let _e499 = ((_e48 + _e474) % 64u);
                        if (_e499 < 64u) {
                        } else {
                            phi_893_ = true;
                            break;
                        }
                        let _e502 = global_10[_e499];
                        if _e456 {
                        } else {
                            phi_893_ = true;
                            break;
                        }
                        global_10[_e455] = type_39((_e494.member + _e502.member), (_e494.member_1 + _e502.member_1), (_e494.member_2 + _e502.member_2), 0u);
                    }
                    workgroupBarrier();
                    phi_747_ = (_e474 / 2u);
                } else {
                    phi_747_ = u32();
                }
                let _e512 = phi_747_;
                continue;
                continuing {
                    phi_743_ = _e487;
                    phi_746_ = _e512;
                    phi_893_ = _e454;
                    break if !(_e492);
                }
            }
            let _e515 = phi_893_;
            if _e515 {
                break;
            }
            if (_e48 == 0u) {
                let _e517 = (_e69 < arrayLength((&global_9.member)));
                if _e517 {
                    let _e519 = global_10[0u];
                    if _e517 {
                    } else {
                        break;
                    }
                    global_9.member[_e69] = type_39(_e519.member, _e519.member_1, _e519.member_2, _e519.member_3);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_counts(@builtin(workgroup_id) param: vec3<u32>, @builtin(local_invocation_index) param_1: u32) {
    global = param;
    global_1 = param_1;
    function_();
}
