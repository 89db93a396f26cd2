struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_13 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_15 {
    member: array<type_13>,
}

struct type_22 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_23 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_24 {
    member: type_23,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_26 {
    member: array<type_24>,
}

struct type_31 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_33 {
    member: array<type_31>,
}

struct type_36 {
    member: type_23,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_38 {
    member: array<type_36>,
}

struct type_47 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_48 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_49 {
    member: f32,
    member_1: bool,
}

struct type_53 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_1: type_15;
@group(0) @binding(0) 
var<storage> global_2: type_33;
@group(0) @binding(4) 
var<storage, read_write> global_3: type_53;
@group(0) @binding(2) 
var<storage> global_4: type_38;
@group(0) @binding(3) 
var<storage, read_write> global_5: type_26;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_221_: u32;
    var phi_370_: i32;
    var phi_371_: i32;
    var phi_381_: bool;
    var phi_391_: u32;
    var phi_392_: u32;
    var phi_394_: bool;
    var phi_399_: u32;
    var phi_432_: i32;
    var phi_450_: f32;
    var phi_456_: f32;
    var phi_496_: f32;
    var phi_502_: f32;
    var phi_575_: f32;
    var phi_581_: f32;
    var phi_621_: f32;
    var phi_627_: f32;
    var phi_700_: f32;
    var phi_706_: f32;
    var phi_746_: f32;
    var phi_752_: f32;
    var phi_871_: i32;
    var phi_893_: u32;
    var phi_894_: u32;
    var phi_931_: i32;
    var phi_953_: u32;
    var phi_954_: u32;
    var phi_962_: f32;
    var phi_963_: f32;
    var phi_2673_: bool;
    var phi_978_: type_49;
    var phi_981_: bool;
    var phi_983_: u32;
    var phi_985_: u32;
    var phi_987_: u32;
    var phi_998_: bool;
    var phi_1030_: bool;
    var phi_1031_: u32;
    var phi_1032_: u32;
    var phi_2030_: type_48;
    var phi_2392_: u32;
    var phi_2419_: u32;
    var phi_2420_: u32;
    var phi_2421_: u32;
    var phi_2423_: u32;
    var phi_2424_: u32;
    var phi_2425_: bool;
    var phi_2434_: u32;
    var phi_2439_: bool;
    var phi_2440_: u32;
    var phi_1047_: type_49;
    var phi_1050_: type_7;
    var phi_1051_: type_7;
    var phi_1073_: type_7;
    var phi_1094_: u32;
    var phi_1186_: array<array<f32, 3>, 3>;
    var phi_1716_: f32;
    var phi_1717_: f32;
    var phi_1718_: f32;
    var phi_1719_: f32;
    var phi_1720_: vec3<f32>;
    var phi_1721_: vec3<f32>;
    var phi_1722_: vec3<f32>;
    var phi_1723_: vec3<f32>;
    var phi_1914_: f32;
    var phi_1934_: type_47;
    var phi_1935_: type_47;
    var phi_1938_: type_47;
    var phi_1939_: type_47;
    var phi_1940_: bool;
    var phi_1944_: type_47;
    var phi_1953_: type_22;
    var phi_1964_: type_49;
    var phi_1965_: type_49;
    var phi_1048_: type_49;
    var phi_2667_: bool;
    var local_2: type_49;
    var phi_2825_: bool;
    var phi_2442_: type_49;
    var phi_2443_: bool;
    var phi_2444_: u32;
    var phi_2445_: u32;
    var phi_2824_: bool;
    var phi_2446_: type_49;
    var phi_2447_: bool;
    var phi_2448_: u32;
    var phi_2449_: u32;
    var phi_2450_: u32;
    var phi_2823_: bool;
    var phi_2451_: type_49;
    var phi_2452_: bool;
    var phi_2453_: u32;
    var phi_2454_: u32;
    var phi_2455_: u32;
    var phi_2822_: bool;
    var phi_979_: type_49;
    var phi_982_: bool;
    var phi_984_: u32;
    var phi_986_: u32;
    var phi_988_: u32;
    var phi_2456_: bool;
    var phi_2821_: bool;
    var local_3: type_49;
    var local_4: type_49;

