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

struct type_28 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_30 {
    member: array<type_28>,
}

struct type_32 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_33 {
    member: type_32,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_35 {
    member: array<type_33>,
}

struct type_39 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: f32,
    member_3: f32,
    member_4: array<u32, 2>,
}

struct type_41 {
    member: array<type_39>,
}

struct type_44 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 3>,
    member_5: u32,
    member_6: array<f32, 3>,
    member_7: u32,
}

struct type_46 {
    member: array<type_44>,
}

struct type_48 {
    member: vec3<f32>,
    member_1: vec3<f32>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_10;
@group(0) @binding(1) 
var<storage> global_2: type_15;
@group(0) @binding(2) 
var<storage> global_3: type_19;
@group(0) @binding(3) 
var<storage> global_4: type_15;
@group(0) @binding(4) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage> global_6: type_41;
@group(0) @binding(6) 
var<storage> global_7: type_46;
@group(0) @binding(7) 
var<storage> global_8: type_30;
@group(0) @binding(8) 
var<storage, read_write> global_9: type_35;

fn function_() {
    var phi_1526_: i32;
    var phi_1557_: i32;
    var phi_1576_: vec3<f32>;
    var phi_228_: array<u32, 3>;
    var phi_243_: array<f32, 3>;
    var phi_261_: array<f32, 3>;
    var phi_279_: array<f32, 3>;
    var phi_362_: array<u32, 3>;
    var phi_379_: vec3<f32>;
    var phi_396_: vec3<f32>;
    var phi_413_: vec3<f32>;
    var phi_545_: i32;
    var phi_576_: i32;
    var phi_595_: vec3<f32>;
    var phi_678_: i32;
    var phi_709_: i32;
    var phi_728_: vec3<f32>;
    var phi_758_: u32;
    var phi_792_: f32;
    var phi_829_: f32;
    var phi_851_: f32;
    var phi_890_: i32;
    var phi_921_: i32;
    var phi_940_: vec3<f32>;
    var phi_980_: vec3<f32>;
    var phi_1026_: vec3<f32>;
    var phi_1027_: vec3<f32>;
    var phi_1114_: f32;
    var phi_1115_: f32;
    var phi_1117_: f32;
    var phi_1091_: f32;
    var phi_1092_: f32;
    var phi_1118_: f32;
    var phi_1162_: f32;
    var phi_1163_: f32;
    var phi_1165_: f32;
    var phi_1139_: f32;
    var phi_1140_: f32;
    var phi_1166_: f32;
    var phi_1210_: f32;
    var phi_1211_: f32;
    var phi_1213_: f32;
    var phi_1187_: f32;
    var phi_1188_: f32;
    var phi_1214_: f32;
    var phi_1217_: type_48;
    var phi_1219_: type_48;
    var phi_1220_: bool;
    var phi_1295_: f32;
    var phi_1296_: f32;
    var phi_1298_: f32;
    var phi_1272_: f32;
    var phi_1273_: f32;
    var phi_1299_: f32;
    var phi_1343_: f32;
    var phi_1344_: f32;
    var phi_1346_: f32;
    var phi_1320_: f32;
    var phi_1321_: f32;
    var phi_1347_: f32;
    var phi_1391_: f32;
    var phi_1392_: f32;
    var phi_1394_: f32;
    var phi_1368_: f32;
    var phi_1369_: f32;
    var phi_1395_: f32;
    var phi_1438_: vec3<f32>;
    var phi_1440_: type_48;
    var phi_1460_: vec3<f32>;
    var phi_1478_: type_33;
    var phi_1633_: type_33;

    switch bitcast<i32>(0u) {
        default: {
            let _e44 = global;
            let _e47 = arrayLength((&global_2.member));
            let _e52 = arrayLength((&global_4.member));
            let _e56 = arrayLength((&global_6.member));
            let _e58 = arrayLength((&global_7.member));
            let _e66 = (_e44.x + (_e44.y * 2097152u));
            let _e67 = (_e66 < arrayLength((&global_9.member)));
            if _e67 {
                let _e68 = (_e66 < arrayLength((&global_8.member)));
                if _e68 {
                    if (_e56 == 0u) {
                    } else {
                        if (_e58 == 0u) {
                        } else {
                            if _e67 {
                            } else {
                                break;
                            }
                            let _e73 = global_9.member[_e66];
                            if _e68 {
                            } else {
                                break;
                            }
                            let _e76 = global_8.member[_e66];
                            if (_e73.member.member_1 <= _e73.member.member_3) {
                                if (_e76.member_3 != 4294967295u) {
                                    let _e224 = global_1.member[0u];
                                    let _e225 = bitcast<i32>(_e224);
                                    let _e226 = (_e225 / 2i);
                                    let _e231 = bitcast<f32>((bitcast<u32>((_e226 + 127i)) << bitcast<u32>(23i)));
                                    let _e237 = bitcast<f32>((bitcast<u32>(((_e225 - _e226) + 127i)) << bitcast<u32>(23i)));
                                    let _e238 = (_e76.member_3 < arrayLength((&global_3.member)));
                                    if _e238 {
                                        if _e238 {
                                        } else {
                                            break;
                                        }
                                        let _e240 = global_3.member[_e76.member_3];
                                        phi_228_ = _e240;
                                    } else {
                                        phi_228_ = array<u32, 3>(0u, 0u, 0u);
                                    }
                                    let _e242 = phi_228_;
                                    let _e244 = (_e242[0] < _e47);
                                    if _e244 {
                                        if _e244 {
                                        } else {
                                            break;
                                        }
                                        let _e246 = global_2.member[_e242[0]];
                                        phi_243_ = _e246;
                                    } else {
                                        phi_243_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e248 = phi_243_;
                                    let _e253 = (_e242[1] < _e47);
                                    if _e253 {
                                        if _e253 {
                                        } else {
                                            break;
                                        }
                                        let _e255 = global_2.member[_e242[1]];
                                        phi_261_ = _e255;
                                    } else {
                                        phi_261_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e257 = phi_261_;
                                    let _e262 = (_e242[2] < _e47);
                                    if _e262 {
                                        if _e262 {
                                        } else {
                                            break;
                                        }
                                        let _e264 = global_2.member[_e242[2]];
                                        phi_279_ = _e264;
                                    } else {
                                        phi_279_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e266 = phi_279_;
                                    let _e271 = ((_e248[0] * _e231) * _e237);
                                    let _e273 = select(_e271, 0f, (_e271 == 0f));
                                    let _e275 = ((_e248[1] * _e231) * _e237);
                                    let _e277 = select(_e275, 0f, (_e275 == 0f));
                                    let _e279 = ((_e248[2] * _e231) * _e237);
                                    let _e281 = select(_e279, 0f, (_e279 == 0f));
                                    let _e283 = ((_e257[0] * _e231) * _e237);
                                    let _e285 = select(_e283, 0f, (_e283 == 0f));
                                    let _e287 = ((_e257[1] * _e231) * _e237);
                                    let _e289 = select(_e287, 0f, (_e287 == 0f));
                                    let _e291 = ((_e257[2] * _e231) * _e237);
                                    let _e293 = select(_e291, 0f, (_e291 == 0f));
                                    let _e295 = ((_e266[0] * _e231) * _e237);
                                    let _e297 = select(_e295, 0f, (_e295 == 0f));
                                    let _e299 = ((_e266[1] * _e231) * _e237);
                                    let _e301 = select(_e299, 0f, (_e299 == 0f));
                                    let _e303 = ((_e266[2] * _e231) * _e237);
                                    let _e305 = select(_e303, 0f, (_e303 == 0f));
                                    if _e238 {
                                        if _e238 {
                                        } else {
                                            break;
                                        }
                                        let _e307 = global_3.member[_e76.member_3];
                                        phi_362_ = _e307;
                                    } else {
                                        phi_362_ = array<u32, 3>(0u, 0u, 0u);
                                    }
                                    let _e309 = phi_362_;
                                    let _e311 = (_e309[0] < _e52);
                                    if _e311 {
                                        if _e311 {
                                        } else {
                                            break;
                                        }
                                        let _e314 = global_4.member[_e309[0]];
                                        phi_379_ = vec3<f32>(_e314[0], _e314[1], _e314[2]);
                                    } else {
                                        phi_379_ = vec3<f32>(0f, 0f, 0f);
                                    }
                                    let _e320 = phi_379_;
                                    let _e322 = (_e309[1] < _e52);
                                    if _e322 {
                                        if _e322 {
                                        } else {
                                            break;
                                        }
                                        let _e325 = global_4.member[_e309[1]];
                                        phi_396_ = vec3<f32>(_e325[0], _e325[1], _e325[2]);
                                    } else {
                                        phi_396_ = vec3<f32>(0f, 0f, 0f);
                                    }
                                    let _e331 = phi_396_;
                                    let _e333 = (_e309[2] < _e52);
                                    if _e333 {
                                        if _e333 {
                                        } else {
                                            break;
                                        }
                                        let _e336 = global_4.member[_e309[2]];
                                        phi_413_ = vec3<f32>(_e336[0], _e336[1], _e336[2]);
                                    } else {
                                        phi_413_ = vec3<f32>(0f, 0f, 0f);
                                    }
                                    let _e342 = phi_413_;
                                    let _e351 = ((1f - _e76.member_1) - _e76.member_2);
                                    let _e353 = select(0f, _e351, (_e351 > 0f));
                                    let _e355 = select(1f, _e76.member_1, (_e76.member_1 < 1f));
                                    let _e357 = select(1f, _e76.member_2, (_e76.member_2 < 1f));
                                    let _e358 = (_e273 * _e353);
                                    let _e359 = (_e277 * _e353);
                                    let _e360 = (_e281 * _e353);
                                    let _e361 = (_e285 * _e355);
                                    let _e362 = (_e289 * _e355);
                                    let _e363 = (_e293 * _e355);
                                    let _e364 = (_e297 * _e357);
                                    let _e365 = (_e301 * _e357);
                                    let _e366 = (_e305 * _e357);
                                    let _e370 = ((_e358 + _e361) + _e364);
                                    let _e371 = ((_e359 + _e362) + _e365);
                                    let _e372 = ((_e360 + _e363) + _e366);
                                    let _e406 = (((bitcast<f32>((bitcast<u32>(_e358) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e361) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e364) & 2147483647u))) * 0.00000071525625f);
                                    let _e407 = (((bitcast<f32>((bitcast<u32>(_e359) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e362) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e365) & 2147483647u))) * 0.00000071525625f);
                                    let _e408 = (((bitcast<f32>((bitcast<u32>(_e360) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e363) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e366) & 2147483647u))) * 0.00000071525625f);
                                    let _e409 = (_e285 - _e273);
                                    let _e410 = (_e289 - _e277);
                                    let _e411 = (_e293 - _e281);
                                    let _e412 = (_e297 - _e273);
                                    let _e413 = (_e301 - _e277);
                                    let _e414 = (_e305 - _e281);
                                    let _e417 = ((_e410 * _e414) - (_e413 * _e411));
                                    let _e420 = ((_e411 * _e412) - (_e414 * _e409));
                                    let _e423 = ((_e409 * _e413) - (_e412 * _e410));
                                    let _e426 = bitcast<f32>((bitcast<u32>(_e417) & 2147483647u));
                                    let _e429 = bitcast<f32>((bitcast<u32>(_e420) & 2147483647u));
                                    let _e431 = select(_e429, _e426, (_e426 > _e429));
                                    let _e434 = bitcast<f32>((bitcast<u32>(_e423) & 2147483647u));
                                    let _e436 = select(_e434, _e431, (_e431 > _e434));
                                    if (_e436 < 0.000000000000000000000000000000000000011754944f) {
                                        phi_595_ = vec3<f32>(0f, 0f, 0f);
                                    } else {
                                        let _e439 = (bitcast<u32>(_e436) & 2147483647u);
                                        let _e440 = (_e439 >= 8388608u);
                                        if _e440 {
                                            phi_545_ = (bitcast<i32>((_e439 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_545_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e439)), 32u, (_e439 == 0u))));
                                        }
                                        let _e453 = phi_545_;
                                        let _e460 = bitcast<f32>((bitcast<u32>(((_e453 / -2i) + 127i)) << bitcast<u32>(23i)));
                                        if _e440 {
                                            phi_576_ = (bitcast<i32>((_e439 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_576_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e439)), 32u, (_e439 == 0u))));
                                        }
                                        let _e476 = phi_576_;
                                        let _e482 = bitcast<f32>((bitcast<u32>((((_e453 / 2i) - _e476) + 127i)) << bitcast<u32>(23i)));
                                        let _e483 = ((_e417 * _e460) * _e482);
                                        let _e484 = ((_e420 * _e460) * _e482);
                                        let _e485 = ((_e423 * _e460) * _e482);
                                        let _e491 = sqrt((((_e483 * _e483) + (_e484 * _e484)) + (_e485 * _e485)));
                                        phi_595_ = vec3<f32>((_e483 / _e491), (_e484 / _e491), (_e485 / _e491));
                                    }
                                    let _e497 = phi_595_;
                                    let _e507 = select(1f, -1f, ((((_e497.x * _e73.member.member_2[0]) + (_e497.y * _e73.member.member_2[1])) + (_e497.z * _e73.member.member_2[2])) > 0f));
                                    let _e508 = (_e497.x * _e507);
                                    let _e509 = (_e497.y * _e507);
                                    let _e510 = (_e497.z * _e507);
                                    let _e533 = (((_e320.x * _e353) + (_e331.x * _e355)) + (_e342.x * _e357));
                                    let _e534 = (((_e320.y * _e353) + (_e331.y * _e355)) + (_e342.y * _e357));
                                    let _e535 = (((_e320.z * _e353) + (_e331.z * _e355)) + (_e342.z * _e357));
                                    let _e538 = bitcast<f32>((bitcast<u32>(_e533) & 2147483647u));
                                    let _e541 = bitcast<f32>((bitcast<u32>(_e534) & 2147483647u));
                                    let _e543 = select(_e541, _e538, (_e538 > _e541));
                                    let _e546 = bitcast<f32>((bitcast<u32>(_e535) & 2147483647u));
                                    let _e548 = select(_e546, _e543, (_e543 > _e546));
                                    if (_e548 < 0.000000000000000000000000000000000000011754944f) {
                                        phi_728_ = vec3<f32>(0f, 0f, 0f);
                                    } else {
                                        let _e551 = (bitcast<u32>(_e548) & 2147483647u);
                                        let _e552 = (_e551 >= 8388608u);
                                        if _e552 {
                                            phi_678_ = (bitcast<i32>((_e551 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_678_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e551)), 32u, (_e551 == 0u))));
                                        }
                                        let _e565 = phi_678_;
                                        let _e572 = bitcast<f32>((bitcast<u32>(((_e565 / -2i) + 127i)) << bitcast<u32>(23i)));
                                        if _e552 {
                                            phi_709_ = (bitcast<i32>((_e551 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_709_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e551)), 32u, (_e551 == 0u))));
                                        }
                                        let _e588 = phi_709_;
                                        let _e594 = bitcast<f32>((bitcast<u32>((((_e565 / 2i) - _e588) + 127i)) << bitcast<u32>(23i)));
                                        let _e595 = ((_e533 * _e572) * _e594);
                                        let _e596 = ((_e534 * _e572) * _e594);
                                        let _e597 = ((_e535 * _e572) * _e594);
                                        let _e603 = sqrt((((_e595 * _e595) + (_e596 * _e596)) + (_e597 * _e597)));
                                        phi_728_ = vec3<f32>((_e595 / _e603), (_e596 / _e603), (_e597 / _e603));
                                    }
                                    let _e609 = phi_728_;
                                    let _e624 = select((_e497 * _e507), (_e609 * _e507), vec3((((((_e609.x * _e507) * _e508) + ((_e609.y * _e507) * _e509)) + ((_e609.z * _e507) * _e510)) > 0f)));
                                    let _e625 = (_e76.member_3 < arrayLength((&global_5.member)));
                                    if _e625 {
                                        if _e625 {
                                        } else {
                                            break;
                                        }
                                        let _e628 = global_5.member[_e76.member_3];
                                        phi_758_ = _e628;
                                    } else {
                                        phi_758_ = 0u;
                                    }
                                    let _e630 = phi_758_;
                                    let _e632 = select(_e630, 0u, (_e630 >= _e56));
                                    if (_e632 < _e56) {
                                    } else {
                                        break;
                                    }
                                    let _e636 = global_6.member[_e632];
                                    if (0u < _e58) {
                                    } else {
                                        break;
                                    }
                                    let _e641 = global_7.member[0u].member;
                                    let _e650 = (_e636.member_2 > 0f);
                                    if _e650 {
                                        phi_792_ = _e636.member_2;
                                    } else {
                                        phi_792_ = _e636.member_1;
                                    }
                                    let _e653 = phi_792_;
                                    let _e655 = ((1f - _e653) * 0.31830987f);
                                    let _e676 = array<f32, 3>((_e73.member_3[0] + ((_e641[0] * (_e636.member[0] * _e655)) * _e73.member_1[0])), (_e73.member_3[1] + ((_e641[1] * (_e636.member[1] * _e655)) * _e73.member_1[1])), (_e73.member_3[2] + ((_e641[2] * (_e636.member[2] * _e655)) * _e73.member_1[2])));
                                    if _e650 {
                                        phi_829_ = _e636.member_2;
                                    } else {
                                        phi_829_ = _e636.member_1;
                                    }
                                    let _e682 = phi_829_;
                                    if (_e682 <= 0f) {
                                        phi_1478_ = type_33(type_32(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), _e73.member_1, _e73.member_2, _e676, _e73.member_4);
                                    } else {
                                        if _e650 {
                                            if (_e507 > 0f) {
                                                phi_851_ = (1f / _e636.member_3);
                                            } else {
                                                phi_851_ = _e636.member_3;
                                            }
                                            let _e693 = phi_851_;
                                            let _e696 = bitcast<f32>((bitcast<u32>(_e73.member.member_2[0]) & 2147483647u));
                                            let _e699 = bitcast<f32>((bitcast<u32>(_e73.member.member_2[1]) & 2147483647u));
                                            let _e701 = select(_e699, _e696, (_e696 > _e699));
                                            let _e704 = bitcast<f32>((bitcast<u32>(_e73.member.member_2[2]) & 2147483647u));
                                            let _e706 = select(_e704, _e701, (_e701 > _e704));
                                            if (_e706 < 0.000000000000000000000000000000000000011754944f) {
                                                phi_940_ = vec3<f32>(0f, 0f, 0f);
                                            } else {
                                                let _e709 = (bitcast<u32>(_e706) & 2147483647u);
                                                let _e710 = (_e709 >= 8388608u);
                                                if _e710 {
                                                    phi_890_ = (bitcast<i32>((_e709 >> bitcast<u32>(23i))) - 127i);
                                                } else {
                                                    phi_890_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e709)), 32u, (_e709 == 0u))));
                                                }
                                                let _e723 = phi_890_;
                                                let _e730 = bitcast<f32>((bitcast<u32>(((_e723 / -2i) + 127i)) << bitcast<u32>(23i)));
                                                if _e710 {
                                                    phi_921_ = (bitcast<i32>((_e709 >> bitcast<u32>(23i))) - 127i);
                                                } else {
                                                    phi_921_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e709)), 32u, (_e709 == 0u))));
                                                }
                                                let _e746 = phi_921_;
                                                let _e752 = bitcast<f32>((bitcast<u32>((((_e723 / 2i) - _e746) + 127i)) << bitcast<u32>(23i)));
                                                let _e753 = ((_e73.member.member_2[0] * _e730) * _e752);
                                                let _e754 = ((_e73.member.member_2[1] * _e730) * _e752);
                                                let _e755 = ((_e73.member.member_2[2] * _e730) * _e752);
                                                let _e761 = sqrt((((_e753 * _e753) + (_e754 * _e754)) + (_e755 * _e755)));
                                                phi_940_ = vec3<f32>((_e753 / _e761), (_e754 / _e761), (_e755 / _e761));
                                            }
                                            let _e767 = phi_940_;
                                            let _e778 = (((_e624.x * _e767.x) + (_e624.y * _e767.y)) + (_e624.z * _e767.z));
                                            let _e779 = (_e693 * _e693);
                                            let _e783 = (1f - (_e779 * (1f - (_e778 * _e778))));
                                            if (_e783 >= 0f) {
                                                let _e790 = ((_e693 * _e778) + sqrt(_e783));
                                                phi_980_ = vec3<f32>(((_e693 * _e767.x) - (_e790 * _e624.x)), ((_e693 * _e767.y) - (_e790 * _e624.y)), ((_e693 * _e767.z) - (_e790 * _e624.z)));
                                            } else {
                                                phi_980_ = vec3<f32>(0f, 0f, 0f);
                                            }
                                            let _e799 = phi_980_;
                                            if ((((_e799.x * _e508) + (_e799.y * _e509)) + (_e799.z * _e510)) > 0f) {
                                                let _e813 = (((_e508 * _e767.x) + (_e509 * _e767.y)) + (_e510 * _e767.z));
                                                let _e817 = (1f - (_e779 * (1f - (_e813 * _e813))));
                                                if (_e817 >= 0f) {
                                                    let _e824 = ((_e693 * _e813) + sqrt(_e817));
                                                    phi_1026_ = vec3<f32>(((_e693 * _e767.x) - (_e824 * _e508)), ((_e693 * _e767.y) - (_e824 * _e509)), ((_e693 * _e767.z) - (_e824 * _e510)));
                                                } else {
                                                    phi_1026_ = vec3<f32>(0f, 0f, 0f);
                                                }
                                                let _e833 = phi_1026_;
                                                phi_1027_ = _e833;
                                            } else {
                                                phi_1027_ = _e799;
                                            }
                                            let _e835 = phi_1027_;
                                            let _e844 = ((((_e835.x * _e508) + (_e835.y * _e509)) + (_e835.z * _e510)) < 0f);
                                            if _e844 {
                                                let _e845 = -(_e508);
                                                let _e846 = -(_e509);
                                                let _e847 = -(_e510);
                                                let _e849 = select(_e407, _e406, (_e406 > _e407));
                                                let _e863 = (select(_e408, _e849, (_e849 > _e408)) * ((bitcast<f32>((bitcast<u32>(_e845) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e846) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e847) & 2147483647u))));
                                                let _e867 = (_e370 + (_e845 * _e863));
                                                let _e868 = (_e371 + (_e846 * _e863));
                                                let _e869 = (_e372 + (_e847 * _e863));
                                                if (_e845 > 0f) {
                                                    let _e890 = bitcast<u32>(_e867);
                                                    if ((_e890 & 2147483647u) == 0u) {
                                                        phi_1092_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e890 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_1091_ = bitcast<f32>((_e890 + 1u));
                                                        } else {
                                                            phi_1091_ = bitcast<f32>((_e890 - 1u));
                                                        }
                                                        let _e901 = phi_1091_;
                                                        phi_1092_ = _e901;
                                                    }
                                                    let _e903 = phi_1092_;
                                                    phi_1118_ = _e903;
                                                } else {
                                                    if (_e845 < 0f) {
                                                        let _e873 = bitcast<u32>(-(_e867));
                                                        if ((_e873 & 2147483647u) == 0u) {
                                                            phi_1115_ = 0.000000000000000000000000000000000000000000001f;
                                                        } else {
                                                            if ((_e873 >> bitcast<u32>(31i)) == 0u) {
                                                                phi_1114_ = bitcast<f32>((_e873 + 1u));
                                                            } else {
                                                                phi_1114_ = bitcast<f32>((_e873 - 1u));
                                                            }
                                                            let _e884 = phi_1114_;
                                                            phi_1115_ = _e884;
                                                        }
                                                        let _e886 = phi_1115_;
                                                        phi_1117_ = -(_e886);
                                                    } else {
                                                        phi_1117_ = _e867;
                                                    }
                                                    let _e889 = phi_1117_;
                                                    phi_1118_ = _e889;
                                                }
                                                let _e905 = phi_1118_;
                                                if (_e846 > 0f) {
                                                    let _e926 = bitcast<u32>(_e868);
                                                    if ((_e926 & 2147483647u) == 0u) {
                                                        phi_1140_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e926 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_1139_ = bitcast<f32>((_e926 + 1u));
                                                        } else {
                                                            phi_1139_ = bitcast<f32>((_e926 - 1u));
                                                        }
                                                        let _e937 = phi_1139_;
                                                        phi_1140_ = _e937;
                                                    }
                                                    let _e939 = phi_1140_;
                                                    phi_1166_ = _e939;
                                                } else {
                                                    if (_e846 < 0f) {
                                                        let _e909 = bitcast<u32>(-(_e868));
                                                        if ((_e909 & 2147483647u) == 0u) {
                                                            phi_1163_ = 0.000000000000000000000000000000000000000000001f;
                                                        } else {
                                                            if ((_e909 >> bitcast<u32>(31i)) == 0u) {
                                                                phi_1162_ = bitcast<f32>((_e909 + 1u));
                                                            } else {
                                                                phi_1162_ = bitcast<f32>((_e909 - 1u));
                                                            }
                                                            let _e920 = phi_1162_;
                                                            phi_1163_ = _e920;
                                                        }
                                                        let _e922 = phi_1163_;
                                                        phi_1165_ = -(_e922);
                                                    } else {
                                                        phi_1165_ = _e868;
                                                    }
                                                    let _e925 = phi_1165_;
                                                    phi_1166_ = _e925;
                                                }
                                                let _e941 = phi_1166_;
                                                if (_e847 > 0f) {
                                                    let _e962 = bitcast<u32>(_e869);
                                                    if ((_e962 & 2147483647u) == 0u) {
                                                        phi_1188_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e962 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_1187_ = bitcast<f32>((_e962 + 1u));
                                                        } else {
                                                            phi_1187_ = bitcast<f32>((_e962 - 1u));
                                                        }
                                                        let _e973 = phi_1187_;
                                                        phi_1188_ = _e973;
                                                    }
                                                    let _e975 = phi_1188_;
                                                    phi_1214_ = _e975;
                                                } else {
                                                    if (_e847 < 0f) {
                                                        let _e945 = bitcast<u32>(-(_e869));
                                                        if ((_e945 & 2147483647u) == 0u) {
                                                            phi_1211_ = 0.000000000000000000000000000000000000000000001f;
                                                        } else {
                                                            if ((_e945 >> bitcast<u32>(31i)) == 0u) {
                                                                phi_1210_ = bitcast<f32>((_e945 + 1u));
                                                            } else {
                                                                phi_1210_ = bitcast<f32>((_e945 - 1u));
                                                            }
                                                            let _e956 = phi_1210_;
                                                            phi_1211_ = _e956;
                                                        }
                                                        let _e958 = phi_1211_;
                                                        phi_1213_ = -(_e958);
                                                    } else {
                                                        phi_1213_ = _e869;
                                                    }
                                                    let _e961 = phi_1213_;
                                                    phi_1214_ = _e961;
                                                }
                                                let _e977 = phi_1214_;
                                                phi_1217_ = type_48(vec3<f32>(_e905, _e941, _e977), _e835);
                                            } else {
                                                phi_1217_ = type_48();
                                            }
                                            let _e981 = phi_1217_;
                                            phi_1219_ = _e981;
                                            phi_1220_ = select(true, false, _e844);
                                        } else {
                                            phi_1219_ = type_48();
                                            phi_1220_ = true;
                                        }
                                        let _e984 = phi_1219_;
                                        let _e986 = phi_1220_;
                                        if _e986 {
                                            let _e988 = select(_e407, _e406, (_e406 > _e407));
                                            let _e1002 = (select(_e408, _e988, (_e988 > _e408)) * ((bitcast<f32>((bitcast<u32>(_e508) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e509) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e510) & 2147483647u))));
                                            let _e1006 = (_e370 + (_e508 * _e1002));
                                            let _e1007 = (_e371 + (_e509 * _e1002));
                                            let _e1008 = (_e372 + (_e510 * _e1002));
                                            if (_e508 > 0f) {
                                                let _e1029 = bitcast<u32>(_e1006);
                                                if ((_e1029 & 2147483647u) == 0u) {
                                                    phi_1273_ = 0.000000000000000000000000000000000000000000001f;
                                                } else {
                                                    if ((_e1029 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_1272_ = bitcast<f32>((_e1029 + 1u));
                                                    } else {
                                                        phi_1272_ = bitcast<f32>((_e1029 - 1u));
                                                    }
                                                    let _e1040 = phi_1272_;
                                                    phi_1273_ = _e1040;
                                                }
                                                let _e1042 = phi_1273_;
                                                phi_1299_ = _e1042;
                                            } else {
                                                if (_e508 < 0f) {
                                                    let _e1012 = bitcast<u32>(-(_e1006));
                                                    if ((_e1012 & 2147483647u) == 0u) {
                                                        phi_1296_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1012 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_1295_ = bitcast<f32>((_e1012 + 1u));
                                                        } else {
                                                            phi_1295_ = bitcast<f32>((_e1012 - 1u));
                                                        }
                                                        let _e1023 = phi_1295_;
                                                        phi_1296_ = _e1023;
                                                    }
                                                    let _e1025 = phi_1296_;
                                                    phi_1298_ = -(_e1025);
                                                } else {
                                                    phi_1298_ = _e1006;
                                                }
                                                let _e1028 = phi_1298_;
                                                phi_1299_ = _e1028;
                                            }
                                            let _e1044 = phi_1299_;
                                            if (_e509 > 0f) {
                                                let _e1065 = bitcast<u32>(_e1007);
                                                if ((_e1065 & 2147483647u) == 0u) {
                                                    phi_1321_ = 0.000000000000000000000000000000000000000000001f;
                                                } else {
                                                    if ((_e1065 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_1320_ = bitcast<f32>((_e1065 + 1u));
                                                    } else {
                                                        phi_1320_ = bitcast<f32>((_e1065 - 1u));
                                                    }
                                                    let _e1076 = phi_1320_;
                                                    phi_1321_ = _e1076;
                                                }
                                                let _e1078 = phi_1321_;
                                                phi_1347_ = _e1078;
                                            } else {
                                                if (_e509 < 0f) {
                                                    let _e1048 = bitcast<u32>(-(_e1007));
                                                    if ((_e1048 & 2147483647u) == 0u) {
                                                        phi_1344_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1048 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_1343_ = bitcast<f32>((_e1048 + 1u));
                                                        } else {
                                                            phi_1343_ = bitcast<f32>((_e1048 - 1u));
                                                        }
                                                        let _e1059 = phi_1343_;
                                                        phi_1344_ = _e1059;
                                                    }
                                                    let _e1061 = phi_1344_;
                                                    phi_1346_ = -(_e1061);
                                                } else {
                                                    phi_1346_ = _e1007;
                                                }
                                                let _e1064 = phi_1346_;
                                                phi_1347_ = _e1064;
                                            }
                                            let _e1080 = phi_1347_;
                                            if (_e510 > 0f) {
                                                let _e1101 = bitcast<u32>(_e1008);
                                                if ((_e1101 & 2147483647u) == 0u) {
                                                    phi_1369_ = 0.000000000000000000000000000000000000000000001f;
                                                } else {
                                                    if ((_e1101 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_1368_ = bitcast<f32>((_e1101 + 1u));
                                                    } else {
                                                        phi_1368_ = bitcast<f32>((_e1101 - 1u));
                                                    }
                                                    let _e1112 = phi_1368_;
                                                    phi_1369_ = _e1112;
                                                }
                                                let _e1114 = phi_1369_;
                                                phi_1395_ = _e1114;
                                            } else {
                                                if (_e510 < 0f) {
                                                    let _e1084 = bitcast<u32>(-(_e1008));
                                                    if ((_e1084 & 2147483647u) == 0u) {
                                                        phi_1392_ = 0.000000000000000000000000000000000000000000001f;
                                                    } else {
                                                        if ((_e1084 >> bitcast<u32>(31i)) == 0u) {
                                                            phi_1391_ = bitcast<f32>((_e1084 + 1u));
                                                        } else {
                                                            phi_1391_ = bitcast<f32>((_e1084 - 1u));
                                                        }
                                                        let _e1095 = phi_1391_;
                                                        phi_1392_ = _e1095;
                                                    }
                                                    let _e1097 = phi_1392_;
                                                    phi_1394_ = -(_e1097);
                                                } else {
                                                    phi_1394_ = _e1008;
                                                }
                                                let _e1100 = phi_1394_;
                                                phi_1395_ = _e1100;
                                            }
                                            let _e1116 = phi_1395_;
                                            let _e1126 = (2f * (((_e73.member.member_2[0] * _e624.x) + (_e73.member.member_2[1] * _e624.y)) + (_e73.member.member_2[2] * _e624.z)));
                                            let _e1130 = (_e73.member.member_2[0] - (_e624.x * _e1126));
                                            let _e1131 = (_e73.member.member_2[1] - (_e624.y * _e1126));
                                            let _e1132 = (_e73.member.member_2[2] - (_e624.z * _e1126));
                                            if ((((_e1130 * _e508) + (_e1131 * _e509)) + (_e1132 * _e510)) > 0f) {
                                                phi_1438_ = vec3<f32>(_e1130, _e1131, _e1132);
                                            } else {
                                                let _e1145 = (2f * (((_e73.member.member_2[0] * _e508) + (_e73.member.member_2[1] * _e509)) + (_e73.member.member_2[2] * _e510)));
                                                phi_1438_ = vec3<f32>((_e73.member.member_2[0] - (_e508 * _e1145)), (_e73.member.member_2[1] - (_e509 * _e1145)), (_e73.member.member_2[2] - (_e510 * _e1145)));
                                            }
                                            let _e1154 = phi_1438_;
                                            phi_1440_ = type_48(vec3<f32>(_e1044, _e1080, _e1116), _e1154);
                                        } else {
                                            phi_1440_ = _e984;
                                        }
                                        let _e1157 = phi_1440_;
                                        if _e650 {
                                            phi_1460_ = vec3<f32>((_e636.member[0] * _e636.member_2), (_e636.member[1] * _e636.member_2), (_e636.member[2] * _e636.member_2));
                                        } else {
                                            phi_1460_ = vec3(_e636.member_1);
                                        }
                                        let _e1165 = phi_1460_;
                                        phi_1478_ = type_33(type_32(array<f32, 3>(_e1157.member.x, _e1157.member.y, _e1157.member.z), 0f, array<f32, 3>(_e1157.member_1.x, _e1157.member_1.y, _e1157.member_1.z), 340282350000000000000000000000000000000f), array<f32, 3>((_e73.member_1[0] * _e1165.x), (_e73.member_1[1] * _e1165.y), (_e73.member_1[2] * _e1165.z)), _e76.member_3, _e676, _e73.member_4);
                                    }
                                    let _e1191 = phi_1478_;
                                    phi_1633_ = _e1191;
                                } else {
                                    if (0u < _e58) {
                                    } else {
                                        break;
                                    }
                                    let _e92 = bitcast<f32>((bitcast<u32>(_e73.member.member_2[0]) & 2147483647u));
                                    let _e95 = bitcast<f32>((bitcast<u32>(_e73.member.member_2[1]) & 2147483647u));
                                    let _e97 = select(_e95, _e92, (_e92 > _e95));
                                    let _e100 = bitcast<f32>((bitcast<u32>(_e73.member.member_2[2]) & 2147483647u));
                                    let _e102 = select(_e100, _e97, (_e97 > _e100));
                                    if (_e102 < 0.000000000000000000000000000000000000011754944f) {
                                        phi_1576_ = vec3<f32>(0f, 0f, 0f);
                                    } else {
                                        let _e105 = (bitcast<u32>(_e102) & 2147483647u);
                                        let _e106 = (_e105 >= 8388608u);
                                        if _e106 {
                                            phi_1526_ = (bitcast<i32>((_e105 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_1526_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e105)), 32u, (_e105 == 0u))));
                                        }
                                        let _e119 = phi_1526_;
                                        let _e126 = bitcast<f32>((bitcast<u32>(((_e119 / -2i) + 127i)) << bitcast<u32>(23i)));
                                        if _e106 {
                                            phi_1557_ = (bitcast<i32>((_e105 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_1557_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e105)), 32u, (_e105 == 0u))));
                                        }
                                        let _e142 = phi_1557_;
                                        let _e148 = bitcast<f32>((bitcast<u32>((((_e119 / 2i) - _e142) + 127i)) << bitcast<u32>(23i)));
                                        let _e149 = ((_e73.member.member_2[0] * _e126) * _e148);
                                        let _e150 = ((_e73.member.member_2[1] * _e126) * _e148);
                                        let _e151 = ((_e73.member.member_2[2] * _e126) * _e148);
                                        let _e157 = sqrt((((_e149 * _e149) + (_e150 * _e150)) + (_e151 * _e151)));
                                        phi_1576_ = vec3<f32>((_e149 / _e157), (_e150 / _e157), (_e151 / _e157));
                                    }
                                    let _e163 = phi_1576_;
                                    let _e167 = global_7.member[0u].member_6;
                                    let _e178 = (((_e163.x * _e167[0]) + (_e163.y * _e167[1])) + (_e163.z * _e167[2]));
                                    let _e180 = select(0f, _e178, (_e178 > 0f));
                                    let _e184 = global_7.member[0u].member_4;
                                    let _e191 = global_7.member[0u].member_2;
                                    phi_1633_ = type_33(type_32(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), _e73.member_1, _e73.member_2, array<f32, 3>((_e73.member_3[0] + ((_e184[0] + ((_e191[0] - _e184[0]) * _e180)) * _e73.member_1[0])), (_e73.member_3[1] + ((_e184[1] + ((_e191[1] - _e184[1]) * _e180)) * _e73.member_1[1])), (_e73.member_3[2] + ((_e184[2] + ((_e191[2] - _e184[2]) * _e180)) * _e73.member_1[2]))), _e73.member_4);
                                }
                                let _e1193 = phi_1633_;
                                if _e67 {
                                } else {
                                    break;
                                }
                                global_9.member[_e66] = _e1193;
                            }
                        }
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn shade_scatter(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
