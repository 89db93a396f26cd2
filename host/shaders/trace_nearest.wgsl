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
    var phi_276_: i32;
    var phi_277_: i32;
    var phi_287_: bool;
    var phi_297_: u32;
    var phi_298_: u32;
    var phi_300_: bool;
    var phi_305_: u32;
    var phi_317_: i32;
    var phi_337_: i32;
    var phi_355_: f32;
    var phi_361_: f32;
    var phi_372_: f32;
    var phi_378_: f32;
    var phi_401_: f32;
    var phi_412_: f32;
    var phi_421_: f32;
    var phi_427_: f32;
    var phi_438_: f32;
    var phi_444_: f32;
    var phi_467_: f32;
    var phi_478_: f32;
    var phi_487_: f32;
    var phi_493_: f32;
    var phi_504_: f32;
    var phi_510_: f32;
    var phi_533_: f32;
    var phi_544_: f32;
    var phi_644_: f32;
    var phi_645_: f32;
    var phi_2273_: bool;
    var phi_2253_: f32;
    var phi_709_: u32;
    var phi_712_: u32;
    var phi_714_: bool;
    var phi_716_: u32;
    var phi_727_: bool;
    var phi_760_: u32;
    var phi_761_: bool;
    var phi_762_: u32;
    var phi_1651_: type_39;
    var phi_1996_: u32;
    var phi_2024_: u32;
    var phi_2025_: u32;
    var phi_2026_: u32;
    var phi_2028_: u32;
    var phi_2029_: u32;
    var phi_2030_: bool;
    var phi_2039_: u32;
    var phi_2044_: u32;
    var phi_2045_: bool;
    var phi_2270_: bool;
    var phi_2260_: f32;
    var phi_777_: type_4;
    var phi_778_: type_4;
    var phi_801_: type_4;
    var phi_822_: u32;
    var phi_911_: array<array<f32, 3>, 3>;
    var phi_1383_: vec3<f32>;
    var phi_1384_: vec3<f32>;
    var phi_1415_: bool;
    var phi_1424_: vec3<f32>;
    var phi_1464_: type_23;
    var phi_1466_: type_23;
    var phi_1467_: bool;
    var phi_1471_: type_23;
    var phi_1472_: type_23;
    var phi_1473_: type_23;
    var phi_1474_: bool;
    var phi_1478_: type_23;
    var phi_1479_: bool;
    var phi_1483_: type_23;
    var phi_1484_: bool;
    var phi_1488_: type_23;
    var phi_1500_: type_4;
    var phi_1503_: type_23;
    var phi_1501_: type_4;
    var phi_1526_: type_4;
    var phi_1558_: bool;
    var phi_1559_: bool;
    var phi_1580_: type_23;
    var phi_1504_: type_23;
    var phi_2261_: bool;
    var phi_2528_: f32;
    var phi_2527_: f32;
    var phi_2378_: bool;
    var phi_2526_: f32;
    var phi_2377_: bool;
    var phi_2525_: f32;
    var phi_2376_: bool;
    var phi_2465_: f32;
    var phi_2375_: bool;
    var phi_2430_: f32;
    var phi_2384_: bool;
    var phi_2047_: u32;
    var phi_2048_: bool;
    var phi_2049_: u32;
    var phi_2429_: f32;
    var phi_2383_: bool;
    var phi_2050_: u32;
    var phi_2051_: u32;
    var phi_2052_: bool;
    var phi_2053_: u32;
    var phi_2428_: f32;
    var phi_2382_: bool;
    var phi_2054_: u32;
    var phi_2055_: u32;
    var phi_2056_: bool;
    var phi_2057_: u32;
    var phi_2427_: f32;
    var phi_2381_: bool;
    var phi_710_: u32;
    var phi_713_: u32;
    var phi_715_: bool;
    var phi_717_: u32;
    var phi_2058_: bool;
    var phi_2380_: bool;
    var phi_2065_: type_4;
    var phi_2066_: type_4;
    var phi_2089_: type_4;
    var phi_2155_: type_23;
    var phi_2420_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e66 = global;
            let _e68 = arrayLength((&global_2.member));
            let _e70 = arrayLength((&global_3.member));
            let _e78 = (_e66.x + (_e66.y * 2097152u));
            let _e81 = global_1.member[0u];
            let _e82 = bitcast<i32>(_e81);
            let _e83 = (_e78 < arrayLength((&global_4.member)));
            if _e83 {
                let _e84 = (_e78 < arrayLength((&global_5.member)));
                if _e84 {
                    if _e83 {
                    } else {
                        break;
                    }
                    let _e92 = global_4.member[_e78].member_2[0u];
                    let _e94 = (bitcast<u32>(_e92) & 2147483647u);
                    let _e99 = global_4.member[_e78].member_2[1u];
                    let _e101 = (bitcast<u32>(_e99) & 2147483647u);
                    let _e106 = global_4.member[_e78].member_2[2u];
                    let _e108 = (bitcast<u32>(_e106) & 2147483647u);
                    let _e113 = global_4.member[_e78].member[0u];
                    let _e115 = (bitcast<u32>(_e113) & 2147483647u);
                    let _e120 = global_4.member[_e78].member[1u];
                    let _e122 = (bitcast<u32>(_e120) & 2147483647u);
                    let _e127 = global_4.member[_e78].member[2u];
                    let _e129 = (bitcast<u32>(_e127) & 2147483647u);
                    let _e131 = select(_e101, _e94, (_e101 < _e94));
                    let _e133 = select(_e108, _e131, (_e108 < _e131));
                    let _e135 = select(_e115, _e133, (_e115 < _e133));
                    let _e137 = select(_e122, _e135, (_e122 < _e135));
                    let _e139 = select(_e129, _e137, (_e129 < _e137));
                    let _e143 = global_4.member[_e78].member_1;
                    let _e145 = (bitcast<u32>(_e143) & 2147483647u);
                    let _e152 = global_4.member[_e78].member_3;
                    let _e158 = (((select(_e145, _e139, (_e145 < _e139)) < 2139095040u) && ((bitcast<u32>(_e152) & 2147483647u) <= 2139095040u)) && (_e133 > 0u));
                    if _e158 {
                        let _e161 = (bitcast<u32>(bitcast<f32>(_e133)) & 2147483647u);
                        if (_e161 >= 8388608u) {
                            phi_276_ = (bitcast<i32>((_e161 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_276_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e161)), 32u, (_e161 == 0u))));
                        }
                        let _e175 = phi_276_;
                        phi_277_ = _e175;
                    } else {
                        phi_277_ = 0i;
                    }
                    let _e177 = phi_277_;
                    let _e178 = (_e94 == _e133);
                    if _e178 {
                        phi_287_ = true;
                    } else {
                        phi_287_ = (_e101 == _e133);
                    }
                    let _e181 = phi_287_;
                    let _e182 = select(1u, 0u, _e178);
                    if _e181 {
                        let _e183 = (_e182 + 1u);
                        phi_297_ = _e183;
                        phi_298_ = _e183;
                        phi_300_ = select(true, false, (_e183 == 2u));
                    } else {
                        phi_297_ = u32();
                        phi_298_ = 0u;
                        phi_300_ = true;
                    }
                    let _e187 = phi_297_;
                    let _e189 = phi_298_;
                    let _e191 = phi_300_;
                    if _e191 {
                        phi_305_ = (_e189 + 1u);
                    } else {
                        phi_305_ = 0u;
                    }
                    let _e195 = phi_305_;
                    let _e196 = select(_e187, _e189, _e191);
                    let _e197 = select(_e182, select(2u, _e182, _e181), _e191);
                    if (_e82 < -126i) {
                        phi_317_ = -126i;
                    } else {
                        phi_317_ = select(_e82, 127i, (_e82 > 127i));
                    }
                    let _e202 = phi_317_;
                    let _e207 = bitcast<f32>((bitcast<u32>((_e202 + 127i)) << bitcast<u32>(23i)));
                    let _e213 = bitcast<f32>((bitcast<u32>(((_e82 - _e202) + 127i)) << bitcast<u32>(23i)));
                    let _e214 = -(_e177);
                    if (_e214 < -126i) {
                        phi_337_ = -126i;
                    } else {
                        phi_337_ = select(_e214, 127i, (_e214 > 127i));
                    }
                    let _e219 = phi_337_;
                    let _e224 = bitcast<f32>((bitcast<u32>((_e219 + 127i)) << bitcast<u32>(23i)));
                    let _e230 = bitcast<f32>((bitcast<u32>(((_e214 - _e219) + 127i)) << bitcast<u32>(23i)));
                    let _e234 = global_4.member[_e78].member;
                    let _e235 = (_e196 == 0u);
                    if _e235 {
                        phi_355_ = _e234[0];
                    } else {
                        phi_355_ = _e234[1];
                    }
                    let _e239 = phi_355_;
                    let _e240 = (_e196 == 2u);
                    if _e240 {
                        phi_361_ = _e234[2];
                    } else {
                        phi_361_ = _e239;
                    }
                    let _e243 = phi_361_;
                    let _e245 = ((_e243 * _e207) * _e213);
                    let _e246 = global_4.member[_e78].member_2;
                    if _e235 {
                        phi_372_ = _e246[0];
                    } else {
                        phi_372_ = _e246[1];
                    }
                    let _e250 = phi_372_;
                    if _e240 {
                        phi_378_ = _e246[2];
                    } else {
                        phi_378_ = _e250;
                    }
                    let _e253 = phi_378_;
                    let _e255 = ((_e253 * _e224) * _e230);
                    let _e259 = (bitcast<f32>((bitcast<u32>(_e255) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e259 {
                        let _e263 = (bitcast<f32>((bitcast<u32>(_e245) & 2147483647u)) * 0.00000011920929f);
                        phi_401_ = select(0.00000000000011368684f, _e263, (_e263 > 0.00000000000011368684f));
                    } else {
                        phi_401_ = 0f;
                    }
                    let _e267 = phi_401_;
                    let _e268 = (_e245 + _e267);
                    let _e269 = (_e245 - _e267);
                    let _e270 = select(_e255, 0f, _e259);
                    if _e259 {
                        phi_412_ = 38685626000000000000000000f;
                    } else {
                        phi_412_ = (1f / _e255);
                    }
                    let _e273 = phi_412_;
                    let _e274 = (_e195 == 0u);
                    if _e274 {
                        phi_421_ = _e234[0];
                    } else {
                        phi_421_ = _e234[1];
                    }
                    let _e278 = phi_421_;
                    let _e279 = (_e195 == 2u);
                    if _e279 {
                        phi_427_ = _e234[2];
                    } else {
                        phi_427_ = _e278;
                    }
                    let _e282 = phi_427_;
                    let _e284 = ((_e282 * _e207) * _e213);
                    if _e274 {
                        phi_438_ = _e246[0];
                    } else {
                        phi_438_ = _e246[1];
                    }
                    let _e288 = phi_438_;
                    if _e279 {
                        phi_444_ = _e246[2];
                    } else {
                        phi_444_ = _e288;
                    }
                    let _e291 = phi_444_;
                    let _e293 = ((_e291 * _e224) * _e230);
                    let _e297 = (bitcast<f32>((bitcast<u32>(_e293) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e297 {
                        let _e301 = (bitcast<f32>((bitcast<u32>(_e284) & 2147483647u)) * 0.00000011920929f);
                        phi_467_ = select(0.00000000000011368684f, _e301, (_e301 > 0.00000000000011368684f));
                    } else {
                        phi_467_ = 0f;
                    }
                    let _e305 = phi_467_;
                    let _e306 = (_e284 + _e305);
                    let _e307 = (_e284 - _e305);
                    let _e308 = select(_e293, 0f, _e297);
                    if _e297 {
                        phi_478_ = 38685626000000000000000000f;
                    } else {
                        phi_478_ = (1f / _e293);
                    }
                    let _e311 = phi_478_;
                    let _e312 = (_e197 == 0u);
                    if _e312 {
                        phi_487_ = _e234[0];
                    } else {
                        phi_487_ = _e234[1];
                    }
                    let _e316 = phi_487_;
                    let _e317 = (_e197 == 2u);
                    if _e317 {
                        phi_493_ = _e234[2];
                    } else {
                        phi_493_ = _e316;
                    }
                    let _e320 = phi_493_;
                    let _e322 = ((_e320 * _e207) * _e213);
                    if _e312 {
                        phi_504_ = _e246[0];
                    } else {
                        phi_504_ = _e246[1];
                    }
                    let _e326 = phi_504_;
                    if _e317 {
                        phi_510_ = _e246[2];
                    } else {
                        phi_510_ = _e326;
                    }
                    let _e329 = phi_510_;
                    let _e331 = ((_e329 * _e224) * _e230);
                    let _e335 = (bitcast<f32>((bitcast<u32>(_e331) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e335 {
                        let _e339 = (bitcast<f32>((bitcast<u32>(_e322) & 2147483647u)) * 0.00000011920929f);
                        phi_533_ = select(0.00000000000011368684f, _e339, (_e339 > 0.00000000000011368684f));
                    } else {
                        phi_533_ = 0f;
                    }
                    let _e343 = phi_533_;
                    let _e344 = (_e322 + _e343);
                    let _e345 = (_e322 - _e343);
                    let _e346 = select(_e331, 0f, _e335);
                    if _e335 {
                        phi_544_ = 38685626000000000000000000f;
                    } else {
                        phi_544_ = (1f / _e331);
                    }
                    let _e349 = phi_544_;
                    let _e352 = bitcast<f32>((bitcast<u32>(_e245) & 2147483647u));
                    let _e355 = bitcast<f32>((bitcast<u32>(_e284) & 2147483647u));
                    let _e357 = select(_e355, _e352, (_e352 > _e355));
                    let _e360 = bitcast<f32>((bitcast<u32>(_e322) & 2147483647u));
                    let _e363 = (_e82 + _e177);
                    if (_e158 && (select(_e360, _e357, (_e357 > _e360)) <= 1099511600000f)) {
                        let _e366 = (_e363 / 3i);
                        let _e373 = bitcast<f32>((bitcast<u32>((_e366 + 127i)) << bitcast<u32>(23i)));
                        let _e380 = bitcast<f32>((bitcast<u32>(((_e363 - (2i * _e366)) + 127i)) << bitcast<u32>(23i)));
                        let _e381 = (((_e143 * _e373) * _e373) * _e380);
                        let _e383 = select(340282350000000000000000000000000000000f, _e381, (_e381 < 340282350000000000000000000000000000000f));
                        let _e388 = (((_e152 * _e373) * _e373) * _e380);
                        let _e390 = select(340282350000000000000000000000000000000f, _e388, (_e388 < 340282350000000000000000000000000000000f));
                        phi_644_ = select(-340282350000000000000000000000000000000f, _e390, (_e390 > -340282350000000000000000000000000000000f));
                        phi_645_ = select(-340282350000000000000000000000000000000f, _e383, (_e383 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_644_ = 0f;
                        phi_645_ = 1f;
                    }
                    let _e394 = phi_644_;
                    let _e396 = phi_645_;
                    local = array<type_23, 8>(type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_2 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2273_ = false;
                    phi_2253_ = _e394;
                    phi_709_ = select(0u, 2147483648u, (_e68 == 0u));
                    phi_712_ = ((3u * _e68) + 1u);
                    phi_714_ = (_e396 <= _e394);
                    phi_716_ = 0u;
                    loop {
                        let _e403 = phi_2273_;
                        let _e405 = phi_2253_;
                        let _e407 = phi_709_;
                        let _e409 = phi_712_;
                        let _e411 = phi_714_;
                        let _e413 = phi_716_;
                        if _e411 {
                            phi_727_ = true;
                        } else {
                            phi_727_ = (_e413 > 0u);
                        }
                        let _e416 = phi_727_;
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
                                        phi_2380_ = true;
                                        break;
                                    }
                                    let _e422 = local_2[_e419];
                                    if _e420 {
                                    } else {
                                        phi_2380_ = true;
                                        break;
                                    }
                                    let _e424 = local_1[_e419];
                                    phi_760_ = _e422;
                                    phi_761_ = (_e424 <= _e405);
                                    phi_762_ = _e418;
                                }
                                let _e427 = phi_760_;
                                let _e429 = phi_761_;
                                let _e431 = phi_762_;
                                if _e429 {
                                    if ((_e427 & 2147483648u) != 0u) {
                                        phi_2270_ = _e403;
                                        phi_2260_ = _e405;
                                        phi_777_ = type_4(0u, ((_e427 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e628 = phi_2270_;
                                            let _e630 = phi_2260_;
                                            let _e632 = phi_777_;
                                            if (_e632.member < _e632.member_1) {
                                                phi_778_ = type_4((_e632.member + 1u), _e632.member_1);
                                                phi_801_ = type_4(1u, _e632.member);
                                            } else {
                                                phi_778_ = _e632;
                                                phi_801_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e645 = phi_778_;
                                            let _e647 = phi_801_;
                                            let _e651 = (bitcast<i32>(_e647.member) != 0i);
                                            if _e651 {
                                                let _e652 = ((_e427 & 268435455u) + _e647.member_1);
                                                let _e653 = (_e652 < _e70);
                                                if _e653 {
                                                    if _e653 {
                                                    } else {
                                                        phi_2465_ = _e630;
                                                        phi_2375_ = true;
                                                        break;
                                                    }
                                                    let _e657 = global_3.member[_e652].member_1;
                                                    phi_822_ = _e657;
                                                } else {
                                                    phi_822_ = 4294967295u;
                                                }
                                                let _e659 = phi_822_;
                                                if (_e652 >= _e70) {
                                                    phi_911_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e653 {
                                                    } else {
                                                        phi_2465_ = _e630;
                                                        phi_2375_ = true;
                                                        break;
                                                    }
                                                    let _e661 = (_e196 % 3u);
                                                    let _e662 = (_e195 % 3u);
                                                    let _e663 = (_e197 % 3u);
                                                    if (_e661 < 9u) {
                                                    } else {
                                                        phi_2465_ = _e630;
                                                        phi_2375_ = true;
                                                        break;
                                                    }
                                                    let _e669 = global_3.member[_e652].member[_e661];
                                                    if (_e662 < 9u) {
                                                    } else {
                                                        phi_2465_ = _e630;
                                                        phi_2375_ = true;
                                                        break;
                                                    }
                                                    let _e675 = global_3.member[_e652].member[_e662];
                                                    if (_e663 < 9u) {
                                                    } else {
                                                        phi_2465_ = _e630;
                                                        phi_2375_ = true;
                                                        break;
                                                    }
                                                    let _e681 = global_3.member[_e652].member[_e663];
                                                    let _e683 = (3u + _e661);
                                                    if (_e683 < 9u) {
                                                    } else {
                                                        phi_2465_ = _e630;
                                                        phi_2375_ = true;
                                                        break;
                                                    }
                                                    let _e689 = global_3.member[_e652].member[_e683];
                                                    let _e690 = (3u + _e662);
                                                    if (_e690 < 9u) {
                                                    } else {
                                                        phi_2465_ = _e630;
                                                        phi_2375_ = true;
                                                        break;
                                                    }
                                                    let _e696 = global_3.member[_e652].member[_e690];
                                                    let _e697 = (3u + _e663);
                                                    if (_e697 < 9u) {
                                                    } else {
                                                        phi_2465_ = _e630;
                                                        phi_2375_ = true;
                                                        break;
                                                    }
                                                    let _e703 = global_3.member[_e652].member[_e697];
                                                    let _e705 = (6u + _e661);
                                                    if (_e705 < 9u) {
                                                    } else {
                                                        phi_2465_ = _e630;
                                                        phi_2375_ = true;
                                                        break;
                                                    }
                                                    let _e711 = global_3.member[_e652].member[_e705];
                                                    let _e712 = (6u + _e662);
                                                    if (_e712 < 9u) {
                                                    } else {
                                                        phi_2465_ = _e630;
                                                        phi_2375_ = true;
                                                        break;
                                                    }
                                                    let _e718 = global_3.member[_e652].member[_e712];
                                                    let _e719 = (6u + _e663);
                                                    if (_e719 < 9u) {
                                                    } else {
                                                        phi_2465_ = _e630;
                                                        phi_2375_ = true;
                                                        break;
                                                    }
                                                    let _e725 = global_3.member[_e652].member[_e719];
                                                    phi_911_ = array<array<f32, 3>, 3>(array<f32, 3>(_e669, _e675, _e681), array<f32, 3>(_e689, _e696, _e703), array<f32, 3>(_e711, _e718, _e725));
                                                }
                                                let _e729 = phi_911_;
                                                let _e736 = (_e729[0][2] - _e322);
                                                let _e739 = (((_e729[0][0] - _e245) * _e346) - (_e736 * _e270));
                                                let _e742 = (((_e729[0][1] - _e284) * _e346) - (_e736 * _e308));
                                                let _e749 = (_e729[1][2] - _e322);
                                                let _e752 = (((_e729[1][0] - _e245) * _e346) - (_e749 * _e270));
                                                let _e755 = (((_e729[1][1] - _e284) * _e346) - (_e749 * _e308));
                                                let _e762 = (_e729[2][2] - _e322);
                                                let _e765 = (((_e729[2][0] - _e245) * _e346) - (_e762 * _e270));
                                                let _e768 = (((_e729[2][1] - _e284) * _e346) - (_e762 * _e308));
                                                let _e769 = (_e765 * _e755);
                                                let _e770 = (_e768 * _e752);
                                                let _e771 = (_e739 * _e768);
                                                let _e772 = (_e742 * _e765);
                                                let _e773 = (_e752 * _e742);
                                                let _e774 = (_e755 * _e739);
                                                let _e779 = (((_e769 >= _e770) && (_e771 >= _e772)) && (_e773 >= _e774));
                                                if (_e779 || (((_e769 <= _e770) && (_e771 <= _e772)) && (_e773 <= _e774))) {
                                                    let _e786 = select(-1f, 1f, _e779);
                                                    let _e788 = ((_e769 - _e770) * _e786);
                                                    let _e790 = select(0f, _e788, (_e788 > 0f));
                                                    let _e792 = ((_e771 - _e772) * _e786);
                                                    let _e794 = select(0f, _e792, (_e792 > 0f));
                                                    let _e796 = ((_e773 - _e774) * _e786);
                                                    let _e798 = select(0f, _e796, (_e796 > 0f));
                                                    let _e800 = ((_e790 + _e794) + _e798);
                                                    if (_e800 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1478_ = type_23();
                                                        phi_1479_ = true;
                                                    } else {
                                                        let _e803 = select(_e729[1][0], _e729[0][0], (_e729[0][0] < _e729[1][0]));
                                                        let _e807 = select(_e729[1][0], _e729[0][0], (_e729[0][0] > _e729[1][0]));
                                                        let _e811 = select(_e729[1][1], _e729[0][1], (_e729[0][1] < _e729[1][1]));
                                                        let _e815 = select(_e729[1][1], _e729[0][1], (_e729[0][1] > _e729[1][1]));
                                                        let _e819 = select(_e729[1][2], _e729[0][2], (_e729[0][2] < _e729[1][2]));
                                                        let _e823 = select(_e729[1][2], _e729[0][2], (_e729[0][2] > _e729[1][2]));
                                                        let _e828 = ((select(_e729[2][0], _e803, (_e803 < _e729[2][0])) - _e268) * _e273);
                                                        let _e829 = ((select(_e729[2][0], _e807, (_e807 > _e729[2][0])) - _e269) * _e273);
                                                        let _e832 = ((select(_e729[2][1], _e811, (_e811 < _e729[2][1])) - _e306) * _e311);
                                                        let _e833 = ((select(_e729[2][1], _e815, (_e815 > _e729[2][1])) - _e307) * _e311);
                                                        let _e836 = ((select(_e729[2][2], _e819, (_e819 < _e729[2][2])) - _e344) * _e349);
                                                        let _e837 = ((select(_e729[2][2], _e823, (_e823 > _e729[2][2])) - _e345) * _e349);
                                                        let _e839 = select(_e837, _e836, (_e836 < _e837));
                                                        let _e841 = select(_e837, _e836, (_e836 > _e837));
                                                        let _e843 = select(_e829, _e828, (_e828 < _e829));
                                                        let _e845 = select(_e833, _e832, (_e832 < _e833));
                                                        let _e847 = select(_e845, _e843, (_e843 > _e845));
                                                        let _e849 = select(_e839, _e847, (_e847 > _e839));
                                                        let _e851 = select(_e829, _e828, (_e828 > _e829));
                                                        let _e853 = select(_e833, _e832, (_e832 > _e833));
                                                        let _e855 = select(_e853, _e851, (_e851 < _e853));
                                                        let _e857 = select(_e841, _e855, (_e855 < _e841));
                                                        let _e858 = -(_e839);
                                                        let _e864 = select(_e396, _e849, (_e849 > _e396));
                                                        if (_e864 > (_e857 + (select(_e858, _e841, (_e841 > _e858)) * 0.0000019073523f))) {
                                                            phi_1473_ = type_23();
                                                            phi_1474_ = true;
                                                        } else {
                                                            let _e866 = (_e864 > _e630);
                                                            if _e866 {
                                                                phi_1472_ = type_23();
                                                            } else {
                                                                let _e870 = (_e729[1][0] - _e729[0][0]);
                                                                let _e871 = (_e729[1][1] - _e729[0][1]);
                                                                let _e872 = (_e729[1][2] - _e729[0][2]);
                                                                let _e873 = vec3<f32>(_e870, _e871, _e872);
                                                                let _e874 = (_e729[2][0] - _e729[1][0]);
                                                                let _e875 = (_e729[2][1] - _e729[1][1]);
                                                                let _e876 = (_e729[2][2] - _e729[1][2]);
                                                                let _e877 = vec3<f32>(_e874, _e875, _e876);
                                                                let _e878 = (_e729[0][0] - _e729[2][0]);
                                                                let _e879 = (_e729[0][1] - _e729[2][1]);
                                                                let _e880 = (_e729[0][2] - _e729[2][2]);
                                                                let _e881 = vec3<f32>(_e878, _e879, _e880);
                                                                let _e884 = bitcast<f32>((bitcast<u32>(_e870) & 2147483647u));
                                                                let _e887 = bitcast<f32>((bitcast<u32>(_e871) & 2147483647u));
                                                                let _e889 = select(_e887, _e884, (_e884 > _e887));
                                                                let _e892 = bitcast<f32>((bitcast<u32>(_e872) & 2147483647u));
                                                                let _e894 = select(_e892, _e889, (_e889 > _e892));
                                                                let _e897 = bitcast<f32>((bitcast<u32>(_e874) & 2147483647u));
                                                                let _e900 = bitcast<f32>((bitcast<u32>(_e875) & 2147483647u));
                                                                let _e902 = select(_e900, _e897, (_e897 > _e900));
                                                                let _e905 = bitcast<f32>((bitcast<u32>(_e876) & 2147483647u));
                                                                let _e907 = select(_e905, _e902, (_e902 > _e905));
                                                                let _e910 = bitcast<f32>((bitcast<u32>(_e878) & 2147483647u));
                                                                let _e913 = bitcast<f32>((bitcast<u32>(_e879) & 2147483647u));
                                                                let _e915 = select(_e913, _e910, (_e910 > _e913));
                                                                let _e918 = bitcast<f32>((bitcast<u32>(_e880) & 2147483647u));
                                                                let _e920 = select(_e918, _e915, (_e915 > _e918));
                                                                let _e922 = select(_e907, _e894, (_e894 > _e907));
                                                                let _e924 = select(_e920, _e922, (_e922 > _e920));
                                                                if (_e894 == _e924) {
                                                                    phi_1383_ = _e877;
                                                                    phi_1384_ = _e881;
                                                                } else {
                                                                    let _e927 = vec3((_e907 == _e924));
                                                                    phi_1383_ = select(_e873, _e881, _e927);
                                                                    phi_1384_ = select(_e877, _e873, _e927);
                                                                }
                                                                let _e931 = phi_1383_;
                                                                let _e933 = phi_1384_;
                                                                let _e940 = ((_e931.y * _e933.z) - (_e933.y * _e931.z));
                                                                let _e945 = ((_e931.z * _e933.x) - (_e933.z * _e931.x));
                                                                let _e948 = ((_e931.x * _e933.y) - (_e933.x * _e931.y));
                                                                if (_e790 >= _e794) {
                                                                    phi_1415_ = select(true, false, (_e790 >= _e798));
                                                                } else {
                                                                    phi_1415_ = true;
                                                                }
                                                                let _e953 = phi_1415_;
                                                                if _e953 {
                                                                    phi_1424_ = select(vec3<f32>(_e729[2][0], _e729[2][1], _e729[2][2]), vec3<f32>(_e729[1][0], _e729[1][1], _e729[1][2]), vec3((_e794 >= _e798)));
                                                                } else {
                                                                    phi_1424_ = vec3<f32>(_e729[0][0], _e729[0][1], _e729[0][2]);
                                                                }
                                                                let _e958 = phi_1424_;
                                                                let _e975 = ((((_e940 * (_e958.x - _e245)) + (_e945 * (_e958.y - _e284))) + (_e948 * (_e958.z - _e322))) / (((_e940 * _e270) + (_e945 * _e308)) + (_e948 * _e346)));
                                                                let _e977 = select(_e857, _e975, (_e975 < _e857));
                                                                let _e979 = select(_e849, _e977, (_e977 > _e849));
                                                                if (_e979 >= _e396) {
                                                                    let _e981 = (_e979 <= _e630);
                                                                    if _e981 {
                                                                        let _e982 = (1f / _e800);
                                                                        phi_1464_ = type_23(_e979, (_e794 * _e982), (_e798 * _e982), _e659);
                                                                    } else {
                                                                        phi_1464_ = type_23();
                                                                    }
                                                                    let _e987 = phi_1464_;
                                                                    phi_1466_ = _e987;
                                                                    phi_1467_ = select(true, false, _e981);
                                                                } else {
                                                                    phi_1466_ = type_23();
                                                                    phi_1467_ = true;
                                                                }
                                                                let _e990 = phi_1466_;
                                                                let _e992 = phi_1467_;
                                                                if _e992 {
                                                                    phi_1471_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1471_ = _e990;
                                                                }
                                                                let _e994 = phi_1471_;
                                                                phi_1472_ = _e994;
                                                            }
                                                            let _e996 = phi_1472_;
                                                            phi_1473_ = _e996;
                                                            phi_1474_ = _e866;
                                                        }
                                                        let _e998 = phi_1473_;
                                                        let _e1000 = phi_1474_;
                                                        phi_1478_ = _e998;
                                                        phi_1479_ = _e1000;
                                                    }
                                                    let _e1002 = phi_1478_;
                                                    let _e1004 = phi_1479_;
                                                    phi_1483_ = _e1002;
                                                    phi_1484_ = _e1004;
                                                } else {
                                                    phi_1483_ = type_23();
                                                    phi_1484_ = true;
                                                }
                                                let _e1006 = phi_1483_;
                                                let _e1008 = phi_1484_;
                                                if _e1008 {
                                                    phi_1488_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1488_ = _e1006;
                                                }
                                                let _e1010 = phi_1488_;
                                                if (_e1010.member_3 != 4294967295u) {
                                                    if (_e659 != 4294967295u) {
                                                        phi_1500_ = type_4(0u, 8u);
                                                        phi_1503_ = _e1010;
                                                        loop {
                                                            let _e1015 = phi_1500_;
                                                            let _e1017 = phi_1503_;
                                                            if (_e1015.member < _e1015.member_1) {
                                                                phi_1501_ = type_4((_e1015.member + 1u), _e1015.member_1);
                                                                phi_1526_ = type_4(1u, _e1015.member);
                                                            } else {
                                                                phi_1501_ = _e1015;
                                                                phi_1526_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1030 = phi_1501_;
                                                            let _e1032 = phi_1526_;
                                                            let _e1036 = (bitcast<i32>(_e1032.member) != 0i);
                                                            if _e1036 {
                                                                let _e1037 = (_e1032.member_1 < 8u);
                                                                if _e1037 {
                                                                } else {
                                                                    phi_2261_ = true;
                                                                    break;
                                                                }
                                                                let _e1042 = local[_e1032.member_1].member;
                                                                if (_e1017.member < _e1042) {
                                                                    phi_1559_ = true;
                                                                } else {
                                                                    let _e1044 = local[_e1032.member_1].member;
                                                                    if (_e1017.member == _e1044) {
                                                                        let _e1049 = local[_e1032.member_1].member_3;
                                                                        phi_1558_ = (_e1017.member_3 < _e1049);
                                                                    } else {
                                                                        phi_1558_ = false;
                                                                    }
                                                                    let _e1052 = phi_1558_;
                                                                    phi_1559_ = _e1052;
                                                                }
                                                                let _e1054 = phi_1559_;
                                                                if _e1054 {
                                                                    if _e1037 {
                                                                    } else {
                                                                        phi_2261_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1055 = local[_e1032.member_1];
                                                                    local[_e1032.member_1] = type_23(_e1017.member, _e1017.member_1, _e1017.member_2, _e1017.member_3);
                                                                    phi_1580_ = type_23(_e1055.member, _e1055.member_1, _e1055.member_2, _e1055.member_3);
                                                                } else {
                                                                    phi_1580_ = _e1017;
                                                                }
                                                                let _e1066 = phi_1580_;
                                                                phi_1504_ = _e1066;
                                                            } else {
                                                                phi_1504_ = type_23();
                                                            }
                                                            let _e1068 = phi_1504_;
                                                            continue;
                                                            continuing {
                                                                phi_1500_ = _e1030;
                                                                phi_1503_ = _e1068;
                                                                phi_2261_ = _e628;
                                                                break if !(_e1036);
                                                            }
                                                        }
                                                        let _e1071 = phi_2261_;
                                                        phi_2465_ = _e630;
                                                        phi_2375_ = _e1071;
                                                        if _e1071 {
                                                            break;
                                                        }
                                                        let _e1074 = local[7u].member_3;
                                                        if (_e1074 != 4294967295u) {
                                                            let _e1078 = local[7u].member;
                                                            phi_2528_ = _e1078;
                                                        } else {
                                                            phi_2528_ = _e630;
                                                        }
                                                        let _e1080 = phi_2528_;
                                                        phi_2527_ = _e1080;
                                                        phi_2378_ = _e1071;
                                                    } else {
                                                        phi_2527_ = _e630;
                                                        phi_2378_ = _e628;
                                                    }
                                                    let _e1082 = phi_2527_;
                                                    let _e1084 = phi_2378_;
                                                    phi_2526_ = _e1082;
                                                    phi_2377_ = _e1084;
                                                } else {
                                                    phi_2526_ = _e630;
                                                    phi_2377_ = _e628;
                                                }
                                                let _e1086 = phi_2526_;
                                                let _e1088 = phi_2377_;
                                                phi_2525_ = _e1086;
                                                phi_2376_ = _e1088;
                                            } else {
                                                phi_2525_ = _e630;
                                                phi_2376_ = _e628;
                                            }
                                            let _e1090 = phi_2525_;
                                            let _e1092 = phi_2376_;
                                            continue;
                                            continuing {
                                                phi_2270_ = _e1092;
                                                phi_2260_ = _e1090;
                                                phi_777_ = _e645;
                                                phi_2465_ = _e1090;
                                                phi_2375_ = _e1092;
                                                break if !(_e651);
                                            }
                                        }
                                        let _e1095 = phi_2465_;
                                        let _e1097 = phi_2375_;
                                        phi_2380_ = _e1097;
                                        if _e1097 {
                                            break;
                                        }
                                        phi_2430_ = _e1095;
                                        phi_2384_ = _e1097;
                                        phi_2047_ = _e427;
                                        phi_2048_ = false;
                                        phi_2049_ = _e431;
                                    } else {
                                        if (_e427 >= _e68) {
                                            phi_1651_ = type_39(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e427 < _e68) {
                                            } else {
                                                phi_2380_ = true;
                                                break;
                                            }
                                            let _e441 = (_e196 % 3u);
                                            if (_e441 < 3u) {
                                            } else {
                                                phi_2380_ = true;
                                                break;
                                            }
                                            let _e447 = global_2.member[_e427].member[_e441];
                                            let _e453 = (_e195 % 3u);
                                            if (_e453 < 3u) {
                                            } else {
                                                phi_2380_ = true;
                                                break;
                                            }
                                            let _e459 = global_2.member[_e427].member[_e453];
                                            let _e465 = (_e197 % 3u);
                                            if (_e465 < 3u) {
                                            } else {
                                                phi_2380_ = true;
                                                break;
                                            }
                                            let _e471 = global_2.member[_e427].member[_e465];
                                            let _e481 = global_2.member[_e427].member_1;
                                            let _e485 = global_2.member[_e427].member_2;
                                            phi_1651_ = type_39(array<vec4<f32>, 3>(vec4<f32>(_e447[0], _e447[1], _e447[2], _e447[3]), vec4<f32>(_e459[0], _e459[1], _e459[2], _e459[3]), vec4<f32>(_e471[0], _e471[1], _e471[2], _e471[3])), _e481, _e485);
                                        }
                                        let _e488 = phi_1651_;
                                        let _e499 = ((_e488.member[0].x - _e268) * _e273);
                                        let _e500 = ((_e488.member[0].y - _e268) * _e273);
                                        let _e501 = ((_e488.member[0].z - _e269) * _e273);
                                        let _e502 = ((_e488.member[0].w - _e269) * _e273);
                                        let _e512 = ((_e488.member[1].x - _e306) * _e311);
                                        let _e513 = ((_e488.member[1].y - _e306) * _e311);
                                        let _e514 = ((_e488.member[1].z - _e307) * _e311);
                                        let _e515 = ((_e488.member[1].w - _e307) * _e311);
                                        let _e525 = ((_e488.member[2].x - _e344) * _e349);
                                        let _e526 = ((_e488.member[2].y - _e344) * _e349);
                                        let _e527 = ((_e488.member[2].z - _e345) * _e349);
                                        let _e528 = ((_e488.member[2].w - _e345) * _e349);
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
                                        let _e580 = select(_e396, _e550, (_e550 > _e396));
                                        let _e582 = select(_e396, _e552, (_e552 > _e396));
                                        let _e587 = (_e580 <= select(_e405, _e577, (_e577 < _e405)));
                                        let _e588 = (_e582 <= select(_e405, _e578, (_e578 < _e405)));
                                        let _e589 = (_e580 <= _e582);
                                        if _e587 {
                                            if _e588 {
                                                if _e589 {
                                                    phi_1996_ = _e488.member_2;
                                                } else {
                                                    phi_1996_ = _e488.member_1;
                                                }
                                                let _e593 = phi_1996_;
                                                let _e596 = (_e431 % 128u);
                                                let _e597 = (_e596 < 128u);
                                                if _e597 {
                                                } else {
                                                    phi_2380_ = true;
                                                    break;
                                                }
                                                local_2[_e596] = _e593;
                                                if _e597 {
                                                } else {
                                                    phi_2380_ = true;
                                                    break;
                                                }
                                                local_1[_e596] = select(_e582, _e580, (_e580 > _e582));
                                                if _e589 {
                                                    phi_2024_ = _e488.member_1;
                                                } else {
                                                    phi_2024_ = _e488.member_2;
                                                }
                                                let _e604 = phi_2024_;
                                                phi_2025_ = _e604;
                                                phi_2026_ = (_e431 + 1u);
                                            } else {
                                                phi_2025_ = u32();
                                                phi_2026_ = u32();
                                            }
                                            let _e606 = phi_2025_;
                                            let _e608 = phi_2026_;
                                            phi_2028_ = _e606;
                                            phi_2029_ = _e608;
                                            phi_2030_ = select(true, false, _e588);
                                        } else {
                                            phi_2028_ = u32();
                                            phi_2029_ = u32();
                                            phi_2030_ = true;
                                        }
                                        let _e611 = phi_2028_;
                                        let _e613 = phi_2029_;
                                        let _e615 = phi_2030_;
                                        if _e615 {
                                            if _e587 {
                                                phi_2039_ = _e488.member_1;
                                            } else {
                                                phi_2039_ = _e488.member_2;
                                            }
                                            let _e619 = phi_2039_;
                                            phi_2044_ = _e619;
                                            phi_2045_ = select(_e588, true, _e587);
                                        } else {
                                            phi_2044_ = _e611;
                                            phi_2045_ = _e429;
                                        }
                                        let _e622 = phi_2044_;
                                        let _e624 = phi_2045_;
                                        phi_2430_ = _e405;
                                        phi_2384_ = _e403;
                                        phi_2047_ = _e622;
                                        phi_2048_ = _e624;
                                        phi_2049_ = select(_e613, _e431, _e615);
                                    }
                                    let _e1099 = phi_2430_;
                                    let _e1101 = phi_2384_;
                                    let _e1103 = phi_2047_;
                                    let _e1105 = phi_2048_;
                                    let _e1107 = phi_2049_;
                                    phi_2429_ = _e1099;
                                    phi_2383_ = _e1101;
                                    phi_2050_ = _e1103;
                                    phi_2051_ = (_e409 - 1u);
                                    phi_2052_ = _e1105;
                                    phi_2053_ = _e1107;
                                } else {
                                    phi_2429_ = _e405;
                                    phi_2383_ = _e403;
                                    phi_2050_ = _e427;
                                    phi_2051_ = _e409;
                                    phi_2052_ = _e429;
                                    phi_2053_ = _e431;
                                }
                                let _e1109 = phi_2429_;
                                let _e1111 = phi_2383_;
                                let _e1113 = phi_2050_;
                                let _e1115 = phi_2051_;
                                let _e1117 = phi_2052_;
                                let _e1119 = phi_2053_;
                                phi_2428_ = _e1109;
                                phi_2382_ = _e1111;
                                phi_2054_ = _e1113;
                                phi_2055_ = _e1115;
                                phi_2056_ = _e1117;
                                phi_2057_ = _e1119;
                            } else {
                                phi_2428_ = _e405;
                                phi_2382_ = _e403;
                                phi_2054_ = u32();
                                phi_2055_ = u32();
                                phi_2056_ = bool();
                                phi_2057_ = u32();
                            }
                            let _e1121 = phi_2428_;
                            let _e1123 = phi_2382_;
                            let _e1125 = phi_2054_;
                            let _e1127 = phi_2055_;
                            let _e1129 = phi_2056_;
                            let _e1131 = phi_2057_;
                            phi_2427_ = _e1121;
                            phi_2381_ = _e1123;
                            phi_710_ = _e1125;
                            phi_713_ = _e1127;
                            phi_715_ = _e1129;
                            phi_717_ = _e1131;
                            phi_2058_ = _e417;
                        } else {
                            phi_2427_ = _e405;
                            phi_2381_ = _e403;
                            phi_710_ = u32();
                            phi_713_ = u32();
                            phi_715_ = bool();
                            phi_717_ = u32();
                            phi_2058_ = false;
                        }
                        let _e1133 = phi_2427_;
                        let _e1135 = phi_2381_;
                        let _e1137 = phi_710_;
                        let _e1139 = phi_713_;
                        let _e1141 = phi_715_;
                        let _e1143 = phi_717_;
                        let _e1145 = phi_2058_;
                        continue;
                        continuing {
                            phi_2273_ = _e1135;
                            phi_2253_ = _e1133;
                            phi_709_ = _e1137;
                            phi_712_ = _e1139;
                            phi_714_ = _e1141;
                            phi_716_ = _e1143;
                            phi_2380_ = _e1135;
                            break if !(_e1145);
                        }
                    }
                    let _e1148 = phi_2380_;
                    if _e1148 {
                        break;
                    }
                    phi_2065_ = type_4(0u, 8u);
                    loop {
                        let _e1150 = phi_2065_;
                        if (_e1150.member < _e1150.member_1) {
                            phi_2066_ = type_4((_e1150.member + 1u), _e1150.member_1);
                            phi_2089_ = type_4(1u, _e1150.member);
                        } else {
                            phi_2066_ = _e1150;
                            phi_2089_ = type_4(0u, type_4().member_1);
                        }
                        let _e1163 = phi_2066_;
                        let _e1165 = phi_2089_;
                        let _e1169 = (bitcast<i32>(_e1165.member) != 0i);
                        if _e1169 {
                            let _e1170 = (_e1165.member_1 < 8u);
                            if _e1170 {
                            } else {
                                phi_2420_ = true;
                                break;
                            }
                            let _e1172 = local[_e1165.member_1];
                            if (_e1172.member_3 != 4294967295u) {
                                let _e1178 = -(_e363);
                                let _e1179 = (_e1178 / 3i);
                                let _e1186 = bitcast<f32>((bitcast<u32>((_e1179 + 127i)) << bitcast<u32>(23i)));
                                let _e1194 = (((_e1172.member * _e1186) * _e1186) * bitcast<f32>((bitcast<u32>(((_e1178 - (2i * _e1179)) + 127i)) << bitcast<u32>(23i))));
                                let _e1196 = select(340282350000000000000000000000000000000f, _e1194, (_e1194 < 340282350000000000000000000000000000000f));
                                phi_2155_ = type_23(select(-340282350000000000000000000000000000000f, _e1196, (_e1196 > -340282350000000000000000000000000000000f)), _e1172.member_1, _e1172.member_2, _e1172.member_3);
                            } else {
                                phi_2155_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1201 = phi_2155_;
                            if _e1170 {
                            } else {
                                phi_2420_ = true;
                                break;
                            }
                            local[_e1165.member_1] = type_23(_e1201.member, _e1201.member_1, _e1201.member_2, _e1201.member_3);
                        }
                        continue;
                        continuing {
                            phi_2065_ = _e1163;
                            phi_2420_ = _e1148;
                            break if !(_e1169);
                        }
                    }
                    let _e1209 = phi_2420_;
                    if _e1209 {
                        break;
                    }
                    let _e1210 = local;
                    if _e84 {
                    } else {
                        break;
                    }
                    global_5.member[_e78] = array<type_23, 8>(type_23(_e1210[0].member, _e1210[0].member_1, _e1210[0].member_2, _e1210[0].member_3), type_23(_e1210[1].member, _e1210[1].member_1, _e1210[1].member_2, _e1210[1].member_3), type_23(_e1210[2].member, _e1210[2].member_1, _e1210[2].member_2, _e1210[2].member_3), type_23(_e1210[3].member, _e1210[3].member_1, _e1210[3].member_2, _e1210[3].member_3), type_23(_e1210[4].member, _e1210[4].member_1, _e1210[4].member_2, _e1210[4].member_3), type_23(_e1210[5].member, _e1210[5].member_1, _e1210[5].member_2, _e1210[5].member_3), type_23(_e1210[6].member, _e1210[6].member_1, _e1210[6].member_2, _e1210[6].member_3), type_23(_e1210[7].member, _e1210[7].member_1, _e1210[7].member_2, _e1210[7].member_3));
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