    switch bitcast<i32>(0u) {
        default: {
            let _e71 = global;
            let _e73 = arrayLength((&global_2.member));
            let _e75 = arrayLength((&global_1.member));
            let _e81 = arrayLength((&global_3.member));
            let _e85 = (_e71.x + (_e71.y * 2097152u));
            let _e86 = (_e85 < arrayLength((&global_4.member)));
            if _e86 {
                if _e86 {
                } else {
                    break;
                }
                let _e90 = global_4.member[_e85].member_2;
                phi_221_ = _e90;
            } else {
                phi_221_ = 4294967295u;
            }
            let _e92 = phi_221_;
            if _e86 {
                let _e93 = (_e85 < arrayLength((&global_5.member)));
                if _e93 {
                    if _e86 {
                    } else {
                        break;
                    }
                    let _e98 = global_4.member[_e85].member.member_1;
                    let _e103 = global_4.member[_e85].member.member_3;
                    if (_e98 <= _e103) {
                        let _e105 = (1u < _e81);
                        if _e105 {
                            if (0u < _e81) {
                            } else {
                                break;
                            }
                            let _e109 = atomicAdd((&global_3.member[0u]), 1u);
                            if ((_e109 + 1u) < _e109) {
                                if _e105 {
                                } else {
                                    break;
                                }
                                let _e114 = atomicAdd((&global_3.member[1u]), 1u);
                            }
                        }
                        if _e86 {
                        } else {
                            break;
                        }
                        let _e124 = global_4.member[_e85].member.member_2[0u];
                        let _e126 = (bitcast<u32>(_e124) & 2147483647u);
                        let _e132 = global_4.member[_e85].member.member_2[1u];
                        let _e134 = (bitcast<u32>(_e132) & 2147483647u);
                        let _e140 = global_4.member[_e85].member.member_2[2u];
                        let _e142 = (bitcast<u32>(_e140) & 2147483647u);
                        let _e148 = global_4.member[_e85].member.member[0u];
                        let _e150 = (bitcast<u32>(_e148) & 2147483647u);
                        let _e156 = global_4.member[_e85].member.member[1u];
                        let _e158 = (bitcast<u32>(_e156) & 2147483647u);
                        let _e164 = global_4.member[_e85].member.member[2u];
                        let _e166 = (bitcast<u32>(_e164) & 2147483647u);
                        let _e168 = select(_e134, _e126, (_e134 < _e126));
                        let _e170 = select(_e142, _e168, (_e142 < _e168));
                        let _e172 = select(_e150, _e170, (_e150 < _e170));
                        let _e174 = select(_e158, _e172, (_e158 < _e172));
                        let _e176 = select(_e166, _e174, (_e166 < _e174));
                        let _e177 = bitcast<u32>(_e98);
                        let _e178 = (_e177 & 2147483647u);
                        let _e182 = bitcast<u32>(_e103);
                        let _e183 = (_e182 & 2147483647u);
                        let _e187 = (((select(_e178, _e176, (_e178 < _e176)) < 2139095040u) && (_e183 <= 2139095040u)) && (_e170 > 0u));
                        if _e187 {
                            let _e190 = (bitcast<u32>(bitcast<f32>(_e170)) & 2147483647u);
                            if (_e190 >= 8388608u) {
                                phi_370_ = (bitcast<i32>((_e190 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_370_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e190)), 32u, (_e190 == 0u))));
                            }
                            let _e204 = phi_370_;
                            phi_371_ = _e204;
                        } else {
                            phi_371_ = 0i;
                        }
                        let _e206 = phi_371_;
                        let _e207 = (_e126 == _e170);
                        if _e207 {
                            phi_381_ = true;
                        } else {
                            phi_381_ = (_e134 == _e170);
                        }
                        let _e210 = phi_381_;
                        let _e211 = select(1u, 0u, _e207);
                        if _e210 {
                            let _e212 = (_e211 + 1u);
                            phi_391_ = _e212;
                            phi_392_ = _e212;
                            phi_394_ = select(true, false, (_e212 == 2u));
                        } else {
                            phi_391_ = u32();
                            phi_392_ = 0u;
                            phi_394_ = true;
                        }
                        let _e216 = phi_391_;
                        let _e218 = phi_392_;
                        let _e220 = phi_394_;
                        if _e220 {
                            phi_399_ = (_e218 + 1u);
                        } else {
                            phi_399_ = 0u;
                        }
                        let _e224 = phi_399_;
                        let _e225 = select(_e216, _e218, _e220);
                        let _e226 = select(_e211, select(2u, _e211, _e210), _e220);
                        let _e227 = -(_e206);
                        if (_e227 < -126i) {
                            phi_432_ = -126i;
                        } else {
                            phi_432_ = select(_e227, 127i, (_e227 > 127i));
                        }
                        let _e232 = phi_432_;
                        let _e237 = bitcast<f32>((bitcast<u32>((_e232 + 127i)) << bitcast<u32>(23i)));
                        let _e243 = bitcast<f32>((bitcast<u32>(((_e227 - _e232) + 127i)) << bitcast<u32>(23i)));
                        let _e248 = global_4.member[_e85].member.member;
                        let _e249 = (_e225 == 0u);
                        if _e249 {
                            phi_450_ = _e248[0];
                        } else {
                            phi_450_ = _e248[1];
                        }
                        let _e253 = phi_450_;
                        let _e254 = (_e225 == 2u);
                        if _e254 {
                            phi_456_ = _e248[2];
                        } else {
                            phi_456_ = _e253;
                        }
                        let _e257 = phi_456_;
                        let _e258 = bitcast<u32>(_e257);
                        let _e260 = ((_e258 & 2139095040u) != 0u);
                        let _e272 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e258 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e258 & 2147483648u))), _e257, _e260) * select(0.00000011920929f, 1f, _e260));
                        let _e273 = global_4.member[_e85].member.member_2;
                        if _e249 {
                            phi_496_ = _e273[0];
                        } else {
                            phi_496_ = _e273[1];
                        }
                        let _e277 = phi_496_;
                        if _e254 {
                            phi_502_ = _e273[2];
                        } else {
                            phi_502_ = _e277;
                        }
                        let _e280 = phi_502_;
                        let _e281 = bitcast<u32>(_e280);
                        let _e283 = ((_e281 & 2139095040u) != 0u);
                        let _e297 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e281 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e281 & 2147483648u))), _e280, _e283) * _e237) * select(0.00000011920929f, 1f, _e283)) * _e243);
                        let _e301 = (bitcast<f32>((bitcast<u32>(_e297) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e304 = bitcast<f32>((bitcast<u32>(_e272) & 2147483647u));
                        let _e305 = (_e304 * 0.00000011920929f);
                        let _e308 = select(select(0.00000000000011368684f, _e305, (_e305 > 0.00000000000011368684f)), 0f, _e301);
                        let _e309 = select(0f, _e297, _e301);
                        let _e310 = (_e272 + _e308);
                        let _e311 = (_e272 - _e308);
                        let _e313 = select(38685626000000000000000000f, (1f / _e297), _e301);
                        let _e314 = (_e224 == 0u);
                        if _e314 {
                            phi_575_ = _e248[0];
                        } else {
                            phi_575_ = _e248[1];
                        }
                        let _e318 = phi_575_;
                        let _e319 = (_e224 == 2u);
                        if _e319 {
                            phi_581_ = _e248[2];
                        } else {
                            phi_581_ = _e318;
                        }
                        let _e322 = phi_581_;
                        let _e323 = bitcast<u32>(_e322);
                        let _e325 = ((_e323 & 2139095040u) != 0u);
                        let _e337 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e323 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e323 & 2147483648u))), _e322, _e325) * select(0.00000011920929f, 1f, _e325));
                        if _e314 {
                            phi_621_ = _e273[0];
                        } else {
                            phi_621_ = _e273[1];
                        }
                        let _e341 = phi_621_;
                        if _e319 {
                            phi_627_ = _e273[2];
                        } else {
                            phi_627_ = _e341;
                        }
                        let _e344 = phi_627_;
                        let _e345 = bitcast<u32>(_e344);
                        let _e347 = ((_e345 & 2139095040u) != 0u);
                        let _e361 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e345 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e345 & 2147483648u))), _e344, _e347) * _e237) * select(0.00000011920929f, 1f, _e347)) * _e243);
                        let _e365 = (bitcast<f32>((bitcast<u32>(_e361) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e368 = bitcast<f32>((bitcast<u32>(_e337) & 2147483647u));
                        let _e369 = (_e368 * 0.00000011920929f);
                        let _e372 = select(select(0.00000000000011368684f, _e369, (_e369 > 0.00000000000011368684f)), 0f, _e365);
                        let _e373 = select(0f, _e361, _e365);
                        let _e374 = (_e337 + _e372);
                        let _e375 = (_e337 - _e372);
                        let _e377 = select(38685626000000000000000000f, (1f / _e361), _e365);
                        let _e378 = (_e226 == 0u);
                        if _e378 {
                            phi_700_ = _e248[0];
                        } else {
                            phi_700_ = _e248[1];
                        }
                        let _e382 = phi_700_;
                        let _e383 = (_e226 == 2u);
                        if _e383 {
                            phi_706_ = _e248[2];
                        } else {
                            phi_706_ = _e382;
                        }
                        let _e386 = phi_706_;
                        let _e387 = bitcast<u32>(_e386);
                        let _e389 = ((_e387 & 2139095040u) != 0u);
                        let _e401 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e387 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e387 & 2147483648u))), _e386, _e389) * select(0.00000011920929f, 1f, _e389));
                        if _e378 {
                            phi_746_ = _e273[0];
                        } else {
                            phi_746_ = _e273[1];
                        }
                        let _e405 = phi_746_;
                        if _e383 {
                            phi_752_ = _e273[2];
                        } else {
                            phi_752_ = _e405;
                        }
                        let _e408 = phi_752_;
                        let _e409 = bitcast<u32>(_e408);
                        let _e411 = ((_e409 & 2139095040u) != 0u);
                        let _e425 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e409 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e409 & 2147483648u))), _e408, _e411) * _e237) * select(0.00000011920929f, 1f, _e411)) * _e243);
                        let _e429 = (bitcast<f32>((bitcast<u32>(_e425) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e432 = bitcast<f32>((bitcast<u32>(_e401) & 2147483647u));
                        let _e433 = (_e432 * 0.00000011920929f);
                        let _e436 = select(select(0.00000000000011368684f, _e433, (_e433 > 0.00000000000011368684f)), 0f, _e429);
                        let _e437 = select(0f, _e425, _e429);
                        let _e438 = (_e401 + _e436);
                        let _e439 = (_e401 - _e436);
                        let _e441 = select(38685626000000000000000000f, (1f / _e425), _e429);
                        let _e443 = select(_e368, _e304, (_e304 > _e368));
                        if (_e187 && (select(_e432, _e443, (_e443 > _e432)) <= 1099511600000f)) {
                            let _e455 = ((_e178 & 8388607u) | (select(0u, 1u, ((_e178 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e458 = bitcast<i32>((_e178 >> bitcast<u32>(23i)));
                            let _e462 = (_e455 == 0u);
                            let _e465 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e455)), 32u, _e462)) - 8i);
                            if (_e458 == 255i) {
                                phi_871_ = 255i;
                            } else {
                                phi_871_ = (((_e458 + select(0i, 1i, (_e458 == 0i))) - _e465) + _e206);
                            }
                            let _e473 = phi_871_;
                            let _e483 = (_e473 <= 0i);
                            if _e483 {
                                phi_894_ = u32();
                            } else {
                                if _e462 {
                                    phi_893_ = u32();
                                } else {
                                    phi_893_ = select(((bitcast<u32>(_e473) << bitcast<u32>(23i)) | ((_e455 << bitcast<u32>(((_e465 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e473 >= 255i));
                                }
                                let _e487 = phi_893_;
                                phi_894_ = _e487;
                            }
                            let _e489 = phi_894_;
                            let _e501 = ((_e183 & 8388607u) | (select(0u, 1u, ((_e183 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e504 = bitcast<i32>((_e183 >> bitcast<u32>(23i)));
                            let _e508 = (_e501 == 0u);
                            let _e511 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e501)), 32u, _e508)) - 8i);
                            if (_e504 == 255i) {
                                phi_931_ = 255i;
                            } else {
                                phi_931_ = (((_e504 + select(0i, 1i, (_e504 == 0i))) - _e511) + _e206);
                            }
                            let _e519 = phi_931_;
                            let _e529 = (_e519 <= 0i);
                            if _e529 {
                                phi_954_ = u32();
                            } else {
                                if _e508 {
                                    phi_953_ = u32();
                                } else {
                                    phi_953_ = select(((bitcast<u32>(_e519) << bitcast<u32>(23i)) | ((_e501 << bitcast<u32>(((_e511 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e519 >= 255i));
                                }
                                let _e533 = phi_953_;
                                phi_954_ = _e533;
                            }
                            let _e535 = phi_954_;
                            phi_962_ = bitcast<f32>(((_e182 & 2147483648u) | select(_e535, 0u, select(_e508, true, _e529))));
                            phi_963_ = bitcast<f32>(((_e177 & 2147483648u) | select(_e489, 0u, select(_e462, true, _e483))));
                        } else {
                            phi_962_ = 0f;
                            phi_963_ = 1f;
                        }
                        let _e541 = phi_962_;
                        let _e543 = phi_963_;
                        local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        phi_2673_ = false;
                        phi_978_ = type_49(_e541, false);
                        phi_981_ = (_e543 <= _e541);
                        phi_983_ = select(0u, 2147483648u, (_e73 == 0u));
                        phi_985_ = 0u;
                        phi_987_ = ((3u * _e73) + 1u);
                        loop {
                            let _e551 = phi_2673_;
                            let _e553 = phi_978_;
                            let _e555 = phi_981_;
                            let _e557 = phi_983_;
                            let _e559 = phi_985_;
                            let _e561 = phi_987_;
                            local_3 = _e553;
                            if _e555 {
                                phi_998_ = true;
                            } else {
                                phi_998_ = (_e559 > 0u);
                            }
                            let _e564 = phi_998_;
                            if _e564 {
                                let _e565 = (_e561 > 0u);
                                if _e565 {
                                    if _e555 {
                                        phi_1030_ = _e555;
                                        phi_1031_ = _e557;
                                        phi_1032_ = _e559;
                                    } else {
                                        let _e566 = (_e559 - 1u);
                                        let _e567 = (_e566 % 128u);
                                        let _e568 = (_e567 < 128u);
                                        if _e568 {
                                        } else {
                                            phi_2821_ = true;
                                            break;
                                        }
                                        let _e570 = local_1[_e567];
                                        if _e568 {
                                        } else {
                                            phi_2821_ = true;
                                            break;
                                        }
                                        let _e572 = local[_e567];
                                        phi_1030_ = (_e572 <= _e553.member);
                                        phi_1031_ = _e570;
                                        phi_1032_ = _e566;
                                    }
                                    let _e576 = phi_1030_;
                                    let _e578 = phi_1031_;
                                    let _e580 = phi_1032_;
                                    if _e576 {
                                        if ((_e578 & 2147483648u) != 0u) {
                                            phi_1047_ = _e553;
                                            phi_1050_ = type_7(0u, ((_e578 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e777 = phi_1047_;
                                                let _e779 = phi_1050_;
                                                local_2 = _e777;
                                                local_4 = _e777;
                                                if (_e779.member < _e779.member_1) {
                                                    phi_1051_ = type_7((_e779.member + 1u), _e779.member_1);
                                                    phi_1073_ = type_7(1u, _e779.member);
                                                } else {
                                                    phi_1051_ = _e779;
                                                    phi_1073_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e792 = phi_1051_;
                                                let _e794 = phi_1073_;
                                                let _e798 = (bitcast<i32>(_e794.member) != 0i);
                                                if _e798 {
                                                    let _e799 = ((_e578 & 268435455u) + _e794.member_1);
                                                    let _e800 = (_e799 < _e75);
                                                    if _e800 {
                                                        if _e800 {
                                                        } else {
                                                            phi_2667_ = true;
                                                            break;
                                                        }
                                                        let _e804 = global_1.member[_e799].member_1;
                                                        phi_1094_ = _e804;
                                                    } else {
                                                        phi_1094_ = 4294967295u;
                                                    }
                                                    let _e806 = phi_1094_;
                                                    if (_e799 >= _e75) {
                                                        phi_1186_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e800 {
                                                        } else {
                                                            phi_2667_ = true;
                                                            break;
                                                        }
                                                        let _e808 = (_e225 % 3u);
                                                        let _e809 = (_e224 % 3u);
                                                        let _e810 = (_e226 % 3u);
                                                        if (_e808 < 9u) {
                                                        } else {
                                                            phi_2667_ = true;
                                                            break;
                                                        }
                                                        let _e816 = global_1.member[_e799].member[_e808];
                                                        if (_e809 < 9u) {
                                                        } else {
                                                            phi_2667_ = true;
                                                            break;
                                                        }
                                                        let _e822 = global_1.member[_e799].member[_e809];
                                                        if (_e810 < 9u) {
                                                        } else {
                                                            phi_2667_ = true;
                                                            break;
                                                        }
                                                        let _e828 = global_1.member[_e799].member[_e810];
                                                        let _e830 = (3u + _e808);
                                                        if (_e830 < 9u) {
                                                        } else {
                                                            phi_2667_ = true;
                                                            break;
                                                        }
                                                        let _e836 = global_1.member[_e799].member[_e830];
                                                        let _e837 = (3u + _e809);
                                                        if (_e837 < 9u) {
                                                        } else {
                                                            phi_2667_ = true;
                                                            break;
                                                        }
                                                        let _e843 = global_1.member[_e799].member[_e837];
                                                        let _e844 = (3u + _e810);
                                                        if (_e844 < 9u) {
                                                        } else {
                                                            phi_2667_ = true;
                                                            break;
                                                        }
                                                        let _e850 = global_1.member[_e799].member[_e844];
                                                        let _e852 = (6u + _e808);
                                                        if (_e852 < 9u) {
                                                        } else {
                                                            phi_2667_ = true;
                                                            break;
                                                        }
                                                        let _e858 = global_1.member[_e799].member[_e852];
                                                        let _e859 = (6u + _e809);
                                                        if (_e859 < 9u) {
                                                        } else {
                                                            phi_2667_ = true;
                                                            break;
                                                        }
                                                        let _e865 = global_1.member[_e799].member[_e859];
                                                        let _e866 = (6u + _e810);
                                                        if (_e866 < 9u) {
                                                        } else {
                                                            phi_2667_ = true;
                                                            break;
                                                        }
                                                        let _e872 = global_1.member[_e799].member[_e866];
                                                        phi_1186_ = array<array<f32, 3>, 3>(array<f32, 3>(_e816, _e822, _e828), array<f32, 3>(_e836, _e843, _e850), array<f32, 3>(_e858, _e865, _e872));
                                                    }
                                                    let _e876 = phi_1186_;
                                                    let _e892 = (_e876[0][2] - _e401);
                                                    let _e895 = (((_e876[0][0] - _e272) * _e437) - (_e892 * _e309));
                                                    let _e898 = (((_e876[0][1] - _e337) * _e437) - (_e892 * _e373));
                                                    let _e901 = (_e876[1][2] - _e401);
                                                    let _e904 = (((_e876[1][0] - _e272) * _e437) - (_e901 * _e309));
                                                    let _e907 = (((_e876[1][1] - _e337) * _e437) - (_e901 * _e373));
                                                    let _e910 = (_e876[2][2] - _e401);
                                                    let _e913 = (((_e876[2][0] - _e272) * _e437) - (_e910 * _e309));
                                                    let _e916 = (((_e876[2][1] - _e337) * _e437) - (_e910 * _e373));
                                                    let _e917 = (_e913 * _e907);
                                                    let _e918 = (_e916 * _e904);
                                                    let _e919 = (_e895 * _e916);
                                                    let _e920 = (_e898 * _e913);
                                                    let _e921 = (_e904 * _e898);
                                                    let _e922 = (_e907 * _e895);
                                                    let _e927 = (((_e917 >= _e918) && (_e919 >= _e920)) && (_e921 >= _e922));
                                                    let _e933 = (_e927 || (((_e917 <= _e918) && (_e919 <= _e920)) && (_e921 <= _e922)));
                                                    if _e933 {
                                                        let _e935 = select(-1f, 1f, _e927);
                                                        let _e937 = ((_e917 - _e918) * _e935);
                                                        let _e939 = select(0f, _e937, (_e937 > 0f));
                                                        let _e941 = ((_e919 - _e920) * _e935);
                                                        let _e943 = select(0f, _e941, (_e941 > 0f));
                                                        let _e945 = ((_e921 - _e922) * _e935);
                                                        let _e947 = select(0f, _e945, (_e945 > 0f));
                                                        let _e949 = ((_e939 + _e943) + _e947);
                                                        let _e951 = select(_e876[1][0], _e876[0][0], (_e876[0][0] < _e876[1][0]));
                                                        let _e955 = select(_e876[1][0], _e876[0][0], (_e876[0][0] > _e876[1][0]));
                                                        let _e959 = select(_e876[1][1], _e876[0][1], (_e876[0][1] < _e876[1][1]));
                                                        let _e963 = select(_e876[1][1], _e876[0][1], (_e876[0][1] > _e876[1][1]));
                                                        let _e967 = select(_e876[1][2], _e876[0][2], (_e876[0][2] < _e876[1][2]));
                                                        let _e971 = select(_e876[1][2], _e876[0][2], (_e876[0][2] > _e876[1][2]));
                                                        let _e976 = ((select(_e876[2][0], _e951, (_e951 < _e876[2][0])) - _e310) * _e313);
                                                        let _e977 = ((select(_e876[2][0], _e955, (_e955 > _e876[2][0])) - _e311) * _e313);
                                                        let _e980 = ((select(_e876[2][1], _e959, (_e959 < _e876[2][1])) - _e374) * _e377);
                                                        let _e981 = ((select(_e876[2][1], _e963, (_e963 > _e876[2][1])) - _e375) * _e377);
                                                        let _e984 = ((select(_e876[2][2], _e967, (_e967 < _e876[2][2])) - _e438) * _e441);
                                                        let _e985 = ((select(_e876[2][2], _e971, (_e971 > _e876[2][2])) - _e439) * _e441);
                                                        let _e987 = select(_e985, _e984, (_e984 < _e985));
                                                        let _e989 = select(_e985, _e984, (_e984 > _e985));
                                                        let _e991 = select(_e977, _e976, (_e976 < _e977));
                                                        let _e993 = select(_e981, _e980, (_e980 < _e981));
                                                        let _e995 = select(_e993, _e991, (_e991 > _e993));
                                                        let _e997 = select(_e987, _e995, (_e995 > _e987));
                                                        let _e999 = select(_e977, _e976, (_e976 > _e977));
                                                        let _e1001 = select(_e981, _e980, (_e980 > _e981));
                                                        let _e1003 = select(_e1001, _e999, (_e999 < _e1001));
                                                        let _e1005 = select(_e989, _e1003, (_e1003 < _e989));
                                                        let _e1006 = -(_e987);
                                                        let _e1012 = select(_e543, _e997, (_e997 > _e543));
                                                        let _e1016 = select(_e904, _e895, (_e895 < _e904));
                                                        let _e1021 = select(_e904, _e895, (_e895 > _e904));
                                                        let _e1028 = select(_e907, _e898, (_e898 < _e907));
                                                        let _e1033 = select(_e907, _e898, (_e898 > _e907));
                                                        let _e1042 = (((((_e933 && (_e949 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e913, _e1016, (_e1016 < _e913)) <= 0f) && (select(_e913, _e1021, (_e1021 > _e913)) >= 0f))) && ((select(_e916, _e1028, (_e1028 < _e916)) <= 0f) && (select(_e916, _e1033, (_e1033 > _e916)) >= 0f))) && (_e1012 <= (_e1005 + (select(_e1006, _e989, (_e989 > _e1006)) * 0.0000019073523f)))) && (_e1012 <= _e777.member));
                                                        if _e1042 {
                                                            let _e1047 = (_e876[1][0] - _e876[0][0]);
                                                            let _e1048 = (_e876[1][1] - _e876[0][1]);
                                                            let _e1049 = (_e876[1][2] - _e876[0][2]);
                                                            let _e1050 = vec3<f32>(_e1047, _e1048, _e1049);
                                                            let _e1051 = (_e876[2][0] - _e876[1][0]);
                                                            let _e1052 = (_e876[2][1] - _e876[1][1]);
                                                            let _e1053 = (_e876[2][2] - _e876[1][2]);
                                                            let _e1054 = vec3<f32>(_e1051, _e1052, _e1053);
                                                            let _e1055 = (_e876[0][0] - _e876[2][0]);
                                                            let _e1056 = (_e876[0][1] - _e876[2][1]);
                                                            let _e1057 = (_e876[0][2] - _e876[2][2]);
                                                            let _e1058 = vec3<f32>(_e1055, _e1056, _e1057);
                                                            let _e1061 = bitcast<f32>((bitcast<u32>(_e1047) & 2147483647u));
                                                            let _e1064 = bitcast<f32>((bitcast<u32>(_e1048) & 2147483647u));
                                                            let _e1066 = select(_e1064, _e1061, (_e1061 > _e1064));
                                                            let _e1069 = bitcast<f32>((bitcast<u32>(_e1049) & 2147483647u));
                                                            let _e1071 = select(_e1069, _e1066, (_e1066 > _e1069));
                                                            let _e1074 = bitcast<f32>((bitcast<u32>(_e1051) & 2147483647u));
                                                            let _e1077 = bitcast<f32>((bitcast<u32>(_e1052) & 2147483647u));
                                                            let _e1079 = select(_e1077, _e1074, (_e1074 > _e1077));
                                                            let _e1082 = bitcast<f32>((bitcast<u32>(_e1053) & 2147483647u));
                                                            let _e1084 = select(_e1082, _e1079, (_e1079 > _e1082));
                                                            let _e1087 = bitcast<f32>((bitcast<u32>(_e1055) & 2147483647u));
                                                            let _e1090 = bitcast<f32>((bitcast<u32>(_e1056) & 2147483647u));
                                                            let _e1092 = select(_e1090, _e1087, (_e1087 > _e1090));
                                                            let _e1095 = bitcast<f32>((bitcast<u32>(_e1057) & 2147483647u));
                                                            let _e1097 = select(_e1095, _e1092, (_e1092 > _e1095));
                                                            let _e1099 = select(_e1084, _e1071, (_e1071 > _e1084));
                                                            let _e1101 = select(_e1097, _e1099, (_e1099 > _e1097));
                                                            if (_e1071 == _e1101) {
                                                                phi_1716_ = _e907;
                                                                phi_1717_ = _e904;
                                                                phi_1718_ = _e898;
                                                                phi_1719_ = _e895;
                                                                phi_1720_ = vec3<f32>(_e876[0][0], _e876[0][1], _e876[0][2]);
                                                                phi_1721_ = _e1058;
                                                                phi_1722_ = _e1054;
                                                                phi_1723_ = _e1050;
                                                            } else {
                                                                let _e1103 = (_e1084 == _e1101);
                                                                let _e1108 = vec3(_e1103);
                                                                phi_1716_ = select(_e898, _e916, _e1103);
                                                                phi_1717_ = select(_e895, _e913, _e1103);
                                                                phi_1718_ = select(_e916, _e907, _e1103);
                                                                phi_1719_ = select(_e913, _e904, _e1103);
                                                                phi_1720_ = select(vec3<f32>(_e876[2][0], _e876[2][1], _e876[2][2]), vec3<f32>(_e876[1][0], _e876[1][1], _e876[1][2]), _e1108);
                                                                phi_1721_ = select(_e1054, _e1050, _e1108);
                                                                phi_1722_ = select(_e1050, _e1058, _e1108);
                                                                phi_1723_ = select(_e1058, _e1054, _e1108);
                                                            }
                                                            let _e1114 = phi_1716_;
                                                            let _e1116 = phi_1717_;
                                                            let _e1118 = phi_1718_;
                                                            let _e1120 = phi_1719_;
                                                            let _e1122 = phi_1720_;
                                                            let _e1124 = phi_1721_;
                                                            let _e1126 = phi_1722_;
                                                            let _e1128 = phi_1723_;
                                                            let _e1135 = ((_e1126.y * _e1124.z) - (_e1124.y * _e1126.z));
                                                            let _e1140 = ((_e1126.z * _e1124.x) - (_e1124.z * _e1126.x));
                                                            let _e1143 = ((_e1126.x * _e1124.y) - (_e1124.x * _e1126.y));
                                                            let _e1146 = ((_e939 >= _e943) && (_e939 >= _e947));
                                                            let _e1147 = (_e943 >= _e947);
                                                            let _e1161 = (((_e1135 * (select(select(_e876[2][0], _e876[1][0], _e1147), _e876[0][0], _e1146) - _e272)) + (_e1140 * (select(select(_e876[2][1], _e876[1][1], _e1147), _e876[0][1], _e1146) - _e337))) + (_e1143 * (select(select(_e876[2][2], _e876[1][2], _e1147), _e876[0][2], _e1146) - _e401)));
                                                            let _e1166 = (((_e1135 * _e309) + (_e1140 * _e373)) + (_e1143 * _e437));
                                                            let _e1167 = (_e1116 - _e1120);
                                                            let _e1168 = (_e1114 - _e1118);
                                                            let _e1171 = ((_e1167 * _e1167) + (_e1168 * _e1168));
                                                            let _e1178 = (-(((_e1120 * _e1167) + (_e1118 * _e1168))) / select(0.000000000000000000000000000000000000011754944f, _e1171, (_e1171 > 0.000000000000000000000000000000000000011754944f)));
                                                            let _e1180 = select(1f, _e1178, (_e1178 < 1f));
                                                            let _e1182 = select(0f, _e1180, (_e1180 > 0f));
                                                            let _e1191 = ((_e1122.x + (_e1128.x * _e1182)) - _e272);
                                                            let _e1194 = ((_e1122.y + (_e1128.y * _e1182)) - _e337);
                                                            let _e1197 = ((_e1122.z + (_e1128.z * _e1182)) - _e401);
                                                            let _e1200 = bitcast<f32>((bitcast<u32>(_e1191) & 2147483647u));
                                                            let _e1203 = bitcast<f32>((bitcast<u32>(_e1194) & 2147483647u));
                                                            let _e1205 = select(_e1203, _e1200, (_e1200 > _e1203));
                                                            let _e1208 = bitcast<f32>((bitcast<u32>(_e1197) & 2147483647u));
                                                            let _e1210 = select(_e1208, _e1205, (_e1205 > _e1208));
                                                            let _e1216 = bitcast<f32>((bitcast<u32>(_e1135) & 2147483647u));
                                                            let _e1219 = bitcast<f32>((bitcast<u32>(_e1140) & 2147483647u));
                                                            let _e1221 = select(_e1219, _e1216, (_e1216 > _e1219));
                                                            let _e1224 = bitcast<f32>((bitcast<u32>(_e1143) & 2147483647u));
                                                            let _e1243 = bitcast<f32>((bitcast<u32>(_e1126.x) & 2147483647u));
                                                            let _e1246 = bitcast<f32>((bitcast<u32>(_e1126.y) & 2147483647u));
                                                            let _e1248 = select(_e1246, _e1243, (_e1243 > _e1246));
                                                            let _e1251 = bitcast<f32>((bitcast<u32>(_e1126.z) & 2147483647u));
                                                            let _e1257 = bitcast<f32>((bitcast<u32>(_e1124.x) & 2147483647u));
                                                            let _e1260 = bitcast<f32>((bitcast<u32>(_e1124.y) & 2147483647u));
                                                            let _e1262 = select(_e1260, _e1257, (_e1257 > _e1260));
                                                            let _e1265 = bitcast<f32>((bitcast<u32>(_e1124.z) & 2147483647u));
                                                            let _e1271 = ((bitcast<f32>((bitcast<u32>(((((_e1135 * _e1191) + (_e1140 * _e1194)) + (_e1143 * _e1197)) - _e1161)) & 2147483647u)) <= ((0.0000009536743f * select(_e1101, _e1210, (_e1210 > _e1101))) * select(_e1224, _e1221, (_e1221 > _e1224)))) && !((bitcast<f32>((bitcast<u32>(_e1166) & 2147483647u)) <= ((0.0000038146973f * select(_e1251, _e1248, (_e1248 > _e1251))) * select(_e1265, _e1262, (_e1262 > _e1265))))));
                                                            let _e1272 = (_e1161 / _e1166);
                                                            if (_e1042 && !(_e1271)) {
                                                                let _e1275 = (_e1197 / _e437);
                                                                let _e1283 = (((_e1135 * (_e1191 - (_e309 * _e1275))) + (_e1140 * (_e1194 - (_e373 * _e1275)))) / _e1166);
                                                                phi_1914_ = select(select(_e1275, (_e1275 + _e1283), (bitcast<f32>((bitcast<u32>(_e1283) & 2147483647u)) <= _e1101)), _e1272, _e1271);
                                                            } else {
                                                                phi_1914_ = _e1272;
                                                            }
                                                            let _e1292 = phi_1914_;
                                                            let _e1294 = select(_e1005, _e1292, (_e1292 < _e1005));
                                                            let _e1296 = select(_e997, _e1294, (_e1294 > _e997));
                                                            let _e1297 = (1f / _e949);
                                                            phi_1934_ = type_47(_e1296, (_e943 * _e1297), (_e947 * _e1297), ((_e1042 && (_e1296 >= _e543)) && (_e1296 <= _e777.member)));
                                                            phi_1935_ = type_47();
                                                        } else {
                                                            phi_1934_ = type_47();
                                                            phi_1935_ = type_47(0f, 0f, 0f, _e1042);
                                                        }
                                                        let _e1306 = phi_1934_;
                                                        let _e1308 = phi_1935_;
                                                        phi_1938_ = _e1306;
                                                        phi_1939_ = _e1308;
                                                        phi_1940_ = select(true, false, _e1042);
                                                    } else {
                                                        phi_1938_ = type_47();
                                                        phi_1939_ = type_47(0f, 0f, 0f, _e933);
                                                        phi_1940_ = true;
                                                    }
                                                    let _e1311 = phi_1938_;
                                                    let _e1313 = phi_1939_;
                                                    let _e1315 = phi_1940_;
                                                    if _e1315 {
                                                        phi_1944_ = _e1313;
                                                    } else {
                                                        phi_1944_ = _e1311;
                                                    }
                                                    let _e1317 = phi_1944_;
                                                    if _e1317.member_3 {
                                                        phi_1953_ = type_22(_e1317.member, _e1317.member_1, _e1317.member_2, _e806);
                                                    } else {
                                                        phi_1953_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    }
                                                    let _e1324 = phi_1953_;
                                                    if (_e1324.member_3 != 4294967295u) {
                                                        if (_e806 != _e92) {
                                                            phi_1964_ = type_49(-340282350000000000000000000000000000000f, true);
                                                        } else {
                                                            phi_1964_ = _e777;
                                                        }
                                                        let _e1329 = phi_1964_;
                                                        phi_1965_ = _e1329;
                                                    } else {
                                                        phi_1965_ = _e777;
                                                    }
                                                    let _e1331 = phi_1965_;
                                                    phi_1048_ = _e1331;
                                                } else {
                                                    phi_1048_ = type_49();
                                                }
                                                let _e1333 = phi_1048_;
                                                continue;
                                                continuing {
                                                    phi_1047_ = _e1333;
                                                    phi_1050_ = _e792;
                                                    phi_2667_ = _e551;
                                                    break if !(_e798);
                                                }
                                            }
                                            let _e1336 = phi_2667_;
                                            phi_2821_ = _e1336;
                                            if _e1336 {
                                                break;
                                            }
                                            let _e1338 = local_2;
                                            phi_2825_ = _e1336;
                                            let _e1505 = local_4;
                                            phi_2442_ = _e1505;
                                            phi_2443_ = false;
                                            phi_2444_ = _e578;
                                            phi_2445_ = select(_e580, 0u, (_e543 > _e1338.member));
                                        } else {
                                            if (_e578 >= _e73) {
                                                phi_2030_ = type_48(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                            } else {
                                                if (_e578 < _e73) {
                                                } else {
                                                    phi_2821_ = true;
                                                    break;
                                                }
                                                let _e590 = (_e225 % 3u);
                                                if (_e590 < 3u) {
                                                } else {
                                                    phi_2821_ = true;
                                                    break;
                                                }
                                                let _e596 = global_2.member[_e578].member[_e590];
                                                let _e602 = (_e224 % 3u);
                                                if (_e602 < 3u) {
                                                } else {
                                                    phi_2821_ = true;
                                                    break;
                                                }
                                                let _e608 = global_2.member[_e578].member[_e602];
                                                let _e614 = (_e226 % 3u);
                                                if (_e614 < 3u) {
                                                } else {
                                                    phi_2821_ = true;
                                                    break;
                                                }
                                                let _e620 = global_2.member[_e578].member[_e614];
                                                let _e630 = global_2.member[_e578].member_1;
                                                let _e634 = global_2.member[_e578].member_2;
                                                phi_2030_ = type_48(array<vec4<f32>, 3>(vec4<f32>(_e596[0], _e596[1], _e596[2], _e596[3]), vec4<f32>(_e608[0], _e608[1], _e608[2], _e608[3]), vec4<f32>(_e620[0], _e620[1], _e620[2], _e620[3])), _e630, _e634);
                                            }
                                            let _e637 = phi_2030_;
                                            let _e649 = ((_e637.member[0].x - _e310) * _e313);
                                            let _e650 = ((_e637.member[0].y - _e310) * _e313);
                                            let _e651 = ((_e637.member[0].z - _e311) * _e313);
                                            let _e652 = ((_e637.member[0].w - _e311) * _e313);
                                            let _e662 = ((_e637.member[1].x - _e374) * _e377);
                                            let _e663 = ((_e637.member[1].y - _e374) * _e377);
                                            let _e664 = ((_e637.member[1].z - _e375) * _e377);
                                            let _e665 = ((_e637.member[1].w - _e375) * _e377);
                                            let _e675 = ((_e637.member[2].x - _e438) * _e441);
                                            let _e676 = ((_e637.member[2].y - _e438) * _e441);
                                            let _e677 = ((_e637.member[2].z - _e439) * _e441);
                                            let _e678 = ((_e637.member[2].w - _e439) * _e441);
                                            let _e680 = select(_e677, _e675, (_e675 < _e677));
                                            let _e682 = select(_e678, _e676, (_e676 < _e678));
                                            let _e684 = select(_e677, _e675, (_e675 > _e677));
                                            let _e686 = select(_e678, _e676, (_e676 > _e678));
                                            let _e688 = select(_e651, _e649, (_e649 < _e651));
                                            let _e690 = select(_e652, _e650, (_e650 < _e652));
                                            let _e692 = select(_e664, _e662, (_e662 < _e664));
                                            let _e694 = select(_e665, _e663, (_e663 < _e665));
                                            let _e696 = select(_e692, _e688, (_e688 > _e692));
                                            let _e698 = select(_e694, _e690, (_e690 > _e694));
                                            let _e700 = select(_e680, _e696, (_e696 > _e680));
                                            let _e702 = select(_e682, _e698, (_e698 > _e682));
                                            let _e704 = select(_e651, _e649, (_e649 > _e651));
                                            let _e706 = select(_e652, _e650, (_e650 > _e652));
                                            let _e708 = select(_e664, _e662, (_e662 > _e664));
                                            let _e710 = select(_e665, _e663, (_e663 > _e665));
                                            let _e712 = select(_e708, _e704, (_e704 < _e708));
                                            let _e714 = select(_e710, _e706, (_e706 < _e710));
                                            let _e719 = -(_e680);
                                            let _e720 = -(_e682);
                                            let _e727 = (select(_e684, _e712, (_e712 < _e684)) + (select(_e719, _e684, (_e684 > _e719)) * 0.0000019073523f));
                                            let _e728 = (select(_e686, _e714, (_e714 < _e686)) + (select(_e720, _e686, (_e686 > _e720)) * 0.0000019073523f));
                                            let _e730 = select(_e543, _e700, (_e700 > _e543));
                                            let _e732 = select(_e543, _e702, (_e702 > _e543));
                                            let _e737 = (_e730 <= select(_e553.member, _e727, (_e727 < _e553.member)));
                                            let _e738 = (_e732 <= select(_e553.member, _e728, (_e728 < _e553.member)));
                                            let _e739 = (_e730 <= _e732);
                                            if _e737 {
                                                if _e738 {
                                                    if _e739 {
                                                        phi_2392_ = _e637.member_2;
                                                    } else {
                                                        phi_2392_ = _e637.member_1;
                                                    }
                                                    let _e743 = phi_2392_;
                                                    let _e745 = (_e580 % 128u);
                                                    let _e746 = (_e745 < 128u);
                                                    if _e746 {
                                                    } else {
                                                        phi_2821_ = true;
                                                        break;
                                                    }
                                                    local_1[_e745] = _e743;
                                                    if _e746 {
                                                    } else {
                                                        phi_2821_ = true;
                                                        break;
                                                    }
                                                    local[_e745] = select(_e730, _e732, _e739);
                                                    if _e739 {
                                                        phi_2419_ = _e637.member_1;
                                                    } else {
                                                        phi_2419_ = _e637.member_2;
                                                    }
                                                    let _e753 = phi_2419_;
                                                    phi_2420_ = _e753;
                                                    phi_2421_ = (_e580 + 1u);
                                                } else {
                                                    phi_2420_ = u32();
                                                    phi_2421_ = u32();
                                                }
                                                let _e755 = phi_2420_;
                                                let _e757 = phi_2421_;
                                                phi_2423_ = _e755;
                                                phi_2424_ = _e757;
                                                phi_2425_ = select(true, false, _e738);
                                            } else {
                                                phi_2423_ = u32();
                                                phi_2424_ = u32();
                                                phi_2425_ = true;
                                            }
                                            let _e760 = phi_2423_;
                                            let _e762 = phi_2424_;
                                            let _e764 = phi_2425_;
                                            if _e764 {
                                                if _e737 {
                                                    phi_2434_ = _e637.member_1;
                                                } else {
                                                    phi_2434_ = _e637.member_2;
                                                }
                                                let _e768 = phi_2434_;
                                                phi_2439_ = select(_e738, true, _e737);
                                                phi_2440_ = _e768;
                                            } else {
                                                phi_2439_ = _e576;
                                                phi_2440_ = _e760;
                                            }
                                            let _e771 = phi_2439_;
                                            let _e773 = phi_2440_;
                                            phi_2825_ = _e551;
                                            phi_2442_ = _e553;
                                            phi_2443_ = _e771;
                                            phi_2444_ = _e773;
                                            phi_2445_ = select(_e762, _e580, _e764);
                                        }
                                        let _e1343 = phi_2825_;
                                        let _e1345 = phi_2442_;
                                        let _e1347 = phi_2443_;
                                        let _e1349 = phi_2444_;
                                        let _e1351 = phi_2445_;
                                        phi_2824_ = _e1343;
                                        phi_2446_ = _e1345;
                                        phi_2447_ = _e1347;
                                        phi_2448_ = _e1349;
                                        phi_2449_ = _e1351;
                                        phi_2450_ = (_e561 - 1u);
                                    } else {
                                        phi_2824_ = _e551;
                                        phi_2446_ = _e553;
                                        phi_2447_ = _e576;
                                        phi_2448_ = _e578;
                                        phi_2449_ = _e580;
                                        phi_2450_ = _e561;
                                    }
                                    let _e1353 = phi_2824_;
                                    let _e1355 = phi_2446_;
                                    let _e1357 = phi_2447_;
                                    let _e1359 = phi_2448_;
                                    let _e1361 = phi_2449_;
                                    let _e1363 = phi_2450_;
                                    phi_2823_ = _e1353;
                                    phi_2451_ = _e1355;
                                    phi_2452_ = _e1357;
                                    phi_2453_ = _e1359;
                                    phi_2454_ = _e1361;
                                    phi_2455_ = _e1363;
                                } else {
                                    phi_2823_ = _e551;
                                    phi_2451_ = type_49();
                                    phi_2452_ = bool();
                                    phi_2453_ = u32();
                                    phi_2454_ = u32();
                                    phi_2455_ = u32();
                                }
                                let _e1365 = phi_2823_;
                                let _e1367 = phi_2451_;
                                let _e1369 = phi_2452_;
                                let _e1371 = phi_2453_;
                                let _e1373 = phi_2454_;
                                let _e1375 = phi_2455_;
                                phi_2822_ = _e1365;
                                phi_979_ = _e1367;
                                phi_982_ = _e1369;
                                phi_984_ = _e1371;
                                phi_986_ = _e1373;
                                phi_988_ = _e1375;
                                phi_2456_ = _e565;
                            } else {
                                phi_2822_ = _e551;
                                phi_979_ = type_49();
                                phi_982_ = bool();
                                phi_984_ = u32();
                                phi_986_ = u32();
                                phi_988_ = u32();
                                phi_2456_ = false;
                            }
                            let _e1377 = phi_2822_;
                            let _e1379 = phi_979_;
                            let _e1381 = phi_982_;
                            let _e1383 = phi_984_;
                            let _e1385 = phi_986_;
                            let _e1387 = phi_988_;
                            let _e1389 = phi_2456_;
                            continue;
                            continuing {
                                phi_2673_ = _e1377;
                                phi_978_ = _e1379;
                                phi_981_ = _e1381;
                                phi_983_ = _e1383;
                                phi_985_ = _e1385;
                                phi_987_ = _e1387;
                                phi_2821_ = _e1377;
                                break if !(_e1389);
                            }
                        }
                        let _e1392 = phi_2821_;
                        if _e1392 {
                            break;
                        }
                        let _e1394 = local_3;
                        if _e1394.member_1 {
                        } else {
                            if _e93 {
                            } else {
                                break;
                            }
                            let _e1398 = global_5.member[_e85];
                            if _e86 {
                            } else {
                                break;
                            }
                            let _e1402 = global_4.member[_e85].member_1;
                            if _e93 {
                            } else {
                                break;
                            }
                            global_5.member[_e85] = type_24(_e1398.member, _e1398.member_1, _e1398.member_2, array<f32, 3>((_e1398.member_3[0] + (_e1402[0] * _e1398.member_1[0])), (_e1398.member_3[1] + (_e1402[1] * _e1398.member_1[1])), (_e1398.member_3[2] + (_e1402[2] * _e1398.member_1[2]))), _e1398.member_4);
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
fn trace_shadows(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
