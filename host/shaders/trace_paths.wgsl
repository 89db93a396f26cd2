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
    var phi_275_: i32;
    var phi_276_: i32;
    var phi_286_: bool;
    var phi_296_: u32;
    var phi_297_: u32;
    var phi_299_: bool;
    var phi_304_: u32;
    var phi_348_: f32;
    var phi_354_: f32;
    var phi_365_: f32;
    var phi_371_: f32;
    var phi_394_: f32;
    var phi_405_: f32;
    var phi_414_: f32;
    var phi_420_: f32;
    var phi_431_: f32;
    var phi_437_: f32;
    var phi_460_: f32;
    var phi_471_: f32;
    var phi_480_: f32;
    var phi_486_: f32;
    var phi_497_: f32;
    var phi_503_: f32;
    var phi_526_: f32;
    var phi_537_: f32;
    var phi_637_: f32;
    var phi_638_: f32;
    var phi_2351_: bool;
    var phi_912_: type_42;
    var phi_915_: u32;
    var phi_917_: u32;
    var phi_919_: bool;
    var phi_921_: u32;
    var phi_932_: bool;
    var phi_963_: u32;
    var phi_964_: bool;
    var phi_965_: u32;
    var phi_1786_: type_46;
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
    var phi_980_: type_42;
    var phi_983_: type_7;
    var phi_984_: type_7;
    var phi_1006_: type_7;
    var phi_1027_: u32;
    var phi_1116_: array<array<f32, 3>, 3>;
    var phi_1587_: vec3<f32>;
    var phi_1588_: vec3<f32>;
    var phi_1619_: bool;
    var phi_1628_: vec3<f32>;
    var phi_1668_: type_22;
    var phi_1670_: type_22;
    var phi_1671_: bool;
    var phi_1675_: type_22;
    var phi_1676_: type_22;
    var phi_1677_: type_22;
    var phi_1678_: bool;
    var phi_1682_: type_22;
    var phi_1683_: bool;
    var phi_1687_: type_22;
    var phi_1688_: bool;
    var phi_1692_: type_22;
    var phi_1717_: bool;
    var phi_1718_: bool;
    var phi_1724_: type_42;
    var phi_1725_: type_42;
    var phi_1726_: type_42;
    var phi_981_: type_42;
    var phi_2345_: bool;
    var phi_2459_: bool;
    var phi_2180_: type_42;
    var phi_2181_: u32;
    var phi_2182_: bool;
    var phi_2183_: u32;
    var phi_2458_: bool;
    var phi_2184_: type_42;
    var phi_2185_: u32;
    var phi_2186_: u32;
    var phi_2187_: bool;
    var phi_2188_: u32;
    var phi_2457_: bool;
    var phi_2189_: type_42;
    var phi_2190_: u32;
    var phi_2191_: u32;
    var phi_2192_: bool;
    var phi_2193_: u32;
    var phi_2456_: bool;
    var phi_913_: type_42;
    var phi_916_: u32;
    var phi_918_: u32;
    var phi_920_: bool;
    var phi_922_: u32;
    var phi_2194_: bool;
    var phi_2455_: bool;
    var local_2: type_42;
    var phi_2246_: type_22;
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
                let _e78 = (_e76 < arrayLength((&global_4.member)));
                if _e78 {
                    if _e77 {
                    } else {
                        break;
                    }
                    if _e77 {
                    } else {
                        break;
                    }
                    let _e82 = global_3.member[_e76].member_2;
                    let _e92 = global_3.member[_e76].member.member_2[0u];
                    let _e94 = (bitcast<u32>(_e92) & 2147483647u);
                    let _e100 = global_3.member[_e76].member.member_2[1u];
                    let _e102 = (bitcast<u32>(_e100) & 2147483647u);
                    let _e108 = global_3.member[_e76].member.member_2[2u];
                    let _e110 = (bitcast<u32>(_e108) & 2147483647u);
                    let _e116 = global_3.member[_e76].member.member[0u];
                    let _e118 = (bitcast<u32>(_e116) & 2147483647u);
                    let _e124 = global_3.member[_e76].member.member[1u];
                    let _e126 = (bitcast<u32>(_e124) & 2147483647u);
                    let _e132 = global_3.member[_e76].member.member[2u];
                    let _e134 = (bitcast<u32>(_e132) & 2147483647u);
                    let _e136 = select(_e102, _e94, (_e102 < _e94));
                    let _e138 = select(_e110, _e136, (_e110 < _e136));
                    let _e140 = select(_e118, _e138, (_e118 < _e138));
                    let _e142 = select(_e126, _e140, (_e126 < _e140));
                    let _e144 = select(_e134, _e142, (_e134 < _e142));
                    let _e149 = global_3.member[_e76].member.member_1;
                    let _e151 = (bitcast<u32>(_e149) & 2147483647u);
                    let _e159 = global_3.member[_e76].member.member_3;
                    let _e165 = (((select(_e151, _e144, (_e151 < _e144)) < 2139095040u) && ((bitcast<u32>(_e159) & 2147483647u) <= 2139095040u)) && (_e138 > 0u));
                    if _e165 {
                        let _e168 = (bitcast<u32>(bitcast<f32>(_e138)) & 2147483647u);
                        if (_e168 >= 8388608u) {
                            phi_275_ = (bitcast<i32>((_e168 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_275_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e168)), 32u, (_e168 == 0u))));
                        }
                        let _e182 = phi_275_;
                        phi_276_ = _e182;
                    } else {
                        phi_276_ = 0i;
                    }
                    let _e184 = phi_276_;
                    let _e185 = (_e94 == _e138);
                    if _e185 {
                        phi_286_ = true;
                    } else {
                        phi_286_ = (_e102 == _e138);
                    }
                    let _e188 = phi_286_;
                    let _e189 = select(1u, 0u, _e185);
                    if _e188 {
                        let _e190 = (_e189 + 1u);
                        phi_296_ = _e190;
                        phi_297_ = _e190;
                        phi_299_ = select(true, false, (_e190 == 2u));
                    } else {
                        phi_296_ = u32();
                        phi_297_ = 0u;
                        phi_299_ = true;
                    }
                    let _e194 = phi_296_;
                    let _e196 = phi_297_;
                    let _e198 = phi_299_;
                    if _e198 {
                        phi_304_ = (_e196 + 1u);
                    } else {
                        phi_304_ = 0u;
                    }
                    let _e202 = phi_304_;
                    let _e203 = select(_e194, _e196, _e198);
                    let _e204 = select(_e189, select(2u, _e189, _e188), _e198);
                    let _e205 = -(_e184);
                    let _e206 = (_e205 / 2i);
                    let _e211 = bitcast<f32>((bitcast<u32>((_e206 + 127i)) << bitcast<u32>(23i)));
                    let _e217 = bitcast<f32>((bitcast<u32>(((_e205 - _e206) + 127i)) << bitcast<u32>(23i)));
                    let _e222 = global_3.member[_e76].member.member;
                    let _e223 = (_e203 == 0u);
                    if _e223 {
                        phi_348_ = _e222[0];
                    } else {
                        phi_348_ = _e222[1];
                    }
                    let _e227 = phi_348_;
                    let _e228 = (_e203 == 2u);
                    if _e228 {
                        phi_354_ = _e222[2];
                    } else {
                        phi_354_ = _e227;
                    }
                    let _e231 = phi_354_;
                    let _e232 = global_3.member[_e76].member.member_2;
                    if _e223 {
                        phi_365_ = _e232[0];
                    } else {
                        phi_365_ = _e232[1];
                    }
                    let _e236 = phi_365_;
                    if _e228 {
                        phi_371_ = _e232[2];
                    } else {
                        phi_371_ = _e236;
                    }
                    let _e239 = phi_371_;
                    let _e241 = ((_e239 * _e211) * _e217);
                    let _e245 = (bitcast<f32>((bitcast<u32>(_e241) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e245 {
                        let _e249 = (bitcast<f32>((bitcast<u32>(_e231) & 2147483647u)) * 0.00000011920929f);
                        phi_394_ = select(0.00000000000011368684f, _e249, (_e249 > 0.00000000000011368684f));
                    } else {
                        phi_394_ = 0f;
                    }
                    let _e253 = phi_394_;
                    let _e254 = (_e231 + _e253);
                    let _e255 = (_e231 - _e253);
                    let _e256 = select(_e241, 0f, _e245);
                    if _e245 {
                        phi_405_ = 38685626000000000000000000f;
                    } else {
                        phi_405_ = (1f / _e241);
                    }
                    let _e259 = phi_405_;
                    let _e260 = (_e202 == 0u);
                    if _e260 {
                        phi_414_ = _e222[0];
                    } else {
                        phi_414_ = _e222[1];
                    }
                    let _e264 = phi_414_;
                    let _e265 = (_e202 == 2u);
                    if _e265 {
                        phi_420_ = _e222[2];
                    } else {
                        phi_420_ = _e264;
                    }
                    let _e268 = phi_420_;
                    if _e260 {
                        phi_431_ = _e232[0];
                    } else {
                        phi_431_ = _e232[1];
                    }
                    let _e272 = phi_431_;
                    if _e265 {
                        phi_437_ = _e232[2];
                    } else {
                        phi_437_ = _e272;
                    }
                    let _e275 = phi_437_;
                    let _e277 = ((_e275 * _e211) * _e217);
                    let _e281 = (bitcast<f32>((bitcast<u32>(_e277) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e281 {
                        let _e285 = (bitcast<f32>((bitcast<u32>(_e268) & 2147483647u)) * 0.00000011920929f);
                        phi_460_ = select(0.00000000000011368684f, _e285, (_e285 > 0.00000000000011368684f));
                    } else {
                        phi_460_ = 0f;
                    }
                    let _e289 = phi_460_;
                    let _e290 = (_e268 + _e289);
                    let _e291 = (_e268 - _e289);
                    let _e292 = select(_e277, 0f, _e281);
                    if _e281 {
                        phi_471_ = 38685626000000000000000000f;
                    } else {
                        phi_471_ = (1f / _e277);
                    }
                    let _e295 = phi_471_;
                    let _e296 = (_e204 == 0u);
                    if _e296 {
                        phi_480_ = _e222[0];
                    } else {
                        phi_480_ = _e222[1];
                    }
                    let _e300 = phi_480_;
                    let _e301 = (_e204 == 2u);
                    if _e301 {
                        phi_486_ = _e222[2];
                    } else {
                        phi_486_ = _e300;
                    }
                    let _e304 = phi_486_;
                    if _e296 {
                        phi_497_ = _e232[0];
                    } else {
                        phi_497_ = _e232[1];
                    }
                    let _e308 = phi_497_;
                    if _e301 {
                        phi_503_ = _e232[2];
                    } else {
                        phi_503_ = _e308;
                    }
                    let _e311 = phi_503_;
                    let _e313 = ((_e311 * _e211) * _e217);
                    let _e317 = (bitcast<f32>((bitcast<u32>(_e313) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e317 {
                        let _e321 = (bitcast<f32>((bitcast<u32>(_e304) & 2147483647u)) * 0.00000011920929f);
                        phi_526_ = select(0.00000000000011368684f, _e321, (_e321 > 0.00000000000011368684f));
                    } else {
                        phi_526_ = 0f;
                    }
                    let _e325 = phi_526_;
                    let _e326 = (_e304 + _e325);
                    let _e327 = (_e304 - _e325);
                    let _e328 = select(_e313, 0f, _e317);
                    if _e317 {
                        phi_537_ = 38685626000000000000000000f;
                    } else {
                        phi_537_ = (1f / _e313);
                    }
                    let _e331 = phi_537_;
                    let _e334 = bitcast<f32>((bitcast<u32>(_e231) & 2147483647u));
                    let _e337 = bitcast<f32>((bitcast<u32>(_e268) & 2147483647u));
                    let _e339 = select(_e337, _e334, (_e334 > _e337));
                    let _e342 = bitcast<f32>((bitcast<u32>(_e304) & 2147483647u));
                    if (_e165 && (select(_e342, _e339, (_e339 > _e342)) <= 1099511600000f)) {
                        let _e347 = (_e184 / 3i);
                        let _e354 = bitcast<f32>((bitcast<u32>((_e347 + 127i)) << bitcast<u32>(23i)));
                        let _e361 = bitcast<f32>((bitcast<u32>(((_e184 - (2i * _e347)) + 127i)) << bitcast<u32>(23i)));
                        let _e362 = (((_e149 * _e354) * _e354) * _e361);
                        let _e364 = select(340282350000000000000000000000000000000f, _e362, (_e362 < 340282350000000000000000000000000000000f));
                        let _e369 = (((_e159 * _e354) * _e354) * _e361);
                        let _e371 = select(340282350000000000000000000000000000000f, _e369, (_e369 < 340282350000000000000000000000000000000f));
                        phi_637_ = select(-340282350000000000000000000000000000000f, _e371, (_e371 > -340282350000000000000000000000000000000f));
                        phi_638_ = select(-340282350000000000000000000000000000000f, _e364, (_e364 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_637_ = 0f;
                        phi_638_ = 1f;
                    }
                    let _e375 = phi_637_;
                    let _e377 = phi_638_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2351_ = false;
                    phi_912_ = type_42(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e375);
                    phi_915_ = select(0u, 2147483648u, (_e64 == 0u));
                    phi_917_ = ((3u * _e64) + 1u);
                    phi_919_ = (_e377 <= _e375);
                    phi_921_ = 0u;
                    loop {
                        let _e385 = phi_2351_;
                        let _e387 = phi_912_;
                        let _e389 = phi_915_;
                        let _e391 = phi_917_;
                        let _e393 = phi_919_;
                        let _e395 = phi_921_;
                        local_2 = _e387;
                        if _e393 {
                            phi_932_ = true;
                        } else {
                            phi_932_ = (_e395 > 0u);
                        }
                        let _e398 = phi_932_;
                        if _e398 {
                            let _e399 = (_e391 > 0u);
                            if _e399 {
                                if _e393 {
                                    phi_963_ = _e389;
                                    phi_964_ = _e393;
                                    phi_965_ = _e395;
                                } else {
                                    let _e400 = (_e395 - 1u);
                                    let _e401 = (_e400 % 128u);
                                    let _e402 = (_e401 < 128u);
                                    if _e402 {
                                    } else {
                                        phi_2455_ = true;
                                        break;
                                    }
                                    let _e404 = local_1[_e401];
                                    if _e402 {
                                    } else {
                                        phi_2455_ = true;
                                        break;
                                    }
                                    let _e406 = local[_e401];
                                    phi_963_ = _e404;
                                    phi_964_ = (_e406 <= _e387.member_1);
                                    phi_965_ = _e400;
                                }
                                let _e410 = phi_963_;
                                let _e412 = phi_964_;
                                let _e414 = phi_965_;
                                if _e412 {
                                    if ((_e410 & 2147483648u) != 0u) {
                                        phi_980_ = _e387;
                                        phi_983_ = type_7(0u, ((_e410 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e612 = phi_980_;
                                            let _e614 = phi_983_;
                                            local_3 = _e612;
                                            if (_e614.member < _e614.member_1) {
                                                phi_984_ = type_7((_e614.member + 1u), _e614.member_1);
                                                phi_1006_ = type_7(1u, _e614.member);
                                            } else {
                                                phi_984_ = _e614;
                                                phi_1006_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e627 = phi_984_;
                                            let _e629 = phi_1006_;
                                            let _e633 = (bitcast<i32>(_e629.member) != 0i);
                                            if _e633 {
                                                let _e634 = ((_e410 & 268435455u) + _e629.member_1);
                                                let _e635 = (_e634 < _e66);
                                                if _e635 {
                                                    if _e635 {
                                                    } else {
                                                        phi_2345_ = true;
                                                        break;
                                                    }
                                                    let _e639 = global_1.member[_e634].member_1;
                                                    phi_1027_ = _e639;
                                                } else {
                                                    phi_1027_ = 4294967295u;
                                                }
                                                let _e641 = phi_1027_;
                                                if (_e634 >= _e66) {
                                                    phi_1116_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e635 {
                                                    } else {
                                                        phi_2345_ = true;
                                                        break;
                                                    }
                                                    let _e643 = (_e203 % 3u);
                                                    let _e644 = (_e202 % 3u);
                                                    let _e645 = (_e204 % 3u);
                                                    if (_e643 < 9u) {
                                                    } else {
                                                        phi_2345_ = true;
                                                        break;
                                                    }
                                                    let _e651 = global_1.member[_e634].member[_e643];
                                                    if (_e644 < 9u) {
                                                    } else {
                                                        phi_2345_ = true;
                                                        break;
                                                    }
                                                    let _e657 = global_1.member[_e634].member[_e644];
                                                    if (_e645 < 9u) {
                                                    } else {
                                                        phi_2345_ = true;
                                                        break;
                                                    }
                                                    let _e663 = global_1.member[_e634].member[_e645];
                                                    let _e665 = (3u + _e643);
                                                    if (_e665 < 9u) {
                                                    } else {
                                                        phi_2345_ = true;
                                                        break;
                                                    }
                                                    let _e671 = global_1.member[_e634].member[_e665];
                                                    let _e672 = (3u + _e644);
                                                    if (_e672 < 9u) {
                                                    } else {
                                                        phi_2345_ = true;
                                                        break;
                                                    }
                                                    let _e678 = global_1.member[_e634].member[_e672];
                                                    let _e679 = (3u + _e645);
                                                    if (_e679 < 9u) {
                                                    } else {
                                                        phi_2345_ = true;
                                                        break;
                                                    }
                                                    let _e685 = global_1.member[_e634].member[_e679];
                                                    let _e687 = (6u + _e643);
                                                    if (_e687 < 9u) {
                                                    } else {
                                                        phi_2345_ = true;
                                                        break;
                                                    }
                                                    let _e693 = global_1.member[_e634].member[_e687];
                                                    let _e694 = (6u + _e644);
                                                    if (_e694 < 9u) {
                                                    } else {
                                                        phi_2345_ = true;
                                                        break;
                                                    }
                                                    let _e700 = global_1.member[_e634].member[_e694];
                                                    let _e701 = (6u + _e645);
                                                    if (_e701 < 9u) {
                                                    } else {
                                                        phi_2345_ = true;
                                                        break;
                                                    }
                                                    let _e707 = global_1.member[_e634].member[_e701];
                                                    phi_1116_ = array<array<f32, 3>, 3>(array<f32, 3>(_e651, _e657, _e663), array<f32, 3>(_e671, _e678, _e685), array<f32, 3>(_e693, _e700, _e707));
                                                }
                                                let _e711 = phi_1116_;
                                                let _e719 = (_e711[0][2] - _e304);
                                                let _e722 = (((_e711[0][0] - _e231) * _e328) - (_e719 * _e256));
                                                let _e725 = (((_e711[0][1] - _e268) * _e328) - (_e719 * _e292));
                                                let _e732 = (_e711[1][2] - _e304);
                                                let _e735 = (((_e711[1][0] - _e231) * _e328) - (_e732 * _e256));
                                                let _e738 = (((_e711[1][1] - _e268) * _e328) - (_e732 * _e292));
                                                let _e745 = (_e711[2][2] - _e304);
                                                let _e748 = (((_e711[2][0] - _e231) * _e328) - (_e745 * _e256));
                                                let _e751 = (((_e711[2][1] - _e268) * _e328) - (_e745 * _e292));
                                                let _e752 = (_e748 * _e738);
                                                let _e753 = (_e751 * _e735);
                                                let _e754 = (_e722 * _e751);
                                                let _e755 = (_e725 * _e748);
                                                let _e756 = (_e735 * _e725);
                                                let _e757 = (_e738 * _e722);
                                                let _e762 = (((_e752 >= _e753) && (_e754 >= _e755)) && (_e756 >= _e757));
                                                if (_e762 || (((_e752 <= _e753) && (_e754 <= _e755)) && (_e756 <= _e757))) {
                                                    let _e769 = select(-1f, 1f, _e762);
                                                    let _e771 = ((_e752 - _e753) * _e769);
                                                    let _e773 = select(0f, _e771, (_e771 > 0f));
                                                    let _e775 = ((_e754 - _e755) * _e769);
                                                    let _e777 = select(0f, _e775, (_e775 > 0f));
                                                    let _e779 = ((_e756 - _e757) * _e769);
                                                    let _e781 = select(0f, _e779, (_e779 > 0f));
                                                    let _e783 = ((_e773 + _e777) + _e781);
                                                    if (_e783 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1682_ = type_22();
                                                        phi_1683_ = true;
                                                    } else {
                                                        let _e786 = select(_e711[1][0], _e711[0][0], (_e711[0][0] < _e711[1][0]));
                                                        let _e790 = select(_e711[1][0], _e711[0][0], (_e711[0][0] > _e711[1][0]));
                                                        let _e794 = select(_e711[1][1], _e711[0][1], (_e711[0][1] < _e711[1][1]));
                                                        let _e798 = select(_e711[1][1], _e711[0][1], (_e711[0][1] > _e711[1][1]));
                                                        let _e802 = select(_e711[1][2], _e711[0][2], (_e711[0][2] < _e711[1][2]));
                                                        let _e806 = select(_e711[1][2], _e711[0][2], (_e711[0][2] > _e711[1][2]));
                                                        let _e811 = ((select(_e711[2][0], _e786, (_e786 < _e711[2][0])) - _e254) * _e259);
                                                        let _e812 = ((select(_e711[2][0], _e790, (_e790 > _e711[2][0])) - _e255) * _e259);
                                                        let _e815 = ((select(_e711[2][1], _e794, (_e794 < _e711[2][1])) - _e290) * _e295);
                                                        let _e816 = ((select(_e711[2][1], _e798, (_e798 > _e711[2][1])) - _e291) * _e295);
                                                        let _e819 = ((select(_e711[2][2], _e802, (_e802 < _e711[2][2])) - _e326) * _e331);
                                                        let _e820 = ((select(_e711[2][2], _e806, (_e806 > _e711[2][2])) - _e327) * _e331);
                                                        let _e822 = select(_e820, _e819, (_e819 < _e820));
                                                        let _e824 = select(_e820, _e819, (_e819 > _e820));
                                                        let _e826 = select(_e812, _e811, (_e811 < _e812));
                                                        let _e828 = select(_e816, _e815, (_e815 < _e816));
                                                        let _e830 = select(_e828, _e826, (_e826 > _e828));
                                                        let _e832 = select(_e822, _e830, (_e830 > _e822));
                                                        let _e834 = select(_e812, _e811, (_e811 > _e812));
                                                        let _e836 = select(_e816, _e815, (_e815 > _e816));
                                                        let _e838 = select(_e836, _e834, (_e834 < _e836));
                                                        let _e840 = select(_e824, _e838, (_e838 < _e824));
                                                        let _e841 = -(_e822);
                                                        let _e847 = select(_e377, _e832, (_e832 > _e377));
                                                        if (_e847 > (_e840 + (select(_e841, _e824, (_e824 > _e841)) * 0.0000019073523f))) {
                                                            phi_1677_ = type_22();
                                                            phi_1678_ = true;
                                                        } else {
                                                            let _e849 = (_e847 > _e612.member_1);
                                                            if _e849 {
                                                                phi_1676_ = type_22();
                                                            } else {
                                                                let _e853 = (_e711[1][0] - _e711[0][0]);
                                                                let _e854 = (_e711[1][1] - _e711[0][1]);
                                                                let _e855 = (_e711[1][2] - _e711[0][2]);
                                                                let _e856 = vec3<f32>(_e853, _e854, _e855);
                                                                let _e857 = (_e711[2][0] - _e711[1][0]);
                                                                let _e858 = (_e711[2][1] - _e711[1][1]);
                                                                let _e859 = (_e711[2][2] - _e711[1][2]);
                                                                let _e860 = vec3<f32>(_e857, _e858, _e859);
                                                                let _e861 = (_e711[0][0] - _e711[2][0]);
                                                                let _e862 = (_e711[0][1] - _e711[2][1]);
                                                                let _e863 = (_e711[0][2] - _e711[2][2]);
                                                                let _e864 = vec3<f32>(_e861, _e862, _e863);
                                                                let _e867 = bitcast<f32>((bitcast<u32>(_e853) & 2147483647u));
                                                                let _e870 = bitcast<f32>((bitcast<u32>(_e854) & 2147483647u));
                                                                let _e872 = select(_e870, _e867, (_e867 > _e870));
                                                                let _e875 = bitcast<f32>((bitcast<u32>(_e855) & 2147483647u));
                                                                let _e877 = select(_e875, _e872, (_e872 > _e875));
                                                                let _e880 = bitcast<f32>((bitcast<u32>(_e857) & 2147483647u));
                                                                let _e883 = bitcast<f32>((bitcast<u32>(_e858) & 2147483647u));
                                                                let _e885 = select(_e883, _e880, (_e880 > _e883));
                                                                let _e888 = bitcast<f32>((bitcast<u32>(_e859) & 2147483647u));
                                                                let _e890 = select(_e888, _e885, (_e885 > _e888));
                                                                let _e893 = bitcast<f32>((bitcast<u32>(_e861) & 2147483647u));
                                                                let _e896 = bitcast<f32>((bitcast<u32>(_e862) & 2147483647u));
                                                                let _e898 = select(_e896, _e893, (_e893 > _e896));
                                                                let _e901 = bitcast<f32>((bitcast<u32>(_e863) & 2147483647u));
                                                                let _e903 = select(_e901, _e898, (_e898 > _e901));
                                                                let _e905 = select(_e890, _e877, (_e877 > _e890));
                                                                let _e907 = select(_e903, _e905, (_e905 > _e903));
                                                                if (_e877 == _e907) {
                                                                    phi_1587_ = _e860;
                                                                    phi_1588_ = _e864;
                                                                } else {
                                                                    let _e910 = vec3((_e890 == _e907));
                                                                    phi_1587_ = select(_e856, _e864, _e910);
                                                                    phi_1588_ = select(_e860, _e856, _e910);
                                                                }
                                                                let _e914 = phi_1587_;
                                                                let _e916 = phi_1588_;
                                                                let _e923 = ((_e914.y * _e916.z) - (_e916.y * _e914.z));
                                                                let _e928 = ((_e914.z * _e916.x) - (_e916.z * _e914.x));
                                                                let _e931 = ((_e914.x * _e916.y) - (_e916.x * _e914.y));
                                                                if (_e773 >= _e777) {
                                                                    phi_1619_ = select(true, false, (_e773 >= _e781));
                                                                } else {
                                                                    phi_1619_ = true;
                                                                }
                                                                let _e936 = phi_1619_;
                                                                if _e936 {
                                                                    phi_1628_ = select(vec3<f32>(_e711[2][0], _e711[2][1], _e711[2][2]), vec3<f32>(_e711[1][0], _e711[1][1], _e711[1][2]), vec3((_e777 >= _e781)));
                                                                } else {
                                                                    phi_1628_ = vec3<f32>(_e711[0][0], _e711[0][1], _e711[0][2]);
                                                                }
                                                                let _e941 = phi_1628_;
                                                                let _e958 = ((((_e923 * (_e941.x - _e231)) + (_e928 * (_e941.y - _e268))) + (_e931 * (_e941.z - _e304))) / (((_e923 * _e256) + (_e928 * _e292)) + (_e931 * _e328)));
                                                                let _e960 = select(_e840, _e958, (_e958 < _e840));
                                                                let _e962 = select(_e832, _e960, (_e960 > _e832));
                                                                if (_e962 >= _e377) {
                                                                    let _e964 = (_e962 <= _e612.member_1);
                                                                    if _e964 {
                                                                        let _e965 = (1f / _e783);
                                                                        phi_1668_ = type_22(_e962, (_e777 * _e965), (_e781 * _e965), _e641);
                                                                    } else {
                                                                        phi_1668_ = type_22();
                                                                    }
                                                                    let _e970 = phi_1668_;
                                                                    phi_1670_ = _e970;
                                                                    phi_1671_ = select(true, false, _e964);
                                                                } else {
                                                                    phi_1670_ = type_22();
                                                                    phi_1671_ = true;
                                                                }
                                                                let _e973 = phi_1670_;
                                                                let _e975 = phi_1671_;
                                                                if _e975 {
                                                                    phi_1675_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1675_ = _e973;
                                                                }
                                                                let _e977 = phi_1675_;
                                                                phi_1676_ = _e977;
                                                            }
                                                            let _e979 = phi_1676_;
                                                            phi_1677_ = _e979;
                                                            phi_1678_ = _e849;
                                                        }
                                                        let _e981 = phi_1677_;
                                                        let _e983 = phi_1678_;
                                                        phi_1682_ = _e981;
                                                        phi_1683_ = _e983;
                                                    }
                                                    let _e985 = phi_1682_;
                                                    let _e987 = phi_1683_;
                                                    phi_1687_ = _e985;
                                                    phi_1688_ = _e987;
                                                } else {
                                                    phi_1687_ = type_22();
                                                    phi_1688_ = true;
                                                }
                                                let _e989 = phi_1687_;
                                                let _e991 = phi_1688_;
                                                if _e991 {
                                                    phi_1692_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1692_ = _e989;
                                                }
                                                let _e993 = phi_1692_;
                                                if (_e993.member_3 != 4294967295u) {
                                                    if (_e641 != _e82) {
                                                        if (_e993.member < _e612.member.member) {
                                                            phi_1718_ = true;
                                                        } else {
                                                            if (_e993.member == _e612.member.member) {
                                                                phi_1717_ = (_e993.member_3 < _e612.member.member_3);
                                                            } else {
                                                                phi_1717_ = false;
                                                            }
                                                            let _e1006 = phi_1717_;
                                                            phi_1718_ = _e1006;
                                                        }
                                                        let _e1008 = phi_1718_;
                                                        if _e1008 {
                                                            phi_1724_ = type_42(_e993, _e993.member);
                                                        } else {
                                                            phi_1724_ = _e612;
                                                        }
                                                        let _e1011 = phi_1724_;
                                                        phi_1725_ = _e1011;
                                                    } else {
                                                        phi_1725_ = _e612;
                                                    }
                                                    let _e1013 = phi_1725_;
                                                    phi_1726_ = _e1013;
                                                } else {
                                                    phi_1726_ = _e612;
                                                }
                                                let _e1015 = phi_1726_;
                                                phi_981_ = _e1015;
                                            } else {
                                                phi_981_ = type_42();
                                            }
                                            let _e1017 = phi_981_;
                                            continue;
                                            continuing {
                                                phi_980_ = _e1017;
                                                phi_983_ = _e627;
                                                phi_2345_ = _e385;
                                                break if !(_e633);
                                            }
                                        }
                                        let _e1020 = phi_2345_;
                                        phi_2455_ = _e1020;
                                        if _e1020 {
                                            break;
                                        }
                                        phi_2459_ = _e1020;
                                        let _e1212 = local_3;
                                        phi_2180_ = _e1212;
                                        phi_2181_ = _e410;
                                        phi_2182_ = false;
                                        phi_2183_ = _e414;
                                    } else {
                                        if (_e410 >= _e64) {
                                            phi_1786_ = type_46(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e410 < _e64) {
                                            } else {
                                                phi_2455_ = true;
                                                break;
                                            }
                                            let _e424 = (_e203 % 3u);
                                            if (_e424 < 3u) {
                                            } else {
                                                phi_2455_ = true;
                                                break;
                                            }
                                            let _e430 = global_2.member[_e410].member[_e424];
                                            let _e436 = (_e202 % 3u);
                                            if (_e436 < 3u) {
                                            } else {
                                                phi_2455_ = true;
                                                break;
                                            }
                                            let _e442 = global_2.member[_e410].member[_e436];
                                            let _e448 = (_e204 % 3u);
                                            if (_e448 < 3u) {
                                            } else {
                                                phi_2455_ = true;
                                                break;
                                            }
                                            let _e454 = global_2.member[_e410].member[_e448];
                                            let _e464 = global_2.member[_e410].member_1;
                                            let _e468 = global_2.member[_e410].member_2;
                                            phi_1786_ = type_46(array<vec4<f32>, 3>(vec4<f32>(_e430[0], _e430[1], _e430[2], _e430[3]), vec4<f32>(_e442[0], _e442[1], _e442[2], _e442[3]), vec4<f32>(_e454[0], _e454[1], _e454[2], _e454[3])), _e464, _e468);
                                        }
                                        let _e471 = phi_1786_;
                                        let _e483 = ((_e471.member[0].x - _e254) * _e259);
                                        let _e484 = ((_e471.member[0].y - _e254) * _e259);
                                        let _e485 = ((_e471.member[0].z - _e255) * _e259);
                                        let _e486 = ((_e471.member[0].w - _e255) * _e259);
                                        let _e496 = ((_e471.member[1].x - _e290) * _e295);
                                        let _e497 = ((_e471.member[1].y - _e290) * _e295);
                                        let _e498 = ((_e471.member[1].z - _e291) * _e295);
                                        let _e499 = ((_e471.member[1].w - _e291) * _e295);
                                        let _e509 = ((_e471.member[2].x - _e326) * _e331);
                                        let _e510 = ((_e471.member[2].y - _e326) * _e331);
                                        let _e511 = ((_e471.member[2].z - _e327) * _e331);
                                        let _e512 = ((_e471.member[2].w - _e327) * _e331);
                                        let _e514 = select(_e511, _e509, (_e509 < _e511));
                                        let _e516 = select(_e512, _e510, (_e510 < _e512));
                                        let _e518 = select(_e511, _e509, (_e509 > _e511));
                                        let _e520 = select(_e512, _e510, (_e510 > _e512));
                                        let _e522 = select(_e485, _e483, (_e483 < _e485));
                                        let _e524 = select(_e486, _e484, (_e484 < _e486));
                                        let _e526 = select(_e498, _e496, (_e496 < _e498));
                                        let _e528 = select(_e499, _e497, (_e497 < _e499));
                                        let _e530 = select(_e526, _e522, (_e522 > _e526));
                                        let _e532 = select(_e528, _e524, (_e524 > _e528));
                                        let _e534 = select(_e514, _e530, (_e530 > _e514));
                                        let _e536 = select(_e516, _e532, (_e532 > _e516));
                                        let _e538 = select(_e485, _e483, (_e483 > _e485));
                                        let _e540 = select(_e486, _e484, (_e484 > _e486));
                                        let _e542 = select(_e498, _e496, (_e496 > _e498));
                                        let _e544 = select(_e499, _e497, (_e497 > _e499));
                                        let _e546 = select(_e542, _e538, (_e538 < _e542));
                                        let _e548 = select(_e544, _e540, (_e540 < _e544));
                                        let _e553 = -(_e514);
                                        let _e554 = -(_e516);
                                        let _e561 = (select(_e518, _e546, (_e546 < _e518)) + (select(_e553, _e518, (_e518 > _e553)) * 0.0000019073523f));
                                        let _e562 = (select(_e520, _e548, (_e548 < _e520)) + (select(_e554, _e520, (_e520 > _e554)) * 0.0000019073523f));
                                        let _e564 = select(_e377, _e534, (_e534 > _e377));
                                        let _e566 = select(_e377, _e536, (_e536 > _e377));
                                        let _e571 = (_e564 <= select(_e387.member_1, _e561, (_e561 < _e387.member_1)));
                                        let _e572 = (_e566 <= select(_e387.member_1, _e562, (_e562 < _e387.member_1)));
                                        let _e573 = (_e564 <= _e566);
                                        if _e571 {
                                            if _e572 {
                                                if _e573 {
                                                    phi_2130_ = _e471.member_2;
                                                } else {
                                                    phi_2130_ = _e471.member_1;
                                                }
                                                let _e577 = phi_2130_;
                                                let _e578 = (_e414 % 128u);
                                                let _e579 = (_e578 < 128u);
                                                if _e579 {
                                                } else {
                                                    phi_2455_ = true;
                                                    break;
                                                }
                                                local_1[_e578] = _e577;
                                                if _e579 {
                                                } else {
                                                    phi_2455_ = true;
                                                    break;
                                                }
                                                local[_e578] = select(_e566, _e564, (_e564 > _e566));
                                                if _e573 {
                                                    phi_2157_ = _e471.member_1;
                                                } else {
                                                    phi_2157_ = _e471.member_2;
                                                }
                                                let _e588 = phi_2157_;
                                                phi_2158_ = _e588;
                                                phi_2159_ = (_e414 + 1u);
                                            } else {
                                                phi_2158_ = u32();
                                                phi_2159_ = u32();
                                            }
                                            let _e590 = phi_2158_;
                                            let _e592 = phi_2159_;
                                            phi_2161_ = _e590;
                                            phi_2162_ = _e592;
                                            phi_2163_ = select(true, false, _e572);
                                        } else {
                                            phi_2161_ = u32();
                                            phi_2162_ = u32();
                                            phi_2163_ = true;
                                        }
                                        let _e595 = phi_2161_;
                                        let _e597 = phi_2162_;
                                        let _e599 = phi_2163_;
                                        if _e599 {
                                            if _e571 {
                                                phi_2172_ = _e471.member_1;
                                            } else {
                                                phi_2172_ = _e471.member_2;
                                            }
                                            let _e603 = phi_2172_;
                                            phi_2177_ = _e603;
                                            phi_2178_ = select(_e572, true, _e571);
                                        } else {
                                            phi_2177_ = _e595;
                                            phi_2178_ = _e412;
                                        }
                                        let _e606 = phi_2177_;
                                        let _e608 = phi_2178_;
                                        phi_2459_ = _e385;
                                        phi_2180_ = _e387;
                                        phi_2181_ = _e606;
                                        phi_2182_ = _e608;
                                        phi_2183_ = select(_e597, _e414, _e599);
                                    }
                                    let _e1022 = phi_2459_;
                                    let _e1024 = phi_2180_;
                                    let _e1026 = phi_2181_;
                                    let _e1028 = phi_2182_;
                                    let _e1030 = phi_2183_;
                                    phi_2458_ = _e1022;
                                    phi_2184_ = _e1024;
                                    phi_2185_ = _e1026;
                                    phi_2186_ = (_e391 - 1u);
                                    phi_2187_ = _e1028;
                                    phi_2188_ = _e1030;
                                } else {
                                    phi_2458_ = _e385;
                                    phi_2184_ = _e387;
                                    phi_2185_ = _e410;
                                    phi_2186_ = _e391;
                                    phi_2187_ = _e412;
                                    phi_2188_ = _e414;
                                }
                                let _e1032 = phi_2458_;
                                let _e1034 = phi_2184_;
                                let _e1036 = phi_2185_;
                                let _e1038 = phi_2186_;
                                let _e1040 = phi_2187_;
                                let _e1042 = phi_2188_;
                                phi_2457_ = _e1032;
                                phi_2189_ = _e1034;
                                phi_2190_ = _e1036;
                                phi_2191_ = _e1038;
                                phi_2192_ = _e1040;
                                phi_2193_ = _e1042;
                            } else {
                                phi_2457_ = _e385;
                                phi_2189_ = type_42();
                                phi_2190_ = u32();
                                phi_2191_ = u32();
                                phi_2192_ = bool();
                                phi_2193_ = u32();
                            }
                            let _e1044 = phi_2457_;
                            let _e1046 = phi_2189_;
                            let _e1048 = phi_2190_;
                            let _e1050 = phi_2191_;
                            let _e1052 = phi_2192_;
                            let _e1054 = phi_2193_;
                            phi_2456_ = _e1044;
                            phi_913_ = _e1046;
                            phi_916_ = _e1048;
                            phi_918_ = _e1050;
                            phi_920_ = _e1052;
                            phi_922_ = _e1054;
                            phi_2194_ = _e399;
                        } else {
                            phi_2456_ = _e385;
                            phi_913_ = type_42();
                            phi_916_ = u32();
                            phi_918_ = u32();
                            phi_920_ = bool();
                            phi_922_ = u32();
                            phi_2194_ = false;
                        }
                        let _e1056 = phi_2456_;
                        let _e1058 = phi_913_;
                        let _e1060 = phi_916_;
                        let _e1062 = phi_918_;
                        let _e1064 = phi_920_;
                        let _e1066 = phi_922_;
                        let _e1068 = phi_2194_;
                        continue;
                        continuing {
                            phi_2351_ = _e1056;
                            phi_912_ = _e1058;
                            phi_915_ = _e1060;
                            phi_917_ = _e1062;
                            phi_919_ = _e1064;
                            phi_921_ = _e1066;
                            phi_2455_ = _e1056;
                            break if !(_e1068);
                        }
                    }
                    let _e1071 = phi_2455_;
                    if _e1071 {
                        break;
                    }
                    let _e1073 = local_2;
                    if (_e1073.member.member_3 != 4294967295u) {
                        let _e1078 = (_e205 / 3i);
                        let _e1085 = bitcast<f32>((bitcast<u32>((_e1078 + 127i)) << bitcast<u32>(23i)));
                        let _e1093 = (((_e1073.member.member * _e1085) * _e1085) * bitcast<f32>((bitcast<u32>(((_e205 - (2i * _e1078)) + 127i)) << bitcast<u32>(23i))));
                        let _e1095 = select(340282350000000000000000000000000000000f, _e1093, (_e1093 < 340282350000000000000000000000000000000f));
                        phi_2246_ = type_22(select(-340282350000000000000000000000000000000f, _e1095, (_e1095 > -340282350000000000000000000000000000000f)), _e1073.member.member_1, _e1073.member.member_2, _e1073.member.member_3);
                    } else {
                        phi_2246_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1102 = phi_2246_;
                    if _e78 {
                    } else {
                        break;
                    }
                    global_4.member[_e76] = _e1102;
                    if _e77 {
                    } else {
                        break;
                    }
                    let _e1106 = select(0u, 1u, (_e149 <= _e159));
                    if (_e1106 > 0u) {
                        let _e1108 = (1u < _e72);
                        if _e1108 {
                            if (0u < _e72) {
                            } else {
                                break;
                            }
                            let _e1112 = atomicAdd((&global_5.member[0u]), _e1106);
                            if ((_e1112 + _e1106) < _e1112) {
                                if _e1108 {
                                } else {
                                    break;
                                }
                                let _e1117 = atomicAdd((&global_5.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1120 = select(0u, 1u, (_e1102.member_3 != 4294967295u));
                    if (_e1120 > 0u) {
                        let _e1122 = (3u < _e72);
                        if _e1122 {
                            if (2u < _e72) {
                            } else {
                                break;
                            }
                            let _e1126 = atomicAdd((&global_5.member[2u]), _e1120);
                            if ((_e1126 + _e1120) < _e1126) {
                                if _e1122 {
                                } else {
                                    break;
                                }
                                let _e1131 = atomicAdd((&global_5.member[3u]), 1u);
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
