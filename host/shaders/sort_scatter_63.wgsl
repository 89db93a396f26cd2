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
var<workgroup> global_3: array<array<u32, 64>, 16>;
@group(0) @binding(1) 
var<storage> global_4: type_18;
@group(0) @binding(2) 
var<storage> global_5: type_5;
@group(0) @binding(3) 
var<storage, read_write> global_6: type_18;

fn function_() {
    var local: array<u32, 16>;
    var local_1: array<u32, 16>;
    var phi_85_: type_9;
    var phi_86_: type_9;
    var phi_109_: type_9;
    var phi_651_: bool;
    var phi_151_: type_9;
    var phi_152_: type_9;
    var phi_175_: type_9;
    var phi_196_: u32;
    var phi_655_: bool;
    var phi_236_: u32;
    var phi_243_: type_9;
    var phi_244_: type_9;
    var phi_267_: type_9;
    var phi_662_: bool;
    var phi_672_: bool;
    var phi_297_: type_9;
    var phi_300_: u32;
    var phi_298_: type_9;
    var phi_323_: type_9;
    var phi_332_: type_9;
    var phi_333_: type_9;
    var phi_356_: type_9;
    var phi_392_: u32;
    var phi_667_: bool;
    var phi_401_: type_9;
    var phi_402_: type_9;
    var phi_425_: type_9;
    var phi_674_: bool;
    var phi_679_: bool;
    var phi_301_: u32;
    var phi_678_: bool;
    var phi_456_: type_9;
    var phi_457_: type_9;
    var phi_480_: type_9;
    var phi_501_: u32;
    var phi_680_: bool;
    var phi_554_: type_9;
    var phi_555_: type_9;
    var phi_578_: type_9;
    var phi_599_: u32;
    var phi_685_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e31 = global;
            let _e32 = global_1;
            let _e34 = arrayLength((&global_4.member));
            let _e41 = global_2.member[0u];
            phi_85_ = type_9(0u, 16u);
            loop {
                let _e43 = phi_85_;
                if (_e43.member < _e43.member_1) {
                    phi_86_ = type_9((_e43.member + 1u), _e43.member_1);
                    phi_109_ = type_9(1u, _e43.member);
                } else {
                    phi_86_ = _e43;
                    phi_109_ = type_9(0u, type_9().member_1);
                }
                let _e56 = phi_86_;
                let _e58 = phi_109_;
                let _e62 = (bitcast<i32>(_e58.member) != 0i);
                if _e62 {
                    if (_e58.member_1 < 16u) {
                    } else {
                        phi_651_ = true;
                        break;
                    }
                    let _e64 = (_e32 % 64u);
                    if (_e64 < 64u) {
                    } else {
                        phi_651_ = true;
                        break;
                    }
                    global_3[_e58.member_1][_e64] = 0u;
                }
                continue;
                continuing {
                    phi_85_ = _e56;
                    phi_651_ = false;
                    break if !(_e62);
                }
            }
            let _e70 = phi_651_;
            if _e70 {
                break;
            }
            let _e74 = (_e31.x + (_e31.y * 32768u));
            let _e77 = ((_e74 * 1024u) + (_e32 * 16u));
            let _e79 = select(_e34, _e77, (_e77 < _e34));
            let _e80 = (_e34 - _e79);
            let _e84 = type_9(_e79, (_e79 + select(16u, _e80, (_e80 < 16u))));
            phi_151_ = _e84;
            loop {
                let _e86 = phi_151_;
                if (_e86.member < _e86.member_1) {
                    phi_152_ = type_9((_e86.member + 1u), _e86.member_1);
                    phi_175_ = type_9(1u, _e86.member);
                } else {
                    phi_152_ = _e86;
                    phi_175_ = type_9(0u, type_9().member_1);
                }
                let _e99 = phi_152_;
                let _e101 = phi_175_;
                let _e105 = (bitcast<i32>(_e101.member) != 0i);
                if _e105 {
                    if (_e101.member_1 < _e34) {
                    } else {
                        phi_655_ = true;
                        break;
                    }
                    let _e109 = global_4.member[_e101.member_1];
                    if (_e41 < 32u) {
                        phi_196_ = _e109[1];
                    } else {
                        phi_196_ = _e109[0];
                    }
                    let _e114 = phi_196_;
                    let _e120 = (((_e114 >> bitcast<u32>(((_e41 & 31u) & 31u))) & 15u) % 16u);
                    if (_e120 < 16u) {
                    } else {
                        phi_655_ = true;
                        break;
                    }
                    let _e122 = (_e32 % 64u);
                    if (_e122 < 64u) {
                    } else {
                        phi_655_ = true;
                        break;
                    }
                    let _e126 = global_3[_e120][_e122];
                    global_3[_e120][_e122] = (_e126 + 1u);
                }
                continue;
                continuing {
                    phi_151_ = _e99;
                    phi_655_ = _e70;
                    break if !(_e105);
                }
            }
            let _e130 = phi_655_;
            if _e130 {
                break;
            }
            workgroupBarrier();
            let _e131 = (_e34 / 1024u);
            if ((_e34 % 1024u) > 0u) {
                phi_236_ = (_e131 + 1u);
            } else {
                phi_236_ = _e131;
            }
            let _e136 = phi_236_;
            local = array<u32, 16>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
            local_1 = array<u32, 16>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
            phi_243_ = type_9(0u, 16u);
            loop {
                let _e138 = phi_243_;
                if (_e138.member < _e138.member_1) {
                    phi_244_ = type_9((_e138.member + 1u), _e138.member_1);
                    phi_267_ = type_9(1u, _e138.member);
                } else {
                    phi_244_ = _e138;
                    phi_267_ = type_9(0u, type_9().member_1);
                }
                let _e151 = phi_244_;
                let _e153 = phi_267_;
                let _e157 = (bitcast<i32>(_e153.member) != 0i);
                if _e157 {
                    let _e158 = (_e153.member_1 < 16u);
                    if _e158 {
                    } else {
                        phi_662_ = true;
                        break;
                    }
                    let _e159 = (_e32 % 64u);
                    if (_e159 < 64u) {
                    } else {
                        phi_662_ = true;
                        break;
                    }
                    let _e163 = global_3[_e153.member_1][_e159];
                    if _e158 {
                    } else {
                        phi_662_ = true;
                        break;
                    }
                    local[_e153.member_1] = _e163;
                }
                continue;
                continuing {
                    phi_243_ = _e151;
                    phi_662_ = _e130;
                    break if !(_e157);
                }
            }
            let _e167 = phi_662_;
            if _e167 {
                break;
            }
            phi_672_ = _e167;
            phi_297_ = type_9(0u, 6u);
            phi_300_ = 1u;
            loop {
                let _e169 = phi_672_;
                let _e171 = phi_297_;
                let _e173 = phi_300_;
                if (_e171.member < _e171.member_1) {
                    phi_298_ = type_9((_e171.member + 1u), _e171.member_1);
                    phi_323_ = type_9(1u, _e171.member);
                } else {
                    phi_298_ = _e171;
                    phi_323_ = type_9(0u, type_9().member_1);
                }
                let _e186 = phi_298_;
                let _e188 = phi_323_;
                let _e191 = (bitcast<i32>(_e188.member) != 0i);
                if _e191 {
                    phi_332_ = type_9(0u, 16u);
                    loop {
                        let _e193 = phi_332_;
                        if (_e193.member < _e193.member_1) {
                            phi_333_ = type_9((_e193.member + 1u), _e193.member_1);
                            phi_356_ = type_9(1u, _e193.member);
                        } else {
                            phi_333_ = _e193;
                            phi_356_ = type_9(0u, type_9().member_1);
                        }
                        let _e206 = phi_333_;
                        let _e208 = phi_356_;
                        let _e212 = (bitcast<i32>(_e208.member) != 0i);
                        if _e212 {
                            let _e213 = (_e208.member_1 < 16u);
                            if _e213 {
                            } else {
                                phi_667_ = true;
                                break;
                            }
                            let _e214 = (_e32 % 64u);
                            if (_e214 < 64u) {
                            } else {
                                phi_667_ = true;
                                break;
                            }
                            let _e218 = global_3[_e208.member_1][_e214];
                            if (_e32 >= _e173) {
                                let _e221 = ((_e32 - _e173) % 64u);
                                if (_e221 < 64u) {
                                } else {
                                    phi_667_ = true;
                                    break;
                                }
                                let _e225 = global_3[_e208.member_1][_e221];
                                phi_392_ = (_e218 + _e225);
                            } else {
                                phi_392_ = _e218;
                            }
                            let _e228 = phi_392_;
                            if _e213 {
                            } else {
                                phi_667_ = true;
                                break;
                            }
                            local_1[_e208.member_1] = _e228;
                        }
                        continue;
                        continuing {
                            phi_332_ = _e206;
                            phi_667_ = _e169;
                            break if !(_e212);
                        }
                    }
                    let _e232 = phi_667_;
                    phi_678_ = _e232;
                    if _e232 {
                        break;
                    }
                    workgroupBarrier();
                    phi_401_ = type_9(0u, 16u);
                    loop {
                        let _e234 = phi_401_;
                        if (_e234.member < _e234.member_1) {
                            phi_402_ = type_9((_e234.member + 1u), _e234.member_1);
                            phi_425_ = type_9(1u, _e234.member);
                        } else {
                            phi_402_ = _e234;
                            phi_425_ = type_9(0u, type_9().member_1);
                        }
                        let _e247 = phi_402_;
                        let _e249 = phi_425_;
                        let _e253 = (bitcast<i32>(_e249.member) != 0i);
                        if _e253 {
                            let _e254 = (_e249.member_1 < 16u);
                            if _e254 {
                            } else {
                                phi_674_ = true;
                                break;
                            }
                            let _e256 = local_1[_e249.member_1];
                            if _e254 {
                            } else {
                                phi_674_ = true;
                                break;
                            }
                            let _e257 = (_e32 % 64u);
                            if (_e257 < 64u) {
                            } else {
                                phi_674_ = true;
                                break;
                            }
                            global_3[_e249.member_1][_e257] = _e256;
                        }
                        continue;
                        continuing {
                            phi_401_ = _e247;
                            phi_674_ = _e232;
                            break if !(_e253);
                        }
                    }
                    let _e263 = phi_674_;
                    phi_678_ = _e263;
                    if _e263 {
                        break;
                    }
                    workgroupBarrier();
                    phi_679_ = _e263;
                    phi_301_ = (_e173 * 2u);
                } else {
                    phi_679_ = _e169;
                    phi_301_ = u32();
                }
                let _e266 = phi_679_;
                let _e268 = phi_301_;
                continue;
                continuing {
                    phi_672_ = _e266;
                    phi_297_ = _e186;
                    phi_300_ = _e268;
                    phi_678_ = _e266;
                    break if !(_e191);
                }
            }
            let _e271 = phi_678_;
            if _e271 {
                break;
            }
            phi_456_ = type_9(0u, 16u);
            loop {
                let _e273 = phi_456_;
                if (_e273.member < _e273.member_1) {
                    phi_457_ = type_9((_e273.member + 1u), _e273.member_1);
                    phi_480_ = type_9(1u, _e273.member);
                } else {
                    phi_457_ = _e273;
                    phi_480_ = type_9(0u, type_9().member_1);
                }
                let _e286 = phi_457_;
                let _e288 = phi_480_;
                let _e292 = (bitcast<i32>(_e288.member) != 0i);
                if _e292 {
                    let _e294 = ((_e288.member_1 * _e136) + _e74);
                    let _e295 = (_e294 < arrayLength((&global_5.member)));
                    if _e295 {
                        if _e295 {
                        } else {
                            phi_680_ = true;
                            break;
                        }
                        let _e298 = global_5.member[_e294];
                        phi_501_ = _e298;
                    } else {
                        phi_501_ = 0u;
                    }
                    let _e300 = phi_501_;
                    let _e301 = (_e288.member_1 < 16u);
                    if _e301 {
                    } else {
                        phi_680_ = true;
                        break;
                    }
                    let _e303 = local_1[_e288.member_1];
                    if _e301 {
                    } else {
                        phi_680_ = true;
                        break;
                    }
                    let _e305 = local[_e288.member_1];
                    if _e301 {
                    } else {
                        phi_680_ = true;
                        break;
                    }
                    let _e308 = (_e32 % 64u);
                    if (_e308 < 64u) {
                    } else {
                        phi_680_ = true;
                        break;
                    }
                    global_3[_e288.member_1][_e308] = (_e300 + (_e303 - _e305));
                }
                continue;
                continuing {
                    phi_456_ = _e286;
                    phi_680_ = _e271;
                    break if !(_e292);
                }
            }
            let _e314 = phi_680_;
            if _e314 {
                break;
            }
            phi_554_ = _e84;
            loop {
                let _e316 = phi_554_;
                if (_e316.member < _e316.member_1) {
                    phi_555_ = type_9((_e316.member + 1u), _e316.member_1);
                    phi_578_ = type_9(1u, _e316.member);
                } else {
                    phi_555_ = _e316;
                    phi_578_ = type_9(0u, type_9().member_1);
                }
                let _e329 = phi_555_;
                let _e331 = phi_578_;
                let _e335 = (bitcast<i32>(_e331.member) != 0i);
                if _e335 {
                    if (_e331.member_1 < _e34) {
                    } else {
                        phi_685_ = true;
                        break;
                    }
                    let _e339 = global_4.member[_e331.member_1];
                    if (_e41 < 32u) {
                        phi_599_ = _e339[1];
                    } else {
                        phi_599_ = _e339[0];
                    }
                    let _e344 = phi_599_;
                    let _e350 = (((_e344 >> bitcast<u32>(((_e41 & 31u) & 31u))) & 15u) % 16u);
                    if (_e350 < 16u) {
                    } else {
                        phi_685_ = true;
                        break;
                    }
                    let _e352 = (_e32 % 64u);
                    if (_e352 < 64u) {
                    } else {
                        phi_685_ = true;
                        break;
                    }
                    let _e356 = global_3[_e350][_e352];
                    global_3[_e350][_e352] = (_e356 + 1u);
                    let _e358 = (_e356 < arrayLength((&global_6.member)));
                    if _e358 {
                        if _e358 {
                        } else {
                            phi_685_ = true;
                            break;
                        }
                        global_6.member[_e356] = _e339;
                    }
                }
                continue;
                continuing {
                    phi_554_ = _e329;
                    phi_685_ = _e314;
                    break if !(_e335);
                }
            }
            let _e363 = phi_685_;
            if _e363 {
                break;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn sort_scatter_63_(@builtin(workgroup_id) param: vec3<u32>, @builtin(local_invocation_index) param_1: u32) {
    global = param;
    global_1 = param_1;
    function_();
}
