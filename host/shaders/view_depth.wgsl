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
    var phi_129_: type_7;
    var phi_132_: vec3<f32>;
    var phi_130_: type_7;
    var phi_155_: type_7;
    var phi_174_: u32;
    var phi_211_: vec3<f32>;
    var phi_133_: vec3<f32>;
    var phi_233_: bool;
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
                    let _e61 = global_1.member[0u];
                    let _e64 = global_1.member[1u];
                    let _e65 = (_e32 * _e37);
                    let _e66 = bitcast<f32>(_e61);
                    let _e67 = bitcast<f32>(_e64);
                    phi_129_ = type_7(_e65, (_e65 + _e37));
                    phi_132_ = vec3<f32>(0f, 0f, 0f);
                    loop {
                        let _e71 = phi_129_;
                        let _e73 = phi_132_;
                        local = _e73;
                        local_1 = _e73;
                        local_2 = _e73;
                        if (_e71.member < _e71.member_1) {
                            phi_130_ = type_7((_e71.member + 1u), _e71.member_1);
                            phi_155_ = type_7(1u, _e71.member);
                        } else {
                            phi_130_ = _e71;
                            phi_155_ = type_7(0u, type_7().member_1);
                        }
                        let _e86 = phi_130_;
                        let _e88 = phi_155_;
                        let _e92 = (bitcast<i32>(_e88.member) != 0i);
                        if _e92 {
                            let _e93 = (_e88.member_1 < _e26);
                            if _e93 {
                                if _e93 {
                                } else {
                                    phi_233_ = true;
                                    break;
                                }
                                let _e96 = global_3.member[_e88.member_1];
                                phi_174_ = _e96;
                            } else {
                                phi_174_ = 2139095039u;
                            }
                            let _e98 = phi_174_;
                            if (_e98 < 2139095039u) {
                                let _e100 = bitcast<f32>(_e98);
                                let _e102 = (_e67 - _e66);
                                let _e107 = (((_e100 - _e66) / select(0.000000000000000000000000000000000000011754944f, _e102, (_e102 > 0.000000000000000000000000000000000000011754944f))) * (_e67 / _e100));
                                let _e109 = select(1f, _e107, (_e107 < 1f));
                                let _e113 = (0.9f - (0.85f * select(0f, _e109, (_e109 > 0f))));
                                phi_211_ = vec3<f32>((_e73.x + _e113), (_e73.y + _e113), (_e73.z + _e113));
                            } else {
                                phi_211_ = _e73;
                            }
                            let _e122 = phi_211_;
                            phi_133_ = _e122;
                        } else {
                            phi_133_ = vec3<f32>();
                        }
                        let _e124 = phi_133_;
                        continue;
                        continuing {
                            phi_129_ = _e86;
                            phi_132_ = _e124;
                            phi_233_ = false;
                            break if !(_e92);
                        }
                    }
                    let _e127 = phi_233_;
                    if _e127 {
                        break;
                    }
                    let _e128 = f32(_e37);
                    let _e130 = local;
                    let _e134 = local_1;
                    let _e138 = local_2;
                    if _e58 {
                    } else {
                        break;
                    }
                    global_4.member[_e54] = array<f32, 4>((_e130.x / _e128), (_e134.y / _e128), (_e138.z / _e128), 1f);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn view_depth(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
