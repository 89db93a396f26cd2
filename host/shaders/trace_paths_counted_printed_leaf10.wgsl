struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_19 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_21 {
    member: array<type_19>,
}

struct type_23 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_24 {
    member: type_23,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_26 {
    member: array<type_24>,
}

struct type_34 {
    member: type_19,
    member_1: f32,
}

struct type_36 {
    member: type_34,
    member_1: u32,
    member_2: u32,
}

struct type_38 {
    member: array<vec4<u32>, 2>,
}

struct type_40 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_42 {
    member: array<type_40>,
}

struct type_45 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_47 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_49 {
    member: array<type_47>,
}

struct type_53 {
    member: type_45,
    member_1: u32,
}

struct type_58 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(4) 
var<storage, read_write> global_1: type_21;
@group(0) @binding(0) 
var<uniform> global_2: type_38;
@group(0) @binding(3) 
var<storage> global_3: type_26;
@group(0) @binding(5) 
var<storage, read_write> global_4: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_5: type_58;
@group(0) @binding(1) 
var<storage> global_6: type_42;
@group(0) @binding(2) 
var<storage> global_7: type_49;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<f32, 128>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<u32, 128>;
    var local_7: array<f32, 128>;
    var local_8: array<f32, 3>;
    var local_9: array<f32, 3>;
    var phi_345_: i32;
    var phi_346_: i32;
    var phi_356_: bool;
    var phi_366_: u32;
    var phi_367_: u32;
    var phi_369_: bool;
    var phi_374_: u32;
    var phi_406_: i32;
    var phi_424_: f32;
    var phi_430_: f32;
    var phi_441_: f32;
    var phi_447_: f32;
    var phi_470_: f32;
    var phi_481_: f32;
    var phi_490_: f32;
    var phi_496_: f32;
    var phi_507_: f32;
    var phi_513_: f32;
    var phi_536_: f32;
    var phi_547_: f32;
    var phi_556_: f32;
    var phi_562_: f32;
    var phi_573_: f32;
    var phi_579_: f32;
    var phi_602_: f32;
    var phi_613_: f32;
    var phi_713_: f32;
    var phi_714_: f32;
    var phi_3289_: bool;
    var phi_796_: type_36;
    var phi_799_: type_53;
    var phi_801_: u32;
    var phi_803_: bool;
    var phi_805_: u32;
    var phi_816_: bool;
    var phi_902_: type_53;
    var phi_903_: bool;
    var phi_904_: u32;
    var phi_2128_: type_40;
    var phi_2960_: type_53;
    var phi_3037_: type_53;
    var phi_3038_: type_53;
    var phi_3039_: u32;
    var phi_3041_: type_53;
    var phi_3042_: u32;
    var phi_3043_: bool;
    var phi_3050_: type_53;
    var phi_3055_: type_53;
    var phi_3056_: bool;
    var phi_923_: type_36;
    var phi_926_: type_7;
    var phi_927_: type_7;
    var phi_949_: type_7;
    var phi_977_: u32;
    var phi_993_: type_47;
    var phi_1369_: bool;
    var phi_1398_: bool;
    var phi_1775_: f32;
    var phi_1776_: f32;
    var phi_1777_: f32;
    var phi_1778_: f32;
    var phi_1779_: vec3<f32>;
    var phi_1780_: vec3<f32>;
    var phi_1781_: vec3<f32>;
    var phi_1782_: vec3<f32>;
    var phi_1813_: bool;
    var phi_1822_: vec3<f32>;
    var phi_1989_: bool;
    var phi_2013_: f32;
    var phi_2014_: f32;
    var phi_2037_: type_19;
    var phi_2039_: type_19;
    var phi_2040_: bool;
    var phi_2044_: type_19;
    var phi_2045_: type_19;
    var phi_2046_: type_19;
    var phi_2047_: bool;
    var phi_2051_: type_19;
    var phi_2052_: bool;
    var phi_2053_: type_19;
    var phi_2054_: bool;
    var phi_2055_: bool;
    var phi_2056_: type_19;
    var phi_2057_: bool;
    var phi_2058_: bool;
    var phi_2066_: type_19;
    var phi_2067_: bool;
    var phi_2071_: type_19;
    var phi_2096_: bool;
    var phi_2097_: bool;
    var phi_2104_: type_36;
    var phi_2105_: type_36;
    var phi_2106_: type_36;
    var phi_924_: type_36;
    var phi_3283_: bool;
    var phi_3447_: bool;
    var phi_3058_: type_36;
    var phi_3059_: type_53;
    var phi_3060_: bool;
    var phi_3061_: u32;
    var phi_3446_: bool;
    var phi_3062_: type_36;
    var phi_3063_: type_53;
    var phi_3064_: u32;
    var phi_3065_: bool;
    var phi_3066_: u32;
    var phi_3445_: bool;
    var phi_3067_: type_36;
    var phi_3068_: type_53;
    var phi_3069_: u32;
    var phi_3070_: bool;
    var phi_3071_: u32;
    var phi_3444_: bool;
    var phi_797_: type_36;
    var phi_800_: type_53;
    var phi_802_: u32;
    var phi_804_: bool;
    var phi_806_: u32;
    var phi_3072_: bool;
    var phi_3443_: bool;
    var local_10: type_36;
    var phi_3124_: type_19;
    var local_11: type_36;
    var local_12: type_36;

