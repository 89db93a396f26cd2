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

struct type_48 {
    member: type_44,
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
    var phi_2130_: bool;
    var phi_656_: type_48;
    var phi_659_: u32;
    var phi_661_: u32;
    var phi_663_: bool;
    var phi_665_: u32;
    var phi_676_: bool;
    var phi_706_: u32;
    var phi_707_: bool;
    var phi_708_: u32;
    var phi_1535_: type_47;
    var phi_1879_: u32;
    var phi_1905_: u32;
    var phi_1906_: u32;
    var phi_1907_: u32;
    var phi_1909_: u32;
    var phi_1910_: u32;
    var phi_1911_: bool;
    var phi_1920_: u32;
    var phi_1925_: u32;
    var phi_1926_: bool;
    var phi_724_: type_48;
    var phi_727_: type_7;
    var phi_728_: type_7;
    var phi_750_: type_7;
    var phi_773_: u32;
    var phi_861_: array<array<f32, 3>, 3>;
    var phi_1332_: vec3<f32>;
    var phi_1333_: vec3<f32>;
    var phi_1364_: bool;
    var phi_1373_: vec3<f32>;
    var phi_1413_: type_22;
    var phi_1415_: type_22;
    var phi_1416_: bool;
    var phi_1420_: type_22;
    var phi_1421_: type_22;
    var phi_1422_: type_22;
    var phi_1423_: bool;
    var phi_1427_: type_22;
    var phi_1428_: bool;
    var phi_1432_: type_22;
    var phi_1433_: bool;
    var phi_1437_: type_22;
    var phi_1462_: bool;
    var phi_1463_: bool;
    var phi_1470_: type_48;
    var phi_1471_: type_48;
    var phi_1472_: type_48;
    var phi_725_: type_48;
    var phi_2124_: bool;
    var phi_2238_: bool;
    var phi_1928_: type_48;
    var phi_1929_: u32;
    var phi_1930_: bool;
    var phi_1931_: u32;
    var phi_2237_: bool;
    var phi_1932_: type_48;
    var phi_1933_: u32;
    var phi_1934_: u32;
    var phi_1935_: bool;
    var phi_1936_: u32;
    var phi_2236_: bool;
    var phi_1937_: type_48;
    var phi_1938_: u32;
    var phi_1939_: u32;
    var phi_1940_: bool;
    var phi_1941_: u32;
    var phi_2235_: bool;
    var phi_657_: type_48;
    var phi_660_: u32;
    var phi_662_: u32;
    var phi_664_: bool;
    var phi_666_: u32;
    var phi_1942_: bool;
    var phi_2234_: bool;
    var local_2: type_48;
    var phi_1994_: type_22;
    var local_3: type_48;
    var local_4: type_48;

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
                        let _e222 = global_3.member[_e79].member.member;
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
                        let _e232 = global_3.member[_e79].member.member_2;
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
                        if _e80 {
                        } else {
                            break;
                        }
                        let _e383 = global_3.member[_e79].member_2;
                        local = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        phi_2130_ = false;
                        phi_656_ = type_48(type_44(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e375), 0u, 0u);
                        phi_659_ = select(0u, 2147483648u, (_e65 == 0u));
                        phi_661_ = ((3u * _e65) + 1u);
                        phi_663_ = (_e377 <= _e375);
                        phi_665_ = 0u;
                        loop {
                            let _e390 = phi_2130_;
                            let _e392 = phi_656_;
                            let _e394 = phi_659_;
                            let _e396 = phi_661_;
                            let _e398 = phi_663_;
                            let _e400 = phi_665_;
                            local_2 = _e392;
                            local_3 = _e392;
                            if _e398 {
                                phi_676_ = true;
                            } else {
                                phi_676_ = (_e400 > 0u);
                            }
                            let _e403 = phi_676_;
                            if _e403 {
                                let _e404 = (_e396 > 0u);
                                if _e404 {
                                    if _e398 {
                                        phi_706_ = _e394;
                                        phi_707_ = _e398;
                                        phi_708_ = _e400;
                                    } else {
                                        let _e405 = (_e400 - 1u);
                                        let _e406 = (_e405 % 128u);
                                        let _e407 = (_e406 < 128u);
                                        if _e407 {
                                        } else {
                                            phi_2234_ = true;
                                            break;
                                        }
                                        let _e409 = local[_e406];
                                        if _e407 {
                                        } else {
                                            phi_2234_ = true;
                                            break;
                                        }
                                        let _e411 = local_1[_e406];
                                        phi_706_ = _e409;
                                        phi_707_ = (_e411 <= _e392.member.member_1);
                                        phi_708_ = _e405;
                                    }
                                    let _e416 = phi_706_;
                                    let _e418 = phi_707_;
                                    let _e420 = phi_708_;
                                    if _e418 {
                                        let _e424 = (_e416 & 268435455u);
                                        if ((_e416 & 2147483648u) != 0u) {
                                            phi_724_ = _e392;
                                            phi_727_ = type_7(_e424, (_e424 + ((_e416 >> bitcast<u32>(28u)) & 7u)));
                                            loop {
                                                let _e626 = phi_724_;
                                                let _e628 = phi_727_;
                                                local_4 = _e626;
                                                if (_e628.member < _e628.member_1) {
                                                    phi_728_ = type_7((_e628.member + 1u), _e628.member_1);
                                                    phi_750_ = type_7(1u, _e628.member);
                                                } else {
                                                    phi_728_ = _e628;
                                                    phi_750_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e641 = phi_728_;
                                                let _e643 = phi_750_;
                                                let _e647 = (bitcast<i32>(_e643.member) != 0i);
                                                if _e647 {
                                                    let _e653 = type_48(_e626.member, _e626.member_1, (_e626.member_2 + 1u));
                                                    let _e654 = (_e643.member_1 < _e67);
                                                    if _e654 {
                                                        if _e654 {
                                                        } else {
                                                            phi_2124_ = true;
                                                            break;
                                                        }
                                                        let _e658 = global_1.member[_e643.member_1].member_1;
                                                        phi_773_ = _e658;
                                                    } else {
                                                        phi_773_ = 4294967295u;
                                                    }
                                                    let _e660 = phi_773_;
                                                    if (_e643.member_1 >= _e67) {
                                                        phi_861_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e654 {
                                                        } else {
                                                            phi_2124_ = true;
                                                            break;
                                                        }
                                                        let _e662 = (_e203 % 3u);
                                                        let _e663 = (_e202 % 3u);
                                                        let _e664 = (_e204 % 3u);
                                                        if (_e662 < 9u) {
                                                        } else {
                                                            phi_2124_ = true;
                                                            break;
                                                        }
                                                        let _e670 = global_1.member[_e643.member_1].member[_e662];
                                                        if (_e663 < 9u) {
                                                        } else {
                                                            phi_2124_ = true;
                                                            break;
                                                        }
                                                        let _e676 = global_1.member[_e643.member_1].member[_e663];
                                                        if (_e664 < 9u) {
                                                        } else {
                                                            phi_2124_ = true;
                                                            break;
                                                        }
                                                        let _e682 = global_1.member[_e643.member_1].member[_e664];
                                                        let _e684 = (3u + _e662);
                                                        if (_e684 < 9u) {
                                                        } else {
                                                            phi_2124_ = true;
                                                            break;
                                                        }
                                                        let _e690 = global_1.member[_e643.member_1].member[_e684];
                                                        let _e691 = (3u + _e663);
                                                        if (_e691 < 9u) {
                                                        } else {
                                                            phi_2124_ = true;
                                                            break;
                                                        }
                                                        let _e697 = global_1.member[_e643.member_1].member[_e691];
                                                        let _e698 = (3u + _e664);
                                                        if (_e698 < 9u) {
                                                        } else {
                                                            phi_2124_ = true;
                                                            break;
                                                        }
                                                        let _e704 = global_1.member[_e643.member_1].member[_e698];
                                                        let _e706 = (6u + _e662);
                                                        if (_e706 < 9u) {
                                                        } else {
                                                            phi_2124_ = true;
                                                            break;
                                                        }
                                                        let _e712 = global_1.member[_e643.member_1].member[_e706];
                                                        let _e713 = (6u + _e663);
                                                        if (_e713 < 9u) {
                                                        } else {
                                                            phi_2124_ = true;
                                                            break;
                                                        }
                                                        let _e719 = global_1.member[_e643.member_1].member[_e713];
                                                        let _e720 = (6u + _e664);
                                                        if (_e720 < 9u) {
                                                        } else {
                                                            phi_2124_ = true;
                                                            break;
                                                        }
                                                        let _e726 = global_1.member[_e643.member_1].member[_e720];
                                                        phi_861_ = array<array<f32, 3>, 3>(array<f32, 3>(_e670, _e676, _e682), array<f32, 3>(_e690, _e697, _e704), array<f32, 3>(_e712, _e719, _e726));
                                                    }
                                                    let _e730 = phi_861_;
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
                                                            phi_1427_ = type_22();
                                                            phi_1428_ = true;
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
                                                                phi_1422_ = type_22();
                                                                phi_1423_ = true;
                                                            } else {
                                                                let _e869 = (_e867 > _e626.member.member_1);
                                                                if _e869 {
                                                                    phi_1421_ = type_22();
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
                                                                        phi_1332_ = _e880;
                                                                        phi_1333_ = _e884;
                                                                    } else {
                                                                        let _e930 = vec3((_e910 == _e927));
                                                                        phi_1332_ = select(_e876, _e884, _e930);
                                                                        phi_1333_ = select(_e880, _e876, _e930);
                                                                    }
                                                                    let _e934 = phi_1332_;
                                                                    let _e936 = phi_1333_;
                                                                    let _e943 = ((_e934.y * _e936.z) - (_e936.y * _e934.z));
                                                                    let _e948 = ((_e934.z * _e936.x) - (_e936.z * _e934.x));
                                                                    let _e951 = ((_e934.x * _e936.y) - (_e936.x * _e934.y));
                                                                    if (_e793 >= _e797) {
                                                                        phi_1364_ = select(true, false, (_e793 >= _e801));
                                                                    } else {
                                                                        phi_1364_ = true;
                                                                    }
                                                                    let _e956 = phi_1364_;
                                                                    if _e956 {
                                                                        phi_1373_ = select(vec3<f32>(_e730[2][0], _e730[2][1], _e730[2][2]), vec3<f32>(_e730[1][0], _e730[1][1], _e730[1][2]), vec3((_e797 >= _e801)));
                                                                    } else {
                                                                        phi_1373_ = vec3<f32>(_e730[0][0], _e730[0][1], _e730[0][2]);
                                                                    }
                                                                    let _e961 = phi_1373_;
                                                                    let _e978 = ((((_e943 * (_e961.x - _e231)) + (_e948 * (_e961.y - _e268))) + (_e951 * (_e961.z - _e304))) / (((_e943 * _e256) + (_e948 * _e292)) + (_e951 * _e328)));
                                                                    let _e980 = select(_e860, _e978, (_e978 < _e860));
                                                                    let _e982 = select(_e852, _e980, (_e980 > _e852));
                                                                    if (_e982 >= _e377) {
                                                                        let _e984 = (_e982 <= _e626.member.member_1);
                                                                        if _e984 {
                                                                            let _e985 = (1f / _e803);
                                                                            phi_1413_ = type_22(_e982, (_e797 * _e985), (_e801 * _e985), _e660);
                                                                        } else {
                                                                            phi_1413_ = type_22();
                                                                        }
                                                                        let _e990 = phi_1413_;
                                                                        phi_1415_ = _e990;
                                                                        phi_1416_ = select(true, false, _e984);
                                                                    } else {
                                                                        phi_1415_ = type_22();
                                                                        phi_1416_ = true;
                                                                    }
                                                                    let _e993 = phi_1415_;
                                                                    let _e995 = phi_1416_;
                                                                    if _e995 {
                                                                        phi_1420_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_1420_ = _e993;
                                                                    }
                                                                    let _e997 = phi_1420_;
                                                                    phi_1421_ = _e997;
                                                                }
                                                                let _e999 = phi_1421_;
                                                                phi_1422_ = _e999;
                                                                phi_1423_ = _e869;
                                                            }
                                                            let _e1001 = phi_1422_;
                                                            let _e1003 = phi_1423_;
                                                            phi_1427_ = _e1001;
                                                            phi_1428_ = _e1003;
                                                        }
                                                        let _e1005 = phi_1427_;
                                                        let _e1007 = phi_1428_;
                                                        phi_1432_ = _e1005;
                                                        phi_1433_ = _e1007;
                                                    } else {
                                                        phi_1432_ = type_22();
                                                        phi_1433_ = true;
                                                    }
                                                    let _e1009 = phi_1432_;
                                                    let _e1011 = phi_1433_;
                                                    if _e1011 {
                                                        phi_1437_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1437_ = _e1009;
                                                    }
                                                    let _e1013 = phi_1437_;
                                                    if (_e1013.member_3 != 4294967295u) {
                                                        if (_e660 != _e383) {
                                                            if (_e1013.member < _e626.member.member.member) {
                                                                phi_1463_ = true;
                                                            } else {
                                                                if (_e1013.member == _e626.member.member.member) {
                                                                    phi_1462_ = (_e1013.member_3 < _e626.member.member.member_3);
                                                                } else {
                                                                    phi_1462_ = false;
                                                                }
                                                                let _e1028 = phi_1462_;
                                                                phi_1463_ = _e1028;
                                                            }
                                                            let _e1030 = phi_1463_;
                                                            if _e1030 {
                                                                phi_1470_ = type_48(type_44(_e1013, _e1013.member), _e653.member_1, _e653.member_2);
                                                            } else {
                                                                phi_1470_ = _e653;
                                                            }
                                                            let _e1037 = phi_1470_;
                                                            phi_1471_ = _e1037;
                                                        } else {
                                                            phi_1471_ = _e653;
                                                        }
                                                        let _e1039 = phi_1471_;
                                                        phi_1472_ = _e1039;
                                                    } else {
                                                        phi_1472_ = _e653;
                                                    }
                                                    let _e1041 = phi_1472_;
                                                    phi_725_ = _e1041;
                                                } else {
                                                    phi_725_ = type_48();
                                                }
                                                let _e1043 = phi_725_;
                                                continue;
                                                continuing {
                                                    phi_724_ = _e1043;
                                                    phi_727_ = _e641;
                                                    phi_2124_ = _e390;
                                                    break if !(_e647);
                                                }
                                            }
                                            let _e1046 = phi_2124_;
                                            phi_2234_ = _e1046;
                                            if _e1046 {
                                                break;
                                            }
                                            phi_2238_ = _e1046;
                                            let _e1255 = local_4;
                                            phi_1928_ = _e1255;
                                            phi_1929_ = _e416;
                                            phi_1930_ = false;
                                            phi_1931_ = _e420;
                                        } else {
                                            if (_e416 >= _e65) {
                                                phi_1535_ = type_47(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                            } else {
                                                if (_e416 < _e65) {
                                                } else {
                                                    phi_2234_ = true;
                                                    break;
                                                }
                                                let _e436 = (_e203 % 3u);
                                                if (_e436 < 3u) {
                                                } else {
                                                    phi_2234_ = true;
                                                    break;
                                                }
                                                let _e442 = global_2.member[_e416].member[_e436];
                                                let _e448 = (_e202 % 3u);
                                                if (_e448 < 3u) {
                                                } else {
                                                    phi_2234_ = true;
                                                    break;
                                                }
                                                let _e454 = global_2.member[_e416].member[_e448];
                                                let _e460 = (_e204 % 3u);
                                                if (_e460 < 3u) {
                                                } else {
                                                    phi_2234_ = true;
                                                    break;
                                                }
                                                let _e466 = global_2.member[_e416].member[_e460];
                                                let _e476 = global_2.member[_e416].member_1;
                                                let _e480 = global_2.member[_e416].member_2;
                                                phi_1535_ = type_47(array<vec4<f32>, 3>(vec4<f32>(_e442[0], _e442[1], _e442[2], _e442[3]), vec4<f32>(_e454[0], _e454[1], _e454[2], _e454[3]), vec4<f32>(_e466[0], _e466[1], _e466[2], _e466[3])), _e476, _e480);
                                            }
                                            let _e483 = phi_1535_;
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
                                                        phi_1879_ = _e483.member_2;
                                                    } else {
                                                        phi_1879_ = _e483.member_1;
                                                    }
                                                    let _e590 = phi_1879_;
                                                    let _e591 = (_e420 % 128u);
                                                    let _e592 = (_e591 < 128u);
                                                    if _e592 {
                                                    } else {
                                                        phi_2234_ = true;
                                                        break;
                                                    }
                                                    local[_e591] = _e590;
                                                    if _e592 {
                                                    } else {
                                                        phi_2234_ = true;
                                                        break;
                                                    }
                                                    local_1[_e591] = select(_e579, _e577, (_e577 > _e579));
                                                    if _e586 {
                                                        phi_1905_ = _e483.member_1;
                                                    } else {
                                                        phi_1905_ = _e483.member_2;
                                                    }
                                                    let _e601 = phi_1905_;
                                                    phi_1906_ = _e601;
                                                    phi_1907_ = (_e420 + 1u);
                                                } else {
                                                    phi_1906_ = u32();
                                                    phi_1907_ = u32();
                                                }
                                                let _e603 = phi_1906_;
                                                let _e605 = phi_1907_;
                                                phi_1909_ = _e603;
                                                phi_1910_ = _e605;
                                                phi_1911_ = select(true, false, _e585);
                                            } else {
                                                phi_1909_ = u32();
                                                phi_1910_ = u32();
                                                phi_1911_ = true;
                                            }
                                            let _e608 = phi_1909_;
                                            let _e610 = phi_1910_;
                                            let _e612 = phi_1911_;
                                            if _e612 {
                                                if _e584 {
                                                    phi_1920_ = _e483.member_1;
                                                } else {
                                                    phi_1920_ = _e483.member_2;
                                                }
                                                let _e616 = phi_1920_;
                                                phi_1925_ = _e616;
                                                phi_1926_ = select(_e585, true, _e584);
                                            } else {
                                                phi_1925_ = _e608;
                                                phi_1926_ = _e418;
                                            }
                                            let _e619 = phi_1925_;
                                            let _e621 = phi_1926_;
                                            phi_2238_ = _e390;
                                            phi_1928_ = type_48(_e392.member, (_e392.member_1 + 1u), _e392.member_2);
                                            phi_1929_ = _e619;
                                            phi_1930_ = _e621;
                                            phi_1931_ = select(_e610, _e420, _e612);
                                        }
                                        let _e1048 = phi_2238_;
                                        let _e1050 = phi_1928_;
                                        let _e1052 = phi_1929_;
                                        let _e1054 = phi_1930_;
                                        let _e1056 = phi_1931_;
                                        phi_2237_ = _e1048;
                                        phi_1932_ = _e1050;
                                        phi_1933_ = _e1052;
                                        phi_1934_ = (_e396 - 1u);
                                        phi_1935_ = _e1054;
                                        phi_1936_ = _e1056;
                                    } else {
                                        phi_2237_ = _e390;
                                        phi_1932_ = _e392;
                                        phi_1933_ = _e416;
                                        phi_1934_ = _e396;
                                        phi_1935_ = _e418;
                                        phi_1936_ = _e420;
                                    }
                                    let _e1058 = phi_2237_;
                                    let _e1060 = phi_1932_;
                                    let _e1062 = phi_1933_;
                                    let _e1064 = phi_1934_;
                                    let _e1066 = phi_1935_;
                                    let _e1068 = phi_1936_;
                                    phi_2236_ = _e1058;
                                    phi_1937_ = _e1060;
                                    phi_1938_ = _e1062;
                                    phi_1939_ = _e1064;
                                    phi_1940_ = _e1066;
                                    phi_1941_ = _e1068;
                                } else {
                                    phi_2236_ = _e390;
                                    phi_1937_ = type_48();
                                    phi_1938_ = u32();
                                    phi_1939_ = u32();
                                    phi_1940_ = bool();
                                    phi_1941_ = u32();
                                }
                                let _e1070 = phi_2236_;
                                let _e1072 = phi_1937_;
                                let _e1074 = phi_1938_;
                                let _e1076 = phi_1939_;
                                let _e1078 = phi_1940_;
                                let _e1080 = phi_1941_;
                                phi_2235_ = _e1070;
                                phi_657_ = _e1072;
                                phi_660_ = _e1074;
                                phi_662_ = _e1076;
                                phi_664_ = _e1078;
                                phi_666_ = _e1080;
                                phi_1942_ = _e404;
                            } else {
                                phi_2235_ = _e390;
                                phi_657_ = type_48();
                                phi_660_ = u32();
                                phi_662_ = u32();
                                phi_664_ = bool();
                                phi_666_ = u32();
                                phi_1942_ = false;
                            }
                            let _e1082 = phi_2235_;
                            let _e1084 = phi_657_;
                            let _e1086 = phi_660_;
                            let _e1088 = phi_662_;
                            let _e1090 = phi_664_;
                            let _e1092 = phi_666_;
                            let _e1094 = phi_1942_;
                            continue;
                            continuing {
                                phi_2130_ = _e1082;
                                phi_656_ = _e1084;
                                phi_659_ = _e1086;
                                phi_661_ = _e1088;
                                phi_663_ = _e1090;
                                phi_665_ = _e1092;
                                phi_2234_ = _e1082;
                                break if !(_e1094);
                            }
                        }
                        let _e1097 = phi_2234_;
                        if _e1097 {
                            break;
                        }
                        let _e1099 = local_2;
                        if (_e1099.member.member.member_3 != 4294967295u) {
                            let _e1105 = (_e205 / 3i);
                            let _e1112 = bitcast<f32>((bitcast<u32>((_e1105 + 127i)) << bitcast<u32>(23i)));
                            let _e1120 = (((_e1099.member.member.member * _e1112) * _e1112) * bitcast<f32>((bitcast<u32>(((_e205 - (2i * _e1105)) + 127i)) << bitcast<u32>(23i))));
                            let _e1122 = select(340282350000000000000000000000000000000f, _e1120, (_e1120 < 340282350000000000000000000000000000000f));
                            phi_1994_ = type_22(select(-340282350000000000000000000000000000000f, _e1122, (_e1122 > -340282350000000000000000000000000000000f)), _e1099.member.member.member_1, _e1099.member.member.member_2, _e1099.member.member.member_3);
                        } else {
                            phi_1994_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1129 = phi_1994_;
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
