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

struct type_47 {
    member: type_42,
    member_1: u32,
    member_2: u32,
}

struct type_52 {
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
var<storage, read_write> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_52;

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
    var phi_349_: f32;
    var phi_355_: f32;
    var phi_366_: f32;
    var phi_372_: f32;
    var phi_395_: f32;
    var phi_406_: f32;
    var phi_415_: f32;
    var phi_421_: f32;
    var phi_432_: f32;
    var phi_438_: f32;
    var phi_461_: f32;
    var phi_472_: f32;
    var phi_481_: f32;
    var phi_487_: f32;
    var phi_498_: f32;
    var phi_504_: f32;
    var phi_527_: f32;
    var phi_538_: f32;
    var phi_638_: f32;
    var phi_639_: f32;
    var phi_2406_: bool;
    var phi_922_: type_47;
    var phi_925_: u32;
    var phi_927_: u32;
    var phi_929_: bool;
    var phi_931_: u32;
    var phi_942_: bool;
    var phi_973_: u32;
    var phi_974_: bool;
    var phi_975_: u32;
    var phi_1803_: type_46;
    var phi_2147_: u32;
    var phi_2174_: u32;
    var phi_2175_: u32;
    var phi_2176_: u32;
    var phi_2178_: u32;
    var phi_2179_: u32;
    var phi_2180_: bool;
    var phi_2189_: u32;
    var phi_2194_: u32;
    var phi_2195_: bool;
    var phi_990_: type_47;
    var phi_993_: type_7;
    var phi_994_: type_7;
    var phi_1016_: type_7;
    var phi_1040_: u32;
    var phi_1129_: array<array<f32, 3>, 3>;
    var phi_1600_: vec3<f32>;
    var phi_1601_: vec3<f32>;
    var phi_1632_: bool;
    var phi_1641_: vec3<f32>;
    var phi_1681_: type_22;
    var phi_1683_: type_22;
    var phi_1684_: bool;
    var phi_1688_: type_22;
    var phi_1689_: type_22;
    var phi_1690_: type_22;
    var phi_1691_: bool;
    var phi_1695_: type_22;
    var phi_1696_: bool;
    var phi_1700_: type_22;
    var phi_1701_: bool;
    var phi_1705_: type_22;
    var phi_1730_: bool;
    var phi_1731_: bool;
    var phi_1738_: type_47;
    var phi_1739_: type_47;
    var phi_1740_: type_47;
    var phi_991_: type_47;
    var phi_2400_: bool;
    var phi_2514_: bool;
    var phi_2197_: type_47;
    var phi_2198_: u32;
    var phi_2199_: bool;
    var phi_2200_: u32;
    var phi_2513_: bool;
    var phi_2201_: type_47;
    var phi_2202_: u32;
    var phi_2203_: u32;
    var phi_2204_: bool;
    var phi_2205_: u32;
    var phi_2512_: bool;
    var phi_2206_: type_47;
    var phi_2207_: u32;
    var phi_2208_: u32;
    var phi_2209_: bool;
    var phi_2210_: u32;
    var phi_2511_: bool;
    var phi_923_: type_47;
    var phi_926_: u32;
    var phi_928_: u32;
    var phi_930_: bool;
    var phi_932_: u32;
    var phi_2211_: bool;
    var phi_2510_: bool;
    var local_2: type_47;
    var phi_2263_: type_22;
    var local_3: type_47;
    var local_4: type_47;

