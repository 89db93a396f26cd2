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
    var phi_2546_: bool;
    var phi_889_: type_46;
    var phi_892_: u32;
    var phi_894_: bool;
    var phi_896_: u32;
    var phi_898_: u32;
    var phi_909_: bool;
    var phi_941_: bool;
    var phi_942_: u32;
    var phi_943_: u32;
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
    var phi_2540_: bool;
    var phi_2732_: bool;
    var phi_2009_: type_46;
    var phi_2074_: type_42;
    var phi_2436_: u32;
    var phi_2463_: u32;
    var phi_2464_: u32;
    var phi_2465_: u32;
    var phi_2467_: u32;
    var phi_2468_: u32;
    var phi_2469_: bool;
    var phi_2478_: u32;
    var phi_2483_: bool;
    var phi_2485_: u32;
    var phi_2489_: bool;
    var phi_2490_: u32;
    var phi_2491_: u32;
    var phi_2501_: u32;
    var phi_2700_: bool;
    var phi_2503_: type_46;
    var phi_2504_: u32;
    var phi_2505_: bool;
    var phi_2506_: u32;
    var phi_2507_: u32;
    var phi_2699_: bool;
    var phi_2508_: type_46;
    var phi_2509_: u32;
    var phi_2510_: bool;
    var phi_2511_: u32;
    var phi_2512_: u32;
    var phi_2698_: bool;
    var phi_890_: type_46;
    var phi_893_: u32;
    var phi_895_: bool;
    var phi_897_: u32;
    var phi_899_: u32;
    var phi_2513_: bool;
    var phi_2697_: bool;
    var local_2: type_46;
    var local_3: type_46;

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
                    phi_2546_ = false;
                    phi_889_ = type_46(_e552, false);
                    phi_892_ = ((3u * _e71) + 1u);
                    phi_894_ = (_e554 <= _e552);
                    phi_896_ = 0u;
                    phi_898_ = select(0u, 2147483648u, (_e71 == 0u));
                    loop {
                        let _e562 = phi_2546_;
                        let _e564 = phi_889_;
                        let _e566 = phi_892_;
                        let _e568 = phi_894_;
                        let _e570 = phi_896_;
                        let _e572 = phi_898_;
                        local_2 = _e564;
                        if _e568 {
                            phi_909_ = true;
                        } else {
                            phi_909_ = (_e570 > 0u);
                        }
                        let _e575 = phi_909_;
                        if _e575 {
                            let _e576 = (_e566 > 0u);
                            if _e576 {
                                if _e568 {
                                    phi_941_ = _e568;
                                    phi_942_ = _e570;
                                    phi_943_ = _e572;
                                } else {
                                    let _e577 = (_e570 - 1u);
                                    let _e578 = (_e577 % 128u);
                                    let _e579 = (_e578 < 128u);
                                    if _e579 {
                                    } else {
                                        phi_2697_ = true;
                                        break;
                                    }
                                    let _e581 = local_1[_e578];
                                    if _e579 {
                                    } else {
                                        phi_2697_ = true;
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
                                    let _e594 = ((_e591 & 2147483648u) != 0u);
                                    if _e594 {
                                        phi_958_ = _e564;
                                        phi_961_ = type_7(0u, ((_e591 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e601 = phi_958_;
                                            let _e603 = phi_961_;
                                            local_3 = _e601;
                                            if (_e603.member < _e603.member_1) {
                                                phi_962_ = type_7((_e603.member + 1u), _e603.member_1);
                                                phi_984_ = type_7(1u, _e603.member);
                                            } else {
                                                phi_962_ = _e603;
                                                phi_984_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e616 = phi_962_;
                                            let _e618 = phi_984_;
                                            let _e622 = (bitcast<i32>(_e618.member) != 0i);
                                            if _e622 {
                                                let _e623 = ((_e591 & 268435455u) + _e618.member_1);
                                                let _e624 = (_e623 < _e73);
                                                if _e624 {
                                                    if _e624 {
                                                    } else {
                                                        phi_2540_ = true;
                                                        break;
                                                    }
                                                    let _e628 = global_3.member[_e623].member_1;
                                                    phi_1005_ = _e628;
                                                } else {
                                                    phi_1005_ = 4294967295u;
                                                }
                                                let _e630 = phi_1005_;
                                                if (_e623 >= _e73) {
                                                    phi_1097_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e624 {
                                                    } else {
                                                        phi_2540_ = true;
                                                        break;
                                                    }
                                                    let _e632 = (_e199 % 3u);
                                                    let _e633 = (_e198 % 3u);
                                                    let _e634 = (_e200 % 3u);
                                                    if (_e632 < 9u) {
                                                    } else {
                                                        phi_2540_ = true;
                                                        break;
                                                    }
                                                    let _e640 = global_3.member[_e623].member[_e632];
                                                    if (_e633 < 9u) {
                                                    } else {
                                                        phi_2540_ = true;
                                                        break;
                                                    }
                                                    let _e646 = global_3.member[_e623].member[_e633];
                                                    if (_e634 < 9u) {
                                                    } else {
                                                        phi_2540_ = true;
                                                        break;
                                                    }
                                                    let _e652 = global_3.member[_e623].member[_e634];
                                                    let _e654 = (3u + _e632);
                                                    if (_e654 < 9u) {
                                                    } else {
                                                        phi_2540_ = true;
                                                        break;
                                                    }
                                                    let _e660 = global_3.member[_e623].member[_e654];
                                                    let _e661 = (3u + _e633);
                                                    if (_e661 < 9u) {
                                                    } else {
                                                        phi_2540_ = true;
                                                        break;
                                                    }
                                                    let _e667 = global_3.member[_e623].member[_e661];
                                                    let _e668 = (3u + _e634);
                                                    if (_e668 < 9u) {
                                                    } else {
                                                        phi_2540_ = true;
                                                        break;
                                                    }
                                                    let _e674 = global_3.member[_e623].member[_e668];
                                                    let _e676 = (6u + _e632);
                                                    if (_e676 < 9u) {
                                                    } else {
                                                        phi_2540_ = true;
                                                        break;
                                                    }
                                                    let _e682 = global_3.member[_e623].member[_e676];
                                                    let _e683 = (6u + _e633);
                                                    if (_e683 < 9u) {
                                                    } else {
                                                        phi_2540_ = true;
                                                        break;
                                                    }
                                                    let _e689 = global_3.member[_e623].member[_e683];
                                                    let _e690 = (6u + _e634);
                                                    if (_e690 < 9u) {
                                                    } else {
                                                        phi_2540_ = true;
                                                        break;
                                                    }
                                                    let _e696 = global_3.member[_e623].member[_e690];
                                                    phi_1097_ = array<array<f32, 3>, 3>(array<f32, 3>(_e640, _e646, _e652), array<f32, 3>(_e660, _e667, _e674), array<f32, 3>(_e682, _e689, _e696));
                                                }
                                                let _e700 = phi_1097_;
                                                let _e708 = (_e700[0][2] - _e400);
                                                let _e711 = (((_e700[0][0] - _e263) * _e439) - (_e708 * _e303));
                                                let _e714 = (((_e700[0][1] - _e332) * _e439) - (_e708 * _e371));
                                                let _e721 = (_e700[1][2] - _e400);
                                                let _e724 = (((_e700[1][0] - _e263) * _e439) - (_e721 * _e303));
                                                let _e727 = (((_e700[1][1] - _e332) * _e439) - (_e721 * _e371));
                                                let _e734 = (_e700[2][2] - _e400);
                                                let _e737 = (((_e700[2][0] - _e263) * _e439) - (_e734 * _e303));
                                                let _e740 = (((_e700[2][1] - _e332) * _e439) - (_e734 * _e371));
                                                let _e741 = (_e737 * _e727);
                                                let _e742 = (_e740 * _e724);
                                                let _e743 = (_e711 * _e740);
                                                let _e744 = (_e714 * _e737);
                                                let _e745 = (_e724 * _e714);
                                                let _e746 = (_e727 * _e711);
                                                let _e751 = (((_e741 >= _e742) && (_e743 >= _e744)) && (_e745 >= _e746));
                                                if (_e751 || (((_e741 <= _e742) && (_e743 <= _e744)) && (_e745 <= _e746))) {
                                                    let _e758 = select(-1f, 1f, _e751);
                                                    let _e760 = ((_e741 - _e742) * _e758);
                                                    let _e762 = select(0f, _e760, (_e760 > 0f));
                                                    let _e764 = ((_e743 - _e744) * _e758);
                                                    let _e766 = select(0f, _e764, (_e764 > 0f));
                                                    let _e768 = ((_e745 - _e746) * _e758);
                                                    let _e770 = select(0f, _e768, (_e768 > 0f));
                                                    let _e772 = ((_e762 + _e766) + _e770);
                                                    if (_e772 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1981_ = type_26();
                                                        phi_1982_ = true;
                                                        phi_1983_ = false;
                                                    } else {
                                                        let _e775 = select(_e724, _e711, (_e711 < _e724));
                                                        if (select(_e737, _e775, (_e775 < _e737)) > 0f) {
                                                            phi_1249_ = true;
                                                        } else {
                                                            let _e780 = select(_e724, _e711, (_e711 > _e724));
                                                            phi_1249_ = (select(_e737, _e780, (_e780 > _e737)) < 0f);
                                                        }
                                                        let _e785 = phi_1249_;
                                                        if _e785 {
                                                            phi_1978_ = type_26();
                                                            phi_1979_ = true;
                                                            phi_1980_ = false;
                                                        } else {
                                                            let _e787 = select(_e727, _e714, (_e714 < _e727));
                                                            if (select(_e740, _e787, (_e787 < _e740)) > 0f) {
                                                                phi_1278_ = true;
                                                            } else {
                                                                let _e792 = select(_e727, _e714, (_e714 > _e727));
                                                                phi_1278_ = (select(_e740, _e792, (_e792 > _e740)) < 0f);
                                                            }
                                                            let _e797 = phi_1278_;
                                                            if _e797 {
                                                                phi_1976_ = type_26();
                                                                phi_1977_ = false;
                                                            } else {
                                                                let _e799 = select(_e700[1][0], _e700[0][0], (_e700[0][0] < _e700[1][0]));
                                                                let _e803 = select(_e700[1][0], _e700[0][0], (_e700[0][0] > _e700[1][0]));
                                                                let _e807 = select(_e700[1][1], _e700[0][1], (_e700[0][1] < _e700[1][1]));
                                                                let _e811 = select(_e700[1][1], _e700[0][1], (_e700[0][1] > _e700[1][1]));
                                                                let _e815 = select(_e700[1][2], _e700[0][2], (_e700[0][2] < _e700[1][2]));
                                                                let _e819 = select(_e700[1][2], _e700[0][2], (_e700[0][2] > _e700[1][2]));
                                                                let _e824 = ((select(_e700[2][0], _e799, (_e799 < _e700[2][0])) - _e301) * _e306);
                                                                let _e825 = ((select(_e700[2][0], _e803, (_e803 > _e700[2][0])) - _e302) * _e306);
                                                                let _e828 = ((select(_e700[2][1], _e807, (_e807 < _e700[2][1])) - _e369) * _e374);
                                                                let _e829 = ((select(_e700[2][1], _e811, (_e811 > _e700[2][1])) - _e370) * _e374);
                                                                let _e832 = ((select(_e700[2][2], _e815, (_e815 < _e700[2][2])) - _e437) * _e442);
                                                                let _e833 = ((select(_e700[2][2], _e819, (_e819 > _e700[2][2])) - _e438) * _e442);
                                                                let _e835 = select(_e833, _e832, (_e832 < _e833));
                                                                let _e837 = select(_e833, _e832, (_e832 > _e833));
                                                                let _e839 = select(_e825, _e824, (_e824 < _e825));
                                                                let _e841 = select(_e829, _e828, (_e828 < _e829));
                                                                let _e843 = select(_e841, _e839, (_e839 > _e841));
                                                                let _e845 = select(_e835, _e843, (_e843 > _e835));
                                                                let _e847 = select(_e825, _e824, (_e824 > _e825));
                                                                let _e849 = select(_e829, _e828, (_e828 > _e829));
                                                                let _e851 = select(_e849, _e847, (_e847 < _e849));
                                                                let _e853 = select(_e837, _e851, (_e851 < _e837));
                                                                let _e854 = -(_e835);
                                                                let _e860 = select(_e554, _e845, (_e845 > _e554));
                                                                if (_e860 > (_e853 + (select(_e854, _e837, (_e837 > _e854)) * 0.0000019073523f))) {
                                                                    phi_1971_ = type_26();
                                                                    phi_1972_ = true;
                                                                } else {
                                                                    let _e862 = (_e860 > _e601.member);
                                                                    if _e862 {
                                                                        phi_1970_ = type_26();
                                                                    } else {
                                                                        let _e863 = vec3<f32>(_e700[0][0], _e700[0][1], _e700[0][2]);
                                                                        let _e864 = vec3<f32>(_e700[1][0], _e700[1][1], _e700[1][2]);
                                                                        let _e865 = vec3<f32>(_e700[2][0], _e700[2][1], _e700[2][2]);
                                                                        let _e866 = (_e700[1][0] - _e700[0][0]);
                                                                        let _e867 = (_e700[1][1] - _e700[0][1]);
                                                                        let _e868 = (_e700[1][2] - _e700[0][2]);
                                                                        let _e869 = vec3<f32>(_e866, _e867, _e868);
                                                                        let _e870 = (_e700[2][0] - _e700[1][0]);
                                                                        let _e871 = (_e700[2][1] - _e700[1][1]);
                                                                        let _e872 = (_e700[2][2] - _e700[1][2]);
                                                                        let _e873 = vec3<f32>(_e870, _e871, _e872);
                                                                        let _e874 = (_e700[0][0] - _e700[2][0]);
                                                                        let _e875 = (_e700[0][1] - _e700[2][1]);
                                                                        let _e876 = (_e700[0][2] - _e700[2][2]);
                                                                        let _e877 = vec3<f32>(_e874, _e875, _e876);
                                                                        let _e880 = bitcast<f32>((bitcast<u32>(_e866) & 2147483647u));
                                                                        let _e883 = bitcast<f32>((bitcast<u32>(_e867) & 2147483647u));
                                                                        let _e885 = select(_e883, _e880, (_e880 > _e883));
                                                                        let _e888 = bitcast<f32>((bitcast<u32>(_e868) & 2147483647u));
                                                                        let _e890 = select(_e888, _e885, (_e885 > _e888));
                                                                        let _e893 = bitcast<f32>((bitcast<u32>(_e870) & 2147483647u));
                                                                        let _e896 = bitcast<f32>((bitcast<u32>(_e871) & 2147483647u));
                                                                        let _e898 = select(_e896, _e893, (_e893 > _e896));
                                                                        let _e901 = bitcast<f32>((bitcast<u32>(_e872) & 2147483647u));
                                                                        let _e903 = select(_e901, _e898, (_e898 > _e901));
                                                                        let _e906 = bitcast<f32>((bitcast<u32>(_e874) & 2147483647u));
                                                                        let _e909 = bitcast<f32>((bitcast<u32>(_e875) & 2147483647u));
                                                                        let _e911 = select(_e909, _e906, (_e906 > _e909));
                                                                        let _e914 = bitcast<f32>((bitcast<u32>(_e876) & 2147483647u));
                                                                        let _e916 = select(_e914, _e911, (_e911 > _e914));
                                                                        let _e918 = select(_e903, _e890, (_e890 > _e903));
                                                                        let _e920 = select(_e916, _e918, (_e918 > _e916));
                                                                        if (_e890 == _e920) {
                                                                            phi_1697_ = _e727;
                                                                            phi_1698_ = _e724;
                                                                            phi_1699_ = _e714;
                                                                            phi_1700_ = _e711;
                                                                            phi_1701_ = _e863;
                                                                            phi_1702_ = _e877;
                                                                            phi_1703_ = _e873;
                                                                            phi_1704_ = _e869;
                                                                        } else {
                                                                            let _e922 = (_e903 == _e920);
                                                                            let _e927 = vec3(_e922);
                                                                            phi_1697_ = select(_e714, _e740, _e922);
                                                                            phi_1698_ = select(_e711, _e737, _e922);
                                                                            phi_1699_ = select(_e740, _e727, _e922);
                                                                            phi_1700_ = select(_e737, _e724, _e922);
                                                                            phi_1701_ = select(_e865, _e864, _e927);
                                                                            phi_1702_ = select(_e873, _e869, _e927);
                                                                            phi_1703_ = select(_e869, _e877, _e927);
                                                                            phi_1704_ = select(_e877, _e873, _e927);
                                                                        }
                                                                        let _e933 = phi_1697_;
                                                                        let _e935 = phi_1698_;
                                                                        let _e937 = phi_1699_;
                                                                        let _e939 = phi_1700_;
                                                                        let _e941 = phi_1701_;
                                                                        let _e943 = phi_1702_;
                                                                        let _e945 = phi_1703_;
                                                                        let _e947 = phi_1704_;
                                                                        let _e954 = ((_e945.y * _e943.z) - (_e943.y * _e945.z));
                                                                        let _e959 = ((_e945.z * _e943.x) - (_e943.z * _e945.x));
                                                                        let _e962 = ((_e945.x * _e943.y) - (_e943.x * _e945.y));
                                                                        if (_e762 >= _e766) {
                                                                            phi_1741_ = select(true, false, (_e762 >= _e770));
                                                                        } else {
                                                                            phi_1741_ = true;
                                                                        }
                                                                        let _e967 = phi_1741_;
                                                                        if _e967 {
                                                                            phi_1750_ = select(_e865, _e864, vec3((_e766 >= _e770)));
                                                                        } else {
                                                                            phi_1750_ = _e863;
                                                                        }
                                                                        let _e972 = phi_1750_;
                                                                        let _e983 = (((_e954 * (_e972.x - _e263)) + (_e959 * (_e972.y - _e332))) + (_e962 * (_e972.z - _e400)));
                                                                        let _e988 = (((_e954 * _e303) + (_e959 * _e371)) + (_e962 * _e439));
                                                                        let _e989 = (_e935 - _e939);
                                                                        let _e990 = (_e933 - _e937);
                                                                        let _e998 = (-(((_e939 * _e989) + (_e937 * _e990))) / ((_e989 * _e989) + (_e990 * _e990)));
                                                                        let _e1000 = select(1f, _e998, (_e998 < 1f));
                                                                        let _e1002 = select(0f, _e1000, (_e1000 > 0f));
                                                                        let _e1015 = ((_e941.x + (_e947.x * _e1002)) - _e263);
                                                                        let _e1016 = ((_e941.y + (_e947.y * _e1002)) - _e332);
                                                                        let _e1017 = ((_e941.z + (_e947.z * _e1002)) - _e400);
                                                                        let _e1018 = (_e1017 / _e439);
                                                                        let _e1030 = bitcast<f32>((bitcast<u32>(_e1015) & 2147483647u));
                                                                        let _e1033 = bitcast<f32>((bitcast<u32>(_e1016) & 2147483647u));
                                                                        let _e1035 = select(_e1033, _e1030, (_e1030 > _e1033));
                                                                        let _e1038 = bitcast<f32>((bitcast<u32>(_e1017) & 2147483647u));
                                                                        let _e1040 = select(_e1038, _e1035, (_e1035 > _e1038));
                                                                        let _e1046 = bitcast<f32>((bitcast<u32>(_e954) & 2147483647u));
                                                                        let _e1049 = bitcast<f32>((bitcast<u32>(_e959) & 2147483647u));
                                                                        let _e1051 = select(_e1049, _e1046, (_e1046 > _e1049));
                                                                        let _e1054 = bitcast<f32>((bitcast<u32>(_e962) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e954 * _e1015) + (_e959 * _e1016)) + (_e962 * _e1017)) - _e983)) & 2147483647u)) <= ((0.0000009536743f * select(_e920, _e1040, (_e1040 > _e920))) * select(_e1054, _e1051, (_e1051 > _e1054)))) {
                                                                            let _e1064 = bitcast<f32>((bitcast<u32>(_e945.x) & 2147483647u));
                                                                            let _e1067 = bitcast<f32>((bitcast<u32>(_e945.y) & 2147483647u));
                                                                            let _e1069 = select(_e1067, _e1064, (_e1064 > _e1067));
                                                                            let _e1072 = bitcast<f32>((bitcast<u32>(_e945.z) & 2147483647u));
                                                                            let _e1078 = bitcast<f32>((bitcast<u32>(_e943.x) & 2147483647u));
                                                                            let _e1081 = bitcast<f32>((bitcast<u32>(_e943.y) & 2147483647u));
                                                                            let _e1083 = select(_e1081, _e1078, (_e1078 > _e1081));
                                                                            let _e1086 = bitcast<f32>((bitcast<u32>(_e943.z) & 2147483647u));
                                                                            let _e1090 = (bitcast<f32>((bitcast<u32>(_e988) & 2147483647u)) > ((0.0000038146973f * select(_e1072, _e1069, (_e1069 > _e1072))) * select(_e1086, _e1083, (_e1083 > _e1086))));
                                                                            if _e1090 {
                                                                                phi_1915_ = (_e983 / _e988);
                                                                            } else {
                                                                                phi_1915_ = f32();
                                                                            }
                                                                            let _e1093 = phi_1915_;
                                                                            phi_1917_ = _e1093;
                                                                            phi_1918_ = select(true, false, _e1090);
                                                                        } else {
                                                                            phi_1917_ = f32();
                                                                            phi_1918_ = true;
                                                                        }
                                                                        let _e1096 = phi_1917_;
                                                                        let _e1098 = phi_1918_;
                                                                        if _e1098 {
                                                                            let _e1106 = (((_e954 * (_e1015 - (_e303 * _e1018))) + (_e959 * (_e1016 - (_e371 * _e1018)))) / _e988);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1106) & 2147483647u)) <= _e920) {
                                                                                phi_1938_ = (_e1018 + _e1106);
                                                                            } else {
                                                                                phi_1938_ = _e1018;
                                                                            }
                                                                            let _e1113 = phi_1938_;
                                                                            phi_1939_ = _e1113;
                                                                        } else {
                                                                            phi_1939_ = _e1096;
                                                                        }
                                                                        let _e1115 = phi_1939_;
                                                                        let _e1117 = select(_e853, _e1115, (_e1115 < _e853));
                                                                        let _e1119 = select(_e845, _e1117, (_e1117 > _e845));
                                                                        if (_e1119 >= _e554) {
                                                                            let _e1121 = (_e1119 <= _e601.member);
                                                                            if _e1121 {
                                                                                let _e1122 = (1f / _e772);
                                                                                phi_1962_ = type_26(_e1119, (_e766 * _e1122), (_e770 * _e1122), _e630);
                                                                            } else {
                                                                                phi_1962_ = type_26();
                                                                            }
                                                                            let _e1127 = phi_1962_;
                                                                            phi_1964_ = _e1127;
                                                                            phi_1965_ = select(true, false, _e1121);
                                                                        } else {
                                                                            phi_1964_ = type_26();
                                                                            phi_1965_ = true;
                                                                        }
                                                                        let _e1130 = phi_1964_;
                                                                        let _e1132 = phi_1965_;
                                                                        if _e1132 {
                                                                            phi_1969_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1969_ = _e1130;
                                                                        }
                                                                        let _e1134 = phi_1969_;
                                                                        phi_1970_ = _e1134;
                                                                    }
                                                                    let _e1136 = phi_1970_;
                                                                    phi_1971_ = _e1136;
                                                                    phi_1972_ = _e862;
                                                                }
                                                                let _e1138 = phi_1971_;
                                                                let _e1140 = phi_1972_;
                                                                phi_1976_ = _e1138;
                                                                phi_1977_ = _e1140;
                                                            }
                                                            let _e1142 = phi_1976_;
                                                            let _e1144 = phi_1977_;
                                                            phi_1978_ = _e1142;
                                                            phi_1979_ = _e797;
                                                            phi_1980_ = _e1144;
                                                        }
                                                        let _e1146 = phi_1978_;
                                                        let _e1148 = phi_1979_;
                                                        let _e1150 = phi_1980_;
                                                        phi_1981_ = _e1146;
                                                        phi_1982_ = _e1148;
                                                        phi_1983_ = _e1150;
                                                    }
                                                    let _e1152 = phi_1981_;
                                                    let _e1154 = phi_1982_;
                                                    let _e1156 = phi_1983_;
                                                    phi_1991_ = _e1152;
                                                    phi_1992_ = select(_e1156, true, _e1154);
                                                } else {
                                                    phi_1991_ = type_26();
                                                    phi_1992_ = true;
                                                }
                                                let _e1159 = phi_1991_;
                                                let _e1161 = phi_1992_;
                                                if _e1161 {
                                                    phi_1996_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1996_ = _e1159;
                                                }
                                                let _e1163 = phi_1996_;
                                                if (_e1163.member_3 != 4294967295u) {
                                                    if (_e630 != 4294967295u) {
                                                        phi_2007_ = type_46(_e601.member, true);
                                                    } else {
                                                        phi_2007_ = _e601;
                                                    }
                                                    let _e1171 = phi_2007_;
                                                    phi_2008_ = _e1171;
                                                } else {
                                                    phi_2008_ = _e601;
                                                }
                                                let _e1173 = phi_2008_;
                                                phi_959_ = _e1173;
                                            } else {
                                                phi_959_ = type_46();
                                            }
                                            let _e1175 = phi_959_;
                                            continue;
                                            continuing {
                                                phi_958_ = _e1175;
                                                phi_961_ = _e616;
                                                phi_2540_ = _e562;
                                                break if !(_e622);
                                            }
                                        }
                                        let _e1178 = phi_2540_;
                                        phi_2697_ = _e1178;
                                        if _e1178 {
                                            break;
                                        }
                                        phi_2732_ = _e1178;
                                        let _e1522 = local_3;
                                        phi_2009_ = _e1522;
                                    } else {
                                        phi_2732_ = _e562;
                                        phi_2009_ = _e564;
                                    }
                                    let _e1180 = phi_2732_;
                                    let _e1182 = phi_2009_;
                                    if _e594 {
                                        phi_2489_ = bool();
                                        phi_2490_ = u32();
                                        phi_2491_ = u32();
                                    } else {
                                        if (_e591 >= _e71) {
                                            phi_2074_ = type_42(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e591 < _e71) {
                                            } else {
                                                phi_2697_ = true;
                                                break;
                                            }
                                            let _e1185 = (_e199 % 3u);
                                            if (_e1185 < 3u) {
                                            } else {
                                                phi_2697_ = true;
                                                break;
                                            }
                                            let _e1191 = global_2.member[_e591].member[_e1185];
                                            let _e1197 = (_e198 % 3u);
                                            if (_e1197 < 3u) {
                                            } else {
                                                phi_2697_ = true;
                                                break;
                                            }
                                            let _e1203 = global_2.member[_e591].member[_e1197];
                                            let _e1209 = (_e200 % 3u);
                                            if (_e1209 < 3u) {
                                            } else {
                                                phi_2697_ = true;
                                                break;
                                            }
                                            let _e1215 = global_2.member[_e591].member[_e1209];
                                            let _e1225 = global_2.member[_e591].member_1;
                                            let _e1229 = global_2.member[_e591].member_2;
                                            phi_2074_ = type_42(array<vec4<f32>, 3>(vec4<f32>(_e1191[0], _e1191[1], _e1191[2], _e1191[3]), vec4<f32>(_e1203[0], _e1203[1], _e1203[2], _e1203[3]), vec4<f32>(_e1215[0], _e1215[1], _e1215[2], _e1215[3])), _e1225, _e1229);
                                        }
                                        let _e1232 = phi_2074_;
                                        let _e1244 = ((_e1232.member[0].x - _e301) * _e306);
                                        let _e1245 = ((_e1232.member[0].y - _e301) * _e306);
                                        let _e1246 = ((_e1232.member[0].z - _e302) * _e306);
                                        let _e1247 = ((_e1232.member[0].w - _e302) * _e306);
                                        let _e1257 = ((_e1232.member[1].x - _e369) * _e374);
                                        let _e1258 = ((_e1232.member[1].y - _e369) * _e374);
                                        let _e1259 = ((_e1232.member[1].z - _e370) * _e374);
                                        let _e1260 = ((_e1232.member[1].w - _e370) * _e374);
                                        let _e1270 = ((_e1232.member[2].x - _e437) * _e442);
                                        let _e1271 = ((_e1232.member[2].y - _e437) * _e442);
                                        let _e1272 = ((_e1232.member[2].z - _e438) * _e442);
                                        let _e1273 = ((_e1232.member[2].w - _e438) * _e442);
                                        let _e1275 = select(_e1272, _e1270, (_e1270 < _e1272));
                                        let _e1277 = select(_e1273, _e1271, (_e1271 < _e1273));
                                        let _e1279 = select(_e1272, _e1270, (_e1270 > _e1272));
                                        let _e1281 = select(_e1273, _e1271, (_e1271 > _e1273));
                                        let _e1283 = select(_e1246, _e1244, (_e1244 < _e1246));
                                        let _e1285 = select(_e1247, _e1245, (_e1245 < _e1247));
                                        let _e1287 = select(_e1259, _e1257, (_e1257 < _e1259));
                                        let _e1289 = select(_e1260, _e1258, (_e1258 < _e1260));
                                        let _e1291 = select(_e1287, _e1283, (_e1283 > _e1287));
                                        let _e1293 = select(_e1289, _e1285, (_e1285 > _e1289));
                                        let _e1295 = select(_e1275, _e1291, (_e1291 > _e1275));
                                        let _e1297 = select(_e1277, _e1293, (_e1293 > _e1277));
                                        let _e1299 = select(_e1246, _e1244, (_e1244 > _e1246));
                                        let _e1301 = select(_e1247, _e1245, (_e1245 > _e1247));
                                        let _e1303 = select(_e1259, _e1257, (_e1257 > _e1259));
                                        let _e1305 = select(_e1260, _e1258, (_e1258 > _e1260));
                                        let _e1307 = select(_e1303, _e1299, (_e1299 < _e1303));
                                        let _e1309 = select(_e1305, _e1301, (_e1301 < _e1305));
                                        let _e1314 = -(_e1275);
                                        let _e1315 = -(_e1277);
                                        let _e1322 = (select(_e1279, _e1307, (_e1307 < _e1279)) + (select(_e1314, _e1279, (_e1279 > _e1314)) * 0.0000019073523f));
                                        let _e1323 = (select(_e1281, _e1309, (_e1309 < _e1281)) + (select(_e1315, _e1281, (_e1281 > _e1315)) * 0.0000019073523f));
                                        let _e1325 = select(_e554, _e1295, (_e1295 > _e554));
                                        let _e1327 = select(_e554, _e1297, (_e1297 > _e554));
                                        let _e1332 = (_e1325 <= select(_e1182.member, _e1322, (_e1322 < _e1182.member)));
                                        let _e1333 = (_e1327 <= select(_e1182.member, _e1323, (_e1323 < _e1182.member)));
                                        let _e1334 = (_e1325 <= _e1327);
                                        if _e1332 {
                                            if _e1333 {
                                                if _e1334 {
                                                    phi_2436_ = _e1232.member_2;
                                                } else {
                                                    phi_2436_ = _e1232.member_1;
                                                }
                                                let _e1338 = phi_2436_;
                                                let _e1340 = (_e589 % 128u);
                                                let _e1341 = (_e1340 < 128u);
                                                if _e1341 {
                                                } else {
                                                    phi_2697_ = true;
                                                    break;
                                                }
                                                local_1[_e1340] = _e1338;
                                                if _e1341 {
                                                } else {
                                                    phi_2697_ = true;
                                                    break;
                                                }
                                                local[_e1340] = select(_e1325, _e1327, _e1334);
                                                if _e1334 {
                                                    phi_2463_ = _e1232.member_1;
                                                } else {
                                                    phi_2463_ = _e1232.member_2;
                                                }
                                                let _e1348 = phi_2463_;
                                                phi_2464_ = (_e589 + 1u);
                                                phi_2465_ = _e1348;
                                            } else {
                                                phi_2464_ = u32();
                                                phi_2465_ = u32();
                                            }
                                            let _e1350 = phi_2464_;
                                            let _e1352 = phi_2465_;
                                            phi_2467_ = _e1350;
                                            phi_2468_ = _e1352;
                                            phi_2469_ = select(true, false, _e1333);
                                        } else {
                                            phi_2467_ = u32();
                                            phi_2468_ = u32();
                                            phi_2469_ = true;
                                        }
                                        let _e1355 = phi_2467_;
                                        let _e1357 = phi_2468_;
                                        let _e1359 = phi_2469_;
                                        if _e1359 {
                                            if _e1332 {
                                                phi_2478_ = _e1232.member_1;
                                            } else {
                                                phi_2478_ = _e1232.member_2;
                                            }
                                            let _e1363 = phi_2478_;
                                            phi_2483_ = select(_e1333, true, _e1332);
                                            phi_2485_ = _e1363;
                                        } else {
                                            phi_2483_ = _e587;
                                            phi_2485_ = _e1357;
                                        }
                                        let _e1366 = phi_2483_;
                                        let _e1368 = phi_2485_;
                                        phi_2489_ = _e1366;
                                        phi_2490_ = select(_e1355, _e589, _e1359);
                                        phi_2491_ = _e1368;
                                    }
                                    let _e1371 = phi_2489_;
                                    let _e1373 = phi_2490_;
                                    let _e1375 = phi_2491_;
                                    if _e594 {
                                        phi_2501_ = select(_e589, 0u, _e1182.member_1);
                                    } else {
                                        phi_2501_ = _e1373;
                                    }
                                    let _e1379 = phi_2501_;
                                    phi_2700_ = _e1180;
                                    phi_2503_ = _e1182;
                                    phi_2504_ = (_e566 - 1u);
                                    phi_2505_ = select(_e1371, false, _e594);
                                    phi_2506_ = _e1379;
                                    phi_2507_ = select(_e1375, _e591, _e594);
                                } else {
                                    phi_2700_ = _e562;
                                    phi_2503_ = _e564;
                                    phi_2504_ = _e566;
                                    phi_2505_ = _e587;
                                    phi_2506_ = _e589;
                                    phi_2507_ = _e591;
                                }
                                let _e1383 = phi_2700_;
                                let _e1385 = phi_2503_;
                                let _e1387 = phi_2504_;
                                let _e1389 = phi_2505_;
                                let _e1391 = phi_2506_;
                                let _e1393 = phi_2507_;
                                phi_2699_ = _e1383;
                                phi_2508_ = _e1385;
                                phi_2509_ = _e1387;
                                phi_2510_ = _e1389;
                                phi_2511_ = _e1391;
                                phi_2512_ = _e1393;
                            } else {
                                phi_2699_ = _e562;
                                phi_2508_ = type_46();
                                phi_2509_ = u32();
                                phi_2510_ = bool();
                                phi_2511_ = u32();
                                phi_2512_ = u32();
                            }
                            let _e1395 = phi_2699_;
                            let _e1397 = phi_2508_;
                            let _e1399 = phi_2509_;
                            let _e1401 = phi_2510_;
                            let _e1403 = phi_2511_;
                            let _e1405 = phi_2512_;
                            phi_2698_ = _e1395;
                            phi_890_ = _e1397;
                            phi_893_ = _e1399;
                            phi_895_ = _e1401;
                            phi_897_ = _e1403;
                            phi_899_ = _e1405;
                            phi_2513_ = _e576;
                        } else {
                            phi_2698_ = _e562;
                            phi_890_ = type_46();
                            phi_893_ = u32();
                            phi_895_ = bool();
                            phi_897_ = u32();
                            phi_899_ = u32();
                            phi_2513_ = false;
                        }
                        let _e1407 = phi_2698_;
                        let _e1409 = phi_890_;
                        let _e1411 = phi_893_;
                        let _e1413 = phi_895_;
                        let _e1415 = phi_897_;
                        let _e1417 = phi_899_;
                        let _e1419 = phi_2513_;
                        continue;
                        continuing {
                            phi_2546_ = _e1407;
                            phi_889_ = _e1409;
                            phi_892_ = _e1411;
                            phi_894_ = _e1413;
                            phi_896_ = _e1415;
                            phi_898_ = _e1417;
                            phi_2697_ = _e1407;
                            break if !(_e1419);
                        }
                    }
                    let _e1422 = phi_2697_;
                    if _e1422 {
                        break;
                    }
                    let _e1424 = local_2;
                    if _e87 {
                    } else {
                        break;
                    }
                    global_5.member[_e81] = select(0u, 1u, _e1424.member_1);
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
