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
    var phi_266_: i32;
    var phi_267_: i32;
    var phi_277_: bool;
    var phi_287_: u32;
    var phi_288_: u32;
    var phi_290_: bool;
    var phi_295_: u32;
    var phi_307_: i32;
    var phi_327_: i32;
    var phi_345_: f32;
    var phi_351_: f32;
    var phi_362_: f32;
    var phi_368_: f32;
    var phi_391_: f32;
    var phi_402_: f32;
    var phi_411_: f32;
    var phi_417_: f32;
    var phi_428_: f32;
    var phi_434_: f32;
    var phi_457_: f32;
    var phi_468_: f32;
    var phi_477_: f32;
    var phi_483_: f32;
    var phi_494_: f32;
    var phi_500_: f32;
    var phi_523_: f32;
    var phi_534_: f32;
    var phi_634_: f32;
    var phi_635_: f32;
    var phi_1942_: bool;
    var phi_646_: type_46;
    var phi_649_: u32;
    var phi_651_: u32;
    var phi_653_: bool;
    var phi_655_: u32;
    var phi_666_: bool;
    var phi_698_: u32;
    var phi_699_: bool;
    var phi_700_: u32;
    var phi_1500_: type_42;
    var phi_1844_: u32;
    var phi_1872_: u32;
    var phi_1873_: u32;
    var phi_1874_: u32;
    var phi_1876_: u32;
    var phi_1877_: u32;
    var phi_1878_: bool;
    var phi_1887_: u32;
    var phi_1892_: u32;
    var phi_1893_: bool;
    var phi_715_: type_46;
    var phi_718_: type_7;
    var phi_719_: type_7;
    var phi_741_: type_7;
    var phi_762_: u32;
    var phi_851_: array<array<f32, 3>, 3>;
    var phi_1322_: vec3<f32>;
    var phi_1323_: vec3<f32>;
    var phi_1354_: bool;
    var phi_1363_: vec3<f32>;
    var phi_1403_: type_26;
    var phi_1405_: type_26;
    var phi_1406_: bool;
    var phi_1410_: type_26;
    var phi_1411_: type_26;
    var phi_1412_: type_26;
    var phi_1413_: bool;
    var phi_1417_: type_26;
    var phi_1418_: bool;
    var phi_1422_: type_26;
    var phi_1423_: bool;
    var phi_1427_: type_26;
    var phi_1438_: type_46;
    var phi_1439_: type_46;
    var phi_716_: type_46;
    var phi_1936_: bool;
    var local_2: type_46;
    var phi_2051_: bool;
    var phi_1895_: type_46;
    var phi_1896_: u32;
    var phi_1897_: bool;
    var phi_1898_: u32;
    var phi_2050_: bool;
    var phi_1899_: type_46;
    var phi_1900_: u32;
    var phi_1901_: u32;
    var phi_1902_: bool;
    var phi_1903_: u32;
    var phi_2049_: bool;
    var phi_1904_: type_46;
    var phi_1905_: u32;
    var phi_1906_: u32;
    var phi_1907_: bool;
    var phi_1908_: u32;
    var phi_2048_: bool;
    var phi_647_: type_46;
    var phi_650_: u32;
    var phi_652_: u32;
    var phi_654_: bool;
    var phi_656_: u32;
    var phi_1909_: bool;
    var phi_2047_: bool;
    var local_3: type_46;
    var local_4: type_46;

    switch bitcast<i32>(0u) {
        default: {
            let _e62 = global;
            let _e64 = arrayLength((&global_2.member));
            let _e66 = arrayLength((&global_3.member));
            let _e74 = (_e62.x + (_e62.y * 2097152u));
            let _e77 = global_1.member[0u];
            let _e78 = bitcast<i32>(_e77);
            let _e79 = (_e74 < arrayLength((&global_4.member)));
            if _e79 {
                let _e80 = (_e74 < arrayLength((&global_5.member)));
                if _e80 {
                    if _e79 {
                    } else {
                        break;
                    }
                    let _e88 = global_4.member[_e74].member_2[0u];
                    let _e90 = (bitcast<u32>(_e88) & 2147483647u);
                    let _e95 = global_4.member[_e74].member_2[1u];
                    let _e97 = (bitcast<u32>(_e95) & 2147483647u);
                    let _e102 = global_4.member[_e74].member_2[2u];
                    let _e104 = (bitcast<u32>(_e102) & 2147483647u);
                    let _e109 = global_4.member[_e74].member[0u];
                    let _e111 = (bitcast<u32>(_e109) & 2147483647u);
                    let _e116 = global_4.member[_e74].member[1u];
                    let _e118 = (bitcast<u32>(_e116) & 2147483647u);
                    let _e123 = global_4.member[_e74].member[2u];
                    let _e125 = (bitcast<u32>(_e123) & 2147483647u);
                    let _e127 = select(_e97, _e90, (_e97 < _e90));
                    let _e129 = select(_e104, _e127, (_e104 < _e127));
                    let _e131 = select(_e111, _e129, (_e111 < _e129));
                    let _e133 = select(_e118, _e131, (_e118 < _e131));
                    let _e135 = select(_e125, _e133, (_e125 < _e133));
                    let _e139 = global_4.member[_e74].member_1;
                    let _e141 = (bitcast<u32>(_e139) & 2147483647u);
                    let _e148 = global_4.member[_e74].member_3;
                    let _e154 = (((select(_e141, _e135, (_e141 < _e135)) < 2139095040u) && ((bitcast<u32>(_e148) & 2147483647u) <= 2139095040u)) && (_e129 > 0u));
                    if _e154 {
                        let _e157 = (bitcast<u32>(bitcast<f32>(_e129)) & 2147483647u);
                        if (_e157 >= 8388608u) {
                            phi_266_ = (bitcast<i32>((_e157 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_266_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e157)), 32u, (_e157 == 0u))));
                        }
                        let _e171 = phi_266_;
                        phi_267_ = _e171;
                    } else {
                        phi_267_ = 0i;
                    }
                    let _e173 = phi_267_;
                    let _e174 = (_e90 == _e129);
                    if _e174 {
                        phi_277_ = true;
                    } else {
                        phi_277_ = (_e97 == _e129);
                    }
                    let _e177 = phi_277_;
                    let _e178 = select(1u, 0u, _e174);
                    if _e177 {
                        let _e179 = (_e178 + 1u);
                        phi_287_ = _e179;
                        phi_288_ = _e179;
                        phi_290_ = select(true, false, (_e179 == 2u));
                    } else {
                        phi_287_ = u32();
                        phi_288_ = 0u;
                        phi_290_ = true;
                    }
                    let _e183 = phi_287_;
                    let _e185 = phi_288_;
                    let _e187 = phi_290_;
                    if _e187 {
                        phi_295_ = (_e185 + 1u);
                    } else {
                        phi_295_ = 0u;
                    }
                    let _e191 = phi_295_;
                    let _e192 = select(_e183, _e185, _e187);
                    let _e193 = select(_e178, select(2u, _e178, _e177), _e187);
                    if (_e78 < -126i) {
                        phi_307_ = -126i;
                    } else {
                        phi_307_ = select(_e78, 127i, (_e78 > 127i));
                    }
                    let _e198 = phi_307_;
                    let _e203 = bitcast<f32>((bitcast<u32>((_e198 + 127i)) << bitcast<u32>(23i)));
                    let _e209 = bitcast<f32>((bitcast<u32>(((_e78 - _e198) + 127i)) << bitcast<u32>(23i)));
                    let _e210 = -(_e173);
                    if (_e210 < -126i) {
                        phi_327_ = -126i;
                    } else {
                        phi_327_ = select(_e210, 127i, (_e210 > 127i));
                    }
                    let _e215 = phi_327_;
                    let _e220 = bitcast<f32>((bitcast<u32>((_e215 + 127i)) << bitcast<u32>(23i)));
                    let _e226 = bitcast<f32>((bitcast<u32>(((_e210 - _e215) + 127i)) << bitcast<u32>(23i)));
                    let _e230 = global_4.member[_e74].member;
                    let _e231 = (_e192 == 0u);
                    if _e231 {
                        phi_345_ = _e230[0];
                    } else {
                        phi_345_ = _e230[1];
                    }
                    let _e235 = phi_345_;
                    let _e236 = (_e192 == 2u);
                    if _e236 {
                        phi_351_ = _e230[2];
                    } else {
                        phi_351_ = _e235;
                    }
                    let _e239 = phi_351_;
                    let _e241 = ((_e239 * _e203) * _e209);
                    let _e242 = global_4.member[_e74].member_2;
                    if _e231 {
                        phi_362_ = _e242[0];
                    } else {
                        phi_362_ = _e242[1];
                    }
                    let _e246 = phi_362_;
                    if _e236 {
                        phi_368_ = _e242[2];
                    } else {
                        phi_368_ = _e246;
                    }
                    let _e249 = phi_368_;
                    let _e251 = ((_e249 * _e220) * _e226);
                    let _e255 = (bitcast<f32>((bitcast<u32>(_e251) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e255 {
                        let _e259 = (bitcast<f32>((bitcast<u32>(_e241) & 2147483647u)) * 0.00000011920929f);
                        phi_391_ = select(0.00000000000011368684f, _e259, (_e259 > 0.00000000000011368684f));
                    } else {
                        phi_391_ = 0f;
                    }
                    let _e263 = phi_391_;
                    let _e264 = (_e241 + _e263);
                    let _e265 = (_e241 - _e263);
                    let _e266 = select(_e251, 0f, _e255);
                    if _e255 {
                        phi_402_ = 38685626000000000000000000f;
                    } else {
                        phi_402_ = (1f / _e251);
                    }
                    let _e269 = phi_402_;
                    let _e270 = (_e191 == 0u);
                    if _e270 {
                        phi_411_ = _e230[0];
                    } else {
                        phi_411_ = _e230[1];
                    }
                    let _e274 = phi_411_;
                    let _e275 = (_e191 == 2u);
                    if _e275 {
                        phi_417_ = _e230[2];
                    } else {
                        phi_417_ = _e274;
                    }
                    let _e278 = phi_417_;
                    let _e280 = ((_e278 * _e203) * _e209);
                    if _e270 {
                        phi_428_ = _e242[0];
                    } else {
                        phi_428_ = _e242[1];
                    }
                    let _e284 = phi_428_;
                    if _e275 {
                        phi_434_ = _e242[2];
                    } else {
                        phi_434_ = _e284;
                    }
                    let _e287 = phi_434_;
                    let _e289 = ((_e287 * _e220) * _e226);
                    let _e293 = (bitcast<f32>((bitcast<u32>(_e289) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e293 {
                        let _e297 = (bitcast<f32>((bitcast<u32>(_e280) & 2147483647u)) * 0.00000011920929f);
                        phi_457_ = select(0.00000000000011368684f, _e297, (_e297 > 0.00000000000011368684f));
                    } else {
                        phi_457_ = 0f;
                    }
                    let _e301 = phi_457_;
                    let _e302 = (_e280 + _e301);
                    let _e303 = (_e280 - _e301);
                    let _e304 = select(_e289, 0f, _e293);
                    if _e293 {
                        phi_468_ = 38685626000000000000000000f;
                    } else {
                        phi_468_ = (1f / _e289);
                    }
                    let _e307 = phi_468_;
                    let _e308 = (_e193 == 0u);
                    if _e308 {
                        phi_477_ = _e230[0];
                    } else {
                        phi_477_ = _e230[1];
                    }
                    let _e312 = phi_477_;
                    let _e313 = (_e193 == 2u);
                    if _e313 {
                        phi_483_ = _e230[2];
                    } else {
                        phi_483_ = _e312;
                    }
                    let _e316 = phi_483_;
                    let _e318 = ((_e316 * _e203) * _e209);
                    if _e308 {
                        phi_494_ = _e242[0];
                    } else {
                        phi_494_ = _e242[1];
                    }
                    let _e322 = phi_494_;
                    if _e313 {
                        phi_500_ = _e242[2];
                    } else {
                        phi_500_ = _e322;
                    }
                    let _e325 = phi_500_;
                    let _e327 = ((_e325 * _e220) * _e226);
                    let _e331 = (bitcast<f32>((bitcast<u32>(_e327) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e331 {
                        let _e335 = (bitcast<f32>((bitcast<u32>(_e318) & 2147483647u)) * 0.00000011920929f);
                        phi_523_ = select(0.00000000000011368684f, _e335, (_e335 > 0.00000000000011368684f));
                    } else {
                        phi_523_ = 0f;
                    }
                    let _e339 = phi_523_;
                    let _e340 = (_e318 + _e339);
                    let _e341 = (_e318 - _e339);
                    let _e342 = select(_e327, 0f, _e331);
                    if _e331 {
                        phi_534_ = 38685626000000000000000000f;
                    } else {
                        phi_534_ = (1f / _e327);
                    }
                    let _e345 = phi_534_;
                    let _e348 = bitcast<f32>((bitcast<u32>(_e241) & 2147483647u));
                    let _e351 = bitcast<f32>((bitcast<u32>(_e280) & 2147483647u));
                    let _e353 = select(_e351, _e348, (_e348 > _e351));
                    let _e356 = bitcast<f32>((bitcast<u32>(_e318) & 2147483647u));
                    let _e359 = (_e78 + _e173);
                    if (_e154 && (select(_e356, _e353, (_e353 > _e356)) <= 1099511600000f)) {
                        let _e362 = (_e359 / 3i);
                        let _e369 = bitcast<f32>((bitcast<u32>((_e362 + 127i)) << bitcast<u32>(23i)));
                        let _e376 = bitcast<f32>((bitcast<u32>(((_e359 - (2i * _e362)) + 127i)) << bitcast<u32>(23i)));
                        let _e377 = (((_e139 * _e369) * _e369) * _e376);
                        let _e379 = select(340282350000000000000000000000000000000f, _e377, (_e377 < 340282350000000000000000000000000000000f));
                        let _e384 = (((_e148 * _e369) * _e369) * _e376);
                        let _e386 = select(340282350000000000000000000000000000000f, _e384, (_e384 < 340282350000000000000000000000000000000f));
                        phi_634_ = select(-340282350000000000000000000000000000000f, _e386, (_e386 > -340282350000000000000000000000000000000f));
                        phi_635_ = select(-340282350000000000000000000000000000000f, _e379, (_e379 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_634_ = 0f;
                        phi_635_ = 1f;
                    }
                    let _e390 = phi_634_;
                    let _e392 = phi_635_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_1942_ = false;
                    phi_646_ = type_46(_e390, false);
                    phi_649_ = select(0u, 2147483648u, (_e64 == 0u));
                    phi_651_ = ((3u * _e64) + 1u);
                    phi_653_ = (_e392 <= _e390);
                    phi_655_ = 0u;
                    loop {
                        let _e400 = phi_1942_;
                        let _e402 = phi_646_;
                        let _e404 = phi_649_;
                        let _e406 = phi_651_;
                        let _e408 = phi_653_;
                        let _e410 = phi_655_;
                        local_3 = _e402;
                        if _e408 {
                            phi_666_ = true;
                        } else {
                            phi_666_ = (_e410 > 0u);
                        }
                        let _e413 = phi_666_;
                        if _e413 {
                            let _e414 = (_e406 > 0u);
                            if _e414 {
                                if _e408 {
                                    phi_698_ = _e404;
                                    phi_699_ = _e408;
                                    phi_700_ = _e410;
                                } else {
                                    let _e415 = (_e410 - 1u);
                                    let _e416 = (_e415 % 128u);
                                    let _e417 = (_e416 < 128u);
                                    if _e417 {
                                    } else {
                                        phi_2047_ = true;
                                        break;
                                    }
                                    let _e419 = local_1[_e416];
                                    if _e417 {
                                    } else {
                                        phi_2047_ = true;
                                        break;
                                    }
                                    let _e421 = local[_e416];
                                    phi_698_ = _e419;
                                    phi_699_ = (_e421 <= _e402.member);
                                    phi_700_ = _e415;
                                }
                                let _e425 = phi_698_;
                                let _e427 = phi_699_;
                                let _e429 = phi_700_;
                                if _e427 {
                                    if ((_e425 & 2147483648u) != 0u) {
                                        phi_715_ = _e402;
                                        phi_718_ = type_7(0u, ((_e425 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e627 = phi_715_;
                                            let _e629 = phi_718_;
                                            local_2 = _e627;
                                            local_4 = _e627;
                                            if (_e629.member < _e629.member_1) {
                                                phi_719_ = type_7((_e629.member + 1u), _e629.member_1);
                                                phi_741_ = type_7(1u, _e629.member);
                                            } else {
                                                phi_719_ = _e629;
                                                phi_741_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e642 = phi_719_;
                                            let _e644 = phi_741_;
                                            let _e648 = (bitcast<i32>(_e644.member) != 0i);
                                            if _e648 {
                                                let _e649 = ((_e425 & 268435455u) + _e644.member_1);
                                                let _e650 = (_e649 < _e66);
                                                if _e650 {
                                                    if _e650 {
                                                    } else {
                                                        phi_1936_ = true;
                                                        break;
                                                    }
                                                    let _e654 = global_3.member[_e649].member_1;
                                                    phi_762_ = _e654;
                                                } else {
                                                    phi_762_ = 4294967295u;
                                                }
                                                let _e656 = phi_762_;
                                                if (_e649 >= _e66) {
                                                    phi_851_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e650 {
                                                    } else {
                                                        phi_1936_ = true;
                                                        break;
                                                    }
                                                    let _e658 = (_e192 % 3u);
                                                    let _e659 = (_e191 % 3u);
                                                    let _e660 = (_e193 % 3u);
                                                    if (_e658 < 9u) {
                                                    } else {
                                                        phi_1936_ = true;
                                                        break;
                                                    }
                                                    let _e666 = global_3.member[_e649].member[_e658];
                                                    if (_e659 < 9u) {
                                                    } else {
                                                        phi_1936_ = true;
                                                        break;
                                                    }
                                                    let _e672 = global_3.member[_e649].member[_e659];
                                                    if (_e660 < 9u) {
                                                    } else {
                                                        phi_1936_ = true;
                                                        break;
                                                    }
                                                    let _e678 = global_3.member[_e649].member[_e660];
                                                    let _e680 = (3u + _e658);
                                                    if (_e680 < 9u) {
                                                    } else {
                                                        phi_1936_ = true;
                                                        break;
                                                    }
                                                    let _e686 = global_3.member[_e649].member[_e680];
                                                    let _e687 = (3u + _e659);
                                                    if (_e687 < 9u) {
                                                    } else {
                                                        phi_1936_ = true;
                                                        break;
                                                    }
                                                    let _e693 = global_3.member[_e649].member[_e687];
                                                    let _e694 = (3u + _e660);
                                                    if (_e694 < 9u) {
                                                    } else {
                                                        phi_1936_ = true;
                                                        break;
                                                    }
                                                    let _e700 = global_3.member[_e649].member[_e694];
                                                    let _e702 = (6u + _e658);
                                                    if (_e702 < 9u) {
                                                    } else {
                                                        phi_1936_ = true;
                                                        break;
                                                    }
                                                    let _e708 = global_3.member[_e649].member[_e702];
                                                    let _e709 = (6u + _e659);
                                                    if (_e709 < 9u) {
                                                    } else {
                                                        phi_1936_ = true;
                                                        break;
                                                    }
                                                    let _e715 = global_3.member[_e649].member[_e709];
                                                    let _e716 = (6u + _e660);
                                                    if (_e716 < 9u) {
                                                    } else {
                                                        phi_1936_ = true;
                                                        break;
                                                    }
                                                    let _e722 = global_3.member[_e649].member[_e716];
                                                    phi_851_ = array<array<f32, 3>, 3>(array<f32, 3>(_e666, _e672, _e678), array<f32, 3>(_e686, _e693, _e700), array<f32, 3>(_e708, _e715, _e722));
                                                }
                                                let _e726 = phi_851_;
                                                let _e734 = (_e726[0][2] - _e318);
                                                let _e737 = (((_e726[0][0] - _e241) * _e342) - (_e734 * _e266));
                                                let _e740 = (((_e726[0][1] - _e280) * _e342) - (_e734 * _e304));
                                                let _e747 = (_e726[1][2] - _e318);
                                                let _e750 = (((_e726[1][0] - _e241) * _e342) - (_e747 * _e266));
                                                let _e753 = (((_e726[1][1] - _e280) * _e342) - (_e747 * _e304));
                                                let _e760 = (_e726[2][2] - _e318);
                                                let _e763 = (((_e726[2][0] - _e241) * _e342) - (_e760 * _e266));
                                                let _e766 = (((_e726[2][1] - _e280) * _e342) - (_e760 * _e304));
                                                let _e767 = (_e763 * _e753);
                                                let _e768 = (_e766 * _e750);
                                                let _e769 = (_e737 * _e766);
                                                let _e770 = (_e740 * _e763);
                                                let _e771 = (_e750 * _e740);
                                                let _e772 = (_e753 * _e737);
                                                let _e777 = (((_e767 >= _e768) && (_e769 >= _e770)) && (_e771 >= _e772));
                                                if (_e777 || (((_e767 <= _e768) && (_e769 <= _e770)) && (_e771 <= _e772))) {
                                                    let _e784 = select(-1f, 1f, _e777);
                                                    let _e786 = ((_e767 - _e768) * _e784);
                                                    let _e788 = select(0f, _e786, (_e786 > 0f));
                                                    let _e790 = ((_e769 - _e770) * _e784);
                                                    let _e792 = select(0f, _e790, (_e790 > 0f));
                                                    let _e794 = ((_e771 - _e772) * _e784);
                                                    let _e796 = select(0f, _e794, (_e794 > 0f));
                                                    let _e798 = ((_e788 + _e792) + _e796);
                                                    if (_e798 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1417_ = type_26();
                                                        phi_1418_ = true;
                                                    } else {
                                                        let _e801 = select(_e726[1][0], _e726[0][0], (_e726[0][0] < _e726[1][0]));
                                                        let _e805 = select(_e726[1][0], _e726[0][0], (_e726[0][0] > _e726[1][0]));
                                                        let _e809 = select(_e726[1][1], _e726[0][1], (_e726[0][1] < _e726[1][1]));
                                                        let _e813 = select(_e726[1][1], _e726[0][1], (_e726[0][1] > _e726[1][1]));
                                                        let _e817 = select(_e726[1][2], _e726[0][2], (_e726[0][2] < _e726[1][2]));
                                                        let _e821 = select(_e726[1][2], _e726[0][2], (_e726[0][2] > _e726[1][2]));
                                                        let _e826 = ((select(_e726[2][0], _e801, (_e801 < _e726[2][0])) - _e264) * _e269);
                                                        let _e827 = ((select(_e726[2][0], _e805, (_e805 > _e726[2][0])) - _e265) * _e269);
                                                        let _e830 = ((select(_e726[2][1], _e809, (_e809 < _e726[2][1])) - _e302) * _e307);
                                                        let _e831 = ((select(_e726[2][1], _e813, (_e813 > _e726[2][1])) - _e303) * _e307);
                                                        let _e834 = ((select(_e726[2][2], _e817, (_e817 < _e726[2][2])) - _e340) * _e345);
                                                        let _e835 = ((select(_e726[2][2], _e821, (_e821 > _e726[2][2])) - _e341) * _e345);
                                                        let _e837 = select(_e835, _e834, (_e834 < _e835));
                                                        let _e839 = select(_e835, _e834, (_e834 > _e835));
                                                        let _e841 = select(_e827, _e826, (_e826 < _e827));
                                                        let _e843 = select(_e831, _e830, (_e830 < _e831));
                                                        let _e845 = select(_e843, _e841, (_e841 > _e843));
                                                        let _e847 = select(_e837, _e845, (_e845 > _e837));
                                                        let _e849 = select(_e827, _e826, (_e826 > _e827));
                                                        let _e851 = select(_e831, _e830, (_e830 > _e831));
                                                        let _e853 = select(_e851, _e849, (_e849 < _e851));
                                                        let _e855 = select(_e839, _e853, (_e853 < _e839));
                                                        let _e856 = -(_e837);
                                                        let _e862 = select(_e392, _e847, (_e847 > _e392));
                                                        if (_e862 > (_e855 + (select(_e856, _e839, (_e839 > _e856)) * 0.0000019073523f))) {
                                                            phi_1412_ = type_26();
                                                            phi_1413_ = true;
                                                        } else {
                                                            let _e864 = (_e862 > _e627.member);
                                                            if _e864 {
                                                                phi_1411_ = type_26();
                                                            } else {
                                                                let _e868 = (_e726[1][0] - _e726[0][0]);
                                                                let _e869 = (_e726[1][1] - _e726[0][1]);
                                                                let _e870 = (_e726[1][2] - _e726[0][2]);
                                                                let _e871 = vec3<f32>(_e868, _e869, _e870);
                                                                let _e872 = (_e726[2][0] - _e726[1][0]);
                                                                let _e873 = (_e726[2][1] - _e726[1][1]);
                                                                let _e874 = (_e726[2][2] - _e726[1][2]);
                                                                let _e875 = vec3<f32>(_e872, _e873, _e874);
                                                                let _e876 = (_e726[0][0] - _e726[2][0]);
                                                                let _e877 = (_e726[0][1] - _e726[2][1]);
                                                                let _e878 = (_e726[0][2] - _e726[2][2]);
                                                                let _e879 = vec3<f32>(_e876, _e877, _e878);
                                                                let _e882 = bitcast<f32>((bitcast<u32>(_e868) & 2147483647u));
                                                                let _e885 = bitcast<f32>((bitcast<u32>(_e869) & 2147483647u));
                                                                let _e887 = select(_e885, _e882, (_e882 > _e885));
                                                                let _e890 = bitcast<f32>((bitcast<u32>(_e870) & 2147483647u));
                                                                let _e892 = select(_e890, _e887, (_e887 > _e890));
                                                                let _e895 = bitcast<f32>((bitcast<u32>(_e872) & 2147483647u));
                                                                let _e898 = bitcast<f32>((bitcast<u32>(_e873) & 2147483647u));
                                                                let _e900 = select(_e898, _e895, (_e895 > _e898));
                                                                let _e903 = bitcast<f32>((bitcast<u32>(_e874) & 2147483647u));
                                                                let _e905 = select(_e903, _e900, (_e900 > _e903));
                                                                let _e908 = bitcast<f32>((bitcast<u32>(_e876) & 2147483647u));
                                                                let _e911 = bitcast<f32>((bitcast<u32>(_e877) & 2147483647u));
                                                                let _e913 = select(_e911, _e908, (_e908 > _e911));
                                                                let _e916 = bitcast<f32>((bitcast<u32>(_e878) & 2147483647u));
                                                                let _e918 = select(_e916, _e913, (_e913 > _e916));
                                                                let _e920 = select(_e905, _e892, (_e892 > _e905));
                                                                let _e922 = select(_e918, _e920, (_e920 > _e918));
                                                                if (_e892 == _e922) {
                                                                    phi_1322_ = _e875;
                                                                    phi_1323_ = _e879;
                                                                } else {
                                                                    let _e925 = vec3((_e905 == _e922));
                                                                    phi_1322_ = select(_e871, _e879, _e925);
                                                                    phi_1323_ = select(_e875, _e871, _e925);
                                                                }
                                                                let _e929 = phi_1322_;
                                                                let _e931 = phi_1323_;
                                                                let _e938 = ((_e929.y * _e931.z) - (_e931.y * _e929.z));
                                                                let _e943 = ((_e929.z * _e931.x) - (_e931.z * _e929.x));
                                                                let _e946 = ((_e929.x * _e931.y) - (_e931.x * _e929.y));
                                                                if (_e788 >= _e792) {
                                                                    phi_1354_ = select(true, false, (_e788 >= _e796));
                                                                } else {
                                                                    phi_1354_ = true;
                                                                }
                                                                let _e951 = phi_1354_;
                                                                if _e951 {
                                                                    phi_1363_ = select(vec3<f32>(_e726[2][0], _e726[2][1], _e726[2][2]), vec3<f32>(_e726[1][0], _e726[1][1], _e726[1][2]), vec3((_e792 >= _e796)));
                                                                } else {
                                                                    phi_1363_ = vec3<f32>(_e726[0][0], _e726[0][1], _e726[0][2]);
                                                                }
                                                                let _e956 = phi_1363_;
                                                                let _e973 = ((((_e938 * (_e956.x - _e241)) + (_e943 * (_e956.y - _e280))) + (_e946 * (_e956.z - _e318))) / (((_e938 * _e266) + (_e943 * _e304)) + (_e946 * _e342)));
                                                                let _e975 = select(_e855, _e973, (_e973 < _e855));
                                                                let _e977 = select(_e847, _e975, (_e975 > _e847));
                                                                if (_e977 >= _e392) {
                                                                    let _e979 = (_e977 <= _e627.member);
                                                                    if _e979 {
                                                                        let _e980 = (1f / _e798);
                                                                        phi_1403_ = type_26(_e977, (_e792 * _e980), (_e796 * _e980), _e656);
                                                                    } else {
                                                                        phi_1403_ = type_26();
                                                                    }
                                                                    let _e985 = phi_1403_;
                                                                    phi_1405_ = _e985;
                                                                    phi_1406_ = select(true, false, _e979);
                                                                } else {
                                                                    phi_1405_ = type_26();
                                                                    phi_1406_ = true;
                                                                }
                                                                let _e988 = phi_1405_;
                                                                let _e990 = phi_1406_;
                                                                if _e990 {
                                                                    phi_1410_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1410_ = _e988;
                                                                }
                                                                let _e992 = phi_1410_;
                                                                phi_1411_ = _e992;
                                                            }
                                                            let _e994 = phi_1411_;
                                                            phi_1412_ = _e994;
                                                            phi_1413_ = _e864;
                                                        }
                                                        let _e996 = phi_1412_;
                                                        let _e998 = phi_1413_;
                                                        phi_1417_ = _e996;
                                                        phi_1418_ = _e998;
                                                    }
                                                    let _e1000 = phi_1417_;
                                                    let _e1002 = phi_1418_;
                                                    phi_1422_ = _e1000;
                                                    phi_1423_ = _e1002;
                                                } else {
                                                    phi_1422_ = type_26();
                                                    phi_1423_ = true;
                                                }
                                                let _e1004 = phi_1422_;
                                                let _e1006 = phi_1423_;
                                                if _e1006 {
                                                    phi_1427_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1427_ = _e1004;
                                                }
                                                let _e1008 = phi_1427_;
                                                if (_e1008.member_3 != 4294967295u) {
                                                    if (_e656 != 4294967295u) {
                                                        phi_1438_ = type_46(_e627.member, true);
                                                    } else {
                                                        phi_1438_ = _e627;
                                                    }
                                                    let _e1016 = phi_1438_;
                                                    phi_1439_ = _e1016;
                                                } else {
                                                    phi_1439_ = _e627;
                                                }
                                                let _e1018 = phi_1439_;
                                                phi_716_ = _e1018;
                                            } else {
                                                phi_716_ = type_46();
                                            }
                                            let _e1020 = phi_716_;
                                            continue;
                                            continuing {
                                                phi_715_ = _e1020;
                                                phi_718_ = _e642;
                                                phi_1936_ = _e400;
                                                break if !(_e648);
                                            }
                                        }
                                        let _e1023 = phi_1936_;
                                        phi_2047_ = _e1023;
                                        if _e1023 {
                                            break;
                                        }
                                        let _e1025 = local_2;
                                        phi_2051_ = _e1023;
                                        let _e1165 = local_4;
                                        phi_1895_ = _e1165;
                                        phi_1896_ = _e425;
                                        phi_1897_ = false;
                                        phi_1898_ = select(_e429, 0u, _e1025.member_1);
                                    } else {
                                        if (_e425 >= _e64) {
                                            phi_1500_ = type_42(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e425 < _e64) {
                                            } else {
                                                phi_2047_ = true;
                                                break;
                                            }
                                            let _e439 = (_e192 % 3u);
                                            if (_e439 < 3u) {
                                            } else {
                                                phi_2047_ = true;
                                                break;
                                            }
                                            let _e445 = global_2.member[_e425].member[_e439];
                                            let _e451 = (_e191 % 3u);
                                            if (_e451 < 3u) {
                                            } else {
                                                phi_2047_ = true;
                                                break;
                                            }
                                            let _e457 = global_2.member[_e425].member[_e451];
                                            let _e463 = (_e193 % 3u);
                                            if (_e463 < 3u) {
                                            } else {
                                                phi_2047_ = true;
                                                break;
                                            }
                                            let _e469 = global_2.member[_e425].member[_e463];
                                            let _e479 = global_2.member[_e425].member_1;
                                            let _e483 = global_2.member[_e425].member_2;
                                            phi_1500_ = type_42(array<vec4<f32>, 3>(vec4<f32>(_e445[0], _e445[1], _e445[2], _e445[3]), vec4<f32>(_e457[0], _e457[1], _e457[2], _e457[3]), vec4<f32>(_e469[0], _e469[1], _e469[2], _e469[3])), _e479, _e483);
                                        }
                                        let _e486 = phi_1500_;
                                        let _e498 = ((_e486.member[0].x - _e264) * _e269);
                                        let _e499 = ((_e486.member[0].y - _e264) * _e269);
                                        let _e500 = ((_e486.member[0].z - _e265) * _e269);
                                        let _e501 = ((_e486.member[0].w - _e265) * _e269);
                                        let _e511 = ((_e486.member[1].x - _e302) * _e307);
                                        let _e512 = ((_e486.member[1].y - _e302) * _e307);
                                        let _e513 = ((_e486.member[1].z - _e303) * _e307);
                                        let _e514 = ((_e486.member[1].w - _e303) * _e307);
                                        let _e524 = ((_e486.member[2].x - _e340) * _e345);
                                        let _e525 = ((_e486.member[2].y - _e340) * _e345);
                                        let _e526 = ((_e486.member[2].z - _e341) * _e345);
                                        let _e527 = ((_e486.member[2].w - _e341) * _e345);
                                        let _e529 = select(_e526, _e524, (_e524 < _e526));
                                        let _e531 = select(_e527, _e525, (_e525 < _e527));
                                        let _e533 = select(_e526, _e524, (_e524 > _e526));
                                        let _e535 = select(_e527, _e525, (_e525 > _e527));
                                        let _e537 = select(_e500, _e498, (_e498 < _e500));
                                        let _e539 = select(_e501, _e499, (_e499 < _e501));
                                        let _e541 = select(_e513, _e511, (_e511 < _e513));
                                        let _e543 = select(_e514, _e512, (_e512 < _e514));
                                        let _e545 = select(_e541, _e537, (_e537 > _e541));
                                        let _e547 = select(_e543, _e539, (_e539 > _e543));
                                        let _e549 = select(_e529, _e545, (_e545 > _e529));
                                        let _e551 = select(_e531, _e547, (_e547 > _e531));
                                        let _e553 = select(_e500, _e498, (_e498 > _e500));
                                        let _e555 = select(_e501, _e499, (_e499 > _e501));
                                        let _e557 = select(_e513, _e511, (_e511 > _e513));
                                        let _e559 = select(_e514, _e512, (_e512 > _e514));
                                        let _e561 = select(_e557, _e553, (_e553 < _e557));
                                        let _e563 = select(_e559, _e555, (_e555 < _e559));
                                        let _e568 = -(_e529);
                                        let _e569 = -(_e531);
                                        let _e576 = (select(_e533, _e561, (_e561 < _e533)) + (select(_e568, _e533, (_e533 > _e568)) * 0.0000019073523f));
                                        let _e577 = (select(_e535, _e563, (_e563 < _e535)) + (select(_e569, _e535, (_e535 > _e569)) * 0.0000019073523f));
                                        let _e579 = select(_e392, _e549, (_e549 > _e392));
                                        let _e581 = select(_e392, _e551, (_e551 > _e392));
                                        let _e586 = (_e579 <= select(_e402.member, _e576, (_e576 < _e402.member)));
                                        let _e587 = (_e581 <= select(_e402.member, _e577, (_e577 < _e402.member)));
                                        let _e588 = (_e579 <= _e581);
                                        if _e586 {
                                            if _e587 {
                                                if _e588 {
                                                    phi_1844_ = _e486.member_2;
                                                } else {
                                                    phi_1844_ = _e486.member_1;
                                                }
                                                let _e592 = phi_1844_;
                                                let _e595 = (_e429 % 128u);
                                                let _e596 = (_e595 < 128u);
                                                if _e596 {
                                                } else {
                                                    phi_2047_ = true;
                                                    break;
                                                }
                                                local_1[_e595] = _e592;
                                                if _e596 {
                                                } else {
                                                    phi_2047_ = true;
                                                    break;
                                                }
                                                local[_e595] = select(_e581, _e579, (_e579 > _e581));
                                                if _e588 {
                                                    phi_1872_ = _e486.member_1;
                                                } else {
                                                    phi_1872_ = _e486.member_2;
                                                }
                                                let _e603 = phi_1872_;
                                                phi_1873_ = _e603;
                                                phi_1874_ = (_e429 + 1u);
                                            } else {
                                                phi_1873_ = u32();
                                                phi_1874_ = u32();
                                            }
                                            let _e605 = phi_1873_;
                                            let _e607 = phi_1874_;
                                            phi_1876_ = _e605;
                                            phi_1877_ = _e607;
                                            phi_1878_ = select(true, false, _e587);
                                        } else {
                                            phi_1876_ = u32();
                                            phi_1877_ = u32();
                                            phi_1878_ = true;
                                        }
                                        let _e610 = phi_1876_;
                                        let _e612 = phi_1877_;
                                        let _e614 = phi_1878_;
                                        if _e614 {
                                            if _e586 {
                                                phi_1887_ = _e486.member_1;
                                            } else {
                                                phi_1887_ = _e486.member_2;
                                            }
                                            let _e618 = phi_1887_;
                                            phi_1892_ = _e618;
                                            phi_1893_ = select(_e587, true, _e586);
                                        } else {
                                            phi_1892_ = _e610;
                                            phi_1893_ = _e427;
                                        }
                                        let _e621 = phi_1892_;
                                        let _e623 = phi_1893_;
                                        phi_2051_ = _e400;
                                        phi_1895_ = _e402;
                                        phi_1896_ = _e621;
                                        phi_1897_ = _e623;
                                        phi_1898_ = select(_e612, _e429, _e614);
                                    }
                                    let _e1029 = phi_2051_;
                                    let _e1031 = phi_1895_;
                                    let _e1033 = phi_1896_;
                                    let _e1035 = phi_1897_;
                                    let _e1037 = phi_1898_;
                                    phi_2050_ = _e1029;
                                    phi_1899_ = _e1031;
                                    phi_1900_ = _e1033;
                                    phi_1901_ = (_e406 - 1u);
                                    phi_1902_ = _e1035;
                                    phi_1903_ = _e1037;
                                } else {
                                    phi_2050_ = _e400;
                                    phi_1899_ = _e402;
                                    phi_1900_ = _e425;
                                    phi_1901_ = _e406;
                                    phi_1902_ = _e427;
                                    phi_1903_ = _e429;
                                }
                                let _e1039 = phi_2050_;
                                let _e1041 = phi_1899_;
                                let _e1043 = phi_1900_;
                                let _e1045 = phi_1901_;
                                let _e1047 = phi_1902_;
                                let _e1049 = phi_1903_;
                                phi_2049_ = _e1039;
                                phi_1904_ = _e1041;
                                phi_1905_ = _e1043;
                                phi_1906_ = _e1045;
                                phi_1907_ = _e1047;
                                phi_1908_ = _e1049;
                            } else {
                                phi_2049_ = _e400;
                                phi_1904_ = type_46();
                                phi_1905_ = u32();
                                phi_1906_ = u32();
                                phi_1907_ = bool();
                                phi_1908_ = u32();
                            }
                            let _e1051 = phi_2049_;
                            let _e1053 = phi_1904_;
                            let _e1055 = phi_1905_;
                            let _e1057 = phi_1906_;
                            let _e1059 = phi_1907_;
                            let _e1061 = phi_1908_;
                            phi_2048_ = _e1051;
                            phi_647_ = _e1053;
                            phi_650_ = _e1055;
                            phi_652_ = _e1057;
                            phi_654_ = _e1059;
                            phi_656_ = _e1061;
                            phi_1909_ = _e414;
                        } else {
                            phi_2048_ = _e400;
                            phi_647_ = type_46();
                            phi_650_ = u32();
                            phi_652_ = u32();
                            phi_654_ = bool();
                            phi_656_ = u32();
                            phi_1909_ = false;
                        }
                        let _e1063 = phi_2048_;
                        let _e1065 = phi_647_;
                        let _e1067 = phi_650_;
                        let _e1069 = phi_652_;
                        let _e1071 = phi_654_;
                        let _e1073 = phi_656_;
                        let _e1075 = phi_1909_;
                        continue;
                        continuing {
                            phi_1942_ = _e1063;
                            phi_646_ = _e1065;
                            phi_649_ = _e1067;
                            phi_651_ = _e1069;
                            phi_653_ = _e1071;
                            phi_655_ = _e1073;
                            phi_2047_ = _e1063;
                            break if !(_e1075);
                        }
                    }
                    let _e1078 = phi_2047_;
                    if _e1078 {
                        break;
                    }
                    let _e1080 = local_3;
                    if _e80 {
                    } else {
                        break;
                    }
                    global_5.member[_e74] = select(0u, 1u, _e1080.member_1);
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
