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

struct type_46 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_47 {
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
    var phi_321_: i32;
    var phi_322_: i32;
    var phi_332_: bool;
    var phi_342_: u32;
    var phi_343_: u32;
    var phi_345_: bool;
    var phi_350_: u32;
    var phi_382_: i32;
    var phi_400_: f32;
    var phi_406_: f32;
    var phi_417_: f32;
    var phi_423_: f32;
    var phi_446_: f32;
    var phi_457_: f32;
    var phi_466_: f32;
    var phi_472_: f32;
    var phi_483_: f32;
    var phi_489_: f32;
    var phi_512_: f32;
    var phi_523_: f32;
    var phi_532_: f32;
    var phi_538_: f32;
    var phi_549_: f32;
    var phi_555_: f32;
    var phi_578_: f32;
    var phi_589_: f32;
    var phi_689_: f32;
    var phi_690_: f32;
    var phi_2301_: bool;
    var phi_964_: type_47;
    var phi_967_: u32;
    var phi_969_: u32;
    var phi_971_: bool;
    var phi_973_: u32;
    var phi_984_: bool;
    var phi_1015_: u32;
    var phi_1016_: bool;
    var phi_1017_: u32;
    var phi_1817_: type_46;
    var phi_2161_: u32;
    var phi_2188_: u32;
    var phi_2189_: u32;
    var phi_2190_: u32;
    var phi_2192_: u32;
    var phi_2193_: u32;
    var phi_2194_: bool;
    var phi_2203_: u32;
    var phi_2208_: u32;
    var phi_2209_: bool;
    var phi_1032_: type_47;
    var phi_1035_: type_7;
    var phi_1036_: type_7;
    var phi_1058_: type_7;
    var phi_1079_: u32;
    var phi_1168_: array<array<f32, 3>, 3>;
    var phi_1639_: vec3<f32>;
    var phi_1640_: vec3<f32>;
    var phi_1671_: bool;
    var phi_1680_: vec3<f32>;
    var phi_1720_: type_22;
    var phi_1722_: type_22;
    var phi_1723_: bool;
    var phi_1727_: type_22;
    var phi_1728_: type_22;
    var phi_1729_: type_22;
    var phi_1730_: bool;
    var phi_1734_: type_22;
    var phi_1735_: bool;
    var phi_1739_: type_22;
    var phi_1740_: bool;
    var phi_1744_: type_22;
    var phi_1755_: type_47;
    var phi_1756_: type_47;
    var phi_1033_: type_47;
    var phi_2295_: bool;
    var local_2: type_47;
    var phi_2413_: bool;
    var phi_2211_: type_47;
    var phi_2212_: u32;
    var phi_2213_: bool;
    var phi_2214_: u32;
    var phi_2412_: bool;
    var phi_2215_: type_47;
    var phi_2216_: u32;
    var phi_2217_: u32;
    var phi_2218_: bool;
    var phi_2219_: u32;
    var phi_2411_: bool;
    var phi_2220_: type_47;
    var phi_2221_: u32;
    var phi_2222_: u32;
    var phi_2223_: bool;
    var phi_2224_: u32;
    var phi_2410_: bool;
    var phi_965_: type_47;
    var phi_968_: u32;
    var phi_970_: u32;
    var phi_972_: bool;
    var phi_974_: u32;
    var phi_2225_: bool;
    var phi_2409_: bool;
    var local_3: type_47;
    var local_4: type_47;

