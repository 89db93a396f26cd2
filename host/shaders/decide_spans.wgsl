struct type_5 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_13 {
    member: array<array<f32, 3>>,
}

struct type_17 {
    member: array<array<u32, 3>>,
}

struct type_26 {
    member: array<array<u32, 2>>,
}

struct type_30 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
    member_2: f32,
    member_3: f32,
    member_4: u32,
}

struct type_32 {
    member: array<type_30>,
}

struct type_35 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_37 {
    member: array<type_35>,
}

var<private> global: vec3<u32>;
var<private> global_1: u32;
@group(0) @binding(0) 
var<uniform> global_2: type_8;
@group(0) @binding(1) 
var<uniform> global_3: type_8;
@group(0) @binding(2) 
var<storage> global_4: type_13;
@group(0) @binding(3) 
var<storage> global_5: type_17;
@group(0) @binding(4) 
var<storage> global_6: type_26;
@group(0) @binding(5) 
var<storage> global_7: type_37;
@group(0) @binding(6) 
var<storage, read_write> global_8: type_32;
var<workgroup> global_9: array<type_30, 64>;

fn function_() {
    var phi_171_: type_35;
    var phi_190_: i32;
    var phi_227_: array<f32, 3>;
    var phi_346_: u32;
    var phi_349_: type_5;
    var phi_352_: type_30;
    var phi_350_: type_5;
    var phi_375_: type_5;
    var phi_405_: array<u32, 3>;
    var phi_420_: array<f32, 3>;
    var phi_438_: array<f32, 3>;
    var phi_456_: array<f32, 3>;
    var phi_979_: type_30;
    var phi_353_: type_30;
    var phi_1437_: bool;
    var phi_996_: u32;
    var phi_999_: type_5;
    var phi_1002_: type_30;
    var phi_1000_: type_5;
    var phi_1025_: type_5;
    var phi_1055_: array<u32, 2>;
    var phi_1071_: array<f32, 3>;
    var phi_1085_: array<f32, 3>;
    var phi_1099_: bool;
    var phi_1116_: bool;
    var phi_1133_: bool;
    var phi_1134_: bool;
    var phi_1136_: bool;
    var phi_1137_: bool;
    var phi_1147_: type_30;
    var phi_1003_: type_30;
    var phi_1499_: bool;
    var local: type_30;
    var local_1: type_30;
    var local_2: type_30;
    var local_3: type_30;
    var local_4: type_30;
    var phi_1171_: type_5;
    var phi_1174_: u32;
    var phi_1172_: type_5;
    var phi_1197_: type_5;
    var phi_1175_: u32;
    var phi_1514_: bool;
    var local_5: type_30;

    switch bitcast<i32>(0u) {
        default: {
            let _e54 = global;
            let _e55 = global_1;
            let _e58 = arrayLength((&global_4.member));
            let _e72 = (_e54.x + (_e54.y * 32768u));
            let _e73 = (_e72 < arrayLength((&global_7.member)));
            if _e73 {
                if _e73 {
                } else {
                    break;
                }
                let _e76 = global_7.member[_e72];
                phi_171_ = _e76;
            } else {
                phi_171_ = type_35(0u, 0u, 0u, 0u, 0u);
            }
            let _e78 = phi_171_;
            let _e81 = global_2.member[0u];
            let _e82 = bitcast<i32>(_e81);
            if (_e82 < -126i) {
                phi_190_ = -126i;
            } else {
                phi_190_ = select(_e82, 127i, (_e82 > 127i));
            }
            let _e87 = phi_190_;
            let _e92 = bitcast<f32>((bitcast<u32>((_e87 + 127i)) << bitcast<u32>(23i)));
            let _e98 = bitcast<f32>((bitcast<u32>(((_e82 - _e87) + 127i)) << bitcast<u32>(23i)));
            let _e101 = global_3.member[0u];
            let _e103 = (_e78.member < _e58);
            if _e103 {
                if _e103 {
                } else {
                    break;
                }
                let _e105 = global_4.member[_e78.member];
                phi_227_ = _e105;
            } else {
                phi_227_ = array<f32, 3>(0f, 0f, 0f);
            }
            let _e107 = phi_227_;
            let _e109 = bitcast<u32>(_e107[0]);
            let _e111 = ((_e109 & 2139095040u) != 0u);
            let _e127 = bitcast<u32>(_e107[1]);
            let _e129 = ((_e127 & 2139095040u) != 0u);
            let _e145 = bitcast<u32>(_e107[2]);
            let _e147 = ((_e145 & 2139095040u) != 0u);
            let _e163 = (_e78.member_2 / 64u);
            if ((_e78.member_2 % 64u) > 0u) {
                phi_346_ = (_e163 + 1u);
            } else {
                phi_346_ = _e163;
            }
            let _e168 = phi_346_;
            phi_349_ = type_5(0u, _e168);
            phi_352_ = type_30(array<f32, 3>(340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f), array<f32, 3>(-340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f), 0f, 0f, 0u);
            loop {
                let _e171 = phi_349_;
                let _e173 = phi_352_;
                local_5 = _e173;
                if (_e171.member < _e171.member_1) {
                    phi_350_ = type_5((_e171.member + 1u), _e171.member_1);
                    phi_375_ = type_5(1u, _e171.member);
                } else {
                    phi_350_ = _e171;
                    phi_375_ = type_5(0u, type_5().member_1);
                }
                let _e186 = phi_350_;
                let _e188 = phi_375_;
                let _e192 = (bitcast<i32>(_e188.member) != 0i);
                if _e192 {
                    let _e194 = ((_e188.member_1 * 64u) + _e55);
                    if (_e194 < _e78.member_2) {
                        let _e197 = (_e78.member_1 + _e194);
                        let _e198 = (_e197 < arrayLength((&global_5.member)));
                        if _e198 {
                            if _e198 {
                            } else {
                                phi_1437_ = true;
                                break;
                            }
                            let _e200 = global_5.member[_e197];
                            phi_405_ = _e200;
                        } else {
                            phi_405_ = array<u32, 3>(0u, 0u, 0u);
                        }
                        let _e202 = phi_405_;
                        let _e204 = (_e202[0] < _e58);
                        if _e204 {
                            if _e204 {
                            } else {
                                phi_1437_ = true;
                                break;
                            }
                            let _e206 = global_4.member[_e202[0]];
                            phi_420_ = _e206;
                        } else {
                            phi_420_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e208 = phi_420_;
                        let _e213 = (_e202[1] < _e58);
                        if _e213 {
                            if _e213 {
                            } else {
                                phi_1437_ = true;
                                break;
                            }
                            let _e215 = global_4.member[_e202[1]];
                            phi_438_ = _e215;
                        } else {
                            phi_438_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e217 = phi_438_;
                        let _e222 = (_e202[2] < _e58);
                        if _e222 {
                            if _e222 {
                            } else {
                                phi_1437_ = true;
                                break;
                            }
                            let _e224 = global_4.member[_e202[2]];
                            phi_456_ = _e224;
                        } else {
                            phi_456_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e226 = phi_456_;
                        let _e230 = bitcast<u32>(_e208[0]);
                        let _e232 = ((_e230 & 2139095040u) != 0u);
                        let _e246 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e230 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e230 & 2147483648u))), _e208[0], _e232) * _e92) * select(0.00000011920929f, 1f, _e232)) * _e98);
                        let _e247 = bitcast<u32>(_e208[1]);
                        let _e249 = ((_e247 & 2139095040u) != 0u);
                        let _e263 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e247 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e247 & 2147483648u))), _e208[1], _e249) * _e92) * select(0.00000011920929f, 1f, _e249)) * _e98);
                        let _e264 = bitcast<u32>(_e208[2]);
                        let _e266 = ((_e264 & 2139095040u) != 0u);
                        let _e280 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e264 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e264 & 2147483648u))), _e208[2], _e266) * _e92) * select(0.00000011920929f, 1f, _e266)) * _e98);
                        let _e281 = (_e246 - (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e109 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e109 & 2147483648u))), _e107[0], _e111) * _e92) * select(0.00000011920929f, 1f, _e111)) * _e98));
                        let _e282 = (_e263 - (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e127 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e127 & 2147483648u))), _e107[1], _e129) * _e92) * select(0.00000011920929f, 1f, _e129)) * _e98));
                        let _e283 = (_e280 - (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e145 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e145 & 2147483648u))), _e107[2], _e147) * _e92) * select(0.00000011920929f, 1f, _e147)) * _e98));
                        let _e284 = bitcast<u32>(_e217[0]);
                        let _e286 = ((_e284 & 2139095040u) != 0u);
                        let _e301 = bitcast<u32>(_e217[1]);
                        let _e303 = ((_e301 & 2139095040u) != 0u);
                        let _e318 = bitcast<u32>(_e217[2]);
                        let _e320 = ((_e318 & 2139095040u) != 0u);
                        let _e335 = ((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e284 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e284 & 2147483648u))), _e217[0], _e286) * _e92) * select(0.00000011920929f, 1f, _e286)) * _e98) - _e246);
                        let _e336 = ((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e301 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e301 & 2147483648u))), _e217[1], _e303) * _e92) * select(0.00000011920929f, 1f, _e303)) * _e98) - _e263);
                        let _e337 = ((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e318 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e318 & 2147483648u))), _e217[2], _e320) * _e92) * select(0.00000011920929f, 1f, _e320)) * _e98) - _e280);
                        let _e338 = bitcast<u32>(_e226[0]);
                        let _e340 = ((_e338 & 2139095040u) != 0u);
                        let _e355 = bitcast<u32>(_e226[1]);
                        let _e357 = ((_e355 & 2139095040u) != 0u);
                        let _e372 = bitcast<u32>(_e226[2]);
                        let _e374 = ((_e372 & 2139095040u) != 0u);
                        let _e389 = ((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e338 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e338 & 2147483648u))), _e226[0], _e340) * _e92) * select(0.00000011920929f, 1f, _e340)) * _e98) - _e246);
                        let _e390 = ((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e355 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e355 & 2147483648u))), _e226[1], _e357) * _e92) * select(0.00000011920929f, 1f, _e357)) * _e98) - _e263);
                        let _e391 = ((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e372 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e372 & 2147483648u))), _e226[2], _e374) * _e92) * select(0.00000011920929f, 1f, _e374)) * _e98) - _e280);
                        let _e395 = bitcast<f32>((bitcast<u32>((_e335 * _e390)) ^ _e101));
                        let _e399 = bitcast<f32>((bitcast<u32>((_e336 * _e389)) ^ _e101));
                        let _e403 = bitcast<f32>((bitcast<u32>((_e336 * _e391)) ^ _e101));
                        let _e407 = bitcast<f32>((bitcast<u32>((_e337 * _e390)) ^ _e101));
                        let _e411 = bitcast<f32>((bitcast<u32>((_e337 * _e389)) ^ _e101));
                        let _e415 = bitcast<f32>((bitcast<u32>((_e335 * _e391)) ^ _e101));
                        let _e478 = select(_e217[0], _e208[0], (_e208[0] < _e217[0]));
                        let _e480 = select(_e217[1], _e208[1], (_e208[1] < _e217[1]));
                        let _e482 = select(_e217[2], _e208[2], (_e208[2] < _e217[2]));
                        let _e484 = select(_e226[0], _e478, (_e478 < _e226[0]));
                        let _e486 = select(_e226[1], _e480, (_e480 < _e226[1]));
                        let _e488 = select(_e226[2], _e482, (_e482 < _e226[2]));
                        let _e490 = select(_e217[0], _e208[0], (_e208[0] > _e217[0]));
                        let _e492 = select(_e217[1], _e208[1], (_e208[1] > _e217[1]));
                        let _e494 = select(_e217[2], _e208[2], (_e208[2] > _e217[2]));
                        let _e496 = select(_e226[0], _e490, (_e490 > _e226[0]));
                        let _e498 = select(_e226[1], _e492, (_e492 > _e226[1]));
                        let _e500 = select(_e226[2], _e494, (_e494 > _e226[2]));
                        let _e504 = select(_e484, 0f, ((bitcast<u32>(_e484) & 2147483647u) == 0u));
                        let _e508 = select(_e486, 0f, ((bitcast<u32>(_e486) & 2147483647u) == 0u));
                        let _e512 = select(_e488, 0f, ((bitcast<u32>(_e488) & 2147483647u) == 0u));
                        let _e516 = select(_e496, 0f, ((bitcast<u32>(_e496) & 2147483647u) == 0u));
                        let _e520 = select(_e498, 0f, ((bitcast<u32>(_e498) & 2147483647u) == 0u));
                        let _e524 = select(_e500, 0f, ((bitcast<u32>(_e500) & 2147483647u) == 0u));
                        let _e531 = (_e173.member_2 + ((bitcast<f32>((bitcast<u32>((_e281 * (_e403 - _e407))) ^ _e101)) + bitcast<f32>((bitcast<u32>((_e282 * (_e411 - _e415))) ^ _e101))) + bitcast<f32>((bitcast<u32>((_e283 * (_e395 - _e399))) ^ _e101))));
                        phi_979_ = type_30(array<f32, 3>(select(_e504, _e173.member[0], (_e173.member[0] < _e504)), select(_e508, _e173.member[1], (_e173.member[1] < _e508)), select(_e512, _e173.member[2], (_e173.member[2] < _e512))), array<f32, 3>(select(_e516, _e173.member_1[0], (_e173.member_1[0] > _e516)), select(_e520, _e173.member_1[1], (_e173.member_1[1] > _e520)), select(_e524, _e173.member_1[2], (_e173.member_1[2] > _e524))), _e531, ((_e173.member_3 + (bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e281) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e403) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e407) & 2147483647u))))) ^ _e101)) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e282) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e411) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e415) & 2147483647u))))) ^ _e101))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e283) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e395) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e399) & 2147483647u))))) ^ _e101))))) ^ _e101)) + 0.0000000000000000000000000000000000030092655f)) + (0.000000059604645f * bitcast<f32>((bitcast<u32>(_e531) & 2147483647u)))), _e173.member_4);
                    } else {
                        phi_979_ = _e173;
                    }
                    let _e564 = phi_979_;
                    phi_353_ = _e564;
                } else {
                    phi_353_ = type_30();
                }
                let _e566 = phi_353_;
                continue;
                continuing {
                    phi_349_ = _e186;
                    phi_352_ = _e566;
                    phi_1437_ = false;
                    break if !(_e192);
                }
            }
            let _e569 = phi_1437_;
            if _e569 {
                break;
            }
            let _e571 = (_e78.member_4 / 64u);
            if ((_e78.member_4 % 64u) > 0u) {
                phi_996_ = (_e571 + 1u);
            } else {
                phi_996_ = _e571;
            }
            let _e576 = phi_996_;
            phi_999_ = type_5(0u, _e576);
            let _e827 = local_5;
            phi_1002_ = _e827;
            loop {
                let _e579 = phi_999_;
                let _e581 = phi_1002_;
                local = _e581;
                local_1 = _e581;
                local_2 = _e581;
                local_3 = _e581;
                local_4 = _e581;
                if (_e579.member < _e579.member_1) {
                    phi_1000_ = type_5((_e579.member + 1u), _e579.member_1);
                    phi_1025_ = type_5(1u, _e579.member);
                } else {
                    phi_1000_ = _e579;
                    phi_1025_ = type_5(0u, type_5().member_1);
                }
                let _e594 = phi_1000_;
                let _e596 = phi_1025_;
                let _e600 = (bitcast<i32>(_e596.member) != 0i);
                if _e600 {
                    let _e602 = ((_e596.member_1 * 64u) + _e55);
                    if (_e602 < _e78.member_4) {
                        let _e605 = (_e78.member_3 + _e602);
                        let _e606 = (_e605 < arrayLength((&global_6.member)));
                        if _e606 {
                            if _e606 {
                            } else {
                                phi_1499_ = true;
                                break;
                            }
                            let _e608 = global_6.member[_e605];
                            phi_1055_ = _e608;
                        } else {
                            phi_1055_ = array<u32, 2>(0u, 0u);
                        }
                        let _e610 = phi_1055_;
                        let _e613 = (_e610[0] < _e58);
                        if _e613 {
                            if _e613 {
                            } else {
                                phi_1499_ = true;
                                break;
                            }
                            let _e615 = global_4.member[_e610[0]];
                            phi_1071_ = _e615;
                        } else {
                            phi_1071_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e617 = phi_1071_;
                        let _e618 = (_e610[1] < _e58);
                        if _e618 {
                            if _e618 {
                            } else {
                                phi_1499_ = true;
                                break;
                            }
                            let _e620 = global_4.member[_e610[1]];
                            phi_1085_ = _e620;
                        } else {
                            phi_1085_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e622 = phi_1085_;
                        let _e625 = bitcast<u32>(_e617[0]);
                        let _e626 = bitcast<u32>(_e622[0]);
                        if (_e625 == _e626) {
                            phi_1099_ = true;
                        } else {
                            phi_1099_ = (((_e625 | _e626) << bitcast<u32>(1i)) == 0u);
                        }
                        let _e633 = phi_1099_;
                        if _e633 {
                            let _e636 = bitcast<u32>(_e617[1]);
                            let _e637 = bitcast<u32>(_e622[1]);
                            if (_e636 == _e637) {
                                phi_1116_ = true;
                            } else {
                                phi_1116_ = (((_e636 | _e637) << bitcast<u32>(1i)) == 0u);
                            }
                            let _e644 = phi_1116_;
                            if _e644 {
                                let _e647 = bitcast<u32>(_e617[2]);
                                let _e648 = bitcast<u32>(_e622[2]);
                                if (_e647 == _e648) {
                                    phi_1133_ = true;
                                } else {
                                    phi_1133_ = (((_e647 | _e648) << bitcast<u32>(1i)) == 0u);
                                }
                                let _e655 = phi_1133_;
                                phi_1134_ = _e655;
                            } else {
                                phi_1134_ = bool();
                            }
                            let _e657 = phi_1134_;
                            phi_1136_ = _e657;
                            phi_1137_ = select(true, false, _e644);
                        } else {
                            phi_1136_ = bool();
                            phi_1137_ = true;
                        }
                        let _e660 = phi_1136_;
                        let _e662 = phi_1137_;
                        phi_1147_ = type_30(_e581.member, _e581.member_1, _e581.member_2, _e581.member_3, (_e581.member_4 | select(0u, 1u, !(select(_e660, false, _e662)))));
                    } else {
                        phi_1147_ = _e581;
                    }
                    let _e675 = phi_1147_;
                    phi_1003_ = _e675;
                } else {
                    phi_1003_ = type_30();
                }
                let _e677 = phi_1003_;
                continue;
                continuing {
                    phi_999_ = _e594;
                    phi_1002_ = _e677;
                    phi_1499_ = _e569;
                    break if !(_e600);
                }
            }
            let _e680 = phi_1499_;
            if _e680 {
                break;
            }
            let _e681 = (_e55 % 64u);
            let _e682 = (_e681 < 64u);
            if _e682 {
            } else {
                break;
            }
            let _e685 = local;
            let _e692 = local_1;
            let _e699 = local_2;
            let _e702 = local_3;
            let _e705 = local_4;
            global_9[_e681] = type_30(array<f32, 3>(_e685.member[0], _e685.member[1], _e685.member[2]), array<f32, 3>(_e692.member_1[0], _e692.member_1[1], _e692.member_1[2]), _e699.member_2, _e702.member_3, _e705.member_4);
            workgroupBarrier();
            phi_1171_ = type_5(0u, 6u);
            phi_1174_ = 32u;
            loop {
                let _e709 = phi_1171_;
                let _e711 = phi_1174_;
                if (_e709.member < _e709.member_1) {
                    phi_1172_ = type_5((_e709.member + 1u), _e709.member_1);
                    phi_1197_ = type_5(1u, _e709.member);
                } else {
                    phi_1172_ = _e709;
                    phi_1197_ = type_5(0u, type_5().member_1);
                }
                let _e724 = phi_1172_;
                let _e726 = phi_1197_;
                let _e729 = (bitcast<i32>(_e726.member) != 0i);
                if _e729 {
                    if (_e55 < _e711) {
                        if _e682 {
                        } else {
                            phi_1514_ = true;
                            break;
                        }
                        let _e731 = global_9[_e681];
                        let _e744 = ((_e55 + _e711) % 64u);
                        if (_e744 < 64u) {
                        } else {
                            phi_1514_ = true;
                            break;
                        }
                        let _e747 = global_9[_e744];
                        let _e759 = (_e731.member_2 + _e747.member_2);
                        if _e682 {
                        } else {
                            phi_1514_ = true;
                            break;
                        }
                        global_9[_e681] = type_30(array<f32, 3>(select(_e747.member[0], _e731.member[0], (_e731.member[0] < _e747.member[0])), select(_e747.member[1], _e731.member[1], (_e731.member[1] < _e747.member[1])), select(_e747.member[2], _e731.member[2], (_e731.member[2] < _e747.member[2]))), array<f32, 3>(select(_e747.member_1[0], _e731.member_1[0], (_e731.member_1[0] > _e747.member_1[0])), select(_e747.member_1[1], _e731.member_1[1], (_e731.member_1[1] > _e747.member_1[1])), select(_e747.member_1[2], _e731.member_1[2], (_e731.member_1[2] > _e747.member_1[2]))), _e759, ((_e731.member_3 + _e747.member_3) + (0.000000059604645f * bitcast<f32>((bitcast<u32>(_e759) & 2147483647u)))), (_e731.member_4 | _e747.member_4));
                    }
                    workgroupBarrier();
                    phi_1175_ = (_e711 / 2u);
                } else {
                    phi_1175_ = u32();
                }
                let _e784 = phi_1175_;
                continue;
                continuing {
                    phi_1171_ = _e724;
                    phi_1174_ = _e784;
                    phi_1514_ = _e680;
                    break if !(_e729);
                }
            }
            let _e787 = phi_1514_;
            if _e787 {
                break;
            }
            if (_e55 == 0u) {
                if _e73 {
                    let _e789 = (_e72 < arrayLength((&global_8.member)));
                    if _e789 {
                        let _e791 = global_9[0u];
                        if _e789 {
                        } else {
                            break;
                        }
                        global_8.member[_e72] = type_30(array<f32, 3>(_e791.member[0], _e791.member[1], _e791.member[2]), array<f32, 3>(_e791.member_1[0], _e791.member_1[1], _e791.member_1[2]), _e791.member_2, _e791.member_3, _e791.member_4);
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_spans(@builtin(workgroup_id) param: vec3<u32>, @builtin(local_invocation_index) param_1: u32) {
    global = param;
    global_1 = param_1;
    function_();
}
