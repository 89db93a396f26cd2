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

struct type_47 {
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
    var phi_184_: u32;
    var phi_289_: i32;
    var phi_290_: i32;
    var phi_300_: bool;
    var phi_310_: u32;
    var phi_311_: u32;
    var phi_313_: bool;
    var phi_318_: u32;
    var phi_350_: i32;
    var phi_368_: f32;
    var phi_374_: f32;
    var phi_385_: f32;
    var phi_391_: f32;
    var phi_414_: f32;
    var phi_425_: f32;
    var phi_434_: f32;
    var phi_440_: f32;
    var phi_451_: f32;
    var phi_457_: f32;
    var phi_480_: f32;
    var phi_491_: f32;
    var phi_500_: f32;
    var phi_506_: f32;
    var phi_517_: f32;
    var phi_523_: f32;
    var phi_546_: f32;
    var phi_557_: f32;
    var phi_657_: f32;
    var phi_658_: f32;
    var phi_2371_: bool;
    var phi_669_: type_42;
    var phi_672_: u32;
    var phi_674_: u32;
    var phi_676_: bool;
    var phi_678_: u32;
    var phi_689_: bool;
    var phi_721_: u32;
    var phi_722_: bool;
    var phi_723_: u32;
    var phi_1808_: type_47;
    var phi_2152_: u32;
    var phi_2180_: u32;
    var phi_2181_: u32;
    var phi_2182_: u32;
    var phi_2184_: u32;
    var phi_2185_: u32;
    var phi_2186_: bool;
    var phi_2195_: u32;
    var phi_2200_: u32;
    var phi_2201_: bool;
    var phi_738_: type_42;
    var phi_741_: type_7;
    var phi_742_: type_7;
    var phi_764_: type_7;
    var phi_785_: u32;
    var phi_874_: array<array<f32, 3>, 3>;
    var phi_991_: bool;
    var phi_1020_: bool;
    var phi_1421_: f32;
    var phi_1422_: f32;
    var phi_1423_: f32;
    var phi_1424_: f32;
    var phi_1425_: vec3<f32>;
    var phi_1426_: vec3<f32>;
    var phi_1427_: vec3<f32>;
    var phi_1428_: vec3<f32>;
    var phi_1459_: bool;
    var phi_1468_: vec3<f32>;
    var phi_1633_: f32;
    var phi_1635_: f32;
    var phi_1636_: bool;
    var phi_1656_: f32;
    var phi_1657_: f32;
    var phi_1680_: type_22;
    var phi_1682_: type_22;
    var phi_1683_: bool;
    var phi_1687_: type_22;
    var phi_1688_: type_22;
    var phi_1689_: type_22;
    var phi_1690_: bool;
    var phi_1694_: type_22;
    var phi_1695_: bool;
    var phi_1696_: type_22;
    var phi_1697_: bool;
    var phi_1698_: bool;
    var phi_1699_: type_22;
    var phi_1700_: bool;
    var phi_1701_: bool;
    var phi_1709_: type_22;
    var phi_1710_: bool;
    var phi_1714_: type_22;
    var phi_1739_: bool;
    var phi_1740_: bool;
    var phi_1746_: type_42;
    var phi_1747_: type_42;
    var phi_1748_: type_42;
    var phi_739_: type_42;
    var phi_2365_: bool;
    var phi_2512_: bool;
    var phi_2203_: type_42;
    var phi_2204_: u32;
    var phi_2205_: bool;
    var phi_2206_: u32;
    var phi_2511_: bool;
    var phi_2207_: type_42;
    var phi_2208_: u32;
    var phi_2209_: u32;
    var phi_2210_: bool;
    var phi_2211_: u32;
    var phi_2510_: bool;
    var phi_2212_: type_42;
    var phi_2213_: u32;
    var phi_2214_: u32;
    var phi_2215_: bool;
    var phi_2216_: u32;
    var phi_2509_: bool;
    var phi_670_: type_42;
    var phi_673_: u32;
    var phi_675_: u32;
    var phi_677_: bool;
    var phi_679_: u32;
    var phi_2217_: bool;
    var phi_2508_: bool;
    var local_2: type_42;
    var phi_2269_: type_22;
    var local_3: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e66 = global;
            let _e68 = arrayLength((&global_2.member));
            let _e70 = arrayLength((&global_1.member));
            let _e76 = arrayLength((&global_5.member));
            let _e80 = (_e66.x + (_e66.y * 2097152u));
            let _e81 = (_e80 < arrayLength((&global_3.member)));
            if _e81 {
                if _e81 {
                } else {
                    break;
                }
                let _e85 = global_3.member[_e80].member_2;
                phi_184_ = _e85;
            } else {
                phi_184_ = 4294967295u;
            }
            let _e87 = phi_184_;
            if _e81 {
                let _e88 = (_e80 < arrayLength((&global_4.member)));
                if _e88 {
                    if _e81 {
                    } else {
                        break;
                    }
                    let _e98 = global_3.member[_e80].member.member_2[0u];
                    let _e100 = (bitcast<u32>(_e98) & 2147483647u);
                    let _e106 = global_3.member[_e80].member.member_2[1u];
                    let _e108 = (bitcast<u32>(_e106) & 2147483647u);
                    let _e114 = global_3.member[_e80].member.member_2[2u];
                    let _e116 = (bitcast<u32>(_e114) & 2147483647u);
                    let _e122 = global_3.member[_e80].member.member[0u];
                    let _e124 = (bitcast<u32>(_e122) & 2147483647u);
                    let _e130 = global_3.member[_e80].member.member[1u];
                    let _e132 = (bitcast<u32>(_e130) & 2147483647u);
                    let _e138 = global_3.member[_e80].member.member[2u];
                    let _e140 = (bitcast<u32>(_e138) & 2147483647u);
                    let _e142 = select(_e108, _e100, (_e108 < _e100));
                    let _e144 = select(_e116, _e142, (_e116 < _e142));
                    let _e146 = select(_e124, _e144, (_e124 < _e144));
                    let _e148 = select(_e132, _e146, (_e132 < _e146));
                    let _e150 = select(_e140, _e148, (_e140 < _e148));
                    let _e155 = global_3.member[_e80].member.member_1;
                    let _e157 = (bitcast<u32>(_e155) & 2147483647u);
                    let _e165 = global_3.member[_e80].member.member_3;
                    let _e171 = (((select(_e157, _e150, (_e157 < _e150)) < 2139095040u) && ((bitcast<u32>(_e165) & 2147483647u) <= 2139095040u)) && (_e144 > 0u));
                    if _e171 {
                        let _e174 = (bitcast<u32>(bitcast<f32>(_e144)) & 2147483647u);
                        if (_e174 >= 8388608u) {
                            phi_289_ = (bitcast<i32>((_e174 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_289_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e174)), 32u, (_e174 == 0u))));
                        }
                        let _e188 = phi_289_;
                        phi_290_ = _e188;
                    } else {
                        phi_290_ = 0i;
                    }
                    let _e190 = phi_290_;
                    let _e191 = (_e100 == _e144);
                    if _e191 {
                        phi_300_ = true;
                    } else {
                        phi_300_ = (_e108 == _e144);
                    }
                    let _e194 = phi_300_;
                    let _e195 = select(1u, 0u, _e191);
                    if _e194 {
                        let _e196 = (_e195 + 1u);
                        phi_310_ = _e196;
                        phi_311_ = _e196;
                        phi_313_ = select(true, false, (_e196 == 2u));
                    } else {
                        phi_310_ = u32();
                        phi_311_ = 0u;
                        phi_313_ = true;
                    }
                    let _e200 = phi_310_;
                    let _e202 = phi_311_;
                    let _e204 = phi_313_;
                    if _e204 {
                        phi_318_ = (_e202 + 1u);
                    } else {
                        phi_318_ = 0u;
                    }
                    let _e208 = phi_318_;
                    let _e209 = select(_e200, _e202, _e204);
                    let _e210 = select(_e195, select(2u, _e195, _e194), _e204);
                    let _e211 = -(_e190);
                    if (_e211 < -126i) {
                        phi_350_ = -126i;
                    } else {
                        phi_350_ = select(_e211, 127i, (_e211 > 127i));
                    }
                    let _e216 = phi_350_;
                    let _e221 = bitcast<f32>((bitcast<u32>((_e216 + 127i)) << bitcast<u32>(23i)));
                    let _e227 = bitcast<f32>((bitcast<u32>(((_e211 - _e216) + 127i)) << bitcast<u32>(23i)));
                    let _e232 = global_3.member[_e80].member.member;
                    let _e233 = (_e209 == 0u);
                    if _e233 {
                        phi_368_ = _e232[0];
                    } else {
                        phi_368_ = _e232[1];
                    }
                    let _e237 = phi_368_;
                    let _e238 = (_e209 == 2u);
                    if _e238 {
                        phi_374_ = _e232[2];
                    } else {
                        phi_374_ = _e237;
                    }
                    let _e241 = phi_374_;
                    let _e242 = global_3.member[_e80].member.member_2;
                    if _e233 {
                        phi_385_ = _e242[0];
                    } else {
                        phi_385_ = _e242[1];
                    }
                    let _e246 = phi_385_;
                    if _e238 {
                        phi_391_ = _e242[2];
                    } else {
                        phi_391_ = _e246;
                    }
                    let _e249 = phi_391_;
                    let _e251 = ((_e249 * _e221) * _e227);
                    let _e255 = (bitcast<f32>((bitcast<u32>(_e251) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e255 {
                        let _e259 = (bitcast<f32>((bitcast<u32>(_e241) & 2147483647u)) * 0.00000011920929f);
                        phi_414_ = select(0.00000000000011368684f, _e259, (_e259 > 0.00000000000011368684f));
                    } else {
                        phi_414_ = 0f;
                    }
                    let _e263 = phi_414_;
                    let _e264 = (_e241 + _e263);
                    let _e265 = (_e241 - _e263);
                    let _e266 = select(_e251, 0f, _e255);
                    if _e255 {
                        phi_425_ = 38685626000000000000000000f;
                    } else {
                        phi_425_ = (1f / _e251);
                    }
                    let _e269 = phi_425_;
                    let _e270 = (_e208 == 0u);
                    if _e270 {
                        phi_434_ = _e232[0];
                    } else {
                        phi_434_ = _e232[1];
                    }
                    let _e274 = phi_434_;
                    let _e275 = (_e208 == 2u);
                    if _e275 {
                        phi_440_ = _e232[2];
                    } else {
                        phi_440_ = _e274;
                    }
                    let _e278 = phi_440_;
                    if _e270 {
                        phi_451_ = _e242[0];
                    } else {
                        phi_451_ = _e242[1];
                    }
                    let _e282 = phi_451_;
                    if _e275 {
                        phi_457_ = _e242[2];
                    } else {
                        phi_457_ = _e282;
                    }
                    let _e285 = phi_457_;
                    let _e287 = ((_e285 * _e221) * _e227);
                    let _e291 = (bitcast<f32>((bitcast<u32>(_e287) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e291 {
                        let _e295 = (bitcast<f32>((bitcast<u32>(_e278) & 2147483647u)) * 0.00000011920929f);
                        phi_480_ = select(0.00000000000011368684f, _e295, (_e295 > 0.00000000000011368684f));
                    } else {
                        phi_480_ = 0f;
                    }
                    let _e299 = phi_480_;
                    let _e300 = (_e278 + _e299);
                    let _e301 = (_e278 - _e299);
                    let _e302 = select(_e287, 0f, _e291);
                    if _e291 {
                        phi_491_ = 38685626000000000000000000f;
                    } else {
                        phi_491_ = (1f / _e287);
                    }
                    let _e305 = phi_491_;
                    let _e306 = (_e210 == 0u);
                    if _e306 {
                        phi_500_ = _e232[0];
                    } else {
                        phi_500_ = _e232[1];
                    }
                    let _e310 = phi_500_;
                    let _e311 = (_e210 == 2u);
                    if _e311 {
                        phi_506_ = _e232[2];
                    } else {
                        phi_506_ = _e310;
                    }
                    let _e314 = phi_506_;
                    if _e306 {
                        phi_517_ = _e242[0];
                    } else {
                        phi_517_ = _e242[1];
                    }
                    let _e318 = phi_517_;
                    if _e311 {
                        phi_523_ = _e242[2];
                    } else {
                        phi_523_ = _e318;
                    }
                    let _e321 = phi_523_;
                    let _e323 = ((_e321 * _e221) * _e227);
                    let _e327 = (bitcast<f32>((bitcast<u32>(_e323) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e327 {
                        let _e331 = (bitcast<f32>((bitcast<u32>(_e314) & 2147483647u)) * 0.00000011920929f);
                        phi_546_ = select(0.00000000000011368684f, _e331, (_e331 > 0.00000000000011368684f));
                    } else {
                        phi_546_ = 0f;
                    }
                    let _e335 = phi_546_;
                    let _e336 = (_e314 + _e335);
                    let _e337 = (_e314 - _e335);
                    let _e338 = select(_e323, 0f, _e327);
                    if _e327 {
                        phi_557_ = 38685626000000000000000000f;
                    } else {
                        phi_557_ = (1f / _e323);
                    }
                    let _e341 = phi_557_;
                    let _e344 = bitcast<f32>((bitcast<u32>(_e241) & 2147483647u));
                    let _e347 = bitcast<f32>((bitcast<u32>(_e278) & 2147483647u));
                    let _e349 = select(_e347, _e344, (_e344 > _e347));
                    let _e352 = bitcast<f32>((bitcast<u32>(_e314) & 2147483647u));
                    if (_e171 && (select(_e352, _e349, (_e349 > _e352)) <= 1099511600000f)) {
                        let _e357 = (_e190 / 3i);
                        let _e364 = bitcast<f32>((bitcast<u32>((_e357 + 127i)) << bitcast<u32>(23i)));
                        let _e371 = bitcast<f32>((bitcast<u32>(((_e190 - (2i * _e357)) + 127i)) << bitcast<u32>(23i)));
                        let _e372 = (((_e155 * _e364) * _e364) * _e371);
                        let _e374 = select(340282350000000000000000000000000000000f, _e372, (_e372 < 340282350000000000000000000000000000000f));
                        let _e379 = (((_e165 * _e364) * _e364) * _e371);
                        let _e381 = select(340282350000000000000000000000000000000f, _e379, (_e379 < 340282350000000000000000000000000000000f));
                        phi_657_ = select(-340282350000000000000000000000000000000f, _e381, (_e381 > -340282350000000000000000000000000000000f));
                        phi_658_ = select(-340282350000000000000000000000000000000f, _e374, (_e374 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_657_ = 0f;
                        phi_658_ = 1f;
                    }
                    let _e385 = phi_657_;
                    let _e387 = phi_658_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2371_ = false;
                    phi_669_ = type_42(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e385);
                    phi_672_ = select(0u, 2147483648u, (_e68 == 0u));
                    phi_674_ = ((3u * _e68) + 1u);
                    phi_676_ = (_e387 <= _e385);
                    phi_678_ = 0u;
                    loop {
                        let _e395 = phi_2371_;
                        let _e397 = phi_669_;
                        let _e399 = phi_672_;
                        let _e401 = phi_674_;
                        let _e403 = phi_676_;
                        let _e405 = phi_678_;
                        local_2 = _e397;
                        if _e403 {
                            phi_689_ = true;
                        } else {
                            phi_689_ = (_e405 > 0u);
                        }
                        let _e408 = phi_689_;
                        if _e408 {
                            let _e409 = (_e401 > 0u);
                            if _e409 {
                                if _e403 {
                                    phi_721_ = _e399;
                                    phi_722_ = _e403;
                                    phi_723_ = _e405;
                                } else {
                                    let _e410 = (_e405 - 1u);
                                    let _e411 = (_e410 % 128u);
                                    let _e412 = (_e411 < 128u);
                                    if _e412 {
                                    } else {
                                        phi_2508_ = true;
                                        break;
                                    }
                                    let _e414 = local_1[_e411];
                                    if _e412 {
                                    } else {
                                        phi_2508_ = true;
                                        break;
                                    }
                                    let _e416 = local[_e411];
                                    phi_721_ = _e414;
                                    phi_722_ = (_e416 <= _e397.member_1);
                                    phi_723_ = _e410;
                                }
                                let _e420 = phi_721_;
                                let _e422 = phi_722_;
                                let _e424 = phi_723_;
                                if _e422 {
                                    if ((_e420 & 2147483648u) != 0u) {
                                        phi_738_ = _e397;
                                        phi_741_ = type_7(0u, ((_e420 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e622 = phi_738_;
                                            let _e624 = phi_741_;
                                            local_3 = _e622;
                                            if (_e624.member < _e624.member_1) {
                                                phi_742_ = type_7((_e624.member + 1u), _e624.member_1);
                                                phi_764_ = type_7(1u, _e624.member);
                                            } else {
                                                phi_742_ = _e624;
                                                phi_764_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e637 = phi_742_;
                                            let _e639 = phi_764_;
                                            let _e643 = (bitcast<i32>(_e639.member) != 0i);
                                            if _e643 {
                                                let _e644 = ((_e420 & 268435455u) + _e639.member_1);
                                                let _e645 = (_e644 < _e70);
                                                if _e645 {
                                                    if _e645 {
                                                    } else {
                                                        phi_2365_ = true;
                                                        break;
                                                    }
                                                    let _e649 = global_1.member[_e644].member_1;
                                                    phi_785_ = _e649;
                                                } else {
                                                    phi_785_ = 4294967295u;
                                                }
                                                let _e651 = phi_785_;
                                                if (_e644 >= _e70) {
                                                    phi_874_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e645 {
                                                    } else {
                                                        phi_2365_ = true;
                                                        break;
                                                    }
                                                    let _e653 = (_e209 % 3u);
                                                    let _e654 = (_e208 % 3u);
                                                    let _e655 = (_e210 % 3u);
                                                    if (_e653 < 9u) {
                                                    } else {
                                                        phi_2365_ = true;
                                                        break;
                                                    }
                                                    let _e661 = global_1.member[_e644].member[_e653];
                                                    if (_e654 < 9u) {
                                                    } else {
                                                        phi_2365_ = true;
                                                        break;
                                                    }
                                                    let _e667 = global_1.member[_e644].member[_e654];
                                                    if (_e655 < 9u) {
                                                    } else {
                                                        phi_2365_ = true;
                                                        break;
                                                    }
                                                    let _e673 = global_1.member[_e644].member[_e655];
                                                    let _e675 = (3u + _e653);
                                                    if (_e675 < 9u) {
                                                    } else {
                                                        phi_2365_ = true;
                                                        break;
                                                    }
                                                    let _e681 = global_1.member[_e644].member[_e675];
                                                    let _e682 = (3u + _e654);
                                                    if (_e682 < 9u) {
                                                    } else {
                                                        phi_2365_ = true;
                                                        break;
                                                    }
                                                    let _e688 = global_1.member[_e644].member[_e682];
                                                    let _e689 = (3u + _e655);
                                                    if (_e689 < 9u) {
                                                    } else {
                                                        phi_2365_ = true;
                                                        break;
                                                    }
                                                    let _e695 = global_1.member[_e644].member[_e689];
                                                    let _e697 = (6u + _e653);
                                                    if (_e697 < 9u) {
                                                    } else {
                                                        phi_2365_ = true;
                                                        break;
                                                    }
                                                    let _e703 = global_1.member[_e644].member[_e697];
                                                    let _e704 = (6u + _e654);
                                                    if (_e704 < 9u) {
                                                    } else {
                                                        phi_2365_ = true;
                                                        break;
                                                    }
                                                    let _e710 = global_1.member[_e644].member[_e704];
                                                    let _e711 = (6u + _e655);
                                                    if (_e711 < 9u) {
                                                    } else {
                                                        phi_2365_ = true;
                                                        break;
                                                    }
                                                    let _e717 = global_1.member[_e644].member[_e711];
                                                    phi_874_ = array<array<f32, 3>, 3>(array<f32, 3>(_e661, _e667, _e673), array<f32, 3>(_e681, _e688, _e695), array<f32, 3>(_e703, _e710, _e717));
                                                }
                                                let _e721 = phi_874_;
                                                let _e729 = (_e721[0][2] - _e314);
                                                let _e732 = (((_e721[0][0] - _e241) * _e338) - (_e729 * _e266));
                                                let _e735 = (((_e721[0][1] - _e278) * _e338) - (_e729 * _e302));
                                                let _e742 = (_e721[1][2] - _e314);
                                                let _e745 = (((_e721[1][0] - _e241) * _e338) - (_e742 * _e266));
                                                let _e748 = (((_e721[1][1] - _e278) * _e338) - (_e742 * _e302));
                                                let _e755 = (_e721[2][2] - _e314);
                                                let _e758 = (((_e721[2][0] - _e241) * _e338) - (_e755 * _e266));
                                                let _e761 = (((_e721[2][1] - _e278) * _e338) - (_e755 * _e302));
                                                let _e762 = (_e758 * _e748);
                                                let _e763 = (_e761 * _e745);
                                                let _e764 = (_e732 * _e761);
                                                let _e765 = (_e735 * _e758);
                                                let _e766 = (_e745 * _e735);
                                                let _e767 = (_e748 * _e732);
                                                let _e772 = (((_e762 >= _e763) && (_e764 >= _e765)) && (_e766 >= _e767));
                                                if (_e772 || (((_e762 <= _e763) && (_e764 <= _e765)) && (_e766 <= _e767))) {
                                                    let _e779 = select(-1f, 1f, _e772);
                                                    let _e781 = ((_e762 - _e763) * _e779);
                                                    let _e783 = select(0f, _e781, (_e781 > 0f));
                                                    let _e785 = ((_e764 - _e765) * _e779);
                                                    let _e787 = select(0f, _e785, (_e785 > 0f));
                                                    let _e789 = ((_e766 - _e767) * _e779);
                                                    let _e791 = select(0f, _e789, (_e789 > 0f));
                                                    let _e793 = ((_e783 + _e787) + _e791);
                                                    if (_e793 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1699_ = type_22();
                                                        phi_1700_ = true;
                                                        phi_1701_ = false;
                                                    } else {
                                                        let _e796 = select(_e745, _e732, (_e732 < _e745));
                                                        if (select(_e758, _e796, (_e796 < _e758)) > 0f) {
                                                            phi_991_ = true;
                                                        } else {
                                                            let _e801 = select(_e745, _e732, (_e732 > _e745));
                                                            phi_991_ = (select(_e758, _e801, (_e801 > _e758)) < 0f);
                                                        }
                                                        let _e806 = phi_991_;
                                                        if _e806 {
                                                            phi_1696_ = type_22();
                                                            phi_1697_ = true;
                                                            phi_1698_ = false;
                                                        } else {
                                                            let _e808 = select(_e748, _e735, (_e735 < _e748));
                                                            if (select(_e761, _e808, (_e808 < _e761)) > 0f) {
                                                                phi_1020_ = true;
                                                            } else {
                                                                let _e813 = select(_e748, _e735, (_e735 > _e748));
                                                                phi_1020_ = (select(_e761, _e813, (_e813 > _e761)) < 0f);
                                                            }
                                                            let _e818 = phi_1020_;
                                                            if _e818 {
                                                                phi_1694_ = type_22();
                                                                phi_1695_ = false;
                                                            } else {
                                                                let _e820 = select(_e721[1][0], _e721[0][0], (_e721[0][0] < _e721[1][0]));
                                                                let _e824 = select(_e721[1][0], _e721[0][0], (_e721[0][0] > _e721[1][0]));
                                                                let _e828 = select(_e721[1][1], _e721[0][1], (_e721[0][1] < _e721[1][1]));
                                                                let _e832 = select(_e721[1][1], _e721[0][1], (_e721[0][1] > _e721[1][1]));
                                                                let _e836 = select(_e721[1][2], _e721[0][2], (_e721[0][2] < _e721[1][2]));
                                                                let _e840 = select(_e721[1][2], _e721[0][2], (_e721[0][2] > _e721[1][2]));
                                                                let _e845 = ((select(_e721[2][0], _e820, (_e820 < _e721[2][0])) - _e264) * _e269);
                                                                let _e846 = ((select(_e721[2][0], _e824, (_e824 > _e721[2][0])) - _e265) * _e269);
                                                                let _e849 = ((select(_e721[2][1], _e828, (_e828 < _e721[2][1])) - _e300) * _e305);
                                                                let _e850 = ((select(_e721[2][1], _e832, (_e832 > _e721[2][1])) - _e301) * _e305);
                                                                let _e853 = ((select(_e721[2][2], _e836, (_e836 < _e721[2][2])) - _e336) * _e341);
                                                                let _e854 = ((select(_e721[2][2], _e840, (_e840 > _e721[2][2])) - _e337) * _e341);
                                                                let _e856 = select(_e854, _e853, (_e853 < _e854));
                                                                let _e858 = select(_e854, _e853, (_e853 > _e854));
                                                                let _e860 = select(_e846, _e845, (_e845 < _e846));
                                                                let _e862 = select(_e850, _e849, (_e849 < _e850));
                                                                let _e864 = select(_e862, _e860, (_e860 > _e862));
                                                                let _e866 = select(_e856, _e864, (_e864 > _e856));
                                                                let _e868 = select(_e846, _e845, (_e845 > _e846));
                                                                let _e870 = select(_e850, _e849, (_e849 > _e850));
                                                                let _e872 = select(_e870, _e868, (_e868 < _e870));
                                                                let _e874 = select(_e858, _e872, (_e872 < _e858));
                                                                let _e875 = -(_e856);
                                                                let _e881 = select(_e387, _e866, (_e866 > _e387));
                                                                if (_e881 > (_e874 + (select(_e875, _e858, (_e858 > _e875)) * 0.0000019073523f))) {
                                                                    phi_1689_ = type_22();
                                                                    phi_1690_ = true;
                                                                } else {
                                                                    let _e883 = (_e881 > _e622.member_1);
                                                                    if _e883 {
                                                                        phi_1688_ = type_22();
                                                                    } else {
                                                                        let _e884 = vec3<f32>(_e721[0][0], _e721[0][1], _e721[0][2]);
                                                                        let _e885 = vec3<f32>(_e721[1][0], _e721[1][1], _e721[1][2]);
                                                                        let _e886 = vec3<f32>(_e721[2][0], _e721[2][1], _e721[2][2]);
                                                                        let _e887 = (_e721[1][0] - _e721[0][0]);
                                                                        let _e888 = (_e721[1][1] - _e721[0][1]);
                                                                        let _e889 = (_e721[1][2] - _e721[0][2]);
                                                                        let _e890 = vec3<f32>(_e887, _e888, _e889);
                                                                        let _e891 = (_e721[2][0] - _e721[1][0]);
                                                                        let _e892 = (_e721[2][1] - _e721[1][1]);
                                                                        let _e893 = (_e721[2][2] - _e721[1][2]);
                                                                        let _e894 = vec3<f32>(_e891, _e892, _e893);
                                                                        let _e895 = (_e721[0][0] - _e721[2][0]);
                                                                        let _e896 = (_e721[0][1] - _e721[2][1]);
                                                                        let _e897 = (_e721[0][2] - _e721[2][2]);
                                                                        let _e898 = vec3<f32>(_e895, _e896, _e897);
                                                                        let _e901 = bitcast<f32>((bitcast<u32>(_e887) & 2147483647u));
                                                                        let _e904 = bitcast<f32>((bitcast<u32>(_e888) & 2147483647u));
                                                                        let _e906 = select(_e904, _e901, (_e901 > _e904));
                                                                        let _e909 = bitcast<f32>((bitcast<u32>(_e889) & 2147483647u));
                                                                        let _e911 = select(_e909, _e906, (_e906 > _e909));
                                                                        let _e914 = bitcast<f32>((bitcast<u32>(_e891) & 2147483647u));
                                                                        let _e917 = bitcast<f32>((bitcast<u32>(_e892) & 2147483647u));
                                                                        let _e919 = select(_e917, _e914, (_e914 > _e917));
                                                                        let _e922 = bitcast<f32>((bitcast<u32>(_e893) & 2147483647u));
                                                                        let _e924 = select(_e922, _e919, (_e919 > _e922));
                                                                        let _e927 = bitcast<f32>((bitcast<u32>(_e895) & 2147483647u));
                                                                        let _e930 = bitcast<f32>((bitcast<u32>(_e896) & 2147483647u));
                                                                        let _e932 = select(_e930, _e927, (_e927 > _e930));
                                                                        let _e935 = bitcast<f32>((bitcast<u32>(_e897) & 2147483647u));
                                                                        let _e937 = select(_e935, _e932, (_e932 > _e935));
                                                                        let _e939 = select(_e924, _e911, (_e911 > _e924));
                                                                        let _e941 = select(_e937, _e939, (_e939 > _e937));
                                                                        if (_e911 == _e941) {
                                                                            phi_1421_ = _e748;
                                                                            phi_1422_ = _e745;
                                                                            phi_1423_ = _e735;
                                                                            phi_1424_ = _e732;
                                                                            phi_1425_ = _e884;
                                                                            phi_1426_ = _e898;
                                                                            phi_1427_ = _e894;
                                                                            phi_1428_ = _e890;
                                                                        } else {
                                                                            let _e943 = (_e924 == _e941);
                                                                            let _e948 = vec3(_e943);
                                                                            phi_1421_ = select(_e735, _e761, _e943);
                                                                            phi_1422_ = select(_e732, _e758, _e943);
                                                                            phi_1423_ = select(_e761, _e748, _e943);
                                                                            phi_1424_ = select(_e758, _e745, _e943);
                                                                            phi_1425_ = select(_e886, _e885, _e948);
                                                                            phi_1426_ = select(_e894, _e890, _e948);
                                                                            phi_1427_ = select(_e890, _e898, _e948);
                                                                            phi_1428_ = select(_e898, _e894, _e948);
                                                                        }
                                                                        let _e954 = phi_1421_;
                                                                        let _e956 = phi_1422_;
                                                                        let _e958 = phi_1423_;
                                                                        let _e960 = phi_1424_;
                                                                        let _e962 = phi_1425_;
                                                                        let _e964 = phi_1426_;
                                                                        let _e966 = phi_1427_;
                                                                        let _e968 = phi_1428_;
                                                                        let _e975 = ((_e966.y * _e964.z) - (_e964.y * _e966.z));
                                                                        let _e980 = ((_e966.z * _e964.x) - (_e964.z * _e966.x));
                                                                        let _e983 = ((_e966.x * _e964.y) - (_e964.x * _e966.y));
                                                                        if (_e783 >= _e787) {
                                                                            phi_1459_ = select(true, false, (_e783 >= _e791));
                                                                        } else {
                                                                            phi_1459_ = true;
                                                                        }
                                                                        let _e988 = phi_1459_;
                                                                        if _e988 {
                                                                            phi_1468_ = select(_e886, _e885, vec3((_e787 >= _e791)));
                                                                        } else {
                                                                            phi_1468_ = _e884;
                                                                        }
                                                                        let _e993 = phi_1468_;
                                                                        let _e1004 = (((_e975 * (_e993.x - _e241)) + (_e980 * (_e993.y - _e278))) + (_e983 * (_e993.z - _e314)));
                                                                        let _e1009 = (((_e975 * _e266) + (_e980 * _e302)) + (_e983 * _e338));
                                                                        let _e1010 = (_e956 - _e960);
                                                                        let _e1011 = (_e954 - _e958);
                                                                        let _e1019 = (-(((_e960 * _e1010) + (_e958 * _e1011))) / ((_e1010 * _e1010) + (_e1011 * _e1011)));
                                                                        let _e1021 = select(1f, _e1019, (_e1019 < 1f));
                                                                        let _e1023 = select(0f, _e1021, (_e1021 > 0f));
                                                                        let _e1036 = ((_e962.x + (_e968.x * _e1023)) - _e241);
                                                                        let _e1037 = ((_e962.y + (_e968.y * _e1023)) - _e278);
                                                                        let _e1038 = ((_e962.z + (_e968.z * _e1023)) - _e314);
                                                                        let _e1039 = (_e1038 / _e338);
                                                                        let _e1051 = bitcast<f32>((bitcast<u32>(_e1036) & 2147483647u));
                                                                        let _e1054 = bitcast<f32>((bitcast<u32>(_e1037) & 2147483647u));
                                                                        let _e1056 = select(_e1054, _e1051, (_e1051 > _e1054));
                                                                        let _e1059 = bitcast<f32>((bitcast<u32>(_e1038) & 2147483647u));
                                                                        let _e1061 = select(_e1059, _e1056, (_e1056 > _e1059));
                                                                        let _e1067 = bitcast<f32>((bitcast<u32>(_e975) & 2147483647u));
                                                                        let _e1070 = bitcast<f32>((bitcast<u32>(_e980) & 2147483647u));
                                                                        let _e1072 = select(_e1070, _e1067, (_e1067 > _e1070));
                                                                        let _e1075 = bitcast<f32>((bitcast<u32>(_e983) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e975 * _e1036) + (_e980 * _e1037)) + (_e983 * _e1038)) - _e1004)) & 2147483647u)) <= ((0.0000009536743f * select(_e941, _e1061, (_e1061 > _e941))) * select(_e1075, _e1072, (_e1072 > _e1075)))) {
                                                                            let _e1085 = bitcast<f32>((bitcast<u32>(_e966.x) & 2147483647u));
                                                                            let _e1088 = bitcast<f32>((bitcast<u32>(_e966.y) & 2147483647u));
                                                                            let _e1090 = select(_e1088, _e1085, (_e1085 > _e1088));
                                                                            let _e1093 = bitcast<f32>((bitcast<u32>(_e966.z) & 2147483647u));
                                                                            let _e1099 = bitcast<f32>((bitcast<u32>(_e964.x) & 2147483647u));
                                                                            let _e1102 = bitcast<f32>((bitcast<u32>(_e964.y) & 2147483647u));
                                                                            let _e1104 = select(_e1102, _e1099, (_e1099 > _e1102));
                                                                            let _e1107 = bitcast<f32>((bitcast<u32>(_e964.z) & 2147483647u));
                                                                            let _e1111 = (bitcast<f32>((bitcast<u32>(_e1009) & 2147483647u)) > ((0.0000038146973f * select(_e1093, _e1090, (_e1090 > _e1093))) * select(_e1107, _e1104, (_e1104 > _e1107))));
                                                                            if _e1111 {
                                                                                phi_1633_ = (_e1004 / _e1009);
                                                                            } else {
                                                                                phi_1633_ = f32();
                                                                            }
                                                                            let _e1114 = phi_1633_;
                                                                            phi_1635_ = _e1114;
                                                                            phi_1636_ = select(true, false, _e1111);
                                                                        } else {
                                                                            phi_1635_ = f32();
                                                                            phi_1636_ = true;
                                                                        }
                                                                        let _e1117 = phi_1635_;
                                                                        let _e1119 = phi_1636_;
                                                                        if _e1119 {
                                                                            let _e1127 = (((_e975 * (_e1036 - (_e266 * _e1039))) + (_e980 * (_e1037 - (_e302 * _e1039)))) / _e1009);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1127) & 2147483647u)) <= _e941) {
                                                                                phi_1656_ = (_e1039 + _e1127);
                                                                            } else {
                                                                                phi_1656_ = _e1039;
                                                                            }
                                                                            let _e1134 = phi_1656_;
                                                                            phi_1657_ = _e1134;
                                                                        } else {
                                                                            phi_1657_ = _e1117;
                                                                        }
                                                                        let _e1136 = phi_1657_;
                                                                        let _e1138 = select(_e874, _e1136, (_e1136 < _e874));
                                                                        let _e1140 = select(_e866, _e1138, (_e1138 > _e866));
                                                                        if (_e1140 >= _e387) {
                                                                            let _e1142 = (_e1140 <= _e622.member_1);
                                                                            if _e1142 {
                                                                                let _e1143 = (1f / _e793);
                                                                                phi_1680_ = type_22(_e1140, (_e787 * _e1143), (_e791 * _e1143), _e651);
                                                                            } else {
                                                                                phi_1680_ = type_22();
                                                                            }
                                                                            let _e1148 = phi_1680_;
                                                                            phi_1682_ = _e1148;
                                                                            phi_1683_ = select(true, false, _e1142);
                                                                        } else {
                                                                            phi_1682_ = type_22();
                                                                            phi_1683_ = true;
                                                                        }
                                                                        let _e1151 = phi_1682_;
                                                                        let _e1153 = phi_1683_;
                                                                        if _e1153 {
                                                                            phi_1687_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1687_ = _e1151;
                                                                        }
                                                                        let _e1155 = phi_1687_;
                                                                        phi_1688_ = _e1155;
                                                                    }
                                                                    let _e1157 = phi_1688_;
                                                                    phi_1689_ = _e1157;
                                                                    phi_1690_ = _e883;
                                                                }
                                                                let _e1159 = phi_1689_;
                                                                let _e1161 = phi_1690_;
                                                                phi_1694_ = _e1159;
                                                                phi_1695_ = _e1161;
                                                            }
                                                            let _e1163 = phi_1694_;
                                                            let _e1165 = phi_1695_;
                                                            phi_1696_ = _e1163;
                                                            phi_1697_ = _e818;
                                                            phi_1698_ = _e1165;
                                                        }
                                                        let _e1167 = phi_1696_;
                                                        let _e1169 = phi_1697_;
                                                        let _e1171 = phi_1698_;
                                                        phi_1699_ = _e1167;
                                                        phi_1700_ = _e1169;
                                                        phi_1701_ = _e1171;
                                                    }
                                                    let _e1173 = phi_1699_;
                                                    let _e1175 = phi_1700_;
                                                    let _e1177 = phi_1701_;
                                                    phi_1709_ = _e1173;
                                                    phi_1710_ = select(_e1177, true, _e1175);
                                                } else {
                                                    phi_1709_ = type_22();
                                                    phi_1710_ = true;
                                                }
                                                let _e1180 = phi_1709_;
                                                let _e1182 = phi_1710_;
                                                if _e1182 {
                                                    phi_1714_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1714_ = _e1180;
                                                }
                                                let _e1184 = phi_1714_;
                                                if (_e1184.member_3 != 4294967295u) {
                                                    if (_e651 != _e87) {
                                                        if (_e1184.member < _e622.member.member) {
                                                            phi_1740_ = true;
                                                        } else {
                                                            if (_e1184.member == _e622.member.member) {
                                                                phi_1739_ = (_e1184.member_3 < _e622.member.member_3);
                                                            } else {
                                                                phi_1739_ = false;
                                                            }
                                                            let _e1197 = phi_1739_;
                                                            phi_1740_ = _e1197;
                                                        }
                                                        let _e1199 = phi_1740_;
                                                        if _e1199 {
                                                            phi_1746_ = type_42(_e1184, _e1184.member);
                                                        } else {
                                                            phi_1746_ = _e622;
                                                        }
                                                        let _e1202 = phi_1746_;
                                                        phi_1747_ = _e1202;
                                                    } else {
                                                        phi_1747_ = _e622;
                                                    }
                                                    let _e1204 = phi_1747_;
                                                    phi_1748_ = _e1204;
                                                } else {
                                                    phi_1748_ = _e622;
                                                }
                                                let _e1206 = phi_1748_;
                                                phi_739_ = _e1206;
                                            } else {
                                                phi_739_ = type_42();
                                            }
                                            let _e1208 = phi_739_;
                                            continue;
                                            continuing {
                                                phi_738_ = _e1208;
                                                phi_741_ = _e637;
                                                phi_2365_ = _e395;
                                                break if !(_e643);
                                            }
                                        }
                                        let _e1211 = phi_2365_;
                                        phi_2508_ = _e1211;
                                        if _e1211 {
                                            break;
                                        }
                                        phi_2512_ = _e1211;
                                        let _e1424 = local_3;
                                        phi_2203_ = _e1424;
                                        phi_2204_ = _e420;
                                        phi_2205_ = false;
                                        phi_2206_ = _e424;
                                    } else {
                                        if (_e420 >= _e68) {
                                            phi_1808_ = type_47(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e420 < _e68) {
                                            } else {
                                                phi_2508_ = true;
                                                break;
                                            }
                                            let _e434 = (_e209 % 3u);
                                            if (_e434 < 3u) {
                                            } else {
                                                phi_2508_ = true;
                                                break;
                                            }
                                            let _e440 = global_2.member[_e420].member[_e434];
                                            let _e446 = (_e208 % 3u);
                                            if (_e446 < 3u) {
                                            } else {
                                                phi_2508_ = true;
                                                break;
                                            }
                                            let _e452 = global_2.member[_e420].member[_e446];
                                            let _e458 = (_e210 % 3u);
                                            if (_e458 < 3u) {
                                            } else {
                                                phi_2508_ = true;
                                                break;
                                            }
                                            let _e464 = global_2.member[_e420].member[_e458];
                                            let _e474 = global_2.member[_e420].member_1;
                                            let _e478 = global_2.member[_e420].member_2;
                                            phi_1808_ = type_47(array<vec4<f32>, 3>(vec4<f32>(_e440[0], _e440[1], _e440[2], _e440[3]), vec4<f32>(_e452[0], _e452[1], _e452[2], _e452[3]), vec4<f32>(_e464[0], _e464[1], _e464[2], _e464[3])), _e474, _e478);
                                        }
                                        let _e481 = phi_1808_;
                                        let _e493 = ((_e481.member[0].x - _e264) * _e269);
                                        let _e494 = ((_e481.member[0].y - _e264) * _e269);
                                        let _e495 = ((_e481.member[0].z - _e265) * _e269);
                                        let _e496 = ((_e481.member[0].w - _e265) * _e269);
                                        let _e506 = ((_e481.member[1].x - _e300) * _e305);
                                        let _e507 = ((_e481.member[1].y - _e300) * _e305);
                                        let _e508 = ((_e481.member[1].z - _e301) * _e305);
                                        let _e509 = ((_e481.member[1].w - _e301) * _e305);
                                        let _e519 = ((_e481.member[2].x - _e336) * _e341);
                                        let _e520 = ((_e481.member[2].y - _e336) * _e341);
                                        let _e521 = ((_e481.member[2].z - _e337) * _e341);
                                        let _e522 = ((_e481.member[2].w - _e337) * _e341);
                                        let _e524 = select(_e521, _e519, (_e519 < _e521));
                                        let _e526 = select(_e522, _e520, (_e520 < _e522));
                                        let _e528 = select(_e521, _e519, (_e519 > _e521));
                                        let _e530 = select(_e522, _e520, (_e520 > _e522));
                                        let _e532 = select(_e495, _e493, (_e493 < _e495));
                                        let _e534 = select(_e496, _e494, (_e494 < _e496));
                                        let _e536 = select(_e508, _e506, (_e506 < _e508));
                                        let _e538 = select(_e509, _e507, (_e507 < _e509));
                                        let _e540 = select(_e536, _e532, (_e532 > _e536));
                                        let _e542 = select(_e538, _e534, (_e534 > _e538));
                                        let _e544 = select(_e524, _e540, (_e540 > _e524));
                                        let _e546 = select(_e526, _e542, (_e542 > _e526));
                                        let _e548 = select(_e495, _e493, (_e493 > _e495));
                                        let _e550 = select(_e496, _e494, (_e494 > _e496));
                                        let _e552 = select(_e508, _e506, (_e506 > _e508));
                                        let _e554 = select(_e509, _e507, (_e507 > _e509));
                                        let _e556 = select(_e552, _e548, (_e548 < _e552));
                                        let _e558 = select(_e554, _e550, (_e550 < _e554));
                                        let _e563 = -(_e524);
                                        let _e564 = -(_e526);
                                        let _e571 = (select(_e528, _e556, (_e556 < _e528)) + (select(_e563, _e528, (_e528 > _e563)) * 0.0000019073523f));
                                        let _e572 = (select(_e530, _e558, (_e558 < _e530)) + (select(_e564, _e530, (_e530 > _e564)) * 0.0000019073523f));
                                        let _e574 = select(_e387, _e544, (_e544 > _e387));
                                        let _e576 = select(_e387, _e546, (_e546 > _e387));
                                        let _e581 = (_e574 <= select(_e397.member_1, _e571, (_e571 < _e397.member_1)));
                                        let _e582 = (_e576 <= select(_e397.member_1, _e572, (_e572 < _e397.member_1)));
                                        let _e583 = (_e574 <= _e576);
                                        if _e581 {
                                            if _e582 {
                                                if _e583 {
                                                    phi_2152_ = _e481.member_2;
                                                } else {
                                                    phi_2152_ = _e481.member_1;
                                                }
                                                let _e587 = phi_2152_;
                                                let _e590 = (_e424 % 128u);
                                                let _e591 = (_e590 < 128u);
                                                if _e591 {
                                                } else {
                                                    phi_2508_ = true;
                                                    break;
                                                }
                                                local_1[_e590] = _e587;
                                                if _e591 {
                                                } else {
                                                    phi_2508_ = true;
                                                    break;
                                                }
                                                local[_e590] = select(_e576, _e574, (_e574 > _e576));
                                                if _e583 {
                                                    phi_2180_ = _e481.member_1;
                                                } else {
                                                    phi_2180_ = _e481.member_2;
                                                }
                                                let _e598 = phi_2180_;
                                                phi_2181_ = _e598;
                                                phi_2182_ = (_e424 + 1u);
                                            } else {
                                                phi_2181_ = u32();
                                                phi_2182_ = u32();
                                            }
                                            let _e600 = phi_2181_;
                                            let _e602 = phi_2182_;
                                            phi_2184_ = _e600;
                                            phi_2185_ = _e602;
                                            phi_2186_ = select(true, false, _e582);
                                        } else {
                                            phi_2184_ = u32();
                                            phi_2185_ = u32();
                                            phi_2186_ = true;
                                        }
                                        let _e605 = phi_2184_;
                                        let _e607 = phi_2185_;
                                        let _e609 = phi_2186_;
                                        if _e609 {
                                            if _e581 {
                                                phi_2195_ = _e481.member_1;
                                            } else {
                                                phi_2195_ = _e481.member_2;
                                            }
                                            let _e613 = phi_2195_;
                                            phi_2200_ = _e613;
                                            phi_2201_ = select(_e582, true, _e581);
                                        } else {
                                            phi_2200_ = _e605;
                                            phi_2201_ = _e422;
                                        }
                                        let _e616 = phi_2200_;
                                        let _e618 = phi_2201_;
                                        phi_2512_ = _e395;
                                        phi_2203_ = _e397;
                                        phi_2204_ = _e616;
                                        phi_2205_ = _e618;
                                        phi_2206_ = select(_e607, _e424, _e609);
                                    }
                                    let _e1213 = phi_2512_;
                                    let _e1215 = phi_2203_;
                                    let _e1217 = phi_2204_;
                                    let _e1219 = phi_2205_;
                                    let _e1221 = phi_2206_;
                                    phi_2511_ = _e1213;
                                    phi_2207_ = _e1215;
                                    phi_2208_ = _e1217;
                                    phi_2209_ = (_e401 - 1u);
                                    phi_2210_ = _e1219;
                                    phi_2211_ = _e1221;
                                } else {
                                    phi_2511_ = _e395;
                                    phi_2207_ = _e397;
                                    phi_2208_ = _e420;
                                    phi_2209_ = _e401;
                                    phi_2210_ = _e422;
                                    phi_2211_ = _e424;
                                }
                                let _e1223 = phi_2511_;
                                let _e1225 = phi_2207_;
                                let _e1227 = phi_2208_;
                                let _e1229 = phi_2209_;
                                let _e1231 = phi_2210_;
                                let _e1233 = phi_2211_;
                                phi_2510_ = _e1223;
                                phi_2212_ = _e1225;
                                phi_2213_ = _e1227;
                                phi_2214_ = _e1229;
                                phi_2215_ = _e1231;
                                phi_2216_ = _e1233;
                            } else {
                                phi_2510_ = _e395;
                                phi_2212_ = type_42();
                                phi_2213_ = u32();
                                phi_2214_ = u32();
                                phi_2215_ = bool();
                                phi_2216_ = u32();
                            }
                            let _e1235 = phi_2510_;
                            let _e1237 = phi_2212_;
                            let _e1239 = phi_2213_;
                            let _e1241 = phi_2214_;
                            let _e1243 = phi_2215_;
                            let _e1245 = phi_2216_;
                            phi_2509_ = _e1235;
                            phi_670_ = _e1237;
                            phi_673_ = _e1239;
                            phi_675_ = _e1241;
                            phi_677_ = _e1243;
                            phi_679_ = _e1245;
                            phi_2217_ = _e409;
                        } else {
                            phi_2509_ = _e395;
                            phi_670_ = type_42();
                            phi_673_ = u32();
                            phi_675_ = u32();
                            phi_677_ = bool();
                            phi_679_ = u32();
                            phi_2217_ = false;
                        }
                        let _e1247 = phi_2509_;
                        let _e1249 = phi_670_;
                        let _e1251 = phi_673_;
                        let _e1253 = phi_675_;
                        let _e1255 = phi_677_;
                        let _e1257 = phi_679_;
                        let _e1259 = phi_2217_;
                        continue;
                        continuing {
                            phi_2371_ = _e1247;
                            phi_669_ = _e1249;
                            phi_672_ = _e1251;
                            phi_674_ = _e1253;
                            phi_676_ = _e1255;
                            phi_678_ = _e1257;
                            phi_2508_ = _e1247;
                            break if !(_e1259);
                        }
                    }
                    let _e1262 = phi_2508_;
                    if _e1262 {
                        break;
                    }
                    let _e1264 = local_2;
                    if (_e1264.member.member_3 != 4294967295u) {
                        let _e1269 = (_e211 / 3i);
                        let _e1276 = bitcast<f32>((bitcast<u32>((_e1269 + 127i)) << bitcast<u32>(23i)));
                        let _e1284 = (((_e1264.member.member * _e1276) * _e1276) * bitcast<f32>((bitcast<u32>(((_e211 - (2i * _e1269)) + 127i)) << bitcast<u32>(23i))));
                        let _e1286 = select(340282350000000000000000000000000000000f, _e1284, (_e1284 < 340282350000000000000000000000000000000f));
                        phi_2269_ = type_22(select(-340282350000000000000000000000000000000f, _e1286, (_e1286 > -340282350000000000000000000000000000000f)), _e1264.member.member_1, _e1264.member.member_2, _e1264.member.member_3);
                    } else {
                        phi_2269_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1293 = phi_2269_;
                    if _e88 {
                    } else {
                        break;
                    }
                    global_4.member[_e80] = _e1293;
                    if _e81 {
                    } else {
                        break;
                    }
                    let _e1297 = select(0u, 1u, (_e155 <= _e165));
                    if (_e1297 > 0u) {
                        let _e1299 = (1u < _e76);
                        if _e1299 {
                            if (0u < _e76) {
                            } else {
                                break;
                            }
                            let _e1303 = atomicAdd((&global_5.member[0u]), _e1297);
                            if ((_e1303 + _e1297) < _e1303) {
                                if _e1299 {
                                } else {
                                    break;
                                }
                                let _e1308 = atomicAdd((&global_5.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1311 = select(0u, 1u, (_e1293.member_3 != 4294967295u));
                    if (_e1311 > 0u) {
                        let _e1313 = (3u < _e76);
                        if _e1313 {
                            if (2u < _e76) {
                            } else {
                                break;
                            }
                            let _e1317 = atomicAdd((&global_5.member[2u]), _e1311);
                            if ((_e1317 + _e1311) < _e1317) {
                                if _e1313 {
                                } else {
                                    break;
                                }
                                let _e1322 = atomicAdd((&global_5.member[3u]), 1u);
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
