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

struct type_23 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_24 {
    member: type_23,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_26 {
    member: array<type_24>,
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

struct type_36 {
    member: type_23,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_38 {
    member: array<type_36>,
}

struct type_47 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_48 {
    member: f32,
    member_1: bool,
}

struct type_52 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_1: type_15;
@group(0) @binding(0) 
var<storage> global_2: type_33;
@group(0) @binding(4) 
var<storage, read_write> global_3: type_52;
@group(0) @binding(2) 
var<storage> global_4: type_38;
@group(0) @binding(3) 
var<storage, read_write> global_5: type_26;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_185_: u32;
    var phi_334_: i32;
    var phi_335_: i32;
    var phi_345_: bool;
    var phi_355_: u32;
    var phi_356_: u32;
    var phi_358_: bool;
    var phi_363_: u32;
    var phi_395_: i32;
    var phi_413_: f32;
    var phi_419_: f32;
    var phi_430_: f32;
    var phi_436_: f32;
    var phi_459_: f32;
    var phi_470_: f32;
    var phi_479_: f32;
    var phi_485_: f32;
    var phi_496_: f32;
    var phi_502_: f32;
    var phi_525_: f32;
    var phi_536_: f32;
    var phi_545_: f32;
    var phi_551_: f32;
    var phi_562_: f32;
    var phi_568_: f32;
    var phi_591_: f32;
    var phi_602_: f32;
    var phi_702_: f32;
    var phi_703_: f32;
    var phi_2314_: bool;
    var phi_714_: type_48;
    var phi_717_: u32;
    var phi_719_: u32;
    var phi_721_: bool;
    var phi_723_: u32;
    var phi_734_: bool;
    var phi_766_: u32;
    var phi_767_: bool;
    var phi_768_: u32;
    var phi_1832_: type_47;
    var phi_2176_: u32;
    var phi_2204_: u32;
    var phi_2205_: u32;
    var phi_2206_: u32;
    var phi_2208_: u32;
    var phi_2209_: u32;
    var phi_2210_: bool;
    var phi_2219_: u32;
    var phi_2224_: u32;
    var phi_2225_: bool;
    var phi_783_: type_48;
    var phi_786_: type_7;
    var phi_787_: type_7;
    var phi_809_: type_7;
    var phi_830_: u32;
    var phi_919_: array<array<f32, 3>, 3>;
    var phi_1036_: bool;
    var phi_1065_: bool;
    var phi_1466_: f32;
    var phi_1467_: f32;
    var phi_1468_: f32;
    var phi_1469_: f32;
    var phi_1470_: vec3<f32>;
    var phi_1471_: vec3<f32>;
    var phi_1472_: vec3<f32>;
    var phi_1473_: vec3<f32>;
    var phi_1504_: bool;
    var phi_1513_: vec3<f32>;
    var phi_1678_: f32;
    var phi_1680_: f32;
    var phi_1681_: bool;
    var phi_1701_: f32;
    var phi_1702_: f32;
    var phi_1725_: type_22;
    var phi_1727_: type_22;
    var phi_1728_: bool;
    var phi_1732_: type_22;
    var phi_1733_: type_22;
    var phi_1734_: type_22;
    var phi_1735_: bool;
    var phi_1739_: type_22;
    var phi_1740_: bool;
    var phi_1741_: type_22;
    var phi_1742_: bool;
    var phi_1743_: bool;
    var phi_1744_: type_22;
    var phi_1745_: bool;
    var phi_1746_: bool;
    var phi_1754_: type_22;
    var phi_1755_: bool;
    var phi_1759_: type_22;
    var phi_1770_: type_48;
    var phi_1771_: type_48;
    var phi_784_: type_48;
    var phi_2308_: bool;
    var local_2: type_48;
    var phi_2455_: bool;
    var phi_2227_: type_48;
    var phi_2228_: u32;
    var phi_2229_: bool;
    var phi_2230_: u32;
    var phi_2454_: bool;
    var phi_2231_: type_48;
    var phi_2232_: u32;
    var phi_2233_: u32;
    var phi_2234_: bool;
    var phi_2235_: u32;
    var phi_2453_: bool;
    var phi_2236_: type_48;
    var phi_2237_: u32;
    var phi_2238_: u32;
    var phi_2239_: bool;
    var phi_2240_: u32;
    var phi_2452_: bool;
    var phi_715_: type_48;
    var phi_718_: u32;
    var phi_720_: u32;
    var phi_722_: bool;
    var phi_724_: u32;
    var phi_2241_: bool;
    var phi_2451_: bool;
    var local_3: type_48;
    var local_4: type_48;

    switch bitcast<i32>(0u) {
        default: {
            let _e66 = global;
            let _e68 = arrayLength((&global_2.member));
            let _e70 = arrayLength((&global_1.member));
            let _e76 = arrayLength((&global_3.member));
            let _e80 = (_e66.x + (_e66.y * 2097152u));
            let _e81 = (_e80 < arrayLength((&global_4.member)));
            if _e81 {
                if _e81 {
                } else {
                    break;
                }
                let _e85 = global_4.member[_e80].member_2;
                phi_185_ = _e85;
            } else {
                phi_185_ = 4294967295u;
            }
            let _e87 = phi_185_;
            if _e81 {
                let _e88 = (_e80 < arrayLength((&global_5.member)));
                if _e88 {
                    if _e81 {
                    } else {
                        break;
                    }
                    let _e93 = global_4.member[_e80].member.member_1;
                    let _e98 = global_4.member[_e80].member.member_3;
                    if (_e93 <= _e98) {
                        let _e100 = (1u < _e76);
                        if _e100 {
                            if (0u < _e76) {
                            } else {
                                break;
                            }
                            let _e104 = atomicAdd((&global_3.member[0u]), 1u);
                            if ((_e104 + 1u) < _e104) {
                                if _e100 {
                                } else {
                                    break;
                                }
                                let _e109 = atomicAdd((&global_3.member[1u]), 1u);
                            }
                        }
                        if _e81 {
                        } else {
                            break;
                        }
                        let _e119 = global_4.member[_e80].member.member_2[0u];
                        let _e121 = (bitcast<u32>(_e119) & 2147483647u);
                        let _e127 = global_4.member[_e80].member.member_2[1u];
                        let _e129 = (bitcast<u32>(_e127) & 2147483647u);
                        let _e135 = global_4.member[_e80].member.member_2[2u];
                        let _e137 = (bitcast<u32>(_e135) & 2147483647u);
                        let _e143 = global_4.member[_e80].member.member[0u];
                        let _e145 = (bitcast<u32>(_e143) & 2147483647u);
                        let _e151 = global_4.member[_e80].member.member[1u];
                        let _e153 = (bitcast<u32>(_e151) & 2147483647u);
                        let _e159 = global_4.member[_e80].member.member[2u];
                        let _e161 = (bitcast<u32>(_e159) & 2147483647u);
                        let _e163 = select(_e129, _e121, (_e129 < _e121));
                        let _e165 = select(_e137, _e163, (_e137 < _e163));
                        let _e167 = select(_e145, _e165, (_e145 < _e165));
                        let _e169 = select(_e153, _e167, (_e153 < _e167));
                        let _e171 = select(_e161, _e169, (_e161 < _e169));
                        let _e173 = (bitcast<u32>(_e93) & 2147483647u);
                        let _e182 = (((select(_e173, _e171, (_e173 < _e171)) < 2139095040u) && ((bitcast<u32>(_e98) & 2147483647u) <= 2139095040u)) && (_e165 > 0u));
                        if _e182 {
                            let _e185 = (bitcast<u32>(bitcast<f32>(_e165)) & 2147483647u);
                            if (_e185 >= 8388608u) {
                                phi_334_ = (bitcast<i32>((_e185 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_334_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e185)), 32u, (_e185 == 0u))));
                            }
                            let _e199 = phi_334_;
                            phi_335_ = _e199;
                        } else {
                            phi_335_ = 0i;
                        }
                        let _e201 = phi_335_;
                        let _e202 = (_e121 == _e165);
                        if _e202 {
                            phi_345_ = true;
                        } else {
                            phi_345_ = (_e129 == _e165);
                        }
                        let _e205 = phi_345_;
                        let _e206 = select(1u, 0u, _e202);
                        if _e205 {
                            let _e207 = (_e206 + 1u);
                            phi_355_ = _e207;
                            phi_356_ = _e207;
                            phi_358_ = select(true, false, (_e207 == 2u));
                        } else {
                            phi_355_ = u32();
                            phi_356_ = 0u;
                            phi_358_ = true;
                        }
                        let _e211 = phi_355_;
                        let _e213 = phi_356_;
                        let _e215 = phi_358_;
                        if _e215 {
                            phi_363_ = (_e213 + 1u);
                        } else {
                            phi_363_ = 0u;
                        }
                        let _e219 = phi_363_;
                        let _e220 = select(_e211, _e213, _e215);
                        let _e221 = select(_e206, select(2u, _e206, _e205), _e215);
                        let _e222 = -(_e201);
                        if (_e222 < -126i) {
                            phi_395_ = -126i;
                        } else {
                            phi_395_ = select(_e222, 127i, (_e222 > 127i));
                        }
                        let _e227 = phi_395_;
                        let _e232 = bitcast<f32>((bitcast<u32>((_e227 + 127i)) << bitcast<u32>(23i)));
                        let _e238 = bitcast<f32>((bitcast<u32>(((_e222 - _e227) + 127i)) << bitcast<u32>(23i)));
                        let _e243 = global_4.member[_e80].member.member;
                        let _e244 = (_e220 == 0u);
                        if _e244 {
                            phi_413_ = _e243[0];
                        } else {
                            phi_413_ = _e243[1];
                        }
                        let _e248 = phi_413_;
                        let _e249 = (_e220 == 2u);
                        if _e249 {
                            phi_419_ = _e243[2];
                        } else {
                            phi_419_ = _e248;
                        }
                        let _e252 = phi_419_;
                        let _e253 = global_4.member[_e80].member.member_2;
                        if _e244 {
                            phi_430_ = _e253[0];
                        } else {
                            phi_430_ = _e253[1];
                        }
                        let _e257 = phi_430_;
                        if _e249 {
                            phi_436_ = _e253[2];
                        } else {
                            phi_436_ = _e257;
                        }
                        let _e260 = phi_436_;
                        let _e262 = ((_e260 * _e232) * _e238);
                        let _e266 = (bitcast<f32>((bitcast<u32>(_e262) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e266 {
                            let _e270 = (bitcast<f32>((bitcast<u32>(_e252) & 2147483647u)) * 0.00000011920929f);
                            phi_459_ = select(0.00000000000011368684f, _e270, (_e270 > 0.00000000000011368684f));
                        } else {
                            phi_459_ = 0f;
                        }
                        let _e274 = phi_459_;
                        let _e275 = (_e252 + _e274);
                        let _e276 = (_e252 - _e274);
                        let _e277 = select(_e262, 0f, _e266);
                        if _e266 {
                            phi_470_ = 38685626000000000000000000f;
                        } else {
                            phi_470_ = (1f / _e262);
                        }
                        let _e280 = phi_470_;
                        let _e281 = (_e219 == 0u);
                        if _e281 {
                            phi_479_ = _e243[0];
                        } else {
                            phi_479_ = _e243[1];
                        }
                        let _e285 = phi_479_;
                        let _e286 = (_e219 == 2u);
                        if _e286 {
                            phi_485_ = _e243[2];
                        } else {
                            phi_485_ = _e285;
                        }
                        let _e289 = phi_485_;
                        if _e281 {
                            phi_496_ = _e253[0];
                        } else {
                            phi_496_ = _e253[1];
                        }
                        let _e293 = phi_496_;
                        if _e286 {
                            phi_502_ = _e253[2];
                        } else {
                            phi_502_ = _e293;
                        }
                        let _e296 = phi_502_;
                        let _e298 = ((_e296 * _e232) * _e238);
                        let _e302 = (bitcast<f32>((bitcast<u32>(_e298) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e302 {
                            let _e306 = (bitcast<f32>((bitcast<u32>(_e289) & 2147483647u)) * 0.00000011920929f);
                            phi_525_ = select(0.00000000000011368684f, _e306, (_e306 > 0.00000000000011368684f));
                        } else {
                            phi_525_ = 0f;
                        }
                        let _e310 = phi_525_;
                        let _e311 = (_e289 + _e310);
                        let _e312 = (_e289 - _e310);
                        let _e313 = select(_e298, 0f, _e302);
                        if _e302 {
                            phi_536_ = 38685626000000000000000000f;
                        } else {
                            phi_536_ = (1f / _e298);
                        }
                        let _e316 = phi_536_;
                        let _e317 = (_e221 == 0u);
                        if _e317 {
                            phi_545_ = _e243[0];
                        } else {
                            phi_545_ = _e243[1];
                        }
                        let _e321 = phi_545_;
                        let _e322 = (_e221 == 2u);
                        if _e322 {
                            phi_551_ = _e243[2];
                        } else {
                            phi_551_ = _e321;
                        }
                        let _e325 = phi_551_;
                        if _e317 {
                            phi_562_ = _e253[0];
                        } else {
                            phi_562_ = _e253[1];
                        }
                        let _e329 = phi_562_;
                        if _e322 {
                            phi_568_ = _e253[2];
                        } else {
                            phi_568_ = _e329;
                        }
                        let _e332 = phi_568_;
                        let _e334 = ((_e332 * _e232) * _e238);
                        let _e338 = (bitcast<f32>((bitcast<u32>(_e334) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e338 {
                            let _e342 = (bitcast<f32>((bitcast<u32>(_e325) & 2147483647u)) * 0.00000011920929f);
                            phi_591_ = select(0.00000000000011368684f, _e342, (_e342 > 0.00000000000011368684f));
                        } else {
                            phi_591_ = 0f;
                        }
                        let _e346 = phi_591_;
                        let _e347 = (_e325 + _e346);
                        let _e348 = (_e325 - _e346);
                        let _e349 = select(_e334, 0f, _e338);
                        if _e338 {
                            phi_602_ = 38685626000000000000000000f;
                        } else {
                            phi_602_ = (1f / _e334);
                        }
                        let _e352 = phi_602_;
                        let _e355 = bitcast<f32>((bitcast<u32>(_e252) & 2147483647u));
                        let _e358 = bitcast<f32>((bitcast<u32>(_e289) & 2147483647u));
                        let _e360 = select(_e358, _e355, (_e355 > _e358));
                        let _e363 = bitcast<f32>((bitcast<u32>(_e325) & 2147483647u));
                        if (_e182 && (select(_e363, _e360, (_e360 > _e363)) <= 1099511600000f)) {
                            let _e368 = (_e201 / 3i);
                            let _e375 = bitcast<f32>((bitcast<u32>((_e368 + 127i)) << bitcast<u32>(23i)));
                            let _e382 = bitcast<f32>((bitcast<u32>(((_e201 - (2i * _e368)) + 127i)) << bitcast<u32>(23i)));
                            let _e383 = (((_e93 * _e375) * _e375) * _e382);
                            let _e385 = select(340282350000000000000000000000000000000f, _e383, (_e383 < 340282350000000000000000000000000000000f));
                            let _e390 = (((_e98 * _e375) * _e375) * _e382);
                            let _e392 = select(340282350000000000000000000000000000000f, _e390, (_e390 < 340282350000000000000000000000000000000f));
                            phi_702_ = select(-340282350000000000000000000000000000000f, _e392, (_e392 > -340282350000000000000000000000000000000f));
                            phi_703_ = select(-340282350000000000000000000000000000000f, _e385, (_e385 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_702_ = 0f;
                            phi_703_ = 1f;
                        }
                        let _e396 = phi_702_;
                        let _e398 = phi_703_;
                        local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        phi_2314_ = false;
                        phi_714_ = type_48(_e396, false);
                        phi_717_ = select(0u, 2147483648u, (_e68 == 0u));
                        phi_719_ = ((3u * _e68) + 1u);
                        phi_721_ = (_e398 <= _e396);
                        phi_723_ = 0u;
                        loop {
                            let _e406 = phi_2314_;
                            let _e408 = phi_714_;
                            let _e410 = phi_717_;
                            let _e412 = phi_719_;
                            let _e414 = phi_721_;
                            let _e416 = phi_723_;
                            local_3 = _e408;
                            if _e414 {
                                phi_734_ = true;
                            } else {
                                phi_734_ = (_e416 > 0u);
                            }
                            let _e419 = phi_734_;
                            if _e419 {
                                let _e420 = (_e412 > 0u);
                                if _e420 {
                                    if _e414 {
                                        phi_766_ = _e410;
                                        phi_767_ = _e414;
                                        phi_768_ = _e416;
                                    } else {
                                        let _e421 = (_e416 - 1u);
                                        let _e422 = (_e421 % 128u);
                                        let _e423 = (_e422 < 128u);
                                        if _e423 {
                                        } else {
                                            phi_2451_ = true;
                                            break;
                                        }
                                        let _e425 = local_1[_e422];
                                        if _e423 {
                                        } else {
                                            phi_2451_ = true;
                                            break;
                                        }
                                        let _e427 = local[_e422];
                                        phi_766_ = _e425;
                                        phi_767_ = (_e427 <= _e408.member);
                                        phi_768_ = _e421;
                                    }
                                    let _e431 = phi_766_;
                                    let _e433 = phi_767_;
                                    let _e435 = phi_768_;
                                    if _e433 {
                                        if ((_e431 & 2147483648u) != 0u) {
                                            phi_783_ = _e408;
                                            phi_786_ = type_7(0u, ((_e431 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e633 = phi_783_;
                                                let _e635 = phi_786_;
                                                local_2 = _e633;
                                                local_4 = _e633;
                                                if (_e635.member < _e635.member_1) {
                                                    phi_787_ = type_7((_e635.member + 1u), _e635.member_1);
                                                    phi_809_ = type_7(1u, _e635.member);
                                                } else {
                                                    phi_787_ = _e635;
                                                    phi_809_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e648 = phi_787_;
                                                let _e650 = phi_809_;
                                                let _e654 = (bitcast<i32>(_e650.member) != 0i);
                                                if _e654 {
                                                    let _e655 = ((_e431 & 268435455u) + _e650.member_1);
                                                    let _e656 = (_e655 < _e70);
                                                    if _e656 {
                                                        if _e656 {
                                                        } else {
                                                            phi_2308_ = true;
                                                            break;
                                                        }
                                                        let _e660 = global_1.member[_e655].member_1;
                                                        phi_830_ = _e660;
                                                    } else {
                                                        phi_830_ = 4294967295u;
                                                    }
                                                    let _e662 = phi_830_;
                                                    if (_e655 >= _e70) {
                                                        phi_919_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e656 {
                                                        } else {
                                                            phi_2308_ = true;
                                                            break;
                                                        }
                                                        let _e664 = (_e220 % 3u);
                                                        let _e665 = (_e219 % 3u);
                                                        let _e666 = (_e221 % 3u);
                                                        if (_e664 < 9u) {
                                                        } else {
                                                            phi_2308_ = true;
                                                            break;
                                                        }
                                                        let _e672 = global_1.member[_e655].member[_e664];
                                                        if (_e665 < 9u) {
                                                        } else {
                                                            phi_2308_ = true;
                                                            break;
                                                        }
                                                        let _e678 = global_1.member[_e655].member[_e665];
                                                        if (_e666 < 9u) {
                                                        } else {
                                                            phi_2308_ = true;
                                                            break;
                                                        }
                                                        let _e684 = global_1.member[_e655].member[_e666];
                                                        let _e686 = (3u + _e664);
                                                        if (_e686 < 9u) {
                                                        } else {
                                                            phi_2308_ = true;
                                                            break;
                                                        }
                                                        let _e692 = global_1.member[_e655].member[_e686];
                                                        let _e693 = (3u + _e665);
                                                        if (_e693 < 9u) {
                                                        } else {
                                                            phi_2308_ = true;
                                                            break;
                                                        }
                                                        let _e699 = global_1.member[_e655].member[_e693];
                                                        let _e700 = (3u + _e666);
                                                        if (_e700 < 9u) {
                                                        } else {
                                                            phi_2308_ = true;
                                                            break;
                                                        }
                                                        let _e706 = global_1.member[_e655].member[_e700];
                                                        let _e708 = (6u + _e664);
                                                        if (_e708 < 9u) {
                                                        } else {
                                                            phi_2308_ = true;
                                                            break;
                                                        }
                                                        let _e714 = global_1.member[_e655].member[_e708];
                                                        let _e715 = (6u + _e665);
                                                        if (_e715 < 9u) {
                                                        } else {
                                                            phi_2308_ = true;
                                                            break;
                                                        }
                                                        let _e721 = global_1.member[_e655].member[_e715];
                                                        let _e722 = (6u + _e666);
                                                        if (_e722 < 9u) {
                                                        } else {
                                                            phi_2308_ = true;
                                                            break;
                                                        }
                                                        let _e728 = global_1.member[_e655].member[_e722];
                                                        phi_919_ = array<array<f32, 3>, 3>(array<f32, 3>(_e672, _e678, _e684), array<f32, 3>(_e692, _e699, _e706), array<f32, 3>(_e714, _e721, _e728));
                                                    }
                                                    let _e732 = phi_919_;
                                                    let _e740 = (_e732[0][2] - _e325);
                                                    let _e743 = (((_e732[0][0] - _e252) * _e349) - (_e740 * _e277));
                                                    let _e746 = (((_e732[0][1] - _e289) * _e349) - (_e740 * _e313));
                                                    let _e753 = (_e732[1][2] - _e325);
                                                    let _e756 = (((_e732[1][0] - _e252) * _e349) - (_e753 * _e277));
                                                    let _e759 = (((_e732[1][1] - _e289) * _e349) - (_e753 * _e313));
                                                    let _e766 = (_e732[2][2] - _e325);
                                                    let _e769 = (((_e732[2][0] - _e252) * _e349) - (_e766 * _e277));
                                                    let _e772 = (((_e732[2][1] - _e289) * _e349) - (_e766 * _e313));
                                                    let _e773 = (_e769 * _e759);
                                                    let _e774 = (_e772 * _e756);
                                                    let _e775 = (_e743 * _e772);
                                                    let _e776 = (_e746 * _e769);
                                                    let _e777 = (_e756 * _e746);
                                                    let _e778 = (_e759 * _e743);
                                                    let _e783 = (((_e773 >= _e774) && (_e775 >= _e776)) && (_e777 >= _e778));
                                                    if (_e783 || (((_e773 <= _e774) && (_e775 <= _e776)) && (_e777 <= _e778))) {
                                                        let _e790 = select(-1f, 1f, _e783);
                                                        let _e792 = ((_e773 - _e774) * _e790);
                                                        let _e794 = select(0f, _e792, (_e792 > 0f));
                                                        let _e796 = ((_e775 - _e776) * _e790);
                                                        let _e798 = select(0f, _e796, (_e796 > 0f));
                                                        let _e800 = ((_e777 - _e778) * _e790);
                                                        let _e802 = select(0f, _e800, (_e800 > 0f));
                                                        let _e804 = ((_e794 + _e798) + _e802);
                                                        if (_e804 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1744_ = type_22();
                                                            phi_1745_ = true;
                                                            phi_1746_ = false;
                                                        } else {
                                                            let _e807 = select(_e756, _e743, (_e743 < _e756));
                                                            if (select(_e769, _e807, (_e807 < _e769)) > 0f) {
                                                                phi_1036_ = true;
                                                            } else {
                                                                let _e812 = select(_e756, _e743, (_e743 > _e756));
                                                                phi_1036_ = (select(_e769, _e812, (_e812 > _e769)) < 0f);
                                                            }
                                                            let _e817 = phi_1036_;
                                                            if _e817 {
                                                                phi_1741_ = type_22();
                                                                phi_1742_ = true;
                                                                phi_1743_ = false;
                                                            } else {
                                                                let _e819 = select(_e759, _e746, (_e746 < _e759));
                                                                if (select(_e772, _e819, (_e819 < _e772)) > 0f) {
                                                                    phi_1065_ = true;
                                                                } else {
                                                                    let _e824 = select(_e759, _e746, (_e746 > _e759));
                                                                    phi_1065_ = (select(_e772, _e824, (_e824 > _e772)) < 0f);
                                                                }
                                                                let _e829 = phi_1065_;
                                                                if _e829 {
                                                                    phi_1739_ = type_22();
                                                                    phi_1740_ = false;
                                                                } else {
                                                                    let _e831 = select(_e732[1][0], _e732[0][0], (_e732[0][0] < _e732[1][0]));
                                                                    let _e835 = select(_e732[1][0], _e732[0][0], (_e732[0][0] > _e732[1][0]));
                                                                    let _e839 = select(_e732[1][1], _e732[0][1], (_e732[0][1] < _e732[1][1]));
                                                                    let _e843 = select(_e732[1][1], _e732[0][1], (_e732[0][1] > _e732[1][1]));
                                                                    let _e847 = select(_e732[1][2], _e732[0][2], (_e732[0][2] < _e732[1][2]));
                                                                    let _e851 = select(_e732[1][2], _e732[0][2], (_e732[0][2] > _e732[1][2]));
                                                                    let _e856 = ((select(_e732[2][0], _e831, (_e831 < _e732[2][0])) - _e275) * _e280);
                                                                    let _e857 = ((select(_e732[2][0], _e835, (_e835 > _e732[2][0])) - _e276) * _e280);
                                                                    let _e860 = ((select(_e732[2][1], _e839, (_e839 < _e732[2][1])) - _e311) * _e316);
                                                                    let _e861 = ((select(_e732[2][1], _e843, (_e843 > _e732[2][1])) - _e312) * _e316);
                                                                    let _e864 = ((select(_e732[2][2], _e847, (_e847 < _e732[2][2])) - _e347) * _e352);
                                                                    let _e865 = ((select(_e732[2][2], _e851, (_e851 > _e732[2][2])) - _e348) * _e352);
                                                                    let _e867 = select(_e865, _e864, (_e864 < _e865));
                                                                    let _e869 = select(_e865, _e864, (_e864 > _e865));
                                                                    let _e871 = select(_e857, _e856, (_e856 < _e857));
                                                                    let _e873 = select(_e861, _e860, (_e860 < _e861));
                                                                    let _e875 = select(_e873, _e871, (_e871 > _e873));
                                                                    let _e877 = select(_e867, _e875, (_e875 > _e867));
                                                                    let _e879 = select(_e857, _e856, (_e856 > _e857));
                                                                    let _e881 = select(_e861, _e860, (_e860 > _e861));
                                                                    let _e883 = select(_e881, _e879, (_e879 < _e881));
                                                                    let _e885 = select(_e869, _e883, (_e883 < _e869));
                                                                    let _e886 = -(_e867);
                                                                    let _e892 = select(_e398, _e877, (_e877 > _e398));
                                                                    if (_e892 > (_e885 + (select(_e886, _e869, (_e869 > _e886)) * 0.0000019073523f))) {
                                                                        phi_1734_ = type_22();
                                                                        phi_1735_ = true;
                                                                    } else {
                                                                        let _e894 = (_e892 > _e633.member);
                                                                        if _e894 {
                                                                            phi_1733_ = type_22();
                                                                        } else {
                                                                            let _e895 = vec3<f32>(_e732[0][0], _e732[0][1], _e732[0][2]);
                                                                            let _e896 = vec3<f32>(_e732[1][0], _e732[1][1], _e732[1][2]);
                                                                            let _e897 = vec3<f32>(_e732[2][0], _e732[2][1], _e732[2][2]);
                                                                            let _e898 = (_e732[1][0] - _e732[0][0]);
                                                                            let _e899 = (_e732[1][1] - _e732[0][1]);
                                                                            let _e900 = (_e732[1][2] - _e732[0][2]);
                                                                            let _e901 = vec3<f32>(_e898, _e899, _e900);
                                                                            let _e902 = (_e732[2][0] - _e732[1][0]);
                                                                            let _e903 = (_e732[2][1] - _e732[1][1]);
                                                                            let _e904 = (_e732[2][2] - _e732[1][2]);
                                                                            let _e905 = vec3<f32>(_e902, _e903, _e904);
                                                                            let _e906 = (_e732[0][0] - _e732[2][0]);
                                                                            let _e907 = (_e732[0][1] - _e732[2][1]);
                                                                            let _e908 = (_e732[0][2] - _e732[2][2]);
                                                                            let _e909 = vec3<f32>(_e906, _e907, _e908);
                                                                            let _e912 = bitcast<f32>((bitcast<u32>(_e898) & 2147483647u));
                                                                            let _e915 = bitcast<f32>((bitcast<u32>(_e899) & 2147483647u));
                                                                            let _e917 = select(_e915, _e912, (_e912 > _e915));
                                                                            let _e920 = bitcast<f32>((bitcast<u32>(_e900) & 2147483647u));
                                                                            let _e922 = select(_e920, _e917, (_e917 > _e920));
                                                                            let _e925 = bitcast<f32>((bitcast<u32>(_e902) & 2147483647u));
                                                                            let _e928 = bitcast<f32>((bitcast<u32>(_e903) & 2147483647u));
                                                                            let _e930 = select(_e928, _e925, (_e925 > _e928));
                                                                            let _e933 = bitcast<f32>((bitcast<u32>(_e904) & 2147483647u));
                                                                            let _e935 = select(_e933, _e930, (_e930 > _e933));
                                                                            let _e938 = bitcast<f32>((bitcast<u32>(_e906) & 2147483647u));
                                                                            let _e941 = bitcast<f32>((bitcast<u32>(_e907) & 2147483647u));
                                                                            let _e943 = select(_e941, _e938, (_e938 > _e941));
                                                                            let _e946 = bitcast<f32>((bitcast<u32>(_e908) & 2147483647u));
                                                                            let _e948 = select(_e946, _e943, (_e943 > _e946));
                                                                            let _e950 = select(_e935, _e922, (_e922 > _e935));
                                                                            let _e952 = select(_e948, _e950, (_e950 > _e948));
                                                                            if (_e922 == _e952) {
                                                                                phi_1466_ = _e759;
                                                                                phi_1467_ = _e756;
                                                                                phi_1468_ = _e746;
                                                                                phi_1469_ = _e743;
                                                                                phi_1470_ = _e895;
                                                                                phi_1471_ = _e909;
                                                                                phi_1472_ = _e905;
                                                                                phi_1473_ = _e901;
                                                                            } else {
                                                                                let _e954 = (_e935 == _e952);
                                                                                let _e959 = vec3(_e954);
                                                                                phi_1466_ = select(_e746, _e772, _e954);
                                                                                phi_1467_ = select(_e743, _e769, _e954);
                                                                                phi_1468_ = select(_e772, _e759, _e954);
                                                                                phi_1469_ = select(_e769, _e756, _e954);
                                                                                phi_1470_ = select(_e897, _e896, _e959);
                                                                                phi_1471_ = select(_e905, _e901, _e959);
                                                                                phi_1472_ = select(_e901, _e909, _e959);
                                                                                phi_1473_ = select(_e909, _e905, _e959);
                                                                            }
                                                                            let _e965 = phi_1466_;
                                                                            let _e967 = phi_1467_;
                                                                            let _e969 = phi_1468_;
                                                                            let _e971 = phi_1469_;
                                                                            let _e973 = phi_1470_;
                                                                            let _e975 = phi_1471_;
                                                                            let _e977 = phi_1472_;
                                                                            let _e979 = phi_1473_;
                                                                            let _e986 = ((_e977.y * _e975.z) - (_e975.y * _e977.z));
                                                                            let _e991 = ((_e977.z * _e975.x) - (_e975.z * _e977.x));
                                                                            let _e994 = ((_e977.x * _e975.y) - (_e975.x * _e977.y));
                                                                            if (_e794 >= _e798) {
                                                                                phi_1504_ = select(true, false, (_e794 >= _e802));
                                                                            } else {
                                                                                phi_1504_ = true;
                                                                            }
                                                                            let _e999 = phi_1504_;
                                                                            if _e999 {
                                                                                phi_1513_ = select(_e897, _e896, vec3((_e798 >= _e802)));
                                                                            } else {
                                                                                phi_1513_ = _e895;
                                                                            }
                                                                            let _e1004 = phi_1513_;
                                                                            let _e1015 = (((_e986 * (_e1004.x - _e252)) + (_e991 * (_e1004.y - _e289))) + (_e994 * (_e1004.z - _e325)));
                                                                            let _e1020 = (((_e986 * _e277) + (_e991 * _e313)) + (_e994 * _e349));
                                                                            let _e1021 = (_e967 - _e971);
                                                                            let _e1022 = (_e965 - _e969);
                                                                            let _e1030 = (-(((_e971 * _e1021) + (_e969 * _e1022))) / ((_e1021 * _e1021) + (_e1022 * _e1022)));
                                                                            let _e1032 = select(1f, _e1030, (_e1030 < 1f));
                                                                            let _e1034 = select(0f, _e1032, (_e1032 > 0f));
                                                                            let _e1047 = ((_e973.x + (_e979.x * _e1034)) - _e252);
                                                                            let _e1048 = ((_e973.y + (_e979.y * _e1034)) - _e289);
                                                                            let _e1049 = ((_e973.z + (_e979.z * _e1034)) - _e325);
                                                                            let _e1050 = (_e1049 / _e349);
                                                                            let _e1062 = bitcast<f32>((bitcast<u32>(_e1047) & 2147483647u));
                                                                            let _e1065 = bitcast<f32>((bitcast<u32>(_e1048) & 2147483647u));
                                                                            let _e1067 = select(_e1065, _e1062, (_e1062 > _e1065));
                                                                            let _e1070 = bitcast<f32>((bitcast<u32>(_e1049) & 2147483647u));
                                                                            let _e1072 = select(_e1070, _e1067, (_e1067 > _e1070));
                                                                            let _e1078 = bitcast<f32>((bitcast<u32>(_e986) & 2147483647u));
                                                                            let _e1081 = bitcast<f32>((bitcast<u32>(_e991) & 2147483647u));
                                                                            let _e1083 = select(_e1081, _e1078, (_e1078 > _e1081));
                                                                            let _e1086 = bitcast<f32>((bitcast<u32>(_e994) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e986 * _e1047) + (_e991 * _e1048)) + (_e994 * _e1049)) - _e1015)) & 2147483647u)) <= ((0.0000009536743f * select(_e952, _e1072, (_e1072 > _e952))) * select(_e1086, _e1083, (_e1083 > _e1086)))) {
                                                                                let _e1096 = bitcast<f32>((bitcast<u32>(_e977.x) & 2147483647u));
                                                                                let _e1099 = bitcast<f32>((bitcast<u32>(_e977.y) & 2147483647u));
                                                                                let _e1101 = select(_e1099, _e1096, (_e1096 > _e1099));
                                                                                let _e1104 = bitcast<f32>((bitcast<u32>(_e977.z) & 2147483647u));
                                                                                let _e1110 = bitcast<f32>((bitcast<u32>(_e975.x) & 2147483647u));
                                                                                let _e1113 = bitcast<f32>((bitcast<u32>(_e975.y) & 2147483647u));
                                                                                let _e1115 = select(_e1113, _e1110, (_e1110 > _e1113));
                                                                                let _e1118 = bitcast<f32>((bitcast<u32>(_e975.z) & 2147483647u));
                                                                                let _e1122 = (bitcast<f32>((bitcast<u32>(_e1020) & 2147483647u)) > ((0.0000038146973f * select(_e1104, _e1101, (_e1101 > _e1104))) * select(_e1118, _e1115, (_e1115 > _e1118))));
                                                                                if _e1122 {
                                                                                    phi_1678_ = (_e1015 / _e1020);
                                                                                } else {
                                                                                    phi_1678_ = f32();
                                                                                }
                                                                                let _e1125 = phi_1678_;
                                                                                phi_1680_ = _e1125;
                                                                                phi_1681_ = select(true, false, _e1122);
                                                                            } else {
                                                                                phi_1680_ = f32();
                                                                                phi_1681_ = true;
                                                                            }
                                                                            let _e1128 = phi_1680_;
                                                                            let _e1130 = phi_1681_;
                                                                            if _e1130 {
                                                                                let _e1138 = (((_e986 * (_e1047 - (_e277 * _e1050))) + (_e991 * (_e1048 - (_e313 * _e1050)))) / _e1020);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1138) & 2147483647u)) <= _e952) {
                                                                                    phi_1701_ = (_e1050 + _e1138);
                                                                                } else {
                                                                                    phi_1701_ = _e1050;
                                                                                }
                                                                                let _e1145 = phi_1701_;
                                                                                phi_1702_ = _e1145;
                                                                            } else {
                                                                                phi_1702_ = _e1128;
                                                                            }
                                                                            let _e1147 = phi_1702_;
                                                                            let _e1149 = select(_e885, _e1147, (_e1147 < _e885));
                                                                            let _e1151 = select(_e877, _e1149, (_e1149 > _e877));
                                                                            if (_e1151 >= _e398) {
                                                                                let _e1153 = (_e1151 <= _e633.member);
                                                                                if _e1153 {
                                                                                    let _e1154 = (1f / _e804);
                                                                                    phi_1725_ = type_22(_e1151, (_e798 * _e1154), (_e802 * _e1154), _e662);
                                                                                } else {
                                                                                    phi_1725_ = type_22();
                                                                                }
                                                                                let _e1159 = phi_1725_;
                                                                                phi_1727_ = _e1159;
                                                                                phi_1728_ = select(true, false, _e1153);
                                                                            } else {
                                                                                phi_1727_ = type_22();
                                                                                phi_1728_ = true;
                                                                            }
                                                                            let _e1162 = phi_1727_;
                                                                            let _e1164 = phi_1728_;
                                                                            if _e1164 {
                                                                                phi_1732_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_1732_ = _e1162;
                                                                            }
                                                                            let _e1166 = phi_1732_;
                                                                            phi_1733_ = _e1166;
                                                                        }
                                                                        let _e1168 = phi_1733_;
                                                                        phi_1734_ = _e1168;
                                                                        phi_1735_ = _e894;
                                                                    }
                                                                    let _e1170 = phi_1734_;
                                                                    let _e1172 = phi_1735_;
                                                                    phi_1739_ = _e1170;
                                                                    phi_1740_ = _e1172;
                                                                }
                                                                let _e1174 = phi_1739_;
                                                                let _e1176 = phi_1740_;
                                                                phi_1741_ = _e1174;
                                                                phi_1742_ = _e829;
                                                                phi_1743_ = _e1176;
                                                            }
                                                            let _e1178 = phi_1741_;
                                                            let _e1180 = phi_1742_;
                                                            let _e1182 = phi_1743_;
                                                            phi_1744_ = _e1178;
                                                            phi_1745_ = _e1180;
                                                            phi_1746_ = _e1182;
                                                        }
                                                        let _e1184 = phi_1744_;
                                                        let _e1186 = phi_1745_;
                                                        let _e1188 = phi_1746_;
                                                        phi_1754_ = _e1184;
                                                        phi_1755_ = select(_e1188, true, _e1186);
                                                    } else {
                                                        phi_1754_ = type_22();
                                                        phi_1755_ = true;
                                                    }
                                                    let _e1191 = phi_1754_;
                                                    let _e1193 = phi_1755_;
                                                    if _e1193 {
                                                        phi_1759_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1759_ = _e1191;
                                                    }
                                                    let _e1195 = phi_1759_;
                                                    if (_e1195.member_3 != 4294967295u) {
                                                        if (_e662 != _e87) {
                                                            phi_1770_ = type_48(_e633.member, true);
                                                        } else {
                                                            phi_1770_ = _e633;
                                                        }
                                                        let _e1203 = phi_1770_;
                                                        phi_1771_ = _e1203;
                                                    } else {
                                                        phi_1771_ = _e633;
                                                    }
                                                    let _e1205 = phi_1771_;
                                                    phi_784_ = _e1205;
                                                } else {
                                                    phi_784_ = type_48();
                                                }
                                                let _e1207 = phi_784_;
                                                continue;
                                                continuing {
                                                    phi_783_ = _e1207;
                                                    phi_786_ = _e648;
                                                    phi_2308_ = _e406;
                                                    break if !(_e654);
                                                }
                                            }
                                            let _e1210 = phi_2308_;
                                            phi_2451_ = _e1210;
                                            if _e1210 {
                                                break;
                                            }
                                            let _e1212 = local_2;
                                            phi_2455_ = _e1210;
                                            let _e1397 = local_4;
                                            phi_2227_ = _e1397;
                                            phi_2228_ = _e431;
                                            phi_2229_ = false;
                                            phi_2230_ = select(_e435, 0u, _e1212.member_1);
                                        } else {
                                            if (_e431 >= _e68) {
                                                phi_1832_ = type_47(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                            } else {
                                                if (_e431 < _e68) {
                                                } else {
                                                    phi_2451_ = true;
                                                    break;
                                                }
                                                let _e445 = (_e220 % 3u);
                                                if (_e445 < 3u) {
                                                } else {
                                                    phi_2451_ = true;
                                                    break;
                                                }
                                                let _e451 = global_2.member[_e431].member[_e445];
                                                let _e457 = (_e219 % 3u);
                                                if (_e457 < 3u) {
                                                } else {
                                                    phi_2451_ = true;
                                                    break;
                                                }
                                                let _e463 = global_2.member[_e431].member[_e457];
                                                let _e469 = (_e221 % 3u);
                                                if (_e469 < 3u) {
                                                } else {
                                                    phi_2451_ = true;
                                                    break;
                                                }
                                                let _e475 = global_2.member[_e431].member[_e469];
                                                let _e485 = global_2.member[_e431].member_1;
                                                let _e489 = global_2.member[_e431].member_2;
                                                phi_1832_ = type_47(array<vec4<f32>, 3>(vec4<f32>(_e451[0], _e451[1], _e451[2], _e451[3]), vec4<f32>(_e463[0], _e463[1], _e463[2], _e463[3]), vec4<f32>(_e475[0], _e475[1], _e475[2], _e475[3])), _e485, _e489);
                                            }
                                            let _e492 = phi_1832_;
                                            let _e504 = ((_e492.member[0].x - _e275) * _e280);
                                            let _e505 = ((_e492.member[0].y - _e275) * _e280);
                                            let _e506 = ((_e492.member[0].z - _e276) * _e280);
                                            let _e507 = ((_e492.member[0].w - _e276) * _e280);
                                            let _e517 = ((_e492.member[1].x - _e311) * _e316);
                                            let _e518 = ((_e492.member[1].y - _e311) * _e316);
                                            let _e519 = ((_e492.member[1].z - _e312) * _e316);
                                            let _e520 = ((_e492.member[1].w - _e312) * _e316);
                                            let _e530 = ((_e492.member[2].x - _e347) * _e352);
                                            let _e531 = ((_e492.member[2].y - _e347) * _e352);
                                            let _e532 = ((_e492.member[2].z - _e348) * _e352);
                                            let _e533 = ((_e492.member[2].w - _e348) * _e352);
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
                                            let _e585 = select(_e398, _e555, (_e555 > _e398));
                                            let _e587 = select(_e398, _e557, (_e557 > _e398));
                                            let _e592 = (_e585 <= select(_e408.member, _e582, (_e582 < _e408.member)));
                                            let _e593 = (_e587 <= select(_e408.member, _e583, (_e583 < _e408.member)));
                                            let _e594 = (_e585 <= _e587);
                                            if _e592 {
                                                if _e593 {
                                                    if _e594 {
                                                        phi_2176_ = _e492.member_2;
                                                    } else {
                                                        phi_2176_ = _e492.member_1;
                                                    }
                                                    let _e598 = phi_2176_;
                                                    let _e601 = (_e435 % 128u);
                                                    let _e602 = (_e601 < 128u);
                                                    if _e602 {
                                                    } else {
                                                        phi_2451_ = true;
                                                        break;
                                                    }
                                                    local_1[_e601] = _e598;
                                                    if _e602 {
                                                    } else {
                                                        phi_2451_ = true;
                                                        break;
                                                    }
                                                    local[_e601] = select(_e587, _e585, (_e585 > _e587));
                                                    if _e594 {
                                                        phi_2204_ = _e492.member_1;
                                                    } else {
                                                        phi_2204_ = _e492.member_2;
                                                    }
                                                    let _e609 = phi_2204_;
                                                    phi_2205_ = _e609;
                                                    phi_2206_ = (_e435 + 1u);
                                                } else {
                                                    phi_2205_ = u32();
                                                    phi_2206_ = u32();
                                                }
                                                let _e611 = phi_2205_;
                                                let _e613 = phi_2206_;
                                                phi_2208_ = _e611;
                                                phi_2209_ = _e613;
                                                phi_2210_ = select(true, false, _e593);
                                            } else {
                                                phi_2208_ = u32();
                                                phi_2209_ = u32();
                                                phi_2210_ = true;
                                            }
                                            let _e616 = phi_2208_;
                                            let _e618 = phi_2209_;
                                            let _e620 = phi_2210_;
                                            if _e620 {
                                                if _e592 {
                                                    phi_2219_ = _e492.member_1;
                                                } else {
                                                    phi_2219_ = _e492.member_2;
                                                }
                                                let _e624 = phi_2219_;
                                                phi_2224_ = _e624;
                                                phi_2225_ = select(_e593, true, _e592);
                                            } else {
                                                phi_2224_ = _e616;
                                                phi_2225_ = _e433;
                                            }
                                            let _e627 = phi_2224_;
                                            let _e629 = phi_2225_;
                                            phi_2455_ = _e406;
                                            phi_2227_ = _e408;
                                            phi_2228_ = _e627;
                                            phi_2229_ = _e629;
                                            phi_2230_ = select(_e618, _e435, _e620);
                                        }
                                        let _e1216 = phi_2455_;
                                        let _e1218 = phi_2227_;
                                        let _e1220 = phi_2228_;
                                        let _e1222 = phi_2229_;
                                        let _e1224 = phi_2230_;
                                        phi_2454_ = _e1216;
                                        phi_2231_ = _e1218;
                                        phi_2232_ = _e1220;
                                        phi_2233_ = (_e412 - 1u);
                                        phi_2234_ = _e1222;
                                        phi_2235_ = _e1224;
                                    } else {
                                        phi_2454_ = _e406;
                                        phi_2231_ = _e408;
                                        phi_2232_ = _e431;
                                        phi_2233_ = _e412;
                                        phi_2234_ = _e433;
                                        phi_2235_ = _e435;
                                    }
                                    let _e1226 = phi_2454_;
                                    let _e1228 = phi_2231_;
                                    let _e1230 = phi_2232_;
                                    let _e1232 = phi_2233_;
                                    let _e1234 = phi_2234_;
                                    let _e1236 = phi_2235_;
                                    phi_2453_ = _e1226;
                                    phi_2236_ = _e1228;
                                    phi_2237_ = _e1230;
                                    phi_2238_ = _e1232;
                                    phi_2239_ = _e1234;
                                    phi_2240_ = _e1236;
                                } else {
                                    phi_2453_ = _e406;
                                    phi_2236_ = type_48();
                                    phi_2237_ = u32();
                                    phi_2238_ = u32();
                                    phi_2239_ = bool();
                                    phi_2240_ = u32();
                                }
                                let _e1238 = phi_2453_;
                                let _e1240 = phi_2236_;
                                let _e1242 = phi_2237_;
                                let _e1244 = phi_2238_;
                                let _e1246 = phi_2239_;
                                let _e1248 = phi_2240_;
                                phi_2452_ = _e1238;
                                phi_715_ = _e1240;
                                phi_718_ = _e1242;
                                phi_720_ = _e1244;
                                phi_722_ = _e1246;
                                phi_724_ = _e1248;
                                phi_2241_ = _e420;
                            } else {
                                phi_2452_ = _e406;
                                phi_715_ = type_48();
                                phi_718_ = u32();
                                phi_720_ = u32();
                                phi_722_ = bool();
                                phi_724_ = u32();
                                phi_2241_ = false;
                            }
                            let _e1250 = phi_2452_;
                            let _e1252 = phi_715_;
                            let _e1254 = phi_718_;
                            let _e1256 = phi_720_;
                            let _e1258 = phi_722_;
                            let _e1260 = phi_724_;
                            let _e1262 = phi_2241_;
                            continue;
                            continuing {
                                phi_2314_ = _e1250;
                                phi_714_ = _e1252;
                                phi_717_ = _e1254;
                                phi_719_ = _e1256;
                                phi_721_ = _e1258;
                                phi_723_ = _e1260;
                                phi_2451_ = _e1250;
                                break if !(_e1262);
                            }
                        }
                        let _e1265 = phi_2451_;
                        if _e1265 {
                            break;
                        }
                        let _e1267 = local_3;
                        if _e1267.member_1 {
                        } else {
                            if _e88 {
                            } else {
                                break;
                            }
                            let _e1271 = global_5.member[_e80];
                            if _e81 {
                            } else {
                                break;
                            }
                            let _e1275 = global_4.member[_e80].member_1;
                            if _e88 {
                            } else {
                                break;
                            }
                            global_5.member[_e80] = type_24(_e1271.member, _e1271.member_1, _e1271.member_2, array<f32, 3>((_e1271.member_3[0] + (_e1275[0] * _e1271.member_1[0])), (_e1271.member_3[1] + (_e1275[1] * _e1271.member_1[1])), (_e1271.member_3[2] + (_e1275[2] * _e1271.member_1[2]))), _e1271.member_4);
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
fn trace_shadows(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
