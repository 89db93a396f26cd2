struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_13 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_15 {
    member: array<type_13>,
}

struct type_22 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_23 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_32 {
    member: array<type_23>,
}

struct type_36 {
    member: array<array<type_22, 8>>,
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

struct type_51 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_53 {
    member: type_51,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(3) 
var<storage> global_2: type_15;
@group(0) @binding(1) 
var<uniform> global_3: type_42;
@group(0) @binding(4) 
var<storage> global_4: type_32;
@group(0) @binding(2) 
var<storage> global_5: type_46;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_36;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<f32, 128>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<u32, 128>;
    var local_7: array<f32, 3>;
    var local_8: array<f32, 3>;
    var local_9: array<type_22, 8>;
    var local_10: array<f32, 128>;
    var local_11: array<f32, 3>;
    var local_12: array<f32, 3>;
    var local_13: array<f32, 3>;
    var local_14: array<f32, 3>;
    var local_15: array<u32, 3>;
    var local_16: array<u32, 3>;
    var local_17: array<f32, 3>;
    var local_18: array<f32, 3>;
    var phi_344_: i32;
    var phi_345_: i32;
    var phi_355_: bool;
    var phi_365_: u32;
    var phi_366_: u32;
    var phi_368_: bool;
    var phi_373_: u32;
    var phi_386_: i32;
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
    var phi_2932_: bool;
    var phi_2923_: f32;
    var phi_840_: type_53;
    var phi_843_: u32;
    var phi_845_: bool;
    var phi_847_: u32;
    var phi_858_: bool;
    var phi_945_: type_53;
    var phi_946_: bool;
    var phi_947_: u32;
    var phi_1813_: type_44;
    var phi_1822_: type_4;
    var phi_1823_: type_4;
    var phi_1846_: type_4;
    var phi_2925_: bool;
    var phi_1976_: type_4;
    var phi_1977_: type_4;
    var phi_2000_: type_4;
    var phi_2985_: bool;
    var phi_2564_: type_53;
    var phi_2641_: type_53;
    var phi_2642_: type_53;
    var phi_2643_: u32;
    var phi_2645_: type_53;
    var phi_2646_: u32;
    var phi_2647_: bool;
    var phi_2654_: type_53;
    var phi_2659_: type_53;
    var phi_2660_: bool;
    var phi_3024_: bool;
    var phi_3014_: f32;
    var phi_965_: type_4;
    var phi_966_: type_4;
    var phi_989_: type_4;
    var phi_1010_: u32;
    var phi_1099_: array<array<f32, 3>, 3>;
    var phi_1571_: vec3<f32>;
    var phi_1572_: vec3<f32>;
    var phi_1603_: bool;
    var phi_1612_: vec3<f32>;
    var phi_1652_: type_22;
    var phi_1654_: type_22;
    var phi_1655_: bool;
    var phi_1659_: type_22;
    var phi_1660_: type_22;
    var phi_1661_: type_22;
    var phi_1662_: bool;
    var phi_1666_: type_22;
    var phi_1667_: bool;
    var phi_1671_: type_22;
    var phi_1672_: bool;
    var phi_1676_: type_22;
    var phi_1688_: type_4;
    var phi_1691_: type_22;
    var phi_1689_: type_4;
    var phi_1714_: type_4;
    var phi_1746_: bool;
    var phi_1747_: bool;
    var phi_1768_: type_22;
    var phi_1692_: type_22;
    var phi_3015_: bool;
    var phi_3230_: f32;
    var phi_3229_: f32;
    var phi_3081_: bool;
    var phi_3228_: f32;
    var phi_3080_: bool;
    var phi_3227_: f32;
    var phi_3079_: bool;
    var phi_3167_: f32;
    var phi_3078_: bool;
    var phi_3132_: f32;
    var phi_3087_: bool;
    var phi_2662_: type_53;
    var phi_2663_: bool;
    var phi_2664_: u32;
    var phi_3131_: f32;
    var phi_3086_: bool;
    var phi_2665_: type_53;
    var phi_2666_: u32;
    var phi_2667_: bool;
    var phi_2668_: u32;
    var phi_3130_: f32;
    var phi_3085_: bool;
    var phi_2669_: type_53;
    var phi_2670_: u32;
    var phi_2671_: bool;
    var phi_2672_: u32;
    var phi_3129_: f32;
    var phi_3084_: bool;
    var phi_841_: type_53;
    var phi_844_: u32;
    var phi_846_: bool;
    var phi_848_: u32;
    var phi_2673_: bool;
    var phi_3083_: bool;
    var phi_2680_: type_4;
    var phi_2681_: type_4;
    var phi_2704_: type_4;
    var phi_2770_: type_22;
    var phi_3122_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e88 = global;
            let _e91 = arrayLength((&global_5.member));
            let _e93 = arrayLength((&global_2.member));
            let _e101 = global_3.member[0u][0u];
            let _e105 = global_3.member[0u][1u];
            let _e109 = global_3.member[0u][2u];
            let _e113 = global_3.member[1u][0u];
            let _e117 = global_3.member[1u][1u];
            let _e121 = global_3.member[1u][2u];
            let _e125 = global_3.member[1u][3u];
            let _e128 = global_1.member[0u];
            let _e129 = bitcast<i32>(_e128);
            let _e139 = (_e88.x + (_e88.y * 2097152u));
            let _e140 = (_e139 < arrayLength((&global_4.member)));
            if _e140 {
                let _e141 = (_e139 < arrayLength((&global_6.member)));
                if _e141 {
                    if _e140 {
                    } else {
                        break;
                    }
                    let _e149 = global_4.member[_e139].member_2[0u];
                    let _e151 = (bitcast<u32>(_e149) & 2147483647u);
                    let _e156 = global_4.member[_e139].member_2[1u];
                    let _e158 = (bitcast<u32>(_e156) & 2147483647u);
                    let _e163 = global_4.member[_e139].member_2[2u];
                    let _e165 = (bitcast<u32>(_e163) & 2147483647u);
                    let _e170 = global_4.member[_e139].member[0u];
                    let _e172 = (bitcast<u32>(_e170) & 2147483647u);
                    let _e177 = global_4.member[_e139].member[1u];
                    let _e179 = (bitcast<u32>(_e177) & 2147483647u);
                    let _e184 = global_4.member[_e139].member[2u];
                    let _e186 = (bitcast<u32>(_e184) & 2147483647u);
                    let _e188 = select(_e158, _e151, (_e158 < _e151));
                    let _e190 = select(_e165, _e188, (_e165 < _e188));
                    let _e192 = select(_e172, _e190, (_e172 < _e190));
                    let _e194 = select(_e179, _e192, (_e179 < _e192));
                    let _e196 = select(_e186, _e194, (_e186 < _e194));
                    let _e200 = global_4.member[_e139].member_1;
                    let _e202 = (bitcast<u32>(_e200) & 2147483647u);
                    let _e209 = global_4.member[_e139].member_3;
                    let _e215 = (((select(_e202, _e196, (_e202 < _e196)) < 2139095040u) && ((bitcast<u32>(_e209) & 2147483647u) <= 2139095040u)) && (_e190 > 0u));
                    if _e215 {
                        let _e218 = (bitcast<u32>(bitcast<f32>(_e190)) & 2147483647u);
                        if (_e218 >= 8388608u) {
                            phi_344_ = (bitcast<i32>((_e218 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_344_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e218)), 32u, (_e218 == 0u))));
                        }
                        let _e232 = phi_344_;
                        phi_345_ = _e232;
                    } else {
                        phi_345_ = 0i;
                    }
                    let _e234 = phi_345_;
                    let _e235 = (_e151 == _e190);
                    if _e235 {
                        phi_355_ = true;
                    } else {
                        phi_355_ = (_e158 == _e190);
                    }
                    let _e238 = phi_355_;
                    let _e239 = select(1u, 0u, _e235);
                    if _e238 {
                        let _e240 = (_e239 + 1u);
                        phi_365_ = _e240;
                        phi_366_ = _e240;
                        phi_368_ = select(true, false, (_e240 == 2u));
                    } else {
                        phi_365_ = u32();
                        phi_366_ = 0u;
                        phi_368_ = true;
                    }
                    let _e244 = phi_365_;
                    let _e246 = phi_366_;
                    let _e248 = phi_368_;
                    if _e248 {
                        phi_373_ = (_e246 + 1u);
                    } else {
                        phi_373_ = 0u;
                    }
                    let _e252 = phi_373_;
                    let _e253 = select(_e244, _e246, _e248);
                    let _e254 = select(_e239, select(2u, _e239, _e238), _e248);
                    if (_e129 < -126i) {
                        phi_386_ = -126i;
                    } else {
                        phi_386_ = select(_e129, 127i, (_e129 > 127i));
                    }
                    let _e259 = phi_386_;
                    let _e264 = bitcast<f32>((bitcast<u32>((_e259 + 127i)) << bitcast<u32>(23i)));
                    let _e270 = bitcast<f32>((bitcast<u32>(((_e129 - _e259) + 127i)) << bitcast<u32>(23i)));
                    let _e271 = -(_e234);
                    if (_e271 < -126i) {
                        phi_406_ = -126i;
                    } else {
                        phi_406_ = select(_e271, 127i, (_e271 > 127i));
                    }
                    let _e276 = phi_406_;
                    let _e281 = bitcast<f32>((bitcast<u32>((_e276 + 127i)) << bitcast<u32>(23i)));
                    let _e287 = bitcast<f32>((bitcast<u32>(((_e271 - _e276) + 127i)) << bitcast<u32>(23i)));
                    let _e291 = global_4.member[_e139].member;
                    let _e292 = (_e253 == 0u);
                    if _e292 {
                        phi_424_ = _e291[0];
                    } else {
                        phi_424_ = _e291[1];
                    }
                    let _e296 = phi_424_;
                    let _e297 = (_e253 == 2u);
                    if _e297 {
                        phi_430_ = _e291[2];
                    } else {
                        phi_430_ = _e296;
                    }
                    let _e300 = phi_430_;
                    let _e302 = ((_e300 * _e264) * _e270);
                    let _e303 = global_4.member[_e139].member_2;
                    if _e292 {
                        phi_441_ = _e303[0];
                    } else {
                        phi_441_ = _e303[1];
                    }
                    let _e307 = phi_441_;
                    if _e297 {
                        phi_447_ = _e303[2];
                    } else {
                        phi_447_ = _e307;
                    }
                    let _e310 = phi_447_;
                    let _e312 = ((_e310 * _e281) * _e287);
                    let _e316 = (bitcast<f32>((bitcast<u32>(_e312) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e316 {
                        let _e320 = (bitcast<f32>((bitcast<u32>(_e302) & 2147483647u)) * 0.00000011920929f);
                        phi_470_ = select(0.00000000000011368684f, _e320, (_e320 > 0.00000000000011368684f));
                    } else {
                        phi_470_ = 0f;
                    }
                    let _e324 = phi_470_;
                    let _e325 = (_e302 + _e324);
                    let _e326 = (_e302 - _e324);
                    let _e327 = select(_e312, 0f, _e316);
                    if _e316 {
                        phi_481_ = 38685626000000000000000000f;
                    } else {
                        phi_481_ = (1f / _e312);
                    }
                    let _e330 = phi_481_;
                    let _e331 = (_e252 == 0u);
                    if _e331 {
                        phi_490_ = _e291[0];
                    } else {
                        phi_490_ = _e291[1];
                    }
                    let _e335 = phi_490_;
                    let _e336 = (_e252 == 2u);
                    if _e336 {
                        phi_496_ = _e291[2];
                    } else {
                        phi_496_ = _e335;
                    }
                    let _e339 = phi_496_;
                    let _e341 = ((_e339 * _e264) * _e270);
                    if _e331 {
                        phi_507_ = _e303[0];
                    } else {
                        phi_507_ = _e303[1];
                    }
                    let _e345 = phi_507_;
                    if _e336 {
                        phi_513_ = _e303[2];
                    } else {
                        phi_513_ = _e345;
                    }
                    let _e348 = phi_513_;
                    let _e350 = ((_e348 * _e281) * _e287);
                    let _e354 = (bitcast<f32>((bitcast<u32>(_e350) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e354 {
                        let _e358 = (bitcast<f32>((bitcast<u32>(_e341) & 2147483647u)) * 0.00000011920929f);
                        phi_536_ = select(0.00000000000011368684f, _e358, (_e358 > 0.00000000000011368684f));
                    } else {
                        phi_536_ = 0f;
                    }
                    let _e362 = phi_536_;
                    let _e363 = (_e341 + _e362);
                    let _e364 = (_e341 - _e362);
                    let _e365 = select(_e350, 0f, _e354);
                    if _e354 {
                        phi_547_ = 38685626000000000000000000f;
                    } else {
                        phi_547_ = (1f / _e350);
                    }
                    let _e368 = phi_547_;
                    let _e369 = (_e254 == 0u);
                    if _e369 {
                        phi_556_ = _e291[0];
                    } else {
                        phi_556_ = _e291[1];
                    }
                    let _e373 = phi_556_;
                    let _e374 = (_e254 == 2u);
                    if _e374 {
                        phi_562_ = _e291[2];
                    } else {
                        phi_562_ = _e373;
                    }
                    let _e377 = phi_562_;
                    let _e379 = ((_e377 * _e264) * _e270);
                    if _e369 {
                        phi_573_ = _e303[0];
                    } else {
                        phi_573_ = _e303[1];
                    }
                    let _e383 = phi_573_;
                    if _e374 {
                        phi_579_ = _e303[2];
                    } else {
                        phi_579_ = _e383;
                    }
                    let _e386 = phi_579_;
                    let _e388 = ((_e386 * _e281) * _e287);
                    let _e392 = (bitcast<f32>((bitcast<u32>(_e388) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e392 {
                        let _e396 = (bitcast<f32>((bitcast<u32>(_e379) & 2147483647u)) * 0.00000011920929f);
                        phi_602_ = select(0.00000000000011368684f, _e396, (_e396 > 0.00000000000011368684f));
                    } else {
                        phi_602_ = 0f;
                    }
                    let _e400 = phi_602_;
                    let _e401 = (_e379 + _e400);
                    let _e402 = (_e379 - _e400);
                    let _e403 = select(_e388, 0f, _e392);
                    if _e392 {
                        phi_613_ = 38685626000000000000000000f;
                    } else {
                        phi_613_ = (1f / _e388);
                    }
                    let _e406 = phi_613_;
                    let _e409 = bitcast<f32>((bitcast<u32>(_e302) & 2147483647u));
                    let _e412 = bitcast<f32>((bitcast<u32>(_e341) & 2147483647u));
                    let _e414 = select(_e412, _e409, (_e409 > _e412));
                    let _e417 = bitcast<f32>((bitcast<u32>(_e379) & 2147483647u));
                    let _e420 = (_e129 + _e234);
                    if (_e215 && (select(_e417, _e414, (_e414 > _e417)) <= 1099511600000f)) {
                        let _e423 = (_e420 / 3i);
                        let _e430 = bitcast<f32>((bitcast<u32>((_e423 + 127i)) << bitcast<u32>(23i)));
                        let _e437 = bitcast<f32>((bitcast<u32>(((_e420 - (2i * _e423)) + 127i)) << bitcast<u32>(23i)));
                        let _e438 = (((_e200 * _e430) * _e430) * _e437);
                        let _e440 = select(340282350000000000000000000000000000000f, _e438, (_e438 < 340282350000000000000000000000000000000f));
                        let _e445 = (((_e209 * _e430) * _e430) * _e437);
                        let _e447 = select(340282350000000000000000000000000000000f, _e445, (_e445 < 340282350000000000000000000000000000000f));
                        phi_713_ = select(-340282350000000000000000000000000000000f, _e447, (_e447 > -340282350000000000000000000000000000000f));
                        phi_714_ = select(-340282350000000000000000000000000000000f, _e440, (_e440 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_713_ = 0f;
                        phi_714_ = 1f;
                    }
                    let _e451 = phi_713_;
                    let _e453 = phi_714_;
                    local_9 = array<type_22, 8>(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_10 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_18 = array<f32, 3>(bitcast<f32>(_e101), bitcast<f32>(_e105), bitcast<f32>(_e109));
                    let _e457 = (_e253 % 3u);
                    let _e458 = (_e457 < 3u);
                    if _e458 {
                    } else {
                        break;
                    }
                    let _e460 = local_18[_e457];
                    let _e461 = (_e252 % 3u);
                    let _e462 = (_e461 < 3u);
                    if _e462 {
                    } else {
                        break;
                    }
                    let _e464 = local_18[_e461];
                    let _e465 = (_e254 % 3u);
                    let _e466 = (_e465 < 3u);
                    if _e466 {
                    } else {
                        break;
                    }
                    let _e468 = local_18[_e465];
                    local_17 = array<f32, 3>(bitcast<f32>(_e113), bitcast<f32>(_e117), bitcast<f32>(_e121));
                    if _e458 {
                    } else {
                        break;
                    }
                    let _e472 = local_17[_e457];
                    if _e462 {
                    } else {
                        break;
                    }
                    let _e474 = local_17[_e461];
                    if _e466 {
                    } else {
                        break;
                    }
                    let _e476 = local_17[_e465];
                    phi_2932_ = false;
                    phi_2923_ = _e451;
                    phi_840_ = type_53(type_51(array<f32, 3>(_e460, _e464, _e468), array<f32, 3>(_e472, _e474, _e476)), select(0u, 2147483648u, (_e91 == 0u)));
                    phi_843_ = ((3u * _e91) + 1u);
                    phi_845_ = (_e453 <= _e451);
                    phi_847_ = 0u;
                    loop {
                        let _e484 = phi_2932_;
                        let _e486 = phi_2923_;
                        let _e488 = phi_840_;
                        let _e490 = phi_843_;
                        let _e492 = phi_845_;
                        let _e494 = phi_847_;
                        if _e492 {
                            phi_858_ = true;
                        } else {
                            phi_858_ = (_e494 > 0u);
                        }
                        let _e497 = phi_858_;
                        if _e497 {
                            let _e498 = (_e490 > 0u);
                            if _e498 {
                                if _e492 {
                                    phi_945_ = _e488;
                                    phi_946_ = _e492;
                                    phi_947_ = _e494;
                                } else {
                                    let _e499 = (_e494 - 1u);
                                    let _e500 = (_e499 % 128u);
                                    let _e501 = (_e500 < 128u);
                                    if _e501 {
                                    } else {
                                        phi_3083_ = true;
                                        break;
                                    }
                                    let _e503 = local_6[_e500];
                                    if _e501 {
                                    } else {
                                        phi_3083_ = true;
                                        break;
                                    }
                                    let _e505 = local_5[_e500];
                                    if _e501 {
                                    } else {
                                        phi_3083_ = true;
                                        break;
                                    }
                                    let _e507 = local_4[_e500];
                                    if _e501 {
                                    } else {
                                        phi_3083_ = true;
                                        break;
                                    }
                                    let _e509 = local_3[_e500];
                                    if _e501 {
                                    } else {
                                        phi_3083_ = true;
                                        break;
                                    }
                                    let _e512 = local_2[_e500];
                                    if _e501 {
                                    } else {
                                        phi_3083_ = true;
                                        break;
                                    }
                                    let _e514 = local_1[_e500];
                                    if _e501 {
                                    } else {
                                        phi_3083_ = true;
                                        break;
                                    }
                                    let _e516 = local[_e500];
                                    if _e501 {
                                    } else {
                                        phi_3083_ = true;
                                        break;
                                    }
                                    let _e521 = local_10[_e500];
                                    phi_945_ = type_53(type_51(array<f32, 3>(_e505, _e507, _e509), array<f32, 3>(_e512, _e514, _e516)), _e503);
                                    phi_946_ = (_e521 <= _e486);
                                    phi_947_ = _e499;
                                }
                                let _e524 = phi_945_;
                                let _e526 = phi_946_;
                                let _e528 = phi_947_;
                                if _e526 {
                                    if ((_e524.member_1 & 2147483648u) != 0u) {
                                        phi_3024_ = _e484;
                                        phi_3014_ = _e486;
                                        phi_965_ = type_4(0u, ((_e524.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e852 = phi_3024_;
                                            let _e854 = phi_3014_;
                                            let _e856 = phi_965_;
                                            if (_e856.member < _e856.member_1) {
                                                phi_966_ = type_4((_e856.member + 1u), _e856.member_1);
                                                phi_989_ = type_4(1u, _e856.member);
                                            } else {
                                                phi_966_ = _e856;
                                                phi_989_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e869 = phi_966_;
                                            let _e871 = phi_989_;
                                            let _e875 = (bitcast<i32>(_e871.member) != 0i);
                                            if _e875 {
                                                let _e876 = ((_e524.member_1 & 268435455u) + _e871.member_1);
                                                let _e877 = (_e876 < _e93);
                                                if _e877 {
                                                    if _e877 {
                                                    } else {
                                                        phi_3167_ = _e854;
                                                        phi_3078_ = true;
                                                        break;
                                                    }
                                                    let _e881 = global_2.member[_e876].member_1;
                                                    phi_1010_ = _e881;
                                                } else {
                                                    phi_1010_ = 4294967295u;
                                                }
                                                let _e883 = phi_1010_;
                                                if (_e876 >= _e93) {
                                                    phi_1099_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e877 {
                                                    } else {
                                                        phi_3167_ = _e854;
                                                        phi_3078_ = true;
                                                        break;
                                                    }
                                                    if (_e457 < 9u) {
                                                    } else {
                                                        phi_3167_ = _e854;
                                                        phi_3078_ = true;
                                                        break;
                                                    }
                                                    let _e890 = global_2.member[_e876].member[_e457];
                                                    if (_e461 < 9u) {
                                                    } else {
                                                        phi_3167_ = _e854;
                                                        phi_3078_ = true;
                                                        break;
                                                    }
                                                    let _e896 = global_2.member[_e876].member[_e461];
                                                    if (_e465 < 9u) {
                                                    } else {
                                                        phi_3167_ = _e854;
                                                        phi_3078_ = true;
                                                        break;
                                                    }
                                                    let _e902 = global_2.member[_e876].member[_e465];
                                                    let _e904 = (3u + _e457);
                                                    if (_e904 < 9u) {
                                                    } else {
                                                        phi_3167_ = _e854;
                                                        phi_3078_ = true;
                                                        break;
                                                    }
                                                    let _e910 = global_2.member[_e876].member[_e904];
                                                    let _e911 = (3u + _e461);
                                                    if (_e911 < 9u) {
                                                    } else {
                                                        phi_3167_ = _e854;
                                                        phi_3078_ = true;
                                                        break;
                                                    }
                                                    let _e917 = global_2.member[_e876].member[_e911];
                                                    let _e918 = (3u + _e465);
                                                    if (_e918 < 9u) {
                                                    } else {
                                                        phi_3167_ = _e854;
                                                        phi_3078_ = true;
                                                        break;
                                                    }
                                                    let _e924 = global_2.member[_e876].member[_e918];
                                                    let _e926 = (6u + _e457);
                                                    if (_e926 < 9u) {
                                                    } else {
                                                        phi_3167_ = _e854;
                                                        phi_3078_ = true;
                                                        break;
                                                    }
                                                    let _e932 = global_2.member[_e876].member[_e926];
                                                    let _e933 = (6u + _e461);
                                                    if (_e933 < 9u) {
                                                    } else {
                                                        phi_3167_ = _e854;
                                                        phi_3078_ = true;
                                                        break;
                                                    }
                                                    let _e939 = global_2.member[_e876].member[_e933];
                                                    let _e940 = (6u + _e465);
                                                    if (_e940 < 9u) {
                                                    } else {
                                                        phi_3167_ = _e854;
                                                        phi_3078_ = true;
                                                        break;
                                                    }
                                                    let _e946 = global_2.member[_e876].member[_e940];
                                                    phi_1099_ = array<array<f32, 3>, 3>(array<f32, 3>(_e890, _e896, _e902), array<f32, 3>(_e910, _e917, _e924), array<f32, 3>(_e932, _e939, _e946));
                                                }
                                                let _e950 = phi_1099_;
                                                let _e957 = (_e950[0][2] - _e379);
                                                let _e960 = (((_e950[0][0] - _e302) * _e403) - (_e957 * _e327));
                                                let _e963 = (((_e950[0][1] - _e341) * _e403) - (_e957 * _e365));
                                                let _e970 = (_e950[1][2] - _e379);
                                                let _e973 = (((_e950[1][0] - _e302) * _e403) - (_e970 * _e327));
                                                let _e976 = (((_e950[1][1] - _e341) * _e403) - (_e970 * _e365));
                                                let _e983 = (_e950[2][2] - _e379);
                                                let _e986 = (((_e950[2][0] - _e302) * _e403) - (_e983 * _e327));
                                                let _e989 = (((_e950[2][1] - _e341) * _e403) - (_e983 * _e365));
                                                let _e990 = (_e986 * _e976);
                                                let _e991 = (_e989 * _e973);
                                                let _e992 = (_e960 * _e989);
                                                let _e993 = (_e963 * _e986);
                                                let _e994 = (_e973 * _e963);
                                                let _e995 = (_e976 * _e960);
                                                let _e1000 = (((_e990 >= _e991) && (_e992 >= _e993)) && (_e994 >= _e995));
                                                if (_e1000 || (((_e990 <= _e991) && (_e992 <= _e993)) && (_e994 <= _e995))) {
                                                    let _e1007 = select(-1f, 1f, _e1000);
                                                    let _e1009 = ((_e990 - _e991) * _e1007);
                                                    let _e1011 = select(0f, _e1009, (_e1009 > 0f));
                                                    let _e1013 = ((_e992 - _e993) * _e1007);
                                                    let _e1015 = select(0f, _e1013, (_e1013 > 0f));
                                                    let _e1017 = ((_e994 - _e995) * _e1007);
                                                    let _e1019 = select(0f, _e1017, (_e1017 > 0f));
                                                    let _e1021 = ((_e1011 + _e1015) + _e1019);
                                                    if (_e1021 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1666_ = type_22();
                                                        phi_1667_ = true;
                                                    } else {
                                                        let _e1024 = select(_e950[1][0], _e950[0][0], (_e950[0][0] < _e950[1][0]));
                                                        let _e1028 = select(_e950[1][0], _e950[0][0], (_e950[0][0] > _e950[1][0]));
                                                        let _e1032 = select(_e950[1][1], _e950[0][1], (_e950[0][1] < _e950[1][1]));
                                                        let _e1036 = select(_e950[1][1], _e950[0][1], (_e950[0][1] > _e950[1][1]));
                                                        let _e1040 = select(_e950[1][2], _e950[0][2], (_e950[0][2] < _e950[1][2]));
                                                        let _e1044 = select(_e950[1][2], _e950[0][2], (_e950[0][2] > _e950[1][2]));
                                                        let _e1049 = ((select(_e950[2][0], _e1024, (_e1024 < _e950[2][0])) - _e325) * _e330);
                                                        let _e1050 = ((select(_e950[2][0], _e1028, (_e1028 > _e950[2][0])) - _e326) * _e330);
                                                        let _e1053 = ((select(_e950[2][1], _e1032, (_e1032 < _e950[2][1])) - _e363) * _e368);
                                                        let _e1054 = ((select(_e950[2][1], _e1036, (_e1036 > _e950[2][1])) - _e364) * _e368);
                                                        let _e1057 = ((select(_e950[2][2], _e1040, (_e1040 < _e950[2][2])) - _e401) * _e406);
                                                        let _e1058 = ((select(_e950[2][2], _e1044, (_e1044 > _e950[2][2])) - _e402) * _e406);
                                                        let _e1060 = select(_e1058, _e1057, (_e1057 < _e1058));
                                                        let _e1062 = select(_e1058, _e1057, (_e1057 > _e1058));
                                                        let _e1064 = select(_e1050, _e1049, (_e1049 < _e1050));
                                                        let _e1066 = select(_e1054, _e1053, (_e1053 < _e1054));
                                                        let _e1068 = select(_e1066, _e1064, (_e1064 > _e1066));
                                                        let _e1070 = select(_e1060, _e1068, (_e1068 > _e1060));
                                                        let _e1072 = select(_e1050, _e1049, (_e1049 > _e1050));
                                                        let _e1074 = select(_e1054, _e1053, (_e1053 > _e1054));
                                                        let _e1076 = select(_e1074, _e1072, (_e1072 < _e1074));
                                                        let _e1078 = select(_e1062, _e1076, (_e1076 < _e1062));
                                                        let _e1079 = -(_e1060);
                                                        let _e1085 = select(_e453, _e1070, (_e1070 > _e453));
                                                        if (_e1085 > (_e1078 + (select(_e1079, _e1062, (_e1062 > _e1079)) * 0.0000019073523f))) {
                                                            phi_1661_ = type_22();
                                                            phi_1662_ = true;
                                                        } else {
                                                            let _e1087 = (_e1085 > _e854);
                                                            if _e1087 {
                                                                phi_1660_ = type_22();
                                                            } else {
                                                                let _e1091 = (_e950[1][0] - _e950[0][0]);
                                                                let _e1092 = (_e950[1][1] - _e950[0][1]);
                                                                let _e1093 = (_e950[1][2] - _e950[0][2]);
                                                                let _e1094 = vec3<f32>(_e1091, _e1092, _e1093);
                                                                let _e1095 = (_e950[2][0] - _e950[1][0]);
                                                                let _e1096 = (_e950[2][1] - _e950[1][1]);
                                                                let _e1097 = (_e950[2][2] - _e950[1][2]);
                                                                let _e1098 = vec3<f32>(_e1095, _e1096, _e1097);
                                                                let _e1099 = (_e950[0][0] - _e950[2][0]);
                                                                let _e1100 = (_e950[0][1] - _e950[2][1]);
                                                                let _e1101 = (_e950[0][2] - _e950[2][2]);
                                                                let _e1102 = vec3<f32>(_e1099, _e1100, _e1101);
                                                                let _e1105 = bitcast<f32>((bitcast<u32>(_e1091) & 2147483647u));
                                                                let _e1108 = bitcast<f32>((bitcast<u32>(_e1092) & 2147483647u));
                                                                let _e1110 = select(_e1108, _e1105, (_e1105 > _e1108));
                                                                let _e1113 = bitcast<f32>((bitcast<u32>(_e1093) & 2147483647u));
                                                                let _e1115 = select(_e1113, _e1110, (_e1110 > _e1113));
                                                                let _e1118 = bitcast<f32>((bitcast<u32>(_e1095) & 2147483647u));
                                                                let _e1121 = bitcast<f32>((bitcast<u32>(_e1096) & 2147483647u));
                                                                let _e1123 = select(_e1121, _e1118, (_e1118 > _e1121));
                                                                let _e1126 = bitcast<f32>((bitcast<u32>(_e1097) & 2147483647u));
                                                                let _e1128 = select(_e1126, _e1123, (_e1123 > _e1126));
                                                                let _e1131 = bitcast<f32>((bitcast<u32>(_e1099) & 2147483647u));
                                                                let _e1134 = bitcast<f32>((bitcast<u32>(_e1100) & 2147483647u));
                                                                let _e1136 = select(_e1134, _e1131, (_e1131 > _e1134));
                                                                let _e1139 = bitcast<f32>((bitcast<u32>(_e1101) & 2147483647u));
                                                                let _e1141 = select(_e1139, _e1136, (_e1136 > _e1139));
                                                                let _e1143 = select(_e1128, _e1115, (_e1115 > _e1128));
                                                                let _e1145 = select(_e1141, _e1143, (_e1143 > _e1141));
                                                                if (_e1115 == _e1145) {
                                                                    phi_1571_ = _e1098;
                                                                    phi_1572_ = _e1102;
                                                                } else {
                                                                    let _e1148 = vec3((_e1128 == _e1145));
                                                                    phi_1571_ = select(_e1094, _e1102, _e1148);
                                                                    phi_1572_ = select(_e1098, _e1094, _e1148);
                                                                }
                                                                let _e1152 = phi_1571_;
                                                                let _e1154 = phi_1572_;
                                                                let _e1161 = ((_e1152.y * _e1154.z) - (_e1154.y * _e1152.z));
                                                                let _e1166 = ((_e1152.z * _e1154.x) - (_e1154.z * _e1152.x));
                                                                let _e1169 = ((_e1152.x * _e1154.y) - (_e1154.x * _e1152.y));
                                                                if (_e1011 >= _e1015) {
                                                                    phi_1603_ = select(true, false, (_e1011 >= _e1019));
                                                                } else {
                                                                    phi_1603_ = true;
                                                                }
                                                                let _e1174 = phi_1603_;
                                                                if _e1174 {
                                                                    phi_1612_ = select(vec3<f32>(_e950[2][0], _e950[2][1], _e950[2][2]), vec3<f32>(_e950[1][0], _e950[1][1], _e950[1][2]), vec3((_e1015 >= _e1019)));
                                                                } else {
                                                                    phi_1612_ = vec3<f32>(_e950[0][0], _e950[0][1], _e950[0][2]);
                                                                }
                                                                let _e1179 = phi_1612_;
                                                                let _e1196 = ((((_e1161 * (_e1179.x - _e302)) + (_e1166 * (_e1179.y - _e341))) + (_e1169 * (_e1179.z - _e379))) / (((_e1161 * _e327) + (_e1166 * _e365)) + (_e1169 * _e403)));
                                                                let _e1198 = select(_e1078, _e1196, (_e1196 < _e1078));
                                                                let _e1200 = select(_e1070, _e1198, (_e1198 > _e1070));
                                                                if (_e1200 >= _e453) {
                                                                    let _e1202 = (_e1200 <= _e854);
                                                                    if _e1202 {
                                                                        let _e1203 = (1f / _e1021);
                                                                        phi_1652_ = type_22(_e1200, (_e1015 * _e1203), (_e1019 * _e1203), _e883);
                                                                    } else {
                                                                        phi_1652_ = type_22();
                                                                    }
                                                                    let _e1208 = phi_1652_;
                                                                    phi_1654_ = _e1208;
                                                                    phi_1655_ = select(true, false, _e1202);
                                                                } else {
                                                                    phi_1654_ = type_22();
                                                                    phi_1655_ = true;
                                                                }
                                                                let _e1211 = phi_1654_;
                                                                let _e1213 = phi_1655_;
                                                                if _e1213 {
                                                                    phi_1659_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1659_ = _e1211;
                                                                }
                                                                let _e1215 = phi_1659_;
                                                                phi_1660_ = _e1215;
                                                            }
                                                            let _e1217 = phi_1660_;
                                                            phi_1661_ = _e1217;
                                                            phi_1662_ = _e1087;
                                                        }
                                                        let _e1219 = phi_1661_;
                                                        let _e1221 = phi_1662_;
                                                        phi_1666_ = _e1219;
                                                        phi_1667_ = _e1221;
                                                    }
                                                    let _e1223 = phi_1666_;
                                                    let _e1225 = phi_1667_;
                                                    phi_1671_ = _e1223;
                                                    phi_1672_ = _e1225;
                                                } else {
                                                    phi_1671_ = type_22();
                                                    phi_1672_ = true;
                                                }
                                                let _e1227 = phi_1671_;
                                                let _e1229 = phi_1672_;
                                                if _e1229 {
                                                    phi_1676_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1676_ = _e1227;
                                                }
                                                let _e1231 = phi_1676_;
                                                if (_e1231.member_3 != 4294967295u) {
                                                    if (_e883 != 4294967295u) {
                                                        phi_1688_ = type_4(0u, 8u);
                                                        phi_1691_ = _e1231;
                                                        loop {
                                                            let _e1236 = phi_1688_;
                                                            let _e1238 = phi_1691_;
                                                            if (_e1236.member < _e1236.member_1) {
                                                                phi_1689_ = type_4((_e1236.member + 1u), _e1236.member_1);
                                                                phi_1714_ = type_4(1u, _e1236.member);
                                                            } else {
                                                                phi_1689_ = _e1236;
                                                                phi_1714_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1251 = phi_1689_;
                                                            let _e1253 = phi_1714_;
                                                            let _e1257 = (bitcast<i32>(_e1253.member) != 0i);
                                                            if _e1257 {
                                                                let _e1258 = (_e1253.member_1 < 8u);
                                                                if _e1258 {
                                                                } else {
                                                                    phi_3015_ = true;
                                                                    break;
                                                                }
                                                                let _e1263 = local_9[_e1253.member_1].member;
                                                                if (_e1238.member < _e1263) {
                                                                    phi_1747_ = true;
                                                                } else {
                                                                    let _e1265 = local_9[_e1253.member_1].member;
                                                                    if (_e1238.member == _e1265) {
                                                                        let _e1270 = local_9[_e1253.member_1].member_3;
                                                                        phi_1746_ = (_e1238.member_3 < _e1270);
                                                                    } else {
                                                                        phi_1746_ = false;
                                                                    }
                                                                    let _e1273 = phi_1746_;
                                                                    phi_1747_ = _e1273;
                                                                }
                                                                let _e1275 = phi_1747_;
                                                                if _e1275 {
                                                                    if _e1258 {
                                                                    } else {
                                                                        phi_3015_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1276 = local_9[_e1253.member_1];
                                                                    local_9[_e1253.member_1] = type_22(_e1238.member, _e1238.member_1, _e1238.member_2, _e1238.member_3);
                                                                    phi_1768_ = type_22(_e1276.member, _e1276.member_1, _e1276.member_2, _e1276.member_3);
                                                                } else {
                                                                    phi_1768_ = _e1238;
                                                                }
                                                                let _e1287 = phi_1768_;
                                                                phi_1692_ = _e1287;
                                                            } else {
                                                                phi_1692_ = type_22();
                                                            }
                                                            let _e1289 = phi_1692_;
                                                            continue;
                                                            continuing {
                                                                phi_1688_ = _e1251;
                                                                phi_1691_ = _e1289;
                                                                phi_3015_ = _e852;
                                                                break if !(_e1257);
                                                            }
                                                        }
                                                        let _e1292 = phi_3015_;
                                                        phi_3167_ = _e854;
                                                        phi_3078_ = _e1292;
                                                        if _e1292 {
                                                            break;
                                                        }
                                                        let _e1295 = local_9[7u].member_3;
                                                        if (_e1295 != 4294967295u) {
                                                            let _e1299 = local_9[7u].member;
                                                            phi_3230_ = _e1299;
                                                        } else {
                                                            phi_3230_ = _e854;
                                                        }
                                                        let _e1301 = phi_3230_;
                                                        phi_3229_ = _e1301;
                                                        phi_3081_ = _e1292;
                                                    } else {
                                                        phi_3229_ = _e854;
                                                        phi_3081_ = _e852;
                                                    }
                                                    let _e1303 = phi_3229_;
                                                    let _e1305 = phi_3081_;
                                                    phi_3228_ = _e1303;
                                                    phi_3080_ = _e1305;
                                                } else {
                                                    phi_3228_ = _e854;
                                                    phi_3080_ = _e852;
                                                }
                                                let _e1307 = phi_3228_;
                                                let _e1309 = phi_3080_;
                                                phi_3227_ = _e1307;
                                                phi_3079_ = _e1309;
                                            } else {
                                                phi_3227_ = _e854;
                                                phi_3079_ = _e852;
                                            }
                                            let _e1311 = phi_3227_;
                                            let _e1313 = phi_3079_;
                                            continue;
                                            continuing {
                                                phi_3024_ = _e1313;
                                                phi_3014_ = _e1311;
                                                phi_965_ = _e869;
                                                phi_3167_ = _e1311;
                                                phi_3078_ = _e1313;
                                                break if !(_e875);
                                            }
                                        }
                                        let _e1316 = phi_3167_;
                                        let _e1318 = phi_3078_;
                                        phi_3083_ = _e1318;
                                        if _e1318 {
                                            break;
                                        }
                                        phi_3132_ = _e1316;
                                        phi_3087_ = _e1318;
                                        phi_2662_ = _e524;
                                        phi_2663_ = false;
                                        phi_2664_ = _e528;
                                    } else {
                                        local_8 = array<f32, 3>(_e524.member.member[0], _e524.member.member[1], _e524.member.member[2]);
                                        local_7 = array<f32, 3>(_e524.member.member_1[0], _e524.member.member_1[1], _e524.member.member_1[2]);
                                        let _e548 = (_e524.member_1 < _e91);
                                        if _e548 {
                                            if _e548 {
                                            } else {
                                                phi_3083_ = true;
                                                break;
                                            }
                                            let _e550 = global_5.member[_e524.member_1];
                                            phi_1813_ = _e550;
                                        } else {
                                            phi_1813_ = type_44(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e552 = phi_1813_;
                                        let _e554 = array<u32, 3>(_e253, _e252, _e254);
                                        local_16 = _e554;
                                        local_12 = array<f32, 3>(0f, 0f, 0f);
                                        local_11 = array<f32, 3>(0f, 0f, 0f);
                                        phi_1822_ = type_4(0u, 3u);
                                        loop {
                                            let _e556 = phi_1822_;
                                            if (_e556.member < _e556.member_1) {
                                                phi_1823_ = type_4((_e556.member + 1u), _e556.member_1);
                                                phi_1846_ = type_4(1u, _e556.member);
                                            } else {
                                                phi_1823_ = _e556;
                                                phi_1846_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e569 = phi_1823_;
                                            let _e571 = phi_1846_;
                                            let _e575 = (bitcast<i32>(_e571.member) != 0i);
                                            if _e575 {
                                                let _e576 = (_e571.member_1 < 3u);
                                                if _e576 {
                                                } else {
                                                    phi_2925_ = true;
                                                    break;
                                                }
                                                let _e578 = local_16[_e571.member_1];
                                                if _e576 {
                                                } else {
                                                    phi_2925_ = true;
                                                    break;
                                                }
                                                let _e580 = local_8[_e571.member_1];
                                                if _e576 {
                                                } else {
                                                    phi_2925_ = true;
                                                    break;
                                                }
                                                let _e582 = local_7[_e571.member_1];
                                                let _e585 = ((10u * _e578) & 31u);
                                                let _e588 = ((_e552.member[0] >> bitcast<u32>(_e585)) & 1023u);
                                                let _e593 = bitcast<f32>((bitcast<u32>(((_e582 - _e580) * 0.0009775171f)) ^ _e125));
                                                let _e599 = (_e580 + bitcast<f32>((bitcast<u32>((f32(_e588) * _e593)) ^ _e125)));
                                                if _e576 {
                                                } else {
                                                    phi_2925_ = true;
                                                    break;
                                                }
                                                local_12[_e571.member_1] = select(select(_e582, _e599, (_e599 < _e582)), _e582, (_e588 == 1023u));
                                                let _e608 = ((_e552.member[1] >> bitcast<u32>(_e585)) & 1023u);
                                                let _e614 = (_e580 + bitcast<f32>((bitcast<u32>((f32(_e608) * _e593)) ^ _e125)));
                                                if _e576 {
                                                } else {
                                                    phi_2925_ = true;
                                                    break;
                                                }
                                                local_11[_e571.member_1] = select(select(_e582, _e614, (_e614 < _e582)), _e582, (_e608 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_1822_ = _e569;
                                                phi_2925_ = _e484;
                                                break if !(_e575);
                                            }
                                        }
                                        let _e622 = phi_2925_;
                                        phi_3083_ = _e622;
                                        if _e622 {
                                            break;
                                        }
                                        let _e623 = local_11;
                                        let _e624 = local_12;
                                        local_15 = _e554;
                                        local_14 = array<f32, 3>(0f, 0f, 0f);
                                        local_13 = array<f32, 3>(0f, 0f, 0f);
                                        phi_1976_ = type_4(0u, 3u);
                                        loop {
                                            let _e633 = phi_1976_;
                                            if (_e633.member < _e633.member_1) {
                                                phi_1977_ = type_4((_e633.member + 1u), _e633.member_1);
                                                phi_2000_ = type_4(1u, _e633.member);
                                            } else {
                                                phi_1977_ = _e633;
                                                phi_2000_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e646 = phi_1977_;
                                            let _e648 = phi_2000_;
                                            let _e652 = (bitcast<i32>(_e648.member) != 0i);
                                            if _e652 {
                                                let _e653 = (_e648.member_1 < 3u);
                                                if _e653 {
                                                } else {
                                                    phi_2985_ = true;
                                                    break;
                                                }
                                                let _e655 = local_15[_e648.member_1];
                                                if _e653 {
                                                } else {
                                                    phi_2985_ = true;
                                                    break;
                                                }
                                                let _e657 = local_8[_e648.member_1];
                                                if _e653 {
                                                } else {
                                                    phi_2985_ = true;
                                                    break;
                                                }
                                                let _e659 = local_7[_e648.member_1];
                                                let _e662 = ((10u * _e655) & 31u);
                                                let _e665 = ((_e552.member_1[0] >> bitcast<u32>(_e662)) & 1023u);
                                                let _e670 = bitcast<f32>((bitcast<u32>(((_e659 - _e657) * 0.0009775171f)) ^ _e125));
                                                let _e676 = (_e657 + bitcast<f32>((bitcast<u32>((f32(_e665) * _e670)) ^ _e125)));
                                                if _e653 {
                                                } else {
                                                    phi_2985_ = true;
                                                    break;
                                                }
                                                local_14[_e648.member_1] = select(select(_e659, _e676, (_e676 < _e659)), _e659, (_e665 == 1023u));
                                                let _e685 = ((_e552.member_1[1] >> bitcast<u32>(_e662)) & 1023u);
                                                let _e691 = (_e657 + bitcast<f32>((bitcast<u32>((f32(_e685) * _e670)) ^ _e125)));
                                                if _e653 {
                                                } else {
                                                    phi_2985_ = true;
                                                    break;
                                                }
                                                local_13[_e648.member_1] = select(select(_e659, _e691, (_e691 < _e659)), _e659, (_e685 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_1976_ = _e646;
                                                phi_2985_ = _e622;
                                                break if !(_e652);
                                            }
                                        }
                                        let _e699 = phi_2985_;
                                        phi_3083_ = _e699;
                                        if _e699 {
                                            break;
                                        }
                                        let _e700 = local_13;
                                        let _e701 = local_14;
                                        let _e712 = type_53(type_51(array<f32, 3>(_e624[0], _e624[1], _e624[2]), array<f32, 3>(_e623[0], _e623[1], _e623[2])), _e552.member_2);
                                        let _e717 = type_53(type_51(array<f32, 3>(_e701[0], _e701[1], _e701[2]), array<f32, 3>(_e700[0], _e700[1], _e700[2])), _e552.member_3);
                                        let _e722 = ((_e624[0] - _e325) * _e330);
                                        let _e723 = ((_e701[0] - _e325) * _e330);
                                        let _e724 = ((_e623[0] - _e326) * _e330);
                                        let _e725 = ((_e700[0] - _e326) * _e330);
                                        let _e730 = ((_e624[1] - _e363) * _e368);
                                        let _e731 = ((_e701[1] - _e363) * _e368);
                                        let _e732 = ((_e623[1] - _e364) * _e368);
                                        let _e733 = ((_e700[1] - _e364) * _e368);
                                        let _e738 = ((_e624[2] - _e401) * _e406);
                                        let _e739 = ((_e701[2] - _e401) * _e406);
                                        let _e740 = ((_e623[2] - _e402) * _e406);
                                        let _e741 = ((_e700[2] - _e402) * _e406);
                                        let _e743 = select(_e740, _e738, (_e738 < _e740));
                                        let _e745 = select(_e741, _e739, (_e739 < _e741));
                                        let _e747 = select(_e740, _e738, (_e738 > _e740));
                                        let _e749 = select(_e741, _e739, (_e739 > _e741));
                                        let _e751 = select(_e724, _e722, (_e722 < _e724));
                                        let _e753 = select(_e725, _e723, (_e723 < _e725));
                                        let _e755 = select(_e732, _e730, (_e730 < _e732));
                                        let _e757 = select(_e733, _e731, (_e731 < _e733));
                                        let _e759 = select(_e755, _e751, (_e751 > _e755));
                                        let _e761 = select(_e757, _e753, (_e753 > _e757));
                                        let _e763 = select(_e743, _e759, (_e759 > _e743));
                                        let _e765 = select(_e745, _e761, (_e761 > _e745));
                                        let _e767 = select(_e724, _e722, (_e722 > _e724));
                                        let _e769 = select(_e725, _e723, (_e723 > _e725));
                                        let _e771 = select(_e732, _e730, (_e730 > _e732));
                                        let _e773 = select(_e733, _e731, (_e731 > _e733));
                                        let _e775 = select(_e771, _e767, (_e767 < _e771));
                                        let _e777 = select(_e773, _e769, (_e769 < _e773));
                                        let _e782 = -(_e743);
                                        let _e783 = -(_e745);
                                        let _e790 = (select(_e747, _e775, (_e775 < _e747)) + (select(_e782, _e747, (_e747 > _e782)) * 0.0000019073523f));
                                        let _e791 = (select(_e749, _e777, (_e777 < _e749)) + (select(_e783, _e749, (_e749 > _e783)) * 0.0000019073523f));
                                        let _e793 = select(_e453, _e763, (_e763 > _e453));
                                        let _e795 = select(_e453, _e765, (_e765 > _e453));
                                        let _e800 = (_e793 <= select(_e486, _e790, (_e790 < _e486)));
                                        let _e801 = (_e795 <= select(_e486, _e791, (_e791 < _e486)));
                                        let _e802 = (_e793 <= _e795);
                                        if _e800 {
                                            if _e801 {
                                                if _e802 {
                                                    phi_2564_ = _e717;
                                                } else {
                                                    phi_2564_ = _e712;
                                                }
                                                let _e804 = phi_2564_;
                                                let _e812 = (_e528 % 128u);
                                                let _e813 = (_e812 < 128u);
                                                if _e813 {
                                                } else {
                                                    phi_3083_ = true;
                                                    break;
                                                }
                                                local_6[_e812] = _e804.member_1;
                                                if _e813 {
                                                } else {
                                                    phi_3083_ = true;
                                                    break;
                                                }
                                                local_5[_e812] = _e804.member.member[0];
                                                if _e813 {
                                                } else {
                                                    phi_3083_ = true;
                                                    break;
                                                }
                                                local_4[_e812] = _e804.member.member[1];
                                                if _e813 {
                                                } else {
                                                    phi_3083_ = true;
                                                    break;
                                                }
                                                local_3[_e812] = _e804.member.member[2];
                                                if _e813 {
                                                } else {
                                                    phi_3083_ = true;
                                                    break;
                                                }
                                                local_2[_e812] = _e804.member.member_1[0];
                                                if _e813 {
                                                } else {
                                                    phi_3083_ = true;
                                                    break;
                                                }
                                                local_1[_e812] = _e804.member.member_1[1];
                                                if _e813 {
                                                } else {
                                                    phi_3083_ = true;
                                                    break;
                                                }
                                                local[_e812] = _e804.member.member_1[2];
                                                if _e813 {
                                                } else {
                                                    phi_3083_ = true;
                                                    break;
                                                }
                                                local_10[_e812] = select(_e795, _e793, (_e793 > _e795));
                                                if _e802 {
                                                    phi_2641_ = _e712;
                                                } else {
                                                    phi_2641_ = _e717;
                                                }
                                                let _e830 = phi_2641_;
                                                phi_2642_ = _e830;
                                                phi_2643_ = (_e528 + 1u);
                                            } else {
                                                phi_2642_ = type_53();
                                                phi_2643_ = u32();
                                            }
                                            let _e832 = phi_2642_;
                                            let _e834 = phi_2643_;
                                            phi_2645_ = _e832;
                                            phi_2646_ = _e834;
                                            phi_2647_ = select(true, false, _e801);
                                        } else {
                                            phi_2645_ = type_53();
                                            phi_2646_ = u32();
                                            phi_2647_ = true;
                                        }
                                        let _e837 = phi_2645_;
                                        let _e839 = phi_2646_;
                                        let _e841 = phi_2647_;
                                        if _e841 {
                                            if _e800 {
                                                phi_2654_ = _e712;
                                            } else {
                                                phi_2654_ = _e717;
                                            }
                                            let _e843 = phi_2654_;
                                            phi_2659_ = _e843;
                                            phi_2660_ = select(_e801, true, _e800);
                                        } else {
                                            phi_2659_ = _e837;
                                            phi_2660_ = _e526;
                                        }
                                        let _e846 = phi_2659_;
                                        let _e848 = phi_2660_;
                                        phi_3132_ = _e486;
                                        phi_3087_ = _e699;
                                        phi_2662_ = _e846;
                                        phi_2663_ = _e848;
                                        phi_2664_ = select(_e839, _e528, _e841);
                                    }
                                    let _e1320 = phi_3132_;
                                    let _e1322 = phi_3087_;
                                    let _e1324 = phi_2662_;
                                    let _e1326 = phi_2663_;
                                    let _e1328 = phi_2664_;
                                    phi_3131_ = _e1320;
                                    phi_3086_ = _e1322;
                                    phi_2665_ = _e1324;
                                    phi_2666_ = (_e490 - 1u);
                                    phi_2667_ = _e1326;
                                    phi_2668_ = _e1328;
                                } else {
                                    phi_3131_ = _e486;
                                    phi_3086_ = _e484;
                                    phi_2665_ = _e524;
                                    phi_2666_ = _e490;
                                    phi_2667_ = _e526;
                                    phi_2668_ = _e528;
                                }
                                let _e1330 = phi_3131_;
                                let _e1332 = phi_3086_;
                                let _e1334 = phi_2665_;
                                let _e1336 = phi_2666_;
                                let _e1338 = phi_2667_;
                                let _e1340 = phi_2668_;
                                phi_3130_ = _e1330;
                                phi_3085_ = _e1332;
                                phi_2669_ = _e1334;
                                phi_2670_ = _e1336;
                                phi_2671_ = _e1338;
                                phi_2672_ = _e1340;
                            } else {
                                phi_3130_ = _e486;
                                phi_3085_ = _e484;
                                phi_2669_ = type_53();
                                phi_2670_ = u32();
                                phi_2671_ = bool();
                                phi_2672_ = u32();
                            }
                            let _e1342 = phi_3130_;
                            let _e1344 = phi_3085_;
                            let _e1346 = phi_2669_;
                            let _e1348 = phi_2670_;
                            let _e1350 = phi_2671_;
                            let _e1352 = phi_2672_;
                            phi_3129_ = _e1342;
                            phi_3084_ = _e1344;
                            phi_841_ = _e1346;
                            phi_844_ = _e1348;
                            phi_846_ = _e1350;
                            phi_848_ = _e1352;
                            phi_2673_ = _e498;
                        } else {
                            phi_3129_ = _e486;
                            phi_3084_ = _e484;
                            phi_841_ = type_53();
                            phi_844_ = u32();
                            phi_846_ = bool();
                            phi_848_ = u32();
                            phi_2673_ = false;
                        }
                        let _e1354 = phi_3129_;
                        let _e1356 = phi_3084_;
                        let _e1358 = phi_841_;
                        let _e1360 = phi_844_;
                        let _e1362 = phi_846_;
                        let _e1364 = phi_848_;
                        let _e1366 = phi_2673_;
                        continue;
                        continuing {
                            phi_2932_ = _e1356;
                            phi_2923_ = _e1354;
                            phi_840_ = _e1358;
                            phi_843_ = _e1360;
                            phi_845_ = _e1362;
                            phi_847_ = _e1364;
                            phi_3083_ = _e1356;
                            break if !(_e1366);
                        }
                    }
                    let _e1369 = phi_3083_;
                    if _e1369 {
                        break;
                    }
                    phi_2680_ = type_4(0u, 8u);
                    loop {
                        let _e1371 = phi_2680_;
                        if (_e1371.member < _e1371.member_1) {
                            phi_2681_ = type_4((_e1371.member + 1u), _e1371.member_1);
                            phi_2704_ = type_4(1u, _e1371.member);
                        } else {
                            phi_2681_ = _e1371;
                            phi_2704_ = type_4(0u, type_4().member_1);
                        }
                        let _e1384 = phi_2681_;
                        let _e1386 = phi_2704_;
                        let _e1390 = (bitcast<i32>(_e1386.member) != 0i);
                        if _e1390 {
                            let _e1391 = (_e1386.member_1 < 8u);
                            if _e1391 {
                            } else {
                                phi_3122_ = true;
                                break;
                            }
                            let _e1393 = local_9[_e1386.member_1];
                            if (_e1393.member_3 != 4294967295u) {
                                let _e1399 = -(_e420);
                                let _e1400 = (_e1399 / 3i);
                                let _e1407 = bitcast<f32>((bitcast<u32>((_e1400 + 127i)) << bitcast<u32>(23i)));
                                let _e1415 = (((_e1393.member * _e1407) * _e1407) * bitcast<f32>((bitcast<u32>(((_e1399 - (2i * _e1400)) + 127i)) << bitcast<u32>(23i))));
                                let _e1417 = select(340282350000000000000000000000000000000f, _e1415, (_e1415 < 340282350000000000000000000000000000000f));
                                phi_2770_ = type_22(select(-340282350000000000000000000000000000000f, _e1417, (_e1417 > -340282350000000000000000000000000000000f)), _e1393.member_1, _e1393.member_2, _e1393.member_3);
                            } else {
                                phi_2770_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1422 = phi_2770_;
                            if _e1391 {
                            } else {
                                phi_3122_ = true;
                                break;
                            }
                            local_9[_e1386.member_1] = type_22(_e1422.member, _e1422.member_1, _e1422.member_2, _e1422.member_3);
                        }
                        continue;
                        continuing {
                            phi_2680_ = _e1384;
                            phi_3122_ = _e1369;
                            break if !(_e1390);
                        }
                    }
                    let _e1430 = phi_3122_;
                    if _e1430 {
                        break;
                    }
                    let _e1431 = local_9;
                    if _e141 {
                    } else {
                        break;
                    }
                    global_6.member[_e139] = array<type_22, 8>(type_22(_e1431[0].member, _e1431[0].member_1, _e1431[0].member_2, _e1431[0].member_3), type_22(_e1431[1].member, _e1431[1].member_1, _e1431[1].member_2, _e1431[1].member_3), type_22(_e1431[2].member, _e1431[2].member_1, _e1431[2].member_2, _e1431[2].member_3), type_22(_e1431[3].member, _e1431[3].member_1, _e1431[3].member_2, _e1431[3].member_3), type_22(_e1431[4].member, _e1431[4].member_1, _e1431[4].member_2, _e1431[4].member_3), type_22(_e1431[5].member, _e1431[5].member_1, _e1431[5].member_2, _e1431[5].member_3), type_22(_e1431[6].member, _e1431[6].member_1, _e1431[6].member_2, _e1431[6].member_3), type_22(_e1431[7].member, _e1431[7].member_1, _e1431[7].member_2, _e1431[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
