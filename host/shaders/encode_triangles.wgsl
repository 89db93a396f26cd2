struct type_4 {
    member: array<u32>,
}

struct type_10 {
    member: vec4<u32>,
}

struct type_14 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_16 {
    member: array<type_14>,
}

struct type_21 {
    member: array<vec4<u32>, 2>,
}

struct type_25 {
    member: array<i32, 3>,
    member_1: u32,
}

struct type_27 {
    member: array<type_25>,
}

var<private> global: vec3<u32>;
@group(0) @binding(2) 
var<storage> global_1: type_16;
@group(0) @binding(0) 
var<uniform> global_2: type_10;
@group(0) @binding(1) 
var<uniform> global_3: type_21;
@group(0) @binding(3) 
var<storage> global_4: type_27;
@group(0) @binding(4) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_4;

fn function_() {
    var phi_205_: i32;
    var phi_239_: i32;
    var phi_273_: i32;
    var phi_307_: i32;
    var phi_341_: i32;
    var phi_375_: i32;
    var phi_409_: i32;
    var phi_443_: i32;
    var phi_477_: i32;
    var phi_669_: array<u32, 10>;

    switch bitcast<i32>(0u) {
        default: {
            let _e40 = global;
            let _e48 = arrayLength((&global_6.member));
            let _e52 = (_e40.x + (_e40.y * 2097152u));
            let _e55 = global_2.member[0u];
            if (_e52 < _e55) {
                let _e57 = (_e52 < arrayLength((&global_1.member)));
                if _e57 {
                    let _e58 = (_e52 < arrayLength((&global_4.member)));
                    if _e58 {
                        let _e59 = (_e52 < arrayLength((&global_5.member)));
                        if _e59 {
                            let _e63 = global_3.member[0u][3u];
                            let _e69 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e63) + 127i)) << bitcast<u32>(23i)));
                            if _e59 {
                            } else {
                                break;
                            }
                            let _e72 = global_5.member[_e52];
                            if _e58 {
                            } else {
                                break;
                            }
                            let _e76 = global_4.member[_e52].member_1;
                            if ((_e72 + _e76) <= _e48) {
                                if _e57 {
                                } else {
                                    break;
                                }
                                if _e58 {
                                } else {
                                    break;
                                }
                                let _e82 = global_1.member[_e52].member_1;
                                switch bitcast<i32>(_e76) {
                                    case 4: {
                                        let _e380 = global_4.member[_e52].member[0u];
                                        let _e385 = global_4.member[_e52].member[1u];
                                        let _e390 = global_4.member[_e52].member[2u];
                                        let _e392 = (f32(_e380) * _e69);
                                        let _e394 = (f32(_e385) * _e69);
                                        let _e396 = (f32(_e390) * _e69);
                                        let _e397 = (1f / _e69);
                                        let _e402 = global_1.member[_e52].member[0u];
                                        let _e407 = global_1.member[_e52].member[1u];
                                        let _e412 = global_1.member[_e52].member[2u];
                                        let _e416 = (1024f / _e69);
                                        let _e434 = global_1.member[_e52].member[3u];
                                        let _e439 = global_1.member[_e52].member[4u];
                                        let _e444 = global_1.member[_e52].member[5u];
                                        let _e465 = global_1.member[_e52].member[6u];
                                        let _e470 = global_1.member[_e52].member[7u];
                                        let _e475 = global_1.member[_e52].member[8u];
                                        phi_669_ = array<u32, 10>(((bitcast<u32>(((((_e402 - _e392) * _e397) + ((_e407 - _e394) * _e416)) + 8388608f)) & 4194303u) | ((bitcast<u32>((((_e412 - _e396) * _e397) + 8388608f)) & 4194303u) << bitcast<u32>(20i))), ((bitcast<u32>(((((_e434 - _e392) * _e397) + ((_e439 - _e394) * _e416)) + 8388608f)) & 4194303u) | ((bitcast<u32>((((_e444 - _e396) * _e397) + 8388608f)) & 4194303u) << bitcast<u32>(20i))), ((bitcast<u32>(((((_e465 - _e392) * _e397) + ((_e470 - _e394) * _e416)) + 8388608f)) & 4194303u) | ((bitcast<u32>((((_e475 - _e396) * _e397) + 8388608f)) & 4194303u) << bitcast<u32>(20i))), _e82, 0u, 0u, 0u, 0u, 0u, 0u);
                                        break;
                                    }
                                    case 7: {
                                        let _e497 = global_4.member[_e52].member[0u];
                                        let _e502 = global_4.member[_e52].member[1u];
                                        let _e507 = global_4.member[_e52].member[2u];
                                        let _e509 = (f32(_e497) * _e69);
                                        let _e511 = (f32(_e502) * _e69);
                                        let _e513 = (f32(_e507) * _e69);
                                        let _e514 = (1f / _e69);
                                        let _e519 = global_1.member[_e52].member[0u];
                                        let _e524 = global_1.member[_e52].member[1u];
                                        let _e529 = global_1.member[_e52].member[2u];
                                        let _e534 = (bitcast<u32>((((_e524 - _e511) * _e514) + 8388608f)) & 4194303u);
                                        let _e557 = global_1.member[_e52].member[3u];
                                        let _e562 = global_1.member[_e52].member[4u];
                                        let _e567 = global_1.member[_e52].member[5u];
                                        let _e572 = (bitcast<u32>((((_e562 - _e511) * _e514) + 8388608f)) & 4194303u);
                                        let _e595 = global_1.member[_e52].member[6u];
                                        let _e600 = global_1.member[_e52].member[7u];
                                        let _e605 = global_1.member[_e52].member[8u];
                                        let _e610 = (bitcast<u32>((((_e600 - _e511) * _e514) + 8388608f)) & 4194303u);
                                        phi_669_ = array<u32, 10>(((bitcast<u32>((((_e519 - _e509) * _e514) + 8388608f)) & 4194303u) | (_e534 << bitcast<u32>(21i))), ((_e534 >> bitcast<u32>(11i)) | ((bitcast<u32>((((_e529 - _e513) * _e514) + 8388608f)) & 4194303u) << bitcast<u32>(10i))), ((bitcast<u32>((((_e557 - _e509) * _e514) + 8388608f)) & 4194303u) | (_e572 << bitcast<u32>(21i))), ((_e572 >> bitcast<u32>(11i)) | ((bitcast<u32>((((_e567 - _e513) * _e514) + 8388608f)) & 4194303u) << bitcast<u32>(10i))), ((bitcast<u32>((((_e595 - _e509) * _e514) + 8388608f)) & 4194303u) | (_e610 << bitcast<u32>(21i))), ((_e610 >> bitcast<u32>(11i)) | ((bitcast<u32>((((_e605 - _e513) * _e514) + 8388608f)) & 4194303u) << bitcast<u32>(10i))), _e82, 0u, 0u, 0u);
                                        break;
                                    }
                                    default: {
                                        let _e88 = global_1.member[_e52].member[0u];
                                        let _e90 = (bitcast<u32>(_e69) & 2147483647u);
                                        let _e91 = (_e90 >= 8388608u);
                                        if _e91 {
                                            phi_205_ = (bitcast<i32>((_e90 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_205_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e90)), 32u, (_e90 == 0u))));
                                        }
                                        let _e104 = phi_205_;
                                        let _e110 = (_e88 * bitcast<f32>((bitcast<u32>((127i - _e104)) << bitcast<u32>(23i))));
                                        let _e123 = global_1.member[_e52].member[1u];
                                        if _e91 {
                                            phi_239_ = (bitcast<i32>((_e90 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_239_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e90)), 32u, (_e90 == 0u))));
                                        }
                                        let _e136 = phi_239_;
                                        let _e142 = (_e123 * bitcast<f32>((bitcast<u32>((127i - _e136)) << bitcast<u32>(23i))));
                                        let _e155 = global_1.member[_e52].member[2u];
                                        if _e91 {
                                            phi_273_ = (bitcast<i32>((_e90 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_273_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e90)), 32u, (_e90 == 0u))));
                                        }
                                        let _e168 = phi_273_;
                                        let _e174 = (_e155 * bitcast<f32>((bitcast<u32>((127i - _e168)) << bitcast<u32>(23i))));
                                        let _e187 = global_1.member[_e52].member[3u];
                                        if _e91 {
                                            phi_307_ = (bitcast<i32>((_e90 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_307_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e90)), 32u, (_e90 == 0u))));
                                        }
                                        let _e200 = phi_307_;
                                        let _e206 = (_e187 * bitcast<f32>((bitcast<u32>((127i - _e200)) << bitcast<u32>(23i))));
                                        let _e219 = global_1.member[_e52].member[4u];
                                        if _e91 {
                                            phi_341_ = (bitcast<i32>((_e90 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_341_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e90)), 32u, (_e90 == 0u))));
                                        }
                                        let _e232 = phi_341_;
                                        let _e238 = (_e219 * bitcast<f32>((bitcast<u32>((127i - _e232)) << bitcast<u32>(23i))));
                                        let _e251 = global_1.member[_e52].member[5u];
                                        if _e91 {
                                            phi_375_ = (bitcast<i32>((_e90 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_375_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e90)), 32u, (_e90 == 0u))));
                                        }
                                        let _e264 = phi_375_;
                                        let _e270 = (_e251 * bitcast<f32>((bitcast<u32>((127i - _e264)) << bitcast<u32>(23i))));
                                        let _e283 = global_1.member[_e52].member[6u];
                                        if _e91 {
                                            phi_409_ = (bitcast<i32>((_e90 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_409_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e90)), 32u, (_e90 == 0u))));
                                        }
                                        let _e296 = phi_409_;
                                        let _e302 = (_e283 * bitcast<f32>((bitcast<u32>((127i - _e296)) << bitcast<u32>(23i))));
                                        let _e315 = global_1.member[_e52].member[7u];
                                        if _e91 {
                                            phi_443_ = (bitcast<i32>((_e90 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_443_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e90)), 32u, (_e90 == 0u))));
                                        }
                                        let _e328 = phi_443_;
                                        let _e334 = (_e315 * bitcast<f32>((bitcast<u32>((127i - _e328)) << bitcast<u32>(23i))));
                                        let _e347 = global_1.member[_e52].member[8u];
                                        if _e91 {
                                            phi_477_ = (bitcast<i32>((_e90 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_477_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e90)), 32u, (_e90 == 0u))));
                                        }
                                        let _e360 = phi_477_;
                                        let _e366 = (_e347 * bitcast<f32>((bitcast<u32>((127i - _e360)) << bitcast<u32>(23i))));
                                        phi_669_ = array<u32, 10>(bitcast<u32>(select(0i, select(select(i32(_e110), i32(-2147483648), (_e110 < -2147483600f)), 2147483647i, (_e110 > 2147483500f)), (_e110 == _e110))), bitcast<u32>(select(0i, select(select(i32(_e142), i32(-2147483648), (_e142 < -2147483600f)), 2147483647i, (_e142 > 2147483500f)), (_e142 == _e142))), bitcast<u32>(select(0i, select(select(i32(_e174), i32(-2147483648), (_e174 < -2147483600f)), 2147483647i, (_e174 > 2147483500f)), (_e174 == _e174))), bitcast<u32>(select(0i, select(select(i32(_e206), i32(-2147483648), (_e206 < -2147483600f)), 2147483647i, (_e206 > 2147483500f)), (_e206 == _e206))), bitcast<u32>(select(0i, select(select(i32(_e238), i32(-2147483648), (_e238 < -2147483600f)), 2147483647i, (_e238 > 2147483500f)), (_e238 == _e238))), bitcast<u32>(select(0i, select(select(i32(_e270), i32(-2147483648), (_e270 < -2147483600f)), 2147483647i, (_e270 > 2147483500f)), (_e270 == _e270))), bitcast<u32>(select(0i, select(select(i32(_e302), i32(-2147483648), (_e302 < -2147483600f)), 2147483647i, (_e302 > 2147483500f)), (_e302 == _e302))), bitcast<u32>(select(0i, select(select(i32(_e334), i32(-2147483648), (_e334 < -2147483600f)), 2147483647i, (_e334 > 2147483500f)), (_e334 == _e334))), bitcast<u32>(select(0i, select(select(i32(_e366), i32(-2147483648), (_e366 < -2147483600f)), 2147483647i, (_e366 > 2147483500f)), (_e366 == _e366))), _e82);
                                        break;
                                    }
                                }
                                let _e631 = phi_669_;
                                if (_e72 < _e48) {
                                } else {
                                    break;
                                }
                                global_6.member[_e72] = _e631[0];
                                let _e645 = (_e72 + 1u);
                                if (_e645 < _e48) {
                                } else {
                                    break;
                                }
                                global_6.member[_e645] = _e631[1];
                                let _e649 = (_e72 + 2u);
                                if (_e649 < _e48) {
                                } else {
                                    break;
                                }
                                global_6.member[_e649] = _e631[2];
                                let _e653 = (_e72 + 3u);
                                if (_e653 < _e48) {
                                } else {
                                    break;
                                }
                                global_6.member[_e653] = _e631[3];
                                if (_e76 > 4u) {
                                    let _e658 = (_e72 + 4u);
                                    if (_e658 < _e48) {
                                    } else {
                                        break;
                                    }
                                    global_6.member[_e658] = _e631[4];
                                    let _e662 = (_e72 + 5u);
                                    if (_e662 < _e48) {
                                    } else {
                                        break;
                                    }
                                    global_6.member[_e662] = _e631[5];
                                    let _e666 = (_e72 + 6u);
                                    if (_e666 < _e48) {
                                    } else {
                                        break;
                                    }
                                    global_6.member[_e666] = _e631[6];
                                }
                                if (_e76 > 7u) {
                                    let _e671 = (_e72 + 7u);
                                    if (_e671 < _e48) {
                                    } else {
                                        break;
                                    }
                                    global_6.member[_e671] = _e631[7];
                                    let _e675 = (_e72 + 8u);
                                    if (_e675 < _e48) {
                                    } else {
                                        break;
                                    }
                                    global_6.member[_e675] = _e631[8];
                                    let _e679 = (_e72 + 9u);
                                    if (_e679 < _e48) {
                                    } else {
                                        break;
                                    }
                                    global_6.member[_e679] = _e631[9];
                                }
                            }
                        }
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn encode_triangles(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
