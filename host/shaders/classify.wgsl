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
    member: array<vec4<u32>, 2>,
}

struct type_39 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_42 {
    member: array<i32>,
}

struct type_47 {
    member: array<vec4<u32>, 5>,
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
var<uniform> global_3: type_35;
var<workgroup> global_4: array<u32, 64>;
@group(0) @binding(2) 
var<uniform> global_5: type_47;
@group(0) @binding(3) 
var<storage> global_6: type_21;
@group(0) @binding(4) 
var<storage> global_7: type_25;
@group(0) @binding(5) 
var<storage> global_8: type_5;
@group(0) @binding(6) 
var<storage> global_9: type_42;
@group(0) @binding(7) 
var<storage, read_write> global_10: type_5;

fn function_() {
    var local: array<array<f32, 4>, 4>;
    var local_1: array<vec3<f32>, 3>;
    var local_2: type_53;
    var local_3: type_53;
    var phi_247_: type_39;
    var phi_297_: type_11;
    var phi_298_: type_11;
    var phi_321_: type_11;
    var phi_1317_: bool;
    var phi_405_: type_11;
    var phi_406_: type_11;
    var phi_429_: type_11;
    var phi_1322_: bool;
    var phi_587_: u32;
    var phi_604_: i32;
    var phi_617_: bool;
    var phi_634_: array<u32, 3>;
    var phi_649_: array<f32, 3>;
    var phi_667_: array<f32, 3>;
    var phi_685_: array<f32, 3>;
    var phi_792_: vec3<f32>;
    var phi_988_: bool;
    var phi_1331_: bool;
    var phi_1019_: type_11;
    var phi_1022_: bool;
    var phi_1020_: type_11;
    var phi_1045_: type_11;
    var phi_1079_: type_11;
    var phi_1082_: bool;
    var phi_1080_: type_11;
    var phi_1105_: type_11;
    var phi_1083_: bool;
    var phi_1326_: bool;
    var local_4: bool;
    var phi_1360_: bool;
    var phi_1023_: bool;
    var phi_1359_: bool;
    var local_5: bool;
    var phi_1367_: bool;
    var phi_1169_: bool;
    var phi_1366_: bool;
    var phi_1170_: bool;
    var phi_1365_: bool;
    var phi_1172_: u32;
    var phi_1192_: type_11;
    var phi_1195_: u32;
    var phi_1193_: type_11;
    var phi_1218_: type_11;
    var phi_1196_: u32;
    var phi_1361_: bool;
    var local_6: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e54 = global_1;
            let _e55 = global;
            let _e58 = arrayLength((&global_6.member));
            let _e73 = (_e54.x + (_e54.y * 2097152u));
            let _e74 = (_e73 < arrayLength((&global_7.member)));
            if _e74 {
                let _e77 = global_2.member[0u];
                let _e81 = global_3.member[0u][0u];
                let _e85 = global_3.member[0u][1u];
                let _e89 = global_3.member[0u][2u];
                let _e93 = global_3.member[0u][3u];
                let _e97 = global_3.member[1u][0u];
                let _e101 = global_3.member[1u][1u];
                let _e105 = global_3.member[1u][2u];
                let _e109 = global_3.member[1u][3u];
                let _e110 = bitcast<f32>(_e81);
                let _e111 = bitcast<f32>(_e85);
                let _e112 = bitcast<f32>(_e89);
                let _e114 = bitcast<f32>(_e97);
                let _e115 = array<u32, 3>(_e101, _e105, _e109);
                let _e117 = bitcast<i32>(_e77);
                let _e118 = (_e117 / 2i);
                let _e123 = bitcast<f32>((bitcast<u32>((_e118 + 127i)) << bitcast<u32>(23i)));
                let _e129 = bitcast<f32>((bitcast<u32>(((_e117 - _e118) + 127i)) << bitcast<u32>(23i)));
                if (_e93 == 0u) {
                    phi_247_ = type_39(array<f32, 3>(_e110, _e111, _e112), _e93, _e114, _e115);
                } else {
                    phi_247_ = type_39(array<f32, 3>(((_e110 * _e123) * _e129), ((_e111 * _e123) * _e129), ((_e112 * _e123) * _e129)), _e93, ((_e114 * _e123) * _e129), _e115);
                }
                let _e142 = phi_247_;
                let _e146 = global_5.member[0u][0u];
                let _e150 = global_5.member[0u][1u];
                let _e154 = global_5.member[0u][2u];
                let _e158 = global_5.member[0u][3u];
                local_3.member = array<f32, 3>(bitcast<f32>(_e146), bitcast<f32>(_e150), bitcast<f32>(_e154));
                local_3.member_1 = _e158;
                local_3.member_2 = array<array<f32, 4>, 4>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f));
                phi_297_ = type_11(0u, 4u);
                loop {
                    let _e167 = phi_297_;
                    if (_e167.member < _e167.member_1) {
                        phi_298_ = type_11((_e167.member + 1u), _e167.member_1);
                        phi_321_ = type_11(1u, _e167.member);
                    } else {
                        phi_298_ = _e167;
                        phi_321_ = type_11(0u, type_11().member_1);
                    }
                    let _e180 = phi_298_;
                    let _e182 = phi_321_;
                    let _e186 = (bitcast<i32>(_e182.member) != 0i);
                    if _e186 {
                        let _e187 = (_e182.member_1 + 1u);
                        if (_e187 < 5u) {
                        } else {
                            phi_1317_ = true;
                            break;
                        }
                        let _e192 = global_5.member[_e187][0u];
                        let _e196 = global_5.member[_e187][1u];
                        let _e200 = global_5.member[_e187][2u];
                        let _e204 = global_5.member[_e187][3u];
                        if (_e182.member_1 < 4u) {
                        } else {
                            phi_1317_ = true;
                            break;
                        }
                        local_3.member_2[_e182.member_1][0u] = bitcast<f32>(_e192);
                        local_3.member_2[_e182.member_1][1u] = bitcast<f32>(_e196);
                        local_3.member_2[_e182.member_1][2u] = bitcast<f32>(_e200);
                        local_3.member_2[_e182.member_1][3u] = bitcast<f32>(_e204);
                    }
                    continue;
                    continuing {
                        phi_297_ = _e180;
                        phi_1317_ = false;
                        break if !(_e186);
                    }
                }
                let _e224 = phi_1317_;
                if _e224 {
                    break;
                }
                let _e225 = local_3;
                local_2 = _e225;
                let _e226 = local_3.member;
                local_2.member = array<f32, 3>(((_e226[0] * _e123) * _e129), ((_e226[1] * _e123) * _e129), ((_e226[2] * _e123) * _e129));
                phi_405_ = type_11(0u, 4u);
                loop {
                    let _e239 = phi_405_;
                    if (_e239.member < _e239.member_1) {
                        phi_406_ = type_11((_e239.member + 1u), _e239.member_1);
                        phi_429_ = type_11(1u, _e239.member);
                    } else {
                        phi_406_ = _e239;
                        phi_429_ = type_11(0u, type_11().member_1);
                    }
                    let _e252 = phi_406_;
                    let _e254 = phi_429_;
                    let _e258 = (bitcast<i32>(_e254.member) != 0i);
                    if _e258 {
                        let _e259 = (_e254.member_1 < 4u);
                        if _e259 {
                        } else {
                            phi_1322_ = true;
                            break;
                        }
                        let _e263 = local_3.member_2[_e254.member_1][3u];
                        if _e259 {
                        } else {
                            phi_1322_ = true;
                            break;
                        }
                        local_2.member_2[_e254.member_1][3u] = ((_e263 * _e123) * _e129);
                    }
                    continue;
                    continuing {
                        phi_405_ = _e252;
                        phi_1322_ = _e224;
                        break if !(_e258);
                    }
                }
                let _e271 = phi_1322_;
                if _e271 {
                    break;
                }
                let _e272 = local_2;
                local = _e272.member_2;
                let _e281 = (_e73 < arrayLength((&global_8.member)));
                if _e281 {
                    if _e281 {
                    } else {
                        break;
                    }
                    let _e283 = global_8.member[_e73];
                    phi_587_ = _e283;
                } else {
                    phi_587_ = 4294967295u;
                }
                let _e285 = phi_587_;
                let _e286 = (_e285 < arrayLength((&global_9.member)));
                if _e286 {
                    if _e286 {
                    } else {
                        break;
                    }
                    let _e288 = global_9.member[_e285];
                    phi_604_ = _e288;
                } else {
                    phi_604_ = 0i;
                }
                let _e290 = phi_604_;
                let _e291 = (_e290 == 0i);
                if _e291 {
                    phi_617_ = select(true, false, (_e272.member_1 == 0u));
                } else {
                    phi_617_ = true;
                }
                let _e295 = phi_617_;
                if _e295 {
                    if _e74 {
                        if _e74 {
                        } else {
                            break;
                        }
                        let _e297 = global_7.member[_e73];
                        phi_634_ = _e297;
                    } else {
                        phi_634_ = array<u32, 3>(0u, 0u, 0u);
                    }
                    let _e299 = phi_634_;
                    let _e301 = (_e299[0] < _e58);
                    if _e301 {
                        if _e301 {
                        } else {
                            break;
                        }
                        let _e303 = global_6.member[_e299[0]];
                        phi_649_ = _e303;
                    } else {
                        phi_649_ = array<f32, 3>(0f, 0f, 0f);
                    }
                    let _e305 = phi_649_;
                    let _e310 = (_e299[1] < _e58);
                    if _e310 {
                        if _e310 {
                        } else {
                            break;
                        }
                        let _e312 = global_6.member[_e299[1]];
                        phi_667_ = _e312;
                    } else {
                        phi_667_ = array<f32, 3>(0f, 0f, 0f);
                    }
                    let _e314 = phi_667_;
                    let _e319 = (_e299[2] < _e58);
                    if _e319 {
                        if _e319 {
                        } else {
                            break;
                        }
                        let _e321 = global_6.member[_e299[2]];
                        phi_685_ = _e321;
                    } else {
                        phi_685_ = array<f32, 3>(0f, 0f, 0f);
                    }
                    let _e323 = phi_685_;
                    let _e328 = ((_e305[0] * _e123) * _e129);
                    let _e330 = select(_e328, 0f, (_e328 == 0f));
                    let _e332 = ((_e305[1] * _e123) * _e129);
                    let _e334 = select(_e332, 0f, (_e332 == 0f));
                    let _e336 = ((_e305[2] * _e123) * _e129);
                    let _e338 = select(_e336, 0f, (_e336 == 0f));
                    let _e340 = ((_e314[0] * _e123) * _e129);
                    let _e342 = select(_e340, 0f, (_e340 == 0f));
                    let _e344 = ((_e314[1] * _e123) * _e129);
                    let _e346 = select(_e344, 0f, (_e344 == 0f));
                    let _e348 = ((_e314[2] * _e123) * _e129);
                    let _e350 = select(_e348, 0f, (_e348 == 0f));
                    let _e352 = ((_e323[0] * _e123) * _e129);
                    let _e354 = select(_e352, 0f, (_e352 == 0f));
                    let _e356 = ((_e323[1] * _e123) * _e129);
                    let _e358 = select(_e356, 0f, (_e356 == 0f));
                    let _e360 = ((_e323[2] * _e123) * _e129);
                    let _e362 = select(_e360, 0f, (_e360 == 0f));
                    if _e291 {
                        phi_988_ = true;
                    } else {
                        let _e363 = (_e342 - _e330);
                        let _e364 = (_e346 - _e334);
                        let _e365 = (_e350 - _e338);
                        let _e366 = (_e354 - _e330);
                        let _e367 = (_e358 - _e334);
                        let _e368 = (_e362 - _e338);
                        if (_e142.member_1 == 1u) {
                            phi_792_ = vec3<f32>((_e142.member[0] - _e330), (_e142.member[1] - _e334), (_e142.member[2] - _e338));
                        } else {
                            phi_792_ = vec3<f32>(_e142.member[0], _e142.member[1], _e142.member[2]);
                        }
                        let _e382 = phi_792_;
                        let _e386 = bitcast<f32>((bitcast<u32>((_e363 * _e367)) ^ _e142.member_3[0]));
                        let _e390 = bitcast<f32>((bitcast<u32>((_e364 * _e366)) ^ _e142.member_3[0]));
                        let _e394 = bitcast<f32>((bitcast<u32>((_e364 * _e368)) ^ _e142.member_3[0]));
                        let _e398 = bitcast<f32>((bitcast<u32>((_e365 * _e367)) ^ _e142.member_3[0]));
                        let _e402 = bitcast<f32>((bitcast<u32>((_e365 * _e366)) ^ _e142.member_3[0]));
                        let _e406 = bitcast<f32>((bitcast<u32>((_e363 * _e368)) ^ _e142.member_3[0]));
                        let _e407 = (_e394 - _e398);
                        let _e408 = (_e402 - _e406);
                        let _e409 = (_e386 - _e390);
                        let _e433 = (bitcast<f32>((bitcast<u32>(_e394) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e398) & 2147483647u)));
                        let _e440 = (bitcast<f32>((bitcast<u32>(_e402) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e406) & 2147483647u)));
                        let _e447 = (bitcast<f32>((bitcast<u32>(_e386) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e390) & 2147483647u)));
                        let _e473 = bitcast<f32>((bitcast<u32>(_e407) & 2147483647u));
                        let _e476 = bitcast<f32>((bitcast<u32>(_e408) & 2147483647u));
                        let _e479 = bitcast<f32>((bitcast<u32>(_e409) & 2147483647u));
                        let _e481 = select(_e479, _e476, (_e476 > _e479));
                        let _e485 = select(_e479, _e476, (_e476 < _e479));
                        let _e489 = select(_e476, _e473, (_e473 < _e476));
                        let _e491 = select(_e476, _e473, (_e473 > _e476));
                        let _e493 = select(_e479, _e491, (_e491 < _e479));
                        phi_988_ = !(((((bitcast<f32>((bitcast<u32>((_e382.x * _e407)) ^ _e142.member_3[0])) + bitcast<f32>((bitcast<u32>((_e382.y * _e408)) ^ _e142.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e382.z * _e409)) ^ _e142.member_3[0]))) * f32(-(_e290))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e382.x) & 2147483647u)) * _e433)) ^ _e142.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e382.y) & 2147483647u)) * _e440)) ^ _e142.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e382.z) & 2147483647u)) * _e447)) ^ _e142.member_3[0]))))) ^ _e142.member_3[0])) + bitcast<f32>((bitcast<u32>((_e142.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e481, _e473, (_e473 > _e481)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e493, _e489, (_e489 > _e493)))) ^ _e142.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e485, _e473, (_e473 < _e485)))) ^ _e142.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e433 + _e440) + _e447))) ^ _e142.member_3[0]))) * 1.0000005f)) ^ _e142.member_3[0])))) ^ _e142.member_3[0]))) + 0.0000000000000000000000000000000000001880791f)));
                    }
                    let _e533 = phi_988_;
                    if _e533 {
                        local_1[0u] = vec3<f32>((_e330 - _e272.member[0]), (_e334 - _e272.member[1]), (_e338 - _e272.member[2]));
                        local_1[1u] = vec3<f32>((_e342 - _e272.member[0]), (_e346 - _e272.member[1]), (_e350 - _e272.member[2]));
                        local_1[2u] = vec3<f32>((_e354 - _e272.member[0]), (_e358 - _e272.member[1]), (_e362 - _e272.member[2]));
                        phi_1331_ = _e271;
                        phi_1019_ = type_11(0u, 4u);
                        phi_1022_ = false;
                        loop {
                            let _e553 = phi_1331_;
                            let _e555 = phi_1019_;
                            let _e557 = phi_1022_;
                            local_5 = _e557;
                            if (_e555.member < _e555.member_1) {
                                phi_1020_ = type_11((_e555.member + 1u), _e555.member_1);
                                phi_1045_ = type_11(1u, _e555.member);
                            } else {
                                phi_1020_ = _e555;
                                phi_1045_ = type_11(0u, type_11().member_1);
                            }
                            let _e570 = phi_1020_;
                            let _e572 = phi_1045_;
                            let _e576 = (bitcast<i32>(_e572.member) != 0i);
                            if _e576 {
                                if (_e572.member_1 < 4u) {
                                } else {
                                    phi_1359_ = true;
                                    break;
                                }
                                let _e580 = local[_e572.member_1][0u];
                                let _e583 = local[_e572.member_1][1u];
                                let _e586 = local[_e572.member_1][2u];
                                let _e589 = local[_e572.member_1][3u];
                                phi_1079_ = type_11(0u, 3u);
                                phi_1082_ = true;
                                loop {
                                    let _e591 = phi_1079_;
                                    let _e593 = phi_1082_;
                                    local_4 = _e593;
                                    if (_e591.member < _e591.member_1) {
                                        phi_1080_ = type_11((_e591.member + 1u), _e591.member_1);
                                        phi_1105_ = type_11(1u, _e591.member);
                                    } else {
                                        phi_1080_ = _e591;
                                        phi_1105_ = type_11(0u, type_11().member_1);
                                    }
                                    let _e606 = phi_1080_;
                                    let _e608 = phi_1105_;
                                    let _e612 = (bitcast<i32>(_e608.member) != 0i);
                                    if _e612 {
                                        if (_e608.member_1 < 3u) {
                                        } else {
                                            phi_1326_ = true;
                                            break;
                                        }
                                        let _e616 = local_1[_e608.member_1][0u];
                                        let _e619 = local_1[_e608.member_1][1u];
                                        let _e622 = local_1[_e608.member_1][2u];
                                        phi_1083_ = (_e593 && (((((_e580 * _e616) + (_e583 * _e619)) + (_e586 * _e622)) + _e589) < (-0.0000000000000000000000000000000000001880791f - (0.000003814712f * (((bitcast<f32>((bitcast<u32>(_e616) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e619) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e622) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e589) & 2147483647u)))))));
                                    } else {
                                        phi_1083_ = bool();
                                    }
                                    let _e649 = phi_1083_;
                                    continue;
                                    continuing {
                                        phi_1079_ = _e606;
                                        phi_1082_ = _e649;
                                        phi_1326_ = _e553;
                                        break if !(_e612);
                                    }
                                }
                                let _e652 = phi_1326_;
                                phi_1359_ = _e652;
                                if _e652 {
                                    break;
                                }
                                let _e654 = local_4;
                                phi_1360_ = _e652;
                                phi_1023_ = (_e557 || _e654);
                            } else {
                                phi_1360_ = _e553;
                                phi_1023_ = bool();
                            }
                            let _e657 = phi_1360_;
                            let _e659 = phi_1023_;
                            continue;
                            continuing {
                                phi_1331_ = _e657;
                                phi_1019_ = _e570;
                                phi_1022_ = _e659;
                                phi_1359_ = _e657;
                                break if !(_e576);
                            }
                        }
                        let _e662 = phi_1359_;
                        if _e662 {
                            break;
                        }
                        let _e665 = local_5;
                        phi_1367_ = _e662;
                        phi_1169_ = !(select(false, _e665, (_e272.member_1 == 1u)));
                    } else {
                        phi_1367_ = _e271;
                        phi_1169_ = false;
                    }
                    let _e669 = phi_1367_;
                    let _e671 = phi_1169_;
                    phi_1366_ = _e669;
                    phi_1170_ = _e671;
                } else {
                    phi_1366_ = _e271;
                    phi_1170_ = true;
                }
                let _e673 = phi_1366_;
                let _e675 = phi_1170_;
                phi_1365_ = _e673;
                phi_1172_ = select(0u, 1u, _e675);
            } else {
                phi_1365_ = false;
                phi_1172_ = 0u;
            }
            let _e678 = phi_1365_;
            let _e680 = phi_1172_;
            let _e681 = (_e55 % 64u);
            if (_e681 < 64u) {
            } else {
                break;
            }
            global_4[_e681] = _e680;
            workgroupBarrier();
            let _e684 = (_e73 / 32u);
            if ((_e55 & 31u) == 0u) {
                let _e687 = (_e684 < arrayLength((&global_10.member)));
                if _e687 {
                    phi_1192_ = type_11(0u, 32u);
                    phi_1195_ = 0u;
                    loop {
                        let _e689 = phi_1192_;
                        let _e691 = phi_1195_;
                        local_6 = _e691;
                        if (_e689.member < _e689.member_1) {
                            phi_1193_ = type_11((_e689.member + 1u), _e689.member_1);
                            phi_1218_ = type_11(1u, _e689.member);
                        } else {
                            phi_1193_ = _e689;
                            phi_1218_ = type_11(0u, type_11().member_1);
                        }
                        let _e704 = phi_1193_;
                        let _e706 = phi_1218_;
                        let _e710 = (bitcast<i32>(_e706.member) != 0i);
                        if _e710 {
                            let _e712 = ((_e55 + _e706.member_1) % 64u);
                            if (_e712 < 64u) {
                            } else {
                                phi_1361_ = true;
                                break;
                            }
                            let _e715 = global_4[_e712];
                            phi_1196_ = (_e691 | (_e715 << bitcast<u32>((_e706.member_1 & 31u))));
                        } else {
                            phi_1196_ = u32();
                        }
                        let _e721 = phi_1196_;
                        continue;
                        continuing {
                            phi_1192_ = _e704;
                            phi_1195_ = _e721;
                            phi_1361_ = _e678;
                            break if !(_e710);
                        }
                    }
                    let _e724 = phi_1361_;
                    if _e724 {
                        break;
                    }
                    if _e687 {
                    } else {
                        break;
                    }
                    let _e728 = local_6;
                    global_10.member[_e684] = _e728;
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
