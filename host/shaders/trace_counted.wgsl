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
    var phi_310_: i32;
    var phi_311_: i32;
    var phi_321_: bool;
    var phi_331_: u32;
    var phi_332_: u32;
    var phi_334_: bool;
    var phi_339_: u32;
    var phi_352_: i32;
    var phi_372_: i32;
    var phi_390_: f32;
    var phi_396_: f32;
    var phi_436_: f32;
    var phi_442_: f32;
    var phi_515_: f32;
    var phi_521_: f32;
    var phi_561_: f32;
    var phi_567_: f32;
    var phi_640_: f32;
    var phi_646_: f32;
    var phi_686_: f32;
    var phi_692_: f32;
    var phi_811_: i32;
    var phi_833_: u32;
    var phi_834_: u32;
    var phi_871_: i32;
    var phi_893_: u32;
    var phi_894_: u32;
    var phi_902_: f32;
    var phi_903_: f32;
    var phi_2605_: bool;
    var phi_919_: type_49;
    var phi_922_: bool;
    var phi_924_: u32;
    var phi_926_: u32;
    var phi_928_: u32;
    var phi_939_: bool;
    var phi_971_: bool;
    var phi_972_: u32;
    var phi_973_: u32;
    var phi_1997_: type_45;
    var phi_2362_: u32;
    var phi_2389_: u32;
    var phi_2390_: u32;
    var phi_2391_: u32;
    var phi_2393_: u32;
    var phi_2394_: u32;
    var phi_2395_: bool;
    var phi_2404_: u32;
    var phi_2409_: bool;
    var phi_2410_: u32;
    var phi_988_: type_49;
    var phi_991_: type_4;
    var phi_992_: type_4;
    var phi_1014_: type_4;
    var phi_1038_: u32;
    var phi_1130_: array<array<f32, 3>, 3>;
    var phi_1660_: f32;
    var phi_1661_: f32;
    var phi_1662_: f32;
    var phi_1663_: f32;
    var phi_1664_: vec3<f32>;
    var phi_1665_: vec3<f32>;
    var phi_1666_: vec3<f32>;
    var phi_1667_: vec3<f32>;
    var phi_1858_: f32;
    var phi_1878_: type_44;
    var phi_1879_: type_44;
    var phi_1882_: type_44;
    var phi_1883_: type_44;
    var phi_1884_: bool;
    var phi_1888_: type_44;
    var phi_1897_: type_27;
    var phi_1922_: bool;
    var phi_1923_: bool;
    var phi_1930_: type_49;
    var phi_1931_: type_49;
    var phi_1932_: type_49;
    var phi_989_: type_49;
    var phi_2599_: bool;
    var local_2: type_49;
    var phi_2756_: bool;
    var phi_2412_: type_49;
    var phi_2413_: bool;
    var phi_2414_: u32;
    var phi_2415_: u32;
    var phi_2755_: bool;
    var phi_2416_: type_49;
    var phi_2417_: bool;
    var phi_2418_: u32;
    var phi_2419_: u32;
    var phi_2420_: u32;
    var phi_2754_: bool;
    var phi_2421_: type_49;
    var phi_2422_: bool;
    var phi_2423_: u32;
    var phi_2424_: u32;
    var phi_2425_: u32;
    var phi_2753_: bool;
    var phi_920_: type_49;
    var phi_923_: bool;
    var phi_925_: u32;
    var phi_927_: u32;
    var phi_929_: u32;
    var phi_2426_: bool;
    var phi_2752_: bool;
    var local_3: type_49;
    var local_4: type_49;
    var local_5: type_49;

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
                            phi_310_ = (bitcast<i32>((_e163 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_310_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e163)), 32u, (_e163 == 0u))));
                        }
                        let _e177 = phi_310_;
                        phi_311_ = _e177;
                    } else {
                        phi_311_ = 0i;
                    }
                    let _e179 = phi_311_;
                    let _e180 = (_e96 == _e135);
                    if _e180 {
                        phi_321_ = true;
                    } else {
                        phi_321_ = (_e103 == _e135);
                    }
                    let _e183 = phi_321_;
                    let _e184 = select(1u, 0u, _e180);
                    if _e183 {
                        let _e185 = (_e184 + 1u);
                        phi_331_ = _e185;
                        phi_332_ = _e185;
                        phi_334_ = select(true, false, (_e185 == 2u));
                    } else {
                        phi_331_ = u32();
                        phi_332_ = 0u;
                        phi_334_ = true;
                    }
                    let _e189 = phi_331_;
                    let _e191 = phi_332_;
                    let _e193 = phi_334_;
                    if _e193 {
                        phi_339_ = (_e191 + 1u);
                    } else {
                        phi_339_ = 0u;
                    }
                    let _e197 = phi_339_;
                    let _e198 = select(_e189, _e191, _e193);
                    let _e199 = select(_e184, select(2u, _e184, _e183), _e193);
                    if (_e84 < -126i) {
                        phi_352_ = -126i;
                    } else {
                        phi_352_ = select(_e84, 127i, (_e84 > 127i));
                    }
                    let _e204 = phi_352_;
                    let _e209 = bitcast<f32>((bitcast<u32>((_e204 + 127i)) << bitcast<u32>(23i)));
                    let _e215 = bitcast<f32>((bitcast<u32>(((_e84 - _e204) + 127i)) << bitcast<u32>(23i)));
                    let _e216 = -(_e179);
                    if (_e216 < -126i) {
                        phi_372_ = -126i;
                    } else {
                        phi_372_ = select(_e216, 127i, (_e216 > 127i));
                    }
                    let _e221 = phi_372_;
                    let _e226 = bitcast<f32>((bitcast<u32>((_e221 + 127i)) << bitcast<u32>(23i)));
                    let _e232 = bitcast<f32>((bitcast<u32>(((_e216 - _e221) + 127i)) << bitcast<u32>(23i)));
                    let _e236 = global_4.member[_e80].member;
                    let _e237 = (_e198 == 0u);
                    if _e237 {
                        phi_390_ = _e236[0];
                    } else {
                        phi_390_ = _e236[1];
                    }
                    let _e241 = phi_390_;
                    let _e242 = (_e198 == 2u);
                    if _e242 {
                        phi_396_ = _e236[2];
                    } else {
                        phi_396_ = _e241;
                    }
                    let _e245 = phi_396_;
                    let _e246 = bitcast<u32>(_e245);
                    let _e248 = ((_e246 & 2139095040u) != 0u);
                    let _e262 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e246 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e246 & 2147483648u))), _e245, _e248) * _e209) * select(0.00000011920929f, 1f, _e248)) * _e215);
                    let _e263 = global_4.member[_e80].member_2;
                    if _e237 {
                        phi_436_ = _e263[0];
                    } else {
                        phi_436_ = _e263[1];
                    }
                    let _e267 = phi_436_;
                    if _e242 {
                        phi_442_ = _e263[2];
                    } else {
                        phi_442_ = _e267;
                    }
                    let _e270 = phi_442_;
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
                        phi_515_ = _e236[0];
                    } else {
                        phi_515_ = _e236[1];
                    }
                    let _e308 = phi_515_;
                    let _e309 = (_e197 == 2u);
                    if _e309 {
                        phi_521_ = _e236[2];
                    } else {
                        phi_521_ = _e308;
                    }
                    let _e312 = phi_521_;
                    let _e313 = bitcast<u32>(_e312);
                    let _e315 = ((_e313 & 2139095040u) != 0u);
                    let _e329 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e313 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e313 & 2147483648u))), _e312, _e315) * _e209) * select(0.00000011920929f, 1f, _e315)) * _e215);
                    if _e304 {
                        phi_561_ = _e263[0];
                    } else {
                        phi_561_ = _e263[1];
                    }
                    let _e333 = phi_561_;
                    if _e309 {
                        phi_567_ = _e263[2];
                    } else {
                        phi_567_ = _e333;
                    }
                    let _e336 = phi_567_;
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
                        phi_640_ = _e236[0];
                    } else {
                        phi_640_ = _e236[1];
                    }
                    let _e374 = phi_640_;
                    let _e375 = (_e199 == 2u);
                    if _e375 {
                        phi_646_ = _e236[2];
                    } else {
                        phi_646_ = _e374;
                    }
                    let _e378 = phi_646_;
                    let _e379 = bitcast<u32>(_e378);
                    let _e381 = ((_e379 & 2139095040u) != 0u);
                    let _e395 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e379 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e379 & 2147483648u))), _e378, _e381) * _e209) * select(0.00000011920929f, 1f, _e381)) * _e215);
                    if _e370 {
                        phi_686_ = _e263[0];
                    } else {
                        phi_686_ = _e263[1];
                    }
                    let _e399 = phi_686_;
                    if _e375 {
                        phi_692_ = _e263[2];
                    } else {
                        phi_692_ = _e399;
                    }
                    let _e402 = phi_692_;
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
                            phi_811_ = 255i;
                        } else {
                            phi_811_ = (((_e453 + select(0i, 1i, (_e453 == 0i))) - _e460) + _e440);
                        }
                        let _e468 = phi_811_;
                        let _e478 = (_e468 <= 0i);
                        if _e478 {
                            phi_834_ = u32();
                        } else {
                            if _e457 {
                                phi_833_ = u32();
                            } else {
                                phi_833_ = select(((bitcast<u32>(_e468) << bitcast<u32>(23i)) | ((_e450 << bitcast<u32>(((_e460 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e468 >= 255i));
                            }
                            let _e482 = phi_833_;
                            phi_834_ = _e482;
                        }
                        let _e484 = phi_834_;
                        let _e496 = ((_e156 & 8388607u) | (select(0u, 1u, ((_e156 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e499 = bitcast<i32>((_e156 >> bitcast<u32>(23i)));
                        let _e503 = (_e496 == 0u);
                        let _e506 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e496)), 32u, _e503)) - 8i);
                        if (_e499 == 255i) {
                            phi_871_ = 255i;
                        } else {
                            phi_871_ = (((_e499 + select(0i, 1i, (_e499 == 0i))) - _e506) + _e440);
                        }
                        let _e514 = phi_871_;
                        let _e524 = (_e514 <= 0i);
                        if _e524 {
                            phi_894_ = u32();
                        } else {
                            if _e503 {
                                phi_893_ = u32();
                            } else {
                                phi_893_ = select(((bitcast<u32>(_e514) << bitcast<u32>(23i)) | ((_e496 << bitcast<u32>(((_e506 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e514 >= 255i));
                            }
                            let _e528 = phi_893_;
                            phi_894_ = _e528;
                        }
                        let _e530 = phi_894_;
                        phi_902_ = bitcast<f32>(((_e155 & 2147483648u) | select(_e530, 0u, select(_e503, true, _e524))));
                        phi_903_ = bitcast<f32>(((_e146 & 2147483648u) | select(_e484, 0u, select(_e457, true, _e478))));
                    } else {
                        phi_902_ = 0f;
                        phi_903_ = 1f;
                    }
                    let _e536 = phi_902_;
                    let _e538 = phi_903_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2605_ = false;
                    phi_919_ = type_49(type_40(type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e536), 0u, 0u);
                    phi_922_ = (_e538 <= _e536);
                    phi_924_ = select(0u, 2147483648u, (_e70 == 0u));
                    phi_926_ = 0u;
                    phi_928_ = ((3u * _e70) + 1u);
                    loop {
                        let _e547 = phi_2605_;
                        let _e549 = phi_919_;
                        let _e551 = phi_922_;
                        let _e553 = phi_924_;
                        let _e555 = phi_926_;
                        let _e557 = phi_928_;
                        local_3 = _e549;
                        local_4 = _e549;
                        if _e551 {
                            phi_939_ = true;
                        } else {
                            phi_939_ = (_e555 > 0u);
                        }
                        let _e560 = phi_939_;
                        if _e560 {
                            let _e561 = (_e557 > 0u);
                            if _e561 {
                                if _e551 {
                                    phi_971_ = _e551;
                                    phi_972_ = _e553;
                                    phi_973_ = _e555;
                                } else {
                                    let _e562 = (_e555 - 1u);
                                    let _e563 = (_e562 % 128u);
                                    let _e564 = (_e563 < 128u);
                                    if _e564 {
                                    } else {
                                        phi_2752_ = true;
                                        break;
                                    }
                                    let _e566 = local_1[_e563];
                                    if _e564 {
                                    } else {
                                        phi_2752_ = true;
                                        break;
                                    }
                                    let _e568 = local[_e563];
                                    phi_971_ = (_e568 <= _e549.member.member_1);
                                    phi_972_ = _e566;
                                    phi_973_ = _e562;
                                }
                                let _e573 = phi_971_;
                                let _e575 = phi_972_;
                                let _e577 = phi_973_;
                                if _e573 {
                                    if ((_e575 & 2147483648u) != 0u) {
                                        phi_988_ = _e549;
                                        phi_991_ = type_4(0u, ((_e575 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e781 = phi_988_;
                                            let _e783 = phi_991_;
                                            local_2 = _e781;
                                            local_5 = _e781;
                                            if (_e783.member < _e783.member_1) {
                                                phi_992_ = type_4((_e783.member + 1u), _e783.member_1);
                                                phi_1014_ = type_4(1u, _e783.member);
                                            } else {
                                                phi_992_ = _e783;
                                                phi_1014_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e796 = phi_992_;
                                            let _e798 = phi_1014_;
                                            let _e802 = (bitcast<i32>(_e798.member) != 0i);
                                            if _e802 {
                                                let _e808 = type_49(_e781.member, _e781.member_1, (_e781.member_2 + 1u));
                                                let _e809 = ((_e575 & 268435455u) + _e798.member_1);
                                                let _e810 = (_e809 < _e72);
                                                if _e810 {
                                                    if _e810 {
                                                    } else {
                                                        phi_2599_ = true;
                                                        break;
                                                    }
                                                    let _e814 = global_3.member[_e809].member_1;
                                                    phi_1038_ = _e814;
                                                } else {
                                                    phi_1038_ = 4294967295u;
                                                }
                                                let _e816 = phi_1038_;
                                                if (_e809 >= _e72) {
                                                    phi_1130_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e810 {
                                                    } else {
                                                        phi_2599_ = true;
                                                        break;
                                                    }
                                                    let _e818 = (_e198 % 3u);
                                                    let _e819 = (_e197 % 3u);
                                                    let _e820 = (_e199 % 3u);
                                                    if (_e818 < 9u) {
                                                    } else {
                                                        phi_2599_ = true;
                                                        break;
                                                    }
                                                    let _e826 = global_3.member[_e809].member[_e818];
                                                    if (_e819 < 9u) {
                                                    } else {
                                                        phi_2599_ = true;
                                                        break;
                                                    }
                                                    let _e832 = global_3.member[_e809].member[_e819];
                                                    if (_e820 < 9u) {
                                                    } else {
                                                        phi_2599_ = true;
                                                        break;
                                                    }
                                                    let _e838 = global_3.member[_e809].member[_e820];
                                                    let _e840 = (3u + _e818);
                                                    if (_e840 < 9u) {
                                                    } else {
                                                        phi_2599_ = true;
                                                        break;
                                                    }
                                                    let _e846 = global_3.member[_e809].member[_e840];
                                                    let _e847 = (3u + _e819);
                                                    if (_e847 < 9u) {
                                                    } else {
                                                        phi_2599_ = true;
                                                        break;
                                                    }
                                                    let _e853 = global_3.member[_e809].member[_e847];
                                                    let _e854 = (3u + _e820);
                                                    if (_e854 < 9u) {
                                                    } else {
                                                        phi_2599_ = true;
                                                        break;
                                                    }
                                                    let _e860 = global_3.member[_e809].member[_e854];
                                                    let _e862 = (6u + _e818);
                                                    if (_e862 < 9u) {
                                                    } else {
                                                        phi_2599_ = true;
                                                        break;
                                                    }
                                                    let _e868 = global_3.member[_e809].member[_e862];
                                                    let _e869 = (6u + _e819);
                                                    if (_e869 < 9u) {
                                                    } else {
                                                        phi_2599_ = true;
                                                        break;
                                                    }
                                                    let _e875 = global_3.member[_e809].member[_e869];
                                                    let _e876 = (6u + _e820);
                                                    if (_e876 < 9u) {
                                                    } else {
                                                        phi_2599_ = true;
                                                        break;
                                                    }
                                                    let _e882 = global_3.member[_e809].member[_e876];
                                                    phi_1130_ = array<array<f32, 3>, 3>(array<f32, 3>(_e826, _e832, _e838), array<f32, 3>(_e846, _e853, _e860), array<f32, 3>(_e868, _e875, _e882));
                                                }
                                                let _e886 = phi_1130_;
                                                let _e903 = (_e886[0][2] - _e395);
                                                let _e906 = (((_e886[0][0] - _e262) * _e431) - (_e903 * _e299));
                                                let _e909 = (((_e886[0][1] - _e329) * _e431) - (_e903 * _e365));
                                                let _e912 = (_e886[1][2] - _e395);
                                                let _e915 = (((_e886[1][0] - _e262) * _e431) - (_e912 * _e299));
                                                let _e918 = (((_e886[1][1] - _e329) * _e431) - (_e912 * _e365));
                                                let _e921 = (_e886[2][2] - _e395);
                                                let _e924 = (((_e886[2][0] - _e262) * _e431) - (_e921 * _e299));
                                                let _e927 = (((_e886[2][1] - _e329) * _e431) - (_e921 * _e365));
                                                let _e928 = (_e924 * _e918);
                                                let _e929 = (_e927 * _e915);
                                                let _e930 = (_e906 * _e927);
                                                let _e931 = (_e909 * _e924);
                                                let _e932 = (_e915 * _e909);
                                                let _e933 = (_e918 * _e906);
                                                let _e938 = (((_e928 >= _e929) && (_e930 >= _e931)) && (_e932 >= _e933));
                                                let _e944 = (_e938 || (((_e928 <= _e929) && (_e930 <= _e931)) && (_e932 <= _e933)));
                                                if _e944 {
                                                    let _e946 = select(-1f, 1f, _e938);
                                                    let _e948 = ((_e928 - _e929) * _e946);
                                                    let _e950 = select(0f, _e948, (_e948 > 0f));
                                                    let _e952 = ((_e930 - _e931) * _e946);
                                                    let _e954 = select(0f, _e952, (_e952 > 0f));
                                                    let _e956 = ((_e932 - _e933) * _e946);
                                                    let _e958 = select(0f, _e956, (_e956 > 0f));
                                                    let _e960 = ((_e950 + _e954) + _e958);
                                                    let _e962 = select(_e886[1][0], _e886[0][0], (_e886[0][0] < _e886[1][0]));
                                                    let _e966 = select(_e886[1][0], _e886[0][0], (_e886[0][0] > _e886[1][0]));
                                                    let _e970 = select(_e886[1][1], _e886[0][1], (_e886[0][1] < _e886[1][1]));
                                                    let _e974 = select(_e886[1][1], _e886[0][1], (_e886[0][1] > _e886[1][1]));
                                                    let _e978 = select(_e886[1][2], _e886[0][2], (_e886[0][2] < _e886[1][2]));
                                                    let _e982 = select(_e886[1][2], _e886[0][2], (_e886[0][2] > _e886[1][2]));
                                                    let _e987 = ((select(_e886[2][0], _e962, (_e962 < _e886[2][0])) - _e300) * _e303);
                                                    let _e988 = ((select(_e886[2][0], _e966, (_e966 > _e886[2][0])) - _e301) * _e303);
                                                    let _e991 = ((select(_e886[2][1], _e970, (_e970 < _e886[2][1])) - _e366) * _e369);
                                                    let _e992 = ((select(_e886[2][1], _e974, (_e974 > _e886[2][1])) - _e367) * _e369);
                                                    let _e995 = ((select(_e886[2][2], _e978, (_e978 < _e886[2][2])) - _e432) * _e435);
                                                    let _e996 = ((select(_e886[2][2], _e982, (_e982 > _e886[2][2])) - _e433) * _e435);
                                                    let _e998 = select(_e996, _e995, (_e995 < _e996));
                                                    let _e1000 = select(_e996, _e995, (_e995 > _e996));
                                                    let _e1002 = select(_e988, _e987, (_e987 < _e988));
                                                    let _e1004 = select(_e992, _e991, (_e991 < _e992));
                                                    let _e1006 = select(_e1004, _e1002, (_e1002 > _e1004));
                                                    let _e1008 = select(_e998, _e1006, (_e1006 > _e998));
                                                    let _e1010 = select(_e988, _e987, (_e987 > _e988));
                                                    let _e1012 = select(_e992, _e991, (_e991 > _e992));
                                                    let _e1014 = select(_e1012, _e1010, (_e1010 < _e1012));
                                                    let _e1016 = select(_e1000, _e1014, (_e1014 < _e1000));
                                                    let _e1017 = -(_e998);
                                                    let _e1023 = select(_e538, _e1008, (_e1008 > _e538));
                                                    let _e1027 = select(_e915, _e906, (_e906 < _e915));
                                                    let _e1032 = select(_e915, _e906, (_e906 > _e915));
                                                    let _e1039 = select(_e918, _e909, (_e909 < _e918));
                                                    let _e1044 = select(_e918, _e909, (_e909 > _e918));
                                                    let _e1053 = (((((_e944 && (_e960 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e924, _e1027, (_e1027 < _e924)) <= 0f) && (select(_e924, _e1032, (_e1032 > _e924)) >= 0f))) && ((select(_e927, _e1039, (_e1039 < _e927)) <= 0f) && (select(_e927, _e1044, (_e1044 > _e927)) >= 0f))) && (_e1023 <= (_e1016 + (select(_e1017, _e1000, (_e1000 > _e1017)) * 0.0000019073523f)))) && (_e1023 <= _e781.member.member_1));
                                                    if _e1053 {
                                                        let _e1058 = (_e886[1][0] - _e886[0][0]);
                                                        let _e1059 = (_e886[1][1] - _e886[0][1]);
                                                        let _e1060 = (_e886[1][2] - _e886[0][2]);
                                                        let _e1061 = vec3<f32>(_e1058, _e1059, _e1060);
                                                        let _e1062 = (_e886[2][0] - _e886[1][0]);
                                                        let _e1063 = (_e886[2][1] - _e886[1][1]);
                                                        let _e1064 = (_e886[2][2] - _e886[1][2]);
                                                        let _e1065 = vec3<f32>(_e1062, _e1063, _e1064);
                                                        let _e1066 = (_e886[0][0] - _e886[2][0]);
                                                        let _e1067 = (_e886[0][1] - _e886[2][1]);
                                                        let _e1068 = (_e886[0][2] - _e886[2][2]);
                                                        let _e1069 = vec3<f32>(_e1066, _e1067, _e1068);
                                                        let _e1072 = bitcast<f32>((bitcast<u32>(_e1058) & 2147483647u));
                                                        let _e1075 = bitcast<f32>((bitcast<u32>(_e1059) & 2147483647u));
                                                        let _e1077 = select(_e1075, _e1072, (_e1072 > _e1075));
                                                        let _e1080 = bitcast<f32>((bitcast<u32>(_e1060) & 2147483647u));
                                                        let _e1082 = select(_e1080, _e1077, (_e1077 > _e1080));
                                                        let _e1085 = bitcast<f32>((bitcast<u32>(_e1062) & 2147483647u));
                                                        let _e1088 = bitcast<f32>((bitcast<u32>(_e1063) & 2147483647u));
                                                        let _e1090 = select(_e1088, _e1085, (_e1085 > _e1088));
                                                        let _e1093 = bitcast<f32>((bitcast<u32>(_e1064) & 2147483647u));
                                                        let _e1095 = select(_e1093, _e1090, (_e1090 > _e1093));
                                                        let _e1098 = bitcast<f32>((bitcast<u32>(_e1066) & 2147483647u));
                                                        let _e1101 = bitcast<f32>((bitcast<u32>(_e1067) & 2147483647u));
                                                        let _e1103 = select(_e1101, _e1098, (_e1098 > _e1101));
                                                        let _e1106 = bitcast<f32>((bitcast<u32>(_e1068) & 2147483647u));
                                                        let _e1108 = select(_e1106, _e1103, (_e1103 > _e1106));
                                                        let _e1110 = select(_e1095, _e1082, (_e1082 > _e1095));
                                                        let _e1112 = select(_e1108, _e1110, (_e1110 > _e1108));
                                                        if (_e1082 == _e1112) {
                                                            phi_1660_ = _e918;
                                                            phi_1661_ = _e915;
                                                            phi_1662_ = _e909;
                                                            phi_1663_ = _e906;
                                                            phi_1664_ = vec3<f32>(_e886[0][0], _e886[0][1], _e886[0][2]);
                                                            phi_1665_ = _e1069;
                                                            phi_1666_ = _e1065;
                                                            phi_1667_ = _e1061;
                                                        } else {
                                                            let _e1114 = (_e1095 == _e1112);
                                                            let _e1119 = vec3(_e1114);
                                                            phi_1660_ = select(_e909, _e927, _e1114);
                                                            phi_1661_ = select(_e906, _e924, _e1114);
                                                            phi_1662_ = select(_e927, _e918, _e1114);
                                                            phi_1663_ = select(_e924, _e915, _e1114);
                                                            phi_1664_ = select(vec3<f32>(_e886[2][0], _e886[2][1], _e886[2][2]), vec3<f32>(_e886[1][0], _e886[1][1], _e886[1][2]), _e1119);
                                                            phi_1665_ = select(_e1065, _e1061, _e1119);
                                                            phi_1666_ = select(_e1061, _e1069, _e1119);
                                                            phi_1667_ = select(_e1069, _e1065, _e1119);
                                                        }
                                                        let _e1125 = phi_1660_;
                                                        let _e1127 = phi_1661_;
                                                        let _e1129 = phi_1662_;
                                                        let _e1131 = phi_1663_;
                                                        let _e1133 = phi_1664_;
                                                        let _e1135 = phi_1665_;
                                                        let _e1137 = phi_1666_;
                                                        let _e1139 = phi_1667_;
                                                        let _e1146 = ((_e1137.y * _e1135.z) - (_e1135.y * _e1137.z));
                                                        let _e1151 = ((_e1137.z * _e1135.x) - (_e1135.z * _e1137.x));
                                                        let _e1154 = ((_e1137.x * _e1135.y) - (_e1135.x * _e1137.y));
                                                        let _e1157 = ((_e950 >= _e954) && (_e950 >= _e958));
                                                        let _e1158 = (_e954 >= _e958);
                                                        let _e1172 = (((_e1146 * (select(select(_e886[2][0], _e886[1][0], _e1158), _e886[0][0], _e1157) - _e262)) + (_e1151 * (select(select(_e886[2][1], _e886[1][1], _e1158), _e886[0][1], _e1157) - _e329))) + (_e1154 * (select(select(_e886[2][2], _e886[1][2], _e1158), _e886[0][2], _e1157) - _e395)));
                                                        let _e1177 = (((_e1146 * _e299) + (_e1151 * _e365)) + (_e1154 * _e431));
                                                        let _e1178 = (_e1127 - _e1131);
                                                        let _e1179 = (_e1125 - _e1129);
                                                        let _e1182 = ((_e1178 * _e1178) + (_e1179 * _e1179));
                                                        let _e1189 = (-(((_e1131 * _e1178) + (_e1129 * _e1179))) / select(0.000000000000000000000000000000000000011754944f, _e1182, (_e1182 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1191 = select(1f, _e1189, (_e1189 < 1f));
                                                        let _e1193 = select(0f, _e1191, (_e1191 > 0f));
                                                        let _e1202 = ((_e1133.x + (_e1139.x * _e1193)) - _e262);
                                                        let _e1205 = ((_e1133.y + (_e1139.y * _e1193)) - _e329);
                                                        let _e1208 = ((_e1133.z + (_e1139.z * _e1193)) - _e395);
                                                        let _e1211 = bitcast<f32>((bitcast<u32>(_e1202) & 2147483647u));
                                                        let _e1214 = bitcast<f32>((bitcast<u32>(_e1205) & 2147483647u));
                                                        let _e1216 = select(_e1214, _e1211, (_e1211 > _e1214));
                                                        let _e1219 = bitcast<f32>((bitcast<u32>(_e1208) & 2147483647u));
                                                        let _e1221 = select(_e1219, _e1216, (_e1216 > _e1219));
                                                        let _e1227 = bitcast<f32>((bitcast<u32>(_e1146) & 2147483647u));
                                                        let _e1230 = bitcast<f32>((bitcast<u32>(_e1151) & 2147483647u));
                                                        let _e1232 = select(_e1230, _e1227, (_e1227 > _e1230));
                                                        let _e1235 = bitcast<f32>((bitcast<u32>(_e1154) & 2147483647u));
                                                        let _e1254 = bitcast<f32>((bitcast<u32>(_e1137.x) & 2147483647u));
                                                        let _e1257 = bitcast<f32>((bitcast<u32>(_e1137.y) & 2147483647u));
                                                        let _e1259 = select(_e1257, _e1254, (_e1254 > _e1257));
                                                        let _e1262 = bitcast<f32>((bitcast<u32>(_e1137.z) & 2147483647u));
                                                        let _e1268 = bitcast<f32>((bitcast<u32>(_e1135.x) & 2147483647u));
                                                        let _e1271 = bitcast<f32>((bitcast<u32>(_e1135.y) & 2147483647u));
                                                        let _e1273 = select(_e1271, _e1268, (_e1268 > _e1271));
                                                        let _e1276 = bitcast<f32>((bitcast<u32>(_e1135.z) & 2147483647u));
                                                        let _e1282 = ((bitcast<f32>((bitcast<u32>(((((_e1146 * _e1202) + (_e1151 * _e1205)) + (_e1154 * _e1208)) - _e1172)) & 2147483647u)) <= ((0.0000009536743f * select(_e1112, _e1221, (_e1221 > _e1112))) * select(_e1235, _e1232, (_e1232 > _e1235)))) && !((bitcast<f32>((bitcast<u32>(_e1177) & 2147483647u)) <= ((0.0000038146973f * select(_e1262, _e1259, (_e1259 > _e1262))) * select(_e1276, _e1273, (_e1273 > _e1276))))));
                                                        let _e1283 = (_e1172 / _e1177);
                                                        if (_e1053 && !(_e1282)) {
                                                            let _e1286 = (_e1208 / _e431);
                                                            let _e1294 = (((_e1146 * (_e1202 - (_e299 * _e1286))) + (_e1151 * (_e1205 - (_e365 * _e1286)))) / _e1177);
                                                            phi_1858_ = select(select(_e1286, (_e1286 + _e1294), (bitcast<f32>((bitcast<u32>(_e1294) & 2147483647u)) <= _e1112)), _e1283, _e1282);
                                                        } else {
                                                            phi_1858_ = _e1283;
                                                        }
                                                        let _e1303 = phi_1858_;
                                                        let _e1305 = select(_e1016, _e1303, (_e1303 < _e1016));
                                                        let _e1307 = select(_e1008, _e1305, (_e1305 > _e1008));
                                                        let _e1308 = (1f / _e960);
                                                        phi_1878_ = type_44(_e1307, (_e954 * _e1308), (_e958 * _e1308), ((_e1053 && (_e1307 >= _e538)) && (_e1307 <= _e781.member.member_1)));
                                                        phi_1879_ = type_44();
                                                    } else {
                                                        phi_1878_ = type_44();
                                                        phi_1879_ = type_44(0f, 0f, 0f, _e1053);
                                                    }
                                                    let _e1317 = phi_1878_;
                                                    let _e1319 = phi_1879_;
                                                    phi_1882_ = _e1317;
                                                    phi_1883_ = _e1319;
                                                    phi_1884_ = select(true, false, _e1053);
                                                } else {
                                                    phi_1882_ = type_44();
                                                    phi_1883_ = type_44(0f, 0f, 0f, _e944);
                                                    phi_1884_ = true;
                                                }
                                                let _e1322 = phi_1882_;
                                                let _e1324 = phi_1883_;
                                                let _e1326 = phi_1884_;
                                                if _e1326 {
                                                    phi_1888_ = _e1324;
                                                } else {
                                                    phi_1888_ = _e1322;
                                                }
                                                let _e1328 = phi_1888_;
                                                if _e1328.member_3 {
                                                    phi_1897_ = type_27(_e1328.member, _e1328.member_1, _e1328.member_2, _e816);
                                                } else {
                                                    phi_1897_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1335 = phi_1897_;
                                                if (_e1335.member_3 != 4294967295u) {
                                                    if (_e816 != 4294967295u) {
                                                        if (_e1335.member < _e781.member.member.member) {
                                                            phi_1923_ = true;
                                                        } else {
                                                            if (_e1335.member == _e781.member.member.member) {
                                                                phi_1922_ = (_e1335.member_3 < _e781.member.member.member_3);
                                                            } else {
                                                                phi_1922_ = false;
                                                            }
                                                            let _e1350 = phi_1922_;
                                                            phi_1923_ = _e1350;
                                                        }
                                                        let _e1352 = phi_1923_;
                                                        if _e1352 {
                                                            phi_1930_ = type_49(type_40(_e1335, _e1335.member), _e808.member_1, _e808.member_2);
                                                        } else {
                                                            phi_1930_ = _e808;
                                                        }
                                                        let _e1359 = phi_1930_;
                                                        phi_1931_ = _e1359;
                                                    } else {
                                                        phi_1931_ = _e808;
                                                    }
                                                    let _e1361 = phi_1931_;
                                                    phi_1932_ = _e1361;
                                                } else {
                                                    phi_1932_ = _e808;
                                                }
                                                let _e1363 = phi_1932_;
                                                phi_989_ = _e1363;
                                            } else {
                                                phi_989_ = type_49();
                                            }
                                            let _e1365 = phi_989_;
                                            continue;
                                            continuing {
                                                phi_988_ = _e1365;
                                                phi_991_ = _e796;
                                                phi_2599_ = _e547;
                                                break if !(_e802);
                                            }
                                        }
                                        let _e1368 = phi_2599_;
                                        phi_2752_ = _e1368;
                                        if _e1368 {
                                            break;
                                        }
                                        let _e1370 = local_2;
                                        phi_2756_ = _e1368;
                                        let _e1521 = local_5;
                                        phi_2412_ = _e1521;
                                        phi_2413_ = false;
                                        phi_2414_ = _e575;
                                        phi_2415_ = select(_e577, 0u, (_e538 > _e1370.member.member_1));
                                    } else {
                                        if (_e575 >= _e70) {
                                            phi_1997_ = type_45(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e575 < _e70) {
                                            } else {
                                                phi_2752_ = true;
                                                break;
                                            }
                                            let _e587 = (_e198 % 3u);
                                            if (_e587 < 3u) {
                                            } else {
                                                phi_2752_ = true;
                                                break;
                                            }
                                            let _e593 = global_2.member[_e575].member[_e587];
                                            let _e599 = (_e197 % 3u);
                                            if (_e599 < 3u) {
                                            } else {
                                                phi_2752_ = true;
                                                break;
                                            }
                                            let _e605 = global_2.member[_e575].member[_e599];
                                            let _e611 = (_e199 % 3u);
                                            if (_e611 < 3u) {
                                            } else {
                                                phi_2752_ = true;
                                                break;
                                            }
                                            let _e617 = global_2.member[_e575].member[_e611];
                                            let _e627 = global_2.member[_e575].member_1;
                                            let _e631 = global_2.member[_e575].member_2;
                                            phi_1997_ = type_45(array<vec4<f32>, 3>(vec4<f32>(_e593[0], _e593[1], _e593[2], _e593[3]), vec4<f32>(_e605[0], _e605[1], _e605[2], _e605[3]), vec4<f32>(_e617[0], _e617[1], _e617[2], _e617[3])), _e627, _e631);
                                        }
                                        let _e634 = phi_1997_;
                                        let _e653 = ((_e634.member[0].x - _e300) * _e303);
                                        let _e654 = ((_e634.member[0].y - _e300) * _e303);
                                        let _e655 = ((_e634.member[0].z - _e301) * _e303);
                                        let _e656 = ((_e634.member[0].w - _e301) * _e303);
                                        let _e666 = ((_e634.member[1].x - _e366) * _e369);
                                        let _e667 = ((_e634.member[1].y - _e366) * _e369);
                                        let _e668 = ((_e634.member[1].z - _e367) * _e369);
                                        let _e669 = ((_e634.member[1].w - _e367) * _e369);
                                        let _e679 = ((_e634.member[2].x - _e432) * _e435);
                                        let _e680 = ((_e634.member[2].y - _e432) * _e435);
                                        let _e681 = ((_e634.member[2].z - _e433) * _e435);
                                        let _e682 = ((_e634.member[2].w - _e433) * _e435);
                                        let _e684 = select(_e681, _e679, (_e679 < _e681));
                                        let _e686 = select(_e682, _e680, (_e680 < _e682));
                                        let _e688 = select(_e681, _e679, (_e679 > _e681));
                                        let _e690 = select(_e682, _e680, (_e680 > _e682));
                                        let _e692 = select(_e655, _e653, (_e653 < _e655));
                                        let _e694 = select(_e656, _e654, (_e654 < _e656));
                                        let _e696 = select(_e668, _e666, (_e666 < _e668));
                                        let _e698 = select(_e669, _e667, (_e667 < _e669));
                                        let _e700 = select(_e696, _e692, (_e692 > _e696));
                                        let _e702 = select(_e698, _e694, (_e694 > _e698));
                                        let _e704 = select(_e684, _e700, (_e700 > _e684));
                                        let _e706 = select(_e686, _e702, (_e702 > _e686));
                                        let _e708 = select(_e655, _e653, (_e653 > _e655));
                                        let _e710 = select(_e656, _e654, (_e654 > _e656));
                                        let _e712 = select(_e668, _e666, (_e666 > _e668));
                                        let _e714 = select(_e669, _e667, (_e667 > _e669));
                                        let _e716 = select(_e712, _e708, (_e708 < _e712));
                                        let _e718 = select(_e714, _e710, (_e710 < _e714));
                                        let _e723 = -(_e684);
                                        let _e724 = -(_e686);
                                        let _e731 = (select(_e688, _e716, (_e716 < _e688)) + (select(_e723, _e688, (_e688 > _e723)) * 0.0000019073523f));
                                        let _e732 = (select(_e690, _e718, (_e718 < _e690)) + (select(_e724, _e690, (_e690 > _e724)) * 0.0000019073523f));
                                        let _e734 = select(_e538, _e704, (_e704 > _e538));
                                        let _e736 = select(_e538, _e706, (_e706 > _e538));
                                        let _e741 = (_e734 <= select(_e549.member.member_1, _e731, (_e731 < _e549.member.member_1)));
                                        let _e742 = (_e736 <= select(_e549.member.member_1, _e732, (_e732 < _e549.member.member_1)));
                                        let _e743 = (_e734 <= _e736);
                                        if _e741 {
                                            if _e742 {
                                                if _e743 {
                                                    phi_2362_ = _e634.member_2;
                                                } else {
                                                    phi_2362_ = _e634.member_1;
                                                }
                                                let _e747 = phi_2362_;
                                                let _e749 = (_e577 % 128u);
                                                let _e750 = (_e749 < 128u);
                                                if _e750 {
                                                } else {
                                                    phi_2752_ = true;
                                                    break;
                                                }
                                                local_1[_e749] = _e747;
                                                if _e750 {
                                                } else {
                                                    phi_2752_ = true;
                                                    break;
                                                }
                                                local[_e749] = select(_e734, _e736, _e743);
                                                if _e743 {
                                                    phi_2389_ = _e634.member_1;
                                                } else {
                                                    phi_2389_ = _e634.member_2;
                                                }
                                                let _e757 = phi_2389_;
                                                phi_2390_ = _e757;
                                                phi_2391_ = (_e577 + 1u);
                                            } else {
                                                phi_2390_ = u32();
                                                phi_2391_ = u32();
                                            }
                                            let _e759 = phi_2390_;
                                            let _e761 = phi_2391_;
                                            phi_2393_ = _e759;
                                            phi_2394_ = _e761;
                                            phi_2395_ = select(true, false, _e742);
                                        } else {
                                            phi_2393_ = u32();
                                            phi_2394_ = u32();
                                            phi_2395_ = true;
                                        }
                                        let _e764 = phi_2393_;
                                        let _e766 = phi_2394_;
                                        let _e768 = phi_2395_;
                                        if _e768 {
                                            if _e741 {
                                                phi_2404_ = _e634.member_1;
                                            } else {
                                                phi_2404_ = _e634.member_2;
                                            }
                                            let _e772 = phi_2404_;
                                            phi_2409_ = select(_e742, true, _e741);
                                            phi_2410_ = _e772;
                                        } else {
                                            phi_2409_ = _e573;
                                            phi_2410_ = _e764;
                                        }
                                        let _e775 = phi_2409_;
                                        let _e777 = phi_2410_;
                                        phi_2756_ = _e547;
                                        phi_2412_ = type_49(_e549.member, (_e549.member_1 + 1u), _e549.member_2);
                                        phi_2413_ = _e775;
                                        phi_2414_ = _e777;
                                        phi_2415_ = select(_e766, _e577, _e768);
                                    }
                                    let _e1376 = phi_2756_;
                                    let _e1378 = phi_2412_;
                                    let _e1380 = phi_2413_;
                                    let _e1382 = phi_2414_;
                                    let _e1384 = phi_2415_;
                                    phi_2755_ = _e1376;
                                    phi_2416_ = _e1378;
                                    phi_2417_ = _e1380;
                                    phi_2418_ = _e1382;
                                    phi_2419_ = _e1384;
                                    phi_2420_ = (_e557 - 1u);
                                } else {
                                    phi_2755_ = _e547;
                                    phi_2416_ = _e549;
                                    phi_2417_ = _e573;
                                    phi_2418_ = _e575;
                                    phi_2419_ = _e577;
                                    phi_2420_ = _e557;
                                }
                                let _e1386 = phi_2755_;
                                let _e1388 = phi_2416_;
                                let _e1390 = phi_2417_;
                                let _e1392 = phi_2418_;
                                let _e1394 = phi_2419_;
                                let _e1396 = phi_2420_;
                                phi_2754_ = _e1386;
                                phi_2421_ = _e1388;
                                phi_2422_ = _e1390;
                                phi_2423_ = _e1392;
                                phi_2424_ = _e1394;
                                phi_2425_ = _e1396;
                            } else {
                                phi_2754_ = _e547;
                                phi_2421_ = type_49();
                                phi_2422_ = bool();
                                phi_2423_ = u32();
                                phi_2424_ = u32();
                                phi_2425_ = u32();
                            }
                            let _e1398 = phi_2754_;
                            let _e1400 = phi_2421_;
                            let _e1402 = phi_2422_;
                            let _e1404 = phi_2423_;
                            let _e1406 = phi_2424_;
                            let _e1408 = phi_2425_;
                            phi_2753_ = _e1398;
                            phi_920_ = _e1400;
                            phi_923_ = _e1402;
                            phi_925_ = _e1404;
                            phi_927_ = _e1406;
                            phi_929_ = _e1408;
                            phi_2426_ = _e561;
                        } else {
                            phi_2753_ = _e547;
                            phi_920_ = type_49();
                            phi_923_ = bool();
                            phi_925_ = u32();
                            phi_927_ = u32();
                            phi_929_ = u32();
                            phi_2426_ = false;
                        }
                        let _e1410 = phi_2753_;
                        let _e1412 = phi_920_;
                        let _e1414 = phi_923_;
                        let _e1416 = phi_925_;
                        let _e1418 = phi_927_;
                        let _e1420 = phi_929_;
                        let _e1422 = phi_2426_;
                        continue;
                        continuing {
                            phi_2605_ = _e1410;
                            phi_919_ = _e1412;
                            phi_922_ = _e1414;
                            phi_924_ = _e1416;
                            phi_926_ = _e1418;
                            phi_928_ = _e1420;
                            phi_2752_ = _e1410;
                            break if !(_e1422);
                        }
                    }
                    let _e1425 = phi_2752_;
                    if _e1425 {
                        break;
                    }
                    let _e1427 = local_3;
                    let _e1430 = local_4;
                    if _e86 {
                    } else {
                        break;
                    }
                    global_5.member[_e80][0u] = _e1427.member_1;
                    global_5.member[_e80][1u] = _e1430.member_2;
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
