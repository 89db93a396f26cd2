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

struct type_27 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_29 {
    member: array<type_27>,
}

struct type_31 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_32 {
    member: type_31,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_34 {
    member: array<type_32>,
}

struct type_38 {
    member: array<f32, 3>,
    member_1: f32,
}

struct type_40 {
    member: array<type_38>,
}

struct type_43 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 3>,
    member_5: u32,
    member_6: array<f32, 3>,
    member_7: u32,
}

struct type_45 {
    member: array<type_43>,
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
var<storage> global_6: type_40;
@group(0) @binding(6) 
var<storage> global_7: type_45;
@group(0) @binding(7) 
var<storage> global_8: type_29;
@group(0) @binding(8) 
var<storage, read_write> global_9: type_34;

fn function_() {
    var phi_1179_: i32;
    var phi_1210_: i32;
    var phi_1229_: vec3<f32>;
    var phi_440_: array<u32, 3>;
    var phi_455_: array<f32, 3>;
    var phi_473_: array<f32, 3>;
    var phi_491_: array<f32, 3>;
    var phi_578_: array<u32, 3>;
    var phi_595_: vec3<f32>;
    var phi_612_: vec3<f32>;
    var phi_629_: vec3<f32>;
    var phi_763_: i32;
    var phi_794_: i32;
    var phi_813_: vec3<f32>;
    var phi_896_: i32;
    var phi_927_: i32;
    var phi_946_: vec3<f32>;
    var phi_988_: u32;
    var phi_1111_: vec3<f32>;
    var phi_1395_: f32;
    var phi_1397_: f32;
    var phi_1401_: f32;
    var phi_1373_: f32;
    var phi_1375_: f32;
    var phi_1403_: f32;
    var phi_1446_: f32;
    var phi_1448_: f32;
    var phi_1452_: f32;
    var phi_1424_: f32;
    var phi_1426_: f32;
    var phi_1454_: f32;
    var phi_1497_: f32;
    var phi_1499_: f32;
    var phi_1503_: f32;
    var phi_1475_: f32;
    var phi_1477_: f32;
    var phi_1505_: f32;
    var phi_1131_: type_32;
    var phi_1286_: type_32;

    switch bitcast<i32>(0u) {
        default: {
            let _e41 = global;
            let _e44 = arrayLength((&global_2.member));
            let _e49 = arrayLength((&global_4.member));
            let _e53 = arrayLength((&global_6.member));
            let _e55 = arrayLength((&global_7.member));
            let _e63 = (_e41.x + (_e41.y * 2097152u));
            let _e64 = (_e63 < arrayLength((&global_9.member)));
            if _e64 {
                let _e65 = (_e63 < arrayLength((&global_8.member)));
                if _e65 {
                    if (_e53 == 0u) {
                    } else {
                        if (_e55 == 0u) {
                        } else {
                            if _e64 {
                            } else {
                                break;
                            }
                            let _e70 = global_9.member[_e63];
                            if _e65 {
                            } else {
                                break;
                            }
                            let _e73 = global_8.member[_e63];
                            if (_e70.member.member_1 <= _e70.member.member_3) {
                                if (_e73.member_3 != 4294967295u) {
                                    let _e221 = global_1.member[0u];
                                    let _e222 = bitcast<i32>(_e221);
                                    let _e223 = (_e222 / 2i);
                                    let _e228 = bitcast<f32>((bitcast<u32>((_e223 + 127i)) << bitcast<u32>(23i)));
                                    let _e234 = bitcast<f32>((bitcast<u32>(((_e222 - _e223) + 127i)) << bitcast<u32>(23i)));
                                    let _e235 = (_e73.member_3 < arrayLength((&global_3.member)));
                                    if _e235 {
                                        if _e235 {
                                        } else {
                                            break;
                                        }
                                        let _e237 = global_3.member[_e73.member_3];
                                        phi_440_ = _e237;
                                    } else {
                                        phi_440_ = array<u32, 3>(0u, 0u, 0u);
                                    }
                                    let _e239 = phi_440_;
                                    let _e241 = (_e239[0] < _e44);
                                    if _e241 {
                                        if _e241 {
                                        } else {
                                            break;
                                        }
                                        let _e243 = global_2.member[_e239[0]];
                                        phi_455_ = _e243;
                                    } else {
                                        phi_455_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e245 = phi_455_;
                                    let _e250 = (_e239[1] < _e44);
                                    if _e250 {
                                        if _e250 {
                                        } else {
                                            break;
                                        }
                                        let _e252 = global_2.member[_e239[1]];
                                        phi_473_ = _e252;
                                    } else {
                                        phi_473_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e254 = phi_473_;
                                    let _e259 = (_e239[2] < _e44);
                                    if _e259 {
                                        if _e259 {
                                        } else {
                                            break;
                                        }
                                        let _e261 = global_2.member[_e239[2]];
                                        phi_491_ = _e261;
                                    } else {
                                        phi_491_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e263 = phi_491_;
                                    let _e268 = ((_e245[0] * _e228) * _e234);
                                    let _e270 = select(_e268, 0f, (_e268 == 0f));
                                    let _e272 = ((_e245[1] * _e228) * _e234);
                                    let _e274 = select(_e272, 0f, (_e272 == 0f));
                                    let _e276 = ((_e245[2] * _e228) * _e234);
                                    let _e278 = select(_e276, 0f, (_e276 == 0f));
                                    let _e280 = ((_e254[0] * _e228) * _e234);
                                    let _e282 = select(_e280, 0f, (_e280 == 0f));
                                    let _e284 = ((_e254[1] * _e228) * _e234);
                                    let _e286 = select(_e284, 0f, (_e284 == 0f));
                                    let _e288 = ((_e254[2] * _e228) * _e234);
                                    let _e290 = select(_e288, 0f, (_e288 == 0f));
                                    let _e292 = ((_e263[0] * _e228) * _e234);
                                    let _e294 = select(_e292, 0f, (_e292 == 0f));
                                    let _e296 = ((_e263[1] * _e228) * _e234);
                                    let _e298 = select(_e296, 0f, (_e296 == 0f));
                                    let _e300 = ((_e263[2] * _e228) * _e234);
                                    let _e302 = select(_e300, 0f, (_e300 == 0f));
                                    if _e235 {
                                        if _e235 {
                                        } else {
                                            break;
                                        }
                                        let _e304 = global_3.member[_e73.member_3];
                                        phi_578_ = _e304;
                                    } else {
                                        phi_578_ = array<u32, 3>(0u, 0u, 0u);
                                    }
                                    let _e306 = phi_578_;
                                    let _e308 = (_e306[0] < _e49);
                                    if _e308 {
                                        if _e308 {
                                        } else {
                                            break;
                                        }
                                        let _e311 = global_4.member[_e306[0]];
                                        phi_595_ = vec3<f32>(_e311[0], _e311[1], _e311[2]);
                                    } else {
                                        phi_595_ = vec3<f32>(0f, 0f, 0f);
                                    }
                                    let _e317 = phi_595_;
                                    let _e319 = (_e306[1] < _e49);
                                    if _e319 {
                                        if _e319 {
                                        } else {
                                            break;
                                        }
                                        let _e322 = global_4.member[_e306[1]];
                                        phi_612_ = vec3<f32>(_e322[0], _e322[1], _e322[2]);
                                    } else {
                                        phi_612_ = vec3<f32>(0f, 0f, 0f);
                                    }
                                    let _e328 = phi_612_;
                                    let _e330 = (_e306[2] < _e49);
                                    if _e330 {
                                        if _e330 {
                                        } else {
                                            break;
                                        }
                                        let _e333 = global_4.member[_e306[2]];
                                        phi_629_ = vec3<f32>(_e333[0], _e333[1], _e333[2]);
                                    } else {
                                        phi_629_ = vec3<f32>(0f, 0f, 0f);
                                    }
                                    let _e339 = phi_629_;
                                    let _e348 = ((1f - _e73.member_1) - _e73.member_2);
                                    let _e350 = select(0f, _e348, (_e348 > 0f));
                                    let _e352 = select(1f, _e73.member_1, (_e73.member_1 < 1f));
                                    let _e354 = select(1f, _e73.member_2, (_e73.member_2 < 1f));
                                    let _e355 = (_e270 * _e350);
                                    let _e356 = (_e274 * _e350);
                                    let _e357 = (_e278 * _e350);
                                    let _e358 = (_e282 * _e352);
                                    let _e359 = (_e286 * _e352);
                                    let _e360 = (_e290 * _e352);
                                    let _e361 = (_e294 * _e354);
                                    let _e362 = (_e298 * _e354);
                                    let _e363 = (_e302 * _e354);
                                    let _e403 = (((bitcast<f32>((bitcast<u32>(_e355) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e358) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e361) & 2147483647u))) * 0.00000071525625f);
                                    let _e404 = (((bitcast<f32>((bitcast<u32>(_e356) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e359) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e362) & 2147483647u))) * 0.00000071525625f);
                                    let _e405 = (((bitcast<f32>((bitcast<u32>(_e357) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e360) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e363) & 2147483647u))) * 0.00000071525625f);
                                    let _e406 = (_e282 - _e270);
                                    let _e407 = (_e286 - _e274);
                                    let _e408 = (_e290 - _e278);
                                    let _e409 = (_e294 - _e270);
                                    let _e410 = (_e298 - _e274);
                                    let _e411 = (_e302 - _e278);
                                    let _e414 = ((_e407 * _e411) - (_e410 * _e408));
                                    let _e417 = ((_e408 * _e409) - (_e411 * _e406));
                                    let _e420 = ((_e406 * _e410) - (_e409 * _e407));
                                    let _e423 = bitcast<f32>((bitcast<u32>(_e414) & 2147483647u));
                                    let _e426 = bitcast<f32>((bitcast<u32>(_e417) & 2147483647u));
                                    let _e428 = select(_e426, _e423, (_e423 > _e426));
                                    let _e431 = bitcast<f32>((bitcast<u32>(_e420) & 2147483647u));
                                    let _e433 = select(_e431, _e428, (_e428 > _e431));
                                    if (_e433 < 0.000000000000000000000000000000000000011754944f) {
                                        phi_813_ = vec3<f32>(0f, 0f, 0f);
                                    } else {
                                        let _e436 = (bitcast<u32>(_e433) & 2147483647u);
                                        let _e437 = (_e436 >= 8388608u);
                                        if _e437 {
                                            phi_763_ = (bitcast<i32>((_e436 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_763_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e436)), 32u, (_e436 == 0u))));
                                        }
                                        let _e450 = phi_763_;
                                        let _e457 = bitcast<f32>((bitcast<u32>(((_e450 / -2i) + 127i)) << bitcast<u32>(23i)));
                                        if _e437 {
                                            phi_794_ = (bitcast<i32>((_e436 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_794_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e436)), 32u, (_e436 == 0u))));
                                        }
                                        let _e473 = phi_794_;
                                        let _e479 = bitcast<f32>((bitcast<u32>((((_e450 / 2i) - _e473) + 127i)) << bitcast<u32>(23i)));
                                        let _e480 = ((_e414 * _e457) * _e479);
                                        let _e481 = ((_e417 * _e457) * _e479);
                                        let _e482 = ((_e420 * _e457) * _e479);
                                        let _e488 = sqrt((((_e480 * _e480) + (_e481 * _e481)) + (_e482 * _e482)));
                                        phi_813_ = vec3<f32>((_e480 / _e488), (_e481 / _e488), (_e482 / _e488));
                                    }
                                    let _e494 = phi_813_;
                                    let _e504 = select(1f, -1f, ((((_e494.x * _e70.member.member_2[0]) + (_e494.y * _e70.member.member_2[1])) + (_e494.z * _e70.member.member_2[2])) > 0f));
                                    let _e508 = (_e494 * _e504);
                                    let _e530 = (((_e317.x * _e350) + (_e328.x * _e352)) + (_e339.x * _e354));
                                    let _e531 = (((_e317.y * _e350) + (_e328.y * _e352)) + (_e339.y * _e354));
                                    let _e532 = (((_e317.z * _e350) + (_e328.z * _e352)) + (_e339.z * _e354));
                                    let _e535 = bitcast<f32>((bitcast<u32>(_e530) & 2147483647u));
                                    let _e538 = bitcast<f32>((bitcast<u32>(_e531) & 2147483647u));
                                    let _e540 = select(_e538, _e535, (_e535 > _e538));
                                    let _e543 = bitcast<f32>((bitcast<u32>(_e532) & 2147483647u));
                                    let _e545 = select(_e543, _e540, (_e540 > _e543));
                                    if (_e545 < 0.000000000000000000000000000000000000011754944f) {
                                        phi_946_ = vec3<f32>(0f, 0f, 0f);
                                    } else {
                                        let _e548 = (bitcast<u32>(_e545) & 2147483647u);
                                        let _e549 = (_e548 >= 8388608u);
                                        if _e549 {
                                            phi_896_ = (bitcast<i32>((_e548 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_896_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e548)), 32u, (_e548 == 0u))));
                                        }
                                        let _e562 = phi_896_;
                                        let _e569 = bitcast<f32>((bitcast<u32>(((_e562 / -2i) + 127i)) << bitcast<u32>(23i)));
                                        if _e549 {
                                            phi_927_ = (bitcast<i32>((_e548 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_927_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e548)), 32u, (_e548 == 0u))));
                                        }
                                        let _e585 = phi_927_;
                                        let _e591 = bitcast<f32>((bitcast<u32>((((_e562 / 2i) - _e585) + 127i)) << bitcast<u32>(23i)));
                                        let _e592 = ((_e530 * _e569) * _e591);
                                        let _e593 = ((_e531 * _e569) * _e591);
                                        let _e594 = ((_e532 * _e569) * _e591);
                                        let _e600 = sqrt((((_e592 * _e592) + (_e593 * _e593)) + (_e594 * _e594)));
                                        phi_946_ = vec3<f32>((_e592 / _e600), (_e593 / _e600), (_e594 / _e600));
                                    }
                                    let _e606 = phi_946_;
                                    let _e621 = select(_e508, (_e606 * _e504), vec3((((((_e606.x * _e504) * (_e494.x * _e504)) + ((_e606.y * _e504) * (_e494.y * _e504))) + ((_e606.z * _e504) * (_e494.z * _e504))) > 0f)));
                                    let _e622 = (_e73.member_3 < arrayLength((&global_5.member)));
                                    if _e622 {
                                        if _e622 {
                                        } else {
                                            break;
                                        }
                                        let _e625 = global_5.member[_e73.member_3];
                                        phi_988_ = _e625;
                                    } else {
                                        phi_988_ = 0u;
                                    }
                                    let _e627 = phi_988_;
                                    let _e629 = select(_e627, 0u, (_e627 >= _e53));
                                    if (_e629 < _e53) {
                                    } else {
                                        break;
                                    }
                                    let _e633 = global_6.member[_e629];
                                    if (0u < _e55) {
                                    } else {
                                        break;
                                    }
                                    let _e638 = global_7.member[0u].member;
                                    let _e648 = ((1f - _e633.member_1) * 0.31830987f);
                                    let _e669 = array<f32, 3>((_e70.member_3[0] + ((_e638[0] * (_e633.member[0] * _e648)) * _e70.member_1[0])), (_e70.member_3[1] + ((_e638[1] * (_e633.member[1] * _e648)) * _e70.member_1[1])), (_e70.member_3[2] + ((_e638[2] * (_e633.member[2] * _e648)) * _e70.member_1[2])));
                                    if (_e633.member_1 <= 0f) {
                                        phi_1131_ = type_32(type_31(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), _e70.member_1, _e70.member_2, _e669, _e70.member_4);
                                    } else {
                                        let _e686 = (2f * (((_e70.member.member_2[0] * _e621.x) + (_e70.member.member_2[1] * _e621.y)) + (_e70.member.member_2[2] * _e621.z)));
                                        let _e690 = (_e70.member.member_2[0] - (_e621.x * _e686));
                                        let _e691 = (_e70.member.member_2[1] - (_e621.y * _e686));
                                        let _e692 = (_e70.member.member_2[2] - (_e621.z * _e686));
                                        if ((((_e690 * _e508.x) + (_e691 * _e508.y)) + (_e692 * _e508.z)) > 0f) {
                                            phi_1111_ = vec3<f32>(_e690, _e691, _e692);
                                        } else {
                                            let _e708 = (2f * (((_e70.member.member_2[0] * _e508.x) + (_e70.member.member_2[1] * _e508.y)) + (_e70.member.member_2[2] * _e508.z)));
                                            phi_1111_ = vec3<f32>((_e70.member.member_2[0] - (_e508.x * _e708)), (_e70.member.member_2[1] - (_e508.y * _e708)), (_e70.member.member_2[2] - (_e508.z * _e708)));
                                        }
                                        let _e717 = phi_1111_;
                                        let _e722 = select(_e404, _e403, (_e403 > _e404));
                                        let _e736 = (select(_e405, _e722, (_e722 > _e405)) * ((bitcast<f32>((bitcast<u32>(_e508.x) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e508.y) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e508.z) & 2147483647u))));
                                        let _e740 = (((_e355 + _e358) + _e361) + (_e508.x * _e736));
                                        let _e741 = (((_e356 + _e359) + _e362) + (_e508.y * _e736));
                                        let _e742 = (((_e357 + _e360) + _e363) + (_e508.z * _e736));
                                        if (_e508.x > 0f) {
                                            let _e763 = bitcast<u32>(_e740);
                                            if ((_e763 & 2147483647u) == 0u) {
                                                phi_1375_ = 0.000000000000000000000000000000000000000000001f;
                                            } else {
                                                if ((_e763 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_1373_ = bitcast<f32>((_e763 + 1u));
                                                } else {
                                                    phi_1373_ = bitcast<f32>((_e763 - 1u));
                                                }
                                                let _e774 = phi_1373_;
                                                phi_1375_ = _e774;
                                            }
                                            let _e776 = phi_1375_;
                                            phi_1403_ = _e776;
                                        } else {
                                            if (_e508.x < 0f) {
                                                let _e746 = bitcast<u32>(-(_e740));
                                                if ((_e746 & 2147483647u) == 0u) {
                                                    phi_1397_ = 0.000000000000000000000000000000000000000000001f;
                                                } else {
                                                    if ((_e746 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_1395_ = bitcast<f32>((_e746 + 1u));
                                                    } else {
                                                        phi_1395_ = bitcast<f32>((_e746 - 1u));
                                                    }
                                                    let _e757 = phi_1395_;
                                                    phi_1397_ = _e757;
                                                }
                                                let _e759 = phi_1397_;
                                                phi_1401_ = -(_e759);
                                            } else {
                                                phi_1401_ = _e740;
                                            }
                                            let _e762 = phi_1401_;
                                            phi_1403_ = _e762;
                                        }
                                        let _e778 = phi_1403_;
                                        if (_e508.y > 0f) {
                                            let _e799 = bitcast<u32>(_e741);
                                            if ((_e799 & 2147483647u) == 0u) {
                                                phi_1426_ = 0.000000000000000000000000000000000000000000001f;
                                            } else {
                                                if ((_e799 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_1424_ = bitcast<f32>((_e799 + 1u));
                                                } else {
                                                    phi_1424_ = bitcast<f32>((_e799 - 1u));
                                                }
                                                let _e810 = phi_1424_;
                                                phi_1426_ = _e810;
                                            }
                                            let _e812 = phi_1426_;
                                            phi_1454_ = _e812;
                                        } else {
                                            if (_e508.y < 0f) {
                                                let _e782 = bitcast<u32>(-(_e741));
                                                if ((_e782 & 2147483647u) == 0u) {
                                                    phi_1448_ = 0.000000000000000000000000000000000000000000001f;
                                                } else {
                                                    if ((_e782 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_1446_ = bitcast<f32>((_e782 + 1u));
                                                    } else {
                                                        phi_1446_ = bitcast<f32>((_e782 - 1u));
                                                    }
                                                    let _e793 = phi_1446_;
                                                    phi_1448_ = _e793;
                                                }
                                                let _e795 = phi_1448_;
                                                phi_1452_ = -(_e795);
                                            } else {
                                                phi_1452_ = _e741;
                                            }
                                            let _e798 = phi_1452_;
                                            phi_1454_ = _e798;
                                        }
                                        let _e814 = phi_1454_;
                                        if (_e508.z > 0f) {
                                            let _e835 = bitcast<u32>(_e742);
                                            if ((_e835 & 2147483647u) == 0u) {
                                                phi_1477_ = 0.000000000000000000000000000000000000000000001f;
                                            } else {
                                                if ((_e835 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_1475_ = bitcast<f32>((_e835 + 1u));
                                                } else {
                                                    phi_1475_ = bitcast<f32>((_e835 - 1u));
                                                }
                                                let _e846 = phi_1475_;
                                                phi_1477_ = _e846;
                                            }
                                            let _e848 = phi_1477_;
                                            phi_1505_ = _e848;
                                        } else {
                                            if (_e508.z < 0f) {
                                                let _e818 = bitcast<u32>(-(_e742));
                                                if ((_e818 & 2147483647u) == 0u) {
                                                    phi_1499_ = 0.000000000000000000000000000000000000000000001f;
                                                } else {
                                                    if ((_e818 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_1497_ = bitcast<f32>((_e818 + 1u));
                                                    } else {
                                                        phi_1497_ = bitcast<f32>((_e818 - 1u));
                                                    }
                                                    let _e829 = phi_1497_;
                                                    phi_1499_ = _e829;
                                                }
                                                let _e831 = phi_1499_;
                                                phi_1503_ = -(_e831);
                                            } else {
                                                phi_1503_ = _e742;
                                            }
                                            let _e834 = phi_1503_;
                                            phi_1505_ = _e834;
                                        }
                                        let _e850 = phi_1505_;
                                        phi_1131_ = type_32(type_31(array<f32, 3>(_e778, _e814, _e850), 0f, array<f32, 3>(_e717.x, _e717.y, _e717.z), 340282350000000000000000000000000000000f), array<f32, 3>((_e70.member_1[0] * _e633.member_1), (_e70.member_1[1] * _e633.member_1), (_e70.member_1[2] * _e633.member_1)), _e73.member_3, _e669, _e70.member_4);
                                    }
                                    let _e861 = phi_1131_;
                                    phi_1286_ = _e861;
                                } else {
                                    if (0u < _e55) {
                                    } else {
                                        break;
                                    }
                                    let _e89 = bitcast<f32>((bitcast<u32>(_e70.member.member_2[0]) & 2147483647u));
                                    let _e92 = bitcast<f32>((bitcast<u32>(_e70.member.member_2[1]) & 2147483647u));
                                    let _e94 = select(_e92, _e89, (_e89 > _e92));
                                    let _e97 = bitcast<f32>((bitcast<u32>(_e70.member.member_2[2]) & 2147483647u));
                                    let _e99 = select(_e97, _e94, (_e94 > _e97));
                                    if (_e99 < 0.000000000000000000000000000000000000011754944f) {
                                        phi_1229_ = vec3<f32>(0f, 0f, 0f);
                                    } else {
                                        let _e102 = (bitcast<u32>(_e99) & 2147483647u);
                                        let _e103 = (_e102 >= 8388608u);
                                        if _e103 {
                                            phi_1179_ = (bitcast<i32>((_e102 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_1179_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e102)), 32u, (_e102 == 0u))));
                                        }
                                        let _e116 = phi_1179_;
                                        let _e123 = bitcast<f32>((bitcast<u32>(((_e116 / -2i) + 127i)) << bitcast<u32>(23i)));
                                        if _e103 {
                                            phi_1210_ = (bitcast<i32>((_e102 >> bitcast<u32>(23i))) - 127i);
                                        } else {
                                            phi_1210_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e102)), 32u, (_e102 == 0u))));
                                        }
                                        let _e139 = phi_1210_;
                                        let _e145 = bitcast<f32>((bitcast<u32>((((_e116 / 2i) - _e139) + 127i)) << bitcast<u32>(23i)));
                                        let _e146 = ((_e70.member.member_2[0] * _e123) * _e145);
                                        let _e147 = ((_e70.member.member_2[1] * _e123) * _e145);
                                        let _e148 = ((_e70.member.member_2[2] * _e123) * _e145);
                                        let _e154 = sqrt((((_e146 * _e146) + (_e147 * _e147)) + (_e148 * _e148)));
                                        phi_1229_ = vec3<f32>((_e146 / _e154), (_e147 / _e154), (_e148 / _e154));
                                    }
                                    let _e160 = phi_1229_;
                                    let _e164 = global_7.member[0u].member_6;
                                    let _e175 = (((_e160.x * _e164[0]) + (_e160.y * _e164[1])) + (_e160.z * _e164[2]));
                                    let _e177 = select(0f, _e175, (_e175 > 0f));
                                    let _e181 = global_7.member[0u].member_4;
                                    let _e188 = global_7.member[0u].member_2;
                                    phi_1286_ = type_32(type_31(array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(0f, 0f, 0f), 0f), _e70.member_1, _e70.member_2, array<f32, 3>((_e70.member_3[0] + ((_e181[0] + ((_e188[0] - _e181[0]) * _e177)) * _e70.member_1[0])), (_e70.member_3[1] + ((_e181[1] + ((_e188[1] - _e181[1]) * _e177)) * _e70.member_1[1])), (_e70.member_3[2] + ((_e181[2] + ((_e188[2] - _e181[2]) * _e177)) * _e70.member_1[2]))), _e70.member_4);
                                }
                                let _e863 = phi_1286_;
                                if _e64 {
                                } else {
                                    break;
                                }
                                global_9.member[_e63] = _e863;
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
