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

struct type_18 {
    member: array<array<u32, 3>>,
}

var<private> global: vec3<u32>;
var<private> global_1: u32;
@group(0) @binding(0) 
var<uniform> global_2: type_14;
@group(0) @binding(2) 
var<storage, read_write> global_3: type_5;
var<workgroup> global_4: array<array<u32, 64>, 16>;
@group(0) @binding(1) 
var<storage> global_5: type_18;

fn function_() {
    var phi_74_: type_9;
    var phi_75_: type_9;
    var phi_98_: type_9;
    var phi_312_: bool;
    var phi_140_: type_9;
    var phi_141_: type_9;
    var phi_164_: type_9;
    var phi_185_: u32;
    var phi_316_: bool;
    var phi_225_: u32;
    var phi_246_: type_9;
    var phi_249_: u32;
    var phi_247_: type_9;
    var phi_272_: type_9;
    var phi_250_: u32;
    var phi_323_: bool;
    var local: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e26 = global;
            let _e27 = global_1;
            let _e29 = arrayLength((&global_5.member));
            let _e34 = global_2.member[0u];
            phi_74_ = type_9(0u, 16u);
            loop {
                let _e36 = phi_74_;
                if (_e36.member < _e36.member_1) {
                    phi_75_ = type_9((_e36.member + 1u), _e36.member_1);
                    phi_98_ = type_9(1u, _e36.member);
                } else {
                    phi_75_ = _e36;
                    phi_98_ = type_9(0u, type_9().member_1);
                }
                let _e49 = phi_75_;
                let _e51 = phi_98_;
                let _e55 = (bitcast<i32>(_e51.member) != 0i);
                if _e55 {
                    if (_e51.member_1 < 16u) {
                    } else {
                        phi_312_ = true;
                        break;
                    }
                    let _e57 = (_e27 % 64u);
                    if (_e57 < 64u) {
                    } else {
                        phi_312_ = true;
                        break;
                    }
                    global_4[_e51.member_1][_e57] = 0u;
                }
                continue;
                continuing {
                    phi_74_ = _e49;
                    phi_312_ = false;
                    break if !(_e55);
                }
            }
            let _e63 = phi_312_;
            if _e63 {
                break;
            }
            let _e67 = (_e26.x + (_e26.y * 32768u));
            let _e70 = ((_e67 * 1024u) + (_e27 * 16u));
            let _e72 = select(_e29, _e70, (_e70 < _e29));
            let _e73 = (_e29 - _e72);
            phi_140_ = type_9(_e72, (_e72 + select(16u, _e73, (_e73 < 16u))));
            loop {
                let _e79 = phi_140_;
                if (_e79.member < _e79.member_1) {
                    phi_141_ = type_9((_e79.member + 1u), _e79.member_1);
                    phi_164_ = type_9(1u, _e79.member);
                } else {
                    phi_141_ = _e79;
                    phi_164_ = type_9(0u, type_9().member_1);
                }
                let _e92 = phi_141_;
                let _e94 = phi_164_;
                let _e98 = (bitcast<i32>(_e94.member) != 0i);
                if _e98 {
                    if (_e94.member_1 < _e29) {
                    } else {
                        phi_316_ = true;
                        break;
                    }
                    let _e102 = global_5.member[_e94.member_1];
                    if (_e34 < 32u) {
                        phi_185_ = _e102[1];
                    } else {
                        phi_185_ = _e102[0];
                    }
                    let _e107 = phi_185_;
                    let _e113 = (((_e107 >> bitcast<u32>(((_e34 & 31u) & 31u))) & 15u) % 16u);
                    if (_e113 < 16u) {
                    } else {
                        phi_316_ = true;
                        break;
                    }
                    let _e115 = (_e27 % 64u);
                    if (_e115 < 64u) {
                    } else {
                        phi_316_ = true;
                        break;
                    }
                    let _e119 = global_4[_e113][_e115];
                    global_4[_e113][_e115] = (_e119 + 1u);
                }
                continue;
                continuing {
                    phi_140_ = _e92;
                    phi_316_ = _e63;
                    break if !(_e98);
                }
            }
            let _e123 = phi_316_;
            if _e123 {
                break;
            }
            workgroupBarrier();
            let _e124 = (_e29 / 1024u);
            if ((_e29 % 1024u) > 0u) {
                phi_225_ = (_e124 + 1u);
            } else {
                phi_225_ = _e124;
            }
            let _e129 = phi_225_;
            let _e131 = ((_e27 * _e129) + _e67);
            if (_e27 < 16u) {
                if (_e67 < _e129) {
                    let _e134 = (_e131 < arrayLength((&global_3.member)));
                    if _e134 {
                        phi_246_ = type_9(0u, 64u);
                        phi_249_ = 0u;
                        loop {
                            let _e136 = phi_246_;
                            let _e138 = phi_249_;
                            local = _e138;
                            if (_e136.member < _e136.member_1) {
                                phi_247_ = type_9((_e136.member + 1u), _e136.member_1);
                                phi_272_ = type_9(1u, _e136.member);
                            } else {
                                phi_247_ = _e136;
                                phi_272_ = type_9(0u, type_9().member_1);
                            }
                            let _e151 = phi_247_;
                            let _e153 = phi_272_;
                            let _e157 = (bitcast<i32>(_e153.member) != 0i);
                            if _e157 {
                                let _e158 = (_e27 % 16u);
                                if (_e158 < 16u) {
                                } else {
                                    phi_323_ = true;
                                    break;
                                }
                                if (_e153.member_1 < 64u) {
                                } else {
                                    phi_323_ = true;
                                    break;
                                }
                                let _e163 = global_4[_e158][_e153.member_1];
                                phi_250_ = (_e138 + _e163);
                            } else {
                                phi_250_ = u32();
                            }
                            let _e166 = phi_250_;
                            continue;
                            continuing {
                                phi_246_ = _e151;
                                phi_249_ = _e166;
                                phi_323_ = _e123;
                                break if !(_e157);
                            }
                        }
                        let _e169 = phi_323_;
                        if _e169 {
                            break;
                        }
                        if _e134 {
                        } else {
                            break;
                        }
                        let _e173 = local;
                        global_3.member[_e131] = _e173;
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn sort_count_63_(@builtin(workgroup_id) param: vec3<u32>, @builtin(local_invocation_index) param_1: u32) {
    global = param;
    global_1 = param_1;
    function_();
}
