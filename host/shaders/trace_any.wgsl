struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_11 {
    member: vec4<u32>,
}

struct type_16 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_18 {
    member: array<type_16>,
}

struct type_26 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_27 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_30 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_32 {
    member: array<type_30>,
}

struct type_42 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_44 {
    member: array<type_27>,
}

struct type_46 {
    member: f32,
    member_1: bool,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_11;
@group(0) @binding(1) 
var<storage> global_2: type_32;
@group(0) @binding(2) 
var<storage> global_3: type_18;
@group(0) @binding(3) 
var<storage> global_4: type_44;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_4;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_281_: i32;
    var phi_282_: i32;
    var phi_292_: bool;
    var phi_302_: u32;
    var phi_303_: u32;
    var phi_305_: bool;
    var phi_310_: u32;
    var phi_323_: i32;
    var phi_343_: i32;
    var phi_361_: f32;
    var phi_367_: f32;
    var phi_407_: f32;
    var phi_413_: f32;
    var phi_465_: f32;
    var phi_477_: f32;
    var phi_486_: f32;
    var phi_492_: f32;
    var phi_532_: f32;
    var phi_538_: f32;
    var phi_590_: f32;
    var phi_602_: f32;
    var phi_611_: f32;
    var phi_617_: f32;
    var phi_657_: f32;
    var phi_663_: f32;
    var phi_715_: f32;
    var phi_727_: f32;
    var phi_782_: i32;
    var phi_804_: u32;
    var phi_805_: u32;
    var phi_842_: i32;
    var phi_864_: u32;
    var phi_865_: u32;
    var phi_873_: f32;
    var phi_874_: f32;
    var phi_2543_: bool;
    var phi_889_: type_46;
    var phi_892_: bool;
    var phi_894_: u32;
    var phi_896_: u32;
    var phi_898_: u32;
    var phi_909_: bool;
    var phi_941_: bool;
    var phi_942_: u32;
    var phi_943_: u32;
    var phi_2080_: type_42;
    var phi_2442_: u32;
    var phi_2470_: u32;
    var phi_2471_: u32;
    var phi_2472_: u32;
    var phi_2474_: u32;
    var phi_2475_: u32;
    var phi_2476_: bool;
    var phi_2485_: u32;
    var phi_2490_: bool;
    var phi_2492_: u32;
    var phi_958_: type_46;
    var phi_961_: type_7;
    var phi_962_: type_7;
    var phi_984_: type_7;
    var phi_1005_: u32;
    var phi_1097_: array<array<f32, 3>, 3>;
    var phi_1249_: bool;
    var phi_1278_: bool;
    var phi_1697_: f32;
    var phi_1698_: f32;
    var phi_1699_: f32;
    var phi_1700_: f32;
    var phi_1701_: vec3<f32>;
    var phi_1702_: vec3<f32>;
    var phi_1703_: vec3<f32>;
    var phi_1704_: vec3<f32>;
    var phi_1741_: bool;
    var phi_1750_: vec3<f32>;
    var phi_1915_: f32;
    var phi_1917_: f32;
    var phi_1918_: bool;
    var phi_1938_: f32;
    var phi_1939_: f32;
    var phi_1962_: type_26;
    var phi_1964_: type_26;
    var phi_1965_: bool;
    var phi_1969_: type_26;
    var phi_1970_: type_26;
    var phi_1971_: type_26;
    var phi_1972_: bool;
    var phi_1976_: type_26;
    var phi_1977_: bool;
    var phi_1978_: type_26;
    var phi_1979_: bool;
    var phi_1980_: bool;
    var phi_1981_: type_26;
    var phi_1982_: bool;
    var phi_1983_: bool;
    var phi_1991_: type_26;
    var phi_1992_: bool;
    var phi_1996_: type_26;
    var phi_2007_: type_46;
    var phi_2008_: type_46;
    var phi_959_: type_46;
    var phi_2537_: bool;
    var local_2: type_46;
    var phi_2698_: bool;
    var phi_2496_: type_46;
    var phi_2497_: bool;
    var phi_2498_: u32;
    var phi_2499_: u32;
    var phi_2697_: bool;
    var phi_2500_: type_46;
    var phi_2501_: bool;
    var phi_2502_: u32;
    var phi_2503_: u32;
    var phi_2504_: u32;
    var phi_2696_: bool;
    var phi_2505_: type_46;
    var phi_2506_: bool;
    var phi_2507_: u32;
    var phi_2508_: u32;
    var phi_2509_: u32;
    var phi_2695_: bool;
    var phi_890_: type_46;
    var phi_893_: bool;
    var phi_895_: u32;
    var phi_897_: u32;
    var phi_899_: u32;
    var phi_2510_: bool;
    var phi_2694_: bool;
    var local_3: type_46;
    var local_4: type_46;

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
                            phi_281_ = (bitcast<i32>((_e164 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_281_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e164)), 32u, (_e164 == 0u))));
                        }
                        let _e178 = phi_281_;
                        phi_282_ = _e178;
                    } else {
                        phi_282_ = 0i;
                    }
                    let _e180 = phi_282_;
                    let _e181 = (_e97 == _e136);
                    if _e181 {
                        phi_292_ = true;
                    } else {
                        phi_292_ = (_e104 == _e136);
                    }
                    let _e184 = phi_292_;
                    let _e185 = select(1u, 0u, _e181);
                    if _e184 {
                        let _e186 = (_e185 + 1u);
                        phi_302_ = _e186;
                        phi_303_ = _e186;
                        phi_305_ = select(true, false, (_e186 == 2u));
                    } else {
                        phi_302_ = u32();
                        phi_303_ = 0u;
                        phi_305_ = true;
                    }
                    let _e190 = phi_302_;
                    let _e192 = phi_303_;
                    let _e194 = phi_305_;
                    if _e194 {
                        phi_310_ = (_e192 + 1u);
                    } else {
                        phi_310_ = 0u;
                    }
                    let _e198 = phi_310_;
                    let _e199 = select(_e190, _e192, _e194);
                    let _e200 = select(_e185, select(2u, _e185, _e184), _e194);
                    if (_e85 < -126i) {
                        phi_323_ = -126i;
                    } else {
                        phi_323_ = select(_e85, 127i, (_e85 > 127i));
                    }
                    let _e205 = phi_323_;
                    let _e210 = bitcast<f32>((bitcast<u32>((_e205 + 127i)) << bitcast<u32>(23i)));
                    let _e216 = bitcast<f32>((bitcast<u32>(((_e85 - _e205) + 127i)) << bitcast<u32>(23i)));
                    let _e217 = -(_e180);
                    if (_e217 < -126i) {
                        phi_343_ = -126i;
                    } else {
                        phi_343_ = select(_e217, 127i, (_e217 > 127i));
                    }
                    let _e222 = phi_343_;
                    let _e227 = bitcast<f32>((bitcast<u32>((_e222 + 127i)) << bitcast<u32>(23i)));
                    let _e233 = bitcast<f32>((bitcast<u32>(((_e217 - _e222) + 127i)) << bitcast<u32>(23i)));
                    let _e237 = global_4.member[_e81].member;
                    let _e238 = (_e199 == 0u);
                    if _e238 {
                        phi_361_ = _e237[0];
                    } else {
                        phi_361_ = _e237[1];
                    }
                    let _e242 = phi_361_;
                    let _e243 = (_e199 == 2u);
                    if _e243 {
                        phi_367_ = _e237[2];
                    } else {
                        phi_367_ = _e242;
                    }
                    let _e246 = phi_367_;
                    let _e247 = bitcast<u32>(_e246);
                    let _e249 = ((_e247 & 2139095040u) != 0u);
                    let _e263 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e247 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e247 & 2147483648u))), _e246, _e249) * _e210) * select(0.00000011920929f, 1f, _e249)) * _e216);
                    let _e264 = global_4.member[_e81].member_2;
                    if _e238 {
                        phi_407_ = _e264[0];
                    } else {
                        phi_407_ = _e264[1];
                    }
                    let _e268 = phi_407_;
                    if _e243 {
                        phi_413_ = _e264[2];
                    } else {
                        phi_413_ = _e268;
                    }
                    let _e271 = phi_413_;
                    let _e272 = bitcast<u32>(_e271);
                    let _e274 = ((_e272 & 2139095040u) != 0u);
                    let _e288 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e272 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e272 & 2147483648u))), _e271, _e274) * _e227) * select(0.00000011920929f, 1f, _e274)) * _e233);
                    let _e292 = (bitcast<f32>((bitcast<u32>(_e288) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e292 {
                        let _e296 = (bitcast<f32>((bitcast<u32>(_e263) & 2147483647u)) * 0.00000011920929f);
                        phi_465_ = select(0.00000000000011368684f, _e296, (_e296 > 0.00000000000011368684f));
                    } else {
                        phi_465_ = 0f;
                    }
                    let _e300 = phi_465_;
                    let _e301 = (_e263 + _e300);
                    let _e302 = (_e263 - _e300);
                    let _e303 = select(_e288, 0f, _e292);
                    if _e292 {
                        phi_477_ = 38685626000000000000000000f;
                    } else {
                        phi_477_ = (1f / _e288);
                    }
                    let _e306 = phi_477_;
                    let _e307 = (_e198 == 0u);
                    if _e307 {
                        phi_486_ = _e237[0];
                    } else {
                        phi_486_ = _e237[1];
                    }
                    let _e311 = phi_486_;
                    let _e312 = (_e198 == 2u);
                    if _e312 {
                        phi_492_ = _e237[2];
                    } else {
                        phi_492_ = _e311;
                    }
                    let _e315 = phi_492_;
                    let _e316 = bitcast<u32>(_e315);
                    let _e318 = ((_e316 & 2139095040u) != 0u);
                    let _e332 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e316 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e316 & 2147483648u))), _e315, _e318) * _e210) * select(0.00000011920929f, 1f, _e318)) * _e216);
                    if _e307 {
                        phi_532_ = _e264[0];
                    } else {
                        phi_532_ = _e264[1];
                    }
                    let _e336 = phi_532_;
                    if _e312 {
                        phi_538_ = _e264[2];
                    } else {
                        phi_538_ = _e336;
                    }
                    let _e339 = phi_538_;
                    let _e340 = bitcast<u32>(_e339);
                    let _e342 = ((_e340 & 2139095040u) != 0u);
                    let _e356 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e340 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e340 & 2147483648u))), _e339, _e342) * _e227) * select(0.00000011920929f, 1f, _e342)) * _e233);
                    let _e360 = (bitcast<f32>((bitcast<u32>(_e356) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e360 {
                        let _e364 = (bitcast<f32>((bitcast<u32>(_e332) & 2147483647u)) * 0.00000011920929f);
                        phi_590_ = select(0.00000000000011368684f, _e364, (_e364 > 0.00000000000011368684f));
                    } else {
                        phi_590_ = 0f;
                    }
                    let _e368 = phi_590_;
                    let _e369 = (_e332 + _e368);
                    let _e370 = (_e332 - _e368);
                    let _e371 = select(_e356, 0f, _e360);
                    if _e360 {
                        phi_602_ = 38685626000000000000000000f;
                    } else {
                        phi_602_ = (1f / _e356);
                    }
                    let _e374 = phi_602_;
                    let _e375 = (_e200 == 0u);
                    if _e375 {
                        phi_611_ = _e237[0];
                    } else {
                        phi_611_ = _e237[1];
                    }
                    let _e379 = phi_611_;
                    let _e380 = (_e200 == 2u);
                    if _e380 {
                        phi_617_ = _e237[2];
                    } else {
                        phi_617_ = _e379;
                    }
                    let _e383 = phi_617_;
                    let _e384 = bitcast<u32>(_e383);
                    let _e386 = ((_e384 & 2139095040u) != 0u);
                    let _e400 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e384 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e384 & 2147483648u))), _e383, _e386) * _e210) * select(0.00000011920929f, 1f, _e386)) * _e216);
                    if _e375 {
                        phi_657_ = _e264[0];
                    } else {
                        phi_657_ = _e264[1];
                    }
                    let _e404 = phi_657_;
                    if _e380 {
                        phi_663_ = _e264[2];
                    } else {
                        phi_663_ = _e404;
                    }
                    let _e407 = phi_663_;
                    let _e408 = bitcast<u32>(_e407);
                    let _e410 = ((_e408 & 2139095040u) != 0u);
                    let _e424 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e408 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e408 & 2147483648u))), _e407, _e410) * _e227) * select(0.00000011920929f, 1f, _e410)) * _e233);
                    let _e428 = (bitcast<f32>((bitcast<u32>(_e424) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e428 {
                        let _e432 = (bitcast<f32>((bitcast<u32>(_e400) & 2147483647u)) * 0.00000011920929f);
                        phi_715_ = select(0.00000000000011368684f, _e432, (_e432 > 0.00000000000011368684f));
                    } else {
                        phi_715_ = 0f;
                    }
                    let _e436 = phi_715_;
                    let _e437 = (_e400 + _e436);
                    let _e438 = (_e400 - _e436);
                    let _e439 = select(_e424, 0f, _e428);
                    if _e428 {
                        phi_727_ = 38685626000000000000000000f;
                    } else {
                        phi_727_ = (1f / _e424);
                    }
                    let _e442 = phi_727_;
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
                            phi_782_ = 255i;
                        } else {
                            phi_782_ = (((_e469 + select(0i, 1i, (_e469 == 0i))) - _e476) + _e456);
                        }
                        let _e484 = phi_782_;
                        let _e494 = (_e484 <= 0i);
                        if _e494 {
                            phi_805_ = u32();
                        } else {
                            if _e473 {
                                phi_804_ = u32();
                            } else {
                                phi_804_ = select(((bitcast<u32>(_e484) << bitcast<u32>(23i)) | ((_e466 << bitcast<u32>(((_e476 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e484 >= 255i));
                            }
                            let _e498 = phi_804_;
                            phi_805_ = _e498;
                        }
                        let _e500 = phi_805_;
                        let _e512 = ((_e157 & 8388607u) | (select(0u, 1u, ((_e157 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e515 = bitcast<i32>((_e157 >> bitcast<u32>(23i)));
                        let _e519 = (_e512 == 0u);
                        let _e522 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e512)), 32u, _e519)) - 8i);
                        if (_e515 == 255i) {
                            phi_842_ = 255i;
                        } else {
                            phi_842_ = (((_e515 + select(0i, 1i, (_e515 == 0i))) - _e522) + _e456);
                        }
                        let _e530 = phi_842_;
                        let _e540 = (_e530 <= 0i);
                        if _e540 {
                            phi_865_ = u32();
                        } else {
                            if _e519 {
                                phi_864_ = u32();
                            } else {
                                phi_864_ = select(((bitcast<u32>(_e530) << bitcast<u32>(23i)) | ((_e512 << bitcast<u32>(((_e522 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e530 >= 255i));
                            }
                            let _e544 = phi_864_;
                            phi_865_ = _e544;
                        }
                        let _e546 = phi_865_;
                        phi_873_ = bitcast<f32>(((_e156 & 2147483648u) | select(_e546, 0u, select(_e519, true, _e540))));
                        phi_874_ = bitcast<f32>(((_e147 & 2147483648u) | select(_e500, 0u, select(_e473, true, _e494))));
                    } else {
                        phi_873_ = 0f;
                        phi_874_ = 1f;
                    }
                    let _e552 = phi_873_;
                    let _e554 = phi_874_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2543_ = false;
                    phi_889_ = type_46(_e552, false);
                    phi_892_ = (_e554 <= _e552);
                    phi_894_ = ((3u * _e71) + 1u);
                    phi_896_ = 0u;
                    phi_898_ = select(0u, 2147483648u, (_e71 == 0u));
                    loop {
                        let _e562 = phi_2543_;
                        let _e564 = phi_889_;
                        let _e566 = phi_892_;
                        let _e568 = phi_894_;
                        let _e570 = phi_896_;
                        let _e572 = phi_898_;
                        local_3 = _e564;
                        if _e566 {
                            phi_909_ = true;
                        } else {
                            phi_909_ = (_e570 > 0u);
                        }
                        let _e575 = phi_909_;
                        if _e575 {
                            let _e576 = (_e568 > 0u);
                            if _e576 {
                                if _e566 {
                                    phi_941_ = _e566;
                                    phi_942_ = _e570;
                                    phi_943_ = _e572;
                                } else {
                                    let _e577 = (_e570 - 1u);
                                    let _e578 = (_e577 % 128u);
                                    let _e579 = (_e578 < 128u);
                                    if _e579 {
                                    } else {
                                        phi_2694_ = true;
                                        break;
                                    }
                                    let _e581 = local_1[_e578];
                                    if _e579 {
                                    } else {
                                        phi_2694_ = true;
                                        break;
                                    }
                                    let _e583 = local[_e578];
                                    phi_941_ = (_e583 <= _e564.member);
                                    phi_942_ = _e577;
                                    phi_943_ = _e581;
                                }
                                let _e587 = phi_941_;
                                let _e589 = phi_942_;
                                let _e591 = phi_943_;
                                if _e587 {
                                    if ((_e591 & 2147483648u) != 0u) {
                                        phi_958_ = _e564;
                                        phi_961_ = type_7(0u, ((_e591 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e789 = phi_958_;
                                            let _e791 = phi_961_;
                                            local_2 = _e789;
                                            local_4 = _e789;
                                            if (_e791.member < _e791.member_1) {
                                                phi_962_ = type_7((_e791.member + 1u), _e791.member_1);
                                                phi_984_ = type_7(1u, _e791.member);
                                            } else {
                                                phi_962_ = _e791;
                                                phi_984_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e804 = phi_962_;
                                            let _e806 = phi_984_;
                                            let _e810 = (bitcast<i32>(_e806.member) != 0i);
                                            if _e810 {
                                                let _e811 = ((_e591 & 268435455u) + _e806.member_1);
                                                let _e812 = (_e811 < _e73);
                                                if _e812 {
                                                    if _e812 {
                                                    } else {
                                                        phi_2537_ = true;
                                                        break;
                                                    }
                                                    let _e816 = global_3.member[_e811].member_1;
                                                    phi_1005_ = _e816;
                                                } else {
                                                    phi_1005_ = 4294967295u;
                                                }
                                                let _e818 = phi_1005_;
                                                if (_e811 >= _e73) {
                                                    phi_1097_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e812 {
                                                    } else {
                                                        phi_2537_ = true;
                                                        break;
                                                    }
                                                    let _e820 = (_e199 % 3u);
                                                    let _e821 = (_e198 % 3u);
                                                    let _e822 = (_e200 % 3u);
                                                    if (_e820 < 9u) {
                                                    } else {
                                                        phi_2537_ = true;
                                                        break;
                                                    }
                                                    let _e828 = global_3.member[_e811].member[_e820];
                                                    if (_e821 < 9u) {
                                                    } else {
                                                        phi_2537_ = true;
                                                        break;
                                                    }
                                                    let _e834 = global_3.member[_e811].member[_e821];
                                                    if (_e822 < 9u) {
                                                    } else {
                                                        phi_2537_ = true;
                                                        break;
                                                    }
                                                    let _e840 = global_3.member[_e811].member[_e822];
                                                    let _e842 = (3u + _e820);
                                                    if (_e842 < 9u) {
                                                    } else {
                                                        phi_2537_ = true;
                                                        break;
                                                    }
                                                    let _e848 = global_3.member[_e811].member[_e842];
                                                    let _e849 = (3u + _e821);
                                                    if (_e849 < 9u) {
                                                    } else {
                                                        phi_2537_ = true;
                                                        break;
                                                    }
                                                    let _e855 = global_3.member[_e811].member[_e849];
                                                    let _e856 = (3u + _e822);
                                                    if (_e856 < 9u) {
                                                    } else {
                                                        phi_2537_ = true;
                                                        break;
                                                    }
                                                    let _e862 = global_3.member[_e811].member[_e856];
                                                    let _e864 = (6u + _e820);
                                                    if (_e864 < 9u) {
                                                    } else {
                                                        phi_2537_ = true;
                                                        break;
                                                    }
                                                    let _e870 = global_3.member[_e811].member[_e864];
                                                    let _e871 = (6u + _e821);
                                                    if (_e871 < 9u) {
                                                    } else {
                                                        phi_2537_ = true;
                                                        break;
                                                    }
                                                    let _e877 = global_3.member[_e811].member[_e871];
                                                    let _e878 = (6u + _e822);
                                                    if (_e878 < 9u) {
                                                    } else {
                                                        phi_2537_ = true;
                                                        break;
                                                    }
                                                    let _e884 = global_3.member[_e811].member[_e878];
                                                    phi_1097_ = array<array<f32, 3>, 3>(array<f32, 3>(_e828, _e834, _e840), array<f32, 3>(_e848, _e855, _e862), array<f32, 3>(_e870, _e877, _e884));
                                                }
                                                let _e888 = phi_1097_;
                                                let _e896 = (_e888[0][2] - _e400);
                                                let _e899 = (((_e888[0][0] - _e263) * _e439) - (_e896 * _e303));
                                                let _e902 = (((_e888[0][1] - _e332) * _e439) - (_e896 * _e371));
                                                let _e909 = (_e888[1][2] - _e400);
                                                let _e912 = (((_e888[1][0] - _e263) * _e439) - (_e909 * _e303));
                                                let _e915 = (((_e888[1][1] - _e332) * _e439) - (_e909 * _e371));
                                                let _e922 = (_e888[2][2] - _e400);
                                                let _e925 = (((_e888[2][0] - _e263) * _e439) - (_e922 * _e303));
                                                let _e928 = (((_e888[2][1] - _e332) * _e439) - (_e922 * _e371));
                                                let _e929 = (_e925 * _e915);
                                                let _e930 = (_e928 * _e912);
                                                let _e931 = (_e899 * _e928);
                                                let _e932 = (_e902 * _e925);
                                                let _e933 = (_e912 * _e902);
                                                let _e934 = (_e915 * _e899);
                                                let _e939 = (((_e929 >= _e930) && (_e931 >= _e932)) && (_e933 >= _e934));
                                                if (_e939 || (((_e929 <= _e930) && (_e931 <= _e932)) && (_e933 <= _e934))) {
                                                    let _e946 = select(-1f, 1f, _e939);
                                                    let _e948 = ((_e929 - _e930) * _e946);
                                                    let _e950 = select(0f, _e948, (_e948 > 0f));
                                                    let _e952 = ((_e931 - _e932) * _e946);
                                                    let _e954 = select(0f, _e952, (_e952 > 0f));
                                                    let _e956 = ((_e933 - _e934) * _e946);
                                                    let _e958 = select(0f, _e956, (_e956 > 0f));
                                                    let _e960 = ((_e950 + _e954) + _e958);
                                                    if (_e960 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1981_ = type_26();
                                                        phi_1982_ = true;
                                                        phi_1983_ = false;
                                                    } else {
                                                        let _e963 = select(_e912, _e899, (_e899 < _e912));
                                                        if (select(_e925, _e963, (_e963 < _e925)) > 0f) {
                                                            phi_1249_ = true;
                                                        } else {
                                                            let _e968 = select(_e912, _e899, (_e899 > _e912));
                                                            phi_1249_ = (select(_e925, _e968, (_e968 > _e925)) < 0f);
                                                        }
                                                        let _e973 = phi_1249_;
                                                        if _e973 {
                                                            phi_1978_ = type_26();
                                                            phi_1979_ = true;
                                                            phi_1980_ = false;
                                                        } else {
                                                            let _e975 = select(_e915, _e902, (_e902 < _e915));
                                                            if (select(_e928, _e975, (_e975 < _e928)) > 0f) {
                                                                phi_1278_ = true;
                                                            } else {
                                                                let _e980 = select(_e915, _e902, (_e902 > _e915));
                                                                phi_1278_ = (select(_e928, _e980, (_e980 > _e928)) < 0f);
                                                            }
                                                            let _e985 = phi_1278_;
                                                            if _e985 {
                                                                phi_1976_ = type_26();
                                                                phi_1977_ = false;
                                                            } else {
                                                                let _e987 = select(_e888[1][0], _e888[0][0], (_e888[0][0] < _e888[1][0]));
                                                                let _e991 = select(_e888[1][0], _e888[0][0], (_e888[0][0] > _e888[1][0]));
                                                                let _e995 = select(_e888[1][1], _e888[0][1], (_e888[0][1] < _e888[1][1]));
                                                                let _e999 = select(_e888[1][1], _e888[0][1], (_e888[0][1] > _e888[1][1]));
                                                                let _e1003 = select(_e888[1][2], _e888[0][2], (_e888[0][2] < _e888[1][2]));
                                                                let _e1007 = select(_e888[1][2], _e888[0][2], (_e888[0][2] > _e888[1][2]));
                                                                let _e1012 = ((select(_e888[2][0], _e987, (_e987 < _e888[2][0])) - _e301) * _e306);
                                                                let _e1013 = ((select(_e888[2][0], _e991, (_e991 > _e888[2][0])) - _e302) * _e306);
                                                                let _e1016 = ((select(_e888[2][1], _e995, (_e995 < _e888[2][1])) - _e369) * _e374);
                                                                let _e1017 = ((select(_e888[2][1], _e999, (_e999 > _e888[2][1])) - _e370) * _e374);
                                                                let _e1020 = ((select(_e888[2][2], _e1003, (_e1003 < _e888[2][2])) - _e437) * _e442);
                                                                let _e1021 = ((select(_e888[2][2], _e1007, (_e1007 > _e888[2][2])) - _e438) * _e442);
                                                                let _e1023 = select(_e1021, _e1020, (_e1020 < _e1021));
                                                                let _e1025 = select(_e1021, _e1020, (_e1020 > _e1021));
                                                                let _e1027 = select(_e1013, _e1012, (_e1012 < _e1013));
                                                                let _e1029 = select(_e1017, _e1016, (_e1016 < _e1017));
                                                                let _e1031 = select(_e1029, _e1027, (_e1027 > _e1029));
                                                                let _e1033 = select(_e1023, _e1031, (_e1031 > _e1023));
                                                                let _e1035 = select(_e1013, _e1012, (_e1012 > _e1013));
                                                                let _e1037 = select(_e1017, _e1016, (_e1016 > _e1017));
                                                                let _e1039 = select(_e1037, _e1035, (_e1035 < _e1037));
                                                                let _e1041 = select(_e1025, _e1039, (_e1039 < _e1025));
                                                                let _e1042 = -(_e1023);
                                                                let _e1048 = select(_e554, _e1033, (_e1033 > _e554));
                                                                if (_e1048 > (_e1041 + (select(_e1042, _e1025, (_e1025 > _e1042)) * 0.0000019073523f))) {
                                                                    phi_1971_ = type_26();
                                                                    phi_1972_ = true;
                                                                } else {
                                                                    let _e1050 = (_e1048 > _e789.member);
                                                                    if _e1050 {
                                                                        phi_1970_ = type_26();
                                                                    } else {
                                                                        let _e1051 = vec3<f32>(_e888[0][0], _e888[0][1], _e888[0][2]);
                                                                        let _e1052 = vec3<f32>(_e888[1][0], _e888[1][1], _e888[1][2]);
                                                                        let _e1053 = vec3<f32>(_e888[2][0], _e888[2][1], _e888[2][2]);
                                                                        let _e1054 = (_e888[1][0] - _e888[0][0]);
                                                                        let _e1055 = (_e888[1][1] - _e888[0][1]);
                                                                        let _e1056 = (_e888[1][2] - _e888[0][2]);
                                                                        let _e1057 = vec3<f32>(_e1054, _e1055, _e1056);
                                                                        let _e1058 = (_e888[2][0] - _e888[1][0]);
                                                                        let _e1059 = (_e888[2][1] - _e888[1][1]);
                                                                        let _e1060 = (_e888[2][2] - _e888[1][2]);
                                                                        let _e1061 = vec3<f32>(_e1058, _e1059, _e1060);
                                                                        let _e1062 = (_e888[0][0] - _e888[2][0]);
                                                                        let _e1063 = (_e888[0][1] - _e888[2][1]);
                                                                        let _e1064 = (_e888[0][2] - _e888[2][2]);
                                                                        let _e1065 = vec3<f32>(_e1062, _e1063, _e1064);
                                                                        let _e1068 = bitcast<f32>((bitcast<u32>(_e1054) & 2147483647u));
                                                                        let _e1071 = bitcast<f32>((bitcast<u32>(_e1055) & 2147483647u));
                                                                        let _e1073 = select(_e1071, _e1068, (_e1068 > _e1071));
                                                                        let _e1076 = bitcast<f32>((bitcast<u32>(_e1056) & 2147483647u));
                                                                        let _e1078 = select(_e1076, _e1073, (_e1073 > _e1076));
                                                                        let _e1081 = bitcast<f32>((bitcast<u32>(_e1058) & 2147483647u));
                                                                        let _e1084 = bitcast<f32>((bitcast<u32>(_e1059) & 2147483647u));
                                                                        let _e1086 = select(_e1084, _e1081, (_e1081 > _e1084));
                                                                        let _e1089 = bitcast<f32>((bitcast<u32>(_e1060) & 2147483647u));
                                                                        let _e1091 = select(_e1089, _e1086, (_e1086 > _e1089));
                                                                        let _e1094 = bitcast<f32>((bitcast<u32>(_e1062) & 2147483647u));
                                                                        let _e1097 = bitcast<f32>((bitcast<u32>(_e1063) & 2147483647u));
                                                                        let _e1099 = select(_e1097, _e1094, (_e1094 > _e1097));
                                                                        let _e1102 = bitcast<f32>((bitcast<u32>(_e1064) & 2147483647u));
                                                                        let _e1104 = select(_e1102, _e1099, (_e1099 > _e1102));
                                                                        let _e1106 = select(_e1091, _e1078, (_e1078 > _e1091));
                                                                        let _e1108 = select(_e1104, _e1106, (_e1106 > _e1104));
                                                                        if (_e1078 == _e1108) {
                                                                            phi_1697_ = _e915;
                                                                            phi_1698_ = _e912;
                                                                            phi_1699_ = _e902;
                                                                            phi_1700_ = _e899;
                                                                            phi_1701_ = _e1051;
                                                                            phi_1702_ = _e1065;
                                                                            phi_1703_ = _e1061;
                                                                            phi_1704_ = _e1057;
                                                                        } else {
                                                                            let _e1110 = (_e1091 == _e1108);
                                                                            let _e1115 = vec3(_e1110);
                                                                            phi_1697_ = select(_e902, _e928, _e1110);
                                                                            phi_1698_ = select(_e899, _e925, _e1110);
                                                                            phi_1699_ = select(_e928, _e915, _e1110);
                                                                            phi_1700_ = select(_e925, _e912, _e1110);
                                                                            phi_1701_ = select(_e1053, _e1052, _e1115);
                                                                            phi_1702_ = select(_e1061, _e1057, _e1115);
                                                                            phi_1703_ = select(_e1057, _e1065, _e1115);
                                                                            phi_1704_ = select(_e1065, _e1061, _e1115);
                                                                        }
                                                                        let _e1121 = phi_1697_;
                                                                        let _e1123 = phi_1698_;
                                                                        let _e1125 = phi_1699_;
                                                                        let _e1127 = phi_1700_;
                                                                        let _e1129 = phi_1701_;
                                                                        let _e1131 = phi_1702_;
                                                                        let _e1133 = phi_1703_;
                                                                        let _e1135 = phi_1704_;
                                                                        let _e1142 = ((_e1133.y * _e1131.z) - (_e1131.y * _e1133.z));
                                                                        let _e1147 = ((_e1133.z * _e1131.x) - (_e1131.z * _e1133.x));
                                                                        let _e1150 = ((_e1133.x * _e1131.y) - (_e1131.x * _e1133.y));
                                                                        if (_e950 >= _e954) {
                                                                            phi_1741_ = select(true, false, (_e950 >= _e958));
                                                                        } else {
                                                                            phi_1741_ = true;
                                                                        }
                                                                        let _e1155 = phi_1741_;
                                                                        if _e1155 {
                                                                            phi_1750_ = select(_e1053, _e1052, vec3((_e954 >= _e958)));
                                                                        } else {
                                                                            phi_1750_ = _e1051;
                                                                        }
                                                                        let _e1160 = phi_1750_;
                                                                        let _e1171 = (((_e1142 * (_e1160.x - _e263)) + (_e1147 * (_e1160.y - _e332))) + (_e1150 * (_e1160.z - _e400)));
                                                                        let _e1176 = (((_e1142 * _e303) + (_e1147 * _e371)) + (_e1150 * _e439));
                                                                        let _e1177 = (_e1123 - _e1127);
                                                                        let _e1178 = (_e1121 - _e1125);
                                                                        let _e1186 = (-(((_e1127 * _e1177) + (_e1125 * _e1178))) / ((_e1177 * _e1177) + (_e1178 * _e1178)));
                                                                        let _e1188 = select(1f, _e1186, (_e1186 < 1f));
                                                                        let _e1190 = select(0f, _e1188, (_e1188 > 0f));
                                                                        let _e1203 = ((_e1129.x + (_e1135.x * _e1190)) - _e263);
                                                                        let _e1204 = ((_e1129.y + (_e1135.y * _e1190)) - _e332);
                                                                        let _e1205 = ((_e1129.z + (_e1135.z * _e1190)) - _e400);
                                                                        let _e1206 = (_e1205 / _e439);
                                                                        let _e1218 = bitcast<f32>((bitcast<u32>(_e1203) & 2147483647u));
                                                                        let _e1221 = bitcast<f32>((bitcast<u32>(_e1204) & 2147483647u));
                                                                        let _e1223 = select(_e1221, _e1218, (_e1218 > _e1221));
                                                                        let _e1226 = bitcast<f32>((bitcast<u32>(_e1205) & 2147483647u));
                                                                        let _e1228 = select(_e1226, _e1223, (_e1223 > _e1226));
                                                                        let _e1234 = bitcast<f32>((bitcast<u32>(_e1142) & 2147483647u));
                                                                        let _e1237 = bitcast<f32>((bitcast<u32>(_e1147) & 2147483647u));
                                                                        let _e1239 = select(_e1237, _e1234, (_e1234 > _e1237));
                                                                        let _e1242 = bitcast<f32>((bitcast<u32>(_e1150) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1142 * _e1203) + (_e1147 * _e1204)) + (_e1150 * _e1205)) - _e1171)) & 2147483647u)) <= ((0.0000009536743f * select(_e1108, _e1228, (_e1228 > _e1108))) * select(_e1242, _e1239, (_e1239 > _e1242)))) {
                                                                            let _e1252 = bitcast<f32>((bitcast<u32>(_e1133.x) & 2147483647u));
                                                                            let _e1255 = bitcast<f32>((bitcast<u32>(_e1133.y) & 2147483647u));
                                                                            let _e1257 = select(_e1255, _e1252, (_e1252 > _e1255));
                                                                            let _e1260 = bitcast<f32>((bitcast<u32>(_e1133.z) & 2147483647u));
                                                                            let _e1266 = bitcast<f32>((bitcast<u32>(_e1131.x) & 2147483647u));
                                                                            let _e1269 = bitcast<f32>((bitcast<u32>(_e1131.y) & 2147483647u));
                                                                            let _e1271 = select(_e1269, _e1266, (_e1266 > _e1269));
                                                                            let _e1274 = bitcast<f32>((bitcast<u32>(_e1131.z) & 2147483647u));
                                                                            let _e1278 = (bitcast<f32>((bitcast<u32>(_e1176) & 2147483647u)) > ((0.0000038146973f * select(_e1260, _e1257, (_e1257 > _e1260))) * select(_e1274, _e1271, (_e1271 > _e1274))));
                                                                            if _e1278 {
                                                                                phi_1915_ = (_e1171 / _e1176);
                                                                            } else {
                                                                                phi_1915_ = f32();
                                                                            }
                                                                            let _e1281 = phi_1915_;
                                                                            phi_1917_ = _e1281;
                                                                            phi_1918_ = select(true, false, _e1278);
                                                                        } else {
                                                                            phi_1917_ = f32();
                                                                            phi_1918_ = true;
                                                                        }
                                                                        let _e1284 = phi_1917_;
                                                                        let _e1286 = phi_1918_;
                                                                        if _e1286 {
                                                                            let _e1294 = (((_e1142 * (_e1203 - (_e303 * _e1206))) + (_e1147 * (_e1204 - (_e371 * _e1206)))) / _e1176);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1294) & 2147483647u)) <= _e1108) {
                                                                                phi_1938_ = (_e1206 + _e1294);
                                                                            } else {
                                                                                phi_1938_ = _e1206;
                                                                            }
                                                                            let _e1301 = phi_1938_;
                                                                            phi_1939_ = _e1301;
                                                                        } else {
                                                                            phi_1939_ = _e1284;
                                                                        }
                                                                        let _e1303 = phi_1939_;
                                                                        let _e1305 = select(_e1041, _e1303, (_e1303 < _e1041));
                                                                        let _e1307 = select(_e1033, _e1305, (_e1305 > _e1033));
                                                                        if (_e1307 >= _e554) {
                                                                            let _e1309 = (_e1307 <= _e789.member);
                                                                            if _e1309 {
                                                                                let _e1310 = (1f / _e960);
                                                                                phi_1962_ = type_26(_e1307, (_e954 * _e1310), (_e958 * _e1310), _e818);
                                                                            } else {
                                                                                phi_1962_ = type_26();
                                                                            }
                                                                            let _e1315 = phi_1962_;
                                                                            phi_1964_ = _e1315;
                                                                            phi_1965_ = select(true, false, _e1309);
                                                                        } else {
                                                                            phi_1964_ = type_26();
                                                                            phi_1965_ = true;
                                                                        }
                                                                        let _e1318 = phi_1964_;
                                                                        let _e1320 = phi_1965_;
                                                                        if _e1320 {
                                                                            phi_1969_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1969_ = _e1318;
                                                                        }
                                                                        let _e1322 = phi_1969_;
                                                                        phi_1970_ = _e1322;
                                                                    }
                                                                    let _e1324 = phi_1970_;
                                                                    phi_1971_ = _e1324;
                                                                    phi_1972_ = _e1050;
                                                                }
                                                                let _e1326 = phi_1971_;
                                                                let _e1328 = phi_1972_;
                                                                phi_1976_ = _e1326;
                                                                phi_1977_ = _e1328;
                                                            }
                                                            let _e1330 = phi_1976_;
                                                            let _e1332 = phi_1977_;
                                                            phi_1978_ = _e1330;
                                                            phi_1979_ = _e985;
                                                            phi_1980_ = _e1332;
                                                        }
                                                        let _e1334 = phi_1978_;
                                                        let _e1336 = phi_1979_;
                                                        let _e1338 = phi_1980_;
                                                        phi_1981_ = _e1334;
                                                        phi_1982_ = _e1336;
                                                        phi_1983_ = _e1338;
                                                    }
                                                    let _e1340 = phi_1981_;
                                                    let _e1342 = phi_1982_;
                                                    let _e1344 = phi_1983_;
                                                    phi_1991_ = _e1340;
                                                    phi_1992_ = select(_e1344, true, _e1342);
                                                } else {
                                                    phi_1991_ = type_26();
                                                    phi_1992_ = true;
                                                }
                                                let _e1347 = phi_1991_;
                                                let _e1349 = phi_1992_;
                                                if _e1349 {
                                                    phi_1996_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1996_ = _e1347;
                                                }
                                                let _e1351 = phi_1996_;
                                                if (_e1351.member_3 != 4294967295u) {
                                                    if (_e818 != 4294967295u) {
                                                        phi_2007_ = type_46(_e789.member, true);
                                                    } else {
                                                        phi_2007_ = _e789;
                                                    }
                                                    let _e1359 = phi_2007_;
                                                    phi_2008_ = _e1359;
                                                } else {
                                                    phi_2008_ = _e789;
                                                }
                                                let _e1361 = phi_2008_;
                                                phi_959_ = _e1361;
                                            } else {
                                                phi_959_ = type_46();
                                            }
                                            let _e1363 = phi_959_;
                                            continue;
                                            continuing {
                                                phi_958_ = _e1363;
                                                phi_961_ = _e804;
                                                phi_2537_ = _e562;
                                                break if !(_e810);
                                            }
                                        }
                                        let _e1366 = phi_2537_;
                                        phi_2694_ = _e1366;
                                        if _e1366 {
                                            break;
                                        }
                                        let _e1368 = local_2;
                                        phi_2698_ = _e1366;
                                        let _e1533 = local_4;
                                        phi_2496_ = _e1533;
                                        phi_2497_ = false;
                                        phi_2498_ = select(_e589, 0u, _e1368.member_1);
                                        phi_2499_ = _e591;
                                    } else {
                                        if (_e591 >= _e71) {
                                            phi_2080_ = type_42(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e591 < _e71) {
                                            } else {
                                                phi_2694_ = true;
                                                break;
                                            }
                                            let _e601 = (_e199 % 3u);
                                            if (_e601 < 3u) {
                                            } else {
                                                phi_2694_ = true;
                                                break;
                                            }
                                            let _e607 = global_2.member[_e591].member[_e601];
                                            let _e613 = (_e198 % 3u);
                                            if (_e613 < 3u) {
                                            } else {
                                                phi_2694_ = true;
                                                break;
                                            }
                                            let _e619 = global_2.member[_e591].member[_e613];
                                            let _e625 = (_e200 % 3u);
                                            if (_e625 < 3u) {
                                            } else {
                                                phi_2694_ = true;
                                                break;
                                            }
                                            let _e631 = global_2.member[_e591].member[_e625];
                                            let _e641 = global_2.member[_e591].member_1;
                                            let _e645 = global_2.member[_e591].member_2;
                                            phi_2080_ = type_42(array<vec4<f32>, 3>(vec4<f32>(_e607[0], _e607[1], _e607[2], _e607[3]), vec4<f32>(_e619[0], _e619[1], _e619[2], _e619[3]), vec4<f32>(_e631[0], _e631[1], _e631[2], _e631[3])), _e641, _e645);
                                        }
                                        let _e648 = phi_2080_;
                                        let _e660 = ((_e648.member[0].x - _e301) * _e306);
                                        let _e661 = ((_e648.member[0].y - _e301) * _e306);
                                        let _e662 = ((_e648.member[0].z - _e302) * _e306);
                                        let _e663 = ((_e648.member[0].w - _e302) * _e306);
                                        let _e673 = ((_e648.member[1].x - _e369) * _e374);
                                        let _e674 = ((_e648.member[1].y - _e369) * _e374);
                                        let _e675 = ((_e648.member[1].z - _e370) * _e374);
                                        let _e676 = ((_e648.member[1].w - _e370) * _e374);
                                        let _e686 = ((_e648.member[2].x - _e437) * _e442);
                                        let _e687 = ((_e648.member[2].y - _e437) * _e442);
                                        let _e688 = ((_e648.member[2].z - _e438) * _e442);
                                        let _e689 = ((_e648.member[2].w - _e438) * _e442);
                                        let _e691 = select(_e688, _e686, (_e686 < _e688));
                                        let _e693 = select(_e689, _e687, (_e687 < _e689));
                                        let _e695 = select(_e688, _e686, (_e686 > _e688));
                                        let _e697 = select(_e689, _e687, (_e687 > _e689));
                                        let _e699 = select(_e662, _e660, (_e660 < _e662));
                                        let _e701 = select(_e663, _e661, (_e661 < _e663));
                                        let _e703 = select(_e675, _e673, (_e673 < _e675));
                                        let _e705 = select(_e676, _e674, (_e674 < _e676));
                                        let _e707 = select(_e703, _e699, (_e699 > _e703));
                                        let _e709 = select(_e705, _e701, (_e701 > _e705));
                                        let _e711 = select(_e691, _e707, (_e707 > _e691));
                                        let _e713 = select(_e693, _e709, (_e709 > _e693));
                                        let _e715 = select(_e662, _e660, (_e660 > _e662));
                                        let _e717 = select(_e663, _e661, (_e661 > _e663));
                                        let _e719 = select(_e675, _e673, (_e673 > _e675));
                                        let _e721 = select(_e676, _e674, (_e674 > _e676));
                                        let _e723 = select(_e719, _e715, (_e715 < _e719));
                                        let _e725 = select(_e721, _e717, (_e717 < _e721));
                                        let _e730 = -(_e691);
                                        let _e731 = -(_e693);
                                        let _e738 = (select(_e695, _e723, (_e723 < _e695)) + (select(_e730, _e695, (_e695 > _e730)) * 0.0000019073523f));
                                        let _e739 = (select(_e697, _e725, (_e725 < _e697)) + (select(_e731, _e697, (_e697 > _e731)) * 0.0000019073523f));
                                        let _e741 = select(_e554, _e711, (_e711 > _e554));
                                        let _e743 = select(_e554, _e713, (_e713 > _e554));
                                        let _e748 = (_e741 <= select(_e564.member, _e738, (_e738 < _e564.member)));
                                        let _e749 = (_e743 <= select(_e564.member, _e739, (_e739 < _e564.member)));
                                        let _e750 = (_e741 <= _e743);
                                        if _e748 {
                                            if _e749 {
                                                if _e750 {
                                                    phi_2442_ = _e648.member_2;
                                                } else {
                                                    phi_2442_ = _e648.member_1;
                                                }
                                                let _e754 = phi_2442_;
                                                let _e757 = (_e589 % 128u);
                                                let _e758 = (_e757 < 128u);
                                                if _e758 {
                                                } else {
                                                    phi_2694_ = true;
                                                    break;
                                                }
                                                local_1[_e757] = _e754;
                                                if _e758 {
                                                } else {
                                                    phi_2694_ = true;
                                                    break;
                                                }
                                                local[_e757] = select(_e743, _e741, !(_e750));
                                                if _e750 {
                                                    phi_2470_ = _e648.member_1;
                                                } else {
                                                    phi_2470_ = _e648.member_2;
                                                }
                                                let _e765 = phi_2470_;
                                                phi_2471_ = (_e589 + 1u);
                                                phi_2472_ = _e765;
                                            } else {
                                                phi_2471_ = u32();
                                                phi_2472_ = u32();
                                            }
                                            let _e767 = phi_2471_;
                                            let _e769 = phi_2472_;
                                            phi_2474_ = _e767;
                                            phi_2475_ = _e769;
                                            phi_2476_ = select(true, false, _e749);
                                        } else {
                                            phi_2474_ = u32();
                                            phi_2475_ = u32();
                                            phi_2476_ = true;
                                        }
                                        let _e772 = phi_2474_;
                                        let _e774 = phi_2475_;
                                        let _e776 = phi_2476_;
                                        if _e776 {
                                            if _e748 {
                                                phi_2485_ = _e648.member_1;
                                            } else {
                                                phi_2485_ = _e648.member_2;
                                            }
                                            let _e780 = phi_2485_;
                                            phi_2490_ = select(_e749, true, _e748);
                                            phi_2492_ = _e780;
                                        } else {
                                            phi_2490_ = _e587;
                                            phi_2492_ = _e774;
                                        }
                                        let _e783 = phi_2490_;
                                        let _e785 = phi_2492_;
                                        phi_2698_ = _e562;
                                        phi_2496_ = _e564;
                                        phi_2497_ = _e783;
                                        phi_2498_ = select(_e772, _e589, _e776);
                                        phi_2499_ = _e785;
                                    }
                                    let _e1372 = phi_2698_;
                                    let _e1374 = phi_2496_;
                                    let _e1376 = phi_2497_;
                                    let _e1378 = phi_2498_;
                                    let _e1380 = phi_2499_;
                                    phi_2697_ = _e1372;
                                    phi_2500_ = _e1374;
                                    phi_2501_ = _e1376;
                                    phi_2502_ = (_e568 - 1u);
                                    phi_2503_ = _e1378;
                                    phi_2504_ = _e1380;
                                } else {
                                    phi_2697_ = _e562;
                                    phi_2500_ = _e564;
                                    phi_2501_ = _e587;
                                    phi_2502_ = _e568;
                                    phi_2503_ = _e589;
                                    phi_2504_ = _e591;
                                }
                                let _e1382 = phi_2697_;
                                let _e1384 = phi_2500_;
                                let _e1386 = phi_2501_;
                                let _e1388 = phi_2502_;
                                let _e1390 = phi_2503_;
                                let _e1392 = phi_2504_;
                                phi_2696_ = _e1382;
                                phi_2505_ = _e1384;
                                phi_2506_ = _e1386;
                                phi_2507_ = _e1388;
                                phi_2508_ = _e1390;
                                phi_2509_ = _e1392;
                            } else {
                                phi_2696_ = _e562;
                                phi_2505_ = type_46();
                                phi_2506_ = bool();
                                phi_2507_ = u32();
                                phi_2508_ = u32();
                                phi_2509_ = u32();
                            }
                            let _e1394 = phi_2696_;
                            let _e1396 = phi_2505_;
                            let _e1398 = phi_2506_;
                            let _e1400 = phi_2507_;
                            let _e1402 = phi_2508_;
                            let _e1404 = phi_2509_;
                            phi_2695_ = _e1394;
                            phi_890_ = _e1396;
                            phi_893_ = _e1398;
                            phi_895_ = _e1400;
                            phi_897_ = _e1402;
                            phi_899_ = _e1404;
                            phi_2510_ = _e576;
                        } else {
                            phi_2695_ = _e562;
                            phi_890_ = type_46();
                            phi_893_ = bool();
                            phi_895_ = u32();
                            phi_897_ = u32();
                            phi_899_ = u32();
                            phi_2510_ = false;
                        }
                        let _e1406 = phi_2695_;
                        let _e1408 = phi_890_;
                        let _e1410 = phi_893_;
                        let _e1412 = phi_895_;
                        let _e1414 = phi_897_;
                        let _e1416 = phi_899_;
                        let _e1418 = phi_2510_;
                        continue;
                        continuing {
                            phi_2543_ = _e1406;
                            phi_889_ = _e1408;
                            phi_892_ = _e1410;
                            phi_894_ = _e1412;
                            phi_896_ = _e1414;
                            phi_898_ = _e1416;
                            phi_2694_ = _e1406;
                            break if !(_e1418);
                        }
                    }
                    let _e1421 = phi_2694_;
                    if _e1421 {
                        break;
                    }
                    let _e1423 = local_3;
                    if _e87 {
                    } else {
                        break;
                    }
                    global_5.member[_e81] = select(0u, 1u, _e1423.member_1);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_any(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
