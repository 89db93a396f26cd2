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
    var phi_335_: u32;
    var phi_379_: i32;
    var phi_403_: type_40;
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
    var phi_1011_: type_46;
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
    var phi_1138_: type_46;
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
    var phi_2663_: type_25;
    var phi_2665_: type_25;
    var phi_2666_: bool;
    var phi_2670_: type_25;
    var phi_2671_: type_25;
    var phi_2672_: type_25;
    var phi_2673_: bool;
    var phi_2677_: type_25;
    var phi_2678_: bool;
    var phi_2679_: type_25;
    var phi_2680_: bool;
    var phi_2681_: bool;
    var phi_2682_: type_25;
    var phi_2683_: bool;
    var phi_2684_: bool;
    var phi_2692_: type_25;
    var phi_2693_: bool;
    var phi_2697_: type_25;
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
    var phi_3031_: type_46;
    var phi_3032_: type_46;
    var phi_1139_: type_46;
    var phi_4531_: bool;
    var local_10: type_46;
    var phi_4748_: bool;
    var phi_4273_: type_46;
    var phi_4274_: type_58;
    var phi_4275_: bool;
    var phi_4276_: u32;
    var phi_4747_: bool;
    var phi_4277_: type_46;
    var phi_4278_: type_58;
    var phi_4279_: u32;
    var phi_4280_: bool;
    var phi_4281_: u32;
    var phi_4746_: bool;
    var phi_4282_: type_46;
    var phi_4283_: type_58;
    var phi_4284_: u32;
    var phi_4285_: bool;
    var phi_4286_: u32;
    var phi_4745_: bool;
    var phi_1012_: type_46;
    var phi_1015_: type_58;
    var phi_1017_: u32;
    var phi_1019_: bool;
    var phi_1021_: u32;
    var phi_4287_: bool;
    var phi_4744_: bool;
    var local_11: type_46;
    var local_12: type_46;

    switch bitcast<i32>(0u) {
        default: {
            let _e101 = global;
            let _e103 = arrayLength((&global_5.member));
            let _e106 = arrayLength((&global_10.member));
            let _e118 = arrayLength((&global_8.member));
            let _e122 = global_4.member[0u][0u];
            let _e126 = global_4.member[0u][1u];
            let _e130 = global_4.member[0u][2u];
            let _e134 = global_4.member[0u][3u];
            let _e138 = global_4.member[1u][0u];
            let _e142 = global_4.member[1u][1u];
            let _e146 = global_4.member[1u][2u];
            let _e150 = (_e101.x + (_e101.y * 2097152u));
            let _e162 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e134) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e122), bitcast<i32>(_e126), bitcast<i32>(_e130));
            local = array<i32, 3>(bitcast<i32>(_e138), bitcast<i32>(_e142), bitcast<i32>(_e146));
            let _e165 = (_e150 < arrayLength((&global_9.member)));
            if _e165 {
                if _e165 {
                } else {
                    break;
                }
                let _e169 = global_9.member[_e150].member_2;
                phi_335_ = _e169;
            } else {
                phi_335_ = 4294967295u;
            }
            let _e171 = phi_335_;
            let _e174 = global_1.member[0u];
            let _e178 = global_3.member[0u][0u];
            let _e182 = global_3.member[0u][1u];
            let _e186 = global_3.member[0u][2u];
            let _e190 = global_3.member[0u][3u];
            let _e194 = global_3.member[1u][0u];
            let _e198 = global_3.member[1u][1u];
            let _e202 = global_3.member[1u][2u];
            let _e206 = global_3.member[1u][3u];
            let _e207 = bitcast<f32>(_e178);
            let _e208 = bitcast<f32>(_e182);
            let _e209 = bitcast<f32>(_e186);
            let _e211 = bitcast<f32>(_e194);
            let _e212 = array<u32, 3>(_e198, _e202, _e206);
            let _e214 = bitcast<i32>(_e174);
            if (_e214 < -126i) {
                phi_379_ = -126i;
            } else {
                phi_379_ = select(_e214, 127i, (_e214 > 127i));
            }
            let _e219 = phi_379_;
            let _e224 = bitcast<f32>((bitcast<u32>((_e219 + 127i)) << bitcast<u32>(23i)));
            let _e230 = bitcast<f32>((bitcast<u32>(((_e214 - _e219) + 127i)) << bitcast<u32>(23i)));
            if (_e190 == 0u) {
                phi_403_ = type_40(array<f32, 3>(_e207, _e208, _e209), _e190, _e211, _e212);
            } else {
                phi_403_ = type_40(array<f32, 3>(((_e207 * _e224) * _e230), ((_e208 * _e224) * _e230), ((_e209 * _e224) * _e230)), _e190, ((_e211 * _e224) * _e230), _e212);
            }
            let _e243 = phi_403_;
            if _e165 {
                let _e244 = (_e150 < arrayLength((&global_2.member)));
                if _e244 {
                    if _e165 {
                    } else {
                        break;
                    }
                    let _e249 = global_9.member[_e150].member.member_1;
                    let _e254 = global_9.member[_e150].member.member_3;
                    if (_e249 <= _e254) {
                        let _e256 = (1u < _e118);
                        if _e256 {
                            if (0u < _e118) {
                            } else {
                                break;
                            }
                            let _e260 = atomicAdd((&global_8.member[0u]), 1u);
                            if ((_e260 + 1u) < _e260) {
                                if _e256 {
                                } else {
                                    break;
                                }
                                let _e265 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                        if _e165 {
                        } else {
                            break;
                        }
                        let _e275 = global_9.member[_e150].member.member_2[0u];
                        let _e277 = (bitcast<u32>(_e275) & 2147483647u);
                        let _e283 = global_9.member[_e150].member.member_2[1u];
                        let _e285 = (bitcast<u32>(_e283) & 2147483647u);
                        let _e291 = global_9.member[_e150].member.member_2[2u];
                        let _e293 = (bitcast<u32>(_e291) & 2147483647u);
                        let _e299 = global_9.member[_e150].member.member[0u];
                        let _e301 = (bitcast<u32>(_e299) & 2147483647u);
                        let _e307 = global_9.member[_e150].member.member[1u];
                        let _e309 = (bitcast<u32>(_e307) & 2147483647u);
                        let _e315 = global_9.member[_e150].member.member[2u];
                        let _e317 = (bitcast<u32>(_e315) & 2147483647u);
                        let _e319 = select(_e285, _e277, (_e285 < _e277));
                        let _e321 = select(_e293, _e319, (_e293 < _e319));
                        let _e323 = select(_e301, _e321, (_e301 < _e321));
                        let _e325 = select(_e309, _e323, (_e309 < _e323));
                        let _e327 = select(_e317, _e325, (_e317 < _e325));
                        let _e329 = (bitcast<u32>(_e249) & 2147483647u);
                        let _e338 = (((select(_e329, _e327, (_e329 < _e327)) < 2139095040u) && ((bitcast<u32>(_e254) & 2147483647u) <= 2139095040u)) && (_e321 > 0u));
                        if _e338 {
                            let _e341 = (bitcast<u32>(bitcast<f32>(_e321)) & 2147483647u);
                            if (_e341 >= 8388608u) {
                                phi_553_ = (bitcast<i32>((_e341 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_553_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e341)), 32u, (_e341 == 0u))));
                            }
                            let _e355 = phi_553_;
                            phi_554_ = _e355;
                        } else {
                            phi_554_ = 0i;
                        }
                        let _e357 = phi_554_;
                        let _e358 = (_e277 == _e321);
                        if _e358 {
                            phi_564_ = true;
                        } else {
                            phi_564_ = (_e285 == _e321);
                        }
                        let _e361 = phi_564_;
                        let _e362 = select(1u, 0u, _e358);
                        if _e361 {
                            let _e363 = (_e362 + 1u);
                            phi_574_ = _e363;
                            phi_575_ = _e363;
                            phi_577_ = select(true, false, (_e363 == 2u));
                        } else {
                            phi_574_ = u32();
                            phi_575_ = 0u;
                            phi_577_ = true;
                        }
                        let _e367 = phi_574_;
                        let _e369 = phi_575_;
                        let _e371 = phi_577_;
                        if _e371 {
                            phi_582_ = (_e369 + 1u);
                        } else {
                            phi_582_ = 0u;
                        }
                        let _e375 = phi_582_;
                        let _e376 = select(_e367, _e369, _e371);
                        let _e377 = select(_e362, select(2u, _e362, _e361), _e371);
                        let _e378 = -(_e357);
                        if (_e378 < -126i) {
                            phi_614_ = -126i;
                        } else {
                            phi_614_ = select(_e378, 127i, (_e378 > 127i));
                        }
                        let _e383 = phi_614_;
                        let _e388 = bitcast<f32>((bitcast<u32>((_e383 + 127i)) << bitcast<u32>(23i)));
                        let _e394 = bitcast<f32>((bitcast<u32>(((_e378 - _e383) + 127i)) << bitcast<u32>(23i)));
                        let _e399 = global_9.member[_e150].member.member;
                        let _e400 = (_e376 == 0u);
                        if _e400 {
                            phi_632_ = _e399[0];
                        } else {
                            phi_632_ = _e399[1];
                        }
                        let _e404 = phi_632_;
                        let _e405 = (_e376 == 2u);
                        if _e405 {
                            phi_638_ = _e399[2];
                        } else {
                            phi_638_ = _e404;
                        }
                        let _e408 = phi_638_;
                        let _e409 = global_9.member[_e150].member.member_2;
                        if _e400 {
                            phi_649_ = _e409[0];
                        } else {
                            phi_649_ = _e409[1];
                        }
                        let _e413 = phi_649_;
                        if _e405 {
                            phi_655_ = _e409[2];
                        } else {
                            phi_655_ = _e413;
                        }
                        let _e416 = phi_655_;
                        let _e418 = ((_e416 * _e388) * _e394);
                        let _e422 = (bitcast<f32>((bitcast<u32>(_e418) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e422 {
                            let _e426 = (bitcast<f32>((bitcast<u32>(_e408) & 2147483647u)) * 0.00000011920929f);
                            phi_678_ = select(0.00000000000011368684f, _e426, (_e426 > 0.00000000000011368684f));
                        } else {
                            phi_678_ = 0f;
                        }
                        let _e430 = phi_678_;
                        let _e431 = (_e408 + _e430);
                        let _e432 = (_e408 - _e430);
                        let _e433 = select(_e418, 0f, _e422);
                        if _e422 {
                            phi_689_ = 38685626000000000000000000f;
                        } else {
                            phi_689_ = (1f / _e418);
                        }
                        let _e436 = phi_689_;
                        let _e437 = (_e375 == 0u);
                        if _e437 {
                            phi_698_ = _e399[0];
                        } else {
                            phi_698_ = _e399[1];
                        }
                        let _e441 = phi_698_;
                        let _e442 = (_e375 == 2u);
                        if _e442 {
                            phi_704_ = _e399[2];
                        } else {
                            phi_704_ = _e441;
                        }
                        let _e445 = phi_704_;
                        if _e437 {
                            phi_715_ = _e409[0];
                        } else {
                            phi_715_ = _e409[1];
                        }
                        let _e449 = phi_715_;
                        if _e442 {
                            phi_721_ = _e409[2];
                        } else {
                            phi_721_ = _e449;
                        }
                        let _e452 = phi_721_;
                        let _e454 = ((_e452 * _e388) * _e394);
                        let _e458 = (bitcast<f32>((bitcast<u32>(_e454) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e458 {
                            let _e462 = (bitcast<f32>((bitcast<u32>(_e445) & 2147483647u)) * 0.00000011920929f);
                            phi_744_ = select(0.00000000000011368684f, _e462, (_e462 > 0.00000000000011368684f));
                        } else {
                            phi_744_ = 0f;
                        }
                        let _e466 = phi_744_;
                        let _e467 = (_e445 + _e466);
                        let _e468 = (_e445 - _e466);
                        let _e469 = select(_e454, 0f, _e458);
                        if _e458 {
                            phi_755_ = 38685626000000000000000000f;
                        } else {
                            phi_755_ = (1f / _e454);
                        }
                        let _e472 = phi_755_;
                        let _e473 = (_e377 == 0u);
                        if _e473 {
                            phi_764_ = _e399[0];
                        } else {
                            phi_764_ = _e399[1];
                        }
                        let _e477 = phi_764_;
                        let _e478 = (_e377 == 2u);
                        if _e478 {
                            phi_770_ = _e399[2];
                        } else {
                            phi_770_ = _e477;
                        }
                        let _e481 = phi_770_;
                        if _e473 {
                            phi_781_ = _e409[0];
                        } else {
                            phi_781_ = _e409[1];
                        }
                        let _e485 = phi_781_;
                        if _e478 {
                            phi_787_ = _e409[2];
                        } else {
                            phi_787_ = _e485;
                        }
                        let _e488 = phi_787_;
                        let _e490 = ((_e488 * _e388) * _e394);
                        let _e494 = (bitcast<f32>((bitcast<u32>(_e490) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e494 {
                            let _e498 = (bitcast<f32>((bitcast<u32>(_e481) & 2147483647u)) * 0.00000011920929f);
                            phi_810_ = select(0.00000000000011368684f, _e498, (_e498 > 0.00000000000011368684f));
                        } else {
                            phi_810_ = 0f;
                        }
                        let _e502 = phi_810_;
                        let _e503 = (_e481 + _e502);
                        let _e504 = (_e481 - _e502);
                        let _e505 = select(_e490, 0f, _e494);
                        if _e494 {
                            phi_821_ = 38685626000000000000000000f;
                        } else {
                            phi_821_ = (1f / _e490);
                        }
                        let _e508 = phi_821_;
                        let _e511 = bitcast<f32>((bitcast<u32>(_e408) & 2147483647u));
                        let _e514 = bitcast<f32>((bitcast<u32>(_e445) & 2147483647u));
                        let _e516 = select(_e514, _e511, (_e511 > _e514));
                        let _e519 = bitcast<f32>((bitcast<u32>(_e481) & 2147483647u));
                        if (_e338 && (select(_e519, _e516, (_e516 > _e519)) <= 1099511600000f)) {
                            let _e524 = (_e357 / 3i);
                            let _e531 = bitcast<f32>((bitcast<u32>((_e524 + 127i)) << bitcast<u32>(23i)));
                            let _e538 = bitcast<f32>((bitcast<u32>(((_e357 - (2i * _e524)) + 127i)) << bitcast<u32>(23i)));
                            let _e539 = (((_e249 * _e531) * _e531) * _e538);
                            let _e541 = select(340282350000000000000000000000000000000f, _e539, (_e539 < 340282350000000000000000000000000000000f));
                            let _e546 = (((_e254 * _e531) * _e531) * _e538);
                            let _e548 = select(340282350000000000000000000000000000000f, _e546, (_e546 < 340282350000000000000000000000000000000f));
                            phi_921_ = select(-340282350000000000000000000000000000000f, _e548, (_e548 > -340282350000000000000000000000000000000f));
                            phi_922_ = select(-340282350000000000000000000000000000000f, _e541, (_e541 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_921_ = 0f;
                            phi_922_ = 1f;
                        }
                        let _e552 = phi_921_;
                        let _e554 = phi_922_;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e558 = (_e376 % 3u);
                        let _e559 = (_e558 < 3u);
                        if _e559 {
                        } else {
                            break;
                        }
                        let _e561 = local_1[_e558];
                        let _e564 = (_e375 % 3u);
                        let _e565 = (_e564 < 3u);
                        if _e565 {
                        } else {
                            break;
                        }
                        let _e567 = local_1[_e564];
                        let _e570 = (_e377 % 3u);
                        let _e571 = (_e570 < 3u);
                        if _e571 {
                        } else {
                            break;
                        }
                        let _e573 = local_1[_e570];
                        if _e559 {
                        } else {
                            break;
                        }
                        let _e578 = local[_e558];
                        if _e565 {
                        } else {
                            break;
                        }
                        let _e582 = local[_e564];
                        if _e571 {
                        } else {
                            break;
                        }
                        let _e586 = local[_e570];
                        phi_4537_ = false;
                        phi_1011_ = type_46(_e552, false);
                        phi_1014_ = type_58(type_34(vec4<f32>((f32(_e561) * _e162), (f32(_e567) * _e162), (f32(_e573) * _e162), 0f), vec4<f32>((f32(_e578) * _e162), (f32(_e582) * _e162), (f32(_e586) * _e162), 0f)), select(0u, 2147483648u, (_e103 == 0u)));
                        phi_1016_ = ((3u * _e103) + 1u);
                        phi_1018_ = (_e554 <= _e552);
                        phi_1020_ = 0u;
                        loop {
                            let _e596 = phi_4537_;
                            let _e598 = phi_1011_;
                            let _e600 = phi_1014_;
                            let _e602 = phi_1016_;
                            let _e604 = phi_1018_;
                            let _e606 = phi_1020_;
                            local_11 = _e598;
                            if _e604 {
                                phi_1031_ = true;
                            } else {
                                phi_1031_ = (_e606 > 0u);
                            }
                            let _e609 = phi_1031_;
                            if _e609 {
                                let _e610 = (_e602 > 0u);
                                if _e610 {
                                    if _e604 {
                                        phi_1117_ = _e600;
                                        phi_1118_ = _e604;
                                        phi_1119_ = _e606;
                                    } else {
                                        let _e611 = (_e606 - 1u);
                                        let _e612 = (_e611 % 128u);
                                        let _e613 = (_e612 < 128u);
                                        if _e613 {
                                        } else {
                                            phi_4744_ = true;
                                            break;
                                        }
                                        let _e615 = local_7[_e612];
                                        if _e613 {
                                        } else {
                                            phi_4744_ = true;
                                            break;
                                        }
                                        let _e617 = local_6[_e612];
                                        if _e613 {
                                        } else {
                                            phi_4744_ = true;
                                            break;
                                        }
                                        let _e619 = local_5[_e612];
                                        if _e613 {
                                        } else {
                                            phi_4744_ = true;
                                            break;
                                        }
                                        let _e621 = local_4[_e612];
                                        if _e613 {
                                        } else {
                                            phi_4744_ = true;
                                            break;
                                        }
                                        let _e623 = local_3[_e612];
                                        if _e613 {
                                        } else {
                                            phi_4744_ = true;
                                            break;
                                        }
                                        let _e625 = local_2[_e612];
                                        if _e613 {
                                        } else {
                                            phi_4744_ = true;
                                            break;
                                        }
                                        let _e630 = local_8[_e612];
                                        if _e613 {
                                        } else {
                                            phi_4744_ = true;
                                            break;
                                        }
                                        let _e633 = local_9[_e612];
                                        phi_1117_ = type_58(type_34(vec4<f32>(_e615, _e617, _e619, 0f), vec4<f32>(_e621, _e623, _e625, 0f)), _e630);
                                        phi_1118_ = (_e633 <= _e598.member);
                                        phi_1119_ = _e611;
                                    }
                                    let _e637 = phi_1117_;
                                    let _e639 = phi_1118_;
                                    let _e641 = phi_1119_;
                                    if _e639 {
                                        let _e646 = (_e637.member_1 & 268435455u);
                                        if ((_e637.member_1 & 2147483648u) != 0u) {
                                            phi_1138_ = _e598;
                                            phi_1141_ = type_8(0u, ((_e637.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1106 = phi_1138_;
                                                let _e1108 = phi_1141_;
                                                local_10 = _e1106;
                                                local_12 = _e1106;
                                                if (_e1108.member < _e1108.member_1) {
                                                    phi_1142_ = type_8((_e1108.member + 1u), _e1108.member_1);
                                                    phi_1164_ = type_8(1u, _e1108.member);
                                                } else {
                                                    phi_1142_ = _e1108;
                                                    phi_1164_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1121 = phi_1142_;
                                                let _e1123 = phi_1164_;
                                                let _e1127 = (bitcast<i32>(_e1123.member) != 0i);
                                                if _e1127 {
                                                    let _e1132 = (_e637.member.member_1.x - _e637.member.member.x);
                                                    let _e1135 = (_e637.member.member_1.y - _e637.member.member.y);
                                                    let _e1138 = (_e637.member.member_1.z - _e637.member.member.z);
                                                    let _e1140 = select(_e1135, _e1132, (_e1132 > _e1135));
                                                    let _e1142 = select(_e1138, _e1140, (_e1140 > _e1138));
                                                    let _e1144 = (_e1142 < (1024f * _e162));
                                                    if _e1144 {
                                                        phi_1205_ = 0u;
                                                    } else {
                                                        phi_1205_ = select(2u, 1u, (_e1142 < (2097152f * _e162)));
                                                    }
                                                    let _e1149 = phi_1205_;
                                                    switch bitcast<i32>(_e1149) {
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
                                                    let _e1152 = phi_1211_;
                                                    switch bitcast<i32>(_e1149) {
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
                                                    let _e1159 = phi_1221_;
                                                    let _e1161 = ((_e646 + (_e1123.member_1 * ((3u * _e1152) + 1u))) + (3u * _e1159));
                                                    let _e1162 = (_e1161 < _e106);
                                                    if _e1162 {
                                                        if _e1162 {
                                                        } else {
                                                            phi_4531_ = true;
                                                            break;
                                                        }
                                                        let _e1164 = global_10.member[_e1161];
                                                        phi_1237_ = _e1164;
                                                    } else {
                                                        phi_1237_ = 4294967295u;
                                                    }
                                                    let _e1166 = phi_1237_;
                                                    if _e1144 {
                                                        phi_1270_ = 0u;
                                                    } else {
                                                        phi_1270_ = select(2u, 1u, (_e1142 < (2097152f * _e162)));
                                                    }
                                                    let _e1171 = phi_1270_;
                                                    switch bitcast<i32>(_e1171) {
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
                                                    let _e1174 = phi_1276_;
                                                    let _e1178 = (_e646 + (_e1123.member_1 * ((3u * _e1174) + 1u)));
                                                    switch bitcast<i32>(_e1171) {
                                                        case 0: {
                                                            let _e1444 = (_e1178 < _e106);
                                                            if _e1444 {
                                                                if _e1444 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e1446 = global_10.member[_e1178];
                                                                phi_1300_ = _e1446;
                                                            } else {
                                                                phi_1300_ = 0u;
                                                            }
                                                            let _e1448 = phi_1300_;
                                                            let _e1450 = ((10u * _e376) & 31u);
                                                            let _e1459 = ((10u * _e375) & 31u);
                                                            let _e1468 = ((10u * _e377) & 31u);
                                                            let _e1477 = (_e1178 + 1u);
                                                            let _e1478 = (_e1477 < _e106);
                                                            if _e1478 {
                                                                if _e1478 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e1480 = global_10.member[_e1477];
                                                                phi_1343_ = _e1480;
                                                            } else {
                                                                phi_1343_ = 0u;
                                                            }
                                                            let _e1482 = phi_1343_;
                                                            let _e1505 = (_e1178 + 2u);
                                                            let _e1506 = (_e1505 < _e106);
                                                            if _e1506 {
                                                                if _e1506 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e1508 = global_10.member[_e1505];
                                                                phi_1386_ = _e1508;
                                                            } else {
                                                                phi_1386_ = 0u;
                                                            }
                                                            let _e1510 = phi_1386_;
                                                            phi_1857_ = array<array<f32, 3>, 3>(array<f32, 3>((_e637.member.member.x + (f32(bitcast<i32>(((_e1448 >> bitcast<u32>(_e1450)) & 1023u))) * _e162)), (_e637.member.member.y + (f32(bitcast<i32>(((_e1448 >> bitcast<u32>(_e1459)) & 1023u))) * _e162)), (_e637.member.member.z + (f32(bitcast<i32>(((_e1448 >> bitcast<u32>(_e1468)) & 1023u))) * _e162))), array<f32, 3>((_e637.member.member.x + (f32(bitcast<i32>(((_e1482 >> bitcast<u32>(_e1450)) & 1023u))) * _e162)), (_e637.member.member.y + (f32(bitcast<i32>(((_e1482 >> bitcast<u32>(_e1459)) & 1023u))) * _e162)), (_e637.member.member.z + (f32(bitcast<i32>(((_e1482 >> bitcast<u32>(_e1468)) & 1023u))) * _e162))), array<f32, 3>((_e637.member.member.x + (f32(bitcast<i32>(((_e1510 >> bitcast<u32>(_e1450)) & 1023u))) * _e162)), (_e637.member.member.y + (f32(bitcast<i32>(((_e1510 >> bitcast<u32>(_e1459)) & 1023u))) * _e162)), (_e637.member.member.z + (f32(bitcast<i32>(((_e1510 >> bitcast<u32>(_e1468)) & 1023u))) * _e162))));
                                                            break;
                                                        }
                                                        case 1: {
                                                            let _e1267 = (_e1178 < _e106);
                                                            if _e1267 {
                                                                if _e1267 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e1269 = global_10.member[_e1178];
                                                                phi_1429_ = _e1269;
                                                            } else {
                                                                phi_1429_ = 0u;
                                                            }
                                                            let _e1271 = phi_1429_;
                                                            let _e1272 = (_e1178 + 1u);
                                                            let _e1273 = (_e1272 < _e106);
                                                            if _e1273 {
                                                                if _e1273 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e1275 = global_10.member[_e1272];
                                                                phi_1444_ = _e1275;
                                                            } else {
                                                                phi_1444_ = 0u;
                                                            }
                                                            let _e1277 = phi_1444_;
                                                            let _e1278 = (_e376 == 1u);
                                                            if _e1278 {
                                                                phi_1454_ = ((_e1271 >> bitcast<u32>(21i)) | (_e1277 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1454_ = (_e1277 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1287 = phi_1454_;
                                                            let _e1294 = (_e375 == 1u);
                                                            if _e1294 {
                                                                phi_1474_ = ((_e1271 >> bitcast<u32>(21i)) | (_e1277 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1474_ = (_e1277 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1303 = phi_1474_;
                                                            let _e1310 = (_e377 == 1u);
                                                            if _e1310 {
                                                                phi_1494_ = ((_e1271 >> bitcast<u32>(21i)) | (_e1277 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1494_ = (_e1277 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1319 = phi_1494_;
                                                            let _e1327 = (_e1178 + 2u);
                                                            let _e1328 = (_e1327 < _e106);
                                                            if _e1328 {
                                                                if _e1328 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e1330 = global_10.member[_e1327];
                                                                phi_1520_ = _e1330;
                                                            } else {
                                                                phi_1520_ = 0u;
                                                            }
                                                            let _e1332 = phi_1520_;
                                                            let _e1333 = (_e1178 + 3u);
                                                            let _e1334 = (_e1333 < _e106);
                                                            if _e1334 {
                                                                if _e1334 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e1336 = global_10.member[_e1333];
                                                                phi_1535_ = _e1336;
                                                            } else {
                                                                phi_1535_ = 0u;
                                                            }
                                                            let _e1338 = phi_1535_;
                                                            if _e1278 {
                                                                phi_1545_ = ((_e1332 >> bitcast<u32>(21i)) | (_e1338 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1545_ = (_e1338 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1347 = phi_1545_;
                                                            if _e1294 {
                                                                phi_1565_ = ((_e1332 >> bitcast<u32>(21i)) | (_e1338 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1565_ = (_e1338 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1362 = phi_1565_;
                                                            if _e1310 {
                                                                phi_1585_ = ((_e1332 >> bitcast<u32>(21i)) | (_e1338 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1585_ = (_e1338 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1377 = phi_1585_;
                                                            let _e1385 = (_e1178 + 4u);
                                                            let _e1386 = (_e1385 < _e106);
                                                            if _e1386 {
                                                                if _e1386 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e1388 = global_10.member[_e1385];
                                                                phi_1611_ = _e1388;
                                                            } else {
                                                                phi_1611_ = 0u;
                                                            }
                                                            let _e1390 = phi_1611_;
                                                            let _e1391 = (_e1178 + 5u);
                                                            let _e1392 = (_e1391 < _e106);
                                                            if _e1392 {
                                                                if _e1392 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e1394 = global_10.member[_e1391];
                                                                phi_1626_ = _e1394;
                                                            } else {
                                                                phi_1626_ = 0u;
                                                            }
                                                            let _e1396 = phi_1626_;
                                                            if _e1278 {
                                                                phi_1636_ = ((_e1390 >> bitcast<u32>(21i)) | (_e1396 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1636_ = (_e1396 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1405 = phi_1636_;
                                                            if _e1294 {
                                                                phi_1656_ = ((_e1390 >> bitcast<u32>(21i)) | (_e1396 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1656_ = (_e1396 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1420 = phi_1656_;
                                                            if _e1310 {
                                                                phi_1676_ = ((_e1390 >> bitcast<u32>(21i)) | (_e1396 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1676_ = (_e1396 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1435 = phi_1676_;
                                                            phi_1857_ = array<array<f32, 3>, 3>(array<f32, 3>((_e637.member.member.x + (f32(bitcast<i32>((select(_e1287, _e1271, _e400) & 2097151u))) * _e162)), (_e637.member.member.y + (f32(bitcast<i32>((select(_e1303, _e1271, _e437) & 2097151u))) * _e162)), (_e637.member.member.z + (f32(bitcast<i32>((select(_e1319, _e1271, _e473) & 2097151u))) * _e162))), array<f32, 3>((_e637.member.member.x + (f32(bitcast<i32>((select(_e1347, _e1332, _e400) & 2097151u))) * _e162)), (_e637.member.member.y + (f32(bitcast<i32>((select(_e1362, _e1332, _e437) & 2097151u))) * _e162)), (_e637.member.member.z + (f32(bitcast<i32>((select(_e1377, _e1332, _e473) & 2097151u))) * _e162))), array<f32, 3>((_e637.member.member.x + (f32(bitcast<i32>((select(_e1405, _e1390, _e400) & 2097151u))) * _e162)), (_e637.member.member.y + (f32(bitcast<i32>((select(_e1420, _e1390, _e437) & 2097151u))) * _e162)), (_e637.member.member.z + (f32(bitcast<i32>((select(_e1435, _e1390, _e473) & 2097151u))) * _e162))));
                                                            break;
                                                        }
                                                        case 2: {
                                                            let _e1180 = (_e1178 + _e376);
                                                            let _e1181 = (_e1180 < _e106);
                                                            if _e1181 {
                                                                if _e1181 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e1183 = global_10.member[_e1180];
                                                                phi_1703_ = _e1183;
                                                            } else {
                                                                phi_1703_ = 0u;
                                                            }
                                                            let _e1185 = phi_1703_;
                                                            let _e1189 = (_e1178 + _e375);
                                                            let _e1190 = (_e1189 < _e106);
                                                            if _e1190 {
                                                                if _e1190 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e1192 = global_10.member[_e1189];
                                                                phi_1721_ = _e1192;
                                                            } else {
                                                                phi_1721_ = 0u;
                                                            }
                                                            let _e1194 = phi_1721_;
                                                            let _e1198 = (_e1178 + _e377);
                                                            let _e1199 = (_e1198 < _e106);
                                                            if _e1199 {
                                                                if _e1199 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e1201 = global_10.member[_e1198];
                                                                phi_1739_ = _e1201;
                                                            } else {
                                                                phi_1739_ = 0u;
                                                            }
                                                            let _e1203 = phi_1739_;
                                                            let _e1208 = (_e1178 + 3u);
                                                            let _e1209 = (_e1208 + _e376);
                                                            let _e1210 = (_e1209 < _e106);
                                                            if _e1210 {
                                                                if _e1210 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e1212 = global_10.member[_e1209];
                                                                phi_1759_ = _e1212;
                                                            } else {
                                                                phi_1759_ = 0u;
                                                            }
                                                            let _e1214 = phi_1759_;
                                                            let _e1218 = (_e1208 + _e375);
                                                            let _e1219 = (_e1218 < _e106);
                                                            if _e1219 {
                                                                if _e1219 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e1221 = global_10.member[_e1218];
                                                                phi_1777_ = _e1221;
                                                            } else {
                                                                phi_1777_ = 0u;
                                                            }
                                                            let _e1223 = phi_1777_;
                                                            let _e1227 = (_e1208 + _e377);
                                                            let _e1228 = (_e1227 < _e106);
                                                            if _e1228 {
                                                                if _e1228 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e1230 = global_10.member[_e1227];
                                                                phi_1795_ = _e1230;
                                                            } else {
                                                                phi_1795_ = 0u;
                                                            }
                                                            let _e1232 = phi_1795_;
                                                            let _e1237 = (_e1178 + 6u);
                                                            let _e1238 = (_e1237 + _e376);
                                                            let _e1239 = (_e1238 < _e106);
                                                            if _e1239 {
                                                                if _e1239 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e1241 = global_10.member[_e1238];
                                                                phi_1815_ = _e1241;
                                                            } else {
                                                                phi_1815_ = 0u;
                                                            }
                                                            let _e1243 = phi_1815_;
                                                            let _e1247 = (_e1237 + _e375);
                                                            let _e1248 = (_e1247 < _e106);
                                                            if _e1248 {
                                                                if _e1248 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e1250 = global_10.member[_e1247];
                                                                phi_1833_ = _e1250;
                                                            } else {
                                                                phi_1833_ = 0u;
                                                            }
                                                            let _e1252 = phi_1833_;
                                                            let _e1256 = (_e1237 + _e377);
                                                            let _e1257 = (_e1256 < _e106);
                                                            if _e1257 {
                                                                if _e1257 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e1259 = global_10.member[_e1256];
                                                                phi_1851_ = _e1259;
                                                            } else {
                                                                phi_1851_ = 0u;
                                                            }
                                                            let _e1261 = phi_1851_;
                                                            phi_1857_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1185)) * _e162), (f32(bitcast<i32>(_e1194)) * _e162), (f32(bitcast<i32>(_e1203)) * _e162)), array<f32, 3>((f32(bitcast<i32>(_e1214)) * _e162), (f32(bitcast<i32>(_e1223)) * _e162), (f32(bitcast<i32>(_e1232)) * _e162)), array<f32, 3>((f32(bitcast<i32>(_e1243)) * _e162), (f32(bitcast<i32>(_e1252)) * _e162), (f32(bitcast<i32>(_e1261)) * _e162)));
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1857_ = array<array<f32, 3>, 3>();
                                                            break;
                                                        }
                                                    }
                                                    let _e1535 = phi_1857_;
                                                    let _e1543 = (_e1535[0][2] - _e481);
                                                    let _e1546 = (((_e1535[0][0] - _e408) * _e505) - (_e1543 * _e433));
                                                    let _e1549 = (((_e1535[0][1] - _e445) * _e505) - (_e1543 * _e469));
                                                    let _e1556 = (_e1535[1][2] - _e481);
                                                    let _e1559 = (((_e1535[1][0] - _e408) * _e505) - (_e1556 * _e433));
                                                    let _e1562 = (((_e1535[1][1] - _e445) * _e505) - (_e1556 * _e469));
                                                    let _e1569 = (_e1535[2][2] - _e481);
                                                    let _e1572 = (((_e1535[2][0] - _e408) * _e505) - (_e1569 * _e433));
                                                    let _e1575 = (((_e1535[2][1] - _e445) * _e505) - (_e1569 * _e469));
                                                    let _e1576 = (_e1572 * _e1562);
                                                    let _e1577 = (_e1575 * _e1559);
                                                    let _e1578 = (_e1546 * _e1575);
                                                    let _e1579 = (_e1549 * _e1572);
                                                    let _e1580 = (_e1559 * _e1549);
                                                    let _e1581 = (_e1562 * _e1546);
                                                    let _e1586 = (((_e1576 >= _e1577) && (_e1578 >= _e1579)) && (_e1580 >= _e1581));
                                                    if (_e1586 || (((_e1576 <= _e1577) && (_e1578 <= _e1579)) && (_e1580 <= _e1581))) {
                                                        let _e1593 = select(-1f, 1f, _e1586);
                                                        let _e1595 = ((_e1576 - _e1577) * _e1593);
                                                        let _e1597 = select(0f, _e1595, (_e1595 > 0f));
                                                        let _e1599 = ((_e1578 - _e1579) * _e1593);
                                                        let _e1601 = select(0f, _e1599, (_e1599 > 0f));
                                                        let _e1603 = ((_e1580 - _e1581) * _e1593);
                                                        let _e1605 = select(0f, _e1603, (_e1603 > 0f));
                                                        let _e1607 = ((_e1597 + _e1601) + _e1605);
                                                        if (_e1607 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2682_ = type_25();
                                                            phi_2683_ = true;
                                                            phi_2684_ = false;
                                                        } else {
                                                            let _e1610 = select(_e1559, _e1546, (_e1546 < _e1559));
                                                            if (select(_e1572, _e1610, (_e1610 < _e1572)) > 0f) {
                                                                phi_1974_ = true;
                                                            } else {
                                                                let _e1615 = select(_e1559, _e1546, (_e1546 > _e1559));
                                                                phi_1974_ = (select(_e1572, _e1615, (_e1615 > _e1572)) < 0f);
                                                            }
                                                            let _e1620 = phi_1974_;
                                                            if _e1620 {
                                                                phi_2679_ = type_25();
                                                                phi_2680_ = true;
                                                                phi_2681_ = false;
                                                            } else {
                                                                let _e1622 = select(_e1562, _e1549, (_e1549 < _e1562));
                                                                if (select(_e1575, _e1622, (_e1622 < _e1575)) > 0f) {
                                                                    phi_2003_ = true;
                                                                } else {
                                                                    let _e1627 = select(_e1562, _e1549, (_e1549 > _e1562));
                                                                    phi_2003_ = (select(_e1575, _e1627, (_e1627 > _e1575)) < 0f);
                                                                }
                                                                let _e1632 = phi_2003_;
                                                                if _e1632 {
                                                                    phi_2677_ = type_25();
                                                                    phi_2678_ = false;
                                                                } else {
                                                                    let _e1634 = select(_e1535[1][0], _e1535[0][0], (_e1535[0][0] < _e1535[1][0]));
                                                                    let _e1638 = select(_e1535[1][0], _e1535[0][0], (_e1535[0][0] > _e1535[1][0]));
                                                                    let _e1642 = select(_e1535[1][1], _e1535[0][1], (_e1535[0][1] < _e1535[1][1]));
                                                                    let _e1646 = select(_e1535[1][1], _e1535[0][1], (_e1535[0][1] > _e1535[1][1]));
                                                                    let _e1650 = select(_e1535[1][2], _e1535[0][2], (_e1535[0][2] < _e1535[1][2]));
                                                                    let _e1654 = select(_e1535[1][2], _e1535[0][2], (_e1535[0][2] > _e1535[1][2]));
                                                                    let _e1659 = ((select(_e1535[2][0], _e1634, (_e1634 < _e1535[2][0])) - _e431) * _e436);
                                                                    let _e1660 = ((select(_e1535[2][0], _e1638, (_e1638 > _e1535[2][0])) - _e432) * _e436);
                                                                    let _e1663 = ((select(_e1535[2][1], _e1642, (_e1642 < _e1535[2][1])) - _e467) * _e472);
                                                                    let _e1664 = ((select(_e1535[2][1], _e1646, (_e1646 > _e1535[2][1])) - _e468) * _e472);
                                                                    let _e1667 = ((select(_e1535[2][2], _e1650, (_e1650 < _e1535[2][2])) - _e503) * _e508);
                                                                    let _e1668 = ((select(_e1535[2][2], _e1654, (_e1654 > _e1535[2][2])) - _e504) * _e508);
                                                                    let _e1670 = select(_e1668, _e1667, (_e1667 < _e1668));
                                                                    let _e1672 = select(_e1668, _e1667, (_e1667 > _e1668));
                                                                    let _e1674 = select(_e1660, _e1659, (_e1659 < _e1660));
                                                                    let _e1676 = select(_e1664, _e1663, (_e1663 < _e1664));
                                                                    let _e1678 = select(_e1676, _e1674, (_e1674 > _e1676));
                                                                    let _e1680 = select(_e1670, _e1678, (_e1678 > _e1670));
                                                                    let _e1682 = select(_e1660, _e1659, (_e1659 > _e1660));
                                                                    let _e1684 = select(_e1664, _e1663, (_e1663 > _e1664));
                                                                    let _e1686 = select(_e1684, _e1682, (_e1682 < _e1684));
                                                                    let _e1688 = select(_e1672, _e1686, (_e1686 < _e1672));
                                                                    let _e1689 = -(_e1670);
                                                                    let _e1695 = select(_e554, _e1680, (_e1680 > _e554));
                                                                    if (_e1695 > (_e1688 + (select(_e1689, _e1672, (_e1672 > _e1689)) * 0.0000019073523f))) {
                                                                        phi_2672_ = type_25();
                                                                        phi_2673_ = true;
                                                                    } else {
                                                                        let _e1697 = (_e1695 > _e1106.member);
                                                                        if _e1697 {
                                                                            phi_2671_ = type_25();
                                                                        } else {
                                                                            let _e1698 = vec3<f32>(_e1535[0][0], _e1535[0][1], _e1535[0][2]);
                                                                            let _e1699 = vec3<f32>(_e1535[1][0], _e1535[1][1], _e1535[1][2]);
                                                                            let _e1700 = vec3<f32>(_e1535[2][0], _e1535[2][1], _e1535[2][2]);
                                                                            let _e1701 = (_e1535[1][0] - _e1535[0][0]);
                                                                            let _e1702 = (_e1535[1][1] - _e1535[0][1]);
                                                                            let _e1703 = (_e1535[1][2] - _e1535[0][2]);
                                                                            let _e1704 = vec3<f32>(_e1701, _e1702, _e1703);
                                                                            let _e1705 = (_e1535[2][0] - _e1535[1][0]);
                                                                            let _e1706 = (_e1535[2][1] - _e1535[1][1]);
                                                                            let _e1707 = (_e1535[2][2] - _e1535[1][2]);
                                                                            let _e1708 = vec3<f32>(_e1705, _e1706, _e1707);
                                                                            let _e1709 = (_e1535[0][0] - _e1535[2][0]);
                                                                            let _e1710 = (_e1535[0][1] - _e1535[2][1]);
                                                                            let _e1711 = (_e1535[0][2] - _e1535[2][2]);
                                                                            let _e1712 = vec3<f32>(_e1709, _e1710, _e1711);
                                                                            let _e1715 = bitcast<f32>((bitcast<u32>(_e1701) & 2147483647u));
                                                                            let _e1718 = bitcast<f32>((bitcast<u32>(_e1702) & 2147483647u));
                                                                            let _e1720 = select(_e1718, _e1715, (_e1715 > _e1718));
                                                                            let _e1723 = bitcast<f32>((bitcast<u32>(_e1703) & 2147483647u));
                                                                            let _e1725 = select(_e1723, _e1720, (_e1720 > _e1723));
                                                                            let _e1728 = bitcast<f32>((bitcast<u32>(_e1705) & 2147483647u));
                                                                            let _e1731 = bitcast<f32>((bitcast<u32>(_e1706) & 2147483647u));
                                                                            let _e1733 = select(_e1731, _e1728, (_e1728 > _e1731));
                                                                            let _e1736 = bitcast<f32>((bitcast<u32>(_e1707) & 2147483647u));
                                                                            let _e1738 = select(_e1736, _e1733, (_e1733 > _e1736));
                                                                            let _e1741 = bitcast<f32>((bitcast<u32>(_e1709) & 2147483647u));
                                                                            let _e1744 = bitcast<f32>((bitcast<u32>(_e1710) & 2147483647u));
                                                                            let _e1746 = select(_e1744, _e1741, (_e1741 > _e1744));
                                                                            let _e1749 = bitcast<f32>((bitcast<u32>(_e1711) & 2147483647u));
                                                                            let _e1751 = select(_e1749, _e1746, (_e1746 > _e1749));
                                                                            let _e1753 = select(_e1738, _e1725, (_e1725 > _e1738));
                                                                            let _e1755 = select(_e1751, _e1753, (_e1753 > _e1751));
                                                                            if (_e1725 == _e1755) {
                                                                                phi_2404_ = _e1562;
                                                                                phi_2405_ = _e1559;
                                                                                phi_2406_ = _e1549;
                                                                                phi_2407_ = _e1546;
                                                                                phi_2408_ = _e1698;
                                                                                phi_2409_ = _e1712;
                                                                                phi_2410_ = _e1708;
                                                                                phi_2411_ = _e1704;
                                                                            } else {
                                                                                let _e1757 = (_e1738 == _e1755);
                                                                                let _e1762 = vec3(_e1757);
                                                                                phi_2404_ = select(_e1549, _e1575, _e1757);
                                                                                phi_2405_ = select(_e1546, _e1572, _e1757);
                                                                                phi_2406_ = select(_e1575, _e1562, _e1757);
                                                                                phi_2407_ = select(_e1572, _e1559, _e1757);
                                                                                phi_2408_ = select(_e1700, _e1699, _e1762);
                                                                                phi_2409_ = select(_e1708, _e1704, _e1762);
                                                                                phi_2410_ = select(_e1704, _e1712, _e1762);
                                                                                phi_2411_ = select(_e1712, _e1708, _e1762);
                                                                            }
                                                                            let _e1768 = phi_2404_;
                                                                            let _e1770 = phi_2405_;
                                                                            let _e1772 = phi_2406_;
                                                                            let _e1774 = phi_2407_;
                                                                            let _e1776 = phi_2408_;
                                                                            let _e1778 = phi_2409_;
                                                                            let _e1780 = phi_2410_;
                                                                            let _e1782 = phi_2411_;
                                                                            let _e1789 = ((_e1780.y * _e1778.z) - (_e1778.y * _e1780.z));
                                                                            let _e1794 = ((_e1780.z * _e1778.x) - (_e1778.z * _e1780.x));
                                                                            let _e1797 = ((_e1780.x * _e1778.y) - (_e1778.x * _e1780.y));
                                                                            if (_e1597 >= _e1601) {
                                                                                phi_2442_ = select(true, false, (_e1597 >= _e1605));
                                                                            } else {
                                                                                phi_2442_ = true;
                                                                            }
                                                                            let _e1802 = phi_2442_;
                                                                            if _e1802 {
                                                                                phi_2451_ = select(_e1700, _e1699, vec3((_e1601 >= _e1605)));
                                                                            } else {
                                                                                phi_2451_ = _e1698;
                                                                            }
                                                                            let _e1807 = phi_2451_;
                                                                            let _e1818 = (((_e1789 * (_e1807.x - _e408)) + (_e1794 * (_e1807.y - _e445))) + (_e1797 * (_e1807.z - _e481)));
                                                                            let _e1823 = (((_e1789 * _e433) + (_e1794 * _e469)) + (_e1797 * _e505));
                                                                            let _e1824 = (_e1770 - _e1774);
                                                                            let _e1825 = (_e1768 - _e1772);
                                                                            let _e1833 = (-(((_e1774 * _e1824) + (_e1772 * _e1825))) / ((_e1824 * _e1824) + (_e1825 * _e1825)));
                                                                            let _e1835 = select(1f, _e1833, (_e1833 < 1f));
                                                                            let _e1837 = select(0f, _e1835, (_e1835 > 0f));
                                                                            let _e1850 = ((_e1776.x + (_e1782.x * _e1837)) - _e408);
                                                                            let _e1851 = ((_e1776.y + (_e1782.y * _e1837)) - _e445);
                                                                            let _e1852 = ((_e1776.z + (_e1782.z * _e1837)) - _e481);
                                                                            let _e1853 = (_e1852 / _e505);
                                                                            let _e1865 = bitcast<f32>((bitcast<u32>(_e1850) & 2147483647u));
                                                                            let _e1868 = bitcast<f32>((bitcast<u32>(_e1851) & 2147483647u));
                                                                            let _e1870 = select(_e1868, _e1865, (_e1865 > _e1868));
                                                                            let _e1873 = bitcast<f32>((bitcast<u32>(_e1852) & 2147483647u));
                                                                            let _e1875 = select(_e1873, _e1870, (_e1870 > _e1873));
                                                                            let _e1881 = bitcast<f32>((bitcast<u32>(_e1789) & 2147483647u));
                                                                            let _e1884 = bitcast<f32>((bitcast<u32>(_e1794) & 2147483647u));
                                                                            let _e1886 = select(_e1884, _e1881, (_e1881 > _e1884));
                                                                            let _e1889 = bitcast<f32>((bitcast<u32>(_e1797) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1789 * _e1850) + (_e1794 * _e1851)) + (_e1797 * _e1852)) - _e1818)) & 2147483647u)) <= ((0.0000009536743f * select(_e1755, _e1875, (_e1875 > _e1755))) * select(_e1889, _e1886, (_e1886 > _e1889)))) {
                                                                                let _e1899 = bitcast<f32>((bitcast<u32>(_e1780.x) & 2147483647u));
                                                                                let _e1902 = bitcast<f32>((bitcast<u32>(_e1780.y) & 2147483647u));
                                                                                let _e1904 = select(_e1902, _e1899, (_e1899 > _e1902));
                                                                                let _e1907 = bitcast<f32>((bitcast<u32>(_e1780.z) & 2147483647u));
                                                                                let _e1913 = bitcast<f32>((bitcast<u32>(_e1778.x) & 2147483647u));
                                                                                let _e1916 = bitcast<f32>((bitcast<u32>(_e1778.y) & 2147483647u));
                                                                                let _e1918 = select(_e1916, _e1913, (_e1913 > _e1916));
                                                                                let _e1921 = bitcast<f32>((bitcast<u32>(_e1778.z) & 2147483647u));
                                                                                let _e1925 = (bitcast<f32>((bitcast<u32>(_e1823) & 2147483647u)) > ((0.0000038146973f * select(_e1907, _e1904, (_e1904 > _e1907))) * select(_e1921, _e1918, (_e1918 > _e1921))));
                                                                                if _e1925 {
                                                                                    phi_2616_ = (_e1818 / _e1823);
                                                                                } else {
                                                                                    phi_2616_ = f32();
                                                                                }
                                                                                let _e1928 = phi_2616_;
                                                                                phi_2618_ = _e1928;
                                                                                phi_2619_ = select(true, false, _e1925);
                                                                            } else {
                                                                                phi_2618_ = f32();
                                                                                phi_2619_ = true;
                                                                            }
                                                                            let _e1931 = phi_2618_;
                                                                            let _e1933 = phi_2619_;
                                                                            if _e1933 {
                                                                                let _e1941 = (((_e1789 * (_e1850 - (_e433 * _e1853))) + (_e1794 * (_e1851 - (_e469 * _e1853)))) / _e1823);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1941) & 2147483647u)) <= _e1755) {
                                                                                    phi_2639_ = (_e1853 + _e1941);
                                                                                } else {
                                                                                    phi_2639_ = _e1853;
                                                                                }
                                                                                let _e1948 = phi_2639_;
                                                                                phi_2640_ = _e1948;
                                                                            } else {
                                                                                phi_2640_ = _e1931;
                                                                            }
                                                                            let _e1950 = phi_2640_;
                                                                            let _e1952 = select(_e1688, _e1950, (_e1950 < _e1688));
                                                                            let _e1954 = select(_e1680, _e1952, (_e1952 > _e1680));
                                                                            if (_e1954 >= _e554) {
                                                                                let _e1956 = (_e1954 <= _e1106.member);
                                                                                if _e1956 {
                                                                                    let _e1957 = (1f / _e1607);
                                                                                    phi_2663_ = type_25(_e1954, (_e1601 * _e1957), (_e1605 * _e1957), _e1166);
                                                                                } else {
                                                                                    phi_2663_ = type_25();
                                                                                }
                                                                                let _e1962 = phi_2663_;
                                                                                phi_2665_ = _e1962;
                                                                                phi_2666_ = select(true, false, _e1956);
                                                                            } else {
                                                                                phi_2665_ = type_25();
                                                                                phi_2666_ = true;
                                                                            }
                                                                            let _e1965 = phi_2665_;
                                                                            let _e1967 = phi_2666_;
                                                                            if _e1967 {
                                                                                phi_2670_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2670_ = _e1965;
                                                                            }
                                                                            let _e1969 = phi_2670_;
                                                                            phi_2671_ = _e1969;
                                                                        }
                                                                        let _e1971 = phi_2671_;
                                                                        phi_2672_ = _e1971;
                                                                        phi_2673_ = _e1697;
                                                                    }
                                                                    let _e1973 = phi_2672_;
                                                                    let _e1975 = phi_2673_;
                                                                    phi_2677_ = _e1973;
                                                                    phi_2678_ = _e1975;
                                                                }
                                                                let _e1977 = phi_2677_;
                                                                let _e1979 = phi_2678_;
                                                                phi_2679_ = _e1977;
                                                                phi_2680_ = _e1632;
                                                                phi_2681_ = _e1979;
                                                            }
                                                            let _e1981 = phi_2679_;
                                                            let _e1983 = phi_2680_;
                                                            let _e1985 = phi_2681_;
                                                            phi_2682_ = _e1981;
                                                            phi_2683_ = _e1983;
                                                            phi_2684_ = _e1985;
                                                        }
                                                        let _e1987 = phi_2682_;
                                                        let _e1989 = phi_2683_;
                                                        let _e1991 = phi_2684_;
                                                        phi_2692_ = _e1987;
                                                        phi_2693_ = select(_e1991, true, _e1989);
                                                    } else {
                                                        phi_2692_ = type_25();
                                                        phi_2693_ = true;
                                                    }
                                                    let _e1994 = phi_2692_;
                                                    let _e1996 = phi_2693_;
                                                    if _e1996 {
                                                        phi_2697_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2697_ = _e1994;
                                                    }
                                                    let _e1998 = phi_2697_;
                                                    if (_e1998.member_3 != 4294967295u) {
                                                        if (_e1166 == _e171) {
                                                            phi_3026_ = false;
                                                        } else {
                                                            let _e2002 = (_e1166 < arrayLength((&global_6.member)));
                                                            if _e2002 {
                                                                if _e2002 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e2004 = global_6.member[_e1166];
                                                                phi_2720_ = _e2004;
                                                            } else {
                                                                phi_2720_ = 4294967295u;
                                                            }
                                                            let _e2006 = phi_2720_;
                                                            let _e2007 = (_e2006 < arrayLength((&global_7.member)));
                                                            if _e2007 {
                                                                if _e2007 {
                                                                } else {
                                                                    phi_4531_ = true;
                                                                    break;
                                                                }
                                                                let _e2009 = global_7.member[_e2006];
                                                                phi_2734_ = _e2009;
                                                            } else {
                                                                phi_2734_ = 0i;
                                                            }
                                                            let _e2011 = phi_2734_;
                                                            let _e2012 = (_e2011 == 0i);
                                                            if _e2012 {
                                                                phi_3025_ = true;
                                                            } else {
                                                                if _e400 {
                                                                    phi_2755_ = vec3<f32>(_e1535[0][0], _e1535[0][1], _e1535[0][2]);
                                                                } else {
                                                                    if (_e376 == 1u) {
                                                                        phi_2754_ = vec3<f32>(_e1535[0][2], _e1535[0][0], _e1535[0][1]);
                                                                    } else {
                                                                        phi_2754_ = vec3<f32>(_e1535[0][1], _e1535[0][2], _e1535[0][0]);
                                                                    }
                                                                    let _e2017 = phi_2754_;
                                                                    phi_2755_ = _e2017;
                                                                }
                                                                let _e2020 = phi_2755_;
                                                                if _e400 {
                                                                    phi_2772_ = vec3<f32>(_e1535[1][0], _e1535[1][1], _e1535[1][2]);
                                                                } else {
                                                                    if (_e376 == 1u) {
                                                                        phi_2771_ = vec3<f32>(_e1535[1][2], _e1535[1][0], _e1535[1][1]);
                                                                    } else {
                                                                        phi_2771_ = vec3<f32>(_e1535[1][1], _e1535[1][2], _e1535[1][0]);
                                                                    }
                                                                    let _e2025 = phi_2771_;
                                                                    phi_2772_ = _e2025;
                                                                }
                                                                let _e2028 = phi_2772_;
                                                                if _e400 {
                                                                    phi_2789_ = vec3<f32>(_e1535[2][0], _e1535[2][1], _e1535[2][2]);
                                                                } else {
                                                                    if (_e376 == 1u) {
                                                                        phi_2788_ = vec3<f32>(_e1535[2][2], _e1535[2][0], _e1535[2][1]);
                                                                    } else {
                                                                        phi_2788_ = vec3<f32>(_e1535[2][1], _e1535[2][2], _e1535[2][0]);
                                                                    }
                                                                    let _e2033 = phi_2788_;
                                                                    phi_2789_ = _e2033;
                                                                }
                                                                let _e2036 = phi_2789_;
                                                                let _e2039 = (_e2028.x - _e2020.x);
                                                                let _e2042 = (_e2028.y - _e2020.y);
                                                                let _e2045 = (_e2028.z - _e2020.z);
                                                                let _e2047 = (_e2036.x - _e2020.x);
                                                                let _e2049 = (_e2036.y - _e2020.y);
                                                                let _e2051 = (_e2036.z - _e2020.z);
                                                                if (_e243.member_1 == 1u) {
                                                                    phi_2825_ = (vec3<f32>(_e243.member[0], _e243.member[1], _e243.member[2]) - _e2020);
                                                                } else {
                                                                    phi_2825_ = vec3<f32>(_e243.member[0], _e243.member[1], _e243.member[2]);
                                                                }
                                                                let _e2066 = phi_2825_;
                                                                let _e2072 = bitcast<f32>((bitcast<u32>((_e2039 * _e2049)) ^ _e243.member_3[0]));
                                                                let _e2076 = bitcast<f32>((bitcast<u32>((_e2042 * _e2047)) ^ _e243.member_3[0]));
                                                                let _e2080 = bitcast<f32>((bitcast<u32>((_e2042 * _e2051)) ^ _e243.member_3[0]));
                                                                let _e2084 = bitcast<f32>((bitcast<u32>((_e2045 * _e2049)) ^ _e243.member_3[0]));
                                                                let _e2088 = bitcast<f32>((bitcast<u32>((_e2045 * _e2047)) ^ _e243.member_3[0]));
                                                                let _e2092 = bitcast<f32>((bitcast<u32>((_e2039 * _e2051)) ^ _e243.member_3[0]));
                                                                let _e2093 = (_e2080 - _e2084);
                                                                let _e2094 = (_e2088 - _e2092);
                                                                let _e2095 = (_e2072 - _e2076);
                                                                let _e2119 = (bitcast<f32>((bitcast<u32>(_e2080) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2084) & 2147483647u)));
                                                                let _e2126 = (bitcast<f32>((bitcast<u32>(_e2088) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2092) & 2147483647u)));
                                                                let _e2133 = (bitcast<f32>((bitcast<u32>(_e2072) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2076) & 2147483647u)));
                                                                if (_e243.member_2 == 0f) {
                                                                    phi_3007_ = 0f;
                                                                } else {
                                                                    let _e2163 = bitcast<f32>((bitcast<u32>(_e2093) & 2147483647u));
                                                                    let _e2166 = bitcast<f32>((bitcast<u32>(_e2094) & 2147483647u));
                                                                    let _e2169 = bitcast<f32>((bitcast<u32>(_e2095) & 2147483647u));
                                                                    let _e2171 = select(_e2169, _e2166, (_e2166 > _e2169));
                                                                    let _e2175 = select(_e2169, _e2166, (_e2166 < _e2169));
                                                                    let _e2179 = select(_e2166, _e2163, (_e2163 < _e2166));
                                                                    let _e2181 = select(_e2166, _e2163, (_e2163 > _e2166));
                                                                    let _e2183 = select(_e2169, _e2181, (_e2181 < _e2169));
                                                                    phi_3007_ = bitcast<f32>((bitcast<u32>((_e243.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2171, _e2163, (_e2163 > _e2171)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2183, _e2179, (_e2179 > _e2183)))) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2175, _e2163, (_e2163 < _e2175)))) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e2119 + _e2126) + _e2133))) ^ _e243.member_3[0]))) * 1.0000005f)) ^ _e243.member_3[0])))) ^ _e243.member_3[0]));
                                                                }
                                                                let _e2210 = phi_3007_;
                                                                phi_3025_ = (_e2012 || !(((((bitcast<f32>((bitcast<u32>((_e2066.x * _e2093)) ^ _e243.member_3[0])) + bitcast<f32>((bitcast<u32>((_e2066.y * _e2094)) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e2066.z * _e2095)) ^ _e243.member_3[0]))) * f32(-(_e2011))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2066.x) & 2147483647u)) * _e2119)) ^ _e243.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2066.y) & 2147483647u)) * _e2126)) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2066.z) & 2147483647u)) * _e2133)) ^ _e243.member_3[0]))))) ^ _e243.member_3[0])) + _e2210) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e2224 = phi_3025_;
                                                            phi_3026_ = _e2224;
                                                        }
                                                        let _e2226 = phi_3026_;
                                                        if _e2226 {
                                                            phi_3031_ = type_46(_e1106.member, true);
                                                        } else {
                                                            phi_3031_ = _e1106;
                                                        }
                                                        let _e2231 = phi_3031_;
                                                        phi_3032_ = _e2231;
                                                    } else {
                                                        phi_3032_ = _e1106;
                                                    }
                                                    let _e2233 = phi_3032_;
                                                    phi_1139_ = _e2233;
                                                } else {
                                                    phi_1139_ = type_46();
                                                }
                                                let _e2235 = phi_1139_;
                                                continue;
                                                continuing {
                                                    phi_1138_ = _e2235;
                                                    phi_1141_ = _e1121;
                                                    phi_4531_ = _e596;
                                                    break if !(_e1127);
                                                }
                                            }
                                            let _e2238 = phi_4531_;
                                            phi_4744_ = _e2238;
                                            if _e2238 {
                                                break;
                                            }
                                            let _e2240 = local_10;
                                            phi_4748_ = _e2238;
                                            let _e2480 = local_12;
                                            phi_4273_ = _e2480;
                                            phi_4274_ = _e637;
                                            phi_4275_ = false;
                                            phi_4276_ = select(_e641, 0u, _e2240.member_1);
                                        } else {
                                            if (_e637.member_1 >= _e103) {
                                                phi_3829_ = type_59(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_58(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_58(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e637.member_1 < _e103) {
                                                } else {
                                                    phi_4744_ = true;
                                                    break;
                                                }
                                                let _e654 = ((1u + _e376) % 4u);
                                                if (_e654 < 4u) {
                                                } else {
                                                    phi_4744_ = true;
                                                    break;
                                                }
                                                let _e659 = global_5.member[_e637.member_1][_e654];
                                                let _e661 = (_e659 >> bitcast<u32>(11u));
                                                let _e663 = ((1u + _e375) % 4u);
                                                if (_e663 < 4u) {
                                                } else {
                                                    phi_4744_ = true;
                                                    break;
                                                }
                                                let _e668 = global_5.member[_e637.member_1][_e663];
                                                let _e670 = (_e668 >> bitcast<u32>(11u));
                                                let _e672 = ((1u + _e377) % 4u);
                                                if (_e672 < 4u) {
                                                } else {
                                                    phi_4744_ = true;
                                                    break;
                                                }
                                                let _e677 = global_5.member[_e637.member_1][_e672];
                                                let _e679 = (_e677 >> bitcast<u32>(11u));
                                                let _e702 = (bitcast<f32>((bitcast<u32>((_e637.member.member_1.x - _e637.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e703 = (bitcast<f32>((bitcast<u32>((_e637.member.member_1.y - _e637.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e704 = (bitcast<f32>((bitcast<u32>((_e637.member.member_1.z - _e637.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e706 = select(_e162, _e702, (_e702 > _e162));
                                                let _e708 = select(_e162, _e703, (_e703 > _e162));
                                                let _e710 = select(_e162, _e704, (_e704 > _e162));
                                                let _e735 = bitcast<u32>((f32(bitcast<i32>((_e659 & 1023u))) * _e706));
                                                let _e740 = (bitcast<i32>((_e659 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e743 = bitcast<f32>((_e735 & bitcast<u32>(_e740)));
                                                let _e744 = bitcast<u32>((f32(bitcast<i32>((_e668 & 1023u))) * _e708));
                                                let _e749 = (bitcast<i32>((_e668 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e752 = bitcast<f32>((_e744 & bitcast<u32>(_e749)));
                                                let _e753 = bitcast<u32>((f32(bitcast<i32>((_e677 & 1023u))) * _e710));
                                                let _e758 = (bitcast<i32>((_e677 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e761 = bitcast<f32>((_e753 & bitcast<u32>(_e758)));
                                                let _e765 = bitcast<f32>((_e735 & bitcast<u32>(~(_e740))));
                                                let _e769 = bitcast<f32>((_e744 & bitcast<u32>(~(_e749))));
                                                let _e773 = bitcast<f32>((_e753 & bitcast<u32>(~(_e758))));
                                                let _e774 = bitcast<u32>((f32(bitcast<i32>((_e661 & 1023u))) * _e706));
                                                let _e779 = (bitcast<i32>((_e661 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e782 = bitcast<f32>((_e774 & bitcast<u32>(_e779)));
                                                let _e783 = bitcast<u32>((f32(bitcast<i32>((_e670 & 1023u))) * _e708));
                                                let _e788 = (bitcast<i32>((_e670 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e791 = bitcast<f32>((_e783 & bitcast<u32>(_e788)));
                                                let _e792 = bitcast<u32>((f32(bitcast<i32>((_e679 & 1023u))) * _e710));
                                                let _e797 = (bitcast<i32>((_e679 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e800 = bitcast<f32>((_e792 & bitcast<u32>(_e797)));
                                                let _e804 = bitcast<f32>((_e774 & bitcast<u32>(~(_e779))));
                                                let _e808 = bitcast<f32>((_e783 & bitcast<u32>(~(_e788))));
                                                let _e812 = bitcast<f32>((_e792 & bitcast<u32>(~(_e797))));
                                                let _e813 = (_e637.member.member.x + _e743);
                                                let _e814 = (_e637.member.member.y + _e752);
                                                let _e815 = (_e637.member.member.z + _e761);
                                                let _e818 = (_e637.member.member_1.x - _e782);
                                                let _e819 = (_e637.member.member_1.y - _e791);
                                                let _e820 = (_e637.member.member_1.z - _e800);
                                                let _e839 = (_e818 - _e813);
                                                let _e840 = (_e819 - _e814);
                                                let _e841 = (_e820 - _e815);
                                                let _e843 = select(_e840, _e839, (_e839 > _e840));
                                                let _e845 = select(_e841, _e843, (_e843 > _e841));
                                                if (_e845 < (1024f * _e162)) {
                                                    phi_3530_ = 0u;
                                                } else {
                                                    phi_3530_ = select(2u, 1u, (_e845 < (2097152f * _e162)));
                                                }
                                                let _e852 = phi_3530_;
                                                switch bitcast<i32>(_e852) {
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
                                                let _e855 = phi_3536_;
                                                let _e861 = global_5.member[_e637.member_1][0u];
                                                let _e865 = global_5.member[_e637.member_1][1u];
                                                let _e869 = global_5.member[_e637.member_1][2u];
                                                let _e873 = global_5.member[_e637.member_1][3u];
                                                let _e885 = (((_e865 >> bitcast<u32>(22i)) | ((_e869 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e873 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e886 = (_e861 & 268435455u);
                                                let _e887 = (_e885 & 268435455u);
                                                let _e890 = ((_e861 >> bitcast<u32>(28u)) & 7u);
                                                let _e898 = ((_e861 >> bitcast<u32>(31i)) | (((_e885 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e899 = (_e890 != 0u);
                                                if (_e890 == 0u) {
                                                    phi_3791_ = _e886;
                                                } else {
                                                    if (_e890 == 7u) {
                                                        phi_3790_ = 2147483648u;
                                                    } else {
                                                        phi_3790_ = ((2147483648u | (_e890 << bitcast<u32>(28u))) | (_e887 & 268435455u));
                                                    }
                                                    let _e908 = phi_3790_;
                                                    phi_3791_ = _e908;
                                                }
                                                let _e910 = phi_3791_;
                                                if _e899 {
                                                    let _e911 = (_e890 != 7u);
                                                    if _e911 {
                                                        phi_3801_ = (_e887 + (_e890 * ((3u * _e855) + 1u)));
                                                    } else {
                                                        phi_3801_ = u32();
                                                    }
                                                    let _e915 = phi_3801_;
                                                    phi_3803_ = _e915;
                                                    phi_3804_ = select(true, false, _e911);
                                                } else {
                                                    phi_3803_ = u32();
                                                    phi_3804_ = true;
                                                }
                                                let _e918 = phi_3803_;
                                                let _e920 = phi_3804_;
                                                if (_e898 == 0u) {
                                                    phi_3825_ = (_e886 + select(0u, 1u, !(_e899)));
                                                } else {
                                                    if (_e898 == 7u) {
                                                        phi_3824_ = 2147483648u;
                                                    } else {
                                                        phi_3824_ = ((2147483648u | (_e898 << bitcast<u32>(28u))) | (select(_e918, _e887, _e920) & 268435455u));
                                                    }
                                                    let _e933 = phi_3824_;
                                                    phi_3825_ = _e933;
                                                }
                                                let _e935 = phi_3825_;
                                                phi_3829_ = type_59(array<vec4<f32>, 3>(vec4<f32>(_e813, (_e637.member.member.x + _e765), _e818, (_e637.member.member_1.x - _e804)), vec4<f32>(_e814, (_e637.member.member.y + _e769), _e819, (_e637.member.member_1.y - _e808)), vec4<f32>(_e815, (_e637.member.member.z + _e773), _e820, (_e637.member.member_1.z - _e812))), type_58(type_34((_e637.member.member + vec4<f32>(_e743, _e752, _e761, 0f)), (_e637.member.member_1 - vec4<f32>(_e782, _e791, _e800, 0f))), _e910), type_58(type_34((_e637.member.member + vec4<f32>(_e765, _e769, _e773, 0f)), (_e637.member.member_1 - vec4<f32>(_e804, _e808, _e812, 0f))), _e935));
                                            }
                                            let _e940 = phi_3829_;
                                            let _e952 = ((_e940.member[0].x - _e431) * _e436);
                                            let _e953 = ((_e940.member[0].y - _e431) * _e436);
                                            let _e954 = ((_e940.member[0].z - _e432) * _e436);
                                            let _e955 = ((_e940.member[0].w - _e432) * _e436);
                                            let _e965 = ((_e940.member[1].x - _e467) * _e472);
                                            let _e966 = ((_e940.member[1].y - _e467) * _e472);
                                            let _e967 = ((_e940.member[1].z - _e468) * _e472);
                                            let _e968 = ((_e940.member[1].w - _e468) * _e472);
                                            let _e978 = ((_e940.member[2].x - _e503) * _e508);
                                            let _e979 = ((_e940.member[2].y - _e503) * _e508);
                                            let _e980 = ((_e940.member[2].z - _e504) * _e508);
                                            let _e981 = ((_e940.member[2].w - _e504) * _e508);
                                            let _e983 = select(_e980, _e978, (_e978 < _e980));
                                            let _e985 = select(_e981, _e979, (_e979 < _e981));
                                            let _e987 = select(_e980, _e978, (_e978 > _e980));
                                            let _e989 = select(_e981, _e979, (_e979 > _e981));
                                            let _e991 = select(_e954, _e952, (_e952 < _e954));
                                            let _e993 = select(_e955, _e953, (_e953 < _e955));
                                            let _e995 = select(_e967, _e965, (_e965 < _e967));
                                            let _e997 = select(_e968, _e966, (_e966 < _e968));
                                            let _e999 = select(_e995, _e991, (_e991 > _e995));
                                            let _e1001 = select(_e997, _e993, (_e993 > _e997));
                                            let _e1003 = select(_e983, _e999, (_e999 > _e983));
                                            let _e1005 = select(_e985, _e1001, (_e1001 > _e985));
                                            let _e1007 = select(_e954, _e952, (_e952 > _e954));
                                            let _e1009 = select(_e955, _e953, (_e953 > _e955));
                                            let _e1011 = select(_e967, _e965, (_e965 > _e967));
                                            let _e1013 = select(_e968, _e966, (_e966 > _e968));
                                            let _e1015 = select(_e1011, _e1007, (_e1007 < _e1011));
                                            let _e1017 = select(_e1013, _e1009, (_e1009 < _e1013));
                                            let _e1022 = -(_e983);
                                            let _e1023 = -(_e985);
                                            let _e1030 = (select(_e987, _e1015, (_e1015 < _e987)) + (select(_e1022, _e987, (_e987 > _e1022)) * 0.0000019073523f));
                                            let _e1031 = (select(_e989, _e1017, (_e1017 < _e989)) + (select(_e1023, _e989, (_e989 > _e1023)) * 0.0000019073523f));
                                            let _e1033 = select(_e554, _e1003, (_e1003 > _e554));
                                            let _e1035 = select(_e554, _e1005, (_e1005 > _e554));
                                            let _e1040 = (_e1033 <= select(_e598.member, _e1030, (_e1030 < _e598.member)));
                                            let _e1041 = (_e1035 <= select(_e598.member, _e1031, (_e1031 < _e598.member)));
                                            let _e1042 = (_e1033 <= _e1035);
                                            if _e1040 {
                                                if _e1041 {
                                                    if _e1042 {
                                                        phi_4173_ = _e940.member_2;
                                                    } else {
                                                        phi_4173_ = _e940.member_1;
                                                    }
                                                    let _e1046 = phi_4173_;
                                                    let _e1068 = (_e641 % 128u);
                                                    let _e1069 = (_e1068 < 128u);
                                                    if _e1069 {
                                                    } else {
                                                        phi_4744_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1068] = _e1046.member_1;
                                                    if _e1069 {
                                                    } else {
                                                        phi_4744_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1068] = _e1046.member.member.x;
                                                    if _e1069 {
                                                    } else {
                                                        phi_4744_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1068] = _e1046.member.member.y;
                                                    if _e1069 {
                                                    } else {
                                                        phi_4744_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1068] = _e1046.member.member.z;
                                                    if _e1069 {
                                                    } else {
                                                        phi_4744_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1068] = _e1046.member.member_1.x;
                                                    if _e1069 {
                                                    } else {
                                                        phi_4744_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1068] = _e1046.member.member_1.y;
                                                    if _e1069 {
                                                    } else {
                                                        phi_4744_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1068] = _e1046.member.member_1.z;
                                                    if _e1069 {
                                                    } else {
                                                        phi_4744_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1068] = select(_e1035, _e1033, (_e1033 > _e1035));
                                                    if _e1042 {
                                                        phi_4250_ = _e940.member_1;
                                                    } else {
                                                        phi_4250_ = _e940.member_2;
                                                    }
                                                    let _e1082 = phi_4250_;
                                                    phi_4251_ = _e1082;
                                                    phi_4252_ = (_e641 + 1u);
                                                } else {
                                                    phi_4251_ = type_58();
                                                    phi_4252_ = u32();
                                                }
                                                let _e1084 = phi_4251_;
                                                let _e1086 = phi_4252_;
                                                phi_4254_ = _e1084;
                                                phi_4255_ = _e1086;
                                                phi_4256_ = select(true, false, _e1041);
                                            } else {
                                                phi_4254_ = type_58();
                                                phi_4255_ = u32();
                                                phi_4256_ = true;
                                            }
                                            let _e1089 = phi_4254_;
                                            let _e1091 = phi_4255_;
                                            let _e1093 = phi_4256_;
                                            if _e1093 {
                                                if _e1040 {
                                                    phi_4265_ = _e940.member_1;
                                                } else {
                                                    phi_4265_ = _e940.member_2;
                                                }
                                                let _e1097 = phi_4265_;
                                                phi_4270_ = _e1097;
                                                phi_4271_ = select(_e1041, true, _e1040);
                                            } else {
                                                phi_4270_ = _e1089;
                                                phi_4271_ = _e639;
                                            }
                                            let _e1100 = phi_4270_;
                                            let _e1102 = phi_4271_;
                                            phi_4748_ = _e596;
                                            phi_4273_ = _e598;
                                            phi_4274_ = _e1100;
                                            phi_4275_ = _e1102;
                                            phi_4276_ = select(_e1091, _e641, _e1093);
                                        }
                                        let _e2244 = phi_4748_;
                                        let _e2246 = phi_4273_;
                                        let _e2248 = phi_4274_;
                                        let _e2250 = phi_4275_;
                                        let _e2252 = phi_4276_;
                                        phi_4747_ = _e2244;
                                        phi_4277_ = _e2246;
                                        phi_4278_ = _e2248;
                                        phi_4279_ = (_e602 - 1u);
                                        phi_4280_ = _e2250;
                                        phi_4281_ = _e2252;
                                    } else {
                                        phi_4747_ = _e596;
                                        phi_4277_ = _e598;
                                        phi_4278_ = _e637;
                                        phi_4279_ = _e602;
                                        phi_4280_ = _e639;
                                        phi_4281_ = _e641;
                                    }
                                    let _e2254 = phi_4747_;
                                    let _e2256 = phi_4277_;
                                    let _e2258 = phi_4278_;
                                    let _e2260 = phi_4279_;
                                    let _e2262 = phi_4280_;
                                    let _e2264 = phi_4281_;
                                    phi_4746_ = _e2254;
                                    phi_4282_ = _e2256;
                                    phi_4283_ = _e2258;
                                    phi_4284_ = _e2260;
                                    phi_4285_ = _e2262;
                                    phi_4286_ = _e2264;
                                } else {
                                    phi_4746_ = _e596;
                                    phi_4282_ = type_46();
                                    phi_4283_ = type_58();
                                    phi_4284_ = u32();
                                    phi_4285_ = bool();
                                    phi_4286_ = u32();
                                }
                                let _e2266 = phi_4746_;
                                let _e2268 = phi_4282_;
                                let _e2270 = phi_4283_;
                                let _e2272 = phi_4284_;
                                let _e2274 = phi_4285_;
                                let _e2276 = phi_4286_;
                                phi_4745_ = _e2266;
                                phi_1012_ = _e2268;
                                phi_1015_ = _e2270;
                                phi_1017_ = _e2272;
                                phi_1019_ = _e2274;
                                phi_1021_ = _e2276;
                                phi_4287_ = _e610;
                            } else {
                                phi_4745_ = _e596;
                                phi_1012_ = type_46();
                                phi_1015_ = type_58();
                                phi_1017_ = u32();
                                phi_1019_ = bool();
                                phi_1021_ = u32();
                                phi_4287_ = false;
                            }
                            let _e2278 = phi_4745_;
                            let _e2280 = phi_1012_;
                            let _e2282 = phi_1015_;
                            let _e2284 = phi_1017_;
                            let _e2286 = phi_1019_;
                            let _e2288 = phi_1021_;
                            let _e2290 = phi_4287_;
                            continue;
                            continuing {
                                phi_4537_ = _e2278;
                                phi_1011_ = _e2280;
                                phi_1014_ = _e2282;
                                phi_1016_ = _e2284;
                                phi_1018_ = _e2286;
                                phi_1020_ = _e2288;
                                phi_4744_ = _e2278;
                                break if !(_e2290);
                            }
                        }
                        let _e2293 = phi_4744_;
                        if _e2293 {
                            break;
                        }
                        let _e2295 = local_11;
                        if _e2295.member_1 {
                        } else {
                            if _e244 {
                            } else {
                                break;
                            }
                            let _e2299 = global_2.member[_e150];
                            if _e165 {
                            } else {
                                break;
                            }
                            let _e2303 = global_9.member[_e150].member_1;
                            if _e244 {
                            } else {
                                break;
                            }
                            global_2.member[_e150] = type_27(_e2299.member, _e2299.member_1, _e2299.member_2, array<f32, 3>((_e2299.member_3[0] + (_e2303[0] * _e2299.member_1[0])), (_e2299.member_3[1] + (_e2303[1] * _e2299.member_1[1])), (_e2299.member_3[2] + (_e2303[2] * _e2299.member_1[2]))), _e2299.member_4);
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
