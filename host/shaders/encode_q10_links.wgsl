struct type_4 {
    member: array<u32>,
}

struct type_11 {
    member: array<array<u32, 4>>,
}

struct type_14 {
    member: vec4<u32>,
}

struct type_19 {
    member: array<array<i32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_21 {
    member: array<type_19>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_14;
@group(0) @binding(1) 
var<storage> global_2: type_21;
@group(0) @binding(2) 
var<storage> global_3: type_4;
@group(0) @binding(3) 
var<storage, read_write> global_4: type_11;

fn function_() {
    var phi_128_: u32;
    var phi_130_: u32;
    var phi_131_: bool;
    var phi_147_: u32;
    var phi_149_: u32;
    var phi_150_: bool;
    var phi_155_: u32;
    var phi_167_: u32;
    var phi_183_: u32;
    var phi_198_: u32;
    var phi_213_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e24 = global;
            let _e34 = (_e24.x + (_e24.y * 2097152u));
            let _e37 = global_1.member[0u];
            if (_e34 < _e37) {
                let _e39 = (_e34 < arrayLength((&global_2.member)));
                if _e39 {
                    let _e40 = (_e34 < arrayLength((&global_4.member)));
                    if _e40 {
                        if _e40 {
                        } else {
                            break;
                        }
                        let _e43 = global_4.member[_e34];
                        if _e39 {
                        } else {
                            break;
                        }
                        let _e47 = global_2.member[_e34].member_1;
                        let _e51 = global_2.member[_e34].member_2;
                        let _e53 = ((_e47 & 2147483648u) != 0u);
                        if _e53 {
                            let _e57 = (((_e47 >> bitcast<u32>(28u)) & 7u) > 0u);
                            if _e57 {
                                phi_128_ = (_e47 & 268435455u);
                            } else {
                                phi_128_ = u32();
                            }
                            let _e60 = phi_128_;
                            phi_130_ = _e60;
                            phi_131_ = select(true, false, _e57);
                        } else {
                            phi_130_ = u32();
                            phi_131_ = true;
                        }
                        let _e63 = phi_130_;
                        let _e65 = phi_131_;
                        if _e65 {
                            if ((_e51 & 2147483648u) != 0u) {
                                let _e71 = (((_e51 >> bitcast<u32>(28u)) & 7u) > 0u);
                                if _e71 {
                                    phi_147_ = (_e51 & 268435455u);
                                } else {
                                    phi_147_ = u32();
                                }
                                let _e74 = phi_147_;
                                phi_149_ = _e74;
                                phi_150_ = select(true, false, _e71);
                            } else {
                                phi_149_ = u32();
                                phi_150_ = true;
                            }
                            let _e77 = phi_149_;
                            let _e79 = phi_150_;
                            phi_155_ = select(_e77, 0u, _e79);
                        } else {
                            phi_155_ = _e63;
                        }
                        let _e82 = phi_155_;
                        let _e83 = (_e82 < arrayLength((&global_3.member)));
                        if _e83 {
                            if _e83 {
                            } else {
                                break;
                            }
                            let _e86 = global_3.member[_e82];
                            phi_167_ = _e86;
                        } else {
                            phi_167_ = 0u;
                        }
                        let _e88 = phi_167_;
                        if _e53 {
                            phi_183_ = select(_e51, 0u, ((_e51 & 2147483648u) != 0u));
                        } else {
                            phi_183_ = _e47;
                        }
                        let _e93 = phi_183_;
                        if _e53 {
                            let _e96 = ((_e47 >> bitcast<u32>(28u)) & 7u);
                            phi_198_ = select(_e96, 7u, (_e96 == 0u));
                        } else {
                            phi_198_ = 0u;
                        }
                        let _e100 = phi_198_;
                        if ((_e51 & 2147483648u) != 0u) {
                            let _e105 = ((_e51 >> bitcast<u32>(28u)) & 7u);
                            phi_213_ = select(_e105, 7u, (_e105 == 0u));
                        } else {
                            phi_213_ = 0u;
                        }
                        let _e109 = phi_213_;
                        let _e122 = ((_e88 & 268435455u) | ((_e109 >> bitcast<u32>(1i)) << bitcast<u32>(28u)));
                        if _e40 {
                        } else {
                            break;
                        }
                        global_4.member[_e34] = array<u32, 4>((((_e93 & 268435455u) | (_e100 << bitcast<u32>(28u))) | (_e109 << bitcast<u32>(31i))), (_e43[1] | (_e122 << bitcast<u32>(22i))), (_e43[2] | ((_e122 >> bitcast<u32>(10u)) << bitcast<u32>(22i))), (_e43[3] | ((_e122 >> bitcast<u32>(20u)) << bitcast<u32>(22i))));
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn encode_q10_links(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
