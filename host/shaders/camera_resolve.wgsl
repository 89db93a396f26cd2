struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_7 {
    member: vec4<u32>,
}

struct type_12 {
    member: array<array<f32, 3>>,
}

struct type_16 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_17 {
    member: type_16,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_19 {
    member: array<type_17>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_7;
@group(0) @binding(1) 
var<storage> global_2: type_19;
@group(0) @binding(2) 
var<storage, read_write> global_3: type_12;

fn function_() {
    var phi_74_: type_4;
    var phi_77_: vec3<f32>;
    var phi_75_: type_4;
    var phi_100_: type_4;
    var phi_132_: vec3<f32>;
    var phi_78_: vec3<f32>;
    var phi_156_: bool;
    var local: vec3<f32>;
    var local_1: vec3<f32>;
    var local_2: vec3<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e16 = global;
            let _e24 = (_e16.x + (_e16.y * 2097152u));
            let _e25 = (_e24 < arrayLength((&global_3.member)));
            if _e25 {
                let _e28 = global_1.member[0u];
                let _e29 = (_e24 * _e28);
                phi_74_ = type_4(_e29, (_e29 + _e28));
                phi_77_ = vec3<f32>(0f, 0f, 0f);
                loop {
                    let _e33 = phi_74_;
                    let _e35 = phi_77_;
                    local = _e35;
                    local_1 = _e35;
                    local_2 = _e35;
                    if (_e33.member < _e33.member_1) {
                        phi_75_ = type_4((_e33.member + 1u), _e33.member_1);
                        phi_100_ = type_4(1u, _e33.member);
                    } else {
                        phi_75_ = _e33;
                        phi_100_ = type_4(0u, type_4().member_1);
                    }
                    let _e48 = phi_75_;
                    let _e50 = phi_100_;
                    let _e54 = (bitcast<i32>(_e50.member) != 0i);
                    if _e54 {
                        let _e55 = (_e50.member_1 < arrayLength((&global_2.member)));
                        if _e55 {
                            if _e55 {
                            } else {
                                phi_156_ = true;
                                break;
                            }
                            let _e59 = global_2.member[_e50.member_1].member_3;
                            phi_132_ = vec3<f32>((_e35.x + _e59[0]), (_e35.y + _e59[1]), (_e35.z + _e59[2]));
                        } else {
                            phi_132_ = _e35;
                        }
                        let _e71 = phi_132_;
                        phi_78_ = _e71;
                    } else {
                        phi_78_ = vec3<f32>();
                    }
                    let _e73 = phi_78_;
                    continue;
                    continuing {
                        phi_74_ = _e48;
                        phi_77_ = _e73;
                        phi_156_ = false;
                        break if !(_e54);
                    }
                }
                let _e76 = phi_156_;
                if _e76 {
                    break;
                }
                let _e77 = f32(_e28);
                let _e79 = local;
                let _e83 = local_1;
                let _e87 = local_2;
                if _e25 {
                } else {
                    break;
                }
                global_3.member[_e24] = array<f32, 3>((_e79.x / _e77), (_e83.y / _e77), (_e87.z / _e77));
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
