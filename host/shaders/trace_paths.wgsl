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

struct type_44 {
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
    var local: array<u32, 128>;
    var local_1: array<f32, 128>;
    var phi_273_: i32;
    var phi_274_: i32;
    var phi_284_: bool;
    var phi_294_: u32;
    var phi_295_: u32;
    var phi_297_: bool;
    var phi_302_: u32;
    var phi_346_: f32;
    var phi_352_: f32;
    var phi_363_: f32;
    var phi_369_: f32;
    var phi_392_: f32;
    var phi_403_: f32;
    var phi_412_: f32;
    var phi_418_: f32;
    var phi_429_: f32;
    var phi_435_: f32;
    var phi_458_: f32;
    var phi_469_: f32;
    var phi_478_: f32;
    var phi_484_: f32;
    var phi_495_: f32;
    var phi_501_: f32;
    var phi_524_: f32;
    var phi_535_: f32;
    var phi_635_: f32;
    var phi_636_: f32;
    var phi_2076_: bool;
    var phi_647_: type_44;
    var phi_650_: u32;
    var phi_652_: u32;
    var phi_654_: bool;
    var phi_656_: u32;
    var phi_667_: bool;
    var phi_697_: u32;
    var phi_698_: bool;
    var phi_699_: u32;
    var phi_1519_: type_47;
    var phi_1863_: u32;
    var phi_1889_: u32;
    var phi_1890_: u32;
    var phi_1891_: u32;
    var phi_1893_: u32;
    var phi_1894_: u32;
    var phi_1895_: bool;
    var phi_1904_: u32;
    var phi_1909_: u32;
    var phi_1910_: bool;
    var phi_715_: type_44;
    var phi_718_: type_7;
    var phi_719_: type_7;
    var phi_741_: type_7;
    var phi_761_: u32;
    var phi_849_: array<array<f32, 3>, 3>;
    var phi_1320_: vec3<f32>;
    var phi_1321_: vec3<f32>;
    var phi_1352_: bool;
    var phi_1361_: vec3<f32>;
    var phi_1401_: type_22;
    var phi_1403_: type_22;
    var phi_1404_: bool;
    var phi_1408_: type_22;
    var phi_1409_: type_22;
    var phi_1410_: type_22;
    var phi_1411_: bool;
    var phi_1415_: type_22;
    var phi_1416_: bool;
    var phi_1420_: type_22;
    var phi_1421_: bool;
    var phi_1425_: type_22;
    var phi_1450_: bool;
    var phi_1451_: bool;
    var phi_1457_: type_44;
    var phi_1458_: type_44;
    var phi_1459_: type_44;
    var phi_716_: type_44;
    var phi_2070_: bool;
    var phi_2184_: bool;
    var phi_1912_: type_44;
    var phi_1913_: u32;
    var phi_1914_: bool;
    var phi_1915_: u32;
    var phi_2183_: bool;
    var phi_1916_: type_44;
    var phi_1917_: u32;
    var phi_1918_: u32;
    var phi_1919_: bool;
    var phi_1920_: u32;
    var phi_2182_: bool;
    var phi_1921_: type_44;
    var phi_1922_: u32;
    var phi_1923_: u32;
    var phi_1924_: bool;
    var phi_1925_: u32;
    var phi_2181_: bool;
    var phi_648_: type_44;
    var phi_651_: u32;
    var phi_653_: u32;
    var phi_655_: bool;
    var phi_657_: u32;
    var phi_1926_: bool;
    var phi_2180_: bool;
    var local_2: type_44;
    var phi_1978_: type_22;
    var local_3: type_44;

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
                            phi_273_ = (bitcast<i32>((_e168 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_273_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e168)), 32u, (_e168 == 0u))));
                        }
                        let _e182 = phi_273_;
                        phi_274_ = _e182;
                    } else {
                        phi_274_ = 0i;
                    }
                    let _e184 = phi_274_;
                    let _e185 = (_e94 == _e138);
                    if _e185 {
                        phi_284_ = true;
                    } else {
                        phi_284_ = (_e102 == _e138);
                    }
                    let _e188 = phi_284_;
                    let _e189 = select(1u, 0u, _e185);
                    if _e188 {
                        let _e190 = (_e189 + 1u);
                        phi_294_ = _e190;
                        phi_295_ = _e190;
                        phi_297_ = select(true, false, (_e190 == 2u));
                    } else {
                        phi_294_ = u32();
                        phi_295_ = 0u;
                        phi_297_ = true;
                    }
                    let _e194 = phi_294_;
                    let _e196 = phi_295_;
                    let _e198 = phi_297_;
                    if _e198 {
                        phi_302_ = (_e196 + 1u);
                    } else {
                        phi_302_ = 0u;
                    }
                    let _e202 = phi_302_;
                    let _e203 = select(_e194, _e196, _e198);
                    let _e204 = select(_e189, select(2u, _e189, _e188), _e198);
                    let _e205 = -(_e184);
                    let _e206 = (_e205 / 2i);
                    let _e211 = bitcast<f32>((bitcast<u32>((_e206 + 127i)) << bitcast<u32>(23i)));
                    let _e217 = bitcast<f32>((bitcast<u32>(((_e205 - _e206) + 127i)) << bitcast<u32>(23i)));
                    let _e222 = global_3.member[_e76].member.member;
                    let _e223 = (_e203 == 0u);
                    if _e223 {
                        phi_346_ = _e222[0];
                    } else {
                        phi_346_ = _e222[1];
                    }
                    let _e227 = phi_346_;
                    let _e228 = (_e203 == 2u);
                    if _e228 {
                        phi_352_ = _e222[2];
                    } else {
                        phi_352_ = _e227;
                    }
                    let _e231 = phi_352_;
                    let _e232 = global_3.member[_e76].member.member_2;
                    if _e223 {
                        phi_363_ = _e232[0];
                    } else {
                        phi_363_ = _e232[1];
                    }
                    let _e236 = phi_363_;
                    if _e228 {
                        phi_369_ = _e232[2];
                    } else {
                        phi_369_ = _e236;
                    }
                    let _e239 = phi_369_;
                    let _e241 = ((_e239 * _e211) * _e217);
                    let _e245 = (bitcast<f32>((bitcast<u32>(_e241) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e245 {
                        let _e249 = (bitcast<f32>((bitcast<u32>(_e231) & 2147483647u)) * 0.00000011920929f);
                        phi_392_ = select(0.00000000000011368684f, _e249, (_e249 > 0.00000000000011368684f));
                    } else {
                        phi_392_ = 0f;
                    }
                    let _e253 = phi_392_;
                    let _e254 = (_e231 + _e253);
                    let _e255 = (_e231 - _e253);
                    let _e256 = select(_e241, 0f, _e245);
                    if _e245 {
                        phi_403_ = 38685626000000000000000000f;
                    } else {
                        phi_403_ = (1f / _e241);
                    }
                    let _e259 = phi_403_;
                    let _e260 = (_e202 == 0u);
                    if _e260 {
                        phi_412_ = _e222[0];
                    } else {
                        phi_412_ = _e222[1];
                    }
                    let _e264 = phi_412_;
                    let _e265 = (_e202 == 2u);
                    if _e265 {
                        phi_418_ = _e222[2];
                    } else {
                        phi_418_ = _e264;
                    }
                    let _e268 = phi_418_;
                    if _e260 {
                        phi_429_ = _e232[0];
                    } else {
                        phi_429_ = _e232[1];
                    }
                    let _e272 = phi_429_;
                    if _e265 {
                        phi_435_ = _e232[2];
                    } else {
                        phi_435_ = _e272;
                    }
                    let _e275 = phi_435_;
                    let _e277 = ((_e275 * _e211) * _e217);
                    let _e281 = (bitcast<f32>((bitcast<u32>(_e277) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e281 {
                        let _e285 = (bitcast<f32>((bitcast<u32>(_e268) & 2147483647u)) * 0.00000011920929f);
                        phi_458_ = select(0.00000000000011368684f, _e285, (_e285 > 0.00000000000011368684f));
                    } else {
                        phi_458_ = 0f;
                    }
                    let _e289 = phi_458_;
                    let _e290 = (_e268 + _e289);
                    let _e291 = (_e268 - _e289);
                    let _e292 = select(_e277, 0f, _e281);
                    if _e281 {
                        phi_469_ = 38685626000000000000000000f;
                    } else {
                        phi_469_ = (1f / _e277);
                    }
                    let _e295 = phi_469_;
                    let _e296 = (_e204 == 0u);
                    if _e296 {
                        phi_478_ = _e222[0];
                    } else {
                        phi_478_ = _e222[1];
                    }
                    let _e300 = phi_478_;
                    let _e301 = (_e204 == 2u);
                    if _e301 {
                        phi_484_ = _e222[2];
                    } else {
                        phi_484_ = _e300;
                    }
                    let _e304 = phi_484_;
                    if _e296 {
                        phi_495_ = _e232[0];
                    } else {
                        phi_495_ = _e232[1];
                    }
                    let _e308 = phi_495_;
                    if _e301 {
                        phi_501_ = _e232[2];
                    } else {
                        phi_501_ = _e308;
                    }
                    let _e311 = phi_501_;
                    let _e313 = ((_e311 * _e211) * _e217);
                    let _e317 = (bitcast<f32>((bitcast<u32>(_e313) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e317 {
                        let _e321 = (bitcast<f32>((bitcast<u32>(_e304) & 2147483647u)) * 0.00000011920929f);
                        phi_524_ = select(0.00000000000011368684f, _e321, (_e321 > 0.00000000000011368684f));
                    } else {
                        phi_524_ = 0f;
                    }
                    let _e325 = phi_524_;
                    let _e326 = (_e304 + _e325);
                    let _e327 = (_e304 - _e325);
                    let _e328 = select(_e313, 0f, _e317);
                    if _e317 {
                        phi_535_ = 38685626000000000000000000f;
                    } else {
                        phi_535_ = (1f / _e313);
                    }
                    let _e331 = phi_535_;
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
                        phi_635_ = select(-340282350000000000000000000000000000000f, _e371, (_e371 > -340282350000000000000000000000000000000f));
                        phi_636_ = select(-340282350000000000000000000000000000000f, _e364, (_e364 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_635_ = 0f;
                        phi_636_ = 1f;
                    }
                    let _e375 = phi_635_;
                    let _e377 = phi_636_;
                    local = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2076_ = false;
                    phi_647_ = type_44(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e375);
                    phi_650_ = select(0u, 2147483648u, (_e64 == 0u));
                    phi_652_ = ((3u * _e64) + 1u);
                    phi_654_ = (_e377 <= _e375);
                    phi_656_ = 0u;
                    loop {
                        let _e385 = phi_2076_;
                        let _e387 = phi_647_;
                        let _e389 = phi_650_;
                        let _e391 = phi_652_;
                        let _e393 = phi_654_;
                        let _e395 = phi_656_;
                        local_2 = _e387;
                        if _e393 {
                            phi_667_ = true;
                        } else {
                            phi_667_ = (_e395 > 0u);
                        }
                        let _e398 = phi_667_;
                        if _e398 {
                            let _e399 = (_e391 > 0u);
                            if _e399 {
                                if _e393 {
                                    phi_697_ = _e389;
                                    phi_698_ = _e393;
                                    phi_699_ = _e395;
                                } else {
                                    let _e400 = (_e395 - 1u);
                                    let _e401 = (_e400 % 128u);
                                    let _e402 = (_e401 < 128u);
                                    if _e402 {
                                    } else {
                                        phi_2180_ = true;
                                        break;
                                    }
                                    let _e404 = local[_e401];
                                    if _e402 {
                                    } else {
                                        phi_2180_ = true;
                                        break;
                                    }
                                    let _e406 = local_1[_e401];
                                    phi_697_ = _e404;
                                    phi_698_ = (_e406 <= _e387.member_1);
                                    phi_699_ = _e400;
                                }
                                let _e410 = phi_697_;
                                let _e412 = phi_698_;
                                let _e414 = phi_699_;
                                if _e412 {
                                    let _e418 = (_e410 & 268435455u);
                                    if ((_e410 & 2147483648u) != 0u) {
                                        phi_715_ = _e387;
                                        phi_718_ = type_7(_e418, (_e418 + ((_e410 >> bitcast<u32>(28u)) & 7u)));
                                        loop {
                                            let _e613 = phi_715_;
                                            let _e615 = phi_718_;
                                            local_3 = _e613;
                                            if (_e615.member < _e615.member_1) {
                                                phi_719_ = type_7((_e615.member + 1u), _e615.member_1);
                                                phi_741_ = type_7(1u, _e615.member);
                                            } else {
                                                phi_719_ = _e615;
                                                phi_741_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e628 = phi_719_;
                                            let _e630 = phi_741_;
                                            let _e634 = (bitcast<i32>(_e630.member) != 0i);
                                            if _e634 {
                                                let _e635 = (_e630.member_1 < _e66);
                                                if _e635 {
                                                    if _e635 {
                                                    } else {
                                                        phi_2070_ = true;
                                                        break;
                                                    }
                                                    let _e639 = global_1.member[_e630.member_1].member_1;
                                                    phi_761_ = _e639;
                                                } else {
                                                    phi_761_ = 4294967295u;
                                                }
                                                let _e641 = phi_761_;
                                                if (_e630.member_1 >= _e66) {
                                                    phi_849_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e635 {
                                                    } else {
                                                        phi_2070_ = true;
                                                        break;
                                                    }
                                                    let _e643 = (_e203 % 3u);
                                                    let _e644 = (_e202 % 3u);
                                                    let _e645 = (_e204 % 3u);
                                                    if (_e643 < 9u) {
                                                    } else {
                                                        phi_2070_ = true;
                                                        break;
                                                    }
                                                    let _e651 = global_1.member[_e630.member_1].member[_e643];
                                                    if (_e644 < 9u) {
                                                    } else {
                                                        phi_2070_ = true;
                                                        break;
                                                    }
                                                    let _e657 = global_1.member[_e630.member_1].member[_e644];
                                                    if (_e645 < 9u) {
                                                    } else {
                                                        phi_2070_ = true;
                                                        break;
                                                    }
                                                    let _e663 = global_1.member[_e630.member_1].member[_e645];
                                                    let _e665 = (3u + _e643);
                                                    if (_e665 < 9u) {
                                                    } else {
                                                        phi_2070_ = true;
                                                        break;
                                                    }
                                                    let _e671 = global_1.member[_e630.member_1].member[_e665];
                                                    let _e672 = (3u + _e644);
                                                    if (_e672 < 9u) {
                                                    } else {
                                                        phi_2070_ = true;
                                                        break;
                                                    }
                                                    let _e678 = global_1.member[_e630.member_1].member[_e672];
                                                    let _e679 = (3u + _e645);
                                                    if (_e679 < 9u) {
                                                    } else {
                                                        phi_2070_ = true;
                                                        break;
                                                    }
                                                    let _e685 = global_1.member[_e630.member_1].member[_e679];
                                                    let _e687 = (6u + _e643);
                                                    if (_e687 < 9u) {
                                                    } else {
                                                        phi_2070_ = true;
                                                        break;
                                                    }
                                                    let _e693 = global_1.member[_e630.member_1].member[_e687];
                                                    let _e694 = (6u + _e644);
                                                    if (_e694 < 9u) {
                                                    } else {
                                                        phi_2070_ = true;
                                                        break;
                                                    }
                                                    let _e700 = global_1.member[_e630.member_1].member[_e694];
                                                    let _e701 = (6u + _e645);
                                                    if (_e701 < 9u) {
                                                    } else {
                                                        phi_2070_ = true;
                                                        break;
                                                    }
                                                    let _e707 = global_1.member[_e630.member_1].member[_e701];
                                                    phi_849_ = array<array<f32, 3>, 3>(array<f32, 3>(_e651, _e657, _e663), array<f32, 3>(_e671, _e678, _e685), array<f32, 3>(_e693, _e700, _e707));
                                                }
                                                let _e711 = phi_849_;
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
                                                        phi_1415_ = type_22();
                                                        phi_1416_ = true;
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
                                                            phi_1410_ = type_22();
                                                            phi_1411_ = true;
                                                        } else {
                                                            let _e849 = (_e847 > _e613.member_1);
                                                            if _e849 {
                                                                phi_1409_ = type_22();
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
                                                                    phi_1320_ = _e860;
                                                                    phi_1321_ = _e864;
                                                                } else {
                                                                    let _e910 = vec3((_e890 == _e907));
                                                                    phi_1320_ = select(_e856, _e864, _e910);
                                                                    phi_1321_ = select(_e860, _e856, _e910);
                                                                }
                                                                let _e914 = phi_1320_;
                                                                let _e916 = phi_1321_;
                                                                let _e923 = ((_e914.y * _e916.z) - (_e916.y * _e914.z));
                                                                let _e928 = ((_e914.z * _e916.x) - (_e916.z * _e914.x));
                                                                let _e931 = ((_e914.x * _e916.y) - (_e916.x * _e914.y));
                                                                if (_e773 >= _e777) {
                                                                    phi_1352_ = select(true, false, (_e773 >= _e781));
                                                                } else {
                                                                    phi_1352_ = true;
                                                                }
                                                                let _e936 = phi_1352_;
                                                                if _e936 {
                                                                    phi_1361_ = select(vec3<f32>(_e711[2][0], _e711[2][1], _e711[2][2]), vec3<f32>(_e711[1][0], _e711[1][1], _e711[1][2]), vec3((_e777 >= _e781)));
                                                                } else {
                                                                    phi_1361_ = vec3<f32>(_e711[0][0], _e711[0][1], _e711[0][2]);
                                                                }
                                                                let _e941 = phi_1361_;
                                                                let _e958 = ((((_e923 * (_e941.x - _e231)) + (_e928 * (_e941.y - _e268))) + (_e931 * (_e941.z - _e304))) / (((_e923 * _e256) + (_e928 * _e292)) + (_e931 * _e328)));
                                                                let _e960 = select(_e840, _e958, (_e958 < _e840));
                                                                let _e962 = select(_e832, _e960, (_e960 > _e832));
                                                                if (_e962 >= _e377) {
                                                                    let _e964 = (_e962 <= _e613.member_1);
                                                                    if _e964 {
                                                                        let _e965 = (1f / _e783);
                                                                        phi_1401_ = type_22(_e962, (_e777 * _e965), (_e781 * _e965), _e641);
                                                                    } else {
                                                                        phi_1401_ = type_22();
                                                                    }
                                                                    let _e970 = phi_1401_;
                                                                    phi_1403_ = _e970;
                                                                    phi_1404_ = select(true, false, _e964);
                                                                } else {
                                                                    phi_1403_ = type_22();
                                                                    phi_1404_ = true;
                                                                }
                                                                let _e973 = phi_1403_;
                                                                let _e975 = phi_1404_;
                                                                if _e975 {
                                                                    phi_1408_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1408_ = _e973;
                                                                }
                                                                let _e977 = phi_1408_;
                                                                phi_1409_ = _e977;
                                                            }
                                                            let _e979 = phi_1409_;
                                                            phi_1410_ = _e979;
                                                            phi_1411_ = _e849;
                                                        }
                                                        let _e981 = phi_1410_;
                                                        let _e983 = phi_1411_;
                                                        phi_1415_ = _e981;
                                                        phi_1416_ = _e983;
                                                    }
                                                    let _e985 = phi_1415_;
                                                    let _e987 = phi_1416_;
                                                    phi_1420_ = _e985;
                                                    phi_1421_ = _e987;
                                                } else {
                                                    phi_1420_ = type_22();
                                                    phi_1421_ = true;
                                                }
                                                let _e989 = phi_1420_;
                                                let _e991 = phi_1421_;
                                                if _e991 {
                                                    phi_1425_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1425_ = _e989;
                                                }
                                                let _e993 = phi_1425_;
                                                if (_e993.member_3 != 4294967295u) {
                                                    if (_e641 != _e82) {
                                                        if (_e993.member < _e613.member.member) {
                                                            phi_1451_ = true;
                                                        } else {
                                                            if (_e993.member == _e613.member.member) {
                                                                phi_1450_ = (_e993.member_3 < _e613.member.member_3);
                                                            } else {
                                                                phi_1450_ = false;
                                                            }
                                                            let _e1006 = phi_1450_;
                                                            phi_1451_ = _e1006;
                                                        }
                                                        let _e1008 = phi_1451_;
                                                        if _e1008 {
                                                            phi_1457_ = type_44(_e993, _e993.member);
                                                        } else {
                                                            phi_1457_ = _e613;
                                                        }
                                                        let _e1011 = phi_1457_;
                                                        phi_1458_ = _e1011;
                                                    } else {
                                                        phi_1458_ = _e613;
                                                    }
                                                    let _e1013 = phi_1458_;
                                                    phi_1459_ = _e1013;
                                                } else {
                                                    phi_1459_ = _e613;
                                                }
                                                let _e1015 = phi_1459_;
                                                phi_716_ = _e1015;
                                            } else {
                                                phi_716_ = type_44();
                                            }
                                            let _e1017 = phi_716_;
                                            continue;
                                            continuing {
                                                phi_715_ = _e1017;
                                                phi_718_ = _e628;
                                                phi_2070_ = _e385;
                                                break if !(_e634);
                                            }
                                        }
                                        let _e1020 = phi_2070_;
                                        phi_2180_ = _e1020;
                                        if _e1020 {
                                            break;
                                        }
                                        phi_2184_ = _e1020;
                                        let _e1212 = local_3;
                                        phi_1912_ = _e1212;
                                        phi_1913_ = _e410;
                                        phi_1914_ = false;
                                        phi_1915_ = _e414;
                                    } else {
                                        if (_e410 >= _e64) {
                                            phi_1519_ = type_47(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e410 < _e64) {
                                            } else {
                                                phi_2180_ = true;
                                                break;
                                            }
                                            let _e424 = (_e203 % 3u);
                                            if (_e424 < 3u) {
                                            } else {
                                                phi_2180_ = true;
                                                break;
                                            }
                                            let _e430 = global_2.member[_e410].member[_e424];
                                            let _e436 = (_e202 % 3u);
                                            if (_e436 < 3u) {
                                            } else {
                                                phi_2180_ = true;
                                                break;
                                            }
                                            let _e442 = global_2.member[_e410].member[_e436];
                                            let _e448 = (_e204 % 3u);
                                            if (_e448 < 3u) {
                                            } else {
                                                phi_2180_ = true;
                                                break;
                                            }
                                            let _e454 = global_2.member[_e410].member[_e448];
                                            let _e464 = global_2.member[_e410].member_1;
                                            let _e468 = global_2.member[_e410].member_2;
                                            phi_1519_ = type_47(array<vec4<f32>, 3>(vec4<f32>(_e430[0], _e430[1], _e430[2], _e430[3]), vec4<f32>(_e442[0], _e442[1], _e442[2], _e442[3]), vec4<f32>(_e454[0], _e454[1], _e454[2], _e454[3])), _e464, _e468);
                                        }
                                        let _e471 = phi_1519_;
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
                                                    phi_1863_ = _e471.member_2;
                                                } else {
                                                    phi_1863_ = _e471.member_1;
                                                }
                                                let _e577 = phi_1863_;
                                                let _e578 = (_e414 % 128u);
                                                let _e579 = (_e578 < 128u);
                                                if _e579 {
                                                } else {
                                                    phi_2180_ = true;
                                                    break;
                                                }
                                                local[_e578] = _e577;
                                                if _e579 {
                                                } else {
                                                    phi_2180_ = true;
                                                    break;
                                                }
                                                local_1[_e578] = select(_e566, _e564, (_e564 > _e566));
                                                if _e573 {
                                                    phi_1889_ = _e471.member_1;
                                                } else {
                                                    phi_1889_ = _e471.member_2;
                                                }
                                                let _e588 = phi_1889_;
                                                phi_1890_ = _e588;
                                                phi_1891_ = (_e414 + 1u);
                                            } else {
                                                phi_1890_ = u32();
                                                phi_1891_ = u32();
                                            }
                                            let _e590 = phi_1890_;
                                            let _e592 = phi_1891_;
                                            phi_1893_ = _e590;
                                            phi_1894_ = _e592;
                                            phi_1895_ = select(true, false, _e572);
                                        } else {
                                            phi_1893_ = u32();
                                            phi_1894_ = u32();
                                            phi_1895_ = true;
                                        }
                                        let _e595 = phi_1893_;
                                        let _e597 = phi_1894_;
                                        let _e599 = phi_1895_;
                                        if _e599 {
                                            if _e571 {
                                                phi_1904_ = _e471.member_1;
                                            } else {
                                                phi_1904_ = _e471.member_2;
                                            }
                                            let _e603 = phi_1904_;
                                            phi_1909_ = _e603;
                                            phi_1910_ = select(_e572, true, _e571);
                                        } else {
                                            phi_1909_ = _e595;
                                            phi_1910_ = _e412;
                                        }
                                        let _e606 = phi_1909_;
                                        let _e608 = phi_1910_;
                                        phi_2184_ = _e385;
                                        phi_1912_ = _e387;
                                        phi_1913_ = _e606;
                                        phi_1914_ = _e608;
                                        phi_1915_ = select(_e597, _e414, _e599);
                                    }
                                    let _e1022 = phi_2184_;
                                    let _e1024 = phi_1912_;
                                    let _e1026 = phi_1913_;
                                    let _e1028 = phi_1914_;
                                    let _e1030 = phi_1915_;
                                    phi_2183_ = _e1022;
                                    phi_1916_ = _e1024;
                                    phi_1917_ = _e1026;
                                    phi_1918_ = (_e391 - 1u);
                                    phi_1919_ = _e1028;
                                    phi_1920_ = _e1030;
                                } else {
                                    phi_2183_ = _e385;
                                    phi_1916_ = _e387;
                                    phi_1917_ = _e410;
                                    phi_1918_ = _e391;
                                    phi_1919_ = _e412;
                                    phi_1920_ = _e414;
                                }
                                let _e1032 = phi_2183_;
                                let _e1034 = phi_1916_;
                                let _e1036 = phi_1917_;
                                let _e1038 = phi_1918_;
                                let _e1040 = phi_1919_;
                                let _e1042 = phi_1920_;
                                phi_2182_ = _e1032;
                                phi_1921_ = _e1034;
                                phi_1922_ = _e1036;
                                phi_1923_ = _e1038;
                                phi_1924_ = _e1040;
                                phi_1925_ = _e1042;
                            } else {
                                phi_2182_ = _e385;
                                phi_1921_ = type_44();
                                phi_1922_ = u32();
                                phi_1923_ = u32();
                                phi_1924_ = bool();
                                phi_1925_ = u32();
                            }
                            let _e1044 = phi_2182_;
                            let _e1046 = phi_1921_;
                            let _e1048 = phi_1922_;
                            let _e1050 = phi_1923_;
                            let _e1052 = phi_1924_;
                            let _e1054 = phi_1925_;
                            phi_2181_ = _e1044;
                            phi_648_ = _e1046;
                            phi_651_ = _e1048;
                            phi_653_ = _e1050;
                            phi_655_ = _e1052;
                            phi_657_ = _e1054;
                            phi_1926_ = _e399;
                        } else {
                            phi_2181_ = _e385;
                            phi_648_ = type_44();
                            phi_651_ = u32();
                            phi_653_ = u32();
                            phi_655_ = bool();
                            phi_657_ = u32();
                            phi_1926_ = false;
                        }
                        let _e1056 = phi_2181_;
                        let _e1058 = phi_648_;
                        let _e1060 = phi_651_;
                        let _e1062 = phi_653_;
                        let _e1064 = phi_655_;
                        let _e1066 = phi_657_;
                        let _e1068 = phi_1926_;
                        continue;
                        continuing {
                            phi_2076_ = _e1056;
                            phi_647_ = _e1058;
                            phi_650_ = _e1060;
                            phi_652_ = _e1062;
                            phi_654_ = _e1064;
                            phi_656_ = _e1066;
                            phi_2180_ = _e1056;
                            break if !(_e1068);
                        }
                    }
                    let _e1071 = phi_2180_;
                    if _e1071 {
                        break;
                    }
                    let _e1073 = local_2;
                    if (_e1073.member.member_3 != 4294967295u) {
                        let _e1078 = (_e205 / 3i);
                        let _e1085 = bitcast<f32>((bitcast<u32>((_e1078 + 127i)) << bitcast<u32>(23i)));
                        let _e1093 = (((_e1073.member.member * _e1085) * _e1085) * bitcast<f32>((bitcast<u32>(((_e205 - (2i * _e1078)) + 127i)) << bitcast<u32>(23i))));
                        let _e1095 = select(340282350000000000000000000000000000000f, _e1093, (_e1093 < 340282350000000000000000000000000000000f));
                        phi_1978_ = type_22(select(-340282350000000000000000000000000000000f, _e1095, (_e1095 > -340282350000000000000000000000000000000f)), _e1073.member.member_1, _e1073.member.member_2, _e1073.member.member_3);
                    } else {
                        phi_1978_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1102 = phi_1978_;
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
