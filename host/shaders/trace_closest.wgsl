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

struct type_25 {
    member: array<type_23>,
}

struct type_27 {
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
    member: type_23,
    member_1: f32,
}

struct type_43 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_45 {
    member: array<type_27>,
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
var<storage, read_write> global_5: type_25;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_265_: i32;
    var phi_266_: i32;
    var phi_276_: bool;
    var phi_286_: u32;
    var phi_287_: u32;
    var phi_289_: bool;
    var phi_294_: u32;
    var phi_338_: f32;
    var phi_344_: f32;
    var phi_355_: f32;
    var phi_361_: f32;
    var phi_384_: f32;
    var phi_395_: f32;
    var phi_404_: f32;
    var phi_410_: f32;
    var phi_421_: f32;
    var phi_427_: f32;
    var phi_450_: f32;
    var phi_461_: f32;
    var phi_470_: f32;
    var phi_476_: f32;
    var phi_487_: f32;
    var phi_493_: f32;
    var phi_516_: f32;
    var phi_527_: f32;
    var phi_627_: f32;
    var phi_628_: f32;
    var phi_2266_: bool;
    var phi_902_: type_39;
    var phi_905_: u32;
    var phi_907_: u32;
    var phi_909_: bool;
    var phi_911_: u32;
    var phi_922_: bool;
    var phi_953_: u32;
    var phi_954_: bool;
    var phi_955_: u32;
    var phi_1776_: type_43;
    var phi_2120_: u32;
    var phi_2147_: u32;
    var phi_2148_: u32;
    var phi_2149_: u32;
    var phi_2151_: u32;
    var phi_2152_: u32;
    var phi_2153_: bool;
    var phi_2162_: u32;
    var phi_2167_: u32;
    var phi_2168_: bool;
    var phi_970_: type_39;
    var phi_973_: type_4;
    var phi_974_: type_4;
    var phi_996_: type_4;
    var phi_1017_: u32;
    var phi_1106_: array<array<f32, 3>, 3>;
    var phi_1577_: vec3<f32>;
    var phi_1578_: vec3<f32>;
    var phi_1609_: bool;
    var phi_1618_: vec3<f32>;
    var phi_1658_: type_23;
    var phi_1660_: type_23;
    var phi_1661_: bool;
    var phi_1665_: type_23;
    var phi_1666_: type_23;
    var phi_1667_: type_23;
    var phi_1668_: bool;
    var phi_1672_: type_23;
    var phi_1673_: bool;
    var phi_1677_: type_23;
    var phi_1678_: bool;
    var phi_1682_: type_23;
    var phi_1707_: bool;
    var phi_1708_: bool;
    var phi_1714_: type_39;
    var phi_1715_: type_39;
    var phi_1716_: type_39;
    var phi_971_: type_39;
    var phi_2260_: bool;
    var phi_2374_: bool;
    var phi_2170_: type_39;
    var phi_2171_: u32;
    var phi_2172_: bool;
    var phi_2173_: u32;
    var phi_2373_: bool;
    var phi_2174_: type_39;
    var phi_2175_: u32;
    var phi_2176_: u32;
    var phi_2177_: bool;
    var phi_2178_: u32;
    var phi_2372_: bool;
    var phi_2179_: type_39;
    var phi_2180_: u32;
    var phi_2181_: u32;
    var phi_2182_: bool;
    var phi_2183_: u32;
    var phi_2371_: bool;
    var phi_903_: type_39;
    var phi_906_: u32;
    var phi_908_: u32;
    var phi_910_: bool;
    var phi_912_: u32;
    var phi_2184_: bool;
    var phi_2370_: bool;
    var local_2: type_39;
    var phi_2236_: type_23;
    var local_3: type_39;

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
                            phi_265_ = (bitcast<i32>((_e156 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_265_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e156)), 32u, (_e156 == 0u))));
                        }
                        let _e170 = phi_265_;
                        phi_266_ = _e170;
                    } else {
                        phi_266_ = 0i;
                    }
                    let _e172 = phi_266_;
                    let _e173 = (_e89 == _e128);
                    if _e173 {
                        phi_276_ = true;
                    } else {
                        phi_276_ = (_e96 == _e128);
                    }
                    let _e176 = phi_276_;
                    let _e177 = select(1u, 0u, _e173);
                    if _e176 {
                        let _e178 = (_e177 + 1u);
                        phi_286_ = _e178;
                        phi_287_ = _e178;
                        phi_289_ = select(true, false, (_e178 == 2u));
                    } else {
                        phi_286_ = u32();
                        phi_287_ = 0u;
                        phi_289_ = true;
                    }
                    let _e182 = phi_286_;
                    let _e184 = phi_287_;
                    let _e186 = phi_289_;
                    if _e186 {
                        phi_294_ = (_e184 + 1u);
                    } else {
                        phi_294_ = 0u;
                    }
                    let _e190 = phi_294_;
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
                        phi_338_ = _e221[0];
                    } else {
                        phi_338_ = _e221[1];
                    }
                    let _e226 = phi_338_;
                    let _e227 = (_e191 == 2u);
                    if _e227 {
                        phi_344_ = _e221[2];
                    } else {
                        phi_344_ = _e226;
                    }
                    let _e230 = phi_344_;
                    let _e232 = ((_e230 * _e198) * _e204);
                    let _e233 = global_4.member[_e73].member_2;
                    if _e222 {
                        phi_355_ = _e233[0];
                    } else {
                        phi_355_ = _e233[1];
                    }
                    let _e237 = phi_355_;
                    if _e227 {
                        phi_361_ = _e233[2];
                    } else {
                        phi_361_ = _e237;
                    }
                    let _e240 = phi_361_;
                    let _e242 = ((_e240 * _e211) * _e217);
                    let _e246 = (bitcast<f32>((bitcast<u32>(_e242) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e246 {
                        let _e250 = (bitcast<f32>((bitcast<u32>(_e232) & 2147483647u)) * 0.00000011920929f);
                        phi_384_ = select(0.00000000000011368684f, _e250, (_e250 > 0.00000000000011368684f));
                    } else {
                        phi_384_ = 0f;
                    }
                    let _e254 = phi_384_;
                    let _e255 = (_e232 + _e254);
                    let _e256 = (_e232 - _e254);
                    let _e257 = select(_e242, 0f, _e246);
                    if _e246 {
                        phi_395_ = 38685626000000000000000000f;
                    } else {
                        phi_395_ = (1f / _e242);
                    }
                    let _e260 = phi_395_;
                    let _e261 = (_e190 == 0u);
                    if _e261 {
                        phi_404_ = _e221[0];
                    } else {
                        phi_404_ = _e221[1];
                    }
                    let _e265 = phi_404_;
                    let _e266 = (_e190 == 2u);
                    if _e266 {
                        phi_410_ = _e221[2];
                    } else {
                        phi_410_ = _e265;
                    }
                    let _e269 = phi_410_;
                    let _e271 = ((_e269 * _e198) * _e204);
                    if _e261 {
                        phi_421_ = _e233[0];
                    } else {
                        phi_421_ = _e233[1];
                    }
                    let _e275 = phi_421_;
                    if _e266 {
                        phi_427_ = _e233[2];
                    } else {
                        phi_427_ = _e275;
                    }
                    let _e278 = phi_427_;
                    let _e280 = ((_e278 * _e211) * _e217);
                    let _e284 = (bitcast<f32>((bitcast<u32>(_e280) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e284 {
                        let _e288 = (bitcast<f32>((bitcast<u32>(_e271) & 2147483647u)) * 0.00000011920929f);
                        phi_450_ = select(0.00000000000011368684f, _e288, (_e288 > 0.00000000000011368684f));
                    } else {
                        phi_450_ = 0f;
                    }
                    let _e292 = phi_450_;
                    let _e293 = (_e271 + _e292);
                    let _e294 = (_e271 - _e292);
                    let _e295 = select(_e280, 0f, _e284);
                    if _e284 {
                        phi_461_ = 38685626000000000000000000f;
                    } else {
                        phi_461_ = (1f / _e280);
                    }
                    let _e298 = phi_461_;
                    let _e299 = (_e192 == 0u);
                    if _e299 {
                        phi_470_ = _e221[0];
                    } else {
                        phi_470_ = _e221[1];
                    }
                    let _e303 = phi_470_;
                    let _e304 = (_e192 == 2u);
                    if _e304 {
                        phi_476_ = _e221[2];
                    } else {
                        phi_476_ = _e303;
                    }
                    let _e307 = phi_476_;
                    let _e309 = ((_e307 * _e198) * _e204);
                    if _e299 {
                        phi_487_ = _e233[0];
                    } else {
                        phi_487_ = _e233[1];
                    }
                    let _e313 = phi_487_;
                    if _e304 {
                        phi_493_ = _e233[2];
                    } else {
                        phi_493_ = _e313;
                    }
                    let _e316 = phi_493_;
                    let _e318 = ((_e316 * _e211) * _e217);
                    let _e322 = (bitcast<f32>((bitcast<u32>(_e318) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e322 {
                        let _e326 = (bitcast<f32>((bitcast<u32>(_e309) & 2147483647u)) * 0.00000011920929f);
                        phi_516_ = select(0.00000000000011368684f, _e326, (_e326 > 0.00000000000011368684f));
                    } else {
                        phi_516_ = 0f;
                    }
                    let _e330 = phi_516_;
                    let _e331 = (_e309 + _e330);
                    let _e332 = (_e309 - _e330);
                    let _e333 = select(_e318, 0f, _e322);
                    if _e322 {
                        phi_527_ = 38685626000000000000000000f;
                    } else {
                        phi_527_ = (1f / _e318);
                    }
                    let _e336 = phi_527_;
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
                        phi_627_ = select(-340282350000000000000000000000000000000f, _e377, (_e377 > -340282350000000000000000000000000000000f));
                        phi_628_ = select(-340282350000000000000000000000000000000f, _e370, (_e370 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_627_ = 0f;
                        phi_628_ = 1f;
                    }
                    let _e381 = phi_627_;
                    let _e383 = phi_628_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2266_ = false;
                    phi_902_ = type_39(type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e381);
                    phi_905_ = select(0u, 2147483648u, (_e63 == 0u));
                    phi_907_ = ((3u * _e63) + 1u);
                    phi_909_ = (_e383 <= _e381);
                    phi_911_ = 0u;
                    loop {
                        let _e391 = phi_2266_;
                        let _e393 = phi_902_;
                        let _e395 = phi_905_;
                        let _e397 = phi_907_;
                        let _e399 = phi_909_;
                        let _e401 = phi_911_;
                        local_2 = _e393;
                        if _e399 {
                            phi_922_ = true;
                        } else {
                            phi_922_ = (_e401 > 0u);
                        }
                        let _e404 = phi_922_;
                        if _e404 {
                            let _e405 = (_e397 > 0u);
                            if _e405 {
                                if _e399 {
                                    phi_953_ = _e395;
                                    phi_954_ = _e399;
                                    phi_955_ = _e401;
                                } else {
                                    let _e406 = (_e401 - 1u);
                                    let _e407 = (_e406 % 128u);
                                    let _e408 = (_e407 < 128u);
                                    if _e408 {
                                    } else {
                                        phi_2370_ = true;
                                        break;
                                    }
                                    let _e410 = local_1[_e407];
                                    if _e408 {
                                    } else {
                                        phi_2370_ = true;
                                        break;
                                    }
                                    let _e412 = local[_e407];
                                    phi_953_ = _e410;
                                    phi_954_ = (_e412 <= _e393.member_1);
                                    phi_955_ = _e406;
                                }
                                let _e416 = phi_953_;
                                let _e418 = phi_954_;
                                let _e420 = phi_955_;
                                if _e418 {
                                    if ((_e416 & 2147483648u) != 0u) {
                                        phi_970_ = _e393;
                                        phi_973_ = type_4(0u, ((_e416 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e618 = phi_970_;
                                            let _e620 = phi_973_;
                                            local_3 = _e618;
                                            if (_e620.member < _e620.member_1) {
                                                phi_974_ = type_4((_e620.member + 1u), _e620.member_1);
                                                phi_996_ = type_4(1u, _e620.member);
                                            } else {
                                                phi_974_ = _e620;
                                                phi_996_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e633 = phi_974_;
                                            let _e635 = phi_996_;
                                            let _e639 = (bitcast<i32>(_e635.member) != 0i);
                                            if _e639 {
                                                let _e640 = ((_e416 & 268435455u) + _e635.member_1);
                                                let _e641 = (_e640 < _e65);
                                                if _e641 {
                                                    if _e641 {
                                                    } else {
                                                        phi_2260_ = true;
                                                        break;
                                                    }
                                                    let _e645 = global_3.member[_e640].member_1;
                                                    phi_1017_ = _e645;
                                                } else {
                                                    phi_1017_ = 4294967295u;
                                                }
                                                let _e647 = phi_1017_;
                                                if (_e640 >= _e65) {
                                                    phi_1106_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e641 {
                                                    } else {
                                                        phi_2260_ = true;
                                                        break;
                                                    }
                                                    let _e649 = (_e191 % 3u);
                                                    let _e650 = (_e190 % 3u);
                                                    let _e651 = (_e192 % 3u);
                                                    if (_e649 < 9u) {
                                                    } else {
                                                        phi_2260_ = true;
                                                        break;
                                                    }
                                                    let _e657 = global_3.member[_e640].member[_e649];
                                                    if (_e650 < 9u) {
                                                    } else {
                                                        phi_2260_ = true;
                                                        break;
                                                    }
                                                    let _e663 = global_3.member[_e640].member[_e650];
                                                    if (_e651 < 9u) {
                                                    } else {
                                                        phi_2260_ = true;
                                                        break;
                                                    }
                                                    let _e669 = global_3.member[_e640].member[_e651];
                                                    let _e671 = (3u + _e649);
                                                    if (_e671 < 9u) {
                                                    } else {
                                                        phi_2260_ = true;
                                                        break;
                                                    }
                                                    let _e677 = global_3.member[_e640].member[_e671];
                                                    let _e678 = (3u + _e650);
                                                    if (_e678 < 9u) {
                                                    } else {
                                                        phi_2260_ = true;
                                                        break;
                                                    }
                                                    let _e684 = global_3.member[_e640].member[_e678];
                                                    let _e685 = (3u + _e651);
                                                    if (_e685 < 9u) {
                                                    } else {
                                                        phi_2260_ = true;
                                                        break;
                                                    }
                                                    let _e691 = global_3.member[_e640].member[_e685];
                                                    let _e693 = (6u + _e649);
                                                    if (_e693 < 9u) {
                                                    } else {
                                                        phi_2260_ = true;
                                                        break;
                                                    }
                                                    let _e699 = global_3.member[_e640].member[_e693];
                                                    let _e700 = (6u + _e650);
                                                    if (_e700 < 9u) {
                                                    } else {
                                                        phi_2260_ = true;
                                                        break;
                                                    }
                                                    let _e706 = global_3.member[_e640].member[_e700];
                                                    let _e707 = (6u + _e651);
                                                    if (_e707 < 9u) {
                                                    } else {
                                                        phi_2260_ = true;
                                                        break;
                                                    }
                                                    let _e713 = global_3.member[_e640].member[_e707];
                                                    phi_1106_ = array<array<f32, 3>, 3>(array<f32, 3>(_e657, _e663, _e669), array<f32, 3>(_e677, _e684, _e691), array<f32, 3>(_e699, _e706, _e713));
                                                }
                                                let _e717 = phi_1106_;
                                                let _e725 = (_e717[0][2] - _e309);
                                                let _e728 = (((_e717[0][0] - _e232) * _e333) - (_e725 * _e257));
                                                let _e731 = (((_e717[0][1] - _e271) * _e333) - (_e725 * _e295));
                                                let _e738 = (_e717[1][2] - _e309);
                                                let _e741 = (((_e717[1][0] - _e232) * _e333) - (_e738 * _e257));
                                                let _e744 = (((_e717[1][1] - _e271) * _e333) - (_e738 * _e295));
                                                let _e751 = (_e717[2][2] - _e309);
                                                let _e754 = (((_e717[2][0] - _e232) * _e333) - (_e751 * _e257));
                                                let _e757 = (((_e717[2][1] - _e271) * _e333) - (_e751 * _e295));
                                                let _e758 = (_e754 * _e744);
                                                let _e759 = (_e757 * _e741);
                                                let _e760 = (_e728 * _e757);
                                                let _e761 = (_e731 * _e754);
                                                let _e762 = (_e741 * _e731);
                                                let _e763 = (_e744 * _e728);
                                                let _e768 = (((_e758 >= _e759) && (_e760 >= _e761)) && (_e762 >= _e763));
                                                if (_e768 || (((_e758 <= _e759) && (_e760 <= _e761)) && (_e762 <= _e763))) {
                                                    let _e775 = select(-1f, 1f, _e768);
                                                    let _e777 = ((_e758 - _e759) * _e775);
                                                    let _e779 = select(0f, _e777, (_e777 > 0f));
                                                    let _e781 = ((_e760 - _e761) * _e775);
                                                    let _e783 = select(0f, _e781, (_e781 > 0f));
                                                    let _e785 = ((_e762 - _e763) * _e775);
                                                    let _e787 = select(0f, _e785, (_e785 > 0f));
                                                    let _e789 = ((_e779 + _e783) + _e787);
                                                    if (_e789 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1672_ = type_23();
                                                        phi_1673_ = true;
                                                    } else {
                                                        let _e792 = select(_e717[1][0], _e717[0][0], (_e717[0][0] < _e717[1][0]));
                                                        let _e796 = select(_e717[1][0], _e717[0][0], (_e717[0][0] > _e717[1][0]));
                                                        let _e800 = select(_e717[1][1], _e717[0][1], (_e717[0][1] < _e717[1][1]));
                                                        let _e804 = select(_e717[1][1], _e717[0][1], (_e717[0][1] > _e717[1][1]));
                                                        let _e808 = select(_e717[1][2], _e717[0][2], (_e717[0][2] < _e717[1][2]));
                                                        let _e812 = select(_e717[1][2], _e717[0][2], (_e717[0][2] > _e717[1][2]));
                                                        let _e817 = ((select(_e717[2][0], _e792, (_e792 < _e717[2][0])) - _e255) * _e260);
                                                        let _e818 = ((select(_e717[2][0], _e796, (_e796 > _e717[2][0])) - _e256) * _e260);
                                                        let _e821 = ((select(_e717[2][1], _e800, (_e800 < _e717[2][1])) - _e293) * _e298);
                                                        let _e822 = ((select(_e717[2][1], _e804, (_e804 > _e717[2][1])) - _e294) * _e298);
                                                        let _e825 = ((select(_e717[2][2], _e808, (_e808 < _e717[2][2])) - _e331) * _e336);
                                                        let _e826 = ((select(_e717[2][2], _e812, (_e812 > _e717[2][2])) - _e332) * _e336);
                                                        let _e828 = select(_e826, _e825, (_e825 < _e826));
                                                        let _e830 = select(_e826, _e825, (_e825 > _e826));
                                                        let _e832 = select(_e818, _e817, (_e817 < _e818));
                                                        let _e834 = select(_e822, _e821, (_e821 < _e822));
                                                        let _e836 = select(_e834, _e832, (_e832 > _e834));
                                                        let _e838 = select(_e828, _e836, (_e836 > _e828));
                                                        let _e840 = select(_e818, _e817, (_e817 > _e818));
                                                        let _e842 = select(_e822, _e821, (_e821 > _e822));
                                                        let _e844 = select(_e842, _e840, (_e840 < _e842));
                                                        let _e846 = select(_e830, _e844, (_e844 < _e830));
                                                        let _e847 = -(_e828);
                                                        let _e853 = select(_e383, _e838, (_e838 > _e383));
                                                        if (_e853 > (_e846 + (select(_e847, _e830, (_e830 > _e847)) * 0.0000019073523f))) {
                                                            phi_1667_ = type_23();
                                                            phi_1668_ = true;
                                                        } else {
                                                            let _e855 = (_e853 > _e618.member_1);
                                                            if _e855 {
                                                                phi_1666_ = type_23();
                                                            } else {
                                                                let _e859 = (_e717[1][0] - _e717[0][0]);
                                                                let _e860 = (_e717[1][1] - _e717[0][1]);
                                                                let _e861 = (_e717[1][2] - _e717[0][2]);
                                                                let _e862 = vec3<f32>(_e859, _e860, _e861);
                                                                let _e863 = (_e717[2][0] - _e717[1][0]);
                                                                let _e864 = (_e717[2][1] - _e717[1][1]);
                                                                let _e865 = (_e717[2][2] - _e717[1][2]);
                                                                let _e866 = vec3<f32>(_e863, _e864, _e865);
                                                                let _e867 = (_e717[0][0] - _e717[2][0]);
                                                                let _e868 = (_e717[0][1] - _e717[2][1]);
                                                                let _e869 = (_e717[0][2] - _e717[2][2]);
                                                                let _e870 = vec3<f32>(_e867, _e868, _e869);
                                                                let _e873 = bitcast<f32>((bitcast<u32>(_e859) & 2147483647u));
                                                                let _e876 = bitcast<f32>((bitcast<u32>(_e860) & 2147483647u));
                                                                let _e878 = select(_e876, _e873, (_e873 > _e876));
                                                                let _e881 = bitcast<f32>((bitcast<u32>(_e861) & 2147483647u));
                                                                let _e883 = select(_e881, _e878, (_e878 > _e881));
                                                                let _e886 = bitcast<f32>((bitcast<u32>(_e863) & 2147483647u));
                                                                let _e889 = bitcast<f32>((bitcast<u32>(_e864) & 2147483647u));
                                                                let _e891 = select(_e889, _e886, (_e886 > _e889));
                                                                let _e894 = bitcast<f32>((bitcast<u32>(_e865) & 2147483647u));
                                                                let _e896 = select(_e894, _e891, (_e891 > _e894));
                                                                let _e899 = bitcast<f32>((bitcast<u32>(_e867) & 2147483647u));
                                                                let _e902 = bitcast<f32>((bitcast<u32>(_e868) & 2147483647u));
                                                                let _e904 = select(_e902, _e899, (_e899 > _e902));
                                                                let _e907 = bitcast<f32>((bitcast<u32>(_e869) & 2147483647u));
                                                                let _e909 = select(_e907, _e904, (_e904 > _e907));
                                                                let _e911 = select(_e896, _e883, (_e883 > _e896));
                                                                let _e913 = select(_e909, _e911, (_e911 > _e909));
                                                                if (_e883 == _e913) {
                                                                    phi_1577_ = _e866;
                                                                    phi_1578_ = _e870;
                                                                } else {
                                                                    let _e916 = vec3((_e896 == _e913));
                                                                    phi_1577_ = select(_e862, _e870, _e916);
                                                                    phi_1578_ = select(_e866, _e862, _e916);
                                                                }
                                                                let _e920 = phi_1577_;
                                                                let _e922 = phi_1578_;
                                                                let _e929 = ((_e920.y * _e922.z) - (_e922.y * _e920.z));
                                                                let _e934 = ((_e920.z * _e922.x) - (_e922.z * _e920.x));
                                                                let _e937 = ((_e920.x * _e922.y) - (_e922.x * _e920.y));
                                                                if (_e779 >= _e783) {
                                                                    phi_1609_ = select(true, false, (_e779 >= _e787));
                                                                } else {
                                                                    phi_1609_ = true;
                                                                }
                                                                let _e942 = phi_1609_;
                                                                if _e942 {
                                                                    phi_1618_ = select(vec3<f32>(_e717[2][0], _e717[2][1], _e717[2][2]), vec3<f32>(_e717[1][0], _e717[1][1], _e717[1][2]), vec3((_e783 >= _e787)));
                                                                } else {
                                                                    phi_1618_ = vec3<f32>(_e717[0][0], _e717[0][1], _e717[0][2]);
                                                                }
                                                                let _e947 = phi_1618_;
                                                                let _e964 = ((((_e929 * (_e947.x - _e232)) + (_e934 * (_e947.y - _e271))) + (_e937 * (_e947.z - _e309))) / (((_e929 * _e257) + (_e934 * _e295)) + (_e937 * _e333)));
                                                                let _e966 = select(_e846, _e964, (_e964 < _e846));
                                                                let _e968 = select(_e838, _e966, (_e966 > _e838));
                                                                if (_e968 >= _e383) {
                                                                    let _e970 = (_e968 <= _e618.member_1);
                                                                    if _e970 {
                                                                        let _e971 = (1f / _e789);
                                                                        phi_1658_ = type_23(_e968, (_e783 * _e971), (_e787 * _e971), _e647);
                                                                    } else {
                                                                        phi_1658_ = type_23();
                                                                    }
                                                                    let _e976 = phi_1658_;
                                                                    phi_1660_ = _e976;
                                                                    phi_1661_ = select(true, false, _e970);
                                                                } else {
                                                                    phi_1660_ = type_23();
                                                                    phi_1661_ = true;
                                                                }
                                                                let _e979 = phi_1660_;
                                                                let _e981 = phi_1661_;
                                                                if _e981 {
                                                                    phi_1665_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1665_ = _e979;
                                                                }
                                                                let _e983 = phi_1665_;
                                                                phi_1666_ = _e983;
                                                            }
                                                            let _e985 = phi_1666_;
                                                            phi_1667_ = _e985;
                                                            phi_1668_ = _e855;
                                                        }
                                                        let _e987 = phi_1667_;
                                                        let _e989 = phi_1668_;
                                                        phi_1672_ = _e987;
                                                        phi_1673_ = _e989;
                                                    }
                                                    let _e991 = phi_1672_;
                                                    let _e993 = phi_1673_;
                                                    phi_1677_ = _e991;
                                                    phi_1678_ = _e993;
                                                } else {
                                                    phi_1677_ = type_23();
                                                    phi_1678_ = true;
                                                }
                                                let _e995 = phi_1677_;
                                                let _e997 = phi_1678_;
                                                if _e997 {
                                                    phi_1682_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1682_ = _e995;
                                                }
                                                let _e999 = phi_1682_;
                                                if (_e999.member_3 != 4294967295u) {
                                                    if (_e647 != 4294967295u) {
                                                        if (_e999.member < _e618.member.member) {
                                                            phi_1708_ = true;
                                                        } else {
                                                            if (_e999.member == _e618.member.member) {
                                                                phi_1707_ = (_e999.member_3 < _e618.member.member_3);
                                                            } else {
                                                                phi_1707_ = false;
                                                            }
                                                            let _e1012 = phi_1707_;
                                                            phi_1708_ = _e1012;
                                                        }
                                                        let _e1014 = phi_1708_;
                                                        if _e1014 {
                                                            phi_1714_ = type_39(_e999, _e999.member);
                                                        } else {
                                                            phi_1714_ = _e618;
                                                        }
                                                        let _e1017 = phi_1714_;
                                                        phi_1715_ = _e1017;
                                                    } else {
                                                        phi_1715_ = _e618;
                                                    }
                                                    let _e1019 = phi_1715_;
                                                    phi_1716_ = _e1019;
                                                } else {
                                                    phi_1716_ = _e618;
                                                }
                                                let _e1021 = phi_1716_;
                                                phi_971_ = _e1021;
                                            } else {
                                                phi_971_ = type_39();
                                            }
                                            let _e1023 = phi_971_;
                                            continue;
                                            continuing {
                                                phi_970_ = _e1023;
                                                phi_973_ = _e633;
                                                phi_2260_ = _e391;
                                                break if !(_e639);
                                            }
                                        }
                                        let _e1026 = phi_2260_;
                                        phi_2370_ = _e1026;
                                        if _e1026 {
                                            break;
                                        }
                                        phi_2374_ = _e1026;
                                        let _e1192 = local_3;
                                        phi_2170_ = _e1192;
                                        phi_2171_ = _e416;
                                        phi_2172_ = false;
                                        phi_2173_ = _e420;
                                    } else {
                                        if (_e416 >= _e63) {
                                            phi_1776_ = type_43(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e416 < _e63) {
                                            } else {
                                                phi_2370_ = true;
                                                break;
                                            }
                                            let _e430 = (_e191 % 3u);
                                            if (_e430 < 3u) {
                                            } else {
                                                phi_2370_ = true;
                                                break;
                                            }
                                            let _e436 = global_2.member[_e416].member[_e430];
                                            let _e442 = (_e190 % 3u);
                                            if (_e442 < 3u) {
                                            } else {
                                                phi_2370_ = true;
                                                break;
                                            }
                                            let _e448 = global_2.member[_e416].member[_e442];
                                            let _e454 = (_e192 % 3u);
                                            if (_e454 < 3u) {
                                            } else {
                                                phi_2370_ = true;
                                                break;
                                            }
                                            let _e460 = global_2.member[_e416].member[_e454];
                                            let _e470 = global_2.member[_e416].member_1;
                                            let _e474 = global_2.member[_e416].member_2;
                                            phi_1776_ = type_43(array<vec4<f32>, 3>(vec4<f32>(_e436[0], _e436[1], _e436[2], _e436[3]), vec4<f32>(_e448[0], _e448[1], _e448[2], _e448[3]), vec4<f32>(_e460[0], _e460[1], _e460[2], _e460[3])), _e470, _e474);
                                        }
                                        let _e477 = phi_1776_;
                                        let _e489 = ((_e477.member[0].x - _e255) * _e260);
                                        let _e490 = ((_e477.member[0].y - _e255) * _e260);
                                        let _e491 = ((_e477.member[0].z - _e256) * _e260);
                                        let _e492 = ((_e477.member[0].w - _e256) * _e260);
                                        let _e502 = ((_e477.member[1].x - _e293) * _e298);
                                        let _e503 = ((_e477.member[1].y - _e293) * _e298);
                                        let _e504 = ((_e477.member[1].z - _e294) * _e298);
                                        let _e505 = ((_e477.member[1].w - _e294) * _e298);
                                        let _e515 = ((_e477.member[2].x - _e331) * _e336);
                                        let _e516 = ((_e477.member[2].y - _e331) * _e336);
                                        let _e517 = ((_e477.member[2].z - _e332) * _e336);
                                        let _e518 = ((_e477.member[2].w - _e332) * _e336);
                                        let _e520 = select(_e517, _e515, (_e515 < _e517));
                                        let _e522 = select(_e518, _e516, (_e516 < _e518));
                                        let _e524 = select(_e517, _e515, (_e515 > _e517));
                                        let _e526 = select(_e518, _e516, (_e516 > _e518));
                                        let _e528 = select(_e491, _e489, (_e489 < _e491));
                                        let _e530 = select(_e492, _e490, (_e490 < _e492));
                                        let _e532 = select(_e504, _e502, (_e502 < _e504));
                                        let _e534 = select(_e505, _e503, (_e503 < _e505));
                                        let _e536 = select(_e532, _e528, (_e528 > _e532));
                                        let _e538 = select(_e534, _e530, (_e530 > _e534));
                                        let _e540 = select(_e520, _e536, (_e536 > _e520));
                                        let _e542 = select(_e522, _e538, (_e538 > _e522));
                                        let _e544 = select(_e491, _e489, (_e489 > _e491));
                                        let _e546 = select(_e492, _e490, (_e490 > _e492));
                                        let _e548 = select(_e504, _e502, (_e502 > _e504));
                                        let _e550 = select(_e505, _e503, (_e503 > _e505));
                                        let _e552 = select(_e548, _e544, (_e544 < _e548));
                                        let _e554 = select(_e550, _e546, (_e546 < _e550));
                                        let _e559 = -(_e520);
                                        let _e560 = -(_e522);
                                        let _e567 = (select(_e524, _e552, (_e552 < _e524)) + (select(_e559, _e524, (_e524 > _e559)) * 0.0000019073523f));
                                        let _e568 = (select(_e526, _e554, (_e554 < _e526)) + (select(_e560, _e526, (_e526 > _e560)) * 0.0000019073523f));
                                        let _e570 = select(_e383, _e540, (_e540 > _e383));
                                        let _e572 = select(_e383, _e542, (_e542 > _e383));
                                        let _e577 = (_e570 <= select(_e393.member_1, _e567, (_e567 < _e393.member_1)));
                                        let _e578 = (_e572 <= select(_e393.member_1, _e568, (_e568 < _e393.member_1)));
                                        let _e579 = (_e570 <= _e572);
                                        if _e577 {
                                            if _e578 {
                                                if _e579 {
                                                    phi_2120_ = _e477.member_2;
                                                } else {
                                                    phi_2120_ = _e477.member_1;
                                                }
                                                let _e583 = phi_2120_;
                                                let _e584 = (_e420 % 128u);
                                                let _e585 = (_e584 < 128u);
                                                if _e585 {
                                                } else {
                                                    phi_2370_ = true;
                                                    break;
                                                }
                                                local_1[_e584] = _e583;
                                                if _e585 {
                                                } else {
                                                    phi_2370_ = true;
                                                    break;
                                                }
                                                local[_e584] = select(_e572, _e570, (_e570 > _e572));
                                                if _e579 {
                                                    phi_2147_ = _e477.member_1;
                                                } else {
                                                    phi_2147_ = _e477.member_2;
                                                }
                                                let _e594 = phi_2147_;
                                                phi_2148_ = _e594;
                                                phi_2149_ = (_e420 + 1u);
                                            } else {
                                                phi_2148_ = u32();
                                                phi_2149_ = u32();
                                            }
                                            let _e596 = phi_2148_;
                                            let _e598 = phi_2149_;
                                            phi_2151_ = _e596;
                                            phi_2152_ = _e598;
                                            phi_2153_ = select(true, false, _e578);
                                        } else {
                                            phi_2151_ = u32();
                                            phi_2152_ = u32();
                                            phi_2153_ = true;
                                        }
                                        let _e601 = phi_2151_;
                                        let _e603 = phi_2152_;
                                        let _e605 = phi_2153_;
                                        if _e605 {
                                            if _e577 {
                                                phi_2162_ = _e477.member_1;
                                            } else {
                                                phi_2162_ = _e477.member_2;
                                            }
                                            let _e609 = phi_2162_;
                                            phi_2167_ = _e609;
                                            phi_2168_ = select(_e578, true, _e577);
                                        } else {
                                            phi_2167_ = _e601;
                                            phi_2168_ = _e418;
                                        }
                                        let _e612 = phi_2167_;
                                        let _e614 = phi_2168_;
                                        phi_2374_ = _e391;
                                        phi_2170_ = _e393;
                                        phi_2171_ = _e612;
                                        phi_2172_ = _e614;
                                        phi_2173_ = select(_e603, _e420, _e605);
                                    }
                                    let _e1028 = phi_2374_;
                                    let _e1030 = phi_2170_;
                                    let _e1032 = phi_2171_;
                                    let _e1034 = phi_2172_;
                                    let _e1036 = phi_2173_;
                                    phi_2373_ = _e1028;
                                    phi_2174_ = _e1030;
                                    phi_2175_ = _e1032;
                                    phi_2176_ = (_e397 - 1u);
                                    phi_2177_ = _e1034;
                                    phi_2178_ = _e1036;
                                } else {
                                    phi_2373_ = _e391;
                                    phi_2174_ = _e393;
                                    phi_2175_ = _e416;
                                    phi_2176_ = _e397;
                                    phi_2177_ = _e418;
                                    phi_2178_ = _e420;
                                }
                                let _e1038 = phi_2373_;
                                let _e1040 = phi_2174_;
                                let _e1042 = phi_2175_;
                                let _e1044 = phi_2176_;
                                let _e1046 = phi_2177_;
                                let _e1048 = phi_2178_;
                                phi_2372_ = _e1038;
                                phi_2179_ = _e1040;
                                phi_2180_ = _e1042;
                                phi_2181_ = _e1044;
                                phi_2182_ = _e1046;
                                phi_2183_ = _e1048;
                            } else {
                                phi_2372_ = _e391;
                                phi_2179_ = type_39();
                                phi_2180_ = u32();
                                phi_2181_ = u32();
                                phi_2182_ = bool();
                                phi_2183_ = u32();
                            }
                            let _e1050 = phi_2372_;
                            let _e1052 = phi_2179_;
                            let _e1054 = phi_2180_;
                            let _e1056 = phi_2181_;
                            let _e1058 = phi_2182_;
                            let _e1060 = phi_2183_;
                            phi_2371_ = _e1050;
                            phi_903_ = _e1052;
                            phi_906_ = _e1054;
                            phi_908_ = _e1056;
                            phi_910_ = _e1058;
                            phi_912_ = _e1060;
                            phi_2184_ = _e405;
                        } else {
                            phi_2371_ = _e391;
                            phi_903_ = type_39();
                            phi_906_ = u32();
                            phi_908_ = u32();
                            phi_910_ = bool();
                            phi_912_ = u32();
                            phi_2184_ = false;
                        }
                        let _e1062 = phi_2371_;
                        let _e1064 = phi_903_;
                        let _e1066 = phi_906_;
                        let _e1068 = phi_908_;
                        let _e1070 = phi_910_;
                        let _e1072 = phi_912_;
                        let _e1074 = phi_2184_;
                        continue;
                        continuing {
                            phi_2266_ = _e1062;
                            phi_902_ = _e1064;
                            phi_905_ = _e1066;
                            phi_907_ = _e1068;
                            phi_909_ = _e1070;
                            phi_911_ = _e1072;
                            phi_2370_ = _e1062;
                            break if !(_e1074);
                        }
                    }
                    let _e1077 = phi_2370_;
                    if _e1077 {
                        break;
                    }
                    let _e1079 = local_2;
                    if (_e1079.member.member_3 != 4294967295u) {
                        let _e1084 = -(_e350);
                        let _e1085 = (_e1084 / 3i);
                        let _e1092 = bitcast<f32>((bitcast<u32>((_e1085 + 127i)) << bitcast<u32>(23i)));
                        let _e1100 = (((_e1079.member.member * _e1092) * _e1092) * bitcast<f32>((bitcast<u32>(((_e1084 - (2i * _e1085)) + 127i)) << bitcast<u32>(23i))));
                        let _e1102 = select(340282350000000000000000000000000000000f, _e1100, (_e1100 < 340282350000000000000000000000000000000f));
                        phi_2236_ = type_23(select(-340282350000000000000000000000000000000f, _e1102, (_e1102 > -340282350000000000000000000000000000000f)), _e1079.member.member_1, _e1079.member.member_2, _e1079.member.member_3);
                    } else {
                        phi_2236_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1109 = phi_2236_;
                    if _e79 {
                    } else {
                        break;
                    }
                    global_5.member[_e73] = _e1109;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_closest(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
