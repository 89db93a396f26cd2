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

struct type_21 {
    member: array<array<u32, 2>>,
}

struct type_27 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_28 {
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

struct type_40 {
    member: type_27,
    member_1: f32,
}

struct type_44 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_45 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_47 {
    member: array<type_28>,
}

struct type_49 {
    member: type_40,
    member_1: u32,
    member_2: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(1) 
var<storage> global_2: type_33;
@group(0) @binding(2) 
var<storage> global_3: type_15;
@group(0) @binding(3) 
var<storage> global_4: type_47;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_21;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_303_: i32;
    var phi_304_: i32;
    var phi_314_: bool;
    var phi_324_: u32;
    var phi_325_: u32;
    var phi_327_: bool;
    var phi_332_: u32;
    var phi_345_: i32;
    var phi_365_: i32;
    var phi_383_: f32;
    var phi_389_: f32;
    var phi_429_: f32;
    var phi_435_: f32;
    var phi_508_: f32;
    var phi_514_: f32;
    var phi_554_: f32;
    var phi_560_: f32;
    var phi_633_: f32;
    var phi_639_: f32;
    var phi_679_: f32;
    var phi_685_: f32;
    var phi_804_: i32;
    var phi_826_: u32;
    var phi_827_: u32;
    var phi_864_: i32;
    var phi_886_: u32;
    var phi_887_: u32;
    var phi_895_: f32;
    var phi_896_: f32;
    var phi_2679_: bool;
    var phi_912_: type_49;
    var phi_915_: u32;
    var phi_917_: bool;
    var phi_919_: u32;
    var phi_921_: u32;
    var phi_932_: bool;
    var phi_964_: bool;
    var phi_965_: u32;
    var phi_966_: u32;
    var phi_981_: type_49;
    var phi_984_: type_4;
    var phi_985_: type_4;
    var phi_1007_: type_4;
    var phi_1031_: u32;
    var phi_1123_: array<array<f32, 3>, 3>;
    var phi_2499_: bool;
    var phi_2514_: bool;
    var phi_2529_: bool;
    var phi_2544_: bool;
    var phi_2559_: bool;
    var phi_2574_: bool;
    var phi_1665_: f32;
    var phi_1666_: f32;
    var phi_1667_: f32;
    var phi_1668_: f32;
    var phi_1669_: vec3<f32>;
    var phi_1670_: vec3<f32>;
    var phi_1671_: vec3<f32>;
    var phi_1672_: vec3<f32>;
    var phi_2589_: bool;
    var phi_2604_: bool;
    var phi_2619_: bool;
    var phi_2634_: bool;
    var phi_2649_: bool;
    var phi_2664_: bool;
    var phi_1880_: f32;
    var phi_1900_: type_44;
    var phi_1901_: type_44;
    var phi_1904_: type_44;
    var phi_1905_: type_44;
    var phi_1906_: bool;
    var phi_1910_: type_44;
    var phi_1919_: type_27;
    var phi_1944_: bool;
    var phi_1945_: bool;
    var phi_1952_: type_49;
    var phi_1953_: type_49;
    var phi_1954_: type_49;
    var phi_982_: type_49;
    var phi_2673_: bool;
    var phi_2873_: bool;
    var phi_1955_: type_49;
    var phi_2020_: type_45;
    var phi_2385_: u32;
    var phi_2412_: u32;
    var phi_2413_: u32;
    var phi_2414_: u32;
    var phi_2416_: u32;
    var phi_2417_: u32;
    var phi_2418_: bool;
    var phi_2427_: u32;
    var phi_2432_: bool;
    var phi_2434_: u32;
    var phi_2439_: type_49;
    var phi_2440_: bool;
    var phi_2441_: u32;
    var phi_2442_: u32;
    var phi_2450_: type_49;
    var phi_2841_: bool;
    var phi_2454_: type_49;
    var phi_2455_: u32;
    var phi_2456_: bool;
    var phi_2457_: u32;
    var phi_2458_: u32;
    var phi_2840_: bool;
    var phi_2459_: type_49;
    var phi_2460_: u32;
    var phi_2461_: bool;
    var phi_2462_: u32;
    var phi_2463_: u32;
    var phi_2839_: bool;
    var phi_913_: type_49;
    var phi_916_: u32;
    var phi_918_: bool;
    var phi_920_: u32;
    var phi_922_: u32;
    var phi_2464_: bool;
    var phi_2838_: bool;
    var local_2: type_49;
    var local_3: type_49;
    var local_4: type_49;

