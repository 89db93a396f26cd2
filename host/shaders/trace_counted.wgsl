struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_13 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_15 {
    member: array<type_13>,
}

struct type_21 {
    member: array<array<u32, 2>>,
}

struct type_27 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_28 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
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

struct type_40 {
    member: type_27,
    member_1: f32,
}

struct type_44 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_46 {
    member: array<type_28>,
}

struct type_48 {
    member: type_40,
    member_1: u32,
    member_2: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(1) 
var<storage> global_2: type_33;
@group(0) @binding(2) 
var<storage> global_3: type_15;
@group(0) @binding(3) 
var<storage> global_4: type_46;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_21;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_284_: i32;
    var phi_285_: i32;
    var phi_295_: bool;
    var phi_305_: u32;
    var phi_306_: u32;
    var phi_308_: bool;
    var phi_313_: u32;
    var phi_326_: i32;
    var phi_346_: i32;
    var phi_364_: f32;
    var phi_370_: f32;
    var phi_410_: f32;
    var phi_416_: f32;
    var phi_468_: f32;
    var phi_480_: f32;
    var phi_489_: f32;
    var phi_495_: f32;
    var phi_535_: f32;
    var phi_541_: f32;
    var phi_593_: f32;
    var phi_605_: f32;
    var phi_614_: f32;
    var phi_620_: f32;
    var phi_660_: f32;
    var phi_666_: f32;
    var phi_718_: f32;
    var phi_730_: f32;
    var phi_785_: i32;
    var phi_807_: u32;
    var phi_808_: u32;
    var phi_845_: i32;
    var phi_867_: u32;
    var phi_868_: u32;
    var phi_876_: f32;
    var phi_877_: f32;
    var phi_2583_: bool;
    var phi_893_: type_48;
    var phi_896_: u32;
    var phi_898_: bool;
    var phi_900_: u32;
    var phi_902_: u32;
    var phi_913_: bool;
    var phi_945_: bool;
    var phi_946_: u32;
    var phi_947_: u32;
    var phi_962_: type_48;
    var phi_965_: type_4;
    var phi_966_: type_4;
    var phi_988_: type_4;
    var phi_1012_: u32;
    var phi_1104_: array<array<f32, 3>, 3>;
    var phi_1256_: bool;
    var phi_1285_: bool;
    var phi_1704_: f32;
    var phi_1705_: f32;
    var phi_1706_: f32;
    var phi_1707_: f32;
    var phi_1708_: vec3<f32>;
    var phi_1709_: vec3<f32>;
    var phi_1710_: vec3<f32>;
    var phi_1711_: vec3<f32>;
    var phi_1748_: bool;
    var phi_1757_: vec3<f32>;
    var phi_1922_: f32;
    var phi_1924_: f32;
    var phi_1925_: bool;
    var phi_1945_: f32;
    var phi_1946_: f32;
    var phi_1969_: type_27;
    var phi_1971_: type_27;
    var phi_1972_: bool;
    var phi_1976_: type_27;
    var phi_1977_: type_27;
    var phi_1978_: type_27;
    var phi_1979_: bool;
    var phi_1983_: type_27;
    var phi_1984_: bool;
    var phi_1985_: type_27;
    var phi_1986_: bool;
    var phi_1987_: bool;
    var phi_1988_: type_27;
    var phi_1989_: bool;
    var phi_1990_: bool;
    var phi_1998_: type_27;
    var phi_1999_: bool;
    var phi_2003_: type_27;
    var phi_2028_: bool;
    var phi_2029_: bool;
    var phi_2036_: type_48;
    var phi_2037_: type_48;
    var phi_2038_: type_48;
    var phi_963_: type_48;
    var phi_2577_: bool;
    var phi_2772_: bool;
    var phi_2039_: type_48;
    var phi_2104_: type_44;
    var phi_2469_: u32;
    var phi_2496_: u32;
    var phi_2497_: u32;
    var phi_2498_: u32;
    var phi_2500_: u32;
    var phi_2501_: u32;
    var phi_2502_: bool;
    var phi_2511_: u32;
    var phi_2516_: bool;
    var phi_2518_: u32;
    var phi_2523_: type_48;
    var phi_2524_: bool;
    var phi_2525_: u32;
    var phi_2526_: u32;
    var phi_2534_: type_48;
    var phi_2740_: bool;
    var phi_2538_: type_48;
    var phi_2539_: u32;
    var phi_2540_: bool;
    var phi_2541_: u32;
    var phi_2542_: u32;
    var phi_2739_: bool;
    var phi_2543_: type_48;
    var phi_2544_: u32;
    var phi_2545_: bool;
    var phi_2546_: u32;
    var phi_2547_: u32;
    var phi_2738_: bool;
    var phi_894_: type_48;
    var phi_897_: u32;
    var phi_899_: bool;
    var phi_901_: u32;
    var phi_903_: u32;
    var phi_2548_: bool;
    var phi_2737_: bool;
    var local_2: type_48;
    var local_3: type_48;
    var local_4: type_48;

