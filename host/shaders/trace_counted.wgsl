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

struct type_43 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_45 {
    member: array<type_28>,
}

struct type_47 {
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
var<storage> global_4: type_45;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_21;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_267_: i32;
    var phi_268_: i32;
    var phi_278_: bool;
    var phi_288_: u32;
    var phi_289_: u32;
    var phi_291_: bool;
    var phi_296_: u32;
    var phi_340_: f32;
    var phi_346_: f32;
    var phi_357_: f32;
    var phi_363_: f32;
    var phi_386_: f32;
    var phi_397_: f32;
    var phi_406_: f32;
    var phi_412_: f32;
    var phi_423_: f32;
    var phi_429_: f32;
    var phi_452_: f32;
    var phi_463_: f32;
    var phi_472_: f32;
    var phi_478_: f32;
    var phi_489_: f32;
    var phi_495_: f32;
    var phi_518_: f32;
    var phi_529_: f32;
    var phi_629_: f32;
    var phi_630_: f32;
    var phi_2232_: bool;
    var phi_905_: type_47;
    var phi_908_: u32;
    var phi_910_: u32;
    var phi_912_: bool;
    var phi_914_: u32;
    var phi_925_: bool;
    var phi_956_: u32;
    var phi_957_: bool;
    var phi_958_: u32;
    var phi_1786_: type_43;
    var phi_2130_: u32;
    var phi_2157_: u32;
    var phi_2158_: u32;
    var phi_2159_: u32;
    var phi_2161_: u32;
    var phi_2162_: u32;
    var phi_2163_: bool;
    var phi_2172_: u32;
    var phi_2177_: u32;
    var phi_2178_: bool;
    var phi_973_: type_47;
    var phi_976_: type_4;
    var phi_977_: type_4;
    var phi_999_: type_4;
    var phi_1023_: u32;
    var phi_1112_: array<array<f32, 3>, 3>;
    var phi_1583_: vec3<f32>;
    var phi_1584_: vec3<f32>;
    var phi_1615_: bool;
    var phi_1624_: vec3<f32>;
    var phi_1664_: type_27;
    var phi_1666_: type_27;
    var phi_1667_: bool;
    var phi_1671_: type_27;
    var phi_1672_: type_27;
    var phi_1673_: type_27;
    var phi_1674_: bool;
    var phi_1678_: type_27;
    var phi_1679_: bool;
    var phi_1683_: type_27;
    var phi_1684_: bool;
    var phi_1688_: type_27;
    var phi_1713_: bool;
    var phi_1714_: bool;
    var phi_1721_: type_47;
    var phi_1722_: type_47;
    var phi_1723_: type_47;
    var phi_974_: type_47;
    var phi_2226_: bool;
    var phi_2340_: bool;
    var phi_2180_: type_47;
    var phi_2181_: u32;
    var phi_2182_: bool;
    var phi_2183_: u32;
    var phi_2339_: bool;
    var phi_2184_: type_47;
    var phi_2185_: u32;
    var phi_2186_: u32;
    var phi_2187_: bool;
    var phi_2188_: u32;
    var phi_2338_: bool;
    var phi_2189_: type_47;
    var phi_2190_: u32;
    var phi_2191_: u32;
    var phi_2192_: bool;
    var phi_2193_: u32;
    var phi_2337_: bool;
    var phi_906_: type_47;
    var phi_909_: u32;
    var phi_911_: u32;
    var phi_913_: bool;
    var phi_915_: u32;
    var phi_2194_: bool;
    var phi_2336_: bool;
    var local_2: type_47;
    var local_3: type_47;
    var local_4: type_47;

