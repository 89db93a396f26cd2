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

struct type_48 {
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
    var phi_284_: i32;
    var phi_285_: i32;
    var phi_295_: bool;
    var phi_305_: u32;
    var phi_306_: u32;
    var phi_308_: bool;
    var phi_313_: u32;
    var phi_345_: i32;
    var phi_363_: f32;
    var phi_369_: f32;
    var phi_380_: f32;
    var phi_386_: f32;
    var phi_409_: f32;
    var phi_420_: f32;
    var phi_429_: f32;
    var phi_435_: f32;
    var phi_446_: f32;
    var phi_452_: f32;
    var phi_475_: f32;
    var phi_486_: f32;
    var phi_495_: f32;
    var phi_501_: f32;
    var phi_512_: f32;
    var phi_518_: f32;
    var phi_541_: f32;
    var phi_552_: f32;
    var phi_652_: f32;
    var phi_653_: f32;
    var phi_2420_: bool;
    var phi_673_: type_48;
    var phi_676_: u32;
    var phi_678_: u32;
    var phi_680_: bool;
    var phi_682_: u32;
    var phi_693_: bool;
    var phi_725_: u32;
    var phi_726_: bool;
    var phi_727_: u32;
    var phi_1819_: type_47;
    var phi_2163_: u32;
    var phi_2191_: u32;
    var phi_2192_: u32;
    var phi_2193_: u32;
    var phi_2195_: u32;
    var phi_2196_: u32;
    var phi_2197_: bool;
    var phi_2206_: u32;
    var phi_2211_: u32;
    var phi_2212_: bool;
    var phi_742_: type_48;
    var phi_745_: type_7;
    var phi_746_: type_7;
    var phi_768_: type_7;
    var phi_792_: u32;
    var phi_881_: array<array<f32, 3>, 3>;
    var phi_998_: bool;
    var phi_1027_: bool;
    var phi_1428_: f32;
    var phi_1429_: f32;
    var phi_1430_: f32;
    var phi_1431_: f32;
    var phi_1432_: vec3<f32>;
    var phi_1433_: vec3<f32>;
    var phi_1434_: vec3<f32>;
    var phi_1435_: vec3<f32>;
    var phi_1466_: bool;
    var phi_1475_: vec3<f32>;
    var phi_1640_: f32;
    var phi_1642_: f32;
    var phi_1643_: bool;
    var phi_1663_: f32;
    var phi_1664_: f32;
    var phi_1687_: type_22;
    var phi_1689_: type_22;
    var phi_1690_: bool;
    var phi_1694_: type_22;
    var phi_1695_: type_22;
    var phi_1696_: type_22;
    var phi_1697_: bool;
    var phi_1701_: type_22;
    var phi_1702_: bool;
    var phi_1703_: type_22;
    var phi_1704_: bool;
    var phi_1705_: bool;
    var phi_1706_: type_22;
    var phi_1707_: bool;
    var phi_1708_: bool;
    var phi_1716_: type_22;
    var phi_1717_: bool;
    var phi_1721_: type_22;
    var phi_1746_: bool;
    var phi_1747_: bool;
    var phi_1754_: type_48;
    var phi_1755_: type_48;
    var phi_1756_: type_48;
    var phi_743_: type_48;
    var phi_2414_: bool;
    var phi_2560_: bool;
    var phi_2214_: type_48;
    var phi_2215_: u32;
    var phi_2216_: bool;
    var phi_2217_: u32;
    var phi_2559_: bool;
    var phi_2218_: type_48;
    var phi_2219_: u32;
    var phi_2220_: u32;
    var phi_2221_: bool;
    var phi_2222_: u32;
    var phi_2558_: bool;
    var phi_2223_: type_48;
    var phi_2224_: u32;
    var phi_2225_: u32;
    var phi_2226_: bool;
    var phi_2227_: u32;
    var phi_2557_: bool;
    var phi_674_: type_48;
    var phi_677_: u32;
    var phi_679_: u32;
    var phi_681_: bool;
    var phi_683_: u32;
    var phi_2228_: bool;
    var phi_2556_: bool;
    var local_2: type_48;
    var phi_2280_: type_22;
    var local_3: type_48;
    var local_4: type_48;

