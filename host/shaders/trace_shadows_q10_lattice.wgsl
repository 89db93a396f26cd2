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

struct type_25 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
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
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_35 {
    member: type_26,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_37 {
    member: array<type_35>,
}

struct type_40 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_46 {
    member: f32,
    member_1: bool,
}

struct type_48 {
    member: array<vec4<u32>, 2>,
}

struct type_51 {
    member: array<i32>,
}

struct type_58 {
    member: type_34,
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
var<uniform> global_1: type_16;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_29;
@group(0) @binding(1) 
var<uniform> global_3: type_48;
@group(0) @binding(2) 
var<uniform> global_4: type_48;
@group(0) @binding(3) 
var<storage> global_5: type_13;
@group(0) @binding(5) 
var<storage> global_6: type_4;
@group(0) @binding(6) 
var<storage> global_7: type_51;
@group(0) @binding(9) 
var<storage, read_write> global_8: type_64;
@group(0) @binding(7) 
var<storage> global_9: type_37;
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
    var phi_396_: type_40;
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
    var phi_1004_: type_46;
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
    var phi_1131_: type_46;
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
    var phi_2402_: type_25;
    var phi_2404_: type_25;
    var phi_2405_: bool;
    var phi_2409_: type_25;
    var phi_2410_: type_25;
    var phi_2411_: type_25;
    var phi_2412_: bool;
    var phi_2416_: type_25;
    var phi_2417_: bool;
    var phi_2421_: type_25;
    var phi_2422_: bool;
    var phi_2426_: type_25;
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
    var phi_2760_: type_46;
    var phi_2761_: type_46;
    var phi_1132_: type_46;
    var phi_4260_: bool;
    var local_10: type_46;
    var phi_4449_: bool;
    var phi_4002_: type_46;
    var phi_4003_: type_58;
    var phi_4004_: bool;
    var phi_4005_: u32;
    var phi_4448_: bool;
    var phi_4006_: type_46;
    var phi_4007_: type_58;
    var phi_4008_: u32;
    var phi_4009_: bool;
    var phi_4010_: u32;
    var phi_4447_: bool;
    var phi_4011_: type_46;
    var phi_4012_: type_58;
    var phi_4013_: u32;
    var phi_4014_: bool;
    var phi_4015_: u32;
    var phi_4446_: bool;
    var phi_1005_: type_46;
    var phi_1008_: type_58;
    var phi_1010_: u32;
    var phi_1012_: bool;
    var phi_1014_: u32;
    var phi_4016_: bool;
    var phi_4445_: bool;
    var local_11: type_46;
    var local_12: type_46;

    switch bitcast<i32>(0u) {
        default: {
            let _e98 = global;
            let _e100 = arrayLength((&global_5.member));
            let _e103 = arrayLength((&global_10.member));
            let _e115 = arrayLength((&global_8.member));
            let _e119 = global_4.member[0u][0u];
            let _e123 = global_4.member[0u][1u];
            let _e127 = global_4.member[0u][2u];
            let _e131 = global_4.member[0u][3u];
            let _e135 = global_4.member[1u][0u];
            let _e139 = global_4.member[1u][1u];
            let _e143 = global_4.member[1u][2u];
            let _e147 = (_e98.x + (_e98.y * 2097152u));
            let _e159 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e131) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e119), bitcast<i32>(_e123), bitcast<i32>(_e127));
            local = array<i32, 3>(bitcast<i32>(_e135), bitcast<i32>(_e139), bitcast<i32>(_e143));
            let _e162 = (_e147 < arrayLength((&global_9.member)));
            if _e162 {
                if _e162 {
                } else {
                    break;
                }
                let _e166 = global_9.member[_e147].member_2;
                phi_328_ = _e166;
            } else {
                phi_328_ = 4294967295u;
            }
            let _e168 = phi_328_;
            let _e171 = global_1.member[0u];
            let _e175 = global_3.member[0u][0u];
            let _e179 = global_3.member[0u][1u];
            let _e183 = global_3.member[0u][2u];
            let _e187 = global_3.member[0u][3u];
            let _e191 = global_3.member[1u][0u];
            let _e195 = global_3.member[1u][1u];
            let _e199 = global_3.member[1u][2u];
            let _e203 = global_3.member[1u][3u];
            let _e204 = bitcast<f32>(_e175);
            let _e205 = bitcast<f32>(_e179);
            let _e206 = bitcast<f32>(_e183);
            let _e208 = bitcast<f32>(_e191);
            let _e209 = array<u32, 3>(_e195, _e199, _e203);
            let _e211 = bitcast<i32>(_e171);
            if (_e211 < -126i) {
                phi_372_ = -126i;
            } else {
                phi_372_ = select(_e211, 127i, (_e211 > 127i));
            }
            let _e216 = phi_372_;
            let _e221 = bitcast<f32>((bitcast<u32>((_e216 + 127i)) << bitcast<u32>(23i)));
            let _e227 = bitcast<f32>((bitcast<u32>(((_e211 - _e216) + 127i)) << bitcast<u32>(23i)));
            if (_e187 == 0u) {
                phi_396_ = type_40(array<f32, 3>(_e204, _e205, _e206), _e187, _e208, _e209);
            } else {
                phi_396_ = type_40(array<f32, 3>(((_e204 * _e221) * _e227), ((_e205 * _e221) * _e227), ((_e206 * _e221) * _e227)), _e187, ((_e208 * _e221) * _e227), _e209);
            }
            let _e240 = phi_396_;
            if _e162 {
                let _e241 = (_e147 < arrayLength((&global_2.member)));
                if _e241 {
                    if _e162 {
                    } else {
                        break;
                    }
                    let _e246 = global_9.member[_e147].member.member_1;
                    let _e251 = global_9.member[_e147].member.member_3;
                    if (_e246 <= _e251) {
                        let _e253 = (1u < _e115);
                        if _e253 {
                            if (0u < _e115) {
                            } else {
                                break;
                            }
                            let _e257 = atomicAdd((&global_8.member[0u]), 1u);
                            if ((_e257 + 1u) < _e257) {
                                if _e253 {
                                } else {
                                    break;
                                }
                                let _e262 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                        if _e162 {
                        } else {
                            break;
                        }
                        let _e272 = global_9.member[_e147].member.member_2[0u];
                        let _e274 = (bitcast<u32>(_e272) & 2147483647u);
                        let _e280 = global_9.member[_e147].member.member_2[1u];
                        let _e282 = (bitcast<u32>(_e280) & 2147483647u);
                        let _e288 = global_9.member[_e147].member.member_2[2u];
                        let _e290 = (bitcast<u32>(_e288) & 2147483647u);
                        let _e296 = global_9.member[_e147].member.member[0u];
                        let _e298 = (bitcast<u32>(_e296) & 2147483647u);
                        let _e304 = global_9.member[_e147].member.member[1u];
                        let _e306 = (bitcast<u32>(_e304) & 2147483647u);
                        let _e312 = global_9.member[_e147].member.member[2u];
                        let _e314 = (bitcast<u32>(_e312) & 2147483647u);
                        let _e316 = select(_e282, _e274, (_e282 < _e274));
                        let _e318 = select(_e290, _e316, (_e290 < _e316));
                        let _e320 = select(_e298, _e318, (_e298 < _e318));
                        let _e322 = select(_e306, _e320, (_e306 < _e320));
                        let _e324 = select(_e314, _e322, (_e314 < _e322));
                        let _e326 = (bitcast<u32>(_e246) & 2147483647u);
                        let _e335 = (((select(_e326, _e324, (_e326 < _e324)) < 2139095040u) && ((bitcast<u32>(_e251) & 2147483647u) <= 2139095040u)) && (_e318 > 0u));
                        if _e335 {
                            let _e338 = (bitcast<u32>(bitcast<f32>(_e318)) & 2147483647u);
                            if (_e338 >= 8388608u) {
                                phi_546_ = (bitcast<i32>((_e338 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_546_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e338)), 32u, (_e338 == 0u))));
                            }
                            let _e352 = phi_546_;
                            phi_547_ = _e352;
                        } else {
                            phi_547_ = 0i;
                        }
                        let _e354 = phi_547_;
                        let _e355 = (_e274 == _e318);
                        if _e355 {
                            phi_557_ = true;
                        } else {
                            phi_557_ = (_e282 == _e318);
                        }
                        let _e358 = phi_557_;
                        let _e359 = select(1u, 0u, _e355);
                        if _e358 {
                            let _e360 = (_e359 + 1u);
                            phi_567_ = _e360;
                            phi_568_ = _e360;
                            phi_570_ = select(true, false, (_e360 == 2u));
                        } else {
                            phi_567_ = u32();
                            phi_568_ = 0u;
                            phi_570_ = true;
                        }
                        let _e364 = phi_567_;
                        let _e366 = phi_568_;
                        let _e368 = phi_570_;
                        if _e368 {
                            phi_575_ = (_e366 + 1u);
                        } else {
                            phi_575_ = 0u;
                        }
                        let _e372 = phi_575_;
                        let _e373 = select(_e364, _e366, _e368);
                        let _e374 = select(_e359, select(2u, _e359, _e358), _e368);
                        let _e375 = -(_e354);
                        if (_e375 < -126i) {
                            phi_607_ = -126i;
                        } else {
                            phi_607_ = select(_e375, 127i, (_e375 > 127i));
                        }
                        let _e380 = phi_607_;
                        let _e385 = bitcast<f32>((bitcast<u32>((_e380 + 127i)) << bitcast<u32>(23i)));
                        let _e391 = bitcast<f32>((bitcast<u32>(((_e375 - _e380) + 127i)) << bitcast<u32>(23i)));
                        let _e396 = global_9.member[_e147].member.member;
                        let _e397 = (_e373 == 0u);
                        if _e397 {
                            phi_625_ = _e396[0];
                        } else {
                            phi_625_ = _e396[1];
                        }
                        let _e401 = phi_625_;
                        let _e402 = (_e373 == 2u);
                        if _e402 {
                            phi_631_ = _e396[2];
                        } else {
                            phi_631_ = _e401;
                        }
                        let _e405 = phi_631_;
                        let _e406 = global_9.member[_e147].member.member_2;
                        if _e397 {
                            phi_642_ = _e406[0];
                        } else {
                            phi_642_ = _e406[1];
                        }
                        let _e410 = phi_642_;
                        if _e402 {
                            phi_648_ = _e406[2];
                        } else {
                            phi_648_ = _e410;
                        }
                        let _e413 = phi_648_;
                        let _e415 = ((_e413 * _e385) * _e391);
                        let _e419 = (bitcast<f32>((bitcast<u32>(_e415) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e419 {
                            let _e423 = (bitcast<f32>((bitcast<u32>(_e405) & 2147483647u)) * 0.00000011920929f);
                            phi_671_ = select(0.00000000000011368684f, _e423, (_e423 > 0.00000000000011368684f));
                        } else {
                            phi_671_ = 0f;
                        }
                        let _e427 = phi_671_;
                        let _e428 = (_e405 + _e427);
                        let _e429 = (_e405 - _e427);
                        let _e430 = select(_e415, 0f, _e419);
                        if _e419 {
                            phi_682_ = 38685626000000000000000000f;
                        } else {
                            phi_682_ = (1f / _e415);
                        }
                        let _e433 = phi_682_;
                        let _e434 = (_e372 == 0u);
                        if _e434 {
                            phi_691_ = _e396[0];
                        } else {
                            phi_691_ = _e396[1];
                        }
                        let _e438 = phi_691_;
                        let _e439 = (_e372 == 2u);
                        if _e439 {
                            phi_697_ = _e396[2];
                        } else {
                            phi_697_ = _e438;
                        }
                        let _e442 = phi_697_;
                        if _e434 {
                            phi_708_ = _e406[0];
                        } else {
                            phi_708_ = _e406[1];
                        }
                        let _e446 = phi_708_;
                        if _e439 {
                            phi_714_ = _e406[2];
                        } else {
                            phi_714_ = _e446;
                        }
                        let _e449 = phi_714_;
                        let _e451 = ((_e449 * _e385) * _e391);
                        let _e455 = (bitcast<f32>((bitcast<u32>(_e451) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e455 {
                            let _e459 = (bitcast<f32>((bitcast<u32>(_e442) & 2147483647u)) * 0.00000011920929f);
                            phi_737_ = select(0.00000000000011368684f, _e459, (_e459 > 0.00000000000011368684f));
                        } else {
                            phi_737_ = 0f;
                        }
                        let _e463 = phi_737_;
                        let _e464 = (_e442 + _e463);
                        let _e465 = (_e442 - _e463);
                        let _e466 = select(_e451, 0f, _e455);
                        if _e455 {
                            phi_748_ = 38685626000000000000000000f;
                        } else {
                            phi_748_ = (1f / _e451);
                        }
                        let _e469 = phi_748_;
                        let _e470 = (_e374 == 0u);
                        if _e470 {
                            phi_757_ = _e396[0];
                        } else {
                            phi_757_ = _e396[1];
                        }
                        let _e474 = phi_757_;
                        let _e475 = (_e374 == 2u);
                        if _e475 {
                            phi_763_ = _e396[2];
                        } else {
                            phi_763_ = _e474;
                        }
                        let _e478 = phi_763_;
                        if _e470 {
                            phi_774_ = _e406[0];
                        } else {
                            phi_774_ = _e406[1];
                        }
                        let _e482 = phi_774_;
                        if _e475 {
                            phi_780_ = _e406[2];
                        } else {
                            phi_780_ = _e482;
                        }
                        let _e485 = phi_780_;
                        let _e487 = ((_e485 * _e385) * _e391);
                        let _e491 = (bitcast<f32>((bitcast<u32>(_e487) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e491 {
                            let _e495 = (bitcast<f32>((bitcast<u32>(_e478) & 2147483647u)) * 0.00000011920929f);
                            phi_803_ = select(0.00000000000011368684f, _e495, (_e495 > 0.00000000000011368684f));
                        } else {
                            phi_803_ = 0f;
                        }
                        let _e499 = phi_803_;
                        let _e500 = (_e478 + _e499);
                        let _e501 = (_e478 - _e499);
                        let _e502 = select(_e487, 0f, _e491);
                        if _e491 {
                            phi_814_ = 38685626000000000000000000f;
                        } else {
                            phi_814_ = (1f / _e487);
                        }
                        let _e505 = phi_814_;
                        let _e508 = bitcast<f32>((bitcast<u32>(_e405) & 2147483647u));
                        let _e511 = bitcast<f32>((bitcast<u32>(_e442) & 2147483647u));
                        let _e513 = select(_e511, _e508, (_e508 > _e511));
                        let _e516 = bitcast<f32>((bitcast<u32>(_e478) & 2147483647u));
                        if (_e335 && (select(_e516, _e513, (_e513 > _e516)) <= 1099511600000f)) {
                            let _e521 = (_e354 / 3i);
                            let _e528 = bitcast<f32>((bitcast<u32>((_e521 + 127i)) << bitcast<u32>(23i)));
                            let _e535 = bitcast<f32>((bitcast<u32>(((_e354 - (2i * _e521)) + 127i)) << bitcast<u32>(23i)));
                            let _e536 = (((_e246 * _e528) * _e528) * _e535);
                            let _e538 = select(340282350000000000000000000000000000000f, _e536, (_e536 < 340282350000000000000000000000000000000f));
                            let _e543 = (((_e251 * _e528) * _e528) * _e535);
                            let _e545 = select(340282350000000000000000000000000000000f, _e543, (_e543 < 340282350000000000000000000000000000000f));
                            phi_914_ = select(-340282350000000000000000000000000000000f, _e545, (_e545 > -340282350000000000000000000000000000000f));
                            phi_915_ = select(-340282350000000000000000000000000000000f, _e538, (_e538 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_914_ = 0f;
                            phi_915_ = 1f;
                        }
                        let _e549 = phi_914_;
                        let _e551 = phi_915_;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e555 = (_e373 % 3u);
                        let _e556 = (_e555 < 3u);
                        if _e556 {
                        } else {
                            break;
                        }
                        let _e558 = local_1[_e555];
                        let _e561 = (_e372 % 3u);
                        let _e562 = (_e561 < 3u);
                        if _e562 {
                        } else {
                            break;
                        }
                        let _e564 = local_1[_e561];
                        let _e567 = (_e374 % 3u);
                        let _e568 = (_e567 < 3u);
                        if _e568 {
                        } else {
                            break;
                        }
                        let _e570 = local_1[_e567];
                        if _e556 {
                        } else {
                            break;
                        }
                        let _e575 = local[_e555];
                        if _e562 {
                        } else {
                            break;
                        }
                        let _e579 = local[_e561];
                        if _e568 {
                        } else {
                            break;
                        }
                        let _e583 = local[_e567];
                        phi_4266_ = false;
                        phi_1004_ = type_46(_e549, false);
                        phi_1007_ = type_58(type_34(vec4<f32>((f32(_e558) * _e159), (f32(_e564) * _e159), (f32(_e570) * _e159), 0f), vec4<f32>((f32(_e575) * _e159), (f32(_e579) * _e159), (f32(_e583) * _e159), 0f)), select(0u, 2147483648u, (_e100 == 0u)));
                        phi_1009_ = ((3u * _e100) + 1u);
                        phi_1011_ = (_e551 <= _e549);
                        phi_1013_ = 0u;
                        loop {
                            let _e593 = phi_4266_;
                            let _e595 = phi_1004_;
                            let _e597 = phi_1007_;
                            let _e599 = phi_1009_;
                            let _e601 = phi_1011_;
                            let _e603 = phi_1013_;
                            local_11 = _e595;
                            if _e601 {
                                phi_1024_ = true;
                            } else {
                                phi_1024_ = (_e603 > 0u);
                            }
                            let _e606 = phi_1024_;
                            if _e606 {
                                let _e607 = (_e599 > 0u);
                                if _e607 {
                                    if _e601 {
                                        phi_1110_ = _e597;
                                        phi_1111_ = _e601;
                                        phi_1112_ = _e603;
                                    } else {
                                        let _e608 = (_e603 - 1u);
                                        let _e609 = (_e608 % 128u);
                                        let _e610 = (_e609 < 128u);
                                        if _e610 {
                                        } else {
                                            phi_4445_ = true;
                                            break;
                                        }
                                        let _e612 = local_7[_e609];
                                        if _e610 {
                                        } else {
                                            phi_4445_ = true;
                                            break;
                                        }
                                        let _e614 = local_6[_e609];
                                        if _e610 {
                                        } else {
                                            phi_4445_ = true;
                                            break;
                                        }
                                        let _e616 = local_5[_e609];
                                        if _e610 {
                                        } else {
                                            phi_4445_ = true;
                                            break;
                                        }
                                        let _e618 = local_4[_e609];
                                        if _e610 {
                                        } else {
                                            phi_4445_ = true;
                                            break;
                                        }
                                        let _e620 = local_3[_e609];
                                        if _e610 {
                                        } else {
                                            phi_4445_ = true;
                                            break;
                                        }
                                        let _e622 = local_2[_e609];
                                        if _e610 {
                                        } else {
                                            phi_4445_ = true;
                                            break;
                                        }
                                        let _e627 = local_8[_e609];
                                        if _e610 {
                                        } else {
                                            phi_4445_ = true;
                                            break;
                                        }
                                        let _e630 = local_9[_e609];
                                        phi_1110_ = type_58(type_34(vec4<f32>(_e612, _e614, _e616, 0f), vec4<f32>(_e618, _e620, _e622, 0f)), _e627);
                                        phi_1111_ = (_e630 <= _e595.member);
                                        phi_1112_ = _e608;
                                    }
                                    let _e634 = phi_1110_;
                                    let _e636 = phi_1111_;
                                    let _e638 = phi_1112_;
                                    if _e636 {
                                        let _e643 = (_e634.member_1 & 268435455u);
                                        if ((_e634.member_1 & 2147483648u) != 0u) {
                                            phi_1131_ = _e595;
                                            phi_1134_ = type_8(0u, ((_e634.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1103 = phi_1131_;
                                                let _e1105 = phi_1134_;
                                                local_10 = _e1103;
                                                local_12 = _e1103;
                                                if (_e1105.member < _e1105.member_1) {
                                                    phi_1135_ = type_8((_e1105.member + 1u), _e1105.member_1);
                                                    phi_1157_ = type_8(1u, _e1105.member);
                                                } else {
                                                    phi_1135_ = _e1105;
                                                    phi_1157_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1118 = phi_1135_;
                                                let _e1120 = phi_1157_;
                                                let _e1124 = (bitcast<i32>(_e1120.member) != 0i);
                                                if _e1124 {
                                                    let _e1129 = (_e634.member.member_1.x - _e634.member.member.x);
                                                    let _e1132 = (_e634.member.member_1.y - _e634.member.member.y);
                                                    let _e1135 = (_e634.member.member_1.z - _e634.member.member.z);
                                                    let _e1137 = select(_e1132, _e1129, (_e1129 > _e1132));
                                                    let _e1139 = select(_e1135, _e1137, (_e1137 > _e1135));
                                                    let _e1141 = (_e1139 < (1024f * _e159));
                                                    if _e1141 {
                                                        phi_1198_ = 0u;
                                                    } else {
                                                        phi_1198_ = select(2u, 1u, (_e1139 < (2097152f * _e159)));
                                                    }
                                                    let _e1146 = phi_1198_;
                                                    switch bitcast<i32>(_e1146) {
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
                                                    let _e1149 = phi_1204_;
                                                    switch bitcast<i32>(_e1146) {
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
                                                    let _e1156 = phi_1214_;
                                                    let _e1158 = ((_e643 + (_e1120.member_1 * ((3u * _e1149) + 1u))) + (3u * _e1156));
                                                    let _e1159 = (_e1158 < _e103);
                                                    if _e1159 {
                                                        if _e1159 {
                                                        } else {
                                                            phi_4260_ = true;
                                                            break;
                                                        }
                                                        let _e1161 = global_10.member[_e1158];
                                                        phi_1230_ = _e1161;
                                                    } else {
                                                        phi_1230_ = 4294967295u;
                                                    }
                                                    let _e1163 = phi_1230_;
                                                    if _e1141 {
                                                        phi_1263_ = 0u;
                                                    } else {
                                                        phi_1263_ = select(2u, 1u, (_e1139 < (2097152f * _e159)));
                                                    }
                                                    let _e1168 = phi_1263_;
                                                    switch bitcast<i32>(_e1168) {
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
                                                    let _e1171 = phi_1269_;
                                                    let _e1175 = (_e643 + (_e1120.member_1 * ((3u * _e1171) + 1u)));
                                                    switch bitcast<i32>(_e1168) {
                                                        case 0: {
                                                            let _e1441 = (_e1175 < _e103);
                                                            if _e1441 {
                                                                if _e1441 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1443 = global_10.member[_e1175];
                                                                phi_1293_ = _e1443;
                                                            } else {
                                                                phi_1293_ = 0u;
                                                            }
                                                            let _e1445 = phi_1293_;
                                                            let _e1447 = ((10u * _e373) & 31u);
                                                            let _e1456 = ((10u * _e372) & 31u);
                                                            let _e1465 = ((10u * _e374) & 31u);
                                                            let _e1474 = (_e1175 + 1u);
                                                            let _e1475 = (_e1474 < _e103);
                                                            if _e1475 {
                                                                if _e1475 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1477 = global_10.member[_e1474];
                                                                phi_1336_ = _e1477;
                                                            } else {
                                                                phi_1336_ = 0u;
                                                            }
                                                            let _e1479 = phi_1336_;
                                                            let _e1502 = (_e1175 + 2u);
                                                            let _e1503 = (_e1502 < _e103);
                                                            if _e1503 {
                                                                if _e1503 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1505 = global_10.member[_e1502];
                                                                phi_1379_ = _e1505;
                                                            } else {
                                                                phi_1379_ = 0u;
                                                            }
                                                            let _e1507 = phi_1379_;
                                                            phi_1850_ = array<array<f32, 3>, 3>(array<f32, 3>((_e634.member.member.x + (f32(bitcast<i32>(((_e1445 >> bitcast<u32>(_e1447)) & 1023u))) * _e159)), (_e634.member.member.y + (f32(bitcast<i32>(((_e1445 >> bitcast<u32>(_e1456)) & 1023u))) * _e159)), (_e634.member.member.z + (f32(bitcast<i32>(((_e1445 >> bitcast<u32>(_e1465)) & 1023u))) * _e159))), array<f32, 3>((_e634.member.member.x + (f32(bitcast<i32>(((_e1479 >> bitcast<u32>(_e1447)) & 1023u))) * _e159)), (_e634.member.member.y + (f32(bitcast<i32>(((_e1479 >> bitcast<u32>(_e1456)) & 1023u))) * _e159)), (_e634.member.member.z + (f32(bitcast<i32>(((_e1479 >> bitcast<u32>(_e1465)) & 1023u))) * _e159))), array<f32, 3>((_e634.member.member.x + (f32(bitcast<i32>(((_e1507 >> bitcast<u32>(_e1447)) & 1023u))) * _e159)), (_e634.member.member.y + (f32(bitcast<i32>(((_e1507 >> bitcast<u32>(_e1456)) & 1023u))) * _e159)), (_e634.member.member.z + (f32(bitcast<i32>(((_e1507 >> bitcast<u32>(_e1465)) & 1023u))) * _e159))));
                                                            break;
                                                        }
                                                        case 1: {
                                                            let _e1264 = (_e1175 < _e103);
                                                            if _e1264 {
                                                                if _e1264 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1266 = global_10.member[_e1175];
                                                                phi_1422_ = _e1266;
                                                            } else {
                                                                phi_1422_ = 0u;
                                                            }
                                                            let _e1268 = phi_1422_;
                                                            let _e1269 = (_e1175 + 1u);
                                                            let _e1270 = (_e1269 < _e103);
                                                            if _e1270 {
                                                                if _e1270 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1272 = global_10.member[_e1269];
                                                                phi_1437_ = _e1272;
                                                            } else {
                                                                phi_1437_ = 0u;
                                                            }
                                                            let _e1274 = phi_1437_;
                                                            let _e1275 = (_e373 == 1u);
                                                            if _e1275 {
                                                                phi_1447_ = ((_e1268 >> bitcast<u32>(21i)) | (_e1274 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1447_ = (_e1274 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1284 = phi_1447_;
                                                            let _e1291 = (_e372 == 1u);
                                                            if _e1291 {
                                                                phi_1467_ = ((_e1268 >> bitcast<u32>(21i)) | (_e1274 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1467_ = (_e1274 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1300 = phi_1467_;
                                                            let _e1307 = (_e374 == 1u);
                                                            if _e1307 {
                                                                phi_1487_ = ((_e1268 >> bitcast<u32>(21i)) | (_e1274 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1487_ = (_e1274 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1316 = phi_1487_;
                                                            let _e1324 = (_e1175 + 2u);
                                                            let _e1325 = (_e1324 < _e103);
                                                            if _e1325 {
                                                                if _e1325 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1327 = global_10.member[_e1324];
                                                                phi_1513_ = _e1327;
                                                            } else {
                                                                phi_1513_ = 0u;
                                                            }
                                                            let _e1329 = phi_1513_;
                                                            let _e1330 = (_e1175 + 3u);
                                                            let _e1331 = (_e1330 < _e103);
                                                            if _e1331 {
                                                                if _e1331 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1333 = global_10.member[_e1330];
                                                                phi_1528_ = _e1333;
                                                            } else {
                                                                phi_1528_ = 0u;
                                                            }
                                                            let _e1335 = phi_1528_;
                                                            if _e1275 {
                                                                phi_1538_ = ((_e1329 >> bitcast<u32>(21i)) | (_e1335 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1538_ = (_e1335 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1344 = phi_1538_;
                                                            if _e1291 {
                                                                phi_1558_ = ((_e1329 >> bitcast<u32>(21i)) | (_e1335 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1558_ = (_e1335 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1359 = phi_1558_;
                                                            if _e1307 {
                                                                phi_1578_ = ((_e1329 >> bitcast<u32>(21i)) | (_e1335 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1578_ = (_e1335 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1374 = phi_1578_;
                                                            let _e1382 = (_e1175 + 4u);
                                                            let _e1383 = (_e1382 < _e103);
                                                            if _e1383 {
                                                                if _e1383 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1385 = global_10.member[_e1382];
                                                                phi_1604_ = _e1385;
                                                            } else {
                                                                phi_1604_ = 0u;
                                                            }
                                                            let _e1387 = phi_1604_;
                                                            let _e1388 = (_e1175 + 5u);
                                                            let _e1389 = (_e1388 < _e103);
                                                            if _e1389 {
                                                                if _e1389 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1391 = global_10.member[_e1388];
                                                                phi_1619_ = _e1391;
                                                            } else {
                                                                phi_1619_ = 0u;
                                                            }
                                                            let _e1393 = phi_1619_;
                                                            if _e1275 {
                                                                phi_1629_ = ((_e1387 >> bitcast<u32>(21i)) | (_e1393 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1629_ = (_e1393 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1402 = phi_1629_;
                                                            if _e1291 {
                                                                phi_1649_ = ((_e1387 >> bitcast<u32>(21i)) | (_e1393 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1649_ = (_e1393 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1417 = phi_1649_;
                                                            if _e1307 {
                                                                phi_1669_ = ((_e1387 >> bitcast<u32>(21i)) | (_e1393 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1669_ = (_e1393 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1432 = phi_1669_;
                                                            phi_1850_ = array<array<f32, 3>, 3>(array<f32, 3>((_e634.member.member.x + (f32(bitcast<i32>((select(_e1284, _e1268, _e397) & 2097151u))) * _e159)), (_e634.member.member.y + (f32(bitcast<i32>((select(_e1300, _e1268, _e434) & 2097151u))) * _e159)), (_e634.member.member.z + (f32(bitcast<i32>((select(_e1316, _e1268, _e470) & 2097151u))) * _e159))), array<f32, 3>((_e634.member.member.x + (f32(bitcast<i32>((select(_e1344, _e1329, _e397) & 2097151u))) * _e159)), (_e634.member.member.y + (f32(bitcast<i32>((select(_e1359, _e1329, _e434) & 2097151u))) * _e159)), (_e634.member.member.z + (f32(bitcast<i32>((select(_e1374, _e1329, _e470) & 2097151u))) * _e159))), array<f32, 3>((_e634.member.member.x + (f32(bitcast<i32>((select(_e1402, _e1387, _e397) & 2097151u))) * _e159)), (_e634.member.member.y + (f32(bitcast<i32>((select(_e1417, _e1387, _e434) & 2097151u))) * _e159)), (_e634.member.member.z + (f32(bitcast<i32>((select(_e1432, _e1387, _e470) & 2097151u))) * _e159))));
                                                            break;
                                                        }
                                                        case 2: {
                                                            let _e1177 = (_e1175 + _e373);
                                                            let _e1178 = (_e1177 < _e103);
                                                            if _e1178 {
                                                                if _e1178 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1180 = global_10.member[_e1177];
                                                                phi_1696_ = _e1180;
                                                            } else {
                                                                phi_1696_ = 0u;
                                                            }
                                                            let _e1182 = phi_1696_;
                                                            let _e1186 = (_e1175 + _e372);
                                                            let _e1187 = (_e1186 < _e103);
                                                            if _e1187 {
                                                                if _e1187 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1189 = global_10.member[_e1186];
                                                                phi_1714_ = _e1189;
                                                            } else {
                                                                phi_1714_ = 0u;
                                                            }
                                                            let _e1191 = phi_1714_;
                                                            let _e1195 = (_e1175 + _e374);
                                                            let _e1196 = (_e1195 < _e103);
                                                            if _e1196 {
                                                                if _e1196 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1198 = global_10.member[_e1195];
                                                                phi_1732_ = _e1198;
                                                            } else {
                                                                phi_1732_ = 0u;
                                                            }
                                                            let _e1200 = phi_1732_;
                                                            let _e1205 = (_e1175 + 3u);
                                                            let _e1206 = (_e1205 + _e373);
                                                            let _e1207 = (_e1206 < _e103);
                                                            if _e1207 {
                                                                if _e1207 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1209 = global_10.member[_e1206];
                                                                phi_1752_ = _e1209;
                                                            } else {
                                                                phi_1752_ = 0u;
                                                            }
                                                            let _e1211 = phi_1752_;
                                                            let _e1215 = (_e1205 + _e372);
                                                            let _e1216 = (_e1215 < _e103);
                                                            if _e1216 {
                                                                if _e1216 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1218 = global_10.member[_e1215];
                                                                phi_1770_ = _e1218;
                                                            } else {
                                                                phi_1770_ = 0u;
                                                            }
                                                            let _e1220 = phi_1770_;
                                                            let _e1224 = (_e1205 + _e374);
                                                            let _e1225 = (_e1224 < _e103);
                                                            if _e1225 {
                                                                if _e1225 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1227 = global_10.member[_e1224];
                                                                phi_1788_ = _e1227;
                                                            } else {
                                                                phi_1788_ = 0u;
                                                            }
                                                            let _e1229 = phi_1788_;
                                                            let _e1234 = (_e1175 + 6u);
                                                            let _e1235 = (_e1234 + _e373);
                                                            let _e1236 = (_e1235 < _e103);
                                                            if _e1236 {
                                                                if _e1236 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1238 = global_10.member[_e1235];
                                                                phi_1808_ = _e1238;
                                                            } else {
                                                                phi_1808_ = 0u;
                                                            }
                                                            let _e1240 = phi_1808_;
                                                            let _e1244 = (_e1234 + _e372);
                                                            let _e1245 = (_e1244 < _e103);
                                                            if _e1245 {
                                                                if _e1245 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1247 = global_10.member[_e1244];
                                                                phi_1826_ = _e1247;
                                                            } else {
                                                                phi_1826_ = 0u;
                                                            }
                                                            let _e1249 = phi_1826_;
                                                            let _e1253 = (_e1234 + _e374);
                                                            let _e1254 = (_e1253 < _e103);
                                                            if _e1254 {
                                                                if _e1254 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1256 = global_10.member[_e1253];
                                                                phi_1844_ = _e1256;
                                                            } else {
                                                                phi_1844_ = 0u;
                                                            }
                                                            let _e1258 = phi_1844_;
                                                            phi_1850_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1182)) * _e159), (f32(bitcast<i32>(_e1191)) * _e159), (f32(bitcast<i32>(_e1200)) * _e159)), array<f32, 3>((f32(bitcast<i32>(_e1211)) * _e159), (f32(bitcast<i32>(_e1220)) * _e159), (f32(bitcast<i32>(_e1229)) * _e159)), array<f32, 3>((f32(bitcast<i32>(_e1240)) * _e159), (f32(bitcast<i32>(_e1249)) * _e159), (f32(bitcast<i32>(_e1258)) * _e159)));
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1850_ = array<array<f32, 3>, 3>();
                                                            break;
                                                        }
                                                    }
                                                    let _e1532 = phi_1850_;
                                                    let _e1540 = (_e1532[0][2] - _e478);
                                                    let _e1543 = (((_e1532[0][0] - _e405) * _e502) - (_e1540 * _e430));
                                                    let _e1546 = (((_e1532[0][1] - _e442) * _e502) - (_e1540 * _e466));
                                                    let _e1553 = (_e1532[1][2] - _e478);
                                                    let _e1556 = (((_e1532[1][0] - _e405) * _e502) - (_e1553 * _e430));
                                                    let _e1559 = (((_e1532[1][1] - _e442) * _e502) - (_e1553 * _e466));
                                                    let _e1566 = (_e1532[2][2] - _e478);
                                                    let _e1569 = (((_e1532[2][0] - _e405) * _e502) - (_e1566 * _e430));
                                                    let _e1572 = (((_e1532[2][1] - _e442) * _e502) - (_e1566 * _e466));
                                                    let _e1573 = (_e1569 * _e1559);
                                                    let _e1574 = (_e1572 * _e1556);
                                                    let _e1575 = (_e1543 * _e1572);
                                                    let _e1576 = (_e1546 * _e1569);
                                                    let _e1577 = (_e1556 * _e1546);
                                                    let _e1578 = (_e1559 * _e1543);
                                                    let _e1583 = (((_e1573 >= _e1574) && (_e1575 >= _e1576)) && (_e1577 >= _e1578));
                                                    if (_e1583 || (((_e1573 <= _e1574) && (_e1575 <= _e1576)) && (_e1577 <= _e1578))) {
                                                        let _e1590 = select(-1f, 1f, _e1583);
                                                        let _e1592 = ((_e1573 - _e1574) * _e1590);
                                                        let _e1594 = select(0f, _e1592, (_e1592 > 0f));
                                                        let _e1596 = ((_e1575 - _e1576) * _e1590);
                                                        let _e1598 = select(0f, _e1596, (_e1596 > 0f));
                                                        let _e1600 = ((_e1577 - _e1578) * _e1590);
                                                        let _e1602 = select(0f, _e1600, (_e1600 > 0f));
                                                        let _e1604 = ((_e1594 + _e1598) + _e1602);
                                                        if (_e1604 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2416_ = type_25();
                                                            phi_2417_ = true;
                                                        } else {
                                                            let _e1607 = select(_e1532[1][0], _e1532[0][0], (_e1532[0][0] < _e1532[1][0]));
                                                            let _e1611 = select(_e1532[1][0], _e1532[0][0], (_e1532[0][0] > _e1532[1][0]));
                                                            let _e1615 = select(_e1532[1][1], _e1532[0][1], (_e1532[0][1] < _e1532[1][1]));
                                                            let _e1619 = select(_e1532[1][1], _e1532[0][1], (_e1532[0][1] > _e1532[1][1]));
                                                            let _e1623 = select(_e1532[1][2], _e1532[0][2], (_e1532[0][2] < _e1532[1][2]));
                                                            let _e1627 = select(_e1532[1][2], _e1532[0][2], (_e1532[0][2] > _e1532[1][2]));
                                                            let _e1632 = ((select(_e1532[2][0], _e1607, (_e1607 < _e1532[2][0])) - _e428) * _e433);
                                                            let _e1633 = ((select(_e1532[2][0], _e1611, (_e1611 > _e1532[2][0])) - _e429) * _e433);
                                                            let _e1636 = ((select(_e1532[2][1], _e1615, (_e1615 < _e1532[2][1])) - _e464) * _e469);
                                                            let _e1637 = ((select(_e1532[2][1], _e1619, (_e1619 > _e1532[2][1])) - _e465) * _e469);
                                                            let _e1640 = ((select(_e1532[2][2], _e1623, (_e1623 < _e1532[2][2])) - _e500) * _e505);
                                                            let _e1641 = ((select(_e1532[2][2], _e1627, (_e1627 > _e1532[2][2])) - _e501) * _e505);
                                                            let _e1643 = select(_e1641, _e1640, (_e1640 < _e1641));
                                                            let _e1645 = select(_e1641, _e1640, (_e1640 > _e1641));
                                                            let _e1647 = select(_e1633, _e1632, (_e1632 < _e1633));
                                                            let _e1649 = select(_e1637, _e1636, (_e1636 < _e1637));
                                                            let _e1651 = select(_e1649, _e1647, (_e1647 > _e1649));
                                                            let _e1653 = select(_e1643, _e1651, (_e1651 > _e1643));
                                                            let _e1655 = select(_e1633, _e1632, (_e1632 > _e1633));
                                                            let _e1657 = select(_e1637, _e1636, (_e1636 > _e1637));
                                                            let _e1659 = select(_e1657, _e1655, (_e1655 < _e1657));
                                                            let _e1661 = select(_e1645, _e1659, (_e1659 < _e1645));
                                                            let _e1662 = -(_e1643);
                                                            let _e1668 = select(_e551, _e1653, (_e1653 > _e551));
                                                            if (_e1668 > (_e1661 + (select(_e1662, _e1645, (_e1645 > _e1662)) * 0.0000019073523f))) {
                                                                phi_2411_ = type_25();
                                                                phi_2412_ = true;
                                                            } else {
                                                                let _e1670 = (_e1668 > _e1103.member);
                                                                if _e1670 {
                                                                    phi_2410_ = type_25();
                                                                } else {
                                                                    let _e1674 = (_e1532[1][0] - _e1532[0][0]);
                                                                    let _e1675 = (_e1532[1][1] - _e1532[0][1]);
                                                                    let _e1676 = (_e1532[1][2] - _e1532[0][2]);
                                                                    let _e1677 = vec3<f32>(_e1674, _e1675, _e1676);
                                                                    let _e1678 = (_e1532[2][0] - _e1532[1][0]);
                                                                    let _e1679 = (_e1532[2][1] - _e1532[1][1]);
                                                                    let _e1680 = (_e1532[2][2] - _e1532[1][2]);
                                                                    let _e1681 = vec3<f32>(_e1678, _e1679, _e1680);
                                                                    let _e1682 = (_e1532[0][0] - _e1532[2][0]);
                                                                    let _e1683 = (_e1532[0][1] - _e1532[2][1]);
                                                                    let _e1684 = (_e1532[0][2] - _e1532[2][2]);
                                                                    let _e1685 = vec3<f32>(_e1682, _e1683, _e1684);
                                                                    let _e1688 = bitcast<f32>((bitcast<u32>(_e1674) & 2147483647u));
                                                                    let _e1691 = bitcast<f32>((bitcast<u32>(_e1675) & 2147483647u));
                                                                    let _e1693 = select(_e1691, _e1688, (_e1688 > _e1691));
                                                                    let _e1696 = bitcast<f32>((bitcast<u32>(_e1676) & 2147483647u));
                                                                    let _e1698 = select(_e1696, _e1693, (_e1693 > _e1696));
                                                                    let _e1701 = bitcast<f32>((bitcast<u32>(_e1678) & 2147483647u));
                                                                    let _e1704 = bitcast<f32>((bitcast<u32>(_e1679) & 2147483647u));
                                                                    let _e1706 = select(_e1704, _e1701, (_e1701 > _e1704));
                                                                    let _e1709 = bitcast<f32>((bitcast<u32>(_e1680) & 2147483647u));
                                                                    let _e1711 = select(_e1709, _e1706, (_e1706 > _e1709));
                                                                    let _e1714 = bitcast<f32>((bitcast<u32>(_e1682) & 2147483647u));
                                                                    let _e1717 = bitcast<f32>((bitcast<u32>(_e1683) & 2147483647u));
                                                                    let _e1719 = select(_e1717, _e1714, (_e1714 > _e1717));
                                                                    let _e1722 = bitcast<f32>((bitcast<u32>(_e1684) & 2147483647u));
                                                                    let _e1724 = select(_e1722, _e1719, (_e1719 > _e1722));
                                                                    let _e1726 = select(_e1711, _e1698, (_e1698 > _e1711));
                                                                    let _e1728 = select(_e1724, _e1726, (_e1726 > _e1724));
                                                                    if (_e1698 == _e1728) {
                                                                        phi_2321_ = _e1681;
                                                                        phi_2322_ = _e1685;
                                                                    } else {
                                                                        let _e1731 = vec3((_e1711 == _e1728));
                                                                        phi_2321_ = select(_e1677, _e1685, _e1731);
                                                                        phi_2322_ = select(_e1681, _e1677, _e1731);
                                                                    }
                                                                    let _e1735 = phi_2321_;
                                                                    let _e1737 = phi_2322_;
                                                                    let _e1744 = ((_e1735.y * _e1737.z) - (_e1737.y * _e1735.z));
                                                                    let _e1749 = ((_e1735.z * _e1737.x) - (_e1737.z * _e1735.x));
                                                                    let _e1752 = ((_e1735.x * _e1737.y) - (_e1737.x * _e1735.y));
                                                                    if (_e1594 >= _e1598) {
                                                                        phi_2353_ = select(true, false, (_e1594 >= _e1602));
                                                                    } else {
                                                                        phi_2353_ = true;
                                                                    }
                                                                    let _e1757 = phi_2353_;
                                                                    if _e1757 {
                                                                        phi_2362_ = select(vec3<f32>(_e1532[2][0], _e1532[2][1], _e1532[2][2]), vec3<f32>(_e1532[1][0], _e1532[1][1], _e1532[1][2]), vec3((_e1598 >= _e1602)));
                                                                    } else {
                                                                        phi_2362_ = vec3<f32>(_e1532[0][0], _e1532[0][1], _e1532[0][2]);
                                                                    }
                                                                    let _e1762 = phi_2362_;
                                                                    let _e1779 = ((((_e1744 * (_e1762.x - _e405)) + (_e1749 * (_e1762.y - _e442))) + (_e1752 * (_e1762.z - _e478))) / (((_e1744 * _e430) + (_e1749 * _e466)) + (_e1752 * _e502)));
                                                                    let _e1781 = select(_e1661, _e1779, (_e1779 < _e1661));
                                                                    let _e1783 = select(_e1653, _e1781, (_e1781 > _e1653));
                                                                    if (_e1783 >= _e551) {
                                                                        let _e1785 = (_e1783 <= _e1103.member);
                                                                        if _e1785 {
                                                                            let _e1786 = (1f / _e1604);
                                                                            phi_2402_ = type_25(_e1783, (_e1598 * _e1786), (_e1602 * _e1786), _e1163);
                                                                        } else {
                                                                            phi_2402_ = type_25();
                                                                        }
                                                                        let _e1791 = phi_2402_;
                                                                        phi_2404_ = _e1791;
                                                                        phi_2405_ = select(true, false, _e1785);
                                                                    } else {
                                                                        phi_2404_ = type_25();
                                                                        phi_2405_ = true;
                                                                    }
                                                                    let _e1794 = phi_2404_;
                                                                    let _e1796 = phi_2405_;
                                                                    if _e1796 {
                                                                        phi_2409_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_2409_ = _e1794;
                                                                    }
                                                                    let _e1798 = phi_2409_;
                                                                    phi_2410_ = _e1798;
                                                                }
                                                                let _e1800 = phi_2410_;
                                                                phi_2411_ = _e1800;
                                                                phi_2412_ = _e1670;
                                                            }
                                                            let _e1802 = phi_2411_;
                                                            let _e1804 = phi_2412_;
                                                            phi_2416_ = _e1802;
                                                            phi_2417_ = _e1804;
                                                        }
                                                        let _e1806 = phi_2416_;
                                                        let _e1808 = phi_2417_;
                                                        phi_2421_ = _e1806;
                                                        phi_2422_ = _e1808;
                                                    } else {
                                                        phi_2421_ = type_25();
                                                        phi_2422_ = true;
                                                    }
                                                    let _e1810 = phi_2421_;
                                                    let _e1812 = phi_2422_;
                                                    if _e1812 {
                                                        phi_2426_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2426_ = _e1810;
                                                    }
                                                    let _e1814 = phi_2426_;
                                                    if (_e1814.member_3 != 4294967295u) {
                                                        if (_e1163 == _e168) {
                                                            phi_2755_ = false;
                                                        } else {
                                                            let _e1818 = (_e1163 < arrayLength((&global_6.member)));
                                                            if _e1818 {
                                                                if _e1818 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1820 = global_6.member[_e1163];
                                                                phi_2449_ = _e1820;
                                                            } else {
                                                                phi_2449_ = 4294967295u;
                                                            }
                                                            let _e1822 = phi_2449_;
                                                            let _e1823 = (_e1822 < arrayLength((&global_7.member)));
                                                            if _e1823 {
                                                                if _e1823 {
                                                                } else {
                                                                    phi_4260_ = true;
                                                                    break;
                                                                }
                                                                let _e1825 = global_7.member[_e1822];
                                                                phi_2463_ = _e1825;
                                                            } else {
                                                                phi_2463_ = 0i;
                                                            }
                                                            let _e1827 = phi_2463_;
                                                            let _e1828 = (_e1827 == 0i);
                                                            if _e1828 {
                                                                phi_2754_ = true;
                                                            } else {
                                                                if _e397 {
                                                                    phi_2484_ = vec3<f32>(_e1532[0][0], _e1532[0][1], _e1532[0][2]);
                                                                } else {
                                                                    if (_e373 == 1u) {
                                                                        phi_2483_ = vec3<f32>(_e1532[0][2], _e1532[0][0], _e1532[0][1]);
                                                                    } else {
                                                                        phi_2483_ = vec3<f32>(_e1532[0][1], _e1532[0][2], _e1532[0][0]);
                                                                    }
                                                                    let _e1833 = phi_2483_;
                                                                    phi_2484_ = _e1833;
                                                                }
                                                                let _e1836 = phi_2484_;
                                                                if _e397 {
                                                                    phi_2501_ = vec3<f32>(_e1532[1][0], _e1532[1][1], _e1532[1][2]);
                                                                } else {
                                                                    if (_e373 == 1u) {
                                                                        phi_2500_ = vec3<f32>(_e1532[1][2], _e1532[1][0], _e1532[1][1]);
                                                                    } else {
                                                                        phi_2500_ = vec3<f32>(_e1532[1][1], _e1532[1][2], _e1532[1][0]);
                                                                    }
                                                                    let _e1841 = phi_2500_;
                                                                    phi_2501_ = _e1841;
                                                                }
                                                                let _e1844 = phi_2501_;
                                                                if _e397 {
                                                                    phi_2518_ = vec3<f32>(_e1532[2][0], _e1532[2][1], _e1532[2][2]);
                                                                } else {
                                                                    if (_e373 == 1u) {
                                                                        phi_2517_ = vec3<f32>(_e1532[2][2], _e1532[2][0], _e1532[2][1]);
                                                                    } else {
                                                                        phi_2517_ = vec3<f32>(_e1532[2][1], _e1532[2][2], _e1532[2][0]);
                                                                    }
                                                                    let _e1849 = phi_2517_;
                                                                    phi_2518_ = _e1849;
                                                                }
                                                                let _e1852 = phi_2518_;
                                                                let _e1855 = (_e1844.x - _e1836.x);
                                                                let _e1858 = (_e1844.y - _e1836.y);
                                                                let _e1861 = (_e1844.z - _e1836.z);
                                                                let _e1863 = (_e1852.x - _e1836.x);
                                                                let _e1865 = (_e1852.y - _e1836.y);
                                                                let _e1867 = (_e1852.z - _e1836.z);
                                                                if (_e240.member_1 == 1u) {
                                                                    phi_2554_ = (vec3<f32>(_e240.member[0], _e240.member[1], _e240.member[2]) - _e1836);
                                                                } else {
                                                                    phi_2554_ = vec3<f32>(_e240.member[0], _e240.member[1], _e240.member[2]);
                                                                }
                                                                let _e1882 = phi_2554_;
                                                                let _e1888 = bitcast<f32>((bitcast<u32>((_e1855 * _e1865)) ^ _e240.member_3[0]));
                                                                let _e1892 = bitcast<f32>((bitcast<u32>((_e1858 * _e1863)) ^ _e240.member_3[0]));
                                                                let _e1896 = bitcast<f32>((bitcast<u32>((_e1858 * _e1867)) ^ _e240.member_3[0]));
                                                                let _e1900 = bitcast<f32>((bitcast<u32>((_e1861 * _e1865)) ^ _e240.member_3[0]));
                                                                let _e1904 = bitcast<f32>((bitcast<u32>((_e1861 * _e1863)) ^ _e240.member_3[0]));
                                                                let _e1908 = bitcast<f32>((bitcast<u32>((_e1855 * _e1867)) ^ _e240.member_3[0]));
                                                                let _e1909 = (_e1896 - _e1900);
                                                                let _e1910 = (_e1904 - _e1908);
                                                                let _e1911 = (_e1888 - _e1892);
                                                                let _e1935 = (bitcast<f32>((bitcast<u32>(_e1896) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1900) & 2147483647u)));
                                                                let _e1942 = (bitcast<f32>((bitcast<u32>(_e1904) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1908) & 2147483647u)));
                                                                let _e1949 = (bitcast<f32>((bitcast<u32>(_e1888) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1892) & 2147483647u)));
                                                                if (_e240.member_2 == 0f) {
                                                                    phi_2736_ = 0f;
                                                                } else {
                                                                    let _e1979 = bitcast<f32>((bitcast<u32>(_e1909) & 2147483647u));
                                                                    let _e1982 = bitcast<f32>((bitcast<u32>(_e1910) & 2147483647u));
                                                                    let _e1985 = bitcast<f32>((bitcast<u32>(_e1911) & 2147483647u));
                                                                    let _e1987 = select(_e1985, _e1982, (_e1982 > _e1985));
                                                                    let _e1991 = select(_e1985, _e1982, (_e1982 < _e1985));
                                                                    let _e1995 = select(_e1982, _e1979, (_e1979 < _e1982));
                                                                    let _e1997 = select(_e1982, _e1979, (_e1979 > _e1982));
                                                                    let _e1999 = select(_e1985, _e1997, (_e1997 < _e1985));
                                                                    phi_2736_ = bitcast<f32>((bitcast<u32>((_e240.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1987, _e1979, (_e1979 > _e1987)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1999, _e1995, (_e1995 > _e1999)))) ^ _e240.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1991, _e1979, (_e1979 < _e1991)))) ^ _e240.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1935 + _e1942) + _e1949))) ^ _e240.member_3[0]))) * 1.0000005f)) ^ _e240.member_3[0])))) ^ _e240.member_3[0]));
                                                                }
                                                                let _e2026 = phi_2736_;
                                                                phi_2754_ = (_e1828 || !(((((bitcast<f32>((bitcast<u32>((_e1882.x * _e1909)) ^ _e240.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1882.y * _e1910)) ^ _e240.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1882.z * _e1911)) ^ _e240.member_3[0]))) * f32(-(_e1827))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1882.x) & 2147483647u)) * _e1935)) ^ _e240.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1882.y) & 2147483647u)) * _e1942)) ^ _e240.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1882.z) & 2147483647u)) * _e1949)) ^ _e240.member_3[0]))))) ^ _e240.member_3[0])) + _e2026) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e2040 = phi_2754_;
                                                            phi_2755_ = _e2040;
                                                        }
                                                        let _e2042 = phi_2755_;
                                                        if _e2042 {
                                                            phi_2760_ = type_46(_e1103.member, true);
                                                        } else {
                                                            phi_2760_ = _e1103;
                                                        }
                                                        let _e2047 = phi_2760_;
                                                        phi_2761_ = _e2047;
                                                    } else {
                                                        phi_2761_ = _e1103;
                                                    }
                                                    let _e2049 = phi_2761_;
                                                    phi_1132_ = _e2049;
                                                } else {
                                                    phi_1132_ = type_46();
                                                }
                                                let _e2051 = phi_1132_;
                                                continue;
                                                continuing {
                                                    phi_1131_ = _e2051;
                                                    phi_1134_ = _e1118;
                                                    phi_4260_ = _e593;
                                                    break if !(_e1124);
                                                }
                                            }
                                            let _e2054 = phi_4260_;
                                            phi_4445_ = _e2054;
                                            if _e2054 {
                                                break;
                                            }
                                            let _e2056 = local_10;
                                            phi_4449_ = _e2054;
                                            let _e2277 = local_12;
                                            phi_4002_ = _e2277;
                                            phi_4003_ = _e634;
                                            phi_4004_ = false;
                                            phi_4005_ = select(_e638, 0u, _e2056.member_1);
                                        } else {
                                            if (_e634.member_1 >= _e100) {
                                                phi_3558_ = type_59(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_58(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_58(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e634.member_1 < _e100) {
                                                } else {
                                                    phi_4445_ = true;
                                                    break;
                                                }
                                                let _e651 = ((1u + _e373) % 4u);
                                                if (_e651 < 4u) {
                                                } else {
                                                    phi_4445_ = true;
                                                    break;
                                                }
                                                let _e656 = global_5.member[_e634.member_1][_e651];
                                                let _e658 = (_e656 >> bitcast<u32>(11u));
                                                let _e660 = ((1u + _e372) % 4u);
                                                if (_e660 < 4u) {
                                                } else {
                                                    phi_4445_ = true;
                                                    break;
                                                }
                                                let _e665 = global_5.member[_e634.member_1][_e660];
                                                let _e667 = (_e665 >> bitcast<u32>(11u));
                                                let _e669 = ((1u + _e374) % 4u);
                                                if (_e669 < 4u) {
                                                } else {
                                                    phi_4445_ = true;
                                                    break;
                                                }
                                                let _e674 = global_5.member[_e634.member_1][_e669];
                                                let _e676 = (_e674 >> bitcast<u32>(11u));
                                                let _e699 = (bitcast<f32>((bitcast<u32>((_e634.member.member_1.x - _e634.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e700 = (bitcast<f32>((bitcast<u32>((_e634.member.member_1.y - _e634.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e701 = (bitcast<f32>((bitcast<u32>((_e634.member.member_1.z - _e634.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e703 = select(_e159, _e699, (_e699 > _e159));
                                                let _e705 = select(_e159, _e700, (_e700 > _e159));
                                                let _e707 = select(_e159, _e701, (_e701 > _e159));
                                                let _e732 = bitcast<u32>((f32(bitcast<i32>((_e656 & 1023u))) * _e703));
                                                let _e737 = (bitcast<i32>((_e656 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e740 = bitcast<f32>((_e732 & bitcast<u32>(_e737)));
                                                let _e741 = bitcast<u32>((f32(bitcast<i32>((_e665 & 1023u))) * _e705));
                                                let _e746 = (bitcast<i32>((_e665 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e749 = bitcast<f32>((_e741 & bitcast<u32>(_e746)));
                                                let _e750 = bitcast<u32>((f32(bitcast<i32>((_e674 & 1023u))) * _e707));
                                                let _e755 = (bitcast<i32>((_e674 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e758 = bitcast<f32>((_e750 & bitcast<u32>(_e755)));
                                                let _e762 = bitcast<f32>((_e732 & bitcast<u32>(~(_e737))));
                                                let _e766 = bitcast<f32>((_e741 & bitcast<u32>(~(_e746))));
                                                let _e770 = bitcast<f32>((_e750 & bitcast<u32>(~(_e755))));
                                                let _e771 = bitcast<u32>((f32(bitcast<i32>((_e658 & 1023u))) * _e703));
                                                let _e776 = (bitcast<i32>((_e658 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e779 = bitcast<f32>((_e771 & bitcast<u32>(_e776)));
                                                let _e780 = bitcast<u32>((f32(bitcast<i32>((_e667 & 1023u))) * _e705));
                                                let _e785 = (bitcast<i32>((_e667 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e788 = bitcast<f32>((_e780 & bitcast<u32>(_e785)));
                                                let _e789 = bitcast<u32>((f32(bitcast<i32>((_e676 & 1023u))) * _e707));
                                                let _e794 = (bitcast<i32>((_e676 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e797 = bitcast<f32>((_e789 & bitcast<u32>(_e794)));
                                                let _e801 = bitcast<f32>((_e771 & bitcast<u32>(~(_e776))));
                                                let _e805 = bitcast<f32>((_e780 & bitcast<u32>(~(_e785))));
                                                let _e809 = bitcast<f32>((_e789 & bitcast<u32>(~(_e794))));
                                                let _e810 = (_e634.member.member.x + _e740);
                                                let _e811 = (_e634.member.member.y + _e749);
                                                let _e812 = (_e634.member.member.z + _e758);
                                                let _e815 = (_e634.member.member_1.x - _e779);
                                                let _e816 = (_e634.member.member_1.y - _e788);
                                                let _e817 = (_e634.member.member_1.z - _e797);
                                                let _e836 = (_e815 - _e810);
                                                let _e837 = (_e816 - _e811);
                                                let _e838 = (_e817 - _e812);
                                                let _e840 = select(_e837, _e836, (_e836 > _e837));
                                                let _e842 = select(_e838, _e840, (_e840 > _e838));
                                                if (_e842 < (1024f * _e159)) {
                                                    phi_3259_ = 0u;
                                                } else {
                                                    phi_3259_ = select(2u, 1u, (_e842 < (2097152f * _e159)));
                                                }
                                                let _e849 = phi_3259_;
                                                switch bitcast<i32>(_e849) {
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
                                                let _e852 = phi_3265_;
                                                let _e858 = global_5.member[_e634.member_1][0u];
                                                let _e862 = global_5.member[_e634.member_1][1u];
                                                let _e866 = global_5.member[_e634.member_1][2u];
                                                let _e870 = global_5.member[_e634.member_1][3u];
                                                let _e882 = (((_e862 >> bitcast<u32>(22i)) | ((_e866 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e870 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e883 = (_e858 & 268435455u);
                                                let _e884 = (_e882 & 268435455u);
                                                let _e887 = ((_e858 >> bitcast<u32>(28u)) & 7u);
                                                let _e895 = ((_e858 >> bitcast<u32>(31i)) | (((_e882 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e896 = (_e887 != 0u);
                                                if (_e887 == 0u) {
                                                    phi_3520_ = _e883;
                                                } else {
                                                    if (_e887 == 7u) {
                                                        phi_3519_ = 2147483648u;
                                                    } else {
                                                        phi_3519_ = ((2147483648u | (_e887 << bitcast<u32>(28u))) | (_e884 & 268435455u));
                                                    }
                                                    let _e905 = phi_3519_;
                                                    phi_3520_ = _e905;
                                                }
                                                let _e907 = phi_3520_;
                                                if _e896 {
                                                    let _e908 = (_e887 != 7u);
                                                    if _e908 {
                                                        phi_3530_ = (_e884 + (_e887 * ((3u * _e852) + 1u)));
                                                    } else {
                                                        phi_3530_ = u32();
                                                    }
                                                    let _e912 = phi_3530_;
                                                    phi_3532_ = _e912;
                                                    phi_3533_ = select(true, false, _e908);
                                                } else {
                                                    phi_3532_ = u32();
                                                    phi_3533_ = true;
                                                }
                                                let _e915 = phi_3532_;
                                                let _e917 = phi_3533_;
                                                if (_e895 == 0u) {
                                                    phi_3554_ = (_e883 + select(0u, 1u, !(_e896)));
                                                } else {
                                                    if (_e895 == 7u) {
                                                        phi_3553_ = 2147483648u;
                                                    } else {
                                                        phi_3553_ = ((2147483648u | (_e895 << bitcast<u32>(28u))) | (select(_e915, _e884, _e917) & 268435455u));
                                                    }
                                                    let _e930 = phi_3553_;
                                                    phi_3554_ = _e930;
                                                }
                                                let _e932 = phi_3554_;
                                                phi_3558_ = type_59(array<vec4<f32>, 3>(vec4<f32>(_e810, (_e634.member.member.x + _e762), _e815, (_e634.member.member_1.x - _e801)), vec4<f32>(_e811, (_e634.member.member.y + _e766), _e816, (_e634.member.member_1.y - _e805)), vec4<f32>(_e812, (_e634.member.member.z + _e770), _e817, (_e634.member.member_1.z - _e809))), type_58(type_34((_e634.member.member + vec4<f32>(_e740, _e749, _e758, 0f)), (_e634.member.member_1 - vec4<f32>(_e779, _e788, _e797, 0f))), _e907), type_58(type_34((_e634.member.member + vec4<f32>(_e762, _e766, _e770, 0f)), (_e634.member.member_1 - vec4<f32>(_e801, _e805, _e809, 0f))), _e932));
                                            }
                                            let _e937 = phi_3558_;
                                            let _e949 = ((_e937.member[0].x - _e428) * _e433);
                                            let _e950 = ((_e937.member[0].y - _e428) * _e433);
                                            let _e951 = ((_e937.member[0].z - _e429) * _e433);
                                            let _e952 = ((_e937.member[0].w - _e429) * _e433);
                                            let _e962 = ((_e937.member[1].x - _e464) * _e469);
                                            let _e963 = ((_e937.member[1].y - _e464) * _e469);
                                            let _e964 = ((_e937.member[1].z - _e465) * _e469);
                                            let _e965 = ((_e937.member[1].w - _e465) * _e469);
                                            let _e975 = ((_e937.member[2].x - _e500) * _e505);
                                            let _e976 = ((_e937.member[2].y - _e500) * _e505);
                                            let _e977 = ((_e937.member[2].z - _e501) * _e505);
                                            let _e978 = ((_e937.member[2].w - _e501) * _e505);
                                            let _e980 = select(_e977, _e975, (_e975 < _e977));
                                            let _e982 = select(_e978, _e976, (_e976 < _e978));
                                            let _e984 = select(_e977, _e975, (_e975 > _e977));
                                            let _e986 = select(_e978, _e976, (_e976 > _e978));
                                            let _e988 = select(_e951, _e949, (_e949 < _e951));
                                            let _e990 = select(_e952, _e950, (_e950 < _e952));
                                            let _e992 = select(_e964, _e962, (_e962 < _e964));
                                            let _e994 = select(_e965, _e963, (_e963 < _e965));
                                            let _e996 = select(_e992, _e988, (_e988 > _e992));
                                            let _e998 = select(_e994, _e990, (_e990 > _e994));
                                            let _e1000 = select(_e980, _e996, (_e996 > _e980));
                                            let _e1002 = select(_e982, _e998, (_e998 > _e982));
                                            let _e1004 = select(_e951, _e949, (_e949 > _e951));
                                            let _e1006 = select(_e952, _e950, (_e950 > _e952));
                                            let _e1008 = select(_e964, _e962, (_e962 > _e964));
                                            let _e1010 = select(_e965, _e963, (_e963 > _e965));
                                            let _e1012 = select(_e1008, _e1004, (_e1004 < _e1008));
                                            let _e1014 = select(_e1010, _e1006, (_e1006 < _e1010));
                                            let _e1019 = -(_e980);
                                            let _e1020 = -(_e982);
                                            let _e1027 = (select(_e984, _e1012, (_e1012 < _e984)) + (select(_e1019, _e984, (_e984 > _e1019)) * 0.0000019073523f));
                                            let _e1028 = (select(_e986, _e1014, (_e1014 < _e986)) + (select(_e1020, _e986, (_e986 > _e1020)) * 0.0000019073523f));
                                            let _e1030 = select(_e551, _e1000, (_e1000 > _e551));
                                            let _e1032 = select(_e551, _e1002, (_e1002 > _e551));
                                            let _e1037 = (_e1030 <= select(_e595.member, _e1027, (_e1027 < _e595.member)));
                                            let _e1038 = (_e1032 <= select(_e595.member, _e1028, (_e1028 < _e595.member)));
                                            let _e1039 = (_e1030 <= _e1032);
                                            if _e1037 {
                                                if _e1038 {
                                                    if _e1039 {
                                                        phi_3902_ = _e937.member_2;
                                                    } else {
                                                        phi_3902_ = _e937.member_1;
                                                    }
                                                    let _e1043 = phi_3902_;
                                                    let _e1065 = (_e638 % 128u);
                                                    let _e1066 = (_e1065 < 128u);
                                                    if _e1066 {
                                                    } else {
                                                        phi_4445_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1065] = _e1043.member_1;
                                                    if _e1066 {
                                                    } else {
                                                        phi_4445_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1065] = _e1043.member.member.x;
                                                    if _e1066 {
                                                    } else {
                                                        phi_4445_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1065] = _e1043.member.member.y;
                                                    if _e1066 {
                                                    } else {
                                                        phi_4445_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1065] = _e1043.member.member.z;
                                                    if _e1066 {
                                                    } else {
                                                        phi_4445_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1065] = _e1043.member.member_1.x;
                                                    if _e1066 {
                                                    } else {
                                                        phi_4445_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1065] = _e1043.member.member_1.y;
                                                    if _e1066 {
                                                    } else {
                                                        phi_4445_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1065] = _e1043.member.member_1.z;
                                                    if _e1066 {
                                                    } else {
                                                        phi_4445_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1065] = select(_e1032, _e1030, (_e1030 > _e1032));
                                                    if _e1039 {
                                                        phi_3979_ = _e937.member_1;
                                                    } else {
                                                        phi_3979_ = _e937.member_2;
                                                    }
                                                    let _e1079 = phi_3979_;
                                                    phi_3980_ = _e1079;
                                                    phi_3981_ = (_e638 + 1u);
                                                } else {
                                                    phi_3980_ = type_58();
                                                    phi_3981_ = u32();
                                                }
                                                let _e1081 = phi_3980_;
                                                let _e1083 = phi_3981_;
                                                phi_3983_ = _e1081;
                                                phi_3984_ = _e1083;
                                                phi_3985_ = select(true, false, _e1038);
                                            } else {
                                                phi_3983_ = type_58();
                                                phi_3984_ = u32();
                                                phi_3985_ = true;
                                            }
                                            let _e1086 = phi_3983_;
                                            let _e1088 = phi_3984_;
                                            let _e1090 = phi_3985_;
                                            if _e1090 {
                                                if _e1037 {
                                                    phi_3994_ = _e937.member_1;
                                                } else {
                                                    phi_3994_ = _e937.member_2;
                                                }
                                                let _e1094 = phi_3994_;
                                                phi_3999_ = _e1094;
                                                phi_4000_ = select(_e1038, true, _e1037);
                                            } else {
                                                phi_3999_ = _e1086;
                                                phi_4000_ = _e636;
                                            }
                                            let _e1097 = phi_3999_;
                                            let _e1099 = phi_4000_;
                                            phi_4449_ = _e593;
                                            phi_4002_ = _e595;
                                            phi_4003_ = _e1097;
                                            phi_4004_ = _e1099;
                                            phi_4005_ = select(_e1088, _e638, _e1090);
                                        }
                                        let _e2060 = phi_4449_;
                                        let _e2062 = phi_4002_;
                                        let _e2064 = phi_4003_;
                                        let _e2066 = phi_4004_;
                                        let _e2068 = phi_4005_;
                                        phi_4448_ = _e2060;
                                        phi_4006_ = _e2062;
                                        phi_4007_ = _e2064;
                                        phi_4008_ = (_e599 - 1u);
                                        phi_4009_ = _e2066;
                                        phi_4010_ = _e2068;
                                    } else {
                                        phi_4448_ = _e593;
                                        phi_4006_ = _e595;
                                        phi_4007_ = _e634;
                                        phi_4008_ = _e599;
                                        phi_4009_ = _e636;
                                        phi_4010_ = _e638;
                                    }
                                    let _e2070 = phi_4448_;
                                    let _e2072 = phi_4006_;
                                    let _e2074 = phi_4007_;
                                    let _e2076 = phi_4008_;
                                    let _e2078 = phi_4009_;
                                    let _e2080 = phi_4010_;
                                    phi_4447_ = _e2070;
                                    phi_4011_ = _e2072;
                                    phi_4012_ = _e2074;
                                    phi_4013_ = _e2076;
                                    phi_4014_ = _e2078;
                                    phi_4015_ = _e2080;
                                } else {
                                    phi_4447_ = _e593;
                                    phi_4011_ = type_46();
                                    phi_4012_ = type_58();
                                    phi_4013_ = u32();
                                    phi_4014_ = bool();
                                    phi_4015_ = u32();
                                }
                                let _e2082 = phi_4447_;
                                let _e2084 = phi_4011_;
                                let _e2086 = phi_4012_;
                                let _e2088 = phi_4013_;
                                let _e2090 = phi_4014_;
                                let _e2092 = phi_4015_;
                                phi_4446_ = _e2082;
                                phi_1005_ = _e2084;
                                phi_1008_ = _e2086;
                                phi_1010_ = _e2088;
                                phi_1012_ = _e2090;
                                phi_1014_ = _e2092;
                                phi_4016_ = _e607;
                            } else {
                                phi_4446_ = _e593;
                                phi_1005_ = type_46();
                                phi_1008_ = type_58();
                                phi_1010_ = u32();
                                phi_1012_ = bool();
                                phi_1014_ = u32();
                                phi_4016_ = false;
                            }
                            let _e2094 = phi_4446_;
                            let _e2096 = phi_1005_;
                            let _e2098 = phi_1008_;
                            let _e2100 = phi_1010_;
                            let _e2102 = phi_1012_;
                            let _e2104 = phi_1014_;
                            let _e2106 = phi_4016_;
                            continue;
                            continuing {
                                phi_4266_ = _e2094;
                                phi_1004_ = _e2096;
                                phi_1007_ = _e2098;
                                phi_1009_ = _e2100;
                                phi_1011_ = _e2102;
                                phi_1013_ = _e2104;
                                phi_4445_ = _e2094;
                                break if !(_e2106);
                            }
                        }
                        let _e2109 = phi_4445_;
                        if _e2109 {
                            break;
                        }
                        let _e2111 = local_11;
                        if _e2111.member_1 {
                        } else {
                            if _e241 {
                            } else {
                                break;
                            }
                            let _e2115 = global_2.member[_e147];
                            if _e162 {
                            } else {
                                break;
                            }
                            let _e2119 = global_9.member[_e147].member_1;
                            if _e241 {
                            } else {
                                break;
                            }
                            global_2.member[_e147] = type_27(_e2115.member, _e2115.member_1, _e2115.member_2, array<f32, 3>((_e2115.member_3[0] + (_e2119[0] * _e2115.member_1[0])), (_e2115.member_3[1] + (_e2119[1] * _e2115.member_1[1])), (_e2115.member_3[2] + (_e2119[2] * _e2115.member_1[2]))), _e2115.member_4);
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
fn trace_shadows_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
