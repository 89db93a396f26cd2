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
    var phi_228_: i32;
    var phi_252_: type_39;
    var phi_302_: type_11;
    var phi_303_: type_11;
    var phi_326_: type_11;
    var phi_1373_: bool;
    var phi_380_: i32;
    var phi_413_: type_11;
    var phi_414_: type_11;
    var phi_437_: type_11;
    var phi_1380_: bool;
    var phi_572_: i32;
    var phi_598_: u32;
    var phi_615_: i32;
    var phi_628_: bool;
    var phi_645_: array<u32, 3>;
    var phi_660_: array<f32, 3>;
    var phi_678_: array<f32, 3>;
    var phi_696_: array<f32, 3>;
    var phi_800_: vec3<f32>;
    var phi_986_: f32;
    var phi_1028_: type_11;
    var phi_1031_: bool;
    var phi_1029_: type_11;
    var phi_1054_: type_11;
    var phi_1209_: bool;
    var phi_1211_: bool;
    var phi_1212_: bool;
    var phi_1032_: bool;
    var phi_1386_: bool;
    var local_3: bool;
    var phi_1429_: bool;
    var phi_1226_: bool;
    var phi_1428_: bool;
    var phi_1227_: bool;
    var phi_1427_: bool;
    var phi_1229_: u32;
    var phi_1426_: bool;
    var phi_1230_: u32;
    var phi_1250_: type_11;
    var phi_1253_: u32;
    var phi_1251_: type_11;
    var phi_1276_: type_11;
    var phi_1254_: u32;
    var phi_1422_: bool;
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
                    let _e121 = (_e120 < -126i);
                    if _e121 {
                        phi_228_ = -126i;
                    } else {
                        phi_228_ = select(_e120, 127i, (_e120 > 127i));
                    }
                    let _e125 = phi_228_;
                    let _e130 = bitcast<f32>((bitcast<u32>((_e125 + 127i)) << bitcast<u32>(23i)));
                    let _e136 = bitcast<f32>((bitcast<u32>(((_e120 - _e125) + 127i)) << bitcast<u32>(23i)));
                    if (_e96 == 0u) {
                        phi_252_ = type_39(array<f32, 3>(_e113, _e114, _e115), _e96, _e117, _e118);
                    } else {
                        phi_252_ = type_39(array<f32, 3>(((_e113 * _e130) * _e136), ((_e114 * _e130) * _e136), ((_e115 * _e130) * _e136)), _e96, ((_e117 * _e130) * _e136), _e118);
                    }
                    let _e149 = phi_252_;
                    let _e153 = global_5.member[0u][0u];
                    let _e157 = global_5.member[0u][1u];
                    let _e161 = global_5.member[0u][2u];
                    let _e165 = global_5.member[0u][3u];
                    local_2.member = array<f32, 3>(bitcast<f32>(_e153), bitcast<f32>(_e157), bitcast<f32>(_e161));
                    local_2.member_1 = _e165;
                    local_2.member_2 = array<array<f32, 4>, 4>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f));
                    phi_302_ = type_11(0u, 4u);
                    loop {
                        let _e174 = phi_302_;
                        if (_e174.member < _e174.member_1) {
                            phi_303_ = type_11((_e174.member + 1u), _e174.member_1);
                            phi_326_ = type_11(1u, _e174.member);
                        } else {
                            phi_303_ = _e174;
                            phi_326_ = type_11(0u, type_11().member_1);
                        }
                        let _e187 = phi_303_;
                        let _e189 = phi_326_;
                        let _e193 = (bitcast<i32>(_e189.member) != 0i);
                        if _e193 {
                            let _e194 = (_e189.member_1 + 1u);
                            if (_e194 < 5u) {
                            } else {
                                phi_1373_ = true;
                                break;
                            }
                            let _e199 = global_5.member[_e194][0u];
                            let _e203 = global_5.member[_e194][1u];
                            let _e207 = global_5.member[_e194][2u];
                            let _e211 = global_5.member[_e194][3u];
                            if (_e189.member_1 < 4u) {
                            } else {
                                phi_1373_ = true;
                                break;
                            }
                            local_2.member_2[_e189.member_1][0u] = bitcast<f32>(_e199);
                            local_2.member_2[_e189.member_1][1u] = bitcast<f32>(_e203);
                            local_2.member_2[_e189.member_1][2u] = bitcast<f32>(_e207);
                            local_2.member_2[_e189.member_1][3u] = bitcast<f32>(_e211);
                        }
                        continue;
                        continuing {
                            phi_302_ = _e187;
                            phi_1373_ = false;
                            break if !(_e193);
                        }
                    }
                    let _e231 = phi_1373_;
                    if _e231 {
                        break;
                    }
                    if _e121 {
                        phi_380_ = -126i;
                    } else {
                        phi_380_ = select(_e120, 127i, (_e120 > 127i));
                    }
                    let _e235 = phi_380_;
                    let _e240 = bitcast<f32>((bitcast<u32>((_e235 + 127i)) << bitcast<u32>(23i)));
                    let _e246 = bitcast<f32>((bitcast<u32>(((_e120 - _e235) + 127i)) << bitcast<u32>(23i)));
                    let _e247 = local_2;
                    local_1 = _e247;
                    let _e248 = local_2.member;
                    local_1.member = array<f32, 3>(((_e248[0] * _e240) * _e246), ((_e248[1] * _e240) * _e246), ((_e248[2] * _e240) * _e246));
                    phi_413_ = type_11(0u, 4u);
                    loop {
                        let _e261 = phi_413_;
                        if (_e261.member < _e261.member_1) {
                            phi_414_ = type_11((_e261.member + 1u), _e261.member_1);
                            phi_437_ = type_11(1u, _e261.member);
                        } else {
                            phi_414_ = _e261;
                            phi_437_ = type_11(0u, type_11().member_1);
                        }
                        let _e274 = phi_414_;
                        let _e276 = phi_437_;
                        let _e280 = (bitcast<i32>(_e276.member) != 0i);
                        if _e280 {
                            let _e281 = (_e276.member_1 < 4u);
                            if _e281 {
                            } else {
                                phi_1380_ = true;
                                break;
                            }
                            let _e285 = local_2.member_2[_e276.member_1][3u];
                            if _e281 {
                            } else {
                                phi_1380_ = true;
                                break;
                            }
                            local_1.member_2[_e276.member_1][3u] = ((_e285 * _e240) * _e246);
                        }
                        continue;
                        continuing {
                            phi_413_ = _e274;
                            phi_1380_ = _e231;
                            break if !(_e280);
                        }
                    }
                    let _e293 = phi_1380_;
                    if _e293 {
                        break;
                    }
                    let _e294 = local_1;
                    local = _e294.member_2;
                    if _e121 {
                        phi_572_ = -126i;
                    } else {
                        phi_572_ = select(_e120, 127i, (_e120 > 127i));
                    }
                    let _e306 = phi_572_;
                    let _e311 = bitcast<f32>((bitcast<u32>((_e306 + 127i)) << bitcast<u32>(23i)));
                    let _e317 = bitcast<f32>((bitcast<u32>(((_e120 - _e306) + 127i)) << bitcast<u32>(23i)));
                    let _e318 = (_e72 < arrayLength((&global_9.member)));
                    if _e318 {
                        if _e318 {
                        } else {
                            break;
                        }
                        let _e320 = global_9.member[_e72];
                        phi_598_ = _e320;
                    } else {
                        phi_598_ = 4294967295u;
                    }
                    let _e322 = phi_598_;
                    let _e323 = (_e322 < arrayLength((&global_10.member)));
                    if _e323 {
                        if _e323 {
                        } else {
                            break;
                        }
                        let _e325 = global_10.member[_e322];
                        phi_615_ = _e325;
                    } else {
                        phi_615_ = 0i;
                    }
                    let _e327 = phi_615_;
                    let _e328 = (_e327 == 0i);
                    if _e328 {
                        phi_628_ = select(true, false, (_e294.member_1 == 0u));
                    } else {
                        phi_628_ = true;
                    }
                    let _e332 = phi_628_;
                    if _e332 {
                        if _e77 {
                            if _e77 {
                            } else {
                                break;
                            }
                            let _e334 = global_8.member[_e72];
                            phi_645_ = _e334;
                        } else {
                            phi_645_ = array<u32, 3>(0u, 0u, 0u);
                        }
                        let _e336 = phi_645_;
                        let _e338 = (_e336[0] < _e57);
                        if _e338 {
                            if _e338 {
                            } else {
                                break;
                            }
                            let _e340 = global_7.member[_e336[0]];
                            phi_660_ = _e340;
                        } else {
                            phi_660_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e342 = phi_660_;
                        let _e347 = (_e336[1] < _e57);
                        if _e347 {
                            if _e347 {
                            } else {
                                break;
                            }
                            let _e349 = global_7.member[_e336[1]];
                            phi_678_ = _e349;
                        } else {
                            phi_678_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e351 = phi_678_;
                        let _e356 = (_e336[2] < _e57);
                        if _e356 {
                            if _e356 {
                            } else {
                                break;
                            }
                            let _e358 = global_7.member[_e336[2]];
                            phi_696_ = _e358;
                        } else {
                            phi_696_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e360 = phi_696_;
                        let _e365 = ((_e342[0] * _e311) * _e317);
                        let _e367 = select(_e365, 0f, (_e365 == 0f));
                        let _e369 = ((_e342[1] * _e311) * _e317);
                        let _e371 = select(_e369, 0f, (_e369 == 0f));
                        let _e373 = ((_e342[2] * _e311) * _e317);
                        let _e375 = select(_e373, 0f, (_e373 == 0f));
                        let _e377 = ((_e351[0] * _e311) * _e317);
                        let _e379 = select(_e377, 0f, (_e377 == 0f));
                        let _e381 = ((_e351[1] * _e311) * _e317);
                        let _e383 = select(_e381, 0f, (_e381 == 0f));
                        let _e385 = ((_e351[2] * _e311) * _e317);
                        let _e387 = select(_e385, 0f, (_e385 == 0f));
                        let _e389 = ((_e360[0] * _e311) * _e317);
                        let _e391 = select(_e389, 0f, (_e389 == 0f));
                        let _e393 = ((_e360[1] * _e311) * _e317);
                        let _e395 = select(_e393, 0f, (_e393 == 0f));
                        let _e397 = ((_e360[2] * _e311) * _e317);
                        let _e399 = select(_e397, 0f, (_e397 == 0f));
                        let _e400 = (_e379 - _e367);
                        let _e401 = (_e383 - _e371);
                        let _e402 = (_e387 - _e375);
                        let _e403 = (_e391 - _e367);
                        let _e404 = (_e395 - _e371);
                        let _e405 = (_e399 - _e375);
                        if (_e149.member_1 == 1u) {
                            phi_800_ = vec3<f32>((_e149.member[0] - _e367), (_e149.member[1] - _e371), (_e149.member[2] - _e375));
                        } else {
                            phi_800_ = vec3<f32>(_e149.member[0], _e149.member[1], _e149.member[2]);
                        }
                        let _e419 = phi_800_;
                        let _e423 = bitcast<f32>((bitcast<u32>((_e400 * _e404)) ^ _e149.member_3[0]));
                        let _e427 = bitcast<f32>((bitcast<u32>((_e401 * _e403)) ^ _e149.member_3[0]));
                        let _e431 = bitcast<f32>((bitcast<u32>((_e401 * _e405)) ^ _e149.member_3[0]));
                        let _e435 = bitcast<f32>((bitcast<u32>((_e402 * _e404)) ^ _e149.member_3[0]));
                        let _e439 = bitcast<f32>((bitcast<u32>((_e402 * _e403)) ^ _e149.member_3[0]));
                        let _e443 = bitcast<f32>((bitcast<u32>((_e400 * _e405)) ^ _e149.member_3[0]));
                        let _e444 = (_e431 - _e435);
                        let _e445 = (_e439 - _e443);
                        let _e446 = (_e423 - _e427);
                        let _e470 = (bitcast<f32>((bitcast<u32>(_e431) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e435) & 2147483647u)));
                        let _e477 = (bitcast<f32>((bitcast<u32>(_e439) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e443) & 2147483647u)));
                        let _e484 = (bitcast<f32>((bitcast<u32>(_e423) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e427) & 2147483647u)));
                        if (_e149.member_2 == 0f) {
                            phi_986_ = 0f;
                        } else {
                            let _e513 = bitcast<f32>((bitcast<u32>(_e444) & 2147483647u));
                            let _e516 = bitcast<f32>((bitcast<u32>(_e445) & 2147483647u));
                            let _e519 = bitcast<f32>((bitcast<u32>(_e446) & 2147483647u));
                            let _e521 = select(_e519, _e516, (_e516 > _e519));
                            let _e525 = select(_e519, _e516, (_e516 < _e519));
                            let _e529 = select(_e516, _e513, (_e513 < _e516));
                            let _e531 = select(_e516, _e513, (_e513 > _e516));
                            let _e533 = select(_e519, _e531, (_e531 < _e519));
                            phi_986_ = bitcast<f32>((bitcast<u32>((_e149.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e521, _e513, (_e513 > _e521)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e533, _e529, (_e529 > _e533)))) ^ _e149.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e525, _e513, (_e513 < _e525)))) ^ _e149.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e470 + _e477) + _e484))) ^ _e149.member_3[0]))) * 1.0000005f)) ^ _e149.member_3[0])))) ^ _e149.member_3[0]));
                        }
                        let _e560 = phi_986_;
                        if (_e328 || !(((((bitcast<f32>((bitcast<u32>((_e419.x * _e444)) ^ _e149.member_3[0])) + bitcast<f32>((bitcast<u32>((_e419.y * _e445)) ^ _e149.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e419.z * _e446)) ^ _e149.member_3[0]))) * f32(-(_e327))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e419.x) & 2147483647u)) * _e470)) ^ _e149.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e419.y) & 2147483647u)) * _e477)) ^ _e149.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e419.z) & 2147483647u)) * _e484)) ^ _e149.member_3[0]))))) ^ _e149.member_3[0])) + _e560) + 0.0000000000000000000000000000000000001880791f)))) {
                            let _e576 = (_e367 - _e294.member[0]);
                            let _e577 = (_e371 - _e294.member[1]);
                            let _e578 = (_e375 - _e294.member[2]);
                            let _e579 = (_e379 - _e294.member[0]);
                            let _e580 = (_e383 - _e294.member[1]);
                            let _e581 = (_e387 - _e294.member[2]);
                            let _e582 = (_e391 - _e294.member[0]);
                            let _e583 = (_e395 - _e294.member[1]);
                            let _e584 = (_e399 - _e294.member[2]);
                            phi_1028_ = type_11(0u, 4u);
                            phi_1031_ = false;
                            loop {
                                let _e586 = phi_1028_;
                                let _e588 = phi_1031_;
                                local_3 = _e588;
                                if (_e586.member < _e586.member_1) {
                                    phi_1029_ = type_11((_e586.member + 1u), _e586.member_1);
                                    phi_1054_ = type_11(1u, _e586.member);
                                } else {
                                    phi_1029_ = _e586;
                                    phi_1054_ = type_11(0u, type_11().member_1);
                                }
                                let _e601 = phi_1029_;
                                let _e603 = phi_1054_;
                                let _e607 = (bitcast<i32>(_e603.member) != 0i);
                                if _e607 {
                                    let _e608 = (_e603.member_1 < 4u);
                                    if _e608 {
                                    } else {
                                        phi_1386_ = true;
                                        break;
                                    }
                                    let _e610 = local[_e603.member_1];
                                    if (((((_e610[0] * _e576) + (_e610[1] * _e577)) + (_e610[2] * _e578)) + _e610[3]) < (-0.0000000000000000000000000000000000001880791f - (0.000003814712f * (((bitcast<f32>((bitcast<u32>(_e576) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e577) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e578) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e610[3]) & 2147483647u)))))) {
                                        if _e608 {
                                        } else {
                                            phi_1386_ = true;
                                            break;
                                        }
                                        let _e639 = local[_e603.member_1];
                                        let _e667 = (((((_e639[0] * _e579) + (_e639[1] * _e580)) + (_e639[2] * _e581)) + _e639[3]) < (-0.0000000000000000000000000000000000001880791f - (0.000003814712f * (((bitcast<f32>((bitcast<u32>(_e579) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e580) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e581) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e639[3]) & 2147483647u))))));
                                        if _e667 {
                                            if _e608 {
                                            } else {
                                                phi_1386_ = true;
                                                break;
                                            }
                                            let _e668 = local[_e603.member_1];
                                            phi_1209_ = (((((_e668[0] * _e582) + (_e668[1] * _e583)) + (_e668[2] * _e584)) + _e668[3]) < (-0.0000000000000000000000000000000000001880791f - (0.000003814712f * (((bitcast<f32>((bitcast<u32>(_e582) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e583) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e584) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e668[3]) & 2147483647u))))));
                                        } else {
                                            phi_1209_ = bool();
                                        }
                                        let _e698 = phi_1209_;
                                        phi_1211_ = _e698;
                                        phi_1212_ = select(true, false, _e667);
                                    } else {
                                        phi_1211_ = bool();
                                        phi_1212_ = true;
                                    }
                                    let _e701 = phi_1211_;
                                    let _e703 = phi_1212_;
                                    phi_1032_ = (_e588 || select(_e701, false, _e703));
                                } else {
                                    phi_1032_ = bool();
                                }
                                let _e707 = phi_1032_;
                                continue;
                                continuing {
                                    phi_1028_ = _e601;
                                    phi_1031_ = _e707;
                                    phi_1386_ = _e293;
                                    break if !(_e607);
                                }
                            }
                            let _e710 = phi_1386_;
                            if _e710 {
                                break;
                            }
                            let _e713 = local_3;
                            phi_1429_ = _e710;
                            phi_1226_ = !(select(false, _e713, (_e294.member_1 == 1u)));
                        } else {
                            phi_1429_ = _e293;
                            phi_1226_ = false;
                        }
                        let _e717 = phi_1429_;
                        let _e719 = phi_1226_;
                        phi_1428_ = _e717;
                        phi_1227_ = _e719;
                    } else {
                        phi_1428_ = _e293;
                        phi_1227_ = true;
                    }
                    let _e721 = phi_1428_;
                    let _e723 = phi_1227_;
                    phi_1427_ = _e721;
                    phi_1229_ = select(0u, 1u, _e723);
                } else {
                    phi_1427_ = false;
                    phi_1229_ = 0u;
                }
                let _e726 = phi_1427_;
                let _e728 = phi_1229_;
                phi_1426_ = _e726;
                phi_1230_ = _e728;
            } else {
                phi_1426_ = false;
                phi_1230_ = 0u;
            }
            let _e730 = phi_1426_;
            let _e732 = phi_1230_;
            let _e733 = (_e54 % 64u);
            if (_e733 < 64u) {
            } else {
                break;
            }
            global_4[_e733] = _e732;
            workgroupBarrier();
            let _e736 = (_e72 / 32u);
            if ((_e54 & 31u) == 0u) {
                let _e739 = (_e736 < arrayLength((&global_11.member)));
                if _e739 {
                    phi_1250_ = type_11(0u, 32u);
                    phi_1253_ = 0u;
                    loop {
                        let _e741 = phi_1250_;
                        let _e743 = phi_1253_;
                        local_4 = _e743;
                        if (_e741.member < _e741.member_1) {
                            phi_1251_ = type_11((_e741.member + 1u), _e741.member_1);
                            phi_1276_ = type_11(1u, _e741.member);
                        } else {
                            phi_1251_ = _e741;
                            phi_1276_ = type_11(0u, type_11().member_1);
                        }
                        let _e756 = phi_1251_;
                        let _e758 = phi_1276_;
                        let _e762 = (bitcast<i32>(_e758.member) != 0i);
                        if _e762 {
                            let _e764 = ((_e54 + _e758.member_1) % 64u);
                            if (_e764 < 64u) {
                            } else {
                                phi_1422_ = true;
                                break;
                            }
                            let _e767 = global_4[_e764];
                            phi_1254_ = (_e743 | (_e767 << bitcast<u32>((_e758.member_1 & 31u))));
                        } else {
                            phi_1254_ = u32();
                        }
                        let _e773 = phi_1254_;
                        continue;
                        continuing {
                            phi_1250_ = _e756;
                            phi_1253_ = _e773;
                            phi_1422_ = _e730;
                            break if !(_e762);
                        }
                    }
                    let _e776 = phi_1422_;
                    if _e776 {
                        break;
                    }
                    if _e739 {
                    } else {
                        break;
                    }
                    let _e780 = local_4;
                    global_11.member[_e736] = _e780;
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
