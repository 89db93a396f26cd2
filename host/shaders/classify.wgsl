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

struct type_42 {
    member: array<vec4<u32>, 2>,
}

struct type_45 {
    member: array<i32>,
}

struct type_53 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<array<f32, 4>, 4>,
}

var<private> global: u32;
var<private> global_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_2: type_16;
@group(0) @binding(1) 
var<uniform> global_3: type_42;
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
var<storage> global_10: type_45;
@group(0) @binding(8) 
var<storage, read_write> global_11: type_5;

fn function_() {
    var local: array<array<f32, 4>, 4>;
    var local_1: array<vec3<f32>, 3>;
    var local_2: type_53;
    var local_3: type_53;
    var phi_255_: type_39;
    var phi_305_: type_11;
    var phi_306_: type_11;
    var phi_329_: type_11;
    var phi_1326_: bool;
    var phi_413_: type_11;
    var phi_414_: type_11;
    var phi_437_: type_11;
    var phi_1331_: bool;
    var phi_595_: u32;
    var phi_612_: i32;
    var phi_625_: bool;
    var phi_642_: array<u32, 3>;
    var phi_657_: array<f32, 3>;
    var phi_675_: array<f32, 3>;
    var phi_693_: array<f32, 3>;
    var phi_800_: vec3<f32>;
    var phi_996_: bool;
    var phi_1340_: bool;
    var phi_1027_: type_11;
    var phi_1030_: bool;
    var phi_1028_: type_11;
    var phi_1053_: type_11;
    var phi_1087_: type_11;
    var phi_1090_: bool;
    var phi_1088_: type_11;
    var phi_1113_: type_11;
    var phi_1091_: bool;
    var phi_1335_: bool;
    var local_4: bool;
    var phi_1369_: bool;
    var phi_1031_: bool;
    var phi_1368_: bool;
    var local_5: bool;
    var phi_1377_: bool;
    var phi_1177_: bool;
    var phi_1376_: bool;
    var phi_1178_: bool;
    var phi_1375_: bool;
    var phi_1180_: u32;
    var phi_1374_: bool;
    var phi_1181_: u32;
    var phi_1201_: type_11;
    var phi_1204_: u32;
    var phi_1202_: type_11;
    var phi_1227_: type_11;
    var phi_1205_: u32;
    var phi_1370_: bool;
    var local_6: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e55 = global_1;
            let _e56 = global;
            let _e59 = arrayLength((&global_7.member));
            let _e74 = (_e55.x + (_e55.y * 2097152u));
            let _e77 = global_6.member[0u];
            if (_e77 > 0u) {
                let _e79 = (_e74 < arrayLength((&global_8.member)));
                if _e79 {
                    let _e82 = global_2.member[0u];
                    let _e86 = global_3.member[0u][0u];
                    let _e90 = global_3.member[0u][1u];
                    let _e94 = global_3.member[0u][2u];
                    let _e98 = global_3.member[0u][3u];
                    let _e102 = global_3.member[1u][0u];
                    let _e106 = global_3.member[1u][1u];
                    let _e110 = global_3.member[1u][2u];
                    let _e114 = global_3.member[1u][3u];
                    let _e115 = bitcast<f32>(_e86);
                    let _e116 = bitcast<f32>(_e90);
                    let _e117 = bitcast<f32>(_e94);
                    let _e119 = bitcast<f32>(_e102);
                    let _e120 = array<u32, 3>(_e106, _e110, _e114);
                    let _e122 = bitcast<i32>(_e82);
                    let _e123 = (_e122 / 2i);
                    let _e128 = bitcast<f32>((bitcast<u32>((_e123 + 127i)) << bitcast<u32>(23i)));
                    let _e134 = bitcast<f32>((bitcast<u32>(((_e122 - _e123) + 127i)) << bitcast<u32>(23i)));
                    if (_e98 == 0u) {
                        phi_255_ = type_39(array<f32, 3>(_e115, _e116, _e117), _e98, _e119, _e120);
                    } else {
                        phi_255_ = type_39(array<f32, 3>(((_e115 * _e128) * _e134), ((_e116 * _e128) * _e134), ((_e117 * _e128) * _e134)), _e98, ((_e119 * _e128) * _e134), _e120);
                    }
                    let _e147 = phi_255_;
                    let _e151 = global_5.member[0u][0u];
                    let _e155 = global_5.member[0u][1u];
                    let _e159 = global_5.member[0u][2u];
                    let _e163 = global_5.member[0u][3u];
                    local_3.member = array<f32, 3>(bitcast<f32>(_e151), bitcast<f32>(_e155), bitcast<f32>(_e159));
                    local_3.member_1 = _e163;
                    local_3.member_2 = array<array<f32, 4>, 4>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f));
                    phi_305_ = type_11(0u, 4u);
                    loop {
                        let _e172 = phi_305_;
                        if (_e172.member < _e172.member_1) {
                            phi_306_ = type_11((_e172.member + 1u), _e172.member_1);
                            phi_329_ = type_11(1u, _e172.member);
                        } else {
                            phi_306_ = _e172;
                            phi_329_ = type_11(0u, type_11().member_1);
                        }
                        let _e185 = phi_306_;
                        let _e187 = phi_329_;
                        let _e191 = (bitcast<i32>(_e187.member) != 0i);
                        if _e191 {
                            let _e192 = (_e187.member_1 + 1u);
                            if (_e192 < 5u) {
                            } else {
                                phi_1326_ = true;
                                break;
                            }
                            let _e197 = global_5.member[_e192][0u];
                            let _e201 = global_5.member[_e192][1u];
                            let _e205 = global_5.member[_e192][2u];
                            let _e209 = global_5.member[_e192][3u];
                            if (_e187.member_1 < 4u) {
                            } else {
                                phi_1326_ = true;
                                break;
                            }
                            local_3.member_2[_e187.member_1][0u] = bitcast<f32>(_e197);
                            local_3.member_2[_e187.member_1][1u] = bitcast<f32>(_e201);
                            local_3.member_2[_e187.member_1][2u] = bitcast<f32>(_e205);
                            local_3.member_2[_e187.member_1][3u] = bitcast<f32>(_e209);
                        }
                        continue;
                        continuing {
                            phi_305_ = _e185;
                            phi_1326_ = false;
                            break if !(_e191);
                        }
                    }
                    let _e229 = phi_1326_;
                    if _e229 {
                        break;
                    }
                    let _e230 = local_3;
                    local_2 = _e230;
                    let _e231 = local_3.member;
                    local_2.member = array<f32, 3>(((_e231[0] * _e128) * _e134), ((_e231[1] * _e128) * _e134), ((_e231[2] * _e128) * _e134));
                    phi_413_ = type_11(0u, 4u);
                    loop {
                        let _e244 = phi_413_;
                        if (_e244.member < _e244.member_1) {
                            phi_414_ = type_11((_e244.member + 1u), _e244.member_1);
                            phi_437_ = type_11(1u, _e244.member);
                        } else {
                            phi_414_ = _e244;
                            phi_437_ = type_11(0u, type_11().member_1);
                        }
                        let _e257 = phi_414_;
                        let _e259 = phi_437_;
                        let _e263 = (bitcast<i32>(_e259.member) != 0i);
                        if _e263 {
                            let _e264 = (_e259.member_1 < 4u);
                            if _e264 {
                            } else {
                                phi_1331_ = true;
                                break;
                            }
                            let _e268 = local_3.member_2[_e259.member_1][3u];
                            if _e264 {
                            } else {
                                phi_1331_ = true;
                                break;
                            }
                            local_2.member_2[_e259.member_1][3u] = ((_e268 * _e128) * _e134);
                        }
                        continue;
                        continuing {
                            phi_413_ = _e257;
                            phi_1331_ = _e229;
                            break if !(_e263);
                        }
                    }
                    let _e276 = phi_1331_;
                    if _e276 {
                        break;
                    }
                    let _e277 = local_2;
                    local = _e277.member_2;
                    let _e286 = (_e74 < arrayLength((&global_9.member)));
                    if _e286 {
                        if _e286 {
                        } else {
                            break;
                        }
                        let _e288 = global_9.member[_e74];
                        phi_595_ = _e288;
                    } else {
                        phi_595_ = 4294967295u;
                    }
                    let _e290 = phi_595_;
                    let _e291 = (_e290 < arrayLength((&global_10.member)));
                    if _e291 {
                        if _e291 {
                        } else {
                            break;
                        }
                        let _e293 = global_10.member[_e290];
                        phi_612_ = _e293;
                    } else {
                        phi_612_ = 0i;
                    }
                    let _e295 = phi_612_;
                    let _e296 = (_e295 == 0i);
                    if _e296 {
                        phi_625_ = select(true, false, (_e277.member_1 == 0u));
                    } else {
                        phi_625_ = true;
                    }
                    let _e300 = phi_625_;
                    if _e300 {
                        if _e79 {
                            if _e79 {
                            } else {
                                break;
                            }
                            let _e302 = global_8.member[_e74];
                            phi_642_ = _e302;
                        } else {
                            phi_642_ = array<u32, 3>(0u, 0u, 0u);
                        }
                        let _e304 = phi_642_;
                        let _e306 = (_e304[0] < _e59);
                        if _e306 {
                            if _e306 {
                            } else {
                                break;
                            }
                            let _e308 = global_7.member[_e304[0]];
                            phi_657_ = _e308;
                        } else {
                            phi_657_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e310 = phi_657_;
                        let _e315 = (_e304[1] < _e59);
                        if _e315 {
                            if _e315 {
                            } else {
                                break;
                            }
                            let _e317 = global_7.member[_e304[1]];
                            phi_675_ = _e317;
                        } else {
                            phi_675_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e319 = phi_675_;
                        let _e324 = (_e304[2] < _e59);
                        if _e324 {
                            if _e324 {
                            } else {
                                break;
                            }
                            let _e326 = global_7.member[_e304[2]];
                            phi_693_ = _e326;
                        } else {
                            phi_693_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e328 = phi_693_;
                        let _e333 = ((_e310[0] * _e128) * _e134);
                        let _e335 = select(_e333, 0f, (_e333 == 0f));
                        let _e337 = ((_e310[1] * _e128) * _e134);
                        let _e339 = select(_e337, 0f, (_e337 == 0f));
                        let _e341 = ((_e310[2] * _e128) * _e134);
                        let _e343 = select(_e341, 0f, (_e341 == 0f));
                        let _e345 = ((_e319[0] * _e128) * _e134);
                        let _e347 = select(_e345, 0f, (_e345 == 0f));
                        let _e349 = ((_e319[1] * _e128) * _e134);
                        let _e351 = select(_e349, 0f, (_e349 == 0f));
                        let _e353 = ((_e319[2] * _e128) * _e134);
                        let _e355 = select(_e353, 0f, (_e353 == 0f));
                        let _e357 = ((_e328[0] * _e128) * _e134);
                        let _e359 = select(_e357, 0f, (_e357 == 0f));
                        let _e361 = ((_e328[1] * _e128) * _e134);
                        let _e363 = select(_e361, 0f, (_e361 == 0f));
                        let _e365 = ((_e328[2] * _e128) * _e134);
                        let _e367 = select(_e365, 0f, (_e365 == 0f));
                        if _e296 {
                            phi_996_ = true;
                        } else {
                            let _e368 = (_e347 - _e335);
                            let _e369 = (_e351 - _e339);
                            let _e370 = (_e355 - _e343);
                            let _e371 = (_e359 - _e335);
                            let _e372 = (_e363 - _e339);
                            let _e373 = (_e367 - _e343);
                            if (_e147.member_1 == 1u) {
                                phi_800_ = vec3<f32>((_e147.member[0] - _e335), (_e147.member[1] - _e339), (_e147.member[2] - _e343));
                            } else {
                                phi_800_ = vec3<f32>(_e147.member[0], _e147.member[1], _e147.member[2]);
                            }
                            let _e387 = phi_800_;
                            let _e391 = bitcast<f32>((bitcast<u32>((_e368 * _e372)) ^ _e147.member_3[0]));
                            let _e395 = bitcast<f32>((bitcast<u32>((_e369 * _e371)) ^ _e147.member_3[0]));
                            let _e399 = bitcast<f32>((bitcast<u32>((_e369 * _e373)) ^ _e147.member_3[0]));
                            let _e403 = bitcast<f32>((bitcast<u32>((_e370 * _e372)) ^ _e147.member_3[0]));
                            let _e407 = bitcast<f32>((bitcast<u32>((_e370 * _e371)) ^ _e147.member_3[0]));
                            let _e411 = bitcast<f32>((bitcast<u32>((_e368 * _e373)) ^ _e147.member_3[0]));
                            let _e412 = (_e399 - _e403);
                            let _e413 = (_e407 - _e411);
                            let _e414 = (_e391 - _e395);
                            let _e438 = (bitcast<f32>((bitcast<u32>(_e399) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e403) & 2147483647u)));
                            let _e445 = (bitcast<f32>((bitcast<u32>(_e407) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e411) & 2147483647u)));
                            let _e452 = (bitcast<f32>((bitcast<u32>(_e391) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e395) & 2147483647u)));
                            let _e478 = bitcast<f32>((bitcast<u32>(_e412) & 2147483647u));
                            let _e481 = bitcast<f32>((bitcast<u32>(_e413) & 2147483647u));
                            let _e484 = bitcast<f32>((bitcast<u32>(_e414) & 2147483647u));
                            let _e486 = select(_e484, _e481, (_e481 > _e484));
                            let _e490 = select(_e484, _e481, (_e481 < _e484));
                            let _e494 = select(_e481, _e478, (_e478 < _e481));
                            let _e496 = select(_e481, _e478, (_e478 > _e481));
                            let _e498 = select(_e484, _e496, (_e496 < _e484));
                            phi_996_ = !(((((bitcast<f32>((bitcast<u32>((_e387.x * _e412)) ^ _e147.member_3[0])) + bitcast<f32>((bitcast<u32>((_e387.y * _e413)) ^ _e147.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e387.z * _e414)) ^ _e147.member_3[0]))) * f32(-(_e295))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e387.x) & 2147483647u)) * _e438)) ^ _e147.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e387.y) & 2147483647u)) * _e445)) ^ _e147.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e387.z) & 2147483647u)) * _e452)) ^ _e147.member_3[0]))))) ^ _e147.member_3[0])) + bitcast<f32>((bitcast<u32>((_e147.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e486, _e478, (_e478 > _e486)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e498, _e494, (_e494 > _e498)))) ^ _e147.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e490, _e478, (_e478 < _e490)))) ^ _e147.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e438 + _e445) + _e452))) ^ _e147.member_3[0]))) * 1.0000005f)) ^ _e147.member_3[0])))) ^ _e147.member_3[0]))) + 0.0000000000000000000000000000000000001880791f)));
                        }
                        let _e538 = phi_996_;
                        if _e538 {
                            local_1[0u] = vec3<f32>((_e335 - _e277.member[0]), (_e339 - _e277.member[1]), (_e343 - _e277.member[2]));
                            local_1[1u] = vec3<f32>((_e347 - _e277.member[0]), (_e351 - _e277.member[1]), (_e355 - _e277.member[2]));
                            local_1[2u] = vec3<f32>((_e359 - _e277.member[0]), (_e363 - _e277.member[1]), (_e367 - _e277.member[2]));
                            phi_1340_ = _e276;
                            phi_1027_ = type_11(0u, 4u);
                            phi_1030_ = false;
                            loop {
                                let _e558 = phi_1340_;
                                let _e560 = phi_1027_;
                                let _e562 = phi_1030_;
                                local_5 = _e562;
                                if (_e560.member < _e560.member_1) {
                                    phi_1028_ = type_11((_e560.member + 1u), _e560.member_1);
                                    phi_1053_ = type_11(1u, _e560.member);
                                } else {
                                    phi_1028_ = _e560;
                                    phi_1053_ = type_11(0u, type_11().member_1);
                                }
                                let _e575 = phi_1028_;
                                let _e577 = phi_1053_;
                                let _e581 = (bitcast<i32>(_e577.member) != 0i);
                                if _e581 {
                                    if (_e577.member_1 < 4u) {
                                    } else {
                                        phi_1368_ = true;
                                        break;
                                    }
                                    let _e585 = local[_e577.member_1][0u];
                                    let _e588 = local[_e577.member_1][1u];
                                    let _e591 = local[_e577.member_1][2u];
                                    let _e594 = local[_e577.member_1][3u];
                                    phi_1087_ = type_11(0u, 3u);
                                    phi_1090_ = true;
                                    loop {
                                        let _e596 = phi_1087_;
                                        let _e598 = phi_1090_;
                                        local_4 = _e598;
                                        if (_e596.member < _e596.member_1) {
                                            phi_1088_ = type_11((_e596.member + 1u), _e596.member_1);
                                            phi_1113_ = type_11(1u, _e596.member);
                                        } else {
                                            phi_1088_ = _e596;
                                            phi_1113_ = type_11(0u, type_11().member_1);
                                        }
                                        let _e611 = phi_1088_;
                                        let _e613 = phi_1113_;
                                        let _e617 = (bitcast<i32>(_e613.member) != 0i);
                                        if _e617 {
                                            if (_e613.member_1 < 3u) {
                                            } else {
                                                phi_1335_ = true;
                                                break;
                                            }
                                            let _e621 = local_1[_e613.member_1][0u];
                                            let _e624 = local_1[_e613.member_1][1u];
                                            let _e627 = local_1[_e613.member_1][2u];
                                            phi_1091_ = (_e598 && (((((_e585 * _e621) + (_e588 * _e624)) + (_e591 * _e627)) + _e594) < (-0.0000000000000000000000000000000000001880791f - (0.000003814712f * (((bitcast<f32>((bitcast<u32>(_e621) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e624) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e627) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e594) & 2147483647u)))))));
                                        } else {
                                            phi_1091_ = bool();
                                        }
                                        let _e654 = phi_1091_;
                                        continue;
                                        continuing {
                                            phi_1087_ = _e611;
                                            phi_1090_ = _e654;
                                            phi_1335_ = _e558;
                                            break if !(_e617);
                                        }
                                    }
                                    let _e657 = phi_1335_;
                                    phi_1368_ = _e657;
                                    if _e657 {
                                        break;
                                    }
                                    let _e659 = local_4;
                                    phi_1369_ = _e657;
                                    phi_1031_ = (_e562 || _e659);
                                } else {
                                    phi_1369_ = _e558;
                                    phi_1031_ = bool();
                                }
                                let _e662 = phi_1369_;
                                let _e664 = phi_1031_;
                                continue;
                                continuing {
                                    phi_1340_ = _e662;
                                    phi_1027_ = _e575;
                                    phi_1030_ = _e664;
                                    phi_1368_ = _e662;
                                    break if !(_e581);
                                }
                            }
                            let _e667 = phi_1368_;
                            if _e667 {
                                break;
                            }
                            let _e670 = local_5;
                            phi_1377_ = _e667;
                            phi_1177_ = !(select(false, _e670, (_e277.member_1 == 1u)));
                        } else {
                            phi_1377_ = _e276;
                            phi_1177_ = false;
                        }
                        let _e674 = phi_1377_;
                        let _e676 = phi_1177_;
                        phi_1376_ = _e674;
                        phi_1178_ = _e676;
                    } else {
                        phi_1376_ = _e276;
                        phi_1178_ = true;
                    }
                    let _e678 = phi_1376_;
                    let _e680 = phi_1178_;
                    phi_1375_ = _e678;
                    phi_1180_ = select(0u, 1u, _e680);
                } else {
                    phi_1375_ = false;
                    phi_1180_ = 0u;
                }
                let _e683 = phi_1375_;
                let _e685 = phi_1180_;
                phi_1374_ = _e683;
                phi_1181_ = _e685;
            } else {
                phi_1374_ = false;
                phi_1181_ = 0u;
            }
            let _e687 = phi_1374_;
            let _e689 = phi_1181_;
            let _e690 = (_e56 % 64u);
            if (_e690 < 64u) {
            } else {
                break;
            }
            global_4[_e690] = _e689;
            workgroupBarrier();
            let _e693 = (_e74 / 32u);
            if ((_e56 & 31u) == 0u) {
                let _e696 = (_e693 < arrayLength((&global_11.member)));
                if _e696 {
                    phi_1201_ = type_11(0u, 32u);
                    phi_1204_ = 0u;
                    loop {
                        let _e698 = phi_1201_;
                        let _e700 = phi_1204_;
                        local_6 = _e700;
                        if (_e698.member < _e698.member_1) {
                            phi_1202_ = type_11((_e698.member + 1u), _e698.member_1);
                            phi_1227_ = type_11(1u, _e698.member);
                        } else {
                            phi_1202_ = _e698;
                            phi_1227_ = type_11(0u, type_11().member_1);
                        }
                        let _e713 = phi_1202_;
                        let _e715 = phi_1227_;
                        let _e719 = (bitcast<i32>(_e715.member) != 0i);
                        if _e719 {
                            let _e721 = ((_e56 + _e715.member_1) % 64u);
                            if (_e721 < 64u) {
                            } else {
                                phi_1370_ = true;
                                break;
                            }
                            let _e724 = global_4[_e721];
                            phi_1205_ = (_e700 | (_e724 << bitcast<u32>((_e715.member_1 & 31u))));
                        } else {
                            phi_1205_ = u32();
                        }
                        let _e730 = phi_1205_;
                        continue;
                        continuing {
                            phi_1201_ = _e713;
                            phi_1204_ = _e730;
                            phi_1370_ = _e687;
                            break if !(_e719);
                        }
                    }
                    let _e733 = phi_1370_;
                    if _e733 {
                        break;
                    }
                    if _e696 {
                    } else {
                        break;
                    }
                    let _e737 = local_6;
                    global_11.member[_e693] = _e737;
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