    switch bitcast<i32>(0u) {
        default: {
            let _e63 = global;
            let _e65 = arrayLength((&global_2.member));
            let _e67 = arrayLength((&global_1.member));
            let _e75 = arrayLength((&global_6.member));
            let _e79 = (_e63.x + (_e63.y * 2097152u));
            let _e80 = (_e79 < arrayLength((&global_3.member)));
            if _e80 {
                let _e81 = (_e79 < arrayLength((&global_4.member)));
                if _e81 {
                    let _e82 = (_e79 < arrayLength((&global_5.member)));
                    if _e82 {
                        if _e80 {
                        } else {
                            break;
                        }
                        let _e92 = global_3.member[_e79].member.member_2[0u];
                        let _e94 = (bitcast<u32>(_e92) & 2147483647u);
                        let _e100 = global_3.member[_e79].member.member_2[1u];
                        let _e102 = (bitcast<u32>(_e100) & 2147483647u);
                        let _e108 = global_3.member[_e79].member.member_2[2u];
                        let _e110 = (bitcast<u32>(_e108) & 2147483647u);
                        let _e116 = global_3.member[_e79].member.member[0u];
                        let _e118 = (bitcast<u32>(_e116) & 2147483647u);
                        let _e124 = global_3.member[_e79].member.member[1u];
                        let _e126 = (bitcast<u32>(_e124) & 2147483647u);
                        let _e132 = global_3.member[_e79].member.member[2u];
                        let _e134 = (bitcast<u32>(_e132) & 2147483647u);
                        let _e136 = select(_e102, _e94, (_e102 < _e94));
                        let _e138 = select(_e110, _e136, (_e110 < _e136));
                        let _e140 = select(_e118, _e138, (_e118 < _e138));
                        let _e142 = select(_e126, _e140, (_e126 < _e140));
                        let _e144 = select(_e134, _e142, (_e134 < _e142));
                        let _e149 = global_3.member[_e79].member.member_1;
                        let _e151 = (bitcast<u32>(_e149) & 2147483647u);
                        let _e159 = global_3.member[_e79].member.member_3;
                        let _e165 = (((select(_e151, _e144, (_e151 < _e144)) < 2139095040u) && ((bitcast<u32>(_e159) & 2147483647u) <= 2139095040u)) && (_e138 > 0u));
                        if _e165 {
                            let _e168 = (bitcast<u32>(bitcast<f32>(_e138)) & 2147483647u);
                            if (_e168 >= 8388608u) {
                                phi_276_ = (bitcast<i32>((_e168 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_276_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e168)), 32u, (_e168 == 0u))));
                            }
                            let _e182 = phi_276_;
                            phi_277_ = _e182;
                        } else {
                            phi_277_ = 0i;
                        }
                        let _e184 = phi_277_;
                        let _e185 = (_e94 == _e138);
                        if _e185 {
                            phi_287_ = true;
                        } else {
                            phi_287_ = (_e102 == _e138);
                        }
                        let _e188 = phi_287_;
                        let _e189 = select(1u, 0u, _e185);
                        if _e188 {
                            let _e190 = (_e189 + 1u);
                            phi_297_ = _e190;
                            phi_298_ = _e190;
                            phi_300_ = select(true, false, (_e190 == 2u));
                        } else {
                            phi_297_ = u32();
                            phi_298_ = 0u;
                            phi_300_ = true;
                        }
                        let _e194 = phi_297_;
                        let _e196 = phi_298_;
                        let _e198 = phi_300_;
                        if _e198 {
                            phi_305_ = (_e196 + 1u);
                        } else {
                            phi_305_ = 0u;
                        }
                        let _e202 = phi_305_;
                        let _e203 = select(_e194, _e196, _e198);
                        let _e204 = select(_e189, select(2u, _e189, _e188), _e198);
                        let _e205 = -(_e184);
                        let _e206 = (_e205 / 2i);
                        let _e211 = bitcast<f32>((bitcast<u32>((_e206 + 127i)) << bitcast<u32>(23i)));
                        let _e217 = bitcast<f32>((bitcast<u32>(((_e205 - _e206) + 127i)) << bitcast<u32>(23i)));
                        let _e222 = global_3.member[_e79].member.member;
                        let _e223 = (_e203 == 0u);
                        if _e223 {
                            phi_349_ = _e222[0];
                        } else {
                            phi_349_ = _e222[1];
                        }
                        let _e227 = phi_349_;
                        let _e228 = (_e203 == 2u);
                        if _e228 {
                            phi_355_ = _e222[2];
                        } else {
                            phi_355_ = _e227;
                        }
                        let _e231 = phi_355_;
                        let _e232 = global_3.member[_e79].member.member_2;
                        if _e223 {
                            phi_366_ = _e232[0];
                        } else {
                            phi_366_ = _e232[1];
                        }
                        let _e236 = phi_366_;
                        if _e228 {
                            phi_372_ = _e232[2];
                        } else {
                            phi_372_ = _e236;
                        }
                        let _e239 = phi_372_;
                        let _e241 = ((_e239 * _e211) * _e217);
                        let _e245 = (bitcast<f32>((bitcast<u32>(_e241) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e245 {
                            let _e249 = (bitcast<f32>((bitcast<u32>(_e231) & 2147483647u)) * 0.00000011920929f);
                            phi_395_ = select(0.00000000000011368684f, _e249, (_e249 > 0.00000000000011368684f));
                        } else {
                            phi_395_ = 0f;
                        }
                        let _e253 = phi_395_;
                        let _e254 = (_e231 + _e253);
                        let _e255 = (_e231 - _e253);
                        let _e256 = select(_e241, 0f, _e245);
                        if _e245 {
                            phi_406_ = 38685626000000000000000000f;
                        } else {
                            phi_406_ = (1f / _e241);
                        }
                        let _e259 = phi_406_;
                        let _e260 = (_e202 == 0u);
                        if _e260 {
                            phi_415_ = _e222[0];
                        } else {
                            phi_415_ = _e222[1];
                        }
                        let _e264 = phi_415_;
                        let _e265 = (_e202 == 2u);
                        if _e265 {
                            phi_421_ = _e222[2];
                        } else {
                            phi_421_ = _e264;
                        }
                        let _e268 = phi_421_;
                        if _e260 {
                            phi_432_ = _e232[0];
                        } else {
                            phi_432_ = _e232[1];
                        }
                        let _e272 = phi_432_;
                        if _e265 {
                            phi_438_ = _e232[2];
                        } else {
                            phi_438_ = _e272;
                        }
                        let _e275 = phi_438_;
                        let _e277 = ((_e275 * _e211) * _e217);
                        let _e281 = (bitcast<f32>((bitcast<u32>(_e277) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e281 {
                            let _e285 = (bitcast<f32>((bitcast<u32>(_e268) & 2147483647u)) * 0.00000011920929f);
                            phi_461_ = select(0.00000000000011368684f, _e285, (_e285 > 0.00000000000011368684f));
                        } else {
                            phi_461_ = 0f;
                        }
                        let _e289 = phi_461_;
                        let _e290 = (_e268 + _e289);
                        let _e291 = (_e268 - _e289);
                        let _e292 = select(_e277, 0f, _e281);
                        if _e281 {
                            phi_472_ = 38685626000000000000000000f;
                        } else {
                            phi_472_ = (1f / _e277);
                        }
                        let _e295 = phi_472_;
                        let _e296 = (_e204 == 0u);
                        if _e296 {
                            phi_481_ = _e222[0];
                        } else {
                            phi_481_ = _e222[1];
                        }
                        let _e300 = phi_481_;
                        let _e301 = (_e204 == 2u);
                        if _e301 {
                            phi_487_ = _e222[2];
                        } else {
                            phi_487_ = _e300;
                        }
                        let _e304 = phi_487_;
                        if _e296 {
                            phi_498_ = _e232[0];
                        } else {
                            phi_498_ = _e232[1];
                        }
                        let _e308 = phi_498_;
                        if _e301 {
                            phi_504_ = _e232[2];
                        } else {
                            phi_504_ = _e308;
                        }
                        let _e311 = phi_504_;
                        let _e313 = ((_e311 * _e211) * _e217);
                        let _e317 = (bitcast<f32>((bitcast<u32>(_e313) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e317 {
                            let _e321 = (bitcast<f32>((bitcast<u32>(_e304) & 2147483647u)) * 0.00000011920929f);
                            phi_527_ = select(0.00000000000011368684f, _e321, (_e321 > 0.00000000000011368684f));
                        } else {
                            phi_527_ = 0f;
                        }
                        let _e325 = phi_527_;
                        let _e326 = (_e304 + _e325);
                        let _e327 = (_e304 - _e325);
                        let _e328 = select(_e313, 0f, _e317);
                        if _e317 {
                            phi_538_ = 38685626000000000000000000f;
                        } else {
                            phi_538_ = (1f / _e313);
                        }
                        let _e331 = phi_538_;
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
                            phi_638_ = select(-340282350000000000000000000000000000000f, _e371, (_e371 > -340282350000000000000000000000000000000f));
                            phi_639_ = select(-340282350000000000000000000000000000000f, _e364, (_e364 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_638_ = 0f;
                            phi_639_ = 1f;
                        }
                        let _e375 = phi_638_;
                        let _e377 = phi_639_;
                        if _e80 {
                        } else {
                            break;
                        }
                        let _e383 = global_3.member[_e79].member_2;
                        local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        phi_2406_ = false;
                        phi_922_ = type_47(type_42(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e375), 0u, 0u);
                        phi_925_ = select(0u, 2147483648u, (_e65 == 0u));
                        phi_927_ = ((3u * _e65) + 1u);
                        phi_929_ = (_e377 <= _e375);
                        phi_931_ = 0u;
                        loop {
                            let _e390 = phi_2406_;
                            let _e392 = phi_922_;
                            let _e394 = phi_925_;
                            let _e396 = phi_927_;
                            let _e398 = phi_929_;
                            let _e400 = phi_931_;
                            local_2 = _e392;
                            local_3 = _e392;
                            if _e398 {
                                phi_942_ = true;
                            } else {
                                phi_942_ = (_e400 > 0u);
                            }
                            let _e403 = phi_942_;
                            if _e403 {
                                let _e404 = (_e396 > 0u);
                                if _e404 {
                                    if _e398 {
                                        phi_973_ = _e394;
                                        phi_974_ = _e398;
                                        phi_975_ = _e400;
                                    } else {
                                        let _e405 = (_e400 - 1u);
                                        let _e406 = (_e405 % 128u);
                                        let _e407 = (_e406 < 128u);
                                        if _e407 {
                                        } else {
                                            phi_2510_ = true;
                                            break;
                                        }
                                        let _e409 = local_1[_e406];
                                        if _e407 {
                                        } else {
                                            phi_2510_ = true;
                                            break;
                                        }
                                        let _e411 = local[_e406];
                                        phi_973_ = _e409;
                                        phi_974_ = (_e411 <= _e392.member.member_1);
                                        phi_975_ = _e405;
                                    }
                                    let _e416 = phi_973_;
                                    let _e418 = phi_974_;
                                    let _e420 = phi_975_;
                                    if _e418 {
                                        if ((_e416 & 2147483648u) != 0u) {
                                            phi_990_ = _e392;
                                            phi_993_ = type_7(0u, ((_e416 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e625 = phi_990_;
                                                let _e627 = phi_993_;
                                                local_4 = _e625;
                                                if (_e627.member < _e627.member_1) {
                                                    phi_994_ = type_7((_e627.member + 1u), _e627.member_1);
                                                    phi_1016_ = type_7(1u, _e627.member);
                                                } else {
                                                    phi_994_ = _e627;
                                                    phi_1016_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e640 = phi_994_;
                                                let _e642 = phi_1016_;
                                                let _e646 = (bitcast<i32>(_e642.member) != 0i);
                                                if _e646 {
                                                    let _e652 = type_47(_e625.member, _e625.member_1, (_e625.member_2 + 1u));
                                                    let _e653 = ((_e416 & 268435455u) + _e642.member_1);
                                                    let _e654 = (_e653 < _e67);
                                                    if _e654 {
                                                        if _e654 {
                                                        } else {
                                                            phi_2400_ = true;
                                                            break;
                                                        }
                                                        let _e658 = global_1.member[_e653].member_1;
                                                        phi_1040_ = _e658;
                                                    } else {
                                                        phi_1040_ = 4294967295u;
                                                    }
                                                    let _e660 = phi_1040_;
                                                    if (_e653 >= _e67) {
                                                        phi_1129_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e654 {
                                                        } else {
                                                            phi_2400_ = true;
                                                            break;
                                                        }
                                                        let _e662 = (_e203 % 3u);
                                                        let _e663 = (_e202 % 3u);
                                                        let _e664 = (_e204 % 3u);
                                                        if (_e662 < 9u) {
                                                        } else {
                                                            phi_2400_ = true;
                                                            break;
                                                        }
                                                        let _e670 = global_1.member[_e653].member[_e662];
                                                        if (_e663 < 9u) {
                                                        } else {
                                                            phi_2400_ = true;
                                                            break;
                                                        }
                                                        let _e676 = global_1.member[_e653].member[_e663];
                                                        if (_e664 < 9u) {
                                                        } else {
                                                            phi_2400_ = true;
                                                            break;
                                                        }
                                                        let _e682 = global_1.member[_e653].member[_e664];
                                                        let _e684 = (3u + _e662);
                                                        if (_e684 < 9u) {
                                                        } else {
                                                            phi_2400_ = true;
                                                            break;
                                                        }
                                                        let _e690 = global_1.member[_e653].member[_e684];
                                                        let _e691 = (3u + _e663);
                                                        if (_e691 < 9u) {
                                                        } else {
                                                            phi_2400_ = true;
                                                            break;
                                                        }
                                                        let _e697 = global_1.member[_e653].member[_e691];
                                                        let _e698 = (3u + _e664);
                                                        if (_e698 < 9u) {
                                                        } else {
                                                            phi_2400_ = true;
                                                            break;
                                                        }
                                                        let _e704 = global_1.member[_e653].member[_e698];
                                                        let _e706 = (6u + _e662);
                                                        if (_e706 < 9u) {
                                                        } else {
                                                            phi_2400_ = true;
                                                            break;
                                                        }
                                                        let _e712 = global_1.member[_e653].member[_e706];
                                                        let _e713 = (6u + _e663);
                                                        if (_e713 < 9u) {
                                                        } else {
                                                            phi_2400_ = true;
                                                            break;
                                                        }
                                                        let _e719 = global_1.member[_e653].member[_e713];
                                                        let _e720 = (6u + _e664);
                                                        if (_e720 < 9u) {
                                                        } else {
                                                            phi_2400_ = true;
                                                            break;
                                                        }
                                                        let _e726 = global_1.member[_e653].member[_e720];
                                                        phi_1129_ = array<array<f32, 3>, 3>(array<f32, 3>(_e670, _e676, _e682), array<f32, 3>(_e690, _e697, _e704), array<f32, 3>(_e712, _e719, _e726));
                                                    }
                                                    let _e730 = phi_1129_;
                                                    let _e739 = (_e730[0][2] - _e304);
                                                    let _e742 = (((_e730[0][0] - _e231) * _e328) - (_e739 * _e256));
                                                    let _e745 = (((_e730[0][1] - _e268) * _e328) - (_e739 * _e292));
                                                    let _e752 = (_e730[1][2] - _e304);
                                                    let _e755 = (((_e730[1][0] - _e231) * _e328) - (_e752 * _e256));
                                                    let _e758 = (((_e730[1][1] - _e268) * _e328) - (_e752 * _e292));
                                                    let _e765 = (_e730[2][2] - _e304);
                                                    let _e768 = (((_e730[2][0] - _e231) * _e328) - (_e765 * _e256));
                                                    let _e771 = (((_e730[2][1] - _e268) * _e328) - (_e765 * _e292));
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
                                                            phi_1695_ = type_22();
                                                            phi_1696_ = true;
                                                        } else {
                                                            let _e806 = select(_e730[1][0], _e730[0][0], (_e730[0][0] < _e730[1][0]));
                                                            let _e810 = select(_e730[1][0], _e730[0][0], (_e730[0][0] > _e730[1][0]));
                                                            let _e814 = select(_e730[1][1], _e730[0][1], (_e730[0][1] < _e730[1][1]));
                                                            let _e818 = select(_e730[1][1], _e730[0][1], (_e730[0][1] > _e730[1][1]));
                                                            let _e822 = select(_e730[1][2], _e730[0][2], (_e730[0][2] < _e730[1][2]));
                                                            let _e826 = select(_e730[1][2], _e730[0][2], (_e730[0][2] > _e730[1][2]));
                                                            let _e831 = ((select(_e730[2][0], _e806, (_e806 < _e730[2][0])) - _e254) * _e259);
                                                            let _e832 = ((select(_e730[2][0], _e810, (_e810 > _e730[2][0])) - _e255) * _e259);
                                                            let _e835 = ((select(_e730[2][1], _e814, (_e814 < _e730[2][1])) - _e290) * _e295);
                                                            let _e836 = ((select(_e730[2][1], _e818, (_e818 > _e730[2][1])) - _e291) * _e295);
                                                            let _e839 = ((select(_e730[2][2], _e822, (_e822 < _e730[2][2])) - _e326) * _e331);
                                                            let _e840 = ((select(_e730[2][2], _e826, (_e826 > _e730[2][2])) - _e327) * _e331);
                                                            let _e842 = select(_e840, _e839, (_e839 < _e840));
                                                            let _e844 = select(_e840, _e839, (_e839 > _e840));
                                                            let _e846 = select(_e832, _e831, (_e831 < _e832));
                                                            let _e848 = select(_e836, _e835, (_e835 < _e836));
                                                            let _e850 = select(_e848, _e846, (_e846 > _e848));
                                                            let _e852 = select(_e842, _e850, (_e850 > _e842));
                                                            let _e854 = select(_e832, _e831, (_e831 > _e832));
                                                            let _e856 = select(_e836, _e835, (_e835 > _e836));
                                                            let _e858 = select(_e856, _e854, (_e854 < _e856));
                                                            let _e860 = select(_e844, _e858, (_e858 < _e844));
                                                            let _e861 = -(_e842);
                                                            let _e867 = select(_e377, _e852, (_e852 > _e377));
                                                            if (_e867 > (_e860 + (select(_e861, _e844, (_e844 > _e861)) * 0.0000019073523f))) {
                                                                phi_1690_ = type_22();
                                                                phi_1691_ = true;
                                                            } else {
                                                                let _e869 = (_e867 > _e625.member.member_1);
                                                                if _e869 {
                                                                    phi_1689_ = type_22();
                                                                } else {
                                                                    let _e873 = (_e730[1][0] - _e730[0][0]);
                                                                    let _e874 = (_e730[1][1] - _e730[0][1]);
                                                                    let _e875 = (_e730[1][2] - _e730[0][2]);
                                                                    let _e876 = vec3<f32>(_e873, _e874, _e875);
                                                                    let _e877 = (_e730[2][0] - _e730[1][0]);
                                                                    let _e878 = (_e730[2][1] - _e730[1][1]);
                                                                    let _e879 = (_e730[2][2] - _e730[1][2]);
                                                                    let _e880 = vec3<f32>(_e877, _e878, _e879);
                                                                    let _e881 = (_e730[0][0] - _e730[2][0]);
                                                                    let _e882 = (_e730[0][1] - _e730[2][1]);
                                                                    let _e883 = (_e730[0][2] - _e730[2][2]);
                                                                    let _e884 = vec3<f32>(_e881, _e882, _e883);
                                                                    let _e887 = bitcast<f32>((bitcast<u32>(_e873) & 2147483647u));
                                                                    let _e890 = bitcast<f32>((bitcast<u32>(_e874) & 2147483647u));
                                                                    let _e892 = select(_e890, _e887, (_e887 > _e890));
                                                                    let _e895 = bitcast<f32>((bitcast<u32>(_e875) & 2147483647u));
                                                                    let _e897 = select(_e895, _e892, (_e892 > _e895));
                                                                    let _e900 = bitcast<f32>((bitcast<u32>(_e877) & 2147483647u));
                                                                    let _e903 = bitcast<f32>((bitcast<u32>(_e878) & 2147483647u));
                                                                    let _e905 = select(_e903, _e900, (_e900 > _e903));
                                                                    let _e908 = bitcast<f32>((bitcast<u32>(_e879) & 2147483647u));
                                                                    let _e910 = select(_e908, _e905, (_e905 > _e908));
                                                                    let _e913 = bitcast<f32>((bitcast<u32>(_e881) & 2147483647u));
                                                                    let _e916 = bitcast<f32>((bitcast<u32>(_e882) & 2147483647u));
                                                                    let _e918 = select(_e916, _e913, (_e913 > _e916));
                                                                    let _e921 = bitcast<f32>((bitcast<u32>(_e883) & 2147483647u));
                                                                    let _e923 = select(_e921, _e918, (_e918 > _e921));
                                                                    let _e925 = select(_e910, _e897, (_e897 > _e910));
                                                                    let _e927 = select(_e923, _e925, (_e925 > _e923));
                                                                    if (_e897 == _e927) {
                                                                        phi_1600_ = _e880;
                                                                        phi_1601_ = _e884;
                                                                    } else {
                                                                        let _e930 = vec3((_e910 == _e927));
                                                                        phi_1600_ = select(_e876, _e884, _e930);
                                                                        phi_1601_ = select(_e880, _e876, _e930);
                                                                    }
                                                                    let _e934 = phi_1600_;
                                                                    let _e936 = phi_1601_;
                                                                    let _e943 = ((_e934.y * _e936.z) - (_e936.y * _e934.z));
                                                                    let _e948 = ((_e934.z * _e936.x) - (_e936.z * _e934.x));
                                                                    let _e951 = ((_e934.x * _e936.y) - (_e936.x * _e934.y));
                                                                    if (_e793 >= _e797) {
                                                                        phi_1632_ = select(true, false, (_e793 >= _e801));
                                                                    } else {
                                                                        phi_1632_ = true;
                                                                    }
                                                                    let _e956 = phi_1632_;
                                                                    if _e956 {
                                                                        phi_1641_ = select(vec3<f32>(_e730[2][0], _e730[2][1], _e730[2][2]), vec3<f32>(_e730[1][0], _e730[1][1], _e730[1][2]), vec3((_e797 >= _e801)));
                                                                    } else {
                                                                        phi_1641_ = vec3<f32>(_e730[0][0], _e730[0][1], _e730[0][2]);
                                                                    }
                                                                    let _e961 = phi_1641_;
                                                                    let _e978 = ((((_e943 * (_e961.x - _e231)) + (_e948 * (_e961.y - _e268))) + (_e951 * (_e961.z - _e304))) / (((_e943 * _e256) + (_e948 * _e292)) + (_e951 * _e328)));
                                                                    let _e980 = select(_e860, _e978, (_e978 < _e860));
                                                                    let _e982 = select(_e852, _e980, (_e980 > _e852));
                                                                    if (_e982 >= _e377) {
                                                                        let _e984 = (_e982 <= _e625.member.member_1);
                                                                        if _e984 {
                                                                            let _e985 = (1f / _e803);
                                                                            phi_1681_ = type_22(_e982, (_e797 * _e985), (_e801 * _e985), _e660);
                                                                        } else {
                                                                            phi_1681_ = type_22();
                                                                        }
                                                                        let _e990 = phi_1681_;
                                                                        phi_1683_ = _e990;
                                                                        phi_1684_ = select(true, false, _e984);
                                                                    } else {
                                                                        phi_1683_ = type_22();
                                                                        phi_1684_ = true;
                                                                    }
                                                                    let _e993 = phi_1683_;
                                                                    let _e995 = phi_1684_;
                                                                    if _e995 {
                                                                        phi_1688_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_1688_ = _e993;
                                                                    }
                                                                    let _e997 = phi_1688_;
                                                                    phi_1689_ = _e997;
                                                                }
                                                                let _e999 = phi_1689_;
                                                                phi_1690_ = _e999;
                                                                phi_1691_ = _e869;
                                                            }
                                                            let _e1001 = phi_1690_;
                                                            let _e1003 = phi_1691_;
                                                            phi_1695_ = _e1001;
                                                            phi_1696_ = _e1003;
                                                        }
                                                        let _e1005 = phi_1695_;
                                                        let _e1007 = phi_1696_;
                                                        phi_1700_ = _e1005;
                                                        phi_1701_ = _e1007;
                                                    } else {
                                                        phi_1700_ = type_22();
                                                        phi_1701_ = true;
                                                    }
                                                    let _e1009 = phi_1700_;
                                                    let _e1011 = phi_1701_;
                                                    if _e1011 {
                                                        phi_1705_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1705_ = _e1009;
                                                    }
                                                    let _e1013 = phi_1705_;
                                                    if (_e1013.member_3 != 4294967295u) {
                                                        if (_e660 != _e383) {
                                                            if (_e1013.member < _e625.member.member.member) {
                                                                phi_1731_ = true;
                                                            } else {
                                                                if (_e1013.member == _e625.member.member.member) {
                                                                    phi_1730_ = (_e1013.member_3 < _e625.member.member.member_3);
                                                                } else {
                                                                    phi_1730_ = false;
                                                                }
                                                                let _e1028 = phi_1730_;
                                                                phi_1731_ = _e1028;
                                                            }
                                                            let _e1030 = phi_1731_;
                                                            if _e1030 {
                                                                phi_1738_ = type_47(type_42(_e1013, _e1013.member), _e652.member_1, _e652.member_2);
                                                            } else {
                                                                phi_1738_ = _e652;
                                                            }
                                                            let _e1037 = phi_1738_;
                                                            phi_1739_ = _e1037;
                                                        } else {
                                                            phi_1739_ = _e652;
                                                        }
                                                        let _e1039 = phi_1739_;
                                                        phi_1740_ = _e1039;
                                                    } else {
                                                        phi_1740_ = _e652;
                                                    }
                                                    let _e1041 = phi_1740_;
                                                    phi_991_ = _e1041;
                                                } else {
                                                    phi_991_ = type_47();
                                                }
                                                let _e1043 = phi_991_;
                                                continue;
                                                continuing {
                                                    phi_990_ = _e1043;
                                                    phi_993_ = _e640;
                                                    phi_2400_ = _e390;
                                                    break if !(_e646);
                                                }
                                            }
                                            let _e1046 = phi_2400_;
                                            phi_2510_ = _e1046;
                                            if _e1046 {
                                                break;
                                            }
                                            phi_2514_ = _e1046;
                                            let _e1255 = local_4;
                                            phi_2197_ = _e1255;
                                            phi_2198_ = _e416;
                                            phi_2199_ = false;
                                            phi_2200_ = _e420;
                                        } else {
                                            if (_e416 >= _e65) {
                                                phi_1803_ = type_46(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                            } else {
                                                if (_e416 < _e65) {
                                                } else {
                                                    phi_2510_ = true;
                                                    break;
                                                }
                                                let _e436 = (_e203 % 3u);
                                                if (_e436 < 3u) {
                                                } else {
                                                    phi_2510_ = true;
                                                    break;
                                                }
                                                let _e442 = global_2.member[_e416].member[_e436];
                                                let _e448 = (_e202 % 3u);
                                                if (_e448 < 3u) {
                                                } else {
                                                    phi_2510_ = true;
                                                    break;
                                                }
                                                let _e454 = global_2.member[_e416].member[_e448];
                                                let _e460 = (_e204 % 3u);
                                                if (_e460 < 3u) {
                                                } else {
                                                    phi_2510_ = true;
                                                    break;
                                                }
                                                let _e466 = global_2.member[_e416].member[_e460];
                                                let _e476 = global_2.member[_e416].member_1;
                                                let _e480 = global_2.member[_e416].member_2;
                                                phi_1803_ = type_46(array<vec4<f32>, 3>(vec4<f32>(_e442[0], _e442[1], _e442[2], _e442[3]), vec4<f32>(_e454[0], _e454[1], _e454[2], _e454[3]), vec4<f32>(_e466[0], _e466[1], _e466[2], _e466[3])), _e476, _e480);
                                            }
                                            let _e483 = phi_1803_;
                                            let _e496 = ((_e483.member[0].x - _e254) * _e259);
                                            let _e497 = ((_e483.member[0].y - _e254) * _e259);
                                            let _e498 = ((_e483.member[0].z - _e255) * _e259);
                                            let _e499 = ((_e483.member[0].w - _e255) * _e259);
                                            let _e509 = ((_e483.member[1].x - _e290) * _e295);
                                            let _e510 = ((_e483.member[1].y - _e290) * _e295);
                                            let _e511 = ((_e483.member[1].z - _e291) * _e295);
                                            let _e512 = ((_e483.member[1].w - _e291) * _e295);
                                            let _e522 = ((_e483.member[2].x - _e326) * _e331);
                                            let _e523 = ((_e483.member[2].y - _e326) * _e331);
                                            let _e524 = ((_e483.member[2].z - _e327) * _e331);
                                            let _e525 = ((_e483.member[2].w - _e327) * _e331);
                                            let _e527 = select(_e524, _e522, (_e522 < _e524));
                                            let _e529 = select(_e525, _e523, (_e523 < _e525));
                                            let _e531 = select(_e524, _e522, (_e522 > _e524));
                                            let _e533 = select(_e525, _e523, (_e523 > _e525));
                                            let _e535 = select(_e498, _e496, (_e496 < _e498));
                                            let _e537 = select(_e499, _e497, (_e497 < _e499));
                                            let _e539 = select(_e511, _e509, (_e509 < _e511));
                                            let _e541 = select(_e512, _e510, (_e510 < _e512));
                                            let _e543 = select(_e539, _e535, (_e535 > _e539));
                                            let _e545 = select(_e541, _e537, (_e537 > _e541));
                                            let _e547 = select(_e527, _e543, (_e543 > _e527));
                                            let _e549 = select(_e529, _e545, (_e545 > _e529));
                                            let _e551 = select(_e498, _e496, (_e496 > _e498));
                                            let _e553 = select(_e499, _e497, (_e497 > _e499));
                                            let _e555 = select(_e511, _e509, (_e509 > _e511));
                                            let _e557 = select(_e512, _e510, (_e510 > _e512));
                                            let _e559 = select(_e555, _e551, (_e551 < _e555));
                                            let _e561 = select(_e557, _e553, (_e553 < _e557));
                                            let _e566 = -(_e527);
                                            let _e567 = -(_e529);
                                            let _e574 = (select(_e531, _e559, (_e559 < _e531)) + (select(_e566, _e531, (_e531 > _e566)) * 0.0000019073523f));
                                            let _e575 = (select(_e533, _e561, (_e561 < _e533)) + (select(_e567, _e533, (_e533 > _e567)) * 0.0000019073523f));
                                            let _e577 = select(_e377, _e547, (_e547 > _e377));
                                            let _e579 = select(_e377, _e549, (_e549 > _e377));
                                            let _e584 = (_e577 <= select(_e392.member.member_1, _e574, (_e574 < _e392.member.member_1)));
                                            let _e585 = (_e579 <= select(_e392.member.member_1, _e575, (_e575 < _e392.member.member_1)));
                                            let _e586 = (_e577 <= _e579);
                                            if _e584 {
                                                if _e585 {
                                                    if _e586 {
                                                        phi_2147_ = _e483.member_2;
                                                    } else {
                                                        phi_2147_ = _e483.member_1;
                                                    }
                                                    let _e590 = phi_2147_;
                                                    let _e591 = (_e420 % 128u);
                                                    let _e592 = (_e591 < 128u);
                                                    if _e592 {
                                                    } else {
                                                        phi_2510_ = true;
                                                        break;
                                                    }
                                                    local_1[_e591] = _e590;
                                                    if _e592 {
                                                    } else {
                                                        phi_2510_ = true;
                                                        break;
                                                    }
                                                    local[_e591] = select(_e579, _e577, (_e577 > _e579));
                                                    if _e586 {
                                                        phi_2174_ = _e483.member_1;
                                                    } else {
                                                        phi_2174_ = _e483.member_2;
                                                    }
                                                    let _e601 = phi_2174_;
                                                    phi_2175_ = _e601;
                                                    phi_2176_ = (_e420 + 1u);
                                                } else {
                                                    phi_2175_ = u32();
                                                    phi_2176_ = u32();
                                                }
                                                let _e603 = phi_2175_;
                                                let _e605 = phi_2176_;
                                                phi_2178_ = _e603;
                                                phi_2179_ = _e605;
                                                phi_2180_ = select(true, false, _e585);
                                            } else {
                                                phi_2178_ = u32();
                                                phi_2179_ = u32();
                                                phi_2180_ = true;
                                            }
                                            let _e608 = phi_2178_;
                                            let _e610 = phi_2179_;
                                            let _e612 = phi_2180_;
                                            if _e612 {
                                                if _e584 {
                                                    phi_2189_ = _e483.member_1;
                                                } else {
                                                    phi_2189_ = _e483.member_2;
                                                }
                                                let _e616 = phi_2189_;
                                                phi_2194_ = _e616;
                                                phi_2195_ = select(_e585, true, _e584);
                                            } else {
                                                phi_2194_ = _e608;
                                                phi_2195_ = _e418;
                                            }
                                            let _e619 = phi_2194_;
                                            let _e621 = phi_2195_;
                                            phi_2514_ = _e390;
                                            phi_2197_ = type_47(_e392.member, (_e392.member_1 + 1u), _e392.member_2);
                                            phi_2198_ = _e619;
                                            phi_2199_ = _e621;
                                            phi_2200_ = select(_e610, _e420, _e612);
                                        }
                                        let _e1048 = phi_2514_;
                                        let _e1050 = phi_2197_;
                                        let _e1052 = phi_2198_;
                                        let _e1054 = phi_2199_;
                                        let _e1056 = phi_2200_;
                                        phi_2513_ = _e1048;
                                        phi_2201_ = _e1050;
                                        phi_2202_ = _e1052;
                                        phi_2203_ = (_e396 - 1u);
                                        phi_2204_ = _e1054;
                                        phi_2205_ = _e1056;
                                    } else {
                                        phi_2513_ = _e390;
                                        phi_2201_ = _e392;
                                        phi_2202_ = _e416;
                                        phi_2203_ = _e396;
                                        phi_2204_ = _e418;
                                        phi_2205_ = _e420;
                                    }
                                    let _e1058 = phi_2513_;
                                    let _e1060 = phi_2201_;
                                    let _e1062 = phi_2202_;
                                    let _e1064 = phi_2203_;
                                    let _e1066 = phi_2204_;
                                    let _e1068 = phi_2205_;
                                    phi_2512_ = _e1058;
                                    phi_2206_ = _e1060;
                                    phi_2207_ = _e1062;
                                    phi_2208_ = _e1064;
                                    phi_2209_ = _e1066;
                                    phi_2210_ = _e1068;
                                } else {
                                    phi_2512_ = _e390;
                                    phi_2206_ = type_47();
                                    phi_2207_ = u32();
                                    phi_2208_ = u32();
                                    phi_2209_ = bool();
                                    phi_2210_ = u32();
                                }
                                let _e1070 = phi_2512_;
                                let _e1072 = phi_2206_;
                                let _e1074 = phi_2207_;
                                let _e1076 = phi_2208_;
                                let _e1078 = phi_2209_;
                                let _e1080 = phi_2210_;
                                phi_2511_ = _e1070;
                                phi_923_ = _e1072;
                                phi_926_ = _e1074;
                                phi_928_ = _e1076;
                                phi_930_ = _e1078;
                                phi_932_ = _e1080;
                                phi_2211_ = _e404;
                            } else {
                                phi_2511_ = _e390;
                                phi_923_ = type_47();
                                phi_926_ = u32();
                                phi_928_ = u32();
                                phi_930_ = bool();
                                phi_932_ = u32();
                                phi_2211_ = false;
                            }
                            let _e1082 = phi_2511_;
                            let _e1084 = phi_923_;
                            let _e1086 = phi_926_;
                            let _e1088 = phi_928_;
                            let _e1090 = phi_930_;
                            let _e1092 = phi_932_;
                            let _e1094 = phi_2211_;
                            continue;
                            continuing {
                                phi_2406_ = _e1082;
                                phi_922_ = _e1084;
                                phi_925_ = _e1086;
                                phi_927_ = _e1088;
                                phi_929_ = _e1090;
                                phi_931_ = _e1092;
                                phi_2510_ = _e1082;
                                break if !(_e1094);
                            }
                        }
                        let _e1097 = phi_2510_;
                        if _e1097 {
                            break;
                        }
                        let _e1099 = local_2;
                        if (_e1099.member.member.member_3 != 4294967295u) {
                            let _e1105 = (_e205 / 3i);
                            let _e1112 = bitcast<f32>((bitcast<u32>((_e1105 + 127i)) << bitcast<u32>(23i)));
                            let _e1120 = (((_e1099.member.member.member * _e1112) * _e1112) * bitcast<f32>((bitcast<u32>(((_e205 - (2i * _e1105)) + 127i)) << bitcast<u32>(23i))));
                            let _e1122 = select(340282350000000000000000000000000000000f, _e1120, (_e1120 < 340282350000000000000000000000000000000f));
                            phi_2263_ = type_22(select(-340282350000000000000000000000000000000f, _e1122, (_e1122 > -340282350000000000000000000000000000000f)), _e1099.member.member.member_1, _e1099.member.member.member_2, _e1099.member.member.member_3);
                        } else {
                            phi_2263_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1129 = phi_2263_;
                        if _e81 {
                        } else {
                            break;
                        }
                        global_4.member[_e79] = _e1129;
                        let _e1133 = local_3;
                        if _e82 {
                        } else {
                            break;
                        }
                        global_5.member[_e79] = _e1133.member_1;
                        if _e80 {
                        } else {
                            break;
                        }
                        let _e1138 = select(0u, 1u, (_e149 <= _e159));
                        if (_e1138 > 0u) {
                            let _e1140 = (1u < _e75);
                            if _e1140 {
                                if (0u < _e75) {
                                } else {
                                    break;
                                }
                                let _e1144 = atomicAdd((&global_6.member[0u]), _e1138);
                                if ((_e1144 + _e1138) < _e1144) {
                                    if _e1140 {
                                    } else {
                                        break;
                                    }
                                    let _e1149 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1152 = select(0u, 1u, (_e1129.member_3 != 4294967295u));
                        if (_e1152 > 0u) {
                            let _e1154 = (3u < _e75);
                            if _e1154 {
                                if (2u < _e75) {
                                } else {
                                    break;
                                }
                                let _e1158 = atomicAdd((&global_6.member[2u]), _e1152);
                                if ((_e1158 + _e1152) < _e1158) {
                                    if _e1154 {
                                    } else {
                                        break;
                                    }
                                    let _e1163 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1133.member_1 > 0u) {
                            let _e1165 = (5u < _e75);
                            if _e1165 {
                                if (4u < _e75) {
                                } else {
                                    break;
                                }
                                let _e1169 = atomicAdd((&global_6.member[4u]), _e1133.member_1);
                                if ((_e1169 + _e1133.member_1) < _e1169) {
                                    if _e1165 {
                                    } else {
                                        break;
                                    }
                                    let _e1174 = atomicAdd((&global_6.member[5u]), 1u);
                                }
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
fn trace_paths_counted(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
