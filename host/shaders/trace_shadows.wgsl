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
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_48 {
    member: f32,
    member_1: bool,
}

struct type_52 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_1: type_15;
@group(0) @binding(0) 
var<storage> global_2: type_33;
@group(0) @binding(4) 
var<storage, read_write> global_3: type_52;
@group(0) @binding(2) 
var<storage> global_4: type_38;
@group(0) @binding(3) 
var<storage, read_write> global_5: type_26;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_179_: u32;
    var phi_328_: i32;
    var phi_329_: i32;
    var phi_339_: bool;
    var phi_349_: u32;
    var phi_350_: u32;
    var phi_352_: bool;
    var phi_357_: u32;
    var phi_389_: i32;
    var phi_407_: f32;
    var phi_413_: f32;
    var phi_424_: f32;
    var phi_430_: f32;
    var phi_453_: f32;
    var phi_464_: f32;
    var phi_473_: f32;
    var phi_479_: f32;
    var phi_490_: f32;
    var phi_496_: f32;
    var phi_519_: f32;
    var phi_530_: f32;
    var phi_539_: f32;
    var phi_545_: f32;
    var phi_556_: f32;
    var phi_562_: f32;
    var phi_585_: f32;
    var phi_596_: f32;
    var phi_696_: f32;
    var phi_697_: f32;
    var phi_2044_: bool;
    var phi_708_: type_48;
    var phi_711_: u32;
    var phi_713_: u32;
    var phi_715_: bool;
    var phi_717_: u32;
    var phi_728_: bool;
    var phi_760_: u32;
    var phi_761_: bool;
    var phi_762_: u32;
    var phi_1562_: type_47;
    var phi_1906_: u32;
    var phi_1934_: u32;
    var phi_1935_: u32;
    var phi_1936_: u32;
    var phi_1938_: u32;
    var phi_1939_: u32;
    var phi_1940_: bool;
    var phi_1949_: u32;
    var phi_1954_: u32;
    var phi_1955_: bool;
    var phi_777_: type_48;
    var phi_780_: type_7;
    var phi_781_: type_7;
    var phi_803_: type_7;
    var phi_824_: u32;
    var phi_913_: array<array<f32, 3>, 3>;
    var phi_1384_: vec3<f32>;
    var phi_1385_: vec3<f32>;
    var phi_1416_: bool;
    var phi_1425_: vec3<f32>;
    var phi_1465_: type_22;
    var phi_1467_: type_22;
    var phi_1468_: bool;
    var phi_1472_: type_22;
    var phi_1473_: type_22;
    var phi_1474_: type_22;
    var phi_1475_: bool;
    var phi_1479_: type_22;
    var phi_1480_: bool;
    var phi_1484_: type_22;
    var phi_1485_: bool;
    var phi_1489_: type_22;
    var phi_1500_: type_48;
    var phi_1501_: type_48;
    var phi_778_: type_48;
    var phi_2038_: bool;
    var local_2: type_48;
    var phi_2157_: bool;
    var phi_1957_: type_48;
    var phi_1958_: u32;
    var phi_1959_: bool;
    var phi_1960_: u32;
    var phi_2156_: bool;
    var phi_1961_: type_48;
    var phi_1962_: u32;
    var phi_1963_: u32;
    var phi_1964_: bool;
    var phi_1965_: u32;
    var phi_2155_: bool;
    var phi_1966_: type_48;
    var phi_1967_: u32;
    var phi_1968_: u32;
    var phi_1969_: bool;
    var phi_1970_: u32;
    var phi_2154_: bool;
    var phi_709_: type_48;
    var phi_712_: u32;
    var phi_714_: u32;
    var phi_716_: bool;
    var phi_718_: u32;
    var phi_1971_: bool;
    var phi_2153_: bool;
    var local_3: type_48;
    var local_4: type_48;

    switch bitcast<i32>(0u) {
        default: {
            let _e63 = global;
            let _e65 = arrayLength((&global_2.member));
            let _e67 = arrayLength((&global_1.member));
            let _e73 = arrayLength((&global_3.member));
            let _e77 = (_e63.x + (_e63.y * 2097152u));
            let _e78 = (_e77 < arrayLength((&global_4.member)));
            if _e78 {
                if _e78 {
                } else {
                    break;
                }
                let _e82 = global_4.member[_e77].member_2;
                phi_179_ = _e82;
            } else {
                phi_179_ = 4294967295u;
            }
            let _e84 = phi_179_;
            if _e78 {
                let _e85 = (_e77 < arrayLength((&global_5.member)));
                if _e85 {
                    if _e78 {
                    } else {
                        break;
                    }
                    let _e90 = global_4.member[_e77].member.member_1;
                    let _e95 = global_4.member[_e77].member.member_3;
                    if (_e90 <= _e95) {
                        let _e97 = (1u < _e73);
                        if _e97 {
                            if (0u < _e73) {
                            } else {
                                break;
                            }
                            let _e101 = atomicAdd((&global_3.member[0u]), 1u);
                            if ((_e101 + 1u) < _e101) {
                                if _e97 {
                                } else {
                                    break;
                                }
                                let _e106 = atomicAdd((&global_3.member[1u]), 1u);
                            }
                        }
                        if _e78 {
                        } else {
                            break;
                        }
                        let _e116 = global_4.member[_e77].member.member_2[0u];
                        let _e118 = (bitcast<u32>(_e116) & 2147483647u);
                        let _e124 = global_4.member[_e77].member.member_2[1u];
                        let _e126 = (bitcast<u32>(_e124) & 2147483647u);
                        let _e132 = global_4.member[_e77].member.member_2[2u];
                        let _e134 = (bitcast<u32>(_e132) & 2147483647u);
                        let _e140 = global_4.member[_e77].member.member[0u];
                        let _e142 = (bitcast<u32>(_e140) & 2147483647u);
                        let _e148 = global_4.member[_e77].member.member[1u];
                        let _e150 = (bitcast<u32>(_e148) & 2147483647u);
                        let _e156 = global_4.member[_e77].member.member[2u];
                        let _e158 = (bitcast<u32>(_e156) & 2147483647u);
                        let _e160 = select(_e126, _e118, (_e126 < _e118));
                        let _e162 = select(_e134, _e160, (_e134 < _e160));
                        let _e164 = select(_e142, _e162, (_e142 < _e162));
                        let _e166 = select(_e150, _e164, (_e150 < _e164));
                        let _e168 = select(_e158, _e166, (_e158 < _e166));
                        let _e170 = (bitcast<u32>(_e90) & 2147483647u);
                        let _e179 = (((select(_e170, _e168, (_e170 < _e168)) < 2139095040u) && ((bitcast<u32>(_e95) & 2147483647u) <= 2139095040u)) && (_e162 > 0u));
                        if _e179 {
                            let _e182 = (bitcast<u32>(bitcast<f32>(_e162)) & 2147483647u);
                            if (_e182 >= 8388608u) {
                                phi_328_ = (bitcast<i32>((_e182 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_328_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e182)), 32u, (_e182 == 0u))));
                            }
                            let _e196 = phi_328_;
                            phi_329_ = _e196;
                        } else {
                            phi_329_ = 0i;
                        }
                        let _e198 = phi_329_;
                        let _e199 = (_e118 == _e162);
                        if _e199 {
                            phi_339_ = true;
                        } else {
                            phi_339_ = (_e126 == _e162);
                        }
                        let _e202 = phi_339_;
                        let _e203 = select(1u, 0u, _e199);
                        if _e202 {
                            let _e204 = (_e203 + 1u);
                            phi_349_ = _e204;
                            phi_350_ = _e204;
                            phi_352_ = select(true, false, (_e204 == 2u));
                        } else {
                            phi_349_ = u32();
                            phi_350_ = 0u;
                            phi_352_ = true;
                        }
                        let _e208 = phi_349_;
                        let _e210 = phi_350_;
                        let _e212 = phi_352_;
                        if _e212 {
                            phi_357_ = (_e210 + 1u);
                        } else {
                            phi_357_ = 0u;
                        }
                        let _e216 = phi_357_;
                        let _e217 = select(_e208, _e210, _e212);
                        let _e218 = select(_e203, select(2u, _e203, _e202), _e212);
                        let _e219 = -(_e198);
                        if (_e219 < -126i) {
                            phi_389_ = -126i;
                        } else {
                            phi_389_ = select(_e219, 127i, (_e219 > 127i));
                        }
                        let _e224 = phi_389_;
                        let _e229 = bitcast<f32>((bitcast<u32>((_e224 + 127i)) << bitcast<u32>(23i)));
                        let _e235 = bitcast<f32>((bitcast<u32>(((_e219 - _e224) + 127i)) << bitcast<u32>(23i)));
                        let _e240 = global_4.member[_e77].member.member;
                        let _e241 = (_e217 == 0u);
                        if _e241 {
                            phi_407_ = _e240[0];
                        } else {
                            phi_407_ = _e240[1];
                        }
                        let _e245 = phi_407_;
                        let _e246 = (_e217 == 2u);
                        if _e246 {
                            phi_413_ = _e240[2];
                        } else {
                            phi_413_ = _e245;
                        }
                        let _e249 = phi_413_;
                        let _e250 = global_4.member[_e77].member.member_2;
                        if _e241 {
                            phi_424_ = _e250[0];
                        } else {
                            phi_424_ = _e250[1];
                        }
                        let _e254 = phi_424_;
                        if _e246 {
                            phi_430_ = _e250[2];
                        } else {
                            phi_430_ = _e254;
                        }
                        let _e257 = phi_430_;
                        let _e259 = ((_e257 * _e229) * _e235);
                        let _e263 = (bitcast<f32>((bitcast<u32>(_e259) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e263 {
                            let _e267 = (bitcast<f32>((bitcast<u32>(_e249) & 2147483647u)) * 0.00000011920929f);
                            phi_453_ = select(0.00000000000011368684f, _e267, (_e267 > 0.00000000000011368684f));
                        } else {
                            phi_453_ = 0f;
                        }
                        let _e271 = phi_453_;
                        let _e272 = (_e249 + _e271);
                        let _e273 = (_e249 - _e271);
                        let _e274 = select(_e259, 0f, _e263);
                        if _e263 {
                            phi_464_ = 38685626000000000000000000f;
                        } else {
                            phi_464_ = (1f / _e259);
                        }
                        let _e277 = phi_464_;
                        let _e278 = (_e216 == 0u);
                        if _e278 {
                            phi_473_ = _e240[0];
                        } else {
                            phi_473_ = _e240[1];
                        }
                        let _e282 = phi_473_;
                        let _e283 = (_e216 == 2u);
                        if _e283 {
                            phi_479_ = _e240[2];
                        } else {
                            phi_479_ = _e282;
                        }
                        let _e286 = phi_479_;
                        if _e278 {
                            phi_490_ = _e250[0];
                        } else {
                            phi_490_ = _e250[1];
                        }
                        let _e290 = phi_490_;
                        if _e283 {
                            phi_496_ = _e250[2];
                        } else {
                            phi_496_ = _e290;
                        }
                        let _e293 = phi_496_;
                        let _e295 = ((_e293 * _e229) * _e235);
                        let _e299 = (bitcast<f32>((bitcast<u32>(_e295) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e299 {
                            let _e303 = (bitcast<f32>((bitcast<u32>(_e286) & 2147483647u)) * 0.00000011920929f);
                            phi_519_ = select(0.00000000000011368684f, _e303, (_e303 > 0.00000000000011368684f));
                        } else {
                            phi_519_ = 0f;
                        }
                        let _e307 = phi_519_;
                        let _e308 = (_e286 + _e307);
                        let _e309 = (_e286 - _e307);
                        let _e310 = select(_e295, 0f, _e299);
                        if _e299 {
                            phi_530_ = 38685626000000000000000000f;
                        } else {
                            phi_530_ = (1f / _e295);
                        }
                        let _e313 = phi_530_;
                        let _e314 = (_e218 == 0u);
                        if _e314 {
                            phi_539_ = _e240[0];
                        } else {
                            phi_539_ = _e240[1];
                        }
                        let _e318 = phi_539_;
                        let _e319 = (_e218 == 2u);
                        if _e319 {
                            phi_545_ = _e240[2];
                        } else {
                            phi_545_ = _e318;
                        }
                        let _e322 = phi_545_;
                        if _e314 {
                            phi_556_ = _e250[0];
                        } else {
                            phi_556_ = _e250[1];
                        }
                        let _e326 = phi_556_;
                        if _e319 {
                            phi_562_ = _e250[2];
                        } else {
                            phi_562_ = _e326;
                        }
                        let _e329 = phi_562_;
                        let _e331 = ((_e329 * _e229) * _e235);
                        let _e335 = (bitcast<f32>((bitcast<u32>(_e331) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e335 {
                            let _e339 = (bitcast<f32>((bitcast<u32>(_e322) & 2147483647u)) * 0.00000011920929f);
                            phi_585_ = select(0.00000000000011368684f, _e339, (_e339 > 0.00000000000011368684f));
                        } else {
                            phi_585_ = 0f;
                        }
                        let _e343 = phi_585_;
                        let _e344 = (_e322 + _e343);
                        let _e345 = (_e322 - _e343);
                        let _e346 = select(_e331, 0f, _e335);
                        if _e335 {
                            phi_596_ = 38685626000000000000000000f;
                        } else {
                            phi_596_ = (1f / _e331);
                        }
                        let _e349 = phi_596_;
                        let _e352 = bitcast<f32>((bitcast<u32>(_e249) & 2147483647u));
                        let _e355 = bitcast<f32>((bitcast<u32>(_e286) & 2147483647u));
                        let _e357 = select(_e355, _e352, (_e352 > _e355));
                        let _e360 = bitcast<f32>((bitcast<u32>(_e322) & 2147483647u));
                        if (_e179 && (select(_e360, _e357, (_e357 > _e360)) <= 1099511600000f)) {
                            let _e365 = (_e198 / 3i);
                            let _e372 = bitcast<f32>((bitcast<u32>((_e365 + 127i)) << bitcast<u32>(23i)));
                            let _e379 = bitcast<f32>((bitcast<u32>(((_e198 - (2i * _e365)) + 127i)) << bitcast<u32>(23i)));
                            let _e380 = (((_e90 * _e372) * _e372) * _e379);
                            let _e382 = select(340282350000000000000000000000000000000f, _e380, (_e380 < 340282350000000000000000000000000000000f));
                            let _e387 = (((_e95 * _e372) * _e372) * _e379);
                            let _e389 = select(340282350000000000000000000000000000000f, _e387, (_e387 < 340282350000000000000000000000000000000f));
                            phi_696_ = select(-340282350000000000000000000000000000000f, _e389, (_e389 > -340282350000000000000000000000000000000f));
                            phi_697_ = select(-340282350000000000000000000000000000000f, _e382, (_e382 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_696_ = 0f;
                            phi_697_ = 1f;
                        }
                        let _e393 = phi_696_;
                        let _e395 = phi_697_;
                        local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        phi_2044_ = false;
                        phi_708_ = type_48(_e393, false);
                        phi_711_ = select(0u, 2147483648u, (_e65 == 0u));
                        phi_713_ = ((3u * _e65) + 1u);
                        phi_715_ = (_e395 <= _e393);
                        phi_717_ = 0u;
                        loop {
                            let _e403 = phi_2044_;
                            let _e405 = phi_708_;
                            let _e407 = phi_711_;
                            let _e409 = phi_713_;
                            let _e411 = phi_715_;
                            let _e413 = phi_717_;
                            local_3 = _e405;
                            if _e411 {
                                phi_728_ = true;
                            } else {
                                phi_728_ = (_e413 > 0u);
                            }
                            let _e416 = phi_728_;
                            if _e416 {
                                let _e417 = (_e409 > 0u);
                                if _e417 {
                                    if _e411 {
                                        phi_760_ = _e407;
                                        phi_761_ = _e411;
                                        phi_762_ = _e413;
                                    } else {
                                        let _e418 = (_e413 - 1u);
                                        let _e419 = (_e418 % 128u);
                                        let _e420 = (_e419 < 128u);
                                        if _e420 {
                                        } else {
                                            phi_2153_ = true;
                                            break;
                                        }
                                        let _e422 = local_1[_e419];
                                        if _e420 {
                                        } else {
                                            phi_2153_ = true;
                                            break;
                                        }
                                        let _e424 = local[_e419];
                                        phi_760_ = _e422;
                                        phi_761_ = (_e424 <= _e405.member);
                                        phi_762_ = _e418;
                                    }
                                    let _e428 = phi_760_;
                                    let _e430 = phi_761_;
                                    let _e432 = phi_762_;
                                    if _e430 {
                                        if ((_e428 & 2147483648u) != 0u) {
                                            phi_777_ = _e405;
                                            phi_780_ = type_7(0u, ((_e428 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e630 = phi_777_;
                                                let _e632 = phi_780_;
                                                local_2 = _e630;
                                                local_4 = _e630;
                                                if (_e632.member < _e632.member_1) {
                                                    phi_781_ = type_7((_e632.member + 1u), _e632.member_1);
                                                    phi_803_ = type_7(1u, _e632.member);
                                                } else {
                                                    phi_781_ = _e632;
                                                    phi_803_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e645 = phi_781_;
                                                let _e647 = phi_803_;
                                                let _e651 = (bitcast<i32>(_e647.member) != 0i);
                                                if _e651 {
                                                    let _e652 = ((_e428 & 268435455u) + _e647.member_1);
                                                    let _e653 = (_e652 < _e67);
                                                    if _e653 {
                                                        if _e653 {
                                                        } else {
                                                            phi_2038_ = true;
                                                            break;
                                                        }
                                                        let _e657 = global_1.member[_e652].member_1;
                                                        phi_824_ = _e657;
                                                    } else {
                                                        phi_824_ = 4294967295u;
                                                    }
                                                    let _e659 = phi_824_;
                                                    if (_e652 >= _e67) {
                                                        phi_913_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e653 {
                                                        } else {
                                                            phi_2038_ = true;
                                                            break;
                                                        }
                                                        let _e661 = (_e217 % 3u);
                                                        let _e662 = (_e216 % 3u);
                                                        let _e663 = (_e218 % 3u);
                                                        if (_e661 < 9u) {
                                                        } else {
                                                            phi_2038_ = true;
                                                            break;
                                                        }
                                                        let _e669 = global_1.member[_e652].member[_e661];
                                                        if (_e662 < 9u) {
                                                        } else {
                                                            phi_2038_ = true;
                                                            break;
                                                        }
                                                        let _e675 = global_1.member[_e652].member[_e662];
                                                        if (_e663 < 9u) {
                                                        } else {
                                                            phi_2038_ = true;
                                                            break;
                                                        }
                                                        let _e681 = global_1.member[_e652].member[_e663];
                                                        let _e683 = (3u + _e661);
                                                        if (_e683 < 9u) {
                                                        } else {
                                                            phi_2038_ = true;
                                                            break;
                                                        }
                                                        let _e689 = global_1.member[_e652].member[_e683];
                                                        let _e690 = (3u + _e662);
                                                        if (_e690 < 9u) {
                                                        } else {
                                                            phi_2038_ = true;
                                                            break;
                                                        }
                                                        let _e696 = global_1.member[_e652].member[_e690];
                                                        let _e697 = (3u + _e663);
                                                        if (_e697 < 9u) {
                                                        } else {
                                                            phi_2038_ = true;
                                                            break;
                                                        }
                                                        let _e703 = global_1.member[_e652].member[_e697];
                                                        let _e705 = (6u + _e661);
                                                        if (_e705 < 9u) {
                                                        } else {
                                                            phi_2038_ = true;
                                                            break;
                                                        }
                                                        let _e711 = global_1.member[_e652].member[_e705];
                                                        let _e712 = (6u + _e662);
                                                        if (_e712 < 9u) {
                                                        } else {
                                                            phi_2038_ = true;
                                                            break;
                                                        }
                                                        let _e718 = global_1.member[_e652].member[_e712];
                                                        let _e719 = (6u + _e663);
                                                        if (_e719 < 9u) {
                                                        } else {
                                                            phi_2038_ = true;
                                                            break;
                                                        }
                                                        let _e725 = global_1.member[_e652].member[_e719];
                                                        phi_913_ = array<array<f32, 3>, 3>(array<f32, 3>(_e669, _e675, _e681), array<f32, 3>(_e689, _e696, _e703), array<f32, 3>(_e711, _e718, _e725));
                                                    }
                                                    let _e729 = phi_913_;
                                                    let _e737 = (_e729[0][2] - _e322);
                                                    let _e740 = (((_e729[0][0] - _e249) * _e346) - (_e737 * _e274));
                                                    let _e743 = (((_e729[0][1] - _e286) * _e346) - (_e737 * _e310));
                                                    let _e750 = (_e729[1][2] - _e322);
                                                    let _e753 = (((_e729[1][0] - _e249) * _e346) - (_e750 * _e274));
                                                    let _e756 = (((_e729[1][1] - _e286) * _e346) - (_e750 * _e310));
                                                    let _e763 = (_e729[2][2] - _e322);
                                                    let _e766 = (((_e729[2][0] - _e249) * _e346) - (_e763 * _e274));
                                                    let _e769 = (((_e729[2][1] - _e286) * _e346) - (_e763 * _e310));
                                                    let _e770 = (_e766 * _e756);
                                                    let _e771 = (_e769 * _e753);
                                                    let _e772 = (_e740 * _e769);
                                                    let _e773 = (_e743 * _e766);
                                                    let _e774 = (_e753 * _e743);
                                                    let _e775 = (_e756 * _e740);
                                                    let _e780 = (((_e770 >= _e771) && (_e772 >= _e773)) && (_e774 >= _e775));
                                                    if (_e780 || (((_e770 <= _e771) && (_e772 <= _e773)) && (_e774 <= _e775))) {
                                                        let _e787 = select(-1f, 1f, _e780);
                                                        let _e789 = ((_e770 - _e771) * _e787);
                                                        let _e791 = select(0f, _e789, (_e789 > 0f));
                                                        let _e793 = ((_e772 - _e773) * _e787);
                                                        let _e795 = select(0f, _e793, (_e793 > 0f));
                                                        let _e797 = ((_e774 - _e775) * _e787);
                                                        let _e799 = select(0f, _e797, (_e797 > 0f));
                                                        let _e801 = ((_e791 + _e795) + _e799);
                                                        if (_e801 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1479_ = type_22();
                                                            phi_1480_ = true;
                                                        } else {
                                                            let _e804 = select(_e729[1][0], _e729[0][0], (_e729[0][0] < _e729[1][0]));
                                                            let _e808 = select(_e729[1][0], _e729[0][0], (_e729[0][0] > _e729[1][0]));
                                                            let _e812 = select(_e729[1][1], _e729[0][1], (_e729[0][1] < _e729[1][1]));
                                                            let _e816 = select(_e729[1][1], _e729[0][1], (_e729[0][1] > _e729[1][1]));
                                                            let _e820 = select(_e729[1][2], _e729[0][2], (_e729[0][2] < _e729[1][2]));
                                                            let _e824 = select(_e729[1][2], _e729[0][2], (_e729[0][2] > _e729[1][2]));
                                                            let _e829 = ((select(_e729[2][0], _e804, (_e804 < _e729[2][0])) - _e272) * _e277);
                                                            let _e830 = ((select(_e729[2][0], _e808, (_e808 > _e729[2][0])) - _e273) * _e277);
                                                            let _e833 = ((select(_e729[2][1], _e812, (_e812 < _e729[2][1])) - _e308) * _e313);
                                                            let _e834 = ((select(_e729[2][1], _e816, (_e816 > _e729[2][1])) - _e309) * _e313);
                                                            let _e837 = ((select(_e729[2][2], _e820, (_e820 < _e729[2][2])) - _e344) * _e349);
                                                            let _e838 = ((select(_e729[2][2], _e824, (_e824 > _e729[2][2])) - _e345) * _e349);
                                                            let _e840 = select(_e838, _e837, (_e837 < _e838));
                                                            let _e842 = select(_e838, _e837, (_e837 > _e838));
                                                            let _e844 = select(_e830, _e829, (_e829 < _e830));
                                                            let _e846 = select(_e834, _e833, (_e833 < _e834));
                                                            let _e848 = select(_e846, _e844, (_e844 > _e846));
                                                            let _e850 = select(_e840, _e848, (_e848 > _e840));
                                                            let _e852 = select(_e830, _e829, (_e829 > _e830));
                                                            let _e854 = select(_e834, _e833, (_e833 > _e834));
                                                            let _e856 = select(_e854, _e852, (_e852 < _e854));
                                                            let _e858 = select(_e842, _e856, (_e856 < _e842));
                                                            let _e859 = -(_e840);
                                                            let _e865 = select(_e395, _e850, (_e850 > _e395));
                                                            if (_e865 > (_e858 + (select(_e859, _e842, (_e842 > _e859)) * 0.0000019073523f))) {
                                                                phi_1474_ = type_22();
                                                                phi_1475_ = true;
                                                            } else {
                                                                let _e867 = (_e865 > _e630.member);
                                                                if _e867 {
                                                                    phi_1473_ = type_22();
                                                                } else {
                                                                    let _e871 = (_e729[1][0] - _e729[0][0]);
                                                                    let _e872 = (_e729[1][1] - _e729[0][1]);
                                                                    let _e873 = (_e729[1][2] - _e729[0][2]);
                                                                    let _e874 = vec3<f32>(_e871, _e872, _e873);
                                                                    let _e875 = (_e729[2][0] - _e729[1][0]);
                                                                    let _e876 = (_e729[2][1] - _e729[1][1]);
                                                                    let _e877 = (_e729[2][2] - _e729[1][2]);
                                                                    let _e878 = vec3<f32>(_e875, _e876, _e877);
                                                                    let _e879 = (_e729[0][0] - _e729[2][0]);
                                                                    let _e880 = (_e729[0][1] - _e729[2][1]);
                                                                    let _e881 = (_e729[0][2] - _e729[2][2]);
                                                                    let _e882 = vec3<f32>(_e879, _e880, _e881);
                                                                    let _e885 = bitcast<f32>((bitcast<u32>(_e871) & 2147483647u));
                                                                    let _e888 = bitcast<f32>((bitcast<u32>(_e872) & 2147483647u));
                                                                    let _e890 = select(_e888, _e885, (_e885 > _e888));
                                                                    let _e893 = bitcast<f32>((bitcast<u32>(_e873) & 2147483647u));
                                                                    let _e895 = select(_e893, _e890, (_e890 > _e893));
                                                                    let _e898 = bitcast<f32>((bitcast<u32>(_e875) & 2147483647u));
                                                                    let _e901 = bitcast<f32>((bitcast<u32>(_e876) & 2147483647u));
                                                                    let _e903 = select(_e901, _e898, (_e898 > _e901));
                                                                    let _e906 = bitcast<f32>((bitcast<u32>(_e877) & 2147483647u));
                                                                    let _e908 = select(_e906, _e903, (_e903 > _e906));
                                                                    let _e911 = bitcast<f32>((bitcast<u32>(_e879) & 2147483647u));
                                                                    let _e914 = bitcast<f32>((bitcast<u32>(_e880) & 2147483647u));
                                                                    let _e916 = select(_e914, _e911, (_e911 > _e914));
                                                                    let _e919 = bitcast<f32>((bitcast<u32>(_e881) & 2147483647u));
                                                                    let _e921 = select(_e919, _e916, (_e916 > _e919));
                                                                    let _e923 = select(_e908, _e895, (_e895 > _e908));
                                                                    let _e925 = select(_e921, _e923, (_e923 > _e921));
                                                                    if (_e895 == _e925) {
                                                                        phi_1384_ = _e878;
                                                                        phi_1385_ = _e882;
                                                                    } else {
                                                                        let _e928 = vec3((_e908 == _e925));
                                                                        phi_1384_ = select(_e874, _e882, _e928);
                                                                        phi_1385_ = select(_e878, _e874, _e928);
                                                                    }
                                                                    let _e932 = phi_1384_;
                                                                    let _e934 = phi_1385_;
                                                                    let _e941 = ((_e932.y * _e934.z) - (_e934.y * _e932.z));
                                                                    let _e946 = ((_e932.z * _e934.x) - (_e934.z * _e932.x));
                                                                    let _e949 = ((_e932.x * _e934.y) - (_e934.x * _e932.y));
                                                                    if (_e791 >= _e795) {
                                                                        phi_1416_ = select(true, false, (_e791 >= _e799));
                                                                    } else {
                                                                        phi_1416_ = true;
                                                                    }
                                                                    let _e954 = phi_1416_;
                                                                    if _e954 {
                                                                        phi_1425_ = select(vec3<f32>(_e729[2][0], _e729[2][1], _e729[2][2]), vec3<f32>(_e729[1][0], _e729[1][1], _e729[1][2]), vec3((_e795 >= _e799)));
                                                                    } else {
                                                                        phi_1425_ = vec3<f32>(_e729[0][0], _e729[0][1], _e729[0][2]);
                                                                    }
                                                                    let _e959 = phi_1425_;
                                                                    let _e976 = ((((_e941 * (_e959.x - _e249)) + (_e946 * (_e959.y - _e286))) + (_e949 * (_e959.z - _e322))) / (((_e941 * _e274) + (_e946 * _e310)) + (_e949 * _e346)));
                                                                    let _e978 = select(_e858, _e976, (_e976 < _e858));
                                                                    let _e980 = select(_e850, _e978, (_e978 > _e850));
                                                                    if (_e980 >= _e395) {
                                                                        let _e982 = (_e980 <= _e630.member);
                                                                        if _e982 {
                                                                            let _e983 = (1f / _e801);
                                                                            phi_1465_ = type_22(_e980, (_e795 * _e983), (_e799 * _e983), _e659);
                                                                        } else {
                                                                            phi_1465_ = type_22();
                                                                        }
                                                                        let _e988 = phi_1465_;
                                                                        phi_1467_ = _e988;
                                                                        phi_1468_ = select(true, false, _e982);
                                                                    } else {
                                                                        phi_1467_ = type_22();
                                                                        phi_1468_ = true;
                                                                    }
                                                                    let _e991 = phi_1467_;
                                                                    let _e993 = phi_1468_;
                                                                    if _e993 {
                                                                        phi_1472_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_1472_ = _e991;
                                                                    }
                                                                    let _e995 = phi_1472_;
                                                                    phi_1473_ = _e995;
                                                                }
                                                                let _e997 = phi_1473_;
                                                                phi_1474_ = _e997;
                                                                phi_1475_ = _e867;
                                                            }
                                                            let _e999 = phi_1474_;
                                                            let _e1001 = phi_1475_;
                                                            phi_1479_ = _e999;
                                                            phi_1480_ = _e1001;
                                                        }
                                                        let _e1003 = phi_1479_;
                                                        let _e1005 = phi_1480_;
                                                        phi_1484_ = _e1003;
                                                        phi_1485_ = _e1005;
                                                    } else {
                                                        phi_1484_ = type_22();
                                                        phi_1485_ = true;
                                                    }
                                                    let _e1007 = phi_1484_;
                                                    let _e1009 = phi_1485_;
                                                    if _e1009 {
                                                        phi_1489_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1489_ = _e1007;
                                                    }
                                                    let _e1011 = phi_1489_;
                                                    if (_e1011.member_3 != 4294967295u) {
                                                        if (_e659 != _e84) {
                                                            phi_1500_ = type_48(_e630.member, true);
                                                        } else {
                                                            phi_1500_ = _e630;
                                                        }
                                                        let _e1019 = phi_1500_;
                                                        phi_1501_ = _e1019;
                                                    } else {
                                                        phi_1501_ = _e630;
                                                    }
                                                    let _e1021 = phi_1501_;
                                                    phi_778_ = _e1021;
                                                } else {
                                                    phi_778_ = type_48();
                                                }
                                                let _e1023 = phi_778_;
                                                continue;
                                                continuing {
                                                    phi_777_ = _e1023;
                                                    phi_780_ = _e645;
                                                    phi_2038_ = _e403;
                                                    break if !(_e651);
                                                }
                                            }
                                            let _e1026 = phi_2038_;
                                            phi_2153_ = _e1026;
                                            if _e1026 {
                                                break;
                                            }
                                            let _e1028 = local_2;
                                            phi_2157_ = _e1026;
                                            let _e1194 = local_4;
                                            phi_1957_ = _e1194;
                                            phi_1958_ = _e428;
                                            phi_1959_ = false;
                                            phi_1960_ = select(_e432, 0u, _e1028.member_1);
                                        } else {
                                            if (_e428 >= _e65) {
                                                phi_1562_ = type_47(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                            } else {
                                                if (_e428 < _e65) {
                                                } else {
                                                    phi_2153_ = true;
                                                    break;
                                                }
                                                let _e442 = (_e217 % 3u);
                                                if (_e442 < 3u) {
                                                } else {
                                                    phi_2153_ = true;
                                                    break;
                                                }
                                                let _e448 = global_2.member[_e428].member[_e442];
                                                let _e454 = (_e216 % 3u);
                                                if (_e454 < 3u) {
                                                } else {
                                                    phi_2153_ = true;
                                                    break;
                                                }
                                                let _e460 = global_2.member[_e428].member[_e454];
                                                let _e466 = (_e218 % 3u);
                                                if (_e466 < 3u) {
                                                } else {
                                                    phi_2153_ = true;
                                                    break;
                                                }
                                                let _e472 = global_2.member[_e428].member[_e466];
                                                let _e482 = global_2.member[_e428].member_1;
                                                let _e486 = global_2.member[_e428].member_2;
                                                phi_1562_ = type_47(array<vec4<f32>, 3>(vec4<f32>(_e448[0], _e448[1], _e448[2], _e448[3]), vec4<f32>(_e460[0], _e460[1], _e460[2], _e460[3]), vec4<f32>(_e472[0], _e472[1], _e472[2], _e472[3])), _e482, _e486);
                                            }
                                            let _e489 = phi_1562_;
                                            let _e501 = ((_e489.member[0].x - _e272) * _e277);
                                            let _e502 = ((_e489.member[0].y - _e272) * _e277);
                                            let _e503 = ((_e489.member[0].z - _e273) * _e277);
                                            let _e504 = ((_e489.member[0].w - _e273) * _e277);
                                            let _e514 = ((_e489.member[1].x - _e308) * _e313);
                                            let _e515 = ((_e489.member[1].y - _e308) * _e313);
                                            let _e516 = ((_e489.member[1].z - _e309) * _e313);
                                            let _e517 = ((_e489.member[1].w - _e309) * _e313);
                                            let _e527 = ((_e489.member[2].x - _e344) * _e349);
                                            let _e528 = ((_e489.member[2].y - _e344) * _e349);
                                            let _e529 = ((_e489.member[2].z - _e345) * _e349);
                                            let _e530 = ((_e489.member[2].w - _e345) * _e349);
                                            let _e532 = select(_e529, _e527, (_e527 < _e529));
                                            let _e534 = select(_e530, _e528, (_e528 < _e530));
                                            let _e536 = select(_e529, _e527, (_e527 > _e529));
                                            let _e538 = select(_e530, _e528, (_e528 > _e530));
                                            let _e540 = select(_e503, _e501, (_e501 < _e503));
                                            let _e542 = select(_e504, _e502, (_e502 < _e504));
                                            let _e544 = select(_e516, _e514, (_e514 < _e516));
                                            let _e546 = select(_e517, _e515, (_e515 < _e517));
                                            let _e548 = select(_e544, _e540, (_e540 > _e544));
                                            let _e550 = select(_e546, _e542, (_e542 > _e546));
                                            let _e552 = select(_e532, _e548, (_e548 > _e532));
                                            let _e554 = select(_e534, _e550, (_e550 > _e534));
                                            let _e556 = select(_e503, _e501, (_e501 > _e503));
                                            let _e558 = select(_e504, _e502, (_e502 > _e504));
                                            let _e560 = select(_e516, _e514, (_e514 > _e516));
                                            let _e562 = select(_e517, _e515, (_e515 > _e517));
                                            let _e564 = select(_e560, _e556, (_e556 < _e560));
                                            let _e566 = select(_e562, _e558, (_e558 < _e562));
                                            let _e571 = -(_e532);
                                            let _e572 = -(_e534);
                                            let _e579 = (select(_e536, _e564, (_e564 < _e536)) + (select(_e571, _e536, (_e536 > _e571)) * 0.0000019073523f));
                                            let _e580 = (select(_e538, _e566, (_e566 < _e538)) + (select(_e572, _e538, (_e538 > _e572)) * 0.0000019073523f));
                                            let _e582 = select(_e395, _e552, (_e552 > _e395));
                                            let _e584 = select(_e395, _e554, (_e554 > _e395));
                                            let _e589 = (_e582 <= select(_e405.member, _e579, (_e579 < _e405.member)));
                                            let _e590 = (_e584 <= select(_e405.member, _e580, (_e580 < _e405.member)));
                                            let _e591 = (_e582 <= _e584);
                                            if _e589 {
                                                if _e590 {
                                                    if _e591 {
                                                        phi_1906_ = _e489.member_2;
                                                    } else {
                                                        phi_1906_ = _e489.member_1;
                                                    }
                                                    let _e595 = phi_1906_;
                                                    let _e598 = (_e432 % 128u);
                                                    let _e599 = (_e598 < 128u);
                                                    if _e599 {
                                                    } else {
                                                        phi_2153_ = true;
                                                        break;
                                                    }
                                                    local_1[_e598] = _e595;
                                                    if _e599 {
                                                    } else {
                                                        phi_2153_ = true;
                                                        break;
                                                    }
                                                    local[_e598] = select(_e584, _e582, (_e582 > _e584));
                                                    if _e591 {
                                                        phi_1934_ = _e489.member_1;
                                                    } else {
                                                        phi_1934_ = _e489.member_2;
                                                    }
                                                    let _e606 = phi_1934_;
                                                    phi_1935_ = _e606;
                                                    phi_1936_ = (_e432 + 1u);
                                                } else {
                                                    phi_1935_ = u32();
                                                    phi_1936_ = u32();
                                                }
                                                let _e608 = phi_1935_;
                                                let _e610 = phi_1936_;
                                                phi_1938_ = _e608;
                                                phi_1939_ = _e610;
                                                phi_1940_ = select(true, false, _e590);
                                            } else {
                                                phi_1938_ = u32();
                                                phi_1939_ = u32();
                                                phi_1940_ = true;
                                            }
                                            let _e613 = phi_1938_;
                                            let _e615 = phi_1939_;
                                            let _e617 = phi_1940_;
                                            if _e617 {
                                                if _e589 {
                                                    phi_1949_ = _e489.member_1;
                                                } else {
                                                    phi_1949_ = _e489.member_2;
                                                }
                                                let _e621 = phi_1949_;
                                                phi_1954_ = _e621;
                                                phi_1955_ = select(_e590, true, _e589);
                                            } else {
                                                phi_1954_ = _e613;
                                                phi_1955_ = _e430;
                                            }
                                            let _e624 = phi_1954_;
                                            let _e626 = phi_1955_;
                                            phi_2157_ = _e403;
                                            phi_1957_ = _e405;
                                            phi_1958_ = _e624;
                                            phi_1959_ = _e626;
                                            phi_1960_ = select(_e615, _e432, _e617);
                                        }
                                        let _e1032 = phi_2157_;
                                        let _e1034 = phi_1957_;
                                        let _e1036 = phi_1958_;
                                        let _e1038 = phi_1959_;
                                        let _e1040 = phi_1960_;
                                        phi_2156_ = _e1032;
                                        phi_1961_ = _e1034;
                                        phi_1962_ = _e1036;
                                        phi_1963_ = (_e409 - 1u);
                                        phi_1964_ = _e1038;
                                        phi_1965_ = _e1040;
                                    } else {
                                        phi_2156_ = _e403;
                                        phi_1961_ = _e405;
                                        phi_1962_ = _e428;
                                        phi_1963_ = _e409;
                                        phi_1964_ = _e430;
                                        phi_1965_ = _e432;
                                    }
                                    let _e1042 = phi_2156_;
                                    let _e1044 = phi_1961_;
                                    let _e1046 = phi_1962_;
                                    let _e1048 = phi_1963_;
                                    let _e1050 = phi_1964_;
                                    let _e1052 = phi_1965_;
                                    phi_2155_ = _e1042;
                                    phi_1966_ = _e1044;
                                    phi_1967_ = _e1046;
                                    phi_1968_ = _e1048;
                                    phi_1969_ = _e1050;
                                    phi_1970_ = _e1052;
                                } else {
                                    phi_2155_ = _e403;
                                    phi_1966_ = type_48();
                                    phi_1967_ = u32();
                                    phi_1968_ = u32();
                                    phi_1969_ = bool();
                                    phi_1970_ = u32();
                                }
                                let _e1054 = phi_2155_;
                                let _e1056 = phi_1966_;
                                let _e1058 = phi_1967_;
                                let _e1060 = phi_1968_;
                                let _e1062 = phi_1969_;
                                let _e1064 = phi_1970_;
                                phi_2154_ = _e1054;
                                phi_709_ = _e1056;
                                phi_712_ = _e1058;
                                phi_714_ = _e1060;
                                phi_716_ = _e1062;
                                phi_718_ = _e1064;
                                phi_1971_ = _e417;
                            } else {
                                phi_2154_ = _e403;
                                phi_709_ = type_48();
                                phi_712_ = u32();
                                phi_714_ = u32();
                                phi_716_ = bool();
                                phi_718_ = u32();
                                phi_1971_ = false;
                            }
                            let _e1066 = phi_2154_;
                            let _e1068 = phi_709_;
                            let _e1070 = phi_712_;
                            let _e1072 = phi_714_;
                            let _e1074 = phi_716_;
                            let _e1076 = phi_718_;
                            let _e1078 = phi_1971_;
                            continue;
                            continuing {
                                phi_2044_ = _e1066;
                                phi_708_ = _e1068;
                                phi_711_ = _e1070;
                                phi_713_ = _e1072;
                                phi_715_ = _e1074;
                                phi_717_ = _e1076;
                                phi_2153_ = _e1066;
                                break if !(_e1078);
                            }
                        }
                        let _e1081 = phi_2153_;
                        if _e1081 {
                            break;
                        }
                        let _e1083 = local_3;
                        if _e1083.member_1 {
                        } else {
                            if _e85 {
                            } else {
                                break;
                            }
                            let _e1087 = global_5.member[_e77];
                            if _e78 {
                            } else {
                                break;
                            }
                            let _e1091 = global_4.member[_e77].member_1;
                            if _e85 {
                            } else {
                                break;
                            }
                            global_5.member[_e77] = type_24(_e1087.member, _e1087.member_1, _e1087.member_2, array<f32, 3>((_e1087.member_3[0] + (_e1091[0] * _e1087.member_1[0])), (_e1087.member_3[1] + (_e1091[1] * _e1087.member_1[1])), (_e1087.member_3[2] + (_e1091[2] * _e1087.member_1[2]))), _e1087.member_4);
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
