struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_11 {
    member: vec4<u32>,
}

struct type_16 {
    member: array<array<f32, 3>>,
}

struct type_20 {
    member: array<array<u32, 3>>,
}

struct type_29 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_31 {
    member: array<type_29>,
}

struct type_33 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_34 {
    member: type_33,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_36 {
    member: array<type_34>,
}

struct type_41 {
    member: array<vec4<u32>, 2>,
}

struct type_43 {
    member: array<f32, 3>,
    member_1: f32,
}

struct type_45 {
    member: array<type_43>,
}

struct type_47 {
    member: type_33,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_49 {
    member: array<type_47>,
}

struct type_51 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: f32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_11;
@group(0) @binding(1) 
var<uniform> global_2: type_41;
@group(0) @binding(2) 
var<storage> global_3: type_16;
@group(0) @binding(3) 
var<storage> global_4: type_20;
@group(0) @binding(4) 
var<storage> global_5: type_16;
@group(0) @binding(5) 
var<storage> global_6: type_4;
@group(0) @binding(6) 
var<storage> global_7: type_45;
@group(0) @binding(7) 
var<storage> global_8: type_31;
@group(0) @binding(8) 
var<storage> global_9: type_36;
@group(0) @binding(9) 
var<storage, read_write> global_10: type_49;
var<private> global_11: vec3<f32> = vec3<f32>(0f, 0f, 0f);

fn function_() {
    var local: type_51;
    var local_1: type_51;
    var phi_268_: array<u32, 3>;
    var phi_283_: array<f32, 3>;
    var phi_301_: array<f32, 3>;
    var phi_319_: array<f32, 3>;
    var phi_406_: array<u32, 3>;
    var phi_423_: vec3<f32>;
    var phi_440_: vec3<f32>;
    var phi_457_: vec3<f32>;
    var phi_591_: i32;
    var phi_622_: i32;
    var phi_641_: vec3<f32>;
    var phi_724_: i32;
    var phi_755_: i32;
    var phi_774_: vec3<f32>;
    var phi_816_: u32;
    var phi_927_: type_7;
    var phi_928_: type_7;
    var phi_951_: type_7;
    var phi_2117_: bool;
    var phi_1607_: vec3<f32>;
    var phi_1690_: bool;
    var phi_1693_: bool;
    var phi_1694_: bool;
    var phi_1919_: f32;
    var phi_1923_: f32;
    var phi_1926_: f32;
    var phi_1941_: f32;
    var phi_1945_: f32;
    var phi_1947_: f32;
    var phi_1970_: f32;
    var phi_1974_: f32;
    var phi_1977_: f32;
    var phi_1992_: f32;
    var phi_1996_: f32;
    var phi_1998_: f32;
    var phi_2021_: f32;
    var phi_2025_: f32;
    var phi_2028_: f32;
    var phi_2043_: f32;
    var phi_2047_: f32;
    var phi_2049_: f32;
    var phi_1715_: vec3<f32>;
    var phi_1748_: f32;
    var phi_1763_: f32;
    var phi_1774_: bool;
    var phi_1776_: f32;
    var phi_1777_: bool;
    var phi_1778_: bool;
    var phi_1779_: bool;
    var phi_1821_: type_47;
    var phi_1831_: type_47;
    var phi_1833_: type_47;
    var phi_1837_: type_47;
    var phi_1838_: bool;
    var phi_1842_: type_47;
    var phi_1028_: type_47;
    var phi_1029_: type_47;
    var phi_1030_: type_47;

    switch bitcast<i32>(0u) {
        default: {
            let _e52 = global;
            let _e55 = arrayLength((&global_3.member));
            let _e60 = arrayLength((&global_5.member));
            let _e64 = arrayLength((&global_7.member));
            let _e74 = (_e52.x + (_e52.y * 2097152u));
            let _e75 = (_e74 < arrayLength((&global_9.member)));
            if _e75 {
                let _e76 = (_e74 < arrayLength((&global_8.member)));
                if _e76 {
                    let _e77 = (_e74 < arrayLength((&global_10.member)));
                    if _e77 {
                        if _e75 {
                        } else {
                            break;
                        }
                        let _e80 = global_9.member[_e74];
                        if _e76 {
                        } else {
                            break;
                        }
                        let _e83 = global_8.member[_e74];
                        if (_e80.member.member_1 <= _e80.member.member_3) {
                            if (_e83.member_3 != 4294967295u) {
                                if (_e64 == 0u) {
                                    phi_1028_ = type_47(type_33(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                                } else {
                                    let _e94 = global_1.member[0u];
                                    let _e95 = bitcast<i32>(_e94);
                                    let _e96 = (_e95 / 2i);
                                    let _e101 = bitcast<f32>((bitcast<u32>((_e96 + 127i)) << bitcast<u32>(23i)));
                                    let _e107 = bitcast<f32>((bitcast<u32>(((_e95 - _e96) + 127i)) << bitcast<u32>(23i)));
                                    let _e108 = (_e83.member_3 < arrayLength((&global_4.member)));
                                    if _e108 {
                                        if _e108 {
                                        } else {
                                            break;
                                        }
                                        let _e110 = global_4.member[_e83.member_3];
                                        phi_268_ = _e110;
                                    } else {
                                        phi_268_ = array<u32, 3>(0u, 0u, 0u);
                                    }
                                    let _e112 = phi_268_;
                                    let _e114 = (_e112[0] < _e55);
                                    if _e114 {
                                        if _e114 {
                                        } else {
                                            break;
                                        }
                                        let _e116 = global_3.member[_e112[0]];
                                        phi_283_ = _e116;
                                    } else {
                                        phi_283_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e118 = phi_283_;
                                    let _e123 = (_e112[1] < _e55);
                                    if _e123 {
                                        if _e123 {
                                        } else {
                                            break;
                                        }
                                        let _e125 = global_3.member[_e112[1]];
                                        phi_301_ = _e125;
                                    } else {
                                        phi_301_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e127 = phi_301_;
                                    let _e132 = (_e112[2] < _e55);
                                    if _e132 {
                                        if _e132 {
                                        } else {
                                            break;
                                        }
                                        let _e134 = global_3.member[_e112[2]];
                                        phi_319_ = _e134;
                                    } else {
                                        phi_319_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e136 = phi_319_;
                                    let _e141 = ((_e118[0] * _e101) * _e107);
                                    let _e143 = select(_e141, 0f, (_e141 == 0f));
                                    let _e145 = ((_e118[1] * _e101) * _e107);
                                    let _e147 = select(_e145, 0f, (_e145 == 0f));
                                    let _e149 = ((_e118[2] * _e101) * _e107);
                                    let _e151 = select(_e149, 0f, (_e149 == 0f));
                                    let _e153 = ((_e127[0] * _e101) * _e107);
                                    let _e155 = select(_e153, 0f, (_e153 == 0f));
                                    let _e157 = ((_e127[1] * _e101) * _e107);
                                    let _e159 = select(_e157, 0f, (_e157 == 0f));
                                    let _e161 = ((_e127[2] * _e101) * _e107);
                                    let _e163 = select(_e161, 0f, (_e161 == 0f));
                                    let _e165 = ((_e136[0] * _e101) * _e107);
                                    let _e167 = select(_e165, 0f, (_e165 == 0f));
                                    let _e169 = ((_e136[1] * _e101) * _e107);
                                    let _e171 = select(_e169, 0f, (_e169 == 0f));
                                    let _e173 = ((_e136[2] * _e101) * _e107);
                                    let _e175 = select(_e173, 0f, (_e173 == 0f));
                                    if _e108 {
                                        if _e108 {
                                        } else {
                                            break;
                                        }
                                        let _e178 = global_4.member[_e83.member_3];
                                        phi_406_ = _e178;
                                    } else {
                                        phi_406_ = array<u32, 3>(0u, 0u, 0u);
                                    }
                                    let _e180 = phi_406_;
                                    let _e182 = (_e180[0] < _e60);
                                    if _e182 {
                                        if _e182 {
                                        } else {
                                            break;
                                        }
                                        let _e185 = global_5.member[_e180[0]];
                                        phi_423_ = vec3<f32>(_e185[0], _e185[1], _e185[2]);
                                    } else {
                                        phi_423_ = vec3<f32>(0f, 0f, 0f);
                                    }
                                    let _e191 = phi_423_;
                                    let _e193 = (_e180[1] < _e60);
                                    if _e193 {
                                        if _e193 {
                                        } else {
                                            break;
                                        }
                                        let _e196 = global_5.member[_e180[1]];
                                        phi_440_ = vec3<f32>(_e196[0], _e196[1], _e196[2]);
                                    } else {
                                        phi_440_ = vec3<f32>(0f, 0f, 0f);
                                    }
                                    let _e202 = phi_440_;
                                    let _e204 = (_e180[2] < _e60);
                                    if _e204 {
                                        if _e204 {
                                        } else {
                                            break;
                                        }
                                        let _e207 = global_5.member[_e180[2]];
                                        phi_457_ = vec3<f32>(_e207[0], _e207[1], _e207[2]);
                                    } else {
                                        phi_457_ = vec3<f32>(0f, 0f, 0f);
                                    }
                                    let _e213 = phi_457_;
                                    let _e222 = ((1f - _e83.member_1) - _e83.member_2);
                                    let _e224 = select(0f, _e222, (_e222 > 0f));
                                    let _e226 = select(1f, _e83.member_1, (_e83.member_1 < 1f));
                                    let _e228 = select(1f, _e83.member_2, (_e83.member_2 < 1f));
                                    let _e229 = (_e143 * _e224);
                                    let _e230 = (_e147 * _e224);
                                    let _e231 = (_e151 * _e224);
                                    let _e232 = (_e155 * _e226);
                                    let _e233 = (_e159 * _e226);
                                    let _e234 = (_e163 * _e226);
                                    let _e235 = (_e167 * _e228);
                                    let _e236 = (_e171 * _e228);
                                    let _e237 = (_e175 * _e228);
                                    let _e277 = (((bitcast<f32>((bitcast<u32>(_e229) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e232) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e235) & 2147483647u))) * 0.00000071525625f);
                                    let _e278 = (((bitcast<f32>((bitcast<u32>(_e230) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e233) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e236) & 2147483647u))) * 0.00000071525625f);
                                    let _e279 = (((bitcast<f32>((bitcast<u32>(_e231) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e234) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e237) & 2147483647u))) * 0.00000071525625f);
                                    let _e280 = (_e155 - _e143);
                                    let _e281 = (_e159 - _e147);
                                    let _e282 = (_e163 - _e151);
                                    let _e283 = (_e167 - _e143);
                                    let _e284 = (_e171 - _e147);
                                    let _e285 = (_e175 - _e151);
                                    let _e286 = (_e281 * _e285);
                                    let _e288 = (_e286 - (_e284 * _e282));
                                    let _e289 = (_e282 * _e283);
                                    let _e291 = (_e289 - (_e285 * _e280));
                                    let _e292 = (_e280 * _e284);
                                    let _e294 = (_e292 - (_e283 * _e281));
                                    let _e297 = bitcast<f32>((bitcast<u32>(_e288) & 2147483647u));
                                    let _e300 = bitcast<f32>((bitcast<u32>(_e291) & 2147483647u));
                                    let _e302 = select(_e300, _e297, (_e297 > _e300));
                                    let _e305 = bitcast<f32>((bitcast<u32>(_e294) & 2147483647u));
                                    let _e307 = select(_e305, _e302, (_e302 > _e305));
                                    if (_e307 < 0.000000000000000000000000000000000000011754944f) {
                                        phi_641_ = vec3<f32>(0f, 0f, 0f);
                                    } else {
                                        let _e310 = (bitcast<u32>(_e307) & 2147483647u);
                                        let _e311 = (_e310 >= 8388608u);
                                        if _e311 {
                                            phi_591_ = (bitcast<i32>((_e310 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_591_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e310)), 32u, (_e310 == 0u))));
                                        }
                                        let _e324 = phi_591_;
                                        let _e331 = bitcast<f32>((bitcast<u32>(((_e324 / -2i) + 127i)) << bitcast<u32>(23i)));
                                        if _e311 {
                                            phi_622_ = (bitcast<i32>((_e310 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_622_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e310)), 32u, (_e310 == 0u))));
                                        }
                                        let _e347 = phi_622_;
                                        let _e353 = bitcast<f32>((bitcast<u32>((((_e324 / 2i) - _e347) + 127i)) << bitcast<u32>(23i)));
                                        let _e354 = ((_e288 * _e331) * _e353);
                                        let _e355 = ((_e291 * _e331) * _e353);
                                        let _e356 = ((_e294 * _e331) * _e353);
                                        let _e362 = sqrt((((_e354 * _e354) + (_e355 * _e355)) + (_e356 * _e356)));
                                        phi_641_ = vec3<f32>((_e354 / _e362), (_e355 / _e362), (_e356 / _e362));
                                    }
                                    let _e368 = phi_641_;
                                    let _e378 = select(1f, -1f, ((((_e368.x * _e80.member.member_2[0]) + (_e368.y * _e80.member.member_2[1])) + (_e368.z * _e80.member.member_2[2])) > 0f));
                                    let _e382 = (_e368 * _e378);
                                    let _e404 = (((_e191.x * _e224) + (_e202.x * _e226)) + (_e213.x * _e228));
                                    let _e405 = (((_e191.y * _e224) + (_e202.y * _e226)) + (_e213.y * _e228));
                                    let _e406 = (((_e191.z * _e224) + (_e202.z * _e226)) + (_e213.z * _e228));
                                    let _e409 = bitcast<f32>((bitcast<u32>(_e404) & 2147483647u));
                                    let _e412 = bitcast<f32>((bitcast<u32>(_e405) & 2147483647u));
                                    let _e414 = select(_e412, _e409, (_e409 > _e412));
                                    let _e417 = bitcast<f32>((bitcast<u32>(_e406) & 2147483647u));
                                    let _e419 = select(_e417, _e414, (_e414 > _e417));
                                    if (_e419 < 0.000000000000000000000000000000000000011754944f) {
                                        phi_774_ = vec3<f32>(0f, 0f, 0f);
                                    } else {
                                        let _e422 = (bitcast<u32>(_e419) & 2147483647u);
                                        let _e423 = (_e422 >= 8388608u);
                                        if _e423 {
                                            phi_724_ = (bitcast<i32>((_e422 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_724_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e422)), 32u, (_e422 == 0u))));
                                        }
                                        let _e436 = phi_724_;
                                        let _e443 = bitcast<f32>((bitcast<u32>(((_e436 / -2i) + 127i)) << bitcast<u32>(23i)));
                                        if _e423 {
                                            phi_755_ = (bitcast<i32>((_e422 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_755_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e422)), 32u, (_e422 == 0u))));
                                        }
                                        let _e459 = phi_755_;
                                        let _e465 = bitcast<f32>((bitcast<u32>((((_e436 / 2i) - _e459) + 127i)) << bitcast<u32>(23i)));
                                        let _e466 = ((_e404 * _e443) * _e465);
                                        let _e467 = ((_e405 * _e443) * _e465);
                                        let _e468 = ((_e406 * _e443) * _e465);
                                        let _e474 = sqrt((((_e466 * _e466) + (_e467 * _e467)) + (_e468 * _e468)));
                                        phi_774_ = vec3<f32>((_e466 / _e474), (_e467 / _e474), (_e468 / _e474));
                                    }
                                    let _e480 = phi_774_;
                                    let _e495 = select(_e382, (_e480 * _e378), vec3((((((_e480.x * _e378) * (_e368.x * _e378)) + ((_e480.y * _e378) * (_e368.y * _e378))) + ((_e480.z * _e378) * (_e368.z * _e378))) > 0f)));
                                    let _e496 = (_e83.member_3 < arrayLength((&global_6.member)));
                                    if _e496 {
                                        if _e496 {
                                        } else {
                                            break;
                                        }
                                        let _e499 = global_6.member[_e83.member_3];
                                        phi_816_ = _e499;
                                    } else {
                                        phi_816_ = 0u;
                                    }
                                    let _e501 = phi_816_;
                                    let _e503 = select(_e501, 0u, (_e501 >= _e64));
                                    if (_e503 < _e64) {
                                    } else {
                                        break;
                                    }
                                    let _e507 = global_7.member[_e503];
                                    let _e513 = global_2.member[0u][0u];
                                    let _e517 = global_2.member[0u][1u];
                                    let _e521 = global_2.member[0u][2u];
                                    let _e525 = global_2.member[0u][3u];
                                    let _e529 = global_2.member[1u][0u];
                                    let _e533 = global_2.member[1u][1u];
                                    let _e537 = global_2.member[1u][2u];
                                    let _e541 = global_2.member[1u][3u];
                                    local_1 = type_51(array<f32, 3>(bitcast<f32>(_e513), bitcast<f32>(_e517), bitcast<f32>(_e521)), _e525, array<f32, 3>(bitcast<f32>(_e529), bitcast<f32>(_e533), bitcast<f32>(_e537)), bitcast<f32>(_e541));
                                    let _e552 = local_1;
                                    local = _e552;
                                    let _e554 = local_1.member_1;
                                    if (_e554 == 1u) {
                                        let _e557 = local_1.member;
                                        local.member = array<f32, 3>(((_e557[0] * _e101) * _e107), ((_e557[1] * _e101) * _e107), ((_e557[2] * _e101) * _e107));
                                        phi_927_ = type_7(0u, 3u);
                                        loop {
                                            let _e570 = phi_927_;
                                            if (_e570.member < _e570.member_1) {
                                                phi_928_ = type_7((_e570.member + 1u), _e570.member_1);
                                                phi_951_ = type_7(1u, _e570.member);
                                            } else {
                                                phi_928_ = _e570;
                                                phi_951_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e583 = phi_928_;
                                            let _e585 = phi_951_;
                                            let _e589 = (bitcast<i32>(_e585.member) != 0i);
                                            if _e589 {
                                                let _e590 = (_e585.member_1 < 3u);
                                                if _e590 {
                                                } else {
                                                    phi_2117_ = true;
                                                    break;
                                                }
                                                let _e593 = local_1.member_2[_e585.member_1];
                                                let _e597 = ((((_e593 * _e101) * _e107) * _e101) * _e107);
                                                if _e590 {
                                                } else {
                                                    phi_2117_ = true;
                                                    break;
                                                }
                                                local.member_2[_e585.member_1] = select(340282350000000000000000000000000000000f, _e597, (_e597 < 340282350000000000000000000000000000000f));
                                            }
                                            continue;
                                            continuing {
                                                phi_927_ = _e583;
                                                phi_2117_ = false;
                                                break if !(_e589);
                                            }
                                        }
                                        let _e604 = phi_2117_;
                                        if _e604 {
                                            break;
                                        }
                                        let _e606 = local_1.member_3;
                                        if (_e606 < 340282350000000000000000000000000000000f) {
                                            let _e608 = local_1.member_3;
                                            let _e610 = ((_e608 * _e101) * _e107);
                                            local.member_3 = select(340282350000000000000000000000000000000f, _e610, (_e610 < 340282350000000000000000000000000000000f));
                                        }
                                    }
                                    let _e614 = local;
                                    let _e622 = vec3<f32>(_e614.member[0], _e614.member[1], _e614.member[2]);
                                    let _e626 = (_e614.member_1 == 1u);
                                    if _e626 {
                                        phi_1607_ = (_e622 - vec3<f32>(_e143, _e147, _e151));
                                    } else {
                                        phi_1607_ = _e622;
                                    }
                                    let _e629 = phi_1607_;
                                    let _e631 = (_e282 * _e284);
                                    let _e635 = (_e280 * _e285);
                                    let _e640 = (_e281 * _e283);
                                    let _e682 = global_11[0u];
                                    if (_e614.member_2[0] == _e682) {
                                        let _e685 = global_11[1u];
                                        let _e686 = (_e614.member_2[1] == _e685);
                                        if _e686 {
                                            let _e688 = global_11[2u];
                                            phi_1690_ = (_e614.member_2[2] == _e688);
                                        } else {
                                            phi_1690_ = bool();
                                        }
                                        let _e691 = phi_1690_;
                                        phi_1693_ = _e691;
                                        phi_1694_ = select(true, false, _e686);
                                    } else {
                                        phi_1693_ = bool();
                                        phi_1694_ = true;
                                    }
                                    let _e694 = phi_1693_;
                                    let _e696 = phi_1694_;
                                    if select(_e694, false, _e696) {
                                        phi_1837_ = type_47();
                                        phi_1838_ = true;
                                    } else {
                                        let _e699 = (((((_e629.x * (_e286 - _e631)) + (_e629.y * (_e289 - _e635))) + (_e629.z * (_e292 - _e640))) * _e378) > ((0.0000009536752f * (((bitcast<f32>((bitcast<u32>(_e629.x) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e286) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e631) & 2147483647u)))) + (bitcast<f32>((bitcast<u32>(_e629.y) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e289) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e635) & 2147483647u))))) + (bitcast<f32>((bitcast<u32>(_e629.z) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e292) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e640) & 2147483647u)))))) + 0.0000000000000000000000000000000000001880791f));
                                        if _e699 {
                                            let _e701 = select(_e278, _e277, (_e277 > _e278));
                                            let _e718 = (select(_e279, _e701, (_e701 > _e279)) * ((bitcast<f32>((bitcast<u32>(_e382.x) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e382.y) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e382.z) & 2147483647u))));
                                            let _e722 = (((_e229 + _e232) + _e235) + (_e382.x * _e718));
                                            let _e723 = (((_e230 + _e233) + _e236) + (_e382.y * _e718));
                                            let _e724 = (((_e231 + _e234) + _e237) + (_e382.z * _e718));
                                            if (_e382.x > 0f) {
                                                let _e745 = bitcast<u32>(_e722);
                                                if ((_e745 & 2147483647u) == 0u) {
                                                    phi_1945_ = 0.000000000000000000000000000000000000000000001f;
                                                } else {
                                                    if ((_e745 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_1941_ = bitcast<f32>((_e745 + 1u));
                                                    } else {
                                                        phi_1941_ = bitcast<f32>((_e745 - 1u));
                                                    }
                                                    let _e756 = phi_1941_;
                                                    phi_1945_ = _e756;
                                                }
                                                let _e758 = phi_1945_;
                                                phi_1947_ = _e758;
                                            } else {
                                                if (_e382.x < 0f) {
                                                    let _e728 = bitcast<u32>(-(_e722));
                                                    if ((_e728 & 2147483647u) == 0u) {
                                                        phi_1923_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e728 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_1919_ = bitcast<f32>((_e728 + 1u));
                                                        } else {
                                                            phi_1919_ = bitcast<f32>((_e728 - 1u));
                                                        }
                                                        let _e739 = phi_1919_;
                                                        phi_1923_ = _e739;
                                                    }
                                                    let _e741 = phi_1923_;
                                                    phi_1926_ = -(_e741);
                                                } else {
                                                    phi_1926_ = _e722;
                                                }
                                                let _e744 = phi_1926_;
                                                phi_1947_ = _e744;
                                            }
                                            let _e760 = phi_1947_;
                                            if (_e382.y > 0f) {
                                                let _e781 = bitcast<u32>(_e723);
                                                if ((_e781 & 2147483647u) == 0u) {
                                                    phi_1996_ = 0.000000000000000000000000000000000000000000001f;
                                                } else {
                                                    if ((_e781 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_1992_ = bitcast<f32>((_e781 + 1u));
                                                    } else {
                                                        phi_1992_ = bitcast<f32>((_e781 - 1u));
                                                    }
                                                    let _e792 = phi_1992_;
                                                    phi_1996_ = _e792;
                                                }
                                                let _e794 = phi_1996_;
                                                phi_1998_ = _e794;
                                            } else {
                                                if (_e382.y < 0f) {
                                                    let _e764 = bitcast<u32>(-(_e723));
                                                    if ((_e764 & 2147483647u) == 0u) {
                                                        phi_1974_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e764 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_1970_ = bitcast<f32>((_e764 + 1u));
                                                        } else {
                                                            phi_1970_ = bitcast<f32>((_e764 - 1u));
                                                        }
                                                        let _e775 = phi_1970_;
                                                        phi_1974_ = _e775;
                                                    }
                                                    let _e777 = phi_1974_;
                                                    phi_1977_ = -(_e777);
                                                } else {
                                                    phi_1977_ = _e723;
                                                }
                                                let _e780 = phi_1977_;
                                                phi_1998_ = _e780;
                                            }
                                            let _e796 = phi_1998_;
                                            if (_e382.z > 0f) {
                                                let _e817 = bitcast<u32>(_e724);
                                                if ((_e817 & 2147483647u) == 0u) {
                                                    phi_2047_ = 0.000000000000000000000000000000000000000000001f;
                                                } else {
                                                    if ((_e817 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_2043_ = bitcast<f32>((_e817 + 1u));
                                                    } else {
                                                        phi_2043_ = bitcast<f32>((_e817 - 1u));
                                                    }
                                                    let _e828 = phi_2043_;
                                                    phi_2047_ = _e828;
                                                }
                                                let _e830 = phi_2047_;
                                                phi_2049_ = _e830;
                                            } else {
                                                if (_e382.z < 0f) {
                                                    let _e800 = bitcast<u32>(-(_e724));
                                                    if ((_e800 & 2147483647u) == 0u) {
                                                        phi_2025_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e800 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_2021_ = bitcast<f32>((_e800 + 1u));
                                                        } else {
                                                            phi_2021_ = bitcast<f32>((_e800 - 1u));
                                                        }
                                                        let _e811 = phi_2021_;
                                                        phi_2025_ = _e811;
                                                    }
                                                    let _e813 = phi_2025_;
                                                    phi_2028_ = -(_e813);
                                                } else {
                                                    phi_2028_ = _e724;
                                                }
                                                let _e816 = phi_2028_;
                                                phi_2049_ = _e816;
                                            }
                                            let _e832 = phi_2049_;
                                            if _e626 {
                                                phi_1715_ = (_e622 - vec3<f32>(_e760, _e796, _e832));
                                            } else {
                                                phi_1715_ = _e622;
                                            }
                                            let _e836 = phi_1715_;
                                            let _e845 = sqrt((((_e836.x * _e836.x) + (_e836.y * _e836.y)) + (_e836.z * _e836.z)));
                                            let _e854 = ((((_e495.x * _e836.x) + (_e495.y * _e836.y)) + (_e495.z * _e836.z)) / _e845);
                                            if _e626 {
                                                let _e861 = (_e845 <= _e614.member_3);
                                                if _e626 {
                                                    phi_1763_ = (1f / (_e845 * _e845));
                                                } else {
                                                    phi_1763_ = 1f;
                                                }
                                                let _e865 = phi_1763_;
                                                let _e866 = (_e854 > 0f);
                                                if _e866 {
                                                    phi_1774_ = select(true, false, _e861);
                                                } else {
                                                    phi_1774_ = false;
                                                }
                                                let _e869 = phi_1774_;
                                                phi_1776_ = _e865;
                                                phi_1777_ = select(false, _e861, _e866);
                                                phi_1778_ = select(true, false, _e866);
                                                phi_1779_ = _e869;
                                            } else {
                                                if _e626 {
                                                    phi_1748_ = (1f / (_e845 * _e845));
                                                } else {
                                                    phi_1748_ = 1f;
                                                }
                                                let _e858 = phi_1748_;
                                                let _e859 = (_e854 > 0f);
                                                phi_1776_ = _e858;
                                                phi_1777_ = _e859;
                                                phi_1778_ = select(true, false, _e859);
                                                phi_1779_ = false;
                                            }
                                            let _e873 = phi_1776_;
                                            let _e875 = phi_1777_;
                                            let _e877 = phi_1778_;
                                            let _e879 = phi_1779_;
                                            if _e875 {
                                                let _e884 = ((1f - _e507.member_1) * 0.31830987f);
                                                let _e891 = (_e854 * _e873);
                                                phi_1821_ = type_47(type_33(array<f32, 3>(_e760, _e796, _e832), 0f, array<f32, 3>(_e836.x, _e836.y, _e836.z), select(340282350000000000000000000000000000000f, 1f, _e626)), array<f32, 3>(((_e614.member_2[0] * (_e507.member[0] * _e884)) * _e891), ((_e614.member_2[1] * (_e507.member[1] * _e884)) * _e891), ((_e614.member_2[2] * (_e507.member[2] * _e884)) * _e891)), _e83.member_3);
                                            } else {
                                                phi_1821_ = type_47();
                                            }
                                            let _e902 = phi_1821_;
                                            if select(select(_e879, false, _e875), true, select(_e877, false, _e875)) {
                                                phi_1831_ = type_47(type_33(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                                            } else {
                                                phi_1831_ = _e902;
                                            }
                                            let _e907 = phi_1831_;
                                            phi_1833_ = _e907;
                                        } else {
                                            phi_1833_ = type_47();
                                        }
                                        let _e909 = phi_1833_;
                                        phi_1837_ = _e909;
                                        phi_1838_ = select(true, false, _e699);
                                    }
                                    let _e912 = phi_1837_;
                                    let _e914 = phi_1838_;
                                    if _e914 {
                                        phi_1842_ = type_47(type_33(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                                    } else {
                                        phi_1842_ = _e912;
                                    }
                                    let _e916 = phi_1842_;
                                    phi_1028_ = _e916;
                                }
                                let _e918 = phi_1028_;
                                phi_1029_ = _e918;
                            } else {
                                phi_1029_ = type_47(type_33(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                            }
                            let _e920 = phi_1029_;
                            phi_1030_ = _e920;
                        } else {
                            phi_1030_ = type_47(type_33(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                        }
                        let _e922 = phi_1030_;
                        if _e77 {
                        } else {
                            break;
                        }
                        global_10.member[_e74] = _e922;
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
