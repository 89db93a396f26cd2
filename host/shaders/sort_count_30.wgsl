struct type_5 {
    member: array<u32>,
}

struct type_9 {
    member: u32,
    member_1: u32,
}

struct type_14 {
    member: vec4<u32>,
}

struct type_19 {
    member: array<array<u32, 2>>,
}

var<private> global: vec3<u32>;
var<private> global_1: u32;
@group(0) @binding(0) 
var<uniform> global_2: type_14;
@group(0) @binding(1) 
var<storage> global_3: type_19;
@group(0) @binding(2) 
var<storage, read_write> global_4: type_5;
var<workgroup> global_5: array<array<u32, 64>, 16>;

fn function_() {
    var phi_72_: type_9;
    var phi_73_: type_9;
    var phi_96_: type_9;
    var phi_303_: bool;
    var phi_138_: type_9;
    var phi_139_: type_9;
    var phi_162_: type_9;
    var phi_307_: bool;
    var phi_216_: u32;
    var phi_237_: type_9;
    var phi_240_: u32;
    var phi_238_: type_9;
    var phi_263_: type_9;
    var phi_241_: u32;
    var phi_313_: bool;
    var local: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e24 = global;
            let _e25 = global_1;
            let _e27 = arrayLength((&global_3.member));
            let _e32 = global_2.member[0u];
            phi_72_ = type_9(0u, 16u);
            loop {
                let _e34 = phi_72_;
                if (_e34.member < _e34.member_1) {
                    phi_73_ = type_9((_e34.member + 1u), _e34.member_1);
                    phi_96_ = type_9(1u, _e34.member);
                } else {
                    phi_73_ = _e34;
                    phi_96_ = type_9(0u, type_9().member_1);
                }
                let _e47 = phi_73_;
                let _e49 = phi_96_;
                let _e53 = (bitcast<i32>(_e49.member) != 0i);
                if _e53 {
                    if (_e49.member_1 < 16u) {
                    } else {
                        phi_303_ = true;
                        break;
                    }
                    let _e55 = (_e25 % 64u);
                    if (_e55 < 64u) {
                    } else {
                        phi_303_ = true;
                        break;
                    }
                    global_5[_e49.member_1][_e55] = 0u;
                }
                continue;
                continuing {
                    phi_72_ = _e47;
                    phi_303_ = false;
                    break if !(_e53);
                }
            }
            let _e61 = phi_303_;
            if _e61 {
                break;
            }
            let _e65 = (_e24.x + (_e24.y * 32768u));
            let _e68 = ((_e65 * 1024u) + (_e25 * 16u));
            let _e70 = select(_e27, _e68, (_e68 < _e27));
            let _e71 = (_e27 - _e70);
            phi_138_ = type_9(_e70, (_e70 + select(16u, _e71, (_e71 < 16u))));
            loop {
                let _e77 = phi_138_;
                if (_e77.member < _e77.member_1) {
                    phi_139_ = type_9((_e77.member + 1u), _e77.member_1);
                    phi_162_ = type_9(1u, _e77.member);
                } else {
                    phi_139_ = _e77;
                    phi_162_ = type_9(0u, type_9().member_1);
                }
                let _e90 = phi_139_;
                let _e92 = phi_162_;
                let _e96 = (bitcast<i32>(_e92.member) != 0i);
                if _e96 {
                    if (_e92.member_1 < _e27) {
                    } else {
                        phi_307_ = true;
                        break;
                    }
                    let _e100 = global_3.member[_e92.member_1];
                    let _e106 = (((_e100[0] >> bitcast<u32>((_e32 & 31u))) & 15u) % 16u);
                    if (_e106 < 16u) {
                    } else {
                        phi_307_ = true;
                        break;
                    }
                    let _e108 = (_e25 % 64u);
                    if (_e108 < 64u) {
                    } else {
                        phi_307_ = true;
                        break;
                    }
                    let _e112 = global_5[_e106][_e108];
                    global_5[_e106][_e108] = (_e112 + 1u);
                }
                continue;
                continuing {
                    phi_138_ = _e90;
                    phi_307_ = _e61;
                    break if !(_e96);
                }
            }
            let _e116 = phi_307_;
            if _e116 {
                break;
            }
            workgroupBarrier();
            let _e117 = (_e27 / 1024u);
            if ((_e27 % 1024u) > 0u) {
                phi_216_ = (_e117 + 1u);
            } else {
                phi_216_ = _e117;
            }
            let _e122 = phi_216_;
            let _e124 = ((_e25 * _e122) + _e65);
            if (_e25 < 16u) {
                if (_e65 < _e122) {
                    let _e127 = (_e124 < arrayLength((&global_4.member)));
                    if _e127 {
                        phi_237_ = type_9(0u, 64u);
                        phi_240_ = 0u;
                        loop {
                            let _e129 = phi_237_;
                            let _e131 = phi_240_;
                            local = _e131;
                            if (_e129.member < _e129.member_1) {
                                phi_238_ = type_9((_e129.member + 1u), _e129.member_1);
                                phi_263_ = type_9(1u, _e129.member);
                            } else {
                                phi_238_ = _e129;
                                phi_263_ = type_9(0u, type_9().member_1);
                            }
                            let _e144 = phi_238_;
                            let _e146 = phi_263_;
                            let _e150 = (bitcast<i32>(_e146.member) != 0i);
                            if _e150 {
                                let _e151 = (_e25 % 16u);
                                if (_e151 < 16u) {
                                } else {
                                    phi_313_ = true;
                                    break;
                                }
                                if (_e146.member_1 < 64u) {
                                } else {
                                    phi_313_ = true;
                                    break;
                                }
                                let _e156 = global_5[_e151][_e146.member_1];
                                phi_241_ = (_e131 + _e156);
                            } else {
                                phi_241_ = u32();
                            }
                            let _e159 = phi_241_;
                            continue;
                            continuing {
                                phi_237_ = _e144;
                                phi_240_ = _e159;
                                phi_313_ = _e116;
                                break if !(_e150);
                            }
                        }
                        let _e162 = phi_313_;
                        if _e162 {
                            break;
                        }
                        if _e127 {
                        } else {
                            break;
                        }
                        let _e166 = local;
                        global_4.member[_e124] = _e166;
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn sort_count_30_(@builtin(workgroup_id) param: vec3<u32>, @builtin(local_invocation_index) param_1: u32) {
    global = param;
    global_1 = param_1;
    function_();
}
