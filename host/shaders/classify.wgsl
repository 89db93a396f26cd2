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
    var phi_1362_: bool;
    var phi_409_: type_11;
    var phi_410_: type_11;
    var phi_433_: type_11;
    var phi_1367_: bool;
    var phi_591_: u32;
    var phi_608_: i32;
    var phi_621_: bool;
    var phi_638_: array<u32, 3>;
    var phi_653_: array<f32, 3>;
    var phi_671_: array<f32, 3>;
    var phi_689_: array<f32, 3>;
    var phi_796_: vec3<f32>;
    var phi_992_: bool;
    var phi_1017_: type_11;
    var phi_1020_: bool;
    var phi_1018_: type_11;
    var phi_1043_: type_11;
    var phi_1198_: bool;
    var phi_1200_: bool;
    var phi_1201_: bool;
    var phi_1021_: bool;
    var phi_1371_: bool;
    var local_3: bool;
    var phi_1412_: bool;
    var phi_1215_: bool;
    var phi_1411_: bool;
    var phi_1216_: bool;
    var phi_1410_: bool;
    var phi_1218_: u32;
    var phi_1409_: bool;
    var phi_1219_: u32;
    var phi_1239_: type_11;
    var phi_1242_: u32;
    var phi_1240_: type_11;
    var phi_1265_: type_11;
    var phi_1243_: u32;
    var phi_1405_: bool;
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
                                phi_1362_ = true;
                                break;
                            }
                            let _e195 = global_5.member[_e190][0u];
                            let _e199 = global_5.member[_e190][1u];
                            let _e203 = global_5.member[_e190][2u];
                            let _e207 = global_5.member[_e190][3u];
                            if (_e185.member_1 < 4u) {
                            } else {
                                phi_1362_ = true;
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
                            phi_1362_ = false;
                            break if !(_e189);
                        }
                    }
                    let _e227 = phi_1362_;
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
                                phi_1367_ = true;
                                break;
                            }
                            let _e266 = local_2.member_2[_e257.member_1][3u];
                            if _e262 {
                            } else {
                                phi_1367_ = true;
                                break;
                            }
                            local_1.member_2[_e257.member_1][3u] = ((_e266 * _e126) * _e132);
                        }
                        continue;
                        continuing {
                            phi_409_ = _e255;
                            phi_1367_ = _e227;
                            break if !(_e261);
                        }
                    }
                    let _e274 = phi_1367_;
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
                        if _e294 {
                            phi_992_ = true;
                        } else {
                            let _e366 = (_e345 - _e333);
                            let _e367 = (_e349 - _e337);
                            let _e368 = (_e353 - _e341);
                            let _e369 = (_e357 - _e333);
                            let _e370 = (_e361 - _e337);
                            let _e371 = (_e365 - _e341);
                            if (_e145.member_1 == 1u) {
                                phi_796_ = vec3<f32>((_e145.member[0] - _e333), (_e145.member[1] - _e337), (_e145.member[2] - _e341));
                            } else {
                                phi_796_ = vec3<f32>(_e145.member[0], _e145.member[1], _e145.member[2]);
                            }
                            let _e385 = phi_796_;
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
                            let _e476 = bitcast<f32>((bitcast<u32>(_e410) & 2147483647u));
                            let _e479 = bitcast<f32>((bitcast<u32>(_e411) & 2147483647u));
                            let _e482 = bitcast<f32>((bitcast<u32>(_e412) & 2147483647u));
                            let _e484 = select(_e482, _e479, (_e479 > _e482));
                            let _e488 = select(_e482, _e479, (_e479 < _e482));
                            let _e492 = select(_e479, _e476, (_e476 < _e479));
                            let _e494 = select(_e479, _e476, (_e476 > _e479));
                            let _e496 = select(_e482, _e494, (_e494 < _e482));
                            phi_992_ = !(((((bitcast<f32>((bitcast<u32>((_e385.x * _e410)) ^ _e145.member_3[0])) + bitcast<f32>((bitcast<u32>((_e385.y * _e411)) ^ _e145.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e385.z * _e412)) ^ _e145.member_3[0]))) * f32(-(_e293))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e385.x) & 2147483647u)) * _e436)) ^ _e145.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e385.y) & 2147483647u)) * _e443)) ^ _e145.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e385.z) & 2147483647u)) * _e450)) ^ _e145.member_3[0]))))) ^ _e145.member_3[0])) + bitcast<f32>((bitcast<u32>((_e145.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e484, _e476, (_e476 > _e484)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e496, _e492, (_e492 > _e496)))) ^ _e145.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e488, _e476, (_e476 < _e488)))) ^ _e145.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e436 + _e443) + _e450))) ^ _e145.member_3[0]))) * 1.0000005f)) ^ _e145.member_3[0])))) ^ _e145.member_3[0]))) + 0.0000000000000000000000000000000000001880791f)));
                        }
                        let _e536 = phi_992_;
                        if _e536 {
                            let _e540 = (_e333 - _e275.member[0]);
                            let _e541 = (_e337 - _e275.member[1]);
                            let _e542 = (_e341 - _e275.member[2]);
                            let _e543 = (_e345 - _e275.member[0]);
                            let _e544 = (_e349 - _e275.member[1]);
                            let _e545 = (_e353 - _e275.member[2]);
                            let _e546 = (_e357 - _e275.member[0]);
                            let _e547 = (_e361 - _e275.member[1]);
                            let _e548 = (_e365 - _e275.member[2]);
                            phi_1017_ = type_11(0u, 4u);
                            phi_1020_ = false;
                            loop {
                                let _e550 = phi_1017_;
                                let _e552 = phi_1020_;
                                local_3 = _e552;
                                if (_e550.member < _e550.member_1) {
                                    phi_1018_ = type_11((_e550.member + 1u), _e550.member_1);
                                    phi_1043_ = type_11(1u, _e550.member);
                                } else {
                                    phi_1018_ = _e550;
                                    phi_1043_ = type_11(0u, type_11().member_1);
                                }
                                let _e565 = phi_1018_;
                                let _e567 = phi_1043_;
                                let _e571 = (bitcast<i32>(_e567.member) != 0i);
                                if _e571 {
                                    let _e572 = (_e567.member_1 < 4u);
                                    if _e572 {
                                    } else {
                                        phi_1371_ = true;
                                        break;
                                    }
                                    let _e574 = local[_e567.member_1];
                                    if (((((_e574[0] * _e540) + (_e574[1] * _e541)) + (_e574[2] * _e542)) + _e574[3]) < (-0.0000000000000000000000000000000000001880791f - (0.000003814712f * (((bitcast<f32>((bitcast<u32>(_e540) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e541) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e542) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e574[3]) & 2147483647u)))))) {
                                        if _e572 {
                                        } else {
                                            phi_1371_ = true;
                                            break;
                                        }
                                        let _e603 = local[_e567.member_1];
                                        let _e631 = (((((_e603[0] * _e543) + (_e603[1] * _e544)) + (_e603[2] * _e545)) + _e603[3]) < (-0.0000000000000000000000000000000000001880791f - (0.000003814712f * (((bitcast<f32>((bitcast<u32>(_e543) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e544) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e545) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e603[3]) & 2147483647u))))));
                                        if _e631 {
                                            if _e572 {
                                            } else {
                                                phi_1371_ = true;
                                                break;
                                            }
                                            let _e632 = local[_e567.member_1];
                                            phi_1198_ = (((((_e632[0] * _e546) + (_e632[1] * _e547)) + (_e632[2] * _e548)) + _e632[3]) < (-0.0000000000000000000000000000000000001880791f - (0.000003814712f * (((bitcast<f32>((bitcast<u32>(_e546) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e547) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e548) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e632[3]) & 2147483647u))))));
                                        } else {
                                            phi_1198_ = bool();
                                        }
                                        let _e662 = phi_1198_;
                                        phi_1200_ = _e662;
                                        phi_1201_ = select(true, false, _e631);
                                    } else {
                                        phi_1200_ = bool();
                                        phi_1201_ = true;
                                    }
                                    let _e665 = phi_1200_;
                                    let _e667 = phi_1201_;
                                    phi_1021_ = (_e552 || select(_e665, false, _e667));
                                } else {
                                    phi_1021_ = bool();
                                }
                                let _e671 = phi_1021_;
                                continue;
                                continuing {
                                    phi_1017_ = _e565;
                                    phi_1020_ = _e671;
                                    phi_1371_ = _e274;
                                    break if !(_e571);
                                }
                            }
                            let _e674 = phi_1371_;
                            if _e674 {
                                break;
                            }
                            let _e677 = local_3;
                            phi_1412_ = _e674;
                            phi_1215_ = !(select(false, _e677, (_e275.member_1 == 1u)));
                        } else {
                            phi_1412_ = _e274;
                            phi_1215_ = false;
                        }
                        let _e681 = phi_1412_;
                        let _e683 = phi_1215_;
                        phi_1411_ = _e681;
                        phi_1216_ = _e683;
                    } else {
                        phi_1411_ = _e274;
                        phi_1216_ = true;
                    }
                    let _e685 = phi_1411_;
                    let _e687 = phi_1216_;
                    phi_1410_ = _e685;
                    phi_1218_ = select(0u, 1u, _e687);
                } else {
                    phi_1410_ = false;
                    phi_1218_ = 0u;
                }
                let _e690 = phi_1410_;
                let _e692 = phi_1218_;
                phi_1409_ = _e690;
                phi_1219_ = _e692;
            } else {
                phi_1409_ = false;
                phi_1219_ = 0u;
            }
            let _e694 = phi_1409_;
            let _e696 = phi_1219_;
            let _e697 = (_e54 % 64u);
            if (_e697 < 64u) {
            } else {
                break;
            }
            global_4[_e697] = _e696;
            workgroupBarrier();
            let _e700 = (_e72 / 32u);
            if ((_e54 & 31u) == 0u) {
                let _e703 = (_e700 < arrayLength((&global_11.member)));
                if _e703 {
                    phi_1239_ = type_11(0u, 32u);
                    phi_1242_ = 0u;
                    loop {
                        let _e705 = phi_1239_;
                        let _e707 = phi_1242_;
                        local_4 = _e707;
                        if (_e705.member < _e705.member_1) {
                            phi_1240_ = type_11((_e705.member + 1u), _e705.member_1);
                            phi_1265_ = type_11(1u, _e705.member);
                        } else {
                            phi_1240_ = _e705;
                            phi_1265_ = type_11(0u, type_11().member_1);
                        }
                        let _e720 = phi_1240_;
                        let _e722 = phi_1265_;
                        let _e726 = (bitcast<i32>(_e722.member) != 0i);
                        if _e726 {
                            let _e728 = ((_e54 + _e722.member_1) % 64u);
                            if (_e728 < 64u) {
                            } else {
                                phi_1405_ = true;
                                break;
                            }
                            let _e731 = global_4[_e728];
                            phi_1243_ = (_e707 | (_e731 << bitcast<u32>((_e722.member_1 & 31u))));
                        } else {
                            phi_1243_ = u32();
                        }
                        let _e737 = phi_1243_;
                        continue;
                        continuing {
                            phi_1239_ = _e720;
                            phi_1242_ = _e737;
                            phi_1405_ = _e694;
                            break if !(_e726);
                        }
                    }
                    let _e740 = phi_1405_;
                    if _e740 {
                        break;
                    }
                    if _e703 {
                    } else {
                        break;
                    }
                    let _e744 = local_4;
                    global_11.member[_e700] = _e744;
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
