struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: vec4<u32>,
}

struct type_18 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_20 {
    member: array<type_18>,
}

struct type_28 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_29 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_30 {
    member: type_29,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_32 {
    member: array<type_30>,
}

struct type_37 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_39 {
    member: array<type_37>,
}

struct type_42 {
    member: type_29,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_44 {
    member: array<type_42>,
}

struct type_47 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_54 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_55 {
    member: f32,
    member_1: bool,
}

struct type_57 {
    member: array<vec4<u32>, 2>,
}

struct type_60 {
    member: array<i32>,
}

struct type_67 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_57;
@group(0) @binding(2) 
var<storage> global_3: type_39;
@group(0) @binding(3) 
var<storage> global_4: type_20;
@group(0) @binding(4) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage> global_6: type_60;
@group(0) @binding(8) 
var<storage, read_write> global_7: type_67;
@group(0) @binding(6) 
var<storage> global_8: type_44;
@group(0) @binding(7) 
var<storage, read_write> global_9: type_32;

fn function_() {
    var local: array<u32, 128>;
    var local_1: array<f32, 128>;
    var phi_313_: type_47;
    var phi_423_: i32;
    var phi_424_: i32;
    var phi_434_: bool;
    var phi_444_: u32;
    var phi_445_: u32;
    var phi_447_: bool;
    var phi_452_: u32;
    var phi_496_: f32;
    var phi_502_: f32;
    var phi_513_: f32;
    var phi_519_: f32;
    var phi_542_: f32;
    var phi_553_: f32;
    var phi_562_: f32;
    var phi_568_: f32;
    var phi_579_: f32;
    var phi_585_: f32;
    var phi_608_: f32;
    var phi_619_: f32;
    var phi_628_: f32;
    var phi_634_: f32;
    var phi_645_: f32;
    var phi_651_: f32;
    var phi_674_: f32;
    var phi_685_: f32;
    var phi_785_: f32;
    var phi_786_: f32;
    var phi_2486_: bool;
    var phi_797_: type_55;
    var phi_800_: u32;
    var phi_802_: u32;
    var phi_804_: bool;
    var phi_806_: u32;
    var phi_817_: bool;
    var phi_847_: u32;
    var phi_848_: bool;
    var phi_849_: u32;
    var phi_2010_: type_54;
    var phi_2354_: u32;
    var phi_2380_: u32;
    var phi_2381_: u32;
    var phi_2382_: u32;
    var phi_2384_: u32;
    var phi_2385_: u32;
    var phi_2386_: bool;
    var phi_2395_: u32;
    var phi_2400_: u32;
    var phi_2401_: bool;
    var phi_865_: type_55;
    var phi_868_: type_8;
    var phi_869_: type_8;
    var phi_891_: type_8;
    var phi_911_: u32;
    var phi_999_: array<array<f32, 3>, 3>;
    var phi_1470_: vec3<f32>;
    var phi_1471_: vec3<f32>;
    var phi_1502_: bool;
    var phi_1511_: vec3<f32>;
    var phi_1551_: type_28;
    var phi_1553_: type_28;
    var phi_1554_: bool;
    var phi_1558_: type_28;
    var phi_1559_: type_28;
    var phi_1560_: type_28;
    var phi_1561_: bool;
    var phi_1565_: type_28;
    var phi_1566_: bool;
    var phi_1570_: type_28;
    var phi_1571_: bool;
    var phi_1575_: type_28;
    var phi_1598_: u32;
    var phi_1612_: i32;
    var phi_1704_: array<array<f32, 3>, 3>;
    var phi_1742_: vec3<f32>;
    var phi_1924_: f32;
    var phi_1942_: bool;
    var phi_1943_: bool;
    var phi_1948_: type_55;
    var phi_1949_: type_55;
    var phi_866_: type_55;
    var phi_2480_: bool;
    var local_2: type_55;
    var phi_2610_: bool;
    var phi_2403_: type_55;
    var phi_2404_: u32;
    var phi_2405_: bool;
    var phi_2406_: u32;
    var phi_2609_: bool;
    var phi_2407_: type_55;
    var phi_2408_: u32;
    var phi_2409_: u32;
    var phi_2410_: bool;
    var phi_2411_: u32;
    var phi_2608_: bool;
    var phi_2412_: type_55;
    var phi_2413_: u32;
    var phi_2414_: u32;
    var phi_2415_: bool;
    var phi_2416_: u32;
    var phi_2607_: bool;
    var phi_798_: type_55;
    var phi_801_: u32;
    var phi_803_: u32;
    var phi_805_: bool;
    var phi_807_: u32;
    var phi_2417_: bool;
    var phi_2606_: bool;
    var local_3: type_55;
    var local_4: type_55;

    switch bitcast<i32>(0u) {
        default: {
            let _e73 = global;
            let _e75 = arrayLength((&global_3.member));
            let _e77 = arrayLength((&global_4.member));
            let _e89 = arrayLength((&global_7.member));
            let _e93 = (_e73.x + (_e73.y * 2097152u));
            let _e94 = (_e93 < arrayLength((&global_8.member)));
            if _e94 {
                let _e95 = (_e93 < arrayLength((&global_9.member)));
                if _e95 {
                    if _e94 {
                    } else {
                        break;
                    }
                    let _e100 = global_8.member[_e93].member.member_1;
                    let _e105 = global_8.member[_e93].member.member_3;
                    if (_e100 <= _e105) {
                        let _e107 = (1u < _e89);
                        if _e107 {
                            if (0u < _e89) {
                            } else {
                                break;
                            }
                            let _e111 = atomicAdd((&global_7.member[0u]), 1u);
                            if ((_e111 + 1u) < _e111) {
                                if _e107 {
                                } else {
                                    break;
                                }
                                let _e116 = atomicAdd((&global_7.member[1u]), 1u);
                            }
                        }
                        let _e119 = global_1.member[0u];
                        let _e123 = global_2.member[0u][0u];
                        let _e127 = global_2.member[0u][1u];
                        let _e131 = global_2.member[0u][2u];
                        let _e135 = global_2.member[0u][3u];
                        let _e139 = global_2.member[1u][0u];
                        let _e143 = global_2.member[1u][1u];
                        let _e147 = global_2.member[1u][2u];
                        let _e151 = global_2.member[1u][3u];
                        let _e152 = bitcast<f32>(_e123);
                        let _e153 = bitcast<f32>(_e127);
                        let _e154 = bitcast<f32>(_e131);
                        let _e156 = bitcast<f32>(_e139);
                        let _e157 = array<u32, 3>(_e143, _e147, _e151);
                        let _e159 = bitcast<i32>(_e119);
                        let _e160 = (_e159 / 2i);
                        let _e165 = bitcast<f32>((bitcast<u32>((_e160 + 127i)) << bitcast<u32>(23i)));
                        let _e171 = bitcast<f32>((bitcast<u32>(((_e159 - _e160) + 127i)) << bitcast<u32>(23i)));
                        if (_e135 == 0u) {
                            phi_313_ = type_47(array<f32, 3>(_e152, _e153, _e154), _e135, _e156, _e157);
                        } else {
                            phi_313_ = type_47(array<f32, 3>(((_e152 * _e165) * _e171), ((_e153 * _e165) * _e171), ((_e154 * _e165) * _e171)), _e135, ((_e156 * _e165) * _e171), _e157);
                        }
                        let _e184 = phi_313_;
                        if _e94 {
                        } else {
                            break;
                        }
                        if _e94 {
                        } else {
                            break;
                        }
                        let _e188 = global_8.member[_e93].member_2;
                        let _e198 = global_8.member[_e93].member.member_2[0u];
                        let _e200 = (bitcast<u32>(_e198) & 2147483647u);
                        let _e206 = global_8.member[_e93].member.member_2[1u];
                        let _e208 = (bitcast<u32>(_e206) & 2147483647u);
                        let _e214 = global_8.member[_e93].member.member_2[2u];
                        let _e216 = (bitcast<u32>(_e214) & 2147483647u);
                        let _e222 = global_8.member[_e93].member.member[0u];
                        let _e224 = (bitcast<u32>(_e222) & 2147483647u);
                        let _e230 = global_8.member[_e93].member.member[1u];
                        let _e232 = (bitcast<u32>(_e230) & 2147483647u);
                        let _e238 = global_8.member[_e93].member.member[2u];
                        let _e240 = (bitcast<u32>(_e238) & 2147483647u);
                        let _e242 = select(_e208, _e200, (_e208 < _e200));
                        let _e244 = select(_e216, _e242, (_e216 < _e242));
                        let _e246 = select(_e224, _e244, (_e224 < _e244));
                        let _e248 = select(_e232, _e246, (_e232 < _e246));
                        let _e250 = select(_e240, _e248, (_e240 < _e248));
                        let _e252 = (bitcast<u32>(_e100) & 2147483647u);
                        let _e261 = (((select(_e252, _e250, (_e252 < _e250)) < 2139095040u) && ((bitcast<u32>(_e105) & 2147483647u) <= 2139095040u)) && (_e244 > 0u));
                        if _e261 {
                            let _e264 = (bitcast<u32>(bitcast<f32>(_e244)) & 2147483647u);
                            if (_e264 >= 8388608u) {
                                phi_423_ = (bitcast<i32>((_e264 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_423_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e264)), 32u, (_e264 == 0u))));
                            }
                            let _e278 = phi_423_;
                            phi_424_ = _e278;
                        } else {
                            phi_424_ = 0i;
                        }
                        let _e280 = phi_424_;
                        let _e281 = (_e200 == _e244);
                        if _e281 {
                            phi_434_ = true;
                        } else {
                            phi_434_ = (_e208 == _e244);
                        }
                        let _e284 = phi_434_;
                        let _e285 = select(1u, 0u, _e281);
                        if _e284 {
                            let _e286 = (_e285 + 1u);
                            phi_444_ = _e286;
                            phi_445_ = _e286;
                            phi_447_ = select(true, false, (_e286 == 2u));
                        } else {
                            phi_444_ = u32();
                            phi_445_ = 0u;
                            phi_447_ = true;
                        }
                        let _e290 = phi_444_;
                        let _e292 = phi_445_;
                        let _e294 = phi_447_;
                        if _e294 {
                            phi_452_ = (_e292 + 1u);
                        } else {
                            phi_452_ = 0u;
                        }
                        let _e298 = phi_452_;
                        let _e299 = select(_e290, _e292, _e294);
                        let _e300 = select(_e285, select(2u, _e285, _e284), _e294);
                        let _e301 = -(_e280);
                        let _e302 = (_e301 / 2i);
                        let _e307 = bitcast<f32>((bitcast<u32>((_e302 + 127i)) << bitcast<u32>(23i)));
                        let _e313 = bitcast<f32>((bitcast<u32>(((_e301 - _e302) + 127i)) << bitcast<u32>(23i)));
                        let _e318 = global_8.member[_e93].member.member;
                        let _e319 = (_e299 == 0u);
                        if _e319 {
                            phi_496_ = _e318[0];
                        } else {
                            phi_496_ = _e318[1];
                        }
                        let _e323 = phi_496_;
                        let _e324 = (_e299 == 2u);
                        if _e324 {
                            phi_502_ = _e318[2];
                        } else {
                            phi_502_ = _e323;
                        }
                        let _e327 = phi_502_;
                        let _e328 = global_8.member[_e93].member.member_2;
                        if _e319 {
                            phi_513_ = _e328[0];
                        } else {
                            phi_513_ = _e328[1];
                        }
                        let _e332 = phi_513_;
                        if _e324 {
                            phi_519_ = _e328[2];
                        } else {
                            phi_519_ = _e332;
                        }
                        let _e335 = phi_519_;
                        let _e337 = ((_e335 * _e307) * _e313);
                        let _e341 = (bitcast<f32>((bitcast<u32>(_e337) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e341 {
                            let _e345 = (bitcast<f32>((bitcast<u32>(_e327) & 2147483647u)) * 0.00000011920929f);
                            phi_542_ = select(0.00000000000011368684f, _e345, (_e345 > 0.00000000000011368684f));
                        } else {
                            phi_542_ = 0f;
                        }
                        let _e349 = phi_542_;
                        let _e350 = (_e327 + _e349);
                        let _e351 = (_e327 - _e349);
                        let _e352 = select(_e337, 0f, _e341);
                        if _e341 {
                            phi_553_ = 38685626000000000000000000f;
                        } else {
                            phi_553_ = (1f / _e337);
                        }
                        let _e355 = phi_553_;
                        let _e356 = (_e298 == 0u);
                        if _e356 {
                            phi_562_ = _e318[0];
                        } else {
                            phi_562_ = _e318[1];
                        }
                        let _e360 = phi_562_;
                        let _e361 = (_e298 == 2u);
                        if _e361 {
                            phi_568_ = _e318[2];
                        } else {
                            phi_568_ = _e360;
                        }
                        let _e364 = phi_568_;
                        if _e356 {
                            phi_579_ = _e328[0];
                        } else {
                            phi_579_ = _e328[1];
                        }
                        let _e368 = phi_579_;
                        if _e361 {
                            phi_585_ = _e328[2];
                        } else {
                            phi_585_ = _e368;
                        }
                        let _e371 = phi_585_;
                        let _e373 = ((_e371 * _e307) * _e313);
                        let _e377 = (bitcast<f32>((bitcast<u32>(_e373) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e377 {
                            let _e381 = (bitcast<f32>((bitcast<u32>(_e364) & 2147483647u)) * 0.00000011920929f);
                            phi_608_ = select(0.00000000000011368684f, _e381, (_e381 > 0.00000000000011368684f));
                        } else {
                            phi_608_ = 0f;
                        }
                        let _e385 = phi_608_;
                        let _e386 = (_e364 + _e385);
                        let _e387 = (_e364 - _e385);
                        let _e388 = select(_e373, 0f, _e377);
                        if _e377 {
                            phi_619_ = 38685626000000000000000000f;
                        } else {
                            phi_619_ = (1f / _e373);
                        }
                        let _e391 = phi_619_;
                        let _e392 = (_e300 == 0u);
                        if _e392 {
                            phi_628_ = _e318[0];
                        } else {
                            phi_628_ = _e318[1];
                        }
                        let _e396 = phi_628_;
                        let _e397 = (_e300 == 2u);
                        if _e397 {
                            phi_634_ = _e318[2];
                        } else {
                            phi_634_ = _e396;
                        }
                        let _e400 = phi_634_;
                        if _e392 {
                            phi_645_ = _e328[0];
                        } else {
                            phi_645_ = _e328[1];
                        }
                        let _e404 = phi_645_;
                        if _e397 {
                            phi_651_ = _e328[2];
                        } else {
                            phi_651_ = _e404;
                        }
                        let _e407 = phi_651_;
                        let _e409 = ((_e407 * _e307) * _e313);
                        let _e413 = (bitcast<f32>((bitcast<u32>(_e409) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e413 {
                            let _e417 = (bitcast<f32>((bitcast<u32>(_e400) & 2147483647u)) * 0.00000011920929f);
                            phi_674_ = select(0.00000000000011368684f, _e417, (_e417 > 0.00000000000011368684f));
                        } else {
                            phi_674_ = 0f;
                        }
                        let _e421 = phi_674_;
                        let _e422 = (_e400 + _e421);
                        let _e423 = (_e400 - _e421);
                        let _e424 = select(_e409, 0f, _e413);
                        if _e413 {
                            phi_685_ = 38685626000000000000000000f;
                        } else {
                            phi_685_ = (1f / _e409);
                        }
                        let _e427 = phi_685_;
                        let _e430 = bitcast<f32>((bitcast<u32>(_e327) & 2147483647u));
                        let _e433 = bitcast<f32>((bitcast<u32>(_e364) & 2147483647u));
                        let _e435 = select(_e433, _e430, (_e430 > _e433));
                        let _e438 = bitcast<f32>((bitcast<u32>(_e400) & 2147483647u));
                        if (_e261 && (select(_e438, _e435, (_e435 > _e438)) <= 1099511600000f)) {
                            let _e443 = (_e280 / 3i);
                            let _e450 = bitcast<f32>((bitcast<u32>((_e443 + 127i)) << bitcast<u32>(23i)));
                            let _e457 = bitcast<f32>((bitcast<u32>(((_e280 - (2i * _e443)) + 127i)) << bitcast<u32>(23i)));
                            let _e458 = (((_e100 * _e450) * _e450) * _e457);
                            let _e460 = select(340282350000000000000000000000000000000f, _e458, (_e458 < 340282350000000000000000000000000000000f));
                            let _e465 = (((_e105 * _e450) * _e450) * _e457);
                            let _e467 = select(340282350000000000000000000000000000000f, _e465, (_e465 < 340282350000000000000000000000000000000f));
                            phi_785_ = select(-340282350000000000000000000000000000000f, _e467, (_e467 > -340282350000000000000000000000000000000f));
                            phi_786_ = select(-340282350000000000000000000000000000000f, _e460, (_e460 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_785_ = 0f;
                            phi_786_ = 1f;
                        }
                        let _e471 = phi_785_;
                        let _e473 = phi_786_;
                        local = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        phi_2486_ = false;
                        phi_797_ = type_55(_e471, false);
                        phi_800_ = select(0u, 2147483648u, (_e75 == 0u));
                        phi_802_ = ((3u * _e75) + 1u);
                        phi_804_ = (_e473 <= _e471);
                        phi_806_ = 0u;
                        loop {
                            let _e481 = phi_2486_;
                            let _e483 = phi_797_;
                            let _e485 = phi_800_;
                            let _e487 = phi_802_;
                            let _e489 = phi_804_;
                            let _e491 = phi_806_;
                            local_3 = _e483;
                            if _e489 {
                                phi_817_ = true;
                            } else {
                                phi_817_ = (_e491 > 0u);
                            }
                            let _e494 = phi_817_;
                            if _e494 {
                                let _e495 = (_e487 > 0u);
                                if _e495 {
                                    if _e489 {
                                        phi_847_ = _e485;
                                        phi_848_ = _e489;
                                        phi_849_ = _e491;
                                    } else {
                                        let _e496 = (_e491 - 1u);
                                        let _e497 = (_e496 % 128u);
                                        let _e498 = (_e497 < 128u);
                                        if _e498 {
                                        } else {
                                            phi_2606_ = true;
                                            break;
                                        }
                                        let _e500 = local[_e497];
                                        if _e498 {
                                        } else {
                                            phi_2606_ = true;
                                            break;
                                        }
                                        let _e502 = local_1[_e497];
                                        phi_847_ = _e500;
                                        phi_848_ = (_e502 <= _e483.member);
                                        phi_849_ = _e496;
                                    }
                                    let _e506 = phi_847_;
                                    let _e508 = phi_848_;
                                    let _e510 = phi_849_;
                                    if _e508 {
                                        let _e514 = (_e506 & 268435455u);
                                        if ((_e506 & 2147483648u) != 0u) {
                                            phi_865_ = _e483;
                                            phi_868_ = type_8(_e514, (_e514 + ((_e506 >> bitcast<u32>(28u)) & 7u)));
                                            loop {
                                                let _e709 = phi_865_;
                                                let _e711 = phi_868_;
                                                local_2 = _e709;
                                                local_4 = _e709;
                                                if (_e711.member < _e711.member_1) {
                                                    phi_869_ = type_8((_e711.member + 1u), _e711.member_1);
                                                    phi_891_ = type_8(1u, _e711.member);
                                                } else {
                                                    phi_869_ = _e711;
                                                    phi_891_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e724 = phi_869_;
                                                let _e726 = phi_891_;
                                                let _e730 = (bitcast<i32>(_e726.member) != 0i);
                                                if _e730 {
                                                    let _e731 = (_e726.member_1 < _e77);
                                                    if _e731 {
                                                        if _e731 {
                                                        } else {
                                                            phi_2480_ = true;
                                                            break;
                                                        }
                                                        let _e735 = global_4.member[_e726.member_1].member_1;
                                                        phi_911_ = _e735;
                                                    } else {
                                                        phi_911_ = 4294967295u;
                                                    }
                                                    let _e737 = phi_911_;
                                                    let _e738 = (_e726.member_1 >= _e77);
                                                    if _e738 {
                                                        phi_999_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e731 {
                                                        } else {
                                                            phi_2480_ = true;
                                                            break;
                                                        }
                                                        let _e739 = (_e299 % 3u);
                                                        let _e740 = (_e298 % 3u);
                                                        let _e741 = (_e300 % 3u);
                                                        if (_e739 < 9u) {
                                                        } else {
                                                            phi_2480_ = true;
                                                            break;
                                                        }
                                                        let _e747 = global_4.member[_e726.member_1].member[_e739];
                                                        if (_e740 < 9u) {
                                                        } else {
                                                            phi_2480_ = true;
                                                            break;
                                                        }
                                                        let _e753 = global_4.member[_e726.member_1].member[_e740];
                                                        if (_e741 < 9u) {
                                                        } else {
                                                            phi_2480_ = true;
                                                            break;
                                                        }
                                                        let _e759 = global_4.member[_e726.member_1].member[_e741];
                                                        let _e761 = (3u + _e739);
                                                        if (_e761 < 9u) {
                                                        } else {
                                                            phi_2480_ = true;
                                                            break;
                                                        }
                                                        let _e767 = global_4.member[_e726.member_1].member[_e761];
                                                        let _e768 = (3u + _e740);
                                                        if (_e768 < 9u) {
                                                        } else {
                                                            phi_2480_ = true;
                                                            break;
                                                        }
                                                        let _e774 = global_4.member[_e726.member_1].member[_e768];
                                                        let _e775 = (3u + _e741);
                                                        if (_e775 < 9u) {
                                                        } else {
                                                            phi_2480_ = true;
                                                            break;
                                                        }
                                                        let _e781 = global_4.member[_e726.member_1].member[_e775];
                                                        let _e783 = (6u + _e739);
                                                        if (_e783 < 9u) {
                                                        } else {
                                                            phi_2480_ = true;
                                                            break;
                                                        }
                                                        let _e789 = global_4.member[_e726.member_1].member[_e783];
                                                        let _e790 = (6u + _e740);
                                                        if (_e790 < 9u) {
                                                        } else {
                                                            phi_2480_ = true;
                                                            break;
                                                        }
                                                        let _e796 = global_4.member[_e726.member_1].member[_e790];
                                                        let _e797 = (6u + _e741);
                                                        if (_e797 < 9u) {
                                                        } else {
                                                            phi_2480_ = true;
                                                            break;
                                                        }
                                                        let _e803 = global_4.member[_e726.member_1].member[_e797];
                                                        phi_999_ = array<array<f32, 3>, 3>(array<f32, 3>(_e747, _e753, _e759), array<f32, 3>(_e767, _e774, _e781), array<f32, 3>(_e789, _e796, _e803));
                                                    }
                                                    let _e807 = phi_999_;
                                                    let _e815 = (_e807[0][2] - _e400);
                                                    let _e818 = (((_e807[0][0] - _e327) * _e424) - (_e815 * _e352));
                                                    let _e821 = (((_e807[0][1] - _e364) * _e424) - (_e815 * _e388));
                                                    let _e828 = (_e807[1][2] - _e400);
                                                    let _e831 = (((_e807[1][0] - _e327) * _e424) - (_e828 * _e352));
                                                    let _e834 = (((_e807[1][1] - _e364) * _e424) - (_e828 * _e388));
                                                    let _e841 = (_e807[2][2] - _e400);
                                                    let _e844 = (((_e807[2][0] - _e327) * _e424) - (_e841 * _e352));
                                                    let _e847 = (((_e807[2][1] - _e364) * _e424) - (_e841 * _e388));
                                                    let _e848 = (_e844 * _e834);
                                                    let _e849 = (_e847 * _e831);
                                                    let _e850 = (_e818 * _e847);
                                                    let _e851 = (_e821 * _e844);
                                                    let _e852 = (_e831 * _e821);
                                                    let _e853 = (_e834 * _e818);
                                                    let _e858 = (((_e848 >= _e849) && (_e850 >= _e851)) && (_e852 >= _e853));
                                                    if (_e858 || (((_e848 <= _e849) && (_e850 <= _e851)) && (_e852 <= _e853))) {
                                                        let _e865 = select(-1f, 1f, _e858);
                                                        let _e867 = ((_e848 - _e849) * _e865);
                                                        let _e869 = select(0f, _e867, (_e867 > 0f));
                                                        let _e871 = ((_e850 - _e851) * _e865);
                                                        let _e873 = select(0f, _e871, (_e871 > 0f));
                                                        let _e875 = ((_e852 - _e853) * _e865);
                                                        let _e877 = select(0f, _e875, (_e875 > 0f));
                                                        let _e879 = ((_e869 + _e873) + _e877);
                                                        if (_e879 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1565_ = type_28();
                                                            phi_1566_ = true;
                                                        } else {
                                                            let _e882 = select(_e807[1][0], _e807[0][0], (_e807[0][0] < _e807[1][0]));
                                                            let _e886 = select(_e807[1][0], _e807[0][0], (_e807[0][0] > _e807[1][0]));
                                                            let _e890 = select(_e807[1][1], _e807[0][1], (_e807[0][1] < _e807[1][1]));
                                                            let _e894 = select(_e807[1][1], _e807[0][1], (_e807[0][1] > _e807[1][1]));
                                                            let _e898 = select(_e807[1][2], _e807[0][2], (_e807[0][2] < _e807[1][2]));
                                                            let _e902 = select(_e807[1][2], _e807[0][2], (_e807[0][2] > _e807[1][2]));
                                                            let _e907 = ((select(_e807[2][0], _e882, (_e882 < _e807[2][0])) - _e350) * _e355);
                                                            let _e908 = ((select(_e807[2][0], _e886, (_e886 > _e807[2][0])) - _e351) * _e355);
                                                            let _e911 = ((select(_e807[2][1], _e890, (_e890 < _e807[2][1])) - _e386) * _e391);
                                                            let _e912 = ((select(_e807[2][1], _e894, (_e894 > _e807[2][1])) - _e387) * _e391);
                                                            let _e915 = ((select(_e807[2][2], _e898, (_e898 < _e807[2][2])) - _e422) * _e427);
                                                            let _e916 = ((select(_e807[2][2], _e902, (_e902 > _e807[2][2])) - _e423) * _e427);
                                                            let _e918 = select(_e916, _e915, (_e915 < _e916));
                                                            let _e920 = select(_e916, _e915, (_e915 > _e916));
                                                            let _e922 = select(_e908, _e907, (_e907 < _e908));
                                                            let _e924 = select(_e912, _e911, (_e911 < _e912));
                                                            let _e926 = select(_e924, _e922, (_e922 > _e924));
                                                            let _e928 = select(_e918, _e926, (_e926 > _e918));
                                                            let _e930 = select(_e908, _e907, (_e907 > _e908));
                                                            let _e932 = select(_e912, _e911, (_e911 > _e912));
                                                            let _e934 = select(_e932, _e930, (_e930 < _e932));
                                                            let _e936 = select(_e920, _e934, (_e934 < _e920));
                                                            let _e937 = -(_e918);
                                                            let _e943 = select(_e473, _e928, (_e928 > _e473));
                                                            if (_e943 > (_e936 + (select(_e937, _e920, (_e920 > _e937)) * 0.0000019073523f))) {
                                                                phi_1560_ = type_28();
                                                                phi_1561_ = true;
                                                            } else {
                                                                let _e945 = (_e943 > _e709.member);
                                                                if _e945 {
                                                                    phi_1559_ = type_28();
                                                                } else {
                                                                    let _e949 = (_e807[1][0] - _e807[0][0]);
                                                                    let _e950 = (_e807[1][1] - _e807[0][1]);
                                                                    let _e951 = (_e807[1][2] - _e807[0][2]);
                                                                    let _e952 = vec3<f32>(_e949, _e950, _e951);
                                                                    let _e953 = (_e807[2][0] - _e807[1][0]);
                                                                    let _e954 = (_e807[2][1] - _e807[1][1]);
                                                                    let _e955 = (_e807[2][2] - _e807[1][2]);
                                                                    let _e956 = vec3<f32>(_e953, _e954, _e955);
                                                                    let _e957 = (_e807[0][0] - _e807[2][0]);
                                                                    let _e958 = (_e807[0][1] - _e807[2][1]);
                                                                    let _e959 = (_e807[0][2] - _e807[2][2]);
                                                                    let _e960 = vec3<f32>(_e957, _e958, _e959);
                                                                    let _e963 = bitcast<f32>((bitcast<u32>(_e949) & 2147483647u));
                                                                    let _e966 = bitcast<f32>((bitcast<u32>(_e950) & 2147483647u));
                                                                    let _e968 = select(_e966, _e963, (_e963 > _e966));
                                                                    let _e971 = bitcast<f32>((bitcast<u32>(_e951) & 2147483647u));
                                                                    let _e973 = select(_e971, _e968, (_e968 > _e971));
                                                                    let _e976 = bitcast<f32>((bitcast<u32>(_e953) & 2147483647u));
                                                                    let _e979 = bitcast<f32>((bitcast<u32>(_e954) & 2147483647u));
                                                                    let _e981 = select(_e979, _e976, (_e976 > _e979));
                                                                    let _e984 = bitcast<f32>((bitcast<u32>(_e955) & 2147483647u));
                                                                    let _e986 = select(_e984, _e981, (_e981 > _e984));
                                                                    let _e989 = bitcast<f32>((bitcast<u32>(_e957) & 2147483647u));
                                                                    let _e992 = bitcast<f32>((bitcast<u32>(_e958) & 2147483647u));
                                                                    let _e994 = select(_e992, _e989, (_e989 > _e992));
                                                                    let _e997 = bitcast<f32>((bitcast<u32>(_e959) & 2147483647u));
                                                                    let _e999 = select(_e997, _e994, (_e994 > _e997));
                                                                    let _e1001 = select(_e986, _e973, (_e973 > _e986));
                                                                    let _e1003 = select(_e999, _e1001, (_e1001 > _e999));
                                                                    if (_e973 == _e1003) {
                                                                        phi_1470_ = _e956;
                                                                        phi_1471_ = _e960;
                                                                    } else {
                                                                        let _e1006 = vec3((_e986 == _e1003));
                                                                        phi_1470_ = select(_e952, _e960, _e1006);
                                                                        phi_1471_ = select(_e956, _e952, _e1006);
                                                                    }
                                                                    let _e1010 = phi_1470_;
                                                                    let _e1012 = phi_1471_;
                                                                    let _e1019 = ((_e1010.y * _e1012.z) - (_e1012.y * _e1010.z));
                                                                    let _e1024 = ((_e1010.z * _e1012.x) - (_e1012.z * _e1010.x));
                                                                    let _e1027 = ((_e1010.x * _e1012.y) - (_e1012.x * _e1010.y));
                                                                    if (_e869 >= _e873) {
                                                                        phi_1502_ = select(true, false, (_e869 >= _e877));
                                                                    } else {
                                                                        phi_1502_ = true;
                                                                    }
                                                                    let _e1032 = phi_1502_;
                                                                    if _e1032 {
                                                                        phi_1511_ = select(vec3<f32>(_e807[2][0], _e807[2][1], _e807[2][2]), vec3<f32>(_e807[1][0], _e807[1][1], _e807[1][2]), vec3((_e873 >= _e877)));
                                                                    } else {
                                                                        phi_1511_ = vec3<f32>(_e807[0][0], _e807[0][1], _e807[0][2]);
                                                                    }
                                                                    let _e1037 = phi_1511_;
                                                                    let _e1054 = ((((_e1019 * (_e1037.x - _e327)) + (_e1024 * (_e1037.y - _e364))) + (_e1027 * (_e1037.z - _e400))) / (((_e1019 * _e352) + (_e1024 * _e388)) + (_e1027 * _e424)));
                                                                    let _e1056 = select(_e936, _e1054, (_e1054 < _e936));
                                                                    let _e1058 = select(_e928, _e1056, (_e1056 > _e928));
                                                                    if (_e1058 >= _e473) {
                                                                        let _e1060 = (_e1058 <= _e709.member);
                                                                        if _e1060 {
                                                                            let _e1061 = (1f / _e879);
                                                                            phi_1551_ = type_28(_e1058, (_e873 * _e1061), (_e877 * _e1061), _e737);
                                                                        } else {
                                                                            phi_1551_ = type_28();
                                                                        }
                                                                        let _e1066 = phi_1551_;
                                                                        phi_1553_ = _e1066;
                                                                        phi_1554_ = select(true, false, _e1060);
                                                                    } else {
                                                                        phi_1553_ = type_28();
                                                                        phi_1554_ = true;
                                                                    }
                                                                    let _e1069 = phi_1553_;
                                                                    let _e1071 = phi_1554_;
                                                                    if _e1071 {
                                                                        phi_1558_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_1558_ = _e1069;
                                                                    }
                                                                    let _e1073 = phi_1558_;
                                                                    phi_1559_ = _e1073;
                                                                }
                                                                let _e1075 = phi_1559_;
                                                                phi_1560_ = _e1075;
                                                                phi_1561_ = _e945;
                                                            }
                                                            let _e1077 = phi_1560_;
                                                            let _e1079 = phi_1561_;
                                                            phi_1565_ = _e1077;
                                                            phi_1566_ = _e1079;
                                                        }
                                                        let _e1081 = phi_1565_;
                                                        let _e1083 = phi_1566_;
                                                        phi_1570_ = _e1081;
                                                        phi_1571_ = _e1083;
                                                    } else {
                                                        phi_1570_ = type_28();
                                                        phi_1571_ = true;
                                                    }
                                                    let _e1085 = phi_1570_;
                                                    let _e1087 = phi_1571_;
                                                    if _e1087 {
                                                        phi_1575_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1575_ = _e1085;
                                                    }
                                                    let _e1089 = phi_1575_;
                                                    if (_e1089.member_3 != 4294967295u) {
                                                        if (_e737 == _e188) {
                                                            phi_1943_ = false;
                                                        } else {
                                                            let _e1093 = (_e737 < arrayLength((&global_5.member)));
                                                            if _e1093 {
                                                                if _e1093 {
                                                                } else {
                                                                    phi_2480_ = true;
                                                                    break;
                                                                }
                                                                let _e1095 = global_5.member[_e737];
                                                                phi_1598_ = _e1095;
                                                            } else {
                                                                phi_1598_ = 4294967295u;
                                                            }
                                                            let _e1097 = phi_1598_;
                                                            let _e1098 = (_e1097 < arrayLength((&global_6.member)));
                                                            if _e1098 {
                                                                if _e1098 {
                                                                } else {
                                                                    phi_2480_ = true;
                                                                    break;
                                                                }
                                                                let _e1100 = global_6.member[_e1097];
                                                                phi_1612_ = _e1100;
                                                            } else {
                                                                phi_1612_ = 0i;
                                                            }
                                                            let _e1102 = phi_1612_;
                                                            let _e1103 = (_e1102 == 0i);
                                                            if _e1103 {
                                                                phi_1942_ = true;
                                                            } else {
                                                                if _e738 {
                                                                    phi_1704_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                                } else {
                                                                    if _e731 {
                                                                    } else {
                                                                        phi_2480_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1108 = global_4.member[_e726.member_1].member[0u];
                                                                    let _e1113 = global_4.member[_e726.member_1].member[1u];
                                                                    let _e1118 = global_4.member[_e726.member_1].member[2u];
                                                                    let _e1124 = global_4.member[_e726.member_1].member[3u];
                                                                    let _e1129 = global_4.member[_e726.member_1].member[4u];
                                                                    let _e1134 = global_4.member[_e726.member_1].member[5u];
                                                                    let _e1140 = global_4.member[_e726.member_1].member[6u];
                                                                    let _e1145 = global_4.member[_e726.member_1].member[7u];
                                                                    let _e1150 = global_4.member[_e726.member_1].member[8u];
                                                                    phi_1704_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1108, _e1113, _e1118), array<f32, 3>(_e1124, _e1129, _e1134), array<f32, 3>(_e1140, _e1145, _e1150));
                                                                }
                                                                let _e1154 = phi_1704_;
                                                                let _e1167 = (_e1154[1][0] - _e1154[0][0]);
                                                                let _e1168 = (_e1154[1][1] - _e1154[0][1]);
                                                                let _e1169 = (_e1154[1][2] - _e1154[0][2]);
                                                                let _e1170 = (_e1154[2][0] - _e1154[0][0]);
                                                                let _e1171 = (_e1154[2][1] - _e1154[0][1]);
                                                                let _e1172 = (_e1154[2][2] - _e1154[0][2]);
                                                                if (_e184.member_1 == 1u) {
                                                                    phi_1742_ = vec3<f32>((_e184.member[0] - _e1154[0][0]), (_e184.member[1] - _e1154[0][1]), (_e184.member[2] - _e1154[0][2]));
                                                                } else {
                                                                    phi_1742_ = vec3<f32>(_e184.member[0], _e184.member[1], _e184.member[2]);
                                                                }
                                                                let _e1189 = phi_1742_;
                                                                let _e1195 = bitcast<f32>((bitcast<u32>((_e1167 * _e1171)) ^ _e184.member_3[0]));
                                                                let _e1199 = bitcast<f32>((bitcast<u32>((_e1168 * _e1170)) ^ _e184.member_3[0]));
                                                                let _e1203 = bitcast<f32>((bitcast<u32>((_e1168 * _e1172)) ^ _e184.member_3[0]));
                                                                let _e1207 = bitcast<f32>((bitcast<u32>((_e1169 * _e1171)) ^ _e184.member_3[0]));
                                                                let _e1211 = bitcast<f32>((bitcast<u32>((_e1169 * _e1170)) ^ _e184.member_3[0]));
                                                                let _e1215 = bitcast<f32>((bitcast<u32>((_e1167 * _e1172)) ^ _e184.member_3[0]));
                                                                let _e1216 = (_e1203 - _e1207);
                                                                let _e1217 = (_e1211 - _e1215);
                                                                let _e1218 = (_e1195 - _e1199);
                                                                let _e1242 = (bitcast<f32>((bitcast<u32>(_e1203) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1207) & 2147483647u)));
                                                                let _e1249 = (bitcast<f32>((bitcast<u32>(_e1211) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1215) & 2147483647u)));
                                                                let _e1256 = (bitcast<f32>((bitcast<u32>(_e1195) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1199) & 2147483647u)));
                                                                if (_e184.member_2 == 0f) {
                                                                    phi_1924_ = 0f;
                                                                } else {
                                                                    let _e1286 = bitcast<f32>((bitcast<u32>(_e1216) & 2147483647u));
                                                                    let _e1289 = bitcast<f32>((bitcast<u32>(_e1217) & 2147483647u));
                                                                    let _e1292 = bitcast<f32>((bitcast<u32>(_e1218) & 2147483647u));
                                                                    let _e1294 = select(_e1292, _e1289, (_e1289 > _e1292));
                                                                    let _e1298 = select(_e1292, _e1289, (_e1289 < _e1292));
                                                                    let _e1302 = select(_e1289, _e1286, (_e1286 < _e1289));
                                                                    let _e1304 = select(_e1289, _e1286, (_e1286 > _e1289));
                                                                    let _e1306 = select(_e1292, _e1304, (_e1304 < _e1292));
                                                                    phi_1924_ = bitcast<f32>((bitcast<u32>((_e184.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1294, _e1286, (_e1286 > _e1294)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1306, _e1302, (_e1302 > _e1306)))) ^ _e184.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1298, _e1286, (_e1286 < _e1298)))) ^ _e184.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1242 + _e1249) + _e1256))) ^ _e184.member_3[0]))) * 1.0000005f)) ^ _e184.member_3[0])))) ^ _e184.member_3[0]));
                                                                }
                                                                let _e1333 = phi_1924_;
                                                                phi_1942_ = (_e1103 || !(((((bitcast<f32>((bitcast<u32>((_e1189.x * _e1216)) ^ _e184.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1189.y * _e1217)) ^ _e184.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1189.z * _e1218)) ^ _e184.member_3[0]))) * f32(-(_e1102))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1189.x) & 2147483647u)) * _e1242)) ^ _e184.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1189.y) & 2147483647u)) * _e1249)) ^ _e184.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1189.z) & 2147483647u)) * _e1256)) ^ _e184.member_3[0]))))) ^ _e184.member_3[0])) + _e1333) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1347 = phi_1942_;
                                                            phi_1943_ = _e1347;
                                                        }
                                                        let _e1349 = phi_1943_;
                                                        if _e1349 {
                                                            phi_1948_ = type_55(_e709.member, true);
                                                        } else {
                                                            phi_1948_ = _e709;
                                                        }
                                                        let _e1354 = phi_1948_;
                                                        phi_1949_ = _e1354;
                                                    } else {
                                                        phi_1949_ = _e709;
                                                    }
                                                    let _e1356 = phi_1949_;
                                                    phi_866_ = _e1356;
                                                } else {
                                                    phi_866_ = type_55();
                                                }
                                                let _e1358 = phi_866_;
                                                continue;
                                                continuing {
                                                    phi_865_ = _e1358;
                                                    phi_868_ = _e724;
                                                    phi_2480_ = _e481;
                                                    break if !(_e730);
                                                }
                                            }
                                            let _e1361 = phi_2480_;
                                            phi_2606_ = _e1361;
                                            if _e1361 {
                                                break;
                                            }
                                            let _e1363 = local_2;
                                            phi_2610_ = _e1361;
                                            let _e1535 = local_4;
                                            phi_2403_ = _e1535;
                                            phi_2404_ = _e506;
                                            phi_2405_ = false;
                                            phi_2406_ = select(_e510, 0u, _e1363.member_1);
                                        } else {
                                            if (_e506 >= _e75) {
                                                phi_2010_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                            } else {
                                                if (_e506 < _e75) {
                                                } else {
                                                    phi_2606_ = true;
                                                    break;
                                                }
                                                let _e520 = (_e299 % 3u);
                                                if (_e520 < 3u) {
                                                } else {
                                                    phi_2606_ = true;
                                                    break;
                                                }
                                                let _e526 = global_3.member[_e506].member[_e520];
                                                let _e532 = (_e298 % 3u);
                                                if (_e532 < 3u) {
                                                } else {
                                                    phi_2606_ = true;
                                                    break;
                                                }
                                                let _e538 = global_3.member[_e506].member[_e532];
                                                let _e544 = (_e300 % 3u);
                                                if (_e544 < 3u) {
                                                } else {
                                                    phi_2606_ = true;
                                                    break;
                                                }
                                                let _e550 = global_3.member[_e506].member[_e544];
                                                let _e560 = global_3.member[_e506].member_1;
                                                let _e564 = global_3.member[_e506].member_2;
                                                phi_2010_ = type_54(array<vec4<f32>, 3>(vec4<f32>(_e526[0], _e526[1], _e526[2], _e526[3]), vec4<f32>(_e538[0], _e538[1], _e538[2], _e538[3]), vec4<f32>(_e550[0], _e550[1], _e550[2], _e550[3])), _e560, _e564);
                                            }
                                            let _e567 = phi_2010_;
                                            let _e579 = ((_e567.member[0].x - _e350) * _e355);
                                            let _e580 = ((_e567.member[0].y - _e350) * _e355);
                                            let _e581 = ((_e567.member[0].z - _e351) * _e355);
                                            let _e582 = ((_e567.member[0].w - _e351) * _e355);
                                            let _e592 = ((_e567.member[1].x - _e386) * _e391);
                                            let _e593 = ((_e567.member[1].y - _e386) * _e391);
                                            let _e594 = ((_e567.member[1].z - _e387) * _e391);
                                            let _e595 = ((_e567.member[1].w - _e387) * _e391);
                                            let _e605 = ((_e567.member[2].x - _e422) * _e427);
                                            let _e606 = ((_e567.member[2].y - _e422) * _e427);
                                            let _e607 = ((_e567.member[2].z - _e423) * _e427);
                                            let _e608 = ((_e567.member[2].w - _e423) * _e427);
                                            let _e610 = select(_e607, _e605, (_e605 < _e607));
                                            let _e612 = select(_e608, _e606, (_e606 < _e608));
                                            let _e614 = select(_e607, _e605, (_e605 > _e607));
                                            let _e616 = select(_e608, _e606, (_e606 > _e608));
                                            let _e618 = select(_e581, _e579, (_e579 < _e581));
                                            let _e620 = select(_e582, _e580, (_e580 < _e582));
                                            let _e622 = select(_e594, _e592, (_e592 < _e594));
                                            let _e624 = select(_e595, _e593, (_e593 < _e595));
                                            let _e626 = select(_e622, _e618, (_e618 > _e622));
                                            let _e628 = select(_e624, _e620, (_e620 > _e624));
                                            let _e630 = select(_e610, _e626, (_e626 > _e610));
                                            let _e632 = select(_e612, _e628, (_e628 > _e612));
                                            let _e634 = select(_e581, _e579, (_e579 > _e581));
                                            let _e636 = select(_e582, _e580, (_e580 > _e582));
                                            let _e638 = select(_e594, _e592, (_e592 > _e594));
                                            let _e640 = select(_e595, _e593, (_e593 > _e595));
                                            let _e642 = select(_e638, _e634, (_e634 < _e638));
                                            let _e644 = select(_e640, _e636, (_e636 < _e640));
                                            let _e649 = -(_e610);
                                            let _e650 = -(_e612);
                                            let _e657 = (select(_e614, _e642, (_e642 < _e614)) + (select(_e649, _e614, (_e614 > _e649)) * 0.0000019073523f));
                                            let _e658 = (select(_e616, _e644, (_e644 < _e616)) + (select(_e650, _e616, (_e616 > _e650)) * 0.0000019073523f));
                                            let _e660 = select(_e473, _e630, (_e630 > _e473));
                                            let _e662 = select(_e473, _e632, (_e632 > _e473));
                                            let _e667 = (_e660 <= select(_e483.member, _e657, (_e657 < _e483.member)));
                                            let _e668 = (_e662 <= select(_e483.member, _e658, (_e658 < _e483.member)));
                                            let _e669 = (_e660 <= _e662);
                                            if _e667 {
                                                if _e668 {
                                                    if _e669 {
                                                        phi_2354_ = _e567.member_2;
                                                    } else {
                                                        phi_2354_ = _e567.member_1;
                                                    }
                                                    let _e673 = phi_2354_;
                                                    let _e674 = (_e510 % 128u);
                                                    let _e675 = (_e674 < 128u);
                                                    if _e675 {
                                                    } else {
                                                        phi_2606_ = true;
                                                        break;
                                                    }
                                                    local[_e674] = _e673;
                                                    if _e675 {
                                                    } else {
                                                        phi_2606_ = true;
                                                        break;
                                                    }
                                                    local_1[_e674] = select(_e662, _e660, (_e660 > _e662));
                                                    if _e669 {
                                                        phi_2380_ = _e567.member_1;
                                                    } else {
                                                        phi_2380_ = _e567.member_2;
                                                    }
                                                    let _e684 = phi_2380_;
                                                    phi_2381_ = _e684;
                                                    phi_2382_ = (_e510 + 1u);
                                                } else {
                                                    phi_2381_ = u32();
                                                    phi_2382_ = u32();
                                                }
                                                let _e686 = phi_2381_;
                                                let _e688 = phi_2382_;
                                                phi_2384_ = _e686;
                                                phi_2385_ = _e688;
                                                phi_2386_ = select(true, false, _e668);
                                            } else {
                                                phi_2384_ = u32();
                                                phi_2385_ = u32();
                                                phi_2386_ = true;
                                            }
                                            let _e691 = phi_2384_;
                                            let _e693 = phi_2385_;
                                            let _e695 = phi_2386_;
                                            if _e695 {
                                                if _e667 {
                                                    phi_2395_ = _e567.member_1;
                                                } else {
                                                    phi_2395_ = _e567.member_2;
                                                }
                                                let _e699 = phi_2395_;
                                                phi_2400_ = _e699;
                                                phi_2401_ = select(_e668, true, _e667);
                                            } else {
                                                phi_2400_ = _e691;
                                                phi_2401_ = _e508;
                                            }
                                            let _e702 = phi_2400_;
                                            let _e704 = phi_2401_;
                                            phi_2610_ = _e481;
                                            phi_2403_ = _e483;
                                            phi_2404_ = _e702;
                                            phi_2405_ = _e704;
                                            phi_2406_ = select(_e693, _e510, _e695);
                                        }
                                        let _e1367 = phi_2610_;
                                        let _e1369 = phi_2403_;
                                        let _e1371 = phi_2404_;
                                        let _e1373 = phi_2405_;
                                        let _e1375 = phi_2406_;
                                        phi_2609_ = _e1367;
                                        phi_2407_ = _e1369;
                                        phi_2408_ = _e1371;
                                        phi_2409_ = (_e487 - 1u);
                                        phi_2410_ = _e1373;
                                        phi_2411_ = _e1375;
                                    } else {
                                        phi_2609_ = _e481;
                                        phi_2407_ = _e483;
                                        phi_2408_ = _e506;
                                        phi_2409_ = _e487;
                                        phi_2410_ = _e508;
                                        phi_2411_ = _e510;
                                    }
                                    let _e1377 = phi_2609_;
                                    let _e1379 = phi_2407_;
                                    let _e1381 = phi_2408_;
                                    let _e1383 = phi_2409_;
                                    let _e1385 = phi_2410_;
                                    let _e1387 = phi_2411_;
                                    phi_2608_ = _e1377;
                                    phi_2412_ = _e1379;
                                    phi_2413_ = _e1381;
                                    phi_2414_ = _e1383;
                                    phi_2415_ = _e1385;
                                    phi_2416_ = _e1387;
                                } else {
                                    phi_2608_ = _e481;
                                    phi_2412_ = type_55();
                                    phi_2413_ = u32();
                                    phi_2414_ = u32();
                                    phi_2415_ = bool();
                                    phi_2416_ = u32();
                                }
                                let _e1389 = phi_2608_;
                                let _e1391 = phi_2412_;
                                let _e1393 = phi_2413_;
                                let _e1395 = phi_2414_;
                                let _e1397 = phi_2415_;
                                let _e1399 = phi_2416_;
                                phi_2607_ = _e1389;
                                phi_798_ = _e1391;
                                phi_801_ = _e1393;
                                phi_803_ = _e1395;
                                phi_805_ = _e1397;
                                phi_807_ = _e1399;
                                phi_2417_ = _e495;
                            } else {
                                phi_2607_ = _e481;
                                phi_798_ = type_55();
                                phi_801_ = u32();
                                phi_803_ = u32();
                                phi_805_ = bool();
                                phi_807_ = u32();
                                phi_2417_ = false;
                            }
                            let _e1401 = phi_2607_;
                            let _e1403 = phi_798_;
                            let _e1405 = phi_801_;
                            let _e1407 = phi_803_;
                            let _e1409 = phi_805_;
                            let _e1411 = phi_807_;
                            let _e1413 = phi_2417_;
                            continue;
                            continuing {
                                phi_2486_ = _e1401;
                                phi_797_ = _e1403;
                                phi_800_ = _e1405;
                                phi_802_ = _e1407;
                                phi_804_ = _e1409;
                                phi_806_ = _e1411;
                                phi_2606_ = _e1401;
                                break if !(_e1413);
                            }
                        }
                        let _e1416 = phi_2606_;
                        if _e1416 {
                            break;
                        }
                        let _e1418 = local_3;
                        if _e1418.member_1 {
                        } else {
                            if _e95 {
                            } else {
                                break;
                            }
                            let _e1422 = global_9.member[_e93];
                            if _e94 {
                            } else {
                                break;
                            }
                            let _e1426 = global_8.member[_e93].member_1;
                            if _e95 {
                            } else {
                                break;
                            }
                            global_9.member[_e93] = type_30(_e1422.member, _e1422.member_1, _e1422.member_2, array<f32, 3>((_e1422.member_3[0] + (_e1426[0] * _e1422.member_1[0])), (_e1422.member_3[1] + (_e1426[1] * _e1422.member_1[1])), (_e1422.member_3[2] + (_e1426[2] * _e1422.member_1[2]))), _e1422.member_4);
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
fn trace_shadows_facing(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
