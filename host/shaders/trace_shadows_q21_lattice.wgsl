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
    var phi_334_: u32;
    var phi_378_: i32;
    var phi_402_: type_36;
    var phi_552_: i32;
    var phi_553_: i32;
    var phi_563_: bool;
    var phi_573_: u32;
    var phi_574_: u32;
    var phi_576_: bool;
    var phi_581_: u32;
    var phi_613_: i32;
    var phi_631_: f32;
    var phi_637_: f32;
    var phi_648_: f32;
    var phi_654_: f32;
    var phi_677_: f32;
    var phi_688_: f32;
    var phi_697_: f32;
    var phi_703_: f32;
    var phi_714_: f32;
    var phi_720_: f32;
    var phi_743_: f32;
    var phi_754_: f32;
    var phi_763_: f32;
    var phi_769_: f32;
    var phi_780_: f32;
    var phi_786_: f32;
    var phi_809_: f32;
    var phi_820_: f32;
    var phi_920_: f32;
    var phi_921_: f32;
    var phi_4539_: bool;
    var phi_1010_: type_42;
    var phi_1013_: type_58;
    var phi_1015_: u32;
    var phi_1017_: bool;
    var phi_1019_: u32;
    var phi_1030_: bool;
    var phi_1116_: type_58;
    var phi_1117_: bool;
    var phi_1118_: u32;
    var phi_3532_: u32;
    var phi_3538_: u32;
    var phi_3792_: u32;
    var phi_3793_: u32;
    var phi_3803_: u32;
    var phi_3805_: u32;
    var phi_3806_: bool;
    var phi_3826_: u32;
    var phi_3827_: u32;
    var phi_3831_: type_59;
    var phi_4175_: type_58;
    var phi_4252_: type_58;
    var phi_4253_: type_58;
    var phi_4254_: u32;
    var phi_4256_: type_58;
    var phi_4257_: u32;
    var phi_4258_: bool;
    var phi_4267_: type_58;
    var phi_4272_: type_58;
    var phi_4273_: bool;
    var phi_1137_: type_42;
    var phi_1140_: type_8;
    var phi_1141_: type_8;
    var phi_1163_: type_8;
    var phi_1204_: u32;
    var phi_1210_: u32;
    var phi_1220_: u32;
    var phi_1236_: u32;
    var phi_1269_: u32;
    var phi_1275_: u32;
    var phi_1702_: u32;
    var phi_1720_: u32;
    var phi_1738_: u32;
    var phi_1758_: u32;
    var phi_1776_: u32;
    var phi_1794_: u32;
    var phi_1814_: u32;
    var phi_1832_: u32;
    var phi_1850_: u32;
    var phi_1428_: u32;
    var phi_1443_: u32;
    var phi_1453_: u32;
    var phi_1473_: u32;
    var phi_1493_: u32;
    var phi_1519_: u32;
    var phi_1534_: u32;
    var phi_1544_: u32;
    var phi_1564_: u32;
    var phi_1584_: u32;
    var phi_1610_: u32;
    var phi_1625_: u32;
    var phi_1635_: u32;
    var phi_1655_: u32;
    var phi_1675_: u32;
    var phi_1299_: u32;
    var phi_1342_: u32;
    var phi_1385_: u32;
    var phi_1856_: array<array<f32, 3>, 3>;
    var phi_1973_: bool;
    var phi_2002_: bool;
    var phi_2403_: f32;
    var phi_2404_: f32;
    var phi_2405_: f32;
    var phi_2406_: f32;
    var phi_2407_: vec3<f32>;
    var phi_2408_: vec3<f32>;
    var phi_2409_: vec3<f32>;
    var phi_2410_: vec3<f32>;
    var phi_2441_: bool;
    var phi_2450_: vec3<f32>;
    var phi_2617_: bool;
    var phi_2641_: f32;
    var phi_2642_: f32;
    var phi_2665_: type_21;
    var phi_2667_: type_21;
    var phi_2668_: bool;
    var phi_2672_: type_21;
    var phi_2673_: type_21;
    var phi_2674_: type_21;
    var phi_2675_: bool;
    var phi_2679_: type_21;
    var phi_2680_: bool;
    var phi_2681_: type_21;
    var phi_2682_: bool;
    var phi_2683_: bool;
    var phi_2684_: type_21;
    var phi_2685_: bool;
    var phi_2686_: bool;
    var phi_2694_: type_21;
    var phi_2695_: bool;
    var phi_2699_: type_21;
    var phi_2722_: u32;
    var phi_2736_: i32;
    var phi_2756_: vec3<f32>;
    var phi_2757_: vec3<f32>;
    var phi_2773_: vec3<f32>;
    var phi_2774_: vec3<f32>;
    var phi_2790_: vec3<f32>;
    var phi_2791_: vec3<f32>;
    var phi_2827_: vec3<f32>;
    var phi_3009_: f32;
    var phi_3027_: bool;
    var phi_3028_: bool;
    var phi_3033_: type_42;
    var phi_3034_: type_42;
    var phi_1138_: type_42;
    var phi_4533_: bool;
    var local_10: type_42;
    var phi_4750_: bool;
    var phi_4275_: type_42;
    var phi_4276_: type_58;
    var phi_4277_: bool;
    var phi_4278_: u32;
    var phi_4749_: bool;
    var phi_4279_: type_42;
    var phi_4280_: type_58;
    var phi_4281_: u32;
    var phi_4282_: bool;
    var phi_4283_: u32;
    var phi_4748_: bool;
    var phi_4284_: type_42;
    var phi_4285_: type_58;
    var phi_4286_: u32;
    var phi_4287_: bool;
    var phi_4288_: u32;
    var phi_4747_: bool;
    var phi_1011_: type_42;
    var phi_1014_: type_58;
    var phi_1016_: u32;
    var phi_1018_: bool;
    var phi_1020_: u32;
    var phi_4289_: bool;
    var phi_4746_: bool;
    var local_11: type_42;
    var local_12: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e97 = global;
            let _e99 = arrayLength((&global_8.member));
            let _e102 = arrayLength((&global_10.member));
            let _e114 = arrayLength((&global_7.member));
            let _e118 = global_4.member[0u][0u];
            let _e122 = global_4.member[0u][1u];
            let _e126 = global_4.member[0u][2u];
            let _e130 = global_4.member[0u][3u];
            let _e134 = global_4.member[1u][0u];
            let _e138 = global_4.member[1u][1u];
            let _e142 = global_4.member[1u][2u];
            let _e146 = (_e97.x + (_e97.y * 2097152u));
            let _e158 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e130) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e118), bitcast<i32>(_e122), bitcast<i32>(_e126));
            local = array<i32, 3>(bitcast<i32>(_e134), bitcast<i32>(_e138), bitcast<i32>(_e142));
            let _e161 = (_e146 < arrayLength((&global_9.member)));
            if _e161 {
                if _e161 {
                } else {
                    break;
                }
                let _e165 = global_9.member[_e146].member_2;
                phi_334_ = _e165;
            } else {
                phi_334_ = 4294967295u;
            }
            let _e167 = phi_334_;
            let _e170 = global_1.member[0u];
            let _e174 = global_3.member[0u][0u];
            let _e178 = global_3.member[0u][1u];
            let _e182 = global_3.member[0u][2u];
            let _e186 = global_3.member[0u][3u];
            let _e190 = global_3.member[1u][0u];
            let _e194 = global_3.member[1u][1u];
            let _e198 = global_3.member[1u][2u];
            let _e202 = global_3.member[1u][3u];
            let _e203 = bitcast<f32>(_e174);
            let _e204 = bitcast<f32>(_e178);
            let _e205 = bitcast<f32>(_e182);
            let _e207 = bitcast<f32>(_e190);
            let _e208 = array<u32, 3>(_e194, _e198, _e202);
            let _e210 = bitcast<i32>(_e170);
            if (_e210 < -126i) {
                phi_378_ = -126i;
            } else {
                phi_378_ = select(_e210, 127i, (_e210 > 127i));
            }
            let _e215 = phi_378_;
            let _e220 = bitcast<f32>((bitcast<u32>((_e215 + 127i)) << bitcast<u32>(23i)));
            let _e226 = bitcast<f32>((bitcast<u32>(((_e210 - _e215) + 127i)) << bitcast<u32>(23i)));
            if (_e186 == 0u) {
                phi_402_ = type_36(array<f32, 3>(_e203, _e204, _e205), _e186, _e207, _e208);
            } else {
                phi_402_ = type_36(array<f32, 3>(((_e203 * _e220) * _e226), ((_e204 * _e220) * _e226), ((_e205 * _e220) * _e226)), _e186, ((_e207 * _e220) * _e226), _e208);
            }
            let _e239 = phi_402_;
            if _e161 {
                let _e240 = (_e146 < arrayLength((&global_2.member)));
                if _e240 {
                    if _e161 {
                    } else {
                        break;
                    }
                    let _e245 = global_9.member[_e146].member.member_1;
                    let _e250 = global_9.member[_e146].member.member_3;
                    if (_e245 <= _e250) {
                        let _e252 = (1u < _e114);
                        if _e252 {
                            if (0u < _e114) {
                            } else {
                                break;
                            }
                            let _e256 = atomicAdd((&global_7.member[0u]), 1u);
                            if ((_e256 + 1u) < _e256) {
                                if _e252 {
                                } else {
                                    break;
                                }
                                let _e261 = atomicAdd((&global_7.member[1u]), 1u);
                            }
                        }
                        if _e161 {
                        } else {
                            break;
                        }
                        let _e271 = global_9.member[_e146].member.member_2[0u];
                        let _e273 = (bitcast<u32>(_e271) & 2147483647u);
                        let _e279 = global_9.member[_e146].member.member_2[1u];
                        let _e281 = (bitcast<u32>(_e279) & 2147483647u);
                        let _e287 = global_9.member[_e146].member.member_2[2u];
                        let _e289 = (bitcast<u32>(_e287) & 2147483647u);
                        let _e295 = global_9.member[_e146].member.member[0u];
                        let _e297 = (bitcast<u32>(_e295) & 2147483647u);
                        let _e303 = global_9.member[_e146].member.member[1u];
                        let _e305 = (bitcast<u32>(_e303) & 2147483647u);
                        let _e311 = global_9.member[_e146].member.member[2u];
                        let _e313 = (bitcast<u32>(_e311) & 2147483647u);
                        let _e315 = select(_e281, _e273, (_e281 < _e273));
                        let _e317 = select(_e289, _e315, (_e289 < _e315));
                        let _e319 = select(_e297, _e317, (_e297 < _e317));
                        let _e321 = select(_e305, _e319, (_e305 < _e319));
                        let _e323 = select(_e313, _e321, (_e313 < _e321));
                        let _e325 = (bitcast<u32>(_e245) & 2147483647u);
                        let _e334 = (((select(_e325, _e323, (_e325 < _e323)) < 2139095040u) && ((bitcast<u32>(_e250) & 2147483647u) <= 2139095040u)) && (_e317 > 0u));
                        if _e334 {
                            let _e337 = (bitcast<u32>(bitcast<f32>(_e317)) & 2147483647u);
                            if (_e337 >= 8388608u) {
                                phi_552_ = (bitcast<i32>((_e337 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_552_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e337)), 32u, (_e337 == 0u))));
                            }
                            let _e351 = phi_552_;
                            phi_553_ = _e351;
                        } else {
                            phi_553_ = 0i;
                        }
                        let _e353 = phi_553_;
                        let _e354 = (_e273 == _e317);
                        if _e354 {
                            phi_563_ = true;
                        } else {
                            phi_563_ = (_e281 == _e317);
                        }
                        let _e357 = phi_563_;
                        let _e358 = select(1u, 0u, _e354);
                        if _e357 {
                            let _e359 = (_e358 + 1u);
                            phi_573_ = _e359;
                            phi_574_ = _e359;
                            phi_576_ = select(true, false, (_e359 == 2u));
                        } else {
                            phi_573_ = u32();
                            phi_574_ = 0u;
                            phi_576_ = true;
                        }
                        let _e363 = phi_573_;
                        let _e365 = phi_574_;
                        let _e367 = phi_576_;
                        if _e367 {
                            phi_581_ = (_e365 + 1u);
                        } else {
                            phi_581_ = 0u;
                        }
                        let _e371 = phi_581_;
                        let _e372 = select(_e363, _e365, _e367);
                        let _e373 = select(_e358, select(2u, _e358, _e357), _e367);
                        let _e374 = -(_e353);
                        if (_e374 < -126i) {
                            phi_613_ = -126i;
                        } else {
                            phi_613_ = select(_e374, 127i, (_e374 > 127i));
                        }
                        let _e379 = phi_613_;
                        let _e384 = bitcast<f32>((bitcast<u32>((_e379 + 127i)) << bitcast<u32>(23i)));
                        let _e390 = bitcast<f32>((bitcast<u32>(((_e374 - _e379) + 127i)) << bitcast<u32>(23i)));
                        let _e395 = global_9.member[_e146].member.member;
                        let _e396 = (_e372 == 0u);
                        if _e396 {
                            phi_631_ = _e395[0];
                        } else {
                            phi_631_ = _e395[1];
                        }
                        let _e400 = phi_631_;
                        let _e401 = (_e372 == 2u);
                        if _e401 {
                            phi_637_ = _e395[2];
                        } else {
                            phi_637_ = _e400;
                        }
                        let _e404 = phi_637_;
                        let _e405 = global_9.member[_e146].member.member_2;
                        if _e396 {
                            phi_648_ = _e405[0];
                        } else {
                            phi_648_ = _e405[1];
                        }
                        let _e409 = phi_648_;
                        if _e401 {
                            phi_654_ = _e405[2];
                        } else {
                            phi_654_ = _e409;
                        }
                        let _e412 = phi_654_;
                        let _e414 = ((_e412 * _e384) * _e390);
                        let _e418 = (bitcast<f32>((bitcast<u32>(_e414) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e418 {
                            let _e422 = (bitcast<f32>((bitcast<u32>(_e404) & 2147483647u)) * 0.00000011920929f);
                            phi_677_ = select(0.00000000000011368684f, _e422, (_e422 > 0.00000000000011368684f));
                        } else {
                            phi_677_ = 0f;
                        }
                        let _e426 = phi_677_;
                        let _e427 = (_e404 + _e426);
                        let _e428 = (_e404 - _e426);
                        let _e429 = select(_e414, 0f, _e418);
                        if _e418 {
                            phi_688_ = 38685626000000000000000000f;
                        } else {
                            phi_688_ = (1f / _e414);
                        }
                        let _e432 = phi_688_;
                        let _e433 = (_e371 == 0u);
                        if _e433 {
                            phi_697_ = _e395[0];
                        } else {
                            phi_697_ = _e395[1];
                        }
                        let _e437 = phi_697_;
                        let _e438 = (_e371 == 2u);
                        if _e438 {
                            phi_703_ = _e395[2];
                        } else {
                            phi_703_ = _e437;
                        }
                        let _e441 = phi_703_;
                        if _e433 {
                            phi_714_ = _e405[0];
                        } else {
                            phi_714_ = _e405[1];
                        }
                        let _e445 = phi_714_;
                        if _e438 {
                            phi_720_ = _e405[2];
                        } else {
                            phi_720_ = _e445;
                        }
                        let _e448 = phi_720_;
                        let _e450 = ((_e448 * _e384) * _e390);
                        let _e454 = (bitcast<f32>((bitcast<u32>(_e450) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e454 {
                            let _e458 = (bitcast<f32>((bitcast<u32>(_e441) & 2147483647u)) * 0.00000011920929f);
                            phi_743_ = select(0.00000000000011368684f, _e458, (_e458 > 0.00000000000011368684f));
                        } else {
                            phi_743_ = 0f;
                        }
                        let _e462 = phi_743_;
                        let _e463 = (_e441 + _e462);
                        let _e464 = (_e441 - _e462);
                        let _e465 = select(_e450, 0f, _e454);
                        if _e454 {
                            phi_754_ = 38685626000000000000000000f;
                        } else {
                            phi_754_ = (1f / _e450);
                        }
                        let _e468 = phi_754_;
                        let _e469 = (_e373 == 0u);
                        if _e469 {
                            phi_763_ = _e395[0];
                        } else {
                            phi_763_ = _e395[1];
                        }
                        let _e473 = phi_763_;
                        let _e474 = (_e373 == 2u);
                        if _e474 {
                            phi_769_ = _e395[2];
                        } else {
                            phi_769_ = _e473;
                        }
                        let _e477 = phi_769_;
                        if _e469 {
                            phi_780_ = _e405[0];
                        } else {
                            phi_780_ = _e405[1];
                        }
                        let _e481 = phi_780_;
                        if _e474 {
                            phi_786_ = _e405[2];
                        } else {
                            phi_786_ = _e481;
                        }
                        let _e484 = phi_786_;
                        let _e486 = ((_e484 * _e384) * _e390);
                        let _e490 = (bitcast<f32>((bitcast<u32>(_e486) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e490 {
                            let _e494 = (bitcast<f32>((bitcast<u32>(_e477) & 2147483647u)) * 0.00000011920929f);
                            phi_809_ = select(0.00000000000011368684f, _e494, (_e494 > 0.00000000000011368684f));
                        } else {
                            phi_809_ = 0f;
                        }
                        let _e498 = phi_809_;
                        let _e499 = (_e477 + _e498);
                        let _e500 = (_e477 - _e498);
                        let _e501 = select(_e486, 0f, _e490);
                        if _e490 {
                            phi_820_ = 38685626000000000000000000f;
                        } else {
                            phi_820_ = (1f / _e486);
                        }
                        let _e504 = phi_820_;
                        let _e507 = bitcast<f32>((bitcast<u32>(_e404) & 2147483647u));
                        let _e510 = bitcast<f32>((bitcast<u32>(_e441) & 2147483647u));
                        let _e512 = select(_e510, _e507, (_e507 > _e510));
                        let _e515 = bitcast<f32>((bitcast<u32>(_e477) & 2147483647u));
                        if (_e334 && (select(_e515, _e512, (_e512 > _e515)) <= 1099511600000f)) {
                            let _e520 = (_e353 / 3i);
                            let _e527 = bitcast<f32>((bitcast<u32>((_e520 + 127i)) << bitcast<u32>(23i)));
                            let _e534 = bitcast<f32>((bitcast<u32>(((_e353 - (2i * _e520)) + 127i)) << bitcast<u32>(23i)));
                            let _e535 = (((_e245 * _e527) * _e527) * _e534);
                            let _e537 = select(340282350000000000000000000000000000000f, _e535, (_e535 < 340282350000000000000000000000000000000f));
                            let _e542 = (((_e250 * _e527) * _e527) * _e534);
                            let _e544 = select(340282350000000000000000000000000000000f, _e542, (_e542 < 340282350000000000000000000000000000000f));
                            phi_920_ = select(-340282350000000000000000000000000000000f, _e544, (_e544 > -340282350000000000000000000000000000000f));
                            phi_921_ = select(-340282350000000000000000000000000000000f, _e537, (_e537 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_920_ = 0f;
                            phi_921_ = 1f;
                        }
                        let _e548 = phi_920_;
                        let _e550 = phi_921_;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e554 = (_e372 % 3u);
                        let _e555 = (_e554 < 3u);
                        if _e555 {
                        } else {
                            break;
                        }
                        let _e557 = local_1[_e554];
                        let _e560 = (_e371 % 3u);
                        let _e561 = (_e560 < 3u);
                        if _e561 {
                        } else {
                            break;
                        }
                        let _e563 = local_1[_e560];
                        let _e566 = (_e373 % 3u);
                        let _e567 = (_e566 < 3u);
                        if _e567 {
                        } else {
                            break;
                        }
                        let _e569 = local_1[_e566];
                        if _e555 {
                        } else {
                            break;
                        }
                        let _e574 = local[_e554];
                        if _e561 {
                        } else {
                            break;
                        }
                        let _e578 = local[_e560];
                        if _e567 {
                        } else {
                            break;
                        }
                        let _e582 = local[_e566];
                        phi_4539_ = false;
                        phi_1010_ = type_42(_e548, false);
                        phi_1013_ = type_58(type_30(vec4<f32>((f32(_e557) * _e158), (f32(_e563) * _e158), (f32(_e569) * _e158), 0f), vec4<f32>((f32(_e574) * _e158), (f32(_e578) * _e158), (f32(_e582) * _e158), 0f)), select(0u, 2147483648u, (_e99 == 0u)));
                        phi_1015_ = ((3u * _e99) + 1u);
                        phi_1017_ = (_e550 <= _e548);
                        phi_1019_ = 0u;
                        loop {
                            let _e592 = phi_4539_;
                            let _e594 = phi_1010_;
                            let _e596 = phi_1013_;
                            let _e598 = phi_1015_;
                            let _e600 = phi_1017_;
                            let _e602 = phi_1019_;
                            local_11 = _e594;
                            if _e600 {
                                phi_1030_ = true;
                            } else {
                                phi_1030_ = (_e602 > 0u);
                            }
                            let _e605 = phi_1030_;
                            if _e605 {
                                let _e606 = (_e598 > 0u);
                                if _e606 {
                                    if _e600 {
                                        phi_1116_ = _e596;
                                        phi_1117_ = _e600;
                                        phi_1118_ = _e602;
                                    } else {
                                        let _e607 = (_e602 - 1u);
                                        let _e608 = (_e607 % 128u);
                                        let _e609 = (_e608 < 128u);
                                        if _e609 {
                                        } else {
                                            phi_4746_ = true;
                                            break;
                                        }
                                        let _e611 = local_7[_e608];
                                        if _e609 {
                                        } else {
                                            phi_4746_ = true;
                                            break;
                                        }
                                        let _e613 = local_6[_e608];
                                        if _e609 {
                                        } else {
                                            phi_4746_ = true;
                                            break;
                                        }
                                        let _e615 = local_5[_e608];
                                        if _e609 {
                                        } else {
                                            phi_4746_ = true;
                                            break;
                                        }
                                        let _e617 = local_4[_e608];
                                        if _e609 {
                                        } else {
                                            phi_4746_ = true;
                                            break;
                                        }
                                        let _e619 = local_3[_e608];
                                        if _e609 {
                                        } else {
                                            phi_4746_ = true;
                                            break;
                                        }
                                        let _e621 = local_2[_e608];
                                        if _e609 {
                                        } else {
                                            phi_4746_ = true;
                                            break;
                                        }
                                        let _e626 = local_8[_e608];
                                        if _e609 {
                                        } else {
                                            phi_4746_ = true;
                                            break;
                                        }
                                        let _e629 = local_9[_e608];
                                        phi_1116_ = type_58(type_30(vec4<f32>(_e611, _e613, _e615, 0f), vec4<f32>(_e617, _e619, _e621, 0f)), _e626);
                                        phi_1117_ = (_e629 <= _e594.member);
                                        phi_1118_ = _e607;
                                    }
                                    let _e633 = phi_1116_;
                                    let _e635 = phi_1117_;
                                    let _e637 = phi_1118_;
                                    if _e635 {
                                        let _e642 = (_e633.member_1 & 268435455u);
                                        if ((_e633.member_1 & 2147483648u) != 0u) {
                                            phi_1137_ = _e594;
                                            phi_1140_ = type_8(0u, ((_e633.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1120 = phi_1137_;
                                                let _e1122 = phi_1140_;
                                                local_10 = _e1120;
                                                local_12 = _e1120;
                                                if (_e1122.member < _e1122.member_1) {
                                                    phi_1141_ = type_8((_e1122.member + 1u), _e1122.member_1);
                                                    phi_1163_ = type_8(1u, _e1122.member);
                                                } else {
                                                    phi_1141_ = _e1122;
                                                    phi_1163_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1135 = phi_1141_;
                                                let _e1137 = phi_1163_;
                                                let _e1141 = (bitcast<i32>(_e1137.member) != 0i);
                                                if _e1141 {
                                                    let _e1146 = (_e633.member.member_1.x - _e633.member.member.x);
                                                    let _e1149 = (_e633.member.member_1.y - _e633.member.member.y);
                                                    let _e1152 = (_e633.member.member_1.z - _e633.member.member.z);
                                                    let _e1154 = select(_e1149, _e1146, (_e1146 > _e1149));
                                                    let _e1156 = select(_e1152, _e1154, (_e1154 > _e1152));
                                                    let _e1158 = (_e1156 < (1024f * _e158));
                                                    if _e1158 {
                                                        phi_1204_ = 0u;
                                                    } else {
                                                        phi_1204_ = select(2u, 1u, (_e1156 < (2097152f * _e158)));
                                                    }
                                                    let _e1163 = phi_1204_;
                                                    switch bitcast<i32>(_e1163) {
                                                        case 0: {
                                                            phi_1210_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1210_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1210_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1210_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1166 = phi_1210_;
                                                    switch bitcast<i32>(_e1163) {
                                                        case 0: {
                                                            phi_1220_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1220_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1220_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1220_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1173 = phi_1220_;
                                                    let _e1175 = ((_e642 + (_e1137.member_1 * ((3u * _e1166) + 1u))) + (3u * _e1173));
                                                    let _e1176 = (_e1175 < _e102);
                                                    if _e1176 {
                                                        if _e1176 {
                                                        } else {
                                                            phi_4533_ = true;
                                                            break;
                                                        }
                                                        let _e1178 = global_10.member[_e1175];
                                                        phi_1236_ = _e1178;
                                                    } else {
                                                        phi_1236_ = 4294967295u;
                                                    }
                                                    let _e1180 = phi_1236_;
                                                    if _e1158 {
                                                        phi_1269_ = 0u;
                                                    } else {
                                                        phi_1269_ = select(2u, 1u, (_e1156 < (2097152f * _e158)));
                                                    }
                                                    let _e1185 = phi_1269_;
                                                    switch bitcast<i32>(_e1185) {
                                                        case 0: {
                                                            phi_1275_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1275_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1275_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1275_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1188 = phi_1275_;
                                                    let _e1192 = (_e642 + (_e1137.member_1 * ((3u * _e1188) + 1u)));
                                                    switch bitcast<i32>(_e1185) {
                                                        case 0: {
                                                            let _e1458 = (_e1192 < _e102);
                                                            if _e1458 {
                                                                if _e1458 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e1460 = global_10.member[_e1192];
                                                                phi_1299_ = _e1460;
                                                            } else {
                                                                phi_1299_ = 0u;
                                                            }
                                                            let _e1462 = phi_1299_;
                                                            let _e1464 = ((10u * _e372) & 31u);
                                                            let _e1473 = ((10u * _e371) & 31u);
                                                            let _e1482 = ((10u * _e373) & 31u);
                                                            let _e1491 = (_e1192 + 1u);
                                                            let _e1492 = (_e1491 < _e102);
                                                            if _e1492 {
                                                                if _e1492 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e1494 = global_10.member[_e1491];
                                                                phi_1342_ = _e1494;
                                                            } else {
                                                                phi_1342_ = 0u;
                                                            }
                                                            let _e1496 = phi_1342_;
                                                            let _e1519 = (_e1192 + 2u);
                                                            let _e1520 = (_e1519 < _e102);
                                                            if _e1520 {
                                                                if _e1520 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e1522 = global_10.member[_e1519];
                                                                phi_1385_ = _e1522;
                                                            } else {
                                                                phi_1385_ = 0u;
                                                            }
                                                            let _e1524 = phi_1385_;
                                                            phi_1856_ = array<array<f32, 3>, 3>(array<f32, 3>((_e633.member.member.x + (f32(bitcast<i32>(((_e1462 >> bitcast<u32>(_e1464)) & 1023u))) * _e158)), (_e633.member.member.y + (f32(bitcast<i32>(((_e1462 >> bitcast<u32>(_e1473)) & 1023u))) * _e158)), (_e633.member.member.z + (f32(bitcast<i32>(((_e1462 >> bitcast<u32>(_e1482)) & 1023u))) * _e158))), array<f32, 3>((_e633.member.member.x + (f32(bitcast<i32>(((_e1496 >> bitcast<u32>(_e1464)) & 1023u))) * _e158)), (_e633.member.member.y + (f32(bitcast<i32>(((_e1496 >> bitcast<u32>(_e1473)) & 1023u))) * _e158)), (_e633.member.member.z + (f32(bitcast<i32>(((_e1496 >> bitcast<u32>(_e1482)) & 1023u))) * _e158))), array<f32, 3>((_e633.member.member.x + (f32(bitcast<i32>(((_e1524 >> bitcast<u32>(_e1464)) & 1023u))) * _e158)), (_e633.member.member.y + (f32(bitcast<i32>(((_e1524 >> bitcast<u32>(_e1473)) & 1023u))) * _e158)), (_e633.member.member.z + (f32(bitcast<i32>(((_e1524 >> bitcast<u32>(_e1482)) & 1023u))) * _e158))));
                                                            break;
                                                        }
                                                        case 1: {
                                                            let _e1281 = (_e1192 < _e102);
                                                            if _e1281 {
                                                                if _e1281 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e1283 = global_10.member[_e1192];
                                                                phi_1428_ = _e1283;
                                                            } else {
                                                                phi_1428_ = 0u;
                                                            }
                                                            let _e1285 = phi_1428_;
                                                            let _e1286 = (_e1192 + 1u);
                                                            let _e1287 = (_e1286 < _e102);
                                                            if _e1287 {
                                                                if _e1287 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e1289 = global_10.member[_e1286];
                                                                phi_1443_ = _e1289;
                                                            } else {
                                                                phi_1443_ = 0u;
                                                            }
                                                            let _e1291 = phi_1443_;
                                                            let _e1292 = (_e372 == 1u);
                                                            if _e1292 {
                                                                phi_1453_ = ((_e1285 >> bitcast<u32>(21i)) | (_e1291 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1453_ = (_e1291 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1301 = phi_1453_;
                                                            let _e1308 = (_e371 == 1u);
                                                            if _e1308 {
                                                                phi_1473_ = ((_e1285 >> bitcast<u32>(21i)) | (_e1291 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1473_ = (_e1291 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1317 = phi_1473_;
                                                            let _e1324 = (_e373 == 1u);
                                                            if _e1324 {
                                                                phi_1493_ = ((_e1285 >> bitcast<u32>(21i)) | (_e1291 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1493_ = (_e1291 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1333 = phi_1493_;
                                                            let _e1341 = (_e1192 + 2u);
                                                            let _e1342 = (_e1341 < _e102);
                                                            if _e1342 {
                                                                if _e1342 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e1344 = global_10.member[_e1341];
                                                                phi_1519_ = _e1344;
                                                            } else {
                                                                phi_1519_ = 0u;
                                                            }
                                                            let _e1346 = phi_1519_;
                                                            let _e1347 = (_e1192 + 3u);
                                                            let _e1348 = (_e1347 < _e102);
                                                            if _e1348 {
                                                                if _e1348 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e1350 = global_10.member[_e1347];
                                                                phi_1534_ = _e1350;
                                                            } else {
                                                                phi_1534_ = 0u;
                                                            }
                                                            let _e1352 = phi_1534_;
                                                            if _e1292 {
                                                                phi_1544_ = ((_e1346 >> bitcast<u32>(21i)) | (_e1352 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1544_ = (_e1352 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1361 = phi_1544_;
                                                            if _e1308 {
                                                                phi_1564_ = ((_e1346 >> bitcast<u32>(21i)) | (_e1352 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1564_ = (_e1352 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1376 = phi_1564_;
                                                            if _e1324 {
                                                                phi_1584_ = ((_e1346 >> bitcast<u32>(21i)) | (_e1352 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1584_ = (_e1352 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1391 = phi_1584_;
                                                            let _e1399 = (_e1192 + 4u);
                                                            let _e1400 = (_e1399 < _e102);
                                                            if _e1400 {
                                                                if _e1400 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e1402 = global_10.member[_e1399];
                                                                phi_1610_ = _e1402;
                                                            } else {
                                                                phi_1610_ = 0u;
                                                            }
                                                            let _e1404 = phi_1610_;
                                                            let _e1405 = (_e1192 + 5u);
                                                            let _e1406 = (_e1405 < _e102);
                                                            if _e1406 {
                                                                if _e1406 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e1408 = global_10.member[_e1405];
                                                                phi_1625_ = _e1408;
                                                            } else {
                                                                phi_1625_ = 0u;
                                                            }
                                                            let _e1410 = phi_1625_;
                                                            if _e1292 {
                                                                phi_1635_ = ((_e1404 >> bitcast<u32>(21i)) | (_e1410 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1635_ = (_e1410 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1419 = phi_1635_;
                                                            if _e1308 {
                                                                phi_1655_ = ((_e1404 >> bitcast<u32>(21i)) | (_e1410 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1655_ = (_e1410 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1434 = phi_1655_;
                                                            if _e1324 {
                                                                phi_1675_ = ((_e1404 >> bitcast<u32>(21i)) | (_e1410 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1675_ = (_e1410 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1449 = phi_1675_;
                                                            phi_1856_ = array<array<f32, 3>, 3>(array<f32, 3>((_e633.member.member.x + (f32(bitcast<i32>((select(_e1301, _e1285, _e396) & 2097151u))) * _e158)), (_e633.member.member.y + (f32(bitcast<i32>((select(_e1317, _e1285, _e433) & 2097151u))) * _e158)), (_e633.member.member.z + (f32(bitcast<i32>((select(_e1333, _e1285, _e469) & 2097151u))) * _e158))), array<f32, 3>((_e633.member.member.x + (f32(bitcast<i32>((select(_e1361, _e1346, _e396) & 2097151u))) * _e158)), (_e633.member.member.y + (f32(bitcast<i32>((select(_e1376, _e1346, _e433) & 2097151u))) * _e158)), (_e633.member.member.z + (f32(bitcast<i32>((select(_e1391, _e1346, _e469) & 2097151u))) * _e158))), array<f32, 3>((_e633.member.member.x + (f32(bitcast<i32>((select(_e1419, _e1404, _e396) & 2097151u))) * _e158)), (_e633.member.member.y + (f32(bitcast<i32>((select(_e1434, _e1404, _e433) & 2097151u))) * _e158)), (_e633.member.member.z + (f32(bitcast<i32>((select(_e1449, _e1404, _e469) & 2097151u))) * _e158))));
                                                            break;
                                                        }
                                                        case 2: {
                                                            let _e1194 = (_e1192 + _e372);
                                                            let _e1195 = (_e1194 < _e102);
                                                            if _e1195 {
                                                                if _e1195 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e1197 = global_10.member[_e1194];
                                                                phi_1702_ = _e1197;
                                                            } else {
                                                                phi_1702_ = 0u;
                                                            }
                                                            let _e1199 = phi_1702_;
                                                            let _e1203 = (_e1192 + _e371);
                                                            let _e1204 = (_e1203 < _e102);
                                                            if _e1204 {
                                                                if _e1204 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e1206 = global_10.member[_e1203];
                                                                phi_1720_ = _e1206;
                                                            } else {
                                                                phi_1720_ = 0u;
                                                            }
                                                            let _e1208 = phi_1720_;
                                                            let _e1212 = (_e1192 + _e373);
                                                            let _e1213 = (_e1212 < _e102);
                                                            if _e1213 {
                                                                if _e1213 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e1215 = global_10.member[_e1212];
                                                                phi_1738_ = _e1215;
                                                            } else {
                                                                phi_1738_ = 0u;
                                                            }
                                                            let _e1217 = phi_1738_;
                                                            let _e1222 = (_e1192 + 3u);
                                                            let _e1223 = (_e1222 + _e372);
                                                            let _e1224 = (_e1223 < _e102);
                                                            if _e1224 {
                                                                if _e1224 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e1226 = global_10.member[_e1223];
                                                                phi_1758_ = _e1226;
                                                            } else {
                                                                phi_1758_ = 0u;
                                                            }
                                                            let _e1228 = phi_1758_;
                                                            let _e1232 = (_e1222 + _e371);
                                                            let _e1233 = (_e1232 < _e102);
                                                            if _e1233 {
                                                                if _e1233 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e1235 = global_10.member[_e1232];
                                                                phi_1776_ = _e1235;
                                                            } else {
                                                                phi_1776_ = 0u;
                                                            }
                                                            let _e1237 = phi_1776_;
                                                            let _e1241 = (_e1222 + _e373);
                                                            let _e1242 = (_e1241 < _e102);
                                                            if _e1242 {
                                                                if _e1242 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e1244 = global_10.member[_e1241];
                                                                phi_1794_ = _e1244;
                                                            } else {
                                                                phi_1794_ = 0u;
                                                            }
                                                            let _e1246 = phi_1794_;
                                                            let _e1251 = (_e1192 + 6u);
                                                            let _e1252 = (_e1251 + _e372);
                                                            let _e1253 = (_e1252 < _e102);
                                                            if _e1253 {
                                                                if _e1253 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e1255 = global_10.member[_e1252];
                                                                phi_1814_ = _e1255;
                                                            } else {
                                                                phi_1814_ = 0u;
                                                            }
                                                            let _e1257 = phi_1814_;
                                                            let _e1261 = (_e1251 + _e371);
                                                            let _e1262 = (_e1261 < _e102);
                                                            if _e1262 {
                                                                if _e1262 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e1264 = global_10.member[_e1261];
                                                                phi_1832_ = _e1264;
                                                            } else {
                                                                phi_1832_ = 0u;
                                                            }
                                                            let _e1266 = phi_1832_;
                                                            let _e1270 = (_e1251 + _e373);
                                                            let _e1271 = (_e1270 < _e102);
                                                            if _e1271 {
                                                                if _e1271 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e1273 = global_10.member[_e1270];
                                                                phi_1850_ = _e1273;
                                                            } else {
                                                                phi_1850_ = 0u;
                                                            }
                                                            let _e1275 = phi_1850_;
                                                            phi_1856_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1199)) * _e158), (f32(bitcast<i32>(_e1208)) * _e158), (f32(bitcast<i32>(_e1217)) * _e158)), array<f32, 3>((f32(bitcast<i32>(_e1228)) * _e158), (f32(bitcast<i32>(_e1237)) * _e158), (f32(bitcast<i32>(_e1246)) * _e158)), array<f32, 3>((f32(bitcast<i32>(_e1257)) * _e158), (f32(bitcast<i32>(_e1266)) * _e158), (f32(bitcast<i32>(_e1275)) * _e158)));
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1856_ = array<array<f32, 3>, 3>();
                                                            break;
                                                        }
                                                    }
                                                    let _e1549 = phi_1856_;
                                                    let _e1557 = (_e1549[0][2] - _e477);
                                                    let _e1560 = (((_e1549[0][0] - _e404) * _e501) - (_e1557 * _e429));
                                                    let _e1563 = (((_e1549[0][1] - _e441) * _e501) - (_e1557 * _e465));
                                                    let _e1570 = (_e1549[1][2] - _e477);
                                                    let _e1573 = (((_e1549[1][0] - _e404) * _e501) - (_e1570 * _e429));
                                                    let _e1576 = (((_e1549[1][1] - _e441) * _e501) - (_e1570 * _e465));
                                                    let _e1583 = (_e1549[2][2] - _e477);
                                                    let _e1586 = (((_e1549[2][0] - _e404) * _e501) - (_e1583 * _e429));
                                                    let _e1589 = (((_e1549[2][1] - _e441) * _e501) - (_e1583 * _e465));
                                                    let _e1590 = (_e1586 * _e1576);
                                                    let _e1591 = (_e1589 * _e1573);
                                                    let _e1592 = (_e1560 * _e1589);
                                                    let _e1593 = (_e1563 * _e1586);
                                                    let _e1594 = (_e1573 * _e1563);
                                                    let _e1595 = (_e1576 * _e1560);
                                                    let _e1600 = (((_e1590 >= _e1591) && (_e1592 >= _e1593)) && (_e1594 >= _e1595));
                                                    if (_e1600 || (((_e1590 <= _e1591) && (_e1592 <= _e1593)) && (_e1594 <= _e1595))) {
                                                        let _e1607 = select(-1f, 1f, _e1600);
                                                        let _e1609 = ((_e1590 - _e1591) * _e1607);
                                                        let _e1611 = select(0f, _e1609, (_e1609 > 0f));
                                                        let _e1613 = ((_e1592 - _e1593) * _e1607);
                                                        let _e1615 = select(0f, _e1613, (_e1613 > 0f));
                                                        let _e1617 = ((_e1594 - _e1595) * _e1607);
                                                        let _e1619 = select(0f, _e1617, (_e1617 > 0f));
                                                        let _e1621 = ((_e1611 + _e1615) + _e1619);
                                                        if (_e1621 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2684_ = type_21();
                                                            phi_2685_ = true;
                                                            phi_2686_ = false;
                                                        } else {
                                                            let _e1624 = select(_e1573, _e1560, (_e1560 < _e1573));
                                                            if (select(_e1586, _e1624, (_e1624 < _e1586)) > 0f) {
                                                                phi_1973_ = true;
                                                            } else {
                                                                let _e1629 = select(_e1573, _e1560, (_e1560 > _e1573));
                                                                phi_1973_ = (select(_e1586, _e1629, (_e1629 > _e1586)) < 0f);
                                                            }
                                                            let _e1634 = phi_1973_;
                                                            if _e1634 {
                                                                phi_2681_ = type_21();
                                                                phi_2682_ = true;
                                                                phi_2683_ = false;
                                                            } else {
                                                                let _e1636 = select(_e1576, _e1563, (_e1563 < _e1576));
                                                                if (select(_e1589, _e1636, (_e1636 < _e1589)) > 0f) {
                                                                    phi_2002_ = true;
                                                                } else {
                                                                    let _e1641 = select(_e1576, _e1563, (_e1563 > _e1576));
                                                                    phi_2002_ = (select(_e1589, _e1641, (_e1641 > _e1589)) < 0f);
                                                                }
                                                                let _e1646 = phi_2002_;
                                                                if _e1646 {
                                                                    phi_2679_ = type_21();
                                                                    phi_2680_ = false;
                                                                } else {
                                                                    let _e1648 = select(_e1549[1][0], _e1549[0][0], (_e1549[0][0] < _e1549[1][0]));
                                                                    let _e1652 = select(_e1549[1][0], _e1549[0][0], (_e1549[0][0] > _e1549[1][0]));
                                                                    let _e1656 = select(_e1549[1][1], _e1549[0][1], (_e1549[0][1] < _e1549[1][1]));
                                                                    let _e1660 = select(_e1549[1][1], _e1549[0][1], (_e1549[0][1] > _e1549[1][1]));
                                                                    let _e1664 = select(_e1549[1][2], _e1549[0][2], (_e1549[0][2] < _e1549[1][2]));
                                                                    let _e1668 = select(_e1549[1][2], _e1549[0][2], (_e1549[0][2] > _e1549[1][2]));
                                                                    let _e1673 = ((select(_e1549[2][0], _e1648, (_e1648 < _e1549[2][0])) - _e427) * _e432);
                                                                    let _e1674 = ((select(_e1549[2][0], _e1652, (_e1652 > _e1549[2][0])) - _e428) * _e432);
                                                                    let _e1677 = ((select(_e1549[2][1], _e1656, (_e1656 < _e1549[2][1])) - _e463) * _e468);
                                                                    let _e1678 = ((select(_e1549[2][1], _e1660, (_e1660 > _e1549[2][1])) - _e464) * _e468);
                                                                    let _e1681 = ((select(_e1549[2][2], _e1664, (_e1664 < _e1549[2][2])) - _e499) * _e504);
                                                                    let _e1682 = ((select(_e1549[2][2], _e1668, (_e1668 > _e1549[2][2])) - _e500) * _e504);
                                                                    let _e1684 = select(_e1682, _e1681, (_e1681 < _e1682));
                                                                    let _e1686 = select(_e1682, _e1681, (_e1681 > _e1682));
                                                                    let _e1688 = select(_e1674, _e1673, (_e1673 < _e1674));
                                                                    let _e1690 = select(_e1678, _e1677, (_e1677 < _e1678));
                                                                    let _e1692 = select(_e1690, _e1688, (_e1688 > _e1690));
                                                                    let _e1694 = select(_e1684, _e1692, (_e1692 > _e1684));
                                                                    let _e1696 = select(_e1674, _e1673, (_e1673 > _e1674));
                                                                    let _e1698 = select(_e1678, _e1677, (_e1677 > _e1678));
                                                                    let _e1700 = select(_e1698, _e1696, (_e1696 < _e1698));
                                                                    let _e1702 = select(_e1686, _e1700, (_e1700 < _e1686));
                                                                    let _e1703 = -(_e1684);
                                                                    let _e1709 = select(_e550, _e1694, (_e1694 > _e550));
                                                                    if (_e1709 > (_e1702 + (select(_e1703, _e1686, (_e1686 > _e1703)) * 0.0000019073523f))) {
                                                                        phi_2674_ = type_21();
                                                                        phi_2675_ = true;
                                                                    } else {
                                                                        let _e1711 = (_e1709 > _e1120.member);
                                                                        if _e1711 {
                                                                            phi_2673_ = type_21();
                                                                        } else {
                                                                            let _e1712 = vec3<f32>(_e1549[0][0], _e1549[0][1], _e1549[0][2]);
                                                                            let _e1713 = vec3<f32>(_e1549[1][0], _e1549[1][1], _e1549[1][2]);
                                                                            let _e1714 = vec3<f32>(_e1549[2][0], _e1549[2][1], _e1549[2][2]);
                                                                            let _e1715 = (_e1549[1][0] - _e1549[0][0]);
                                                                            let _e1716 = (_e1549[1][1] - _e1549[0][1]);
                                                                            let _e1717 = (_e1549[1][2] - _e1549[0][2]);
                                                                            let _e1718 = vec3<f32>(_e1715, _e1716, _e1717);
                                                                            let _e1719 = (_e1549[2][0] - _e1549[1][0]);
                                                                            let _e1720 = (_e1549[2][1] - _e1549[1][1]);
                                                                            let _e1721 = (_e1549[2][2] - _e1549[1][2]);
                                                                            let _e1722 = vec3<f32>(_e1719, _e1720, _e1721);
                                                                            let _e1723 = (_e1549[0][0] - _e1549[2][0]);
                                                                            let _e1724 = (_e1549[0][1] - _e1549[2][1]);
                                                                            let _e1725 = (_e1549[0][2] - _e1549[2][2]);
                                                                            let _e1726 = vec3<f32>(_e1723, _e1724, _e1725);
                                                                            let _e1729 = bitcast<f32>((bitcast<u32>(_e1715) & 2147483647u));
                                                                            let _e1732 = bitcast<f32>((bitcast<u32>(_e1716) & 2147483647u));
                                                                            let _e1734 = select(_e1732, _e1729, (_e1729 > _e1732));
                                                                            let _e1737 = bitcast<f32>((bitcast<u32>(_e1717) & 2147483647u));
                                                                            let _e1739 = select(_e1737, _e1734, (_e1734 > _e1737));
                                                                            let _e1742 = bitcast<f32>((bitcast<u32>(_e1719) & 2147483647u));
                                                                            let _e1745 = bitcast<f32>((bitcast<u32>(_e1720) & 2147483647u));
                                                                            let _e1747 = select(_e1745, _e1742, (_e1742 > _e1745));
                                                                            let _e1750 = bitcast<f32>((bitcast<u32>(_e1721) & 2147483647u));
                                                                            let _e1752 = select(_e1750, _e1747, (_e1747 > _e1750));
                                                                            let _e1755 = bitcast<f32>((bitcast<u32>(_e1723) & 2147483647u));
                                                                            let _e1758 = bitcast<f32>((bitcast<u32>(_e1724) & 2147483647u));
                                                                            let _e1760 = select(_e1758, _e1755, (_e1755 > _e1758));
                                                                            let _e1763 = bitcast<f32>((bitcast<u32>(_e1725) & 2147483647u));
                                                                            let _e1765 = select(_e1763, _e1760, (_e1760 > _e1763));
                                                                            let _e1767 = select(_e1752, _e1739, (_e1739 > _e1752));
                                                                            let _e1769 = select(_e1765, _e1767, (_e1767 > _e1765));
                                                                            if (_e1739 == _e1769) {
                                                                                phi_2403_ = _e1576;
                                                                                phi_2404_ = _e1573;
                                                                                phi_2405_ = _e1563;
                                                                                phi_2406_ = _e1560;
                                                                                phi_2407_ = _e1712;
                                                                                phi_2408_ = _e1726;
                                                                                phi_2409_ = _e1722;
                                                                                phi_2410_ = _e1718;
                                                                            } else {
                                                                                let _e1771 = (_e1752 == _e1769);
                                                                                let _e1776 = vec3(_e1771);
                                                                                phi_2403_ = select(_e1563, _e1589, _e1771);
                                                                                phi_2404_ = select(_e1560, _e1586, _e1771);
                                                                                phi_2405_ = select(_e1589, _e1576, _e1771);
                                                                                phi_2406_ = select(_e1586, _e1573, _e1771);
                                                                                phi_2407_ = select(_e1714, _e1713, _e1776);
                                                                                phi_2408_ = select(_e1722, _e1718, _e1776);
                                                                                phi_2409_ = select(_e1718, _e1726, _e1776);
                                                                                phi_2410_ = select(_e1726, _e1722, _e1776);
                                                                            }
                                                                            let _e1782 = phi_2403_;
                                                                            let _e1784 = phi_2404_;
                                                                            let _e1786 = phi_2405_;
                                                                            let _e1788 = phi_2406_;
                                                                            let _e1790 = phi_2407_;
                                                                            let _e1792 = phi_2408_;
                                                                            let _e1794 = phi_2409_;
                                                                            let _e1796 = phi_2410_;
                                                                            let _e1803 = ((_e1794.y * _e1792.z) - (_e1792.y * _e1794.z));
                                                                            let _e1808 = ((_e1794.z * _e1792.x) - (_e1792.z * _e1794.x));
                                                                            let _e1811 = ((_e1794.x * _e1792.y) - (_e1792.x * _e1794.y));
                                                                            if (_e1611 >= _e1615) {
                                                                                phi_2441_ = select(true, false, (_e1611 >= _e1619));
                                                                            } else {
                                                                                phi_2441_ = true;
                                                                            }
                                                                            let _e1816 = phi_2441_;
                                                                            if _e1816 {
                                                                                phi_2450_ = select(_e1714, _e1713, vec3((_e1615 >= _e1619)));
                                                                            } else {
                                                                                phi_2450_ = _e1712;
                                                                            }
                                                                            let _e1821 = phi_2450_;
                                                                            let _e1826 = (((_e1803 * _e429) + (_e1808 * _e465)) + (_e1811 * _e501));
                                                                            let _e1837 = (((_e1803 * (_e1821.x - _e404)) + (_e1808 * (_e1821.y - _e441))) + (_e1811 * (_e1821.z - _e477)));
                                                                            let _e1839 = (_e1784 - _e1788);
                                                                            let _e1840 = (_e1782 - _e1786);
                                                                            let _e1848 = (-(((_e1788 * _e1839) + (_e1786 * _e1840))) / ((_e1839 * _e1839) + (_e1840 * _e1840)));
                                                                            let _e1850 = select(1f, _e1848, (_e1848 < 1f));
                                                                            let _e1852 = select(0f, _e1850, (_e1850 > 0f));
                                                                            let _e1865 = ((_e1790.x + (_e1796.x * _e1852)) - _e404);
                                                                            let _e1866 = ((_e1790.y + (_e1796.y * _e1852)) - _e441);
                                                                            let _e1867 = ((_e1790.z + (_e1796.z * _e1852)) - _e477);
                                                                            let _e1868 = (_e1867 / _e501);
                                                                            let _e1880 = bitcast<f32>((bitcast<u32>(_e1865) & 2147483647u));
                                                                            let _e1883 = bitcast<f32>((bitcast<u32>(_e1866) & 2147483647u));
                                                                            let _e1885 = select(_e1883, _e1880, (_e1880 > _e1883));
                                                                            let _e1888 = bitcast<f32>((bitcast<u32>(_e1867) & 2147483647u));
                                                                            let _e1890 = select(_e1888, _e1885, (_e1885 > _e1888));
                                                                            let _e1896 = bitcast<f32>((bitcast<u32>(_e1803) & 2147483647u));
                                                                            let _e1899 = bitcast<f32>((bitcast<u32>(_e1808) & 2147483647u));
                                                                            let _e1901 = select(_e1899, _e1896, (_e1896 > _e1899));
                                                                            let _e1904 = bitcast<f32>((bitcast<u32>(_e1811) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1803 * _e1865) + (_e1808 * _e1866)) + (_e1811 * _e1867)) - _e1837)) & 2147483647u)) <= ((0.0000009536743f * select(_e1769, _e1890, (_e1890 > _e1769))) * select(_e1904, _e1901, (_e1901 > _e1904)))) {
                                                                                let _e1914 = bitcast<f32>((bitcast<u32>(_e1794.x) & 2147483647u));
                                                                                let _e1917 = bitcast<f32>((bitcast<u32>(_e1794.y) & 2147483647u));
                                                                                let _e1919 = select(_e1917, _e1914, (_e1914 > _e1917));
                                                                                let _e1922 = bitcast<f32>((bitcast<u32>(_e1794.z) & 2147483647u));
                                                                                let _e1928 = bitcast<f32>((bitcast<u32>(_e1792.x) & 2147483647u));
                                                                                let _e1931 = bitcast<f32>((bitcast<u32>(_e1792.y) & 2147483647u));
                                                                                let _e1933 = select(_e1931, _e1928, (_e1928 > _e1931));
                                                                                let _e1936 = bitcast<f32>((bitcast<u32>(_e1792.z) & 2147483647u));
                                                                                phi_2617_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1826) & 2147483647u)) > ((0.0000038146973f * select(_e1922, _e1919, (_e1919 > _e1922))) * select(_e1936, _e1933, (_e1933 > _e1936)))));
                                                                            } else {
                                                                                phi_2617_ = true;
                                                                            }
                                                                            let _e1943 = phi_2617_;
                                                                            if _e1943 {
                                                                                let _e1954 = ((((_e1803 * (_e1865 - (_e429 * _e1868))) + (_e1808 * (_e1866 - (_e465 * _e1868)))) + (_e1811 * (_e1867 - _e1867))) / _e1826);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1954) & 2147483647u)) <= _e1769) {
                                                                                    phi_2641_ = (_e1868 + _e1954);
                                                                                } else {
                                                                                    phi_2641_ = _e1868;
                                                                                }
                                                                                let _e1961 = phi_2641_;
                                                                                phi_2642_ = _e1961;
                                                                            } else {
                                                                                phi_2642_ = (_e1837 / _e1826);
                                                                            }
                                                                            let _e1963 = phi_2642_;
                                                                            let _e1965 = select(_e1702, _e1963, (_e1963 < _e1702));
                                                                            let _e1967 = select(_e1694, _e1965, (_e1965 > _e1694));
                                                                            if (_e1967 >= _e550) {
                                                                                let _e1969 = (_e1967 <= _e1120.member);
                                                                                if _e1969 {
                                                                                    let _e1970 = (1f / _e1621);
                                                                                    phi_2665_ = type_21(_e1967, (_e1615 * _e1970), (_e1619 * _e1970), _e1180);
                                                                                } else {
                                                                                    phi_2665_ = type_21();
                                                                                }
                                                                                let _e1975 = phi_2665_;
                                                                                phi_2667_ = _e1975;
                                                                                phi_2668_ = select(true, false, _e1969);
                                                                            } else {
                                                                                phi_2667_ = type_21();
                                                                                phi_2668_ = true;
                                                                            }
                                                                            let _e1978 = phi_2667_;
                                                                            let _e1980 = phi_2668_;
                                                                            if _e1980 {
                                                                                phi_2672_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2672_ = _e1978;
                                                                            }
                                                                            let _e1982 = phi_2672_;
                                                                            phi_2673_ = _e1982;
                                                                        }
                                                                        let _e1984 = phi_2673_;
                                                                        phi_2674_ = _e1984;
                                                                        phi_2675_ = _e1711;
                                                                    }
                                                                    let _e1986 = phi_2674_;
                                                                    let _e1988 = phi_2675_;
                                                                    phi_2679_ = _e1986;
                                                                    phi_2680_ = _e1988;
                                                                }
                                                                let _e1990 = phi_2679_;
                                                                let _e1992 = phi_2680_;
                                                                phi_2681_ = _e1990;
                                                                phi_2682_ = _e1646;
                                                                phi_2683_ = _e1992;
                                                            }
                                                            let _e1994 = phi_2681_;
                                                            let _e1996 = phi_2682_;
                                                            let _e1998 = phi_2683_;
                                                            phi_2684_ = _e1994;
                                                            phi_2685_ = _e1996;
                                                            phi_2686_ = _e1998;
                                                        }
                                                        let _e2000 = phi_2684_;
                                                        let _e2002 = phi_2685_;
                                                        let _e2004 = phi_2686_;
                                                        phi_2694_ = _e2000;
                                                        phi_2695_ = select(_e2004, true, _e2002);
                                                    } else {
                                                        phi_2694_ = type_21();
                                                        phi_2695_ = true;
                                                    }
                                                    let _e2007 = phi_2694_;
                                                    let _e2009 = phi_2695_;
                                                    if _e2009 {
                                                        phi_2699_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2699_ = _e2007;
                                                    }
                                                    let _e2011 = phi_2699_;
                                                    if (_e2011.member_3 != 4294967295u) {
                                                        if (_e1180 == _e167) {
                                                            phi_3028_ = false;
                                                        } else {
                                                            let _e2015 = (_e1180 < arrayLength((&global_5.member)));
                                                            if _e2015 {
                                                                if _e2015 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e2017 = global_5.member[_e1180];
                                                                phi_2722_ = _e2017;
                                                            } else {
                                                                phi_2722_ = 4294967295u;
                                                            }
                                                            let _e2019 = phi_2722_;
                                                            let _e2020 = (_e2019 < arrayLength((&global_6.member)));
                                                            if _e2020 {
                                                                if _e2020 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e2022 = global_6.member[_e2019];
                                                                phi_2736_ = _e2022;
                                                            } else {
                                                                phi_2736_ = 0i;
                                                            }
                                                            let _e2024 = phi_2736_;
                                                            let _e2025 = (_e2024 == 0i);
                                                            if _e2025 {
                                                                phi_3027_ = true;
                                                            } else {
                                                                if _e396 {
                                                                    phi_2757_ = vec3<f32>(_e1549[0][0], _e1549[0][1], _e1549[0][2]);
                                                                } else {
                                                                    if (_e372 == 1u) {
                                                                        phi_2756_ = vec3<f32>(_e1549[0][2], _e1549[0][0], _e1549[0][1]);
                                                                    } else {
                                                                        phi_2756_ = vec3<f32>(_e1549[0][1], _e1549[0][2], _e1549[0][0]);
                                                                    }
                                                                    let _e2030 = phi_2756_;
                                                                    phi_2757_ = _e2030;
                                                                }
                                                                let _e2033 = phi_2757_;
                                                                if _e396 {
                                                                    phi_2774_ = vec3<f32>(_e1549[1][0], _e1549[1][1], _e1549[1][2]);
                                                                } else {
                                                                    if (_e372 == 1u) {
                                                                        phi_2773_ = vec3<f32>(_e1549[1][2], _e1549[1][0], _e1549[1][1]);
                                                                    } else {
                                                                        phi_2773_ = vec3<f32>(_e1549[1][1], _e1549[1][2], _e1549[1][0]);
                                                                    }
                                                                    let _e2038 = phi_2773_;
                                                                    phi_2774_ = _e2038;
                                                                }
                                                                let _e2041 = phi_2774_;
                                                                if _e396 {
                                                                    phi_2791_ = vec3<f32>(_e1549[2][0], _e1549[2][1], _e1549[2][2]);
                                                                } else {
                                                                    if (_e372 == 1u) {
                                                                        phi_2790_ = vec3<f32>(_e1549[2][2], _e1549[2][0], _e1549[2][1]);
                                                                    } else {
                                                                        phi_2790_ = vec3<f32>(_e1549[2][1], _e1549[2][2], _e1549[2][0]);
                                                                    }
                                                                    let _e2046 = phi_2790_;
                                                                    phi_2791_ = _e2046;
                                                                }
                                                                let _e2049 = phi_2791_;
                                                                let _e2052 = (_e2041.x - _e2033.x);
                                                                let _e2055 = (_e2041.y - _e2033.y);
                                                                let _e2058 = (_e2041.z - _e2033.z);
                                                                let _e2060 = (_e2049.x - _e2033.x);
                                                                let _e2062 = (_e2049.y - _e2033.y);
                                                                let _e2064 = (_e2049.z - _e2033.z);
                                                                if (_e239.member_1 == 1u) {
                                                                    phi_2827_ = (vec3<f32>(_e239.member[0], _e239.member[1], _e239.member[2]) - _e2033);
                                                                } else {
                                                                    phi_2827_ = vec3<f32>(_e239.member[0], _e239.member[1], _e239.member[2]);
                                                                }
                                                                let _e2079 = phi_2827_;
                                                                let _e2085 = bitcast<f32>((bitcast<u32>((_e2052 * _e2062)) ^ _e239.member_3[0]));
                                                                let _e2089 = bitcast<f32>((bitcast<u32>((_e2055 * _e2060)) ^ _e239.member_3[0]));
                                                                let _e2093 = bitcast<f32>((bitcast<u32>((_e2055 * _e2064)) ^ _e239.member_3[0]));
                                                                let _e2097 = bitcast<f32>((bitcast<u32>((_e2058 * _e2062)) ^ _e239.member_3[0]));
                                                                let _e2101 = bitcast<f32>((bitcast<u32>((_e2058 * _e2060)) ^ _e239.member_3[0]));
                                                                let _e2105 = bitcast<f32>((bitcast<u32>((_e2052 * _e2064)) ^ _e239.member_3[0]));
                                                                let _e2106 = (_e2093 - _e2097);
                                                                let _e2107 = (_e2101 - _e2105);
                                                                let _e2108 = (_e2085 - _e2089);
                                                                let _e2132 = (bitcast<f32>((bitcast<u32>(_e2093) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2097) & 2147483647u)));
                                                                let _e2139 = (bitcast<f32>((bitcast<u32>(_e2101) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2105) & 2147483647u)));
                                                                let _e2146 = (bitcast<f32>((bitcast<u32>(_e2085) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2089) & 2147483647u)));
                                                                if (_e239.member_2 == 0f) {
                                                                    phi_3009_ = 0f;
                                                                } else {
                                                                    let _e2176 = bitcast<f32>((bitcast<u32>(_e2106) & 2147483647u));
                                                                    let _e2179 = bitcast<f32>((bitcast<u32>(_e2107) & 2147483647u));
                                                                    let _e2182 = bitcast<f32>((bitcast<u32>(_e2108) & 2147483647u));
                                                                    let _e2184 = select(_e2182, _e2179, (_e2179 > _e2182));
                                                                    let _e2188 = select(_e2182, _e2179, (_e2179 < _e2182));
                                                                    let _e2192 = select(_e2179, _e2176, (_e2176 < _e2179));
                                                                    let _e2194 = select(_e2179, _e2176, (_e2176 > _e2179));
                                                                    let _e2196 = select(_e2182, _e2194, (_e2194 < _e2182));
                                                                    phi_3009_ = bitcast<f32>((bitcast<u32>((_e239.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2184, _e2176, (_e2176 > _e2184)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2196, _e2192, (_e2192 > _e2196)))) ^ _e239.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2188, _e2176, (_e2176 < _e2188)))) ^ _e239.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e2132 + _e2139) + _e2146))) ^ _e239.member_3[0]))) * 1.0000005f)) ^ _e239.member_3[0])))) ^ _e239.member_3[0]));
                                                                }
                                                                let _e2223 = phi_3009_;
                                                                phi_3027_ = (_e2025 || !(((((bitcast<f32>((bitcast<u32>((_e2079.x * _e2106)) ^ _e239.member_3[0])) + bitcast<f32>((bitcast<u32>((_e2079.y * _e2107)) ^ _e239.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e2079.z * _e2108)) ^ _e239.member_3[0]))) * f32(-(_e2024))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2079.x) & 2147483647u)) * _e2132)) ^ _e239.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2079.y) & 2147483647u)) * _e2139)) ^ _e239.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2079.z) & 2147483647u)) * _e2146)) ^ _e239.member_3[0]))))) ^ _e239.member_3[0])) + _e2223) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e2237 = phi_3027_;
                                                            phi_3028_ = _e2237;
                                                        }
                                                        let _e2239 = phi_3028_;
                                                        if _e2239 {
                                                            phi_3033_ = type_42(_e1120.member, true);
                                                        } else {
                                                            phi_3033_ = _e1120;
                                                        }
                                                        let _e2244 = phi_3033_;
                                                        phi_3034_ = _e2244;
                                                    } else {
                                                        phi_3034_ = _e1120;
                                                    }
                                                    let _e2246 = phi_3034_;
                                                    phi_1138_ = _e2246;
                                                } else {
                                                    phi_1138_ = type_42();
                                                }
                                                let _e2248 = phi_1138_;
                                                continue;
                                                continuing {
                                                    phi_1137_ = _e2248;
                                                    phi_1140_ = _e1135;
                                                    phi_4533_ = _e592;
                                                    break if !(_e1141);
                                                }
                                            }
                                            let _e2251 = phi_4533_;
                                            phi_4746_ = _e2251;
                                            if _e2251 {
                                                break;
                                            }
                                            let _e2253 = local_10;
                                            phi_4750_ = _e2251;
                                            let _e2491 = local_12;
                                            phi_4275_ = _e2491;
                                            phi_4276_ = _e633;
                                            phi_4277_ = false;
                                            phi_4278_ = select(_e637, 0u, _e2253.member_1);
                                        } else {
                                            if (_e633.member_1 >= _e99) {
                                                phi_3831_ = type_59(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_58(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_58(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e633.member_1 < _e99) {
                                                } else {
                                                    phi_4746_ = true;
                                                    break;
                                                }
                                                let _e649 = (_e372 * 2u);
                                                let _e651 = ((1u + _e649) % 7u);
                                                if (_e651 < 7u) {
                                                } else {
                                                    phi_4746_ = true;
                                                    break;
                                                }
                                                let _e656 = global_8.member[_e633.member_1][_e651];
                                                let _e658 = ((_e649 + 2u) % 7u);
                                                if (_e658 < 7u) {
                                                } else {
                                                    phi_4746_ = true;
                                                    break;
                                                }
                                                let _e663 = global_8.member[_e633.member_1][_e658];
                                                let _e664 = (_e371 * 2u);
                                                let _e666 = ((1u + _e664) % 7u);
                                                if (_e666 < 7u) {
                                                } else {
                                                    phi_4746_ = true;
                                                    break;
                                                }
                                                let _e671 = global_8.member[_e633.member_1][_e666];
                                                let _e673 = ((_e664 + 2u) % 7u);
                                                if (_e673 < 7u) {
                                                } else {
                                                    phi_4746_ = true;
                                                    break;
                                                }
                                                let _e678 = global_8.member[_e633.member_1][_e673];
                                                let _e679 = (_e373 * 2u);
                                                let _e681 = ((1u + _e679) % 7u);
                                                if (_e681 < 7u) {
                                                } else {
                                                    phi_4746_ = true;
                                                    break;
                                                }
                                                let _e686 = global_8.member[_e633.member_1][_e681];
                                                let _e688 = ((_e679 + 2u) % 7u);
                                                if (_e688 < 7u) {
                                                } else {
                                                    phi_4746_ = true;
                                                    break;
                                                }
                                                let _e693 = global_8.member[_e633.member_1][_e688];
                                                let _e716 = (bitcast<f32>((bitcast<u32>((_e633.member.member_1.x - _e633.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e717 = (bitcast<f32>((bitcast<u32>((_e633.member.member_1.y - _e633.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e718 = (bitcast<f32>((bitcast<u32>((_e633.member.member_1.z - _e633.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e720 = select(_e158, _e716, (_e716 > _e158));
                                                let _e722 = select(_e158, _e717, (_e717 > _e158));
                                                let _e724 = select(_e158, _e718, (_e718 > _e158));
                                                let _e749 = bitcast<u32>((f32(bitcast<i32>((_e656 & 2097151u))) * _e720));
                                                let _e754 = (bitcast<i32>((_e656 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e757 = bitcast<f32>((_e749 & bitcast<u32>(_e754)));
                                                let _e758 = bitcast<u32>((f32(bitcast<i32>((_e671 & 2097151u))) * _e722));
                                                let _e763 = (bitcast<i32>((_e671 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e766 = bitcast<f32>((_e758 & bitcast<u32>(_e763)));
                                                let _e767 = bitcast<u32>((f32(bitcast<i32>((_e686 & 2097151u))) * _e724));
                                                let _e772 = (bitcast<i32>((_e686 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e775 = bitcast<f32>((_e767 & bitcast<u32>(_e772)));
                                                let _e779 = bitcast<f32>((_e749 & bitcast<u32>(~(_e754))));
                                                let _e783 = bitcast<f32>((_e758 & bitcast<u32>(~(_e763))));
                                                let _e787 = bitcast<f32>((_e767 & bitcast<u32>(~(_e772))));
                                                let _e788 = bitcast<u32>((f32(bitcast<i32>((_e663 & 2097151u))) * _e720));
                                                let _e793 = (bitcast<i32>((_e663 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e796 = bitcast<f32>((_e788 & bitcast<u32>(_e793)));
                                                let _e797 = bitcast<u32>((f32(bitcast<i32>((_e678 & 2097151u))) * _e722));
                                                let _e802 = (bitcast<i32>((_e678 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e805 = bitcast<f32>((_e797 & bitcast<u32>(_e802)));
                                                let _e806 = bitcast<u32>((f32(bitcast<i32>((_e693 & 2097151u))) * _e724));
                                                let _e811 = (bitcast<i32>((_e693 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e814 = bitcast<f32>((_e806 & bitcast<u32>(_e811)));
                                                let _e818 = bitcast<f32>((_e788 & bitcast<u32>(~(_e793))));
                                                let _e822 = bitcast<f32>((_e797 & bitcast<u32>(~(_e802))));
                                                let _e826 = bitcast<f32>((_e806 & bitcast<u32>(~(_e811))));
                                                let _e827 = (_e633.member.member.x + _e757);
                                                let _e828 = (_e633.member.member.y + _e766);
                                                let _e829 = (_e633.member.member.z + _e775);
                                                let _e832 = (_e633.member.member_1.x - _e796);
                                                let _e833 = (_e633.member.member_1.y - _e805);
                                                let _e834 = (_e633.member.member_1.z - _e814);
                                                let _e853 = (_e832 - _e827);
                                                let _e854 = (_e833 - _e828);
                                                let _e855 = (_e834 - _e829);
                                                let _e857 = select(_e854, _e853, (_e853 > _e854));
                                                let _e859 = select(_e855, _e857, (_e857 > _e855));
                                                if (_e859 < (1024f * _e158)) {
                                                    phi_3532_ = 0u;
                                                } else {
                                                    phi_3532_ = select(2u, 1u, (_e859 < (2097152f * _e158)));
                                                }
                                                let _e866 = phi_3532_;
                                                switch bitcast<i32>(_e866) {
                                                    case 0: {
                                                        phi_3538_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_3538_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_3538_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_3538_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e869 = phi_3538_;
                                                let _e875 = global_8.member[_e633.member_1][0u];
                                                let _e879 = global_8.member[_e633.member_1][2u];
                                                let _e883 = global_8.member[_e633.member_1][4u];
                                                let _e887 = global_8.member[_e633.member_1][6u];
                                                let _e899 = (((_e879 >> bitcast<u32>(22i)) | ((_e883 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e887 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e900 = (_e875 & 268435455u);
                                                let _e901 = (_e899 & 268435455u);
                                                let _e904 = ((_e875 >> bitcast<u32>(28u)) & 7u);
                                                let _e912 = ((_e875 >> bitcast<u32>(31i)) | (((_e899 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e913 = (_e904 != 0u);
                                                if (_e904 == 0u) {
                                                    phi_3793_ = _e900;
                                                } else {
                                                    if (_e904 == 7u) {
                                                        phi_3792_ = 2147483648u;
                                                    } else {
                                                        phi_3792_ = ((2147483648u | (_e904 << bitcast<u32>(28u))) | (_e901 & 268435455u));
                                                    }
                                                    let _e922 = phi_3792_;
                                                    phi_3793_ = _e922;
                                                }
                                                let _e924 = phi_3793_;
                                                if _e913 {
                                                    let _e925 = (_e904 != 7u);
                                                    if _e925 {
                                                        phi_3803_ = (_e901 + (_e904 * ((3u * _e869) + 1u)));
                                                    } else {
                                                        phi_3803_ = u32();
                                                    }
                                                    let _e929 = phi_3803_;
                                                    phi_3805_ = _e929;
                                                    phi_3806_ = select(true, false, _e925);
                                                } else {
                                                    phi_3805_ = u32();
                                                    phi_3806_ = true;
                                                }
                                                let _e932 = phi_3805_;
                                                let _e934 = phi_3806_;
                                                if (_e912 == 0u) {
                                                    phi_3827_ = (_e900 + select(0u, 1u, !(_e913)));
                                                } else {
                                                    if (_e912 == 7u) {
                                                        phi_3826_ = 2147483648u;
                                                    } else {
                                                        phi_3826_ = ((2147483648u | (_e912 << bitcast<u32>(28u))) | (select(_e932, _e901, _e934) & 268435455u));
                                                    }
                                                    let _e947 = phi_3826_;
                                                    phi_3827_ = _e947;
                                                }
                                                let _e949 = phi_3827_;
                                                phi_3831_ = type_59(array<vec4<f32>, 3>(vec4<f32>(_e827, (_e633.member.member.x + _e779), _e832, (_e633.member.member_1.x - _e818)), vec4<f32>(_e828, (_e633.member.member.y + _e783), _e833, (_e633.member.member_1.y - _e822)), vec4<f32>(_e829, (_e633.member.member.z + _e787), _e834, (_e633.member.member_1.z - _e826))), type_58(type_30((_e633.member.member + vec4<f32>(_e757, _e766, _e775, 0f)), (_e633.member.member_1 - vec4<f32>(_e796, _e805, _e814, 0f))), _e924), type_58(type_30((_e633.member.member + vec4<f32>(_e779, _e783, _e787, 0f)), (_e633.member.member_1 - vec4<f32>(_e818, _e822, _e826, 0f))), _e949));
                                            }
                                            let _e954 = phi_3831_;
                                            let _e966 = ((_e954.member[0].x - _e427) * _e432);
                                            let _e967 = ((_e954.member[0].y - _e427) * _e432);
                                            let _e968 = ((_e954.member[0].z - _e428) * _e432);
                                            let _e969 = ((_e954.member[0].w - _e428) * _e432);
                                            let _e979 = ((_e954.member[1].x - _e463) * _e468);
                                            let _e980 = ((_e954.member[1].y - _e463) * _e468);
                                            let _e981 = ((_e954.member[1].z - _e464) * _e468);
                                            let _e982 = ((_e954.member[1].w - _e464) * _e468);
                                            let _e992 = ((_e954.member[2].x - _e499) * _e504);
                                            let _e993 = ((_e954.member[2].y - _e499) * _e504);
                                            let _e994 = ((_e954.member[2].z - _e500) * _e504);
                                            let _e995 = ((_e954.member[2].w - _e500) * _e504);
                                            let _e997 = select(_e994, _e992, (_e992 < _e994));
                                            let _e999 = select(_e995, _e993, (_e993 < _e995));
                                            let _e1001 = select(_e994, _e992, (_e992 > _e994));
                                            let _e1003 = select(_e995, _e993, (_e993 > _e995));
                                            let _e1005 = select(_e968, _e966, (_e966 < _e968));
                                            let _e1007 = select(_e969, _e967, (_e967 < _e969));
                                            let _e1009 = select(_e981, _e979, (_e979 < _e981));
                                            let _e1011 = select(_e982, _e980, (_e980 < _e982));
                                            let _e1013 = select(_e1009, _e1005, (_e1005 > _e1009));
                                            let _e1015 = select(_e1011, _e1007, (_e1007 > _e1011));
                                            let _e1017 = select(_e997, _e1013, (_e1013 > _e997));
                                            let _e1019 = select(_e999, _e1015, (_e1015 > _e999));
                                            let _e1021 = select(_e968, _e966, (_e966 > _e968));
                                            let _e1023 = select(_e969, _e967, (_e967 > _e969));
                                            let _e1025 = select(_e981, _e979, (_e979 > _e981));
                                            let _e1027 = select(_e982, _e980, (_e980 > _e982));
                                            let _e1029 = select(_e1025, _e1021, (_e1021 < _e1025));
                                            let _e1031 = select(_e1027, _e1023, (_e1023 < _e1027));
                                            let _e1036 = -(_e997);
                                            let _e1037 = -(_e999);
                                            let _e1044 = (select(_e1001, _e1029, (_e1029 < _e1001)) + (select(_e1036, _e1001, (_e1001 > _e1036)) * 0.0000019073523f));
                                            let _e1045 = (select(_e1003, _e1031, (_e1031 < _e1003)) + (select(_e1037, _e1003, (_e1003 > _e1037)) * 0.0000019073523f));
                                            let _e1047 = select(_e550, _e1017, (_e1017 > _e550));
                                            let _e1049 = select(_e550, _e1019, (_e1019 > _e550));
                                            let _e1054 = (_e1047 <= select(_e594.member, _e1044, (_e1044 < _e594.member)));
                                            let _e1055 = (_e1049 <= select(_e594.member, _e1045, (_e1045 < _e594.member)));
                                            let _e1056 = (_e1047 <= _e1049);
                                            if _e1054 {
                                                if _e1055 {
                                                    if _e1056 {
                                                        phi_4175_ = _e954.member_2;
                                                    } else {
                                                        phi_4175_ = _e954.member_1;
                                                    }
                                                    let _e1060 = phi_4175_;
                                                    let _e1082 = (_e637 % 128u);
                                                    let _e1083 = (_e1082 < 128u);
                                                    if _e1083 {
                                                    } else {
                                                        phi_4746_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1082] = _e1060.member_1;
                                                    if _e1083 {
                                                    } else {
                                                        phi_4746_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1082] = _e1060.member.member.x;
                                                    if _e1083 {
                                                    } else {
                                                        phi_4746_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1082] = _e1060.member.member.y;
                                                    if _e1083 {
                                                    } else {
                                                        phi_4746_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1082] = _e1060.member.member.z;
                                                    if _e1083 {
                                                    } else {
                                                        phi_4746_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1082] = _e1060.member.member_1.x;
                                                    if _e1083 {
                                                    } else {
                                                        phi_4746_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1082] = _e1060.member.member_1.y;
                                                    if _e1083 {
                                                    } else {
                                                        phi_4746_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1082] = _e1060.member.member_1.z;
                                                    if _e1083 {
                                                    } else {
                                                        phi_4746_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1082] = select(_e1049, _e1047, (_e1047 > _e1049));
                                                    if _e1056 {
                                                        phi_4252_ = _e954.member_1;
                                                    } else {
                                                        phi_4252_ = _e954.member_2;
                                                    }
                                                    let _e1096 = phi_4252_;
                                                    phi_4253_ = _e1096;
                                                    phi_4254_ = (_e637 + 1u);
                                                } else {
                                                    phi_4253_ = type_58();
                                                    phi_4254_ = u32();
                                                }
                                                let _e1098 = phi_4253_;
                                                let _e1100 = phi_4254_;
                                                phi_4256_ = _e1098;
                                                phi_4257_ = _e1100;
                                                phi_4258_ = select(true, false, _e1055);
                                            } else {
                                                phi_4256_ = type_58();
                                                phi_4257_ = u32();
                                                phi_4258_ = true;
                                            }
                                            let _e1103 = phi_4256_;
                                            let _e1105 = phi_4257_;
                                            let _e1107 = phi_4258_;
                                            if _e1107 {
                                                if _e1054 {
                                                    phi_4267_ = _e954.member_1;
                                                } else {
                                                    phi_4267_ = _e954.member_2;
                                                }
                                                let _e1111 = phi_4267_;
                                                phi_4272_ = _e1111;
                                                phi_4273_ = select(_e1055, true, _e1054);
                                            } else {
                                                phi_4272_ = _e1103;
                                                phi_4273_ = _e635;
                                            }
                                            let _e1114 = phi_4272_;
                                            let _e1116 = phi_4273_;
                                            phi_4750_ = _e592;
                                            phi_4275_ = _e594;
                                            phi_4276_ = _e1114;
                                            phi_4277_ = _e1116;
                                            phi_4278_ = select(_e1105, _e637, _e1107);
                                        }
                                        let _e2257 = phi_4750_;
                                        let _e2259 = phi_4275_;
                                        let _e2261 = phi_4276_;
                                        let _e2263 = phi_4277_;
                                        let _e2265 = phi_4278_;
                                        phi_4749_ = _e2257;
                                        phi_4279_ = _e2259;
                                        phi_4280_ = _e2261;
                                        phi_4281_ = (_e598 - 1u);
                                        phi_4282_ = _e2263;
                                        phi_4283_ = _e2265;
                                    } else {
                                        phi_4749_ = _e592;
                                        phi_4279_ = _e594;
                                        phi_4280_ = _e633;
                                        phi_4281_ = _e598;
                                        phi_4282_ = _e635;
                                        phi_4283_ = _e637;
                                    }
                                    let _e2267 = phi_4749_;
                                    let _e2269 = phi_4279_;
                                    let _e2271 = phi_4280_;
                                    let _e2273 = phi_4281_;
                                    let _e2275 = phi_4282_;
                                    let _e2277 = phi_4283_;
                                    phi_4748_ = _e2267;
                                    phi_4284_ = _e2269;
                                    phi_4285_ = _e2271;
                                    phi_4286_ = _e2273;
                                    phi_4287_ = _e2275;
                                    phi_4288_ = _e2277;
                                } else {
                                    phi_4748_ = _e592;
                                    phi_4284_ = type_42();
                                    phi_4285_ = type_58();
                                    phi_4286_ = u32();
                                    phi_4287_ = bool();
                                    phi_4288_ = u32();
                                }
                                let _e2279 = phi_4748_;
                                let _e2281 = phi_4284_;
                                let _e2283 = phi_4285_;
                                let _e2285 = phi_4286_;
                                let _e2287 = phi_4287_;
                                let _e2289 = phi_4288_;
                                phi_4747_ = _e2279;
                                phi_1011_ = _e2281;
                                phi_1014_ = _e2283;
                                phi_1016_ = _e2285;
                                phi_1018_ = _e2287;
                                phi_1020_ = _e2289;
                                phi_4289_ = _e606;
                            } else {
                                phi_4747_ = _e592;
                                phi_1011_ = type_42();
                                phi_1014_ = type_58();
                                phi_1016_ = u32();
                                phi_1018_ = bool();
                                phi_1020_ = u32();
                                phi_4289_ = false;
                            }
                            let _e2291 = phi_4747_;
                            let _e2293 = phi_1011_;
                            let _e2295 = phi_1014_;
                            let _e2297 = phi_1016_;
                            let _e2299 = phi_1018_;
                            let _e2301 = phi_1020_;
                            let _e2303 = phi_4289_;
                            continue;
                            continuing {
                                phi_4539_ = _e2291;
                                phi_1010_ = _e2293;
                                phi_1013_ = _e2295;
                                phi_1015_ = _e2297;
                                phi_1017_ = _e2299;
                                phi_1019_ = _e2301;
                                phi_4746_ = _e2291;
                                break if !(_e2303);
                            }
                        }
                        let _e2306 = phi_4746_;
                        if _e2306 {
                            break;
                        }
                        let _e2308 = local_11;
                        if _e2308.member_1 {
                        } else {
                            if _e240 {
                            } else {
                                break;
                            }
                            let _e2312 = global_2.member[_e146];
                            if _e161 {
                            } else {
                                break;
                            }
                            let _e2316 = global_9.member[_e146].member_1;
                            if _e240 {
                            } else {
                                break;
                            }
                            global_2.member[_e146] = type_23(_e2312.member, _e2312.member_1, _e2312.member_2, array<f32, 3>((_e2312.member_3[0] + (_e2316[0] * _e2312.member_1[0])), (_e2312.member_3[1] + (_e2316[1] * _e2312.member_1[1])), (_e2312.member_3[2] + (_e2316[2] * _e2312.member_1[2]))), _e2312.member_4);
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
