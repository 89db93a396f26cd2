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

struct type_23 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_24 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_27 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_29 {
    member: array<type_27>,
}

struct type_39 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_41 {
    member: array<type_24>,
}

struct type_45 {
    member: array<array<type_23, 8>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(1) 
var<storage> global_2: type_29;
@group(0) @binding(2) 
var<storage> global_3: type_15;
@group(0) @binding(3) 
var<storage> global_4: type_41;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_45;

fn function_() {
    var local: array<type_23, 8>;
    var local_1: array<f32, 128>;
    var local_2: array<u32, 128>;
    var phi_282_: i32;
    var phi_283_: i32;
    var phi_293_: bool;
    var phi_303_: u32;
    var phi_304_: u32;
    var phi_306_: bool;
    var phi_311_: u32;
    var phi_323_: i32;
    var phi_343_: i32;
    var phi_361_: f32;
    var phi_367_: f32;
    var phi_378_: f32;
    var phi_384_: f32;
    var phi_407_: f32;
    var phi_418_: f32;
    var phi_427_: f32;
    var phi_433_: f32;
    var phi_444_: f32;
    var phi_450_: f32;
    var phi_473_: f32;
    var phi_484_: f32;
    var phi_493_: f32;
    var phi_499_: f32;
    var phi_510_: f32;
    var phi_516_: f32;
    var phi_539_: f32;
    var phi_550_: f32;
    var phi_650_: f32;
    var phi_651_: f32;
    var phi_2543_: bool;
    var phi_2523_: f32;
    var phi_715_: u32;
    var phi_718_: u32;
    var phi_720_: bool;
    var phi_722_: u32;
    var phi_733_: bool;
    var phi_766_: u32;
    var phi_767_: bool;
    var phi_768_: u32;
    var phi_1921_: type_39;
    var phi_2266_: u32;
    var phi_2294_: u32;
    var phi_2295_: u32;
    var phi_2296_: u32;
    var phi_2298_: u32;
    var phi_2299_: u32;
    var phi_2300_: bool;
    var phi_2309_: u32;
    var phi_2314_: u32;
    var phi_2315_: bool;
    var phi_2540_: bool;
    var phi_2530_: f32;
    var phi_783_: type_4;
    var phi_784_: type_4;
    var phi_807_: type_4;
    var phi_828_: u32;
    var phi_917_: array<array<f32, 3>, 3>;
    var phi_1035_: bool;
    var phi_1064_: bool;
    var phi_1465_: f32;
    var phi_1466_: f32;
    var phi_1467_: f32;
    var phi_1468_: f32;
    var phi_1469_: vec3<f32>;
    var phi_1470_: vec3<f32>;
    var phi_1471_: vec3<f32>;
    var phi_1472_: vec3<f32>;
    var phi_1503_: bool;
    var phi_1512_: vec3<f32>;
    var phi_1677_: f32;
    var phi_1679_: f32;
    var phi_1680_: bool;
    var phi_1700_: f32;
    var phi_1701_: f32;
    var phi_1724_: type_23;
    var phi_1726_: type_23;
    var phi_1727_: bool;
    var phi_1731_: type_23;
    var phi_1732_: type_23;
    var phi_1733_: type_23;
    var phi_1734_: bool;
    var phi_1738_: type_23;
    var phi_1739_: bool;
    var phi_1740_: type_23;
    var phi_1741_: bool;
    var phi_1742_: bool;
    var phi_1743_: type_23;
    var phi_1744_: bool;
    var phi_1745_: bool;
    var phi_1753_: type_23;
    var phi_1754_: bool;
    var phi_1758_: type_23;
    var phi_1770_: type_4;
    var phi_1773_: type_23;
    var phi_1771_: type_4;
    var phi_1796_: type_4;
    var phi_1828_: bool;
    var phi_1829_: bool;
    var phi_1850_: type_23;
    var phi_1774_: type_23;
    var phi_2531_: bool;
    var phi_2854_: f32;
    var phi_2853_: f32;
    var phi_2676_: bool;
    var phi_2852_: f32;
    var phi_2675_: bool;
    var phi_2851_: f32;
    var phi_2674_: bool;
    var phi_2763_: f32;
    var phi_2673_: bool;
    var phi_2728_: f32;
    var phi_2682_: bool;
    var phi_2317_: u32;
    var phi_2318_: bool;
    var phi_2319_: u32;
    var phi_2727_: f32;
    var phi_2681_: bool;
    var phi_2320_: u32;
    var phi_2321_: u32;
    var phi_2322_: bool;
    var phi_2323_: u32;
    var phi_2726_: f32;
    var phi_2680_: bool;
    var phi_2324_: u32;
    var phi_2325_: u32;
    var phi_2326_: bool;
    var phi_2327_: u32;
    var phi_2725_: f32;
    var phi_2679_: bool;
    var phi_716_: u32;
    var phi_719_: u32;
    var phi_721_: bool;
    var phi_723_: u32;
    var phi_2328_: bool;
    var phi_2678_: bool;
    var phi_2335_: type_4;
    var phi_2336_: type_4;
    var phi_2359_: type_4;
    var phi_2425_: type_23;
    var phi_2718_: bool;

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
                    let _e148 = (bitcast<u32>(_e146) & 2147483647u);
                    let _e155 = global_4.member[_e81].member_3;
                    let _e161 = (((select(_e148, _e142, (_e148 < _e142)) < 2139095040u) && ((bitcast<u32>(_e155) & 2147483647u) <= 2139095040u)) && (_e136 > 0u));
                    if _e161 {
                        let _e164 = (bitcast<u32>(bitcast<f32>(_e136)) & 2147483647u);
                        if (_e164 >= 8388608u) {
                            phi_282_ = (bitcast<i32>((_e164 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_282_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e164)), 32u, (_e164 == 0u))));
                        }
                        let _e178 = phi_282_;
                        phi_283_ = _e178;
                    } else {
                        phi_283_ = 0i;
                    }
                    let _e180 = phi_283_;
                    let _e181 = (_e97 == _e136);
                    if _e181 {
                        phi_293_ = true;
                    } else {
                        phi_293_ = (_e104 == _e136);
                    }
                    let _e184 = phi_293_;
                    let _e185 = select(1u, 0u, _e181);
                    if _e184 {
                        let _e186 = (_e185 + 1u);
                        phi_303_ = _e186;
                        phi_304_ = _e186;
                        phi_306_ = select(true, false, (_e186 == 2u));
                    } else {
                        phi_303_ = u32();
                        phi_304_ = 0u;
                        phi_306_ = true;
                    }
                    let _e190 = phi_303_;
                    let _e192 = phi_304_;
                    let _e194 = phi_306_;
                    if _e194 {
                        phi_311_ = (_e192 + 1u);
                    } else {
                        phi_311_ = 0u;
                    }
                    let _e198 = phi_311_;
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
                    let _e248 = ((_e246 * _e210) * _e216);
                    let _e249 = global_4.member[_e81].member_2;
                    if _e238 {
                        phi_378_ = _e249[0];
                    } else {
                        phi_378_ = _e249[1];
                    }
                    let _e253 = phi_378_;
                    if _e243 {
                        phi_384_ = _e249[2];
                    } else {
                        phi_384_ = _e253;
                    }
                    let _e256 = phi_384_;
                    let _e258 = ((_e256 * _e227) * _e233);
                    let _e262 = (bitcast<f32>((bitcast<u32>(_e258) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e262 {
                        let _e266 = (bitcast<f32>((bitcast<u32>(_e248) & 2147483647u)) * 0.00000011920929f);
                        phi_407_ = select(0.00000000000011368684f, _e266, (_e266 > 0.00000000000011368684f));
                    } else {
                        phi_407_ = 0f;
                    }
                    let _e270 = phi_407_;
                    let _e271 = (_e248 + _e270);
                    let _e272 = (_e248 - _e270);
                    let _e273 = select(_e258, 0f, _e262);
                    if _e262 {
                        phi_418_ = 38685626000000000000000000f;
                    } else {
                        phi_418_ = (1f / _e258);
                    }
                    let _e276 = phi_418_;
                    let _e277 = (_e198 == 0u);
                    if _e277 {
                        phi_427_ = _e237[0];
                    } else {
                        phi_427_ = _e237[1];
                    }
                    let _e281 = phi_427_;
                    let _e282 = (_e198 == 2u);
                    if _e282 {
                        phi_433_ = _e237[2];
                    } else {
                        phi_433_ = _e281;
                    }
                    let _e285 = phi_433_;
                    let _e287 = ((_e285 * _e210) * _e216);
                    if _e277 {
                        phi_444_ = _e249[0];
                    } else {
                        phi_444_ = _e249[1];
                    }
                    let _e291 = phi_444_;
                    if _e282 {
                        phi_450_ = _e249[2];
                    } else {
                        phi_450_ = _e291;
                    }
                    let _e294 = phi_450_;
                    let _e296 = ((_e294 * _e227) * _e233);
                    let _e300 = (bitcast<f32>((bitcast<u32>(_e296) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e300 {
                        let _e304 = (bitcast<f32>((bitcast<u32>(_e287) & 2147483647u)) * 0.00000011920929f);
                        phi_473_ = select(0.00000000000011368684f, _e304, (_e304 > 0.00000000000011368684f));
                    } else {
                        phi_473_ = 0f;
                    }
                    let _e308 = phi_473_;
                    let _e309 = (_e287 + _e308);
                    let _e310 = (_e287 - _e308);
                    let _e311 = select(_e296, 0f, _e300);
                    if _e300 {
                        phi_484_ = 38685626000000000000000000f;
                    } else {
                        phi_484_ = (1f / _e296);
                    }
                    let _e314 = phi_484_;
                    let _e315 = (_e200 == 0u);
                    if _e315 {
                        phi_493_ = _e237[0];
                    } else {
                        phi_493_ = _e237[1];
                    }
                    let _e319 = phi_493_;
                    let _e320 = (_e200 == 2u);
                    if _e320 {
                        phi_499_ = _e237[2];
                    } else {
                        phi_499_ = _e319;
                    }
                    let _e323 = phi_499_;
                    let _e325 = ((_e323 * _e210) * _e216);
                    if _e315 {
                        phi_510_ = _e249[0];
                    } else {
                        phi_510_ = _e249[1];
                    }
                    let _e329 = phi_510_;
                    if _e320 {
                        phi_516_ = _e249[2];
                    } else {
                        phi_516_ = _e329;
                    }
                    let _e332 = phi_516_;
                    let _e334 = ((_e332 * _e227) * _e233);
                    let _e338 = (bitcast<f32>((bitcast<u32>(_e334) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e338 {
                        let _e342 = (bitcast<f32>((bitcast<u32>(_e325) & 2147483647u)) * 0.00000011920929f);
                        phi_539_ = select(0.00000000000011368684f, _e342, (_e342 > 0.00000000000011368684f));
                    } else {
                        phi_539_ = 0f;
                    }
                    let _e346 = phi_539_;
                    let _e347 = (_e325 + _e346);
                    let _e348 = (_e325 - _e346);
                    let _e349 = select(_e334, 0f, _e338);
                    if _e338 {
                        phi_550_ = 38685626000000000000000000f;
                    } else {
                        phi_550_ = (1f / _e334);
                    }
                    let _e352 = phi_550_;
                    let _e355 = bitcast<f32>((bitcast<u32>(_e248) & 2147483647u));
                    let _e358 = bitcast<f32>((bitcast<u32>(_e287) & 2147483647u));
                    let _e360 = select(_e358, _e355, (_e355 > _e358));
                    let _e363 = bitcast<f32>((bitcast<u32>(_e325) & 2147483647u));
                    let _e366 = (_e85 + _e180);
                    if (_e161 && (select(_e363, _e360, (_e360 > _e363)) <= 1099511600000f)) {
                        let _e369 = (_e366 / 3i);
                        let _e376 = bitcast<f32>((bitcast<u32>((_e369 + 127i)) << bitcast<u32>(23i)));
                        let _e383 = bitcast<f32>((bitcast<u32>(((_e366 - (2i * _e369)) + 127i)) << bitcast<u32>(23i)));
                        let _e384 = (((_e146 * _e376) * _e376) * _e383);
                        let _e386 = select(340282350000000000000000000000000000000f, _e384, (_e384 < 340282350000000000000000000000000000000f));
                        let _e391 = (((_e155 * _e376) * _e376) * _e383);
                        let _e393 = select(340282350000000000000000000000000000000f, _e391, (_e391 < 340282350000000000000000000000000000000f));
                        phi_650_ = select(-340282350000000000000000000000000000000f, _e393, (_e393 > -340282350000000000000000000000000000000f));
                        phi_651_ = select(-340282350000000000000000000000000000000f, _e386, (_e386 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_650_ = 0f;
                        phi_651_ = 1f;
                    }
                    let _e397 = phi_650_;
                    let _e399 = phi_651_;
                    local = array<type_23, 8>(type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_2 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2543_ = false;
                    phi_2523_ = _e397;
                    phi_715_ = select(0u, 2147483648u, (_e71 == 0u));
                    phi_718_ = ((3u * _e71) + 1u);
                    phi_720_ = (_e399 <= _e397);
                    phi_722_ = 0u;
                    loop {
                        let _e406 = phi_2543_;
                        let _e408 = phi_2523_;
                        let _e410 = phi_715_;
                        let _e412 = phi_718_;
                        let _e414 = phi_720_;
                        let _e416 = phi_722_;
                        if _e414 {
                            phi_733_ = true;
                        } else {
                            phi_733_ = (_e416 > 0u);
                        }
                        let _e419 = phi_733_;
                        if _e419 {
                            let _e420 = (_e412 > 0u);
                            if _e420 {
                                if _e414 {
                                    phi_766_ = _e410;
                                    phi_767_ = _e414;
                                    phi_768_ = _e416;
                                } else {
                                    let _e421 = (_e416 - 1u);
                                    let _e422 = (_e421 % 128u);
                                    let _e423 = (_e422 < 128u);
                                    if _e423 {
                                    } else {
                                        phi_2678_ = true;
                                        break;
                                    }
                                    let _e425 = local_2[_e422];
                                    if _e423 {
                                    } else {
                                        phi_2678_ = true;
                                        break;
                                    }
                                    let _e427 = local_1[_e422];
                                    phi_766_ = _e425;
                                    phi_767_ = (_e427 <= _e408);
                                    phi_768_ = _e421;
                                }
                                let _e430 = phi_766_;
                                let _e432 = phi_767_;
                                let _e434 = phi_768_;
                                if _e432 {
                                    if ((_e430 & 2147483648u) != 0u) {
                                        phi_2540_ = _e406;
                                        phi_2530_ = _e408;
                                        phi_783_ = type_4(0u, ((_e430 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e631 = phi_2540_;
                                            let _e633 = phi_2530_;
                                            let _e635 = phi_783_;
                                            if (_e635.member < _e635.member_1) {
                                                phi_784_ = type_4((_e635.member + 1u), _e635.member_1);
                                                phi_807_ = type_4(1u, _e635.member);
                                            } else {
                                                phi_784_ = _e635;
                                                phi_807_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e648 = phi_784_;
                                            let _e650 = phi_807_;
                                            let _e654 = (bitcast<i32>(_e650.member) != 0i);
                                            if _e654 {
                                                let _e655 = ((_e430 & 268435455u) + _e650.member_1);
                                                let _e656 = (_e655 < _e73);
                                                if _e656 {
                                                    if _e656 {
                                                    } else {
                                                        phi_2763_ = _e633;
                                                        phi_2673_ = true;
                                                        break;
                                                    }
                                                    let _e660 = global_3.member[_e655].member_1;
                                                    phi_828_ = _e660;
                                                } else {
                                                    phi_828_ = 4294967295u;
                                                }
                                                let _e662 = phi_828_;
                                                if (_e655 >= _e73) {
                                                    phi_917_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e656 {
                                                    } else {
                                                        phi_2763_ = _e633;
                                                        phi_2673_ = true;
                                                        break;
                                                    }
                                                    let _e664 = (_e199 % 3u);
                                                    let _e665 = (_e198 % 3u);
                                                    let _e666 = (_e200 % 3u);
                                                    if (_e664 < 9u) {
                                                    } else {
                                                        phi_2763_ = _e633;
                                                        phi_2673_ = true;
                                                        break;
                                                    }
                                                    let _e672 = global_3.member[_e655].member[_e664];
                                                    if (_e665 < 9u) {
                                                    } else {
                                                        phi_2763_ = _e633;
                                                        phi_2673_ = true;
                                                        break;
                                                    }
                                                    let _e678 = global_3.member[_e655].member[_e665];
                                                    if (_e666 < 9u) {
                                                    } else {
                                                        phi_2763_ = _e633;
                                                        phi_2673_ = true;
                                                        break;
                                                    }
                                                    let _e684 = global_3.member[_e655].member[_e666];
                                                    let _e686 = (3u + _e664);
                                                    if (_e686 < 9u) {
                                                    } else {
                                                        phi_2763_ = _e633;
                                                        phi_2673_ = true;
                                                        break;
                                                    }
                                                    let _e692 = global_3.member[_e655].member[_e686];
                                                    let _e693 = (3u + _e665);
                                                    if (_e693 < 9u) {
                                                    } else {
                                                        phi_2763_ = _e633;
                                                        phi_2673_ = true;
                                                        break;
                                                    }
                                                    let _e699 = global_3.member[_e655].member[_e693];
                                                    let _e700 = (3u + _e666);
                                                    if (_e700 < 9u) {
                                                    } else {
                                                        phi_2763_ = _e633;
                                                        phi_2673_ = true;
                                                        break;
                                                    }
                                                    let _e706 = global_3.member[_e655].member[_e700];
                                                    let _e708 = (6u + _e664);
                                                    if (_e708 < 9u) {
                                                    } else {
                                                        phi_2763_ = _e633;
                                                        phi_2673_ = true;
                                                        break;
                                                    }
                                                    let _e714 = global_3.member[_e655].member[_e708];
                                                    let _e715 = (6u + _e665);
                                                    if (_e715 < 9u) {
                                                    } else {
                                                        phi_2763_ = _e633;
                                                        phi_2673_ = true;
                                                        break;
                                                    }
                                                    let _e721 = global_3.member[_e655].member[_e715];
                                                    let _e722 = (6u + _e666);
                                                    if (_e722 < 9u) {
                                                    } else {
                                                        phi_2763_ = _e633;
                                                        phi_2673_ = true;
                                                        break;
                                                    }
                                                    let _e728 = global_3.member[_e655].member[_e722];
                                                    phi_917_ = array<array<f32, 3>, 3>(array<f32, 3>(_e672, _e678, _e684), array<f32, 3>(_e692, _e699, _e706), array<f32, 3>(_e714, _e721, _e728));
                                                }
                                                let _e732 = phi_917_;
                                                let _e739 = (_e732[0][2] - _e325);
                                                let _e742 = (((_e732[0][0] - _e248) * _e349) - (_e739 * _e273));
                                                let _e745 = (((_e732[0][1] - _e287) * _e349) - (_e739 * _e311));
                                                let _e752 = (_e732[1][2] - _e325);
                                                let _e755 = (((_e732[1][0] - _e248) * _e349) - (_e752 * _e273));
                                                let _e758 = (((_e732[1][1] - _e287) * _e349) - (_e752 * _e311));
                                                let _e765 = (_e732[2][2] - _e325);
                                                let _e768 = (((_e732[2][0] - _e248) * _e349) - (_e765 * _e273));
                                                let _e771 = (((_e732[2][1] - _e287) * _e349) - (_e765 * _e311));
                                                let _e772 = (_e768 * _e758);
                                                let _e773 = (_e771 * _e755);
                                                let _e774 = (_e742 * _e771);
                                                let _e775 = (_e745 * _e768);
                                                let _e776 = (_e755 * _e745);
                                                let _e777 = (_e758 * _e742);
                                                let _e782 = (((_e772 >= _e773) && (_e774 >= _e775)) && (_e776 >= _e777));
                                                if (_e782 || (((_e772 <= _e773) && (_e774 <= _e775)) && (_e776 <= _e777))) {
                                                    let _e789 = select(-1f, 1f, _e782);
                                                    let _e791 = ((_e772 - _e773) * _e789);
                                                    let _e793 = select(0f, _e791, (_e791 > 0f));
                                                    let _e795 = ((_e774 - _e775) * _e789);
                                                    let _e797 = select(0f, _e795, (_e795 > 0f));
                                                    let _e799 = ((_e776 - _e777) * _e789);
                                                    let _e801 = select(0f, _e799, (_e799 > 0f));
                                                    let _e803 = ((_e793 + _e797) + _e801);
                                                    if (_e803 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1743_ = type_23();
                                                        phi_1744_ = true;
                                                        phi_1745_ = false;
                                                    } else {
                                                        let _e806 = select(_e755, _e742, (_e742 < _e755));
                                                        if (select(_e768, _e806, (_e806 < _e768)) > 0f) {
                                                            phi_1035_ = true;
                                                        } else {
                                                            let _e811 = select(_e755, _e742, (_e742 > _e755));
                                                            phi_1035_ = (select(_e768, _e811, (_e811 > _e768)) < 0f);
                                                        }
                                                        let _e816 = phi_1035_;
                                                        if _e816 {
                                                            phi_1740_ = type_23();
                                                            phi_1741_ = true;
                                                            phi_1742_ = false;
                                                        } else {
                                                            let _e818 = select(_e758, _e745, (_e745 < _e758));
                                                            if (select(_e771, _e818, (_e818 < _e771)) > 0f) {
                                                                phi_1064_ = true;
                                                            } else {
                                                                let _e823 = select(_e758, _e745, (_e745 > _e758));
                                                                phi_1064_ = (select(_e771, _e823, (_e823 > _e771)) < 0f);
                                                            }
                                                            let _e828 = phi_1064_;
                                                            if _e828 {
                                                                phi_1738_ = type_23();
                                                                phi_1739_ = false;
                                                            } else {
                                                                let _e830 = select(_e732[1][0], _e732[0][0], (_e732[0][0] < _e732[1][0]));
                                                                let _e834 = select(_e732[1][0], _e732[0][0], (_e732[0][0] > _e732[1][0]));
                                                                let _e838 = select(_e732[1][1], _e732[0][1], (_e732[0][1] < _e732[1][1]));
                                                                let _e842 = select(_e732[1][1], _e732[0][1], (_e732[0][1] > _e732[1][1]));
                                                                let _e846 = select(_e732[1][2], _e732[0][2], (_e732[0][2] < _e732[1][2]));
                                                                let _e850 = select(_e732[1][2], _e732[0][2], (_e732[0][2] > _e732[1][2]));
                                                                let _e855 = ((select(_e732[2][0], _e830, (_e830 < _e732[2][0])) - _e271) * _e276);
                                                                let _e856 = ((select(_e732[2][0], _e834, (_e834 > _e732[2][0])) - _e272) * _e276);
                                                                let _e859 = ((select(_e732[2][1], _e838, (_e838 < _e732[2][1])) - _e309) * _e314);
                                                                let _e860 = ((select(_e732[2][1], _e842, (_e842 > _e732[2][1])) - _e310) * _e314);
                                                                let _e863 = ((select(_e732[2][2], _e846, (_e846 < _e732[2][2])) - _e347) * _e352);
                                                                let _e864 = ((select(_e732[2][2], _e850, (_e850 > _e732[2][2])) - _e348) * _e352);
                                                                let _e866 = select(_e864, _e863, (_e863 < _e864));
                                                                let _e868 = select(_e864, _e863, (_e863 > _e864));
                                                                let _e870 = select(_e856, _e855, (_e855 < _e856));
                                                                let _e872 = select(_e860, _e859, (_e859 < _e860));
                                                                let _e874 = select(_e872, _e870, (_e870 > _e872));
                                                                let _e876 = select(_e866, _e874, (_e874 > _e866));
                                                                let _e878 = select(_e856, _e855, (_e855 > _e856));
                                                                let _e880 = select(_e860, _e859, (_e859 > _e860));
                                                                let _e882 = select(_e880, _e878, (_e878 < _e880));
                                                                let _e884 = select(_e868, _e882, (_e882 < _e868));
                                                                let _e885 = -(_e866);
                                                                let _e891 = select(_e399, _e876, (_e876 > _e399));
                                                                if (_e891 > (_e884 + (select(_e885, _e868, (_e868 > _e885)) * 0.0000019073523f))) {
                                                                    phi_1733_ = type_23();
                                                                    phi_1734_ = true;
                                                                } else {
                                                                    let _e893 = (_e891 > _e633);
                                                                    if _e893 {
                                                                        phi_1732_ = type_23();
                                                                    } else {
                                                                        let _e894 = vec3<f32>(_e732[0][0], _e732[0][1], _e732[0][2]);
                                                                        let _e895 = vec3<f32>(_e732[1][0], _e732[1][1], _e732[1][2]);
                                                                        let _e896 = vec3<f32>(_e732[2][0], _e732[2][1], _e732[2][2]);
                                                                        let _e897 = (_e732[1][0] - _e732[0][0]);
                                                                        let _e898 = (_e732[1][1] - _e732[0][1]);
                                                                        let _e899 = (_e732[1][2] - _e732[0][2]);
                                                                        let _e900 = vec3<f32>(_e897, _e898, _e899);
                                                                        let _e901 = (_e732[2][0] - _e732[1][0]);
                                                                        let _e902 = (_e732[2][1] - _e732[1][1]);
                                                                        let _e903 = (_e732[2][2] - _e732[1][2]);
                                                                        let _e904 = vec3<f32>(_e901, _e902, _e903);
                                                                        let _e905 = (_e732[0][0] - _e732[2][0]);
                                                                        let _e906 = (_e732[0][1] - _e732[2][1]);
                                                                        let _e907 = (_e732[0][2] - _e732[2][2]);
                                                                        let _e908 = vec3<f32>(_e905, _e906, _e907);
                                                                        let _e911 = bitcast<f32>((bitcast<u32>(_e897) & 2147483647u));
                                                                        let _e914 = bitcast<f32>((bitcast<u32>(_e898) & 2147483647u));
                                                                        let _e916 = select(_e914, _e911, (_e911 > _e914));
                                                                        let _e919 = bitcast<f32>((bitcast<u32>(_e899) & 2147483647u));
                                                                        let _e921 = select(_e919, _e916, (_e916 > _e919));
                                                                        let _e924 = bitcast<f32>((bitcast<u32>(_e901) & 2147483647u));
                                                                        let _e927 = bitcast<f32>((bitcast<u32>(_e902) & 2147483647u));
                                                                        let _e929 = select(_e927, _e924, (_e924 > _e927));
                                                                        let _e932 = bitcast<f32>((bitcast<u32>(_e903) & 2147483647u));
                                                                        let _e934 = select(_e932, _e929, (_e929 > _e932));
                                                                        let _e937 = bitcast<f32>((bitcast<u32>(_e905) & 2147483647u));
                                                                        let _e940 = bitcast<f32>((bitcast<u32>(_e906) & 2147483647u));
                                                                        let _e942 = select(_e940, _e937, (_e937 > _e940));
                                                                        let _e945 = bitcast<f32>((bitcast<u32>(_e907) & 2147483647u));
                                                                        let _e947 = select(_e945, _e942, (_e942 > _e945));
                                                                        let _e949 = select(_e934, _e921, (_e921 > _e934));
                                                                        let _e951 = select(_e947, _e949, (_e949 > _e947));
                                                                        if (_e921 == _e951) {
                                                                            phi_1465_ = _e758;
                                                                            phi_1466_ = _e755;
                                                                            phi_1467_ = _e745;
                                                                            phi_1468_ = _e742;
                                                                            phi_1469_ = _e894;
                                                                            phi_1470_ = _e908;
                                                                            phi_1471_ = _e904;
                                                                            phi_1472_ = _e900;
                                                                        } else {
                                                                            let _e953 = (_e934 == _e951);
                                                                            let _e958 = vec3(_e953);
                                                                            phi_1465_ = select(_e745, _e771, _e953);
                                                                            phi_1466_ = select(_e742, _e768, _e953);
                                                                            phi_1467_ = select(_e771, _e758, _e953);
                                                                            phi_1468_ = select(_e768, _e755, _e953);
                                                                            phi_1469_ = select(_e896, _e895, _e958);
                                                                            phi_1470_ = select(_e904, _e900, _e958);
                                                                            phi_1471_ = select(_e900, _e908, _e958);
                                                                            phi_1472_ = select(_e908, _e904, _e958);
                                                                        }
                                                                        let _e964 = phi_1465_;
                                                                        let _e966 = phi_1466_;
                                                                        let _e968 = phi_1467_;
                                                                        let _e970 = phi_1468_;
                                                                        let _e972 = phi_1469_;
                                                                        let _e974 = phi_1470_;
                                                                        let _e976 = phi_1471_;
                                                                        let _e978 = phi_1472_;
                                                                        let _e985 = ((_e976.y * _e974.z) - (_e974.y * _e976.z));
                                                                        let _e990 = ((_e976.z * _e974.x) - (_e974.z * _e976.x));
                                                                        let _e993 = ((_e976.x * _e974.y) - (_e974.x * _e976.y));
                                                                        if (_e793 >= _e797) {
                                                                            phi_1503_ = select(true, false, (_e793 >= _e801));
                                                                        } else {
                                                                            phi_1503_ = true;
                                                                        }
                                                                        let _e998 = phi_1503_;
                                                                        if _e998 {
                                                                            phi_1512_ = select(_e896, _e895, vec3((_e797 >= _e801)));
                                                                        } else {
                                                                            phi_1512_ = _e894;
                                                                        }
                                                                        let _e1003 = phi_1512_;
                                                                        let _e1014 = (((_e985 * (_e1003.x - _e248)) + (_e990 * (_e1003.y - _e287))) + (_e993 * (_e1003.z - _e325)));
                                                                        let _e1019 = (((_e985 * _e273) + (_e990 * _e311)) + (_e993 * _e349));
                                                                        let _e1020 = (_e966 - _e970);
                                                                        let _e1021 = (_e964 - _e968);
                                                                        let _e1029 = (-(((_e970 * _e1020) + (_e968 * _e1021))) / ((_e1020 * _e1020) + (_e1021 * _e1021)));
                                                                        let _e1031 = select(1f, _e1029, (_e1029 < 1f));
                                                                        let _e1033 = select(0f, _e1031, (_e1031 > 0f));
                                                                        let _e1046 = ((_e972.x + (_e978.x * _e1033)) - _e248);
                                                                        let _e1047 = ((_e972.y + (_e978.y * _e1033)) - _e287);
                                                                        let _e1048 = ((_e972.z + (_e978.z * _e1033)) - _e325);
                                                                        let _e1049 = (_e1048 / _e349);
                                                                        let _e1061 = bitcast<f32>((bitcast<u32>(_e1046) & 2147483647u));
                                                                        let _e1064 = bitcast<f32>((bitcast<u32>(_e1047) & 2147483647u));
                                                                        let _e1066 = select(_e1064, _e1061, (_e1061 > _e1064));
                                                                        let _e1069 = bitcast<f32>((bitcast<u32>(_e1048) & 2147483647u));
                                                                        let _e1071 = select(_e1069, _e1066, (_e1066 > _e1069));
                                                                        let _e1077 = bitcast<f32>((bitcast<u32>(_e985) & 2147483647u));
                                                                        let _e1080 = bitcast<f32>((bitcast<u32>(_e990) & 2147483647u));
                                                                        let _e1082 = select(_e1080, _e1077, (_e1077 > _e1080));
                                                                        let _e1085 = bitcast<f32>((bitcast<u32>(_e993) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e985 * _e1046) + (_e990 * _e1047)) + (_e993 * _e1048)) - _e1014)) & 2147483647u)) <= ((0.0000009536743f * select(_e951, _e1071, (_e1071 > _e951))) * select(_e1085, _e1082, (_e1082 > _e1085)))) {
                                                                            let _e1095 = bitcast<f32>((bitcast<u32>(_e976.x) & 2147483647u));
                                                                            let _e1098 = bitcast<f32>((bitcast<u32>(_e976.y) & 2147483647u));
                                                                            let _e1100 = select(_e1098, _e1095, (_e1095 > _e1098));
                                                                            let _e1103 = bitcast<f32>((bitcast<u32>(_e976.z) & 2147483647u));
                                                                            let _e1109 = bitcast<f32>((bitcast<u32>(_e974.x) & 2147483647u));
                                                                            let _e1112 = bitcast<f32>((bitcast<u32>(_e974.y) & 2147483647u));
                                                                            let _e1114 = select(_e1112, _e1109, (_e1109 > _e1112));
                                                                            let _e1117 = bitcast<f32>((bitcast<u32>(_e974.z) & 2147483647u));
                                                                            let _e1121 = (bitcast<f32>((bitcast<u32>(_e1019) & 2147483647u)) > ((0.0000038146973f * select(_e1103, _e1100, (_e1100 > _e1103))) * select(_e1117, _e1114, (_e1114 > _e1117))));
                                                                            if _e1121 {
                                                                                phi_1677_ = (_e1014 / _e1019);
                                                                            } else {
                                                                                phi_1677_ = f32();
                                                                            }
                                                                            let _e1124 = phi_1677_;
                                                                            phi_1679_ = _e1124;
                                                                            phi_1680_ = select(true, false, _e1121);
                                                                        } else {
                                                                            phi_1679_ = f32();
                                                                            phi_1680_ = true;
                                                                        }
                                                                        let _e1127 = phi_1679_;
                                                                        let _e1129 = phi_1680_;
                                                                        if _e1129 {
                                                                            let _e1137 = (((_e985 * (_e1046 - (_e273 * _e1049))) + (_e990 * (_e1047 - (_e311 * _e1049)))) / _e1019);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1137) & 2147483647u)) <= _e951) {
                                                                                phi_1700_ = (_e1049 + _e1137);
                                                                            } else {
                                                                                phi_1700_ = _e1049;
                                                                            }
                                                                            let _e1144 = phi_1700_;
                                                                            phi_1701_ = _e1144;
                                                                        } else {
                                                                            phi_1701_ = _e1127;
                                                                        }
                                                                        let _e1146 = phi_1701_;
                                                                        let _e1148 = select(_e884, _e1146, (_e1146 < _e884));
                                                                        let _e1150 = select(_e876, _e1148, (_e1148 > _e876));
                                                                        if (_e1150 >= _e399) {
                                                                            let _e1152 = (_e1150 <= _e633);
                                                                            if _e1152 {
                                                                                let _e1153 = (1f / _e803);
                                                                                phi_1724_ = type_23(_e1150, (_e797 * _e1153), (_e801 * _e1153), _e662);
                                                                            } else {
                                                                                phi_1724_ = type_23();
                                                                            }
                                                                            let _e1158 = phi_1724_;
                                                                            phi_1726_ = _e1158;
                                                                            phi_1727_ = select(true, false, _e1152);
                                                                        } else {
                                                                            phi_1726_ = type_23();
                                                                            phi_1727_ = true;
                                                                        }
                                                                        let _e1161 = phi_1726_;
                                                                        let _e1163 = phi_1727_;
                                                                        if _e1163 {
                                                                            phi_1731_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1731_ = _e1161;
                                                                        }
                                                                        let _e1165 = phi_1731_;
                                                                        phi_1732_ = _e1165;
                                                                    }
                                                                    let _e1167 = phi_1732_;
                                                                    phi_1733_ = _e1167;
                                                                    phi_1734_ = _e893;
                                                                }
                                                                let _e1169 = phi_1733_;
                                                                let _e1171 = phi_1734_;
                                                                phi_1738_ = _e1169;
                                                                phi_1739_ = _e1171;
                                                            }
                                                            let _e1173 = phi_1738_;
                                                            let _e1175 = phi_1739_;
                                                            phi_1740_ = _e1173;
                                                            phi_1741_ = _e828;
                                                            phi_1742_ = _e1175;
                                                        }
                                                        let _e1177 = phi_1740_;
                                                        let _e1179 = phi_1741_;
                                                        let _e1181 = phi_1742_;
                                                        phi_1743_ = _e1177;
                                                        phi_1744_ = _e1179;
                                                        phi_1745_ = _e1181;
                                                    }
                                                    let _e1183 = phi_1743_;
                                                    let _e1185 = phi_1744_;
                                                    let _e1187 = phi_1745_;
                                                    phi_1753_ = _e1183;
                                                    phi_1754_ = select(_e1187, true, _e1185);
                                                } else {
                                                    phi_1753_ = type_23();
                                                    phi_1754_ = true;
                                                }
                                                let _e1190 = phi_1753_;
                                                let _e1192 = phi_1754_;
                                                if _e1192 {
                                                    phi_1758_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1758_ = _e1190;
                                                }
                                                let _e1194 = phi_1758_;
                                                if (_e1194.member_3 != 4294967295u) {
                                                    if (_e662 != 4294967295u) {
                                                        phi_1770_ = type_4(0u, 8u);
                                                        phi_1773_ = _e1194;
                                                        loop {
                                                            let _e1199 = phi_1770_;
                                                            let _e1201 = phi_1773_;
                                                            if (_e1199.member < _e1199.member_1) {
                                                                phi_1771_ = type_4((_e1199.member + 1u), _e1199.member_1);
                                                                phi_1796_ = type_4(1u, _e1199.member);
                                                            } else {
                                                                phi_1771_ = _e1199;
                                                                phi_1796_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1214 = phi_1771_;
                                                            let _e1216 = phi_1796_;
                                                            let _e1220 = (bitcast<i32>(_e1216.member) != 0i);
                                                            if _e1220 {
                                                                let _e1221 = (_e1216.member_1 < 8u);
                                                                if _e1221 {
                                                                } else {
                                                                    phi_2531_ = true;
                                                                    break;
                                                                }
                                                                let _e1226 = local[_e1216.member_1].member;
                                                                if (_e1201.member < _e1226) {
                                                                    phi_1829_ = true;
                                                                } else {
                                                                    let _e1228 = local[_e1216.member_1].member;
                                                                    if (_e1201.member == _e1228) {
                                                                        let _e1233 = local[_e1216.member_1].member_3;
                                                                        phi_1828_ = (_e1201.member_3 < _e1233);
                                                                    } else {
                                                                        phi_1828_ = false;
                                                                    }
                                                                    let _e1236 = phi_1828_;
                                                                    phi_1829_ = _e1236;
                                                                }
                                                                let _e1238 = phi_1829_;
                                                                if _e1238 {
                                                                    if _e1221 {
                                                                    } else {
                                                                        phi_2531_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1239 = local[_e1216.member_1];
                                                                    local[_e1216.member_1] = type_23(_e1201.member, _e1201.member_1, _e1201.member_2, _e1201.member_3);
                                                                    phi_1850_ = type_23(_e1239.member, _e1239.member_1, _e1239.member_2, _e1239.member_3);
                                                                } else {
                                                                    phi_1850_ = _e1201;
                                                                }
                                                                let _e1250 = phi_1850_;
                                                                phi_1774_ = _e1250;
                                                            } else {
                                                                phi_1774_ = type_23();
                                                            }
                                                            let _e1252 = phi_1774_;
                                                            continue;
                                                            continuing {
                                                                phi_1770_ = _e1214;
                                                                phi_1773_ = _e1252;
                                                                phi_2531_ = _e631;
                                                                break if !(_e1220);
                                                            }
                                                        }
                                                        let _e1255 = phi_2531_;
                                                        phi_2763_ = _e633;
                                                        phi_2673_ = _e1255;
                                                        if _e1255 {
                                                            break;
                                                        }
                                                        let _e1258 = local[7u].member_3;
                                                        if (_e1258 != 4294967295u) {
                                                            let _e1262 = local[7u].member;
                                                            phi_2854_ = _e1262;
                                                        } else {
                                                            phi_2854_ = _e633;
                                                        }
                                                        let _e1264 = phi_2854_;
                                                        phi_2853_ = _e1264;
                                                        phi_2676_ = _e1255;
                                                    } else {
                                                        phi_2853_ = _e633;
                                                        phi_2676_ = _e631;
                                                    }
                                                    let _e1266 = phi_2853_;
                                                    let _e1268 = phi_2676_;
                                                    phi_2852_ = _e1266;
                                                    phi_2675_ = _e1268;
                                                } else {
                                                    phi_2852_ = _e633;
                                                    phi_2675_ = _e631;
                                                }
                                                let _e1270 = phi_2852_;
                                                let _e1272 = phi_2675_;
                                                phi_2851_ = _e1270;
                                                phi_2674_ = _e1272;
                                            } else {
                                                phi_2851_ = _e633;
                                                phi_2674_ = _e631;
                                            }
                                            let _e1274 = phi_2851_;
                                            let _e1276 = phi_2674_;
                                            continue;
                                            continuing {
                                                phi_2540_ = _e1276;
                                                phi_2530_ = _e1274;
                                                phi_783_ = _e648;
                                                phi_2763_ = _e1274;
                                                phi_2673_ = _e1276;
                                                break if !(_e654);
                                            }
                                        }
                                        let _e1279 = phi_2763_;
                                        let _e1281 = phi_2673_;
                                        phi_2678_ = _e1281;
                                        if _e1281 {
                                            break;
                                        }
                                        phi_2728_ = _e1279;
                                        phi_2682_ = _e1281;
                                        phi_2317_ = _e430;
                                        phi_2318_ = false;
                                        phi_2319_ = _e434;
                                    } else {
                                        if (_e430 >= _e71) {
                                            phi_1921_ = type_39(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e430 < _e71) {
                                            } else {
                                                phi_2678_ = true;
                                                break;
                                            }
                                            let _e444 = (_e199 % 3u);
                                            if (_e444 < 3u) {
                                            } else {
                                                phi_2678_ = true;
                                                break;
                                            }
                                            let _e450 = global_2.member[_e430].member[_e444];
                                            let _e456 = (_e198 % 3u);
                                            if (_e456 < 3u) {
                                            } else {
                                                phi_2678_ = true;
                                                break;
                                            }
                                            let _e462 = global_2.member[_e430].member[_e456];
                                            let _e468 = (_e200 % 3u);
                                            if (_e468 < 3u) {
                                            } else {
                                                phi_2678_ = true;
                                                break;
                                            }
                                            let _e474 = global_2.member[_e430].member[_e468];
                                            let _e484 = global_2.member[_e430].member_1;
                                            let _e488 = global_2.member[_e430].member_2;
                                            phi_1921_ = type_39(array<vec4<f32>, 3>(vec4<f32>(_e450[0], _e450[1], _e450[2], _e450[3]), vec4<f32>(_e462[0], _e462[1], _e462[2], _e462[3]), vec4<f32>(_e474[0], _e474[1], _e474[2], _e474[3])), _e484, _e488);
                                        }
                                        let _e491 = phi_1921_;
                                        let _e502 = ((_e491.member[0].x - _e271) * _e276);
                                        let _e503 = ((_e491.member[0].y - _e271) * _e276);
                                        let _e504 = ((_e491.member[0].z - _e272) * _e276);
                                        let _e505 = ((_e491.member[0].w - _e272) * _e276);
                                        let _e515 = ((_e491.member[1].x - _e309) * _e314);
                                        let _e516 = ((_e491.member[1].y - _e309) * _e314);
                                        let _e517 = ((_e491.member[1].z - _e310) * _e314);
                                        let _e518 = ((_e491.member[1].w - _e310) * _e314);
                                        let _e528 = ((_e491.member[2].x - _e347) * _e352);
                                        let _e529 = ((_e491.member[2].y - _e347) * _e352);
                                        let _e530 = ((_e491.member[2].z - _e348) * _e352);
                                        let _e531 = ((_e491.member[2].w - _e348) * _e352);
                                        let _e533 = select(_e530, _e528, (_e528 < _e530));
                                        let _e535 = select(_e531, _e529, (_e529 < _e531));
                                        let _e537 = select(_e530, _e528, (_e528 > _e530));
                                        let _e539 = select(_e531, _e529, (_e529 > _e531));
                                        let _e541 = select(_e504, _e502, (_e502 < _e504));
                                        let _e543 = select(_e505, _e503, (_e503 < _e505));
                                        let _e545 = select(_e517, _e515, (_e515 < _e517));
                                        let _e547 = select(_e518, _e516, (_e516 < _e518));
                                        let _e549 = select(_e545, _e541, (_e541 > _e545));
                                        let _e551 = select(_e547, _e543, (_e543 > _e547));
                                        let _e553 = select(_e533, _e549, (_e549 > _e533));
                                        let _e555 = select(_e535, _e551, (_e551 > _e535));
                                        let _e557 = select(_e504, _e502, (_e502 > _e504));
                                        let _e559 = select(_e505, _e503, (_e503 > _e505));
                                        let _e561 = select(_e517, _e515, (_e515 > _e517));
                                        let _e563 = select(_e518, _e516, (_e516 > _e518));
                                        let _e565 = select(_e561, _e557, (_e557 < _e561));
                                        let _e567 = select(_e563, _e559, (_e559 < _e563));
                                        let _e572 = -(_e533);
                                        let _e573 = -(_e535);
                                        let _e580 = (select(_e537, _e565, (_e565 < _e537)) + (select(_e572, _e537, (_e537 > _e572)) * 0.0000019073523f));
                                        let _e581 = (select(_e539, _e567, (_e567 < _e539)) + (select(_e573, _e539, (_e539 > _e573)) * 0.0000019073523f));
                                        let _e583 = select(_e399, _e553, (_e553 > _e399));
                                        let _e585 = select(_e399, _e555, (_e555 > _e399));
                                        let _e590 = (_e583 <= select(_e408, _e580, (_e580 < _e408)));
                                        let _e591 = (_e585 <= select(_e408, _e581, (_e581 < _e408)));
                                        let _e592 = (_e583 <= _e585);
                                        if _e590 {
                                            if _e591 {
                                                if _e592 {
                                                    phi_2266_ = _e491.member_2;
                                                } else {
                                                    phi_2266_ = _e491.member_1;
                                                }
                                                let _e596 = phi_2266_;
                                                let _e599 = (_e434 % 128u);
                                                let _e600 = (_e599 < 128u);
                                                if _e600 {
                                                } else {
                                                    phi_2678_ = true;
                                                    break;
                                                }
                                                local_2[_e599] = _e596;
                                                if _e600 {
                                                } else {
                                                    phi_2678_ = true;
                                                    break;
                                                }
                                                local_1[_e599] = select(_e585, _e583, (_e583 > _e585));
                                                if _e592 {
                                                    phi_2294_ = _e491.member_1;
                                                } else {
                                                    phi_2294_ = _e491.member_2;
                                                }
                                                let _e607 = phi_2294_;
                                                phi_2295_ = _e607;
                                                phi_2296_ = (_e434 + 1u);
                                            } else {
                                                phi_2295_ = u32();
                                                phi_2296_ = u32();
                                            }
                                            let _e609 = phi_2295_;
                                            let _e611 = phi_2296_;
                                            phi_2298_ = _e609;
                                            phi_2299_ = _e611;
                                            phi_2300_ = select(true, false, _e591);
                                        } else {
                                            phi_2298_ = u32();
                                            phi_2299_ = u32();
                                            phi_2300_ = true;
                                        }
                                        let _e614 = phi_2298_;
                                        let _e616 = phi_2299_;
                                        let _e618 = phi_2300_;
                                        if _e618 {
                                            if _e590 {
                                                phi_2309_ = _e491.member_1;
                                            } else {
                                                phi_2309_ = _e491.member_2;
                                            }
                                            let _e622 = phi_2309_;
                                            phi_2314_ = _e622;
                                            phi_2315_ = select(_e591, true, _e590);
                                        } else {
                                            phi_2314_ = _e614;
                                            phi_2315_ = _e432;
                                        }
                                        let _e625 = phi_2314_;
                                        let _e627 = phi_2315_;
                                        phi_2728_ = _e408;
                                        phi_2682_ = _e406;
                                        phi_2317_ = _e625;
                                        phi_2318_ = _e627;
                                        phi_2319_ = select(_e616, _e434, _e618);
                                    }
                                    let _e1283 = phi_2728_;
                                    let _e1285 = phi_2682_;
                                    let _e1287 = phi_2317_;
                                    let _e1289 = phi_2318_;
                                    let _e1291 = phi_2319_;
                                    phi_2727_ = _e1283;
                                    phi_2681_ = _e1285;
                                    phi_2320_ = _e1287;
                                    phi_2321_ = (_e412 - 1u);
                                    phi_2322_ = _e1289;
                                    phi_2323_ = _e1291;
                                } else {
                                    phi_2727_ = _e408;
                                    phi_2681_ = _e406;
                                    phi_2320_ = _e430;
                                    phi_2321_ = _e412;
                                    phi_2322_ = _e432;
                                    phi_2323_ = _e434;
                                }
                                let _e1293 = phi_2727_;
                                let _e1295 = phi_2681_;
                                let _e1297 = phi_2320_;
                                let _e1299 = phi_2321_;
                                let _e1301 = phi_2322_;
                                let _e1303 = phi_2323_;
                                phi_2726_ = _e1293;
                                phi_2680_ = _e1295;
                                phi_2324_ = _e1297;
                                phi_2325_ = _e1299;
                                phi_2326_ = _e1301;
                                phi_2327_ = _e1303;
                            } else {
                                phi_2726_ = _e408;
                                phi_2680_ = _e406;
                                phi_2324_ = u32();
                                phi_2325_ = u32();
                                phi_2326_ = bool();
                                phi_2327_ = u32();
                            }
                            let _e1305 = phi_2726_;
                            let _e1307 = phi_2680_;
                            let _e1309 = phi_2324_;
                            let _e1311 = phi_2325_;
                            let _e1313 = phi_2326_;
                            let _e1315 = phi_2327_;
                            phi_2725_ = _e1305;
                            phi_2679_ = _e1307;
                            phi_716_ = _e1309;
                            phi_719_ = _e1311;
                            phi_721_ = _e1313;
                            phi_723_ = _e1315;
                            phi_2328_ = _e420;
                        } else {
                            phi_2725_ = _e408;
                            phi_2679_ = _e406;
                            phi_716_ = u32();
                            phi_719_ = u32();
                            phi_721_ = bool();
                            phi_723_ = u32();
                            phi_2328_ = false;
                        }
                        let _e1317 = phi_2725_;
                        let _e1319 = phi_2679_;
                        let _e1321 = phi_716_;
                        let _e1323 = phi_719_;
                        let _e1325 = phi_721_;
                        let _e1327 = phi_723_;
                        let _e1329 = phi_2328_;
                        continue;
                        continuing {
                            phi_2543_ = _e1319;
                            phi_2523_ = _e1317;
                            phi_715_ = _e1321;
                            phi_718_ = _e1323;
                            phi_720_ = _e1325;
                            phi_722_ = _e1327;
                            phi_2678_ = _e1319;
                            break if !(_e1329);
                        }
                    }
                    let _e1332 = phi_2678_;
                    if _e1332 {
                        break;
                    }
                    phi_2335_ = type_4(0u, 8u);
                    loop {
                        let _e1334 = phi_2335_;
                        if (_e1334.member < _e1334.member_1) {
                            phi_2336_ = type_4((_e1334.member + 1u), _e1334.member_1);
                            phi_2359_ = type_4(1u, _e1334.member);
                        } else {
                            phi_2336_ = _e1334;
                            phi_2359_ = type_4(0u, type_4().member_1);
                        }
                        let _e1347 = phi_2336_;
                        let _e1349 = phi_2359_;
                        let _e1353 = (bitcast<i32>(_e1349.member) != 0i);
                        if _e1353 {
                            let _e1354 = (_e1349.member_1 < 8u);
                            if _e1354 {
                            } else {
                                phi_2718_ = true;
                                break;
                            }
                            let _e1356 = local[_e1349.member_1];
                            if (_e1356.member_3 != 4294967295u) {
                                let _e1362 = -(_e366);
                                let _e1363 = (_e1362 / 3i);
                                let _e1370 = bitcast<f32>((bitcast<u32>((_e1363 + 127i)) << bitcast<u32>(23i)));
                                let _e1378 = (((_e1356.member * _e1370) * _e1370) * bitcast<f32>((bitcast<u32>(((_e1362 - (2i * _e1363)) + 127i)) << bitcast<u32>(23i))));
                                let _e1380 = select(340282350000000000000000000000000000000f, _e1378, (_e1378 < 340282350000000000000000000000000000000f));
                                phi_2425_ = type_23(select(-340282350000000000000000000000000000000f, _e1380, (_e1380 > -340282350000000000000000000000000000000f)), _e1356.member_1, _e1356.member_2, _e1356.member_3);
                            } else {
                                phi_2425_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1385 = phi_2425_;
                            if _e1354 {
                            } else {
                                phi_2718_ = true;
                                break;
                            }
                            local[_e1349.member_1] = type_23(_e1385.member, _e1385.member_1, _e1385.member_2, _e1385.member_3);
                        }
                        continue;
                        continuing {
                            phi_2335_ = _e1347;
                            phi_2718_ = _e1332;
                            break if !(_e1353);
                        }
                    }
                    let _e1393 = phi_2718_;
                    if _e1393 {
                        break;
                    }
                    let _e1394 = local;
                    if _e87 {
                    } else {
                        break;
                    }
                    global_5.member[_e81] = array<type_23, 8>(type_23(_e1394[0].member, _e1394[0].member_1, _e1394[0].member_2, _e1394[0].member_3), type_23(_e1394[1].member, _e1394[1].member_1, _e1394[1].member_2, _e1394[1].member_3), type_23(_e1394[2].member, _e1394[2].member_1, _e1394[2].member_2, _e1394[2].member_3), type_23(_e1394[3].member, _e1394[3].member_1, _e1394[3].member_2, _e1394[3].member_3), type_23(_e1394[4].member, _e1394[4].member_1, _e1394[4].member_2, _e1394[4].member_3), type_23(_e1394[5].member, _e1394[5].member_1, _e1394[5].member_2, _e1394[5].member_3), type_23(_e1394[6].member, _e1394[6].member_1, _e1394[6].member_2, _e1394[6].member_3), type_23(_e1394[7].member, _e1394[7].member_1, _e1394[7].member_2, _e1394[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
