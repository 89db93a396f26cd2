struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_13 {
    member: array<array<u32, 4>>,
}

struct type_16 {
    member: vec4<u32>,
}

struct type_22 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_24 {
    member: array<type_22>,
}

struct type_30 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_31 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_32 {
    member: type_31,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_34 {
    member: array<type_32>,
}

struct type_39 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_40 {
    member: type_31,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_42 {
    member: array<type_40>,
}

struct type_45 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_51 {
    member: f32,
    member_1: bool,
}

struct type_53 {
    member: array<vec4<u32>, 2>,
}

struct type_56 {
    member: array<i32>,
}

struct type_63 {
    member: type_39,
    member_1: u32,
}

struct type_64 {
    member: array<vec4<f32>, 3>,
    member_1: type_63,
    member_2: type_63,
}

struct type_69 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_34;
@group(0) @binding(1) 
var<uniform> global_3: type_53;
@group(0) @binding(2) 
var<uniform> global_4: type_53;
@group(0) @binding(3) 
var<storage> global_5: type_13;
@group(0) @binding(4) 
var<storage> global_6: type_24;
@group(0) @binding(5) 
var<storage> global_7: type_4;
@group(0) @binding(6) 
var<storage> global_8: type_56;
@group(0) @binding(9) 
var<storage, read_write> global_9: type_69;
@group(0) @binding(7) 
var<storage> global_10: type_42;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<f32, 128>;
    var local_7: array<f32, 128>;
    var local_8: array<u32, 128>;
    var local_9: array<f32, 128>;
    var phi_324_: u32;
    var phi_368_: i32;
    var phi_392_: type_45;
    var phi_542_: i32;
    var phi_543_: i32;
    var phi_553_: bool;
    var phi_563_: u32;
    var phi_564_: u32;
    var phi_566_: bool;
    var phi_571_: u32;
    var phi_604_: i32;
    var phi_622_: f32;
    var phi_628_: f32;
    var phi_639_: f32;
    var phi_645_: f32;
    var phi_668_: f32;
    var phi_679_: f32;
    var phi_688_: f32;
    var phi_694_: f32;
    var phi_705_: f32;
    var phi_711_: f32;
    var phi_734_: f32;
    var phi_745_: f32;
    var phi_754_: f32;
    var phi_760_: f32;
    var phi_771_: f32;
    var phi_777_: f32;
    var phi_800_: f32;
    var phi_811_: f32;
    var phi_911_: f32;
    var phi_912_: f32;
    var phi_3786_: bool;
    var phi_1001_: type_51;
    var phi_1004_: type_63;
    var phi_1006_: u32;
    var phi_1008_: bool;
    var phi_1010_: u32;
    var phi_1021_: bool;
    var phi_1107_: type_63;
    var phi_1108_: bool;
    var phi_1109_: u32;
    var phi_3039_: u32;
    var phi_3040_: u32;
    var phi_3050_: u32;
    var phi_3052_: u32;
    var phi_3053_: bool;
    var phi_3073_: u32;
    var phi_3074_: u32;
    var phi_3078_: type_64;
    var phi_3422_: type_63;
    var phi_3499_: type_63;
    var phi_3500_: type_63;
    var phi_3501_: u32;
    var phi_3503_: type_63;
    var phi_3504_: u32;
    var phi_3505_: bool;
    var phi_3514_: type_63;
    var phi_3519_: type_63;
    var phi_3520_: bool;
    var phi_1127_: type_51;
    var phi_1130_: type_8;
    var phi_1131_: type_8;
    var phi_1153_: type_8;
    var phi_1174_: u32;
    var phi_1263_: array<array<f32, 3>, 3>;
    var phi_1734_: vec3<f32>;
    var phi_1735_: vec3<f32>;
    var phi_1766_: bool;
    var phi_1775_: vec3<f32>;
    var phi_1815_: type_30;
    var phi_1817_: type_30;
    var phi_1818_: bool;
    var phi_1822_: type_30;
    var phi_1823_: type_30;
    var phi_1824_: type_30;
    var phi_1825_: bool;
    var phi_1829_: type_30;
    var phi_1830_: bool;
    var phi_1834_: type_30;
    var phi_1835_: bool;
    var phi_1839_: type_30;
    var phi_1862_: u32;
    var phi_1876_: i32;
    var phi_1896_: vec3<f32>;
    var phi_1897_: vec3<f32>;
    var phi_1913_: vec3<f32>;
    var phi_1914_: vec3<f32>;
    var phi_1930_: vec3<f32>;
    var phi_1931_: vec3<f32>;
    var phi_1967_: vec3<f32>;
    var phi_2149_: f32;
    var phi_2167_: bool;
    var phi_2168_: bool;
    var phi_2173_: type_51;
    var phi_2174_: type_51;
    var phi_1128_: type_51;
    var phi_3780_: bool;
    var local_10: type_51;
    var phi_3922_: bool;
    var phi_3522_: type_51;
    var phi_3523_: type_63;
    var phi_3524_: bool;
    var phi_3525_: u32;
    var phi_3921_: bool;
    var phi_3526_: type_51;
    var phi_3527_: type_63;
    var phi_3528_: u32;
    var phi_3529_: bool;
    var phi_3530_: u32;
    var phi_3920_: bool;
    var phi_3531_: type_51;
    var phi_3532_: type_63;
    var phi_3533_: u32;
    var phi_3534_: bool;
    var phi_3535_: u32;
    var phi_3919_: bool;
    var phi_1002_: type_51;
    var phi_1005_: type_63;
    var phi_1007_: u32;
    var phi_1009_: bool;
    var phi_1011_: u32;
    var phi_3536_: bool;
    var phi_3918_: bool;
    var local_11: type_51;
    var local_12: type_51;

