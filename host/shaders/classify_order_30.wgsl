struct type_5 {
    member: array<u32>,
}

struct type_10 {
    member: u32,
    member_1: u32,
}

struct type_16 {
    member: array<array<u32, 2>>,
}

var<private> global: u32;
var<private> global_1: vec3<u32>;
@group(0) @binding(0) 
var<storage> global_2: type_16;
@group(0) @binding(1) 
var<storage> global_3: type_5;
@group(0) @binding(2) 
var<storage, read_write> global_4: type_5;
@group(0) @binding(3) 
var<storage, read_write> global_5: type_5;
var<workgroup> global_6: array<u32, 64>;

fn function_() {
    var phi_93_: u32;
    var phi_100_: u32;
    var phi_128_: type_10;
    var phi_131_: u32;
    var phi_129_: type_10;
    var phi_154_: type_10;
    var phi_132_: u32;
    var phi_194_: bool;
    var local: u32;
    var local_1: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e23 = global_1;
            let _e24 = global;
            let _e36 = (_e23.x + (_e23.y * 2097152u));
            let _e37 = (_e36 < arrayLength((&global_2.member)));
            if _e37 {
                if _e37 {
                } else {
                    break;
                }
                let _e41 = global_2.member[_e36][1u];
                let _e43 = (_e41 >> bitcast<u32>(5i));
                let _e44 = (_e43 < arrayLength((&global_3.member)));
                if _e44 {
                    if _e44 {
                    } else {
                        break;
                    }
                    let _e47 = global_3.member[_e43];
                    phi_93_ = _e47;
                } else {
                    phi_93_ = 0u;
                }
                let _e49 = phi_93_;
                phi_100_ = select(0u, 1u, (((_e49 >> bitcast<u32>(((_e41 & 31u) & 31u))) & 1u) == 1u));
            } else {
                phi_100_ = 0u;
            }
            let _e58 = phi_100_;
            let _e59 = (_e24 % 64u);
            if (_e59 < 64u) {
            } else {
                break;
            }
            global_6[_e59] = _e58;
            workgroupBarrier();
            let _e62 = (_e36 / 32u);
            if ((_e24 & 31u) == 0u) {
                let _e65 = (_e62 < arrayLength((&global_4.member)));
                if _e65 {
                    let _e66 = (_e62 < arrayLength((&global_5.member)));
                    if _e66 {
                        phi_128_ = type_10(0u, 32u);
                        phi_131_ = 0u;
                        loop {
                            let _e68 = phi_128_;
                            let _e70 = phi_131_;
                            local = _e70;
                            local_1 = _e70;
                            if (_e68.member < _e68.member_1) {
                                phi_129_ = type_10((_e68.member + 1u), _e68.member_1);
                                phi_154_ = type_10(1u, _e68.member);
                            } else {
                                phi_129_ = _e68;
                                phi_154_ = type_10(0u, type_10().member_1);
                            }
                            let _e83 = phi_129_;
                            let _e85 = phi_154_;
                            let _e89 = (bitcast<i32>(_e85.member) != 0i);
                            if _e89 {
                                let _e91 = ((_e24 + _e85.member_1) % 64u);
                                if (_e91 < 64u) {
                                } else {
                                    phi_194_ = true;
                                    break;
                                }
                                let _e94 = global_6[_e91];
                                phi_132_ = (_e70 | (_e94 << bitcast<u32>((_e85.member_1 & 31u))));
                            } else {
                                phi_132_ = u32();
                            }
                            let _e100 = phi_132_;
                            continue;
                            continuing {
                                phi_128_ = _e83;
                                phi_131_ = _e100;
                                phi_194_ = false;
                                break if !(_e89);
                            }
                        }
                        let _e103 = phi_194_;
                        if _e103 {
                            break;
                        }
                        if _e65 {
                        } else {
                            break;
                        }
                        let _e107 = local;
                        global_4.member[_e62] = _e107;
                        let _e109 = local_1;
                        if _e66 {
                        } else {
                            break;
                        }
                        global_5.member[_e62] = countOneBits(_e109);
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn classify_order_30_(@builtin(global_invocation_id) param: vec3<u32>, @builtin(local_invocation_index) param_1: u32) {
    global_1 = param;
    global = param_1;
    function_();
}
