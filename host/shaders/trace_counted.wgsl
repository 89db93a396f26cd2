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
    var phi_2577_: bool;
    var phi_893_: type_48;
    var phi_896_: bool;
    var phi_898_: u32;
    var phi_900_: u32;
    var phi_902_: u32;
    var phi_913_: bool;
    var phi_945_: bool;
    var phi_946_: u32;
    var phi_947_: u32;
    var phi_2108_: type_44;
    var phi_2473_: u32;
    var phi_2501_: u32;
    var phi_2502_: u32;
    var phi_2503_: u32;
    var phi_2505_: u32;
    var phi_2506_: u32;
    var phi_2507_: bool;
    var phi_2516_: u32;
    var phi_2521_: bool;
    var phi_2523_: u32;
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
    var phi_2571_: bool;
    var phi_2735_: bool;
    var phi_2528_: type_48;
    var phi_2529_: bool;
    var phi_2530_: u32;
    var phi_2531_: u32;
    var phi_2734_: bool;
    var phi_2532_: type_48;
    var phi_2533_: bool;
    var phi_2534_: u32;
    var phi_2535_: u32;
    var phi_2536_: u32;
    var phi_2733_: bool;
    var phi_2537_: type_48;
    var phi_2538_: bool;
    var phi_2539_: u32;
    var phi_2540_: u32;
    var phi_2541_: u32;
    var phi_2732_: bool;
    var phi_894_: type_48;
    var phi_897_: bool;
    var phi_899_: u32;
    var phi_901_: u32;
    var phi_903_: u32;
    var phi_2542_: bool;
    var phi_2731_: bool;
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
                    phi_2577_ = false;
                    phi_893_ = type_48(type_40(type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e552), 0u, 0u);
                    phi_896_ = (_e554 <= _e552);
                    phi_898_ = ((3u * _e71) + 1u);
                    phi_900_ = 0u;
                    phi_902_ = select(0u, 2147483648u, (_e71 == 0u));
                    loop {
                        let _e563 = phi_2577_;
                        let _e565 = phi_893_;
                        let _e567 = phi_896_;
                        let _e569 = phi_898_;
                        let _e571 = phi_900_;
                        let _e573 = phi_902_;
                        local_2 = _e565;
                        local_3 = _e565;
                        if _e567 {
                            phi_913_ = true;
                        } else {
                            phi_913_ = (_e571 > 0u);
                        }
                        let _e576 = phi_913_;
                        if _e576 {
                            let _e577 = (_e569 > 0u);
                            if _e577 {
                                if _e567 {
                                    phi_945_ = _e567;
                                    phi_946_ = _e571;
                                    phi_947_ = _e573;
                                } else {
                                    let _e578 = (_e571 - 1u);
                                    let _e579 = (_e578 % 128u);
                                    let _e580 = (_e579 < 128u);
                                    if _e580 {
                                    } else {
                                        phi_2731_ = true;
                                        break;
                                    }
                                    let _e582 = local_1[_e579];
                                    if _e580 {
                                    } else {
                                        phi_2731_ = true;
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
                                    if ((_e593 & 2147483648u) != 0u) {
                                        phi_962_ = _e565;
                                        phi_965_ = type_4(0u, ((_e593 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e798 = phi_962_;
                                            let _e800 = phi_965_;
                                            local_4 = _e798;
                                            if (_e800.member < _e800.member_1) {
                                                phi_966_ = type_4((_e800.member + 1u), _e800.member_1);
                                                phi_988_ = type_4(1u, _e800.member);
                                            } else {
                                                phi_966_ = _e800;
                                                phi_988_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e813 = phi_966_;
                                            let _e815 = phi_988_;
                                            let _e819 = (bitcast<i32>(_e815.member) != 0i);
                                            if _e819 {
                                                let _e825 = type_48(_e798.member, _e798.member_1, (_e798.member_2 + 1u));
                                                let _e826 = ((_e593 & 268435455u) + _e815.member_1);
                                                let _e827 = (_e826 < _e73);
                                                if _e827 {
                                                    if _e827 {
                                                    } else {
                                                        phi_2571_ = true;
                                                        break;
                                                    }
                                                    let _e831 = global_3.member[_e826].member_1;
                                                    phi_1012_ = _e831;
                                                } else {
                                                    phi_1012_ = 4294967295u;
                                                }
                                                let _e833 = phi_1012_;
                                                if (_e826 >= _e73) {
                                                    phi_1104_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e827 {
                                                    } else {
                                                        phi_2571_ = true;
                                                        break;
                                                    }
                                                    let _e835 = (_e199 % 3u);
                                                    let _e836 = (_e198 % 3u);
                                                    let _e837 = (_e200 % 3u);
                                                    if (_e835 < 9u) {
                                                    } else {
                                                        phi_2571_ = true;
                                                        break;
                                                    }
                                                    let _e843 = global_3.member[_e826].member[_e835];
                                                    if (_e836 < 9u) {
                                                    } else {
                                                        phi_2571_ = true;
                                                        break;
                                                    }
                                                    let _e849 = global_3.member[_e826].member[_e836];
                                                    if (_e837 < 9u) {
                                                    } else {
                                                        phi_2571_ = true;
                                                        break;
                                                    }
                                                    let _e855 = global_3.member[_e826].member[_e837];
                                                    let _e857 = (3u + _e835);
                                                    if (_e857 < 9u) {
                                                    } else {
                                                        phi_2571_ = true;
                                                        break;
                                                    }
                                                    let _e863 = global_3.member[_e826].member[_e857];
                                                    let _e864 = (3u + _e836);
                                                    if (_e864 < 9u) {
                                                    } else {
                                                        phi_2571_ = true;
                                                        break;
                                                    }
                                                    let _e870 = global_3.member[_e826].member[_e864];
                                                    let _e871 = (3u + _e837);
                                                    if (_e871 < 9u) {
                                                    } else {
                                                        phi_2571_ = true;
                                                        break;
                                                    }
                                                    let _e877 = global_3.member[_e826].member[_e871];
                                                    let _e879 = (6u + _e835);
                                                    if (_e879 < 9u) {
                                                    } else {
                                                        phi_2571_ = true;
                                                        break;
                                                    }
                                                    let _e885 = global_3.member[_e826].member[_e879];
                                                    let _e886 = (6u + _e836);
                                                    if (_e886 < 9u) {
                                                    } else {
                                                        phi_2571_ = true;
                                                        break;
                                                    }
                                                    let _e892 = global_3.member[_e826].member[_e886];
                                                    let _e893 = (6u + _e837);
                                                    if (_e893 < 9u) {
                                                    } else {
                                                        phi_2571_ = true;
                                                        break;
                                                    }
                                                    let _e899 = global_3.member[_e826].member[_e893];
                                                    phi_1104_ = array<array<f32, 3>, 3>(array<f32, 3>(_e843, _e849, _e855), array<f32, 3>(_e863, _e870, _e877), array<f32, 3>(_e885, _e892, _e899));
                                                }
                                                let _e903 = phi_1104_;
                                                let _e912 = (_e903[0][2] - _e400);
                                                let _e915 = (((_e903[0][0] - _e263) * _e439) - (_e912 * _e303));
                                                let _e918 = (((_e903[0][1] - _e332) * _e439) - (_e912 * _e371));
                                                let _e925 = (_e903[1][2] - _e400);
                                                let _e928 = (((_e903[1][0] - _e263) * _e439) - (_e925 * _e303));
                                                let _e931 = (((_e903[1][1] - _e332) * _e439) - (_e925 * _e371));
                                                let _e938 = (_e903[2][2] - _e400);
                                                let _e941 = (((_e903[2][0] - _e263) * _e439) - (_e938 * _e303));
                                                let _e944 = (((_e903[2][1] - _e332) * _e439) - (_e938 * _e371));
                                                let _e945 = (_e941 * _e931);
                                                let _e946 = (_e944 * _e928);
                                                let _e947 = (_e915 * _e944);
                                                let _e948 = (_e918 * _e941);
                                                let _e949 = (_e928 * _e918);
                                                let _e950 = (_e931 * _e915);
                                                let _e955 = (((_e945 >= _e946) && (_e947 >= _e948)) && (_e949 >= _e950));
                                                if (_e955 || (((_e945 <= _e946) && (_e947 <= _e948)) && (_e949 <= _e950))) {
                                                    let _e962 = select(-1f, 1f, _e955);
                                                    let _e964 = ((_e945 - _e946) * _e962);
                                                    let _e966 = select(0f, _e964, (_e964 > 0f));
                                                    let _e968 = ((_e947 - _e948) * _e962);
                                                    let _e970 = select(0f, _e968, (_e968 > 0f));
                                                    let _e972 = ((_e949 - _e950) * _e962);
                                                    let _e974 = select(0f, _e972, (_e972 > 0f));
                                                    let _e976 = ((_e966 + _e970) + _e974);
                                                    if (_e976 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1988_ = type_27();
                                                        phi_1989_ = true;
                                                        phi_1990_ = false;
                                                    } else {
                                                        let _e979 = select(_e928, _e915, (_e915 < _e928));
                                                        if (select(_e941, _e979, (_e979 < _e941)) > 0f) {
                                                            phi_1256_ = true;
                                                        } else {
                                                            let _e984 = select(_e928, _e915, (_e915 > _e928));
                                                            phi_1256_ = (select(_e941, _e984, (_e984 > _e941)) < 0f);
                                                        }
                                                        let _e989 = phi_1256_;
                                                        if _e989 {
                                                            phi_1985_ = type_27();
                                                            phi_1986_ = true;
                                                            phi_1987_ = false;
                                                        } else {
                                                            let _e991 = select(_e931, _e918, (_e918 < _e931));
                                                            if (select(_e944, _e991, (_e991 < _e944)) > 0f) {
                                                                phi_1285_ = true;
                                                            } else {
                                                                let _e996 = select(_e931, _e918, (_e918 > _e931));
                                                                phi_1285_ = (select(_e944, _e996, (_e996 > _e944)) < 0f);
                                                            }
                                                            let _e1001 = phi_1285_;
                                                            if _e1001 {
                                                                phi_1983_ = type_27();
                                                                phi_1984_ = false;
                                                            } else {
                                                                let _e1003 = select(_e903[1][0], _e903[0][0], (_e903[0][0] < _e903[1][0]));
                                                                let _e1007 = select(_e903[1][0], _e903[0][0], (_e903[0][0] > _e903[1][0]));
                                                                let _e1011 = select(_e903[1][1], _e903[0][1], (_e903[0][1] < _e903[1][1]));
                                                                let _e1015 = select(_e903[1][1], _e903[0][1], (_e903[0][1] > _e903[1][1]));
                                                                let _e1019 = select(_e903[1][2], _e903[0][2], (_e903[0][2] < _e903[1][2]));
                                                                let _e1023 = select(_e903[1][2], _e903[0][2], (_e903[0][2] > _e903[1][2]));
                                                                let _e1028 = ((select(_e903[2][0], _e1003, (_e1003 < _e903[2][0])) - _e301) * _e306);
                                                                let _e1029 = ((select(_e903[2][0], _e1007, (_e1007 > _e903[2][0])) - _e302) * _e306);
                                                                let _e1032 = ((select(_e903[2][1], _e1011, (_e1011 < _e903[2][1])) - _e369) * _e374);
                                                                let _e1033 = ((select(_e903[2][1], _e1015, (_e1015 > _e903[2][1])) - _e370) * _e374);
                                                                let _e1036 = ((select(_e903[2][2], _e1019, (_e1019 < _e903[2][2])) - _e437) * _e442);
                                                                let _e1037 = ((select(_e903[2][2], _e1023, (_e1023 > _e903[2][2])) - _e438) * _e442);
                                                                let _e1039 = select(_e1037, _e1036, (_e1036 < _e1037));
                                                                let _e1041 = select(_e1037, _e1036, (_e1036 > _e1037));
                                                                let _e1043 = select(_e1029, _e1028, (_e1028 < _e1029));
                                                                let _e1045 = select(_e1033, _e1032, (_e1032 < _e1033));
                                                                let _e1047 = select(_e1045, _e1043, (_e1043 > _e1045));
                                                                let _e1049 = select(_e1039, _e1047, (_e1047 > _e1039));
                                                                let _e1051 = select(_e1029, _e1028, (_e1028 > _e1029));
                                                                let _e1053 = select(_e1033, _e1032, (_e1032 > _e1033));
                                                                let _e1055 = select(_e1053, _e1051, (_e1051 < _e1053));
                                                                let _e1057 = select(_e1041, _e1055, (_e1055 < _e1041));
                                                                let _e1058 = -(_e1039);
                                                                let _e1064 = select(_e554, _e1049, (_e1049 > _e554));
                                                                if (_e1064 > (_e1057 + (select(_e1058, _e1041, (_e1041 > _e1058)) * 0.0000019073523f))) {
                                                                    phi_1978_ = type_27();
                                                                    phi_1979_ = true;
                                                                } else {
                                                                    let _e1066 = (_e1064 > _e798.member.member_1);
                                                                    if _e1066 {
                                                                        phi_1977_ = type_27();
                                                                    } else {
                                                                        let _e1067 = vec3<f32>(_e903[0][0], _e903[0][1], _e903[0][2]);
                                                                        let _e1068 = vec3<f32>(_e903[1][0], _e903[1][1], _e903[1][2]);
                                                                        let _e1069 = vec3<f32>(_e903[2][0], _e903[2][1], _e903[2][2]);
                                                                        let _e1070 = (_e903[1][0] - _e903[0][0]);
                                                                        let _e1071 = (_e903[1][1] - _e903[0][1]);
                                                                        let _e1072 = (_e903[1][2] - _e903[0][2]);
                                                                        let _e1073 = vec3<f32>(_e1070, _e1071, _e1072);
                                                                        let _e1074 = (_e903[2][0] - _e903[1][0]);
                                                                        let _e1075 = (_e903[2][1] - _e903[1][1]);
                                                                        let _e1076 = (_e903[2][2] - _e903[1][2]);
                                                                        let _e1077 = vec3<f32>(_e1074, _e1075, _e1076);
                                                                        let _e1078 = (_e903[0][0] - _e903[2][0]);
                                                                        let _e1079 = (_e903[0][1] - _e903[2][1]);
                                                                        let _e1080 = (_e903[0][2] - _e903[2][2]);
                                                                        let _e1081 = vec3<f32>(_e1078, _e1079, _e1080);
                                                                        let _e1084 = bitcast<f32>((bitcast<u32>(_e1070) & 2147483647u));
                                                                        let _e1087 = bitcast<f32>((bitcast<u32>(_e1071) & 2147483647u));
                                                                        let _e1089 = select(_e1087, _e1084, (_e1084 > _e1087));
                                                                        let _e1092 = bitcast<f32>((bitcast<u32>(_e1072) & 2147483647u));
                                                                        let _e1094 = select(_e1092, _e1089, (_e1089 > _e1092));
                                                                        let _e1097 = bitcast<f32>((bitcast<u32>(_e1074) & 2147483647u));
                                                                        let _e1100 = bitcast<f32>((bitcast<u32>(_e1075) & 2147483647u));
                                                                        let _e1102 = select(_e1100, _e1097, (_e1097 > _e1100));
                                                                        let _e1105 = bitcast<f32>((bitcast<u32>(_e1076) & 2147483647u));
                                                                        let _e1107 = select(_e1105, _e1102, (_e1102 > _e1105));
                                                                        let _e1110 = bitcast<f32>((bitcast<u32>(_e1078) & 2147483647u));
                                                                        let _e1113 = bitcast<f32>((bitcast<u32>(_e1079) & 2147483647u));
                                                                        let _e1115 = select(_e1113, _e1110, (_e1110 > _e1113));
                                                                        let _e1118 = bitcast<f32>((bitcast<u32>(_e1080) & 2147483647u));
                                                                        let _e1120 = select(_e1118, _e1115, (_e1115 > _e1118));
                                                                        let _e1122 = select(_e1107, _e1094, (_e1094 > _e1107));
                                                                        let _e1124 = select(_e1120, _e1122, (_e1122 > _e1120));
                                                                        if (_e1094 == _e1124) {
                                                                            phi_1704_ = _e931;
                                                                            phi_1705_ = _e928;
                                                                            phi_1706_ = _e918;
                                                                            phi_1707_ = _e915;
                                                                            phi_1708_ = _e1067;
                                                                            phi_1709_ = _e1081;
                                                                            phi_1710_ = _e1077;
                                                                            phi_1711_ = _e1073;
                                                                        } else {
                                                                            let _e1126 = (_e1107 == _e1124);
                                                                            let _e1131 = vec3(_e1126);
                                                                            phi_1704_ = select(_e918, _e944, _e1126);
                                                                            phi_1705_ = select(_e915, _e941, _e1126);
                                                                            phi_1706_ = select(_e944, _e931, _e1126);
                                                                            phi_1707_ = select(_e941, _e928, _e1126);
                                                                            phi_1708_ = select(_e1069, _e1068, _e1131);
                                                                            phi_1709_ = select(_e1077, _e1073, _e1131);
                                                                            phi_1710_ = select(_e1073, _e1081, _e1131);
                                                                            phi_1711_ = select(_e1081, _e1077, _e1131);
                                                                        }
                                                                        let _e1137 = phi_1704_;
                                                                        let _e1139 = phi_1705_;
                                                                        let _e1141 = phi_1706_;
                                                                        let _e1143 = phi_1707_;
                                                                        let _e1145 = phi_1708_;
                                                                        let _e1147 = phi_1709_;
                                                                        let _e1149 = phi_1710_;
                                                                        let _e1151 = phi_1711_;
                                                                        let _e1158 = ((_e1149.y * _e1147.z) - (_e1147.y * _e1149.z));
                                                                        let _e1163 = ((_e1149.z * _e1147.x) - (_e1147.z * _e1149.x));
                                                                        let _e1166 = ((_e1149.x * _e1147.y) - (_e1147.x * _e1149.y));
                                                                        if (_e966 >= _e970) {
                                                                            phi_1748_ = select(true, false, (_e966 >= _e974));
                                                                        } else {
                                                                            phi_1748_ = true;
                                                                        }
                                                                        let _e1171 = phi_1748_;
                                                                        if _e1171 {
                                                                            phi_1757_ = select(_e1069, _e1068, vec3((_e970 >= _e974)));
                                                                        } else {
                                                                            phi_1757_ = _e1067;
                                                                        }
                                                                        let _e1176 = phi_1757_;
                                                                        let _e1187 = (((_e1158 * (_e1176.x - _e263)) + (_e1163 * (_e1176.y - _e332))) + (_e1166 * (_e1176.z - _e400)));
                                                                        let _e1192 = (((_e1158 * _e303) + (_e1163 * _e371)) + (_e1166 * _e439));
                                                                        let _e1193 = (_e1139 - _e1143);
                                                                        let _e1194 = (_e1137 - _e1141);
                                                                        let _e1202 = (-(((_e1143 * _e1193) + (_e1141 * _e1194))) / ((_e1193 * _e1193) + (_e1194 * _e1194)));
                                                                        let _e1204 = select(1f, _e1202, (_e1202 < 1f));
                                                                        let _e1206 = select(0f, _e1204, (_e1204 > 0f));
                                                                        let _e1219 = ((_e1145.x + (_e1151.x * _e1206)) - _e263);
                                                                        let _e1220 = ((_e1145.y + (_e1151.y * _e1206)) - _e332);
                                                                        let _e1221 = ((_e1145.z + (_e1151.z * _e1206)) - _e400);
                                                                        let _e1222 = (_e1221 / _e439);
                                                                        let _e1234 = bitcast<f32>((bitcast<u32>(_e1219) & 2147483647u));
                                                                        let _e1237 = bitcast<f32>((bitcast<u32>(_e1220) & 2147483647u));
                                                                        let _e1239 = select(_e1237, _e1234, (_e1234 > _e1237));
                                                                        let _e1242 = bitcast<f32>((bitcast<u32>(_e1221) & 2147483647u));
                                                                        let _e1244 = select(_e1242, _e1239, (_e1239 > _e1242));
                                                                        let _e1250 = bitcast<f32>((bitcast<u32>(_e1158) & 2147483647u));
                                                                        let _e1253 = bitcast<f32>((bitcast<u32>(_e1163) & 2147483647u));
                                                                        let _e1255 = select(_e1253, _e1250, (_e1250 > _e1253));
                                                                        let _e1258 = bitcast<f32>((bitcast<u32>(_e1166) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1158 * _e1219) + (_e1163 * _e1220)) + (_e1166 * _e1221)) - _e1187)) & 2147483647u)) <= ((0.0000009536743f * select(_e1124, _e1244, (_e1244 > _e1124))) * select(_e1258, _e1255, (_e1255 > _e1258)))) {
                                                                            let _e1268 = bitcast<f32>((bitcast<u32>(_e1149.x) & 2147483647u));
                                                                            let _e1271 = bitcast<f32>((bitcast<u32>(_e1149.y) & 2147483647u));
                                                                            let _e1273 = select(_e1271, _e1268, (_e1268 > _e1271));
                                                                            let _e1276 = bitcast<f32>((bitcast<u32>(_e1149.z) & 2147483647u));
                                                                            let _e1282 = bitcast<f32>((bitcast<u32>(_e1147.x) & 2147483647u));
                                                                            let _e1285 = bitcast<f32>((bitcast<u32>(_e1147.y) & 2147483647u));
                                                                            let _e1287 = select(_e1285, _e1282, (_e1282 > _e1285));
                                                                            let _e1290 = bitcast<f32>((bitcast<u32>(_e1147.z) & 2147483647u));
                                                                            let _e1294 = (bitcast<f32>((bitcast<u32>(_e1192) & 2147483647u)) > ((0.0000038146973f * select(_e1276, _e1273, (_e1273 > _e1276))) * select(_e1290, _e1287, (_e1287 > _e1290))));
                                                                            if _e1294 {
                                                                                phi_1922_ = (_e1187 / _e1192);
                                                                            } else {
                                                                                phi_1922_ = f32();
                                                                            }
                                                                            let _e1297 = phi_1922_;
                                                                            phi_1924_ = _e1297;
                                                                            phi_1925_ = select(true, false, _e1294);
                                                                        } else {
                                                                            phi_1924_ = f32();
                                                                            phi_1925_ = true;
                                                                        }
                                                                        let _e1300 = phi_1924_;
                                                                        let _e1302 = phi_1925_;
                                                                        if _e1302 {
                                                                            let _e1310 = (((_e1158 * (_e1219 - (_e303 * _e1222))) + (_e1163 * (_e1220 - (_e371 * _e1222)))) / _e1192);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1310) & 2147483647u)) <= _e1124) {
                                                                                phi_1945_ = (_e1222 + _e1310);
                                                                            } else {
                                                                                phi_1945_ = _e1222;
                                                                            }
                                                                            let _e1317 = phi_1945_;
                                                                            phi_1946_ = _e1317;
                                                                        } else {
                                                                            phi_1946_ = _e1300;
                                                                        }
                                                                        let _e1319 = phi_1946_;
                                                                        let _e1321 = select(_e1057, _e1319, (_e1319 < _e1057));
                                                                        let _e1323 = select(_e1049, _e1321, (_e1321 > _e1049));
                                                                        if (_e1323 >= _e554) {
                                                                            let _e1325 = (_e1323 <= _e798.member.member_1);
                                                                            if _e1325 {
                                                                                let _e1326 = (1f / _e976);
                                                                                phi_1969_ = type_27(_e1323, (_e970 * _e1326), (_e974 * _e1326), _e833);
                                                                            } else {
                                                                                phi_1969_ = type_27();
                                                                            }
                                                                            let _e1331 = phi_1969_;
                                                                            phi_1971_ = _e1331;
                                                                            phi_1972_ = select(true, false, _e1325);
                                                                        } else {
                                                                            phi_1971_ = type_27();
                                                                            phi_1972_ = true;
                                                                        }
                                                                        let _e1334 = phi_1971_;
                                                                        let _e1336 = phi_1972_;
                                                                        if _e1336 {
                                                                            phi_1976_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1976_ = _e1334;
                                                                        }
                                                                        let _e1338 = phi_1976_;
                                                                        phi_1977_ = _e1338;
                                                                    }
                                                                    let _e1340 = phi_1977_;
                                                                    phi_1978_ = _e1340;
                                                                    phi_1979_ = _e1066;
                                                                }
                                                                let _e1342 = phi_1978_;
                                                                let _e1344 = phi_1979_;
                                                                phi_1983_ = _e1342;
                                                                phi_1984_ = _e1344;
                                                            }
                                                            let _e1346 = phi_1983_;
                                                            let _e1348 = phi_1984_;
                                                            phi_1985_ = _e1346;
                                                            phi_1986_ = _e1001;
                                                            phi_1987_ = _e1348;
                                                        }
                                                        let _e1350 = phi_1985_;
                                                        let _e1352 = phi_1986_;
                                                        let _e1354 = phi_1987_;
                                                        phi_1988_ = _e1350;
                                                        phi_1989_ = _e1352;
                                                        phi_1990_ = _e1354;
                                                    }
                                                    let _e1356 = phi_1988_;
                                                    let _e1358 = phi_1989_;
                                                    let _e1360 = phi_1990_;
                                                    phi_1998_ = _e1356;
                                                    phi_1999_ = select(_e1360, true, _e1358);
                                                } else {
                                                    phi_1998_ = type_27();
                                                    phi_1999_ = true;
                                                }
                                                let _e1363 = phi_1998_;
                                                let _e1365 = phi_1999_;
                                                if _e1365 {
                                                    phi_2003_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2003_ = _e1363;
                                                }
                                                let _e1367 = phi_2003_;
                                                if (_e1367.member_3 != 4294967295u) {
                                                    if (_e833 != 4294967295u) {
                                                        if (_e1367.member < _e798.member.member.member) {
                                                            phi_2029_ = true;
                                                        } else {
                                                            if (_e1367.member == _e798.member.member.member) {
                                                                phi_2028_ = (_e1367.member_3 < _e798.member.member.member_3);
                                                            } else {
                                                                phi_2028_ = false;
                                                            }
                                                            let _e1382 = phi_2028_;
                                                            phi_2029_ = _e1382;
                                                        }
                                                        let _e1384 = phi_2029_;
                                                        if _e1384 {
                                                            phi_2036_ = type_48(type_40(_e1367, _e1367.member), _e825.member_1, _e825.member_2);
                                                        } else {
                                                            phi_2036_ = _e825;
                                                        }
                                                        let _e1391 = phi_2036_;
                                                        phi_2037_ = _e1391;
                                                    } else {
                                                        phi_2037_ = _e825;
                                                    }
                                                    let _e1393 = phi_2037_;
                                                    phi_2038_ = _e1393;
                                                } else {
                                                    phi_2038_ = _e825;
                                                }
                                                let _e1395 = phi_2038_;
                                                phi_963_ = _e1395;
                                            } else {
                                                phi_963_ = type_48();
                                            }
                                            let _e1397 = phi_963_;
                                            continue;
                                            continuing {
                                                phi_962_ = _e1397;
                                                phi_965_ = _e813;
                                                phi_2571_ = _e563;
                                                break if !(_e819);
                                            }
                                        }
                                        let _e1400 = phi_2571_;
                                        phi_2731_ = _e1400;
                                        if _e1400 {
                                            break;
                                        }
                                        phi_2735_ = _e1400;
                                        let _e1571 = local_4;
                                        phi_2528_ = _e1571;
                                        phi_2529_ = false;
                                        phi_2530_ = _e591;
                                        phi_2531_ = _e593;
                                    } else {
                                        if (_e593 >= _e71) {
                                            phi_2108_ = type_44(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e593 < _e71) {
                                            } else {
                                                phi_2731_ = true;
                                                break;
                                            }
                                            let _e603 = (_e199 % 3u);
                                            if (_e603 < 3u) {
                                            } else {
                                                phi_2731_ = true;
                                                break;
                                            }
                                            let _e609 = global_2.member[_e593].member[_e603];
                                            let _e615 = (_e198 % 3u);
                                            if (_e615 < 3u) {
                                            } else {
                                                phi_2731_ = true;
                                                break;
                                            }
                                            let _e621 = global_2.member[_e593].member[_e615];
                                            let _e627 = (_e200 % 3u);
                                            if (_e627 < 3u) {
                                            } else {
                                                phi_2731_ = true;
                                                break;
                                            }
                                            let _e633 = global_2.member[_e593].member[_e627];
                                            let _e643 = global_2.member[_e593].member_1;
                                            let _e647 = global_2.member[_e593].member_2;
                                            phi_2108_ = type_44(array<vec4<f32>, 3>(vec4<f32>(_e609[0], _e609[1], _e609[2], _e609[3]), vec4<f32>(_e621[0], _e621[1], _e621[2], _e621[3]), vec4<f32>(_e633[0], _e633[1], _e633[2], _e633[3])), _e643, _e647);
                                        }
                                        let _e650 = phi_2108_;
                                        let _e669 = ((_e650.member[0].x - _e301) * _e306);
                                        let _e670 = ((_e650.member[0].y - _e301) * _e306);
                                        let _e671 = ((_e650.member[0].z - _e302) * _e306);
                                        let _e672 = ((_e650.member[0].w - _e302) * _e306);
                                        let _e682 = ((_e650.member[1].x - _e369) * _e374);
                                        let _e683 = ((_e650.member[1].y - _e369) * _e374);
                                        let _e684 = ((_e650.member[1].z - _e370) * _e374);
                                        let _e685 = ((_e650.member[1].w - _e370) * _e374);
                                        let _e695 = ((_e650.member[2].x - _e437) * _e442);
                                        let _e696 = ((_e650.member[2].y - _e437) * _e442);
                                        let _e697 = ((_e650.member[2].z - _e438) * _e442);
                                        let _e698 = ((_e650.member[2].w - _e438) * _e442);
                                        let _e700 = select(_e697, _e695, (_e695 < _e697));
                                        let _e702 = select(_e698, _e696, (_e696 < _e698));
                                        let _e704 = select(_e697, _e695, (_e695 > _e697));
                                        let _e706 = select(_e698, _e696, (_e696 > _e698));
                                        let _e708 = select(_e671, _e669, (_e669 < _e671));
                                        let _e710 = select(_e672, _e670, (_e670 < _e672));
                                        let _e712 = select(_e684, _e682, (_e682 < _e684));
                                        let _e714 = select(_e685, _e683, (_e683 < _e685));
                                        let _e716 = select(_e712, _e708, (_e708 > _e712));
                                        let _e718 = select(_e714, _e710, (_e710 > _e714));
                                        let _e720 = select(_e700, _e716, (_e716 > _e700));
                                        let _e722 = select(_e702, _e718, (_e718 > _e702));
                                        let _e724 = select(_e671, _e669, (_e669 > _e671));
                                        let _e726 = select(_e672, _e670, (_e670 > _e672));
                                        let _e728 = select(_e684, _e682, (_e682 > _e684));
                                        let _e730 = select(_e685, _e683, (_e683 > _e685));
                                        let _e732 = select(_e728, _e724, (_e724 < _e728));
                                        let _e734 = select(_e730, _e726, (_e726 < _e730));
                                        let _e739 = -(_e700);
                                        let _e740 = -(_e702);
                                        let _e747 = (select(_e704, _e732, (_e732 < _e704)) + (select(_e739, _e704, (_e704 > _e739)) * 0.0000019073523f));
                                        let _e748 = (select(_e706, _e734, (_e734 < _e706)) + (select(_e740, _e706, (_e706 > _e740)) * 0.0000019073523f));
                                        let _e750 = select(_e554, _e720, (_e720 > _e554));
                                        let _e752 = select(_e554, _e722, (_e722 > _e554));
                                        let _e757 = (_e750 <= select(_e565.member.member_1, _e747, (_e747 < _e565.member.member_1)));
                                        let _e758 = (_e752 <= select(_e565.member.member_1, _e748, (_e748 < _e565.member.member_1)));
                                        let _e759 = (_e750 <= _e752);
                                        if _e757 {
                                            if _e758 {
                                                if _e759 {
                                                    phi_2473_ = _e650.member_2;
                                                } else {
                                                    phi_2473_ = _e650.member_1;
                                                }
                                                let _e763 = phi_2473_;
                                                let _e766 = (_e591 % 128u);
                                                let _e767 = (_e766 < 128u);
                                                if _e767 {
                                                } else {
                                                    phi_2731_ = true;
                                                    break;
                                                }
                                                local_1[_e766] = _e763;
                                                if _e767 {
                                                } else {
                                                    phi_2731_ = true;
                                                    break;
                                                }
                                                local[_e766] = select(_e752, _e750, !(_e759));
                                                if _e759 {
                                                    phi_2501_ = _e650.member_1;
                                                } else {
                                                    phi_2501_ = _e650.member_2;
                                                }
                                                let _e774 = phi_2501_;
                                                phi_2502_ = (_e591 + 1u);
                                                phi_2503_ = _e774;
                                            } else {
                                                phi_2502_ = u32();
                                                phi_2503_ = u32();
                                            }
                                            let _e776 = phi_2502_;
                                            let _e778 = phi_2503_;
                                            phi_2505_ = _e776;
                                            phi_2506_ = _e778;
                                            phi_2507_ = select(true, false, _e758);
                                        } else {
                                            phi_2505_ = u32();
                                            phi_2506_ = u32();
                                            phi_2507_ = true;
                                        }
                                        let _e781 = phi_2505_;
                                        let _e783 = phi_2506_;
                                        let _e785 = phi_2507_;
                                        if _e785 {
                                            if _e757 {
                                                phi_2516_ = _e650.member_1;
                                            } else {
                                                phi_2516_ = _e650.member_2;
                                            }
                                            let _e789 = phi_2516_;
                                            phi_2521_ = select(_e758, true, _e757);
                                            phi_2523_ = _e789;
                                        } else {
                                            phi_2521_ = _e589;
                                            phi_2523_ = _e783;
                                        }
                                        let _e792 = phi_2521_;
                                        let _e794 = phi_2523_;
                                        phi_2735_ = _e563;
                                        phi_2528_ = type_48(_e565.member, (_e565.member_1 + 1u), _e565.member_2);
                                        phi_2529_ = _e792;
                                        phi_2530_ = select(_e781, _e591, _e785);
                                        phi_2531_ = _e794;
                                    }
                                    let _e1402 = phi_2735_;
                                    let _e1404 = phi_2528_;
                                    let _e1406 = phi_2529_;
                                    let _e1408 = phi_2530_;
                                    let _e1410 = phi_2531_;
                                    phi_2734_ = _e1402;
                                    phi_2532_ = _e1404;
                                    phi_2533_ = _e1406;
                                    phi_2534_ = (_e569 - 1u);
                                    phi_2535_ = _e1408;
                                    phi_2536_ = _e1410;
                                } else {
                                    phi_2734_ = _e563;
                                    phi_2532_ = _e565;
                                    phi_2533_ = _e589;
                                    phi_2534_ = _e569;
                                    phi_2535_ = _e591;
                                    phi_2536_ = _e593;
                                }
                                let _e1412 = phi_2734_;
                                let _e1414 = phi_2532_;
                                let _e1416 = phi_2533_;
                                let _e1418 = phi_2534_;
                                let _e1420 = phi_2535_;
                                let _e1422 = phi_2536_;
                                phi_2733_ = _e1412;
                                phi_2537_ = _e1414;
                                phi_2538_ = _e1416;
                                phi_2539_ = _e1418;
                                phi_2540_ = _e1420;
                                phi_2541_ = _e1422;
                            } else {
                                phi_2733_ = _e563;
                                phi_2537_ = type_48();
                                phi_2538_ = bool();
                                phi_2539_ = u32();
                                phi_2540_ = u32();
                                phi_2541_ = u32();
                            }
                            let _e1424 = phi_2733_;
                            let _e1426 = phi_2537_;
                            let _e1428 = phi_2538_;
                            let _e1430 = phi_2539_;
                            let _e1432 = phi_2540_;
                            let _e1434 = phi_2541_;
                            phi_2732_ = _e1424;
                            phi_894_ = _e1426;
                            phi_897_ = _e1428;
                            phi_899_ = _e1430;
                            phi_901_ = _e1432;
                            phi_903_ = _e1434;
                            phi_2542_ = _e577;
                        } else {
                            phi_2732_ = _e563;
                            phi_894_ = type_48();
                            phi_897_ = bool();
                            phi_899_ = u32();
                            phi_901_ = u32();
                            phi_903_ = u32();
                            phi_2542_ = false;
                        }
                        let _e1436 = phi_2732_;
                        let _e1438 = phi_894_;
                        let _e1440 = phi_897_;
                        let _e1442 = phi_899_;
                        let _e1444 = phi_901_;
                        let _e1446 = phi_903_;
                        let _e1448 = phi_2542_;
                        continue;
                        continuing {
                            phi_2577_ = _e1436;
                            phi_893_ = _e1438;
                            phi_896_ = _e1440;
                            phi_898_ = _e1442;
                            phi_900_ = _e1444;
                            phi_902_ = _e1446;
                            phi_2731_ = _e1436;
                            break if !(_e1448);
                        }
                    }
                    let _e1451 = phi_2731_;
                    if _e1451 {
                        break;
                    }
                    let _e1453 = local_2;
                    let _e1456 = local_3;
                    if _e87 {
                    } else {
                        break;
                    }
                    global_5.member[_e81][0u] = _e1453.member_1;
                    global_5.member[_e81][1u] = _e1456.member_2;
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