    switch bitcast<i32>(0u) {
        default: {
            let _e67 = global;
            let _e69 = arrayLength((&global_2.member));
            let _e71 = arrayLength((&global_1.member));
            let _e79 = arrayLength((&global_6.member));
            let _e83 = (_e67.x + (_e67.y * 2097152u));
            let _e84 = (_e83 < arrayLength((&global_3.member)));
            if _e84 {
                let _e85 = (_e83 < arrayLength((&global_4.member)));
                if _e85 {
                    let _e86 = (_e83 < arrayLength((&global_5.member)));
                    if _e86 {
                        if _e84 {
                        } else {
                            break;
                        }
                        let _e96 = global_3.member[_e83].member.member_2[0u];
                        let _e98 = (bitcast<u32>(_e96) & 2147483647u);
                        let _e104 = global_3.member[_e83].member.member_2[1u];
                        let _e106 = (bitcast<u32>(_e104) & 2147483647u);
                        let _e112 = global_3.member[_e83].member.member_2[2u];
                        let _e114 = (bitcast<u32>(_e112) & 2147483647u);
                        let _e120 = global_3.member[_e83].member.member[0u];
                        let _e122 = (bitcast<u32>(_e120) & 2147483647u);
                        let _e128 = global_3.member[_e83].member.member[1u];
                        let _e130 = (bitcast<u32>(_e128) & 2147483647u);
                        let _e136 = global_3.member[_e83].member.member[2u];
                        let _e138 = (bitcast<u32>(_e136) & 2147483647u);
                        let _e140 = select(_e106, _e98, (_e106 < _e98));
                        let _e142 = select(_e114, _e140, (_e114 < _e140));
                        let _e144 = select(_e122, _e142, (_e122 < _e142));
                        let _e146 = select(_e130, _e144, (_e130 < _e144));
                        let _e148 = select(_e138, _e146, (_e138 < _e146));
                        let _e153 = global_3.member[_e83].member.member_1;
                        let _e155 = (bitcast<u32>(_e153) & 2147483647u);
                        let _e163 = global_3.member[_e83].member.member_3;
                        let _e169 = (((select(_e155, _e148, (_e155 < _e148)) < 2139095040u) && ((bitcast<u32>(_e163) & 2147483647u) <= 2139095040u)) && (_e142 > 0u));
                        if _e169 {
                            let _e172 = (bitcast<u32>(bitcast<f32>(_e142)) & 2147483647u);
                            if (_e172 >= 8388608u) {
                                phi_284_ = (bitcast<i32>((_e172 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_284_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e172)), 32u, (_e172 == 0u))));
                            }
                            let _e186 = phi_284_;
                            phi_285_ = _e186;
                        } else {
                            phi_285_ = 0i;
                        }
                        let _e188 = phi_285_;
                        let _e189 = (_e98 == _e142);
                        if _e189 {
                            phi_295_ = true;
                        } else {
                            phi_295_ = (_e106 == _e142);
                        }
                        let _e192 = phi_295_;
                        let _e193 = select(1u, 0u, _e189);
                        if _e192 {
                            let _e194 = (_e193 + 1u);
                            phi_305_ = _e194;
                            phi_306_ = _e194;
                            phi_308_ = select(true, false, (_e194 == 2u));
                        } else {
                            phi_305_ = u32();
                            phi_306_ = 0u;
                            phi_308_ = true;
                        }
                        let _e198 = phi_305_;
                        let _e200 = phi_306_;
                        let _e202 = phi_308_;
                        if _e202 {
                            phi_313_ = (_e200 + 1u);
                        } else {
                            phi_313_ = 0u;
                        }
                        let _e206 = phi_313_;
                        let _e207 = select(_e198, _e200, _e202);
                        let _e208 = select(_e193, select(2u, _e193, _e192), _e202);
                        let _e209 = -(_e188);
                        if (_e209 < -126i) {
                            phi_345_ = -126i;
                        } else {
                            phi_345_ = select(_e209, 127i, (_e209 > 127i));
                        }
                        let _e214 = phi_345_;
                        let _e219 = bitcast<f32>((bitcast<u32>((_e214 + 127i)) << bitcast<u32>(23i)));
                        let _e225 = bitcast<f32>((bitcast<u32>(((_e209 - _e214) + 127i)) << bitcast<u32>(23i)));
                        let _e230 = global_3.member[_e83].member.member;
                        let _e231 = (_e207 == 0u);
                        if _e231 {
                            phi_363_ = _e230[0];
                        } else {
                            phi_363_ = _e230[1];
                        }
                        let _e235 = phi_363_;
                        let _e236 = (_e207 == 2u);
                        if _e236 {
                            phi_369_ = _e230[2];
                        } else {
                            phi_369_ = _e235;
                        }
                        let _e239 = phi_369_;
                        let _e240 = global_3.member[_e83].member.member_2;
                        if _e231 {
                            phi_380_ = _e240[0];
                        } else {
                            phi_380_ = _e240[1];
                        }
                        let _e244 = phi_380_;
                        if _e236 {
                            phi_386_ = _e240[2];
                        } else {
                            phi_386_ = _e244;
                        }
                        let _e247 = phi_386_;
                        let _e249 = ((_e247 * _e219) * _e225);
                        let _e253 = (bitcast<f32>((bitcast<u32>(_e249) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e253 {
                            let _e257 = (bitcast<f32>((bitcast<u32>(_e239) & 2147483647u)) * 0.00000011920929f);
                            phi_409_ = select(0.00000000000011368684f, _e257, (_e257 > 0.00000000000011368684f));
                        } else {
                            phi_409_ = 0f;
                        }
                        let _e261 = phi_409_;
                        let _e262 = (_e239 + _e261);
                        let _e263 = (_e239 - _e261);
                        let _e264 = select(_e249, 0f, _e253);
                        if _e253 {
                            phi_420_ = 38685626000000000000000000f;
                        } else {
                            phi_420_ = (1f / _e249);
                        }
                        let _e267 = phi_420_;
                        let _e268 = (_e206 == 0u);
                        if _e268 {
                            phi_429_ = _e230[0];
                        } else {
                            phi_429_ = _e230[1];
                        }
                        let _e272 = phi_429_;
                        let _e273 = (_e206 == 2u);
                        if _e273 {
                            phi_435_ = _e230[2];
                        } else {
                            phi_435_ = _e272;
                        }
                        let _e276 = phi_435_;
                        if _e268 {
                            phi_446_ = _e240[0];
                        } else {
                            phi_446_ = _e240[1];
                        }
                        let _e280 = phi_446_;
                        if _e273 {
                            phi_452_ = _e240[2];
                        } else {
                            phi_452_ = _e280;
                        }
                        let _e283 = phi_452_;
                        let _e285 = ((_e283 * _e219) * _e225);
                        let _e289 = (bitcast<f32>((bitcast<u32>(_e285) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e289 {
                            let _e293 = (bitcast<f32>((bitcast<u32>(_e276) & 2147483647u)) * 0.00000011920929f);
                            phi_475_ = select(0.00000000000011368684f, _e293, (_e293 > 0.00000000000011368684f));
                        } else {
                            phi_475_ = 0f;
                        }
                        let _e297 = phi_475_;
                        let _e298 = (_e276 + _e297);
                        let _e299 = (_e276 - _e297);
                        let _e300 = select(_e285, 0f, _e289);
                        if _e289 {
                            phi_486_ = 38685626000000000000000000f;
                        } else {
                            phi_486_ = (1f / _e285);
                        }
                        let _e303 = phi_486_;
                        let _e304 = (_e208 == 0u);
                        if _e304 {
                            phi_495_ = _e230[0];
                        } else {
                            phi_495_ = _e230[1];
                        }
                        let _e308 = phi_495_;
                        let _e309 = (_e208 == 2u);
                        if _e309 {
                            phi_501_ = _e230[2];
                        } else {
                            phi_501_ = _e308;
                        }
                        let _e312 = phi_501_;
                        if _e304 {
                            phi_512_ = _e240[0];
                        } else {
                            phi_512_ = _e240[1];
                        }
                        let _e316 = phi_512_;
                        if _e309 {
                            phi_518_ = _e240[2];
                        } else {
                            phi_518_ = _e316;
                        }
                        let _e319 = phi_518_;
                        let _e321 = ((_e319 * _e219) * _e225);
                        let _e325 = (bitcast<f32>((bitcast<u32>(_e321) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e325 {
                            let _e329 = (bitcast<f32>((bitcast<u32>(_e312) & 2147483647u)) * 0.00000011920929f);
                            phi_541_ = select(0.00000000000011368684f, _e329, (_e329 > 0.00000000000011368684f));
                        } else {
                            phi_541_ = 0f;
                        }
                        let _e333 = phi_541_;
                        let _e334 = (_e312 + _e333);
                        let _e335 = (_e312 - _e333);
                        let _e336 = select(_e321, 0f, _e325);
                        if _e325 {
                            phi_552_ = 38685626000000000000000000f;
                        } else {
                            phi_552_ = (1f / _e321);
                        }
                        let _e339 = phi_552_;
                        let _e342 = bitcast<f32>((bitcast<u32>(_e239) & 2147483647u));
                        let _e345 = bitcast<f32>((bitcast<u32>(_e276) & 2147483647u));
                        let _e347 = select(_e345, _e342, (_e342 > _e345));
                        let _e350 = bitcast<f32>((bitcast<u32>(_e312) & 2147483647u));
                        if (_e169 && (select(_e350, _e347, (_e347 > _e350)) <= 1099511600000f)) {
                            let _e355 = (_e188 / 3i);
                            let _e362 = bitcast<f32>((bitcast<u32>((_e355 + 127i)) << bitcast<u32>(23i)));
                            let _e369 = bitcast<f32>((bitcast<u32>(((_e188 - (2i * _e355)) + 127i)) << bitcast<u32>(23i)));
                            let _e370 = (((_e153 * _e362) * _e362) * _e369);
                            let _e372 = select(340282350000000000000000000000000000000f, _e370, (_e370 < 340282350000000000000000000000000000000f));
                            let _e377 = (((_e163 * _e362) * _e362) * _e369);
                            let _e379 = select(340282350000000000000000000000000000000f, _e377, (_e377 < 340282350000000000000000000000000000000f));
                            phi_652_ = select(-340282350000000000000000000000000000000f, _e379, (_e379 > -340282350000000000000000000000000000000f));
                            phi_653_ = select(-340282350000000000000000000000000000000f, _e372, (_e372 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_652_ = 0f;
                            phi_653_ = 1f;
                        }
                        let _e383 = phi_652_;
                        let _e385 = phi_653_;
                        if _e84 {
                        } else {
                            break;
                        }
                        let _e391 = global_3.member[_e83].member_2;
                        local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        phi_2420_ = false;
                        phi_673_ = type_48(type_42(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e383), 0u, 0u);
                        phi_676_ = select(0u, 2147483648u, (_e69 == 0u));
                        phi_678_ = ((3u * _e69) + 1u);
                        phi_680_ = (_e385 <= _e383);
                        phi_682_ = 0u;
                        loop {
                            let _e398 = phi_2420_;
                            let _e400 = phi_673_;
                            let _e402 = phi_676_;
                            let _e404 = phi_678_;
                            let _e406 = phi_680_;
                            let _e408 = phi_682_;
                            local_2 = _e400;
                            local_3 = _e400;
                            if _e406 {
                                phi_693_ = true;
                            } else {
                                phi_693_ = (_e408 > 0u);
                            }
                            let _e411 = phi_693_;
                            if _e411 {
                                let _e412 = (_e404 > 0u);
                                if _e412 {
                                    if _e406 {
                                        phi_725_ = _e402;
                                        phi_726_ = _e406;
                                        phi_727_ = _e408;
                                    } else {
                                        let _e413 = (_e408 - 1u);
                                        let _e414 = (_e413 % 128u);
                                        let _e415 = (_e414 < 128u);
                                        if _e415 {
                                        } else {
                                            phi_2556_ = true;
                                            break;
                                        }
                                        let _e417 = local_1[_e414];
                                        if _e415 {
                                        } else {
                                            phi_2556_ = true;
                                            break;
                                        }
                                        let _e419 = local[_e414];
                                        phi_725_ = _e417;
                                        phi_726_ = (_e419 <= _e400.member.member_1);
                                        phi_727_ = _e413;
                                    }
                                    let _e424 = phi_725_;
                                    let _e426 = phi_726_;
                                    let _e428 = phi_727_;
                                    if _e426 {
                                        if ((_e424 & 2147483648u) != 0u) {
                                            phi_742_ = _e400;
                                            phi_745_ = type_7(0u, ((_e424 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e633 = phi_742_;
                                                let _e635 = phi_745_;
                                                local_4 = _e633;
                                                if (_e635.member < _e635.member_1) {
                                                    phi_746_ = type_7((_e635.member + 1u), _e635.member_1);
                                                    phi_768_ = type_7(1u, _e635.member);
                                                } else {
                                                    phi_746_ = _e635;
                                                    phi_768_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e648 = phi_746_;
                                                let _e650 = phi_768_;
                                                let _e654 = (bitcast<i32>(_e650.member) != 0i);
                                                if _e654 {
                                                    let _e660 = type_48(_e633.member, _e633.member_1, (_e633.member_2 + 1u));
                                                    let _e661 = ((_e424 & 268435455u) + _e650.member_1);
                                                    let _e662 = (_e661 < _e71);
                                                    if _e662 {
                                                        if _e662 {
                                                        } else {
                                                            phi_2414_ = true;
                                                            break;
                                                        }
                                                        let _e666 = global_1.member[_e661].member_1;
                                                        phi_792_ = _e666;
                                                    } else {
                                                        phi_792_ = 4294967295u;
                                                    }
                                                    let _e668 = phi_792_;
                                                    if (_e661 >= _e71) {
                                                        phi_881_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e662 {
                                                        } else {
                                                            phi_2414_ = true;
                                                            break;
                                                        }
                                                        let _e670 = (_e207 % 3u);
                                                        let _e671 = (_e206 % 3u);
                                                        let _e672 = (_e208 % 3u);
                                                        if (_e670 < 9u) {
                                                        } else {
                                                            phi_2414_ = true;
                                                            break;
                                                        }
                                                        let _e678 = global_1.member[_e661].member[_e670];
                                                        if (_e671 < 9u) {
                                                        } else {
                                                            phi_2414_ = true;
                                                            break;
                                                        }
                                                        let _e684 = global_1.member[_e661].member[_e671];
                                                        if (_e672 < 9u) {
                                                        } else {
                                                            phi_2414_ = true;
                                                            break;
                                                        }
                                                        let _e690 = global_1.member[_e661].member[_e672];
                                                        let _e692 = (3u + _e670);
                                                        if (_e692 < 9u) {
                                                        } else {
                                                            phi_2414_ = true;
                                                            break;
                                                        }
                                                        let _e698 = global_1.member[_e661].member[_e692];
                                                        let _e699 = (3u + _e671);
                                                        if (_e699 < 9u) {
                                                        } else {
                                                            phi_2414_ = true;
                                                            break;
                                                        }
                                                        let _e705 = global_1.member[_e661].member[_e699];
                                                        let _e706 = (3u + _e672);
                                                        if (_e706 < 9u) {
                                                        } else {
                                                            phi_2414_ = true;
                                                            break;
                                                        }
                                                        let _e712 = global_1.member[_e661].member[_e706];
                                                        let _e714 = (6u + _e670);
                                                        if (_e714 < 9u) {
                                                        } else {
                                                            phi_2414_ = true;
                                                            break;
                                                        }
                                                        let _e720 = global_1.member[_e661].member[_e714];
                                                        let _e721 = (6u + _e671);
                                                        if (_e721 < 9u) {
                                                        } else {
                                                            phi_2414_ = true;
                                                            break;
                                                        }
                                                        let _e727 = global_1.member[_e661].member[_e721];
                                                        let _e728 = (6u + _e672);
                                                        if (_e728 < 9u) {
                                                        } else {
                                                            phi_2414_ = true;
                                                            break;
                                                        }
                                                        let _e734 = global_1.member[_e661].member[_e728];
                                                        phi_881_ = array<array<f32, 3>, 3>(array<f32, 3>(_e678, _e684, _e690), array<f32, 3>(_e698, _e705, _e712), array<f32, 3>(_e720, _e727, _e734));
                                                    }
                                                    let _e738 = phi_881_;
                                                    let _e747 = (_e738[0][2] - _e312);
                                                    let _e750 = (((_e738[0][0] - _e239) * _e336) - (_e747 * _e264));
                                                    let _e753 = (((_e738[0][1] - _e276) * _e336) - (_e747 * _e300));
                                                    let _e760 = (_e738[1][2] - _e312);
                                                    let _e763 = (((_e738[1][0] - _e239) * _e336) - (_e760 * _e264));
                                                    let _e766 = (((_e738[1][1] - _e276) * _e336) - (_e760 * _e300));
                                                    let _e773 = (_e738[2][2] - _e312);
                                                    let _e776 = (((_e738[2][0] - _e239) * _e336) - (_e773 * _e264));
                                                    let _e779 = (((_e738[2][1] - _e276) * _e336) - (_e773 * _e300));
                                                    let _e780 = (_e776 * _e766);
                                                    let _e781 = (_e779 * _e763);
                                                    let _e782 = (_e750 * _e779);
                                                    let _e783 = (_e753 * _e776);
                                                    let _e784 = (_e763 * _e753);
                                                    let _e785 = (_e766 * _e750);
                                                    let _e790 = (((_e780 >= _e781) && (_e782 >= _e783)) && (_e784 >= _e785));
                                                    if (_e790 || (((_e780 <= _e781) && (_e782 <= _e783)) && (_e784 <= _e785))) {
                                                        let _e797 = select(-1f, 1f, _e790);
                                                        let _e799 = ((_e780 - _e781) * _e797);
                                                        let _e801 = select(0f, _e799, (_e799 > 0f));
                                                        let _e803 = ((_e782 - _e783) * _e797);
                                                        let _e805 = select(0f, _e803, (_e803 > 0f));
                                                        let _e807 = ((_e784 - _e785) * _e797);
                                                        let _e809 = select(0f, _e807, (_e807 > 0f));
                                                        let _e811 = ((_e801 + _e805) + _e809);
                                                        if (_e811 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1706_ = type_22();
                                                            phi_1707_ = true;
                                                            phi_1708_ = false;
                                                        } else {
                                                            let _e814 = select(_e763, _e750, (_e750 < _e763));
                                                            if (select(_e776, _e814, (_e814 < _e776)) > 0f) {
                                                                phi_998_ = true;
                                                            } else {
                                                                let _e819 = select(_e763, _e750, (_e750 > _e763));
                                                                phi_998_ = (select(_e776, _e819, (_e819 > _e776)) < 0f);
                                                            }
                                                            let _e824 = phi_998_;
                                                            if _e824 {
                                                                phi_1703_ = type_22();
                                                                phi_1704_ = true;
                                                                phi_1705_ = false;
                                                            } else {
                                                                let _e826 = select(_e766, _e753, (_e753 < _e766));
                                                                if (select(_e779, _e826, (_e826 < _e779)) > 0f) {
                                                                    phi_1027_ = true;
                                                                } else {
                                                                    let _e831 = select(_e766, _e753, (_e753 > _e766));
                                                                    phi_1027_ = (select(_e779, _e831, (_e831 > _e779)) < 0f);
                                                                }
                                                                let _e836 = phi_1027_;
                                                                if _e836 {
                                                                    phi_1701_ = type_22();
                                                                    phi_1702_ = false;
                                                                } else {
                                                                    let _e838 = select(_e738[1][0], _e738[0][0], (_e738[0][0] < _e738[1][0]));
                                                                    let _e842 = select(_e738[1][0], _e738[0][0], (_e738[0][0] > _e738[1][0]));
                                                                    let _e846 = select(_e738[1][1], _e738[0][1], (_e738[0][1] < _e738[1][1]));
                                                                    let _e850 = select(_e738[1][1], _e738[0][1], (_e738[0][1] > _e738[1][1]));
                                                                    let _e854 = select(_e738[1][2], _e738[0][2], (_e738[0][2] < _e738[1][2]));
                                                                    let _e858 = select(_e738[1][2], _e738[0][2], (_e738[0][2] > _e738[1][2]));
                                                                    let _e863 = ((select(_e738[2][0], _e838, (_e838 < _e738[2][0])) - _e262) * _e267);
                                                                    let _e864 = ((select(_e738[2][0], _e842, (_e842 > _e738[2][0])) - _e263) * _e267);
                                                                    let _e867 = ((select(_e738[2][1], _e846, (_e846 < _e738[2][1])) - _e298) * _e303);
                                                                    let _e868 = ((select(_e738[2][1], _e850, (_e850 > _e738[2][1])) - _e299) * _e303);
                                                                    let _e871 = ((select(_e738[2][2], _e854, (_e854 < _e738[2][2])) - _e334) * _e339);
                                                                    let _e872 = ((select(_e738[2][2], _e858, (_e858 > _e738[2][2])) - _e335) * _e339);
                                                                    let _e874 = select(_e872, _e871, (_e871 < _e872));
                                                                    let _e876 = select(_e872, _e871, (_e871 > _e872));
                                                                    let _e878 = select(_e864, _e863, (_e863 < _e864));
                                                                    let _e880 = select(_e868, _e867, (_e867 < _e868));
                                                                    let _e882 = select(_e880, _e878, (_e878 > _e880));
                                                                    let _e884 = select(_e874, _e882, (_e882 > _e874));
                                                                    let _e886 = select(_e864, _e863, (_e863 > _e864));
                                                                    let _e888 = select(_e868, _e867, (_e867 > _e868));
                                                                    let _e890 = select(_e888, _e886, (_e886 < _e888));
                                                                    let _e892 = select(_e876, _e890, (_e890 < _e876));
                                                                    let _e893 = -(_e874);
                                                                    let _e899 = select(_e385, _e884, (_e884 > _e385));
                                                                    if (_e899 > (_e892 + (select(_e893, _e876, (_e876 > _e893)) * 0.0000019073523f))) {
                                                                        phi_1696_ = type_22();
                                                                        phi_1697_ = true;
                                                                    } else {
                                                                        let _e901 = (_e899 > _e633.member.member_1);
                                                                        if _e901 {
                                                                            phi_1695_ = type_22();
                                                                        } else {
                                                                            let _e902 = vec3<f32>(_e738[0][0], _e738[0][1], _e738[0][2]);
                                                                            let _e903 = vec3<f32>(_e738[1][0], _e738[1][1], _e738[1][2]);
                                                                            let _e904 = vec3<f32>(_e738[2][0], _e738[2][1], _e738[2][2]);
                                                                            let _e905 = (_e738[1][0] - _e738[0][0]);
                                                                            let _e906 = (_e738[1][1] - _e738[0][1]);
                                                                            let _e907 = (_e738[1][2] - _e738[0][2]);
                                                                            let _e908 = vec3<f32>(_e905, _e906, _e907);
                                                                            let _e909 = (_e738[2][0] - _e738[1][0]);
                                                                            let _e910 = (_e738[2][1] - _e738[1][1]);
                                                                            let _e911 = (_e738[2][2] - _e738[1][2]);
                                                                            let _e912 = vec3<f32>(_e909, _e910, _e911);
                                                                            let _e913 = (_e738[0][0] - _e738[2][0]);
                                                                            let _e914 = (_e738[0][1] - _e738[2][1]);
                                                                            let _e915 = (_e738[0][2] - _e738[2][2]);
                                                                            let _e916 = vec3<f32>(_e913, _e914, _e915);
                                                                            let _e919 = bitcast<f32>((bitcast<u32>(_e905) & 2147483647u));
                                                                            let _e922 = bitcast<f32>((bitcast<u32>(_e906) & 2147483647u));
                                                                            let _e924 = select(_e922, _e919, (_e919 > _e922));
                                                                            let _e927 = bitcast<f32>((bitcast<u32>(_e907) & 2147483647u));
                                                                            let _e929 = select(_e927, _e924, (_e924 > _e927));
                                                                            let _e932 = bitcast<f32>((bitcast<u32>(_e909) & 2147483647u));
                                                                            let _e935 = bitcast<f32>((bitcast<u32>(_e910) & 2147483647u));
                                                                            let _e937 = select(_e935, _e932, (_e932 > _e935));
                                                                            let _e940 = bitcast<f32>((bitcast<u32>(_e911) & 2147483647u));
                                                                            let _e942 = select(_e940, _e937, (_e937 > _e940));
                                                                            let _e945 = bitcast<f32>((bitcast<u32>(_e913) & 2147483647u));
                                                                            let _e948 = bitcast<f32>((bitcast<u32>(_e914) & 2147483647u));
                                                                            let _e950 = select(_e948, _e945, (_e945 > _e948));
                                                                            let _e953 = bitcast<f32>((bitcast<u32>(_e915) & 2147483647u));
                                                                            let _e955 = select(_e953, _e950, (_e950 > _e953));
                                                                            let _e957 = select(_e942, _e929, (_e929 > _e942));
                                                                            let _e959 = select(_e955, _e957, (_e957 > _e955));
                                                                            if (_e929 == _e959) {
                                                                                phi_1428_ = _e766;
                                                                                phi_1429_ = _e763;
                                                                                phi_1430_ = _e753;
                                                                                phi_1431_ = _e750;
                                                                                phi_1432_ = _e902;
                                                                                phi_1433_ = _e916;
                                                                                phi_1434_ = _e912;
                                                                                phi_1435_ = _e908;
                                                                            } else {
                                                                                let _e961 = (_e942 == _e959);
                                                                                let _e966 = vec3(_e961);
                                                                                phi_1428_ = select(_e753, _e779, _e961);
                                                                                phi_1429_ = select(_e750, _e776, _e961);
                                                                                phi_1430_ = select(_e779, _e766, _e961);
                                                                                phi_1431_ = select(_e776, _e763, _e961);
                                                                                phi_1432_ = select(_e904, _e903, _e966);
                                                                                phi_1433_ = select(_e912, _e908, _e966);
                                                                                phi_1434_ = select(_e908, _e916, _e966);
                                                                                phi_1435_ = select(_e916, _e912, _e966);
                                                                            }
                                                                            let _e972 = phi_1428_;
                                                                            let _e974 = phi_1429_;
                                                                            let _e976 = phi_1430_;
                                                                            let _e978 = phi_1431_;
                                                                            let _e980 = phi_1432_;
                                                                            let _e982 = phi_1433_;
                                                                            let _e984 = phi_1434_;
                                                                            let _e986 = phi_1435_;
                                                                            let _e993 = ((_e984.y * _e982.z) - (_e982.y * _e984.z));
                                                                            let _e998 = ((_e984.z * _e982.x) - (_e982.z * _e984.x));
                                                                            let _e1001 = ((_e984.x * _e982.y) - (_e982.x * _e984.y));
                                                                            if (_e801 >= _e805) {
                                                                                phi_1466_ = select(true, false, (_e801 >= _e809));
                                                                            } else {
                                                                                phi_1466_ = true;
                                                                            }
                                                                            let _e1006 = phi_1466_;
                                                                            if _e1006 {
                                                                                phi_1475_ = select(_e904, _e903, vec3((_e805 >= _e809)));
                                                                            } else {
                                                                                phi_1475_ = _e902;
                                                                            }
                                                                            let _e1011 = phi_1475_;
                                                                            let _e1022 = (((_e993 * (_e1011.x - _e239)) + (_e998 * (_e1011.y - _e276))) + (_e1001 * (_e1011.z - _e312)));
                                                                            let _e1027 = (((_e993 * _e264) + (_e998 * _e300)) + (_e1001 * _e336));
                                                                            let _e1028 = (_e974 - _e978);
                                                                            let _e1029 = (_e972 - _e976);
                                                                            let _e1037 = (-(((_e978 * _e1028) + (_e976 * _e1029))) / ((_e1028 * _e1028) + (_e1029 * _e1029)));
                                                                            let _e1039 = select(1f, _e1037, (_e1037 < 1f));
                                                                            let _e1041 = select(0f, _e1039, (_e1039 > 0f));
                                                                            let _e1054 = ((_e980.x + (_e986.x * _e1041)) - _e239);
                                                                            let _e1055 = ((_e980.y + (_e986.y * _e1041)) - _e276);
                                                                            let _e1056 = ((_e980.z + (_e986.z * _e1041)) - _e312);
                                                                            let _e1057 = (_e1056 / _e336);
                                                                            let _e1069 = bitcast<f32>((bitcast<u32>(_e1054) & 2147483647u));
                                                                            let _e1072 = bitcast<f32>((bitcast<u32>(_e1055) & 2147483647u));
                                                                            let _e1074 = select(_e1072, _e1069, (_e1069 > _e1072));
                                                                            let _e1077 = bitcast<f32>((bitcast<u32>(_e1056) & 2147483647u));
                                                                            let _e1079 = select(_e1077, _e1074, (_e1074 > _e1077));
                                                                            let _e1085 = bitcast<f32>((bitcast<u32>(_e993) & 2147483647u));
                                                                            let _e1088 = bitcast<f32>((bitcast<u32>(_e998) & 2147483647u));
                                                                            let _e1090 = select(_e1088, _e1085, (_e1085 > _e1088));
                                                                            let _e1093 = bitcast<f32>((bitcast<u32>(_e1001) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e993 * _e1054) + (_e998 * _e1055)) + (_e1001 * _e1056)) - _e1022)) & 2147483647u)) <= ((0.0000009536743f * select(_e959, _e1079, (_e1079 > _e959))) * select(_e1093, _e1090, (_e1090 > _e1093)))) {
                                                                                let _e1103 = bitcast<f32>((bitcast<u32>(_e984.x) & 2147483647u));
                                                                                let _e1106 = bitcast<f32>((bitcast<u32>(_e984.y) & 2147483647u));
                                                                                let _e1108 = select(_e1106, _e1103, (_e1103 > _e1106));
                                                                                let _e1111 = bitcast<f32>((bitcast<u32>(_e984.z) & 2147483647u));
                                                                                let _e1117 = bitcast<f32>((bitcast<u32>(_e982.x) & 2147483647u));
                                                                                let _e1120 = bitcast<f32>((bitcast<u32>(_e982.y) & 2147483647u));
                                                                                let _e1122 = select(_e1120, _e1117, (_e1117 > _e1120));
                                                                                let _e1125 = bitcast<f32>((bitcast<u32>(_e982.z) & 2147483647u));
                                                                                let _e1129 = (bitcast<f32>((bitcast<u32>(_e1027) & 2147483647u)) > ((0.0000038146973f * select(_e1111, _e1108, (_e1108 > _e1111))) * select(_e1125, _e1122, (_e1122 > _e1125))));
                                                                                if _e1129 {
                                                                                    phi_1640_ = (_e1022 / _e1027);
                                                                                } else {
                                                                                    phi_1640_ = f32();
                                                                                }
                                                                                let _e1132 = phi_1640_;
                                                                                phi_1642_ = _e1132;
                                                                                phi_1643_ = select(true, false, _e1129);
                                                                            } else {
                                                                                phi_1642_ = f32();
                                                                                phi_1643_ = true;
                                                                            }
                                                                            let _e1135 = phi_1642_;
                                                                            let _e1137 = phi_1643_;
                                                                            if _e1137 {
                                                                                let _e1145 = (((_e993 * (_e1054 - (_e264 * _e1057))) + (_e998 * (_e1055 - (_e300 * _e1057)))) / _e1027);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1145) & 2147483647u)) <= _e959) {
                                                                                    phi_1663_ = (_e1057 + _e1145);
                                                                                } else {
                                                                                    phi_1663_ = _e1057;
                                                                                }
                                                                                let _e1152 = phi_1663_;
                                                                                phi_1664_ = _e1152;
                                                                            } else {
                                                                                phi_1664_ = _e1135;
                                                                            }
                                                                            let _e1154 = phi_1664_;
                                                                            let _e1156 = select(_e892, _e1154, (_e1154 < _e892));
                                                                            let _e1158 = select(_e884, _e1156, (_e1156 > _e884));
                                                                            if (_e1158 >= _e385) {
                                                                                let _e1160 = (_e1158 <= _e633.member.member_1);
                                                                                if _e1160 {
                                                                                    let _e1161 = (1f / _e811);
                                                                                    phi_1687_ = type_22(_e1158, (_e805 * _e1161), (_e809 * _e1161), _e668);
                                                                                } else {
                                                                                    phi_1687_ = type_22();
                                                                                }
                                                                                let _e1166 = phi_1687_;
                                                                                phi_1689_ = _e1166;
                                                                                phi_1690_ = select(true, false, _e1160);
                                                                            } else {
                                                                                phi_1689_ = type_22();
                                                                                phi_1690_ = true;
                                                                            }
                                                                            let _e1169 = phi_1689_;
                                                                            let _e1171 = phi_1690_;
                                                                            if _e1171 {
                                                                                phi_1694_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_1694_ = _e1169;
                                                                            }
                                                                            let _e1173 = phi_1694_;
                                                                            phi_1695_ = _e1173;
                                                                        }
                                                                        let _e1175 = phi_1695_;
                                                                        phi_1696_ = _e1175;
                                                                        phi_1697_ = _e901;
                                                                    }
                                                                    let _e1177 = phi_1696_;
                                                                    let _e1179 = phi_1697_;
                                                                    phi_1701_ = _e1177;
                                                                    phi_1702_ = _e1179;
                                                                }
                                                                let _e1181 = phi_1701_;
                                                                let _e1183 = phi_1702_;
                                                                phi_1703_ = _e1181;
                                                                phi_1704_ = _e836;
                                                                phi_1705_ = _e1183;
                                                            }
                                                            let _e1185 = phi_1703_;
                                                            let _e1187 = phi_1704_;
                                                            let _e1189 = phi_1705_;
                                                            phi_1706_ = _e1185;
                                                            phi_1707_ = _e1187;
                                                            phi_1708_ = _e1189;
                                                        }
                                                        let _e1191 = phi_1706_;
                                                        let _e1193 = phi_1707_;
                                                        let _e1195 = phi_1708_;
                                                        phi_1716_ = _e1191;
                                                        phi_1717_ = select(_e1195, true, _e1193);
                                                    } else {
                                                        phi_1716_ = type_22();
                                                        phi_1717_ = true;
                                                    }
                                                    let _e1198 = phi_1716_;
                                                    let _e1200 = phi_1717_;
                                                    if _e1200 {
                                                        phi_1721_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1721_ = _e1198;
                                                    }
                                                    let _e1202 = phi_1721_;
                                                    if (_e1202.member_3 != 4294967295u) {
                                                        if (_e668 != _e391) {
                                                            if (_e1202.member < _e633.member.member.member) {
                                                                phi_1747_ = true;
                                                            } else {
                                                                if (_e1202.member == _e633.member.member.member) {
                                                                    phi_1746_ = (_e1202.member_3 < _e633.member.member.member_3);
                                                                } else {
                                                                    phi_1746_ = false;
                                                                }
                                                                let _e1217 = phi_1746_;
                                                                phi_1747_ = _e1217;
                                                            }
                                                            let _e1219 = phi_1747_;
                                                            if _e1219 {
                                                                phi_1754_ = type_48(type_42(_e1202, _e1202.member), _e660.member_1, _e660.member_2);
                                                            } else {
                                                                phi_1754_ = _e660;
                                                            }
                                                            let _e1226 = phi_1754_;
                                                            phi_1755_ = _e1226;
                                                        } else {
                                                            phi_1755_ = _e660;
                                                        }
                                                        let _e1228 = phi_1755_;
                                                        phi_1756_ = _e1228;
                                                    } else {
                                                        phi_1756_ = _e660;
                                                    }
                                                    let _e1230 = phi_1756_;
                                                    phi_743_ = _e1230;
                                                } else {
                                                    phi_743_ = type_48();
                                                }
                                                let _e1232 = phi_743_;
                                                continue;
                                                continuing {
                                                    phi_742_ = _e1232;
                                                    phi_745_ = _e648;
                                                    phi_2414_ = _e398;
                                                    break if !(_e654);
                                                }
                                            }
                                            let _e1235 = phi_2414_;
                                            phi_2556_ = _e1235;
                                            if _e1235 {
                                                break;
                                            }
                                            phi_2560_ = _e1235;
                                            let _e1464 = local_4;
                                            phi_2214_ = _e1464;
                                            phi_2215_ = _e424;
                                            phi_2216_ = false;
                                            phi_2217_ = _e428;
                                        } else {
                                            if (_e424 >= _e69) {
                                                phi_1819_ = type_47(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                            } else {
                                                if (_e424 < _e69) {
                                                } else {
                                                    phi_2556_ = true;
                                                    break;
                                                }
                                                let _e444 = (_e207 % 3u);
                                                if (_e444 < 3u) {
                                                } else {
                                                    phi_2556_ = true;
                                                    break;
                                                }
                                                let _e450 = global_2.member[_e424].member[_e444];
                                                let _e456 = (_e206 % 3u);
                                                if (_e456 < 3u) {
                                                } else {
                                                    phi_2556_ = true;
                                                    break;
                                                }
                                                let _e462 = global_2.member[_e424].member[_e456];
                                                let _e468 = (_e208 % 3u);
                                                if (_e468 < 3u) {
                                                } else {
                                                    phi_2556_ = true;
                                                    break;
                                                }
                                                let _e474 = global_2.member[_e424].member[_e468];
                                                let _e484 = global_2.member[_e424].member_1;
                                                let _e488 = global_2.member[_e424].member_2;
                                                phi_1819_ = type_47(array<vec4<f32>, 3>(vec4<f32>(_e450[0], _e450[1], _e450[2], _e450[3]), vec4<f32>(_e462[0], _e462[1], _e462[2], _e462[3]), vec4<f32>(_e474[0], _e474[1], _e474[2], _e474[3])), _e484, _e488);
                                            }
                                            let _e491 = phi_1819_;
                                            let _e504 = ((_e491.member[0].x - _e262) * _e267);
                                            let _e505 = ((_e491.member[0].y - _e262) * _e267);
                                            let _e506 = ((_e491.member[0].z - _e263) * _e267);
                                            let _e507 = ((_e491.member[0].w - _e263) * _e267);
                                            let _e517 = ((_e491.member[1].x - _e298) * _e303);
                                            let _e518 = ((_e491.member[1].y - _e298) * _e303);
                                            let _e519 = ((_e491.member[1].z - _e299) * _e303);
                                            let _e520 = ((_e491.member[1].w - _e299) * _e303);
                                            let _e530 = ((_e491.member[2].x - _e334) * _e339);
                                            let _e531 = ((_e491.member[2].y - _e334) * _e339);
                                            let _e532 = ((_e491.member[2].z - _e335) * _e339);
                                            let _e533 = ((_e491.member[2].w - _e335) * _e339);
                                            let _e535 = select(_e532, _e530, (_e530 < _e532));
                                            let _e537 = select(_e533, _e531, (_e531 < _e533));
                                            let _e539 = select(_e532, _e530, (_e530 > _e532));
                                            let _e541 = select(_e533, _e531, (_e531 > _e533));
                                            let _e543 = select(_e506, _e504, (_e504 < _e506));
                                            let _e545 = select(_e507, _e505, (_e505 < _e507));
                                            let _e547 = select(_e519, _e517, (_e517 < _e519));
                                            let _e549 = select(_e520, _e518, (_e518 < _e520));
                                            let _e551 = select(_e547, _e543, (_e543 > _e547));
                                            let _e553 = select(_e549, _e545, (_e545 > _e549));
                                            let _e555 = select(_e535, _e551, (_e551 > _e535));
                                            let _e557 = select(_e537, _e553, (_e553 > _e537));
                                            let _e559 = select(_e506, _e504, (_e504 > _e506));
                                            let _e561 = select(_e507, _e505, (_e505 > _e507));
                                            let _e563 = select(_e519, _e517, (_e517 > _e519));
                                            let _e565 = select(_e520, _e518, (_e518 > _e520));
                                            let _e567 = select(_e563, _e559, (_e559 < _e563));
                                            let _e569 = select(_e565, _e561, (_e561 < _e565));
                                            let _e574 = -(_e535);
                                            let _e575 = -(_e537);
                                            let _e582 = (select(_e539, _e567, (_e567 < _e539)) + (select(_e574, _e539, (_e539 > _e574)) * 0.0000019073523f));
                                            let _e583 = (select(_e541, _e569, (_e569 < _e541)) + (select(_e575, _e541, (_e541 > _e575)) * 0.0000019073523f));
                                            let _e585 = select(_e385, _e555, (_e555 > _e385));
                                            let _e587 = select(_e385, _e557, (_e557 > _e385));
                                            let _e592 = (_e585 <= select(_e400.member.member_1, _e582, (_e582 < _e400.member.member_1)));
                                            let _e593 = (_e587 <= select(_e400.member.member_1, _e583, (_e583 < _e400.member.member_1)));
                                            let _e594 = (_e585 <= _e587);
                                            if _e592 {
                                                if _e593 {
                                                    if _e594 {
                                                        phi_2163_ = _e491.member_2;
                                                    } else {
                                                        phi_2163_ = _e491.member_1;
                                                    }
                                                    let _e598 = phi_2163_;
                                                    let _e601 = (_e428 % 128u);
                                                    let _e602 = (_e601 < 128u);
                                                    if _e602 {
                                                    } else {
                                                        phi_2556_ = true;
                                                        break;
                                                    }
                                                    local_1[_e601] = _e598;
                                                    if _e602 {
                                                    } else {
                                                        phi_2556_ = true;
                                                        break;
                                                    }
                                                    local[_e601] = select(_e587, _e585, (_e585 > _e587));
                                                    if _e594 {
                                                        phi_2191_ = _e491.member_1;
                                                    } else {
                                                        phi_2191_ = _e491.member_2;
                                                    }
                                                    let _e609 = phi_2191_;
                                                    phi_2192_ = _e609;
                                                    phi_2193_ = (_e428 + 1u);
                                                } else {
                                                    phi_2192_ = u32();
                                                    phi_2193_ = u32();
                                                }
                                                let _e611 = phi_2192_;
                                                let _e613 = phi_2193_;
                                                phi_2195_ = _e611;
                                                phi_2196_ = _e613;
                                                phi_2197_ = select(true, false, _e593);
                                            } else {
                                                phi_2195_ = u32();
                                                phi_2196_ = u32();
                                                phi_2197_ = true;
                                            }
                                            let _e616 = phi_2195_;
                                            let _e618 = phi_2196_;
                                            let _e620 = phi_2197_;
                                            if _e620 {
                                                if _e592 {
                                                    phi_2206_ = _e491.member_1;
                                                } else {
                                                    phi_2206_ = _e491.member_2;
                                                }
                                                let _e624 = phi_2206_;
                                                phi_2211_ = _e624;
                                                phi_2212_ = select(_e593, true, _e592);
                                            } else {
                                                phi_2211_ = _e616;
                                                phi_2212_ = _e426;
                                            }
                                            let _e627 = phi_2211_;
                                            let _e629 = phi_2212_;
                                            phi_2560_ = _e398;
                                            phi_2214_ = type_48(_e400.member, (_e400.member_1 + 1u), _e400.member_2);
                                            phi_2215_ = _e627;
                                            phi_2216_ = _e629;
                                            phi_2217_ = select(_e618, _e428, _e620);
                                        }
                                        let _e1237 = phi_2560_;
                                        let _e1239 = phi_2214_;
                                        let _e1241 = phi_2215_;
                                        let _e1243 = phi_2216_;
                                        let _e1245 = phi_2217_;
                                        phi_2559_ = _e1237;
                                        phi_2218_ = _e1239;
                                        phi_2219_ = _e1241;
                                        phi_2220_ = (_e404 - 1u);
                                        phi_2221_ = _e1243;
                                        phi_2222_ = _e1245;
                                    } else {
                                        phi_2559_ = _e398;
                                        phi_2218_ = _e400;
                                        phi_2219_ = _e424;
                                        phi_2220_ = _e404;
                                        phi_2221_ = _e426;
                                        phi_2222_ = _e428;
                                    }
                                    let _e1247 = phi_2559_;
                                    let _e1249 = phi_2218_;
                                    let _e1251 = phi_2219_;
                                    let _e1253 = phi_2220_;
                                    let _e1255 = phi_2221_;
                                    let _e1257 = phi_2222_;
                                    phi_2558_ = _e1247;
                                    phi_2223_ = _e1249;
                                    phi_2224_ = _e1251;
                                    phi_2225_ = _e1253;
                                    phi_2226_ = _e1255;
                                    phi_2227_ = _e1257;
                                } else {
                                    phi_2558_ = _e398;
                                    phi_2223_ = type_48();
                                    phi_2224_ = u32();
                                    phi_2225_ = u32();
                                    phi_2226_ = bool();
                                    phi_2227_ = u32();
                                }
                                let _e1259 = phi_2558_;
                                let _e1261 = phi_2223_;
                                let _e1263 = phi_2224_;
                                let _e1265 = phi_2225_;
                                let _e1267 = phi_2226_;
                                let _e1269 = phi_2227_;
                                phi_2557_ = _e1259;
                                phi_674_ = _e1261;
                                phi_677_ = _e1263;
                                phi_679_ = _e1265;
                                phi_681_ = _e1267;
                                phi_683_ = _e1269;
                                phi_2228_ = _e412;
                            } else {
                                phi_2557_ = _e398;
                                phi_674_ = type_48();
                                phi_677_ = u32();
                                phi_679_ = u32();
                                phi_681_ = bool();
                                phi_683_ = u32();
                                phi_2228_ = false;
                            }
                            let _e1271 = phi_2557_;
                            let _e1273 = phi_674_;
                            let _e1275 = phi_677_;
                            let _e1277 = phi_679_;
                            let _e1279 = phi_681_;
                            let _e1281 = phi_683_;
                            let _e1283 = phi_2228_;
                            continue;
                            continuing {
                                phi_2420_ = _e1271;
                                phi_673_ = _e1273;
                                phi_676_ = _e1275;
                                phi_678_ = _e1277;
                                phi_680_ = _e1279;
                                phi_682_ = _e1281;
                                phi_2556_ = _e1271;
                                break if !(_e1283);
                            }
                        }
                        let _e1286 = phi_2556_;
                        if _e1286 {
                            break;
                        }
                        let _e1288 = local_2;
                        if (_e1288.member.member.member_3 != 4294967295u) {
                            let _e1294 = (_e209 / 3i);
                            let _e1301 = bitcast<f32>((bitcast<u32>((_e1294 + 127i)) << bitcast<u32>(23i)));
                            let _e1309 = (((_e1288.member.member.member * _e1301) * _e1301) * bitcast<f32>((bitcast<u32>(((_e209 - (2i * _e1294)) + 127i)) << bitcast<u32>(23i))));
                            let _e1311 = select(340282350000000000000000000000000000000f, _e1309, (_e1309 < 340282350000000000000000000000000000000f));
                            phi_2280_ = type_22(select(-340282350000000000000000000000000000000f, _e1311, (_e1311 > -340282350000000000000000000000000000000f)), _e1288.member.member.member_1, _e1288.member.member.member_2, _e1288.member.member.member_3);
                        } else {
                            phi_2280_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1318 = phi_2280_;
                        if _e85 {
                        } else {
                            break;
                        }
                        global_4.member[_e83] = _e1318;
                        let _e1322 = local_3;
                        if _e86 {
                        } else {
                            break;
                        }
                        global_5.member[_e83] = _e1322.member_1;
                        if _e84 {
                        } else {
                            break;
                        }
                        let _e1327 = select(0u, 1u, (_e153 <= _e163));
                        if (_e1327 > 0u) {
                            let _e1329 = (1u < _e79);
                            if _e1329 {
                                if (0u < _e79) {
                                } else {
                                    break;
                                }
                                let _e1333 = atomicAdd((&global_6.member[0u]), _e1327);
                                if ((_e1333 + _e1327) < _e1333) {
                                    if _e1329 {
                                    } else {
                                        break;
                                    }
                                    let _e1338 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1341 = select(0u, 1u, (_e1318.member_3 != 4294967295u));
                        if (_e1341 > 0u) {
                            let _e1343 = (3u < _e79);
                            if _e1343 {
                                if (2u < _e79) {
                                } else {
                                    break;
                                }
                                let _e1347 = atomicAdd((&global_6.member[2u]), _e1341);
                                if ((_e1347 + _e1341) < _e1347) {
                                    if _e1343 {
                                    } else {
                                        break;
                                    }
                                    let _e1352 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1322.member_1 > 0u) {
                            let _e1354 = (5u < _e79);
                            if _e1354 {
                                if (4u < _e79) {
                                } else {
                                    break;
                                }
                                let _e1358 = atomicAdd((&global_6.member[4u]), _e1322.member_1);
                                if ((_e1358 + _e1322.member_1) < _e1358) {
                                    if _e1354 {
                                    } else {
                                        break;
                                    }
                                    let _e1363 = atomicAdd((&global_6.member[5u]), 1u);
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
