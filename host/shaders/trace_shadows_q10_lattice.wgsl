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
    var phi_334_: u32;
    var phi_378_: i32;
    var phi_402_: type_40;
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
    var phi_1010_: type_46;
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
    var phi_1137_: type_46;
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
    var phi_2665_: type_25;
    var phi_2667_: type_25;
    var phi_2668_: bool;
    var phi_2672_: type_25;
    var phi_2673_: type_25;
    var phi_2674_: type_25;
    var phi_2675_: bool;
    var phi_2679_: type_25;
    var phi_2680_: bool;
    var phi_2681_: type_25;
    var phi_2682_: bool;
    var phi_2683_: bool;
    var phi_2684_: type_25;
    var phi_2685_: bool;
    var phi_2686_: bool;
    var phi_2694_: type_25;
    var phi_2695_: bool;
    var phi_2699_: type_25;
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
    var phi_3033_: type_46;
    var phi_3034_: type_46;
    var phi_1138_: type_46;
    var phi_4533_: bool;
    var local_10: type_46;
    var phi_4750_: bool;
    var phi_4275_: type_46;
    var phi_4276_: type_58;
    var phi_4277_: bool;
    var phi_4278_: u32;
    var phi_4749_: bool;
    var phi_4279_: type_46;
    var phi_4280_: type_58;
    var phi_4281_: u32;
    var phi_4282_: bool;
    var phi_4283_: u32;
    var phi_4748_: bool;
    var phi_4284_: type_46;
    var phi_4285_: type_58;
    var phi_4286_: u32;
    var phi_4287_: bool;
    var phi_4288_: u32;
    var phi_4747_: bool;
    var phi_1011_: type_46;
    var phi_1014_: type_58;
    var phi_1016_: u32;
    var phi_1018_: bool;
    var phi_1020_: u32;
    var phi_4289_: bool;
    var phi_4746_: bool;
    var local_11: type_46;
    var local_12: type_46;

    switch bitcast<i32>(0u) {
        default: {
            let _e100 = global;
            let _e102 = arrayLength((&global_5.member));
            let _e105 = arrayLength((&global_10.member));
            let _e117 = arrayLength((&global_8.member));
            let _e121 = global_4.member[0u][0u];
            let _e125 = global_4.member[0u][1u];
            let _e129 = global_4.member[0u][2u];
            let _e133 = global_4.member[0u][3u];
            let _e137 = global_4.member[1u][0u];
            let _e141 = global_4.member[1u][1u];
            let _e145 = global_4.member[1u][2u];
            let _e149 = (_e100.x + (_e100.y * 2097152u));
            let _e161 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e133) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e121), bitcast<i32>(_e125), bitcast<i32>(_e129));
            local = array<i32, 3>(bitcast<i32>(_e137), bitcast<i32>(_e141), bitcast<i32>(_e145));
            let _e164 = (_e149 < arrayLength((&global_9.member)));
            if _e164 {
                if _e164 {
                } else {
                    break;
                }
                let _e168 = global_9.member[_e149].member_2;
                phi_334_ = _e168;
            } else {
                phi_334_ = 4294967295u;
            }
            let _e170 = phi_334_;
            let _e173 = global_1.member[0u];
            let _e177 = global_3.member[0u][0u];
            let _e181 = global_3.member[0u][1u];
            let _e185 = global_3.member[0u][2u];
            let _e189 = global_3.member[0u][3u];
            let _e193 = global_3.member[1u][0u];
            let _e197 = global_3.member[1u][1u];
            let _e201 = global_3.member[1u][2u];
            let _e205 = global_3.member[1u][3u];
            let _e206 = bitcast<f32>(_e177);
            let _e207 = bitcast<f32>(_e181);
            let _e208 = bitcast<f32>(_e185);
            let _e210 = bitcast<f32>(_e193);
            let _e211 = array<u32, 3>(_e197, _e201, _e205);
            let _e213 = bitcast<i32>(_e173);
            if (_e213 < -126i) {
                phi_378_ = -126i;
            } else {
                phi_378_ = select(_e213, 127i, (_e213 > 127i));
            }
            let _e218 = phi_378_;
            let _e223 = bitcast<f32>((bitcast<u32>((_e218 + 127i)) << bitcast<u32>(23i)));
            let _e229 = bitcast<f32>((bitcast<u32>(((_e213 - _e218) + 127i)) << bitcast<u32>(23i)));
            if (_e189 == 0u) {
                phi_402_ = type_40(array<f32, 3>(_e206, _e207, _e208), _e189, _e210, _e211);
            } else {
                phi_402_ = type_40(array<f32, 3>(((_e206 * _e223) * _e229), ((_e207 * _e223) * _e229), ((_e208 * _e223) * _e229)), _e189, ((_e210 * _e223) * _e229), _e211);
            }
            let _e242 = phi_402_;
            if _e164 {
                let _e243 = (_e149 < arrayLength((&global_2.member)));
                if _e243 {
                    if _e164 {
                    } else {
                        break;
                    }
                    let _e248 = global_9.member[_e149].member.member_1;
                    let _e253 = global_9.member[_e149].member.member_3;
                    if (_e248 <= _e253) {
                        let _e255 = (1u < _e117);
                        if _e255 {
                            if (0u < _e117) {
                            } else {
                                break;
                            }
                            let _e259 = atomicAdd((&global_8.member[0u]), 1u);
                            if ((_e259 + 1u) < _e259) {
                                if _e255 {
                                } else {
                                    break;
                                }
                                let _e264 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                        if _e164 {
                        } else {
                            break;
                        }
                        let _e274 = global_9.member[_e149].member.member_2[0u];
                        let _e276 = (bitcast<u32>(_e274) & 2147483647u);
                        let _e282 = global_9.member[_e149].member.member_2[1u];
                        let _e284 = (bitcast<u32>(_e282) & 2147483647u);
                        let _e290 = global_9.member[_e149].member.member_2[2u];
                        let _e292 = (bitcast<u32>(_e290) & 2147483647u);
                        let _e298 = global_9.member[_e149].member.member[0u];
                        let _e300 = (bitcast<u32>(_e298) & 2147483647u);
                        let _e306 = global_9.member[_e149].member.member[1u];
                        let _e308 = (bitcast<u32>(_e306) & 2147483647u);
                        let _e314 = global_9.member[_e149].member.member[2u];
                        let _e316 = (bitcast<u32>(_e314) & 2147483647u);
                        let _e318 = select(_e284, _e276, (_e284 < _e276));
                        let _e320 = select(_e292, _e318, (_e292 < _e318));
                        let _e322 = select(_e300, _e320, (_e300 < _e320));
                        let _e324 = select(_e308, _e322, (_e308 < _e322));
                        let _e326 = select(_e316, _e324, (_e316 < _e324));
                        let _e328 = (bitcast<u32>(_e248) & 2147483647u);
                        let _e337 = (((select(_e328, _e326, (_e328 < _e326)) < 2139095040u) && ((bitcast<u32>(_e253) & 2147483647u) <= 2139095040u)) && (_e320 > 0u));
                        if _e337 {
                            let _e340 = (bitcast<u32>(bitcast<f32>(_e320)) & 2147483647u);
                            if (_e340 >= 8388608u) {
                                phi_552_ = (bitcast<i32>((_e340 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_552_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e340)), 32u, (_e340 == 0u))));
                            }
                            let _e354 = phi_552_;
                            phi_553_ = _e354;
                        } else {
                            phi_553_ = 0i;
                        }
                        let _e356 = phi_553_;
                        let _e357 = (_e276 == _e320);
                        if _e357 {
                            phi_563_ = true;
                        } else {
                            phi_563_ = (_e284 == _e320);
                        }
                        let _e360 = phi_563_;
                        let _e361 = select(1u, 0u, _e357);
                        if _e360 {
                            let _e362 = (_e361 + 1u);
                            phi_573_ = _e362;
                            phi_574_ = _e362;
                            phi_576_ = select(true, false, (_e362 == 2u));
                        } else {
                            phi_573_ = u32();
                            phi_574_ = 0u;
                            phi_576_ = true;
                        }
                        let _e366 = phi_573_;
                        let _e368 = phi_574_;
                        let _e370 = phi_576_;
                        if _e370 {
                            phi_581_ = (_e368 + 1u);
                        } else {
                            phi_581_ = 0u;
                        }
                        let _e374 = phi_581_;
                        let _e375 = select(_e366, _e368, _e370);
                        let _e376 = select(_e361, select(2u, _e361, _e360), _e370);
                        let _e377 = -(_e356);
                        if (_e377 < -126i) {
                            phi_613_ = -126i;
                        } else {
                            phi_613_ = select(_e377, 127i, (_e377 > 127i));
                        }
                        let _e382 = phi_613_;
                        let _e387 = bitcast<f32>((bitcast<u32>((_e382 + 127i)) << bitcast<u32>(23i)));
                        let _e393 = bitcast<f32>((bitcast<u32>(((_e377 - _e382) + 127i)) << bitcast<u32>(23i)));
                        let _e398 = global_9.member[_e149].member.member;
                        let _e399 = (_e375 == 0u);
                        if _e399 {
                            phi_631_ = _e398[0];
                        } else {
                            phi_631_ = _e398[1];
                        }
                        let _e403 = phi_631_;
                        let _e404 = (_e375 == 2u);
                        if _e404 {
                            phi_637_ = _e398[2];
                        } else {
                            phi_637_ = _e403;
                        }
                        let _e407 = phi_637_;
                        let _e408 = global_9.member[_e149].member.member_2;
                        if _e399 {
                            phi_648_ = _e408[0];
                        } else {
                            phi_648_ = _e408[1];
                        }
                        let _e412 = phi_648_;
                        if _e404 {
                            phi_654_ = _e408[2];
                        } else {
                            phi_654_ = _e412;
                        }
                        let _e415 = phi_654_;
                        let _e417 = ((_e415 * _e387) * _e393);
                        let _e421 = (bitcast<f32>((bitcast<u32>(_e417) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e421 {
                            let _e425 = (bitcast<f32>((bitcast<u32>(_e407) & 2147483647u)) * 0.00000011920929f);
                            phi_677_ = select(0.00000000000011368684f, _e425, (_e425 > 0.00000000000011368684f));
                        } else {
                            phi_677_ = 0f;
                        }
                        let _e429 = phi_677_;
                        let _e430 = (_e407 + _e429);
                        let _e431 = (_e407 - _e429);
                        let _e432 = select(_e417, 0f, _e421);
                        if _e421 {
                            phi_688_ = 38685626000000000000000000f;
                        } else {
                            phi_688_ = (1f / _e417);
                        }
                        let _e435 = phi_688_;
                        let _e436 = (_e374 == 0u);
                        if _e436 {
                            phi_697_ = _e398[0];
                        } else {
                            phi_697_ = _e398[1];
                        }
                        let _e440 = phi_697_;
                        let _e441 = (_e374 == 2u);
                        if _e441 {
                            phi_703_ = _e398[2];
                        } else {
                            phi_703_ = _e440;
                        }
                        let _e444 = phi_703_;
                        if _e436 {
                            phi_714_ = _e408[0];
                        } else {
                            phi_714_ = _e408[1];
                        }
                        let _e448 = phi_714_;
                        if _e441 {
                            phi_720_ = _e408[2];
                        } else {
                            phi_720_ = _e448;
                        }
                        let _e451 = phi_720_;
                        let _e453 = ((_e451 * _e387) * _e393);
                        let _e457 = (bitcast<f32>((bitcast<u32>(_e453) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e457 {
                            let _e461 = (bitcast<f32>((bitcast<u32>(_e444) & 2147483647u)) * 0.00000011920929f);
                            phi_743_ = select(0.00000000000011368684f, _e461, (_e461 > 0.00000000000011368684f));
                        } else {
                            phi_743_ = 0f;
                        }
                        let _e465 = phi_743_;
                        let _e466 = (_e444 + _e465);
                        let _e467 = (_e444 - _e465);
                        let _e468 = select(_e453, 0f, _e457);
                        if _e457 {
                            phi_754_ = 38685626000000000000000000f;
                        } else {
                            phi_754_ = (1f / _e453);
                        }
                        let _e471 = phi_754_;
                        let _e472 = (_e376 == 0u);
                        if _e472 {
                            phi_763_ = _e398[0];
                        } else {
                            phi_763_ = _e398[1];
                        }
                        let _e476 = phi_763_;
                        let _e477 = (_e376 == 2u);
                        if _e477 {
                            phi_769_ = _e398[2];
                        } else {
                            phi_769_ = _e476;
                        }
                        let _e480 = phi_769_;
                        if _e472 {
                            phi_780_ = _e408[0];
                        } else {
                            phi_780_ = _e408[1];
                        }
                        let _e484 = phi_780_;
                        if _e477 {
                            phi_786_ = _e408[2];
                        } else {
                            phi_786_ = _e484;
                        }
                        let _e487 = phi_786_;
                        let _e489 = ((_e487 * _e387) * _e393);
                        let _e493 = (bitcast<f32>((bitcast<u32>(_e489) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e493 {
                            let _e497 = (bitcast<f32>((bitcast<u32>(_e480) & 2147483647u)) * 0.00000011920929f);
                            phi_809_ = select(0.00000000000011368684f, _e497, (_e497 > 0.00000000000011368684f));
                        } else {
                            phi_809_ = 0f;
                        }
                        let _e501 = phi_809_;
                        let _e502 = (_e480 + _e501);
                        let _e503 = (_e480 - _e501);
                        let _e504 = select(_e489, 0f, _e493);
                        if _e493 {
                            phi_820_ = 38685626000000000000000000f;
                        } else {
                            phi_820_ = (1f / _e489);
                        }
                        let _e507 = phi_820_;
                        let _e510 = bitcast<f32>((bitcast<u32>(_e407) & 2147483647u));
                        let _e513 = bitcast<f32>((bitcast<u32>(_e444) & 2147483647u));
                        let _e515 = select(_e513, _e510, (_e510 > _e513));
                        let _e518 = bitcast<f32>((bitcast<u32>(_e480) & 2147483647u));
                        if (_e337 && (select(_e518, _e515, (_e515 > _e518)) <= 1099511600000f)) {
                            let _e523 = (_e356 / 3i);
                            let _e530 = bitcast<f32>((bitcast<u32>((_e523 + 127i)) << bitcast<u32>(23i)));
                            let _e537 = bitcast<f32>((bitcast<u32>(((_e356 - (2i * _e523)) + 127i)) << bitcast<u32>(23i)));
                            let _e538 = (((_e248 * _e530) * _e530) * _e537);
                            let _e540 = select(340282350000000000000000000000000000000f, _e538, (_e538 < 340282350000000000000000000000000000000f));
                            let _e545 = (((_e253 * _e530) * _e530) * _e537);
                            let _e547 = select(340282350000000000000000000000000000000f, _e545, (_e545 < 340282350000000000000000000000000000000f));
                            phi_920_ = select(-340282350000000000000000000000000000000f, _e547, (_e547 > -340282350000000000000000000000000000000f));
                            phi_921_ = select(-340282350000000000000000000000000000000f, _e540, (_e540 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_920_ = 0f;
                            phi_921_ = 1f;
                        }
                        let _e551 = phi_920_;
                        let _e553 = phi_921_;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e557 = (_e375 % 3u);
                        let _e558 = (_e557 < 3u);
                        if _e558 {
                        } else {
                            break;
                        }
                        let _e560 = local_1[_e557];
                        let _e563 = (_e374 % 3u);
                        let _e564 = (_e563 < 3u);
                        if _e564 {
                        } else {
                            break;
                        }
                        let _e566 = local_1[_e563];
                        let _e569 = (_e376 % 3u);
                        let _e570 = (_e569 < 3u);
                        if _e570 {
                        } else {
                            break;
                        }
                        let _e572 = local_1[_e569];
                        if _e558 {
                        } else {
                            break;
                        }
                        let _e577 = local[_e557];
                        if _e564 {
                        } else {
                            break;
                        }
                        let _e581 = local[_e563];
                        if _e570 {
                        } else {
                            break;
                        }
                        let _e585 = local[_e569];
                        phi_4539_ = false;
                        phi_1010_ = type_46(_e551, false);
                        phi_1013_ = type_58(type_34(vec4<f32>((f32(_e560) * _e161), (f32(_e566) * _e161), (f32(_e572) * _e161), 0f), vec4<f32>((f32(_e577) * _e161), (f32(_e581) * _e161), (f32(_e585) * _e161), 0f)), select(0u, 2147483648u, (_e102 == 0u)));
                        phi_1015_ = ((3u * _e102) + 1u);
                        phi_1017_ = (_e553 <= _e551);
                        phi_1019_ = 0u;
                        loop {
                            let _e595 = phi_4539_;
                            let _e597 = phi_1010_;
                            let _e599 = phi_1013_;
                            let _e601 = phi_1015_;
                            let _e603 = phi_1017_;
                            let _e605 = phi_1019_;
                            local_11 = _e597;
                            if _e603 {
                                phi_1030_ = true;
                            } else {
                                phi_1030_ = (_e605 > 0u);
                            }
                            let _e608 = phi_1030_;
                            if _e608 {
                                let _e609 = (_e601 > 0u);
                                if _e609 {
                                    if _e603 {
                                        phi_1116_ = _e599;
                                        phi_1117_ = _e603;
                                        phi_1118_ = _e605;
                                    } else {
                                        let _e610 = (_e605 - 1u);
                                        let _e611 = (_e610 % 128u);
                                        let _e612 = (_e611 < 128u);
                                        if _e612 {
                                        } else {
                                            phi_4746_ = true;
                                            break;
                                        }
                                        let _e614 = local_7[_e611];
                                        if _e612 {
                                        } else {
                                            phi_4746_ = true;
                                            break;
                                        }
                                        let _e616 = local_6[_e611];
                                        if _e612 {
                                        } else {
                                            phi_4746_ = true;
                                            break;
                                        }
                                        let _e618 = local_5[_e611];
                                        if _e612 {
                                        } else {
                                            phi_4746_ = true;
                                            break;
                                        }
                                        let _e620 = local_4[_e611];
                                        if _e612 {
                                        } else {
                                            phi_4746_ = true;
                                            break;
                                        }
                                        let _e622 = local_3[_e611];
                                        if _e612 {
                                        } else {
                                            phi_4746_ = true;
                                            break;
                                        }
                                        let _e624 = local_2[_e611];
                                        if _e612 {
                                        } else {
                                            phi_4746_ = true;
                                            break;
                                        }
                                        let _e629 = local_8[_e611];
                                        if _e612 {
                                        } else {
                                            phi_4746_ = true;
                                            break;
                                        }
                                        let _e632 = local_9[_e611];
                                        phi_1116_ = type_58(type_34(vec4<f32>(_e614, _e616, _e618, 0f), vec4<f32>(_e620, _e622, _e624, 0f)), _e629);
                                        phi_1117_ = (_e632 <= _e597.member);
                                        phi_1118_ = _e610;
                                    }
                                    let _e636 = phi_1116_;
                                    let _e638 = phi_1117_;
                                    let _e640 = phi_1118_;
                                    if _e638 {
                                        let _e645 = (_e636.member_1 & 268435455u);
                                        if ((_e636.member_1 & 2147483648u) != 0u) {
                                            phi_1137_ = _e597;
                                            phi_1140_ = type_8(0u, ((_e636.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1105 = phi_1137_;
                                                let _e1107 = phi_1140_;
                                                local_10 = _e1105;
                                                local_12 = _e1105;
                                                if (_e1107.member < _e1107.member_1) {
                                                    phi_1141_ = type_8((_e1107.member + 1u), _e1107.member_1);
                                                    phi_1163_ = type_8(1u, _e1107.member);
                                                } else {
                                                    phi_1141_ = _e1107;
                                                    phi_1163_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1120 = phi_1141_;
                                                let _e1122 = phi_1163_;
                                                let _e1126 = (bitcast<i32>(_e1122.member) != 0i);
                                                if _e1126 {
                                                    let _e1131 = (_e636.member.member_1.x - _e636.member.member.x);
                                                    let _e1134 = (_e636.member.member_1.y - _e636.member.member.y);
                                                    let _e1137 = (_e636.member.member_1.z - _e636.member.member.z);
                                                    let _e1139 = select(_e1134, _e1131, (_e1131 > _e1134));
                                                    let _e1141 = select(_e1137, _e1139, (_e1139 > _e1137));
                                                    let _e1143 = (_e1141 < (1024f * _e161));
                                                    if _e1143 {
                                                        phi_1204_ = 0u;
                                                    } else {
                                                        phi_1204_ = select(2u, 1u, (_e1141 < (2097152f * _e161)));
                                                    }
                                                    let _e1148 = phi_1204_;
                                                    switch bitcast<i32>(_e1148) {
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
                                                    let _e1151 = phi_1210_;
                                                    switch bitcast<i32>(_e1148) {
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
                                                    let _e1158 = phi_1220_;
                                                    let _e1160 = ((_e645 + (_e1122.member_1 * ((3u * _e1151) + 1u))) + (3u * _e1158));
                                                    let _e1161 = (_e1160 < _e105);
                                                    if _e1161 {
                                                        if _e1161 {
                                                        } else {
                                                            phi_4533_ = true;
                                                            break;
                                                        }
                                                        let _e1163 = global_10.member[_e1160];
                                                        phi_1236_ = _e1163;
                                                    } else {
                                                        phi_1236_ = 4294967295u;
                                                    }
                                                    let _e1165 = phi_1236_;
                                                    if _e1143 {
                                                        phi_1269_ = 0u;
                                                    } else {
                                                        phi_1269_ = select(2u, 1u, (_e1141 < (2097152f * _e161)));
                                                    }
                                                    let _e1170 = phi_1269_;
                                                    switch bitcast<i32>(_e1170) {
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
                                                    let _e1173 = phi_1275_;
                                                    let _e1177 = (_e645 + (_e1122.member_1 * ((3u * _e1173) + 1u)));
                                                    switch bitcast<i32>(_e1170) {
                                                        case 0: {
                                                            let _e1443 = (_e1177 < _e105);
                                                            if _e1443 {
                                                                if _e1443 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e1445 = global_10.member[_e1177];
                                                                phi_1299_ = _e1445;
                                                            } else {
                                                                phi_1299_ = 0u;
                                                            }
                                                            let _e1447 = phi_1299_;
                                                            let _e1449 = ((10u * _e375) & 31u);
                                                            let _e1458 = ((10u * _e374) & 31u);
                                                            let _e1467 = ((10u * _e376) & 31u);
                                                            let _e1476 = (_e1177 + 1u);
                                                            let _e1477 = (_e1476 < _e105);
                                                            if _e1477 {
                                                                if _e1477 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e1479 = global_10.member[_e1476];
                                                                phi_1342_ = _e1479;
                                                            } else {
                                                                phi_1342_ = 0u;
                                                            }
                                                            let _e1481 = phi_1342_;
                                                            let _e1504 = (_e1177 + 2u);
                                                            let _e1505 = (_e1504 < _e105);
                                                            if _e1505 {
                                                                if _e1505 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e1507 = global_10.member[_e1504];
                                                                phi_1385_ = _e1507;
                                                            } else {
                                                                phi_1385_ = 0u;
                                                            }
                                                            let _e1509 = phi_1385_;
                                                            phi_1856_ = array<array<f32, 3>, 3>(array<f32, 3>((_e636.member.member.x + (f32(bitcast<i32>(((_e1447 >> bitcast<u32>(_e1449)) & 1023u))) * _e161)), (_e636.member.member.y + (f32(bitcast<i32>(((_e1447 >> bitcast<u32>(_e1458)) & 1023u))) * _e161)), (_e636.member.member.z + (f32(bitcast<i32>(((_e1447 >> bitcast<u32>(_e1467)) & 1023u))) * _e161))), array<f32, 3>((_e636.member.member.x + (f32(bitcast<i32>(((_e1481 >> bitcast<u32>(_e1449)) & 1023u))) * _e161)), (_e636.member.member.y + (f32(bitcast<i32>(((_e1481 >> bitcast<u32>(_e1458)) & 1023u))) * _e161)), (_e636.member.member.z + (f32(bitcast<i32>(((_e1481 >> bitcast<u32>(_e1467)) & 1023u))) * _e161))), array<f32, 3>((_e636.member.member.x + (f32(bitcast<i32>(((_e1509 >> bitcast<u32>(_e1449)) & 1023u))) * _e161)), (_e636.member.member.y + (f32(bitcast<i32>(((_e1509 >> bitcast<u32>(_e1458)) & 1023u))) * _e161)), (_e636.member.member.z + (f32(bitcast<i32>(((_e1509 >> bitcast<u32>(_e1467)) & 1023u))) * _e161))));
                                                            break;
                                                        }
                                                        case 1: {
                                                            let _e1266 = (_e1177 < _e105);
                                                            if _e1266 {
                                                                if _e1266 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e1268 = global_10.member[_e1177];
                                                                phi_1428_ = _e1268;
                                                            } else {
                                                                phi_1428_ = 0u;
                                                            }
                                                            let _e1270 = phi_1428_;
                                                            let _e1271 = (_e1177 + 1u);
                                                            let _e1272 = (_e1271 < _e105);
                                                            if _e1272 {
                                                                if _e1272 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e1274 = global_10.member[_e1271];
                                                                phi_1443_ = _e1274;
                                                            } else {
                                                                phi_1443_ = 0u;
                                                            }
                                                            let _e1276 = phi_1443_;
                                                            let _e1277 = (_e375 == 1u);
                                                            if _e1277 {
                                                                phi_1453_ = ((_e1270 >> bitcast<u32>(21i)) | (_e1276 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1453_ = (_e1276 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1286 = phi_1453_;
                                                            let _e1293 = (_e374 == 1u);
                                                            if _e1293 {
                                                                phi_1473_ = ((_e1270 >> bitcast<u32>(21i)) | (_e1276 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1473_ = (_e1276 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1302 = phi_1473_;
                                                            let _e1309 = (_e376 == 1u);
                                                            if _e1309 {
                                                                phi_1493_ = ((_e1270 >> bitcast<u32>(21i)) | (_e1276 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1493_ = (_e1276 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1318 = phi_1493_;
                                                            let _e1326 = (_e1177 + 2u);
                                                            let _e1327 = (_e1326 < _e105);
                                                            if _e1327 {
                                                                if _e1327 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e1329 = global_10.member[_e1326];
                                                                phi_1519_ = _e1329;
                                                            } else {
                                                                phi_1519_ = 0u;
                                                            }
                                                            let _e1331 = phi_1519_;
                                                            let _e1332 = (_e1177 + 3u);
                                                            let _e1333 = (_e1332 < _e105);
                                                            if _e1333 {
                                                                if _e1333 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e1335 = global_10.member[_e1332];
                                                                phi_1534_ = _e1335;
                                                            } else {
                                                                phi_1534_ = 0u;
                                                            }
                                                            let _e1337 = phi_1534_;
                                                            if _e1277 {
                                                                phi_1544_ = ((_e1331 >> bitcast<u32>(21i)) | (_e1337 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1544_ = (_e1337 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1346 = phi_1544_;
                                                            if _e1293 {
                                                                phi_1564_ = ((_e1331 >> bitcast<u32>(21i)) | (_e1337 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1564_ = (_e1337 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1361 = phi_1564_;
                                                            if _e1309 {
                                                                phi_1584_ = ((_e1331 >> bitcast<u32>(21i)) | (_e1337 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1584_ = (_e1337 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1376 = phi_1584_;
                                                            let _e1384 = (_e1177 + 4u);
                                                            let _e1385 = (_e1384 < _e105);
                                                            if _e1385 {
                                                                if _e1385 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e1387 = global_10.member[_e1384];
                                                                phi_1610_ = _e1387;
                                                            } else {
                                                                phi_1610_ = 0u;
                                                            }
                                                            let _e1389 = phi_1610_;
                                                            let _e1390 = (_e1177 + 5u);
                                                            let _e1391 = (_e1390 < _e105);
                                                            if _e1391 {
                                                                if _e1391 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e1393 = global_10.member[_e1390];
                                                                phi_1625_ = _e1393;
                                                            } else {
                                                                phi_1625_ = 0u;
                                                            }
                                                            let _e1395 = phi_1625_;
                                                            if _e1277 {
                                                                phi_1635_ = ((_e1389 >> bitcast<u32>(21i)) | (_e1395 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1635_ = (_e1395 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1404 = phi_1635_;
                                                            if _e1293 {
                                                                phi_1655_ = ((_e1389 >> bitcast<u32>(21i)) | (_e1395 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1655_ = (_e1395 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1419 = phi_1655_;
                                                            if _e1309 {
                                                                phi_1675_ = ((_e1389 >> bitcast<u32>(21i)) | (_e1395 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1675_ = (_e1395 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1434 = phi_1675_;
                                                            phi_1856_ = array<array<f32, 3>, 3>(array<f32, 3>((_e636.member.member.x + (f32(bitcast<i32>((select(_e1286, _e1270, _e399) & 2097151u))) * _e161)), (_e636.member.member.y + (f32(bitcast<i32>((select(_e1302, _e1270, _e436) & 2097151u))) * _e161)), (_e636.member.member.z + (f32(bitcast<i32>((select(_e1318, _e1270, _e472) & 2097151u))) * _e161))), array<f32, 3>((_e636.member.member.x + (f32(bitcast<i32>((select(_e1346, _e1331, _e399) & 2097151u))) * _e161)), (_e636.member.member.y + (f32(bitcast<i32>((select(_e1361, _e1331, _e436) & 2097151u))) * _e161)), (_e636.member.member.z + (f32(bitcast<i32>((select(_e1376, _e1331, _e472) & 2097151u))) * _e161))), array<f32, 3>((_e636.member.member.x + (f32(bitcast<i32>((select(_e1404, _e1389, _e399) & 2097151u))) * _e161)), (_e636.member.member.y + (f32(bitcast<i32>((select(_e1419, _e1389, _e436) & 2097151u))) * _e161)), (_e636.member.member.z + (f32(bitcast<i32>((select(_e1434, _e1389, _e472) & 2097151u))) * _e161))));
                                                            break;
                                                        }
                                                        case 2: {
                                                            let _e1179 = (_e1177 + _e375);
                                                            let _e1180 = (_e1179 < _e105);
                                                            if _e1180 {
                                                                if _e1180 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e1182 = global_10.member[_e1179];
                                                                phi_1702_ = _e1182;
                                                            } else {
                                                                phi_1702_ = 0u;
                                                            }
                                                            let _e1184 = phi_1702_;
                                                            let _e1188 = (_e1177 + _e374);
                                                            let _e1189 = (_e1188 < _e105);
                                                            if _e1189 {
                                                                if _e1189 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e1191 = global_10.member[_e1188];
                                                                phi_1720_ = _e1191;
                                                            } else {
                                                                phi_1720_ = 0u;
                                                            }
                                                            let _e1193 = phi_1720_;
                                                            let _e1197 = (_e1177 + _e376);
                                                            let _e1198 = (_e1197 < _e105);
                                                            if _e1198 {
                                                                if _e1198 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e1200 = global_10.member[_e1197];
                                                                phi_1738_ = _e1200;
                                                            } else {
                                                                phi_1738_ = 0u;
                                                            }
                                                            let _e1202 = phi_1738_;
                                                            let _e1207 = (_e1177 + 3u);
                                                            let _e1208 = (_e1207 + _e375);
                                                            let _e1209 = (_e1208 < _e105);
                                                            if _e1209 {
                                                                if _e1209 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e1211 = global_10.member[_e1208];
                                                                phi_1758_ = _e1211;
                                                            } else {
                                                                phi_1758_ = 0u;
                                                            }
                                                            let _e1213 = phi_1758_;
                                                            let _e1217 = (_e1207 + _e374);
                                                            let _e1218 = (_e1217 < _e105);
                                                            if _e1218 {
                                                                if _e1218 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e1220 = global_10.member[_e1217];
                                                                phi_1776_ = _e1220;
                                                            } else {
                                                                phi_1776_ = 0u;
                                                            }
                                                            let _e1222 = phi_1776_;
                                                            let _e1226 = (_e1207 + _e376);
                                                            let _e1227 = (_e1226 < _e105);
                                                            if _e1227 {
                                                                if _e1227 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e1229 = global_10.member[_e1226];
                                                                phi_1794_ = _e1229;
                                                            } else {
                                                                phi_1794_ = 0u;
                                                            }
                                                            let _e1231 = phi_1794_;
                                                            let _e1236 = (_e1177 + 6u);
                                                            let _e1237 = (_e1236 + _e375);
                                                            let _e1238 = (_e1237 < _e105);
                                                            if _e1238 {
                                                                if _e1238 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e1240 = global_10.member[_e1237];
                                                                phi_1814_ = _e1240;
                                                            } else {
                                                                phi_1814_ = 0u;
                                                            }
                                                            let _e1242 = phi_1814_;
                                                            let _e1246 = (_e1236 + _e374);
                                                            let _e1247 = (_e1246 < _e105);
                                                            if _e1247 {
                                                                if _e1247 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e1249 = global_10.member[_e1246];
                                                                phi_1832_ = _e1249;
                                                            } else {
                                                                phi_1832_ = 0u;
                                                            }
                                                            let _e1251 = phi_1832_;
                                                            let _e1255 = (_e1236 + _e376);
                                                            let _e1256 = (_e1255 < _e105);
                                                            if _e1256 {
                                                                if _e1256 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e1258 = global_10.member[_e1255];
                                                                phi_1850_ = _e1258;
                                                            } else {
                                                                phi_1850_ = 0u;
                                                            }
                                                            let _e1260 = phi_1850_;
                                                            phi_1856_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1184)) * _e161), (f32(bitcast<i32>(_e1193)) * _e161), (f32(bitcast<i32>(_e1202)) * _e161)), array<f32, 3>((f32(bitcast<i32>(_e1213)) * _e161), (f32(bitcast<i32>(_e1222)) * _e161), (f32(bitcast<i32>(_e1231)) * _e161)), array<f32, 3>((f32(bitcast<i32>(_e1242)) * _e161), (f32(bitcast<i32>(_e1251)) * _e161), (f32(bitcast<i32>(_e1260)) * _e161)));
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1856_ = array<array<f32, 3>, 3>();
                                                            break;
                                                        }
                                                    }
                                                    let _e1534 = phi_1856_;
                                                    let _e1542 = (_e1534[0][2] - _e480);
                                                    let _e1545 = (((_e1534[0][0] - _e407) * _e504) - (_e1542 * _e432));
                                                    let _e1548 = (((_e1534[0][1] - _e444) * _e504) - (_e1542 * _e468));
                                                    let _e1555 = (_e1534[1][2] - _e480);
                                                    let _e1558 = (((_e1534[1][0] - _e407) * _e504) - (_e1555 * _e432));
                                                    let _e1561 = (((_e1534[1][1] - _e444) * _e504) - (_e1555 * _e468));
                                                    let _e1568 = (_e1534[2][2] - _e480);
                                                    let _e1571 = (((_e1534[2][0] - _e407) * _e504) - (_e1568 * _e432));
                                                    let _e1574 = (((_e1534[2][1] - _e444) * _e504) - (_e1568 * _e468));
                                                    let _e1575 = (_e1571 * _e1561);
                                                    let _e1576 = (_e1574 * _e1558);
                                                    let _e1577 = (_e1545 * _e1574);
                                                    let _e1578 = (_e1548 * _e1571);
                                                    let _e1579 = (_e1558 * _e1548);
                                                    let _e1580 = (_e1561 * _e1545);
                                                    let _e1585 = (((_e1575 >= _e1576) && (_e1577 >= _e1578)) && (_e1579 >= _e1580));
                                                    if (_e1585 || (((_e1575 <= _e1576) && (_e1577 <= _e1578)) && (_e1579 <= _e1580))) {
                                                        let _e1592 = select(-1f, 1f, _e1585);
                                                        let _e1594 = ((_e1575 - _e1576) * _e1592);
                                                        let _e1596 = select(0f, _e1594, (_e1594 > 0f));
                                                        let _e1598 = ((_e1577 - _e1578) * _e1592);
                                                        let _e1600 = select(0f, _e1598, (_e1598 > 0f));
                                                        let _e1602 = ((_e1579 - _e1580) * _e1592);
                                                        let _e1604 = select(0f, _e1602, (_e1602 > 0f));
                                                        let _e1606 = ((_e1596 + _e1600) + _e1604);
                                                        if (_e1606 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2684_ = type_25();
                                                            phi_2685_ = true;
                                                            phi_2686_ = false;
                                                        } else {
                                                            let _e1609 = select(_e1558, _e1545, (_e1545 < _e1558));
                                                            if (select(_e1571, _e1609, (_e1609 < _e1571)) > 0f) {
                                                                phi_1973_ = true;
                                                            } else {
                                                                let _e1614 = select(_e1558, _e1545, (_e1545 > _e1558));
                                                                phi_1973_ = (select(_e1571, _e1614, (_e1614 > _e1571)) < 0f);
                                                            }
                                                            let _e1619 = phi_1973_;
                                                            if _e1619 {
                                                                phi_2681_ = type_25();
                                                                phi_2682_ = true;
                                                                phi_2683_ = false;
                                                            } else {
                                                                let _e1621 = select(_e1561, _e1548, (_e1548 < _e1561));
                                                                if (select(_e1574, _e1621, (_e1621 < _e1574)) > 0f) {
                                                                    phi_2002_ = true;
                                                                } else {
                                                                    let _e1626 = select(_e1561, _e1548, (_e1548 > _e1561));
                                                                    phi_2002_ = (select(_e1574, _e1626, (_e1626 > _e1574)) < 0f);
                                                                }
                                                                let _e1631 = phi_2002_;
                                                                if _e1631 {
                                                                    phi_2679_ = type_25();
                                                                    phi_2680_ = false;
                                                                } else {
                                                                    let _e1633 = select(_e1534[1][0], _e1534[0][0], (_e1534[0][0] < _e1534[1][0]));
                                                                    let _e1637 = select(_e1534[1][0], _e1534[0][0], (_e1534[0][0] > _e1534[1][0]));
                                                                    let _e1641 = select(_e1534[1][1], _e1534[0][1], (_e1534[0][1] < _e1534[1][1]));
                                                                    let _e1645 = select(_e1534[1][1], _e1534[0][1], (_e1534[0][1] > _e1534[1][1]));
                                                                    let _e1649 = select(_e1534[1][2], _e1534[0][2], (_e1534[0][2] < _e1534[1][2]));
                                                                    let _e1653 = select(_e1534[1][2], _e1534[0][2], (_e1534[0][2] > _e1534[1][2]));
                                                                    let _e1658 = ((select(_e1534[2][0], _e1633, (_e1633 < _e1534[2][0])) - _e430) * _e435);
                                                                    let _e1659 = ((select(_e1534[2][0], _e1637, (_e1637 > _e1534[2][0])) - _e431) * _e435);
                                                                    let _e1662 = ((select(_e1534[2][1], _e1641, (_e1641 < _e1534[2][1])) - _e466) * _e471);
                                                                    let _e1663 = ((select(_e1534[2][1], _e1645, (_e1645 > _e1534[2][1])) - _e467) * _e471);
                                                                    let _e1666 = ((select(_e1534[2][2], _e1649, (_e1649 < _e1534[2][2])) - _e502) * _e507);
                                                                    let _e1667 = ((select(_e1534[2][2], _e1653, (_e1653 > _e1534[2][2])) - _e503) * _e507);
                                                                    let _e1669 = select(_e1667, _e1666, (_e1666 < _e1667));
                                                                    let _e1671 = select(_e1667, _e1666, (_e1666 > _e1667));
                                                                    let _e1673 = select(_e1659, _e1658, (_e1658 < _e1659));
                                                                    let _e1675 = select(_e1663, _e1662, (_e1662 < _e1663));
                                                                    let _e1677 = select(_e1675, _e1673, (_e1673 > _e1675));
                                                                    let _e1679 = select(_e1669, _e1677, (_e1677 > _e1669));
                                                                    let _e1681 = select(_e1659, _e1658, (_e1658 > _e1659));
                                                                    let _e1683 = select(_e1663, _e1662, (_e1662 > _e1663));
                                                                    let _e1685 = select(_e1683, _e1681, (_e1681 < _e1683));
                                                                    let _e1687 = select(_e1671, _e1685, (_e1685 < _e1671));
                                                                    let _e1688 = -(_e1669);
                                                                    let _e1694 = select(_e553, _e1679, (_e1679 > _e553));
                                                                    if (_e1694 > (_e1687 + (select(_e1688, _e1671, (_e1671 > _e1688)) * 0.0000019073523f))) {
                                                                        phi_2674_ = type_25();
                                                                        phi_2675_ = true;
                                                                    } else {
                                                                        let _e1696 = (_e1694 > _e1105.member);
                                                                        if _e1696 {
                                                                            phi_2673_ = type_25();
                                                                        } else {
                                                                            let _e1697 = vec3<f32>(_e1534[0][0], _e1534[0][1], _e1534[0][2]);
                                                                            let _e1698 = vec3<f32>(_e1534[1][0], _e1534[1][1], _e1534[1][2]);
                                                                            let _e1699 = vec3<f32>(_e1534[2][0], _e1534[2][1], _e1534[2][2]);
                                                                            let _e1700 = (_e1534[1][0] - _e1534[0][0]);
                                                                            let _e1701 = (_e1534[1][1] - _e1534[0][1]);
                                                                            let _e1702 = (_e1534[1][2] - _e1534[0][2]);
                                                                            let _e1703 = vec3<f32>(_e1700, _e1701, _e1702);
                                                                            let _e1704 = (_e1534[2][0] - _e1534[1][0]);
                                                                            let _e1705 = (_e1534[2][1] - _e1534[1][1]);
                                                                            let _e1706 = (_e1534[2][2] - _e1534[1][2]);
                                                                            let _e1707 = vec3<f32>(_e1704, _e1705, _e1706);
                                                                            let _e1708 = (_e1534[0][0] - _e1534[2][0]);
                                                                            let _e1709 = (_e1534[0][1] - _e1534[2][1]);
                                                                            let _e1710 = (_e1534[0][2] - _e1534[2][2]);
                                                                            let _e1711 = vec3<f32>(_e1708, _e1709, _e1710);
                                                                            let _e1714 = bitcast<f32>((bitcast<u32>(_e1700) & 2147483647u));
                                                                            let _e1717 = bitcast<f32>((bitcast<u32>(_e1701) & 2147483647u));
                                                                            let _e1719 = select(_e1717, _e1714, (_e1714 > _e1717));
                                                                            let _e1722 = bitcast<f32>((bitcast<u32>(_e1702) & 2147483647u));
                                                                            let _e1724 = select(_e1722, _e1719, (_e1719 > _e1722));
                                                                            let _e1727 = bitcast<f32>((bitcast<u32>(_e1704) & 2147483647u));
                                                                            let _e1730 = bitcast<f32>((bitcast<u32>(_e1705) & 2147483647u));
                                                                            let _e1732 = select(_e1730, _e1727, (_e1727 > _e1730));
                                                                            let _e1735 = bitcast<f32>((bitcast<u32>(_e1706) & 2147483647u));
                                                                            let _e1737 = select(_e1735, _e1732, (_e1732 > _e1735));
                                                                            let _e1740 = bitcast<f32>((bitcast<u32>(_e1708) & 2147483647u));
                                                                            let _e1743 = bitcast<f32>((bitcast<u32>(_e1709) & 2147483647u));
                                                                            let _e1745 = select(_e1743, _e1740, (_e1740 > _e1743));
                                                                            let _e1748 = bitcast<f32>((bitcast<u32>(_e1710) & 2147483647u));
                                                                            let _e1750 = select(_e1748, _e1745, (_e1745 > _e1748));
                                                                            let _e1752 = select(_e1737, _e1724, (_e1724 > _e1737));
                                                                            let _e1754 = select(_e1750, _e1752, (_e1752 > _e1750));
                                                                            if (_e1724 == _e1754) {
                                                                                phi_2403_ = _e1561;
                                                                                phi_2404_ = _e1558;
                                                                                phi_2405_ = _e1548;
                                                                                phi_2406_ = _e1545;
                                                                                phi_2407_ = _e1697;
                                                                                phi_2408_ = _e1711;
                                                                                phi_2409_ = _e1707;
                                                                                phi_2410_ = _e1703;
                                                                            } else {
                                                                                let _e1756 = (_e1737 == _e1754);
                                                                                let _e1761 = vec3(_e1756);
                                                                                phi_2403_ = select(_e1548, _e1574, _e1756);
                                                                                phi_2404_ = select(_e1545, _e1571, _e1756);
                                                                                phi_2405_ = select(_e1574, _e1561, _e1756);
                                                                                phi_2406_ = select(_e1571, _e1558, _e1756);
                                                                                phi_2407_ = select(_e1699, _e1698, _e1761);
                                                                                phi_2408_ = select(_e1707, _e1703, _e1761);
                                                                                phi_2409_ = select(_e1703, _e1711, _e1761);
                                                                                phi_2410_ = select(_e1711, _e1707, _e1761);
                                                                            }
                                                                            let _e1767 = phi_2403_;
                                                                            let _e1769 = phi_2404_;
                                                                            let _e1771 = phi_2405_;
                                                                            let _e1773 = phi_2406_;
                                                                            let _e1775 = phi_2407_;
                                                                            let _e1777 = phi_2408_;
                                                                            let _e1779 = phi_2409_;
                                                                            let _e1781 = phi_2410_;
                                                                            let _e1788 = ((_e1779.y * _e1777.z) - (_e1777.y * _e1779.z));
                                                                            let _e1793 = ((_e1779.z * _e1777.x) - (_e1777.z * _e1779.x));
                                                                            let _e1796 = ((_e1779.x * _e1777.y) - (_e1777.x * _e1779.y));
                                                                            if (_e1596 >= _e1600) {
                                                                                phi_2441_ = select(true, false, (_e1596 >= _e1604));
                                                                            } else {
                                                                                phi_2441_ = true;
                                                                            }
                                                                            let _e1801 = phi_2441_;
                                                                            if _e1801 {
                                                                                phi_2450_ = select(_e1699, _e1698, vec3((_e1600 >= _e1604)));
                                                                            } else {
                                                                                phi_2450_ = _e1697;
                                                                            }
                                                                            let _e1806 = phi_2450_;
                                                                            let _e1811 = (((_e1788 * _e432) + (_e1793 * _e468)) + (_e1796 * _e504));
                                                                            let _e1822 = (((_e1788 * (_e1806.x - _e407)) + (_e1793 * (_e1806.y - _e444))) + (_e1796 * (_e1806.z - _e480)));
                                                                            let _e1824 = (_e1769 - _e1773);
                                                                            let _e1825 = (_e1767 - _e1771);
                                                                            let _e1833 = (-(((_e1773 * _e1824) + (_e1771 * _e1825))) / ((_e1824 * _e1824) + (_e1825 * _e1825)));
                                                                            let _e1835 = select(1f, _e1833, (_e1833 < 1f));
                                                                            let _e1837 = select(0f, _e1835, (_e1835 > 0f));
                                                                            let _e1850 = ((_e1775.x + (_e1781.x * _e1837)) - _e407);
                                                                            let _e1851 = ((_e1775.y + (_e1781.y * _e1837)) - _e444);
                                                                            let _e1852 = ((_e1775.z + (_e1781.z * _e1837)) - _e480);
                                                                            let _e1853 = (_e1852 / _e504);
                                                                            let _e1865 = bitcast<f32>((bitcast<u32>(_e1850) & 2147483647u));
                                                                            let _e1868 = bitcast<f32>((bitcast<u32>(_e1851) & 2147483647u));
                                                                            let _e1870 = select(_e1868, _e1865, (_e1865 > _e1868));
                                                                            let _e1873 = bitcast<f32>((bitcast<u32>(_e1852) & 2147483647u));
                                                                            let _e1875 = select(_e1873, _e1870, (_e1870 > _e1873));
                                                                            let _e1881 = bitcast<f32>((bitcast<u32>(_e1788) & 2147483647u));
                                                                            let _e1884 = bitcast<f32>((bitcast<u32>(_e1793) & 2147483647u));
                                                                            let _e1886 = select(_e1884, _e1881, (_e1881 > _e1884));
                                                                            let _e1889 = bitcast<f32>((bitcast<u32>(_e1796) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1788 * _e1850) + (_e1793 * _e1851)) + (_e1796 * _e1852)) - _e1822)) & 2147483647u)) <= ((0.0000009536743f * select(_e1754, _e1875, (_e1875 > _e1754))) * select(_e1889, _e1886, (_e1886 > _e1889)))) {
                                                                                let _e1899 = bitcast<f32>((bitcast<u32>(_e1779.x) & 2147483647u));
                                                                                let _e1902 = bitcast<f32>((bitcast<u32>(_e1779.y) & 2147483647u));
                                                                                let _e1904 = select(_e1902, _e1899, (_e1899 > _e1902));
                                                                                let _e1907 = bitcast<f32>((bitcast<u32>(_e1779.z) & 2147483647u));
                                                                                let _e1913 = bitcast<f32>((bitcast<u32>(_e1777.x) & 2147483647u));
                                                                                let _e1916 = bitcast<f32>((bitcast<u32>(_e1777.y) & 2147483647u));
                                                                                let _e1918 = select(_e1916, _e1913, (_e1913 > _e1916));
                                                                                let _e1921 = bitcast<f32>((bitcast<u32>(_e1777.z) & 2147483647u));
                                                                                phi_2617_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1811) & 2147483647u)) > ((0.0000038146973f * select(_e1907, _e1904, (_e1904 > _e1907))) * select(_e1921, _e1918, (_e1918 > _e1921)))));
                                                                            } else {
                                                                                phi_2617_ = true;
                                                                            }
                                                                            let _e1928 = phi_2617_;
                                                                            if _e1928 {
                                                                                let _e1939 = ((((_e1788 * (_e1850 - (_e432 * _e1853))) + (_e1793 * (_e1851 - (_e468 * _e1853)))) + (_e1796 * (_e1852 - _e1852))) / _e1811);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1939) & 2147483647u)) <= _e1754) {
                                                                                    phi_2641_ = (_e1853 + _e1939);
                                                                                } else {
                                                                                    phi_2641_ = _e1853;
                                                                                }
                                                                                let _e1946 = phi_2641_;
                                                                                phi_2642_ = _e1946;
                                                                            } else {
                                                                                phi_2642_ = (_e1822 / _e1811);
                                                                            }
                                                                            let _e1948 = phi_2642_;
                                                                            let _e1950 = select(_e1687, _e1948, (_e1948 < _e1687));
                                                                            let _e1952 = select(_e1679, _e1950, (_e1950 > _e1679));
                                                                            if (_e1952 >= _e553) {
                                                                                let _e1954 = (_e1952 <= _e1105.member);
                                                                                if _e1954 {
                                                                                    let _e1955 = (1f / _e1606);
                                                                                    phi_2665_ = type_25(_e1952, (_e1600 * _e1955), (_e1604 * _e1955), _e1165);
                                                                                } else {
                                                                                    phi_2665_ = type_25();
                                                                                }
                                                                                let _e1960 = phi_2665_;
                                                                                phi_2667_ = _e1960;
                                                                                phi_2668_ = select(true, false, _e1954);
                                                                            } else {
                                                                                phi_2667_ = type_25();
                                                                                phi_2668_ = true;
                                                                            }
                                                                            let _e1963 = phi_2667_;
                                                                            let _e1965 = phi_2668_;
                                                                            if _e1965 {
                                                                                phi_2672_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2672_ = _e1963;
                                                                            }
                                                                            let _e1967 = phi_2672_;
                                                                            phi_2673_ = _e1967;
                                                                        }
                                                                        let _e1969 = phi_2673_;
                                                                        phi_2674_ = _e1969;
                                                                        phi_2675_ = _e1696;
                                                                    }
                                                                    let _e1971 = phi_2674_;
                                                                    let _e1973 = phi_2675_;
                                                                    phi_2679_ = _e1971;
                                                                    phi_2680_ = _e1973;
                                                                }
                                                                let _e1975 = phi_2679_;
                                                                let _e1977 = phi_2680_;
                                                                phi_2681_ = _e1975;
                                                                phi_2682_ = _e1631;
                                                                phi_2683_ = _e1977;
                                                            }
                                                            let _e1979 = phi_2681_;
                                                            let _e1981 = phi_2682_;
                                                            let _e1983 = phi_2683_;
                                                            phi_2684_ = _e1979;
                                                            phi_2685_ = _e1981;
                                                            phi_2686_ = _e1983;
                                                        }
                                                        let _e1985 = phi_2684_;
                                                        let _e1987 = phi_2685_;
                                                        let _e1989 = phi_2686_;
                                                        phi_2694_ = _e1985;
                                                        phi_2695_ = select(_e1989, true, _e1987);
                                                    } else {
                                                        phi_2694_ = type_25();
                                                        phi_2695_ = true;
                                                    }
                                                    let _e1992 = phi_2694_;
                                                    let _e1994 = phi_2695_;
                                                    if _e1994 {
                                                        phi_2699_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2699_ = _e1992;
                                                    }
                                                    let _e1996 = phi_2699_;
                                                    if (_e1996.member_3 != 4294967295u) {
                                                        if (_e1165 == _e170) {
                                                            phi_3028_ = false;
                                                        } else {
                                                            let _e2000 = (_e1165 < arrayLength((&global_6.member)));
                                                            if _e2000 {
                                                                if _e2000 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e2002 = global_6.member[_e1165];
                                                                phi_2722_ = _e2002;
                                                            } else {
                                                                phi_2722_ = 4294967295u;
                                                            }
                                                            let _e2004 = phi_2722_;
                                                            let _e2005 = (_e2004 < arrayLength((&global_7.member)));
                                                            if _e2005 {
                                                                if _e2005 {
                                                                } else {
                                                                    phi_4533_ = true;
                                                                    break;
                                                                }
                                                                let _e2007 = global_7.member[_e2004];
                                                                phi_2736_ = _e2007;
                                                            } else {
                                                                phi_2736_ = 0i;
                                                            }
                                                            let _e2009 = phi_2736_;
                                                            let _e2010 = (_e2009 == 0i);
                                                            if _e2010 {
                                                                phi_3027_ = true;
                                                            } else {
                                                                if _e399 {
                                                                    phi_2757_ = vec3<f32>(_e1534[0][0], _e1534[0][1], _e1534[0][2]);
                                                                } else {
                                                                    if (_e375 == 1u) {
                                                                        phi_2756_ = vec3<f32>(_e1534[0][2], _e1534[0][0], _e1534[0][1]);
                                                                    } else {
                                                                        phi_2756_ = vec3<f32>(_e1534[0][1], _e1534[0][2], _e1534[0][0]);
                                                                    }
                                                                    let _e2015 = phi_2756_;
                                                                    phi_2757_ = _e2015;
                                                                }
                                                                let _e2018 = phi_2757_;
                                                                if _e399 {
                                                                    phi_2774_ = vec3<f32>(_e1534[1][0], _e1534[1][1], _e1534[1][2]);
                                                                } else {
                                                                    if (_e375 == 1u) {
                                                                        phi_2773_ = vec3<f32>(_e1534[1][2], _e1534[1][0], _e1534[1][1]);
                                                                    } else {
                                                                        phi_2773_ = vec3<f32>(_e1534[1][1], _e1534[1][2], _e1534[1][0]);
                                                                    }
                                                                    let _e2023 = phi_2773_;
                                                                    phi_2774_ = _e2023;
                                                                }
                                                                let _e2026 = phi_2774_;
                                                                if _e399 {
                                                                    phi_2791_ = vec3<f32>(_e1534[2][0], _e1534[2][1], _e1534[2][2]);
                                                                } else {
                                                                    if (_e375 == 1u) {
                                                                        phi_2790_ = vec3<f32>(_e1534[2][2], _e1534[2][0], _e1534[2][1]);
                                                                    } else {
                                                                        phi_2790_ = vec3<f32>(_e1534[2][1], _e1534[2][2], _e1534[2][0]);
                                                                    }
                                                                    let _e2031 = phi_2790_;
                                                                    phi_2791_ = _e2031;
                                                                }
                                                                let _e2034 = phi_2791_;
                                                                let _e2037 = (_e2026.x - _e2018.x);
                                                                let _e2040 = (_e2026.y - _e2018.y);
                                                                let _e2043 = (_e2026.z - _e2018.z);
                                                                let _e2045 = (_e2034.x - _e2018.x);
                                                                let _e2047 = (_e2034.y - _e2018.y);
                                                                let _e2049 = (_e2034.z - _e2018.z);
                                                                if (_e242.member_1 == 1u) {
                                                                    phi_2827_ = (vec3<f32>(_e242.member[0], _e242.member[1], _e242.member[2]) - _e2018);
                                                                } else {
                                                                    phi_2827_ = vec3<f32>(_e242.member[0], _e242.member[1], _e242.member[2]);
                                                                }
                                                                let _e2064 = phi_2827_;
                                                                let _e2070 = bitcast<f32>((bitcast<u32>((_e2037 * _e2047)) ^ _e242.member_3[0]));
                                                                let _e2074 = bitcast<f32>((bitcast<u32>((_e2040 * _e2045)) ^ _e242.member_3[0]));
                                                                let _e2078 = bitcast<f32>((bitcast<u32>((_e2040 * _e2049)) ^ _e242.member_3[0]));
                                                                let _e2082 = bitcast<f32>((bitcast<u32>((_e2043 * _e2047)) ^ _e242.member_3[0]));
                                                                let _e2086 = bitcast<f32>((bitcast<u32>((_e2043 * _e2045)) ^ _e242.member_3[0]));
                                                                let _e2090 = bitcast<f32>((bitcast<u32>((_e2037 * _e2049)) ^ _e242.member_3[0]));
                                                                let _e2091 = (_e2078 - _e2082);
                                                                let _e2092 = (_e2086 - _e2090);
                                                                let _e2093 = (_e2070 - _e2074);
                                                                let _e2117 = (bitcast<f32>((bitcast<u32>(_e2078) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2082) & 2147483647u)));
                                                                let _e2124 = (bitcast<f32>((bitcast<u32>(_e2086) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2090) & 2147483647u)));
                                                                let _e2131 = (bitcast<f32>((bitcast<u32>(_e2070) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2074) & 2147483647u)));
                                                                if (_e242.member_2 == 0f) {
                                                                    phi_3009_ = 0f;
                                                                } else {
                                                                    let _e2161 = bitcast<f32>((bitcast<u32>(_e2091) & 2147483647u));
                                                                    let _e2164 = bitcast<f32>((bitcast<u32>(_e2092) & 2147483647u));
                                                                    let _e2167 = bitcast<f32>((bitcast<u32>(_e2093) & 2147483647u));
                                                                    let _e2169 = select(_e2167, _e2164, (_e2164 > _e2167));
                                                                    let _e2173 = select(_e2167, _e2164, (_e2164 < _e2167));
                                                                    let _e2177 = select(_e2164, _e2161, (_e2161 < _e2164));
                                                                    let _e2179 = select(_e2164, _e2161, (_e2161 > _e2164));
                                                                    let _e2181 = select(_e2167, _e2179, (_e2179 < _e2167));
                                                                    phi_3009_ = bitcast<f32>((bitcast<u32>((_e242.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2169, _e2161, (_e2161 > _e2169)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2181, _e2177, (_e2177 > _e2181)))) ^ _e242.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2173, _e2161, (_e2161 < _e2173)))) ^ _e242.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e2117 + _e2124) + _e2131))) ^ _e242.member_3[0]))) * 1.0000005f)) ^ _e242.member_3[0])))) ^ _e242.member_3[0]));
                                                                }
                                                                let _e2208 = phi_3009_;
                                                                phi_3027_ = (_e2010 || !(((((bitcast<f32>((bitcast<u32>((_e2064.x * _e2091)) ^ _e242.member_3[0])) + bitcast<f32>((bitcast<u32>((_e2064.y * _e2092)) ^ _e242.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e2064.z * _e2093)) ^ _e242.member_3[0]))) * f32(-(_e2009))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2064.x) & 2147483647u)) * _e2117)) ^ _e242.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2064.y) & 2147483647u)) * _e2124)) ^ _e242.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2064.z) & 2147483647u)) * _e2131)) ^ _e242.member_3[0]))))) ^ _e242.member_3[0])) + _e2208) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e2222 = phi_3027_;
                                                            phi_3028_ = _e2222;
                                                        }
                                                        let _e2224 = phi_3028_;
                                                        if _e2224 {
                                                            phi_3033_ = type_46(_e1105.member, true);
                                                        } else {
                                                            phi_3033_ = _e1105;
                                                        }
                                                        let _e2229 = phi_3033_;
                                                        phi_3034_ = _e2229;
                                                    } else {
                                                        phi_3034_ = _e1105;
                                                    }
                                                    let _e2231 = phi_3034_;
                                                    phi_1138_ = _e2231;
                                                } else {
                                                    phi_1138_ = type_46();
                                                }
                                                let _e2233 = phi_1138_;
                                                continue;
                                                continuing {
                                                    phi_1137_ = _e2233;
                                                    phi_1140_ = _e1120;
                                                    phi_4533_ = _e595;
                                                    break if !(_e1126);
                                                }
                                            }
                                            let _e2236 = phi_4533_;
                                            phi_4746_ = _e2236;
                                            if _e2236 {
                                                break;
                                            }
                                            let _e2238 = local_10;
                                            phi_4750_ = _e2236;
                                            let _e2476 = local_12;
                                            phi_4275_ = _e2476;
                                            phi_4276_ = _e636;
                                            phi_4277_ = false;
                                            phi_4278_ = select(_e640, 0u, _e2238.member_1);
                                        } else {
                                            if (_e636.member_1 >= _e102) {
                                                phi_3831_ = type_59(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_58(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_58(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e636.member_1 < _e102) {
                                                } else {
                                                    phi_4746_ = true;
                                                    break;
                                                }
                                                let _e653 = ((1u + _e375) % 4u);
                                                if (_e653 < 4u) {
                                                } else {
                                                    phi_4746_ = true;
                                                    break;
                                                }
                                                let _e658 = global_5.member[_e636.member_1][_e653];
                                                let _e660 = (_e658 >> bitcast<u32>(11u));
                                                let _e662 = ((1u + _e374) % 4u);
                                                if (_e662 < 4u) {
                                                } else {
                                                    phi_4746_ = true;
                                                    break;
                                                }
                                                let _e667 = global_5.member[_e636.member_1][_e662];
                                                let _e669 = (_e667 >> bitcast<u32>(11u));
                                                let _e671 = ((1u + _e376) % 4u);
                                                if (_e671 < 4u) {
                                                } else {
                                                    phi_4746_ = true;
                                                    break;
                                                }
                                                let _e676 = global_5.member[_e636.member_1][_e671];
                                                let _e678 = (_e676 >> bitcast<u32>(11u));
                                                let _e701 = (bitcast<f32>((bitcast<u32>((_e636.member.member_1.x - _e636.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e702 = (bitcast<f32>((bitcast<u32>((_e636.member.member_1.y - _e636.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e703 = (bitcast<f32>((bitcast<u32>((_e636.member.member_1.z - _e636.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e705 = select(_e161, _e701, (_e701 > _e161));
                                                let _e707 = select(_e161, _e702, (_e702 > _e161));
                                                let _e709 = select(_e161, _e703, (_e703 > _e161));
                                                let _e734 = bitcast<u32>((f32(bitcast<i32>((_e658 & 1023u))) * _e705));
                                                let _e739 = (bitcast<i32>((_e658 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e742 = bitcast<f32>((_e734 & bitcast<u32>(_e739)));
                                                let _e743 = bitcast<u32>((f32(bitcast<i32>((_e667 & 1023u))) * _e707));
                                                let _e748 = (bitcast<i32>((_e667 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e751 = bitcast<f32>((_e743 & bitcast<u32>(_e748)));
                                                let _e752 = bitcast<u32>((f32(bitcast<i32>((_e676 & 1023u))) * _e709));
                                                let _e757 = (bitcast<i32>((_e676 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e760 = bitcast<f32>((_e752 & bitcast<u32>(_e757)));
                                                let _e764 = bitcast<f32>((_e734 & bitcast<u32>(~(_e739))));
                                                let _e768 = bitcast<f32>((_e743 & bitcast<u32>(~(_e748))));
                                                let _e772 = bitcast<f32>((_e752 & bitcast<u32>(~(_e757))));
                                                let _e773 = bitcast<u32>((f32(bitcast<i32>((_e660 & 1023u))) * _e705));
                                                let _e778 = (bitcast<i32>((_e660 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e781 = bitcast<f32>((_e773 & bitcast<u32>(_e778)));
                                                let _e782 = bitcast<u32>((f32(bitcast<i32>((_e669 & 1023u))) * _e707));
                                                let _e787 = (bitcast<i32>((_e669 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e790 = bitcast<f32>((_e782 & bitcast<u32>(_e787)));
                                                let _e791 = bitcast<u32>((f32(bitcast<i32>((_e678 & 1023u))) * _e709));
                                                let _e796 = (bitcast<i32>((_e678 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e799 = bitcast<f32>((_e791 & bitcast<u32>(_e796)));
                                                let _e803 = bitcast<f32>((_e773 & bitcast<u32>(~(_e778))));
                                                let _e807 = bitcast<f32>((_e782 & bitcast<u32>(~(_e787))));
                                                let _e811 = bitcast<f32>((_e791 & bitcast<u32>(~(_e796))));
                                                let _e812 = (_e636.member.member.x + _e742);
                                                let _e813 = (_e636.member.member.y + _e751);
                                                let _e814 = (_e636.member.member.z + _e760);
                                                let _e817 = (_e636.member.member_1.x - _e781);
                                                let _e818 = (_e636.member.member_1.y - _e790);
                                                let _e819 = (_e636.member.member_1.z - _e799);
                                                let _e838 = (_e817 - _e812);
                                                let _e839 = (_e818 - _e813);
                                                let _e840 = (_e819 - _e814);
                                                let _e842 = select(_e839, _e838, (_e838 > _e839));
                                                let _e844 = select(_e840, _e842, (_e842 > _e840));
                                                if (_e844 < (1024f * _e161)) {
                                                    phi_3532_ = 0u;
                                                } else {
                                                    phi_3532_ = select(2u, 1u, (_e844 < (2097152f * _e161)));
                                                }
                                                let _e851 = phi_3532_;
                                                switch bitcast<i32>(_e851) {
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
                                                let _e854 = phi_3538_;
                                                let _e860 = global_5.member[_e636.member_1][0u];
                                                let _e864 = global_5.member[_e636.member_1][1u];
                                                let _e868 = global_5.member[_e636.member_1][2u];
                                                let _e872 = global_5.member[_e636.member_1][3u];
                                                let _e884 = (((_e864 >> bitcast<u32>(22i)) | ((_e868 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e872 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e885 = (_e860 & 268435455u);
                                                let _e886 = (_e884 & 268435455u);
                                                let _e889 = ((_e860 >> bitcast<u32>(28u)) & 7u);
                                                let _e897 = ((_e860 >> bitcast<u32>(31i)) | (((_e884 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e898 = (_e889 != 0u);
                                                if (_e889 == 0u) {
                                                    phi_3793_ = _e885;
                                                } else {
                                                    if (_e889 == 7u) {
                                                        phi_3792_ = 2147483648u;
                                                    } else {
                                                        phi_3792_ = ((2147483648u | (_e889 << bitcast<u32>(28u))) | (_e886 & 268435455u));
                                                    }
                                                    let _e907 = phi_3792_;
                                                    phi_3793_ = _e907;
                                                }
                                                let _e909 = phi_3793_;
                                                if _e898 {
                                                    let _e910 = (_e889 != 7u);
                                                    if _e910 {
                                                        phi_3803_ = (_e886 + (_e889 * ((3u * _e854) + 1u)));
                                                    } else {
                                                        phi_3803_ = u32();
                                                    }
                                                    let _e914 = phi_3803_;
                                                    phi_3805_ = _e914;
                                                    phi_3806_ = select(true, false, _e910);
                                                } else {
                                                    phi_3805_ = u32();
                                                    phi_3806_ = true;
                                                }
                                                let _e917 = phi_3805_;
                                                let _e919 = phi_3806_;
                                                if (_e897 == 0u) {
                                                    phi_3827_ = (_e885 + select(0u, 1u, !(_e898)));
                                                } else {
                                                    if (_e897 == 7u) {
                                                        phi_3826_ = 2147483648u;
                                                    } else {
                                                        phi_3826_ = ((2147483648u | (_e897 << bitcast<u32>(28u))) | (select(_e917, _e886, _e919) & 268435455u));
                                                    }
                                                    let _e932 = phi_3826_;
                                                    phi_3827_ = _e932;
                                                }
                                                let _e934 = phi_3827_;
                                                phi_3831_ = type_59(array<vec4<f32>, 3>(vec4<f32>(_e812, (_e636.member.member.x + _e764), _e817, (_e636.member.member_1.x - _e803)), vec4<f32>(_e813, (_e636.member.member.y + _e768), _e818, (_e636.member.member_1.y - _e807)), vec4<f32>(_e814, (_e636.member.member.z + _e772), _e819, (_e636.member.member_1.z - _e811))), type_58(type_34((_e636.member.member + vec4<f32>(_e742, _e751, _e760, 0f)), (_e636.member.member_1 - vec4<f32>(_e781, _e790, _e799, 0f))), _e909), type_58(type_34((_e636.member.member + vec4<f32>(_e764, _e768, _e772, 0f)), (_e636.member.member_1 - vec4<f32>(_e803, _e807, _e811, 0f))), _e934));
                                            }
                                            let _e939 = phi_3831_;
                                            let _e951 = ((_e939.member[0].x - _e430) * _e435);
                                            let _e952 = ((_e939.member[0].y - _e430) * _e435);
                                            let _e953 = ((_e939.member[0].z - _e431) * _e435);
                                            let _e954 = ((_e939.member[0].w - _e431) * _e435);
                                            let _e964 = ((_e939.member[1].x - _e466) * _e471);
                                            let _e965 = ((_e939.member[1].y - _e466) * _e471);
                                            let _e966 = ((_e939.member[1].z - _e467) * _e471);
                                            let _e967 = ((_e939.member[1].w - _e467) * _e471);
                                            let _e977 = ((_e939.member[2].x - _e502) * _e507);
                                            let _e978 = ((_e939.member[2].y - _e502) * _e507);
                                            let _e979 = ((_e939.member[2].z - _e503) * _e507);
                                            let _e980 = ((_e939.member[2].w - _e503) * _e507);
                                            let _e982 = select(_e979, _e977, (_e977 < _e979));
                                            let _e984 = select(_e980, _e978, (_e978 < _e980));
                                            let _e986 = select(_e979, _e977, (_e977 > _e979));
                                            let _e988 = select(_e980, _e978, (_e978 > _e980));
                                            let _e990 = select(_e953, _e951, (_e951 < _e953));
                                            let _e992 = select(_e954, _e952, (_e952 < _e954));
                                            let _e994 = select(_e966, _e964, (_e964 < _e966));
                                            let _e996 = select(_e967, _e965, (_e965 < _e967));
                                            let _e998 = select(_e994, _e990, (_e990 > _e994));
                                            let _e1000 = select(_e996, _e992, (_e992 > _e996));
                                            let _e1002 = select(_e982, _e998, (_e998 > _e982));
                                            let _e1004 = select(_e984, _e1000, (_e1000 > _e984));
                                            let _e1006 = select(_e953, _e951, (_e951 > _e953));
                                            let _e1008 = select(_e954, _e952, (_e952 > _e954));
                                            let _e1010 = select(_e966, _e964, (_e964 > _e966));
                                            let _e1012 = select(_e967, _e965, (_e965 > _e967));
                                            let _e1014 = select(_e1010, _e1006, (_e1006 < _e1010));
                                            let _e1016 = select(_e1012, _e1008, (_e1008 < _e1012));
                                            let _e1021 = -(_e982);
                                            let _e1022 = -(_e984);
                                            let _e1029 = (select(_e986, _e1014, (_e1014 < _e986)) + (select(_e1021, _e986, (_e986 > _e1021)) * 0.0000019073523f));
                                            let _e1030 = (select(_e988, _e1016, (_e1016 < _e988)) + (select(_e1022, _e988, (_e988 > _e1022)) * 0.0000019073523f));
                                            let _e1032 = select(_e553, _e1002, (_e1002 > _e553));
                                            let _e1034 = select(_e553, _e1004, (_e1004 > _e553));
                                            let _e1039 = (_e1032 <= select(_e597.member, _e1029, (_e1029 < _e597.member)));
                                            let _e1040 = (_e1034 <= select(_e597.member, _e1030, (_e1030 < _e597.member)));
                                            let _e1041 = (_e1032 <= _e1034);
                                            if _e1039 {
                                                if _e1040 {
                                                    if _e1041 {
                                                        phi_4175_ = _e939.member_2;
                                                    } else {
                                                        phi_4175_ = _e939.member_1;
                                                    }
                                                    let _e1045 = phi_4175_;
                                                    let _e1067 = (_e640 % 128u);
                                                    let _e1068 = (_e1067 < 128u);
                                                    if _e1068 {
                                                    } else {
                                                        phi_4746_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1067] = _e1045.member_1;
                                                    if _e1068 {
                                                    } else {
                                                        phi_4746_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1067] = _e1045.member.member.x;
                                                    if _e1068 {
                                                    } else {
                                                        phi_4746_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1067] = _e1045.member.member.y;
                                                    if _e1068 {
                                                    } else {
                                                        phi_4746_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1067] = _e1045.member.member.z;
                                                    if _e1068 {
                                                    } else {
                                                        phi_4746_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1067] = _e1045.member.member_1.x;
                                                    if _e1068 {
                                                    } else {
                                                        phi_4746_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1067] = _e1045.member.member_1.y;
                                                    if _e1068 {
                                                    } else {
                                                        phi_4746_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1067] = _e1045.member.member_1.z;
                                                    if _e1068 {
                                                    } else {
                                                        phi_4746_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1067] = select(_e1034, _e1032, (_e1032 > _e1034));
                                                    if _e1041 {
                                                        phi_4252_ = _e939.member_1;
                                                    } else {
                                                        phi_4252_ = _e939.member_2;
                                                    }
                                                    let _e1081 = phi_4252_;
                                                    phi_4253_ = _e1081;
                                                    phi_4254_ = (_e640 + 1u);
                                                } else {
                                                    phi_4253_ = type_58();
                                                    phi_4254_ = u32();
                                                }
                                                let _e1083 = phi_4253_;
                                                let _e1085 = phi_4254_;
                                                phi_4256_ = _e1083;
                                                phi_4257_ = _e1085;
                                                phi_4258_ = select(true, false, _e1040);
                                            } else {
                                                phi_4256_ = type_58();
                                                phi_4257_ = u32();
                                                phi_4258_ = true;
                                            }
                                            let _e1088 = phi_4256_;
                                            let _e1090 = phi_4257_;
                                            let _e1092 = phi_4258_;
                                            if _e1092 {
                                                if _e1039 {
                                                    phi_4267_ = _e939.member_1;
                                                } else {
                                                    phi_4267_ = _e939.member_2;
                                                }
                                                let _e1096 = phi_4267_;
                                                phi_4272_ = _e1096;
                                                phi_4273_ = select(_e1040, true, _e1039);
                                            } else {
                                                phi_4272_ = _e1088;
                                                phi_4273_ = _e638;
                                            }
                                            let _e1099 = phi_4272_;
                                            let _e1101 = phi_4273_;
                                            phi_4750_ = _e595;
                                            phi_4275_ = _e597;
                                            phi_4276_ = _e1099;
                                            phi_4277_ = _e1101;
                                            phi_4278_ = select(_e1090, _e640, _e1092);
                                        }
                                        let _e2242 = phi_4750_;
                                        let _e2244 = phi_4275_;
                                        let _e2246 = phi_4276_;
                                        let _e2248 = phi_4277_;
                                        let _e2250 = phi_4278_;
                                        phi_4749_ = _e2242;
                                        phi_4279_ = _e2244;
                                        phi_4280_ = _e2246;
                                        phi_4281_ = (_e601 - 1u);
                                        phi_4282_ = _e2248;
                                        phi_4283_ = _e2250;
                                    } else {
                                        phi_4749_ = _e595;
                                        phi_4279_ = _e597;
                                        phi_4280_ = _e636;
                                        phi_4281_ = _e601;
                                        phi_4282_ = _e638;
                                        phi_4283_ = _e640;
                                    }
                                    let _e2252 = phi_4749_;
                                    let _e2254 = phi_4279_;
                                    let _e2256 = phi_4280_;
                                    let _e2258 = phi_4281_;
                                    let _e2260 = phi_4282_;
                                    let _e2262 = phi_4283_;
                                    phi_4748_ = _e2252;
                                    phi_4284_ = _e2254;
                                    phi_4285_ = _e2256;
                                    phi_4286_ = _e2258;
                                    phi_4287_ = _e2260;
                                    phi_4288_ = _e2262;
                                } else {
                                    phi_4748_ = _e595;
                                    phi_4284_ = type_46();
                                    phi_4285_ = type_58();
                                    phi_4286_ = u32();
                                    phi_4287_ = bool();
                                    phi_4288_ = u32();
                                }
                                let _e2264 = phi_4748_;
                                let _e2266 = phi_4284_;
                                let _e2268 = phi_4285_;
                                let _e2270 = phi_4286_;
                                let _e2272 = phi_4287_;
                                let _e2274 = phi_4288_;
                                phi_4747_ = _e2264;
                                phi_1011_ = _e2266;
                                phi_1014_ = _e2268;
                                phi_1016_ = _e2270;
                                phi_1018_ = _e2272;
                                phi_1020_ = _e2274;
                                phi_4289_ = _e609;
                            } else {
                                phi_4747_ = _e595;
                                phi_1011_ = type_46();
                                phi_1014_ = type_58();
                                phi_1016_ = u32();
                                phi_1018_ = bool();
                                phi_1020_ = u32();
                                phi_4289_ = false;
                            }
                            let _e2276 = phi_4747_;
                            let _e2278 = phi_1011_;
                            let _e2280 = phi_1014_;
                            let _e2282 = phi_1016_;
                            let _e2284 = phi_1018_;
                            let _e2286 = phi_1020_;
                            let _e2288 = phi_4289_;
                            continue;
                            continuing {
                                phi_4539_ = _e2276;
                                phi_1010_ = _e2278;
                                phi_1013_ = _e2280;
                                phi_1015_ = _e2282;
                                phi_1017_ = _e2284;
                                phi_1019_ = _e2286;
                                phi_4746_ = _e2276;
                                break if !(_e2288);
                            }
                        }
                        let _e2291 = phi_4746_;
                        if _e2291 {
                            break;
                        }
                        let _e2293 = local_11;
                        if _e2293.member_1 {
                        } else {
                            if _e243 {
                            } else {
                                break;
                            }
                            let _e2297 = global_2.member[_e149];
                            if _e164 {
                            } else {
                                break;
                            }
                            let _e2301 = global_9.member[_e149].member_1;
                            if _e243 {
                            } else {
                                break;
                            }
                            global_2.member[_e149] = type_27(_e2297.member, _e2297.member_1, _e2297.member_2, array<f32, 3>((_e2297.member_3[0] + (_e2301[0] * _e2297.member_1[0])), (_e2297.member_3[1] + (_e2301[1] * _e2297.member_1[1])), (_e2297.member_3[2] + (_e2301[2] * _e2297.member_1[2]))), _e2297.member_4);
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