    switch bitcast<i32>(0u) {
        default: {
            let _e68 = global;
            let _e70 = arrayLength((&global_2.member));
            let _e72 = arrayLength((&global_3.member));
            let _e80 = (_e68.x + (_e68.y * 2097152u));
            let _e83 = global_1.member[0u];
            let _e84 = bitcast<i32>(_e83);
            let _e85 = (_e80 < arrayLength((&global_4.member)));
            if _e85 {
                let _e86 = (_e80 < arrayLength((&global_5.member)));
                if _e86 {
                    if _e85 {
                    } else {
                        break;
                    }
                    let _e94 = global_4.member[_e80].member_2[0u];
                    let _e96 = (bitcast<u32>(_e94) & 2147483647u);
                    let _e101 = global_4.member[_e80].member_2[1u];
                    let _e103 = (bitcast<u32>(_e101) & 2147483647u);
                    let _e108 = global_4.member[_e80].member_2[2u];
                    let _e110 = (bitcast<u32>(_e108) & 2147483647u);
                    let _e115 = global_4.member[_e80].member[0u];
                    let _e117 = (bitcast<u32>(_e115) & 2147483647u);
                    let _e122 = global_4.member[_e80].member[1u];
                    let _e124 = (bitcast<u32>(_e122) & 2147483647u);
                    let _e129 = global_4.member[_e80].member[2u];
                    let _e131 = (bitcast<u32>(_e129) & 2147483647u);
                    let _e133 = select(_e103, _e96, (_e103 < _e96));
                    let _e135 = select(_e110, _e133, (_e110 < _e133));
                    let _e137 = select(_e117, _e135, (_e117 < _e135));
                    let _e139 = select(_e124, _e137, (_e124 < _e137));
                    let _e141 = select(_e131, _e139, (_e131 < _e139));
                    let _e145 = global_4.member[_e80].member_1;
                    let _e146 = bitcast<u32>(_e145);
                    let _e147 = (_e146 & 2147483647u);
                    let _e154 = global_4.member[_e80].member_3;
                    let _e155 = bitcast<u32>(_e154);
                    let _e156 = (_e155 & 2147483647u);
                    let _e160 = (((select(_e147, _e141, (_e147 < _e141)) < 2139095040u) && (_e156 <= 2139095040u)) && (_e135 > 0u));
                    if _e160 {
                        let _e163 = (bitcast<u32>(bitcast<f32>(_e135)) & 2147483647u);
                        if (_e163 >= 8388608u) {
                            phi_303_ = (bitcast<i32>((_e163 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_303_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e163)), 32u, (_e163 == 0u))));
                        }
                        let _e177 = phi_303_;
                        phi_304_ = _e177;
                    } else {
                        phi_304_ = 0i;
                    }
                    let _e179 = phi_304_;
                    let _e180 = (_e96 == _e135);
                    if _e180 {
                        phi_314_ = true;
                    } else {
                        phi_314_ = (_e103 == _e135);
                    }
                    let _e183 = phi_314_;
                    let _e184 = select(1u, 0u, _e180);
                    if _e183 {
                        let _e185 = (_e184 + 1u);
                        phi_324_ = _e185;
                        phi_325_ = _e185;
                        phi_327_ = select(true, false, (_e185 == 2u));
                    } else {
                        phi_324_ = u32();
                        phi_325_ = 0u;
                        phi_327_ = true;
                    }
                    let _e189 = phi_324_;
                    let _e191 = phi_325_;
                    let _e193 = phi_327_;
                    if _e193 {
                        phi_332_ = (_e191 + 1u);
                    } else {
                        phi_332_ = 0u;
                    }
                    let _e197 = phi_332_;
                    let _e198 = select(_e189, _e191, _e193);
                    let _e199 = select(_e184, select(2u, _e184, _e183), _e193);
                    if (_e84 < -126i) {
                        phi_345_ = -126i;
                    } else {
                        phi_345_ = select(_e84, 127i, (_e84 > 127i));
                    }
                    let _e204 = phi_345_;
                    let _e209 = bitcast<f32>((bitcast<u32>((_e204 + 127i)) << bitcast<u32>(23i)));
                    let _e215 = bitcast<f32>((bitcast<u32>(((_e84 - _e204) + 127i)) << bitcast<u32>(23i)));
                    let _e216 = -(_e179);
                    if (_e216 < -126i) {
                        phi_365_ = -126i;
                    } else {
                        phi_365_ = select(_e216, 127i, (_e216 > 127i));
                    }
                    let _e221 = phi_365_;
                    let _e226 = bitcast<f32>((bitcast<u32>((_e221 + 127i)) << bitcast<u32>(23i)));
                    let _e232 = bitcast<f32>((bitcast<u32>(((_e216 - _e221) + 127i)) << bitcast<u32>(23i)));
                    let _e236 = global_4.member[_e80].member;
                    let _e237 = (_e198 == 0u);
                    if _e237 {
                        phi_383_ = _e236[0];
                    } else {
                        phi_383_ = _e236[1];
                    }
                    let _e241 = phi_383_;
                    let _e242 = (_e198 == 2u);
                    if _e242 {
                        phi_389_ = _e236[2];
                    } else {
                        phi_389_ = _e241;
                    }
                    let _e245 = phi_389_;
                    let _e246 = bitcast<u32>(_e245);
                    let _e248 = ((_e246 & 2139095040u) != 0u);
                    let _e262 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e246 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e246 & 2147483648u))), _e245, _e248) * _e209) * select(0.00000011920929f, 1f, _e248)) * _e215);
                    let _e263 = global_4.member[_e80].member_2;
                    if _e237 {
                        phi_429_ = _e263[0];
                    } else {
                        phi_429_ = _e263[1];
                    }
                    let _e267 = phi_429_;
                    if _e242 {
                        phi_435_ = _e263[2];
                    } else {
                        phi_435_ = _e267;
                    }
                    let _e270 = phi_435_;
                    let _e271 = bitcast<u32>(_e270);
                    let _e273 = ((_e271 & 2139095040u) != 0u);
                    let _e287 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e271 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e271 & 2147483648u))), _e270, _e273) * _e226) * select(0.00000011920929f, 1f, _e273)) * _e232);
                    let _e291 = (bitcast<f32>((bitcast<u32>(_e287) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e294 = bitcast<f32>((bitcast<u32>(_e262) & 2147483647u));
                    let _e295 = (_e294 * 0.00000011920929f);
                    let _e298 = select(select(0.00000000000011368684f, _e295, (_e295 > 0.00000000000011368684f)), 0f, _e291);
                    let _e299 = select(0f, _e287, _e291);
                    let _e300 = (_e262 + _e298);
                    let _e301 = (_e262 - _e298);
                    let _e303 = select(38685626000000000000000000f, (1f / _e287), _e291);
                    let _e304 = (_e197 == 0u);
                    if _e304 {
                        phi_508_ = _e236[0];
                    } else {
                        phi_508_ = _e236[1];
                    }
                    let _e308 = phi_508_;
                    let _e309 = (_e197 == 2u);
                    if _e309 {
                        phi_514_ = _e236[2];
                    } else {
                        phi_514_ = _e308;
                    }
                    let _e312 = phi_514_;
                    let _e313 = bitcast<u32>(_e312);
                    let _e315 = ((_e313 & 2139095040u) != 0u);
                    let _e329 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e313 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e313 & 2147483648u))), _e312, _e315) * _e209) * select(0.00000011920929f, 1f, _e315)) * _e215);
                    if _e304 {
                        phi_554_ = _e263[0];
                    } else {
                        phi_554_ = _e263[1];
                    }
                    let _e333 = phi_554_;
                    if _e309 {
                        phi_560_ = _e263[2];
                    } else {
                        phi_560_ = _e333;
                    }
                    let _e336 = phi_560_;
                    let _e337 = bitcast<u32>(_e336);
                    let _e339 = ((_e337 & 2139095040u) != 0u);
                    let _e353 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e337 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e337 & 2147483648u))), _e336, _e339) * _e226) * select(0.00000011920929f, 1f, _e339)) * _e232);
                    let _e357 = (bitcast<f32>((bitcast<u32>(_e353) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e360 = bitcast<f32>((bitcast<u32>(_e329) & 2147483647u));
                    let _e361 = (_e360 * 0.00000011920929f);
                    let _e364 = select(select(0.00000000000011368684f, _e361, (_e361 > 0.00000000000011368684f)), 0f, _e357);
                    let _e365 = select(0f, _e353, _e357);
                    let _e366 = (_e329 + _e364);
                    let _e367 = (_e329 - _e364);
                    let _e369 = select(38685626000000000000000000f, (1f / _e353), _e357);
                    let _e370 = (_e199 == 0u);
                    if _e370 {
                        phi_633_ = _e236[0];
                    } else {
                        phi_633_ = _e236[1];
                    }
                    let _e374 = phi_633_;
                    let _e375 = (_e199 == 2u);
                    if _e375 {
                        phi_639_ = _e236[2];
                    } else {
                        phi_639_ = _e374;
                    }
                    let _e378 = phi_639_;
                    let _e379 = bitcast<u32>(_e378);
                    let _e381 = ((_e379 & 2139095040u) != 0u);
                    let _e395 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e379 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e379 & 2147483648u))), _e378, _e381) * _e209) * select(0.00000011920929f, 1f, _e381)) * _e215);
                    if _e370 {
                        phi_679_ = _e263[0];
                    } else {
                        phi_679_ = _e263[1];
                    }
                    let _e399 = phi_679_;
                    if _e375 {
                        phi_685_ = _e263[2];
                    } else {
                        phi_685_ = _e399;
                    }
                    let _e402 = phi_685_;
                    let _e403 = bitcast<u32>(_e402);
                    let _e405 = ((_e403 & 2139095040u) != 0u);
                    let _e419 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e403 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e403 & 2147483648u))), _e402, _e405) * _e226) * select(0.00000011920929f, 1f, _e405)) * _e232);
                    let _e423 = (bitcast<f32>((bitcast<u32>(_e419) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e426 = bitcast<f32>((bitcast<u32>(_e395) & 2147483647u));
                    let _e427 = (_e426 * 0.00000011920929f);
                    let _e430 = select(select(0.00000000000011368684f, _e427, (_e427 > 0.00000000000011368684f)), 0f, _e423);
                    let _e431 = select(0f, _e419, _e423);
                    let _e432 = (_e395 + _e430);
                    let _e433 = (_e395 - _e430);
                    let _e435 = select(38685626000000000000000000f, (1f / _e419), _e423);
                    let _e437 = select(_e360, _e294, (_e294 > _e360));
                    let _e440 = (_e84 + _e179);
                    if (_e160 && (select(_e426, _e437, (_e437 > _e426)) <= 1099511600000f)) {
                        let _e450 = ((_e147 & 8388607u) | (select(0u, 1u, ((_e147 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e453 = bitcast<i32>((_e147 >> bitcast<u32>(23i)));
                        let _e457 = (_e450 == 0u);
                        let _e460 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e450)), 32u, _e457)) - 8i);
                        if (_e453 == 255i) {
                            phi_804_ = 255i;
                        } else {
                            phi_804_ = (((_e453 + select(0i, 1i, (_e453 == 0i))) - _e460) + _e440);
                        }
                        let _e468 = phi_804_;
                        let _e478 = (_e468 <= 0i);
                        if _e478 {
                            phi_827_ = u32();
                        } else {
                            if _e457 {
                                phi_826_ = u32();
                            } else {
                                phi_826_ = select(((bitcast<u32>(_e468) << bitcast<u32>(23i)) | ((_e450 << bitcast<u32>(((_e460 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e468 >= 255i));
                            }
                            let _e482 = phi_826_;
                            phi_827_ = _e482;
                        }
                        let _e484 = phi_827_;
                        let _e496 = ((_e156 & 8388607u) | (select(0u, 1u, ((_e156 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e499 = bitcast<i32>((_e156 >> bitcast<u32>(23i)));
                        let _e503 = (_e496 == 0u);
                        let _e506 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e496)), 32u, _e503)) - 8i);
                        if (_e499 == 255i) {
                            phi_864_ = 255i;
                        } else {
                            phi_864_ = (((_e499 + select(0i, 1i, (_e499 == 0i))) - _e506) + _e440);
                        }
                        let _e514 = phi_864_;
                        let _e524 = (_e514 <= 0i);
                        if _e524 {
                            phi_887_ = u32();
                        } else {
                            if _e503 {
                                phi_886_ = u32();
                            } else {
                                phi_886_ = select(((bitcast<u32>(_e514) << bitcast<u32>(23i)) | ((_e496 << bitcast<u32>(((_e506 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e514 >= 255i));
                            }
                            let _e528 = phi_886_;
                            phi_887_ = _e528;
                        }
                        let _e530 = phi_887_;
                        phi_895_ = bitcast<f32>(((_e155 & 2147483648u) | select(_e530, 0u, select(_e503, true, _e524))));
                        phi_896_ = bitcast<f32>(((_e146 & 2147483648u) | select(_e484, 0u, select(_e457, true, _e478))));
                    } else {
                        phi_895_ = 0f;
                        phi_896_ = 1f;
                    }
                    let _e536 = phi_895_;
                    let _e538 = phi_896_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2679_ = false;
                    phi_912_ = type_49(type_40(type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e536), 0u, 0u);
                    phi_915_ = ((3u * _e70) + 1u);
                    phi_917_ = (_e538 <= _e536);
                    phi_919_ = 0u;
                    phi_921_ = select(0u, 2147483648u, (_e70 == 0u));
                    loop {
                        let _e547 = phi_2679_;
                        let _e549 = phi_912_;
                        let _e551 = phi_915_;
                        let _e553 = phi_917_;
                        let _e555 = phi_919_;
                        let _e557 = phi_921_;
                        local_2 = _e549;
                        local_3 = _e549;
                        if _e553 {
                            phi_932_ = true;
                        } else {
                            phi_932_ = (_e555 > 0u);
                        }
                        let _e560 = phi_932_;
                        if _e560 {
                            let _e561 = (_e551 > 0u);
                            if _e561 {
                                if _e553 {
                                    phi_964_ = _e553;
                                    phi_965_ = _e555;
                                    phi_966_ = _e557;
                                } else {
                                    let _e562 = (_e555 - 1u);
                                    let _e563 = (_e562 % 128u);
                                    let _e564 = (_e563 < 128u);
                                    if _e564 {
                                    } else {
                                        phi_2838_ = true;
                                        break;
                                    }
                                    let _e566 = local_1[_e563];
                                    if _e564 {
                                    } else {
                                        phi_2838_ = true;
                                        break;
                                    }
                                    let _e568 = local[_e563];
                                    phi_964_ = (_e568 <= _e549.member.member_1);
                                    phi_965_ = _e562;
                                    phi_966_ = _e566;
                                }
                                let _e573 = phi_964_;
                                let _e575 = phi_965_;
                                let _e577 = phi_966_;
                                if _e573 {
                                    let _e580 = ((_e577 & 2147483648u) != 0u);
                                    if _e580 {
                                        phi_981_ = _e549;
                                        phi_984_ = type_4(0u, ((_e577 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e587 = phi_981_;
                                            let _e589 = phi_984_;
                                            local_4 = _e587;
                                            if (_e589.member < _e589.member_1) {
                                                phi_985_ = type_4((_e589.member + 1u), _e589.member_1);
                                                phi_1007_ = type_4(1u, _e589.member);
                                            } else {
                                                phi_985_ = _e589;
                                                phi_1007_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e602 = phi_985_;
                                            let _e604 = phi_1007_;
                                            let _e608 = (bitcast<i32>(_e604.member) != 0i);
                                            if _e608 {
                                                let _e614 = type_49(_e587.member, _e587.member_1, (_e587.member_2 + 1u));
                                                let _e615 = ((_e577 & 268435455u) + _e604.member_1);
                                                let _e616 = (_e615 < _e72);
                                                if _e616 {
                                                    if _e616 {
                                                    } else {
                                                        phi_2673_ = true;
                                                        break;
                                                    }
                                                    let _e620 = global_3.member[_e615].member_1;
                                                    phi_1031_ = _e620;
                                                } else {
                                                    phi_1031_ = 4294967295u;
                                                }
                                                let _e622 = phi_1031_;
                                                if (_e615 >= _e72) {
                                                    phi_1123_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e616 {
                                                    } else {
                                                        phi_2673_ = true;
                                                        break;
                                                    }
                                                    let _e624 = (_e198 % 3u);
                                                    let _e625 = (_e197 % 3u);
                                                    let _e626 = (_e199 % 3u);
                                                    if (_e624 < 9u) {
                                                    } else {
                                                        phi_2673_ = true;
                                                        break;
                                                    }
                                                    let _e632 = global_3.member[_e615].member[_e624];
                                                    if (_e625 < 9u) {
                                                    } else {
                                                        phi_2673_ = true;
                                                        break;
                                                    }
                                                    let _e638 = global_3.member[_e615].member[_e625];
                                                    if (_e626 < 9u) {
                                                    } else {
                                                        phi_2673_ = true;
                                                        break;
                                                    }
                                                    let _e644 = global_3.member[_e615].member[_e626];
                                                    let _e646 = (3u + _e624);
                                                    if (_e646 < 9u) {
                                                    } else {
                                                        phi_2673_ = true;
                                                        break;
                                                    }
                                                    let _e652 = global_3.member[_e615].member[_e646];
                                                    let _e653 = (3u + _e625);
                                                    if (_e653 < 9u) {
                                                    } else {
                                                        phi_2673_ = true;
                                                        break;
                                                    }
                                                    let _e659 = global_3.member[_e615].member[_e653];
                                                    let _e660 = (3u + _e626);
                                                    if (_e660 < 9u) {
                                                    } else {
                                                        phi_2673_ = true;
                                                        break;
                                                    }
                                                    let _e666 = global_3.member[_e615].member[_e660];
                                                    let _e668 = (6u + _e624);
                                                    if (_e668 < 9u) {
                                                    } else {
                                                        phi_2673_ = true;
                                                        break;
                                                    }
                                                    let _e674 = global_3.member[_e615].member[_e668];
                                                    let _e675 = (6u + _e625);
                                                    if (_e675 < 9u) {
                                                    } else {
                                                        phi_2673_ = true;
                                                        break;
                                                    }
                                                    let _e681 = global_3.member[_e615].member[_e675];
                                                    let _e682 = (6u + _e626);
                                                    if (_e682 < 9u) {
                                                    } else {
                                                        phi_2673_ = true;
                                                        break;
                                                    }
                                                    let _e688 = global_3.member[_e615].member[_e682];
                                                    phi_1123_ = array<array<f32, 3>, 3>(array<f32, 3>(_e632, _e638, _e644), array<f32, 3>(_e652, _e659, _e666), array<f32, 3>(_e674, _e681, _e688));
                                                }
                                                let _e692 = phi_1123_;
                                                let _e709 = (_e692[0][2] - _e395);
                                                let _e712 = (((_e692[0][0] - _e262) * _e431) - (_e709 * _e299));
                                                let _e715 = (((_e692[0][1] - _e329) * _e431) - (_e709 * _e365));
                                                let _e718 = (_e692[1][2] - _e395);
                                                let _e721 = (((_e692[1][0] - _e262) * _e431) - (_e718 * _e299));
                                                let _e724 = (((_e692[1][1] - _e329) * _e431) - (_e718 * _e365));
                                                let _e727 = (_e692[2][2] - _e395);
                                                let _e730 = (((_e692[2][0] - _e262) * _e431) - (_e727 * _e299));
                                                let _e733 = (((_e692[2][1] - _e329) * _e431) - (_e727 * _e365));
                                                let _e734 = (_e730 * _e724);
                                                let _e735 = (_e733 * _e721);
                                                let _e736 = (_e712 * _e733);
                                                let _e737 = (_e715 * _e730);
                                                let _e738 = (_e721 * _e715);
                                                let _e739 = (_e724 * _e712);
                                                let _e744 = (((_e734 >= _e735) && (_e736 >= _e737)) && (_e738 >= _e739));
                                                let _e750 = (_e744 || (((_e734 <= _e735) && (_e736 <= _e737)) && (_e738 <= _e739)));
                                                if _e750 {
                                                    let _e752 = select(-1f, 1f, _e744);
                                                    let _e754 = ((_e734 - _e735) * _e752);
                                                    let _e756 = select(0f, _e754, (_e754 > 0f));
                                                    let _e758 = ((_e736 - _e737) * _e752);
                                                    let _e760 = select(0f, _e758, (_e758 > 0f));
                                                    let _e762 = ((_e738 - _e739) * _e752);
                                                    let _e764 = select(0f, _e762, (_e762 > 0f));
                                                    let _e766 = ((_e756 + _e760) + _e764);
                                                    let _e768 = select(_e692[1][0], _e692[0][0], (_e692[0][0] < _e692[1][0]));
                                                    let _e772 = select(_e692[1][0], _e692[0][0], (_e692[0][0] > _e692[1][0]));
                                                    let _e776 = select(_e692[1][1], _e692[0][1], (_e692[0][1] < _e692[1][1]));
                                                    let _e780 = select(_e692[1][1], _e692[0][1], (_e692[0][1] > _e692[1][1]));
                                                    let _e784 = select(_e692[1][2], _e692[0][2], (_e692[0][2] < _e692[1][2]));
                                                    let _e788 = select(_e692[1][2], _e692[0][2], (_e692[0][2] > _e692[1][2]));
                                                    let _e793 = ((select(_e692[2][0], _e768, (_e768 < _e692[2][0])) - _e300) * _e303);
                                                    let _e794 = ((select(_e692[2][0], _e772, (_e772 > _e692[2][0])) - _e301) * _e303);
                                                    let _e797 = ((select(_e692[2][1], _e776, (_e776 < _e692[2][1])) - _e366) * _e369);
                                                    let _e798 = ((select(_e692[2][1], _e780, (_e780 > _e692[2][1])) - _e367) * _e369);
                                                    let _e801 = ((select(_e692[2][2], _e784, (_e784 < _e692[2][2])) - _e432) * _e435);
                                                    let _e802 = ((select(_e692[2][2], _e788, (_e788 > _e692[2][2])) - _e433) * _e435);
                                                    let _e804 = select(_e802, _e801, (_e801 < _e802));
                                                    let _e806 = select(_e802, _e801, (_e801 > _e802));
                                                    let _e808 = select(_e794, _e793, (_e793 < _e794));
                                                    let _e810 = select(_e798, _e797, (_e797 < _e798));
                                                    let _e812 = select(_e810, _e808, (_e808 > _e810));
                                                    let _e814 = select(_e804, _e812, (_e812 > _e804));
                                                    let _e816 = select(_e794, _e793, (_e793 > _e794));
                                                    let _e818 = select(_e798, _e797, (_e797 > _e798));
                                                    let _e820 = select(_e818, _e816, (_e816 < _e818));
                                                    let _e822 = select(_e806, _e820, (_e820 < _e806));
                                                    let _e823 = -(_e804);
                                                    let _e829 = select(_e538, _e814, (_e814 > _e538));
                                                    let _e833 = select(_e721, _e712, (_e712 < _e721));
                                                    let _e838 = select(_e721, _e712, (_e712 > _e721));
                                                    let _e845 = select(_e724, _e715, (_e715 < _e724));
                                                    let _e850 = select(_e724, _e715, (_e715 > _e724));
                                                    let _e859 = (((((_e750 && (_e766 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e730, _e833, (_e833 < _e730)) <= 0f) && (select(_e730, _e838, (_e838 > _e730)) >= 0f))) && ((select(_e733, _e845, (_e845 < _e733)) <= 0f) && (select(_e733, _e850, (_e850 > _e733)) >= 0f))) && (_e829 <= (_e822 + (select(_e823, _e806, (_e806 > _e823)) * 0.0000019073523f)))) && (_e829 <= _e587.member.member_1));
                                                    if _e859 {
                                                        let _e864 = (_e692[1][0] - _e692[0][0]);
                                                        let _e865 = (_e692[1][1] - _e692[0][1]);
                                                        let _e866 = (_e692[1][2] - _e692[0][2]);
                                                        let _e867 = vec3<f32>(_e864, _e865, _e866);
                                                        let _e868 = (_e692[2][0] - _e692[1][0]);
                                                        let _e869 = (_e692[2][1] - _e692[1][1]);
                                                        let _e870 = (_e692[2][2] - _e692[1][2]);
                                                        let _e871 = vec3<f32>(_e868, _e869, _e870);
                                                        let _e872 = (_e692[0][0] - _e692[2][0]);
                                                        let _e873 = (_e692[0][1] - _e692[2][1]);
                                                        let _e874 = (_e692[0][2] - _e692[2][2]);
                                                        let _e875 = vec3<f32>(_e872, _e873, _e874);
                                                        let _e876 = abs(_e864);
                                                        let _e877 = abs(_e865);
                                                        if (_e876 != _e876) {
                                                            phi_2499_ = true;
                                                        } else {
                                                            phi_2499_ = (_e877 >= _e876);
                                                        }
                                                        let _e881 = phi_2499_;
                                                        let _e882 = select(_e876, _e877, _e881);
                                                        let _e883 = abs(_e866);
                                                        if (_e882 != _e882) {
                                                            phi_2514_ = true;
                                                        } else {
                                                            phi_2514_ = (_e883 >= _e882);
                                                        }
                                                        let _e887 = phi_2514_;
                                                        let _e888 = select(_e882, _e883, _e887);
                                                        let _e889 = abs(_e868);
                                                        let _e890 = abs(_e869);
                                                        if (_e889 != _e889) {
                                                            phi_2529_ = true;
                                                        } else {
                                                            phi_2529_ = (_e890 >= _e889);
                                                        }
                                                        let _e894 = phi_2529_;
                                                        let _e895 = select(_e889, _e890, _e894);
                                                        let _e896 = abs(_e870);
                                                        if (_e895 != _e895) {
                                                            phi_2544_ = true;
                                                        } else {
                                                            phi_2544_ = (_e896 >= _e895);
                                                        }
                                                        let _e900 = phi_2544_;
                                                        let _e901 = select(_e895, _e896, _e900);
                                                        let _e902 = abs(_e872);
                                                        let _e903 = abs(_e873);
                                                        if (_e902 != _e902) {
                                                            phi_2559_ = true;
                                                        } else {
                                                            phi_2559_ = (_e903 >= _e902);
                                                        }
                                                        let _e907 = phi_2559_;
                                                        let _e908 = select(_e902, _e903, _e907);
                                                        let _e909 = abs(_e874);
                                                        if (_e908 != _e908) {
                                                            phi_2574_ = true;
                                                        } else {
                                                            phi_2574_ = (_e909 >= _e908);
                                                        }
                                                        let _e913 = phi_2574_;
                                                        let _e914 = select(_e908, _e909, _e913);
                                                        let _e916 = select(_e901, _e888, (_e888 > _e901));
                                                        let _e918 = select(_e914, _e916, (_e916 > _e914));
                                                        if (_e888 == _e918) {
                                                            phi_1665_ = _e724;
                                                            phi_1666_ = _e721;
                                                            phi_1667_ = _e715;
                                                            phi_1668_ = _e712;
                                                            phi_1669_ = vec3<f32>(_e692[0][0], _e692[0][1], _e692[0][2]);
                                                            phi_1670_ = _e875;
                                                            phi_1671_ = _e871;
                                                            phi_1672_ = _e867;
                                                        } else {
                                                            let _e920 = (_e901 == _e918);
                                                            let _e925 = vec3(_e920);
                                                            phi_1665_ = select(_e715, _e733, _e920);
                                                            phi_1666_ = select(_e712, _e730, _e920);
                                                            phi_1667_ = select(_e733, _e724, _e920);
                                                            phi_1668_ = select(_e730, _e721, _e920);
                                                            phi_1669_ = select(vec3<f32>(_e692[2][0], _e692[2][1], _e692[2][2]), vec3<f32>(_e692[1][0], _e692[1][1], _e692[1][2]), _e925);
                                                            phi_1670_ = select(_e871, _e867, _e925);
                                                            phi_1671_ = select(_e867, _e875, _e925);
                                                            phi_1672_ = select(_e875, _e871, _e925);
                                                        }
                                                        let _e931 = phi_1665_;
                                                        let _e933 = phi_1666_;
                                                        let _e935 = phi_1667_;
                                                        let _e937 = phi_1668_;
                                                        let _e939 = phi_1669_;
                                                        let _e941 = phi_1670_;
                                                        let _e943 = phi_1671_;
                                                        let _e945 = phi_1672_;
                                                        let _e952 = ((_e943.y * _e941.z) - (_e941.y * _e943.z));
                                                        let _e957 = ((_e943.z * _e941.x) - (_e941.z * _e943.x));
                                                        let _e960 = ((_e943.x * _e941.y) - (_e941.x * _e943.y));
                                                        let _e963 = ((_e756 >= _e760) && (_e756 >= _e764));
                                                        let _e964 = (_e760 >= _e764);
                                                        let _e978 = (((_e952 * (select(select(_e692[2][0], _e692[1][0], _e964), _e692[0][0], _e963) - _e262)) + (_e957 * (select(select(_e692[2][1], _e692[1][1], _e964), _e692[0][1], _e963) - _e329))) + (_e960 * (select(select(_e692[2][2], _e692[1][2], _e964), _e692[0][2], _e963) - _e395)));
                                                        let _e983 = (((_e952 * _e299) + (_e957 * _e365)) + (_e960 * _e431));
                                                        let _e984 = (_e933 - _e937);
                                                        let _e985 = (_e931 - _e935);
                                                        let _e988 = ((_e984 * _e984) + (_e985 * _e985));
                                                        let _e995 = (-(((_e937 * _e984) + (_e935 * _e985))) / select(0.000000000000000000000000000000000000011754944f, _e988, (_e988 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e997 = select(1f, _e995, (_e995 < 1f));
                                                        let _e999 = select(0f, _e997, (_e997 > 0f));
                                                        let _e1008 = ((_e939.x + (_e945.x * _e999)) - _e262);
                                                        let _e1011 = ((_e939.y + (_e945.y * _e999)) - _e329);
                                                        let _e1014 = ((_e939.z + (_e945.z * _e999)) - _e395);
                                                        let _e1017 = bitcast<f32>((bitcast<u32>(_e1008) & 2147483647u));
                                                        let _e1020 = bitcast<f32>((bitcast<u32>(_e1011) & 2147483647u));
                                                        let _e1022 = select(_e1020, _e1017, (_e1017 > _e1020));
                                                        let _e1025 = bitcast<f32>((bitcast<u32>(_e1014) & 2147483647u));
                                                        let _e1027 = select(_e1025, _e1022, (_e1022 > _e1025));
                                                        let _e1031 = abs(_e952);
                                                        let _e1032 = abs(_e957);
                                                        if (_e1031 != _e1031) {
                                                            phi_2589_ = true;
                                                        } else {
                                                            phi_2589_ = (_e1032 >= _e1031);
                                                        }
                                                        let _e1036 = phi_2589_;
                                                        let _e1037 = select(_e1031, _e1032, _e1036);
                                                        let _e1038 = abs(_e960);
                                                        if (_e1037 != _e1037) {
                                                            phi_2604_ = true;
                                                        } else {
                                                            phi_2604_ = (_e1038 >= _e1037);
                                                        }
                                                        let _e1042 = phi_2604_;
                                                        let _e1058 = abs(_e943.x);
                                                        let _e1059 = abs(_e943.y);
                                                        if (_e1058 != _e1058) {
                                                            phi_2619_ = true;
                                                        } else {
                                                            phi_2619_ = (_e1059 >= _e1058);
                                                        }
                                                        let _e1063 = phi_2619_;
                                                        let _e1064 = select(_e1058, _e1059, _e1063);
                                                        let _e1065 = abs(_e943.z);
                                                        if (_e1064 != _e1064) {
                                                            phi_2634_ = true;
                                                        } else {
                                                            phi_2634_ = (_e1065 >= _e1064);
                                                        }
                                                        let _e1069 = phi_2634_;
                                                        let _e1072 = abs(_e941.x);
                                                        let _e1073 = abs(_e941.y);
                                                        if (_e1072 != _e1072) {
                                                            phi_2649_ = true;
                                                        } else {
                                                            phi_2649_ = (_e1073 >= _e1072);
                                                        }
                                                        let _e1077 = phi_2649_;
                                                        let _e1078 = select(_e1072, _e1073, _e1077);
                                                        let _e1079 = abs(_e941.z);
                                                        if (_e1078 != _e1078) {
                                                            phi_2664_ = true;
                                                        } else {
                                                            phi_2664_ = (_e1079 >= _e1078);
                                                        }
                                                        let _e1083 = phi_2664_;
                                                        let _e1088 = ((bitcast<f32>((bitcast<u32>(((((_e952 * _e1008) + (_e957 * _e1011)) + (_e960 * _e1014)) - _e978)) & 2147483647u)) <= ((0.0000009536743f * select(_e918, _e1027, (_e1027 > _e918))) * select(_e1037, _e1038, _e1042))) && !((bitcast<f32>((bitcast<u32>(_e983) & 2147483647u)) <= ((0.0000038146973f * select(_e1064, _e1065, _e1069)) * select(_e1078, _e1079, _e1083)))));
                                                        let _e1089 = (_e978 / _e983);
                                                        if (_e859 && !(_e1088)) {
                                                            let _e1092 = (_e1014 / _e431);
                                                            let _e1100 = (((_e952 * (_e1008 - (_e299 * _e1092))) + (_e957 * (_e1011 - (_e365 * _e1092)))) / _e983);
                                                            phi_1880_ = select(select(_e1092, (_e1092 + _e1100), (bitcast<f32>((bitcast<u32>(_e1100) & 2147483647u)) <= _e918)), _e1089, _e1088);
                                                        } else {
                                                            phi_1880_ = _e1089;
                                                        }
                                                        let _e1109 = phi_1880_;
                                                        let _e1111 = select(_e822, _e1109, (_e1109 < _e822));
                                                        let _e1113 = select(_e814, _e1111, (_e1111 > _e814));
                                                        let _e1114 = (1f / _e766);
                                                        phi_1900_ = type_44(_e1113, (_e760 * _e1114), (_e764 * _e1114), ((_e859 && (_e1113 >= _e538)) && (_e1113 <= _e587.member.member_1)));
                                                        phi_1901_ = type_44();
                                                    } else {
                                                        phi_1900_ = type_44();
                                                        phi_1901_ = type_44(0f, 0f, 0f, _e859);
                                                    }
                                                    let _e1123 = phi_1900_;
                                                    let _e1125 = phi_1901_;
                                                    phi_1904_ = _e1123;
                                                    phi_1905_ = _e1125;
                                                    phi_1906_ = select(true, false, _e859);
                                                } else {
                                                    phi_1904_ = type_44();
                                                    phi_1905_ = type_44(0f, 0f, 0f, _e750);
                                                    phi_1906_ = true;
                                                }
                                                let _e1128 = phi_1904_;
                                                let _e1130 = phi_1905_;
                                                let _e1132 = phi_1906_;
                                                if _e1132 {
                                                    phi_1910_ = _e1130;
                                                } else {
                                                    phi_1910_ = _e1128;
                                                }
                                                let _e1134 = phi_1910_;
                                                if _e1134.member_3 {
                                                    phi_1919_ = type_27(_e1134.member, _e1134.member_1, _e1134.member_2, _e622);
                                                } else {
                                                    phi_1919_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1141 = phi_1919_;
                                                if (_e1141.member_3 != 4294967295u) {
                                                    if (_e622 != 4294967295u) {
                                                        if (_e1141.member < _e587.member.member.member) {
                                                            phi_1945_ = true;
                                                        } else {
                                                            if (_e1141.member == _e587.member.member.member) {
                                                                phi_1944_ = (_e1141.member_3 < _e587.member.member.member_3);
                                                            } else {
                                                                phi_1944_ = false;
                                                            }
                                                            let _e1156 = phi_1944_;
                                                            phi_1945_ = _e1156;
                                                        }
                                                        let _e1158 = phi_1945_;
                                                        if _e1158 {
                                                            phi_1952_ = type_49(type_40(_e1141, _e1141.member), _e614.member_1, _e614.member_2);
                                                        } else {
                                                            phi_1952_ = _e614;
                                                        }
                                                        let _e1165 = phi_1952_;
                                                        phi_1953_ = _e1165;
                                                    } else {
                                                        phi_1953_ = _e614;
                                                    }
                                                    let _e1167 = phi_1953_;
                                                    phi_1954_ = _e1167;
                                                } else {
                                                    phi_1954_ = _e614;
                                                }
                                                let _e1169 = phi_1954_;
                                                phi_982_ = _e1169;
                                            } else {
                                                phi_982_ = type_49();
                                            }
                                            let _e1171 = phi_982_;
                                            continue;
                                            continuing {
                                                phi_981_ = _e1171;
                                                phi_984_ = _e602;
                                                phi_2673_ = _e547;
                                                break if !(_e608);
                                            }
                                        }
                                        let _e1174 = phi_2673_;
                                        phi_2838_ = _e1174;
                                        if _e1174 {
                                            break;
                                        }
                                        phi_2873_ = _e1174;
                                        let _e1522 = local_4;
                                        phi_1955_ = _e1522;
                                    } else {
                                        phi_2873_ = _e547;
                                        phi_1955_ = _e549;
                                    }
                                    let _e1176 = phi_2873_;
                                    let _e1178 = phi_1955_;
                                    if _e580 {
                                        phi_2439_ = type_49();
                                        phi_2440_ = bool();
                                        phi_2441_ = u32();
                                        phi_2442_ = u32();
                                    } else {
                                        if (_e577 >= _e70) {
                                            phi_2020_ = type_45(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e577 < _e70) {
                                            } else {
                                                phi_2838_ = true;
                                                break;
                                            }
                                            let _e1181 = (_e198 % 3u);
                                            if (_e1181 < 3u) {
                                            } else {
                                                phi_2838_ = true;
                                                break;
                                            }
                                            let _e1187 = global_2.member[_e577].member[_e1181];
                                            let _e1193 = (_e197 % 3u);
                                            if (_e1193 < 3u) {
                                            } else {
                                                phi_2838_ = true;
                                                break;
                                            }
                                            let _e1199 = global_2.member[_e577].member[_e1193];
                                            let _e1205 = (_e199 % 3u);
                                            if (_e1205 < 3u) {
                                            } else {
                                                phi_2838_ = true;
                                                break;
                                            }
                                            let _e1211 = global_2.member[_e577].member[_e1205];
                                            let _e1221 = global_2.member[_e577].member_1;
                                            let _e1225 = global_2.member[_e577].member_2;
                                            phi_2020_ = type_45(array<vec4<f32>, 3>(vec4<f32>(_e1187[0], _e1187[1], _e1187[2], _e1187[3]), vec4<f32>(_e1199[0], _e1199[1], _e1199[2], _e1199[3]), vec4<f32>(_e1211[0], _e1211[1], _e1211[2], _e1211[3])), _e1221, _e1225);
                                        }
                                        let _e1228 = phi_2020_;
                                        let _e1247 = ((_e1228.member[0].x - _e300) * _e303);
                                        let _e1248 = ((_e1228.member[0].y - _e300) * _e303);
                                        let _e1249 = ((_e1228.member[0].z - _e301) * _e303);
                                        let _e1250 = ((_e1228.member[0].w - _e301) * _e303);
                                        let _e1260 = ((_e1228.member[1].x - _e366) * _e369);
                                        let _e1261 = ((_e1228.member[1].y - _e366) * _e369);
                                        let _e1262 = ((_e1228.member[1].z - _e367) * _e369);
                                        let _e1263 = ((_e1228.member[1].w - _e367) * _e369);
                                        let _e1273 = ((_e1228.member[2].x - _e432) * _e435);
                                        let _e1274 = ((_e1228.member[2].y - _e432) * _e435);
                                        let _e1275 = ((_e1228.member[2].z - _e433) * _e435);
                                        let _e1276 = ((_e1228.member[2].w - _e433) * _e435);
                                        let _e1278 = select(_e1275, _e1273, (_e1273 < _e1275));
                                        let _e1280 = select(_e1276, _e1274, (_e1274 < _e1276));
                                        let _e1282 = select(_e1275, _e1273, (_e1273 > _e1275));
                                        let _e1284 = select(_e1276, _e1274, (_e1274 > _e1276));
                                        let _e1286 = select(_e1249, _e1247, (_e1247 < _e1249));
                                        let _e1288 = select(_e1250, _e1248, (_e1248 < _e1250));
                                        let _e1290 = select(_e1262, _e1260, (_e1260 < _e1262));
                                        let _e1292 = select(_e1263, _e1261, (_e1261 < _e1263));
                                        let _e1294 = select(_e1290, _e1286, (_e1286 > _e1290));
                                        let _e1296 = select(_e1292, _e1288, (_e1288 > _e1292));
                                        let _e1298 = select(_e1278, _e1294, (_e1294 > _e1278));
                                        let _e1300 = select(_e1280, _e1296, (_e1296 > _e1280));
                                        let _e1302 = select(_e1249, _e1247, (_e1247 > _e1249));
                                        let _e1304 = select(_e1250, _e1248, (_e1248 > _e1250));
                                        let _e1306 = select(_e1262, _e1260, (_e1260 > _e1262));
                                        let _e1308 = select(_e1263, _e1261, (_e1261 > _e1263));
                                        let _e1310 = select(_e1306, _e1302, (_e1302 < _e1306));
                                        let _e1312 = select(_e1308, _e1304, (_e1304 < _e1308));
                                        let _e1317 = -(_e1278);
                                        let _e1318 = -(_e1280);
                                        let _e1325 = (select(_e1282, _e1310, (_e1310 < _e1282)) + (select(_e1317, _e1282, (_e1282 > _e1317)) * 0.0000019073523f));
                                        let _e1326 = (select(_e1284, _e1312, (_e1312 < _e1284)) + (select(_e1318, _e1284, (_e1284 > _e1318)) * 0.0000019073523f));
                                        let _e1328 = select(_e538, _e1298, (_e1298 > _e538));
                                        let _e1330 = select(_e538, _e1300, (_e1300 > _e538));
                                        let _e1335 = (_e1328 <= select(_e1178.member.member_1, _e1325, (_e1325 < _e1178.member.member_1)));
                                        let _e1336 = (_e1330 <= select(_e1178.member.member_1, _e1326, (_e1326 < _e1178.member.member_1)));
                                        let _e1337 = (_e1328 <= _e1330);
                                        if _e1335 {
                                            if _e1336 {
                                                if _e1337 {
                                                    phi_2385_ = _e1228.member_2;
                                                } else {
                                                    phi_2385_ = _e1228.member_1;
                                                }
                                                let _e1341 = phi_2385_;
                                                let _e1343 = (_e575 % 128u);
                                                let _e1344 = (_e1343 < 128u);
                                                if _e1344 {
                                                } else {
                                                    phi_2838_ = true;
                                                    break;
                                                }
                                                local_1[_e1343] = _e1341;
                                                if _e1344 {
                                                } else {
                                                    phi_2838_ = true;
                                                    break;
                                                }
                                                local[_e1343] = select(_e1328, _e1330, _e1337);
                                                if _e1337 {
                                                    phi_2412_ = _e1228.member_1;
                                                } else {
                                                    phi_2412_ = _e1228.member_2;
                                                }
                                                let _e1351 = phi_2412_;
                                                phi_2413_ = (_e575 + 1u);
                                                phi_2414_ = _e1351;
                                            } else {
                                                phi_2413_ = u32();
                                                phi_2414_ = u32();
                                            }
                                            let _e1353 = phi_2413_;
                                            let _e1355 = phi_2414_;
                                            phi_2416_ = _e1353;
                                            phi_2417_ = _e1355;
                                            phi_2418_ = select(true, false, _e1336);
                                        } else {
                                            phi_2416_ = u32();
                                            phi_2417_ = u32();
                                            phi_2418_ = true;
                                        }
                                        let _e1358 = phi_2416_;
                                        let _e1360 = phi_2417_;
                                        let _e1362 = phi_2418_;
                                        if _e1362 {
                                            if _e1335 {
                                                phi_2427_ = _e1228.member_1;
                                            } else {
                                                phi_2427_ = _e1228.member_2;
                                            }
                                            let _e1366 = phi_2427_;
                                            phi_2432_ = select(_e1336, true, _e1335);
                                            phi_2434_ = _e1366;
                                        } else {
                                            phi_2432_ = _e573;
                                            phi_2434_ = _e1360;
                                        }
                                        let _e1369 = phi_2432_;
                                        let _e1371 = phi_2434_;
                                        phi_2439_ = type_49(_e1178.member, (_e1178.member_1 + 1u), _e1178.member_2);
                                        phi_2440_ = _e1369;
                                        phi_2441_ = select(_e1358, _e575, _e1362);
                                        phi_2442_ = _e1371;
                                    }
                                    let _e1374 = phi_2439_;
                                    let _e1376 = phi_2440_;
                                    let _e1378 = phi_2441_;
                                    let _e1380 = phi_2442_;
                                    if _e580 {
                                        phi_2450_ = _e1178;
                                    } else {
                                        phi_2450_ = _e1374;
                                    }
                                    let _e1382 = phi_2450_;
                                    phi_2841_ = _e1176;
                                    phi_2454_ = _e1382;
                                    phi_2455_ = (_e551 - 1u);
                                    phi_2456_ = select(_e1376, false, _e580);
                                    phi_2457_ = select(_e1378, _e575, _e580);
                                    phi_2458_ = select(_e1380, _e577, _e580);
                                } else {
                                    phi_2841_ = _e547;
                                    phi_2454_ = _e549;
                                    phi_2455_ = _e551;
                                    phi_2456_ = _e573;
                                    phi_2457_ = _e575;
                                    phi_2458_ = _e577;
                                }
                                let _e1387 = phi_2841_;
                                let _e1389 = phi_2454_;
                                let _e1391 = phi_2455_;
                                let _e1393 = phi_2456_;
                                let _e1395 = phi_2457_;
                                let _e1397 = phi_2458_;
                                phi_2840_ = _e1387;
                                phi_2459_ = _e1389;
                                phi_2460_ = _e1391;
                                phi_2461_ = _e1393;
                                phi_2462_ = _e1395;
                                phi_2463_ = _e1397;
                            } else {
                                phi_2840_ = _e547;
                                phi_2459_ = type_49();
                                phi_2460_ = u32();
                                phi_2461_ = bool();
                                phi_2462_ = u32();
                                phi_2463_ = u32();
                            }
                            let _e1399 = phi_2840_;
                            let _e1401 = phi_2459_;
                            let _e1403 = phi_2460_;
                            let _e1405 = phi_2461_;
                            let _e1407 = phi_2462_;
                            let _e1409 = phi_2463_;
                            phi_2839_ = _e1399;
                            phi_913_ = _e1401;
                            phi_916_ = _e1403;
                            phi_918_ = _e1405;
                            phi_920_ = _e1407;
                            phi_922_ = _e1409;
                            phi_2464_ = _e561;
                        } else {
                            phi_2839_ = _e547;
                            phi_913_ = type_49();
                            phi_916_ = u32();
                            phi_918_ = bool();
                            phi_920_ = u32();
                            phi_922_ = u32();
                            phi_2464_ = false;
                        }
                        let _e1411 = phi_2839_;
                        let _e1413 = phi_913_;
                        let _e1415 = phi_916_;
                        let _e1417 = phi_918_;
                        let _e1419 = phi_920_;
                        let _e1421 = phi_922_;
                        let _e1423 = phi_2464_;
                        continue;
                        continuing {
                            phi_2679_ = _e1411;
                            phi_912_ = _e1413;
                            phi_915_ = _e1415;
                            phi_917_ = _e1417;
                            phi_919_ = _e1419;
                            phi_921_ = _e1421;
                            phi_2838_ = _e1411;
                            break if !(_e1423);
                        }
                    }
                    let _e1426 = phi_2838_;
                    if _e1426 {
                        break;
                    }
                    let _e1428 = local_2;
                    let _e1431 = local_3;
                    if _e86 {
                    } else {
                        break;
                    }
                    global_5.member[_e80][0u] = _e1428.member_1;
                    global_5.member[_e80][1u] = _e1431.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
