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
    var phi_335_: u32;
    var phi_379_: i32;
    var phi_403_: type_36;
    var phi_553_: i32;
    var phi_554_: i32;
    var phi_564_: bool;
    var phi_574_: u32;
    var phi_575_: u32;
    var phi_577_: bool;
    var phi_582_: u32;
    var phi_614_: i32;
    var phi_632_: f32;
    var phi_638_: f32;
    var phi_649_: f32;
    var phi_655_: f32;
    var phi_678_: f32;
    var phi_689_: f32;
    var phi_698_: f32;
    var phi_704_: f32;
    var phi_715_: f32;
    var phi_721_: f32;
    var phi_744_: f32;
    var phi_755_: f32;
    var phi_764_: f32;
    var phi_770_: f32;
    var phi_781_: f32;
    var phi_787_: f32;
    var phi_810_: f32;
    var phi_821_: f32;
    var phi_921_: f32;
    var phi_922_: f32;
    var phi_4537_: bool;
    var phi_1011_: type_42;
    var phi_1014_: type_58;
    var phi_1016_: u32;
    var phi_1018_: bool;
    var phi_1020_: u32;
    var phi_1031_: bool;
    var phi_1117_: type_58;
    var phi_1118_: bool;
    var phi_1119_: u32;
    var phi_3530_: u32;
    var phi_3536_: u32;
    var phi_3790_: u32;
    var phi_3791_: u32;
    var phi_3801_: u32;
    var phi_3803_: u32;
    var phi_3804_: bool;
    var phi_3824_: u32;
    var phi_3825_: u32;
    var phi_3829_: type_59;
    var phi_4173_: type_58;
    var phi_4250_: type_58;
    var phi_4251_: type_58;
    var phi_4252_: u32;
    var phi_4254_: type_58;
    var phi_4255_: u32;
    var phi_4256_: bool;
    var phi_4265_: type_58;
    var phi_4270_: type_58;
    var phi_4271_: bool;
    var phi_1138_: type_42;
    var phi_1141_: type_8;
    var phi_1142_: type_8;
    var phi_1164_: type_8;
    var phi_1205_: u32;
    var phi_1211_: u32;
    var phi_1221_: u32;
    var phi_1237_: u32;
    var phi_1270_: u32;
    var phi_1276_: u32;
    var phi_1703_: u32;
    var phi_1721_: u32;
    var phi_1739_: u32;
    var phi_1759_: u32;
    var phi_1777_: u32;
    var phi_1795_: u32;
    var phi_1815_: u32;
    var phi_1833_: u32;
    var phi_1851_: u32;
    var phi_1429_: u32;
    var phi_1444_: u32;
    var phi_1454_: u32;
    var phi_1474_: u32;
    var phi_1494_: u32;
    var phi_1520_: u32;
    var phi_1535_: u32;
    var phi_1545_: u32;
    var phi_1565_: u32;
    var phi_1585_: u32;
    var phi_1611_: u32;
    var phi_1626_: u32;
    var phi_1636_: u32;
    var phi_1656_: u32;
    var phi_1676_: u32;
    var phi_1300_: u32;
    var phi_1343_: u32;
    var phi_1386_: u32;
    var phi_1857_: array<array<f32, 3>, 3>;
    var phi_1974_: bool;
    var phi_2003_: bool;
    var phi_2404_: f32;
    var phi_2405_: f32;
    var phi_2406_: f32;
    var phi_2407_: f32;
    var phi_2408_: vec3<f32>;
    var phi_2409_: vec3<f32>;
    var phi_2410_: vec3<f32>;
    var phi_2411_: vec3<f32>;
    var phi_2442_: bool;
    var phi_2451_: vec3<f32>;
    var phi_2616_: f32;
    var phi_2618_: f32;
    var phi_2619_: bool;
    var phi_2639_: f32;
    var phi_2640_: f32;
    var phi_2663_: type_21;
    var phi_2665_: type_21;
    var phi_2666_: bool;
    var phi_2670_: type_21;
    var phi_2671_: type_21;
    var phi_2672_: type_21;
    var phi_2673_: bool;
    var phi_2677_: type_21;
    var phi_2678_: bool;
    var phi_2679_: type_21;
    var phi_2680_: bool;
    var phi_2681_: bool;
    var phi_2682_: type_21;
    var phi_2683_: bool;
    var phi_2684_: bool;
    var phi_2692_: type_21;
    var phi_2693_: bool;
    var phi_2697_: type_21;
    var phi_2720_: u32;
    var phi_2734_: i32;
    var phi_2754_: vec3<f32>;
    var phi_2755_: vec3<f32>;
    var phi_2771_: vec3<f32>;
    var phi_2772_: vec3<f32>;
    var phi_2788_: vec3<f32>;
    var phi_2789_: vec3<f32>;
    var phi_2825_: vec3<f32>;
    var phi_3007_: f32;
    var phi_3025_: bool;
    var phi_3026_: bool;
    var phi_3031_: type_42;
    var phi_3032_: type_42;
    var phi_1139_: type_42;
    var phi_4531_: bool;
    var local_10: type_42;
    var phi_4748_: bool;
    var phi_4273_: type_42;
    var phi_4274_: type_58;
    var phi_4275_: bool;
    var phi_4276_: u32;
    var phi_4747_: bool;
    var phi_4277_: type_42;
    var phi_4278_: type_58;
    var phi_4279_: u32;
    var phi_4280_: bool;
    var phi_4281_: u32;
    var phi_4746_: bool;
    var phi_4282_: type_42;
    var phi_4283_: type_58;
    var phi_4284_: u32;
    var phi_4285_: bool;
    var phi_4286_: u32;
    var phi_4745_: bool;
    var phi_1012_: type_42;
    var phi_1015_: type_58;
    var phi_1017_: u32;
    var phi_1019_: bool;
    var phi_1021_: u32;
    var phi_4287_: bool;
    var phi_4744_: bool;
    var local_11: type_42;
    var local_12: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e98 = global;
            let _e100 = arrayLength((&global_8.member));
            let _e103 = arrayLength((&global_10.member));
            let _e115 = arrayLength((&global_7.member));
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
                phi_335_ = _e166;
            } else {
                phi_335_ = 4294967295u;
            }
            let _e168 = phi_335_;
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
                phi_379_ = -126i;
            } else {
                phi_379_ = select(_e211, 127i, (_e211 > 127i));
            }
            let _e216 = phi_379_;
            let _e221 = bitcast<f32>((bitcast<u32>((_e216 + 127i)) << bitcast<u32>(23i)));
            let _e227 = bitcast<f32>((bitcast<u32>(((_e211 - _e216) + 127i)) << bitcast<u32>(23i)));
            if (_e187 == 0u) {
                phi_403_ = type_36(array<f32, 3>(_e204, _e205, _e206), _e187, _e208, _e209);
            } else {
                phi_403_ = type_36(array<f32, 3>(((_e204 * _e221) * _e227), ((_e205 * _e221) * _e227), ((_e206 * _e221) * _e227)), _e187, ((_e208 * _e221) * _e227), _e209);
            }
            let _e240 = phi_403_;
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
                            let _e257 = atomicAdd((&global_7.member[0u]), 1u);
                            if ((_e257 + 1u) < _e257) {
                                if _e253 {
                                } else {
                                    break;
                                }
                                let _e262 = atomicAdd((&global_7.member[1u]), 1u);
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
                                phi_553_ = (bitcast<i32>((_e338 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_553_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e338)), 32u, (_e338 == 0u))));
                            }
                            let _e352 = phi_553_;
                            phi_554_ = _e352;
                        } else {
                            phi_554_ = 0i;
                        }
                        let _e354 = phi_554_;
                        let _e355 = (_e274 == _e318);
                        if _e355 {
                            phi_564_ = true;
                        } else {
                            phi_564_ = (_e282 == _e318);
                        }
                        let _e358 = phi_564_;
                        let _e359 = select(1u, 0u, _e355);
                        if _e358 {
                            let _e360 = (_e359 + 1u);
                            phi_574_ = _e360;
                            phi_575_ = _e360;
                            phi_577_ = select(true, false, (_e360 == 2u));
                        } else {
                            phi_574_ = u32();
                            phi_575_ = 0u;
                            phi_577_ = true;
                        }
                        let _e364 = phi_574_;
                        let _e366 = phi_575_;
                        let _e368 = phi_577_;
                        if _e368 {
                            phi_582_ = (_e366 + 1u);
                        } else {
                            phi_582_ = 0u;
                        }
                        let _e372 = phi_582_;
                        let _e373 = select(_e364, _e366, _e368);
                        let _e374 = select(_e359, select(2u, _e359, _e358), _e368);
                        let _e375 = -(_e354);
                        if (_e375 < -126i) {
                            phi_614_ = -126i;
                        } else {
                            phi_614_ = select(_e375, 127i, (_e375 > 127i));
                        }
                        let _e380 = phi_614_;
                        let _e385 = bitcast<f32>((bitcast<u32>((_e380 + 127i)) << bitcast<u32>(23i)));
                        let _e391 = bitcast<f32>((bitcast<u32>(((_e375 - _e380) + 127i)) << bitcast<u32>(23i)));
                        let _e396 = global_9.member[_e147].member.member;
                        let _e397 = (_e373 == 0u);
                        if _e397 {
                            phi_632_ = _e396[0];
                        } else {
                            phi_632_ = _e396[1];
                        }
                        let _e401 = phi_632_;
                        let _e402 = (_e373 == 2u);
                        if _e402 {
                            phi_638_ = _e396[2];
                        } else {
                            phi_638_ = _e401;
                        }
                        let _e405 = phi_638_;
                        let _e406 = global_9.member[_e147].member.member_2;
                        if _e397 {
                            phi_649_ = _e406[0];
                        } else {
                            phi_649_ = _e406[1];
                        }
                        let _e410 = phi_649_;
                        if _e402 {
                            phi_655_ = _e406[2];
                        } else {
                            phi_655_ = _e410;
                        }
                        let _e413 = phi_655_;
                        let _e415 = ((_e413 * _e385) * _e391);
                        let _e419 = (bitcast<f32>((bitcast<u32>(_e415) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e419 {
                            let _e423 = (bitcast<f32>((bitcast<u32>(_e405) & 2147483647u)) * 0.00000011920929f);
                            phi_678_ = select(0.00000000000011368684f, _e423, (_e423 > 0.00000000000011368684f));
                        } else {
                            phi_678_ = 0f;
                        }
                        let _e427 = phi_678_;
                        let _e428 = (_e405 + _e427);
                        let _e429 = (_e405 - _e427);
                        let _e430 = select(_e415, 0f, _e419);
                        if _e419 {
                            phi_689_ = 38685626000000000000000000f;
                        } else {
                            phi_689_ = (1f / _e415);
                        }
                        let _e433 = phi_689_;
                        let _e434 = (_e372 == 0u);
                        if _e434 {
                            phi_698_ = _e396[0];
                        } else {
                            phi_698_ = _e396[1];
                        }
                        let _e438 = phi_698_;
                        let _e439 = (_e372 == 2u);
                        if _e439 {
                            phi_704_ = _e396[2];
                        } else {
                            phi_704_ = _e438;
                        }
                        let _e442 = phi_704_;
                        if _e434 {
                            phi_715_ = _e406[0];
                        } else {
                            phi_715_ = _e406[1];
                        }
                        let _e446 = phi_715_;
                        if _e439 {
                            phi_721_ = _e406[2];
                        } else {
                            phi_721_ = _e446;
                        }
                        let _e449 = phi_721_;
                        let _e451 = ((_e449 * _e385) * _e391);
                        let _e455 = (bitcast<f32>((bitcast<u32>(_e451) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e455 {
                            let _e459 = (bitcast<f32>((bitcast<u32>(_e442) & 2147483647u)) * 0.00000011920929f);
                            phi_744_ = select(0.00000000000011368684f, _e459, (_e459 > 0.00000000000011368684f));
                        } else {
                            phi_744_ = 0f;
                        }
                        let _e463 = phi_744_;
                        let _e464 = (_e442 + _e463);
                        let _e465 = (_e442 - _e463);
                        let _e466 = select(_e451, 0f, _e455);
                        if _e455 {
                            phi_755_ = 38685626000000000000000000f;
                        } else {
                            phi_755_ = (1f / _e451);
                        }
                        let _e469 = phi_755_;
                        let _e470 = (_e374 == 0u);
                        if _e470 {
                            phi_764_ = _e396[0];
                        } else {
                            phi_764_ = _e396[1];
                        }
                        let _e474 = phi_764_;
                        let _e475 = (_e374 == 2u);
                        if _e475 {
                            phi_770_ = _e396[2];
                        } else {
                            phi_770_ = _e474;
                        }
                        let _e478 = phi_770_;
                        if _e470 {
                            phi_781_ = _e406[0];
                        } else {
                            phi_781_ = _e406[1];
                        }
                        let _e482 = phi_781_;
                        if _e475 {
                            phi_787_ = _e406[2];
                        } else {
                            phi_787_ = _e482;
                        }
                        let _e485 = phi_787_;
                        let _e487 = ((_e485 * _e385) * _e391);
                        let _e491 = (bitcast<f32>((bitcast<u32>(_e487) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e491 {
                            let _e495 = (bitcast<f32>((bitcast<u32>(_e478) & 2147483647u)) * 0.00000011920929f);
                            phi_810_ = select(0.00000000000011368684f, _e495, (_e495 > 0.00000000000011368684f));
                        } else {
                            phi_810_ = 0f;
                        }
                        let _e499 = phi_810_;
                        let _e500 = (_e478 + _e499);
                        let _e501 = (_e478 - _e499);
                        let _e502 = select(_e487, 0f, _e491);
                        if _e491 {
                            phi_821_ = 38685626000000000000000000f;
                        } else {
                            phi_821_ = (1f / _e487);
                        }
                        let _e505 = phi_821_;
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
                            phi_921_ = select(-340282350000000000000000000000000000000f, _e545, (_e545 > -340282350000000000000000000000000000000f));
                            phi_922_ = select(-340282350000000000000000000000000000000f, _e538, (_e538 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_921_ = 0f;
                            phi_922_ = 1f;
                        }
                        let _e549 = phi_921_;
                        let _e551 = phi_922_;
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
                        phi_4537_ = false;
                        phi_1011_ = type_42(_e549, false);
                        phi_1014_ = type_58(type_30(vec4<f32>((f32(_e558) * _e159), (f32(_e564) * _e159), (f32(_e570) * _e159), 0f), vec4<f32>((f32(_e575) * _e159), (f32(_e579) * _e159), (f32(_e583) * _e159), 0f)), select(0u, 2147483648u, (_e100 == 0u)));
                        phi_1016_ = ((3u * _e100) + 1u);
                        phi_1018_ = (_e551 <= _e549);
                        phi_1020_ = 0u;
                        loop {
                            let _e593 = phi_4537_;
                            let _e595 = phi_1011_;
                            let _e597 = phi_1014_;
                            let _e599 = phi_1016_;
                            let _e601 = phi_1018_;
                            let _e603 = phi_1020_;
                            local_11 = _e595;
                            if _e601 {
                                phi_1031_ = true;
                            } else {
                                phi_1031_ = (_e603 > 0u);
                            }
                            let _e606 = phi_1031_;
                            if _e606 {
                                let _e607 = (_e599 > 0u);
                                if _e607 {
                                    if _e601 {
                                        phi_1117_ = _e597;
                                        phi_1118_ = _e601;
                                        phi_1119_ = _e603;
                                    } else {
                                        let _e608 = (_e603 - 1u);
                                        let _e609 = (_e608 % 128u);
                                        let _e610 = (_e609 < 128u);
                                        if _e610 {
                                        } else {
                                            phi_4744_ = true;
                                            break;
                                        }
                                        let _e612 = local_7[_e609];
                                        if _e610 {
                                        } else {
                                            phi_4744_ = true;
                                            break;
                                        }
                                        let _e614 = local_6[_e609];
                                        if _e610 {
                                        } else {
                                            phi_4744_ = true;
                                            break;
                                        }
                                        let _e616 = local_5[_e609];
                                        if _e610 {
                                        } else {
                                            phi_4744_ = true;
                                            break;
                                        }
                                        let _e618 = local_4[_e609];
                                        if _e610 {
                                        } else {
                                            phi_4744_ = true;
                                            break;
                                        }
                                        let _e620 = local_3[_e609];
                                        if _e610 {
                                        } else {
                                            phi_4744_ = true;
                                            break;
                                        }
                                        let _e622 = local_2[_e609];
                                        if _e610 {
                                        } else {
                                            phi_4744_ = true;
                                            break;
                                        }
                                        let _e627 = local_8[_e609];
                                        if _e610 {
                                        } else {
                                            phi_4744_ = true;
                                            break;
                                        }
                                        let _e630 = local_9[_e609];
                                        phi_1117_ = type_58(type_30(vec4<f32>(_e612, _e614, _e616, 0f), vec4<f32>(_e618, _e620, _e622, 0f)), _e627);
                                        phi_1118_ = (_e630 <= _e595.member);
                                        phi_1119_ = _e608;
                                    }
                                    let _e634 = phi_1117_;
                                    let _e636 = phi_1118_;
                                    let _e638 = phi_1119_;
                                    if _e636 {
                                        let _e643 = (_e634.member_1 & 268435455u);
                                        if ((_e634.member_1 & 2147483648u) != 0u) {
                                            phi_1138_ = _e595;
                                            phi_1141_ = type_8(0u, ((_e634.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1121 = phi_1138_;
                                                let _e1123 = phi_1141_;
                                                local_10 = _e1121;
                                                local_12 = _e1121;
                                                if (_e1123.member < _e1123.member_1) {
                                                    phi_1142_ = type_8((_e1123.member + 1u), _e1123.member_1);
                                                    phi_1164_ = type_8(1u, _e1123.member);
                                                } else {
                                                    phi_1142_ = _e1123;
                                                    phi_1164_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1136 = phi_1142_;
                                                let _e1138 = phi_1164_;
                                                let _e1142 = (bitcast<i32>(_e1138.member) != 0i);
                                                if _e1142 {
                                                    let _e1147 = (_e634.member.member_1.x - _e634.member.member.x);
                                                    let _e1150 = (_e634.member.member_1.y - _e634.member.member.y);
                                                    let _e1153 = (_e634.member.member_1.z - _e634.member.member.z);
                                                    let _e1155 = select(_e1150, _e1147, (_e1147 > _e1150));
                                                    let _e1157 = select(_e1153, _e1155, (_e1155 > _e1153));
                                                    let _e1159 = (_e1157 < (1024f * _e159));
                                                    if _e1159 {
                                                        phi_1205_ = 0u;
                                                    } else {
                                                        phi_1205_ = select(2u, 1u, (_e1157 < (2097152f * _e159)));
                                                    }
                                                    let _e1164 = phi_1205_;
                                                    switch bitcast<i32>(_e1164) {
                                                        case 0: {
                                                            phi_1211_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1211_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1211_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1211_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1167 = phi_1211_;
                                                    switch bitcast<i32>(_e1164) {
                                                        case 0: {
                                                            phi_1221_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1221_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1221_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1221_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1174 = phi_1221_;
                                                    let _e1176 = ((_e643 + (_e1138.member_1 * ((3u * _e1167) + 1u))) + (3u * _e1174));
                                                    let _e1177 = (_e1176 < _e103);
                                                    if _e1177 {
                                                        if _e1177 {
                                                        } else {
                                                            phi_4531_ = true;
                                                            break;
                                                        }
                                                        let _e1179 = global_10.member[_e1176];
                                                        phi_1237_ = _e1179;
                                                    } else {
                                                        phi_1237_ = 4294967295u;
                                                    }
                                                    let _e1181 = phi_1237_;
                                                    if _e1159 {
                                                        phi_1270_ = 0u;
                                                    } else {
                                                        phi_1270_ = select(2u, 1u, (_e1157 < (2097152f * _e159)));
                                                    }
                                                    let _e1186 = phi_1270_;
                                                    switch bitcast<i32>(_e1186) {
                                                        case 0: {
                                                            phi_1276_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1276_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1276_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1276_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1189 = phi_1276_;
                                                    let _e1193 = (_e643 + (_e1138.member_1 * ((3u * _e1189) + 1u)));
                                                    switch bitcast<i32>(_e1186) {
                                                        case 0: {
                                                            let _e1459 = (_e1193 < _e103);
                                                            if _e1459 {
                                                                if _e1459 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e1461 = global_10.member[_e1193];
                                                                phi_1300_ = _e1461;
                                                            } else {
                                                                phi_1300_ = 0u;
                                                            }
                                                            let _e1463 = phi_1300_;
                                                            let _e1465 = ((10u * _e373) & 31u);
                                                            let _e1474 = ((10u * _e372) & 31u);
                                                            let _e1483 = ((10u * _e374) & 31u);
                                                            let _e1492 = (_e1193 + 1u);
                                                            let _e1493 = (_e1492 < _e103);
                                                            if _e1493 {
                                                                if _e1493 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e1495 = global_10.member[_e1492];
                                                                phi_1343_ = _e1495;
                                                            } else {
                                                                phi_1343_ = 0u;
                                                            }
                                                            let _e1497 = phi_1343_;
                                                            let _e1520 = (_e1193 + 2u);
                                                            let _e1521 = (_e1520 < _e103);
                                                            if _e1521 {
                                                                if _e1521 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e1523 = global_10.member[_e1520];
                                                                phi_1386_ = _e1523;
                                                            } else {
                                                                phi_1386_ = 0u;
                                                            }
                                                            let _e1525 = phi_1386_;
                                                            phi_1857_ = array<array<f32, 3>, 3>(array<f32, 3>((_e634.member.member.x + (f32(bitcast<i32>(((_e1463 >> bitcast<u32>(_e1465)) & 1023u))) * _e159)), (_e634.member.member.y + (f32(bitcast<i32>(((_e1463 >> bitcast<u32>(_e1474)) & 1023u))) * _e159)), (_e634.member.member.z + (f32(bitcast<i32>(((_e1463 >> bitcast<u32>(_e1483)) & 1023u))) * _e159))), array<f32, 3>((_e634.member.member.x + (f32(bitcast<i32>(((_e1497 >> bitcast<u32>(_e1465)) & 1023u))) * _e159)), (_e634.member.member.y + (f32(bitcast<i32>(((_e1497 >> bitcast<u32>(_e1474)) & 1023u))) * _e159)), (_e634.member.member.z + (f32(bitcast<i32>(((_e1497 >> bitcast<u32>(_e1483)) & 1023u))) * _e159))), array<f32, 3>((_e634.member.member.x + (f32(bitcast<i32>(((_e1525 >> bitcast<u32>(_e1465)) & 1023u))) * _e159)), (_e634.member.member.y + (f32(bitcast<i32>(((_e1525 >> bitcast<u32>(_e1474)) & 1023u))) * _e159)), (_e634.member.member.z + (f32(bitcast<i32>(((_e1525 >> bitcast<u32>(_e1483)) & 1023u))) * _e159))));
                                                            break;
                                                        }
                                                        case 1: {
                                                            let _e1282 = (_e1193 < _e103);
                                                            if _e1282 {
                                                                if _e1282 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e1284 = global_10.member[_e1193];
                                                                phi_1429_ = _e1284;
                                                            } else {
                                                                phi_1429_ = 0u;
                                                            }
                                                            let _e1286 = phi_1429_;
                                                            let _e1287 = (_e1193 + 1u);
                                                            let _e1288 = (_e1287 < _e103);
                                                            if _e1288 {
                                                                if _e1288 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e1290 = global_10.member[_e1287];
                                                                phi_1444_ = _e1290;
                                                            } else {
                                                                phi_1444_ = 0u;
                                                            }
                                                            let _e1292 = phi_1444_;
                                                            let _e1293 = (_e373 == 1u);
                                                            if _e1293 {
                                                                phi_1454_ = ((_e1286 >> bitcast<u32>(21i)) | (_e1292 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1454_ = (_e1292 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1302 = phi_1454_;
                                                            let _e1309 = (_e372 == 1u);
                                                            if _e1309 {
                                                                phi_1474_ = ((_e1286 >> bitcast<u32>(21i)) | (_e1292 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1474_ = (_e1292 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1318 = phi_1474_;
                                                            let _e1325 = (_e374 == 1u);
                                                            if _e1325 {
                                                                phi_1494_ = ((_e1286 >> bitcast<u32>(21i)) | (_e1292 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1494_ = (_e1292 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1334 = phi_1494_;
                                                            let _e1342 = (_e1193 + 2u);
                                                            let _e1343 = (_e1342 < _e103);
                                                            if _e1343 {
                                                                if _e1343 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e1345 = global_10.member[_e1342];
                                                                phi_1520_ = _e1345;
                                                            } else {
                                                                phi_1520_ = 0u;
                                                            }
                                                            let _e1347 = phi_1520_;
                                                            let _e1348 = (_e1193 + 3u);
                                                            let _e1349 = (_e1348 < _e103);
                                                            if _e1349 {
                                                                if _e1349 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e1351 = global_10.member[_e1348];
                                                                phi_1535_ = _e1351;
                                                            } else {
                                                                phi_1535_ = 0u;
                                                            }
                                                            let _e1353 = phi_1535_;
                                                            if _e1293 {
                                                                phi_1545_ = ((_e1347 >> bitcast<u32>(21i)) | (_e1353 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1545_ = (_e1353 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1362 = phi_1545_;
                                                            if _e1309 {
                                                                phi_1565_ = ((_e1347 >> bitcast<u32>(21i)) | (_e1353 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1565_ = (_e1353 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1377 = phi_1565_;
                                                            if _e1325 {
                                                                phi_1585_ = ((_e1347 >> bitcast<u32>(21i)) | (_e1353 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1585_ = (_e1353 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1392 = phi_1585_;
                                                            let _e1400 = (_e1193 + 4u);
                                                            let _e1401 = (_e1400 < _e103);
                                                            if _e1401 {
                                                                if _e1401 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e1403 = global_10.member[_e1400];
                                                                phi_1611_ = _e1403;
                                                            } else {
                                                                phi_1611_ = 0u;
                                                            }
                                                            let _e1405 = phi_1611_;
                                                            let _e1406 = (_e1193 + 5u);
                                                            let _e1407 = (_e1406 < _e103);
                                                            if _e1407 {
                                                                if _e1407 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e1409 = global_10.member[_e1406];
                                                                phi_1626_ = _e1409;
                                                            } else {
                                                                phi_1626_ = 0u;
                                                            }
                                                            let _e1411 = phi_1626_;
                                                            if _e1293 {
                                                                phi_1636_ = ((_e1405 >> bitcast<u32>(21i)) | (_e1411 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1636_ = (_e1411 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1420 = phi_1636_;
                                                            if _e1309 {
                                                                phi_1656_ = ((_e1405 >> bitcast<u32>(21i)) | (_e1411 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1656_ = (_e1411 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1435 = phi_1656_;
                                                            if _e1325 {
                                                                phi_1676_ = ((_e1405 >> bitcast<u32>(21i)) | (_e1411 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1676_ = (_e1411 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1450 = phi_1676_;
                                                            phi_1857_ = array<array<f32, 3>, 3>(array<f32, 3>((_e634.member.member.x + (f32(bitcast<i32>((select(_e1302, _e1286, _e397) & 2097151u))) * _e159)), (_e634.member.member.y + (f32(bitcast<i32>((select(_e1318, _e1286, _e434) & 2097151u))) * _e159)), (_e634.member.member.z + (f32(bitcast<i32>((select(_e1334, _e1286, _e470) & 2097151u))) * _e159))), array<f32, 3>((_e634.member.member.x + (f32(bitcast<i32>((select(_e1362, _e1347, _e397) & 2097151u))) * _e159)), (_e634.member.member.y + (f32(bitcast<i32>((select(_e1377, _e1347, _e434) & 2097151u))) * _e159)), (_e634.member.member.z + (f32(bitcast<i32>((select(_e1392, _e1347, _e470) & 2097151u))) * _e159))), array<f32, 3>((_e634.member.member.x + (f32(bitcast<i32>((select(_e1420, _e1405, _e397) & 2097151u))) * _e159)), (_e634.member.member.y + (f32(bitcast<i32>((select(_e1435, _e1405, _e434) & 2097151u))) * _e159)), (_e634.member.member.z + (f32(bitcast<i32>((select(_e1450, _e1405, _e470) & 2097151u))) * _e159))));
                                                            break;
                                                        }
                                                        case 2: {
                                                            let _e1195 = (_e1193 + _e373);
                                                            let _e1196 = (_e1195 < _e103);
                                                            if _e1196 {
                                                                if _e1196 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e1198 = global_10.member[_e1195];
                                                                phi_1703_ = _e1198;
                                                            } else {
                                                                phi_1703_ = 0u;
                                                            }
                                                            let _e1200 = phi_1703_;
                                                            let _e1204 = (_e1193 + _e372);
                                                            let _e1205 = (_e1204 < _e103);
                                                            if _e1205 {
                                                                if _e1205 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e1207 = global_10.member[_e1204];
                                                                phi_1721_ = _e1207;
                                                            } else {
                                                                phi_1721_ = 0u;
                                                            }
                                                            let _e1209 = phi_1721_;
                                                            let _e1213 = (_e1193 + _e374);
                                                            let _e1214 = (_e1213 < _e103);
                                                            if _e1214 {
                                                                if _e1214 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e1216 = global_10.member[_e1213];
                                                                phi_1739_ = _e1216;
                                                            } else {
                                                                phi_1739_ = 0u;
                                                            }
                                                            let _e1218 = phi_1739_;
                                                            let _e1223 = (_e1193 + 3u);
                                                            let _e1224 = (_e1223 + _e373);
                                                            let _e1225 = (_e1224 < _e103);
                                                            if _e1225 {
                                                                if _e1225 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e1227 = global_10.member[_e1224];
                                                                phi_1759_ = _e1227;
                                                            } else {
                                                                phi_1759_ = 0u;
                                                            }
                                                            let _e1229 = phi_1759_;
                                                            let _e1233 = (_e1223 + _e372);
                                                            let _e1234 = (_e1233 < _e103);
                                                            if _e1234 {
                                                                if _e1234 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e1236 = global_10.member[_e1233];
                                                                phi_1777_ = _e1236;
                                                            } else {
                                                                phi_1777_ = 0u;
                                                            }
                                                            let _e1238 = phi_1777_;
                                                            let _e1242 = (_e1223 + _e374);
                                                            let _e1243 = (_e1242 < _e103);
                                                            if _e1243 {
                                                                if _e1243 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e1245 = global_10.member[_e1242];
                                                                phi_1795_ = _e1245;
                                                            } else {
                                                                phi_1795_ = 0u;
                                                            }
                                                            let _e1247 = phi_1795_;
                                                            let _e1252 = (_e1193 + 6u);
                                                            let _e1253 = (_e1252 + _e373);
                                                            let _e1254 = (_e1253 < _e103);
                                                            if _e1254 {
                                                                if _e1254 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e1256 = global_10.member[_e1253];
                                                                phi_1815_ = _e1256;
                                                            } else {
                                                                phi_1815_ = 0u;
                                                            }
                                                            let _e1258 = phi_1815_;
                                                            let _e1262 = (_e1252 + _e372);
                                                            let _e1263 = (_e1262 < _e103);
                                                            if _e1263 {
                                                                if _e1263 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e1265 = global_10.member[_e1262];
                                                                phi_1833_ = _e1265;
                                                            } else {
                                                                phi_1833_ = 0u;
                                                            }
                                                            let _e1267 = phi_1833_;
                                                            let _e1271 = (_e1252 + _e374);
                                                            let _e1272 = (_e1271 < _e103);
                                                            if _e1272 {
                                                                if _e1272 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e1274 = global_10.member[_e1271];
                                                                phi_1851_ = _e1274;
                                                            } else {
                                                                phi_1851_ = 0u;
                                                            }
                                                            let _e1276 = phi_1851_;
                                                            phi_1857_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1200)) * _e159), (f32(bitcast<i32>(_e1209)) * _e159), (f32(bitcast<i32>(_e1218)) * _e159)), array<f32, 3>((f32(bitcast<i32>(_e1229)) * _e159), (f32(bitcast<i32>(_e1238)) * _e159), (f32(bitcast<i32>(_e1247)) * _e159)), array<f32, 3>((f32(bitcast<i32>(_e1258)) * _e159), (f32(bitcast<i32>(_e1267)) * _e159), (f32(bitcast<i32>(_e1276)) * _e159)));
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1857_ = array<array<f32, 3>, 3>();
                                                            break;
                                                        }
                                                    }
                                                    let _e1550 = phi_1857_;
                                                    let _e1558 = (_e1550[0][2] - _e478);
                                                    let _e1561 = (((_e1550[0][0] - _e405) * _e502) - (_e1558 * _e430));
                                                    let _e1564 = (((_e1550[0][1] - _e442) * _e502) - (_e1558 * _e466));
                                                    let _e1571 = (_e1550[1][2] - _e478);
                                                    let _e1574 = (((_e1550[1][0] - _e405) * _e502) - (_e1571 * _e430));
                                                    let _e1577 = (((_e1550[1][1] - _e442) * _e502) - (_e1571 * _e466));
                                                    let _e1584 = (_e1550[2][2] - _e478);
                                                    let _e1587 = (((_e1550[2][0] - _e405) * _e502) - (_e1584 * _e430));
                                                    let _e1590 = (((_e1550[2][1] - _e442) * _e502) - (_e1584 * _e466));
                                                    let _e1591 = (_e1587 * _e1577);
                                                    let _e1592 = (_e1590 * _e1574);
                                                    let _e1593 = (_e1561 * _e1590);
                                                    let _e1594 = (_e1564 * _e1587);
                                                    let _e1595 = (_e1574 * _e1564);
                                                    let _e1596 = (_e1577 * _e1561);
                                                    let _e1601 = (((_e1591 >= _e1592) && (_e1593 >= _e1594)) && (_e1595 >= _e1596));
                                                    if (_e1601 || (((_e1591 <= _e1592) && (_e1593 <= _e1594)) && (_e1595 <= _e1596))) {
                                                        let _e1608 = select(-1f, 1f, _e1601);
                                                        let _e1610 = ((_e1591 - _e1592) * _e1608);
                                                        let _e1612 = select(0f, _e1610, (_e1610 > 0f));
                                                        let _e1614 = ((_e1593 - _e1594) * _e1608);
                                                        let _e1616 = select(0f, _e1614, (_e1614 > 0f));
                                                        let _e1618 = ((_e1595 - _e1596) * _e1608);
                                                        let _e1620 = select(0f, _e1618, (_e1618 > 0f));
                                                        let _e1622 = ((_e1612 + _e1616) + _e1620);
                                                        if (_e1622 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2682_ = type_21();
                                                            phi_2683_ = true;
                                                            phi_2684_ = false;
                                                        } else {
                                                            let _e1625 = select(_e1574, _e1561, (_e1561 < _e1574));
                                                            if (select(_e1587, _e1625, (_e1625 < _e1587)) > 0f) {
                                                                phi_1974_ = true;
                                                            } else {
                                                                let _e1630 = select(_e1574, _e1561, (_e1561 > _e1574));
                                                                phi_1974_ = (select(_e1587, _e1630, (_e1630 > _e1587)) < 0f);
                                                            }
                                                            let _e1635 = phi_1974_;
                                                            if _e1635 {
                                                                phi_2679_ = type_21();
                                                                phi_2680_ = true;
                                                                phi_2681_ = false;
                                                            } else {
                                                                let _e1637 = select(_e1577, _e1564, (_e1564 < _e1577));
                                                                if (select(_e1590, _e1637, (_e1637 < _e1590)) > 0f) {
                                                                    phi_2003_ = true;
                                                                } else {
                                                                    let _e1642 = select(_e1577, _e1564, (_e1564 > _e1577));
                                                                    phi_2003_ = (select(_e1590, _e1642, (_e1642 > _e1590)) < 0f);
                                                                }
                                                                let _e1647 = phi_2003_;
                                                                if _e1647 {
                                                                    phi_2677_ = type_21();
                                                                    phi_2678_ = false;
                                                                } else {
                                                                    let _e1649 = select(_e1550[1][0], _e1550[0][0], (_e1550[0][0] < _e1550[1][0]));
                                                                    let _e1653 = select(_e1550[1][0], _e1550[0][0], (_e1550[0][0] > _e1550[1][0]));
                                                                    let _e1657 = select(_e1550[1][1], _e1550[0][1], (_e1550[0][1] < _e1550[1][1]));
                                                                    let _e1661 = select(_e1550[1][1], _e1550[0][1], (_e1550[0][1] > _e1550[1][1]));
                                                                    let _e1665 = select(_e1550[1][2], _e1550[0][2], (_e1550[0][2] < _e1550[1][2]));
                                                                    let _e1669 = select(_e1550[1][2], _e1550[0][2], (_e1550[0][2] > _e1550[1][2]));
                                                                    let _e1674 = ((select(_e1550[2][0], _e1649, (_e1649 < _e1550[2][0])) - _e428) * _e433);
                                                                    let _e1675 = ((select(_e1550[2][0], _e1653, (_e1653 > _e1550[2][0])) - _e429) * _e433);
                                                                    let _e1678 = ((select(_e1550[2][1], _e1657, (_e1657 < _e1550[2][1])) - _e464) * _e469);
                                                                    let _e1679 = ((select(_e1550[2][1], _e1661, (_e1661 > _e1550[2][1])) - _e465) * _e469);
                                                                    let _e1682 = ((select(_e1550[2][2], _e1665, (_e1665 < _e1550[2][2])) - _e500) * _e505);
                                                                    let _e1683 = ((select(_e1550[2][2], _e1669, (_e1669 > _e1550[2][2])) - _e501) * _e505);
                                                                    let _e1685 = select(_e1683, _e1682, (_e1682 < _e1683));
                                                                    let _e1687 = select(_e1683, _e1682, (_e1682 > _e1683));
                                                                    let _e1689 = select(_e1675, _e1674, (_e1674 < _e1675));
                                                                    let _e1691 = select(_e1679, _e1678, (_e1678 < _e1679));
                                                                    let _e1693 = select(_e1691, _e1689, (_e1689 > _e1691));
                                                                    let _e1695 = select(_e1685, _e1693, (_e1693 > _e1685));
                                                                    let _e1697 = select(_e1675, _e1674, (_e1674 > _e1675));
                                                                    let _e1699 = select(_e1679, _e1678, (_e1678 > _e1679));
                                                                    let _e1701 = select(_e1699, _e1697, (_e1697 < _e1699));
                                                                    let _e1703 = select(_e1687, _e1701, (_e1701 < _e1687));
                                                                    let _e1704 = -(_e1685);
                                                                    let _e1710 = select(_e551, _e1695, (_e1695 > _e551));
                                                                    if (_e1710 > (_e1703 + (select(_e1704, _e1687, (_e1687 > _e1704)) * 0.0000019073523f))) {
                                                                        phi_2672_ = type_21();
                                                                        phi_2673_ = true;
                                                                    } else {
                                                                        let _e1712 = (_e1710 > _e1121.member);
                                                                        if _e1712 {
                                                                            phi_2671_ = type_21();
                                                                        } else {
                                                                            let _e1713 = vec3<f32>(_e1550[0][0], _e1550[0][1], _e1550[0][2]);
                                                                            let _e1714 = vec3<f32>(_e1550[1][0], _e1550[1][1], _e1550[1][2]);
                                                                            let _e1715 = vec3<f32>(_e1550[2][0], _e1550[2][1], _e1550[2][2]);
                                                                            let _e1716 = (_e1550[1][0] - _e1550[0][0]);
                                                                            let _e1717 = (_e1550[1][1] - _e1550[0][1]);
                                                                            let _e1718 = (_e1550[1][2] - _e1550[0][2]);
                                                                            let _e1719 = vec3<f32>(_e1716, _e1717, _e1718);
                                                                            let _e1720 = (_e1550[2][0] - _e1550[1][0]);
                                                                            let _e1721 = (_e1550[2][1] - _e1550[1][1]);
                                                                            let _e1722 = (_e1550[2][2] - _e1550[1][2]);
                                                                            let _e1723 = vec3<f32>(_e1720, _e1721, _e1722);
                                                                            let _e1724 = (_e1550[0][0] - _e1550[2][0]);
                                                                            let _e1725 = (_e1550[0][1] - _e1550[2][1]);
                                                                            let _e1726 = (_e1550[0][2] - _e1550[2][2]);
                                                                            let _e1727 = vec3<f32>(_e1724, _e1725, _e1726);
                                                                            let _e1730 = bitcast<f32>((bitcast<u32>(_e1716) & 2147483647u));
                                                                            let _e1733 = bitcast<f32>((bitcast<u32>(_e1717) & 2147483647u));
                                                                            let _e1735 = select(_e1733, _e1730, (_e1730 > _e1733));
                                                                            let _e1738 = bitcast<f32>((bitcast<u32>(_e1718) & 2147483647u));
                                                                            let _e1740 = select(_e1738, _e1735, (_e1735 > _e1738));
                                                                            let _e1743 = bitcast<f32>((bitcast<u32>(_e1720) & 2147483647u));
                                                                            let _e1746 = bitcast<f32>((bitcast<u32>(_e1721) & 2147483647u));
                                                                            let _e1748 = select(_e1746, _e1743, (_e1743 > _e1746));
                                                                            let _e1751 = bitcast<f32>((bitcast<u32>(_e1722) & 2147483647u));
                                                                            let _e1753 = select(_e1751, _e1748, (_e1748 > _e1751));
                                                                            let _e1756 = bitcast<f32>((bitcast<u32>(_e1724) & 2147483647u));
                                                                            let _e1759 = bitcast<f32>((bitcast<u32>(_e1725) & 2147483647u));
                                                                            let _e1761 = select(_e1759, _e1756, (_e1756 > _e1759));
                                                                            let _e1764 = bitcast<f32>((bitcast<u32>(_e1726) & 2147483647u));
                                                                            let _e1766 = select(_e1764, _e1761, (_e1761 > _e1764));
                                                                            let _e1768 = select(_e1753, _e1740, (_e1740 > _e1753));
                                                                            let _e1770 = select(_e1766, _e1768, (_e1768 > _e1766));
                                                                            if (_e1740 == _e1770) {
                                                                                phi_2404_ = _e1577;
                                                                                phi_2405_ = _e1574;
                                                                                phi_2406_ = _e1564;
                                                                                phi_2407_ = _e1561;
                                                                                phi_2408_ = _e1713;
                                                                                phi_2409_ = _e1727;
                                                                                phi_2410_ = _e1723;
                                                                                phi_2411_ = _e1719;
                                                                            } else {
                                                                                let _e1772 = (_e1753 == _e1770);
                                                                                let _e1777 = vec3(_e1772);
                                                                                phi_2404_ = select(_e1564, _e1590, _e1772);
                                                                                phi_2405_ = select(_e1561, _e1587, _e1772);
                                                                                phi_2406_ = select(_e1590, _e1577, _e1772);
                                                                                phi_2407_ = select(_e1587, _e1574, _e1772);
                                                                                phi_2408_ = select(_e1715, _e1714, _e1777);
                                                                                phi_2409_ = select(_e1723, _e1719, _e1777);
                                                                                phi_2410_ = select(_e1719, _e1727, _e1777);
                                                                                phi_2411_ = select(_e1727, _e1723, _e1777);
                                                                            }
                                                                            let _e1783 = phi_2404_;
                                                                            let _e1785 = phi_2405_;
                                                                            let _e1787 = phi_2406_;
                                                                            let _e1789 = phi_2407_;
                                                                            let _e1791 = phi_2408_;
                                                                            let _e1793 = phi_2409_;
                                                                            let _e1795 = phi_2410_;
                                                                            let _e1797 = phi_2411_;
                                                                            let _e1804 = ((_e1795.y * _e1793.z) - (_e1793.y * _e1795.z));
                                                                            let _e1809 = ((_e1795.z * _e1793.x) - (_e1793.z * _e1795.x));
                                                                            let _e1812 = ((_e1795.x * _e1793.y) - (_e1793.x * _e1795.y));
                                                                            if (_e1612 >= _e1616) {
                                                                                phi_2442_ = select(true, false, (_e1612 >= _e1620));
                                                                            } else {
                                                                                phi_2442_ = true;
                                                                            }
                                                                            let _e1817 = phi_2442_;
                                                                            if _e1817 {
                                                                                phi_2451_ = select(_e1715, _e1714, vec3((_e1616 >= _e1620)));
                                                                            } else {
                                                                                phi_2451_ = _e1713;
                                                                            }
                                                                            let _e1822 = phi_2451_;
                                                                            let _e1833 = (((_e1804 * (_e1822.x - _e405)) + (_e1809 * (_e1822.y - _e442))) + (_e1812 * (_e1822.z - _e478)));
                                                                            let _e1838 = (((_e1804 * _e430) + (_e1809 * _e466)) + (_e1812 * _e502));
                                                                            let _e1839 = (_e1785 - _e1789);
                                                                            let _e1840 = (_e1783 - _e1787);
                                                                            let _e1848 = (-(((_e1789 * _e1839) + (_e1787 * _e1840))) / ((_e1839 * _e1839) + (_e1840 * _e1840)));
                                                                            let _e1850 = select(1f, _e1848, (_e1848 < 1f));
                                                                            let _e1852 = select(0f, _e1850, (_e1850 > 0f));
                                                                            let _e1865 = ((_e1791.x + (_e1797.x * _e1852)) - _e405);
                                                                            let _e1866 = ((_e1791.y + (_e1797.y * _e1852)) - _e442);
                                                                            let _e1867 = ((_e1791.z + (_e1797.z * _e1852)) - _e478);
                                                                            let _e1868 = (_e1867 / _e502);
                                                                            let _e1880 = bitcast<f32>((bitcast<u32>(_e1865) & 2147483647u));
                                                                            let _e1883 = bitcast<f32>((bitcast<u32>(_e1866) & 2147483647u));
                                                                            let _e1885 = select(_e1883, _e1880, (_e1880 > _e1883));
                                                                            let _e1888 = bitcast<f32>((bitcast<u32>(_e1867) & 2147483647u));
                                                                            let _e1890 = select(_e1888, _e1885, (_e1885 > _e1888));
                                                                            let _e1896 = bitcast<f32>((bitcast<u32>(_e1804) & 2147483647u));
                                                                            let _e1899 = bitcast<f32>((bitcast<u32>(_e1809) & 2147483647u));
                                                                            let _e1901 = select(_e1899, _e1896, (_e1896 > _e1899));
                                                                            let _e1904 = bitcast<f32>((bitcast<u32>(_e1812) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1804 * _e1865) + (_e1809 * _e1866)) + (_e1812 * _e1867)) - _e1833)) & 2147483647u)) <= ((0.0000009536743f * select(_e1770, _e1890, (_e1890 > _e1770))) * select(_e1904, _e1901, (_e1901 > _e1904)))) {
                                                                                let _e1914 = bitcast<f32>((bitcast<u32>(_e1795.x) & 2147483647u));
                                                                                let _e1917 = bitcast<f32>((bitcast<u32>(_e1795.y) & 2147483647u));
                                                                                let _e1919 = select(_e1917, _e1914, (_e1914 > _e1917));
                                                                                let _e1922 = bitcast<f32>((bitcast<u32>(_e1795.z) & 2147483647u));
                                                                                let _e1928 = bitcast<f32>((bitcast<u32>(_e1793.x) & 2147483647u));
                                                                                let _e1931 = bitcast<f32>((bitcast<u32>(_e1793.y) & 2147483647u));
                                                                                let _e1933 = select(_e1931, _e1928, (_e1928 > _e1931));
                                                                                let _e1936 = bitcast<f32>((bitcast<u32>(_e1793.z) & 2147483647u));
                                                                                let _e1940 = (bitcast<f32>((bitcast<u32>(_e1838) & 2147483647u)) > ((0.0000038146973f * select(_e1922, _e1919, (_e1919 > _e1922))) * select(_e1936, _e1933, (_e1933 > _e1936))));
                                                                                if _e1940 {
                                                                                    phi_2616_ = (_e1833 / _e1838);
                                                                                } else {
                                                                                    phi_2616_ = f32();
                                                                                }
                                                                                let _e1943 = phi_2616_;
                                                                                phi_2618_ = _e1943;
                                                                                phi_2619_ = select(true, false, _e1940);
                                                                            } else {
                                                                                phi_2618_ = f32();
                                                                                phi_2619_ = true;
                                                                            }
                                                                            let _e1946 = phi_2618_;
                                                                            let _e1948 = phi_2619_;
                                                                            if _e1948 {
                                                                                let _e1956 = (((_e1804 * (_e1865 - (_e430 * _e1868))) + (_e1809 * (_e1866 - (_e466 * _e1868)))) / _e1838);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1956) & 2147483647u)) <= _e1770) {
                                                                                    phi_2639_ = (_e1868 + _e1956);
                                                                                } else {
                                                                                    phi_2639_ = _e1868;
                                                                                }
                                                                                let _e1963 = phi_2639_;
                                                                                phi_2640_ = _e1963;
                                                                            } else {
                                                                                phi_2640_ = _e1946;
                                                                            }
                                                                            let _e1965 = phi_2640_;
                                                                            let _e1967 = select(_e1703, _e1965, (_e1965 < _e1703));
                                                                            let _e1969 = select(_e1695, _e1967, (_e1967 > _e1695));
                                                                            if (_e1969 >= _e551) {
                                                                                let _e1971 = (_e1969 <= _e1121.member);
                                                                                if _e1971 {
                                                                                    let _e1972 = (1f / _e1622);
                                                                                    phi_2663_ = type_21(_e1969, (_e1616 * _e1972), (_e1620 * _e1972), _e1181);
                                                                                } else {
                                                                                    phi_2663_ = type_21();
                                                                                }
                                                                                let _e1977 = phi_2663_;
                                                                                phi_2665_ = _e1977;
                                                                                phi_2666_ = select(true, false, _e1971);
                                                                            } else {
                                                                                phi_2665_ = type_21();
                                                                                phi_2666_ = true;
                                                                            }
                                                                            let _e1980 = phi_2665_;
                                                                            let _e1982 = phi_2666_;
                                                                            if _e1982 {
                                                                                phi_2670_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2670_ = _e1980;
                                                                            }
                                                                            let _e1984 = phi_2670_;
                                                                            phi_2671_ = _e1984;
                                                                        }
                                                                        let _e1986 = phi_2671_;
                                                                        phi_2672_ = _e1986;
                                                                        phi_2673_ = _e1712;
                                                                    }
                                                                    let _e1988 = phi_2672_;
                                                                    let _e1990 = phi_2673_;
                                                                    phi_2677_ = _e1988;
                                                                    phi_2678_ = _e1990;
                                                                }
                                                                let _e1992 = phi_2677_;
                                                                let _e1994 = phi_2678_;
                                                                phi_2679_ = _e1992;
                                                                phi_2680_ = _e1647;
                                                                phi_2681_ = _e1994;
                                                            }
                                                            let _e1996 = phi_2679_;
                                                            let _e1998 = phi_2680_;
                                                            let _e2000 = phi_2681_;
                                                            phi_2682_ = _e1996;
                                                            phi_2683_ = _e1998;
                                                            phi_2684_ = _e2000;
                                                        }
                                                        let _e2002 = phi_2682_;
                                                        let _e2004 = phi_2683_;
                                                        let _e2006 = phi_2684_;
                                                        phi_2692_ = _e2002;
                                                        phi_2693_ = select(_e2006, true, _e2004);
                                                    } else {
                                                        phi_2692_ = type_21();
                                                        phi_2693_ = true;
                                                    }
                                                    let _e2009 = phi_2692_;
                                                    let _e2011 = phi_2693_;
                                                    if _e2011 {
                                                        phi_2697_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2697_ = _e2009;
                                                    }
                                                    let _e2013 = phi_2697_;
                                                    if (_e2013.member_3 != 4294967295u) {
                                                        if (_e1181 == _e168) {
                                                            phi_3026_ = false;
                                                        } else {
                                                            let _e2017 = (_e1181 < arrayLength((&global_5.member)));
                                                            if _e2017 {
                                                                if _e2017 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e2019 = global_5.member[_e1181];
                                                                phi_2720_ = _e2019;
                                                            } else {
                                                                phi_2720_ = 4294967295u;
                                                            }
                                                            let _e2021 = phi_2720_;
                                                            let _e2022 = (_e2021 < arrayLength((&global_6.member)));
                                                            if _e2022 {
                                                                if _e2022 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e2024 = global_6.member[_e2021];
                                                                phi_2734_ = _e2024;
                                                            } else {
                                                                phi_2734_ = 0i;
                                                            }
                                                            let _e2026 = phi_2734_;
                                                            let _e2027 = (_e2026 == 0i);
                                                            if _e2027 {
                                                                phi_3025_ = true;
                                                            } else {
                                                                if _e397 {
                                                                    phi_2755_ = vec3<f32>(_e1550[0][0], _e1550[0][1], _e1550[0][2]);
                                                                } else {
                                                                    if (_e373 == 1u) {
                                                                        phi_2754_ = vec3<f32>(_e1550[0][2], _e1550[0][0], _e1550[0][1]);
                                                                    } else {
                                                                        phi_2754_ = vec3<f32>(_e1550[0][1], _e1550[0][2], _e1550[0][0]);
                                                                    }
                                                                    let _e2032 = phi_2754_;
                                                                    phi_2755_ = _e2032;
                                                                }
                                                                let _e2035 = phi_2755_;
                                                                if _e397 {
                                                                    phi_2772_ = vec3<f32>(_e1550[1][0], _e1550[1][1], _e1550[1][2]);
                                                                } else {
                                                                    if (_e373 == 1u) {
                                                                        phi_2771_ = vec3<f32>(_e1550[1][2], _e1550[1][0], _e1550[1][1]);
                                                                    } else {
                                                                        phi_2771_ = vec3<f32>(_e1550[1][1], _e1550[1][2], _e1550[1][0]);
                                                                    }
                                                                    let _e2040 = phi_2771_;
                                                                    phi_2772_ = _e2040;
                                                                }
                                                                let _e2043 = phi_2772_;
                                                                if _e397 {
                                                                    phi_2789_ = vec3<f32>(_e1550[2][0], _e1550[2][1], _e1550[2][2]);
                                                                } else {
                                                                    if (_e373 == 1u) {
                                                                        phi_2788_ = vec3<f32>(_e1550[2][2], _e1550[2][0], _e1550[2][1]);
                                                                    } else {
                                                                        phi_2788_ = vec3<f32>(_e1550[2][1], _e1550[2][2], _e1550[2][0]);
                                                                    }
                                                                    let _e2048 = phi_2788_;
                                                                    phi_2789_ = _e2048;
                                                                }
                                                                let _e2051 = phi_2789_;
                                                                let _e2054 = (_e2043.x - _e2035.x);
                                                                let _e2057 = (_e2043.y - _e2035.y);
                                                                let _e2060 = (_e2043.z - _e2035.z);
                                                                let _e2062 = (_e2051.x - _e2035.x);
                                                                let _e2064 = (_e2051.y - _e2035.y);
                                                                let _e2066 = (_e2051.z - _e2035.z);
                                                                if (_e240.member_1 == 1u) {
                                                                    phi_2825_ = (vec3<f32>(_e240.member[0], _e240.member[1], _e240.member[2]) - _e2035);
                                                                } else {
                                                                    phi_2825_ = vec3<f32>(_e240.member[0], _e240.member[1], _e240.member[2]);
                                                                }
                                                                let _e2081 = phi_2825_;
                                                                let _e2087 = bitcast<f32>((bitcast<u32>((_e2054 * _e2064)) ^ _e240.member_3[0]));
                                                                let _e2091 = bitcast<f32>((bitcast<u32>((_e2057 * _e2062)) ^ _e240.member_3[0]));
                                                                let _e2095 = bitcast<f32>((bitcast<u32>((_e2057 * _e2066)) ^ _e240.member_3[0]));
                                                                let _e2099 = bitcast<f32>((bitcast<u32>((_e2060 * _e2064)) ^ _e240.member_3[0]));
                                                                let _e2103 = bitcast<f32>((bitcast<u32>((_e2060 * _e2062)) ^ _e240.member_3[0]));
                                                                let _e2107 = bitcast<f32>((bitcast<u32>((_e2054 * _e2066)) ^ _e240.member_3[0]));
                                                                let _e2108 = (_e2095 - _e2099);
                                                                let _e2109 = (_e2103 - _e2107);
                                                                let _e2110 = (_e2087 - _e2091);
                                                                let _e2134 = (bitcast<f32>((bitcast<u32>(_e2095) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2099) & 2147483647u)));
                                                                let _e2141 = (bitcast<f32>((bitcast<u32>(_e2103) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2107) & 2147483647u)));
                                                                let _e2148 = (bitcast<f32>((bitcast<u32>(_e2087) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2091) & 2147483647u)));
                                                                if (_e240.member_2 == 0f) {
                                                                    phi_3007_ = 0f;
                                                                } else {
                                                                    let _e2178 = bitcast<f32>((bitcast<u32>(_e2108) & 2147483647u));
                                                                    let _e2181 = bitcast<f32>((bitcast<u32>(_e2109) & 2147483647u));
                                                                    let _e2184 = bitcast<f32>((bitcast<u32>(_e2110) & 2147483647u));
                                                                    let _e2186 = select(_e2184, _e2181, (_e2181 > _e2184));
                                                                    let _e2190 = select(_e2184, _e2181, (_e2181 < _e2184));
                                                                    let _e2194 = select(_e2181, _e2178, (_e2178 < _e2181));
                                                                    let _e2196 = select(_e2181, _e2178, (_e2178 > _e2181));
                                                                    let _e2198 = select(_e2184, _e2196, (_e2196 < _e2184));
                                                                    phi_3007_ = bitcast<f32>((bitcast<u32>((_e240.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2186, _e2178, (_e2178 > _e2186)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2198, _e2194, (_e2194 > _e2198)))) ^ _e240.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2190, _e2178, (_e2178 < _e2190)))) ^ _e240.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e2134 + _e2141) + _e2148))) ^ _e240.member_3[0]))) * 1.0000005f)) ^ _e240.member_3[0])))) ^ _e240.member_3[0]));
                                                                }
                                                                let _e2225 = phi_3007_;
                                                                phi_3025_ = (_e2027 || !(((((bitcast<f32>((bitcast<u32>((_e2081.x * _e2108)) ^ _e240.member_3[0])) + bitcast<f32>((bitcast<u32>((_e2081.y * _e2109)) ^ _e240.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e2081.z * _e2110)) ^ _e240.member_3[0]))) * f32(-(_e2026))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2081.x) & 2147483647u)) * _e2134)) ^ _e240.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2081.y) & 2147483647u)) * _e2141)) ^ _e240.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2081.z) & 2147483647u)) * _e2148)) ^ _e240.member_3[0]))))) ^ _e240.member_3[0])) + _e2225) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e2239 = phi_3025_;
                                                            phi_3026_ = _e2239;
                                                        }
                                                        let _e2241 = phi_3026_;
                                                        if _e2241 {
                                                            phi_3031_ = type_42(_e1121.member, true);
                                                        } else {
                                                            phi_3031_ = _e1121;
                                                        }
                                                        let _e2246 = phi_3031_;
                                                        phi_3032_ = _e2246;
                                                    } else {
                                                        phi_3032_ = _e1121;
                                                    }
                                                    let _e2248 = phi_3032_;
                                                    phi_1139_ = _e2248;
                                                } else {
                                                    phi_1139_ = type_42();
                                                }
                                                let _e2250 = phi_1139_;
                                                continue;
                                                continuing {
                                                    phi_1138_ = _e2250;
                                                    phi_1141_ = _e1136;
                                                    phi_4531_ = _e593;
                                                    break if !(_e1142);
                                                }
                                            }
                                            let _e2253 = phi_4531_;
                                            phi_4744_ = _e2253;
                                            if _e2253 {
                                                break;
                                            }
                                            let _e2255 = local_10;
                                            phi_4748_ = _e2253;
                                            let _e2495 = local_12;
                                            phi_4273_ = _e2495;
                                            phi_4274_ = _e634;
                                            phi_4275_ = false;
                                            phi_4276_ = select(_e638, 0u, _e2255.member_1);
                                        } else {
                                            if (_e634.member_1 >= _e100) {
                                                phi_3829_ = type_59(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_58(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_58(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e634.member_1 < _e100) {
                                                } else {
                                                    phi_4744_ = true;
                                                    break;
                                                }
                                                let _e650 = (_e373 * 2u);
                                                let _e652 = ((1u + _e650) % 7u);
                                                if (_e652 < 7u) {
                                                } else {
                                                    phi_4744_ = true;
                                                    break;
                                                }
                                                let _e657 = global_8.member[_e634.member_1][_e652];
                                                let _e659 = ((_e650 + 2u) % 7u);
                                                if (_e659 < 7u) {
                                                } else {
                                                    phi_4744_ = true;
                                                    break;
                                                }
                                                let _e664 = global_8.member[_e634.member_1][_e659];
                                                let _e665 = (_e372 * 2u);
                                                let _e667 = ((1u + _e665) % 7u);
                                                if (_e667 < 7u) {
                                                } else {
                                                    phi_4744_ = true;
                                                    break;
                                                }
                                                let _e672 = global_8.member[_e634.member_1][_e667];
                                                let _e674 = ((_e665 + 2u) % 7u);
                                                if (_e674 < 7u) {
                                                } else {
                                                    phi_4744_ = true;
                                                    break;
                                                }
                                                let _e679 = global_8.member[_e634.member_1][_e674];
                                                let _e680 = (_e374 * 2u);
                                                let _e682 = ((1u + _e680) % 7u);
                                                if (_e682 < 7u) {
                                                } else {
                                                    phi_4744_ = true;
                                                    break;
                                                }
                                                let _e687 = global_8.member[_e634.member_1][_e682];
                                                let _e689 = ((_e680 + 2u) % 7u);
                                                if (_e689 < 7u) {
                                                } else {
                                                    phi_4744_ = true;
                                                    break;
                                                }
                                                let _e694 = global_8.member[_e634.member_1][_e689];
                                                let _e717 = (bitcast<f32>((bitcast<u32>((_e634.member.member_1.x - _e634.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e718 = (bitcast<f32>((bitcast<u32>((_e634.member.member_1.y - _e634.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e719 = (bitcast<f32>((bitcast<u32>((_e634.member.member_1.z - _e634.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e721 = select(_e159, _e717, (_e717 > _e159));
                                                let _e723 = select(_e159, _e718, (_e718 > _e159));
                                                let _e725 = select(_e159, _e719, (_e719 > _e159));
                                                let _e750 = bitcast<u32>((f32(bitcast<i32>((_e657 & 2097151u))) * _e721));
                                                let _e755 = (bitcast<i32>((_e657 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e758 = bitcast<f32>((_e750 & bitcast<u32>(_e755)));
                                                let _e759 = bitcast<u32>((f32(bitcast<i32>((_e672 & 2097151u))) * _e723));
                                                let _e764 = (bitcast<i32>((_e672 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e767 = bitcast<f32>((_e759 & bitcast<u32>(_e764)));
                                                let _e768 = bitcast<u32>((f32(bitcast<i32>((_e687 & 2097151u))) * _e725));
                                                let _e773 = (bitcast<i32>((_e687 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e776 = bitcast<f32>((_e768 & bitcast<u32>(_e773)));
                                                let _e780 = bitcast<f32>((_e750 & bitcast<u32>(~(_e755))));
                                                let _e784 = bitcast<f32>((_e759 & bitcast<u32>(~(_e764))));
                                                let _e788 = bitcast<f32>((_e768 & bitcast<u32>(~(_e773))));
                                                let _e789 = bitcast<u32>((f32(bitcast<i32>((_e664 & 2097151u))) * _e721));
                                                let _e794 = (bitcast<i32>((_e664 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e797 = bitcast<f32>((_e789 & bitcast<u32>(_e794)));
                                                let _e798 = bitcast<u32>((f32(bitcast<i32>((_e679 & 2097151u))) * _e723));
                                                let _e803 = (bitcast<i32>((_e679 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e806 = bitcast<f32>((_e798 & bitcast<u32>(_e803)));
                                                let _e807 = bitcast<u32>((f32(bitcast<i32>((_e694 & 2097151u))) * _e725));
                                                let _e812 = (bitcast<i32>((_e694 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e815 = bitcast<f32>((_e807 & bitcast<u32>(_e812)));
                                                let _e819 = bitcast<f32>((_e789 & bitcast<u32>(~(_e794))));
                                                let _e823 = bitcast<f32>((_e798 & bitcast<u32>(~(_e803))));
                                                let _e827 = bitcast<f32>((_e807 & bitcast<u32>(~(_e812))));
                                                let _e828 = (_e634.member.member.x + _e758);
                                                let _e829 = (_e634.member.member.y + _e767);
                                                let _e830 = (_e634.member.member.z + _e776);
                                                let _e833 = (_e634.member.member_1.x - _e797);
                                                let _e834 = (_e634.member.member_1.y - _e806);
                                                let _e835 = (_e634.member.member_1.z - _e815);
                                                let _e854 = (_e833 - _e828);
                                                let _e855 = (_e834 - _e829);
                                                let _e856 = (_e835 - _e830);
                                                let _e858 = select(_e855, _e854, (_e854 > _e855));
                                                let _e860 = select(_e856, _e858, (_e858 > _e856));
                                                if (_e860 < (1024f * _e159)) {
                                                    phi_3530_ = 0u;
                                                } else {
                                                    phi_3530_ = select(2u, 1u, (_e860 < (2097152f * _e159)));
                                                }
                                                let _e867 = phi_3530_;
                                                switch bitcast<i32>(_e867) {
                                                    case 0: {
                                                        phi_3536_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_3536_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_3536_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_3536_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e870 = phi_3536_;
                                                let _e876 = global_8.member[_e634.member_1][0u];
                                                let _e880 = global_8.member[_e634.member_1][2u];
                                                let _e884 = global_8.member[_e634.member_1][4u];
                                                let _e888 = global_8.member[_e634.member_1][6u];
                                                let _e900 = (((_e880 >> bitcast<u32>(22i)) | ((_e884 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e888 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e901 = (_e876 & 268435455u);
                                                let _e902 = (_e900 & 268435455u);
                                                let _e905 = ((_e876 >> bitcast<u32>(28u)) & 7u);
                                                let _e913 = ((_e876 >> bitcast<u32>(31i)) | (((_e900 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e914 = (_e905 != 0u);
                                                if (_e905 == 0u) {
                                                    phi_3791_ = _e901;
                                                } else {
                                                    if (_e905 == 7u) {
                                                        phi_3790_ = 2147483648u;
                                                    } else {
                                                        phi_3790_ = ((2147483648u | (_e905 << bitcast<u32>(28u))) | (_e902 & 268435455u));
                                                    }
                                                    let _e923 = phi_3790_;
                                                    phi_3791_ = _e923;
                                                }
                                                let _e925 = phi_3791_;
                                                if _e914 {
                                                    let _e926 = (_e905 != 7u);
                                                    if _e926 {
                                                        phi_3801_ = (_e902 + (_e905 * ((3u * _e870) + 1u)));
                                                    } else {
                                                        phi_3801_ = u32();
                                                    }
                                                    let _e930 = phi_3801_;
                                                    phi_3803_ = _e930;
                                                    phi_3804_ = select(true, false, _e926);
                                                } else {
                                                    phi_3803_ = u32();
                                                    phi_3804_ = true;
                                                }
                                                let _e933 = phi_3803_;
                                                let _e935 = phi_3804_;
                                                if (_e913 == 0u) {
                                                    phi_3825_ = (_e901 + select(0u, 1u, !(_e914)));
                                                } else {
                                                    if (_e913 == 7u) {
                                                        phi_3824_ = 2147483648u;
                                                    } else {
                                                        phi_3824_ = ((2147483648u | (_e913 << bitcast<u32>(28u))) | (select(_e933, _e902, _e935) & 268435455u));
                                                    }
                                                    let _e948 = phi_3824_;
                                                    phi_3825_ = _e948;
                                                }
                                                let _e950 = phi_3825_;
                                                phi_3829_ = type_59(array<vec4<f32>, 3>(vec4<f32>(_e828, (_e634.member.member.x + _e780), _e833, (_e634.member.member_1.x - _e819)), vec4<f32>(_e829, (_e634.member.member.y + _e784), _e834, (_e634.member.member_1.y - _e823)), vec4<f32>(_e830, (_e634.member.member.z + _e788), _e835, (_e634.member.member_1.z - _e827))), type_58(type_30((_e634.member.member + vec4<f32>(_e758, _e767, _e776, 0f)), (_e634.member.member_1 - vec4<f32>(_e797, _e806, _e815, 0f))), _e925), type_58(type_30((_e634.member.member + vec4<f32>(_e780, _e784, _e788, 0f)), (_e634.member.member_1 - vec4<f32>(_e819, _e823, _e827, 0f))), _e950));
                                            }
                                            let _e955 = phi_3829_;
                                            let _e967 = ((_e955.member[0].x - _e428) * _e433);
                                            let _e968 = ((_e955.member[0].y - _e428) * _e433);
                                            let _e969 = ((_e955.member[0].z - _e429) * _e433);
                                            let _e970 = ((_e955.member[0].w - _e429) * _e433);
                                            let _e980 = ((_e955.member[1].x - _e464) * _e469);
                                            let _e981 = ((_e955.member[1].y - _e464) * _e469);
                                            let _e982 = ((_e955.member[1].z - _e465) * _e469);
                                            let _e983 = ((_e955.member[1].w - _e465) * _e469);
                                            let _e993 = ((_e955.member[2].x - _e500) * _e505);
                                            let _e994 = ((_e955.member[2].y - _e500) * _e505);
                                            let _e995 = ((_e955.member[2].z - _e501) * _e505);
                                            let _e996 = ((_e955.member[2].w - _e501) * _e505);
                                            let _e998 = select(_e995, _e993, (_e993 < _e995));
                                            let _e1000 = select(_e996, _e994, (_e994 < _e996));
                                            let _e1002 = select(_e995, _e993, (_e993 > _e995));
                                            let _e1004 = select(_e996, _e994, (_e994 > _e996));
                                            let _e1006 = select(_e969, _e967, (_e967 < _e969));
                                            let _e1008 = select(_e970, _e968, (_e968 < _e970));
                                            let _e1010 = select(_e982, _e980, (_e980 < _e982));
                                            let _e1012 = select(_e983, _e981, (_e981 < _e983));
                                            let _e1014 = select(_e1010, _e1006, (_e1006 > _e1010));
                                            let _e1016 = select(_e1012, _e1008, (_e1008 > _e1012));
                                            let _e1018 = select(_e998, _e1014, (_e1014 > _e998));
                                            let _e1020 = select(_e1000, _e1016, (_e1016 > _e1000));
                                            let _e1022 = select(_e969, _e967, (_e967 > _e969));
                                            let _e1024 = select(_e970, _e968, (_e968 > _e970));
                                            let _e1026 = select(_e982, _e980, (_e980 > _e982));
                                            let _e1028 = select(_e983, _e981, (_e981 > _e983));
                                            let _e1030 = select(_e1026, _e1022, (_e1022 < _e1026));
                                            let _e1032 = select(_e1028, _e1024, (_e1024 < _e1028));
                                            let _e1037 = -(_e998);
                                            let _e1038 = -(_e1000);
                                            let _e1045 = (select(_e1002, _e1030, (_e1030 < _e1002)) + (select(_e1037, _e1002, (_e1002 > _e1037)) * 0.0000019073523f));
                                            let _e1046 = (select(_e1004, _e1032, (_e1032 < _e1004)) + (select(_e1038, _e1004, (_e1004 > _e1038)) * 0.0000019073523f));
                                            let _e1048 = select(_e551, _e1018, (_e1018 > _e551));
                                            let _e1050 = select(_e551, _e1020, (_e1020 > _e551));
                                            let _e1055 = (_e1048 <= select(_e595.member, _e1045, (_e1045 < _e595.member)));
                                            let _e1056 = (_e1050 <= select(_e595.member, _e1046, (_e1046 < _e595.member)));
                                            let _e1057 = (_e1048 <= _e1050);
                                            if _e1055 {
                                                if _e1056 {
                                                    if _e1057 {
                                                        phi_4173_ = _e955.member_2;
                                                    } else {
                                                        phi_4173_ = _e955.member_1;
                                                    }
                                                    let _e1061 = phi_4173_;
                                                    let _e1083 = (_e638 % 128u);
                                                    let _e1084 = (_e1083 < 128u);
                                                    if _e1084 {
                                                    } else {
                                                        phi_4744_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1083] = _e1061.member_1;
                                                    if _e1084 {
                                                    } else {
                                                        phi_4744_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1083] = _e1061.member.member.x;
                                                    if _e1084 {
                                                    } else {
                                                        phi_4744_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1083] = _e1061.member.member.y;
                                                    if _e1084 {
                                                    } else {
                                                        phi_4744_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1083] = _e1061.member.member.z;
                                                    if _e1084 {
                                                    } else {
                                                        phi_4744_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1083] = _e1061.member.member_1.x;
                                                    if _e1084 {
                                                    } else {
                                                        phi_4744_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1083] = _e1061.member.member_1.y;
                                                    if _e1084 {
                                                    } else {
                                                        phi_4744_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1083] = _e1061.member.member_1.z;
                                                    if _e1084 {
                                                    } else {
                                                        phi_4744_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1083] = select(_e1050, _e1048, (_e1048 > _e1050));
                                                    if _e1057 {
                                                        phi_4250_ = _e955.member_1;
                                                    } else {
                                                        phi_4250_ = _e955.member_2;
                                                    }
                                                    let _e1097 = phi_4250_;
                                                    phi_4251_ = _e1097;
                                                    phi_4252_ = (_e638 + 1u);
                                                } else {
                                                    phi_4251_ = type_58();
                                                    phi_4252_ = u32();
                                                }
                                                let _e1099 = phi_4251_;
                                                let _e1101 = phi_4252_;
                                                phi_4254_ = _e1099;
                                                phi_4255_ = _e1101;
                                                phi_4256_ = select(true, false, _e1056);
                                            } else {
                                                phi_4254_ = type_58();
                                                phi_4255_ = u32();
                                                phi_4256_ = true;
                                            }
                                            let _e1104 = phi_4254_;
                                            let _e1106 = phi_4255_;
                                            let _e1108 = phi_4256_;
                                            if _e1108 {
                                                if _e1055 {
                                                    phi_4265_ = _e955.member_1;
                                                } else {
                                                    phi_4265_ = _e955.member_2;
                                                }
                                                let _e1112 = phi_4265_;
                                                phi_4270_ = _e1112;
                                                phi_4271_ = select(_e1056, true, _e1055);
                                            } else {
                                                phi_4270_ = _e1104;
                                                phi_4271_ = _e636;
                                            }
                                            let _e1115 = phi_4270_;
                                            let _e1117 = phi_4271_;
                                            phi_4748_ = _e593;
                                            phi_4273_ = _e595;
                                            phi_4274_ = _e1115;
                                            phi_4275_ = _e1117;
                                            phi_4276_ = select(_e1106, _e638, _e1108);
                                        }
                                        let _e2259 = phi_4748_;
                                        let _e2261 = phi_4273_;
                                        let _e2263 = phi_4274_;
                                        let _e2265 = phi_4275_;
                                        let _e2267 = phi_4276_;
                                        phi_4747_ = _e2259;
                                        phi_4277_ = _e2261;
                                        phi_4278_ = _e2263;
                                        phi_4279_ = (_e599 - 1u);
                                        phi_4280_ = _e2265;
                                        phi_4281_ = _e2267;
                                    } else {
                                        phi_4747_ = _e593;
                                        phi_4277_ = _e595;
                                        phi_4278_ = _e634;
                                        phi_4279_ = _e599;
                                        phi_4280_ = _e636;
                                        phi_4281_ = _e638;
                                    }
                                    let _e2269 = phi_4747_;
                                    let _e2271 = phi_4277_;
                                    let _e2273 = phi_4278_;
                                    let _e2275 = phi_4279_;
                                    let _e2277 = phi_4280_;
                                    let _e2279 = phi_4281_;
                                    phi_4746_ = _e2269;
                                    phi_4282_ = _e2271;
                                    phi_4283_ = _e2273;
                                    phi_4284_ = _e2275;
                                    phi_4285_ = _e2277;
                                    phi_4286_ = _e2279;
                                } else {
                                    phi_4746_ = _e593;
                                    phi_4282_ = type_42();
                                    phi_4283_ = type_58();
                                    phi_4284_ = u32();
                                    phi_4285_ = bool();
                                    phi_4286_ = u32();
                                }
                                let _e2281 = phi_4746_;
                                let _e2283 = phi_4282_;
                                let _e2285 = phi_4283_;
                                let _e2287 = phi_4284_;
                                let _e2289 = phi_4285_;
                                let _e2291 = phi_4286_;
                                phi_4745_ = _e2281;
                                phi_1012_ = _e2283;
                                phi_1015_ = _e2285;
                                phi_1017_ = _e2287;
                                phi_1019_ = _e2289;
                                phi_1021_ = _e2291;
                                phi_4287_ = _e607;
                            } else {
                                phi_4745_ = _e593;
                                phi_1012_ = type_42();
                                phi_1015_ = type_58();
                                phi_1017_ = u32();
                                phi_1019_ = bool();
                                phi_1021_ = u32();
                                phi_4287_ = false;
                            }
                            let _e2293 = phi_4745_;
                            let _e2295 = phi_1012_;
                            let _e2297 = phi_1015_;
                            let _e2299 = phi_1017_;
                            let _e2301 = phi_1019_;
                            let _e2303 = phi_1021_;
                            let _e2305 = phi_4287_;
                            continue;
                            continuing {
                                phi_4537_ = _e2293;
                                phi_1011_ = _e2295;
                                phi_1014_ = _e2297;
                                phi_1016_ = _e2299;
                                phi_1018_ = _e2301;
                                phi_1020_ = _e2303;
                                phi_4744_ = _e2293;
                                break if !(_e2305);
                            }
                        }
                        let _e2308 = phi_4744_;
                        if _e2308 {
                            break;
                        }
                        let _e2310 = local_11;
                        if _e2310.member_1 {
                        } else {
                            if _e241 {
                            } else {
                                break;
                            }
                            let _e2314 = global_2.member[_e147];
                            if _e162 {
                            } else {
                                break;
                            }
                            let _e2318 = global_9.member[_e147].member_1;
                            if _e241 {
                            } else {
                                break;
                            }
                            global_2.member[_e147] = type_23(_e2314.member, _e2314.member_1, _e2314.member_2, array<f32, 3>((_e2314.member_3[0] + (_e2318[0] * _e2314.member_1[0])), (_e2314.member_3[1] + (_e2318[1] * _e2314.member_1[1])), (_e2314.member_3[2] + (_e2318[2] * _e2314.member_1[2]))), _e2314.member_4);
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
