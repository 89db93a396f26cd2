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
    var phi_184_: u32;
    var phi_333_: i32;
    var phi_334_: i32;
    var phi_344_: bool;
    var phi_354_: u32;
    var phi_355_: u32;
    var phi_357_: bool;
    var phi_362_: u32;
    var phi_394_: i32;
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
    var phi_544_: f32;
    var phi_550_: f32;
    var phi_561_: f32;
    var phi_567_: f32;
    var phi_590_: f32;
    var phi_601_: f32;
    var phi_701_: f32;
    var phi_702_: f32;
    var phi_2316_: bool;
    var phi_713_: type_48;
    var phi_716_: u32;
    var phi_718_: u32;
    var phi_720_: bool;
    var phi_722_: u32;
    var phi_733_: bool;
    var phi_765_: u32;
    var phi_766_: bool;
    var phi_767_: u32;
    var phi_1834_: type_47;
    var phi_2178_: u32;
    var phi_2206_: u32;
    var phi_2207_: u32;
    var phi_2208_: u32;
    var phi_2210_: u32;
    var phi_2211_: u32;
    var phi_2212_: bool;
    var phi_2221_: u32;
    var phi_2226_: u32;
    var phi_2227_: bool;
    var phi_782_: type_48;
    var phi_785_: type_7;
    var phi_786_: type_7;
    var phi_808_: type_7;
    var phi_829_: u32;
    var phi_918_: array<array<f32, 3>, 3>;
    var phi_1035_: bool;
    var phi_1064_: bool;
    var phi_1465_: f32;
    var phi_1466_: f32;
    var phi_1467_: f32;
    var phi_1468_: f32;
    var phi_1469_: vec3<f32>;
    var phi_1470_: vec3<f32>;
    var phi_1471_: vec3<f32>;
    var phi_1472_: vec3<f32>;
    var phi_1503_: bool;
    var phi_1512_: vec3<f32>;
    var phi_1679_: bool;
    var phi_1703_: f32;
    var phi_1704_: f32;
    var phi_1727_: type_22;
    var phi_1729_: type_22;
    var phi_1730_: bool;
    var phi_1734_: type_22;
    var phi_1735_: type_22;
    var phi_1736_: type_22;
    var phi_1737_: bool;
    var phi_1741_: type_22;
    var phi_1742_: bool;
    var phi_1743_: type_22;
    var phi_1744_: bool;
    var phi_1745_: bool;
    var phi_1746_: type_22;
    var phi_1747_: bool;
    var phi_1748_: bool;
    var phi_1756_: type_22;
    var phi_1757_: bool;
    var phi_1761_: type_22;
    var phi_1772_: type_48;
    var phi_1773_: type_48;
    var phi_783_: type_48;
    var phi_2310_: bool;
    var local_2: type_48;
    var phi_2457_: bool;
    var phi_2229_: type_48;
    var phi_2230_: u32;
    var phi_2231_: bool;
    var phi_2232_: u32;
    var phi_2456_: bool;
    var phi_2233_: type_48;
    var phi_2234_: u32;
    var phi_2235_: u32;
    var phi_2236_: bool;
    var phi_2237_: u32;
    var phi_2455_: bool;
    var phi_2238_: type_48;
    var phi_2239_: u32;
    var phi_2240_: u32;
    var phi_2241_: bool;
    var phi_2242_: u32;
    var phi_2454_: bool;
    var phi_714_: type_48;
    var phi_717_: u32;
    var phi_719_: u32;
    var phi_721_: bool;
    var phi_723_: u32;
    var phi_2243_: bool;
    var phi_2453_: bool;
    var local_3: type_48;
    var local_4: type_48;

    switch bitcast<i32>(0u) {
        default: {
            let _e65 = global;
            let _e67 = arrayLength((&global_2.member));
            let _e69 = arrayLength((&global_1.member));
            let _e75 = arrayLength((&global_3.member));
            let _e79 = (_e65.x + (_e65.y * 2097152u));
            let _e80 = (_e79 < arrayLength((&global_4.member)));
            if _e80 {
                if _e80 {
                } else {
                    break;
                }
                let _e84 = global_4.member[_e79].member_2;
                phi_184_ = _e84;
            } else {
                phi_184_ = 4294967295u;
            }
            let _e86 = phi_184_;
            if _e80 {
                let _e87 = (_e79 < arrayLength((&global_5.member)));
                if _e87 {
                    if _e80 {
                    } else {
                        break;
                    }
                    let _e92 = global_4.member[_e79].member.member_1;
                    let _e97 = global_4.member[_e79].member.member_3;
                    if (_e92 <= _e97) {
                        let _e99 = (1u < _e75);
                        if _e99 {
                            if (0u < _e75) {
                            } else {
                                break;
                            }
                            let _e103 = atomicAdd((&global_3.member[0u]), 1u);
                            if ((_e103 + 1u) < _e103) {
                                if _e99 {
                                } else {
                                    break;
                                }
                                let _e108 = atomicAdd((&global_3.member[1u]), 1u);
                            }
                        }
                        if _e80 {
                        } else {
                            break;
                        }
                        let _e118 = global_4.member[_e79].member.member_2[0u];
                        let _e120 = (bitcast<u32>(_e118) & 2147483647u);
                        let _e126 = global_4.member[_e79].member.member_2[1u];
                        let _e128 = (bitcast<u32>(_e126) & 2147483647u);
                        let _e134 = global_4.member[_e79].member.member_2[2u];
                        let _e136 = (bitcast<u32>(_e134) & 2147483647u);
                        let _e142 = global_4.member[_e79].member.member[0u];
                        let _e144 = (bitcast<u32>(_e142) & 2147483647u);
                        let _e150 = global_4.member[_e79].member.member[1u];
                        let _e152 = (bitcast<u32>(_e150) & 2147483647u);
                        let _e158 = global_4.member[_e79].member.member[2u];
                        let _e160 = (bitcast<u32>(_e158) & 2147483647u);
                        let _e162 = select(_e128, _e120, (_e128 < _e120));
                        let _e164 = select(_e136, _e162, (_e136 < _e162));
                        let _e166 = select(_e144, _e164, (_e144 < _e164));
                        let _e168 = select(_e152, _e166, (_e152 < _e166));
                        let _e170 = select(_e160, _e168, (_e160 < _e168));
                        let _e172 = (bitcast<u32>(_e92) & 2147483647u);
                        let _e181 = (((select(_e172, _e170, (_e172 < _e170)) < 2139095040u) && ((bitcast<u32>(_e97) & 2147483647u) <= 2139095040u)) && (_e164 > 0u));
                        if _e181 {
                            let _e184 = (bitcast<u32>(bitcast<f32>(_e164)) & 2147483647u);
                            if (_e184 >= 8388608u) {
                                phi_333_ = (bitcast<i32>((_e184 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_333_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e184)), 32u, (_e184 == 0u))));
                            }
                            let _e198 = phi_333_;
                            phi_334_ = _e198;
                        } else {
                            phi_334_ = 0i;
                        }
                        let _e200 = phi_334_;
                        let _e201 = (_e120 == _e164);
                        if _e201 {
                            phi_344_ = true;
                        } else {
                            phi_344_ = (_e128 == _e164);
                        }
                        let _e204 = phi_344_;
                        let _e205 = select(1u, 0u, _e201);
                        if _e204 {
                            let _e206 = (_e205 + 1u);
                            phi_354_ = _e206;
                            phi_355_ = _e206;
                            phi_357_ = select(true, false, (_e206 == 2u));
                        } else {
                            phi_354_ = u32();
                            phi_355_ = 0u;
                            phi_357_ = true;
                        }
                        let _e210 = phi_354_;
                        let _e212 = phi_355_;
                        let _e214 = phi_357_;
                        if _e214 {
                            phi_362_ = (_e212 + 1u);
                        } else {
                            phi_362_ = 0u;
                        }
                        let _e218 = phi_362_;
                        let _e219 = select(_e210, _e212, _e214);
                        let _e220 = select(_e205, select(2u, _e205, _e204), _e214);
                        let _e221 = -(_e200);
                        if (_e221 < -126i) {
                            phi_394_ = -126i;
                        } else {
                            phi_394_ = select(_e221, 127i, (_e221 > 127i));
                        }
                        let _e226 = phi_394_;
                        let _e231 = bitcast<f32>((bitcast<u32>((_e226 + 127i)) << bitcast<u32>(23i)));
                        let _e237 = bitcast<f32>((bitcast<u32>(((_e221 - _e226) + 127i)) << bitcast<u32>(23i)));
                        let _e242 = global_4.member[_e79].member.member;
                        let _e243 = (_e219 == 0u);
                        if _e243 {
                            phi_412_ = _e242[0];
                        } else {
                            phi_412_ = _e242[1];
                        }
                        let _e247 = phi_412_;
                        let _e248 = (_e219 == 2u);
                        if _e248 {
                            phi_418_ = _e242[2];
                        } else {
                            phi_418_ = _e247;
                        }
                        let _e251 = phi_418_;
                        let _e252 = global_4.member[_e79].member.member_2;
                        if _e243 {
                            phi_429_ = _e252[0];
                        } else {
                            phi_429_ = _e252[1];
                        }
                        let _e256 = phi_429_;
                        if _e248 {
                            phi_435_ = _e252[2];
                        } else {
                            phi_435_ = _e256;
                        }
                        let _e259 = phi_435_;
                        let _e261 = ((_e259 * _e231) * _e237);
                        let _e265 = (bitcast<f32>((bitcast<u32>(_e261) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e265 {
                            let _e269 = (bitcast<f32>((bitcast<u32>(_e251) & 2147483647u)) * 0.00000011920929f);
                            phi_458_ = select(0.00000000000011368684f, _e269, (_e269 > 0.00000000000011368684f));
                        } else {
                            phi_458_ = 0f;
                        }
                        let _e273 = phi_458_;
                        let _e274 = (_e251 + _e273);
                        let _e275 = (_e251 - _e273);
                        let _e276 = select(_e261, 0f, _e265);
                        if _e265 {
                            phi_469_ = 38685626000000000000000000f;
                        } else {
                            phi_469_ = (1f / _e261);
                        }
                        let _e279 = phi_469_;
                        let _e280 = (_e218 == 0u);
                        if _e280 {
                            phi_478_ = _e242[0];
                        } else {
                            phi_478_ = _e242[1];
                        }
                        let _e284 = phi_478_;
                        let _e285 = (_e218 == 2u);
                        if _e285 {
                            phi_484_ = _e242[2];
                        } else {
                            phi_484_ = _e284;
                        }
                        let _e288 = phi_484_;
                        if _e280 {
                            phi_495_ = _e252[0];
                        } else {
                            phi_495_ = _e252[1];
                        }
                        let _e292 = phi_495_;
                        if _e285 {
                            phi_501_ = _e252[2];
                        } else {
                            phi_501_ = _e292;
                        }
                        let _e295 = phi_501_;
                        let _e297 = ((_e295 * _e231) * _e237);
                        let _e301 = (bitcast<f32>((bitcast<u32>(_e297) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e301 {
                            let _e305 = (bitcast<f32>((bitcast<u32>(_e288) & 2147483647u)) * 0.00000011920929f);
                            phi_524_ = select(0.00000000000011368684f, _e305, (_e305 > 0.00000000000011368684f));
                        } else {
                            phi_524_ = 0f;
                        }
                        let _e309 = phi_524_;
                        let _e310 = (_e288 + _e309);
                        let _e311 = (_e288 - _e309);
                        let _e312 = select(_e297, 0f, _e301);
                        if _e301 {
                            phi_535_ = 38685626000000000000000000f;
                        } else {
                            phi_535_ = (1f / _e297);
                        }
                        let _e315 = phi_535_;
                        let _e316 = (_e220 == 0u);
                        if _e316 {
                            phi_544_ = _e242[0];
                        } else {
                            phi_544_ = _e242[1];
                        }
                        let _e320 = phi_544_;
                        let _e321 = (_e220 == 2u);
                        if _e321 {
                            phi_550_ = _e242[2];
                        } else {
                            phi_550_ = _e320;
                        }
                        let _e324 = phi_550_;
                        if _e316 {
                            phi_561_ = _e252[0];
                        } else {
                            phi_561_ = _e252[1];
                        }
                        let _e328 = phi_561_;
                        if _e321 {
                            phi_567_ = _e252[2];
                        } else {
                            phi_567_ = _e328;
                        }
                        let _e331 = phi_567_;
                        let _e333 = ((_e331 * _e231) * _e237);
                        let _e337 = (bitcast<f32>((bitcast<u32>(_e333) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e337 {
                            let _e341 = (bitcast<f32>((bitcast<u32>(_e324) & 2147483647u)) * 0.00000011920929f);
                            phi_590_ = select(0.00000000000011368684f, _e341, (_e341 > 0.00000000000011368684f));
                        } else {
                            phi_590_ = 0f;
                        }
                        let _e345 = phi_590_;
                        let _e346 = (_e324 + _e345);
                        let _e347 = (_e324 - _e345);
                        let _e348 = select(_e333, 0f, _e337);
                        if _e337 {
                            phi_601_ = 38685626000000000000000000f;
                        } else {
                            phi_601_ = (1f / _e333);
                        }
                        let _e351 = phi_601_;
                        let _e354 = bitcast<f32>((bitcast<u32>(_e251) & 2147483647u));
                        let _e357 = bitcast<f32>((bitcast<u32>(_e288) & 2147483647u));
                        let _e359 = select(_e357, _e354, (_e354 > _e357));
                        let _e362 = bitcast<f32>((bitcast<u32>(_e324) & 2147483647u));
                        if (_e181 && (select(_e362, _e359, (_e359 > _e362)) <= 1099511600000f)) {
                            let _e367 = (_e200 / 3i);
                            let _e374 = bitcast<f32>((bitcast<u32>((_e367 + 127i)) << bitcast<u32>(23i)));
                            let _e381 = bitcast<f32>((bitcast<u32>(((_e200 - (2i * _e367)) + 127i)) << bitcast<u32>(23i)));
                            let _e382 = (((_e92 * _e374) * _e374) * _e381);
                            let _e384 = select(340282350000000000000000000000000000000f, _e382, (_e382 < 340282350000000000000000000000000000000f));
                            let _e389 = (((_e97 * _e374) * _e374) * _e381);
                            let _e391 = select(340282350000000000000000000000000000000f, _e389, (_e389 < 340282350000000000000000000000000000000f));
                            phi_701_ = select(-340282350000000000000000000000000000000f, _e391, (_e391 > -340282350000000000000000000000000000000f));
                            phi_702_ = select(-340282350000000000000000000000000000000f, _e384, (_e384 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_701_ = 0f;
                            phi_702_ = 1f;
                        }
                        let _e395 = phi_701_;
                        let _e397 = phi_702_;
                        local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        phi_2316_ = false;
                        phi_713_ = type_48(_e395, false);
                        phi_716_ = select(0u, 2147483648u, (_e67 == 0u));
                        phi_718_ = ((3u * _e67) + 1u);
                        phi_720_ = (_e397 <= _e395);
                        phi_722_ = 0u;
                        loop {
                            let _e405 = phi_2316_;
                            let _e407 = phi_713_;
                            let _e409 = phi_716_;
                            let _e411 = phi_718_;
                            let _e413 = phi_720_;
                            let _e415 = phi_722_;
                            local_3 = _e407;
                            if _e413 {
                                phi_733_ = true;
                            } else {
                                phi_733_ = (_e415 > 0u);
                            }
                            let _e418 = phi_733_;
                            if _e418 {
                                let _e419 = (_e411 > 0u);
                                if _e419 {
                                    if _e413 {
                                        phi_765_ = _e409;
                                        phi_766_ = _e413;
                                        phi_767_ = _e415;
                                    } else {
                                        let _e420 = (_e415 - 1u);
                                        let _e421 = (_e420 % 128u);
                                        let _e422 = (_e421 < 128u);
                                        if _e422 {
                                        } else {
                                            phi_2453_ = true;
                                            break;
                                        }
                                        let _e424 = local_1[_e421];
                                        if _e422 {
                                        } else {
                                            phi_2453_ = true;
                                            break;
                                        }
                                        let _e426 = local[_e421];
                                        phi_765_ = _e424;
                                        phi_766_ = (_e426 <= _e407.member);
                                        phi_767_ = _e420;
                                    }
                                    let _e430 = phi_765_;
                                    let _e432 = phi_766_;
                                    let _e434 = phi_767_;
                                    if _e432 {
                                        if ((_e430 & 2147483648u) != 0u) {
                                            phi_782_ = _e407;
                                            phi_785_ = type_7(0u, ((_e430 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e632 = phi_782_;
                                                let _e634 = phi_785_;
                                                local_2 = _e632;
                                                local_4 = _e632;
                                                if (_e634.member < _e634.member_1) {
                                                    phi_786_ = type_7((_e634.member + 1u), _e634.member_1);
                                                    phi_808_ = type_7(1u, _e634.member);
                                                } else {
                                                    phi_786_ = _e634;
                                                    phi_808_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e647 = phi_786_;
                                                let _e649 = phi_808_;
                                                let _e653 = (bitcast<i32>(_e649.member) != 0i);
                                                if _e653 {
                                                    let _e654 = ((_e430 & 268435455u) + _e649.member_1);
                                                    let _e655 = (_e654 < _e69);
                                                    if _e655 {
                                                        if _e655 {
                                                        } else {
                                                            phi_2310_ = true;
                                                            break;
                                                        }
                                                        let _e659 = global_1.member[_e654].member_1;
                                                        phi_829_ = _e659;
                                                    } else {
                                                        phi_829_ = 4294967295u;
                                                    }
                                                    let _e661 = phi_829_;
                                                    if (_e654 >= _e69) {
                                                        phi_918_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e655 {
                                                        } else {
                                                            phi_2310_ = true;
                                                            break;
                                                        }
                                                        let _e663 = (_e219 % 3u);
                                                        let _e664 = (_e218 % 3u);
                                                        let _e665 = (_e220 % 3u);
                                                        if (_e663 < 9u) {
                                                        } else {
                                                            phi_2310_ = true;
                                                            break;
                                                        }
                                                        let _e671 = global_1.member[_e654].member[_e663];
                                                        if (_e664 < 9u) {
                                                        } else {
                                                            phi_2310_ = true;
                                                            break;
                                                        }
                                                        let _e677 = global_1.member[_e654].member[_e664];
                                                        if (_e665 < 9u) {
                                                        } else {
                                                            phi_2310_ = true;
                                                            break;
                                                        }
                                                        let _e683 = global_1.member[_e654].member[_e665];
                                                        let _e685 = (3u + _e663);
                                                        if (_e685 < 9u) {
                                                        } else {
                                                            phi_2310_ = true;
                                                            break;
                                                        }
                                                        let _e691 = global_1.member[_e654].member[_e685];
                                                        let _e692 = (3u + _e664);
                                                        if (_e692 < 9u) {
                                                        } else {
                                                            phi_2310_ = true;
                                                            break;
                                                        }
                                                        let _e698 = global_1.member[_e654].member[_e692];
                                                        let _e699 = (3u + _e665);
                                                        if (_e699 < 9u) {
                                                        } else {
                                                            phi_2310_ = true;
                                                            break;
                                                        }
                                                        let _e705 = global_1.member[_e654].member[_e699];
                                                        let _e707 = (6u + _e663);
                                                        if (_e707 < 9u) {
                                                        } else {
                                                            phi_2310_ = true;
                                                            break;
                                                        }
                                                        let _e713 = global_1.member[_e654].member[_e707];
                                                        let _e714 = (6u + _e664);
                                                        if (_e714 < 9u) {
                                                        } else {
                                                            phi_2310_ = true;
                                                            break;
                                                        }
                                                        let _e720 = global_1.member[_e654].member[_e714];
                                                        let _e721 = (6u + _e665);
                                                        if (_e721 < 9u) {
                                                        } else {
                                                            phi_2310_ = true;
                                                            break;
                                                        }
                                                        let _e727 = global_1.member[_e654].member[_e721];
                                                        phi_918_ = array<array<f32, 3>, 3>(array<f32, 3>(_e671, _e677, _e683), array<f32, 3>(_e691, _e698, _e705), array<f32, 3>(_e713, _e720, _e727));
                                                    }
                                                    let _e731 = phi_918_;
                                                    let _e739 = (_e731[0][2] - _e324);
                                                    let _e742 = (((_e731[0][0] - _e251) * _e348) - (_e739 * _e276));
                                                    let _e745 = (((_e731[0][1] - _e288) * _e348) - (_e739 * _e312));
                                                    let _e752 = (_e731[1][2] - _e324);
                                                    let _e755 = (((_e731[1][0] - _e251) * _e348) - (_e752 * _e276));
                                                    let _e758 = (((_e731[1][1] - _e288) * _e348) - (_e752 * _e312));
                                                    let _e765 = (_e731[2][2] - _e324);
                                                    let _e768 = (((_e731[2][0] - _e251) * _e348) - (_e765 * _e276));
                                                    let _e771 = (((_e731[2][1] - _e288) * _e348) - (_e765 * _e312));
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
                                                            phi_1746_ = type_22();
                                                            phi_1747_ = true;
                                                            phi_1748_ = false;
                                                        } else {
                                                            let _e806 = select(_e755, _e742, (_e742 < _e755));
                                                            if (select(_e768, _e806, (_e806 < _e768)) > 0f) {
                                                                phi_1035_ = true;
                                                            } else {
                                                                let _e811 = select(_e755, _e742, (_e742 > _e755));
                                                                phi_1035_ = (select(_e768, _e811, (_e811 > _e768)) < 0f);
                                                            }
                                                            let _e816 = phi_1035_;
                                                            if _e816 {
                                                                phi_1743_ = type_22();
                                                                phi_1744_ = true;
                                                                phi_1745_ = false;
                                                            } else {
                                                                let _e818 = select(_e758, _e745, (_e745 < _e758));
                                                                if (select(_e771, _e818, (_e818 < _e771)) > 0f) {
                                                                    phi_1064_ = true;
                                                                } else {
                                                                    let _e823 = select(_e758, _e745, (_e745 > _e758));
                                                                    phi_1064_ = (select(_e771, _e823, (_e823 > _e771)) < 0f);
                                                                }
                                                                let _e828 = phi_1064_;
                                                                if _e828 {
                                                                    phi_1741_ = type_22();
                                                                    phi_1742_ = false;
                                                                } else {
                                                                    let _e830 = select(_e731[1][0], _e731[0][0], (_e731[0][0] < _e731[1][0]));
                                                                    let _e834 = select(_e731[1][0], _e731[0][0], (_e731[0][0] > _e731[1][0]));
                                                                    let _e838 = select(_e731[1][1], _e731[0][1], (_e731[0][1] < _e731[1][1]));
                                                                    let _e842 = select(_e731[1][1], _e731[0][1], (_e731[0][1] > _e731[1][1]));
                                                                    let _e846 = select(_e731[1][2], _e731[0][2], (_e731[0][2] < _e731[1][2]));
                                                                    let _e850 = select(_e731[1][2], _e731[0][2], (_e731[0][2] > _e731[1][2]));
                                                                    let _e855 = ((select(_e731[2][0], _e830, (_e830 < _e731[2][0])) - _e274) * _e279);
                                                                    let _e856 = ((select(_e731[2][0], _e834, (_e834 > _e731[2][0])) - _e275) * _e279);
                                                                    let _e859 = ((select(_e731[2][1], _e838, (_e838 < _e731[2][1])) - _e310) * _e315);
                                                                    let _e860 = ((select(_e731[2][1], _e842, (_e842 > _e731[2][1])) - _e311) * _e315);
                                                                    let _e863 = ((select(_e731[2][2], _e846, (_e846 < _e731[2][2])) - _e346) * _e351);
                                                                    let _e864 = ((select(_e731[2][2], _e850, (_e850 > _e731[2][2])) - _e347) * _e351);
                                                                    let _e866 = select(_e864, _e863, (_e863 < _e864));
                                                                    let _e868 = select(_e864, _e863, (_e863 > _e864));
                                                                    let _e870 = select(_e856, _e855, (_e855 < _e856));
                                                                    let _e872 = select(_e860, _e859, (_e859 < _e860));
                                                                    let _e874 = select(_e872, _e870, (_e870 > _e872));
                                                                    let _e876 = select(_e866, _e874, (_e874 > _e866));
                                                                    let _e878 = select(_e856, _e855, (_e855 > _e856));
                                                                    let _e880 = select(_e860, _e859, (_e859 > _e860));
                                                                    let _e882 = select(_e880, _e878, (_e878 < _e880));
                                                                    let _e884 = select(_e868, _e882, (_e882 < _e868));
                                                                    let _e885 = -(_e866);
                                                                    let _e891 = select(_e397, _e876, (_e876 > _e397));
                                                                    if (_e891 > (_e884 + (select(_e885, _e868, (_e868 > _e885)) * 0.0000019073523f))) {
                                                                        phi_1736_ = type_22();
                                                                        phi_1737_ = true;
                                                                    } else {
                                                                        let _e893 = (_e891 > _e632.member);
                                                                        if _e893 {
                                                                            phi_1735_ = type_22();
                                                                        } else {
                                                                            let _e894 = vec3<f32>(_e731[0][0], _e731[0][1], _e731[0][2]);
                                                                            let _e895 = vec3<f32>(_e731[1][0], _e731[1][1], _e731[1][2]);
                                                                            let _e896 = vec3<f32>(_e731[2][0], _e731[2][1], _e731[2][2]);
                                                                            let _e897 = (_e731[1][0] - _e731[0][0]);
                                                                            let _e898 = (_e731[1][1] - _e731[0][1]);
                                                                            let _e899 = (_e731[1][2] - _e731[0][2]);
                                                                            let _e900 = vec3<f32>(_e897, _e898, _e899);
                                                                            let _e901 = (_e731[2][0] - _e731[1][0]);
                                                                            let _e902 = (_e731[2][1] - _e731[1][1]);
                                                                            let _e903 = (_e731[2][2] - _e731[1][2]);
                                                                            let _e904 = vec3<f32>(_e901, _e902, _e903);
                                                                            let _e905 = (_e731[0][0] - _e731[2][0]);
                                                                            let _e906 = (_e731[0][1] - _e731[2][1]);
                                                                            let _e907 = (_e731[0][2] - _e731[2][2]);
                                                                            let _e908 = vec3<f32>(_e905, _e906, _e907);
                                                                            let _e911 = bitcast<f32>((bitcast<u32>(_e897) & 2147483647u));
                                                                            let _e914 = bitcast<f32>((bitcast<u32>(_e898) & 2147483647u));
                                                                            let _e916 = select(_e914, _e911, (_e911 > _e914));
                                                                            let _e919 = bitcast<f32>((bitcast<u32>(_e899) & 2147483647u));
                                                                            let _e921 = select(_e919, _e916, (_e916 > _e919));
                                                                            let _e924 = bitcast<f32>((bitcast<u32>(_e901) & 2147483647u));
                                                                            let _e927 = bitcast<f32>((bitcast<u32>(_e902) & 2147483647u));
                                                                            let _e929 = select(_e927, _e924, (_e924 > _e927));
                                                                            let _e932 = bitcast<f32>((bitcast<u32>(_e903) & 2147483647u));
                                                                            let _e934 = select(_e932, _e929, (_e929 > _e932));
                                                                            let _e937 = bitcast<f32>((bitcast<u32>(_e905) & 2147483647u));
                                                                            let _e940 = bitcast<f32>((bitcast<u32>(_e906) & 2147483647u));
                                                                            let _e942 = select(_e940, _e937, (_e937 > _e940));
                                                                            let _e945 = bitcast<f32>((bitcast<u32>(_e907) & 2147483647u));
                                                                            let _e947 = select(_e945, _e942, (_e942 > _e945));
                                                                            let _e949 = select(_e934, _e921, (_e921 > _e934));
                                                                            let _e951 = select(_e947, _e949, (_e949 > _e947));
                                                                            if (_e921 == _e951) {
                                                                                phi_1465_ = _e758;
                                                                                phi_1466_ = _e755;
                                                                                phi_1467_ = _e745;
                                                                                phi_1468_ = _e742;
                                                                                phi_1469_ = _e894;
                                                                                phi_1470_ = _e908;
                                                                                phi_1471_ = _e904;
                                                                                phi_1472_ = _e900;
                                                                            } else {
                                                                                let _e953 = (_e934 == _e951);
                                                                                let _e958 = vec3(_e953);
                                                                                phi_1465_ = select(_e745, _e771, _e953);
                                                                                phi_1466_ = select(_e742, _e768, _e953);
                                                                                phi_1467_ = select(_e771, _e758, _e953);
                                                                                phi_1468_ = select(_e768, _e755, _e953);
                                                                                phi_1469_ = select(_e896, _e895, _e958);
                                                                                phi_1470_ = select(_e904, _e900, _e958);
                                                                                phi_1471_ = select(_e900, _e908, _e958);
                                                                                phi_1472_ = select(_e908, _e904, _e958);
                                                                            }
                                                                            let _e964 = phi_1465_;
                                                                            let _e966 = phi_1466_;
                                                                            let _e968 = phi_1467_;
                                                                            let _e970 = phi_1468_;
                                                                            let _e972 = phi_1469_;
                                                                            let _e974 = phi_1470_;
                                                                            let _e976 = phi_1471_;
                                                                            let _e978 = phi_1472_;
                                                                            let _e985 = ((_e976.y * _e974.z) - (_e974.y * _e976.z));
                                                                            let _e990 = ((_e976.z * _e974.x) - (_e974.z * _e976.x));
                                                                            let _e993 = ((_e976.x * _e974.y) - (_e974.x * _e976.y));
                                                                            if (_e793 >= _e797) {
                                                                                phi_1503_ = select(true, false, (_e793 >= _e801));
                                                                            } else {
                                                                                phi_1503_ = true;
                                                                            }
                                                                            let _e998 = phi_1503_;
                                                                            if _e998 {
                                                                                phi_1512_ = select(_e896, _e895, vec3((_e797 >= _e801)));
                                                                            } else {
                                                                                phi_1512_ = _e894;
                                                                            }
                                                                            let _e1003 = phi_1512_;
                                                                            let _e1008 = (((_e985 * _e276) + (_e990 * _e312)) + (_e993 * _e348));
                                                                            let _e1019 = (((_e985 * (_e1003.x - _e251)) + (_e990 * (_e1003.y - _e288))) + (_e993 * (_e1003.z - _e324)));
                                                                            let _e1021 = (_e966 - _e970);
                                                                            let _e1022 = (_e964 - _e968);
                                                                            let _e1030 = (-(((_e970 * _e1021) + (_e968 * _e1022))) / ((_e1021 * _e1021) + (_e1022 * _e1022)));
                                                                            let _e1032 = select(1f, _e1030, (_e1030 < 1f));
                                                                            let _e1034 = select(0f, _e1032, (_e1032 > 0f));
                                                                            let _e1047 = ((_e972.x + (_e978.x * _e1034)) - _e251);
                                                                            let _e1048 = ((_e972.y + (_e978.y * _e1034)) - _e288);
                                                                            let _e1049 = ((_e972.z + (_e978.z * _e1034)) - _e324);
                                                                            let _e1050 = (_e1049 / _e348);
                                                                            let _e1062 = bitcast<f32>((bitcast<u32>(_e1047) & 2147483647u));
                                                                            let _e1065 = bitcast<f32>((bitcast<u32>(_e1048) & 2147483647u));
                                                                            let _e1067 = select(_e1065, _e1062, (_e1062 > _e1065));
                                                                            let _e1070 = bitcast<f32>((bitcast<u32>(_e1049) & 2147483647u));
                                                                            let _e1072 = select(_e1070, _e1067, (_e1067 > _e1070));
                                                                            let _e1078 = bitcast<f32>((bitcast<u32>(_e985) & 2147483647u));
                                                                            let _e1081 = bitcast<f32>((bitcast<u32>(_e990) & 2147483647u));
                                                                            let _e1083 = select(_e1081, _e1078, (_e1078 > _e1081));
                                                                            let _e1086 = bitcast<f32>((bitcast<u32>(_e993) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e985 * _e1047) + (_e990 * _e1048)) + (_e993 * _e1049)) - _e1019)) & 2147483647u)) <= ((0.0000009536743f * select(_e951, _e1072, (_e1072 > _e951))) * select(_e1086, _e1083, (_e1083 > _e1086)))) {
                                                                                let _e1096 = bitcast<f32>((bitcast<u32>(_e976.x) & 2147483647u));
                                                                                let _e1099 = bitcast<f32>((bitcast<u32>(_e976.y) & 2147483647u));
                                                                                let _e1101 = select(_e1099, _e1096, (_e1096 > _e1099));
                                                                                let _e1104 = bitcast<f32>((bitcast<u32>(_e976.z) & 2147483647u));
                                                                                let _e1110 = bitcast<f32>((bitcast<u32>(_e974.x) & 2147483647u));
                                                                                let _e1113 = bitcast<f32>((bitcast<u32>(_e974.y) & 2147483647u));
                                                                                let _e1115 = select(_e1113, _e1110, (_e1110 > _e1113));
                                                                                let _e1118 = bitcast<f32>((bitcast<u32>(_e974.z) & 2147483647u));
                                                                                phi_1679_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1008) & 2147483647u)) > ((0.0000038146973f * select(_e1104, _e1101, (_e1101 > _e1104))) * select(_e1118, _e1115, (_e1115 > _e1118)))));
                                                                            } else {
                                                                                phi_1679_ = true;
                                                                            }
                                                                            let _e1125 = phi_1679_;
                                                                            if _e1125 {
                                                                                let _e1136 = ((((_e985 * (_e1047 - (_e276 * _e1050))) + (_e990 * (_e1048 - (_e312 * _e1050)))) + (_e993 * (_e1049 - _e1049))) / _e1008);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1136) & 2147483647u)) <= _e951) {
                                                                                    phi_1703_ = (_e1050 + _e1136);
                                                                                } else {
                                                                                    phi_1703_ = _e1050;
                                                                                }
                                                                                let _e1143 = phi_1703_;
                                                                                phi_1704_ = _e1143;
                                                                            } else {
                                                                                phi_1704_ = (_e1019 / _e1008);
                                                                            }
                                                                            let _e1145 = phi_1704_;
                                                                            let _e1147 = select(_e884, _e1145, (_e1145 < _e884));
                                                                            let _e1149 = select(_e876, _e1147, (_e1147 > _e876));
                                                                            if (_e1149 >= _e397) {
                                                                                let _e1151 = (_e1149 <= _e632.member);
                                                                                if _e1151 {
                                                                                    let _e1152 = (1f / _e803);
                                                                                    phi_1727_ = type_22(_e1149, (_e797 * _e1152), (_e801 * _e1152), _e661);
                                                                                } else {
                                                                                    phi_1727_ = type_22();
                                                                                }
                                                                                let _e1157 = phi_1727_;
                                                                                phi_1729_ = _e1157;
                                                                                phi_1730_ = select(true, false, _e1151);
                                                                            } else {
                                                                                phi_1729_ = type_22();
                                                                                phi_1730_ = true;
                                                                            }
                                                                            let _e1160 = phi_1729_;
                                                                            let _e1162 = phi_1730_;
                                                                            if _e1162 {
                                                                                phi_1734_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_1734_ = _e1160;
                                                                            }
                                                                            let _e1164 = phi_1734_;
                                                                            phi_1735_ = _e1164;
                                                                        }
                                                                        let _e1166 = phi_1735_;
                                                                        phi_1736_ = _e1166;
                                                                        phi_1737_ = _e893;
                                                                    }
                                                                    let _e1168 = phi_1736_;
                                                                    let _e1170 = phi_1737_;
                                                                    phi_1741_ = _e1168;
                                                                    phi_1742_ = _e1170;
                                                                }
                                                                let _e1172 = phi_1741_;
                                                                let _e1174 = phi_1742_;
                                                                phi_1743_ = _e1172;
                                                                phi_1744_ = _e828;
                                                                phi_1745_ = _e1174;
                                                            }
                                                            let _e1176 = phi_1743_;
                                                            let _e1178 = phi_1744_;
                                                            let _e1180 = phi_1745_;
                                                            phi_1746_ = _e1176;
                                                            phi_1747_ = _e1178;
                                                            phi_1748_ = _e1180;
                                                        }
                                                        let _e1182 = phi_1746_;
                                                        let _e1184 = phi_1747_;
                                                        let _e1186 = phi_1748_;
                                                        phi_1756_ = _e1182;
                                                        phi_1757_ = select(_e1186, true, _e1184);
                                                    } else {
                                                        phi_1756_ = type_22();
                                                        phi_1757_ = true;
                                                    }
                                                    let _e1189 = phi_1756_;
                                                    let _e1191 = phi_1757_;
                                                    if _e1191 {
                                                        phi_1761_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1761_ = _e1189;
                                                    }
                                                    let _e1193 = phi_1761_;
                                                    if (_e1193.member_3 != 4294967295u) {
                                                        if (_e661 != _e86) {
                                                            phi_1772_ = type_48(_e632.member, true);
                                                        } else {
                                                            phi_1772_ = _e632;
                                                        }
                                                        let _e1201 = phi_1772_;
                                                        phi_1773_ = _e1201;
                                                    } else {
                                                        phi_1773_ = _e632;
                                                    }
                                                    let _e1203 = phi_1773_;
                                                    phi_783_ = _e1203;
                                                } else {
                                                    phi_783_ = type_48();
                                                }
                                                let _e1205 = phi_783_;
                                                continue;
                                                continuing {
                                                    phi_782_ = _e1205;
                                                    phi_785_ = _e647;
                                                    phi_2310_ = _e405;
                                                    break if !(_e653);
                                                }
                                            }
                                            let _e1208 = phi_2310_;
                                            phi_2453_ = _e1208;
                                            if _e1208 {
                                                break;
                                            }
                                            let _e1210 = local_2;
                                            phi_2457_ = _e1208;
                                            let _e1393 = local_4;
                                            phi_2229_ = _e1393;
                                            phi_2230_ = _e430;
                                            phi_2231_ = false;
                                            phi_2232_ = select(_e434, 0u, _e1210.member_1);
                                        } else {
                                            if (_e430 >= _e67) {
                                                phi_1834_ = type_47(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                            } else {
                                                if (_e430 < _e67) {
                                                } else {
                                                    phi_2453_ = true;
                                                    break;
                                                }
                                                let _e444 = (_e219 % 3u);
                                                if (_e444 < 3u) {
                                                } else {
                                                    phi_2453_ = true;
                                                    break;
                                                }
                                                let _e450 = global_2.member[_e430].member[_e444];
                                                let _e456 = (_e218 % 3u);
                                                if (_e456 < 3u) {
                                                } else {
                                                    phi_2453_ = true;
                                                    break;
                                                }
                                                let _e462 = global_2.member[_e430].member[_e456];
                                                let _e468 = (_e220 % 3u);
                                                if (_e468 < 3u) {
                                                } else {
                                                    phi_2453_ = true;
                                                    break;
                                                }
                                                let _e474 = global_2.member[_e430].member[_e468];
                                                let _e484 = global_2.member[_e430].member_1;
                                                let _e488 = global_2.member[_e430].member_2;
                                                phi_1834_ = type_47(array<vec4<f32>, 3>(vec4<f32>(_e450[0], _e450[1], _e450[2], _e450[3]), vec4<f32>(_e462[0], _e462[1], _e462[2], _e462[3]), vec4<f32>(_e474[0], _e474[1], _e474[2], _e474[3])), _e484, _e488);
                                            }
                                            let _e491 = phi_1834_;
                                            let _e503 = ((_e491.member[0].x - _e274) * _e279);
                                            let _e504 = ((_e491.member[0].y - _e274) * _e279);
                                            let _e505 = ((_e491.member[0].z - _e275) * _e279);
                                            let _e506 = ((_e491.member[0].w - _e275) * _e279);
                                            let _e516 = ((_e491.member[1].x - _e310) * _e315);
                                            let _e517 = ((_e491.member[1].y - _e310) * _e315);
                                            let _e518 = ((_e491.member[1].z - _e311) * _e315);
                                            let _e519 = ((_e491.member[1].w - _e311) * _e315);
                                            let _e529 = ((_e491.member[2].x - _e346) * _e351);
                                            let _e530 = ((_e491.member[2].y - _e346) * _e351);
                                            let _e531 = ((_e491.member[2].z - _e347) * _e351);
                                            let _e532 = ((_e491.member[2].w - _e347) * _e351);
                                            let _e534 = select(_e531, _e529, (_e529 < _e531));
                                            let _e536 = select(_e532, _e530, (_e530 < _e532));
                                            let _e538 = select(_e531, _e529, (_e529 > _e531));
                                            let _e540 = select(_e532, _e530, (_e530 > _e532));
                                            let _e542 = select(_e505, _e503, (_e503 < _e505));
                                            let _e544 = select(_e506, _e504, (_e504 < _e506));
                                            let _e546 = select(_e518, _e516, (_e516 < _e518));
                                            let _e548 = select(_e519, _e517, (_e517 < _e519));
                                            let _e550 = select(_e546, _e542, (_e542 > _e546));
                                            let _e552 = select(_e548, _e544, (_e544 > _e548));
                                            let _e554 = select(_e534, _e550, (_e550 > _e534));
                                            let _e556 = select(_e536, _e552, (_e552 > _e536));
                                            let _e558 = select(_e505, _e503, (_e503 > _e505));
                                            let _e560 = select(_e506, _e504, (_e504 > _e506));
                                            let _e562 = select(_e518, _e516, (_e516 > _e518));
                                            let _e564 = select(_e519, _e517, (_e517 > _e519));
                                            let _e566 = select(_e562, _e558, (_e558 < _e562));
                                            let _e568 = select(_e564, _e560, (_e560 < _e564));
                                            let _e573 = -(_e534);
                                            let _e574 = -(_e536);
                                            let _e581 = (select(_e538, _e566, (_e566 < _e538)) + (select(_e573, _e538, (_e538 > _e573)) * 0.0000019073523f));
                                            let _e582 = (select(_e540, _e568, (_e568 < _e540)) + (select(_e574, _e540, (_e540 > _e574)) * 0.0000019073523f));
                                            let _e584 = select(_e397, _e554, (_e554 > _e397));
                                            let _e586 = select(_e397, _e556, (_e556 > _e397));
                                            let _e591 = (_e584 <= select(_e407.member, _e581, (_e581 < _e407.member)));
                                            let _e592 = (_e586 <= select(_e407.member, _e582, (_e582 < _e407.member)));
                                            let _e593 = (_e584 <= _e586);
                                            if _e591 {
                                                if _e592 {
                                                    if _e593 {
                                                        phi_2178_ = _e491.member_2;
                                                    } else {
                                                        phi_2178_ = _e491.member_1;
                                                    }
                                                    let _e597 = phi_2178_;
                                                    let _e600 = (_e434 % 128u);
                                                    let _e601 = (_e600 < 128u);
                                                    if _e601 {
                                                    } else {
                                                        phi_2453_ = true;
                                                        break;
                                                    }
                                                    local_1[_e600] = _e597;
                                                    if _e601 {
                                                    } else {
                                                        phi_2453_ = true;
                                                        break;
                                                    }
                                                    local[_e600] = select(_e586, _e584, (_e584 > _e586));
                                                    if _e593 {
                                                        phi_2206_ = _e491.member_1;
                                                    } else {
                                                        phi_2206_ = _e491.member_2;
                                                    }
                                                    let _e608 = phi_2206_;
                                                    phi_2207_ = _e608;
                                                    phi_2208_ = (_e434 + 1u);
                                                } else {
                                                    phi_2207_ = u32();
                                                    phi_2208_ = u32();
                                                }
                                                let _e610 = phi_2207_;
                                                let _e612 = phi_2208_;
                                                phi_2210_ = _e610;
                                                phi_2211_ = _e612;
                                                phi_2212_ = select(true, false, _e592);
                                            } else {
                                                phi_2210_ = u32();
                                                phi_2211_ = u32();
                                                phi_2212_ = true;
                                            }
                                            let _e615 = phi_2210_;
                                            let _e617 = phi_2211_;
                                            let _e619 = phi_2212_;
                                            if _e619 {
                                                if _e591 {
                                                    phi_2221_ = _e491.member_1;
                                                } else {
                                                    phi_2221_ = _e491.member_2;
                                                }
                                                let _e623 = phi_2221_;
                                                phi_2226_ = _e623;
                                                phi_2227_ = select(_e592, true, _e591);
                                            } else {
                                                phi_2226_ = _e615;
                                                phi_2227_ = _e432;
                                            }
                                            let _e626 = phi_2226_;
                                            let _e628 = phi_2227_;
                                            phi_2457_ = _e405;
                                            phi_2229_ = _e407;
                                            phi_2230_ = _e626;
                                            phi_2231_ = _e628;
                                            phi_2232_ = select(_e617, _e434, _e619);
                                        }
                                        let _e1214 = phi_2457_;
                                        let _e1216 = phi_2229_;
                                        let _e1218 = phi_2230_;
                                        let _e1220 = phi_2231_;
                                        let _e1222 = phi_2232_;
                                        phi_2456_ = _e1214;
                                        phi_2233_ = _e1216;
                                        phi_2234_ = _e1218;
                                        phi_2235_ = (_e411 - 1u);
                                        phi_2236_ = _e1220;
                                        phi_2237_ = _e1222;
                                    } else {
                                        phi_2456_ = _e405;
                                        phi_2233_ = _e407;
                                        phi_2234_ = _e430;
                                        phi_2235_ = _e411;
                                        phi_2236_ = _e432;
                                        phi_2237_ = _e434;
                                    }
                                    let _e1224 = phi_2456_;
                                    let _e1226 = phi_2233_;
                                    let _e1228 = phi_2234_;
                                    let _e1230 = phi_2235_;
                                    let _e1232 = phi_2236_;
                                    let _e1234 = phi_2237_;
                                    phi_2455_ = _e1224;
                                    phi_2238_ = _e1226;
                                    phi_2239_ = _e1228;
                                    phi_2240_ = _e1230;
                                    phi_2241_ = _e1232;
                                    phi_2242_ = _e1234;
                                } else {
                                    phi_2455_ = _e405;
                                    phi_2238_ = type_48();
                                    phi_2239_ = u32();
                                    phi_2240_ = u32();
                                    phi_2241_ = bool();
                                    phi_2242_ = u32();
                                }
                                let _e1236 = phi_2455_;
                                let _e1238 = phi_2238_;
                                let _e1240 = phi_2239_;
                                let _e1242 = phi_2240_;
                                let _e1244 = phi_2241_;
                                let _e1246 = phi_2242_;
                                phi_2454_ = _e1236;
                                phi_714_ = _e1238;
                                phi_717_ = _e1240;
                                phi_719_ = _e1242;
                                phi_721_ = _e1244;
                                phi_723_ = _e1246;
                                phi_2243_ = _e419;
                            } else {
                                phi_2454_ = _e405;
                                phi_714_ = type_48();
                                phi_717_ = u32();
                                phi_719_ = u32();
                                phi_721_ = bool();
                                phi_723_ = u32();
                                phi_2243_ = false;
                            }
                            let _e1248 = phi_2454_;
                            let _e1250 = phi_714_;
                            let _e1252 = phi_717_;
                            let _e1254 = phi_719_;
                            let _e1256 = phi_721_;
                            let _e1258 = phi_723_;
                            let _e1260 = phi_2243_;
                            continue;
                            continuing {
                                phi_2316_ = _e1248;
                                phi_713_ = _e1250;
                                phi_716_ = _e1252;
                                phi_718_ = _e1254;
                                phi_720_ = _e1256;
                                phi_722_ = _e1258;
                                phi_2453_ = _e1248;
                                break if !(_e1260);
                            }
                        }
                        let _e1263 = phi_2453_;
                        if _e1263 {
                            break;
                        }
                        let _e1265 = local_3;
                        if _e1265.member_1 {
                        } else {
                            if _e87 {
                            } else {
                                break;
                            }
                            let _e1269 = global_5.member[_e79];
                            if _e80 {
                            } else {
                                break;
                            }
                            let _e1273 = global_4.member[_e79].member_1;
                            if _e87 {
                            } else {
                                break;
                            }
                            global_5.member[_e79] = type_24(_e1269.member, _e1269.member_1, _e1269.member_2, array<f32, 3>((_e1269.member_3[0] + (_e1273[0] * _e1269.member_1[0])), (_e1269.member_3[1] + (_e1273[1] * _e1269.member_1[1])), (_e1269.member_3[2] + (_e1273[2] * _e1269.member_1[2]))), _e1269.member_4);
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