    switch bitcast<i32>(0u) {
        default: {
            let _e63 = global;
            let _e65 = arrayLength((&global_2.member));
            let _e67 = arrayLength((&global_1.member));
            let _e73 = arrayLength((&global_3.member));
            let _e77 = (_e63.x + (_e63.y * 2097152u));
            let _e78 = (_e77 < arrayLength((&global_4.member)));
            if _e78 {
                let _e79 = (_e77 < arrayLength((&global_5.member)));
                if _e79 {
                    if _e78 {
                    } else {
                        break;
                    }
                    let _e84 = global_4.member[_e77].member.member_1;
                    let _e89 = global_4.member[_e77].member.member_3;
                    if (_e84 <= _e89) {
                        let _e91 = (1u < _e73);
                        if _e91 {
                            if (0u < _e73) {
                            } else {
                                break;
                            }
                            let _e95 = atomicAdd((&global_3.member[0u]), 1u);
                            if ((_e95 + 1u) < _e95) {
                                if _e91 {
                                } else {
                                    break;
                                }
                                let _e100 = atomicAdd((&global_3.member[1u]), 1u);
                            }
                        }
                        if _e78 {
                        } else {
                            break;
                        }
                        if _e78 {
                        } else {
                            break;
                        }
                        let _e104 = global_4.member[_e77].member_2;
                        let _e114 = global_4.member[_e77].member.member_2[0u];
                        let _e116 = (bitcast<u32>(_e114) & 2147483647u);
                        let _e122 = global_4.member[_e77].member.member_2[1u];
                        let _e124 = (bitcast<u32>(_e122) & 2147483647u);
                        let _e130 = global_4.member[_e77].member.member_2[2u];
                        let _e132 = (bitcast<u32>(_e130) & 2147483647u);
                        let _e138 = global_4.member[_e77].member.member[0u];
                        let _e140 = (bitcast<u32>(_e138) & 2147483647u);
                        let _e146 = global_4.member[_e77].member.member[1u];
                        let _e148 = (bitcast<u32>(_e146) & 2147483647u);
                        let _e154 = global_4.member[_e77].member.member[2u];
                        let _e156 = (bitcast<u32>(_e154) & 2147483647u);
                        let _e158 = select(_e124, _e116, (_e124 < _e116));
                        let _e160 = select(_e132, _e158, (_e132 < _e158));
                        let _e162 = select(_e140, _e160, (_e140 < _e160));
                        let _e164 = select(_e148, _e162, (_e148 < _e162));
                        let _e166 = select(_e156, _e164, (_e156 < _e164));
                        let _e168 = (bitcast<u32>(_e84) & 2147483647u);
                        let _e177 = (((select(_e168, _e166, (_e168 < _e166)) < 2139095040u) && ((bitcast<u32>(_e89) & 2147483647u) <= 2139095040u)) && (_e160 > 0u));
                        if _e177 {
                            let _e180 = (bitcast<u32>(bitcast<f32>(_e160)) & 2147483647u);
                            if (_e180 >= 8388608u) {
                                phi_321_ = (bitcast<i32>((_e180 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_321_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e180)), 32u, (_e180 == 0u))));
                            }
                            let _e194 = phi_321_;
                            phi_322_ = _e194;
                        } else {
                            phi_322_ = 0i;
                        }
                        let _e196 = phi_322_;
                        let _e197 = (_e116 == _e160);
                        if _e197 {
                            phi_332_ = true;
                        } else {
                            phi_332_ = (_e124 == _e160);
                        }
                        let _e200 = phi_332_;
                        let _e201 = select(1u, 0u, _e197);
                        if _e200 {
                            let _e202 = (_e201 + 1u);
                            phi_342_ = _e202;
                            phi_343_ = _e202;
                            phi_345_ = select(true, false, (_e202 == 2u));
                        } else {
                            phi_342_ = u32();
                            phi_343_ = 0u;
                            phi_345_ = true;
                        }
                        let _e206 = phi_342_;
                        let _e208 = phi_343_;
                        let _e210 = phi_345_;
                        if _e210 {
                            phi_350_ = (_e208 + 1u);
                        } else {
                            phi_350_ = 0u;
                        }
                        let _e214 = phi_350_;
                        let _e215 = select(_e206, _e208, _e210);
                        let _e216 = select(_e201, select(2u, _e201, _e200), _e210);
                        let _e217 = -(_e196);
                        if (_e217 < -126i) {
                            phi_382_ = -126i;
                        } else {
                            phi_382_ = select(_e217, 127i, (_e217 > 127i));
                        }
                        let _e222 = phi_382_;
                        let _e227 = bitcast<f32>((bitcast<u32>((_e222 + 127i)) << bitcast<u32>(23i)));
                        let _e233 = bitcast<f32>((bitcast<u32>(((_e217 - _e222) + 127i)) << bitcast<u32>(23i)));
                        let _e238 = global_4.member[_e77].member.member;
                        let _e239 = (_e215 == 0u);
                        if _e239 {
                            phi_400_ = _e238[0];
                        } else {
                            phi_400_ = _e238[1];
                        }
                        let _e243 = phi_400_;
                        let _e244 = (_e215 == 2u);
                        if _e244 {
                            phi_406_ = _e238[2];
                        } else {
                            phi_406_ = _e243;
                        }
                        let _e247 = phi_406_;
                        let _e248 = global_4.member[_e77].member.member_2;
                        if _e239 {
                            phi_417_ = _e248[0];
                        } else {
                            phi_417_ = _e248[1];
                        }
                        let _e252 = phi_417_;
                        if _e244 {
                            phi_423_ = _e248[2];
                        } else {
                            phi_423_ = _e252;
                        }
                        let _e255 = phi_423_;
                        let _e257 = ((_e255 * _e227) * _e233);
                        let _e261 = (bitcast<f32>((bitcast<u32>(_e257) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e261 {
                            let _e265 = (bitcast<f32>((bitcast<u32>(_e247) & 2147483647u)) * 0.00000011920929f);
                            phi_446_ = select(0.00000000000011368684f, _e265, (_e265 > 0.00000000000011368684f));
                        } else {
                            phi_446_ = 0f;
                        }
                        let _e269 = phi_446_;
                        let _e270 = (_e247 + _e269);
                        let _e271 = (_e247 - _e269);
                        let _e272 = select(_e257, 0f, _e261);
                        if _e261 {
                            phi_457_ = 38685626000000000000000000f;
                        } else {
                            phi_457_ = (1f / _e257);
                        }
                        let _e275 = phi_457_;
                        let _e276 = (_e214 == 0u);
                        if _e276 {
                            phi_466_ = _e238[0];
                        } else {
                            phi_466_ = _e238[1];
                        }
                        let _e280 = phi_466_;
                        let _e281 = (_e214 == 2u);
                        if _e281 {
                            phi_472_ = _e238[2];
                        } else {
                            phi_472_ = _e280;
                        }
                        let _e284 = phi_472_;
                        if _e276 {
                            phi_483_ = _e248[0];
                        } else {
                            phi_483_ = _e248[1];
                        }
                        let _e288 = phi_483_;
                        if _e281 {
                            phi_489_ = _e248[2];
                        } else {
                            phi_489_ = _e288;
                        }
                        let _e291 = phi_489_;
                        let _e293 = ((_e291 * _e227) * _e233);
                        let _e297 = (bitcast<f32>((bitcast<u32>(_e293) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e297 {
                            let _e301 = (bitcast<f32>((bitcast<u32>(_e284) & 2147483647u)) * 0.00000011920929f);
                            phi_512_ = select(0.00000000000011368684f, _e301, (_e301 > 0.00000000000011368684f));
                        } else {
                            phi_512_ = 0f;
                        }
                        let _e305 = phi_512_;
                        let _e306 = (_e284 + _e305);
                        let _e307 = (_e284 - _e305);
                        let _e308 = select(_e293, 0f, _e297);
                        if _e297 {
                            phi_523_ = 38685626000000000000000000f;
                        } else {
                            phi_523_ = (1f / _e293);
                        }
                        let _e311 = phi_523_;
                        let _e312 = (_e216 == 0u);
                        if _e312 {
                            phi_532_ = _e238[0];
                        } else {
                            phi_532_ = _e238[1];
                        }
                        let _e316 = phi_532_;
                        let _e317 = (_e216 == 2u);
                        if _e317 {
                            phi_538_ = _e238[2];
                        } else {
                            phi_538_ = _e316;
                        }
                        let _e320 = phi_538_;
                        if _e312 {
                            phi_549_ = _e248[0];
                        } else {
                            phi_549_ = _e248[1];
                        }
                        let _e324 = phi_549_;
                        if _e317 {
                            phi_555_ = _e248[2];
                        } else {
                            phi_555_ = _e324;
                        }
                        let _e327 = phi_555_;
                        let _e329 = ((_e327 * _e227) * _e233);
                        let _e333 = (bitcast<f32>((bitcast<u32>(_e329) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e333 {
                            let _e337 = (bitcast<f32>((bitcast<u32>(_e320) & 2147483647u)) * 0.00000011920929f);
                            phi_578_ = select(0.00000000000011368684f, _e337, (_e337 > 0.00000000000011368684f));
                        } else {
                            phi_578_ = 0f;
                        }
                        let _e341 = phi_578_;
                        let _e342 = (_e320 + _e341);
                        let _e343 = (_e320 - _e341);
                        let _e344 = select(_e329, 0f, _e333);
                        if _e333 {
                            phi_589_ = 38685626000000000000000000f;
                        } else {
                            phi_589_ = (1f / _e329);
                        }
                        let _e347 = phi_589_;
                        let _e350 = bitcast<f32>((bitcast<u32>(_e247) & 2147483647u));
                        let _e353 = bitcast<f32>((bitcast<u32>(_e284) & 2147483647u));
                        let _e355 = select(_e353, _e350, (_e350 > _e353));
                        let _e358 = bitcast<f32>((bitcast<u32>(_e320) & 2147483647u));
                        if (_e177 && (select(_e358, _e355, (_e355 > _e358)) <= 1099511600000f)) {
                            let _e363 = (_e196 / 3i);
                            let _e370 = bitcast<f32>((bitcast<u32>((_e363 + 127i)) << bitcast<u32>(23i)));
                            let _e377 = bitcast<f32>((bitcast<u32>(((_e196 - (2i * _e363)) + 127i)) << bitcast<u32>(23i)));
                            let _e378 = (((_e84 * _e370) * _e370) * _e377);
                            let _e380 = select(340282350000000000000000000000000000000f, _e378, (_e378 < 340282350000000000000000000000000000000f));
                            let _e385 = (((_e89 * _e370) * _e370) * _e377);
                            let _e387 = select(340282350000000000000000000000000000000f, _e385, (_e385 < 340282350000000000000000000000000000000f));
                            phi_689_ = select(-340282350000000000000000000000000000000f, _e387, (_e387 > -340282350000000000000000000000000000000f));
                            phi_690_ = select(-340282350000000000000000000000000000000f, _e380, (_e380 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_689_ = 0f;
                            phi_690_ = 1f;
                        }
                        let _e391 = phi_689_;
                        let _e393 = phi_690_;
                        local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        phi_2301_ = false;
                        phi_964_ = type_47(_e391, false);
                        phi_967_ = select(0u, 2147483648u, (_e65 == 0u));
                        phi_969_ = ((3u * _e65) + 1u);
                        phi_971_ = (_e393 <= _e391);
                        phi_973_ = 0u;
                        loop {
                            let _e401 = phi_2301_;
                            let _e403 = phi_964_;
                            let _e405 = phi_967_;
                            let _e407 = phi_969_;
                            let _e409 = phi_971_;
                            let _e411 = phi_973_;
                            local_3 = _e403;
                            if _e409 {
                                phi_984_ = true;
                            } else {
                                phi_984_ = (_e411 > 0u);
                            }
                            let _e414 = phi_984_;
                            if _e414 {
                                let _e415 = (_e407 > 0u);
                                if _e415 {
                                    if _e409 {
                                        phi_1015_ = _e405;
                                        phi_1016_ = _e409;
                                        phi_1017_ = _e411;
                                    } else {
                                        let _e416 = (_e411 - 1u);
                                        let _e417 = (_e416 % 128u);
                                        let _e418 = (_e417 < 128u);
                                        if _e418 {
                                        } else {
                                            phi_2409_ = true;
                                            break;
                                        }
                                        let _e420 = local_1[_e417];
                                        if _e418 {
                                        } else {
                                            phi_2409_ = true;
                                            break;
                                        }
                                        let _e422 = local[_e417];
                                        phi_1015_ = _e420;
                                        phi_1016_ = (_e422 <= _e403.member);
                                        phi_1017_ = _e416;
                                    }
                                    let _e426 = phi_1015_;
                                    let _e428 = phi_1016_;
                                    let _e430 = phi_1017_;
                                    if _e428 {
                                        if ((_e426 & 2147483648u) != 0u) {
                                            phi_1032_ = _e403;
                                            phi_1035_ = type_7(0u, ((_e426 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e628 = phi_1032_;
                                                let _e630 = phi_1035_;
                                                local_2 = _e628;
                                                local_4 = _e628;
                                                if (_e630.member < _e630.member_1) {
                                                    phi_1036_ = type_7((_e630.member + 1u), _e630.member_1);
                                                    phi_1058_ = type_7(1u, _e630.member);
                                                } else {
                                                    phi_1036_ = _e630;
                                                    phi_1058_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e643 = phi_1036_;
                                                let _e645 = phi_1058_;
                                                let _e649 = (bitcast<i32>(_e645.member) != 0i);
                                                if _e649 {
                                                    let _e650 = ((_e426 & 268435455u) + _e645.member_1);
                                                    let _e651 = (_e650 < _e67);
                                                    if _e651 {
                                                        if _e651 {
                                                        } else {
                                                            phi_2295_ = true;
                                                            break;
                                                        }
                                                        let _e655 = global_1.member[_e650].member_1;
                                                        phi_1079_ = _e655;
                                                    } else {
                                                        phi_1079_ = 4294967295u;
                                                    }
                                                    let _e657 = phi_1079_;
                                                    if (_e650 >= _e67) {
                                                        phi_1168_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e651 {
                                                        } else {
                                                            phi_2295_ = true;
                                                            break;
                                                        }
                                                        let _e659 = (_e215 % 3u);
                                                        let _e660 = (_e214 % 3u);
                                                        let _e661 = (_e216 % 3u);
                                                        if (_e659 < 9u) {
                                                        } else {
                                                            phi_2295_ = true;
                                                            break;
                                                        }
                                                        let _e667 = global_1.member[_e650].member[_e659];
                                                        if (_e660 < 9u) {
                                                        } else {
                                                            phi_2295_ = true;
                                                            break;
                                                        }
                                                        let _e673 = global_1.member[_e650].member[_e660];
                                                        if (_e661 < 9u) {
                                                        } else {
                                                            phi_2295_ = true;
                                                            break;
                                                        }
                                                        let _e679 = global_1.member[_e650].member[_e661];
                                                        let _e681 = (3u + _e659);
                                                        if (_e681 < 9u) {
                                                        } else {
                                                            phi_2295_ = true;
                                                            break;
                                                        }
                                                        let _e687 = global_1.member[_e650].member[_e681];
                                                        let _e688 = (3u + _e660);
                                                        if (_e688 < 9u) {
                                                        } else {
                                                            phi_2295_ = true;
                                                            break;
                                                        }
                                                        let _e694 = global_1.member[_e650].member[_e688];
                                                        let _e695 = (3u + _e661);
                                                        if (_e695 < 9u) {
                                                        } else {
                                                            phi_2295_ = true;
                                                            break;
                                                        }
                                                        let _e701 = global_1.member[_e650].member[_e695];
                                                        let _e703 = (6u + _e659);
                                                        if (_e703 < 9u) {
                                                        } else {
                                                            phi_2295_ = true;
                                                            break;
                                                        }
                                                        let _e709 = global_1.member[_e650].member[_e703];
                                                        let _e710 = (6u + _e660);
                                                        if (_e710 < 9u) {
                                                        } else {
                                                            phi_2295_ = true;
                                                            break;
                                                        }
                                                        let _e716 = global_1.member[_e650].member[_e710];
                                                        let _e717 = (6u + _e661);
                                                        if (_e717 < 9u) {
                                                        } else {
                                                            phi_2295_ = true;
                                                            break;
                                                        }
                                                        let _e723 = global_1.member[_e650].member[_e717];
                                                        phi_1168_ = array<array<f32, 3>, 3>(array<f32, 3>(_e667, _e673, _e679), array<f32, 3>(_e687, _e694, _e701), array<f32, 3>(_e709, _e716, _e723));
                                                    }
                                                    let _e727 = phi_1168_;
                                                    let _e735 = (_e727[0][2] - _e320);
                                                    let _e738 = (((_e727[0][0] - _e247) * _e344) - (_e735 * _e272));
                                                    let _e741 = (((_e727[0][1] - _e284) * _e344) - (_e735 * _e308));
                                                    let _e748 = (_e727[1][2] - _e320);
                                                    let _e751 = (((_e727[1][0] - _e247) * _e344) - (_e748 * _e272));
                                                    let _e754 = (((_e727[1][1] - _e284) * _e344) - (_e748 * _e308));
                                                    let _e761 = (_e727[2][2] - _e320);
                                                    let _e764 = (((_e727[2][0] - _e247) * _e344) - (_e761 * _e272));
                                                    let _e767 = (((_e727[2][1] - _e284) * _e344) - (_e761 * _e308));
                                                    let _e768 = (_e764 * _e754);
                                                    let _e769 = (_e767 * _e751);
                                                    let _e770 = (_e738 * _e767);
                                                    let _e771 = (_e741 * _e764);
                                                    let _e772 = (_e751 * _e741);
                                                    let _e773 = (_e754 * _e738);
                                                    let _e778 = (((_e768 >= _e769) && (_e770 >= _e771)) && (_e772 >= _e773));
                                                    if (_e778 || (((_e768 <= _e769) && (_e770 <= _e771)) && (_e772 <= _e773))) {
                                                        let _e785 = select(-1f, 1f, _e778);
                                                        let _e787 = ((_e768 - _e769) * _e785);
                                                        let _e789 = select(0f, _e787, (_e787 > 0f));
                                                        let _e791 = ((_e770 - _e771) * _e785);
                                                        let _e793 = select(0f, _e791, (_e791 > 0f));
                                                        let _e795 = ((_e772 - _e773) * _e785);
                                                        let _e797 = select(0f, _e795, (_e795 > 0f));
                                                        let _e799 = ((_e789 + _e793) + _e797);
                                                        if (_e799 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1734_ = type_22();
                                                            phi_1735_ = true;
                                                        } else {
                                                            let _e802 = select(_e727[1][0], _e727[0][0], (_e727[0][0] < _e727[1][0]));
                                                            let _e806 = select(_e727[1][0], _e727[0][0], (_e727[0][0] > _e727[1][0]));
                                                            let _e810 = select(_e727[1][1], _e727[0][1], (_e727[0][1] < _e727[1][1]));
                                                            let _e814 = select(_e727[1][1], _e727[0][1], (_e727[0][1] > _e727[1][1]));
                                                            let _e818 = select(_e727[1][2], _e727[0][2], (_e727[0][2] < _e727[1][2]));
                                                            let _e822 = select(_e727[1][2], _e727[0][2], (_e727[0][2] > _e727[1][2]));
                                                            let _e827 = ((select(_e727[2][0], _e802, (_e802 < _e727[2][0])) - _e270) * _e275);
                                                            let _e828 = ((select(_e727[2][0], _e806, (_e806 > _e727[2][0])) - _e271) * _e275);
                                                            let _e831 = ((select(_e727[2][1], _e810, (_e810 < _e727[2][1])) - _e306) * _e311);
                                                            let _e832 = ((select(_e727[2][1], _e814, (_e814 > _e727[2][1])) - _e307) * _e311);
                                                            let _e835 = ((select(_e727[2][2], _e818, (_e818 < _e727[2][2])) - _e342) * _e347);
                                                            let _e836 = ((select(_e727[2][2], _e822, (_e822 > _e727[2][2])) - _e343) * _e347);
                                                            let _e838 = select(_e836, _e835, (_e835 < _e836));
                                                            let _e840 = select(_e836, _e835, (_e835 > _e836));
                                                            let _e842 = select(_e828, _e827, (_e827 < _e828));
                                                            let _e844 = select(_e832, _e831, (_e831 < _e832));
                                                            let _e846 = select(_e844, _e842, (_e842 > _e844));
                                                            let _e848 = select(_e838, _e846, (_e846 > _e838));
                                                            let _e850 = select(_e828, _e827, (_e827 > _e828));
                                                            let _e852 = select(_e832, _e831, (_e831 > _e832));
                                                            let _e854 = select(_e852, _e850, (_e850 < _e852));
                                                            let _e856 = select(_e840, _e854, (_e854 < _e840));
                                                            let _e857 = -(_e838);
                                                            let _e863 = select(_e393, _e848, (_e848 > _e393));
                                                            if (_e863 > (_e856 + (select(_e857, _e840, (_e840 > _e857)) * 0.0000019073523f))) {
                                                                phi_1729_ = type_22();
                                                                phi_1730_ = true;
                                                            } else {
                                                                let _e865 = (_e863 > _e628.member);
                                                                if _e865 {
                                                                    phi_1728_ = type_22();
                                                                } else {
                                                                    let _e869 = (_e727[1][0] - _e727[0][0]);
                                                                    let _e870 = (_e727[1][1] - _e727[0][1]);
                                                                    let _e871 = (_e727[1][2] - _e727[0][2]);
                                                                    let _e872 = vec3<f32>(_e869, _e870, _e871);
                                                                    let _e873 = (_e727[2][0] - _e727[1][0]);
                                                                    let _e874 = (_e727[2][1] - _e727[1][1]);
                                                                    let _e875 = (_e727[2][2] - _e727[1][2]);
                                                                    let _e876 = vec3<f32>(_e873, _e874, _e875);
                                                                    let _e877 = (_e727[0][0] - _e727[2][0]);
                                                                    let _e878 = (_e727[0][1] - _e727[2][1]);
                                                                    let _e879 = (_e727[0][2] - _e727[2][2]);
                                                                    let _e880 = vec3<f32>(_e877, _e878, _e879);
                                                                    let _e883 = bitcast<f32>((bitcast<u32>(_e869) & 2147483647u));
                                                                    let _e886 = bitcast<f32>((bitcast<u32>(_e870) & 2147483647u));
                                                                    let _e888 = select(_e886, _e883, (_e883 > _e886));
                                                                    let _e891 = bitcast<f32>((bitcast<u32>(_e871) & 2147483647u));
                                                                    let _e893 = select(_e891, _e888, (_e888 > _e891));
                                                                    let _e896 = bitcast<f32>((bitcast<u32>(_e873) & 2147483647u));
                                                                    let _e899 = bitcast<f32>((bitcast<u32>(_e874) & 2147483647u));
                                                                    let _e901 = select(_e899, _e896, (_e896 > _e899));
                                                                    let _e904 = bitcast<f32>((bitcast<u32>(_e875) & 2147483647u));
                                                                    let _e906 = select(_e904, _e901, (_e901 > _e904));
                                                                    let _e909 = bitcast<f32>((bitcast<u32>(_e877) & 2147483647u));
                                                                    let _e912 = bitcast<f32>((bitcast<u32>(_e878) & 2147483647u));
                                                                    let _e914 = select(_e912, _e909, (_e909 > _e912));
                                                                    let _e917 = bitcast<f32>((bitcast<u32>(_e879) & 2147483647u));
                                                                    let _e919 = select(_e917, _e914, (_e914 > _e917));
                                                                    let _e921 = select(_e906, _e893, (_e893 > _e906));
                                                                    let _e923 = select(_e919, _e921, (_e921 > _e919));
                                                                    if (_e893 == _e923) {
                                                                        phi_1639_ = _e876;
                                                                        phi_1640_ = _e880;
                                                                    } else {
                                                                        let _e926 = vec3((_e906 == _e923));
                                                                        phi_1639_ = select(_e872, _e880, _e926);
                                                                        phi_1640_ = select(_e876, _e872, _e926);
                                                                    }
                                                                    let _e930 = phi_1639_;
                                                                    let _e932 = phi_1640_;
                                                                    let _e939 = ((_e930.y * _e932.z) - (_e932.y * _e930.z));
                                                                    let _e944 = ((_e930.z * _e932.x) - (_e932.z * _e930.x));
                                                                    let _e947 = ((_e930.x * _e932.y) - (_e932.x * _e930.y));
                                                                    if (_e789 >= _e793) {
                                                                        phi_1671_ = select(true, false, (_e789 >= _e797));
                                                                    } else {
                                                                        phi_1671_ = true;
                                                                    }
                                                                    let _e952 = phi_1671_;
                                                                    if _e952 {
                                                                        phi_1680_ = select(vec3<f32>(_e727[2][0], _e727[2][1], _e727[2][2]), vec3<f32>(_e727[1][0], _e727[1][1], _e727[1][2]), vec3((_e793 >= _e797)));
                                                                    } else {
                                                                        phi_1680_ = vec3<f32>(_e727[0][0], _e727[0][1], _e727[0][2]);
                                                                    }
                                                                    let _e957 = phi_1680_;
                                                                    let _e974 = ((((_e939 * (_e957.x - _e247)) + (_e944 * (_e957.y - _e284))) + (_e947 * (_e957.z - _e320))) / (((_e939 * _e272) + (_e944 * _e308)) + (_e947 * _e344)));
                                                                    let _e976 = select(_e856, _e974, (_e974 < _e856));
                                                                    let _e978 = select(_e848, _e976, (_e976 > _e848));
                                                                    if (_e978 >= _e393) {
                                                                        let _e980 = (_e978 <= _e628.member);
                                                                        if _e980 {
                                                                            let _e981 = (1f / _e799);
                                                                            phi_1720_ = type_22(_e978, (_e793 * _e981), (_e797 * _e981), _e657);
                                                                        } else {
                                                                            phi_1720_ = type_22();
                                                                        }
                                                                        let _e986 = phi_1720_;
                                                                        phi_1722_ = _e986;
                                                                        phi_1723_ = select(true, false, _e980);
                                                                    } else {
                                                                        phi_1722_ = type_22();
                                                                        phi_1723_ = true;
                                                                    }
                                                                    let _e989 = phi_1722_;
                                                                    let _e991 = phi_1723_;
                                                                    if _e991 {
                                                                        phi_1727_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_1727_ = _e989;
                                                                    }
                                                                    let _e993 = phi_1727_;
                                                                    phi_1728_ = _e993;
                                                                }
                                                                let _e995 = phi_1728_;
                                                                phi_1729_ = _e995;
                                                                phi_1730_ = _e865;
                                                            }
                                                            let _e997 = phi_1729_;
                                                            let _e999 = phi_1730_;
                                                            phi_1734_ = _e997;
                                                            phi_1735_ = _e999;
                                                        }
                                                        let _e1001 = phi_1734_;
                                                        let _e1003 = phi_1735_;
                                                        phi_1739_ = _e1001;
                                                        phi_1740_ = _e1003;
                                                    } else {
                                                        phi_1739_ = type_22();
                                                        phi_1740_ = true;
                                                    }
                                                    let _e1005 = phi_1739_;
                                                    let _e1007 = phi_1740_;
                                                    if _e1007 {
                                                        phi_1744_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1744_ = _e1005;
                                                    }
                                                    let _e1009 = phi_1744_;
                                                    if (_e1009.member_3 != 4294967295u) {
                                                        if (_e657 != _e104) {
                                                            phi_1755_ = type_47(_e628.member, true);
                                                        } else {
                                                            phi_1755_ = _e628;
                                                        }
                                                        let _e1017 = phi_1755_;
                                                        phi_1756_ = _e1017;
                                                    } else {
                                                        phi_1756_ = _e628;
                                                    }
                                                    let _e1019 = phi_1756_;
                                                    phi_1033_ = _e1019;
                                                } else {
                                                    phi_1033_ = type_47();
                                                }
                                                let _e1021 = phi_1033_;
                                                continue;
                                                continuing {
                                                    phi_1032_ = _e1021;
                                                    phi_1035_ = _e643;
                                                    phi_2295_ = _e401;
                                                    break if !(_e649);
                                                }
                                            }
                                            let _e1024 = phi_2295_;
                                            phi_2409_ = _e1024;
                                            if _e1024 {
                                                break;
                                            }
                                            let _e1026 = local_2;
                                            phi_2413_ = _e1024;
                                            let _e1191 = local_4;
                                            phi_2211_ = _e1191;
                                            phi_2212_ = _e426;
                                            phi_2213_ = false;
                                            phi_2214_ = select(_e430, 0u, _e1026.member_1);
                                        } else {
                                            if (_e426 >= _e65) {
                                                phi_1817_ = type_46(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                            } else {
                                                if (_e426 < _e65) {
                                                } else {
                                                    phi_2409_ = true;
                                                    break;
                                                }
                                                let _e440 = (_e215 % 3u);
                                                if (_e440 < 3u) {
                                                } else {
                                                    phi_2409_ = true;
                                                    break;
                                                }
                                                let _e446 = global_2.member[_e426].member[_e440];
                                                let _e452 = (_e214 % 3u);
                                                if (_e452 < 3u) {
                                                } else {
                                                    phi_2409_ = true;
                                                    break;
                                                }
                                                let _e458 = global_2.member[_e426].member[_e452];
                                                let _e464 = (_e216 % 3u);
                                                if (_e464 < 3u) {
                                                } else {
                                                    phi_2409_ = true;
                                                    break;
                                                }
                                                let _e470 = global_2.member[_e426].member[_e464];
                                                let _e480 = global_2.member[_e426].member_1;
                                                let _e484 = global_2.member[_e426].member_2;
                                                phi_1817_ = type_46(array<vec4<f32>, 3>(vec4<f32>(_e446[0], _e446[1], _e446[2], _e446[3]), vec4<f32>(_e458[0], _e458[1], _e458[2], _e458[3]), vec4<f32>(_e470[0], _e470[1], _e470[2], _e470[3])), _e480, _e484);
                                            }
                                            let _e487 = phi_1817_;
                                            let _e499 = ((_e487.member[0].x - _e270) * _e275);
                                            let _e500 = ((_e487.member[0].y - _e270) * _e275);
                                            let _e501 = ((_e487.member[0].z - _e271) * _e275);
                                            let _e502 = ((_e487.member[0].w - _e271) * _e275);
                                            let _e512 = ((_e487.member[1].x - _e306) * _e311);
                                            let _e513 = ((_e487.member[1].y - _e306) * _e311);
                                            let _e514 = ((_e487.member[1].z - _e307) * _e311);
                                            let _e515 = ((_e487.member[1].w - _e307) * _e311);
                                            let _e525 = ((_e487.member[2].x - _e342) * _e347);
                                            let _e526 = ((_e487.member[2].y - _e342) * _e347);
                                            let _e527 = ((_e487.member[2].z - _e343) * _e347);
                                            let _e528 = ((_e487.member[2].w - _e343) * _e347);
                                            let _e530 = select(_e527, _e525, (_e525 < _e527));
                                            let _e532 = select(_e528, _e526, (_e526 < _e528));
                                            let _e534 = select(_e527, _e525, (_e525 > _e527));
                                            let _e536 = select(_e528, _e526, (_e526 > _e528));
                                            let _e538 = select(_e501, _e499, (_e499 < _e501));
                                            let _e540 = select(_e502, _e500, (_e500 < _e502));
                                            let _e542 = select(_e514, _e512, (_e512 < _e514));
                                            let _e544 = select(_e515, _e513, (_e513 < _e515));
                                            let _e546 = select(_e542, _e538, (_e538 > _e542));
                                            let _e548 = select(_e544, _e540, (_e540 > _e544));
                                            let _e550 = select(_e530, _e546, (_e546 > _e530));
                                            let _e552 = select(_e532, _e548, (_e548 > _e532));
                                            let _e554 = select(_e501, _e499, (_e499 > _e501));
                                            let _e556 = select(_e502, _e500, (_e500 > _e502));
                                            let _e558 = select(_e514, _e512, (_e512 > _e514));
                                            let _e560 = select(_e515, _e513, (_e513 > _e515));
                                            let _e562 = select(_e558, _e554, (_e554 < _e558));
                                            let _e564 = select(_e560, _e556, (_e556 < _e560));
                                            let _e569 = -(_e530);
                                            let _e570 = -(_e532);
                                            let _e577 = (select(_e534, _e562, (_e562 < _e534)) + (select(_e569, _e534, (_e534 > _e569)) * 0.0000019073523f));
                                            let _e578 = (select(_e536, _e564, (_e564 < _e536)) + (select(_e570, _e536, (_e536 > _e570)) * 0.0000019073523f));
                                            let _e580 = select(_e393, _e550, (_e550 > _e393));
                                            let _e582 = select(_e393, _e552, (_e552 > _e393));
                                            let _e587 = (_e580 <= select(_e403.member, _e577, (_e577 < _e403.member)));
                                            let _e588 = (_e582 <= select(_e403.member, _e578, (_e578 < _e403.member)));
                                            let _e589 = (_e580 <= _e582);
                                            if _e587 {
                                                if _e588 {
                                                    if _e589 {
                                                        phi_2161_ = _e487.member_2;
                                                    } else {
                                                        phi_2161_ = _e487.member_1;
                                                    }
                                                    let _e593 = phi_2161_;
                                                    let _e594 = (_e430 % 128u);
                                                    let _e595 = (_e594 < 128u);
                                                    if _e595 {
                                                    } else {
                                                        phi_2409_ = true;
                                                        break;
                                                    }
                                                    local_1[_e594] = _e593;
                                                    if _e595 {
                                                    } else {
                                                        phi_2409_ = true;
                                                        break;
                                                    }
                                                    local[_e594] = select(_e582, _e580, (_e580 > _e582));
                                                    if _e589 {
                                                        phi_2188_ = _e487.member_1;
                                                    } else {
                                                        phi_2188_ = _e487.member_2;
                                                    }
                                                    let _e604 = phi_2188_;
                                                    phi_2189_ = _e604;
                                                    phi_2190_ = (_e430 + 1u);
                                                } else {
                                                    phi_2189_ = u32();
                                                    phi_2190_ = u32();
                                                }
                                                let _e606 = phi_2189_;
                                                let _e608 = phi_2190_;
                                                phi_2192_ = _e606;
                                                phi_2193_ = _e608;
                                                phi_2194_ = select(true, false, _e588);
                                            } else {
                                                phi_2192_ = u32();
                                                phi_2193_ = u32();
                                                phi_2194_ = true;
                                            }
                                            let _e611 = phi_2192_;
                                            let _e613 = phi_2193_;
                                            let _e615 = phi_2194_;
                                            if _e615 {
                                                if _e587 {
                                                    phi_2203_ = _e487.member_1;
                                                } else {
                                                    phi_2203_ = _e487.member_2;
                                                }
                                                let _e619 = phi_2203_;
                                                phi_2208_ = _e619;
                                                phi_2209_ = select(_e588, true, _e587);
                                            } else {
                                                phi_2208_ = _e611;
                                                phi_2209_ = _e428;
                                            }
                                            let _e622 = phi_2208_;
                                            let _e624 = phi_2209_;
                                            phi_2413_ = _e401;
                                            phi_2211_ = _e403;
                                            phi_2212_ = _e622;
                                            phi_2213_ = _e624;
                                            phi_2214_ = select(_e613, _e430, _e615);
                                        }
                                        let _e1030 = phi_2413_;
                                        let _e1032 = phi_2211_;
                                        let _e1034 = phi_2212_;
                                        let _e1036 = phi_2213_;
                                        let _e1038 = phi_2214_;
                                        phi_2412_ = _e1030;
                                        phi_2215_ = _e1032;
                                        phi_2216_ = _e1034;
                                        phi_2217_ = (_e407 - 1u);
                                        phi_2218_ = _e1036;
                                        phi_2219_ = _e1038;
                                    } else {
                                        phi_2412_ = _e401;
                                        phi_2215_ = _e403;
                                        phi_2216_ = _e426;
                                        phi_2217_ = _e407;
                                        phi_2218_ = _e428;
                                        phi_2219_ = _e430;
                                    }
                                    let _e1040 = phi_2412_;
                                    let _e1042 = phi_2215_;
                                    let _e1044 = phi_2216_;
                                    let _e1046 = phi_2217_;
                                    let _e1048 = phi_2218_;
                                    let _e1050 = phi_2219_;
                                    phi_2411_ = _e1040;
                                    phi_2220_ = _e1042;
                                    phi_2221_ = _e1044;
                                    phi_2222_ = _e1046;
                                    phi_2223_ = _e1048;
                                    phi_2224_ = _e1050;
                                } else {
                                    phi_2411_ = _e401;
                                    phi_2220_ = type_47();
                                    phi_2221_ = u32();
                                    phi_2222_ = u32();
                                    phi_2223_ = bool();
                                    phi_2224_ = u32();
                                }
                                let _e1052 = phi_2411_;
                                let _e1054 = phi_2220_;
                                let _e1056 = phi_2221_;
                                let _e1058 = phi_2222_;
                                let _e1060 = phi_2223_;
                                let _e1062 = phi_2224_;
                                phi_2410_ = _e1052;
                                phi_965_ = _e1054;
                                phi_968_ = _e1056;
                                phi_970_ = _e1058;
                                phi_972_ = _e1060;
                                phi_974_ = _e1062;
                                phi_2225_ = _e415;
                            } else {
                                phi_2410_ = _e401;
                                phi_965_ = type_47();
                                phi_968_ = u32();
                                phi_970_ = u32();
                                phi_972_ = bool();
                                phi_974_ = u32();
                                phi_2225_ = false;
                            }
                            let _e1064 = phi_2410_;
                            let _e1066 = phi_965_;
                            let _e1068 = phi_968_;
                            let _e1070 = phi_970_;
                            let _e1072 = phi_972_;
                            let _e1074 = phi_974_;
                            let _e1076 = phi_2225_;
                            continue;
                            continuing {
                                phi_2301_ = _e1064;
                                phi_964_ = _e1066;
                                phi_967_ = _e1068;
                                phi_969_ = _e1070;
                                phi_971_ = _e1072;
                                phi_973_ = _e1074;
                                phi_2409_ = _e1064;
                                break if !(_e1076);
                            }
                        }
                        let _e1079 = phi_2409_;
                        if _e1079 {
                            break;
                        }
                        let _e1081 = local_3;
                        if _e1081.member_1 {
                        } else {
                            if _e79 {
                            } else {
                                break;
                            }
                            let _e1085 = global_5.member[_e77];
                            if _e78 {
                            } else {
                                break;
                            }
                            let _e1089 = global_4.member[_e77].member_1;
                            if _e79 {
                            } else {
                                break;
                            }
                            global_5.member[_e77] = type_24(_e1085.member, _e1085.member_1, _e1085.member_2, array<f32, 3>((_e1085.member_3[0] + (_e1089[0] * _e1085.member_1[0])), (_e1085.member_3[1] + (_e1089[1] * _e1085.member_1[1])), (_e1085.member_3[2] + (_e1089[2] * _e1085.member_1[2]))), _e1085.member_4);
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
