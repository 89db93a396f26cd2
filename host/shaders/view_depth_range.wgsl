struct type_2 {
    member: u32,
    member_1: u32,
}

struct type_7 {
    member: array<array<u32, 4>>,
}

struct type_11 {
    member: array<array<u32, 2>>,
}

@group(0) @binding(0) 
var<storage> global: type_11;
@group(0) @binding(1) 
var<storage, read_write> global_1: type_7;

fn function_() {
    var phi_54_: type_2;
    var phi_57_: u32;
    var phi_59_: u32;
    var phi_55_: type_2;
    var phi_82_: type_2;
    var phi_107_: array<u32, 2>;
    var phi_117_: u32;
    var phi_118_: u32;
    var phi_119_: u32;
    var phi_120_: u32;
    var phi_58_: u32;
    var phi_60_: u32;
    var phi_122_: bool;
    var phi_174_: bool;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var phi_141_: array<u32, 2>;
    var phi_154_: array<u32, 2>;
    var phi_157_: array<u32, 2>;

    switch bitcast<i32>(0u) {
        default: {
            let _e20 = arrayLength((&global.member));
            let _e22 = arrayLength((&global_1.member));
            if (_e22 == 0u) {
            } else {
                phi_54_ = type_2(0u, 32u);
                phi_57_ = _e20;
                phi_59_ = 0u;
                loop {
                    let _e25 = phi_54_;
                    let _e27 = phi_57_;
                    let _e29 = phi_59_;
                    local = _e29;
                    local_1 = _e29;
                    local_2 = _e29;
                    if (_e25.member < _e25.member_1) {
                        phi_55_ = type_2((_e25.member + 1u), _e25.member_1);
                        phi_82_ = type_2(1u, _e25.member);
                    } else {
                        phi_55_ = _e25;
                        phi_82_ = type_2(0u, type_2().member_1);
                    }
                    let _e42 = phi_55_;
                    let _e44 = phi_82_;
                    if (bitcast<i32>(_e44.member) != 0i) {
                        let _e48 = (_e27 == 0u);
                        if _e48 {
                            phi_119_ = u32();
                            phi_120_ = u32();
                        } else {
                            let _e49 = (_e27 / 2u);
                            let _e50 = (_e29 + _e49);
                            let _e51 = (_e50 < _e20);
                            if _e51 {
                                if _e51 {
                                } else {
                                    phi_174_ = true;
                                    break;
                                }
                                let _e54 = global.member[_e50];
                                phi_107_ = _e54;
                            } else {
                                phi_107_ = array<u32, 2>(2139095039u, 2139095039u);
                            }
                            let _e56 = phi_107_;
                            if (_e56[0] < 2139095039u) {
                                let _e59 = (_e49 + 1u);
                                phi_117_ = (_e27 - _e59);
                                phi_118_ = (_e29 + _e59);
                            } else {
                                phi_117_ = _e49;
                                phi_118_ = _e29;
                            }
                            let _e63 = phi_117_;
                            let _e65 = phi_118_;
                            phi_119_ = _e63;
                            phi_120_ = _e65;
                        }
                        let _e67 = phi_119_;
                        let _e69 = phi_120_;
                        phi_58_ = _e67;
                        phi_60_ = _e69;
                        phi_122_ = select(true, false, _e48);
                    } else {
                        phi_58_ = u32();
                        phi_60_ = u32();
                        phi_122_ = false;
                    }
                    let _e72 = phi_58_;
                    let _e74 = phi_60_;
                    let _e76 = phi_122_;
                    continue;
                    continuing {
                        phi_54_ = _e42;
                        phi_57_ = _e72;
                        phi_59_ = _e74;
                        phi_174_ = false;
                        break if !(_e76);
                    }
                }
                let _e79 = phi_174_;
                if _e79 {
                    break;
                }
                let _e81 = local;
                if (_e81 == 0u) {
                    phi_157_ = array<u32, 2>(0u, 0u);
                } else {
                    let _e84 = local_1;
                    let _e87 = local_2;
                    let _e89 = ((_e84 - 1u) - (_e87 / 100u));
                    let _e90 = (0u < _e20);
                    if _e90 {
                        if _e90 {
                        } else {
                            break;
                        }
                        let _e93 = global.member[0u];
                        phi_141_ = _e93;
                    } else {
                        phi_141_ = array<u32, 2>(0u, 0u);
                    }
                    let _e95 = phi_141_;
                    let _e97 = (_e89 < _e20);
                    if _e97 {
                        if _e97 {
                        } else {
                            break;
                        }
                        let _e100 = global.member[_e89];
                        phi_154_ = _e100;
                    } else {
                        phi_154_ = array<u32, 2>(0u, 0u);
                    }
                    let _e102 = phi_154_;
                    phi_157_ = array<u32, 2>(_e95[0], _e102[0]);
                }
                let _e106 = phi_157_;
                if (0u < _e22) {
                } else {
                    break;
                }
                global_1.member[0u][0u] = _e106[0];
                global_1.member[0u][1u] = _e106[1];
                global_1.member[0u][2u] = 0u;
                global_1.member[0u][3u] = 0u;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(1, 1, 1) 
fn view_depth_range() {
    function_();
}
