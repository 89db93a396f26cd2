struct type_5 {
    member: array<u32>,
}

struct type_11 {
    member: u32,
    member_1: u32,
}

struct type_16 {
    member: vec4<u32>,
}

struct type_21 {
    member: array<array<f32, 3>>,
}

struct type_25 {
    member: array<array<u32, 3>>,
}

struct type_35 {
    member: array<vec4<u32>, 5>,
}

struct type_39 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_41 {
    member: array<vec4<u32>, 2>,
}

struct type_44 {
    member: array<i32>,
}

struct type_50 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<array<f32, 4>, 4>,
}

var<private> global: u32;
var<private> global_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_2: type_16;
@group(0) @binding(1) 
var<uniform> global_3: type_41;
var<workgroup> global_4: array<u32, 64>;
@group(0) @binding(2) 
var<uniform> global_5: type_35;
@group(0) @binding(3) 
var<uniform> global_6: type_16;
@group(0) @binding(4) 
var<storage> global_7: type_21;
@group(0) @binding(5) 
var<storage> global_8: type_25;
@group(0) @binding(6) 
var<storage> global_9: type_5;
@group(0) @binding(7) 
var<storage> global_10: type_44;
@group(0) @binding(8) 
var<storage, read_write> global_11: type_5;

fn function_() {
    var local: array<array<f32, 4>, 4>;
    var local_1: type_50;
    var local_2: type_50;
    var phi_251_: type_39;
    var phi_301_: type_11;
    var phi_302_: type_11;
    var phi_325_: type_11;
    var phi_1366_: bool;
    var phi_409_: type_11;
    var phi_410_: type_11;
    var phi_433_: type_11;
    var phi_1371_: bool;
    var phi_591_: u32;
    var phi_608_: i32;
    var phi_621_: bool;
    var phi_638_: array<u32, 3>;
    var phi_653_: array<f32, 3>;
    var phi_671_: array<f32, 3>;
    var phi_689_: array<f32, 3>;
    var phi_793_: vec3<f32>;
    var phi_979_: f32;
    var phi_1021_: type_11;
    var phi_1024_: bool;
    var phi_1022_: type_11;
    var phi_1047_: type_11;
    var phi_1202_: bool;
    var phi_1204_: bool;
    var phi_1205_: bool;
    var phi_1025_: bool;
    var phi_1375_: bool;
    var local_3: bool;
    var phi_1416_: bool;
    var phi_1219_: bool;
    var phi_1415_: bool;
    var phi_1220_: bool;
    var phi_1414_: bool;
    var phi_1222_: u32;
    var phi_1413_: bool;
    var phi_1223_: u32;
    var phi_1243_: type_11;
    var phi_1246_: u32;
    var phi_1244_: type_11;
    var phi_1269_: type_11;
    var phi_1247_: u32;
    var phi_1409_: bool;
    var local_4: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e53 = global_1;
            let _e54 = global;
            let _e57 = arrayLength((&global_7.member));
            let _e72 = (_e53.x + (_e53.y * 2097152u));
            let _e75 = global_6.member[0u];
            if (_e75 > 0u) {
                let _e77 = (_e72 < arrayLength((&global_8.member)));
                if _e77 {
                    let _e80 = global_2.member[0u];
                    let _e84 = global_3.member[0u][0u];
                    let _e88 = global_3.member[0u][1u];
                    let _e92 = global_3.member[0u][2u];
                    let _e96 = global_3.member[0u][3u];
                    let _e100 = global_3.member[1u][0u];
                    let _e104 = global_3.member[1u][1u];
                    let _e108 = global_3.member[1u][2u];
                    let _e112 = global_3.member[1u][3u];
                    let _e113 = bitcast<f32>(_e84);
                    let _e114 = bitcast<f32>(_e88);
                    let _e115 = bitcast<f32>(_e92);
                    let _e117 = bitcast<f32>(_e100);
                    let _e118 = array<u32, 3>(_e104, _e108, _e112);
                    let _e120 = bitcast<i32>(_e80);
                    let _e121 = (_e120 / 2i);
                    let _e126 = bitcast<f32>((bitcast<u32>((_e121 + 127i)) << bitcast<u32>(23i)));
                    let _e132 = bitcast<f32>((bitcast<u32>(((_e120 - _e121) + 127i)) << bitcast<u32>(23i)));
                    if (_e96 == 0u) {
                        phi_251_ = type_39(array<f32, 3>(_e113, _e114, _e115), _e96, _e117, _e118);
                    } else {
                        phi_251_ = type_39(array<f32, 3>(((_e113 * _e126) * _e132), ((_e114 * _e126) * _e132), ((_e115 * _e126) * _e132)), _e96, ((_e117 * _e126) * _e132), _e118);
                    }
                    let _e145 = phi_251_;
                    let _e149 = global_5.member[0u][0u];
                    let _e153 = global_5.member[0u][1u];
                    let _e157 = global_5.member[0u][2u];
                    let _e161 = global_5.member[0u][3u];
                    local_2.member = array<f32, 3>(bitcast<f32>(_e149), bitcast<f32>(_e153), bitcast<f32>(_e157));
                    local_2.member_1 = _e161;
                    local_2.member_2 = array<array<f32, 4>, 4>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f));
                    phi_301_ = type_11(0u, 4u);
                    loop {
                        let _e170 = phi_301_;
                        if (_e170.member < _e170.member_1) {
                            phi_302_ = type_11((_e170.member + 1u), _e170.member_1);
                            phi_325_ = type_11(1u, _e170.member);
                        } else {
                            phi_302_ = _e170;
                            phi_325_ = type_11(0u, type_11().member_1);
                        }
                        let _e183 = phi_302_;
                        let _e185 = phi_325_;
                        let _e189 = (bitcast<i32>(_e185.member) != 0i);
                        if _e189 {
                            let _e190 = (_e185.member_1 + 1u);
                            if (_e190 < 5u) {
                            } else {
                                phi_1366_ = true;
                                break;
                            }
                            let _e195 = global_5.member[_e190][0u];
                            let _e199 = global_5.member[_e190][1u];
                            let _e203 = global_5.member[_e190][2u];
                            let _e207 = global_5.member[_e190][3u];
                            if (_e185.member_1 < 4u) {
                            } else {
                                phi_1366_ = true;
                                break;
                            }
                            local_2.member_2[_e185.member_1][0u] = bitcast<f32>(_e195);
                            local_2.member_2[_e185.member_1][1u] = bitcast<f32>(_e199);
                            local_2.member_2[_e185.member_1][2u] = bitcast<f32>(_e203);
                            local_2.member_2[_e185.member_1][3u] = bitcast<f32>(_e207);
                        }
                        continue;
                        continuing {
                            phi_301_ = _e183;
                            phi_1366_ = false;
                            break if !(_e189);
                        }
                    }
                    let _e227 = phi_1366_;
                    if _e227 {
                        break;
                    }
                    let _e228 = local_2;
                    local_1 = _e228;
                    let _e229 = local_2.member;
                    local_1.member = array<f32, 3>(((_e229[0] * _e126) * _e132), ((_e229[1] * _e126) * _e132), ((_e229[2] * _e126) * _e132));
                    phi_409_ = type_11(0u, 4u);
                    loop {
                        let _e242 = phi_409_;
                        if (_e242.member < _e242.member_1) {
                            phi_410_ = type_11((_e242.member + 1u), _e242.member_1);
                            phi_433_ = type_11(1u, _e242.member);
                        } else {
                            phi_410_ = _e242;
                            phi_433_ = type_11(0u, type_11().member_1);
                        }
                        let _e255 = phi_410_;
                        let _e257 = phi_433_;
                        let _e261 = (bitcast<i32>(_e257.member) != 0i);
                        if _e261 {
                            let _e262 = (_e257.member_1 < 4u);
                            if _e262 {
                            } else {
                                phi_1371_ = true;
                                break;
                            }
                            let _e266 = local_2.member_2[_e257.member_1][3u];
                            if _e262 {
                            } else {
                                phi_1371_ = true;
                                break;
                            }
                            local_1.member_2[_e257.member_1][3u] = ((_e266 * _e126) * _e132);
                        }
                        continue;
                        continuing {
                            phi_409_ = _e255;
                            phi_1371_ = _e227;
                            break if !(_e261);
                        }
                    }
                    let _e274 = phi_1371_;
                    if _e274 {
                        break;
                    }
                    let _e275 = local_1;
                    local = _e275.member_2;
                    let _e284 = (_e72 < arrayLength((&global_9.member)));
                    if _e284 {
                        if _e284 {
                        } else {
                            break;
                        }
                        let _e286 = global_9.member[_e72];
                        phi_591_ = _e286;
                    } else {
                        phi_591_ = 4294967295u;
                    }
                    let _e288 = phi_591_;
                    let _e289 = (_e288 < arrayLength((&global_10.member)));
                    if _e289 {
                        if _e289 {
                        } else {
                            break;
                        }
                        let _e291 = global_10.member[_e288];
                        phi_608_ = _e291;
                    } else {
                        phi_608_ = 0i;
                    }
                    let _e293 = phi_608_;
                    let _e294 = (_e293 == 0i);
                    if _e294 {
                        phi_621_ = select(true, false, (_e275.member_1 == 0u));
                    } else {
                        phi_621_ = true;
                    }
                    let _e298 = phi_621_;
                    if _e298 {
                        if _e77 {
                            if _e77 {
                            } else {
                                break;
                            }
                            let _e300 = global_8.member[_e72];
                            phi_638_ = _e300;
                        } else {
                            phi_638_ = array<u32, 3>(0u, 0u, 0u);
                        }
                        let _e302 = phi_638_;
                        let _e304 = (_e302[0] < _e57);
                        if _e304 {
                            if _e304 {
                            } else {
                                break;
                            }
                            let _e306 = global_7.member[_e302[0]];
                            phi_653_ = _e306;
                        } else {
                            phi_653_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e308 = phi_653_;
                        let _e313 = (_e302[1] < _e57);
                        if _e313 {
                            if _e313 {
                            } else {
                                break;
                            }
                            let _e315 = global_7.member[_e302[1]];
                            phi_671_ = _e315;
                        } else {
                            phi_671_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e317 = phi_671_;
                        let _e322 = (_e302[2] < _e57);
                        if _e322 {
                            if _e322 {
                            } else {
                                break;
                            }
                            let _e324 = global_7.member[_e302[2]];
                            phi_689_ = _e324;
                        } else {
                            phi_689_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e326 = phi_689_;
                        let _e331 = ((_e308[0] * _e126) * _e132);
                        let _e333 = select(_e331, 0f, (_e331 == 0f));
                        let _e335 = ((_e308[1] * _e126) * _e132);
                        let _e337 = select(_e335, 0f, (_e335 == 0f));
                        let _e339 = ((_e308[2] * _e126) * _e132);
                        let _e341 = select(_e339, 0f, (_e339 == 0f));
                        let _e343 = ((_e317[0] * _e126) * _e132);
                        let _e345 = select(_e343, 0f, (_e343 == 0f));
                        let _e347 = ((_e317[1] * _e126) * _e132);
                        let _e349 = select(_e347, 0f, (_e347 == 0f));
                        let _e351 = ((_e317[2] * _e126) * _e132);
                        let _e353 = select(_e351, 0f, (_e351 == 0f));
                        let _e355 = ((_e326[0] * _e126) * _e132);
                        let _e357 = select(_e355, 0f, (_e355 == 0f));
                        let _e359 = ((_e326[1] * _e126) * _e132);
                        let _e361 = select(_e359, 0f, (_e359 == 0f));
                        let _e363 = ((_e326[2] * _e126) * _e132);
                        let _e365 = select(_e363, 0f, (_e363 == 0f));
                        let _e366 = (_e345 - _e333);
                        let _e367 = (_e349 - _e337);
                        let _e368 = (_e353 - _e341);
                        let _e369 = (_e357 - _e333);
                        let _e370 = (_e361 - _e337);
                        let _e371 = (_e365 - _e341);
                        if (_e145.member_1 == 1u) {
                            phi_793_ = vec3<f32>((_e145.member[0] - _e333), (_e145.member[1] - _e337), (_e145.member[2] - _e341));
                        } else {
                            phi_793_ = vec3<f32>(_e145.member[0], _e145.member[1], _e145.member[2]);
                        }
                        let _e385 = phi_793_;
                        let _e389 = bitcast<f32>((bitcast<u32>((_e366 * _e370)) ^ _e145.member_3[0]));
                        let _e393 = bitcast<f32>((bitcast<u32>((_e367 * _e369)) ^ _e145.member_3[0]));
                        let _e397 = bitcast<f32>((bitcast<u32>((_e367 * _e371)) ^ _e145.member_3[0]));
                        let _e401 = bitcast<f32>((bitcast<u32>((_e368 * _e370)) ^ _e145.member_3[0]));
                        let _e405 = bitcast<f32>((bitcast<u32>((_e368 * _e369)) ^ _e145.member_3[0]));
                        let _e409 = bitcast<f32>((bitcast<u32>((_e366 * _e371)) ^ _e145.member_3[0]));
                        let _e410 = (_e397 - _e401);
                        let _e411 = (_e405 - _e409);
                        let _e412 = (_e389 - _e393);
                        let _e436 = (bitcast<f32>((bitcast<u32>(_e397) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e401) & 2147483647u)));
                        let _e443 = (bitcast<f32>((bitcast<u32>(_e405) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e409) & 2147483647u)));
                        let _e450 = (bitcast<f32>((bitcast<u32>(_e389) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e393) & 2147483647u)));
                        if (_e145.member_2 == 0f) {
                            phi_979_ = 0f;
                        } else {
                            let _e479 = bitcast<f32>((bitcast<u32>(_e410) & 2147483647u));
                            let _e482 = bitcast<f32>((bitcast<u32>(_e411) & 2147483647u));
                            let _e485 = bitcast<f32>((bitcast<u32>(_e412) & 2147483647u));
                            let _e487 = select(_e485, _e482, (_e482 > _e485));
                            let _e491 = select(_e485, _e482, (_e482 < _e485));
                            let _e495 = select(_e482, _e479, (_e479 < _e482));
                            let _e497 = select(_e482, _e479, (_e479 > _e482));
                            let _e499 = select(_e485, _e497, (_e497 < _e485));
                            phi_979_ = bitcast<f32>((bitcast<u32>((_e145.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e487, _e479, (_e479 > _e487)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e499, _e495, (_e495 > _e499)))) ^ _e145.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e491, _e479, (_e479 < _e491)))) ^ _e145.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e436 + _e443) + _e450))) ^ _e145.member_3[0]))) * 1.0000005f)) ^ _e145.member_3[0])))) ^ _e145.member_3[0]));
                        }
                        let _e526 = phi_979_;
                        if (_e294 || !(((((bitcast<f32>((bitcast<u32>((_e385.x * _e410)) ^ _e145.member_3[0])) + bitcast<f32>((bitcast<u32>((_e385.y * _e411)) ^ _e145.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e385.z * _e412)) ^ _e145.member_3[0]))) * f32(-(_e293))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e385.x) & 2147483647u)) * _e436)) ^ _e145.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e385.y) & 2147483647u)) * _e443)) ^ _e145.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e385.z) & 2147483647u)) * _e450)) ^ _e145.member_3[0]))))) ^ _e145.member_3[0])) + _e526) + 0.0000000000000000000000000000000000001880791f)))) {
                            let _e542 = (_e333 - _e275.member[0]);
                            let _e543 = (_e337 - _e275.member[1]);
                            let _e544 = (_e341 - _e275.member[2]);
                            let _e545 = (_e345 - _e275.member[0]);
                            let _e546 = (_e349 - _e275.member[1]);
                            let _e547 = (_e353 - _e275.member[2]);
                            let _e548 = (_e357 - _e275.member[0]);
                            let _e549 = (_e361 - _e275.member[1]);
                            let _e550 = (_e365 - _e275.member[2]);
                            phi_1021_ = type_11(0u, 4u);
                            phi_1024_ = false;
                            loop {
                                let _e552 = phi_1021_;
                                let _e554 = phi_1024_;
                                local_3 = _e554;
                                if (_e552.member < _e552.member_1) {
                                    phi_1022_ = type_11((_e552.member + 1u), _e552.member_1);
                                    phi_1047_ = type_11(1u, _e552.member);
                                } else {
                                    phi_1022_ = _e552;
                                    phi_1047_ = type_11(0u, type_11().member_1);
                                }
                                let _e567 = phi_1022_;
                                let _e569 = phi_1047_;
                                let _e573 = (bitcast<i32>(_e569.member) != 0i);
                                if _e573 {
                                    let _e574 = (_e569.member_1 < 4u);
                                    if _e574 {
                                    } else {
                                        phi_1375_ = true;
                                        break;
                                    }
                                    let _e576 = local[_e569.member_1];
                                    if (((((_e576[0] * _e542) + (_e576[1] * _e543)) + (_e576[2] * _e544)) + _e576[3]) < (-0.0000000000000000000000000000000000001880791f - (0.000003814712f * (((bitcast<f32>((bitcast<u32>(_e542) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e543) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e544) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e576[3]) & 2147483647u)))))) {
                                        if _e574 {
                                        } else {
                                            phi_1375_ = true;
                                            break;
                                        }
                                        let _e605 = local[_e569.member_1];
                                        let _e633 = (((((_e605[0] * _e545) + (_e605[1] * _e546)) + (_e605[2] * _e547)) + _e605[3]) < (-0.0000000000000000000000000000000000001880791f - (0.000003814712f * (((bitcast<f32>((bitcast<u32>(_e545) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e546) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e547) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e605[3]) & 2147483647u))))));
                                        if _e633 {
                                            if _e574 {
                                            } else {
                                                phi_1375_ = true;
                                                break;
                                            }
                                            let _e634 = local[_e569.member_1];
                                            phi_1202_ = (((((_e634[0] * _e548) + (_e634[1] * _e549)) + (_e634[2] * _e550)) + _e634[3]) < (-0.0000000000000000000000000000000000001880791f - (0.000003814712f * (((bitcast<f32>((bitcast<u32>(_e548) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e549) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e550) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e634[3]) & 2147483647u))))));
                                        } else {
                                            phi_1202_ = bool();
                                        }
                                        let _e664 = phi_1202_;
                                        phi_1204_ = _e664;
                                        phi_1205_ = select(true, false, _e633);
                                    } else {
                                        phi_1204_ = bool();
                                        phi_1205_ = true;
                                    }
                                    let _e667 = phi_1204_;
                                    let _e669 = phi_1205_;
                                    phi_1025_ = (_e554 || select(_e667, false, _e669));
                                } else {
                                    phi_1025_ = bool();
                                }
                                let _e673 = phi_1025_;
                                continue;
                                continuing {
                                    phi_1021_ = _e567;
                                    phi_1024_ = _e673;
                                    phi_1375_ = _e274;
                                    break if !(_e573);
                                }
                            }
                            let _e676 = phi_1375_;
                            if _e676 {
                                break;
                            }
                            let _e679 = local_3;
                            phi_1416_ = _e676;
                            phi_1219_ = !(select(false, _e679, (_e275.member_1 == 1u)));
                        } else {
                            phi_1416_ = _e274;
                            phi_1219_ = false;
                        }
                        let _e683 = phi_1416_;
                        let _e685 = phi_1219_;
                        phi_1415_ = _e683;
                        phi_1220_ = _e685;
                    } else {
                        phi_1415_ = _e274;
                        phi_1220_ = true;
                    }
                    let _e687 = phi_1415_;
                    let _e689 = phi_1220_;
                    phi_1414_ = _e687;
                    phi_1222_ = select(0u, 1u, _e689);
                } else {
                    phi_1414_ = false;
                    phi_1222_ = 0u;
                }
                let _e692 = phi_1414_;
                let _e694 = phi_1222_;
                phi_1413_ = _e692;
                phi_1223_ = _e694;
            } else {
                phi_1413_ = false;
                phi_1223_ = 0u;
            }
            let _e696 = phi_1413_;
            let _e698 = phi_1223_;
            let _e699 = (_e54 % 64u);
            if (_e699 < 64u) {
            } else {
                break;
            }
            global_4[_e699] = _e698;
            workgroupBarrier();
            let _e702 = (_e72 / 32u);
            if ((_e54 & 31u) == 0u) {
                let _e705 = (_e702 < arrayLength((&global_11.member)));
                if _e705 {
                    phi_1243_ = type_11(0u, 32u);
                    phi_1246_ = 0u;
                    loop {
                        let _e707 = phi_1243_;
                        let _e709 = phi_1246_;
                        local_4 = _e709;
                        if (_e707.member < _e707.member_1) {
                            phi_1244_ = type_11((_e707.member + 1u), _e707.member_1);
                            phi_1269_ = type_11(1u, _e707.member);
                        } else {
                            phi_1244_ = _e707;
                            phi_1269_ = type_11(0u, type_11().member_1);
                        }
                        let _e722 = phi_1244_;
                        let _e724 = phi_1269_;
                        let _e728 = (bitcast<i32>(_e724.member) != 0i);
                        if _e728 {
                            let _e730 = ((_e54 + _e724.member_1) % 64u);
                            if (_e730 < 64u) {
                            } else {
                                phi_1409_ = true;
                                break;
                            }
                            let _e733 = global_4[_e730];
                            phi_1247_ = (_e709 | (_e733 << bitcast<u32>((_e724.member_1 & 31u))));
                        } else {
                            phi_1247_ = u32();
                        }
                        let _e739 = phi_1247_;
                        continue;
                        continuing {
                            phi_1243_ = _e722;
                            phi_1246_ = _e739;
                            phi_1409_ = _e696;
                            break if !(_e728);
                        }
                    }
                    let _e742 = phi_1409_;
                    if _e742 {
                        break;
                    }
                    if _e705 {
                    } else {
                        break;
                    }
                    let _e746 = local_4;
                    global_11.member[_e702] = _e746;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn classify(@builtin(global_invocation_id) param: vec3<u32>, @builtin(local_invocation_index) param_1: u32) {
    global_1 = param;
    global = param_1;
    function_();
}
