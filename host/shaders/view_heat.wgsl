struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_11 {
    member: vec4<u32>,
}

struct type_17 {
    member: array<array<f32, 4>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_11;
@group(0) @binding(1) 
var<uniform> global_2: type_11;
@group(0) @binding(2) 
var<storage> global_3: type_4;
@group(0) @binding(3) 
var<storage, read_write> global_4: type_17;

fn function_() {
    var phi_124_: type_7;
    var phi_127_: vec3<f32>;
    var phi_125_: type_7;
    var phi_150_: type_7;
    var phi_169_: u32;
    var phi_128_: vec3<f32>;
    var phi_262_: bool;
    var local: vec3<f32>;
    var local_1: vec3<f32>;
    var local_2: vec3<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e24 = global;
            let _e26 = arrayLength((&global_3.member));
            let _e32 = (_e24.x + (_e24.y * 2097152u));
            let _e35 = global_2.member[0u];
            let _e37 = select(1u, _e35, (1u < _e35));
            let _e40 = global_2.member[1u];
            let _e42 = select(1u, _e40, (1u < _e40));
            let _e45 = global_2.member[3u];
            let _e46 = (_e45 + _e32);
            let _e47 = (_e42 == 0u);
            if _e47 {
                break;
            }
            let _e51 = global_2.member[2u];
            if _e47 {
                break;
            }
            let _e54 = (((_e46 / _e42) * _e51) + (_e46 % _e42));
            if (_e37 == 0u) {
                break;
            }
            if (_e32 < (_e26 / _e37)) {
                let _e58 = (_e54 < arrayLength((&global_4.member)));
                if _e58 {
                    let _e59 = (_e32 * _e37);
                    let _e62 = global_1.member[0u];
                    phi_124_ = type_7(_e59, (_e59 + _e37));
                    phi_127_ = vec3<f32>(0f, 0f, 0f);
                    loop {
                        let _e66 = phi_124_;
                        let _e68 = phi_127_;
                        local = _e68;
                        local_1 = _e68;
                        local_2 = _e68;
                        if (_e66.member < _e66.member_1) {
                            phi_125_ = type_7((_e66.member + 1u), _e66.member_1);
                            phi_150_ = type_7(1u, _e66.member);
                        } else {
                            phi_125_ = _e66;
                            phi_150_ = type_7(0u, type_7().member_1);
                        }
                        let _e81 = phi_125_;
                        let _e83 = phi_150_;
                        let _e87 = (bitcast<i32>(_e83.member) != 0i);
                        if _e87 {
                            let _e88 = (_e83.member_1 < _e26);
                            if _e88 {
                                if _e88 {
                                } else {
                                    phi_262_ = true;
                                    break;
                                }
                                let _e91 = global_3.member[_e83.member_1];
                                phi_169_ = _e91;
                            } else {
                                phi_169_ = 0u;
                            }
                            let _e93 = phi_169_;
                            let _e95 = f32(_e62);
                            let _e98 = (f32(_e93) / select(1f, _e95, (_e95 > 1f)));
                            let _e101 = (select(1f, _e98, (_e98 < 1f)) * 4f);
                            let _e103 = select(1f, _e101, (_e101 < 1f));
                            let _e106 = (_e101 - 1f);
                            let _e108 = select(1f, _e106, (_e106 < 1f));
                            let _e110 = select(0f, _e108, (_e108 > 0f));
                            let _e111 = (_e101 - 2f);
                            let _e113 = select(1f, _e111, (_e111 < 1f));
                            let _e116 = (_e101 - 3f);
                            let _e118 = select(1f, _e116, (_e116 < 1f));
                            phi_128_ = vec3<f32>((_e68.x + _e110), (_e68.y + select(0f, _e113, (_e113 > 0f))), (_e68.z + (((0.6f * select(0f, _e103, (_e103 > 0f))) * (1f - _e110)) + select(0f, _e118, (_e118 > 0f)))));
                        } else {
                            phi_128_ = vec3<f32>();
                        }
                        let _e133 = phi_128_;
                        continue;
                        continuing {
                            phi_124_ = _e81;
                            phi_127_ = _e133;
                            phi_262_ = false;
                            break if !(_e87);
                        }
                    }
                    let _e136 = phi_262_;
                    if _e136 {
                        break;
                    }
                    let _e137 = f32(_e37);
                    let _e139 = local;
                    let _e143 = local_1;
                    let _e147 = local_2;
                    if _e58 {
                    } else {
                        break;
                    }
                    global_4.member[_e54] = array<f32, 4>((_e139.x / _e137), (_e143.y / _e137), (_e147.z / _e137), 1f);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn view_heat(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
