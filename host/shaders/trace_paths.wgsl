struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_13 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_15 {
    member: array<type_13>,
}

struct type_22 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_24 {
    member: array<type_22>,
}

struct type_26 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_27 {
    member: type_26,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_29 {
    member: array<type_27>,
}

struct type_34 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_36 {
    member: array<type_34>,
}

struct type_42 {
    member: type_22,
    member_1: f32,
}

struct type_46 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_51 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_1: type_15;
@group(0) @binding(0) 
var<storage> global_2: type_36;
@group(0) @binding(2) 
var<storage> global_3: type_29;
@group(0) @binding(3) 
var<storage, read_write> global_4: type_24;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_51;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_276_: i32;
    var phi_277_: i32;
    var phi_287_: bool;
    var phi_297_: u32;
    var phi_298_: u32;
    var phi_300_: bool;
    var phi_305_: u32;
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
    var phi_2358_: bool;
    var phi_919_: type_42;
    var phi_922_: u32;
    var phi_924_: u32;
    var phi_926_: bool;
    var phi_928_: u32;
    var phi_939_: bool;
    var phi_970_: u32;
    var phi_971_: bool;
    var phi_972_: u32;
    var phi_1793_: type_46;
    var phi_2137_: u32;
    var phi_2164_: u32;
    var phi_2165_: u32;
    var phi_2166_: u32;
    var phi_2168_: u32;
    var phi_2169_: u32;
    var phi_2170_: bool;
    var phi_2179_: u32;
    var phi_2184_: u32;
    var phi_2185_: bool;
    var phi_987_: type_42;
    var phi_990_: type_7;
    var phi_991_: type_7;
    var phi_1013_: type_7;
    var phi_1034_: u32;
    var phi_1123_: array<array<f32, 3>, 3>;
    var phi_1594_: vec3<f32>;
    var phi_1595_: vec3<f32>;
    var phi_1626_: bool;
    var phi_1635_: vec3<f32>;
    var phi_1675_: type_22;
    var phi_1677_: type_22;
    var phi_1678_: bool;
    var phi_1682_: type_22;
    var phi_1683_: type_22;
    var phi_1684_: type_22;
    var phi_1685_: bool;
    var phi_1689_: type_22;
    var phi_1690_: bool;
    var phi_1694_: type_22;
    var phi_1695_: bool;
    var phi_1699_: type_22;
    var phi_1724_: bool;
    var phi_1725_: bool;
    var phi_1731_: type_42;
    var phi_1732_: type_42;
    var phi_1733_: type_42;
    var phi_988_: type_42;
    var phi_2352_: bool;
    var phi_2470_: bool;
    var phi_2187_: type_42;
    var phi_2188_: u32;
    var phi_2189_: bool;
    var phi_2190_: u32;
    var phi_2469_: bool;
    var phi_2191_: type_42;
    var phi_2192_: u32;
    var phi_2193_: u32;
    var phi_2194_: bool;
    var phi_2195_: u32;
    var phi_2468_: bool;
    var phi_2196_: type_42;
    var phi_2197_: u32;
    var phi_2198_: u32;
    var phi_2199_: bool;
    var phi_2200_: u32;
    var phi_2467_: bool;
    var phi_920_: type_42;
    var phi_923_: u32;
    var phi_925_: u32;
    var phi_927_: bool;
    var phi_929_: u32;
    var phi_2201_: bool;
    var phi_2466_: bool;
    var local_2: type_42;
    var phi_2253_: type_22;
    var local_3: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e63 = global;
            let _e65 = arrayLength((&global_2.member));
            let _e67 = arrayLength((&global_1.member));
            let _e73 = arrayLength((&global_5.member));
            let _e77 = (_e63.x + (_e63.y * 2097152u));
            let _e78 = (_e77 < arrayLength((&global_3.member)));
            if _e78 {
                let _e79 = (_e77 < arrayLength((&global_4.member)));
                if _e79 {
                    if _e78 {
                    } else {
                        break;
                    }
                    if _e78 {
                    } else {
                        break;
                    }
                    let _e83 = global_3.member[_e77].member_2;
                    let _e93 = global_3.member[_e77].member.member_2[0u];
                    let _e95 = (bitcast<u32>(_e93) & 2147483647u);
                    let _e101 = global_3.member[_e77].member.member_2[1u];
                    let _e103 = (bitcast<u32>(_e101) & 2147483647u);
                    let _e109 = global_3.member[_e77].member.member_2[2u];
                    let _e111 = (bitcast<u32>(_e109) & 2147483647u);
                    let _e117 = global_3.member[_e77].member.member[0u];
                    let _e119 = (bitcast<u32>(_e117) & 2147483647u);
                    let _e125 = global_3.member[_e77].member.member[1u];
                    let _e127 = (bitcast<u32>(_e125) & 2147483647u);
                    let _e133 = global_3.member[_e77].member.member[2u];
                    let _e135 = (bitcast<u32>(_e133) & 2147483647u);
                    let _e137 = select(_e103, _e95, (_e103 < _e95));
                    let _e139 = select(_e111, _e137, (_e111 < _e137));
                    let _e141 = select(_e119, _e139, (_e119 < _e139));
                    let _e143 = select(_e127, _e141, (_e127 < _e141));
                    let _e145 = select(_e135, _e143, (_e135 < _e143));
                    let _e150 = global_3.member[_e77].member.member_1;
                    let _e152 = (bitcast<u32>(_e150) & 2147483647u);
                    let _e160 = global_3.member[_e77].member.member_3;
                    let _e166 = (((select(_e152, _e145, (_e152 < _e145)) < 2139095040u) && ((bitcast<u32>(_e160) & 2147483647u) <= 2139095040u)) && (_e139 > 0u));
                    if _e166 {
                        let _e169 = (bitcast<u32>(bitcast<f32>(_e139)) & 2147483647u);
                        if (_e169 >= 8388608u) {
                            phi_276_ = (bitcast<i32>((_e169 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_276_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e169)), 32u, (_e169 == 0u))));
                        }
                        let _e183 = phi_276_;
                        phi_277_ = _e183;
                    } else {
                        phi_277_ = 0i;
                    }
                    let _e185 = phi_277_;
                    let _e186 = (_e95 == _e139);
                    if _e186 {
                        phi_287_ = true;
                    } else {
                        phi_287_ = (_e103 == _e139);
                    }
                    let _e189 = phi_287_;
                    let _e190 = select(1u, 0u, _e186);
                    if _e189 {
                        let _e191 = (_e190 + 1u);
                        phi_297_ = _e191;
                        phi_298_ = _e191;
                        phi_300_ = select(true, false, (_e191 == 2u));
                    } else {
                        phi_297_ = u32();
                        phi_298_ = 0u;
                        phi_300_ = true;
                    }
                    let _e195 = phi_297_;
                    let _e197 = phi_298_;
                    let _e199 = phi_300_;
                    if _e199 {
                        phi_305_ = (_e197 + 1u);
                    } else {
                        phi_305_ = 0u;
                    }
                    let _e203 = phi_305_;
                    let _e204 = select(_e195, _e197, _e199);
                    let _e205 = select(_e190, select(2u, _e190, _e189), _e199);
                    let _e206 = -(_e185);
                    if (_e206 < -126i) {
                        phi_337_ = -126i;
                    } else {
                        phi_337_ = select(_e206, 127i, (_e206 > 127i));
                    }
                    let _e211 = phi_337_;
                    let _e216 = bitcast<f32>((bitcast<u32>((_e211 + 127i)) << bitcast<u32>(23i)));
                    let _e222 = bitcast<f32>((bitcast<u32>(((_e206 - _e211) + 127i)) << bitcast<u32>(23i)));
                    let _e227 = global_3.member[_e77].member.member;
                    let _e228 = (_e204 == 0u);
                    if _e228 {
                        phi_355_ = _e227[0];
                    } else {
                        phi_355_ = _e227[1];
                    }
                    let _e232 = phi_355_;
                    let _e233 = (_e204 == 2u);
                    if _e233 {
                        phi_361_ = _e227[2];
                    } else {
                        phi_361_ = _e232;
                    }
                    let _e236 = phi_361_;
                    let _e237 = global_3.member[_e77].member.member_2;
                    if _e228 {
                        phi_372_ = _e237[0];
                    } else {
                        phi_372_ = _e237[1];
                    }
                    let _e241 = phi_372_;
                    if _e233 {
                        phi_378_ = _e237[2];
                    } else {
                        phi_378_ = _e241;
                    }
                    let _e244 = phi_378_;
                    let _e246 = ((_e244 * _e216) * _e222);
                    let _e250 = (bitcast<f32>((bitcast<u32>(_e246) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e250 {
                        let _e254 = (bitcast<f32>((bitcast<u32>(_e236) & 2147483647u)) * 0.00000011920929f);
                        phi_401_ = select(0.00000000000011368684f, _e254, (_e254 > 0.00000000000011368684f));
                    } else {
                        phi_401_ = 0f;
                    }
                    let _e258 = phi_401_;
                    let _e259 = (_e236 + _e258);
                    let _e260 = (_e236 - _e258);
                    let _e261 = select(_e246, 0f, _e250);
                    if _e250 {
                        phi_412_ = 38685626000000000000000000f;
                    } else {
                        phi_412_ = (1f / _e246);
                    }
                    let _e264 = phi_412_;
                    let _e265 = (_e203 == 0u);
                    if _e265 {
                        phi_421_ = _e227[0];
                    } else {
                        phi_421_ = _e227[1];
                    }
                    let _e269 = phi_421_;
                    let _e270 = (_e203 == 2u);
                    if _e270 {
                        phi_427_ = _e227[2];
                    } else {
                        phi_427_ = _e269;
                    }
                    let _e273 = phi_427_;
                    if _e265 {
                        phi_438_ = _e237[0];
                    } else {
                        phi_438_ = _e237[1];
                    }
                    let _e277 = phi_438_;
                    if _e270 {
                        phi_444_ = _e237[2];
                    } else {
                        phi_444_ = _e277;
                    }
                    let _e280 = phi_444_;
                    let _e282 = ((_e280 * _e216) * _e222);
                    let _e286 = (bitcast<f32>((bitcast<u32>(_e282) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e286 {
                        let _e290 = (bitcast<f32>((bitcast<u32>(_e273) & 2147483647u)) * 0.00000011920929f);
                        phi_467_ = select(0.00000000000011368684f, _e290, (_e290 > 0.00000000000011368684f));
                    } else {
                        phi_467_ = 0f;
                    }
                    let _e294 = phi_467_;
                    let _e295 = (_e273 + _e294);
                    let _e296 = (_e273 - _e294);
                    let _e297 = select(_e282, 0f, _e286);
                    if _e286 {
                        phi_478_ = 38685626000000000000000000f;
                    } else {
                        phi_478_ = (1f / _e282);
                    }
                    let _e300 = phi_478_;
                    let _e301 = (_e205 == 0u);
                    if _e301 {
                        phi_487_ = _e227[0];
                    } else {
                        phi_487_ = _e227[1];
                    }
                    let _e305 = phi_487_;
                    let _e306 = (_e205 == 2u);
                    if _e306 {
                        phi_493_ = _e227[2];
                    } else {
                        phi_493_ = _e305;
                    }
                    let _e309 = phi_493_;
                    if _e301 {
                        phi_504_ = _e237[0];
                    } else {
                        phi_504_ = _e237[1];
                    }
                    let _e313 = phi_504_;
                    if _e306 {
                        phi_510_ = _e237[2];
                    } else {
                        phi_510_ = _e313;
                    }
                    let _e316 = phi_510_;
                    let _e318 = ((_e316 * _e216) * _e222);
                    let _e322 = (bitcast<f32>((bitcast<u32>(_e318) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e322 {
                        let _e326 = (bitcast<f32>((bitcast<u32>(_e309) & 2147483647u)) * 0.00000011920929f);
                        phi_533_ = select(0.00000000000011368684f, _e326, (_e326 > 0.00000000000011368684f));
                    } else {
                        phi_533_ = 0f;
                    }
                    let _e330 = phi_533_;
                    let _e331 = (_e309 + _e330);
                    let _e332 = (_e309 - _e330);
                    let _e333 = select(_e318, 0f, _e322);
                    if _e322 {
                        phi_544_ = 38685626000000000000000000f;
                    } else {
                        phi_544_ = (1f / _e318);
                    }
                    let _e336 = phi_544_;
                    let _e339 = bitcast<f32>((bitcast<u32>(_e236) & 2147483647u));
                    let _e342 = bitcast<f32>((bitcast<u32>(_e273) & 2147483647u));
                    let _e344 = select(_e342, _e339, (_e339 > _e342));
                    let _e347 = bitcast<f32>((bitcast<u32>(_e309) & 2147483647u));
                    if (_e166 && (select(_e347, _e344, (_e344 > _e347)) <= 1099511600000f)) {
                        let _e352 = (_e185 / 3i);
                        let _e359 = bitcast<f32>((bitcast<u32>((_e352 + 127i)) << bitcast<u32>(23i)));
                        let _e366 = bitcast<f32>((bitcast<u32>(((_e185 - (2i * _e352)) + 127i)) << bitcast<u32>(23i)));
                        let _e367 = (((_e150 * _e359) * _e359) * _e366);
                        let _e369 = select(340282350000000000000000000000000000000f, _e367, (_e367 < 340282350000000000000000000000000000000f));
                        let _e374 = (((_e160 * _e359) * _e359) * _e366);
                        let _e376 = select(340282350000000000000000000000000000000f, _e374, (_e374 < 340282350000000000000000000000000000000f));
                        phi_644_ = select(-340282350000000000000000000000000000000f, _e376, (_e376 > -340282350000000000000000000000000000000f));
                        phi_645_ = select(-340282350000000000000000000000000000000f, _e369, (_e369 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_644_ = 0f;
                        phi_645_ = 1f;
                    }
                    let _e380 = phi_644_;
                    let _e382 = phi_645_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2358_ = false;
                    phi_919_ = type_42(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e380);
                    phi_922_ = select(0u, 2147483648u, (_e65 == 0u));
                    phi_924_ = ((3u * _e65) + 1u);
                    phi_926_ = (_e382 <= _e380);
                    phi_928_ = 0u;
                    loop {
                        let _e390 = phi_2358_;
                        let _e392 = phi_919_;
                        let _e394 = phi_922_;
                        let _e396 = phi_924_;
                        let _e398 = phi_926_;
                        let _e400 = phi_928_;
                        local_2 = _e392;
                        if _e398 {
                            phi_939_ = true;
                        } else {
                            phi_939_ = (_e400 > 0u);
                        }
                        let _e403 = phi_939_;
                        if _e403 {
                            let _e404 = (_e396 > 0u);
                            if _e404 {
                                if _e398 {
                                    phi_970_ = _e394;
                                    phi_971_ = _e398;
                                    phi_972_ = _e400;
                                } else {
                                    let _e405 = (_e400 - 1u);
                                    let _e406 = (_e405 % 128u);
                                    let _e407 = (_e406 < 128u);
                                    if _e407 {
                                    } else {
                                        phi_2466_ = true;
                                        break;
                                    }
                                    let _e409 = local_1[_e406];
                                    if _e407 {
                                    } else {
                                        phi_2466_ = true;
                                        break;
                                    }
                                    let _e411 = local[_e406];
                                    phi_970_ = _e409;
                                    phi_971_ = (_e411 <= _e392.member_1);
                                    phi_972_ = _e405;
                                }
                                let _e415 = phi_970_;
                                let _e417 = phi_971_;
                                let _e419 = phi_972_;
                                if _e417 {
                                    if ((_e415 & 2147483648u) != 0u) {
                                        phi_987_ = _e392;
                                        phi_990_ = type_7(0u, ((_e415 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e617 = phi_987_;
                                            let _e619 = phi_990_;
                                            local_3 = _e617;
                                            if (_e619.member < _e619.member_1) {
                                                phi_991_ = type_7((_e619.member + 1u), _e619.member_1);
                                                phi_1013_ = type_7(1u, _e619.member);
                                            } else {
                                                phi_991_ = _e619;
                                                phi_1013_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e632 = phi_991_;
                                            let _e634 = phi_1013_;
                                            let _e638 = (bitcast<i32>(_e634.member) != 0i);
                                            if _e638 {
                                                let _e639 = ((_e415 & 268435455u) + _e634.member_1);
                                                let _e640 = (_e639 < _e67);
                                                if _e640 {
                                                    if _e640 {
                                                    } else {
                                                        phi_2352_ = true;
                                                        break;
                                                    }
                                                    let _e644 = global_1.member[_e639].member_1;
                                                    phi_1034_ = _e644;
                                                } else {
                                                    phi_1034_ = 4294967295u;
                                                }
                                                let _e646 = phi_1034_;
                                                if (_e639 >= _e67) {
                                                    phi_1123_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e640 {
                                                    } else {
                                                        phi_2352_ = true;
                                                        break;
                                                    }
                                                    let _e648 = (_e204 % 3u);
                                                    let _e649 = (_e203 % 3u);
                                                    let _e650 = (_e205 % 3u);
                                                    if (_e648 < 9u) {
                                                    } else {
                                                        phi_2352_ = true;
                                                        break;
                                                    }
                                                    let _e656 = global_1.member[_e639].member[_e648];
                                                    if (_e649 < 9u) {
                                                    } else {
                                                        phi_2352_ = true;
                                                        break;
                                                    }
                                                    let _e662 = global_1.member[_e639].member[_e649];
                                                    if (_e650 < 9u) {
                                                    } else {
                                                        phi_2352_ = true;
                                                        break;
                                                    }
                                                    let _e668 = global_1.member[_e639].member[_e650];
                                                    let _e670 = (3u + _e648);
                                                    if (_e670 < 9u) {
                                                    } else {
                                                        phi_2352_ = true;
                                                        break;
                                                    }
                                                    let _e676 = global_1.member[_e639].member[_e670];
                                                    let _e677 = (3u + _e649);
                                                    if (_e677 < 9u) {
                                                    } else {
                                                        phi_2352_ = true;
                                                        break;
                                                    }
                                                    let _e683 = global_1.member[_e639].member[_e677];
                                                    let _e684 = (3u + _e650);
                                                    if (_e684 < 9u) {
                                                    } else {
                                                        phi_2352_ = true;
                                                        break;
                                                    }
                                                    let _e690 = global_1.member[_e639].member[_e684];
                                                    let _e692 = (6u + _e648);
                                                    if (_e692 < 9u) {
                                                    } else {
                                                        phi_2352_ = true;
                                                        break;
                                                    }
                                                    let _e698 = global_1.member[_e639].member[_e692];
                                                    let _e699 = (6u + _e649);
                                                    if (_e699 < 9u) {
                                                    } else {
                                                        phi_2352_ = true;
                                                        break;
                                                    }
                                                    let _e705 = global_1.member[_e639].member[_e699];
                                                    let _e706 = (6u + _e650);
                                                    if (_e706 < 9u) {
                                                    } else {
                                                        phi_2352_ = true;
                                                        break;
                                                    }
                                                    let _e712 = global_1.member[_e639].member[_e706];
                                                    phi_1123_ = array<array<f32, 3>, 3>(array<f32, 3>(_e656, _e662, _e668), array<f32, 3>(_e676, _e683, _e690), array<f32, 3>(_e698, _e705, _e712));
                                                }
                                                let _e716 = phi_1123_;
                                                let _e724 = (_e716[0][2] - _e309);
                                                let _e727 = (((_e716[0][0] - _e236) * _e333) - (_e724 * _e261));
                                                let _e730 = (((_e716[0][1] - _e273) * _e333) - (_e724 * _e297));
                                                let _e737 = (_e716[1][2] - _e309);
                                                let _e740 = (((_e716[1][0] - _e236) * _e333) - (_e737 * _e261));
                                                let _e743 = (((_e716[1][1] - _e273) * _e333) - (_e737 * _e297));
                                                let _e750 = (_e716[2][2] - _e309);
                                                let _e753 = (((_e716[2][0] - _e236) * _e333) - (_e750 * _e261));
                                                let _e756 = (((_e716[2][1] - _e273) * _e333) - (_e750 * _e297));
                                                let _e757 = (_e753 * _e743);
                                                let _e758 = (_e756 * _e740);
                                                let _e759 = (_e727 * _e756);
                                                let _e760 = (_e730 * _e753);
                                                let _e761 = (_e740 * _e730);
                                                let _e762 = (_e743 * _e727);
                                                let _e767 = (((_e757 >= _e758) && (_e759 >= _e760)) && (_e761 >= _e762));
                                                if (_e767 || (((_e757 <= _e758) && (_e759 <= _e760)) && (_e761 <= _e762))) {
                                                    let _e774 = select(-1f, 1f, _e767);
                                                    let _e776 = ((_e757 - _e758) * _e774);
                                                    let _e778 = select(0f, _e776, (_e776 > 0f));
                                                    let _e780 = ((_e759 - _e760) * _e774);
                                                    let _e782 = select(0f, _e780, (_e780 > 0f));
                                                    let _e784 = ((_e761 - _e762) * _e774);
                                                    let _e786 = select(0f, _e784, (_e784 > 0f));
                                                    let _e788 = ((_e778 + _e782) + _e786);
                                                    if (_e788 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1689_ = type_22();
                                                        phi_1690_ = true;
                                                    } else {
                                                        let _e791 = select(_e716[1][0], _e716[0][0], (_e716[0][0] < _e716[1][0]));
                                                        let _e795 = select(_e716[1][0], _e716[0][0], (_e716[0][0] > _e716[1][0]));
                                                        let _e799 = select(_e716[1][1], _e716[0][1], (_e716[0][1] < _e716[1][1]));
                                                        let _e803 = select(_e716[1][1], _e716[0][1], (_e716[0][1] > _e716[1][1]));
                                                        let _e807 = select(_e716[1][2], _e716[0][2], (_e716[0][2] < _e716[1][2]));
                                                        let _e811 = select(_e716[1][2], _e716[0][2], (_e716[0][2] > _e716[1][2]));
                                                        let _e816 = ((select(_e716[2][0], _e791, (_e791 < _e716[2][0])) - _e259) * _e264);
                                                        let _e817 = ((select(_e716[2][0], _e795, (_e795 > _e716[2][0])) - _e260) * _e264);
                                                        let _e820 = ((select(_e716[2][1], _e799, (_e799 < _e716[2][1])) - _e295) * _e300);
                                                        let _e821 = ((select(_e716[2][1], _e803, (_e803 > _e716[2][1])) - _e296) * _e300);
                                                        let _e824 = ((select(_e716[2][2], _e807, (_e807 < _e716[2][2])) - _e331) * _e336);
                                                        let _e825 = ((select(_e716[2][2], _e811, (_e811 > _e716[2][2])) - _e332) * _e336);
                                                        let _e827 = select(_e825, _e824, (_e824 < _e825));
                                                        let _e829 = select(_e825, _e824, (_e824 > _e825));
                                                        let _e831 = select(_e817, _e816, (_e816 < _e817));
                                                        let _e833 = select(_e821, _e820, (_e820 < _e821));
                                                        let _e835 = select(_e833, _e831, (_e831 > _e833));
                                                        let _e837 = select(_e827, _e835, (_e835 > _e827));
                                                        let _e839 = select(_e817, _e816, (_e816 > _e817));
                                                        let _e841 = select(_e821, _e820, (_e820 > _e821));
                                                        let _e843 = select(_e841, _e839, (_e839 < _e841));
                                                        let _e845 = select(_e829, _e843, (_e843 < _e829));
                                                        let _e846 = -(_e827);
                                                        let _e852 = select(_e382, _e837, (_e837 > _e382));
                                                        if (_e852 > (_e845 + (select(_e846, _e829, (_e829 > _e846)) * 0.0000019073523f))) {
                                                            phi_1684_ = type_22();
                                                            phi_1685_ = true;
                                                        } else {
                                                            let _e854 = (_e852 > _e617.member_1);
                                                            if _e854 {
                                                                phi_1683_ = type_22();
                                                            } else {
                                                                let _e858 = (_e716[1][0] - _e716[0][0]);
                                                                let _e859 = (_e716[1][1] - _e716[0][1]);
                                                                let _e860 = (_e716[1][2] - _e716[0][2]);
                                                                let _e861 = vec3<f32>(_e858, _e859, _e860);
                                                                let _e862 = (_e716[2][0] - _e716[1][0]);
                                                                let _e863 = (_e716[2][1] - _e716[1][1]);
                                                                let _e864 = (_e716[2][2] - _e716[1][2]);
                                                                let _e865 = vec3<f32>(_e862, _e863, _e864);
                                                                let _e866 = (_e716[0][0] - _e716[2][0]);
                                                                let _e867 = (_e716[0][1] - _e716[2][1]);
                                                                let _e868 = (_e716[0][2] - _e716[2][2]);
                                                                let _e869 = vec3<f32>(_e866, _e867, _e868);
                                                                let _e872 = bitcast<f32>((bitcast<u32>(_e858) & 2147483647u));
                                                                let _e875 = bitcast<f32>((bitcast<u32>(_e859) & 2147483647u));
                                                                let _e877 = select(_e875, _e872, (_e872 > _e875));
                                                                let _e880 = bitcast<f32>((bitcast<u32>(_e860) & 2147483647u));
                                                                let _e882 = select(_e880, _e877, (_e877 > _e880));
                                                                let _e885 = bitcast<f32>((bitcast<u32>(_e862) & 2147483647u));
                                                                let _e888 = bitcast<f32>((bitcast<u32>(_e863) & 2147483647u));
                                                                let _e890 = select(_e888, _e885, (_e885 > _e888));
                                                                let _e893 = bitcast<f32>((bitcast<u32>(_e864) & 2147483647u));
                                                                let _e895 = select(_e893, _e890, (_e890 > _e893));
                                                                let _e898 = bitcast<f32>((bitcast<u32>(_e866) & 2147483647u));
                                                                let _e901 = bitcast<f32>((bitcast<u32>(_e867) & 2147483647u));
                                                                let _e903 = select(_e901, _e898, (_e898 > _e901));
                                                                let _e906 = bitcast<f32>((bitcast<u32>(_e868) & 2147483647u));
                                                                let _e908 = select(_e906, _e903, (_e903 > _e906));
                                                                let _e910 = select(_e895, _e882, (_e882 > _e895));
                                                                let _e912 = select(_e908, _e910, (_e910 > _e908));
                                                                if (_e882 == _e912) {
                                                                    phi_1594_ = _e865;
                                                                    phi_1595_ = _e869;
                                                                } else {
                                                                    let _e915 = vec3((_e895 == _e912));
                                                                    phi_1594_ = select(_e861, _e869, _e915);
                                                                    phi_1595_ = select(_e865, _e861, _e915);
                                                                }
                                                                let _e919 = phi_1594_;
                                                                let _e921 = phi_1595_;
                                                                let _e928 = ((_e919.y * _e921.z) - (_e921.y * _e919.z));
                                                                let _e933 = ((_e919.z * _e921.x) - (_e921.z * _e919.x));
                                                                let _e936 = ((_e919.x * _e921.y) - (_e921.x * _e919.y));
                                                                if (_e778 >= _e782) {
                                                                    phi_1626_ = select(true, false, (_e778 >= _e786));
                                                                } else {
                                                                    phi_1626_ = true;
                                                                }
                                                                let _e941 = phi_1626_;
                                                                if _e941 {
                                                                    phi_1635_ = select(vec3<f32>(_e716[2][0], _e716[2][1], _e716[2][2]), vec3<f32>(_e716[1][0], _e716[1][1], _e716[1][2]), vec3((_e782 >= _e786)));
                                                                } else {
                                                                    phi_1635_ = vec3<f32>(_e716[0][0], _e716[0][1], _e716[0][2]);
                                                                }
                                                                let _e946 = phi_1635_;
                                                                let _e963 = ((((_e928 * (_e946.x - _e236)) + (_e933 * (_e946.y - _e273))) + (_e936 * (_e946.z - _e309))) / (((_e928 * _e261) + (_e933 * _e297)) + (_e936 * _e333)));
                                                                let _e965 = select(_e845, _e963, (_e963 < _e845));
                                                                let _e967 = select(_e837, _e965, (_e965 > _e837));
                                                                if (_e967 >= _e382) {
                                                                    let _e969 = (_e967 <= _e617.member_1);
                                                                    if _e969 {
                                                                        let _e970 = (1f / _e788);
                                                                        phi_1675_ = type_22(_e967, (_e782 * _e970), (_e786 * _e970), _e646);
                                                                    } else {
                                                                        phi_1675_ = type_22();
                                                                    }
                                                                    let _e975 = phi_1675_;
                                                                    phi_1677_ = _e975;
                                                                    phi_1678_ = select(true, false, _e969);
                                                                } else {
                                                                    phi_1677_ = type_22();
                                                                    phi_1678_ = true;
                                                                }
                                                                let _e978 = phi_1677_;
                                                                let _e980 = phi_1678_;
                                                                if _e980 {
                                                                    phi_1682_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1682_ = _e978;
                                                                }
                                                                let _e982 = phi_1682_;
                                                                phi_1683_ = _e982;
                                                            }
                                                            let _e984 = phi_1683_;
                                                            phi_1684_ = _e984;
                                                            phi_1685_ = _e854;
                                                        }
                                                        let _e986 = phi_1684_;
                                                        let _e988 = phi_1685_;
                                                        phi_1689_ = _e986;
                                                        phi_1690_ = _e988;
                                                    }
                                                    let _e990 = phi_1689_;
                                                    let _e992 = phi_1690_;
                                                    phi_1694_ = _e990;
                                                    phi_1695_ = _e992;
                                                } else {
                                                    phi_1694_ = type_22();
                                                    phi_1695_ = true;
                                                }
                                                let _e994 = phi_1694_;
                                                let _e996 = phi_1695_;
                                                if _e996 {
                                                    phi_1699_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1699_ = _e994;
                                                }
                                                let _e998 = phi_1699_;
                                                if (_e998.member_3 != 4294967295u) {
                                                    if (_e646 != _e83) {
                                                        if (_e998.member < _e617.member.member) {
                                                            phi_1725_ = true;
                                                        } else {
                                                            if (_e998.member == _e617.member.member) {
                                                                phi_1724_ = (_e998.member_3 < _e617.member.member_3);
                                                            } else {
                                                                phi_1724_ = false;
                                                            }
                                                            let _e1011 = phi_1724_;
                                                            phi_1725_ = _e1011;
                                                        }
                                                        let _e1013 = phi_1725_;
                                                        if _e1013 {
                                                            phi_1731_ = type_42(_e998, _e998.member);
                                                        } else {
                                                            phi_1731_ = _e617;
                                                        }
                                                        let _e1016 = phi_1731_;
                                                        phi_1732_ = _e1016;
                                                    } else {
                                                        phi_1732_ = _e617;
                                                    }
                                                    let _e1018 = phi_1732_;
                                                    phi_1733_ = _e1018;
                                                } else {
                                                    phi_1733_ = _e617;
                                                }
                                                let _e1020 = phi_1733_;
                                                phi_988_ = _e1020;
                                            } else {
                                                phi_988_ = type_42();
                                            }
                                            let _e1022 = phi_988_;
                                            continue;
                                            continuing {
                                                phi_987_ = _e1022;
                                                phi_990_ = _e632;
                                                phi_2352_ = _e390;
                                                break if !(_e638);
                                            }
                                        }
                                        let _e1025 = phi_2352_;
                                        phi_2466_ = _e1025;
                                        if _e1025 {
                                            break;
                                        }
                                        phi_2470_ = _e1025;
                                        let _e1218 = local_3;
                                        phi_2187_ = _e1218;
                                        phi_2188_ = _e415;
                                        phi_2189_ = false;
                                        phi_2190_ = _e419;
                                    } else {
                                        if (_e415 >= _e65) {
                                            phi_1793_ = type_46(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e415 < _e65) {
                                            } else {
                                                phi_2466_ = true;
                                                break;
                                            }
                                            let _e429 = (_e204 % 3u);
                                            if (_e429 < 3u) {
                                            } else {
                                                phi_2466_ = true;
                                                break;
                                            }
                                            let _e435 = global_2.member[_e415].member[_e429];
                                            let _e441 = (_e203 % 3u);
                                            if (_e441 < 3u) {
                                            } else {
                                                phi_2466_ = true;
                                                break;
                                            }
                                            let _e447 = global_2.member[_e415].member[_e441];
                                            let _e453 = (_e205 % 3u);
                                            if (_e453 < 3u) {
                                            } else {
                                                phi_2466_ = true;
                                                break;
                                            }
                                            let _e459 = global_2.member[_e415].member[_e453];
                                            let _e469 = global_2.member[_e415].member_1;
                                            let _e473 = global_2.member[_e415].member_2;
                                            phi_1793_ = type_46(array<vec4<f32>, 3>(vec4<f32>(_e435[0], _e435[1], _e435[2], _e435[3]), vec4<f32>(_e447[0], _e447[1], _e447[2], _e447[3]), vec4<f32>(_e459[0], _e459[1], _e459[2], _e459[3])), _e469, _e473);
                                        }
                                        let _e476 = phi_1793_;
                                        let _e488 = ((_e476.member[0].x - _e259) * _e264);
                                        let _e489 = ((_e476.member[0].y - _e259) * _e264);
                                        let _e490 = ((_e476.member[0].z - _e260) * _e264);
                                        let _e491 = ((_e476.member[0].w - _e260) * _e264);
                                        let _e501 = ((_e476.member[1].x - _e295) * _e300);
                                        let _e502 = ((_e476.member[1].y - _e295) * _e300);
                                        let _e503 = ((_e476.member[1].z - _e296) * _e300);
                                        let _e504 = ((_e476.member[1].w - _e296) * _e300);
                                        let _e514 = ((_e476.member[2].x - _e331) * _e336);
                                        let _e515 = ((_e476.member[2].y - _e331) * _e336);
                                        let _e516 = ((_e476.member[2].z - _e332) * _e336);
                                        let _e517 = ((_e476.member[2].w - _e332) * _e336);
                                        let _e519 = select(_e516, _e514, (_e514 < _e516));
                                        let _e521 = select(_e517, _e515, (_e515 < _e517));
                                        let _e523 = select(_e516, _e514, (_e514 > _e516));
                                        let _e525 = select(_e517, _e515, (_e515 > _e517));
                                        let _e527 = select(_e490, _e488, (_e488 < _e490));
                                        let _e529 = select(_e491, _e489, (_e489 < _e491));
                                        let _e531 = select(_e503, _e501, (_e501 < _e503));
                                        let _e533 = select(_e504, _e502, (_e502 < _e504));
                                        let _e535 = select(_e531, _e527, (_e527 > _e531));
                                        let _e537 = select(_e533, _e529, (_e529 > _e533));
                                        let _e539 = select(_e519, _e535, (_e535 > _e519));
                                        let _e541 = select(_e521, _e537, (_e537 > _e521));
                                        let _e543 = select(_e490, _e488, (_e488 > _e490));
                                        let _e545 = select(_e491, _e489, (_e489 > _e491));
                                        let _e547 = select(_e503, _e501, (_e501 > _e503));
                                        let _e549 = select(_e504, _e502, (_e502 > _e504));
                                        let _e551 = select(_e547, _e543, (_e543 < _e547));
                                        let _e553 = select(_e549, _e545, (_e545 < _e549));
                                        let _e558 = -(_e519);
                                        let _e559 = -(_e521);
                                        let _e566 = (select(_e523, _e551, (_e551 < _e523)) + (select(_e558, _e523, (_e523 > _e558)) * 0.0000019073523f));
                                        let _e567 = (select(_e525, _e553, (_e553 < _e525)) + (select(_e559, _e525, (_e525 > _e559)) * 0.0000019073523f));
                                        let _e569 = select(_e382, _e539, (_e539 > _e382));
                                        let _e571 = select(_e382, _e541, (_e541 > _e382));
                                        let _e576 = (_e569 <= select(_e392.member_1, _e566, (_e566 < _e392.member_1)));
                                        let _e577 = (_e571 <= select(_e392.member_1, _e567, (_e567 < _e392.member_1)));
                                        let _e578 = (_e569 <= _e571);
                                        if _e576 {
                                            if _e577 {
                                                if _e578 {
                                                    phi_2137_ = _e476.member_2;
                                                } else {
                                                    phi_2137_ = _e476.member_1;
                                                }
                                                let _e582 = phi_2137_;
                                                let _e583 = (_e419 % 128u);
                                                let _e584 = (_e583 < 128u);
                                                if _e584 {
                                                } else {
                                                    phi_2466_ = true;
                                                    break;
                                                }
                                                local_1[_e583] = _e582;
                                                if _e584 {
                                                } else {
                                                    phi_2466_ = true;
                                                    break;
                                                }
                                                local[_e583] = select(_e571, _e569, (_e569 > _e571));
                                                if _e578 {
                                                    phi_2164_ = _e476.member_1;
                                                } else {
                                                    phi_2164_ = _e476.member_2;
                                                }
                                                let _e593 = phi_2164_;
                                                phi_2165_ = _e593;
                                                phi_2166_ = (_e419 + 1u);
                                            } else {
                                                phi_2165_ = u32();
                                                phi_2166_ = u32();
                                            }
                                            let _e595 = phi_2165_;
                                            let _e597 = phi_2166_;
                                            phi_2168_ = _e595;
                                            phi_2169_ = _e597;
                                            phi_2170_ = select(true, false, _e577);
                                        } else {
                                            phi_2168_ = u32();
                                            phi_2169_ = u32();
                                            phi_2170_ = true;
                                        }
                                        let _e600 = phi_2168_;
                                        let _e602 = phi_2169_;
                                        let _e604 = phi_2170_;
                                        if _e604 {
                                            if _e576 {
                                                phi_2179_ = _e476.member_1;
                                            } else {
                                                phi_2179_ = _e476.member_2;
                                            }
                                            let _e608 = phi_2179_;
                                            phi_2184_ = _e608;
                                            phi_2185_ = select(_e577, true, _e576);
                                        } else {
                                            phi_2184_ = _e600;
                                            phi_2185_ = _e417;
                                        }
                                        let _e611 = phi_2184_;
                                        let _e613 = phi_2185_;
                                        phi_2470_ = _e390;
                                        phi_2187_ = _e392;
                                        phi_2188_ = _e611;
                                        phi_2189_ = _e613;
                                        phi_2190_ = select(_e602, _e419, _e604);
                                    }
                                    let _e1027 = phi_2470_;
                                    let _e1029 = phi_2187_;
                                    let _e1031 = phi_2188_;
                                    let _e1033 = phi_2189_;
                                    let _e1035 = phi_2190_;
                                    phi_2469_ = _e1027;
                                    phi_2191_ = _e1029;
                                    phi_2192_ = _e1031;
                                    phi_2193_ = (_e396 - 1u);
                                    phi_2194_ = _e1033;
                                    phi_2195_ = _e1035;
                                } else {
                                    phi_2469_ = _e390;
                                    phi_2191_ = _e392;
                                    phi_2192_ = _e415;
                                    phi_2193_ = _e396;
                                    phi_2194_ = _e417;
                                    phi_2195_ = _e419;
                                }
                                let _e1037 = phi_2469_;
                                let _e1039 = phi_2191_;
                                let _e1041 = phi_2192_;
                                let _e1043 = phi_2193_;
                                let _e1045 = phi_2194_;
                                let _e1047 = phi_2195_;
                                phi_2468_ = _e1037;
                                phi_2196_ = _e1039;
                                phi_2197_ = _e1041;
                                phi_2198_ = _e1043;
                                phi_2199_ = _e1045;
                                phi_2200_ = _e1047;
                            } else {
                                phi_2468_ = _e390;
                                phi_2196_ = type_42();
                                phi_2197_ = u32();
                                phi_2198_ = u32();
                                phi_2199_ = bool();
                                phi_2200_ = u32();
                            }
                            let _e1049 = phi_2468_;
                            let _e1051 = phi_2196_;
                            let _e1053 = phi_2197_;
                            let _e1055 = phi_2198_;
                            let _e1057 = phi_2199_;
                            let _e1059 = phi_2200_;
                            phi_2467_ = _e1049;
                            phi_920_ = _e1051;
                            phi_923_ = _e1053;
                            phi_925_ = _e1055;
                            phi_927_ = _e1057;
                            phi_929_ = _e1059;
                            phi_2201_ = _e404;
                        } else {
                            phi_2467_ = _e390;
                            phi_920_ = type_42();
                            phi_923_ = u32();
                            phi_925_ = u32();
                            phi_927_ = bool();
                            phi_929_ = u32();
                            phi_2201_ = false;
                        }
                        let _e1061 = phi_2467_;
                        let _e1063 = phi_920_;
                        let _e1065 = phi_923_;
                        let _e1067 = phi_925_;
                        let _e1069 = phi_927_;
                        let _e1071 = phi_929_;
                        let _e1073 = phi_2201_;
                        continue;
                        continuing {
                            phi_2358_ = _e1061;
                            phi_919_ = _e1063;
                            phi_922_ = _e1065;
                            phi_924_ = _e1067;
                            phi_926_ = _e1069;
                            phi_928_ = _e1071;
                            phi_2466_ = _e1061;
                            break if !(_e1073);
                        }
                    }
                    let _e1076 = phi_2466_;
                    if _e1076 {
                        break;
                    }
                    let _e1078 = local_2;
                    if (_e1078.member.member_3 != 4294967295u) {
                        let _e1083 = (_e206 / 3i);
                        let _e1090 = bitcast<f32>((bitcast<u32>((_e1083 + 127i)) << bitcast<u32>(23i)));
                        let _e1098 = (((_e1078.member.member * _e1090) * _e1090) * bitcast<f32>((bitcast<u32>(((_e206 - (2i * _e1083)) + 127i)) << bitcast<u32>(23i))));
                        let _e1100 = select(340282350000000000000000000000000000000f, _e1098, (_e1098 < 340282350000000000000000000000000000000f));
                        phi_2253_ = type_22(select(-340282350000000000000000000000000000000f, _e1100, (_e1100 > -340282350000000000000000000000000000000f)), _e1078.member.member_1, _e1078.member.member_2, _e1078.member.member_3);
                    } else {
                        phi_2253_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1107 = phi_2253_;
                    if _e79 {
                    } else {
                        break;
                    }
                    global_4.member[_e77] = _e1107;
                    if _e78 {
                    } else {
                        break;
                    }
                    let _e1111 = select(0u, 1u, (_e150 <= _e160));
                    if (_e1111 > 0u) {
                        let _e1113 = (1u < _e73);
                        if _e1113 {
                            if (0u < _e73) {
                            } else {
                                break;
                            }
                            let _e1117 = atomicAdd((&global_5.member[0u]), _e1111);
                            if ((_e1117 + _e1111) < _e1117) {
                                if _e1113 {
                                } else {
                                    break;
                                }
                                let _e1122 = atomicAdd((&global_5.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1125 = select(0u, 1u, (_e1107.member_3 != 4294967295u));
                    if (_e1125 > 0u) {
                        let _e1127 = (3u < _e73);
                        if _e1127 {
                            if (2u < _e73) {
                            } else {
                                break;
                            }
                            let _e1131 = atomicAdd((&global_5.member[2u]), _e1125);
                            if ((_e1131 + _e1125) < _e1131) {
                                if _e1127 {
                                } else {
                                    break;
                                }
                                let _e1136 = atomicAdd((&global_5.member[3u]), 1u);
                            }
                        }
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_paths(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
