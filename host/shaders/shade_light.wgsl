struct type_4 {
    member: array<u32>,
}

struct type_10 {
    member: vec4<u32>,
}

struct type_15 {
    member: array<array<f32, 3>>,
}

struct type_19 {
    member: array<array<u32, 3>>,
}

struct type_26 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_28 {
    member: array<type_26>,
}

struct type_30 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_31 {
    member: type_30,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_33 {
    member: array<type_31>,
}

struct type_39 {
    member: array<vec4<u32>, 2>,
}

struct type_41 {
    member: array<f32, 3>,
    member_1: f32,
}

struct type_43 {
    member: array<type_41>,
}

struct type_45 {
    member: type_30,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_47 {
    member: array<type_45>,
}

struct type_50 {
    member: type_30,
    member_1: vec3<f32>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_10;
@group(0) @binding(1) 
var<uniform> global_2: type_39;
@group(0) @binding(2) 
var<storage> global_3: type_15;
@group(0) @binding(3) 
var<storage> global_4: type_19;
@group(0) @binding(4) 
var<storage> global_5: type_15;
@group(0) @binding(5) 
var<storage> global_6: type_4;
@group(0) @binding(6) 
var<storage> global_7: type_43;
@group(0) @binding(7) 
var<storage> global_8: type_28;
@group(0) @binding(8) 
var<storage> global_9: type_33;
@group(0) @binding(9) 
var<storage, read_write> global_10: type_47;
var<private> global_11: vec3<f32> = vec3<f32>(0f, 0f, 0f);

fn function_() {
    var phi_262_: array<u32, 3>;
    var phi_277_: array<f32, 3>;
    var phi_295_: array<f32, 3>;
    var phi_313_: array<f32, 3>;
    var phi_400_: array<u32, 3>;
    var phi_417_: vec3<f32>;
    var phi_434_: vec3<f32>;
    var phi_451_: vec3<f32>;
    var phi_585_: i32;
    var phi_616_: i32;
    var phi_635_: vec3<f32>;
    var phi_718_: i32;
    var phi_749_: i32;
    var phi_768_: vec3<f32>;
    var phi_810_: u32;
    var phi_1457_: vec3<f32>;
    var phi_1539_: bool;
    var phi_1543_: bool;
    var phi_1544_: bool;
    var phi_1789_: f32;
    var phi_1791_: f32;
    var phi_1795_: f32;
    var phi_1767_: f32;
    var phi_1769_: f32;
    var phi_1797_: f32;
    var phi_1840_: f32;
    var phi_1842_: f32;
    var phi_1846_: f32;
    var phi_1818_: f32;
    var phi_1820_: f32;
    var phi_1848_: f32;
    var phi_1891_: f32;
    var phi_1893_: f32;
    var phi_1897_: f32;
    var phi_1869_: f32;
    var phi_1871_: f32;
    var phi_1899_: f32;
    var phi_1565_: vec3<f32>;
    var phi_1619_: f32;
    var phi_1601_: f32;
    var phi_1612_: bool;
    var phi_1626_: f32;
    var phi_1627_: bool;
    var phi_1628_: bool;
    var phi_1629_: bool;
    var phi_1671_: type_50;
    var phi_1681_: type_50;
    var phi_1684_: type_50;
    var phi_1687_: type_50;
    var phi_1688_: bool;
    var phi_1692_: type_50;
    var phi_881_: type_45;
    var phi_882_: type_45;
    var phi_883_: type_45;

    switch bitcast<i32>(0u) {
        default: {
            let _e48 = global;
            let _e51 = arrayLength((&global_3.member));
            let _e56 = arrayLength((&global_5.member));
            let _e60 = arrayLength((&global_7.member));
            let _e70 = (_e48.x + (_e48.y * 2097152u));
            let _e71 = (_e70 < arrayLength((&global_9.member)));
            if _e71 {
                let _e72 = (_e70 < arrayLength((&global_8.member)));
                if _e72 {
                    let _e73 = (_e70 < arrayLength((&global_10.member)));
                    if _e73 {
                        if _e71 {
                        } else {
                            break;
                        }
                        let _e76 = global_9.member[_e70];
                        if _e72 {
                        } else {
                            break;
                        }
                        let _e79 = global_8.member[_e70];
                        if (_e76.member.member_1 <= _e76.member.member_3) {
                            if (_e79.member_3 != 4294967295u) {
                                if (_e60 == 0u) {
                                    phi_881_ = type_45(type_30(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                                } else {
                                    let _e90 = global_1.member[0u];
                                    let _e91 = bitcast<i32>(_e90);
                                    let _e92 = (_e91 / 2i);
                                    let _e97 = bitcast<f32>((bitcast<u32>((_e92 + 127i)) << bitcast<u32>(23i)));
                                    let _e103 = bitcast<f32>((bitcast<u32>(((_e91 - _e92) + 127i)) << bitcast<u32>(23i)));
                                    let _e104 = (_e79.member_3 < arrayLength((&global_4.member)));
                                    if _e104 {
                                        if _e104 {
                                        } else {
                                            break;
                                        }
                                        let _e106 = global_4.member[_e79.member_3];
                                        phi_262_ = _e106;
                                    } else {
                                        phi_262_ = array<u32, 3>(0u, 0u, 0u);
                                    }
                                    let _e108 = phi_262_;
                                    let _e110 = (_e108[0] < _e51);
                                    if _e110 {
                                        if _e110 {
                                        } else {
                                            break;
                                        }
                                        let _e112 = global_3.member[_e108[0]];
                                        phi_277_ = _e112;
                                    } else {
                                        phi_277_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e114 = phi_277_;
                                    let _e119 = (_e108[1] < _e51);
                                    if _e119 {
                                        if _e119 {
                                        } else {
                                            break;
                                        }
                                        let _e121 = global_3.member[_e108[1]];
                                        phi_295_ = _e121;
                                    } else {
                                        phi_295_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e123 = phi_295_;
                                    let _e128 = (_e108[2] < _e51);
                                    if _e128 {
                                        if _e128 {
                                        } else {
                                            break;
                                        }
                                        let _e130 = global_3.member[_e108[2]];
                                        phi_313_ = _e130;
                                    } else {
                                        phi_313_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e132 = phi_313_;
                                    let _e137 = ((_e114[0] * _e97) * _e103);
                                    let _e139 = select(_e137, 0f, (_e137 == 0f));
                                    let _e141 = ((_e114[1] * _e97) * _e103);
                                    let _e143 = select(_e141, 0f, (_e141 == 0f));
                                    let _e145 = ((_e114[2] * _e97) * _e103);
                                    let _e147 = select(_e145, 0f, (_e145 == 0f));
                                    let _e149 = ((_e123[0] * _e97) * _e103);
                                    let _e151 = select(_e149, 0f, (_e149 == 0f));
                                    let _e153 = ((_e123[1] * _e97) * _e103);
                                    let _e155 = select(_e153, 0f, (_e153 == 0f));
                                    let _e157 = ((_e123[2] * _e97) * _e103);
                                    let _e159 = select(_e157, 0f, (_e157 == 0f));
                                    let _e161 = ((_e132[0] * _e97) * _e103);
                                    let _e163 = select(_e161, 0f, (_e161 == 0f));
                                    let _e165 = ((_e132[1] * _e97) * _e103);
                                    let _e167 = select(_e165, 0f, (_e165 == 0f));
                                    let _e169 = ((_e132[2] * _e97) * _e103);
                                    let _e171 = select(_e169, 0f, (_e169 == 0f));
                                    if _e104 {
                                        if _e104 {
                                        } else {
                                            break;
                                        }
                                        let _e174 = global_4.member[_e79.member_3];
                                        phi_400_ = _e174;
                                    } else {
                                        phi_400_ = array<u32, 3>(0u, 0u, 0u);
                                    }
                                    let _e176 = phi_400_;
                                    let _e178 = (_e176[0] < _e56);
                                    if _e178 {
                                        if _e178 {
                                        } else {
                                            break;
                                        }
                                        let _e181 = global_5.member[_e176[0]];
                                        phi_417_ = vec3<f32>(_e181[0], _e181[1], _e181[2]);
                                    } else {
                                        phi_417_ = vec3<f32>(0f, 0f, 0f);
                                    }
                                    let _e187 = phi_417_;
                                    let _e189 = (_e176[1] < _e56);
                                    if _e189 {
                                        if _e189 {
                                        } else {
                                            break;
                                        }
                                        let _e192 = global_5.member[_e176[1]];
                                        phi_434_ = vec3<f32>(_e192[0], _e192[1], _e192[2]);
                                    } else {
                                        phi_434_ = vec3<f32>(0f, 0f, 0f);
                                    }
                                    let _e198 = phi_434_;
                                    let _e200 = (_e176[2] < _e56);
                                    if _e200 {
                                        if _e200 {
                                        } else {
                                            break;
                                        }
                                        let _e203 = global_5.member[_e176[2]];
                                        phi_451_ = vec3<f32>(_e203[0], _e203[1], _e203[2]);
                                    } else {
                                        phi_451_ = vec3<f32>(0f, 0f, 0f);
                                    }
                                    let _e209 = phi_451_;
                                    let _e218 = ((1f - _e79.member_1) - _e79.member_2);
                                    let _e220 = select(0f, _e218, (_e218 > 0f));
                                    let _e222 = select(1f, _e79.member_1, (_e79.member_1 < 1f));
                                    let _e224 = select(1f, _e79.member_2, (_e79.member_2 < 1f));
                                    let _e225 = (_e139 * _e220);
                                    let _e226 = (_e143 * _e220);
                                    let _e227 = (_e147 * _e220);
                                    let _e228 = (_e151 * _e222);
                                    let _e229 = (_e155 * _e222);
                                    let _e230 = (_e159 * _e222);
                                    let _e231 = (_e163 * _e224);
                                    let _e232 = (_e167 * _e224);
                                    let _e233 = (_e171 * _e224);
                                    let _e273 = (((bitcast<f32>((bitcast<u32>(_e225) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e228) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e231) & 2147483647u))) * 0.00000071525625f);
                                    let _e274 = (((bitcast<f32>((bitcast<u32>(_e226) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e229) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e232) & 2147483647u))) * 0.00000071525625f);
                                    let _e275 = (((bitcast<f32>((bitcast<u32>(_e227) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e230) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e233) & 2147483647u))) * 0.00000071525625f);
                                    let _e276 = (_e151 - _e139);
                                    let _e277 = (_e155 - _e143);
                                    let _e278 = (_e159 - _e147);
                                    let _e279 = (_e163 - _e139);
                                    let _e280 = (_e167 - _e143);
                                    let _e281 = (_e171 - _e147);
                                    let _e282 = (_e277 * _e281);
                                    let _e284 = (_e282 - (_e280 * _e278));
                                    let _e285 = (_e278 * _e279);
                                    let _e287 = (_e285 - (_e281 * _e276));
                                    let _e288 = (_e276 * _e280);
                                    let _e290 = (_e288 - (_e279 * _e277));
                                    let _e293 = bitcast<f32>((bitcast<u32>(_e284) & 2147483647u));
                                    let _e296 = bitcast<f32>((bitcast<u32>(_e287) & 2147483647u));
                                    let _e298 = select(_e296, _e293, (_e293 > _e296));
                                    let _e301 = bitcast<f32>((bitcast<u32>(_e290) & 2147483647u));
                                    let _e303 = select(_e301, _e298, (_e298 > _e301));
                                    if (_e303 < 0.000000000000000000000000000000000000011754944f) {
                                        phi_635_ = vec3<f32>(0f, 0f, 0f);
                                    } else {
                                        let _e306 = (bitcast<u32>(_e303) & 2147483647u);
                                        let _e307 = (_e306 >= 8388608u);
                                        if _e307 {
                                            phi_585_ = (bitcast<i32>((_e306 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_585_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e306)), 32u, (_e306 == 0u))));
                                        }
                                        let _e320 = phi_585_;
                                        let _e327 = bitcast<f32>((bitcast<u32>(((_e320 / -2i) + 127i)) << bitcast<u32>(23i)));
                                        if _e307 {
                                            phi_616_ = (bitcast<i32>((_e306 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_616_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e306)), 32u, (_e306 == 0u))));
                                        }
                                        let _e343 = phi_616_;
                                        let _e349 = bitcast<f32>((bitcast<u32>((((_e320 / 2i) - _e343) + 127i)) << bitcast<u32>(23i)));
                                        let _e350 = ((_e284 * _e327) * _e349);
                                        let _e351 = ((_e287 * _e327) * _e349);
                                        let _e352 = ((_e290 * _e327) * _e349);
                                        let _e358 = sqrt((((_e350 * _e350) + (_e351 * _e351)) + (_e352 * _e352)));
                                        phi_635_ = vec3<f32>((_e350 / _e358), (_e351 / _e358), (_e352 / _e358));
                                    }
                                    let _e364 = phi_635_;
                                    let _e374 = select(1f, -1f, ((((_e364.x * _e76.member.member_2[0]) + (_e364.y * _e76.member.member_2[1])) + (_e364.z * _e76.member.member_2[2])) > 0f));
                                    let _e378 = (_e364 * _e374);
                                    let _e400 = (((_e187.x * _e220) + (_e198.x * _e222)) + (_e209.x * _e224));
                                    let _e401 = (((_e187.y * _e220) + (_e198.y * _e222)) + (_e209.y * _e224));
                                    let _e402 = (((_e187.z * _e220) + (_e198.z * _e222)) + (_e209.z * _e224));
                                    let _e405 = bitcast<f32>((bitcast<u32>(_e400) & 2147483647u));
                                    let _e408 = bitcast<f32>((bitcast<u32>(_e401) & 2147483647u));
                                    let _e410 = select(_e408, _e405, (_e405 > _e408));
                                    let _e413 = bitcast<f32>((bitcast<u32>(_e402) & 2147483647u));
                                    let _e415 = select(_e413, _e410, (_e410 > _e413));
                                    if (_e415 < 0.000000000000000000000000000000000000011754944f) {
                                        phi_768_ = vec3<f32>(0f, 0f, 0f);
                                    } else {
                                        let _e418 = (bitcast<u32>(_e415) & 2147483647u);
                                        let _e419 = (_e418 >= 8388608u);
                                        if _e419 {
                                            phi_718_ = (bitcast<i32>((_e418 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_718_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e418)), 32u, (_e418 == 0u))));
                                        }
                                        let _e432 = phi_718_;
                                        let _e439 = bitcast<f32>((bitcast<u32>(((_e432 / -2i) + 127i)) << bitcast<u32>(23i)));
                                        if _e419 {
                                            phi_749_ = (bitcast<i32>((_e418 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_749_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e418)), 32u, (_e418 == 0u))));
                                        }
                                        let _e455 = phi_749_;
                                        let _e461 = bitcast<f32>((bitcast<u32>((((_e432 / 2i) - _e455) + 127i)) << bitcast<u32>(23i)));
                                        let _e462 = ((_e400 * _e439) * _e461);
                                        let _e463 = ((_e401 * _e439) * _e461);
                                        let _e464 = ((_e402 * _e439) * _e461);
                                        let _e470 = sqrt((((_e462 * _e462) + (_e463 * _e463)) + (_e464 * _e464)));
                                        phi_768_ = vec3<f32>((_e462 / _e470), (_e463 / _e470), (_e464 / _e470));
                                    }
                                    let _e476 = phi_768_;
                                    let _e491 = select(_e378, (_e476 * _e374), vec3((((((_e476.x * _e374) * (_e364.x * _e374)) + ((_e476.y * _e374) * (_e364.y * _e374))) + ((_e476.z * _e374) * (_e364.z * _e374))) > 0f)));
                                    let _e492 = (_e79.member_3 < arrayLength((&global_6.member)));
                                    if _e492 {
                                        if _e492 {
                                        } else {
                                            break;
                                        }
                                        let _e495 = global_6.member[_e79.member_3];
                                        phi_810_ = _e495;
                                    } else {
                                        phi_810_ = 0u;
                                    }
                                    let _e497 = phi_810_;
                                    let _e499 = select(_e497, 0u, (_e497 >= _e60));
                                    if (_e499 < _e60) {
                                    } else {
                                        break;
                                    }
                                    let _e503 = global_7.member[_e499];
                                    let _e509 = global_2.member[0u][0u];
                                    let _e513 = global_2.member[0u][1u];
                                    let _e517 = global_2.member[0u][2u];
                                    let _e521 = global_2.member[0u][3u];
                                    let _e525 = global_2.member[1u][0u];
                                    let _e529 = global_2.member[1u][1u];
                                    let _e533 = global_2.member[1u][2u];
                                    let _e537 = global_2.member[1u][3u];
                                    let _e541 = bitcast<f32>(_e525);
                                    let _e542 = bitcast<f32>(_e529);
                                    let _e543 = bitcast<f32>(_e533);
                                    let _e545 = vec3<f32>(bitcast<f32>(_e509), bitcast<f32>(_e513), bitcast<f32>(_e517));
                                    let _e546 = (_e521 == 1u);
                                    if _e546 {
                                        phi_1457_ = (_e545 - vec3<f32>(_e139, _e143, _e147));
                                    } else {
                                        phi_1457_ = _e545;
                                    }
                                    let _e549 = phi_1457_;
                                    let _e551 = (_e278 * _e280);
                                    let _e555 = (_e276 * _e281);
                                    let _e560 = (_e277 * _e279);
                                    let _e602 = global_11[0u];
                                    if (_e541 == _e602) {
                                        let _e605 = global_11[1u];
                                        let _e606 = (_e542 == _e605);
                                        if _e606 {
                                            let _e608 = global_11[2u];
                                            phi_1539_ = (_e543 == _e608);
                                        } else {
                                            phi_1539_ = bool();
                                        }
                                        let _e611 = phi_1539_;
                                        phi_1543_ = _e611;
                                        phi_1544_ = select(true, false, _e606);
                                    } else {
                                        phi_1543_ = bool();
                                        phi_1544_ = true;
                                    }
                                    let _e614 = phi_1543_;
                                    let _e616 = phi_1544_;
                                    if select(_e614, false, _e616) {
                                        phi_1687_ = type_50();
                                        phi_1688_ = true;
                                    } else {
                                        let _e619 = (((((_e549.x * (_e282 - _e551)) + (_e549.y * (_e285 - _e555))) + (_e549.z * (_e288 - _e560))) * _e374) > ((0.0000009536752f * (((bitcast<f32>((bitcast<u32>(_e549.x) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e282) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e551) & 2147483647u)))) + (bitcast<f32>((bitcast<u32>(_e549.y) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e285) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e555) & 2147483647u))))) + (bitcast<f32>((bitcast<u32>(_e549.z) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e288) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e560) & 2147483647u)))))) + 0.0000000000000000000000000000000000001880791f));
                                        if _e619 {
                                            let _e621 = select(_e274, _e273, (_e273 > _e274));
                                            let _e638 = (select(_e275, _e621, (_e621 > _e275)) * ((bitcast<f32>((bitcast<u32>(_e378.x) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e378.y) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e378.z) & 2147483647u))));
                                            let _e642 = (((_e225 + _e228) + _e231) + (_e378.x * _e638));
                                            let _e643 = (((_e226 + _e229) + _e232) + (_e378.y * _e638));
                                            let _e644 = (((_e227 + _e230) + _e233) + (_e378.z * _e638));
                                            if (_e378.x > 0f) {
                                                let _e665 = bitcast<u32>(_e642);
                                                if ((_e665 & 2147483647u) == 0u) {
                                                    phi_1769_ = 0.000000000000000000000000000000000000000000001f;
                                                } else {
                                                    if ((_e665 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_1767_ = bitcast<f32>((_e665 + 1u));
                                                    } else {
                                                        phi_1767_ = bitcast<f32>((_e665 - 1u));
                                                    }
                                                    let _e676 = phi_1767_;
                                                    phi_1769_ = _e676;
                                                }
                                                let _e678 = phi_1769_;
                                                phi_1797_ = _e678;
                                            } else {
                                                if (_e378.x < 0f) {
                                                    let _e648 = bitcast<u32>(-(_e642));
                                                    if ((_e648 & 2147483647u) == 0u) {
                                                        phi_1791_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e648 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_1789_ = bitcast<f32>((_e648 + 1u));
                                                        } else {
                                                            phi_1789_ = bitcast<f32>((_e648 - 1u));
                                                        }
                                                        let _e659 = phi_1789_;
                                                        phi_1791_ = _e659;
                                                    }
                                                    let _e661 = phi_1791_;
                                                    phi_1795_ = -(_e661);
                                                } else {
                                                    phi_1795_ = _e642;
                                                }
                                                let _e664 = phi_1795_;
                                                phi_1797_ = _e664;
                                            }
                                            let _e680 = phi_1797_;
                                            if (_e378.y > 0f) {
                                                let _e701 = bitcast<u32>(_e643);
                                                if ((_e701 & 2147483647u) == 0u) {
                                                    phi_1820_ = 0.000000000000000000000000000000000000000000001f;
                                                } else {
                                                    if ((_e701 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_1818_ = bitcast<f32>((_e701 + 1u));
                                                    } else {
                                                        phi_1818_ = bitcast<f32>((_e701 - 1u));
                                                    }
                                                    let _e712 = phi_1818_;
                                                    phi_1820_ = _e712;
                                                }
                                                let _e714 = phi_1820_;
                                                phi_1848_ = _e714;
                                            } else {
                                                if (_e378.y < 0f) {
                                                    let _e684 = bitcast<u32>(-(_e643));
                                                    if ((_e684 & 2147483647u) == 0u) {
                                                        phi_1842_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e684 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_1840_ = bitcast<f32>((_e684 + 1u));
                                                        } else {
                                                            phi_1840_ = bitcast<f32>((_e684 - 1u));
                                                        }
                                                        let _e695 = phi_1840_;
                                                        phi_1842_ = _e695;
                                                    }
                                                    let _e697 = phi_1842_;
                                                    phi_1846_ = -(_e697);
                                                } else {
                                                    phi_1846_ = _e643;
                                                }
                                                let _e700 = phi_1846_;
                                                phi_1848_ = _e700;
                                            }
                                            let _e716 = phi_1848_;
                                            if (_e378.z > 0f) {
                                                let _e737 = bitcast<u32>(_e644);
                                                if ((_e737 & 2147483647u) == 0u) {
                                                    phi_1871_ = 0.000000000000000000000000000000000000000000001f;
                                                } else {
                                                    if ((_e737 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_1869_ = bitcast<f32>((_e737 + 1u));
                                                    } else {
                                                        phi_1869_ = bitcast<f32>((_e737 - 1u));
                                                    }
                                                    let _e748 = phi_1869_;
                                                    phi_1871_ = _e748;
                                                }
                                                let _e750 = phi_1871_;
                                                phi_1899_ = _e750;
                                            } else {
                                                if (_e378.z < 0f) {
                                                    let _e720 = bitcast<u32>(-(_e644));
                                                    if ((_e720 & 2147483647u) == 0u) {
                                                        phi_1893_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e720 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_1891_ = bitcast<f32>((_e720 + 1u));
                                                        } else {
                                                            phi_1891_ = bitcast<f32>((_e720 - 1u));
                                                        }
                                                        let _e731 = phi_1891_;
                                                        phi_1893_ = _e731;
                                                    }
                                                    let _e733 = phi_1893_;
                                                    phi_1897_ = -(_e733);
                                                } else {
                                                    phi_1897_ = _e644;
                                                }
                                                let _e736 = phi_1897_;
                                                phi_1899_ = _e736;
                                            }
                                            let _e752 = phi_1899_;
                                            if _e546 {
                                                phi_1565_ = (_e545 - vec3<f32>(_e680, _e716, _e752));
                                            } else {
                                                phi_1565_ = _e545;
                                            }
                                            let _e756 = phi_1565_;
                                            let _e765 = sqrt((((_e756.x * _e756.x) + (_e756.y * _e756.y)) + (_e756.z * _e756.z)));
                                            let _e774 = ((((_e491.x * _e756.x) + (_e491.y * _e756.y)) + (_e491.z * _e756.z)) / _e765);
                                            if _e546 {
                                                let _e781 = (_e765 <= bitcast<f32>(_e537));
                                                if _e546 {
                                                    phi_1601_ = (1f / (_e765 * _e765));
                                                } else {
                                                    phi_1601_ = 1f;
                                                }
                                                let _e785 = phi_1601_;
                                                let _e786 = (_e774 > 0f);
                                                if _e786 {
                                                    phi_1612_ = select(true, false, _e781);
                                                } else {
                                                    phi_1612_ = false;
                                                }
                                                let _e789 = phi_1612_;
                                                phi_1626_ = _e785;
                                                phi_1627_ = select(false, _e781, _e786);
                                                phi_1628_ = select(true, false, _e786);
                                                phi_1629_ = _e789;
                                            } else {
                                                if _e546 {
                                                    phi_1619_ = (1f / (_e765 * _e765));
                                                } else {
                                                    phi_1619_ = 1f;
                                                }
                                                let _e778 = phi_1619_;
                                                let _e779 = (_e774 > 0f);
                                                phi_1626_ = _e778;
                                                phi_1627_ = _e779;
                                                phi_1628_ = select(true, false, _e779);
                                                phi_1629_ = false;
                                            }
                                            let _e793 = phi_1626_;
                                            let _e795 = phi_1627_;
                                            let _e797 = phi_1628_;
                                            let _e799 = phi_1629_;
                                            if _e795 {
                                                let _e808 = ((1f - _e503.member_1) * 0.31830987f);
                                                let _e815 = (_e774 * _e793);
                                                phi_1671_ = type_50(type_30(array<f32, 3>(_e680, _e716, _e752), 0f, array<f32, 3>(_e756.x, _e756.y, _e756.z), select(340282350000000000000000000000000000000f, 1f, _e546)), vec3<f32>(((_e541 * (_e503.member[0] * _e808)) * _e815), ((_e542 * (_e503.member[1] * _e808)) * _e815), ((_e543 * (_e503.member[2] * _e808)) * _e815)));
                                            } else {
                                                phi_1671_ = type_50();
                                            }
                                            let _e822 = phi_1671_;
                                            if select(select(_e799, false, _e795), true, select(_e797, false, _e795)) {
                                                phi_1681_ = type_50(type_30(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), vec3<f32>(0f, 0f, 0f));
                                            } else {
                                                phi_1681_ = _e822;
                                            }
                                            let _e827 = phi_1681_;
                                            phi_1684_ = _e827;
                                        } else {
                                            phi_1684_ = type_50();
                                        }
                                        let _e829 = phi_1684_;
                                        phi_1687_ = _e829;
                                        phi_1688_ = select(true, false, _e619);
                                    }
                                    let _e832 = phi_1687_;
                                    let _e834 = phi_1688_;
                                    if _e834 {
                                        phi_1692_ = type_50(type_30(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), vec3<f32>(0f, 0f, 0f));
                                    } else {
                                        phi_1692_ = _e832;
                                    }
                                    let _e836 = phi_1692_;
                                    phi_881_ = type_45(_e836.member, array<f32, 3>(_e836.member_1.x, _e836.member_1.y, _e836.member_1.z), _e79.member_3);
                                }
                                let _e847 = phi_881_;
                                phi_882_ = _e847;
                            } else {
                                phi_882_ = type_45(type_30(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                            }
                            let _e849 = phi_882_;
                            phi_883_ = _e849;
                        } else {
                            phi_883_ = type_45(type_30(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                        }
                        let _e851 = phi_883_;
                        if _e73 {
                        } else {
                            break;
                        }
                        global_10.member[_e70] = _e851;
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn shade_light(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
