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
    var phi_272_: array<u32, 3>;
    var phi_287_: array<f32, 3>;
    var phi_305_: array<f32, 3>;
    var phi_323_: array<f32, 3>;
    var phi_410_: array<u32, 3>;
    var phi_427_: vec3<f32>;
    var phi_444_: vec3<f32>;
    var phi_461_: vec3<f32>;
    var phi_595_: i32;
    var phi_626_: i32;
    var phi_645_: vec3<f32>;
    var phi_728_: i32;
    var phi_759_: i32;
    var phi_778_: vec3<f32>;
    var phi_820_: u32;
    var phi_931_: type_7;
    var phi_932_: type_7;
    var phi_955_: type_7;
    var phi_2389_: bool;
    var phi_1757_: vec3<f32>;
    var phi_1958_: bool;
    var phi_1961_: bool;
    var phi_1962_: bool;
    var phi_2187_: f32;
    var phi_2191_: f32;
    var phi_2194_: f32;
    var phi_2209_: f32;
    var phi_2213_: f32;
    var phi_2215_: f32;
    var phi_2238_: f32;
    var phi_2242_: f32;
    var phi_2245_: f32;
    var phi_2260_: f32;
    var phi_2264_: f32;
    var phi_2266_: f32;
    var phi_2289_: f32;
    var phi_2293_: f32;
    var phi_2296_: f32;
    var phi_2311_: f32;
    var phi_2315_: f32;
    var phi_2317_: f32;
    var phi_1983_: vec3<f32>;
    var phi_2016_: f32;
    var phi_2031_: f32;
    var phi_2042_: bool;
    var phi_2044_: f32;
    var phi_2045_: bool;
    var phi_2046_: bool;
    var phi_2047_: bool;
    var phi_2089_: type_47;
    var phi_2099_: type_47;
    var phi_2101_: type_47;
    var phi_2105_: type_47;
    var phi_2106_: bool;
    var phi_2110_: type_47;
    var phi_1032_: type_47;
    var phi_1033_: type_47;
    var phi_1034_: type_47;

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
                                    phi_1032_ = type_47(type_33(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
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
                                        phi_272_ = _e110;
                                    } else {
                                        phi_272_ = array<u32, 3>(0u, 0u, 0u);
                                    }
                                    let _e112 = phi_272_;
                                    let _e114 = (_e112[0] < _e55);
                                    if _e114 {
                                        if _e114 {
                                        } else {
                                            break;
                                        }
                                        let _e116 = global_3.member[_e112[0]];
                                        phi_287_ = _e116;
                                    } else {
                                        phi_287_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e118 = phi_287_;
                                    let _e123 = (_e112[1] < _e55);
                                    if _e123 {
                                        if _e123 {
                                        } else {
                                            break;
                                        }
                                        let _e125 = global_3.member[_e112[1]];
                                        phi_305_ = _e125;
                                    } else {
                                        phi_305_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e127 = phi_305_;
                                    let _e132 = (_e112[2] < _e55);
                                    if _e132 {
                                        if _e132 {
                                        } else {
                                            break;
                                        }
                                        let _e134 = global_3.member[_e112[2]];
                                        phi_323_ = _e134;
                                    } else {
                                        phi_323_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e136 = phi_323_;
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
                                        phi_410_ = _e178;
                                    } else {
                                        phi_410_ = array<u32, 3>(0u, 0u, 0u);
                                    }
                                    let _e180 = phi_410_;
                                    let _e182 = (_e180[0] < _e60);
                                    if _e182 {
                                        if _e182 {
                                        } else {
                                            break;
                                        }
                                        let _e185 = global_5.member[_e180[0]];
                                        phi_427_ = vec3<f32>(_e185[0], _e185[1], _e185[2]);
                                    } else {
                                        phi_427_ = vec3<f32>(0f, 0f, 0f);
                                    }
                                    let _e191 = phi_427_;
                                    let _e193 = (_e180[1] < _e60);
                                    if _e193 {
                                        if _e193 {
                                        } else {
                                            break;
                                        }
                                        let _e196 = global_5.member[_e180[1]];
                                        phi_444_ = vec3<f32>(_e196[0], _e196[1], _e196[2]);
                                    } else {
                                        phi_444_ = vec3<f32>(0f, 0f, 0f);
                                    }
                                    let _e202 = phi_444_;
                                    let _e204 = (_e180[2] < _e60);
                                    if _e204 {
                                        if _e204 {
                                        } else {
                                            break;
                                        }
                                        let _e207 = global_5.member[_e180[2]];
                                        phi_461_ = vec3<f32>(_e207[0], _e207[1], _e207[2]);
                                    } else {
                                        phi_461_ = vec3<f32>(0f, 0f, 0f);
                                    }
                                    let _e213 = phi_461_;
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
                                        phi_645_ = vec3<f32>(0f, 0f, 0f);
                                    } else {
                                        let _e310 = (bitcast<u32>(_e307) & 2147483647u);
                                        let _e311 = (_e310 >= 8388608u);
                                        if _e311 {
                                            phi_595_ = (bitcast<i32>((_e310 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_595_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e310)), 32u, (_e310 == 0u))));
                                        }
                                        let _e324 = phi_595_;
                                        let _e331 = bitcast<f32>((bitcast<u32>(((_e324 / -2i) + 127i)) << bitcast<u32>(23i)));
                                        if _e311 {
                                            phi_626_ = (bitcast<i32>((_e310 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_626_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e310)), 32u, (_e310 == 0u))));
                                        }
                                        let _e347 = phi_626_;
                                        let _e353 = bitcast<f32>((bitcast<u32>((((_e324 / 2i) - _e347) + 127i)) << bitcast<u32>(23i)));
                                        let _e354 = ((_e288 * _e331) * _e353);
                                        let _e355 = ((_e291 * _e331) * _e353);
                                        let _e356 = ((_e294 * _e331) * _e353);
                                        let _e362 = sqrt((((_e354 * _e354) + (_e355 * _e355)) + (_e356 * _e356)));
                                        phi_645_ = vec3<f32>((_e354 / _e362), (_e355 / _e362), (_e356 / _e362));
                                    }
                                    let _e368 = phi_645_;
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
                                        phi_778_ = vec3<f32>(0f, 0f, 0f);
                                    } else {
                                        let _e422 = (bitcast<u32>(_e419) & 2147483647u);
                                        let _e423 = (_e422 >= 8388608u);
                                        if _e423 {
                                            phi_728_ = (bitcast<i32>((_e422 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_728_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e422)), 32u, (_e422 == 0u))));
                                        }
                                        let _e436 = phi_728_;
                                        let _e443 = bitcast<f32>((bitcast<u32>(((_e436 / -2i) + 127i)) << bitcast<u32>(23i)));
                                        if _e423 {
                                            phi_759_ = (bitcast<i32>((_e422 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_759_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e422)), 32u, (_e422 == 0u))));
                                        }
                                        let _e459 = phi_759_;
                                        let _e465 = bitcast<f32>((bitcast<u32>((((_e436 / 2i) - _e459) + 127i)) << bitcast<u32>(23i)));
                                        let _e466 = ((_e404 * _e443) * _e465);
                                        let _e467 = ((_e405 * _e443) * _e465);
                                        let _e468 = ((_e406 * _e443) * _e465);
                                        let _e474 = sqrt((((_e466 * _e466) + (_e467 * _e467)) + (_e468 * _e468)));
                                        phi_778_ = vec3<f32>((_e466 / _e474), (_e467 / _e474), (_e468 / _e474));
                                    }
                                    let _e480 = phi_778_;
                                    let _e495 = select(_e382, (_e480 * _e378), vec3((((((_e480.x * _e378) * (_e368.x * _e378)) + ((_e480.y * _e378) * (_e368.y * _e378))) + ((_e480.z * _e378) * (_e368.z * _e378))) > 0f)));
                                    let _e496 = (_e83.member_3 < arrayLength((&global_6.member)));
                                    if _e496 {
                                        if _e496 {
                                        } else {
                                            break;
                                        }
                                        let _e499 = global_6.member[_e83.member_3];
                                        phi_820_ = _e499;
                                    } else {
                                        phi_820_ = 0u;
                                    }
                                    let _e501 = phi_820_;
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
                                        phi_931_ = type_7(0u, 3u);
                                        loop {
                                            let _e570 = phi_931_;
                                            if (_e570.member < _e570.member_1) {
                                                phi_932_ = type_7((_e570.member + 1u), _e570.member_1);
                                                phi_955_ = type_7(1u, _e570.member);
                                            } else {
                                                phi_932_ = _e570;
                                                phi_955_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e583 = phi_932_;
                                            let _e585 = phi_955_;
                                            let _e589 = (bitcast<i32>(_e585.member) != 0i);
                                            if _e589 {
                                                let _e590 = (_e585.member_1 < 3u);
                                                if _e590 {
                                                } else {
                                                    phi_2389_ = true;
                                                    break;
                                                }
                                                let _e593 = local_1.member_2[_e585.member_1];
                                                let _e597 = ((((_e593 * _e101) * _e107) * _e101) * _e107);
                                                if _e590 {
                                                } else {
                                                    phi_2389_ = true;
                                                    break;
                                                }
                                                local.member_2[_e585.member_1] = select(340282350000000000000000000000000000000f, _e597, (_e597 < 340282350000000000000000000000000000000f));
                                            }
                                            continue;
                                            continuing {
                                                phi_931_ = _e583;
                                                phi_2389_ = false;
                                                break if !(_e589);
                                            }
                                        }
                                        let _e604 = phi_2389_;
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
                                        phi_1757_ = (_e622 - vec3<f32>(_e143, _e147, _e151));
                                    } else {
                                        phi_1757_ = _e622;
                                    }
                                    let _e629 = phi_1757_;
                                    let _e631 = bitcast<f32>(bitcast<u32>(_e292));
                                    let _e634 = bitcast<f32>(bitcast<u32>((_e281 * _e283)));
                                    let _e636 = bitcast<f32>(bitcast<u32>(_e286));
                                    let _e639 = bitcast<f32>(bitcast<u32>((_e282 * _e284)));
                                    let _e641 = bitcast<f32>(bitcast<u32>(_e289));
                                    let _e644 = bitcast<f32>(bitcast<u32>((_e280 * _e285)));
                                    let _e708 = global_11[0u];
                                    if (_e614.member_2[0] == _e708) {
                                        let _e711 = global_11[1u];
                                        let _e712 = (_e614.member_2[1] == _e711);
                                        if _e712 {
                                            let _e714 = global_11[2u];
                                            phi_1958_ = (_e614.member_2[2] == _e714);
                                        } else {
                                            phi_1958_ = bool();
                                        }
                                        let _e717 = phi_1958_;
                                        phi_1961_ = _e717;
                                        phi_1962_ = select(true, false, _e712);
                                    } else {
                                        phi_1961_ = bool();
                                        phi_1962_ = true;
                                    }
                                    let _e720 = phi_1961_;
                                    let _e722 = phi_1962_;
                                    if select(_e720, false, _e722) {
                                        phi_2105_ = type_47();
                                        phi_2106_ = true;
                                    } else {
                                        let _e725 = ((((bitcast<f32>(bitcast<u32>((_e629.x * (_e636 - _e639)))) + bitcast<f32>(bitcast<u32>((_e629.y * (_e641 - _e644))))) + bitcast<f32>(bitcast<u32>((_e629.z * (_e631 - _e634))))) * _e378) > (bitcast<f32>(bitcast<u32>((0.0000009536752f * ((bitcast<f32>(bitcast<u32>((bitcast<f32>((bitcast<u32>(_e629.x) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e636) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e639) & 2147483647u)))))) + bitcast<f32>(bitcast<u32>((bitcast<f32>((bitcast<u32>(_e629.y) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e641) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e644) & 2147483647u))))))) + bitcast<f32>(bitcast<u32>((bitcast<f32>((bitcast<u32>(_e629.z) & 2147483647u)) * (bitcast<f32>((bitcast<u32>(_e631) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e634) & 2147483647u)))))))))) + 0.0000000000000000000000000000000000001880791f));
                                        if _e725 {
                                            let _e727 = select(_e278, _e277, (_e277 > _e278));
                                            let _e744 = (select(_e279, _e727, (_e727 > _e279)) * ((bitcast<f32>((bitcast<u32>(_e382.x) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e382.y) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e382.z) & 2147483647u))));
                                            let _e748 = (((_e229 + _e232) + _e235) + (_e382.x * _e744));
                                            let _e749 = (((_e230 + _e233) + _e236) + (_e382.y * _e744));
                                            let _e750 = (((_e231 + _e234) + _e237) + (_e382.z * _e744));
                                            if (_e382.x > 0f) {
                                                let _e771 = bitcast<u32>(_e748);
                                                if ((_e771 & 2147483647u) == 0u) {
                                                    phi_2213_ = 0.000000000000000000000000000000000000000000001f;
                                                } else {
                                                    if ((_e771 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_2209_ = bitcast<f32>((_e771 + 1u));
                                                    } else {
                                                        phi_2209_ = bitcast<f32>((_e771 - 1u));
                                                    }
                                                    let _e782 = phi_2209_;
                                                    phi_2213_ = _e782;
                                                }
                                                let _e784 = phi_2213_;
                                                phi_2215_ = _e784;
                                            } else {
                                                if (_e382.x < 0f) {
                                                    let _e754 = bitcast<u32>(-(_e748));
                                                    if ((_e754 & 2147483647u) == 0u) {
                                                        phi_2191_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e754 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_2187_ = bitcast<f32>((_e754 + 1u));
                                                        } else {
                                                            phi_2187_ = bitcast<f32>((_e754 - 1u));
                                                        }
                                                        let _e765 = phi_2187_;
                                                        phi_2191_ = _e765;
                                                    }
                                                    let _e767 = phi_2191_;
                                                    phi_2194_ = -(_e767);
                                                } else {
                                                    phi_2194_ = _e748;
                                                }
                                                let _e770 = phi_2194_;
                                                phi_2215_ = _e770;
                                            }
                                            let _e786 = phi_2215_;
                                            if (_e382.y > 0f) {
                                                let _e807 = bitcast<u32>(_e749);
                                                if ((_e807 & 2147483647u) == 0u) {
                                                    phi_2264_ = 0.000000000000000000000000000000000000000000001f;
                                                } else {
                                                    if ((_e807 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_2260_ = bitcast<f32>((_e807 + 1u));
                                                    } else {
                                                        phi_2260_ = bitcast<f32>((_e807 - 1u));
                                                    }
                                                    let _e818 = phi_2260_;
                                                    phi_2264_ = _e818;
                                                }
                                                let _e820 = phi_2264_;
                                                phi_2266_ = _e820;
                                            } else {
                                                if (_e382.y < 0f) {
                                                    let _e790 = bitcast<u32>(-(_e749));
                                                    if ((_e790 & 2147483647u) == 0u) {
                                                        phi_2242_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e790 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_2238_ = bitcast<f32>((_e790 + 1u));
                                                        } else {
                                                            phi_2238_ = bitcast<f32>((_e790 - 1u));
                                                        }
                                                        let _e801 = phi_2238_;
                                                        phi_2242_ = _e801;
                                                    }
                                                    let _e803 = phi_2242_;
                                                    phi_2245_ = -(_e803);
                                                } else {
                                                    phi_2245_ = _e749;
                                                }
                                                let _e806 = phi_2245_;
                                                phi_2266_ = _e806;
                                            }
                                            let _e822 = phi_2266_;
                                            if (_e382.z > 0f) {
                                                let _e843 = bitcast<u32>(_e750);
                                                if ((_e843 & 2147483647u) == 0u) {
                                                    phi_2315_ = 0.000000000000000000000000000000000000000000001f;
                                                } else {
                                                    if ((_e843 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_2311_ = bitcast<f32>((_e843 + 1u));
                                                    } else {
                                                        phi_2311_ = bitcast<f32>((_e843 - 1u));
                                                    }
                                                    let _e854 = phi_2311_;
                                                    phi_2315_ = _e854;
                                                }
                                                let _e856 = phi_2315_;
                                                phi_2317_ = _e856;
                                            } else {
                                                if (_e382.z < 0f) {
                                                    let _e826 = bitcast<u32>(-(_e750));
                                                    if ((_e826 & 2147483647u) == 0u) {
                                                        phi_2293_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e826 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_2289_ = bitcast<f32>((_e826 + 1u));
                                                        } else {
                                                            phi_2289_ = bitcast<f32>((_e826 - 1u));
                                                        }
                                                        let _e837 = phi_2289_;
                                                        phi_2293_ = _e837;
                                                    }
                                                    let _e839 = phi_2293_;
                                                    phi_2296_ = -(_e839);
                                                } else {
                                                    phi_2296_ = _e750;
                                                }
                                                let _e842 = phi_2296_;
                                                phi_2317_ = _e842;
                                            }
                                            let _e858 = phi_2317_;
                                            if _e626 {
                                                phi_1983_ = (_e622 - vec3<f32>(_e786, _e822, _e858));
                                            } else {
                                                phi_1983_ = _e622;
                                            }
                                            let _e862 = phi_1983_;
                                            let _e871 = sqrt((((_e862.x * _e862.x) + (_e862.y * _e862.y)) + (_e862.z * _e862.z)));
                                            let _e880 = ((((_e495.x * _e862.x) + (_e495.y * _e862.y)) + (_e495.z * _e862.z)) / _e871);
                                            if _e626 {
                                                let _e887 = (_e871 <= _e614.member_3);
                                                if _e626 {
                                                    phi_2031_ = (1f / (_e871 * _e871));
                                                } else {
                                                    phi_2031_ = 1f;
                                                }
                                                let _e891 = phi_2031_;
                                                let _e892 = (_e880 > 0f);
                                                if _e892 {
                                                    phi_2042_ = select(true, false, _e887);
                                                } else {
                                                    phi_2042_ = false;
                                                }
                                                let _e895 = phi_2042_;
                                                phi_2044_ = _e891;
                                                phi_2045_ = select(false, _e887, _e892);
                                                phi_2046_ = select(true, false, _e892);
                                                phi_2047_ = _e895;
                                            } else {
                                                if _e626 {
                                                    phi_2016_ = (1f / (_e871 * _e871));
                                                } else {
                                                    phi_2016_ = 1f;
                                                }
                                                let _e884 = phi_2016_;
                                                let _e885 = (_e880 > 0f);
                                                phi_2044_ = _e884;
                                                phi_2045_ = _e885;
                                                phi_2046_ = select(true, false, _e885);
                                                phi_2047_ = false;
                                            }
                                            let _e899 = phi_2044_;
                                            let _e901 = phi_2045_;
                                            let _e903 = phi_2046_;
                                            let _e905 = phi_2047_;
                                            if _e901 {
                                                let _e910 = ((1f - _e507.member_1) * 0.31830987f);
                                                let _e917 = (_e880 * _e899);
                                                phi_2089_ = type_47(type_33(array<f32, 3>(_e786, _e822, _e858), 0f, array<f32, 3>(_e862.x, _e862.y, _e862.z), select(340282350000000000000000000000000000000f, 1f, _e626)), array<f32, 3>(((_e614.member_2[0] * (_e507.member[0] * _e910)) * _e917), ((_e614.member_2[1] * (_e507.member[1] * _e910)) * _e917), ((_e614.member_2[2] * (_e507.member[2] * _e910)) * _e917)), _e83.member_3);
                                            } else {
                                                phi_2089_ = type_47();
                                            }
                                            let _e928 = phi_2089_;
                                            if select(select(_e905, false, _e901), true, select(_e903, false, _e901)) {
                                                phi_2099_ = type_47(type_33(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                                            } else {
                                                phi_2099_ = _e928;
                                            }
                                            let _e933 = phi_2099_;
                                            phi_2101_ = _e933;
                                        } else {
                                            phi_2101_ = type_47();
                                        }
                                        let _e935 = phi_2101_;
                                        phi_2105_ = _e935;
                                        phi_2106_ = select(true, false, _e725);
                                    }
                                    let _e938 = phi_2105_;
                                    let _e940 = phi_2106_;
                                    if _e940 {
                                        phi_2110_ = type_47(type_33(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                                    } else {
                                        phi_2110_ = _e938;
                                    }
                                    let _e942 = phi_2110_;
                                    phi_1032_ = _e942;
                                }
                                let _e944 = phi_1032_;
                                phi_1033_ = _e944;
                            } else {
                                phi_1033_ = type_47(type_33(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                            }
                            let _e946 = phi_1033_;
                            phi_1034_ = _e946;
                        } else {
                            phi_1034_ = type_47(type_33(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), array<f32, 3>(0f, 0f, 0f), 4294967295u);
                        }
                        let _e948 = phi_1034_;
                        if _e77 {
                        } else {
                            break;
                        }
                        global_10.member[_e74] = _e948;
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
