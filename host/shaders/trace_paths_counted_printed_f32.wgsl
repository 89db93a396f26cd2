struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_14 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_16 {
    member: array<type_14>,
}

struct type_23 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_25 {
    member: array<type_23>,
}

struct type_27 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_28 {
    member: type_27,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_30 {
    member: array<type_28>,
}

struct type_37 {
    member: type_23,
    member_1: f32,
}

struct type_40 {
    member: type_37,
    member_1: u32,
    member_2: u32,
}

struct type_42 {
    member: array<vec4<u32>, 2>,
}

struct type_44 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_46 {
    member: array<type_44>,
}

struct type_50 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_53 {
    member: type_50,
    member_1: u32,
}

struct type_60 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(2) 
var<storage> global_1: type_16;
@group(0) @binding(4) 
var<storage, read_write> global_2: type_25;
@group(0) @binding(0) 
var<uniform> global_3: type_42;
@group(0) @binding(3) 
var<storage> global_4: type_30;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_6: type_60;
@group(0) @binding(1) 
var<storage> global_7: type_46;

fn function_() {
    var local: array<f32, 3>;
    var local_1: array<f32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<type_53, 128>;
    var local_4: array<f32, 3>;
    var local_5: array<f32, 3>;
    var local_6: array<f32, 3>;
    var local_7: array<f32, 3>;
    var local_8: array<u32, 3>;
    var local_9: array<u32, 3>;
    var local_10: array<f32, 3>;
    var local_11: array<f32, 3>;
    var phi_345_: i32;
    var phi_346_: i32;
    var phi_356_: bool;
    var phi_366_: u32;
    var phi_367_: u32;
    var phi_369_: bool;
    var phi_374_: u32;
    var phi_419_: f32;
    var phi_425_: f32;
    var phi_436_: f32;
    var phi_442_: f32;
    var phi_465_: f32;
    var phi_476_: f32;
    var phi_485_: f32;
    var phi_491_: f32;
    var phi_502_: f32;
    var phi_508_: f32;
    var phi_531_: f32;
    var phi_542_: f32;
    var phi_551_: f32;
    var phi_557_: f32;
    var phi_568_: f32;
    var phi_574_: f32;
    var phi_597_: f32;
    var phi_608_: f32;
    var phi_708_: f32;
    var phi_709_: f32;
    var phi_4776_: bool;
    var phi_2846_: type_40;
    var phi_2849_: type_53;
    var phi_2851_: u32;
    var phi_2853_: bool;
    var phi_2855_: u32;
    var phi_2866_: bool;
    var phi_2911_: type_53;
    var phi_2912_: bool;
    var phi_2913_: u32;
    var phi_3718_: type_44;
    var phi_3727_: type_7;
    var phi_3728_: type_7;
    var phi_3751_: type_7;
    var phi_4769_: bool;
    var phi_3881_: type_7;
    var phi_3882_: type_7;
    var phi_3905_: type_7;
    var phi_4825_: bool;
    var phi_4468_: type_53;
    var phi_4507_: type_53;
    var phi_4508_: type_53;
    var phi_4509_: u32;
    var phi_4511_: type_53;
    var phi_4512_: u32;
    var phi_4513_: bool;
    var phi_4520_: type_53;
    var phi_4525_: type_53;
    var phi_4526_: bool;
    var phi_2931_: type_40;
    var phi_2934_: type_7;
    var phi_2935_: type_7;
    var phi_2957_: type_7;
    var phi_2981_: u32;
    var phi_3070_: array<array<f32, 3>, 3>;
    var phi_3541_: vec3<f32>;
    var phi_3542_: vec3<f32>;
    var phi_3573_: bool;
    var phi_3582_: vec3<f32>;
    var phi_3622_: type_23;
    var phi_3624_: type_23;
    var phi_3625_: bool;
    var phi_3629_: type_23;
    var phi_3630_: type_23;
    var phi_3631_: type_23;
    var phi_3632_: bool;
    var phi_3636_: type_23;
    var phi_3637_: bool;
    var phi_3641_: type_23;
    var phi_3642_: bool;
    var phi_3646_: type_23;
    var phi_3671_: bool;
    var phi_3672_: bool;
    var phi_3679_: type_40;
    var phi_3680_: type_40;
    var phi_3681_: type_40;
    var phi_2932_: type_40;
    var phi_4833_: bool;
    var phi_4900_: bool;
    var phi_4528_: type_40;
    var phi_4529_: type_53;
    var phi_4530_: bool;
    var phi_4531_: u32;
    var phi_4899_: bool;
    var phi_4532_: type_40;
    var phi_4533_: type_53;
    var phi_4534_: u32;
    var phi_4535_: bool;
    var phi_4536_: u32;
    var phi_4898_: bool;
    var phi_4537_: type_40;
    var phi_4538_: type_53;
    var phi_4539_: u32;
    var phi_4540_: bool;
    var phi_4541_: u32;
    var phi_4897_: bool;
    var phi_2847_: type_40;
    var phi_2850_: type_53;
    var phi_2852_: u32;
    var phi_2854_: bool;
    var phi_2856_: u32;
    var phi_4542_: bool;
    var phi_4896_: bool;
    var local_12: type_40;
    var phi_4594_: type_23;
    var local_13: type_40;
    var local_14: type_40;

    switch bitcast<i32>(0u) {
        default: {
            let _e82 = global;
            let _e85 = arrayLength((&global_7.member));
            let _e87 = arrayLength((&global_1.member));
            let _e95 = arrayLength((&global_6.member));
            let _e99 = global_3.member[0u][0u];
            let _e103 = global_3.member[0u][1u];
            let _e107 = global_3.member[0u][2u];
            let _e111 = global_3.member[1u][0u];
            let _e115 = global_3.member[1u][1u];
            let _e119 = global_3.member[1u][2u];
            let _e123 = global_3.member[1u][3u];
            let _e127 = (_e82.x + (_e82.y * 2097152u));
            let _e134 = (_e127 < arrayLength((&global_4.member)));
            if _e134 {
                let _e135 = (_e127 < arrayLength((&global_2.member)));
                if _e135 {
                    let _e136 = (_e127 < arrayLength((&global_5.member)));
                    if _e136 {
                        if _e134 {
                        } else {
                            break;
                        }
                        let _e146 = global_4.member[_e127].member.member_2[0u];
                        let _e148 = (bitcast<u32>(_e146) & 2147483647u);
                        let _e154 = global_4.member[_e127].member.member_2[1u];
                        let _e156 = (bitcast<u32>(_e154) & 2147483647u);
                        let _e162 = global_4.member[_e127].member.member_2[2u];
                        let _e164 = (bitcast<u32>(_e162) & 2147483647u);
                        let _e170 = global_4.member[_e127].member.member[0u];
                        let _e172 = (bitcast<u32>(_e170) & 2147483647u);
                        let _e178 = global_4.member[_e127].member.member[1u];
                        let _e180 = (bitcast<u32>(_e178) & 2147483647u);
                        let _e186 = global_4.member[_e127].member.member[2u];
                        let _e188 = (bitcast<u32>(_e186) & 2147483647u);
                        let _e190 = select(_e156, _e148, (_e156 < _e148));
                        let _e192 = select(_e164, _e190, (_e164 < _e190));
                        let _e194 = select(_e172, _e192, (_e172 < _e192));
                        let _e196 = select(_e180, _e194, (_e180 < _e194));
                        let _e198 = select(_e188, _e196, (_e188 < _e196));
                        let _e203 = global_4.member[_e127].member.member_1;
                        let _e205 = (bitcast<u32>(_e203) & 2147483647u);
                        let _e213 = global_4.member[_e127].member.member_3;
                        let _e219 = (((select(_e205, _e198, (_e205 < _e198)) < 2139095040u) && ((bitcast<u32>(_e213) & 2147483647u) <= 2139095040u)) && (_e192 > 0u));
                        if _e219 {
                            let _e222 = (bitcast<u32>(bitcast<f32>(_e192)) & 2147483647u);
                            if (_e222 >= 8388608u) {
                                phi_345_ = (bitcast<i32>((_e222 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_345_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e222)), 32u, (_e222 == 0u))));
                            }
                            let _e236 = phi_345_;
                            phi_346_ = _e236;
                        } else {
                            phi_346_ = 0i;
                        }
                        let _e238 = phi_346_;
                        let _e239 = (_e148 == _e192);
                        if _e239 {
                            phi_356_ = true;
                        } else {
                            phi_356_ = (_e156 == _e192);
                        }
                        let _e242 = phi_356_;
                        let _e243 = select(1u, 0u, _e239);
                        if _e242 {
                            let _e244 = (_e243 + 1u);
                            phi_366_ = _e244;
                            phi_367_ = _e244;
                            phi_369_ = select(true, false, (_e244 == 2u));
                        } else {
                            phi_366_ = u32();
                            phi_367_ = 0u;
                            phi_369_ = true;
                        }
                        let _e248 = phi_366_;
                        let _e250 = phi_367_;
                        let _e252 = phi_369_;
                        if _e252 {
                            phi_374_ = (_e250 + 1u);
                        } else {
                            phi_374_ = 0u;
                        }
                        let _e256 = phi_374_;
                        let _e257 = select(_e248, _e250, _e252);
                        let _e258 = select(_e243, select(2u, _e243, _e242), _e252);
                        let _e259 = -(_e238);
                        let _e260 = (_e259 / 2i);
                        let _e265 = bitcast<f32>((bitcast<u32>((_e260 + 127i)) << bitcast<u32>(23i)));
                        let _e271 = bitcast<f32>((bitcast<u32>(((_e259 - _e260) + 127i)) << bitcast<u32>(23i)));
                        let _e276 = global_4.member[_e127].member.member;
                        let _e277 = (_e257 == 0u);
                        if _e277 {
                            phi_419_ = _e276[0];
                        } else {
                            phi_419_ = _e276[1];
                        }
                        let _e281 = phi_419_;
                        let _e282 = (_e257 == 2u);
                        if _e282 {
                            phi_425_ = _e276[2];
                        } else {
                            phi_425_ = _e281;
                        }
                        let _e285 = phi_425_;
                        let _e286 = global_4.member[_e127].member.member_2;
                        if _e277 {
                            phi_436_ = _e286[0];
                        } else {
                            phi_436_ = _e286[1];
                        }
                        let _e290 = phi_436_;
                        if _e282 {
                            phi_442_ = _e286[2];
                        } else {
                            phi_442_ = _e290;
                        }
                        let _e293 = phi_442_;
                        let _e295 = ((_e293 * _e265) * _e271);
                        let _e299 = (bitcast<f32>((bitcast<u32>(_e295) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e299 {
                            let _e303 = (bitcast<f32>((bitcast<u32>(_e285) & 2147483647u)) * 0.00000011920929f);
                            phi_465_ = select(0.00000000000011368684f, _e303, (_e303 > 0.00000000000011368684f));
                        } else {
                            phi_465_ = 0f;
                        }
                        let _e307 = phi_465_;
                        let _e308 = (_e285 + _e307);
                        let _e309 = (_e285 - _e307);
                        let _e310 = select(_e295, 0f, _e299);
                        if _e299 {
                            phi_476_ = 38685626000000000000000000f;
                        } else {
                            phi_476_ = (1f / _e295);
                        }
                        let _e313 = phi_476_;
                        let _e314 = (_e256 == 0u);
                        if _e314 {
                            phi_485_ = _e276[0];
                        } else {
                            phi_485_ = _e276[1];
                        }
                        let _e318 = phi_485_;
                        let _e319 = (_e256 == 2u);
                        if _e319 {
                            phi_491_ = _e276[2];
                        } else {
                            phi_491_ = _e318;
                        }
                        let _e322 = phi_491_;
                        if _e314 {
                            phi_502_ = _e286[0];
                        } else {
                            phi_502_ = _e286[1];
                        }
                        let _e326 = phi_502_;
                        if _e319 {
                            phi_508_ = _e286[2];
                        } else {
                            phi_508_ = _e326;
                        }
                        let _e329 = phi_508_;
                        let _e331 = ((_e329 * _e265) * _e271);
                        let _e335 = (bitcast<f32>((bitcast<u32>(_e331) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e335 {
                            let _e339 = (bitcast<f32>((bitcast<u32>(_e322) & 2147483647u)) * 0.00000011920929f);
                            phi_531_ = select(0.00000000000011368684f, _e339, (_e339 > 0.00000000000011368684f));
                        } else {
                            phi_531_ = 0f;
                        }
                        let _e343 = phi_531_;
                        let _e344 = (_e322 + _e343);
                        let _e345 = (_e322 - _e343);
                        let _e346 = select(_e331, 0f, _e335);
                        if _e335 {
                            phi_542_ = 38685626000000000000000000f;
                        } else {
                            phi_542_ = (1f / _e331);
                        }
                        let _e349 = phi_542_;
                        let _e350 = (_e258 == 0u);
                        if _e350 {
                            phi_551_ = _e276[0];
                        } else {
                            phi_551_ = _e276[1];
                        }
                        let _e354 = phi_551_;
                        let _e355 = (_e258 == 2u);
                        if _e355 {
                            phi_557_ = _e276[2];
                        } else {
                            phi_557_ = _e354;
                        }
                        let _e358 = phi_557_;
                        if _e350 {
                            phi_568_ = _e286[0];
                        } else {
                            phi_568_ = _e286[1];
                        }
                        let _e362 = phi_568_;
                        if _e355 {
                            phi_574_ = _e286[2];
                        } else {
                            phi_574_ = _e362;
                        }
                        let _e365 = phi_574_;
                        let _e367 = ((_e365 * _e265) * _e271);
                        let _e371 = (bitcast<f32>((bitcast<u32>(_e367) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e371 {
                            let _e375 = (bitcast<f32>((bitcast<u32>(_e358) & 2147483647u)) * 0.00000011920929f);
                            phi_597_ = select(0.00000000000011368684f, _e375, (_e375 > 0.00000000000011368684f));
                        } else {
                            phi_597_ = 0f;
                        }
                        let _e379 = phi_597_;
                        let _e380 = (_e358 + _e379);
                        let _e381 = (_e358 - _e379);
                        let _e382 = select(_e367, 0f, _e371);
                        if _e371 {
                            phi_608_ = 38685626000000000000000000f;
                        } else {
                            phi_608_ = (1f / _e367);
                        }
                        let _e385 = phi_608_;
                        let _e388 = bitcast<f32>((bitcast<u32>(_e285) & 2147483647u));
                        let _e391 = bitcast<f32>((bitcast<u32>(_e322) & 2147483647u));
                        let _e393 = select(_e391, _e388, (_e388 > _e391));
                        let _e396 = bitcast<f32>((bitcast<u32>(_e358) & 2147483647u));
                        if (_e219 && (select(_e396, _e393, (_e393 > _e396)) <= 1099511600000f)) {
                            let _e401 = (_e238 / 3i);
                            let _e408 = bitcast<f32>((bitcast<u32>((_e401 + 127i)) << bitcast<u32>(23i)));
                            let _e415 = bitcast<f32>((bitcast<u32>(((_e238 - (2i * _e401)) + 127i)) << bitcast<u32>(23i)));
                            let _e416 = (((_e203 * _e408) * _e408) * _e415);
                            let _e418 = select(340282350000000000000000000000000000000f, _e416, (_e416 < 340282350000000000000000000000000000000f));
                            let _e423 = (((_e213 * _e408) * _e408) * _e415);
                            let _e425 = select(340282350000000000000000000000000000000f, _e423, (_e423 < 340282350000000000000000000000000000000f));
                            phi_708_ = select(-340282350000000000000000000000000000000f, _e425, (_e425 > -340282350000000000000000000000000000000f));
                            phi_709_ = select(-340282350000000000000000000000000000000f, _e418, (_e418 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_708_ = 0f;
                            phi_709_ = 1f;
                        }
                        let _e429 = phi_708_;
                        let _e431 = phi_709_;
                        if _e134 {
                        } else {
                            break;
                        }
                        let _e437 = global_4.member[_e127].member_2;
                        local_3 = array<type_53, 128>(type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u));
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_11 = array<f32, 3>(bitcast<f32>(_e99), bitcast<f32>(_e103), bitcast<f32>(_e107));
                        let _e441 = (_e257 % 3u);
                        let _e442 = (_e441 < 3u);
                        if _e442 {
                        } else {
                            break;
                        }
                        let _e444 = local_11[_e441];
                        let _e445 = (_e256 % 3u);
                        let _e446 = (_e445 < 3u);
                        if _e446 {
                        } else {
                            break;
                        }
                        let _e448 = local_11[_e445];
                        let _e449 = (_e258 % 3u);
                        let _e450 = (_e449 < 3u);
                        if _e450 {
                        } else {
                            break;
                        }
                        let _e452 = local_11[_e449];
                        local_10 = array<f32, 3>(bitcast<f32>(_e111), bitcast<f32>(_e115), bitcast<f32>(_e119));
                        if _e442 {
                        } else {
                            break;
                        }
                        let _e456 = local_10[_e441];
                        if _e446 {
                        } else {
                            break;
                        }
                        let _e458 = local_10[_e445];
                        if _e450 {
                        } else {
                            break;
                        }
                        let _e460 = local_10[_e449];
                        phi_4776_ = false;
                        phi_2846_ = type_40(type_37(type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e429), 0u, 0u);
                        phi_2849_ = type_53(type_50(array<f32, 3>(_e444, _e448, _e452), array<f32, 3>(_e456, _e458, _e460)), select(0u, 2147483648u, (_e85 == 0u)));
                        phi_2851_ = ((3u * _e85) + 1u);
                        phi_2853_ = (_e431 <= _e429);
                        phi_2855_ = 0u;
                        loop {
                            let _e468 = phi_4776_;
                            let _e470 = phi_2846_;
                            let _e472 = phi_2849_;
                            let _e474 = phi_2851_;
                            let _e476 = phi_2853_;
                            let _e478 = phi_2855_;
                            local_12 = _e470;
                            local_13 = _e470;
                            if _e476 {
                                phi_2866_ = true;
                            } else {
                                phi_2866_ = (_e478 > 0u);
                            }
                            let _e481 = phi_2866_;
                            if _e481 {
                                let _e482 = (_e474 > 0u);
                                if _e482 {
                                    if _e476 {
                                        phi_2911_ = _e472;
                                        phi_2912_ = _e476;
                                        phi_2913_ = _e478;
                                    } else {
                                        let _e483 = (_e478 - 1u);
                                        let _e484 = (_e483 % 128u);
                                        let _e485 = (_e484 < 128u);
                                        if _e485 {
                                        } else {
                                            phi_4896_ = true;
                                            break;
                                        }
                                        let _e487 = local_3[_e484];
                                        if _e485 {
                                        } else {
                                            phi_4896_ = true;
                                            break;
                                        }
                                        let _e503 = local_2[_e484];
                                        phi_2911_ = type_53(type_50(array<f32, 3>(_e487.member.member[0], _e487.member.member[1], _e487.member.member[2]), array<f32, 3>(_e487.member.member_1[0], _e487.member.member_1[1], _e487.member.member_1[2])), _e487.member_1);
                                        phi_2912_ = (_e503 <= _e470.member.member_1);
                                        phi_2913_ = _e483;
                                    }
                                    let _e508 = phi_2911_;
                                    let _e510 = phi_2912_;
                                    let _e512 = phi_2913_;
                                    if _e510 {
                                        if ((_e508.member_1 & 2147483648u) != 0u) {
                                            phi_2931_ = _e470;
                                            phi_2934_ = type_7(0u, ((_e508.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e841 = phi_2931_;
                                                let _e843 = phi_2934_;
                                                local_14 = _e841;
                                                if (_e843.member < _e843.member_1) {
                                                    phi_2935_ = type_7((_e843.member + 1u), _e843.member_1);
                                                    phi_2957_ = type_7(1u, _e843.member);
                                                } else {
                                                    phi_2935_ = _e843;
                                                    phi_2957_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e856 = phi_2935_;
                                                let _e858 = phi_2957_;
                                                let _e862 = (bitcast<i32>(_e858.member) != 0i);
                                                if _e862 {
                                                    let _e868 = type_40(_e841.member, _e841.member_1, (_e841.member_2 + 1u));
                                                    let _e869 = ((_e508.member_1 & 268435455u) + _e858.member_1);
                                                    let _e870 = (_e869 < _e87);
                                                    if _e870 {
                                                        if _e870 {
                                                        } else {
                                                            phi_4833_ = true;
                                                            break;
                                                        }
                                                        let _e874 = global_1.member[_e869].member_1;
                                                        phi_2981_ = _e874;
                                                    } else {
                                                        phi_2981_ = 4294967295u;
                                                    }
                                                    let _e876 = phi_2981_;
                                                    if (_e869 >= _e87) {
                                                        phi_3070_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e870 {
                                                        } else {
                                                            phi_4833_ = true;
                                                            break;
                                                        }
                                                        if (_e441 < 9u) {
                                                        } else {
                                                            phi_4833_ = true;
                                                            break;
                                                        }
                                                        let _e883 = global_1.member[_e869].member[_e441];
                                                        if (_e445 < 9u) {
                                                        } else {
                                                            phi_4833_ = true;
                                                            break;
                                                        }
                                                        let _e889 = global_1.member[_e869].member[_e445];
                                                        if (_e449 < 9u) {
                                                        } else {
                                                            phi_4833_ = true;
                                                            break;
                                                        }
                                                        let _e895 = global_1.member[_e869].member[_e449];
                                                        let _e897 = (3u + _e441);
                                                        if (_e897 < 9u) {
                                                        } else {
                                                            phi_4833_ = true;
                                                            break;
                                                        }
                                                        let _e903 = global_1.member[_e869].member[_e897];
                                                        let _e904 = (3u + _e445);
                                                        if (_e904 < 9u) {
                                                        } else {
                                                            phi_4833_ = true;
                                                            break;
                                                        }
                                                        let _e910 = global_1.member[_e869].member[_e904];
                                                        let _e911 = (3u + _e449);
                                                        if (_e911 < 9u) {
                                                        } else {
                                                            phi_4833_ = true;
                                                            break;
                                                        }
                                                        let _e917 = global_1.member[_e869].member[_e911];
                                                        let _e919 = (6u + _e441);
                                                        if (_e919 < 9u) {
                                                        } else {
                                                            phi_4833_ = true;
                                                            break;
                                                        }
                                                        let _e925 = global_1.member[_e869].member[_e919];
                                                        let _e926 = (6u + _e445);
                                                        if (_e926 < 9u) {
                                                        } else {
                                                            phi_4833_ = true;
                                                            break;
                                                        }
                                                        let _e932 = global_1.member[_e869].member[_e926];
                                                        let _e933 = (6u + _e449);
                                                        if (_e933 < 9u) {
                                                        } else {
                                                            phi_4833_ = true;
                                                            break;
                                                        }
                                                        let _e939 = global_1.member[_e869].member[_e933];
                                                        phi_3070_ = array<array<f32, 3>, 3>(array<f32, 3>(_e883, _e889, _e895), array<f32, 3>(_e903, _e910, _e917), array<f32, 3>(_e925, _e932, _e939));
                                                    }
                                                    let _e943 = phi_3070_;
                                                    let _e952 = (_e943[0][2] - _e358);
                                                    let _e955 = (((_e943[0][0] - _e285) * _e382) - (_e952 * _e310));
                                                    let _e958 = (((_e943[0][1] - _e322) * _e382) - (_e952 * _e346));
                                                    let _e965 = (_e943[1][2] - _e358);
                                                    let _e968 = (((_e943[1][0] - _e285) * _e382) - (_e965 * _e310));
                                                    let _e971 = (((_e943[1][1] - _e322) * _e382) - (_e965 * _e346));
                                                    let _e978 = (_e943[2][2] - _e358);
                                                    let _e981 = (((_e943[2][0] - _e285) * _e382) - (_e978 * _e310));
                                                    let _e984 = (((_e943[2][1] - _e322) * _e382) - (_e978 * _e346));
                                                    let _e985 = (_e981 * _e971);
                                                    let _e986 = (_e984 * _e968);
                                                    let _e987 = (_e955 * _e984);
                                                    let _e988 = (_e958 * _e981);
                                                    let _e989 = (_e968 * _e958);
                                                    let _e990 = (_e971 * _e955);
                                                    let _e995 = (((_e985 >= _e986) && (_e987 >= _e988)) && (_e989 >= _e990));
                                                    if (_e995 || (((_e985 <= _e986) && (_e987 <= _e988)) && (_e989 <= _e990))) {
                                                        let _e1002 = select(-1f, 1f, _e995);
                                                        let _e1004 = ((_e985 - _e986) * _e1002);
                                                        let _e1006 = select(0f, _e1004, (_e1004 > 0f));
                                                        let _e1008 = ((_e987 - _e988) * _e1002);
                                                        let _e1010 = select(0f, _e1008, (_e1008 > 0f));
                                                        let _e1012 = ((_e989 - _e990) * _e1002);
                                                        let _e1014 = select(0f, _e1012, (_e1012 > 0f));
                                                        let _e1016 = ((_e1006 + _e1010) + _e1014);
                                                        if (_e1016 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_3636_ = type_23();
                                                            phi_3637_ = true;
                                                        } else {
                                                            let _e1019 = select(_e943[1][0], _e943[0][0], (_e943[0][0] < _e943[1][0]));
                                                            let _e1023 = select(_e943[1][0], _e943[0][0], (_e943[0][0] > _e943[1][0]));
                                                            let _e1027 = select(_e943[1][1], _e943[0][1], (_e943[0][1] < _e943[1][1]));
                                                            let _e1031 = select(_e943[1][1], _e943[0][1], (_e943[0][1] > _e943[1][1]));
                                                            let _e1035 = select(_e943[1][2], _e943[0][2], (_e943[0][2] < _e943[1][2]));
                                                            let _e1039 = select(_e943[1][2], _e943[0][2], (_e943[0][2] > _e943[1][2]));
                                                            let _e1044 = ((select(_e943[2][0], _e1019, (_e1019 < _e943[2][0])) - _e308) * _e313);
                                                            let _e1045 = ((select(_e943[2][0], _e1023, (_e1023 > _e943[2][0])) - _e309) * _e313);
                                                            let _e1048 = ((select(_e943[2][1], _e1027, (_e1027 < _e943[2][1])) - _e344) * _e349);
                                                            let _e1049 = ((select(_e943[2][1], _e1031, (_e1031 > _e943[2][1])) - _e345) * _e349);
                                                            let _e1052 = ((select(_e943[2][2], _e1035, (_e1035 < _e943[2][2])) - _e380) * _e385);
                                                            let _e1053 = ((select(_e943[2][2], _e1039, (_e1039 > _e943[2][2])) - _e381) * _e385);
                                                            let _e1055 = select(_e1053, _e1052, (_e1052 < _e1053));
                                                            let _e1057 = select(_e1053, _e1052, (_e1052 > _e1053));
                                                            let _e1059 = select(_e1045, _e1044, (_e1044 < _e1045));
                                                            let _e1061 = select(_e1049, _e1048, (_e1048 < _e1049));
                                                            let _e1063 = select(_e1061, _e1059, (_e1059 > _e1061));
                                                            let _e1065 = select(_e1055, _e1063, (_e1063 > _e1055));
                                                            let _e1067 = select(_e1045, _e1044, (_e1044 > _e1045));
                                                            let _e1069 = select(_e1049, _e1048, (_e1048 > _e1049));
                                                            let _e1071 = select(_e1069, _e1067, (_e1067 < _e1069));
                                                            let _e1073 = select(_e1057, _e1071, (_e1071 < _e1057));
                                                            let _e1074 = -(_e1055);
                                                            let _e1080 = select(_e431, _e1065, (_e1065 > _e431));
                                                            if (_e1080 > (_e1073 + (select(_e1074, _e1057, (_e1057 > _e1074)) * 0.0000019073523f))) {
                                                                phi_3631_ = type_23();
                                                                phi_3632_ = true;
                                                            } else {
                                                                let _e1082 = (_e1080 > _e841.member.member_1);
                                                                if _e1082 {
                                                                    phi_3630_ = type_23();
                                                                } else {
                                                                    let _e1086 = (_e943[1][0] - _e943[0][0]);
                                                                    let _e1087 = (_e943[1][1] - _e943[0][1]);
                                                                    let _e1088 = (_e943[1][2] - _e943[0][2]);
                                                                    let _e1089 = vec3<f32>(_e1086, _e1087, _e1088);
                                                                    let _e1090 = (_e943[2][0] - _e943[1][0]);
                                                                    let _e1091 = (_e943[2][1] - _e943[1][1]);
                                                                    let _e1092 = (_e943[2][2] - _e943[1][2]);
                                                                    let _e1093 = vec3<f32>(_e1090, _e1091, _e1092);
                                                                    let _e1094 = (_e943[0][0] - _e943[2][0]);
                                                                    let _e1095 = (_e943[0][1] - _e943[2][1]);
                                                                    let _e1096 = (_e943[0][2] - _e943[2][2]);
                                                                    let _e1097 = vec3<f32>(_e1094, _e1095, _e1096);
                                                                    let _e1100 = bitcast<f32>((bitcast<u32>(_e1086) & 2147483647u));
                                                                    let _e1103 = bitcast<f32>((bitcast<u32>(_e1087) & 2147483647u));
                                                                    let _e1105 = select(_e1103, _e1100, (_e1100 > _e1103));
                                                                    let _e1108 = bitcast<f32>((bitcast<u32>(_e1088) & 2147483647u));
                                                                    let _e1110 = select(_e1108, _e1105, (_e1105 > _e1108));
                                                                    let _e1113 = bitcast<f32>((bitcast<u32>(_e1090) & 2147483647u));
                                                                    let _e1116 = bitcast<f32>((bitcast<u32>(_e1091) & 2147483647u));
                                                                    let _e1118 = select(_e1116, _e1113, (_e1113 > _e1116));
                                                                    let _e1121 = bitcast<f32>((bitcast<u32>(_e1092) & 2147483647u));
                                                                    let _e1123 = select(_e1121, _e1118, (_e1118 > _e1121));
                                                                    let _e1126 = bitcast<f32>((bitcast<u32>(_e1094) & 2147483647u));
                                                                    let _e1129 = bitcast<f32>((bitcast<u32>(_e1095) & 2147483647u));
                                                                    let _e1131 = select(_e1129, _e1126, (_e1126 > _e1129));
                                                                    let _e1134 = bitcast<f32>((bitcast<u32>(_e1096) & 2147483647u));
                                                                    let _e1136 = select(_e1134, _e1131, (_e1131 > _e1134));
                                                                    let _e1138 = select(_e1123, _e1110, (_e1110 > _e1123));
                                                                    let _e1140 = select(_e1136, _e1138, (_e1138 > _e1136));
                                                                    if (_e1110 == _e1140) {
                                                                        phi_3541_ = _e1093;
                                                                        phi_3542_ = _e1097;
                                                                    } else {
                                                                        let _e1143 = vec3((_e1123 == _e1140));
                                                                        phi_3541_ = select(_e1089, _e1097, _e1143);
                                                                        phi_3542_ = select(_e1093, _e1089, _e1143);
                                                                    }
                                                                    let _e1147 = phi_3541_;
                                                                    let _e1149 = phi_3542_;
                                                                    let _e1156 = ((_e1147.y * _e1149.z) - (_e1149.y * _e1147.z));
                                                                    let _e1161 = ((_e1147.z * _e1149.x) - (_e1149.z * _e1147.x));
                                                                    let _e1164 = ((_e1147.x * _e1149.y) - (_e1149.x * _e1147.y));
                                                                    if (_e1006 >= _e1010) {
                                                                        phi_3573_ = select(true, false, (_e1006 >= _e1014));
                                                                    } else {
                                                                        phi_3573_ = true;
                                                                    }
                                                                    let _e1169 = phi_3573_;
                                                                    if _e1169 {
                                                                        phi_3582_ = select(vec3<f32>(_e943[2][0], _e943[2][1], _e943[2][2]), vec3<f32>(_e943[1][0], _e943[1][1], _e943[1][2]), vec3((_e1010 >= _e1014)));
                                                                    } else {
                                                                        phi_3582_ = vec3<f32>(_e943[0][0], _e943[0][1], _e943[0][2]);
                                                                    }
                                                                    let _e1174 = phi_3582_;
                                                                    let _e1191 = ((((_e1156 * (_e1174.x - _e285)) + (_e1161 * (_e1174.y - _e322))) + (_e1164 * (_e1174.z - _e358))) / (((_e1156 * _e310) + (_e1161 * _e346)) + (_e1164 * _e382)));
                                                                    let _e1193 = select(_e1073, _e1191, (_e1191 < _e1073));
                                                                    let _e1195 = select(_e1065, _e1193, (_e1193 > _e1065));
                                                                    if (_e1195 >= _e431) {
                                                                        let _e1197 = (_e1195 <= _e841.member.member_1);
                                                                        if _e1197 {
                                                                            let _e1198 = (1f / _e1016);
                                                                            phi_3622_ = type_23(_e1195, (_e1010 * _e1198), (_e1014 * _e1198), _e876);
                                                                        } else {
                                                                            phi_3622_ = type_23();
                                                                        }
                                                                        let _e1203 = phi_3622_;
                                                                        phi_3624_ = _e1203;
                                                                        phi_3625_ = select(true, false, _e1197);
                                                                    } else {
                                                                        phi_3624_ = type_23();
                                                                        phi_3625_ = true;
                                                                    }
                                                                    let _e1206 = phi_3624_;
                                                                    let _e1208 = phi_3625_;
                                                                    if _e1208 {
                                                                        phi_3629_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_3629_ = _e1206;
                                                                    }
                                                                    let _e1210 = phi_3629_;
                                                                    phi_3630_ = _e1210;
                                                                }
                                                                let _e1212 = phi_3630_;
                                                                phi_3631_ = _e1212;
                                                                phi_3632_ = _e1082;
                                                            }
                                                            let _e1214 = phi_3631_;
                                                            let _e1216 = phi_3632_;
                                                            phi_3636_ = _e1214;
                                                            phi_3637_ = _e1216;
                                                        }
                                                        let _e1218 = phi_3636_;
                                                        let _e1220 = phi_3637_;
                                                        phi_3641_ = _e1218;
                                                        phi_3642_ = _e1220;
                                                    } else {
                                                        phi_3641_ = type_23();
                                                        phi_3642_ = true;
                                                    }
                                                    let _e1222 = phi_3641_;
                                                    let _e1224 = phi_3642_;
                                                    if _e1224 {
                                                        phi_3646_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_3646_ = _e1222;
                                                    }
                                                    let _e1226 = phi_3646_;
                                                    if (_e1226.member_3 != 4294967295u) {
                                                        if (_e876 != _e437) {
                                                            if (_e1226.member < _e841.member.member.member) {
                                                                phi_3672_ = true;
                                                            } else {
                                                                if (_e1226.member == _e841.member.member.member) {
                                                                    phi_3671_ = (_e1226.member_3 < _e841.member.member.member_3);
                                                                } else {
                                                                    phi_3671_ = false;
                                                                }
                                                                let _e1241 = phi_3671_;
                                                                phi_3672_ = _e1241;
                                                            }
                                                            let _e1243 = phi_3672_;
                                                            if _e1243 {
                                                                phi_3679_ = type_40(type_37(_e1226, _e1226.member), _e868.member_1, _e868.member_2);
                                                            } else {
                                                                phi_3679_ = _e868;
                                                            }
                                                            let _e1250 = phi_3679_;
                                                            phi_3680_ = _e1250;
                                                        } else {
                                                            phi_3680_ = _e868;
                                                        }
                                                        let _e1252 = phi_3680_;
                                                        phi_3681_ = _e1252;
                                                    } else {
                                                        phi_3681_ = _e868;
                                                    }
                                                    let _e1254 = phi_3681_;
                                                    phi_2932_ = _e1254;
                                                } else {
                                                    phi_2932_ = type_40();
                                                }
                                                let _e1256 = phi_2932_;
                                                continue;
                                                continuing {
                                                    phi_2931_ = _e1256;
                                                    phi_2934_ = _e856;
                                                    phi_4833_ = _e468;
                                                    break if !(_e862);
                                                }
                                            }
                                            let _e1259 = phi_4833_;
                                            phi_4896_ = _e1259;
                                            if _e1259 {
                                                break;
                                            }
                                            phi_4900_ = _e1259;
                                            let _e1476 = local_14;
                                            phi_4528_ = _e1476;
                                            phi_4529_ = _e508;
                                            phi_4530_ = false;
                                            phi_4531_ = _e512;
                                        } else {
                                            local_1 = array<f32, 3>(_e508.member.member[0], _e508.member.member[1], _e508.member.member[2]);
                                            local = array<f32, 3>(_e508.member.member_1[0], _e508.member.member_1[1], _e508.member.member_1[2]);
                                            let _e538 = (_e508.member_1 < _e85);
                                            if _e538 {
                                                if _e538 {
                                                } else {
                                                    phi_4896_ = true;
                                                    break;
                                                }
                                                let _e540 = global_7.member[_e508.member_1];
                                                phi_3718_ = _e540;
                                            } else {
                                                phi_3718_ = type_44(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e542 = phi_3718_;
                                            let _e544 = array<u32, 3>(_e257, _e256, _e258);
                                            local_9 = _e544;
                                            local_5 = array<f32, 3>(0f, 0f, 0f);
                                            local_4 = array<f32, 3>(0f, 0f, 0f);
                                            phi_3727_ = type_7(0u, 3u);
                                            loop {
                                                let _e546 = phi_3727_;
                                                if (_e546.member < _e546.member_1) {
                                                    phi_3728_ = type_7((_e546.member + 1u), _e546.member_1);
                                                    phi_3751_ = type_7(1u, _e546.member);
                                                } else {
                                                    phi_3728_ = _e546;
                                                    phi_3751_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e559 = phi_3728_;
                                                let _e561 = phi_3751_;
                                                let _e565 = (bitcast<i32>(_e561.member) != 0i);
                                                if _e565 {
                                                    let _e566 = (_e561.member_1 < 3u);
                                                    if _e566 {
                                                    } else {
                                                        phi_4769_ = true;
                                                        break;
                                                    }
                                                    let _e568 = local_9[_e561.member_1];
                                                    if _e566 {
                                                    } else {
                                                        phi_4769_ = true;
                                                        break;
                                                    }
                                                    let _e570 = local_1[_e561.member_1];
                                                    if _e566 {
                                                    } else {
                                                        phi_4769_ = true;
                                                        break;
                                                    }
                                                    let _e572 = local[_e561.member_1];
                                                    let _e575 = ((10u * _e568) & 31u);
                                                    let _e578 = ((_e542.member[0] >> bitcast<u32>(_e575)) & 1023u);
                                                    let _e583 = bitcast<f32>((bitcast<u32>(((_e572 - _e570) * 0.0009775171f)) ^ _e123));
                                                    let _e589 = (_e570 + bitcast<f32>((bitcast<u32>((f32(_e578) * _e583)) ^ _e123)));
                                                    if _e566 {
                                                    } else {
                                                        phi_4769_ = true;
                                                        break;
                                                    }
                                                    local_5[_e561.member_1] = select(select(_e572, _e589, (_e589 < _e572)), _e572, (_e578 == 1023u));
                                                    let _e598 = ((_e542.member[1] >> bitcast<u32>(_e575)) & 1023u);
                                                    let _e604 = (_e570 + bitcast<f32>((bitcast<u32>((f32(_e598) * _e583)) ^ _e123)));
                                                    if _e566 {
                                                    } else {
                                                        phi_4769_ = true;
                                                        break;
                                                    }
                                                    local_4[_e561.member_1] = select(select(_e572, _e604, (_e604 < _e572)), _e572, (_e598 == 1023u));
                                                }
                                                continue;
                                                continuing {
                                                    phi_3727_ = _e559;
                                                    phi_4769_ = _e468;
                                                    break if !(_e565);
                                                }
                                            }
                                            let _e612 = phi_4769_;
                                            phi_4896_ = _e612;
                                            if _e612 {
                                                break;
                                            }
                                            let _e613 = local_4;
                                            let _e614 = local_5;
                                            local_8 = _e544;
                                            local_7 = array<f32, 3>(0f, 0f, 0f);
                                            local_6 = array<f32, 3>(0f, 0f, 0f);
                                            phi_3881_ = type_7(0u, 3u);
                                            loop {
                                                let _e623 = phi_3881_;
                                                if (_e623.member < _e623.member_1) {
                                                    phi_3882_ = type_7((_e623.member + 1u), _e623.member_1);
                                                    phi_3905_ = type_7(1u, _e623.member);
                                                } else {
                                                    phi_3882_ = _e623;
                                                    phi_3905_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e636 = phi_3882_;
                                                let _e638 = phi_3905_;
                                                let _e642 = (bitcast<i32>(_e638.member) != 0i);
                                                if _e642 {
                                                    let _e643 = (_e638.member_1 < 3u);
                                                    if _e643 {
                                                    } else {
                                                        phi_4825_ = true;
                                                        break;
                                                    }
                                                    let _e645 = local_8[_e638.member_1];
                                                    if _e643 {
                                                    } else {
                                                        phi_4825_ = true;
                                                        break;
                                                    }
                                                    let _e647 = local_1[_e638.member_1];
                                                    if _e643 {
                                                    } else {
                                                        phi_4825_ = true;
                                                        break;
                                                    }
                                                    let _e649 = local[_e638.member_1];
                                                    let _e652 = ((10u * _e645) & 31u);
                                                    let _e655 = ((_e542.member_1[0] >> bitcast<u32>(_e652)) & 1023u);
                                                    let _e660 = bitcast<f32>((bitcast<u32>(((_e649 - _e647) * 0.0009775171f)) ^ _e123));
                                                    let _e666 = (_e647 + bitcast<f32>((bitcast<u32>((f32(_e655) * _e660)) ^ _e123)));
                                                    if _e643 {
                                                    } else {
                                                        phi_4825_ = true;
                                                        break;
                                                    }
                                                    local_7[_e638.member_1] = select(select(_e649, _e666, (_e666 < _e649)), _e649, (_e655 == 1023u));
                                                    let _e675 = ((_e542.member_1[1] >> bitcast<u32>(_e652)) & 1023u);
                                                    let _e681 = (_e647 + bitcast<f32>((bitcast<u32>((f32(_e675) * _e660)) ^ _e123)));
                                                    if _e643 {
                                                    } else {
                                                        phi_4825_ = true;
                                                        break;
                                                    }
                                                    local_6[_e638.member_1] = select(select(_e649, _e681, (_e681 < _e649)), _e649, (_e675 == 1023u));
                                                }
                                                continue;
                                                continuing {
                                                    phi_3881_ = _e636;
                                                    phi_4825_ = _e612;
                                                    break if !(_e642);
                                                }
                                            }
                                            let _e689 = phi_4825_;
                                            phi_4896_ = _e689;
                                            if _e689 {
                                                break;
                                            }
                                            let _e690 = local_6;
                                            let _e691 = local_7;
                                            let _e702 = type_53(type_50(array<f32, 3>(_e614[0], _e614[1], _e614[2]), array<f32, 3>(_e613[0], _e613[1], _e613[2])), _e542.member_2);
                                            let _e707 = type_53(type_50(array<f32, 3>(_e691[0], _e691[1], _e691[2]), array<f32, 3>(_e690[0], _e690[1], _e690[2])), _e542.member_3);
                                            let _e714 = ((_e614[0] - _e308) * _e313);
                                            let _e715 = ((_e691[0] - _e308) * _e313);
                                            let _e716 = ((_e613[0] - _e309) * _e313);
                                            let _e717 = ((_e690[0] - _e309) * _e313);
                                            let _e722 = ((_e614[1] - _e344) * _e349);
                                            let _e723 = ((_e691[1] - _e344) * _e349);
                                            let _e724 = ((_e613[1] - _e345) * _e349);
                                            let _e725 = ((_e690[1] - _e345) * _e349);
                                            let _e730 = ((_e614[2] - _e380) * _e385);
                                            let _e731 = ((_e691[2] - _e380) * _e385);
                                            let _e732 = ((_e613[2] - _e381) * _e385);
                                            let _e733 = ((_e690[2] - _e381) * _e385);
                                            let _e735 = select(_e732, _e730, (_e730 < _e732));
                                            let _e737 = select(_e733, _e731, (_e731 < _e733));
                                            let _e739 = select(_e732, _e730, (_e730 > _e732));
                                            let _e741 = select(_e733, _e731, (_e731 > _e733));
                                            let _e743 = select(_e716, _e714, (_e714 < _e716));
                                            let _e745 = select(_e717, _e715, (_e715 < _e717));
                                            let _e747 = select(_e724, _e722, (_e722 < _e724));
                                            let _e749 = select(_e725, _e723, (_e723 < _e725));
                                            let _e751 = select(_e747, _e743, (_e743 > _e747));
                                            let _e753 = select(_e749, _e745, (_e745 > _e749));
                                            let _e755 = select(_e735, _e751, (_e751 > _e735));
                                            let _e757 = select(_e737, _e753, (_e753 > _e737));
                                            let _e759 = select(_e716, _e714, (_e714 > _e716));
                                            let _e761 = select(_e717, _e715, (_e715 > _e717));
                                            let _e763 = select(_e724, _e722, (_e722 > _e724));
                                            let _e765 = select(_e725, _e723, (_e723 > _e725));
                                            let _e767 = select(_e763, _e759, (_e759 < _e763));
                                            let _e769 = select(_e765, _e761, (_e761 < _e765));
                                            let _e774 = -(_e735);
                                            let _e775 = -(_e737);
                                            let _e782 = (select(_e739, _e767, (_e767 < _e739)) + (select(_e774, _e739, (_e739 > _e774)) * 0.0000019073523f));
                                            let _e783 = (select(_e741, _e769, (_e769 < _e741)) + (select(_e775, _e741, (_e741 > _e775)) * 0.0000019073523f));
                                            let _e785 = select(_e431, _e755, (_e755 > _e431));
                                            let _e787 = select(_e431, _e757, (_e757 > _e431));
                                            let _e792 = (_e785 <= select(_e470.member.member_1, _e782, (_e782 < _e470.member.member_1)));
                                            let _e793 = (_e787 <= select(_e470.member.member_1, _e783, (_e783 < _e470.member.member_1)));
                                            let _e794 = (_e785 <= _e787);
                                            if _e792 {
                                                if _e793 {
                                                    if _e794 {
                                                        phi_4468_ = _e707;
                                                    } else {
                                                        phi_4468_ = _e702;
                                                    }
                                                    let _e796 = phi_4468_;
                                                    let _e797 = (_e512 % 128u);
                                                    let _e798 = (_e797 < 128u);
                                                    if _e798 {
                                                    } else {
                                                        phi_4896_ = true;
                                                        break;
                                                    }
                                                    local_3[_e797] = type_53(type_50(array<f32, 3>(_e796.member.member[0], _e796.member.member[1], _e796.member.member[2]), array<f32, 3>(_e796.member.member_1[0], _e796.member.member_1[1], _e796.member.member_1[2])), _e796.member_1);
                                                    if _e798 {
                                                    } else {
                                                        phi_4896_ = true;
                                                        break;
                                                    }
                                                    local_2[_e797] = select(_e787, _e785, (_e785 > _e787));
                                                    if _e794 {
                                                        phi_4507_ = _e702;
                                                    } else {
                                                        phi_4507_ = _e707;
                                                    }
                                                    let _e819 = phi_4507_;
                                                    phi_4508_ = _e819;
                                                    phi_4509_ = (_e512 + 1u);
                                                } else {
                                                    phi_4508_ = type_53();
                                                    phi_4509_ = u32();
                                                }
                                                let _e821 = phi_4508_;
                                                let _e823 = phi_4509_;
                                                phi_4511_ = _e821;
                                                phi_4512_ = _e823;
                                                phi_4513_ = select(true, false, _e793);
                                            } else {
                                                phi_4511_ = type_53();
                                                phi_4512_ = u32();
                                                phi_4513_ = true;
                                            }
                                            let _e826 = phi_4511_;
                                            let _e828 = phi_4512_;
                                            let _e830 = phi_4513_;
                                            if _e830 {
                                                if _e792 {
                                                    phi_4520_ = _e702;
                                                } else {
                                                    phi_4520_ = _e707;
                                                }
                                                let _e832 = phi_4520_;
                                                phi_4525_ = _e832;
                                                phi_4526_ = select(_e793, true, _e792);
                                            } else {
                                                phi_4525_ = _e826;
                                                phi_4526_ = _e510;
                                            }
                                            let _e835 = phi_4525_;
                                            let _e837 = phi_4526_;
                                            phi_4900_ = _e689;
                                            phi_4528_ = type_40(_e470.member, (_e470.member_1 + 1u), _e470.member_2);
                                            phi_4529_ = _e835;
                                            phi_4530_ = _e837;
                                            phi_4531_ = select(_e828, _e512, _e830);
                                        }
                                        let _e1261 = phi_4900_;
                                        let _e1263 = phi_4528_;
                                        let _e1265 = phi_4529_;
                                        let _e1267 = phi_4530_;
                                        let _e1269 = phi_4531_;
                                        phi_4899_ = _e1261;
                                        phi_4532_ = _e1263;
                                        phi_4533_ = _e1265;
                                        phi_4534_ = (_e474 - 1u);
                                        phi_4535_ = _e1267;
                                        phi_4536_ = _e1269;
                                    } else {
                                        phi_4899_ = _e468;
                                        phi_4532_ = _e470;
                                        phi_4533_ = _e508;
                                        phi_4534_ = _e474;
                                        phi_4535_ = _e510;
                                        phi_4536_ = _e512;
                                    }
                                    let _e1271 = phi_4899_;
                                    let _e1273 = phi_4532_;
                                    let _e1275 = phi_4533_;
                                    let _e1277 = phi_4534_;
                                    let _e1279 = phi_4535_;
                                    let _e1281 = phi_4536_;
                                    phi_4898_ = _e1271;
                                    phi_4537_ = _e1273;
                                    phi_4538_ = _e1275;
                                    phi_4539_ = _e1277;
                                    phi_4540_ = _e1279;
                                    phi_4541_ = _e1281;
                                } else {
                                    phi_4898_ = _e468;
                                    phi_4537_ = type_40();
                                    phi_4538_ = type_53();
                                    phi_4539_ = u32();
                                    phi_4540_ = bool();
                                    phi_4541_ = u32();
                                }
                                let _e1283 = phi_4898_;
                                let _e1285 = phi_4537_;
                                let _e1287 = phi_4538_;
                                let _e1289 = phi_4539_;
                                let _e1291 = phi_4540_;
                                let _e1293 = phi_4541_;
                                phi_4897_ = _e1283;
                                phi_2847_ = _e1285;
                                phi_2850_ = _e1287;
                                phi_2852_ = _e1289;
                                phi_2854_ = _e1291;
                                phi_2856_ = _e1293;
                                phi_4542_ = _e482;
                            } else {
                                phi_4897_ = _e468;
                                phi_2847_ = type_40();
                                phi_2850_ = type_53();
                                phi_2852_ = u32();
                                phi_2854_ = bool();
                                phi_2856_ = u32();
                                phi_4542_ = false;
                            }
                            let _e1295 = phi_4897_;
                            let _e1297 = phi_2847_;
                            let _e1299 = phi_2850_;
                            let _e1301 = phi_2852_;
                            let _e1303 = phi_2854_;
                            let _e1305 = phi_2856_;
                            let _e1307 = phi_4542_;
                            continue;
                            continuing {
                                phi_4776_ = _e1295;
                                phi_2846_ = _e1297;
                                phi_2849_ = _e1299;
                                phi_2851_ = _e1301;
                                phi_2853_ = _e1303;
                                phi_2855_ = _e1305;
                                phi_4896_ = _e1295;
                                break if !(_e1307);
                            }
                        }
                        let _e1310 = phi_4896_;
                        if _e1310 {
                            break;
                        }
                        let _e1312 = local_12;
                        if (_e1312.member.member.member_3 != 4294967295u) {
                            let _e1318 = (_e259 / 3i);
                            let _e1325 = bitcast<f32>((bitcast<u32>((_e1318 + 127i)) << bitcast<u32>(23i)));
                            let _e1333 = (((_e1312.member.member.member * _e1325) * _e1325) * bitcast<f32>((bitcast<u32>(((_e259 - (2i * _e1318)) + 127i)) << bitcast<u32>(23i))));
                            let _e1335 = select(340282350000000000000000000000000000000f, _e1333, (_e1333 < 340282350000000000000000000000000000000f));
                            phi_4594_ = type_23(select(-340282350000000000000000000000000000000f, _e1335, (_e1335 > -340282350000000000000000000000000000000f)), _e1312.member.member.member_1, _e1312.member.member.member_2, _e1312.member.member.member_3);
                        } else {
                            phi_4594_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1342 = phi_4594_;
                        if _e135 {
                        } else {
                            break;
                        }
                        global_2.member[_e127] = _e1342;
                        let _e1346 = local_13;
                        if _e136 {
                        } else {
                            break;
                        }
                        global_5.member[_e127] = _e1346.member_1;
                        if _e134 {
                        } else {
                            break;
                        }
                        let _e1351 = select(0u, 1u, (_e203 <= _e213));
                        if (_e1351 > 0u) {
                            let _e1353 = (1u < _e95);
                            if _e1353 {
                                if (0u < _e95) {
                                } else {
                                    break;
                                }
                                let _e1357 = atomicAdd((&global_6.member[0u]), _e1351);
                                if ((_e1357 + _e1351) < _e1357) {
                                    if _e1353 {
                                    } else {
                                        break;
                                    }
                                    let _e1362 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1365 = select(0u, 1u, (_e1342.member_3 != 4294967295u));
                        if (_e1365 > 0u) {
                            let _e1367 = (3u < _e95);
                            if _e1367 {
                                if (2u < _e95) {
                                } else {
                                    break;
                                }
                                let _e1371 = atomicAdd((&global_6.member[2u]), _e1365);
                                if ((_e1371 + _e1365) < _e1371) {
                                    if _e1367 {
                                    } else {
                                        break;
                                    }
                                    let _e1376 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1346.member_1 > 0u) {
                            let _e1378 = (5u < _e95);
                            if _e1378 {
                                if (4u < _e95) {
                                } else {
                                    break;
                                }
                                let _e1382 = atomicAdd((&global_6.member[4u]), _e1346.member_1);
                                if ((_e1382 + _e1346.member_1) < _e1382) {
                                    if _e1378 {
                                    } else {
                                        break;
                                    }
                                    let _e1387 = atomicAdd((&global_6.member[5u]), 1u);
                                }
                            }
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
fn trace_paths_counted_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
