struct type_5 {
    member: array<u32>,
}

struct type_9 {
    member: u32,
    member_1: u32,
}

struct type_13 {
    member: vec4<u32>,
}

struct type_18 {
    member: array<array<f32, 3>>,
}

struct type_22 {
    member: array<array<u32, 3>>,
}

struct type_30 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_31 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_33 {
    member: array<vec4<u32>, 2>,
}

struct type_36 {
    member: array<i32>,
}

struct type_41 {
    member: array<type_30>,
}

var<private> global: vec3<u32>;
var<private> global_1: u32;
@group(0) @binding(0) 
var<uniform> global_2: type_13;
@group(0) @binding(1) 
var<uniform> global_3: type_33;
@group(0) @binding(4) 
var<storage> global_4: type_5;
@group(0) @binding(5) 
var<storage> global_5: type_36;
@group(0) @binding(2) 
var<storage> global_6: type_18;
@group(0) @binding(3) 
var<storage> global_7: type_22;
@group(0) @binding(6) 
var<storage> global_8: type_36;
@group(0) @binding(7) 
var<storage, read_write> global_9: type_41;
var<workgroup> global_10: array<type_30, 64>;

fn function_() {
    var phi_168_: i32;
    var phi_221_: i32;
    var phi_361_: type_31;
    var phi_372_: type_9;
    var phi_375_: type_30;
    var phi_373_: type_9;
    var phi_398_: type_9;
    var phi_428_: u32;
    var phi_442_: i32;
    var phi_461_: array<u32, 3>;
    var phi_476_: array<f32, 3>;
    var phi_494_: array<f32, 3>;
    var phi_512_: array<f32, 3>;
    var phi_909_: vec3<f32>;
    var phi_1091_: f32;
    var phi_1127_: i32;
    var phi_1131_: type_30;
    var phi_1142_: type_30;
    var phi_376_: type_30;
    var phi_1274_: bool;
    var local: type_30;
    var local_1: type_30;
    var local_2: type_30;
    var local_3: type_30;
    var phi_1157_: type_9;
    var phi_1160_: u32;
    var phi_1158_: type_9;
    var phi_1183_: type_9;
    var phi_1161_: u32;
    var phi_1337_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e55 = global;
            let _e56 = global_1;
            let _e59 = arrayLength((&global_6.member));
            let _e77 = (_e55.x + (_e55.y * 32768u));
            let _e80 = global_2.member[0u];
            let _e81 = bitcast<i32>(_e80);
            let _e82 = (_e81 < -126i);
            if _e82 {
                phi_168_ = -126i;
            } else {
                phi_168_ = select(_e81, 127i, (_e81 > 127i));
            }
            let _e86 = phi_168_;
            let _e91 = bitcast<f32>((bitcast<u32>((_e86 + 127i)) << bitcast<u32>(23i)));
            let _e97 = bitcast<f32>((bitcast<u32>(((_e81 - _e86) + 127i)) << bitcast<u32>(23i)));
            let _e101 = global_3.member[0u][0u];
            let _e105 = global_3.member[0u][1u];
            let _e109 = global_3.member[0u][2u];
            let _e113 = global_3.member[0u][3u];
            let _e117 = global_3.member[1u][0u];
            let _e121 = global_3.member[1u][1u];
            let _e125 = global_3.member[1u][2u];
            let _e129 = global_3.member[1u][3u];
            let _e130 = bitcast<f32>(_e101);
            let _e131 = bitcast<f32>(_e105);
            let _e132 = bitcast<f32>(_e109);
            let _e134 = bitcast<f32>(_e117);
            let _e135 = array<u32, 3>(_e121, _e125, _e129);
            if _e82 {
                phi_221_ = -126i;
            } else {
                phi_221_ = select(_e81, 127i, (_e81 > 127i));
            }
            let _e140 = phi_221_;
            let _e145 = bitcast<f32>((bitcast<u32>((_e140 + 127i)) << bitcast<u32>(23i)));
            let _e151 = bitcast<f32>((bitcast<u32>(((_e81 - _e140) + 127i)) << bitcast<u32>(23i)));
            if (_e113 == 0u) {
                phi_361_ = type_31(array<f32, 3>(_e130, _e131, _e132), _e113, _e134, _e135);
            } else {
                let _e153 = bitcast<u32>(_e130);
                let _e155 = ((_e153 & 2139095040u) != 0u);
                let _e170 = bitcast<u32>(_e131);
                let _e172 = ((_e170 & 2139095040u) != 0u);
                let _e187 = bitcast<u32>(_e132);
                let _e189 = ((_e187 & 2139095040u) != 0u);
                let _e205 = bitcast<u32>(_e134);
                let _e207 = ((_e205 & 2139095040u) != 0u);
                phi_361_ = type_31(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e153 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e153 & 2147483648u))), _e130, _e155) * _e145) * select(0.00000011920929f, 1f, _e155)) * _e151), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e170 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e170 & 2147483648u))), _e131, _e172) * _e145) * select(0.00000011920929f, 1f, _e172)) * _e151), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e187 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e187 & 2147483648u))), _e132, _e189) * _e145) * select(0.00000011920929f, 1f, _e189)) * _e151)), _e113, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e205 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e205 & 2147483648u))), _e134, _e207) * _e145) * select(0.00000011920929f, 1f, _e207)) * _e151), _e135);
            }
            let _e224 = phi_361_;
            phi_372_ = type_9(0u, 16u);
            phi_375_ = type_30(0u, 0u, 0u, 0u);
            loop {
                let _e226 = phi_372_;
                let _e228 = phi_375_;
                local = _e228;
                local_1 = _e228;
                local_2 = _e228;
                local_3 = _e228;
                if (_e226.member < _e226.member_1) {
                    phi_373_ = type_9((_e226.member + 1u), _e226.member_1);
                    phi_398_ = type_9(1u, _e226.member);
                } else {
                    phi_373_ = _e226;
                    phi_398_ = type_9(0u, type_9().member_1);
                }
                let _e241 = phi_373_;
                let _e243 = phi_398_;
                let _e247 = (bitcast<i32>(_e243.member) != 0i);
                if _e247 {
                    let _e251 = (((_e77 * 1024u) + (_e243.member_1 * 64u)) + _e56);
                    let _e252 = (_e251 < arrayLength((&global_7.member)));
                    if _e252 {
                        let _e253 = (_e251 < arrayLength((&global_4.member)));
                        if _e253 {
                            if _e253 {
                            } else {
                                phi_1274_ = true;
                                break;
                            }
                            let _e255 = global_4.member[_e251];
                            phi_428_ = _e255;
                        } else {
                            phi_428_ = 4294967295u;
                        }
                        let _e257 = phi_428_;
                        let _e258 = (_e257 < arrayLength((&global_5.member)));
                        if _e258 {
                            if _e258 {
                            } else {
                                phi_1274_ = true;
                                break;
                            }
                            let _e260 = global_5.member[_e257];
                            phi_442_ = _e260;
                        } else {
                            phi_442_ = 0i;
                        }
                        let _e262 = phi_442_;
                        if (_e262 == 0i) {
                            phi_1131_ = type_30(1u, 1u, 0u, 0u);
                        } else {
                            if _e252 {
                                if _e252 {
                                } else {
                                    phi_1274_ = true;
                                    break;
                                }
                                let _e265 = global_7.member[_e251];
                                phi_461_ = _e265;
                            } else {
                                phi_461_ = array<u32, 3>(0u, 0u, 0u);
                            }
                            let _e267 = phi_461_;
                            let _e269 = (_e267[0] < _e59);
                            if _e269 {
                                if _e269 {
                                } else {
                                    phi_1274_ = true;
                                    break;
                                }
                                let _e271 = global_6.member[_e267[0]];
                                phi_476_ = _e271;
                            } else {
                                phi_476_ = array<f32, 3>(0f, 0f, 0f);
                            }
                            let _e273 = phi_476_;
                            let _e278 = (_e267[1] < _e59);
                            if _e278 {
                                if _e278 {
                                } else {
                                    phi_1274_ = true;
                                    break;
                                }
                                let _e280 = global_6.member[_e267[1]];
                                phi_494_ = _e280;
                            } else {
                                phi_494_ = array<f32, 3>(0f, 0f, 0f);
                            }
                            let _e282 = phi_494_;
                            let _e287 = (_e267[2] < _e59);
                            if _e287 {
                                if _e287 {
                                } else {
                                    phi_1274_ = true;
                                    break;
                                }
                                let _e289 = global_6.member[_e267[2]];
                                phi_512_ = _e289;
                            } else {
                                phi_512_ = array<f32, 3>(0f, 0f, 0f);
                            }
                            let _e291 = phi_512_;
                            let _e295 = bitcast<u32>(_e273[0]);
                            let _e297 = ((_e295 & 2139095040u) != 0u);
                            let _e311 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e295 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e295 & 2147483648u))), _e273[0], _e297) * _e91) * select(0.00000011920929f, 1f, _e297)) * _e97);
                            let _e316 = select(_e311, 0f, (bitcast<f32>((bitcast<u32>(_e311) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
                            let _e317 = bitcast<u32>(_e273[1]);
                            let _e319 = ((_e317 & 2139095040u) != 0u);
                            let _e333 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e317 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e317 & 2147483648u))), _e273[1], _e319) * _e91) * select(0.00000011920929f, 1f, _e319)) * _e97);
                            let _e338 = select(_e333, 0f, (bitcast<f32>((bitcast<u32>(_e333) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
                            let _e339 = bitcast<u32>(_e273[2]);
                            let _e341 = ((_e339 & 2139095040u) != 0u);
                            let _e355 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e339 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e339 & 2147483648u))), _e273[2], _e341) * _e91) * select(0.00000011920929f, 1f, _e341)) * _e97);
                            let _e360 = select(_e355, 0f, (bitcast<f32>((bitcast<u32>(_e355) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
                            let _e361 = bitcast<u32>(_e282[0]);
                            let _e363 = ((_e361 & 2139095040u) != 0u);
                            let _e377 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e361 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e361 & 2147483648u))), _e282[0], _e363) * _e91) * select(0.00000011920929f, 1f, _e363)) * _e97);
                            let _e383 = bitcast<u32>(_e282[1]);
                            let _e385 = ((_e383 & 2139095040u) != 0u);
                            let _e399 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e383 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e383 & 2147483648u))), _e282[1], _e385) * _e91) * select(0.00000011920929f, 1f, _e385)) * _e97);
                            let _e405 = bitcast<u32>(_e282[2]);
                            let _e407 = ((_e405 & 2139095040u) != 0u);
                            let _e421 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e405 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e405 & 2147483648u))), _e282[2], _e407) * _e91) * select(0.00000011920929f, 1f, _e407)) * _e97);
                            let _e427 = bitcast<u32>(_e291[0]);
                            let _e429 = ((_e427 & 2139095040u) != 0u);
                            let _e443 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e427 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e427 & 2147483648u))), _e291[0], _e429) * _e91) * select(0.00000011920929f, 1f, _e429)) * _e97);
                            let _e449 = bitcast<u32>(_e291[1]);
                            let _e451 = ((_e449 & 2139095040u) != 0u);
                            let _e465 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e449 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e449 & 2147483648u))), _e291[1], _e451) * _e91) * select(0.00000011920929f, 1f, _e451)) * _e97);
                            let _e471 = bitcast<u32>(_e291[2]);
                            let _e473 = ((_e471 & 2139095040u) != 0u);
                            let _e487 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e471 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e471 & 2147483648u))), _e291[2], _e473) * _e91) * select(0.00000011920929f, 1f, _e473)) * _e97);
                            let _e493 = (select(_e377, 0f, (bitcast<f32>((bitcast<u32>(_e377) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f)) - _e316);
                            let _e494 = (select(_e399, 0f, (bitcast<f32>((bitcast<u32>(_e399) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f)) - _e338);
                            let _e495 = (select(_e421, 0f, (bitcast<f32>((bitcast<u32>(_e421) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f)) - _e360);
                            let _e496 = (select(_e443, 0f, (bitcast<f32>((bitcast<u32>(_e443) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f)) - _e316);
                            let _e497 = (select(_e465, 0f, (bitcast<f32>((bitcast<u32>(_e465) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f)) - _e338);
                            let _e498 = (select(_e487, 0f, (bitcast<f32>((bitcast<u32>(_e487) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f)) - _e360);
                            if (_e224.member_1 == 1u) {
                                phi_909_ = vec3<f32>((_e224.member[0] - _e316), (_e224.member[1] - _e338), (_e224.member[2] - _e360));
                            } else {
                                phi_909_ = vec3<f32>(_e224.member[0], _e224.member[1], _e224.member[2]);
                            }
                            let _e515 = phi_909_;
                            let _e521 = bitcast<f32>((bitcast<u32>((_e493 * _e497)) ^ _e224.member_3[0]));
                            let _e525 = bitcast<f32>((bitcast<u32>((_e494 * _e496)) ^ _e224.member_3[0]));
                            let _e529 = bitcast<f32>((bitcast<u32>((_e494 * _e498)) ^ _e224.member_3[0]));
                            let _e533 = bitcast<f32>((bitcast<u32>((_e495 * _e497)) ^ _e224.member_3[0]));
                            let _e537 = bitcast<f32>((bitcast<u32>((_e495 * _e496)) ^ _e224.member_3[0]));
                            let _e541 = bitcast<f32>((bitcast<u32>((_e493 * _e498)) ^ _e224.member_3[0]));
                            let _e542 = (_e529 - _e533);
                            let _e543 = (_e537 - _e541);
                            let _e544 = (_e521 - _e525);
                            let _e561 = ((bitcast<f32>((bitcast<u32>((_e515.x * _e542)) ^ _e224.member_3[0])) + bitcast<f32>((bitcast<u32>((_e515.y * _e543)) ^ _e224.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e515.z * _e544)) ^ _e224.member_3[0])));
                            let _e568 = (bitcast<f32>((bitcast<u32>(_e529) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e533) & 2147483647u)));
                            let _e575 = (bitcast<f32>((bitcast<u32>(_e537) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e541) & 2147483647u)));
                            let _e582 = (bitcast<f32>((bitcast<u32>(_e521) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e525) & 2147483647u)));
                            if (_e224.member_2 == 0f) {
                                phi_1091_ = 0f;
                            } else {
                                let _e612 = bitcast<f32>((bitcast<u32>(_e542) & 2147483647u));
                                let _e615 = bitcast<f32>((bitcast<u32>(_e543) & 2147483647u));
                                let _e618 = bitcast<f32>((bitcast<u32>(_e544) & 2147483647u));
                                let _e620 = select(_e618, _e615, (_e615 > _e618));
                                let _e624 = select(_e618, _e615, (_e615 < _e618));
                                let _e628 = select(_e615, _e612, (_e612 < _e615));
                                let _e630 = select(_e615, _e612, (_e612 > _e615));
                                let _e632 = select(_e618, _e630, (_e630 < _e618));
                                phi_1091_ = bitcast<f32>((bitcast<u32>((_e224.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e620, _e612, (_e612 > _e620)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e632, _e628, (_e628 > _e632)))) ^ _e224.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e624, _e612, (_e612 < _e624)))) ^ _e224.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e568 + _e575) + _e582))) ^ _e224.member_3[0]))) * 1.0000005f)) ^ _e224.member_3[0])))) ^ _e224.member_3[0]));
                            }
                            let _e659 = phi_1091_;
                            let _e665 = ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e515.x) & 2147483647u)) * _e568)) ^ _e224.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e515.y) & 2147483647u)) * _e575)) ^ _e224.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e515.z) & 2147483647u)) * _e582)) ^ _e224.member_3[0]))))) ^ _e224.member_3[0])) + _e659) + 0.0000000000000000000000000000000000001880791f);
                            let _e677 = (_e257 < arrayLength((&global_8.member)));
                            if _e677 {
                                if _e677 {
                                } else {
                                    phi_1274_ = true;
                                    break;
                                }
                                let _e679 = global_8.member[_e257];
                                phi_1127_ = _e679;
                            } else {
                                phi_1127_ = 0i;
                            }
                            let _e681 = phi_1127_;
                            phi_1131_ = type_30(select(0u, 1u, !(((_e561 * f32(-(_e262))) > _e665))), select(0u, 1u, !(((_e561 * f32(_e262)) > _e665))), select(0u, 1u, (_e681 == 0i)), 0u);
                        }
                        let _e686 = phi_1131_;
                        phi_1142_ = type_30((_e228.member + _e686.member), (_e228.member_1 + _e686.member_1), (_e228.member_2 + _e686.member_2), 0u);
                    } else {
                        phi_1142_ = _e228;
                    }
                    let _e698 = phi_1142_;
                    phi_376_ = _e698;
                } else {
                    phi_376_ = type_30();
                }
                let _e700 = phi_376_;
                continue;
                continuing {
                    phi_372_ = _e241;
                    phi_375_ = _e700;
                    phi_1274_ = false;
                    break if !(_e247);
                }
            }
            let _e703 = phi_1274_;
            if _e703 {
                break;
            }
            let _e704 = (_e56 % 64u);
            let _e705 = (_e704 < 64u);
            if _e705 {
            } else {
                break;
            }
            let _e708 = local;
            let _e711 = local_1;
            let _e714 = local_2;
            let _e717 = local_3;
            global_10[_e704] = type_30(_e708.member, _e711.member_1, _e714.member_2, _e717.member_3);
            workgroupBarrier();
            phi_1157_ = type_9(0u, 6u);
            phi_1160_ = 32u;
            loop {
                let _e721 = phi_1157_;
                let _e723 = phi_1160_;
                if (_e721.member < _e721.member_1) {
                    phi_1158_ = type_9((_e721.member + 1u), _e721.member_1);
                    phi_1183_ = type_9(1u, _e721.member);
                } else {
                    phi_1158_ = _e721;
                    phi_1183_ = type_9(0u, type_9().member_1);
                }
                let _e736 = phi_1158_;
                let _e738 = phi_1183_;
                let _e741 = (bitcast<i32>(_e738.member) != 0i);
                if _e741 {
                    if (_e56 < _e723) {
                        if _e705 {
                        } else {
                            phi_1337_ = true;
                            break;
                        }
                        let _e743 = global_10[_e704];
                        let _e748 = ((_e56 + _e723) % 64u);
                        if (_e748 < 64u) {
                        } else {
                            phi_1337_ = true;
                            break;
                        }
                        let _e751 = global_10[_e748];
                        if _e705 {
                        } else {
                            phi_1337_ = true;
                            break;
                        }
                        global_10[_e704] = type_30((_e743.member + _e751.member), (_e743.member_1 + _e751.member_1), (_e743.member_2 + _e751.member_2), 0u);
                    }
                    workgroupBarrier();
                    phi_1161_ = (_e723 / 2u);
                } else {
                    phi_1161_ = u32();
                }
                let _e761 = phi_1161_;
                continue;
                continuing {
                    phi_1157_ = _e736;
                    phi_1160_ = _e761;
                    phi_1337_ = _e703;
                    break if !(_e741);
                }
            }
            let _e764 = phi_1337_;
            if _e764 {
                break;
            }
            if (_e56 == 0u) {
                let _e766 = (_e77 < arrayLength((&global_9.member)));
                if _e766 {
                    let _e768 = global_10[0u];
                    if _e766 {
                    } else {
                        break;
                    }
                    global_9.member[_e77] = type_30(_e768.member, _e768.member_1, _e768.member_2, _e768.member_3);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_counts(@builtin(workgroup_id) param: vec3<u32>, @builtin(local_invocation_index) param_1: u32) {
    global = param;
    global_1 = param_1;
    function_();
}
