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
    var phi_281_: i32;
    var phi_282_: i32;
    var phi_292_: bool;
    var phi_302_: u32;
    var phi_303_: u32;
    var phi_305_: bool;
    var phi_310_: u32;
    var phi_322_: i32;
    var phi_342_: i32;
    var phi_360_: f32;
    var phi_366_: f32;
    var phi_377_: f32;
    var phi_383_: f32;
    var phi_406_: f32;
    var phi_417_: f32;
    var phi_426_: f32;
    var phi_432_: f32;
    var phi_443_: f32;
    var phi_449_: f32;
    var phi_472_: f32;
    var phi_483_: f32;
    var phi_492_: f32;
    var phi_498_: f32;
    var phi_509_: f32;
    var phi_515_: f32;
    var phi_538_: f32;
    var phi_549_: f32;
    var phi_649_: f32;
    var phi_650_: f32;
    var phi_2545_: bool;
    var phi_2525_: f32;
    var phi_714_: u32;
    var phi_717_: u32;
    var phi_719_: bool;
    var phi_721_: u32;
    var phi_732_: bool;
    var phi_765_: u32;
    var phi_766_: bool;
    var phi_767_: u32;
    var phi_1923_: type_39;
    var phi_2268_: u32;
    var phi_2296_: u32;
    var phi_2297_: u32;
    var phi_2298_: u32;
    var phi_2300_: u32;
    var phi_2301_: u32;
    var phi_2302_: bool;
    var phi_2311_: u32;
    var phi_2316_: u32;
    var phi_2317_: bool;
    var phi_2542_: bool;
    var phi_2532_: f32;
    var phi_782_: type_4;
    var phi_783_: type_4;
    var phi_806_: type_4;
    var phi_827_: u32;
    var phi_916_: array<array<f32, 3>, 3>;
    var phi_1034_: bool;
    var phi_1063_: bool;
    var phi_1464_: f32;
    var phi_1465_: f32;
    var phi_1466_: f32;
    var phi_1467_: f32;
    var phi_1468_: vec3<f32>;
    var phi_1469_: vec3<f32>;
    var phi_1470_: vec3<f32>;
    var phi_1471_: vec3<f32>;
    var phi_1502_: bool;
    var phi_1511_: vec3<f32>;
    var phi_1678_: bool;
    var phi_1702_: f32;
    var phi_1703_: f32;
    var phi_1726_: type_23;
    var phi_1728_: type_23;
    var phi_1729_: bool;
    var phi_1733_: type_23;
    var phi_1734_: type_23;
    var phi_1735_: type_23;
    var phi_1736_: bool;
    var phi_1740_: type_23;
    var phi_1741_: bool;
    var phi_1742_: type_23;
    var phi_1743_: bool;
    var phi_1744_: bool;
    var phi_1745_: type_23;
    var phi_1746_: bool;
    var phi_1747_: bool;
    var phi_1755_: type_23;
    var phi_1756_: bool;
    var phi_1760_: type_23;
    var phi_1772_: type_4;
    var phi_1775_: type_23;
    var phi_1773_: type_4;
    var phi_1798_: type_4;
    var phi_1830_: bool;
    var phi_1831_: bool;
    var phi_1852_: type_23;
    var phi_1776_: type_23;
    var phi_2533_: bool;
    var phi_2856_: f32;
    var phi_2855_: f32;
    var phi_2678_: bool;
    var phi_2854_: f32;
    var phi_2677_: bool;
    var phi_2853_: f32;
    var phi_2676_: bool;
    var phi_2765_: f32;
    var phi_2675_: bool;
    var phi_2730_: f32;
    var phi_2684_: bool;
    var phi_2319_: u32;
    var phi_2320_: bool;
    var phi_2321_: u32;
    var phi_2729_: f32;
    var phi_2683_: bool;
    var phi_2322_: u32;
    var phi_2323_: u32;
    var phi_2324_: bool;
    var phi_2325_: u32;
    var phi_2728_: f32;
    var phi_2682_: bool;
    var phi_2326_: u32;
    var phi_2327_: u32;
    var phi_2328_: bool;
    var phi_2329_: u32;
    var phi_2727_: f32;
    var phi_2681_: bool;
    var phi_715_: u32;
    var phi_718_: u32;
    var phi_720_: bool;
    var phi_722_: u32;
    var phi_2330_: bool;
    var phi_2680_: bool;
    var phi_2337_: type_4;
    var phi_2338_: type_4;
    var phi_2361_: type_4;
    var phi_2427_: type_23;
    var phi_2720_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e68 = global;
            let _e70 = arrayLength((&global_2.member));
            let _e72 = arrayLength((&global_3.member));
            let _e80 = (_e68.x + (_e68.y * 2097152u));
            let _e83 = global_1.member[0u];
            let _e84 = bitcast<i32>(_e83);
            let _e85 = (_e80 < arrayLength((&global_4.member)));
            if _e85 {
                let _e86 = (_e80 < arrayLength((&global_5.member)));
                if _e86 {
                    if _e85 {
                    } else {
                        break;
                    }
                    let _e94 = global_4.member[_e80].member_2[0u];
                    let _e96 = (bitcast<u32>(_e94) & 2147483647u);
                    let _e101 = global_4.member[_e80].member_2[1u];
                    let _e103 = (bitcast<u32>(_e101) & 2147483647u);
                    let _e108 = global_4.member[_e80].member_2[2u];
                    let _e110 = (bitcast<u32>(_e108) & 2147483647u);
                    let _e115 = global_4.member[_e80].member[0u];
                    let _e117 = (bitcast<u32>(_e115) & 2147483647u);
                    let _e122 = global_4.member[_e80].member[1u];
                    let _e124 = (bitcast<u32>(_e122) & 2147483647u);
                    let _e129 = global_4.member[_e80].member[2u];
                    let _e131 = (bitcast<u32>(_e129) & 2147483647u);
                    let _e133 = select(_e103, _e96, (_e103 < _e96));
                    let _e135 = select(_e110, _e133, (_e110 < _e133));
                    let _e137 = select(_e117, _e135, (_e117 < _e135));
                    let _e139 = select(_e124, _e137, (_e124 < _e137));
                    let _e141 = select(_e131, _e139, (_e131 < _e139));
                    let _e145 = global_4.member[_e80].member_1;
                    let _e147 = (bitcast<u32>(_e145) & 2147483647u);
                    let _e154 = global_4.member[_e80].member_3;
                    let _e160 = (((select(_e147, _e141, (_e147 < _e141)) < 2139095040u) && ((bitcast<u32>(_e154) & 2147483647u) <= 2139095040u)) && (_e135 > 0u));
                    if _e160 {
                        let _e163 = (bitcast<u32>(bitcast<f32>(_e135)) & 2147483647u);
                        if (_e163 >= 8388608u) {
                            phi_281_ = (bitcast<i32>((_e163 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_281_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e163)), 32u, (_e163 == 0u))));
                        }
                        let _e177 = phi_281_;
                        phi_282_ = _e177;
                    } else {
                        phi_282_ = 0i;
                    }
                    let _e179 = phi_282_;
                    let _e180 = (_e96 == _e135);
                    if _e180 {
                        phi_292_ = true;
                    } else {
                        phi_292_ = (_e103 == _e135);
                    }
                    let _e183 = phi_292_;
                    let _e184 = select(1u, 0u, _e180);
                    if _e183 {
                        let _e185 = (_e184 + 1u);
                        phi_302_ = _e185;
                        phi_303_ = _e185;
                        phi_305_ = select(true, false, (_e185 == 2u));
                    } else {
                        phi_302_ = u32();
                        phi_303_ = 0u;
                        phi_305_ = true;
                    }
                    let _e189 = phi_302_;
                    let _e191 = phi_303_;
                    let _e193 = phi_305_;
                    if _e193 {
                        phi_310_ = (_e191 + 1u);
                    } else {
                        phi_310_ = 0u;
                    }
                    let _e197 = phi_310_;
                    let _e198 = select(_e189, _e191, _e193);
                    let _e199 = select(_e184, select(2u, _e184, _e183), _e193);
                    if (_e84 < -126i) {
                        phi_322_ = -126i;
                    } else {
                        phi_322_ = select(_e84, 127i, (_e84 > 127i));
                    }
                    let _e204 = phi_322_;
                    let _e209 = bitcast<f32>((bitcast<u32>((_e204 + 127i)) << bitcast<u32>(23i)));
                    let _e215 = bitcast<f32>((bitcast<u32>(((_e84 - _e204) + 127i)) << bitcast<u32>(23i)));
                    let _e216 = -(_e179);
                    if (_e216 < -126i) {
                        phi_342_ = -126i;
                    } else {
                        phi_342_ = select(_e216, 127i, (_e216 > 127i));
                    }
                    let _e221 = phi_342_;
                    let _e226 = bitcast<f32>((bitcast<u32>((_e221 + 127i)) << bitcast<u32>(23i)));
                    let _e232 = bitcast<f32>((bitcast<u32>(((_e216 - _e221) + 127i)) << bitcast<u32>(23i)));
                    let _e236 = global_4.member[_e80].member;
                    let _e237 = (_e198 == 0u);
                    if _e237 {
                        phi_360_ = _e236[0];
                    } else {
                        phi_360_ = _e236[1];
                    }
                    let _e241 = phi_360_;
                    let _e242 = (_e198 == 2u);
                    if _e242 {
                        phi_366_ = _e236[2];
                    } else {
                        phi_366_ = _e241;
                    }
                    let _e245 = phi_366_;
                    let _e247 = ((_e245 * _e209) * _e215);
                    let _e248 = global_4.member[_e80].member_2;
                    if _e237 {
                        phi_377_ = _e248[0];
                    } else {
                        phi_377_ = _e248[1];
                    }
                    let _e252 = phi_377_;
                    if _e242 {
                        phi_383_ = _e248[2];
                    } else {
                        phi_383_ = _e252;
                    }
                    let _e255 = phi_383_;
                    let _e257 = ((_e255 * _e226) * _e232);
                    let _e261 = (bitcast<f32>((bitcast<u32>(_e257) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e261 {
                        let _e265 = (bitcast<f32>((bitcast<u32>(_e247) & 2147483647u)) * 0.00000011920929f);
                        phi_406_ = select(0.00000000000011368684f, _e265, (_e265 > 0.00000000000011368684f));
                    } else {
                        phi_406_ = 0f;
                    }
                    let _e269 = phi_406_;
                    let _e270 = (_e247 + _e269);
                    let _e271 = (_e247 - _e269);
                    let _e272 = select(_e257, 0f, _e261);
                    if _e261 {
                        phi_417_ = 38685626000000000000000000f;
                    } else {
                        phi_417_ = (1f / _e257);
                    }
                    let _e275 = phi_417_;
                    let _e276 = (_e197 == 0u);
                    if _e276 {
                        phi_426_ = _e236[0];
                    } else {
                        phi_426_ = _e236[1];
                    }
                    let _e280 = phi_426_;
                    let _e281 = (_e197 == 2u);
                    if _e281 {
                        phi_432_ = _e236[2];
                    } else {
                        phi_432_ = _e280;
                    }
                    let _e284 = phi_432_;
                    let _e286 = ((_e284 * _e209) * _e215);
                    if _e276 {
                        phi_443_ = _e248[0];
                    } else {
                        phi_443_ = _e248[1];
                    }
                    let _e290 = phi_443_;
                    if _e281 {
                        phi_449_ = _e248[2];
                    } else {
                        phi_449_ = _e290;
                    }
                    let _e293 = phi_449_;
                    let _e295 = ((_e293 * _e226) * _e232);
                    let _e299 = (bitcast<f32>((bitcast<u32>(_e295) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e299 {
                        let _e303 = (bitcast<f32>((bitcast<u32>(_e286) & 2147483647u)) * 0.00000011920929f);
                        phi_472_ = select(0.00000000000011368684f, _e303, (_e303 > 0.00000000000011368684f));
                    } else {
                        phi_472_ = 0f;
                    }
                    let _e307 = phi_472_;
                    let _e308 = (_e286 + _e307);
                    let _e309 = (_e286 - _e307);
                    let _e310 = select(_e295, 0f, _e299);
                    if _e299 {
                        phi_483_ = 38685626000000000000000000f;
                    } else {
                        phi_483_ = (1f / _e295);
                    }
                    let _e313 = phi_483_;
                    let _e314 = (_e199 == 0u);
                    if _e314 {
                        phi_492_ = _e236[0];
                    } else {
                        phi_492_ = _e236[1];
                    }
                    let _e318 = phi_492_;
                    let _e319 = (_e199 == 2u);
                    if _e319 {
                        phi_498_ = _e236[2];
                    } else {
                        phi_498_ = _e318;
                    }
                    let _e322 = phi_498_;
                    let _e324 = ((_e322 * _e209) * _e215);
                    if _e314 {
                        phi_509_ = _e248[0];
                    } else {
                        phi_509_ = _e248[1];
                    }
                    let _e328 = phi_509_;
                    if _e319 {
                        phi_515_ = _e248[2];
                    } else {
                        phi_515_ = _e328;
                    }
                    let _e331 = phi_515_;
                    let _e333 = ((_e331 * _e226) * _e232);
                    let _e337 = (bitcast<f32>((bitcast<u32>(_e333) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e337 {
                        let _e341 = (bitcast<f32>((bitcast<u32>(_e324) & 2147483647u)) * 0.00000011920929f);
                        phi_538_ = select(0.00000000000011368684f, _e341, (_e341 > 0.00000000000011368684f));
                    } else {
                        phi_538_ = 0f;
                    }
                    let _e345 = phi_538_;
                    let _e346 = (_e324 + _e345);
                    let _e347 = (_e324 - _e345);
                    let _e348 = select(_e333, 0f, _e337);
                    if _e337 {
                        phi_549_ = 38685626000000000000000000f;
                    } else {
                        phi_549_ = (1f / _e333);
                    }
                    let _e351 = phi_549_;
                    let _e354 = bitcast<f32>((bitcast<u32>(_e247) & 2147483647u));
                    let _e357 = bitcast<f32>((bitcast<u32>(_e286) & 2147483647u));
                    let _e359 = select(_e357, _e354, (_e354 > _e357));
                    let _e362 = bitcast<f32>((bitcast<u32>(_e324) & 2147483647u));
                    let _e365 = (_e84 + _e179);
                    if (_e160 && (select(_e362, _e359, (_e359 > _e362)) <= 1099511600000f)) {
                        let _e368 = (_e365 / 3i);
                        let _e375 = bitcast<f32>((bitcast<u32>((_e368 + 127i)) << bitcast<u32>(23i)));
                        let _e382 = bitcast<f32>((bitcast<u32>(((_e365 - (2i * _e368)) + 127i)) << bitcast<u32>(23i)));
                        let _e383 = (((_e145 * _e375) * _e375) * _e382);
                        let _e385 = select(340282350000000000000000000000000000000f, _e383, (_e383 < 340282350000000000000000000000000000000f));
                        let _e390 = (((_e154 * _e375) * _e375) * _e382);
                        let _e392 = select(340282350000000000000000000000000000000f, _e390, (_e390 < 340282350000000000000000000000000000000f));
                        phi_649_ = select(-340282350000000000000000000000000000000f, _e392, (_e392 > -340282350000000000000000000000000000000f));
                        phi_650_ = select(-340282350000000000000000000000000000000f, _e385, (_e385 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_649_ = 0f;
                        phi_650_ = 1f;
                    }
                    let _e396 = phi_649_;
                    let _e398 = phi_650_;
                    local = array<type_23, 8>(type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_2 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2545_ = false;
                    phi_2525_ = _e396;
                    phi_714_ = select(0u, 2147483648u, (_e70 == 0u));
                    phi_717_ = ((3u * _e70) + 1u);
                    phi_719_ = (_e398 <= _e396);
                    phi_721_ = 0u;
                    loop {
                        let _e405 = phi_2545_;
                        let _e407 = phi_2525_;
                        let _e409 = phi_714_;
                        let _e411 = phi_717_;
                        let _e413 = phi_719_;
                        let _e415 = phi_721_;
                        if _e413 {
                            phi_732_ = true;
                        } else {
                            phi_732_ = (_e415 > 0u);
                        }
                        let _e418 = phi_732_;
                        if _e418 {
                            let _e419 = (_e411 > 0u);
                            if _e419 {
                                if _e413 {
                                    phi_765_ = _e409;
                                    phi_766_ = _e413;
                                    phi_767_ = _e415;
                                } else {
                                    let _e420 = (_e415 - 1u);
                                    let _e421 = (_e420 % 128u);
                                    let _e422 = (_e421 < 128u);
                                    if _e422 {
                                    } else {
                                        phi_2680_ = true;
                                        break;
                                    }
                                    let _e424 = local_2[_e421];
                                    if _e422 {
                                    } else {
                                        phi_2680_ = true;
                                        break;
                                    }
                                    let _e426 = local_1[_e421];
                                    phi_765_ = _e424;
                                    phi_766_ = (_e426 <= _e407);
                                    phi_767_ = _e420;
                                }
                                let _e429 = phi_765_;
                                let _e431 = phi_766_;
                                let _e433 = phi_767_;
                                if _e431 {
                                    if ((_e429 & 2147483648u) != 0u) {
                                        phi_2542_ = _e405;
                                        phi_2532_ = _e407;
                                        phi_782_ = type_4(0u, ((_e429 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e630 = phi_2542_;
                                            let _e632 = phi_2532_;
                                            let _e634 = phi_782_;
                                            if (_e634.member < _e634.member_1) {
                                                phi_783_ = type_4((_e634.member + 1u), _e634.member_1);
                                                phi_806_ = type_4(1u, _e634.member);
                                            } else {
                                                phi_783_ = _e634;
                                                phi_806_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e647 = phi_783_;
                                            let _e649 = phi_806_;
                                            let _e653 = (bitcast<i32>(_e649.member) != 0i);
                                            if _e653 {
                                                let _e654 = ((_e429 & 268435455u) + _e649.member_1);
                                                let _e655 = (_e654 < _e72);
                                                if _e655 {
                                                    if _e655 {
                                                    } else {
                                                        phi_2765_ = _e632;
                                                        phi_2675_ = true;
                                                        break;
                                                    }
                                                    let _e659 = global_3.member[_e654].member_1;
                                                    phi_827_ = _e659;
                                                } else {
                                                    phi_827_ = 4294967295u;
                                                }
                                                let _e661 = phi_827_;
                                                if (_e654 >= _e72) {
                                                    phi_916_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e655 {
                                                    } else {
                                                        phi_2765_ = _e632;
                                                        phi_2675_ = true;
                                                        break;
                                                    }
                                                    let _e663 = (_e198 % 3u);
                                                    let _e664 = (_e197 % 3u);
                                                    let _e665 = (_e199 % 3u);
                                                    if (_e663 < 9u) {
                                                    } else {
                                                        phi_2765_ = _e632;
                                                        phi_2675_ = true;
                                                        break;
                                                    }
                                                    let _e671 = global_3.member[_e654].member[_e663];
                                                    if (_e664 < 9u) {
                                                    } else {
                                                        phi_2765_ = _e632;
                                                        phi_2675_ = true;
                                                        break;
                                                    }
                                                    let _e677 = global_3.member[_e654].member[_e664];
                                                    if (_e665 < 9u) {
                                                    } else {
                                                        phi_2765_ = _e632;
                                                        phi_2675_ = true;
                                                        break;
                                                    }
                                                    let _e683 = global_3.member[_e654].member[_e665];
                                                    let _e685 = (3u + _e663);
                                                    if (_e685 < 9u) {
                                                    } else {
                                                        phi_2765_ = _e632;
                                                        phi_2675_ = true;
                                                        break;
                                                    }
                                                    let _e691 = global_3.member[_e654].member[_e685];
                                                    let _e692 = (3u + _e664);
                                                    if (_e692 < 9u) {
                                                    } else {
                                                        phi_2765_ = _e632;
                                                        phi_2675_ = true;
                                                        break;
                                                    }
                                                    let _e698 = global_3.member[_e654].member[_e692];
                                                    let _e699 = (3u + _e665);
                                                    if (_e699 < 9u) {
                                                    } else {
                                                        phi_2765_ = _e632;
                                                        phi_2675_ = true;
                                                        break;
                                                    }
                                                    let _e705 = global_3.member[_e654].member[_e699];
                                                    let _e707 = (6u + _e663);
                                                    if (_e707 < 9u) {
                                                    } else {
                                                        phi_2765_ = _e632;
                                                        phi_2675_ = true;
                                                        break;
                                                    }
                                                    let _e713 = global_3.member[_e654].member[_e707];
                                                    let _e714 = (6u + _e664);
                                                    if (_e714 < 9u) {
                                                    } else {
                                                        phi_2765_ = _e632;
                                                        phi_2675_ = true;
                                                        break;
                                                    }
                                                    let _e720 = global_3.member[_e654].member[_e714];
                                                    let _e721 = (6u + _e665);
                                                    if (_e721 < 9u) {
                                                    } else {
                                                        phi_2765_ = _e632;
                                                        phi_2675_ = true;
                                                        break;
                                                    }
                                                    let _e727 = global_3.member[_e654].member[_e721];
                                                    phi_916_ = array<array<f32, 3>, 3>(array<f32, 3>(_e671, _e677, _e683), array<f32, 3>(_e691, _e698, _e705), array<f32, 3>(_e713, _e720, _e727));
                                                }
                                                let _e731 = phi_916_;
                                                let _e738 = (_e731[0][2] - _e324);
                                                let _e741 = (((_e731[0][0] - _e247) * _e348) - (_e738 * _e272));
                                                let _e744 = (((_e731[0][1] - _e286) * _e348) - (_e738 * _e310));
                                                let _e751 = (_e731[1][2] - _e324);
                                                let _e754 = (((_e731[1][0] - _e247) * _e348) - (_e751 * _e272));
                                                let _e757 = (((_e731[1][1] - _e286) * _e348) - (_e751 * _e310));
                                                let _e764 = (_e731[2][2] - _e324);
                                                let _e767 = (((_e731[2][0] - _e247) * _e348) - (_e764 * _e272));
                                                let _e770 = (((_e731[2][1] - _e286) * _e348) - (_e764 * _e310));
                                                let _e771 = (_e767 * _e757);
                                                let _e772 = (_e770 * _e754);
                                                let _e773 = (_e741 * _e770);
                                                let _e774 = (_e744 * _e767);
                                                let _e775 = (_e754 * _e744);
                                                let _e776 = (_e757 * _e741);
                                                let _e781 = (((_e771 >= _e772) && (_e773 >= _e774)) && (_e775 >= _e776));
                                                if (_e781 || (((_e771 <= _e772) && (_e773 <= _e774)) && (_e775 <= _e776))) {
                                                    let _e788 = select(-1f, 1f, _e781);
                                                    let _e790 = ((_e771 - _e772) * _e788);
                                                    let _e792 = select(0f, _e790, (_e790 > 0f));
                                                    let _e794 = ((_e773 - _e774) * _e788);
                                                    let _e796 = select(0f, _e794, (_e794 > 0f));
                                                    let _e798 = ((_e775 - _e776) * _e788);
                                                    let _e800 = select(0f, _e798, (_e798 > 0f));
                                                    let _e802 = ((_e792 + _e796) + _e800);
                                                    if (_e802 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1745_ = type_23();
                                                        phi_1746_ = true;
                                                        phi_1747_ = false;
                                                    } else {
                                                        let _e805 = select(_e754, _e741, (_e741 < _e754));
                                                        if (select(_e767, _e805, (_e805 < _e767)) > 0f) {
                                                            phi_1034_ = true;
                                                        } else {
                                                            let _e810 = select(_e754, _e741, (_e741 > _e754));
                                                            phi_1034_ = (select(_e767, _e810, (_e810 > _e767)) < 0f);
                                                        }
                                                        let _e815 = phi_1034_;
                                                        if _e815 {
                                                            phi_1742_ = type_23();
                                                            phi_1743_ = true;
                                                            phi_1744_ = false;
                                                        } else {
                                                            let _e817 = select(_e757, _e744, (_e744 < _e757));
                                                            if (select(_e770, _e817, (_e817 < _e770)) > 0f) {
                                                                phi_1063_ = true;
                                                            } else {
                                                                let _e822 = select(_e757, _e744, (_e744 > _e757));
                                                                phi_1063_ = (select(_e770, _e822, (_e822 > _e770)) < 0f);
                                                            }
                                                            let _e827 = phi_1063_;
                                                            if _e827 {
                                                                phi_1740_ = type_23();
                                                                phi_1741_ = false;
                                                            } else {
                                                                let _e829 = select(_e731[1][0], _e731[0][0], (_e731[0][0] < _e731[1][0]));
                                                                let _e833 = select(_e731[1][0], _e731[0][0], (_e731[0][0] > _e731[1][0]));
                                                                let _e837 = select(_e731[1][1], _e731[0][1], (_e731[0][1] < _e731[1][1]));
                                                                let _e841 = select(_e731[1][1], _e731[0][1], (_e731[0][1] > _e731[1][1]));
                                                                let _e845 = select(_e731[1][2], _e731[0][2], (_e731[0][2] < _e731[1][2]));
                                                                let _e849 = select(_e731[1][2], _e731[0][2], (_e731[0][2] > _e731[1][2]));
                                                                let _e854 = ((select(_e731[2][0], _e829, (_e829 < _e731[2][0])) - _e270) * _e275);
                                                                let _e855 = ((select(_e731[2][0], _e833, (_e833 > _e731[2][0])) - _e271) * _e275);
                                                                let _e858 = ((select(_e731[2][1], _e837, (_e837 < _e731[2][1])) - _e308) * _e313);
                                                                let _e859 = ((select(_e731[2][1], _e841, (_e841 > _e731[2][1])) - _e309) * _e313);
                                                                let _e862 = ((select(_e731[2][2], _e845, (_e845 < _e731[2][2])) - _e346) * _e351);
                                                                let _e863 = ((select(_e731[2][2], _e849, (_e849 > _e731[2][2])) - _e347) * _e351);
                                                                let _e865 = select(_e863, _e862, (_e862 < _e863));
                                                                let _e867 = select(_e863, _e862, (_e862 > _e863));
                                                                let _e869 = select(_e855, _e854, (_e854 < _e855));
                                                                let _e871 = select(_e859, _e858, (_e858 < _e859));
                                                                let _e873 = select(_e871, _e869, (_e869 > _e871));
                                                                let _e875 = select(_e865, _e873, (_e873 > _e865));
                                                                let _e877 = select(_e855, _e854, (_e854 > _e855));
                                                                let _e879 = select(_e859, _e858, (_e858 > _e859));
                                                                let _e881 = select(_e879, _e877, (_e877 < _e879));
                                                                let _e883 = select(_e867, _e881, (_e881 < _e867));
                                                                let _e884 = -(_e865);
                                                                let _e890 = select(_e398, _e875, (_e875 > _e398));
                                                                if (_e890 > (_e883 + (select(_e884, _e867, (_e867 > _e884)) * 0.0000019073523f))) {
                                                                    phi_1735_ = type_23();
                                                                    phi_1736_ = true;
                                                                } else {
                                                                    let _e892 = (_e890 > _e632);
                                                                    if _e892 {
                                                                        phi_1734_ = type_23();
                                                                    } else {
                                                                        let _e893 = vec3<f32>(_e731[0][0], _e731[0][1], _e731[0][2]);
                                                                        let _e894 = vec3<f32>(_e731[1][0], _e731[1][1], _e731[1][2]);
                                                                        let _e895 = vec3<f32>(_e731[2][0], _e731[2][1], _e731[2][2]);
                                                                        let _e896 = (_e731[1][0] - _e731[0][0]);
                                                                        let _e897 = (_e731[1][1] - _e731[0][1]);
                                                                        let _e898 = (_e731[1][2] - _e731[0][2]);
                                                                        let _e899 = vec3<f32>(_e896, _e897, _e898);
                                                                        let _e900 = (_e731[2][0] - _e731[1][0]);
                                                                        let _e901 = (_e731[2][1] - _e731[1][1]);
                                                                        let _e902 = (_e731[2][2] - _e731[1][2]);
                                                                        let _e903 = vec3<f32>(_e900, _e901, _e902);
                                                                        let _e904 = (_e731[0][0] - _e731[2][0]);
                                                                        let _e905 = (_e731[0][1] - _e731[2][1]);
                                                                        let _e906 = (_e731[0][2] - _e731[2][2]);
                                                                        let _e907 = vec3<f32>(_e904, _e905, _e906);
                                                                        let _e910 = bitcast<f32>((bitcast<u32>(_e896) & 2147483647u));
                                                                        let _e913 = bitcast<f32>((bitcast<u32>(_e897) & 2147483647u));
                                                                        let _e915 = select(_e913, _e910, (_e910 > _e913));
                                                                        let _e918 = bitcast<f32>((bitcast<u32>(_e898) & 2147483647u));
                                                                        let _e920 = select(_e918, _e915, (_e915 > _e918));
                                                                        let _e923 = bitcast<f32>((bitcast<u32>(_e900) & 2147483647u));
                                                                        let _e926 = bitcast<f32>((bitcast<u32>(_e901) & 2147483647u));
                                                                        let _e928 = select(_e926, _e923, (_e923 > _e926));
                                                                        let _e931 = bitcast<f32>((bitcast<u32>(_e902) & 2147483647u));
                                                                        let _e933 = select(_e931, _e928, (_e928 > _e931));
                                                                        let _e936 = bitcast<f32>((bitcast<u32>(_e904) & 2147483647u));
                                                                        let _e939 = bitcast<f32>((bitcast<u32>(_e905) & 2147483647u));
                                                                        let _e941 = select(_e939, _e936, (_e936 > _e939));
                                                                        let _e944 = bitcast<f32>((bitcast<u32>(_e906) & 2147483647u));
                                                                        let _e946 = select(_e944, _e941, (_e941 > _e944));
                                                                        let _e948 = select(_e933, _e920, (_e920 > _e933));
                                                                        let _e950 = select(_e946, _e948, (_e948 > _e946));
                                                                        if (_e920 == _e950) {
                                                                            phi_1464_ = _e757;
                                                                            phi_1465_ = _e754;
                                                                            phi_1466_ = _e744;
                                                                            phi_1467_ = _e741;
                                                                            phi_1468_ = _e893;
                                                                            phi_1469_ = _e907;
                                                                            phi_1470_ = _e903;
                                                                            phi_1471_ = _e899;
                                                                        } else {
                                                                            let _e952 = (_e933 == _e950);
                                                                            let _e957 = vec3(_e952);
                                                                            phi_1464_ = select(_e744, _e770, _e952);
                                                                            phi_1465_ = select(_e741, _e767, _e952);
                                                                            phi_1466_ = select(_e770, _e757, _e952);
                                                                            phi_1467_ = select(_e767, _e754, _e952);
                                                                            phi_1468_ = select(_e895, _e894, _e957);
                                                                            phi_1469_ = select(_e903, _e899, _e957);
                                                                            phi_1470_ = select(_e899, _e907, _e957);
                                                                            phi_1471_ = select(_e907, _e903, _e957);
                                                                        }
                                                                        let _e963 = phi_1464_;
                                                                        let _e965 = phi_1465_;
                                                                        let _e967 = phi_1466_;
                                                                        let _e969 = phi_1467_;
                                                                        let _e971 = phi_1468_;
                                                                        let _e973 = phi_1469_;
                                                                        let _e975 = phi_1470_;
                                                                        let _e977 = phi_1471_;
                                                                        let _e984 = ((_e975.y * _e973.z) - (_e973.y * _e975.z));
                                                                        let _e989 = ((_e975.z * _e973.x) - (_e973.z * _e975.x));
                                                                        let _e992 = ((_e975.x * _e973.y) - (_e973.x * _e975.y));
                                                                        if (_e792 >= _e796) {
                                                                            phi_1502_ = select(true, false, (_e792 >= _e800));
                                                                        } else {
                                                                            phi_1502_ = true;
                                                                        }
                                                                        let _e997 = phi_1502_;
                                                                        if _e997 {
                                                                            phi_1511_ = select(_e895, _e894, vec3((_e796 >= _e800)));
                                                                        } else {
                                                                            phi_1511_ = _e893;
                                                                        }
                                                                        let _e1002 = phi_1511_;
                                                                        let _e1007 = (((_e984 * _e272) + (_e989 * _e310)) + (_e992 * _e348));
                                                                        let _e1018 = (((_e984 * (_e1002.x - _e247)) + (_e989 * (_e1002.y - _e286))) + (_e992 * (_e1002.z - _e324)));
                                                                        let _e1020 = (_e965 - _e969);
                                                                        let _e1021 = (_e963 - _e967);
                                                                        let _e1029 = (-(((_e969 * _e1020) + (_e967 * _e1021))) / ((_e1020 * _e1020) + (_e1021 * _e1021)));
                                                                        let _e1031 = select(1f, _e1029, (_e1029 < 1f));
                                                                        let _e1033 = select(0f, _e1031, (_e1031 > 0f));
                                                                        let _e1046 = ((_e971.x + (_e977.x * _e1033)) - _e247);
                                                                        let _e1047 = ((_e971.y + (_e977.y * _e1033)) - _e286);
                                                                        let _e1048 = ((_e971.z + (_e977.z * _e1033)) - _e324);
                                                                        let _e1049 = (_e1048 / _e348);
                                                                        let _e1061 = bitcast<f32>((bitcast<u32>(_e1046) & 2147483647u));
                                                                        let _e1064 = bitcast<f32>((bitcast<u32>(_e1047) & 2147483647u));
                                                                        let _e1066 = select(_e1064, _e1061, (_e1061 > _e1064));
                                                                        let _e1069 = bitcast<f32>((bitcast<u32>(_e1048) & 2147483647u));
                                                                        let _e1071 = select(_e1069, _e1066, (_e1066 > _e1069));
                                                                        let _e1077 = bitcast<f32>((bitcast<u32>(_e984) & 2147483647u));
                                                                        let _e1080 = bitcast<f32>((bitcast<u32>(_e989) & 2147483647u));
                                                                        let _e1082 = select(_e1080, _e1077, (_e1077 > _e1080));
                                                                        let _e1085 = bitcast<f32>((bitcast<u32>(_e992) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e984 * _e1046) + (_e989 * _e1047)) + (_e992 * _e1048)) - _e1018)) & 2147483647u)) <= ((0.0000009536743f * select(_e950, _e1071, (_e1071 > _e950))) * select(_e1085, _e1082, (_e1082 > _e1085)))) {
                                                                            let _e1095 = bitcast<f32>((bitcast<u32>(_e975.x) & 2147483647u));
                                                                            let _e1098 = bitcast<f32>((bitcast<u32>(_e975.y) & 2147483647u));
                                                                            let _e1100 = select(_e1098, _e1095, (_e1095 > _e1098));
                                                                            let _e1103 = bitcast<f32>((bitcast<u32>(_e975.z) & 2147483647u));
                                                                            let _e1109 = bitcast<f32>((bitcast<u32>(_e973.x) & 2147483647u));
                                                                            let _e1112 = bitcast<f32>((bitcast<u32>(_e973.y) & 2147483647u));
                                                                            let _e1114 = select(_e1112, _e1109, (_e1109 > _e1112));
                                                                            let _e1117 = bitcast<f32>((bitcast<u32>(_e973.z) & 2147483647u));
                                                                            phi_1678_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1007) & 2147483647u)) > ((0.0000038146973f * select(_e1103, _e1100, (_e1100 > _e1103))) * select(_e1117, _e1114, (_e1114 > _e1117)))));
                                                                        } else {
                                                                            phi_1678_ = true;
                                                                        }
                                                                        let _e1124 = phi_1678_;
                                                                        if _e1124 {
                                                                            let _e1135 = ((((_e984 * (_e1046 - (_e272 * _e1049))) + (_e989 * (_e1047 - (_e310 * _e1049)))) + (_e992 * (_e1048 - _e1048))) / _e1007);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1135) & 2147483647u)) <= _e950) {
                                                                                phi_1702_ = (_e1049 + _e1135);
                                                                            } else {
                                                                                phi_1702_ = _e1049;
                                                                            }
                                                                            let _e1142 = phi_1702_;
                                                                            phi_1703_ = _e1142;
                                                                        } else {
                                                                            phi_1703_ = (_e1018 / _e1007);
                                                                        }
                                                                        let _e1144 = phi_1703_;
                                                                        let _e1146 = select(_e883, _e1144, (_e1144 < _e883));
                                                                        let _e1148 = select(_e875, _e1146, (_e1146 > _e875));
                                                                        if (_e1148 >= _e398) {
                                                                            let _e1150 = (_e1148 <= _e632);
                                                                            if _e1150 {
                                                                                let _e1151 = (1f / _e802);
                                                                                phi_1726_ = type_23(_e1148, (_e796 * _e1151), (_e800 * _e1151), _e661);
                                                                            } else {
                                                                                phi_1726_ = type_23();
                                                                            }
                                                                            let _e1156 = phi_1726_;
                                                                            phi_1728_ = _e1156;
                                                                            phi_1729_ = select(true, false, _e1150);
                                                                        } else {
                                                                            phi_1728_ = type_23();
                                                                            phi_1729_ = true;
                                                                        }
                                                                        let _e1159 = phi_1728_;
                                                                        let _e1161 = phi_1729_;
                                                                        if _e1161 {
                                                                            phi_1733_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1733_ = _e1159;
                                                                        }
                                                                        let _e1163 = phi_1733_;
                                                                        phi_1734_ = _e1163;
                                                                    }
                                                                    let _e1165 = phi_1734_;
                                                                    phi_1735_ = _e1165;
                                                                    phi_1736_ = _e892;
                                                                }
                                                                let _e1167 = phi_1735_;
                                                                let _e1169 = phi_1736_;
                                                                phi_1740_ = _e1167;
                                                                phi_1741_ = _e1169;
                                                            }
                                                            let _e1171 = phi_1740_;
                                                            let _e1173 = phi_1741_;
                                                            phi_1742_ = _e1171;
                                                            phi_1743_ = _e827;
                                                            phi_1744_ = _e1173;
                                                        }
                                                        let _e1175 = phi_1742_;
                                                        let _e1177 = phi_1743_;
                                                        let _e1179 = phi_1744_;
                                                        phi_1745_ = _e1175;
                                                        phi_1746_ = _e1177;
                                                        phi_1747_ = _e1179;
                                                    }
                                                    let _e1181 = phi_1745_;
                                                    let _e1183 = phi_1746_;
                                                    let _e1185 = phi_1747_;
                                                    phi_1755_ = _e1181;
                                                    phi_1756_ = select(_e1185, true, _e1183);
                                                } else {
                                                    phi_1755_ = type_23();
                                                    phi_1756_ = true;
                                                }
                                                let _e1188 = phi_1755_;
                                                let _e1190 = phi_1756_;
                                                if _e1190 {
                                                    phi_1760_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1760_ = _e1188;
                                                }
                                                let _e1192 = phi_1760_;
                                                if (_e1192.member_3 != 4294967295u) {
                                                    if (_e661 != 4294967295u) {
                                                        phi_1772_ = type_4(0u, 8u);
                                                        phi_1775_ = _e1192;
                                                        loop {
                                                            let _e1197 = phi_1772_;
                                                            let _e1199 = phi_1775_;
                                                            if (_e1197.member < _e1197.member_1) {
                                                                phi_1773_ = type_4((_e1197.member + 1u), _e1197.member_1);
                                                                phi_1798_ = type_4(1u, _e1197.member);
                                                            } else {
                                                                phi_1773_ = _e1197;
                                                                phi_1798_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1212 = phi_1773_;
                                                            let _e1214 = phi_1798_;
                                                            let _e1218 = (bitcast<i32>(_e1214.member) != 0i);
                                                            if _e1218 {
                                                                let _e1219 = (_e1214.member_1 < 8u);
                                                                if _e1219 {
                                                                } else {
                                                                    phi_2533_ = true;
                                                                    break;
                                                                }
                                                                let _e1224 = local[_e1214.member_1].member;
                                                                if (_e1199.member < _e1224) {
                                                                    phi_1831_ = true;
                                                                } else {
                                                                    let _e1226 = local[_e1214.member_1].member;
                                                                    if (_e1199.member == _e1226) {
                                                                        let _e1231 = local[_e1214.member_1].member_3;
                                                                        phi_1830_ = (_e1199.member_3 < _e1231);
                                                                    } else {
                                                                        phi_1830_ = false;
                                                                    }
                                                                    let _e1234 = phi_1830_;
                                                                    phi_1831_ = _e1234;
                                                                }
                                                                let _e1236 = phi_1831_;
                                                                if _e1236 {
                                                                    if _e1219 {
                                                                    } else {
                                                                        phi_2533_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1237 = local[_e1214.member_1];
                                                                    local[_e1214.member_1] = type_23(_e1199.member, _e1199.member_1, _e1199.member_2, _e1199.member_3);
                                                                    phi_1852_ = type_23(_e1237.member, _e1237.member_1, _e1237.member_2, _e1237.member_3);
                                                                } else {
                                                                    phi_1852_ = _e1199;
                                                                }
                                                                let _e1248 = phi_1852_;
                                                                phi_1776_ = _e1248;
                                                            } else {
                                                                phi_1776_ = type_23();
                                                            }
                                                            let _e1250 = phi_1776_;
                                                            continue;
                                                            continuing {
                                                                phi_1772_ = _e1212;
                                                                phi_1775_ = _e1250;
                                                                phi_2533_ = _e630;
                                                                break if !(_e1218);
                                                            }
                                                        }
                                                        let _e1253 = phi_2533_;
                                                        phi_2765_ = _e632;
                                                        phi_2675_ = _e1253;
                                                        if _e1253 {
                                                            break;
                                                        }
                                                        let _e1256 = local[7u].member_3;
                                                        if (_e1256 != 4294967295u) {
                                                            let _e1260 = local[7u].member;
                                                            phi_2856_ = _e1260;
                                                        } else {
                                                            phi_2856_ = _e632;
                                                        }
                                                        let _e1262 = phi_2856_;
                                                        phi_2855_ = _e1262;
                                                        phi_2678_ = _e1253;
                                                    } else {
                                                        phi_2855_ = _e632;
                                                        phi_2678_ = _e630;
                                                    }
                                                    let _e1264 = phi_2855_;
                                                    let _e1266 = phi_2678_;
                                                    phi_2854_ = _e1264;
                                                    phi_2677_ = _e1266;
                                                } else {
                                                    phi_2854_ = _e632;
                                                    phi_2677_ = _e630;
                                                }
                                                let _e1268 = phi_2854_;
                                                let _e1270 = phi_2677_;
                                                phi_2853_ = _e1268;
                                                phi_2676_ = _e1270;
                                            } else {
                                                phi_2853_ = _e632;
                                                phi_2676_ = _e630;
                                            }
                                            let _e1272 = phi_2853_;
                                            let _e1274 = phi_2676_;
                                            continue;
                                            continuing {
                                                phi_2542_ = _e1274;
                                                phi_2532_ = _e1272;
                                                phi_782_ = _e647;
                                                phi_2765_ = _e1272;
                                                phi_2675_ = _e1274;
                                                break if !(_e653);
                                            }
                                        }
                                        let _e1277 = phi_2765_;
                                        let _e1279 = phi_2675_;
                                        phi_2680_ = _e1279;
                                        if _e1279 {
                                            break;
                                        }
                                        phi_2730_ = _e1277;
                                        phi_2684_ = _e1279;
                                        phi_2319_ = _e429;
                                        phi_2320_ = false;
                                        phi_2321_ = _e433;
                                    } else {
                                        if (_e429 >= _e70) {
                                            phi_1923_ = type_39(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e429 < _e70) {
                                            } else {
                                                phi_2680_ = true;
                                                break;
                                            }
                                            let _e443 = (_e198 % 3u);
                                            if (_e443 < 3u) {
                                            } else {
                                                phi_2680_ = true;
                                                break;
                                            }
                                            let _e449 = global_2.member[_e429].member[_e443];
                                            let _e455 = (_e197 % 3u);
                                            if (_e455 < 3u) {
                                            } else {
                                                phi_2680_ = true;
                                                break;
                                            }
                                            let _e461 = global_2.member[_e429].member[_e455];
                                            let _e467 = (_e199 % 3u);
                                            if (_e467 < 3u) {
                                            } else {
                                                phi_2680_ = true;
                                                break;
                                            }
                                            let _e473 = global_2.member[_e429].member[_e467];
                                            let _e483 = global_2.member[_e429].member_1;
                                            let _e487 = global_2.member[_e429].member_2;
                                            phi_1923_ = type_39(array<vec4<f32>, 3>(vec4<f32>(_e449[0], _e449[1], _e449[2], _e449[3]), vec4<f32>(_e461[0], _e461[1], _e461[2], _e461[3]), vec4<f32>(_e473[0], _e473[1], _e473[2], _e473[3])), _e483, _e487);
                                        }
                                        let _e490 = phi_1923_;
                                        let _e501 = ((_e490.member[0].x - _e270) * _e275);
                                        let _e502 = ((_e490.member[0].y - _e270) * _e275);
                                        let _e503 = ((_e490.member[0].z - _e271) * _e275);
                                        let _e504 = ((_e490.member[0].w - _e271) * _e275);
                                        let _e514 = ((_e490.member[1].x - _e308) * _e313);
                                        let _e515 = ((_e490.member[1].y - _e308) * _e313);
                                        let _e516 = ((_e490.member[1].z - _e309) * _e313);
                                        let _e517 = ((_e490.member[1].w - _e309) * _e313);
                                        let _e527 = ((_e490.member[2].x - _e346) * _e351);
                                        let _e528 = ((_e490.member[2].y - _e346) * _e351);
                                        let _e529 = ((_e490.member[2].z - _e347) * _e351);
                                        let _e530 = ((_e490.member[2].w - _e347) * _e351);
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
                                        let _e582 = select(_e398, _e552, (_e552 > _e398));
                                        let _e584 = select(_e398, _e554, (_e554 > _e398));
                                        let _e589 = (_e582 <= select(_e407, _e579, (_e579 < _e407)));
                                        let _e590 = (_e584 <= select(_e407, _e580, (_e580 < _e407)));
                                        let _e591 = (_e582 <= _e584);
                                        if _e589 {
                                            if _e590 {
                                                if _e591 {
                                                    phi_2268_ = _e490.member_2;
                                                } else {
                                                    phi_2268_ = _e490.member_1;
                                                }
                                                let _e595 = phi_2268_;
                                                let _e598 = (_e433 % 128u);
                                                let _e599 = (_e598 < 128u);
                                                if _e599 {
                                                } else {
                                                    phi_2680_ = true;
                                                    break;
                                                }
                                                local_2[_e598] = _e595;
                                                if _e599 {
                                                } else {
                                                    phi_2680_ = true;
                                                    break;
                                                }
                                                local_1[_e598] = select(_e584, _e582, (_e582 > _e584));
                                                if _e591 {
                                                    phi_2296_ = _e490.member_1;
                                                } else {
                                                    phi_2296_ = _e490.member_2;
                                                }
                                                let _e606 = phi_2296_;
                                                phi_2297_ = _e606;
                                                phi_2298_ = (_e433 + 1u);
                                            } else {
                                                phi_2297_ = u32();
                                                phi_2298_ = u32();
                                            }
                                            let _e608 = phi_2297_;
                                            let _e610 = phi_2298_;
                                            phi_2300_ = _e608;
                                            phi_2301_ = _e610;
                                            phi_2302_ = select(true, false, _e590);
                                        } else {
                                            phi_2300_ = u32();
                                            phi_2301_ = u32();
                                            phi_2302_ = true;
                                        }
                                        let _e613 = phi_2300_;
                                        let _e615 = phi_2301_;
                                        let _e617 = phi_2302_;
                                        if _e617 {
                                            if _e589 {
                                                phi_2311_ = _e490.member_1;
                                            } else {
                                                phi_2311_ = _e490.member_2;
                                            }
                                            let _e621 = phi_2311_;
                                            phi_2316_ = _e621;
                                            phi_2317_ = select(_e590, true, _e589);
                                        } else {
                                            phi_2316_ = _e613;
                                            phi_2317_ = _e431;
                                        }
                                        let _e624 = phi_2316_;
                                        let _e626 = phi_2317_;
                                        phi_2730_ = _e407;
                                        phi_2684_ = _e405;
                                        phi_2319_ = _e624;
                                        phi_2320_ = _e626;
                                        phi_2321_ = select(_e615, _e433, _e617);
                                    }
                                    let _e1281 = phi_2730_;
                                    let _e1283 = phi_2684_;
                                    let _e1285 = phi_2319_;
                                    let _e1287 = phi_2320_;
                                    let _e1289 = phi_2321_;
                                    phi_2729_ = _e1281;
                                    phi_2683_ = _e1283;
                                    phi_2322_ = _e1285;
                                    phi_2323_ = (_e411 - 1u);
                                    phi_2324_ = _e1287;
                                    phi_2325_ = _e1289;
                                } else {
                                    phi_2729_ = _e407;
                                    phi_2683_ = _e405;
                                    phi_2322_ = _e429;
                                    phi_2323_ = _e411;
                                    phi_2324_ = _e431;
                                    phi_2325_ = _e433;
                                }
                                let _e1291 = phi_2729_;
                                let _e1293 = phi_2683_;
                                let _e1295 = phi_2322_;
                                let _e1297 = phi_2323_;
                                let _e1299 = phi_2324_;
                                let _e1301 = phi_2325_;
                                phi_2728_ = _e1291;
                                phi_2682_ = _e1293;
                                phi_2326_ = _e1295;
                                phi_2327_ = _e1297;
                                phi_2328_ = _e1299;
                                phi_2329_ = _e1301;
                            } else {
                                phi_2728_ = _e407;
                                phi_2682_ = _e405;
                                phi_2326_ = u32();
                                phi_2327_ = u32();
                                phi_2328_ = bool();
                                phi_2329_ = u32();
                            }
                            let _e1303 = phi_2728_;
                            let _e1305 = phi_2682_;
                            let _e1307 = phi_2326_;
                            let _e1309 = phi_2327_;
                            let _e1311 = phi_2328_;
                            let _e1313 = phi_2329_;
                            phi_2727_ = _e1303;
                            phi_2681_ = _e1305;
                            phi_715_ = _e1307;
                            phi_718_ = _e1309;
                            phi_720_ = _e1311;
                            phi_722_ = _e1313;
                            phi_2330_ = _e419;
                        } else {
                            phi_2727_ = _e407;
                            phi_2681_ = _e405;
                            phi_715_ = u32();
                            phi_718_ = u32();
                            phi_720_ = bool();
                            phi_722_ = u32();
                            phi_2330_ = false;
                        }
                        let _e1315 = phi_2727_;
                        let _e1317 = phi_2681_;
                        let _e1319 = phi_715_;
                        let _e1321 = phi_718_;
                        let _e1323 = phi_720_;
                        let _e1325 = phi_722_;
                        let _e1327 = phi_2330_;
                        continue;
                        continuing {
                            phi_2545_ = _e1317;
                            phi_2525_ = _e1315;
                            phi_714_ = _e1319;
                            phi_717_ = _e1321;
                            phi_719_ = _e1323;
                            phi_721_ = _e1325;
                            phi_2680_ = _e1317;
                            break if !(_e1327);
                        }
                    }
                    let _e1330 = phi_2680_;
                    if _e1330 {
                        break;
                    }
                    phi_2337_ = type_4(0u, 8u);
                    loop {
                        let _e1332 = phi_2337_;
                        if (_e1332.member < _e1332.member_1) {
                            phi_2338_ = type_4((_e1332.member + 1u), _e1332.member_1);
                            phi_2361_ = type_4(1u, _e1332.member);
                        } else {
                            phi_2338_ = _e1332;
                            phi_2361_ = type_4(0u, type_4().member_1);
                        }
                        let _e1345 = phi_2338_;
                        let _e1347 = phi_2361_;
                        let _e1351 = (bitcast<i32>(_e1347.member) != 0i);
                        if _e1351 {
                            let _e1352 = (_e1347.member_1 < 8u);
                            if _e1352 {
                            } else {
                                phi_2720_ = true;
                                break;
                            }
                            let _e1354 = local[_e1347.member_1];
                            if (_e1354.member_3 != 4294967295u) {
                                let _e1360 = -(_e365);
                                let _e1361 = (_e1360 / 3i);
                                let _e1368 = bitcast<f32>((bitcast<u32>((_e1361 + 127i)) << bitcast<u32>(23i)));
                                let _e1376 = (((_e1354.member * _e1368) * _e1368) * bitcast<f32>((bitcast<u32>(((_e1360 - (2i * _e1361)) + 127i)) << bitcast<u32>(23i))));
                                let _e1378 = select(340282350000000000000000000000000000000f, _e1376, (_e1376 < 340282350000000000000000000000000000000f));
                                phi_2427_ = type_23(select(-340282350000000000000000000000000000000f, _e1378, (_e1378 > -340282350000000000000000000000000000000f)), _e1354.member_1, _e1354.member_2, _e1354.member_3);
                            } else {
                                phi_2427_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1383 = phi_2427_;
                            if _e1352 {
                            } else {
                                phi_2720_ = true;
                                break;
                            }
                            local[_e1347.member_1] = type_23(_e1383.member, _e1383.member_1, _e1383.member_2, _e1383.member_3);
                        }
                        continue;
                        continuing {
                            phi_2337_ = _e1345;
                            phi_2720_ = _e1330;
                            break if !(_e1351);
                        }
                    }
                    let _e1391 = phi_2720_;
                    if _e1391 {
                        break;
                    }
                    let _e1392 = local;
                    if _e86 {
                    } else {
                        break;
                    }
                    global_5.member[_e80] = array<type_23, 8>(type_23(_e1392[0].member, _e1392[0].member_1, _e1392[0].member_2, _e1392[0].member_3), type_23(_e1392[1].member, _e1392[1].member_1, _e1392[1].member_2, _e1392[1].member_3), type_23(_e1392[2].member, _e1392[2].member_1, _e1392[2].member_2, _e1392[2].member_3), type_23(_e1392[3].member, _e1392[3].member_1, _e1392[3].member_2, _e1392[3].member_3), type_23(_e1392[4].member, _e1392[4].member_1, _e1392[4].member_2, _e1392[4].member_3), type_23(_e1392[5].member, _e1392[5].member_1, _e1392[5].member_2, _e1392[5].member_3), type_23(_e1392[6].member, _e1392[6].member_1, _e1392[6].member_2, _e1392[6].member_3), type_23(_e1392[7].member, _e1392[7].member_1, _e1392[7].member_2, _e1392[7].member_3));
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