    switch bitcast<i32>(0u) {
        default: {
            let _e93 = global;
            let _e95 = arrayLength((&global_5.member));
            let _e97 = arrayLength((&global_6.member));
            let _e109 = arrayLength((&global_9.member));
            let _e113 = global_4.member[0u][0u];
            let _e117 = global_4.member[0u][1u];
            let _e121 = global_4.member[0u][2u];
            let _e125 = global_4.member[0u][3u];
            let _e129 = global_4.member[1u][0u];
            let _e133 = global_4.member[1u][1u];
            let _e137 = global_4.member[1u][2u];
            let _e141 = (_e93.x + (_e93.y * 2097152u));
            let _e153 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e125) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e113), bitcast<i32>(_e117), bitcast<i32>(_e121));
            local = array<i32, 3>(bitcast<i32>(_e129), bitcast<i32>(_e133), bitcast<i32>(_e137));
            let _e156 = (_e141 < arrayLength((&global_10.member)));
            if _e156 {
                if _e156 {
                } else {
                    break;
                }
                let _e160 = global_10.member[_e141].member_2;
                phi_324_ = _e160;
            } else {
                phi_324_ = 4294967295u;
            }
            let _e162 = phi_324_;
            let _e165 = global_1.member[0u];
            let _e169 = global_3.member[0u][0u];
            let _e173 = global_3.member[0u][1u];
            let _e177 = global_3.member[0u][2u];
            let _e181 = global_3.member[0u][3u];
            let _e185 = global_3.member[1u][0u];
            let _e189 = global_3.member[1u][1u];
            let _e193 = global_3.member[1u][2u];
            let _e197 = global_3.member[1u][3u];
            let _e198 = bitcast<f32>(_e169);
            let _e199 = bitcast<f32>(_e173);
            let _e200 = bitcast<f32>(_e177);
            let _e202 = bitcast<f32>(_e185);
            let _e203 = array<u32, 3>(_e189, _e193, _e197);
            let _e205 = bitcast<i32>(_e165);
            if (_e205 < -126i) {
                phi_368_ = -126i;
            } else {
                phi_368_ = select(_e205, 127i, (_e205 > 127i));
            }
            let _e210 = phi_368_;
            let _e215 = bitcast<f32>((bitcast<u32>((_e210 + 127i)) << bitcast<u32>(23i)));
            let _e221 = bitcast<f32>((bitcast<u32>(((_e205 - _e210) + 127i)) << bitcast<u32>(23i)));
            if (_e181 == 0u) {
                phi_392_ = type_45(array<f32, 3>(_e198, _e199, _e200), _e181, _e202, _e203);
            } else {
                phi_392_ = type_45(array<f32, 3>(((_e198 * _e215) * _e221), ((_e199 * _e215) * _e221), ((_e200 * _e215) * _e221)), _e181, ((_e202 * _e215) * _e221), _e203);
            }
            let _e234 = phi_392_;
            if _e156 {
                let _e235 = (_e141 < arrayLength((&global_2.member)));
                if _e235 {
                    if _e156 {
                    } else {
                        break;
                    }
                    let _e240 = global_10.member[_e141].member.member_1;
                    let _e245 = global_10.member[_e141].member.member_3;
                    if (_e240 <= _e245) {
                        let _e247 = (1u < _e109);
                        if _e247 {
                            if (0u < _e109) {
                            } else {
                                break;
                            }
                            let _e251 = atomicAdd((&global_9.member[0u]), 1u);
                            if ((_e251 + 1u) < _e251) {
                                if _e247 {
                                } else {
                                    break;
                                }
                                let _e256 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                        if _e156 {
                        } else {
                            break;
                        }
                        let _e266 = global_10.member[_e141].member.member_2[0u];
                        let _e268 = (bitcast<u32>(_e266) & 2147483647u);
                        let _e274 = global_10.member[_e141].member.member_2[1u];
                        let _e276 = (bitcast<u32>(_e274) & 2147483647u);
                        let _e282 = global_10.member[_e141].member.member_2[2u];
                        let _e284 = (bitcast<u32>(_e282) & 2147483647u);
                        let _e290 = global_10.member[_e141].member.member[0u];
                        let _e292 = (bitcast<u32>(_e290) & 2147483647u);
                        let _e298 = global_10.member[_e141].member.member[1u];
                        let _e300 = (bitcast<u32>(_e298) & 2147483647u);
                        let _e306 = global_10.member[_e141].member.member[2u];
                        let _e308 = (bitcast<u32>(_e306) & 2147483647u);
                        let _e310 = select(_e276, _e268, (_e276 < _e268));
                        let _e312 = select(_e284, _e310, (_e284 < _e310));
                        let _e314 = select(_e292, _e312, (_e292 < _e312));
                        let _e316 = select(_e300, _e314, (_e300 < _e314));
                        let _e318 = select(_e308, _e316, (_e308 < _e316));
                        let _e320 = (bitcast<u32>(_e240) & 2147483647u);
                        let _e329 = (((select(_e320, _e318, (_e320 < _e318)) < 2139095040u) && ((bitcast<u32>(_e245) & 2147483647u) <= 2139095040u)) && (_e312 > 0u));
                        if _e329 {
                            let _e332 = (bitcast<u32>(bitcast<f32>(_e312)) & 2147483647u);
                            if (_e332 >= 8388608u) {
                                phi_542_ = (bitcast<i32>((_e332 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_542_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e332)), 32u, (_e332 == 0u))));
                            }
                            let _e346 = phi_542_;
                            phi_543_ = _e346;
                        } else {
                            phi_543_ = 0i;
                        }
                        let _e348 = phi_543_;
                        let _e349 = (_e268 == _e312);
                        if _e349 {
                            phi_553_ = true;
                        } else {
                            phi_553_ = (_e276 == _e312);
                        }
                        let _e352 = phi_553_;
                        let _e353 = select(1u, 0u, _e349);
                        if _e352 {
                            let _e354 = (_e353 + 1u);
                            phi_563_ = _e354;
                            phi_564_ = _e354;
                            phi_566_ = select(true, false, (_e354 == 2u));
                        } else {
                            phi_563_ = u32();
                            phi_564_ = 0u;
                            phi_566_ = true;
                        }
                        let _e358 = phi_563_;
                        let _e360 = phi_564_;
                        let _e362 = phi_566_;
                        if _e362 {
                            phi_571_ = (_e360 + 1u);
                        } else {
                            phi_571_ = 0u;
                        }
                        let _e366 = phi_571_;
                        let _e367 = select(_e358, _e360, _e362);
                        let _e368 = select(_e353, select(2u, _e353, _e352), _e362);
                        let _e369 = -(_e348);
                        if (_e369 < -126i) {
                            phi_604_ = -126i;
                        } else {
                            phi_604_ = select(_e369, 127i, (_e369 > 127i));
                        }
                        let _e374 = phi_604_;
                        let _e379 = bitcast<f32>((bitcast<u32>((_e374 + 127i)) << bitcast<u32>(23i)));
                        let _e385 = bitcast<f32>((bitcast<u32>(((_e369 - _e374) + 127i)) << bitcast<u32>(23i)));
                        let _e390 = global_10.member[_e141].member.member;
                        let _e391 = (_e367 == 0u);
                        if _e391 {
                            phi_622_ = _e390[0];
                        } else {
                            phi_622_ = _e390[1];
                        }
                        let _e395 = phi_622_;
                        let _e396 = (_e367 == 2u);
                        if _e396 {
                            phi_628_ = _e390[2];
                        } else {
                            phi_628_ = _e395;
                        }
                        let _e399 = phi_628_;
                        let _e400 = global_10.member[_e141].member.member_2;
                        if _e391 {
                            phi_639_ = _e400[0];
                        } else {
                            phi_639_ = _e400[1];
                        }
                        let _e404 = phi_639_;
                        if _e396 {
                            phi_645_ = _e400[2];
                        } else {
                            phi_645_ = _e404;
                        }
                        let _e407 = phi_645_;
                        let _e409 = ((_e407 * _e379) * _e385);
                        let _e413 = (bitcast<f32>((bitcast<u32>(_e409) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e413 {
                            let _e417 = (bitcast<f32>((bitcast<u32>(_e399) & 2147483647u)) * 0.00000011920929f);
                            phi_668_ = select(0.00000000000011368684f, _e417, (_e417 > 0.00000000000011368684f));
                        } else {
                            phi_668_ = 0f;
                        }
                        let _e421 = phi_668_;
                        let _e422 = (_e399 + _e421);
                        let _e423 = (_e399 - _e421);
                        let _e424 = select(_e409, 0f, _e413);
                        if _e413 {
                            phi_679_ = 38685626000000000000000000f;
                        } else {
                            phi_679_ = (1f / _e409);
                        }
                        let _e427 = phi_679_;
                        let _e428 = (_e366 == 0u);
                        if _e428 {
                            phi_688_ = _e390[0];
                        } else {
                            phi_688_ = _e390[1];
                        }
                        let _e432 = phi_688_;
                        let _e433 = (_e366 == 2u);
                        if _e433 {
                            phi_694_ = _e390[2];
                        } else {
                            phi_694_ = _e432;
                        }
                        let _e436 = phi_694_;
                        if _e428 {
                            phi_705_ = _e400[0];
                        } else {
                            phi_705_ = _e400[1];
                        }
                        let _e440 = phi_705_;
                        if _e433 {
                            phi_711_ = _e400[2];
                        } else {
                            phi_711_ = _e440;
                        }
                        let _e443 = phi_711_;
                        let _e445 = ((_e443 * _e379) * _e385);
                        let _e449 = (bitcast<f32>((bitcast<u32>(_e445) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e449 {
                            let _e453 = (bitcast<f32>((bitcast<u32>(_e436) & 2147483647u)) * 0.00000011920929f);
                            phi_734_ = select(0.00000000000011368684f, _e453, (_e453 > 0.00000000000011368684f));
                        } else {
                            phi_734_ = 0f;
                        }
                        let _e457 = phi_734_;
                        let _e458 = (_e436 + _e457);
                        let _e459 = (_e436 - _e457);
                        let _e460 = select(_e445, 0f, _e449);
                        if _e449 {
                            phi_745_ = 38685626000000000000000000f;
                        } else {
                            phi_745_ = (1f / _e445);
                        }
                        let _e463 = phi_745_;
                        let _e464 = (_e368 == 0u);
                        if _e464 {
                            phi_754_ = _e390[0];
                        } else {
                            phi_754_ = _e390[1];
                        }
                        let _e468 = phi_754_;
                        let _e469 = (_e368 == 2u);
                        if _e469 {
                            phi_760_ = _e390[2];
                        } else {
                            phi_760_ = _e468;
                        }
                        let _e472 = phi_760_;
                        if _e464 {
                            phi_771_ = _e400[0];
                        } else {
                            phi_771_ = _e400[1];
                        }
                        let _e476 = phi_771_;
                        if _e469 {
                            phi_777_ = _e400[2];
                        } else {
                            phi_777_ = _e476;
                        }
                        let _e479 = phi_777_;
                        let _e481 = ((_e479 * _e379) * _e385);
                        let _e485 = (bitcast<f32>((bitcast<u32>(_e481) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e485 {
                            let _e489 = (bitcast<f32>((bitcast<u32>(_e472) & 2147483647u)) * 0.00000011920929f);
                            phi_800_ = select(0.00000000000011368684f, _e489, (_e489 > 0.00000000000011368684f));
                        } else {
                            phi_800_ = 0f;
                        }
                        let _e493 = phi_800_;
                        let _e494 = (_e472 + _e493);
                        let _e495 = (_e472 - _e493);
                        let _e496 = select(_e481, 0f, _e485);
                        if _e485 {
                            phi_811_ = 38685626000000000000000000f;
                        } else {
                            phi_811_ = (1f / _e481);
                        }
                        let _e499 = phi_811_;
                        let _e502 = bitcast<f32>((bitcast<u32>(_e399) & 2147483647u));
                        let _e505 = bitcast<f32>((bitcast<u32>(_e436) & 2147483647u));
                        let _e507 = select(_e505, _e502, (_e502 > _e505));
                        let _e510 = bitcast<f32>((bitcast<u32>(_e472) & 2147483647u));
                        if (_e329 && (select(_e510, _e507, (_e507 > _e510)) <= 1099511600000f)) {
                            let _e515 = (_e348 / 3i);
                            let _e522 = bitcast<f32>((bitcast<u32>((_e515 + 127i)) << bitcast<u32>(23i)));
                            let _e529 = bitcast<f32>((bitcast<u32>(((_e348 - (2i * _e515)) + 127i)) << bitcast<u32>(23i)));
                            let _e530 = (((_e240 * _e522) * _e522) * _e529);
                            let _e532 = select(340282350000000000000000000000000000000f, _e530, (_e530 < 340282350000000000000000000000000000000f));
                            let _e537 = (((_e245 * _e522) * _e522) * _e529);
                            let _e539 = select(340282350000000000000000000000000000000f, _e537, (_e537 < 340282350000000000000000000000000000000f));
                            phi_911_ = select(-340282350000000000000000000000000000000f, _e539, (_e539 > -340282350000000000000000000000000000000f));
                            phi_912_ = select(-340282350000000000000000000000000000000f, _e532, (_e532 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_911_ = 0f;
                            phi_912_ = 1f;
                        }
                        let _e543 = phi_911_;
                        let _e545 = phi_912_;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e549 = (_e367 % 3u);
                        let _e550 = (_e549 < 3u);
                        if _e550 {
                        } else {
                            break;
                        }
                        let _e552 = local_1[_e549];
                        let _e555 = (_e366 % 3u);
                        let _e556 = (_e555 < 3u);
                        if _e556 {
                        } else {
                            break;
                        }
                        let _e558 = local_1[_e555];
                        let _e561 = (_e368 % 3u);
                        let _e562 = (_e561 < 3u);
                        if _e562 {
                        } else {
                            break;
                        }
                        let _e564 = local_1[_e561];
                        if _e550 {
                        } else {
                            break;
                        }
                        let _e569 = local[_e549];
                        if _e556 {
                        } else {
                            break;
                        }
                        let _e573 = local[_e555];
                        if _e562 {
                        } else {
                            break;
                        }
                        let _e577 = local[_e561];
                        phi_3786_ = false;
                        phi_1001_ = type_51(_e543, false);
                        phi_1004_ = type_63(type_39(vec4<f32>((f32(_e552) * _e153), (f32(_e558) * _e153), (f32(_e564) * _e153), 0f), vec4<f32>((f32(_e569) * _e153), (f32(_e573) * _e153), (f32(_e577) * _e153), 0f)), select(0u, 2147483648u, (_e95 == 0u)));
                        phi_1006_ = ((3u * _e95) + 1u);
                        phi_1008_ = (_e545 <= _e543);
                        phi_1010_ = 0u;
                        loop {
                            let _e587 = phi_3786_;
                            let _e589 = phi_1001_;
                            let _e591 = phi_1004_;
                            let _e593 = phi_1006_;
                            let _e595 = phi_1008_;
                            let _e597 = phi_1010_;
                            local_11 = _e589;
                            if _e595 {
                                phi_1021_ = true;
                            } else {
                                phi_1021_ = (_e597 > 0u);
                            }
                            let _e600 = phi_1021_;
                            if _e600 {
                                let _e601 = (_e593 > 0u);
                                if _e601 {
                                    if _e595 {
                                        phi_1107_ = _e591;
                                        phi_1108_ = _e595;
                                        phi_1109_ = _e597;
                                    } else {
                                        let _e602 = (_e597 - 1u);
                                        let _e603 = (_e602 % 128u);
                                        let _e604 = (_e603 < 128u);
                                        if _e604 {
                                        } else {
                                            phi_3918_ = true;
                                            break;
                                        }
                                        let _e606 = local_7[_e603];
                                        if _e604 {
                                        } else {
                                            phi_3918_ = true;
                                            break;
                                        }
                                        let _e608 = local_6[_e603];
                                        if _e604 {
                                        } else {
                                            phi_3918_ = true;
                                            break;
                                        }
                                        let _e610 = local_5[_e603];
                                        if _e604 {
                                        } else {
                                            phi_3918_ = true;
                                            break;
                                        }
                                        let _e612 = local_4[_e603];
                                        if _e604 {
                                        } else {
                                            phi_3918_ = true;
                                            break;
                                        }
                                        let _e614 = local_3[_e603];
                                        if _e604 {
                                        } else {
                                            phi_3918_ = true;
                                            break;
                                        }
                                        let _e616 = local_2[_e603];
                                        if _e604 {
                                        } else {
                                            phi_3918_ = true;
                                            break;
                                        }
                                        let _e621 = local_8[_e603];
                                        if _e604 {
                                        } else {
                                            phi_3918_ = true;
                                            break;
                                        }
                                        let _e624 = local_9[_e603];
                                        phi_1107_ = type_63(type_39(vec4<f32>(_e606, _e608, _e610, 0f), vec4<f32>(_e612, _e614, _e616, 0f)), _e621);
                                        phi_1108_ = (_e624 <= _e589.member);
                                        phi_1109_ = _e602;
                                    }
                                    let _e628 = phi_1107_;
                                    let _e630 = phi_1108_;
                                    let _e632 = phi_1109_;
                                    if _e630 {
                                        if ((_e628.member_1 & 2147483648u) != 0u) {
                                            phi_1127_ = _e589;
                                            phi_1130_ = type_8(0u, ((_e628.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1097 = phi_1127_;
                                                let _e1099 = phi_1130_;
                                                local_10 = _e1097;
                                                local_12 = _e1097;
                                                if (_e1099.member < _e1099.member_1) {
                                                    phi_1131_ = type_8((_e1099.member + 1u), _e1099.member_1);
                                                    phi_1153_ = type_8(1u, _e1099.member);
                                                } else {
                                                    phi_1131_ = _e1099;
                                                    phi_1153_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1112 = phi_1131_;
                                                let _e1114 = phi_1153_;
                                                let _e1118 = (bitcast<i32>(_e1114.member) != 0i);
                                                if _e1118 {
                                                    let _e1119 = ((_e628.member_1 & 268435455u) + _e1114.member_1);
                                                    let _e1120 = (_e1119 < _e97);
                                                    if _e1120 {
                                                        if _e1120 {
                                                        } else {
                                                            phi_3780_ = true;
                                                            break;
                                                        }
                                                        let _e1124 = global_6.member[_e1119].member_1;
                                                        phi_1174_ = _e1124;
                                                    } else {
                                                        phi_1174_ = 4294967295u;
                                                    }
                                                    let _e1126 = phi_1174_;
                                                    if (_e1119 >= _e97) {
                                                        phi_1263_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1120 {
                                                        } else {
                                                            phi_3780_ = true;
                                                            break;
                                                        }
                                                        if (_e549 < 9u) {
                                                        } else {
                                                            phi_3780_ = true;
                                                            break;
                                                        }
                                                        let _e1133 = global_6.member[_e1119].member[_e549];
                                                        if (_e555 < 9u) {
                                                        } else {
                                                            phi_3780_ = true;
                                                            break;
                                                        }
                                                        let _e1139 = global_6.member[_e1119].member[_e555];
                                                        if (_e561 < 9u) {
                                                        } else {
                                                            phi_3780_ = true;
                                                            break;
                                                        }
                                                        let _e1145 = global_6.member[_e1119].member[_e561];
                                                        let _e1147 = (3u + _e549);
                                                        if (_e1147 < 9u) {
                                                        } else {
                                                            phi_3780_ = true;
                                                            break;
                                                        }
                                                        let _e1153 = global_6.member[_e1119].member[_e1147];
                                                        let _e1154 = (3u + _e555);
                                                        if (_e1154 < 9u) {
                                                        } else {
                                                            phi_3780_ = true;
                                                            break;
                                                        }
                                                        let _e1160 = global_6.member[_e1119].member[_e1154];
                                                        let _e1161 = (3u + _e561);
                                                        if (_e1161 < 9u) {
                                                        } else {
                                                            phi_3780_ = true;
                                                            break;
                                                        }
                                                        let _e1167 = global_6.member[_e1119].member[_e1161];
                                                        let _e1169 = (6u + _e549);
                                                        if (_e1169 < 9u) {
                                                        } else {
                                                            phi_3780_ = true;
                                                            break;
                                                        }
                                                        let _e1175 = global_6.member[_e1119].member[_e1169];
                                                        let _e1176 = (6u + _e555);
                                                        if (_e1176 < 9u) {
                                                        } else {
                                                            phi_3780_ = true;
                                                            break;
                                                        }
                                                        let _e1182 = global_6.member[_e1119].member[_e1176];
                                                        let _e1183 = (6u + _e561);
                                                        if (_e1183 < 9u) {
                                                        } else {
                                                            phi_3780_ = true;
                                                            break;
                                                        }
                                                        let _e1189 = global_6.member[_e1119].member[_e1183];
                                                        phi_1263_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1133, _e1139, _e1145), array<f32, 3>(_e1153, _e1160, _e1167), array<f32, 3>(_e1175, _e1182, _e1189));
                                                    }
                                                    let _e1193 = phi_1263_;
                                                    let _e1201 = (_e1193[0][2] - _e472);
                                                    let _e1204 = (((_e1193[0][0] - _e399) * _e496) - (_e1201 * _e424));
                                                    let _e1207 = (((_e1193[0][1] - _e436) * _e496) - (_e1201 * _e460));
                                                    let _e1214 = (_e1193[1][2] - _e472);
                                                    let _e1217 = (((_e1193[1][0] - _e399) * _e496) - (_e1214 * _e424));
                                                    let _e1220 = (((_e1193[1][1] - _e436) * _e496) - (_e1214 * _e460));
                                                    let _e1227 = (_e1193[2][2] - _e472);
                                                    let _e1230 = (((_e1193[2][0] - _e399) * _e496) - (_e1227 * _e424));
                                                    let _e1233 = (((_e1193[2][1] - _e436) * _e496) - (_e1227 * _e460));
                                                    let _e1234 = (_e1230 * _e1220);
                                                    let _e1235 = (_e1233 * _e1217);
                                                    let _e1236 = (_e1204 * _e1233);
                                                    let _e1237 = (_e1207 * _e1230);
                                                    let _e1238 = (_e1217 * _e1207);
                                                    let _e1239 = (_e1220 * _e1204);
                                                    let _e1244 = (((_e1234 >= _e1235) && (_e1236 >= _e1237)) && (_e1238 >= _e1239));
                                                    if (_e1244 || (((_e1234 <= _e1235) && (_e1236 <= _e1237)) && (_e1238 <= _e1239))) {
                                                        let _e1251 = select(-1f, 1f, _e1244);
                                                        let _e1253 = ((_e1234 - _e1235) * _e1251);
                                                        let _e1255 = select(0f, _e1253, (_e1253 > 0f));
                                                        let _e1257 = ((_e1236 - _e1237) * _e1251);
                                                        let _e1259 = select(0f, _e1257, (_e1257 > 0f));
                                                        let _e1261 = ((_e1238 - _e1239) * _e1251);
                                                        let _e1263 = select(0f, _e1261, (_e1261 > 0f));
                                                        let _e1265 = ((_e1255 + _e1259) + _e1263);
                                                        if (_e1265 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1829_ = type_30();
                                                            phi_1830_ = true;
                                                        } else {
                                                            let _e1268 = select(_e1193[1][0], _e1193[0][0], (_e1193[0][0] < _e1193[1][0]));
                                                            let _e1272 = select(_e1193[1][0], _e1193[0][0], (_e1193[0][0] > _e1193[1][0]));
                                                            let _e1276 = select(_e1193[1][1], _e1193[0][1], (_e1193[0][1] < _e1193[1][1]));
                                                            let _e1280 = select(_e1193[1][1], _e1193[0][1], (_e1193[0][1] > _e1193[1][1]));
                                                            let _e1284 = select(_e1193[1][2], _e1193[0][2], (_e1193[0][2] < _e1193[1][2]));
                                                            let _e1288 = select(_e1193[1][2], _e1193[0][2], (_e1193[0][2] > _e1193[1][2]));
                                                            let _e1293 = ((select(_e1193[2][0], _e1268, (_e1268 < _e1193[2][0])) - _e422) * _e427);
                                                            let _e1294 = ((select(_e1193[2][0], _e1272, (_e1272 > _e1193[2][0])) - _e423) * _e427);
                                                            let _e1297 = ((select(_e1193[2][1], _e1276, (_e1276 < _e1193[2][1])) - _e458) * _e463);
                                                            let _e1298 = ((select(_e1193[2][1], _e1280, (_e1280 > _e1193[2][1])) - _e459) * _e463);
                                                            let _e1301 = ((select(_e1193[2][2], _e1284, (_e1284 < _e1193[2][2])) - _e494) * _e499);
                                                            let _e1302 = ((select(_e1193[2][2], _e1288, (_e1288 > _e1193[2][2])) - _e495) * _e499);
                                                            let _e1304 = select(_e1302, _e1301, (_e1301 < _e1302));
                                                            let _e1306 = select(_e1302, _e1301, (_e1301 > _e1302));
                                                            let _e1308 = select(_e1294, _e1293, (_e1293 < _e1294));
                                                            let _e1310 = select(_e1298, _e1297, (_e1297 < _e1298));
                                                            let _e1312 = select(_e1310, _e1308, (_e1308 > _e1310));
                                                            let _e1314 = select(_e1304, _e1312, (_e1312 > _e1304));
                                                            let _e1316 = select(_e1294, _e1293, (_e1293 > _e1294));
                                                            let _e1318 = select(_e1298, _e1297, (_e1297 > _e1298));
                                                            let _e1320 = select(_e1318, _e1316, (_e1316 < _e1318));
                                                            let _e1322 = select(_e1306, _e1320, (_e1320 < _e1306));
                                                            let _e1323 = -(_e1304);
                                                            let _e1329 = select(_e545, _e1314, (_e1314 > _e545));
                                                            if (_e1329 > (_e1322 + (select(_e1323, _e1306, (_e1306 > _e1323)) * 0.0000019073523f))) {
                                                                phi_1824_ = type_30();
                                                                phi_1825_ = true;
                                                            } else {
                                                                let _e1331 = (_e1329 > _e1097.member);
                                                                if _e1331 {
                                                                    phi_1823_ = type_30();
                                                                } else {
                                                                    let _e1335 = (_e1193[1][0] - _e1193[0][0]);
                                                                    let _e1336 = (_e1193[1][1] - _e1193[0][1]);
                                                                    let _e1337 = (_e1193[1][2] - _e1193[0][2]);
                                                                    let _e1338 = vec3<f32>(_e1335, _e1336, _e1337);
                                                                    let _e1339 = (_e1193[2][0] - _e1193[1][0]);
                                                                    let _e1340 = (_e1193[2][1] - _e1193[1][1]);
                                                                    let _e1341 = (_e1193[2][2] - _e1193[1][2]);
                                                                    let _e1342 = vec3<f32>(_e1339, _e1340, _e1341);
                                                                    let _e1343 = (_e1193[0][0] - _e1193[2][0]);
                                                                    let _e1344 = (_e1193[0][1] - _e1193[2][1]);
                                                                    let _e1345 = (_e1193[0][2] - _e1193[2][2]);
                                                                    let _e1346 = vec3<f32>(_e1343, _e1344, _e1345);
                                                                    let _e1349 = bitcast<f32>((bitcast<u32>(_e1335) & 2147483647u));
                                                                    let _e1352 = bitcast<f32>((bitcast<u32>(_e1336) & 2147483647u));
                                                                    let _e1354 = select(_e1352, _e1349, (_e1349 > _e1352));
                                                                    let _e1357 = bitcast<f32>((bitcast<u32>(_e1337) & 2147483647u));
                                                                    let _e1359 = select(_e1357, _e1354, (_e1354 > _e1357));
                                                                    let _e1362 = bitcast<f32>((bitcast<u32>(_e1339) & 2147483647u));
                                                                    let _e1365 = bitcast<f32>((bitcast<u32>(_e1340) & 2147483647u));
                                                                    let _e1367 = select(_e1365, _e1362, (_e1362 > _e1365));
                                                                    let _e1370 = bitcast<f32>((bitcast<u32>(_e1341) & 2147483647u));
                                                                    let _e1372 = select(_e1370, _e1367, (_e1367 > _e1370));
                                                                    let _e1375 = bitcast<f32>((bitcast<u32>(_e1343) & 2147483647u));
                                                                    let _e1378 = bitcast<f32>((bitcast<u32>(_e1344) & 2147483647u));
                                                                    let _e1380 = select(_e1378, _e1375, (_e1375 > _e1378));
                                                                    let _e1383 = bitcast<f32>((bitcast<u32>(_e1345) & 2147483647u));
                                                                    let _e1385 = select(_e1383, _e1380, (_e1380 > _e1383));
                                                                    let _e1387 = select(_e1372, _e1359, (_e1359 > _e1372));
                                                                    let _e1389 = select(_e1385, _e1387, (_e1387 > _e1385));
                                                                    if (_e1359 == _e1389) {
                                                                        phi_1734_ = _e1342;
                                                                        phi_1735_ = _e1346;
                                                                    } else {
                                                                        let _e1392 = vec3((_e1372 == _e1389));
                                                                        phi_1734_ = select(_e1338, _e1346, _e1392);
                                                                        phi_1735_ = select(_e1342, _e1338, _e1392);
                                                                    }
                                                                    let _e1396 = phi_1734_;
                                                                    let _e1398 = phi_1735_;
                                                                    let _e1405 = ((_e1396.y * _e1398.z) - (_e1398.y * _e1396.z));
                                                                    let _e1410 = ((_e1396.z * _e1398.x) - (_e1398.z * _e1396.x));
                                                                    let _e1413 = ((_e1396.x * _e1398.y) - (_e1398.x * _e1396.y));
                                                                    if (_e1255 >= _e1259) {
                                                                        phi_1766_ = select(true, false, (_e1255 >= _e1263));
                                                                    } else {
                                                                        phi_1766_ = true;
                                                                    }
                                                                    let _e1418 = phi_1766_;
                                                                    if _e1418 {
                                                                        phi_1775_ = select(vec3<f32>(_e1193[2][0], _e1193[2][1], _e1193[2][2]), vec3<f32>(_e1193[1][0], _e1193[1][1], _e1193[1][2]), vec3((_e1259 >= _e1263)));
                                                                    } else {
                                                                        phi_1775_ = vec3<f32>(_e1193[0][0], _e1193[0][1], _e1193[0][2]);
                                                                    }
                                                                    let _e1423 = phi_1775_;
                                                                    let _e1440 = ((((_e1405 * (_e1423.x - _e399)) + (_e1410 * (_e1423.y - _e436))) + (_e1413 * (_e1423.z - _e472))) / (((_e1405 * _e424) + (_e1410 * _e460)) + (_e1413 * _e496)));
                                                                    let _e1442 = select(_e1322, _e1440, (_e1440 < _e1322));
                                                                    let _e1444 = select(_e1314, _e1442, (_e1442 > _e1314));
                                                                    if (_e1444 >= _e545) {
                                                                        let _e1446 = (_e1444 <= _e1097.member);
                                                                        if _e1446 {
                                                                            let _e1447 = (1f / _e1265);
                                                                            phi_1815_ = type_30(_e1444, (_e1259 * _e1447), (_e1263 * _e1447), _e1126);
                                                                        } else {
                                                                            phi_1815_ = type_30();
                                                                        }
                                                                        let _e1452 = phi_1815_;
                                                                        phi_1817_ = _e1452;
                                                                        phi_1818_ = select(true, false, _e1446);
                                                                    } else {
                                                                        phi_1817_ = type_30();
                                                                        phi_1818_ = true;
                                                                    }
                                                                    let _e1455 = phi_1817_;
                                                                    let _e1457 = phi_1818_;
                                                                    if _e1457 {
                                                                        phi_1822_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_1822_ = _e1455;
                                                                    }
                                                                    let _e1459 = phi_1822_;
                                                                    phi_1823_ = _e1459;
                                                                }
                                                                let _e1461 = phi_1823_;
                                                                phi_1824_ = _e1461;
                                                                phi_1825_ = _e1331;
                                                            }
                                                            let _e1463 = phi_1824_;
                                                            let _e1465 = phi_1825_;
                                                            phi_1829_ = _e1463;
                                                            phi_1830_ = _e1465;
                                                        }
                                                        let _e1467 = phi_1829_;
                                                        let _e1469 = phi_1830_;
                                                        phi_1834_ = _e1467;
                                                        phi_1835_ = _e1469;
                                                    } else {
                                                        phi_1834_ = type_30();
                                                        phi_1835_ = true;
                                                    }
                                                    let _e1471 = phi_1834_;
                                                    let _e1473 = phi_1835_;
                                                    if _e1473 {
                                                        phi_1839_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1839_ = _e1471;
                                                    }
                                                    let _e1475 = phi_1839_;
                                                    if (_e1475.member_3 != 4294967295u) {
                                                        if (_e1126 == _e162) {
                                                            phi_2168_ = false;
                                                        } else {
                                                            let _e1479 = (_e1126 < arrayLength((&global_7.member)));
                                                            if _e1479 {
                                                                if _e1479 {
                                                                } else {
                                                                    phi_3780_ = true;
                                                                    break;
                                                                }
                                                                let _e1481 = global_7.member[_e1126];
                                                                phi_1862_ = _e1481;
                                                            } else {
                                                                phi_1862_ = 4294967295u;
                                                            }
                                                            let _e1483 = phi_1862_;
                                                            let _e1484 = (_e1483 < arrayLength((&global_8.member)));
                                                            if _e1484 {
                                                                if _e1484 {
                                                                } else {
                                                                    phi_3780_ = true;
                                                                    break;
                                                                }
                                                                let _e1486 = global_8.member[_e1483];
                                                                phi_1876_ = _e1486;
                                                            } else {
                                                                phi_1876_ = 0i;
                                                            }
                                                            let _e1488 = phi_1876_;
                                                            let _e1489 = (_e1488 == 0i);
                                                            if _e1489 {
                                                                phi_2167_ = true;
                                                            } else {
                                                                if _e391 {
                                                                    phi_1897_ = vec3<f32>(_e1193[0][0], _e1193[0][1], _e1193[0][2]);
                                                                } else {
                                                                    if (_e367 == 1u) {
                                                                        phi_1896_ = vec3<f32>(_e1193[0][2], _e1193[0][0], _e1193[0][1]);
                                                                    } else {
                                                                        phi_1896_ = vec3<f32>(_e1193[0][1], _e1193[0][2], _e1193[0][0]);
                                                                    }
                                                                    let _e1494 = phi_1896_;
                                                                    phi_1897_ = _e1494;
                                                                }
                                                                let _e1497 = phi_1897_;
                                                                if _e391 {
                                                                    phi_1914_ = vec3<f32>(_e1193[1][0], _e1193[1][1], _e1193[1][2]);
                                                                } else {
                                                                    if (_e367 == 1u) {
                                                                        phi_1913_ = vec3<f32>(_e1193[1][2], _e1193[1][0], _e1193[1][1]);
                                                                    } else {
                                                                        phi_1913_ = vec3<f32>(_e1193[1][1], _e1193[1][2], _e1193[1][0]);
                                                                    }
                                                                    let _e1502 = phi_1913_;
                                                                    phi_1914_ = _e1502;
                                                                }
                                                                let _e1505 = phi_1914_;
                                                                if _e391 {
                                                                    phi_1931_ = vec3<f32>(_e1193[2][0], _e1193[2][1], _e1193[2][2]);
                                                                } else {
                                                                    if (_e367 == 1u) {
                                                                        phi_1930_ = vec3<f32>(_e1193[2][2], _e1193[2][0], _e1193[2][1]);
                                                                    } else {
                                                                        phi_1930_ = vec3<f32>(_e1193[2][1], _e1193[2][2], _e1193[2][0]);
                                                                    }
                                                                    let _e1510 = phi_1930_;
                                                                    phi_1931_ = _e1510;
                                                                }
                                                                let _e1513 = phi_1931_;
                                                                let _e1516 = (_e1505.x - _e1497.x);
                                                                let _e1519 = (_e1505.y - _e1497.y);
                                                                let _e1522 = (_e1505.z - _e1497.z);
                                                                let _e1524 = (_e1513.x - _e1497.x);
                                                                let _e1526 = (_e1513.y - _e1497.y);
                                                                let _e1528 = (_e1513.z - _e1497.z);
                                                                if (_e234.member_1 == 1u) {
                                                                    phi_1967_ = (vec3<f32>(_e234.member[0], _e234.member[1], _e234.member[2]) - _e1497);
                                                                } else {
                                                                    phi_1967_ = vec3<f32>(_e234.member[0], _e234.member[1], _e234.member[2]);
                                                                }
                                                                let _e1543 = phi_1967_;
                                                                let _e1549 = bitcast<f32>((bitcast<u32>((_e1516 * _e1526)) ^ _e234.member_3[0]));
                                                                let _e1553 = bitcast<f32>((bitcast<u32>((_e1519 * _e1524)) ^ _e234.member_3[0]));
                                                                let _e1557 = bitcast<f32>((bitcast<u32>((_e1519 * _e1528)) ^ _e234.member_3[0]));
                                                                let _e1561 = bitcast<f32>((bitcast<u32>((_e1522 * _e1526)) ^ _e234.member_3[0]));
                                                                let _e1565 = bitcast<f32>((bitcast<u32>((_e1522 * _e1524)) ^ _e234.member_3[0]));
                                                                let _e1569 = bitcast<f32>((bitcast<u32>((_e1516 * _e1528)) ^ _e234.member_3[0]));
                                                                let _e1570 = (_e1557 - _e1561);
                                                                let _e1571 = (_e1565 - _e1569);
                                                                let _e1572 = (_e1549 - _e1553);
                                                                let _e1596 = (bitcast<f32>((bitcast<u32>(_e1557) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1561) & 2147483647u)));
                                                                let _e1603 = (bitcast<f32>((bitcast<u32>(_e1565) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1569) & 2147483647u)));
                                                                let _e1610 = (bitcast<f32>((bitcast<u32>(_e1549) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1553) & 2147483647u)));
                                                                if (_e234.member_2 == 0f) {
                                                                    phi_2149_ = 0f;
                                                                } else {
                                                                    let _e1640 = bitcast<f32>((bitcast<u32>(_e1570) & 2147483647u));
                                                                    let _e1643 = bitcast<f32>((bitcast<u32>(_e1571) & 2147483647u));
                                                                    let _e1646 = bitcast<f32>((bitcast<u32>(_e1572) & 2147483647u));
                                                                    let _e1648 = select(_e1646, _e1643, (_e1643 > _e1646));
                                                                    let _e1652 = select(_e1646, _e1643, (_e1643 < _e1646));
                                                                    let _e1656 = select(_e1643, _e1640, (_e1640 < _e1643));
                                                                    let _e1658 = select(_e1643, _e1640, (_e1640 > _e1643));
                                                                    let _e1660 = select(_e1646, _e1658, (_e1658 < _e1646));
                                                                    phi_2149_ = bitcast<f32>((bitcast<u32>((_e234.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1648, _e1640, (_e1640 > _e1648)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1660, _e1656, (_e1656 > _e1660)))) ^ _e234.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1652, _e1640, (_e1640 < _e1652)))) ^ _e234.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1596 + _e1603) + _e1610))) ^ _e234.member_3[0]))) * 1.0000005f)) ^ _e234.member_3[0])))) ^ _e234.member_3[0]));
                                                                }
                                                                let _e1687 = phi_2149_;
                                                                phi_2167_ = (_e1489 || !(((((bitcast<f32>((bitcast<u32>((_e1543.x * _e1570)) ^ _e234.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1543.y * _e1571)) ^ _e234.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1543.z * _e1572)) ^ _e234.member_3[0]))) * f32(-(_e1488))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1543.x) & 2147483647u)) * _e1596)) ^ _e234.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1543.y) & 2147483647u)) * _e1603)) ^ _e234.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1543.z) & 2147483647u)) * _e1610)) ^ _e234.member_3[0]))))) ^ _e234.member_3[0])) + _e1687) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1701 = phi_2167_;
                                                            phi_2168_ = _e1701;
                                                        }
                                                        let _e1703 = phi_2168_;
                                                        if _e1703 {
                                                            phi_2173_ = type_51(_e1097.member, true);
                                                        } else {
                                                            phi_2173_ = _e1097;
                                                        }
                                                        let _e1708 = phi_2173_;
                                                        phi_2174_ = _e1708;
                                                    } else {
                                                        phi_2174_ = _e1097;
                                                    }
                                                    let _e1710 = phi_2174_;
                                                    phi_1128_ = _e1710;
                                                } else {
                                                    phi_1128_ = type_51();
                                                }
                                                let _e1712 = phi_1128_;
                                                continue;
                                                continuing {
                                                    phi_1127_ = _e1712;
                                                    phi_1130_ = _e1112;
                                                    phi_3780_ = _e587;
                                                    break if !(_e1118);
                                                }
                                            }
                                            let _e1715 = phi_3780_;
                                            phi_3918_ = _e1715;
                                            if _e1715 {
                                                break;
                                            }
                                            let _e1717 = local_10;
                                            phi_3922_ = _e1715;
                                            let _e1904 = local_12;
                                            phi_3522_ = _e1904;
                                            phi_3523_ = _e628;
                                            phi_3524_ = false;
                                            phi_3525_ = select(_e632, 0u, _e1717.member_1);
                                        } else {
                                            if (_e628.member_1 >= _e95) {
                                                phi_3078_ = type_64(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_63(type_39(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_63(type_39(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e628.member_1 < _e95) {
                                                } else {
                                                    phi_3918_ = true;
                                                    break;
                                                }
                                                let _e644 = ((1u + _e367) % 4u);
                                                if (_e644 < 4u) {
                                                } else {
                                                    phi_3918_ = true;
                                                    break;
                                                }
                                                let _e649 = global_5.member[_e628.member_1][_e644];
                                                let _e651 = ((1u + _e366) % 4u);
                                                if (_e651 < 4u) {
                                                } else {
                                                    phi_3918_ = true;
                                                    break;
                                                }
                                                let _e656 = global_5.member[_e628.member_1][_e651];
                                                let _e658 = ((1u + _e368) % 4u);
                                                if (_e658 < 4u) {
                                                } else {
                                                    phi_3918_ = true;
                                                    break;
                                                }
                                                let _e663 = global_5.member[_e628.member_1][_e658];
                                                let _e665 = ((_e367 + 1u) % 4u);
                                                if (_e665 < 4u) {
                                                } else {
                                                    phi_3918_ = true;
                                                    break;
                                                }
                                                let _e670 = global_5.member[_e628.member_1][_e665];
                                                let _e672 = (_e670 >> bitcast<u32>(11u));
                                                let _e674 = ((_e366 + 1u) % 4u);
                                                if (_e674 < 4u) {
                                                } else {
                                                    phi_3918_ = true;
                                                    break;
                                                }
                                                let _e679 = global_5.member[_e628.member_1][_e674];
                                                let _e681 = (_e679 >> bitcast<u32>(11u));
                                                let _e683 = ((_e368 + 1u) % 4u);
                                                if (_e683 < 4u) {
                                                } else {
                                                    phi_3918_ = true;
                                                    break;
                                                }
                                                let _e688 = global_5.member[_e628.member_1][_e683];
                                                let _e690 = (_e688 >> bitcast<u32>(11u));
                                                let _e713 = (bitcast<f32>((bitcast<u32>((_e628.member.member_1.x - _e628.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e714 = (bitcast<f32>((bitcast<u32>((_e628.member.member_1.y - _e628.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e715 = (bitcast<f32>((bitcast<u32>((_e628.member.member_1.z - _e628.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e717 = select(_e153, _e713, (_e713 > _e153));
                                                let _e719 = select(_e153, _e714, (_e714 > _e153));
                                                let _e721 = select(_e153, _e715, (_e715 > _e153));
                                                let _e746 = bitcast<u32>((f32(bitcast<i32>((_e649 & 1023u))) * _e717));
                                                let _e751 = (bitcast<i32>((_e649 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e754 = bitcast<f32>((_e746 & bitcast<u32>(_e751)));
                                                let _e755 = bitcast<u32>((f32(bitcast<i32>((_e656 & 1023u))) * _e719));
                                                let _e760 = (bitcast<i32>((_e656 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e763 = bitcast<f32>((_e755 & bitcast<u32>(_e760)));
                                                let _e764 = bitcast<u32>((f32(bitcast<i32>((_e663 & 1023u))) * _e721));
                                                let _e769 = (bitcast<i32>((_e663 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e772 = bitcast<f32>((_e764 & bitcast<u32>(_e769)));
                                                let _e776 = bitcast<f32>((_e746 & bitcast<u32>(~(_e751))));
                                                let _e780 = bitcast<f32>((_e755 & bitcast<u32>(~(_e760))));
                                                let _e784 = bitcast<f32>((_e764 & bitcast<u32>(~(_e769))));
                                                let _e785 = bitcast<u32>((f32(bitcast<i32>((_e672 & 1023u))) * _e717));
                                                let _e790 = (bitcast<i32>((_e672 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e793 = bitcast<f32>((_e785 & bitcast<u32>(_e790)));
                                                let _e794 = bitcast<u32>((f32(bitcast<i32>((_e681 & 1023u))) * _e719));
                                                let _e799 = (bitcast<i32>((_e681 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e802 = bitcast<f32>((_e794 & bitcast<u32>(_e799)));
                                                let _e803 = bitcast<u32>((f32(bitcast<i32>((_e690 & 1023u))) * _e721));
                                                let _e808 = (bitcast<i32>((_e690 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e811 = bitcast<f32>((_e803 & bitcast<u32>(_e808)));
                                                let _e815 = bitcast<f32>((_e785 & bitcast<u32>(~(_e790))));
                                                let _e819 = bitcast<f32>((_e794 & bitcast<u32>(~(_e799))));
                                                let _e823 = bitcast<f32>((_e803 & bitcast<u32>(~(_e808))));
                                                let _e853 = global_5.member[_e628.member_1][0u];
                                                let _e857 = global_5.member[_e628.member_1][1u];
                                                let _e861 = global_5.member[_e628.member_1][2u];
                                                let _e865 = global_5.member[_e628.member_1][3u];
                                                let _e877 = (((_e857 >> bitcast<u32>(22i)) | ((_e861 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e865 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e878 = (_e853 & 268435455u);
                                                let _e879 = (_e877 & 268435455u);
                                                let _e882 = ((_e853 >> bitcast<u32>(28u)) & 7u);
                                                let _e890 = ((_e853 >> bitcast<u32>(31i)) | (((_e877 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e891 = (_e882 != 0u);
                                                if (_e882 == 0u) {
                                                    phi_3040_ = _e878;
                                                } else {
                                                    if (_e882 == 7u) {
                                                        phi_3039_ = 2147483648u;
                                                    } else {
                                                        phi_3039_ = ((2147483648u | (_e882 << bitcast<u32>(28u))) | (_e879 & 268435455u));
                                                    }
                                                    let _e900 = phi_3039_;
                                                    phi_3040_ = _e900;
                                                }
                                                let _e902 = phi_3040_;
                                                if _e891 {
                                                    let _e903 = (_e882 != 7u);
                                                    if _e903 {
                                                        phi_3050_ = (_e879 + _e882);
                                                    } else {
                                                        phi_3050_ = u32();
                                                    }
                                                    let _e906 = phi_3050_;
                                                    phi_3052_ = _e906;
                                                    phi_3053_ = select(true, false, _e903);
                                                } else {
                                                    phi_3052_ = u32();
                                                    phi_3053_ = true;
                                                }
                                                let _e909 = phi_3052_;
                                                let _e911 = phi_3053_;
                                                if (_e890 == 0u) {
                                                    phi_3074_ = (_e878 + select(0u, 1u, !(_e891)));
                                                } else {
                                                    if (_e890 == 7u) {
                                                        phi_3073_ = 2147483648u;
                                                    } else {
                                                        phi_3073_ = ((2147483648u | (_e890 << bitcast<u32>(28u))) | (select(_e909, _e879, _e911) & 268435455u));
                                                    }
                                                    let _e924 = phi_3073_;
                                                    phi_3074_ = _e924;
                                                }
                                                let _e926 = phi_3074_;
                                                phi_3078_ = type_64(array<vec4<f32>, 3>(vec4<f32>((_e628.member.member.x + _e754), (_e628.member.member.x + _e776), (_e628.member.member_1.x - _e793), (_e628.member.member_1.x - _e815)), vec4<f32>((_e628.member.member.y + _e763), (_e628.member.member.y + _e780), (_e628.member.member_1.y - _e802), (_e628.member.member_1.y - _e819)), vec4<f32>((_e628.member.member.z + _e772), (_e628.member.member.z + _e784), (_e628.member.member_1.z - _e811), (_e628.member.member_1.z - _e823))), type_63(type_39((_e628.member.member + vec4<f32>(_e754, _e763, _e772, 0f)), (_e628.member.member_1 - vec4<f32>(_e793, _e802, _e811, 0f))), _e902), type_63(type_39((_e628.member.member + vec4<f32>(_e776, _e780, _e784, 0f)), (_e628.member.member_1 - vec4<f32>(_e815, _e819, _e823, 0f))), _e926));
                                            }
                                            let _e931 = phi_3078_;
                                            let _e943 = ((_e931.member[0].x - _e422) * _e427);
                                            let _e944 = ((_e931.member[0].y - _e422) * _e427);
                                            let _e945 = ((_e931.member[0].z - _e423) * _e427);
                                            let _e946 = ((_e931.member[0].w - _e423) * _e427);
                                            let _e956 = ((_e931.member[1].x - _e458) * _e463);
                                            let _e957 = ((_e931.member[1].y - _e458) * _e463);
                                            let _e958 = ((_e931.member[1].z - _e459) * _e463);
                                            let _e959 = ((_e931.member[1].w - _e459) * _e463);
                                            let _e969 = ((_e931.member[2].x - _e494) * _e499);
                                            let _e970 = ((_e931.member[2].y - _e494) * _e499);
                                            let _e971 = ((_e931.member[2].z - _e495) * _e499);
                                            let _e972 = ((_e931.member[2].w - _e495) * _e499);
                                            let _e974 = select(_e971, _e969, (_e969 < _e971));
                                            let _e976 = select(_e972, _e970, (_e970 < _e972));
                                            let _e978 = select(_e971, _e969, (_e969 > _e971));
                                            let _e980 = select(_e972, _e970, (_e970 > _e972));
                                            let _e982 = select(_e945, _e943, (_e943 < _e945));
                                            let _e984 = select(_e946, _e944, (_e944 < _e946));
                                            let _e986 = select(_e958, _e956, (_e956 < _e958));
                                            let _e988 = select(_e959, _e957, (_e957 < _e959));
                                            let _e990 = select(_e986, _e982, (_e982 > _e986));
                                            let _e992 = select(_e988, _e984, (_e984 > _e988));
                                            let _e994 = select(_e974, _e990, (_e990 > _e974));
                                            let _e996 = select(_e976, _e992, (_e992 > _e976));
                                            let _e998 = select(_e945, _e943, (_e943 > _e945));
                                            let _e1000 = select(_e946, _e944, (_e944 > _e946));
                                            let _e1002 = select(_e958, _e956, (_e956 > _e958));
                                            let _e1004 = select(_e959, _e957, (_e957 > _e959));
                                            let _e1006 = select(_e1002, _e998, (_e998 < _e1002));
                                            let _e1008 = select(_e1004, _e1000, (_e1000 < _e1004));
                                            let _e1013 = -(_e974);
                                            let _e1014 = -(_e976);
                                            let _e1021 = (select(_e978, _e1006, (_e1006 < _e978)) + (select(_e1013, _e978, (_e978 > _e1013)) * 0.0000019073523f));
                                            let _e1022 = (select(_e980, _e1008, (_e1008 < _e980)) + (select(_e1014, _e980, (_e980 > _e1014)) * 0.0000019073523f));
                                            let _e1024 = select(_e545, _e994, (_e994 > _e545));
                                            let _e1026 = select(_e545, _e996, (_e996 > _e545));
                                            let _e1031 = (_e1024 <= select(_e589.member, _e1021, (_e1021 < _e589.member)));
                                            let _e1032 = (_e1026 <= select(_e589.member, _e1022, (_e1022 < _e589.member)));
                                            let _e1033 = (_e1024 <= _e1026);
                                            if _e1031 {
                                                if _e1032 {
                                                    if _e1033 {
                                                        phi_3422_ = _e931.member_2;
                                                    } else {
                                                        phi_3422_ = _e931.member_1;
                                                    }
                                                    let _e1037 = phi_3422_;
                                                    let _e1059 = (_e632 % 128u);
                                                    let _e1060 = (_e1059 < 128u);
                                                    if _e1060 {
                                                    } else {
                                                        phi_3918_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1059] = _e1037.member_1;
                                                    if _e1060 {
                                                    } else {
                                                        phi_3918_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1059] = _e1037.member.member.x;
                                                    if _e1060 {
                                                    } else {
                                                        phi_3918_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1059] = _e1037.member.member.y;
                                                    if _e1060 {
                                                    } else {
                                                        phi_3918_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1059] = _e1037.member.member.z;
                                                    if _e1060 {
                                                    } else {
                                                        phi_3918_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1059] = _e1037.member.member_1.x;
                                                    if _e1060 {
                                                    } else {
                                                        phi_3918_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1059] = _e1037.member.member_1.y;
                                                    if _e1060 {
                                                    } else {
                                                        phi_3918_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1059] = _e1037.member.member_1.z;
                                                    if _e1060 {
                                                    } else {
                                                        phi_3918_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1059] = select(_e1026, _e1024, (_e1024 > _e1026));
                                                    if _e1033 {
                                                        phi_3499_ = _e931.member_1;
                                                    } else {
                                                        phi_3499_ = _e931.member_2;
                                                    }
                                                    let _e1073 = phi_3499_;
                                                    phi_3500_ = _e1073;
                                                    phi_3501_ = (_e632 + 1u);
                                                } else {
                                                    phi_3500_ = type_63();
                                                    phi_3501_ = u32();
                                                }
                                                let _e1075 = phi_3500_;
                                                let _e1077 = phi_3501_;
                                                phi_3503_ = _e1075;
                                                phi_3504_ = _e1077;
                                                phi_3505_ = select(true, false, _e1032);
                                            } else {
                                                phi_3503_ = type_63();
                                                phi_3504_ = u32();
                                                phi_3505_ = true;
                                            }
                                            let _e1080 = phi_3503_;
                                            let _e1082 = phi_3504_;
                                            let _e1084 = phi_3505_;
                                            if _e1084 {
                                                if _e1031 {
                                                    phi_3514_ = _e931.member_1;
                                                } else {
                                                    phi_3514_ = _e931.member_2;
                                                }
                                                let _e1088 = phi_3514_;
                                                phi_3519_ = _e1088;
                                                phi_3520_ = select(_e1032, true, _e1031);
                                            } else {
                                                phi_3519_ = _e1080;
                                                phi_3520_ = _e630;
                                            }
                                            let _e1091 = phi_3519_;
                                            let _e1093 = phi_3520_;
                                            phi_3922_ = _e587;
                                            phi_3522_ = _e589;
                                            phi_3523_ = _e1091;
                                            phi_3524_ = _e1093;
                                            phi_3525_ = select(_e1082, _e632, _e1084);
                                        }
                                        let _e1721 = phi_3922_;
                                        let _e1723 = phi_3522_;
                                        let _e1725 = phi_3523_;
                                        let _e1727 = phi_3524_;
                                        let _e1729 = phi_3525_;
                                        phi_3921_ = _e1721;
                                        phi_3526_ = _e1723;
                                        phi_3527_ = _e1725;
                                        phi_3528_ = (_e593 - 1u);
                                        phi_3529_ = _e1727;
                                        phi_3530_ = _e1729;
                                    } else {
                                        phi_3921_ = _e587;
                                        phi_3526_ = _e589;
                                        phi_3527_ = _e628;
                                        phi_3528_ = _e593;
                                        phi_3529_ = _e630;
                                        phi_3530_ = _e632;
                                    }
                                    let _e1731 = phi_3921_;
                                    let _e1733 = phi_3526_;
                                    let _e1735 = phi_3527_;
                                    let _e1737 = phi_3528_;
                                    let _e1739 = phi_3529_;
                                    let _e1741 = phi_3530_;
                                    phi_3920_ = _e1731;
                                    phi_3531_ = _e1733;
                                    phi_3532_ = _e1735;
                                    phi_3533_ = _e1737;
                                    phi_3534_ = _e1739;
                                    phi_3535_ = _e1741;
                                } else {
                                    phi_3920_ = _e587;
                                    phi_3531_ = type_51();
                                    phi_3532_ = type_63();
                                    phi_3533_ = u32();
                                    phi_3534_ = bool();
                                    phi_3535_ = u32();
                                }
                                let _e1743 = phi_3920_;
                                let _e1745 = phi_3531_;
                                let _e1747 = phi_3532_;
                                let _e1749 = phi_3533_;
                                let _e1751 = phi_3534_;
                                let _e1753 = phi_3535_;
                                phi_3919_ = _e1743;
                                phi_1002_ = _e1745;
                                phi_1005_ = _e1747;
                                phi_1007_ = _e1749;
                                phi_1009_ = _e1751;
                                phi_1011_ = _e1753;
                                phi_3536_ = _e601;
                            } else {
                                phi_3919_ = _e587;
                                phi_1002_ = type_51();
                                phi_1005_ = type_63();
                                phi_1007_ = u32();
                                phi_1009_ = bool();
                                phi_1011_ = u32();
                                phi_3536_ = false;
                            }
                            let _e1755 = phi_3919_;
                            let _e1757 = phi_1002_;
                            let _e1759 = phi_1005_;
                            let _e1761 = phi_1007_;
                            let _e1763 = phi_1009_;
                            let _e1765 = phi_1011_;
                            let _e1767 = phi_3536_;
                            continue;
                            continuing {
                                phi_3786_ = _e1755;
                                phi_1001_ = _e1757;
                                phi_1004_ = _e1759;
                                phi_1006_ = _e1761;
                                phi_1008_ = _e1763;
                                phi_1010_ = _e1765;
                                phi_3918_ = _e1755;
                                break if !(_e1767);
                            }
                        }
                        let _e1770 = phi_3918_;
                        if _e1770 {
                            break;
                        }
                        let _e1772 = local_11;
                        if _e1772.member_1 {
                        } else {
                            if _e235 {
                            } else {
                                break;
                            }
                            let _e1776 = global_2.member[_e141];
                            if _e156 {
                            } else {
                                break;
                            }
                            let _e1780 = global_10.member[_e141].member_1;
                            if _e235 {
                            } else {
                                break;
                            }
                            global_2.member[_e141] = type_32(_e1776.member, _e1776.member_1, _e1776.member_2, array<f32, 3>((_e1776.member_3[0] + (_e1780[0] * _e1776.member_1[0])), (_e1776.member_3[1] + (_e1780[1] * _e1776.member_1[1])), (_e1776.member_3[2] + (_e1780[2] * _e1776.member_1[2]))), _e1776.member_4);
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
fn trace_shadows_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