    switch bitcast<i32>(0u) {
        default: {
            let _e69 = global;
            let _e71 = arrayLength((&global_2.member));
            let _e73 = arrayLength((&global_3.member));
            let _e81 = (_e69.x + (_e69.y * 2097152u));
            let _e84 = global_1.member[0u];
            let _e85 = bitcast<i32>(_e84);
            let _e86 = (_e81 < arrayLength((&global_4.member)));
            if _e86 {
                let _e87 = (_e81 < arrayLength((&global_5.member)));
                if _e87 {
                    if _e86 {
                    } else {
                        break;
                    }
                    let _e95 = global_4.member[_e81].member_2[0u];
                    let _e97 = (bitcast<u32>(_e95) & 2147483647u);
                    let _e102 = global_4.member[_e81].member_2[1u];
                    let _e104 = (bitcast<u32>(_e102) & 2147483647u);
                    let _e109 = global_4.member[_e81].member_2[2u];
                    let _e111 = (bitcast<u32>(_e109) & 2147483647u);
                    let _e116 = global_4.member[_e81].member[0u];
                    let _e118 = (bitcast<u32>(_e116) & 2147483647u);
                    let _e123 = global_4.member[_e81].member[1u];
                    let _e125 = (bitcast<u32>(_e123) & 2147483647u);
                    let _e130 = global_4.member[_e81].member[2u];
                    let _e132 = (bitcast<u32>(_e130) & 2147483647u);
                    let _e134 = select(_e104, _e97, (_e104 < _e97));
                    let _e136 = select(_e111, _e134, (_e111 < _e134));
                    let _e138 = select(_e118, _e136, (_e118 < _e136));
                    let _e140 = select(_e125, _e138, (_e125 < _e138));
                    let _e142 = select(_e132, _e140, (_e132 < _e140));
                    let _e146 = global_4.member[_e81].member_1;
                    let _e147 = bitcast<u32>(_e146);
                    let _e148 = (_e147 & 2147483647u);
                    let _e155 = global_4.member[_e81].member_3;
                    let _e156 = bitcast<u32>(_e155);
                    let _e157 = (_e156 & 2147483647u);
                    let _e161 = (((select(_e148, _e142, (_e148 < _e142)) < 2139095040u) && (_e157 <= 2139095040u)) && (_e136 > 0u));
                    if _e161 {
                        let _e164 = (bitcast<u32>(bitcast<f32>(_e136)) & 2147483647u);
                        if (_e164 >= 8388608u) {
                            phi_284_ = (bitcast<i32>((_e164 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_284_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e164)), 32u, (_e164 == 0u))));
                        }
                        let _e178 = phi_284_;
                        phi_285_ = _e178;
                    } else {
                        phi_285_ = 0i;
                    }
                    let _e180 = phi_285_;
                    let _e181 = (_e97 == _e136);
                    if _e181 {
                        phi_295_ = true;
                    } else {
                        phi_295_ = (_e104 == _e136);
                    }
                    let _e184 = phi_295_;
                    let _e185 = select(1u, 0u, _e181);
                    if _e184 {
                        let _e186 = (_e185 + 1u);
                        phi_305_ = _e186;
                        phi_306_ = _e186;
                        phi_308_ = select(true, false, (_e186 == 2u));
                    } else {
                        phi_305_ = u32();
                        phi_306_ = 0u;
                        phi_308_ = true;
                    }
                    let _e190 = phi_305_;
                    let _e192 = phi_306_;
                    let _e194 = phi_308_;
                    if _e194 {
                        phi_313_ = (_e192 + 1u);
                    } else {
                        phi_313_ = 0u;
                    }
                    let _e198 = phi_313_;
                    let _e199 = select(_e190, _e192, _e194);
                    let _e200 = select(_e185, select(2u, _e185, _e184), _e194);
                    if (_e85 < -126i) {
                        phi_326_ = -126i;
                    } else {
                        phi_326_ = select(_e85, 127i, (_e85 > 127i));
                    }
                    let _e205 = phi_326_;
                    let _e210 = bitcast<f32>((bitcast<u32>((_e205 + 127i)) << bitcast<u32>(23i)));
                    let _e216 = bitcast<f32>((bitcast<u32>(((_e85 - _e205) + 127i)) << bitcast<u32>(23i)));
                    let _e217 = -(_e180);
                    if (_e217 < -126i) {
                        phi_346_ = -126i;
                    } else {
                        phi_346_ = select(_e217, 127i, (_e217 > 127i));
                    }
                    let _e222 = phi_346_;
                    let _e227 = bitcast<f32>((bitcast<u32>((_e222 + 127i)) << bitcast<u32>(23i)));
                    let _e233 = bitcast<f32>((bitcast<u32>(((_e217 - _e222) + 127i)) << bitcast<u32>(23i)));
                    let _e237 = global_4.member[_e81].member;
                    let _e238 = (_e199 == 0u);
                    if _e238 {
                        phi_364_ = _e237[0];
                    } else {
                        phi_364_ = _e237[1];
                    }
                    let _e242 = phi_364_;
                    let _e243 = (_e199 == 2u);
                    if _e243 {
                        phi_370_ = _e237[2];
                    } else {
                        phi_370_ = _e242;
                    }
                    let _e246 = phi_370_;
                    let _e247 = bitcast<u32>(_e246);
                    let _e249 = ((_e247 & 2139095040u) != 0u);
                    let _e263 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e247 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e247 & 2147483648u))), _e246, _e249) * _e210) * select(0.00000011920929f, 1f, _e249)) * _e216);
                    let _e264 = global_4.member[_e81].member_2;
                    if _e238 {
                        phi_410_ = _e264[0];
                    } else {
                        phi_410_ = _e264[1];
                    }
                    let _e268 = phi_410_;
                    if _e243 {
                        phi_416_ = _e264[2];
                    } else {
                        phi_416_ = _e268;
                    }
                    let _e271 = phi_416_;
                    let _e272 = bitcast<u32>(_e271);
                    let _e274 = ((_e272 & 2139095040u) != 0u);
                    let _e288 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e272 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e272 & 2147483648u))), _e271, _e274) * _e227) * select(0.00000011920929f, 1f, _e274)) * _e233);
                    let _e292 = (bitcast<f32>((bitcast<u32>(_e288) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e292 {
                        let _e296 = (bitcast<f32>((bitcast<u32>(_e263) & 2147483647u)) * 0.00000011920929f);
                        phi_468_ = select(0.00000000000011368684f, _e296, (_e296 > 0.00000000000011368684f));
                    } else {
                        phi_468_ = 0f;
                    }
                    let _e300 = phi_468_;
                    let _e301 = (_e263 + _e300);
                    let _e302 = (_e263 - _e300);
                    let _e303 = select(_e288, 0f, _e292);
                    if _e292 {
                        phi_480_ = 38685626000000000000000000f;
                    } else {
                        phi_480_ = (1f / _e288);
                    }
                    let _e306 = phi_480_;
                    let _e307 = (_e198 == 0u);
                    if _e307 {
                        phi_489_ = _e237[0];
                    } else {
                        phi_489_ = _e237[1];
                    }
                    let _e311 = phi_489_;
                    let _e312 = (_e198 == 2u);
                    if _e312 {
                        phi_495_ = _e237[2];
                    } else {
                        phi_495_ = _e311;
                    }
                    let _e315 = phi_495_;
                    let _e316 = bitcast<u32>(_e315);
                    let _e318 = ((_e316 & 2139095040u) != 0u);
                    let _e332 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e316 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e316 & 2147483648u))), _e315, _e318) * _e210) * select(0.00000011920929f, 1f, _e318)) * _e216);
                    if _e307 {
                        phi_535_ = _e264[0];
                    } else {
                        phi_535_ = _e264[1];
                    }
                    let _e336 = phi_535_;
                    if _e312 {
                        phi_541_ = _e264[2];
                    } else {
                        phi_541_ = _e336;
                    }
                    let _e339 = phi_541_;
                    let _e340 = bitcast<u32>(_e339);
                    let _e342 = ((_e340 & 2139095040u) != 0u);
                    let _e356 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e340 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e340 & 2147483648u))), _e339, _e342) * _e227) * select(0.00000011920929f, 1f, _e342)) * _e233);
                    let _e360 = (bitcast<f32>((bitcast<u32>(_e356) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e360 {
                        let _e364 = (bitcast<f32>((bitcast<u32>(_e332) & 2147483647u)) * 0.00000011920929f);
                        phi_593_ = select(0.00000000000011368684f, _e364, (_e364 > 0.00000000000011368684f));
                    } else {
                        phi_593_ = 0f;
                    }
                    let _e368 = phi_593_;
                    let _e369 = (_e332 + _e368);
                    let _e370 = (_e332 - _e368);
                    let _e371 = select(_e356, 0f, _e360);
                    if _e360 {
                        phi_605_ = 38685626000000000000000000f;
                    } else {
                        phi_605_ = (1f / _e356);
                    }
                    let _e374 = phi_605_;
                    let _e375 = (_e200 == 0u);
                    if _e375 {
                        phi_614_ = _e237[0];
                    } else {
                        phi_614_ = _e237[1];
                    }
                    let _e379 = phi_614_;
                    let _e380 = (_e200 == 2u);
                    if _e380 {
                        phi_620_ = _e237[2];
                    } else {
                        phi_620_ = _e379;
                    }
                    let _e383 = phi_620_;
                    let _e384 = bitcast<u32>(_e383);
                    let _e386 = ((_e384 & 2139095040u) != 0u);
                    let _e400 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e384 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e384 & 2147483648u))), _e383, _e386) * _e210) * select(0.00000011920929f, 1f, _e386)) * _e216);
                    if _e375 {
                        phi_660_ = _e264[0];
                    } else {
                        phi_660_ = _e264[1];
                    }
                    let _e404 = phi_660_;
                    if _e380 {
                        phi_666_ = _e264[2];
                    } else {
                        phi_666_ = _e404;
                    }
                    let _e407 = phi_666_;
                    let _e408 = bitcast<u32>(_e407);
                    let _e410 = ((_e408 & 2139095040u) != 0u);
                    let _e424 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e408 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e408 & 2147483648u))), _e407, _e410) * _e227) * select(0.00000011920929f, 1f, _e410)) * _e233);
                    let _e428 = (bitcast<f32>((bitcast<u32>(_e424) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e428 {
                        let _e432 = (bitcast<f32>((bitcast<u32>(_e400) & 2147483647u)) * 0.00000011920929f);
                        phi_718_ = select(0.00000000000011368684f, _e432, (_e432 > 0.00000000000011368684f));
                    } else {
                        phi_718_ = 0f;
                    }
                    let _e436 = phi_718_;
                    let _e437 = (_e400 + _e436);
                    let _e438 = (_e400 - _e436);
                    let _e439 = select(_e424, 0f, _e428);
                    if _e428 {
                        phi_730_ = 38685626000000000000000000f;
                    } else {
                        phi_730_ = (1f / _e424);
                    }
                    let _e442 = phi_730_;
                    let _e445 = bitcast<f32>((bitcast<u32>(_e263) & 2147483647u));
                    let _e448 = bitcast<f32>((bitcast<u32>(_e332) & 2147483647u));
                    let _e450 = select(_e448, _e445, (_e445 > _e448));
                    let _e453 = bitcast<f32>((bitcast<u32>(_e400) & 2147483647u));
                    let _e456 = (_e85 + _e180);
                    if (_e161 && (select(_e453, _e450, (_e450 > _e453)) <= 1099511600000f)) {
                        let _e466 = ((_e148 & 8388607u) | (select(0u, 1u, ((_e148 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e469 = bitcast<i32>((_e148 >> bitcast<u32>(23i)));
                        let _e473 = (_e466 == 0u);
                        let _e476 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e466)), 32u, _e473)) - 8i);
                        if (_e469 == 255i) {
                            phi_785_ = 255i;
                        } else {
                            phi_785_ = (((_e469 + select(0i, 1i, (_e469 == 0i))) - _e476) + _e456);
                        }
                        let _e484 = phi_785_;
                        let _e494 = (_e484 <= 0i);
                        if _e494 {
                            phi_808_ = u32();
                        } else {
                            if _e473 {
                                phi_807_ = u32();
                            } else {
                                phi_807_ = select(((bitcast<u32>(_e484) << bitcast<u32>(23i)) | ((_e466 << bitcast<u32>(((_e476 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e484 >= 255i));
                            }
                            let _e498 = phi_807_;
                            phi_808_ = _e498;
                        }
                        let _e500 = phi_808_;
                        let _e512 = ((_e157 & 8388607u) | (select(0u, 1u, ((_e157 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e515 = bitcast<i32>((_e157 >> bitcast<u32>(23i)));
                        let _e519 = (_e512 == 0u);
                        let _e522 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e512)), 32u, _e519)) - 8i);
                        if (_e515 == 255i) {
                            phi_845_ = 255i;
                        } else {
                            phi_845_ = (((_e515 + select(0i, 1i, (_e515 == 0i))) - _e522) + _e456);
                        }
                        let _e530 = phi_845_;
                        let _e540 = (_e530 <= 0i);
                        if _e540 {
                            phi_868_ = u32();
                        } else {
                            if _e519 {
                                phi_867_ = u32();
                            } else {
                                phi_867_ = select(((bitcast<u32>(_e530) << bitcast<u32>(23i)) | ((_e512 << bitcast<u32>(((_e522 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e530 >= 255i));
                            }
                            let _e544 = phi_867_;
                            phi_868_ = _e544;
                        }
                        let _e546 = phi_868_;
                        phi_876_ = bitcast<f32>(((_e156 & 2147483648u) | select(_e546, 0u, select(_e519, true, _e540))));
                        phi_877_ = bitcast<f32>(((_e147 & 2147483648u) | select(_e500, 0u, select(_e473, true, _e494))));
                    } else {
                        phi_876_ = 0f;
                        phi_877_ = 1f;
                    }
                    let _e552 = phi_876_;
                    let _e554 = phi_877_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2583_ = false;
                    phi_893_ = type_48(type_40(type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e552), 0u, 0u);
                    phi_896_ = ((3u * _e71) + 1u);
                    phi_898_ = (_e554 <= _e552);
                    phi_900_ = 0u;
                    phi_902_ = select(0u, 2147483648u, (_e71 == 0u));
                    loop {
                        let _e563 = phi_2583_;
                        let _e565 = phi_893_;
                        let _e567 = phi_896_;
                        let _e569 = phi_898_;
                        let _e571 = phi_900_;
                        let _e573 = phi_902_;
                        local_2 = _e565;
                        local_3 = _e565;
                        if _e569 {
                            phi_913_ = true;
                        } else {
                            phi_913_ = (_e571 > 0u);
                        }
                        let _e576 = phi_913_;
                        if _e576 {
                            let _e577 = (_e567 > 0u);
                            if _e577 {
                                if _e569 {
                                    phi_945_ = _e569;
                                    phi_946_ = _e571;
                                    phi_947_ = _e573;
                                } else {
                                    let _e578 = (_e571 - 1u);
                                    let _e579 = (_e578 % 128u);
                                    let _e580 = (_e579 < 128u);
                                    if _e580 {
                                    } else {
                                        phi_2737_ = true;
                                        break;
                                    }
                                    let _e582 = local_1[_e579];
                                    if _e580 {
                                    } else {
                                        phi_2737_ = true;
                                        break;
                                    }
                                    let _e584 = local[_e579];
                                    phi_945_ = (_e584 <= _e565.member.member_1);
                                    phi_946_ = _e578;
                                    phi_947_ = _e582;
                                }
                                let _e589 = phi_945_;
                                let _e591 = phi_946_;
                                let _e593 = phi_947_;
                                if _e589 {
                                    let _e596 = ((_e593 & 2147483648u) != 0u);
                                    if _e596 {
                                        phi_962_ = _e565;
                                        phi_965_ = type_4(0u, ((_e593 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e603 = phi_962_;
                                            let _e605 = phi_965_;
                                            local_4 = _e603;
                                            if (_e605.member < _e605.member_1) {
                                                phi_966_ = type_4((_e605.member + 1u), _e605.member_1);
                                                phi_988_ = type_4(1u, _e605.member);
                                            } else {
                                                phi_966_ = _e605;
                                                phi_988_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e618 = phi_966_;
                                            let _e620 = phi_988_;
                                            let _e624 = (bitcast<i32>(_e620.member) != 0i);
                                            if _e624 {
                                                let _e630 = type_48(_e603.member, _e603.member_1, (_e603.member_2 + 1u));
                                                let _e631 = ((_e593 & 268435455u) + _e620.member_1);
                                                let _e632 = (_e631 < _e73);
                                                if _e632 {
                                                    if _e632 {
                                                    } else {
                                                        phi_2577_ = true;
                                                        break;
                                                    }
                                                    let _e636 = global_3.member[_e631].member_1;
                                                    phi_1012_ = _e636;
                                                } else {
                                                    phi_1012_ = 4294967295u;
                                                }
                                                let _e638 = phi_1012_;
                                                if (_e631 >= _e73) {
                                                    phi_1104_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e632 {
                                                    } else {
                                                        phi_2577_ = true;
                                                        break;
                                                    }
                                                    let _e640 = (_e199 % 3u);
                                                    let _e641 = (_e198 % 3u);
                                                    let _e642 = (_e200 % 3u);
                                                    if (_e640 < 9u) {
                                                    } else {
                                                        phi_2577_ = true;
                                                        break;
                                                    }
                                                    let _e648 = global_3.member[_e631].member[_e640];
                                                    if (_e641 < 9u) {
                                                    } else {
                                                        phi_2577_ = true;
                                                        break;
                                                    }
                                                    let _e654 = global_3.member[_e631].member[_e641];
                                                    if (_e642 < 9u) {
                                                    } else {
                                                        phi_2577_ = true;
                                                        break;
                                                    }
                                                    let _e660 = global_3.member[_e631].member[_e642];
                                                    let _e662 = (3u + _e640);
                                                    if (_e662 < 9u) {
                                                    } else {
                                                        phi_2577_ = true;
                                                        break;
                                                    }
                                                    let _e668 = global_3.member[_e631].member[_e662];
                                                    let _e669 = (3u + _e641);
                                                    if (_e669 < 9u) {
                                                    } else {
                                                        phi_2577_ = true;
                                                        break;
                                                    }
                                                    let _e675 = global_3.member[_e631].member[_e669];
                                                    let _e676 = (3u + _e642);
                                                    if (_e676 < 9u) {
                                                    } else {
                                                        phi_2577_ = true;
                                                        break;
                                                    }
                                                    let _e682 = global_3.member[_e631].member[_e676];
                                                    let _e684 = (6u + _e640);
                                                    if (_e684 < 9u) {
                                                    } else {
                                                        phi_2577_ = true;
                                                        break;
                                                    }
                                                    let _e690 = global_3.member[_e631].member[_e684];
                                                    let _e691 = (6u + _e641);
                                                    if (_e691 < 9u) {
                                                    } else {
                                                        phi_2577_ = true;
                                                        break;
                                                    }
                                                    let _e697 = global_3.member[_e631].member[_e691];
                                                    let _e698 = (6u + _e642);
                                                    if (_e698 < 9u) {
                                                    } else {
                                                        phi_2577_ = true;
                                                        break;
                                                    }
                                                    let _e704 = global_3.member[_e631].member[_e698];
                                                    phi_1104_ = array<array<f32, 3>, 3>(array<f32, 3>(_e648, _e654, _e660), array<f32, 3>(_e668, _e675, _e682), array<f32, 3>(_e690, _e697, _e704));
                                                }
                                                let _e708 = phi_1104_;
                                                let _e717 = (_e708[0][2] - _e400);
                                                let _e720 = (((_e708[0][0] - _e263) * _e439) - (_e717 * _e303));
                                                let _e723 = (((_e708[0][1] - _e332) * _e439) - (_e717 * _e371));
                                                let _e730 = (_e708[1][2] - _e400);
                                                let _e733 = (((_e708[1][0] - _e263) * _e439) - (_e730 * _e303));
                                                let _e736 = (((_e708[1][1] - _e332) * _e439) - (_e730 * _e371));
                                                let _e743 = (_e708[2][2] - _e400);
                                                let _e746 = (((_e708[2][0] - _e263) * _e439) - (_e743 * _e303));
                                                let _e749 = (((_e708[2][1] - _e332) * _e439) - (_e743 * _e371));
                                                let _e750 = (_e746 * _e736);
                                                let _e751 = (_e749 * _e733);
                                                let _e752 = (_e720 * _e749);
                                                let _e753 = (_e723 * _e746);
                                                let _e754 = (_e733 * _e723);
                                                let _e755 = (_e736 * _e720);
                                                let _e760 = (((_e750 >= _e751) && (_e752 >= _e753)) && (_e754 >= _e755));
                                                if (_e760 || (((_e750 <= _e751) && (_e752 <= _e753)) && (_e754 <= _e755))) {
                                                    let _e767 = select(-1f, 1f, _e760);
                                                    let _e769 = ((_e750 - _e751) * _e767);
                                                    let _e771 = select(0f, _e769, (_e769 > 0f));
                                                    let _e773 = ((_e752 - _e753) * _e767);
                                                    let _e775 = select(0f, _e773, (_e773 > 0f));
                                                    let _e777 = ((_e754 - _e755) * _e767);
                                                    let _e779 = select(0f, _e777, (_e777 > 0f));
                                                    let _e781 = ((_e771 + _e775) + _e779);
                                                    if (_e781 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1988_ = type_27();
                                                        phi_1989_ = true;
                                                        phi_1990_ = false;
                                                    } else {
                                                        let _e784 = select(_e733, _e720, (_e720 < _e733));
                                                        if (select(_e746, _e784, (_e784 < _e746)) > 0f) {
                                                            phi_1256_ = true;
                                                        } else {
                                                            let _e789 = select(_e733, _e720, (_e720 > _e733));
                                                            phi_1256_ = (select(_e746, _e789, (_e789 > _e746)) < 0f);
                                                        }
                                                        let _e794 = phi_1256_;
                                                        if _e794 {
                                                            phi_1985_ = type_27();
                                                            phi_1986_ = true;
                                                            phi_1987_ = false;
                                                        } else {
                                                            let _e796 = select(_e736, _e723, (_e723 < _e736));
                                                            if (select(_e749, _e796, (_e796 < _e749)) > 0f) {
                                                                phi_1285_ = true;
                                                            } else {
                                                                let _e801 = select(_e736, _e723, (_e723 > _e736));
                                                                phi_1285_ = (select(_e749, _e801, (_e801 > _e749)) < 0f);
                                                            }
                                                            let _e806 = phi_1285_;
                                                            if _e806 {
                                                                phi_1983_ = type_27();
                                                                phi_1984_ = false;
                                                            } else {
                                                                let _e808 = select(_e708[1][0], _e708[0][0], (_e708[0][0] < _e708[1][0]));
                                                                let _e812 = select(_e708[1][0], _e708[0][0], (_e708[0][0] > _e708[1][0]));
                                                                let _e816 = select(_e708[1][1], _e708[0][1], (_e708[0][1] < _e708[1][1]));
                                                                let _e820 = select(_e708[1][1], _e708[0][1], (_e708[0][1] > _e708[1][1]));
                                                                let _e824 = select(_e708[1][2], _e708[0][2], (_e708[0][2] < _e708[1][2]));
                                                                let _e828 = select(_e708[1][2], _e708[0][2], (_e708[0][2] > _e708[1][2]));
                                                                let _e833 = ((select(_e708[2][0], _e808, (_e808 < _e708[2][0])) - _e301) * _e306);
                                                                let _e834 = ((select(_e708[2][0], _e812, (_e812 > _e708[2][0])) - _e302) * _e306);
                                                                let _e837 = ((select(_e708[2][1], _e816, (_e816 < _e708[2][1])) - _e369) * _e374);
                                                                let _e838 = ((select(_e708[2][1], _e820, (_e820 > _e708[2][1])) - _e370) * _e374);
                                                                let _e841 = ((select(_e708[2][2], _e824, (_e824 < _e708[2][2])) - _e437) * _e442);
                                                                let _e842 = ((select(_e708[2][2], _e828, (_e828 > _e708[2][2])) - _e438) * _e442);
                                                                let _e844 = select(_e842, _e841, (_e841 < _e842));
                                                                let _e846 = select(_e842, _e841, (_e841 > _e842));
                                                                let _e848 = select(_e834, _e833, (_e833 < _e834));
                                                                let _e850 = select(_e838, _e837, (_e837 < _e838));
                                                                let _e852 = select(_e850, _e848, (_e848 > _e850));
                                                                let _e854 = select(_e844, _e852, (_e852 > _e844));
                                                                let _e856 = select(_e834, _e833, (_e833 > _e834));
                                                                let _e858 = select(_e838, _e837, (_e837 > _e838));
                                                                let _e860 = select(_e858, _e856, (_e856 < _e858));
                                                                let _e862 = select(_e846, _e860, (_e860 < _e846));
                                                                let _e863 = -(_e844);
                                                                let _e869 = select(_e554, _e854, (_e854 > _e554));
                                                                if (_e869 > (_e862 + (select(_e863, _e846, (_e846 > _e863)) * 0.0000019073523f))) {
                                                                    phi_1978_ = type_27();
                                                                    phi_1979_ = true;
                                                                } else {
                                                                    let _e871 = (_e869 > _e603.member.member_1);
                                                                    if _e871 {
                                                                        phi_1977_ = type_27();
                                                                    } else {
                                                                        let _e872 = vec3<f32>(_e708[0][0], _e708[0][1], _e708[0][2]);
                                                                        let _e873 = vec3<f32>(_e708[1][0], _e708[1][1], _e708[1][2]);
                                                                        let _e874 = vec3<f32>(_e708[2][0], _e708[2][1], _e708[2][2]);
                                                                        let _e875 = (_e708[1][0] - _e708[0][0]);
                                                                        let _e876 = (_e708[1][1] - _e708[0][1]);
                                                                        let _e877 = (_e708[1][2] - _e708[0][2]);
                                                                        let _e878 = vec3<f32>(_e875, _e876, _e877);
                                                                        let _e879 = (_e708[2][0] - _e708[1][0]);
                                                                        let _e880 = (_e708[2][1] - _e708[1][1]);
                                                                        let _e881 = (_e708[2][2] - _e708[1][2]);
                                                                        let _e882 = vec3<f32>(_e879, _e880, _e881);
                                                                        let _e883 = (_e708[0][0] - _e708[2][0]);
                                                                        let _e884 = (_e708[0][1] - _e708[2][1]);
                                                                        let _e885 = (_e708[0][2] - _e708[2][2]);
                                                                        let _e886 = vec3<f32>(_e883, _e884, _e885);
                                                                        let _e889 = bitcast<f32>((bitcast<u32>(_e875) & 2147483647u));
                                                                        let _e892 = bitcast<f32>((bitcast<u32>(_e876) & 2147483647u));
                                                                        let _e894 = select(_e892, _e889, (_e889 > _e892));
                                                                        let _e897 = bitcast<f32>((bitcast<u32>(_e877) & 2147483647u));
                                                                        let _e899 = select(_e897, _e894, (_e894 > _e897));
                                                                        let _e902 = bitcast<f32>((bitcast<u32>(_e879) & 2147483647u));
                                                                        let _e905 = bitcast<f32>((bitcast<u32>(_e880) & 2147483647u));
                                                                        let _e907 = select(_e905, _e902, (_e902 > _e905));
                                                                        let _e910 = bitcast<f32>((bitcast<u32>(_e881) & 2147483647u));
                                                                        let _e912 = select(_e910, _e907, (_e907 > _e910));
                                                                        let _e915 = bitcast<f32>((bitcast<u32>(_e883) & 2147483647u));
                                                                        let _e918 = bitcast<f32>((bitcast<u32>(_e884) & 2147483647u));
                                                                        let _e920 = select(_e918, _e915, (_e915 > _e918));
                                                                        let _e923 = bitcast<f32>((bitcast<u32>(_e885) & 2147483647u));
                                                                        let _e925 = select(_e923, _e920, (_e920 > _e923));
                                                                        let _e927 = select(_e912, _e899, (_e899 > _e912));
                                                                        let _e929 = select(_e925, _e927, (_e927 > _e925));
                                                                        if (_e899 == _e929) {
                                                                            phi_1704_ = _e736;
                                                                            phi_1705_ = _e733;
                                                                            phi_1706_ = _e723;
                                                                            phi_1707_ = _e720;
                                                                            phi_1708_ = _e872;
                                                                            phi_1709_ = _e886;
                                                                            phi_1710_ = _e882;
                                                                            phi_1711_ = _e878;
                                                                        } else {
                                                                            let _e931 = (_e912 == _e929);
                                                                            let _e936 = vec3(_e931);
                                                                            phi_1704_ = select(_e723, _e749, _e931);
                                                                            phi_1705_ = select(_e720, _e746, _e931);
                                                                            phi_1706_ = select(_e749, _e736, _e931);
                                                                            phi_1707_ = select(_e746, _e733, _e931);
                                                                            phi_1708_ = select(_e874, _e873, _e936);
                                                                            phi_1709_ = select(_e882, _e878, _e936);
                                                                            phi_1710_ = select(_e878, _e886, _e936);
                                                                            phi_1711_ = select(_e886, _e882, _e936);
                                                                        }
                                                                        let _e942 = phi_1704_;
                                                                        let _e944 = phi_1705_;
                                                                        let _e946 = phi_1706_;
                                                                        let _e948 = phi_1707_;
                                                                        let _e950 = phi_1708_;
                                                                        let _e952 = phi_1709_;
                                                                        let _e954 = phi_1710_;
                                                                        let _e956 = phi_1711_;
                                                                        let _e963 = ((_e954.y * _e952.z) - (_e952.y * _e954.z));
                                                                        let _e968 = ((_e954.z * _e952.x) - (_e952.z * _e954.x));
                                                                        let _e971 = ((_e954.x * _e952.y) - (_e952.x * _e954.y));
                                                                        if (_e771 >= _e775) {
                                                                            phi_1748_ = select(true, false, (_e771 >= _e779));
                                                                        } else {
                                                                            phi_1748_ = true;
                                                                        }
                                                                        let _e976 = phi_1748_;
                                                                        if _e976 {
                                                                            phi_1757_ = select(_e874, _e873, vec3((_e775 >= _e779)));
                                                                        } else {
                                                                            phi_1757_ = _e872;
                                                                        }
                                                                        let _e981 = phi_1757_;
                                                                        let _e992 = (((_e963 * (_e981.x - _e263)) + (_e968 * (_e981.y - _e332))) + (_e971 * (_e981.z - _e400)));
                                                                        let _e997 = (((_e963 * _e303) + (_e968 * _e371)) + (_e971 * _e439));
                                                                        let _e998 = (_e944 - _e948);
                                                                        let _e999 = (_e942 - _e946);
                                                                        let _e1007 = (-(((_e948 * _e998) + (_e946 * _e999))) / ((_e998 * _e998) + (_e999 * _e999)));
                                                                        let _e1009 = select(1f, _e1007, (_e1007 < 1f));
                                                                        let _e1011 = select(0f, _e1009, (_e1009 > 0f));
                                                                        let _e1024 = ((_e950.x + (_e956.x * _e1011)) - _e263);
                                                                        let _e1025 = ((_e950.y + (_e956.y * _e1011)) - _e332);
                                                                        let _e1026 = ((_e950.z + (_e956.z * _e1011)) - _e400);
                                                                        let _e1027 = (_e1026 / _e439);
                                                                        let _e1039 = bitcast<f32>((bitcast<u32>(_e1024) & 2147483647u));
                                                                        let _e1042 = bitcast<f32>((bitcast<u32>(_e1025) & 2147483647u));
                                                                        let _e1044 = select(_e1042, _e1039, (_e1039 > _e1042));
                                                                        let _e1047 = bitcast<f32>((bitcast<u32>(_e1026) & 2147483647u));
                                                                        let _e1049 = select(_e1047, _e1044, (_e1044 > _e1047));
                                                                        let _e1055 = bitcast<f32>((bitcast<u32>(_e963) & 2147483647u));
                                                                        let _e1058 = bitcast<f32>((bitcast<u32>(_e968) & 2147483647u));
                                                                        let _e1060 = select(_e1058, _e1055, (_e1055 > _e1058));
                                                                        let _e1063 = bitcast<f32>((bitcast<u32>(_e971) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e963 * _e1024) + (_e968 * _e1025)) + (_e971 * _e1026)) - _e992)) & 2147483647u)) <= ((0.0000009536743f * select(_e929, _e1049, (_e1049 > _e929))) * select(_e1063, _e1060, (_e1060 > _e1063)))) {
                                                                            let _e1073 = bitcast<f32>((bitcast<u32>(_e954.x) & 2147483647u));
                                                                            let _e1076 = bitcast<f32>((bitcast<u32>(_e954.y) & 2147483647u));
                                                                            let _e1078 = select(_e1076, _e1073, (_e1073 > _e1076));
                                                                            let _e1081 = bitcast<f32>((bitcast<u32>(_e954.z) & 2147483647u));
                                                                            let _e1087 = bitcast<f32>((bitcast<u32>(_e952.x) & 2147483647u));
                                                                            let _e1090 = bitcast<f32>((bitcast<u32>(_e952.y) & 2147483647u));
                                                                            let _e1092 = select(_e1090, _e1087, (_e1087 > _e1090));
                                                                            let _e1095 = bitcast<f32>((bitcast<u32>(_e952.z) & 2147483647u));
                                                                            let _e1099 = (bitcast<f32>((bitcast<u32>(_e997) & 2147483647u)) > ((0.0000038146973f * select(_e1081, _e1078, (_e1078 > _e1081))) * select(_e1095, _e1092, (_e1092 > _e1095))));
                                                                            if _e1099 {
                                                                                phi_1922_ = (_e992 / _e997);
                                                                            } else {
                                                                                phi_1922_ = f32();
                                                                            }
                                                                            let _e1102 = phi_1922_;
                                                                            phi_1924_ = _e1102;
                                                                            phi_1925_ = select(true, false, _e1099);
                                                                        } else {
                                                                            phi_1924_ = f32();
                                                                            phi_1925_ = true;
                                                                        }
                                                                        let _e1105 = phi_1924_;
                                                                        let _e1107 = phi_1925_;
                                                                        if _e1107 {
                                                                            let _e1115 = (((_e963 * (_e1024 - (_e303 * _e1027))) + (_e968 * (_e1025 - (_e371 * _e1027)))) / _e997);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1115) & 2147483647u)) <= _e929) {
                                                                                phi_1945_ = (_e1027 + _e1115);
                                                                            } else {
                                                                                phi_1945_ = _e1027;
                                                                            }
                                                                            let _e1122 = phi_1945_;
                                                                            phi_1946_ = _e1122;
                                                                        } else {
                                                                            phi_1946_ = _e1105;
                                                                        }
                                                                        let _e1124 = phi_1946_;
                                                                        let _e1126 = select(_e862, _e1124, (_e1124 < _e862));
                                                                        let _e1128 = select(_e854, _e1126, (_e1126 > _e854));
                                                                        if (_e1128 >= _e554) {
                                                                            let _e1130 = (_e1128 <= _e603.member.member_1);
                                                                            if _e1130 {
                                                                                let _e1131 = (1f / _e781);
                                                                                phi_1969_ = type_27(_e1128, (_e775 * _e1131), (_e779 * _e1131), _e638);
                                                                            } else {
                                                                                phi_1969_ = type_27();
                                                                            }
                                                                            let _e1136 = phi_1969_;
                                                                            phi_1971_ = _e1136;
                                                                            phi_1972_ = select(true, false, _e1130);
                                                                        } else {
                                                                            phi_1971_ = type_27();
                                                                            phi_1972_ = true;
                                                                        }
                                                                        let _e1139 = phi_1971_;
                                                                        let _e1141 = phi_1972_;
                                                                        if _e1141 {
                                                                            phi_1976_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1976_ = _e1139;
                                                                        }
                                                                        let _e1143 = phi_1976_;
                                                                        phi_1977_ = _e1143;
                                                                    }
                                                                    let _e1145 = phi_1977_;
                                                                    phi_1978_ = _e1145;
                                                                    phi_1979_ = _e871;
                                                                }
                                                                let _e1147 = phi_1978_;
                                                                let _e1149 = phi_1979_;
                                                                phi_1983_ = _e1147;
                                                                phi_1984_ = _e1149;
                                                            }
                                                            let _e1151 = phi_1983_;
                                                            let _e1153 = phi_1984_;
                                                            phi_1985_ = _e1151;
                                                            phi_1986_ = _e806;
                                                            phi_1987_ = _e1153;
                                                        }
                                                        let _e1155 = phi_1985_;
                                                        let _e1157 = phi_1986_;
                                                        let _e1159 = phi_1987_;
                                                        phi_1988_ = _e1155;
                                                        phi_1989_ = _e1157;
                                                        phi_1990_ = _e1159;
                                                    }
                                                    let _e1161 = phi_1988_;
                                                    let _e1163 = phi_1989_;
                                                    let _e1165 = phi_1990_;
                                                    phi_1998_ = _e1161;
                                                    phi_1999_ = select(_e1165, true, _e1163);
                                                } else {
                                                    phi_1998_ = type_27();
                                                    phi_1999_ = true;
                                                }
                                                let _e1168 = phi_1998_;
                                                let _e1170 = phi_1999_;
                                                if _e1170 {
                                                    phi_2003_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2003_ = _e1168;
                                                }
                                                let _e1172 = phi_2003_;
                                                if (_e1172.member_3 != 4294967295u) {
                                                    if (_e638 != 4294967295u) {
                                                        if (_e1172.member < _e603.member.member.member) {
                                                            phi_2029_ = true;
                                                        } else {
                                                            if (_e1172.member == _e603.member.member.member) {
                                                                phi_2028_ = (_e1172.member_3 < _e603.member.member.member_3);
                                                            } else {
                                                                phi_2028_ = false;
                                                            }
                                                            let _e1187 = phi_2028_;
                                                            phi_2029_ = _e1187;
                                                        }
                                                        let _e1189 = phi_2029_;
                                                        if _e1189 {
                                                            phi_2036_ = type_48(type_40(_e1172, _e1172.member), _e630.member_1, _e630.member_2);
                                                        } else {
                                                            phi_2036_ = _e630;
                                                        }
                                                        let _e1196 = phi_2036_;
                                                        phi_2037_ = _e1196;
                                                    } else {
                                                        phi_2037_ = _e630;
                                                    }
                                                    let _e1198 = phi_2037_;
                                                    phi_2038_ = _e1198;
                                                } else {
                                                    phi_2038_ = _e630;
                                                }
                                                let _e1200 = phi_2038_;
                                                phi_963_ = _e1200;
                                            } else {
                                                phi_963_ = type_48();
                                            }
                                            let _e1202 = phi_963_;
                                            continue;
                                            continuing {
                                                phi_962_ = _e1202;
                                                phi_965_ = _e618;
                                                phi_2577_ = _e563;
                                                break if !(_e624);
                                            }
                                        }
                                        let _e1205 = phi_2577_;
                                        phi_2737_ = _e1205;
                                        if _e1205 {
                                            break;
                                        }
                                        phi_2772_ = _e1205;
                                        let _e1566 = local_4;
                                        phi_2039_ = _e1566;
                                    } else {
                                        phi_2772_ = _e563;
                                        phi_2039_ = _e565;
                                    }
                                    let _e1207 = phi_2772_;
                                    let _e1209 = phi_2039_;
                                    if _e596 {
                                        phi_2523_ = type_48();
                                        phi_2524_ = bool();
                                        phi_2525_ = u32();
                                        phi_2526_ = u32();
                                    } else {
                                        if (_e593 >= _e71) {
                                            phi_2104_ = type_44(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e593 < _e71) {
                                            } else {
                                                phi_2737_ = true;
                                                break;
                                            }
                                            let _e1212 = (_e199 % 3u);
                                            if (_e1212 < 3u) {
                                            } else {
                                                phi_2737_ = true;
                                                break;
                                            }
                                            let _e1218 = global_2.member[_e593].member[_e1212];
                                            let _e1224 = (_e198 % 3u);
                                            if (_e1224 < 3u) {
                                            } else {
                                                phi_2737_ = true;
                                                break;
                                            }
                                            let _e1230 = global_2.member[_e593].member[_e1224];
                                            let _e1236 = (_e200 % 3u);
                                            if (_e1236 < 3u) {
                                            } else {
                                                phi_2737_ = true;
                                                break;
                                            }
                                            let _e1242 = global_2.member[_e593].member[_e1236];
                                            let _e1252 = global_2.member[_e593].member_1;
                                            let _e1256 = global_2.member[_e593].member_2;
                                            phi_2104_ = type_44(array<vec4<f32>, 3>(vec4<f32>(_e1218[0], _e1218[1], _e1218[2], _e1218[3]), vec4<f32>(_e1230[0], _e1230[1], _e1230[2], _e1230[3]), vec4<f32>(_e1242[0], _e1242[1], _e1242[2], _e1242[3])), _e1252, _e1256);
                                        }
                                        let _e1259 = phi_2104_;
                                        let _e1278 = ((_e1259.member[0].x - _e301) * _e306);
                                        let _e1279 = ((_e1259.member[0].y - _e301) * _e306);
                                        let _e1280 = ((_e1259.member[0].z - _e302) * _e306);
                                        let _e1281 = ((_e1259.member[0].w - _e302) * _e306);
                                        let _e1291 = ((_e1259.member[1].x - _e369) * _e374);
                                        let _e1292 = ((_e1259.member[1].y - _e369) * _e374);
                                        let _e1293 = ((_e1259.member[1].z - _e370) * _e374);
                                        let _e1294 = ((_e1259.member[1].w - _e370) * _e374);
                                        let _e1304 = ((_e1259.member[2].x - _e437) * _e442);
                                        let _e1305 = ((_e1259.member[2].y - _e437) * _e442);
                                        let _e1306 = ((_e1259.member[2].z - _e438) * _e442);
                                        let _e1307 = ((_e1259.member[2].w - _e438) * _e442);
                                        let _e1309 = select(_e1306, _e1304, (_e1304 < _e1306));
                                        let _e1311 = select(_e1307, _e1305, (_e1305 < _e1307));
                                        let _e1313 = select(_e1306, _e1304, (_e1304 > _e1306));
                                        let _e1315 = select(_e1307, _e1305, (_e1305 > _e1307));
                                        let _e1317 = select(_e1280, _e1278, (_e1278 < _e1280));
                                        let _e1319 = select(_e1281, _e1279, (_e1279 < _e1281));
                                        let _e1321 = select(_e1293, _e1291, (_e1291 < _e1293));
                                        let _e1323 = select(_e1294, _e1292, (_e1292 < _e1294));
                                        let _e1325 = select(_e1321, _e1317, (_e1317 > _e1321));
                                        let _e1327 = select(_e1323, _e1319, (_e1319 > _e1323));
                                        let _e1329 = select(_e1309, _e1325, (_e1325 > _e1309));
                                        let _e1331 = select(_e1311, _e1327, (_e1327 > _e1311));
                                        let _e1333 = select(_e1280, _e1278, (_e1278 > _e1280));
                                        let _e1335 = select(_e1281, _e1279, (_e1279 > _e1281));
                                        let _e1337 = select(_e1293, _e1291, (_e1291 > _e1293));
                                        let _e1339 = select(_e1294, _e1292, (_e1292 > _e1294));
                                        let _e1341 = select(_e1337, _e1333, (_e1333 < _e1337));
                                        let _e1343 = select(_e1339, _e1335, (_e1335 < _e1339));
                                        let _e1348 = -(_e1309);
                                        let _e1349 = -(_e1311);
                                        let _e1356 = (select(_e1313, _e1341, (_e1341 < _e1313)) + (select(_e1348, _e1313, (_e1313 > _e1348)) * 0.0000019073523f));
                                        let _e1357 = (select(_e1315, _e1343, (_e1343 < _e1315)) + (select(_e1349, _e1315, (_e1315 > _e1349)) * 0.0000019073523f));
                                        let _e1359 = select(_e554, _e1329, (_e1329 > _e554));
                                        let _e1361 = select(_e554, _e1331, (_e1331 > _e554));
                                        let _e1366 = (_e1359 <= select(_e1209.member.member_1, _e1356, (_e1356 < _e1209.member.member_1)));
                                        let _e1367 = (_e1361 <= select(_e1209.member.member_1, _e1357, (_e1357 < _e1209.member.member_1)));
                                        let _e1368 = (_e1359 <= _e1361);
                                        if _e1366 {
                                            if _e1367 {
                                                if _e1368 {
                                                    phi_2469_ = _e1259.member_2;
                                                } else {
                                                    phi_2469_ = _e1259.member_1;
                                                }
                                                let _e1372 = phi_2469_;
                                                let _e1374 = (_e591 % 128u);
                                                let _e1375 = (_e1374 < 128u);
                                                if _e1375 {
                                                } else {
                                                    phi_2737_ = true;
                                                    break;
                                                }
                                                local_1[_e1374] = _e1372;
                                                if _e1375 {
                                                } else {
                                                    phi_2737_ = true;
                                                    break;
                                                }
                                                local[_e1374] = select(_e1359, _e1361, _e1368);
                                                if _e1368 {
                                                    phi_2496_ = _e1259.member_1;
                                                } else {
                                                    phi_2496_ = _e1259.member_2;
                                                }
                                                let _e1382 = phi_2496_;
                                                phi_2497_ = (_e591 + 1u);
                                                phi_2498_ = _e1382;
                                            } else {
                                                phi_2497_ = u32();
                                                phi_2498_ = u32();
                                            }
                                            let _e1384 = phi_2497_;
                                            let _e1386 = phi_2498_;
                                            phi_2500_ = _e1384;
                                            phi_2501_ = _e1386;
                                            phi_2502_ = select(true, false, _e1367);
                                        } else {
                                            phi_2500_ = u32();
                                            phi_2501_ = u32();
                                            phi_2502_ = true;
                                        }
                                        let _e1389 = phi_2500_;
                                        let _e1391 = phi_2501_;
                                        let _e1393 = phi_2502_;
                                        if _e1393 {
                                            if _e1366 {
                                                phi_2511_ = _e1259.member_1;
                                            } else {
                                                phi_2511_ = _e1259.member_2;
                                            }
                                            let _e1397 = phi_2511_;
                                            phi_2516_ = select(_e1367, true, _e1366);
                                            phi_2518_ = _e1397;
                                        } else {
                                            phi_2516_ = _e589;
                                            phi_2518_ = _e1391;
                                        }
                                        let _e1400 = phi_2516_;
                                        let _e1402 = phi_2518_;
                                        phi_2523_ = type_48(_e1209.member, (_e1209.member_1 + 1u), _e1209.member_2);
                                        phi_2524_ = _e1400;
                                        phi_2525_ = select(_e1389, _e591, _e1393);
                                        phi_2526_ = _e1402;
                                    }
                                    let _e1405 = phi_2523_;
                                    let _e1407 = phi_2524_;
                                    let _e1409 = phi_2525_;
                                    let _e1411 = phi_2526_;
                                    if _e596 {
                                        phi_2534_ = _e1209;
                                    } else {
                                        phi_2534_ = _e1405;
                                    }
                                    let _e1413 = phi_2534_;
                                    phi_2740_ = _e1207;
                                    phi_2538_ = _e1413;
                                    phi_2539_ = (_e567 - 1u);
                                    phi_2540_ = select(_e1407, false, _e596);
                                    phi_2541_ = select(_e1409, _e591, _e596);
                                    phi_2542_ = select(_e1411, _e593, _e596);
                                } else {
                                    phi_2740_ = _e563;
                                    phi_2538_ = _e565;
                                    phi_2539_ = _e567;
                                    phi_2540_ = _e589;
                                    phi_2541_ = _e591;
                                    phi_2542_ = _e593;
                                }
                                let _e1418 = phi_2740_;
                                let _e1420 = phi_2538_;
                                let _e1422 = phi_2539_;
                                let _e1424 = phi_2540_;
                                let _e1426 = phi_2541_;
                                let _e1428 = phi_2542_;
                                phi_2739_ = _e1418;
                                phi_2543_ = _e1420;
                                phi_2544_ = _e1422;
                                phi_2545_ = _e1424;
                                phi_2546_ = _e1426;
                                phi_2547_ = _e1428;
                            } else {
                                phi_2739_ = _e563;
                                phi_2543_ = type_48();
                                phi_2544_ = u32();
                                phi_2545_ = bool();
                                phi_2546_ = u32();
                                phi_2547_ = u32();
                            }
                            let _e1430 = phi_2739_;
                            let _e1432 = phi_2543_;
                            let _e1434 = phi_2544_;
                            let _e1436 = phi_2545_;
                            let _e1438 = phi_2546_;
                            let _e1440 = phi_2547_;
                            phi_2738_ = _e1430;
                            phi_894_ = _e1432;
                            phi_897_ = _e1434;
                            phi_899_ = _e1436;
                            phi_901_ = _e1438;
                            phi_903_ = _e1440;
                            phi_2548_ = _e577;
                        } else {
                            phi_2738_ = _e563;
                            phi_894_ = type_48();
                            phi_897_ = u32();
                            phi_899_ = bool();
                            phi_901_ = u32();
                            phi_903_ = u32();
                            phi_2548_ = false;
                        }
                        let _e1442 = phi_2738_;
                        let _e1444 = phi_894_;
                        let _e1446 = phi_897_;
                        let _e1448 = phi_899_;
                        let _e1450 = phi_901_;
                        let _e1452 = phi_903_;
                        let _e1454 = phi_2548_;
                        continue;
                        continuing {
                            phi_2583_ = _e1442;
                            phi_893_ = _e1444;
                            phi_896_ = _e1446;
                            phi_898_ = _e1448;
                            phi_900_ = _e1450;
                            phi_902_ = _e1452;
                            phi_2737_ = _e1442;
                            break if !(_e1454);
                        }
                    }
                    let _e1457 = phi_2737_;
                    if _e1457 {
                        break;
                    }
                    let _e1459 = local_2;
                    let _e1462 = local_3;
                    if _e87 {
                    } else {
                        break;
                    }
                    global_5.member[_e81][0u] = _e1459.member_1;
                    global_5.member[_e81][1u] = _e1462.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