    switch bitcast<i32>(0u) {
        default: {
            let _e61 = global;
            let _e63 = arrayLength((&global_2.member));
            let _e65 = arrayLength((&global_3.member));
            let _e73 = (_e61.x + (_e61.y * 2097152u));
            let _e76 = global_1.member[0u];
            let _e77 = bitcast<i32>(_e76);
            let _e78 = (_e73 < arrayLength((&global_4.member)));
            if _e78 {
                let _e79 = (_e73 < arrayLength((&global_5.member)));
                if _e79 {
                    if _e78 {
                    } else {
                        break;
                    }
                    let _e87 = global_4.member[_e73].member_2[0u];
                    let _e89 = (bitcast<u32>(_e87) & 2147483647u);
                    let _e94 = global_4.member[_e73].member_2[1u];
                    let _e96 = (bitcast<u32>(_e94) & 2147483647u);
                    let _e101 = global_4.member[_e73].member_2[2u];
                    let _e103 = (bitcast<u32>(_e101) & 2147483647u);
                    let _e108 = global_4.member[_e73].member[0u];
                    let _e110 = (bitcast<u32>(_e108) & 2147483647u);
                    let _e115 = global_4.member[_e73].member[1u];
                    let _e117 = (bitcast<u32>(_e115) & 2147483647u);
                    let _e122 = global_4.member[_e73].member[2u];
                    let _e124 = (bitcast<u32>(_e122) & 2147483647u);
                    let _e126 = select(_e96, _e89, (_e96 < _e89));
                    let _e128 = select(_e103, _e126, (_e103 < _e126));
                    let _e130 = select(_e110, _e128, (_e110 < _e128));
                    let _e132 = select(_e117, _e130, (_e117 < _e130));
                    let _e134 = select(_e124, _e132, (_e124 < _e132));
                    let _e138 = global_4.member[_e73].member_1;
                    let _e140 = (bitcast<u32>(_e138) & 2147483647u);
                    let _e147 = global_4.member[_e73].member_3;
                    let _e153 = (((select(_e140, _e134, (_e140 < _e134)) < 2139095040u) && ((bitcast<u32>(_e147) & 2147483647u) <= 2139095040u)) && (_e128 > 0u));
                    if _e153 {
                        let _e156 = (bitcast<u32>(bitcast<f32>(_e128)) & 2147483647u);
                        if (_e156 >= 8388608u) {
                            phi_267_ = (bitcast<i32>((_e156 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_267_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e156)), 32u, (_e156 == 0u))));
                        }
                        let _e170 = phi_267_;
                        phi_268_ = _e170;
                    } else {
                        phi_268_ = 0i;
                    }
                    let _e172 = phi_268_;
                    let _e173 = (_e89 == _e128);
                    if _e173 {
                        phi_278_ = true;
                    } else {
                        phi_278_ = (_e96 == _e128);
                    }
                    let _e176 = phi_278_;
                    let _e177 = select(1u, 0u, _e173);
                    if _e176 {
                        let _e178 = (_e177 + 1u);
                        phi_288_ = _e178;
                        phi_289_ = _e178;
                        phi_291_ = select(true, false, (_e178 == 2u));
                    } else {
                        phi_288_ = u32();
                        phi_289_ = 0u;
                        phi_291_ = true;
                    }
                    let _e182 = phi_288_;
                    let _e184 = phi_289_;
                    let _e186 = phi_291_;
                    if _e186 {
                        phi_296_ = (_e184 + 1u);
                    } else {
                        phi_296_ = 0u;
                    }
                    let _e190 = phi_296_;
                    let _e191 = select(_e182, _e184, _e186);
                    let _e192 = select(_e177, select(2u, _e177, _e176), _e186);
                    let _e193 = (_e77 / 2i);
                    let _e198 = bitcast<f32>((bitcast<u32>((_e193 + 127i)) << bitcast<u32>(23i)));
                    let _e204 = bitcast<f32>((bitcast<u32>(((_e77 - _e193) + 127i)) << bitcast<u32>(23i)));
                    let _e205 = -(_e172);
                    let _e206 = (_e205 / 2i);
                    let _e211 = bitcast<f32>((bitcast<u32>((_e206 + 127i)) << bitcast<u32>(23i)));
                    let _e217 = bitcast<f32>((bitcast<u32>(((_e205 - _e206) + 127i)) << bitcast<u32>(23i)));
                    let _e221 = global_4.member[_e73].member;
                    let _e222 = (_e191 == 0u);
                    if _e222 {
                        phi_340_ = _e221[0];
                    } else {
                        phi_340_ = _e221[1];
                    }
                    let _e226 = phi_340_;
                    let _e227 = (_e191 == 2u);
                    if _e227 {
                        phi_346_ = _e221[2];
                    } else {
                        phi_346_ = _e226;
                    }
                    let _e230 = phi_346_;
                    let _e232 = ((_e230 * _e198) * _e204);
                    let _e233 = global_4.member[_e73].member_2;
                    if _e222 {
                        phi_357_ = _e233[0];
                    } else {
                        phi_357_ = _e233[1];
                    }
                    let _e237 = phi_357_;
                    if _e227 {
                        phi_363_ = _e233[2];
                    } else {
                        phi_363_ = _e237;
                    }
                    let _e240 = phi_363_;
                    let _e242 = ((_e240 * _e211) * _e217);
                    let _e246 = (bitcast<f32>((bitcast<u32>(_e242) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e246 {
                        let _e250 = (bitcast<f32>((bitcast<u32>(_e232) & 2147483647u)) * 0.00000011920929f);
                        phi_386_ = select(0.00000000000011368684f, _e250, (_e250 > 0.00000000000011368684f));
                    } else {
                        phi_386_ = 0f;
                    }
                    let _e254 = phi_386_;
                    let _e255 = (_e232 + _e254);
                    let _e256 = (_e232 - _e254);
                    let _e257 = select(_e242, 0f, _e246);
                    if _e246 {
                        phi_397_ = 38685626000000000000000000f;
                    } else {
                        phi_397_ = (1f / _e242);
                    }
                    let _e260 = phi_397_;
                    let _e261 = (_e190 == 0u);
                    if _e261 {
                        phi_406_ = _e221[0];
                    } else {
                        phi_406_ = _e221[1];
                    }
                    let _e265 = phi_406_;
                    let _e266 = (_e190 == 2u);
                    if _e266 {
                        phi_412_ = _e221[2];
                    } else {
                        phi_412_ = _e265;
                    }
                    let _e269 = phi_412_;
                    let _e271 = ((_e269 * _e198) * _e204);
                    if _e261 {
                        phi_423_ = _e233[0];
                    } else {
                        phi_423_ = _e233[1];
                    }
                    let _e275 = phi_423_;
                    if _e266 {
                        phi_429_ = _e233[2];
                    } else {
                        phi_429_ = _e275;
                    }
                    let _e278 = phi_429_;
                    let _e280 = ((_e278 * _e211) * _e217);
                    let _e284 = (bitcast<f32>((bitcast<u32>(_e280) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e284 {
                        let _e288 = (bitcast<f32>((bitcast<u32>(_e271) & 2147483647u)) * 0.00000011920929f);
                        phi_452_ = select(0.00000000000011368684f, _e288, (_e288 > 0.00000000000011368684f));
                    } else {
                        phi_452_ = 0f;
                    }
                    let _e292 = phi_452_;
                    let _e293 = (_e271 + _e292);
                    let _e294 = (_e271 - _e292);
                    let _e295 = select(_e280, 0f, _e284);
                    if _e284 {
                        phi_463_ = 38685626000000000000000000f;
                    } else {
                        phi_463_ = (1f / _e280);
                    }
                    let _e298 = phi_463_;
                    let _e299 = (_e192 == 0u);
                    if _e299 {
                        phi_472_ = _e221[0];
                    } else {
                        phi_472_ = _e221[1];
                    }
                    let _e303 = phi_472_;
                    let _e304 = (_e192 == 2u);
                    if _e304 {
                        phi_478_ = _e221[2];
                    } else {
                        phi_478_ = _e303;
                    }
                    let _e307 = phi_478_;
                    let _e309 = ((_e307 * _e198) * _e204);
                    if _e299 {
                        phi_489_ = _e233[0];
                    } else {
                        phi_489_ = _e233[1];
                    }
                    let _e313 = phi_489_;
                    if _e304 {
                        phi_495_ = _e233[2];
                    } else {
                        phi_495_ = _e313;
                    }
                    let _e316 = phi_495_;
                    let _e318 = ((_e316 * _e211) * _e217);
                    let _e322 = (bitcast<f32>((bitcast<u32>(_e318) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e322 {
                        let _e326 = (bitcast<f32>((bitcast<u32>(_e309) & 2147483647u)) * 0.00000011920929f);
                        phi_518_ = select(0.00000000000011368684f, _e326, (_e326 > 0.00000000000011368684f));
                    } else {
                        phi_518_ = 0f;
                    }
                    let _e330 = phi_518_;
                    let _e331 = (_e309 + _e330);
                    let _e332 = (_e309 - _e330);
                    let _e333 = select(_e318, 0f, _e322);
                    if _e322 {
                        phi_529_ = 38685626000000000000000000f;
                    } else {
                        phi_529_ = (1f / _e318);
                    }
                    let _e336 = phi_529_;
                    let _e339 = bitcast<f32>((bitcast<u32>(_e232) & 2147483647u));
                    let _e342 = bitcast<f32>((bitcast<u32>(_e271) & 2147483647u));
                    let _e344 = select(_e342, _e339, (_e339 > _e342));
                    let _e347 = bitcast<f32>((bitcast<u32>(_e309) & 2147483647u));
                    let _e350 = (_e77 + _e172);
                    if (_e153 && (select(_e347, _e344, (_e344 > _e347)) <= 1099511600000f)) {
                        let _e353 = (_e350 / 3i);
                        let _e360 = bitcast<f32>((bitcast<u32>((_e353 + 127i)) << bitcast<u32>(23i)));
                        let _e367 = bitcast<f32>((bitcast<u32>(((_e350 - (2i * _e353)) + 127i)) << bitcast<u32>(23i)));
                        let _e368 = (((_e138 * _e360) * _e360) * _e367);
                        let _e370 = select(340282350000000000000000000000000000000f, _e368, (_e368 < 340282350000000000000000000000000000000f));
                        let _e375 = (((_e147 * _e360) * _e360) * _e367);
                        let _e377 = select(340282350000000000000000000000000000000f, _e375, (_e375 < 340282350000000000000000000000000000000f));
                        phi_629_ = select(-340282350000000000000000000000000000000f, _e377, (_e377 > -340282350000000000000000000000000000000f));
                        phi_630_ = select(-340282350000000000000000000000000000000f, _e370, (_e370 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_629_ = 0f;
                        phi_630_ = 1f;
                    }
                    let _e381 = phi_629_;
                    let _e383 = phi_630_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2232_ = false;
                    phi_905_ = type_47(type_39(type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e381), 0u, 0u);
                    phi_908_ = select(0u, 2147483648u, (_e63 == 0u));
                    phi_910_ = ((3u * _e63) + 1u);
                    phi_912_ = (_e383 <= _e381);
                    phi_914_ = 0u;
                    loop {
                        let _e392 = phi_2232_;
                        let _e394 = phi_905_;
                        let _e396 = phi_908_;
                        let _e398 = phi_910_;
                        let _e400 = phi_912_;
                        let _e402 = phi_914_;
                        local_2 = _e394;
                        local_3 = _e394;
                        if _e400 {
                            phi_925_ = true;
                        } else {
                            phi_925_ = (_e402 > 0u);
                        }
                        let _e405 = phi_925_;
                        if _e405 {
                            let _e406 = (_e398 > 0u);
                            if _e406 {
                                if _e400 {
                                    phi_956_ = _e396;
                                    phi_957_ = _e400;
                                    phi_958_ = _e402;
                                } else {
                                    let _e407 = (_e402 - 1u);
                                    let _e408 = (_e407 % 128u);
                                    let _e409 = (_e408 < 128u);
                                    if _e409 {
                                    } else {
                                        phi_2336_ = true;
                                        break;
                                    }
                                    let _e411 = local_1[_e408];
                                    if _e409 {
                                    } else {
                                        phi_2336_ = true;
                                        break;
                                    }
                                    let _e413 = local[_e408];
                                    phi_956_ = _e411;
                                    phi_957_ = (_e413 <= _e394.member.member_1);
                                    phi_958_ = _e407;
                                }
                                let _e418 = phi_956_;
                                let _e420 = phi_957_;
                                let _e422 = phi_958_;
                                if _e420 {
                                    if ((_e418 & 2147483648u) != 0u) {
                                        phi_973_ = _e394;
                                        phi_976_ = type_4(0u, ((_e418 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e627 = phi_973_;
                                            let _e629 = phi_976_;
                                            local_4 = _e627;
                                            if (_e629.member < _e629.member_1) {
                                                phi_977_ = type_4((_e629.member + 1u), _e629.member_1);
                                                phi_999_ = type_4(1u, _e629.member);
                                            } else {
                                                phi_977_ = _e629;
                                                phi_999_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e642 = phi_977_;
                                            let _e644 = phi_999_;
                                            let _e648 = (bitcast<i32>(_e644.member) != 0i);
                                            if _e648 {
                                                let _e654 = type_47(_e627.member, _e627.member_1, (_e627.member_2 + 1u));
                                                let _e655 = ((_e418 & 268435455u) + _e644.member_1);
                                                let _e656 = (_e655 < _e65);
                                                if _e656 {
                                                    if _e656 {
                                                    } else {
                                                        phi_2226_ = true;
                                                        break;
                                                    }
                                                    let _e660 = global_3.member[_e655].member_1;
                                                    phi_1023_ = _e660;
                                                } else {
                                                    phi_1023_ = 4294967295u;
                                                }
                                                let _e662 = phi_1023_;
                                                if (_e655 >= _e65) {
                                                    phi_1112_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e656 {
                                                    } else {
                                                        phi_2226_ = true;
                                                        break;
                                                    }
                                                    let _e664 = (_e191 % 3u);
                                                    let _e665 = (_e190 % 3u);
                                                    let _e666 = (_e192 % 3u);
                                                    if (_e664 < 9u) {
                                                    } else {
                                                        phi_2226_ = true;
                                                        break;
                                                    }
                                                    let _e672 = global_3.member[_e655].member[_e664];
                                                    if (_e665 < 9u) {
                                                    } else {
                                                        phi_2226_ = true;
                                                        break;
                                                    }
                                                    let _e678 = global_3.member[_e655].member[_e665];
                                                    if (_e666 < 9u) {
                                                    } else {
                                                        phi_2226_ = true;
                                                        break;
                                                    }
                                                    let _e684 = global_3.member[_e655].member[_e666];
                                                    let _e686 = (3u + _e664);
                                                    if (_e686 < 9u) {
                                                    } else {
                                                        phi_2226_ = true;
                                                        break;
                                                    }
                                                    let _e692 = global_3.member[_e655].member[_e686];
                                                    let _e693 = (3u + _e665);
                                                    if (_e693 < 9u) {
                                                    } else {
                                                        phi_2226_ = true;
                                                        break;
                                                    }
                                                    let _e699 = global_3.member[_e655].member[_e693];
                                                    let _e700 = (3u + _e666);
                                                    if (_e700 < 9u) {
                                                    } else {
                                                        phi_2226_ = true;
                                                        break;
                                                    }
                                                    let _e706 = global_3.member[_e655].member[_e700];
                                                    let _e708 = (6u + _e664);
                                                    if (_e708 < 9u) {
                                                    } else {
                                                        phi_2226_ = true;
                                                        break;
                                                    }
                                                    let _e714 = global_3.member[_e655].member[_e708];
                                                    let _e715 = (6u + _e665);
                                                    if (_e715 < 9u) {
                                                    } else {
                                                        phi_2226_ = true;
                                                        break;
                                                    }
                                                    let _e721 = global_3.member[_e655].member[_e715];
                                                    let _e722 = (6u + _e666);
                                                    if (_e722 < 9u) {
                                                    } else {
                                                        phi_2226_ = true;
                                                        break;
                                                    }
                                                    let _e728 = global_3.member[_e655].member[_e722];
                                                    phi_1112_ = array<array<f32, 3>, 3>(array<f32, 3>(_e672, _e678, _e684), array<f32, 3>(_e692, _e699, _e706), array<f32, 3>(_e714, _e721, _e728));
                                                }
                                                let _e732 = phi_1112_;
                                                let _e741 = (_e732[0][2] - _e309);
                                                let _e744 = (((_e732[0][0] - _e232) * _e333) - (_e741 * _e257));
                                                let _e747 = (((_e732[0][1] - _e271) * _e333) - (_e741 * _e295));
                                                let _e754 = (_e732[1][2] - _e309);
                                                let _e757 = (((_e732[1][0] - _e232) * _e333) - (_e754 * _e257));
                                                let _e760 = (((_e732[1][1] - _e271) * _e333) - (_e754 * _e295));
                                                let _e767 = (_e732[2][2] - _e309);
                                                let _e770 = (((_e732[2][0] - _e232) * _e333) - (_e767 * _e257));
                                                let _e773 = (((_e732[2][1] - _e271) * _e333) - (_e767 * _e295));
                                                let _e774 = (_e770 * _e760);
                                                let _e775 = (_e773 * _e757);
                                                let _e776 = (_e744 * _e773);
                                                let _e777 = (_e747 * _e770);
                                                let _e778 = (_e757 * _e747);
                                                let _e779 = (_e760 * _e744);
                                                let _e784 = (((_e774 >= _e775) && (_e776 >= _e777)) && (_e778 >= _e779));
                                                if (_e784 || (((_e774 <= _e775) && (_e776 <= _e777)) && (_e778 <= _e779))) {
                                                    let _e791 = select(-1f, 1f, _e784);
                                                    let _e793 = ((_e774 - _e775) * _e791);
                                                    let _e795 = select(0f, _e793, (_e793 > 0f));
                                                    let _e797 = ((_e776 - _e777) * _e791);
                                                    let _e799 = select(0f, _e797, (_e797 > 0f));
                                                    let _e801 = ((_e778 - _e779) * _e791);
                                                    let _e803 = select(0f, _e801, (_e801 > 0f));
                                                    let _e805 = ((_e795 + _e799) + _e803);
                                                    if (_e805 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1678_ = type_27();
                                                        phi_1679_ = true;
                                                    } else {
                                                        let _e808 = select(_e732[1][0], _e732[0][0], (_e732[0][0] < _e732[1][0]));
                                                        let _e812 = select(_e732[1][0], _e732[0][0], (_e732[0][0] > _e732[1][0]));
                                                        let _e816 = select(_e732[1][1], _e732[0][1], (_e732[0][1] < _e732[1][1]));
                                                        let _e820 = select(_e732[1][1], _e732[0][1], (_e732[0][1] > _e732[1][1]));
                                                        let _e824 = select(_e732[1][2], _e732[0][2], (_e732[0][2] < _e732[1][2]));
                                                        let _e828 = select(_e732[1][2], _e732[0][2], (_e732[0][2] > _e732[1][2]));
                                                        let _e833 = ((select(_e732[2][0], _e808, (_e808 < _e732[2][0])) - _e255) * _e260);
                                                        let _e834 = ((select(_e732[2][0], _e812, (_e812 > _e732[2][0])) - _e256) * _e260);
                                                        let _e837 = ((select(_e732[2][1], _e816, (_e816 < _e732[2][1])) - _e293) * _e298);
                                                        let _e838 = ((select(_e732[2][1], _e820, (_e820 > _e732[2][1])) - _e294) * _e298);
                                                        let _e841 = ((select(_e732[2][2], _e824, (_e824 < _e732[2][2])) - _e331) * _e336);
                                                        let _e842 = ((select(_e732[2][2], _e828, (_e828 > _e732[2][2])) - _e332) * _e336);
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
                                                        let _e869 = select(_e383, _e854, (_e854 > _e383));
                                                        if (_e869 > (_e862 + (select(_e863, _e846, (_e846 > _e863)) * 0.0000019073523f))) {
                                                            phi_1673_ = type_27();
                                                            phi_1674_ = true;
                                                        } else {
                                                            let _e871 = (_e869 > _e627.member.member_1);
                                                            if _e871 {
                                                                phi_1672_ = type_27();
                                                            } else {
                                                                let _e875 = (_e732[1][0] - _e732[0][0]);
                                                                let _e876 = (_e732[1][1] - _e732[0][1]);
                                                                let _e877 = (_e732[1][2] - _e732[0][2]);
                                                                let _e878 = vec3<f32>(_e875, _e876, _e877);
                                                                let _e879 = (_e732[2][0] - _e732[1][0]);
                                                                let _e880 = (_e732[2][1] - _e732[1][1]);
                                                                let _e881 = (_e732[2][2] - _e732[1][2]);
                                                                let _e882 = vec3<f32>(_e879, _e880, _e881);
                                                                let _e883 = (_e732[0][0] - _e732[2][0]);
                                                                let _e884 = (_e732[0][1] - _e732[2][1]);
                                                                let _e885 = (_e732[0][2] - _e732[2][2]);
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
                                                                    phi_1583_ = _e882;
                                                                    phi_1584_ = _e886;
                                                                } else {
                                                                    let _e932 = vec3((_e912 == _e929));
                                                                    phi_1583_ = select(_e878, _e886, _e932);
                                                                    phi_1584_ = select(_e882, _e878, _e932);
                                                                }
                                                                let _e936 = phi_1583_;
                                                                let _e938 = phi_1584_;
                                                                let _e945 = ((_e936.y * _e938.z) - (_e938.y * _e936.z));
                                                                let _e950 = ((_e936.z * _e938.x) - (_e938.z * _e936.x));
                                                                let _e953 = ((_e936.x * _e938.y) - (_e938.x * _e936.y));
                                                                if (_e795 >= _e799) {
                                                                    phi_1615_ = select(true, false, (_e795 >= _e803));
                                                                } else {
                                                                    phi_1615_ = true;
                                                                }
                                                                let _e958 = phi_1615_;
                                                                if _e958 {
                                                                    phi_1624_ = select(vec3<f32>(_e732[2][0], _e732[2][1], _e732[2][2]), vec3<f32>(_e732[1][0], _e732[1][1], _e732[1][2]), vec3((_e799 >= _e803)));
                                                                } else {
                                                                    phi_1624_ = vec3<f32>(_e732[0][0], _e732[0][1], _e732[0][2]);
                                                                }
                                                                let _e963 = phi_1624_;
                                                                let _e980 = ((((_e945 * (_e963.x - _e232)) + (_e950 * (_e963.y - _e271))) + (_e953 * (_e963.z - _e309))) / (((_e945 * _e257) + (_e950 * _e295)) + (_e953 * _e333)));
                                                                let _e982 = select(_e862, _e980, (_e980 < _e862));
                                                                let _e984 = select(_e854, _e982, (_e982 > _e854));
                                                                if (_e984 >= _e383) {
                                                                    let _e986 = (_e984 <= _e627.member.member_1);
                                                                    if _e986 {
                                                                        let _e987 = (1f / _e805);
                                                                        phi_1664_ = type_27(_e984, (_e799 * _e987), (_e803 * _e987), _e662);
                                                                    } else {
                                                                        phi_1664_ = type_27();
                                                                    }
                                                                    let _e992 = phi_1664_;
                                                                    phi_1666_ = _e992;
                                                                    phi_1667_ = select(true, false, _e986);
                                                                } else {
                                                                    phi_1666_ = type_27();
                                                                    phi_1667_ = true;
                                                                }
                                                                let _e995 = phi_1666_;
                                                                let _e997 = phi_1667_;
                                                                if _e997 {
                                                                    phi_1671_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1671_ = _e995;
                                                                }
                                                                let _e999 = phi_1671_;
                                                                phi_1672_ = _e999;
                                                            }
                                                            let _e1001 = phi_1672_;
                                                            phi_1673_ = _e1001;
                                                            phi_1674_ = _e871;
                                                        }
                                                        let _e1003 = phi_1673_;
                                                        let _e1005 = phi_1674_;
                                                        phi_1678_ = _e1003;
                                                        phi_1679_ = _e1005;
                                                    }
                                                    let _e1007 = phi_1678_;
                                                    let _e1009 = phi_1679_;
                                                    phi_1683_ = _e1007;
                                                    phi_1684_ = _e1009;
                                                } else {
                                                    phi_1683_ = type_27();
                                                    phi_1684_ = true;
                                                }
                                                let _e1011 = phi_1683_;
                                                let _e1013 = phi_1684_;
                                                if _e1013 {
                                                    phi_1688_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1688_ = _e1011;
                                                }
                                                let _e1015 = phi_1688_;
                                                if (_e1015.member_3 != 4294967295u) {
                                                    if (_e662 != 4294967295u) {
                                                        if (_e1015.member < _e627.member.member.member) {
                                                            phi_1714_ = true;
                                                        } else {
                                                            if (_e1015.member == _e627.member.member.member) {
                                                                phi_1713_ = (_e1015.member_3 < _e627.member.member.member_3);
                                                            } else {
                                                                phi_1713_ = false;
                                                            }
                                                            let _e1030 = phi_1713_;
                                                            phi_1714_ = _e1030;
                                                        }
                                                        let _e1032 = phi_1714_;
                                                        if _e1032 {
                                                            phi_1721_ = type_47(type_39(_e1015, _e1015.member), _e654.member_1, _e654.member_2);
                                                        } else {
                                                            phi_1721_ = _e654;
                                                        }
                                                        let _e1039 = phi_1721_;
                                                        phi_1722_ = _e1039;
                                                    } else {
                                                        phi_1722_ = _e654;
                                                    }
                                                    let _e1041 = phi_1722_;
                                                    phi_1723_ = _e1041;
                                                } else {
                                                    phi_1723_ = _e654;
                                                }
                                                let _e1043 = phi_1723_;
                                                phi_974_ = _e1043;
                                            } else {
                                                phi_974_ = type_47();
                                            }
                                            let _e1045 = phi_974_;
                                            continue;
                                            continuing {
                                                phi_973_ = _e1045;
                                                phi_976_ = _e642;
                                                phi_2226_ = _e392;
                                                break if !(_e648);
                                            }
                                        }
                                        let _e1048 = phi_2226_;
                                        phi_2336_ = _e1048;
                                        if _e1048 {
                                            break;
                                        }
                                        phi_2340_ = _e1048;
                                        let _e1192 = local_4;
                                        phi_2180_ = _e1192;
                                        phi_2181_ = _e418;
                                        phi_2182_ = false;
                                        phi_2183_ = _e422;
                                    } else {
                                        if (_e418 >= _e63) {
                                            phi_1786_ = type_43(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e418 < _e63) {
                                            } else {
                                                phi_2336_ = true;
                                                break;
                                            }
                                            let _e438 = (_e191 % 3u);
                                            if (_e438 < 3u) {
                                            } else {
                                                phi_2336_ = true;
                                                break;
                                            }
                                            let _e444 = global_2.member[_e418].member[_e438];
                                            let _e450 = (_e190 % 3u);
                                            if (_e450 < 3u) {
                                            } else {
                                                phi_2336_ = true;
                                                break;
                                            }
                                            let _e456 = global_2.member[_e418].member[_e450];
                                            let _e462 = (_e192 % 3u);
                                            if (_e462 < 3u) {
                                            } else {
                                                phi_2336_ = true;
                                                break;
                                            }
                                            let _e468 = global_2.member[_e418].member[_e462];
                                            let _e478 = global_2.member[_e418].member_1;
                                            let _e482 = global_2.member[_e418].member_2;
                                            phi_1786_ = type_43(array<vec4<f32>, 3>(vec4<f32>(_e444[0], _e444[1], _e444[2], _e444[3]), vec4<f32>(_e456[0], _e456[1], _e456[2], _e456[3]), vec4<f32>(_e468[0], _e468[1], _e468[2], _e468[3])), _e478, _e482);
                                        }
                                        let _e485 = phi_1786_;
                                        let _e498 = ((_e485.member[0].x - _e255) * _e260);
                                        let _e499 = ((_e485.member[0].y - _e255) * _e260);
                                        let _e500 = ((_e485.member[0].z - _e256) * _e260);
                                        let _e501 = ((_e485.member[0].w - _e256) * _e260);
                                        let _e511 = ((_e485.member[1].x - _e293) * _e298);
                                        let _e512 = ((_e485.member[1].y - _e293) * _e298);
                                        let _e513 = ((_e485.member[1].z - _e294) * _e298);
                                        let _e514 = ((_e485.member[1].w - _e294) * _e298);
                                        let _e524 = ((_e485.member[2].x - _e331) * _e336);
                                        let _e525 = ((_e485.member[2].y - _e331) * _e336);
                                        let _e526 = ((_e485.member[2].z - _e332) * _e336);
                                        let _e527 = ((_e485.member[2].w - _e332) * _e336);
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
                                        let _e579 = select(_e383, _e549, (_e549 > _e383));
                                        let _e581 = select(_e383, _e551, (_e551 > _e383));
                                        let _e586 = (_e579 <= select(_e394.member.member_1, _e576, (_e576 < _e394.member.member_1)));
                                        let _e587 = (_e581 <= select(_e394.member.member_1, _e577, (_e577 < _e394.member.member_1)));
                                        let _e588 = (_e579 <= _e581);
                                        if _e586 {
                                            if _e587 {
                                                if _e588 {
                                                    phi_2130_ = _e485.member_2;
                                                } else {
                                                    phi_2130_ = _e485.member_1;
                                                }
                                                let _e592 = phi_2130_;
                                                let _e593 = (_e422 % 128u);
                                                let _e594 = (_e593 < 128u);
                                                if _e594 {
                                                } else {
                                                    phi_2336_ = true;
                                                    break;
                                                }
                                                local_1[_e593] = _e592;
                                                if _e594 {
                                                } else {
                                                    phi_2336_ = true;
                                                    break;
                                                }
                                                local[_e593] = select(_e581, _e579, (_e579 > _e581));
                                                if _e588 {
                                                    phi_2157_ = _e485.member_1;
                                                } else {
                                                    phi_2157_ = _e485.member_2;
                                                }
                                                let _e603 = phi_2157_;
                                                phi_2158_ = _e603;
                                                phi_2159_ = (_e422 + 1u);
                                            } else {
                                                phi_2158_ = u32();
                                                phi_2159_ = u32();
                                            }
                                            let _e605 = phi_2158_;
                                            let _e607 = phi_2159_;
                                            phi_2161_ = _e605;
                                            phi_2162_ = _e607;
                                            phi_2163_ = select(true, false, _e587);
                                        } else {
                                            phi_2161_ = u32();
                                            phi_2162_ = u32();
                                            phi_2163_ = true;
                                        }
                                        let _e610 = phi_2161_;
                                        let _e612 = phi_2162_;
                                        let _e614 = phi_2163_;
                                        if _e614 {
                                            if _e586 {
                                                phi_2172_ = _e485.member_1;
                                            } else {
                                                phi_2172_ = _e485.member_2;
                                            }
                                            let _e618 = phi_2172_;
                                            phi_2177_ = _e618;
                                            phi_2178_ = select(_e587, true, _e586);
                                        } else {
                                            phi_2177_ = _e610;
                                            phi_2178_ = _e420;
                                        }
                                        let _e621 = phi_2177_;
                                        let _e623 = phi_2178_;
                                        phi_2340_ = _e392;
                                        phi_2180_ = type_47(_e394.member, (_e394.member_1 + 1u), _e394.member_2);
                                        phi_2181_ = _e621;
                                        phi_2182_ = _e623;
                                        phi_2183_ = select(_e612, _e422, _e614);
                                    }
                                    let _e1050 = phi_2340_;
                                    let _e1052 = phi_2180_;
                                    let _e1054 = phi_2181_;
                                    let _e1056 = phi_2182_;
                                    let _e1058 = phi_2183_;
                                    phi_2339_ = _e1050;
                                    phi_2184_ = _e1052;
                                    phi_2185_ = _e1054;
                                    phi_2186_ = (_e398 - 1u);
                                    phi_2187_ = _e1056;
                                    phi_2188_ = _e1058;
                                } else {
                                    phi_2339_ = _e392;
                                    phi_2184_ = _e394;
                                    phi_2185_ = _e418;
                                    phi_2186_ = _e398;
                                    phi_2187_ = _e420;
                                    phi_2188_ = _e422;
                                }
                                let _e1060 = phi_2339_;
                                let _e1062 = phi_2184_;
                                let _e1064 = phi_2185_;
                                let _e1066 = phi_2186_;
                                let _e1068 = phi_2187_;
                                let _e1070 = phi_2188_;
                                phi_2338_ = _e1060;
                                phi_2189_ = _e1062;
                                phi_2190_ = _e1064;
                                phi_2191_ = _e1066;
                                phi_2192_ = _e1068;
                                phi_2193_ = _e1070;
                            } else {
                                phi_2338_ = _e392;
                                phi_2189_ = type_47();
                                phi_2190_ = u32();
                                phi_2191_ = u32();
                                phi_2192_ = bool();
                                phi_2193_ = u32();
                            }
                            let _e1072 = phi_2338_;
                            let _e1074 = phi_2189_;
                            let _e1076 = phi_2190_;
                            let _e1078 = phi_2191_;
                            let _e1080 = phi_2192_;
                            let _e1082 = phi_2193_;
                            phi_2337_ = _e1072;
                            phi_906_ = _e1074;
                            phi_909_ = _e1076;
                            phi_911_ = _e1078;
                            phi_913_ = _e1080;
                            phi_915_ = _e1082;
                            phi_2194_ = _e406;
                        } else {
                            phi_2337_ = _e392;
                            phi_906_ = type_47();
                            phi_909_ = u32();
                            phi_911_ = u32();
                            phi_913_ = bool();
                            phi_915_ = u32();
                            phi_2194_ = false;
                        }
                        let _e1084 = phi_2337_;
                        let _e1086 = phi_906_;
                        let _e1088 = phi_909_;
                        let _e1090 = phi_911_;
                        let _e1092 = phi_913_;
                        let _e1094 = phi_915_;
                        let _e1096 = phi_2194_;
                        continue;
                        continuing {
                            phi_2232_ = _e1084;
                            phi_905_ = _e1086;
                            phi_908_ = _e1088;
                            phi_910_ = _e1090;
                            phi_912_ = _e1092;
                            phi_914_ = _e1094;
                            phi_2336_ = _e1084;
                            break if !(_e1096);
                        }
                    }
                    let _e1099 = phi_2336_;
                    if _e1099 {
                        break;
                    }
                    let _e1101 = local_2;
                    let _e1104 = local_3;
                    if _e79 {
                    } else {
                        break;
                    }
                    global_5.member[_e73][0u] = _e1101.member_1;
                    global_5.member[_e73][1u] = _e1104.member_2;
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
