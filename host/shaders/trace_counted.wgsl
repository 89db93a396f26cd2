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

struct type_39 {
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
    member: type_39,
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
    var phi_277_: i32;
    var phi_278_: i32;
    var phi_288_: bool;
    var phi_298_: u32;
    var phi_299_: u32;
    var phi_301_: bool;
    var phi_306_: u32;
    var phi_318_: i32;
    var phi_338_: i32;
    var phi_356_: f32;
    var phi_362_: f32;
    var phi_402_: f32;
    var phi_408_: f32;
    var phi_460_: f32;
    var phi_471_: f32;
    var phi_480_: f32;
    var phi_486_: f32;
    var phi_526_: f32;
    var phi_532_: f32;
    var phi_584_: f32;
    var phi_595_: f32;
    var phi_604_: f32;
    var phi_610_: f32;
    var phi_650_: f32;
    var phi_656_: f32;
    var phi_708_: f32;
    var phi_719_: f32;
    var phi_774_: i32;
    var phi_796_: u32;
    var phi_797_: u32;
    var phi_834_: i32;
    var phi_856_: u32;
    var phi_857_: u32;
    var phi_865_: f32;
    var phi_866_: f32;
    var phi_2468_: bool;
    var phi_878_: type_48;
    var phi_881_: u32;
    var phi_883_: u32;
    var phi_885_: bool;
    var phi_887_: u32;
    var phi_898_: bool;
    var phi_930_: u32;
    var phi_931_: bool;
    var phi_932_: u32;
    var phi_2024_: type_44;
    var phi_2368_: u32;
    var phi_2396_: u32;
    var phi_2397_: u32;
    var phi_2398_: u32;
    var phi_2400_: u32;
    var phi_2401_: u32;
    var phi_2402_: bool;
    var phi_2411_: u32;
    var phi_2416_: u32;
    var phi_2417_: bool;
    var phi_947_: type_48;
    var phi_950_: type_4;
    var phi_951_: type_4;
    var phi_973_: type_4;
    var phi_997_: u32;
    var phi_1086_: array<array<f32, 3>, 3>;
    var phi_1203_: bool;
    var phi_1232_: bool;
    var phi_1633_: f32;
    var phi_1634_: f32;
    var phi_1635_: f32;
    var phi_1636_: f32;
    var phi_1637_: vec3<f32>;
    var phi_1638_: vec3<f32>;
    var phi_1639_: vec3<f32>;
    var phi_1640_: vec3<f32>;
    var phi_1671_: bool;
    var phi_1680_: vec3<f32>;
    var phi_1845_: f32;
    var phi_1847_: f32;
    var phi_1848_: bool;
    var phi_1868_: f32;
    var phi_1869_: f32;
    var phi_1892_: type_27;
    var phi_1894_: type_27;
    var phi_1895_: bool;
    var phi_1899_: type_27;
    var phi_1900_: type_27;
    var phi_1901_: type_27;
    var phi_1902_: bool;
    var phi_1906_: type_27;
    var phi_1907_: bool;
    var phi_1908_: type_27;
    var phi_1909_: bool;
    var phi_1910_: bool;
    var phi_1911_: type_27;
    var phi_1912_: bool;
    var phi_1913_: bool;
    var phi_1921_: type_27;
    var phi_1922_: bool;
    var phi_1926_: type_27;
    var phi_1951_: bool;
    var phi_1952_: bool;
    var phi_1959_: type_48;
    var phi_1960_: type_48;
    var phi_1961_: type_48;
    var phi_948_: type_48;
    var phi_2462_: bool;
    var phi_2626_: bool;
    var phi_2419_: type_48;
    var phi_2420_: u32;
    var phi_2421_: bool;
    var phi_2422_: u32;
    var phi_2625_: bool;
    var phi_2423_: type_48;
    var phi_2424_: u32;
    var phi_2425_: u32;
    var phi_2426_: bool;
    var phi_2427_: u32;
    var phi_2624_: bool;
    var phi_2428_: type_48;
    var phi_2429_: u32;
    var phi_2430_: u32;
    var phi_2431_: bool;
    var phi_2432_: u32;
    var phi_2623_: bool;
    var phi_879_: type_48;
    var phi_882_: u32;
    var phi_884_: u32;
    var phi_886_: bool;
    var phi_888_: u32;
    var phi_2433_: bool;
    var phi_2622_: bool;
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
                            phi_277_ = (bitcast<i32>((_e164 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_277_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e164)), 32u, (_e164 == 0u))));
                        }
                        let _e178 = phi_277_;
                        phi_278_ = _e178;
                    } else {
                        phi_278_ = 0i;
                    }
                    let _e180 = phi_278_;
                    let _e181 = (_e97 == _e136);
                    if _e181 {
                        phi_288_ = true;
                    } else {
                        phi_288_ = (_e104 == _e136);
                    }
                    let _e184 = phi_288_;
                    let _e185 = select(1u, 0u, _e181);
                    if _e184 {
                        let _e186 = (_e185 + 1u);
                        phi_298_ = _e186;
                        phi_299_ = _e186;
                        phi_301_ = select(true, false, (_e186 == 2u));
                    } else {
                        phi_298_ = u32();
                        phi_299_ = 0u;
                        phi_301_ = true;
                    }
                    let _e190 = phi_298_;
                    let _e192 = phi_299_;
                    let _e194 = phi_301_;
                    if _e194 {
                        phi_306_ = (_e192 + 1u);
                    } else {
                        phi_306_ = 0u;
                    }
                    let _e198 = phi_306_;
                    let _e199 = select(_e190, _e192, _e194);
                    let _e200 = select(_e185, select(2u, _e185, _e184), _e194);
                    if (_e85 < -126i) {
                        phi_318_ = -126i;
                    } else {
                        phi_318_ = select(_e85, 127i, (_e85 > 127i));
                    }
                    let _e205 = phi_318_;
                    let _e210 = bitcast<f32>((bitcast<u32>((_e205 + 127i)) << bitcast<u32>(23i)));
                    let _e216 = bitcast<f32>((bitcast<u32>(((_e85 - _e205) + 127i)) << bitcast<u32>(23i)));
                    let _e217 = -(_e180);
                    if (_e217 < -126i) {
                        phi_338_ = -126i;
                    } else {
                        phi_338_ = select(_e217, 127i, (_e217 > 127i));
                    }
                    let _e222 = phi_338_;
                    let _e227 = bitcast<f32>((bitcast<u32>((_e222 + 127i)) << bitcast<u32>(23i)));
                    let _e233 = bitcast<f32>((bitcast<u32>(((_e217 - _e222) + 127i)) << bitcast<u32>(23i)));
                    let _e237 = global_4.member[_e81].member;
                    let _e238 = (_e199 == 0u);
                    if _e238 {
                        phi_356_ = _e237[0];
                    } else {
                        phi_356_ = _e237[1];
                    }
                    let _e242 = phi_356_;
                    let _e243 = (_e199 == 2u);
                    if _e243 {
                        phi_362_ = _e237[2];
                    } else {
                        phi_362_ = _e242;
                    }
                    let _e246 = phi_362_;
                    let _e247 = bitcast<u32>(_e246);
                    let _e249 = ((_e247 & 2139095040u) != 0u);
                    let _e263 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e247 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e247 & 2147483648u))), _e246, _e249) * _e210) * select(0.00000011920929f, 1f, _e249)) * _e216);
                    let _e264 = global_4.member[_e81].member_2;
                    if _e238 {
                        phi_402_ = _e264[0];
                    } else {
                        phi_402_ = _e264[1];
                    }
                    let _e268 = phi_402_;
                    if _e243 {
                        phi_408_ = _e264[2];
                    } else {
                        phi_408_ = _e268;
                    }
                    let _e271 = phi_408_;
                    let _e272 = bitcast<u32>(_e271);
                    let _e274 = ((_e272 & 2139095040u) != 0u);
                    let _e288 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e272 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e272 & 2147483648u))), _e271, _e274) * _e227) * select(0.00000011920929f, 1f, _e274)) * _e233);
                    let _e292 = (bitcast<f32>((bitcast<u32>(_e288) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e292 {
                        let _e296 = (bitcast<f32>((bitcast<u32>(_e263) & 2147483647u)) * 0.00000011920929f);
                        phi_460_ = select(0.00000000000011368684f, _e296, (_e296 > 0.00000000000011368684f));
                    } else {
                        phi_460_ = 0f;
                    }
                    let _e300 = phi_460_;
                    let _e301 = (_e263 + _e300);
                    let _e302 = (_e263 - _e300);
                    let _e303 = select(_e288, 0f, _e292);
                    if _e292 {
                        phi_471_ = 38685626000000000000000000f;
                    } else {
                        phi_471_ = (1f / _e288);
                    }
                    let _e306 = phi_471_;
                    let _e307 = (_e198 == 0u);
                    if _e307 {
                        phi_480_ = _e237[0];
                    } else {
                        phi_480_ = _e237[1];
                    }
                    let _e311 = phi_480_;
                    let _e312 = (_e198 == 2u);
                    if _e312 {
                        phi_486_ = _e237[2];
                    } else {
                        phi_486_ = _e311;
                    }
                    let _e315 = phi_486_;
                    let _e316 = bitcast<u32>(_e315);
                    let _e318 = ((_e316 & 2139095040u) != 0u);
                    let _e332 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e316 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e316 & 2147483648u))), _e315, _e318) * _e210) * select(0.00000011920929f, 1f, _e318)) * _e216);
                    if _e307 {
                        phi_526_ = _e264[0];
                    } else {
                        phi_526_ = _e264[1];
                    }
                    let _e336 = phi_526_;
                    if _e312 {
                        phi_532_ = _e264[2];
                    } else {
                        phi_532_ = _e336;
                    }
                    let _e339 = phi_532_;
                    let _e340 = bitcast<u32>(_e339);
                    let _e342 = ((_e340 & 2139095040u) != 0u);
                    let _e356 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e340 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e340 & 2147483648u))), _e339, _e342) * _e227) * select(0.00000011920929f, 1f, _e342)) * _e233);
                    let _e360 = (bitcast<f32>((bitcast<u32>(_e356) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e360 {
                        let _e364 = (bitcast<f32>((bitcast<u32>(_e332) & 2147483647u)) * 0.00000011920929f);
                        phi_584_ = select(0.00000000000011368684f, _e364, (_e364 > 0.00000000000011368684f));
                    } else {
                        phi_584_ = 0f;
                    }
                    let _e368 = phi_584_;
                    let _e369 = (_e332 + _e368);
                    let _e370 = (_e332 - _e368);
                    let _e371 = select(_e356, 0f, _e360);
                    if _e360 {
                        phi_595_ = 38685626000000000000000000f;
                    } else {
                        phi_595_ = (1f / _e356);
                    }
                    let _e374 = phi_595_;
                    let _e375 = (_e200 == 0u);
                    if _e375 {
                        phi_604_ = _e237[0];
                    } else {
                        phi_604_ = _e237[1];
                    }
                    let _e379 = phi_604_;
                    let _e380 = (_e200 == 2u);
                    if _e380 {
                        phi_610_ = _e237[2];
                    } else {
                        phi_610_ = _e379;
                    }
                    let _e383 = phi_610_;
                    let _e384 = bitcast<u32>(_e383);
                    let _e386 = ((_e384 & 2139095040u) != 0u);
                    let _e400 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e384 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e384 & 2147483648u))), _e383, _e386) * _e210) * select(0.00000011920929f, 1f, _e386)) * _e216);
                    if _e375 {
                        phi_650_ = _e264[0];
                    } else {
                        phi_650_ = _e264[1];
                    }
                    let _e404 = phi_650_;
                    if _e380 {
                        phi_656_ = _e264[2];
                    } else {
                        phi_656_ = _e404;
                    }
                    let _e407 = phi_656_;
                    let _e408 = bitcast<u32>(_e407);
                    let _e410 = ((_e408 & 2139095040u) != 0u);
                    let _e424 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e408 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e408 & 2147483648u))), _e407, _e410) * _e227) * select(0.00000011920929f, 1f, _e410)) * _e233);
                    let _e428 = (bitcast<f32>((bitcast<u32>(_e424) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e428 {
                        let _e432 = (bitcast<f32>((bitcast<u32>(_e400) & 2147483647u)) * 0.00000011920929f);
                        phi_708_ = select(0.00000000000011368684f, _e432, (_e432 > 0.00000000000011368684f));
                    } else {
                        phi_708_ = 0f;
                    }
                    let _e436 = phi_708_;
                    let _e437 = (_e400 + _e436);
                    let _e438 = (_e400 - _e436);
                    let _e439 = select(_e424, 0f, _e428);
                    if _e428 {
                        phi_719_ = 38685626000000000000000000f;
                    } else {
                        phi_719_ = (1f / _e424);
                    }
                    let _e442 = phi_719_;
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
                            phi_774_ = 255i;
                        } else {
                            phi_774_ = (((_e469 + select(0i, 1i, (_e469 == 0i))) - _e476) + _e456);
                        }
                        let _e484 = phi_774_;
                        let _e494 = (_e484 <= 0i);
                        if _e494 {
                            phi_797_ = u32();
                        } else {
                            if _e473 {
                                phi_796_ = u32();
                            } else {
                                phi_796_ = select(((bitcast<u32>(_e484) << bitcast<u32>(23i)) | ((_e466 << bitcast<u32>(((_e476 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e484 >= 255i));
                            }
                            let _e498 = phi_796_;
                            phi_797_ = _e498;
                        }
                        let _e500 = phi_797_;
                        let _e512 = ((_e157 & 8388607u) | (select(0u, 1u, ((_e157 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e515 = bitcast<i32>((_e157 >> bitcast<u32>(23i)));
                        let _e519 = (_e512 == 0u);
                        let _e522 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e512)), 32u, _e519)) - 8i);
                        if (_e515 == 255i) {
                            phi_834_ = 255i;
                        } else {
                            phi_834_ = (((_e515 + select(0i, 1i, (_e515 == 0i))) - _e522) + _e456);
                        }
                        let _e530 = phi_834_;
                        let _e540 = (_e530 <= 0i);
                        if _e540 {
                            phi_857_ = u32();
                        } else {
                            if _e519 {
                                phi_856_ = u32();
                            } else {
                                phi_856_ = select(((bitcast<u32>(_e530) << bitcast<u32>(23i)) | ((_e512 << bitcast<u32>(((_e522 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e530 >= 255i));
                            }
                            let _e544 = phi_856_;
                            phi_857_ = _e544;
                        }
                        let _e546 = phi_857_;
                        phi_865_ = bitcast<f32>(((_e156 & 2147483648u) | select(_e546, 0u, select(_e519, true, _e540))));
                        phi_866_ = bitcast<f32>(((_e147 & 2147483648u) | select(_e500, 0u, select(_e473, true, _e494))));
                    } else {
                        phi_865_ = 0f;
                        phi_866_ = 1f;
                    }
                    let _e552 = phi_865_;
                    let _e554 = phi_866_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2468_ = false;
                    phi_878_ = type_48(type_39(type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e552), 0u, 0u);
                    phi_881_ = select(0u, 2147483648u, (_e71 == 0u));
                    phi_883_ = ((3u * _e71) + 1u);
                    phi_885_ = (_e554 <= _e552);
                    phi_887_ = 0u;
                    loop {
                        let _e563 = phi_2468_;
                        let _e565 = phi_878_;
                        let _e567 = phi_881_;
                        let _e569 = phi_883_;
                        let _e571 = phi_885_;
                        let _e573 = phi_887_;
                        local_2 = _e565;
                        local_3 = _e565;
                        if _e571 {
                            phi_898_ = true;
                        } else {
                            phi_898_ = (_e573 > 0u);
                        }
                        let _e576 = phi_898_;
                        if _e576 {
                            let _e577 = (_e569 > 0u);
                            if _e577 {
                                if _e571 {
                                    phi_930_ = _e567;
                                    phi_931_ = _e571;
                                    phi_932_ = _e573;
                                } else {
                                    let _e578 = (_e573 - 1u);
                                    let _e579 = (_e578 % 128u);
                                    let _e580 = (_e579 < 128u);
                                    if _e580 {
                                    } else {
                                        phi_2622_ = true;
                                        break;
                                    }
                                    let _e582 = local_1[_e579];
                                    if _e580 {
                                    } else {
                                        phi_2622_ = true;
                                        break;
                                    }
                                    let _e584 = local[_e579];
                                    phi_930_ = _e582;
                                    phi_931_ = (_e584 <= _e565.member.member_1);
                                    phi_932_ = _e578;
                                }
                                let _e589 = phi_930_;
                                let _e591 = phi_931_;
                                let _e593 = phi_932_;
                                if _e591 {
                                    if ((_e589 & 2147483648u) != 0u) {
                                        phi_947_ = _e565;
                                        phi_950_ = type_4(0u, ((_e589 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e798 = phi_947_;
                                            let _e800 = phi_950_;
                                            local_4 = _e798;
                                            if (_e800.member < _e800.member_1) {
                                                phi_951_ = type_4((_e800.member + 1u), _e800.member_1);
                                                phi_973_ = type_4(1u, _e800.member);
                                            } else {
                                                phi_951_ = _e800;
                                                phi_973_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e813 = phi_951_;
                                            let _e815 = phi_973_;
                                            let _e819 = (bitcast<i32>(_e815.member) != 0i);
                                            if _e819 {
                                                let _e825 = type_48(_e798.member, _e798.member_1, (_e798.member_2 + 1u));
                                                let _e826 = ((_e589 & 268435455u) + _e815.member_1);
                                                let _e827 = (_e826 < _e73);
                                                if _e827 {
                                                    if _e827 {
                                                    } else {
                                                        phi_2462_ = true;
                                                        break;
                                                    }
                                                    let _e831 = global_3.member[_e826].member_1;
                                                    phi_997_ = _e831;
                                                } else {
                                                    phi_997_ = 4294967295u;
                                                }
                                                let _e833 = phi_997_;
                                                if (_e826 >= _e73) {
                                                    phi_1086_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e827 {
                                                    } else {
                                                        phi_2462_ = true;
                                                        break;
                                                    }
                                                    let _e835 = (_e199 % 3u);
                                                    let _e836 = (_e198 % 3u);
                                                    let _e837 = (_e200 % 3u);
                                                    if (_e835 < 9u) {
                                                    } else {
                                                        phi_2462_ = true;
                                                        break;
                                                    }
                                                    let _e843 = global_3.member[_e826].member[_e835];
                                                    if (_e836 < 9u) {
                                                    } else {
                                                        phi_2462_ = true;
                                                        break;
                                                    }
                                                    let _e849 = global_3.member[_e826].member[_e836];
                                                    if (_e837 < 9u) {
                                                    } else {
                                                        phi_2462_ = true;
                                                        break;
                                                    }
                                                    let _e855 = global_3.member[_e826].member[_e837];
                                                    let _e857 = (3u + _e835);
                                                    if (_e857 < 9u) {
                                                    } else {
                                                        phi_2462_ = true;
                                                        break;
                                                    }
                                                    let _e863 = global_3.member[_e826].member[_e857];
                                                    let _e864 = (3u + _e836);
                                                    if (_e864 < 9u) {
                                                    } else {
                                                        phi_2462_ = true;
                                                        break;
                                                    }
                                                    let _e870 = global_3.member[_e826].member[_e864];
                                                    let _e871 = (3u + _e837);
                                                    if (_e871 < 9u) {
                                                    } else {
                                                        phi_2462_ = true;
                                                        break;
                                                    }
                                                    let _e877 = global_3.member[_e826].member[_e871];
                                                    let _e879 = (6u + _e835);
                                                    if (_e879 < 9u) {
                                                    } else {
                                                        phi_2462_ = true;
                                                        break;
                                                    }
                                                    let _e885 = global_3.member[_e826].member[_e879];
                                                    let _e886 = (6u + _e836);
                                                    if (_e886 < 9u) {
                                                    } else {
                                                        phi_2462_ = true;
                                                        break;
                                                    }
                                                    let _e892 = global_3.member[_e826].member[_e886];
                                                    let _e893 = (6u + _e837);
                                                    if (_e893 < 9u) {
                                                    } else {
                                                        phi_2462_ = true;
                                                        break;
                                                    }
                                                    let _e899 = global_3.member[_e826].member[_e893];
                                                    phi_1086_ = array<array<f32, 3>, 3>(array<f32, 3>(_e843, _e849, _e855), array<f32, 3>(_e863, _e870, _e877), array<f32, 3>(_e885, _e892, _e899));
                                                }
                                                let _e903 = phi_1086_;
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
                                                        phi_1911_ = type_27();
                                                        phi_1912_ = true;
                                                        phi_1913_ = false;
                                                    } else {
                                                        let _e979 = select(_e928, _e915, (_e915 < _e928));
                                                        if (select(_e941, _e979, (_e979 < _e941)) > 0f) {
                                                            phi_1203_ = true;
                                                        } else {
                                                            let _e984 = select(_e928, _e915, (_e915 > _e928));
                                                            phi_1203_ = (select(_e941, _e984, (_e984 > _e941)) < 0f);
                                                        }
                                                        let _e989 = phi_1203_;
                                                        if _e989 {
                                                            phi_1908_ = type_27();
                                                            phi_1909_ = true;
                                                            phi_1910_ = false;
                                                        } else {
                                                            let _e991 = select(_e931, _e918, (_e918 < _e931));
                                                            if (select(_e944, _e991, (_e991 < _e944)) > 0f) {
                                                                phi_1232_ = true;
                                                            } else {
                                                                let _e996 = select(_e931, _e918, (_e918 > _e931));
                                                                phi_1232_ = (select(_e944, _e996, (_e996 > _e944)) < 0f);
                                                            }
                                                            let _e1001 = phi_1232_;
                                                            if _e1001 {
                                                                phi_1906_ = type_27();
                                                                phi_1907_ = false;
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
                                                                    phi_1901_ = type_27();
                                                                    phi_1902_ = true;
                                                                } else {
                                                                    let _e1066 = (_e1064 > _e798.member.member_1);
                                                                    if _e1066 {
                                                                        phi_1900_ = type_27();
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
                                                                            phi_1633_ = _e931;
                                                                            phi_1634_ = _e928;
                                                                            phi_1635_ = _e918;
                                                                            phi_1636_ = _e915;
                                                                            phi_1637_ = _e1067;
                                                                            phi_1638_ = _e1081;
                                                                            phi_1639_ = _e1077;
                                                                            phi_1640_ = _e1073;
                                                                        } else {
                                                                            let _e1126 = (_e1107 == _e1124);
                                                                            let _e1131 = vec3(_e1126);
                                                                            phi_1633_ = select(_e918, _e944, _e1126);
                                                                            phi_1634_ = select(_e915, _e941, _e1126);
                                                                            phi_1635_ = select(_e944, _e931, _e1126);
                                                                            phi_1636_ = select(_e941, _e928, _e1126);
                                                                            phi_1637_ = select(_e1069, _e1068, _e1131);
                                                                            phi_1638_ = select(_e1077, _e1073, _e1131);
                                                                            phi_1639_ = select(_e1073, _e1081, _e1131);
                                                                            phi_1640_ = select(_e1081, _e1077, _e1131);
                                                                        }
                                                                        let _e1137 = phi_1633_;
                                                                        let _e1139 = phi_1634_;
                                                                        let _e1141 = phi_1635_;
                                                                        let _e1143 = phi_1636_;
                                                                        let _e1145 = phi_1637_;
                                                                        let _e1147 = phi_1638_;
                                                                        let _e1149 = phi_1639_;
                                                                        let _e1151 = phi_1640_;
                                                                        let _e1158 = ((_e1149.y * _e1147.z) - (_e1147.y * _e1149.z));
                                                                        let _e1163 = ((_e1149.z * _e1147.x) - (_e1147.z * _e1149.x));
                                                                        let _e1166 = ((_e1149.x * _e1147.y) - (_e1147.x * _e1149.y));
                                                                        if (_e966 >= _e970) {
                                                                            phi_1671_ = select(true, false, (_e966 >= _e974));
                                                                        } else {
                                                                            phi_1671_ = true;
                                                                        }
                                                                        let _e1171 = phi_1671_;
                                                                        if _e1171 {
                                                                            phi_1680_ = select(_e1069, _e1068, vec3((_e970 >= _e974)));
                                                                        } else {
                                                                            phi_1680_ = _e1067;
                                                                        }
                                                                        let _e1176 = phi_1680_;
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
                                                                                phi_1845_ = (_e1187 / _e1192);
                                                                            } else {
                                                                                phi_1845_ = f32();
                                                                            }
                                                                            let _e1297 = phi_1845_;
                                                                            phi_1847_ = _e1297;
                                                                            phi_1848_ = select(true, false, _e1294);
                                                                        } else {
                                                                            phi_1847_ = f32();
                                                                            phi_1848_ = true;
                                                                        }
                                                                        let _e1300 = phi_1847_;
                                                                        let _e1302 = phi_1848_;
                                                                        if _e1302 {
                                                                            let _e1310 = (((_e1158 * (_e1219 - (_e303 * _e1222))) + (_e1163 * (_e1220 - (_e371 * _e1222)))) / _e1192);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1310) & 2147483647u)) <= _e1124) {
                                                                                phi_1868_ = (_e1222 + _e1310);
                                                                            } else {
                                                                                phi_1868_ = _e1222;
                                                                            }
                                                                            let _e1317 = phi_1868_;
                                                                            phi_1869_ = _e1317;
                                                                        } else {
                                                                            phi_1869_ = _e1300;
                                                                        }
                                                                        let _e1319 = phi_1869_;
                                                                        let _e1321 = select(_e1057, _e1319, (_e1319 < _e1057));
                                                                        let _e1323 = select(_e1049, _e1321, (_e1321 > _e1049));
                                                                        if (_e1323 >= _e554) {
                                                                            let _e1325 = (_e1323 <= _e798.member.member_1);
                                                                            if _e1325 {
                                                                                let _e1326 = (1f / _e976);
                                                                                phi_1892_ = type_27(_e1323, (_e970 * _e1326), (_e974 * _e1326), _e833);
                                                                            } else {
                                                                                phi_1892_ = type_27();
                                                                            }
                                                                            let _e1331 = phi_1892_;
                                                                            phi_1894_ = _e1331;
                                                                            phi_1895_ = select(true, false, _e1325);
                                                                        } else {
                                                                            phi_1894_ = type_27();
                                                                            phi_1895_ = true;
                                                                        }
                                                                        let _e1334 = phi_1894_;
                                                                        let _e1336 = phi_1895_;
                                                                        if _e1336 {
                                                                            phi_1899_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1899_ = _e1334;
                                                                        }
                                                                        let _e1338 = phi_1899_;
                                                                        phi_1900_ = _e1338;
                                                                    }
                                                                    let _e1340 = phi_1900_;
                                                                    phi_1901_ = _e1340;
                                                                    phi_1902_ = _e1066;
                                                                }
                                                                let _e1342 = phi_1901_;
                                                                let _e1344 = phi_1902_;
                                                                phi_1906_ = _e1342;
                                                                phi_1907_ = _e1344;
                                                            }
                                                            let _e1346 = phi_1906_;
                                                            let _e1348 = phi_1907_;
                                                            phi_1908_ = _e1346;
                                                            phi_1909_ = _e1001;
                                                            phi_1910_ = _e1348;
                                                        }
                                                        let _e1350 = phi_1908_;
                                                        let _e1352 = phi_1909_;
                                                        let _e1354 = phi_1910_;
                                                        phi_1911_ = _e1350;
                                                        phi_1912_ = _e1352;
                                                        phi_1913_ = _e1354;
                                                    }
                                                    let _e1356 = phi_1911_;
                                                    let _e1358 = phi_1912_;
                                                    let _e1360 = phi_1913_;
                                                    phi_1921_ = _e1356;
                                                    phi_1922_ = select(_e1360, true, _e1358);
                                                } else {
                                                    phi_1921_ = type_27();
                                                    phi_1922_ = true;
                                                }
                                                let _e1363 = phi_1921_;
                                                let _e1365 = phi_1922_;
                                                if _e1365 {
                                                    phi_1926_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1926_ = _e1363;
                                                }
                                                let _e1367 = phi_1926_;
                                                if (_e1367.member_3 != 4294967295u) {
                                                    if (_e833 != 4294967295u) {
                                                        if (_e1367.member < _e798.member.member.member) {
                                                            phi_1952_ = true;
                                                        } else {
                                                            if (_e1367.member == _e798.member.member.member) {
                                                                phi_1951_ = (_e1367.member_3 < _e798.member.member.member_3);
                                                            } else {
                                                                phi_1951_ = false;
                                                            }
                                                            let _e1382 = phi_1951_;
                                                            phi_1952_ = _e1382;
                                                        }
                                                        let _e1384 = phi_1952_;
                                                        if _e1384 {
                                                            phi_1959_ = type_48(type_39(_e1367, _e1367.member), _e825.member_1, _e825.member_2);
                                                        } else {
                                                            phi_1959_ = _e825;
                                                        }
                                                        let _e1391 = phi_1959_;
                                                        phi_1960_ = _e1391;
                                                    } else {
                                                        phi_1960_ = _e825;
                                                    }
                                                    let _e1393 = phi_1960_;
                                                    phi_1961_ = _e1393;
                                                } else {
                                                    phi_1961_ = _e825;
                                                }
                                                let _e1395 = phi_1961_;
                                                phi_948_ = _e1395;
                                            } else {
                                                phi_948_ = type_48();
                                            }
                                            let _e1397 = phi_948_;
                                            continue;
                                            continuing {
                                                phi_947_ = _e1397;
                                                phi_950_ = _e813;
                                                phi_2462_ = _e563;
                                                break if !(_e819);
                                            }
                                        }
                                        let _e1400 = phi_2462_;
                                        phi_2622_ = _e1400;
                                        if _e1400 {
                                            break;
                                        }
                                        phi_2626_ = _e1400;
                                        let _e1571 = local_4;
                                        phi_2419_ = _e1571;
                                        phi_2420_ = _e589;
                                        phi_2421_ = false;
                                        phi_2422_ = _e593;
                                    } else {
                                        if (_e589 >= _e71) {
                                            phi_2024_ = type_44(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e589 < _e71) {
                                            } else {
                                                phi_2622_ = true;
                                                break;
                                            }
                                            let _e609 = (_e199 % 3u);
                                            if (_e609 < 3u) {
                                            } else {
                                                phi_2622_ = true;
                                                break;
                                            }
                                            let _e615 = global_2.member[_e589].member[_e609];
                                            let _e621 = (_e198 % 3u);
                                            if (_e621 < 3u) {
                                            } else {
                                                phi_2622_ = true;
                                                break;
                                            }
                                            let _e627 = global_2.member[_e589].member[_e621];
                                            let _e633 = (_e200 % 3u);
                                            if (_e633 < 3u) {
                                            } else {
                                                phi_2622_ = true;
                                                break;
                                            }
                                            let _e639 = global_2.member[_e589].member[_e633];
                                            let _e649 = global_2.member[_e589].member_1;
                                            let _e653 = global_2.member[_e589].member_2;
                                            phi_2024_ = type_44(array<vec4<f32>, 3>(vec4<f32>(_e615[0], _e615[1], _e615[2], _e615[3]), vec4<f32>(_e627[0], _e627[1], _e627[2], _e627[3]), vec4<f32>(_e639[0], _e639[1], _e639[2], _e639[3])), _e649, _e653);
                                        }
                                        let _e656 = phi_2024_;
                                        let _e669 = ((_e656.member[0].x - _e301) * _e306);
                                        let _e670 = ((_e656.member[0].y - _e301) * _e306);
                                        let _e671 = ((_e656.member[0].z - _e302) * _e306);
                                        let _e672 = ((_e656.member[0].w - _e302) * _e306);
                                        let _e682 = ((_e656.member[1].x - _e369) * _e374);
                                        let _e683 = ((_e656.member[1].y - _e369) * _e374);
                                        let _e684 = ((_e656.member[1].z - _e370) * _e374);
                                        let _e685 = ((_e656.member[1].w - _e370) * _e374);
                                        let _e695 = ((_e656.member[2].x - _e437) * _e442);
                                        let _e696 = ((_e656.member[2].y - _e437) * _e442);
                                        let _e697 = ((_e656.member[2].z - _e438) * _e442);
                                        let _e698 = ((_e656.member[2].w - _e438) * _e442);
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
                                                    phi_2368_ = _e656.member_2;
                                                } else {
                                                    phi_2368_ = _e656.member_1;
                                                }
                                                let _e763 = phi_2368_;
                                                let _e766 = (_e593 % 128u);
                                                let _e767 = (_e766 < 128u);
                                                if _e767 {
                                                } else {
                                                    phi_2622_ = true;
                                                    break;
                                                }
                                                local_1[_e766] = _e763;
                                                if _e767 {
                                                } else {
                                                    phi_2622_ = true;
                                                    break;
                                                }
                                                local[_e766] = select(_e752, _e750, (_e750 > _e752));
                                                if _e759 {
                                                    phi_2396_ = _e656.member_1;
                                                } else {
                                                    phi_2396_ = _e656.member_2;
                                                }
                                                let _e774 = phi_2396_;
                                                phi_2397_ = _e774;
                                                phi_2398_ = (_e593 + 1u);
                                            } else {
                                                phi_2397_ = u32();
                                                phi_2398_ = u32();
                                            }
                                            let _e776 = phi_2397_;
                                            let _e778 = phi_2398_;
                                            phi_2400_ = _e776;
                                            phi_2401_ = _e778;
                                            phi_2402_ = select(true, false, _e758);
                                        } else {
                                            phi_2400_ = u32();
                                            phi_2401_ = u32();
                                            phi_2402_ = true;
                                        }
                                        let _e781 = phi_2400_;
                                        let _e783 = phi_2401_;
                                        let _e785 = phi_2402_;
                                        if _e785 {
                                            if _e757 {
                                                phi_2411_ = _e656.member_1;
                                            } else {
                                                phi_2411_ = _e656.member_2;
                                            }
                                            let _e789 = phi_2411_;
                                            phi_2416_ = _e789;
                                            phi_2417_ = select(_e758, true, _e757);
                                        } else {
                                            phi_2416_ = _e781;
                                            phi_2417_ = _e591;
                                        }
                                        let _e792 = phi_2416_;
                                        let _e794 = phi_2417_;
                                        phi_2626_ = _e563;
                                        phi_2419_ = type_48(_e565.member, (_e565.member_1 + 1u), _e565.member_2);
                                        phi_2420_ = _e792;
                                        phi_2421_ = _e794;
                                        phi_2422_ = select(_e783, _e593, _e785);
                                    }
                                    let _e1402 = phi_2626_;
                                    let _e1404 = phi_2419_;
                                    let _e1406 = phi_2420_;
                                    let _e1408 = phi_2421_;
                                    let _e1410 = phi_2422_;
                                    phi_2625_ = _e1402;
                                    phi_2423_ = _e1404;
                                    phi_2424_ = _e1406;
                                    phi_2425_ = (_e569 - 1u);
                                    phi_2426_ = _e1408;
                                    phi_2427_ = _e1410;
                                } else {
                                    phi_2625_ = _e563;
                                    phi_2423_ = _e565;
                                    phi_2424_ = _e589;
                                    phi_2425_ = _e569;
                                    phi_2426_ = _e591;
                                    phi_2427_ = _e593;
                                }
                                let _e1412 = phi_2625_;
                                let _e1414 = phi_2423_;
                                let _e1416 = phi_2424_;
                                let _e1418 = phi_2425_;
                                let _e1420 = phi_2426_;
                                let _e1422 = phi_2427_;
                                phi_2624_ = _e1412;
                                phi_2428_ = _e1414;
                                phi_2429_ = _e1416;
                                phi_2430_ = _e1418;
                                phi_2431_ = _e1420;
                                phi_2432_ = _e1422;
                            } else {
                                phi_2624_ = _e563;
                                phi_2428_ = type_48();
                                phi_2429_ = u32();
                                phi_2430_ = u32();
                                phi_2431_ = bool();
                                phi_2432_ = u32();
                            }
                            let _e1424 = phi_2624_;
                            let _e1426 = phi_2428_;
                            let _e1428 = phi_2429_;
                            let _e1430 = phi_2430_;
                            let _e1432 = phi_2431_;
                            let _e1434 = phi_2432_;
                            phi_2623_ = _e1424;
                            phi_879_ = _e1426;
                            phi_882_ = _e1428;
                            phi_884_ = _e1430;
                            phi_886_ = _e1432;
                            phi_888_ = _e1434;
                            phi_2433_ = _e577;
                        } else {
                            phi_2623_ = _e563;
                            phi_879_ = type_48();
                            phi_882_ = u32();
                            phi_884_ = u32();
                            phi_886_ = bool();
                            phi_888_ = u32();
                            phi_2433_ = false;
                        }
                        let _e1436 = phi_2623_;
                        let _e1438 = phi_879_;
                        let _e1440 = phi_882_;
                        let _e1442 = phi_884_;
                        let _e1444 = phi_886_;
                        let _e1446 = phi_888_;
                        let _e1448 = phi_2433_;
                        continue;
                        continuing {
                            phi_2468_ = _e1436;
                            phi_878_ = _e1438;
                            phi_881_ = _e1440;
                            phi_883_ = _e1442;
                            phi_885_ = _e1444;
                            phi_887_ = _e1446;
                            phi_2622_ = _e1436;
                            break if !(_e1448);
                        }
                    }
                    let _e1451 = phi_2622_;
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