    switch bitcast<i32>(0u) {
        default: {
            let _e77 = global;
            let _e80 = arrayLength((&global_6.member));
            let _e91 = arrayLength((&global_5.member));
            let _e95 = global_2.member[0u][0u];
            let _e99 = global_2.member[0u][1u];
            let _e103 = global_2.member[0u][2u];
            let _e107 = global_2.member[1u][0u];
            let _e111 = global_2.member[1u][1u];
            let _e115 = global_2.member[1u][2u];
            let _e119 = global_2.member[1u][3u];
            let _e123 = (_e77.x + (_e77.y * 2097152u));
            let _e130 = (_e123 < arrayLength((&global_3.member)));
            if _e130 {
                let _e131 = (_e123 < arrayLength((&global_1.member)));
                if _e131 {
                    let _e132 = (_e123 < arrayLength((&global_4.member)));
                    if _e132 {
                        if _e130 {
                        } else {
                            break;
                        }
                        let _e142 = global_3.member[_e123].member.member_2[0u];
                        let _e144 = (bitcast<u32>(_e142) & 2147483647u);
                        let _e150 = global_3.member[_e123].member.member_2[1u];
                        let _e152 = (bitcast<u32>(_e150) & 2147483647u);
                        let _e158 = global_3.member[_e123].member.member_2[2u];
                        let _e160 = (bitcast<u32>(_e158) & 2147483647u);
                        let _e166 = global_3.member[_e123].member.member[0u];
                        let _e168 = (bitcast<u32>(_e166) & 2147483647u);
                        let _e174 = global_3.member[_e123].member.member[1u];
                        let _e176 = (bitcast<u32>(_e174) & 2147483647u);
                        let _e182 = global_3.member[_e123].member.member[2u];
                        let _e184 = (bitcast<u32>(_e182) & 2147483647u);
                        let _e186 = select(_e152, _e144, (_e152 < _e144));
                        let _e188 = select(_e160, _e186, (_e160 < _e186));
                        let _e190 = select(_e168, _e188, (_e168 < _e188));
                        let _e192 = select(_e176, _e190, (_e176 < _e190));
                        let _e194 = select(_e184, _e192, (_e184 < _e192));
                        let _e199 = global_3.member[_e123].member.member_1;
                        let _e201 = (bitcast<u32>(_e199) & 2147483647u);
                        let _e209 = global_3.member[_e123].member.member_3;
                        let _e215 = (((select(_e201, _e194, (_e201 < _e194)) < 2139095040u) && ((bitcast<u32>(_e209) & 2147483647u) <= 2139095040u)) && (_e188 > 0u));
                        if _e215 {
                            let _e218 = (bitcast<u32>(bitcast<f32>(_e188)) & 2147483647u);
                            if (_e218 >= 8388608u) {
                                phi_345_ = (bitcast<i32>((_e218 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_345_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e218)), 32u, (_e218 == 0u))));
                            }
                            let _e232 = phi_345_;
                            phi_346_ = _e232;
                        } else {
                            phi_346_ = 0i;
                        }
                        let _e234 = phi_346_;
                        let _e235 = (_e144 == _e188);
                        if _e235 {
                            phi_356_ = true;
                        } else {
                            phi_356_ = (_e152 == _e188);
                        }
                        let _e238 = phi_356_;
                        let _e239 = select(1u, 0u, _e235);
                        if _e238 {
                            let _e240 = (_e239 + 1u);
                            phi_366_ = _e240;
                            phi_367_ = _e240;
                            phi_369_ = select(true, false, (_e240 == 2u));
                        } else {
                            phi_366_ = u32();
                            phi_367_ = 0u;
                            phi_369_ = true;
                        }
                        let _e244 = phi_366_;
                        let _e246 = phi_367_;
                        let _e248 = phi_369_;
                        if _e248 {
                            phi_374_ = (_e246 + 1u);
                        } else {
                            phi_374_ = 0u;
                        }
                        let _e252 = phi_374_;
                        let _e253 = select(_e244, _e246, _e248);
                        let _e254 = select(_e239, select(2u, _e239, _e238), _e248);
                        let _e255 = -(_e234);
                        if (_e255 < -126i) {
                            phi_406_ = -126i;
                        } else {
                            phi_406_ = select(_e255, 127i, (_e255 > 127i));
                        }
                        let _e260 = phi_406_;
                        let _e265 = bitcast<f32>((bitcast<u32>((_e260 + 127i)) << bitcast<u32>(23i)));
                        let _e271 = bitcast<f32>((bitcast<u32>(((_e255 - _e260) + 127i)) << bitcast<u32>(23i)));
                        let _e276 = global_3.member[_e123].member.member;
                        let _e277 = (_e253 == 0u);
                        if _e277 {
                            phi_424_ = _e276[0];
                        } else {
                            phi_424_ = _e276[1];
                        }
                        let _e281 = phi_424_;
                        let _e282 = (_e253 == 2u);
                        if _e282 {
                            phi_430_ = _e276[2];
                        } else {
                            phi_430_ = _e281;
                        }
                        let _e285 = phi_430_;
                        let _e286 = global_3.member[_e123].member.member_2;
                        if _e277 {
                            phi_441_ = _e286[0];
                        } else {
                            phi_441_ = _e286[1];
                        }
                        let _e290 = phi_441_;
                        if _e282 {
                            phi_447_ = _e286[2];
                        } else {
                            phi_447_ = _e290;
                        }
                        let _e293 = phi_447_;
                        let _e295 = ((_e293 * _e265) * _e271);
                        let _e299 = (bitcast<f32>((bitcast<u32>(_e295) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e299 {
                            let _e303 = (bitcast<f32>((bitcast<u32>(_e285) & 2147483647u)) * 0.00000011920929f);
                            phi_470_ = select(0.00000000000011368684f, _e303, (_e303 > 0.00000000000011368684f));
                        } else {
                            phi_470_ = 0f;
                        }
                        let _e307 = phi_470_;
                        let _e308 = (_e285 + _e307);
                        let _e309 = (_e285 - _e307);
                        let _e310 = select(_e295, 0f, _e299);
                        if _e299 {
                            phi_481_ = 38685626000000000000000000f;
                        } else {
                            phi_481_ = (1f / _e295);
                        }
                        let _e313 = phi_481_;
                        let _e314 = (_e252 == 0u);
                        if _e314 {
                            phi_490_ = _e276[0];
                        } else {
                            phi_490_ = _e276[1];
                        }
                        let _e318 = phi_490_;
                        let _e319 = (_e252 == 2u);
                        if _e319 {
                            phi_496_ = _e276[2];
                        } else {
                            phi_496_ = _e318;
                        }
                        let _e322 = phi_496_;
                        if _e314 {
                            phi_507_ = _e286[0];
                        } else {
                            phi_507_ = _e286[1];
                        }
                        let _e326 = phi_507_;
                        if _e319 {
                            phi_513_ = _e286[2];
                        } else {
                            phi_513_ = _e326;
                        }
                        let _e329 = phi_513_;
                        let _e331 = ((_e329 * _e265) * _e271);
                        let _e335 = (bitcast<f32>((bitcast<u32>(_e331) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e335 {
                            let _e339 = (bitcast<f32>((bitcast<u32>(_e322) & 2147483647u)) * 0.00000011920929f);
                            phi_536_ = select(0.00000000000011368684f, _e339, (_e339 > 0.00000000000011368684f));
                        } else {
                            phi_536_ = 0f;
                        }
                        let _e343 = phi_536_;
                        let _e344 = (_e322 + _e343);
                        let _e345 = (_e322 - _e343);
                        let _e346 = select(_e331, 0f, _e335);
                        if _e335 {
                            phi_547_ = 38685626000000000000000000f;
                        } else {
                            phi_547_ = (1f / _e331);
                        }
                        let _e349 = phi_547_;
                        let _e350 = (_e254 == 0u);
                        if _e350 {
                            phi_556_ = _e276[0];
                        } else {
                            phi_556_ = _e276[1];
                        }
                        let _e354 = phi_556_;
                        let _e355 = (_e254 == 2u);
                        if _e355 {
                            phi_562_ = _e276[2];
                        } else {
                            phi_562_ = _e354;
                        }
                        let _e358 = phi_562_;
                        if _e350 {
                            phi_573_ = _e286[0];
                        } else {
                            phi_573_ = _e286[1];
                        }
                        let _e362 = phi_573_;
                        if _e355 {
                            phi_579_ = _e286[2];
                        } else {
                            phi_579_ = _e362;
                        }
                        let _e365 = phi_579_;
                        let _e367 = ((_e365 * _e265) * _e271);
                        let _e371 = (bitcast<f32>((bitcast<u32>(_e367) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e371 {
                            let _e375 = (bitcast<f32>((bitcast<u32>(_e358) & 2147483647u)) * 0.00000011920929f);
                            phi_602_ = select(0.00000000000011368684f, _e375, (_e375 > 0.00000000000011368684f));
                        } else {
                            phi_602_ = 0f;
                        }
                        let _e379 = phi_602_;
                        let _e380 = (_e358 + _e379);
                        let _e381 = (_e358 - _e379);
                        let _e382 = select(_e367, 0f, _e371);
                        if _e371 {
                            phi_613_ = 38685626000000000000000000f;
                        } else {
                            phi_613_ = (1f / _e367);
                        }
                        let _e385 = phi_613_;
                        let _e388 = bitcast<f32>((bitcast<u32>(_e285) & 2147483647u));
                        let _e391 = bitcast<f32>((bitcast<u32>(_e322) & 2147483647u));
                        let _e393 = select(_e391, _e388, (_e388 > _e391));
                        let _e396 = bitcast<f32>((bitcast<u32>(_e358) & 2147483647u));
                        if (_e215 && (select(_e396, _e393, (_e393 > _e396)) <= 1099511600000f)) {
                            let _e401 = (_e234 / 3i);
                            let _e408 = bitcast<f32>((bitcast<u32>((_e401 + 127i)) << bitcast<u32>(23i)));
                            let _e415 = bitcast<f32>((bitcast<u32>(((_e234 - (2i * _e401)) + 127i)) << bitcast<u32>(23i)));
                            let _e416 = (((_e199 * _e408) * _e408) * _e415);
                            let _e418 = select(340282350000000000000000000000000000000f, _e416, (_e416 < 340282350000000000000000000000000000000f));
                            let _e423 = (((_e209 * _e408) * _e408) * _e415);
                            let _e425 = select(340282350000000000000000000000000000000f, _e423, (_e423 < 340282350000000000000000000000000000000f));
                            phi_713_ = select(-340282350000000000000000000000000000000f, _e425, (_e425 > -340282350000000000000000000000000000000f));
                            phi_714_ = select(-340282350000000000000000000000000000000f, _e418, (_e418 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_713_ = 0f;
                            phi_714_ = 1f;
                        }
                        let _e429 = phi_713_;
                        let _e431 = phi_714_;
                        if _e130 {
                        } else {
                            break;
                        }
                        let _e437 = global_3.member[_e123].member_2;
                        local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 3>(bitcast<f32>(_e95), bitcast<f32>(_e99), bitcast<f32>(_e103));
                        let _e441 = (_e253 % 3u);
                        let _e442 = (_e441 < 3u);
                        if _e442 {
                        } else {
                            break;
                        }
                        let _e444 = local_9[_e441];
                        let _e445 = (_e252 % 3u);
                        let _e446 = (_e445 < 3u);
                        if _e446 {
                        } else {
                            break;
                        }
                        let _e448 = local_9[_e445];
                        let _e449 = (_e254 % 3u);
                        let _e450 = (_e449 < 3u);
                        if _e450 {
                        } else {
                            break;
                        }
                        let _e452 = local_9[_e449];
                        local_8 = array<f32, 3>(bitcast<f32>(_e107), bitcast<f32>(_e111), bitcast<f32>(_e115));
                        if _e442 {
                        } else {
                            break;
                        }
                        let _e456 = local_8[_e441];
                        if _e446 {
                        } else {
                            break;
                        }
                        let _e458 = local_8[_e445];
                        if _e450 {
                        } else {
                            break;
                        }
                        let _e460 = local_8[_e449];
                        phi_3289_ = false;
                        phi_796_ = type_36(type_34(type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e429), 0u, 0u);
                        phi_799_ = type_53(type_45(array<f32, 3>(_e444, _e448, _e452), array<f32, 3>(_e456, _e458, _e460)), select(0u, 2147483648u, (_e80 == 0u)));
                        phi_801_ = ((3u * _e80) + 1u);
                        phi_803_ = (_e431 <= _e429);
                        phi_805_ = 0u;
                        loop {
                            let _e468 = phi_3289_;
                            let _e470 = phi_796_;
                            let _e472 = phi_799_;
                            let _e474 = phi_801_;
                            let _e476 = phi_803_;
                            let _e478 = phi_805_;
                            local_10 = _e470;
                            local_11 = _e470;
                            if _e476 {
                                phi_816_ = true;
                            } else {
                                phi_816_ = (_e478 > 0u);
                            }
                            let _e481 = phi_816_;
                            if _e481 {
                                let _e482 = (_e474 > 0u);
                                if _e482 {
                                    if _e476 {
                                        phi_902_ = _e472;
                                        phi_903_ = _e476;
                                        phi_904_ = _e478;
                                    } else {
                                        let _e483 = (_e478 - 1u);
                                        let _e484 = (_e483 % 128u);
                                        let _e485 = (_e484 < 128u);
                                        if _e485 {
                                        } else {
                                            phi_3443_ = true;
                                            break;
                                        }
                                        let _e487 = local_6[_e484];
                                        if _e485 {
                                        } else {
                                            phi_3443_ = true;
                                            break;
                                        }
                                        let _e489 = local_5[_e484];
                                        if _e485 {
                                        } else {
                                            phi_3443_ = true;
                                            break;
                                        }
                                        let _e491 = local_4[_e484];
                                        if _e485 {
                                        } else {
                                            phi_3443_ = true;
                                            break;
                                        }
                                        let _e493 = local_3[_e484];
                                        if _e485 {
                                        } else {
                                            phi_3443_ = true;
                                            break;
                                        }
                                        let _e496 = local_2[_e484];
                                        if _e485 {
                                        } else {
                                            phi_3443_ = true;
                                            break;
                                        }
                                        let _e498 = local_1[_e484];
                                        if _e485 {
                                        } else {
                                            phi_3443_ = true;
                                            break;
                                        }
                                        let _e500 = local[_e484];
                                        if _e485 {
                                        } else {
                                            phi_3443_ = true;
                                            break;
                                        }
                                        let _e505 = local_7[_e484];
                                        phi_902_ = type_53(type_45(array<f32, 3>(_e489, _e491, _e493), array<f32, 3>(_e496, _e498, _e500)), _e487);
                                        phi_903_ = (_e505 <= _e470.member.member_1);
                                        phi_904_ = _e483;
                                    }
                                    let _e510 = phi_902_;
                                    let _e512 = phi_903_;
                                    let _e514 = phi_904_;
                                    if _e512 {
                                        if ((_e510.member_1 & 2147483648u) != 0u) {
                                            phi_923_ = _e470;
                                            phi_926_ = type_7(0u, ((_e510.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e874 = phi_923_;
                                                let _e876 = phi_926_;
                                                local_12 = _e874;
                                                if (_e876.member < _e876.member_1) {
                                                    phi_927_ = type_7((_e876.member + 1u), _e876.member_1);
                                                    phi_949_ = type_7(1u, _e876.member);
                                                } else {
                                                    phi_927_ = _e876;
                                                    phi_949_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e889 = phi_927_;
                                                let _e891 = phi_949_;
                                                let _e895 = (bitcast<i32>(_e891.member) != 0i);
                                                if _e895 {
                                                    let _e901 = type_36(_e874.member, _e874.member_1, (_e874.member_2 + 1u));
                                                    let _e902 = ((_e510.member_1 & 268435455u) + _e891.member_1);
                                                    let _e903 = (_e902 < arrayLength((&global_7.member)));
                                                    if _e903 {
                                                        if _e903 {
                                                        } else {
                                                            phi_3283_ = true;
                                                            break;
                                                        }
                                                        let _e906 = global_7.member[_e902].member_1;
                                                        phi_977_ = _e906;
                                                    } else {
                                                        phi_977_ = 4294967295u;
                                                    }
                                                    let _e908 = phi_977_;
                                                    if _e903 {
                                                        if _e903 {
                                                        } else {
                                                            phi_3283_ = true;
                                                            break;
                                                        }
                                                        let _e910 = global_7.member[_e902];
                                                        phi_993_ = _e910;
                                                    } else {
                                                        phi_993_ = type_47(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                    }
                                                    let _e912 = phi_993_;
                                                    let _e924 = ((10u * _e253) & 31u);
                                                    let _e927 = ((_e912.member[0] >> bitcast<u32>(_e924)) & 1023u);
                                                    let _e932 = bitcast<f32>((bitcast<u32>(((_e510.member.member_1[0] - _e510.member.member[0]) * 0.0009775171f)) ^ _e119));
                                                    let _e938 = (_e510.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e927) * _e932)) ^ _e119)));
                                                    let _e942 = select(select(_e510.member.member_1[0], _e938, (_e938 < _e510.member.member_1[0])), _e510.member.member_1[0], (_e927 == 1023u));
                                                    let _e944 = ((10u * _e252) & 31u);
                                                    let _e947 = ((_e912.member[0] >> bitcast<u32>(_e944)) & 1023u);
                                                    let _e952 = bitcast<f32>((bitcast<u32>(((_e510.member.member_1[1] - _e510.member.member[1]) * 0.0009775171f)) ^ _e119));
                                                    let _e958 = (_e510.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e947) * _e952)) ^ _e119)));
                                                    let _e962 = select(select(_e510.member.member_1[1], _e958, (_e958 < _e510.member.member_1[1])), _e510.member.member_1[1], (_e947 == 1023u));
                                                    let _e964 = ((10u * _e254) & 31u);
                                                    let _e967 = ((_e912.member[0] >> bitcast<u32>(_e964)) & 1023u);
                                                    let _e972 = bitcast<f32>((bitcast<u32>(((_e510.member.member_1[2] - _e510.member.member[2]) * 0.0009775171f)) ^ _e119));
                                                    let _e978 = (_e510.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e967) * _e972)) ^ _e119)));
                                                    let _e982 = select(select(_e510.member.member_1[2], _e978, (_e978 < _e510.member.member_1[2])), _e510.member.member_1[2], (_e967 == 1023u));
                                                    let _e986 = ((_e912.member[1] >> bitcast<u32>(_e924)) & 1023u);
                                                    let _e992 = (_e510.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e986) * _e932)) ^ _e119)));
                                                    let _e996 = select(select(_e510.member.member_1[0], _e992, (_e992 < _e510.member.member_1[0])), _e510.member.member_1[0], (_e986 == 1023u));
                                                    let _e999 = ((_e912.member[1] >> bitcast<u32>(_e944)) & 1023u);
                                                    let _e1005 = (_e510.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e999) * _e952)) ^ _e119)));
                                                    let _e1009 = select(select(_e510.member.member_1[1], _e1005, (_e1005 < _e510.member.member_1[1])), _e510.member.member_1[1], (_e999 == 1023u));
                                                    let _e1012 = ((_e912.member[1] >> bitcast<u32>(_e964)) & 1023u);
                                                    let _e1018 = (_e510.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1012) * _e972)) ^ _e119)));
                                                    let _e1022 = select(select(_e510.member.member_1[2], _e1018, (_e1018 < _e510.member.member_1[2])), _e510.member.member_1[2], (_e1012 == 1023u));
                                                    let _e1026 = ((_e912.member[2] >> bitcast<u32>(_e924)) & 1023u);
                                                    let _e1032 = (_e510.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1026) * _e932)) ^ _e119)));
                                                    let _e1036 = select(select(_e510.member.member_1[0], _e1032, (_e1032 < _e510.member.member_1[0])), _e510.member.member_1[0], (_e1026 == 1023u));
                                                    let _e1039 = ((_e912.member[2] >> bitcast<u32>(_e944)) & 1023u);
                                                    let _e1045 = (_e510.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1039) * _e952)) ^ _e119)));
                                                    let _e1049 = select(select(_e510.member.member_1[1], _e1045, (_e1045 < _e510.member.member_1[1])), _e510.member.member_1[1], (_e1039 == 1023u));
                                                    let _e1052 = ((_e912.member[2] >> bitcast<u32>(_e964)) & 1023u);
                                                    let _e1058 = (_e510.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1052) * _e972)) ^ _e119)));
                                                    let _e1062 = select(select(_e510.member.member_1[2], _e1058, (_e1058 < _e510.member.member_1[2])), _e510.member.member_1[2], (_e1052 == 1023u));
                                                    let _e1067 = (_e982 - _e358);
                                                    let _e1070 = (((_e942 - _e285) * _e382) - (_e1067 * _e310));
                                                    let _e1073 = (((_e962 - _e322) * _e382) - (_e1067 * _e346));
                                                    let _e1076 = (_e1022 - _e358);
                                                    let _e1079 = (((_e996 - _e285) * _e382) - (_e1076 * _e310));
                                                    let _e1082 = (((_e1009 - _e322) * _e382) - (_e1076 * _e346));
                                                    let _e1085 = (_e1062 - _e358);
                                                    let _e1088 = (((_e1036 - _e285) * _e382) - (_e1085 * _e310));
                                                    let _e1091 = (((_e1049 - _e322) * _e382) - (_e1085 * _e346));
                                                    let _e1092 = (_e1088 * _e1082);
                                                    let _e1093 = (_e1091 * _e1079);
                                                    let _e1094 = (_e1070 * _e1091);
                                                    let _e1095 = (_e1073 * _e1088);
                                                    let _e1096 = (_e1079 * _e1073);
                                                    let _e1097 = (_e1082 * _e1070);
                                                    let _e1102 = (((_e1092 >= _e1093) && (_e1094 >= _e1095)) && (_e1096 >= _e1097));
                                                    if (_e1102 || (((_e1092 <= _e1093) && (_e1094 <= _e1095)) && (_e1096 <= _e1097))) {
                                                        let _e1109 = select(-1f, 1f, _e1102);
                                                        let _e1111 = ((_e1092 - _e1093) * _e1109);
                                                        let _e1113 = select(0f, _e1111, (_e1111 > 0f));
                                                        let _e1115 = ((_e1094 - _e1095) * _e1109);
                                                        let _e1117 = select(0f, _e1115, (_e1115 > 0f));
                                                        let _e1119 = ((_e1096 - _e1097) * _e1109);
                                                        let _e1121 = select(0f, _e1119, (_e1119 > 0f));
                                                        let _e1123 = ((_e1113 + _e1117) + _e1121);
                                                        if (_e1123 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2056_ = type_19();
                                                            phi_2057_ = true;
                                                            phi_2058_ = false;
                                                        } else {
                                                            let _e1126 = select(_e1079, _e1070, (_e1070 < _e1079));
                                                            if (select(_e1088, _e1126, (_e1126 < _e1088)) > 0f) {
                                                                phi_1369_ = true;
                                                            } else {
                                                                let _e1131 = select(_e1079, _e1070, (_e1070 > _e1079));
                                                                phi_1369_ = (select(_e1088, _e1131, (_e1131 > _e1088)) < 0f);
                                                            }
                                                            let _e1136 = phi_1369_;
                                                            if _e1136 {
                                                                phi_2053_ = type_19();
                                                                phi_2054_ = true;
                                                                phi_2055_ = false;
                                                            } else {
                                                                let _e1138 = select(_e1082, _e1073, (_e1073 < _e1082));
                                                                if (select(_e1091, _e1138, (_e1138 < _e1091)) > 0f) {
                                                                    phi_1398_ = true;
                                                                } else {
                                                                    let _e1143 = select(_e1082, _e1073, (_e1073 > _e1082));
                                                                    phi_1398_ = (select(_e1091, _e1143, (_e1143 > _e1091)) < 0f);
                                                                }
                                                                let _e1148 = phi_1398_;
                                                                if _e1148 {
                                                                    phi_2051_ = type_19();
                                                                    phi_2052_ = false;
                                                                } else {
                                                                    let _e1150 = select(_e996, _e942, (_e942 < _e996));
                                                                    let _e1154 = select(_e996, _e942, (_e942 > _e996));
                                                                    let _e1158 = select(_e1009, _e962, (_e962 < _e1009));
                                                                    let _e1162 = select(_e1009, _e962, (_e962 > _e1009));
                                                                    let _e1166 = select(_e1022, _e982, (_e982 < _e1022));
                                                                    let _e1170 = select(_e1022, _e982, (_e982 > _e1022));
                                                                    let _e1175 = ((select(_e1036, _e1150, (_e1150 < _e1036)) - _e308) * _e313);
                                                                    let _e1176 = ((select(_e1036, _e1154, (_e1154 > _e1036)) - _e309) * _e313);
                                                                    let _e1179 = ((select(_e1049, _e1158, (_e1158 < _e1049)) - _e344) * _e349);
                                                                    let _e1180 = ((select(_e1049, _e1162, (_e1162 > _e1049)) - _e345) * _e349);
                                                                    let _e1183 = ((select(_e1062, _e1166, (_e1166 < _e1062)) - _e380) * _e385);
                                                                    let _e1184 = ((select(_e1062, _e1170, (_e1170 > _e1062)) - _e381) * _e385);
                                                                    let _e1186 = select(_e1184, _e1183, (_e1183 < _e1184));
                                                                    let _e1188 = select(_e1184, _e1183, (_e1183 > _e1184));
                                                                    let _e1190 = select(_e1176, _e1175, (_e1175 < _e1176));
                                                                    let _e1192 = select(_e1180, _e1179, (_e1179 < _e1180));
                                                                    let _e1194 = select(_e1192, _e1190, (_e1190 > _e1192));
                                                                    let _e1196 = select(_e1186, _e1194, (_e1194 > _e1186));
                                                                    let _e1198 = select(_e1176, _e1175, (_e1175 > _e1176));
                                                                    let _e1200 = select(_e1180, _e1179, (_e1179 > _e1180));
                                                                    let _e1202 = select(_e1200, _e1198, (_e1198 < _e1200));
                                                                    let _e1204 = select(_e1188, _e1202, (_e1202 < _e1188));
                                                                    let _e1205 = -(_e1186);
                                                                    let _e1211 = select(_e431, _e1196, (_e1196 > _e431));
                                                                    if (_e1211 > (_e1204 + (select(_e1205, _e1188, (_e1188 > _e1205)) * 0.0000019073523f))) {
                                                                        phi_2046_ = type_19();
                                                                        phi_2047_ = true;
                                                                    } else {
                                                                        let _e1213 = (_e1211 > _e874.member.member_1);
                                                                        if _e1213 {
                                                                            phi_2045_ = type_19();
                                                                        } else {
                                                                            let _e1214 = vec3<f32>(_e942, _e962, _e982);
                                                                            let _e1215 = vec3<f32>(_e996, _e1009, _e1022);
                                                                            let _e1216 = vec3<f32>(_e1036, _e1049, _e1062);
                                                                            let _e1217 = (_e996 - _e942);
                                                                            let _e1218 = (_e1009 - _e962);
                                                                            let _e1219 = (_e1022 - _e982);
                                                                            let _e1220 = vec3<f32>(_e1217, _e1218, _e1219);
                                                                            let _e1221 = (_e1036 - _e996);
                                                                            let _e1222 = (_e1049 - _e1009);
                                                                            let _e1223 = (_e1062 - _e1022);
                                                                            let _e1224 = vec3<f32>(_e1221, _e1222, _e1223);
                                                                            let _e1225 = (_e942 - _e1036);
                                                                            let _e1226 = (_e962 - _e1049);
                                                                            let _e1227 = (_e982 - _e1062);
                                                                            let _e1228 = vec3<f32>(_e1225, _e1226, _e1227);
                                                                            let _e1231 = bitcast<f32>((bitcast<u32>(_e1217) & 2147483647u));
                                                                            let _e1234 = bitcast<f32>((bitcast<u32>(_e1218) & 2147483647u));
                                                                            let _e1236 = select(_e1234, _e1231, (_e1231 > _e1234));
                                                                            let _e1239 = bitcast<f32>((bitcast<u32>(_e1219) & 2147483647u));
                                                                            let _e1241 = select(_e1239, _e1236, (_e1236 > _e1239));
                                                                            let _e1244 = bitcast<f32>((bitcast<u32>(_e1221) & 2147483647u));
                                                                            let _e1247 = bitcast<f32>((bitcast<u32>(_e1222) & 2147483647u));
                                                                            let _e1249 = select(_e1247, _e1244, (_e1244 > _e1247));
                                                                            let _e1252 = bitcast<f32>((bitcast<u32>(_e1223) & 2147483647u));
                                                                            let _e1254 = select(_e1252, _e1249, (_e1249 > _e1252));
                                                                            let _e1257 = bitcast<f32>((bitcast<u32>(_e1225) & 2147483647u));
                                                                            let _e1260 = bitcast<f32>((bitcast<u32>(_e1226) & 2147483647u));
                                                                            let _e1262 = select(_e1260, _e1257, (_e1257 > _e1260));
                                                                            let _e1265 = bitcast<f32>((bitcast<u32>(_e1227) & 2147483647u));
                                                                            let _e1267 = select(_e1265, _e1262, (_e1262 > _e1265));
                                                                            let _e1269 = select(_e1254, _e1241, (_e1241 > _e1254));
                                                                            let _e1271 = select(_e1267, _e1269, (_e1269 > _e1267));
                                                                            if (_e1241 == _e1271) {
                                                                                phi_1775_ = _e1082;
                                                                                phi_1776_ = _e1079;
                                                                                phi_1777_ = _e1073;
                                                                                phi_1778_ = _e1070;
                                                                                phi_1779_ = _e1214;
                                                                                phi_1780_ = _e1228;
                                                                                phi_1781_ = _e1224;
                                                                                phi_1782_ = _e1220;
                                                                            } else {
                                                                                let _e1273 = (_e1254 == _e1271);
                                                                                let _e1278 = vec3(_e1273);
                                                                                phi_1775_ = select(_e1073, _e1091, _e1273);
                                                                                phi_1776_ = select(_e1070, _e1088, _e1273);
                                                                                phi_1777_ = select(_e1091, _e1082, _e1273);
                                                                                phi_1778_ = select(_e1088, _e1079, _e1273);
                                                                                phi_1779_ = select(_e1216, _e1215, _e1278);
                                                                                phi_1780_ = select(_e1224, _e1220, _e1278);
                                                                                phi_1781_ = select(_e1220, _e1228, _e1278);
                                                                                phi_1782_ = select(_e1228, _e1224, _e1278);
                                                                            }
                                                                            let _e1284 = phi_1775_;
                                                                            let _e1286 = phi_1776_;
                                                                            let _e1288 = phi_1777_;
                                                                            let _e1290 = phi_1778_;
                                                                            let _e1292 = phi_1779_;
                                                                            let _e1294 = phi_1780_;
                                                                            let _e1296 = phi_1781_;
                                                                            let _e1298 = phi_1782_;
                                                                            let _e1305 = ((_e1296.y * _e1294.z) - (_e1294.y * _e1296.z));
                                                                            let _e1310 = ((_e1296.z * _e1294.x) - (_e1294.z * _e1296.x));
                                                                            let _e1313 = ((_e1296.x * _e1294.y) - (_e1294.x * _e1296.y));
                                                                            if (_e1113 >= _e1117) {
                                                                                phi_1813_ = select(true, false, (_e1113 >= _e1121));
                                                                            } else {
                                                                                phi_1813_ = true;
                                                                            }
                                                                            let _e1318 = phi_1813_;
                                                                            if _e1318 {
                                                                                phi_1822_ = select(_e1216, _e1215, vec3((_e1117 >= _e1121)));
                                                                            } else {
                                                                                phi_1822_ = _e1214;
                                                                            }
                                                                            let _e1323 = phi_1822_;
                                                                            let _e1328 = (((_e1305 * _e310) + (_e1310 * _e346)) + (_e1313 * _e382));
                                                                            let _e1339 = (((_e1305 * (_e1323.x - _e285)) + (_e1310 * (_e1323.y - _e322))) + (_e1313 * (_e1323.z - _e358)));
                                                                            let _e1341 = (_e1286 - _e1290);
                                                                            let _e1342 = (_e1284 - _e1288);
                                                                            let _e1350 = (-(((_e1290 * _e1341) + (_e1288 * _e1342))) / ((_e1341 * _e1341) + (_e1342 * _e1342)));
                                                                            let _e1352 = select(1f, _e1350, (_e1350 < 1f));
                                                                            let _e1354 = select(0f, _e1352, (_e1352 > 0f));
                                                                            let _e1367 = ((_e1292.x + (_e1298.x * _e1354)) - _e285);
                                                                            let _e1368 = ((_e1292.y + (_e1298.y * _e1354)) - _e322);
                                                                            let _e1369 = ((_e1292.z + (_e1298.z * _e1354)) - _e358);
                                                                            let _e1370 = (_e1369 / _e382);
                                                                            let _e1382 = bitcast<f32>((bitcast<u32>(_e1367) & 2147483647u));
                                                                            let _e1385 = bitcast<f32>((bitcast<u32>(_e1368) & 2147483647u));
                                                                            let _e1387 = select(_e1385, _e1382, (_e1382 > _e1385));
                                                                            let _e1390 = bitcast<f32>((bitcast<u32>(_e1369) & 2147483647u));
                                                                            let _e1392 = select(_e1390, _e1387, (_e1387 > _e1390));
                                                                            let _e1398 = bitcast<f32>((bitcast<u32>(_e1305) & 2147483647u));
                                                                            let _e1401 = bitcast<f32>((bitcast<u32>(_e1310) & 2147483647u));
                                                                            let _e1403 = select(_e1401, _e1398, (_e1398 > _e1401));
                                                                            let _e1406 = bitcast<f32>((bitcast<u32>(_e1313) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1305 * _e1367) + (_e1310 * _e1368)) + (_e1313 * _e1369)) - _e1339)) & 2147483647u)) <= ((0.0000009536743f * select(_e1271, _e1392, (_e1392 > _e1271))) * select(_e1406, _e1403, (_e1403 > _e1406)))) {
                                                                                let _e1416 = bitcast<f32>((bitcast<u32>(_e1296.x) & 2147483647u));
                                                                                let _e1419 = bitcast<f32>((bitcast<u32>(_e1296.y) & 2147483647u));
                                                                                let _e1421 = select(_e1419, _e1416, (_e1416 > _e1419));
                                                                                let _e1424 = bitcast<f32>((bitcast<u32>(_e1296.z) & 2147483647u));
                                                                                let _e1430 = bitcast<f32>((bitcast<u32>(_e1294.x) & 2147483647u));
                                                                                let _e1433 = bitcast<f32>((bitcast<u32>(_e1294.y) & 2147483647u));
                                                                                let _e1435 = select(_e1433, _e1430, (_e1430 > _e1433));
                                                                                let _e1438 = bitcast<f32>((bitcast<u32>(_e1294.z) & 2147483647u));
                                                                                phi_1989_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1328) & 2147483647u)) > ((0.0000038146973f * select(_e1424, _e1421, (_e1421 > _e1424))) * select(_e1438, _e1435, (_e1435 > _e1438)))));
                                                                            } else {
                                                                                phi_1989_ = true;
                                                                            }
                                                                            let _e1445 = phi_1989_;
                                                                            if _e1445 {
                                                                                let _e1456 = ((((_e1305 * (_e1367 - (_e310 * _e1370))) + (_e1310 * (_e1368 - (_e346 * _e1370)))) + (_e1313 * (_e1369 - _e1369))) / _e1328);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1456) & 2147483647u)) <= _e1271) {
                                                                                    phi_2013_ = (_e1370 + _e1456);
                                                                                } else {
                                                                                    phi_2013_ = _e1370;
                                                                                }
                                                                                let _e1463 = phi_2013_;
                                                                                phi_2014_ = _e1463;
                                                                            } else {
                                                                                phi_2014_ = (_e1339 / _e1328);
                                                                            }
                                                                            let _e1465 = phi_2014_;
                                                                            let _e1467 = select(_e1204, _e1465, (_e1465 < _e1204));
                                                                            let _e1469 = select(_e1196, _e1467, (_e1467 > _e1196));
                                                                            if (_e1469 >= _e431) {
                                                                                let _e1471 = (_e1469 <= _e874.member.member_1);
                                                                                if _e1471 {
                                                                                    let _e1472 = (1f / _e1123);
                                                                                    phi_2037_ = type_19(_e1469, (_e1117 * _e1472), (_e1121 * _e1472), _e908);
                                                                                } else {
                                                                                    phi_2037_ = type_19();
                                                                                }
                                                                                let _e1477 = phi_2037_;
                                                                                phi_2039_ = _e1477;
                                                                                phi_2040_ = select(true, false, _e1471);
                                                                            } else {
                                                                                phi_2039_ = type_19();
                                                                                phi_2040_ = true;
                                                                            }
                                                                            let _e1480 = phi_2039_;
                                                                            let _e1482 = phi_2040_;
                                                                            if _e1482 {
                                                                                phi_2044_ = type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2044_ = _e1480;
                                                                            }
                                                                            let _e1484 = phi_2044_;
                                                                            phi_2045_ = _e1484;
                                                                        }
                                                                        let _e1486 = phi_2045_;
                                                                        phi_2046_ = _e1486;
                                                                        phi_2047_ = _e1213;
                                                                    }
                                                                    let _e1488 = phi_2046_;
                                                                    let _e1490 = phi_2047_;
                                                                    phi_2051_ = _e1488;
                                                                    phi_2052_ = _e1490;
                                                                }
                                                                let _e1492 = phi_2051_;
                                                                let _e1494 = phi_2052_;
                                                                phi_2053_ = _e1492;
                                                                phi_2054_ = _e1148;
                                                                phi_2055_ = _e1494;
                                                            }
                                                            let _e1496 = phi_2053_;
                                                            let _e1498 = phi_2054_;
                                                            let _e1500 = phi_2055_;
                                                            phi_2056_ = _e1496;
                                                            phi_2057_ = _e1498;
                                                            phi_2058_ = _e1500;
                                                        }
                                                        let _e1502 = phi_2056_;
                                                        let _e1504 = phi_2057_;
                                                        let _e1506 = phi_2058_;
                                                        phi_2066_ = _e1502;
                                                        phi_2067_ = select(_e1506, true, _e1504);
                                                    } else {
                                                        phi_2066_ = type_19();
                                                        phi_2067_ = true;
                                                    }
                                                    let _e1509 = phi_2066_;
                                                    let _e1511 = phi_2067_;
                                                    if _e1511 {
                                                        phi_2071_ = type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2071_ = _e1509;
                                                    }
                                                    let _e1513 = phi_2071_;
                                                    if (_e1513.member_3 != 4294967295u) {
                                                        if (_e908 != _e437) {
                                                            if (_e1513.member < _e874.member.member.member) {
                                                                phi_2097_ = true;
                                                            } else {
                                                                if (_e1513.member == _e874.member.member.member) {
                                                                    phi_2096_ = (_e1513.member_3 < _e874.member.member.member_3);
                                                                } else {
                                                                    phi_2096_ = false;
                                                                }
                                                                let _e1528 = phi_2096_;
                                                                phi_2097_ = _e1528;
                                                            }
                                                            let _e1530 = phi_2097_;
                                                            if _e1530 {
                                                                phi_2104_ = type_36(type_34(_e1513, _e1513.member), _e901.member_1, _e901.member_2);
                                                            } else {
                                                                phi_2104_ = _e901;
                                                            }
                                                            let _e1537 = phi_2104_;
                                                            phi_2105_ = _e1537;
                                                        } else {
                                                            phi_2105_ = _e901;
                                                        }
                                                        let _e1539 = phi_2105_;
                                                        phi_2106_ = _e1539;
                                                    } else {
                                                        phi_2106_ = _e901;
                                                    }
                                                    let _e1541 = phi_2106_;
                                                    phi_924_ = _e1541;
                                                } else {
                                                    phi_924_ = type_36();
                                                }
                                                let _e1543 = phi_924_;
                                                continue;
                                                continuing {
                                                    phi_923_ = _e1543;
                                                    phi_926_ = _e889;
                                                    phi_3283_ = _e468;
                                                    break if !(_e895);
                                                }
                                            }
                                            let _e1546 = phi_3283_;
                                            phi_3443_ = _e1546;
                                            if _e1546 {
                                                break;
                                            }
                                            phi_3447_ = _e1546;
                                            let _e1773 = local_12;
                                            phi_3058_ = _e1773;
                                            phi_3059_ = _e510;
                                            phi_3060_ = false;
                                            phi_3061_ = _e514;
                                        } else {
                                            let _e530 = (_e510.member_1 < _e80);
                                            if _e530 {
                                                if _e530 {
                                                } else {
                                                    phi_3443_ = true;
                                                    break;
                                                }
                                                let _e532 = global_6.member[_e510.member_1];
                                                phi_2128_ = _e532;
                                            } else {
                                                phi_2128_ = type_40(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e534 = phi_2128_;
                                            let _e549 = ((10u * _e253) & 31u);
                                            let _e552 = ((_e534.member[0] >> bitcast<u32>(_e549)) & 1023u);
                                            let _e557 = bitcast<f32>((bitcast<u32>(((_e510.member.member_1[0] - _e510.member.member[0]) * 0.0009775171f)) ^ _e119));
                                            let _e563 = (_e510.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e552) * _e557)) ^ _e119)));
                                            let _e567 = select(select(_e510.member.member_1[0], _e563, (_e563 < _e510.member.member_1[0])), _e510.member.member_1[0], (_e552 == 1023u));
                                            let _e569 = ((10u * _e252) & 31u);
                                            let _e572 = ((_e534.member[0] >> bitcast<u32>(_e569)) & 1023u);
                                            let _e577 = bitcast<f32>((bitcast<u32>(((_e510.member.member_1[1] - _e510.member.member[1]) * 0.0009775171f)) ^ _e119));
                                            let _e583 = (_e510.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e572) * _e577)) ^ _e119)));
                                            let _e587 = select(select(_e510.member.member_1[1], _e583, (_e583 < _e510.member.member_1[1])), _e510.member.member_1[1], (_e572 == 1023u));
                                            let _e589 = ((10u * _e254) & 31u);
                                            let _e592 = ((_e534.member[0] >> bitcast<u32>(_e589)) & 1023u);
                                            let _e597 = bitcast<f32>((bitcast<u32>(((_e510.member.member_1[2] - _e510.member.member[2]) * 0.0009775171f)) ^ _e119));
                                            let _e603 = (_e510.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e592) * _e597)) ^ _e119)));
                                            let _e607 = select(select(_e510.member.member_1[2], _e603, (_e603 < _e510.member.member_1[2])), _e510.member.member_1[2], (_e592 == 1023u));
                                            let _e610 = ((_e534.member[1] >> bitcast<u32>(_e549)) & 1023u);
                                            let _e616 = (_e510.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e610) * _e557)) ^ _e119)));
                                            let _e620 = select(select(_e510.member.member_1[0], _e616, (_e616 < _e510.member.member_1[0])), _e510.member.member_1[0], (_e610 == 1023u));
                                            let _e623 = ((_e534.member[1] >> bitcast<u32>(_e569)) & 1023u);
                                            let _e629 = (_e510.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e623) * _e577)) ^ _e119)));
                                            let _e633 = select(select(_e510.member.member_1[1], _e629, (_e629 < _e510.member.member_1[1])), _e510.member.member_1[1], (_e623 == 1023u));
                                            let _e636 = ((_e534.member[1] >> bitcast<u32>(_e589)) & 1023u);
                                            let _e642 = (_e510.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e636) * _e597)) ^ _e119)));
                                            let _e646 = select(select(_e510.member.member_1[2], _e642, (_e642 < _e510.member.member_1[2])), _e510.member.member_1[2], (_e636 == 1023u));
                                            let _e652 = ((_e534.member_1[0] >> bitcast<u32>(_e549)) & 1023u);
                                            let _e658 = (_e510.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e652) * _e557)) ^ _e119)));
                                            let _e662 = select(select(_e510.member.member_1[0], _e658, (_e658 < _e510.member.member_1[0])), _e510.member.member_1[0], (_e652 == 1023u));
                                            let _e665 = ((_e534.member_1[0] >> bitcast<u32>(_e569)) & 1023u);
                                            let _e671 = (_e510.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e665) * _e577)) ^ _e119)));
                                            let _e675 = select(select(_e510.member.member_1[1], _e671, (_e671 < _e510.member.member_1[1])), _e510.member.member_1[1], (_e665 == 1023u));
                                            let _e678 = ((_e534.member_1[0] >> bitcast<u32>(_e589)) & 1023u);
                                            let _e684 = (_e510.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e678) * _e597)) ^ _e119)));
                                            let _e688 = select(select(_e510.member.member_1[2], _e684, (_e684 < _e510.member.member_1[2])), _e510.member.member_1[2], (_e678 == 1023u));
                                            let _e691 = ((_e534.member_1[1] >> bitcast<u32>(_e549)) & 1023u);
                                            let _e697 = (_e510.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e691) * _e557)) ^ _e119)));
                                            let _e701 = select(select(_e510.member.member_1[0], _e697, (_e697 < _e510.member.member_1[0])), _e510.member.member_1[0], (_e691 == 1023u));
                                            let _e704 = ((_e534.member_1[1] >> bitcast<u32>(_e569)) & 1023u);
                                            let _e710 = (_e510.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e704) * _e577)) ^ _e119)));
                                            let _e714 = select(select(_e510.member.member_1[1], _e710, (_e710 < _e510.member.member_1[1])), _e510.member.member_1[1], (_e704 == 1023u));
                                            let _e717 = ((_e534.member_1[1] >> bitcast<u32>(_e589)) & 1023u);
                                            let _e723 = (_e510.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e717) * _e597)) ^ _e119)));
                                            let _e727 = select(select(_e510.member.member_1[2], _e723, (_e723 < _e510.member.member_1[2])), _e510.member.member_1[2], (_e717 == 1023u));
                                            let _e732 = type_53(type_45(array<f32, 3>(_e567, _e587, _e607), array<f32, 3>(_e620, _e633, _e646)), _e534.member_2);
                                            let _e737 = type_53(type_45(array<f32, 3>(_e662, _e675, _e688), array<f32, 3>(_e701, _e714, _e727)), _e534.member_3);
                                            let _e744 = ((_e567 - _e308) * _e313);
                                            let _e745 = ((_e662 - _e308) * _e313);
                                            let _e746 = ((_e620 - _e309) * _e313);
                                            let _e747 = ((_e701 - _e309) * _e313);
                                            let _e752 = ((_e587 - _e344) * _e349);
                                            let _e753 = ((_e675 - _e344) * _e349);
                                            let _e754 = ((_e633 - _e345) * _e349);
                                            let _e755 = ((_e714 - _e345) * _e349);
                                            let _e760 = ((_e607 - _e380) * _e385);
                                            let _e761 = ((_e688 - _e380) * _e385);
                                            let _e762 = ((_e646 - _e381) * _e385);
                                            let _e763 = ((_e727 - _e381) * _e385);
                                            let _e765 = select(_e762, _e760, (_e760 < _e762));
                                            let _e767 = select(_e763, _e761, (_e761 < _e763));
                                            let _e769 = select(_e762, _e760, (_e760 > _e762));
                                            let _e771 = select(_e763, _e761, (_e761 > _e763));
                                            let _e773 = select(_e746, _e744, (_e744 < _e746));
                                            let _e775 = select(_e747, _e745, (_e745 < _e747));
                                            let _e777 = select(_e754, _e752, (_e752 < _e754));
                                            let _e779 = select(_e755, _e753, (_e753 < _e755));
                                            let _e781 = select(_e777, _e773, (_e773 > _e777));
                                            let _e783 = select(_e779, _e775, (_e775 > _e779));
                                            let _e785 = select(_e765, _e781, (_e781 > _e765));
                                            let _e787 = select(_e767, _e783, (_e783 > _e767));
                                            let _e789 = select(_e746, _e744, (_e744 > _e746));
                                            let _e791 = select(_e747, _e745, (_e745 > _e747));
                                            let _e793 = select(_e754, _e752, (_e752 > _e754));
                                            let _e795 = select(_e755, _e753, (_e753 > _e755));
                                            let _e797 = select(_e793, _e789, (_e789 < _e793));
                                            let _e799 = select(_e795, _e791, (_e791 < _e795));
                                            let _e804 = -(_e765);
                                            let _e805 = -(_e767);
                                            let _e812 = (select(_e769, _e797, (_e797 < _e769)) + (select(_e804, _e769, (_e769 > _e804)) * 0.0000019073523f));
                                            let _e813 = (select(_e771, _e799, (_e799 < _e771)) + (select(_e805, _e771, (_e771 > _e805)) * 0.0000019073523f));
                                            let _e815 = select(_e431, _e785, (_e785 > _e431));
                                            let _e817 = select(_e431, _e787, (_e787 > _e431));
                                            let _e822 = (_e815 <= select(_e470.member.member_1, _e812, (_e812 < _e470.member.member_1)));
                                            let _e823 = (_e817 <= select(_e470.member.member_1, _e813, (_e813 < _e470.member.member_1)));
                                            let _e824 = (_e815 <= _e817);
                                            if _e822 {
                                                if _e823 {
                                                    if _e824 {
                                                        phi_2960_ = _e737;
                                                    } else {
                                                        phi_2960_ = _e732;
                                                    }
                                                    let _e826 = phi_2960_;
                                                    let _e834 = (_e514 % 128u);
                                                    let _e835 = (_e834 < 128u);
                                                    if _e835 {
                                                    } else {
                                                        phi_3443_ = true;
                                                        break;
                                                    }
                                                    local_6[_e834] = _e826.member_1;
                                                    if _e835 {
                                                    } else {
                                                        phi_3443_ = true;
                                                        break;
                                                    }
                                                    local_5[_e834] = _e826.member.member[0];
                                                    if _e835 {
                                                    } else {
                                                        phi_3443_ = true;
                                                        break;
                                                    }
                                                    local_4[_e834] = _e826.member.member[1];
                                                    if _e835 {
                                                    } else {
                                                        phi_3443_ = true;
                                                        break;
                                                    }
                                                    local_3[_e834] = _e826.member.member[2];
                                                    if _e835 {
                                                    } else {
                                                        phi_3443_ = true;
                                                        break;
                                                    }
                                                    local_2[_e834] = _e826.member.member_1[0];
                                                    if _e835 {
                                                    } else {
                                                        phi_3443_ = true;
                                                        break;
                                                    }
                                                    local_1[_e834] = _e826.member.member_1[1];
                                                    if _e835 {
                                                    } else {
                                                        phi_3443_ = true;
                                                        break;
                                                    }
                                                    local[_e834] = _e826.member.member_1[2];
                                                    if _e835 {
                                                    } else {
                                                        phi_3443_ = true;
                                                        break;
                                                    }
                                                    local_7[_e834] = select(_e817, _e815, (_e815 > _e817));
                                                    if _e824 {
                                                        phi_3037_ = _e732;
                                                    } else {
                                                        phi_3037_ = _e737;
                                                    }
                                                    let _e852 = phi_3037_;
                                                    phi_3038_ = _e852;
                                                    phi_3039_ = (_e514 + 1u);
                                                } else {
                                                    phi_3038_ = type_53();
                                                    phi_3039_ = u32();
                                                }
                                                let _e854 = phi_3038_;
                                                let _e856 = phi_3039_;
                                                phi_3041_ = _e854;
                                                phi_3042_ = _e856;
                                                phi_3043_ = select(true, false, _e823);
                                            } else {
                                                phi_3041_ = type_53();
                                                phi_3042_ = u32();
                                                phi_3043_ = true;
                                            }
                                            let _e859 = phi_3041_;
                                            let _e861 = phi_3042_;
                                            let _e863 = phi_3043_;
                                            if _e863 {
                                                if _e822 {
                                                    phi_3050_ = _e732;
                                                } else {
                                                    phi_3050_ = _e737;
                                                }
                                                let _e865 = phi_3050_;
                                                phi_3055_ = _e865;
                                                phi_3056_ = select(_e823, true, _e822);
                                            } else {
                                                phi_3055_ = _e859;
                                                phi_3056_ = _e512;
                                            }
                                            let _e868 = phi_3055_;
                                            let _e870 = phi_3056_;
                                            phi_3447_ = _e468;
                                            phi_3058_ = type_36(_e470.member, (_e470.member_1 + 1u), _e470.member_2);
                                            phi_3059_ = _e868;
                                            phi_3060_ = _e870;
                                            phi_3061_ = select(_e861, _e514, _e863);
                                        }
                                        let _e1548 = phi_3447_;
                                        let _e1550 = phi_3058_;
                                        let _e1552 = phi_3059_;
                                        let _e1554 = phi_3060_;
                                        let _e1556 = phi_3061_;
                                        phi_3446_ = _e1548;
                                        phi_3062_ = _e1550;
                                        phi_3063_ = _e1552;
                                        phi_3064_ = (_e474 - 1u);
                                        phi_3065_ = _e1554;
                                        phi_3066_ = _e1556;
                                    } else {
                                        phi_3446_ = _e468;
                                        phi_3062_ = _e470;
                                        phi_3063_ = _e510;
                                        phi_3064_ = _e474;
                                        phi_3065_ = _e512;
                                        phi_3066_ = _e514;
                                    }
                                    let _e1558 = phi_3446_;
                                    let _e1560 = phi_3062_;
                                    let _e1562 = phi_3063_;
                                    let _e1564 = phi_3064_;
                                    let _e1566 = phi_3065_;
                                    let _e1568 = phi_3066_;
                                    phi_3445_ = _e1558;
                                    phi_3067_ = _e1560;
                                    phi_3068_ = _e1562;
                                    phi_3069_ = _e1564;
                                    phi_3070_ = _e1566;
                                    phi_3071_ = _e1568;
                                } else {
                                    phi_3445_ = _e468;
                                    phi_3067_ = type_36();
                                    phi_3068_ = type_53();
                                    phi_3069_ = u32();
                                    phi_3070_ = bool();
                                    phi_3071_ = u32();
                                }
                                let _e1570 = phi_3445_;
                                let _e1572 = phi_3067_;
                                let _e1574 = phi_3068_;
                                let _e1576 = phi_3069_;
                                let _e1578 = phi_3070_;
                                let _e1580 = phi_3071_;
                                phi_3444_ = _e1570;
                                phi_797_ = _e1572;
                                phi_800_ = _e1574;
                                phi_802_ = _e1576;
                                phi_804_ = _e1578;
                                phi_806_ = _e1580;
                                phi_3072_ = _e482;
                            } else {
                                phi_3444_ = _e468;
                                phi_797_ = type_36();
                                phi_800_ = type_53();
                                phi_802_ = u32();
                                phi_804_ = bool();
                                phi_806_ = u32();
                                phi_3072_ = false;
                            }
                            let _e1582 = phi_3444_;
                            let _e1584 = phi_797_;
                            let _e1586 = phi_800_;
                            let _e1588 = phi_802_;
                            let _e1590 = phi_804_;
                            let _e1592 = phi_806_;
                            let _e1594 = phi_3072_;
                            continue;
                            continuing {
                                phi_3289_ = _e1582;
                                phi_796_ = _e1584;
                                phi_799_ = _e1586;
                                phi_801_ = _e1588;
                                phi_803_ = _e1590;
                                phi_805_ = _e1592;
                                phi_3443_ = _e1582;
                                break if !(_e1594);
                            }
                        }
                        let _e1597 = phi_3443_;
                        if _e1597 {
                            break;
                        }
                        let _e1599 = local_10;
                        if (_e1599.member.member.member_3 != 4294967295u) {
                            let _e1605 = (_e255 / 3i);
                            let _e1612 = bitcast<f32>((bitcast<u32>((_e1605 + 127i)) << bitcast<u32>(23i)));
                            let _e1620 = (((_e1599.member.member.member * _e1612) * _e1612) * bitcast<f32>((bitcast<u32>(((_e255 - (2i * _e1605)) + 127i)) << bitcast<u32>(23i))));
                            let _e1622 = select(340282350000000000000000000000000000000f, _e1620, (_e1620 < 340282350000000000000000000000000000000f));
                            phi_3124_ = type_19(select(-340282350000000000000000000000000000000f, _e1622, (_e1622 > -340282350000000000000000000000000000000f)), _e1599.member.member.member_1, _e1599.member.member.member_2, _e1599.member.member.member_3);
                        } else {
                            phi_3124_ = type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1629 = phi_3124_;
                        if _e131 {
                        } else {
                            break;
                        }
                        global_1.member[_e123] = _e1629;
                        let _e1633 = local_11;
                        if _e132 {
                        } else {
                            break;
                        }
                        global_4.member[_e123] = _e1633.member_1;
                        if _e130 {
                        } else {
                            break;
                        }
                        let _e1638 = select(0u, 1u, (_e199 <= _e209));
                        if (_e1638 > 0u) {
                            let _e1640 = (1u < _e91);
                            if _e1640 {
                                if (0u < _e91) {
                                } else {
                                    break;
                                }
                                let _e1644 = atomicAdd((&global_5.member[0u]), _e1638);
                                if ((_e1644 + _e1638) < _e1644) {
                                    if _e1640 {
                                    } else {
                                        break;
                                    }
                                    let _e1649 = atomicAdd((&global_5.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1652 = select(0u, 1u, (_e1629.member_3 != 4294967295u));
                        if (_e1652 > 0u) {
                            let _e1654 = (3u < _e91);
                            if _e1654 {
                                if (2u < _e91) {
                                } else {
                                    break;
                                }
                                let _e1658 = atomicAdd((&global_5.member[2u]), _e1652);
                                if ((_e1658 + _e1652) < _e1658) {
                                    if _e1654 {
                                    } else {
                                        break;
                                    }
                                    let _e1663 = atomicAdd((&global_5.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1633.member_1 > 0u) {
                            let _e1665 = (5u < _e91);
                            if _e1665 {
                                if (4u < _e91) {
                                } else {
                                    break;
                                }
                                let _e1669 = atomicAdd((&global_5.member[4u]), _e1633.member_1);
                                if ((_e1669 + _e1633.member_1) < _e1669) {
                                    if _e1665 {
                                    } else {
                                        break;
                                    }
                                    let _e1674 = atomicAdd((&global_5.member[5u]), 1u);
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
fn trace_paths_counted_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
