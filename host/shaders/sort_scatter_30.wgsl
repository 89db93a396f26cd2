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
var<workgroup> global_4: array<array<u32, 64>, 16>;
@group(0) @binding(2) 
var<storage> global_5: type_5;
@group(0) @binding(3) 
var<storage, read_write> global_6: type_19;

fn function_() {
    var local: array<u32, 16>;
    var local_1: array<u32, 16>;
    var phi_83_: type_9;
    var phi_84_: type_9;
    var phi_107_: type_9;
    var phi_635_: bool;
    var phi_149_: type_9;
    var phi_150_: type_9;
    var phi_173_: type_9;
    var phi_639_: bool;
    var phi_227_: u32;
    var phi_234_: type_9;
    var phi_235_: type_9;
    var phi_258_: type_9;
    var phi_645_: bool;
    var phi_655_: bool;
    var phi_288_: type_9;
    var phi_291_: u32;
    var phi_289_: type_9;
    var phi_314_: type_9;
    var phi_323_: type_9;
    var phi_324_: type_9;
    var phi_347_: type_9;
    var phi_383_: u32;
    var phi_650_: bool;
    var phi_392_: type_9;
    var phi_393_: type_9;
    var phi_416_: type_9;
    var phi_657_: bool;
    var phi_662_: bool;
    var phi_292_: u32;
    var phi_661_: bool;
    var phi_447_: type_9;
    var phi_448_: type_9;
    var phi_471_: type_9;
    var phi_492_: u32;
    var phi_663_: bool;
    var phi_545_: type_9;
    var phi_546_: type_9;
    var phi_569_: type_9;
    var phi_668_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e29 = global;
            let _e30 = global_1;
            let _e32 = arrayLength((&global_3.member));
            let _e39 = global_2.member[0u];
            phi_83_ = type_9(0u, 16u);
            loop {
                let _e41 = phi_83_;
                if (_e41.member < _e41.member_1) {
                    phi_84_ = type_9((_e41.member + 1u), _e41.member_1);
                    phi_107_ = type_9(1u, _e41.member);
                } else {
                    phi_84_ = _e41;
                    phi_107_ = type_9(0u, type_9().member_1);
                }
                let _e54 = phi_84_;
                let _e56 = phi_107_;
                let _e60 = (bitcast<i32>(_e56.member) != 0i);
                if _e60 {
                    if (_e56.member_1 < 16u) {
                    } else {
                        phi_635_ = true;
                        break;
                    }
                    let _e62 = (_e30 % 64u);
                    if (_e62 < 64u) {
                    } else {
                        phi_635_ = true;
                        break;
                    }
                    global_4[_e56.member_1][_e62] = 0u;
                }
                continue;
                continuing {
                    phi_83_ = _e54;
                    phi_635_ = false;
                    break if !(_e60);
                }
            }
            let _e68 = phi_635_;
            if _e68 {
                break;
            }
            let _e72 = (_e29.x + (_e29.y * 32768u));
            let _e75 = ((_e72 * 1024u) + (_e30 * 16u));
            let _e77 = select(_e32, _e75, (_e75 < _e32));
            let _e78 = (_e32 - _e77);
            let _e82 = type_9(_e77, (_e77 + select(16u, _e78, (_e78 < 16u))));
            phi_149_ = _e82;
            loop {
                let _e84 = phi_149_;
                if (_e84.member < _e84.member_1) {
                    phi_150_ = type_9((_e84.member + 1u), _e84.member_1);
                    phi_173_ = type_9(1u, _e84.member);
                } else {
                    phi_150_ = _e84;
                    phi_173_ = type_9(0u, type_9().member_1);
                }
                let _e97 = phi_150_;
                let _e99 = phi_173_;
                let _e103 = (bitcast<i32>(_e99.member) != 0i);
                if _e103 {
                    if (_e99.member_1 < _e32) {
                    } else {
                        phi_639_ = true;
                        break;
                    }
                    let _e107 = global_3.member[_e99.member_1];
                    let _e113 = (((_e107[0] >> bitcast<u32>((_e39 & 31u))) & 15u) % 16u);
                    if (_e113 < 16u) {
                    } else {
                        phi_639_ = true;
                        break;
                    }
                    let _e115 = (_e30 % 64u);
                    if (_e115 < 64u) {
                    } else {
                        phi_639_ = true;
                        break;
                    }
                    let _e119 = global_4[_e113][_e115];
                    global_4[_e113][_e115] = (_e119 + 1u);
                }
                continue;
                continuing {
                    phi_149_ = _e97;
                    phi_639_ = _e68;
                    break if !(_e103);
                }
            }
            let _e123 = phi_639_;
            if _e123 {
                break;
            }
            workgroupBarrier();
            let _e124 = (_e32 / 1024u);
            if ((_e32 % 1024u) > 0u) {
                phi_227_ = (_e124 + 1u);
            } else {
                phi_227_ = _e124;
            }
            let _e129 = phi_227_;
            local = array<u32, 16>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
            local_1 = array<u32, 16>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
            phi_234_ = type_9(0u, 16u);
            loop {
                let _e131 = phi_234_;
                if (_e131.member < _e131.member_1) {
                    phi_235_ = type_9((_e131.member + 1u), _e131.member_1);
                    phi_258_ = type_9(1u, _e131.member);
                } else {
                    phi_235_ = _e131;
                    phi_258_ = type_9(0u, type_9().member_1);
                }
                let _e144 = phi_235_;
                let _e146 = phi_258_;
                let _e150 = (bitcast<i32>(_e146.member) != 0i);
                if _e150 {
                    let _e151 = (_e146.member_1 < 16u);
                    if _e151 {
                    } else {
                        phi_645_ = true;
                        break;
                    }
                    let _e152 = (_e30 % 64u);
                    if (_e152 < 64u) {
                    } else {
                        phi_645_ = true;
                        break;
                    }
                    let _e156 = global_4[_e146.member_1][_e152];
                    if _e151 {
                    } else {
                        phi_645_ = true;
                        break;
                    }
                    local[_e146.member_1] = _e156;
                }
                continue;
                continuing {
                    phi_234_ = _e144;
                    phi_645_ = _e123;
                    break if !(_e150);
                }
            }
            let _e160 = phi_645_;
            if _e160 {
                break;
            }
            phi_655_ = _e160;
            phi_288_ = type_9(0u, 6u);
            phi_291_ = 1u;
            loop {
                let _e162 = phi_655_;
                let _e164 = phi_288_;
                let _e166 = phi_291_;
                if (_e164.member < _e164.member_1) {
                    phi_289_ = type_9((_e164.member + 1u), _e164.member_1);
                    phi_314_ = type_9(1u, _e164.member);
                } else {
                    phi_289_ = _e164;
                    phi_314_ = type_9(0u, type_9().member_1);
                }
                let _e179 = phi_289_;
                let _e181 = phi_314_;
                let _e184 = (bitcast<i32>(_e181.member) != 0i);
                if _e184 {
                    phi_323_ = type_9(0u, 16u);
                    loop {
                        let _e186 = phi_323_;
                        if (_e186.member < _e186.member_1) {
                            phi_324_ = type_9((_e186.member + 1u), _e186.member_1);
                            phi_347_ = type_9(1u, _e186.member);
                        } else {
                            phi_324_ = _e186;
                            phi_347_ = type_9(0u, type_9().member_1);
                        }
                        let _e199 = phi_324_;
                        let _e201 = phi_347_;
                        let _e205 = (bitcast<i32>(_e201.member) != 0i);
                        if _e205 {
                            let _e206 = (_e201.member_1 < 16u);
                            if _e206 {
                            } else {
                                phi_650_ = true;
                                break;
                            }
                            let _e207 = (_e30 % 64u);
                            if (_e207 < 64u) {
                            } else {
                                phi_650_ = true;
                                break;
                            }
                            let _e211 = global_4[_e201.member_1][_e207];
                            if (_e30 >= _e166) {
                                let _e214 = ((_e30 - _e166) % 64u);
                                if (_e214 < 64u) {
                                } else {
                                    phi_650_ = true;
                                    break;
                                }
                                let _e218 = global_4[_e201.member_1][_e214];
                                phi_383_ = (_e211 + _e218);
                            } else {
                                phi_383_ = _e211;
                            }
                            let _e221 = phi_383_;
                            if _e206 {
                            } else {
                                phi_650_ = true;
                                break;
                            }
                            local_1[_e201.member_1] = _e221;
                        }
                        continue;
                        continuing {
                            phi_323_ = _e199;
                            phi_650_ = _e162;
                            break if !(_e205);
                        }
                    }
                    let _e225 = phi_650_;
                    phi_661_ = _e225;
                    if _e225 {
                        break;
                    }
                    workgroupBarrier();
                    phi_392_ = type_9(0u, 16u);
                    loop {
                        let _e227 = phi_392_;
                        if (_e227.member < _e227.member_1) {
                            phi_393_ = type_9((_e227.member + 1u), _e227.member_1);
                            phi_416_ = type_9(1u, _e227.member);
                        } else {
                            phi_393_ = _e227;
                            phi_416_ = type_9(0u, type_9().member_1);
                        }
                        let _e240 = phi_393_;
                        let _e242 = phi_416_;
                        let _e246 = (bitcast<i32>(_e242.member) != 0i);
                        if _e246 {
                            let _e247 = (_e242.member_1 < 16u);
                            if _e247 {
                            } else {
                                phi_657_ = true;
                                break;
                            }
                            let _e249 = local_1[_e242.member_1];
                            if _e247 {
                            } else {
                                phi_657_ = true;
                                break;
                            }
                            let _e250 = (_e30 % 64u);
                            if (_e250 < 64u) {
                            } else {
                                phi_657_ = true;
                                break;
                            }
                            global_4[_e242.member_1][_e250] = _e249;
                        }
                        continue;
                        continuing {
                            phi_392_ = _e240;
                            phi_657_ = _e225;
                            break if !(_e246);
                        }
                    }
                    let _e256 = phi_657_;
                    phi_661_ = _e256;
                    if _e256 {
                        break;
                    }
                    workgroupBarrier();
                    phi_662_ = _e256;
                    phi_292_ = (_e166 * 2u);
                } else {
                    phi_662_ = _e162;
                    phi_292_ = u32();
                }
                let _e259 = phi_662_;
                let _e261 = phi_292_;
                continue;
                continuing {
                    phi_655_ = _e259;
                    phi_288_ = _e179;
                    phi_291_ = _e261;
                    phi_661_ = _e259;
                    break if !(_e184);
                }
            }
            let _e264 = phi_661_;
            if _e264 {
                break;
            }
            phi_447_ = type_9(0u, 16u);
            loop {
                let _e266 = phi_447_;
                if (_e266.member < _e266.member_1) {
                    phi_448_ = type_9((_e266.member + 1u), _e266.member_1);
                    phi_471_ = type_9(1u, _e266.member);
                } else {
                    phi_448_ = _e266;
                    phi_471_ = type_9(0u, type_9().member_1);
                }
                let _e279 = phi_448_;
                let _e281 = phi_471_;
                let _e285 = (bitcast<i32>(_e281.member) != 0i);
                if _e285 {
                    let _e287 = ((_e281.member_1 * _e129) + _e72);
                    let _e288 = (_e287 < arrayLength((&global_5.member)));
                    if _e288 {
                        if _e288 {
                        } else {
                            phi_663_ = true;
                            break;
                        }
                        let _e291 = global_5.member[_e287];
                        phi_492_ = _e291;
                    } else {
                        phi_492_ = 0u;
                    }
                    let _e293 = phi_492_;
                    let _e294 = (_e281.member_1 < 16u);
                    if _e294 {
                    } else {
                        phi_663_ = true;
                        break;
                    }
                    let _e296 = local_1[_e281.member_1];
                    if _e294 {
                    } else {
                        phi_663_ = true;
                        break;
                    }
                    let _e298 = local[_e281.member_1];
                    if _e294 {
                    } else {
                        phi_663_ = true;
                        break;
                    }
                    let _e301 = (_e30 % 64u);
                    if (_e301 < 64u) {
                    } else {
                        phi_663_ = true;
                        break;
                    }
                    global_4[_e281.member_1][_e301] = (_e293 + (_e296 - _e298));
                }
                continue;
                continuing {
                    phi_447_ = _e279;
                    phi_663_ = _e264;
                    break if !(_e285);
                }
            }
            let _e307 = phi_663_;
            if _e307 {
                break;
            }
            phi_545_ = _e82;
            loop {
                let _e309 = phi_545_;
                if (_e309.member < _e309.member_1) {
                    phi_546_ = type_9((_e309.member + 1u), _e309.member_1);
                    phi_569_ = type_9(1u, _e309.member);
                } else {
                    phi_546_ = _e309;
                    phi_569_ = type_9(0u, type_9().member_1);
                }
                let _e322 = phi_546_;
                let _e324 = phi_569_;
                let _e328 = (bitcast<i32>(_e324.member) != 0i);
                if _e328 {
                    if (_e324.member_1 < _e32) {
                    } else {
                        phi_668_ = true;
                        break;
                    }
                    let _e332 = global_3.member[_e324.member_1];
                    let _e338 = (((_e332[0] >> bitcast<u32>((_e39 & 31u))) & 15u) % 16u);
                    if (_e338 < 16u) {
                    } else {
                        phi_668_ = true;
                        break;
                    }
                    let _e340 = (_e30 % 64u);
                    if (_e340 < 64u) {
                    } else {
                        phi_668_ = true;
                        break;
                    }
                    let _e344 = global_4[_e338][_e340];
                    global_4[_e338][_e340] = (_e344 + 1u);
                    let _e346 = (_e344 < arrayLength((&global_6.member)));
                    if _e346 {
                        if _e346 {
                        } else {
                            phi_668_ = true;
                            break;
                        }
                        global_6.member[_e344] = _e332;
                    }
                }
                continue;
                continuing {
                    phi_545_ = _e322;
                    phi_668_ = _e307;
                    break if !(_e328);
                }
            }
            let _e351 = phi_668_;
            if _e351 {
                break;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn sort_scatter_30_(@builtin(workgroup_id) param: vec3<u32>, @builtin(local_invocation_index) param_1: u32) {
    global = param;
    global_1 = param_1;
    function_();
}
