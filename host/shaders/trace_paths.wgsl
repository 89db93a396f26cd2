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
    var phi_176_: u32;
    var phi_281_: i32;
    var phi_282_: i32;
    var phi_292_: bool;
    var phi_302_: u32;
    var phi_303_: u32;
    var phi_305_: bool;
    var phi_310_: u32;
    var phi_354_: f32;
    var phi_360_: f32;
    var phi_371_: f32;
    var phi_377_: f32;
    var phi_400_: f32;
    var phi_411_: f32;
    var phi_420_: f32;
    var phi_426_: f32;
    var phi_437_: f32;
    var phi_443_: f32;
    var phi_466_: f32;
    var phi_477_: f32;
    var phi_486_: f32;
    var phi_492_: f32;
    var phi_503_: f32;
    var phi_509_: f32;
    var phi_532_: f32;
    var phi_543_: f32;
    var phi_643_: f32;
    var phi_644_: f32;
    var phi_2357_: bool;
    var phi_918_: type_42;
    var phi_921_: u32;
    var phi_923_: u32;
    var phi_925_: bool;
    var phi_927_: u32;
    var phi_938_: bool;
    var phi_969_: u32;
    var phi_970_: bool;
    var phi_971_: u32;
    var phi_1792_: type_46;
    var phi_2136_: u32;
    var phi_2163_: u32;
    var phi_2164_: u32;
    var phi_2165_: u32;
    var phi_2167_: u32;
    var phi_2168_: u32;
    var phi_2169_: bool;
    var phi_2178_: u32;
    var phi_2183_: u32;
    var phi_2184_: bool;
    var phi_986_: type_42;
    var phi_989_: type_7;
    var phi_990_: type_7;
    var phi_1012_: type_7;
    var phi_1033_: u32;
    var phi_1122_: array<array<f32, 3>, 3>;
    var phi_1593_: vec3<f32>;
    var phi_1594_: vec3<f32>;
    var phi_1625_: bool;
    var phi_1634_: vec3<f32>;
    var phi_1674_: type_22;
    var phi_1676_: type_22;
    var phi_1677_: bool;
    var phi_1681_: type_22;
    var phi_1682_: type_22;
    var phi_1683_: type_22;
    var phi_1684_: bool;
    var phi_1688_: type_22;
    var phi_1689_: bool;
    var phi_1693_: type_22;
    var phi_1694_: bool;
    var phi_1698_: type_22;
    var phi_1723_: bool;
    var phi_1724_: bool;
    var phi_1730_: type_42;
    var phi_1731_: type_42;
    var phi_1732_: type_42;
    var phi_987_: type_42;
    var phi_2351_: bool;
    var phi_2466_: bool;
    var phi_2186_: type_42;
    var phi_2187_: u32;
    var phi_2188_: bool;
    var phi_2189_: u32;
    var phi_2465_: bool;
    var phi_2190_: type_42;
    var phi_2191_: u32;
    var phi_2192_: u32;
    var phi_2193_: bool;
    var phi_2194_: u32;
    var phi_2464_: bool;
    var phi_2195_: type_42;
    var phi_2196_: u32;
    var phi_2197_: u32;
    var phi_2198_: bool;
    var phi_2199_: u32;
    var phi_2463_: bool;
    var phi_919_: type_42;
    var phi_922_: u32;
    var phi_924_: u32;
    var phi_926_: bool;
    var phi_928_: u32;
    var phi_2200_: bool;
    var phi_2462_: bool;
    var local_2: type_42;
    var phi_2252_: type_22;
    var local_3: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e62 = global;
            let _e64 = arrayLength((&global_2.member));
            let _e66 = arrayLength((&global_1.member));
            let _e72 = arrayLength((&global_5.member));
            let _e76 = (_e62.x + (_e62.y * 2097152u));
            let _e77 = (_e76 < arrayLength((&global_3.member)));
            if _e77 {
                if _e77 {
                } else {
                    break;
                }
                let _e81 = global_3.member[_e76].member_2;
                phi_176_ = _e81;
            } else {
                phi_176_ = 4294967295u;
            }
            let _e83 = phi_176_;
            if _e77 {
                let _e84 = (_e76 < arrayLength((&global_4.member)));
                if _e84 {
                    if _e77 {
                    } else {
                        break;
                    }
                    let _e94 = global_3.member[_e76].member.member_2[0u];
                    let _e96 = (bitcast<u32>(_e94) & 2147483647u);
                    let _e102 = global_3.member[_e76].member.member_2[1u];
                    let _e104 = (bitcast<u32>(_e102) & 2147483647u);
                    let _e110 = global_3.member[_e76].member.member_2[2u];
                    let _e112 = (bitcast<u32>(_e110) & 2147483647u);
                    let _e118 = global_3.member[_e76].member.member[0u];
                    let _e120 = (bitcast<u32>(_e118) & 2147483647u);
                    let _e126 = global_3.member[_e76].member.member[1u];
                    let _e128 = (bitcast<u32>(_e126) & 2147483647u);
                    let _e134 = global_3.member[_e76].member.member[2u];
                    let _e136 = (bitcast<u32>(_e134) & 2147483647u);
                    let _e138 = select(_e104, _e96, (_e104 < _e96));
                    let _e140 = select(_e112, _e138, (_e112 < _e138));
                    let _e142 = select(_e120, _e140, (_e120 < _e140));
                    let _e144 = select(_e128, _e142, (_e128 < _e142));
                    let _e146 = select(_e136, _e144, (_e136 < _e144));
                    let _e151 = global_3.member[_e76].member.member_1;
                    let _e153 = (bitcast<u32>(_e151) & 2147483647u);
                    let _e161 = global_3.member[_e76].member.member_3;
                    let _e167 = (((select(_e153, _e146, (_e153 < _e146)) < 2139095040u) && ((bitcast<u32>(_e161) & 2147483647u) <= 2139095040u)) && (_e140 > 0u));
                    if _e167 {
                        let _e170 = (bitcast<u32>(bitcast<f32>(_e140)) & 2147483647u);
                        if (_e170 >= 8388608u) {
                            phi_281_ = (bitcast<i32>((_e170 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_281_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e170)), 32u, (_e170 == 0u))));
                        }
                        let _e184 = phi_281_;
                        phi_282_ = _e184;
                    } else {
                        phi_282_ = 0i;
                    }
                    let _e186 = phi_282_;
                    let _e187 = (_e96 == _e140);
                    if _e187 {
                        phi_292_ = true;
                    } else {
                        phi_292_ = (_e104 == _e140);
                    }
                    let _e190 = phi_292_;
                    let _e191 = select(1u, 0u, _e187);
                    if _e190 {
                        let _e192 = (_e191 + 1u);
                        phi_302_ = _e192;
                        phi_303_ = _e192;
                        phi_305_ = select(true, false, (_e192 == 2u));
                    } else {
                        phi_302_ = u32();
                        phi_303_ = 0u;
                        phi_305_ = true;
                    }
                    let _e196 = phi_302_;
                    let _e198 = phi_303_;
                    let _e200 = phi_305_;
                    if _e200 {
                        phi_310_ = (_e198 + 1u);
                    } else {
                        phi_310_ = 0u;
                    }
                    let _e204 = phi_310_;
                    let _e205 = select(_e196, _e198, _e200);
                    let _e206 = select(_e191, select(2u, _e191, _e190), _e200);
                    let _e207 = -(_e186);
                    let _e208 = (_e207 / 2i);
                    let _e213 = bitcast<f32>((bitcast<u32>((_e208 + 127i)) << bitcast<u32>(23i)));
                    let _e219 = bitcast<f32>((bitcast<u32>(((_e207 - _e208) + 127i)) << bitcast<u32>(23i)));
                    let _e224 = global_3.member[_e76].member.member;
                    let _e225 = (_e205 == 0u);
                    if _e225 {
                        phi_354_ = _e224[0];
                    } else {
                        phi_354_ = _e224[1];
                    }
                    let _e229 = phi_354_;
                    let _e230 = (_e205 == 2u);
                    if _e230 {
                        phi_360_ = _e224[2];
                    } else {
                        phi_360_ = _e229;
                    }
                    let _e233 = phi_360_;
                    let _e234 = global_3.member[_e76].member.member_2;
                    if _e225 {
                        phi_371_ = _e234[0];
                    } else {
                        phi_371_ = _e234[1];
                    }
                    let _e238 = phi_371_;
                    if _e230 {
                        phi_377_ = _e234[2];
                    } else {
                        phi_377_ = _e238;
                    }
                    let _e241 = phi_377_;
                    let _e243 = ((_e241 * _e213) * _e219);
                    let _e247 = (bitcast<f32>((bitcast<u32>(_e243) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e247 {
                        let _e251 = (bitcast<f32>((bitcast<u32>(_e233) & 2147483647u)) * 0.00000011920929f);
                        phi_400_ = select(0.00000000000011368684f, _e251, (_e251 > 0.00000000000011368684f));
                    } else {
                        phi_400_ = 0f;
                    }
                    let _e255 = phi_400_;
                    let _e256 = (_e233 + _e255);
                    let _e257 = (_e233 - _e255);
                    let _e258 = select(_e243, 0f, _e247);
                    if _e247 {
                        phi_411_ = 38685626000000000000000000f;
                    } else {
                        phi_411_ = (1f / _e243);
                    }
                    let _e261 = phi_411_;
                    let _e262 = (_e204 == 0u);
                    if _e262 {
                        phi_420_ = _e224[0];
                    } else {
                        phi_420_ = _e224[1];
                    }
                    let _e266 = phi_420_;
                    let _e267 = (_e204 == 2u);
                    if _e267 {
                        phi_426_ = _e224[2];
                    } else {
                        phi_426_ = _e266;
                    }
                    let _e270 = phi_426_;
                    if _e262 {
                        phi_437_ = _e234[0];
                    } else {
                        phi_437_ = _e234[1];
                    }
                    let _e274 = phi_437_;
                    if _e267 {
                        phi_443_ = _e234[2];
                    } else {
                        phi_443_ = _e274;
                    }
                    let _e277 = phi_443_;
                    let _e279 = ((_e277 * _e213) * _e219);
                    let _e283 = (bitcast<f32>((bitcast<u32>(_e279) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e283 {
                        let _e287 = (bitcast<f32>((bitcast<u32>(_e270) & 2147483647u)) * 0.00000011920929f);
                        phi_466_ = select(0.00000000000011368684f, _e287, (_e287 > 0.00000000000011368684f));
                    } else {
                        phi_466_ = 0f;
                    }
                    let _e291 = phi_466_;
                    let _e292 = (_e270 + _e291);
                    let _e293 = (_e270 - _e291);
                    let _e294 = select(_e279, 0f, _e283);
                    if _e283 {
                        phi_477_ = 38685626000000000000000000f;
                    } else {
                        phi_477_ = (1f / _e279);
                    }
                    let _e297 = phi_477_;
                    let _e298 = (_e206 == 0u);
                    if _e298 {
                        phi_486_ = _e224[0];
                    } else {
                        phi_486_ = _e224[1];
                    }
                    let _e302 = phi_486_;
                    let _e303 = (_e206 == 2u);
                    if _e303 {
                        phi_492_ = _e224[2];
                    } else {
                        phi_492_ = _e302;
                    }
                    let _e306 = phi_492_;
                    if _e298 {
                        phi_503_ = _e234[0];
                    } else {
                        phi_503_ = _e234[1];
                    }
                    let _e310 = phi_503_;
                    if _e303 {
                        phi_509_ = _e234[2];
                    } else {
                        phi_509_ = _e310;
                    }
                    let _e313 = phi_509_;
                    let _e315 = ((_e313 * _e213) * _e219);
                    let _e319 = (bitcast<f32>((bitcast<u32>(_e315) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e319 {
                        let _e323 = (bitcast<f32>((bitcast<u32>(_e306) & 2147483647u)) * 0.00000011920929f);
                        phi_532_ = select(0.00000000000011368684f, _e323, (_e323 > 0.00000000000011368684f));
                    } else {
                        phi_532_ = 0f;
                    }
                    let _e327 = phi_532_;
                    let _e328 = (_e306 + _e327);
                    let _e329 = (_e306 - _e327);
                    let _e330 = select(_e315, 0f, _e319);
                    if _e319 {
                        phi_543_ = 38685626000000000000000000f;
                    } else {
                        phi_543_ = (1f / _e315);
                    }
                    let _e333 = phi_543_;
                    let _e336 = bitcast<f32>((bitcast<u32>(_e233) & 2147483647u));
                    let _e339 = bitcast<f32>((bitcast<u32>(_e270) & 2147483647u));
                    let _e341 = select(_e339, _e336, (_e336 > _e339));
                    let _e344 = bitcast<f32>((bitcast<u32>(_e306) & 2147483647u));
                    if (_e167 && (select(_e344, _e341, (_e341 > _e344)) <= 1099511600000f)) {
                        let _e349 = (_e186 / 3i);
                        let _e356 = bitcast<f32>((bitcast<u32>((_e349 + 127i)) << bitcast<u32>(23i)));
                        let _e363 = bitcast<f32>((bitcast<u32>(((_e186 - (2i * _e349)) + 127i)) << bitcast<u32>(23i)));
                        let _e364 = (((_e151 * _e356) * _e356) * _e363);
                        let _e366 = select(340282350000000000000000000000000000000f, _e364, (_e364 < 340282350000000000000000000000000000000f));
                        let _e371 = (((_e161 * _e356) * _e356) * _e363);
                        let _e373 = select(340282350000000000000000000000000000000f, _e371, (_e371 < 340282350000000000000000000000000000000f));
                        phi_643_ = select(-340282350000000000000000000000000000000f, _e373, (_e373 > -340282350000000000000000000000000000000f));
                        phi_644_ = select(-340282350000000000000000000000000000000f, _e366, (_e366 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_643_ = 0f;
                        phi_644_ = 1f;
                    }
                    let _e377 = phi_643_;
                    let _e379 = phi_644_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2357_ = false;
                    phi_918_ = type_42(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e377);
                    phi_921_ = select(0u, 2147483648u, (_e64 == 0u));
                    phi_923_ = ((3u * _e64) + 1u);
                    phi_925_ = (_e379 <= _e377);
                    phi_927_ = 0u;
                    loop {
                        let _e387 = phi_2357_;
                        let _e389 = phi_918_;
                        let _e391 = phi_921_;
                        let _e393 = phi_923_;
                        let _e395 = phi_925_;
                        let _e397 = phi_927_;
                        local_2 = _e389;
                        if _e395 {
                            phi_938_ = true;
                        } else {
                            phi_938_ = (_e397 > 0u);
                        }
                        let _e400 = phi_938_;
                        if _e400 {
                            let _e401 = (_e393 > 0u);
                            if _e401 {
                                if _e395 {
                                    phi_969_ = _e391;
                                    phi_970_ = _e395;
                                    phi_971_ = _e397;
                                } else {
                                    let _e402 = (_e397 - 1u);
                                    let _e403 = (_e402 % 128u);
                                    let _e404 = (_e403 < 128u);
                                    if _e404 {
                                    } else {
                                        phi_2462_ = true;
                                        break;
                                    }
                                    let _e406 = local_1[_e403];
                                    if _e404 {
                                    } else {
                                        phi_2462_ = true;
                                        break;
                                    }
                                    let _e408 = local[_e403];
                                    phi_969_ = _e406;
                                    phi_970_ = (_e408 <= _e389.member_1);
                                    phi_971_ = _e402;
                                }
                                let _e412 = phi_969_;
                                let _e414 = phi_970_;
                                let _e416 = phi_971_;
                                if _e414 {
                                    if ((_e412 & 2147483648u) != 0u) {
                                        phi_986_ = _e389;
                                        phi_989_ = type_7(0u, ((_e412 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e614 = phi_986_;
                                            let _e616 = phi_989_;
                                            local_3 = _e614;
                                            if (_e616.member < _e616.member_1) {
                                                phi_990_ = type_7((_e616.member + 1u), _e616.member_1);
                                                phi_1012_ = type_7(1u, _e616.member);
                                            } else {
                                                phi_990_ = _e616;
                                                phi_1012_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e629 = phi_990_;
                                            let _e631 = phi_1012_;
                                            let _e635 = (bitcast<i32>(_e631.member) != 0i);
                                            if _e635 {
                                                let _e636 = ((_e412 & 268435455u) + _e631.member_1);
                                                let _e637 = (_e636 < _e66);
                                                if _e637 {
                                                    if _e637 {
                                                    } else {
                                                        phi_2351_ = true;
                                                        break;
                                                    }
                                                    let _e641 = global_1.member[_e636].member_1;
                                                    phi_1033_ = _e641;
                                                } else {
                                                    phi_1033_ = 4294967295u;
                                                }
                                                let _e643 = phi_1033_;
                                                if (_e636 >= _e66) {
                                                    phi_1122_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e637 {
                                                    } else {
                                                        phi_2351_ = true;
                                                        break;
                                                    }
                                                    let _e645 = (_e205 % 3u);
                                                    let _e646 = (_e204 % 3u);
                                                    let _e647 = (_e206 % 3u);
                                                    if (_e645 < 9u) {
                                                    } else {
                                                        phi_2351_ = true;
                                                        break;
                                                    }
                                                    let _e653 = global_1.member[_e636].member[_e645];
                                                    if (_e646 < 9u) {
                                                    } else {
                                                        phi_2351_ = true;
                                                        break;
                                                    }
                                                    let _e659 = global_1.member[_e636].member[_e646];
                                                    if (_e647 < 9u) {
                                                    } else {
                                                        phi_2351_ = true;
                                                        break;
                                                    }
                                                    let _e665 = global_1.member[_e636].member[_e647];
                                                    let _e667 = (3u + _e645);
                                                    if (_e667 < 9u) {
                                                    } else {
                                                        phi_2351_ = true;
                                                        break;
                                                    }
                                                    let _e673 = global_1.member[_e636].member[_e667];
                                                    let _e674 = (3u + _e646);
                                                    if (_e674 < 9u) {
                                                    } else {
                                                        phi_2351_ = true;
                                                        break;
                                                    }
                                                    let _e680 = global_1.member[_e636].member[_e674];
                                                    let _e681 = (3u + _e647);
                                                    if (_e681 < 9u) {
                                                    } else {
                                                        phi_2351_ = true;
                                                        break;
                                                    }
                                                    let _e687 = global_1.member[_e636].member[_e681];
                                                    let _e689 = (6u + _e645);
                                                    if (_e689 < 9u) {
                                                    } else {
                                                        phi_2351_ = true;
                                                        break;
                                                    }
                                                    let _e695 = global_1.member[_e636].member[_e689];
                                                    let _e696 = (6u + _e646);
                                                    if (_e696 < 9u) {
                                                    } else {
                                                        phi_2351_ = true;
                                                        break;
                                                    }
                                                    let _e702 = global_1.member[_e636].member[_e696];
                                                    let _e703 = (6u + _e647);
                                                    if (_e703 < 9u) {
                                                    } else {
                                                        phi_2351_ = true;
                                                        break;
                                                    }
                                                    let _e709 = global_1.member[_e636].member[_e703];
                                                    phi_1122_ = array<array<f32, 3>, 3>(array<f32, 3>(_e653, _e659, _e665), array<f32, 3>(_e673, _e680, _e687), array<f32, 3>(_e695, _e702, _e709));
                                                }
                                                let _e713 = phi_1122_;
                                                let _e721 = (_e713[0][2] - _e306);
                                                let _e724 = (((_e713[0][0] - _e233) * _e330) - (_e721 * _e258));
                                                let _e727 = (((_e713[0][1] - _e270) * _e330) - (_e721 * _e294));
                                                let _e734 = (_e713[1][2] - _e306);
                                                let _e737 = (((_e713[1][0] - _e233) * _e330) - (_e734 * _e258));
                                                let _e740 = (((_e713[1][1] - _e270) * _e330) - (_e734 * _e294));
                                                let _e747 = (_e713[2][2] - _e306);
                                                let _e750 = (((_e713[2][0] - _e233) * _e330) - (_e747 * _e258));
                                                let _e753 = (((_e713[2][1] - _e270) * _e330) - (_e747 * _e294));
                                                let _e754 = (_e750 * _e740);
                                                let _e755 = (_e753 * _e737);
                                                let _e756 = (_e724 * _e753);
                                                let _e757 = (_e727 * _e750);
                                                let _e758 = (_e737 * _e727);
                                                let _e759 = (_e740 * _e724);
                                                let _e764 = (((_e754 >= _e755) && (_e756 >= _e757)) && (_e758 >= _e759));
                                                if (_e764 || (((_e754 <= _e755) && (_e756 <= _e757)) && (_e758 <= _e759))) {
                                                    let _e771 = select(-1f, 1f, _e764);
                                                    let _e773 = ((_e754 - _e755) * _e771);
                                                    let _e775 = select(0f, _e773, (_e773 > 0f));
                                                    let _e777 = ((_e756 - _e757) * _e771);
                                                    let _e779 = select(0f, _e777, (_e777 > 0f));
                                                    let _e781 = ((_e758 - _e759) * _e771);
                                                    let _e783 = select(0f, _e781, (_e781 > 0f));
                                                    let _e785 = ((_e775 + _e779) + _e783);
                                                    if (_e785 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1688_ = type_22();
                                                        phi_1689_ = true;
                                                    } else {
                                                        let _e788 = select(_e713[1][0], _e713[0][0], (_e713[0][0] < _e713[1][0]));
                                                        let _e792 = select(_e713[1][0], _e713[0][0], (_e713[0][0] > _e713[1][0]));
                                                        let _e796 = select(_e713[1][1], _e713[0][1], (_e713[0][1] < _e713[1][1]));
                                                        let _e800 = select(_e713[1][1], _e713[0][1], (_e713[0][1] > _e713[1][1]));
                                                        let _e804 = select(_e713[1][2], _e713[0][2], (_e713[0][2] < _e713[1][2]));
                                                        let _e808 = select(_e713[1][2], _e713[0][2], (_e713[0][2] > _e713[1][2]));
                                                        let _e813 = ((select(_e713[2][0], _e788, (_e788 < _e713[2][0])) - _e256) * _e261);
                                                        let _e814 = ((select(_e713[2][0], _e792, (_e792 > _e713[2][0])) - _e257) * _e261);
                                                        let _e817 = ((select(_e713[2][1], _e796, (_e796 < _e713[2][1])) - _e292) * _e297);
                                                        let _e818 = ((select(_e713[2][1], _e800, (_e800 > _e713[2][1])) - _e293) * _e297);
                                                        let _e821 = ((select(_e713[2][2], _e804, (_e804 < _e713[2][2])) - _e328) * _e333);
                                                        let _e822 = ((select(_e713[2][2], _e808, (_e808 > _e713[2][2])) - _e329) * _e333);
                                                        let _e824 = select(_e822, _e821, (_e821 < _e822));
                                                        let _e826 = select(_e822, _e821, (_e821 > _e822));
                                                        let _e828 = select(_e814, _e813, (_e813 < _e814));
                                                        let _e830 = select(_e818, _e817, (_e817 < _e818));
                                                        let _e832 = select(_e830, _e828, (_e828 > _e830));
                                                        let _e834 = select(_e824, _e832, (_e832 > _e824));
                                                        let _e836 = select(_e814, _e813, (_e813 > _e814));
                                                        let _e838 = select(_e818, _e817, (_e817 > _e818));
                                                        let _e840 = select(_e838, _e836, (_e836 < _e838));
                                                        let _e842 = select(_e826, _e840, (_e840 < _e826));
                                                        let _e843 = -(_e824);
                                                        let _e849 = select(_e379, _e834, (_e834 > _e379));
                                                        if (_e849 > (_e842 + (select(_e843, _e826, (_e826 > _e843)) * 0.0000019073523f))) {
                                                            phi_1683_ = type_22();
                                                            phi_1684_ = true;
                                                        } else {
                                                            let _e851 = (_e849 > _e614.member_1);
                                                            if _e851 {
                                                                phi_1682_ = type_22();
                                                            } else {
                                                                let _e855 = (_e713[1][0] - _e713[0][0]);
                                                                let _e856 = (_e713[1][1] - _e713[0][1]);
                                                                let _e857 = (_e713[1][2] - _e713[0][2]);
                                                                let _e858 = vec3<f32>(_e855, _e856, _e857);
                                                                let _e859 = (_e713[2][0] - _e713[1][0]);
                                                                let _e860 = (_e713[2][1] - _e713[1][1]);
                                                                let _e861 = (_e713[2][2] - _e713[1][2]);
                                                                let _e862 = vec3<f32>(_e859, _e860, _e861);
                                                                let _e863 = (_e713[0][0] - _e713[2][0]);
                                                                let _e864 = (_e713[0][1] - _e713[2][1]);
                                                                let _e865 = (_e713[0][2] - _e713[2][2]);
                                                                let _e866 = vec3<f32>(_e863, _e864, _e865);
                                                                let _e869 = bitcast<f32>((bitcast<u32>(_e855) & 2147483647u));
                                                                let _e872 = bitcast<f32>((bitcast<u32>(_e856) & 2147483647u));
                                                                let _e874 = select(_e872, _e869, (_e869 > _e872));
                                                                let _e877 = bitcast<f32>((bitcast<u32>(_e857) & 2147483647u));
                                                                let _e879 = select(_e877, _e874, (_e874 > _e877));
                                                                let _e882 = bitcast<f32>((bitcast<u32>(_e859) & 2147483647u));
                                                                let _e885 = bitcast<f32>((bitcast<u32>(_e860) & 2147483647u));
                                                                let _e887 = select(_e885, _e882, (_e882 > _e885));
                                                                let _e890 = bitcast<f32>((bitcast<u32>(_e861) & 2147483647u));
                                                                let _e892 = select(_e890, _e887, (_e887 > _e890));
                                                                let _e895 = bitcast<f32>((bitcast<u32>(_e863) & 2147483647u));
                                                                let _e898 = bitcast<f32>((bitcast<u32>(_e864) & 2147483647u));
                                                                let _e900 = select(_e898, _e895, (_e895 > _e898));
                                                                let _e903 = bitcast<f32>((bitcast<u32>(_e865) & 2147483647u));
                                                                let _e905 = select(_e903, _e900, (_e900 > _e903));
                                                                let _e907 = select(_e892, _e879, (_e879 > _e892));
                                                                let _e909 = select(_e905, _e907, (_e907 > _e905));
                                                                if (_e879 == _e909) {
                                                                    phi_1593_ = _e862;
                                                                    phi_1594_ = _e866;
                                                                } else {
                                                                    let _e912 = vec3((_e892 == _e909));
                                                                    phi_1593_ = select(_e858, _e866, _e912);
                                                                    phi_1594_ = select(_e862, _e858, _e912);
                                                                }
                                                                let _e916 = phi_1593_;
                                                                let _e918 = phi_1594_;
                                                                let _e925 = ((_e916.y * _e918.z) - (_e918.y * _e916.z));
                                                                let _e930 = ((_e916.z * _e918.x) - (_e918.z * _e916.x));
                                                                let _e933 = ((_e916.x * _e918.y) - (_e918.x * _e916.y));
                                                                if (_e775 >= _e779) {
                                                                    phi_1625_ = select(true, false, (_e775 >= _e783));
                                                                } else {
                                                                    phi_1625_ = true;
                                                                }
                                                                let _e938 = phi_1625_;
                                                                if _e938 {
                                                                    phi_1634_ = select(vec3<f32>(_e713[2][0], _e713[2][1], _e713[2][2]), vec3<f32>(_e713[1][0], _e713[1][1], _e713[1][2]), vec3((_e779 >= _e783)));
                                                                } else {
                                                                    phi_1634_ = vec3<f32>(_e713[0][0], _e713[0][1], _e713[0][2]);
                                                                }
                                                                let _e943 = phi_1634_;
                                                                let _e960 = ((((_e925 * (_e943.x - _e233)) + (_e930 * (_e943.y - _e270))) + (_e933 * (_e943.z - _e306))) / (((_e925 * _e258) + (_e930 * _e294)) + (_e933 * _e330)));
                                                                let _e962 = select(_e842, _e960, (_e960 < _e842));
                                                                let _e964 = select(_e834, _e962, (_e962 > _e834));
                                                                if (_e964 >= _e379) {
                                                                    let _e966 = (_e964 <= _e614.member_1);
                                                                    if _e966 {
                                                                        let _e967 = (1f / _e785);
                                                                        phi_1674_ = type_22(_e964, (_e779 * _e967), (_e783 * _e967), _e643);
                                                                    } else {
                                                                        phi_1674_ = type_22();
                                                                    }
                                                                    let _e972 = phi_1674_;
                                                                    phi_1676_ = _e972;
                                                                    phi_1677_ = select(true, false, _e966);
                                                                } else {
                                                                    phi_1676_ = type_22();
                                                                    phi_1677_ = true;
                                                                }
                                                                let _e975 = phi_1676_;
                                                                let _e977 = phi_1677_;
                                                                if _e977 {
                                                                    phi_1681_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1681_ = _e975;
                                                                }
                                                                let _e979 = phi_1681_;
                                                                phi_1682_ = _e979;
                                                            }
                                                            let _e981 = phi_1682_;
                                                            phi_1683_ = _e981;
                                                            phi_1684_ = _e851;
                                                        }
                                                        let _e983 = phi_1683_;
                                                        let _e985 = phi_1684_;
                                                        phi_1688_ = _e983;
                                                        phi_1689_ = _e985;
                                                    }
                                                    let _e987 = phi_1688_;
                                                    let _e989 = phi_1689_;
                                                    phi_1693_ = _e987;
                                                    phi_1694_ = _e989;
                                                } else {
                                                    phi_1693_ = type_22();
                                                    phi_1694_ = true;
                                                }
                                                let _e991 = phi_1693_;
                                                let _e993 = phi_1694_;
                                                if _e993 {
                                                    phi_1698_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1698_ = _e991;
                                                }
                                                let _e995 = phi_1698_;
                                                if (_e995.member_3 != 4294967295u) {
                                                    if (_e643 != _e83) {
                                                        if (_e995.member < _e614.member.member) {
                                                            phi_1724_ = true;
                                                        } else {
                                                            if (_e995.member == _e614.member.member) {
                                                                phi_1723_ = (_e995.member_3 < _e614.member.member_3);
                                                            } else {
                                                                phi_1723_ = false;
                                                            }
                                                            let _e1008 = phi_1723_;
                                                            phi_1724_ = _e1008;
                                                        }
                                                        let _e1010 = phi_1724_;
                                                        if _e1010 {
                                                            phi_1730_ = type_42(_e995, _e995.member);
                                                        } else {
                                                            phi_1730_ = _e614;
                                                        }
                                                        let _e1013 = phi_1730_;
                                                        phi_1731_ = _e1013;
                                                    } else {
                                                        phi_1731_ = _e614;
                                                    }
                                                    let _e1015 = phi_1731_;
                                                    phi_1732_ = _e1015;
                                                } else {
                                                    phi_1732_ = _e614;
                                                }
                                                let _e1017 = phi_1732_;
                                                phi_987_ = _e1017;
                                            } else {
                                                phi_987_ = type_42();
                                            }
                                            let _e1019 = phi_987_;
                                            continue;
                                            continuing {
                                                phi_986_ = _e1019;
                                                phi_989_ = _e629;
                                                phi_2351_ = _e387;
                                                break if !(_e635);
                                            }
                                        }
                                        let _e1022 = phi_2351_;
                                        phi_2462_ = _e1022;
                                        if _e1022 {
                                            break;
                                        }
                                        phi_2466_ = _e1022;
                                        let _e1215 = local_3;
                                        phi_2186_ = _e1215;
                                        phi_2187_ = _e412;
                                        phi_2188_ = false;
                                        phi_2189_ = _e416;
                                    } else {
                                        if (_e412 >= _e64) {
                                            phi_1792_ = type_46(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e412 < _e64) {
                                            } else {
                                                phi_2462_ = true;
                                                break;
                                            }
                                            let _e426 = (_e205 % 3u);
                                            if (_e426 < 3u) {
                                            } else {
                                                phi_2462_ = true;
                                                break;
                                            }
                                            let _e432 = global_2.member[_e412].member[_e426];
                                            let _e438 = (_e204 % 3u);
                                            if (_e438 < 3u) {
                                            } else {
                                                phi_2462_ = true;
                                                break;
                                            }
                                            let _e444 = global_2.member[_e412].member[_e438];
                                            let _e450 = (_e206 % 3u);
                                            if (_e450 < 3u) {
                                            } else {
                                                phi_2462_ = true;
                                                break;
                                            }
                                            let _e456 = global_2.member[_e412].member[_e450];
                                            let _e466 = global_2.member[_e412].member_1;
                                            let _e470 = global_2.member[_e412].member_2;
                                            phi_1792_ = type_46(array<vec4<f32>, 3>(vec4<f32>(_e432[0], _e432[1], _e432[2], _e432[3]), vec4<f32>(_e444[0], _e444[1], _e444[2], _e444[3]), vec4<f32>(_e456[0], _e456[1], _e456[2], _e456[3])), _e466, _e470);
                                        }
                                        let _e473 = phi_1792_;
                                        let _e485 = ((_e473.member[0].x - _e256) * _e261);
                                        let _e486 = ((_e473.member[0].y - _e256) * _e261);
                                        let _e487 = ((_e473.member[0].z - _e257) * _e261);
                                        let _e488 = ((_e473.member[0].w - _e257) * _e261);
                                        let _e498 = ((_e473.member[1].x - _e292) * _e297);
                                        let _e499 = ((_e473.member[1].y - _e292) * _e297);
                                        let _e500 = ((_e473.member[1].z - _e293) * _e297);
                                        let _e501 = ((_e473.member[1].w - _e293) * _e297);
                                        let _e511 = ((_e473.member[2].x - _e328) * _e333);
                                        let _e512 = ((_e473.member[2].y - _e328) * _e333);
                                        let _e513 = ((_e473.member[2].z - _e329) * _e333);
                                        let _e514 = ((_e473.member[2].w - _e329) * _e333);
                                        let _e516 = select(_e513, _e511, (_e511 < _e513));
                                        let _e518 = select(_e514, _e512, (_e512 < _e514));
                                        let _e520 = select(_e513, _e511, (_e511 > _e513));
                                        let _e522 = select(_e514, _e512, (_e512 > _e514));
                                        let _e524 = select(_e487, _e485, (_e485 < _e487));
                                        let _e526 = select(_e488, _e486, (_e486 < _e488));
                                        let _e528 = select(_e500, _e498, (_e498 < _e500));
                                        let _e530 = select(_e501, _e499, (_e499 < _e501));
                                        let _e532 = select(_e528, _e524, (_e524 > _e528));
                                        let _e534 = select(_e530, _e526, (_e526 > _e530));
                                        let _e536 = select(_e516, _e532, (_e532 > _e516));
                                        let _e538 = select(_e518, _e534, (_e534 > _e518));
                                        let _e540 = select(_e487, _e485, (_e485 > _e487));
                                        let _e542 = select(_e488, _e486, (_e486 > _e488));
                                        let _e544 = select(_e500, _e498, (_e498 > _e500));
                                        let _e546 = select(_e501, _e499, (_e499 > _e501));
                                        let _e548 = select(_e544, _e540, (_e540 < _e544));
                                        let _e550 = select(_e546, _e542, (_e542 < _e546));
                                        let _e555 = -(_e516);
                                        let _e556 = -(_e518);
                                        let _e563 = (select(_e520, _e548, (_e548 < _e520)) + (select(_e555, _e520, (_e520 > _e555)) * 0.0000019073523f));
                                        let _e564 = (select(_e522, _e550, (_e550 < _e522)) + (select(_e556, _e522, (_e522 > _e556)) * 0.0000019073523f));
                                        let _e566 = select(_e379, _e536, (_e536 > _e379));
                                        let _e568 = select(_e379, _e538, (_e538 > _e379));
                                        let _e573 = (_e566 <= select(_e389.member_1, _e563, (_e563 < _e389.member_1)));
                                        let _e574 = (_e568 <= select(_e389.member_1, _e564, (_e564 < _e389.member_1)));
                                        let _e575 = (_e566 <= _e568);
                                        if _e573 {
                                            if _e574 {
                                                if _e575 {
                                                    phi_2136_ = _e473.member_2;
                                                } else {
                                                    phi_2136_ = _e473.member_1;
                                                }
                                                let _e579 = phi_2136_;
                                                let _e580 = (_e416 % 128u);
                                                let _e581 = (_e580 < 128u);
                                                if _e581 {
                                                } else {
                                                    phi_2462_ = true;
                                                    break;
                                                }
                                                local_1[_e580] = _e579;
                                                if _e581 {
                                                } else {
                                                    phi_2462_ = true;
                                                    break;
                                                }
                                                local[_e580] = select(_e568, _e566, (_e566 > _e568));
                                                if _e575 {
                                                    phi_2163_ = _e473.member_1;
                                                } else {
                                                    phi_2163_ = _e473.member_2;
                                                }
                                                let _e590 = phi_2163_;
                                                phi_2164_ = _e590;
                                                phi_2165_ = (_e416 + 1u);
                                            } else {
                                                phi_2164_ = u32();
                                                phi_2165_ = u32();
                                            }
                                            let _e592 = phi_2164_;
                                            let _e594 = phi_2165_;
                                            phi_2167_ = _e592;
                                            phi_2168_ = _e594;
                                            phi_2169_ = select(true, false, _e574);
                                        } else {
                                            phi_2167_ = u32();
                                            phi_2168_ = u32();
                                            phi_2169_ = true;
                                        }
                                        let _e597 = phi_2167_;
                                        let _e599 = phi_2168_;
                                        let _e601 = phi_2169_;
                                        if _e601 {
                                            if _e573 {
                                                phi_2178_ = _e473.member_1;
                                            } else {
                                                phi_2178_ = _e473.member_2;
                                            }
                                            let _e605 = phi_2178_;
                                            phi_2183_ = _e605;
                                            phi_2184_ = select(_e574, true, _e573);
                                        } else {
                                            phi_2183_ = _e597;
                                            phi_2184_ = _e414;
                                        }
                                        let _e608 = phi_2183_;
                                        let _e610 = phi_2184_;
                                        phi_2466_ = _e387;
                                        phi_2186_ = _e389;
                                        phi_2187_ = _e608;
                                        phi_2188_ = _e610;
                                        phi_2189_ = select(_e599, _e416, _e601);
                                    }
                                    let _e1024 = phi_2466_;
                                    let _e1026 = phi_2186_;
                                    let _e1028 = phi_2187_;
                                    let _e1030 = phi_2188_;
                                    let _e1032 = phi_2189_;
                                    phi_2465_ = _e1024;
                                    phi_2190_ = _e1026;
                                    phi_2191_ = _e1028;
                                    phi_2192_ = (_e393 - 1u);
                                    phi_2193_ = _e1030;
                                    phi_2194_ = _e1032;
                                } else {
                                    phi_2465_ = _e387;
                                    phi_2190_ = _e389;
                                    phi_2191_ = _e412;
                                    phi_2192_ = _e393;
                                    phi_2193_ = _e414;
                                    phi_2194_ = _e416;
                                }
                                let _e1034 = phi_2465_;
                                let _e1036 = phi_2190_;
                                let _e1038 = phi_2191_;
                                let _e1040 = phi_2192_;
                                let _e1042 = phi_2193_;
                                let _e1044 = phi_2194_;
                                phi_2464_ = _e1034;
                                phi_2195_ = _e1036;
                                phi_2196_ = _e1038;
                                phi_2197_ = _e1040;
                                phi_2198_ = _e1042;
                                phi_2199_ = _e1044;
                            } else {
                                phi_2464_ = _e387;
                                phi_2195_ = type_42();
                                phi_2196_ = u32();
                                phi_2197_ = u32();
                                phi_2198_ = bool();
                                phi_2199_ = u32();
                            }
                            let _e1046 = phi_2464_;
                            let _e1048 = phi_2195_;
                            let _e1050 = phi_2196_;
                            let _e1052 = phi_2197_;
                            let _e1054 = phi_2198_;
                            let _e1056 = phi_2199_;
                            phi_2463_ = _e1046;
                            phi_919_ = _e1048;
                            phi_922_ = _e1050;
                            phi_924_ = _e1052;
                            phi_926_ = _e1054;
                            phi_928_ = _e1056;
                            phi_2200_ = _e401;
                        } else {
                            phi_2463_ = _e387;
                            phi_919_ = type_42();
                            phi_922_ = u32();
                            phi_924_ = u32();
                            phi_926_ = bool();
                            phi_928_ = u32();
                            phi_2200_ = false;
                        }
                        let _e1058 = phi_2463_;
                        let _e1060 = phi_919_;
                        let _e1062 = phi_922_;
                        let _e1064 = phi_924_;
                        let _e1066 = phi_926_;
                        let _e1068 = phi_928_;
                        let _e1070 = phi_2200_;
                        continue;
                        continuing {
                            phi_2357_ = _e1058;
                            phi_918_ = _e1060;
                            phi_921_ = _e1062;
                            phi_923_ = _e1064;
                            phi_925_ = _e1066;
                            phi_927_ = _e1068;
                            phi_2462_ = _e1058;
                            break if !(_e1070);
                        }
                    }
                    let _e1073 = phi_2462_;
                    if _e1073 {
                        break;
                    }
                    let _e1075 = local_2;
                    if (_e1075.member.member_3 != 4294967295u) {
                        let _e1080 = (_e207 / 3i);
                        let _e1087 = bitcast<f32>((bitcast<u32>((_e1080 + 127i)) << bitcast<u32>(23i)));
                        let _e1095 = (((_e1075.member.member * _e1087) * _e1087) * bitcast<f32>((bitcast<u32>(((_e207 - (2i * _e1080)) + 127i)) << bitcast<u32>(23i))));
                        let _e1097 = select(340282350000000000000000000000000000000f, _e1095, (_e1095 < 340282350000000000000000000000000000000f));
                        phi_2252_ = type_22(select(-340282350000000000000000000000000000000f, _e1097, (_e1097 > -340282350000000000000000000000000000000f)), _e1075.member.member_1, _e1075.member.member_2, _e1075.member.member_3);
                    } else {
                        phi_2252_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1104 = phi_2252_;
                    if _e84 {
                    } else {
                        break;
                    }
                    global_4.member[_e76] = _e1104;
                    if _e77 {
                    } else {
                        break;
                    }
                    let _e1108 = select(0u, 1u, (_e151 <= _e161));
                    if (_e1108 > 0u) {
                        let _e1110 = (1u < _e72);
                        if _e1110 {
                            if (0u < _e72) {
                            } else {
                                break;
                            }
                            let _e1114 = atomicAdd((&global_5.member[0u]), _e1108);
                            if ((_e1114 + _e1108) < _e1114) {
                                if _e1110 {
                                } else {
                                    break;
                                }
                                let _e1119 = atomicAdd((&global_5.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1122 = select(0u, 1u, (_e1104.member_3 != 4294967295u));
                    if (_e1122 > 0u) {
                        let _e1124 = (3u < _e72);
                        if _e1124 {
                            if (2u < _e72) {
                            } else {
                                break;
                            }
                            let _e1128 = atomicAdd((&global_5.member[2u]), _e1122);
                            if ((_e1128 + _e1122) < _e1128) {
                                if _e1124 {
                                } else {
                                    break;
                                }
                                let _e1133 = atomicAdd((&global_5.member[3u]), 1u);
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
