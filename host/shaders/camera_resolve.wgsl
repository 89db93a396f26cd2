struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_7 {
    member: vec4<u32>,
}

struct type_15 {
    member: array<array<f32, 4>>,
}

struct type_19 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_20 {
    member: type_19,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_22 {
    member: array<type_20>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_7;
@group(0) @binding(1) 
var<storage> global_2: type_22;
@group(0) @binding(2) 
var<storage, read_write> global_3: type_15;

fn function_() {
    var phi_118_: type_4;
    var phi_121_: vec3<f32>;
    var phi_119_: type_4;
    var phi_144_: type_4;
    var phi_176_: vec3<f32>;
    var phi_122_: vec3<f32>;
    var phi_198_: bool;
    var local: vec3<f32>;
    var local_1: vec3<f32>;
    var local_2: vec3<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e19 = global;
            let _e21 = arrayLength((&global_2.member));
            let _e27 = (_e19.x + (_e19.y * 2097152u));
            let _e30 = global_1.member[0u];
            let _e32 = select(1u, _e30, (1u < _e30));
            let _e35 = global_1.member[1u];
            let _e37 = select(1u, _e35, (1u < _e35));
            let _e40 = global_1.member[3u];
            let _e41 = (_e40 + _e27);
            let _e42 = (_e37 == 0u);
            if _e42 {
                break;
            }
            let _e46 = global_1.member[2u];
            if _e42 {
                break;
            }
            let _e49 = (((_e41 / _e37) * _e46) + (_e41 % _e37));
            if (_e32 == 0u) {
                break;
            }
            if (_e27 < (_e21 / _e32)) {
                let _e53 = (_e49 < arrayLength((&global_3.member)));
                if _e53 {
                    let _e54 = (_e27 * _e32);
                    phi_118_ = type_4(_e54, (_e54 + _e32));
                    phi_121_ = vec3<f32>(0f, 0f, 0f);
                    loop {
                        let _e58 = phi_118_;
                        let _e60 = phi_121_;
                        local = _e60;
                        local_1 = _e60;
                        local_2 = _e60;
                        if (_e58.member < _e58.member_1) {
                            phi_119_ = type_4((_e58.member + 1u), _e58.member_1);
                            phi_144_ = type_4(1u, _e58.member);
                        } else {
                            phi_119_ = _e58;
                            phi_144_ = type_4(0u, type_4().member_1);
                        }
                        let _e73 = phi_119_;
                        let _e75 = phi_144_;
                        let _e79 = (bitcast<i32>(_e75.member) != 0i);
                        if _e79 {
                            let _e80 = (_e75.member_1 < _e21);
                            if _e80 {
                                if _e80 {
                                } else {
                                    phi_198_ = true;
                                    break;
                                }
                                let _e84 = global_2.member[_e75.member_1].member_3;
                                phi_176_ = vec3<f32>((_e60.x + _e84[0]), (_e60.y + _e84[1]), (_e60.z + _e84[2]));
                            } else {
                                phi_176_ = _e60;
                            }
                            let _e96 = phi_176_;
                            phi_122_ = _e96;
                        } else {
                            phi_122_ = vec3<f32>();
                        }
                        let _e98 = phi_122_;
                        continue;
                        continuing {
                            phi_118_ = _e73;
                            phi_121_ = _e98;
                            phi_198_ = false;
                            break if !(_e79);
                        }
                    }
                    let _e101 = phi_198_;
                    if _e101 {
                        break;
                    }
                    let _e102 = f32(_e32);
                    let _e104 = local;
                    let _e108 = local_1;
                    let _e112 = local_2;
                    if _e53 {
                    } else {
                        break;
                    }
                    global_3.member[_e49] = array<f32, 4>((_e104.x / _e102), (_e108.y / _e102), (_e112.z / _e102), 1f);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn camera_resolve(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
