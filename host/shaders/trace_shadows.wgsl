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
    var phi_214_: u32;
    var phi_363_: i32;
    var phi_364_: i32;
    var phi_374_: bool;
    var phi_384_: u32;
    var phi_385_: u32;
    var phi_387_: bool;
    var phi_392_: u32;
    var phi_425_: i32;
    var phi_443_: f32;
    var phi_449_: f32;
    var phi_489_: f32;
    var phi_495_: f32;
    var phi_568_: f32;
    var phi_574_: f32;
    var phi_614_: f32;
    var phi_620_: f32;
    var phi_693_: f32;
    var phi_699_: f32;
    var phi_739_: f32;
    var phi_745_: f32;
    var phi_864_: i32;
    var phi_886_: u32;
    var phi_887_: u32;
    var phi_924_: i32;
    var phi_946_: u32;
    var phi_947_: u32;
    var phi_955_: f32;
    var phi_956_: f32;
    var phi_2745_: bool;
    var phi_971_: type_49;
    var phi_974_: u32;
    var phi_976_: bool;
    var phi_978_: u32;
    var phi_980_: u32;
    var phi_991_: bool;
    var phi_1023_: bool;
    var phi_1024_: u32;
    var phi_1025_: u32;
    var phi_1040_: type_49;
    var phi_1043_: type_7;
    var phi_1044_: type_7;
    var phi_1066_: type_7;
    var phi_1087_: u32;
    var phi_1179_: array<array<f32, 3>, 3>;
    var phi_2565_: bool;
    var phi_2580_: bool;
    var phi_2595_: bool;
    var phi_2610_: bool;
    var phi_2625_: bool;
    var phi_2640_: bool;
    var phi_1721_: f32;
    var phi_1722_: f32;
    var phi_1723_: f32;
    var phi_1724_: f32;
    var phi_1725_: vec3<f32>;
    var phi_1726_: vec3<f32>;
    var phi_1727_: vec3<f32>;
    var phi_1728_: vec3<f32>;
    var phi_2655_: bool;
    var phi_2670_: bool;
    var phi_2685_: bool;
    var phi_2700_: bool;
    var phi_2715_: bool;
    var phi_2730_: bool;
    var phi_1936_: f32;
    var phi_1956_: type_47;
    var phi_1957_: type_47;
    var phi_1960_: type_47;
    var phi_1961_: type_47;
    var phi_1962_: bool;
    var phi_1966_: type_47;
    var phi_1975_: type_22;
    var phi_1986_: type_49;
    var phi_1987_: type_49;
    var phi_1041_: type_49;
    var phi_2739_: bool;
    var phi_2940_: bool;
    var phi_1988_: type_49;
    var phi_2053_: type_48;
    var phi_2415_: u32;
    var phi_2442_: u32;
    var phi_2443_: u32;
    var phi_2444_: u32;
    var phi_2446_: u32;
    var phi_2447_: u32;
    var phi_2448_: bool;
    var phi_2457_: u32;
    var phi_2462_: bool;
    var phi_2464_: u32;
    var phi_2468_: bool;
    var phi_2469_: u32;
    var phi_2470_: u32;
    var phi_2480_: u32;
    var phi_2908_: bool;
    var phi_2482_: type_49;
    var phi_2483_: u32;
    var phi_2484_: bool;
    var phi_2485_: u32;
    var phi_2486_: u32;
    var phi_2907_: bool;
    var phi_2487_: type_49;
    var phi_2488_: u32;
    var phi_2489_: bool;
    var phi_2490_: u32;
    var phi_2491_: u32;
    var phi_2906_: bool;
    var phi_972_: type_49;
    var phi_975_: u32;
    var phi_977_: bool;
    var phi_979_: u32;
    var phi_981_: u32;
    var phi_2492_: bool;
    var phi_2905_: bool;
    var local_2: type_49;
    var local_3: type_49;

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
                phi_214_ = _e90;
            } else {
                phi_214_ = 4294967295u;
            }
            let _e92 = phi_214_;
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
                                phi_363_ = (bitcast<i32>((_e190 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_363_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e190)), 32u, (_e190 == 0u))));
                            }
                            let _e204 = phi_363_;
                            phi_364_ = _e204;
                        } else {
                            phi_364_ = 0i;
                        }
                        let _e206 = phi_364_;
                        let _e207 = (_e126 == _e170);
                        if _e207 {
                            phi_374_ = true;
                        } else {
                            phi_374_ = (_e134 == _e170);
                        }
                        let _e210 = phi_374_;
                        let _e211 = select(1u, 0u, _e207);
                        if _e210 {
                            let _e212 = (_e211 + 1u);
                            phi_384_ = _e212;
                            phi_385_ = _e212;
                            phi_387_ = select(true, false, (_e212 == 2u));
                        } else {
                            phi_384_ = u32();
                            phi_385_ = 0u;
                            phi_387_ = true;
                        }
                        let _e216 = phi_384_;
                        let _e218 = phi_385_;
                        let _e220 = phi_387_;
                        if _e220 {
                            phi_392_ = (_e218 + 1u);
                        } else {
                            phi_392_ = 0u;
                        }
                        let _e224 = phi_392_;
                        let _e225 = select(_e216, _e218, _e220);
                        let _e226 = select(_e211, select(2u, _e211, _e210), _e220);
                        let _e227 = -(_e206);
                        if (_e227 < -126i) {
                            phi_425_ = -126i;
                        } else {
                            phi_425_ = select(_e227, 127i, (_e227 > 127i));
                        }
                        let _e232 = phi_425_;
                        let _e237 = bitcast<f32>((bitcast<u32>((_e232 + 127i)) << bitcast<u32>(23i)));
                        let _e243 = bitcast<f32>((bitcast<u32>(((_e227 - _e232) + 127i)) << bitcast<u32>(23i)));
                        let _e248 = global_4.member[_e85].member.member;
                        let _e249 = (_e225 == 0u);
                        if _e249 {
                            phi_443_ = _e248[0];
                        } else {
                            phi_443_ = _e248[1];
                        }
                        let _e253 = phi_443_;
                        let _e254 = (_e225 == 2u);
                        if _e254 {
                            phi_449_ = _e248[2];
                        } else {
                            phi_449_ = _e253;
                        }
                        let _e257 = phi_449_;
                        let _e258 = bitcast<u32>(_e257);
                        let _e260 = ((_e258 & 2139095040u) != 0u);
                        let _e272 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e258 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e258 & 2147483648u))), _e257, _e260) * select(0.00000011920929f, 1f, _e260));
                        let _e273 = global_4.member[_e85].member.member_2;
                        if _e249 {
                            phi_489_ = _e273[0];
                        } else {
                            phi_489_ = _e273[1];
                        }
                        let _e277 = phi_489_;
                        if _e254 {
                            phi_495_ = _e273[2];
                        } else {
                            phi_495_ = _e277;
                        }
                        let _e280 = phi_495_;
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
                            phi_568_ = _e248[0];
                        } else {
                            phi_568_ = _e248[1];
                        }
                        let _e318 = phi_568_;
                        let _e319 = (_e224 == 2u);
                        if _e319 {
                            phi_574_ = _e248[2];
                        } else {
                            phi_574_ = _e318;
                        }
                        let _e322 = phi_574_;
                        let _e323 = bitcast<u32>(_e322);
                        let _e325 = ((_e323 & 2139095040u) != 0u);
                        let _e337 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e323 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e323 & 2147483648u))), _e322, _e325) * select(0.00000011920929f, 1f, _e325));
                        if _e314 {
                            phi_614_ = _e273[0];
                        } else {
                            phi_614_ = _e273[1];
                        }
                        let _e341 = phi_614_;
                        if _e319 {
                            phi_620_ = _e273[2];
                        } else {
                            phi_620_ = _e341;
                        }
                        let _e344 = phi_620_;
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
                            phi_693_ = _e248[0];
                        } else {
                            phi_693_ = _e248[1];
                        }
                        let _e382 = phi_693_;
                        let _e383 = (_e226 == 2u);
                        if _e383 {
                            phi_699_ = _e248[2];
                        } else {
                            phi_699_ = _e382;
                        }
                        let _e386 = phi_699_;
                        let _e387 = bitcast<u32>(_e386);
                        let _e389 = ((_e387 & 2139095040u) != 0u);
                        let _e401 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e387 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e387 & 2147483648u))), _e386, _e389) * select(0.00000011920929f, 1f, _e389));
                        if _e378 {
                            phi_739_ = _e273[0];
                        } else {
                            phi_739_ = _e273[1];
                        }
                        let _e405 = phi_739_;
                        if _e383 {
                            phi_745_ = _e273[2];
                        } else {
                            phi_745_ = _e405;
                        }
                        let _e408 = phi_745_;
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
                                phi_864_ = 255i;
                            } else {
                                phi_864_ = (((_e458 + select(0i, 1i, (_e458 == 0i))) - _e465) + _e206);
                            }
                            let _e473 = phi_864_;
                            let _e483 = (_e473 <= 0i);
                            if _e483 {
                                phi_887_ = u32();
                            } else {
                                if _e462 {
                                    phi_886_ = u32();
                                } else {
                                    phi_886_ = select(((bitcast<u32>(_e473) << bitcast<u32>(23i)) | ((_e455 << bitcast<u32>(((_e465 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e473 >= 255i));
                                }
                                let _e487 = phi_886_;
                                phi_887_ = _e487;
                            }
                            let _e489 = phi_887_;
                            let _e501 = ((_e183 & 8388607u) | (select(0u, 1u, ((_e183 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e504 = bitcast<i32>((_e183 >> bitcast<u32>(23i)));
                            let _e508 = (_e501 == 0u);
                            let _e511 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e501)), 32u, _e508)) - 8i);
                            if (_e504 == 255i) {
                                phi_924_ = 255i;
                            } else {
                                phi_924_ = (((_e504 + select(0i, 1i, (_e504 == 0i))) - _e511) + _e206);
                            }
                            let _e519 = phi_924_;
                            let _e529 = (_e519 <= 0i);
                            if _e529 {
                                phi_947_ = u32();
                            } else {
                                if _e508 {
                                    phi_946_ = u32();
                                } else {
                                    phi_946_ = select(((bitcast<u32>(_e519) << bitcast<u32>(23i)) | ((_e501 << bitcast<u32>(((_e511 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e519 >= 255i));
                                }
                                let _e533 = phi_946_;
                                phi_947_ = _e533;
                            }
                            let _e535 = phi_947_;
                            phi_955_ = bitcast<f32>(((_e182 & 2147483648u) | select(_e535, 0u, select(_e508, true, _e529))));
                            phi_956_ = bitcast<f32>(((_e177 & 2147483648u) | select(_e489, 0u, select(_e462, true, _e483))));
                        } else {
                            phi_955_ = 0f;
                            phi_956_ = 1f;
                        }
                        let _e541 = phi_955_;
                        let _e543 = phi_956_;
                        local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        phi_2745_ = false;
                        phi_971_ = type_49(_e541, false);
                        phi_974_ = ((3u * _e73) + 1u);
                        phi_976_ = (_e543 <= _e541);
                        phi_978_ = 0u;
                        phi_980_ = select(0u, 2147483648u, (_e73 == 0u));
                        loop {
                            let _e551 = phi_2745_;
                            let _e553 = phi_971_;
                            let _e555 = phi_974_;
                            let _e557 = phi_976_;
                            let _e559 = phi_978_;
                            let _e561 = phi_980_;
                            local_2 = _e553;
                            if _e557 {
                                phi_991_ = true;
                            } else {
                                phi_991_ = (_e559 > 0u);
                            }
                            let _e564 = phi_991_;
                            if _e564 {
                                let _e565 = (_e555 > 0u);
                                if _e565 {
                                    if _e557 {
                                        phi_1023_ = _e557;
                                        phi_1024_ = _e559;
                                        phi_1025_ = _e561;
                                    } else {
                                        let _e566 = (_e559 - 1u);
                                        let _e567 = (_e566 % 128u);
                                        let _e568 = (_e567 < 128u);
                                        if _e568 {
                                        } else {
                                            phi_2905_ = true;
                                            break;
                                        }
                                        let _e570 = local_1[_e567];
                                        if _e568 {
                                        } else {
                                            phi_2905_ = true;
                                            break;
                                        }
                                        let _e572 = local[_e567];
                                        phi_1023_ = (_e572 <= _e553.member);
                                        phi_1024_ = _e566;
                                        phi_1025_ = _e570;
                                    }
                                    let _e576 = phi_1023_;
                                    let _e578 = phi_1024_;
                                    let _e580 = phi_1025_;
                                    if _e576 {
                                        let _e583 = ((_e580 & 2147483648u) != 0u);
                                        if _e583 {
                                            phi_1040_ = _e553;
                                            phi_1043_ = type_7(0u, ((_e580 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e590 = phi_1040_;
                                                let _e592 = phi_1043_;
                                                local_3 = _e590;
                                                if (_e592.member < _e592.member_1) {
                                                    phi_1044_ = type_7((_e592.member + 1u), _e592.member_1);
                                                    phi_1066_ = type_7(1u, _e592.member);
                                                } else {
                                                    phi_1044_ = _e592;
                                                    phi_1066_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e605 = phi_1044_;
                                                let _e607 = phi_1066_;
                                                let _e611 = (bitcast<i32>(_e607.member) != 0i);
                                                if _e611 {
                                                    let _e612 = ((_e580 & 268435455u) + _e607.member_1);
                                                    let _e613 = (_e612 < _e75);
                                                    if _e613 {
                                                        if _e613 {
                                                        } else {
                                                            phi_2739_ = true;
                                                            break;
                                                        }
                                                        let _e617 = global_1.member[_e612].member_1;
                                                        phi_1087_ = _e617;
                                                    } else {
                                                        phi_1087_ = 4294967295u;
                                                    }
                                                    let _e619 = phi_1087_;
                                                    if (_e612 >= _e75) {
                                                        phi_1179_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e613 {
                                                        } else {
                                                            phi_2739_ = true;
                                                            break;
                                                        }
                                                        let _e621 = (_e225 % 3u);
                                                        let _e622 = (_e224 % 3u);
                                                        let _e623 = (_e226 % 3u);
                                                        if (_e621 < 9u) {
                                                        } else {
                                                            phi_2739_ = true;
                                                            break;
                                                        }
                                                        let _e629 = global_1.member[_e612].member[_e621];
                                                        if (_e622 < 9u) {
                                                        } else {
                                                            phi_2739_ = true;
                                                            break;
                                                        }
                                                        let _e635 = global_1.member[_e612].member[_e622];
                                                        if (_e623 < 9u) {
                                                        } else {
                                                            phi_2739_ = true;
                                                            break;
                                                        }
                                                        let _e641 = global_1.member[_e612].member[_e623];
                                                        let _e643 = (3u + _e621);
                                                        if (_e643 < 9u) {
                                                        } else {
                                                            phi_2739_ = true;
                                                            break;
                                                        }
                                                        let _e649 = global_1.member[_e612].member[_e643];
                                                        let _e650 = (3u + _e622);
                                                        if (_e650 < 9u) {
                                                        } else {
                                                            phi_2739_ = true;
                                                            break;
                                                        }
                                                        let _e656 = global_1.member[_e612].member[_e650];
                                                        let _e657 = (3u + _e623);
                                                        if (_e657 < 9u) {
                                                        } else {
                                                            phi_2739_ = true;
                                                            break;
                                                        }
                                                        let _e663 = global_1.member[_e612].member[_e657];
                                                        let _e665 = (6u + _e621);
                                                        if (_e665 < 9u) {
                                                        } else {
                                                            phi_2739_ = true;
                                                            break;
                                                        }
                                                        let _e671 = global_1.member[_e612].member[_e665];
                                                        let _e672 = (6u + _e622);
                                                        if (_e672 < 9u) {
                                                        } else {
                                                            phi_2739_ = true;
                                                            break;
                                                        }
                                                        let _e678 = global_1.member[_e612].member[_e672];
                                                        let _e679 = (6u + _e623);
                                                        if (_e679 < 9u) {
                                                        } else {
                                                            phi_2739_ = true;
                                                            break;
                                                        }
                                                        let _e685 = global_1.member[_e612].member[_e679];
                                                        phi_1179_ = array<array<f32, 3>, 3>(array<f32, 3>(_e629, _e635, _e641), array<f32, 3>(_e649, _e656, _e663), array<f32, 3>(_e671, _e678, _e685));
                                                    }
                                                    let _e689 = phi_1179_;
                                                    let _e705 = (_e689[0][2] - _e401);
                                                    let _e708 = (((_e689[0][0] - _e272) * _e437) - (_e705 * _e309));
                                                    let _e711 = (((_e689[0][1] - _e337) * _e437) - (_e705 * _e373));
                                                    let _e714 = (_e689[1][2] - _e401);
                                                    let _e717 = (((_e689[1][0] - _e272) * _e437) - (_e714 * _e309));
                                                    let _e720 = (((_e689[1][1] - _e337) * _e437) - (_e714 * _e373));
                                                    let _e723 = (_e689[2][2] - _e401);
                                                    let _e726 = (((_e689[2][0] - _e272) * _e437) - (_e723 * _e309));
                                                    let _e729 = (((_e689[2][1] - _e337) * _e437) - (_e723 * _e373));
                                                    let _e730 = (_e726 * _e720);
                                                    let _e731 = (_e729 * _e717);
                                                    let _e732 = (_e708 * _e729);
                                                    let _e733 = (_e711 * _e726);
                                                    let _e734 = (_e717 * _e711);
                                                    let _e735 = (_e720 * _e708);
                                                    let _e740 = (((_e730 >= _e731) && (_e732 >= _e733)) && (_e734 >= _e735));
                                                    let _e746 = (_e740 || (((_e730 <= _e731) && (_e732 <= _e733)) && (_e734 <= _e735)));
                                                    if _e746 {
                                                        let _e748 = select(-1f, 1f, _e740);
                                                        let _e750 = ((_e730 - _e731) * _e748);
                                                        let _e752 = select(0f, _e750, (_e750 > 0f));
                                                        let _e754 = ((_e732 - _e733) * _e748);
                                                        let _e756 = select(0f, _e754, (_e754 > 0f));
                                                        let _e758 = ((_e734 - _e735) * _e748);
                                                        let _e760 = select(0f, _e758, (_e758 > 0f));
                                                        let _e762 = ((_e752 + _e756) + _e760);
                                                        let _e764 = select(_e689[1][0], _e689[0][0], (_e689[0][0] < _e689[1][0]));
                                                        let _e768 = select(_e689[1][0], _e689[0][0], (_e689[0][0] > _e689[1][0]));
                                                        let _e772 = select(_e689[1][1], _e689[0][1], (_e689[0][1] < _e689[1][1]));
                                                        let _e776 = select(_e689[1][1], _e689[0][1], (_e689[0][1] > _e689[1][1]));
                                                        let _e780 = select(_e689[1][2], _e689[0][2], (_e689[0][2] < _e689[1][2]));
                                                        let _e784 = select(_e689[1][2], _e689[0][2], (_e689[0][2] > _e689[1][2]));
                                                        let _e789 = ((select(_e689[2][0], _e764, (_e764 < _e689[2][0])) - _e310) * _e313);
                                                        let _e790 = ((select(_e689[2][0], _e768, (_e768 > _e689[2][0])) - _e311) * _e313);
                                                        let _e793 = ((select(_e689[2][1], _e772, (_e772 < _e689[2][1])) - _e374) * _e377);
                                                        let _e794 = ((select(_e689[2][1], _e776, (_e776 > _e689[2][1])) - _e375) * _e377);
                                                        let _e797 = ((select(_e689[2][2], _e780, (_e780 < _e689[2][2])) - _e438) * _e441);
                                                        let _e798 = ((select(_e689[2][2], _e784, (_e784 > _e689[2][2])) - _e439) * _e441);
                                                        let _e800 = select(_e798, _e797, (_e797 < _e798));
                                                        let _e802 = select(_e798, _e797, (_e797 > _e798));
                                                        let _e804 = select(_e790, _e789, (_e789 < _e790));
                                                        let _e806 = select(_e794, _e793, (_e793 < _e794));
                                                        let _e808 = select(_e806, _e804, (_e804 > _e806));
                                                        let _e810 = select(_e800, _e808, (_e808 > _e800));
                                                        let _e812 = select(_e790, _e789, (_e789 > _e790));
                                                        let _e814 = select(_e794, _e793, (_e793 > _e794));
                                                        let _e816 = select(_e814, _e812, (_e812 < _e814));
                                                        let _e818 = select(_e802, _e816, (_e816 < _e802));
                                                        let _e819 = -(_e800);
                                                        let _e825 = select(_e543, _e810, (_e810 > _e543));
                                                        let _e829 = select(_e717, _e708, (_e708 < _e717));
                                                        let _e834 = select(_e717, _e708, (_e708 > _e717));
                                                        let _e841 = select(_e720, _e711, (_e711 < _e720));
                                                        let _e846 = select(_e720, _e711, (_e711 > _e720));
                                                        let _e855 = (((((_e746 && (_e762 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e726, _e829, (_e829 < _e726)) <= 0f) && (select(_e726, _e834, (_e834 > _e726)) >= 0f))) && ((select(_e729, _e841, (_e841 < _e729)) <= 0f) && (select(_e729, _e846, (_e846 > _e729)) >= 0f))) && (_e825 <= (_e818 + (select(_e819, _e802, (_e802 > _e819)) * 0.0000019073523f)))) && (_e825 <= _e590.member));
                                                        if _e855 {
                                                            let _e860 = (_e689[1][0] - _e689[0][0]);
                                                            let _e861 = (_e689[1][1] - _e689[0][1]);
                                                            let _e862 = (_e689[1][2] - _e689[0][2]);
                                                            let _e863 = vec3<f32>(_e860, _e861, _e862);
                                                            let _e864 = (_e689[2][0] - _e689[1][0]);
                                                            let _e865 = (_e689[2][1] - _e689[1][1]);
                                                            let _e866 = (_e689[2][2] - _e689[1][2]);
                                                            let _e867 = vec3<f32>(_e864, _e865, _e866);
                                                            let _e868 = (_e689[0][0] - _e689[2][0]);
                                                            let _e869 = (_e689[0][1] - _e689[2][1]);
                                                            let _e870 = (_e689[0][2] - _e689[2][2]);
                                                            let _e871 = vec3<f32>(_e868, _e869, _e870);
                                                            let _e872 = abs(_e860);
                                                            let _e873 = abs(_e861);
                                                            if (_e872 != _e872) {
                                                                phi_2565_ = true;
                                                            } else {
                                                                phi_2565_ = (_e873 >= _e872);
                                                            }
                                                            let _e877 = phi_2565_;
                                                            let _e878 = select(_e872, _e873, _e877);
                                                            let _e879 = abs(_e862);
                                                            if (_e878 != _e878) {
                                                                phi_2580_ = true;
                                                            } else {
                                                                phi_2580_ = (_e879 >= _e878);
                                                            }
                                                            let _e883 = phi_2580_;
                                                            let _e884 = select(_e878, _e879, _e883);
                                                            let _e885 = abs(_e864);
                                                            let _e886 = abs(_e865);
                                                            if (_e885 != _e885) {
                                                                phi_2595_ = true;
                                                            } else {
                                                                phi_2595_ = (_e886 >= _e885);
                                                            }
                                                            let _e890 = phi_2595_;
                                                            let _e891 = select(_e885, _e886, _e890);
                                                            let _e892 = abs(_e866);
                                                            if (_e891 != _e891) {
                                                                phi_2610_ = true;
                                                            } else {
                                                                phi_2610_ = (_e892 >= _e891);
                                                            }
                                                            let _e896 = phi_2610_;
                                                            let _e897 = select(_e891, _e892, _e896);
                                                            let _e898 = abs(_e868);
                                                            let _e899 = abs(_e869);
                                                            if (_e898 != _e898) {
                                                                phi_2625_ = true;
                                                            } else {
                                                                phi_2625_ = (_e899 >= _e898);
                                                            }
                                                            let _e903 = phi_2625_;
                                                            let _e904 = select(_e898, _e899, _e903);
                                                            let _e905 = abs(_e870);
                                                            if (_e904 != _e904) {
                                                                phi_2640_ = true;
                                                            } else {
                                                                phi_2640_ = (_e905 >= _e904);
                                                            }
                                                            let _e909 = phi_2640_;
                                                            let _e910 = select(_e904, _e905, _e909);
                                                            let _e912 = select(_e897, _e884, (_e884 > _e897));
                                                            let _e914 = select(_e910, _e912, (_e912 > _e910));
                                                            if (_e884 == _e914) {
                                                                phi_1721_ = _e720;
                                                                phi_1722_ = _e717;
                                                                phi_1723_ = _e711;
                                                                phi_1724_ = _e708;
                                                                phi_1725_ = vec3<f32>(_e689[0][0], _e689[0][1], _e689[0][2]);
                                                                phi_1726_ = _e871;
                                                                phi_1727_ = _e867;
                                                                phi_1728_ = _e863;
                                                            } else {
                                                                let _e916 = (_e897 == _e914);
                                                                let _e921 = vec3(_e916);
                                                                phi_1721_ = select(_e711, _e729, _e916);
                                                                phi_1722_ = select(_e708, _e726, _e916);
                                                                phi_1723_ = select(_e729, _e720, _e916);
                                                                phi_1724_ = select(_e726, _e717, _e916);
                                                                phi_1725_ = select(vec3<f32>(_e689[2][0], _e689[2][1], _e689[2][2]), vec3<f32>(_e689[1][0], _e689[1][1], _e689[1][2]), _e921);
                                                                phi_1726_ = select(_e867, _e863, _e921);
                                                                phi_1727_ = select(_e863, _e871, _e921);
                                                                phi_1728_ = select(_e871, _e867, _e921);
                                                            }
                                                            let _e927 = phi_1721_;
                                                            let _e929 = phi_1722_;
                                                            let _e931 = phi_1723_;
                                                            let _e933 = phi_1724_;
                                                            let _e935 = phi_1725_;
                                                            let _e937 = phi_1726_;
                                                            let _e939 = phi_1727_;
                                                            let _e941 = phi_1728_;
                                                            let _e948 = ((_e939.y * _e937.z) - (_e937.y * _e939.z));
                                                            let _e953 = ((_e939.z * _e937.x) - (_e937.z * _e939.x));
                                                            let _e956 = ((_e939.x * _e937.y) - (_e937.x * _e939.y));
                                                            let _e959 = ((_e752 >= _e756) && (_e752 >= _e760));
                                                            let _e960 = (_e756 >= _e760);
                                                            let _e974 = (((_e948 * (select(select(_e689[2][0], _e689[1][0], _e960), _e689[0][0], _e959) - _e272)) + (_e953 * (select(select(_e689[2][1], _e689[1][1], _e960), _e689[0][1], _e959) - _e337))) + (_e956 * (select(select(_e689[2][2], _e689[1][2], _e960), _e689[0][2], _e959) - _e401)));
                                                            let _e979 = (((_e948 * _e309) + (_e953 * _e373)) + (_e956 * _e437));
                                                            let _e980 = (_e929 - _e933);
                                                            let _e981 = (_e927 - _e931);
                                                            let _e984 = ((_e980 * _e980) + (_e981 * _e981));
                                                            let _e991 = (-(((_e933 * _e980) + (_e931 * _e981))) / select(0.000000000000000000000000000000000000011754944f, _e984, (_e984 > 0.000000000000000000000000000000000000011754944f)));
                                                            let _e993 = select(1f, _e991, (_e991 < 1f));
                                                            let _e995 = select(0f, _e993, (_e993 > 0f));
                                                            let _e1004 = ((_e935.x + (_e941.x * _e995)) - _e272);
                                                            let _e1007 = ((_e935.y + (_e941.y * _e995)) - _e337);
                                                            let _e1010 = ((_e935.z + (_e941.z * _e995)) - _e401);
                                                            let _e1013 = bitcast<f32>((bitcast<u32>(_e1004) & 2147483647u));
                                                            let _e1016 = bitcast<f32>((bitcast<u32>(_e1007) & 2147483647u));
                                                            let _e1018 = select(_e1016, _e1013, (_e1013 > _e1016));
                                                            let _e1021 = bitcast<f32>((bitcast<u32>(_e1010) & 2147483647u));
                                                            let _e1023 = select(_e1021, _e1018, (_e1018 > _e1021));
                                                            let _e1027 = abs(_e948);
                                                            let _e1028 = abs(_e953);
                                                            if (_e1027 != _e1027) {
                                                                phi_2655_ = true;
                                                            } else {
                                                                phi_2655_ = (_e1028 >= _e1027);
                                                            }
                                                            let _e1032 = phi_2655_;
                                                            let _e1033 = select(_e1027, _e1028, _e1032);
                                                            let _e1034 = abs(_e956);
                                                            if (_e1033 != _e1033) {
                                                                phi_2670_ = true;
                                                            } else {
                                                                phi_2670_ = (_e1034 >= _e1033);
                                                            }
                                                            let _e1038 = phi_2670_;
                                                            let _e1054 = abs(_e939.x);
                                                            let _e1055 = abs(_e939.y);
                                                            if (_e1054 != _e1054) {
                                                                phi_2685_ = true;
                                                            } else {
                                                                phi_2685_ = (_e1055 >= _e1054);
                                                            }
                                                            let _e1059 = phi_2685_;
                                                            let _e1060 = select(_e1054, _e1055, _e1059);
                                                            let _e1061 = abs(_e939.z);
                                                            if (_e1060 != _e1060) {
                                                                phi_2700_ = true;
                                                            } else {
                                                                phi_2700_ = (_e1061 >= _e1060);
                                                            }
                                                            let _e1065 = phi_2700_;
                                                            let _e1068 = abs(_e937.x);
                                                            let _e1069 = abs(_e937.y);
                                                            if (_e1068 != _e1068) {
                                                                phi_2715_ = true;
                                                            } else {
                                                                phi_2715_ = (_e1069 >= _e1068);
                                                            }
                                                            let _e1073 = phi_2715_;
                                                            let _e1074 = select(_e1068, _e1069, _e1073);
                                                            let _e1075 = abs(_e937.z);
                                                            if (_e1074 != _e1074) {
                                                                phi_2730_ = true;
                                                            } else {
                                                                phi_2730_ = (_e1075 >= _e1074);
                                                            }
                                                            let _e1079 = phi_2730_;
                                                            let _e1084 = ((bitcast<f32>((bitcast<u32>(((((_e948 * _e1004) + (_e953 * _e1007)) + (_e956 * _e1010)) - _e974)) & 2147483647u)) <= ((0.0000009536743f * select(_e914, _e1023, (_e1023 > _e914))) * select(_e1033, _e1034, _e1038))) && !((bitcast<f32>((bitcast<u32>(_e979) & 2147483647u)) <= ((0.0000038146973f * select(_e1060, _e1061, _e1065)) * select(_e1074, _e1075, _e1079)))));
                                                            let _e1085 = (_e974 / _e979);
                                                            if (_e855 && !(_e1084)) {
                                                                let _e1088 = (_e1010 / _e437);
                                                                let _e1096 = (((_e948 * (_e1004 - (_e309 * _e1088))) + (_e953 * (_e1007 - (_e373 * _e1088)))) / _e979);
                                                                phi_1936_ = select(select(_e1088, (_e1088 + _e1096), (bitcast<f32>((bitcast<u32>(_e1096) & 2147483647u)) <= _e914)), _e1085, _e1084);
                                                            } else {
                                                                phi_1936_ = _e1085;
                                                            }
                                                            let _e1105 = phi_1936_;
                                                            let _e1107 = select(_e818, _e1105, (_e1105 < _e818));
                                                            let _e1109 = select(_e810, _e1107, (_e1107 > _e810));
                                                            let _e1110 = (1f / _e762);
                                                            phi_1956_ = type_47(_e1109, (_e756 * _e1110), (_e760 * _e1110), ((_e855 && (_e1109 >= _e543)) && (_e1109 <= _e590.member)));
                                                            phi_1957_ = type_47();
                                                        } else {
                                                            phi_1956_ = type_47();
                                                            phi_1957_ = type_47(0f, 0f, 0f, _e855);
                                                        }
                                                        let _e1119 = phi_1956_;
                                                        let _e1121 = phi_1957_;
                                                        phi_1960_ = _e1119;
                                                        phi_1961_ = _e1121;
                                                        phi_1962_ = select(true, false, _e855);
                                                    } else {
                                                        phi_1960_ = type_47();
                                                        phi_1961_ = type_47(0f, 0f, 0f, _e746);
                                                        phi_1962_ = true;
                                                    }
                                                    let _e1124 = phi_1960_;
                                                    let _e1126 = phi_1961_;
                                                    let _e1128 = phi_1962_;
                                                    if _e1128 {
                                                        phi_1966_ = _e1126;
                                                    } else {
                                                        phi_1966_ = _e1124;
                                                    }
                                                    let _e1130 = phi_1966_;
                                                    if _e1130.member_3 {
                                                        phi_1975_ = type_22(_e1130.member, _e1130.member_1, _e1130.member_2, _e619);
                                                    } else {
                                                        phi_1975_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    }
                                                    let _e1137 = phi_1975_;
                                                    if (_e1137.member_3 != 4294967295u) {
                                                        if (_e619 != _e92) {
                                                            phi_1986_ = type_49(-340282350000000000000000000000000000000f, true);
                                                        } else {
                                                            phi_1986_ = _e590;
                                                        }
                                                        let _e1142 = phi_1986_;
                                                        phi_1987_ = _e1142;
                                                    } else {
                                                        phi_1987_ = _e590;
                                                    }
                                                    let _e1144 = phi_1987_;
                                                    phi_1041_ = _e1144;
                                                } else {
                                                    phi_1041_ = type_49();
                                                }
                                                let _e1146 = phi_1041_;
                                                continue;
                                                continuing {
                                                    phi_1040_ = _e1146;
                                                    phi_1043_ = _e605;
                                                    phi_2739_ = _e551;
                                                    break if !(_e611);
                                                }
                                            }
                                            let _e1149 = phi_2739_;
                                            phi_2905_ = _e1149;
                                            if _e1149 {
                                                break;
                                            }
                                            phi_2940_ = _e1149;
                                            let _e1506 = local_3;
                                            phi_1988_ = _e1506;
                                        } else {
                                            phi_2940_ = _e551;
                                            phi_1988_ = _e553;
                                        }
                                        let _e1151 = phi_2940_;
                                        let _e1153 = phi_1988_;
                                        if _e583 {
                                            phi_2468_ = bool();
                                            phi_2469_ = u32();
                                            phi_2470_ = u32();
                                        } else {
                                            if (_e580 >= _e73) {
                                                phi_2053_ = type_48(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                            } else {
                                                if (_e580 < _e73) {
                                                } else {
                                                    phi_2905_ = true;
                                                    break;
                                                }
                                                let _e1156 = (_e225 % 3u);
                                                if (_e1156 < 3u) {
                                                } else {
                                                    phi_2905_ = true;
                                                    break;
                                                }
                                                let _e1162 = global_2.member[_e580].member[_e1156];
                                                let _e1168 = (_e224 % 3u);
                                                if (_e1168 < 3u) {
                                                } else {
                                                    phi_2905_ = true;
                                                    break;
                                                }
                                                let _e1174 = global_2.member[_e580].member[_e1168];
                                                let _e1180 = (_e226 % 3u);
                                                if (_e1180 < 3u) {
                                                } else {
                                                    phi_2905_ = true;
                                                    break;
                                                }
                                                let _e1186 = global_2.member[_e580].member[_e1180];
                                                let _e1196 = global_2.member[_e580].member_1;
                                                let _e1200 = global_2.member[_e580].member_2;
                                                phi_2053_ = type_48(array<vec4<f32>, 3>(vec4<f32>(_e1162[0], _e1162[1], _e1162[2], _e1162[3]), vec4<f32>(_e1174[0], _e1174[1], _e1174[2], _e1174[3]), vec4<f32>(_e1186[0], _e1186[1], _e1186[2], _e1186[3])), _e1196, _e1200);
                                            }
                                            let _e1203 = phi_2053_;
                                            let _e1215 = ((_e1203.member[0].x - _e310) * _e313);
                                            let _e1216 = ((_e1203.member[0].y - _e310) * _e313);
                                            let _e1217 = ((_e1203.member[0].z - _e311) * _e313);
                                            let _e1218 = ((_e1203.member[0].w - _e311) * _e313);
                                            let _e1228 = ((_e1203.member[1].x - _e374) * _e377);
                                            let _e1229 = ((_e1203.member[1].y - _e374) * _e377);
                                            let _e1230 = ((_e1203.member[1].z - _e375) * _e377);
                                            let _e1231 = ((_e1203.member[1].w - _e375) * _e377);
                                            let _e1241 = ((_e1203.member[2].x - _e438) * _e441);
                                            let _e1242 = ((_e1203.member[2].y - _e438) * _e441);
                                            let _e1243 = ((_e1203.member[2].z - _e439) * _e441);
                                            let _e1244 = ((_e1203.member[2].w - _e439) * _e441);
                                            let _e1246 = select(_e1243, _e1241, (_e1241 < _e1243));
                                            let _e1248 = select(_e1244, _e1242, (_e1242 < _e1244));
                                            let _e1250 = select(_e1243, _e1241, (_e1241 > _e1243));
                                            let _e1252 = select(_e1244, _e1242, (_e1242 > _e1244));
                                            let _e1254 = select(_e1217, _e1215, (_e1215 < _e1217));
                                            let _e1256 = select(_e1218, _e1216, (_e1216 < _e1218));
                                            let _e1258 = select(_e1230, _e1228, (_e1228 < _e1230));
                                            let _e1260 = select(_e1231, _e1229, (_e1229 < _e1231));
                                            let _e1262 = select(_e1258, _e1254, (_e1254 > _e1258));
                                            let _e1264 = select(_e1260, _e1256, (_e1256 > _e1260));
                                            let _e1266 = select(_e1246, _e1262, (_e1262 > _e1246));
                                            let _e1268 = select(_e1248, _e1264, (_e1264 > _e1248));
                                            let _e1270 = select(_e1217, _e1215, (_e1215 > _e1217));
                                            let _e1272 = select(_e1218, _e1216, (_e1216 > _e1218));
                                            let _e1274 = select(_e1230, _e1228, (_e1228 > _e1230));
                                            let _e1276 = select(_e1231, _e1229, (_e1229 > _e1231));
                                            let _e1278 = select(_e1274, _e1270, (_e1270 < _e1274));
                                            let _e1280 = select(_e1276, _e1272, (_e1272 < _e1276));
                                            let _e1285 = -(_e1246);
                                            let _e1286 = -(_e1248);
                                            let _e1293 = (select(_e1250, _e1278, (_e1278 < _e1250)) + (select(_e1285, _e1250, (_e1250 > _e1285)) * 0.0000019073523f));
                                            let _e1294 = (select(_e1252, _e1280, (_e1280 < _e1252)) + (select(_e1286, _e1252, (_e1252 > _e1286)) * 0.0000019073523f));
                                            let _e1296 = select(_e543, _e1266, (_e1266 > _e543));
                                            let _e1298 = select(_e543, _e1268, (_e1268 > _e543));
                                            let _e1303 = (_e1296 <= select(_e1153.member, _e1293, (_e1293 < _e1153.member)));
                                            let _e1304 = (_e1298 <= select(_e1153.member, _e1294, (_e1294 < _e1153.member)));
                                            let _e1305 = (_e1296 <= _e1298);
                                            if _e1303 {
                                                if _e1304 {
                                                    if _e1305 {
                                                        phi_2415_ = _e1203.member_2;
                                                    } else {
                                                        phi_2415_ = _e1203.member_1;
                                                    }
                                                    let _e1309 = phi_2415_;
                                                    let _e1311 = (_e578 % 128u);
                                                    let _e1312 = (_e1311 < 128u);
                                                    if _e1312 {
                                                    } else {
                                                        phi_2905_ = true;
                                                        break;
                                                    }
                                                    local_1[_e1311] = _e1309;
                                                    if _e1312 {
                                                    } else {
                                                        phi_2905_ = true;
                                                        break;
                                                    }
                                                    local[_e1311] = select(_e1296, _e1298, _e1305);
                                                    if _e1305 {
                                                        phi_2442_ = _e1203.member_1;
                                                    } else {
                                                        phi_2442_ = _e1203.member_2;
                                                    }
                                                    let _e1319 = phi_2442_;
                                                    phi_2443_ = (_e578 + 1u);
                                                    phi_2444_ = _e1319;
                                                } else {
                                                    phi_2443_ = u32();
                                                    phi_2444_ = u32();
                                                }
                                                let _e1321 = phi_2443_;
                                                let _e1323 = phi_2444_;
                                                phi_2446_ = _e1321;
                                                phi_2447_ = _e1323;
                                                phi_2448_ = select(true, false, _e1304);
                                            } else {
                                                phi_2446_ = u32();
                                                phi_2447_ = u32();
                                                phi_2448_ = true;
                                            }
                                            let _e1326 = phi_2446_;
                                            let _e1328 = phi_2447_;
                                            let _e1330 = phi_2448_;
                                            if _e1330 {
                                                if _e1303 {
                                                    phi_2457_ = _e1203.member_1;
                                                } else {
                                                    phi_2457_ = _e1203.member_2;
                                                }
                                                let _e1334 = phi_2457_;
                                                phi_2462_ = select(_e1304, true, _e1303);
                                                phi_2464_ = _e1334;
                                            } else {
                                                phi_2462_ = _e576;
                                                phi_2464_ = _e1328;
                                            }
                                            let _e1337 = phi_2462_;
                                            let _e1339 = phi_2464_;
                                            phi_2468_ = _e1337;
                                            phi_2469_ = select(_e1326, _e578, _e1330);
                                            phi_2470_ = _e1339;
                                        }
                                        let _e1342 = phi_2468_;
                                        let _e1344 = phi_2469_;
                                        let _e1346 = phi_2470_;
                                        if _e583 {
                                            phi_2480_ = select(_e578, 0u, _e1153.member_1);
                                        } else {
                                            phi_2480_ = _e1344;
                                        }
                                        let _e1350 = phi_2480_;
                                        phi_2908_ = _e1151;
                                        phi_2482_ = _e1153;
                                        phi_2483_ = (_e555 - 1u);
                                        phi_2484_ = select(_e1342, false, _e583);
                                        phi_2485_ = _e1350;
                                        phi_2486_ = select(_e1346, _e580, _e583);
                                    } else {
                                        phi_2908_ = _e551;
                                        phi_2482_ = _e553;
                                        phi_2483_ = _e555;
                                        phi_2484_ = _e576;
                                        phi_2485_ = _e578;
                                        phi_2486_ = _e580;
                                    }
                                    let _e1354 = phi_2908_;
                                    let _e1356 = phi_2482_;
                                    let _e1358 = phi_2483_;
                                    let _e1360 = phi_2484_;
                                    let _e1362 = phi_2485_;
                                    let _e1364 = phi_2486_;
                                    phi_2907_ = _e1354;
                                    phi_2487_ = _e1356;
                                    phi_2488_ = _e1358;
                                    phi_2489_ = _e1360;
                                    phi_2490_ = _e1362;
                                    phi_2491_ = _e1364;
                                } else {
                                    phi_2907_ = _e551;
                                    phi_2487_ = type_49();
                                    phi_2488_ = u32();
                                    phi_2489_ = bool();
                                    phi_2490_ = u32();
                                    phi_2491_ = u32();
                                }
                                let _e1366 = phi_2907_;
                                let _e1368 = phi_2487_;
                                let _e1370 = phi_2488_;
                                let _e1372 = phi_2489_;
                                let _e1374 = phi_2490_;
                                let _e1376 = phi_2491_;
                                phi_2906_ = _e1366;
                                phi_972_ = _e1368;
                                phi_975_ = _e1370;
                                phi_977_ = _e1372;
                                phi_979_ = _e1374;
                                phi_981_ = _e1376;
                                phi_2492_ = _e565;
                            } else {
                                phi_2906_ = _e551;
                                phi_972_ = type_49();
                                phi_975_ = u32();
                                phi_977_ = bool();
                                phi_979_ = u32();
                                phi_981_ = u32();
                                phi_2492_ = false;
                            }
                            let _e1378 = phi_2906_;
                            let _e1380 = phi_972_;
                            let _e1382 = phi_975_;
                            let _e1384 = phi_977_;
                            let _e1386 = phi_979_;
                            let _e1388 = phi_981_;
                            let _e1390 = phi_2492_;
                            continue;
                            continuing {
                                phi_2745_ = _e1378;
                                phi_971_ = _e1380;
                                phi_974_ = _e1382;
                                phi_976_ = _e1384;
                                phi_978_ = _e1386;
                                phi_980_ = _e1388;
                                phi_2905_ = _e1378;
                                break if !(_e1390);
                            }
                        }
                        let _e1393 = phi_2905_;
                        if _e1393 {
                            break;
                        }
                        let _e1395 = local_2;
                        if _e1395.member_1 {
                        } else {
                            if _e93 {
                            } else {
                                break;
                            }
                            let _e1399 = global_5.member[_e85];
                            if _e86 {
                            } else {
                                break;
                            }
                            let _e1403 = global_4.member[_e85].member_1;
                            if _e93 {
                            } else {
                                break;
                            }
                            global_5.member[_e85] = type_24(_e1399.member, _e1399.member_1, _e1399.member_2, array<f32, 3>((_e1399.member_3[0] + (_e1403[0] * _e1399.member_1[0])), (_e1399.member_3[1] + (_e1403[1] * _e1399.member_1[1])), (_e1399.member_3[2] + (_e1403[2] * _e1399.member_1[2]))), _e1399.member_4);
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
