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

struct type_21 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_22 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_23 {
    member: type_22,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_25 {
    member: array<type_23>,
}

struct type_30 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_31 {
    member: type_22,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_33 {
    member: array<type_31>,
}

struct type_36 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_42 {
    member: f32,
    member_1: bool,
}

struct type_44 {
    member: array<vec4<u32>, 2>,
}

struct type_47 {
    member: array<i32>,
}

struct type_53 {
    member: array<array<u32, 7>>,
}

struct type_58 {
    member: type_30,
    member_1: u32,
}

struct type_59 {
    member: array<vec4<f32>, 3>,
    member_1: type_58,
    member_2: type_58,
}

struct type_64 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_25;
@group(0) @binding(1) 
var<uniform> global_3: type_44;
@group(0) @binding(2) 
var<uniform> global_4: type_44;
@group(0) @binding(5) 
var<storage> global_5: type_4;
@group(0) @binding(6) 
var<storage> global_6: type_47;
@group(0) @binding(9) 
var<storage, read_write> global_7: type_64;
@group(0) @binding(3) 
var<storage> global_8: type_53;
@group(0) @binding(7) 
var<storage> global_9: type_33;
@group(0) @binding(4) 
var<storage> global_10: type_4;

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
    var phi_328_: u32;
    var phi_372_: i32;
    var phi_396_: type_36;
    var phi_546_: i32;
    var phi_547_: i32;
    var phi_557_: bool;
    var phi_567_: u32;
    var phi_568_: u32;
    var phi_570_: bool;
    var phi_575_: u32;
    var phi_607_: i32;
    var phi_625_: f32;
    var phi_631_: f32;
    var phi_642_: f32;
    var phi_648_: f32;
    var phi_671_: f32;
    var phi_682_: f32;
    var phi_691_: f32;
    var phi_697_: f32;
    var phi_708_: f32;
    var phi_714_: f32;
    var phi_737_: f32;
    var phi_748_: f32;
    var phi_757_: f32;
    var phi_763_: f32;
    var phi_774_: f32;
    var phi_780_: f32;
    var phi_803_: f32;
    var phi_814_: f32;
    var phi_914_: f32;
    var phi_915_: f32;
    var phi_4266_: bool;
    var phi_1004_: type_42;
    var phi_1007_: type_58;
    var phi_1009_: u32;
    var phi_1011_: bool;
    var phi_1013_: u32;
    var phi_1024_: bool;
    var phi_1110_: type_58;
    var phi_1111_: bool;
    var phi_1112_: u32;
    var phi_3259_: u32;
    var phi_3265_: u32;
    var phi_3519_: u32;
    var phi_3520_: u32;
    var phi_3530_: u32;
    var phi_3532_: u32;
    var phi_3533_: bool;
    var phi_3553_: u32;
    var phi_3554_: u32;
    var phi_3558_: type_59;
    var phi_3902_: type_58;
    var phi_3979_: type_58;
    var phi_3980_: type_58;
    var phi_3981_: u32;
    var phi_3983_: type_58;
    var phi_3984_: u32;
    var phi_3985_: bool;
    var phi_3994_: type_58;
    var phi_3999_: type_58;
    var phi_4000_: bool;
    var phi_1131_: type_42;
    var phi_1134_: type_8;
    var phi_1135_: type_8;
    var phi_1157_: type_8;
    var phi_1198_: u32;
    var phi_1204_: u32;
    var phi_1214_: u32;
    var phi_1230_: u32;
    var phi_1263_: u32;
    var phi_1269_: u32;
    var phi_1696_: u32;
    var phi_1714_: u32;
    var phi_1732_: u32;
    var phi_1752_: u32;
    var phi_1770_: u32;
    var phi_1788_: u32;
    var phi_1808_: u32;
    var phi_1826_: u32;
    var phi_1844_: u32;
    var phi_1422_: u32;
    var phi_1437_: u32;
    var phi_1447_: u32;
    var phi_1467_: u32;
    var phi_1487_: u32;
    var phi_1513_: u32;
    var phi_1528_: u32;
    var phi_1538_: u32;
    var phi_1558_: u32;
    var phi_1578_: u32;
    var phi_1604_: u32;
    var phi_1619_: u32;
    var phi_1629_: u32;
    var phi_1649_: u32;
    var phi_1669_: u32;
    var phi_1293_: u32;
    var phi_1336_: u32;
    var phi_1379_: u32;
    var phi_1850_: array<array<f32, 3>, 3>;
    var phi_2321_: vec3<f32>;
    var phi_2322_: vec3<f32>;
    var phi_2353_: bool;
    var phi_2362_: vec3<f32>;
    var phi_2402_: type_21;
    var phi_2404_: type_21;
    var phi_2405_: bool;
    var phi_2409_: type_21;
    var phi_2410_: type_21;
    var phi_2411_: type_21;
    var phi_2412_: bool;
    var phi_2416_: type_21;
    var phi_2417_: bool;
    var phi_2421_: type_21;
    var phi_2422_: bool;
    var phi_2426_: type_21;
    var phi_2449_: u32;
    var phi_2463_: i32;
    var phi_2483_: vec3<f32>;
    var phi_2484_: vec3<f32>;
    var phi_2500_: vec3<f32>;
    var phi_2501_: vec3<f32>;
    var phi_2517_: vec3<f32>;
    var phi_2518_: vec3<f32>;
    var phi_2554_: vec3<f32>;
    var phi_2736_: f32;
    var phi_2754_: bool;
    var phi_2755_: bool;
    var phi_2760_: type_42;
    var phi_2761_: type_42;
    var phi_1132_: type_42;
    var phi_4260_: bool;
    var local_10: type_42;
    var phi_4449_: bool;
    var phi_4002_: type_42;
    var phi_4003_: type_58;
    var phi_4004_: bool;
    var phi_4005_: u32;
    var phi_4448_: bool;
    var phi_4006_: type_42;
    var phi_4007_: type_58;
    var phi_4008_: u32;
    var phi_4009_: bool;
    var phi_4010_: u32;
    var phi_4447_: bool;
    var phi_4011_: type_42;
    var phi_4012_: type_58;
    var phi_4013_: u32;
    var phi_4014_: bool;
    var phi_4015_: u32;
    var phi_4446_: bool;
    var phi_1005_: type_42;
    var phi_1008_: type_58;
    var phi_1010_: u32;
    var phi_1012_: bool;
    var phi_1014_: u32;
    var phi_4016_: bool;
    var phi_4445_: bool;
    var local_11: type_42;
    var local_12: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e96 = global;
            let _e98 = arrayLength((&global_8.member));
            let _e101 = arrayLength((&global_10.member));
            let _e113 = arrayLength((&global_7.member));
            let _e117 = global_4.member[0u][0u];
            let _e121 = global_4.member[0u][1u];
            let _e125 = global_4.member[0u][2u];
            let _e129 = global_4.member[0u][3u];
            let _e133 = global_4.member[1u][0u];
            let _e137 = global_4.member[1u][1u];
            let _e141 = global_4.member[1u][2u];
            let _e145 = (_e96.x + (_e96.y * 2097152u));
            let _e157 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e129) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e117), bitcast<i32>(_e121), bitcast<i32>(_e125));
            local = array<i32, 3>(bitcast<i32>(_e133), bitcast<i32>(_e137), bitcast<i32>(_e141));
            let _e160 = (_e145 < arrayLength((&global_9.member)));
            if _e160 {
                if _e160 {
                } else {
                    break;
                }
                let _e164 = global_9.member[_e145].member_2;
                phi_328_ = _e164;
            } else {
                phi_328_ = 4294967295u;
            }
            let _e166 = phi_328_;
            let _e169 = global_1.member[0u];
            let _e173 = global_3.member[0u][0u];
            let _e177 = global_3.member[0u][1u];
            let _e181 = global_3.member[0u][2u];
            let _e185 = global_3.member[0u][3u];
            let _e189 = global_3.member[1u][0u];
            let _e193 = global_3.member[1u][1u];
            let _e197 = global_3.member[1u][2u];
            let _e201 = global_3.member[1u][3u];
            let _e202 = bitcast<f32>(_e173);
            let _e203 = bitcast<f32>(_e177);
            let _e204 = bitcast<f32>(_e181);
            let _e206 = bitcast<f32>(_e189);
            let _e207 = array<u32, 3>(_e193, _e197, _e201);
            let _e209 = bitcast<i32>(_e169);
            if (_e209 < -126i) {
                phi_372_ = -126i;
            } else {
                phi_372_ = select(_e209, 127i, (_e209 > 127i));
            }
            let _e214 = phi_372_;
            let _e219 = bitcast<f32>((bitcast<u32>((_e214 + 127i)) << bitcast<u32>(23i)));
            let _e225 = bitcast<f32>((bitcast<u32>(((_e209 - _e214) + 127i)) << bitcast<u32>(23i)));
            if (_e185 == 0u) {
                phi_396_ = type_36(array<f32, 3>(_e202, _e203, _e204), _e185, _e206, _e207);
            } else {
                phi_396_ = type_36(array<f32, 3>(((_e202 * _e219) * _e225), ((_e203 * _e219) * _e225), ((_e204 * _e219) * _e225)), _e185, ((_e206 * _e219) * _e225), _e207);
            }
            let _e238 = phi_396_;
            if _e160 {
                let _e239 = (_e145 < arrayLength((&global_2.member)));
                if _e239 {
                    if _e160 {
                    } else {
                        break;
                    }
                    let _e244 = global_9.member[_e145].member.member_1;
                    let _e249 = global_9.member[_e145].member.member_3;
                    if (_e244 <= _e249) {
                        let _e251 = (1u < _e113);
                        if _e251 {
                            if (0u < _e113) {
                            } else {
                                break;
                            }
                            let _e255 = atomicAdd((&global_7.member[0u]), 1u);
                            if ((_e255 + 1u) < _e255) {
                                if _e251 {
                                } else {
                                    break;
                                }
                                let _e260 = atomicAdd((&global_7.member[1u]), 1u);
                            }
                        }
                        if _e160 {
                        } else {
                            break;
                        }
                        let _e270 = global_9.member[_e145].member.member_2[0u];
                        let _e272 = (bitcast<u32>(_e270) & 2147483647u);
                        let _e278 = global_9.member[_e145].member.member_2[1u];
                        let _e280 = (bitcast<u32>(_e278) & 2147483647u);
                        let _e286 = global_9.member[_e145].member.member_2[2u];
                        let _e288 = (bitcast<u32>(_e286) & 2147483647u);
                        let _e294 = global_9.member[_e145].member.member[0u];
                        let _e296 = (bitcast<u32>(_e294) & 2147483647u);
                        let _e302 = global_9.member[_e145].member.member[1u];
                        let _e304 = (bitcast<u32>(_e302) & 2147483647u);
                        let _e310 = global_9.member[_e145].member.member[2u];
                        let _e312 = (bitcast<u32>(_e310) & 2147483647u);
                        let _e314 = select(_e280, _e272, (_e280 < _e272));
                        let _e316 = select(_e288, _e314, (_e288 < _e314));
                        let _e318 = select(_e296, _e316, (_e296 < _e316));
                        let _e320 = select(_e304, _e318, (_e304 < _e318));
                        let _e322 = select(_e312, _e320, (_e312 < _e320));
                        let _e324 = (bitcast<u32>(_e244) & 2147483647u);
                        let _e333 = (((select(_e324, _e322, (_e324 < _e322)) < 2139095040u) && ((bitcast<u32>(_e249) & 2147483647u) <= 2139095040u)) && (_e316 > 0u));
                        if _e333 {
                            let _e336 = (bitcast<u32>(bitcast<f32>(_e316)) & 2147483647u);
                            if (_e336 >= 8388608u) {
                                phi_546_ = (bitcast<i32>((_e336 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_546_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e336)), 32u, (_e336 == 0u))));
                            }
                            let _e350 = phi_546_;
                            phi_547_ = _e350;
                        } else {
                            phi_547_ = 0i;
                        }
                        let _e352 = phi_547_;
                        let _e353 = (_e272 == _e316);
                        if _e353 {
                            phi_557_ = true;
                        } else {
                            phi_557_ = (_e280 == _e316);
                        }
                        let _e356 = phi_557_;
                        let _e357 = select(1u, 0u, _e353);
                        if _e356 {
                            let _e358 = (_e357 + 1u);
                            phi_567_ = _e358;
                            phi_568_ = _e358;
                            phi_570_ = select(true, false, (_e358 == 2u));
                        } else {
                            phi_567_ = u32();
                            phi_568_ = 0u;
                            phi_570_ = true;
                        }
                        let _e362 = phi_567_;
                        let _e364 = phi_568_;
                        let _e366 = phi_570_;
                        if _e366 {
                            phi_575_ = (_e364 + 1u);
                        } else {
                            phi_575_ = 0u;
                        }
                        let _e370 = phi_575_;
                        let _e371 = select(_e362, _e364, _e366);
                        let _e372 = select(_e357, select(2u, _e357, _e356), _e366);
                        let _e373 = -(_e352);
                        if (_e373 < -126i) {
                            phi_607_ = -126i;
                        } else {
                            phi_607_ = select(_e373, 127i, (_e373 > 127i));
                        }
                        let _e378 = phi_607_;
                        let _e383 = bitcast<f32>((bitcast<u32>((_e378 + 127i)) << bitcast<u32>(23i)));
                        let _e389 = bitcast<f32>((bitcast<u32>(((_e373 - _e378) + 127i)) << bitcast<u32>(23i)));
                        let _e394 = global_9.member[_e145].member.member;
                        let _e395 = (_e371 == 0u);
                        if _e395 {
                            phi_625_ = _e394[0];
                        } else {
                            phi_625_ = _e394[1];
                        }
                        let _e399 = phi_625_;
                        let _e400 = (_e371 == 2u);
                        if _e400 {
                            phi_631_ = _e394[2];
                        } else {
                            phi_631_ = _e399;
                        }
                        let _e403 = phi_631_;
                        let _e404 = global_9.member[_e145].member.member_2;
                        if _e395 {
                            phi_642_ = _e404[0];
                        } else {
                            phi_642_ = _e404[1];
                        }
                        let _e408 = phi_642_;
                        if _e400 {
                            phi_648_ = _e404[2];
                        } else {
                            phi_648_ = _e408;
                        }
                        let _e411 = phi_648_;
                        let _e413 = ((_e411 * _e383) * _e389);
                        let _e417 = (bitcast<f32>((bitcast<u32>(_e413) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e417 {
                            let _e421 = (bitcast<f32>((bitcast<u32>(_e403) & 2147483647u)) * 0.00000011920929f);
                            phi_671_ = select(0.00000000000011368684f, _e421, (_e421 > 0.00000000000011368684f));
                        } else {
                            phi_671_ = 0f;
                        }
                        let _e425 = phi_671_;
                        let _e426 = (_e403 + _e425);
                        let _e427 = (_e403 - _e425);
                        let _e428 = select(_e413, 0f, _e417);
                        if _e417 {
                            phi_682_ = 38685626000000000000000000f;
                        } else {
                            phi_682_ = (1f / _e413);
                        }
                        let _e431 = phi_682_;
                        let _e432 = (_e370 == 0u);
                        if _e432 {
                            phi_691_ = _e394[0];
                        } else {
                            phi_691_ = _e394[1];
                        }
                        let _e436 = phi_691_;
                        let _e437 = (_e370 == 2u);
                        if _e437 {
                            phi_697_ = _e394[2];
                        } else {
                            phi_697_ = _e436;
                        }
                        let _e440 = phi_697_;
                        if _e432 {
                            phi_708_ = _e404[0];
                        } else {
                            phi_708_ = _e404[1];
                        }
                        let _e444 = phi_708_;
                        if _e437 {
                            phi_714_ = _e404[2];
                        } else {
                            phi_714_ = _e444;
                        }
                        let _e447 = phi_714_;
                        let _e449 = ((_e447 * _e383) * _e389);
                        let _e453 = (bitcast<f32>((bitcast<u32>(_e449) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e453 {
                            let _e457 = (bitcast<f32>((bitcast<u32>(_e440) & 2147483647u)) * 0.00000011920929f);
                            phi_737_ = select(0.00000000000011368684f, _e457, (_e457 > 0.00000000000011368684f));
                        } else {
                            phi_737_ = 0f;
                        }
                        let _e461 = phi_737_;
                        let _e462 = (_e440 + _e461);
                        let _e463 = (_e440 - _e461);
                        let _e464 = select(_e449, 0f, _e453);
                        if _e453 {
                            phi_748_ = 38685626000000000000000000f;
                        } else {
                            phi_748_ = (1f / _e449);
                        }
                        let _e467 = phi_748_;
                        let _e468 = (_e372 == 0u);
                        if _e468 {
                            phi_757_ = _e394[0];
                        } else {
                            phi_757_ = _e394[1];
                        }
                        let _e472 = phi_757_;
                        let _e473 = (_e372 == 2u);
                        if _e473 {
                            phi_763_ = _e394[2];
                        } else {
                            phi_763_ = _e472;
                        }
                        let _e476 = phi_763_;
                        if _e468 {
                            phi_774_ = _e404[0];
                        } else {
                            phi_774_ = _e404[1];
                        }
                        let _e480 = phi_774_;
                        if _e473 {
                            phi_780_ = _e404[2];
                        } else {
                            phi_780_ = _e480;
                        }
                        let _e483 = phi_780_;
                        let _e485 = ((_e483 * _e383) * _e389);
                        let _e489 = (bitcast<f32>((bitcast<u32>(_e485) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e489 {
                            let _e493 = (bitcast<f32>((bitcast<u32>(_e476) & 2147483647u)) * 0.00000011920929f);
                            phi_803_ = select(0.00000000000011368684f, _e493, (_e493 > 0.00000000000011368684f));
                        } else {
                            phi_803_ = 0f;
                        }
                        let _e497 = phi_803_;
                        let _e498 = (_e476 + _e497);
                        let _e499 = (_e476 - _e497);
                        let _e500 = select(_e485, 0f, _e489);
                        if _e489 {
                            phi_814_ = 38685626000000000000000000f;
                        } else {
                            phi_814_ = (1f / _e485);
                        }
                        let _e503 = phi_814_;
                        let _e506 = bitcast<f32>((bitcast<u32>(_e403) & 2147483647u));
                        let _e509 = bitcast<f32>((bitcast<u32>(_e440) & 2147483647u));
                        let _e511 = select(_e509, _e506, (_e506 > _e509));
                        let _e514 = bitcast<f32>((bitcast<u32>(_e476) & 2147483647u));
                        if (_e333 && (select(_e514, _e511, (_e511 > _e514)) <= 1099511600000f)) {
                            let _e519 = (_e352 / 3i);
                            let _e526 = bitcast<f32>((bitcast<u32>((_e519 + 127i)) << bitcast<u32>(23i)));
                            let _e533 = bitcast<f32>((bitcast<u32>(((_e352 - (2i * _e519)) + 127i)) << bitcast<u32>(23i)));
                            let _e534 = (((_e244 * _e526) * _e526) * _e533);
                            let _e536 = select(340282350000000000000000000000000000000f, _e534, (_e534 < 340282350000000000000000000000000000000f));
                            let _e541 = (((_e249 * _e526) * _e526) * _e533);
                            let _e543 = select(340282350000000000000000000000000000000f, _e541, (_e541 < 340282350000000000000000000000000000000f));
                            phi_914_ = select(-340282350000000000000000000000000000000f, _e543, (_e543 > -340282350000000000000000000000000000000f));
                            phi_915_ = select(-340282350000000000000000000000000000000f, _e536, (_e536 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_914_ = 0f;
                            phi_915_ = 1f;
                        }
                        let _e547 = phi_914_;
                        let _e549 = phi_915_;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e553 = (_e371 % 3u);
                        let _e554 = (_e553 < 3u);
                        if _e554 {
                        } else {
                            break;
                        }
                        let _e556 = local_1[_e553];
                        let _e559 = (_e370 % 3u);
                        let _e560 = (_e559 < 3u);
                        if _e560 {
                        } else {
                            break;
                        }
                        let _e562 = local_1[_e559];
                        let _e565 = (_e372 % 3u);
                        let _e566 = (_e565 < 3u);
                        if _e566 {
                        } else {
                            break;
                        }
                        let _e568 = local_1[_e565];
                        if _e554 {
                        } else {
                            break;
                        }
                        let _e573 = local[_e553];
                        if _e560 {
                        } else {
                            break;
                        }
                        let _e577 = local[_e559];
                        if _e566 {
                        } else {
                            break;
                        }
                        let _e581 = local[_e565];
                        phi_4266_ = false;
                        phi_1004_ = type_42(_e547, false);
                        phi_1007_ = type_58(type_30(vec4<f32>((f32(_e556) * _e157), (f32(_e562) * _e157), (f32(_e568) * _e157), 0f), vec4<f32>((f32(_e573) * _e157), (f32(_e577) * _e157), (f32(_e581) * _e157), 0f)), select(0u, 2147483648u, (_e98 == 0u)));
                        phi_1009_ = ((3u * _e98) + 1u);
                        phi_1011_ = (_e549 <= _e547);
                        phi_1013_ = 0u;
                        loop {
                            let _e591 = phi_4266_;
                            let _e593 = phi_1004_;
                            let _e595 = phi_1007_;
                            let _e597 = phi_1009_;
                            let _e599 = phi_1011_;
                            let _e601 = phi_1013_;
                            local_11 = _e593;
                            if _e599 {
                                phi_1024_ = true;
                            } else {
                                phi_1024_ = (_e601 > 0u);
                            }
                            let _e604 = phi_1024_;
                            if _e604 {
                                let _e605 = (_e597 > 0u);
                                if _e605 {
                                    if _e599 {
                                        phi_1110_ = _e595;
                                        phi_1111_ = _e599;
                                        phi_1112_ = _e601;
                                    } else {
                                        let _e606 = (_e601 - 1u);
                                        let _e607 = (_e606 % 128u);
                                        let _e608 = (_e607 < 128u);
                                        if _e608 {
                                        } else {
                                            phi_4445_ = true;
                                            break;
                                        }
                                        let _e610 = local_7[_e607];
                                        if _e608 {
                                        } else {
                                            phi_4445_ = true;
                                            break;
                                        }
                                        let _e612 = local_6[_e607];
                                        if _e608 {
                                        } else {
                                            phi_4445_ = true;
                                            break;
                                        }
                                        let _e614 = local_5[_e607];
                                        if _e608 {
                                        } else {
                                            phi_4445_ = true;
                                            break;
                                        }
                                        let _e616 = local_4[_e607];
                                        if _e608 {
                                        } else {
                                            phi_4445_ = true;
                                            break;
                                        }
                                        let _e618 = local_3[_e607];
                                        if _e608 {
                                        } else {
                                            phi_4445_ = true;
                                            break;
                                        }
                                        let _e620 = local_2[_e607];
                                        if _e608 {
                                        } else {
                                            phi_4445_ = true;
                                            break;
                                        }
                                        let _e625 = local_8[_e607];
                                        if _e608 {
                                        } else {
                                            phi_4445_ = true;
                                            break;
                                        }
                                        let _e628 = local_9[_e607];
                                        phi_1110_ = type_58(type_30(vec4<f32>(_e610, _e612, _e614, 0f), vec4<f32>(_e616, _e618, _e620, 0f)), _e625);
                                        phi_1111_ = (_e628 <= _e593.member);
                                        phi_1112_ = _e606;
                                    }
                                    let _e632 = phi_1110_;
                                    let _e634 = phi_1111_;
                                    let _e636 = phi_1112_;
                                    if _e634 {
                                        let _e641 = (_e632.member_1 & 268435455u);
                                        if ((_e632.member_1 & 2147483648u) != 0u) {
                                            phi_1131_ = _e593;
                                            phi_1134_ = type_8(0u, ((_e632.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1119 = phi_1131_;
                                                let _e1121 = phi_1134_;
                                                local_10 = _e1119;
                                                local_12 = _e1119;
                                                if (_e1121.member < _e1121.member_1) {
                                                    phi_1135_ = type_8((_e1121.member + 1u), _e1121.member_1);
                                                    phi_1157_ = type_8(1u, _e1121.member);
                                                } else {
                                                    phi_1135_ = _e1121;
                                                    phi_1157_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1134 = phi_1135_;
                                                let _e1136 = phi_1157_;
                                                let _e1140 = (bitcast<i32>(_e1136.member) != 0i);
                                                if _e1140 {
                                                    let _e1145 = (_e632.member.member_1.x - _e632.member.member.x);
                                                    let _e1148 = (_e632.member.member_1.y - _e632.member.member.y);
                                                    let _e1151 = (_e632.member.member_1.z - _e632.member.member.z);
                                                    let _e1153 = select(_e1148, _e1145, (_e1145 > _e1148));
                                                    let _e1155 = select(_e1151, _e1153, (_e1153 > _e1151));
                                                    let _e1157 = (_e1155 < (1024f * _e157));
                                                    if _e1157 {
                                                        phi_1198_ = 0u;
                                                    } else {
                                                        phi_1198_ = select(2u, 1u, (_e1155 < (2097152f * _e157)));
                                                    }
                                                    let _e1162 = phi_1198_;
                                                    switch bitcast<i32>(_e1162) {
                                                        case 0: {
                                                            phi_1204_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1204_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1204_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1204_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1165 = phi_1204_;
                                                    switch bitcast<i32>(_e1162) {
                                                        case 0: {
                                                            phi_1214_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1214_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1214_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1214_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1172 = phi_1214_;
                                                    let _e1174 = ((_e641 + (_e1136.member_1 * ((3u * _e1165) + 1u))) + (3u * _e1172));
                                                    let _e1175 = (_e1174 < _e101);
                                                    if _e1175 {
                                                        if _e1175 {
                                                        } else {
                                                            phi_4260_ = true;
                                                            break;
                                                        }
                                                        let _e1177 = global_10.member[_e1174];
                                                        phi_1230_ = _e1177;
                                                    } else {
                                                        phi_1230_ = 4294967295u;
                                                    }
                                                    let _e1179 = phi_1230_;
                                                    if _e1157 {
                                                        phi_1263_ = 0u;
                                                    } else {
                                                        phi_1263_ = select(2u, 1u, (_e1155 < (2097152f * _e157)));
                                                    }
                                                    let _e1184 = phi_1263_;
                                                    switch bitcast<i32>(_e1184) {
                                                        case 0: {
                                                            phi_1269_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1269_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1269_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1269_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1187 = phi_1269_;
                                                    let _e1191 = (_e641 + (_e1136.member_1 * ((3u * _e1187) + 1u)));
                                                    switch bitcast<i32>(_e1184) {
                                                        case 0: {
                                                            let _e1457 = (_e1191 < _e101);
                                                            if _e1457 {
                                                                if _e1457 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1459 = global_10.member[_e1191];
                                                                phi_1293_ = _e1459;
                                                            } else {
                                                                phi_1293_ = 0u;
                                                            }
                                                            let _e1461 = phi_1293_;
                                                            let _e1463 = ((10u * _e371) & 31u);
                                                            let _e1472 = ((10u * _e370) & 31u);
                                                            let _e1481 = ((10u * _e372) & 31u);
                                                            let _e1490 = (_e1191 + 1u);
                                                            let _e1491 = (_e1490 < _e101);
                                                            if _e1491 {
                                                                if _e1491 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1493 = global_10.member[_e1490];
                                                                phi_1336_ = _e1493;
                                                            } else {
                                                                phi_1336_ = 0u;
                                                            }
                                                            let _e1495 = phi_1336_;
                                                            let _e1518 = (_e1191 + 2u);
                                                            let _e1519 = (_e1518 < _e101);
                                                            if _e1519 {
                                                                if _e1519 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1521 = global_10.member[_e1518];
                                                                phi_1379_ = _e1521;
                                                            } else {
                                                                phi_1379_ = 0u;
                                                            }
                                                            let _e1523 = phi_1379_;
                                                            phi_1850_ = array<array<f32, 3>, 3>(array<f32, 3>((_e632.member.member.x + (f32(bitcast<i32>(((_e1461 >> bitcast<u32>(_e1463)) & 1023u))) * _e157)), (_e632.member.member.y + (f32(bitcast<i32>(((_e1461 >> bitcast<u32>(_e1472)) & 1023u))) * _e157)), (_e632.member.member.z + (f32(bitcast<i32>(((_e1461 >> bitcast<u32>(_e1481)) & 1023u))) * _e157))), array<f32, 3>((_e632.member.member.x + (f32(bitcast<i32>(((_e1495 >> bitcast<u32>(_e1463)) & 1023u))) * _e157)), (_e632.member.member.y + (f32(bitcast<i32>(((_e1495 >> bitcast<u32>(_e1472)) & 1023u))) * _e157)), (_e632.member.member.z + (f32(bitcast<i32>(((_e1495 >> bitcast<u32>(_e1481)) & 1023u))) * _e157))), array<f32, 3>((_e632.member.member.x + (f32(bitcast<i32>(((_e1523 >> bitcast<u32>(_e1463)) & 1023u))) * _e157)), (_e632.member.member.y + (f32(bitcast<i32>(((_e1523 >> bitcast<u32>(_e1472)) & 1023u))) * _e157)), (_e632.member.member.z + (f32(bitcast<i32>(((_e1523 >> bitcast<u32>(_e1481)) & 1023u))) * _e157))));
                                                            break;
                                                        }
                                                        case 1: {
                                                            let _e1280 = (_e1191 < _e101);
                                                            if _e1280 {
                                                                if _e1280 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1282 = global_10.member[_e1191];
                                                                phi_1422_ = _e1282;
                                                            } else {
                                                                phi_1422_ = 0u;
                                                            }
                                                            let _e1284 = phi_1422_;
                                                            let _e1285 = (_e1191 + 1u);
                                                            let _e1286 = (_e1285 < _e101);
                                                            if _e1286 {
                                                                if _e1286 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1288 = global_10.member[_e1285];
                                                                phi_1437_ = _e1288;
                                                            } else {
                                                                phi_1437_ = 0u;
                                                            }
                                                            let _e1290 = phi_1437_;
                                                            let _e1291 = (_e371 == 1u);
                                                            if _e1291 {
                                                                phi_1447_ = ((_e1284 >> bitcast<u32>(21i)) | (_e1290 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1447_ = (_e1290 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1300 = phi_1447_;
                                                            let _e1307 = (_e370 == 1u);
                                                            if _e1307 {
                                                                phi_1467_ = ((_e1284 >> bitcast<u32>(21i)) | (_e1290 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1467_ = (_e1290 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1316 = phi_1467_;
                                                            let _e1323 = (_e372 == 1u);
                                                            if _e1323 {
                                                                phi_1487_ = ((_e1284 >> bitcast<u32>(21i)) | (_e1290 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1487_ = (_e1290 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1332 = phi_1487_;
                                                            let _e1340 = (_e1191 + 2u);
                                                            let _e1341 = (_e1340 < _e101);
                                                            if _e1341 {
                                                                if _e1341 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1343 = global_10.member[_e1340];
                                                                phi_1513_ = _e1343;
                                                            } else {
                                                                phi_1513_ = 0u;
                                                            }
                                                            let _e1345 = phi_1513_;
                                                            let _e1346 = (_e1191 + 3u);
                                                            let _e1347 = (_e1346 < _e101);
                                                            if _e1347 {
                                                                if _e1347 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1349 = global_10.member[_e1346];
                                                                phi_1528_ = _e1349;
                                                            } else {
                                                                phi_1528_ = 0u;
                                                            }
                                                            let _e1351 = phi_1528_;
                                                            if _e1291 {
                                                                phi_1538_ = ((_e1345 >> bitcast<u32>(21i)) | (_e1351 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1538_ = (_e1351 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1360 = phi_1538_;
                                                            if _e1307 {
                                                                phi_1558_ = ((_e1345 >> bitcast<u32>(21i)) | (_e1351 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1558_ = (_e1351 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1375 = phi_1558_;
                                                            if _e1323 {
                                                                phi_1578_ = ((_e1345 >> bitcast<u32>(21i)) | (_e1351 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1578_ = (_e1351 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1390 = phi_1578_;
                                                            let _e1398 = (_e1191 + 4u);
                                                            let _e1399 = (_e1398 < _e101);
                                                            if _e1399 {
                                                                if _e1399 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1401 = global_10.member[_e1398];
                                                                phi_1604_ = _e1401;
                                                            } else {
                                                                phi_1604_ = 0u;
                                                            }
                                                            let _e1403 = phi_1604_;
                                                            let _e1404 = (_e1191 + 5u);
                                                            let _e1405 = (_e1404 < _e101);
                                                            if _e1405 {
                                                                if _e1405 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1407 = global_10.member[_e1404];
                                                                phi_1619_ = _e1407;
                                                            } else {
                                                                phi_1619_ = 0u;
                                                            }
                                                            let _e1409 = phi_1619_;
                                                            if _e1291 {
                                                                phi_1629_ = ((_e1403 >> bitcast<u32>(21i)) | (_e1409 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1629_ = (_e1409 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1418 = phi_1629_;
                                                            if _e1307 {
                                                                phi_1649_ = ((_e1403 >> bitcast<u32>(21i)) | (_e1409 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1649_ = (_e1409 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1433 = phi_1649_;
                                                            if _e1323 {
                                                                phi_1669_ = ((_e1403 >> bitcast<u32>(21i)) | (_e1409 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1669_ = (_e1409 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1448 = phi_1669_;
                                                            phi_1850_ = array<array<f32, 3>, 3>(array<f32, 3>((_e632.member.member.x + (f32(bitcast<i32>((select(_e1300, _e1284, _e395) & 2097151u))) * _e157)), (_e632.member.member.y + (f32(bitcast<i32>((select(_e1316, _e1284, _e432) & 2097151u))) * _e157)), (_e632.member.member.z + (f32(bitcast<i32>((select(_e1332, _e1284, _e468) & 2097151u))) * _e157))), array<f32, 3>((_e632.member.member.x + (f32(bitcast<i32>((select(_e1360, _e1345, _e395) & 2097151u))) * _e157)), (_e632.member.member.y + (f32(bitcast<i32>((select(_e1375, _e1345, _e432) & 2097151u))) * _e157)), (_e632.member.member.z + (f32(bitcast<i32>((select(_e1390, _e1345, _e468) & 2097151u))) * _e157))), array<f32, 3>((_e632.member.member.x + (f32(bitcast<i32>((select(_e1418, _e1403, _e395) & 2097151u))) * _e157)), (_e632.member.member.y + (f32(bitcast<i32>((select(_e1433, _e1403, _e432) & 2097151u))) * _e157)), (_e632.member.member.z + (f32(bitcast<i32>((select(_e1448, _e1403, _e468) & 2097151u))) * _e157))));
                                                            break;
                                                        }
                                                        case 2: {
                                                            let _e1193 = (_e1191 + _e371);
                                                            let _e1194 = (_e1193 < _e101);
                                                            if _e1194 {
                                                                if _e1194 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1196 = global_10.member[_e1193];
                                                                phi_1696_ = _e1196;
                                                            } else {
                                                                phi_1696_ = 0u;
                                                            }
                                                            let _e1198 = phi_1696_;
                                                            let _e1202 = (_e1191 + _e370);
                                                            let _e1203 = (_e1202 < _e101);
                                                            if _e1203 {
                                                                if _e1203 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1205 = global_10.member[_e1202];
                                                                phi_1714_ = _e1205;
                                                            } else {
                                                                phi_1714_ = 0u;
                                                            }
                                                            let _e1207 = phi_1714_;
                                                            let _e1211 = (_e1191 + _e372);
                                                            let _e1212 = (_e1211 < _e101);
                                                            if _e1212 {
                                                                if _e1212 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1214 = global_10.member[_e1211];
                                                                phi_1732_ = _e1214;
                                                            } else {
                                                                phi_1732_ = 0u;
                                                            }
                                                            let _e1216 = phi_1732_;
                                                            let _e1221 = (_e1191 + 3u);
                                                            let _e1222 = (_e1221 + _e371);
                                                            let _e1223 = (_e1222 < _e101);
                                                            if _e1223 {
                                                                if _e1223 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1225 = global_10.member[_e1222];
                                                                phi_1752_ = _e1225;
                                                            } else {
                                                                phi_1752_ = 0u;
                                                            }
                                                            let _e1227 = phi_1752_;
                                                            let _e1231 = (_e1221 + _e370);
                                                            let _e1232 = (_e1231 < _e101);
                                                            if _e1232 {
                                                                if _e1232 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1234 = global_10.member[_e1231];
                                                                phi_1770_ = _e1234;
                                                            } else {
                                                                phi_1770_ = 0u;
                                                            }
                                                            let _e1236 = phi_1770_;
                                                            let _e1240 = (_e1221 + _e372);
                                                            let _e1241 = (_e1240 < _e101);
                                                            if _e1241 {
                                                                if _e1241 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1243 = global_10.member[_e1240];
                                                                phi_1788_ = _e1243;
                                                            } else {
                                                                phi_1788_ = 0u;
                                                            }
                                                            let _e1245 = phi_1788_;
                                                            let _e1250 = (_e1191 + 6u);
                                                            let _e1251 = (_e1250 + _e371);
                                                            let _e1252 = (_e1251 < _e101);
                                                            if _e1252 {
                                                                if _e1252 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1254 = global_10.member[_e1251];
                                                                phi_1808_ = _e1254;
                                                            } else {
                                                                phi_1808_ = 0u;
                                                            }
                                                            let _e1256 = phi_1808_;
                                                            let _e1260 = (_e1250 + _e370);
                                                            let _e1261 = (_e1260 < _e101);
                                                            if _e1261 {
                                                                if _e1261 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1263 = global_10.member[_e1260];
                                                                phi_1826_ = _e1263;
                                                            } else {
                                                                phi_1826_ = 0u;
                                                            }
                                                            let _e1265 = phi_1826_;
                                                            let _e1269 = (_e1250 + _e372);
                                                            let _e1270 = (_e1269 < _e101);
                                                            if _e1270 {
                                                                if _e1270 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1272 = global_10.member[_e1269];
                                                                phi_1844_ = _e1272;
                                                            } else {
                                                                phi_1844_ = 0u;
                                                            }
                                                            let _e1274 = phi_1844_;
                                                            phi_1850_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1198)) * _e157), (f32(bitcast<i32>(_e1207)) * _e157), (f32(bitcast<i32>(_e1216)) * _e157)), array<f32, 3>((f32(bitcast<i32>(_e1227)) * _e157), (f32(bitcast<i32>(_e1236)) * _e157), (f32(bitcast<i32>(_e1245)) * _e157)), array<f32, 3>((f32(bitcast<i32>(_e1256)) * _e157), (f32(bitcast<i32>(_e1265)) * _e157), (f32(bitcast<i32>(_e1274)) * _e157)));
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1850_ = array<array<f32, 3>, 3>();
                                                            break;
                                                        }
                                                    }
                                                    let _e1548 = phi_1850_;
                                                    let _e1556 = (_e1548[0][2] - _e476);
                                                    let _e1559 = (((_e1548[0][0] - _e403) * _e500) - (_e1556 * _e428));
                                                    let _e1562 = (((_e1548[0][1] - _e440) * _e500) - (_e1556 * _e464));
                                                    let _e1569 = (_e1548[1][2] - _e476);
                                                    let _e1572 = (((_e1548[1][0] - _e403) * _e500) - (_e1569 * _e428));
                                                    let _e1575 = (((_e1548[1][1] - _e440) * _e500) - (_e1569 * _e464));
                                                    let _e1582 = (_e1548[2][2] - _e476);
                                                    let _e1585 = (((_e1548[2][0] - _e403) * _e500) - (_e1582 * _e428));
                                                    let _e1588 = (((_e1548[2][1] - _e440) * _e500) - (_e1582 * _e464));
                                                    let _e1589 = (_e1585 * _e1575);
                                                    let _e1590 = (_e1588 * _e1572);
                                                    let _e1591 = (_e1559 * _e1588);
                                                    let _e1592 = (_e1562 * _e1585);
                                                    let _e1593 = (_e1572 * _e1562);
                                                    let _e1594 = (_e1575 * _e1559);
                                                    let _e1599 = (((_e1589 >= _e1590) && (_e1591 >= _e1592)) && (_e1593 >= _e1594));
                                                    if (_e1599 || (((_e1589 <= _e1590) && (_e1591 <= _e1592)) && (_e1593 <= _e1594))) {
                                                        let _e1606 = select(-1f, 1f, _e1599);
                                                        let _e1608 = ((_e1589 - _e1590) * _e1606);
                                                        let _e1610 = select(0f, _e1608, (_e1608 > 0f));
                                                        let _e1612 = ((_e1591 - _e1592) * _e1606);
                                                        let _e1614 = select(0f, _e1612, (_e1612 > 0f));
                                                        let _e1616 = ((_e1593 - _e1594) * _e1606);
                                                        let _e1618 = select(0f, _e1616, (_e1616 > 0f));
                                                        let _e1620 = ((_e1610 + _e1614) + _e1618);
                                                        if (_e1620 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2416_ = type_21();
                                                            phi_2417_ = true;
                                                        } else {
                                                            let _e1623 = select(_e1548[1][0], _e1548[0][0], (_e1548[0][0] < _e1548[1][0]));
                                                            let _e1627 = select(_e1548[1][0], _e1548[0][0], (_e1548[0][0] > _e1548[1][0]));
                                                            let _e1631 = select(_e1548[1][1], _e1548[0][1], (_e1548[0][1] < _e1548[1][1]));
                                                            let _e1635 = select(_e1548[1][1], _e1548[0][1], (_e1548[0][1] > _e1548[1][1]));
                                                            let _e1639 = select(_e1548[1][2], _e1548[0][2], (_e1548[0][2] < _e1548[1][2]));
                                                            let _e1643 = select(_e1548[1][2], _e1548[0][2], (_e1548[0][2] > _e1548[1][2]));
                                                            let _e1648 = ((select(_e1548[2][0], _e1623, (_e1623 < _e1548[2][0])) - _e426) * _e431);
                                                            let _e1649 = ((select(_e1548[2][0], _e1627, (_e1627 > _e1548[2][0])) - _e427) * _e431);
                                                            let _e1652 = ((select(_e1548[2][1], _e1631, (_e1631 < _e1548[2][1])) - _e462) * _e467);
                                                            let _e1653 = ((select(_e1548[2][1], _e1635, (_e1635 > _e1548[2][1])) - _e463) * _e467);
                                                            let _e1656 = ((select(_e1548[2][2], _e1639, (_e1639 < _e1548[2][2])) - _e498) * _e503);
                                                            let _e1657 = ((select(_e1548[2][2], _e1643, (_e1643 > _e1548[2][2])) - _e499) * _e503);
                                                            let _e1659 = select(_e1657, _e1656, (_e1656 < _e1657));
                                                            let _e1661 = select(_e1657, _e1656, (_e1656 > _e1657));
                                                            let _e1663 = select(_e1649, _e1648, (_e1648 < _e1649));
                                                            let _e1665 = select(_e1653, _e1652, (_e1652 < _e1653));
                                                            let _e1667 = select(_e1665, _e1663, (_e1663 > _e1665));
                                                            let _e1669 = select(_e1659, _e1667, (_e1667 > _e1659));
                                                            let _e1671 = select(_e1649, _e1648, (_e1648 > _e1649));
                                                            let _e1673 = select(_e1653, _e1652, (_e1652 > _e1653));
                                                            let _e1675 = select(_e1673, _e1671, (_e1671 < _e1673));
                                                            let _e1677 = select(_e1661, _e1675, (_e1675 < _e1661));
                                                            let _e1678 = -(_e1659);
                                                            let _e1684 = select(_e549, _e1669, (_e1669 > _e549));
                                                            if (_e1684 > (_e1677 + (select(_e1678, _e1661, (_e1661 > _e1678)) * 0.0000019073523f))) {
                                                                phi_2411_ = type_21();
                                                                phi_2412_ = true;
                                                            } else {
                                                                let _e1686 = (_e1684 > _e1119.member);
                                                                if _e1686 {
                                                                    phi_2410_ = type_21();
                                                                } else {
                                                                    let _e1690 = (_e1548[1][0] - _e1548[0][0]);
                                                                    let _e1691 = (_e1548[1][1] - _e1548[0][1]);
                                                                    let _e1692 = (_e1548[1][2] - _e1548[0][2]);
                                                                    let _e1693 = vec3<f32>(_e1690, _e1691, _e1692);
                                                                    let _e1694 = (_e1548[2][0] - _e1548[1][0]);
                                                                    let _e1695 = (_e1548[2][1] - _e1548[1][1]);
                                                                    let _e1696 = (_e1548[2][2] - _e1548[1][2]);
                                                                    let _e1697 = vec3<f32>(_e1694, _e1695, _e1696);
                                                                    let _e1698 = (_e1548[0][0] - _e1548[2][0]);
                                                                    let _e1699 = (_e1548[0][1] - _e1548[2][1]);
                                                                    let _e1700 = (_e1548[0][2] - _e1548[2][2]);
                                                                    let _e1701 = vec3<f32>(_e1698, _e1699, _e1700);
                                                                    let _e1704 = bitcast<f32>((bitcast<u32>(_e1690) & 2147483647u));
                                                                    let _e1707 = bitcast<f32>((bitcast<u32>(_e1691) & 2147483647u));
                                                                    let _e1709 = select(_e1707, _e1704, (_e1704 > _e1707));
                                                                    let _e1712 = bitcast<f32>((bitcast<u32>(_e1692) & 2147483647u));
                                                                    let _e1714 = select(_e1712, _e1709, (_e1709 > _e1712));
                                                                    let _e1717 = bitcast<f32>((bitcast<u32>(_e1694) & 2147483647u));
                                                                    let _e1720 = bitcast<f32>((bitcast<u32>(_e1695) & 2147483647u));
                                                                    let _e1722 = select(_e1720, _e1717, (_e1717 > _e1720));
                                                                    let _e1725 = bitcast<f32>((bitcast<u32>(_e1696) & 2147483647u));
                                                                    let _e1727 = select(_e1725, _e1722, (_e1722 > _e1725));
                                                                    let _e1730 = bitcast<f32>((bitcast<u32>(_e1698) & 2147483647u));
                                                                    let _e1733 = bitcast<f32>((bitcast<u32>(_e1699) & 2147483647u));
                                                                    let _e1735 = select(_e1733, _e1730, (_e1730 > _e1733));
                                                                    let _e1738 = bitcast<f32>((bitcast<u32>(_e1700) & 2147483647u));
                                                                    let _e1740 = select(_e1738, _e1735, (_e1735 > _e1738));
                                                                    let _e1742 = select(_e1727, _e1714, (_e1714 > _e1727));
                                                                    let _e1744 = select(_e1740, _e1742, (_e1742 > _e1740));
                                                                    if (_e1714 == _e1744) {
                                                                        phi_2321_ = _e1697;
                                                                        phi_2322_ = _e1701;
                                                                    } else {
                                                                        let _e1747 = vec3((_e1727 == _e1744));
                                                                        phi_2321_ = select(_e1693, _e1701, _e1747);
                                                                        phi_2322_ = select(_e1697, _e1693, _e1747);
                                                                    }
                                                                    let _e1751 = phi_2321_;
                                                                    let _e1753 = phi_2322_;
                                                                    let _e1760 = ((_e1751.y * _e1753.z) - (_e1753.y * _e1751.z));
                                                                    let _e1765 = ((_e1751.z * _e1753.x) - (_e1753.z * _e1751.x));
                                                                    let _e1768 = ((_e1751.x * _e1753.y) - (_e1753.x * _e1751.y));
                                                                    if (_e1610 >= _e1614) {
                                                                        phi_2353_ = select(true, false, (_e1610 >= _e1618));
                                                                    } else {
                                                                        phi_2353_ = true;
                                                                    }
                                                                    let _e1773 = phi_2353_;
                                                                    if _e1773 {
                                                                        phi_2362_ = select(vec3<f32>(_e1548[2][0], _e1548[2][1], _e1548[2][2]), vec3<f32>(_e1548[1][0], _e1548[1][1], _e1548[1][2]), vec3((_e1614 >= _e1618)));
                                                                    } else {
                                                                        phi_2362_ = vec3<f32>(_e1548[0][0], _e1548[0][1], _e1548[0][2]);
                                                                    }
                                                                    let _e1778 = phi_2362_;
                                                                    let _e1795 = ((((_e1760 * (_e1778.x - _e403)) + (_e1765 * (_e1778.y - _e440))) + (_e1768 * (_e1778.z - _e476))) / (((_e1760 * _e428) + (_e1765 * _e464)) + (_e1768 * _e500)));
                                                                    let _e1797 = select(_e1677, _e1795, (_e1795 < _e1677));
                                                                    let _e1799 = select(_e1669, _e1797, (_e1797 > _e1669));
                                                                    if (_e1799 >= _e549) {
                                                                        let _e1801 = (_e1799 <= _e1119.member);
                                                                        if _e1801 {
                                                                            let _e1802 = (1f / _e1620);
                                                                            phi_2402_ = type_21(_e1799, (_e1614 * _e1802), (_e1618 * _e1802), _e1179);
                                                                        } else {
                                                                            phi_2402_ = type_21();
                                                                        }
                                                                        let _e1807 = phi_2402_;
                                                                        phi_2404_ = _e1807;
                                                                        phi_2405_ = select(true, false, _e1801);
                                                                    } else {
                                                                        phi_2404_ = type_21();
                                                                        phi_2405_ = true;
                                                                    }
                                                                    let _e1810 = phi_2404_;
                                                                    let _e1812 = phi_2405_;
                                                                    if _e1812 {
                                                                        phi_2409_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_2409_ = _e1810;
                                                                    }
                                                                    let _e1814 = phi_2409_;
                                                                    phi_2410_ = _e1814;
                                                                }
                                                                let _e1816 = phi_2410_;
                                                                phi_2411_ = _e1816;
                                                                phi_2412_ = _e1686;
                                                            }
                                                            let _e1818 = phi_2411_;
                                                            let _e1820 = phi_2412_;
                                                            phi_2416_ = _e1818;
                                                            phi_2417_ = _e1820;
                                                        }
                                                        let _e1822 = phi_2416_;
                                                        let _e1824 = phi_2417_;
                                                        phi_2421_ = _e1822;
                                                        phi_2422_ = _e1824;
                                                    } else {
                                                        phi_2421_ = type_21();
                                                        phi_2422_ = true;
                                                    }
                                                    let _e1826 = phi_2421_;
                                                    let _e1828 = phi_2422_;
                                                    if _e1828 {
                                                        phi_2426_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2426_ = _e1826;
                                                    }
                                                    let _e1830 = phi_2426_;
                                                    if (_e1830.member_3 != 4294967295u) {
                                                        if (_e1179 == _e166) {
                                                            phi_2755_ = false;
                                                        } else {
                                                            let _e1834 = (_e1179 < arrayLength((&global_5.member)));
                                                            if _e1834 {
                                                                if _e1834 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1836 = global_5.member[_e1179];
                                                                phi_2449_ = _e1836;
                                                            } else {
                                                                phi_2449_ = 4294967295u;
                                                            }
                                                            let _e1838 = phi_2449_;
                                                            let _e1839 = (_e1838 < arrayLength((&global_6.member)));
                                                            if _e1839 {
                                                                if _e1839 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1841 = global_6.member[_e1838];
                                                                phi_2463_ = _e1841;
                                                            } else {
                                                                phi_2463_ = 0i;
                                                            }
                                                            let _e1843 = phi_2463_;
                                                            let _e1844 = (_e1843 == 0i);
                                                            if _e1844 {
                                                                phi_2754_ = true;
                                                            } else {
                                                                if _e395 {
                                                                    phi_2484_ = vec3<f32>(_e1548[0][0], _e1548[0][1], _e1548[0][2]);
                                                                } else {
                                                                    if (_e371 == 1u) {
                                                                        phi_2483_ = vec3<f32>(_e1548[0][2], _e1548[0][0], _e1548[0][1]);
                                                                    } else {
                                                                        phi_2483_ = vec3<f32>(_e1548[0][1], _e1548[0][2], _e1548[0][0]);
                                                                    }
                                                                    let _e1849 = phi_2483_;
                                                                    phi_2484_ = _e1849;
                                                                }
                                                                let _e1852 = phi_2484_;
                                                                if _e395 {
                                                                    phi_2501_ = vec3<f32>(_e1548[1][0], _e1548[1][1], _e1548[1][2]);
                                                                } else {
                                                                    if (_e371 == 1u) {
                                                                        phi_2500_ = vec3<f32>(_e1548[1][2], _e1548[1][0], _e1548[1][1]);
                                                                    } else {
                                                                        phi_2500_ = vec3<f32>(_e1548[1][1], _e1548[1][2], _e1548[1][0]);
                                                                    }
                                                                    let _e1857 = phi_2500_;
                                                                    phi_2501_ = _e1857;
                                                                }
                                                                let _e1860 = phi_2501_;
                                                                if _e395 {
                                                                    phi_2518_ = vec3<f32>(_e1548[2][0], _e1548[2][1], _e1548[2][2]);
                                                                } else {
                                                                    if (_e371 == 1u) {
                                                                        phi_2517_ = vec3<f32>(_e1548[2][2], _e1548[2][0], _e1548[2][1]);
                                                                    } else {
                                                                        phi_2517_ = vec3<f32>(_e1548[2][1], _e1548[2][2], _e1548[2][0]);
                                                                    }
                                                                    let _e1865 = phi_2517_;
                                                                    phi_2518_ = _e1865;
                                                                }
                                                                let _e1868 = phi_2518_;
                                                                let _e1871 = (_e1860.x - _e1852.x);
                                                                let _e1874 = (_e1860.y - _e1852.y);
                                                                let _e1877 = (_e1860.z - _e1852.z);
                                                                let _e1879 = (_e1868.x - _e1852.x);
                                                                let _e1881 = (_e1868.y - _e1852.y);
                                                                let _e1883 = (_e1868.z - _e1852.z);
                                                                if (_e238.member_1 == 1u) {
                                                                    phi_2554_ = (vec3<f32>(_e238.member[0], _e238.member[1], _e238.member[2]) - _e1852);
                                                                } else {
                                                                    phi_2554_ = vec3<f32>(_e238.member[0], _e238.member[1], _e238.member[2]);
                                                                }
                                                                let _e1898 = phi_2554_;
                                                                let _e1904 = bitcast<f32>((bitcast<u32>((_e1871 * _e1881)) ^ _e238.member_3[0]));
                                                                let _e1908 = bitcast<f32>((bitcast<u32>((_e1874 * _e1879)) ^ _e238.member_3[0]));
                                                                let _e1912 = bitcast<f32>((bitcast<u32>((_e1874 * _e1883)) ^ _e238.member_3[0]));
                                                                let _e1916 = bitcast<f32>((bitcast<u32>((_e1877 * _e1881)) ^ _e238.member_3[0]));
                                                                let _e1920 = bitcast<f32>((bitcast<u32>((_e1877 * _e1879)) ^ _e238.member_3[0]));
                                                                let _e1924 = bitcast<f32>((bitcast<u32>((_e1871 * _e1883)) ^ _e238.member_3[0]));
                                                                let _e1925 = (_e1912 - _e1916);
                                                                let _e1926 = (_e1920 - _e1924);
                                                                let _e1927 = (_e1904 - _e1908);
                                                                let _e1951 = (bitcast<f32>((bitcast<u32>(_e1912) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1916) & 2147483647u)));
                                                                let _e1958 = (bitcast<f32>((bitcast<u32>(_e1920) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1924) & 2147483647u)));
                                                                let _e1965 = (bitcast<f32>((bitcast<u32>(_e1904) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1908) & 2147483647u)));
                                                                if (_e238.member_2 == 0f) {
                                                                    phi_2736_ = 0f;
                                                                } else {
                                                                    let _e1995 = bitcast<f32>((bitcast<u32>(_e1925) & 2147483647u));
                                                                    let _e1998 = bitcast<f32>((bitcast<u32>(_e1926) & 2147483647u));
                                                                    let _e2001 = bitcast<f32>((bitcast<u32>(_e1927) & 2147483647u));
                                                                    let _e2003 = select(_e2001, _e1998, (_e1998 > _e2001));
                                                                    let _e2007 = select(_e2001, _e1998, (_e1998 < _e2001));
                                                                    let _e2011 = select(_e1998, _e1995, (_e1995 < _e1998));
                                                                    let _e2013 = select(_e1998, _e1995, (_e1995 > _e1998));
                                                                    let _e2015 = select(_e2001, _e2013, (_e2013 < _e2001));
                                                                    phi_2736_ = bitcast<f32>((bitcast<u32>((_e238.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2003, _e1995, (_e1995 > _e2003)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2015, _e2011, (_e2011 > _e2015)))) ^ _e238.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2007, _e1995, (_e1995 < _e2007)))) ^ _e238.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1951 + _e1958) + _e1965))) ^ _e238.member_3[0]))) * 1.0000005f)) ^ _e238.member_3[0])))) ^ _e238.member_3[0]));
                                                                }
                                                                let _e2042 = phi_2736_;
                                                                phi_2754_ = (_e1844 || !(((((bitcast<f32>((bitcast<u32>((_e1898.x * _e1925)) ^ _e238.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1898.y * _e1926)) ^ _e238.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1898.z * _e1927)) ^ _e238.member_3[0]))) * f32(-(_e1843))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1898.x) & 2147483647u)) * _e1951)) ^ _e238.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1898.y) & 2147483647u)) * _e1958)) ^ _e238.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1898.z) & 2147483647u)) * _e1965)) ^ _e238.member_3[0]))))) ^ _e238.member_3[0])) + _e2042) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e2056 = phi_2754_;
                                                            phi_2755_ = _e2056;
                                                        }
                                                        let _e2058 = phi_2755_;
                                                        if _e2058 {
                                                            phi_2760_ = type_42(_e1119.member, true);
                                                        } else {
                                                            phi_2760_ = _e1119;
                                                        }
                                                        let _e2063 = phi_2760_;
                                                        phi_2761_ = _e2063;
                                                    } else {
                                                        phi_2761_ = _e1119;
                                                    }
                                                    let _e2065 = phi_2761_;
                                                    phi_1132_ = _e2065;
                                                } else {
                                                    phi_1132_ = type_42();
                                                }
                                                let _e2067 = phi_1132_;
                                                continue;
                                                continuing {
                                                    phi_1131_ = _e2067;
                                                    phi_1134_ = _e1134;
                                                    phi_4260_ = _e591;
                                                    break if !(_e1140);
                                                }
                                            }
                                            let _e2070 = phi_4260_;
                                            phi_4445_ = _e2070;
                                            if _e2070 {
                                                break;
                                            }
                                            let _e2072 = local_10;
                                            phi_4449_ = _e2070;
                                            let _e2293 = local_12;
                                            phi_4002_ = _e2293;
                                            phi_4003_ = _e632;
                                            phi_4004_ = false;
                                            phi_4005_ = select(_e636, 0u, _e2072.member_1);
                                        } else {
                                            if (_e632.member_1 >= _e98) {
                                                phi_3558_ = type_59(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_58(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_58(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e632.member_1 < _e98) {
                                                } else {
                                                    phi_4445_ = true;
                                                    break;
                                                }
                                                let _e648 = (_e371 * 2u);
                                                let _e650 = ((1u + _e648) % 7u);
                                                if (_e650 < 7u) {
                                                } else {
                                                    phi_4445_ = true;
                                                    break;
                                                }
                                                let _e655 = global_8.member[_e632.member_1][_e650];
                                                let _e657 = ((_e648 + 2u) % 7u);
                                                if (_e657 < 7u) {
                                                } else {
                                                    phi_4445_ = true;
                                                    break;
                                                }
                                                let _e662 = global_8.member[_e632.member_1][_e657];
                                                let _e663 = (_e370 * 2u);
                                                let _e665 = ((1u + _e663) % 7u);
                                                if (_e665 < 7u) {
                                                } else {
                                                    phi_4445_ = true;
                                                    break;
                                                }
                                                let _e670 = global_8.member[_e632.member_1][_e665];
                                                let _e672 = ((_e663 + 2u) % 7u);
                                                if (_e672 < 7u) {
                                                } else {
                                                    phi_4445_ = true;
                                                    break;
                                                }
                                                let _e677 = global_8.member[_e632.member_1][_e672];
                                                let _e678 = (_e372 * 2u);
                                                let _e680 = ((1u + _e678) % 7u);
                                                if (_e680 < 7u) {
                                                } else {
                                                    phi_4445_ = true;
                                                    break;
                                                }
                                                let _e685 = global_8.member[_e632.member_1][_e680];
                                                let _e687 = ((_e678 + 2u) % 7u);
                                                if (_e687 < 7u) {
                                                } else {
                                                    phi_4445_ = true;
                                                    break;
                                                }
                                                let _e692 = global_8.member[_e632.member_1][_e687];
                                                let _e715 = (bitcast<f32>((bitcast<u32>((_e632.member.member_1.x - _e632.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e716 = (bitcast<f32>((bitcast<u32>((_e632.member.member_1.y - _e632.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e717 = (bitcast<f32>((bitcast<u32>((_e632.member.member_1.z - _e632.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e719 = select(_e157, _e715, (_e715 > _e157));
                                                let _e721 = select(_e157, _e716, (_e716 > _e157));
                                                let _e723 = select(_e157, _e717, (_e717 > _e157));
                                                let _e748 = bitcast<u32>((f32(bitcast<i32>((_e655 & 2097151u))) * _e719));
                                                let _e753 = (bitcast<i32>((_e655 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e756 = bitcast<f32>((_e748 & bitcast<u32>(_e753)));
                                                let _e757 = bitcast<u32>((f32(bitcast<i32>((_e670 & 2097151u))) * _e721));
                                                let _e762 = (bitcast<i32>((_e670 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e765 = bitcast<f32>((_e757 & bitcast<u32>(_e762)));
                                                let _e766 = bitcast<u32>((f32(bitcast<i32>((_e685 & 2097151u))) * _e723));
                                                let _e771 = (bitcast<i32>((_e685 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e774 = bitcast<f32>((_e766 & bitcast<u32>(_e771)));
                                                let _e778 = bitcast<f32>((_e748 & bitcast<u32>(~(_e753))));
                                                let _e782 = bitcast<f32>((_e757 & bitcast<u32>(~(_e762))));
                                                let _e786 = bitcast<f32>((_e766 & bitcast<u32>(~(_e771))));
                                                let _e787 = bitcast<u32>((f32(bitcast<i32>((_e662 & 2097151u))) * _e719));
                                                let _e792 = (bitcast<i32>((_e662 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e795 = bitcast<f32>((_e787 & bitcast<u32>(_e792)));
                                                let _e796 = bitcast<u32>((f32(bitcast<i32>((_e677 & 2097151u))) * _e721));
                                                let _e801 = (bitcast<i32>((_e677 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e804 = bitcast<f32>((_e796 & bitcast<u32>(_e801)));
                                                let _e805 = bitcast<u32>((f32(bitcast<i32>((_e692 & 2097151u))) * _e723));
                                                let _e810 = (bitcast<i32>((_e692 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e813 = bitcast<f32>((_e805 & bitcast<u32>(_e810)));
                                                let _e817 = bitcast<f32>((_e787 & bitcast<u32>(~(_e792))));
                                                let _e821 = bitcast<f32>((_e796 & bitcast<u32>(~(_e801))));
                                                let _e825 = bitcast<f32>((_e805 & bitcast<u32>(~(_e810))));
                                                let _e826 = (_e632.member.member.x + _e756);
                                                let _e827 = (_e632.member.member.y + _e765);
                                                let _e828 = (_e632.member.member.z + _e774);
                                                let _e831 = (_e632.member.member_1.x - _e795);
                                                let _e832 = (_e632.member.member_1.y - _e804);
                                                let _e833 = (_e632.member.member_1.z - _e813);
                                                let _e852 = (_e831 - _e826);
                                                let _e853 = (_e832 - _e827);
                                                let _e854 = (_e833 - _e828);
                                                let _e856 = select(_e853, _e852, (_e852 > _e853));
                                                let _e858 = select(_e854, _e856, (_e856 > _e854));
                                                if (_e858 < (1024f * _e157)) {
                                                    phi_3259_ = 0u;
                                                } else {
                                                    phi_3259_ = select(2u, 1u, (_e858 < (2097152f * _e157)));
                                                }
                                                let _e865 = phi_3259_;
                                                switch bitcast<i32>(_e865) {
                                                    case 0: {
                                                        phi_3265_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_3265_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_3265_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_3265_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e868 = phi_3265_;
                                                let _e874 = global_8.member[_e632.member_1][0u];
                                                let _e878 = global_8.member[_e632.member_1][2u];
                                                let _e882 = global_8.member[_e632.member_1][4u];
                                                let _e886 = global_8.member[_e632.member_1][6u];
                                                let _e898 = (((_e878 >> bitcast<u32>(22i)) | ((_e882 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e886 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e899 = (_e874 & 268435455u);
                                                let _e900 = (_e898 & 268435455u);
                                                let _e903 = ((_e874 >> bitcast<u32>(28u)) & 7u);
                                                let _e911 = ((_e874 >> bitcast<u32>(31i)) | (((_e898 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e912 = (_e903 != 0u);
                                                if (_e903 == 0u) {
                                                    phi_3520_ = _e899;
                                                } else {
                                                    if (_e903 == 7u) {
                                                        phi_3519_ = 2147483648u;
                                                    } else {
                                                        phi_3519_ = ((2147483648u | (_e903 << bitcast<u32>(28u))) | (_e900 & 268435455u));
                                                    }
                                                    let _e921 = phi_3519_;
                                                    phi_3520_ = _e921;
                                                }
                                                let _e923 = phi_3520_;
                                                if _e912 {
                                                    let _e924 = (_e903 != 7u);
                                                    if _e924 {
                                                        phi_3530_ = (_e900 + (_e903 * ((3u * _e868) + 1u)));
                                                    } else {
                                                        phi_3530_ = u32();
                                                    }
                                                    let _e928 = phi_3530_;
                                                    phi_3532_ = _e928;
                                                    phi_3533_ = select(true, false, _e924);
                                                } else {
                                                    phi_3532_ = u32();
                                                    phi_3533_ = true;
                                                }
                                                let _e931 = phi_3532_;
                                                let _e933 = phi_3533_;
                                                if (_e911 == 0u) {
                                                    phi_3554_ = (_e899 + select(0u, 1u, !(_e912)));
                                                } else {
                                                    if (_e911 == 7u) {
                                                        phi_3553_ = 2147483648u;
                                                    } else {
                                                        phi_3553_ = ((2147483648u | (_e911 << bitcast<u32>(28u))) | (select(_e931, _e900, _e933) & 268435455u));
                                                    }
                                                    let _e946 = phi_3553_;
                                                    phi_3554_ = _e946;
                                                }
                                                let _e948 = phi_3554_;
                                                phi_3558_ = type_59(array<vec4<f32>, 3>(vec4<f32>(_e826, (_e632.member.member.x + _e778), _e831, (_e632.member.member_1.x - _e817)), vec4<f32>(_e827, (_e632.member.member.y + _e782), _e832, (_e632.member.member_1.y - _e821)), vec4<f32>(_e828, (_e632.member.member.z + _e786), _e833, (_e632.member.member_1.z - _e825))), type_58(type_30((_e632.member.member + vec4<f32>(_e756, _e765, _e774, 0f)), (_e632.member.member_1 - vec4<f32>(_e795, _e804, _e813, 0f))), _e923), type_58(type_30((_e632.member.member + vec4<f32>(_e778, _e782, _e786, 0f)), (_e632.member.member_1 - vec4<f32>(_e817, _e821, _e825, 0f))), _e948));
                                            }
                                            let _e953 = phi_3558_;
                                            let _e965 = ((_e953.member[0].x - _e426) * _e431);
                                            let _e966 = ((_e953.member[0].y - _e426) * _e431);
                                            let _e967 = ((_e953.member[0].z - _e427) * _e431);
                                            let _e968 = ((_e953.member[0].w - _e427) * _e431);
                                            let _e978 = ((_e953.member[1].x - _e462) * _e467);
                                            let _e979 = ((_e953.member[1].y - _e462) * _e467);
                                            let _e980 = ((_e953.member[1].z - _e463) * _e467);
                                            let _e981 = ((_e953.member[1].w - _e463) * _e467);
                                            let _e991 = ((_e953.member[2].x - _e498) * _e503);
                                            let _e992 = ((_e953.member[2].y - _e498) * _e503);
                                            let _e993 = ((_e953.member[2].z - _e499) * _e503);
                                            let _e994 = ((_e953.member[2].w - _e499) * _e503);
                                            let _e996 = select(_e993, _e991, (_e991 < _e993));
                                            let _e998 = select(_e994, _e992, (_e992 < _e994));
                                            let _e1000 = select(_e993, _e991, (_e991 > _e993));
                                            let _e1002 = select(_e994, _e992, (_e992 > _e994));
                                            let _e1004 = select(_e967, _e965, (_e965 < _e967));
                                            let _e1006 = select(_e968, _e966, (_e966 < _e968));
                                            let _e1008 = select(_e980, _e978, (_e978 < _e980));
                                            let _e1010 = select(_e981, _e979, (_e979 < _e981));
                                            let _e1012 = select(_e1008, _e1004, (_e1004 > _e1008));
                                            let _e1014 = select(_e1010, _e1006, (_e1006 > _e1010));
                                            let _e1016 = select(_e996, _e1012, (_e1012 > _e996));
                                            let _e1018 = select(_e998, _e1014, (_e1014 > _e998));
                                            let _e1020 = select(_e967, _e965, (_e965 > _e967));
                                            let _e1022 = select(_e968, _e966, (_e966 > _e968));
                                            let _e1024 = select(_e980, _e978, (_e978 > _e980));
                                            let _e1026 = select(_e981, _e979, (_e979 > _e981));
                                            let _e1028 = select(_e1024, _e1020, (_e1020 < _e1024));
                                            let _e1030 = select(_e1026, _e1022, (_e1022 < _e1026));
                                            let _e1035 = -(_e996);
                                            let _e1036 = -(_e998);
                                            let _e1043 = (select(_e1000, _e1028, (_e1028 < _e1000)) + (select(_e1035, _e1000, (_e1000 > _e1035)) * 0.0000019073523f));
                                            let _e1044 = (select(_e1002, _e1030, (_e1030 < _e1002)) + (select(_e1036, _e1002, (_e1002 > _e1036)) * 0.0000019073523f));
                                            let _e1046 = select(_e549, _e1016, (_e1016 > _e549));
                                            let _e1048 = select(_e549, _e1018, (_e1018 > _e549));
                                            let _e1053 = (_e1046 <= select(_e593.member, _e1043, (_e1043 < _e593.member)));
                                            let _e1054 = (_e1048 <= select(_e593.member, _e1044, (_e1044 < _e593.member)));
                                            let _e1055 = (_e1046 <= _e1048);
                                            if _e1053 {
                                                if _e1054 {
                                                    if _e1055 {
                                                        phi_3902_ = _e953.member_2;
                                                    } else {
                                                        phi_3902_ = _e953.member_1;
                                                    }
                                                    let _e1059 = phi_3902_;
                                                    let _e1081 = (_e636 % 128u);
                                                    let _e1082 = (_e1081 < 128u);
                                                    if _e1082 {
                                                    } else {
                                                        phi_4445_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1081] = _e1059.member_1;
                                                    if _e1082 {
                                                    } else {
                                                        phi_4445_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1081] = _e1059.member.member.x;
                                                    if _e1082 {
                                                    } else {
                                                        phi_4445_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1081] = _e1059.member.member.y;
                                                    if _e1082 {
                                                    } else {
                                                        phi_4445_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1081] = _e1059.member.member.z;
                                                    if _e1082 {
                                                    } else {
                                                        phi_4445_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1081] = _e1059.member.member_1.x;
                                                    if _e1082 {
                                                    } else {
                                                        phi_4445_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1081] = _e1059.member.member_1.y;
                                                    if _e1082 {
                                                    } else {
                                                        phi_4445_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1081] = _e1059.member.member_1.z;
                                                    if _e1082 {
                                                    } else {
                                                        phi_4445_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1081] = select(_e1048, _e1046, (_e1046 > _e1048));
                                                    if _e1055 {
                                                        phi_3979_ = _e953.member_1;
                                                    } else {
                                                        phi_3979_ = _e953.member_2;
                                                    }
                                                    let _e1095 = phi_3979_;
                                                    phi_3980_ = _e1095;
                                                    phi_3981_ = (_e636 + 1u);
                                                } else {
                                                    phi_3980_ = type_58();
                                                    phi_3981_ = u32();
                                                }
                                                let _e1097 = phi_3980_;
                                                let _e1099 = phi_3981_;
                                                phi_3983_ = _e1097;
                                                phi_3984_ = _e1099;
                                                phi_3985_ = select(true, false, _e1054);
                                            } else {
                                                phi_3983_ = type_58();
                                                phi_3984_ = u32();
                                                phi_3985_ = true;
                                            }
                                            let _e1102 = phi_3983_;
                                            let _e1104 = phi_3984_;
                                            let _e1106 = phi_3985_;
                                            if _e1106 {
                                                if _e1053 {
                                                    phi_3994_ = _e953.member_1;
                                                } else {
                                                    phi_3994_ = _e953.member_2;
                                                }
                                                let _e1110 = phi_3994_;
                                                phi_3999_ = _e1110;
                                                phi_4000_ = select(_e1054, true, _e1053);
                                            } else {
                                                phi_3999_ = _e1102;
                                                phi_4000_ = _e634;
                                            }
                                            let _e1113 = phi_3999_;
                                            let _e1115 = phi_4000_;
                                            phi_4449_ = _e591;
                                            phi_4002_ = _e593;
                                            phi_4003_ = _e1113;
                                            phi_4004_ = _e1115;
                                            phi_4005_ = select(_e1104, _e636, _e1106);
                                        }
                                        let _e2076 = phi_4449_;
                                        let _e2078 = phi_4002_;
                                        let _e2080 = phi_4003_;
                                        let _e2082 = phi_4004_;
                                        let _e2084 = phi_4005_;
                                        phi_4448_ = _e2076;
                                        phi_4006_ = _e2078;
                                        phi_4007_ = _e2080;
                                        phi_4008_ = (_e597 - 1u);
                                        phi_4009_ = _e2082;
                                        phi_4010_ = _e2084;
                                    } else {
                                        phi_4448_ = _e591;
                                        phi_4006_ = _e593;
                                        phi_4007_ = _e632;
                                        phi_4008_ = _e597;
                                        phi_4009_ = _e634;
                                        phi_4010_ = _e636;
                                    }
                                    let _e2086 = phi_4448_;
                                    let _e2088 = phi_4006_;
                                    let _e2090 = phi_4007_;
                                    let _e2092 = phi_4008_;
                                    let _e2094 = phi_4009_;
                                    let _e2096 = phi_4010_;
                                    phi_4447_ = _e2086;
                                    phi_4011_ = _e2088;
                                    phi_4012_ = _e2090;
                                    phi_4013_ = _e2092;
                                    phi_4014_ = _e2094;
                                    phi_4015_ = _e2096;
                                } else {
                                    phi_4447_ = _e591;
                                    phi_4011_ = type_42();
                                    phi_4012_ = type_58();
                                    phi_4013_ = u32();
                                    phi_4014_ = bool();
                                    phi_4015_ = u32();
                                }
                                let _e2098 = phi_4447_;
                                let _e2100 = phi_4011_;
                                let _e2102 = phi_4012_;
                                let _e2104 = phi_4013_;
                                let _e2106 = phi_4014_;
                                let _e2108 = phi_4015_;
                                phi_4446_ = _e2098;
                                phi_1005_ = _e2100;
                                phi_1008_ = _e2102;
                                phi_1010_ = _e2104;
                                phi_1012_ = _e2106;
                                phi_1014_ = _e2108;
                                phi_4016_ = _e605;
                            } else {
                                phi_4446_ = _e591;
                                phi_1005_ = type_42();
                                phi_1008_ = type_58();
                                phi_1010_ = u32();
                                phi_1012_ = bool();
                                phi_1014_ = u32();
                                phi_4016_ = false;
                            }
                            let _e2110 = phi_4446_;
                            let _e2112 = phi_1005_;
                            let _e2114 = phi_1008_;
                            let _e2116 = phi_1010_;
                            let _e2118 = phi_1012_;
                            let _e2120 = phi_1014_;
                            let _e2122 = phi_4016_;
                            continue;
                            continuing {
                                phi_4266_ = _e2110;
                                phi_1004_ = _e2112;
                                phi_1007_ = _e2114;
                                phi_1009_ = _e2116;
                                phi_1011_ = _e2118;
                                phi_1013_ = _e2120;
                                phi_4445_ = _e2110;
                                break if !(_e2122);
                            }
                        }
                        let _e2125 = phi_4445_;
                        if _e2125 {
                            break;
                        }
                        let _e2127 = local_11;
                        if _e2127.member_1 {
                        } else {
                            if _e239 {
                            } else {
                                break;
                            }
                            let _e2131 = global_2.member[_e145];
                            if _e160 {
                            } else {
                                break;
                            }
                            let _e2135 = global_9.member[_e145].member_1;
                            if _e239 {
                            } else {
                                break;
                            }
                            global_2.member[_e145] = type_23(_e2131.member, _e2131.member_1, _e2131.member_2, array<f32, 3>((_e2131.member_3[0] + (_e2135[0] * _e2131.member_1[0])), (_e2131.member_3[1] + (_e2135[1] * _e2131.member_1[1])), (_e2131.member_3[2] + (_e2135[2] * _e2131.member_1[2]))), _e2131.member_4);
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
fn trace_shadows_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
